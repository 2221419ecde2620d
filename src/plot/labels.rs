//! Names beside the points that they belong to, without one upon another.

use crate::plot::text;

/// A rectangle: left, top, right, bottom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area(pub [f64; 4]);

impl Area {
    fn overlaps(self, other: Self) -> bool {
        let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
        a < g && e < c && b < h && f < d
    }

    fn within(self, other: Self) -> bool {
        let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
        a >= e && b >= f && c <= g && d <= h
    }

    /// Whether a segment passes through, by the part of it that each side leaves.
    fn is_crossed(self, from: (f64, f64), to: (f64, f64)) -> bool {
        let [left, top, right, bottom] = self.0;
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let (mut start, mut end) = (0.0f64, 1.0f64);
        for (step, room) in [
            (-dx, from.0 - left),
            (dx, right - from.0),
            (-dy, from.1 - top),
            (dy, bottom - from.1),
        ] {
            if step == 0.0 {
                if room < 0.0 {
                    return false;
                }
            } else if step < 0.0 {
                start = start.max(room / step);
            } else {
                end = end.min(room / step);
            }
        }
        start <= end
    }
}

/// A name's place.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// What the text covers.
    pub area: Area,
    /// Where a line to the point ends; `None` beside the point.
    pub leader: Option<(f64, f64)>,
}

/// Half a marker and a little air.
const MARKER: f64 = 5.0;

/// Places names of this size near their points: next to them, or farther off where others
/// are in the way; as few segments as may be run through them. Where all within reach is
/// taken, a name lies upon another.
pub fn place(
    names: &[(&str, (f64, f64))],
    size: f64,
    bounds: Area,
    taken: &[(f64, f64)],
    segments: &[[(f64, f64); 2]],
) -> Vec<Place> {
    let marker = |&(x, y): &(f64, f64)| Area([x - MARKER, y - MARKER, x + MARKER, y + MARKER]);
    let mut full: Vec<Area> = taken.iter().map(marker).collect();
    let mut places = Vec::new();
    for &(name, point) in names {
        let width = text::width(name, size);
        let mut best: Option<(f64, Place)> = None;
        for place in candidates(point, width, size) {
            if !place.area.within(bounds) || full.iter().any(|other| other.overlaps(place.area)) {
                continue;
            }
            let crossed = segments
                .iter()
                .filter(|[from, to]| place.area.is_crossed(*from, *to))
                .count();
            let far = place
                .leader
                .map_or(0.0, |end| 12.0 + (end.0 - point.0).hypot(end.1 - point.1));
            let cost = far + 9.0 * crossed as f64;
            if best.is_none_or(|(least, _)| cost < least) {
                best = Some((cost, place));
            }
        }
        let place = best.map_or_else(|| beside(point, width, size), |(_, place)| place);
        full.push(place.area);
        places.push(place);
    }
    places
}

fn beside((x, y): (f64, f64), width: f64, size: f64) -> Place {
    let left = x + MARKER + 2.0;
    Place {
        area: Area([left, y - size / 2.0, left + width, y + size / 2.0]),
        leader: None,
    }
}

/// Next to the point, and on rings around it, text to either side.
fn candidates(point: (f64, f64), width: f64, size: f64) -> Vec<Place> {
    let (x, y) = point;
    let mirrored = |place: Place| Place {
        area: Area([
            2.0 * x - place.area.0[2],
            place.area.0[1],
            2.0 * x - place.area.0[0],
            place.area.0[3],
        ]),
        leader: place.leader.map(|(end, height)| (2.0 * x - end, height)),
    };
    let mut all = vec![beside(point, width, size)];
    for ring in 1..16 {
        let radius = 12.0 * f64::from(ring);
        for step in -4..=4 {
            let (sin, cos) = (f64::from(step) * std::f64::consts::FRAC_PI_8).sin_cos();
            let end = (x + radius * cos, y + radius * sin);
            let [left, top] = [end.0 + 2.0, end.1 - size / 2.0];
            all.push(Place {
                area: Area([left, top, left + width, top + size]),
                leader: Some(end),
            });
        }
    }
    let other: Vec<Place> = all.iter().copied().map(mirrored).collect();
    all.extend(other);
    all
}
