//! Layouts shared by Rust and GLSL, declared once: push constants, bindings,
//! specialization constants and the list of compiled kernels.
//!
//! `build.rs` includes this file, writes [`Kernel::glsl`] as the include
//! `"interface.glsl"` of each kernel and compiles it; a test compares the tables with
//! what the SPIR-V says.

mod column;
mod family;
mod kernels;

pub use column::{Column, DigitScramble, Generator, NetScramble, purpose};
pub use family::{COLUMN_STRIDE, FAMILIES, Family, Word, column_kind};
pub use kernels::KERNELS;

use std::fmt::Write;

/// A push-constant member: a `uint` of the shader and a `u32` of the struct.
#[derive(Clone, Copy, Debug)]
pub struct Member {
    /// Name in both languages.
    pub name: &'static str,
    /// Byte offset in the block.
    pub offset: usize,
    /// What it means.
    pub doc: &'static str,
}

/// A struct that is also a push-constant block.
pub trait PushConstants: Copy {
    /// Members in order.
    const MEMBERS: &'static [Member];
}

macro_rules! push_constants {
    ($(#[doc = $struct_doc:literal])* $name:ident { $($(#[doc = $doc:literal])* $member:ident),* $(,)? }) => {
        $(#[doc = $struct_doc])*
        #[repr(C)]
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct $name { $($(#[doc = $doc])* pub $member: u32),* }

        impl PushConstants for $name {
            const MEMBERS: &'static [Member] = &[$(Member {
                name: stringify!($member),
                offset: core::mem::offset_of!($name, $member),
                doc: concat!($($doc),*),
            }),*];
        }

        impl $name {
            /// The block's bytes, as `vkCmdPushConstants` takes them.
            #[must_use]
            pub fn bytes(&self) -> Vec<u8> {
                [$(self.$member),*].iter().flat_map(|word| word.to_ne_bytes()).collect()
            }
        }

        const _: () = assert!(core::mem::size_of::<$name>() <= 128, "Vulkan guarantees 128 bytes");
    };
}

push_constants! {
    /// Arguments of the kernels that generate, map or evaluate.
    WorkPush {
        /// Index of the first point.
        first,
        /// Invocations that have work; the rest return.
        invocations,
        /// Distance of successive inputs, for kernels that make their inputs.
        stride,
    }
}

push_constants! {
    /// Arguments of the kernels that map points in memory.
    MapPush {
        /// Invocations that have work, four points each.
        invocations,
        /// Parameters of the map: bits of floats.
        p0,
        /// The second.
        p1,
        /// The third.
        p2,
        /// The fourth.
        p3,
        /// The fifth.
        p4,
        /// The sixth.
        p5,
        /// The seventh.
        p6,
        /// The eighth.
        p7,
        /// The ninth.
        p8,
        /// The tenth.
        p9,
        /// The eleventh.
        p10,
        /// The twelfth.
        p11,
        /// The thirteenth.
        p12,
        /// The fourteenth.
        p13,
        /// The fifteenth.
        p14,
        /// The sixteenth.
        p15,
    }
}

/// Parameters of a map: bits of floats.
pub const MAP_PARAMETERS: usize = 16;

/// Words of a map's tables that one buffer holds: 128 MiB, which every device allows.
pub const TABLE_WORDS: usize = 1 << 25;

impl MapPush {
    /// The block for so many invocations of a map with these parameters.
    #[must_use]
    pub fn new(invocations: u32, parameters: &[u32; MAP_PARAMETERS]) -> Self {
        let [
            p0,
            p1,
            p2,
            p3,
            p4,
            p5,
            p6,
            p7,
            p8,
            p9,
            p10,
            p11,
            p12,
            p13,
            p14,
            p15,
        ] = *parameters;
        Self {
            invocations,
            p0,
            p1,
            p2,
            p3,
            p4,
            p5,
            p6,
            p7,
            p8,
            p9,
            p10,
            p11,
            p12,
            p13,
            p14,
            p15,
        }
    }
}

push_constants! {
    /// Arguments of the irradiance kernel.
    IrradiancePush {
        /// Index of the first point.
        first,
        /// Points in all.
        count,
        /// Invocations, each of which sums the points congruent to it.
        invocations,
        /// Axis of the normal: 0 +x, 1 -x, 2 +y, 3 -y, 4 +z, 5 -z.
        axis,
        /// Columns of the map.
        width,
        /// Rows of the map.
        height,
        /// Radiance is summed in units of 2^-scale.
        scale,
    }
}

push_constants! {
    /// Arguments of the kernels that estimate.
    EstimatePush {
        /// Index of the first point.
        first,
        /// Points in all.
        count,
        /// Points of an invocation; the last may have fewer.
        run,
        /// Invocations that have work.
        invocations,
        /// Terms are in units of 2^-scale; a signed number.
        scale,
    }
}

push_constants! {
    /// Arguments of the kernels over pairs of points.
    PairsPush {
        /// First point of the invocations, one each.
        first_row,
        /// Invocations.
        rows,
        /// First of the other points.
        first_other,
        /// End of the other points.
        end_other,
        /// Points in all.
        count,
        /// Coordinates of a point.
        dimensions,
        /// Products are in units of 2^-scale.
        scale,
    }
}

push_constants! {
    /// Arguments of the void-and-cluster kernel.
    MaskPush {
        /// Columns of a frame.
        width,
        /// Rows of a frame.
        height,
        /// Frames.
        frames,
        /// Rows of a frame that a change reaches.
        span,
        /// Energies in the table, by squared distance.
        terms,
        /// Pixels to toggle, one after the other.
        passes,
        /// Bit 0: whether even passes take a pixel away; bit 1: whether odd ones do.
        removes,
        /// Rank of the first.
        rank,
        /// Added to the rank after each pass; 0 ranks nothing, and stops at a pixel that
        /// returns to its place.
        rank_step,
    }
}

/// What an std430 array holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// `uint`, 4 bytes.
    Uint,
    /// `uvec4`, 16 bytes.
    Uvec4,
}

/// A storage buffer in set 0.
#[derive(Clone, Copy, Debug)]
pub struct Binding {
    /// Its number.
    pub binding: u32,
    /// The array's name.
    pub name: &'static str,
    /// The array's element.
    pub element: Element,
    /// Whether the kernel only reads it, which also lets the validation layer see
    /// hazards.
    pub input: bool,
}

/// A specialization constant of type `uint`.
#[derive(Clone, Copy, Debug)]
pub struct Constant {
    /// Its `constant_id`.
    pub id: u32,
    /// Its name.
    pub name: &'static str,
    /// Its value where none is given.
    pub default: u32,
}

/// One compiled module.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    /// Name of the module.
    pub name: &'static str,
    /// File in `shaders/kernels/`.
    pub source: &'static str,
    /// Macros; only where bindings, types or the profile differ.
    pub defines: &'static [(&'static str, &'static str)],
    /// Invocations per workgroup: at most 128, which every device has.
    pub local_size: u32,
    /// Push-constant members.
    pub push: &'static [Member],
    /// Storage buffers.
    pub bindings: &'static [Binding],
    /// Specialization constants, besides those of the columns.
    pub constants: &'static [Constant],
    /// What columns it makes, and how many of them it takes as constants.
    pub columns: Option<(Family, u32)>,
    /// Which rules the linter holds it to.
    pub profile: Profile,
}

