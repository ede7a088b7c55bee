//! The one way from a contact, a creepage and what is wanted to results.

pub mod derivatives;
pub mod evaluate;
pub mod field;
pub mod model;
pub mod motion;
