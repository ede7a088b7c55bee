//! Forces, derivatives and strips of a patch that is given by its strips.
//!
//! A strip has the creepage of its own place, `(υx − φ y, υy + φ x_c, φ)`, and its own friction
//! bound `μ p₀`, so that friction may vary with `y`. The force of a strip acts at `(x_c, y)`.
//!
//! * Theory of 1967: [`Strip::solve`] in units of the strip. The strips do not move with the
//!   solution. The forces have a kink where a strip loses its adhesion area, and under
//!   [`SlidingRule::RigidSlip`](crate::strip_1967::strip::SlidingRule::RigidSlip) with spin a jump
//!   as large as that strip's share.
//! * [`Model::Strip`]: the ellipse of a strip's [zone](super::zones) is solved at the creepage of
//!   its own centre, and gives the strip the creepages of its `Y` and `Π = (μ p₀)_strip/(μ p₀)`. A
//!   strip whose centre is moved by `x_c` is solved with the lateral creepage there.
//! * [`Model::Total`]: a strip carries a share of the forces that the ellipse of its zone has at
//!   the creepage of the strip's centre, in proportion to its friction bound. This is cheap and
//!   smooth, and gives neither strips nor fields.
//!
//! [`Model::Linear`] holds for ellipses only. The linear theory of a patch is the derivative of
//! [`Model::Strip`] at zero creepage.

use crate::contact::Contact;
use crate::contact::creepage::{Creepage, Parameters, normalised};
use crate::contact::plausibility::LARGEST_MISMATCH;
use crate::contact::totals::{StripForces, Totals};
use crate::forces::theory::sliding_rule;
use crate::forces::warning::model_warning;
use crate::forces::{Model, Solution, StripResult};
use crate::layer::Interface;
use crate::linear::LinearCoefficients;
use crate::number::{Float, Number, are_finite};
use crate::patch::shares::{creepage_of_zone, strip_shares};
use crate::patch::slip::{PatchSlip, Share, ZoneSplit, creepage_at, creepage_of_strip};
use crate::patch::zones::Zone;
use crate::patch::{PatchStrip, PatchView};
use crate::status::{Error, Warning};
use crate::strip_1967::strip::{Regime, State, Strip};
use crate::total;

/// Forces of a zone's ellipse, the creepage that pressure adds, and the creepages of bristles.
type ZoneTotals<T> = (Totals<T>, T, Option<ZoneSplit<T>>);

/// A patch, a creepage and a model that fit together.
#[derive(Clone, Copy, Debug)]
pub(super) struct Problem<'a, F> {
    pub view: &'a PatchView<'a, F>,
    pub creepage: &'a Creepage<F>,
    pub model: Model,
    /// The layer between the bodies, if there is one.
    pub behind: Option<Interface<F>>,
}

impl<'a, F: Float> Problem<'a, F> {
    pub(super) fn new(
        view: &'a PatchView<'a, F>, creepage: &'a Creepage<F>, model: Model,
    ) -> Result<Self, Error> {
        creepage.check()?;
        let has_strips = model != Model::Linear && (model != Model::Total || view.own.is_empty());
        Error::NotInModel.unless(has_strips)?;
        let problem = Self { view, creepage, model, behind: None };
        let (slip, bound) = (problem.largest_rigid_slip(), view.friction_bound());
        Error::Overflow.unless(are_finite(&[slip, bound * view.sizes.reach, bound * slip]))?;
        Ok(problem)
    }

    /// Upper bound of the rigid slip.
    pub fn largest_rigid_slip(&self) -> F {
        let Self { view, creepage, .. } = *self;
        let [own, _] = view.most_own();
        let slip = creepage.fastest_within(view.sizes.reach) + own;
        if view.mismatch() == F::zero() {
            return slip;
        }
        // and the creepage that pressure adds
        slip + view.zones().fold(F::zero(), |most, zone| most.max(zone.contact.strain().abs()))
    }

    /// The warning of the patch from that of its ellipses or, in the theories of 1967, its strips.
    fn warning(&self, of_parts: Warning) -> Warning {
        if self.model.is_of_1967() && self.view.mismatch() != F::zero() {
            return Warning::MismatchNeglected;
        }
        let is_far = self.view.mismatch().abs() > F::constant(LARGEST_MISMATCH);
        if is_far { Warning::Mismatch } else { of_parts }
    }

