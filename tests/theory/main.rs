//! The theory of 1967 and what it stands on: the paper, Hertz, materials, creepages, limits.

mod brute_force;
mod contact_of_bodies;
mod continuity;
mod creepage;
mod hertz;
mod limits;
mod materials;
mod paper;
mod plausibility;
mod strip;
