//! Total forces of a contact, without strips: the recommended model when only `Fx, Fy, Mz` are wanted.
//!
//! An equivalent creep force `q` is put through the saturation curve of strip theory, which is
//! exact for pure creepage in slender contacts (8.15): `F = h S(|q|) q/|q|`. For vanishing
//! creepage `q` is the force of the linear theory. What lies in between, above all the
//! interplay of spin and creepage, is corrected by factors that a small network computes from a
//! few squashed dimensionless numbers; its constants are fitted to about 16 000 cases computed
//! with CONTACT by `fit/fit_total.py`.
//!
//! What holds by construction, whatever the constants:
//! * `|F| ≤ μ N`, `Mz` bounded.
//! * Linear theory for small creepage: every correction carries the weight
//!   `w = n²/(0.05 + n²)`, `n` the size of the linear force.
//! * Saturation: `|F| → μ N` along the rigid slip when translation dominates, and `Mz → 0`.
//! * Symmetry: the network sees only combinations that do not change when the sign of `vx`
//!   changes, or the signs of `vy` and spin together.
//! * Dissipation: `fx vx + fy vy + mz φ ≥ 0`. The spin part of `fy` returns in `mz` with the opposite
//!   sign (as `C23` does in the linear theory), what remains is a positive quadratic form.
//! * Once continuously differentiable in creepage and spin, everywhere.
//!
//! Nothing but `+ − × ÷ √`: activations are `2x/(1 + x²)`, positive factors `1 + 2o + 1.01 o²`, and the
//! saturation curve is a polynomial within 2e-4 of (8.15).

mod constants;

use self::constants::{FIRST, FIXED, LAST, LAST_BIAS, SECOND};
use crate::linear::{LinearCoefficients, widen};
use crate::number::{Arithmetic, Float, Map, Number, Pair, Plain, Quad};

/// Forces of a whole contact, dimensionless, on the lower body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TotalForce<T> {
    /// `Fx/(μ N)`
    pub fx: T,
    /// `Fy/(μ N)`
    pub fy: T,
    /// `Mz/(μ N √(a b))`, about the centre of the contact.
    pub mz: T,
}

/// Axis ratios that the formulas are evaluated with; fitted are 0.1 to 10.
const RATIO_LIMIT: f64 = 1e3;
/// Root of the largest axis ratio that the network is told: beyond it, the formulas around it know the limits.
const LARGEST_ROOT: f64 = 4.0;
/// Creepages beyond this, or beyond what the floating-point type allows, are scaled down together:
/// sliding, to rounding.
const CREEPAGE_LIMIT: f64 = 1e16;

/// Creepages below this, times the smallest normal number, have lost digits, or have products that will.
const LOST: f64 = 1e6;

/// Spin force of the linear theory beyond which creepage and spin are scaled down together.
const SPIN_LIMIT: f64 = 16.0;

/// Share of the squared spin force in the `|q|²` that the saturation curve sees: spin shears the patch also where its
/// force and that of the creepage cancel. Without it `S(|q|)/|q|` has a cone there, and `dMz/dvy` jumps.
const SHEAR: f64 = 0.04;

/// What the network is told that depends on the contact only, and the rest.
const FIXED_INPUTS: usize = FIXED.len() - 1;
const INPUTS: usize = FIRST.len();
/// Units of the two hidden layers, in pairs.
const PAIRS_1: usize = SECOND.len() / 2;
const UNITS_1: usize = 2 * PAIRS_1;
const PAIRS_2: usize = LAST[0].len();

/// `S/|q|` in powers of `|q|` up to full sliding, `|q| = 3π/4`, lowest first. Printed by `fit/fit_total.py`: least
/// maximum error of `S`, 1.5e-4, with the exact slope at 0 and none at full sliding.
const SATURATION: [f64; 6] = [
    1.0,
    -0.26497443542200877,
    -0.016982827409411667,
    0.023171947269272353,
    -0.009070529546294396,
    0.0016453016098987088,
];

