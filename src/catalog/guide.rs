//! What the sequences are for, in words.

use super::Sequence;

/// What one needs to know to choose a sequence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Guide {
    /// What it is.
    pub what: &'static str,
    /// What to use it for.
    pub purpose: &'static str,
    /// Numbers of points that it has, and prefixes that keep its guarantee.
    pub points: &'static str,
    /// Author and year of the papers.
    pub source: &'static str,
}

impl Sequence {
    /// What it is, when to use it, and which of its prefixes are good.
    #[must_use]
    pub fn guide(self) -> Guide {
        match self {
            Self::Random => Guide {
                what: "random numbers by counter, Philox-4x32-10",
                purpose: "plain Monte Carlo; streams without a state in memory",
                points: "any number; nothing is guaranteed",
                source: "Salmon, Moraes, Dror and Shaw 2011",
            },
            Self::RandomFast => Guide {
                what: "random numbers by counter, pcg4d with half a third round",
                purpose: "random numbers where speed counts",
                points: "any number; nothing is guaranteed",
                source: "Jarzynski and Olano 2020",
            },
            Self::Pcg32 => Guide {
                what: "random numbers one after another, PCG32",
                purpose: "the numbers that other software with PCG32 has",
                points: "any number; nothing is guaranteed",
                source: "O'Neill 2014",
            },
            Self::Stratified => Guide {
                what: "one jittered point in each cell of a grid",
                purpose: "few dimensions, and a number of points with divisors",
                points: "a set of any N; a prime N has its cells along one axis",
                source: "Cook 1986",
            },
            Self::LatinHypercube => Guide {
                what: "one jittered point in each of N strata of each axis",
                purpose: "many dimensions that matter one by one",
                points: "a set of any N",
                source: "McKay, Beckman and Conover 1979",
            },
            Self::MultiJittered => Guide {
                what: "correlated multi-jittered: cells of a grid, and N strata of each axis",
                purpose: "pixels, lenses and lights with a number of points known beforehand",
                points: "a set of N = m x n; a prime N above 3 needs a grid of 1 x N",
                source: "Kensler 2013",
            },
            Self::VanDerCorput => Guide {
                what: "radical inverse in one base b",
                purpose: "one dimension",
                points: "any number; b^k in a row have one in each 1/b^k",
                source: "van der Corput 1935",
            },
            Self::Halton => Guide {
                what: "radical inverses in distinct primes",
                purpose: "numbers of points not known beforehand; in many dimensions scrambled",
                points: "any number; 2^i x 3^j in a row have one in each box of that grid",
                source: "Halton 1960",
            },
            Self::Hammersley => Guide {
                what: "k/N and radical inverses",
                purpose: "a lower discrepancy than Halton's, for a number of points known beforehand",
                points: "a set of any N; no prefix of it",
                source: "Hammersley 1960",
            },
            Self::Sobol => Guide {
                what: "digital sequence in base 2, directions of Joe and Kuo",
                purpose: "integrals of any dimension; scrambled, with an estimate of the error",
                points: "any number; each prefix of 2^k is a digital net, scrambled or not",
                source: "Sobol 1967, Joe and Kuo 2008",
            },
            Self::Pmj02 => Guide {
                what: "progressive multi-jittered (0,2): a shuffled, scrambled Sobol pair",
                purpose: "two dimensions that are refined as long as time allows",
                points: "any number; each prefix of 2^k has one in each interval of area 2^-k",
                source: "Christensen, Kensler and Kilpatrick 2018",
            },
            Self::Lattice => Guide {
                what: "embedded rank-1 lattice",
                purpose: "smooth, best periodic, integrands at little cost",
                points: "1 to 2^20; each prefix of 2^k is a lattice",
                source: "Cools, Kuo and Nuyens 2006",
            },
            Self::Korobov => Guide {
                what: "rank-1 lattice of one generator",
                purpose: "smooth, best periodic, integrands; a number known beforehand",
                points: "a set of N = 1021, 2039, 4093, 8191, 16381, 32749, 65521, or with a \
                         generator any N; no prefix of it",
                source: "Korobov 1960, L'Ecuyer and Lemieux 2000",
            },
            Self::R2 => Guide {
                what: "additive recurrence by the generalised golden ratio",
                purpose: "two dimensions at the least cost",
                points: "any number; nothing is guaranteed",
                source: "Roberts 2018",
            },
        }
    }
}
