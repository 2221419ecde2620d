//! Files that are written under another name and come to theirs whole.
//!
//! Of what processes of several machines write at once each has a file of its own, and whoever
//! renames last has the name.

use super::place::{failed, sync_folder};
use crate::error::Result;
use std::collections::hash_map::RandomState;
use std::fs::{self, File, OpenOptions};
use std::hash::{BuildHasher, Hasher};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// How the names of such files end.
pub(super) const ENDING: &str = ".partial";

/// A file without its name yet. Dropped before it has that, it is removed.
pub(super) struct Aside {
    pub(super) file: File,
    partial: PathBuf,
    /// The final name, symbolic links resolved.
    real: PathBuf,
    /// The final name as the user gave it.
    asked: PathBuf,
    committed: bool,
}

impl Aside {
    /// Creates the file as `partial`, which no other process writes; what a killed one has left
    /// there is replaced.
    pub(super) fn create(partial: PathBuf, asked: &Path, real: PathBuf) -> io::Result<Self> {
        let file = File::create(&partial)?;
        Ok(Self::new(file, partial, asked, real))
    }

    /// Creates the file in `folder`, under a name that no other process has: numbers of processes
    /// repeat between machines.
    pub(super) fn create_in(folder: &Path, asked: &Path, real: PathBuf) -> io::Result<Self> {
        loop {
            let random = RandomState::new().build_hasher().finish();
            let partial = folder.join(format!(".{random:016x}{ENDING}"));
            let opened = OpenOptions::new()
                .write(true)
                .create_new(true)
                .open(&partial);
            match opened {
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                opened => return opened.map(|file| Self::new(file, partial, asked, real)),
            }
        }
    }

    fn new(file: File, partial: PathBuf, asked: &Path, real: PathBuf) -> Self {
        Self {
            file,
            partial,
            real,
            asked: asked.to_owned(),
            committed: false,
        }
    }

    /// The final name, symbolic links resolved.
    pub(super) fn real(&self) -> &Path {
        &self.real
    }

    /// Writes all bytes, and waits until they are on the disk.
    pub(super) fn fill(&mut self, bytes: &[u8]) -> Result<()> {
        let written = self.file.write_all(bytes);
        written.map_err(|source| failed("write", &self.asked, source))?;
        let synced = self.file.sync_all();
        synced.map_err(|source| failed("sync", &self.asked, source))
    }

    /// Gives the file its final name; call [`Aside::fill`] before.
    pub(super) fn commit(mut self) -> Result<()> {
        self.rename()?;
        self.last()
    }

    /// The same, where [`Aside::last`] is still to be called, once for each folder.
    pub(super) fn rename(&mut self) -> Result<()> {
        self.named(fs::rename(&self.partial, &self.real))?;
        self.committed = true;
        Ok(())
    }

    /// The same where a file of that name that is there must stay.
    pub(super) fn commit_first(mut self) -> Result<()> {
        match fs::hard_link(&self.partial, &self.real) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => Ok(()),
            // Not every file system has links. There whoever comes last has the name.
            Err(_) => self.commit(),
            Ok(()) => {
                self.committed = true;
                // It has two names, of which one is to stay.
                let _ = fs::remove_file(&self.partial);
                self.last()
            }
        }
    }

    fn named(&self, done: io::Result<()>) -> Result<()> {
        done.map_err(|source| failed("rename the finished file to", &self.asked, source))
    }

    /// Makes the name last, and with it all that were given before in its folder.
    pub(super) fn last(&self) -> Result<()> {
        let synced = sync_folder(&self.real);
        synced.map_err(|source| failed("sync the folder of", &self.asked, source))
    }
}

impl Drop for Aside {
    fn drop(&mut self) {
        if !self.committed {
            // Nothing more can be done about a file that will not go.
            let _ = fs::remove_file(&self.partial);
        }
    }
}
