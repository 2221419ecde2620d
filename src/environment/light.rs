//! What a texel weighs, and texels that are no light.

/// How a texel's colour becomes its weight.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Weight {
    /// 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709).
    #[default]
    Luminance,
    /// The largest of R, G and B.
    Max,
}

impl Weight {
    /// Of a colour whose channels are finite and at least 0.
    #[must_use]
    pub fn of(self, [r, g, b]: [f32; 3]) -> f64 {
        let [r, g, b] = [r, g, b].map(f64::from);
        match self {
            Self::Luminance => 0.2126 * r + 0.7152 * g + 0.0722 * b,
            Self::Max => r.max(g).max(b),
        }
    }
}

/// Texels with a channel that is no light, by kind; one may count in several.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Repairs {
    /// NaN.
    pub nan: u64,
    /// An infinity of either sign.
    pub infinite: u64,
    /// Less than 0 and finite.
    pub negative: u64,
    /// Positive, but below 2^-126, where devices may read 0.
    pub denormal: u64,
}

impl Repairs {
    /// Whether there was nothing to repair.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// The texel with 0 in place of each channel that is no light, which is counted.
    #[must_use]
    pub fn texel(&mut self, texel: [f32; 3]) -> [f32; 3] {
        // By far the most texels, in one test: +0 and normal numbers, by their bits.
        if texel
            .iter()
            .all(|l| l.to_bits() == 0 || (0x0080_0000..0x7f80_0000).contains(&l.to_bits()))
        {
            return texel;
        }
        let any = |wrong: fn(f32) -> bool| u64::from(texel.iter().any(|&l| wrong(l)));
        self.nan += any(f32::is_nan);
        self.infinite += any(f32::is_infinite);
        self.negative += any(|l| l < 0.0 && l.is_finite());
        self.denormal += any(|l| l > 0.0 && l.is_subnormal());
        texel.map(|l| if l.is_normal() && l > 0.0 { l } else { 0.0 })
    }
}

/// Sets to 0 each channel that is no light, as [`Environment::new`](super::Environment::new)
/// weighs it, and counts the texels that had one.
pub fn repair(texels: &mut [[f32; 3]]) -> Repairs {
    let mut repairs = Repairs::default();
    for texel in texels {
        *texel = repairs.texel(*texel);
    }
    repairs
}
