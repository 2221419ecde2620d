//! A module's words as instructions, names and functions.

use std::collections::{HashMap, HashSet};
use std::ops::Range;

use ::spirv::{Decoration, GlslStd450Op, MAGIC_NUMBER, Op};

use super::{Error, Instruction, Result};

const HEADER: usize = 5;
pub(super) const GLSL_STD_450: &str = "GLSL.std.450";

/// A function and the instructions that lie in it.
#[derive(Clone, Debug)]
pub struct Function {
    /// Its result id.
    pub id: u32,
    /// Its name without the parameter types; none in a stripped module.
    pub name: Option<String>,
    /// Its instructions, `OpFunction` to `OpFunctionEnd`, in
    /// [`Module::instructions`].
    pub body: Range<usize>,
}

impl Function {
    /// Its name, or its id if it has none.
    #[must_use]
    pub fn label(&self) -> String {
        self.name.clone().unwrap_or_else(|| format!("%{}", self.id))
    }
}

/// An entry point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EntryPoint {
    /// Its function's id.
    pub function: u32,
    /// Its name for `vkCreateComputePipelines`.
    pub name: String,
}

/// One decoration of an id.
#[derive(Clone, Copy, Debug)]
pub struct Decorated<'a> {
    /// What is decorated.
    pub target: u32,
    /// The decoration, if this build knows it.
    pub decoration: Option<Decoration>,
    /// Its literals, such as the binding's number.
    pub literals: &'a [u32],
}

/// A module's words, split and indexed.
#[derive(Clone, Debug)]
pub struct Module<'a> {
    words: &'a [u32],
    instructions: Vec<Instruction<'a>>,
    names: HashMap<u32, String>,
    functions: Vec<Function>,
    entry_points: Vec<EntryPoint>,
    instruction_sets: HashMap<u32, String>,
    float_types: HashSet<u32>,
}

impl<'a> Module<'a> {
    /// Reads a module. Every cut-off module is an error, since its entry point
    /// or a function that is called would be missing.
    pub fn parse(words: &'a [u32]) -> Result<Self> {
        if words.len() < HEADER {
            return Err(Error::NoHeader { words: words.len() });
        }
        if words[0] != MAGIC_NUMBER {
            return Err(Error::Magic { found: words[0] });
        }
        let mut module = Self {
            words,
            instructions: split(words)?,
            names: HashMap::new(),
            functions: Vec::new(),
            entry_points: Vec::new(),
            instruction_sets: HashMap::new(),
            float_types: HashSet::new(),
        };
        for index in 0..module.instructions.len() {
            module.index_declaration(module.instructions[index])?;
        }
        module.functions = module.find_functions()?;
        module.check_references()?;
        Ok(module)
    }

