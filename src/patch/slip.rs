//! The motion of a patch, and the forces of a strip.

use crate::contact::Contact;
use crate::contact::creepage::{Creepage, normalised};
use crate::contact::totals::StripForces;
use crate::friction::field::StripBehind;
use crate::layer::bristles::Rates;
use crate::layer::{Interface, Layer, Split};
use crate::linear::LinearCoefficients;
use crate::number::{Arithmetic, Dual, Float, Number, scaled_down};
use crate::patch::PatchStrip;
use crate::patch::zones::Zone;

/// Forces of a strip.
#[derive(Clone, Copy, Debug)]
pub(super) struct Share<T: Number> {
    pub fx: T,
    pub fy: T,
    /// Moment about the origin of the patch.
    pub mz: T,
    /// Power of the force on creepages besides the patch's: what pressure adds, the strip's own.
    pub besides: T,
    /// Share of its length in adhesion, at the leading edge.
    pub stick: T::Base,
    pub adheres: bool,
}

impl<T: Number<Base: Float>> Share<T> {
    /// From forces divided by the friction bound, and the moment about the centre in half lengths.
    pub fn new(
        strip: &PatchStrip<T::Base>, carried: &StripForces<T>, stick: T::Base, adheres: bool,
    ) -> Self {
        let bound = strip.friction_bound();
        let StripForces { fx, fy, mx, .. } = *carried;
        let (fx, fy) = (fx.scale(bound), fy.scale(bound));
        // Mz = ∫ (x Y − y X)
        let mz = mx.scale(bound * strip.half_length) + fy.scale(strip.centre_x) - fx.scale(strip.y);
        Self { fx, fy, mz, besides: T::zero(), stick, adheres }
    }

    /// The same of a strip with the creepage of the patch, that which pressure adds, and its own.
    pub fn on(
        mut self, strip: &PatchStrip<T::Base>, shift: T, own: Option<&Creepage<T::Base>>,
    ) -> Self {
        self.besides = self.fx * shift;
        if let Some(own) = own {
            let Creepage { longitudinal, lateral, spin } = *own;
            let mz = self.about_centre(strip);
            self.besides += self.fx.scale(longitudinal) + self.fy.scale(lateral) + mz.scale(spin);
        }
        self
    }

    /// Power divided by rolling speed.
    pub fn power(&self, creepage: &Creepage<T>) -> T {
        let Creepage { longitudinal, lateral, spin } = *creepage;
        self.fx * longitudinal + self.fy * lateral + self.mz * spin + self.besides
    }

    /// Moment about the centre of the strip.
    pub fn about_centre(&self, strip: &PatchStrip<T::Base>) -> T {
        self.mz - self.fy.scale(strip.centre_x) + self.fx.scale(strip.y)
    }
}

/// Creepage at a patch's origin, a factor 1 of the creepage that pressure adds, and the layer.
#[derive(Clone, Copy, Debug)]
pub(super) struct PatchSlip<T> {
    pub creepage: Creepage<T>,
    pub pressure: T,
    /// The layer `h G/G₃` \[m\], and what sliding leaves of its stiffness.
    pub behind: Option<Interface<T>>,
}

/// The variables of derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum By {
    /// The creepages.
    Creepages,
    /// A factor of the mismatch; the other two derivatives are zero.
    Mismatch,
    /// The layer's depth and what sliding leaves of its stiffness; the third derivative is zero.
    Layer,
}

impl<F: Float> PatchSlip<F> {
    pub fn new(creepage: &Creepage<F>, behind: Option<Interface<F>>) -> Self {
        Self { creepage: *creepage, pressure: F::one(), behind }
    }
}

impl<F: Float> PatchSlip<Dual<F, 3>> {
    /// With derivatives.
    pub fn with_slopes(creepage: &Creepage<F>, behind: Option<Interface<F>>, by: By) -> Self {
        let of = |own: F, index: usize, variable: By| {
            if by == variable { Dual::input(own, index) } else { Dual::from_base(own) }
        };
        let Creepage { longitudinal, lateral, spin } = *creepage;
        Self {
            creepage: Creepage {
                longitudinal: of(longitudinal, 0, By::Creepages),
                lateral: of(lateral, 1, By::Creepages),
                spin: of(spin, 2, By::Creepages),
            },
            pressure: of(F::one(), 0, By::Mismatch),
            behind: behind.map(|Interface { layer, slide }| Interface {
                layer: of(layer, 0, By::Layer),
                slide: of(slide, 1, By::Layer),
            }),
        }
    }
}

/// The creepages of half-spaces and bristles of a zone.
#[derive(Clone, Copy, Debug)]
pub(super) struct ZoneSplit<T: Number> {
    split: Split<T>,
    /// Whether there is a layer, not sliding alone.
    has_bristles: bool,
    /// Centre and half length of the zone's ellipse.
    x: T::Base,
    y: T::Base,
    a: T::Base,
    /// `μ p₀` of the ellipse.
    bound: T::Base,
}

