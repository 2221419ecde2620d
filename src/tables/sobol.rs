//! Direction numbers of the Sobol sequence, from the table of Joe and Kuo (2008).

use std::fmt::Write;
use std::sync::OnceLock;

/// Dimensions of the table.
pub const SOBOL_DIMENSIONS: u32 = 21_201;

/// Dimensions of `corput/sobol_directions.glsl`, which engines include.
pub const SOBOL_GLSL_DIMENSIONS: u32 = 64;

/// Polynomials and initial numbers of the dimensions from the second on;
/// `assets/sobol/README.md` describes the format.
const TABLE: &[u8] = include_bytes!("../../assets/sobol/joe_kuo.bin");

/// Where the entry of each dimension from the second on begins.
fn offsets() -> &'static [usize] {
    static OFFSETS: OnceLock<Vec<usize>> = OnceLock::new();
    OFFSETS.get_or_init(|| {
        let mut offsets = Vec::with_capacity(SOBOL_DIMENSIONS as usize);
        let mut at = 0;
        while at < TABLE.len() {
            offsets.push(at);
            let degree = polynomial(at).ilog2() as usize;
            at += 3 + (degree * (degree - 1) / 2).div_ceil(8);
        }
        offsets
    })
}

fn polynomial(at: usize) -> u32 {
    u32::from_le_bytes([TABLE[at], TABLE[at + 1], TABLE[at + 2], 0])
}

/// The primitive polynomial of a dimension with all its coefficients, and its initial
/// numbers m_1 to m_s; `None` for the first dimension, which has neither, and past the
/// table.
#[must_use]
pub fn sobol_initial(dimension: u32) -> Option<(u32, Vec<u32>)> {
    let index = dimension.checked_sub(1)? as usize;
    let at = *offsets().get(index)?;
    let polynomial = polynomial(at);
    let mut bit = 8 * (at + 3);
    let mut numbers = Vec::new();
    for width in 0..polynomial.ilog2() {
        let mut half = 0;
        for i in 0..width {
            half |= u32::from(TABLE[bit / 8] >> (bit % 8) & 1) << i;
            bit += 1;
        }
        numbers.push(2 * half + 1);
    }
    Some((polynomial, numbers))
}

/// Direction numbers of a dimension, from 0 on: entry i is the fraction of 2^32 that bit
/// i of the index contributes, by the recurrence of Bratley and Fox 1988, equation 2.
/// Zeros past the table.
#[must_use]
pub fn sobol_directions(dimension: u32) -> [u32; 32] {
    if dimension == 0 {
        return std::array::from_fn(|i| 1 << (31 - i));
    }
    let Some((polynomial, initial)) = sobol_initial(dimension) else {
        return [0; 32];
    };
    let degree = initial.len();
    let mut directions = [0u32; 32];
    for i in 0..32 {
        directions[i] = match initial.get(i) {
            Some(m) => m << (31 - i),
            None => {
                let mut v = directions[i - degree] ^ (directions[i - degree] >> degree);
                for k in 1..degree {
                    if polynomial >> (degree - k) & 1 != 0 {
                        v ^= directions[i - k];
                    }
                }
                v
            }
        };
    }
    directions
}

/// The text of `shaders/corput/sobol_directions.glsl`; a test compares the committed
/// file.
#[must_use]
pub fn sobol_glsl() -> String {
    let dimensions = SOBOL_GLSL_DIMENSIONS;
    let words = 32 * dimensions;
    let mut text = format!(
        "// what:   direction numbers of the first {dimensions} dimensions of the Sobol sequence.\n\
         // source: Joe and Kuo 2008, Constructing Sobol sequences with better two-dimensional\n\
         //         projections, SIAM J. Sci. Comput. 30; generated from src/tables/sobol.rs.\n\
         //         Their licence is in assets/sobol/README.md.\n\
         // domain: dimensions 0 to {}, bits 0 to 31. range: fractions of 2^32; 0 past the table.\n\
         // cost:   one lookup in a constant array, which llvmpipe copies in every invocation:\n\
         //         there, and wherever constants are not indexed in place, define\n\
         //         CORPUT_SOBOL_DIRECTION by a buffer or, for few dimensions, by numbers.\n\
         // hooks:  none.\n\
         // mirror: src/reference/sobol_directions.rs\n\
         #ifndef CORPUT_SOBOL_DIRECTIONS_GLSL\n\
         #define CORPUT_SOBOL_DIRECTIONS_GLSL\n\n\
         const uint CORPUT_SOBOL_DIRECTIONS[{words}] = uint[{words}](\n",
        dimensions - 1,
    );
    for dimension in 0..dimensions {
        for (part, row) in sobol_directions(dimension).chunks(8).enumerate() {
            let row: Vec<String> = row.iter().map(|v| format!("0x{v:08x}u")).collect();
            let last = dimension + 1 == dimensions && part == 3;
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "    {}{}",
                row.join(", "),
                if last { "" } else { "," }
            );
        }
    }
    let _ = write!(
        text,
        ");\n\n\
         // What bit `bit` of the index contributes to the coordinate `dimension`.\n\
         uint corput_sobol_direction(uint dimension, uint bit) {{\n    \
             return dimension < {dimensions}u && bit < 32u ? CORPUT_SOBOL_DIRECTIONS[32u * dimension + bit] : 0u;\n\
         }}\n\n\
         #endif\n"
    );
    text
}
