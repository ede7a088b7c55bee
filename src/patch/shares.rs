//! The forces of each strip of a patch in the model STRIP. The ellipse of its zone gives it the
//! creepages for its `Y`, its friction bound `Π = (μ p₀)_strip/(μ p₀)`, and its flexibility.

use crate::contact::creepage::{Creepage, normalised};
use crate::contact::totals::StripForces;
use crate::contact::{Contact, mismatch};
use crate::linear::LinearCoefficients;
use crate::number::{Float, Number};
use crate::patch::sizes::Widths;
use crate::patch::slip::{PatchSlip, Share, ZoneSplit, creepage_at, creepage_of_strip};
use crate::patch::zones::Zone;
use crate::patch::{PatchStrip, PatchView, QuadratureScale};
use crate::status::Warning;
use crate::strip::{Distribution, Flexibilities, StripCreepage, StripGeometry, eight_strips};
use heapless::Vec;

/// Least share `Π` of the friction bound. A strip with less is treated as one with this share, so
/// that the squares of its creepages fit an `f32`.
const LEAST_BOUND: f64 = 1e-9;
/// Axis ratio `a/b` for which the flexibility of a strip has half of its full deviation.
const HALF_RATIO: f64 = 5.0;
/// Deviations of a strip's pressure from the zone's that are rounding, in units of the last place.
const LIKE_ELLIPSE: f64 = 32.0;

/// What the strips of a zone need of its ellipse.
pub(super) struct ZoneModel<F: Float> {
    zone: Zone<F>,
    pub units: ZoneUnits<F>,
    linear: LinearCoefficients<F>,
    flexibilities: Flexibilities<F>,
}

/// The creepages of the strips of a zone, for one motion and one centre along `x`.
#[derive(Clone, Copy)]
pub(super) struct ZoneCreepages<T: Number> {
    x: T::Base,
    pub distribution: Distribution<T>,
    /// The creepage that pressure adds.
    shift: T,
    /// The creepage of the ellipse, and what half-spaces and bristles have of it.
    pub whole: Creepage<T>,
    pub split: Option<ZoneSplit<T>>,
}

impl<F: Float> ZoneModel<F> {
    /// The factors are those of the quadrature, or 1.
    pub fn new(zone: &Zone<F>, factors: [F; 2]) -> Self {
        let Contact { a, b, poisson_ratio, .. } = zone.contact;
        let linear = LinearCoefficients::at(a / b, poisson_ratio);
        let flexibilities = Flexibilities::new(a / b, poisson_ratio, &linear, factors);
        Self { zone: *zone, units: ZoneUnits::new(zone), linear, flexibilities }
    }

    /// The creepages of strips with this centre, for their creepage of the patch, not the slip's.
    pub fn creepages<T: Number<Base = F>>(
        &self, slip: &PatchSlip<T>, creepage: &Creepage<T>, x: F,
    ) -> ZoneCreepages<T> {
        let Self { zone, linear, flexibilities, .. } = self;
        let (whole, shift) = creepage_of_zone(zone, linear, slip, creepage, x);
        let split = slip.behind.map(|behind| ZoneSplit::new(zone, linear, &whole, x, &behind));
        let of_half_spaces = split.map_or(whole, |split| split.half_spaces(&whole));
        let distribution = flexibilities.see(normalised(&zone.contact, &of_half_spaces));
        ZoneCreepages { x, distribution, shift, whole, split }
    }
}

/// Passes the forces of every strip to `visit`, eight strips side by side. Returns the warning of
/// the ellipses. Out of line, so that the other models do not take its room on the stack.
#[inline(never)]
pub(super) fn strip_shares<F: Float, T: Number<Base = F>>(
    view: &PatchView<F>, slip: &PatchSlip<T>, warning_of: &dyn Fn(&Contact<F>) -> Warning,
    visit: &mut dyn FnMut(&PatchStrip<F>, Share<T>),
) -> Warning {
    let mut warning = Warning::None;
    let QuadratureScale { area, lever } = view.quadrature();
    let (mut known, mut last): (Option<ZoneModel<F>>, Option<ZoneCreepages<T>>) = (None, None);
    let of_patch = view.sizes.widths;
    for (first, lobe, of_lobe) in view.lobes_and_zones() {
        let is_whole = lobe.len() == view.strips().len();
        let widths = if of_patch.alternate && !is_whole { Widths::of_rule(lobe) } else { of_patch };
        let (count, mut in_lobe) = (lobe.len(), false);
        let half = F::of(0.5);
        let kinds = if widths.alternate { [F::zero(), F::one()] } else { [half; 2] };
        for (g, group) in lobe.chunks(8).enumerate() {
            let zero = T::zero();
            let none = StripCreepage { x: zero, y: zero, spread: zero, start: zero };
            let mut creepages = [(none, T::zero()); 8];
            let (mut inner, mut which) = ([F::zero(); 8], [usize::MAX; 8]);
            // what successive strips have in common, and which of these a strip has
            let mut shifts: Vec<(T, Option<ZoneSplit<T>>), 8> = Vec::new();
            let strips = group.iter().zip(&mut creepages).zip(&mut inner).zip(&mut which);
            for (k, (((strip, creepage), inner), which)) in strips.enumerate() {
                let i = 8 * g + k;
                let x = strip.centre_x;
                if !in_lobe || of_lobe.is_none() {
                    let own = of_lobe.or_else(|| view.zone(first + i));
                    let Some(zone) = own else { continue };
                    if !known.as_ref().is_some_and(|model| zone.nearly_equals(&model.zone)) {
                        // So that the slopes are those of the linear theory for any quadrature.
                        (known, last) = (Some(ZoneModel::new(&zone, [area, lever])), None);
                        warning = warning.worse(warning_of(&zone.contact));
                    }
                    in_lobe = true;
                }
                let Some(model) = &known else { continue };
                let own = view.own(first + i);
                let changes = own.is_some() || last.as_ref().is_none_or(|last| last.x != x);
                if changes {
                    let of_strip = creepage_of_strip(&slip.creepage, strip, own.as_ref());
                    last = Some(model.creepages(slip, &of_strip, x));
                }
                let Some(found) = &last else { continue };
                if changes || shifts.is_empty() {
                    let _ = shifts.push((found.shift, found.split));
                }
                *which = shifts.len() - 1;
                *creepage = found
                    .distribution
                    .strip(&model.units.geometry(strip, strip.width * widths.per_mean));
                let [outermost, next] = kinds;
                *inner = if i.min(count - 1 - i) % 2 == 1 { next } else { outermost };
            }
            for (k, (strip, own)) in group.iter().zip(eight_strips(&creepages, inner)).enumerate() {
                let of_zone = which.get(k).and_then(|which| shifts.get(*which));
                let (shift, split) =
                    of_zone.map_or((zero, None), |(x, split)| (*x, split.as_ref()));
                let share = share_of_strip(strip, &own, split);
                visit(strip, share.on(strip, shift, view.own(first + 8 * g + k).as_ref()));
            }
        }
    }
    warning
}

