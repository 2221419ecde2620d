//! The one error type of the crate.
//!
//! Every message says what was asked, what the limit is and what to do.
//! [`Error::exit_code`] is the contract of the command line:
//! 1 a check failed, 2 refused before work began, 3 no adequate device,
//! 4 failed while running.

mod exit_code;
mod names;
mod remedy;
mod text;

pub use names::nearest;
pub use remedy::INSTALL_HINT;

use names::list;
use remedy::{io_remedy, vulkan_remedy};
use std::path::PathBuf;
use text::dimensions;

/// `Result` with this crate's [`Error`].
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Everything that can go wrong, by what the caller can do about it.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A count of zero points.
    #[error("{what} is 0; the least is 1: ask for at least one point")]
    ZeroCount {
        /// The argument that was zero.
        what: &'static str,
    },
    /// Indices past the end of a sequence.
    #[error("{}", text::index_range(*first, *count))]
    IndexRange {
        /// First index asked for.
        first: u64,
        /// Number of points asked for.
        count: u64,
    },
    /// A radical-inverse base that is no prime.
    #[error("base {base} is not prime; Halton's bases are distinct primes: use {nearest}")]
    NotPrime {
        /// The base as given.
        base: u64,
        /// The nearest prime.
        nearest: u64,
    },
    /// A prime base above the largest of the table.
    #[error(
        "base {base} is above {limit}, the largest prime that this build supports; choose a smaller one"
    )]
    BaseTooLarge {
        /// The base as given.
        base: u64,
        /// The largest supported base.
        limit: u32,
    },
    /// The same base twice.
    #[error(
        "base {base} is given twice, so two dimensions would be equal; Halton's bases are distinct primes: drop one"
    )]
    RepeatedBase {
        /// The repeated base.
        base: u32,
    },
    /// More dimensions than a sequence has, or fewer.
    #[error("{sequence} was asked for {}; it has {}: {remedy}", dimensions(*asked), text::range(*least, *limit))]
    Dimensions {
        /// The sequence's name.
        sequence: &'static str,
        /// Dimensions asked for.
        asked: u64,
        /// The fewest it can give.
        least: u32,
        /// The most it can give.
        limit: u32,
        /// What to do instead.
        remedy: String,
    },
    /// A map that needs another number of dimensions.
    #[error("map {map} takes {} per point; {}: use --dims {needed}", dimensions(u64::from(*needed)), text::given(*given))]
    MapDimensions {
        /// The map's name.
        map: &'static str,
        /// Dimensions that it takes.
        needed: u32,
        /// Dimensions that it got.
        given: u32,
    },
    /// A parameter of a map that is missing or outside its domain.
    #[error("map {map}: {name} {problem}; {domain}")]
    Parameter {
        /// The map's name.
        map: &'static str,
        /// The parameter's.
        name: String,
        /// What is wrong with it.
        problem: String,
        /// What it may be.
        domain: String,
    },
    /// Two arguments that exclude each other, or one that lacks another.
    #[error("{asked}: {limit}; {remedy}")]
    Arguments {
        /// What was asked.
        asked: String,
        /// Why it cannot be.
        limit: String,
        /// What to do.
        remedy: String,
    },
    /// A name that is not in a list.
    #[error("unknown {kind} `{name}`{}; known: {known}{}", nearest.as_ref().map_or(String::new(), |n| format!(", did you mean `{n}`?")), list(kind))]
    UnknownName {
        /// What kind of name: sequence, map, format.
        kind: &'static str,
        /// The name as given.
        name: String,
        /// The most similar known name, if any is similar.
        nearest: Option<String>,
        /// Every known name.
        known: String,
    },
    /// An output that cannot be made.
    #[error("cannot write {}: {problem}; {remedy}", path.display())]
    Output {
        /// The file asked for.
        path: PathBuf,
        /// Why it cannot be written.
        problem: String,
        /// What to do.
        remedy: String,
    },
    /// An image that cannot be read or used.
    #[error("cannot use image {}: {problem}; {remedy}", path.display())]
    Image {
        /// The image's file.
        path: PathBuf,
        /// What is wrong with it.
        problem: String,
        /// What to do.
        remedy: String,
    },
    /// A file of points that cannot be read or used.
    #[error("cannot use points {}: {problem}; {remedy}", path.display())]
    Points {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        problem: String,
        /// What to do.
        remedy: String,
    },
    /// A document that cannot be read or used.
    #[error("cannot use {}: {problem}; {remedy}", path.display())]
    Document {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        problem: String,
        /// What to do.
        remedy: &'static str,
    },
    /// A study file that cannot be read or used.
    #[error("cannot use study {}: {problem}; {remedy}", path.display())]
    Study {
        /// The file.
        path: PathBuf,
        /// What is wrong with it, and where.
        problem: String,
        /// What to do.
        remedy: String,
    },
    /// A scene that cannot be read or used.
    #[error("cannot use scene {}: {problem}; {remedy}", path.display())]
    Scene {
        /// The file.
        path: PathBuf,
        /// What is wrong with it, and where.
        problem: String,
        /// What to do.
        remedy: String,
    },
    /// No Vulkan device at all.
    #[error("no Vulkan device was found ({reason}); {INSTALL_HINT}")]
    NoDevice {
        /// What the loader said.
        reason: String,
    },
    /// A device that is not among those present.
    #[error(
        "unknown device `{asked}`; present: {present}; give an index or a part of a name, or `cpu`"
    )]
    UnknownDevice {
        /// What was asked for.
        asked: String,
        /// The devices that are there.
        present: String,
    },
    /// A device that lacks what the job needs.
    #[error("device {device} is not adequate: {problem}; {remedy}")]
    InadequateDevice {
        /// The device's name.
        device: String,
        /// What it lacks.
        problem: String,
        /// What to do.
        remedy: String,
    },
    /// A Vulkan call that failed.
    #[error("{call} failed: {result}; {}", vulkan_remedy(result))]
    Vulkan {
        /// The call, by its name in the specification.
        call: &'static str,
        /// The result code's name.
        result: String,
    },
    /// A wait that took longer than any dispatch may.
    #[error(
        "{call} did not end within {seconds} s; the device hangs or is shared: try again, or use `--device cpu`"
    )]
    Timeout {
        /// The call that waited.
        call: &'static str,
        /// The bound.
        seconds: f64,
    },
    /// A file operation that failed while running.
    #[error("cannot {action} {}: {source}; {}", path.display(), io_remedy(source.kind()))]
    Io {
        /// What was tried.
        action: &'static str,
        /// The file.
        path: PathBuf,
        /// The cause.
        source: std::io::Error,
    },
    /// Stopped by a signal.
    #[error(
        "interrupted after {done} of {total}; nothing was left under the final name: run again"
    )]
    Interrupted {
        /// Points finished.
        done: u64,
        /// Points asked for.
        total: u64,
    },
    /// Stopped by a signal, with what was finished in a file.
    #[error("interrupted after {done} of {total}, which {} keeps: {} goes on from there", path.display(), text::again(*fresh))]
    Paused {
        /// Parts finished.
        done: u64,
        /// Parts in all.
        total: u64,
        /// The file.
        path: PathBuf,
        /// Whether the command began by removing what it kept.
        fresh: bool,
    },
    /// Stopped by a signal, and nothing is kept of what was finished.
    #[error(
        "interrupted after {done} of {total}, of which nothing is kept: give {option} to keep what is done, \
         and to go on from there"
    )]
    NotKept {
        /// Parts finished.
        done: u64,
        /// Parts in all.
        total: u64,
        /// What keeps them.
        option: &'static str,
    },
    /// A file that was not finished, of which some stays.
    #[error(
        "{}; {kept} of {total} rows stay in {}: the same command with --resume goes on from there",
        cause.text_before_more(),
        path.display()
    )]
    Kept {
        /// What ended the run.
        cause: Box<Error>,
        /// Rows in complete chunks.
        kept: u64,
        /// Rows in all.
        total: u64,
        /// The partial file.
        path: PathBuf,
    },
    /// A file that is not what its arguments make.
    #[error("{} differs: {problem}; make it again, or fetch it again", path.display())]
    Differs {
        /// The file.
        path: PathBuf,
        /// What differs first, and how many rows do.
        problem: String,
    },
    /// Means of a study that are infinite or NaN.
    #[error(
        "{failures} of {total} means are not finite, the first of {first}: the integrand has an infinite or \
         undefined term there, or the device computes one; the table marks them, and no other number counts them"
    )]
    NotFinite {
        /// Means that are not finite.
        failures: u64,
        /// Means in all.
        total: u64,
        /// Sampler, integrand and number of points.
        first: String,
    },
    /// Results that are not what they must be.
    #[error(
        "{failures} of {total} checks failed; the table names them: do not trust this device for those functions, and report the table"
    )]
    CheckFailed {
        /// Checks that failed.
        failures: usize,
        /// Checks that ran.
        total: usize,
    },
    /// A sum of a study that is not the CPU's, or not what it was before.
    #[error(
        "{what}: two sums of the same points differ, so that no time is worth anything: run `corput check --only estimate`"
    )]
    Unequal {
        /// Integrand, sampler and number of points.
        what: String,
    },
    /// A store of which chunks are missing or damaged.
    #[error(
        "store {}: {lacking} of {total} chunks are missing or not what they were; run the shards that make them again, \
         with the arguments of the first time",
        path.display()
    )]
    Incomplete {
        /// The store's folder.
        path: PathBuf,
        /// Chunks that it lacks.
        lacking: u64,
        /// Chunks that it must have.
        total: u64,
    },
    /// A study of which shards have not measured all cells.
    #[error(
        "study in {}: {lacking} of {total} cells are missing; run the shards that measure them, with the arguments of \
         the first time",
        path.display()
    )]
    Unmeasured {
        /// The folder.
        path: PathBuf,
        /// Cells that it lacks.
        lacking: usize,
        /// Cells that it must have.
        total: usize,
    },
    /// Report cards that differ.
    #[error(
        "{differ} exact rows differ, and {missing} are in one card alone: two drivers with the same version of corput and the same options have the same hashes"
    )]
    CardsDiffer {
        /// Rows that both have, with other hashes.
        differ: usize,
        /// Rows that one has.
        missing: usize,
    },
    /// Jobs that take longer than before.
    #[error(
        "{jobs} of {total} jobs are slower than the baseline by more than noise explains; the table names them"
    )]
    Slower {
        /// Jobs that are slower.
        jobs: usize,
        /// Jobs measured.
        total: usize,
    },
    /// GLSL that cannot be taken apart.
    #[error("{file}, line {line}: {problem}; {remedy}")]
    Glsl {
        /// The include name; `main` for the shader itself.
        file: String,
        /// The line, from 1.
        line: usize,
        /// What is not understood there.
        problem: String,
        /// What to do.
        remedy: String,
    },
    /// A shader that does not compile or breaks the rules of its tier.
    #[error("shader {shader}: {problem}")]
    Shader {
        /// The shader's name.
        shader: String,
        /// The compiler's or linter's words.
        problem: String,
    },
}