    /// Passes the forces of every strip to `visit`. Returns the warning of the patch.
    pub(super) fn shares<T: Number<Base = F>>(
        &self, slip: &PatchSlip<T>, visit: &mut dyn FnMut(&PatchStrip<F>, Share<T>),
    ) -> Warning {
        // with the largest spin of any strip
        let [_, own] = self.view.most_own();
        let spin = self.creepage.spin.abs() + own;
        let fastest = Creepage { spin, ..*self.creepage };
        let warning_of = |bound: F, parameters: Parameters<F>| {
            let Parameters { axis_ratio, psi, .. } = parameters;
            model_warning(self.model, bound, axis_ratio, psi)
        };
        let of_ellipse = |contact: &Contact<F>| {
            warning_of(contact.friction_bound(), Parameters::new(contact, &fastest))
        };
        let mut warning = Warning::None;
        if Model::HAS_STRIP && self.model == Model::Strip {
            warning = strip_shares(self.view, slip, &of_ellipse, visit);
        } else if Model::HAS_TOTAL && self.model == Model::Total {
            warning = self.elliptic_shares(slip, &of_ellipse, visit);
        } else if Model::HAS_STRIP_1967 {
            for (i, strip) in self.view.strips().iter().enumerate() {
                let parameters = self.parameters(strip, &fastest);
                warning = warning.worse(warning_of(strip.friction_bound(), parameters));
                let of_strip = self.view.own(i);
                let creepage = creepage_of_strip(&slip.creepage, strip, of_strip.as_ref());
                let own = slip.behind.and_then(|behind| Some((behind, self.view.zone(i)?)));
                let share = match own {
                    None => self.theory_share(strip, &creepage),
                    Some((behind, zone)) => {
                        let (split, seen) = ZoneSplit::of_zone(&zone, &creepage, &behind);
                        let creepage = split.half_spaces_at_origin(&seen);
                        split.mean(strip, self.theory_share(strip, &creepage))
                    }
                };
                visit(strip, share.on(strip, T::zero(), of_strip.as_ref()));
            }
        }
        self.warning(warning)
    }

    /// Kalker's parameters in units of a strip.
    fn parameters<T: Number<Base = F>>(
        &self, strip: &PatchStrip<F>, creepage: &Creepage<T>,
    ) -> Parameters<T> {
        let circle = strip.circle(self.view.shear_modulus(), self.view.poisson_ratio());
        Parameters::new(&circle, &creepage_at(creepage, strip.centre_x, strip.y))
    }

    /// A strip in the theory of 1967, its half length one.
    pub fn theory<T: Number<Base = F>>(
        &self, strip: &PatchStrip<F>, creepage: &Creepage<T>,
    ) -> Strip<T> {
        let rule = sliding_rule(self.model);
        let Parameters { xi, eta, psi, poisson_ratio, .. } = self.parameters(strip, creepage);
        Strip::solve(T::one(), xi, eta, psi, poisson_ratio, rule)
    }

    #[inline(never)]
    fn theory_share<T: Number<Base = F>>(
        &self, strip: &PatchStrip<F>, creepage: &Creepage<T>,
    ) -> Share<T> {
        let solved = self.theory(strip, creepage);
        let (fx, fy) = solved.force();
        let carried = StripForces { fx, fy, mx: solved.moment(), stick: T::zero() };
        let stick = match solved.regime {
            Regime::Adhesion { kappa, .. } => F::one() - kappa.value(),
            Regime::Sliding { .. } => F::zero(),
        };
        Share::new(strip, &carried, stick, solved.adheres())
    }

