//! A progress bar on a terminal, and nothing on a pipe.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;

/// A bar over so many points, with rate and time left.
pub fn points(total: u64) -> ProgressBar {
    let bar = bar(total);
    bar.set_style(style(
        "{bar:32} {human_pos}/{human_len} points, {per_sec}, {eta} left",
    ));
    bar
}

/// A bar over the cells of a study.
pub fn cells(total: u64) -> ProgressBar {
    let bar = bar(total);
    bar.set_style(style("{bar:32} {human_pos}/{human_len}, {eta} left: {msg}"));
    bar
}

/// A bar over the chunks of a store.
pub fn chunks(total: u64) -> ProgressBar {
    let bar = bar(total);
    bar.set_style(style("{bar:32} {human_pos}/{human_len} chunks, {eta} left"));
    bar
}

/// A bar over bytes that are read, of a number that it hears later.
pub fn bytes(what: &'static str) -> ProgressBar {
    let bar = bar(0);
    bar.set_style(style(
        "{prefix}: {bar:32} {bytes}/{total_bytes}, {bytes_per_sec}, {eta} left",
    ));
    bar.set_prefix(what);
    bar
}

/// A bar over one step after another, which [`step`] tells it.
pub fn steps() -> ProgressBar {
    let bar = bar(0);
    bar.set_style(style(
        "{prefix}: {bar:32} {human_pos}/{human_len}, {per_sec}, {eta} left",
    ));
    bar
}

/// Shows how far a step has come.
pub fn step(bar: &ProgressBar, name: &str, done: u64, total: u64) {
    if bar.prefix() != name {
        bar.reset();
        bar.set_prefix(name.to_owned());
        bar.set_length(total);
    }
    bar.set_position(done);
}

/// A counter of rows of unknown number.
pub fn rows() -> ProgressBar {
    let bar = if std::io::stderr().is_terminal() {
        ProgressBar::new_spinner()
    } else {
        ProgressBar::hidden()
    };
    bar.set_style(style("{spinner} {pos} rows, {elapsed}: {msg}"));
    bar
}

fn bar(total: u64) -> ProgressBar {
    if std::io::stderr().is_terminal() {
        ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::stderr_with_hz(8))
    } else {
        ProgressBar::hidden()
    }
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}
