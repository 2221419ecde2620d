//! The kernel of one scene: what it draws, and nothing else.
//!
//! A record of words per sample, one after the other in a buffer, each the words of every
//! domain ([`Record`]). All that the scene says is in the text: coordinates of its sampler with
//! direction numbers and digits, parameters of its maps, weights of its choices. What is
//! looked up, environments and choices among many, is in a buffer each.

mod beside;
mod choice;
mod columns;
#[cfg(feature = "gpu")]
mod device;
mod eight;
mod interface;
mod literal;
mod maps;
mod net;
mod prepared;
mod radical;
mod text;

#[cfg(feature = "gpu")]
pub use device::Sampler;

use super::flat::Flat;
use super::flatten;
use crate::catalog::{Group, Mapping, Profile};
use crate::scene::{Choice, Draw, Needs, Record};
use crate::variant::{STORED_RUN, longest_run};
use crate::{Error, Result};

pub use crate::scene::GROUP;

/// The most dimensions of a kernel: its cursor has some words of each.
pub const MOST_DIMENSIONS: u32 = 1024;

/// Where a kernel has its two parameters, `first` and `count`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Parameters {
    /// In push constants.
    #[default]
    Push,
    /// In a uniform block of 16 bytes, after the other bindings: for languages and engines
    /// without push constants.
    Uniform,
}

/// How to write a kernel. Results are the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Where the parameters are.
    pub parameters: Parameters,
    /// Long runs of samples per invocation, as CPU drivers like them, in place of four, which
    /// leave writes of a GPU's lanes side by side.
    pub cpu: bool,
    /// With `cpu`, for devices that have integers of 64 bits (`shaderInt64`): [`Form::Eight`],
    /// where a scene can have it.
    pub int64: bool,
}

/// How a kernel stores records.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Word by word.
    Words,
    /// Four records at a time, in elements of `uvec4`.
    Four,
    /// Eight words at a time, in elements of `u64vec4`: of up to eight bare numbers in [0, 1) by a
    /// sampler whose coordinates take few instructions a point.
    Eight,
}

/// A buffer of words that the kernel only reads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    /// Its binding in set 0.
    pub binding: u32,
    /// The name of the array.
    pub name: String,
    /// The key of the domain that draws by it.
    pub key: String,
    /// What the buffer holds.
    pub words: Vec<u32>,
}

/// The kernel of a scene.
#[derive(Clone, Debug)]
pub struct Program {
    /// The scene's name.
    pub name: String,
    /// GLSL with includes.
    pub source: String,
    /// What a record consists of.
    pub record: Record,
    /// Samples of an invocation.
    pub run: u32,
    /// How they are stored.
    pub form: Form,
    /// The first index of a dispatch is a multiple of this.
    pub aligned: u32,
    /// Tables, by binding.
    pub tables: Vec<Table>,
    /// Where the parameters are.
    pub parameters: Parameters,
    /// Whose functions the maps use.
    pub profile: Profile,
    /// How many samples there will ever be: greater indices are not the sampler's.
    pub samples: u64,
}

/// Tables beside the samples: Vulkan guarantees four storage buffers.
const MOST_TABLES: usize = 3;

/// The binding of the samples.
const SAMPLES: u32 = 0;

/// Words of a record of which four are made in a row.
const WIDE_WORDS: u32 = 12;

/// Samples of an invocation where each is long, and where lanes are to write side by side.
const SHORT_RUN: u32 = 4;

/// Words of a table that every device's buffers hold: 2^25.
const TABLE_WORDS: usize = crate::interface::TABLE_WORDS;

