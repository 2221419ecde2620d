//! Statistics of points that a device made: how even the bytes of random numbers are, whether
//! every elementary interval of a net has its points, how fast errors fall.

use crate::catalog::{Engine, Request, Sampler};
use crate::converge::{self, Analysis, Settings, Statistic as ErrorStatistic, Study, Truth};
use crate::kernels::Generator;
use crate::stats::{Points, Source, elementary_intervals};
use crate::vulkan::Device;
use crate::{Error, Result};
use serde_json::{Value, json};
use std::sync::Arc;

/// A number that points have, and what it must be.
#[derive(Clone, Debug, PartialEq)]
pub struct Statistic {
    /// What was measured.
    pub what: String,
    /// Of which sampler, with its integrand where there is one.
    pub of: String,
    /// Points that it was measured on.
    pub points: u64,
    /// The number.
    pub value: f64,
    /// The least that passes.
    pub least: f64,
    /// The most that passes.
    pub most: f64,
}

impl Statistic {
    /// Whether the number is what it must be; a NaN is not.
    #[must_use]
    pub fn passes(&self) -> bool {
        (self.least..=self.most).contains(&self.value)
    }

    /// As JSON.
    #[must_use]
    pub fn json(&self) -> Value {
        json!({
            "what": self.what,
            "of": self.of,
            "points": self.points,
            "value": self.value,
            "least": self.least,
            "most": self.most,
            "verdict": if self.passes() { "passed" } else { "failed" },
        })
    }
}

/// Seed of all that is random here.
const SEED: u64 = 20_250;

/// Random numbers, all of them of 32 bits.
const RANDOM: [&str; 3] = ["random", "random-fast", "pcg32"];

/// Samplers whose first 2^k points of two dimensions have one in each interval of area 2^-k.
const NETS: [&str; 6] = [
    "sobol",
    "sobol:owen",
    "sobol:owen-hash",
    "sobol:matrix",
    "pmj02",
    "hammersley",
];

/// Integrand, sampler, and the slope that its errors have in theory. A smooth integrand of one
/// dimension by scrambled nets has -3/2, which 32 replicates show within a tenth.
const SLOPES: [(&str, &str, f64); 3] = [
    ("x-squared", "random", -0.5),
    ("x-squared", "sobol:owen-hash", -1.5),
    ("x-squared", "stratified", -1.5),
];

/// Measures all of them on a device: seconds.
///
/// # Errors
/// Those of the device.
pub fn statistics(device: &Arc<Device>) -> Result<Vec<Statistic>> {
    let mut list = Vec::new();
    for name in RANDOM {
        list.extend(bytes(name, &made(device, &points(name, 1 << 16)?)?));
    }
    for name in NETS {
        list.push(intervals(
            name,
            &made(device, &points(name, 1 << 10)?)?,
            [2, 2],
        )?);
    }
    // Hammersley's set takes its first coordinate from the count; Halton's has two bases.
    list.push(intervals(
        "halton",
        &made(device, &points("halton", 1000)?)?,
        [2, 3],
    )?);
    let engine = converge::Engine::Device(Arc::clone(device));
    for (integrand, sampler, theory) in SLOPES {
        list.push(slope(&engine, integrand, sampler, theory)?);
    }
    Ok(list)
}

/// Two-dimensional points as fractions.
fn points(name: &str, count: u64) -> Result<Request> {
    Sampler::parse(name)?.request(2, count, SEED)
}

fn made(device: &Arc<Device>, request: &Request) -> Result<Vec<u32>> {
    let mut generator = Generator::new(device, request)?;
    let mut words = Vec::new();
    let mut done = 0;
    while done < request.count {
        let count = generator.chunk().min(request.count - done);
        generator.make(done, count, &mut |piece| {
            words.extend_from_slice(piece);
            Ok(())
        })?;
        done += count;
    }
    Ok(words)
}

/// Pearson's statistic of 256 bins, of the highest and of the lowest byte. With 255 degrees of
/// freedom a fair one is beyond either end once in a million (Wilson and Hilferty 1931).
fn bytes(name: &str, words: &[u32]) -> Vec<Statistic> {
    let free = 255.0f64;
    let spread = 2.0 / (9.0 * free);
    let end = |deviations: f64| free * (1.0 - spread + deviations * spread.sqrt()).powi(3);
    let of = |(which, place): (&str, usize)| {
        let mut bins = [0u32; 256];
        for word in words {
            let byte = word.to_be_bytes().get(place).copied().unwrap_or(0);
            if let Some(bin) = bins.get_mut(usize::from(byte)) {
                *bin += 1;
            }
        }
        let expected = words.len() as f64 / 256.0;
        let square = |bin: &u32| (f64::from(*bin) - expected).powi(2) / expected;
        Statistic {
            what: format!("chi-square of the {which} byte"),
            of: name.to_owned(),
            points: words.len() as u64 / 2,
            value: bins.iter().map(square).sum(),
            least: end(-4.753),
            most: end(4.753),
        }
    };
    [("highest", 0), ("lowest", 3)].map(of).into()
}

