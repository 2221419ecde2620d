//! How good a point set is: measures of points in [0, 1)^d, as pure functions in `f64`.
//!
//! ```
//! use corput::stats::{Points, Source, spectrum};
//!
//! let points = Points::new(2, vec![0.0, 0.0, 0.5, 0.5], Source::F64)?;
//! // Two points half a period apart: odd frequencies cancel, even ones add up.
//! let spectrum = spectrum(&points.pairs(0, 1)?, 2, &mut |_, _| Ok(()))?;
//! assert!(spectrum.power(1, 0) < 1e-12);
//! assert!((spectrum.power(1, 1) - 2.0).abs() < 1e-12);
//! # Ok::<(), corput::Error>(())
//! ```

mod distance;
mod l2;
mod net;
mod points;
mod projections;
mod spectrum;
mod star;
mod star_bounds;

pub use distance::{Nearest, hexagonal_distance, nearest};
pub use l2::{L2, L2_KINDS, L2Value, l2_discrepancy, l2_from_pairs};
pub use net::{MAX_SHAPES, Shape, TValue, elementary_intervals, t_value};
pub use points::{Points, Source};
pub use projections::{Projection, projections};
pub use spectrum::{MAX_RANGE, Ring, Spectrum, spectrum, spectrum_range};
pub use star::{star_1d, star_2d};
pub use star_bounds::{StarBounds, star_bounds};

use crate::error::{Error, Result};

/// Told how much of a measure is done, out of how much; an error from it ends the work.
pub type Progress<'a> = &'a mut dyn FnMut(u64, u64) -> Result<()>;

/// Threads to share work among.
fn threads() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

fn refused(asked: impl Into<String>, limit: impl Into<String>, remedy: impl Into<String>) -> Error {
    Error::Arguments {
        asked: asked.into(),
        limit: limit.into(),
        remedy: remedy.into(),
    }
}
