//! Maps that draw from a picture.

use super::parse::npy;
use super::refused::assert_refused;
use super::{Desk, skips};
use std::path::Path;

fn data(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    folder.join(name).display().to_string()
}

#[test]
fn directions_by_a_real_map_are_the_same_on_device_and_cpu() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    for (map, dims) in [("environment", 2), ("environment-alias", 3)] {
        let line = format!(
            "generate sobol --count 4096 --dims {dims} --map {map} --env {} --with-pdf",
            data("sunrise.exr")
        );
        for (name, device) in [("d.npy", ""), ("c.npy", "--device cpu")] {
            let run = desk.run(&format!("{line} {device} --out {name}"));
            run.expect(0, &[]);
            // What lossy compression left below 0.
            assert!(run.stderr.contains("570 texels"), "{}", run.stderr);
            assert!(run.stderr.contains("negative"), "{}", run.stderr);
        }
        assert_eq!(desk.bytes("d.npy"), desk.bytes("c.npy"), "{line}");
        npy(&desk.bytes("d.npy")).assert_is("<f4", 4096, 4);
    }
}

#[test]
fn weights_and_compensation_change_what_is_drawn() {
    let desk = Desk::new();
    let line = format!(
        "sobol --count 512 --dims 2 --device cpu --map environment --env {}",
        data("studio.exr")
    );
    let made = ["", "--env-weight max", "--compensated"].map(|more| {
        let run = desk.run(&format!("generate {line} {more} --out e.npy"));
        run.expect(0, &[]);
        desk.bytes("e.npy")
    });
    assert!(made[0] != made[1] && made[0] != made[2] && made[1] != made[2]);
    // A picture of one black texel, of the other format.
    std::fs::write(desk.path("b.hdr"), b"#?RADIANCE\n\n-Y 1 +X 1\n\0\0\0\0").unwrap();
    let run = desk.run(
        "generate sobol --count 4 --dims 2 --map environment --env b.hdr --device cpu --out b.npy",
    );
    run.expect(0, &[]);
    assert!(run.stderr.contains("it is black"), "{}", run.stderr);
    // Two texels, the second with 2^-120 of the light of the first.
    std::fs::write(
        desk.path("h.hdr"),
        b"#?RADIANCE\n\n-Y 1 +X 2\n\x80\x80\x80\xbc\x80\x80\x80\x44",
    )
    .unwrap();
    let run = desk.run(
        "generate sobol --count 4 --dims 2 --map environment --env h.hdr --device cpu --out h.npy",
    );
    run.expect(0, &[]);
    assert!(run.stderr.contains("1 texel has less"), "{}", run.stderr);
    std::fs::write(
        desk.path("r.hdr"),
        b"#?RADIANCE\n\n-Y 2 +X 1\n\x80\x80\x80\x80\0\0\0\0",
    )
    .unwrap();
    let run = desk.run(
        "generate sobol --count 4 --dims 2 --map environment --env r.hdr --device cpu --out r.npy",
    );
    run.expect(0, &[]);
    assert!(run.stderr.contains("1 row of it"), "{}", run.stderr);
}

#[test]
fn pictures_that_do_not_fit_are_refused() {
    let points = "generate sobol --count 16 --dims 2 --out x.npy --device cpu";
    for (options, words) in [
        ("--map environment", &["--env FILE"][..]),
        ("--env a.exr", &["--env", "add --map environment"]),
        (
            "--map concentric-disk --env a.exr",
            &["add --map environment"],
        ),
        ("--map concentric-disk --compensated", &["--compensated"]),
        (
            "--map environment --env absent.exr",
            &["absent.exr", "cannot be opened"],
        ),
        ("--map environment --env file", &["file", "empty"]),
    ] {
        assert_refused(&format!("{points} {options}"), words);
    }
    let line = format!(
        "{points} --map environment --env {} --env-weight maxi",
        data("studio.exr")
    );
    assert_refused(&line, &["maxi", "did you mean `max`"]);
}
