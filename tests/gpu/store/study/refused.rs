//! What of a study in shards is refused, and what stays as it was.

use super::{Desk, STUDY, shard};
use std::fs;

#[test]
fn cells_that_do_not_belong_together() {
    let desk = Desk::new();
    shard(&desk, "", "0/2").expect(0, &[]);
    // Another study in its place, and beside it.
    shard(&desk, "--seed 7", "0/2").expect(
        2,
        &[
            "cells of another study: seed is 1 there, and 7 here",
            "--fresh",
        ],
    );
    shard(&desk, "--target 1e-5", "1/2").expect(
        2,
        &[
            "cannot use out/cells-0-of-2.jsonl: it has cells of another study: targets[0] is 0.01 there",
            "move that file elsewhere",
        ],
    );
    let path = desk.path("out/cells-1-of-2.jsonl");
    assert!(!path.exists());
    // Who began at once saw no other.
    let line = format!("{STUDY} --device cpu --report beside --shard 1/2 --target 1e-5");
    desk.run(&line).expect(0, &[]);
    fs::copy(desk.path("beside/cells-1-of-2.jsonl"), &path).expect("copied");
    desk.run("merge out").expect(
        2,
        &[
            "cannot use out/cells-1-of-2.jsonl",
            "cells of another study than out/cells-0-of-2.jsonl: targets[0] is 0.01 there",
        ],
    );
    shard(&desk, "--fresh", "1/2").expect(0, &[]);
    desk.run("merge out").expect(0, &[]);
    // Another version.
    let good = fs::read_to_string(&path).expect("cells");
    let program = format!("\"program\":\"{} ", env!("CARGO_PKG_VERSION"));
    let older = good.replace(&program, "\"program\":\"0.0.9 ");
    assert_ne!(older, good);
    fs::write(&path, &older).expect("written");
    desk.run("merge out").expect(
        2,
        &["out/cells-1-of-2.jsonl: `x-squared, halton` was measured by program 0.0.9"],
    );
    let run = shard(&desk, "", "1/2");
    run.tells(
        0,
        &[
            "3 cells of out/cells-1-of-2.jsonl were of other kernels",
            ": measured",
        ],
    );
    desk.run("merge out").expect(0, &[]);
    // A cell of none of its study's keys, and a file of others.
    let mut lines: Vec<&str> = good.lines().collect();
    let other = lines[1].replace("\"key\":\"", "\"key\":\"0");
    lines.push(&other);
    fs::write(&path, lines.join("\n")).expect("written");
    desk.run("merge out")
        .expect(2, &["it has a cell that is none of its study's"]);
    fs::write(&path, "mine\n").expect("written");
    let words = ["its first line is none of \"corput-cells/1\""];
    desk.run("merge out").expect(2, &words);
    shard(&desk, "", "1/2").expect(2, &words);
    assert_eq!(desk.bytes("out/cells-1-of-2.jsonl"), b"mine\n");
}

#[test]
fn a_map_that_has_changed_is_refused() {
    let desk = Desk::new();
    fs::copy(
        crate::repository("tests/data/sunrise.exr"),
        desk.path("a.exr"),
    )
    .expect("a map");
    let line = "converge --integrand irradiance:map=a.exr --estimator mis --sampler random,halton \
                --max-count 64 --replicates 2 --device cpu --report out --shard";
    desk.run(&format!("{line} 0/1")).expect(0, &[]);
    desk.run("merge out").expect(0, &[]);
    fs::copy(
        crate::repository("tests/data/studio.exr"),
        desk.path("a.exr"),
    )
    .expect("a map");
    desk.run("merge out").expect(
        2,
        &[
            "cannot be made again: integrands[0].tables is",
            "the maps that the shards had",
        ],
    );
}

#[test]
fn shards_that_cannot_be() {
    let desk = Desk::new();
    shard(&desk, "", "2/2").expect(2, &["shard 2/2", "the last of 2 is 1/2"]);
    shard(&desk, "", "0/0").expect(2, &["at least one shard"]);
    shard(&desk, "", "-1/2").expect(2, &["-1/2"]);
    desk.run(&format!("{STUDY} --device cpu --shard 0/2"))
        .expect(2, &["--report"]);
    fs::create_dir(desk.path("empty")).expect("a folder");
    desk.run("merge empty --shards 0")
        .expect(2, &["empty/zarr.json"]);
    fs::write(desk.path("empty/cells-0-of-2.jsonl"), "").expect("written");
    desk.run("merge empty")
        .expect(2, &["no shard has kept a cell in it"]);
    shard(&desk, "", "0/2").expect(0, &[]);
    desk.run("merge out --shards 0")
        .expect(2, &["at least one shard"]);
    desk.run("merge out empty")
        .expect(2, &["merge the folder out with others"]);
    assert!(
        desk.names()
            .iter()
            .all(|name| ["out", "empty"].contains(&name.as_str()))
    );
}
