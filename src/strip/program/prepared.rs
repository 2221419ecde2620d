//! Prepared parameters of maps as constants: structs of reals, from their words.

use super::literal::real;
use crate::catalog::Words;
use crate::reference::real::Real as Number;

/// The shape of a struct: how many reals it has, and of what parts.
enum Shape {
    Real,
    Struct(&'static str, &'static [Shape]),
}

use Shape::{Real, Struct};

const REAL3: Shape = Struct("CorputReal3", &[Real, Real, Real]);
const ARC: Shape = Struct("CorputArc", &[Real, Real]);
const FRAME: Shape = Struct("CorputRealFrame", &[REAL3, REAL3, REAL3]);
const TRIANGLE: Shape = Struct(
    "CorputSphericalTriangle",
    &[
        REAL3, REAL3, REAL3, ARC, ARC, ARC, Real, Real, REAL3, REAL3, REAL3, REAL3, Real,
    ],
);

/// The structs that the host prepares, by their names in GLSL.
const SHAPES: &[Shape] = &[
    TRIANGLE,
    Struct("CorputSphericalRectangle", &[TRIANGLE, TRIANGLE, Real]),
    Struct("CorputSphereLight", &[FRAME, Real, Real]),
    Struct("CorputDiskLight", &[REAL3, FRAME, Real, Real]),
    Struct("CorputFilterGaussian", &[Real, Real, Real, Real]),
];

/// A constructor of that struct, of words as `catalog::Words` puts them; zeros where there are
/// too few.
pub(super) fn constructor(name: &str, words: &[u32]) -> String {
    let shape = SHAPES
        .iter()
        .find(|shape| matches!(shape, Struct(known, _) if *known == name));
    let mut words = words.chunks_exact(2);
    shape.map_or_else(String::new, |shape| written(shape, &mut words))
}

fn written<'w>(shape: &Shape, words: &mut impl Iterator<Item = &'w [u32]>) -> String {
    match shape {
        Real => real(Number::of(words.next().unwrap_or_default())),
        Struct(name, parts) => {
            let parts: Vec<String> = parts.iter().map(|part| written(part, words)).collect();
            format!("{name}({})", parts.join(", "))
        }
    }
}
