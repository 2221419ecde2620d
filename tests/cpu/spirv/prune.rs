//! Pruned modules: valid, as exact as they were, and without what was switched off.

use super::glsl::compile;
use super::{has_validator, validate};
use corput::interface::{KERNELS, Kernel, map, task};
use corput::kernels::spirv;
use corput::spirv::{Module, exact_policy, lint, prune};
use std::collections::BTreeSet;

/// The names of a module's functions.
fn functions(words: &[u32]) -> BTreeSet<String> {
    let module = Module::parse(words).expect("a module");
    let all = module.functions().iter();
    all.filter_map(|function| function.name.clone()).collect()
}

fn constant(kernel: &Kernel, name: &str, value: u32) -> (u32, u32) {
    let found = kernel.constants.iter().find(|one| one.name == name);
    (found.expect("a constant").id, value)
}

/// Values of the constants that choose what a kernel does: each kernel with a few.
fn choices(kernel: &Kernel) -> Vec<Vec<(u32, u32)>> {
    let named = |name| kernel.constants.iter().any(|one| one.name == name);
    let mut list = vec![Vec::new()];
    if named("FUNCTION") {
        list.extend([0, 1, 5, 99].map(|id| vec![constant(kernel, "FUNCTION", id)]));
    }
    if named("MAP") && named("TASK") {
        for id in [map::POLAR_DISK, map::CONE, 1000] {
            for task in [task::SAMPLE, task::PDF, task::INVERT, 9] {
                list.push(vec![
                    constant(kernel, "MAP", id),
                    constant(kernel, "TASK", task),
                ]);
            }
        }
    }
    list
}

#[test]
fn every_kernel_stays_valid_and_as_exact_as_it_was() {
    for kernel in KERNELS {
        let words = spirv(kernel.name).expect("a module");
        let before = lint(&words, &exact_policy()).expect("a module");
        for choice in choices(kernel) {
            let pruned = prune(&words, &choice).expect("a module");
            assert!(pruned.len() <= words.len(), "{}", kernel.name);
            assert_eq!(
                prune(&pruned, &choice).expect("a module"),
                pruned,
                "{}",
                kernel.name
            );
            assert!(functions(&pruned).is_subset(&functions(&words)));
            let after = lint(&pruned, &exact_policy()).expect("a module");
            assert!(
                after.violations.len() <= before.violations.len(),
                "{}",
                kernel.name
            );
            if has_validator() {
                validate(&pruned);
            }
        }
    }
}

#[test]
fn what_is_switched_off_goes_and_the_rest_stays() {
    let kernel = KERNELS
        .iter()
        .find(|kernel| kernel.name == "map_spherical")
        .expect("a kernel");
    let words = spirv(kernel.name).expect("a module");
    let pruned = |id, task| {
        let choice = [constant(kernel, "MAP", id), constant(kernel, "TASK", task)];
        functions(&prune(&words, &choice).expect("a module"))
    };
    let sample = pruned(map::CONE, task::SAMPLE);
    assert!(sample.contains("corput_cone") && sample.contains("map_sample"));
    assert!(!sample.contains("corput_cone_invert") && !sample.contains("map_invert"));
    assert!(!sample.contains("corput_uniform_sphere"));
    let invert = pruned(map::UNIFORM_SPHERE, task::INVERT);
    assert!(invert.contains("corput_uniform_sphere_invert"));
    assert!(!invert.contains("corput_cone") && !invert.contains("map_sample"));
    // Without values the defaults hold, and a constant of another number changes nothing.
    let own = functions(&prune(&words, &[(999, 7)]).expect("a module"));
    assert!(own.contains("map_sample") && !own.contains("map_invert"));
}

#[test]
fn a_branch_that_no_constant_decides_stays() {
    let source = "#version 450
        layout(local_size_x = 64) in;
        layout(constant_id = 3) const uint KIND = 1u;
        layout(std430, set = 0, binding = 0) buffer Data { uint data[]; };
        uint one(uint x) { return x * 3u; }
        uint two(uint x) { return x + 5u; }
        uint three(uint x) { return x ^ 9u; }
        uint never(uint x) { return x - 1u; }
        void nothing() { data[2] = 1u; }
        void main() {
            uint x = data[0];
            if (x > 3u) { x = one(x); }
            if (KIND == 1u && x > 4u) { x = two(x); }
            if (KIND == 2u) { x = never(x); nothing(); }
            switch (KIND) { case 1u: x = three(x); break; case 2u: x = never(x); break; default: nothing(); }
            data[1] = x;
        }";
    let words = compile(source);
    let left = |value| functions(&prune(&words, &[(3, value)]).expect("a module"));
    let names = |list: &[&str]| {
        list.iter()
            .map(|name| (*name).to_owned())
            .collect::<BTreeSet<_>>()
    };
    assert_eq!(left(1), names(&["main", "one", "two", "three"]));
    let all_but_three = left(2);
    assert!(all_but_three.contains("never") && all_but_three.contains("nothing"));
    assert!(!all_but_three.contains("three"));
    assert!(left(3).contains("nothing") && !left(3).contains("never"));
    for value in 1..4 {
        if has_validator() {
            validate(&prune(&words, &[(3, value)]).expect("a module"));
        }
    }
    assert!(prune(&words[..3], &[]).is_err());
}

#[test]
fn loops_are_kept_whole() {
    let source = "#version 450
        layout(local_size_x = 64) in;
        layout(constant_id = 3) const uint KIND = 1u;
        layout(std430, set = 0, binding = 0) buffer Data { uint data[]; };
        uint one(uint x) { return x * 3u; }
        uint two(uint x) { return x + 5u; }
        uint once(uint x) {
            for (uint i = 0u; i < x; i++) { x = two(x); if (KIND == 1u) { break; } x ^= one(i); }
            return x;
        }
        void main() {
            for (uint i = 0u; i < data[0]; i++) {
                if (KIND == 2u) { for (uint j = 0u; j < i; j++) { data[j] = one(j); } continue; }
                data[1] = once(i);
            }
        }";
    let words = compile(source);
    for value in 1..4 {
        let pruned = prune(&words, &[(3, value)]).expect("a module");
        assert_eq!(functions(&pruned).contains("once"), value != 2);
        if has_validator() {
            validate(&pruned);
        }
    }
}
