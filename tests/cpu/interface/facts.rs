//! The interface of a kernel as a set of lines: from its row, and from its SPIR-V.

use corput::interface::{Element, Kernel};
use corput::spirv::Module;
use spirq::ReflectConfig;
use spirq::constant::ConstantValue;
use spirq::ty::{DescriptorType, ScalarType, Type};
use spirq::var::Variable;
use std::collections::BTreeSet;

const UINT: Type = Type::Scalar(ScalarType::Integer {
    bits: 32,
    is_signed: false,
});

const UINT64: Type = Type::Scalar(ScalarType::Integer {
    bits: 64,
    is_signed: false,
});

/// The interface of a module or of a row, one line a fact.
pub type Facts = BTreeSet<String>;

/// What the row promises.
pub fn promised(row: &Kernel) -> Facts {
    let mut facts = Facts::from([
        format!("local size [{}, 1, 1]", row.local_size),
        "version 1.3".to_owned(),
    ]);
    for m in row.push {
        facts.insert(format!("push {} at {}", m.name, m.offset));
    }
    if !row.push.is_empty() {
        facts.insert(format!("push bytes {}", row.push_bytes()));
    }
    for b in row.bindings {
        let (element, stride) = match b.element {
            Element::Uint => ("uint[]".to_owned(), 4),
            Element::Uvec4 => ("uvec4[]".to_owned(), 16),
            Element::U64vec4 => ("u64vec4[]".to_owned(), 32),
            Element::Rows(rows) => (format!("uvec4[{rows}]"), 16),
        };
        let access = match (b.element, b.input) {
            (Element::Rows(_), true) => "Uniform",
            (_, true) => "ReadOnly",
            _ => "ReadWrite",
        };
        let (at, name) = (b.binding, b.name);
        facts.insert(format!(
            "buffer 0.{at} {name}: {access} {element} every {stride}"
        ));
    }
    for (id, name, default) in row.specialization() {
        facts.insert(format!("constant {id} {name} = {default}"));
    }
    facts
}

/// What the module says: buffers, block and size by one reader, constants by another.
pub fn reflected(words: &[u32]) -> Facts {
    let readable = without_constant_operations(words);
    let reflection = ReflectConfig::new()
        .spv(readable)
        .ref_all_rscs(true)
        .reflect();
    let entries = reflection.expect("the module is reflected");
    assert_eq!(entries.len(), 1, "one entry point");
    let mut facts = constants(words);
    facts.insert(format!(
        "version {}.{}",
        words[1] >> 16,
        words[1] >> 8 & 0xff
    ));
    for mode in &entries[0].exec_modes {
        let value = |value: &ConstantValue| match value {
            ConstantValue::U32(word) => *word,
            other => panic!("a size of {other:?}"),
        };
        let size: Vec<u32> = mode.operands.iter().map(|o| value(&o.value)).collect();
        facts.insert(format!("local size {size:?}"));
    }
    for variable in &entries[0].vars {
        match variable {
            Variable::PushConstant { ty, .. } => {
                let Type::Struct(block) = ty else {
                    panic!("the block is {ty:?}")
                };
                for m in &block.members {
                    assert_eq!(m.ty, UINT);
                    let name = m.name.clone().unwrap_or_default();
                    facts.insert(format!("push {name} at {}", m.offset.expect("an offset")));
                }
                facts.insert(format!("push bytes {}", ty.nbyte().expect("a size")));
            }
            Variable::Descriptor {
                desc_bind,
                desc_ty,
                ty,
                nbind,
                ..
            } => {
                assert_eq!(*nbind, 1);
                let access = match desc_ty {
                    DescriptorType::StorageBuffer(access) => format!("{access:?}"),
                    DescriptorType::UniformBuffer() => "Uniform".to_owned(),
                    other => panic!("binding {desc_bind} is {other:?}"),
                };
                let (set, at) = desc_bind.into_inner();
                facts.insert(format!("buffer {set}.{at} {}", buffer(ty, &access)));
            }
            _ => {}
        }
    }
    facts
}

/// The module with a plain 0 or false for each operation on specialization constants:
/// spirq 1.3 evaluates them, and knows neither `LogicalOr` nor `Select`. No layout
/// depends on their values.
fn without_constant_operations(words: &[u32]) -> Vec<u32> {
    use ::spirv::Op;
    let module = Module::parse(words).expect("the module is read");
    let rows = module.instructions();
    let mut changed = words[..5].to_vec();
    for row in rows {
        if row.op() != Some(Op::SpecConstantOp) {
            changed.extend_from_slice(row.words);
            continue;
        }
        let (kind, result) = (row.words[1], row.words[2]);
        let bool_kind = |row: &&corput::spirv::Instruction| row.op() == Some(Op::TypeBool);
        if rows
            .iter()
            .find(bool_kind)
            .is_some_and(|row| row.words[1] == kind)
        {
            changed.extend([3 << 16 | Op::ConstantFalse as u32, kind, result]);
        } else {
            changed.extend([4 << 16 | Op::Constant as u32, kind, result, 0]);
        }
    }
    changed
}

/// Name, access, element and stride of a buffer's one array.
fn buffer(ty: &Type, access: &str) -> String {
    let Type::Struct(block) = ty else {
        panic!("a buffer is {ty:?}")
    };
    let [member] = &block.members[..] else {
        panic!("a buffer holds {:?}", block.members)
    };
    let Type::Array(array) = &member.ty else {
        panic!("a buffer holds {:?}", member.ty)
    };
    assert_eq!(member.offset, Some(0));
    let length = array.nelement.map_or(String::new(), |n| n.to_string());
    let element = match &*array.element_ty {
        element if *element == UINT => "uint".to_owned(),
        Type::Vector(v) if Type::Scalar(v.scalar_ty.clone()) == UINT => {
            format!("uvec{}", v.nscalar)
        }
        Type::Vector(v) if Type::Scalar(v.scalar_ty.clone()) == UINT64 => {
            format!("u64vec{}", v.nscalar)
        }
        other => format!("{other:?}"),
    };
    let (name, stride) = (
        member.name.clone().unwrap_or_default(),
        array.stride.unwrap_or(0),
    );
    format!("{name}: {access} {element}[{length}] every {stride}")
}

/// Specialization constants with names and defaults.
pub fn constants(words: &[u32]) -> Facts {
    let module = Module::parse(words).expect("the module is read");
    let id = |target: u32| {
        let mut rows = module.decorations().filter(|row| row.target == target);
        rows.find(|row| row.decoration == Some(::spirv::Decoration::SpecId))
            .map(|row| row.literals[0])
    };
    let mut facts = Facts::new();
    for row in module.instructions() {
        if row.op() == Some(::spirv::Op::SpecConstant) {
            let target = row.words[2];
            let (id, name) = (
                id(target).expect("an id"),
                module.name(target).unwrap_or(""),
            );
            let new = facts.insert(format!("constant {id} {name} = {}", row.words[3]));
            assert!(new, "two constants {id} {name}");
        } else {
            use ::spirv::Op::{SpecConstantComposite, SpecConstantFalse, SpecConstantTrue};
            let other = [SpecConstantTrue, SpecConstantFalse, SpecConstantComposite];
            assert!(
                !row.op().is_some_and(|op| other.contains(&op)),
                "{:?}",
                row.op()
            );
        }
    }
    facts
}
