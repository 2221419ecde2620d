//! Kernels of scenes: their samples are those of the reference, word for word, on every
//! driver.

#[path = "program/corpus.rs"]
mod corpus;
mod support;

use corpus::{Case, bare, every_map, files, samplers};
use corput::bench::scene::verify;
use corput::bulk::SceneReference;
use corput::catalog::{Engine, Output, Profile, Request};
use corput::interface::{Column, task};
use corput::kernels::{Generator, Mapper};
use corput::scene::{Choice, Domain, Draw, Record, Span};
use corput::strip::program::{Form, Options, Parameters, Program, Sampler, program};
use corput::vulkan::Device;
use std::sync::Arc;
use std::time::Instant;
use support::{at_once, on_each_device, on_one_device, skips};

/// Samples at either end of the indices; no whole number of runs.
const COUNT: u32 = 777;

fn made(case: &Case, options: Options) -> (Program, Vec<u32>) {
    let program = program(&case.name, &case.needs, options)
        .unwrap_or_else(|error| panic!("{}: {error}", case.name));
    let flat = program
        .flat(false)
        .unwrap_or_else(|error| panic!("{}: {error}\n{}", case.name, program.source));
    let words = program
        .spirv(&flat.text)
        .unwrap_or_else(|error| panic!("{}: {error}\n{}", case.name, flat.text));
    (program, words)
}

/// The first sample that differs: its index, word, and both values.
fn difference(device: &Arc<Device>, case: &Case, options: Options) -> Option<String> {
    let begin = Instant::now();
    let (program, words) = made(case, options);
    let sampler = Sampler::new(device, &program, &words).unwrap();
    let reference = SceneReference::new(&case.needs).unwrap();
    let samples = case.needs.request.count;
    let count = COUNT.min(u32::try_from(samples).unwrap_or(COUNT));
    let last = (samples - u64::from(count)) as u32;
    let over = last % program.aligned;
    for (first, count) in [(0, count), (last - over, count + over)] {
        let got = sampler.run(first, count).unwrap();
        let mut want = vec![0; got.len()];
        reference.fill(first, &mut want);
        let stride = program.record.words as usize;
        let differ = got.iter().zip(&want).position(|(got, want)| got != want);
        if let Some(at) = differ {
            let (n, word) = (first as usize + at / stride, at % stride);
            return Some(format!(
                "{}: word {word} of sample {n} is {:#x}, not {:#x}",
                case.name, got[at], want[at]
            ));
        }
    }
    println!("{}: {:.2} s", case.name, begin.elapsed().as_secs_f64());
    None
}

/// The points of a domain, as a request of the stock kernels: floats for numbers in [0, 1),
/// fractions for all that is drawn by them.
fn points(case: &Case, domain: &Domain, first: u32, count: u32) -> Request {
    let mut request = case.needs.request.clone();
    let range = domain.range();
    request.columns = request.columns[range.start as usize..range.end as usize].to_vec();
    request.first += u64::from(first);
    request.count = u64::from(count);
    request.output = match domain.draw {
        Draw::Between([0.0, 1.0]) => Output::Floats,
        _ => Output::Fractions,
    };
    request
}

/// The records that stock kernels make: each domain's points by that one, and its map's kernel.
/// Numbers and choices, which have none, are the twins' of these points.
fn stock(
    device: &Arc<Device>,
    case: &Case,
    [first, count]: [u32; 2],
    generator: impl Fn(&Request) -> Generator,
) -> Vec<u32> {
    let record = Record::of(&case.needs);
    let stride = record.words as usize;
    let mut words = vec![0; stride * count as usize];
    for (domain, field) in case.needs.domains.iter().zip(&record.fields) {
        let request = points(case, domain, first, count);
        let mut rows = Vec::new();
        let mut take = |words: &[u32]| {
            rows.extend_from_slice(words);
            Ok(())
        };
        generator(&request)
            .make(0, count.into(), &mut take)
            .unwrap();
        let made: Vec<u32> = match &domain.draw {
            Draw::Between(ends) => match Span::new(*ends).unwrap() {
                Some(span) => rows.iter().map(|u| span.at(*u).to_bits()).collect(),
                None => rows,
            },
            Draw::Choice(weights) => {
                let choice = Choice::new(weights).unwrap();
                let words =
                    |share: corput::scene::Share| [share.index, share.probability.to_bits()];
                rows.iter().flat_map(|u| words(choice.draw(*u))).collect()
            }
            Draw::Map(mapping) => {
                let profile = request.profile;
                let mapper = Mapper::new(device, mapping, true, profile, task::SAMPLE).unwrap();
                mapper.run(&rows).unwrap().0
            }
        };
        let values = made.chunks_exact(field.values.len());
        for (record, values) in words.chunks_exact_mut(stride).zip(values) {
            record[field.range()].copy_from_slice(values);
        }
    }
    words
}

