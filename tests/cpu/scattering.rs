//! The scattering distributions: reference against the judge, pdf against samples, inverses,
//! extremes against multi-precision truth, and broken forms of each, which fail.

#[path = "scattering/accuracy.rs"]
mod accuracy;
#[path = "scattering/bend.rs"]
mod bend;
#[path = "scattering/chi.rs"]
mod chi;
#[path = "scattering/degenerate.rs"]
mod degenerate;
#[path = "scattering/energy.rs"]
mod energy;
#[path = "extreme.rs"]
mod extreme;
#[path = "scattering/extremes.rs"]
mod extremes;
#[path = "scattering/inverse.rs"]
mod inverse;
#[path = "scattering/lobes.rs"]
mod lobes;
mod significance;
