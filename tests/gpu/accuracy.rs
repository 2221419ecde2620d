//! Errors and speeds of single functions: the measure sees what is wrong.

mod support;

use corput::accuracy::{
    About, COLUMNS, Comparison, SCHEMA, Subject, chart, compare, csv, json, judge, names, page,
    repeated, subjects,
};
use corput::catalog::{Profile, maps};
use corput::interface::REPEATS;
use corput::kernels::{kernel, spirv};
use corput::{compile, headers};
use std::path::Path;

fn subject(name: &str) -> Subject {
    let mut found = subjects(&[name.to_owned()]).unwrap();
    assert_eq!(found.len(), 1, "{name}");
    found.remove(0)
}

fn about() -> About {
    About {
        device: "a <device> & more".to_owned(),
        driver: "none".to_owned(),
        device_uuid: String::new(),
        command: "corput accuracy".to_owned(),
    }
}

/// A stock module with a text of one of its files replaced.
fn edited(name: &str, file: &str, from: &str, to: &str) -> corput::Result<Vec<u32>> {
    let row = kernel(name)?;
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("shaders/kernels");
    let mut times = 0;
    let mut read = |name: &str| {
        let header = headers().iter().find(|(header, _)| *header == name);
        let text = match header {
            Some((_, text)) => (*text).to_owned(),
            None if name == "interface.glsl" => row.glsl(),
            None => std::fs::read_to_string(folder.join(name)).ok()?,
        };
        if name != file {
            return Some(text);
        }
        times += text.matches(from).count();
        Some(text.replace(from, to))
    };
    let source = read(row.source).unwrap();
    let words = compile::to_spirv(&source, row.defines, &mut read).unwrap();
    assert_eq!(times, 1, "occurrences of {from}");
    Ok(compile::check(&words, row.profile).unwrap())
}

/// Exact results of a subject on arguments of the loop, as the CPU has them.
fn reference(subject: &Subject, arguments: &[[u32; 3]]) -> Vec<Vec<u32>> {
    let width = subject.width() + usize::from(subject.has_pdf());
    let results = arguments.iter().map(|&u| subject.reference(u));
    results.map(|words| words[..width].to_vec()).collect()
}

#[test]
fn every_map_and_function_is_asked_for_by_its_name() {
    let all = subjects(&[]).unwrap();
    assert!(all.iter().map(Subject::name).eq(names()));
    for map in maps() {
        assert_eq!(
            subject(map.name).kernel(Profile::Exact),
            map.group.kernel(Profile::Exact)
        );
    }
    let two = subjects(&["cone".to_owned(), "sqrt".to_owned()]).unwrap();
    assert!(two.iter().map(Subject::name).eq(["sqrt", "cone"]));
    let error = subjects(&["sqr".to_owned()]).unwrap_err().to_string();
    assert!(error.contains("did you mean `sqrt`?"), "{error}");
    assert!(error.contains("accuracy --list"), "{error}");
}

#[test]
fn the_reference_is_within_its_bounds_and_worse_results_are_seen() {
    let arguments: Vec<[u32; 3]> = (0..16).flat_map(repeated).collect();
    assert_eq!(arguments.len(), 16 * REPEATS as usize);
    for one in subjects(&[]).unwrap() {
        let name = one.name();
        let good = reference(&one, &arguments);
        let judged = judge(&one, &arguments, &good, 0);
        assert!(judged.results > 0, "{name}");
        // The catalogue's bounds are 1.6 ULP at most, and the mean of a rounding is 1/4.
        assert!(judged.errors.worst_ulp <= 1.6, "{name}: {judged:?}");
        assert!(judged.errors.mean_ulp <= 0.6, "{name}: {judged:?}");
        assert!(
            judged.errors.worst_ulp <= judged.worst_relative_ulp,
            "{name}"
        );
        assert!(
            judged.pdf.is_none_or(|pdf| pdf.worst_ulp <= 1.6),
            "{name}: {judged:?}"
        );

        // A lowest byte that is not the function's, in one result.
        let spoilt = |word: fn(u32) -> u32| {
            let mut bad = good.clone();
            let first = arguments
                .iter()
                .position(|&u| one.truth(u).is_some())
                .unwrap();
            bad[first][0] = word(bad[first][0]);
            judge(&one, &arguments, &bad, 0)
        };
        let off = spoilt(|word| word.wrapping_add(0x4000));
        assert!(off.errors.worst_ulp > 10.0, "{name}: {off:?}");
        assert!(off.errors.mean_ulp > judged.errors.mean_ulp, "{name}");
        if name != "atan2" {
            let none = spoilt(|_| f32::NAN.to_bits());
            assert_eq!(none.errors.worst_ulp, f64::INFINITY, "{name}");
            assert_eq!(none.errors.mean_ulp, f64::INFINITY, "{name}");
        }
    }
}

