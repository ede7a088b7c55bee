//! What most tests use.

pub use crate::halving::{bisect, steepest};
pub use crate::header;
pub use crate::manchester::{self, drawn, points, prepared, round_head, steel, zeroed};
pub use crate::random::Random;
pub use crate::reference::numbers;
pub use crate::single::single_motion;
pub use crate::theory::{self, MODELS, any_contact, contact, creepage, options};
pub use crate::toolchain::{
    assert_told, cpp_compilers, has, output_of, read, root, run_cpp, run_source, say, scratch,
};
pub use approx::assert_relative_eq;
pub use kstrip::contact::creepage::{Creepage, Parameters};
pub use kstrip::contact::hertz::{HertzContact, Radii, hertz};
pub use kstrip::contact::material::{CombinedMaterial, Material, combine};
pub use kstrip::contact::totals::{StripCount, Totals};
pub use kstrip::contact::{Contact, from_approach, from_hertz};
pub use kstrip::forces::derivatives::Derivatives;
pub use kstrip::forces::field::FieldPoint;
pub use kstrip::forces::{
    self, Field, Model, Options, Solution, StripResult, forces_of_contact, solve_jacobian, strips,
};
pub use kstrip::friction::SlipFriction;
pub use kstrip::friction::derivatives::{Differentiated, differentiate_with_law};
pub use kstrip::friction::field::LawField;
pub use kstrip::internals::{creepage_counted, estimate_counted};
pub use kstrip::linear::LinearCoefficients;
pub use kstrip::motion::Motion;
pub use kstrip::normal::cells::Given;
pub use kstrip::normal::{Indentation, Profile, ProfileContact};
pub use kstrip::number::Float;
pub use kstrip::number::dual::Dual;
pub use kstrip::patch::field::PatchField;
pub use kstrip::patch::{
    Patch, PatchStrip, PatchView, QuadratureScale, friction as patch_friction, solver,
};
pub use kstrip::rig::fit::{MeasuredForce, fit_friction};
pub use kstrip::rig::{Measured, creepage_for_force, estimate_friction};
pub use kstrip::status::{Error, Warning};
pub use kstrip::strip_1967::strip::{Regime, SlidingRule, State, Strip};
pub use kstrip::total::Total;
pub use kstrip::wheel_rail::contacts::WheelContact;
pub use kstrip::wheel_rail::forces::wrench::{
    Law, Wrench, WrenchByPosition, WrenchDerivatives, of_contacts,
};
pub use kstrip::wheel_rail::profile::PreparedProfile;
pub use kstrip::wheel_rail::scene::{Scene, Workspace};
pub use kstrip::wheel_rail::{BodyState, Position, Requested, Velocity, WheelPair};
pub use kstrip::wheelset::forces::{Wheelset, WheelsetWorkspace};
pub use kstrip::wheelset::kinematics::Side;
pub use kstrip::wheelset::settle::WheelsetLoads;
pub use kstrip::wheelset::track::RailMotion;
pub use nalgebra::{Matrix2, Matrix3};
pub use std::collections::{BTreeMap, BTreeSet, HashMap};
pub use std::f64::consts::PI;
pub use std::mem::MaybeUninit;
pub use std::path::Path;
pub use std::ptr::null_mut;

/// A wheel on a rail.
pub const C0: Contact<f64> = Contact {
    a: 6e-3,
    b: 4.5e-3,
    normal_force: 80e3,
    shear_modulus: 82e9,
    poisson_ratio: 0.28,
    friction: 0.3,
    mismatch: 0.0,
};

pub const fn creep<F>(longitudinal: F, lateral: F, spin: F) -> Creepage<F> {
    Creepage { longitudinal, lateral, spin }
}

/// A radius of a body that is straight.
pub const FLAT: f64 = f64::INFINITY;

/// Of the lower body along and across, and of the upper one.
pub const fn radii<F: Copy>([lower_x, lower_y, upper_x, upper_y]: [F; 4]) -> Radii<F> {
    Radii { lower_x, lower_y, upper_x, upper_y }
}

/// Friction that falls with the slip, of clean bodies.
pub const fn falling(
    friction: f64, ratio: f64, decay: f64, rolling_speed: f64, slope_factor: f64,
) -> SlipFriction<f64> {
    let (slide_factor, layer) = (0.0, 0.0);
    SlipFriction { friction, ratio, decay, rolling_speed, slope_factor, slide_factor, layer }
}

/// 16 strips, as any number for the totals of the theory of 1967
/// (`limits::any_number_of_strips_has_the_same_totals`).
pub const fn sixteen(model: Model) -> Options {
    Options { model, strips: StripCount::Sixteen }
}

/// The forces, which there are.
#[track_caller]
pub fn solved<F: Float>(c: &Contact<F>, m: &Creepage<F>, o: &Options) -> Solution<F> {
    forces_of_contact(c, m, o).unwrap()
}

/// `Fx`, `Fy`, `Mz`.
pub const fn force_and_moment<F: Copy>(s: &Solution<F>) -> [F; 3] {
    [s.fx, s.fy, s.mz]
}

/// The same divided by `μ N` and `μ N √(ab)`.
pub fn normalised<F: Float>(c: &Contact<F>, s: &Solution<F>) -> [F; 3] {
    let bound = c.friction * c.normal_force;
    [s.fx / bound, s.fy / bound, s.mz / (bound * (c.a * c.b).sqrt())]
}

/// The size of what was measured of a force.
pub fn measured_size(measured: Measured, s: &Solution<f64>) -> f64 {
    match measured {
        Measured::Fx => s.fx.abs(),
        Measured::Fy => s.fy.abs(),
        Measured::Both => s.fx.hypot(s.fy),
    }
}

/// A force at its creepage, of which these components were measured.
pub fn measured_force<F: Float>(
    at: Creepage<F>, [fx, fy]: [F; 2], measured: u32,
) -> MeasuredForce<F> {
    let (Creepage { longitudinal, lateral, spin }, weight) = (at, F::one());
    MeasuredForce { longitudinal, lateral, spin, fx, fy, weight, measured, reserved: 0 }
}

/// STRIP under constant friction.
pub const STRIP: Law<f64> = Law { model: Model::Strip, falling: None };

/// A wheel and a rail with 16 strips of STRIP.
pub fn scene<'a>(
    rail: &'a PreparedProfile<f64>, wheel: &'a PreparedProfile<f64>, pair: &'a WheelPair<f64>,
) -> Scene<'a, f64> {
    Scene { rail, wheel, pair, strips: StripCount::Sixteen, law: STRIP, table: None }
}

pub const fn placed([lateral, vertical, yaw, roll]: [f64; 4]) -> Position<f64> {
    Position { lateral, vertical, yaw, roll }
}

/// All six members.
pub const fn rates(velocity: &Velocity<f64>) -> [f64; 6] {
    let Velocity { forward, lateral, vertical, roll, pitch, yaw } = *velocity;
    [forward, lateral, vertical, roll, pitch, yaw]
}
