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
//! The search begins at the given law and at laws that are spread over the usual ranges, of each
//! dozen the one with the least sum, until exact points are met. Of several minima the least one is
//! the result. A warning names another minimum whose residual is at most 1 per cent larger.
//!
//! A parameter that a step would lead beyond its bounds ends there, and stays as long as the sum
//! falls outward. With `m` forces and `n` parameters the standard errors are the roots of the
//! diagonal of `H⁻¹ Σ w (F − F_measured)²/(m − n)`.

use crate::contact::Contact;
use crate::forces::Options;
use crate::friction::SlipFriction;
use crate::friction::derivatives::{Differentiated, differentiate_with_law};
use crate::number::Float;
pub use crate::rig::measured::MeasuredForce;
use crate::rig::measured::MeasuredSums;
use crate::rig::sums::Sums;
use crate::status::{Error, Warning};
use nalgebra::{Matrix6, Vector6};

/// Largest number of times that all forces are computed from one start.
const MOST_EVALUATIONS: usize = 80;
/// The same from the least minimum, if it has not been reached.
const MOST_AT_THE_END: usize = 1000;
/// Starts besides the given one, and how many sets of parameters are compared for each.
const STARTS: usize = 9;
const COMPARED: usize = 12;
/// Ranges of these parameters: friction divided by the largest share of the load that was measured,
/// and the others in their units; and the power by which small ones are preferred.
const RANGES: [[f64; 2]; 6] =
    [[1.02, 2.5], [0.05, 0.95], [0.05, 10.0], [0.03, 1.0], [0.1, 1.0], [0.01, 30.0]];
const PREFERENCE: [usize; 6] = [2, 1, 3, 2, 1, 3];
/// Powers of 1/1.112776, the root of `x⁷ = x + 1`: the fractions of their multiples fill six
/// dimensions evenly (M. Roberts's sequence).
const FRACTIONS: [f64; 6] = [0.898_654, 0.807_578, 0.725_733, 0.652_183, 0.586_087, 0.526_689];
/// Sum of a minimum divided by that of the least one, up to which the residual is as good: 1.01
/// squared.
const AS_GOOD: f64 = 1.0201;
/// Difference of a parameter divided by its size from which two minima are not the same.
const MINIMA_APART: f64 = 0.02;
/// Roundings of the forces that are left at the minimum of exact points.
const EXACT: f64 = 100.0;
/// Damping at the start, its least, and the one that ends the search; how it falls and grows.
const DAMPING: [f64; 3] = [1e-2, 1e-8, 1e8];
const FALLS: f64 = 0.2;
const GROWS: f64 = 4.0;
/// Fall of the sum that ends the search, divided by the sum and by the root of a rounding.
const FALL_REACHED: f64 = 0.01;
/// Least factors, and least layer over the bodies' flexibility: below, no derivative is left.
const LEAST_FACTOR: f64 = 1e-3;
/// Error of the forces, over their size, that is presumed at least where it is asked whether the
/// points tell the parameters; and the share of a parameter that its standard error must not
/// exceed.
const PRESUMED: f64 = 0.01;
const UNCERTAIN: f64 = 0.5;
/// About `8/(3 C₁₁)`: the flexibility of the bodies divided by `a/G`.
const FLEXIBILITY: f64 = 0.6;

/// A law of friction that was fitted to measured points.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionFit<F> {
    /// The law.
    pub law: SlipFriction<F>,
    /// Standard errors of its members, from the remaining differences between points and law; 0 for
    /// a member that was not fitted or that ended at a bound.
    pub standard_errors: SlipFriction<F>,
    /// Root of the weighted mean square difference between measured and computed forces \[N\].
    pub residual: F,
    /// Largest number of times that all forces were computed from one start.
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
    contact: &Contact<F>, points: &[MeasuredForce<F>], start: &SlipFriction<F>, fitted: Fitted,
    options: &Options,
) -> Result<FrictionFit<F>, (usize, Error)> {
    Fit::new(contact, points, start, fitted, options)?.find()
}

/// The points and the parameters that are fitted.
struct Fit<'a, F> {
    contact: &'a Contact<F>,
    points: &'a [MeasuredForce<F>],
    options: &'a Options,
    fitted: Vector6<bool>,
    start: SlipFriction<F>,
    /// Units of the parameters.
    units: Vector6<F>,
    /// In these units.
    low: Vector6<F>,
    high: Vector6<F>,
    measured: MeasuredSums<F>,
}

