//! What the kernels that make points are asked for.

use super::points::{Case, case};
use crate::Result;
use crate::catalog::{MAPS, Options, Order, Scramble, Sequence};

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
    for (name, sequence, dimensions) in [
        ("halton d=1024 f32", Sequence::Halton, 1024),
        ("sobol d=21201 f32", Sequence::Sobol, 21_201),
        ("lattice d=250 f32", Sequence::Lattice, 250),
    ] {
        cases.push(case(name.into(), "generate", |o| {
            o.sequence = sequence;
            o.dimensions = Some(dimensions);
            o.count = 64;
        })?);
    }
    for map in MAPS {
        for with_pdf in [false, true] {
            let pdf = if with_pdf { " pdf" } else { "" };
            for kernel in ["fused", "map"] {
                let name = format!("halton {}{pdf}", map.name);
                cases.push(case(name, kernel, |o| {
                    o.map = Some(map);
                    o.with_pdf = with_pdf;
                })?);
            }
        }
    }
    fused(&mut cases)?;
    Ok(cases)
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
    for (name, change) in list {
        cases.push(case(format!("{name} cosine-hemisphere"), "fused", |o| {
            o.map = MAPS.first();
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
    // Tiles are of one to four columns, or several of four.
    let wide = if kernel == "tile" { 12 } else { 17 };
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
    for dimensions in [2, 3, 4, wide] {
        list.push(change(format!("halton d={dimensions}"), move |o| {
            o.dimensions = Some(dimensions);
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
