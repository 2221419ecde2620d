//! Tables with one wrong entry give wrong words: what tests compare with single values is seen
//! to differ.

use super::{Blocks, Finish, Form, Net, Philox};
use crate::bulk::column::Prepared;
use crate::bulk::points::STRIDE;
use crate::catalog::Output;
use crate::interface::{Column, DigitScramble, Generator, NetScramble};

/// Indices that are compared, across the first two blocks of each column.
const COUNT: usize = 10_000;

/// Words that differ from those of single values.
fn faults(column: &Column, made: &[u32]) -> usize {
    let column = Prepared::new(column);
    let wrong = |(n, word): (usize, &u32)| *word != column.fraction(n as u32);
    made.iter().enumerate().filter(|pair| wrong(*pair)).count()
}

fn made(blocks: &Blocks) -> Vec<u32> {
    let mut words = vec![0; COUNT];
    blocks.fill(0, &mut words);
    words
}

fn blocks(column: &Column) -> Blocks {
    Blocks::new(column, 1 << 32, 1, Finish::Fraction)
}

#[test]
fn a_wrong_bit_of_a_linear_table_shows() {
    for scramble in [
        NetScramble::None,
        NetScramble::Matrix,
        NetScramble::OwenHash,
    ] {
        let column = Column::Sobol {
            dimension: 3,
            gray: true,
            scramble,
            seed: [1, 2],
        };
        let mut blocks = blocks(&column);
        assert_eq!(faults(&column, &made(&blocks)), 0);
        let Form::Linear(linear) = &mut blocks.form else {
            panic!("{column:?} is linear");
        };
        linear.break_table(77);
        assert_eq!(faults(&column, &made(&blocks)), COUNT.div_ceil(1024));
    }
}

#[test]
fn a_wrong_entry_of_a_table_of_rows_shows() {
    let column = |dimension| Column::Sobol {
        dimension,
        gray: false,
        scramble: NetScramble::Shift,
        seed: [1, 2],
    };
    let columns = [column(1), column(2), column(3)];
    let mut net = Net::of(&columns, Finish::Fraction).unwrap();
    for broken in [false, true] {
        if broken {
            net.break_table(3 * 77 + 1);
        }
        let mut rows = vec![0; 3 * COUNT];
        net.fill(0, &mut rows);
        for (c, column) in columns.iter().enumerate() {
            let made: Vec<u32> = rows.iter().skip(c).step_by(3).copied().collect();
            let wrong = broken && c == 1;
            assert_eq!(faults(column, &made) > 0, wrong, "column {c}");
        }
    }
}

#[test]
fn a_wrong_entry_of_a_tile_shows() {
    let digits = |scramble| Column::Digits {
        base: 3,
        scramble,
        seed: 5,
    };
    for column in [
        Column::Radical(3),
        Column::Grid(1_000_003),
        digits(DigitScramble::Faure),
        digits(DigitScramble::Permuted),
        digits(DigitScramble::Started),
    ] {
        for remainder in [false, true] {
            let mut blocks = blocks(&column);
            assert_eq!(faults(&column, &made(&blocks)), 0);
            let Form::Tile(tile) = &mut blocks.form else {
                panic!("{column:?} is a tile");
            };
            tile.break_table(77, remainder);
            assert!(
                faults(&column, &made(&blocks)) > 0,
                "{column:?} {remainder}"
            );
        }
    }
}

#[test]
fn a_generator_of_another_block_shows() {
    let columns = [0, 1, 2, 3].map(|dimension| Column::Random {
        generator: Generator::Philox,
        dimension,
        dimensions: 4,
        seed: [1, 2],
    });
    for broken in [false, true] {
        let mut philox = Philox::of(&columns, Finish::Fraction).unwrap();
        if broken {
            philox.break_block();
        }
        let mut words = vec![0; 4 * STRIDE];
        philox.fill(0, 100, &mut words);
        for (column, words) in columns.iter().zip(words.chunks(STRIDE)) {
            let wrong = faults(column, &words[..100]);
            assert_eq!(wrong, if broken { 100 } else { 0 });
        }
    }
}

#[test]
fn a_column_without_tables_is_made_singly() {
    let column = Column::Pmj02 {
        dimension: 0,
        seed: [1, 2],
    };
    let blocks = Blocks::new(
        &column,
        100,
        1,
        Finish::of(&Prepared::new(&column), Output::Fractions),
    );
    assert!(matches!(blocks.form, Form::Single(_)));
    assert_eq!(faults(&column, &made(&blocks)), 0);
}
