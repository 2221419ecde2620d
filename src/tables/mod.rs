//! Constants, declared once.

mod additive;
mod factors;
mod lattice;
mod primes;
mod sobol;

pub use additive::additive_alphas;
pub use factors::{composite_neighbours, nearly_equal_factors};
pub use lattice::{KOROBOV, lattice_vector, lattice_vector_glsl};
pub use primes::{LARGEST_PRIME, PRIMES, is_prime, nearest_prime, primes_glsl};
pub use sobol::{
    SOBOL_DIMENSIONS, SOBOL_GLSL_DIMENSIONS, sobol_directions, sobol_glsl, sobol_initial,
};
