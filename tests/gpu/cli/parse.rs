//! Parsers and expectations that share nothing with the writers.

use corput::judge;

/// An array read back: words row by row.
#[derive(Debug, PartialEq)]
pub struct Array {
    pub kind: String,
    pub rows: usize,
    pub columns: usize,
    pub words: Vec<u32>,
}

impl Array {
    pub fn row(&self, row: usize) -> &[u32] {
        &self.words[row * self.columns..][..self.columns]
    }

    pub fn assert_is(&self, kind: &str, rows: usize, columns: usize) {
        assert_eq!(
            (&*self.kind, self.rows, self.columns),
            (kind, rows, columns)
        );
    }

    /// The elements as floats.
    pub fn floats(&self) -> impl Iterator<Item = f32> {
        assert_eq!(self.kind, "<f4");
        self.words.iter().map(|&word| f32::from_bits(word))
    }
}

/// Little-endian words.
pub fn words(bytes: &[u8]) -> Vec<u32> {
    let (words, rest) = bytes.as_chunks::<4>();
    assert!(rest.is_empty());
    words.iter().map(|word| u32::from_le_bytes(*word)).collect()
}

/// NumPy's format 1.0, in C order, with the data at byte 4096.
pub fn npy(bytes: &[u8]) -> Array {
    let (magic, rest) = bytes.split_at(8);
    assert_eq!(magic, b"\x93NUMPY\x01\x00");
    let length = usize::from(u16::from_le_bytes([rest[0], rest[1]]));
    assert_eq!(10 + length, 4096);
    let header = std::str::from_utf8(&rest[2..2 + length]).unwrap();
    let dictionary = header.strip_suffix('\n').unwrap().trim_end();
    let inner = dictionary.strip_prefix("{'descr': '").unwrap();
    let (kind, inner) = inner
        .split_once("', 'fortran_order': False, 'shape': (")
        .unwrap();
    let shape = inner.strip_suffix("), }").unwrap();
    let (rows, columns) = shape.split_once(", ").unwrap();
    let array = Array {
        kind: kind.to_owned(),
        rows: rows.parse().unwrap(),
        columns: columns.parse().unwrap(),
        words: words(&bytes[4096..]),
    };
    assert_eq!(array.words.len(), array.rows * array.columns);
    array
}

/// CSV with the header x0,x1,...: fields row by row.
pub fn csv(bytes: &[u8]) -> Vec<Vec<&str>> {
    let text = std::str::from_utf8(bytes).unwrap();
    assert!(text.ends_with('\n') && !text.contains('\r'));
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().unwrap();
    for (i, name) in header.iter().enumerate() {
        assert_eq!(*name, format!("x{i}"));
    }
    let rows: Vec<_> = lines.collect();
    assert!(rows.iter().all(|row| row.len() == header.len()));
    rows
}

/// What a column must hold.
#[derive(Clone, Copy, Debug)]
pub enum Column {
    /// The radical inverse in a base.
    Base(u32),
    /// k/N.
    Grid(u64),
}

impl Column {
    /// The fraction of 2^32 at index `n`, by 128-bit rationals.
    pub fn fraction(self, n: u32) -> u32 {
        let exact = match self {
            Self::Base(base) => judge::radical_inverse(n, base),
            Self::Grid(count) => judge::hammersley(n, count),
        };
        u32::try_from(exact).unwrap()
    }

    /// The float at index `n`, as bits: 24 bits, downwards in base 2 and else upwards,
    /// and never 1.
    pub fn float(self, n: u32) -> u32 {
        let scaled = f64::from(self.fraction(n)) / 256.0;
        let whole = match self {
            Self::Base(2) => scaled.floor(),
            _ => scaled.ceil().min(16_777_215.0),
        };
        ((whole / 16_777_216.0) as f32).to_bits()
    }
}

/// Compares rows spread over an array, and its ends, with the rationals.
pub fn assert_points(array: &Array, first: u64, columns: &[Column]) {
    assert_eq!(array.columns, columns.len());
    let step = (array.rows / 5000).max(1) | 1;
    let ends = array.rows.saturating_sub(100)..array.rows;
    for row in (0..array.rows.min(100))
        .chain((0..array.rows).step_by(step))
        .chain(ends)
    {
        let n = u32::try_from(first + row as u64).unwrap();
        let expected: Vec<u32> = columns
            .iter()
            .map(|column| match &*array.kind {
                "<u4" => column.fraction(n),
                _ => column.float(n),
            })
            .collect();
        assert_eq!(array.row(row), expected, "point {n} of {columns:?}");
    }
}
