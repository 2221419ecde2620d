//! The CPU reference against the judge: elementary functions and maps, with worst ULP.

use corput::glam::{Vec2, Vec3, uvec2, vec2};
use corput::judge::{self, ulp_error};
use corput::reference::{disk, elementary, fixed, hemisphere, unit};

/// A hash to spread inputs over all 32 bits; any good mixer serves.
fn mix(mut x: u32) -> u32 {
    x ^= x >> 16;
    x = x.wrapping_mul(0x7feb_352d);
    x ^= x >> 15;
    x = x.wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

/// Edges of 32-bit fractions: around 0, every power of two and every eighth.
fn edges() -> Vec<u32> {
    let mut edges = Vec::new();
    for bit in 0..32 {
        for offset in -3i64..=3 {
            edges.push(((1i64 << bit) + offset) as u32);
            edges.push((-(1i64 << bit) + offset) as u32);
        }
    }
    for eighth in 0..8u32 {
        for offset in 0..9u32 {
            edges.push((eighth << 29).wrapping_add(offset).wrapping_sub(4));
        }
    }
    edges.sort_unstable();
    edges.dedup();
    edges
}

fn worst(inputs: impl Iterator<Item = u32>, error: impl Fn(u32) -> f64) -> (f64, u32) {
    let mut worst = (0.0, 0);
    for u in inputs {
        let e = error(u);
        assert!(e.is_finite(), "no finite error at {u:#x}");
        if e > worst.0 {
            worst = (e, u);
        }
    }
    worst
}

fn sin_cos_error(u: u32) -> f64 {
    let got = elementary::cos_sin(u);
    let (s, c) = judge::sin_cos(u);
    ulp_error(got.x, c).max(ulp_error(got.y, s))
}

#[test]
fn sincos_over_every_24_bit_turn_is_within_0_52_ulp() {
    let (e, u) = worst((0..1 << 24).map(|k| k << 8), sin_cos_error);
    assert!(e < 0.52, "{e} at {u:#x}");
    let (e, u) = worst((0..1 << 22).map(mix).chain(edges()), sin_cos_error);
    assert!(e < 0.53, "{e} at {u:#x}");
}

#[test]
#[ignore = "all 2^32 inputs: minutes"]
fn sincos_over_every_turn() {
    let (e, u) = worst(0..=u32::MAX, sin_cos_error);
    println!("sincos: {e} ULP at {u:#x}");
    assert!(e < 0.53, "{e} at {u:#x}");
}

#[test]
fn sqrt_is_correctly_rounded_for_every_mantissa_of_two_octaves() {
    for bits in 0x3f00_0000u32..0x4000_0000 {
        let x = f32::from_bits(bits);
        assert_eq!(
            elementary::sqrt(x).to_bits(),
            judge::sqrt(x).to_bits(),
            "{bits:#x}"
        );
    }
    for i in 0..1 << 20 {
        let bits = mix(i) & 0x7fff_ffff;
        let x = f32::from_bits(bits);
        if x.is_normal() {
            assert_eq!(
                elementary::sqrt(x).to_bits(),
                judge::sqrt(x).to_bits(),
                "{bits:#x}"
            );
        }
    }
    assert_eq!(elementary::sqrt(-0.0).to_bits(), 0);
    assert_eq!(elementary::sqrt(f32::INFINITY), f32::INFINITY);
    assert_eq!(elementary::sqrt(-1.0).to_bits(), 0x7fc0_0000);
    assert_eq!(elementary::sqrt(f32::NAN).to_bits(), 0x7fc0_0000);
}

#[test]
fn divide_and_multiply_are_correctly_rounded() {
    let special = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::MAX,
        f32::MIN_POSITIVE,
        1.5,
        3.0,
        1.0 - f32::EPSILON / 2.0,
        1.0 + f32::EPSILON,
        1e-20,
        1e20,
        0.1,
    ];
    let check = |x: f32, y: f32| {
        for (name, got, truth) in [
            ("/", elementary::divide(x, y), judge::divide(x, y)),
            ("*", elementary::multiply(x, y), judge::multiply(x, y)),
        ] {
            if truth.is_nan() {
                assert_eq!(got.to_bits(), 0x7fc0_0000, "{x:e} {name} {y:e}");
            } else {
                assert_eq!(
                    got.to_bits(),
                    truth.to_bits(),
                    "{x:e} {name} {y:e}: {got:e} {truth:e}"
                );
            }
        }
    };
    for x in special {
        for y in special {
            check(x, y);
        }
    }
    for i in 0..1u32 << 22 {
        let x = f32::from_bits(mix(i));
        let y = f32::from_bits(mix(i ^ 0x5bd1_e995));
        if !x.is_subnormal() && !y.is_subnormal() {
            check(x, y);
        }
        // Near ties: mantissas of 12 bits multiply and divide to short results.
        let short = |k: u32| f32::from_bits(0x3f80_0000 | (mix(k) & 0x7f_f000));
        check(short(i), short(!i));
    }
}

