//! What a host needs to know of a module, as C, C++ and Rust.
//!
//! The generated files hold numbers and one struct, and assert its layout when they are
//! compiled. They need nothing of this crate.

mod c;
mod names;
mod rust;

pub use c::c_header;
pub use names::identifier;
pub use rust::rust_module;

use crate::interface::{Element, Kernel};
use crate::{Error, Result, spirv};

/// The interface of a module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interface {
    /// The module's name, of which the names in C are made.
    pub name: String,
    /// The entry point's name.
    pub entry_point: String,
    /// Invocations of a workgroup along each axis.
    pub workgroup: [u32; 3],
    /// Buffers.
    pub resources: Vec<Resource>,
    /// Members of the push-constant block, by offset.
    pub push: Vec<Field>,
    /// Specialization constants.
    pub constants: Vec<Specialization>,
    /// Words of the SPIR-V module.
    pub spirv_words: usize,
    /// Other numbers that a host computes with.
    pub numbers: Vec<Number>,
}

/// A number of 64 bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Number {
    /// Its name.
    pub name: String,
    /// Its value.
    pub value: u64,
    /// What it means, in a line without a full stop.
    pub doc: String,
}

/// A buffer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Resource {
    /// Its descriptor set.
    pub set: u32,
    /// Its binding.
    pub binding: u32,
    /// The name of what it holds.
    pub name: String,
    /// Bytes of the whole, for a uniform block; a storage buffer has any number of elements.
    pub uniform_bytes: Option<u64>,
    /// Bytes from an element to the next.
    pub stride: u32,
    /// Whether the shader only reads it.
    pub read_only: bool,
}

/// A member of 32 bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// Its name.
    pub name: String,
    /// Its offset in bytes.
    pub offset: u32,
    /// What it means.
    pub doc: String,
}

/// A specialization constant of 32 bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Specialization {
    /// Its `constant_id`.
    pub id: u32,
    /// Its name.
    pub name: String,
    /// Its value where none is given.
    pub default: u32,
}

impl Interface {
    /// The interface of a stock kernel in one of its modules: of its buffers and constants those
    /// that the module has, since a flattened one may lack some, and a baked one lacks constants.
    ///
    /// # Errors
    /// The words are no module.
    pub fn of(kernel: &Kernel, words: &[u32]) -> spirv::Result<Self> {
        let facts = spirv::describe(words)?;
        let resource = |binding: &crate::interface::Binding| Resource {
            set: 0,
            binding: binding.binding,
            name: binding.name.to_owned(),
            uniform_bytes: binding.uniform(),
            stride: match binding.element {
                Element::Uint => 4,
                Element::Uvec4 | Element::Rows(_) => 16,
                Element::U64vec4 => 32,
            },
            read_only: binding.input,
        };
        let field = |member: &crate::interface::Member| Field {
            name: member.name.to_owned(),
            offset: member.offset as u32,
            doc: member.doc.trim().to_owned(),
        };
        let buffers = kernel.bindings.iter().map(resource);
        let constants = kernel.specialization().into_iter();
        Ok(Self {
            name: kernel.name.to_owned(),
            entry_point: "main".to_owned(),
            workgroup: [kernel.local_size, 1, 1],
            resources: buffers
                .filter(|buffer| facts.bindings.contains(&(buffer.set, buffer.binding)))
                .collect(),
            push: kernel.push.iter().map(field).collect(),
            constants: constants
                .filter(|(id, _, _)| facts.spec_ids.contains(id))
                .map(|(id, name, default)| Specialization { id, name, default })
                .collect(),
            spirv_words: words.len(),
            numbers: Vec::new(),
        })
    }

    /// Bytes of the push-constant block.
    #[must_use]
    pub fn push_bytes(&self) -> u32 {
        self.push
            .last()
            .map_or(0, |field| field.offset.saturating_add(4))
    }

    /// That names are names, each once, and that fields lie one after the other.
    fn checked(&self) -> Result<()> {
        let refused = |asked: String, limit: &str, remedy: &str| Error::Arguments {
            asked,
            limit: limit.to_owned(),
            remedy: remedy.to_owned(),
        };
        let lists = [
            self.resources.iter().map(|r| r.name.as_str()).collect(),
            self.push.iter().map(|f| f.name.as_str()).collect(),
            self.constants.iter().map(|c| c.name.as_str()).collect(),
            self.numbers.iter().map(|n| n.name.as_str()).collect(),
            vec![self.name.as_str()],
        ];
        for list in lists {
            let list: Vec<&str> = list;
            for (at, name) in list.iter().enumerate() {
                if !names::is_name(name) {
                    return Err(refused(
                        format!("the name `{name}`"),
                        "C and Rust have names of ASCII letters, digits and `_`, not all as keywords",
                        "choose another",
                    ));
                }
                let same = |other: &&str| other.eq_ignore_ascii_case(name);
                if list.iter().take(at).any(same) {
                    return Err(refused(
                        format!("the name `{name}`, twice"),
                        "names differ by more than the size of letters",
                        "choose another for one",
                    ));
                }
            }
        }
        let text = &self.entry_point;
        if text.is_empty() || text.contains(['"', '\\']) || text.contains(char::is_control) {
            return Err(refused(
                format!("the entry point {text:?}"),
                "it stands between quotes in C and Rust",
                "name it without quotes, backslashes and control characters",
            ));
        }
        let mut free = 0;
        for field in &self.push {
            if field.offset % 4 != 0 || field.offset < free || field.offset > 1 << 16 {
                return Err(refused(
                    format!("field `{}` at byte {}", field.name, field.offset),
                    "fields of four bytes follow each other at multiples of 4 up to 65536",
                    "give them by offset",
                ));
            }
            free = field.offset + 4;
        }
        Ok(())
    }

    /// The fields, with what lies before each in words.
    fn fields(&self) -> impl Iterator<Item = (u32, &Field)> {
        let before = std::iter::once(0).chain(self.push.iter().map(|field| field.offset + 4));
        let gaps = before.zip(&self.push);
        gaps.map(|(free, field)| ((field.offset - free) / 4, field))
    }
}
