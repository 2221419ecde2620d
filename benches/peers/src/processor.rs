//! What the processor is: its name, and the numbers that tell its kind where the name does not.

/// As Linux tells it; elsewhere the architecture alone.
pub fn line() -> String {
    named(&std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default())
}

fn named(cpuinfo: &str) -> String {
    let of = |key| field(cpuinfo, key);
    match (of("model name"), of("cpu family"), of("model")) {
        (Some(name), Some(family), Some(model)) => {
            format!("{name} (family {family}, model {model})")
        }
        (Some(name), ..) => name.to_owned(),
        _ => std::env::consts::ARCH.to_owned(),
    }
}

/// The first value of a key.
fn field<'a>(cpuinfo: &'a str, key: &str) -> Option<&'a str> {
    let mut pairs = cpuinfo.lines().filter_map(|line| line.split_once(':'));
    let (_, value) = pairs.find(|(name, _)| name.trim() == key)?;
    Some(value.trim())
}

#[cfg(test)]
mod tests {
    use super::named;

    #[test]
    fn the_first_core_is_named() {
        let cpuinfo = "cpu family\t: 26\nmodel\t\t: 2\nmodel name\t: A: B\n\nmodel\t\t: 3\n";
        assert_eq!(named(cpuinfo), "A: B (family 26, model 2)");
        assert_eq!(named("model name\t: C\n"), "C");
        assert_eq!(named(""), std::env::consts::ARCH);
    }
}