#[test]
fn roots_of_fractions_are_truncated_to_25_bits() {
    let check = |u: u32| {
        let s = elementary::sqrt_fraction(u);
        let truth = (f64::from(u) / 4_294_967_296.0).sqrt();
        let got = f64::from(s.m) * f64::powi(2.0, s.e);
        assert!(
            got <= truth && truth - got <= truth * f64::powi(2.0, -24),
            "{u:#x}"
        );
        let wide = elementary::sqrt_fraction64(uvec2(mix(u), u));
        let value = f64::from(u) * f64::powi(2.0, -32) + f64::from(mix(u)) * f64::powi(2.0, -64);
        let got = f64::from(wide.m) * f64::powi(2.0, wide.e);
        let truth = value.sqrt();
        assert!(
            (got - truth).abs() <= truth * f64::powi(2.0, -24) * (1.0 + f64::powi(2.0, -7)),
            "{u:#x}"
        );
    };
    edges().into_iter().for_each(check);
    (0..1 << 20).map(mix).for_each(check);
}

#[test]
fn ratio_is_the_floor_of_the_quotient() {
    let check = |b: u32, a: u32| {
        let truth = (u64::from(b) << 30) / u64::from(a);
        assert_eq!(u64::from(elementary::ratio(b, a)), truth, "{b} / {a}");
    };
    let mut critical: Vec<u32> = edges().into_iter().map(|u| u >> 1).collect();
    critical.push(1 << 31);
    for &a in &critical {
        for &b in &critical {
            if a > 0 && b <= a {
                check(b, a);
            }
        }
    }
    for i in 0..1u32 << 22 {
        let a = (mix(i) >> 1 >> (mix(!i) & 31)).max(1);
        check(mix(i ^ 0x9e37_79b9) % (a + 1), a);
    }
}

#[test]
fn atan2_is_within_two_units() {
    let check = |x: f32, y: f32| {
        let truth = judge::atan2_turns(y, x) * 4_294_967_296.0;
        let got = f64::from(elementary::atan2(y, x));
        let difference = (got - truth).abs();
        let difference = difference.min(4_294_967_296.0 - difference);
        assert!(difference <= 2.0, "atan2({y:e}, {x:e}): {got} for {truth}");
    };
    for i in 0..1u32 << 22 {
        let exponent = |k: u32| (127 - (mix(k) % 40)) << 23;
        let value = |k: u32| f32::from_bits((mix(k) & 0x807f_ffff) | exponent(!k));
        check(value(i), value(i ^ 0x1234_5678));
    }
    for x in [0.0, 1.0, -1.0, 0.5, 1e-30, -1e-30, 1e30] {
        for y in [0.0, 1.0, -1.0, 0.5, 1e-30, -1e-30, 1e30] {
            if x != 0.0 || y != 0.0 {
                check(x, y);
            }
        }
    }
    assert_eq!(elementary::atan2(0.0, 0.0), 0);
    assert_eq!(elementary::atan2(-0.0, -1.0), 1 << 31);
}

