//! Modules without the names of what lies in functions.

use super::glsl::compile;
use super::{has_validator, validate};
use ::spirv::Op;
use corput::interface::KERNELS;
use corput::kernels::spirv;
use corput::spirv::{Module, drop_local_names, exact_policy, lint};

const SOURCE: &str = "#version 450
    #extension GL_EXT_control_flow_attributes : require
    layout(local_size_x = 64) in;
    layout(std430, set = 0, binding = 0) buffer Data { uint words[]; };
    layout(push_constant) uniform Push { uint first; } push;
    struct Pair { uint one; uint other; };
    uint twice(uint given) { uint local = given * 2u; return local; }
    void main() {
        Pair pair = Pair(twice(push.first), 1u);
        words[0] = pair.one + pair.other;
    }";

/// The names in a module: of ids, and of members.
fn names(words: &[u32]) -> Vec<String> {
    let module = Module::parse(words).expect("a module");
    let text = |at| move |one: &corput::spirv::Instruction| one.text(at).expect("a name");
    let all = module.instructions().iter();
    let mut names: Vec<String> = all
        .clone()
        .filter(|one| one.op() == Some(Op::Name))
        .map(text(2))
        .collect();
    let members = all.filter(|one| one.op() == Some(Op::MemberName));
    names.extend(members.map(text(3)));
    names.retain(|name| !name.is_empty());
    names.sort_unstable();
    names
}

#[test]
fn what_an_engine_binds_and_the_linter_reads_keeps_its_name() {
    let words = compile(SOURCE);
    let all = names(&words);
    for name in ["given", "local", "pair", "one", "other", "param"] {
        assert!(all.iter().any(|known| known == name), "{name} of {all:?}");
    }
    let fewer = drop_local_names(&words).expect("a module");
    assert_eq!(
        names(&fewer),
        [
            "Data",
            "Pair",
            "Push",
            "first",
            "main",
            "push",
            "twice(u1;",
            "words"
        ]
    );
    let module = Module::parse(&fewer).expect("a module");
    let extension = |one: &corput::spirv::Instruction| one.op() == Some(Op::SourceExtension);
    assert!(!module.instructions().iter().any(extension));
    assert_eq!(drop_local_names(&fewer).expect("a module"), fewer);
}

#[test]
fn every_kernel_is_as_exact_without_them() {
    for kernel in KERNELS {
        let words = spirv(kernel.name).expect("a module");
        let fewer = drop_local_names(&words).expect("a module");
        assert!(fewer.len() < words.len(), "{}", kernel.name);
        let judged = |words: &[u32]| {
            format!(
                "{:?}",
                lint(words, &exact_policy())
                    .expect("a module")
                    .violations
                    .len()
            )
        };
        assert_eq!(judged(&fewer), judged(&words), "{}", kernel.name);
        if has_validator() {
            validate(&fewer);
        }
    }
}
