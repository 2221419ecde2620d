//! What the kernels that make points are asked for.

use super::maps::examples;
use super::points::{Case, case};
use crate::Result;
use crate::catalog::{Map, Mapping, Options, Order, Scramble, Sequence, maps};

/// Options of a case, by the name of its row.
type Change<'a> = (String, Box<dyn Fn(&mut Options) + 'a>);

/// Every kernel with the columns, outputs and maps that it may have.
///
/// # Errors
/// None that these requests could cause.
pub fn cases() -> Result<Vec<Case>> {
    let mut cases = Vec::new();
    for kernel in ["generate", "tile"] {
        for fractions in [true, false] {
            let kind = if fractions { "u32" } else { "f32" };
            for (name, change) in radical(kernel).into_iter().chain(others()) {
                cases.push(case(format!("{name} {kind}"), kernel, |o| {
                    o.fractions = fractions;
                    change(o);
                })?);
            }
        }
    }
    wide(&mut cases)?;
    large(&mut cases)?;
    mapped(&mut cases)?;
    fused(&mut cases)?;
    Ok(cases)
}

/// All dimensions of the tables, at the first indices and at the last.
fn wide(cases: &mut Vec<Case>) -> Result<()> {
    let list = [
        (Sequence::Halton, Scramble::None, 1024, 1 << 32),
        (Sequence::Halton, Scramble::Faure, 1024, 1 << 32),
        (Sequence::Halton, Scramble::Owen, 1024, 1 << 32),
        (Sequence::Sobol, Scramble::None, 21_201, 1 << 32),
        (Sequence::Sobol, Scramble::Matrix, 21_201, 1 << 32),
        (Sequence::Sobol, Scramble::OwenHash, 21_201, 1 << 32),
        (Sequence::Lattice, Scramble::None, 250, 1 << 20),
    ];
    for (sequence, scramble, dimensions, end) in list {
        for first in [0, end - 8] {
            let name = format!(
                "{} {} d={dimensions} from {first}",
                sequence.name(),
                scramble.name()
            );
            cases.push(case(name, "generate", |o| {
                o.sequence = sequence;
                o.scramble = Some(scramble);
                o.dimensions = Some(dimensions);
                o.first = first;
                o.count = 8;
            })?);
        }
    }
    Ok(())
}

/// So many points that a device with 64-bit integers may have a kernel for them that stores eight
/// words at a time, which is checked where that is so.
fn large(cases: &mut Vec<Case>) -> Result<()> {
    let list: [(Sequence, Option<Scramble>, &[u64]); 10] = [
        (Sequence::VanDerCorput, None, &[1]),
        (Sequence::Hammersley, None, &[2, 3]),
        (Sequence::Sobol, None, &[1, 2, 3, 4, 8, 16]),
        (Sequence::Sobol, Some(Scramble::Matrix), &[2]),
        (Sequence::Sobol, Some(Scramble::OwenHash), &[2]),
        (Sequence::Random, None, &[1, 2, 3, 4]),
        (Sequence::RandomFast, None, &[4]),
        (Sequence::R2, None, &[1, 2, 3, 4]),
        (Sequence::Halton, None, &[2, 3, 4]),
        (Sequence::Halton, Some(Scramble::Permute), &[2, 3]),
    ];
    for (sequence, scramble, widths) in list {
        for &dimensions in widths {
            let scrambled = scramble.map_or(String::new(), |one| format!(" {}", one.name()));
            let name = format!("{}{scrambled} d={dimensions}, many", sequence.name());
            cases.push(case(name, "large", |o| {
                o.sequence = sequence;
                o.scramble = scramble;
                o.dimensions = (sequence != Sequence::VanDerCorput).then_some(dimensions);
            })?);
        }
    }
    cases.push(case("vdc base 3, many".into(), "large", |o| {
        o.sequence = Sequence::VanDerCorput;
        o.bases = Some(vec![3]);
    })?);
    Ok(())
}

/// Every map with its first parameters, as `generate` makes its samples.
fn mapped(cases: &mut Vec<Case>) -> Result<()> {
    for map in maps() {
        let Some(mapping) = examples(map)?.into_iter().next() else {
            continue;
        };
        let kernel = if map.group.fused() { "fused" } else { "map" };
        for with_pdf in [false, true] {
            let pdf = if with_pdf { " pdf" } else { "" };
            cases.push(case(format!("halton {}{pdf}", map.name), kernel, |o| {
                o.dimensions = Some(map.dimensions.into());
                o.map = Some(mapping.clone());
                o.with_pdf = with_pdf;
            })?);
        }
    }
    Ok(())
}

