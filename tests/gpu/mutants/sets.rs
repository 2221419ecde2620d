//! Pairs of points, dither masks and screen space.

use super::Killer::Mismatch;
use super::{Mutant, mutant};
use crate::harness::Target::{Function, Mask, Nearest, Pairs};

#[rustfmt::skip]
pub const MUTANTS: &[Mutant] = &[
    // Pairs of points.
    mutant("the lesser coordinate in L2-star", Mismatch, Pairs,
        "corput/discrepancy.glsl", "corput_scale64(p, max(x, y))", "corput_scale64(p, min(x, y))"),
    mutant("the centred kernel on the wrong side", Mismatch, Pairs,
        "corput/discrepancy.glsl", ">> 31) == 0u ? nearer", ">> 31) != 0u ? nearer"),
    mutant("3/2 for 5/4 in the wrap-around kernel", Mismatch, Pairs,
        "corput/discrepancy.glsl", "corput_add64(p, corput_shr64(p, 2u))", "corput_add64(p, corput_shr64(p, 1u))"),
    mutant("the mixture kernel without its square", Mismatch, Pairs,
        "corput/discrepancy.glsl", "corput_add64(corput_sub64(more, less), corput_shr64(twice, 1u))", "corput_sub64(more, less)"),
    mutant("the low word of a product is lost", Mismatch, Pairs,
        "corput/discrepancy.glsl", "uvec2(corput_mulhi(p.x, f), 0u)", "uvec2(0u)"),
    mutant("a sum of products overflows", Mismatch, Pairs,
        "kernels/pairs.comp", "high = corput_add64(high, uvec2(p.y, 0u));", "high.x += p.y;"),
    mutant("pairs twice in several blocks", Mismatch, Pairs,
        "kernels/pairs.comp", "other < push.end_other", "other < push.count"),
    mutant("a point is its own neighbour", Mismatch, Nearest,
        "kernels/nearest.comp", "max(push.first_other, row + 1u)", "max(push.first_other, row)"),
    mutant("a torus with one way around", Mismatch, Nearest,
        "corput/distance.glsl", "min(x - y, y - x)", "x - y"),
    mutant("a carry lost between squares", Mismatch, Nearest,
        "corput/distance.glsl", "corput_addc(middle.x, low.y)", "uvec2(middle.x, 0u)"),
    mutant("squares compared by their high words", Mismatch, Nearest,
        "corput/distance.glsl", "    return a.x < b.x;", "    return false;"),
    // Dither masks and screen space.
    mutant("ties to the highest row", Mismatch, Mask, "kernels/void_and_cluster.comp",
        "            atomicMin(best_row, best.y);
        }
        barrier();
        uint inverted = 0u - removes;
        for (uint x = lane; x < push.width; x += gl_WorkGroupSize.x) {
            uint at = best_row * push.width + x;",
        "            atomicMin(best_row, ~best.y);
        }
        barrier();
        uint inverted = 0u - removes;
        for (uint x = lane; x < push.width; x += gl_WorkGroupSize.x) {
            uint at = ~best_row * push.width + x;"),
    mutant("a mask does not wrap around", Mismatch, Mask,
        "kernels/void_and_cluster.comp", "return min(d, circumference - d);", "return d;"),
    mutant("the Gaussian is wider", Mismatch, Mask,
        "kernels/void_and_cluster.comp", "across * across + down * down", "(across * across + down * down) * 3u / 4u"),
    mutant("voids filled before clusters are thinned", Mismatch, Mask,
        "kernels/void_and_cluster.comp", "(push.removes >> (pass & 1u))", "(push.removes >> (~pass & 1u))"),
    mutant("an update skipped", Mismatch, Mask,
        "kernels/void_and_cluster.comp", "if (squared < push.terms)", "if (squared < push.terms && change.x + change.y != 5u)"),
    mutant("removal adds energy", Mismatch, Mask,
        "kernels/void_and_cluster.comp", "change.removed ? 0u - energies[squared] : energies[squared]", "energies[squared]"),
    mutant("the row above is not reached", Mismatch, Mask,
        "kernels/void_and_cluster.comp", "for (uint i = 0u; i < count; i++)", "for (uint i = 1u; i < count; i++)"),
    mutant("frames do not repel each other", Mismatch, Mask,
        "kernels/void_and_cluster.comp", "across == 0u ? distance * distance : push.terms", "push.terms"),
    mutant("the lower edge of a rank's part", Mismatch, Function("blue_noise"),
        "corput/blue_noise.glsl", "(2u * rank + 1u) << 15", "(2u * rank) << 15"),
    mutant("a mask's second digit forgotten", Mismatch, Function("blue_noise"),
        "corput/blue_noise.glsl", " + ((high % count) << 16) / count", ""),
    mutant("frames one row apart", Mismatch, Function("blue_noise"),
        "corput/blue_noise.glsl", "frame % size.z * size.y +", "frame % size.z +"),
    mutant("a shift not wrapped", Mismatch, Function("blue_noise_shift"),
        "corput/blue_noise.glsl", "uvec2(pixel.x % size.x +", "uvec2(pixel.x +"),
    mutant("x and y of the Z-order swapped", Mismatch, Function("screen_space"),
        "corput/screen_space.glsl", "corput_screen_space_spread(pixel.x) |", "corput_screen_space_spread(pixel.y) |"),
    mutant("digits shuffled without those above", Mismatch, Function("screen_space"),
        "corput/screen_space.glsl", "((code >> shift) >> 2) & ((1u << (2u * level)) - 1u)", "0u"),
    mutant("a permutation twice", Mismatch, Function("screen_space"),
        "corput/screen_space.glsl", "0xe4u, 0xb4u", "0xe4u, 0xe4u"),
];
