//! Creep forces of rolling contact by Kalker's strip theory.
//!
//! Two bodies roll over each other, pressed together with a force `N`. They touch in an ellipse
//! with semi-axes `a` (along the rolling direction) and `b` (across it), and slip a little there.
//! The slip causes the creep forces, which steer a railway wheel and heat a disc. J. J. Kalker's *A
//! strip theory for rolling with slip and spin* (Proc. Kon. Ned. Akad. Wetenschappen B 70 (1967)
//! 10–62) gives these forces in closed form. The ellipse is cut into strips along the rolling
//! direction; each strip is a plane problem with an adhesion area at its leading edge and slip
//! behind it.
//!
//! The modules follow the physics, from the bodies to the results:
//!
//! 1. [`contact`]: two bodies, their elastic constants, Hertz's ellipse, creepages from velocities.
//! 2. [`linear`]: Kalker's coefficients and his linear theory.
//! 3. [`strip_1967`]: the theory of the paper. [`strip`]: its strips with flexibilities fitted to
//!    CONTACT. [`total`]: a closed formula for force and moment, fitted to CONTACT.
//! 4. [`forces`]: results and derivatives of a contact and a creepage, for every model. [`batch`]:
//!    many contacts at once.
//! 5. [`friction`]: falling friction. [`motion`]: rolling forward, backward, and
//!    standstill. [`rig`]: from a measured force to friction, from a requested force to creepage.
//! 6. [`patch`]: a patch of any shape as its strips. [`wheel_rail`]: from two profiles and a
//!    position to the force and the moment on a wheel. [`wheelset`]: two wheels on two rails.
//! 7. [`number`]: the types of number that the formulas are written in. [`numerics`]: interpolation
//!    and root searches. [`ffi`]: the functions for C (`include/kstrip.h`).
//!
//! # Axes and signs
//!
//! `x` points in the rolling direction (leading edge at `x > 0`), `y` is lateral, `z` points into
//! the lower body. Creepage is the velocity of the upper body relative to the lower body, divided
//! by the rolling speed. Forces and tractions act on the **lower** body, and have the sense of the
//! slip. All quantities have SI units.
//!
//! # Promises
//!
//! No function allocates or panics, no result depends on earlier calls, and nothing depends on
//! `std`. The same code runs on a PC and on a microcontroller, in `f64` and in `f32`.
//!
//! # Example
//!
//! A wheel of 0.46 m radius on a rail head of 0.30 m, 80 kN, 0.1 % longitudinal creepage:
//! ```
//! use kstrip::contact::{Contact, creepage::Creepage, hertz, material};
//! use kstrip::forces;
//! let steel = material::Material { shear_modulus: 82e9, poisson_ratio: 0.28 };
//! let pair = material::combine(&steel, &steel)?;
//! let radii = hertz::Radii {
//!     lower_x: f64::INFINITY, lower_y: 0.30, upper_x: 0.46, upper_y: f64::INFINITY,
//! };
//! let ellipse = hertz::hertz(&radii, 80e3, pair.shear_modulus, pair.poisson_ratio)?;
//! let contact = Contact {
//!     a: ellipse.a, b: ellipse.b, normal_force: 80e3,
//!     shear_modulus: pair.shear_modulus, poisson_ratio: pair.poisson_ratio, friction: 0.3,
//!     mismatch: 0.0,
//! };
//! let creepage = Creepage { longitudinal: 1e-3, lateral: 0.0, spin: 0.0 };
//! let found = forces::forces_of_contact(&contact, &creepage, &forces::Options::default())?;
//! assert!(found.fx > 0.0 && found.fx < 0.3 * 80e3);
//! # Ok::<(), kstrip::status::Error>(())
//! ```
//!
//! Profiles and workspaces are large structures of plain numbers, and `new()` makes empty ones as
//! constants. A static holds them without any stack. `Box::new` puts them on the heap; an
//! unoptimised build passes them over the stack, of which the largest takes less than 150 kB:
//! ```
//! use kstrip::wheel_rail::{profile::PreparedProfile, scene::Workspace};
//! use std::sync::Mutex;
//! static MEMORY: Mutex<Workspace<f64>> = Mutex::new(Workspace::new());
//! let (y, z): (Vec<f64>, Vec<f64>) = (-100..=100)
//!     .map(|k| f64::from(k) * 0.3e-3)
//!     .map(|y| (y, 0.3 - (0.09 - y * y).sqrt()))
//!     .unzip();
//! let mut rail = Box::new(PreparedProfile::new());
//! rail.prepare(&y, &z, 0.0, 0.0)?;
//! assert!(MEMORY.lock().is_ok_and(|memory| memory.found().is_empty()));
//! assert!(size_of::<kstrip::wheelset::forces::WheelsetWorkspace<f64>>() < 150_000);
//! # Ok::<(), kstrip::status::Error>(())
//! ```
//!
//! More examples:
//!
//! * many contacts at once: [`batch::solve_batch`];
//! * a wheelset on a track: [`wheelset`](wheelset#example);
//! * programs in `examples`: `creep_curve.rs` computes a creep curve, `measured_curve.rs` fits a
//!   law of friction to measured forces, and `wheelset.rs` integrates the motion of a wheelset that
//!   hunts, brakes to a stop, rolls back and lifts a wheel.

#![no_std]
#![deny(missing_docs, unsafe_code)]
// What only abilities use that are left out.
#![cfg_attr(
    not(all(feature = "batch", feature = "fit", feature = "patches", feature = "wheels")),
    allow(dead_code, unused_imports)
)]

pub mod batch;
pub mod contact;
pub mod ffi;
pub mod forces;
pub mod friction;
#[doc(hidden)]
pub mod internals;
pub(crate) mod layer;
pub mod linear;
pub mod motion;
pub mod normal;
pub mod number;
pub mod numerics;
pub mod patch;
pub mod profile_file;
pub mod rig;
pub mod status;
pub mod strip;
pub mod strip_1967;
#[cfg(feature = "tables")]
pub mod table;
pub mod total;
pub mod wheel_rail;
pub mod wheelset;

/// A library without `std` needs a panic handler; nothing reaches it.
#[cfg(all(feature = "panic-handler", panic = "abort"))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    a_panic_can_be_reached()
}

/// Not in the optimised library, as `scripts/no_panic.sh` and `scripts/firmware.sh` prove: they
/// look for its name.
#[cfg(all(feature = "panic-handler", panic = "abort"))]
#[inline(never)]
fn a_panic_can_be_reached() -> ! {
    loop {
        core::hint::spin_loop();
    }
}

/// The programs of docs/start/rust.md run as tests.
#[cfg(doctest)]
#[doc = include_str!("../docs/start/rust.md")]
struct StartInRust;
