//! What is refused, with nothing written.

use super::Desk;
use std::fs;

#[test]
fn a_shard_of_other_arguments() {
    let desk = Desk::new();
    let line = |rest: &str| format!("generate sobol --device cpu --out s.zarr {rest}");
    desk.say(&line("--count 2100000 --dims 2 --shard 0/2"));
    let before = desk.tree("s.zarr");
    for (rest, words) in [
        (
            "--count 2100001 --dims 2",
            ["attributes.corput.arguments.count is 2100000 there, and 2100001 is wanted"],
        ),
        ("--count 2100000 --dims 3", ["arguments.dims is 2 there"]),
        (
            "--count 2100000 --dims 2 --scramble owen --seed 1",
            ["arguments.scramble is \"none\" there"],
        ),
        (
            "--count 2100000 --dims 2 --fractions",
            ["arguments.type is \"f32\" there"],
        ),
    ] {
        let run = desk.run(&line(&format!("{rest} --shard 1/2")));
        run.expect(2, &words);
        run.expect(2, &["another array", "another folder with --out"]);
        assert!(desk.tree("s.zarr") == before, "{rest}");
    }
    // Attributes that others add do not count; a shape that others change does.
    let path = desk.path("s.zarr/zarr.json");
    let text = fs::read_to_string(&path).expect("metadata");
    let added = text.replace(
        "\"attributes\": {",
        "\"storage_transformers\": [], \"attributes\": { \"by\": \"me\",",
    );
    fs::write(&path, added).expect("written");
    desk.say(&line("--count 2100000 --dims 2 --shard 1/2"));
    desk.merged("s.zarr");
    fs::write(&path, text.replace("float32", "uint32")).expect("written");
    let run = desk.run(&line("--count 2100000 --dims 2"));
    run.expect(2, &["data_type is \"uint32\" there"]);
    desk.run("merge s.zarr").expect(2, &["fill_value is 0.0"]);
    let own = format!("\"version\": \"{}\"", env!("CARGO_PKG_VERSION"));
    let older = text.replace(&own, "\"version\": \"0.0.9\"");
    assert_ne!(older, text);
    fs::write(&path, older).expect("written");
    let run = desk.run(&line("--count 2100000 --dims 2"));
    run.expect(
        2,
        &[
            "version is \"0.0.9\" there",
            "fill it with the version of corput",
        ],
    );
    fs::write(&path, "{ \"zarr_for").expect("written");
    let run = desk.run(&line("--count 2100000 --dims 2"));
    run.expect(2, &["it is no JSON document"]);
}

/// Native functions have the bits of one device, so no other may add to the store.
#[test]
fn a_native_shard_of_another_device() {
    if super::skips() {
        return;
    }
    let desk = Desk::new();
    let line = "generate sobol --count 2100000 --map cone --param theta_max=0.5 --profile native --out s.zarr";
    desk.say(&format!("{line} --device cpu --shard 0/2"));
    let before = desk.tree("s.zarr");
    let run = desk.run(&format!("{line} --device llvmpipe --shard 1/2"));
    run.expect(2, &["arguments.device is \"cpu\" there", "llvmpipe"]);
    assert!(desk.tree("s.zarr") == before);
}

#[test]
fn shards_that_are_none() {
    for (shard, words) in [
        ("2/2", ["shards count from 0", "the last of 2 is 1/2"]),
        ("0/0", ["at least one shard", "--shard 0/1"]),
        ("1", ["its index and their number, as 3/8", "count from 0"]),
        ("-1/4", ["shard `-1/4`", "count from 0"]),
        ("1/4/5", ["shard `1/4/5`", "count from 0"]),
    ] {
        let desk = Desk::new();
        let line = format!("generate sobol --count 8 --device cpu --out s.zarr --shard {shard}");
        desk.run(&line).expect(2, &words);
        let line = "estimate --integrand x-squared --sampler sobol --count 8 --device cpu";
        desk.run(&format!("{line} --shard {shard}"))
            .expect(2, &words);
        assert!(!desk.path("s.zarr").exists());
    }
}

#[test]
fn what_no_store_can_be() {
    let desk = Desk::new();
    fs::write(desk.path("file"), "mine").expect("written");
    fs::create_dir(desk.path("folder")).expect("made");
    fs::write(desk.path("folder/notes"), "mine").expect("written");
    for (line, words) in [
        (
            "sobol --count 8 --out p.npy --shard 0/2",
            ["no other format", "--out store.zarr"],
        ),
        (
            "sobol --count 8 --out s.zarr --format npy --shard 0/2",
            ["no other format", "drop --shard"],
        ),
        (
            "sobol --count 8 --out - --format zarr",
            ["it is a folder", "--out store.zarr"],
        ),
        (
            "sobol --count 8 --out s.zarr --type u8",
            ["unknown type `u8`", "f32, u32, u16, f64"],
        ),
        (
            "sobol --count 8 --out s.zarr --chunk-rows 4",
            ["--chunk-rows for a Zarr store", "drop --chunk-rows"],
        ),
        (
            "blue-noise --count 8 --out s.zarr",
            ["blue-noise as a Zarr store", "all at once"],
        ),
        (
            "blue-noise-mask --size 8 --out s.zarr",
            ["blue-noise-mask as a Zarr store", "all at once"],
        ),
        (
            "sobol --count 8 --out file --format zarr",
            ["cannot write file", "no folder"],
        ),
        (
            "sobol --count 8 --out folder --format zarr",
            ["it holds `notes`, and has no zarr.json", "is empty"],
        ),
        (
            "sobol --count 8 --out file/s.zarr",
            ["file/s.zarr", "--out"],
        ),
        ("sobol --count 0 --out s.zarr", ["--count is 0", "at least"]),
    ] {
        let run = desk.run(&format!("generate {line} --device cpu"));
        run.expect(2, &words);
    }
    assert_eq!(fs::read(desk.path("file")).expect("a file"), b"mine");
    assert_eq!(desk.tree("").len(), 2, "{:?}", desk.tree(""));
}

#[test]
fn what_cannot_be_merged() {
    let desk = Desk::new();
    desk.say("generate vdc --count 8 --device cpu --out s.zarr");
    fs::create_dir(desk.path("empty")).expect("made");
    fs::write(desk.path("text"), "no JSON").expect("written");
    for (line, words) in [
        ("empty", ["empty/zarr.json", "there is no such file"]),
        (
            "s.zarr text",
            ["the folder s.zarr with others", "give it alone"],
        ),
        ("s.zarr --shards 0", ["shard 0/0", "at least one shard"]),
        ("text", ["cannot use text", "corput estimate --json"]),
        ("missing", ["cannot use missing", "No such file"]),
        ("text --shards 4", ["--shards with estimates", "drop it"]),
    ] {
        desk.run(&format!("merge {line}")).expect(2, &words);
    }
    // A foreign array, as zarr-python makes it.
    let other = "{\"zarr_format\":3,\"node_type\":\"array\",\"shape\":[4,4],\"data_type\":\"float32\",\
                 \"attributes\":{}}";
    fs::write(desk.path("empty/zarr.json"), other).expect("written");
    let run = desk.run("merge empty");
    run.expect(2, &["no attribute `corput`", "corput generate --out"]);
    let huge = other.replace("[4,4]", "[18446744073709551615,4294967295]");
    fs::write(desk.path("empty/zarr.json"), huge).expect("written");
    desk.run("merge empty")
        .expect(2, &["at most 2^63 bytes and 2^61 words"]);
}
