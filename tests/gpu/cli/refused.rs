//! Bad input: the exit code, the message, and no file.

use super::{Desk, repository, skips};
use exr::prelude::write_rgb_file;

/// Runs `line` in a new folder: refused with these words, and nothing is left.
pub fn assert_refused(line: &str, words: &[&str]) {
    let desk = Desk::new();
    std::fs::write(desk.path("file"), "").unwrap();
    let run = desk.run(line);
    run.expect(2, words);
    assert_eq!(run.stdout, b"", "`{line}` wrote to standard output");
    assert_eq!(desk.names(), ["file"], "`{line}` left files");
    assert_eq!(desk.bytes("file"), b"");
}

#[test]
fn requests_that_cannot_be_met() {
    let limit = "a whole number from 0 to";
    for (arguments, words) in [
        ("halton --count 0", &["--count is 0", "at least one"][..]),
        ("halton --count -5", &["--count", "-5 is negative", limit]),
        ("halton --count 1e6", &["`1e6` is no whole number", limit]),
        (
            "halton --count 99999999999999999999",
            &["99999999999999999999 is too large", limit],
        ),
        (
            "halton --count 5 --first -1",
            &["--first", "-1 is negative"],
        ),
        (
            "halton --count 4294967297",
            &["passes 2^32", "lower --first or --count by 1"],
        ),
        (
            "halton --first 4294967290 --count 10",
            &["4294967290 + 10", "passes 2^32", "by 4"],
        ),
        (
            "halton --first 18446744073709551615 --count 18446744073709551615",
            &["passes 2^32"],
        ),
        (
            "halton --count 5 --bases 0,2",
            &["base 0 is not prime", "use 2"],
        ),
        (
            "halton --count 5 --bases 1,2",
            &["base 1 is not prime", "use 2"],
        ),
        (
            "halton --count 5 --bases 2,9",
            &["base 9 is not prime", "use "],
        ),
        (
            "halton --count 5 --bases 2,-3",
            &["--bases", "-3 is negative"],
        ),
        (
            "halton --count 5 --bases 2,2",
            &["base 2 is given twice", "drop one"],
        ),
        (
            "halton --count 5 --bases 2,8167",
            &["base 8167 is above 8161", "choose a smaller one"],
        ),
        (
            "halton --count 5 --dims 1025",
            &["1025 dimensions", "1 to 1024", "ask for fewer"],
        ),
        (
            "hammersley --count 5 --dims 1026",
            &["1026 dimensions", "1 to 1025", "ask for fewer"],
        ),
        (
            "halton --count 5 --dims 0",
            &["0 dimensions", "1 to 1024", "at least one"],
        ),
        (
            "hammersley --count 5 --dims 0",
            &["0 dimensions", "1 to 1025"],
        ),
        ("halton --count 5 --dims -1", &["--dims", "-1 is negative"]),
        ("vdc --count 5 --dims 2", &["2 dimensions", "use halton"]),
        (
            "halton --count 5 --dims 3 --bases 2,3",
            &["--dims 3", "drop --dims"],
        ),
        (
            "halton --count 5 --index-first",
            &["--index-first", "use hammersley"],
        ),
        (
            "hammersley --count 5 --total 4",
            &["--total 4", "between 5 and 4294967296"],
        ),
        (
            "haltn --count 5",
            &["unknown sequence `haltn`", "did you mean `halton`", "vdc"],
        ),
        (
            "halton --count 5 --map cosine-hemispere",
            &[
                "unknown map",
                "did you mean `cosine-hemisphere`",
                "polar-disk",
            ],
        ),
        (
            "halton --count 5 --format nyp",
            &["unknown format `nyp`", "did you mean `npy`", "csv"],
        ),
        (
            "halton --count 5 --profile exat",
            &["unknown profile", "did you mean `exact`"],
        ),
        (
            "halton --count 5 --dims 1 --map polar-disk",
            &["takes 2 dimensions", "1 was given", "use --dims 2"],
        ),
        (
            "halton --count 5 --dims 3 --map polar-disk",
            &["takes 2 dimensions", "3 were given", "use --dims 2"],
        ),
        (
            "halton --count 5 --fractions --map polar-disk",
            &["--fractions with --map", "drop one"],
        ),
        (
            "halton --count 5 --with-pdf",
            &["--with-pdf without --map", "add --map"],
        ),
        ("halton", &["--count"]),
        ("halton --count 5 --sead 1", &["--sead", "--seed"]),
    ] {
        assert_refused(&format!("generate {arguments} --out p.npy"), words);
    }
    assert_refused("generate halton --count 5", &["--out"]);
    assert_refused("generat", &["generat", "generate"]);
}

