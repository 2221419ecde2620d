//! Uniform directions of solid angles: `shaders/kernels/map_spherical.comp`, line by line.

use super::prepared;
use crate::catalog::{Mapping, Profile};
use crate::interface::map;
use crate::reference::native::{
    cone as native_cone, disk_light as native_disk_light, sphere as native_sphere,
    sphere_light as native_sphere_light, spherical_rectangle as native_spherical_rectangle,
    spherical_triangle as native_spherical_triangle,
};
use crate::reference::{
    cone, disk_light, sphere, sphere_light, spherical_rectangle, spherical_triangle,
};
use glam::{UVec2, Vec3, uvec2, vec3};

fn words(d: Vec3, pdf: f32) -> [u32; 4] {
    [d.x, d.y, d.z, pdf].map(f32::to_bits)
}

/// Coordinates and pdf.
pub(super) fn sample(mapping: &Mapping, profile: Profile, u: [u32; 3]) -> [u32; 4] {
    let (id, p) = (mapping.map().id, mapping.parameters());
    let u = uvec2(u[0], u[1]);
    let v = |i: usize| vec3(p[i], p[i + 1], p[i + 2]);
    match (profile, id) {
        (Profile::Exact, map::UNIFORM_SPHERE) => {
            words(sphere::uniform_sphere(u), sphere::uniform_sphere_pdf())
        }
        (Profile::Exact, map::CONE) => {
            let d = cone::cone(p[0], u);
            words(d, cone::cone_pdf(p[0], d))
        }
        (Profile::Native, map::UNIFORM_SPHERE) => words(
            native_sphere::native_uniform_sphere(u),
            native_sphere::native_uniform_sphere_pdf(),
        ),
        (Profile::Native, map::CONE) => {
            let d = native_cone::native_cone(p[0], u);
            words(d, native_cone::native_cone_pdf(p[0], d))
        }
        (Profile::Exact, map::SPHERICAL_TRIANGLE) => {
            let t = prepared(mapping);
            let d = spherical_triangle::spherical_triangle(t, u);
            words(d, spherical_triangle::spherical_triangle_density(t))
        }
        (Profile::Exact, map::SPHERICAL_RECTANGLE) => {
            let t = prepared(mapping);
            let d = spherical_rectangle::spherical_rectangle(t, u);
            words(d, spherical_rectangle::spherical_rectangle_density(t))
        }
        (Profile::Exact, map::SPHERE_LIGHT) => {
            let t = prepared(mapping);
            let d = sphere_light::sphere_light(t, u);
            words(d, sphere_light::sphere_light_pdf(t, d))
        }
        (Profile::Exact, map::DISK_LIGHT) => {
            let made = disk_light::disk_light(prepared(mapping), u);
            words(made.direction, made.pdf)
        }
        (Profile::Native, map::SPHERICAL_TRIANGLE) => {
            let t = native_spherical_triangle::native_spherical_triangle_prepare(v(0), v(3), v(6));
            let d = native_spherical_triangle::native_spherical_triangle(t, u);
            words(
                d,
                native_spherical_triangle::native_spherical_triangle_density(t),
            )
        }
        (Profile::Native, map::SPHERICAL_RECTANGLE) => {
            let t =
                native_spherical_rectangle::native_spherical_rectangle_prepare(v(0), v(3), v(6));
            let d = native_spherical_rectangle::native_spherical_rectangle(t, u);
            words(
                d,
                native_spherical_rectangle::native_spherical_rectangle_density(t),
            )
        }
        (Profile::Native, map::SPHERE_LIGHT) => {
            let t = native_sphere_light::native_sphere_light_prepare(v(0), p[3]);
            let d = native_sphere_light::native_sphere_light(t, u);
            words(d, native_sphere_light::native_sphere_light_pdf(t, d))
        }
        (Profile::Native, map::DISK_LIGHT) => {
            let made = native_disk_light::native_disk_light(
                native_disk_light::native_disk_light_prepare(v(0), v(3), p[6]),
                u,
            );
            words(made.direction, made.pdf)
        }

        _ => [0; 4],
    }
}

