//! Elementary functions of the native profile: each held to what Vulkan's precision tables allow.

use super::elementary::{ELEMENTARY, ElementaryFunction};
use super::inputs::arguments;
use super::rows::Row;
use crate::Result;
use crate::catalog::{Kind, Profile};
use crate::interface::task;
use crate::kernels::Elementary;
use crate::vulkan::Device;
use std::sync::Arc;

/// The functions that Vulkan says something of: the normal quantile is a formula of many.
pub(super) fn functions() -> impl Iterator<Item = &'static ElementaryFunction> {
    ELEMENTARY
        .iter()
        .filter(|function| function.name != "normal_quantile")
}

/// The row of a function.
pub(super) fn name(function: &ElementaryFunction) -> String {
    format!("native_{}", function.name)
}

/// Checks a function.
pub(super) fn check(device: &Arc<Device>, function: &'static ElementaryFunction) -> Result<Row> {
    let kernel = Elementary::new(device, function.id, Profile::Native, task::SAMPLE)?;
    compare_native_elementary(&kernel, function)
}

/// Holds a function of the native profile to its allowance, on a kernel of the caller's. One that
/// is the driver's alone, beyond it, is a defect of the driver's.
///
/// # Errors
/// Those of the device.
pub fn compare_native_elementary(
    kernel: &Elementary,
    function: &'static ElementaryFunction,
) -> Result<Row> {
    let arguments: Vec<_> = arguments(Kind::Words)
        .into_iter()
        .filter(|&[a, ..]| is_promised(function, a))
        .collect();
    let results = kernel.run(&arguments)?;
    let module = Elementary::kernel(Profile::Native);
    let mut row = Row::native(&name(function), module, 1.0, "of what Vulkan allows");
    row.compared = arguments.len() as u64;
    let mut worst = 0.0;
    for (&[a, b, ..], got) in arguments.iter().zip(&results) {
        row.hash(&got[..function.width]);
        let truth = function.truth([a, b, 0]);
        for (&word, &truth) in got.iter().zip(&truth).take(function.width) {
            let error = error(function, word, truth) / allowed(function, a, truth);
            if error > worst || error.is_nan() {
                worst = error;
                row.witness = format!("{}: {word:08x}, not {truth:e}", function.input([a, b]));
            }
        }
    }
    row.worst = Some(worst);
    // The others are formulas of the headers.
    let of_driver = ["sqrt", "divide", "multiply", "log", "log2", "exp", "exp2"];
    Ok(match of_driver.contains(&function.name) {
        true => row.judged_of_driver(),
        false => row.judged(),
    })
}

/// Vulkan promises a sine and a cosine from -pi to pi, where larger fractions of a turn, rounded,
/// are not.
fn is_promised(function: &ElementaryFunction, a: u32) -> bool {
    function.name != "cos_sin" || a < 0x7fff_ff80
}

/// The distance from the truth, as a number.
fn error(function: &ElementaryFunction, word: u32, truth: f64) -> f64 {
    if function.name == "atan2" {
        // A turn more or less is the same angle.
        let away = (f64::from(word) / 4_294_967_296.0 - truth).abs();
        return away.min(1.0 - away);
    }
    (f64::from(f32::from_bits(word)) - truth).abs()
}

fn power(exponent: i32) -> f64 {
    f64::powi(2.0, exponent)
}

/// One in the last place of a float near this.
fn ulp(truth: f64) -> f64 {
    let magnitude = truth.abs().max(f64::from(f32::MIN_POSITIVE));
    power((magnitude.to_bits() >> 52) as i32 - 1023 - 23)
}

/// What "Precision and Operation of SPIR-V Instructions" allows a result for the first argument
/// `a`, absolute, with the rounding of what the kernel does before and after. Vulkan leaves open
/// which neighbour is rounded to.
fn allowed(function: &ElementaryFunction, a: u32, truth: f64) -> f64 {
    let ulp = ulp(truth);
    // Absolute where the argument is from 1/2 to 2.
    let logarithm = |x: f64| match (0.5..=2.0).contains(&x) {
        true => power(-21),
        false => 3.0 * ulp,
    };
    match function.name {
        // That of 1 over the inverse root: 2 ULP and the quotient's 2.5.
        "sqrt" => 4.5 * power(-23) * truth,
        "divide" => 2.5 * ulp,
        "multiply" => ulp,
        // The angle is two products and a conversion.
        "cos_sin" => power(-11) + power(-20),
        // 4096 ULP of the angle, and what makes it a fraction.
        "atan2" => power(-11) * truth.min(1.0 - truth) + power(-22),
        "log" | "log2" => logarithm(function.positive(a)),
        // A sum of powers, of which each step is rounded; or the logarithm of 1 - u, rounded.
        "negative_log" if a < 0x1000_0000 => 8.0 * ulp,
        "negative_log" => {
            let rounded = a.wrapping_neg() as f32 / 4_294_967_296.0;
            logarithm(rounded.into()) + power(-23)
        }
        _ => (3.0 + 2.0 * function.positive(a)) * ulp,
    }
}

#[cfg(test)]
mod tests {
    use super::{ELEMENTARY, allowed, error, functions, is_promised, power};

    fn of(name: &str, a: u32, truth: f64) -> f64 {
        let function = ELEMENTARY.iter().find(|one| one.name == name);
        allowed(function.expect("a function"), a, truth)
    }

    /// A word of which the kernel makes this float.
    fn word(x: f32) -> u32 {
        let bits = x.to_bits();
        (bits & 0x807f_ffff) | (((bits >> 23 & 0xff) - 101) << 23)
    }

    /// The numbers of the specification's tables.
    #[test]
    fn allowances_are_those_of_the_tables() {
        assert_eq!(of("divide", 0, 1.5), 2.5 * power(-23));
        assert_eq!(of("divide", 0, 0.75), 2.5 * power(-24));
        assert_eq!(of("multiply", 0, -3.0), power(-22));
        assert_eq!(of("sqrt", 0, 2.0), 9.0 * power(-23));
        assert_eq!(of("exp", word(-2.0), 0.14), 7.0 * power(-26));
        assert_eq!(of("exp2", word(0.5), 1.4), 4.0 * power(-23));
        assert_eq!(of("log", word(0.75), -0.3), power(-21));
        assert_eq!(of("log2", word(4.0), 2.0), 3.0 * power(-22));
        assert_eq!(of("atan2", 0, 0.75), power(-13) + power(-22));
        assert_eq!(of("cos_sin", 0, 0.1), power(-11) + power(-20));
        assert_eq!(of("negative_log", 1, power(-32)), 8.0 * power(-55));
        // Its logarithm is of exactly 1/2.
        let half = of("negative_log", 0x8000_0001, 0.7);
        assert_eq!(half, power(-21) + power(-23));
        let less = of("negative_log", 0xc000_0000, 1.4);
        assert_eq!(less, 4.0 * power(-23));
    }

    #[test]
    fn a_turn_more_is_no_error_and_half_a_turn_ends_the_promise() {
        let find = |name: &str| functions().find(|one| one.name == name).expect("there");
        assert!(error(find("atan2"), u32::MAX, 0.0) < power(-31));
        assert!(is_promised(find("cos_sin"), 0x7fff_ff7f));
        assert!(!is_promised(find("cos_sin"), 0x7fff_ffff));
        assert_eq!(functions().count(), ELEMENTARY.len() - 1);
    }
}
