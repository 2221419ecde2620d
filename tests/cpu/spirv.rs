//! The SPIR-V linter and decorator: what they must catch, what they must let
//! through.

#[path = "spirv/glsl.rs"]
mod glsl;
#[path = "spirv/names.rs"]
mod names;
#[path = "spirv/prune.rs"]
mod prune;
#[path = "spirv/robust.rs"]
mod robust;

use std::io::Write;
use std::process::{Command, Stdio};

use ::spirv::{GlslStd450Op, Op};
use corput::spirv::{
    Allowance, AllowanceKind, Module, Tier, Violation, decorate_no_contraction, describe,
    exact_policy, lint, native_policy, remove_no_contraction,
};
use glsl::{FORBIDDEN_IN_FUNCTION, FORBIDDEN_IN_MODULE, compile, exact_kernel, expression};

/// Compiled and decorated, as `build.rs` does it.
fn build(source: &str) -> Vec<u32> {
    decorate_no_contraction(&compile(source)).expect("decorate")
}

fn violations(words: &[u32]) -> Vec<Violation> {
    lint(words, &exact_policy()).expect("lint").violations
}

fn caught(words: &[u32], function: &str, opcode: &str) -> bool {
    violations(words)
        .iter()
        .any(|found| found.function == function && found.opcode == opcode)
}

#[test]
fn each_forbidden_operation_is_caught_in_its_function() {
    for (code, opcode) in FORBIDDEN_IN_FUNCTION {
        let words = build(&expression(code));
        let found = violations(&words);
        assert!(
            caught(&words, "corput_bad", opcode),
            "{code}: {opcode} not caught in {found:?}"
        );
        assert!(
            found.iter().all(|row| row.function == "corput_bad"),
            "{code}: {found:?}"
        );
    }
}

#[test]
fn each_forbidden_declaration_is_caught() {
    for (declarations, code, opcode) in FORBIDDEN_IN_MODULE {
        let words = build(&expression(code).replace("//DECLARATIONS", declarations));
        assert!(
            caught(&words, "(module)", opcode),
            "{declarations}: {:?}",
            violations(&words)
        );
    }
}

#[test]
fn native_policy_allows_core_glsl_only() {
    for (code, _) in FORBIDDEN_IN_FUNCTION {
        let report = lint(&compile(&expression(code)), &native_policy()).expect("lint");
        assert!(report.is_clean(), "{code}: {:?}", report.violations);
        assert_eq!(report.tier, None);
    }
    for (declarations, code, opcode) in FORBIDDEN_IN_MODULE {
        let words = compile(&expression(code).replace("//DECLARATIONS", declarations));
        let clean = lint(&words, &native_policy()).expect("lint").is_clean();
        let core_glsl = ["SpecConstantOp", "Decorate"].contains(opcode);
        assert_eq!(clean, core_glsl, "{declarations}");
    }
}

#[test]
fn clean_kernels_pass_with_their_tier() {
    let report = lint(&build(&exact_kernel("")), &exact_policy()).expect("lint");
    assert_eq!(report.violations, []);
    assert_eq!(report.tier, Some(Tier::Integer));
    let seeds: Vec<&str> = report.used.keys().map(String::as_str).collect();
    let expected = [
        "corput_seed_quotient",
        "corput_seed_sqrt",
        "corput_seed_step",
        "corput_unit_ceil",
        "corput_unit_floor",
    ];
    assert_eq!(seeds, expected);

    let report = lint(&build(&exact_kernel("#define WITH_FRAME")), &exact_policy()).expect("lint");
    assert_eq!(report.violations, []);
    assert_eq!(report.tier, Some(Tier::Float));
}

#[test]
fn an_allowance_covers_its_function_and_its_opcodes_only() {
    let sqrt = "uint corput_seed_sqrt(uint u) { return uint(sqrt(float(u))); }";
    let used = expression("uintBitsToFloat(corput_seed_sqrt(u))").replace("//DECLARATIONS", sqrt);
    assert_eq!(violations(&build(&used)), []);
    assert!(caught(
        &build(&used.replace("corput_seed_sqrt", "corput_sqrt")),
        "corput_sqrt",
        "GLSL.std.450 Sqrt"
    ));
    assert!(caught(
        &build(&used.replace("sqrt(float", "sin(float")),
        "corput_seed_sqrt",
        "GLSL.std.450 Sin"
    ));
    // A name that merely begins like an allowed one is another name.
    let renamed = build(&used.replace("corput_seed_sqrt", "corput_seed_sqrt2"));
    assert!(caught(&renamed, "corput_seed_sqrt2", "ConvertUToF"));
    let row = Allowance {
        function: "corput_seed_sqrt2",
        kind: AllowanceKind::TierF,
        opcodes: &["ConvertUToF", "GLSL.std.450 Sqrt", "ConvertFToU"],
        reason: "a test",
    };
    let report = lint(&renamed, &exact_policy().with(row)).expect("lint");
    assert_eq!(
        (report.violations, report.tier),
        (vec![], Some(Tier::Float))
    );
}

#[test]
fn a_function_that_may_end_without_a_value_is_caught() {
    let endless = "uint corput_endless(uint u) { while (true) { if (u > 3u) { return u; } ++u; } }";
    let words =
        build(&expression("uintBitsToFloat(corput_endless(u))").replace("//DECLARATIONS", endless));
    assert!(
        caught(&words, "corput_endless", "Undef"),
        "{:?}",
        violations(&words)
    );
}

