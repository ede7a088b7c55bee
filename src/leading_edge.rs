//! Where the separatrix meets the leading edge of the contact (7.2).
//!
//! The strips that have an adhesion area are those with `κ(Y) < C(Y) = √(1 − Y²)`. For `|ψ| < 1` the
//! adhesion length is a convex function of `Y` (`κ = (S + ηψ)/(1 − ψ²)`, and `S` is the length of a
//! vector that is linear in `Y`), while `C` is concave: the strips with adhesion form one interval.
//! Of the four roots of `ξ̄² + (η + ψC)² = C²` at most two are real crossings.

mod large_spin;

pub(crate) use self::large_spin::Released;

use crate::real::{Arithmetic, Float, Pair, Real};
use crate::strip::root_s;

/// A point `(Y, C)` of the leading edge, `Y² + C² = 1`, `C ≥ 0`, in units of the semi-axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgePoint<T> {
    /// `Y = y/b`
    pub y: T,
    /// `C = c/a`
    pub c: T,
}

impl<T: Real> EdgePoint<T> {
    fn lifted(point: EdgePoint<T::Base>) -> Self {
        Self { y: T::from_base(point.y), c: T::from_base(point.c) }
    }

    /// These derivatives with another value.
    fn with_value(self, value: Self) -> Self {
        Self {
            y: value.y + (self.y - T::from_base(self.y.value())),
            c: value.c + (self.c - T::from_base(self.c.value())),
        }
    }

    /// The point with tangent of the half angle `t = Y/(1 + C)`.
    fn at_half_tangent(t: T) -> Self {
        let scale = T::one() / (T::one() + t * t);
        Self { y: (t * scale).times(2.0), c: (T::one() - t) * (T::one() + t) * scale }
    }
}

/// The interval of strips with adhesion. Without any, both ends are the strip that comes nearest to
/// it, so that the ends move continuously when an interval appears.
#[derive(Clone, Copy, Debug)]
pub struct AdhesionInterval<T> {
    /// End at smaller `y`.
    pub lower: EdgePoint<T>,
    /// End at larger `y`.
    pub upper: EdgePoint<T>,
}

/// `ξ̄(Y) = ξ − p Y`, `η`, `ψ`: all that the adhesion length depends on.
#[derive(Clone, Copy, Debug)]
pub struct StripFamily<T> {
    /// `ξ`
    pub xi: T,
    /// `p = ψ (b/a)/(1 − ν)`
    pub slope: T,
    /// `η`
    pub eta: T,
    /// `ψ`
    pub psi: T,
}

/// Which end of the adhesion interval.
#[derive(Clone, Copy)]
enum Side {
    Lower,
    Upper,
}

/// A line `A Y + B C = D` that touches the curve `C = κ(Y)` from below; `B = S ≥ 0`.
struct Tangent<T> {
    a: T,
    b: T,
    d: T,
}

impl<T: Real> Tangent<T> {
    /// Where the line meets the circle `Y² + C² = 1`; `None` when it passes above.
    #[inline(always)]
    fn meets_edge(&self, side: Side) -> Option<EdgePoint<T>> {
        let norm = self.a * self.a + self.b * self.b;
        let square = norm - self.d * self.d;
        if !(square > T::zero()) {
            return None;
        }
        let inverse = T::one() / norm;
        let root = match side {
            Side::Lower => -square.sqrt(),
            Side::Upper => square.sqrt(),
        };
        Some(EdgePoint {
            y: (self.d * self.a + self.b * root) * inverse,
            c: (self.d * self.b - self.a * root) * inverse,
        })
    }
}

/// `κ(ξ̄)` of (5.41) for many strips, with what they share computed once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AdhesionLength<P> {
    /// `1 − ψ²`
    q: P,
    /// `1/(1 − ψ²)`
    inverse: P,
    eta_squared: P,
    eta_psi: P,
    /// `ηψ/(1 − ψ²)`
    slope: P,
    cancels: bool,
}

impl<P: Arithmetic> AdhesionLength<P> {
    /// `cancels` chooses the form: `(S + ηψ)/(1 − ψ²)` without, `(ξ̄² + η²)/(S − ηψ)` with
    /// cancellation.
    #[inline(always)]
    pub(crate) fn of(family: &StripFamily<P>, cancels: bool) -> Self {
        let StripFamily { eta, psi, .. } = *family;
        let q = (P::one() - psi) * (P::one() + psi);
        let (inverse, eta_psi) = (P::one() / q, eta * psi);
        Self { q, inverse, eta_squared: eta * eta, eta_psi, slope: eta_psi * inverse, cancels }
    }

