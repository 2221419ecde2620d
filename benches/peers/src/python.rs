//! SciPy, NumPy and Torch, in a Python process that makes what it is asked for.

use crate::VALUES;
use crate::job::{Contender, Job, Kind, Maker, threads};
use std::cell::RefCell;
use std::error::Error;
use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::rc::Rc;

/// Packages that may take part, their libraries' names, and columns of the table.
const LIBRARIES: &[(&str, &str, &str)] = &[
    ("scipy", "SciPy", "SciPy, NumPy"),
    ("numpy", "NumPy", "SciPy, NumPy"),
    ("torch", "Torch", "Torch"),
];

/// The process, and the packages that it has, with their versions.
pub struct Server {
    child: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    packages: Vec<(String, String)>,
}

pub type Shared = Rc<RefCell<Server>>;

impl Server {
    /// Starts `python3`, or what `PYTHON` names; nothing where it has none of the libraries.
    pub fn start() -> Option<Shared> {
        let program = std::env::var("PYTHON").unwrap_or_else(|_| "python3".into());
        let script = concat!(env!("CARGO_MANIFEST_DIR"), "/serve.py");
        let mut child = Command::new(program)
            .arg(script)
            .arg(threads().to_string())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .ok()?;
        let input = child.stdin.take()?;
        let output = BufReader::new(child.stdout.take()?);
        let mut server = Self {
            child,
            input,
            output,
            packages: Vec::new(),
        };
        let line = server.answer().ok()?;
        let packages = line.split_whitespace().filter_map(|word| {
            let (package, version) = word.split_once('-')?;
            Some((package.to_owned(), version.to_owned()))
        });
        server.packages = packages.collect();
        (!server.packages.is_empty()).then(|| Rc::new(RefCell::new(server)))
    }

    fn answer(&mut self) -> std::io::Result<String> {
        let mut line = String::new();
        self.output.read_line(&mut line)?;
        Ok(line.trim().to_owned())
    }

    fn ask(&mut self, question: &str) -> Result<f64, Box<dyn Error>> {
        writeln!(self.input, "{question}")?;
        self.input.flush()?;
        let line = self.answer()?;
        line.parse()
            .map_err(|_| format!("python: {question}: {line}").into())
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The version of a package, where the process has it.
fn version(server: Option<&Shared>, package: &str) -> Option<String> {
    let server = server?.borrow();
    let mut packages = server.packages.iter();
    let (_, version) = packages.find(|(name, _)| name == package)?;
    Some(version.clone())
}

/// Which libraries take part, and which do not.
pub fn line(server: Option<&Shared>) -> String {
    let of = |(package, name, _): &(&str, &str, &str)| match version(server, package) {
        Some(version) => format!("{name} {version}"),
        None => format!("no {name}"),
    };
    let all: Vec<String> = LIBRARIES.iter().map(of).collect();
    format!("Python: {}", all.join(", "))
}

/// The libraries that do not take part.
pub fn missing(server: Option<&Shared>) -> Vec<&'static str> {
    let all = LIBRARIES.iter();
    let missing = all.filter(|(package, ..)| version(server, package).is_none());
    missing.map(|(_, name, _)| *name).collect()
}

struct Asked {
    server: Shared,
    question: String,
}

impl Contender for Asked {
    fn make(&mut self, _: &mut [f32]) -> Result<f64, Box<dyn Error>> {
        self.server.borrow_mut().ask(&self.question)
    }

    /// The process checks its own values: their range, and their mean.
    fn is_in_memory(&self) -> bool {
        false
    }
}

/// Those that make it.
pub fn of(job: &Job, server: Option<&Shared>) -> Vec<Maker> {
    let Some(server) = server else {
        return Vec::new();
    };
    let makers: &[(&str, &str, &str)] = match job.kind {
        Kind::Halton => &[("scipy", "halton", "(f64)")],
        Kind::Sobol => &[("scipy", "sobol", "(f64)"), ("torch", "sobol", "")],
        Kind::SobolScrambled => &[
            ("scipy", "sobol-scrambled", "(f64, linear matrix)"),
            ("torch", "sobol-scrambled", "(linear matrix)"),
        ],
        Kind::Random => &[("numpy", "random", "(f32)"), ("torch", "random", "")],
    };
    let mut found = Vec::new();
    for &(package, name, column) in LIBRARIES {
        let Some(version) = version(Some(server), package) else {
            continue;
        };
        for (_, what, note) in makers.iter().filter(|(its, ..)| *its == package) {
            let rows = VALUES / job.dimensions;
            let asked = Asked {
                server: Rc::clone(server),
                question: format!("{package} {what} {} {rows}", job.dimensions),
            };
            found.push(Maker {
                library: format!("{name} {version}"),
                note: (*note).to_owned(),
                column: column.to_owned(),
                label: String::new(),
                contender: Box::new(asked),
            });
        }
    }
    found
}