/// Total force for creepages `vx, vy = G a b (υx, υy)/(μ N)` and spin `φ = G (a b)^{3/2} ϕ/(μ N)`.
///
/// `axis_ratio` is `a/b`, `linear` the coefficients for it. Fitted for `a/b` 0.1 to 10, `ν` 0 to 1/2 and
/// `|ψ| = (π/3) √(a/b) |φ| ≤ 3`; beyond that finite, bounded and with the right limits, but not accurate.
#[must_use]
pub fn total<T: Number>(
    axis_ratio: T::Base,
    poisson_ratio: T::Base,
    linear: &LinearCoefficients<T::Base>,
    creepage: [T; 3],
) -> TotalForce<T> {
    wanted_total::<T, true>(axis_ratio, poisson_ratio, linear, creepage)
}

/// [`total`] without the moment, which is zero then: the compiler leaves out what leads to it.
#[inline(always)]
pub(crate) fn wanted_total<T: Number, const MOMENT: bool>(
    axis_ratio: T::Base,
    poisson_ratio: T::Base,
    linear: &LinearCoefficients<T::Base>,
    creepage: [T; 3],
) -> TotalForce<T> {
    let one = T::one();
    let g = axis_ratio.clamped(T::Base::of(1.0 / RATIO_LIMIT), T::Base::of(RATIO_LIMIT));
    let LinearCoefficients { c11, c22, c23, c33 } = *linear;
    let [vx, vy, phi] = within_range(creepage, c23);
    let root = g.sqrt();
    let [inverse2, moment] =
        divide([T::Base::one(), g.times(1.0 / 0.1406)], [g, (g * g + g.times(0.467)).plus(1.0)]);
    let inverse = root * inverse2;
    let both = g + inverse2;
    let shape = root.clamped(T::Base::of(1.0 / LARGEST_ROOT), T::Base::of(LARGEST_ROOT));
    let slender = shape.plus(-1.0) / shape.plus(1.0);
    let poisson = poisson_ratio.times(4.0).plus(-1.0);

    // creepage against spin at the ends of the axes
    let vy2 = vy * vy;
    let phi2 = phi * phi;
    let py2 = phi2.scale(g);
    let p2 = phi2.scale(both);
    let [kappa, f_y] =
        divide([p2, py2], [(vx * vx + vy2 + p2).plus(1e-12), (vy2 + py2).plus(0.002)]);
    // the force of the linear theory, lateral force with and without spin
    let lx = vx.scale(c11);
    let ly = vy.scale(c22);
    let ls = phi.scale(c23);
    let lys = ly + ls;
    let lx2 = lx * lx;
    let ly2 = ly * ly;
    let u2 = lx2 + ly2;
    let s2 = ls * ls;
    // spin against the size of the patch: slip at the ends of the axes, moment over its sliding limit
    let tx = phi.scale(c11 * (inverse + root.times(0.27)).times(1.0 / 1.5));
    let ty = phi.scale(c22 * (root + inverse.times(0.27)).times(1.0 / 1.5));
    let tm = phi.scale(c33);
    let tm2 = (tm * tm).scale(moment);
    let n2 = u2 + s2 + tm2;
    let px = (tx * tx).plus(1.0);
    let py = (ty * ty).plus(1.0);
    // size of the creep force braked by spin: e² = lx²/px + ly²/py = n/p
    let p = px * py;
    let lx2_py = lx2 * py;
    let n = lx2_py + ly2 * px;
    let [f_e, f_es, ix, iy, im, f_s, f_u, f_ys, f_s4, w, d_s, _] = divide(
        [one, ly * ls * p, one, one, one, one, one, lys * ls, one, n2, one, one],
        [
            p + n,
            p + n + s2 * p,
            px,
            py,
            (tm2 + u2).plus(1.0),
            s2.plus(1.0),
            u2.times(0.5).plus(1.0),
            (lys * lys + s2).plus(1.0),
            (s2 * s2).plus(1.0),
            n2.plus(0.05),
            (s2 + u2.times(0.3)).plus(1.0),
            one,
        ],
    );
    let f_ex = lx2_py * f_e;
    let f_e = p * f_e;

    let network = Network { fixed: [slender, poisson] };
    let inputs = [
        kappa,
        kappa.scale(slender),
        f_y,
        f_s,
        f_s4,
        f_u,
        f_s.scale(slender),
        f_ys,
        f_e,
        f_ex,
        f_es,
        f_e.scale(slender),
        f_e * kappa,
        f_e * f_s,
        ix,
        im,
    ];
    let [k1, k2, k3, k4, rho, k6] = T::each(&T::map(&network, inputs), |o| *o * w);
    let [k1, k2, k3, k4, k6] =
        T::each(&[k1, k2, k3, k4, k6], |o| (*o * o.times(1.01).plus(2.0)).plus(1.0));

    // how spin brakes the two slopes and the spin moment
    let [dx, dy, dm, _] = roots([ix, iy, im, im]);
    let e2 = lx2 * ix + ly2 * iy;
    let d_e = one / (e2 * e2).times(0.1).plus(1.0);
    let rho = twice(rho) * d_e / (rho * rho).plus(1.0);
    // q: linear theory with spin braking its slopes; the direction turns to that of the rigid slip
    // as sliding spreads
    let by = dy.scale(c22);
    let bx = by * (one - d_e) + k1 * (dx * d_e).scale(c11);
    let spin = d_s.scale(c23);
    let spin_force = spin * phi;
    let qx = (k2 * vx) * bx;
    let qy = k2 * (by * vy) + k3 * spin_force;
    let q2 = qx * qx + qy * qy + (spin_force * spin_force).times(SHEAR);
    // h: spin keeps |F| below μ N in full sliding
    let h = (kappa * w * k6).times(0.3).plus(1.0);
    let sigma = saturation(q2, h);
    let (fx, fy) = (sigma * qx, sigma * qy);
    if !MOMENT {
        return TotalForce { fx, fy, mz: T::zero() };
    }
    // fy = σ (β vy + γ φ), mz = ε φ − σ γ vy + 2 σ ρ √(β ε) vy, |ρ| < 1. With σ ≤ 1 the dissipation
    // σ β vy² + 2 σ ρ √(β ε) vy φ + ε φ² is never negative
    // the moment of spin, at most 1.14 times that of sliding by spin alone, however far away the network is asked
    let epsilon = (k4 * dm).scale(c33);
    let spin_moment = epsilon * phi;
    let excess = (spin_moment * spin_moment).scale(moment);
    let epsilon = epsilon / (excess * excess).times(1.0 / 16.0).plus(1.0);
    let coupling = twice(rho * ((k2 * by) * epsilon).sqrt()) - k3 * spin;
    TotalForce { fx, fy, mz: epsilon * phi + sigma * (coupling * vy) }
}

