"""Truth for tests/cpu/solid, in 80 digits.

Made by: python3 assets/truth/solid_truth.py > assets/truth/solid_truth.csv (mpmath 1.3.0)

A line is: row of the catalogue of extreme cases, map, parameters, fractions of 2^32,
quantity, its value. Parameters are exact: floats in full, or decimals taken as they stand.
"""

import struct

from mpmath import acos, cos, mp, mpf, pi, sin, sqrt

mp.dps = 80


def f32(x):
    """The float nearest to x, exactly."""
    return mpf(struct.unpack("f", struct.pack("f", x))[0])


def line(row, name, parameters, u, quantity, value):
    u = " ".join(str(k) for k in u)
    parameters = " ".join(p if isinstance(p, str) else mp.nstr(p, 30) for p in parameters)
    print(f"{row},{name},{parameters},{u},{quantity},{mp.nstr(value, 25)}")


def sphere():
    for k in [1, 2, 77, 4096, 2**31, 2**32 - 4096, 2**32 - 1]:
        u = mpf(k) / 2**32
        line(19, "uniform-sphere", [], [k, 0], "x", 2 * sqrt(u * (1 - u)))
        line(19, "uniform-sphere", [], [k, 0], "z", 1 - 2 * u)


def cone():
    for theta_max in ["1e-3", "3e-4", "2e-4", "1e-4", "1e-6", "1.5", "3", "3.14159265358979323846"]:
        row = 21 if theta_max.startswith("3.") else 20
        h = 2 * sin(mpf(theta_max) / 2) ** 2
        line(row, "cone", [theta_max], [0, 0], "pdf", 1 / (2 * pi * h))
        for k in [1, 2**31, 2**32 - 1]:
            x = h * k / 2**32
            line(row, "cone", [theta_max], [k, 0], "x", sqrt(x * (2 - x)))


def cosine_power():
    for n in ["0", "1", "1e3", "1e6", "1e9"]:
        power = f32(float(n))
        for k in [1, 2**16, 2**31, 2**32 - 1]:
            rest = 1 - mpf(k) / 2**32
            z = rest ** (1 / (power + 1))
            name = "cosine-power-hemisphere"
            line(17, name, [n], [k, 0], "x", sqrt(1 - z * z))
            line(17, name, [n], [k, 0], "pdf", (power + 1) / (2 * pi) * z**power)


def dot(v, w):
    return sum(a * b for a, b in zip(v, w))


def scaled(v, a):
    return [x * a for x in v]


def plus(v, w):
    return [a + b for a, b in zip(v, w)]


def cross(v, w):
    return [v[i - 2] * w[i - 1] - v[i - 1] * w[i - 2] for i in range(3)]


def unit(v):
    return scaled(v, 1 / sqrt(dot(v, v)))


def solid_angle(a, b, c):
    """Girard's theorem, which loses its digits, of which there are enough."""
    na, nb, nc = unit(cross(b, c)), unit(cross(c, a)), unit(cross(a, b))
    return sum(acos(-dot(*pair)) for pair in [(na, nb), (nb, nc), (nc, na)]) - pi


def arvo(a, b, c, u, v):
    """Arvo 1995, as written."""
    a, b, c = unit(a), unit(b), unit(c)
    area = u * solid_angle(a, b, c)
    alpha = acos(-dot(unit(cross(c, a)), unit(cross(a, b))))
    s, t = sin(area - alpha), cos(area - alpha)
    p, q = t - cos(alpha), s + sin(alpha) * dot(a, b)
    q = ((q * t - p * s) * cos(alpha) - q) / ((q * s + p * t) * sin(alpha))
    moving = plus(scaled(a, q), scaled(unit(plus(c, scaled(a, -dot(c, a)))), sqrt(1 - q * q)))
    z = 1 - v * (1 - dot(moving, b))
    side = unit(plus(moving, scaled(b, -dot(moving, b))))
    return plus(scaled(b, z), scaled(side, sqrt(1 - z * z)))


TRIANGLES = [
    (23, [0, 0, 1, 1e-2, 0, 1, 0, 1e-2, 1]),
    (23, [0, 0, 1, 1e-3, 0, 1, 0, 1e-3, 1]),
    (23, [0, 0, 1, 1e-5, 0, 1, 0, 1e-5, 1]),
    (23, [0, 0, 1, 0, 1e-5, 1, 1e-5, 0, 1]),
    (23, [1e-9, 0, 1, 0, 1e-9, 1, -1e-9, -1e-9, 1]),
    (24, [0.3, 0.4, 0.8, 0.30001, 0.4, 0.8, 0.3, 0.40001, 0.8]),
    (24, [30, 40, 80, 30.02, 40.01, 79.99, 29.99, 40.02, 80.01]),
    (25, [1, 0, 1e-4, -0.5, 0.8660254, 1e-4, -0.5, -0.8660254, 1e-4]),
    (25, [1, 0, 1e-7, -0.5, 0.8660254, 1e-7, -0.5, -0.8660254, 1e-7]),
    (25, [1, 0, 1e-6, -1, 1e-6, 2e-6, 0.3, 1, 1e-6]),
    (23, [1, 0, 0, 0, 1, 0, 0, 0, 1]),
    (23, [1, 0, 0, 0, 0, 1, 0, 1, 0]),
    (23, [1, 0.2, 0.1, 1.00001, 0.2, 0.1, -1, 0.3, 0.2]),
    (23, [1, 0.2, 0.1, -1, 0.3, 0.2, 1.00001, 0.2, 0.1]),
    (23, [100, 0.3, 1, 1, 0.3, 1, 1, 0.30001, 1]),
    (23, [-7, 1, 1, 1e-3, 2e-3, 4e-3, 900, -30, 800]),
    (25, [1, 0, 1e-5, -1, 0.1, 1e-5, -1, -0.1, 1e-5]),
]


