//! Specialization constants and buffers that the kernels share.

use super::super::{
    Binding, Constant, ESTIMATE_DIMENSIONS, Element, EstimatePush, MapPush, Member, PushConstants,
    WorkPush, integrand, map, output, pair_kind, task,
};

pub(super) const OUTPUT: Constant = Constant {
    id: 0,
    name: "OUTPUT",
    default: output::FLOATS,
};
pub(super) const MAP: Constant = Constant {
    id: 1,
    name: "MAP",
    default: map::COSINE_HEMISPHERE,
};
pub(super) const WITH_PDF: Constant = Constant {
    id: 2,
    name: "WITH_PDF",
    default: 0,
};
pub(super) const TILE: Constant = Constant {
    id: 3,
    name: "TILE",
    default: 16,
};
pub(super) const DIMENSIONS: Constant = Constant {
    id: 4,
    name: "DIMENSIONS",
    default: 1,
};
pub(super) const FUNCTION: Constant = Constant {
    id: 5,
    name: "FUNCTION",
    default: 0,
};
pub(super) const INDEXED: Constant = Constant {
    id: 6,
    name: "INDEXED",
    default: 0,
};

/// Words of a row of results, of which the kernel writes four.
pub(super) const ROW_WORDS: Constant = Constant {
    id: 7,
    name: "ROW_WORDS",
    default: 4,
};
/// The first of these four.
pub(super) const FIRST_COLUMN: Constant = Constant {
    id: 8,
    name: "FIRST_COLUMN",
    default: 0,
};
/// How many of them, from the first one on, are not written: the part before this one has.
pub(super) const SKIPPED: Constant = Constant {
    id: 9,
    name: "SKIPPED",
    default: 0,
};

/// Elements of a row of results, of which the kernel writes some.
pub(super) const ROW: Constant = Constant {
    id: 7,
    name: "ROW",
    default: 1,
};
/// Which part of the row it writes.
pub(super) const PART: Constant = Constant {
    id: 8,
    name: "PART",
    default: 0,
};

/// Rows of the coefficients of a pixel.
pub(super) const PIXEL_ROWS: Constant = Constant {
    id: 7,
    name: "PIXEL_ROWS",
    default: 1,
};

/// Which discrepancy.
pub(super) const KIND: Constant = Constant {
    id: 9,
    name: "KIND",
    default: pair_kind::CENTRED,
};
/// Whether distances are on the torus.
pub(super) const TOROIDAL: Constant = Constant {
    id: 10,
    name: "TOROIDAL",
    default: 1,
};

/// What a map kernel does.
pub(super) const TASK: Constant = Constant {
    id: 11,
    name: "TASK",
    default: task::SAMPLE,
};
/// Coordinates of a map's sample.
pub(super) const COORDINATES: Constant = Constant {
    id: 12,
    name: "COORDINATES",
    default: 3,
};

/// Which integrand.
pub(super) const INTEGRAND: Constant = Constant {
    id: 13,
    name: "INTEGRAND",
    default: integrand::X_SQUARED,
};

/// Points that one turn of a loop adds: turns cost some drivers dear.
pub(super) const SIDE_BY_SIDE: Constant = Constant {
    id: 14,
    name: "SIDE_BY_SIDE",
    default: 1,
};

pub(super) const RESULTS: Binding = Binding {
    binding: 0,
    name: "results",
    element: Element::Uvec4,
    input: false,
};
pub(super) const WIDE_RESULTS: Binding = Binding {
    element: Element::U64vec4,
    ..RESULTS
};
pub(super) const COLUMNS: Binding = Binding {
    binding: 1,
    name: "columns",
    element: Element::Uvec4,
    input: true,
};
/// What the places in a block contribute to permuted columns, one column after the other.
pub(super) const PLACES: Binding = Binding {
    binding: 1,
    name: "places",
    element: Element::Uint,
    input: true,
};
/// The columns of an estimate, of which the widest take ten rows.
pub(super) const FEW_COLUMNS: Binding = Binding {
    element: Element::Rows(10 * ESTIMATE_DIMENSIONS),
    ..COLUMNS
};
/// What the host says of an integrand: a row, and one for each dimension.
pub(super) const COEFFICIENTS: Binding = Binding {
    binding: 2,
    name: "coefficients",
    element: Element::Rows(1 + ESTIMATE_DIMENSIONS),
    input: true,
};
/// The same of any number of dimensions.
pub(super) const WIDE_COEFFICIENTS: Binding = Binding {
    element: Element::Uvec4,
    ..COEFFICIENTS
};
/// What it says in bulk: the texels and distribution of a map.
pub(super) const TABLES: Binding = Binding {
    binding: 3,
    name: "tables",
    element: Element::Uint,
    input: true,
};
pub(super) const POINTS: Binding = Binding {
    binding: 1,
    name: "points",
    element: Element::Uint,
    input: true,
};
pub(super) const ARGUMENTS: Binding = Binding {
    binding: 1,
    name: "arguments",
    element: Element::Uvec4,
    input: true,
};

pub(super) const WORK: &[Member] = WorkPush::MEMBERS;

pub(super) const MAP_ARGUMENTS: &[Member] = MapPush::MEMBERS;

pub(super) const ESTIMATE: &[Member] = EstimatePush::MEMBERS;
