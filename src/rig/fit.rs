//! From a measured creep curve to the law of friction.
//!
//! The sum of the squared differences between measured and computed forces, each times the weight
//! of its point, is made least by a Gauss-Newton method with exact derivatives. It is damped as
//! Levenberg and Marquardt do: the diagonal of the normal equations grows where a step does not
//! lead closer, and falls where it does.
//!
//! ```text
//! (H + λ diag H) δ = −g,   H = Σ w ∂F/∂p ∂F/∂pᵀ,   g = Σ w (F − F_measured) ∂F/∂p
//! ```
//!
//! A parameter that a step would lead beyond its bounds ends there, and stays as long as the sum
//! falls outward. With `m` forces and `n` parameters the standard errors are the roots of the
//! diagonal of `H⁻¹ Σ w (F − F_measured)²/(m − n)`.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::forces::Options;
use crate::friction::derivatives::{Differentiated, differentiate_with_law};
use crate::friction::{InMotion, SlipFriction, fastest_slip};
use crate::number::{Float, are_finite};
use crate::status::{Error, Warning};
use nalgebra::Matrix6;

/// Largest number of times that all forces are computed.
const MOST: usize = 80;
/// Damping at the start, its least, and the one that ends the search; how it falls and grows.
const DAMPING: [f64; 3] = [1e-2, 1e-8, 1e8];
const FALLS: f64 = 0.2;
const GROWS: f64 = 4.0;
/// Fall of the sum that ends the search, divided by the sum and by the root of a rounding.
const REACHED: f64 = 0.01;
/// Least factors, and least layer over the flexibility of the bodies: below them no derivative is
/// left.
const LEAST: f64 = 1e-3;
/// Error of the forces, over their size, that is presumed at least where it is asked whether the
/// points tell the parameters; and the share of a parameter that its standard error must not
/// exceed.
const PRESUMED: f64 = 0.01;
const UNCERTAIN: f64 = 0.5;
/// About `8/(3 C₁₁)`: the flexibility of the bodies divided by `a/G`.
const FLEXIBILITY: f64 = 0.6;

/// One measured point of a creep curve.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredForce<F> {
    /// Longitudinal creepage \[-\].
    pub longitudinal: F,
    /// Lateral creepage \[-\].
    pub lateral: F,
    /// Spin \[1/m\].
    pub spin: F,
    /// Longitudinal force on the lower body \[N\]; ignored unless it was measured.
    pub fx: F,
    /// Lateral force on the lower body \[N\]; ignored unless it was measured.
    pub fy: F,
    /// Weight of the squared error of a force, >= 0: 1 for points of equal accuracy, 1/error^2
    /// otherwise; 0: the point does not count.
    pub weight: F,
    /// KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY, or both added.
    pub measured: u32,
    /// Reserved: zero.
    pub reserved: u32,
}

/// A law of friction that was fitted to measured points.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionFit<F> {
    /// The law.
    pub law: SlipFriction<F>,
    /// Standard errors of its members, from the remaining differences between points and law; 0 for
    /// a member that was not fitted or that ended at a bound.
    pub standard_errors: SlipFriction<F>,
    /// Root of the weighted mean of the squared differences between measured and computed forces
    /// \[N\].
    pub residual: F,
    /// Number of times that all forces were computed.
    pub steps: u32,
    /// The status of this result: 0 or one of the KSTRIP_WARNING constants.
    pub warning: Warning,
}

/// Which parameters are fitted, in their order: friction, ratio, decay, slope factor, slide factor,
/// layer.
pub type Fitted = [bool; 6];

/// The law whose forces come nearest to measured ones.
///
/// `fitted` says which members of `start` are fitted; the others stay. A fitted member that has no
/// start (zero) begins at a usual value.
///
/// # Errors
/// Those of [`differentiate_with_law`], of a point with its number; [`Error::Measured`],
/// [`Error::Weight`], [`Error::FewPoints`], [`Error::FitParameters`]. Errors of the contact and the
/// law have the count of the points instead of a number.
pub fn fit_friction<F: Float>(
    contact: &Contact<F>,
    points: &[MeasuredForce<F>],
    start: &SlipFriction<F>,
    fitted: Fitted,
    options: &Options,
) -> Result<FrictionFit<F>, (usize, Error)> {
    Fit::new(contact, points, start, fitted, options)?.find()
}

