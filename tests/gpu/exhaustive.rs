//! Functions of one word over all inputs that matter: the words of every device equal
//! the reference's, and so does their SHA-256, which is committed here and in
//! `docs/exhaustive.json`.
//!
//! Hashes that are others fail the test, which prints them. `-- --ignored` tries all 2^32
//! inputs.

#[path = "exhaustive/maps.rs"]
mod maps;
mod support;

use std::sync::Arc;

use corput::Result;
use corput::catalog::{FUNCTIONS, Function};
use corput::check::Verdict;
use corput::exhaustive::{self, Domain, Hash, INDICES, Row, compare_function, compare_inverses};
use corput::kernels::{Evaluator, Generator, Reducer, kernel};
use corput::report::hexadecimal;
use corput::vulkan::Device;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

/// Results of one dispatch.
const CHUNK: u64 = 1 << 20;

/// A function of the catalogue and 2^24 inputs.
struct Case {
    name: &'static str,
    first: u32,
    stride: u32,
    /// SHA-256 of the results, four little-endian words each: of all 2^24 inputs, and
    /// of each 16th.
    hashes: [&'static str; 2],
}

const CASES: [Case; 8] = [
    Case {
        name: "unit",
        first: 0,
        stride: 256,
        hashes: [
            "f6946de4dedf4c1dd4fccae938b6c7d79bf2942c9b18f9d53c5f919a93bce723",
            "fd601abd382de7c8980f540f31b37a23ab394635f22faba35b5959e6262fe979",
        ],
    },
    Case {
        name: "unit",
        first: 1,
        stride: 256,
        hashes: [
            "d28bfcf9ea858d76e62fb0794e09cca53923271c358a89b0120ad08ea1d94bae",
            "2d3de05e5cfdd3df3ae59f815f3341629b34b55e1cd6938bf2b83c77134b961d",
        ],
    },
    Case {
        name: "cos_sin",
        first: 0,
        stride: 256,
        hashes: [
            "089346cd6d0f6979119b02c6c9e2d84ef777091262086c424b21e40d3833b72c",
            "59865c5da2a2e5199a258f053d4b21ca174d7d7d74e959475d08514994df66e5",
        ],
    },
    // Every float of [1, 4).
    Case {
        name: "sqrt",
        first: 0x3f80_0000,
        stride: 1,
        hashes: [
            "aab7e621a087f9ed96fb1d1a5169c0d287e1bdcc619a1e05052ae8d967fd164d",
            "5a0913f53df2c7f02c43c2f46b206987434526b97c973115afe95f646c48eedc",
        ],
    },
    Case {
        name: "negative_log",
        first: 1,
        stride: 256,
        hashes: [
            "142bb87e0a2ef9903ff30617dc91f811ebe41dc718401e31f709372923b2c969",
            "eebb96c19baad59233222667d52088f3fb7bf0dbb93cd0532f99d3e6e6a876cd",
        ],
    },
    // Every float of [1/2, 2).
    Case {
        name: "log",
        first: 0x3f00_0000,
        stride: 1,
        hashes: [
            "3f2a2f037a9c12173b2cdc1620fc808f41a86b0d76b51072afa97b1e96d7d8d1",
            "83ab0d0a36d1c222daba58fcab529da1fe43339c9323ae8de97ed76ce07e44ed",
        ],
    },
    // Every float of [-2, -1/2).
    Case {
        name: "exp",
        first: 0xbf00_0000,
        stride: 1,
        hashes: [
            "76c0c5b9819680eddc43d60105337613df2cb41f98f52011035e80f92cc6ebfa",
            "696aa9e8d2948d379b36ef98a072b2410ffe1536e7d03b0bae6b9f1d48ab4d67",
        ],
    },
    Case {
        name: "normal_quantile",
        first: 1,
        stride: 256,
        hashes: [
            "15fd71a8b98a27677b6c24d1cc5c97934f58eaef9cf1e64a07d5464d86f9e5a1",
            "6ee42a9995fd5d7129ae7361c52fad583cedfd473c0b278b1167e591dfeee936",
        ],
    },
];

impl Case {
    /// All 2^24 inputs, or each 16th.
    fn domain(&self, part: u32) -> Domain {
        Domain::Words {
            first: self.first,
            stride: self.stride * part,
            count: (1 << 24) / u64::from(part),
        }
    }
}

fn function(name: &str) -> &'static Function {
    let found = FUNCTIONS.iter().find(|function| function.name == name);
    found.unwrap_or_else(|| panic!("no function {name}"))
}

