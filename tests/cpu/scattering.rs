//! The scattering distributions: reference against the judge, pdf against samples, inverses,
//! extremes against multi-precision truth, and broken forms of each, which fail.

#[path = "scattering/accuracy.rs"]
mod accuracy;
#[path = "scattering/lobes.rs"]
mod lobes;