/// The points and the parameters that are fitted.
struct Fit<'a, F> {
    contact: &'a Contact<F>,
    points: &'a [MeasuredForce<F>],
    options: &'a Options,
    fitted: Fitted,
    start: SlipFriction<F>,
    /// Units of the parameters.
    units: [F; 6],
    /// In these units.
    low: [F; 6],
    high: [F; 6],
    /// How many forces count, the sum of their weights, and that of their weighted squares over
    /// `N²`.
    count: usize,
    weights: F,
    squares: F,
}

/// The sum of the squares over `N²`, half of its derivatives, and the normal equations.
#[derive(Clone, Copy)]
struct Sums<F> {
    total: F,
    gradient: [F; 6],
    normal: [[F; 6]; 6],
}

impl<F: Float> MeasuredForce<F> {
    fn creepage(&self) -> Creepage<F> {
        let Self { longitudinal, lateral, spin, .. } = *self;
        Creepage { longitudinal, lateral, spin }
    }

    /// The forces that were measured.
    fn measured_forces(&self) -> [Option<F>; 2] {
        [(1, self.fx), (2, self.fy)].map(|(bit, force)| (self.measured & bit != 0).then_some(force))
    }

    fn check(&self) -> Result<(), Error> {
        let Self { longitudinal, lateral, spin, weight, .. } = *self;
        Error::NotFinite.unless(are_finite(&[longitudinal, lateral, spin, weight]))?;
        let forces = self.measured_forces();
        let finite = forces.iter().flatten().all(|force| force.is_finite_number());
        Error::NotFinite.unless(finite)?;
        Error::Measured.unless(self.measured >= 1 && self.measured <= 3)?;
        Error::Weight.unless(weight >= F::zero())
    }
}

/// The parameters of a law.
fn parameters<F: Float>(law: &SlipFriction<F>) -> [F; 6] {
    let SlipFriction { friction, ratio, decay, slope_factor, slide_factor, layer, .. } = *law;
    [friction, ratio, decay, slope_factor, slide_factor, layer]
}

fn with_parameters<F: Float>(law: &SlipFriction<F>, of: [F; 6]) -> SlipFriction<F> {
    let [friction, ratio, decay, slope_factor, slide_factor, layer] = of;
    SlipFriction { friction, ratio, decay, slope_factor, slide_factor, layer, ..*law }
}

impl<'a, F: Float> Fit<'a, F> {
    fn new(
        contact: &'a Contact<F>,
        points: &'a [MeasuredForce<F>],
        start: &SlipFriction<F>,
        fitted: Fitted,
        options: &'a Options,
    ) -> Result<Self, (usize, Error)> {
        let all = points.len();
        let of_all = |result: Result<(), Error>| result.map_err(|error| (all, error));
        of_all(start.check())?;
        of_all(Contact { friction: F::zero(), ..*contact }.check())?;
        let wanted = fitted.iter().filter(|fitted| **fitted).count();
        of_all(Error::FitParameters.unless(wanted > 0))?;
        of_all(Error::Unexplained.unless(!contact.is_lost()))?;
        let load = contact.normal_force;
        let (zero, one) = (F::zero(), F::one());
        let (mut count, mut weights, mut squares) = (0, zero, zero);
        let (mut used, mut fastest) = (zero, zero);
        for (i, point) in points.iter().enumerate() {
            point.check().map_err(|error| (i, error))?;
            let creepage = point.creepage();
            let motion = InMotion { creepage: &creepage, law: Some(start), options };
            motion.check(contact).map_err(|error| (i, error))?;
            for force in point.measured_forces().into_iter().flatten() {
                if point.weight > zero {
                    count += 1;
                    weights += point.weight;
                    let over = force / load;
                    squares += point.weight * over * over;
                    used = used.max(over.abs());
                    fastest = fastest.max(fastest_slip(contact, &creepage));
                }
            }
        }
        of_all(Error::FewPoints.unless(count >= wanted))?;
        let flexible = (contact.a / contact.shear_modulus).times(FLEXIBILITY);
        // decay over which friction falls within the points
        let slow = start.rolling_speed * fastest;
        let decay = if slow > zero { one / slow } else { one };
        let units = [one, one, decay, one, one, flexible];
        let least = F::of(LEAST);
        let none = [least, zero, zero, least, least, least];
        let most = F::of(1e6);
        let usual = [used.times(1.05).max(least), F::of(0.5), one, F::of(0.5), F::of(0.5), one];
        let mut begin = parameters(start);
        for ((begin, fitted), (usual, unit)) in
            begin.iter_mut().zip(fitted).zip(usual.into_iter().zip(units))
        {
            if fitted && *begin <= zero {
                *begin = usual * unit;
            }
        }
        let start = with_parameters(start, begin);
        let high = [most, one, most, one, one, most];
        Ok(Self {
            contact,
            points,
            options,
            fitted,
            start,
            units,
            low: none,
            high,
            count,
            weights,
            squares,
        })
    }

