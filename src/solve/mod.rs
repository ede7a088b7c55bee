//! The one way from a contact, a creepage and what is wanted to results.
//!
//! [`model`]: the models, what is asked of them and what they answer. [`check`]: whether there is an answer. [`prepared`]:
//! from a contact to what a model knows of it, from that and a creepage to forces. [`derivatives`], [`strips`], [`field`]: what
//! else there is to know. [`motion`]: forward, backward, standstill.

pub mod check;
pub mod derivatives;
pub mod field;
pub mod model;
pub mod motion;
pub mod prepared;
pub mod strips;
pub(crate) mod through_friction;