#[test]
fn maps_are_within_their_stated_ulp() {
    let mut worst = [0f64; 5];
    let mut at = [[0u32; 2]; 5];
    let mut check = |u: [u32; 2]| {
        let v = uvec2(u[0], u[1]);
        let planar = |p: Vec2, t: [f64; 2]| ulp_error(p.x, t[0]).max(ulp_error(p.y, t[1]));
        let spatial =
            |p: Vec3, t: [f64; 3]| planar(vec2(p.x, p.y), [t[0], t[1]]).max(ulp_error(p.z, t[2]));
        let errors = [
            planar(disk::concentric_disk(v), judge::concentric_disk(u)),
            planar(disk::polar_disk(v), judge::polar_disk(u)),
            spatial(
                hemisphere::uniform_hemisphere(v),
                judge::uniform_hemisphere(u),
            ),
            spatial(
                hemisphere::cosine_hemisphere(v),
                judge::cosine_hemisphere(u),
            ),
            spatial(
                hemisphere::cosine_hemisphere_polar(v),
                judge::cosine_hemisphere_polar(u),
            ),
        ];
        for i in 0..5 {
            if errors[i] > worst[i] || !errors[i].is_finite() {
                worst[i] = errors[i];
                at[i] = u;
            }
        }
    };
    let edges = edges();
    for &x in &edges {
        for &y in &edges {
            check([x, y]);
        }
    }
    for i in 0..1u32 << 22 {
        check([mix(i), mix(i ^ 0x9e37_79b9)]);
    }
    println!("{worst:?} {at:x?}");
    for (i, limit) in [0.6, 1.6, 1.6, 0.6, 1.6].into_iter().enumerate() {
        assert!(
            worst[i] <= limit,
            "map {i}: {} ULP at {:x?}",
            worst[i],
            at[i]
        );
    }
}

#[test]
fn inverses_agree_with_samples() {
    let tolerance = 1i64 << 10;
    let near = |a: u32, b: u32| i64::from(a.wrapping_sub(b) as i32).abs() <= tolerance;
    // From 1: mix(0) = 0 is the centre, which has no angle.
    for i in 1..1u32 << 20 {
        let u = uvec2(mix(i), mix(i ^ 0x9e37_79b9));
        let c = hemisphere::cosine_hemisphere_invert(hemisphere::cosine_hemisphere(u));
        assert!(
            (i64::from(c.x) - i64::from(u.x)).abs() <= tolerance,
            "{u} {c}"
        );
        assert!(
            (i64::from(c.y) - i64::from(u.y)).abs() <= tolerance,
            "{u} {c}"
        );
        let p = hemisphere::cosine_hemisphere_polar_invert(hemisphere::cosine_hemisphere_polar(u));
        assert!(
            (i64::from(p.x) - i64::from(u.x)).abs() <= tolerance,
            "{u} {p}"
        );
        assert!(near(p.y, u.y), "{u} {p}");
        let h = hemisphere::uniform_hemisphere_invert(hemisphere::uniform_hemisphere(u));
        assert!(
            (i64::from(h.x) - i64::from(u.x)).abs() <= tolerance,
            "{u} {h}"
        );
        // Near the pole x and y are short, but as exact as long ones.
        assert!(near(h.y, u.y), "{u} {h}");
    }
    assert_eq!(
        disk::concentric_disk_invert(vec2(0.0, 0.0)),
        uvec2(1 << 31, 1 << 31)
    );
    assert_eq!(disk::polar_disk_invert(vec2(0.0, 0.0)), uvec2(0, 0));
}