    /// The law with parameters in their units; those that are not fitted stay as they are.
    fn law(&self, of: &[F; 6]) -> SlipFriction<F> {
        let mut values = parameters(&self.start);
        for ((value, fitted), (of, unit)) in
            values.iter_mut().zip(self.fitted).zip(of.iter().zip(self.units))
        {
            if fitted {
                *value = *of * unit;
            }
        }
        with_parameters(&self.start, values)
    }

    fn sums(&self, of: &[F; 6]) -> Result<Sums<F>, (usize, Error)> {
        let (law, load) = (self.law(of), self.contact.normal_force);
        let zero = F::zero();
        let mut sums = Sums { total: zero, gradient: [zero; 6], normal: [[zero; 6]; 6] };
        for (i, point) in self.points.iter().enumerate() {
            if point.weight <= zero {
                continue;
            }
            let found =
                differentiate_with_law(self.contact, &point.creepage(), Some(&law), self.options)
                    .map_err(|error| (i, error))?;
            let Differentiated { solution, derivatives, law: by, .. } = found;
            let columns = [
                derivatives.friction,
                by.ratio,
                by.decay,
                by.slope_factor,
                by.slide_factor,
                by.layer,
            ];
            let [fx, fy] = point.measured_forces();
            for (measured, computed, row) in [
                (fx, solution.fx, columns.map(|[x, ..]| x)),
                (fy, solution.fy, columns.map(|[_, y, _]| y)),
            ] {
                let Some(measured) = measured else { continue };
                let mut row = row;
                for ((slope, unit), fitted) in row.iter_mut().zip(self.units).zip(self.fitted) {
                    *slope = if fitted { *slope * (unit / load) } else { zero };
                }
                sums.add(point.weight, (computed - measured) / load, &row);
            }
        }
        Ok(sums)
    }

    fn find(&self) -> Result<FrictionFit<F>, (usize, Error)> {
        let mut at = parameters(&self.start);
        for (((at, unit), low), high) in at.iter_mut().zip(self.units).zip(self.low).zip(self.high)
        {
            *at = (*at / unit).clamped(low, high);
        }
        let [start, least, most] = DAMPING.map(F::of);
        let mut damping = start;
        let mut sums = self.sums(&at)?;
        let (mut steps, mut settled) = (1, false);
        while steps < MOST && !settled {
            let free = self.free(&at, &sums);
            let Some(inverse) = sums.inverted(&free, damping) else {
                damping = damping.times(GROWS);
                settled = damping > most;
                continue;
            };
            let mut next = at;
            for ((next, row), (low, high)) in
                next.iter_mut().zip(inverse).zip(self.low.into_iter().zip(self.high))
            {
                let step =
                    row.iter().zip(sums.gradient).fold(F::zero(), |sum, (a, g)| sum + *a * g);
                *next = (*next - step).clamped(low, high);
            }
            steps += 1;
            let found = self.sums(&next)?;
            let fall = sums.total - found.total;
            if fall > F::zero() {
                (at, sums) = (next, found);
                let rounding = self.squares * F::EPSILON * F::EPSILON;
                settled = fall <= sums.total * F::EPSILON.sqrt().times(REACHED) + rounding;
                damping = damping.times(FALLS).max(least);
            } else {
                damping = damping.times(GROWS);
                settled = damping > most || next == at;
            }
        }
        Ok(self.result(&at, &sums, steps, settled))
    }

