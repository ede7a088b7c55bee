//! FaStrip: Kalker's strip theory in the adhesion area, FASTSIM in the slip area.
//!
//! Source: M. Sh. Sichani, R. Enblom, M. Berg, *An alternative to FASTSIM for tangential solution
//! of the wheel-rail contact*, Vehicle System Dynamics 54 (2016) 748-764. The strip parameters are
//! rescaled so that small creepages are exact, `ξ → ξ C11/C11(strip)` and so on with
//! `C(strip) = π²/(4(1−ν)), π²/4, (π/3)√(a/b)`; ahead of the separatrix the traction is the strip
//! theory's (1967, equations 5.1, 5.40, 5.41), behind it FASTSIM gives the direction. The strip
//! theory has no adhesion for a rescaled `|ψ| ≥ 1`; FASTSIM then has the whole ellipse.
//!
//! # Readings
//!
//! [`solve`] is the paper as we read it: strips of equal cell count, the slip area marched on from
//! the strip theory's last adhesion cell under the parabolic bound, and only its direction used:
//! the size in the slip area is Hertz's bound. What the paper's flexibility is, we could not
//! establish. With `Flexibility::Kalker` the mean and the 95th percentile of the survey
//! (`tests/peers.rs`) come out within 6 % (its maximum is 0.18, ours 0.22); `Flexibility::Energy`
//! is better throughout, and is the one to compare against. The published 200x200 check (0.644)
//! lies between the two.
//!
//! Both sum the traction over cell centres, as published. Near the linear limit the strip theory's
//! traction is singular at the trailing edge and that sum misses `0.385/√n` of the force (5 % with
//! 50 cells).
//!
//! [`solve_contact`] follows CONTACT's description of its own FaStrip: its rectangular grid and
//! blended flexibilities, and FASTSIM's traction kept as it is wherever the strip theory slips,
//! also where FASTSIM sticks. Means and 95th percentiles come within 12 % of the table's, not
//! closer.

use super::fastsim::{Flexibility, Grid, Layout, stiffness};
use super::{Input, Output};
use core::f64::consts::{FRAC_2_PI, PI};

/// Strip parameters (1967, equation 5.13), rescaled to the exact coefficients.
struct Parameters {
    xi: f64,
    eta: f64,
    psi: f64,
    /// `ψ (b/a)/(1 − ν)`, so that `ξ̄ = ξ − slope y/b`.
    slope: f64,
    /// The strip theory has no adhesion anywhere.
    none: bool,
}

#[inline(always)]
fn parameters(input: &Input) -> Parameters {
    let (lx, ly, ls) = input.linear();
    // ξ' = (4/3π) C11 vx Gab/(µN), η' likewise, ψ' = C23 φ G(ab)^{3/2}/(µN)
    let k = 4.0 / (3.0 * PI);
    let psi = ls;
    Parameters {
        xi: k * lx,
        eta: k * ly,
        psi,
        slope: psi * (input.b / input.a) / (1.0 - input.poisson_ratio),
        none: psi.abs() >= 1.0 - 1e-6,
    }
}

impl Parameters {
    /// `(ξ̄, κ/a)` of the strip at `y/b`.
    #[inline(always)]
    fn strip(&self, y: f64) -> (f64, f64) {
        let xb = self.xi - self.slope * y;
        let (e, p) = (self.eta, self.psi);
        let rest = 1.0 - p * p;
        // S = √(η² + (1 − ψ²) ξ̄²)
        let s = (e * e + rest * xb * xb).sqrt();
        // κ/a = (S + ηψ)/(1 − ψ²) = (ξ̄² + η²)/(S − ηψ), the form that does not cancel
        let kappa = if e * p >= 0.0 { (s + e * p) / rest } else { (xb * xb + e * e) / (s - e * p) };
        (xb, kappa)
    }
}

