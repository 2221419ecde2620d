//! What `evaluate_net.comp` must give, line by line.

use crate::reference::{pmj02, sobol};
use glam::uvec2;

/// The words of a function; `None` for one of another kernel.
pub(super) fn reference(name: &str, a: [u32; 4]) -> Option<[u32; 4]> {
    Some(match name {
        "sobol" => {
            let of_bit = |bit: usize| (a[1] << 5).wrapping_add(bit as u32);
            let directions = |bit| of_bit(bit).wrapping_mul(0x9e37_79b9);
            let x = sobol::sobol(a[0], &std::array::from_fn::<u32, 32, _>(directions));
            let pair = pmj02::sobol_pair(a[0]);
            [x, sobol::gray(a[0]), pair.x, pair.y]
        }
        "pmj02" => {
            let seed = uvec2(a[1], a[2]);
            let p = pmj02::pmj02(a[0], seed);
            [p.x, p.y, pmj02::pmj02_index(a[0], seed), 0]
        }
        _ => return None,
    })
}