impl<F: Float, T: Number<Base = F>> ZoneSplit<T> {
    /// For the creepage of the ellipse at `x` on its middle line.
    pub fn new(
        zone: &Zone<F>, linear: &LinearCoefficients<F>, seen: &Creepage<T>, x: F,
        behind: &Interface<T>,
    ) -> Self {
        let Contact { a, b, friction, .. } = zone.contact;
        let layer = behind.layer.scale(F::one() / a);
        let interface = Interface { layer, slide: behind.slide };
        let split = Layer::new(a / b, linear).split(normalised(&zone.contact, seen), &interface);
        let bound = friction * zone.contact.peak_pressure();
        let has_bristles = layer.value() > F::zero();
        Self { split, has_bristles, x, y: zone.y, a, bound }
    }

    /// For a creepage at the origin, in the theory of 1967; also the creepage of the ellipse.
    pub fn of_zone(
        zone: &Zone<F>, creepage: &Creepage<T>, behind: &Interface<T>,
    ) -> (Self, Creepage<T>) {
        let Contact { a, b, poisson_ratio, .. } = zone.contact;
        let linear = LinearCoefficients::at(a / b, poisson_ratio);
        let seen = creepage_at(creepage, zone.x, zone.y);
        (Self::new(zone, &linear, &seen, zone.x, behind), seen)
    }

    /// The creepage of the half-spaces.
    pub fn half_spaces(&self, seen: &Creepage<T>) -> Creepage<T> {
        self.split.half_spaces(seen)
    }

    /// The same at the origin of the patch.
    pub fn half_spaces_at_origin(&self, seen: &Creepage<T>) -> Creepage<T> {
        creepage_at(&self.half_spaces(seen), -self.x, -self.y)
    }

    fn bristles(&self, strip: &PatchStrip<F>) -> Rates<T> {
        let [x, y, spin] = self.split.rates;
        let bound = strip.friction * strip.peak_pressure;
        // in units of the strip: c/a over Π
        let unit = if bound > F::zero() && self.bound > F::zero() {
            strip.half_length / self.a * (self.bound / bound)
        } else {
            F::one()
        };
        let (to_y, to_x) = ((strip.y - self.y) / self.a, (strip.centre_x - self.x) / self.a);
        let over_length = strip.half_length / self.a;
        let of_zone = [x - spin.scale(to_y), y + spin.scale(to_x), spin.scale(over_length)];
        // A strip that hardly carries may slide more than any number.
        let unit = unit.min(F::HUGE);
        let [x, y, spin] = scaled_down(of_zone, F::HUGE / unit).map(|rate| rate.scale(unit));
        Rates { x, y, spin }
    }

    /// The mean of the forces of a strip of half-spaces and those of its bristles.
    pub fn mean(&self, strip: &PatchStrip<F>, share: Share<T>) -> Share<T> {
        if !self.has_bristles {
            return share;
        }
        let forces = self.bristles(strip).of_strip();
        let stick = forces.stick.value();
        let adheres = stick > F::zero();
        let bristles = Share::new(strip, &forces, stick, adheres);
        let weight = self.split.weight;
        let mean = |of: T, bristles: T| of + (bristles - of) * weight;
        Share {
            fx: mean(share.fx, bristles.fx),
            fy: mean(share.fy, bristles.fy),
            mz: mean(share.mz, bristles.mz),
            besides: share.besides,
            stick: share.stick + (stick - share.stick) * weight.value(),
            adheres: share.adheres || adheres,
        }
    }
}

impl<F: Float> ZoneSplit<F> {
    /// What the points of a strip need, from the creepage of the ellipse.
    pub fn of_field(&self, strip: &PatchStrip<F>, seen: &Creepage<F>) -> StripBehind<F> {
        let (x, y) = (strip.centre_x - self.x, strip.y - self.y);
        let rigid = |of: &Creepage<F>| {
            let Creepage { longitudinal, lateral, spin } = creepage_at(of, x, y);
            Rates { x: longitudinal, y: lateral, spin: spin * strip.half_length }
        };
        StripBehind {
            rigid: rigid(seen),
            half_spaces: rigid(&self.half_spaces(seen)),
            bristles: self.has_bristles.then(|| self.bristles(strip)),
            weight: self.split.weight,
        }
    }
}

/// Rigid slip at the point `(x, y)` as creepage of a contact there: `(υx − φ y, υy + φ x, φ)`.
pub(crate) fn creepage_at<T: Number>(
    creepage: &Creepage<T>, x: T::Base, y: T::Base,
) -> Creepage<T> {
    let Creepage { longitudinal, lateral, spin } = *creepage;
    Creepage { longitudinal: longitudinal - spin.scale(y), lateral: lateral + spin.scale(x), spin }
}

/// Creepage of the patch at a strip: with that which is `own` at the strip's centre.
pub(super) fn creepage_of_strip<T: Number>(
    creepage: &Creepage<T>, strip: &PatchStrip<T::Base>, own: Option<&Creepage<T::Base>>,
) -> Creepage<T> {
    let Some(own) = own else { return *creepage };
    let at_origin = creepage_at(own, -strip.centre_x, -strip.y);
    Creepage {
        longitudinal: creepage.longitudinal.shift(at_origin.longitudinal),
        lateral: creepage.lateral.shift(at_origin.lateral),
        spin: creepage.spin.shift(at_origin.spin),
    }
}
