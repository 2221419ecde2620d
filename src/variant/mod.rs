//! Every stripping decision, from a plain description of the work.

mod bases;
mod columns;
mod estimate;
mod places;
mod plan;
mod wide;

pub use bases::{odometer_base, radical_base};
pub use columns::{
    LONGEST_RUN, LinearNet, STORED_RUN, column_table, column_words, linear_net, longest_run,
};
pub use estimate::{
    general_estimate, longest_estimate, plan_estimate, plan_pixels, replan_estimate,
};
pub use plan::{FusedMap, Plan, Work, general, plan};
pub use wide::is_short;
