//! The arguments.

use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;

/// Low-discrepancy points and importance-sampled directions, bit-identical on every
/// conformant Vulkan driver and on the CPU.
#[derive(Debug, Parser)]
#[command(version, about, after_help = EXIT_CODES)]
pub struct Cli {
    #[command(subcommand)]
    pub command: Command,
}

const EXIT_CODES: &str = "Exit codes: 0 done; 1 a check failed; 2 refused before work began; \
3 no device present, or none adequate; 4 failed while running.\n\
Environment: CORPUT_DEVICE chooses the device as --device does; CORPUT_VALIDATION=1 runs with \
the Khronos validation layer, whose messages then fail the command.";

#[derive(Debug, Subcommand)]
pub enum Command {
    /// List the Vulkan devices, their limits and what a probe of their floats finds.
    Devices(DevicesArgs),
    /// Make points, or samples of a map over them, and write them to a file.
    Generate(Box<GenerateArgs>),
    /// Compare every kernel and function with the CPU reference on a device.
    Check(CheckArgs),
    /// Write the GLSL headers as files.
    Headers(HeadersArgs),
    /// Make points and directions, check all of them, and light a real map.
    Demo(DemoArgs),
    /// Measure speed, verified first, as a ratio to a fill of the same bytes.
    Bench(BenchArgs),
}

#[derive(Debug, Args)]
pub struct DevicesArgs {
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct GenerateArgs {
    /// vdc, halton, hammersley, blue-noise or blue-noise-mask.
    pub sequence: String,
    /// Points to make: 1 to 2^32; of blue-noise to 65536.
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub count: Option<u64>,
    /// blue-noise-mask: pixels along a side, 4 to 256.
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub size: Option<u64>,
    /// blue-noise-mask: values of a pixel, 1 or 2 [default: 1].
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub channels: Option<u64>,
    /// blue-noise-mask: frames of a mask over time, 1 to 16; size x size x frames is at
    /// most 65536 [default: 1].
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub frames: Option<u64>,
    /// Index of the first point.
    #[arg(long, default_value = "0", value_parser = whole, allow_hyphen_values = true)]
    pub first: u64,
    /// Dimensions: the first primes [default: 2, for vdc 1].
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub dims: Option<u64>,
    /// Prime bases in place of the first primes, as 2,3,8161.
    #[arg(long, value_delimiter = ',', value_parser = whole, allow_hyphen_values = true)]
    pub bases: Option<Vec<u64>>,
    /// hammersley: N of k/N [default: first + count].
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub total: Option<u64>,
    /// hammersley: k/N as the first column instead of the last.
    #[arg(long)]
    pub index_first: bool,
    /// Seed of randomisations; vdc, halton and hammersley have none.
    #[arg(long, default_value = "0", value_parser = whole, allow_hyphen_values = true)]
    pub seed: u64,
    /// Write u32 fractions of 2^32 instead of f32.
    #[arg(long)]
    pub fractions: bool,
    /// Map each point: cosine-hemisphere, cosine-hemisphere-polar, uniform-hemisphere,
    /// concentric-disk or polar-disk. +z is the normal.
    #[arg(long)]
    pub map: Option<String>,
    /// Append the map's pdf as the last column.
    #[arg(long)]
    pub with_pdf: bool,
    /// exact: the same bytes everywhere; native: the device's own functions.
    #[arg(long, default_value = "exact")]
    pub profile: String,
    /// Device by index or part of its name, or cpu for the reference.
    #[arg(long)]
    pub device: Option<String>,
    /// npy, raw or csv; of blue-noise-mask npy, png or exr [default: from the file's ending; npy on standard output].
    #[arg(long)]
    pub format: Option<String>,
    /// The file; - is standard output.
    #[arg(long)]
    pub out: PathBuf,
}

#[derive(Debug, Args)]
pub struct CheckArgs {
    /// Device by index or part of its name.
    #[arg(long)]
    pub device: Option<String>,
    /// Only rows whose name, header or kernel contains this.
    #[arg(long)]
    pub only: Option<String>,
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct HeadersArgs {
    /// The folder, which is made if it is not there; the files lie in its folder corput.
    #[arg(long)]
    pub out: PathBuf,
}

#[derive(Debug, Args)]
pub struct DemoArgs {
    /// Device by index or part of its name.
    #[arg(long)]
    pub device: Option<String>,
    /// The environment map.
    #[arg(long, default_value = "tests/data/sunrise.exr")]
    pub env: PathBuf,
    /// Folder for the files, which is made if it is not there.
    #[arg(long, default_value = "target/demo")]
    pub out: PathBuf,
}

#[derive(Debug, Args)]
pub struct BenchArgs {
    /// Device by index or part of its name.
    #[arg(long)]
    pub device: Option<String>,
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
}

/// A whole number from 0 to 2^64 - 1, with a message that says so.
fn whole(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| {
        let limit = "it must be a whole number from 0 to 18446744073709551615";
        match text.parse::<f64>() {
            Ok(value) if value < 0.0 => format!("{text} is negative; {limit}"),
            _ if !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit()) => {
                format!("{text} is too large; {limit}")
            }
            _ => format!("`{text}` is no whole number; {limit}"),
        }
    })
}