/// The six corrections.
struct Network<F> {
    fixed: [F; FIXED_INPUTS],
}

/// The constants in double precision: converted by the compiler, and where registers of two doubles
/// can be read from.
#[repr(align(16))]
struct Wide<T>(T);

static FIXED_WIDE: Wide<[[[f64; 2]; PAIRS_1]; FIXED.len()]> = Wide(widen(&FIXED));
static FIRST_WIDE: Wide<[[[f64; 2]; PAIRS_1]; INPUTS]> = Wide(widen(&FIRST));
static SECOND_WIDE: Wide<[[[f64; 2]; PAIRS_2]; SECOND.len()]> = Wide(widen(&SECOND));
static LAST_WIDE: Wide<[[[f64; 2]; PAIRS_2]; 6]> = Wide(widen(&LAST));

impl<F: Plain> Map<F, INPUTS, 6> for Network<F> {
    type Place = ([F::Pair; PAIRS_1], [F::Pair; PAIRS_2]);

    #[inline(always)]
    fn value(&self, inputs: [F; INPUTS]) -> ([F; 6], Self::Place) {
        let sums = from_bias(&self.fixed, F::Stored::table(&FIXED, &FIXED_WIDE.0));
        let sums = add_rows::<F, PAIRS_1>(sums, &inputs, F::Stored::table(&FIRST, &FIRST_WIDE.0));
        let (units, slope_1) = activation(sums);
        let units = apart::<F, PAIRS_1, UNITS_1>(units);
        let sums = from_bias::<F, PAIRS_2>(&units, F::Stored::table(&SECOND, &SECOND_WIDE.0));
        let (units, slope_2) = activation(sums);
        (last_layer::<F>(units, LAST_BIAS), (slope_1, slope_2))
    }

