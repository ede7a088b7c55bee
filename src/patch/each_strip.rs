//! Forces of each strip of a patch at its own centre, with derivatives.

use crate::contact::creepage::Creepage;
use crate::forces::Model;
use crate::forces::derivatives::scaled;
use crate::friction::SlipFriction;
use crate::number::{Arithmetic, Dual, Float};
use crate::patch::PatchView;
use crate::patch::friction::{FrictionProblem, Scaled};
pub(crate) use crate::patch::slip::{By, creepage_at};
use crate::patch::slip::{PatchSlip, Share};
use crate::status::{Error, Warning};

/// Forces `fx, fy, mz` of one strip at its own centre, and its power divided by rolling speed, with
/// derivatives while the share `λ` stays.
pub(crate) type AtStrip<F> = ([Dual<F, 3>; 3], Dual<F, 3>);

/// Friction and warning of a solution whose strips were visited.
pub(crate) struct Visited<F: Float> {
    /// `λ`
    pub share: F,
    /// `Σ μ₀ N`
    pub bound: F,
    /// The law without its coefficient, and whether friction falls.
    pub law: SlipFriction<F>,
    pub falls: bool,
    pub warning: Warning,
}

/// Passes the forces of every strip to `visit`, with derivatives if there are `SLOPES`.
pub(crate) fn each_strip<F: Float, const SLOPES: bool>(
    patch: &PatchView<F>, creepage: &Creepage<F>, law: Option<&SlipFriction<F>>,
    (model, by): (Model, Option<By>), visit: &mut dyn FnMut(usize, &AtStrip<F>),
) -> Result<Visited<F>, Error> {
    let problem = FrictionProblem::new(patch, creepage, law, model)?;
    let (share, warning) = problem.agreement()?;
    let at_share = problem.scaled(share)?;
    let (solver, Scaled { creepage, behind, factor, .. }) = (at_share.problem()?, &at_share);
    // F = λ f(k c/λ), P = λ²/k p(k c/λ)
    let power_unit = share / *factor;
    let (unit, power_slope_unit) = match by {
        Some(By::Mismatch) => (share, power_unit),
        _ => (share * *factor, share),
    };
    let mut number = 0;
    let mut take = |(forces, power): AtStrip<F>| {
        let under = |of: Dual<F, 3>, unit: F, slope_unit: F| Dual {
            value: of.value * unit,
            gradient: scaled(of.gradient, slope_unit),
        };
        let forces = forces.map(|force| under(force, share, unit));
        visit(number, &(forces, under(power, power_unit, power_slope_unit)));
        number += 1;
    };
    let found = if let Some(by) = by.filter(|_| SLOPES) {
        let slip = PatchSlip::with_slopes(creepage, *behind, by);
        solver.shares(&slip, &mut |strip, share: Share<Dual<F, 3>>| {
            let (moment, power) = (share.about_centre(strip), share.power(&slip.creepage));
            // from the creepage at the origin to that at the centre
            let at_centre = |mut of: Dual<F, 3>| {
                if let By::Creepages = by {
                    let [x, y, spin] = &mut of.gradient;
                    *spin = *spin + *x * strip.y - *y * strip.centre_x;
                }
                of
            };
            take(([share.fx, share.fy, moment].map(at_centre), at_centre(power)));
        })
    } else {
        let slip = PatchSlip::new(creepage, *behind);
        solver.shares(&slip, &mut |strip, share: Share<F>| {
            let power = share.power(creepage);
            let forces = [share.fx, share.fy, share.about_centre(strip)];
            take((forces.map(Dual::from_base), Dual::from_base(power)));
        })
    };
    let (bound, law, falls) = (problem.bound, problem.law, problem.law.falls());
    let warning = problem.warning(found, warning);
    Ok(Visited { share, bound, law, falls, warning })
}
