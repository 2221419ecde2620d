//! Kernels that make points: each against the reference, word for word.

use super::rows::Row;
use crate::Result;
use crate::bulk::Reference;
use crate::catalog::{Engine, Options, Request, Sequence};
use crate::interface::{Column, Family};
use crate::kernels::Generator;
use crate::vulkan::Device;
use std::sync::Arc;

/// A request and the kernel that is to run it.
#[derive(Clone, Debug)]
pub struct Case {
    /// What the row is called.
    pub name: String,
    /// `generate`, `tile`, `large` for the kernel that many points get, `fused`, or `map` for a map
    /// in a kernel of its own.
    pub kernel: &'static str,
    /// The points, all of the sequence where it has no end of its own.
    pub request: Request,
}

/// Points of a range: as much as one buffer holds of the widest case, and less of the
/// families whose points cost more.
pub(super) fn points(request: &Request) -> u64 {
    let radical = |column: &Column| column.family() == Family::Radical;
    let most = if request.columns.iter().all(radical) {
        1 << 16
    } else {
        1 << 14
    };
    request.count.min(most)
}

/// Starts of ranges in a request of `count` points: the first, the last, and indices
/// around 2^24 and 3^20, where f32 and the cells of base 3 end.
pub(super) fn starts(count: u64, points: u64) -> Vec<u64> {
    let mut starts = vec![0, 1, (1 << 24) - 7, 3_486_784_401 - 40, count - points];
    starts.retain(|start| start + points <= count);
    starts.sort_unstable();
    starts.dedup();
    starts
}

pub(super) fn case(
    name: String,
    kernel: &'static str,
    change: impl Fn(&mut Options),
) -> Result<Case> {
    let mut options = Options::new(Sequence::Halton, 1 << 32);
    change(&mut options);
    let request = Request::new(&options)?;
    Ok(Case {
        name,
        kernel,
        request,
    })
}

/// Runs a case.
pub fn check(device: &Arc<Device>, case: &Case) -> Result<Row> {
    let mut maker = Maker::new(device, case)?;
    compare_points(case, |start, points| maker.words(start, points))
}

/// Compares the words that `make` gives for ranges (start, points) of a case with the
/// reference.
///
/// # Errors
/// Those of `make`.
pub fn compare_points(
    case: &Case,
    mut make: impl FnMut(u64, u64) -> Result<Vec<u32>>,
) -> Result<Row> {
    let request = &case.request;
    let mut row = Row::exact(&case.name, case.kernel);
    let reference = Reference::new(request);
    let width = request.words_per_point() as usize;
    let points = points(request);
    let mut expected = vec![0; points as usize * width];
    for start in starts(request.count, points) {
        let got = make(start, points)?;
        row.hash(&got);
        reference.fill_singly(start, &mut expected);
        // Missing words are mismatches as well.
        let mut got = got.chunks(width);
        for (n, expected) in (request.first + start..).zip(expected.chunks(width)) {
            let got = got.next().unwrap_or_default();
            row.count(got == expected, || {
                format!("point {n}: {got:08x?}, not {expected:08x?}")
            });
        }
    }
    Ok(row.judged())
}

/// The kernels of a case.
pub(super) struct Maker(Generator);

impl Maker {
    pub(super) fn new(device: &Arc<Device>, case: &Case) -> Result<Self> {
        let request = &case.request;
        Ok(Self(match case.kernel {
            "generate" => Generator::general(device, request)?,
            "tile" => Generator::without_int64(device, request)?,
            _ => Generator::new(device, request)?,
        }))
    }

    pub(super) fn words(&mut self, start: u64, points: u64) -> Result<Vec<u32>> {
        let mut words = Vec::new();
        self.0.make(start, points, &mut |part| {
            words.extend_from_slice(part);
            Ok(())
        })?;
        Ok(words)
    }
}
