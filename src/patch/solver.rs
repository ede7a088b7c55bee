//! Forces, derivatives, strips and fields of a patch that is given by its strips.
//!
//! A strip sees the creepage at its own place, `(υx − φ y, υy + φ x_c, φ)`, and its own friction bound `μ p₀`:
//! friction that varies over `y` is nothing special. Its force acts at `(x_c, y)`.
//!
//! * Theory of 1967: [`Strip::solve`] in units of the strip. The strips do not move with the
//!   solution, so where a strip loses its adhesion area the forces have a kink, and under
//!   [`SlidingRule::RigidSlip`] with spin a jump as large as that strip's share.
//! * Corrected strips: the ellipse of a strip's [zone](super::zones) is solved at the creepage of its own centre, and
//!   gives the strip the creepages of its `Y` and `Π = (μ p₀)_strip/(μ p₀)`. A strip whose
//!   centre is moved by `x_c` is solved with what is seen for the lateral creepage there.
//!
//! * [`Model::Total`]: a strip carries its share, by friction bound, of what the ellipse of its zone carries at the creepage of
//!   its own centre. Cheap and smooth; strips and fields are not known.
//!
//! [`Model::Linear`] knows ellipses only. The linear theory of a patch is the derivative of
//! [`Model::Strip`] at zero creepage: [`solve_jacobian`].

use crate::contact::creepage::{Creepage, Parameters};
use crate::contact::forces::Totals;
use crate::linear::LinearCoefficients;
use crate::number::dual::Dual;
use crate::number::{Float, Real};
use crate::patch::zones::{Widths, Zone};
use crate::patch::{PatchStrip, PatchView};
use crate::solve::field::{FieldPoint, rolling_point};
use crate::solve::model::{Model, Precision, Solution, StripResult};
use crate::status::{Error, Notice};
use crate::strip::{Carried, Law as StripLaw, Prepared, Seen, StripGeometry, four_strips};
use crate::strip_1967::strip::{Regime, SlidingRule, State, Strip, StripPoint};
use crate::total;
use nalgebra::Matrix3;

/// Share `Π` of the friction bound below which a strip is treated as one with this share: the squares of what it
/// sees fit an `f32`.
const LEAST_BOUND: f64 = 1e-9;

/// What a strip carries.
#[derive(Clone, Copy, Debug)]
struct Share<T: Real> {
    fx: T,
    fy: T,
    /// About the origin of the patch.
    mz: T,
    /// Share of its length in adhesion, at the leading edge.
    stick: T::Base,
    adheres: bool,
}

impl<T: Real> Share<T> {
    /// From forces over the strip's friction bound, and the moment about its centre in half lengths.
    #[inline(always)]
    fn new(
        strip: &PatchStrip<T::Base>,
        carried: &Carried<T>,
        stick: T::Base,
        adheres: bool,
    ) -> Self {
        let bound = strip.friction_bound();
        let Carried { fx, fy, mx, .. } = *carried;
        let (fx, fy) = (fx.scale(bound), fy.scale(bound));
        // Mz = ∫ (x Y − y X)
        let mz = mx.scale(bound * strip.half_length) + fy.scale(strip.centre_x) - fx.scale(strip.y);
        Self { fx, fy, mz, stick, adheres }
    }
}

/// Rigid slip at the point `(x, y)` as creepage of a contact there: `(υx − φ y, υy + φ x, φ)`.
fn creepage_at<T: Real>(creepage: &Creepage<T>, x: T::Base, y: T::Base) -> Creepage<T> {
    let Creepage { longitudinal, lateral, spin } = *creepage;
    Creepage { longitudinal: longitudinal - spin.scale(y), lateral: lateral + spin.scale(x), spin }
}

/// No point of a patch is farther from its origin.
fn reach<F: Float>(view: &PatchView<F>) -> F {
    view.strips().iter().fold(F::zero(), |reach, strip| {
        reach.max(strip.y.abs() + strip.centre_x.abs() + strip.half_length)
    })
}

