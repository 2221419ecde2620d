//! Names of lines in a column beside their ends, moved apart.

/// Between names, in pixels.
const STEP: f64 = 16.0;

/// A line's name, its mark, where the line ends, and the height at which the name stands.
pub struct End<'a, M> {
    pub name: &'a str,
    pub mark: M,
    pub at: (f64, f64),
    pub y: f64,
}

/// Moves names apart, as little as one pass down and one up allow.
pub fn spread<M>(ends: &mut [End<'_, M>], top: f64, bottom: f64) {
    ends.sort_by(|a, b| a.y.total_cmp(&b.y));
    let mut least = top;
    for end in ends.iter_mut() {
        end.y = end.y.max(least);
        least = end.y + STEP;
    }
    let mut most = bottom;
    for end in ends.iter_mut().rev() {
        end.y = end.y.min(most);
        most = end.y - STEP;
    }
}
