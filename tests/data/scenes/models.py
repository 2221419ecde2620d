"""Writes the two glTF scenes beside it: python3 models.py. Its output is CC0 1.0."""

import json
import math
import struct
from pathlib import Path

FLOAT, BYTE, SHORT = 5126, 5121, 5123


class Model:
    """Geometry in one binary chunk, and the JSON that describes it."""

    def __init__(self):
        self.data = bytearray()
        self.views, self.accessors, self.meshes = [], [], []

    def view(self, data, target):
        self.data += bytes(-len(self.data) % 4)
        self.views.append(
            {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data), "target": target}
        )
        self.data += data
        return len(self.views) - 1

    def positions(self, points):
        data = b"".join(struct.pack("<3f", *p) for p in points)
        # Bounds of what is written, which is rounded.
        rounded = [struct.unpack("<3f", struct.pack("<3f", *p)) for p in points]
        self.accessors.append(
            {
                "bufferView": self.view(data, 34962),
                "componentType": FLOAT,
                "count": len(points),
                "type": "VEC3",
                "min": [min(p[k] for p in rounded) for k in range(3)],
                "max": [max(p[k] for p in rounded) for k in range(3)],
            }
        )
        return len(self.accessors) - 1

    def indices(self, numbers, component):
        code = {BYTE: "B", SHORT: "H"}[component]
        self.accessors.append(
            {
                "bufferView": self.view(struct.pack(f"<{len(numbers)}{code}", *numbers), 34963),
                "componentType": component,
                "count": len(numbers),
                "type": "SCALAR",
            }
        )
        return len(self.accessors) - 1

    def mesh(self, name, points, material, numbers=None, component=SHORT, mode=None):
        primitive = {"attributes": {"POSITION": self.positions(points)}, "material": material}
        if numbers is not None:
            primitive["indices"] = self.indices(numbers, component)
        if mode is not None:
            primitive["mode"] = mode
        self.meshes.append({"name": name, "primitives": [primitive]})
        return len(self.meshes) - 1

    def document(self, **rest):
        asset = {"version": "2.0", "generator": "models.py", "copyright": "CC0 1.0"}
        return {
            "asset": asset,
            "buffers": [{"byteLength": len(self.data)}],
            "bufferViews": self.views,
            "accessors": self.accessors,
            "meshes": self.meshes,
            "scene": 0,
            **rest,
        }


def quad(half):
    return [(-half, 0, -half), (half, 0, -half), (half, 0, half), (-half, 0, half)], [0, 2, 1, 0, 3, 2]


def sphere(rows, columns):
    points, numbers = [], []
    for row in range(rows + 1):
        theta = math.pi * row / rows
        for column in range(columns + 1):
            phi = 2 * math.pi * column / columns
            points.append(
                (math.sin(theta) * math.cos(phi), math.cos(theta), math.sin(theta) * math.sin(phi))
            )
    for row in range(rows):
        for column in range(columns):
            a = row * (columns + 1) + column
            b = a + columns + 1
            numbers += [a, a + 1, b, b, a + 1, b + 1]
    return points, numbers