fn is_of_a_set(column: &Column) -> bool {
    matches!(
        column,
        Column::Grid(_)
            | Column::Korobov { .. }
            | Column::Stratified { .. }
            | Column::LatinHypercube { .. }
            | Column::MultiJittered { .. }
    )
}

/// The points of each domain by kernels that an engine strips by constants alone, at a length
/// for which these are others than the general kernels.
fn constants_do_the_same(device: &Arc<Device>, case: &Case) {
    for domain in &case.needs.domains {
        let mut request = points(case, domain, 0, 1 << 16);
        // A set has no more points than it has.
        if request.columns.iter().any(is_of_a_set) {
            request.count = request.count.min(case.needs.request.count);
        }
        let made = |mut generator: Generator| {
            let mut words = Vec::new();
            let mut take = |some: &[u32]| {
                words.extend_from_slice(some);
                Ok(())
            };
            generator.make(0, request.count, &mut take).unwrap();
            words
        };
        let general = Generator::general(device, &request).unwrap();
        let constant = Generator::new(device, &request).unwrap();
        if request.count == 1 << 16 {
            assert_ne!(general.kernel_name(), constant.kernel_name());
        }
        let (general, constant) = (made(general), made(constant));
        assert!(
            general == constant,
            "{}: other bytes by constants",
            case.name
        );
    }
}

/// That a scene's own kernel makes the bytes of the stock kernels, of those that choose all at
/// run time and of those whose constants an engine sets, which strips them.
fn equals_stock(device: &Arc<Device>, case: &Case) {
    let (program, words) = made(case, LONG);
    let sampler = Sampler::new(device, &program, &words).unwrap();
    let samples = case.needs.request.count;
    // So many that bare points take a kernel of baked tiles.
    let count = (1 << 16).min(samples) as u32;
    let count = if case
        .needs
        .domains
        .iter()
        .any(|one| one.draw.mapping().is_some())
    {
        COUNT.min(count)
    } else {
        count
    };
    let first = (samples - u64::from(count)) as u32 / 2;
    let got = sampler.run(first, count).unwrap();
    let general = |request: &Request| Generator::general(device, request).unwrap();
    let want = stock(device, case, [first, count], general);
    assert!(
        got == want,
        "{}: other bytes than the general kernels",
        case.name
    );
    constants_do_the_same(device, case);
}

/// SwiftShader takes minutes to compile modules of more bytes than this: the time grows faster
/// than they do.
const LARGE: usize = 75_000;

/// The domains of a case one by one, each with the text that it has in the whole, where a driver
/// cannot be asked to compile that.
fn parts(device: &Arc<Device>, case: &Case) -> Vec<Case> {
    let whole = || Case {
        name: case.name.clone(),
        needs: case.needs.clone(),
    };
    let (_, words) = made(case, LONG);
    if 4 * words.len() <= LARGE || !device.info().name.contains("SwiftShader") {
        return vec![whole()];
    }
    let parts = case.needs.domains.iter().map(|domain| {
        let mut part = whole();
        part.name += &format!(", {}", domain.key);
        part.needs.domains = vec![domain.clone()];
        part
    });
    parts.collect()
}

fn all_equal(cases: &[Case], options: &[Options]) {
    on_each_device(|device| {
        let cases: Vec<Case> = cases.iter().flat_map(|case| parts(device, case)).collect();
        at_once(&cases, |case| {
            for options in options {
                let found = difference(device, case, *options);
                assert_eq!(found, None, "{options:?}");
            }
        });
    });
}

