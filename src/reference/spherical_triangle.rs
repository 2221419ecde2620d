//! Directions of a spherical triangle, uniformly, with solid angle, pdf and inverse.
//!
//! Source: Arvo 1995, Stratified sampling of spherical triangles, in the tangent form of
//! Peters 2021, BRDF importance sampling for polygonal lights, section 3, every difference
//! replaced; solid angle: Van Oosterom and Strackee 1983, by edges. Domain: three vertices
//! seen from the origin, of any length and order; two fractions of 2^32; where they span
//! no solid angle, +z with pdf 0; where the origin is within the triangle, the hemisphere
//! towards a x b. Range: unit vectors to 2^-23. Pdf: with respect to solid angle, 1 over it
//! inside, edges widened by the rounding of a direction. Errors: the solid angle 0.6 ULP,
//! the direction 0.6 ULP or 2^-24 of the longest side; the inverse agrees with the sample
//! to 2^-20, more where the rounding of a direction is more of the triangle.
//! Tier I.
//! Mirror: `shaders/corput/spherical_triangle.glsl`.

use crate::reference::arc::{Arc, arc, arc_sum, real3_combine, real3_signed};
use crate::reference::real::{
    Real, real_add, real_divide, real_float, real_less, real_max, real_min, real_multiply,
    real_negate, real_shift, real_smaller, real_sqrt, real_square, real_subtract, real_uint,
    real_zero,
};
use crate::reference::real_angle::{
    angle, angle_cosine, angle_sine_half, real_complement, real_fraction_nearest,
};
use crate::reference::real_vector::{
    Real3, real3, real3_add, real3_dot, real3_floats, real3_length, real3_normalize, real3_scale,
    real3_subtract,
};
use crate::reference::sphere::sphere_versine;
use crate::reference::wide::{wide_cross, wide_triple};
use glam::{UVec2, Vec3, uvec2, vec3};

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphericalTriangle {
    /// The first vertex, as a unit vector.
    pub a: Real3,
    /// The second.
    pub b: Real3,
    /// The third.
    pub c: Real3,
    /// Half the side from a to b.
    pub ab: Arc,
    /// Half that from b to c.
    pub bc: Arc,
    /// Half that from c to a.
    pub ca: Arc,
    /// Half the solid angle, in turns.
    pub area: Real,
    /// What it lacks of 1/2.
    pub rest: Real,
    /// The unit normal of ab, inwards.
    pub ab_normal: Real3,
    /// That of bc.
    pub bc_normal: Real3,
    /// That of ca.
    pub ca_normal: Real3,
    /// The unit tangent at b towards a.
    pub tangent: Real3,
    /// The sine of the angle between b and ca.
    pub height: Real,
}

/// The cosine's part of Van Oosterom and Strackee's formula for unit vectors, with the
/// widest side from u to v.
#[inline]
#[must_use]
pub fn spherical_triangle_cosine(u: Real3, v: Real3, w: Real3, arc: Arc, normal: Real3) -> Real {
    let square = real_shift(real_square(arc.cosine), 1);
    real_add(square, real3_dot(w, arc_sum(u, v, arc, normal)))
}

/// The triangle with vertices a, b, c, given the products a x b, b x c, c x a and the triple
/// product as exactly as they can be had.
#[inline]
#[must_use]
pub fn spherical_triangle_of(
    a: Real3,
    b: Real3,
    c: Real3,
    ab_across: Real3,
    bc_across: Real3,
    ca_across: Real3,
    volume: Real,
) -> SphericalTriangle {
    let ab = arc(a, b, ab_across);
    let bc = arc(b, c, bc_across);
    let ca = arc(c, a, ca_across);
    let magnitude = Real {
        m: volume.m,
        e: volume.e,
        negative: false,
    };
    let b_length = real3_length(b);
    let lengths = real_multiply(real_multiply(real3_length(a), b_length), real3_length(c));
    let ua = real3_normalize(a);
    let ub = real3_normalize(b);
    let uc = real3_normalize(c);
    let ab_normal = real3_normalize(ab_across);
    let bc_normal = real3_normalize(bc_across);
    let ca_normal = real3_normalize(ca_across);
    let mut cosine = spherical_triangle_cosine(ua, ub, uc, ab, ab_normal);
    if real_less(bc.cosine, real_min(ab.cosine, ca.cosine)) {
        cosine = spherical_triangle_cosine(ub, uc, ua, bc, bc_normal);
    } else if real_less(ca.cosine, ab.cosine) {
        cosine = spherical_triangle_cosine(uc, ua, ub, ca, ca_normal);
    }
    let mut sine = real_divide(magnitude, lengths);
    // A vertex at the origin, on another or opposite to it: then there is no side.
    if ab.cosine.m == 0
        || ab.sine.m == 0
        || bc.cosine.m == 0
        || bc.sine.m == 0
        || ca.cosine.m == 0
        || ca.sine.m == 0
    {
        cosine = real_uint(1, 0);
        sine = real_zero();
    }
    let height = real_divide(magnitude, real_multiply(b_length, real3_length(ca_across)));
    SphericalTriangle {
        a: ua,
        b: ub,
        c: uc,
        ab,
        bc,
        ca,
        area: angle(sine, cosine),
        rest: angle(sine, real_negate(cosine)),
        ab_normal: real3_signed(ab_normal, volume.negative),
        bc_normal: real3_signed(bc_normal, volume.negative),
        ca_normal: real3_signed(ca_normal, volume.negative),
        tangent: real3_normalize(wide_cross(b, ab_across)),
        height,
    }
}