    /// `S² = η² + (1 − ψ²) ξ̄²` and `S`
    #[inline(always)]
    fn s(&self, square: P) -> (P, P) {
        // The floor keeps 1/S⁴, which the derivatives need, finite.
        let floor = P::from_base(<P::Base as Real>::ROOT_TINY);
        let s_squared = (self.eta_squared + self.q * square).max(floor);
        (s_squared, s_squared.sqrt())
    }

    /// `κ/a`
    #[inline(always)]
    pub(crate) fn at(&self, xi_bar: P) -> P {
        let square = xi_bar * xi_bar;
        let (_, s) = self.s(square);
        if self.cancels {
            (square + self.eta_squared) / (s - self.eta_psi)
        } else {
            s * self.inverse + self.slope
        }
    }

    /// The tangent at `Y`, `κ + (dκ/dY)(Y' − Y)` with `dκ/dY = −p ξ̄/S` from either form of (5.41),
    /// times `S` so that nothing is divided by it.
    #[inline(always)]
    fn tangent(&self, family: &StripFamily<P>, y: P) -> Tangent<P> {
        let xi_bar = family.xi_bar(y);
        let square = xi_bar * xi_bar;
        let (s_squared, s) = self.s(square);
        let s_kappa = if self.cancels {
            s * ((square + self.eta_squared) / (s - self.eta_psi))
        } else {
            s_squared * self.inverse + s * self.slope
        };
        let a = family.slope * xi_bar;
        Tangent { a, b: s, d: s_kappa + a * y }
    }
}

impl<T: Real> AdhesionLength<T> {
    /// The same twice, side by side.
    #[inline(always)]
    pub(crate) fn paired(&self) -> AdhesionLength<T::Pair> {
        AdhesionLength {
            q: T::Pair::both(self.q),
            inverse: T::Pair::both(self.inverse),
            eta_squared: T::Pair::both(self.eta_squared),
            eta_psi: T::Pair::both(self.eta_psi),
            slope: T::Pair::both(self.slope),
            cancels: self.cancels,
        }
    }
}

/// Tangent steps; each squares the error, except near the birth of an interval where it halves it.
const TANGENT_STEPS: usize = 40;
/// Newton steps with bisection for the strip nearest to adhesion.
const NEAREST_STEPS: usize = 60;

impl<P: Arithmetic> StripFamily<P> {
    /// `ξ̄` of the strip at `y`.
    #[inline(always)]
    pub fn xi_bar(&self, y: P) -> P {
        self.xi - self.slope * y
    }
}

impl<T: Real> StripFamily<T> {
    /// The same family twice, side by side.
    #[inline(always)]
    pub(crate) fn paired(&self) -> StripFamily<T::Pair> {
        StripFamily {
            xi: T::Pair::both(self.xi),
            slope: T::Pair::both(self.slope),
            eta: T::Pair::both(self.eta),
            psi: T::Pair::both(self.psi),
        }
    }

    /// Whether the direct form of (5.41) loses more than a factor 128 in the last place, in single precision 8.
    #[inline(always)]
    pub(crate) fn cancels(&self) -> bool {
        let limit = if size_of::<T::Base>() < 8 { 0.25 } else { 1.0 / 64.0 };
        self.eta * self.psi < T::zero()
            && (T::one() - self.psi) * (T::one() + self.psi) < T::constant(limit)
    }

    /// The same family without derivatives.
    fn plain(&self) -> StripFamily<T::Base> {
        StripFamily {
            xi: self.xi.value(),
            slope: self.slope.value(),
            eta: self.eta.value(),
            psi: self.psi.value(),
        }
    }

    /// The tangent of the adhesion length at `Y`.
    #[inline(always)]
    fn tangent(&self, y: T) -> Tangent<T> {
        AdhesionLength::of(self, self.cancels()).tangent(self, y)
    }

    /// The adhesion interval, or `None` with the strip nearest to adhesion.
    ///
    /// For `|ψ| > 1` the interval is where a root exists and fits (`κ ≤ C`); the bound on the
    /// traction may take pieces out of it, see `Released`.
    pub fn adhesion_interval(&self) -> Result<AdhesionInterval<T>, EdgePoint<T>> {
        let plain = self.plain();
        let (size, one) = (plain.psi.abs(), T::Base::one());
        if !T::HAS_DERIVATIVES && size == T::Base::zero() {
            return self.without_spin();
        }
        // At unit spin the second form of (5.41) still holds, with S = |η|.
        let within = size < one || (size <= one && plain.eta * plain.psi < T::Base::zero());
        let found = if within { plain.by_tangents() } else { plain.beyond_unit_spin() };
        match found {
            Some((lower, upper)) => Ok(AdhesionInterval {
                lower: self.polished(lower, Side::Lower),
                upper: self.polished(upper, Side::Upper),
            }),
            None => Err(self.nearest()),
        }
    }

