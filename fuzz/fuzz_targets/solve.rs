//! Arbitrary bytes for kstrip_solve and kstrip_solve_f32: see tests/common/entries/mod.rs.
#![no_main]

#[path = "../../tests/common/entries/mod.rs"]
mod entries;

libfuzzer_sys::fuzz_target!(|data: &[u8]| entries::solve_entry(data));