/// Creep force and moment on strips of equal cell count, `LANES` strips side by side.
///
/// The grid must be `Layout::StripCentres`.
#[inline]
pub fn solve<const NX: usize, const NY: usize, const LANES: usize>(
    grid: &Grid<NX, NY>, input: &Input, flexibility: Flexibility,
) -> Output {
    debug_assert_eq!(grid.layout, Layout::StripCentres);
    let &Input { a, b, .. } = input;
    let step = 2.0 / NX as f64;
    let p = parameters(input);
    let [k1, k2, k3] = stiffness(input, flexibility);
    // FASTSIM's state in units of the parabolic bound at the strip's centre, 2µN/(πab) C²
    let unit = a * step * (a * b) / (FRAC_2_PI * input.bound());
    let ux = input.longitudinal * k1 * unit;
    let uy = input.lateral * k2 * unit;
    let wx = input.spin * k3 * b * unit;
    let wy = input.spin * k3 * a * unit;
    // the slip is taken in the middle of the step from centre to centre
    let ahead = 0.5 * step;

    let (mut fx, mut fy, mut mx, mut my) = (0.0, 0.0, 0.0, 0.0);
    let mut j0 = 0;
    while j0 < NY {
        let mut dx = [0.0; LANES];
        let mut dy = [0.0; LANES];
        let mut alpha = [0.0; LANES];
        let mut beta = [0.0; LANES];
        let mut behind = [0.0; LANES];
        let mut to_state = [0.0; LANES];
        let mut weight = [0.0; LANES];
        let mut arm = [0.0; LANES];
        let mut yy = [0.0; LANES];
        for l in 0..LANES {
            let j = (j0 + l).min(NY - 1);
            let (y, c, ci) = (grid.y[j], grid.c[j], grid.c_inverse[j]);
            dx[l] = (ux - wx * y) * ci;
            dy[l] = uy * ci;
            if p.none {
                behind[l] = -4.0;
            } else {
                let (xb, kappa) = p.strip(y);
                // α = a ξ̄/κ, β = a η/κ;  adhesion where 1 + s − 2κ/c > 0
                let k = 1.0 / kappa.max(1e-300);
                alpha[l] = xb * k;
                beta[l] = p.eta * k;
                behind[l] = 1.0 - 2.0 * kappa * ci;
            }
            // Hertz's bound at the strip's centre, µp0 C, over the parabolic one
            to_state[l] = 0.75 * ci;
            weight[l] = if j0 + l < NY { c * c } else { 0.0 };
            arm[l] = c;
            yy[l] = y;
        }
        let mut x = [0.0; LANES];
        let mut y = [0.0; LANES];
        let mut sx = [0.0; LANES];
        let mut sy = [0.0; LANES];
        let mut sm = [0.0; LANES];
        for i in 0..NX {
            let s = grid.s[i];
            let e = s + ahead;
            let (limit, full) = (grid.parabola[i], grid.ellipse[i]);
            for l in 0..LANES {
                let inside = behind[l] + s;
                if LANES == 1 {
                    let (qx, qy);
                    if inside > 0.0 {
                        let rest = ((1.0 - s) * inside).sqrt();
                        qx = alpha[l] * (full - rest);
                        qy = p.psi * full + beta[l] * (full - rest);
                        x[l] = qx * to_state[l];
                        y[l] = qy * to_state[l];
                    } else {
                        let px = x[l] + dx[l];
                        let py = y[l] + (dy[l] + wy * e);
                        let r = 1.0 / (px * px + py * py + 1e-300).sqrt();
                        let cut = (limit * r).min(1.0);
                        x[l] = px * cut;
                        y[l] = py * cut;
                        qx = px * (full * r);
                        qy = py * (full * r);
                    }
                    sx[l] += qx;
                    sy[l] += qy;
                    sm[l] += qy * s;
                    continue;
                }
                // X = µp0 (α √(c²−x²) − α √(h²−x'²))/a,  Y = µp0 ((β+ψ) √(c²−x²) − β √(h²−x'²))/a
                let rest = ((1.0 - s) * inside.max(0.0)).sqrt();
                let ax = alpha[l] * (full - rest);
                let ay = p.psi * full + beta[l] * (full - rest);
                // FASTSIM: direction in the slip area
                let px = x[l] + dx[l];
                let py = y[l] + (dy[l] + wy * e);
                let r = 1.0 / (px * px + py * py + 1e-300).sqrt();
                let cut = if limit * r < 1.0 { limit * r } else { 1.0 };
                let stick = inside > 0.0;
                x[l] = if stick { ax * to_state[l] } else { px * cut };
                y[l] = if stick { ay * to_state[l] } else { py * cut };
                let qx = if stick { ax } else { px * (full * r) };
                let qy = if stick { ay } else { py * (full * r) };
                sx[l] += qx;
                sy[l] += qy;
                sm[l] += qy * s;
            }
        }
        for l in 0..LANES {
            fx += weight[l] * sx[l];
            fy += weight[l] * sy[l];
            mx += weight[l] * yy[l] * sx[l];
            my += weight[l] * arm[l] * sm[l];
        }
        j0 += LANES;
    }
    let cell = 0.75 * FRAC_2_PI * step * (2.0 / NY as f64);
    let ratio = (a / b).sqrt();
    Output { fx: cell * fx, fy: cell * fy, mz: cell * (ratio * my - mx / ratio) }
}

