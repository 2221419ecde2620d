//! Samples of a scene on the CPU, by the twins: what kernels made for the scene must equal.

use super::column::Prepared;
use super::maps::map_sample;
use crate::Result;
use crate::catalog::{Mapping, Profile};
use crate::scene::{Choice, Draw, Needs, Record, Span};

/// The records of a scene's samples.
pub struct SceneReference {
    columns: Vec<Prepared>,
    draws: Vec<(usize, Drawn)>,
    record: Record,
    profile: Profile,
}

/// A draw, prepared.
enum Drawn {
    Between(Option<Span>),
    Choice(Choice),
    Map(Mapping),
}

impl SceneReference {
    /// Prepares a scene's domains.
    ///
    /// # Errors
    /// Those of [`Span::new`] and [`Choice::new`].
    pub fn new(needs: &Needs) -> Result<Self> {
        let mut draws = Vec::new();
        for domain in &needs.domains {
            let drawn = match &domain.draw {
                Draw::Between(ends) => Drawn::Between(Span::new(*ends)?),
                Draw::Choice(weights) => Drawn::Choice(Choice::new(weights)?),
                Draw::Map(mapping) => Drawn::Map(mapping.clone()),
            };
            draws.push((domain.first as usize, drawn));
        }
        Ok(Self {
            columns: needs.request.columns.iter().map(Prepared::new).collect(),
            draws,
            record: Record::of(needs),
            profile: needs.request.profile,
        })
    }

    /// What a record has.
    #[must_use]
    pub fn record(&self) -> &Record {
        &self.record
    }

    /// Fills `words` with whole records of consecutive samples from index `first` on, which may
    /// not go past 2^32, by all cores.
    pub fn fill(&self, first: u32, words: &mut [u32]) {
        let width = self.record.words.max(1) as usize;
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let share = (words.len() / width).div_ceil(threads).max(1);
        std::thread::scope(|scope| {
            for (part, words) in (0u32..).zip(words.chunks_mut(share * width)) {
                let first = first.wrapping_add(part.wrapping_mul(share as u32));
                scope.spawn(move || self.fill_part(first, words));
            }
        });
    }

    fn fill_part(&self, first: u32, words: &mut [u32]) {
        let records = words.chunks_exact_mut(self.record.words.max(1) as usize);
        for (n, record) in (first..=u32::MAX).zip(records) {
            for ((dimension, drawn), field) in self.draws.iter().zip(&self.record.fields) {
                let made = self.draw(drawn, *dimension, n);
                if let Some(into) = record.get_mut(field.range()) {
                    into.copy_from_slice(made.get(..into.len()).unwrap_or_default());
                }
            }
        }
    }

    fn draw(&self, drawn: &Drawn, dimension: usize, n: u32) -> [u32; 4] {
        let column = |more: usize| self.columns.get(dimension + more);
        let fraction = |more: usize| column(more).map_or(0, |column| column.fraction(n));
        match drawn {
            Drawn::Between(span) => {
                let u = fraction(0);
                let plain = || column(0).map_or(0.0, |column| column.unit(u));
                let x = span.map_or_else(plain, |span| span.at(u));
                [x.to_bits(), 0, 0, 0]
            }
            Drawn::Choice(choice) => {
                let share = choice.draw(fraction(0));
                [share.index, share.probability.to_bits(), 0, 0]
            }
            Drawn::Map(mapping) => {
                let mut u = [0; 3];
                let taken = mapping.map().dimensions as usize;
                for (axis, into) in u.iter_mut().enumerate().take(taken) {
                    *into = fraction(axis);
                }
                map_sample(mapping, self.profile, u)
            }
        }
    }
}