const LONG: Options = Options {
    parameters: Parameters::Push,
    cpu: true,
    int64: false,
};
const UNIFORM: Options = Options {
    parameters: Parameters::Uniform,
    cpu: false,
    int64: false,
};
const EIGHT: Options = Options {
    parameters: Parameters::Push,
    cpu: true,
    int64: true,
};

#[test]
fn every_sampler_is_that_of_the_reference() {
    if skips() {
        return;
    }
    let cases = samplers();
    assert!(cases.len() > 60, "{}", cases.len());
    all_equal(&cases, &[LONG, UNIFORM]);
}

#[test]
fn stores_of_eight_words_are_those_of_the_reference() {
    if skips() {
        return;
    }
    let mut cases = bare();
    cases.retain(|case| made(case, EIGHT).0.form == Form::Eight);
    for (name, count) in [
        ("sobol", 60),
        ("halton:none", 10),
        ("hammersley", 4),
        ("random", 15),
    ] {
        let of = cases.iter().filter(|case| case.name.contains(name)).count();
        assert!(of >= count, "{name}: {of}");
    }
    on_each_device(|device| {
        if !device.has_int64() {
            let refused = Sampler::new(device, &made(&cases[0], EIGHT).0, &[]);
            let refused = refused.err().unwrap().to_string();
            assert!(refused.contains("strip it without --int64"), "{refused}");
            return;
        }
        at_once(&cases, |case| {
            for parameters in [Parameters::Push, Parameters::Uniform] {
                let options = Options {
                    parameters,
                    ..EIGHT
                };
                assert_eq!(difference(device, case, options), None, "{parameters:?}");
            }
            let (program, words) = made(case, EIGHT);
            let general = |request: &Request| Generator::general(device, request).unwrap();
            let count = u64::from(COUNT).min(case.needs.request.count) as u32;
            let want = stock(device, case, [0, count], general);
            let sampler = Sampler::new(device, &program, &words).unwrap();
            assert!(
                sampler.run(0, count).unwrap() == want,
                "{}: other bytes than the general kernel",
                case.name
            );
            if program.aligned > 1 {
                let sampler = Sampler::new(device, &program, &words).unwrap();
                let refused = sampler.run(1, 1).unwrap_err().to_string();
                assert!(refused.contains("begin at 0"), "{refused}");
            }
        });
    });
}

#[test]
fn every_map_is_that_of_the_reference() {
    if skips() {
        return;
    }
    all_equal(&every_map(Profile::Exact), &[LONG]);
}

/// In the native profile numbers and choices are exact, and coordinates near the exact ones.
#[test]
fn native_kernels_are_near_the_reference() {
    on_each_device(|device| {
        at_once(&every_map(Profile::Native), |case| {
            let (program, words) = made(case, LONG);
            let found = verify(device, &case.needs, &program, &words);
            assert!(found.is_ok(), "{}: {found:?}", case.name);
        });
    });
    // SwiftShader takes minutes to compile a module of everything.
    on_one_device(|device| {
        let cases = files();
        let native = cases.iter().find(|case| case.name == "everything").unwrap();
        let (program, words) = made(native, LONG);
        verify(device, &native.needs, &program, &words).unwrap();
        // Another seed's kernel is found.
        let mut other = native.needs.clone();
        other.request.columns = corput::scene::Needs::of_points(
            &corput::scene::Scene::new("other").unwrap(),
            native.needs.dimensions(),
            None,
        )
        .unwrap()
        .request
        .columns;
        assert!(verify(device, &other, &program, &words).is_err());
    });
}

#[test]
fn the_scenes_are_those_of_the_reference() {
    if skips() {
        return;
    }
    let exact: Vec<Case> = files()
        .into_iter()
        .filter(|case| case.needs.request.profile == Profile::Exact)
        .collect();
    assert!(exact.len() >= 8);
    all_equal(&exact, &[LONG]);
}