    #[inline(always)]
    fn tangent(&self, (slope_1, slope_2): &Self::Place, inputs: [F; INPUTS]) -> [F; 6] {
        let zero = <F::Pair as Arithmetic>::zero();
        let rows = F::Stored::table(&FIRST, &FIRST_WIDE.0);
        let units = times(add_rows::<F, PAIRS_1>([zero; PAIRS_1], &inputs, rows), slope_1);
        let units = apart::<F, PAIRS_1, UNITS_1>(units);
        let [_, rows @ ..] = F::Stored::table(&SECOND, &SECOND_WIDE.0);
        let units = times(add_rows::<F, PAIRS_2>([zero; PAIRS_2], &units, rows), slope_2);
        last_layer::<F>(units, [0.0; 6])
    }
}

/// `bias + Σ xᵢ rowᵢ`: the first row of `weights` is the bias.
#[inline(always)]
fn from_bias<F: Plain, const P: usize>(
    inputs: &[F],
    weights: &[[[F::Stored; 2]; P]],
) -> [F::Pair; P] {
    match weights {
        [bias, rows @ ..] => {
            let plain = |two: &[F::Stored; 2]| <F::Pair as Pair<F>>::plain(F::both_stored(*two));
            let bias = <F::Pair as Arithmetic>::each(bias, plain);
            add_rows::<F, P>(bias, inputs, rows)
        }
        [] => [<F::Pair as Arithmetic>::zero(); P],
    }
}

/// `sums + Σ xᵢ rowᵢ`, row by row: the sums stay in registers and do not wait for each other.
///
/// (Numbers of several contacts side by side fill whole registers: six sums at a time, then the rows again.)
#[inline(always)]
fn add_rows<F: Plain, const P: usize>(
    mut sums: [F::Pair; P],
    inputs: &[F],
    rows: &[[[F::Stored; 2]; P]],
) -> [F::Pair; P] {
    if F::LANES == 1 {
        let (pairs, rest) = sums.as_chunks_mut::<2>();
        let mut quads = [<F::Quad as Arithmetic>::zero(); P];
        for (quad, [first, second]) in quads.iter_mut().zip(&*pairs) {
            *quad = F::Quad::of_halves(*first, *second);
        }
        for (input, row) in inputs.iter().zip(rows) {
            let (weights, last) = row.as_chunks::<2>();
            let x = <F::Quad as Quad<F>>::all(*input);
            for (sum, weights) in quads.iter_mut().zip(weights) {
                *sum += x * quad_of::<F>(weights);
            }
            add_row::<F>(rest, *input, last);
        }
        for (pairs, quad) in pairs.iter_mut().zip(quads) {
            *pairs = quad.halves();
        }
        return sums;
    }
    let (blocks, rest) = sums.as_chunks_mut::<3>();
    for (k, block) in blocks.iter_mut().enumerate() {
        for (input, row) in inputs.iter().zip(rows) {
            if let Some(row) = row.as_chunks::<3>().0.get(k) {
                add_row::<F>(block, *input, row);
            }
        }
    }
    for (input, row) in inputs.iter().zip(rows) {
        add_row::<F>(rest, *input, row.as_chunks::<3>().1);
    }
    sums
}

#[inline(always)]
fn add_row<F: Plain>(sums: &mut [F::Pair], input: F, row: &[[F::Stored; 2]]) {
    let x = <F::Pair as Pair<F>>::both(input);
    for (sum, weights) in sums.iter_mut().zip(row) {
        *sum += x.scale_each(F::both_stored(*weights));
    }
}

/// Two pairs of constants side by side.
#[inline(always)]
fn quad_of<F: Plain>([first, second]: &[[F::Stored; 2]; 2]) -> F::Quad {
    let ([a, b], [c, d]) = (F::both_stored(*first), F::both_stored(*second));
    F::Quad::plain([a, b, c, d])
}

