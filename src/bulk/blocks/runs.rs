//! Runs of consecutive indices within blocks.

/// Cuts the words of consecutive indices from n on where blocks of `length` end: the number of
/// each block, the place in it, and the words.
pub fn runs(n: u64, length: usize, words: &mut [u32]) -> Runs<'_> {
    Runs { n, length, words }
}

pub struct Runs<'a> {
    n: u64,
    length: usize,
    words: &'a mut [u32],
}

impl<'a> Iterator for Runs<'a> {
    type Item = (u64, usize, &'a mut [u32]);

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        if self.words.is_empty() {
            return None;
        }
        let length = self.length as u64;
        let (block, place) = (self.n / length, (self.n % length) as usize);
        let words = std::mem::take(&mut self.words);
        let (run, rest) = words.split_at_mut((self.length - place).min(words.len()));
        self.n += run.len() as u64;
        self.words = rest;
        Some((block, place, run))
    }
}
