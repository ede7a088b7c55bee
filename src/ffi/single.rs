//! The functions in single precision, with the suffix `_f32`.

type F = f32;
macro_rules! symbol {
    ($name:literal) => {
        concat!($name, "_f32")
    };
}

#[path = "exports/mod.rs"]
mod exports;
pub use exports::*;