def triangle():
    for row, numbers in TRIANGLES:
        numbers = [f32(x) for x in numbers]
        a, b, c = numbers[:3], numbers[3:6], numbers[6:]
        line(row, "spherical-triangle", numbers, [0, 0], "area", solid_angle(a, b, c))
        for u in [(1, 1), (2**31, 2**31), (2**30, 2**32 - 1), (2**32 - 1, 2**29), (2**32 - 4096, 4096), (7, 2**31)]:
            d = arvo(a, b, c, mpf(u[0]) / 2**32, mpf(u[1]) / 2**32)
            for axis, x in zip("xyz", d):
                line(row, "spherical-triangle", numbers, u, axis, x)


RECTANGLES = [
    [-0.5, -0.5, 1, 1, 0, 0, 0, 1, 0],
    [0, 0, 1, 3e-3, 0, 0, 0, 3e-3, 0],
    [0, 0, 1, 1e-4, 0, 0, 0, 1e-4, 0],
    [0.3, -0.2, 1, 1e-5, 0, 0, 0, 1e-4, 0],
    [-1, -1, 1e-4, 2, 0, 0, 0, 3, 0],
    [0.1, 0.2, 1e-3, 2, 0, 0, 0, 3, 0],
    [3, 1, 2, 0.5, 0, -0.5, 0, 7, 0],
]


def rectangle():
    for numbers in RECTANGLES:
        numbers = [f32(x) for x in numbers]
        o, x, y = numbers[:3], numbers[3:6], numbers[6:]
        a, e = plus(o, x), plus(o, y)
        c = plus(a, y)
        area = solid_angle(a, o, c) + solid_angle(c, o, e)
        line(27, "spherical-rectangle", numbers, [0, 0], "area", area)


def dominating(x, y):
    """The concentric map."""
    if abs(x) >= abs(y):
        return [x * cos(pi / 4 * y / x), x * sin(pi / 4 * y / x)] if x else [mpf(0), mpf(0)]
    return [y * sin(pi / 4 * x / y), y * cos(pi / 4 * x / y)]


def rotated(n, local):
    """Duff's frame, z = -0 as +0."""
    sign = -1 if n[2] < 0 else 1
    a = -1 / (sign + n[2])
    t = [1 + sign * n[0] ** 2 * a, sign * n[0] * n[1] * a, -sign * n[0]]
    b = [n[0] * n[1] * a, sign + n[1] ** 2 * a, -n[1]]
    return plus(plus(scaled(t, local[0]), scaled(b, local[1])), scaled(n, local[2]))


def lights():
    fractions = [(1, 0), (2**31, 2**29 + 5), (2**32 - 1, 2**31), (12345678, 4000000000)]
    spheres = [
        [0, 0, 1, 1e-3],
        [0, 0, 1e4, 1],
        [3, 4, 12, 1e-4],
        [0, 0, 1, 0.9999999],
        [1e-4, 0, -1, 0.5],
        [1e-3, -1e-3, -1, 1e-5],
        [0.1, 0.2, 0.3, 5],
    ]
    for numbers in spheres:
        numbers = [f32(x) for x in numbers]
        c, r = numbers[:3], numbers[3]
        d2 = dot(c, c)
        row = 29 if c[2] < 0 else 20
        h = 1 - sqrt(1 - r * r / d2) if d2 >= r * r else mpf(2)
        for u in fractions:
            line(row, "sphere-light", numbers, u, "pdf", 1 / (2 * pi * h))
            x = h * u[0] / 2**32
            radius, turn = sqrt(x * (2 - x)), 2 * pi * u[1] / 2**32
            local = [radius * cos(turn), radius * sin(turn), 1 - x]
            for axis, value in zip("xyz", rotated(unit(c), local)):
                line(row, "sphere-light", numbers, u, axis, value)
    disks = [
        [0, 0, 2, 0, 0, 1, 1],
        [0, 0, 1, 0, 0, -1, 1e-4],
        [3, 4, 12, 1e-3, 0, -1, 1e-3],
        [1, 0, 1e-4, 0, 0, 1, 0.5],
        [1, 2, 3, 1, 0, -0.3, 10],
    ]
    for numbers in disks:
        numbers = [f32(x) for x in numbers]
        c, n, r = numbers[:3], unit(numbers[3:6]), numbers[6]
        for u in fractions:
            x, y = dominating(*(r * (2 * mpf(k) / 2**32 - 1) for k in u))
            p = plus(c, rotated(n, [x, y, 0]))
            d2 = dot(p, p)
            line(27, "disk-light", numbers, u, "pdf", d2 * sqrt(d2) / (pi * r * r * abs(dot(n, c))))
            for axis, value in zip("xyz", unit(p)):
                line(27, "disk-light", numbers, u, axis, value)


sphere()
cone()
cosine_power()
triangle()
rectangle()
lights()
