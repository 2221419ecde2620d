//! Functions of one word over all inputs that matter: the words of every device equal
//! the reference's, and so does their SHA-256, which is committed here.
//!
//! `cargo test --release --test gpu_exhaustive -- --nocapture` prints the hashes to
//! commit, once the words equal the reference's. `-- --ignored` tries all 2^32 inputs.

mod support;

use std::sync::Arc;
use std::time::Instant;

use corput::catalog::{Engine, Options, Request, Sequence};
use corput::kernels::{Evaluator, Generator};
use corput::reference::real::{Real, real, real_float};
use corput::reference::{
    elementary, exponential, logarithm, normal_quantile, radical_inverse, unit,
};
use corput::vulkan::Device;
use sha2::{Digest, Sha256};

/// All words.
const TOTAL: u64 = 1 << 32;

/// Results of one dispatch.
const CHUNK: u32 = 1 << 22;

/// A function and its inputs: first, first + stride, ...
struct Case {
    name: &'static str,
    kernel: &'static str,
    /// Number of the function in it.
    id: u32,
    first: u32,
    stride: u32,
    reference: fn(u32) -> [u32; 4],
    /// SHA-256 of the results, four little-endian words each: of all 2^24 inputs, and
    /// of each 16th.
    hashes: [&'static str; 2],
}

const CASES: [Case; 8] = [
    Case {
        name: "unit and van der Corput, u = k << 8",
        kernel: "evaluate",
        id: 4,
        first: 0,
        stride: 256,
        reference: unit,
        hashes: [
            "f6946de4dedf4c1dd4fccae938b6c7d79bf2942c9b18f9d53c5f919a93bce723",
            "fd601abd382de7c8980f540f31b37a23ab394635f22faba35b5959e6262fe979",
        ],
    },
    Case {
        name: "unit and van der Corput, u = k << 8 | 1",
        kernel: "evaluate",
        id: 4,
        first: 1,
        stride: 256,
        reference: unit,
        hashes: [
            "d28bfcf9ea858d76e62fb0794e09cca53923271c358a89b0120ad08ea1d94bae",
            "2d3de05e5cfdd3df3ae59f815f3341629b34b55e1cd6938bf2b83c77134b961d",
        ],
    },
    Case {
        name: "cos_sin, u = k << 8",
        kernel: "evaluate",
        id: 5,
        first: 0,
        stride: 256,
        reference: cos_sin,
        hashes: [
            "089346cd6d0f6979119b02c6c9e2d84ef777091262086c424b21e40d3833b72c",
            "59865c5da2a2e5199a258f053d4b21ca174d7d7d74e959475d08514994df66e5",
        ],
    },
    Case {
        name: "sqrt, every float of [1, 4)",
        kernel: "evaluate",
        id: 6,
        first: 0x3f80_0000,
        stride: 1,
        reference: sqrt,
        hashes: [
            "aab7e621a087f9ed96fb1d1a5169c0d287e1bdcc619a1e05052ae8d967fd164d",
            "5a0913f53df2c7f02c43c2f46b206987434526b97c973115afe95f646c48eedc",
        ],
    },
    Case {
        name: "-ln(1 - u), u = k << 8 | 1",
        kernel: "evaluate_elementary",
        id: 0,
        first: 1,
        stride: 256,
        reference: negative_log,
        hashes: [
            "142bb87e0a2ef9903ff30617dc91f811ebe41dc718401e31f709372923b2c969",
            "eebb96c19baad59233222667d52088f3fb7bf0dbb93cd0532f99d3e6e6a876cd",
        ],
    },
    Case {
        name: "ln and log2, every float of [1/2, 2)",
        kernel: "evaluate_elementary",
        id: 1,
        first: 0x3f00_0000,
        stride: 1,
        reference: log,
        hashes: [
            "3f2a2f037a9c12173b2cdc1620fc808f41a86b0d76b51072afa97b1e96d7d8d1",
            "83ab0d0a36d1c222daba58fcab529da1fe43339c9323ae8de97ed76ce07e44ed",
        ],
    },
    Case {
        name: "exp2, every float of [-2, -1/2)",
        kernel: "evaluate_elementary",
        id: 2,
        first: 0xbf00_0000,
        stride: 1,
        reference: exp2,
        hashes: [
            "76c0c5b9819680eddc43d60105337613df2cb41f98f52011035e80f92cc6ebfa",
            "696aa9e8d2948d379b36ef98a072b2410ffe1536e7d03b0bae6b9f1d48ab4d67",
        ],
    },
    Case {
        name: "normal quantile, u = k << 8 | 1",
        kernel: "evaluate_elementary",
        id: 4,
        first: 1,
        stride: 256,
        reference: normal_quantile,
        hashes: [
            "15fd71a8b98a27677b6c24d1cc5c97934f58eaef9cf1e64a07d5464d86f9e5a1",
            "6ee42a9995fd5d7129ae7361c52fad583cedfd473c0b278b1167e591dfeee936",
        ],
    },
];

fn words(a: Real) -> [u32; 2] {
    [a.m, ((a.e as u32) << 1) | u32::from(a.negative)]
}

fn negative_log(u: u32) -> [u32; 4] {
    let [m, e] = words(logarithm::real_negative_log(u));
    [logarithm::negative_log(u).to_bits(), m, e, 0]
}

fn log(bits: u32) -> [u32; 4] {
    let x = f32::from_bits(bits);
    let [m, e] = words(logarithm::real_log(real(x)));
    [
        logarithm::log(x).to_bits(),
        logarithm::log2(x).to_bits(),
        m,
        e,
    ]
}

/// Also of the same float with its exponent in a range that no result leaves.
fn exp2(bits: u32) -> [u32; 4] {
    let x = f32::from_bits((bits & 0x807f_ffff) | ((103 + ((bits >> 23) & 31)) << 23));
    let gaussian = real_float(exponential::real_gaussian(real(x)));
    let whole = exponential::exp2(f32::from_bits(bits));
    [whole, exponential::exp2(x), exponential::exp(x), gaussian].map(f32::to_bits)
}

fn normal_quantile(u: u32) -> [u32; 4] {
    let z = normal_quantile::real_normal_quantile(u);
    let floats = [
        normal_quantile::normal_quantile(u),
        normal_quantile::inverse_erf(u),
    ];
    let [z_bits, erf_bits] = floats.map(f32::to_bits);
    [z_bits, erf_bits, normal_quantile::normal_fraction(z), 0]
}

fn unit(u: u32) -> [u32; 4] {
    let floor = unit::unit_floor(u).to_bits();
    let ceil = unit::unit_ceil(u).to_bits();
    [floor, ceil, radical_inverse::van_der_corput(u), 0]
}

fn cos_sin(u: u32) -> [u32; 4] {
    let p = elementary::cos_sin(u);
    [p.x.to_bits(), p.y.to_bits(), 0, 0]
}

fn sqrt(bits: u32) -> [u32; 4] {
    [elementary::sqrt(f32::from_bits(bits)).to_bits(), 0, 0, 0]
}

/// Calls `test` with equal parts of a slice, each on a core of its own.
fn in_parts<T: Sync>(all: &[T], test: impl Fn(usize, &[T]) + Sync) {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let part = all.len().div_ceil(cores).max(1);
    std::thread::scope(|scope| {
        for (i, slice) in all.chunks(part).enumerate() {
            let test = &test;
            scope.spawn(move || test(i * part, slice));
        }
    });
}

/// Results of `count` inputs, all compared, and their hash.
fn compared(evaluator: &Evaluator, case: &Case, stride: u32, count: u64) -> String {
    let mut hash = Sha256::new();
    let mut done = 0;
    while done < count {
        let part = (count - done).min(u64::from(CHUNK)) as u32;
        let first = case.first.wrapping_add((done as u32).wrapping_mul(stride));
        let results = evaluator
            .run_indexed(first, stride, part)
            .unwrap_or_else(|error| panic!("{error}"));
        in_parts(&results, |start, results| {
            for (i, got) in results.iter().enumerate() {
                let u = first.wrapping_add(((start + i) as u32).wrapping_mul(stride));
                let expected = (case.reference)(u);
                assert_eq!(*got, expected, "{} of {u:#010x}", case.name);
            }
        });
        hash.update(bytemuck::cast_slice::<_, u8>(&results));
        done += u64::from(part);
    }
    hash.finalize()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

fn evaluator(device: &Arc<Device>, case: &Case) -> Evaluator {
    Evaluator::new(device, case.kernel, case.id).unwrap_or_else(|error| panic!("{error}"))
}

/// All 2^24 inputs, but only each 16th where all would take longer than 20 s.
#[test]
fn words_and_hashes_are_the_same_everywhere() {
    support::on_each_device(|device| {
        let mut wrong = Vec::new();
        for case in &CASES {
            let evaluator = evaluator(device, case);
            let begin = Instant::now();
            let hash = compared(&evaluator, case, case.stride * 16, 1 << 20);
            let spent = begin.elapsed().as_secs_f64();
            println!("{}: each 16th: {hash} ({spent:.2} s)", case.name);
            if hash != case.hashes[1] {
                wrong.push(case.name);
            }
            if spent * 16.0 > 20.0 {
                println!("{}: not all 2^24: too slow here", case.name);
                continue;
            }
            let begin = Instant::now();
            let hash = compared(&evaluator, case, case.stride, 1 << 24);
            let spent = begin.elapsed().as_secs_f64();
            println!("{}: all: {hash} ({spent:.2} s)", case.name);
            if hash != case.hashes[0] {
                wrong.push(case.name);
            }
        }
        assert!(
            wrong.is_empty(),
            "hashes other than the committed: {wrong:?}"
        );
    });
}

/// All 2^32 inputs on one device: about three to five minutes each on lavapipe with two
/// cores, most of them the reference's.
fn every_word(case: &Case) {
    support::on_one_device(|device| {
        let from_zero = Case { first: 0, ..*case };
        let begin = Instant::now();
        let hash = compared(&evaluator(device, case), &from_zero, 1, TOTAL);
        println!(
            "{}: {hash} ({:.1} s)",
            case.name,
            begin.elapsed().as_secs_f64()
        );
    });
}
#[test]
#[ignore = "minutes"]
fn every_word_as_a_unit_float() {
    every_word(&CASES[0]);
}

#[test]
#[ignore = "minutes"]
fn every_angle() {
    every_word(&CASES[2]);
}

#[test]
#[ignore = "minutes"]
fn every_root() {
    every_word(&CASES[3]);
}

#[test]
#[ignore = "minutes"]
fn every_log_of_a_fraction() {
    every_word(&CASES[4]);
}

#[test]
#[ignore = "minutes"]
fn every_log_of_a_float() {
    every_word(&CASES[5]);
}

#[test]
#[ignore = "minutes"]
fn every_exponential() {
    every_word(&CASES[6]);
}

#[test]
#[ignore = "minutes"]
fn every_normal_quantile() {
    every_word(&CASES[7]);
}

/// The worst error of floats over all 2^32 fractions, against the judge: by no device.
#[test]
#[ignore = "minutes"]
fn every_log_and_quantile_is_within_its_bound() {
    use corput::judge;
    let worst = |error: &(dyn Fn(u32) -> f64 + Sync)| {
        let parts: Vec<u32> = (0..256).collect();
        let all = std::sync::Mutex::new(0f64);
        in_parts(&parts, |_, parts| {
            for part in parts {
                let words = part << 24..=(part << 24) | 0xff_ffff;
                let worst = words.map(error).fold(0.0, f64::max);
                let mut all = all
                    .lock()
                    .unwrap_or_else(std::sync::PoisonError::into_inner);
                *all = all.max(worst);
            }
        });
        all.into_inner().unwrap_or(f64::NAN)
    };
    let log = worst(&|u| judge::ulp_error(logarithm::negative_log(u), judge::negative_log(u)));
    let quantile = worst(&|u| {
        judge::ulp_error(
            normal_quantile::normal_quantile(u),
            judge::normal_quantile(u),
        )
    });
    println!("-ln(1 - u): {log:.4} ULP; normal quantile: {quantile:.4} ULP");
    assert!(log < 0.51 && quantile < 0.54, "{log} {quantile}");
}

/// As [`every_word`]: the odometer in base 3, and a table's division in base 8161.
fn every_index(base: u32) {
    support::on_one_device(|device| {
        let mut options = Options::new(Sequence::Halton, 1 << 32);
        options.bases = Some(vec![u64::from(base)]);
        options.fractions = true;
        let request = Request::new(&options).unwrap_or_else(|error| panic!("{error}"));
        let table = corput::variant::radical_base(base);
        let mut first = 0u32;
        let begin = Instant::now();
        Generator::new(device, &request)
            .and_then(|mut generator| {
                generator.make(0, TOTAL, &mut |words| {
                    in_parts(words, |start, words| {
                        for (n, &got) in (first + start as u32..=u32::MAX).zip(words) {
                            let expected = radical_inverse::radical_inverse_table(n, table);
                            assert_eq!(got, expected, "index {n} in base {base}");
                        }
                    });
                    first = first.wrapping_add(words.len() as u32);
                    Ok(())
                })
            })
            .unwrap_or_else(|error| panic!("{error}"));
        println!("base {base}: {:.1} s", begin.elapsed().as_secs_f64());
    });
}

#[test]
#[ignore = "minutes"]
fn every_index_in_base_3() {
    every_index(3);
}

#[test]
#[ignore = "minutes"]
fn every_index_in_base_8161() {
    every_index(8161);
}
