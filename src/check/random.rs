//! References of `evaluate_random.comp`, line by line.

use crate::reference::{hash, owen, random};
use glam::{UVec4, uvec2};

/// What the device must give; `None` for a function of another kernel.
pub fn reference(name: &str, a: [u32; 4]) -> Option<[u32; 4]> {
    let v = UVec4::from_array(a);
    let (low, high) = (uvec2(a[0], a[1]), uvec2(a[2], a[3]));
    let p = random::pcg32_seed(low, high);
    let one = |x: u32| [x, 0, 0, 0];
    Some(match name {
        "hash" => a.map(hash::hash),
        "pcg4d" => hash::pcg4d(v).to_array(),
        "mix4" => hash::mix4(v).to_array(),
        "seed" => one(hash::seed(low, a[2], a[3])),
        "philox" => random::philox(v, uvec2(!a[0], a[1].wrapping_add(a[2]))).to_array(),
        "random" => one(random::random(a[0], a[1], high)),
        "random_fast" => one(random::random_fast(a[0], a[1], high)),
        "pcg32" => {
            let q = random::pcg32_next(p);
            let values = [p, q].map(random::pcg32_value);
            [values[0], values[1], q.state.x, q.state.y]
        }
        "pcg32_advance" => {
            let q = random::pcg32_advance(p, uvec2(a[1], a[3]));
            let state = random::pcg32_advance(p, low).state;
            [random::pcg32_value(q), state.x, state.y, q.increment.x]
        }
        "digital_shift" => one(owen::digital_shift(a[0], a[1])),
        "owen" => one(owen::owen(a[0], a[1], high)),
        "owen_hash" => one(owen::owen_hash(a[0], a[1])),
        "matrix_scramble" => one(owen::matrix_scramble(a[0], a[1], high)),
        _ => return None,
    })
}
