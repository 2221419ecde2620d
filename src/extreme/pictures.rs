//! Environments without light, and with texels that are no number.

use super::case::{Case, Measure, Source, ULP};
use crate::Result;
use crate::bulk::map_sample;
use crate::catalog::{Map, Mapping, Profile};
use crate::environment::{Environment, Options};

/// Samples of an environment of these texels, two columns wide.
fn drawn(texels: &[[f32; 3]]) -> Result<Vec<[u32; 4]>> {
    let height = texels.len() as u32 / 2;
    let made = Environment::new(2, height, texels, Options::default())?;
    let map = Map::from_name("environment")?;
    let mapping = Mapping::with_values(map, &[])?.with_environment(made)?;
    let fractions = (0..1024u32).map(|i| [i << 22, i.reverse_bits(), 0]);
    Ok(fractions
        .map(|u| map_sample(&mapping, Profile::Exact, u))
        .collect())
}

/// The density of the first texel by floats: its share of the sum.
fn share(texels: &[[f32; 3]; 8]) -> f64 {
    let [[first, ..], ..] = texels;
    let sum: f32 = texels.iter().map(|[red, ..]| red).sum();
    (first / sum).into()
}

fn relative(got: f64, truth: f64) -> f64 {
    Measure::Relative.error(&[got], &[truth])
}

pub(super) fn pictures() -> Result<Vec<Case>> {
    let black = [[0.0; 3]; 8];
    let uniform = 0.25 / std::f64::consts::PI;
    let ours = drawn(&black)?
        .into_iter()
        .map(|[.., pdf]| relative(f32::from_bits(pdf).into(), uniform))
        .fold(0.0, f64::max);
    let mut cases = vec![Case::host(
        36,
        "environment without light: uniform, pdf",
        [relative(share(&black), 0.125), ours],
        Source::ClosedForm,
        ULP,
    )];
    for (name, texel) in [
        ("NaN", f32::NAN),
        ("inf", f32::INFINITY),
        ("-1", -1.0),
        ("denormal", 1e-40),
    ] {
        let picture = |fifth: f32| {
            let [one, other] = [[1.0; 3], [fifth; 3]];
            [one, one, one, one, one, other, one, one]
        };
        let (clean, broken) = (picture(0.0), picture(texel));
        let (before, after) = (drawn(&clean)?, drawn(&broken)?);
        let differ = after.iter().zip(&before).filter(|(a, b)| a != b).count();
        cases.push(Case::host(
            37,
            format!("environment with a texel of {name}: samples that differ by it"),
            [
                relative(share(&broken), share(&clean)),
                differ as f64 / before.len() as f64,
            ],
            Source::Integers,
            0.0,
        ));
    }
    Ok(cases)
}
