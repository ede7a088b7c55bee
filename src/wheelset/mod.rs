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

mod balance;
pub mod conicity;
pub mod forces;
pub mod kinematics;
pub mod settle;
pub mod track;

/// Freedoms of a wheelset on two rails: the members of kstrip_wheel_velocity (forward, lateral,
/// vertical, roll, pitch, yaw), then lateral and vertical of the right rail, and lateral and
/// vertical of the left one.
pub const KSTRIP_WHEELSET_FREEDOMS: usize = 10;
