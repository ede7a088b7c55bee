//! The outline of a contact before the normal problem: where its cells lie, their first lengths,
//! and the power by which these are corrected.

use crate::contact::totals::StripCount;
use crate::normal::cell::{CELLS, Cells};
use crate::normal::cells::Given;
use crate::normal::density::{MOST_ZONES, Zones};
use crate::normal::estimate::{Estimate, OVERLAP};
use crate::normal::layout::{couple_parts, layout};
use crate::normal::profile::{Profile, invert};
use crate::normal::profile_contact::ProfileContact;
use crate::normal::smooth::SmoothedProfile;
use crate::number::{Arithmetic, Dual, Float};
use crate::status::{Error, Warning};
use core::f64::consts::PI;

/// Gap of the undeformed bodies at the edge of the contact, over the estimated deflection.
const DEFLECTED: f64 = 0.73;
/// Largest height of the curve's knots above the lowest point, over the first approach.
const KNOT_HEIGHT: f64 = 1.6;
/// Power of a correction times the number of lengths that it moves.
const POWER: f64 = 0.94;
/// Least square of a half length, over `R δ`.
const LEAST_SQUARE: f64 = 0.06;
/// Gap or overlap within which a cell touches in part, over the approach, times the number of
/// cells: 0.005 for 16 strips.
const PARTLY: f64 = 0.09;

/// Cells of the normal problem for about `count` strips, and of a contact with many lobes.
fn number_of_cells(count: StripCount) -> [usize; 2] {
    let cells = match count {
        StripCount::Four => [8, 18],
        StripCount::Eight => [12, 22],
        StripCount::Sixteen => [18, 28],
        StripCount::ThirtyTwo => [36, 40],
        StripCount::SixtyFour => [40, 40],
    };
    cells.map(|cells| cells.min(CELLS - MOST_ZONES))
}

/// What is known of the cells besides.
pub(super) struct Outline<F, const N: usize> {
    /// The load or the approach.
    pub given: Given<Dual<F, N>>,
    /// Of a correction of the lengths.
    pub power: Dual<F, N>,
    /// Gap or overlap of the bodies within which a cell touches in part \[m\].
    pub partly: Dual<F, N>,
    pub iterations: u32,
    /// Of zones that end with the profile, or of too many.
    pub warning: Warning,
    /// Lowest point of the smoothed profile above that of the given points.
    pub lowest: F,
}

impl<F: Float> Outline<F, 1> {
    /// Where cells lie, with their first lengths. None where the smoothed profile does not reach
    /// the other body. It stays out of line, because what leads to the cells is not needed while
    /// they are solved.
    #[inline(never)]
    pub fn new(
        profile: &Profile<F>, contact: &ProfileContact<F>, given: Given<Dual<F, 1>>,
        count: StripCount, cells: &mut Cells<F, 1>,
    ) -> Result<Option<Self>, Error> {
        let radius = contact.rolling_radius;
        // about the approach, and the curve that its width requires
        let (first, mut iterations) = match given {
            Given::Approach(approach) => (approach, 0),
            Given::Load(load) => {
                let load = load.times(PI);
                // of a sphere: N = (4/3) E* √R δ^(3/2)
                let like_sphere = (load.value.times(0.75) / radius.sqrt()).cube_root();
                let start = like_sphere * like_sphere;
                invert(load, start, |approach| profile.load(approach, radius))
                    .ok_or(Error::Overflow)?
            }
        };
        let [half_width, radius_there] = profile.section(first, radius);
        let length = contact.smoothing(half_width);
        let mut curve = SmoothedProfile::new(profile, length, first.times(KNOT_HEIGHT));
        // load and deflection before the normal problem
        let approach = match given {
            Given::Approach(approach) => approach,
            Given::Load(load) => {
                curve.still = true;
                let still_radius = Dual::from_base(radius_there.value);
                let load_at = |approach| Estimate::load(&curve, approach, still_radius, cells);
                let (found, steps) = invert(load, first.value, load_at).ok_or(Error::Overflow)?;
                curve.still = false;
                iterations += steps;
                // f(δ, c) = N, the curve c depending on N: dδ/dN = (1 − ∂f/∂c dc/dN)/(∂f/∂δ)
                let here = Dual::from_base(found.value);
                let [by_curve] = Estimate::load(&curve, here, radius_there, cells).gradient;
                let ([by_load], [unit]) = (found.gradient, load.gradient);
                let rest = F::one() - by_curve / unit;
                Dual { value: found.value, gradient: [by_load * rest] }
            }
        };
        if approach.value <= F::zero() {
            return Ok(None);
        }
        let outline = Self::with_cells(
            profile,
            contact,
            &curve,
            (given, approach),
            |_| radius_there,
            count,
            cells,
        );
        Ok(Some(Self { iterations, lowest: curve.lowest.value, ..outline }))
    }
}

