//! Arrays in source text: a compiler reads the same bits.

use super::*;
use std::process::Command;

/// Floats that are hard to write.
const HARD: [f32; 12] = [
    0.0,
    -0.0,
    1.0,
    0.1,
    1.0 / 3.0,
    -0.99999994,
    16_777_216.0,
    f32::MAX,
    f32::MIN_POSITIVE,
    1e-45,
    f32::INFINITY,
    f32::NEG_INFINITY,
];

fn write(folder: &TempDir, name: &str, layout: Layout, words: &[u32]) -> String {
    let path = folder.path().join(name);
    let format = Format::from_path(&path).unwrap();
    // In pieces that end within rows.
    let pieces: Vec<&[u32]> = words.chunks(5).collect();
    save(&path, format, layout, &pieces).unwrap();
    fs::read_to_string(path).unwrap()
}

/// The bits of every value of an array, as a C program that includes the header prints them.
fn compiled(element: Element, columns: u32, words: &[u32]) -> Vec<u64> {
    let folder = tempfile::tempdir().unwrap();
    let rows = words.len() as u64 / u64::from(columns);
    let text = write(
        &folder,
        "my data-1.h",
        layout(rows, columns, element),
        words,
    );
    // What is more than letters, digits and single underscores has a hash behind it.
    let name = "points_my_data_1_55362a02";
    assert!(
        text.contains(&format!("{name}[{rows}][{columns}] = {{")),
        "{text}"
    );
    let main = "#include \"my data-1.h\"\n#include \"my data-1.h\"\n\
        #include <stdio.h>\n#include <string.h>\n\
        int main(void) {\n\
            size_t size = sizeof NAME[0][0];\n\
            const char *at = (const char *)NAME;\n\
            for (size_t i = 0; i < sizeof NAME / size; i++) {\n\
                unsigned long long bits = 0;\n\
                memcpy(&bits, at + i * size, size);\n\
                printf(\"%llu\\n\", bits);\n\
            }\n\
            return 0;\n\
        }\n"
    .replace("NAME", name);
    fs::write(folder.path().join("main.c"), main).unwrap();
    let built = Command::new("cc")
        .current_dir(folder.path())
        .args([
            "-std=c99", "-Wall", "-Wextra", "-Werror", "main.c", "-o", "main",
        ])
        .output()
        .expect("a C compiler");
    assert!(
        built.status.success(),
        "{}",
        String::from_utf8_lossy(&built.stderr)
    );
    let ran = Command::new(folder.path().join("main")).output().unwrap();
    let text = String::from_utf8(ran.stdout).unwrap();
    text.lines().map(|line| line.parse().unwrap()).collect()
}

#[test]
fn a_c_compiler_reads_the_same_bits() {
    let floats = words(&HARD);
    let fractions: Vec<u32> = (0..12u32)
        .map(|i| i.wrapping_mul(0x1234_5679) ^ u32::MAX)
        .collect();
    for columns in [1, 3, 12] {
        let bits = compiled(Element::F32, columns, &floats);
        assert_eq!(
            bits,
            floats
                .iter()
                .map(|word| u64::from(*word))
                .collect::<Vec<_>>()
        );
        let bits = compiled(Element::U32, columns, &fractions);
        assert_eq!(
            bits,
            fractions
                .iter()
                .map(|word| u64::from(*word))
                .collect::<Vec<_>>()
        );
        let bits = compiled(Element::U16, columns, &fractions);
        assert_eq!(
            bits,
            fractions
                .iter()
                .map(|word| u64::from(word >> 16))
                .collect::<Vec<_>>()
        );
        let bits = compiled(Element::F64, columns, &fractions);
        let exact = |word: &u32| (f64::from(*word) * 0.5f64.powi(32)).to_bits();
        assert_eq!(bits, fractions.iter().map(exact).collect::<Vec<_>>());
    }
}

