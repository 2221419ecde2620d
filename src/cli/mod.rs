//! Commands: parse, call, print, exit code.

mod accuracy;
mod args;
mod arguments;
mod auto;
mod bench;
mod check;
mod converge;
mod demo;
mod devices;
mod environment;
mod estimate;
mod exhaustive;
mod extreme;
mod format;
mod generate;
mod guide;
mod headers;
mod host;
mod integrands;
mod interrupt;
mod maps;
mod mask;
mod measure;
mod merge;
mod modules;
mod pixels;
mod plot;
mod points;
mod progress;
mod scene;
mod store;
mod strip;
mod vectors;
mod verify;
mod windows;

use args::{Cli, Command};
use clap::Parser;
use std::process::ExitCode;

/// Exit code for errors that are not this crate's: failed while running.
const FAILED: u8 = 4;

/// Runs the command of the arguments.
pub fn main() -> ExitCode {
    // clap prints usage errors and exits with 2, help and version with 0.
    let cli = Cli::parse();
    interrupt::install();
    let result = match &cli.command {
        Command::Devices(args) => devices::run(args),
        Command::Generate(args) => generate::run(args),
        Command::Merge(args) => merge::run(args),
        Command::Verify(args) => verify::run(args),
        Command::Maps(args) => maps::run(args),
        Command::Integrands(args) => integrands::run(args),
        Command::Estimate(args) => estimate::run(args),
        Command::Converge(args) => converge::run(args),
        Command::Check(args) => check::run(args),
        Command::Measure(args) => measure::run(args),
        Command::Headers(args) => headers::run(args),
        Command::Modules(args) => modules::run(args),
        Command::Demo(args) => demo::run(args),
        Command::Bench(args) => bench::run(args),
        Command::Accuracy(args) => accuracy::run(args),
        Command::Plot(args) => plot::run(args),
        Command::Scene(args) => scene::run(args),
        Command::Strip(args) => strip::run(args),
        Command::Vectors(args) => vectors::run(args),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("corput: {error}");
            let code = error
                .downcast_ref::<corput::Error>()
                .map_or(FAILED, corput::Error::exit_code);
            ExitCode::from(code)
        }
    }
}

/// Prints a line on standard output; a closed pipe ends the command quietly with 4.
pub fn print(text: &str) {
    use std::io::Write;
    if writeln!(std::io::stdout(), "{text}").is_err() {
        std::process::exit(FAILED.into());
    }
}