/// a . (b x c), whose products are exact, but for what 64 bits cut; where that tells, as of small
/// triangles, by the sides at a, which are exact if the lengths are alike.
#[inline]
#[must_use]
pub fn spherical_triangle_volume(a: Real3, b: Real3, c: Real3) -> Real {
    let volume = wide_triple(a, b, c);
    let x = real3_length(a);
    let y = real3_length(b);
    let z = real3_length(c);
    let lengths = real_multiply(real_multiply(x, y), z);
    let shortest = real_min(x, real_min(y, z));
    let longest = real_max(x, real_max(y, z));
    if real_smaller(volume, real_shift(lengths, -30)) && real_less(longest, real_shift(shortest, 7))
    {
        return wide_triple(a, real3_subtract(b, a), real3_subtract(c, a));
    }
    volume
}

/// The triangle with these vertices.
#[inline]
#[must_use]
pub fn spherical_triangle_prepare(a: Vec3, b: Vec3, c: Vec3) -> SphericalTriangle {
    let va = real3(a);
    let vb = real3(b);
    let vc = real3(c);
    spherical_triangle_of(
        va,
        vb,
        vc,
        wide_cross(va, vb),
        wide_cross(vb, vc),
        wide_cross(vc, va),
        spherical_triangle_volume(va, vb, vc),
    )
}

/// The moving vertex c' on ca: weight_a a + weight_c c has this length squared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MovingVertex {
    /// Its part of a.
    pub weight_a: Real,
    /// Its part of c.
    pub weight_c: Real,
    /// The squared length of the sum.
    pub square: Real,
    /// The cosine of half the angle to a.
    pub a_cosine: Real,
    /// The cosine of half the angle to b.
    pub b_cosine: Real,
}

/// The vertex that parts half the solid angle into before and behind, in turns.
#[inline]
#[must_use]
pub fn moving_vertex(t: SphericalTriangle, before: Real, behind: Real) -> MovingVertex {
    let mut before_sine = angle_sine_half(before, real_add(t.rest, behind));
    let mut behind_sine = angle_sine_half(behind, real_add(t.rest, before));
    let area_sine = angle_sine_half(t.area, t.rest);
    // Of a hemisphere they are equal, also where both vanish.
    if before_sine.m == 0 && behind_sine.m == 0 {
        before_sine = real_uint(1, 0);
        behind_sine = before_sine;
    }
    let q = real_multiply(t.ab.cosine, before_sine);
    let d = real_multiply(
        real_multiply(t.bc.cosine, t.ca.cosine),
        real_shift(behind_sine, 1),
    );
    let q2 = real_shift(q, 1);
    let ca_square = real_square(t.ca.cosine);
    let along = real_add(d, real_multiply(q2, ca_square));
    let across = real_multiply(real_multiply(q2, real_add(d, q)), ca_square);
    let square = real_add(real_square(d), real_shift(across, 1));
    let root = real_sqrt(square);
    let cosines = real_multiply(real_multiply(t.ab.cosine, t.bc.cosine), t.ca.cosine);
    let b_cosine = real_divide(real_shift(real_multiply(cosines, area_sine), 1), root);
    MovingVertex {
        weight_a: real_multiply(d, real_add(d, q2)),
        weight_c: real_multiply(q2, along),
        square,
        a_cosine: real_divide(along, root),
        b_cosine: real_min(real_uint(1, 0), b_cosine),
    }
}