/// The last layer: products of pairs of units, two chains of sums for each output.
#[inline(always)]
fn last_layer<F: Plain>(units: [F::Pair; PAIRS_2], bias: [f32; 6]) -> [F; 6] {
    let mut outputs = F::each(&bias, |x| F::of_f32(*x));
    for (output, weights) in outputs.iter_mut().zip(F::Stored::table(&LAST, &LAST_WIDE.0)) {
        let mut first = <F::Pair as Pair<F>>::of(*output, F::zero());
        let mut second = <F::Pair as Arithmetic>::zero();
        let (mut both, mut factors) = (units.chunks_exact(2), weights.chunks_exact(2));
        for (both, factors) in (&mut both).zip(&mut factors) {
            if let ([x, y], [p, q]) = (both, factors) {
                first += x.scale_each(F::both_stored(*p));
                second += y.scale_each(F::both_stored(*q));
            }
        }
        if let ([x], [p]) = (both.remainder(), factors.remainder()) {
            first += x.scale_each(F::both_stored(*p));
        }
        *output = (first + second).sum();
    }
    outputs
}

/// Pairs, one number after the other.
#[inline(always)]
fn apart<F: Plain, const N: usize, const M: usize>(pairs: [F::Pair; N]) -> [F; M] {
    let mut numbers = [F::zero(); M];
    for (two, pair) in numbers.chunks_exact_mut(2).zip(pairs) {
        let (first, second) = pair.parts();
        if let [p, q] = two {
            *p = first;
            *q = second;
        }
    }
    numbers
}

#[inline(always)]
fn times<P: Arithmetic, const N: usize>(mut x: [P; N], y: &[P; N]) -> [P; N] {
    for (x, y) in x.iter_mut().zip(y) {
        *x = *x * *y;
    }
    x
}

/// `2x/(1 + x²)` and its slope `2/(1 + x²) − (2x/(1 + x²))²`, with one division for two pairs.
#[inline(always)]
fn activation<P: Arithmetic, const N: usize>(x: [P; N]) -> ([P; N], [P; N]) {
    let mut y = x;
    let mut slope = x;
    let (mut units, mut slopes) = (y.chunks_exact_mut(2), slope.chunks_exact_mut(2));
    for (units, slopes) in (&mut units).zip(&mut slopes) {
        if let ([y, z], [s, t]) = (units, slopes) {
            let (p, q) = (y.squared().plus(1.0), z.squared().plus(1.0));
            let r = P::constant(2.0) / (p * q);
            let (p, q) = (r * q, r * p);
            *y = *y * p;
            *z = *z * q;
            *s = p - y.squared();
            *t = q - z.squared();
        }
    }
    if let ([y], [s]) = (units.into_remainder(), slopes.into_remainder()) {
        let p = P::constant(2.0) / y.squared().plus(1.0);
        *y = *y * p;
        *s = p - y.squared();
    }
    (y, slope)
}

/// `S(|q|)/(h |q|)` from `|q|²` and `h`, with `S = 1 − ((2 + d²) √(1 − d²) − 3 d acos d)/2`, `d = 4|q|/(3π)`,
/// and 1 for `d ≥ 1` (8.15).
#[inline(always)]
fn saturation<T: Number>(q2: T, h: T) -> T {
    const FULL: f64 = 3.0 * core::f64::consts::PI / 4.0;
    // the small term keeps the derivative of the root finite at 0
    let q = q2.plus(1e-30).sqrt();
    let e = q.min(T::constant(FULL));
    let e2 = e * e;
    let [k0, k1, k2, k3, k4, k5] = <T::Base as Arithmetic>::each(&SATURATION, |x| T::Base::of(*x));
    let low = e.scale(k1).shift(k0) + e2 * e.scale(k3).shift(k2);
    let s_over_q = low + (e2 * e2) * e.scale(k5).shift(k4);
    s_over_q * (T::constant(FULL) / (q.max(T::constant(FULL)) * h))
}

