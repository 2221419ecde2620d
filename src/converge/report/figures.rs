//! Which figures a study has, and what is in them.

use super::words::{error, floor, group_by_estimator, number};
use crate::Result;
use crate::converge::{ErrorAt, Results, Series, Statistic};
use crate::plot::{
    Curve, Key, MAX_CURVES, Measured, Work, WorkPrecisionStyle, key, work_precision,
};

/// A figure of error against one kind of work.
pub struct Figure {
    /// Its file, without an extension.
    pub name: String,
    /// The figure.
    pub svg: String,
    /// The names of its curves.
    pub key: Key,
}

/// Error against time and against points, of the same series.
pub struct Pair {
    /// Against time, then against points; none where no error is above 0.
    pub figures: Vec<Figure>,
    /// What both show.
    pub caption: String,
}

/// The pairs of an integrand, the `index`-th of the study: one for each estimator, and, where
/// there are several, one of all, each with its best sampler.
pub fn pairs(results: &Results, index: usize, group: &[&Series]) -> Result<Vec<Pair>> {
    let estimators = group_by_estimator(group);
    let mut made = Vec::new();
    if estimators.len() > 1 {
        let best = estimators.iter().filter_map(|(_, series)| best(series));
        let best: Vec<&Series> = best.collect();
        let curves = best.iter().zip(0..).map(|(series, hue)| {
            let name = format!("{}: {}", series.estimator.unwrap_or(""), series.sampler);
            (*series, name, hue)
        });
        let what = "each estimator with its best sampler";
        made.push(pair(results, index, "estimators", what, curves.collect())?);
    }
    for (estimator, series) in estimators {
        let hues = Hues::of(results, &series);
        let curves = series.iter().enumerate().map(|(place, series)| {
            let hue = hues.hue(series, place);
            (*series, series.sampler.clone(), hue)
        });
        let (part, what) = match estimator {
            None => (String::new(), "each sampler".to_owned()),
            Some(name) => (slug(name), format!("estimator {name}, each sampler")),
        };
        made.push(pair(results, index, &part, &what, curves.collect())?);
    }
    Ok(made)
}

/// The colours of samplers: in a study of at most eight, a sampler has the same in all
/// figures.
struct Hues<'a>(Vec<&'a str>);

impl<'a> Hues<'a> {
    fn of(results: &'a Results, group: &[&'a Series]) -> Self {
        let mut names: Vec<&str> = Vec::new();
        for series in &results.series {
            if !names.contains(&series.sampler.as_str()) {
                names.push(&series.sampler);
            }
        }
        match names.len() <= MAX_CURVES {
            true => Self(names),
            false => Self(group.iter().map(|one| one.sampler.as_str()).collect()),
        }
    }

    fn hue(&self, series: &Series, place: usize) -> usize {
        let found = self.0.iter().position(|name| *name == series.sampler);
        found.unwrap_or(place)
    }
}

/// The series with the least error at its largest count, of random samplers if there are any:
/// a single run may be lucky.
fn best<'a>(group: &[&'a Series]) -> Option<&'a Series> {
    let least = |random: bool| {
        let wanted = |one: &&&Series| one.analysis.random == random && last(one).is_finite();
        let kept = group.iter().filter(wanted);
        kept.min_by(|a, b| last(a).total_cmp(&last(b)))
    };
    least(true)
        .or_else(|| least(false))
        .or(group.first())
        .copied()
}

/// The relative error at the largest count; infinite where there is none.
fn last(series: &Series) -> f64 {
    let error = series.analysis.errors.last().map(|one| one.error.value);
    error
        .filter(|error| error.is_finite())
        .map_or(f64::INFINITY, |error| error / series.scale())
}

/// A series, the name of its curve, and its colour.
type Entry<'a> = (&'a Series, String, usize);