fn evaluator(device: &Arc<Device>, name: &str) -> Evaluator {
    let function = function(name);
    expected(Evaluator::new(device, function.kernel, function.id))
}

fn expected<T>(result: Result<T>) -> T {
    result.unwrap_or_else(|error| panic!("{error}"))
}

/// The row of a function, no word of which may differ, and within its bound.
fn row(evaluator: &Evaluator, name: &str, domain: Domain) -> Row {
    let watch = &mut |_, _| Ok(());
    let row = expected(compare_function(evaluator, function(name), domain, watch));
    println!("{:#}", row.json());
    assert_eq!(row.figures.mismatches, 0, "{name}: {}", row.witness);
    assert_eq!(row.figures.compared, domain.inputs(function(name).kind));
    assert!(
        row.worst <= row.bound,
        "{name}: {:?} at {}",
        row.worst,
        row.worst_at
    );
    row
}

/// The hash of a function's results, and the seconds that they took.
fn hashed(evaluator: &Evaluator, domain: Domain) -> (String, f64) {
    let Domain::Words {
        first,
        stride,
        count,
    } = domain
    else {
        panic!("words alone");
    };
    let begun = std::time::Instant::now();
    let mut hash = Sha256::new();
    for done in (0..count).step_by(CHUNK as usize) {
        let first = first.wrapping_add((done as u32).wrapping_mul(stride));
        let part = (count - done).min(CHUNK) as u32;
        let results = expected(evaluator.run_indexed(first, stride, part));
        hash.update(bytemuck::cast_slice::<_, u8>(&results));
    }
    (hexadecimal(&hash.finalize()), begun.elapsed().as_secs_f64())
}

/// Each 256th of 2^24 inputs is compared and judged. The hashes, those of the reference, are
/// the committed ones: of each 16th, and of all inputs where they take no longer than 10 s.
#[test]
fn words_and_hashes_are_the_same_everywhere() {
    support::on_each_device(|device| {
        let mut wrong = Vec::new();
        for case in &CASES {
            let evaluator = evaluator(device, case.name);
            let (few, seconds) = hashed(&evaluator, case.domain(16));
            if few != case.hashes[1] {
                row(&evaluator, case.name, case.domain(16));
                wrong.push(format!("{}, each 16th: {few}", case.name));
            }
            row(&evaluator, case.name, case.domain(256));
            if seconds * 16.0 > 10.0 {
                println!("{}: not all 2^24: too slow here", case.name);
                continue;
            }
            let (all, _) = hashed(&evaluator, case.domain(1));
            if all != case.hashes[0] {
                wrong.push(format!("{}, all: {all}", case.name));
            }
        }
        assert!(
            wrong.is_empty(),
            "hashes other than the committed: {wrong:?}"
        );
    });
}

/// A row of the command, of which the hash is published.
#[test]
fn a_row_has_the_published_hash() {
    support::on_each_device(|device| {
        let chosen: Vec<_> = expected(exhaustive::chosen(Some("multiply")))
            .into_iter()
            .filter(|subject| subject.name() == "multiply")
            .collect();
        let (mut heard, mut seen) = (0, 0);
        let rows = exhaustive::run(
            device,
            &chosen,
            None,
            &mut |name, done, total| {
                assert!(name == "multiply" && heard <= done && done <= total);
                heard = done;
                Ok(())
            },
            &mut |_| seen += 1,
        );
        let (rows, left_out) = expected(rows);
        assert_eq!((rows.len(), seen, left_out.len()), (1, 1, 0));
        let row = &rows[0];
        println!("{:#}", row.json());
        assert_eq!(row.verdict, Verdict::Passed);
        assert_eq!(row.hash, Hash::Equal);
        assert_eq!(heard, row.figures.compared);
        // A product is the nearest float everywhere.
        assert_eq!(row.worst, Some(0.5));
        assert_eq!(row.correct(), Some(1.0));
    });
}

/// One wrong bit in one of 2^20 results is a mismatch with its input, an error, and another
/// hash.
#[test]
fn one_wrong_result_is_found() {
    support::on_one_device(|device| {
        let stock = expected(kernel("evaluate"));
        let words = support::edited(stock, |source| {
            let (right, wrong) = (
                "floatBitsToUint(corput_sqrt(f(a.x)))",
                "floatBitsToUint(corput_sqrt(f(a.x))) ^ uint(a.x == 0x3fa00010u)",
            );
            assert!(source.contains(right));
            source.replace(right, wrong)
        });
        let case = &CASES[3];
        let broken = Evaluator::with_module(device, "evaluate", function("sqrt").id, &words);
        let broken = expected(broken);
        let watch = &mut |_, _| Ok(());
        let found = compare_function(&broken, function("sqrt"), case.domain(16), watch);
        let found = expected(found);
        assert_eq!(found.figures.mismatches, 1);
        assert!(found.witness.contains("3fa00010"), "{}", found.witness);
        assert!(found.worst_at.contains("3fa00010"), "{}", found.worst_at);
        assert!(found.worst > found.bound, "{:?}", found.worst);
        assert_eq!(found.figures.roundings, [(1 << 20) - 1, 1, 0]);
        assert_ne!(found.sha256, case.hashes[1]);
        assert_eq!(found.verdict, Verdict::Failed);
    });
}

