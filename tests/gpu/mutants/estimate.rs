//! Exact sums, and the integrands.

use super::Killer::Mismatch;
use super::{Mutant, mutant};
use crate::harness::Target::{Estimate, EstimateTile};

#[rustfmt::skip]
pub const MUTANTS: &[Mutant] = &[
    mutant("a sum's second carry lost", Mismatch, EstimateTile("x-squared"),
        "corput/sum.glsl", "corput_addc(flip, high.y + w1.y)", "corput_addc(flip, high.y)"),
    mutant("the carry into a negative term's upper word lost", Mismatch, Estimate("genz-oscillatory"),
        "corput/sum.glsl", "corput_addc(term.m.y ^ flip, low.y + w0.y)", "corput_addc(term.m.y ^ flip, low.y)"),
    mutant("a negative term not extended", Mismatch, Estimate("genz-oscillatory"),
        "corput/sum.glsl", "sum.total.w + flip + sign.y", "sum.total.w + sign.y"),
    mutant("a complement without its one", Mismatch, Estimate("genz-oscillatory"),
        "corput/sum.glsl", "term.m.x ^ flip, flip & 1u", "term.m.x ^ flip, 0u"),
    mutant("a square's cross product once", Mismatch, EstimateTile("x-squared"),
        "corput/sum.glsl", "corput_addc(outer.y, cross.x << 1)", "corput_addc(outer.y, cross.x)"),
    mutant("the last carry of the squares lost", Mismatch, EstimateTile("x-squared"),
        "corput/sum.glsl", "sum.squares_high.x, c3.y + q3.y", "sum.squares_high.x, c3.y"),
    mutant("the last sample of a run dropped", Mismatch, EstimateTile("x-squared"),
        "kernels/estimate.comp", "uint end = min(TILE, count - done);", "uint end = min(TILE, count - done - 1u);"),
    mutant("a point past the end of a run", Mismatch, EstimateTile("x-squared"),
        "kernels/estimate.comp", "if (k + j >= end)", "if (k + j > end)"),
    mutant("the same by the general kernel", Mismatch, Estimate("x-squared"),
        "kernels/estimate.comp", "if (k < count)", "if (k + 1u < count)"),
    mutant("the column of another dimension", Mismatch, Estimate("disk-step"),
        "kernels/estimate.comp", "column_load(j * COLUMN_ROWS)", "column_load(0u)"),
    mutant("the words of another dimension", Mismatch, Estimate("genz-gaussian"),
        "kernels/estimate.comp", "words = coefficients[1u + j]", "words = coefficients[1u]"),
    mutant("a cursor that does not move on", Mismatch, Estimate("disk-step"),
        "kernels/estimate.comp", "            cursor = cursor_next(cursor, c);\n", ""),
    mutant("a column of a tile not loaded", Mismatch, EstimateTile("disk-step"),
        "kernels/tile.glsl", "COLUMN1 = column_load(COLUMN_ROWS)", "COLUMN1 = column_load(0u)"),
    mutant("a tile that does not move on", Mismatch, EstimateTile("disk-step"),
        "kernels/estimate.comp", "                tile = tile_next(tile);\n", ""),
    mutant("terms cut instead of rounded", Mismatch, Estimate("genz-gaussian"),
        "corput/sum.glsl", "(right >> 1) + (right & 1u)", "right >> 1"),
    mutant("everything within the disk", Mismatch, EstimateTile("disk-step"),
        "corput/integrand.glsl", "(carried.y | corput_addc(carried.x, yy.y).y) == 0u", "carried.y == 0u"),
    mutant("the lower edge of a cell for its middle", Mismatch, Estimate("inverse-root"),
        "corput/integrand.glsl", "(u << 1) | 1u", "(u << 1) | 0u"),
    mutant("phases without their fraction", Mismatch, Estimate("genz-oscillatory"),
        "corput/genz.glsl", "c.y * u + corput_mulhi(c.x, u)", "corput_mulhi(c.x, u)"),
    mutant("the second coordinate of a step unseen", Mismatch, Estimate("genz-discontinuous"),
        "kernels/integrand.glsl", "state.word | uint(u >", "uint(u >"),
];
