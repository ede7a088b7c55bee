//! Forces, derivatives and strips of a patch that is given by its strips.
//!
//! A strip sees the creepage at its own place, `(υx − φ y, υy + φ x_c, φ)`, and its own friction bound `μ p₀`:
//! friction that varies over `y` is nothing special. Its force acts at `(x_c, y)`.
//!
//! * Theory of 1967: [`Strip::solve`] in units of the strip. The strips do not move with the
//!   solution, so where a strip loses its adhesion area the forces have a kink, and under
//!   [`SlidingRule::RigidSlip`](crate::strip_1967::strip::SlidingRule::RigidSlip) with spin a jump as large as that strip's share.
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
use crate::patch::{PatchStrip, PatchView, QuadratureScale};
use crate::solve::model::{Model, Precision, Solution, StripResult};
use crate::solve::notice::notice;
use crate::solve::theory::sliding_rule;
use crate::status::{Error, Notice};
use crate::strip::{Carried, Law as StripLaw, Prepared, Seen, StripGeometry, eight_strips};
use crate::strip_1967::strip::{Regime, State, Strip};
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
pub(super) fn reach<F: Float>(view: &PatchView<F>) -> F {
    view.strips().iter().fold(F::zero(), |reach, strip| {
        reach.max(strip.y.abs() + strip.centre_x.abs() + strip.half_length)
    })
}

/// No point within reach has a larger rigid slip.
pub(super) fn rigid_slip<F: Float>(creepage: &Creepage<F>, reach: F) -> F {
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
pub(super) struct Problem<'a, F> {
    pub view: &'a PatchView<'a, F>,
    pub creepage: &'a Creepage<F>,
    pub model: Model,
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
    pub fn with_strips(
        view: &'a PatchView<'a, F>,
        creepage: &'a Creepage<F>,
        model: Model,
    ) -> Result<Self, Error> {
        if model == Model::Total {
            return Err(Error::NotInModel);
        }
        Self::new(view, creepage, model)
    }

    pub fn notice(&self) -> Notice {
        let of = |bound: F, Parameters { axis_ratio, psi, .. }: Parameters<F>| {
            notice(self.model, bound, axis_ratio, psi)
        };
        let told = |notice: &Notice| *notice != Notice::None;
        let first = if matches!(self.model, Model::Strip | Model::Total) {
            let mut zones = self.view.zones().map(|Zone { contact, .. }| {
                of(contact.friction_bound(), Parameters::new(&contact, self.creepage))
            });
            zones.find(told)
        } else {
            let strips = self.view.strips().iter();
            let mut strips = strips
                .map(|strip| of(strip.friction_bound(), self.parameters(strip, self.creepage)));
            strips.find(told)
        };
        first.unwrap_or(Notice::None)
    }

    /// Hands what every strip carries to `visit`.
    fn shares<T: Real<Base = F>>(
        &self,
        creepage: &Creepage<T>,
        visit: &mut dyn FnMut(&PatchStrip<F>, Share<T>),
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
    pub fn theory<T: Real<Base = F>>(
        &self,
        strip: &PatchStrip<F>,
        creepage: &Creepage<T>,
    ) -> Strip<T> {
        let rule = sliding_rule(self.model);
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
    pub fn law<T: Real<Base = F>>(
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
        visit: &mut dyn FnMut(&PatchStrip<F>, Share<T>),
    ) {
        let mut solved: Option<(Zone<F>, Totals<T>)> = None;
        for (i, strip) in self.view.strips().iter().enumerate() {
            let Some(zone) = self.view.zone(i) else { return };
            let totals = match solved {
                Some((last, totals)) if zone.is(&last) => totals,
                _ => Self::elliptic_totals(&zone, creepage),
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
        visit: &mut dyn FnMut(&PatchStrip<F>, Share<T>),
    ) {
        let QuadratureScale { area, lever } = self.view.scale();
        let mut prepared: Option<Known<F, StripLaw<T>>> = None;
        let mut before = 0;
        for lobe in self.view.lobes() {
            let (count, widths) = (lobe.len(), Widths::new(lobe));
            let alternating = widths.alternation.times(0.5);
            for (g, group) in lobe.chunks(8).enumerate() {
                let zero = T::zero();
                let none = Seen { x: zero, y: zero, spread: zero, start: zero };
                let mut seen = [(none, T::zero()); 8];
                let mut inner = [F::zero(); 8];
                let strips = group.iter().zip(&mut seen).zip(&mut inner);
                for (k, ((strip, seen), inner)) in strips.enumerate() {
                    let i = 8 * g + k;
                    let x = strip.centre_x;
                    let known = prepared.as_ref().is_some_and(|known| {
                        known.x == x && self.view.is_zone(before + i, &known.zone)
                    });
                    if !known {
                        let Some(zone) = self.view.zone(before + i) else { continue };
                        // the slopes of the linear theory, whatever the quadrature
                        let law = self.law(&zone, creepage, x, [area, lever]);
                        prepared = Some(Known { zone, x, units: Units::new(&zone), law });
                    }
                    let Some(Known { units, law, .. }) = &prepared else { continue };
                    *seen = law.strip(&units.geometry(strip, strip.width * widths.per_mean));
                    let is_inner = i.min(count - 1 - i) % 2 == 1;
                    *inner = (if is_inner { alternating } else { -alternating }).plus(0.5);
                }
                for (strip, found) in group.iter().zip(eight_strips(&seen, inner)) {
                    let stick = found.stick.value();
                    visit(strip, Share::new(strip, &found, stick, stick > F::zero()));
                }
            }
            before += count;
        }
    }
}

/// What the strips of a zone see that have one centre along `x`.
struct Known<F, L> {
    zone: Zone<F>,
    x: F,
    units: Units<F>,
    law: L,
}

/// What the strips of a zone are measured with.
pub(super) struct Units<F> {
    y: F,
    per_a: F,
    per_b: F,
    /// `1/(μ p₀)` of the zone's ellipse; zero without friction or load.
    per_bound: F,
}

impl<F: Float> Units<F> {
    pub fn new(zone: &Zone<F>) -> Self {
        let Zone { y, contact, .. } = zone;
        let bound = contact.friction * contact.peak_pressure();
        Self {
            y: *y,
            per_a: F::one() / contact.a,
            per_b: F::one() / contact.b,
            per_bound: if bound > F::zero() { F::one() / bound } else { F::zero() },
        }
    }

    /// A strip in units of the ellipse; its width over the mean of all.
    pub fn geometry(&self, strip: &PatchStrip<F>, width: F) -> StripGeometry<F> {
        // Π = (μ p₀)_strip/(μ p₀)
        let bound = strip.friction * strip.peak_pressure * self.per_bound;
        let bound = if self.per_bound > F::zero() { bound } else { F::one() };
        StripGeometry {
            y: ((strip.y - self.y) * self.per_b).clamped(-F::one(), F::one()),
            half_length: strip.half_length * self.per_a,
            // of sixteen strips, whatever their number
            width: width.times(0.125),
            bound: bound.max(F::of(LEAST_BOUND)),
        }
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
