//! The scattering distributions: reference against the judge, pdf against samples, inverses,
//! and broken forms of each, which fail.

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
#[path = "scattering/inverse.rs"]
mod inverse;
#[path = "scattering/lobes.rs"]
mod lobes;
mod significance;
