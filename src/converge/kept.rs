//! Finished cells in a file, so that a study that was cut off goes on from there.
//!
//! A line of JSON a cell, under a key that names what was measured, and the program that
//! measured it; lines of other keys are left alone, and cells of other programs are measured
//! anew. A line that was cut off while it was written is no line.

use super::cell::{Cell, Point};
use super::study::{Row, Study};
use crate::catalog::Sampler;
use crate::report::{hexadecimal, save};
use crate::{Error, Result};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use std::collections::HashSet;
use std::fs::{File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};

/// The file, open for more.
pub struct Kept {
    path: PathBuf,
    file: File,
    lines: Vec<Line>,
    /// Keys of this run.
    used: HashSet<String>,
    outdated: u64,
}

/// A cell with what names it.
struct Line {
    key: String,
    program: String,
    cell: Cell,
}

impl Kept {
    /// Opens the file, or makes it.
    ///
    /// # Errors
    /// [`Error::Output`] where it cannot be read or written.
    pub fn open(path: &Path) -> Result<Self> {
        let failed = |source: std::io::Error| Error::Output {
            path: path.to_owned(),
            problem: source.to_string(),
            remedy: "choose a folder that can be written".into(),
        };
        let text = match std::fs::read(path) {
            Ok(bytes) => String::from_utf8_lossy(&bytes).into_owned(),
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => String::new(),
            Err(error) => return Err(failed(error)),
        };
        let mut file = OpenOptions::new()
            .append(true)
            .create(true)
            .open(path)
            .map_err(failed)?;
        if !text.is_empty() && !text.ends_with('\n') {
            file.write_all(b"\n").map_err(failed)?;
        }
        Ok(Self {
            path: path.to_owned(),
            file,
            lines: text.lines().filter_map(read).collect(),
            used: HashSet::new(),
            outdated: 0,
        })
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
        self.used.insert(key.to_owned());
        let mut found = self.lines.iter().filter(|line| line.key == key).peekable();
        let known = found.peek().is_some();
        let cell = found.find(|line| line.program == program);
        self.outdated += u64::from(known && cell.is_none());
        cell.map(|line| line.cell.clone())
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

impl Line {
    fn text(&self) -> String {
        let value =
            json!({ "key": self.key, "program": self.program, "cell": document(&self.cell) });
        format!("{value}\n")
    }
}

/// What a cell measures, as a hash: what is summed, and by whom. `device` names the device and
/// its driver.
#[must_use]
pub fn key(study: &Study, row: &Row, sampler: Sampler, device: &str) -> String {
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

fn document(cell: &Cell) -> Value {
    let bits = |values: &[f64]| -> Vec<u64> { values.iter().map(|one| one.to_bits()).collect() };
    let point = |point: &Point| {
        json!({
            "count": point.count,
            // What is no number has no JSON.
            "means": bits(&point.means),
            "variances": bits(&point.variances),
            "device_ns": point.device_ns,
            "host_ns": point.host_ns,
        })
    };
    json!({
        "setup_ms": cell.setup_ms,
        "first_ms": cell.first_ms,
        "points": cell.points.iter().map(point).collect::<Vec<_>>(),
        "refused": cell.refused,
        "warnings": cell.warnings,
    })
}

fn read(line: &str) -> Option<Line> {
    let value: Value = serde_json::from_str(line).ok()?;
    let cell = value.get("cell")?;
    let numbers = |value: &Value| -> Option<Vec<f64>> {
        value.as_array()?.iter().map(Value::as_f64).collect()
    };
    let bits = |value: &Value| -> Option<Vec<f64>> {
        let words = value.as_array()?.iter().map(Value::as_u64);
        words.map(|word| word.map(f64::from_bits)).collect()
    };
    let point = |value: &Value| -> Option<Point> {
        Some(Point {
            count: value.get("count")?.as_u64()?,
            means: bits(value.get("means")?)?,
            variances: bits(value.get("variances")?)?,
            device_ns: numbers(value.get("device_ns")?)?,
            host_ns: numbers(value.get("host_ns")?)?,
        })
    };
    let points: Option<Vec<Point>> = cell.get("points")?.as_array()?.iter().map(point).collect();
    let refused = |value: &Value| -> Option<(u64, String)> {
        Some((value.get(0)?.as_u64()?, value.get(1)?.as_str()?.to_owned()))
    };
    let refusals: Option<Vec<_>> = cell
        .get("refused")?
        .as_array()?
        .iter()
        .map(refused)
        .collect();
    let warnings = cell.get("warnings")?.as_array()?.iter();
    let warnings: Option<Vec<String>> = warnings
        .map(|one| one.as_str().map(str::to_owned))
        .collect();
    let cell = Cell {
        setup_ms: cell.get("setup_ms")?.as_f64()?,
        first_ms: cell.get("first_ms")?.as_f64()?,
        points: points?,
        refused: refusals?,
        warnings: warnings?,
    };
    let text = |name: &str| Some(value.get(name)?.as_str()?.to_owned());
    Some(Line {
        key: text("key")?,
        program: text("program")?,
        cell,
    })
}

#[cfg(test)]
mod tests {
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