/// The forces of a strip, behind a layer their mean over half-spaces and bristles.
fn share_of_strip<F: Float, T: Number<Base = F>>(
    strip: &PatchStrip<F>, found: &StripForces<T>, split: Option<&ZoneSplit<T>>,
) -> Share<T> {
    let stick = found.stick.value();
    let share = Share::new(strip, found, stick, stick > F::zero());
    split.map_or(share, |split| split.mean(strip, share))
}

/// Creepage of a zone's ellipse at `x` on its middle line, and the part that pressure adds.
pub(super) fn creepage_of_zone<T: Number>(
    zone: &Zone<T::Base>, linear: &LinearCoefficients<T::Base>, slip: &PatchSlip<T>,
    creepage: &Creepage<T>, x: T::Base,
) -> (Creepage<T>, T) {
    let creepage = creepage_at(creepage, x, zone.y);
    let whole = mismatch::with_pressure(&zone.contact, linear, &creepage, slip.pressure);
    (whole, whole.longitudinal - creepage.longitudinal)
}

/// The units of the strips of a zone.
pub(super) struct ZoneUnits<F> {
    y: F,
    per_a: F,
    per_b: F,
    /// `1/(μ p₀)` of the zone's ellipse; zero without friction or load.
    per_bound: F,
    /// `w`, and divided by the zone's mean of `l/p₀`.
    weight: F,
    weighted_pressure: F,
}

impl<F: Float> ZoneUnits<F> {
    pub fn new(zone: &Zone<F>) -> Self {
        let Zone { y, contact, length_by_pressure, .. } = zone;
        let bound = contact.friction * contact.peak_pressure();
        let ratio = (contact.a / contact.b).times(1.0 / HALF_RATIO);
        // no deviation in a zone without load
        let has_load = *length_by_pressure > F::TINY;
        let weight = if has_load { (ratio * ratio).plus(1.0).inverse() } else { F::zero() };
        Self {
            y: *y,
            per_a: F::one() / contact.a,
            per_b: F::one() / contact.b,
            per_bound: if bound > F::zero() { F::one() / bound } else { F::zero() },
            weight,
            weighted_pressure: weight / length_by_pressure.max(F::TINY),
        }
    }

    /// A strip in units of the ellipse, and its width divided by the mean of all.
    pub fn geometry(&self, strip: &PatchStrip<F>, width: F) -> StripGeometry<F> {
        let (pressure, per_bound) = (strip.peak_pressure, self.per_bound);
        // p₀ (L_y − 1) = w (l/s̄ − p₀), nothing that is rounding, so that ellipses stay ellipses
        let excess = strip.half_length * self.weighted_pressure - pressure * self.weight;
        let rounding = pressure * F::EPSILON.times(LIKE_ELLIPSE);
        let excess = excess - excess.clamped(-rounding, rounding);
        // Π = (μ p₀)_strip/(μ p₀), and Π (L_y − 1)
        let bound = strip.friction * pressure * per_bound;
        let bound = if per_bound > F::zero() { bound } else { F::one() };
        let more = strip.friction * excess * per_bound;
        StripGeometry {
            y: ((strip.y - self.y) * self.per_b).clamped(-F::one(), F::one()),
            half_length: strip.half_length * self.per_a,
            // The width of one of sixteen strips, whatever their number.
            width: width.times(0.125),
            bound: [bound + more.times(0.5), bound + more]
                .map(|bound| bound.max(F::of(LEAST_BOUND))),
        }
    }
}
