//! FASTSIM, Kalker's simplified theory: the surface is a mattress of independent springs.
//!
//! Source: J. J. Kalker, *A fast algorithm for the simplified theory of rolling contact*, Vehicle
//! System Dynamics 11 (1982) 1-13. In a strip `y = const` the traction grows from the leading edge
//! by `dp/d(−x) = slip/L` and is cut back to the bound where it exceeds it, keeping its direction.
//! The flexibilities make small creepages exact: `L1 = 8a/(3 G C11)`, `L2 = 8a/(3 G C22)`,
//! `L3 = π a √(a/b)/(4 G C23)`.
//!
//! # Readings
//!
//! *Flexibilities* ([`Flexibility`]). `Three`: each creepage divided by its own. `Kalker`: the one
//! of the 1982 paper, `L = (|vx| L1 + |vy| L2 + √(ab) |φ| L3)/√(vx² + vy² + ab φ²)`. `Energy`: the
//! one that keeps the initial work, `1/L` weighted by the squares of the creepages. `Blended`: from
//! `Three` to `Energy` as the creepages grow, as the program CONTACT does (E. A. H. Vollebregt,
//! open-source release; facts of the method, no code): weight
//! `min(1, ⅓ √((vx² + vy² + φ²)/(vx0² + vy0² + φ0²)))` with `vx0, vy0, φ0` the creepages at which
//! the linear force is `µ N`, and `φ` in 1/mm: the weight depends on that unit.
//!
//! *Bound* ([`Bound`]). Parabolic, `2µN/(πab) (1 − r²)`, is what agrees with the spring model;
//! elliptic is Hertz's.
//!
//! *Cells* ([`Layout`]). `Strips` cuts every strip into the same number of cells; `StripEnds` takes
//! bound and slip at the trailing end of each cell, `StripCentres` at its centre. `Rectangle` is
//! CONTACT's: one rectangular grid, cells whose centre lies in the ellipse, bound at the centre,
//! slip a sixth of a cell ahead of it.
//!
//! # What reproduces the survey's figures (`tests/peers.rs`)
//!
//! * `StripEnds` with three flexibilities reproduces the survey's table for plain FASTSIM;
//!   `StripCentres` is better on every grid and costs the same, so that is the one to compare
//!   against.
//! * `Rectangle` with `Blended` reproduces "FASTSIM as in CONTACT" and the published 200x200 checks
//!   (0.596 elliptic, 0.636 parabolic).
//!
//! # Speed
//!
//! In a strip lengths are divided by its half length and tractions by its own bound at the centre
//! line, so the bound is one table for all strips. [`solve`] marches `LANES` strips side by side,
//! without branches, which hides the latency of the square root and the division and lets the
//! compiler use vectors; with `LANES = 1` it is the classical loop: a branch, and no root or
//! division in cells that stick. For a plain x86-64 build 10 lanes were the fastest of 1 to 20 for
//! 10, 20 and 50 strips: about a third of the classical loop's time for 10x10, a fifth for 50x50.

use super::{Input, Output};
use core::f64::consts::{FRAC_2_PI, FRAC_PI_4, PI};

/// Where the bound and the slip of a cell are taken. See the module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// Strips of equal cell count; bound and slip at the trailing end of each cell.
    StripEnds,
    /// Strips of equal cell count; bound and slip at the cell's centre.
    StripCentres,
    /// One rectangular grid over the bounding box.
    Rectangle,
}

/// The traction bound. See the module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bound {
    /// `3µN/(2πab) √(1 − r²)`.
    Elliptic,
    /// `2µN/(πab) (1 − r²)`.
    Parabolic,
}

/// How the flexibilities are made. See the module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flexibility {
    /// One for each creepage.
    Three,
    /// One, weighted as in the 1982 paper.
    Kalker,
    /// One, from the initial work.
    Energy,
    /// From `Three` to `Energy` as the creepages grow.
    Blended,
}

/// Everything that does not depend on the contact: made once, outside the solve.
#[derive(Clone, Copy, Debug)]
pub struct Grid<const NX: usize, const NY: usize> {
    /// Which reading.
    pub layout: Layout,
    /// Places of the bound, from the leading edge: `x/c` (strips) or `x/a` (rectangle).
    pub(super) s: [f64; NX],
    /// Places of the slip, same unit.
    pub(super) e: [f64; NX],
    /// `1 − s²`.
    pub(super) parabola: [f64; NX],
    /// `√(1 − s²)`.
    pub(super) ellipse: [f64; NX],
    /// Centre lines of the strips, `y/b`.
    pub(super) y: [f64; NY],
    /// Half lengths of the strips, `c/a = √(1 − (y/b)²)`.
    pub(super) c: [f64; NY],
    /// `a/c`.
    pub(super) c_inverse: [f64; NY],
    /// First cell of the rectangle inside the ellipse (0 for strips); the last by symmetry.
    pub(super) first: [usize; NY],
}

