//! Numbers as figures write them, and where axes put them.

/// Round numbers across a range, about `count` of them: multiples of 1, 2 or 5 times a
/// power of ten, with their text.
pub fn ticks(low: f64, high: f64, count: f64) -> Vec<(f64, String)> {
    let rough = (high - low) / count;
    let unit = 10f64.powf(rough.log10().floor());
    let step = match rough / unit {
        part if part <= 1.0 => unit,
        part if part <= 2.0 => 2.0 * unit,
        part if part <= 5.0 => 5.0 * unit,
        _ => 10.0 * unit,
    };
    let places = (-(step.log10() + 1e-9).floor()).max(0.0) as usize;
    let first = (low / step - 1e-9).ceil() as i64;
    let last = (high / step + 1e-9).floor() as i64;
    (first..=last)
        .map(|i| {
            let value = i as f64 * step;
            let text = if places == 0 {
                grouped(value as i64)
            } else {
                signed(&format!("{value:.places$}"))
            };
            (value, text)
        })
        .collect()
}

/// A whole number with its thousands apart: 65,536.
pub fn grouped(number: i64) -> String {
    let digits = number.unsigned_abs().to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    if number < 0 {
        format!("−{text}")
    } else {
        text
    }
}

/// The sign of typesetting in place of the hyphen.
fn signed(text: &str) -> String {
    text.replace('-', "−")
}

/// A number of at most two digits and its power of ten: 3.5×10⁻¹⁰; a power of ten alone: 10⁻³.
#[must_use]
pub fn scientific(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let text = format!("{value:.1e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, ""));
    let digits = digits.strip_suffix(".0").unwrap_or(digits);
    match (digits, exponent.parse()) {
        ("1", Ok(exponent)) => power(10, exponent),
        (_, Ok(0)) => signed(digits),
        (_, Ok(exponent)) => format!("{}×{}", signed(digits), power(10, exponent)),
        _ => signed(&text),
    }
}

/// Seconds in the unit that suits them, with up to three digits: 20 µs.
#[must_use]
pub fn duration(seconds: f64) -> String {
    let units = [(1.0, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns")];
    // 999.6 µs is 1 ms: digits are rounded before the unit is chosen.
    let rounded: f64 = format!("{seconds:.2e}").parse().unwrap_or(seconds);
    let found = units.iter().find(|(unit, _)| rounded >= 0.9999 * unit);
    let &(unit, name) = found.unwrap_or(&(1e-9, "ns"));
    let value = rounded / unit;
    let text = match value {
        _ if value < 9.995 => format!("{value:.2}"),
        _ if value < 99.95 => format!("{value:.1}"),
        _ => format!("{value:.0}"),
    };
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    format!("{text} {name}")
}

/// A power as it is written: 10⁻³.
pub fn power(base: u32, exponent: i64) -> String {
    format!("{base}{}", superscript(exponent))
}

fn superscript(number: i64) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let sign = if number < 0 { "⁻" } else { "" };
    sign.chars()
        .chain(small(number.unsigned_abs(), DIGITS))
        .collect()
}

/// The name of a coordinate, counted from 0: x₀, x₁.
pub fn coordinate(index: usize) -> String {
    const DIGITS: [char; 10] = ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉'];
    "x".chars().chain(small(index as u64, DIGITS)).collect()
}

fn small(number: u64, digits: [char; 10]) -> Vec<char> {
    let plain = number.to_string();
    let raised = plain
        .bytes()
        .filter_map(|digit| digits.get(usize::from(digit.wrapping_sub(b'0'))));
    raised.copied().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_read() {
        let written = [
            (1e-3, "10⁻³"),
            (3.46e-10, "3.5×10⁻¹⁰"),
            (2.5, "2.5"),
            (2e-6, "2×10⁻⁶"),
            (0.0, "0"),
            (9.96e-5, "10⁻⁴"),
        ];
        for (value, text) in written {
            assert_eq!(scientific(value), text);
        }
        let written = [
            (2e-5, "20 µs"),
            (1e-3, "1 ms"),
            (9.996e-4, "1 ms"),
            (1.234e-3, "1.23 ms"),
            (0.05678, "56.8 ms"),
            (0.2, "200 ms"),
            (1234.0, "1230 s"),
            (3e-10, "0.3 ns"),
        ];
        for (seconds, text) in written {
            assert_eq!(duration(seconds), text);
        }
    }
}
