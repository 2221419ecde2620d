//! Colours of series, on white and on a dark page.

use super::svg::{BLUE, FAINT, INK, QUIET, VERMILION};
use std::fmt::Write;

/// The eight of Okabe and Ito, on white and on the dark page: there black is light, and on
/// white yellow is darkened, which would be lost otherwise.
pub const SERIES: [[&str; 2]; 8] = [
    [BLUE, "#3f9bd8"],
    [VERMILION, "#d55e00"],
    ["#009e73", "#009e73"],
    ["#cc79a7", "#cc79a7"],
    ["#e69f00", "#e69f00"],
    ["#56b4e9", "#8fd3ff"],
    ["#000000", "#f0f0f0"],
    ["#a39400", "#f0e442"],
];

/// Classes of what is no series, with their colours on white and on the dark page.
const ROLES: [(&str, [&str; 2]); 4] = [
    ("ink", [INK, "#e4e4e4"]),
    ("quiet", [QUIET, "#a9adb3"]),
    ("target", [QUIET, "#8d939b"]),
    ("grid", [FAINT, "#363b42"]),
];

/// The dark page.
const PAPER: &str = "#15181c";

/// The class of a series.
pub fn class(series: usize) -> String {
    format!("c{}", series % SERIES.len())
}

/// The colour of a series on white.
pub fn colour(series: usize) -> &'static str {
    SERIES[series % SERIES.len()][0]
}

/// Rules of CSS that turn figures with classes dark, for a page to put under its
/// `prefers-color-scheme`; the page's colour is #15181c.
#[must_use]
pub fn dark_rules() -> String {
    let mut rules = format!("svg .paper{{fill:{PAPER}}}\n");
    let series = (0..).zip(SERIES).map(|(n, [_, dark])| (class(n), dark));
    let roles = ROLES
        .iter()
        .map(|(class, [_, dark])| ((*class).to_owned(), *dark));
    for (class, dark) in roles.chain(series) {
        // Writing to a String cannot fail.
        let _ = writeln!(
            rules,
            "svg .{class} path{{stroke:{dark}}}\nsvg .{class} :is(text,circle,polygon){{fill:{dark}}}"
        );
    }
    rules
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The contrast of two colours by WCAG 2.2: 1 of equal ones, 21 of black and white.
    fn contrast(one: &str, other: &str) -> f64 {
        let luminance = |colour: &str| {
            let part = |at: usize| {
                let byte = u8::from_str_radix(&colour[at..at + 2], 16).unwrap();
                match f64::from(byte) / 255.0 {
                    low if low <= 0.04045 => low / 12.92,
                    high => ((high + 0.055) / 1.055).powf(2.4),
                }
            };
            0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5)
        };
        let (a, b) = (luminance(one), luminance(other));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    /// WCAG asks 4.5 of text and 3 of shapes. On white, orange and sky blue of the palette
    /// have no more than 2.2; their lines have markers and names in ink.
    #[test]
    fn series_and_text_stand_against_the_page() {
        assert!((contrast("#000000", "#ffffff") - 21.0).abs() < 1e-9);
        for [light, dark] in SERIES {
            assert!(contrast(light, "#ffffff") > 2.2, "{light}");
            assert!(contrast(dark, PAPER) > 4.0, "{dark}");
        }
        for (class, [light, dark]) in &ROLES[..3] {
            assert!(contrast(light, "#ffffff") > 4.5, "{class}");
            assert!(contrast(dark, PAPER) > 4.5, "{class}");
        }
        assert!(contrast(BLUE, PAPER) < 4.0, "blue needs no dark form");
    }
}
