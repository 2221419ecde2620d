//! Calls of the maps' headers, with the parameters of one scene in the text.

use super::literal::{float, floats, word};
use super::prepared::constructor;
use crate::catalog::{Mapping, Profile};
use crate::interface::map;

/// What a map's function consists of.
#[derive(Clone, Debug, Default)]
pub(super) struct Code {
    /// The header.
    pub(super) include: String,
    /// Statements that end with its words returned; they have the fractions as `u`.
    pub(super) body: String,
    /// Whether it is so short that several in a row do no harm.
    pub(super) short: bool,
}

/// Names of a profile, and the parameters of a map.
struct Names<'m> {
    folder: &'static str,
    function: &'static str,
    structure: &'static str,
    p: &'m [f32; 16],
    prepared: Option<&'m [u32]>,
}

impl Names<'_> {
    fn vector(&self, first: usize, count: usize) -> String {
        floats(self.p.get(first..first + count).unwrap_or_default())
    }

    fn number(&self, at: usize) -> String {
        float(self.p.get(at).copied().unwrap_or(0.0))
    }

    fn bits(&self, at: usize) -> u32 {
        self.p.get(at).copied().unwrap_or(0.0).to_bits()
    }

    fn code(&self, header: &str, body: String) -> Code {
        Code {
            include: format!("corput/{}{header}.glsl", self.folder),
            body,
            short: false,
        }
    }

    /// The lines of a plane figure: a point, and its density.
    fn plane(&self, header: &str, point: &str, density: &str) -> Code {
        let f = self.function;
        let point = point.replace('@', f);
        let density = density.replace('@', f);
        self.code(
            header,
            format!("vec2 p = {point};\nreturn floatBitsToUint(vec3(p, {density}));\n"),
        )
    }

    /// The lines of a direction, and its density.
    fn direction(&self, header: &str, direction: &str, density: &str) -> Code {
        let f = self.function;
        let direction = direction.replace('@', f);
        let density = density.replace('@', f);
        self.code(
            header,
            format!("vec3 d = {direction};\nreturn floatBitsToUint(vec4(d, {density}));\n"),
        )
    }

    /// The lines of a struct `made` with a sample and its density.
    fn made(&self, header: &str, before: &str, kind: &str, call: &str, words: &str) -> Code {
        let (f, s) = (self.function, self.structure);
        let before = before.replace('@', f).replace('$', s);
        let call = call.replace('@', f);
        self.code(
            header,
            format!("{before}{s}{kind} made = {call};\nreturn floatBitsToUint({words});\n"),
        )
    }

    /// A declaration of the prepared struct of that name, from words or by its function.
    fn prepare(&self, kind: &str, name: &str, call: &str) -> String {
        let (f, s) = (self.function, self.structure);
        match self.prepared {
            Some(words) => {
                format!(
                    "const {s}{kind} {name} = {};\n",
                    constructor(&format!("{s}{kind}"), words)
                )
            }
            None => format!("{s}{kind} {name} = {};\n", call.replace('@', f)),
        }
    }
}

const SCATTERED: &str = "vec4(made.direction, made.pdf)";
const PLANE: &str = "vec3(made.p, made.pdf)";

