//! What mask to make, and the pattern that it grows from.

use super::random::word;
use crate::{Error, Result};

/// Size of a dither mask: `frames` images of `width` x `height` pixels, that of frame f,
/// row y and column x at `(f * height + y) * width + x`. All three axes wrap around.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct MaskShape {
    /// Columns.
    pub width: u32,
    /// Rows of a frame.
    pub height: u32,
    /// Frames; 1 for a mask that does not change over time.
    pub frames: u32,
}

impl MaskShape {
    /// The least width and height.
    pub const MIN_SIDE: u32 = 4;
    /// The largest width and height.
    pub const MAX_SIDE: u32 = 256;
    /// The most frames.
    pub const MAX_FRAMES: u32 = 16;
    /// The most pixels of all frames together: 256 x 256, or 64 x 64 x 16.
    pub const MAX_PIXELS: u32 = 1 << 16;

    /// The most rows of all frames together: a workgroup keeps the extremes of each in
    /// its shared memory.
    pub const MAX_ROWS: u32 = 1 << 10;

    /// A shape within the limits.
    ///
    /// # Errors
    /// [`Error::Arguments`] for a side, a number of frames or a number of pixels that is
    /// not.
    pub fn new(width: u64, height: u64, frames: u64) -> Result<Self> {
        let within = |value: u64, least: u32, most: u32| {
            (u64::from(least)..=u64::from(most)).contains(&value)
        };
        let refuse = |asked: String, limit: String, remedy: &str| {
            Err(Error::Arguments {
                asked,
                limit,
                remedy: remedy.to_owned(),
            })
        };
        let (least, most) = (Self::MIN_SIDE, Self::MAX_SIDE);
        if !within(width, least, most) || !within(height, least, most) {
            return refuse(
                format!("a mask of {width} x {height} pixels"),
                format!("a side has {least} to {most} pixels"),
                "choose a size between; masks repeat without a seam",
            );
        }
        if !within(frames, 1, Self::MAX_FRAMES) {
            return refuse(
                format!("a mask of {frames} frames"),
                format!("it has 1 to {}", Self::MAX_FRAMES),
                "choose a number between; masks repeat over time too",
            );
        }
        let pixels = width * height * frames;
        if pixels > u64::from(Self::MAX_PIXELS) {
            return refuse(
                format!("{frames} frames of {width} x {height} pixels, {pixels} in all"),
                format!("a mask has at most {} pixels", Self::MAX_PIXELS),
                "make it smaller, or with fewer frames: 64 x 64 takes 16",
            );
        }
        if height * frames > u64::from(Self::MAX_ROWS) {
            return refuse(
                format!("{frames} frames of {height} rows"),
                format!("a mask has at most {} rows in all", Self::MAX_ROWS),
                "make it less high and wider, or with fewer frames",
            );
        }
        Ok(Self {
            width: width as u32,
            height: height as u32,
            frames: frames as u32,
        })
    }

    /// Pixels of all frames.
    #[must_use]
    pub fn pixels(self) -> u32 {
        self.width * self.height * self.frames
    }

    /// Pixels of the initial pattern: a tenth, and at least one.
    #[must_use]
    pub fn minority(self) -> u32 {
        (self.pixels() / 10).max(1)
    }

    /// The pixels of the initial pattern before it is relaxed, in ascending order: those
    /// with the least words of the seed's stream.
    #[must_use]
    pub fn scatter(self, seed: u64) -> Vec<u32> {
        let mut order: Vec<u32> = (0..self.pixels()).collect();
        order.sort_by_cached_key(|pixel| (word(seed, u64::from(*pixel)), *pixel));
        order.truncate(self.minority() as usize);
        order.sort_unstable();
        order
    }

    /// The seed of a channel of a mask with several. That of channel 0 is the mask's own,
    /// so a mask with more channels begins with the one that has fewer.
    #[must_use]
    pub fn channel_seed(seed: u64, channel: u32) -> u64 {
        match channel {
            0 => seed,
            // Counters of pixels end far below.
            _ => word(seed, u64::MAX - u64::from(channel)),
        }
    }
}
