//! The fractions that the row of a map samples, each made from its number alone.

use super::RANDOM;
use super::edges::edges;
use crate::Result;
use crate::catalog::{Map, Mapping};
use crate::check::{examples, mix};

/// One in so many random inputs is judged: some judges bisect.
const JUDGED: u64 = 1 << 8;

/// One in so many of all 2^32 words.
const JUDGED_WORDS: u64 = 1 << 12;

/// The third fraction beside a pair of critical ones.
const THIRDS: [u32; 3] = [0, 1 << 31, u32::MAX];

/// Places of a pair and of the third fraction, in turn.
const TURNS: u64 = 3;

/// Which part of a row inputs are of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    /// Critical values: one, or all pairs; of three fractions, pairs in every two places.
    Critical,
    /// Random ones.
    Random,
    /// Every word.
    Words,
}

/// Inputs from number `start` to before number `end`, of one parameter set.
#[derive(Clone, Copy, Debug)]
struct Run {
    start: u64,
    end: u64,
    set: usize,
    part: Part,
}

/// A parameter set, and the critical fractions to sample it with.
#[derive(Debug)]
struct Set {
    mapping: Mapping,
    critical: Vec<u32>,
}

/// The inputs of a row: of each parameter set of `corput check`, critical fractions; then random
/// fractions, as many of each set; then, of maps of one fraction, every word by the first set.
#[derive(Debug)]
pub struct Fractions {
    map: &'static Map,
    sets: Vec<Set>,
    runs: Vec<Run>,
}

/// An input.
#[derive(Clone, Copy, Debug)]
pub struct Input<'a> {
    /// The map and its parameters.
    pub mapping: &'a Mapping,
    /// The fractions; 0 in places that the map does not take.
    pub u: [u32; 3],
    /// Whether the result is compared with the truth, too.
    pub judged: bool,
}

impl Fractions {
    /// All inputs of the row of a map.
    ///
    /// # Errors
    /// None, if the catalogue's examples are in their domains.
    pub fn new(map: &'static Map) -> Result<Self> {
        let mut all = Self::critical(map)?;
        let sets = all.sets.len() as u64;
        let first = all.count();
        // Contiguous shares, so that a dispatch has one parameter set.
        all.runs.extend((0..sets).map(|set| Run {
            start: first + RANDOM * set / sets,
            end: first + RANDOM * (set + 1) / sets,
            set: set as usize,
            part: Part::Random,
        }));
        if map.dimensions == 1 {
            all.push(0, Part::Words, 1 << 32);
        }
        Ok(all)
    }

    /// Those of critical fractions alone.
    ///
    /// # Errors
    /// As [`Fractions::new`].
    pub fn critical(map: &'static Map) -> Result<Self> {
        let sets = examples(map)?.into_iter().map(|mapping| Set {
            critical: list(&mapping),
            mapping,
        });
        let mut all = Self {
            map,
            sets: sets.collect(),
            runs: Vec::new(),
        };
        for set in 0..all.sets.len() {
            let side = all.sets.get(set).map_or(0, |set| set.critical.len() as u64);
            let inputs = match map.dimensions {
                1 => side,
                2 => side * side,
                _ => side * side * TURNS * THIRDS.len() as u64,
            };
            all.push(set, Part::Critical, inputs);
        }
        Ok(all)
    }

    /// All inputs of the row of a map, in words.
    #[must_use]
    pub fn describe(map: &Map) -> String {
        let values = critical().len();
        let by = "by parameter sets of `corput check`";
        match map.dimensions {
            1 => format!(
                "{values} critical values and 2^24 random words, {by}, and all 2^32 words by the first"
            ),
            2 => format!(
                "all pairs of {values} critical values and edges, and 2^24 random inputs, {by}"
            ),
            _ => format!(
                "all pairs of {values} critical values and edges in any two places with {} values in \
                 the third, and 2^24 random inputs, {by}",
                THIRDS.len()
            ),
        }
    }

    fn push(&mut self, set: usize, part: Part, inputs: u64) {
        let start = self.count();
        self.runs.push(Run {
            start,
            end: start + inputs,
            set,
            part,
        });
    }

    /// The map.
    #[must_use]
    pub fn map(&self) -> &'static Map {
        self.map
    }

    /// The parameter sets.
    pub fn mappings(&self) -> impl Iterator<Item = &Mapping> {
        self.sets.iter().map(|set| &set.mapping)
    }

    /// How many inputs there are.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.runs.last().map_or(0, |run| run.end)
    }

    /// Input number `i`, and the number of the first one after it that is of another run;
    /// `None` beyond the last.
    #[must_use]
    pub fn at(&self, i: u64) -> Option<(Input<'_>, u64)> {
        let run = self.runs.partition_point(|run| run.end <= i);
        let run = self.runs.get(run)?;
        let set = self.sets.get(run.set)?;
        let n = i - run.start;
        let (mut u, judged) = match run.part {
            Part::Critical => (pair(&set.critical, self.map.dimensions, n), true),
            Part::Random => {
                // By the number among all random inputs: sets do not share fractions.
                let n = (i - self.first_random()) as u32;
                let words = [0, 1, 2].map(|j| mix(n.wrapping_mul(3).wrapping_add(j)));
                (words, u64::from(n).is_multiple_of(JUDGED))
            }
            Part::Words => ([n as u32, 0, 0], n.is_multiple_of(JUDGED_WORDS)),
        };
        for (place, word) in (0..).zip(&mut u) {
            if place >= self.map.dimensions {
                *word = 0;
            }
        }
        let input = Input {
            mapping: &set.mapping,
            u,
            judged,
        };
        Some((input, run.end))
    }

    /// Whether they are all inputs of the row.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.runs.iter().any(|run| run.part == Part::Random)
    }

    fn first_random(&self) -> u64 {
        let first = self.runs.iter().find(|run| run.part == Part::Random);
        first.map_or(0, |run| run.start)
    }

    /// A parameter set in words: its values, or for want of such its number among those of
    /// the map.
    #[must_use]
    pub fn label(&self, mapping: &Mapping) -> String {
        let at = self.mappings().position(|one| std::ptr::eq(one, mapping));
        match (self.sets.len(), mapping.values()) {
            (0 | 1, []) => String::new(),
            (_, []) => format!("set {} ", at.unwrap_or(0)),
            (_, values) => format!("{values:?} "),
        }
    }
}

