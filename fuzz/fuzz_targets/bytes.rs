//! Any bytes as the text of a pass.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| vitrine_fuzz::judge(bytes));
