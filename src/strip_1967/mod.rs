//! The theory of 1967.

pub mod closed_form;
pub mod leading_edge;
mod panels;
pub mod quadrature;
pub mod strip;
pub mod totals;
