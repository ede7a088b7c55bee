//! Arbitrary bytes for every C function: see tests/common/entries/mod.rs.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| kstrip_testing::entries::any_entry(data));