    /// Every strip's share of the forces of the ellipse of its zone.
    #[inline(never)]
    fn elliptic_shares<T: Number<Base = F>>(
        &self, slip: &PatchSlip<T>, warning_of: &dyn Fn(&Contact<F>) -> Warning,
        visit: &mut dyn FnMut(&PatchStrip<F>, Share<T>),
    ) -> Warning {
        let mut warning = Warning::None;
        let mut solved: Option<(Zone<F>, ZoneTotals<T>)> = None;
        let all = self.view.lobes_and_zones().flat_map(|(first, lobe, of_lobe)| {
            lobe.iter().zip(first..).map(move |(strip, i)| (strip, i, of_lobe))
        });
        for (strip, i, of_lobe) in all {
            let Some(zone) = of_lobe.or_else(|| self.view.zone(i)) else { return warning };
            let found = match solved {
                Some((last, found)) if zone.nearly_equals(&last) => found,
                _ => {
                    warning = warning.worse(warning_of(&zone.contact));
                    Self::elliptic_totals(&zone, slip)
                }
            };
            solved = Some((zone, found));
            let (totals, shift, split) = found;
            let bound = strip.friction_bound();
            let (fx, fy) = (totals.fx.scale(bound), totals.fy.scale(bound));
            let size = (zone.contact.a * zone.contact.b).sqrt();
            // Mz = ∫ (x Y − y X)
            let mz = totals.mz.scale(bound * size) + fy.scale(zone.x) - fx.scale(zone.y);
            let share = Share { fx, fy, mz, besides: T::zero(), stick: -F::one(), adheres: false };
            let share = split.map_or(share, |split| split.mean(strip, share));
            visit(strip, Share { adheres: false, ..share.on(strip, shift, None) });
        }
        warning
    }

    fn elliptic_totals<T: Number<Base = F>>(zone: &Zone<F>, slip: &PatchSlip<T>) -> ZoneTotals<T> {
        let Contact { a, b, poisson_ratio, .. } = zone.contact;
        let linear = LinearCoefficients::at(a / b, poisson_ratio);
        let (seen, shift) = creepage_of_zone(zone, &linear, slip, &slip.creepage, zone.x);
        let split = slip.behind.map(|behind| ZoneSplit::new(zone, &linear, &seen, zone.x, &behind));
        let seen = split.map_or(seen, |split| split.half_spaces(&seen));
        let total = total::Total::new(a / b, poisson_ratio, &linear);
        (total.mean_totals(normalised(&zone.contact, &seen)), shift, split)
    }
}

impl<F: Float> Problem<'_, F> {
    /// Passes every strip to `visit`; see [`patch_strips`].
    pub fn strips(&self, visit: &mut impl FnMut(StripResult<F>)) -> Warning {
        let Self { creepage, behind, .. } = *self;
        self.shares(&PatchSlip::new(creepage, behind), &mut |strip, share: Share<F>| {
            let Share { fx, fy, mz, besides, stick, adheres } = share;
            visit(StripResult {
                y: strip.y,
                width: strip.width,
                half_length: strip.half_length,
                // x = x_c + l (1 − 2 stick): the adhesion area as one interval at the leading edge
                separatrix: strip.centre_x + strip.half_length * (F::one() - stick.times(2.0)),
                fx,
                fy,
                mz,
                power: creepage.power([fx, fy, mz]) + besides,
                state: if adheres { State::Stick } else { State::Slip },
                reserved: 0,
            });
        })
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
/// use kstrip::contact::{Contact, creepage::Creepage, totals::StripCount};
/// use kstrip::forces::Model;
/// use kstrip::{patch::Patch, patch::solver::solve_patch};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, friction: 0.3,
///     shear_modulus: 82e9, poisson_ratio: 0.28, mismatch: 0.0,
/// };
/// let mut patch = Patch::from_ellipse(&contact, StripCount::Sixteen)?;
/// let creepage = Creepage { longitudinal: 3e-3, lateral: 0.0, spin: 0.0 };
/// let dry = solve_patch(&patch.view()?, &creepage, Model::Strip)?;
/// for strip in patch.used_mut().iter_mut().filter(|strip| strip.y > 1.3e-3) {
///     strip.friction = 0.05;
/// }
/// let greasy = solve_patch(&patch.view()?, &creepage, Model::Strip)?;
/// assert!(greasy.fx < dry.fx && greasy.mz > 0.0);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn solve_patch<F: Float>(
    patch: &PatchView<F>, creepage: &Creepage<F>, model: Model,
) -> Result<Solution<F>, Error> {
    Ok(Problem::new(patch, creepage, model)?.solution())
}

/// Passes every strip of the solution to `visit`, ascending in `y`. Their shares add up to the
/// totals of [`solve_patch`].
///
/// # Errors
/// Those of [`solve_patch`]; [`Error::NotInModel`] for [`Model::Total`].
pub fn patch_strips<F: Float>(
    patch: &PatchView<F>, creepage: &Creepage<F>, model: Model,
    visit: &mut impl FnMut(StripResult<F>),
) -> Result<Warning, Error> {
    Error::NotInModel.unless(model != Model::Total)?;
    Ok(Problem::new(patch, creepage, model)?.strips(visit))
}
