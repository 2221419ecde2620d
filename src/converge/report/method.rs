//! How a study was made, so that its numbers can be judged and made again.

use super::words::{escape, target};
use crate::converge::analysis::{ABOVE_FLOOR, SLOPE_FROM};
use crate::converge::cell::{CHECKED, REPEATS};
use crate::converge::hits::{ENOUGH, SURE};
use crate::converge::statistics::RESAMPLES;
use crate::converge::{Results, SCHEMA};
use crate::plot::grouped;

/// Device, settings, command and method.
pub fn method(results: &Results) -> String {
    let setting = &results.setting;
    let counts: Vec<String> = setting.counts.iter().map(|n| grouped(*n as i64)).collect();
    let targets: Vec<String> = setting.targets.iter().map(|one| target(*one)).collect();
    let last = setting
        .seed
        .wrapping_add(u64::from(setting.replicates).saturating_sub(1));
    let facts = [
        ("Device and driver", setting.device.clone()),
        ("corput", env!("CARGO_PKG_VERSION").to_owned()),
        ("Points", counts.join(", ")),
        ("Replicates", setting.replicates.to_string()),
        ("Seeds", format!("{} to {last}", setting.seed)),
        ("Relative errors asked for", targets.join(", ")),
        ("Form of results.json", SCHEMA.to_owned()),
    ];
    let facts: String = facts
        .iter()
        .map(|(name, value)| format!("<dt>{name}</dt><dd>{}</dd>\n", escape(value)))
        .collect();
    format!(
        "<section id=\"method\">\n<h2>How this was measured</h2>\n<dl>\n{facts}</dl>\n\
         <p>To run it again:</p>\n<pre tabindex=\"0\"><code>{}</code></pre>\n{}{}</section>\n",
        escape(&setting.command),
        paragraphs(setting.replicates),
        shards(setting.shards)
    )
}

/// What is different where shards measured it.
fn shards(many: u64) -> String {
    if many == 1 {
        return String::new();
    }
    format!(
        "<p><strong>Shards.</strong> {many} shards measured their cells apart, perhaps on several machines, \
         perhaps at once. Errors do not depend on it. Each time is that of the device of its cell, with what \
         that machine had to do meanwhile; times are compared where the device and its driver have one \
         name, and machines of one name are taken to be alike.</p>\n"
    )
}

fn paragraphs(replicates: u32) -> String {
    let repeats = REPEATS.min(replicates);
    let sure = 100.0 * SURE;
    format!(
        "<p><strong>Errors.</strong> Each sampler that is random runs {replicates} times, with \
         the seeds above; the error is the root mean square over these replicates, or the median \
         of |error| where the variance is infinite, relative to |integral|. Its 95 % interval \
         runs from the 2.5th to the 97.5th percentile of {} bootstrap resamples of the \
         replicates. A sampler that is not random has one error a count, and no interval: it may \
         be small by chance. Sums are exact, so errors are the same on every device; those of up \
         to {} points were compared with the CPU's.</p>\n\
         <p><strong>Effective hits.</strong> Where few terms make the variance, as where hardly a \
         direction meets a light, replicates without them agree on a wrong mean, and the interval \
         is too narrow: it tells of the terms that came. The hits of a count are its points in \
         all replicates, one or {replicates}, over the kurtosis of the terms, that is, the points \
         that meet a peak of which all others miss. The kurtosis is that of the random sampler with the most, \
         by how the variances of its replicates spread at the largest count. Errors of fewer than \
         {ENOUGH} hits, or 3 in a single run, are dotted and faint in figures and marked in tables; medians do not hang on \
         rare terms, and have none. So are errors where the mean of all replicates is off by more \
         than Student's {sure} % interval and {ABOVE_FLOOR} floors: all of them missed the same.</p>\n\
         <p><strong>Slopes</strong> are those of log error over log N, by least squares over the \
         counts from {SLOPE_FROM} on whose hits are not few, and whose errors are above \
         {ABOVE_FLOOR} floors; results.json has how many counts were left out. Their \
         intervals resample replicates, each at all counts or at none.</p>\n\
         <p><strong>Floor.</strong> What is left of an error with any number of points: the mean \
         error of the arithmetic of a term and of the grid of 2<sup>-32</sup> on which \
         coordinates lie, and the interval of the reference where the integral is not known.\
         </p>\n\
         <p><strong>Times</strong> are medians over dispatches that sum one replicate each, warm, \
         by the device's own clock where it has one; {repeats} of a sampler that is not random. \
         Set-up, that is buffers and compilation, and the first dispatch are apart and in no \
         other time. A target is reached where the error falls below it for all counts that \
         follow, between two counts by interpolation of logarithms; the interval of its time is \
         that of the error. Two samplers tie where these intervals overlap. Times hold for this \
         device with what else it had to do.</p>\n\
         <p>The command writes results.json and results.csv with every number, and the figures as \
         SVG and PNG, into the folder of its report, with this page. Where the page alone was \
         handed on, they are not beside it.</p>\n",
        grouped(RESAMPLES.into()),
        grouped(CHECKED as i64),
    )
}
