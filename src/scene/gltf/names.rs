//! Names of keys, from names that may be anything.

use std::collections::BTreeSet;

/// Longest name of a key, and the most of a name that messages show.
const LONGEST: usize = 32;

/// Names that were given.
#[derive(Default)]
pub(super) struct Names {
    given: BTreeSet<String>,
}

impl Names {
    /// A name that none has yet: letters, digits, `-` and `_` of the wanted one, after a letter;
    /// or its number, which begins no other.
    pub(super) fn give(&mut self, wanted: Option<&str>, index: usize) -> String {
        let plain: String = wanted
            .unwrap_or("")
            .chars()
            .take(LONGEST)
            .map(|c| match c {
                '-' | '_' => c,
                _ if c.is_ascii_alphanumeric() => c.to_ascii_lowercase(),
                _ => '-',
            })
            .collect();
        let plain = plain.trim_matches('-');
        let begins = plain.starts_with(|c: char| c.is_ascii_alphabetic());
        let name = match begins && !self.given.contains(plain) {
            true => plain.to_owned(),
            false => index.to_string(),
        };
        self.given.insert(name.clone());
        name
    }
}

/// The beginning of a name, without what would break a line.
pub(super) fn short(name: &str) -> String {
    let line = name.chars().map(|c| if c.is_control() { ' ' } else { c });
    line.take(LONGEST).collect()
}
