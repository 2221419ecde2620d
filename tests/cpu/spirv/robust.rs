//! No words make the reader panic.

use std::sync::OnceLock;

use corput::spirv::{
    Error, Module, decorate_no_contraction, describe, exact_policy, lint, native_policy, prune,
    remove_no_contraction,
};
use proptest::prelude::*;

use crate::build;
use crate::glsl::exact_kernel;

/// Everything at once; only a panic is a failure.
fn exercise(words: &[u32]) {
    for policy in [exact_policy(), native_policy()] {
        if let Ok(report) = lint(words, &policy) {
            assert!(
                report
                    .violations
                    .iter()
                    .all(|row| !row.to_string().is_empty())
            );
        }
    }
    if let Ok(decorated) = decorate_no_contraction(words) {
        assert_eq!(decorate_no_contraction(&decorated), Ok(decorated));
    }
    let _ = remove_no_contraction(words, 1);
    let _ = describe(words);
    let _ = prune(words, &[(0, 1)]);
}

#[test]
fn every_truncation_is_an_error() {
    let words = build(&exact_kernel("#define WITH_FRAME"));
    for length in 0..words.len() {
        let error = lint(&words[..length], &exact_policy()).expect_err("a cut-off module");
        assert!(!error.to_string().is_empty());
        exercise(&words[..length]);
    }
    assert_eq!(
        Module::parse(&[]).unwrap_err(),
        Error::NoHeader { words: 0 }
    );
    let swapped: Vec<u32> = words.iter().map(|word| word.swap_bytes()).collect();
    let message = Module::parse(&swapped).unwrap_err().to_string();
    assert!(message.contains("bytes swapped"), "{message}");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn no_words_make_it_panic(
        flips in prop::collection::vec((any::<prop::sample::Index>(), any::<u32>(), 0..4u32), 1..8),
    ) {
        static WORDS: OnceLock<Vec<u32>> = OnceLock::new();
        let mut words = WORDS.get_or_init(|| build(&exact_kernel("#define WITH_FRAME"))).clone();
        for (place, value, kind) in flips {
            let place = 5 + place.index(words.len() - 5);
            words[place] = match kind {
                0 => value,
                1 => words[place] ^ (1 << (value % 32)),
                2 => (words[place] & 0xffff_0000) | (value % 400),
                _ => value % 64,
            };
        }
        exercise(&words);
    }
}
