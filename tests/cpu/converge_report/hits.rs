//! Errors for which too few points speak.

use super::page::says;
use super::{page_of, plain};
use corput::converge::{Analysis, Rarity, Statistic};

/// Where points hardly meet what the error consists of.
#[test]
fn few_hits_are_marked() {
    let mut study = plain();
    let rarity = |share| Some(Rarity { share });
    // 100 hits of 8 replicates at 1250 points, and 3 of a single run at 312.
    for one in &mut study.series {
        let random = one.analysis.random;
        let (cell, truth) = (&one.cell, &one.truth);
        one.analysis = Analysis::new(cell, truth, random, Statistic::Rmse, rarity(0.01));
    }
    let page = page_of(&study);
    says(
        &page,
        &[
            "<li>fewer than 100 effective hits to 1,024 points, or 3 in single runs to 256, or all",
            "Dotted and faint: too few hits for an interval.",
            "stroke-dasharray=\"1.5 3\"",
            // Of 2048 and 4096 points alone there is no slope.
            "<td>-</td></tr>",
        ],
    );
    assert!(!page.contains("; few hits)"), "not of the largest count");
    for one in &mut study.series {
        let random = one.analysis.random;
        let (cell, truth) = (&one.cell, &one.truth);
        one.analysis = Analysis::new(cell, truth, random, Statistic::Rmse, rarity(0.0005));
    }
    says(
        &page_of(&study),
        &[
            "; few hits)</td>",
            "(one run; few hits)",
            "halton (one run) (few hits)</strong>",
        ],
    );
    let clean = page_of(&plain());
    for words in ["few hits)", "1.5 3", "Dotted"] {
        assert!(!clean.contains(words), "{words}");
    }
}
