//! A product of linear factors, of which hundreds of dimensions are usual.

use super::genz::{BASE, dominant};
use super::{Coefficients, Integrand, Parameter, real_words, within};
use crate::interface::integrand;

/// The integrands of this group.
pub(super) const INTEGRANDS: &[Integrand] = &[Integrand {
    name: "product",
    id: integrand::PRODUCT,
    dimensions: (1, 4096),
    parameters: &[
        Parameter {
            name: "weight",
            size: 1,
            default: Some(&[1.0]),
            domain: "it must be from 0.001 to 2, and so small for its dimensions that the mean \
                     is at least 2^-34 of the peak",
            summary: "c_1",
        },
        Parameter {
            name: "decay",
            size: 1,
            default: Some(&[2.0]),
            domain: "it must be from 0 to 4",
            summary: "how fast c_j falls: 0 where all variables matter alike",
        },
    ],
    prepare: |s| product(s.values, s.dimensions),
    truth: |_| 1.0,
    // 4096 steps, each cut by 2^-29.9 at most, and of 2^-30.5 at an end.
    error: 4e-6,
    examples: &[
        (&[1.0, 2.0], 8),
        (&[2.0, 0.0], 1),
        (&[2.0, 0.0], 34),
        (&[0.04, 0.0], 1000),
        (&[1.0, 2.0], 1024),
    ],
    summary: "linear factors of declining weight, for hundreds of dimensions",
    formula: "product of 1 + c_j (x_j - 1/2), c_j = weight / j^decay, j from 1 on; factors and \
              products are cut, so that means are low by some 3.5e-10 of themselves a dimension, which \
              is in the floor of converge",
    source: "of no paper: products of centred linear factors are common tests of many dimensions",
    ..BASE
}];

/// 1 - c_j/2 and c_j of every dimension.
fn product(values: &[f64], dimensions: u32) -> core::result::Result<Coefficients, usize> {
    let weight = within(values, 0, 0.001, 2.0)?;
    let decay = within(values, 1, 0.0, 4.0)?;
    let weights = (1..=dimensions).map(|j| weight * f64::from(j).powf(-decay));
    let column = |c: f64| {
        let [[m, e], [share_m, share_e]] = [real_words(1.0 - 0.5 * c), real_words(c)];
        [m, e, share_m, share_e]
    };
    let peak = weights.clone().map(|c| 1.0 + 0.5 * c).product();
    let columns = weights.map(column).collect();
    dominant(Ok(Coefficients::real([0; 4], columns, peak)), 1.0)
}