/// Least plausible slope factor: measured curves have 0.2 to 1.
const LEAST_SLOPE_FACTOR: f64 = 0.05;

#[derive(Clone, Copy)]
struct Minimum<F> {
    at: Vector6<F>,
    sums: Sums<F>,
    steps: usize,
    settled: bool,
}

fn choose<F>(other: F, wanted: bool, one: F) -> F {
    if wanted { one } else { other }
}

fn parameters<F: Float>(law: &SlipFriction<F>) -> Vector6<F> {
    let SlipFriction { friction, ratio, decay, slope_factor, slide_factor, layer, .. } = *law;
    Vector6::new(friction, ratio, decay, slope_factor, slide_factor, layer)
}

fn with_parameters<F: Float>(law: &SlipFriction<F>, of: Vector6<F>) -> SlipFriction<F> {
    let [friction, ratio, decay, slope_factor, slide_factor, layer] = of.into();
    SlipFriction { friction, ratio, decay, slope_factor, slide_factor, layer, ..*law }
}

impl<'a, F: Float> Fit<'a, F> {
    fn new(
        contact: &'a Contact<F>, points: &'a [MeasuredForce<F>], start: &SlipFriction<F>,
        fitted: Fitted, options: &'a Options,
    ) -> Result<Self, (usize, Error)> {
        let all = points.len();
        let of_all = |result: Result<(), Error>| result.map_err(|error| (all, error));
        of_all(start.check())?;
        of_all(Contact { friction: F::zero(), ..*contact }.check())?;
        let wanted = fitted.iter().filter(|fitted| **fitted).count();
        of_all(Error::FitParameters.unless(wanted > 0))?;
        of_all(Error::Unexplained.unless(!contact.is_lost()))?;
        let measured = MeasuredSums::at_points(contact, points, start, options)?;
        let (zero, one) = (F::zero(), F::one());
        of_all(Error::FewPoints.unless(measured.count >= wanted))?;
        let flexible = (contact.a / contact.shear_modulus).times(FLEXIBILITY);
        // decay over which friction falls within the points
        let slow = start.rolling_speed * measured.fastest;
        let decay = if slow > zero { one / slow } else { one };
        let units = Vector6::new(one, one, decay, one, one, flexible);
        let (least, most, half) = (F::of(LEAST_FACTOR), F::of(1e6), F::of(0.5));
        let low = Vector6::new(least, zero, zero, least, least, least);
        let high = Vector6::new(most, one, most, one, one, most);
        let usual = Vector6::new(measured.used.times(1.05).max(least), half, one, half, half, one);
        let fitted = Vector6::from(fitted);
        let missing = parameters(start).zip_map(&fitted, |start, fitted| fitted && start <= zero);
        let usual = usual.zip_map(&units, |usual, unit| usual * unit);
        let begin = parameters(start).zip_zip_map(&missing, &usual, choose);
        let start = with_parameters(start, begin);
        Ok(Self { contact, points, options, fitted, start, units, low, high, measured })
    }

    /// The law with parameters in their units; those that are not fitted stay as they are.
    fn law(&self, of: &Vector6<F>) -> SlipFriction<F> {
        let of = of.zip_map(&self.units, |of, unit| of * unit);
        let values = parameters(&self.start).zip_zip_map(&self.fitted, &of, choose);
        with_parameters(&self.start, values)
    }

