//! Finished cells in a file, so that a study that was cut off goes on from there.
//!
//! A line of JSON a cell, under a key that names what was measured, and the program that
//! measured it; lines of other keys are left alone, and cells of other programs are measured
//! anew. A line that was cut off while it was written is no line.

use super::cell::Cell;
use super::line::Line;
use super::study::{Row, Study};
use crate::catalog::Sampler;
use crate::report::{bounded_bytes, hexadecimal, save};
use crate::{Error, Result};
use serde_json::json;
use sha2::{Digest, Sha256};
use std::collections::HashSet;
use std::fs::{File, OpenOptions};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

/// Bytes of a file at most: those of cells by the thousand.
const MOST: u64 = 1 << 30;

/// The file, open for more.
pub struct Kept {
    path: PathBuf,
    file: File,
    /// The device of what is added, where keys name none.
    device: Option<String>,
    lines: Vec<Line>,
    /// Keys of this run.
    used: HashSet<String>,
    outdated: u64,
}

impl Kept {
    /// Opens the file, or makes it.
    ///
    /// # Errors
    /// [`Error::Output`] where it cannot be read or written, or has more than 2^30 bytes.
    pub fn open(path: &Path) -> Result<Self> {
        let opened = OpenOptions::new()
            .read(true)
            .append(true)
            .create(true)
            .open(path);
        let mut file = opened.map_err(|error| unusable(path, &error))?;
        let text = text(&mut file).map_err(|problem| unread(path, problem))?;
        Self::of(path, file, &text, None)
    }

    /// A file that is open at its end for more, and what it holds; of cells that any device may
    /// measure where a device is given, which is that of what is added.
    pub(super) fn of(
        path: &Path,
        mut file: File,
        text: &str,
        device: Option<String>,
    ) -> Result<Self> {
        if !text.is_empty() && !text.ends_with('\n') {
            let ended = file.write_all(b"\n");
            ended.map_err(|error| unusable(path, &error))?;
        }
        Ok(Self {
            path: path.to_owned(),
            file,
            device,
            lines: text.lines().filter_map(Line::read).collect(),
            used: HashSet::new(),
            outdated: 0,
        })
    }

    /// The device that keys name, of a run on this one.
    pub(super) fn keyed_by<'d>(&self, device: &'d str) -> Option<&'d str> {
        self.device.is_none().then_some(device)
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The cell of this key, if this program measured it ([`Engine::program`]).
    ///
    /// [`Engine::program`]: super::Engine::program
    pub fn get(&mut self, key: &str, program: &str) -> Option<Cell> {
        self.line(key, program, |_| true)
            .map(|line| line.cell.clone())
    }

    /// The same as its line: the first whose cell fits.
    pub(super) fn line(
        &mut self,
        key: &str,
        program: &str,
        fits: impl Fn(&Cell) -> bool,
    ) -> Option<&Line> {
        self.used.insert(key.to_owned());
        let known = self.lines.iter().any(|line| line.key == key);
        let mut own = self
            .lines
            .iter()
            .filter(|line| line.key == key && line.program == program)
            .peekable();
        self.outdated += u64::from(known && own.peek().is_none());
        own.find(|line| fits(&line.cell))
    }

    /// How many cells were asked for that only other programs had measured.
    #[must_use]
    pub fn outdated(&self) -> u64 {
        self.outdated
    }

    /// Adds a finished cell.
    ///
    /// # Errors
    /// [`Error::Io`] where it cannot be written.
    pub fn add(&mut self, key: &str, program: &str, cell: &Cell) -> Result<()> {
        let line = Line {
            key: key.to_owned(),
            program: program.to_owned(),
            device: self.device.clone(),
            cell: cell.clone(),
        };
        self.file
            .write_all(line.text().as_bytes())
            .map_err(|source| Error::Io {
                action: "write",
                path: self.path.clone(),
                source,
            })?;
        self.used.insert(line.key.clone());
        self.lines.push(line);
        Ok(())
    }

    /// Removes the cells that this run asked for or added, since its study is complete, and the
    /// file where no other study's are left.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn remove(self) -> Result<()> {
        let others = self
            .lines
            .iter()
            .filter(|line| !self.used.contains(&line.key));
        let rest: String = others.map(Line::text).collect();
        if !rest.is_empty() {
            return save(&self.path, rest.as_bytes());
        }
        std::fs::remove_file(&self.path).map_err(|source| Error::Io {
            action: "remove",
            path: self.path,
            source,
        })
    }
}

