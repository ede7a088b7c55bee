//! The one way from a contact, a creepage and what is wanted to results.
//!
//! Types first, each file knowing those before it: `options`, what is asked and answered; `check`, whether there is an answer;
//! `notice`, what a caller should know; `theory`, what a model makes of a contact and answers to a creepage; `prepared`, what it makes
//! of one, kept. Then what callers ask: [`model`] for forces, [`derivatives`], [`strips`], [`field`].

pub mod check;
pub mod derivatives;
pub mod field;
pub mod model;
pub(crate) mod notice;
pub mod options;
pub mod prepared;
pub mod strips;
pub(crate) mod theory;