/// The code of a map.
pub(super) fn code(mapping: &Mapping, profile: Profile) -> Code {
    let native = profile == Profile::Native;
    let tables = mapping.tables().first().map(Vec::as_slice);
    let n = Names {
        folder: if native { "native/" } else { "" },
        function: if native { "corput_native_" } else { "corput_" },
        structure: if native { "CorputNative" } else { "Corput" },
        p: mapping.parameters(),
        prepared: tables.filter(|_| mapping.is_prepared() && !native),
    };
    let disk = if native {
        "0.31830989"
    } else {
        "@concentric_disk_pdf()"
    };
    let id = mapping.map().id;
    let mut code = match id {
        map::CONCENTRIC_DISK => n.plane("hemisphere", "@concentric_disk(u)", disk),
        map::POLAR_DISK => n.plane("hemisphere", "@polar_disk(u)", disk),
        map::UNIFORM_HEMISPHERE => n.direction(
            "hemisphere",
            "@uniform_hemisphere(u)",
            "@uniform_hemisphere_pdf(d)",
        ),
        map::COSINE_HEMISPHERE => n.direction(
            "hemisphere",
            "@cosine_hemisphere(u)",
            "@cosine_hemisphere_pdf(d)",
        ),
        map::COSINE_HEMISPHERE_POLAR => n.direction(
            "hemisphere",
            "@cosine_hemisphere_polar(u)",
            "@cosine_hemisphere_polar_pdf(d)",
        ),
        map::TRIANGLE | map::REGULAR_POLYGON | map::ANNULUS => planar(&n, id),
        map::UNIFORM_SPHERE => n.direction("cone", "@uniform_sphere(u)", "@uniform_sphere_pdf()"),
        map::CONE => {
            let h = n.number(0);
            n.direction(
                "cone",
                &format!("@cone({h}, u)"),
                &format!("@cone_pdf({h}, d)"),
            )
        }
        map::SPHERICAL_TRIANGLE
        | map::SPHERICAL_RECTANGLE
        | map::SPHERE_LIGHT
        | map::DISK_LIGHT => spherical(&n, id),
        map::COSINE_POWER_HEMISPHERE => n.made(
            "cosine_power",
            &format!(
                "$CosinePower lobe = @cosine_power_prepare({});\n",
                n.number(0)
            ),
            "Scattered",
            "@cosine_power(lobe, u)",
            SCATTERED,
        ),
        map::HENYEY_GREENSTEIN => n.made(
            "henyey_greenstein",
            &format!(
                "$HenyeyGreenstein phase = @henyey_greenstein_complement({}, {});\n",
                n.number(0),
                n.bits(1) != 0
            ),
            "Scattered",
            "@henyey_greenstein(phase, u)",
            SCATTERED,
        ),
        map::GGX_VNDF | map::GGX_VNDF_NORMAL | map::GGX_VNDF_CAP | map::GGX_VNDF_BOUNDED => {
            ggx(&n, id)
        }
        map::BECKMANN_NORMAL => n.made(
            "beckmann",
            "",
            "Scattered",
            &format!("@beckmann_normal({}, u)", n.vector(0, 2)),
            SCATTERED,
        ),
        map::BECKMANN => n.made(
            "beckmann",
            "",
            "Scattered",
            &format!("@beckmann({}, {}, u)", n.vector(0, 2), n.vector(2, 3)),
            SCATTERED,
        ),
        map::ENVIRONMENT | map::ENVIRONMENT_ALIAS => {
            let name = if id == map::ENVIRONMENT {
                "environment"
            } else {
                "environment_alias"
            };
            let size = format!("uvec2({}, {})", word(n.bits(0)), word(n.bits(1)));
            let f = n.function;
            n.code(
                "environment",
                format!(
                    "CorputEnvironment made = {f}{name}({size}, u);\n\
                     return floatBitsToUint({SCATTERED});\n"
                ),
            )
        }
        _ => line(&n, id),
    };
    code.short = matches!(
        id,
        map::CONCENTRIC_DISK
            | map::POLAR_DISK
            | map::UNIFORM_HEMISPHERE
            | map::COSINE_HEMISPHERE
            | map::COSINE_HEMISPHERE_POLAR
    );
    code
}

fn planar(n: &Names, id: u32) -> Code {
    match id {
        map::TRIANGLE => {
            let corners = [n.vector(0, 2), n.vector(2, 2), n.vector(4, 2)].join(", ");
            n.plane(
                "triangle",
                &format!("@triangle({corners}, u)"),
                &format!("@triangle_pdf({corners}, p)"),
            )
        }
        map::REGULAR_POLYGON => {
            let sides = word(n.bits(0));
            n.plane(
                "regular_polygon",
                &format!("@regular_polygon({sides}, u)"),
                &format!("@regular_polygon_pdf({sides}, p)"),
            )
        }
        _ => {
            let inner = n.number(0);
            n.plane(
                "annulus",
                &format!("@annulus({inner}, u)"),
                &format!("@annulus_pdf({inner}, p)"),
            )
        }
    }
}

