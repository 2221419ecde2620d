//! What one sample of a scene consists of: words of each domain, one after the other.

use super::needs::{Domain, Draw, Needs, refused};
use crate::Result;
use crate::reference::real::{
    Real, real, real_add, real_float, real_min, real_multiply, real_subtract, real_uint,
};
use std::ops::Range;

/// The words of a domain.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// The domain's key.
    pub key: String,
    /// A name of it for programs: letters, digits and single `_`, unique in the record.
    pub name: String,
    /// Its first word in the record.
    pub first: u32,
    /// What its words are: `index` is a `u32`, all others are `f32`.
    pub values: Vec<&'static str>,
}

impl Field {
    /// Its words in the record.
    #[must_use]
    pub fn range(&self) -> Range<usize> {
        let first = self.first as usize;
        first..first + self.values.len()
    }
}

/// The words of a sample: all domains, also those of alternatives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Record {
    /// As the domains.
    pub fields: Vec<Field>,
    /// Words in all.
    pub words: u32,
}

impl Record {
    /// That of a scene's domains.
    #[must_use]
    pub fn of(needs: &Needs) -> Self {
        let mut fields: Vec<Field> = Vec::new();
        let mut words = 0;
        for domain in &needs.domains {
            let values = values(domain);
            let count = values.len() as u32;
            let plain = plain_name(&domain.key);
            let taken = |name: &str| fields.iter().any(|one| one.name.eq_ignore_ascii_case(name));
            let numbered = (2..).map(|number| format!("{plain}_{number}"));
            let mut names = std::iter::once(plain.clone()).chain(numbered);
            let name = names.find(|name| !taken(name)).unwrap_or_default();
            fields.push(Field {
                key: domain.key.clone(),
                name,
                first: words,
                values,
            });
            words += count;
        }
        Self { fields, words }
    }
}

fn values(domain: &Domain) -> Vec<&'static str> {
    match &domain.draw {
        Draw::Between(_) => vec!["value"],
        Draw::Choice(_) => vec!["index", "probability"],
        Draw::Map(mapping) => {
            let axes = ["x", "y", "z"].into_iter();
            let coordinates = axes.take(mapping.map().coordinates as usize);
            coordinates.chain(["pdf"]).collect()
        }
    }
}

/// A key without signs that programs do not have in names, and two `_` in a row, which GLSL
/// and C++ keep for themselves.
fn plain_name(key: &str) -> String {
    let words = key.split(|c: char| !c.is_ascii_alphanumeric());
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    words.join("_")
}

/// A number between two, ends included: low + (high - low) u / 2^32 in software reals, which
/// are cut to 32 bits, and then rounded to the nearest float. Integers alone: tier I.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// The lower end.
    pub low: Real,
    /// The upper end.
    pub high: Real,
    /// The upper end less the lower.
    pub width: Real,
}

impl Span {
    /// The span between two ends; `None` of [0, 1), whose numbers are the points' own floats.
    ///
    /// # Errors
    /// [`Error::Arguments`](crate::Error::Arguments) for ends that are not two normal floats or
    /// 0, the lower first.
    pub fn new([low, high]: [f64; 2]) -> Result<Option<Self>> {
        let (low, high) = (low as f32, high as f32);
        let fine = |x: f32| x == 0.0 || x.is_normal();
        if !(low < high && fine(low) && fine(high)) {
            return Err(refused(
                format!("a number from {low:e} to {high:e}"),
                "ends are two floats, the lower first, each 0 or from 2^-126 to 2^128 in magnitude",
                "choose another unit, or leave it out",
            ));
        }
        let (from, to) = (real(low), real(high));
        Ok(((low, high) != (0.0, 1.0)).then(|| Self {
            low: from,
            high: to,
            width: real_subtract(to, from),
        }))
    }

    /// The number of a fraction of 2^32.
    #[must_use]
    pub fn at(self, u: u32) -> f32 {
        let part = real_multiply(self.width, real_uint(u, -32));
        real_float(real_min(real_add(self.low, part), self.high))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stay_between_their_ends() {
        for ends in [
            [0.0, 2.0],
            [0.1, 0.7],
            [-3.0, 1e6],
            [1e6, 1_000_001.0],
            [-1.0, 0.0],
        ] {
            let span = Span::new(ends).unwrap().unwrap();
            let [low, high] = ends.map(|end| f64::from(end as f32));
            assert_eq!(f64::from(span.at(0)), low);
            for u in [1, 77, 1 << 31, 0xdead_beef, u32::MAX] {
                let exact = low + (high - low) * f64::from(u) / 2f64.powi(32);
                let got = f64::from(span.at(u));
                let allowed = exact.abs() * 2f64.powi(-24) + (high - low) * 2f64.powi(-31);
                assert!(
                    (got - exact).abs() <= allowed,
                    "{ends:?} at {u}: {got} {exact}"
                );
                assert!((low..=high).contains(&got));
            }
        }
        assert_eq!(Span::new([0.0, 1.0]).unwrap(), None);
        for ends in [
            [1.0, 1.0],
            [1.0, 1.0 + 1e-12],
            [0.0, 1e-40],
            [0.0, 1e39],
            [2.0, 1.0],
        ] {
            assert!(Span::new(ends).is_err(), "{ends:?}");
        }
    }

    #[test]
    fn names_are_plain() {
        assert_eq!(plain_name("material.a-b__c.ggx_"), "material_a_b_c_ggx");
    }
}
