//! Versions of crates, from the lock file that they are built by.

const LOCK: &str = include_str!("../Cargo.lock");

/// The version of a crate that the lock file has once.
pub fn of(name: &str) -> &'static str {
    let start = format!("name = \"{name}\"\nversion = \"");
    let found = LOCK.split_once(&start);
    found
        .and_then(|(_, rest)| rest.split_once('"'))
        .map_or("?", |(version, _)| version)
}

#[cfg(test)]
mod tests {
    #[test]
    fn those_of_the_manifest_are_found() {
        assert!(super::of("halton").starts_with("0.2."));
        assert!(super::of("sobol").starts_with("1."));
        assert!(super::of("sobol_burley").starts_with("0.5."));
        assert_eq!(super::of("no such crate"), "?");
    }
}
