//! The interface table against what the SPIR-V of each kernel says, both ways, and
//! against the numbers that shaders repeat.

#[path = "interface/facts.rs"]
mod facts;
mod source;

use corput::blue_noise::MaskShape;
use corput::interface::{
    Element, EstimatePush, Family, IrradiancePush, KERNELS, MaskPush, PairsPush, PushConstants,
    REPEATS, ReducePush, WorkPush, column_kind, map, output,
};
use corput::kernels::spirv;
use facts::{constants, promised, reflected};
use source::{files, read, without_comments};
use std::collections::BTreeSet;
use std::io::Write;
use std::mem::{align_of, size_of};
use std::process::{Command, Stdio};

/// `const uint NAME = 3u;` of a shader, or `const NAME: u32 = 3;` of Rust.
fn numbers(text: &str) -> BTreeSet<(String, u32)> {
    let mut found = BTreeSet::new();
    for line in without_comments(text).lines() {
        let line = line.trim().trim_start_matches("pub ");
        let Some((name, value)) = line.strip_prefix("const ").and_then(|l| l.split_once('='))
        else {
            continue;
        };
        let name = name.replace("uint ", "").replace(": u32", "");
        if let Ok(value) = value
            .trim()
            .trim_end_matches(';')
            .trim_end_matches('u')
            .parse()
        {
            found.insert((name.trim().to_owned(), value));
        }
    }
    found
}

/// The numbers of one `pub mod` of src/interface.
fn table(module: &str) -> BTreeSet<(String, u32)> {
    let text = read("src/interface/mod.rs") + &read("src/interface/family.rs");
    let start = text
        .split(&format!("pub mod {module} {{"))
        .nth(1)
        .expect(module);
    numbers(start.split("\n}").next().unwrap_or(""))
}

#[test]
fn modules_say_what_the_table_says() {
    for row in KERNELS {
        let words = spirv(row.name).expect("a module for each row");
        assert_eq!(promised(row), reflected(&words), "{}", row.name);
    }
}

/// A list with its last item changed.
fn edited<T: Copy>(list: &[T], edit: impl Fn(&mut T)) -> &'static [T] {
    let mut list = list.to_vec();
    list.last_mut().map(edit).expect("an item");
    list.leak()
}

#[test]
fn a_wrong_row_is_seen() {
    let row = |name: &str| *KERNELS.iter().find(|row| row.name == name).expect(name);
    let (fused, map) = (row("fused"), row("map_hemisphere"));
    let facts = reflected(&spirv("fused").expect("a module"));
    let mut wrong = [fused; 13];
    wrong[0].local_size = 128;
    wrong[1].push = IrradiancePush::MEMBERS;
    wrong[2].bindings = map.bindings;
    wrong[3].constants = &fused.constants[1..];
    wrong[4].constants = map.constants;
    wrong[5].push = edited(fused.push, |member| member.offset = 12);
    wrong[6].bindings = edited(fused.bindings, |binding| binding.input = true);
    wrong[7].bindings = edited(fused.bindings, |binding| binding.element = Element::Uint);
    wrong[8].bindings = edited(fused.bindings, |binding| binding.binding = 1);
    wrong[9].constants = edited(fused.constants, |constant| constant.id = 99);
    wrong[10].constants = edited(fused.constants, |constant| constant.default += 1);
    wrong[11].columns = Some((Family::Radical, 1));
    wrong[12].columns = Some((Family::Net, 2));
    for (i, row) in wrong.iter().enumerate() {
        assert_ne!(promised(row), facts, "mistake {i}");
    }
    let estimate = row("estimate_tile_2_net");
    let facts = reflected(&spirv("estimate_tile_2_net").expect("a module"));
    let mut wrong = [estimate; 5];
    wrong[0].shapes = 1;
    wrong[1].shapes = 3;
    wrong[2].columns = Some((Family::Net, 2));
    wrong[3].bindings = edited(estimate.bindings, |binding| {
        binding.element = Element::Rows(64);
    });
    wrong[4].bindings = edited(estimate.bindings, |binding| {
        binding.element = Element::Uvec4;
    });
    for (i, row) in wrong.iter().enumerate() {
        assert_ne!(promised(row), facts, "mistake {i} of an estimate");
    }
    // From the other side: one other default in the module.
    let words = spirv("fused").expect("a module");
    let mut seen = 0;
    for (at, word) in words.iter().enumerate().skip(5) {
        let opcode = word & 0xffff;
        if opcode == ::spirv::Op::SpecConstant as u32 && *word >> 16 == 4 {
            let mut changed = words.clone();
            changed[at + 3] ^= 1;
            seen += u32::from(constants(&changed) != constants(&words));
        }
    }
    assert_eq!(seen as usize, fused.specialization().len());
}

#[test]
fn rows_keep_to_what_every_device_has() {
    let mut names = BTreeSet::new();
    for row in KERNELS {
        assert!(names.insert(row.name), "two rows {}", row.name);
        assert!(row.local_size <= 128 && row.bindings.len() <= 4 && row.push_bytes() <= 128);
        let constants = row.specialization();
        let ids: BTreeSet<u32> = constants.iter().map(|c| c.0).collect();
        let known: BTreeSet<&str> = constants.iter().map(|c| c.1.as_str()).collect();
        assert_eq!(ids.len(), constants.len(), "{}: an id twice", row.name);
        assert_eq!(known.len(), constants.len(), "{}: a name twice", row.name);
        let bindings: BTreeSet<u32> = row.bindings.iter().map(|b| b.binding).collect();
        assert_eq!(
            bindings.len(),
            row.bindings.len(),
            "{}: a binding twice",
            row.name
        );
    }
    let sources: BTreeSet<&str> = KERNELS.iter().map(|row| row.source).collect();
    let files = files("shaders/kernels", &[".comp"]);
    assert_eq!(sources, files.iter().map(String::as_str).collect());
}

