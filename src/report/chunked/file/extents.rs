//! Extents of the file, for whoever writes words in place.

use super::super::allocate::{allocate, keeps_space};
use super::super::extent::{Extent, extent_from};
use super::super::pipeline::Role;
use super::{Chunked, failed};
use crate::error::Result;
use std::sync::Arc;

impl Chunked {
    /// Reserves the extent that begins with a row, if the file has one there.
    pub(in crate::report) fn extent(&self, row: u64) -> Result<Option<Extent>> {
        let Some((offset, bytes, rows)) = extent_from(&self.encoder, self.rows, row) else {
            return Ok(None);
        };
        if !keeps_space(&self.file) {
            return Ok(None);
        }
        let reserved = allocate(&self.file, offset, bytes);
        let reserved = reserved.map_err(|source| failed("write", &self.asked, source))?;
        Ok(reserved.then(|| Extent {
            file: Arc::clone(&self.file),
            offset,
            bytes,
            rows,
        }))
    }

    /// Whether it is one of this file.
    pub(in crate::report) fn is_own(&self, extent: &Extent) -> bool {
        Arc::ptr_eq(&self.file, &extent.file)
    }

    /// Takes the words that are in an extent.
    pub(in crate::report) fn take(&mut self, extent: &Extent) -> Result<()> {
        if !self.piece.is_empty() {
            self.send(Role::Inside)?;
        }
        let role = match extent.rows.end {
            end if end == self.encoder.layout.rows => Role::Last,
            end if end.is_multiple_of(self.rows) => Role::End,
            _ => Role::Inside,
        };
        let pipeline = self.pipeline.as_mut();
        match pipeline.and_then(|one| one.send_there(extent.bytes, role)) {
            Some(()) => Ok(()),
            None => self.stop().and(Err(self.died())),
        }
    }
}
