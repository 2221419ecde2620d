//! The command line of `corput`.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::main()
}
