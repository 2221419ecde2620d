//! `corput generate` into a Zarr store: the chunks of a shard, those that are there kept.

use super::args::GenerateArgs;
use super::generate::{Maker, element, layout};
use super::{arguments, interrupt, mask, points, progress};
use corput::catalog::{Engine, Request, Shard};
use corput::report::zarr::Store;
use corput::vulkan::Device;
use corput::{Error, Result};
use serde_json::{Value, json};
use std::num::NonZero;
use std::ops::Range;
use std::panic::resume_unwind;
use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, SyncSender, channel, sync_channel};
use std::thread;

/// The name of the format, and the ending that stands for it.
const FORMAT: &str = "zarr";

/// Whether a store is asked for. Refuses what only stores have, and what no store can have.
pub fn asked(args: &GenerateArgs) -> Result<bool> {
    let ending = || {
        let ending = args.out.extension();
        ending.is_some_and(|ending| ending.eq_ignore_ascii_case(FORMAT))
    };
    let refused = |asked: String, limit: &str, remedy: &str| {
        Err(Error::Arguments {
            asked,
            limit: limit.to_owned(),
            remedy: remedy.to_owned(),
        })
    };
    let store = args
        .format
        .as_ref()
        .map_or_else(ending, |name| name == FORMAT);
    let whole = [points::NAME, mask::NAME].contains(&args.sequence.as_str());
    match args.shard {
        _ if store && whole => refused(
            format!("{} as a Zarr store", args.sequence),
            "its points are made all at once, on one machine",
            "write a file with --out p.npy",
        ),
        _ if store && args.out.as_os_str() == "-" => refused(
            "a Zarr store on standard output".to_owned(),
            "it is a folder",
            "name one, as --out store.zarr",
        ),
        _ if store && args.chunk_rows.is_some() => refused(
            "--chunk-rows for a Zarr store".to_owned(),
            "its chunks follow from columns and type, so that all machines have the same",
            "drop --chunk-rows",
        ),
        Some(shard) if !store => refused(
            format!("--shard {shard} into {}", args.out.display()),
            "several machines can write one Zarr store, and no other format",
            "give --out store.zarr, or drop --shard",
        ),
        _ => Ok(store),
    }
}

pub fn run(args: &GenerateArgs, request: &Request) -> anyhow::Result<()> {
    let mut maker = Maker::new(request, args.device.as_deref())?;
    let origin = origin(args, request, maker.device.as_ref())?;
    interrupt::clean_up();
    let layout = layout(request, element(args)?);
    let shards = args.shard.and_then(|shard| NonZero::new(shard.parts().1));
    let store = match shards {
        Some(shards) => Store::create_in_shards(&args.out, layout, &origin, shards)?,
        None => Store::create(&args.out, layout, &origin)?,
    };
    let shard = args.shard.unwrap_or(Shard::WHOLE);
    let chunks = shard.of(store.chunks());
    if chunks.is_empty() {
        eprintln!(
            "corput: shard {shard} is empty: the store has {} chunks, which other shards make",
            store.chunks()
        );
    } else {
        fill(&store, chunks, maker.engine.as_mut(), &args.out)?;
    }
    Ok(maker.validated()?)
}

/// A chunk and its words.
type Made = (u64, Vec<u32>);

/// Makes those of the chunks that are not there as they should be. One is hashed and written
/// while the next is made.
fn fill(store: &Store, chunks: Range<u64>, engine: &mut dyn Engine, path: &Path) -> Result<()> {
    let total = length(&chunks);
    let kept = thread::scope(|scope| {
        let (queue, made) = sync_channel(1);
        let (spent, spare) = channel();
        let write = move |(chunk, words): Made| {
            store.put(chunk, &words)?;
            // The next chunk takes the memory, if there is one.
            let _ = spent.send(words);
            Ok(())
        };
        let writer = scope.spawn(move || made.into_iter().try_for_each(write));
        let kept = produce(store, chunks, engine, path, (queue, &spare));
        // A panic of the thread is a bug, and one here too.
        let written = writer.join().unwrap_or_else(|panic| resume_unwind(panic));
        written.and(kept)
    })?;
    if kept > 0 {
        eprintln!("corput: {kept} of {total} chunks were there already, and whole");
    }
    Ok(())
}

/// Hands on the chunks that are to be written, and says how many are not.
fn produce(
    store: &Store,
    chunks: Range<u64>,
    engine: &mut dyn Engine,
    path: &Path,
    (queue, spare): (SyncSender<Made>, &Receiver<Vec<u32>>),
) -> Result<u64> {
    let points = store.rows(chunks.start).start..store.rows(chunks.end - 1).end;
    let bar = progress::points(length(&points));
    let mut kept = 0;
    for chunk in chunks.clone() {
        let rows = store.rows(chunk);
        let step = |words: u64| {
            bar.inc(words / u64::from(store.layout().columns));
            stop(chunk - chunks.start, length(&chunks), path)
        };
        step(0)?;
        if store.fault(chunk)?.is_none() {
            kept += 1;
            bar.inc(length(&rows));
            continue;
        }
        let mut words = spare.try_recv().unwrap_or_default();
        make(engine, &rows, &step, &mut words)?;
        if queue.send((chunk, words)).is_err() {
            // The writer has met an error, which it returns.
            break;
        }
    }
    bar.finish_and_clear();
    Ok(kept)
}

/// Stops where the user wants it to; what is done stays.
fn stop(done: u64, total: u64, path: &Path) -> Result<()> {
    interrupt::stop(done, total).map_err(|_| Error::Paused {
        done,
        total,
        path: path.to_owned(),
        fresh: false,
    })
}

/// The words of consecutive points in place of those that there are; `step` is told how many each
/// piece of them has.
fn make(
    engine: &mut dyn Engine,
    rows: &Range<u64>,
    step: &dyn Fn(u64) -> Result<()>,
    words: &mut Vec<u32>,
) -> Result<()> {
    words.clear();
    engine.make_range(rows.clone(), &mut |piece| {
        words.extend_from_slice(piece);
        step(piece.len() as u64)
    })
}

fn length(range: &Range<u64>) -> u64 {
    range.end - range.start
}

/// What makes the array again, with nothing in it that differs between machines: no device in
/// the exact profile, and a picture by what it holds.
fn origin(args: &GenerateArgs, request: &Request, device: Option<&Arc<Device>>) -> Result<Value> {
    let mut arguments = arguments::origin(args, Some(request.scramble), device)?.arguments;
    if let Some(path) = &args.env {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        arguments["env"] = json!(name);
    }
    Ok(json!({ "version": env!("CARGO_PKG_VERSION"), "arguments": arguments }))
}