    /// Without spin `κ/a = τ` everywhere, and the strips with `C > τ` adhere (8.15).
    #[inline(always)]
    fn without_spin(&self) -> Result<AdhesionInterval<T>, EdgePoint<T>> {
        let square = self.xi * self.xi + self.eta * self.eta;
        let rest = T::one() - square;
        if !(rest > T::zero()) {
            return Err(self.nearest());
        }
        let (y, c) = (rest.sqrt(), square.sqrt());
        Ok(AdhesionInterval { lower: EdgePoint { y: -y, c }, upper: EdgePoint { y, c } })
    }

    /// One tangent step from a converged end carries the derivatives.
    #[inline]
    fn polished(&self, end: EdgePoint<T::Base>, side: Side) -> EdgePoint<T> {
        let lifted = EdgePoint::lifted(end);
        if !T::HAS_DERIVATIVES {
            return lifted;
        }
        let plain = self.plain();
        let xi_bar = plain.xi_bar(end.y);
        let q = (T::Base::one() - plain.psi) * (T::Base::one() + plain.psi);
        let eta_squared = plain.eta * plain.eta;
        if eta_squared + q * xi_bar * xi_bar <= eta_squared.times(1e-10) && q < T::Base::zero() {
            // Beyond |ψ| = 1 the interval may end where S = 0, at ξ̄ = ±|η|/√(ψ² − 1).
            let q = (T::one() - self.psi) * (T::one() + self.psi);
            let edge = self.eta.abs() / (-q).sqrt();
            let edge = if xi_bar < T::Base::zero() { -edge } else { edge };
            let y = (self.xi - edge) / self.slope;
            let c = ((T::one() - y) * (T::one() + y)).max(T::zero()).sqrt();
            return EdgePoint { y, c }.with_value(lifted);
        }
        // The error of the derivatives is that of the point where they are taken: once more.
        let closer = plain.tangent(end.y).meets_edge(side).unwrap_or(end);
        self.tangent(T::from_base(closer.y))
            .meets_edge(side)
            .filter(|point| (point.y - lifted.y).abs() <= T::constant(1e-3))
            .map_or(lifted, |point| point.with_value(lifted))
    }
}

impl<F: Float> StripFamily<F> {
    /// Ends by Newton's method on `κ = C` with the circle treated exactly. The tangent of the convex
    /// `κ` lies below it, so adhesion is possible only on the chord that it cuts off: a tangent that
    /// misses the circle, or two chords that do not meet, prove that there is none.
    fn by_tangents(&self) -> Option<(EdgePoint<F>, EdgePoint<F>)> {
        let (lower, upper) = self.first_chord()?;
        // Both ends at once, the lower one mirrored: Y → −Y, p → −p.
        let mirror = F::Pair::of(-F::one(), F::one());
        let sides = StripFamily {
            xi: F::Pair::both(self.xi),
            slope: F::Pair::of(-self.slope, self.slope),
            eta: F::Pair::both(self.eta),
            psi: F::Pair::both(self.psi),
        };
        let length = AdhesionLength::of(&sides, self.cancels());
        let mut y = F::Pair::of(-lower, upper);
        for _ in 0..TANGENT_STEPS {
            let tangent = length.tangent(&sides, y);
            let norm = tangent.a * tangent.a + tangent.b * tangent.b;
            let square = norm - tangent.d * tangent.d;
            let (first, second) = square.parts();
            if !(first > F::zero() && second > F::zero()) {
                return None;
            }
            let inverse = F::Pair::one() / norm;
            let root = square.sqrt();
            let (middle, half) = (tangent.d * tangent.a * inverse, tangent.b * root * inverse);
            let outer = middle + half;
            // Where the chords begin and end, unmirrored
            let (far_upper, far_lower) = ((middle - half) * mirror).parts();
            let (near_lower, near_upper) = (outer * mirror).parts();
            if !(near_lower < near_upper && near_lower <= far_upper && far_lower <= near_upper) {
                return None;
            }
            let step = outer - y;
            let (change_lower, change_upper) = step.abs().parts();
            if change_lower.max(change_upper) <= (near_upper - near_lower).times(5e-4) {
                // What is left is the curvature of κ, κ'' = p² η²/S³: along the circle, where
                // d(κ − C)/dθ = √(A² + B² − D²)/S, the end lies dθ = −κ'' S step²/(2 √…) further in.
                let bend = sides.slope * sides.eta * step / tangent.b;
                let turn = -(bend * bend / root).times(0.5);
                let c = (tangent.d * tangent.b - tangent.a * root) * inverse;
                let (lower_c, upper_c) = (c - outer * turn).parts();
                let (lower_y, upper_y) = ((outer + c * turn) * mirror).parts();
                return (lower_y < upper_y).then_some((
                    EdgePoint { y: lower_y, c: lower_c },
                    EdgePoint { y: upper_y, c: upper_c },
                ));
            }
            y = outer;
        }
        None
    }

