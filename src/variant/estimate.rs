//! Which kernel an estimate runs, and how long the runs of its invocations may be.

use super::columns::longest_run;
use super::plan::{Plan, family, kernel, tabled};
use crate::interface::{Column, Kernel, NetScramble, integrand as id};

/// Points that share what the general kernel loads for a dimension. More of them compile for
/// longer, and gain little.
const SHARED: u32 = 8;

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
        Some(name) => estimating(kernel(name, family(columns)), columns, integrand, tile),
        None => general_estimate(columns, integrand),
    }
}

/// The general kernel, for any number of columns.
#[must_use]
pub fn general_estimate(columns: &[Column], integrand: u32) -> Plan {
    let tile = SHARED.min(longest_estimate(columns));
    estimating(
        kernel("estimate", family(columns)),
        columns,
        integrand,
        tile,
    )
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
    let mut plan = tabled(kernel, columns, tile);
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
/// all, of which four columns of the longest run take fewer.
#[must_use]
pub fn longest_estimate(columns: &[Column]) -> u32 {
    let longest = columns.iter().map(|column| match column {
        // A tile of any length starts with 85 iterations, and each point takes 8 at most.
        Column::Radical(_) => 240,
        column => longest_run(column),
    });
    (4 * longest.min().unwrap_or(16) / columns.len().max(1) as u32).max(1)
}
