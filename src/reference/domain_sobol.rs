//! Draws of four dimensions of the Sobol sequence from a domain.
//!
//! Source: Burley 2020; Owen 1995. Domain: every domain. Range: fractions of 2^32.
//! Mirror: `shaders/corput/domain_sobol.glsl`.

use crate::reference::domain::{Domain, domain_seed};
use crate::reference::owen::{owen, owen_hash};
use crate::reference::sobol::sobol;
use glam::{UVec4, uvec4};

/// Shuffled and scrambled by the fast hash; direction numbers of four dimensions, 32 each.
///
/// # Panics
/// If there are fewer than 128 direction numbers.
#[inline]
#[must_use]
pub fn draw_sobol(domain: Domain, directions: &[u32]) -> UVec4 {
    let n = owen_hash(domain.index, domain_seed(domain, 0));
    uvec4(
        owen_hash(sobol(n, &directions[..32]), domain_seed(domain, 1)),
        owen_hash(sobol(n, &directions[32..64]), domain_seed(domain, 2)),
        owen_hash(sobol(n, &directions[64..96]), domain_seed(domain, 3)),
        owen_hash(sobol(n, &directions[96..128]), domain_seed(domain, 4)),
    )
}

/// Shuffled and scrambled exactly; direction numbers of four dimensions, 32 each.
///
/// # Panics
/// If there are fewer than 128 direction numbers.
#[inline]
#[must_use]
pub fn draw_sobol_owen(domain: Domain, directions: &[u32]) -> UVec4 {
    let n = owen(domain.index, 4, domain.pattern);
    uvec4(
        owen(sobol(n, &directions[..32]), 0, domain.pattern),
        owen(sobol(n, &directions[32..64]), 1, domain.pattern),
        owen(sobol(n, &directions[64..96]), 2, domain.pattern),
        owen(sobol(n, &directions[96..128]), 3, domain.pattern),
    )
}
