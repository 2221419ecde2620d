//! Flattened shaders: that every stock kernel's is the same program, that nothing else is in it,
//! and that what is not understood is refused. What is made of modules: counts, headers for
//! hosts, other languages.

#[path = "strip/canonical.rs"]
mod canonical;
#[path = "strip/kernels.rs"]
mod kernels;
#[path = "strip/measure.rs"]
mod measure;
mod source;
#[path = "strip/text.rs"]
mod text;
