//! Stratified points: a jittered fraction of a stratum, jittered grids, Latin hypercubes
//! and correlated multi-jittered sets.
//!
//! Source: Cook 1986 (jitter); McKay, Beckman and Conover 1979 (Latin hypercube); Kensler
//! 2013, Pixar TM 13-01 (correlated multi-jittered).
//! Domain: cell < strata, 1 <= strata <= 2^32; strata = 2^32 is written as 0. Range:
//! fractions of 2^32 in the stratum [2^32 cell/strata, 2^32 (cell + 1)/strata), exactly.
//! Mirror: `shaders/corput/stratified.glsl`.

use crate::reference::fixed::mulhi;
use crate::reference::hammersley::{
    GridPoint, hammersley_next, hammersley_start, hammersley_value,
};
use crate::reference::permute::{permute, permute_key};
use crate::reference::unit::unit_floor;
use glam::{UVec2, uvec2};

/// A fraction of stratum `cell` among `strata` equal ones; `jitter` says where in it.
#[inline]
#[must_use]
pub fn stratum(cell: u32, strata: u32, jitter: u32) -> u32 {
    // The width 2^32 of one stratum has no u32; 2^32 strata hold one fraction each.
    if strata <= 1 {
        return if strata == 1 { jitter } else { cell };
    }
    let lower = hammersley_start(cell, strata);
    // 2^32 / strata. A remainder of `strata` in place of 0 carries in the step below.
    let quotient = 0xffff_ffff / strata;
    let step = GridPoint {
        fraction: quotient,
        remainder: 0xffff_ffff - quotient * strata + 1,
    };
    let first = hammersley_value(lower);
    // The end of the last stratum is 2^32, of which 0 is left.
    let end = hammersley_value(hammersley_next(lower, step, strata));
    first.wrapping_add(mulhi(jitter, end.wrapping_sub(first)))
}

/// The float of u that stays in u's stratum among `strata` equal ones: u cut to 24 bits, or
/// the next one up if the cut leaves the stratum. Exact for strata <= 2^24; above, floats
/// are too few.
#[inline]
#[must_use]
pub fn unit_stratum(u: u32, strata: u32) -> f32 {
    let cut = u & 0xffff_ff00;
    let left = if strata == 0 {
        cut != u
    } else {
        mulhi(cut, strata) != mulhi(u, strata)
    };
    unit_floor(if left && cut != 0xffff_ff00 {
        cut + 256
    } else {
        cut
    })
}

/// The coordinate of point n of a jittered grid along an axis of `strata` strata; `stride`
/// is the product of the strata of the axes before it, at least 1.
#[inline]
#[must_use]
pub fn stratified(n: u32, stride: u32, strata: u32, jitter: u32) -> u32 {
    let cell = n / stride.max(1);
    stratum(
        if strata == 0 { cell } else { cell % strata },
        strata,
        jitter,
    )
}

/// The coordinate of point n of a Latin hypercube of `count` points; each dimension has a
/// seed of its own.
#[inline]
#[must_use]
pub fn latin_hypercube(n: u32, count: u32, seed: u32, jitter: u32) -> u32 {
    stratum(permute(n, count, seed), count, jitter)
}

/// Point n of a correlated multi-jittered set of grid.x * grid.y points, at most 2^32: alone
/// in its cell of the grid, and in its stratum of either axis among as many as points.
#[inline]
#[must_use]
pub fn cmj(n: u32, mut grid: UVec2, seed: u32, jitter: UVec2) -> UVec2 {
    grid = grid.max(UVec2::ONE);
    let count = grid.x.wrapping_mul(grid.y);
    let cell = permute(n, count, permute_key(seed, 0));
    let row = cell / grid.x;
    let column = cell - row * grid.x;
    let x = column
        .wrapping_mul(grid.y)
        .wrapping_add(permute(row, grid.y, permute_key(seed, 1)));
    let y = row
        .wrapping_mul(grid.x)
        .wrapping_add(permute(column, grid.x, permute_key(seed, 2)));
    uvec2(stratum(x, count, jitter.x), stratum(y, count, jitter.y))
}
