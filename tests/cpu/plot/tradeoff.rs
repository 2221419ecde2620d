//! Error against speed: names beside their points, none upon another.

use super::boxes::{assert_apart, texts};
use super::{drawn, refused};
use corput::plot::{Tradeoff, TradeoffStyle, tradeoff};

/// Pairs whose second ends crowd together.
fn crowd(count: usize) -> Vec<Tradeoff> {
    let pair = |i: usize| {
        let angle = i as f64 * 2.4;
        let spread = 0.4 + i as f64 / count as f64;
        Tradeoff {
            name: format!("a-longer-name-{i}"),
            ends: [
                (10f64.powf(6.5 + 0.3 * angle.cos()), 0.5 + 0.01 * i as f64),
                (
                    10f64.powf(8.0 + 0.5 * spread * angle.cos()),
                    10f64.powf(1.0 + spread * angle.sin()),
                ),
            ],
        }
    };
    (0..count).map(pair).collect()
}

#[test]
fn names_lie_apart() {
    let style = TradeoffStyle {
        title: "Title",
        subtitle: "and more",
        ..TradeoffStyle::default()
    };
    for count in [1, 12, 40] {
        let pairs = crowd(count);
        let svg = tradeoff(&pairs, &style).unwrap();
        assert_apart(&svg);
        let texts = texts(&svg);
        for pair in &pairs {
            assert_eq!(
                texts.iter().filter(|(text, _)| *text == pair.name).count(),
                1
            );
        }
        drawn(&format!("tradeoff-{count}"), &svg, [916, 752]);
    }
}

#[test]
fn what_has_no_place_is_left_out() {
    let mut pairs = crowd(2);
    pairs[0].ends[1].1 = f64::INFINITY;
    let svg = tradeoff(&pairs, &TradeoffStyle::default()).unwrap();
    assert!(!svg.contains(&pairs[0].name) && svg.contains(&pairs[1].name));
    pairs[1].ends[0].0 = f64::NAN;
    refused(
        tradeoff(&pairs, &TradeoffStyle::default()),
        "positive and finite",
    );
    let style = TradeoffStyle {
        size: [100.0, 300.0],
        ..TradeoffStyle::default()
    };
    refused(tradeoff(&crowd(3), &style), "160 to 4000");
}
