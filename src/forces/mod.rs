//! The one way from a contact, a creepage and what is wanted to results.
//!
//! Types first, each file knowing those before it: `options`, what is asked and answered; `check`,
//! whether there is an answer; `warning`, what a caller should know; `theory`, what a model makes
//! of a contact and answers to a creepage; `prepared`, what it makes of one, kept. Then what
//! callers use: [`forces_of_contact`], [`derivatives`], [`mod@strips`], [`field`].

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
