//! The maps over the reference: sample, pdf and inverse, as the map kernels have them.

mod hemisphere;
        Group::Scattering => scattering::invert(profile, id, p, s),