/// So are inverses in another base; and who watches may stop.
#[test]
fn inverses_of_another_base_are_found() {
    support::on_one_device(|device| {
        let request = expected(exhaustive::inverses(3));
        let generator = expected(Generator::new(device, &request));
        let mut heard = 0;
        let stopped = compare_inverses(generator, 3, INDICES, &mut |done, total| {
            heard = done;
            match done {
                0..100_000 => Ok(()),
                _ => Err(corput::Error::Interrupted { done, total }),
            }
        });
        assert!(heard >= 100_000, "{heard}");
        assert!(matches!(stopped, Err(corput::Error::Interrupted { .. })));
        for base in exhaustive::BASES {
            let request = expected(exhaustive::inverses(base));
            let generator = || expected(Generator::new(device, &request));
            let watch = &mut |_, _| Ok(());
            let right = expected(compare_inverses(generator(), base, 1 << 20, watch));
            assert_eq!(right.verdict, Verdict::Passed, "{right:?}");
            assert_eq!(right.figures.roundings, [1 << 20, 0, 0]);
            // The points of one base are not those of another.
            let wrong = expected(compare_inverses(generator(), 7, 1 << 20, watch));
            assert_eq!(wrong.verdict, Verdict::Failed);
            assert!(wrong.figures.mismatches > 1 << 19, "{:?}", wrong.figures);
            assert_eq!(wrong.worst, Some(f64::INFINITY));
            assert_eq!(wrong.sha256, right.sha256);
        }
    });
}

/// The sum of equal terms, of fewer than the command has: and a kernel that leaves out the last of
/// each run.
#[test]
fn sums_of_equal_terms_are_judged() {
    support::on_one_device(|device| {
        let watch = &mut |_, _| Ok(());
        let terms = 1 << 22;
        let right = exhaustive::compare_terms(
            terms,
            &mut |group| Reducer::with_group(device, group),
            watch,
        );
        let right = expected(right);
        assert_eq!(right.verdict, Verdict::Passed, "{right:?}");
        assert_eq!((right.figures.compared, right.worst), (18, Some(0.0)));
        let stock = *expected(kernel("reduce"));
        let words = support::edited(&stock, |source| {
            let (right, wrong) = ("k < count;", "k < count - 1u;");
            assert!(source.contains(right), "{source}");
            source.replace(right, wrong)
        });
        let broken = exhaustive::compare_terms(
            terms,
            &mut |_| Reducer::with_module(device, stock, &words),
            watch,
        );
        let broken = expected(broken);
        assert_eq!(broken.verdict, Verdict::Failed);
        assert_eq!(broken.figures.mismatches, 18);
        assert!(broken.further().failure.is_some());
    });
}

/// A row that began ends, those after it are named, and nothing at all is no success.
#[test]
fn time_bounds_the_rows() {
    support::on_one_device(|device| {
        let chosen = expected(exhaustive::chosen(Some("multiply")));
        let ran = |time| exhaustive::run(device, &chosen, time, &mut |_, _, _| Ok(()), &mut |_| ());
        let none = ran(Some(std::time::Duration::ZERO));
        assert_eq!(none.map_err(|error| error.exit_code()).err(), Some(2));
        let (rows, left_out) = expected(ran(Some(std::time::Duration::from_millis(1))));
        assert_eq!((rows.len(), left_out.len()), (1, chosen.len() - 1));
        assert!(chosen.len() > 1);
    });
}