/// The direction a fraction u of the way from b to c' by the versine, as a sum of vertices.
#[inline]
#[must_use]
pub fn spherical_triangle_sum(t: SphericalTriangle, v: MovingVertex, u: u32) -> Vec3 {
    let cosine = v.b_cosine;
    let part = real_uint(u, -32);
    let rest = real_complement(u);
    let part_root = real_sqrt(part);
    let cosine_square = real_square(cosine);
    let sine_square = real_subtract(real_uint(1, 0), cosine_square);
    // Cosine of half the angle from b to the direction.
    let near = real_sqrt(real_add(rest, real_multiply(part, cosine_square)));
    let weight_b = real_divide(
        real_multiply(
            rest,
            real_add(
                real_multiply(cosine, near),
                real_multiply(sine_square, part_root),
            ),
        ),
        real_multiply(cosine, real_add(near, real_multiply(cosine, part_root))),
    );
    let moving = real_divide(
        real_multiply(part_root, near),
        real_multiply(cosine, v.square),
    );
    let side = real3_combine(
        t.a,
        real_multiply(v.weight_a, moving),
        t.c,
        real_multiply(v.weight_c, moving),
    );
    real3_floats(real3_add(real3_scale(t.b, weight_b), side))
}

/// The same by polar coordinates around b, for c' far from it, where the sum would cancel.
#[inline]
#[must_use]
pub fn spherical_triangle_polar(
    t: SphericalTriangle,
    v: MovingVertex,
    before: Real,
    u: u32,
) -> Vec3 {
    let one = real_uint(1, 0);
    let part = real_uint(u, -32);
    let cosine_square = real_square(v.b_cosine);
    let sine_square = real_subtract(one, cosine_square);
    let y = real_multiply(
        v.a_cosine,
        angle_sine_half(before, real_subtract(real_uint(1, -1), before)),
    );
    let x = real_subtract(
        real_multiply(v.a_cosine, angle_cosine(before)),
        real_multiply(t.ab.cosine, v.b_cosine),
    );
    let length = real_sqrt(real_add(real_square(x), real_square(y)));
    let near = real_sqrt(real_add(
        real_complement(u),
        real_multiply(part, cosine_square),
    ));
    let sine = real_multiply(near, real_sqrt(real_multiply(part, sine_square)));
    let radius = real_divide(real_shift(sine, 1), length);
    let cosine = real_subtract(one, real_shift(real_multiply(part, sine_square), 1));
    let side = real3_combine(
        t.tangent,
        real_multiply(radius, x),
        t.ab_normal,
        real_multiply(radius, y),
    );
    real3_floats(real3_add(real3_scale(t.b, cosine), side))
}

/// The direction whose moving vertex parts half the solid angle into before and behind, in
/// turns, a fraction u of the way from b.
#[inline]
#[must_use]
pub fn spherical_triangle_at(t: SphericalTriangle, before: Real, behind: Real, u: u32) -> Vec3 {
    let v = moving_vertex(t, before, behind);
    let square = real_square(v.b_cosine);
    let far = real_less(square, real_uint(1, -1))
        && real_less(real_multiply(square, t.ab.cosine), t.ab.sine);
    // Nearly opposite vertices leave nothing of their sum.
    if far || real_less(t.ca.cosine, real_shift(t.ab.sine, -5)) {
        return spherical_triangle_polar(t, v, before, u);
    }
    spherical_triangle_sum(t, v, u)
}

/// Uniform direction of the triangle.
#[inline]
#[must_use]
pub fn spherical_triangle(t: SphericalTriangle, u: UVec2) -> Vec3 {
    if t.area.m == 0 {
        return vec3(0.0, 0.0, 1.0);
    }
    let before = real_multiply(t.area, real_uint(u.x, -32));
    let behind = real_multiply(t.area, real_complement(u.x));
    spherical_triangle_at(t, before, behind, u.y)
}

/// The solid angle.
#[inline]
#[must_use]
pub fn spherical_triangle_solid_angle(t: SphericalTriangle) -> f32 {
    // 4 pi to 32 bits.
    real_float(real_multiply(t.area, real_uint(3_373_259_426, -28)))
}

