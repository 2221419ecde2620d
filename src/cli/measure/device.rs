//! Measures over pairs of points on a device.

use super::host;
use corput::Result;
use corput::bulk::{Columns, NearestWords, l2_from_sum, pair_kind_of, pair_scale};
use corput::kernels::Pairs;
use corput::stats::{L2, L2Value, Nearest, Points, Progress};
use corput::vulkan::{Device, DeviceKind};
use std::sync::Arc;

/// A device, and the points as it takes them.
pub struct OnDevice {
    device: Arc<Device>,
    columns: Columns,
}

impl OnDevice {
    pub fn new(device: Arc<Device>, points: &Points) -> Result<Self> {
        let columns = Columns::new(points)?;
        Ok(Self { device, columns })
    }

    /// The device in a line.
    pub fn line(&self) -> String {
        host::line(self.device.info())
    }

    /// Whether the points are as they were, and not rounded down to multiples of 2^-32.
    pub fn is_exact(&self) -> bool {
        self.columns.is_exact()
    }

    /// How much more work than the CPU it may be given.
    pub fn speed(&self) -> u64 {
        match self.device.info().kind {
            DeviceKind::Cpu => 1,
            _ => 64,
        }
    }

    pub fn validated(&self) -> Result<()> {
        host::validated(self.device.instance())
    }

    pub fn l2(&self, kind: L2, progress: Progress) -> Result<L2Value> {
        let columns = &self.columns;
        let dimensions = columns.dimensions();
        let scale = pair_scale(kind, dimensions);
        let kernel = pair_kind_of(kind);
        let sum =
            Pairs::sums(&self.device, columns.words(), dimensions, kernel)?.sum(scale, progress)?;
        l2_from_sum(kind, columns, sum, scale)
    }

    pub fn nearest(&self, toroidal: bool, progress: Progress) -> Result<Option<Nearest>> {
        let columns = &self.columns;
        let mut best = None;
        Pairs::nearest(
            &self.device,
            columns.words(),
            columns.dimensions(),
            toroidal,
        )?
        .search(
            &mut |row, square, other| NearestWords::keep(&mut best, row, square, other),
            progress,
        )?;
        Ok(best.map(|best: NearestWords| best.nearest()))
    }
}
