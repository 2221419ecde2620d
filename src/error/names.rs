//! Names that are none, and those that may be meant.

use super::Error;

/// The candidate most similar to a name, if any is similar: at most a third of the
/// longer of the two may differ, or one begins the other.
#[must_use]
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let name = name.to_ascii_lowercase();
    candidates
        .into_iter()
        .map(|candidate| (strsim::damerau_levenshtein(&name, candidate), candidate))
        .filter(|(distance, candidate)| {
            let begins =
                name.len() >= 2 && (candidate.starts_with(&*name) || name.starts_with(candidate));
            begins || *distance <= name.len().max(candidate.len()).div_ceil(3)
        })
        .min()
        .map(|(_, candidate)| candidate)
}

/// The command that lists names of a kind, where there is one.
pub(super) fn list(kind: &str) -> &'static str {
    match kind {
        "integrand" | "estimator" => "; `corput integrands` says more",
        "sampler" | "scramble" => "; `corput generate --help` says more",
        "map" => "; `corput maps` says more",
        _ => "",
    }
}

impl Error {
    /// The error for an unknown name, with the most similar known one.
    #[must_use]
    pub fn unknown_name(kind: &'static str, name: &str, known: &[&str]) -> Self {
        Self::UnknownName {
            kind,
            name: name.to_owned(),
            nearest: nearest(name, known.iter().copied()).map(str::to_owned),
            known: known.join(", "),
        }
    }
}
