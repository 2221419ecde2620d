//! Domains: where in a renderer a sample is drawn.
//!
//! Source: the domain tree of OpenQMC; Kollig and Keller 2002 for padding. Domain: every
//! value of every argument; a split's index is taken modulo 2^32. Range: 12 bytes, by
//! value.
//! Mirror: `shaders/corput/domain.glsl`.

use crate::reference::hash::{mix4, seed as derived_seed};
use glam::{UVec2, Vec4Swizzles, uvec4};

/// Which scrambled copy of a sequence is drawn from, and which of its points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Domain {
    /// The copy.
    pub pattern: UVec2,
    /// Index of the point.
    pub index: u32,
}

/// The domain of a pixel: its samples in one frame are the points 0, 1, 2, ... of one
/// copy, and any number of them from 0 on is well distributed as far as the sequence's
/// prefixes are.
#[inline]
#[must_use]
pub fn domain(pixel: UVec2, frame: u32, index: u32, seed: u32) -> Domain {
    let v = mix4(uvec4(pixel.x, pixel.y, frame, seed));
    Domain {
        pattern: v.xy(),
        index,
    }
}

/// The child for a purpose, such as the lens, the time, or the light at a hit: it draws
/// other dimensions than its siblings with other keys and than its parent.
#[inline]
#[must_use]
pub fn domain_child(parent: Domain, key: u32) -> Domain {
    let v = mix4(uvec4(parent.pattern.x, parent.pattern.y, key, 0));
    Domain {
        pattern: v.xy(),
        index: parent.index,
    }
}

/// The child where each sample splits into `size` ones, of which this is number `branch`,
/// such as shadow rays of a hit: all branches of all samples together are points 0, 1, 2,
/// ... of one copy.
#[inline]
#[must_use]
pub fn domain_split(parent: Domain, key: u32, size: u32, branch: u32) -> Domain {
    let child = domain_child(parent, key);
    Domain {
        pattern: child.pattern,
        index: child.index.wrapping_mul(size).wrapping_add(branch),
    }
}

/// The child for one link of a chain, such as a bounce of a path or a step through a
/// volume: every link draws from another copy, so their number need not be known.
#[inline]
#[must_use]
pub fn domain_chain(parent: Domain, key: u32, link: u32) -> Domain {
    let mut v = mix4(uvec4(parent.pattern.x, parent.pattern.y, key, 1));
    v = mix4(uvec4(v.x, v.y, link, 2));
    Domain {
        pattern: v.xy(),
        index: parent.index,
    }
}

/// A word for dimension d of the draw, different for every pattern.
#[inline]
#[must_use]
pub fn domain_seed(domain: Domain, d: u32) -> u32 {
    derived_seed(domain.pattern, d, 4)
}
