//! `corput plot`.

mod set;

use super::args::PlotArgs;
use super::interrupt;
use corput::plot::{SheetStyle, Stack, sheet, to_png};
use corput::report::save_with;
use corput::{Error, Result};
use set::Set;
use std::path::Path;

/// Pixels of a PNG per unit of the figure.
const SCALE: f32 = 2.0;

/// Sets that fit side by side.
const MAX_FILES: usize = 8;

/// The kinds, by name.
const KINDS: [&str; 4] = ["scatter", "pairs", "spectrum", "all"];

pub fn run(args: &PlotArgs) -> anyhow::Result<()> {
    let picture = Picture::from_path(&args.out)?;
    if let Some(kind) = args.kind.as_deref().filter(|kind| !KINDS.contains(kind)) {
        return Err(Error::unknown_name("kind", kind, &KINDS).into());
    }
    if args.files.len() > MAX_FILES {
        return Err(refused(
            format!("a plot of {} files", args.files.len()),
            format!("at most {MAX_FILES} fit side by side"),
            "plot some of them",
        )
        .into());
    }
    if args.points == Some(0) {
        return Err(Error::ZeroCount { what: "--points" }.into());
    }
    interrupt::clean_up();
    save_with(&args.out, || draw(args, picture))?;
    Ok(())
}

/// The bytes of the picture.
fn draw(args: &PlotArgs, picture: Picture) -> Result<Vec<u8>> {
    let sets = args
        .files
        .iter()
        .map(|path| Set::read(path, args))
        .collect::<Result<Vec<Set>>>()?;
    let names: Vec<String> = args.files.iter().map(|path| name(path)).collect();
    let single = sets.len() == 1;
    let stacks: Vec<Stack<'_>> = sets
        .iter()
        .zip(&names)
        .map(|(set, name)| Stack {
            title: if single { "" } else { name },
            caption: &set.caption,
            rows: set.rows(single),
        })
        .collect();
    let title = args.title.as_deref();
    let style = SheetStyle {
        title: title.unwrap_or(if single { &names[0] } else { "" }),
        size: args.size as f64,
        cells: args.cells,
    };
    let svg = sheet(&stacks, &style)?;
    match picture {
        Picture::Svg => Ok(svg.into_bytes()),
        Picture::Png => to_png(&svg, SCALE),
    }
}

#[derive(Clone, Copy)]
enum Picture {
    Svg,
    Png,
}

impl Picture {
    fn from_path(path: &Path) -> Result<Self> {
        let ending = path
            .extension()
            .map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        match ending.as_deref() {
            Some("svg") => Ok(Self::Svg),
            Some("png") => Ok(Self::Png),
            other => {
                let name = other.map_or_else(|| path.display().to_string(), |e| format!(".{e}"));
                Err(Error::unknown_name(
                    "format of a picture",
                    &name,
                    &[".svg", ".png"],
                ))
            }
        }
    }
}

fn refused(asked: impl Into<String>, limit: impl Into<String>, remedy: impl Into<String>) -> Error {
    Error::Arguments {
        asked: asked.into(),
        limit: limit.into(),
        remedy: remedy.into(),
    }
}

/// What a figure calls a file.
fn name(path: &Path) -> String {
    path.file_name()
        .unwrap_or(path.as_os_str())
        .to_string_lossy()
        .into_owned()
}
