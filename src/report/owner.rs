//! Folders of reports: the page of one command is not written over that of another.

use super::place::refused;
use super::read_json;
use crate::error::Result;
use std::path::Path;

/// The page that several commands write.
const PAGE: &str = "report.html";

/// Bytes of a document at most.
const MOST: u64 = 1 << 30;

/// Whose page it is: the document that a command writes beside it.
pub(crate) struct Owner {
    /// The name of the document.
    pub document: &'static str,
    /// What its `schema` begins with.
    pub schema: &'static str,
    /// Who writes them.
    pub command: &'static str,
}

/// `corput check`.
#[cfg(feature = "images")]
pub(crate) const CARD: Owner = Owner {
    document: "report.json",
    schema: "corput-card/",
    command: "corput check",
};

/// `corput converge`.
pub(crate) const STUDY: Owner = Owner {
    document: "results.json",
    schema: "corput-converge/",
    command: "corput converge",
};

impl Owner {
    /// Refuses a folder whose page is this command's.
    ///
    /// # Errors
    /// [`Error::Output`](crate::Error::Output).
    pub fn refuse(&self, folder: &Path) -> Result<()> {
        let page = folder.join(PAGE);
        if !page.exists() {
            return Ok(());
        }
        let found = read_json(&folder.join(self.document), MOST, "").unwrap_or_default();
        let schema = found["schema"].as_str().unwrap_or_default();
        if !schema.starts_with(self.schema) {
            return Ok(());
        }
        let problem = format!(
            "it is the report of `{}`, whose {} is beside it",
            self.command, self.document
        );
        Err(refused(&page, problem, "give another folder with --report"))
    }
}
