#![no_std]
#![deny(missing_docs, unsafe_code)]
//! Kalker's strip theory of rolling contact.

pub mod real;
