//! A module in a form that only depends on what its entry point does: ids in the order in which
//! they are met from there, no names, nothing that is not reached.

use corput::spirv::{Instruction, Module};
use spirv::Op;
use std::collections::{BTreeSet, HashMap, HashSet};

/// Which operands of an instruction are ids: its own result type and id are among them. Panics
/// at an opcode that no stock kernel has, so that none is taken for something else.
fn ids(instruction: &Instruction) -> Vec<usize> {
    let op = instruction.op().expect("a known opcode");
    let end = instruction.words.len();
    let all = |from: usize| (from..end).collect();
    match op {
        Op::TypeVoid | Op::TypeBool | Op::TypeInt | Op::TypeFloat | Op::Label => vec![1],
        Op::TypeVector => vec![1, 2],
        Op::TypePointer => vec![1, 3],
        Op::TypeArray | Op::TypeRuntimeArray | Op::TypeStruct | Op::TypeFunction => all(1),
        Op::Constant | Op::SpecConstant => vec![1, 2],
        Op::SpecConstantOp => [vec![1, 2], all(4)].concat(),
        Op::Variable => [vec![1, 2], all(4)].concat(),
        Op::Function => vec![1, 2, 4],
        Op::ExtInst => [vec![1, 2, 3], all(5)].concat(),
        Op::Load => vec![1, 2, 3],
        Op::Store => vec![1, 2],
        Op::CompositeExtract => vec![1, 2, 3],
        Op::CompositeInsert => vec![1, 2, 3, 4],
        Op::VectorShuffle => vec![1, 2, 3, 4],
        Op::LoopMerge => vec![1, 2],
        Op::SelectionMerge => vec![1],
        Op::Branch => vec![1],
        Op::BranchConditional => vec![1, 2, 3],
        Op::Switch => (1..3).chain((4..end).step_by(2)).collect(),
        Op::ArrayLength => vec![1, 2, 3],
        Op::Return | Op::Unreachable | Op::FunctionEnd => Vec::new(),
        Op::ExtInstImport => vec![1],
        Op::ReturnValue | Op::ControlBarrier | Op::MemoryBarrier => all(1),
        Op::ConstantTrue | Op::ConstantFalse | Op::ConstantComposite | Op::ConstantNull => all(1),
        Op::SpecConstantComposite | Op::SpecConstantTrue | Op::SpecConstantFalse => all(1),
        Op::FunctionParameter | Op::FunctionCall | Op::AccessChain | Op::CompositeConstruct => {
            all(1)
        }
        Op::Phi | Op::Select | Op::Undef | Op::CopyLogical | Op::CopyObject => all(1),
        _ if (Op::ConvertFToU as u16..=Op::Bitcast as u16).contains(&instruction.opcode())
            || (Op::SNegate as u16..=Op::FUnordGreaterThanEqual as u16)
                .contains(&instruction.opcode())
            || (Op::ShiftRightLogical as u16..=Op::BitCount as u16)
                .contains(&instruction.opcode())
            || (Op::AtomicLoad as u16..=Op::AtomicXor as u16).contains(&instruction.opcode()) =>
        {
            all(1)
        }
        op => panic!("{op:?}: say which of its operands are ids"),
    }
}

/// The result id of a declaration outside of functions.
fn result(instruction: &Instruction) -> Option<u32> {
    match instruction.op()? {
        Op::TypeVoid
        | Op::TypeBool
        | Op::TypeInt
        | Op::TypeFloat
        | Op::TypeVector
        | Op::TypePointer
        | Op::TypeArray
        | Op::TypeRuntimeArray
        | Op::TypeStruct
        | Op::TypeFunction
        | Op::ExtInstImport => Some(instruction.words[1]),
        Op::Constant
        | Op::SpecConstant
        | Op::SpecConstantOp
        | Op::SpecConstantComposite
        | Op::SpecConstantTrue
        | Op::SpecConstantFalse
        | Op::ConstantTrue
        | Op::ConstantFalse
        | Op::ConstantComposite
        | Op::ConstantNull
        | Op::Undef
        | Op::Variable => Some(instruction.words[2]),
        _ => None,
    }
}

struct Writer<'a> {
    globals: HashMap<u32, Instruction<'a>>,
    numbers: HashMap<u32, u32>,
    out: Vec<Vec<u32>>,
}

impl Writer<'_> {
    fn number(&mut self, id: u32) -> u32 {
        if !self.numbers.contains_key(&id) {
            let global = self.globals.get(&id).copied();
            if let Some(global) = global {
                // What it is made of comes first.
                for at in ids(&global) {
                    if global.words[at] != id {
                        self.number(global.words[at]);
                    }
                }
            }
            let next = self.numbers.len() as u32 + 1;
            self.numbers.insert(id, next);
            if let Some(global) = global {
                self.write(&global);
            }
        }
        self.numbers[&id]
    }

    fn write(&mut self, instruction: &Instruction) {
        let mut words = instruction.words.to_vec();
        for at in ids(instruction) {
            words[at] = self.number(words[at]);
        }
        self.out.push(words);
    }
}

/// The ids of the functions that the entry point reaches.
fn reached(module: &Module) -> HashSet<u32> {
    let [entry] = module.entry_points() else {
        panic!("one entry point");
    };
    let mut reached = HashSet::new();
    let mut open = vec![entry.function];
    while let Some(id) = open.pop() {
        if reached.insert(id) {
            let found = module.functions().iter().find(|function| function.id == id);
            let body = &module.instructions()[found.expect("a function").body.clone()];
            let calls = body.iter().filter(|row| row.op() == Some(Op::FunctionCall));
            open.extend(calls.map(|row| row.words[3]));
        }
    }
    reached
}

/// Their names.
pub fn called(words: &[u32]) -> BTreeSet<String> {
    let module = Module::parse(words).expect("a module");
    let reached = reached(&module);
    let functions = module
        .functions()
        .iter()
        .filter(|f| reached.contains(&f.id));
    functions.map(|function| function.label()).collect()
}

/// The instructions of a module's entry point and of all that it reaches, with decorations.
pub fn canonical(words: &[u32]) -> Vec<Vec<u32>> {
    let module = Module::parse(words).expect("a module");
    let all = module.instructions();
    let reached = reached(&module);
    let mut writer = Writer {
        globals: all
            .iter()
            .filter_map(|row| Some((result(row)?, *row)))
            .collect(),
        numbers: HashMap::new(),
        out: Vec::new(),
    };
    for function in module
        .functions()
        .iter()
        .filter(|f| reached.contains(&f.id))
    {
        for row in &all[function.body.clone()] {
            writer.write(row);
        }
    }
    // Of the rest, what speaks of the module or of ids that are reached.
    let mut rest = Vec::new();
    for row in all {
        let mut words = row.words.to_vec();
        match row.op() {
            Some(Op::Capability | Op::MemoryModel) => {}
            Some(Op::EntryPoint | Op::ExecutionMode) => {
                let at = if row.op() == Some(Op::EntryPoint) {
                    2
                } else {
                    1
                };
                words[at] = writer.number(words[at]);
                if row.op() == Some(Op::EntryPoint) {
                    // `main`, then the variables of its interface.
                    for word in &mut words[5..] {
                        *word = writer.number(*word);
                    }
                }
            }
            Some(Op::Decorate | Op::MemberDecorate) => {
                let Some(number) = writer.numbers.get(&words[1]) else {
                    continue;
                };
                words[1] = *number;
            }
            _ => continue,
        }
        rest.push(words);
    }
    rest.sort();
    writer.out.extend(rest);
    writer.out
}