    fn sums(&self, of: &Vector6<F>) -> Result<Sums<F>, (usize, Error)> {
        let (law, load) = (self.law(of), self.contact.normal_force);
        let zero = F::zero();
        let (gradient, normal) = (Vector6::repeat(zero), Matrix6::repeat(zero));
        let mut sums = Sums { total: zero, gradient, normal };
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
                let row =
                    Vector6::from(row).zip_zip_map(&self.fitted, &self.units, |slope, on, unit| {
                        if on { slope * (unit / load) } else { zero }
                    });
                sums.add(point.weight, (computed - measured) / load, &row);
            }
        }
        Ok(sums)
    }

    /// The least of the minima that are reached from all starts.
    fn find(&self) -> Result<FrictionFit<F>, (usize, Error)> {
        let given = parameters(&self.start).zip_map(&self.units, |start, unit| start / unit);
        let rounding = self.exact_rest();
        let mut best = self.minimum(&given, MOST_EVALUATIONS);
        let mut is_alone = true;
        let mut shares = [F::zero(); 6];
        for _ in 0..STARTS {
            if best.as_ref().is_ok_and(|best| best.sums.total <= rounding) {
                break;
            }
            let Some(start) = self.promising_start(&given, &mut shares) else { continue };
            let Ok(other) = self.minimum(&start, MOST_EVALUATIONS) else { continue };
            let Ok(found) = best else {
                best = Ok(other);
                continue;
            };
            let is_less = other.sums.total < found.sums.total;
            let (less, more) = if is_less { (other, found) } else { (found, other) };
            if more.sums.total > less.sums.total.times(AS_GOOD) + rounding {
                is_alone |= is_less;
            } else if more.settled {
                is_alone &= !self.are_apart(&less.at, &more.at);
            }
            best = Ok(Minimum { steps: less.steps.max(more.steps), ..less });
        }
        let best = best?;
        if best.settled {
            return Ok(self.result(&best, is_alone));
        }
        let end = self.minimum(&best.at, MOST_AT_THE_END)?;
        Ok(self.result(&Minimum { steps: best.steps + end.steps, ..end }, is_alone))
    }

    /// The parameters with the least sum among several that are spread over their ranges; members
    /// that are not fitted keep the given values. `shares` are the last ones that were tried, in
    /// parts of the ranges. None if no sum exists.
    fn promising_start(&self, given: &Vector6<F>, shares: &mut [F; 6]) -> Option<Vector6<F>> {
        let fractions = FRACTIONS.map(F::of);
        let ranges = RANGES.map(|[low, high]| [F::of(low), F::of(high - low)]);
        let mut best: Option<(F, Vector6<F>)> = None;
        for _ in 0..COMPARED {
            for (share, fraction) in shares.iter_mut().zip(fractions) {
                let turns = *share + fraction;
                *share = if turns < F::one() { turns } else { turns - F::one() };
            }
            let mut start = [F::zero(); 6];
            let tried = start.iter_mut().zip(&*shares).zip(ranges.into_iter().zip(PREFERENCE));
            for ((start, share), ([low, width], powers)) in tried {
                let share = core::iter::repeat_n(*share, powers).fold(F::one(), |x, by| x * by);
                *start = low + width * share;
            }
            let mut start = Vector6::from(start);
            start.x = start.x * self.measured.used;
            let start = given.zip_zip_map(&self.fitted, &start, choose);
            let Ok(sums) = self.sums(&start) else { continue };
            if best.is_none_or(|(least, _)| sums.total < least) {
                best = Some((sums.total, start));
            }
        }
        best.map(|(_, start)| start)
    }

    /// What is left of the sum at the minimum of exact points.
    fn exact_rest(&self) -> F {
        self.measured.squares * (F::EPSILON * F::EPSILON).times(EXACT * EXACT)
    }

    /// Whether a fitted parameter of two minima differs by more than a small share of its size.
    fn are_apart(&self, one: &Vector6<F>, other: &Vector6<F>) -> bool {
        one.iter().zip(other).zip(&self.fitted).any(|((one, other), fitted)| {
            *fitted && (*one - *other).abs() > one.abs().max(other.abs()).times(MINIMA_APART)
        })
    }

    /// The minimum that is reached from a start. A trial step that has no forces is a bad step.
    ///
    /// # Errors
    /// Those of [`differentiate_with_law`] at the start.
    fn minimum(&self, start: &Vector6<F>, most: usize) -> Result<Minimum<F>, (usize, Error)> {
        let mut at = start.zip_zip_map(&self.low, &self.high, F::clamped);
        let [start, least, stiffest] = DAMPING.map(F::of);
        let mut damping = start;
        let mut sums = self.sums(&at)?;
        let (mut steps, mut settled) = (1, false);
        while steps < most && !settled {
            let free = self.free(&at, &sums);
            let Some(inverse) = sums.inverted(&free, damping) else {
                damping = damping.times(GROWS);
                settled = damping > stiffest;
                continue;
            };
            let mut next = at;
            for (next, row) in next.iter_mut().zip(inverse.column_iter()) {
                let step =
                    row.iter().zip(&sums.gradient).fold(F::zero(), |sum, (a, g)| sum + *a * *g);
                *next -= step;
            }
            next = next.zip_zip_map(&self.low, &self.high, F::clamped);
            steps += 1;
            let found = self.sums(&next).ok().filter(|found| found.total < sums.total);
            if let Some(found) = found {
                let fall = sums.total - found.total;
                (at, sums) = (next, found);
                let rounding = self.measured.squares * F::EPSILON * F::EPSILON;
                settled = fall <= sums.total * F::EPSILON.sqrt().times(FALL_REACHED) + rounding;
                damping = damping.times(FALLS).max(least);
            } else {
                damping = damping.times(GROWS);
                settled = damping > stiffest || next == at;
            }
        }
        settled |= sums.total <= self.exact_rest();
        Ok(Minimum { at, sums, steps, settled })
    }

    /// Which parameters may move: those that are fitted, and not at a bound beyond which the sum
    /// falls.
    fn free(&self, at: &Vector6<F>, sums: &Sums<F>) -> Vector6<bool> {
        let zero = F::zero();
        let below = at.zip_zip_map(&self.low, &sums.gradient, |at, low, by| at <= low && by > zero);
        let above =
            at.zip_zip_map(&self.high, &sums.gradient, |at, high, by| at >= high && by < zero);
        self.fitted.zip_zip_map(&below, &above, |fitted, below, above| fitted && !below && !above)
    }

    /// Whether the sum would fall beyond a bound that a parameter has reached. At the bounds of
    /// ratio and of both factors the law is the usual one, and so it is below the least layer.
    fn is_at_bound(&self, at: &Vector6<F>, sums: &Sums<F>) -> bool {
        self.free(at, sums) != self.fitted
    }

    fn result(&self, found: &Minimum<F>, is_alone: bool) -> FrictionFit<F> {
        let Minimum { at, sums, steps, settled } = found;
        let (zero, load) = (F::zero(), self.contact.normal_force);
        let free = self.free(at, sums);
        let moves = free.iter().filter(|free| **free).count();
        let number = |n: usize| F::widened(n as f32);
        let left = sums.total / number(self.measured.count.saturating_sub(moves).max(1));
        let presumed =
            self.measured.squares / number(self.measured.count) * F::of(PRESUMED * PRESUMED);
        let mut errors = Vector6::repeat(zero);
        let mut tells = false;
        if let Some(inverse) = sums.inverted(&free, zero) {
            // Ratio and slide factor are shares of one, whose error is absolute.
            let shares = Vector6::new(false, true, false, false, true, false);
            let sizes = shares.zip_map(at, |share, value| if share { F::one() } else { value });
            // The variances of parameters that are not free are zero.
            let variances = inverse.diagonal();
            let least = variances.map(|variance| (variance * left.max(presumed)).max(zero).sqrt());
            tells = least
                .iter()
                .zip(&sizes)
                .zip(&free)
                .all(|((error, size), free)| !free || *error <= size.times(UNCERTAIN));
            errors = variances.map(|variance| (variance * left).max(zero).sqrt().min(F::HUGE));
        }
        errors = errors.zip_map(&self.units, |error, unit| (error * unit).min(F::HUGE));
        let warnings = [
            // a search along parameters that the points do not determine need not end
            (!settled && tells, Warning::NotConverged),
            (!tells, Warning::Undetermined),
            (!is_alone, Warning::SecondMinimum),
            (self.is_at_bound(at, sums), Warning::FitBound),
        ];
        let law = self.law(at);
        let [[_, _, _, is_fitted, _, _]] = self.fitted.data.0;
        let is_soft = is_fitted && law.slope_factor < F::of(LEAST_SLOPE_FACTOR);
        let per_cent = if is_soft { Warning::PerCent } else { Warning::None };
        FrictionFit {
            law,
            standard_errors: with_parameters(&SlipFriction::default(), errors),
            residual: ((sums.total / self.measured.weights).sqrt() * load).min(F::HUGE),
            steps: *steps as u32,
            warning: Warning::first(&warnings).worse(per_cent),
        }
    }
}
