//! SciPy and Torch, in a Python process that makes what it is asked for.

use crate::VALUES;
use crate::job::{Contender, Job, Kind};
use std::cell::RefCell;
use std::error::Error;
use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::rc::Rc;

/// The process, and the libraries that it has.
pub struct Server {
    child: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    libraries: Vec<String>,
}

impl Server {
    /// Starts `python3`, or what `PYTHON` names; nothing where it has none of the libraries.
    pub fn start() -> Option<Rc<RefCell<Self>>> {
        let program = std::env::var("PYTHON").unwrap_or_else(|_| "python3".into());
        let script = concat!(env!("CARGO_MANIFEST_DIR"), "/serve.py");
        let mut child = Command::new(program)
            .arg(script)
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
            libraries: Vec::new(),
        };
        let line = server.answer().ok()?;
        server.libraries = line.split_whitespace().map(str::to_owned).collect();
        (!server.libraries.is_empty()).then(|| Rc::new(RefCell::new(server)))
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

/// What it has.
pub fn line(server: Option<&Rc<RefCell<Server>>>) -> String {
    match server {
        Some(server) => server.borrow().libraries.join(", "),
        None => {
            "python3 has neither scipy nor torch: `pip install scipy torch`, or set PYTHON".into()
        }
    }
}

struct Asked {
    server: Rc<RefCell<Server>>,
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
pub fn of(job: &Job, server: Option<&Rc<RefCell<Server>>>) -> Vec<(String, Box<dyn Contender>)> {
    let Some(server) = server else {
        return Vec::new();
    };
    let makers: &[(&str, &str, &str)] = match job.kind {
        Kind::Halton => &[("scipy", "halton", "(f64, 2 workers)")],
        Kind::Sobol => &[("scipy", "sobol", "(f64)"), ("torch", "sobol", "")],
        Kind::SobolScrambled => &[
            ("scipy", "sobol-scrambled", "(f64, linear matrix)"),
            ("torch", "sobol-scrambled", "(linear matrix)"),
        ],
        Kind::Random => &[("numpy", "random", "(f32)"), ("torch", "random", "")],
    };
    let libraries = server.borrow().libraries.clone();
    let mut found: Vec<(String, Box<dyn Contender>)> = Vec::new();
    for (library, what, note) in makers {
        let start = format!("{library}-");
        let Some(version) = libraries.iter().find(|name| name.starts_with(&start)) else {
            continue;
        };
        let rows = VALUES / job.dimensions;
        let question = format!("{library} {what} {} {rows}", job.dimensions);
        let asked = Asked {
            server: Rc::clone(server),
            question,
        };
        let name = format!("{} {note}", version.replacen('-', " ", 1));
        found.push((name.trim().to_owned(), Box::new(asked)));
    }
    found
}