#[test]
fn only_whole_rows_are_published() {
    let hash = "ab".repeat(32);
    let row = |name: &str, verdict: &str, hash_is: &str, mismatches: u64| {
        json!({ "name": name, "inputs": "all", "compared": 7, "mismatches": mismatches,
            "verdict": verdict, "hash": hash_is, "sha256": hash, "seconds": 1.0 })
    };
    let mut beyond = row("beyond", "failed", "differs", 0);
    beyond["worst"] = json!(2.0);
    beyond["bound"] = json!(1.0);
    let mut unjudged = row("unjudged", "failed", "differs", 0);
    unjudged["worst"] = json!(0.0);
    unjudged["bound"] = json!(1.0);
    unjudged["judged"] = json!(0);
    let document = json!({ "rows": [
        beyond,
        unjudged,
        row("new", "passed", "not published", 0),
        row("changed", "failed", "differs", 0),
        row("wrong", "failed", "differs", 1),
        row("bound", "failed", "not published", 0),
        row("refused", "refused", "not published", 0),
    ] });
    let old = json!({ "rows": { "changed": { "sha256": "old" }, "kept": { "sha256": "kept" } } });
    let manifest = exhaustive::publish(&old, &document);
    let rows = manifest["rows"].as_object().expect("rows");
    let names: Vec<&String> = rows.keys().collect();
    assert_eq!(names, ["changed", "kept", "new"]);
    let entry = json!({ "inputs": "all", "compared": 7, "sha256": hash });
    assert_eq!((&rows["new"], &rows["changed"]), (&entry, &entry));
    // What is published names rows that there are, with their inputs.
    let committed = std::fs::read_to_string(MANIFEST).expect("it is there");
    let committed: Value = serde_json::from_str(&committed).expect("it is JSON");
    assert_eq!(committed["schema"], exhaustive::SCHEMA);
    let known: Vec<Row> = exhaustive::subjects().map(|one| Row::new(&one)).collect();
    for (name, entry) in committed["rows"].as_object().expect("rows") {
        let row = known.iter().find(|row| row.name == *name);
        let row = row.unwrap_or_else(|| panic!("no row {name}"));
        assert_eq!(entry["inputs"], row.inputs, "{name}");
        let found = exhaustive::published(name, &row.inputs);
        assert_eq!(found.as_deref(), entry["sha256"].as_str(), "{name}");
        assert_eq!(exhaustive::published(name, "others"), None);
    }
    let all = |row: &Row| exhaustive::published(&row.name, &row.inputs).is_some();
    let unpublished: Vec<&str> = known
        .iter()
        .filter(|row| !all(row))
        .map(|row| row.name.as_str())
        .collect();
    assert!(unpublished.is_empty(), "{unpublished:?}");
}

const MANIFEST: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/exhaustive.json");

/// `CORPUT_WRITE_TABLES=a.json:b.json cargo test --all-features --test gpu_exhaustive -- --ignored
/// publish` takes the rows of documents of `corput check --exhaustive --json` into
/// `docs/exhaustive.json`.
#[test]
#[ignore = "writes"]
fn publish() {
    let Some(documents) = std::env::var_os("CORPUT_WRITE_TABLES") else {
        return;
    };
    let read = |path: &std::path::Path| -> Value {
        let text = std::fs::read_to_string(path).expect("it is there");
        serde_json::from_str(&text).expect("it is JSON")
    };
    let merged = std::env::split_paths(&documents).fold(read(MANIFEST.as_ref()), |all, path| {
        exhaustive::publish(&all, &read(&path))
    });
    std::fs::write(MANIFEST, format!("{merged:#}\n")).expect("it is written");
}

/// All 2^32 inputs on one device: minutes each on lavapipe with two cores, most of them the
/// reference's.
fn every_word(name: &str) {
    support::on_one_device(|device| {
        let row = row(&evaluator(device, name), name, Domain::EVERY_WORD);
        assert_eq!(row.verdict, Verdict::Passed);
    });
}

#[test]
#[ignore = "minutes"]
fn every_word_as_a_unit_float() {
    every_word("unit");
}

#[test]
#[ignore = "minutes"]
fn every_angle() {
    every_word("cos_sin");
}

#[test]
#[ignore = "minutes"]
fn every_root() {
    every_word("sqrt");
}

#[test]
#[ignore = "minutes"]
fn every_log_of_a_fraction() {
    every_word("negative_log");
}

#[test]
#[ignore = "minutes"]
fn every_log_of_a_float() {
    every_word("log");
}

#[test]
#[ignore = "minutes"]
fn every_exponential() {
    every_word("exp");
}

#[test]
#[ignore = "minutes"]
fn every_normal_quantile() {
    every_word("normal_quantile");
}

/// As [`every_word`]: the odometer in base 3, and a table's division in base 8161.
fn every_index(base: u32) {
    support::on_one_device(|device| {
        let request = expected(exhaustive::inverses(base));
        let generator = expected(Generator::new(device, &request));
        let row = expected(compare_inverses(generator, base, INDICES, &mut |_, _| {
            Ok(())
        }));
        println!("{:#}", row.json());
        assert_eq!(row.verdict, Verdict::Passed);
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