/// What such a file holds from where it is, or why it cannot be read. What was cut off may be no
/// text.
pub(super) fn text(file: impl Read) -> Result<String, String> {
    let bytes = bounded_bytes(file, MOST)?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The error of a file to be gone on with, which may hold hours of work.
pub(super) fn unread(path: &Path, problem: String) -> Error {
    Error::Output {
        path: path.to_owned(),
        problem,
        remedy: "move it elsewhere, or choose another folder".into(),
    }
}

pub(super) fn unusable(path: &Path, error: &std::io::Error) -> Error {
    Error::Output {
        path: path.to_owned(),
        problem: error.to_string(),
        remedy: "choose a folder that can be written".into(),
    }
}

/// What a cell measures, as a hash: what is summed, and by whom. `device` names the device and
/// its driver; none where any may measure it.
#[must_use]
pub fn key(study: &Study, row: &Row, sampler: Sampler, device: Option<&str>) -> String {
    let mut hash = Sha256::new();
    let settings = json!({
        "device": device,
        "integrand": row.problem.integrand().name,
        "dimensions": row.problem.dimensions(),
        "values": row.problem.values(),
        "estimator": row.problem.estimator(),
        "sampler": sampler.name(),
        "counts": study.counts(),
        "replicates": study.replicates(),
        "seed": study.seed(),
    });
    hash.update(settings.to_string());
    // What a map holds is in none of the numbers.
    hash.update(bytemuck::cast_slice::<u32, u8>(row.problem.tables()));
    hexadecimal(&hash.finalize())
}

#[cfg(test)]
mod tests {
    use super::super::cell::Point;
    use super::*;

    fn cell(mean: f64) -> Cell {
        Cell {
            setup_ms: 1.25,
            first_ms: 0.1,
            points: vec![Point {
                count: 16,
                means: vec![mean, 1.0 / 3.0],
                variances: vec![f64::INFINITY, 1.0 / 7.0],
                device_ns: vec![1234.5],
                host_ns: vec![0.1 + 0.2],
            }],
            refused: vec![(1 << 22, "too \"many\"".into())],
            warnings: vec!["careful".into()],
        }
    }

    #[test]
    fn cells_come_back_and_a_torn_line_does_not() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cells.jsonl");
        let mut kept = Kept::open(&path).unwrap();
        kept.add("a", "1", &cell(0.1)).unwrap();
        kept.add("b", "1", &cell(f64::NAN)).unwrap();
        let whole = std::fs::read_to_string(&path).unwrap();
        std::fs::write(&path, &whole[..whole.len() - 9]).unwrap();

        let mut again = Kept::open(&path).unwrap();
        assert_eq!(again.get("a", "1"), Some(cell(0.1)));
        assert_eq!(again.get("b", "1"), None);
        again.add("b", "1", &cell(f64::NAN)).unwrap();
        let mut third = Kept::open(&path).unwrap();
        assert!(third.get("b", "1").unwrap().points[0].means[0].is_nan());
        assert_eq!(third.get("a", "1"), Some(cell(0.1)));
        assert_eq!(again.outdated() + third.outdated(), 0);
        third.remove().unwrap();
        assert!(!path.exists());
    }

    #[test]
    fn cells_of_another_study_stay() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cells.jsonl");
        let mut kept = Kept::open(&path).unwrap();
        kept.add("a", "1", &cell(0.1)).unwrap();
        kept.add("b", "1", &cell(0.2)).unwrap();
        let mut other = Kept::open(&path).unwrap();
        assert!(other.get("a", "1").is_some() && other.get("c", "1").is_none());
        other.remove().unwrap();
        let mut left = Kept::open(&path).unwrap();
        assert_eq!(left.get("a", "1"), None);
        assert_eq!(left.get("b", "1"), Some(cell(0.2)));
        left.remove().unwrap();
        assert!(!path.exists());
    }

    #[test]
    fn a_cell_that_does_not_fit_hides_none_that_does() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cells.jsonl");
        let mut kept = Kept::open(&path).unwrap();
        kept.add("a", "1", &cell(0.1)).unwrap();
        kept.add("a", "1", &cell(0.2)).unwrap();
        let mean = |cell: &Cell| cell.points[0].means[0];
        let mut found = |wanted: f64| {
            Some(mean(
                &kept.line("a", "1", |cell| mean(cell) == wanted)?.cell,
            ))
        };
        assert_eq!(found(0.2), Some(0.2));
        assert_eq!(found(0.3), None);
        assert_eq!(kept.outdated(), 0);
    }

    #[test]
    fn cells_of_another_program_are_not_taken() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cells.jsonl");
        let mut kept = Kept::open(&path).unwrap();
        kept.add("a", "1", &cell(0.1)).unwrap();
        assert_eq!(kept.get("a", "2"), None);
        assert_eq!(kept.outdated(), 1);
        kept.add("a", "2", &cell(0.2)).unwrap();
        let mut again = Kept::open(&path).unwrap();
        assert_eq!(again.get("a", "2"), Some(cell(0.2)));
        assert_eq!(again.get("a", "1"), Some(cell(0.1)));
        assert_eq!(again.get("b", "1"), None);
        assert_eq!(again.outdated(), 0);
    }
}