/// Fractions of critical values, number `n` of those for so many places.
fn pair(critical: &[u32], dimensions: u32, n: u64) -> [u32; 3] {
    let side = critical.len().max(1) as u64;
    let value = |at: u64| critical.get((at % side) as usize).copied().unwrap_or(0);
    if dimensions == 1 {
        return [value(n), 0, 0];
    }
    let rest = n / (side * side);
    let third = THIRDS.get((rest / TURNS) as usize).copied().unwrap_or(0);
    let mut u = [value(n / side), value(n), third];
    u.rotate_right((rest % TURNS) as usize);
    u
}

/// The critical fractions of a parameter set: those of all maps, and the edges of its own.
fn list(mapping: &Mapping) -> Vec<u32> {
    let mut list = critical();
    let known: std::collections::BTreeSet<u32> = list.iter().copied().collect();
    list.extend(edges(mapping).into_iter().filter(|u| !known.contains(u)));
    list
}

/// Both ends, every power of two from either, with their neighbours, and the eighths, thirds
/// and fifths: 200 values, ascending. Where floats begin to be rounded, 2^24 from either end,
/// is among them; so are the seams of quadrants and of the disk's diagonals.
#[must_use]
pub fn critical() -> Vec<u32> {
    let mut list = Vec::new();
    let near = |word: u32| [word.wrapping_sub(1), word, word.wrapping_add(1)];
    for bit in 0..32 {
        list.extend(near(1 << bit));
        list.extend(near((1u32 << bit).wrapping_neg()));
    }
    list.extend([3, 5].into_iter().flat_map(|eighth| near(eighth << 29)));
    for parts in [3u64, 5] {
        for part in 1..parts {
            let below = ((part << 32) / parts) as u32;
            list.extend([below, below + 1]);
        }
    }
    list.sort_unstable();
    list.dedup();
    list
}

#[cfg(test)]
mod tests {
    use super::{Fractions, critical, pair};
    use crate::catalog::{Map, maps};
    use std::collections::BTreeSet;

    #[test]
    fn two_hundred_values_are_critical() {
        let list = critical();
        assert_eq!(list.len(), 200);
        let third = 0x5555_5555;
        for value in [0, 1, 2, third, third + 1, 1 << 31, !1, u32::MAX] {
            assert!(list.contains(&value), "{value:#x}");
        }
    }

    #[test]
    fn pairs_are_all_there_in_any_two_of_three_places() {
        let values = [1, 2, 3, 4];
        let all: BTreeSet<_> = (0..16).map(|n| pair(&values, 2, n)).collect();
        assert_eq!(all.len(), 16);
        let all: BTreeSet<_> = (0..16 * 9).map(|n| pair(&values, 3, n)).collect();
        assert_eq!(all.len(), 16 * 9);
        for places in [[0, 1], [1, 2], [2, 0]] {
            let pairs: BTreeSet<_> = all
                .iter()
                .map(|u| places.map(|place| u[place]))
                .filter(|two| two.iter().all(|u| values.contains(u)))
                .collect();
            assert_eq!(pairs.len(), 16, "{places:?}");
        }
    }

    /// Runs follow each other without a gap, and each set has its share of all parts.
    #[test]
    fn inputs_are_whole() {
        for map in maps() {
            let all = Fractions::new(map).expect("examples");
            let sets = all.mappings().count() as u64;
            let (mut at, mut runs) = (0, 0);
            while let Some((input, end)) = all.at(at) {
                assert!(end > at && input.mapping.map() == map);
                let beyond = &input.u[map.dimensions as usize..];
                assert!(beyond.iter().all(|u| *u == 0), "{}", map.name);
                (at, runs) = (end, runs + 1);
            }
            assert_eq!(at, all.count(), "{}", map.name);
            let words = u64::from(map.dimensions == 1);
            assert_eq!(runs, 2 * sets + words, "{}", map.name);
            let critical = Fractions::critical(map).expect("examples").count();
            assert_eq!(at, critical + (1 << 24) + (words << 32), "{}", map.name);
            let pairs = [200, 40_000, 360_000][map.dimensions as usize - 1];
            assert!(critical >= pairs * sets, "{}: {critical}", map.name);
        }
    }

    #[test]
    fn edges_of_a_polygon_are_critical() {
        let map = Map::from_name("regular-polygon").expect("it is there");
        let all = Fractions::critical(map).expect("examples");
        // The first set has three sides, whose edges are thirds; the fourth a thousand.
        let edge = ((1u64 << 32) / 1000) as u32;
        let found = (0..all.count())
            .filter_map(|i| all.at(i))
            .filter(|(input, _)| input.u[0] == edge || input.u[0] == edge + 1);
        let sides: BTreeSet<_> = found
            .map(|(input, _)| input.mapping.values()[0] as u32)
            .collect();
        assert_eq!(sides, [1000].into());
    }
}
