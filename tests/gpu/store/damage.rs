//! What `corput merge` finds, and what makes it whole again.

use super::{Desk, Run, Worker};
use serde_json::{Value, json};
use std::fs::{self, OpenOptions};
use std::io::{Seek, SeekFrom, Write};

/// Three chunks, the last not full.
const LINE: &str = "generate sobol --count 5000000 --dims 2 --device cpu --out s.zarr";

/// A store with one fault, and what the merge of three shards says of it.
fn damaged(break_it: impl FnOnce(&Desk), words: &[&str]) {
    let desk = Desk::new();
    desk.say(LINE);
    let hash = desk.merged("s.zarr");
    let whole = desk.tree("s.zarr");
    break_it(&desk);
    let run = desk.run("merge s.zarr --shards 3");
    run.tells(1, words);
    run.tells(1, &["1 of 3 chunks are missing or not what they were"]);
    assert!(!run.text().contains("sha256 "), "{}", run.text());
    let record = desk.path("s.zarr/corput/array.json");
    assert!(!record.exists(), "it says that all chunks are there");
    // A reader that goes by the exit code, and one that goes by the document.
    let json = desk.run("merge s.zarr --json");
    json.tells(1, &["\"complete\": false", "\"sha256\": null"]);
    // The same command makes that chunk and keeps the others.
    let again = desk.run(LINE);
    again.expect(0, &["2 of 3 chunks were there already, and whole"]);
    assert_eq!(desk.merged("s.zarr"), hash);
    assert!(desk.tree("s.zarr") == whole);
}

fn flip(desk: &Desk, name: &str, at: u64) {
    let bytes = fs::read(desk.path(name)).expect("a file");
    let mut file = OpenOptions::new()
        .write(true)
        .open(desk.path(name))
        .expect("it opens");
    file.seek(SeekFrom::Start(at)).expect("a seek");
    file.write_all(&[bytes[at as usize] ^ 1]).expect("a write");
}

#[test]
fn a_description_of_more_than_there_is_takes_no_time() {
    let desk = Desk::new();
    desk.say("generate halton --count 4 --dims 1 --device cpu --out s.zarr");
    let path = desk.path("s.zarr/zarr.json");
    let text = fs::read_to_string(&path).expect("a description");
    let rows = 1u64 << 60;
    let most = text.replacen(
        "\"shape\": [\n    4,",
        &format!("\"shape\": [\n    {rows},"),
        1,
    );
    assert_ne!(most, text);
    fs::write(&path, most).expect("written");
    let line = "merge s.zarr --shards 2";
    let worker = Worker::start(&desk, line);
    let run = worker.end_within(std::time::Duration::from_secs(20), line);
    let last = rows / (1 << 22) - 1;
    run.tells(
        1,
        &[
            "chunk 0 is of an array with other arguments",
            &format!("chunks 1 to {last} are missing: --shard 0/2 to 1/2 make them again"),
        ],
    );
}

#[test]
fn a_flipped_bit_is_found() {
    let words = ["chunk 1 is damaged", "--shard 1/3 makes it again"];
    damaged(|desk| flip(desk, "s.zarr/c/1/0", 9_999_999), &words);
}

#[test]
fn a_flipped_bit_of_the_padding_is_found() {
    let words = ["chunk 2 is damaged", "--shard 2/3 makes it again"];
    damaged(|desk| flip(desk, "s.zarr/c/2/0", (1 << 24) - 1), &words);
}

#[test]
fn a_missing_chunk_is_named() {
    let words = ["chunk 0 is missing", "--shard 0/3 makes it again"];
    damaged(
        |desk| fs::remove_file(desk.path("s.zarr/c/0/0")).expect("removed"),
        &words,
    );
}

#[test]
fn a_cut_chunk_is_found() {
    let cut = |desk: &Desk| {
        let file = OpenOptions::new()
            .write(true)
            .open(desk.path("s.zarr/c/2/0"));
        file.expect("it opens").set_len(100).expect("cut");
    };
    damaged(cut, &["chunk 2 is of the wrong length (100 bytes)"]);
}

#[test]
fn a_chunk_without_a_record_is_made_again() {
    let words = ["chunk 1 is without a record", "--shard 1/3"];
    damaged(
        |desk| fs::remove_file(desk.path("s.zarr/corput/1.json")).expect("removed"),
        &words,
    );
    damaged(
        |desk| fs::write(desk.path("s.zarr/corput/1.json"), "{\"ar").expect("written"),
        &words,
    );
}