/// No point within reach has a larger rigid slip.
fn rigid_slip<F: Float>(creepage: &Creepage<F>, reach: F) -> F {
    creepage.longitudinal.abs() + creepage.lateral.abs() + creepage.spin.abs() * reach
}

/// Checks the inputs of [`solve`] without solving; a bound of the rigid slip.
pub(crate) fn check<F: Precision>(
    view: &PatchView<F>,
    creepage: &Creepage<F>,
    model: Model,
) -> Result<F, Error> {
    Problem::new(view, creepage, model)?;
    Ok(rigid_slip(creepage, reach(view)))
}

/// A patch, a creepage and a model that fit together.
#[derive(Clone, Copy, Debug)]
struct Problem<'a, F> {
    view: &'a PatchView<'a, F>,
    creepage: &'a Creepage<F>,
    model: Model,
}

impl<'a, F: Precision> Problem<'a, F> {
    fn new(
        view: &'a PatchView<'a, F>,
        creepage: &'a Creepage<F>,
        model: Model,
    ) -> Result<Self, Error> {
        creepage.check()?;
        if model == Model::Linear {
            return Err(Error::NotInModel);
        }
        let reach = reach(view);
        let slip = rigid_slip(creepage, reach);
        let bound = view.friction_bound();
        let results = [slip, bound * reach, bound * slip];
        if results.iter().all(|result| result.is_finite_number()) {
            Ok(Self { view, creepage, model })
        } else {
            Err(Error::Overflow)
        }
    }

    /// For a model that knows what a strip carries.
    fn with_strips(
        view: &'a PatchView<'a, F>,
        creepage: &'a Creepage<F>,
        model: Model,
    ) -> Result<Self, Error> {
        if model == Model::Total {
            return Err(Error::NotInModel);
        }
        Self::new(view, creepage, model)
    }

    fn notice(&self) -> Notice {
        let beyond = |psi: F| psi.abs() >= F::one();
        let outside = |parameters: &Parameters<F>| {
            let ratio = parameters.axis_ratio;
            parameters.psi.abs() > F::constant(3.0)
                || ratio < F::constant(0.099_999)
                || ratio > F::constant(10.000_1)
        };
        let mut loaded =
            self.view.strips().iter().filter(|strip| strip.friction_bound() > F::zero());
        if matches!(self.model, Model::Strip | Model::Total) {
            let view = self.view;
            let ellipses = if view.is_one_zone() { 1 } else { view.strips().len() };
            let mut zones = (0..ellipses)
                .filter_map(|i| view.zone(i))
                .filter(|zone| zone.contact.friction_bound() > F::zero());
            if zones.any(|zone| outside(&Parameters::new(&zone.contact, self.creepage))) {
                return Notice::OutsideRange;
            }
        } else if loaded.any(|strip| beyond(self.parameters(strip, self.creepage).psi)) {
            return Notice::SpinBeyondTheory;
        }
        Notice::None
    }

    /// Hands what every strip carries to `visit`.
    fn shares<T: Real<Base = F>>(
        &self,
        creepage: &Creepage<T>,
        visit: &mut impl FnMut(&PatchStrip<F>, Share<T>),
    ) {
        if self.model == Model::Strip {
            self.rolling_shares(creepage, visit);
        } else if self.model == Model::Total {
            self.elliptic_shares(creepage, visit);
        } else {
            for strip in self.view.strips() {
                visit(strip, self.theory_share(strip, creepage));
            }
        }
    }

    /// Kalker's parameters in units of a strip.
    fn parameters<T: Real<Base = F>>(
        &self,
        strip: &PatchStrip<F>,
        creepage: &Creepage<T>,
    ) -> Parameters<T> {
        let circle = strip.circle(self.view.shear_modulus(), self.view.poisson_ratio());
        Parameters::new(&circle, &creepage_at(creepage, strip.centre_x, strip.y))
    }

    /// A strip in the theory of 1967, its half length one.
    fn theory<T: Real<Base = F>>(&self, strip: &PatchStrip<F>, creepage: &Creepage<T>) -> Strip<T> {
        let rule = match self.model {
            Model::Strip1967Continuous => SlidingRule::Continuous,
            _ => SlidingRule::RigidSlip,
        };
        let Parameters { xi, eta, psi, poisson_ratio, .. } = self.parameters(strip, creepage);
        Strip::solve(T::one(), xi, eta, psi, poisson_ratio, rule)
    }

