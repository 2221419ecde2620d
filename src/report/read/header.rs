//! The header of an `.npy` file: a Python dictionary of three entries.

use super::{Element, Refusal};
use crate::stats::Source;

/// What a header says.
pub(super) struct Header {
    pub element: Element,
    pub fortran: bool,
    pub shape: Vec<u64>,
}

/// Types that hold points: name, meaning, bytes.
const TYPES: [(&str, Source, usize); 3] = [
    ("u4", Source::U32, 4),
    ("f4", Source::F32, 4),
    ("f8", Source::F64, 8),
];

fn malformed(what: impl std::fmt::Display) -> Refusal {
    (
        format!("its header is malformed: {what}"),
        "write it again, with numpy.save or `corput generate`".to_owned(),
    )
}

/// Reads the dictionary.
pub(super) fn parse(text: &[u8]) -> Result<Header, Refusal> {
    let text = std::str::from_utf8(text).map_err(|_| malformed("it is not UTF-8"))?;
    let mut reader = Reader { rest: text };
    let (mut element, mut fortran, mut shape) = (None, None, None);
    reader.expect('{')?;
    while !reader.accept('}') {
        let key = reader.string()?;
        reader.expect(':')?;
        match key {
            "descr" => element = Some(reader.element()?),
            "fortran_order" => fortran = Some(reader.boolean()?),
            "shape" => shape = Some(reader.shape()?),
            other => return Err(malformed(format!("it has an entry `{other}`"))),
        }
        if !reader.accept(',') {
            reader.expect('}')?;
            break;
        }
    }
    if !reader.rest.trim().is_empty() {
        return Err(malformed("something follows the dictionary"));
    }
    let lacking = |key: &str| malformed(format!("it has no entry `{key}`"));
    Ok(Header {
        element: element.ok_or_else(|| lacking("descr"))?,
        fortran: fortran.ok_or_else(|| lacking("fortran_order"))?,
        shape: shape.ok_or_else(|| lacking("shape"))?,
    })
}

/// The text that is yet to be read.
struct Reader<'a> {
    rest: &'a str,
}

impl<'a> Reader<'a> {
    /// Whether this character follows, which is then read.
    fn accept(&mut self, wanted: char) -> bool {
        self.rest = self.rest.trim_start();
        match self.rest.strip_prefix(wanted) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn expect(&mut self, wanted: char) -> Result<(), Refusal> {
        if self.accept(wanted) {
            return Ok(());
        }
        let next = self.rest.chars().next();
        Err(malformed(match next {
            Some(c) => format!("`{c}` stands where `{wanted}` must"),
            None => format!("it ends where `{wanted}` must stand"),
        }))
    }

    /// A string without escapes, which no header needs.
    fn string(&mut self) -> Result<&'a str, Refusal> {
        let quote = if self.accept('"') {
            '"'
        } else {
            self.expect('\'')?;
            '\''
        };
        let (text, rest) = self
            .rest
            .split_once(quote)
            .ok_or_else(|| malformed("a string does not end"))?;
        self.rest = rest;
        Ok(text)
    }

    fn boolean(&mut self) -> Result<bool, Refusal> {
        self.rest = self.rest.trim_start();
        for (name, value) in [("True", true), ("False", false)] {
            if let Some(rest) = self.rest.strip_prefix(name) {
                self.rest = rest;
                return Ok(value);
            }
        }
        Err(malformed("fortran_order is neither True nor False"))
    }

    fn shape(&mut self) -> Result<Vec<u64>, Refusal> {
        let mut shape = Vec::new();
        self.expect('(')?;
        while !self.accept(')') {
            self.rest = self.rest.trim_start();
            let end = self.rest.find(|c: char| !c.is_ascii_digit());
            let (digits, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
            let size = digits
                .parse()
                .map_err(|_| malformed("a size in its shape is no number below 2^64"))?;
            shape.push(size);
            // Python 2 marked long integers.
            self.rest = rest.strip_prefix('L').unwrap_or(rest);
            if !self.accept(',') {
                self.expect(')')?;
                break;
            }
        }
        Ok(shape)
    }

    fn element(&mut self) -> Result<Element, Refusal> {
        let refused = |name: &str| {
            (
                format!(
                    "its values are of type {name}; points are of f4, f8 or u4 (fractions of 2^32)"
                ),
                "convert them: x.astype('f4'), or 'f8'".to_owned(),
            )
        };
        self.rest = self.rest.trim_start();
        if self.rest.starts_with('[') {
            return Err(refused("a record"));
        }
        let name = self.string()?;
        let big_endian = name.starts_with('>');
        let plain = name.strip_prefix(['<', '>']).unwrap_or("");
        match TYPES.iter().find(|(known, _, _)| *known == plain) {
            Some(&(_, source, size)) => Ok(Element {
                source,
                size,
                big_endian,
            }),
            None => Err(refused(&format!("'{name}'"))),
        }
    }
}
