//! `corput verify`: a file or a store made again from what is recorded of it, and compared.

use super::args::{GenerateArgs, VerifyArgs};
use super::arguments::Places;
use super::generate::Maker;
use super::{arguments, generate, host, mask, pixels, points, print, progress};
use corput::catalog::{Engine, Profile};
use corput::report::{Comparison, Form, Layout, Origin, Sidecar, Whole, zarr};
use corput::{Error, Result};
use serde_json::Value;
use std::ops::Range;
use std::path::{Path, PathBuf};

pub fn run(args: &VerifyArgs) -> anyhow::Result<()> {
    match args.file.is_dir() {
        true => store(args),
        false => file(args),
    }
}

fn file(args: &VerifyArgs) -> anyhow::Result<()> {
    // Beside what a link leads to is where `generate` puts the sidecar.
    let file = match args.file.is_symlink() {
        true => args.file.canonicalize().unwrap_or(args.file.clone()),
        false => args.file.clone(),
    };
    let origin = Origin::of(&file)?;
    if origin.arguments["sequence"] == mask::NAME {
        return whole(args, &file, "a mask", &|format| {
            let mut made = arguments::parse(&origin.arguments, &places(args, &file))?;
            made.device.clone_from(&args.device);
            Ok(mask::again(&made, format)?)
        });
    }
    if pixels::is_picture(&origin.arguments) {
        places(args, &file).refuse()?;
        return whole(args, &file, "a picture", &|format| {
            pixels::again(&origin.arguments, args.device.as_deref(), format)
        });
    }
    let sidecar = Sidecar::of(&file)?;
    let recorded = Recorded {
        file: file.clone(),
        document: Sidecar::path_of(&file),
        remedy: "take the FILE.json that was written with the file",
        version: &sidecar.version,
        arguments: &sidecar.origin.arguments,
        device: &sidecar.origin.device,
        layout: sidecar.layout,
    };
    let (mut maker, rows) = recorded.again(args)?;
    let mut comparison = Comparison::open(&file, &sidecar, rows.clone())?;
    let mut take = |words: &[u32]| comparison.take(words);
    compare(maker.engine.as_mut(), &rows, sidecar.layout, &mut take)?;
    comparison.finish()?;
    maker.validated()?;
    say(args, &rows, sidecar.layout, &sidecar.sha256);
    Ok(())
}

/// The bytes of a file, and what they are.
type Made = (Vec<u8>, Form);

/// A file that is made at once, of which no rows can be made alone; `again` makes it in a format.
fn whole(
    args: &VerifyArgs,
    file: &Path,
    what: &str,
    again: &dyn Fn(&str) -> anyhow::Result<Made>,
) -> anyhow::Result<()> {
    let shown = args.file.display();
    if args.range.is_some() {
        return Err(Error::Arguments {
            asked: format!("--range of {shown}"),
            limit: format!("{what} is made whole"),
            remedy: "drop --range".into(),
        }
        .into());
    }
    let recorded = Whole::of(file)?;
    warn_of_version(args, &recorded.version);
    let (bytes, form) = again(&recorded.format)?;
    recorded.compare(file, &bytes, &form)?;
    print(&format!(
        "{shown}: all {} bytes are equal; SHA-256 {}",
        recorded.bytes, recorded.sha256
    ));
    Ok(())
}

/// Where the picture of a file may lie.
fn places<'a>(args: &'a VerifyArgs, file: &'a Path) -> Places<'a> {
    Places {
        given: args.env.as_deref(),
        folder: file.parent().unwrap_or(Path::new("")),
    }
}

fn warn_of_version(args: &VerifyArgs, version: &str) {
    let own = env!("CARGO_PKG_VERSION");
    if version != own {
        let shown = args.file.display();
        eprintln!(
            "corput: warning: {shown} was made by version {version}, and this is {own}: points may differ"
        );
    }
}

