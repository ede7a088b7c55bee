//! What callers of a model name: the function that leads from a contact and a creepage to forces, what it asks and answers, and what else a
//! solution has to show.

pub use crate::solve::check::check;
pub use crate::solve::derivatives::solve_jacobian;
pub use crate::solve::field::{Field, FieldStrip};
pub use crate::solve::options::{Model, Options, Solution};
pub use crate::solve::strips::{StripResult, strips, strips_of};
pub use crate::solve::theory::solve;
