//! Logarithms, exponentials and the normal distribution.

use super::Killer::{Linter, Mismatch};
use super::{Mutant, mutant};
use crate::harness::Target::Function;

#[rustfmt::skip]
pub const MUTANTS: &[Mutant] = &[
    mutant("a native logarithm", Linter, Function("negative_log"),
        "corput/logarithm.glsl", "return corput_real_float(corput_real_negative_log(u));", "return -log(uintBitsToFloat(u));"),
    mutant("~u for 1 - u in the logarithm", Mismatch, Function("negative_log"),
        "corput/real_angle.glsl", "return corput_real_uint(0u - u, -32);", "return corput_real_uint(~u, -32);"),
    mutant("a coefficient of the logarithm 2^12 units off", Mismatch, Function("log"),
        "corput/logarithm.glsl", "858988655u", "858992751u"),
    mutant("the last product of the logarithm is cut", Mismatch, Function("log"),
        "corput/logarithm.glsl", "(corput_mulhi(a, p) + 1u) >> 1", "corput_mulhi(a, p) >> 1"),
    mutant("c + f P next to 1", Mismatch, Function("log"),
        "corput/logarithm.glsl", "if (part.n == 0) {", "if (false) {"),
    mutant("the seam of the logarithm at 3/2", Mismatch, Function("negative_log"),
        "corput/logarithm.glsl", "m > 0xb504f333u", "m > 0xc0000000u"),
    mutant("the sign of the rest is lost", Mismatch, Function("log"),
        "corput/logarithm.glsl", "rest.m != 0u && part.negative);\n    }", "false);\n    }"),
    mutant("a native exponential", Linter, Function("exp"),
        "corput/exponential.glsl", "return corput_real_float(corput_real_exp(corput_real(x)));", "return exp(x);"),
    mutant("a coefficient of the exponential 2^12 units off", Mismatch, Function("exp"),
        "corput/exponential.glsl", "41309926u", "41314022u"),
    mutant("1 / ln 2 of 32 bits", Mismatch, Function("exp"),
        "corput/exponential.glsl", "corput_mulhi(m.y, 1545072827u)", "0u"),
    mutant("exponentials are not rounded", Mismatch, Function("exp"),
        "corput/exponential.glsl", "(fraction >> 1) + (fraction & 1u)", "fraction >> 1"),
    mutant("2^z - 1 by subtraction", Mismatch, Function("power"),
        "corput/exponential.glsl", "if (z.e > -32) {", "if (true) {"),
    mutant("-t for -t / (1 + t)", Mismatch, Function("power"),
        "corput/exponential.glsl", "if (z.negative) {\n        // 2^-|z|", "if (false) {\n        // 2^-|z|"),
    mutant("the lower edge for the midpoint", Mismatch, Function("normal_quantile"),
        "corput/normal_quantile.glsl", "<< 1) | 1u;", "<< 1);"),
    mutant("a coefficient of the centre 2^12 units off", Mismatch, Function("normal_quantile"),
        "corput/normal_quantile.glsl", "96846255", "96850351"),
    mutant("a coefficient of the near tail 2^12 units off", Mismatch, Function("normal_quantile"),
        "corput/normal_quantile.glsl", "135808689", "135812785"),
    mutant("a coefficient of the far tail 2^12 units off", Mismatch, Function("normal_quantile"),
        "corput/normal_quantile.glsl", "69888028", "69892124"),
    mutant("tails of the other sign", Mismatch, Function("normal_quantile"),
        "corput/normal_quantile.glsl", "z.negative ? tail : ~tail", "z.negative ? ~tail : tail"),
    mutant("a signed step as an unsigned one", Mismatch, Function("normal_tail"),
        "corput/normal_quantile.glsl", "if (p < 0) {\n        product -= x;", "if (p < 0) {"),
];
