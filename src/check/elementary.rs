//! The elementary functions of both profiles: what the kernel `function` has.

use crate::judge;
use crate::reference::{elementary, exponential, logarithm, normal_quantile};

/// An elementary function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElementaryFunction {
    /// Its name: that of the GLSL function without `corput_`.
    pub name: &'static str,
    /// Value of the kernel's constant `FUNCTION`.
    pub id: u32,
    /// Words of a result.
    pub width: usize,
    /// Results below this in magnitude have their error counted in ULP of it: 1/2, as for a
    /// result just below 1, of functions that pass through 0; 0 of the others.
    pub floor: f64,
    /// What it is evaluated on.
    pub domain: &'static str,
}

/// The floor of functions that pass through 0.
const HALF: f64 = 0.5;

const MODERATE: &str = "floats from 2^-26 to 2^6, either sign";
const POSITIVE: &str = "floats from 2^-26 to 2^6";
pub(crate) const FRACTIONS: &str = "fractions of 2^32";

/// Every one of them, by id.
pub const ELEMENTARY: &[ElementaryFunction] = &[
    function("sqrt", 0, 0.0, POSITIVE),
    function("divide", 1, 0.0, MODERATE),
    function("multiply", 2, 0.0, MODERATE),
    ElementaryFunction {
        width: 2,
        ..function("cos_sin", 3, HALF, FRACTIONS)
    },
    // A fraction of a turn.
    function("atan2", 4, HALF, MODERATE),
    function("log", 5, HALF, POSITIVE),
    function("log2", 6, HALF, POSITIVE),
    function("negative_log", 7, HALF, FRACTIONS),
    function("exp", 8, 0.0, MODERATE),
    function("exp2", 9, 0.0, MODERATE),
    function("normal_quantile", 10, HALF, FRACTIONS),
];

const fn function(
    name: &'static str,
    id: u32,
    floor: f64,
    domain: &'static str,
) -> ElementaryFunction {
    ElementaryFunction {
        name,
        id,
        width: 1,
        floor,
        domain,
    }
}

/// A float of either sign from 2^-26 to 2^6, as the kernel makes it of a word.
fn moderate(word: u32) -> f32 {
    f32::from_bits((word & 0x807f_ffff) | ((101 + ((word >> 23) & 31)) << 23))
}

impl ElementaryFunction {
    /// The magnitude of the float that the kernel makes of a word.
    pub(super) fn positive(&self, a: u32) -> f64 {
        f64::from(moderate(a).abs())
    }

    /// What the kernel makes of words, as a message has it.
    pub(super) fn input(&self, [a, b]: [u32; 2]) -> String {
        let (x, y) = (moderate(a), moderate(b));
        match (self.domain, self.name) {
            (FRACTIONS, _) => format!("u = {a} 2^-32"),
            (POSITIVE, _) => format!("x = {:e}", x.abs()),
            (_, "exp" | "exp2") => format!("x = {x:e}"),
            _ => format!("x = {x:e}, y = {y:e}"),
        }
    }

    /// `evaluate` of `function.comp`, line by line.
    #[must_use]
    pub fn reference(&self, [a, b, _]: [u32; 3]) -> [u32; 4] {
        let (x, y) = (moderate(a), moderate(b));
        let p = x.abs();
        let one = |x: f32| [x.to_bits(), 0, 0, 0];
        match self.id {
            0 => one(elementary::sqrt(p)),
            1 => one(elementary::divide(x, y)),
            2 => one(elementary::multiply(x, y)),
            3 => {
                let v = elementary::cos_sin(a);
                [v.x.to_bits(), v.y.to_bits(), 0, 0]
            }
            4 => [elementary::atan2(y, x), 0, 0, 0],
            5 => one(logarithm::log(p)),
            6 => one(logarithm::log2(p)),
            7 => one(logarithm::negative_log(a)),
            8 => one(exponential::exp(x)),
            9 => one(exponential::exp2(x)),
            _ => one(normal_quantile::normal_quantile(a)),
        }
    }

    /// The results in `f64`.
    #[must_use]
    pub fn truth(&self, [a, b, _]: [u32; 3]) -> [f64; 4] {
        let (x, y) = (moderate(a), moderate(b));
        let (wide, p) = (f64::from(x), f64::from(x.abs()));
        let one = |truth: f64| [truth, 0.0, 0.0, 0.0];
        match self.id {
            0 => one(p.sqrt()),
            1 => one(wide / f64::from(y)),
            2 => one(wide * f64::from(y)),
            3 => {
                let (sin, cos) = judge::sin_cos(a);
                [cos, sin, 0.0, 0.0]
            }
            4 => one(judge::atan2_turns(y, x)),
            5 => one(judge::log(p)),
            6 => one(judge::log2(p)),
            7 => one(judge::negative_log(a)),
            8 => one(wide.exp()),
            9 => one(wide.exp2()),
            _ => one(judge::normal_quantile(a)),
        }
    }
}
