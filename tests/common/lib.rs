//! What several programs of the tests, reports and fuzz targets use.

pub mod entries;
pub mod halving;
pub mod header;
pub mod in_c;
pub mod manchester;
pub mod names;
pub mod patch_reference;
mod places;
pub mod poison;
pub mod prelude;
pub mod random;
pub mod reference;
pub mod single;
pub mod slopes;
mod structures;
pub mod theory;
pub mod toolchain;
