//! What a module has, to compare a stripped one with the whole.

use std::collections::{HashMap, HashSet};

use ::spirv::Op;

use crate::spirv::{Module, Result, describe};

/// The size of a module and its parts.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Measure {
    /// Bytes of the module.
    pub bytes: usize,
    /// Instructions, all sections together.
    pub instructions: usize,
    /// Functions, the entry point among them.
    pub functions: usize,
    /// Constants, those of specialization not among them.
    pub constants: usize,
    /// Specialization constants, those that are computed of others not among them.
    pub specialization: usize,
    /// Buffers and other resources as (set, binding), ascending.
    pub resources: Vec<(u32, u32)>,
    /// Bytes of constant arrays, each counted once.
    pub table_bytes: u64,
}

/// Measures a module.
///
/// # Errors
/// The words are no module.
pub fn measure(words: &[u32]) -> Result<Measure> {
    let facts = describe(words)?;
    let module = Module::parse(words)?;
    let mut sizes = Sizes::default();
    let mut tables: Vec<(u32, u64)> = Vec::new();
    let mut parts: HashSet<u32> = HashSet::new();
    let mut constants = 0;
    for row in module.instructions() {
        sizes.add(row.op(), row.words);
        match (row.op(), row.words) {
            (Some(Op::ConstantComposite), [_, kind, id, of @ ..]) => {
                constants += 1;
                parts.extend(of);
                if sizes.arrays.contains(kind) {
                    tables.push((*id, sizes.bytes.get(kind).copied().unwrap_or(0)));
                }
            }
            (Some(Op::Constant | Op::ConstantTrue | Op::ConstantFalse | Op::ConstantNull), _) => {
                constants += 1;
            }
            (Some(Op::Function), _) => break,
            _ => {}
        }
    }
    // An array within another is counted with that.
    let whole = tables.iter().filter(|(id, _)| !parts.contains(id));
    Ok(Measure {
        bytes: facts.bytes,
        instructions: facts.instructions,
        functions: facts.functions.len(),
        constants,
        specialization: facts.spec_ids.len(),
        resources: facts.bindings,
        table_bytes: whole.map(|(_, bytes)| bytes).sum(),
    })
}

/// Bytes of the types that constants have.
#[derive(Default)]
struct Sizes {
    bytes: HashMap<u32, u64>,
    arrays: HashSet<u32>,
    numbers: HashMap<u32, u64>,
}

impl Sizes {
    fn add(&mut self, op: Option<Op>, words: &[u32]) {
        let size = |id: &u32| self.bytes.get(id).copied();
        let (id, bytes) = match (op, words) {
            (Some(Op::TypeBool), [_, id]) => (*id, Some(4)),
            (Some(Op::TypeInt | Op::TypeFloat), [_, id, bits, ..]) => {
                (*id, Some(u64::from(*bits / 8)))
            }
            (Some(Op::TypeVector | Op::TypeMatrix), [_, id, of, count]) => {
                (*id, size(of).map(|bytes| bytes * u64::from(*count)))
            }
            (Some(Op::TypeArray), [_, id, of, length]) => {
                let length = self.numbers.get(length);
                let bytes = size(of).zip(length);
                let bytes = bytes.and_then(|(bytes, length)| bytes.checked_mul(*length));
                self.arrays.insert(*id);
                (*id, bytes)
            }
            (Some(Op::TypeStruct), [_, id, members @ ..]) => {
                (*id, members.iter().map(size).sum::<Option<u64>>())
            }
            (Some(Op::Constant), [_, _, id, value]) => {
                self.numbers.insert(*id, u64::from(*value));
                return;
            }
            _ => return,
        };
        if let Some(bytes) = bytes {
            self.bytes.insert(id, bytes);
        }
    }
}
