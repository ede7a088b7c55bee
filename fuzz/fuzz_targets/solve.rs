//! Arbitrary bytes for kstrip_solve and kstrip_solve_f32: see tests/common/entries/mod.rs.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| kstrip_testing::entries::solve_entry(data));
