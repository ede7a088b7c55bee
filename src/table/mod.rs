//! Contact tables: a wheel in microseconds.
//!
//! A table holds the contacts of a wheel of some radius and material on a straight rail: by lateral
//! position, height, yaw and roll. It is a block of caller-provided memory, little-endian and
//! without pointers, which may be written to a file, mapped from it, or placed in flash. Friction,
//! its law, damping, speeds and the side of the wheel stay outside.
//!
//! * [`TableSpec::begin_table`] writes the head of a table.
//! * [`fill_part`] computes its parts, in any order and on any threads.
//! * [`finish`] makes it compact and measures its error.
//! * [`TableScene`] computes contacts, force and moment for a position.
//! * [`source`] puts a table into a [`Scene`](crate::wheel_rail::scene::Scene): heights, wheelsets
//!   and many wheels then take their contacts from it.
//!
//! `fill` describes the stored numbers, and why zones of contact appear without a kink; `axis`
//! describes the interpolation between nodes, `strips` the strips on the wheel, and `lookup` the
//! contacts.

mod axis;
mod begin;
mod blend;
mod block;
mod fill;
mod lookup;
mod measure;
mod parts;
mod spec;
mod strips;

pub use self::block::ContactTable;
pub(crate) use self::block::{HEAD_START, head_length};
pub use self::lookup::{TableScene, source};
pub use self::measure::{TableReport, finish};
pub use self::parts::fill_part;
pub(crate) use self::parts::{fill_memory, memory_of_part};
pub use self::spec::TableSpec;