impl<const NX: usize, const NY: usize> Grid<NX, NY> {
    /// `NX` cells along and `NY` strips across.
    pub fn new(layout: Layout) -> Self {
        let step = 2.0 / NX as f64;
        let (at, ahead) = match layout {
            Layout::StripEnds => (1.0, 0.0),
            Layout::StripCentres => (0.5, 0.0),
            Layout::Rectangle => (0.5, 1.0 / 6.0),
        };
        let s: [f64; NX] = core::array::from_fn(|i| 1.0 - (i as f64 + at) * step);
        let y: [f64; NY] = core::array::from_fn(|j| -1.0 + (2 * j + 1) as f64 / NY as f64);
        let c = y.map(|y| ((1.0 - y) * (1.0 + y)).sqrt());
        let parabola = s.map(|s| ((1.0 - s) * (1.0 + s)).max(0.0));
        let first = c.map(|c| match layout {
            Layout::Rectangle => s.iter().position(|s| *s < c).unwrap_or(NX / 2),
            _ => 0,
        });
        Self {
            layout,
            e: s.map(|s| s + ahead * step),
            parabola,
            ellipse: parabola.map(f64::sqrt),
            c_inverse: c.map(|c| 1.0 / c),
            s,
            y,
            c,
            first,
        }
    }
}

/// `(1/L1, 1/L2, 1/L3)` with the reading asked for, the last for the spin.
#[inline(always)]
pub(super) fn stiffness(input: &Input, flexibility: Flexibility) -> [f64; 3] {
    let &Input {
        a, b, shear_modulus: g, longitudinal: vx, lateral: vy, spin, c11, c22, c23, ..
    } = input;
    let k = 3.0 * g / (8.0 * a);
    // 1/L1 = 3 G C11/(8a), 1/L2 = 3 G C22/(8a), 1/L3 = 4 G C23/(π a √(a/b))
    let three = [k * c11, k * c22, g * c23 * (b / a).sqrt() / (FRAC_PI_4 * a)];
    let energy = || {
        // the spin acts at the mean arm (π a²/4)/(8a/3) = 3πa/32
        let w = spin * (3.0 * PI / 32.0) * a;
        let (x, y, w) = (vx * vx, vy * vy, w * w);
        let sum = x + y + w;
        if sum > 0.0 { (x * three[0] + y * three[1] + w * three[2]) / sum } else { three[0] }
    };
    match flexibility {
        Flexibility::Three => three,
        Flexibility::Kalker => {
            let w = spin.abs() * (a * b).sqrt();
            let (x, y) = (vx.abs(), vy.abs());
            let sum = x / three[0] + y / three[1] + w / three[2];
            let k = if sum > 0.0 { (x * x + y * y + w * w).sqrt() / sum } else { three[0] };
            [k; 3]
        }
        Flexibility::Energy => [energy(); 3],
        Flexibility::Blended => {
            // creepages at which the linear force is µ N; spin in 1/mm
            let r = a * b;
            let d = g * r / input.bound();
            let millimetre = 1e-3;
            let (x0, y0) = (1.0 / (d * c11), 1.0 / (d * c22));
            let w0 = millimetre / (d * r.sqrt() * c23);
            let w = spin * millimetre;
            let size = ((vx * vx + vy * vy + w * w) / (x0 * x0 + y0 * y0 + w0 * w0)).sqrt();
            let weight = (size * (1.0 / 3.0)).min(1.0);
            let l = 1.0 / energy();
            three.map(|k| k / (1.0 + weight * (k * l - 1.0)))
        }
    }
}

