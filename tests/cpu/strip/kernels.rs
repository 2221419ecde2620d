//! Every stock kernel, flattened: the same program.

use super::canonical::{called, canonical};
use super::source::read;
use corput::compile;
use corput::interface::{KERNELS, Kernel};
use corput::strip::{Flat, flatten};
use std::collections::BTreeSet;
use std::time::Instant;

fn lookup(kernel: &'static Kernel) -> impl FnMut(&str) -> Option<String> {
    let interface = kernel.glsl();
    move |name| match name {
        "interface.glsl" => Some(interface.clone()),
        name if name.starts_with("corput/") => {
            let found = corput::headers().iter().find(|(known, _)| *known == name);
            found.map(|(_, text)| (*text).to_owned())
        }
        name => Some(read(&format!("shaders/kernels/{name}"))),
    }
}

fn flat(kernel: &'static Kernel) -> Flat {
    flat_with(kernel, &[])
}

/// A kernel flattened, with more macros.
pub fn flat_with(kernel: &'static Kernel, more: &[(&'static str, Option<&'static str>)]) -> Flat {
    let source = read(&format!("shaders/kernels/{}", kernel.source));
    let own = kernel.defines.iter().map(|d| (d.0, Some(d.1)));
    let defines: Vec<_> = own.chain(more.iter().copied()).collect();
    flatten(&source, &defines, &mut lookup(kernel))
        .unwrap_or_else(|error| panic!("{}: {error}", kernel.name))
}

fn try_compiled(kernel: &Kernel, text: &str) -> Result<Vec<u32>, String> {
    let words = compile::to_spirv(text, &[], &mut |_| None)?;
    compile::check(&words, kernel.profile)
}

fn compiled(kernel: &Kernel, text: &str) -> Vec<u32> {
    try_compiled(kernel, text).unwrap_or_else(|error| panic!("{}: {error}\n{text}", kernel.name))
}

pub fn row(name: &str) -> &'static Kernel {
    KERNELS
        .iter()
        .find(|kernel| kernel.name == name)
        .expect(name)
}

fn stock(kernel: &'static Kernel) -> Vec<u32> {
    let source = read(&format!("shaders/kernels/{}", kernel.source));
    compile::kernel(kernel, &source, &mut lookup(kernel)).expect("a stock kernel compiles")
}

#[test]
fn every_stock_kernel_is_the_same_program() {
    let (mut slowest, mut before, mut after) = ((0.0, ""), 0, 0);
    for kernel in KERNELS {
        let start = Instant::now();
        let flat = flat(kernel);
        let seconds = start.elapsed().as_secs_f64();
        if seconds > slowest.0 {
            slowest = (seconds, kernel.name);
        }
        let (whole, small) = (stock(kernel), compiled(kernel, &flat.text));
        assert_eq!(canonical(&small), canonical(&whole), "{}", kernel.name);
        assert!(small.len() <= whole.len(), "{} grows", kernel.name);
        // And no function too many.
        let kept = flat
            .parts
            .iter()
            .flat_map(|part| part.kept.functions.clone());
        assert_eq!(
            kept.collect::<BTreeSet<_>>(),
            called(&whole),
            "{}",
            kernel.name
        );
        before += 4 * whole.len();
        after += 4 * small.len();
    }
    println!(
        "{} kernels: {before} to {after} bytes; slowest {slowest:?} s",
        KERNELS.len()
    );
}

/// Where the definitions of functions lie in a flattened text.
fn definitions(text: &str) -> Vec<std::ops::Range<usize>> {
    let starts = text.match_indices(") {\n").filter_map(|(at, _)| {
        let start = text[..at].rfind('\n')? + 1;
        (!text[start..].starts_with([' ', '}'])).then_some(start)
    });
    starts
        .map(|start| start..start + text[start..].find("\n}\n").expect("an end") + 3)
        .collect()
}

#[test]
fn a_dropped_function_is_seen() {
    for name in [
        "generate_tile_2_net",
        "map_spherical",
        "evaluate_blue_noise",
    ] {
        let kernel = row(name);
        let (flat, whole) = (flat(kernel), canonical(&stock(kernel)));
        let definitions = definitions(&flat.text);
        let listed = flat
            .parts
            .iter()
            .map(|part| part.kept.functions.len())
            .sum::<usize>();
        assert_eq!(
            definitions.len(),
            listed,
            "{name}: not every function is dropped in turn"
        );
        for range in definitions {
            let head = flat.text[range.clone()]
                .lines()
                .next()
                .unwrap_or("")
                .to_owned();
            let mut text = flat.text.clone();
            text.replace_range(range, "");
            let same = try_compiled(kernel, &text).is_ok_and(|words| canonical(&words) == whole);
            assert!(!same, "{name} does not need {head}");
        }
    }
}

#[test]
fn a_changed_number_is_seen() {
    for name in ["generate_tile_1", "nearest", "evaluate_blue_noise"] {
        let kernel = row(name);
        let (flat, whole) = (flat(kernel), canonical(&stock(kernel)));
        let (mut seen, mut at) = (0, flat.text.find("\nlayout").expect("declarations"));
        while let Some(next) = flat.text[at..].find(|c: char| c.is_ascii_digit()) {
            let (start, before) = (at + next, flat.text[..at + next].chars().last());
            let rest = &flat.text[start..];
            let digits = rest
                .find(|c: char| !c.is_ascii_digit())
                .unwrap_or(rest.len());
            at = start + digits;
            // Numbers like 12u that are no part of a name or of a line of comment.
            let line = &flat.text[flat.text[..start].rfind('\n').map_or(0, |at| at + 1)..start];
            let whole_number = rest[digits..].starts_with('u')
                && !before.is_some_and(|c| c.is_alphanumeric() || "_.".contains(c));
            if line.contains("//") || !whole_number {
                continue;
            }
            let value: u32 = rest[..digits].parse().expect("a number");
            let mut text = flat.text.clone();
            text.replace_range(start..at, &value.wrapping_add(1).to_string());
            let same = try_compiled(kernel, &text).is_ok_and(|words| canonical(&words) == whole);
            assert!(!same, "{name}: {line}{value} does not matter");
            seen += 1;
        }
        assert!(seen > 5, "{name}: {seen} numbers");
    }
}

#[test]
fn flattening_takes_little_time() {
    let kernel = row("estimate_pixels_lattice");
    let best = (0..5).map(|_| {
        let start = Instant::now();
        assert!(flat(kernel).text.len() > 50_000);
        start.elapsed().as_secs_f64()
    });
    let best = best.fold(f64::INFINITY, f64::min);
    println!("{}: {:.1} ms", kernel.name, 1e3 * best);
    assert!(best < 0.05, "{best} s");
}