impl<F: Float, const N: usize> Outline<F, N> {
    /// The cells of a curve for an approach.
    #[inline(never)]
    pub fn with_cells(
        profile: &Profile<F>, contact: &ProfileContact<F>, curve: &SmoothedProfile<F, N>,
        (given, approach): (Given<Dual<F, N>>, Dual<F, N>),
        radius: impl FnOnce(&mut dyn Iterator<Item = [Dual<F, N>; 2]>) -> Dual<F, N>,
        count: StripCount, cells: &mut Cells<F, N>,
    ) -> Self {
        let (warning, radius, width) = touching(curve, approach, radius, count, cells);
        couple_parts(cells);
        let first_lengths = Lengths::new(width, radius, approach);
        let of = |[y, over]: [Dual<F, N>; 2]| {
            let height = curve.over(y, over);
            let radius = profile.rolling_radius(y, contact.rolling_radius);
            let touches = approach.value.times(OVERLAP) > height.value;
            let touches = if touches { F::one() } else { F::zero() };
            ([height, radius, first_lengths.at(height, radius)], touches)
        };
        cells.set_gaps(of, |y| profile.centre_x(y));
        let power = first_lengths.power(given);
        let [cells, _] = number_of_cells(count);
        let partly = approach.times(PARTLY).scale(F::one() / F::widened(cells as f32));
        Self { given, power, partly, iterations: 0, warning, lowest: F::zero() }
    }
}

/// Lays cells out where the bodies touch by the estimate. Returns whether a zone ends with the
/// profile, the rolling radius, and the integral of the density of cells \[m\]. It stays out of
/// line, because the estimate is not needed afterwards.
#[inline(never)]
fn touching<F: Float, const N: usize>(
    curve: &SmoothedProfile<F, N>, approach: Dual<F, N>,
    of_loads: impl FnOnce(&mut dyn Iterator<Item = [Dual<F, N>; 2]>) -> Dual<F, N>,
    count: StripCount, cells: &mut Cells<F, N>,
) -> (Warning, Dual<F, N>, Dual<F, N>) {
    let mut estimate = Estimate::nothing();
    let mut radius = Dual::zero();
    estimate.solve_for(curve, approach, cells, |loads| {
        radius = of_loads(loads);
        radius
    });
    let count = number_of_cells(count);
    let (warning, width) = cells_of_zones(curve, &estimate, approach, count, cells);
    (warning, radius, width)
}

/// The part of it that needs the zones.
#[inline(never)]
fn cells_of_zones<F: Float, const N: usize>(
    curve: &SmoothedProfile<F, N>, estimate: &Estimate<F, N>, approach: Dual<F, N>,
    count: [usize; 2], cells: &mut Cells<F, N>,
) -> (Warning, Dual<F, N>) {
    let mut zones = Zones::new(approach, curve.smoothing());
    let at_end = curve.zones(&mut zones, |y, height, slope| {
        let [deflection, bend] = estimate.deflection(y);
        let height = height - approach + deflection.times(DEFLECTED);
        [height, slope + bend.times(DEFLECTED)]
    });
    let (width, resolved) = layout(&zones, count, cells);
    let warning = match (at_end, resolved && !zones.joined) {
        (true, _) => Warning::ProfileEnd,
        (_, false) => Warning::Rough,
        _ => Warning::None,
    };
    (warning, width)
}

/// First half lengths: of an ellipse at whose rim the undeformed bodies are `λ δ` apart.
struct Lengths<F, const N: usize> {
    rim: Dual<F, N>,
    /// About the logarithm of the axis ratio, times 1.13.
    slenderness: Dual<F, N>,
    approach: Dual<F, N>,
}

impl<F: Float, const N: usize> Lengths<F, N> {
    fn new(width: Dual<F, N>, radius: Dual<F, N>, approach: Dual<F, N>) -> Self {
        let ratio = width.times(1.0 / 2.1) / (radius * approach).sqrt();
        let logarithm = ratio.value.ln_quotient(F::one());
        let logarithm = Dual::composed(logarithm, [F::one() / ratio.value], [ratio]);
        let x = logarithm.times(1.13);
        let rim = (x / x.squared().times(1.53).plus(16.2).sqrt()).plus(1.0).times(0.5);
        Self { rim, slenderness: x, approach }
    }

    /// `a² = 2 R (1 − λ)(δ − h/λ)`, and at least about `0.06 R δ`.
    fn at(&self, height: Dual<F, N>, radius: Dual<F, N>) -> Dual<F, N> {
        let double = radius.times(2.0);
        let square = double * (Dual::one() - self.rim) * (self.approach - height / self.rim);
        let least = (radius * self.approach).times(LEAST_SQUARE);
        let apart = square - least;
        let root = (apart.squared() + least.squared()).sqrt();
        (square + least + root).times(0.5).sqrt()
    }

    /// The power of a correction of the lengths. A correction of one length changes the condition
    /// at its neighbours as well, less so in slender patches.
    fn power(&self, given: Given<Dual<F, N>>) -> Dual<F, N> {
        let more = match given {
            // 1.6/(1 + (g/0.6)^1.3)
            Given::Load(_) => {
                let logarithm = self.slenderness.plus(0.510_825_623_765_990_7).times(1.3);
                let power = logarithm.value.min(F::of(60.0)).exp();
                let power = Dual::composed(power, [power], [logarithm]);
                power.plus(1.0).inverse().times(1.6)
            }
            _ => Dual::constant(0.1),
        };
        more.plus(2.0).inverse().times(POWER)
    }
}
