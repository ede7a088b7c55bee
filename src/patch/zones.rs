//! What a strip takes for its own ellipse: the strips that it is connected with.
//!
//! The corrected strips need an axis ratio. A strip's zone is all strips that it reaches without passing a neck; beyond a neck
//! they count with a weight, one where the neck is 0.85 of the smaller of the two parts that it connects, none below
//! 0.55. So a patch that is pinched falls apart without a jump, and a strip in the neck belongs to both sides.
//!
//! **Equivalent ellipse**, of the zone's load and friction, from sums over the load: on an ellipse
//! `∫ C² l² dY/∫ C² dY = (4/5) a²`, so
//!
//! ```text
//! a² = (5/4) Σ N l²/Σ N,   π a b = area,   (x₀, y₀) = Σ N (x, y)/Σ N,   μ = Σ μ N/Σ N
//! ```

use crate::contact::Contact;
use crate::number::Float;
use crate::patch::{PatchStrip, PatchView};
use core::f64::consts::PI;

/// Neck over the smaller part: no connection, and all of it.
const APART: f64 = 0.55;
const WHOLE: f64 = 0.85;
/// Distance of neighbours, over that at which they touch, where their connection begins to end, and where it has.
const TOUCHING: f64 = 1.5;
const GAP: f64 = 2.0;

/// The ellipse that stands for a strip's zone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Zone<F> {
    /// `x` \[m\] of its centre.
    pub x: F,
    /// `y` \[m\].
    pub y: F,
    /// The ellipse.
    pub contact: Contact<F>,
}

/// Sums over connected strips.
#[derive(Clone, Copy)]
struct Sums<F> {
    load: F,
    bound: F,
    square: F,
    /// `x` and `y`
    centre: [F; 2],
    area: F,
}

impl<F: Float> Sums<F> {
    /// `unit`: of half lengths.
    fn add(&mut self, strip: &PatchStrip<F>, unit: F, weight: F) {
        let load = strip.load() * weight;
        self.load += load;
        self.bound += load * strip.friction;
        self.square += load * (strip.half_length / unit).squared();
        let [x, y] = &mut self.centre;
        *x += load * strip.centre_x;
        *y += load * strip.y;
        self.area += strip.half_length.times(2.0) * strip.width * weight;
    }
}

/// A walk away from a strip: the longest strip on the way, the shortest since, and what is left of the connection.
struct Walk<F> {
    peak: F,
    neck: F,
    weight: F,
}

impl<F: Float> Walk<F> {
    fn new(strip: &PatchStrip<F>) -> Self {
        Self { peak: strip.half_length, neck: strip.half_length, weight: F::one() }
    }

    /// The weight of the next strip.
    fn pass(&mut self, last: &PatchStrip<F>, next: &PatchStrip<F>) -> F {
        let l = next.half_length;
        self.neck = self.neck.min(l);
        let smaller = self.peak.min(l);
        let share = (self.neck / smaller).plus(-APART).times(1.0 / (WHOLE - APART));
        let distance = (next.y - last.y).abs() / (next.width + last.width).times(0.5);
        let near = (F::of(GAP) - distance).times(1.0 / (GAP - TOUCHING));
        let share = share.min(near).clamped(F::zero(), F::one());
        self.weight = self.weight.min(share * share * (F::of(3.0) - share.times(2.0)));
        if l > self.peak {
            (self.peak, self.neck) = (l, l);
        }
        self.weight
    }
}

impl<F: Float> Zone<F> {
    /// The same but for rounding.
    pub(crate) fn is(&self, other: &Self) -> bool {
        let near = |x: F, y: F, size: F| (x - y).abs() <= size * F::EPSILON.times(32.0);
        let (one, two) = (&self.contact, &other.contact);
        near(one.a, two.a, one.a)
            && near(one.b, two.b, one.b)
            && near(one.normal_force, two.normal_force, one.normal_force)
            && near(one.friction, two.friction, one.friction)
            && near(self.x, other.x, self.x.abs() + one.a)
            && near(self.y, other.y, self.y.abs() + one.b)
    }
}

impl<F: Float> PatchView<'_, F> {
    /// Whether no neck and no gap divides the patch.
    pub(crate) fn is_one_zone(&self) -> bool {
        let strips = self.strips();
        let Some(first) = strips.first() else { return true };
        let mut walk = Walk::new(first);
        let mut pairs = strips.iter().zip(strips.iter().skip(1));
        pairs.all(|(last, next)| walk.pass(last, next) >= F::one())
    }

    /// The zone of the strip of this number, `None` beyond the last.
    #[must_use]
    pub fn zone(&self, number: usize) -> Option<Zone<F>> {
        let strips = self.strips();
        let (before, rest) = strips.split_at_checked(number)?;
        let (own, after) = rest.split_first()?;
        let zero = F::zero();
        let mut sums =
            Sums { load: zero, bound: zero, square: zero, centre: [zero; 2], area: zero };
        let unit = own.half_length;
        sums.add(own, unit, F::one());
        let (mut walk, mut last) = (Walk::new(own), own);
        for strip in before.iter().rev() {
            sums.add(strip, unit, walk.pass(last, strip));
            last = strip;
        }
        let (mut walk, mut last) = (Walk::new(own), own);
        for strip in after {
            sums.add(strip, unit, walk.pass(last, strip));
            last = strip;
        }
        let Sums { load, bound, square, centre: [x, y], area } = sums;
        let loaded = load > zero;
        let mean = |sum: F, own: F| if loaded { sum / load } else { own };
        let a = unit * mean(square, F::one()).times(1.25).sqrt();
        let contact = Contact {
            a,
            b: (area * self.scale().area / a).times(1.0 / PI),
            normal_force: load,
            shear_modulus: self.shear_modulus(),
            poisson_ratio: self.poisson_ratio(),
            friction: mean(bound, own.friction),
        };
        Some(Zone { x: mean(x, own.centre_x), y: mean(y, own.y), contact })
    }
}
