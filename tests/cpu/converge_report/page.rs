//! What the page says.

use super::{cell, page_of, plain, results, series, written};
use corput::converge::{Analysis, Results, Series, Statistic, Truth};

/// The part of the page before its integrands.
fn summary(page: &str) -> &str {
    let start = page.find("<section id=\"summary\">").unwrap();
    let length = page[start..].find("</section>").unwrap();
    &page[start..start + length]
}

pub fn says(page: &str, words: &[&str]) {
    for word in words {
        assert!(page.contains(word), "the page does not say `{word}`");
    }
}

#[test]
fn files_are_those_of_the_study_and_the_same_again() {
    let files = written(&plain());
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(
        names,
        [
            "01-one-time.svg",
            "01-one-time.png",
            "01-one-points.svg",
            "01-one-points.png",
            "results.csv",
            "report.html",
            "results.json",
        ]
    );
    assert_eq!(files, written(&plain()));
    let page = page_of(&plain());
    for (name, bytes) in files.iter().filter(|(name, _)| name.ends_with(".svg")) {
        let svg = std::str::from_utf8(bytes).unwrap();
        assert!(page.contains(svg), "{name} is not in the page");
    }
}

#[test]
fn the_summary_names_every_target_and_sampler() {
    let page = page_of(&plain());
    let summary = summary(&page);
    // Errors of halton are 0.2 / (n / 16) of the truth: 1e-2 at 320 points of 2 us.
    says(
        summary,
        &[
            "To 1e-2 use <strong>halton (one run)</strong>: 640 µs with about 320 points; random does not \
             reach it.",
            "To 1e-5: none of random, halton (one run) reaches it within the study.",
        ],
    );
    says(
        &page,
        &[
            "12.5 ms",
            "750 µs",
            "(one run)",
            "-1.00",
            "Seeds</dt><dd>3 to 10",
        ],
    );
}

