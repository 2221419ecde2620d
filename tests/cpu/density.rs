//! Every map against its density: the integral of the pdf, and samples against both the
//! judge's inverse and the judge's pdf, a million for the first three parameter sets of a map
//! and a hundred thousand for the others; moments, half-spaces, and the mean of 1/pdf; and broken
//! maps and densities, which each of these refuses. Environment maps, whose density is of texels, have their own in environment.rs.

#[path = "density/agree.rs"]
mod agree;
#[path = "density/broken.rs"]
mod broken;
#[path = "density/chi.rs"]
mod chi;
#[path = "density/laws.rs"]
mod laws;
#[path = "density/line.rs"]
mod line;
#[path = "density/lobes.rs"]
mod lobes;
#[path = "density/moments.rs"]
mod moments;
#[path = "density/plane.rs"]
mod plane;
#[path = "density/quadrature.rs"]
mod quadrature;
#[path = "density/reciprocal.rs"]
mod reciprocal;
mod significance;
#[path = "density/solid.rs"]
mod solid;
