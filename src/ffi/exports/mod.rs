//! The functions of the C interface, in the order of the header. They are written once, for numbers
//! `F`, and compiled for both precisions: `double.rs` and `single.rs` define `F` and `symbol!`.

mod batch;
mod bodies;
mod inside;
mod many;
mod motion;
mod patch;
mod rig;
mod solve;
mod wheel_rail;
mod wheelset;

use super::F;
pub use batch::*;
pub use bodies::*;
pub use inside::*;
pub use many::*;
pub use motion::*;
pub use patch::*;
pub use rig::*;
pub use solve::*;
pub use wheel_rail::*;
pub use wheelset::*;