#[test]
fn critical_arguments_count_for_the_worst_error_alone() {
    let one = subject("sqrt");
    let arguments: Vec<[u32; 3]> = (0..2).flat_map(repeated).collect();
    let mut results = reference(&one, &arguments);
    let clean = judge(&one, &arguments, &results, 1);
    results[0][0] += 1000;
    let spoilt = judge(&one, &arguments, &results, 1);
    assert_eq!(clean.errors.mean_ulp, spoilt.errors.mean_ulp);
    assert!(spoilt.errors.worst_ulp > 999.0);
}

fn measured(device: &std::sync::Arc<corput::vulkan::Device>, name: &str) -> Comparison {
    compare(device, &subject(name), &spirv).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn a_broken_shader_differs_has_larger_errors_and_is_not_timed() {
    support::on_one_device(|device| {
        let good = measured(device, "sqrt");
        assert_eq!(good.mismatches, 0);
        assert!(good.exact.judged.errors.worst_ulp <= 0.5, "{good:?}");
        let one = subject("sqrt");
        let broken = |file: &'static str, from: &'static str, to: &'static str| {
            compare(device, &one, &|name| match name {
                "function" => edited(name, file, from, to),
                _ => spirv(name),
            })
            .unwrap_or_else(|error| panic!("{error}"))
        };
        let off = broken(
            "function.comp",
            "EXACT_OR(corput_sqrt(p), ",
            "EXACT_OR(corput_sqrt(positive(a.x + 16u)), ",
        );
        assert!(off.mismatches > off.compared / 2, "{off:?}");
        assert!(off.exact.judged.errors.worst_ulp > 4.0, "{off:?}");
        assert_eq!(off.exact.speed, None);
        assert_eq!((off.price(), off.loop_share()), (None, None));
        assert_eq!(off.native.judged, good.native.judged);
        // The loop that is timed is verified, too: here it alone is wrong.
        let looped = broken("repeat.glsl", "0x9e3779b9u", "0x9e3779bbu");
        assert_eq!(looped.exact.judged, good.exact.judged);
        assert_eq!(looped.mismatches, 1024, "{looped:?}");
        assert_eq!(looped.exact.speed, None);
    });
}

#[test]
fn documents_agree_with_each_other() {
    support::on_one_device(|device| {
        let all = [measured(device, "sqrt"), measured(device, "cone")];
        for one in &all {
            let [exact, native, bare] = [one.exact.speed, one.native.speed, one.bare]
                .map(|speed| speed.expect("a speed").results_per_s());
            assert!(exact > 0.0 && native > 0.0 && bare > 0.0);
            assert_eq!(one.price(), Some(native / exact));
        }
        let document = json(&about(), &all);
        assert_eq!(document["schema"], SCHEMA);
        let text = csv(&all);
        let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
        assert_eq!(lines.next().unwrap(), COLUMNS);
        let mut rows = 0;
        for row in lines {
            assert_eq!(row.len(), COLUMNS.len(), "{row:?}");
            let functions = document["functions"].as_array().unwrap();
            let function = functions.iter().find(|one| one["name"] == row[0]).unwrap();
            for (column, cell) in COLUMNS.iter().zip(&row).skip(2) {
                let place = match *column {
                    "exact_takes" => &function[*column],
                    _ => &function[row[1]][*column],
                };
                match place.as_f64() {
                    Some(value) => assert_eq!(cell.parse(), Ok(value), "{column}: {row:?}"),
                    None => assert_eq!(*cell, place.as_str().unwrap_or(""), "{column}: {row:?}"),
                }
            }
            rows += 1;
        }
        assert_eq!(rows, 2 * all.len());

        let svg = chart("device", &all).unwrap();
        let page = page(&about(), &all, &svg);
        for words in [
            "a &lt;device&gt; &amp; more",
            ">sqrt<",
            ">cone<",
            "prefers-color-scheme",
            &svg,
        ] {
            assert!(page.contains(words), "no {words}");
        }
        for words in ["<script", "<link", "src=", "@import", "url("] {
            assert!(!page.contains(words), "{words}");
        }
        // The namespace of SVG is the only address, and is not fetched.
        assert_eq!(page.matches("http").count(), 1);
    });
}
