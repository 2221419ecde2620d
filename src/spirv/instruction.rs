//! One instruction of a module.

use ::spirv::Op;

use super::{Error, Result};

/// One instruction, in place.
#[derive(Clone, Copy, Debug)]
pub struct Instruction<'a> {
    /// Where it begins in the module, in words.
    pub at: usize,
    /// Its words; the first holds length and opcode.
    pub words: &'a [u32],
}

impl<'a> Instruction<'a> {
    /// The opcode's number.
    #[must_use]
    pub fn opcode(&self) -> u16 {
        self.words.first().map_or(0, |word| *word as u16)
    }

    /// The opcode, if this build knows it.
    #[must_use]
    pub fn op(&self) -> Option<Op> {
        Op::from_u32(u32::from(self.opcode()))
    }

    /// Word `n` of the instruction; the first operand is word 1.
    pub fn operand(&self, n: usize) -> Result<u32> {
        self.words.get(n).copied().ok_or(Error::MissingOperand {
            at: self.at,
            opcode: self.opcode(),
            operand: n,
        })
    }

    /// The words from word `n` on; empty if there are none.
    #[must_use]
    pub fn operands_from(&self, n: usize) -> &'a [u32] {
        self.words.get(n..).unwrap_or_default()
    }

    /// The literal string that begins at word `n`.
    pub fn text(&self, n: usize) -> Result<String> {
        let bytes: Vec<u8> = self
            .operands_from(n)
            .iter()
            .flat_map(|word| word.to_le_bytes())
            .collect();
        let end = bytes
            .iter()
            .position(|byte| *byte == 0)
            .ok_or(Error::Text { at: self.at })?;
        String::from_utf8(bytes[..end].to_vec()).map_err(|_| Error::Text { at: self.at })
    }
}