    #[inline(never)]
    fn theory_share<T: Real<Base = F>>(
        &self,
        strip: &PatchStrip<F>,
        creepage: &Creepage<T>,
    ) -> Share<T> {
        let solved = self.theory(strip, creepage);
        let (fx, fy) = solved.force();
        let carried = Carried { fx, fy, mx: solved.moment(), stick: T::zero() };
        let stick = match solved.regime {
            Regime::Adhesion { kappa, .. } => F::one() - kappa.value(),
            Regime::Sliding { .. } => F::zero(),
        };
        Share::new(strip, &carried, stick, solved.adheres())
    }

    /// The corrected strips of a zone's ellipse, for the creepage at `x` on its middle line.
    fn law<T: Real<Base = F>>(
        &self,
        zone: &Zone<F>,
        creepage: &Creepage<T>,
        x: F,
        factors: [F; 2],
    ) -> StripLaw<T> {
        let parameters = Parameters::new(&zone.contact, &creepage_at(creepage, x, zone.y));
        let Parameters { axis_ratio, poisson_ratio, .. } = parameters;
        let linear = LinearCoefficients::at(axis_ratio, poisson_ratio);
        Prepared::new(axis_ratio, poisson_ratio, &linear, factors).see(parameters.normalised())
    }

    /// Every strip's share of what the ellipse of its zone carries.
    #[inline(never)]
    fn elliptic_shares<T: Real<Base = F>>(
        &self,
        creepage: &Creepage<T>,
        visit: &mut impl FnMut(&PatchStrip<F>, Share<T>),
    ) {
        let one_zone = self.view.is_one_zone();
        let mut solved: Option<(Zone<F>, Totals<T>)> = None;
        for (i, strip) in self.view.strips().iter().enumerate() {
            let (zone, totals) = match solved {
                Some(solved) if one_zone => solved,
                _ => {
                    let Some(zone) = self.view.zone(i) else { return };
                    match solved {
                        Some((last, totals)) if zone.is(&last) => (last, totals),
                        _ => (zone, Self::elliptic_totals(&zone, creepage)),
                    }
                }
            };
            solved = Some((zone, totals));
            let bound = strip.friction_bound();
            let (fx, fy) = (totals.fx.scale(bound), totals.fy.scale(bound));
            let size = (zone.contact.a * zone.contact.b).sqrt();
            // Mz = ∫ (x Y − y X)
            let mz = totals.mz.scale(bound * size) + fy.scale(zone.x) - fx.scale(zone.y);
            visit(strip, Share { fx, fy, mz, stick: -F::one(), adheres: false });
        }
    }

    fn elliptic_totals<T: Real<Base = F>>(zone: &Zone<F>, creepage: &Creepage<T>) -> Totals<T> {
        let parameters = Parameters::new(&zone.contact, &creepage_at(creepage, zone.x, zone.y));
        let Parameters { axis_ratio, poisson_ratio, .. } = parameters;
        let linear = LinearCoefficients::at(axis_ratio, poisson_ratio);
        total::Prepared::new(axis_ratio, poisson_ratio, &linear).totals(parameters.normalised())
    }