/// Whether a direction is on the inner side of a plane, or beyond it by its rounding.
#[inline]
#[must_use]
pub fn spherical_triangle_side(normal: Real3, direction: Real3, size: Real) -> bool {
    let x = real_multiply(normal.x, direction.x);
    let y = real_multiply(normal.y, direction.y);
    let z = real_multiply(normal.z, direction.z);
    let sum = real_add(
        real_add(
            Real {
                m: x.m,
                e: x.e,
                negative: false,
            },
            Real {
                m: y.m,
                e: y.e,
                negative: false,
            },
        ),
        Real {
            m: z.m,
            e: z.e,
            negative: false,
        },
    );
    let slack = real_add(real_shift(sum, -22), real_shift(size, -24));
    !real_add(real_add(real_add(x, y), z), slack).negative
}

/// Whether a direction is in the triangle.
#[inline]
#[must_use]
pub fn spherical_triangle_inside(t: SphericalTriangle, direction: Real3) -> bool {
    let size = real_max(t.ab.sine, real_max(t.bc.sine, t.ca.sine));
    t.area.m != 0
        && spherical_triangle_side(t.ab_normal, direction, size)
        && spherical_triangle_side(t.bc_normal, direction, size)
        && spherical_triangle_side(t.ca_normal, direction, size)
}

/// 1 over the solid angle, the pdf of every sample; 0 where there is none.
#[inline]
#[must_use]
pub fn spherical_triangle_density(t: SphericalTriangle) -> f32 {
    let mut density = real_zero();
    if t.area.m != 0 {
        // 1/(4 pi) to 32 bits.
        density = real_divide(real_uint(2_734_261_102, -35), t.area);
    }
    real_float(density)
}

/// 1 over the solid angle inside, else 0.
#[inline]
#[must_use]
pub fn spherical_triangle_pdf(t: SphericalTriangle, direction: Vec3) -> f32 {
    if !spherical_triangle_inside(t, real3(direction)) {
        return 0.0;
    }
    spherical_triangle_density(t)
}

/// Half the solid angle before the moving vertex of a direction, in turns, and what u.y is.
#[inline]
#[must_use]
pub fn spherical_triangle_parts(t: SphericalTriangle, direction: Real3) -> Arc {
    let one = real_uint(1, 0);
    let mut x = real3_dot(direction, t.tangent);
    let mut y = real_max(real3_dot(direction, t.ab_normal), real_zero());
    let radius_square = real_add(real_square(x), real_square(y));
    let radius = real_sqrt(radius_square);
    x = real_divide(x, radius);
    y = real_divide(y, radius);
    // The way from b in this direction meets ca at an angle with this cotangent.
    let slope = real_divide(
        real_subtract(real_square(t.ab.cosine), real_square(t.ab.sine)),
        real_shift(real_multiply(t.ab.cosine, t.ab.sine), 1),
    );
    let lean = real_divide(real3_dot(t.ab_normal, t.ca_normal), t.height);
    let cotangent = real_subtract(real_multiply(slope, x), real_multiply(lean, y));
    let root = real_sqrt(real_add(one, real_square(cotangent)));
    let mut tangent = real_add(
        root,
        Real {
            m: cotangent.m,
            e: cotangent.e,
            negative: false,
        },
    );
    if !cotangent.negative {
        tangent = real_divide(one, tangent);
    }
    let product = real_divide(real_multiply(tangent, t.ab.sine), t.ab.cosine);
    let before = angle(
        real_multiply(product, y),
        real_add(one, real_multiply(product, x)),
    );
    // sin^2 of half the angle from b to the direction, over that to the moving vertex.
    let versine = real_shift(sphere_versine(radius_square, real3_dot(direction, t.b)), -1);
    let square = real_square(tangent);
    let whole = real_divide(square, real_add(one, square));
    Arc {
        cosine: before,
        sine: real_divide(versine, whole),
    }
}

/// The fractions that give this direction.
#[inline]
#[must_use]
pub fn spherical_triangle_invert(t: SphericalTriangle, direction: Vec3) -> UVec2 {
    if t.area.m == 0 {
        return UVec2::ZERO;
    }
    let parts = spherical_triangle_parts(t, real3(direction));
    uvec2(
        real_fraction_nearest(real_divide(parts.cosine, t.area)),
        real_fraction_nearest(parts.sine),
    )
}
