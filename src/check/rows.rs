//! A row of the result.

use crate::catalog::Function;
use crate::report::hexadecimal;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

/// How a row ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Equal to the reference, within the bound of the judge.
    Passed,
    /// Not so.
    Failed,
    /// A function of the driver's own is beyond what Vulkan allows it: that is for its makers to
    /// mend, and breaks no promise of this crate.
    Defect,
    /// Not run, and why: the device makes no promise for it.
    Refused(String),
}

impl Verdict {
    /// As documents have it.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Failed => "failed",
            Self::Defect => "defect",
            Self::Refused(_) => "refused",
        }
    }

    /// Why it was refused.
    #[must_use]
    pub fn reason(&self) -> Option<&str> {
        match self {
            Self::Refused(reason) => Some(reason),
            _ => None,
        }
    }
}

/// The result of one function or kernel.
#[derive(Clone, Debug)]
pub struct Row {
    /// What was checked.
    pub name: String,
    /// The module that ran.
    pub kernel: String,
    /// `exact` or `native`.
    pub profile: &'static str,
    /// `I`, `F`, or `-` in the native profile.
    pub tier: &'static str,
    /// Results compared.
    pub compared: u64,
    /// Results whose words differ from the reference; `None` in the native profile,
    /// where they may.
    pub mismatches: Option<u64>,
    /// The worst error that the judge found, where it judges this row.
    pub worst: Option<f64>,
    /// What it may be.
    pub bound: Option<f64>,
    /// The unit of both.
    pub unit: &'static str,
    /// The first mismatch, or else the input of the worst error.
    pub witness: String,
    /// How it ended.
    pub verdict: Verdict,
    /// SHA-256 of the device's words, little-endian, in the order of the arguments: of the
    /// exact profile the same on every device.
    pub sha256: Option<String>,
    /// Seconds that it took, compilation and all.
    pub seconds: f64,
    words: Option<Box<Sha256>>,
}

/// An error or a bound as tables show it.
#[must_use]
pub fn figure(value: f64) -> String {
    match value {
        0.0 => "0".to_owned(),
        v if (1e-2..1e4).contains(&v) => format!("{v:.3}"),
        v => format!("{v:.2e}"),
    }
}

/// The words of a sum, the lowest first.
pub(super) fn words128(sum: u128) -> [u32; 4] {
    [0, 32, 64, 96].map(|shift| (sum >> shift) as u32)
}

impl Row {
    /// A row of tier I that nothing has been compared for.
    #[must_use]
    pub fn exact(name: &str, kernel: &str) -> Self {
        Self {
            name: name.to_owned(),
            kernel: kernel.to_owned(),
            profile: "exact",
            tier: "I",
            compared: 0,
            mismatches: Some(0),
            worst: None,
            bound: None,
            unit: "",
            witness: String::new(),
            verdict: Verdict::Failed,
            sha256: None,
            seconds: 0.0,
            words: None,
        }
    }

    /// A row of the native profile, whose errors may be up to `bound` of that unit.
    #[must_use]
    pub fn native(name: &str, kernel: &str, bound: f64, unit: &'static str) -> Self {
        Self {
            profile: "native",
            tier: "-",
            mismatches: None,
            worst: Some(0.0),
            bound: Some(bound),
            unit,
            ..Self::exact(name, kernel)
        }
    }

    /// Takes words of the device into the row's hash.
    pub fn hash(&mut self, words: &[u32]) {
        let hash = self.words.get_or_insert_default();
        for word in words {
            hash.update(word.to_le_bytes());
        }
    }

    /// Counts a comparison; the first that fails is the witness.
    pub fn count(&mut self, equal: bool, witness: impl Fn() -> String) {
        self.compared += 1;
        if !equal {
            self.mismatches = self.mismatches.map(|count| count + 1);
            if self.witness.is_empty() {
                self.witness = witness();
            }
        }
    }

    /// A row that was not run.
    #[must_use]
    pub fn refused(function: &Function, reason: &str) -> Self {
        Self {
            tier: function.tier.letter(),
            mismatches: None,
            bound: function.bound,
            unit: function.unit,
            verdict: Verdict::Refused(reason.to_owned()),
            ..Self::exact(function.name, function.kernel)
        }
    }

    /// Decides the verdict from the figures.
    #[must_use]
    pub fn judged(mut self) -> Self {
        let equal = self.mismatches.is_none_or(|count| count == 0);
        let within = match (self.worst, self.bound) {
            // A NaN is never within.
            (Some(worst), Some(bound)) => worst <= bound,
            _ => true,
        };
        self.verdict = if equal && within && self.compared > 0 {
            Verdict::Passed
        } else {
            Verdict::Failed
        };
        let words = self.words.take();
        self.sha256 = words.map(|words| hexadecimal(&words.finalize()));
        self
    }

    /// The same of a function that is the driver's own, whose errors are its defects.
    #[must_use]
    pub fn judged_of_driver(self) -> Self {
        let mut row = self.judged();
        if row.verdict == Verdict::Failed && row.compared > 0 {
            row.verdict = Verdict::Defect;
        }
        row
    }

    /// The row as JSON.
    #[must_use]
    pub fn json(&self) -> Value {
        json!({
            "name": self.name,
            "kernel": self.kernel,
            "profile": self.profile,
            "tier": self.tier,
            "compared": self.compared,
            "mismatches": self.mismatches,
            "worst": self.worst,
            "bound": self.bound,
            "unit": self.unit,
            "witness": self.witness,
            "sha256": self.sha256,
            "seconds": self.seconds,
            "verdict": self.verdict.name(),
            "reason": self.verdict.reason(),
        })
    }
}
