//! Texts in the shape of GLSL, most of which are right.

#![no_main]

use vitrine_fuzz::grammar::Text;

libfuzzer_sys::fuzz_target!(|text: Text| vitrine_fuzz::judge(text.0.as_bytes()));
