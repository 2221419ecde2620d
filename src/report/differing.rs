//! Rows of an array that are not as they must be.

use super::{Element, Layout};
use crate::error::{Error, Result};
use std::ops::Range;
use std::path::Path;

/// Which rows differ: how many, and what is to be said of the first.
pub(super) struct Differing {
    element: Element,
    columns: u64,
    rows: u64,
    last: Option<u64>,
    first: Option<String>,
}

impl Differing {
    pub(super) fn new(layout: &Layout) -> Self {
        Self {
            element: layout.element,
            columns: u64::from(layout.columns),
            rows: 0,
            last: None,
            first: None,
        }
    }

    /// Rows that differ.
    pub(super) fn rows(&self) -> u64 {
        self.rows
    }

    /// What is to be said of the first.
    pub(super) fn first(&self) -> Option<&str> {
        self.first.as_deref()
    }

    /// Notes a row, of which there may be more to note. Rows come in order.
    pub(super) fn note(&mut self, row: u64, say: impl FnOnce() -> String) {
        self.first.get_or_insert_with(say);
        if self.last != Some(row) {
            self.last = Some(row);
            self.rows += 1;
        }
    }

    /// Compares elements of binary data, the first of which is the array's element `at`. What
    /// was not found is not equal.
    pub(super) fn compare(&mut self, at: u64, found: &[u8], wanted: &[u8]) {
        if found == wanted {
            return;
        }
        let (element, columns) = (self.element, self.columns);
        let size = element.bytes() as usize;
        let mut found = found.chunks_exact(size);
        for (index, wanted) in (at..).zip(wanted.chunks_exact(size)) {
            let found = found.next();
            if found != Some(wanted) {
                let (row, column) = (index / columns, index % columns);
                self.note(row, || {
                    let is = found.map_or("missing".into(), |found| element.show(found));
                    let must = element.show(wanted);
                    format!("row {row}, column {column} is {is} and must be {must}")
                });
            }
        }
    }
}

/// Refuses rows that an array has not, and none at all.
pub(super) fn check_range(path: &Path, layout: &Layout, rows: &Range<u64>) -> Result<()> {
    if rows.start < rows.end && rows.end <= layout.rows {
        return Ok(());
    }
    Err(Error::Arguments {
        asked: format!("rows {}..{} of {}", rows.start, rows.end, path.display()),
        limit: format!(
            "it has the rows 0..{}, and a range has one at least",
            layout.rows
        ),
        remedy: "ask for A..B with A below B, which is not part of it".into(),
    })
}

/// Refuses to end a comparison elsewhere than at the end of its rows.
pub(super) fn check_end(at: u64, end: u64) -> Result<()> {
    if at == end {
        return Ok(());
    }
    Err(Error::Arguments {
        asked: format!("a comparison that ends at word {at}"),
        limit: format!("the rows end at word {end}"),
        remedy: "give exactly the words of the rows".into(),
    })
}
