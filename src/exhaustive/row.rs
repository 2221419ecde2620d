//! A row, and the figures that it is made from.

use super::truth::Rounding;
use super::{Fractions, Subject, manifest, terms};
use crate::catalog::Profile;
use crate::check::{Further, Verdict};
use serde_json::{Value, json};

/// Figures of some of the inputs; they merge in any grouping to the same.
#[derive(Clone, Debug, Default)]
pub struct Figures {
    /// Inputs compared with the twin.
    pub compared: u64,
    /// Those of which a word differs.
    pub mismatches: u64,
    /// Those compared with a truth, too.
    pub judged: u64,
    /// Results that are the nearest float, are not, and may be either.
    pub roundings: [u64; 3],
    /// The first mismatch: number of the input, and what it was.
    mismatch: Option<(u64, String)>,
    /// The worst error, the first input that has it, and what that is.
    worst: Option<(f64, u64, String)>,
}

impl Figures {
    /// A word of input number `i` differs.
    pub fn differs(&mut self, i: u64, what: impl Fn() -> String) {
        self.mismatches += 1;
        self.mismatch.get_or_insert_with(|| (i, what()));
    }

    /// An error of input number `i`, which `what` names.
    pub fn error(&mut self, i: u64, error: f64, what: impl Fn() -> String) {
        // A NaN must not pass unseen.
        let error = if error.is_nan() { f64::INFINITY } else { error };
        if self.worst.as_ref().is_none_or(|(worst, ..)| error > *worst) {
            self.worst = Some((error, i, what()));
        }
    }

    /// A result is or is not the nearest float.
    pub fn rounded(&mut self, rounding: Rounding) {
        let [correct, other, undecided] = &mut self.roundings;
        match rounding {
            Rounding::Correct => *correct += 1,
            Rounding::Other => *other += 1,
            Rounding::Undecided => *undecided += 1,
        }
    }

    /// Both together.
    pub fn merge(&mut self, other: Self) {
        self.compared += other.compared;
        self.mismatches += other.mismatches;
        self.judged += other.judged;
        for (mine, its) in self.roundings.iter_mut().zip(other.roundings) {
            *mine += its;
        }
        self.mismatch = match (self.mismatch.take(), other.mismatch) {
            (Some(a), Some(b)) => Some(if a.0 <= b.0 { a } else { b }),
            (a, b) => a.or(b),
        };
        self.worst = match (self.worst.take(), other.worst) {
            (Some(a), Some(b)) if b.0 > a.0 || b.0 == a.0 && b.1 < a.1 => Some(b),
            (a, b) => a.or(b),
        };
    }
}

/// How the hash of a row stands to the published one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Hash {
    /// It is the published one.
    Equal,
    /// None is published for these inputs.
    Unpublished,
    /// Another one is, which fails the row.
    Differs(String),
}

/// The result over all inputs of a row.
#[derive(Clone, Debug)]
pub struct Row {
    /// What was compared.
    pub name: String,
    /// The module that ran.
    pub kernel: String,
    /// `I` or `F`.
    pub tier: &'static str,
    /// The inputs, in words.
    pub inputs: String,
    /// The figures.
    pub figures: Figures,
    /// The worst error that a judge found, where one judges this row.
    pub worst: Option<f64>,
    /// What it may be.
    pub bound: Option<f64>,
    /// The unit of both.
    pub unit: &'static str,
    /// The input of the worst error: its words in hexadecimal, and of maps their parameters
    /// before and the ULP after them.
    pub worst_at: String,
    /// The first mismatch; empty where there is none.
    pub witness: String,
    /// SHA-256 of the device's words, little-endian, in the order of the inputs.
    pub sha256: String,
    /// Whether that is published.
    pub hash: Hash,
    /// Seconds that it took, compilation and all.
    pub seconds: f64,
    /// How it ended.
    pub verdict: Verdict,
}

impl Row {
    /// A row that nothing has been compared for.
    #[must_use]
    pub fn new(subject: &Subject) -> Self {
        let (kernel, tier, bound, unit, inputs) = match subject {
            Subject::Function(function, domain) => (
                function.kernel,
                function.tier.letter(),
                function.bound,
                function.unit,
                domain.describe(function.kind),
            ),
            Subject::Map(map) => (
                map.group.kernel(Profile::Exact),
                map.tier.letter(),
                Some(1.0),
                "of bound",
                Fractions::describe(map),
            ),
            Subject::Terms => ("reduce", "I", Some(0.0), "of it", terms::INPUTS.into()),
            Subject::Inverses(_) => ("points", "I", Some(0.0), "2^-32", "all 2^32 indices".into()),
        };
        Self {
            name: subject.name(),
            kernel: kernel.to_owned(),
            tier,
            inputs,
            figures: Figures::default(),
            worst: None,
            bound,
            unit,
            worst_at: String::new(),
            witness: String::new(),
            sha256: String::new(),
            hash: Hash::Unpublished,
            seconds: 0.0,
            verdict: Verdict::Failed,
        }
    }

