//! The cells of all shards of a study.

use super::description::{difference, restore};
use super::file::{Head, files};
use crate::catalog::Shard;
use crate::converge::item::{Item, Measured, items};
use crate::converge::kept::text;
use crate::converge::line::Line;
use crate::converge::results::{Results, Setting};
use crate::converge::study::Study;
use crate::{Error, Result};
use serde_json::Value;
use std::collections::{HashMap, HashSet};
use std::fs::File;
use std::path::{Path, PathBuf};

const REMEDY: &str =
    "give the folder of `corput converge --report DIR --shard I/N`, and the cells of one study";

/// What shards of one study kept in a folder.
pub struct Gathered {
    folder: PathBuf,
    study: Study,
    /// Shards of which there are files; if several numbers of them were tried, the largest.
    shards: u64,
    /// Of the shards whose cells are taken.
    commands: Vec<String>,
    /// In the order of the study's items, with their names.
    cells: Vec<(String, Option<Measured>)>,
}

/// A cell that no shard has measured yet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lacking {
    /// Integrand, estimator where there is a choice, and sampler.
    pub cell: String,
    /// The shard that measures it.
    pub shard: Shard,
}

/// Files that were read, and lines that name what they measured.
#[derive(Default)]
struct Lines {
    /// Their paths, and the commands that made them.
    files: Vec<(PathBuf, String)>,
    /// By key, in the order of files and lines: the file's number, and the line.
    by_key: HashMap<String, Vec<(usize, Line)>>,
    /// Keys of the study's items.
    asked: HashSet<String>,
    /// Numbers of the files of which a line was taken.
    taken: HashSet<usize>,
}

impl Gathered {
    /// Whether a folder has files of shards.
    #[must_use]
    pub fn is_in(folder: &Path) -> bool {
        files(folder).is_ok_and(|found| !found.is_empty())
    }

    /// Reads the files of all shards in a folder. A cell that several have is that of the first,
    /// by how many shards there are, and by their numbers; its errors are the same in all.
    ///
    /// # Errors
    /// [`Error::Document`] for a folder without such files, and for cells of another study, or of
    /// another program or version alone; [`Error::Arguments`] for a study that this version does
    /// not know.
    pub fn open(folder: &Path) -> Result<Self> {
        let refused = |path: &Path, problem: String| Error::Document {
            path: path.to_owned(),
            problem,
            remedy: REMEDY,
        };
        let found = files(folder).map_err(|error| refused(folder, error.to_string()))?;
        let shards = found.last().map_or(1, |(shard, _)| shard.parts().1);
        let mut first: Option<(PathBuf, Value)> = None;
        let mut lines = Lines::default();
        for (_, path) in found {
            let file = File::open(&path).map_err(|error| refused(&path, error.to_string()));
            let text = text(file?).map_err(|problem| refused(&path, problem))?;
            // One that is just being begun has none.
            let Some(head) = Head::of(&text) else {
                continue;
            };
            let head = head.map_err(|problem| refused(&path, problem))?;
            let (begun, study) = first.get_or_insert_with(|| (path.clone(), head.study.clone()));
            if let Some(difference) = difference(study, &head.study) {
                let of = begun.display();
                let problem = format!("it has cells of another study than {of}: {difference}");
                return Err(refused(&path, problem));
            }
            lines.add(path, head.command, &text);
        }
        let Some((_, study)) = first else {
            return Err(refused(folder, "no shard has kept a cell in it".into()));
        };
        let study = restore(&study)?;
        let mut cells = Vec::new();
        for item in items(&study)? {
            cells.push((item.name(), lines.take(&item)?));
        }
        if let Some(path) = lines.foreign() {
            let problem = "it has a cell that is none of its study's".to_owned();
            return Err(refused(path, problem));
        }
        Ok(Self {
            folder: folder.to_owned(),
            study,
            shards,
            commands: lines.commands(),
            cells,
        })
    }

    /// Cells that there must be.
    #[must_use]
    pub fn total(&self) -> usize {
        self.cells.len()
    }

