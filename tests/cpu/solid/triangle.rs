//! Spherical triangles.

use super::tools::{Truth, extreme, relative, truth};
use corput::glam::{Vec3, vec3};
use corput::judge::ulp_error;
use corput::reference::spherical_triangle::*;

fn corners(parameters: &[f64]) -> [Vec3; 3] {
    let p: Vec<f32> = parameters.iter().map(|&x| x as f32).collect();
    [
        vec3(p[0], p[1], p[2]),
        vec3(p[3], p[4], p[5]),
        vec3(p[6], p[7], p[8]),
    ]
}

#[test]
fn explore() {
    let all = truth("spherical-triangle");
    let mut seen: Vec<&Truth> = Vec::new();
    for t in &all {
        let [a, b, c] = corners(&t.parameters);
        let tri = spherical_triangle_prepare(a, b, c);
        if t.quantity == "area" {
            println!(
                "{a} {b} {c} area {:e} error {:e}",
                t.value,
                relative(spherical_triangle_solid_angle(tri).into(), t.value)
            );
            continue;
        }
        seen.push(t);
        if seen.len() == 3 {
            let d = spherical_triangle(tri, t.u);
            let v = spherical_triangle_invert(tri, d);
            let size = (a.normalize() - b.normalize())
                .length()
                .max((a.normalize() - c.normalize()).length());
            let e: Vec<f64> = (0..3)
                .map(|i| (f64::from(d.to_array()[i]) - seen[i].value))
                .collect();
            let ulps: Vec<f64> = (0..3)
                .map(|i| ulp_error(d.to_array()[i], seen[i].value))
                .collect();
            let rel = e.iter().map(|x| x.abs()).fold(0.0, f64::max) / f64::from(size);
            println!(
                "   {} {d} rel {rel:.1e} ulps {:.2} {:.2} {:.2}; pdf {:e} invert {:.1e} {:.1e}",
                t.u,
                ulps[0],
                ulps[1],
                ulps[2],
                spherical_triangle_pdf(tri, d),
                f64::from(v.x) - f64::from(t.u.x),
                f64::from(v.y) - f64::from(t.u.y)
            );
            seen.clear();
        }
    }
    let _ = extreme;
}
