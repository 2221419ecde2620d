//! Each law is that of the judge: its chart leads back and has the area that differences say,
//! its pdf is that of the judge's samples, its fractions are those of the judge's samples.

use super::laws::{Case, Law, case, cases, random};
use corput::glam::{DVec2, DVec3, dvec2};

const WHAT: [&str; 4] = ["pdf", "fractions", "chart", "area"];

/// A sample rounded by 2^-53 is up to 1e4 times that off in units of a lobe of alpha 1e-4, and
/// grazing ones ten times that; of fractions, triangles leave the last two bits out, filters
/// take the middles of steps of 2^-32; central differences of a root are (step / t)^2 / 8
/// off, beyond a hundred steps 1.3e-5.
const BOUNDS: [f64; 4] = [1e-11, 3.5 / 4_294_967_296.0, 1e-11, 3e-5];

/// The worst differences of a law from the judge, over the bounds.
fn differences(case: &Case) -> [f64; 4] {
    let (mut worst, mut compared) = ([0f64; 4], 0);
    let mut note = |i: usize, difference: f64| {
        let over = difference.abs() / BOUNDS[i];
        worst[i] = if over.is_nan() {
            f64::INFINITY
        } else {
            worst[i].max(over)
        };
    };
    for i in 0..2000 {
        let u = random(7777, i);
        let Some((x, pdf)) = case.truth(u) else {
            continue;
        };
        compared += 1;
        let unit = u.map(|u| f64::from(u) / 4_294_967_296.0);
        let v = case.law.fractions(x);
        note(0, case.law.pdf(x) / pdf - 1.0);
        note(1, turned(unit[0] - v.x));
        if !case.line() {
            // Next to the pole, whichever end it is at, angles mean less.
            note(1, turned(unit[1] - v.y) * unit[0].min(1.0 - unit[0]).sqrt());
        }
        let t = case.law.chart(x);
        note(2, (case.law.at(t) - x).length() / x.length());
        if let Some(ratio) = area_ratio(case, t) {
            note(3, ratio - 1.0);
        }
    }
    assert!(compared > 1000, "{compared} samples of the judge");
    worst
}

#[test]
fn laws_agree_with_the_judge() {
    let mut wrong = Vec::new();
    for case in cases() {
        for (what, over) in WHAT.iter().zip(differences(&case)) {
            if over >= 1.0 {
                wrong.push(format!(
                    "{}: {what} {over:.1e} times its bound",
                    case.name()
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A law of which one function is off by a part.
struct Off {
    law: Box<dyn Law>,
    parts: [f64; 4],
}

impl Law for Off {
    fn at(&self, t: DVec2) -> DVec3 {
        self.law.at(t * (1.0 + self.parts[2]))
    }
    fn stretch(&self, t: DVec2) -> f64 {
        self.law.stretch(t) * (1.0 + self.parts[3])
    }
    fn chart(&self, x: DVec3) -> DVec2 {
        self.law.chart(x)
    }
    fn pdf(&self, x: DVec3) -> f64 {
        self.law.pdf(x) * (1.0 + self.parts[0])
    }
    fn fractions(&self, x: DVec3) -> DVec2 {
        self.law.fractions(x) * (1.0 + self.parts[1])
    }
}

#[test]
fn a_law_that_is_off_is_seen() {
    for (name, values) in [
        ("uniform-sphere", &[][..]),
        ("filter-mitchell", &[2.0, 0.0, 0.5]),
        ("ggx-vndf-bounded", &[0.1, 0.5, -0.48, 0.6, 0.64]),
    ] {
        for (i, part) in [1e-10, 1e-8, 1e-9, 1e-4].into_iter().enumerate() {
            let mut parts = [0.0; 4];
            parts[i] = part;
            let sound = case(name, values);
            assert!(differences(&sound).iter().all(|over| *over < 1.0));
            let law = Box::new(Off {
                law: sound.law,
                parts,
            });
            let over = differences(&Case { law, ..sound });
            assert!(over[i] > 1.0, "{name}: {} {over:?}", WHAT[i]);
        }
    }
}

fn turned(difference: f64) -> f64 {
    difference.abs().min(1.0 - difference.abs())
}

/// The area of the image of a small square around t, by central differences, over that of
/// the law.
fn area_ratio(case: &Case, t: DVec2) -> Option<f64> {
    const STEP: f64 = 1e-5;
    let edge = |t: f64| t.min(1.0 - t) < 100.0 * STEP;
    if edge(t.x) || !case.line() && edge(t.y) {
        return None;
    }
    let along = |step: DVec2| (case.law.at(t + step) - case.law.at(t - step)) / (2.0 * STEP);
    let (p, q) = (along(dvec2(STEP, 0.0)), along(dvec2(0.0, STEP)));
    let area = if case.line() {
        p.length()
    } else {
        p.cross(q).length()
    };
    Some(area / case.law.stretch(t))
}
