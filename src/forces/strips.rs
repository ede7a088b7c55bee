//! The forces of each strip of a solution.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::contact::totals::{StripCount, Totals};
use crate::forces::check::check;
use crate::forces::options::{Model, Options};
use crate::forces::theory::{ScaledContact, Theory, sliding_rule};
use crate::forces::warning::warning_of;
use crate::number::Float;
use crate::status::{Error, Warning};
use crate::strip::{EllipseStrips, Rule};
use crate::strip_1967::strip::State;
use crate::strip_1967::{self, strips::PlacedStrip};

/// One strip y = const of a contact or a patch, and the forces that it carries on the lower body.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripResult<F> {
    /// Centre line \[m\].
    pub y: F,
    /// Width of the strip \[m\].
    pub width: F,
    /// Half of its length along x \[m\].
    pub half_length: F,
    /// x of the separatrix \[m\], with slip behind it and adhesion ahead of it; the leading edge if
    /// the whole strip slides.
    pub separatrix: F,
    /// Its share of the longitudinal force \[N\].
    pub fx: F,
    /// Its share of the lateral force \[N\].
    pub fy: F,
    /// Its share of the moment about the centre of the contact \[N m\].
    pub mz: F,
    /// Its share of the frictional power \[N\].
    pub power: F,
    /// KSTRIP_STATE_STICK if it has an adhesion area, else KSTRIP_STATE_SLIP.
    pub state: State,
    /// Reserved: zero.
    pub reserved: i32,
}

/// Number of strips that [`strips`] passes to its caller, without solving.
///
/// # Errors
/// Those of [`strips`].
pub fn strips_of<F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, options: &Options,
) -> Result<usize, Error> {
    Error::NotInModel.when(matches!(options.model, Model::Total | Model::Linear))?;
    check(contact, creepage, options)?;
    Ok(if contact.is_lost() { 0 } else { options.strips as usize })
}

/// Passes every strip of the solution to `visit`. Their shares add up to the totals of
/// [`solve`](crate::forces::forces_of_contact).
///
/// # Errors
/// Those of [`solve`](crate::forces::forces_of_contact).
pub fn strips<F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, options: &Options,
    visit: &mut dyn FnMut(StripResult<F>),
) -> Result<Warning, Error> {
    if strips_of(contact, creepage, options)? == 0 {
        return Ok(Warning::None);
    }
    let frame = ScaledContact::new(contact);
    let (creepage, _) = &frame.creepage_with_pressure(creepage, options.model);
    let parameters = frame.units.parameters(creepage);
    let bound = contact.friction_bound();
    let mut share = |strip: PlacedStrip<F>| {
        let (fx, fy) = (bound * strip.fx, bound * strip.fy);
        let mz = bound * frame.radius * strip.mz;
        visit(StripResult {
            y: contact.b * strip.y,
            width: contact.b * strip.width,
            half_length: contact.a * strip.half_length,
            separatrix: contact.a * (strip.kappa + strip.kappa - strip.half_length),
            fx,
            fy,
            mz,
            power: creepage.power([fx, fy, mz]),
            state: if strip.adheres { State::Stick } else { State::Slip },
            reserved: 0,
        });
    };
    if Model::HAS_STRIP && options.model == Model::Strip {
        let creepage = frame.units.normalised(&parameters);
        let strips = EllipseStrips::of_contact(&frame, options);
        place_strips(&strips, creepage, options.strips, &mut share);
    } else if Model::HAS_STRIP_1967 {
        let rule = sliding_rule(options.model);
        strip_1967::strips::visit_strips(&parameters, rule, options.strips, &mut share);
    }
    Ok(warning_of(contact, creepage, options.model, parameters.psi))
}

/// The strips of STRIP, in the same form as those of the theory of 1967.
#[inline(never)]
fn place_strips<F: Float>(
    strips: &EllipseStrips<F>, creepage: [F; 3], count: StripCount,
    visit: &mut dyn FnMut(PlacedStrip<F>),
) {
    let rule = Rule::<F>::new(count);
    let mut places = rule.places();
    strips.each_strip(creepage, &mut |carried| {
        let Some([y, c, width]) = places.next() else { return };
        let Totals { fx, fy, mz, stick } = carried;
        visit(PlacedStrip {
            y,
            half_length: c,
            width,
            // The adhesion length as one interval at the leading edge
            kappa: c * (F::one() - stick),
            adheres: stick > F::zero(),
            fx,
            fy,
            mz,
        });
    });
}
