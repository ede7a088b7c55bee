//! Parts of the library by themselves: Kalker's coefficients, the models' totals, strips, searches,
//! registers.

mod check;
mod cube_root;
mod lanes;
mod linear;
mod rig;
mod strip;
mod total;
