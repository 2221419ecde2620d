#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| corput_fuzz::documents::baseline(data));
