//! Flattened shaders: that every stock kernel's is the same program, that nothing else is in it,
//! and that what is not understood is refused. What is made of modules: counts, headers for
//! hosts, other languages.

#[path = "strip/canonical.rs"]
mod canonical;
#[path = "interface/facts.rs"]
#[allow(dead_code, reason = "the test of the interface uses the rest")]
mod facts;
#[path = "strip/host.rs"]
mod host;
#[path = "strip/kernels.rs"]
mod kernels;
#[path = "strip/measure.rs"]
mod measure;
#[path = "strip/refused.rs"]
mod refused;
mod source;
#[path = "strip/text.rs"]
mod text;
#[path = "strip/translate.rs"]
mod translate;
