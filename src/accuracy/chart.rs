//! The figures as a plot.

use super::{Accuracy, Comparison};
use crate::Result;
use crate::plot::{Tradeoff, TradeoffStyle, tradeoff};

/// Worst error against speed, both profiles of a function joined, as SVG; `device` stands
/// below the title. What is not finite or was not timed is left out.
///
/// # Errors
/// [`Error::Arguments`](crate::Error::Arguments) if nothing is left.
pub fn chart(device: &str, comparisons: &[Comparison]) -> Result<String> {
    let end = |one: &Accuracy| {
        let speed = one.speed.map_or(f64::NAN, |speed| speed.results_per_s());
        (speed, one.judged.errors.worst_ulp)
    };
    let pairs: Vec<Tradeoff> = comparisons
        .iter()
        .map(|one| Tradeoff {
            name: one.name.to_owned(),
            ends: [end(&one.exact), end(&one.native)],
        })
        .collect();
    tradeoff(
        &pairs,
        &TradeoffStyle {
            title: "What exactness costs",
            subtitle: device,
            y_label: "worst error in ULP",
            ways: ["exact", "native"],
            ..TradeoffStyle::default()
        },
    )
}
