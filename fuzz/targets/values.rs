//! Drives `values` with the inputs of libFuzzer.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| crankstar_fuzz::values(bytes));
