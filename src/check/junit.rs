//! A check as JUnit XML, which services of continuous integration show.

use super::{Row, Verdict};
use crate::report::escape;
use std::fmt::Write;

/// A case that is no row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Further {
    /// The class.
    pub class: &'static str,
    /// Its name.
    pub name: String,
    /// Why it failed; `None` if it passed.
    pub failure: Option<String>,
    /// Why it did not run, if so.
    pub skipped: Option<String>,
}

/// One test suite, whose cases are the rows: failures with their witness, refused rows,
/// the driver's defects and those that there was no time for as skipped; and further ones.
#[must_use]
pub fn junit(rows: &[Row], left_out: &[String], further: &[Further], device: &str) -> String {
    let skipped = rows.iter().filter(|row| skipped(row)).count()
        + further.iter().filter(|one| one.skipped.is_some()).count()
        + left_out.len();
    let seconds: f64 = rows.iter().map(|row| row.seconds).sum();
    let mut xml = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n<testsuite name=\"corput check, {}\" \
         tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{skipped}\" time=\"{seconds:.3}\">\n",
        escape(device),
        rows.len() + left_out.len() + further.len(),
        rows.iter()
            .filter(|row| row.verdict == Verdict::Failed)
            .count()
            + further.iter().filter(|one| one.failure.is_some()).count(),
    );
    for row in rows {
        // Writing to a String cannot fail, here and below.
        let _ = writeln!(xml, "{}", case(row));
    }
    for name in left_out {
        let _ = writeln!(
            xml,
            "<testcase classname=\"left out\" name=\"{}\"><skipped message=\"no time was left\"/></testcase>",
            escape(name)
        );
    }
    for one in further {
        let element = |name: &str, why: &Option<String>| match why {
            Some(why) => format!("<{name} message=\"{}\"/>", escape(why)),
            None => String::new(),
        };
        let failure = element("failure", &one.failure) + &element("skipped", &one.skipped);
        let _ = writeln!(
            xml,
            "<testcase classname=\"{}\" name=\"{}\">{failure}</testcase>",
            escape(one.class),
            escape(&one.name)
        );
    }
    xml + "</testsuite>\n</testsuites>\n"
}

fn skipped(row: &Row) -> bool {
    matches!(row.verdict, Verdict::Refused(_) | Verdict::Defect)
}

fn case(row: &Row) -> String {
    let head = format!(
        "<testcase classname=\"{}.{}\" name=\"{}\" time=\"{:.3}\">",
        row.profile,
        escape(&row.kernel),
        escape(&row.name),
        row.seconds
    );
    let number = |value: Option<f64>| value.map_or("-".to_owned(), |x| format!("{x:e}"));
    let body = match &row.verdict {
        Verdict::Passed => String::new(),
        Verdict::Refused(reason) => format!("<skipped message=\"{}\"/>", escape(reason)),
        Verdict::Defect => format!(
            "<skipped message=\"the driver's defect: {} {} at {}\"/>",
            number(row.worst),
            escape(row.unit),
            escape(&row.witness)
        ),
        Verdict::Failed => {
            let differ = row.mismatches.unwrap_or(0);
            format!(
                "<failure message=\"{differ} of {} differ; worst error {}, bound {}\">{}</failure>",
                row.compared,
                number(row.worst),
                number(row.bound),
                escape(&row.witness)
            )
        }
    };
    format!("{head}{body}</testcase>")
}