/// Creep force and moment. `LANES` strips are marched side by side; 1 is the classical loop.
/// (Always inlined: registers are those of the caller.)
#[inline(always)]
pub fn solve<const NX: usize, const NY: usize, const LANES: usize>(
    grid: &Grid<NX, NY>, input: &Input, flexibility: Flexibility, bound: Bound,
) -> Output {
    match (grid.layout, bound) {
        (Layout::Rectangle, Bound::Parabolic) => {
            march::<NX, NY, LANES, true, true>(grid, input, flexibility)
        }
        (Layout::Rectangle, Bound::Elliptic) => {
            march::<NX, NY, LANES, true, false>(grid, input, flexibility)
        }
        (_, Bound::Parabolic) => march::<NX, NY, LANES, false, true>(grid, input, flexibility),
        (_, Bound::Elliptic) => march::<NX, NY, LANES, false, false>(grid, input, flexibility),
    }
}

#[inline(always)]
fn march<
    const NX: usize,
    const NY: usize,
    const LANES: usize,
    const RECTANGLE: bool,
    const PARABOLIC: bool,
>(
    grid: &Grid<NX, NY>, input: &Input, flexibility: Flexibility,
) -> Output {
    let &Input { a, b, .. } = input;
    let step = 2.0 / NX as f64;
    let [k1, k2, k3] = stiffness(input, flexibility);
    // tractions in units of the bound at the centre, 2µN/(πab) or 3µN/(2πab); lengths along in a
    let amplitude = if PARABOLIC { FRAC_2_PI } else { 0.75 * FRAC_2_PI };
    let unit = a * step * (a * b) / (amplitude * input.bound());
    let ux = input.longitudinal * k1 * unit;
    let uy = input.lateral * k2 * unit;
    let wx = input.spin * k3 * b * unit;
    let wy = input.spin * k3 * a * unit;

    let (mut fx, mut fy, mut mx, mut my) = (0.0, 0.0, 0.0, 0.0);
    let mut j0 = 0;
    while j0 < NY {
        // lanes beyond the last strip repeat it with no weight
        let mut dx = [0.0; LANES];
        let mut dy = [0.0; LANES];
        let mut dw = [0.0; LANES];
        let mut c2 = [0.0; LANES];
        let mut weight = [0.0; LANES];
        let mut arm = [0.0; LANES];
        let mut yy = [0.0; LANES];
        let mut first = NX;
        for l in 0..LANES {
            let j = (j0 + l).min(NY - 1);
            let (y, c) = (grid.y[j], grid.c[j]);
            // along a strip: x = c s; traction = bound at the strip's centre times q
            let (scale, spin, w) = if RECTANGLE {
                (1.0, 1.0, 1.0)
            } else if PARABOLIC {
                (grid.c_inverse[j], 1.0, c * c * c)
            } else {
                (1.0, c, c * c)
            };
            dx[l] = (ux - wx * y) * scale;
            dy[l] = uy * scale;
            dw[l] = wy * spin;
            c2[l] = c * c;
            weight[l] = if j0 + l < NY { w } else { 0.0 };
            arm[l] = if RECTANGLE { 1.0 } else { c };
            yy[l] = y;
            first = first.min(grid.first[j]);
        }
        let mut x = [0.0; LANES];
        let mut y = [0.0; LANES];
        let mut sx = [0.0; LANES];
        let mut sy = [0.0; LANES];
        let mut sm = [0.0; LANES];
        let cells = if RECTANGLE { first..NX - first } else { 0..NX };
        for i in cells {
            let (s, e) = (grid.s[i], grid.e[i]);
            for l in 0..LANES {
                let limit = if RECTANGLE {
                    // outside the ellipse the bound is zero, which also starts every row at zero
                    let q = (c2[l] - s * s).max(0.0);
                    if PARABOLIC { q } else { q.sqrt() }
                } else if PARABOLIC {
                    grid.parabola[i]
                } else {
                    grid.ellipse[i]
                };
                let px = x[l] + dx[l];
                let py = y[l] + (dy[l] + dw[l] * e);
                let t2 = px * px + py * py;
                // the traction keeps its direction and loses what exceeds the bound
                let r = if LANES == 1 {
                    if t2 > limit * limit { limit / t2.sqrt() } else { 1.0 }
                } else {
                    let r = limit / t2.sqrt();
                    if r < 1.0 { r } else { 1.0 }
                };
                x[l] = px * r;
                y[l] = py * r;
                sx[l] += x[l];
                sy[l] += y[l];
                sm[l] += y[l] * s;
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
    // area of a cell (in ab) times the amplitude
    let cell = amplitude * step * (2.0 / NY as f64);
    let ratio = (a / b).sqrt();
    Output {
        fx: cell * fx,
        fy: cell * fy,
        // M = ∫ (x py − y px), in √(ab)
        mz: cell * (ratio * my - mx / ratio),
    }
}
