//! Forces of a patch as sums over its strips, with their derivatives.

use crate::contact::creepage::Creepage;
use crate::forces::derivatives::{Derivatives, Sensitivity, Slopes};
use crate::forces::{Model, Solution};
use crate::friction::derivatives::OwnSensitivities;
use crate::friction::layered::{InterfaceSlopes, WithSlopes};
use crate::layer::Interface;
use crate::number::{Arithmetic, Dual, Float, Number, add};
use crate::patch::PatchStrip;
use crate::patch::slip::{By, PatchSlip, Share, creepage_at};
use crate::patch::solver::Problem;
use crate::status::{Error, Warning};

/// Sums over the strips.
struct PatchSums<T: Number> {
    /// `fx, fy, mz`
    forces: [T; 3],
    /// Power divided by rolling speed.
    power: T,
    /// Share of the area in adhesion; -1 for a model without strips.
    adhesion: T::Base,
    warning: Warning,
}

impl<F: Float> PatchSums<F> {
    fn solution(&self) -> Solution<F> {
        let Self { forces: [fx, fy, mz], power, adhesion, warning } = *self;
        Solution { fx, fy, mz, power, adhesion, warning, reserved: 0 }
    }
}

impl<F: Float> PatchSums<Dual<F, 3>> {
    /// Derivatives in a direction.
    fn sensitivity(&self, direction: usize) -> Sensitivity<F> {
        let forces = self.forces.map(|sum| sum.derivative(direction));
        Sensitivity { forces, power: self.power.derivative(direction) }
    }
}

impl<F: Float> Problem<'_, F> {
    /// Forces; see [`solve_patch`](super::solver::solve_patch).
    pub fn solution(&self) -> Solution<F> {
        self.sums(&PatchSlip::new(self.creepage, self.behind), |_, _| ()).solution()
    }

    /// The sums, while every share is passed to `visit`.
    fn sums<T: Number<Base = F>>(
        &self, slip: &PatchSlip<T>, mut visit: impl FnMut(&PatchStrip<F>, &Share<T>),
    ) -> PatchSums<T> {
        let (mut forces, mut besides) = ([T::zero(); 3], T::zero());
        let (mut stick, mut whole) = (F::zero(), F::zero());
        let warning = self.shares(slip, &mut |strip, share| {
            visit(strip, &share);
            besides += share.besides;
            add(&mut forces, [share.fx, share.fy, share.mz]);
            let area = strip.half_length * strip.width;
            stick += area * share.stick;
            whole += area;
        });
        let Creepage { longitudinal, lateral, spin } = slip.creepage;
        let [fx, fy, mz] = forces;
        let power = besides + (fx * longitudinal + fy * lateral + mz * spin);
        let adhesion = if self.model == Model::Total {
            -F::one()
        } else if whole > F::zero() {
            (stick / whole).clamped(F::zero(), F::one())
        } else {
            F::zero()
        };
        PatchSums { forces, power, adhesion, warning }
    }

    /// Forces with the derivatives with respect to the creepages, all others zero; and those with
    /// respect to the layer, and to a factor of the strips' own creepages.
    pub fn with_slopes(&self) -> Result<(WithSlopes<F>, OwnSensitivities<F>), Error> {
        let Self { view: patch, creepage, model, behind } = *self;
        let sums = |by: By| self.sums(&PatchSlip::with_slopes(creepage, behind, by), |_, _| ());
        let inputs = PatchSlip::with_slopes(creepage, behind, By::Creepages);
        let ([mut all, mut translation], mut number) = <(OwnSensitivities<F>, usize)>::default();
        let found = self.sums(&inputs, |strip, share| {
            let Some(own) = patch.own(number) else { return };
            number += 1;
            let Creepage { longitudinal, lateral, .. } =
                creepage_at(&own, -strip.centre_x, -strip.y);
            let moved =
                |of: Dual<F, 3>| of.derivative(0) * longitudinal + of.derivative(1) * lateral;
            let power = share.power(&inputs.creepage);
            let turned = |of: Dual<F, 3>| moved(of) + of.derivative(2) * own.spin;
            let forces = [share.fx, share.fy, share.mz];
            add(&mut all.forces, forces.map(turned));
            add(&mut translation.forces, forces.map(moved));
            all.power += turned(power);
            translation.power += moved(power);
        });
        let PatchSums { forces, power, adhesion, warning } = found;
        let jacobian = forces.map(|sum| sum.gradient);
        let mut slopes = Slopes {
            derivatives: Derivatives { jacobian, ..Derivatives::default() },
            seen: *creepage,
            power_by_creepage: power.gradient,
            by_mismatch: Sensitivity::default(),
        };
        if patch.mismatch() != F::zero() && !model.is_of_1967() {
            slopes.by_mismatch = sums(By::Mismatch).sensitivity(0);
        }
        let mut interface = InterfaceSlopes::default();
        if let Some(Interface { layer, .. }) = behind {
            let (found, unit) = (sums(By::Layer), patch.shear_modulus());
            let (by_layer, by_slide) =
                (found.sensitivity(0).scaled(unit, unit), found.sensitivity(1));
            interface = InterfaceSlopes { layer: layer / unit, by_layer, by_slide };
        }
        let InterfaceSlopes { by_layer, by_slide, .. } = &interface;
        let others = [&slopes.by_mismatch, by_layer, by_slide].map(|by| &by.forces);
        let mut entries = jacobian.iter().chain(others).flatten();
        Error::Overflow.unless(entries.all(|entry| entry.is_finite_number()))?;
        let (forces, power) = (forces.map(Dual::value), power.value);
        let values = PatchSums { forces, power, adhesion, warning };
        Ok(((values.solution(), slopes, interface), [all, translation]))
    }
}
