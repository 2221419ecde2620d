//! The report card of a driver: who it is, what it does with floats, which kernels ran and how
//! every row ended, and what that does not prove. As a document for machines and as a page.

mod device;
mod page;
mod statistics;
mod supplement;

pub use device::{device_document, probe_document};
pub use statistics::{Statistic, statistics};
pub use supplement::Supplement;

use crate::check::{Outcome, Row, junit};
use crate::compile::policy;
use crate::extreme;
use crate::interface::{KERNELS, Profile};
use crate::kernels::spirv;
use crate::report::{Document, STUDY, Target, create_folder, hexadecimal, save};
use crate::spirv::{self as modules, Tier};
use crate::vulkan::DeviceInfo;
use crate::{Error, Result};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};

/// Version of the document's form.
pub const SCHEMA: &str = "corput-card/2";

/// A check of a device.
#[derive(Clone, Copy, Debug)]
pub struct Card<'a> {
    /// The device.
    pub info: &'a DeviceInfo,
    /// What the check found.
    pub outcome: &'a Outcome,
    /// What a whole card has besides; `None` where a part of the check was asked for.
    pub supplement: Option<&'a Supplement>,
    /// The command that ran it.
    pub command: &'a str,
}

impl Card<'_> {
    /// The document: identity, kernels with their hashes, probe, rows, the catalogue of extreme
    /// inputs and the statistics (`null` where they were not measured), what was not proved.
    ///
    /// # Errors
    /// None, if the stock kernels are as built.
    pub fn document(&self) -> Result<Value> {
        let rows: Vec<Value> = self.outcome.rows.iter().map(Row::json).collect();
        Ok(json!({
            "schema": SCHEMA,
            "corput": env!("CARGO_PKG_VERSION"),
            "command": self.command,
            "host": format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
            "device": device_document(self.info),
            "probe": probe_document(&self.outcome.probe),
            "kernels": kernels()?,
            "fingerprint": self.fingerprint(),
            "failures": self.failures(),
            "driver_defects": self.outcome.defects(),
            "left_out": self.outcome.left_out,
            "not_proved": self.not_proved(),
            "rows": rows,
            "catalogue": self.supplement.map(|more| extreme::rows_json(&more.catalogue)),
            "statistics": self.supplement.map(|more| {
                more.statistics.iter().map(Statistic::json).collect::<Vec<Value>>()
            }),
        }))
    }

    /// SHA-256 over names, kernels and hashes of the exact rows, one a line: equal for two
    /// drivers that ran the same rows with the same bits.
    #[must_use]
    pub fn fingerprint(&self) -> String {
        let mut hash = Sha256::new();
        for row in self
            .outcome
            .rows
            .iter()
            .filter(|row| row.profile == "exact")
        {
            let words = row.sha256.as_deref().unwrap_or("-");
            hash.update(format!("{}\t{}\t{words}\n", row.name, row.kernel));
        }
        hexadecimal(&hash.finalize())
    }

    /// Rows, extreme inputs and statistics that failed.
    #[must_use]
    pub fn failures(&self) -> usize {
        self.outcome.failures() + self.supplement.map_or(0, Supplement::failures)
    }

    /// The check as JUnit XML, of a device in words.
    #[must_use]
    pub fn junit(&self, device: &str) -> String {
        let further = self.supplement.map_or_else(Vec::new, Supplement::cases);
        junit(&self.outcome.rows, &self.outcome.left_out, &further, device)
    }

    /// What a reader might take for proved.
    #[must_use]
    pub fn not_proved(&self) -> Vec<String> {
        let mut list: Vec<String> = NOT_PROVED.iter().map(ToString::to_string).collect();
        if self.supplement.is_none() {
            list.push(
                "The extreme inputs and the statistics, which a whole check with --report has."
                    .into(),
            );
        }
        if !self.outcome.probe.tier_f() {
            list.push("Tier F: the probe does not find rounding to nearest even here.".into());
        }
        match self.outcome.left_out.len() {
            0 => {}
            left => list.push(format!("{left} rows, for which there was no time.")),
        }
        list
    }

    /// Writes `report.json`, `report.html` and `junit.xml`, each of which is replaced whole; gives
    /// their paths.
    ///
    /// # Errors
    /// [`Error::Output`] and [`Error::Io`] for what cannot be written.
    pub fn write(&self, files: Files) -> Result<Vec<PathBuf>> {
        let document = self.document()?;
        let [json, html, junit] = Files::NAMES.map(|name| files.folder.join(name));
        files.json.finish(format!("{document:#}\n").as_bytes())?;
        files.html.finish(page::page(self, &document).as_bytes())?;
        save(&junit, self.junit(&self.info.name).as_bytes())?;
        Ok(vec![json, html, junit])
    }
}

/// The files of a card, opened before the work that they report.
pub struct Files {
    folder: PathBuf,
    json: Document,
    html: Document,
}

impl Files {
    const NAMES: [&str; 3] = ["report.json", "report.html", "junit.xml"];

    /// Makes the folder, and opens what only this card can be writing there: `junit.xml` may be
    /// the caller's own too.
    ///
    /// # Errors
    /// [`Error::Output`] for what cannot be made or written, and for a folder with the report of a
    /// study, whose page has the same name.
    pub fn open(folder: &Path) -> Result<Self> {
        create_folder(folder, "--report")?;
        STUDY.refuse(folder)?;
        let [json, html, _] = Self::NAMES.map(|name| Target::File(folder.join(name)));
        Ok(Self {
            folder: folder.to_owned(),
            json: Document::open(&json)?,
            html: Document::open(&html)?,
        })
    }
}

const NOT_PROVED: &[&str] = &[
    "All arguments: functions were compared on critical ones and on random ones, which the rows count.",
    "The native profile's bits: only its errors are held to Vulkan's precision tables.",
    "Other versions of this driver, other compilers of GLSL, and other uses of the headers.",
];

/// Each stock kernel: the hash of its SPIR-V, its profile, and what the linter says.
///
/// # Errors
/// None, if the stock kernels are as built.
pub fn kernels() -> Result<Vec<Value>> {
    KERNELS.iter().map(kernel).collect()
}

fn kernel(kernel: &crate::interface::Kernel) -> Result<Value> {
    let words = spirv(kernel.name)?;
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    let exact = matches!(
        kernel.profile,
        Profile::Integer | Profile::Wide | Profile::Float
    );
    let report = modules::lint(&words, &policy(kernel.profile)).map_err(|error| Error::Shader {
        shader: kernel.name.to_owned(),
        problem: error.to_string(),
    })?;
    let tier = match report.tier {
        _ if !exact => "native",
        Some(Tier::Integer) => "I",
        Some(Tier::Float) => "F",
        None => "none",
    };
    Ok(json!({
        "name": kernel.name,
        "sha256": hexadecimal(&Sha256::digest(&bytes)),
        "tier": tier,
        "violations": report.violations.iter().map(ToString::to_string).collect::<Vec<_>>(),
    }))
}
