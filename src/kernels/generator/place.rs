//! Any number of points into a buffer, by short dispatches.

use super::Generator;
use super::record::{ASIDE, check_room};
use crate::catalog::check_points;
use crate::vulkan::{BufferSlice, Timing};
use crate::{Error, Result};
use std::time::Instant;

impl Generator {
    /// Makes points, `start` counted from the request's first, and waits for them. They are
    /// written as [`Self::submit`] does, by as many submissions as
    /// [`Engine::chunk`](crate::catalog::Engine::chunk) says, which learns from their time.
    /// While the device works on one, `meanwhile` is called with its number of points; its time
    /// counts as the device's where it takes longer.
    ///
    /// # Errors
    /// Those of `meanwhile`, after which the device has ended what it was at and begins no more;
    /// those of [`Self::submit`], but for the number of points.
    pub fn place(
        &mut self,
        start: u64,
        count: u64,
        target: &BufferSlice,
        meanwhile: &mut dyn FnMut(u64) -> Result<()>,
    ) -> Result<()> {
        let row = 4 * self.width;
        check_points(self.count, start, count)?;
        check_room(count, row, target)?;
        let mut done = 0;
        while done < count {
            let points = self.piece(count - done)?;
            let part = target.part(done * row, points * row);
            let begun = Instant::now();
            let mut flying = self.submit(start + done, points, &part)?;
            meanwhile(points)?;
            flying.wait()?;
            let timing = Timing {
                device_ns: None,
                host_ns: begun.elapsed().as_nanos() as f64,
            };
            done += points;
            self.adapt(points, &timing);
        }
        Ok(())
    }

    /// Points of the next submission of so many that are left. Where it is not the last, whole
    /// tiles, and so many that the next begins where every device can bind a buffer.
    fn piece(&self, left: u64) -> Result<u64> {
        let unit = least_common_multiple(self.points.tile(), ASIDE);
        let longest = if left <= self.limit {
            left
        } else {
            self.limit / unit * unit
        };
        if longest == 0 {
            return Err(Error::Arguments {
                asked: format!("{left} points of {} words into a buffer", self.width),
                limit: format!(
                    "{} are made at a time, and parts begin at multiples of {unit}",
                    self.limit
                ),
                remedy: "ask for so few at a time".into(),
            });
        }
        Ok((self.chunk / unit * unit).clamp(unit.min(longest), longest))
    }
}

fn least_common_multiple(a: u64, b: u64) -> u64 {
    let (mut x, mut y) = (a, b);
    while y > 0 {
        (x, y) = (y, x % y);
    }
    a / x.max(1) * b
}
