//! The wheelset: two wheels on two rails.
//!
//! Axes of the track: `x` forward, `y` to the right, `z` down; its middle lies between the gauge
//! faces. The right side is number 0, the left side number 1.
//!
//! 1. [`track`] finds the places of the rails from the gauge, and the velocity and the weight of a
//!    body on a curved and canted track.
//! 2. [`kinematics`] has position and velocity of each wheel over its rail, with their derivatives.
//! 3. [`forces`] adds the wrenches of both wheels, with derivatives with respect to velocities and
//!    positions of the wheelset and of both rails.
//! 4. [`settle`] finds height, roll and pitch rate for given loads, with the steps of `balance`.
//! 5. [`conicity`] has the difference of the rolling radii against the lateral shift, and
//!    equivalent conicity.
//!
//! Ten velocities `u` describe a wheelset on two rails that move: the six of the wheelset, and two
//! of each rail. Each wheel moves over its rail with `w = A u`, so that virtual power gives the ten
//! forces from the wrenches `W` of the wheels:
//!
//! ```text
//! Q = Σ Aᵀ W(q, A u)
//! ∂Q/∂u = Σ Aᵀ ∂W/∂w A,   ∂Q/∂q = Σ Aᵀ (∂W/∂q + ∂W/∂w ∂A/∂q u) + ∂Aᵀ/∂q W
//! ```
//!
//! # Example
//!
//! Wheels with treads of 1:20 on round rails, 3 mm to the right of the middle. The right wheel
//! rolls on the larger radius, and the creep forces turn the wheelset to the left, toward the
//! middle:
//! ```
//! use kstrip::contact::totals::StripCount;
//! use kstrip::forces::Model;
//! use kstrip::status::Error;
//! use kstrip::wheel_rail::forces::wrench::Law;
//! use kstrip::wheel_rail::{BodyState, Position, Velocity, WheelPair};
//! use kstrip::wheel_rail::{profile::PreparedProfile, scene::Scene};
//! use kstrip::wheelset::forces::{Wheelset, WheelsetWorkspace};
//! use kstrip::wheelset::{kinematics::Side, settle::WheelsetLoads};
//! fn prepared(z: impl Fn(f64) -> f64) -> Result<Box<PreparedProfile<f64>>, Error> {
//!     let y: Vec<f64> = (-100..=100).map(|k| f64::from(k) * 0.3e-3).collect();
//!     let z: Vec<f64> = y.iter().map(|y| z(*y)).collect();
//!     let mut profile = Box::new(PreparedProfile::new());
//!     profile.prepare(&y, &z, 0.0, 0.0)?;
//!     Ok(profile)
//! }
//! let (rail, wheel) = (prepared(|y| y * y / 0.6)?, prepared(|y| -y / 20.0)?);
//! let right = WheelPair {
//!     wheel_radius: 0.46, shear_modulus: 82e9, poisson_ratio: 0.28, friction: 0.3,
//!     ..WheelPair::default()
//! };
//! let left = WheelPair { left: 1, ..right };
//! let law = Law { model: Model::Strip, falling: None };
//! let (strips, table) = (StripCount::Sixteen, None);
//! let scene = |pair| Scene { rail: &rail, wheel: &wheel, pair, strips, law, table };
//! // 0.75 m from the middle of the wheelset to the running circles, and of the track to the rails
//! let sides = [Side::right(0.75, 0.75), Side::left(0.75, 0.75)];
//! let wheelset = Wheelset { scenes: [scene(&right), scene(&left)], sides };
//! let start = BodyState {
//!     position: Position { lateral: 3e-3, ..Position::default() },
//!     velocity: Velocity { forward: 20.0, ..Velocity::default() },
//! };
//! let loads = WheelsetLoads { vertical: 100e3, ..WheelsetLoads::default() };
//! let mut memory = Box::new(WheelsetWorkspace::new());
//! let still = wheelset.settle(&start, &loads, &mut memory)?;
//! let found = wheelset.solve(&still.state, &mut memory)?;
//! assert!((found.rail[0][2] + found.rail[1][2] - 100e3).abs() < 1.0);
//! assert!(found.wrench.moment[2] < -1e3);
//! # Ok::<(), Error>(())
//! ```

mod balance;
pub mod conicity;
pub mod forces;
pub mod kinematics;
mod lifted;
pub mod settle;
pub mod track;

/// Degrees of freedom of a wheelset on two rails: the members of kstrip_wheel_velocity (forward,
/// lateral, vertical, roll, pitch, yaw), then lateral and vertical of the right rail, and lateral
/// and vertical of the left one.
pub const KSTRIP_WHEELSET_FREEDOMS: usize = 10;