#[test]
fn scenes_and_samplers_are_those_of_the_stock_kernels() {
    if skips() {
        return;
    }
    let exact = |case: &Case| case.needs.request.profile == Profile::Exact;
    let few = |case: &Case| case.needs.dimensions() <= 3;
    let mut cases: Vec<Case> = files().into_iter().filter(exact).collect();
    cases.extend(samplers().into_iter().filter(few));
    assert!(cases.len() >= 60, "{}", cases.len());
    on_each_device(|device| {
        device.keep_pipelines();
        let cases: Vec<Case> = cases.iter().flat_map(|case| parts(device, case)).collect();
        at_once(&cases, |case| equals_stock(device, case));
    });
}

/// The same of stores of eight words: a wrong place, direction, turn, order or store.
#[test]
fn broken_stores_of_eight_words_are_found() {
    on_one_device(|device| {
        if !device.has_int64() {
            println!("SKIPPED: no integers of 64 bits");
            return;
        }
        let cases = bare();
        for (name, from, to) in [
            (
                "sobol:none, 2 dimensions",
                "x1 ^ 0xc0000000u",
                "x1 ^ 0x40000000u",
            ),
            (
                "sobol:none, 2 dimensions",
                "x0 ^ 0x40000000u",
                "x1 ^ 0x40000000u",
            ),
            (
                "sobol:none, 2 dimensions",
                "bitfieldReverse(k)",
                "bitfieldReverse(k >> 1)",
            ),
            ("sobol:none, 3 dimensions", "net2_turn(k)", "net2_turn(n)"),
            ("sobol:none, 3 dimensions", "at += 3u", "at += 2u"),
            ("sobol:none, 2 dimensions", "i * 4u", "i * 3u"),
            ("halton:none, 2 dimensions", "c.n += 1u", "c.n += 2u"),
            (
                "halton:none, 2 dimensions",
                "draw_x1(x1_2)",
                "draw_x1(x1_1)",
            ),
            ("random, 1 dimensions", "samples[at + 0u]", "samples[at]"),
        ] {
            let case = cases.iter().find(|case| case.name == name).unwrap();
            let (program, _) = made(case, EIGHT);
            let text = program.flat(false).unwrap().text;
            assert!(text.contains(from), "{name} has no {from}:\n{text}");
            let words = program.spirv(&text.replacen(from, to, 1)).unwrap();
            let sampler = Sampler::new(device, &program, &words).unwrap();
            let got = sampler.run(0, 480).unwrap();
            let mut want = vec![0; got.len()];
            SceneReference::new(&case.needs).unwrap().fill(0, &mut want);
            // The last means the same.
            assert_eq!(got == want, to == "samples[at]", "{name}: {from} -> {to}");
        }
    });
}

/// A defect anywhere is found: another direction number, digit, weight, parameter or store.
#[test]
fn broken_kernels_are_found() {
    on_one_device(|device| {
        let cases = files();
        let case = |name: &str| cases.iter().find(|case| case.name == name).unwrap();
        for (scene, from, to) in [
            (
                "diffuse_quad",
                "corput_sobol_pair(c.n).y",
                "corput_sobol_pair(c.n).x",
            ),
            ("diffuse_quad", "c.n += 1u", "c.n += 2u"),
            ("diffuse_quad", "push.first + begin", "push.first"),
            ("many_lights", "return uvec2(2u,", "return uvec2(3u,"),
            (
                "motion_blur",
                "CorputReal part = corput_real_multiply(width,",
                "CorputReal part = corput_real_multiply(low,",
            ),
        ] {
            let case = case(scene);
            let (program, _) = made(case, LONG);
            let text = program.flat(false).unwrap().text;
            let (head, main) = text.split_at(text.rfind("// The shader itself.").unwrap());
            let at = main
                .find(from)
                .unwrap_or_else(|| panic!("{scene} has no {from}"));
            let main = format!("{}{to}{}", &main[..at], &main[at + from.len()..]);
            let words = program.spirv(&format!("{head}{main}")).unwrap();
            let sampler = Sampler::new(device, &program, &words).unwrap();
            let reference = SceneReference::new(&case.needs).unwrap();
            let got = sampler.run(0, 256).unwrap();
            let mut want = vec![0; got.len()];
            reference.fill(0, &mut want);
            assert_ne!(got, want, "{scene}: {from} -> {to} is not found");
        }
    });
}