#[test]
fn units_are_exact_and_below_one() {
    let check = |u: u32| {
        let floor = f64::from(u >> 8) / 16_777_216.0;
        assert_eq!(f64::from(unit::unit_floor(u)), floor);
        let ceil = (f64::from(u) / 256.0).ceil().min(16_777_215.0) / 16_777_216.0;
        assert_eq!(f64::from(unit::unit_ceil(u)), ceil);
        assert!(unit::unit_ceil(u) < 1.0);
    };
    edges().into_iter().for_each(check);
    (0..1 << 24)
        .map(|k| (k << 8) | (mix(k) & 0xff))
        .for_each(check);
    for (u, x) in [
        (0, 0.0),
        (0x8000_0000, 0.5),
        (0x8000_00ff, 0.5),
        (u32::MAX, 1.0 - 1.0 / 16_777_216.0),
    ] {
        assert_eq!(unit::unit_floor(u), x);
    }
}

#[test]
fn fixed_point_matches_128_bit_arithmetic() {
    for i in 0..1u32 << 18 {
        let (a, b) = (mix(i), mix(!i));
        let wide = |v: corput::glam::UVec2| u64::from(v.x) | (u64::from(v.y) << 32);
        assert_eq!(wide(fixed::mul64(a, b)), u64::from(a) * u64::from(b));
        let (x, y) = (uvec2(a, b), uvec2(mix(a), mix(b)));
        assert_eq!(wide(fixed::add64(x, y)), wide(x).wrapping_add(wide(y)));
        assert_eq!(wide(fixed::sub64(x, y)), wide(x).wrapping_sub(wide(y)));
        let s = i & 63;
        assert_eq!(wide(fixed::shl64(x, s)), wide(x) << s);
        assert_eq!(wide(fixed::shr64(x, s)), wide(x) >> s);
        let value = f32::from_bits((a & 0x007f_ffff) | ((90 + (b % 50)) << 23));
        let scale = (i % 40) as i32;
        let truth = (f64::from(value) * f64::powi(2.0, scale)).floor();
        assert_eq!(
            wide(fixed::fixed64(value, scale)) as f64,
            truth,
            "{value:e} {scale}"
        );
        let truth = (f64::from(value).min(1.0) * 2_147_483_648.0).floor();
        assert_eq!(f64::from(fixed::fixed31(value)), truth);
        assert_eq!(fixed::fixed31(-value), fixed::fixed31(value));
    }
}

/// Against arc cosine and arc tangent in `f64`, away from the edges of texels, where
/// either neighbour is right.
#[test]
fn envmap_texels_are_those_of_arc_cosine_and_arc_tangent() {
    use corput::bulk::row_edges;
    use corput::reference::envmap::envmap_texel;
    for (width, height) in [(1, 1), (2, 1), (5, 3), (1024, 512), (8192, 4096)] {
        let edges = row_edges(height);
        let mut judged = 0;
        for i in 1..1u32 << 16 {
            let d = hemisphere::uniform_hemisphere(uvec2(mix(i), mix(!i)));
            let d = if i & 1 == 0 {
                d
            } else {
                Vec3::new(d.x, d.y, -d.z)
            };
            let texel = envmap_texel(d, uvec2(width, height), &edges);
            let row =
                f64::from(d.z).clamp(-1.0, 1.0).acos() / std::f64::consts::PI * f64::from(height);
            let column = judge::atan2_turns(d.y, d.x) * f64::from(width);
            let near_edge = |x: f64| (x - x.round()).abs() < 1e-2;
            assert!(texel.x < width && texel.y < height);
            if !near_edge(row) && !near_edge(column) {
                assert_eq!(
                    [texel.x, texel.y],
                    [column as u32, row as u32],
                    "{d} in {width} x {height}"
                );
                judged += 1;
            }
        }
        assert!(judged > 60_000, "{judged} of {width} x {height}");
    }
}

#[test]
fn halton_takes_its_prime_and_no_base_gives_zero() {
    use corput::reference::{halton, primes, radical_inverse};
    for dimension in 0..1024 {
        let prime = primes::prime(dimension);
        let truth = judge::radical_inverse(123_456_789, prime);
        assert_eq!(u64::from(halton::halton(123_456_789, prime)), truth);
    }
    assert_eq!(primes::prime(1024), 0);
    for base in [0, 1, 65_536, u32::MAX] {
        assert_eq!(radical_inverse::radical_inverse(7, base), 0);
    }
}
