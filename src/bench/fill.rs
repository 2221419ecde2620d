//! Fills of memory, of which every time is a multiple.

use std::hint::black_box;
use std::time::Instant;

/// Memory whose parts are filled in turn.
pub(super) struct Fills {
    memory: Vec<u32>,
    /// Words before the next part.
    next: usize,
    value: u8,
}

/// Bytes of the memory: 128 MiB, which no cache holds.
const BYTES: usize = 1 << 27;

impl Fills {
    pub(super) fn new() -> Self {
        Self::of(BYTES)
    }

    fn of(bytes: usize) -> Self {
        // Written, so that the pages are there before anything is timed.
        Self {
            memory: vec![1; bytes / 4],
            next: 0,
            value: 0,
        }
    }

    /// Seconds that a fill of so many bytes takes with all cores, from where the last one ended, so
    /// that a short one too finds nothing of it in a cache.
    pub(super) fn seconds(&mut self, bytes: u64) -> f64 {
        let (mut seconds, mut left) = (0.0, bytes / 4);
        while left > 0 {
            let rest = &mut self.memory[self.next..];
            let words = left.min(rest.len() as u64);
            self.value = self.value.wrapping_add(1);
            seconds += fill(&mut rest[..words as usize], self.value);
            self.next = (self.next + words as usize) % self.memory.len();
            left -= words;
        }
        seconds
    }
}

/// Seconds to fill memory whose pages were touched before, with all cores.
pub(super) fn fill(memory: &mut [u32], value: u8) -> f64 {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let share = memory.len().div_ceil(threads).max(1);
    let start = Instant::now();
    std::thread::scope(|scope| {
        for part in memory.chunks_mut(share) {
            // As bytes it is the C library's memset.
            scope.spawn(move || black_box(bytemuck::cast_slice_mut::<_, u8>(part)).fill(value));
        }
    });
    start.elapsed().as_secs_f64()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_fill_goes_on_where_the_last_one_ended() {
        let mut fills = Fills::of(64);
        let word = |value| u32::from_ne_bytes([value; 4]);
        assert!(fills.seconds(4 * 10) > 0.0);
        assert!(fills.seconds(4 * 10) > 0.0);
        // 10 words, the 6 that were left, and 4 from the first on.
        assert_eq!(fills.memory[..4], [word(3); 4]);
        assert_eq!(fills.memory[4..10], [word(1); 6]);
        assert_eq!(fills.memory[10..], [word(2); 6]);
        // Three times round.
        fills.seconds(4 * 48);
        assert_eq!(fills.next, 4);
        assert_eq!(fills.seconds(0), 0.0);
    }
}
