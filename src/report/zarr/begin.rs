//! How a store begins: its folder and `zarr.json`, by whoever comes first.

use std::fs;
use std::num::NonZero;
use std::path::Path;

use serde_json::Value;

use super::{Store, aside, metadata};
use crate::error::{Error, Result};
use crate::report::{Layout, create_folder};

impl Store {
    /// Makes the folder and its `zarr.json`, or finds them there as they are to be. `origin` is
    /// whatever makes the array; it becomes the attribute `corput`.
    ///
    /// # Errors
    ///
    /// [`Error::Output`] for a file of that name, or a folder that holds something else;
    /// [`Error::Document`] for a store of another array, which is named; [`Error::Arguments`]
    /// for an impossible layout; [`Error::Io`] if it cannot be written.
    pub fn create(path: &Path, layout: Layout, origin: &Value) -> Result<Self> {
        Self::begin(path, layout, origin, None)
    }

    /// The same for work that is cut into so many shards. Whoever makes `zarr.json` notes the number
    /// in it, for [`Store::shards`]. It is no part of the array: those of another number may go on
    /// with a store, and leave what is noted.
    ///
    /// # Errors
    ///
    /// As [`Store::create`].
    pub fn create_in_shards(
        path: &Path,
        layout: Layout,
        origin: &Value,
        shards: NonZero<u64>,
    ) -> Result<Self> {
        Self::begin(path, layout, origin, Some(shards.get()))
    }

    fn begin(path: &Path, layout: Layout, origin: &Value, shards: Option<u64>) -> Result<Self> {
        layout.words()?;
        let store = Self::new(path, layout, origin.clone());
        let wanted = metadata::document(&layout, origin);
        let name = path.join("zarr.json");
        let found = match metadata::read(&name)? {
            Some(found) => Some(found),
            None => {
                refuse_others(path)?;
                create_folder(&store.records(), "--out")?;
                let noted = metadata::noted(wanted.clone(), shards);
                aside::save_first(&store.records(), &name, &metadata::text(&noted))?;
                // Another process may have been first.
                metadata::read(&name)?
            }
        };
        let found = found.unwrap_or_default();
        match metadata::difference(&wanted, &found) {
            None => {
                create_folder(&store.records(), "--out")?;
                Ok(Self {
                    shards: metadata::shards(&found),
                    ..store
                })
            }
            Some(difference) => Err(Error::Document {
                path: name,
                problem: format!("the store is of another array: {difference}"),
                remedy: match found["attributes"]["corput"]["version"] == origin["version"] {
                    true => {
                        "give the arguments that it was begun with, or another folder with --out"
                    }
                    false => {
                        "fill it with the version of corput that it was begun with, or begin another folder \
                         with --out"
                    }
                },
            }),
        }
    }
}

/// Refuses a path at which a store would lie among other things.
fn refuse_others(path: &Path) -> Result<()> {
    let refused = |problem: String, remedy: &str| Error::Output {
        path: path.to_owned(),
        problem,
        remedy: remedy.to_owned(),
    };
    match fs::metadata(path) {
        Ok(found) if !found.is_dir() => {
            return Err(refused(
                "it is there, and no folder, which a Zarr store is".to_owned(),
                "give another name with --out",
            ));
        }
        Ok(_) => {}
        Err(_) => return Ok(()),
    }
    let entries = fs::read_dir(path).map_err(|error| {
        refused(
            format!("it cannot be read ({error})"),
            "give another folder with --out",
        )
    })?;
    let other = entries
        .flatten()
        .map(|entry| entry.file_name())
        // Another process may have begun the same store a moment ago.
        .find(|name| name != "corput" && name != "zarr.json");
    match other {
        None => Ok(()),
        Some(name) => Err(refused(
            format!(
                "it holds `{}`, and has no zarr.json",
                name.to_string_lossy()
            ),
            "give a folder that is not there yet, or is empty",
        )),
    }
}