/// Creep force and moment as CONTACT describes its FaStrip, `LANES` rows side by side.
///
/// The grid must be `Layout::Rectangle`.
#[inline]
pub fn solve_contact<const NX: usize, const NY: usize, const LANES: usize>(
    grid: &Grid<NX, NY>, input: &Input,
) -> Output {
    debug_assert_eq!(grid.layout, Layout::Rectangle);
    let &Input { a, b, .. } = input;
    let step = 2.0 / NX as f64;
    let p = parameters(input);
    let [k1, k2, k3] = stiffness(input, Flexibility::Blended);
    let unit = a * step * (a * b) / (FRAC_2_PI * input.bound());
    let ux = input.longitudinal * k1 * unit;
    let uy = input.lateral * k2 * unit;
    let wx = input.spin * k3 * b * unit;
    let wy = input.spin * k3 * a * unit;
    let nu = 1.0 - input.poisson_ratio;

    let (mut fx, mut fy, mut mx, mut my) = (0.0, 0.0, 0.0, 0.0);
    let mut j0 = 0;
    while j0 < NY {
        let mut dx = [0.0; LANES];
        let mut c2 = [0.0; LANES];
        let mut alpha = [0.0; LANES];
        let mut gamma = [0.0; LANES];
        let mut half = [0.0; LANES];
        let mut kappa = [0.0; LANES];
        let mut weight = [0.0; LANES];
        let mut yy = [0.0; LANES];
        let mut first = NX;
        for l in 0..LANES {
            let j = (j0 + l).min(NY - 1);
            let y = grid.y[j];
            dx[l] = ux - wx * y;
            c2[l] = grid.c[j] * grid.c[j];
            // half length of the row, counted in cells
            half[l] = (NX - 2 * grid.first[j]) as f64 * 0.5 * step;
            kappa[l] = half[l];
            if !p.none {
                let (xb, k) = p.strip(y);
                kappa[l] = k;
                // the direction at the separatrix, with CONTACT's factors (1 − ν)
                let (ux, uy) = (nu * xb, nu * p.eta + p.psi * k);
                let r = 1.0 / (ux * ux + uy * uy).max(1e-20).sqrt();
                (alpha[l], gamma[l]) = (ux * r, uy * r);
            }
            weight[l] = if j0 + l < NY { 1.0 } else { 0.0 };
            yy[l] = y;
            first = first.min(grid.first[j]);
        }
        let mut x = [0.0; LANES];
        let mut y = [0.0; LANES];
        let mut sx = [0.0; LANES];
        let mut sy = [0.0; LANES];
        let mut sm = [0.0; LANES];
        for i in first..NX - first {
            let (s, e) = (grid.s[i], grid.e[i]);
            for l in 0..LANES {
                let limit = (c2[l] - s * s).max(0.0);
                let px = x[l] + dx[l];
                let py = y[l] + (uy + wy * e);
                let r = limit / (px * px + py * py).sqrt();
                let r = if r < 1.0 { r } else { 1.0 };
                x[l] = px * r;
                y[l] = py * r;
                let (h, k) = (half[l], kappa[l]);
                let full = (h * h - s * s).max(0.0).sqrt();
                // (h − κ)² − (x − κ)² = (h − x)(h + x − 2κ)
                let inside = h + s - 2.0 * k;
                let rest = ((h - s) * inside).max(0.0).sqrt();
                let stick = (inside > 0.0) & (limit > 0.0);
                let ax = 0.75 * alpha[l] * (full - rest);
                let ay = 0.75 * (gamma[l] * (full - rest) + p.psi * rest);
                let qx = if stick { ax } else { x[l] };
                let qy = if stick { ay } else { y[l] };
                sx[l] += qx;
                sy[l] += qy;
                sm[l] += qy * s;
            }
        }
        for l in 0..LANES {
            fx += weight[l] * sx[l];
            fy += weight[l] * sy[l];
            mx += weight[l] * yy[l] * sx[l];
            my += weight[l] * sm[l];
        }
        j0 += LANES;
    }
    let cell = FRAC_2_PI * step * (2.0 / NY as f64);
    let ratio = (a / b).sqrt();
    Output { fx: cell * fx, fy: cell * fy, mz: cell * (ratio * my - mx / ratio) }
}
