//! Which kernel an estimate runs, and how long the runs of its invocations may be.

use super::columns::longest_run;
use super::plan::{Plan, family, kernel, table, tiled};
use crate::interface::{Column, INTEGRANDS_OF_GROUP};

/// Below this many points the general kernel starts sooner than one that is compiled anew
/// for its columns.
const SMALL: u64 = 1 << 14;

/// The general kernels, by group of integrands.
const GROUPS: [&str; 3] = ["estimate", "estimate_environment", "estimate_scene"];

/// That of an integrand.
fn group(integrand: u32) -> &'static str {
    let group = (integrand / INTEGRANDS_OF_GROUP) as usize;
    GROUPS.get(group).copied().unwrap_or(GROUPS[0])
}

/// The kernel for sums of an integrand (its `INTEGRAND`) over points; `cpu` as in
/// [`Work`](super::Work). All kernels give the same sums.
#[must_use]
pub fn plan_estimate(columns: &[Column], points: u64, integrand: u32, cpu: bool) -> Plan {
    let tiles = [
        "estimate_tile_1",
        "estimate_tile_2",
        "estimate_tile_3",
        "estimate_tile_4",
    ];
    let mut plan = match tiles.get(columns.len().wrapping_sub(1)) {
        Some(name) if points >= SMALL && group(integrand) == GROUPS[0] => tiled(name, columns, cpu),
        _ => return general_estimate(columns, integrand),
    };
    plan.set("DIMENSIONS", columns.len() as u32);
    plan.set("INTEGRAND", integrand);
    plan
}

/// The general kernel: the yardstick of the others.
#[must_use]
pub fn general_estimate(columns: &[Column], integrand: u32) -> Plan {
    let mut plan = Plan {
        kernel: kernel(group(integrand), family(columns)),
        specializations: vec![Vec::new()],
        table: Some(table(columns)),
        tile: 0,
    };
    plan.set("DIMENSIONS", columns.len() as u32);
    plan.set("INTEGRAND", integrand);
    plan
}

/// Points that an invocation may sum: llvmpipe ends its loops after 65,535 iterations in
/// all, of which four columns of the longest run take fewer; searches in tables take as many
/// again.
#[must_use]
pub fn longest_estimate(columns: &[Column], integrand: u32) -> u32 {
    let longest = columns.iter().map(longest_run).min().unwrap_or(16);
    let share = if group(integrand) == GROUPS[0] { 4 } else { 2 };
    (share * longest / columns.len().max(1) as u32).max(1)
}
