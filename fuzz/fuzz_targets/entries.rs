//! Arbitrary bytes for every C function: see tests/common/entries/mod.rs.
#![no_main]

#[path = "../../tests/common/entries/mod.rs"]
mod entries;

libfuzzer_sys::fuzz_target!(|data: &[u8]| entries::any_entry(data));