#[test]
fn the_table_of_allowances_names_opcodes_that_exist() {
    let plain = (0..=0xffff)
        .filter_map(Op::from_u32)
        .map(|op| format!("{op:?}"));
    let extended = (0..=0xff)
        .filter_map(GlslStd450Op::from_u32)
        .map(|op| format!("GLSL.std.450 {op:?}"));
    let known: Vec<String> = plain.chain(extended).collect();
    let policy = exact_policy();
    for row in policy.allowances() {
        assert!(row.function.starts_with("corput_"), "{}", row.function);
        for opcode in row.opcodes {
            assert!(
                known.iter().any(|name| name == opcode),
                "{}: {opcode}",
                row.function
            );
        }
    }
}

#[test]
fn the_decorator_reaches_callees_that_precise_does_not() {
    let words = compile(&exact_kernel("#define WITH_FRAME"));
    let bare = violations(&words);
    assert!(
        bare.iter()
            .any(|row| row.function == "corput_frame" && row.reason.contains("NoContraction")),
        "{bare:?}"
    );
    assert_eq!(
        violations(&decorate_no_contraction(&words).expect("decorate")),
        []
    );
}

#[test]
fn the_decorator_changes_nothing_but_decorations_and_nothing_twice() {
    let words = compile(&exact_kernel("#define WITH_FRAME"));
    let once = decorate_no_contraction(&words).expect("decorate");
    assert_eq!(decorate_no_contraction(&once).expect("decorate"), once);
    let mut bare = once.clone();
    while let Some(shorter) = remove_no_contraction(&bare, 0) {
        bare = shorter;
    }
    let mut original = words;
    while let Some(shorter) = remove_no_contraction(&original, 0) {
        original = shorter;
    }
    assert_eq!(bare, original);
    assert_eq!(
        decorate_no_contraction(&bare).expect("decorate").len(),
        once.len()
    );
}

#[test]
fn the_removal_of_any_no_contraction_is_caught() {
    let words = build(&exact_kernel("#define WITH_FRAME"));
    let mut removed = 0;
    while let Some(mutant) = remove_no_contraction(&words, removed) {
        let found = violations(&mutant);
        assert_eq!(found.len(), 1, "mutant {removed}: {found:?}");
        assert!(found[0].reason.contains("NoContraction"), "{}", found[0]);
        removed += 1;
    }
    assert!(removed > 15, "only {removed} decorations");
}

#[test]
fn a_stripped_module_cannot_be_proved() {
    let words = build(&exact_kernel(""));
    let module = Module::parse(&words).expect("parse");
    let mut stripped = words[..5].to_vec();
    for instruction in module
        .instructions()
        .iter()
        .filter(|row| row.op() != Some(Op::Name))
    {
        stripped.extend(instruction.words);
    }
    let report = lint(&stripped, &exact_policy()).expect("lint");
    let unit = module
        .functions()
        .iter()
        .find(|row| row.name.as_deref() == Some("corput_unit_floor"))
        .expect("unit");
    assert!(
        report
            .violations
            .iter()
            .any(|row| row.function == format!("%{}", unit.id) && row.opcode == "FMul")
    );
    assert!(
        report
            .violations
            .iter()
            .any(|row| row.reason.contains("without a name"))
    );
}

#[test]
fn facts_are_those_of_the_source() {
    let words = compile(&exact_kernel(""));
    let facts = describe(&words).expect("describe");
    assert_eq!(facts.capabilities, ["Shader"]);
    assert_eq!(facts.bindings, [(0, 0), (0, 2), (1, 1)]);
    assert_eq!(facts.spec_ids, [3, 7]);
    assert_eq!(facts.bytes, words.len() * 4);
    assert!(
        facts
            .functions
            .iter()
            .any(|name| name == "corput_seed_sqrt")
    );
    assert!(facts.instructions > 100);
    let module = Module::parse(&words).expect("parse");
    assert_eq!(module.entry_points()[0].name, "main");
}

#[test]
fn decorated_modules_are_valid() {
    if !has_validator() {
        return;
    }
    validate(&build(&exact_kernel("")));
    validate(&build(&exact_kernel("#define WITH_FRAME")));
    for (code, _) in FORBIDDEN_IN_FUNCTION {
        validate(&build(&expression(code)));
    }
}

/// Whether there is a validator; it is said aloud where there is none.
fn has_validator() -> bool {
    let found = Command::new("spirv-val").arg("--version").output().is_ok();
    if !found {
        eprintln!("SKIPPED: no spirv-val on PATH (package spirv-tools)");
    }
    found
}

fn validate(words: &[u32]) {
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    let mut child = Command::new("spirv-val")
        .args(["--target-env", "vulkan1.1", "-"])
        .stdin(Stdio::piped())
        .stderr(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("spirv-val");
    child
        .stdin
        .take()
        .expect("stdin")
        .write_all(&bytes)
        .expect("write");
    let output = child.wait_with_output().expect("spirv-val");
    assert!(
        output.status.success(),
        "{}{}",
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    );
}

/// A row of the table that no stock kernel needs is leave that nobody asked for.
#[test]
fn every_allowance_is_used_by_a_stock_kernel() {
    let mut used = std::collections::BTreeMap::<String, Vec<String>>::new();
    for kernel in corput::interface::KERNELS {
        let words = corput::kernels::spirv(kernel.name).expect("a stock kernel");
        let report = lint(&words, &exact_policy()).expect("lint");
        for (function, opcodes) in report.used {
            used.entry(function)
                .or_default()
                .extend(opcodes.into_iter().map(|opcode| opcode.to_string()));
        }
    }
    for row in exact_policy().allowances() {
        let known = used
            .get(row.function)
            .unwrap_or_else(|| panic!("{} is not used", row.function));
        for opcode in row.opcodes {
            // Tier F is leave for three operations as one.
            let needed = row.kind == AllowanceKind::TierF || known.iter().any(|k| k == opcode);
            assert!(needed, "{} does not need {opcode}", row.function);
        }
    }
}
