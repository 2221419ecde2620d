//! Integers of 256 bits, as far as variances need them.

use std::fmt;

/// An integer below 2^256, lowest 64 bits first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct U256([u64; 4]);

impl U256 {
    /// From its parts, the lowest first.
    #[must_use]
    pub fn new(parts: [u64; 4]) -> Self {
        Self(parts)
    }

    /// Its parts, the lowest first.
    #[must_use]
    pub fn parts(self) -> [u64; 4] {
        self.0
    }

    /// A smaller integer.
    #[must_use]
    pub fn from_u128(x: u128) -> Self {
        Self([x as u64, (x >> 64) as u64, 0, 0])
    }

    /// From decimal digits; `None` of anything else, and from 2^256 on.
    #[must_use]
    pub fn from_decimal(text: &str) -> Option<Self> {
        let mut digits = text.bytes().peekable();
        digits.peek()?;
        digits.try_fold(Self::default(), |sum, digit| {
            let digit = digit.is_ascii_digit().then(|| digit - b'0')?;
            sum.checked_mul(10)?
                .checked_add(Self::from_u128(digit.into()))
        })
    }

    /// The sum, if it is below 2^256.
    #[must_use]
    pub fn checked_add(self, other: Self) -> Option<Self> {
        let mut parts = [0; 4];
        let mut carry = false;
        for (part, (a, b)) in parts.iter_mut().zip(self.0.into_iter().zip(other.0)) {
            let (sum, first) = a.overflowing_add(b);
            let (sum, second) = sum.overflowing_add(carry.into());
            (*part, carry) = (sum, first | second);
        }
        (!carry).then_some(Self(parts))
    }

    /// The difference, if it is not negative.
    #[must_use]
    pub fn checked_sub(self, other: Self) -> Option<Self> {
        let mut parts = [0; 4];
        let mut borrow = false;
        for (part, (a, b)) in parts.iter_mut().zip(self.0.into_iter().zip(other.0)) {
            let (rest, first) = a.overflowing_sub(b);
            let (rest, second) = rest.overflowing_sub(borrow.into());
            (*part, borrow) = (rest, first | second);
        }
        (!borrow).then_some(Self(parts))
    }

    /// The product, if it is below 2^256.
    #[must_use]
    pub fn checked_mul(self, factor: u64) -> Option<Self> {
        let mut parts = [0; 4];
        let mut carry = 0u128;
        for (part, a) in parts.iter_mut().zip(self.0) {
            carry += u128::from(a) * u128::from(factor);
            *part = carry as u64;
            carry >>= 64;
        }
        (carry == 0).then_some(Self(parts))
    }

    /// x^2.
    #[must_use]
    pub fn square(x: u128) -> Self {
        let (low, high) = (u128::from(x as u64), x >> 64);
        let mut parts = [0; 4];
        let [outer, cross, inner] = [low * low, low * high, high * high];
        let mut carry = 0u128;
        let columns = [
            [outer as u64, 0, 0],
            [(outer >> 64) as u64, cross as u64, cross as u64],
            [(cross >> 64) as u64, (cross >> 64) as u64, inner as u64],
            [(inner >> 64) as u64, 0, 0],
        ];
        for (part, column) in parts.iter_mut().zip(columns) {
            carry += column.into_iter().map(u128::from).sum::<u128>();
            *part = carry as u64;
            carry >>= 64;
        }
        Self(parts)
    }

    /// self / divisor * 2^exponent, correctly rounded where that is a normal float, for
    /// divisors from 1 to 2^127.
    #[must_use]
    pub fn over(self, divisor: u128, exponent: i32) -> f64 {
        let Some(top) = (0..256).rev().find(|&bit| self.bit(bit)) else {
            return 0.0;
        };
        // Long division until the quotient has 64 significant bits; below the units, zeros.
        let (mut rest, mut quotient, mut place) = (0u128, 0u64, top);
        loop {
            rest = (rest << 1) | u128::from(place >= 0 && self.bit(place));
            quotient <<= 1;
            if rest >= divisor {
                rest -= divisor;
                quotient |= 1;
            }
            if quotient >> 63 == 1 {
                break;
            }
            place -= 1;
        }
        let below = (0..place).any(|bit| self.bit(bit));
        // What is left counts as a last bit, which decides halves.
        let rounded = (quotient | u64::from(rest != 0 || below)) as f64;
        scaled(rounded, place + exponent)
    }

    fn bit(self, at: i32) -> bool {
        self.0[(at as usize / 64) & 3] >> (at & 63) & 1 == 1
    }
}

/// x * 2^exponent, in steps that do not overflow before the result does.
fn scaled(x: f64, exponent: i32) -> f64 {
    let step = exponent.clamp(-1000, 1000);
    let power = f64::from_bits(((1023 + step) as u64) << 52);
    if step == exponent || x == 0.0 || x.is_infinite() {
        x * power
    } else {
        scaled(x * power, exponent - step)
    }
}

/// In decimal.
impl fmt::Display for U256 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut rest = self.0;
        let mut groups = Vec::new();
        while rest != [0; 4] {
            let mut remainder = 0u128;
            for part in rest.iter_mut().rev() {
                let x = (remainder << 64) | u128::from(*part);
                *part = (x / GROUP) as u64;
                remainder = x % GROUP;
            }
            groups.push(remainder);
        }
        let mut text = groups.pop().unwrap_or(0).to_string();
        for group in groups.iter().rev() {
            text += &format!("{group:018}");
        }
        f.pad_integral(true, "", &text)
    }
}

/// Eighteen digits, which fit into a part.
const GROUP: u128 = 1_000_000_000_000_000_000;
