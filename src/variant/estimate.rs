//! Which kernel an estimate runs, and how long the runs of its invocations may be.

use super::columns::{longest_run, turns};
use super::plan::{Plan, family, kernel, tabled};
use crate::interface::{
    Column, ESTIMATE_DIMENSIONS, INTEGRANDS_OF_GROUP, Kernel, NetScramble, integrand as id,
};

/// Points that share what the general kernel loads for a dimension. More of them compile for
/// longer, and gain little.
const SHARED: u32 = 8;

/// The general kernels, by group of integrands.
const GROUPS: [&str; 3] = ["estimate", "estimate_environment", "estimate_scene"];

/// That of many dimensions.
const WIDE: &str = "estimate_wide";

/// That of pictures.
const PIXELS: &str = "estimate_pixels";

/// Iterations of an invocation's loops that are safe: llvmpipe ends it after 65,535, and was
/// seen to count a fifth more than a loop seems to have.
const TURNS: u32 = 40_000;

/// That of an integrand.
fn group(integrand: u32) -> &'static str {
    let group = (integrand / INTEGRANDS_OF_GROUP) as usize;
    GROUPS.get(group).copied().unwrap_or(GROUPS[0])
}

/// The kernel for sums of an integrand (its `INTEGRAND`) over points; `cpu` as in
/// [`Work`](super::Work). All kernels give the same sums.
#[must_use]
pub fn plan_estimate(columns: &[Column], integrand: u32, cpu: bool) -> Plan {
    let tiles = [
        "estimate_tile_1",
        "estimate_tile_2",
        "estimate_tile_3",
        "estimate_tile_4",
    ];
    let longest = columns.iter().map(longest_run).min();
    let tile = if cpu { longest.unwrap_or(16) } else { 4 };
    match tiles.get(columns.len().wrapping_sub(1)) {
        Some(name) if group(integrand) == GROUPS[0] => {
            estimating(kernel(name, family(columns)), columns, integrand, tile)
        }
        _ => general_estimate(columns, integrand),
    }
}

/// The general kernel, for any number of columns.
#[must_use]
pub fn general_estimate(columns: &[Column], integrand: u32) -> Plan {
    let group = group(integrand);
    // Terms of rendering are long, and would compile for as long as there are points.
    let tile = match group == GROUPS[0] {
        true => SHARED.min(longest_estimate(columns, integrand)).max(1),
        false => 1,
    };
    let name = if wide(columns) { WIDE } else { group };
    estimating(kernel(name, family(columns)), columns, integrand, tile)
}

/// Whether uniform blocks do not hold the words of so many columns.
fn wide(columns: &[Column]) -> bool {
    columns.len() > ESTIMATE_DIMENSIONS as usize
}

/// The kernel for sums of an integrand of a scene over points of each pixel of a picture, whose
/// coefficients take so many rows.
#[must_use]
pub fn plan_pixels(columns: &[Column], integrand: u32, rows: u32) -> Plan {
    let mut plan = tabled(kernel(PIXELS, family(columns)), columns, 0);
    plan.set("TILE", 1);
    plan.set("DIMENSIONS", columns.len() as u32);
    plan.set("INTEGRAND", integrand);
    plan.set("PIXEL_ROWS", rows);
    plan
}

/// The same plan for other columns of the same shape, which differ in seed, in number of
/// points, or in both: only its table is another. `None` for another shape.
#[must_use]
pub fn replan_estimate(plan: &Plan, columns: &[Column], integrand: u32) -> Option<Plan> {
    let family = plan.kernel.columns.map(|(family, _)| family);
    let fits = columns.iter().all(|column| Some(column.family()) == family);
    let other = estimating(plan.kernel, columns, integrand, plan.tile);
    (fits && other.specializations == plan.specializations).then_some(other)
}

fn estimating(kernel: &'static Kernel, columns: &[Column], integrand: u32, tile: u32) -> Plan {
    // The start of an odometer takes more iterations than a few radical inverses.
    let window = if wide(columns) { 0 } else { tile };
    let mut plan = tabled(kernel, columns, window);
    plan.tile = tile;
    plan.set("TILE", tile);
    plan.set("DIMENSIONS", columns.len() as u32);
    plan.set("INTEGRAND", integrand);
    plan.set("SIDE_BY_SIDE", side_by_side(columns, integrand));
    plan
}

/// Points that one turn of the loop over a tile adds: some where column and integrand take
/// little more than the turn itself. Elsewhere they would only compile for longer. Tiles are
/// multiples of it.
fn side_by_side(columns: &[Column], integrand: u32) -> u32 {
    let short = |column: &Column| match column {
        Column::Reversed | Column::Lattice { .. } | Column::Additive { .. } => true,
        Column::Sobol { scramble, .. } => *scramble != NetScramble::Owen,
        _ => false,
    };
    let plain = [id::X_SQUARED, id::OFFSET, id::DISK_STEP, id::CHECKERBOARD];
    match columns.len() {
        1 | 2 if plain.contains(&integrand) && columns.iter().all(short) => 4,
        _ => 1,
    }
}

/// Points that an invocation may sum: llvmpipe ends its loops after 65,535 iterations in
/// all, of which four columns of the longest run take fewer; searches in tables take as many
/// again. 0 for so many columns that not even one point is sure to end.
#[must_use]
pub fn longest_estimate(columns: &[Column], integrand: u32) -> u32 {
    if wide(columns) {
        let point = columns.iter().map(|column| 1 + turns(column));
        return TURNS / point.fold(1, u32::saturating_add);
    }
    let longest = columns.iter().map(|column| match column {
        // A tile of any length starts with 85 iterations, and each point takes 8 at most.
        Column::Radical(_) => 240,
        column => longest_run(column),
    });
    let share = if group(integrand) == GROUPS[0] { 4 } else { 2 };
    (share * longest.min().unwrap_or(16) / columns.len().max(1) as u32).max(1)
}
