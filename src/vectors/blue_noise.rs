//! Blue noise that hosts make: points by sample elimination, and masks by void-and-cluster.

use super::{Entry, Table, about};
use crate::Result;
use crate::blue_noise::{MaskShape, blue_noise_points, void_and_cluster};
use crate::reference::blue_noise::blue_noise_fraction;

const POINTS: u64 = 1024;
const SEED: u64 = 1;

/// Side and frames of each mask.
pub const MASKS: [(u32, u32); 2] = [(64, 1), (16, 8)];

pub fn each(take: &mut dyn FnMut(&Entry) -> Result<()>) -> Result<()> {
    take(&points()?)?;
    MASKS
        .iter()
        .try_for_each(|&(side, frames)| take(&mask(side, frames)?))
}

/// The file is what the command makes.
fn points() -> Result<Entry> {
    let command = format!("corput generate blue-noise --count {POINTS} --seed {SEED} --fractions");
    Ok(Entry {
        kind: "blue noise",
        name: "blue-noise".into(),
        about: about([("command", command.into())]),
        table: Some(Table {
            file: "blue-noise/points.npy".into(),
            columns: 2,
            words: blue_noise_points(POINTS, SEED)?.concat(),
            axes: None,
        }),
        tables: Vec::new(),
    })
}

/// Fractions of the ranks; frames are the first axis where there are several. The file is what the
/// command makes.
fn mask(side: u32, frames: u32) -> Result<Entry> {
    let shape = MaskShape::new(side.into(), side.into(), frames.into())?;
    let ranks = void_and_cluster(shape, MaskShape::channel_seed(SEED, 0));
    let words = ranks
        .iter()
        .map(|&rank| blue_noise_fraction(rank, shape.pixels()))
        .collect();
    let mut axes = vec![side, side];
    let mut command =
        format!("corput generate blue-noise-mask --size {side} --seed {SEED} --fractions");
    let mut file = format!("blue-noise/mask-{side}");
    if frames > 1 {
        axes.insert(0, frames);
        command += &format!(" --frames {frames}");
        file += &format!("-{frames}");
    }
    Ok(Entry {
        kind: "blue noise",
        name: "blue-noise-mask".into(),
        about: about([("command", command.into())]),
        table: Some(Table {
            file: file + ".npy",
            columns: side,
            words,
            axes: Some(axes),
        }),
        tables: Vec::new(),
    })
}
