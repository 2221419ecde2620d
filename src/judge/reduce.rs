//! The exact sum of floats as one long integer.

/// The sum in units of 2^-150, 384 bits in two's complement, the lowest word first; `None` where
/// a term is infinite or NaN.
#[must_use]
pub fn float_sum(terms: &[f32]) -> Option<[u64; 6]> {
    // Sums of magnitudes by sign: fewer than 2^64 floats do not fill them.
    let mut sums = [[0u64; 6]; 2];
    for x in terms {
        if !x.is_finite() {
            return None;
        }
        // x = m 2^e with an integer m, by the definition of the format.
        let bits = x.abs().to_bits();
        let (m, e) = match bits >> 23 {
            0 => (bits, -149),
            exponent => (bits % (1 << 23) + (1 << 23), exponent as i32 - 150),
        };
        let place = (e + 150) as usize;
        let shifted = u128::from(m) << (place % 64);
        let side = sums.get_mut(usize::from(x.is_sign_negative()))?;
        let mut carry = 0u128;
        for (i, word) in side.iter_mut().enumerate().skip(place / 64) {
            let part = match i - place / 64 {
                0 => shifted as u64,
                1 => (shifted >> 64) as u64,
                _ => 0,
            };
            carry += u128::from(*word) + u128::from(part);
            *word = carry as u64;
            carry >>= 64;
        }
    }
    let [positive, negative] = sums;
    let mut borrow = false;
    let mut words = [0; 6];
    for ((word, a), b) in words.iter_mut().zip(positive).zip(negative) {
        let (rest, first) = a.overflowing_sub(b);
        let (rest, second) = rest.overflowing_sub(borrow.into());
        (*word, borrow) = (rest, first | second);
    }
    Some(words)
}
