//! Fractions at which a map goes from one of its branches to another, where those depend on its
//! parameters.

use crate::catalog::{Group, Mapping};
use crate::interface::map;
use crate::judge::EnvironmentTables;
use crate::reference::filter_mitchell::filter_mitchell_prepare;

/// The edges and what is beside them, ascending; none where all edges are those of quadrants.
#[must_use]
pub fn edges(mapping: &Mapping) -> Vec<u32> {
    let (id, words) = (mapping.map().id, mapping.words());
    let edges = match mapping.map().group {
        Group::Planar if id == map::REGULAR_POLYGON => parts(words[0].into()),
        Group::MitchellFilter => mitchell(mapping),
        Group::Environment if id == map::ENVIRONMENT => texels(mapping),
        Group::Environment => bins(mapping),
        _ => Vec::new(),
    };
    let beside = |edge: u32| [edge.wrapping_sub(1), edge, edge.wrapping_add(1)];
    let mut edges: Vec<u32> = edges.into_iter().flat_map(beside).collect();
    edges.sort_unstable();
    edges.dedup();
    edges
}

/// The first, middle and last of items.
fn some(items: u64) -> [u64; 3] {
    [0, items / 2, items.saturating_sub(1)]
}

/// Ends of some of so many equal parts.
fn parts(count: u64) -> Vec<u32> {
    let end = |part: u64| ((part + 1) << 32).div_ceil(count.max(1)) as u32;
    some(count).map(end).to_vec()
}

/// Where the parts of the filter meet, on both sides of the centre.
fn mitchell(mapping: &Mapping) -> Vec<u32> {
    let [radius, b, c, ..] = *mapping.parameters();
    let filter = filter_mitchell_prepare(radius, b, c);
    // Shares from the edge, out of 2^32, of the upper half of the fractions.
    let upper = |share: u32| (share.wrapping_neg() >> 1) | 0x8000_0000;
    let shares = [filter.inner, filter.tail, filter.lobe].map(upper);
    shares.into_iter().flat_map(|u| [u, !u]).collect()
}

/// Ends of the ranges that draw some of the texels.
fn texels(mapping: &Mapping) -> Vec<u32> {
    let [width, height, ..] = mapping.words();
    let tables = EnvironmentTables {
        width,
        height,
        alias: false,
        words: mapping.tables().first().map_or(&[], Vec::as_slice),
    };
    let texels = some(width.into()).into_iter().zip(some(height.into()));
    let ranges = texels.map(|(x, y)| tables.ranges([x as u32, y as u32]));
    let ends = ranges.flatten().flatten();
    // The end of all, 2^32, is their start.
    ends.map(|end| end as u32).collect()
}

/// Ends of some of the bins of an alias table, and of what is their own.
fn bins(mapping: &Mapping) -> Vec<u32> {
    let [width, height, ..] = mapping.words();
    let count = u64::from(width) * u64::from(height);
    let words = mapping.tables().first().map_or(&[][..], Vec::as_slice);
    let own = |bin: u64| {
        // Three words of each bin follow the edges and the caps of the rows.
        let at = 3 * u64::from(height) + 2 + 3 * bin;
        let own = words.get(at as usize).copied().unwrap_or(0);
        ((bin << 32) + u64::from(own)).div_ceil(count.max(1)) as u32
    };
    let mut edges = parts(count);
    edges.extend(some(count).map(own));
    edges
}

#[cfg(test)]
mod tests {
    use super::edges;
    use crate::bulk::map_sample;
    use crate::catalog::{Map, Profile};
    use crate::check::examples;

    /// The coordinate is another function on the other side: its steps differ.
    #[test]
    fn parts_of_a_filter_meet_there() {
        let map = Map::from_name("filter-mitchell").expect("it is there");
        for mapping in examples(map).expect("examples") {
            let found = edges(&mapping);
            assert!(found.len() >= 6 && found.len() <= 18, "{found:?}");
            for u in &found {
                assert!(found.contains(&!u), "{u:#x} of {:?}", mapping.values());
            }
        }
    }

    /// Another texel is drawn from there on.
    #[test]
    fn texels_and_bins_end_there() {
        for name in ["environment", "environment-alias"] {
            let map = Map::from_name(name).expect("it is there");
            let mapping = &examples(map).expect("examples")[0];
            let pdf = |x: u32, y: u32| map_sample(mapping, Profile::Exact, [x, y, 1 << 31])[3];
            let steps = |one: &dyn Fn(u32) -> u32| {
                let found = edges(mapping);
                let there = |edge: &&u32| one(edge.wrapping_sub(1)) != one(**edge);
                found.iter().filter(there).count()
            };
            let across = steps(&|u| pdf(u, 1 << 31));
            assert!(across >= 3, "{name}: {across}");
        }
    }
}
