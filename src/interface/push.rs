//! Push-constant blocks, as structs of the same members.

use super::MAP_PARAMETERS;

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
    /// Arguments of the kernel that sums floats.
    ReducePush {
        /// First of the terms.
        first,
        /// Terms.
        count,
        /// Terms of an invocation; the last run may be shorter.
        run,
        /// Runs.
        parts,
        /// Invocations that have work: one for each run and each window.
        invocations,
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
