#![no_std]
#![deny(missing_docs, unsafe_code)]
//! Kalker's strip theory of rolling contact.

pub mod closed_form;
pub mod contact;
pub mod creepage;
mod elliptic;
pub mod hertz;
pub mod leading_edge;
pub mod material;
pub mod quadrature;
pub mod real;
pub mod status;
pub mod strip;
pub mod totals;
