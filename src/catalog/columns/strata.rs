//! Jittered strata: grids, Latin hypercubes, correlated multi-jittered sets.

use super::Asked;
use crate::catalog::Sequence;
use crate::interface::{Column, purpose};
use crate::tables::{composite_neighbours, is_prime, nearly_equal_factors};
use crate::{Error, Result};

pub(super) fn columns(asked: &Asked, warnings: &mut Vec<String>) -> Result<Vec<Column>> {
    let (sequence, total, seed) = (asked.sequence, asked.total, asked.seed);
    match sequence {
        Sequence::LatinHypercube => Ok(asked.per_dimension(|dimension| Column::LatinHypercube {
            // A set of strata has at most 2^32 - 1 points.
            count: total as u32,
            dimension,
            seed,
            permutation: asked.derived(dimension, purpose::LATIN_HYPERCUBE),
        })),
        Sequence::MultiJittered => {
            let grid = multi_jittered(asked)?;
            let permutation = asked.derived(0, purpose::MULTI_JITTERED);
            Ok(asked.per_dimension(|dimension| Column::MultiJittered {
                grid,
                dimension,
                seed,
                permutation,
            }))
        }
        _ => {
            let grid = stratified(asked, warnings)?;
            let mut stride = 1;
            let mut columns = Vec::new();
            for (dimension, &strata) in (0..).zip(&grid) {
                columns.push(Column::Stratified {
                    stride,
                    strata,
                    dimension,
                    seed,
                });
                // The product of all is the total, which is a u32; past the last axis
                // nobody reads it.
                stride = stride.wrapping_mul(strata);
            }
            Ok(columns)
        }
    }
}

/// The given grid, whose cells must be as many as the points.
fn given(asked: &Asked, grid: &[u64]) -> Result<Vec<u32>> {
    let product = grid.iter().try_fold(1u64, |a, b| a.checked_mul(*b));
    if product != Some(asked.total) {
        let text: Vec<String> = grid.iter().map(u64::to_string).collect();
        let cells = product.map_or("more than 2^64".into(), |p| p.to_string());
        return Err(Error::Arguments {
            asked: format!("--grid {} with {} points", text.join("x"), asked.total),
            limit: format!("the grid has {cells} cells, and each takes one point"),
            remedy: match product.filter(|product| *product <= asked.sequence.most_points()) {
                Some(product) => asked.whole_set([product]).map_or_else(
                    || "use another grid".into(),
                    |whole| format!("{whole}, or another grid"),
                ),
                None => "use another grid".into(),
            },
        });
    }
    // Factors of a total below 2^32.
    Ok(grid.iter().map(|&cells| cells as u32).collect())
}

fn stratified(asked: &Asked, warnings: &mut Vec<String>) -> Result<Vec<u32>> {
    if let Some(grid) = &asked.options.grid {
        return given(asked, grid);
    }
    let total = asked.total;
    if asked.dimensions > 1 && total > 3 && is_prime(total) {
        warnings.push(format!(
            "{total} is prime, so its grid has all cells along one axis; a count with divisors, \
             or --grid, stratifies the others"
        ));
    }
    let factors = nearly_equal_factors(total, asked.dimensions as usize);
    // Factors of a total below 2^32.
    Ok(factors.iter().map(|&cells| cells as u32).collect())
}

/// m x n as near to a square as the divisors allow. A prime has no such grid.
fn multi_jittered(asked: &Asked) -> Result<[u32; 2]> {
    let total = asked.total;
    if let Some(grid) = &asked.options.grid {
        let grid = given(asked, grid)?;
        return Ok([grid[0], grid[1]]);
    }
    if let Some([below, above]) = composite_neighbours(total) {
        return Err(Error::Arguments {
            asked: format!("cmj of {total} points"),
            limit: format!("the set has m x n points, and {total} is prime"),
            remedy: asked.whole_set([below, above]).map_or_else(
                || format!("use --grid 1x{total}"),
                |whole| format!("{whole}, or --grid 1x{total}"),
            ),
        });
    }
    let factors = nearly_equal_factors(total, 2);
    Ok([factors[0] as u32, factors[1] as u32])
}