    /// The chord of the tangent at the shortest adhesion length (`ξ̄ = 0`), or at the edge of the
    /// contact nearest to it.
    #[inline(always)]
    fn first_chord(&self) -> Option<(F, F)> {
        if self.xi.abs() < self.slope.abs() {
            // There the tangent is level, κ = (|η| + ηψ)/(1 − ψ²), without spin too.
            let eta = self.eta.abs();
            let kappa = if self.eta * self.psi < F::zero() {
                eta / (F::one() + self.psi.abs())
            } else {
                eta / (F::one() - self.psi.abs())
            };
            let square = (F::one() - kappa) * (F::one() + kappa);
            if !(square > F::zero()) {
                return None;
            }
            let y = square.sqrt();
            return Some((-y, y));
        }
        let start = if self.xi * self.slope < F::zero() { -F::one() } else { F::one() };
        let tangent = self.tangent(start);
        let (lower, upper) = (tangent.meets_edge(Side::Lower)?, tangent.meets_edge(Side::Upper)?);
        Some((lower.y, upper.y))
    }
}

impl<T: Real> StripFamily<T> {
    /// The strip where `C − κ` is largest: `Y/C = p ξ̄/S`, a rising function of `Y/C` against a
    /// falling one.
    fn nearest(&self) -> EdgePoint<T> {
        let plain = self.plain();
        let (one, zero) = (T::Base::one(), T::Base::zero());
        // Unknown: the tangent of the half angle, t = Y/(1 + C), in [-1, 1].
        let (mut low, mut high) = (-one, one);
        let mut t = if plain.xi.abs() < plain.slope.abs() {
            let y = plain.xi / plain.slope;
            y / (one + ((one - y) * (one + y)).sqrt())
        } else {
            zero
        };
        let mut point = EdgePoint::at_half_tangent(t);
        for _ in 0..NEAREST_STEPS {
            point = EdgePoint::at_half_tangent(t);
            let (excess, growth) = plain.tilt(point);
            if excess < zero {
                low = t
            } else {
                high = t
            }
            // dY/dt = C (1 + Y²…): with t = tan(θ/2), dθ/dt = 2/(1 + t²)
            let newton = t - excess / growth * (one + t * t).times(0.5);
            let next = if newton > low && newton < high { newton } else { (low + high).times(0.5) };
            let change = (next - t).abs();
            t = next;
            if change <= T::EPSILON.times(2.0) {
                break;
            }
        }
        // One step with derivatives: dθ = −excess/growth.
        let lifted = EdgePoint::lifted(point);
        let (excess, growth) = self.tilt(lifted);
        let turn = -(excess.scale(one / growth.value()));
        if turn.value().abs() > T::EPSILON.times(64.0) || !turn.value().is_finite_number() {
            return lifted;
        }
        EdgePoint { y: lifted.y + lifted.c * turn, c: lifted.c - lifted.y * turn }
    }

    /// `Y S − p ξ̄ C` over `S`-like scale, and its growth with the angle `θ` (`Y = sin θ`).
    fn tilt(&self, point: EdgePoint<T>) -> (T, T) {
        let xi_bar = self.xi_bar(point.y);
        let s = root_s(xi_bar, self.eta, self.psi) + T::from_base(T::TINY);
        let q = (T::one() - self.psi) * (T::one() + self.psi);
        // d/dθ (Y S − p ξ̄ C) = C S + Y S' C + p² C² + p ξ̄ Y,  S' = dS/dY = −q p ξ̄/S
        let s_prime = -(q * self.slope * xi_bar / s);
        let excess = point.y * s - self.slope * xi_bar * point.c;
        let growth = point.c * s
            + point.y * s_prime * point.c
            + self.slope.squared() * point.c.squared()
            + self.slope * xi_bar * point.y;
        (excess, growth.max(T::from_base(T::TINY)))
    }
}
