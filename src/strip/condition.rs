//! The value of an `#if` line.

use super::lex::{Kind, Names};
use super::macros::Live;

/// A value, or why it has none. Only what decides the result needs a value: the right side of
/// `0 && x` may be anything.
type Value = Result<i32, String>;

/// Binary operators by precedence, the weakest first.
const LEVELS: [&[&str]; 10] = [
    &["||"],
    &["&&"],
    &["|"],
    &["^"],
    &["&"],
    &["==", "!="],
    &["<", ">", "<=", ">="],
    &["<<", ">>"],
    &["+", "-"],
    &["*", "/", "%"],
];

/// How deep parentheses and signs may nest.
const DEPTH: usize = 64;

struct Reader<'a> {
    tokens: &'a [Live],
    names: &'a Names,
    at: usize,
    depth: usize,
}

/// Evaluates a line whose macros are expanded and whose `defined` are numbers.
pub(super) fn evaluate(tokens: &[Live], names: &Names) -> Value {
    let mut reader = Reader {
        tokens,
        names,
        at: 0,
        depth: 0,
    };
    let value = reader.binary(0)?;
    match reader.peek() {
        None => value,
        Some(text) => Err(format!("`{text}` is not expected there")),
    }
}

impl<'a> Reader<'a> {
    fn peek(&self) -> Option<&'a str> {
        let token = self.tokens.get(self.at)?;
        Some(self.names.text(token.symbol))
    }

    /// An expression of operators of a level and those that bind more tightly. The outer error
    /// is one of grammar.
    fn binary(&mut self, level: usize) -> Result<Value, String> {
        let Some(operators) = LEVELS.get(level) else {
            return self.unary();
        };
        let mut left = self.binary(level + 1)?;
        while let Some(operator) = self.peek().filter(|text| operators.contains(text)) {
            self.at += 1;
            let right = self.binary(level + 1)?;
            left = apply(operator, left, right);
        }
        Ok(left)
    }

    fn unary(&mut self) -> Result<Value, String> {
        let text = self.peek().ok_or("the condition is cut short")?;
        self.depth += 1;
        if self.depth > DEPTH {
            return Err(format!("the condition nests deeper than {DEPTH}"));
        }
        let kind = self.tokens.get(self.at).map(|token| token.kind);
        self.at += 1;
        let value = match text {
            "(" => {
                let value = self.binary(0)?;
                if self.peek() != Some(")") {
                    return Err("a parenthesis does not close".to_owned());
                }
                self.at += 1;
                value
            }
            "-" => self.unary()?.map(i32::wrapping_neg),
            "+" => self.unary()?,
            "~" => self.unary()?.map(|value| !value),
            "!" => self.unary()?.map(|value| i32::from(value == 0)),
            _ if kind == Some(Kind::Number) => number(text),
            _ if kind == Some(Kind::Name) => Err(format!("`{text}` is no macro at that point")),
            _ => return Err(format!("`{text}` is not expected there")),
        };
        self.depth -= 1;
        Ok(value)
    }
}

fn number(text: &str) -> Value {
    let digits = text.strip_suffix(['u', 'U']).unwrap_or(text);
    let (digits, radix) = match digits.as_bytes() {
        [b'0', b'x' | b'X', ..] => (&digits[2..], 16),
        [b'0', _, ..] => (&digits[1..], 8),
        _ => (digits, 10),
    };
    u32::from_str_radix(digits, radix)
        .map(|value| value as i32)
        .map_err(|_| format!("`{text}` is no integer of 32 bits"))
}

fn apply(operator: &str, left: Value, right: Value) -> Value {
    match (operator, &left) {
        ("||", Ok(value)) if *value != 0 => return Ok(1),
        ("&&", Ok(0)) => return Ok(0),
        _ => {}
    }
    let (a, b) = (left?, right?);
    let shift = u32::try_from(b).ok().filter(|shift| *shift < 32);
    Ok(match operator {
        "||" | "&&" => i32::from(b != 0),
        "|" => a | b,
        "^" => a ^ b,
        "&" => a & b,
        "==" => i32::from(a == b),
        "!=" => i32::from(a != b),
        "<" => i32::from(a < b),
        ">" => i32::from(a > b),
        "<=" => i32::from(a <= b),
        ">=" => i32::from(a >= b),
        "<<" => a << shift.ok_or("a shift by 32 or more bits")?,
        ">>" => a >> shift.ok_or("a shift by 32 or more bits")?,
        "+" => a.wrapping_add(b),
        "-" => a.wrapping_sub(b),
        "*" => a.wrapping_mul(b),
        _ if b == 0 => return Err("a division by 0".to_owned()),
        "/" => a.wrapping_div(b),
        _ => a.wrapping_rem(b),
    })
}
