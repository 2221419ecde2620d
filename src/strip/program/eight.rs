//! Kernels that store eight words at a time.
//!
//! llvmpipe stores lane by lane, so that fewer and wider stores are faster there.

use super::beside::{self, Beside, Run};
use super::literal::indented;
use super::{Form, Program, text};
use crate::Result;
use crate::scene::{Draw, Needs, Record};
use crate::variant::{STORED_RUN, longest_run};
use std::fmt::Write;

/// The samples of such a kernel.
pub(super) struct Eight {
    run: Run,
    columns: Vec<Beside>,
}

impl Eight {
    /// Those of a scene; `None` where it draws more than numbers in [0, 1), or more of them than
    /// are worth it, or by a sampler of long coordinates.
    pub(super) fn of(record: &Record, needs: &Needs) -> Option<Self> {
        if record.words > WORDS {
            return None;
        }
        let columns = || needs.request.columns.iter();
        let run = Run {
            points: if columns().any(beside::is_odometer) {
                columns().map(longest_run).fold(STORED_RUN, u32::min)
            } else {
                match record.words {
                    1 => 32,
                    2 | 3 | 5 | 7 => 16,
                    _ => 8,
                }
            },
            // As many as whole stores hold.
            turn: WORDS >> record.words.trailing_zeros().min(3),
        };
        let mut draws = needs.domains.iter().map(|domain| &domain.draw);
        if !draws.all(|draw| matches!(draw, Draw::Between([0.0, 1.0]))) {
            return None;
        }
        let columns = (0..)
            .zip(columns())
            .map(|(number, column)| beside::code(column, number, run, needs.request.count));
        Some(Self {
            run,
            columns: columns.collect::<Option<_>>()?,
        })
    }

    /// Makes them those of the program.
    pub(super) fn write(&self, program: &mut Program, needs: &Needs) -> Result<()> {
        program.form = Form::Eight;
        program.run = self.run.points;
        program.aligned = match self.columns.iter().any(|column| column.aligned) {
            true => self.run.points,
            false => 1,
        };
        let columns = || self.columns.iter();
        let includes = columns().flat_map(|column| column.includes).copied();
        let units: Vec<&str> = columns().map(|column| column.unit.as_str()).collect();
        let coordinates: String = columns().map(|column| column.globals.as_str()).collect();
        let mut text =
            text::declarations(program, needs, includes.collect(), &units, &coordinates)?;
        text += &text::invocation(program);
        text += &indented(&self.body(program, needs), 4);
        text += "}\n";
        program.source = text;
        Ok(())
    }

    /// What follows the index of the first sample.
    fn body(&self, program: &Program, needs: &Needs) -> String {
        let Run { points, turn } = self.run;
        let stores = turn * program.record.words / WORDS;
        let mut text: String = self.columns.iter().map(|one| one.start.as_str()).collect();
        // Many turns are no gain in many copies.
        let loop_hint = if points > FEW {
            "dont_unroll"
        } else {
            "unroll"
        };
        // Writing to a String cannot fail.
        let _ = write!(
            text,
            "uint at = i * {}u;\n[[{loop_hint}]] for (uint k = 0u; k < {points}u; k += {turn}u) {{\n{}\
             \x20   at += {stores}u;\n}}\n",
            points / turn * stores,
            indented(&self.turn(program, needs, stores), 4)
        );
        text
    }

    /// The statements of a turn.
    fn turn(&self, program: &Program, needs: &Needs, stores: u32) -> String {
        let mut text: String = self.columns.iter().map(|one| one.turn.as_str()).collect();
        let word = |word: u32| {
            let (point, word) = (word / program.record.words, word % program.record.words);
            let mut domains = needs.domains.iter().zip(&program.record.fields);
            let (domain, field) = domains.find(|(_, field)| field.first == word)?;
            let fractions = &self.columns.get(domain.first as usize)?.fractions;
            let fraction = fractions.get(point as usize)?;
            Some(format!("draw_{}({fraction})", field.name))
        };
        let words: Vec<String> = (0..stores * WORDS).filter_map(word).collect();
        for (store, words) in words.chunks(WORDS as usize).enumerate() {
            let pairs = words
                .chunks(2)
                .map(|pair| format!("    packUint2x32(uvec2({}))", pair.join(", ")));
            let pairs: Vec<String> = pairs.collect();
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "samples[at + {store}u] = u64vec4(\n{});",
                pairs.join(",\n")
            );
        }
        text
    }
}

/// Points of an invocation that is made without a loop.
const FEW: u32 = 32;

/// Words of a store.
const WORDS: u32 = 8;
