//! A module without what its specialization constants switch off.
//!
//! Drivers inline every function before they fold a branch away, so a module of many maps
//! costs as much to compile as all of them: ten seconds on llvmpipe in place of one. Here
//! blocks that the constants make unreachable are emptied, and functions that nobody calls
//! any more go. The structure of blocks stays, and with it validity; what can be reached
//! is what it was, less the operands of phis that came from emptied blocks.

use std::collections::{HashMap, HashSet};

use ::spirv::{Decoration, Op};

use super::{Function, Instruction, Module, Result};

/// The module less what cannot be reached with these values of specialization constants
/// (`constant_id`, value); constants that are not listed have their defaults.
pub fn prune(words: &[u32], specialization: &[(u32, u32)]) -> Result<Vec<u32>> {
    let module = Module::parse(words)?;
    let known = constants(&module, specialization)?;
    let mut bodies = HashMap::new();
    for function in module.functions() {
        bodies.insert(function.id, body(&module, function, &known)?);
    }
    let kept = called(&module, &bodies);
    let mut gone = HashSet::new();
    for function in module.functions() {
        if kept.contains(&function.id) {
            gone.extend(bodies[&function.id].gone.iter().copied());
        } else {
            let all = &module.instructions()[function.body.clone()];
            gone.extend(all.iter().filter_map(result));
        }
    }
    let head = module
        .instructions()
        .first()
        .map_or(words.len(), |one| one.at);
    let mut pruned = words[..head].to_vec();
    let mut functions = module.functions().iter();
    let mut next = functions.next();
    let mut index = 0;
    while index < module.instructions().len() {
        if let Some(function) = next.filter(|function| function.body.start == index) {
            if kept.contains(&function.id) {
                pruned.extend(bodies[&function.id].words.iter());
            }
            index = function.body.end;
            next = functions.next();
            continue;
        }
        let instruction = &module.instructions()[index];
        let of_gone = matches!(
            instruction.op(),
            Some(Op::Name | Op::MemberName | Op::Decorate | Op::MemberDecorate)
        ) && instruction.words.get(1).is_some_and(|id| gone.contains(id));
        if !of_gone {
            pruned.extend(instruction.words);
        }
        index += 1;
    }
    Ok(pruned)
}

/// The values of constants that can be told: 32 bits, or 0 and 1 for truth.
type Known = HashMap<u32, u32>;

fn constants(module: &Module, specialization: &[(u32, u32)]) -> Result<Known> {
    let mut numbers = HashMap::new();
    for row in module.decorations() {
        if let (Some(Decoration::SpecId), [number]) = (row.decoration, row.literals) {
            numbers.insert(row.target, *number);
        }
    }
    let mut known = Known::new();
    for instruction in module.instructions() {
        let (id, value) = match (instruction.op(), instruction.words) {
            (Some(Op::Constant), [_, _, id, value]) => (*id, *value),
            (Some(Op::SpecConstant), [_, _, id, default]) => {
                let given = specialization
                    .iter()
                    .find(|(number, _)| numbers.get(id) == Some(number));
                (*id, given.map_or(*default, |(_, value)| *value))
            }
            (Some(Op::ConstantTrue), [_, _, id]) => (*id, 1),
            (Some(Op::ConstantFalse), [_, _, id]) => (*id, 0),
            (Some(Op::SpecConstantOp), [_, _, id, op, operands @ ..]) => {
                match fold(Op::from_u32(*op), operands, &known) {
                    Some(value) => (*id, value),
                    None => continue,
                }
            }
            (Some(Op::Function), _) => break,
            _ => continue,
        };
        known.insert(id, value);
    }
    Ok(known)
}

/// The value of a comparison, or of an operation on truths, between known operands.
fn fold(op: Option<Op>, operands: &[u32], known: &Known) -> Option<u32> {
    let value = |id: &u32| known.get(id).copied();
    let truth = match (op?, operands) {
        (Op::IEqual | Op::LogicalEqual, [a, b]) => value(a)? == value(b)?,
        (Op::INotEqual | Op::LogicalNotEqual, [a, b]) => value(a)? != value(b)?,
        (Op::ULessThan, [a, b]) => value(a)? < value(b)?,
        (Op::ULessThanEqual, [a, b]) => value(a)? <= value(b)?,
        (Op::UGreaterThan, [a, b]) => value(a)? > value(b)?,
        (Op::UGreaterThanEqual, [a, b]) => value(a)? >= value(b)?,
        (Op::LogicalAnd, [a, b]) => value(a)? & value(b)? != 0,
        (Op::LogicalOr, [a, b]) => value(a)? | value(b)? != 0,
        (Op::LogicalNot, [a]) => value(a)? == 0,
        _ => return None,
    };
    Some(truth.into())
}

/// A function's new words, the functions that these call, and the ids that went.
#[derive(Default)]
struct Body {
    words: Vec<u32>,
    calls: Vec<u32>,
    gone: Vec<u32>,
}