    /// Which parameters may move: those that are fitted, and not at a bound beyond which the sum
    /// falls.
    fn free(&self, at: &[F; 6], sums: &Sums<F>) -> Fitted {
        let mut free = self.fitted;
        let bounds = self.low.into_iter().zip(self.high);
        for ((free, at), (gradient, (low, high))) in
            free.iter_mut().zip(at).zip(sums.gradient.into_iter().zip(bounds))
        {
            let held =
                (*at <= low && gradient > F::zero()) || (*at >= high && gradient < F::zero());
            *free = *free && !held;
        }
        free
    }

    fn result(&self, at: &[F; 6], sums: &Sums<F>, steps: usize, settled: bool) -> FrictionFit<F> {
        let (zero, load) = (F::zero(), self.contact.normal_force);
        let free = self.free(at, sums);
        let moves = free.iter().filter(|free| **free).count();
        let number = |n: usize| F::widened(n as f32);
        let left = sums.total / number(self.count.saturating_sub(moves).max(1));
        let presumed = self.squares / number(self.count) * F::of(PRESUMED * PRESUMED);
        let mut errors = [zero; 6];
        let mut tells = true;
        match sums.inverted(&free, zero) {
            None => tells = false,
            Some(inverse) => {
                for (i, ((error, row), free)) in
                    errors.iter_mut().zip(inverse).zip(free).enumerate()
                {
                    let Some(variance) = row.get(i).filter(|_| free) else { continue };
                    let value = at.get(i).copied().unwrap_or(zero);
                    // (of shares of one, ratio and slide factor, the error is absolute)
                    let size = if i == 1 || i == 4 { F::one() } else { value };
                    let error_at_least = (*variance * left.max(presumed)).max(zero).sqrt();
                    tells = tells && error_at_least <= size.times(UNCERTAIN);
                    *error = (*variance * left).max(zero).sqrt().min(F::HUGE);
                }
            }
        }
        for (error, unit) in errors.iter_mut().zip(self.units) {
            *error = (*error * unit).min(F::HUGE);
        }
        let nothing = SlipFriction { ratio: zero, ..SlipFriction::of_constant(zero) };
        let warning = if !settled {
            Warning::NotConverged
        } else if !tells {
            Warning::Undetermined
        } else {
            Warning::None
        };
        FrictionFit {
            law: self.law(at),
            standard_errors: with_parameters(&nothing, errors),
            residual: ((sums.total / self.weights).sqrt() * load).min(F::HUGE),
            steps: steps as u32,
            warning,
        }
    }
}

impl<F: Float> Sums<F> {
    fn add(&mut self, weight: F, error: F, row: &[F; 6]) {
        self.total += weight * error * error;
        for ((normal, gradient), slope) in self.normal.iter_mut().zip(&mut self.gradient).zip(row) {
            let weighted = weight * *slope;
            *gradient += weighted * error;
            for (entry, other) in normal.iter_mut().zip(row) {
                *entry += weighted * *other;
            }
        }
    }

    /// The inverse of the damped normal equations of free parameters, zero for the others; none
    /// where they are singular.
    fn inverted(&self, free: &Fitted, damping: F) -> Option<[[F; 6]; 6]> {
        let (zero, one) = (F::zero(), F::one());
        // in units that make the diagonal one
        let mut scale = [zero; 6];
        for (i, ((scale, row), free)) in scale.iter_mut().zip(&self.normal).zip(free).enumerate() {
            let own = row.get(i).copied().unwrap_or(zero);
            if *free && !(own > zero) {
                return None;
            }
            *scale = if *free { one / own.sqrt() } else { zero };
        }
        let mut matrix = Matrix6::from([[zero; 6]; 6]);
        for (i, ((column, row), own)) in
            matrix.as_mut_slice().chunks_exact_mut(6).zip(&self.normal).zip(scale).enumerate()
        {
            for (j, ((entry, normal), other)) in column.iter_mut().zip(row).zip(scale).enumerate() {
                *entry = *normal * own * other;
                if i == j {
                    *entry = one + damping;
                }
            }
        }
        let inverse = F::inverse_of_normal(matrix)?;
        let mut rows = [[zero; 6]; 6];
        for ((row, column), own) in
            rows.iter_mut().zip(inverse.as_slice().chunks_exact(6)).zip(scale)
        {
            for ((entry, inverse), other) in row.iter_mut().zip(column).zip(scale) {
                *entry = *inverse * own * other;
            }
        }
        Some(rows)
    }
}
