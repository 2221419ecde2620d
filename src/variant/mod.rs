//! Every stripping decision, from a plain description of the work.

mod bases;
mod columns;
mod plan;

pub use bases::{odometer_base, radical_base};
pub use columns::column_words;
pub use plan::{FusedMap, Plan, Work, general, plan};
