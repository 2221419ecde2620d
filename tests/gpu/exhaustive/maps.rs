//! Maps: every one has a row, whose inputs are those of its parameter sets; a broken kernel is
//! seen; hashes of critical inputs are committed here, those of whole rows in
//! `docs/exhaustive.json`.

use crate::{expected, support};
use corput::catalog::{Map, Profile, maps};
use corput::check::Verdict;
use corput::exhaustive::{self, Fractions, Hash, Row, Subject, compare_map, mapper};
use corput::interface::task;
use corput::kernels::{Mapper, kernel};
use std::collections::BTreeSet;

/// Maps of one, two and three fractions, some with edges of their own, and SHA-256 of the
/// results of their critical inputs, which the suite has time for.
const CASES: [(&str, &str); 6] = [
    (
        "concentric-disk",
        "773903fb69869676acb65709829b93630e322253a28eee2ccddc2058b45201c9",
    ),
    (
        "cosine-hemisphere",
        "6a460397ce153b3f8a0c3fbe83677e49a5099aca32465ba77da542c5da6af13f",
    ),
    (
        "annulus",
        "36b44b408c4fb8199f66b115d2649bb8dff9c18fa50ac3202f61cfc1941ee2db",
    ),
    (
        "regular-polygon",
        "643eede31a22f1cb94c92a14415779b2e20d719953d2f021d6f5ebd49ee73e2e",
    ),
    (
        "gaussian",
        "50e454e758a2deded730f88c326f6ea9210b63221662fc1796f7f6d090d727f9",
    ),
    (
        "environment-alias",
        "f94c4032c84d5a798eece6219ae24ad0f252c195673999f334a48904a11842b6",
    ),
];

fn map(name: &str) -> &'static Map {
    expected(Map::from_name(name))
}

/// The row of critical inputs alone, which has no published hash.
fn critical(mapper: &mut Mapper, fractions: &Fractions) -> Row {
    let row = expected(compare_map(mapper, fractions, &mut |_, _| Ok(())));
    println!("{:#}", row.json());
    assert_eq!(row.figures.compared, fractions.count());
    assert_eq!(row.hash, Hash::Unpublished);
    row
}

#[test]
fn every_map_has_a_row_of_its_name() {
    let rows: Vec<Subject> = exhaustive::subjects().collect();
    let names: BTreeSet<String> = rows.iter().map(Subject::name).collect();
    assert_eq!(names.len(), rows.len(), "two rows of one name");
    for map in maps() {
        let chosen = expected(exhaustive::chosen(Some(map.name)));
        let found = chosen.iter().find(|one| one.name() == map.name);
        let found = found.unwrap_or_else(|| panic!("no row of {}", map.name));
        assert!(matches!(found, Subject::Map(one) if *one == map));
        let row = Row::new(found);
        assert_eq!(row.kernel, map.group.kernel(Profile::Exact));
        assert_eq!((row.bound, row.unit), (Some(1.0), "of bound"));
        assert!(row.inputs.contains("2^24 random"), "{}", row.inputs);
        let words = row.inputs.contains("2^32");
        assert_eq!(words, map.dimensions == 1, "{}", row.inputs);
        // A kernel's rows are chosen by its name.
        let of_kernel = expected(exhaustive::chosen(Some(&row.kernel)));
        assert!(of_kernel.iter().any(|one| one.name() == map.name));
    }
}

/// All of them are judged, but where no judge knows.
#[test]
fn critical_inputs_give_the_committed_words() {
    support::on_each_device(|device| {
        device.keep_pipelines();
        let mut wrong = Vec::new();
        for (name, hash) in CASES {
            let fractions = expected(Fractions::critical(map(name)));
            let mut mapper = expected(mapper(device, &fractions));
            let row = critical(&mut mapper, &fractions);
            assert_eq!(row.verdict, Verdict::Passed, "{row:?}");
            assert_eq!(row.figures.judged, row.figures.compared);
            let width = u64::from(map(name).coordinates) + 1;
            let rounded: u64 = row.figures.roundings.iter().sum();
            assert_eq!(rounded, row.figures.judged * width);
            assert!(row.worst.is_some_and(|worst| worst > 0.0 && worst <= 1.0));
            assert!(row.worst_at.contains(" ULP, at most "), "{}", row.worst_at);
            if row.sha256 != hash {
                wrong.push(format!("{name}: {}", row.sha256));
            }
        }
        assert!(
            wrong.is_empty(),
            "hashes other than the committed: {wrong:#?}"
        );
    });
}

/// A row of the command, of which the hash is published: other random inputs, or in another
/// order, have another.
#[test]
fn a_map_has_the_published_hash() {
    support::on_each_device(|device| {
        let one = [Subject::Map(map("concentric-disk"))];
        let rows = exhaustive::run(device, &one, None, &mut |_, _, _| Ok(()), &mut |_| ());
        let row = &expected(rows).0[0];
        println!("{:#}", row.json());
        assert_eq!(row.verdict, Verdict::Passed);
        assert_eq!(row.hash, Hash::Equal);
        assert_eq!(row.figures.compared, 40_000 + (1 << 24));
        assert_eq!(row.figures.judged, 40_000 + (1 << 16));
    });
}

/// One wrong bit of one of 40,000 pairs is a mismatch with its input, an error beyond the bound,
/// and another hash.
#[test]
fn one_wrong_sample_is_found() {
    support::on_one_device(|device| {
        let words = support::edited(expected(kernel("map_hemisphere")), |source| {
            let main = "#include \"map_main.glsl\"";
            assert!(source.contains(main));
            let broken = "
                uvec4 broken_sample(uvec3 u) {
                    return map_sample(u) ^ 4u * uint(u.xy == uvec2(0x55555555u, 0x80000001u));
                }
                #define map_sample broken_sample\n";
            source.replace(main, &format!("{broken}{main}"))
        });
        let fractions = expected(Fractions::critical(map("concentric-disk")));
        let mapping = fractions.mappings().next().expect("one");
        let broken =
            Mapper::with_module(device, mapping, true, Profile::Exact, task::SAMPLE, &words);
        let row = critical(&mut expected(broken), &fractions);
        assert_eq!(row.figures.mismatches, 1);
        assert!(
            row.witness.contains("55555555, 80000001"),
            "{}",
            row.witness
        );
        assert!(
            row.worst_at.contains("55555555, 80000001"),
            "{}",
            row.worst_at
        );
        assert!(row.worst > row.bound, "{:?}", row.worst);
        assert_eq!(row.verdict, Verdict::Failed);
        assert_ne!(row.sha256, CASES[0].1);
    });
}

/// The critical inputs of every map.
#[test]
#[ignore = "minutes"]
fn critical_inputs_of_every_map() {
    support::on_one_device(|device| {
        for map in maps() {
            let fractions = expected(Fractions::critical(map));
            let row = critical(&mut expected(mapper(device, &fractions)), &fractions);
            assert_eq!(row.verdict, Verdict::Passed, "{row:?}");
        }
    });
}
