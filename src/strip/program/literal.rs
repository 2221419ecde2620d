//! Numbers and names as GLSL has them.

use crate::reference::real::Real;
use std::fmt::Write;

/// A float that compilers read as the same bits: digits for what they read alike, bits for
/// what some flush or have no word for.
pub(super) fn float(x: f32) -> String {
    if x.is_normal() || x.to_bits() == 0 {
        // The shortest digits that stand for it, also by way of a double.
        format!("{x:?}")
    } else {
        format!("uintBitsToFloat({:#010x}u)", x.to_bits())
    }
}

/// A whole number: small ones by digits, others by bits.
pub(super) fn word(x: u32) -> String {
    if x < 65536 {
        format!("{x}u")
    } else {
        format!("{x:#010x}u")
    }
}

/// A vector of floats, or one.
pub(super) fn floats(all: &[f32]) -> String {
    let parts: Vec<String> = all.iter().map(|x| float(*x)).collect();
    match &parts[..] {
        [one] => one.clone(),
        parts => format!("vec{}({})", parts.len(), parts.join(", ")),
    }
}

/// A software real.
pub(super) fn real(x: Real) -> String {
    format!("CorputReal({:#010x}u, {}, {})", x.m, x.e, x.negative)
}

/// Lines with so many blanks before each.
pub(super) fn indented(text: &str, blanks: usize) -> String {
    let mut made = String::new();
    for line in text.lines() {
        // Writing to a String cannot fail.
        let _ = match line {
            "" => writeln!(made),
            line => writeln!(made, "{:blanks$}{line}", ""),
        };
    }
    made
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_the_same_bits() {
        assert_eq!(float(0.1), "0.1");
        assert_eq!(float(1.0), "1.0");
        assert_eq!(float(1e30), "1e30");
        assert_eq!(float(-0.0), "uintBitsToFloat(0x80000000u)");
        assert_eq!(float(f32::INFINITY), "uintBitsToFloat(0x7f800000u)");
        assert_eq!(float(1e-40), "uintBitsToFloat(0x000116c2u)");
        assert_eq!(word(7), "7u");
        assert_eq!(word(u32::MAX), "0xffffffffu");
        assert_eq!(floats(&[1.0, 0.5]), "vec2(1.0, 0.5)");
        assert_eq!(indented("a\n\nb\n", 2), "  a\n\n  b\n");
    }
}
