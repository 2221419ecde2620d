//! The irradiance of a map, judged by closed forms, by refinement and by brute force.

use std::f64::consts::{PI, TAU};

use corput::irradiance::irradiance;

/// A fixed stream of 32-bit numbers (splitmix64).
struct Stream(u64);

impl Stream {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn normal(&mut self) -> [f64; 3] {
        let z = 2.0 * self.unit() - 1.0;
        let r = (1.0 - z * z).sqrt();
        let p = TAU * self.unit();
        [r * p.cos(), r * p.sin(), z]
    }

    fn map(&mut self, width: u32, height: u32) -> Vec<[f32; 3]> {
        (0..width * height)
            .map(|_| [(); 3].map(|()| self.unit() as f32))
            .collect()
    }
}

const AXES: [[f64; 3]; 6] = [
    [1., 0., 0.],
    [-1., 0., 0.],
    [0., 1., 0.],
    [0., -1., 0.],
    [0., 0., 1.],
    [0., 0., -1.],
];

/// Axes, slightly tilted axes, diagonals and random ones.
fn normals(stream: &mut Stream) -> Vec<[f64; 3]> {
    let mut all = AXES.to_vec();
    for tilt in [1e-17, 1e-12, 1e-8, 1e-4, 1e-2] {
        all.extend([
            [tilt, 0., 1.],
            [1., 0., tilt],
            [0., -1., -tilt],
            [-tilt, tilt, -1.],
        ]);
    }
    all.extend([
        [0.6, 0., 0.8],
        [0., 0.8, -0.6],
        [-0.5_f64.sqrt(), 0.5_f64.sqrt(), 0.],
    ]);
    all.extend((0..40).map(|_| stream.normal()));
    all.into_iter()
        .map(|n| {
            let length = n.iter().map(|x| x * x).sum::<f64>().sqrt();
            n.map(|x| x / length)
        })
        .collect()
}

fn negative(n: [f64; 3]) -> [f64; 3] {
    n.map(|x| -x)
}

fn close(actual: f64, expected: f64, relative: f64, what: &str) {
    let error = (actual - expected).abs();
    assert!(
        error <= relative * expected.abs(),
        "{what}: {actual} against {expected}, off by {error:e}"
    );
}

/// Closed-form integral of n.w over one texel, without the horizon.
fn signed(width: u32, height: u32, column: u32, row: u32, n: [f64; 3]) -> f64 {
    let [p0, p1] = [0, 1].map(|i| TAU * f64::from(column + i) / f64::from(width));
    let [t0, t1] = [0, 1].map(|i| PI * f64::from(row + i) / f64::from(height));
    let sin_squared = 0.5 * (t1 - t0) - 0.25 * ((2.0 * t1).sin() - (2.0 * t0).sin());
    let sin_cos = 0.5 * (t1.sin().powi(2) - t0.sin().powi(2));
    sin_squared * (n[0] * (p1.sin() - p0.sin()) + n[1] * (p0.cos() - p1.cos()))
        + n[2] * sin_cos * (p1 - p0)
}

#[test]
fn a_white_map_gives_pi() {
    let mut stream = Stream(1);
    let mut worst = 0.0_f64;
    for (width, height) in [
        (1, 1),
        (2, 1),
        (1, 2),
        (5, 3),
        (8, 4),
        (7, 64),
        (64, 7),
        (128, 64),
    ] {
        let white = vec![[1.0; 3]; (width * height) as usize];
        for n in normals(&mut stream) {
            for e in irradiance(width, height, &white, n) {
                close(e, PI, 1e-12, &format!("{width} x {height}, {n:?}"));
                worst = worst.max((e / PI - 1.0).abs());
            }
        }
    }
    println!("worst relative error {worst:e}");
}

#[test]
fn refining_a_map_changes_nothing() {
    let mut stream = Stream(2);
    for (width, height) in [(1, 1), (2, 1), (5, 3), (8, 4)] {
        let map = stream.map(width, height);
        for factor in [2, 3, 16] {
            let (fine_width, fine_height) = (width * factor, height * factor);
            let fine: Vec<[f32; 3]> = (0..fine_height)
                .flat_map(|r| (0..fine_width).map(move |c| (r, c)))
                .map(|(r, c)| map[((r / factor) * width + c / factor) as usize])
                .collect();
            for n in normals(&mut stream) {
                let coarse = irradiance(width, height, &map, n);
                let fine = irradiance(fine_width, fine_height, &fine, n);
                for (a, b) in coarse.into_iter().zip(fine) {
                    close(
                        a,
                        b,
                        1e-12,
                        &format!("{width} x {height} by {factor}, {n:?}"),
                    );
                }
            }
        }
    }
}

#[test]
fn brute_force_agrees() {
    const PARTS: u32 = 64;
    let mut stream = Stream(3);
    for (width, height) in [(8, 4), (5, 3), (1, 1), (2, 1)] {
        let map = stream.map(width, height);
        for _ in 0..4 {
            let n = stream.normal();
            let mut expected = [0.0; 3];
            for row in 0..height * PARTS {
                let t = PI * (f64::from(row) + 0.5) / f64::from(height * PARTS);
                for column in 0..width * PARTS {
                    let p = TAU * (f64::from(column) + 0.5) / f64::from(width * PARTS);
                    let w = [t.sin() * p.cos(), t.sin() * p.sin(), t.cos()];
                    let cosine = n[0] * w[0] + n[1] * w[1] + n[2] * w[2];
                    let area = t.sin() * PI * TAU / f64::from(width * height * PARTS * PARTS);
                    let texel = map[((row / PARTS) * width + column / PARTS) as usize];
                    for (e, l) in expected.iter_mut().zip(texel) {
                        *e += f64::from(l) * cosine.max(0.0) * area;
                    }
                }
            }
            for (a, b) in irradiance(width, height, &map, n).into_iter().zip(expected) {
                close(a, b, 2e-3, &format!("{width} x {height}, {n:?}"));
            }
        }
    }
}

