//! The road from a contact, a creepage and options to results.
//!
//! Each file uses only those before it: `options` has the options and results, `check` the errors,
//! `warning` the warnings, `theory` the numbers that a model computes from a contact and its forces
//! for a creepage, `prepared` the same with these numbers stored. Callers use
//! [`forces_of_contact`], [`derivatives`], [`mod@strips`], [`field`].

pub mod check;
pub mod derivatives;
pub mod field;
pub mod options;
pub mod prepared;
pub mod strips;
pub(crate) mod theory;
pub(crate) mod warning;

pub use self::check::check;
pub use self::derivatives::solve_jacobian;
pub use self::field::{Field, FieldStrip};
pub use self::options::{Model, Options, Solution};
pub use self::strips::{StripResult, strips, strips_of};
pub use self::theory::forces_of_contact;
