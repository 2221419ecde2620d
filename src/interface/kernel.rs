//! What a kernel is compiled with: bindings, constants, and the GLSL that declares them.

use super::{COLUMN_STRIDE, Family, Member};
use std::fmt::Write;

/// What an std430 array holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// `uint`, 4 bytes.
    Uint,
    /// `uvec4`, 16 bytes.
    Uvec4,
    /// `u64vec4`, 32 bytes: eight words, for modules of [`Profile::Wide`].
    U64vec4,
    /// So many `uvec4` in a uniform block, at most 1024: what all invocations read alike.
    /// llvmpipe loads from other buffers lane by lane, thirty times slower.
    Rows(u32),
}

/// A buffer in set 0.
#[derive(Clone, Copy, Debug)]
pub struct Binding {
    /// Its number.
    pub binding: u32,
    /// The array's name.
    pub name: &'static str,
    /// The array's element.
    pub element: Element,
    /// Whether the kernel only reads it, as it does a uniform block; that also lets the
    /// validation layer see hazards.
    pub input: bool,
}

impl Binding {
    /// Bytes of the block, for a uniform block.
    #[must_use]
    pub fn uniform(&self) -> Option<u64> {
        match self.element {
            Element::Uint | Element::Uvec4 | Element::U64vec4 => None,
            Element::Rows(rows) => Some(16 * u64::from(rows)),
        }
    }
}

/// A specialization constant of type `uint`.
#[derive(Clone, Copy, Debug)]
pub struct Constant {
    /// Its `constant_id`.
    pub id: u32,
    /// Its name.
    pub name: &'static str,
    /// Its value where none is given.
    pub default: u32,
}

/// `constant_id` of `KINDS`, which every kernel of columns has: a bit for each kind of
/// column that occurs. By default all may.
pub const KINDS: u32 = 15;

/// One compiled module.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    /// Name of the module.
    pub name: &'static str,
    /// File in `shaders/kernels/`.
    pub source: &'static str,
    /// Macros; only where bindings, types or the profile differ.
    pub defines: &'static [(&'static str, &'static str)],
    /// Invocations per workgroup: at most 128, which every device has.
    pub local_size: u32,
    /// Push-constant members.
    pub push: &'static [Member],
    /// Buffers.
    pub bindings: &'static [Binding],
    /// Specialization constants, besides those of the columns.
    pub constants: &'static [Constant],
    /// What columns it makes, and how many of them it takes as constants.
    pub columns: Option<(Family, u32)>,
    /// Of how many columns the shape is constant, and the other words are in the table.
    pub shapes: u32,
    /// Which rules the linter holds it to.
    pub profile: Profile,
}

/// Which promises a module makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Profile {
    /// Tier I: integers and exactly representable floats.
    Integer,
    /// The same with integers of 64 bits, where the device has them.
    Wide,
    /// Tier F: float + - * besides, never contracted.
    Float,
    /// The device's own functions.
    Native,
    /// The start-up probe: what the device does with floats is what it asks.
    Probe,
}

impl Kernel {
    /// Bytes of the push-constant block.
    #[must_use]
    pub fn push_bytes(&self) -> u32 {
        4 * self.push.len() as u32
    }

    /// Every specialization constant: `constant_id`, name and default. Those of a column
    /// begin with `COLUMN` and its number.
    #[must_use]
    pub fn specialization(&self) -> Vec<(u32, String, u32)> {
        let own = self.constants.iter();
        let mut all: Vec<_> = own.map(|c| (c.id, c.name.to_owned(), c.default)).collect();
        if let Some((family, columns)) = self.columns {
            all.push((KINDS, "KINDS".to_owned(), u32::MAX));
            for column in 0..columns.max(self.shapes) {
                let first = 16 + COLUMN_STRIDE * column;
                for (id, (name, default)) in (first..).zip(family.words()) {
                    if column < columns || family.shape().contains(name) {
                        all.push((id, format!("COLUMN{column}_{name}"), *default));
                    }
                }
            }
        }
        all
    }

    /// The GLSL of this interface: block, buffers, constants and the linear index of
    /// the invocation.
    #[must_use]
    pub fn glsl(&self) -> String {
        let mut text = String::new();
        // Writing to a String cannot fail.
        let _ = writeln!(text, "layout(local_size_x = {}) in;", self.local_size);
        for b in self.bindings {
            let (packing, class, array) = match b.element {
                Element::Uint => ("std430", "buffer", format!("uint {}[]", b.name)),
                Element::Uvec4 => ("std430", "buffer", format!("uvec4 {}[]", b.name)),
                Element::U64vec4 => ("std430", "buffer", format!("u64vec4 {}[]", b.name)),
                Element::Rows(rows) => ("std140", "uniform", format!("uvec4 {}[{rows}]", b.name)),
            };
            let access = match b.element {
                Element::Uint | Element::Uvec4 | Element::U64vec4 if b.input => "readonly ",
                _ => "",
            };
            let _ = writeln!(
                text,
                "layout({packing}, set = 0, binding = {0}) {access}{class} Buffer{0} {{ {array}; }};",
                b.binding,
            );
        }
        if !self.push.is_empty() {
            text.push_str("layout(push_constant) uniform Push {\n");
            for m in self.push {
                let _ = writeln!(text, "    layout(offset = {}) uint {};", m.offset, m.name);
            }
            text.push_str("} push;\n");
        }
        for (id, name, default) in self.specialization() {
            let _ = writeln!(
                text,
                "layout(constant_id = {id}) const uint {name} = {default}u;"
            );
        }
        if let Some((family, _)) = self.columns {
            let _ = writeln!(text, "#define COLUMN_FAMILY {}", family.number());
            let _ = writeln!(text, "#define COLUMN_ROWS {}u", family.rows());
        }
        // More groups than one axis holds are dispatched in two.
        let _ = writeln!(
            text,
            "uint kernel_invocation() {{\n    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x \
             + gl_WorkGroupID.x;\n    return group * {}u + gl_LocalInvocationID.x;\n}}",
            self.local_size
        );
        text
    }
}
