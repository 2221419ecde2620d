//! Samplers as studies name them: a sequence and its scramble, `sobol:owen`.

use super::{Options, Request, SEQUENCES, Scramble, Sequence};
use crate::{Error, Result};

/// A sequence with a way to randomise it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampler {
    sequence: Sequence,
    scramble: Option<Scramble>,
}

impl Sampler {
    /// A sequence, and a scramble that it knows; `None` is the sequence as it is, and for
    /// lattices rotated where a seed is given.
    ///
    /// # Errors
    /// [`Error::UnknownName`] for a scramble that the sequence does not have.
    pub fn new(sequence: Sequence, scramble: Option<Scramble>) -> Result<Self> {
        match scramble {
            Some(one) if !sequence.scrambles().contains(&one) => {
                Err(unknown_scramble(sequence, one.name()))
            }
            _ => Ok(Self { sequence, scramble }),
        }
    }

    /// From `NAME` or `NAME:SCRAMBLE`.
    ///
    /// # Errors
    /// [`Error::UnknownName`], with the nearest name.
    pub fn parse(text: &str) -> Result<Self> {
        let (name, scramble) = match text.split_once(':') {
            Some((name, scramble)) => (name, Some(scramble)),
            None => (text, None),
        };
        let sequence = Sequence::from_name(name).map_err(|_| {
            let known: Vec<&str> = SEQUENCES.iter().map(|one| one.name()).collect();
            Error::unknown_name("sampler", name, &known)
        })?;
        let scramble = scramble
            .map(|name| Scramble::from_name(name).map_err(|_| unknown_scramble(sequence, name)));
        Self::new(sequence, scramble.transpose()?)
    }

    /// As [`Self::parse`] takes it.
    #[must_use]
    pub fn name(self) -> String {
        match self.scramble {
            None => self.sequence.name().to_owned(),
            Some(scramble) => format!("{}:{}", self.sequence.name(), scramble.name()),
        }
    }

    /// The sequence.
    #[must_use]
    pub fn sequence(self) -> Sequence {
        self.sequence
    }

    /// The scramble, where one was named.
    #[must_use]
    pub fn scramble(self) -> Option<Scramble> {
        self.scramble
    }

    /// Whether another seed gives other points.
    #[must_use]
    pub fn is_random(self) -> bool {
        match self.scramble {
            Some(scramble) => scramble.is_random(),
            // Sequences without a scramble are random by themselves, but for the few that
            // only a seed changes.
            None => {
                self.sequence.scrambles().is_empty()
                    || self.sequence.default_scramble(true).is_random()
            }
        }
    }

    /// Whether its points are independent of each other, so that their variance spreads as theory
    /// has it.
    #[must_use]
    pub fn is_independent(self) -> bool {
        matches!(
            self.sequence,
            Sequence::Random | Sequence::RandomFast | Sequence::Pcg32
        )
    }

    /// What its first `count` points lack that as many as a power of two have, in a sentence;
    /// `None` where nothing is lost.
    #[must_use]
    pub fn lost_at(self, count: u64) -> Option<String> {
        let whole = match self.sequence {
            Sequence::Sobol | Sequence::Pmj02 => "a net with points in every elementary interval",
            Sequence::Lattice => "a lattice",
            _ => return None,
        };
        (!count.is_power_of_two()).then(|| {
            format!(
                "{count} points are no power of two, and only so many are {whole}: expect a \
                 larger error than the next lower power of two may have"
            )
        })
    }

    /// Its first `count` points as fractions; of a set, the whole set of so many. The seed
    /// matters only to samplers that are random.
    ///
    /// # Errors
    /// Those of [`Request::new`].
    pub fn request(self, dimensions: u32, count: u64, seed: u64) -> Result<Request> {
        Request::new(&Options {
            dimensions: Some(dimensions.into()),
            seed: self.is_random().then_some(seed),
            scramble: self.scramble,
            fractions: true,
            ..Options::new(self.sequence, count)
        })
    }
}

fn unknown_scramble(sequence: Sequence, name: &str) -> Error {
    let known: Vec<&str> = sequence.scrambles().iter().map(|one| one.name()).collect();
    if known.is_empty() {
        return Error::Arguments {
            asked: format!("{}:{name}", sequence.name()),
            limit: format!(
                "{} is random by itself, and takes no scramble",
                sequence.name()
            ),
            remedy: "leave the scramble out; the seed changes its points".into(),
        };
    }
    Error::unknown_name("scramble", name, &known)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_come_back_and_wrong_ones_are_refused() {
        for text in ["random", "sobol:owen", "halton:permute", "lattice:rotate"] {
            assert_eq!(
                Sampler::parse(text).map(Sampler::name).ok().as_deref(),
                Some(text)
            );
        }
        let said = |text: &str| Sampler::parse(text).unwrap_err().to_string();
        assert!(
            said("sobl").contains("did you mean `sobol`"),
            "{}",
            said("sobl")
        );
        assert!(said("sobol:owne").contains("did you mean `owen`"));
        assert!(said("halton:matrix").contains("permute"));
        assert!(said("random:owen").contains("random by itself"));
    }

    #[test]
    fn nets_and_lattices_lose_what_powers_of_two_have() {
        let lost = |text: &str, count| Sampler::parse(text).unwrap().lost_at(count).is_some();
        assert!(lost("sobol:owen", 1000) && lost("lattice", 3) && lost("pmj02", 5));
        assert!(!lost("sobol:owen", 1024) && !lost("halton", 1000) && !lost("random", 1000));
    }

    #[test]
    fn a_seed_changes_the_points_of_random_samplers_alone() {
        for &sequence in SEQUENCES {
            let scrambles = sequence.scrambles().iter().copied().map(Some);
            for scramble in scrambles.chain([None]) {
                let sampler = Sampler::new(sequence, scramble).unwrap();
                let d = sequence.dimensions().0.max(2).min(sequence.dimensions().1);
                // Korobov's generators are published for a few numbers of points; grids need
                // divisors.
                let count = if sequence == Sequence::Korobov {
                    1021
                } else {
                    1024
                };
                let made = |seed| sampler.request(d, count, seed).unwrap().columns;
                assert_eq!(
                    made(1) != made(2),
                    sampler.is_random(),
                    "{}",
                    sampler.name()
                );
            }
        }
    }
}
