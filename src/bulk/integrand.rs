//! The twin of `shaders/kernels/integrand.glsl`: a point's coordinates one after the other,
//! then the term.

use super::integrand_environment::environment_term;
use super::integrand_scene::scene_term;
use crate::catalog::Problem;
use crate::interface::integrand;
use crate::reference::exponential::real_exp;
use crate::reference::genz::{
    genz_corner, genz_kink, genz_linear, genz_oscillation, genz_peak, genz_phase, genz_square,
    linear_factor, sobol_g,
};
use crate::reference::integrand::{
    checkerboard_cell, disk_step, indicator, inverse_root, ishigami, offset_fraction, x_squared,
};
use crate::reference::keister::{keister_cosine, keister_square, peak_outside};
use crate::reference::real::{
    Real, real_add, real_multiply, real_negate, real_or_zero, real_square, real_uint, real_zero,
};
use crate::reference::sum::{Term, term};
use glam::{UVec3, uvec2};

/// The exact term of an integrand at a point of fractions of 2^32, one for each dimension:
/// (negative ? -1 : 1) * m in units of 2^-scale.
#[must_use]
pub fn integrand_term(problem: &Problem, point: &[u32]) -> Term {
    let made = problem.coefficients();
    let head = made.head;
    if let Some(map) = problem.map() {
        return term(environment_term(problem, map, point), made.scale);
    }
    if problem.id() >= integrand::SKY_UNIFORM {
        return term(scene_term(problem, point), made.scale);
    }
    let mut state = State::start(problem);
    for (j, &u) in point.iter().enumerate() {
        state.step(problem, j, u);
    }
    let [x, y, z] = [0, 1, 2].map(|j| point.get(j).copied().unwrap_or(0));
    let real = match problem.id() {
        integrand::X_SQUARED => return x_squared(x),
        integrand::OFFSET => return offset_fraction(x, head[0]),
        integrand::DISK_STEP => return indicator(disk_step(uvec2(x, y))),
        integrand::CHECKERBOARD => return indicator(state.word & 1 == 0),
        integrand::INVERSE_ROOT => inverse_root(x),
        integrand::ISHIGAMI => ishigami(
            UVec3::new(x, y, z),
            real([head[0], head[1]]),
            real([head[2], head[3]]),
        ),
        integrand::OSCILLATORY => genz_oscillation(state.word),
        integrand::CORNER_PEAK => genz_corner(state.real, problem.dimensions()),
        integrand::SQUARE_OF_SUM => real_square(state.real),
        integrand::GAUSSIAN | integrand::CONTINUOUS | integrand::PEAK_UNIFORM => {
            real_exp(real_negate(state.real))
        }
        integrand::PEAK_NORMAL | integrand::DISCONTINUOUS if state.word != 0 => real_zero(),
        integrand::PEAK_NORMAL => real([head[0], head[1]]),
        integrand::DISCONTINUOUS => real_exp(state.real),
        integrand::KEISTER => real_multiply(real([head[0], head[1]]), keister_cosine(state.real)),
        _ => state.real,
    };
    term(real, made.scale)
}

/// What the coordinates so far come to.
struct State {
    real: Real,
    word: u32,
}

impl State {
    fn start(problem: &Problem) -> Self {
        match problem.integrand().id {
            integrand::OSCILLATORY => Self {
                real: real_zero(),
                word: problem.coefficients().head[0],
            },
            integrand::PRODUCT_PEAK | integrand::SOBOL_G | integrand::PRODUCT => Self {
                real: real_uint(1, 0),
                word: 0,
            },
            _ => Self {
                real: real_zero(),
                word: 0,
            },
        }
    }

    fn step(&mut self, problem: &Problem, dimension: usize, u: u32) {
        let made = problem.coefficients();
        let none = [0; 4];
        let column @ [m, e, w, _] = *made.columns.get(dimension).unwrap_or(&none);
        match problem.id() {
            integrand::CHECKERBOARD => self.word ^= checkerboard_cell(u, made.head[0]),
            integrand::OSCILLATORY => self.word = genz_phase(self.word, u, uvec2(m, e)),
            integrand::PRODUCT_PEAK => self.real = genz_peak(self.real, u, w, real([m, e])),
            integrand::CORNER_PEAK => self.real = genz_linear(self.real, u, real([m, e])),
            integrand::GAUSSIAN | integrand::PEAK_UNIFORM => {
                self.real = genz_square(self.real, u, w, real([m, e]))
            }
            integrand::PEAK_NORMAL => self.word |= peak_outside(u, w, real([m, e])),
            integrand::KEISTER => self.real = keister_square(self.real, u),
            integrand::CONTINUOUS => self.real = genz_kink(self.real, u, w, real([m, e])),
            integrand::DISCONTINUOUS => {
                self.real = genz_linear(self.real, u, real([m, e]));
                self.word |= u32::from(u > w);
            }
            integrand::SOBOL_G => {
                self.real = sobol_g(self.real, u, real([m, e]), real([column[2], column[3]]));
            }
            integrand::PRODUCT => {
                self.real = linear_factor(self.real, u, real([m, e]), real([column[2], column[3]]));
            }
            integrand::SQUARE_OF_SUM => self.real = real_add(self.real, real_uint(u, -32)),
            _ => {}
        }
    }
}

/// A real of two words that is not negative.
fn real([m, e]: [u32; 2]) -> Real {
    real_or_zero(m, e as i32, false)
}
