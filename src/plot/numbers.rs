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

pub fn superscript(number: i64) -> String {
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
