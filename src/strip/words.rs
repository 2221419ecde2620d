//! Keywords of GLSL, as far as declarations go.

/// Words that precede a type.
const QUALIFIERS: [&str; 27] = [
    "layout",
    "const",
    "in",
    "out",
    "inout",
    "uniform",
    "buffer",
    "shared",
    "attribute",
    "varying",
    "centroid",
    "sample",
    "patch",
    "flat",
    "smooth",
    "noperspective",
    "invariant",
    "precise",
    "coherent",
    "volatile",
    "restrict",
    "readonly",
    "writeonly",
    "highp",
    "mediump",
    "lowp",
    "nonuniformEXT",
];

/// Words after which a name is used, and not declared.
const STATEMENTS: [&str; 5] = ["return", "else", "case", "do", "struct"];

/// Whether a word precedes a type.
pub(super) fn is_qualifier(word: &str) -> bool {
    QUALIFIERS.contains(&word)
}

/// Whether a name after this one is no declaration of it.
pub(super) fn is_keyword(word: &str) -> bool {
    is_qualifier(word) || STATEMENTS.contains(&word)
}

/// Words of four bytes that a value of a built-in type has.
pub(super) fn words_of(kind: &str) -> Option<u64> {
    let (scalar, shape) = match kind {
        "float" | "int" | "uint" | "bool" => return Some(1),
        "double" => return Some(2),
        _ => {
            let at = kind.find("vec").or_else(|| kind.find("mat"))?;
            (&kind[..at], &kind[at..])
        }
    };
    let each = match (scalar, shape.get(..3)) {
        ("", _) | ("u" | "i" | "b", Some("vec")) => 1,
        ("d", _) => 2,
        _ => return None,
    };
    let size = |text: &str| match text {
        "2" => Some(2),
        "3" => Some(3),
        "4" => Some(4),
        _ => None,
    };
    let sizes = shape.get(3..)?;
    let count = match (shape.get(..3)?, sizes.split_once('x')) {
        ("mat", Some((columns, rows))) => size(columns)? * size(rows)?,
        ("mat", None) => size(sizes)? * size(sizes)?,
        _ => size(sizes)?,
    };
    Some(each * count)
}
