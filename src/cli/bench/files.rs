//! `corput bench --files DIR`: a file larger than memory and one of a few points, each from the
//! start of the process to its last synced byte, beside a plain write of as many bytes in the same
//! folder.

use super::{align_right, machine};
use crate::cli::args::BenchArgs;
use crate::cli::{host, interrupt, print};
use comfy_table::{Table, presets};
use corput::catalog::{Options, Request, Sequence};
use corput::report::{create_folder, hexadecimal};
use corput::{Error, Result};
use serde_json::json;
use sha2::{Digest, Sha256};
use std::ffi::OsStr;
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// Rounds; medians are reported.
const ROUNDS: usize = 3;
const FEW_ROUNDS: usize = 9;

/// Bytes of a write.
const BLOCK: usize = 8 << 20;

/// Columns of the large file, and bytes of its header.
const COLUMNS: u64 = 4;
const HEADER: u64 = 4096;

/// The goals: times a plain write, and seconds.
const MOST: f64 = 1.3;
const FEW_S: f64 = 0.15;

/// What was measured.
struct Found {
    bytes: u64,
    points: u64,
    made: Vec<f64>,
    plain: Vec<f64>,
    few: Vec<f64>,
}

impl Found {
    fn ratio(&self) -> f64 {
        median(&self.made) / median(&self.plain)
    }
}

pub fn run(args: &BenchArgs, folder: &Path) -> anyhow::Result<()> {
    let points = args.size.div_ceil(4 * COLUMNS).max(1);
    // What cannot be made is said before anything is written.
    let request = Request::new(&Options {
        dimensions: Some(COLUMNS),
        ..Options::new(Sequence::Sobol, points)
    })?;
    let device = match host::open_or_cpu(args.device.as_deref(), request.profile)? {
        Some(device) => host::line(device.info()),
        None => "cpu".to_owned(),
    };
    create_folder(folder, "--files")?;
    // An interrupt ends the commands that run; what they wrote is removed as after any failure.
    interrupt::clean_up();
    // A name that nobody else has, for all that is made.
    let folder = folder.join(format!("corput-bench-{}", std::process::id()));
    create_folder(&folder, "--files")?;
    let found = measured(args, &folder, points);
    // What was made is of no use any more, whether or not it was measured.
    let removed = std::fs::remove_dir_all(&folder);
    let found = found?;
    removed.map_err(|source| Error::Io {
        action: "remove",
        path: folder,
        source,
    })?;
    told(args, device, &found)
}

fn measured(args: &BenchArgs, folder: &Path, points: u64) -> anyhow::Result<Found> {
    let few = folder.join("few.npy");
    let large = folder.join("large.npy");
    // Verified first: the small file's bytes are the CPU's, and so are some of the large one's.
    generate(args.device.as_deref(), 1024, 2, &few)?;
    let there = hash(&few)?;
    generate(Some("cpu"), 1024, 2, &few)?;
    if hash(&few)? != there {
        anyhow::bail!("1,024 points of the device are not those of the CPU: run `corput check`");
    }
    let mut found = Found {
        bytes: HEADER + 4 * COLUMNS * points,
        points,
        made: Vec::new(),
        plain: Vec::new(),
        few: Vec::new(),
    };
    for _ in 0..FEW_ROUNDS {
        let begun = Instant::now();
        generate(args.device.as_deref(), 1024, 2, &few)?;
        found.few.push(begun.elapsed().as_secs_f64());
    }
    for round in 0..ROUNDS {
        let plain = folder.join("plain.bin");
        found.plain.push(written(&plain, found.bytes)?);
        remove(&plain)?;
        let begun = Instant::now();
        generate(args.device.as_deref(), points, COLUMNS, &large)?;
        found.made.push(begun.elapsed().as_secs_f64());
        if round == 0 {
            let end = points.min(1 << 20);
            let range = format!("0..{end}");
            command(&[
                OsStr::new("verify"),
                large.as_os_str(),
                OsStr::new("--range"),
                OsStr::new(&range),
            ])?;
        }
        remove(&large)?;
    }
    Ok(found)
}

/// Sobol points into a file, by a process of its own.
fn generate(device: Option<&str>, points: u64, columns: u64, path: &Path) -> anyhow::Result<()> {
    let [points, columns] = [points, columns].map(|number| number.to_string());
    let words = [
        "generate", "sobol", "--count", &points, "--dims", &columns, "--out",
    ];
    let mut all: Vec<&OsStr> = words.iter().map(OsStr::new).collect();
    all.push(path.as_os_str());
    if let Some(device) = device {
        all.extend([OsStr::new("--device"), OsStr::new(device)]);
    }
    command(&all)
}

