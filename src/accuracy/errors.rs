//! How far results are from the truth.

use super::subject::Subject;

/// Errors of many results, in units of the last place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// The largest; infinite where a result is no number.
    pub worst_ulp: f64,
    /// The mean over the arguments that are spread evenly; infinite likewise.
    pub mean_ulp: f64,
}

/// What the judge found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judged {
    /// Results judged.
    pub results: u64,
    /// Results below this in magnitude counted in ULP of it.
    pub floor: f64,
    /// Errors of the results; of a vector, of its worst coordinate.
    pub errors: Errors,
    /// The largest where results below the floor count in ULP of themselves, down to 2^-32 of
    /// the largest result: what a relative error asks.
    pub worst_relative_ulp: f64,
    /// Errors of the pdf, where there is one, in ULP of itself down to 2^-32 of the largest.
    pub pdf: Option<Errors>,
}

/// The least fraction is that part of them all.
const RANGE: f64 = 4_294_967_296.0;

#[derive(Default)]
struct Sum {
    worst: f64,
    sum: f64,
    count: u64,
}

impl Sum {
    fn add(&mut self, error: f64, typical: bool) {
        // A NaN must not pass unseen.
        let error = if error.is_nan() { f64::INFINITY } else { error };
        self.worst = self.worst.max(error);
        if typical {
            self.sum += error;
            self.count += 1;
        }
    }

    fn errors(&self) -> Errors {
        Errors {
            worst_ulp: self.worst,
            mean_ulp: self.sum / self.count.max(1) as f64,
        }
    }
}

/// Judges the results of a subject, each its words and then its pdf. The worst error is over
/// all arguments, the mean over those from `typical` on: the others are critical ones.
#[must_use]
pub fn judge(
    subject: &Subject,
    arguments: &[[u32; 3]],
    results: &[Vec<u32>],
    typical: usize,
) -> Judged {
    let width = subject.width();
    let truths: Vec<_> = arguments.iter().map(|&u| subject.truth(u)).collect();
    let largest = |at: std::ops::Range<usize>| {
        let known = truths.iter().flatten();
        known
            .flat_map(|truth| truth.iter().take(at.end).skip(at.start))
            .fold(0.0, |most: f64, x| most.max(x.abs()))
    };
    let most = largest(0..width);
    let floor = subject.floor(most);
    let least = floor.min(most / RANGE);
    let pdf_floor = largest(width..width + 1) / RANGE;
    let [mut all, mut relative, mut pdf] = [(); 3].map(|()| Sum::default());
    let mut judged = 0;
    for (i, (words, truth)) in results.iter().zip(&truths).enumerate() {
        let Some(truth) = truth else { continue };
        judged += 1;
        let worst = |floor| {
            let pairs = words.iter().zip(truth).take(width);
            let errors = pairs.map(|(&word, &truth)| subject.error(word, truth, floor));
            errors.fold(0.0, |a: f64, b| if a.is_nan() || a > b { a } else { b })
        };
        all.add(worst(floor), i >= typical);
        relative.add(worst(least), false);
        if let (Some(&word), Some(&truth)) = (words.get(width), truth.get(width)) {
            pdf.add(subject.error(word, truth, pdf_floor), i >= typical);
        }
    }
    Judged {
        results: judged,
        floor,
        errors: all.errors(),
        worst_relative_ulp: relative.worst,
        pdf: subject.has_pdf().then(|| pdf.errors()),
    }
}