def studio():
    """Punctual lights, a lamp of two triangles, metal, lacquer and glass."""
    model = Model()
    floor = model.mesh("floor", *[quad(4)[0], 0, quad(4)[1]])
    ball, faces = sphere(12, 24)
    balls = [model.mesh(name, ball, k + 1, faces) for k, name in enumerate(["gold", "car", "glass"])]
    lamp = model.mesh("lamp", quad(0.5)[0], 4, quad(0.5)[1])
    nodes = [
        {"name": "floor", "mesh": floor},
        *[{"mesh": mesh, "translation": [2.5 * k - 2.5, 1, 0]} for k, mesh in enumerate(balls)],
        # Turned to shine downwards, and twice as long.
        {"name": "lamp", "mesh": lamp, "translation": [0, 4, 0], "rotation": [1, 0, 0, 0], "scale": [2, 1, 1]},
        {"name": "key", "translation": [-3, 4, 3], "extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"name": "rim", "translation": [3, 4, -3], "extensions": {"KHR_lights_punctual": {"light": 1}}},
        {"name": "sun", "extensions": {"KHR_lights_punctual": {"light": 2}}},
        {"name": "view", "camera": 0, "translation": [0, 2, 9]},
    ]
    materials = [
        {"name": "Floor", "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.75}},
        {
            "name": "Gold",
            "pbrMetallicRoughness": {"baseColorFactor": [1, 0.77, 0.34, 1], "roughnessFactor": 0.25},
        },
        {
            "name": "Car Paint",
            "pbrMetallicRoughness": {"baseColorFactor": [0.6, 0.02, 0.02, 1], "metallicFactor": 0, "roughnessFactor": 0.5},
            "extensions": {"KHR_materials_clearcoat": {"clearcoatFactor": 1, "clearcoatRoughnessFactor": 0.125}},
        },
        {
            "name": "Glass",
            "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0},
            "extensions": {
                "KHR_materials_transmission": {"transmissionFactor": 1},
                "KHR_materials_ior": {"ior": 1.45},
            },
        },
        {
            "name": "Lamp",
            "pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1], "metallicFactor": 0},
            "emissiveFactor": [1, 1, 0.5],
            "extensions": {
                "KHR_materials_emissive_strength": {"emissiveStrength": 10},
                "KHR_materials_specular": {"specularFactor": 0},
            },
        },
        {"name": "Spare", "pbrMetallicRoughness": {"roughnessFactor": 0.1}},
    ]
    lights = [
        {"name": "Key", "type": "point", "intensity": 40},
        {"name": "Rim", "type": "spot", "intensity": 80, "color": [0.5, 0.75, 1], "spot": {"outerConeAngle": 0.5}},
        {"name": "Sun", "type": "directional", "intensity": 3},
    ]
    used = [
        "KHR_lights_punctual",
        "KHR_materials_clearcoat",
        "KHR_materials_emissive_strength",
        "KHR_materials_ior",
        "KHR_materials_specular",
        "KHR_materials_transmission",
    ]
    camera = {"name": "Main", "type": "perspective", "perspective": {"yfov": 0.6, "znear": 0.1}, "extras": {"aperture": 0.05}}
    return model, model.document(
        extensionsUsed=used,
        extensionsRequired=["KHR_lights_punctual", "KHR_materials_clearcoat"],
        extensions={"KHR_lights_punctual": {"lights": lights}},
        cameras=[camera],
        materials=materials,
        nodes=nodes,
        scenes=[{"nodes": list(range(len(nodes)))}],
    )


def lantern():
    """Panes that shine in a brushed frame, on cloth, with its bytes beside it; no camera."""
    model = Model()
    strip = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)]
    pane = model.mesh("pane", strip, 0, mode=5)
    cap = model.mesh("cap", quad(0.5)[0], 0, quad(0.5)[1], component=BYTE)
    frame, faces = sphere(4, 6)
    frame = model.mesh("frame", frame, 1, faces)
    cloth = model.mesh("cloth", quad(3)[0], 2, quad(3)[1])
    nodes = [
        {"name": "lantern", "children": [1, 2, 3, 4], "translation": [0, 1, 0]},
        {"mesh": pane, "translation": [-0.5, -0.5, 0.5]},
        {"mesh": pane, "matrix": [0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0.5, -0.5, 0.5, 1]},
        {"mesh": cap, "translation": [0, 0.5, 0]},
        {"mesh": frame, "scale": [0.1, 1, 0.1]},
        {"name": "cloth", "mesh": cloth},
    ]
    materials = [
        {
            "name": "Pane",
            "emissiveFactor": [1, 0.5, 0.25],
            "doubleSided": True,
            "extensions": {"KHR_materials_unlit": {}},
        },
        {
            "name": "Brushed",
            "pbrMetallicRoughness": {"roughnessFactor": 0.5},
            "extensions": {"KHR_materials_anisotropy": {"anisotropyStrength": 0.5}},
        },
        {
            "name": "Cloth",
            "pbrMetallicRoughness": {"metallicFactor": 0},
            "extensions": {"KHR_materials_sheen": {"sheenColorFactor": [0.5, 0.5, 0.5]}},
        },
    ]
    used = ["KHR_materials_anisotropy", "KHR_materials_sheen", "KHR_materials_unlit", "EXT_lights_image_based"]
    return model, model.document(
        extensionsUsed=used, materials=materials, nodes=nodes, scenes=[{"nodes": [0, 5]}]
    )


def main():
    folder = Path(__file__).parent
    model, document = studio()
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    data = bytes(model.data) + bytes(-len(model.data) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    (folder / "studio.glb").write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)
    model, document = lantern()
    document["buffers"][0]["uri"] = "lantern.bin"
    (folder / "lantern.gltf").write_text(json.dumps(document, indent=1) + "\n")
    (folder / "lantern.bin").write_bytes(bytes(model.data))


if __name__ == "__main__":
    main()