fn spherical(n: &Names, id: u32) -> Code {
    let three = [n.vector(0, 3), n.vector(3, 3), n.vector(6, 3)].join(", ");
    let (kind, name, call) = match id {
        map::SPHERICAL_TRIANGLE => (
            "SphericalTriangle",
            "spherical_triangle",
            format!("@spherical_triangle_prepare({three})"),
        ),
        map::SPHERICAL_RECTANGLE => (
            "SphericalRectangle",
            "spherical_rectangle",
            format!("@spherical_rectangle_prepare({three})"),
        ),
        map::SPHERE_LIGHT => (
            "SphereLight",
            "sphere_light",
            format!("@sphere_light_prepare({}, {})", n.vector(0, 3), n.number(3)),
        ),
        _ => {
            let seen = n.prepare(
                "DiskLight",
                "seen",
                &format!(
                    "@disk_light_prepare({}, {}, {})",
                    n.vector(0, 3),
                    n.vector(3, 3),
                    n.number(6)
                ),
            );
            return n.made(
                "disk_light",
                &seen,
                "LightSample",
                "@disk_light(seen, u)",
                SCATTERED,
            );
        }
    };
    let seen = n.prepare(kind, "seen", &call);
    let density = match id {
        map::SPHERE_LIGHT => "@sphere_light_pdf(seen, d)".to_owned(),
        _ => format!("@{name}_density(seen)"),
    };
    let mut code = n.direction(name, &format!("@{name}(seen, u)"), &density);
    code.body.insert_str(0, &seen);
    code
}

fn ggx(n: &Names, id: u32) -> Code {
    let lobe = format!(
        "$Ggx lobe = @ggx_prepare({}, {});\n",
        n.vector(0, 2),
        n.vector(2, 3)
    );
    let (header, lobe, call) = match id {
        map::GGX_VNDF => ("ggx_vndf", lobe, "@ggx_vndf(lobe, u)"),
        map::GGX_VNDF_NORMAL => ("ggx_vndf", lobe, "@ggx_vndf_normal(lobe, u)"),
        map::GGX_VNDF_CAP => ("ggx_vndf_cap", lobe, "@ggx_vndf_cap(lobe, u)"),
        _ => (
            "ggx_vndf_bounded",
            lobe + "lobe = @ggx_vndf_bound(lobe);\n",
            "@ggx_vndf_cap(lobe, u)",
        ),
    };
    n.made(header, &lobe, "Scattered", call, SCATTERED)
}

fn line(n: &Names, id: u32) -> Code {
    let first = n.number(0);
    let filter = |header: &str, name: &str| {
        n.made(
            header,
            "",
            "FilterSample",
            &format!("@{name}({first}, u)"),
            PLANE,
        )
    };
    match id {
        map::EXPONENTIAL => n.made(
            "free_flight",
            "",
            "FreeFlight",
            &format!("@exponential({first}, u)"),
            "vec2(made.t, made.pdf)",
        ),
        map::GAUSSIAN => n.made(
            "gaussian",
            "",
            "Gaussian",
            &format!("@gaussian({first}, u)"),
            "vec2(made.x, made.pdf)",
        ),
        map::NORMAL_PAIR | map::BOX_MULLER => {
            let name = if id == map::NORMAL_PAIR {
                "normal_pair"
            } else {
                "box_muller"
            };
            n.made(
                "gaussian",
                "",
                "GaussianPair",
                &format!("@{name}({first}, u)"),
                PLANE,
            )
        }
        map::FILTER_BOX => filter("filter", "filter_box"),
        map::FILTER_TENT => filter("filter", "filter_tent"),
        map::FILTER_BLACKMAN_HARRIS => filter("filter_blackman_harris", "filter_blackman_harris"),
        map::FILTER_GAUSSIAN => {
            let call = format!("@filter_gaussian_prepare({first}, {})", n.number(1));
            let filter = n.prepare("FilterGaussian", "gaussian", &call);
            n.made(
                "filter",
                &filter,
                "FilterSample",
                "@filter_gaussian(gaussian, u)",
                PLANE,
            )
        }
        _ => {
            let mut filter = format!(
                "$FilterMitchell mitchell = @filter_mitchell_prepare({first}, {}, {});\n",
                n.number(1),
                n.number(2)
            );
            if n.function == "corput_native_" {
                // The host knows the shares exactly.
                filter += &format!(
                    "mitchell.tail = {};\nmitchell.lobe = {};\n",
                    word(n.bits(3)),
                    word(n.bits(4))
                );
            }
            n.made(
                "filter_mitchell",
                &filter,
                "FilterSample",
                "@filter_mitchell(mitchell, u)",
                PLANE,
            )
        }
    }
}