    /// Cells that are not there, in the study's order, and the shards that measure them: of as many
    /// shards as their files say, or of `shards`.
    ///
    /// # Errors
    /// [`Error::Arguments`] for no shards.
    pub fn lacking(&self, shards: Option<u64>) -> Result<Vec<Lacking>> {
        let shards = shards.unwrap_or(self.shards);
        let missing = (0..)
            .zip(&self.cells)
            .filter(|(_, (_, cell))| cell.is_none());
        missing
            .map(|(number, (name, _))| {
                Ok(Lacking {
                    cell: name.clone(),
                    shard: Shard::dealing(number, shards)?,
                })
            })
            .collect()
    }

    /// The results, as one run has them; times are those of each shard. Shards of which no cell is
    /// taken are not counted. `command` is what made them of the shards'.
    ///
    /// # Errors
    /// [`Error::Unmeasured`] where cells are not there.
    pub fn results(self, command: &str) -> Result<Results> {
        let total = self.cells.len();
        let cells = self.cells.into_iter().filter_map(|(_, cell)| cell);
        let cells: Vec<Measured> = cells.collect();
        if cells.len() < total {
            return Err(Error::Unmeasured {
                path: self.folder,
                lacking: total - cells.len(),
                total,
            });
        }
        let mut devices: Vec<&str> = Vec::new();
        for cell in &cells {
            if !devices.contains(&cell.device.as_str()) {
                devices.push(&cell.device);
            }
        }
        let mut commands = self.commands;
        let shards = commands.len() as u64;
        commands.push(command.to_owned());
        let setting = Setting {
            shards,
            ..Setting::new(&self.study, devices.join("; "), commands.join("\n"))
        };
        Ok(Results::of(&self.study, setting, cells))
    }
}

impl Lines {
    /// The first file with a line that no item asked for.
    fn foreign(&self) -> Option<&Path> {
        let others = self
            .by_key
            .iter()
            .filter(|(key, _)| !self.asked.contains(*key));
        let file = others.flat_map(|(_, lines)| lines).map(|(file, _)| *file);
        Some(&self.files[file.min()?].0)
    }

    /// The commands of the files of which lines were taken, in their order.
    fn commands(self) -> Vec<String> {
        let files = self.files.into_iter().enumerate();
        let taken = files.filter(|(file, _)| self.taken.contains(file));
        taken.map(|(_, (_, command))| command).collect()
    }

    /// All lines of a file that are complete.
    fn add(&mut self, path: PathBuf, command: String, text: &str) {
        let file = self.files.len();
        self.files.push((path, command));
        for line in text.lines().filter_map(Line::read) {
            let same = self.by_key.entry(line.key.clone()).or_default();
            same.push((file, line));
        }
    }

    /// The first line of an item that this version measured. Items of two names for one
    /// integrand have the same.
    fn take(&mut self, item: &Item) -> Result<Option<Measured>> {
        let key = item.key(None);
        let lines = self.by_key.get(&key).map_or(&[][..], Vec::as_slice);
        self.asked.insert(key);
        let programs = [true, false].map(|cpu| item.program(cpu));
        let [cpu, other] = programs;
        let programs = [cpu?, other?];
        let mut foreign = None;
        for (file, line) in lines {
            if !programs.contains(&line.program) {
                foreign = Some((*file, &line.program));
            } else if item.fits(&line.cell) {
                self.taken.insert(*file);
                return Ok(Some(Measured {
                    device: line.device.clone().unwrap_or_default(),
                    cell: line.cell.clone(),
                    anew: false,
                }));
            }
        }
        match foreign {
            None => Ok(None),
            Some((file, program)) => Err(Error::Document {
                path: self.files[file].0.clone(),
                problem: format!(
                    "`{}` was measured by program {program}, and this is {}",
                    item.name(),
                    programs[0]
                ),
                remedy: "merge with the version of corput that measured it, or run its shard again with this one",
            }),
        }
    }
}