/// Shapes of elementary intervals, of all with no more cells than there are points, of which a
/// cell has too many or too few.
fn intervals(name: &str, words: &[u32], bases: [u32; 2]) -> Result<Statistic> {
    let values = words.iter().map(|&u| f64::from(u) / 4_294_967_296.0);
    let points = Points::new(2, values.collect(), Source::U32)?;
    let shapes = elementary_intervals(&points, &bases, false, u64::MAX, &mut |_, _| Ok(()))?;
    let [one, other] = bases;
    Ok(Statistic {
        what: format!(
            "unfair shapes of elementary intervals, of {} in bases {one} and {other}",
            shapes.len()
        ),
        of: name.to_owned(),
        points: points.rows() as u64,
        value: shapes.iter().filter(|shape| !shape.is_fair()).count() as f64,
        least: 0.0,
        most: 0.0,
    })
}

/// The slope of the error over the number of points.
fn slope(engine: &converge::Engine, integrand: &str, name: &str, theory: f64) -> Result<Statistic> {
    let sampler = Sampler::parse(name)?;
    let rows = converge::rows(integrand, &[], &[sampler])?;
    let settings = Settings {
        max_count: 1 << 12,
        replicates: 64,
        seed: SEED,
        ..Settings::default()
    };
    let study = Study::new(rows, settings)?;
    let row = study.rows().first().ok_or_else(|| Error::Arguments {
        asked: format!("a study of {integrand}"),
        limit: "it has no rows".into(),
        remedy: "name an integrand that there is".into(),
    })?;
    let watch = &mut || Ok(());
    let truth = Truth::of(engine, &study, row, watch)?;
    let cell = engine.measure(&study, row, sampler, watch)?;
    // x^2 is large nearly everywhere: its hits are its points.
    let found = Analysis::new(
        &cell,
        &truth,
        sampler.is_random(),
        ErrorStatistic::Rmse,
        None,
    );
    Ok(Statistic {
        what: "slope of the RMSE, 2^4 to 2^12 points, 64 replicates".into(),
        of: format!("{name} on {integrand}"),
        points: 1 << 12,
        value: found.slope.map_or(f64::NAN, |slope| slope.value),
        least: theory - 0.1,
        most: theory + 0.1,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bulk::Reference;

    fn words(request: &Request) -> Vec<u32> {
        let mut words = vec![0; 2 * request.count as usize];
        Reference::new(request).fill(0, &mut words).unwrap();
        words
    }

    #[test]
    fn uneven_bytes_are_seen_at_either_end() {
        let fair = words(&points("random", 1 << 16).unwrap());
        assert!(bytes("", &fair).iter().all(Statistic::passes));
        // A bit that is set once too often in 32.
        let biased: Vec<u32> = fair
            .iter()
            .enumerate()
            .map(|(i, w)| w | u32::from(i % 32 == 0))
            .collect();
        let found = bytes("", &biased);
        assert!(found[0].passes() && !found[1].passes(), "{found:?}");
        // A counter is too even.
        let even: Vec<u32> = (0..1 << 17).collect();
        assert!(!bytes("", &even)[1].passes());
    }

    #[test]
    fn a_point_in_the_wrong_interval_is_seen() {
        for name in NETS {
            let mut net = words(&points(name, 1 << 10).unwrap());
            assert!(intervals(name, &net, [2, 2]).unwrap().passes(), "{name}");
            net[77] ^= 1 << 31;
            assert!(!intervals(name, &net, [2, 2]).unwrap().passes(), "{name}");
        }
        let random = words(&points("random", 1 << 10).unwrap());
        assert!(!intervals("random", &random, [2, 2]).unwrap().passes());
    }

    #[test]
    fn slopes_are_those_of_theory_and_of_no_other() {
        let engine = converge::Engine::Cpu;
        for (integrand, sampler, theory) in SLOPES {
            let found = slope(&engine, integrand, sampler, theory).unwrap();
            assert!(found.passes(), "{found:?}");
        }
        assert!(
            !slope(&engine, "x-squared", "random", -1.5)
                .unwrap()
                .passes()
        );
    }
}
