//! `corput generate blue-noise`: points that the host makes all at once.

use super::args::GenerateArgs;
use super::arguments::origin;
use super::generate::{count, element, open, output, stream, words};
use super::{host, interrupt, maps, mask};
use corput::blue_noise::{blue_noise_points, check_count};
use corput::bulk::Stored;
use corput::catalog::{Guide, Output, Profile, check_map};
use corput::report::Layout;
use corput::{Error, Result};

/// The name on the command line.
pub const NAME: &str = "blue-noise";

/// What it is, as `generate --help` says it.
pub const GUIDE: Guide = Guide {
    what: "points far from each other, by sample elimination",
    purpose: "pixels and stippling; to 65,536 points of two dimensions",
    points: "a set of any N; each prefix is spread well",
    source: "Yuksel 2015",
};

/// Dimensions of a point.
const DIMENSIONS: u64 = 2;

pub fn run(args: &GenerateArgs) -> anyhow::Result<()> {
    let (target, format) = output(args)?;
    let (mut stored, layout) = prepare(args)?;
    interrupt::clean_up();
    if let Some(sink) = open(args, &target, format, layout, origin(args, None, None)?)? {
        place(args, &mut stored, layout)?;
        stream(&mut host::Source::Host(Box::new(stored)), layout, sink)?;
    }
    Ok(())
}

/// Checks the arguments. The engine has no points yet: they take long.
pub fn prepare(args: &GenerateArgs) -> Result<(Stored, Layout)> {
    mask::refuse(args)?;
    refuse(args)?;
    let map = maps::mapping(args)?;
    let element = element(args)?;
    let output = words(element);
    check_map(
        map.as_ref(),
        DIMENSIONS as u32,
        output == Output::Fractions,
        args.with_pdf,
    )?;
    let stored = Stored {
        points: Vec::new(),
        output,
        map,
        with_pdf: args.with_pdf,
        profile: profile(args)?,
    };
    let layout = Layout {
        rows: count(args)?,
        columns: stored.words_per_point(),
        element,
    };
    check_count(layout.rows)?;
    Ok((stored, layout))
}

/// Makes the points.
pub fn place(args: &GenerateArgs, stored: &mut Stored, layout: Layout) -> Result<()> {
    stored.points = blue_noise_points(layout.rows, args.seed.unwrap_or(0))?;
    Ok(())
}

/// The exact profile has the same bytes wherever the points are mapped; the native one
/// has those of this CPU, so no other device may be asked for.
fn profile(args: &GenerateArgs) -> Result<Profile> {
    let profile = Profile::from_name(&args.profile)?;
    let on_cpu = host::is_cpu(host::asked(args.device.as_deref()).as_deref());
    if profile == Profile::Native && !on_cpu {
        return Err(Error::Arguments {
            asked: "--profile native with blue-noise".into(),
            limit: "its points are made and mapped on the host".into(),
            remedy: "use --profile exact, or --device cpu for this CPU's functions".into(),
        });
    }
    Ok(profile)
}

/// Refuses what other sequences have and this set has not.
fn refuse(args: &GenerateArgs) -> Result<()> {
    let refused = |asked: &str, limit: &str, remedy: &str| {
        Err(Error::Arguments {
            asked: format!("{asked} with {NAME}"),
            limit: limit.to_owned(),
            remedy: remedy.to_owned(),
        })
    };
    if let Some(dims) = args.dims.filter(|dims| *dims != DIMENSIONS) {
        return Err(Error::Dimensions {
            sequence: NAME,
            asked: dims,
            least: DIMENSIONS as u32,
            limit: DIMENSIONS as u32,
            remedy: "drop --dims, or use another sequence".into(),
        });
    }
    if args.first != 0 {
        let limit = "the set is made whole, from its first point on";
        return refused("--first", limit, "drop it, and skip rows of the file");
    }
    if args.bases.is_some() || args.total.is_some() || args.index_first {
        let limit = "only radical inverses and hammersley have them";
        return refused("--bases, --total or --index-first", limit, "drop them");
    }
    if args.scramble.is_some() || args.order != "natural" {
        let limit = "its points are random already; --seed chooses them";
        return refused("--scramble or --order", limit, "drop them");
    }
    if args.grid.is_some() || args.generator.is_some() {
        let limit = "only strata have a grid, and only korobov a generator";
        return refused("--grid or --generator", limit, "drop them");
    }
    Ok(())
}