#[test]
fn text_stays_text() {
    let mut study = plain();
    let hostile = "<script>alert('x')</script> & \"quoted\"";
    study.setting.command = format!("corput {hostile}");
    study.setting.device = hostile.into();
    for series in &mut study.series {
        series.integrand = hostile.into();
        series.sampler = format!("{}<img src=x>", series.sampler);
        series.cell.warnings = vec![hostile.into()];
        series.cell.refused = vec![(17, hostile.into())];
    }
    let files = written(&study);
    assert!(
        files
            .iter()
            .all(|(name, _)| !name.contains(['<', '/', ' ', '"']))
    );
    let page = page_of(&study);
    assert!(!page.contains("<script") && !page.contains("<img"));
    assert!(!page.contains("aria-label=\"<") && !page.contains("& \"quoted"));
    says(
        &page,
        &["&lt;script&gt;alert('x')&lt;/script&gt; &amp; &quot;quoted&quot;"],
    );
    for (name, bytes) in files.iter().filter(|(name, _)| name.ends_with(".svg")) {
        let svg = std::str::from_utf8(bytes).unwrap();
        resvg::usvg::Tree::from_str(svg, &Default::default())
            .unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

#[test]
fn what_limits_the_numbers_is_said() {
    let mut study = plain();
    for one in &mut study.series {
        one.truth = Truth {
            uncertainty: Some(2e-6),
            ..one.truth
        };
    }
    let one = &mut study.series[0];
    one.cell.points[3].means[2] = f64::NAN;
    one.cell.refused = vec![(16, "no such set".into()), (32, "nor this".into())];
    one.cell.warnings = vec!["be careful".into()];
    one.analysis = Analysis::new(&one.cell, &one.truth, true, Statistic::MedianAbsolute, None);
    let page = page_of(&study);
    says(
        &page,
        &[
            "The variance is infinite",
            "medians of |error|",
            "No integral is known",
            "± 2×10⁻⁶",
            "random: 1 mean is not finite",
            "1 mean is not finite: see its integrand.",
            "random: be careful",
            "random has no 16 points, nor 1 other counts: no such set",
            "relative median |error|",
            "floor, with the reference’s interval",
        ],
    );
    let clean = page_of(&plain());
    for word in ["infinite", "No integral", "not finite:", "has no"] {
        assert!(!clean.contains(&format!("<li>{word}")), "{word}");
    }
    assert!(!clean.contains("class=\"notes\"") && !clean.contains("class=\"failed\""));
}

/// The page may stand alone: it does not say what lies beside it.
#[test]
fn files_are_said_to_be_those_of_the_command() {
    let page = page_of(&plain());
    says(&page, &["The command writes results.json and results.csv"]);
    assert!(!page.contains("Beside this page"));
}

/// Estimators that take other dimensions are not said to take the first one's.
#[test]
fn dimensions_are_those_of_the_estimator() {
    let mut study = estimators();
    let text = page_of(&study);
    says(
        &text,
        &[
            "a function, in 2 dimensions.",
            "the floor of estimator mis is",
        ],
    );
    for one in &mut study.series {
        one.dimensions += u32::from(one.estimator == Some("mis"));
    }
    let text = page_of(&study);
    says(
        &text,
        &[
            "<p>a function. The",
            "the floor of estimator cosine, in 2 dimensions, is",
            "the floor of estimator mis, in 3 dimensions, is",
        ],
    );
}

pub fn estimators() -> Results {
    let with = |name, sampler, slope| Series {
        estimator: Some(name),
        ..series("light", sampler, cell(slope, true), true)
    };
    results(vec![
        with("cosine", "random", -0.5),
        with("cosine", "sobol:owen", -0.8),
        with("mis", "random", -0.5),
        with("mis", "sobol:owen", -1.2),
    ])
}

#[test]
fn estimators_have_a_pair_each_and_one_of_the_best() {
    let files = written(&estimators());
    let svgs: Vec<&str> = files
        .iter()
        .filter_map(|(name, _)| name.strip_suffix(".svg"))
        .collect();
    assert_eq!(
        svgs,
        [
            "01-light-estimators-time",
            "01-light-estimators-points",
            "01-light-cosine-time",
            "01-light-cosine-points",
            "01-light-mis-time",
            "01-light-mis-points",
        ]
    );
    let best = files
        .iter()
        .find(|(name, _)| name == "01-light-estimators-time.svg");
    let best = std::str::from_utf8(&best.unwrap().1).unwrap();
    says(best, &["cosine: sobol:owen", "mis: sobol:owen"]);
    assert!(!best.contains("random"), "not the best of its estimator");
    says(
        summary(&page_of(&estimators())),
        &["<strong>sobol:owen with mis</strong>"],
    );
}

#[test]
fn what_is_not_drawn_is_said() {
    let mut many: Vec<Series> = (0..10)
        .map(|n| {
            let slope = -0.5 - 0.05 * f64::from(n);
            series("one", &format!("sampler-{n}"), cell(slope, true), true)
        })
        .collect();
    let page = page_of(&results(many.clone()));
    says(
        &page,
        &["Left out, with the largest errors: sampler-0, sampler-1."],
    );

    let exact = series("one", "exact", cell(f64::NEG_INFINITY, true), true);
    let mut flat = exact.clone();
    for point in &mut flat.cell.points {
        point.means = vec![0.5; 8];
    }
    flat.analysis = Analysis::new(&flat.cell, &flat.truth, true, Statistic::Rmse, None);
    many.truncate(1);
    many.push(flat.clone());
    let page = page_of(&results(many));
    says(&page, &["Not drawn, since no error is above 0: exact."]);
    let alone = written(&results(vec![flat]));
    assert_eq!(alone.len(), 3, "no figure of nothing");
}

#[test]
fn a_target_below_the_floor_is_named_so() {
    let mut study = plain();
    study.setting.targets = vec![1e-12];
    says(&page_of(&study), &["1e-12", "below the floor 2.00e-9"]);

    // Floors are those of estimators: only who is below its own got there by chance.
    let mut study = estimators();
    study.setting.targets = vec![1e-1];
    let rough = study.series[0].estimator;
    for one in &mut study.series {
        if one.estimator == rough {
            one.truth = Truth::stated(one.truth.value, 0.5);
        }
    }
    let page = page_of(&study);
    let name = format!("with {} (", rough.unwrap());
    let sentence = page.split("It is below the floor of ").nth(1).unwrap();
    let sentence = sentence.split("</li>").next().unwrap();
    assert!(sentence.contains(&name), "{sentence}");
    for one in study.series.iter().filter(|one| one.estimator != rough) {
        let other = format!("with {} (", one.estimator.unwrap());
        assert!(!sentence.contains(&other), "{sentence}");
    }
    let figure = format!("floor of {}", rough.unwrap());
    assert!(!page.contains(&figure), "figures draw the lowest");
    study.setting.targets.clear();
    says(&page_of(&study), &["asked for no target"]);
}
