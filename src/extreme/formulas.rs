//! The common formulas that the cases are beside, as people write them: in float throughout, or in
//! integers of 32 bits where they are about these.

use super::Case;

/// The common formula of a case.
pub(super) fn formula(case: &Case) -> &'static str {
    let subject = case.subject.name();
    match case.number {
        1 if subject == "add64" => "n + 1 of 32 bits",
        1 => "for (uint i = first; i < first + count; i++)",
        2 => "float(k) / float(N)",
        3 => "float(u) 2^-32",
        4 => "sum of digit_i b^-i, by powers of 1.0 / b",
        5 => "floor for ceil",
        6 => "digits that are not permuted",
        7 => "low << s, (high << s) + (low >> (32 - s))",
        8 => "(float(i) + float(jitter)) / float(N)",
        9 => "fract(float(u) 2^-32 + shift)",
        10 => "uint(x 2^31)",
        11 if subject == "host" => "first + k of 32 bits",
        11 => "digits of int(index)",
        12 | 13 => "-log(1 - float(u) 2^-32)",
        14 => "cos and sin of 2 pi float(u) 2^-32",
        15 => "acos of the dot product",
        16 if case.input.starts_with("e^") => "exp2(x log2(e))",
        16 => "exp2(y log2(x))",
        17 if subject == "cosine-power-hemisphere" => {
            "z = pow(1 - u, 1 / (n + 1)), x = sqrt(1 - z^2), pdf = (n + 1) / (2 pi) pow(z, n)"
        }
        17 => "z = sqrt(1 - x^2 - y^2)",
        18 => "x cos(pi / 4 y / x), x sin(pi / 4 y / x) of 2 u - 1",
        19 => "z = 1 - 2 u, x = sqrt(1 - z^2)",
        20 | 21 if subject == "cone" => {
            "z = 1 - u (1 - cos(theta)), x = sqrt(1 - z^2), pdf = 1 / (2 pi (1 - cos(theta)))"
        }
        20 | 29 if subject == "sphere-light" => {
            "a cone of cos = sqrt(1 - r^2 / d^2) in Frisvad's frame, pdf = 1 / (2 pi (1 - cos))"
        }
        22 => "(1 - sqrt(u), sqrt(u) (1 - v), sqrt(u) v)",
        23 | 25 => "the sum of the three angles less pi (Girard)",
        24 => "2 atan2(abs(a . (b x c)), 1 + a . b + b . c + c . a) of unit vectors",
        26 => "b1 /= b1 + b2; b2 /= b1 + b2",
        27 if subject == "disk-light" => "pdf = d^2 / (area abs(cos)) of the rounded direction",
        27 => "the sum of the four angles less 2 pi (Girard)",
        28 => "Urena, Fajardo and King 2013, steps 3 to 5",
        29 => "Frisvad 2012, by 1 / (1 + z)",
        30 => "alpha^2 / (pi ((alpha^2 - 1) cos^2 + 1)^2)",
        31 => "z = (1 - u)(1 + w.z) - w.z, radius = sqrt(1 - z^2) (Dupuy and Benyoub 2023)",
        32 => "1 / (1 + (sqrt(1 + alpha^2 tan^2) - 1) / 2), 1 where tan^2 is infinite",
        33 | 34 => "cos = (1 + g^2 - ((1 - g^2) / (1 - g + 2 g u))^2) / (2 g)",
        35 => "a running sum of floats",
        36 | 37 => "a texel's share of the sum of floats",
        38 => "fract(float(u) 2^-32 n)",
        39 => "the first bin with u <= cdf[bin]",
        40 | 41 if case.input.starts_with("power") => "a^2 / (a^2 + b^2)",
        40 | 41 => "a / (a + b)",
        42 => "a running sum of floats",
        43 => "sums of floats by group, and of groups",
        44 => "mean(x^2) - mean(x)^2 of floats",
        45 if subject == "host" => "the same by points of van der Corput from 0 on",
        45 => "1 / sqrt(float(u) 2^-32), points of van der Corput from 0 on",
        46 => "exp(-(x - centre)^2 / (2 sigma^2)) over uniform points",
        47 => "float(int(65536 x) % 2 == 0) over points that are not scrambled",
        48 => "cos(2 pi N x) over points that are not scrambled",
        49 => "x x + y y < 1 of floats",
        50 => "its definition, and a running sum, in floats",
        51 => "its definition in floats, the quantile of 0 minus infinity",
        52 | 53 => "its definition, and a running sum, in floats",
        54 => "pow(product of e^x, 1 / n)",
        55 => "one column for every dimension",
        _ => "",
    }
}
