//! Each strip of a contact with a layer between its bodies.

use crate::contact::Contact;
use crate::contact::totals::Totals;
use crate::forces::theory::ScaledContact;
use crate::forces::warning::warning_of;
use crate::forces::{self, StripResult};
use crate::friction::layered::{Behind, ThroughLayer};
use crate::layer::Layer;
use crate::number::{Float, add};
use crate::status::{Error, Warning};
use crate::strip_1967::strip::State;

impl<F: Float> ThroughLayer<'_, F> {
    /// Every strip of the solution of a contact, handed to `visit`: the mean of a strip of
    /// half-spaces and of its bristles. Their shares add up to the forces of
    /// [`solve`](Self::solve).
    pub fn strips(
        &self, contact: &Contact<F>, visit: &mut dyn FnMut(StripResult<F>),
    ) -> Result<Warning, Error> {
        if forces::strips_of(contact, self.creepage, self.options)? == 0 {
            return Ok(Warning::None);
        }
        let behind = &self.behind(contact);
        let Behind { layer, split, whole, has_bristles } = behind;
        let creepage = behind.half_spaces();
        let frame = &ScaledContact::new(contact);
        let like = Contact { mismatch: F::zero(), ..*contact };
        // bristles of a strip divided by μ N, and the share of the load
        let bristles = |strip: &StripResult<F>| {
            let (y, width) = (strip.y / contact.b, strip.width / contact.b);
            let load = width * (F::one() - y * y - (width * width).times(1.0 / 12.0)).times(0.75);
            (layer.strip(split.rates, y, strip.half_length / contact.a), load)
        };
        // what the quadratures differ by is shared out by load
        let (mut rest, mut loads) = ([F::zero(); 3], F::zero());
        if *has_bristles {
            let Totals { fx, fy, mz, .. } = layer.bristles(split.rates);
            rest = [fx, fy, mz];
            forces::strips(&like, &creepage, self.options, &mut |strip| {
                let ([fx, fy, mz, _], load) = bristles(&strip);
                add(&mut rest, [-(fx * load), -(fy * load), -(mz * load)]);
                loads += load;
            })?;
        }
        let rest = rest.map(|rest| rest / (loads + F::TINY));
        let bound = contact.friction_bound();
        let warning = forces::strips(&like, &creepage, self.options, &mut |strip| {
            let mut mean = strip;
            if *has_bristles {
                let ([fx, fy, mz, stick], load) = bristles(&strip);
                let of = |half_spaces: F, bristles: F, rest: F, unit: F| {
                    half_spaces + ((bristles + rest) * (load * unit) - half_spaces) * split.weight
                };
                mean.fx = of(strip.fx, fx, rest[0], bound);
                mean.fy = of(strip.fy, fy, rest[1], bound);
                mean.mz = of(strip.mz, mz, rest[2], bound * frame.radius);
                let separatrix = strip.half_length * (F::one() - stick.times(2.0));
                mean.separatrix += (separatrix - strip.separatrix) * split.weight;
                mean.state = if stick > F::zero() { State::Stick } else { strip.state };
            }
            mean.power = whole.power([mean.fx, mean.fy, mean.mz]);
            visit(mean);
        })?;
        let psi = frame.units.parameters(whole).psi;
        Ok(warning.worse(warning_of(contact, whole, self.options.model, psi)))
    }

    /// What lies between the bodies of a contact that carries.
    pub fn behind(&self, contact: &Contact<F>) -> Behind<F> {
        let frame = &ScaledContact::new(contact);
        let (whole, _) = frame.creepage_with_pressure(self.creepage, self.options.model);
        let parameters = frame.units.parameters(&whole);
        let (ratio, _, linear) = frame.shape();
        let layer = Layer::new(ratio, &linear);
        let interface = self.interface(contact);
        let split = layer.split(frame.units.normalised(&parameters), &interface);
        Behind { layer, split, whole, has_bristles: interface.layer > F::zero() }
    }
}