fn pair(
    results: &Results,
    index: usize,
    part: &str,
    what: &str,
    mut entries: Vec<Entry<'_>>,
) -> Result<Pair> {
    let Some(&(first, ..)) = entries.first() else {
        return Ok(Pair {
            figures: Vec::new(),
            caption: String::new(),
        });
    };
    let mut left_out: Vec<String> = Vec::new();
    while entries.len() > MAX_CURVES {
        let worst = entries
            .iter()
            .enumerate()
            .max_by(|(_, a), (_, b)| last(a.0).total_cmp(&last(b.0)));
        let Some((worst, _)) = worst else { break };
        left_out.push(entries.remove(worst).1);
    }
    if entries.iter().any(|(_, _, hue)| *hue >= MAX_CURVES) {
        for (place, entry) in entries.iter_mut().enumerate() {
            entry.2 = place;
        }
    }
    let (drawn, exact): (Vec<_>, Vec<_>) = entries
        .iter()
        .partition(|(series, ..)| relative(series).any(|one| drawable(&one)));
    let mut caption = format!(
        "{}, {what}: {} over time on the device (medians), and over the number of points.",
        first.integrand,
        error_name(first),
    );
    if !left_out.is_empty() {
        caption += &format!(
            " Left out, with the largest errors: {}.",
            left_out.join(", ")
        );
    }
    let exact: Vec<&str> = exact.iter().map(|(_, name, _)| name.as_str()).collect();
    if !exact.is_empty() {
        caption += &format!(
            " Not drawn, since no error is above 0: {}.",
            exact.join(", ")
        );
    }
    if drawn.is_empty() {
        return Ok(Pair {
            figures: Vec::new(),
            caption,
        });
    }
    caption += " Bands are 95 % intervals; dashed lines are samplers without randomisation, of \
                one run each.";
    let faint = drawn
        .iter()
        .any(|(series, ..)| series.analysis.errors.iter().any(ErrorAt::few_hits));
    if faint {
        caption += " Dotted and faint: too few hits for an interval.";
    }
    let lowest = Lowest::of(&entries);
    let mut figures = Vec::new();
    for work in [Work::Seconds, Work::Points] {
        let (short, against) = match work {
            Work::Seconds => ("time", "time"),
            Work::Points => ("points", "the number of points"),
        };
        let title = format!("{}, {what}: error against {against}", first.integrand);
        let curves: Vec<Curve> = drawn
            .iter()
            .map(|(series, name, hue)| curve(series, name, *hue, work))
            .collect();
        let style = WorkPrecisionStyle {
            title: &title,
            description: &description(&drawn, &lowest),
            work,
            y_label: error_name(first),
            targets: &results.setting.targets,
            floor: lowest.floor,
            floor_name: &lowest.name,
            ..WorkPrecisionStyle::default()
        };
        let parts = [&slug(&first.integrand), part, short];
        let parts: Vec<&str> = parts.into_iter().filter(|one| !one.is_empty()).collect();
        figures.push(Figure {
            name: format!("{:02}-{}", index + 1, parts.join("-")),
            svg: work_precision(&curves, &style)?,
            key: key(&curves, &style),
        });
    }
    Ok(Pair { figures, caption })
}

fn error_name(series: &Series) -> &'static str {
    match series.analysis.statistic {
        Statistic::Rmse => "relative RMSE",
        Statistic::MedianAbsolute => "relative median |error|",
    }
}

/// Relative errors with their intervals, over points.
pub fn relative(series: &Series) -> impl Iterator<Item = Measured> {
    let scale = series.scale();
    let errors = series.analysis.errors.iter();
    errors.map(move |at| Measured {
        work: at.count as f64,
        error: at.error.value / scale,
        low: at.error.low / scale,
        high: at.error.high / scale,
        faint: at.few_hits(),
    })
}

fn drawable(one: &Measured) -> bool {
    one.error.is_finite() && one.error > 0.0
}

fn curve(series: &Series, name: &str, hue: usize, work: Work) -> Curve {
    let seconds = series.analysis.errors.iter().map(|at| at.seconds.value);
    let points = relative(series).zip(seconds).map(|(one, seconds)| {
        let work = match work {
            Work::Points => one.work,
            Work::Seconds => seconds,
        };
        Measured { work, ..one }
    });
    Curve {
        name: name.to_owned(),
        points: points.collect(),
        one_run: !series.analysis.random,
        hue,
    }
}

/// The floor that a figure draws: of several estimators the lowest, since their errors may lie
/// below the others' floors.
struct Lowest {
    floor: f64,
    name: String,
}

impl Lowest {
    fn of(entries: &[Entry<'_>]) -> Self {
        let least = entries
            .iter()
            .min_by(|(a, ..), (b, ..)| floor(a).total_cmp(&floor(b)));
        let Some((series, ..)) = least else {
            return Self {
                floor: 0.0,
                name: String::new(),
            };
        };
        let value = floor(series);
        let name = match series.truth.uncertainty {
            None => "arithmetic floor",
            Some(_) => "floor, with the reference’s interval",
        };
        let others = entries.iter().any(|(one, ..)| floor(one) != value);
        let of = series.estimator.filter(|_| others);
        Self {
            floor: value,
            name: of.map_or(name.to_owned(), |estimator| {
                format!("{name} of {estimator}")
            }),
        }
    }
}

/// The figure in words.
fn description(drawn: &[&Entry<'_>], lowest: &Lowest) -> String {
    let mut text = String::from("At the most points: ");
    let ends = drawn.iter().filter_map(|(series, name, _)| {
        let end = relative(series).filter(drawable).last()?;
        Some(format!("{name} {}", error(&end, series.analysis.random)))
    });
    text += &ends.collect::<Vec<_>>().join("; ");
    text + &format!(". The {} is {}.", lowest.name, number(lowest.floor))
}

/// Letters and digits of a name, for a file.
fn slug(name: &str) -> String {
    let plain = name.chars().map(|c| match c.is_ascii_alphanumeric() {
        true => c.to_ascii_lowercase(),
        false => '-',
    });
    let short: String = plain.take(40).collect();
    short.trim_matches('-').to_owned()
}