    fn rolling_shares<T: Real<Base = F>>(
        &self,
        creepage: &Creepage<T>,
        visit: &mut impl FnMut(&PatchStrip<F>, Share<T>),
    ) {
        let scale = self.view.scale();
        let one_zone = self.view.is_one_zone();
        let mut prepared: Option<(Zone<F>, F, StripLaw<T>)> = None;
        let mut before = 0;
        for lobe in self.view.lobes() {
            let (count, widths) = (lobe.len(), Widths::new(lobe));
            for (g, group) in lobe.chunks(4).enumerate() {
                let zero = T::zero();
                let none = Seen { x: zero, y: zero, spread: zero, start: zero };
                let mut seen = [(none, T::zero()); 4];
                let mut inner = [F::zero(); 4];
                for (k, ((strip, seen), inner)) in
                    group.iter().zip(&mut seen).zip(&mut inner).enumerate()
                {
                    let i = 4 * g + k;
                    let zone = match prepared {
                        Some((zone, ..)) if one_zone => Some(zone),
                        _ => self.view.zone(before + i),
                    };
                    let Some(zone) = zone else { continue };
                    let law = match prepared {
                        Some((last, x, law)) if x == strip.centre_x && zone.is(&last) => law,
                        // the slopes of the linear theory, whatever the quadrature
                        _ => self.law(&zone, creepage, strip.centre_x, [scale.area, scale.lever]),
                    };
                    prepared = Some((zone, strip.centre_x, law));
                    *seen = law.strip(&geometry(&zone, strip, widths.mean));
                    let alternating = widths.alternation.times(0.5);
                    let is_inner = i.min(count - 1 - i) % 2 == 1;
                    *inner = (if is_inner { alternating } else { -alternating }).plus(0.5);
                }
                for (strip, found) in group.iter().zip(both_kinds(&seen, inner)) {
                    let stick = found.stick.value();
                    visit(strip, Share::new(strip, &found, stick, stick > F::zero()));
                }
            }
            before += count;
        }
    }
}

/// Four strips with their shares of the inner strips' nodes; both kinds are evaluated where one is not enough.
fn both_kinds<F: Precision, T: Real<Base = F>>(
    seen: &[(Seen<T>, T); 4],
    inner: [F; 4],
) -> [Carried<T>; 4] {
    let mostly = inner.map(|share| share > F::of(0.5));
    let mut found = four_strips(seen, mostly);
    let of_other = |share: F| share.min(F::one() - share);
    if inner.iter().any(|share| of_other(*share) > F::zero()) {
        let others = four_strips(seen, mostly.map(|inner| !inner));
        for ((found, other), share) in found.iter_mut().zip(others).zip(inner) {
            let mix = |own: T, other: T| own + (other - own).scale(of_other(share));
            *found = Carried {
                fx: mix(found.fx, other.fx),
                fy: mix(found.fy, other.fy),
                mx: mix(found.mx, other.mx),
                stick: mix(found.stick, other.stick),
            };
        }
    }
    found
}

/// A strip in units of its zone's ellipse.
fn geometry<F: Float>(zone: &Zone<F>, strip: &PatchStrip<F>, mean_width: F) -> StripGeometry<F> {
    let Zone { y, contact, .. } = zone;
    // Π = (μ p₀)_strip/(μ p₀)
    let whole = contact.friction * contact.peak_pressure();
    let bound = strip.friction * strip.peak_pressure;
    StripGeometry {
        y: ((strip.y - *y) / contact.b).clamped(-F::one(), F::one()),
        half_length: strip.half_length / contact.a,
        // of sixteen strips, whatever their number
        width: (strip.width / mean_width).times(0.125),
        bound: if whole > F::zero() { bound / whole } else { F::one() }.max(F::of(LEAST_BOUND)),
    }
}

/// Sums over the strips.
struct Sums<T: Real> {
    fx: T,
    fy: T,
    mz: T,
    stick: T::Base,
    area: T::Base,
}

impl<F: Precision> Problem<'_, F> {
    fn sums<T: Real<Base = F>>(&self, creepage: &Creepage<T>) -> Sums<T> {
        let zero = T::zero();
        let mut sums = Sums { fx: zero, fy: zero, mz: zero, stick: F::zero(), area: F::zero() };
        self.shares(creepage, &mut |strip, share| {
            sums.fx += share.fx;
            sums.fy += share.fy;
            sums.mz += share.mz;
            let area = strip.half_length * strip.width;
            sums.stick += area * share.stick;
            sums.area += area;
        });
        sums
    }

    fn solution(&self, fx: F, fy: F, mz: F, stick: F, area: F) -> Solution<F> {
        Solution {
            fx,
            fy,
            mz,
            power: self.creepage.power([fx, fy, mz]),
            adhesion: if self.model == Model::Total {
                -F::one()
            } else if area > F::zero() {
                (stick / area).clamped(F::zero(), F::one())
            } else {
                F::zero()
            },
            notice: self.notice(),
            reserved: 0,
        }
    }
}

