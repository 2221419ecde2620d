//! Nets in base 2: Sobol and pmj02.

use super::Asked;
use crate::catalog::{Order, Scramble, Sequence};
use crate::interface::{Column, NetScramble};

pub(super) fn columns(asked: &Asked) -> Vec<Column> {
    let seed = asked.seed;
    if asked.sequence == Sequence::Pmj02 {
        return asked.per_dimension(|dimension| Column::Pmj02 { dimension, seed });
    }
    let scramble = match asked.scramble {
        Scramble::Shift => NetScramble::Shift,
        Scramble::Matrix => NetScramble::Matrix,
        Scramble::Owen => NetScramble::Owen,
        Scramble::OwenHash => NetScramble::OwenHash,
        _ => NetScramble::None,
    };
    asked.per_dimension(|dimension| Column::Sobol {
        dimension,
        gray: asked.options.order == Order::Gray,
        scramble,
        seed,
    })
}