#[test]
fn a_chunk_of_other_arguments_is_found() {
    let swap = |desk: &Desk| {
        let other = LINE.replace("s.zarr", "o.zarr");
        desk.say(&format!("{other} --seed 1 --scramble shift"));
        for name in ["c/1/0", "corput/1.json"] {
            let from = desk.path(&format!("o.zarr/{name}"));
            fs::copy(from, desk.path(&format!("s.zarr/{name}"))).expect("copied");
        }
    };
    damaged(swap, &["chunk 1 is of an array with other arguments"]);
}

#[test]
fn what_was_left_goes_once_the_store_is_complete() {
    let desk = Desk::new();
    desk.say(&format!("{LINE} --shard 0/3"));
    let left = desk.path("s.zarr/corput/.0123456789abcdef.partial");
    fs::write(&left, "half").expect("written");
    desk.run("merge s.zarr").tells(1, &["2 of 3 chunks"]);
    // Another process may still be writing it.
    assert!(left.exists());
    desk.say(&format!("{LINE} --shard 1/3"));
    desk.say(&format!("{LINE} --shard 2/3"));
    desk.merged("s.zarr");
    assert!(!left.exists());
}

#[test]
fn runs_of_chunks_are_named_together() {
    let desk = Desk::new();
    let line = "generate vdc --count 4294967296 --device cpu --out s.zarr --shard 1023/1024";
    desk.say(line);
    let run: Run = desk.run("merge s.zarr --shards 8");
    run.tells(
        1,
        &["chunks 0 to 1022 are missing: --shard 0/8 to 7/8 make them again"],
    );
    run.tells(1, &["1 of 1024 chunks whole", "1023 of 1024"]);
    let run = desk.run("merge s.zarr");
    run.tells(1, &["--shard 0/1024 to 1022/1024"]);
}

#[test]
fn shards_are_named_of_the_number_that_the_store_was_begun_with() {
    let desk = Desk::new();
    let merge = |options: &str, chunks: &str, shards: &str| {
        let words = format!("{chunks} missing: --shard {shards}");
        desk.run(&format!("merge s.zarr {options}"))
            .tells(1, &[&words]);
    };
    desk.say(&format!("{LINE} --shard 0/2"));
    let path = desk.path("s.zarr/zarr.json");
    let metadata = fs::read(&path).expect("metadata");
    merge("", "chunks 1 to 2 are", "1/2 makes it again");
    // Not of as many as chunks, unless those are asked for.
    merge(
        "--shards 3",
        "chunks 1 to 2 are",
        "1/3 to 2/3 make them again",
    );
    let words = ["\"shards\": 2", "\"first_shard\": \"1/2\""];
    desk.run("merge s.zarr --json").tells(1, &words);
    // Shards of another number go on, and leave it.
    desk.say(&format!("{LINE} --shard 1/3"));
    assert_eq!(fs::read(&path).expect("metadata"), metadata);
    merge("", "chunk 2 is", "1/2 makes it again");
    // What is no number of shards is as none, which older stores have.
    let mut document: Value = serde_json::from_slice(&metadata).expect("JSON");
    for number in [json!(0), json!("2"), json!([2]), Value::Null] {
        document["attributes"]["corput_shards"] = number;
        fs::write(&path, document.to_string()).expect("written");
        merge("", "chunk 2 is", "2/3 makes it again");
    }
    let attributes = document["attributes"].as_object_mut();
    attributes.expect("attributes").remove("corput_shards");
    fs::write(&path, document.to_string()).expect("written");
    merge("", "chunk 2 is", "2/3 makes it again");
    merge("--shards 2", "chunk 2 is", "1/2 makes it again");
    desk.run(LINE).expect(0, &["2 of 3 chunks were there"]);
    desk.merged("s.zarr");
    // Of a store that no shard has begun nothing is noted.
    fs::remove_dir_all(desk.path("s.zarr")).expect("removed");
    desk.say(LINE);
    fs::remove_file(desk.path("s.zarr/c/1/0")).expect("removed");
    merge("", "chunk 1 is", "1/3 makes it again");
}

#[test]
#[cfg(unix)]
fn a_chunk_that_cannot_be_written_is_not_there() {
    let desk = Desk::new();
    let mut command = std::process::Command::new("sh");
    command
        .current_dir(desk.path(""))
        .args(["-c", "trap '' XFSZ; ulimit -f 64; exec \"$0\" \"$@\""])
        .arg(env!("CARGO_BIN_EXE_corput"))
        .args(LINE.split_whitespace());
    let run = Run::of(LINE, command);
    run.expect(4, &["cannot write s.zarr/c/0/0", "free space", "run again"]);
    let names: Vec<_> = desk.tree("s.zarr").into_keys().collect();
    assert_eq!(names, [std::path::Path::new("zarr.json")]);
    desk.run("merge s.zarr")
        .tells(1, &["chunks 0 to 2 are missing"]);
    desk.say(LINE);
    desk.merged("s.zarr");
}