fn command(words: &[&OsStr]) -> anyhow::Result<()> {
    let itself = std::env::current_exe().map_err(|source| Error::Io {
        action: "find",
        path: "corput".into(),
        source,
    })?;
    let run = Command::new(&itself).args(words).output();
    let run = run.map_err(|source| Error::Io {
        action: "run",
        path: itself,
        source,
    })?;
    if run.status.success() {
        return Ok(());
    }
    let line: Vec<_> = words.iter().map(|word| word.to_string_lossy()).collect();
    anyhow::bail!(
        "`corput {}` failed: {}",
        line.join(" "),
        String::from_utf8_lossy(&run.stderr).trim()
    );
}

/// Seconds of a sequential write of so many bytes, synced.
fn written(path: &Path, bytes: u64) -> Result<f64> {
    let failed = |source| Error::Io {
        action: "write",
        path: path.to_owned(),
        source,
    };
    // No disk has these bytes for the asking, as it may zeros.
    let block: Vec<u8> = (0..BLOCK as u32 / 4)
        .flat_map(|word| word.wrapping_mul(0x9e37_79b9).to_le_bytes())
        .collect();
    let begun = Instant::now();
    let mut file = File::create(path).map_err(failed)?;
    let mut left = bytes;
    while left > 0 {
        interrupt::stop(bytes - left, bytes)?;
        let some = left.min(BLOCK as u64);
        let part = block.get(..some as usize).unwrap_or(&block);
        file.write_all(part).map_err(failed)?;
        left -= some;
    }
    file.sync_all().map_err(failed)?;
    Ok(begun.elapsed().as_secs_f64())
}

fn remove(path: &PathBuf) -> Result<()> {
    std::fs::remove_file(path).map_err(|source| Error::Io {
        action: "remove",
        path: path.clone(),
        source,
    })
}

fn hash(path: &Path) -> Result<String> {
    let bytes = std::fs::read(path).map_err(|source| Error::Io {
        action: "read",
        path: path.to_owned(),
        source,
    })?;
    Ok(hexadecimal(&Sha256::digest(bytes)))
}

fn median(times: &[f64]) -> f64 {
    let mut sorted = times.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN)
}

fn told(args: &BenchArgs, device: String, found: &Found) -> anyhow::Result<()> {
    let machine = machine(device);
    let [made, plain, few] = [&found.made, &found.plain, &found.few].map(|times| median(times));
    let reached = [found.ratio() <= MOST, few <= FEW_S];
    if args.json {
        let document = json!({
            "schema": "corput-files/1",
            "version": env!("CARGO_PKG_VERSION"),
            "device": machine.device,
            "command": machine.command,
            "large": {
                "bytes": found.bytes, "points": found.points, "dimensions": COLUMNS,
                "seconds": found.made, "plain_write_seconds": found.plain,
                "median_s": made, "plain_write_median_s": plain,
                "x_plain_write": found.ratio(), "at_most": MOST, "goal_reached": reached[0],
            },
            "few": {
                "points": 1024, "dimensions": 2, "seconds": found.few, "median_s": few,
                "at_most_s": FEW_S, "goal_reached": reached[1],
            },
        });
        print(&serde_json::to_string_pretty(&document)?);
        return Ok(());
    }
    let said = |reached: bool| if reached { "reached" } else { "MISSED" };
    let range = |times: &[f64]| {
        let least = times.iter().copied().fold(f64::INFINITY, f64::min);
        let most = times.iter().copied().fold(0.0, f64::max);
        format!("{least:.3} to {most:.3}")
    };
    let mut table = Table::new();
    let header = [
        "start to last byte",
        "median s",
        "all s",
        "x plain write",
        "goal",
    ];
    table.load_style(presets::NOTHING).set_header(header);
    table.add_row([
        format!("plain write of {} bytes, synced", found.bytes),
        format!("{plain:.3}"),
        range(&found.plain),
        "1.00".into(),
        String::new(),
    ]);
    table.add_row([
        format!("generate sobol --count {} --dims {COLUMNS}", found.points),
        format!("{made:.3}"),
        range(&found.made),
        format!("{:.2}", found.ratio()),
        format!("<= {MOST}: {}", said(reached[0])),
    ]);
    table.add_row([
        "generate sobol --count 1024 --dims 2".into(),
        format!("{few:.3}"),
        range(&found.few),
        String::new(),
        format!("<= {FEW_S} s: {}", said(reached[1])),
    ]);
    align_right(&mut table, 1..4);
    print(&format!("{}\n{table}", machine.device));
    Ok(())
}
