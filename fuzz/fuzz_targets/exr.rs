#![no_main]

use std::panic::{set_hook, take_hook};
use std::sync::Once;

/// The decoder's own panics are caught, and are errors; libFuzzer's hook would abort before.
/// Any other is still an abort.
static CAUGHT: Once = Once::new();

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    CAUGHT.call_once(|| {
        drop(take_hook());
        set_hook(Box::new(|_| {}));
    });
    corput_fuzz::exr(data)
});
