//! The functions in double precision.

type F = f64;
macro_rules! symbol {
    ($name:literal) => {
        $name
    };
}

#[path = "exports/mod.rs"]
mod exports;
pub use exports::*;
