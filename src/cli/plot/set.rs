//! A file of points as views of a figure.

use super::super::args::PlotArgs;
use super::super::{interrupt, progress};
use super::refused;
use corput::Result;
use corput::plot::{MAX_DIMENSIONS, MAX_POINTS, View, grouped, pairs_points};
use corput::report::read_points;
use corput::stats::{Points, Source, Spectrum, projections, spectrum, spectrum_range};
use std::path::Path;

/// Dimensions whose pairs are shown unless others are asked for.
const DIMENSIONS: usize = 8;

/// What is drawn of a file, and what is measured of that.
pub struct Set {
    dimensions: Vec<usize>,
    /// Values of each dimension: as many as the pairs take, or the one dimension there is.
    columns: Vec<Vec<f32>>,
    /// Whether every pair of dimensions is drawn, and which one is marked.
    pairs: bool,
    marked: Option<[usize; 2]>,
    scatter: bool,
    /// The dimensions of the scatter plot and of the spectrum, and their points.
    plane: Option<([usize; 2], Vec<[f32; 2]>)>,
    spectrum: Option<Spectrum>,
    /// How much of the file is drawn, and how.
    pub caption: String,
}

impl Set {
    /// Reads a file and measures what its views need.
    pub fn read(path: &Path, args: &PlotArgs) -> Result<Self> {
        let points = read_points(path)?;
        let dimensions = dimensions(path, &points, args)?;
        let shown = dimensions.len();
        let kind = match (args.kind.as_deref(), shown) {
            (Some(kind), _) => kind,
            (None, 1 | 2) => "all",
            (None, _) => "pairs",
        };
        if shown == 1 && (kind == "pairs" || kind == "spectrum") {
            return Err(refused(
                format!("--kind {kind} of one dimension of {}", path.display()),
                "it takes two",
                "use --kind scatter",
            ));
        }
        // How many are drawn: those asked for, as far as a view takes them.
        let most = |default: usize, limit: usize| {
            let asked = args.points.map(|n| usize::try_from(n).unwrap_or(limit));
            points.rows().min(asked.unwrap_or(default)).min(limit)
        };
        let pairs = kind == "pairs" || (kind == "all" && shown > 2);
        let count = if pairs {
            let limit = MAX_POINTS / (shown * (shown - 1) / 2);
            most(pairs_points(shown, args.size as f64), limit)
        } else {
            most(MAX_POINTS, MAX_POINTS)
        };
        let columns = dimensions
            .iter()
            .map(|dimension| points.column(*dimension))
            .collect::<Result<Vec<_>>>()?;
        let marked = if pairs && shown > 2 {
            worst(&columns, count)?.map(|pair| pair.map(|index| dimensions[index]))
        } else {
            None
        };
        let wants_plane = shown > 1 && kind != "pairs";
        let pair = marked.unwrap_or_else(|| [dimensions[0], *dimensions.last().unwrap_or(&0)]);
        let plane = points.pairs(pair[0], pair[1])?;
        let plane = &plane[..most(MAX_POINTS, MAX_POINTS)];
        let spectrum = match kind {
            "spectrum" | "all" if wants_plane => Some(measure(plane)?),
            _ => None,
        };
        let shorter = |column: &Vec<f64>| column[..count].iter().map(|x| *x as f32).collect();
        let mut set = Self {
            columns: columns.iter().map(shorter).collect(),
            pairs,
            marked,
            scatter: kind == "scatter" || kind == "all",
            plane: wants_plane.then(|| (pair, plane.iter().map(|p| p.map(|x| x as f32)).collect())),
            spectrum,
            dimensions,
            caption: String::new(),
        };
        set.caption = set.describe(&points);
        Ok(set)
    }

