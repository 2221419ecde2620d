//! Generators of rank-1 lattices: a vector for sequences in base 2, and Korobov's.

use std::fmt::Write;

/// The generating vector `exod2_base2_m20_CKN` of Cools, Kuo and Nuyens 2006, Constructing
/// embedded lattice rules for multivariate integration, SIAM J. Sci. Comput. 28(6), as in
/// Nuyens's Magic Point Shop: embedded in base 2 up to 2^20 points, for the unanchored Sobolev
/// space with weights of order 2, so all pairs of dimensions count.
const VECTOR: [u32; 250] = [
    1, 182_667, 469_891, 498_753, 110_745, 446_247, 250_185, 118_627, 245_333, 283_199, 408_519,
    391_023, 246_327, 126_539, 399_185, 461_527, 300_343, 69_681, 516_695, 436_179, 106_383,
    238_523, 413_283, 70_841, 47_719, 300_129, 113_029, 123_925, 410_745, 211_325, 17_489, 511_893,
    40_767, 186_077, 519_471, 255_369, 101_819, 243_573, 66_189, 152_143, 503_455, 113_217,
    132_603, 463_967, 297_717, 157_383, 224_015, 502_917, 36_237, 94_049, 170_665, 79_397, 123_963,
    223_451, 323_871, 303_633, 98_567, 318_855, 494_245, 477_137, 177_975, 64_483, 26_695, 88_779,
    94_497, 239_429, 381_007, 110_205, 339_157, 73_397, 407_559, 181_791, 442_675, 301_397, 32_569,
    147_737, 189_949, 138_655, 350_241, 63_371, 511_925, 515_861, 434_045, 383_435, 249_187,
    492_723, 479_195, 84_589, 99_703, 239_831, 269_423, 182_241, 61_063, 130_789, 143_095, 471_209,
    139_019, 172_565, 487_045, 304_803, 45_669, 380_427, 19_547, 425_593, 337_729, 237_863,
    428_453, 291_699, 238_587, 110_653, 196_113, 465_711, 141_583, 224_183, 266_671, 169_063,
    317_617, 68_143, 291_637, 263_355, 427_191, 200_211, 365_773, 254_701, 368_663, 248_047,
    209_221, 279_201, 323_179, 80_217, 122_791, 316_633, 118_515, 14_253, 129_509, 410_941,
    402_601, 511_437, 10_469, 366_469, 463_959, 442_841, 54_641, 44_167, 19_703, 209_585, 69_037,
    33_317, 433_373, 55_879, 245_295, 10_905, 468_881, 128_617, 417_919, 45_067, 442_243, 359_529,
    51_109, 290_275, 168_691, 212_061, 217_775, 405_485, 313_395, 256_763, 152_537, 326_437,
    332_981, 406_755, 423_147, 412_621, 362_019, 279_679, 169_189, 107_405, 251_851, 5413, 316_095,
    247_945, 422_489, 2555, 282_267, 121_027, 369_319, 204_587, 445_191, 337_315, 322_505, 388_411,
    102_961, 506_099, 399_801, 254_381, 452_545, 309_001, 147_013, 507_865, 32_283, 320_511,
    264_647, 417_965, 227_069, 341_461, 466_581, 386_241, 494_585, 201_479, 151_243, 481_337,
    68_195, 75_401, 58_359, 448_107, 459_499, 9873, 365_117, 350_845, 181_873, 7917, 436_695,
    43_899, 348_367, 423_927, 437_399, 385_089, 21_693, 268_793, 49_257, 250_211, 125_071, 341_631,
    310_163, 94_631, 108_795, 21_175, 142_847, 383_599, 71_105, 65_989, 446_433, 177_457, 107_311,
    295_679, 442_763, 40_729, 322_721, 420_175, 430_359, 480_757,
];

/// The generating vector of the lattice sequence: 250 odd numbers below 2^20, one per
/// dimension. More than 2^20 points are still a lattice, but no longer the optimised one.
///
/// Source: Cools, Kuo and Nuyens 2006, SIAM J. Sci. Comput. 28(6), 2162-2188.
#[must_use]
pub fn lattice_vector() -> &'static [u32] {
    &VECTOR
}

/// Korobov generators: the number of points N, a prime, and a, a primitive root modulo N. The
/// lattice is (1, a, a^2, ...) mod N.
///
/// Source: L'Ecuyer and Lemieux 2000, Variance reduction via lattice rules, Management Science
/// 46(9). A test holds each to what they were chosen for: in the plane of the first
/// coordinate with any of the next 23, the distance of the nearest points is at least 0.29 of
/// the largest that a lattice of N points can have.
pub const KOROBOV: &[(u32, u32)] = &[
    (1021, 76),
    (2039, 1487),
    (4093, 1516),
    (8191, 5130),
    (16_381, 4026),
    (32_749, 14_251),
    (65_521, 8950),
];

/// The text of `shaders/corput/lattice_vector.glsl`; a test compares the committed file.
#[must_use]
pub fn lattice_vector_glsl() -> String {
    let mut text = String::from(
        "// what:   a generating vector of lattice sequences in base 2, embedded up to 2^20 points.\n\
         // source: Cools, Kuo and Nuyens 2006, Constructing embedded lattice rules for\n\
         //         multivariate integration, SIAM J. Sci. Comput. 28(6), exod2_base2_m20;\n\
         //         generated from src/tables/lattice.rs.\n\
         // domain: 0 to 249. range: odd numbers below 2^20; 0 past the table.\n\
         // cost:   one lookup in a constant array; engines that need few dimensions copy theirs.\n\
         // hooks:  none.\n\
         // mirror: src/reference/lattice_vector.rs\n\
         #ifndef CORPUT_LATTICE_VECTOR_GLSL\n\
         #define CORPUT_LATTICE_VECTOR_GLSL\n\n\
         const uint CORPUT_LATTICE_VECTOR[250] = uint[250](\n",
    );
    let rows = VECTOR.chunks(10);
    let last = rows.len() - 1;
    for (i, row) in rows.enumerate() {
        let row: Vec<String> = row.iter().map(|z| format!("{z}u")).collect();
        let end = if i == last { "" } else { "," };
        // Writing to a String cannot fail.
        let _ = writeln!(text, "    {}{end}", row.join(", "));
    }
    text.push_str(
        ");\n\n\
         // The generator of a dimension: corput_lattice_vector(0) = 1.\n\
         uint corput_lattice_vector(uint index) {\n    \
             return index < 250u ? CORPUT_LATTICE_VECTOR[index] : 0u;\n\
         }\n\n\
         #endif\n",
    );
    text
}