/// Forces of a patch; the moment is about the origin of its coordinates, `|F| ≤ Σ μ N`.
///
/// # Errors
/// [`Error::NotFinite`]; [`Error::NotInModel`] for [`Model::Linear`];
/// [`Error::Overflow`] when a force or the power does not fit the floating-point type.
///
/// # Example
/// A wheel on a rail whose outer third is greasy:
/// ```
/// use kstrip::{contact::Contact, contact::creepage::Creepage, solve::model::Model, contact::forces::StripCount};
/// use kstrip::{patch::Patch, patch::solver::solve};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, shear_modulus: 82e9, poisson_ratio: 0.28, friction: 0.3,
/// };
/// let mut patch = Patch::<f64, 16>::from_ellipse(&contact, StripCount::Sixteen)?;
/// let creepage = Creepage { longitudinal: 3e-3, lateral: 0.0, spin: 0.0 };
/// let dry = solve(&patch.view()?, &creepage, Model::Strip)?;
/// for strip in patch.strips.iter_mut().filter(|strip| strip.y > 1.3e-3) {
///     strip.friction = 0.05;
/// }
/// let greasy = solve(&patch.view()?, &creepage, Model::Strip)?;
/// assert!(greasy.fx < dry.fx && greasy.mz > 0.0);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn solve<F: Precision>(
    patch: &PatchView<F>,
    creepage: &Creepage<F>,
    model: Model,
) -> Result<Solution<F>, Error> {
    let problem = Problem::new(patch, creepage, model)?;
    let Sums { fx, fy, mz, stick, area } = problem.sums(creepage);
    Ok(problem.solution(fx, fy, mz, stick, area))
}

/// Forces and their exact derivatives with respect to the creepages.
///
/// # Errors
/// Those of [`solve`]; [`Error::Overflow`] also when a derivative is too large.
pub fn solve_jacobian<F: Precision>(
    patch: &PatchView<F>,
    creepage: &Creepage<F>,
    model: Model,
) -> Result<(Solution<F>, Matrix3<F>), Error> {
    let problem = Problem::new(patch, creepage, model)?;
    let inputs = Creepage {
        longitudinal: Dual::<F, 3>::input(creepage.longitudinal, 0),
        lateral: Dual::input(creepage.lateral, 1),
        spin: Dual::input(creepage.spin, 2),
    };
    let Sums { fx, fy, mz, stick, area } = problem.sums(&inputs);
    // nalgebra counts columns first.
    let jacobian = Matrix3::from([fx.gradient, fy.gradient, mz.gradient]).transpose();
    if jacobian.iter().all(|entry| entry.is_finite_number()) {
        Ok((problem.solution(fx.value, fy.value, mz.value, stick, area), jacobian))
    } else {
        Err(Error::Overflow)
    }
}

/// Every strip of the solution, handed to `visit`, ascending in `y`. Their shares add up to the totals of
/// [`solve`].
///
/// # Errors
/// Those of [`solve`]; [`Error::NotInModel`] for [`Model::Total`].
pub fn strips<F: Precision>(
    patch: &PatchView<F>,
    creepage: &Creepage<F>,
    model: Model,
    visit: &mut impl FnMut(StripResult<F>),
) -> Result<Notice, Error> {
    let problem = Problem::with_strips(patch, creepage, model)?;
    problem.shares(creepage, &mut |strip, share: Share<F>| {
        let Share { fx, fy, mz, stick, adheres } = share;
        visit(StripResult {
            y: strip.y,
            width: strip.width,
            half_length: strip.half_length,
            // x = x_c + l (1 − 2 stick): the adhesion area as one interval at the leading edge
            separatrix: strip.centre_x + strip.half_length * (F::one() - stick.times(2.0)),
            fx,
            fy,
            mz,
            power: fx * creepage.longitudinal + fy * creepage.lateral + mz * creepage.spin,
            state: if adheres { State::Stick } else { State::Slip },
            reserved: 0,
        });
    });
    Ok(problem.notice())
}

