//! Parts of messages that depend on what they speak of.

use super::Error;

/// Indices past the end of a sequence, and by how many. Sums of two counts need not fit 64 bits.
pub(super) fn index_range(first: u64, count: u64) -> String {
    let end = u128::from(first) + u128::from(count);
    let beyond = end.saturating_sub(1 << 32);
    format!(
        "first + count = {first} + {count} = {end} passes 2^32, the length of every sequence; \
         lower --first or --count by {beyond}"
    )
}

pub(super) fn dimensions(many: u64) -> String {
    match many {
        1 => "1 dimension".to_owned(),
        many => format!("{many} dimensions"),
    }
}

/// From the least to the most; of one alone that.
pub(super) fn range(least: u32, most: u32) -> String {
    match least == most {
        true => most.to_string(),
        false => format!("{least} to {most}"),
    }
}

pub(super) fn given(many: u32) -> String {
    let verb = if many == 1 { "was" } else { "were" };
    format!("{many} {verb} given")
}

/// What goes on with a run that was begun with or without `--fresh`.
pub(super) fn again(fresh: bool) -> &'static str {
    match fresh {
        true => "the same command without --fresh",
        false => "the same command",
    }
}

impl Error {
    /// The message without the remedy that what follows makes wrong.
    pub(super) fn text_before_more(&self) -> String {
        match self {
            Self::Interrupted { done, total } => format!("interrupted after {done} of {total}"),
            other => other.to_string(),
        }
    }
}
