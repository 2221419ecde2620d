//! Which kernel a job runs, with which constants.

use super::bases::{odometer_base, radical_base};
use crate::interface::{COLUMN_WORDS, Column, KERNELS, Kernel, column_kind, output};
use crate::reference::hammersley::hammersley_start;
use crate::reference::odometer::OdometerBase;

/// A job in plain words.
#[derive(Clone, Copy, Debug)]
pub struct Work<'a> {
    /// The columns of the points.
    pub columns: &'a [Column],
    /// Number of points.
    pub points: u64,
    /// Fractions instead of floats.
    pub fractions: bool,
    /// Value of `MAP`, and whether the pdf is wanted; the points are then two columns.
    pub map: Option<(u32, bool)>,
    /// The native profile.
    pub native: bool,
    /// The device is a CPU, which likes long runs of wide stores per invocation.
    pub cpu: bool,
}

/// The kernel for a job.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The module.
    pub kernel: &'static Kernel,
    /// Values of its specialization constants, for each dispatch that the points take:
    /// one, or one per four columns.
    pub specializations: Vec<Vec<(u32, u32)>>,
    /// The table of columns that the general kernel reads.
    pub table: Option<Vec<u32>>,
    /// Points of an invocation; 0 for the general kernel, which makes four words.
    pub tile: u32,
}

/// Below this many words the general kernel starts sooner than a tile kernel, which is
/// compiled anew for its columns.
const SMALL: u64 = 1 << 16;

/// Wide rows take a tile kernel per four columns, each compiled anew: about as long as
/// the general kernel takes for so many words.
const LARGE: u64 = 1 << 21;

/// Decides. Every choice gives the same bytes; they differ in speed only.
#[must_use]
pub fn plan(work: &Work) -> Plan {
    let words = work.points * work.columns.len() as u64;
    if let Some((map, with_pdf)) = work.map {
        let name = if work.native { "fused_native" } else { "fused" };
        let mut plan = tiled(name, work);
        plan.set("MAP", map);
        plan.set("WITH_PDF", u32::from(with_pdf));
        return plan;
    }
    let output = if work.fractions {
        output::FRACTIONS
    } else {
        output::FLOATS
    };
    let tile = [
        "generate_tile_1",
        "generate_tile_2",
        "generate_tile_3",
        "generate_tile_4",
    ];
    let width = work.columns.len();
    let parts = width.div_ceil(4) as u64;
    let mut plan = match tile.get(width - 1) {
        Some(name) if words >= SMALL => tiled(name, work),
        None if width.is_multiple_of(4) && words >= parts * LARGE => tiled(tile[3], work),
        _ => general(work),
    };
    plan.set("OUTPUT", output);
    plan
}

/// The general kernel for a job without a map: the yardstick of the others.
#[must_use]
pub fn general(work: &Work) -> Plan {
    let mut plan = Plan {
        kernel: kernel("generate"),
        specializations: vec![Vec::new()],
        table: Some(
            work.columns
                .iter()
                .flat_map(|&column| column_words(column, 0))
                .collect(),
        ),
        tile: 0,
    };
    plan.set("DIMENSIONS", work.columns.len() as u32);
    plan.set(
        "OUTPUT",
        if work.fractions {
            output::FRACTIONS
        } else {
            output::FLOATS
        },
    );
    plan
}

fn tiled(name: &'static str, work: &Work) -> Plan {
    // A GPU's lanes should write side by side; a CPU's run on by themselves, the longer
    // the better, as far as every column has an odometer of that length.
    let odometers = |tile| {
        let has = |column: &Column| match column {
            Column::Radical(prime) => odometer_base(*prime, tile).is_some(),
            Column::Reversed | Column::Grid(_) => true,
        };
        work.columns.iter().all(has)
    };
    // Just below 3^5, 5^3 and 7^2.
    let longest = [240, 120, 48].into_iter().find(|&tile| odometers(tile));
    let tile = if work.cpu { longest.unwrap_or(16) } else { 4 };
    let mut plan = Plan {
        kernel: kernel(name),
        specializations: Vec::new(),
        table: None,
        tile,
    };
    for part in work.columns.chunks(4) {
        let mut values = Vec::new();
        for (index, &column) in part.iter().enumerate() {
            let first = 16 * (index as u32 + 1);
            values.extend((first..).zip(column_words(column, tile)));
        }
        plan.specializations.push(values);
    }
    plan.set("TILE", tile);
    plan.set("ROW", work.columns.len().div_ceil(4) as u32);
    for part in 0..plan.specializations.len() {
        plan.set_in(part, "PART", part as u32);
    }
    plan
}

impl Plan {
    /// Gives a constant a value in every dispatch, if the kernel has it.
    fn set(&mut self, name: &str, value: u32) {
        for part in 0..self.specializations.len() {
            self.set_in(part, name, value);
        }
    }

    /// The same in one dispatch.
    fn set_in(&mut self, part: usize, name: &str, value: u32) {
        let constant = self.kernel.constants.iter().find(|c| c.name == name);
        if let (Some(constant), Some(values)) = (constant, self.specializations.get_mut(part)) {
            values.retain(|(id, _)| *id != constant.id);
            values.push((constant.id, value));
        }
    }
}

/// The row with this name; the names are those of the table.
fn kernel(name: &str) -> &'static Kernel {
    KERNELS
        .iter()
        .find(|kernel| kernel.name == name)
        .unwrap_or(&KERNELS[0])
}

/// A column as the kernels read it; an odometer only where windows of `window` points
/// have one (0: never).
fn column_words(column: Column, window: u32) -> [u32; COLUMN_WORDS as usize] {
    let mut base = OdometerBase {
        radical: radical_base(2),
        power: 1,
        ..OdometerBase::default()
    };
    let kind = match column {
        Column::Reversed => column_kind::REVERSED,
        Column::Radical(prime) => {
            base.radical = radical_base(prime);
            match odometer_base(prime, window).filter(|_| window > 0) {
                Some(odometer) => {
                    base = odometer;
                    column_kind::ODOMETER
                }
                None => column_kind::RADICAL,
            }
        }
        Column::Grid(count) => {
            // 2^32 is written as 0; N = 1 has no point 1, and takes no step.
            let written = count as u32;
            let step = hammersley_start(u32::from(written != 1), written);
            base.power = written;
            base.quotient = step.fraction;
            base.fraction = step.remainder;
            column_kind::GRID
        }
    };
    let r = base.radical;
    [
        kind,
        r.base,
        r.digits,
        r.power,
        r.base_magic,
        r.base_shift,
        r.power_magic,
        r.power_shift,
        base.power,
        base.quotient,
        base.fraction,
    ]
}
