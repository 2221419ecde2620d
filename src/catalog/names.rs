//! Messages for names that are not in a list.

use crate::Error;

/// The error for an unknown name, with the most similar known one.
#[must_use]
pub fn unknown(kind: &'static str, name: &str, known: &[&str]) -> Error {
    let nearest = known
        .iter()
        .map(|candidate| (edit_distance(name, candidate), *candidate))
        .min()
        .filter(|(distance, candidate)| *distance <= candidate.len().max(name.len()) / 2)
        .map(|(_, candidate)| candidate.to_owned());
    Error::UnknownName {
        kind,
        name: name.to_owned(),
        nearest,
        known: known.join(", "),
    }
}

/// Levenshtein's distance, with one row of the table.
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, &y) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(x != y);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}
