//! Which counts a slope is fitted to.

use super::analysis::{ErrorAt, SLOPE_FROM};

/// How many counts a slope is fitted to, and why others are left out: each for the first of the
/// reasons that it has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SlopeCounts {
    /// Those of the slope; it needs three.
    pub fitted: u64,
    /// Below 64 points.
    pub small: u64,
    /// Few hits: [`ErrorAt::few_hits`].
    pub few_hits: u64,
    /// Errors within ten floors.
    pub near_floor: u64,
}

impl SlopeCounts {
    /// Of errors by count.
    pub(super) fn of(errors: &[ErrorAt]) -> Self {
        let mut counts = Self::default();
        for one in errors {
            let place = match one {
                _ if one.count < SLOPE_FROM => &mut counts.small,
                _ if one.few_hits() => &mut counts.few_hits,
                _ if !one.above_floor => &mut counts.near_floor,
                _ => &mut counts.fitted,
            };
            *place += 1;
        }
        counts
    }
}
