//! The right to write a file that is made at once, which keeps no chunks.

use super::journal::Journal;
use super::{JOURNAL, PARTIAL, beside};
use crate::error::Result;
use std::fs;
use std::path::{Path, PathBuf};

/// The lock of a file's journal, until it is dropped.
pub(in crate::report) struct Turn {
    journal: Option<Journal>,
    path: PathBuf,
    partial: PathBuf,
}

impl Turn {
    /// Waits for nobody: a file that another run writes is refused. `asked` is the file as
    /// messages name it, `real` without symbolic links.
    pub(in crate::report) fn take(real: &Path, asked: &Path) -> Result<Self> {
        let path = beside(real, JOURNAL);
        Ok(Self {
            journal: Some(Journal::open(path.clone(), asked)?),
            path,
            partial: beside(real, PARTIAL),
        })
    }

    /// Ends it with the file under its name: what an earlier run left of it is of no more use.
    pub(in crate::report) fn done(mut self) {
        let _ = fs::remove_file(&self.partial);
        self.remove();
    }

    fn remove(&mut self) {
        if let Some(journal) = self.journal.take() {
            journal.remove();
        }
    }
}

impl Drop for Turn {
    fn drop(&mut self) {
        // One that is not empty is of a run that can be taken up again.
        if fs::metadata(&self.path).is_ok_and(|found| found.len() == 0) {
            self.remove();
        }
    }
}
