//! Places for words among lines.

/// The upper left and lower right corner.
type Box = [f64; 4];

/// What already lies in a figure.
#[derive(Default)]
pub struct Room {
    lines: Vec<(f64, f64)>,
    words: Vec<Box>,
}

/// Between samples of lines, in pixels.
const GRAIN: f64 = 3.0;

impl Room {
    /// A broken line that words should not lie on.
    pub fn line(&mut self, points: &[(f64, f64)]) {
        for pair in points.windows(2) {
            let &[(x0, y0), (x1, y1)] = pair else {
                continue;
            };
            let steps = ((x1 - x0).hypot(y1 - y0) / GRAIN).ceil().max(1.0);
            let along = (0..=steps as usize).map(|step| step as f64 / steps);
            self.lines
                .extend(along.map(|t| (x0 + t * (x1 - x0), y0 + t * (y1 - y0))));
        }
    }

    /// Takes the first place that nothing lies on, or else the one with the least on it, for
    /// words of that size whose line begins there; gives the place.
    pub fn take(&mut self, places: &[(f64, f64)], [width, size]: [f64; 2]) -> Option<(f64, f64)> {
        let area = |&(x, y): &(f64, f64)| [x - 2.0, y - size, x + width + 2.0, y + 0.3 * size];
        let mut best = None;
        for place in places {
            let cost = self.cost(area(place));
            if best.is_none_or(|(_, least)| cost < least) {
                best = Some((*place, cost));
            }
        }
        let (place, _) = best?;
        self.words.push(area(&place));
        Some(place)
    }

    /// Words on words are worse than words on a line.
    fn cost(&self, [left, top, right, bottom]: Box) -> usize {
        let crossed = self
            .lines
            .iter()
            .filter(|(x, y)| (left..=right).contains(x) && (top..=bottom).contains(y));
        let covered = self
            .words
            .iter()
            .filter(|word| word[0] < right && left < word[2] && word[1] < bottom && top < word[3]);
        crossed.count() + 1000 * covered.count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_keep_off_lines_and_words() {
        let mut room = Room::default();
        room.line(&[(0.0, 0.0), (100.0, 0.0)]);
        let places = [(10.0, 4.0), (10.0, 40.0), (10.0, 80.0)];
        assert_eq!(room.take(&places, [50.0, 12.0]), Some(places[1]));
        assert_eq!(room.take(&places, [50.0, 12.0]), Some(places[2]));
        // A line is the lesser evil.
        assert_eq!(room.take(&places, [50.0, 12.0]), Some(places[0]));
        assert_eq!(room.take(&[], [50.0, 12.0]), None);
    }
}
