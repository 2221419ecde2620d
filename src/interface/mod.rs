//! Layouts shared by Rust and GLSL, declared once: push constants, bindings,
//! specialization constants and the list of compiled kernels.
//!
//! `build.rs` includes this file, writes [`Kernel::glsl`] as the include
//! `"interface.glsl"` of each kernel and compiles it; a test compares the tables with
//! what the SPIR-V says.

mod column;
mod family;
mod kernel;
mod kernels;
mod push;

pub use column::{Column, DigitScramble, Generator, NetScramble, purpose};
pub use family::{COLUMN_STRIDE, FAMILIES, Family, Word, column_kind};
pub use kernel::{Binding, Constant, Element, KINDS, Kernel, Profile};
pub use kernels::KERNELS;
pub use push::{
    EstimatePush, IrradiancePush, MapPush, MaskPush, Member, PairsPush, PushConstants, ReducePush,
    WorkPush,
};

/// Parameters of a map: bits of floats.
pub const MAP_PARAMETERS: usize = 16;

/// Dimensions of an integrand whose words uniform blocks hold; more take a kernel that reads
/// them from storage buffers.
pub const ESTIMATE_DIMENSIONS: u32 = 64;

/// Words of a map's tables that one buffer holds: 128 MiB, which every device allows.
pub const TABLE_WORDS: usize = 1 << 25;

/// Evaluations of an invocation that measures the speed of a function.
pub const REPEATS: u32 = 64;

/// Values of the constant `OUTPUT`.
pub mod output {
    /// u0.32 fractions.
    pub const FRACTIONS: u32 = 0;
    /// f32 in [0, 1).
    pub const FLOATS: u32 = 1;
}

/// Values of the constant `TASK`: what a map kernel does with its input. The kernels of
/// elementary functions know the first and the last two.
pub mod task {
    /// Fractions to samples and their pdf.
    pub const SAMPLE: u32 = 0;
    /// Samples to their pdf.
    pub const PDF: u32 = 1;
    /// Samples to the fractions that give them.
    pub const INVERT: u32 = 2;
    /// Parameters to what the others take of them, where the host prepares that.
    pub const PREPARE: u32 = 3;
    /// Samples of fractions that the kernel makes, [`REPEATS`](super::REPEATS) an invocation
    /// and folded into one: to measure their speed.
    pub const REPEAT: u32 = 4;
    /// The same loop without the samples.
    pub const BARE: u32 = 5;
}

/// Values of the constant `MAP`, by group of maps.
pub mod map {
    /// Unit disk, concentric.
    pub const CONCENTRIC_DISK: u32 = 0;
    /// Unit disk, polar.
    pub const POLAR_DISK: u32 = 1;
    /// Hemisphere, uniform.
    pub const UNIFORM_HEMISPHERE: u32 = 2;
    /// Hemisphere, cosine-weighted, concentric.
    pub const COSINE_HEMISPHERE: u32 = 3;
    /// Hemisphere, cosine-weighted, polar.
    pub const COSINE_HEMISPHERE_POLAR: u32 = 4;

    /// Triangle in the plane.
    pub const TRIANGLE: u32 = 16;
    /// Regular polygon.
    pub const REGULAR_POLYGON: u32 = 17;
    /// Annulus.
    pub const ANNULUS: u32 = 18;

    /// Sphere.
    pub const UNIFORM_SPHERE: u32 = 32;
    /// Cone.
    pub const CONE: u32 = 33;
    /// Spherical triangle.
    pub const SPHERICAL_TRIANGLE: u32 = 34;
    /// Spherical rectangle.
    pub const SPHERICAL_RECTANGLE: u32 = 35;
    /// Sphere seen from outside or within.
    pub const SPHERE_LIGHT: u32 = 36;
    /// Disk, by its area.
    pub const DISK_LIGHT: u32 = 37;
    /// Power of the cosine.
    pub const COSINE_POWER_HEMISPHERE: u32 = 38;

    /// Henyey and Greenstein's phase function.
    pub const HENYEY_GREENSTEIN: u32 = 64;
    /// GGX, reflection at visible normals.
    pub const GGX_VNDF: u32 = 65;
    /// GGX, visible normals.
    pub const GGX_VNDF_NORMAL: u32 = 66;
    /// GGX, reflection by spherical caps.
    pub const GGX_VNDF_CAP: u32 = 67;
    /// GGX, reflection by bounded caps.
    pub const GGX_VNDF_BOUNDED: u32 = 68;
    /// Beckmann, normals.
    pub const BECKMANN_NORMAL: u32 = 69;
    /// Beckmann, reflection.
    pub const BECKMANN: u32 = 70;

    /// Free flight.
    pub const EXPONENTIAL: u32 = 96;
    /// Normal distribution.
    pub const GAUSSIAN: u32 = 97;
    /// Two normal distributions by quantiles.
    pub const NORMAL_PAIR: u32 = 98;
    /// Two normal distributions by the polar method.
    pub const BOX_MULLER: u32 = 99;
    /// Pixel filter: box.
    pub const FILTER_BOX: u32 = 100;
    /// Pixel filter: tent.
    pub const FILTER_TENT: u32 = 101;
    /// Pixel filter: truncated Gaussian.
    pub const FILTER_GAUSSIAN: u32 = 102;
    /// Pixel filter: the window of Blackman and Harris.
    pub const FILTER_BLACKMAN_HARRIS: u32 = 103;
    /// Pixel filter: the magnitude of Mitchell and Netravali's.
    pub const FILTER_MITCHELL: u32 = 104;
    /// Environment map, hierarchical.
    pub const ENVIRONMENT: u32 = 128;
    /// Environment map, by an alias table.
    pub const ENVIRONMENT_ALIAS: u32 = 129;
}

