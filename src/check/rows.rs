//! A row of the result.

use crate::catalog::Function;
use serde_json::{Value, json};

/// How a row ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Equal to the reference, within the bound of the judge.
    Passed,
    /// Not so.
    Failed,
    /// Not run, and why: the device makes no promise for it.
    Refused(String),
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
            name: function.name.to_owned(),
            kernel: function.kernel.to_owned(),
            profile: "exact",
            tier: function.tier.letter(),
            compared: 0,
            mismatches: None,
            worst: None,
            bound: function.bound,
            unit: function.unit,
            witness: String::new(),
            verdict: Verdict::Refused(reason.to_owned()),
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
        self
    }

    /// The row as JSON.
    #[must_use]
    pub fn json(&self) -> Value {
        let (verdict, reason) = match &self.verdict {
            Verdict::Passed => ("passed", None),
            Verdict::Failed => ("failed", None),
            Verdict::Refused(reason) => ("refused", Some(reason.clone())),
        };
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
            "verdict": verdict,
            "reason": reason,
        })
    }
}
