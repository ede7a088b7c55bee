//! The theory of 1967 and what it stands on: the paper, Hertz, materials, creepages, limits.

#[path = "../common/random.rs"]
mod random;
#[path = "../common/single.rs"]
mod single;
#[path = "../common/theory.rs"]
mod theory;

mod brute_force;
mod contact_of_bodies;
mod continuity;
mod creepage;
mod hertz;
mod limits;
mod materials;
mod paper;
mod plausibility;
mod prelude;
mod strip;