/// The tangential field of a patch, ready to be evaluated at points.
///
/// Pressure and traction do not vary over the width of a strip: the patch is its strips. Neighbours share the
/// distance of their centre lines in the ratio of their widths.
#[derive(Clone, Copy, Debug)]
pub struct PatchField<'a, F> {
    problem: Problem<'a, F>,
    /// What the caller should know.
    pub notice: Notice,
}

/// A strip of a [`PatchField`].
#[derive(Clone, Copy, Debug)]
pub struct PatchFieldStrip<F: Real<Base = F>> {
    strip: PatchStrip<F>,
    law: Law<F>,
}

/// The traction law of a strip.
#[derive(Clone, Copy, Debug)]
enum Law<F: Real<Base = F>> {
    /// The theory of 1967, and the unit of slip.
    Theory(Strip<F>, F),
    /// The corrected strips, and the unit of slip.
    Rolling(StripLaw<F>, StripGeometry<F>, F),
}

impl<'a, F: Precision> PatchField<'a, F> {
    /// Prepare the field.
    ///
    /// # Errors
    /// Those of [`solve`].
    pub fn new(
        patch: &'a PatchView<'a, F>,
        creepage: &'a Creepage<F>,
        model: Model,
    ) -> Result<Self, Error> {
        let problem = Problem::with_strips(patch, creepage, model)?;
        Ok(Self { problem, notice: problem.notice() })
    }

    /// The strip through `y` \[m\]; `None` outside the patch and in its gaps.
    #[must_use]
    pub fn strip_at(&self, y: F) -> Option<PatchFieldStrip<F>> {
        let Problem { view, creepage, .. } = self.problem;
        let mut number = 0;
        let lobe = view.lobes().find(|lobe| {
            let inside = lobe.first().is_some_and(|first| first.y - first.width.times(0.5) <= y)
                && lobe.last().is_some_and(|last| y <= last.y + last.width.times(0.5));
            number += if inside { 0 } else { lobe.len() };
            inside
        })?;
        let mut pairs = lobe.iter().zip(lobe.iter().skip(1));
        let found = pairs.position(|(strip, next)| {
            y < strip.y + (next.y - strip.y) * (strip.width / (strip.width + next.width))
        });
        let own = found.unwrap_or(lobe.len().saturating_sub(1));
        let strip = lobe.get(own)?;
        number += own;
        let law = if self.problem.model == Model::Strip {
            let zone = view.zone(number)?;
            let rolling = self.problem.law(&zone, creepage, strip.centre_x, [F::one(), F::one()]);
            let line = StripGeometry { width: F::zero(), ..geometry(&zone, strip, F::one()) };
            Law::Rolling(rolling, line, zone.contact.slip_scale())
        } else {
            let circle = strip.circle(view.shear_modulus(), view.poisson_ratio());
            Law::Theory(self.problem.theory(strip, creepage), circle.slip_scale())
        };
        Some(PatchFieldStrip { strip: *strip, law })
    }

    /// The state at a point of the contact plane \[m\].
    #[must_use]
    pub fn at(&self, x: F, y: F) -> FieldPoint<F> {
        Self::along(self.strip_at(y).as_ref(), x)
    }

    /// The state at `x` \[m\] of a strip of [`PatchField::strip_at`].
    #[must_use]
    pub fn along(strip: Option<&PatchFieldStrip<F>>, x: F) -> FieldPoint<F> {
        let Some(PatchFieldStrip { strip, law }) = strip else {
            let zero = F::zero();
            return FieldPoint::in_units(zero, zero, zero, &StripPoint::outside());
        };
        let place = (x - strip.centre_x) / strip.half_length;
        let pressure = strip.peak_pressure;
        let traction = strip.friction * pressure;
        let (slip, point) = match law {
            Law::Theory(solved, slip) => (*slip, solved.at(place)),
            Law::Rolling(rolling, geometry, slip) => {
                (*slip, rolling_point(rolling, geometry, F::one(), place))
            }
        };
        FieldPoint::in_units(pressure, traction, slip, &point)
    }
}