/// Creepages and spin that mean the same and that the network can be asked about.
///
/// Large spin slides everywhere, and then only the ratio of creepage to spin matters. So both are scaled
/// down together beyond `|Ls| = 16` (fitted is up to 13), smoothly, to `|Ls| = 32` at most.
#[inline(always)]
fn within_range<T: Number>([vx, vy, phi]: [T; 3], c23: T::Base) -> [T; 3] {
    // 1e8, in single precision 1e6
    let limit = T::Base::HUGE.min(T::Base::of(CREEPAGE_LIMIT)).sqrt();
    let size = vx.value().abs().max(vy.value().abs()).max(phi.value().abs());
    let lost = T::TINY.times(LOST);
    let [mut vx, mut vy, mut phi] = [vx, vy, phi];
    if lost.exceeds(size) {
        // The digits of such creepages are those of the smallest numbers, and without them power may have any sign. What
        // they carry is nothing to 1e-32 of `μ N`; the slopes stay.
        let gone = |v: T| v - T::from_base((lost - size).choose(v.value(), T::Base::zero()));
        (vx, vy, phi) = (gone(vx), gone(vy), gone(phi));
    }
    if size.exceeds(limit) {
        let factor = T::from_base((size - limit).choose(limit / size, T::Base::one()));
        return within_spin([vx * factor, vy * factor, phi * factor], c23);
    }
    within_spin([vx, vy, phi], c23)
}

#[inline(always)]
fn within_spin<T: Number>([vx, vy, phi]: [T; 3], c23: T::Base) -> [T; 3] {
    let size = phi.abs().scale(c23);
    let excess = size.plus(-SPIN_LIMIT);
    if excess.exceeds(T::zero()) {
        // 16 + e/(1 + e/16), e = |Ls| − 16
        let allowed = (excess / excess.times(1.0 / SPIN_LIMIT).plus(1.0)).plus(SPIN_LIMIT);
        let factor = excess.choose(allowed / size, T::one());
        [vx * factor, vy * factor, phi * factor]
    } else {
        [vx, vy, phi]
    }
}

/// Element by element, two at a time; an even number of them.
#[inline(always)]
fn divide<T: Number, const N: usize>(numerators: [T; N], denominators: [T; N]) -> [T; N] {
    let mut quotients = numerators;
    for (two, denominators) in quotients.chunks_exact_mut(2).zip(denominators.chunks_exact(2)) {
        if let ([p, q], &[r, s]) = (two, denominators) {
            (*p, *q) = (T::Pair::of(*p, *q) / T::Pair::of(r, s)).parts();
        }
    }
    quotients
}

/// Element by element, two at a time; an even number of them.
#[inline(always)]
fn roots<T: Number, const N: usize>(mut numbers: [T; N]) -> [T; N] {
    for two in numbers.chunks_exact_mut(2) {
        if let [p, q] = two {
            (*p, *q) = T::Pair::of(*p, *q).sqrt().parts();
        }
    }
    numbers
}