/// Which promises a module makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Profile {
    /// Tier I: integers and exactly representable floats.
    Integer,
    /// Tier F: float + - * besides, never contracted.
    Float,
    /// The device's own functions.
    Native,
    /// The start-up probe: what the device does with floats is what it asks.
    Probe,
}

impl Kernel {
    /// Bytes of the push-constant block.
    #[must_use]
    pub fn push_bytes(&self) -> u32 {
        4 * self.push.len() as u32
    }

    /// Every specialization constant: `constant_id`, name and default. Those of a column
    /// begin with `COLUMN` and its number.
    #[must_use]
    pub fn specialization(&self) -> Vec<(u32, String, u32)> {
        let own = self.constants.iter();
        let mut all: Vec<_> = own.map(|c| (c.id, c.name.to_owned(), c.default)).collect();
        if let Some((family, columns)) = self.columns {
            for column in 0..columns {
                let first = 16 + COLUMN_STRIDE * column;
                for (id, (name, default)) in (first..).zip(family.words()) {
                    all.push((id, format!("COLUMN{column}_{name}"), *default));
                }
            }
        }
        all
    }

    /// The GLSL of this interface: block, buffers, constants and the linear index of
    /// the invocation.
    #[must_use]
    pub fn glsl(&self) -> String {
        let mut text = String::new();
        // Writing to a String cannot fail.
        let _ = writeln!(text, "layout(local_size_x = {}) in;", self.local_size);
        for b in self.bindings {
            let element = match b.element {
                Element::Uint => "uint",
                Element::Uvec4 => "uvec4",
            };
            let _ = writeln!(
                text,
                "layout(std430, set = 0, binding = {}) {}buffer Buffer{} {{ {element} {}[]; }};",
                b.binding,
                if b.input { "readonly " } else { "" },
                b.binding,
                b.name
            );
        }
        if !self.push.is_empty() {
            text.push_str("layout(push_constant) uniform Push {\n");
            for m in self.push {
                let _ = writeln!(text, "    layout(offset = {}) uint {};", m.offset, m.name);
            }
            text.push_str("} push;\n");
        }
        for (id, name, default) in self.specialization() {
            let _ = writeln!(
                text,
                "layout(constant_id = {id}) const uint {name} = {default}u;"
            );
        }
        if let Some((family, _)) = self.columns {
            let _ = writeln!(text, "#define COLUMN_FAMILY {}", family.number());
            let _ = writeln!(text, "#define COLUMN_WORDS {}u", family.words().len());
        }
        // More groups than one axis holds are dispatched in two.
        let _ = writeln!(
            text,
            "uint kernel_invocation() {{\n    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x \
             + gl_WorkGroupID.x;\n    return group * {}u + gl_LocalInvocationID.x;\n}}",
            self.local_size
        );
        text
    }
}

/// Values of the constant `OUTPUT`.
pub mod output {
    /// u0.32 fractions.
    pub const FRACTIONS: u32 = 0;
    /// f32 in [0, 1).
    pub const FLOATS: u32 = 1;
}

/// Values of the constant `TASK`: what a map kernel does with its input.
pub mod task {
    /// Fractions to samples and their pdf.
    pub const SAMPLE: u32 = 0;
    /// Samples to their pdf.
    pub const PDF: u32 = 1;
    /// Samples to the fractions that give them.
    pub const INVERT: u32 = 2;
    /// Parameters to what the others take of them, where the host prepares that.
    pub const PREPARE: u32 = 3;
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
    /// Environment map, hierarchical.
    pub const ENVIRONMENT: u32 = 128;
    /// Environment map, by an alias table.
    pub const ENVIRONMENT_ALIAS: u32 = 129;
}

/// Values of the constant `INTEGRAND`.
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
