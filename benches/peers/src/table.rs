//! Rates as README.md shows them: a row a job, a column a kind of makers, and above them what
//! was measured, and where.

/// What a maker did of a job.
pub struct Rate {
    pub job: &'static str,
    /// The library, with its version.
    pub library: String,
    /// The column that it stands in.
    pub column: String,
    /// What tells it from others in its column; of most nothing.
    pub label: String,
    pub values_s: f64,
}

/// Names the place, the libraries that were measured, and those that are missing.
pub fn heading(place: &str, rates: &[Rate], missing: &[&str]) -> String {
    let libraries = firsts(rates.iter().map(|rate| rate.library.as_str()));
    let without = match missing {
        [] => String::new(),
        missing => format!("; without {}", missing.join(", ")),
    };
    format!("{place}; {}{without}:", libraries.join(", "))
}

/// Jobs and columns stand in the order in which they first occur.
pub fn pivot(rates: &[Rate]) -> String {
    let jobs = firsts(rates.iter().map(|rate| rate.job));
    let columns = firsts(rates.iter().map(|rate| rate.column.as_str()));
    let mut table = format!("| job, G values/s | {} |\n", columns.join(" | "));
    table += &format!("|---|{}\n", "---|".repeat(columns.len()));
    for job in jobs {
        table += &format!("| {job} |");
        for column in &columns {
            let here = |rate: &&Rate| rate.job == job && rate.column == *column;
            let cells: Vec<String> = rates.iter().filter(here).map(cell).collect();
            table += &format!(" {} |", cells.join(", "));
        }
        table += "\n";
    }
    table
}

fn cell(rate: &Rate) -> String {
    let text = format!("{:.2} {}", rate.values_s * 1e-9, rate.label);
    text.trim_end().to_owned()
}

/// Each once.
fn firsts<'a>(names: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut found = Vec::new();
    for name in names {
        if !found.contains(&name) {
            found.push(name);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rate(job: &'static str, library: &str, column: &str, label: &str, g: f64) -> Rate {
        Rate {
            job,
            library: library.to_owned(),
            column: column.to_owned(),
            label: label.to_owned(),
            values_s: g * 1e9,
        }
    }

    fn rates() -> [Rate; 6] {
        [
            rate("first", "ours 1.0", "ours", "", 3.0),
            rate("first", "one 0.1", "crates", "`one`", 0.254),
            rate("second", "ours 1.0", "ours", "", 12.0),
            rate("second", "one 0.1", "crates", "`one`", 0.5),
            rate("second", "two 0.2", "crates", "`two`", 0.75),
            rate("second", "Py 3.0", "Py", "", 0.001),
        ]
    }

    #[test]
    fn rows_are_jobs_and_columns_kinds_of_makers() {
        let expected = "\
| job, G values/s | ours | crates | Py |
|---|---|---|---|
| first | 3.00 | 0.25 `one` |  |
| second | 12.00 | 0.50 `one`, 0.75 `two` | 0.00 |
";
        assert_eq!(pivot(&rates()), expected);
    }

    #[test]
    fn the_heading_names_each_library_once_and_what_is_missing() {
        let all = "here; ours 1.0, one 0.1, two 0.2, Py 3.0:";
        assert_eq!(heading("here", &rates(), &[]), all);
        let some = "here; ours 1.0, one 0.1; without Py, Th:";
        assert_eq!(heading("here", &rates()[..2], &["Py", "Th"]), some);
    }
}
