//! The other methods: what people use today for creep forces, written from the published
//! algorithms so that speed and error can be measured in one run beside this library.
//!
//! Bench-only. Nothing here depends on the library, nothing allocates, and every solver is
//! written to be fast: a slow straw man proves nothing. Include the directory with
//! `#[path = "../benches/peers/mod.rs"] mod peers;`.
//!
//! | module | method | source |
//! |---|---|---|
//! | [`fastsim`] | FASTSIM; 1, 3 or blended flexibilities, either bound | Kalker 1982 |
//! | [`fastrip`] | strip theory where it adheres, FASTSIM in slip | Sichani, Enblom, Berg 2016 |
//! | [`vermeulen_johnson`] | closed form without spin | Vermeulen, Johnson 1964 |
//! | [`shen_hedrick_elkins`] | cubic saturation of the linear theory | these authors, 1983 |
//! | [`polach`] | closed form with spin | Polach 1999 |
//!
//! # Axes and signs
//!
//! `x` is the rolling direction, the slip is that of the upper body over the lower,
//! `(vx − φ y, vy + φ x)`, and the force acts on the LOWER body, positive along the slip.
//! The literature often gives the force on the other body, with the opposite sign.
//!
//! # What the numbers of `tests/peers.rs` mean
//!
//! Published papers leave details open (where in a cell the bound is taken, where the slip is
//! evaluated, how three flexibilities become one). Each module says which readings it offers and
//! which of them reproduces the figures of the survey there.

#![forbid(unsafe_code)]
#![allow(dead_code)]

pub mod fastrip;
pub mod fastsim;
pub mod polach;
pub mod shen_hedrick_elkins;
pub mod vermeulen_johnson;

/// One contact and its creepages: what every method needs. SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input {
    /// Semi-axis `a` of the contact ellipse in the rolling direction \[m\].
    pub a: f64,
    /// Semi-axis `b` of the contact ellipse in the lateral direction \[m\].
    pub b: f64,
    /// Normal force `N` \[N\].
    pub normal_force: f64,
    /// Combined shear modulus `G` \[Pa\].
    pub shear_modulus: f64,
    /// Combined Poisson ratio `ν`, 0 to 0.5.
    pub poisson_ratio: f64,
    /// Coulomb friction coefficient `µ`.
    pub friction: f64,
    /// Longitudinal creepage `vx`.
    pub longitudinal: f64,
    /// Lateral creepage `vy`.
    pub lateral: f64,
    /// Spin creepage `φ` \[1/m\].
    pub spin: f64,
    /// Kalker's coefficient `C11` of the linear theory for this `a/b` and `ν`.
    pub c11: f64,
    /// Kalker's coefficient `C22`.
    pub c22: f64,
    /// Kalker's coefficient `C23` (equal to `−C32`).
    pub c23: f64,
}

impl Input {
    /// `µ N` \[N\], the unit of the forces.
    #[inline(always)]
    pub fn bound(&self) -> f64 {
        self.friction * self.normal_force
    }

    /// The force of the linear theory in units of `µ N`:
    /// `(G ab C11 vx, G ab C22 vy, G (ab)^{3/2} C23 φ)/(µ N)`.
    #[inline(always)]
    pub fn linear(&self) -> (f64, f64, f64) {
        let ab = self.a * self.b;
        let k = self.shear_modulus * ab / self.bound();
        (
            k * self.c11 * self.longitudinal,
            k * self.c22 * self.lateral,
            k * ab.sqrt() * self.c23 * self.spin,
        )
    }
}

/// Force and moment on the LOWER body, positive along the slip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Output {
    /// Longitudinal force in units of `µ N`.
    pub fx: f64,
    /// Lateral force in units of `µ N`.
    pub fy: f64,
    /// Moment about the centre, `∫(x py − y px)`, in units of `µ N √(ab)`;
    /// NaN where the method does not give one.
    pub mz: f64,
}
