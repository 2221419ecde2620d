//! Every stripping decision, from a plain description of the work.

mod bases;

pub use bases::{odometer_base, radical_base};