    /// How much of the file is drawn, and how.
    fn describe(&self, points: &Points) -> String {
        let number = |count: usize| grouped(count as i64);
        let (rows, all) = (points.rows(), points.columns());
        let mut text = format!(
            "{} points of {} {}.",
            number(rows),
            number(all),
            if all == 1 { "dimension" } else { "dimensions" },
        );
        if self.dimensions.len() < all {
            let list: Vec<String> = self.dimensions.iter().map(usize::to_string).collect();
            text += &format!(" Shown: dimensions {}, counted from 0.", list.join(", "));
        }
        let part = |name: &str, count: usize| {
            (count < rows).then(|| format!(" {name} the first {} points.", number(count)))
        };
        let plane = self.plane.as_ref().map(|(_, points)| points.len());
        let first = match plane {
            Some(count) if !self.pairs => part("Drawn:", count),
            _ => part("Drawn:", self.columns[0].len()),
        };
        text += &first.unwrap_or_default();
        if let (true, Some(count)) = (self.pairs, plane) {
            text += &format!(" Below: {} points of the worst pair.", number(count));
        }
        if self.marked.is_some() {
            text += " Framed: the pair of the largest centred discrepancy.";
        }
        if self.scatter || self.pairs {
            text += " Colour: order, from dark to light.";
        }
        text
    }

    /// The views: those of one set in a row, those of several below each other.
    pub fn rows(&self, single: bool) -> Vec<Vec<View<'_>>> {
        let mut rows = Vec::new();
        if self.pairs {
            rows.push(vec![View::Pairs {
                columns: &self.columns,
                dimensions: &self.dimensions,
                marked: self.marked,
            }]);
        }
        let mut views = Vec::new();
        match (&self.plane, self.dimensions.as_slice()) {
            (_, [dimension]) => views.push(View::Sequence {
                values: &self.columns[0],
                dimension: *dimension,
            }),
            (Some((dimensions, points)), _) if self.scatter => views.push(View::Scatter {
                points,
                dimensions: *dimensions,
            }),
            _ => {}
        }
        if let Some(spectrum) = &self.spectrum {
            views.extend([View::Power(spectrum), View::Radial(spectrum)]);
        }
        if single {
            rows.push(views);
        } else {
            rows.extend(views.into_iter().map(|view| vec![view]));
        }
        rows
    }
}

/// Places of the two columns whose first points have the largest centred discrepancy.
fn worst(columns: &[Vec<f64>], count: usize) -> Result<Option<[usize; 2]>> {
    let rows = (0..count).flat_map(|row| columns.iter().map(move |column| column[row]));
    let points = Points::new(columns.len(), rows.collect(), Source::F64)?;
    let bar = progress::steps();
    let found = projections(&points, &mut |done, total| {
        progress::step(&bar, "pairs", done, total);
        interrupt::stop(done, total)
    });
    bar.finish_and_clear();
    let worst = found?
        .into_iter()
        .max_by(|a, b| a.centred.total_cmp(&b.centred));
    Ok(worst.map(|projection| projection.dimensions))
}

/// Which dimensions of a file are drawn.
fn dimensions(path: &Path, points: &Points, args: &PlotArgs) -> Result<Vec<usize>> {
    let all = points.columns();
    let flat = matches!(args.kind.as_deref(), Some("scatter" | "spectrum"));
    let most = if flat { 2 } else { MAX_DIMENSIONS };
    let Some(asked) = &args.dims else {
        return Ok((0..all.min(if flat { 2 } else { DIMENSIONS })).collect());
    };
    let list = || {
        let numbers: Vec<String> = asked.iter().map(u64::to_string).collect();
        format!("--dims {}", numbers.join(","))
    };
    if asked.len() > most {
        return Err(refused(
            list(),
            format!("a plot of this kind shows at most {most} dimensions"),
            if flat {
                "use --kind pairs, or give two"
            } else {
                "give fewer"
            },
        ));
    }
    for (index, dimension) in asked.iter().enumerate() {
        if *dimension >= all as u64 {
            return Err(refused(
                list(),
                format!("{} has dimensions 0 to {}", path.display(), all - 1),
                "choose among those",
            ));
        }
        if asked[..index].contains(dimension) {
            return Err(refused(
                list(),
                format!("{dimension} is given twice"),
                "drop one",
            ));
        }
    }
    // Below the number of columns, hence no bits are lost.
    Ok(asked.iter().map(|dimension| *dimension as usize).collect())
}

fn measure(points: &[[f64; 2]]) -> Result<Spectrum> {
    let bar = progress::steps();
    let found = spectrum(points, spectrum_range(points.len()), &mut |done, total| {
        progress::step(&bar, "spectrum", done, total);
        interrupt::stop(done, total)
    });
    bar.finish_and_clear();
    found
}