#[test]
fn not_a_number_has_a_name() {
    let folder = tempfile::tempdir().unwrap();
    let text = write(
        &folder,
        "p.h",
        layout(1, 1, Element::F32),
        &[f32::NAN.to_bits()],
    );
    assert!(
        text.contains("{NAN},\n") && text.contains("#include <math.h>"),
        "{text}"
    );
}

#[test]
fn a_glsl_array_is_golden() {
    let folder = tempfile::tempdir().unwrap();
    let text = write(
        &folder,
        "p.glsl",
        layout(2, 2, Element::F32),
        &words(&[0.0, 1.0, 0.5, -1.0]),
    );
    assert_eq!(
        text,
        "// uintBitsToFloat(points_p[2u * i + j]) is column j of row i.\n\
         #ifndef CORPUT_GLSL_points_p\n#define CORPUT_GLSL_points_p\n\n\
         const uint points_p[4] = uint[](\n\
         0x00000000u, 0x3f800000u,\n\
         0x3f000000u, 0xbf800000u\n\
         );\n\n#endif\n"
    );
    let text = write(
        &folder,
        "p.glsl",
        layout(2, 1, Element::U32),
        &[7, u32::MAX],
    );
    assert!(text.contains("// points_p[1u * i + j] is"), "{text}");
    assert!(text.contains("uint[](\n7u,\n4294967295u\n);"), "{text}");
}

/// All of them in one program: no array has the name of another, and no guard.
#[test]
fn arrays_of_files_of_one_folder_have_names_of_their_own() {
    const FILES: [&str; 9] = ["a_b", "a-b", "a b", "A_b", "a__b", "_a_b", "a_b_", "-", "é"];
    let folder = tempfile::tempdir().unwrap();
    let (mut includes, mut names) = (String::new(), Vec::new());
    for (value, stem) in (0..).zip(FILES) {
        let file = format!("{stem}.h");
        let text = write(&folder, &file, layout(1, 1, Element::U32), &[value]);
        let (_, rest) = text.split_once("uint32_t ").unwrap();
        names.push(rest.split_once('[').unwrap().0.to_owned());
        includes += &format!("#include \"{file}\"\n");
        let text = write(
            &folder,
            &format!("{stem}.glsl"),
            layout(1, 1, Element::U32),
            &[value],
        );
        let (_, rest) = text.split_once("const uint ").unwrap();
        assert_eq!(rest.split_once('[').unwrap().0, names[value as usize]);
        assert!(!text.contains("__"), "GLSL reserves it: {text}");
    }
    assert_eq!(names[0], "points_a_b");
    let wrong: Vec<String> = (0..FILES.len())
        .map(|at| format!("{}[0][0] != {at}", names[at]))
        .collect();
    let main = format!(
        "{includes}int main(void) {{ return {}; }}\n",
        wrong.join(" || ")
    );
    fs::write(folder.path().join("main.c"), main).unwrap();
    let built = Command::new("cc")
        .current_dir(folder.path())
        .args([
            "-std=c99", "-Wall", "-Wextra", "-Werror", "main.c", "-o", "main",
        ])
        .output()
        .expect("a C compiler");
    assert!(
        built.status.success(),
        "{}",
        String::from_utf8_lossy(&built.stderr)
    );
    let ran = Command::new(folder.path().join("main")).status().unwrap();
    assert!(ran.success());
}

#[test]
fn what_source_text_cannot_hold_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    for (name, shape, words) in [
        (
            "p.h",
            layout((1 << 20) + 1, 1, Element::F32),
            "1048577 values as c-header",
        ),
        (
            "p.glsl",
            layout(1 << 19, 3, Element::U32),
            "1572864 values as glsl",
        ),
        ("p.glsl", layout(1, 1, Element::F64), "f64 in a GLSL array"),
        ("p.glsl", layout(1, 1, Element::U16), "u16 in a GLSL array"),
    ] {
        let path = folder.path().join(name);
        let error = save(&path, Format::from_path(&path).unwrap(), shape, &[]).unwrap_err();
        let text = error.to_string();
        assert!(error.exit_code() == 2 && text.contains(words), "{text}");
    }
    assert!(names(&folder).is_empty());
}