    /// A row that is not run, and why.
    #[must_use]
    pub fn refused(subject: &Subject, why: &str) -> Self {
        Self {
            verdict: Verdict::Refused(why.to_owned()),
            ..Self::new(subject)
        }
    }

    /// Decides the verdict from the figures and the hash of the results.
    #[must_use]
    pub fn judged(mut self, figures: Figures, sha256: String) -> Self {
        if let Some((_, what)) = &figures.mismatch {
            self.witness.clone_from(what);
        }
        if self.bound.is_some() && figures.compared > 0 {
            self.worst = Some(figures.worst.as_ref().map_or(0.0, |(worst, ..)| *worst));
        }
        if let Some((_, _, what)) = &figures.worst {
            self.worst_at.clone_from(what);
        }
        self.hash = match manifest::published(&self.name, &self.inputs) {
            None => Hash::Unpublished,
            Some(hash) if hash == sha256 => Hash::Equal,
            Some(hash) => Hash::Differs(hash),
        };
        let within = match (self.worst, self.bound) {
            (Some(worst), Some(bound)) => worst <= bound,
            _ => true,
        };
        // What nobody has judged keeps to no bound.
        let judged = self.bound.is_none() || figures.judged > 0;
        let right = figures.mismatches == 0 && figures.compared > 0 && judged;
        self.verdict = match right && within && !matches!(self.hash, Hash::Differs(_)) {
            true => Verdict::Passed,
            false => Verdict::Failed,
        };
        (self.figures, self.sha256) = (figures, sha256);
        self
    }

    /// The share of results that are known to be the nearest float; `None` where that is not
    /// asked.
    #[must_use]
    pub fn correct(&self) -> Option<f64> {
        let [correct, other, undecided] = self.figures.roundings;
        let all = correct + other + undecided;
        (all > 0).then(|| correct as f64 / all as f64)
    }

    /// The row as a case of JUnit's.
    #[must_use]
    pub fn further(&self) -> Further {
        let worst = self.worst.map_or(String::new(), |worst| {
            format!(", worst {worst:e} {} at {}", self.unit, self.worst_at)
        });
        let hash = match &self.hash {
            Hash::Differs(published) => format!(", hash {}, not {published}", self.sha256),
            Hash::Equal | Hash::Unpublished => String::new(),
        };
        let failure = format!(
            "{} of {} differ{worst}{hash} {}",
            self.figures.mismatches, self.figures.compared, self.witness
        );
        Further {
            class: "exhaustive",
            name: format!("{}, {}", self.name, self.inputs),
            failure: (self.verdict == Verdict::Failed).then_some(failure),
            skipped: match &self.verdict {
                Verdict::Refused(why) => Some(why.clone()),
                _ => None,
            },
        }
    }

    /// The row as JSON.
    #[must_use]
    pub fn json(&self) -> Value {
        let (hash, published) = match &self.hash {
            Hash::Equal => ("equal", Some(&self.sha256)),
            Hash::Unpublished => ("not published", None),
            Hash::Differs(other) => ("differs", Some(other)),
        };
        let [correct, other, undecided] = self.figures.roundings;
        json!({
            "name": self.name,
            "kernel": self.kernel,
            "tier": self.tier,
            "inputs": self.inputs,
            "compared": self.figures.compared,
            "mismatches": self.figures.mismatches,
            "judged": self.figures.judged,
            "witness": self.witness,
            // JSON has no infinity.
            "worst": self.worst.filter(|worst| worst.is_finite()),
            "worst_at": self.worst_at,
            "bound": self.bound,
            "unit": self.unit,
            "correctly_rounded": correct,
            "otherwise_rounded": other,
            "undecided": undecided,
            "sha256": self.sha256,
            "hash": hash,
            "published": published,
            "seconds": self.seconds,
            "verdict": self.verdict.name(),
            "reason": self.verdict.reason(),
        })
    }
}