/// Values of the constant `INTEGRAND` that a group of integrands has, which share a kernel.
pub const INTEGRANDS_OF_GROUP: u32 = 64;

/// Values of the constant `INTEGRAND`, by group.
pub mod integrand {
    /// x^2.
    pub const X_SQUARED: u32 = 0;
    /// A number and x.
    pub const OFFSET: u32 = 1;
    /// 1/sqrt(x).
    pub const INVERSE_ROOT: u32 = 2;
    /// Step at the unit circle.
    pub const DISK_STEP: u32 = 3;
    /// Checkerboard.
    pub const CHECKERBOARD: u32 = 4;
    /// Ishigami's function.
    pub const ISHIGAMI: u32 = 5;
    /// Genz, oscillatory.
    pub const OSCILLATORY: u32 = 6;
    /// Genz, product peak.
    pub const PRODUCT_PEAK: u32 = 7;
    /// Genz, corner peak.
    pub const CORNER_PEAK: u32 = 8;
    /// Genz, Gaussian.
    pub const GAUSSIAN: u32 = 9;
    /// Genz, continuous.
    pub const CONTINUOUS: u32 = 10;
    /// Genz, discontinuous.
    pub const DISCONTINUOUS: u32 = 11;
    /// Sobol's g.
    pub const SOBOL_G: u32 = 12;
    /// Gaussian peak, by uniform points.
    pub const PEAK_UNIFORM: u32 = 13;
    /// By points of its normal distribution.
    pub const PEAK_NORMAL: u32 = 14;
    /// Keister's function.
    pub const KEISTER: u32 = 15;
    /// Square of the sum of all coordinates.
    pub const SQUARE_OF_SUM: u32 = 16;
    /// Product of linear factors.
    pub const PRODUCT: u32 = 17;

    /// Irradiance of a map, by uniform directions.
    pub const IRRADIANCE_UNIFORM: u32 = 64;
    /// By cosine-weighted ones.
    pub const IRRADIANCE_COSINE: u32 = 65;
    /// By the light of the map.
    pub const IRRADIANCE_ENVIRONMENT: u32 = 66;
    /// By half of each of the last two.
    pub const IRRADIANCE_MIS: u32 = 67;

    /// Irradiance of a sky, by uniform directions.
    pub const SKY_UNIFORM: u32 = 128;
    /// By cosine-weighted ones.
    pub const SKY_COSINE: u32 = 129;
    /// Irradiance of a spherical triangle, by uniform directions.
    pub const POLYGON_UNIFORM: u32 = 132;
    /// By cosine-weighted ones.
    pub const POLYGON_COSINE: u32 = 133;
    /// By its own.
    pub const POLYGON_LIGHT: u32 = 134;
    /// By half of each of the last two.
    pub const POLYGON_MIS: u32 = 135;
    /// White furnace of GGX, by uniform directions.
    pub const FURNACE_UNIFORM: u32 = 136;
    /// By cosine-weighted ones.
    pub const FURNACE_COSINE: u32 = 137;
    /// By visible normals.
    pub const FURNACE_VISIBLE: u32 = 138;
    /// Edge in a circle of confusion, by points of a square.
    pub const LENS_SQUARE: u32 = 140;
    /// By the polar map.
    pub const LENS_POLAR: u32 = 141;
    /// By the concentric map.
    pub const LENS_CONCENTRIC: u32 = 142;
    /// Single scattering, by uniform distances and directions.
    pub const SCATTERING_UNIFORM: u32 = 144;
    /// By free flight and phase function.
    pub const SCATTERING_PHASE: u32 = 145;
    /// Sphere behind an edge, by uniform directions.
    pub const SHADOW_UNIFORM: u32 = 148;
    /// By cosine-weighted ones.
    pub const SHADOW_COSINE: u32 = 149;
    /// By those of the light.
    pub const SHADOW_LIGHT: u32 = 150;
    /// By half of each of the last two.
    pub const SHADOW_MIS: u32 = 151;
    /// Spherical light on GGX, by uniform directions.
    pub const LOBE_UNIFORM: u32 = 152;
    /// By visible normals.
    pub const LOBE_GGX: u32 = 153;
    /// By directions of the light.
    pub const LOBE_LIGHT: u32 = 154;
    /// By half of each of the last two.
    pub const LOBE_MIS: u32 = 155;
    /// Edge in a pixel, by uniform points of the filter's square.
    pub const PIXEL_UNIFORM: u32 = 156;
    /// By the filter.
    pub const PIXEL_FILTER: u32 = 157;
}

/// Values of the constant `KIND` of `pairs`.
pub mod pair_kind {
    /// L2-star.
    pub const STAR: u32 = 0;
    /// Centred.
    pub const CENTRED: u32 = 1;
    /// Wrap-around.
    pub const WRAP_AROUND: u32 = 2;
    /// Mixture.
    pub const MIXTURE: u32 = 3;
    /// Modified L2.
    pub const MODIFIED: u32 = 4;
}
