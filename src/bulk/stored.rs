//! Points that are there already, as an engine.

use super::map_sample;
use crate::Result;
use crate::catalog::{Engine, Mapping, Output, Profile};
use crate::reference::unit::unit_floor;

/// Serves points of two dimensions from memory, as fractions, as floats or through a map.
#[derive(Clone, Debug)]
pub struct Stored {
    /// The points, as fractions of 2^32.
    pub points: Vec<[u32; 2]>,
    /// What words to make, where there is no map.
    pub output: Output,
    /// The map, if any.
    pub map: Option<Mapping>,
    /// Whether the pdf follows the coordinates.
    pub with_pdf: bool,
    /// Whose functions the map uses; the native ones are this CPU's.
    pub profile: Profile,
}

/// Points at a time.
const PIECE: u64 = 1 << 12;

impl Stored {
    /// Words of a result row.
    #[must_use]
    pub fn words_per_point(&self) -> u32 {
        match &self.map {
            Some(mapping) => mapping.map().coordinates + u32::from(self.with_pdf),
            None => 2,
        }
    }

    fn row(&self, [x, y]: [u32; 2]) -> [u32; 4] {
        match (&self.map, self.output) {
            (Some(mapping), _) => map_sample(mapping, self.profile, [x, y, 0]),
            (None, Output::Fractions) => [x, y, 0, 0],
            (None, Output::Floats) => [unit_floor(x).to_bits(), unit_floor(y).to_bits(), 0, 0],
        }
    }
}

impl Engine for Stored {
    fn count(&self) -> u64 {
        self.points.len() as u64
    }

    fn words_per_point(&self) -> u32 {
        Self::words_per_point(self)
    }

    fn make(
        &mut self,
        start: u64,
        count: u64,
        take: &mut dyn FnMut(&[u32]) -> Result<()>,
    ) -> Result<()> {
        let width = self.words_per_point() as usize;
        let points = self.points.iter().skip(start as usize).take(count as usize);
        let words: Vec<u32> = points
            .flat_map(|point| self.row(*point).into_iter().take(width))
            .collect();
        take(&words)
    }

    fn chunk(&self) -> u64 {
        PIECE
    }
}
