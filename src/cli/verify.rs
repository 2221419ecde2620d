//! `corput verify`: a file made again from its sidecar, and compared.

use super::args::{GenerateArgs, VerifyArgs};
use super::generate::Maker;
use super::{arguments, generate, points, print, progress};
use corput::catalog::{Engine, Profile};
use corput::report::{Comparison, Layout, Sidecar};
use corput::{Error, Result};

pub fn run(args: &VerifyArgs) -> anyhow::Result<()> {
    if args.file.is_dir() {
        return Err(Error::Arguments {
            asked: format!("verify {}", args.file.display()),
            limit: "it is a folder, and files are what is made again".into(),
            remedy: "`corput merge STORE` checks the hashes of a Zarr store".into(),
        }
        .into());
    }
    // Beside what a link leads to is where `generate` puts the sidecar.
    let file = match args.file.is_symlink() {
        true => args.file.canonicalize().unwrap_or(args.file.clone()),
        false => args.file.clone(),
    };
    let sidecar = Sidecar::of(&file)?;
    let shown = args.file.display();
    if sidecar.version != env!("CARGO_PKG_VERSION") {
        eprintln!(
            "corput: warning: {shown} was made by version {}, and this is {}: points may differ",
            sidecar.version,
            env!("CARGO_PKG_VERSION")
        );
    }
    let made = arguments::parse(&sidecar.origin.arguments)?;
    let (mut maker, layout) = maker(&made, args.device.as_deref())?;
    if layout != sidecar.layout {
        return Err(Error::Document {
            path: Sidecar::path_of(&file),
            problem: format!(
                "its arguments make {}, and it says {}",
                say(layout),
                say(sidecar.layout)
            ),
            remedy: "take the FILE.json that was written with the file",
        }
        .into());
    }
    let by = arguments::device(maker.device.as_ref());
    if made.profile == Profile::Native.name() && by != sidecar.origin.device {
        eprintln!(
            "corput: warning: {shown} has the native functions of {}, and {by} may have others",
            sidecar.origin.device
        );
    }
    let rows = args.range.clone().unwrap_or(0..layout.rows);
    let comparison = Comparison::open(&file, &sidecar, rows.clone())?;
    compare(maker.engine.as_mut(), comparison, rows.clone(), layout)?;
    maker.validated()?;
    let count = rows.end - rows.start;
    print(&match args.range {
        Some(_) => format!(
            "{shown}: rows {}..{} are equal, {count} of {}",
            rows.start, rows.end, layout.rows
        ),
        None => format!(
            "{shown}: all {count} rows are equal; SHA-256 {}",
            sidecar.sha256
        ),
    });
    Ok(())
}

/// What makes the points again, and what it makes.
fn maker(made: &GenerateArgs, device: Option<&str>) -> Result<(Maker, Layout)> {
    if made.sequence == points::NAME {
        let (mut stored, layout) = points::prepare(made)?;
        points::place(made, &mut stored, layout)?;
        let maker = Maker {
            engine: Box::new(stored),
            device: None,
        };
        return Ok((maker, layout));
    }
    let request = generate::request(made)?;
    let layout = generate::layout(&request, generate::element(made)?);
    Ok((Maker::new(&request, device)?, layout))
}

fn compare(
    engine: &mut dyn Engine,
    mut comparison: Comparison,
    rows: std::ops::Range<u64>,
    layout: Layout,
) -> Result<()> {
    let bar = progress::points(rows.end - rows.start);
    let width = u64::from(layout.columns);
    let mut done = rows.start;
    while done < rows.end {
        let points = engine.chunk().clamp(1, rows.end - done);
        engine.make(done, points, &mut |words| {
            comparison.take(words)?;
            bar.inc(words.len() as u64 / width);
            Ok(())
        })?;
        done += points;
    }
    bar.finish_and_clear();
    comparison.finish()
}

fn say(layout: Layout) -> String {
    let Layout {
        rows,
        columns,
        element,
    } = layout;
    format!("{rows} x {columns} of {}", element.descr())
}
