//! What results are compared with: the twin, and the truths.

use super::inputs::{Domain, arguments};
use super::row::Figures;
use super::truth::{Rounding, Truths, truths};
use crate::catalog::Function;
use crate::check::{function_error, function_words};
use crate::judge::RadicalInverses;
use crate::reference::odometer::{
    Odometer, OdometerBase, odometer_next, odometer_start, odometer_value,
};
use crate::reference::radical_inverse::{Base, radical_inverse_table, van_der_corput};
use crate::variant::{odometer_base, radical_base};

/// The costly judge of the normal tail, 200 divisions, sees one input in so many.
const SPARSE: u64 = 1 << 12;

/// Judges a run of results.
pub trait Judge: Sync {
    /// Words of a result.
    fn width(&self) -> usize;

    /// Compares the results of the inputs from number `start` on.
    fn figures(&self, start: u64, results: &[u32]) -> Figures;
}

/// A function of the catalogue.
pub struct OfFunction<'a> {
    pub function: &'a Function,
    pub domain: Domain,
    pub critical: &'a [u32],
}

impl OfFunction<'_> {
    fn input(&self, i: u64) -> [u32; 4] {
        match self.domain {
            Domain::Words { first, stride, .. } => {
                [first.wrapping_add((i as u32).wrapping_mul(stride)); 4]
            }
            Domain::Sampled => arguments(self.function.kind, self.critical, i),
        }
    }
}

impl Judge for OfFunction<'_> {
    fn width(&self) -> usize {
        4
    }

    fn figures(&self, start: u64, results: &[u32]) -> Figures {
        let name = self.function.name;
        let truths = truths(name);
        let mut figures = Figures::default();
        for (i, &got) in (start..).zip(results.as_chunks::<4>().0) {
            let a = self.input(i);
            let expected = function_words(name, a);
            figures.compared += 1;
            if got != expected {
                figures.differs(i, || format!("{a:08x?}: {got:08x?}, not {expected:08x?}"));
            }
            if let Some(truths) = truths {
                figures.judged += 1;
                judged(&mut figures, truths, i, a, got);
            }
            // What has no truths above is judged in the unit of its row.
            let asked = match (self.function.bound, truths) {
                (Some(_), None) => true,
                (Some(_), Some(_)) => name == "normal_tail" && i % SPARSE == 0,
                (None, _) => false,
            };
            if asked {
                figures.judged += u64::from(truths.is_none());
                let error = function_error(name, a, got);
                figures.error(i, error, || format!("{a:08x?}"));
            }
        }
        figures
    }
}

fn judged(figures: &mut Figures, truths: Truths, i: u64, a: [u32; 4], got: [u32; 4]) {
    for (truth, word) in truths(a).into_iter().zip(got) {
        let Some(truth) = truth else { continue };
        let (error, rounding) = truth.judge(f32::from_bits(word));
        figures.error(i, error, || format!("{a:08x?}"));
        figures.rounded(rounding);
    }
}

/// Indices that an odometer goes through from one start.
const WINDOW: u32 = 64;

/// The twin of radical inverses in a base: what is fastest for it.
#[derive(Clone, Copy)]
enum Twin {
    Mirror,
    Odometer(OdometerBase),
    Table(Base),
}

/// Radical inverses in a base, against exact rationals.
pub struct OfBase {
    base: u32,
    twin: Twin,
}

impl OfBase {
    pub fn new(base: u32) -> Self {
        let twin = match odometer_base(base, WINDOW) {
            _ if base == 2 => Twin::Mirror,
            Some(odometer) => Twin::Odometer(odometer),
            None => Twin::Table(radical_base(base)),
        };
        Self { base, twin }
    }
}

impl Twin {
    /// The value at an index, which follows the one that `odometer` is of.
    fn value(self, n: u32, odometer: &mut Odometer) -> u32 {
        match self {
            Self::Mirror => van_der_corput(n),
            Self::Table(base) => radical_inverse_table(n, base),
            Self::Odometer(base) => {
                *odometer = match n % WINDOW {
                    0 => odometer_start(n, base),
                    _ => odometer_next(*odometer, base),
                };
                odometer_value(*odometer, base)
            }
        }
    }

    /// What the value before an index leaves.
    fn before(self, n: u32) -> Odometer {
        let mut odometer = Odometer::default();
        (n - n % WINDOW..n).for_each(|n| {
            self.value(n, &mut odometer);
        });
        odometer
    }
}

impl Judge for OfBase {
    fn width(&self) -> usize {
        1
    }

    fn figures(&self, start: u64, results: &[u32]) -> Figures {
        let mut truth = RadicalInverses::new(start as u32, self.base);
        let mut odometer = self.twin.before(start as u32);
        let mut figures = Figures::default();
        for (i, &got) in (start..).zip(results) {
            let n = i as u32;
            let expected = self.twin.value(n, &mut odometer);
            figures.compared += 1;
            figures.judged += 1;
            if got != expected {
                figures.differs(i, || format!("{n}: {got:08x}, not {expected:08x}"));
            }
            if truth.is(got) {
                figures.rounded(Rounding::Correct);
            } else {
                figures.rounded(Rounding::Other);
                let what = || format!("{:08x?}", [n, self.base, 0, 0]);
                figures.error(i, f64::INFINITY, what);
            }
            truth.step();
        }
        figures
    }
}
