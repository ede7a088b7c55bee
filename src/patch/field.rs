//! The tangential field of a patch that is given by its strips.

use crate::contact::creepage::Creepage;
use crate::forces::Model;
use crate::forces::field::{FieldPoint, FieldStrip};
use crate::friction::SlipFriction;
use crate::friction::field::StripBehind;
use crate::layer::Interface;
use crate::number::{Float, pairs};
use crate::patch::friction::{FrictionProblem, Scaled};
use crate::patch::shares::{ZoneCreepages, ZoneModel};
use crate::patch::slip::{PatchSlip, ZoneSplit, creepage_of_strip};
use crate::patch::solver::Problem;
use crate::patch::{PatchStrip, PatchView};
use crate::status::{Error, Warning};
use crate::strip_1967::strip::StripPoint;

/// The tangential field of a patch, ready to be evaluated at points.
///
/// Pressure and traction do not vary over the width of a strip. The border between two neighbours
/// divides the distance of their centre lines in the ratio of their widths.
#[derive(Clone, Copy, Debug)]
pub struct PatchField<'a, F> {
    /// The patch and the creepage whose tractions times the share `λ` are those under the law.
    view: PatchView<'a, F>,
    creepage: Creepage<F>,
    model: Model,
    behind: Option<Interface<F>>,
    units: LawUnits<F>,
    /// The warning of the solution, if there is one.
    pub warning: Warning,
}

/// A strip of a [`PatchField`].
#[derive(Clone, Copy, Debug)]
pub struct PatchFieldStrip<F: Float> {
    strip: PatchStrip<F>,
    /// In half lengths, and the unit of its slip.
    law: FieldStrip<F>,
    slip: F,
    behind: Option<StripBehind<F>>,
    units: LawUnits<F>,
}

/// Tractions and slip of the patch divided by those of the scaled creepage: `λ`, `λ/k`.
#[derive(Clone, Copy, Debug)]
struct LawUnits<F> {
    traction: F,
    slip: F,
}

impl<'a, F: Float> PatchField<'a, F> {
    /// Prepare the field, under friction that is constant or falls with the slip.
    ///
    /// # Errors
    /// Those of [`solve_patch_with_law`](super::friction::solve_patch_with_law);
    /// [`Error::NotInModel`] also for [`Model::Total`]; [`Error::Overflow`] also when the
    /// dissipation of a point does not fit the floating-point type.
    pub fn new(
        patch: &'a PatchView<'a, F>, creepage: &'a Creepage<F>, law: Option<&SlipFriction<F>>,
        model: Model,
    ) -> Result<Self, Error> {
        Error::NotInModel.unless(model != Model::Total)?;
        Problem::new(patch, creepage, model)?;
        // Dissipation is traction times slip, which is of the size of the rigid slip.
        let tractions = patch.strips().iter().map(|strip| strip.friction * strip.peak_pressure);
        let slip = creepage.fastest_within(patch.sizes.reach).times(8.0);
        Error::Overflow.unless((tractions.fold(F::zero(), F::max) * slip).is_finite_number())?;
        let problem = FrictionProblem::new(patch, creepage, law, model)?;
        let (share, of_friction) = problem.agreement()?;
        let scaled = problem.scaled(share)?;
        let warning = problem.warning(scaled.problem()?.solution().warning, of_friction);
        let Scaled { patch: view, creepage, factor, behind, .. } = scaled;
        let units = LawUnits { traction: share, slip: F::one() / factor };
        Ok(Self { view, creepage, model, behind, units, warning })
    }

    /// The strip through `y` \[m\]; `None` outside the patch and in its gaps.
    #[must_use]
    pub fn strip_at(&self, y: F) -> Option<PatchFieldStrip<F>> {
        let Self { view, creepage, model, behind, units, .. } = self;
        let mut number = 0;
        let lobe = view.lobes().find(|lobe| {
            let inside = lobe.first().is_some_and(|first| first.y - first.width.times(0.5) <= y)
                && lobe.last().is_some_and(|last| y <= last.y + last.width.times(0.5));
            number += if inside { 0 } else { lobe.len() };
            inside
        })?;
        let mut pairs = pairs(lobe);
        let found = pairs.position(|(strip, next)| {
            y < strip.y + (next.y - strip.y) * (strip.width / (strip.width + next.width))
        });
        let own = found.unwrap_or(lobe.len().saturating_sub(1));
        let strip = lobe.get(own)?;
        number += own;
        let creepage = creepage_of_strip(creepage, strip, view.own(number).as_ref());
        let mut of_layer = None;
        let (law, slip) = if Model::HAS_STRIP && *model == Model::Strip {
            let zone = view.zone(number)?;
            let factors = [F::one(), F::one()];
            let (slip, law) = (PatchSlip::new(&creepage, *behind), ZoneModel::new(&zone, factors));
            let ZoneCreepages { distribution: rolling, split, whole, .. } =
                law.creepages(&slip, &creepage, strip.centre_x);
            of_layer = split.map(|split| split.of_field(strip, &whole));
            let line = law.units.geometry(strip, F::zero());
            (FieldStrip::Strip(rolling, line, F::one()), zone.contact.slip_scale())
        } else if Model::HAS_STRIP_1967 {
            let circle = strip.circle(view.shear_modulus(), view.poisson_ratio());
            let problem = Problem { view, creepage: &creepage, model: *model, behind: *behind };
            let own = behind.as_ref().and_then(|behind| Some((behind, view.zone(number)?)));
            let mut at_origin = creepage;
            if let Some((behind, zone)) = own {
                let (split, seen) = ZoneSplit::of_zone(&zone, &creepage, behind);
                at_origin = split.half_spaces_at_origin(&seen);
                of_layer = Some(split.of_field(strip, &seen));
            }
            (FieldStrip::Strip1967(problem.theory(strip, &at_origin)), circle.slip_scale())
        } else {
            return None;
        };
        Some(PatchFieldStrip { strip: *strip, law, slip, behind: of_layer, units: *units })
    }

    /// The state at a point of the contact plane \[m\].
    #[must_use]
    pub fn at(&self, x: F, y: F) -> FieldPoint<F> {
        Self::along(self.strip_at(y).as_ref(), x)
    }

    /// The state at `x` \[m\] of a strip of [`PatchField::strip_at`].
    #[must_use]
    pub fn along(strip: Option<&PatchFieldStrip<F>>, x: F) -> FieldPoint<F> {
        let Some(PatchFieldStrip { strip, law, slip, behind, units }) = strip else {
            let zero = F::zero();
            return FieldPoint::in_units(zero, zero, zero, &StripPoint::outside());
        };
        let place = (x - strip.centre_x) / strip.half_length;
        let pressure = strip.peak_pressure;
        let traction = strip.friction * pressure;
        let point = law.at(place);
        let mean = |behind: &StripBehind<F>| behind.mean(&point, place, [F::one(), *slip]);
        let point = behind.as_ref().map_or(point, mean);
        FieldPoint::in_units(pressure, traction * units.traction, *slip * units.slip, &point)
    }
}