/// The kernel of a scene of that name.
///
/// # Errors
/// [`Error::Arguments`] for numbers that floats cannot tell apart, for more than one
/// environment, for an environment of more than 2^25 words, for more than [`MOST_DIMENSIONS`],
/// and for more buffers than every device has.
pub fn program(name: &str, needs: &Needs, options: Options) -> Result<Program> {
    if needs.dimensions() > MOST_DIMENSIONS {
        return Err(refused(
            format!("a kernel of {} dimensions", needs.dimensions()),
            "it has at most 1024",
            "use `generate`, or the headers in a loop over dimensions",
        ));
    }
    let record = Record::of(needs);
    let profile = needs.request.profile;
    let samples = needs.request.count;
    let mut short = record.words <= WIDE_WORDS;
    let mut tables: Vec<Table> = Vec::new();
    for (domain, field) in needs.domains.iter().zip(&record.fields) {
        let table = match &domain.draw {
            Draw::Between(_) => None,
            Draw::Choice(weights) => {
                let words = Choice::new(weights)?.words();
                (!words.is_empty()).then(|| (format!("choice_{}", field.name), words))
            }
            Draw::Map(mapping) => {
                short &= maps::code(mapping, profile).short;
                environment(mapping)?.map(|words| (text::ENVIRONMENT.to_owned(), words))
            }
        };
        let Some((name, words)) = table else {
            continue;
        };
        if tables.iter().any(|one| one.name == name) {
            return Err(refused(
                "two environments".to_owned(),
                "a kernel draws by one",
                "leave one out",
            ));
        }
        short = false;
        tables.push(Table {
            binding: SAMPLES + 1 + tables.len() as u32,
            name,
            key: domain.key.clone(),
            words,
        });
    }
    if tables.len() > MOST_TABLES {
        let keys: Vec<&str> = tables.iter().map(|table| table.key.as_str()).collect();
        return Err(refused(
            format!("tables for {}", keys.join(", ")),
            "a kernel has three besides its samples, as every Vulkan device has four buffers",
            "choose among fewer: choices among up to 16 need no table",
        ));
    }
    let columns = &needs.request.columns;
    let run = if options.cpu && short {
        // Loops of four columns stay within what llvmpipe lets an invocation do.
        let longest = columns.iter().map(longest_run).fold(STORED_RUN, u32::min);
        (longest / (columns.len() as u32).div_ceil(4) / 4 * 4).max(SHORT_RUN)
    } else {
        SHORT_RUN
    };
    let mut program = Program {
        name: name.to_owned(),
        source: String::new(),
        record,
        run,
        form: if short { Form::Four } else { Form::Words },
        aligned: 1,
        tables,
        parameters: options.parameters,
        profile,
        samples,
    };
    let eight = (options.cpu && options.int64).then(|| eight::Eight::of(&program.record, needs));
    match eight.flatten() {
        Some(eight) => eight.write(&mut program, needs)?,
        None => program.source = text::source(&program, needs)?,
    }
    Ok(program)
}

/// The words of an environment, of a map that draws by one.
fn environment(mapping: &Mapping) -> Result<Option<Vec<u32>>> {
    if mapping.map().group != Group::Environment {
        return Ok(None);
    }
    let words: Vec<u32> = mapping.tables().concat();
    if words.len() > TABLE_WORDS {
        return Err(refused(
            format!("an environment of {} words", words.len()),
            "a buffer of 2^25 words is what every device has",
            "scale the picture down",
        ));
    }
    Ok(Some(words))
}

fn refused(asked: String, limit: &str, remedy: &str) -> Error {
    Error::Arguments {
        asked,
        limit: limit.to_owned(),
        remedy: remedy.to_owned(),
    }
}

impl Program {
    /// One file of what the kernel reaches. `portable` does without carries and extended
    /// products, which some languages lack.
    ///
    /// # Errors
    /// None that can be met: the source is this crate's.
    pub fn flat(&self, portable: bool) -> Result<Flat> {
        let defines: &[(&str, Option<&str>)] = match portable {
            true => &[("CORPUT_PORTABLE", None)],
            false => &[],
        };
        let headers = crate::headers();
        let mut lookup = |name: &str| {
            let found = headers.iter().find(|(known, _)| *known == name);
            found.map(|(_, text)| (*text).to_owned())
        };
        flatten(&self.source, defines, &mut lookup)
    }

    /// Bytes that a buffer of so many samples has.
    #[must_use]
    pub fn sample_bytes(&self, count: u64) -> u64 {
        4 * u64::from(self.record.words) * count.next_multiple_of(self.multiple().into())
    }

    /// The buffer of samples holds a multiple of so many.
    #[must_use]
    pub fn multiple(&self) -> u32 {
        match self.form {
            Form::Words => 1,
            Form::Four => 4,
            Form::Eight => self.run,
        }
    }

    /// Workgroups for so many samples.
    #[must_use]
    pub fn groups(&self, count: u64) -> u64 {
        count
            .div_ceil(u64::from(self.run))
            .div_ceil(u64::from(GROUP))
    }

    /// The binding of the parameters, where they are in a uniform block.
    #[must_use]
    pub fn parameter_binding(&self) -> Option<u32> {
        let binding = SAMPLES + 1 + self.tables.len() as u32;
        (self.parameters == Parameters::Uniform).then_some(binding)
    }

    /// All bindings, ascending.
    #[must_use]
    pub fn bindings(&self) -> Vec<u32> {
        let tables = self.tables.iter().map(|table| table.binding);
        std::iter::once(SAMPLES)
            .chain(tables)
            .chain(self.parameter_binding())
            .collect()
    }
}
