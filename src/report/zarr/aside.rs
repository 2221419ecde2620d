//! Small files and chunks of a store, which come to their names whole.
//!
//! Processes of several machines may write the same file at once: each has a file of its own
//! aside, and whoever renames last has written the same bytes.

use std::collections::hash_map::RandomState;
use std::fs::{self, File, OpenOptions};
use std::hash::{BuildHasher, Hasher};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::error::Result;
use crate::report::place::{failed, sync_folder};

/// How names of files end that have not come to theirs.
const ENDING: &str = ".partial";

/// A file without its name yet, which goes when this is dropped.
struct Partial(PathBuf);

impl Drop for Partial {
    fn drop(&mut self) {
        // After a rename there is none; about one that will not go nothing can be done.
        let _ = fs::remove_file(&self.0);
    }
}

/// Writes a file aside, in `folder`, waits until it is on the disk, and gives it its name.
pub(super) fn save(folder: &Path, path: &Path, bytes: &[u8]) -> Result<()> {
    let partial = write(folder, path, bytes)?;
    fs::rename(&partial.0, path)
        .and_then(|()| sync_folder(path))
        .map_err(|error| failed("rename the finished file to", path, error))
}

/// The same where a file of that name that is there must stay.
pub(super) fn save_first(folder: &Path, path: &Path, bytes: &[u8]) -> Result<()> {
    let partial = write(folder, path, bytes)?;
    let named = match fs::hard_link(&partial.0, path) {
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => return Ok(()),
        // Not every file system has links. There whoever comes last has the name.
        Err(_) => fs::rename(&partial.0, path),
        done => done,
    };
    named
        .and_then(|()| sync_folder(path))
        .map_err(|error| failed("rename the finished file to", path, error))
}

/// Removes what killed processes have left.
pub(super) fn sweep(folder: &Path) -> Result<()> {
    let entries = fs::read_dir(folder).map_err(|error| failed("read", folder, error))?;
    for entry in entries.flatten() {
        if entry.file_name().to_string_lossy().ends_with(ENDING) {
            drop(Partial(entry.path()));
        }
    }
    Ok(())
}

fn write(folder: &Path, path: &Path, bytes: &[u8]) -> Result<Partial> {
    let (partial, mut file) = create(folder).map_err(|error| failed("create", path, error))?;
    file.write_all(bytes)
        .and_then(|()| file.sync_all())
        .map_err(|error| failed("write", path, error))?;
    Ok(partial)
}

/// Creates a file of a name that no other process has: numbers of processes repeat between
/// machines.
fn create(folder: &Path) -> io::Result<(Partial, File)> {
    loop {
        let random = RandomState::new().build_hasher().finish();
        let path = folder.join(format!(".{random:016x}{ENDING}"));
        let opened = OpenOptions::new().write(true).create_new(true).open(&path);
        match opened {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            opened => return opened.map(|file| (Partial(path), file)),
        }
    }
}