fn body(module: &Module, function: &Function, known: &Known) -> Result<Body> {
    let instructions = &module.instructions()[function.body.clone()];
    let mut known = known.clone();
    let reached = reachable(instructions, &mut known);
    // A loop whose way back cannot be reached would need it emptied with care: such a
    // function is left as it is.
    let cut_loop = instructions.iter().any(|instruction| {
        let back = instruction
            .words
            .get(2)
            .filter(|_| instruction.op() == Some(Op::LoopMerge));
        back.is_some_and(|label| !reached.contains(label))
    });
    let keeps = |label: &u32| cut_loop || reached.contains(label);
    let mut body = Body::default();
    let mut alive = true;
    for instruction in instructions {
        match instruction.op() {
            Some(Op::Label) => {
                alive = keeps(&instruction.operand(1)?);
                body.words.extend(instruction.words);
                if !alive {
                    body.words.push(1 << 16 | Op::Unreachable as u32);
                }
                continue;
            }
            Some(Op::FunctionEnd) => alive = true,
            _ => {}
        }
        if !alive {
            body.gone.extend(result(instruction));
            continue;
        }
        match (instruction.op(), instruction.words) {
            (Some(Op::Phi), [_, kind, id, pairs @ ..]) => {
                let pairs = pairs.as_chunks::<2>().0;
                let left: Vec<u32> = pairs
                    .iter()
                    .filter(|[_, from]| keeps(from))
                    .flatten()
                    .copied()
                    .collect();
                let first = ((3 + left.len() as u32) << 16) | Op::Phi as u32;
                body.words.extend([first, *kind, *id]);
                body.words.extend(left);
            }
            (op, words) => {
                if op == Some(Op::FunctionCall) {
                    body.calls.push(instruction.operand(3)?);
                }
                body.words.extend(words);
            }
        }
    }
    Ok(body)
}

/// The labels of the blocks that can be reached from the first.
fn reachable(instructions: &[Instruction], known: &mut Known) -> HashSet<u32> {
    let mut targets: HashMap<u32, Vec<u32>> = HashMap::new();
    let (mut first, mut label) = (None, 0);
    for instruction in instructions {
        match (instruction.op(), instruction.words) {
            (Some(Op::Label), [_, id]) => {
                label = *id;
                first.get_or_insert(label);
            }
            (Some(Op::Branch), [_, target]) => {
                targets.insert(label, vec![*target]);
            }
            (Some(Op::BranchConditional), [_, condition, yes, no, ..]) => {
                let chosen = match known.get(condition) {
                    Some(0) => vec![*no],
                    Some(_) => vec![*yes],
                    None => vec![*yes, *no],
                };
                targets.insert(label, chosen);
            }
            (Some(Op::Switch), [_, selector, default, cases @ ..]) => {
                let pairs = cases.as_chunks::<2>().0.iter();
                let chosen = match known.get(selector) {
                    Some(value) => {
                        let case = pairs.clone().find(|[literal, _]| literal == value);
                        vec![case.map_or(*default, |[_, target]| *target)]
                    }
                    None => pairs.map(|[_, target]| *target).chain([*default]).collect(),
                };
                targets.insert(label, chosen);
            }
            // A comparison of constants within a function.
            (Some(op), [_, _, id, operands @ ..]) => {
                if let Some(value) = fold(Some(op), operands, known) {
                    known.insert(*id, value);
                }
            }
            _ => {}
        }
    }
    let mut reached = HashSet::new();
    let mut open: Vec<u32> = first.into_iter().collect();
    while let Some(label) = open.pop() {
        if reached.insert(label) {
            open.extend(targets.get(&label).into_iter().flatten());
        }
    }
    reached
}

/// The functions that entry points lead to.
fn called(module: &Module, bodies: &HashMap<u32, Body>) -> HashSet<u32> {
    let mut kept = HashSet::new();
    let mut open: Vec<u32> = module
        .entry_points()
        .iter()
        .map(|entry| entry.function)
        .collect();
    while let Some(id) = open.pop() {
        if kept.insert(id) {
            open.extend(bodies.get(&id).into_iter().flat_map(|body| &body.calls));
        }
    }
    kept
}

/// The id that an instruction of a function body defines.
fn result(instruction: &Instruction) -> Option<u32> {
    match instruction.op()? {
        Op::Label => instruction.words.get(1).copied(),
        Op::Store
        | Op::CopyMemory
        | Op::AtomicStore
        | Op::Branch
        | Op::BranchConditional
        | Op::Switch
        | Op::Return
        | Op::ReturnValue
        | Op::Kill
        | Op::Unreachable
        | Op::SelectionMerge
        | Op::LoopMerge
        | Op::ControlBarrier
        | Op::MemoryBarrier
        | Op::Line
        | Op::NoLine
        | Op::Nop
        | Op::FunctionEnd => None,
        _ => instruction.words.get(2).copied(),
    }
}
