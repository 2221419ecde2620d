//! What cells of 2^-32 do to an integrand that jumps or has a pole.

use super::Problem;

/// A cell's side.
const CELL: f64 = 1.0 / 4_294_967_296.0;

impl Problem {
    /// An upper bound of what is left of the mean's error, beyond a change in proportion to the
    /// cells, where all points of a cell of 2^-32 stand for its corner: each jump that a line
    /// along an axis meets may lie anywhere in its cell, and jumps to and fro cancel; a pole is
    /// known. 0 where the integrand is continuous, and of maps, whose texels are not looked at.
    #[must_use]
    pub fn roughness(&self) -> f64 {
        let peak = self.coefficients().peak;
        let dimensions = f64::from(self.dimensions());
        let first = self.values().first().copied().unwrap_or(0.0);
        let edges = match (self.integrand().name, self.estimator()) {
            // Over all cells, by their middle: (1 - sqrt 2) zeta(1/2) 2^-16.
            ("inverse-root", _) => return 9.24e-6,
            ("disk-step", _) => 1.0,
            ("checkerboard", _) => 0.5 * first * dimensions,
            ("genz-discontinuous", _) => dimensions,
            // A peak outside which nothing is evaluated, and directions that may miss a light.
            ("gaussian-peak", Some("normal"))
            | ("polygon-irradiance" | "ggx-lobe", Some("uniform" | "cosine" | "ggx" | "mis"))
            | ("soft-shadow" | "pixel-edge" | "defocus-disk", _) => 2.0,
            _ => 0.0,
        };
        edges * CELL * peak
    }
}
