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
    /// Refuses a folder whose page is this command's, or may be, since the document beside it
    /// cannot be read.
    ///
    /// # Errors
    /// [`Error::Output`](crate::Error::Output).
    pub fn refuse(&self, folder: &Path) -> Result<()> {
        let (page, document) = (folder.join(PAGE), folder.join(self.document));
        if !page.exists() || matches!(document.try_exists(), Ok(false)) {
            return Ok(());
        }
        let problem = match read_json(&document, MOST, "") {
            Ok(found) => {
                let schema = found["schema"].as_str().unwrap_or_default();
                if !schema.starts_with(self.schema) {
                    return Ok(());
                }
                format!(
                    "it is the report of `{}`, whose {} is beside it",
                    self.command, self.document
                )
            }
            Err(_) => format!(
                "it may be the report of `{}`: the {} beside it cannot be read",
                self.command, self.document
            ),
        };
        Err(refused(&page, problem, "give another folder with --report"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_document_that_cannot_be_read_guards_its_page() {
        let folder = tempfile::tempdir().expect("a folder");
        let refused = || STUDY.refuse(folder.path()).err().map(|one| one.to_string());
        std::fs::write(folder.path().join(PAGE), "a page").expect("written");
        assert_eq!(refused(), None);
        let document = folder.path().join(STUDY.document);
        std::fs::create_dir(&document).expect("a folder");
        let said = refused().expect("refused");
        assert!(
            said.contains("it may be the report of `corput converge`"),
            "{said}"
        );
        std::fs::remove_dir(&document).expect("removed");
        std::fs::write(&document, "{}").expect("written");
        assert_eq!(refused(), None);
        std::fs::write(&document, "{\"schema\":\"corput-converge/2\"}").expect("written");
        let said = refused().expect("refused");
        assert!(said.contains("whose results.json is beside it"), "{said}");
    }
}
