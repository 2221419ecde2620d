//! The first 1,024 primes, by trial division at compile time.

use std::fmt::Write;

/// The first 1,024 primes, 2 to 8161.
pub const PRIMES: [u32; 1024] = first_primes();

/// The last of [`PRIMES`], the largest base of a radical inverse here.
pub const LARGEST_PRIME: u32 = PRIMES[1023];

const fn first_primes() -> [u32; 1024] {
    let mut primes = [0; 1024];
    let mut found = 0;
    let mut candidate = 2;
    while found < 1024 {
        let mut i = 0;
        let mut prime = true;
        while prime && i < found && primes[i] * primes[i] <= candidate {
            prime = candidate % primes[i] != 0;
            i += 1;
        }
        if prime {
            primes[found] = candidate;
            found += 1;
        }
        candidate += 1;
    }
    primes
}

/// Whether n is prime, by trial division: at most 2^16 steps for n < 2^32.
#[must_use]
pub fn is_prime(n: u64) -> bool {
    n >= 2
        && (2..)
            .take_while(|d| d * d <= n)
            .all(|d| !n.is_multiple_of(d))
}

/// The prime of the table nearest to n; of two, the smaller.
#[must_use]
pub fn nearest_prime(n: u64) -> u64 {
    PRIMES
        .iter()
        .map(|&p| u64::from(p))
        .min_by_key(|p| p.abs_diff(n))
        .unwrap_or(2)
}

/// The text of `shaders/corput/primes.glsl`; a test compares the committed file.
#[must_use]
pub fn primes_glsl() -> String {
    let mut text = String::from(
        "// what:   the first 1,024 primes, the bases of the Halton sequence.\n\
         // source: trial division; generated from src/tables/primes.rs.\n\
         // domain: 0 to 1023. range: 2 to 8161; 0 past the table.\n\
         // cost:   one lookup in a constant array; engines that need few dimensions name\n\
         //         their primes in CORPUT_PRIME instead.\n\
         // hooks:  none.\n\
         // mirror: src/reference/primes.rs\n\
         #ifndef CORPUT_PRIMES_GLSL\n\
         #define CORPUT_PRIMES_GLSL\n\n\
         const uint CORPUT_PRIMES[1024] = uint[1024](\n",
    );
    for (i, row) in PRIMES.chunks(16).enumerate() {
        let row: Vec<String> = row.iter().map(|p| format!("{p}u")).collect();
        let end = if i == 63 { "" } else { "," };
        // Writing to a String cannot fail.
        let _ = writeln!(text, "    {}{end}", row.join(", "));
    }
    text.push_str(
        ");\n\n\
         // The prime with this index: corput_prime(0) = 2.\n\
         uint corput_prime(uint index) {\n    \
             return index < 1024u ? CORPUT_PRIMES[index] : 0u;\n\
         }\n\n\
         #endif\n",
    );
    text
}