/// One map over points of every family.
fn fused(cases: &mut Vec<Case>) -> Result<()> {
    let list = [
        change("hammersley", |o| {
            o.sequence = Sequence::Hammersley;
            o.count = 1_000_003;
        }),
        change("halton 5,8161", |o| o.bases = Some(vec![5, 8161])),
        change("sobol owen", |o| {
            o.sequence = Sequence::Sobol;
            o.scramble = Some(Scramble::Owen);
        }),
        change("random", |o| o.sequence = Sequence::Random),
        change("stratified", |o| {
            o.sequence = Sequence::Stratified;
            o.count = 1_000_000;
        }),
        change("halton owen", |o| o.scramble = Some(Scramble::Owen)),
        change("r2", |o| o.sequence = Sequence::R2),
    ];
    let cosine = Mapping::new(Map::from_name("cosine-hemisphere")?, &[])?;
    for (name, change) in list {
        cases.push(case(format!("{name} cosine-hemisphere"), "fused", |o| {
            o.map = Some(cosine.clone());
            o.seed = Some(5);
            change(o);
        })?);
    }
    Ok(())
}

fn change<'a>(name: impl Into<String>, change: impl Fn(&mut Options) + 'a) -> Change<'a> {
    (name.into(), Box::new(change))
}

fn radical(kernel: &str) -> Vec<Change<'static>> {
    // Tiles are of one to four columns, or several of four, of which two may share some.
    let wide: &[u64] = if kernel == "tile" { &[7, 12] } else { &[17] };
    let mut list = vec![
        change("vdc", |o| o.sequence = Sequence::VanDerCorput),
        change("vdc base 3", |o| {
            o.sequence = Sequence::VanDerCorput;
            o.bases = Some(vec![3]);
        }),
        change("halton 2,251,8161", |o| o.bases = Some(vec![2, 251, 8161])),
        change("hammersley d=2", |o| o.sequence = Sequence::Hammersley),
        change("hammersley d=4, N=1000003", |o| {
            o.sequence = Sequence::Hammersley;
            o.dimensions = Some(4);
            o.count = 1_000_003;
        }),
    ];
    for &dimensions in [2, 3, 4].iter().chain(wide) {
        list.push(change(format!("halton d={dimensions}"), move |o| {
            o.dimensions = Some(dimensions);
        }));
    }
    if kernel == "tile" {
        list.push(change("sobol d=6 owen-hash", |o| {
            o.sequence = Sequence::Sobol;
            o.dimensions = Some(6);
            o.scramble = Some(Scramble::OwenHash);
            o.seed = Some(7);
        }));
    }
    list
}

/// Sets of a fixed number of points: one that is no power of two, and one near 2^32.
const SETS: [u64; 2] = [1_000_000, 4_294_836_225];

fn others() -> Vec<Change<'static>> {
    let mut list = Vec::new();
    let mut add = |name: String, sequence: Sequence, change_more: Box<dyn Fn(&mut Options)>| {
        list.push(change(name, move |o| {
            o.sequence = sequence;
            o.seed = Some(0x0123_4567_89ab_cdef);
            change_more(o);
        }));
    };
    for scramble in Sequence::Sobol.scrambles() {
        let name = format!("sobol d=4 {}", scramble.name());
        add(
            name,
            Sequence::Sobol,
            Box::new(|o| {
                o.dimensions = Some(4);
                o.scramble = Some(*scramble);
            }),
        );
    }
    add(
        "sobol d=3 gray matrix".into(),
        Sequence::Sobol,
        Box::new(|o| {
            o.dimensions = Some(3);
            o.order = Order::Gray;
            o.scramble = Some(Scramble::Matrix);
        }),
    );
    add("pmj02".into(), Sequence::Pmj02, Box::new(|_| {}));
    for scramble in &Sequence::Halton.scrambles()[1..] {
        let name = format!("halton 2,3,8161 {}", scramble.name());
        add(
            name,
            Sequence::Halton,
            Box::new(|o| {
                o.bases = Some(vec![2, 3, 8161]);
                o.scramble = Some(*scramble);
            }),
        );
    }
    for sequence in [Sequence::Random, Sequence::RandomFast, Sequence::Pcg32] {
        let name = format!("{} d=3", sequence.name());
        add(name, sequence, Box::new(|o| o.dimensions = Some(3)));
    }
    for count in SETS {
        for sequence in [
            Sequence::Stratified,
            Sequence::LatinHypercube,
            Sequence::MultiJittered,
        ] {
            let name = format!("{} N={count}", sequence.name());
            add(name, sequence, Box::new(move |o| o.count = count));
        }
    }
    for (name, scramble) in [("", Scramble::None), (" rotate", Scramble::Rotate)] {
        add(
            format!("lattice d=4{name}"),
            Sequence::Lattice,
            Box::new(move |o| {
                o.count = 1 << 20;
                o.dimensions = Some(4);
                o.scramble = Some(scramble);
            }),
        );
        add(
            format!("korobov N=65521{name}"),
            Sequence::Korobov,
            Box::new(move |o| {
                o.count = 65_521;
                o.scramble = Some(scramble);
            }),
        );
        add(
            format!("r2{name}"),
            Sequence::R2,
            Box::new(move |o| o.scramble = Some(scramble)),
        );
    }
    list
}