    /// The words it was read from.
    #[must_use]
    pub fn words(&self) -> &'a [u32] {
        self.words
    }

    /// Every instruction, in order.
    #[must_use]
    pub fn instructions(&self) -> &[Instruction<'a>] {
        &self.instructions
    }

    /// Every function, in order.
    #[must_use]
    pub fn functions(&self) -> &[Function] {
        &self.functions
    }

    /// Every entry point, in order.
    #[must_use]
    pub fn entry_points(&self) -> &[EntryPoint] {
        &self.entry_points
    }

    /// The name of an id, as the compiler gave it.
    #[must_use]
    pub fn name(&self, id: u32) -> Option<&str> {
        self.names.get(&id).map(String::as_str)
    }

    /// Every `OpDecorate`, in order.
    pub fn decorations(&self) -> impl Iterator<Item = Decorated<'a>> {
        self.instructions
            .iter()
            .filter_map(|instruction| match instruction.words {
                [_, target, decoration, literals @ ..]
                    if instruction.op() == Some(Op::Decorate) =>
                {
                    Some(Decorated {
                        target: *target,
                        decoration: Decoration::from_u32(*decoration),
                        literals,
                    })
                }
                _ => None,
            })
    }

    /// The ids that carry a decoration.
    #[must_use]
    pub fn decorated(&self, decoration: Decoration) -> HashSet<u32> {
        self.decorations()
            .filter(|row| row.decoration == Some(decoration))
            .map(|row| row.target)
            .collect()
    }

    /// Whether an instruction of a function body has a result of a type made
    /// of floats of any width: scalar, vector, matrix, array or struct.
    /// (Where it has no result, word 1 is an id that is no type.)
    #[must_use]
    pub fn has_float_result(&self, instruction: &Instruction) -> bool {
        instruction
            .words
            .get(1)
            .is_some_and(|id| self.float_types.contains(id))
    }

    /// The set and the number of an extended instruction (`OpExtInst`).
    pub fn extended(&self, instruction: &Instruction) -> Result<(&str, u32)> {
        let id = instruction.operand(3)?;
        let set = self.instruction_sets.get(&id).ok_or(Error::UnknownSet {
            at: instruction.at,
            id,
        })?;
        Ok((set, instruction.operand(4)?))
    }

    /// The opcode's name as the policies write it: `FMul`, `GLSL.std.450 Sqrt`.
    pub fn opcode_name(&self, instruction: &Instruction) -> Result<String> {
        match instruction.op() {
            None => Ok(format!("opcode {}", instruction.opcode())),
            Some(Op::ExtInst) => {
                let (set, number) = self.extended(instruction)?;
                let name = GlslStd450Op::from_u32(number).filter(|_| set == GLSL_STD_450);
                Ok(name.map_or_else(
                    || format!("{set} {number}"),
                    |name| format!("{set} {name:?}"),
                ))
            }
            Some(op) => Ok(format!("{op:?}")),
        }
    }

    fn index_declaration(&mut self, instruction: Instruction<'a>) -> Result<()> {
        let is_float = |id: &u32| self.float_types.contains(id);
        match instruction.op() {
            Some(Op::Name) => {
                let text = instruction.text(2)?;
                self.names.entry(instruction.operand(1)?).or_insert(text);
            }
            Some(Op::EntryPoint) => {
                let (function, name) = (instruction.operand(2)?, instruction.text(3)?);
                self.entry_points.push(EntryPoint { function, name });
            }
            Some(Op::ExtInstImport) => {
                self.instruction_sets
                    .insert(instruction.operand(1)?, instruction.text(2)?);
            }
            Some(Op::Decorate) => {
                instruction.operand(2)?;
            }
            Some(Op::TypeFloat) => {
                self.float_types.insert(instruction.operand(1)?);
            }
            Some(Op::TypeVector | Op::TypeMatrix | Op::TypeArray | Op::TypeRuntimeArray)
                if is_float(&instruction.operand(2)?) =>
            {
                self.float_types.insert(instruction.operand(1)?);
            }
            Some(Op::TypeStruct) if instruction.operands_from(2).iter().any(is_float) => {
                self.float_types.insert(instruction.operand(1)?);
            }
            _ => {}
        }
        Ok(())
    }

    fn find_functions(&self) -> Result<Vec<Function>> {
        let mut functions = Vec::new();
        let mut open: Option<(usize, u32)> = None;
        for (index, instruction) in self.instructions.iter().enumerate() {
            match (instruction.op(), open) {
                (Some(Op::Function), None) => open = Some((index, instruction.operand(2)?)),
                (Some(Op::FunctionEnd), Some((first, id))) => {
                    let name = self
                        .name(id)
                        .and_then(|name| name.split('(').next())
                        .map(str::to_owned);
                    let name = name.filter(|name| !name.is_empty());
                    functions.push(Function {
                        id,
                        name,
                        body: first..index + 1,
                    });
                    open = None;
                }
                (Some(Op::Function), Some(_)) | (Some(Op::FunctionEnd), None) => {
                    return Err(Error::FunctionNesting { at: instruction.at });
                }
                _ => {}
            }
        }
        match open {
            Some((_, id)) => Err(Error::OpenFunction { id }),
            None => Ok(functions),
        }
    }

    fn check_references(&self) -> Result<()> {
        let functions: HashSet<u32> = self.functions.iter().map(|function| function.id).collect();
        for instruction in &self.instructions {
            let id = match instruction.op() {
                Some(Op::EntryPoint) => instruction.operand(2)?,
                Some(Op::FunctionCall) => instruction.operand(3)?,
                _ => continue,
            };
            if !functions.contains(&id) {
                return Err(Error::UnknownFunction {
                    at: instruction.at,
                    id,
                });
            }
        }
        if self.entry_points.is_empty() {
            Err(Error::NoEntryPoint)
        } else {
            Ok(())
        }
    }
}

fn split(words: &[u32]) -> Result<Vec<Instruction<'_>>> {
    let mut instructions = Vec::new();
    let mut at = HEADER;
    while at < words.len() {
        let claims = (words[at] >> 16) as usize;
        if claims == 0 {
            return Err(Error::ZeroLength { at });
        }
        let left = words.len() - at;
        let words = words
            .get(at..at + claims)
            .ok_or(Error::Truncated { at, claims, left })?;
        instructions.push(Instruction { at, words });
        at += claims;
    }
    Ok(instructions)
}