fn store(args: &VerifyArgs) -> anyhow::Result<()> {
    let store = zarr::Store::open(&args.file)?;
    let origin = store.origin();
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let recorded = Recorded {
        file: args.file.clone(),
        document: args.file.join("zarr.json"),
        remedy: "take the zarr.json that was written with the store",
        version: &text(&origin["version"]),
        arguments: &origin["arguments"],
        // Of the exact profile it has none, and need not.
        device: &text(&origin["arguments"]["device"]),
        layout: store.layout(),
    };
    let (mut maker, rows) = recorded.again(args)?;
    let mut comparison = zarr::Comparison::new(&store, rows.clone())?;
    let mut take = |words: &[u32]| comparison.take(words);
    compare(maker.engine.as_mut(), &rows, store.layout(), &mut take)?;
    let sha256 = comparison.finish()?;
    maker.validated()?;
    say(args, &rows, store.layout(), &sha256.unwrap_or_default());
    Ok(())
}

/// What is recorded of points.
struct Recorded<'a> {
    /// The file, or the folder of a store.
    file: PathBuf,
    /// Where they are recorded, and what to do where that cannot be.
    document: PathBuf,
    remedy: &'static str,
    version: &'a str,
    arguments: &'a Value,
    device: &'a str,
    layout: Layout,
}

impl Recorded<'_> {
    /// What makes the points again, and the rows to make. Warns where they may be others.
    fn again(&self, args: &VerifyArgs) -> Result<(Maker, Range<u64>)> {
        let shown = args.file.display();
        warn_of_version(args, self.version);
        let made = arguments::parse(self.arguments, &places(args, &self.file))?;
        let (maker, layout) = maker(&made, args.device.as_deref())?;
        if layout != self.layout {
            return Err(Error::Document {
                path: self.document.clone(),
                problem: format!(
                    "its arguments make {}, and it says {}",
                    shape(layout),
                    shape(self.layout)
                ),
                remedy: self.remedy,
            });
        }
        let by = arguments::device(maker.device.as_ref());
        if made.profile == Profile::Native.name() && by != self.device {
            eprintln!(
                "corput: warning: {shown} has the native functions of {}, and {by} may have others",
                self.device
            );
        }
        Ok((maker, args.range.clone().unwrap_or(0..layout.rows)))
    }
}

/// What makes the points again, and what it makes.
fn maker(made: &GenerateArgs, device: Option<&str>) -> Result<(Maker, Layout)> {
    if made.sequence == points::NAME {
        let (mut stored, layout) = points::prepare(made)?;
        points::place(made, &mut stored, layout)?;
        let maker = Maker {
            engine: host::Source::Host(Box::new(stored)),
            device: None,
        };
        return Ok((maker, layout));
    }
    let request = generate::request(made)?;
    let layout = generate::layout(&request, generate::element(made)?);
    Ok((Maker::new(&request, device)?, layout))
}

/// Makes the rows piece after piece, for `take` to compare.
fn compare(
    engine: &mut dyn Engine,
    rows: &Range<u64>,
    layout: Layout,
    take: &mut dyn FnMut(&[u32]) -> Result<()>,
) -> Result<()> {
    let bar = progress::points(rows.end - rows.start);
    let width = u64::from(layout.columns);
    engine.make_range(rows.clone(), &mut |words| {
        take(words)?;
        bar.inc(words.len() as u64 / width);
        Ok(())
    })?;
    bar.finish_and_clear();
    Ok(())
}

/// Prints that all is equal.
fn say(args: &VerifyArgs, rows: &Range<u64>, layout: Layout, sha256: &str) {
    let (shown, count) = (args.file.display(), rows.end - rows.start);
    print(&match args.range {
        Some(_) => format!(
            "{shown}: rows {}..{} are equal, {count} of {}",
            rows.start, rows.end, layout.rows
        ),
        None => format!("{shown}: all {count} rows are equal; SHA-256 {sha256}"),
    });
}

fn shape(layout: Layout) -> String {
    let Layout {
        rows,
        columns,
        element,
    } = layout;
    format!("{rows} x {columns} of {}", element.descr())
}