#[inline(always)]
fn twice<T: Number>(x: T) -> T {
    x + x
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn at(g: f64, nu: f64, v: [f64; 3]) -> [f64; 3] {
        let TotalForce { fx, fy, mz } = total(g, nu, &LinearCoefficients::at(g, nu), v);
        [fx, fy, mz]
    }

    /// Numbers between 0 and 1, the same in every run.
    struct Numbers(u64);

    impl Numbers {
        fn next(&mut self) -> f64 {
            self.0 = self
                .0
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 11) as f64 / (1_u64 << 53) as f64
        }

        /// Both signs, evenly spread over the logarithm between two powers of ten; one in eight is zero.
        fn spread(&mut self, low: f64, high: f64) -> f64 {
            let size = 10_f64.powf(low + (high - low) * self.next());
            match (self.next() * 8.0) as u32 {
                0 => 0.0,
                1..=3 => -size,
                _ => size,
            }
        }
    }

    /// Printed by `fit/fit_total.py`, which evaluates the same formulas in Python.
    #[test]
    fn agrees_with_the_fit() {
        for (g, nu, v, expected) in [
            (1.0, 0.28, [0.1, 0.0, 0.0], [0.37222084585714493, 0.0, 0.0]),
            (
                1.0,
                0.28,
                [0.1, -0.05, 0.2],
                [0.3149498227533282, 0.12509990662642093, 0.20460396194365954],
            ),
            (
                1.0,
                0.28,
                [-0.3, 0.2, 0.7],
                [-0.4207527492240931, 0.707253725282264, 0.2703166122250163],
            ),
            (
                0.1,
                0.0,
                [0.05, 0.3, 0.1],
                [0.08884087325949543, 0.608954679551353, 0.38121412674885935],
            ),
            (0.1, 0.5, [0.0, -0.2, 2.0], [0.0, 0.051539260169295234, 1.2058095158684776]),
            (10.0, 0.28, [0.0, 0.0, 0.09], [0.0, 0.8869953153785158, 0.25050345574808774]),
            (
                10.0,
                0.28,
                [0.05, -0.22, 0.18],
                [0.31272055317301467, 0.14127194691441666, 1.06451108205823],
            ),
            (5.0, 0.1, [0.0, 0.1, -0.2], [0.0, -0.5211448121599446, -0.4961367256339977]),
            (
                0.3,
                0.4,
                [3.0, -2.0, 1.0],
                [0.8152115741451752, -0.5480835618476354, 0.07953930708387201],
            ),
            (
                2.0,
                0.25,
                [0.0001, 0.0002, -0.0001],
                [0.0005093588263918235, 0.0007181112003448441, -0.0006069564945455252],
            ),
            (
                0.02,
                0.3,
                [0.2, 0.2, 0.5],
                [0.08602705368904534, 0.24961928508183281, 2.569842487507663],
            ),
            (
                60.0,
                0.3,
                [0.01, 0.02, 0.03],
                [0.18352107711013801, 0.6679852532681545, -0.026448966951495366],
            ),
            (1.0, 0.5, [0.0, 0.0, 40.0], [0.0, 0.05029037521962382, 0.5809614370293236]),
        ] {
            for (value, expected) in at(g, nu, v).into_iter().zip(expected) {
                assert_relative_eq!(value, expected, max_relative = 1e-12, epsilon = 1e-14);
            }
        }
    }

    /// Relative error against the linear theory vanishes with the creepage, for each of the three outputs.
    #[test]
    fn starts_as_the_linear_theory() {
        for g in [0.01, 0.1, 0.5, 1.0, 3.0, 10.0, 100.0] {
            for nu in [0.0, 0.28, 0.5] {
                let LinearCoefficients { c11, c22, c23, c33 } = LinearCoefficients::at(g, nu);
                for (vx, vy, phi) in
                    [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.3, -0.5, 0.7)]
                {
                    let [vx, vy, phi] = [vx, vy, phi].map(|v| 1e-9 * v);
                    let linear = [c11 * vx, c22 * vy + c23 * phi, c33 * phi - c23 * vy];
                    for (value, linear) in at(g, nu, [vx, vy, phi]).into_iter().zip(linear) {
                        assert_relative_eq!(value, linear, max_relative = 1e-4);
                    }
                }
            }
        }
    }

    /// `F → μ N` along the rigid slip, `Mz → 0`.
    #[test]
    fn ends_as_full_sliding() {
        for g in [0.01, 0.1, 1.0, 10.0, 100.0] {
            for nu in [0.0, 0.28, 0.5] {
                for angle in [0.0_f64, 0.4, 1.0, 1.57, 2.5] {
                    for phi in [0.0, 0.5, -3.0] {
                        let v = 1e7;
                        let [fx, fy, mz] = at(g, nu, [v * angle.cos(), v * angle.sin(), phi]);
                        assert_relative_eq!(fx, angle.cos(), epsilon = 1e-4);
                        assert_relative_eq!(fy, angle.sin(), epsilon = 1e-4);
                        assert!(mz.abs() < 1e-2, "{g} {nu} {angle} {phi}: {mz}");
                    }
                }
            }
        }
    }

    #[test]
    fn keeps_the_symmetries_bounds_and_dissipation() {
        let mut random = Numbers(7);
        for _ in 0..200_000 {
            let g = 10_f64.powf(6.0 * random.next() - 3.0);
            let nu = 0.5 * random.next();
            let v @ [vx, vy, phi] =
                [random.spread(-6.0, 6.0), random.spread(-6.0, 6.0), random.spread(-6.0, 6.0)];
            let [fx, fy, mz] = at(g, nu, v);
            assert!(fx.hypot(fy) <= 1.0 + 1e-9 && mz.is_finite(), "{g} {nu} {v:?}");
            let power = fx * vx + fy * vy + mz * phi;
            let size = (fx * vx).abs() + (fy * vy).abs() + (mz * phi).abs();
            assert!(power >= -1e-13 * size, "{g} {nu} {v:?}: {power} of {size}");
            assert_eq!(at(g, nu, [-vx, vy, phi]), [-fx, fy, mz]);
            assert_eq!(at(g, nu, [-vx, -vy, -phi]), [-fx, -fy, -mz]);
        }
    }

    /// The moment of the fitted range is below that of the largest arm; far outside it stays bounded.
    #[test]
    fn moment_is_bounded() {
        let mut random = Numbers(11);
        for _ in 0..200_000 {
            let g = 10_f64.powf(2.0 * random.next() - 1.0);
            let nu = 0.5 * random.next();
            let v = [random.spread(-3.0, 3.0), random.spread(-3.0, 3.0), random.spread(-3.0, 3.0)];
            let [.., mz] = at(g, nu, v);
            assert!(mz.abs() < 2.0 * g.sqrt().max(1.0 / g.sqrt()), "{g} {nu} {v:?}: {mz}");
        }
    }

    /// Central differences from both sides agree better and better with smaller steps: no kink where
    /// creepages or spin change sign, nor where the saturation curve ends.
    #[test]
    fn is_smooth() {
        let mut random = Numbers(3);
        for _ in 0..20_000 {
            let g = 10_f64.powf(2.0 * random.next() - 1.0);
            let nu = 0.5 * random.next();
            let v = [random.spread(-2.0, 0.5), random.spread(-2.0, 0.5), random.spread(-2.0, 0.5)];
            for axis in 0..3 {
                let bend = |h: f64| {
                    let shifted = |h: f64| {
                        let mut v = v;
                        v[axis] += h;
                        at(g, nu, v)
                    };
                    let (low, middle, high) = (shifted(-h), shifted(0.0), shifted(h));
                    (0..3)
                        .map(|i| (high[i] - 2.0 * middle[i] + low[i]).abs() / h)
                        .fold(0.0, f64::max)
                };
                // change of slope over h: proportional to h, up to rounding, unless there is a kink
                let (coarse, fine) = (bend(1e-4), bend(1e-6));
                assert!(fine < 0.05 * coarse + 1e-3, "{g} {nu} {v:?} {axis}: {coarse} {fine}");
            }
        }
    }

    #[test]
    fn holds_for_hard_inputs() {
        for g in [1e-300, 1e-3, 0.1, 1.0, 10.0, 1e3, 1e300] {
            for v in [0.0, 5e-324, 1e-300, 1e-150, 1e-30, 1e30, 1e150, 1e300] {
                for [x, y, z] in
                    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, -1.0, 1.0]]
                {
                    let [fx, fy, mz] = at(g, 0.3, [v * x, v * y, v * z]);
                    assert!(fx.hypot(fy) <= 1.0 + 1e-9 && mz.is_finite(), "{g} {v} {fx} {fy} {mz}");
                }
            }
        }
        assert_eq!(at(1.0, 0.3, [0.0; 3]), [0.0; 3]);
    }

    #[test]
    fn single_precision_follows() {
        let mut random = Numbers(5);
        for _ in 0..100_000 {
            let g = 10_f64.powf(2.0 * random.next() - 1.0) as f32;
            let nu = 0.5 * random.next() as f32;
            let v = [0; 3].map(|_| random.spread(-3.0, 1.0) as f32);
            let single = total(g, nu, &LinearCoefficients::at(g, nu), v);
            let double = at(g.into(), nu.into(), v.map(f64::from));
            for (single, double) in [single.fx, single.fy, single.mz].into_iter().zip(double) {
                assert_relative_eq!(f64::from(single), double, epsilon = 2e-5);
            }
        }
        for v in [1e-38_f32, 1e-30, 1e12, 1e30, 3e38] {
            for g in [1e-30_f32, 0.1, 1.0, 10.0, 1e30] {
                let f = total(g, 0.5, &LinearCoefficients::at(g, 0.5), [v, -v, v]);
                assert!(f.fx.hypot(f.fy) <= 1.00001 && f.mz.is_finite(), "{g} {v} {f:?}");
            }
        }
    }
}
