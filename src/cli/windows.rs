//! Points that a device writes into the output file itself, as `CORPUT_WINDOWS` says.

use super::interrupt;
use corput::kernels::Generator;
use corput::report::Sink;
use corput::{Error, Result};
use indicatif::ProgressBar;

const VARIABLE: &str = "CORPUT_WINDOWS";

/// What the variable says of windows of the file.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Wish {
    /// Where they can be had: on disks they save time, though in memory (tmpfs) pages cost more to
    /// map than words to copy.
    Any,
    /// Never: what the device makes is copied to the file.
    Off,
    /// What stands in their way is an error.
    Require,
}

impl Wish {
    fn of_environment() -> Result<Self> {
        let value = std::env::var_os(VARIABLE).unwrap_or_default();
        match value.to_str() {
            Some("") => Ok(Self::Any),
            Some("off") => Ok(Self::Off),
            Some("require") => Ok(Self::Require),
            _ => Err(Error::Arguments {
                asked: format!("{VARIABLE}={}", value.to_string_lossy()),
                limit: "it is `off` or `require`, or not set".into(),
                remedy: "unset it: windows of the file are used where they can be had".into(),
            }),
        }
    }
}

/// Makes points by windows, until there are all or a window is refused; the rest is for others.
pub fn fill(generator: &mut Generator, sink: &mut Sink, bar: &ProgressBar) -> Result<()> {
    let wish = Wish::of_environment()?;
    if wish == Wish::Off {
        return Ok(());
    }
    let (rows, begun) = (sink.layout().rows, sink.rows());
    let refusal = generator.write_windows(sink, &mut |points| {
        interrupt::stop(bar.position(), rows)?;
        bar.inc(points);
        Ok(())
    })?;
    match refusal {
        Some(refusal) if wish == Wish::Require => Err(refusal),
        // What is wrong with a device, if it is more than that, the copy will say.
        Some(refusal) if sink.rows() > begun => {
            eprintln!(
                "corput: warning: from row {} on the file is copied to: {refusal}",
                sink.rows()
            );
            Ok(())
        }
        _ => Ok(()),
    }
}
