//! What `evaluate_domain.comp` must give, line by line.

use crate::reference::domain::{domain, domain_chain, domain_child, domain_seed, domain_split};
use crate::reference::domain_draw::{
    draw_additive, draw_cmj, draw_korobov, draw_latin_hypercube, draw_lattice, draw_pairs,
    draw_pmj02, draw_r2, draw_random, draw_random_fast, draw_stratified,
};
use crate::reference::domain_halton::{draw_halton, draw_halton_permuted, draw_halton_started};
use crate::reference::domain_sobol::{draw_sobol, draw_sobol_owen};
use glam::{uvec2, uvec4};

/// The words of a function; `None` for one of another kernel.
pub(super) fn reference(name: &str, a: [u32; 4]) -> Option<[u32; 4]> {
    let mut root = domain(uvec2(a[0], a[1]), a[2] & 3, a[3], a[2]);
    let other = domain_chain(root, a[0], a[1]);
    let split = domain_split(root, a[2], a[1], a[0]);
    let directions: [u32; 128] = std::array::from_fn(|i| (i as u32).wrapping_mul(0x9e37_79b9));
    Some(match name {
        "domain" => {
            let seed = domain_seed(root, a[0]);
            [root.pattern.x, root.pattern.y, root.index, seed]
        }
        "domain_child" => {
            let (x, y) = (domain_child(root, a[0]), domain_child(other, a[1]));
            [x.pattern.x, x.pattern.y, y.pattern.x, y.pattern.y]
        }
        "domain_chain" => [
            other.pattern.x,
            other.pattern.y,
            split.pattern.x,
            split.index,
        ],
        "draw_random" => draw_random(root).into(),
        "draw_random_fast" => draw_random_fast(root).into(),
        "draw_pairs" => draw_pairs(root).into(),
        "draw_pmj02" => draw_pmj02(root).into(),
        "draw_latin_hypercube" => {
            root.index = a[3] % 1000;
            draw_latin_hypercube(root, 1000).into()
        }
        "draw_cmj" => {
            root.index = a[3] % 999;
            draw_cmj(root, uvec2(27, 37)).into()
        }
        "draw_lattice" => draw_lattice(root).into(),
        "draw_additive" => draw_additive(root).into(),
        "draw_sobol" => draw_sobol(root, &directions).into(),
        "draw_sobol_owen" => draw_sobol_owen(root, &directions).into(),
        "draw_halton" => draw_halton(root, uvec4(2, 3, 5, 7)).into(),
        "draw_halton_permuted" => draw_halton_permuted(root, uvec4(2, 3, 5, 7)).into(),
        "draw_halton_started" => draw_halton_started(root, uvec4(2, 3, 5, 7)).into(),
        "draw_stratified" => {
            root.index = a[3] % 999;
            draw_stratified(root, uvec2(27, 37)).into()
        }
        "draw_korobov" => {
            root.index = a[3] % 65521;
            draw_korobov(root, uvec4(1, 8950, 35838, 24805), 65521).into()
        }
        "draw_r2" => {
            let p = draw_r2(root);
            [p.x, p.y, 0, 0]
        }
        _ => return None,
    })
}