#[test]
fn structs_have_the_size_of_their_blocks() {
    fn check<P: PushConstants>(bytes: &[u8]) {
        assert_eq!(size_of::<P>(), 4 * P::MEMBERS.len());
        assert_eq!((bytes.len(), align_of::<P>()), (size_of::<P>(), 4));
        for (i, member) in P::MEMBERS.iter().enumerate() {
            assert_eq!(member.offset, 4 * i, "{}", member.name);
        }
    }
    check::<WorkPush>(&WorkPush::default().bytes());
    check::<IrradiancePush>(&IrradiancePush::default().bytes());
    check::<EstimatePush>(&EstimatePush::default().bytes());
    check::<PairsPush>(&PairsPush::default().bytes());
    check::<ReducePush>(&ReducePush::default().bytes());
    check::<MaskPush>(&MaskPush::default().bytes());
    let push = WorkPush {
        first: 1,
        invocations: 2,
        stride: 3,
    };
    let words: Vec<u32> = push
        .bytes()
        .chunks(4)
        .map(|b| u32::from_ne_bytes(b.try_into().unwrap()))
        .collect();
    assert_eq!(words, [1, 2, 3]);
}

#[test]
fn shaders_repeat_the_right_numbers() {
    let text = |name: &str| read(&format!("shaders/kernels/{name}"));
    let kernels = files("shaders/kernels", &[".comp", ".glsl"]);
    let columns: Vec<&String> = kernels
        .iter()
        .filter(|n| n.starts_with("column_"))
        .collect();
    let kinds: BTreeSet<_> = columns
        .iter()
        .flat_map(|name| numbers(&text(name)))
        .collect();
    assert_eq!(kinds, table("column_kind"));
    let maps: Vec<&String> = kernels
        .iter()
        .filter(|n| n.starts_with("map_") && *n != "map_main.glsl")
        .collect();
    let ids: BTreeSet<_> = maps.iter().flat_map(|name| numbers(&text(name))).collect();
    assert_eq!(ids, table("map"));
    let tasks = text("map_main.glsl") + &text("repeat.glsl");
    assert_eq!(numbers(&tasks), table("task"));
    let repeats = format!("#define REPEATS {REPEATS}u");
    assert!(text("repeat.glsl").contains(&repeats), "no `{repeats}`");
    assert_eq!(numbers(&text("pairs.comp")), table("pair_kind"));
    let integrands: Vec<&String> = kernels
        .iter()
        .filter(|n| n.starts_with("integrand"))
        .collect();
    let ids: BTreeSet<_> = integrands
        .iter()
        .flat_map(|name| numbers(&text(name)))
        .collect();
    assert_eq!(ids, table("integrand"));
    // The reader of src/interface reads what the compiler reads.
    assert!(table("column_kind").contains(&("RADICAL".to_owned(), column_kind::RADICAL)));
    assert!(table("map").contains(&(
        "COSINE_HEMISPHERE_POLAR".to_owned(),
        map::COSINE_HEMISPHERE_POLAR
    )));
    // No other shader has numbers of its own at file level.
    for name in &kernels {
        let listed = ["map_main.glsl", "pairs.comp", "repeat.glsl"].contains(&name.as_str());
        let groups = [&columns, &maps, &integrands];
        let known = groups.iter().any(|group| group.contains(&name)) || listed;
        assert!(known || numbers(&text(name)).is_empty(), "{name}");
    }
    let fractions = format!("if (kind_of_output == {}u)", output::FRACTIONS);
    assert!(text("column.glsl").contains(&fractions), "no `{fractions}`");
    assert_eq!(table("output").len(), 2, "column_output() knows two kinds");
    let probe = KERNELS
        .iter()
        .find(|row| row.name == "probe")
        .expect("the probe");
    let group = format!("group * {}u", probe.local_size);
    assert!(text("probe.comp").contains(&group), "no `{group}`");
    // Two keys for each row of a mask.
    let keys = format!("shared uint row_keys[{}];", 2 * MaskShape::MAX_ROWS);
    let mask = text("void_and_cluster.comp");
    assert!(mask.contains(&keys), "no `{keys}`");
    assert_ne!(
        numbers("const uint GRID = 3u;"),
        numbers("pub const GRID: u32 = 2;")
    );
}

#[test]
fn modules_are_valid() {
    let valid = |words: &[u32]| -> Option<(bool, String)> {
        let mut child = Command::new("spirv-val")
            .args(["--target-env", "vulkan1.1", "-"])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .ok()?;
        let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        child
            .stdin
            .take()
            .expect("a pipe")
            .write_all(&bytes)
            .expect("spirv-val reads");
        let done = child.wait_with_output().expect("spirv-val ends");
        let log = [done.stdout, done.stderr].concat();
        Some((
            done.status.success(),
            String::from_utf8_lossy(&log).into_owned(),
        ))
    };
    for row in KERNELS {
        let words = spirv(row.name).expect("a module");
        let Some((good, log)) = valid(&words) else {
            let mut out = std::io::stderr().lock();
            let _ = writeln!(out, "SKIPPED: no spirv-val on PATH (package spirv-tools)");
            return;
        };
        assert!(good, "{}: {log}", row.name);
        let cut = valid(&words[..words.len() - 1]);
        assert!(cut.is_some_and(|(good, _)| !good), "a cut module passes");
    }
}