#[test]
fn opposite_normals_differ_by_the_signed_integral() {
    let mut stream = Stream(4);
    for (width, height) in [(8, 4), (5, 3), (2, 1), (64, 32)] {
        for _ in 0..20 {
            let (column, row) = (stream.bits() as u32 % width, stream.bits() as u32 % height);
            let mut map = vec![[0.0; 3]; (width * height) as usize];
            map[(row * width + column) as usize] = [1.0; 3];
            for n in normals(&mut stream) {
                let above = irradiance(width, height, &map, n)[0];
                let below = irradiance(width, height, &map, negative(n))[0];
                assert!(above >= 0.0 && below >= 0.0, "{above} {below}");
                let difference = signed(width, height, column, row, n);
                let error = (above - below - difference).abs();
                // The subtractions of the expected value cost the absolute 1e-15.
                assert!(
                    error <= 1e-12 * (above + below) + 1e-15,
                    "{width} {height} {n:?} {error:e}"
                );
            }
        }
    }
}

#[test]
fn opposite_normals_add_up_to_the_absolute_cosine() {
    let mut stream = Stream(5);
    let (width, height) = (8, 4);
    let map = stream.map(width, height);
    for _ in 0..4 {
        let n = stream.normal();
        let [above, below] = [n, negative(n)].map(|n| irradiance(width, height, &map, n)[0]);
        // The same by texels small enough that almost none is cut.
        let parts = 64;
        let mut expected = 0.0;
        for row in 0..height * parts {
            for column in 0..width * parts {
                let l = map[((row / parts) * width + column / parts) as usize][0];
                expected +=
                    f64::from(l) * signed(width * parts, height * parts, column, row, n).abs();
            }
        }
        close(above + below, expected, 1e-4, &format!("{n:?}"));
    }
}

#[test]
fn six_axes_of_one_texel_add_up() {
    // Within an octant every axis is either wholly above or wholly below the horizon.
    let (width, height) = (16, 8);
    for row in 0..height {
        for column in 0..width {
            let mut map = vec![[0.0; 3]; (width * height) as usize];
            map[(row * width + column) as usize] = [1.0, 2.0, 0.5];
            let sum = AXES
                .map(|n| irradiance(width, height, &map, n))
                .into_iter()
                .fold([0.0; 3], |sum, e| {
                    [sum[0] + e[0], sum[1] + e[1], sum[2] + e[2]]
                });
            let sign = |low: u32, high: u32| {
                if (low..high).contains(&column) {
                    -1.0
                } else {
                    1.0
                }
            };
            let up = if row < height / 2 { 1.0 } else { -1.0 };
            let octant = [sign(4, 12), sign(8, 16), up];
            let expected = signed(width, height, column, row, octant);
            for (e, l) in sum.into_iter().zip([1.0, 2.0, 0.5]) {
                close(
                    e,
                    l * expected,
                    1e-14,
                    &format!("row {row}, column {column}"),
                );
            }
        }
    }
}

#[test]
fn turning_map_and_normal_together_changes_no_bit() {
    let mut stream = Stream(6);
    let (width, height) = (32, 16);
    let map = stream.map(width, height);
    let turned: Vec<[f32; 3]> = (0..height)
        .flat_map(|r| (0..width).map(move |c| (r, (c + width - width / 4) % width)))
        .map(|(r, c)| map[(r * width + c) as usize])
        .collect();
    for [x, y, z] in AXES {
        let still = irradiance(width, height, &map, [x, y, z]);
        let moved = irradiance(width, height, &turned, [-y, x, z]);
        assert_eq!(still, moved, "{x} {y} {z}");
    }
}

#[test]
fn mirrored_maps_give_mirrored_values() {
    let mut stream = Stream(7);
    let (width, height) = (12, 5);
    let map = stream.map(width, height);
    let mirrored: Vec<[f32; 3]> = map
        .chunks(width as usize)
        .rev()
        .flatten()
        .copied()
        .collect();
    for n in normals(&mut stream) {
        let still = irradiance(width, height, &map, n);
        let moved = irradiance(width, height, &mirrored, [n[0], n[1], -n[2]]);
        for (a, b) in still.into_iter().zip(moved) {
            close(a, b, 1e-14, &format!("{n:?}"));
        }
    }
}

#[test]
fn degenerate_arguments_have_defined_results() {
    assert_eq!(irradiance(0, 0, &[], [0., 0., 1.]), [0.0; 3]);
    assert_eq!(irradiance(2, 1, &[[1.0; 3]; 2], [0., 0., 0.]), [0.0; 3]);
    assert!(irradiance(2, 1, &[[1.0; 3]; 2], [f64::NAN, 0., 0.])[0].is_nan());
    close(
        irradiance(2, 1, &[[1.0; 3]; 2], [0., 0., 2.])[0],
        TAU,
        1e-13,
        "length 2",
    );
}

#[test]
fn a_full_map_takes_well_under_a_second() {
    let (width, height) = (1024, 512);
    let map = Stream(8).map(width, height);
    let start = std::time::Instant::now();
    let sum: f64 = AXES
        .iter()
        .map(|&n| irradiance(width, height, &map, n)[0])
        .sum();
    let time = start.elapsed();
    println!("1024 x 512, six normals: {time:?} ({sum})");
    // Generous: a debug build on a loaded machine.
    assert!(time.as_secs() < 10, "{time:?}");
}