/// The pdf.
pub(super) fn pdf(mapping: &Mapping, profile: Profile, [x, y, z]: [f32; 3]) -> f32 {
    let (id, p) = (mapping.map().id, mapping.parameters());
    let d = vec3(x, y, z);
    let v = |i: usize| vec3(p[i], p[i + 1], p[i + 2]);
    match (profile, id) {
        (Profile::Exact, map::UNIFORM_SPHERE) => sphere::uniform_sphere_pdf(),
        (Profile::Exact, map::CONE) => cone::cone_pdf(p[0], d),
        (Profile::Native, map::UNIFORM_SPHERE) => native_sphere::native_uniform_sphere_pdf(),
        (Profile::Native, map::CONE) => native_cone::native_cone_pdf(p[0], d),
        (Profile::Exact, map::SPHERICAL_TRIANGLE) => {
            spherical_triangle::spherical_triangle_pdf(prepared(mapping), d)
        }
        (Profile::Exact, map::SPHERICAL_RECTANGLE) => {
            spherical_rectangle::spherical_rectangle_pdf(prepared(mapping), d)
        }
        (Profile::Exact, map::SPHERE_LIGHT) => sphere_light::sphere_light_pdf(prepared(mapping), d),
        (Profile::Exact, map::DISK_LIGHT) => disk_light::disk_light_pdf(prepared(mapping), d),
        (Profile::Native, map::SPHERICAL_TRIANGLE) => {
            native_spherical_triangle::native_spherical_triangle_pdf(
                native_spherical_triangle::native_spherical_triangle_prepare(v(0), v(3), v(6)),
                d,
            )
        }
        (Profile::Native, map::SPHERICAL_RECTANGLE) => {
            native_spherical_rectangle::native_spherical_rectangle_pdf(
                native_spherical_rectangle::native_spherical_rectangle_prepare(v(0), v(3), v(6)),
                d,
            )
        }
        (Profile::Native, map::SPHERE_LIGHT) => native_sphere_light::native_sphere_light_pdf(
            native_sphere_light::native_sphere_light_prepare(v(0), p[3]),
            d,
        ),
        (Profile::Native, map::DISK_LIGHT) => native_disk_light::native_disk_light_pdf(
            native_disk_light::native_disk_light_prepare(v(0), v(3), p[6]),
            d,
        ),

        _ => 0.0,
    }
}

/// The fractions.
pub(super) fn invert(mapping: &Mapping, profile: Profile, [x, y, z]: [f32; 3]) -> [u32; 3] {
    let (id, p) = (mapping.map().id, mapping.parameters());
    let d = vec3(x, y, z);
    let v = |i: usize| vec3(p[i], p[i + 1], p[i + 2]);
    let u = match (profile, id) {
        (Profile::Exact, map::UNIFORM_SPHERE) => sphere::uniform_sphere_invert(d),
        (Profile::Exact, map::CONE) => cone::cone_invert(p[0], d),
        (Profile::Native, map::UNIFORM_SPHERE) => native_sphere::native_uniform_sphere_invert(d),
        (Profile::Native, map::CONE) => native_cone::native_cone_invert(p[0], d),
        (Profile::Exact, map::SPHERICAL_TRIANGLE) => {
            spherical_triangle::spherical_triangle_invert(prepared(mapping), d)
        }
        (Profile::Exact, map::SPHERICAL_RECTANGLE) => {
            spherical_rectangle::spherical_rectangle_invert(prepared(mapping), d)
        }
        (Profile::Exact, map::SPHERE_LIGHT) => {
            sphere_light::sphere_light_invert(prepared(mapping), d)
        }
        (Profile::Exact, map::DISK_LIGHT) => disk_light::disk_light_invert(prepared(mapping), d),
        (Profile::Native, map::SPHERICAL_TRIANGLE) => {
            native_spherical_triangle::native_spherical_triangle_invert(
                native_spherical_triangle::native_spherical_triangle_prepare(v(0), v(3), v(6)),
                d,
            )
        }
        (Profile::Native, map::SPHERICAL_RECTANGLE) => {
            native_spherical_rectangle::native_spherical_rectangle_invert(
                native_spherical_rectangle::native_spherical_rectangle_prepare(v(0), v(3), v(6)),
                d,
            )
        }
        (Profile::Native, map::SPHERE_LIGHT) => native_sphere_light::native_sphere_light_invert(
            native_sphere_light::native_sphere_light_prepare(v(0), p[3]),
            d,
        ),
        (Profile::Native, map::DISK_LIGHT) => native_disk_light::native_disk_light_invert(
            native_disk_light::native_disk_light_prepare(v(0), v(3), p[6]),
            d,
        ),

        _ => UVec2::ZERO,
    };
    [u.x, u.y, 0]
}
