//! The functions of the C interface, in the order of the header. They are written once, for numbers
//! `F`, and compiled for both precisions: `double.rs` and `single.rs` define `F` and `symbol!`.

#[cfg(feature = "batch")]
mod batch;
mod bodies;
#[cfg(feature = "wheels")]
mod files;
#[cfg(feature = "fit")]
mod fit;
mod inside;
#[cfg(feature = "wheels")]
mod many;
mod motion;
#[cfg(feature = "patches")]
mod patch;
mod rig;
#[cfg(feature = "wheels")]
mod scene;
mod solve;
#[cfg(feature = "tables")]
mod tables;
#[cfg(feature = "wheels")]
mod wheel_rail;
#[cfg(feature = "wheels")]
mod wheelset;

use super::F;
#[cfg(feature = "batch")]
pub use batch::*;
pub use bodies::*;
#[cfg(feature = "wheels")]
pub use files::*;
#[cfg(feature = "fit")]
pub use fit::*;
pub use inside::*;
#[cfg(feature = "wheels")]
pub use many::*;
pub use motion::*;
#[cfg(feature = "patches")]
pub use patch::*;
pub use rig::*;
pub use solve::*;
#[cfg(feature = "tables")]
pub use tables::*;
#[cfg(feature = "wheels")]
pub use wheel_rail::*;
#[cfg(feature = "wheels")]
pub use wheelset::*;