#[test]
fn outputs_that_cannot_be_made() {
    for (out, words) in [
        (
            "p.npz",
            &["unknown format `.npz`", "did you mean `.npy`", "--format"][..],
        ),
        ("points", &["unknown format `points`", ".npy"]),
        (
            "missing/p.npy",
            &["missing/p.npy", "folder missing does not exist", "make it"],
        ),
        ("file/p.npy", &["file is not a folder", "another"]),
        (". --format npy", &["it names a folder", "name of a file"]),
        #[cfg(target_os = "linux")]
        (
            "/proc/p.npy",
            &["folder /proc is not writable", "another folder"],
        ),
    ] {
        let line = format!("generate halton --count 5 --device cpu --out {out}");
        assert_refused(&line, words);
    }
    assert_refused("headers --out file/x", &["file/x", "choose a folder"]);
    assert_refused("headers --out file", &["file", "choose a folder"]);
}

#[test]
fn devices_that_are_not_there() {
    if skips() {
        return;
    }
    for (line, words) in [
        (
            "generate halton --count 5 --out p.npy --device voodoo2",
            &["unknown device `voodoo2`", "present: 0: `", "give an index"][..],
        ),
        (
            "generate halton --count 5 --out p.npy --device 12",
            &["unknown device `12`", "present: 0: `"],
        ),
        ("check --device 12", &["unknown device `12`"]),
        ("bench --device 12", &["unknown device `12`"]),
        (
            "check --device cpu",
            &["--device cpu", "needs one", "corput devices"],
        ),
        (
            "demo --device cpu --out made",
            &["needs one", "corput devices"],
        ),
        (
            "check --only nothing-like-this",
            &["--only nothing-like-this", "corput check"],
        ),
        (
            "check --json --only nothing-like-this",
            &["--only nothing-like-this"],
        ),
    ] {
        assert_refused(line, words);
    }
}

#[test]
fn maps_that_are_no_light() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let good = std::fs::read(repository("tests/data/sunrise.exr")).unwrap();
    let file = |name: &str, bytes: &[u8]| {
        std::fs::write(desk.path(name), bytes).unwrap();
    };
    file("truncated.exr", &good[..good.len() / 2]);
    file("empty.exr", b"");
    let mut damaged = good.clone();
    for byte in &mut damaged[..300] {
        *byte ^= 0x5a;
    }
    file("corrupt.exr", &damaged);
    for (name, value) in [("nan.exr", f32::NAN), ("infinite.exr", f32::INFINITY)] {
        write_rgb_file(desk.path(name), 8, 4, |x, y| match (x, y) {
            (3, 2) => (1.0, value, 1.0),
            _ => (1.0, 1.0, 1.0),
        })
        .unwrap();
    }
    let before = desk.names();
    for (name, words) in [
        ("truncated", &["truncated", "fetch it again"][..]),
        ("empty", &["it is empty", "fetch it again"]),
        ("corrupt", &["no sound OpenEXR file", "fetch it again"]),
        ("nan", &["column 3, row 2", "not finite", "replace"]),
        ("infinite", &["column 3, row 2", "not finite", "replace"]),
        ("missing", &["cannot be opened", "check the path"]),
    ] {
        let run = desk.run(&format!("demo --env {name}.exr --out made"));
        run.expect(2, &[&format!("{name}.exr")]);
        run.expect(2, words);
        assert_eq!(run.stdout, b"");
        assert_eq!(desk.names(), before, "{name} left files");
    }
    let map = repository("tests/data/sunrise.exr");
    let line = format!("demo --env {} --out empty.exr", map.display());
    desk.run(&line).expect(2, &["empty.exr", "--out"]);
}
