//! Where the separatrix meets the leading edge of the contact (7.2).
//!
//! The strips that have an adhesion area are those with `κ(Y) < C(Y) = √(1 − Y²)`. For `|ψ| < 1` the
//! adhesion length is a convex function of `Y` (`κ = (S + ηψ)/(1 − ψ²)`, and `S` is the length of a
//! vector that is linear in `Y`), while `C` is concave: the strips with adhesion form one interval.
//! Of the four roots of `ξ̄² + (η + ψC)² = C²` at most two are real crossings.

mod large_spin;
#[cfg(target_arch = "x86_64")]
mod side_by_side;

pub(crate) use self::large_spin::Released;

use crate::number::{Arithmetic, Choice, Float, Number, Pair, Plain, Real, Stored};

/// A point `(Y, C)` of the leading edge, `Y² + C² = 1`, `C ≥ 0`, in units of the semi-axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgePoint<T> {
    /// `Y = y/b`
    pub y: T,
    /// `C = c/a`
    pub c: T,
}

impl<T: Number> EdgePoint<T> {
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

    /// The point with `Y`.
    #[inline(always)]
    pub(crate) fn on_edge(y: T) -> Self {
        Self { y, c: ((T::one() - y) * (T::one() + y)).max(T::zero()).sqrt() }
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

impl<T: Number> Choice<T> for EdgePoint<T> {
    #[inline(always)]
    fn chosen(by: T, yes: Self, no: Self) -> Self {
        Self { y: by.choose(yes.y, no.y), c: by.choose(yes.c, no.c) }
    }
}

impl<T: Number> Choice<T> for AdhesionInterval<T> {
    #[inline(always)]
    fn chosen(by: T, yes: Self, no: Self) -> Self {
        Self {
            lower: EdgePoint::chosen(by, yes.lower, no.lower),
            upper: EdgePoint::chosen(by, yes.upper, no.upper),
        }
    }
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

impl<P: Arithmetic> Tangent<P> {
    /// `A² + B²`, and what it exceeds `D²` by: positive where the line meets the circle `Y² + C² = 1`.
    #[inline(always)]
    fn squares(&self) -> (P, P) {
        let norm = self.a * self.a + self.b * self.b;
        (norm, norm - self.d * self.d)
    }

    /// Where it meets the circle, with the root of either sign and `1/(A² + B²)`.
    #[inline(always)]
    fn on_edge(&self, root: P, inverse: P) -> EdgePoint<P> {
        EdgePoint {
            y: (self.d * self.a + self.b * root) * inverse,
            c: (self.d * self.b - self.a * root) * inverse,
        }
    }
}

impl<T: Real> Tangent<T> {
    /// Where the line meets the circle; `None` when it passes above.
    #[inline(always)]
    fn meets_edge(&self, side: Side) -> Option<EdgePoint<T>> {
        let (norm, square) = self.squares();
        if !(square > T::zero()) {
            return None;
        }
        let root = match side {
            Side::Lower => -square.sqrt(),
            Side::Upper => square.sqrt(),
        };
        Some(self.on_edge(root, T::one() / norm))
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
        let floor = P::from_base(<P::Base as Number>::ROOT_TINY);
        let s_squared = (self.eta_squared + self.q * square).max(floor);
        (s_squared, s_squared.sqrt())
    }

    /// `κ/a`
    #[inline(always)]
    pub(crate) fn at(&self, xi_bar: P) -> P {
        if self.cancels {
            let square = xi_bar * xi_bar;
            let (_, s) = self.s(square);
            return (square + self.eta_squared) / (s - self.eta_psi);
        }
        let x = xi_bar.bare();
        let square = x * x;
        let floor = P::Bare::from_base(<P::Base as Number>::ROOT_TINY);
        let (eta_squared, q) = (self.eta_squared.bare(), self.q.bare());
        let s = (eta_squared + q * square).max(floor).sqrt();
        let inverse = self.inverse.bare();
        let kappa = s * inverse + self.slope.bare();
        // dκ = (ξ̄/S) dξ̄ + d(η²)/(2 q S) + (ξ̄²/(2 q S) − S/q²) dq + d(ηψ/q)
        let over_s = P::Bare::one() / s;
        let half = over_s.times(0.5) * inverse;
        P::composed(
            kappa,
            [x * over_s, half, square * half - s * inverse * inverse, P::Bare::one()],
            [xi_bar, self.eta_squared, self.q, self.slope],
        )
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

impl<T: Number> AdhesionLength<T> {
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
const TANGENT_STEPS: usize = 3;
/// The same, from the parabola about the strip nearest to adhesion.
const SHORT_STEPS: usize = 3;

/// Changes of the ends, of the length of the interval, whose squares no longer matter.
const CLOSE: f64 = 5e-4;

/// A tangent at either end of the interval, the lower one mirrored: where they meet the circle.
struct Closer<P> {
    tangent: Tangent<P>,
    /// `√(A² + B² − D²)`
    root: P,
    /// `1/(A² + B²)`
    inverse: P,
    /// `Y` of the outer end of the chord.
    outer: P,
    /// `Y` of its inner end.
    inner: P,
}

impl<P: Arithmetic> Tangent<P> {
    /// The step of Newton's method that it is, with its [`squares`](Tangent::squares).
    #[inline(always)]
    fn closer(self, (norm, square): (P, P)) -> Closer<P> {
        let Self { a, b, d } = self;
        let (inverse, root) = (P::one() / norm, square.sqrt());
        let (middle, half) = (d * a * inverse, b * root * inverse);
        Closer { tangent: self, root, inverse, outer: middle + half, inner: middle - half }
    }
}

/// The lower and the upper one of two `Y`, of which the lower one is mirrored.
#[inline(always)]
fn unmirrored<T: Number, P: Pair<T>>(y: P) -> (T, T) {
    (y * P::of(-T::one(), T::one())).parts()
}

impl<P: Arithmetic> Closer<P> {
    /// `Y` where the chord of the lower and that of the upper end lie: outer ends, lower and upper, and inner ends.
    #[inline(always)]
    fn chords<T: Number>(&self) -> [T; 4]
    where
        P: Pair<T>,
    {
        let (near_lower, near_upper) = unmirrored(self.outer);
        let (far_upper, far_lower) = unmirrored(self.inner);
        [near_lower, near_upper, far_lower, far_upper]
    }

    /// How far the ends have moved from `Y`.
    #[inline(always)]
    fn change<T: Number>(&self, y: P) -> T
    where
        P: Pair<T>,
    {
        let (lower, upper) = (self.outer - y).abs().parts();
        lower.max(upper)
    }

    /// The ends themselves, when the step from `Y` was short.
    ///
    /// What is left is the curvature of `κ`, `κ'' = p² η²/S³`: along the circle, where
    /// `d(κ − C)/dθ = √(A² + B² − D²)/S`, the end lies `dθ = −κ'' S step²/(2 √…)` further in.
    #[inline(always)]
    fn ends<T: Number>(&self, sides: &StripFamily<P>, y: P) -> (EdgePoint<T>, EdgePoint<T>)
    where
        P: Pair<T>,
    {
        let Tangent { a, b, d } = self.tangent;
        let bend = sides.slope * sides.eta * (self.outer - y) / b;
        let turn = -(bend * bend / self.root).times(0.5);
        let c = (d * b - a * self.root) * self.inverse;
        let (lower_c, upper_c) = (c - self.outer * turn).parts();
        let (lower_y, upper_y) = unmirrored(self.outer + c * turn);
        (EdgePoint { y: lower_y, c: lower_c }, EdgePoint { y: upper_y, c: upper_c })
    }
}

/// `S²/η²` below which an end of the interval is taken to lie where `S = 0`: in single precision what rounding leaves of it there.
fn rooted_share<F: Float>() -> F {
    F::of(1e-10).max(F::EPSILON.times(1024.0))
}

/// What tangents tell of the adhesion interval.
enum Ends<F> {
    /// There is none.
    Missing,
    /// Its ends.
    Found(EdgePoint<F>, EdgePoint<F>),
    /// It lies between these `Y`, and more steps are needed.
    Between(F, F),
}

impl<P: Arithmetic> StripFamily<P> {
    /// `ξ̄` of the strip at `y`.
    #[inline(always)]
    pub fn xi_bar(&self, y: P) -> P {
        self.xi - self.slope * y
    }

    /// `κ = (|η| + ηψ)/(1 − ψ²)` of the strip with `ξ̄ = 0`, the shortest; (5.41), divided by the factor that both have.
    #[inline(always)]
    fn shortest_kappa(&self) -> P {
        let size = self.psi.abs();
        let divisor = (-(self.eta * self.psi)).choose(P::one() + size, P::one() - size);
        self.eta.abs() / divisor
    }
}

impl<T: Number> StripFamily<T> {
    /// `1 − ψ²` below which the direct form of (5.41) may lose more than a factor 128 in the last place, in single
    /// precision 8.
    const CANCELLING: f64 = if size_of::<Stored<T>>() < 8 { 0.25 } else { 1.0 / 64.0 };

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

    /// Whether the direct form of (5.41) loses digits.
    #[inline(always)]
    pub(crate) fn cancels(&self) -> bool {
        let q = (T::one() - self.psi) * (T::one() + self.psi);
        T::zero().exceeds(self.eta * self.psi) && T::constant(Self::CANCELLING).exceeds(q)
    }

    /// The lower side mirrored, `Y → −Y`, `p → −p`, and the upper one.
    #[inline(always)]
    fn both_sides(&self) -> StripFamily<T::Pair> {
        StripFamily { slope: T::Pair::of(-self.slope, self.slope), ..self.paired() }
    }

    /// The same family without derivatives.
    #[inline(always)]
    fn plain(&self) -> StripFamily<T::Base> {
        StripFamily {
            xi: self.xi.value(),
            slope: self.slope.value(),
            eta: self.eta.value(),
            psi: self.psi.value(),
        }
    }
}

impl<T: Real> StripFamily<T> {
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
            let (rest, interval) = self.without_spin();
            return if rest > T::zero() { Ok(interval) } else { Err(self.nearest()) };
        }
        // At unit spin the second form of (5.41) still holds, with S = |η|.
        let within = size < one || (size <= one && plain.eta * plain.psi < T::Base::zero());
        let found = if within {
            plain.by_tangents()
        } else {
            // Strips with adhesion carry up to a/b times what friction allows there, and the pieces that slide take it away
            // again. An interval narrower than the digits of its ends has no pieces left: it slides.
            let narrow = T::Base::EPSILON.times(4.0);
            plain.beyond_unit_spin().filter(|(lower, upper)| upper.y - lower.y > narrow)
        };
        match found {
            Some((lower, upper)) => Ok(if T::HAS_DERIVATIVES {
                self.moving(lower, upper).unwrap_or_else(|| AdhesionInterval {
                    lower: self.polished(lower, Side::Lower),
                    upper: self.polished(upper, Side::Upper),
                })
            } else {
                AdhesionInterval {
                    lower: EdgePoint::lifted(lower),
                    upper: EdgePoint::lifted(upper),
                }
            }),
            None => Err(self.nearest()),
        }
    }

    /// Converged ends with their derivatives, both at once: `κ(Y) = C` differentiated on the circle `Y = sin θ`,
    ///
    /// ```text
    /// dθ = −dκ/(Y + C dκ/dY),   dκ/dY = −p ξ̄/S
    /// ```
    ///
    /// with `dκ` at constant `Y`. `None` where that is no smooth crossing.
    #[inline(always)]
    fn moving(
        &self,
        lower: EdgePoint<T::Base>,
        upper: EdgePoint<T::Base>,
    ) -> Option<AdhesionInterval<T>> {
        let one = <T::Base as Number>::Pair::one();
        let sides = self.both_sides();
        let length = AdhesionLength::of(&sides, self.cancels());
        let plain = StripFamily {
            xi: sides.xi.bare(),
            slope: sides.slope.bare(),
            eta: sides.eta.bare(),
            psi: sides.psi.bare(),
        };
        let plain_length = AdhesionLength {
            q: length.q.bare(),
            inverse: length.inverse.bare(),
            eta_squared: length.eta_squared.bare(),
            eta_psi: length.eta_psi.bare(),
            slope: length.slope.bare(),
            cancels: length.cancels,
        };
        let mirrored = <T::Base as Number>::Pair::of(-lower.y, upper.y);
        // The error of the derivatives is that of the point where they are taken: once more.
        let tangent = plain_length.tangent(&plain, mirrored);
        let (norm, square) = tangent.squares();
        let all_above = |pair: <T::Base as Number>::Pair, bound: T::Base| {
            let (first, second) = pair.parts();
            first > bound && second > bound
        };
        // (beyond |ψ| = 1 the interval may end where S = 0)
        let rooted = tangent.b * tangent.b - length.eta_squared.bare().scale(rooted_share());
        let zero = <T::Base as Arithmetic>::zero();
        if !(all_above(square, zero) && all_above(rooted, zero)) {
            return None;
        }
        let (inverse, root) = (one / norm, square.sqrt());
        let EdgePoint { y, c } = tangent.on_edge(root, inverse);
        if !all_above((mirrored - y).abs().times(-1.0), T::Base::of(-1e-3)) {
            return None;
        }
        // ξ̄ and κ of the strip that does not move
        let x = plain.xi - plain.slope * y;
        let xi_bar = T::Pair::composed(x, [one, -y], [sides.xi, sides.slope]);
        let s = (plain_length.eta_squared + plain_length.q * (x * x))
            .max(<T::Base as Number>::Pair::tiny())
            .sqrt();
        let by_kappa = -(s / (s * y - plain.slope * x * c));
        let angle =
            T::Pair::composed(<T::Base as Number>::Pair::zero(), [by_kappa], [length.at(xi_bar)]);
        let (lower_c, upper_c) = (lower.c, upper.c);
        let place = T::Pair::composed(mirrored, [c], [angle]);
        let height =
            T::Pair::composed(<T::Base as Number>::Pair::of(lower_c, upper_c), [-y], [angle]);
        let ((lower_y, upper_y), (lower_c, upper_c)) = (place.parts(), height.parts());
        Some(AdhesionInterval {
            lower: EdgePoint { y: -lower_y, c: lower_c },
            upper: EdgePoint { y: upper_y, c: upper_c },
        })
    }

    /// The same for one end, by a tangent step that carries the derivatives.
    #[cold]
    fn polished(&self, end: EdgePoint<T::Base>, side: Side) -> EdgePoint<T> {
        let lifted = EdgePoint::lifted(end);
        let plain = self.plain();
        let xi_bar = plain.xi_bar(end.y);
        let q = (T::Base::one() - plain.psi) * (T::Base::one() + plain.psi);
        let eta_squared = plain.eta * plain.eta;
        if eta_squared + q * xi_bar * xi_bar <= eta_squared * rooted_share() && q < T::Base::zero()
        {
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
        match self.ends_from(self.first_chord()?, TANGENT_STEPS) {
            Ends::Missing => None,
            Ends::Found(lower, upper) => Some((lower, upper)),
            // A short interval: each step only halves its error.
            Ends::Between(..) => self.ends_of_short_interval(),
        }
    }

    /// The same from the middle.
    #[cold]
    #[inline(never)]
    fn ends_of_short_interval(&self) -> Option<(EdgePoint<F>, EdgePoint<F>)> {
        match self.ends_from(self.short_interval()?, SHORT_STEPS) {
            Ends::Missing => None,
            Ends::Found(lower, upper) => Some((lower, upper)),
            Ends::Between(lower, upper) => {
                Some((EdgePoint::on_edge(lower), EdgePoint::on_edge(upper)))
            }
        }
    }

    /// At most `steps` tangents at either end, from `Y` of the lower and the upper one.
    #[cfg_attr(not(target_os = "none"), inline(always))]
    fn ends_from(&self, (lower, upper): (F, F), steps: usize) -> Ends<F> {
        let sides = self.both_sides();
        let length = AdhesionLength::of(&sides, self.cancels());
        let mut y = F::Pair::of(-lower, upper);
        for _ in 0..steps {
            let tangent = length.tangent(&sides, y);
            let squares = tangent.squares();
            let (first, second) = squares.1.parts();
            if !(first > F::zero() && second > F::zero()) {
                return Ends::Missing;
            }
            let closer = tangent.closer(squares);
            let [near_lower, near_upper, far_lower, far_upper] = closer.chords();
            if !(near_lower < near_upper && near_lower <= far_upper && far_lower <= near_upper) {
                return Ends::Missing;
            }
            if closer.change(y) < (near_upper - near_lower).times(CLOSE) {
                let (lower, upper) = closer.ends(&sides, y);
                return if lower.y < upper.y { Ends::Found(lower, upper) } else { Ends::Missing };
            }
            y = closer.outer;
        }
        let (lower, upper) = unmirrored(y);
        Ends::Between(lower, upper)
    }

    /// `Y` of the ends of a short interval: `κ − C` is a parabola in the angle `θ` about the strip nearest
    /// to adhesion, `d²(κ − C)/dθ² = κ'' C² − κ' Y + C` with `κ' = −Y/C` there.
    fn short_interval(&self) -> Option<(F, F)> {
        let EdgePoint { y, c } = self.nearest();
        let length = AdhesionLength::of(self, self.cancels());
        let xi_bar = self.xi_bar(y);
        let depth = c - length.at(xi_bar);
        if !(depth > F::zero()) {
            return None;
        }
        let (s_squared, s) = length.s(xi_bar * xi_bar);
        let bend = self.slope * self.eta * c;
        let curvature = bend * bend / (s_squared * s) + F::one() / c;
        let turn = (depth.times(2.0) / curvature).sqrt();
        // Rotated by ±turn, whose tangent of the half angle is turn/2 to the order of the parabola
        let EdgePoint { y: sine, c: cosine } = EdgePoint::at_half_tangent(turn.times(0.5));
        Some((y * cosine - c * sine, y * cosine + c * sine))
    }

    /// The chord of the tangent at the shortest adhesion length (`ξ̄ = 0`), or at the edge of the
    /// contact nearest to it.
    #[inline(always)]
    fn first_chord(&self) -> Option<(F, F)> {
        if self.xi.abs() < self.slope.abs() {
            // There the tangent is level, without spin too.
            let kappa = self.shortest_kappa();
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

impl<T: Number> StripFamily<T> {
    /// Without spin `κ/a = τ` everywhere, and the strips with `C > τ` adhere (8.15): `1 − τ²`, negative when there
    /// are none, and their interval.
    #[inline(always)]
    fn without_spin(&self) -> (T, AdhesionInterval<T>) {
        let square = self.xi * self.xi + self.eta * self.eta;
        let rest = T::one() - square;
        let (y, c) = (rest.sqrt(), square.sqrt());
        (rest, AdhesionInterval { lower: EdgePoint { y: -y, c }, upper: EdgePoint { y, c } })
    }

    /// The strip where `C − κ` is largest: `Y/C = p ξ̄/S`.
    ///
    /// With `ξ̄ + p Y = ξ` and `r = 1 − ψ² + p²` that is `ξ̄ + p² ξ̄/√(η² + r ξ̄²) = ξ`, or, solved for the other
    /// of the two, `p Y + |η| Y/√(p² − r Y²) = ξ`. By the sign of `r` the first or the second is concave.
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    fn nearest(&self) -> EdgePoint<T> {
        let plain = self.plain();
        let one = T::Base::one();
        // Mirrored so that ξ, p and |η| are not negative. The equations keep their form when ξ and p are divided by
        // a number, η and 1 − ψ² by its square: no power overflows.
        let (sign_xi, sign_slope) = (sign(plain.xi), sign(plain.slope));
        let size = one / plain.xi.abs().max(plain.slope.abs()).max(one);
        let xi = self.xi.scale(sign_xi * size);
        let p = self.slope.scale(sign_slope * size);
        let eta = self.eta.scale(sign(plain.eta) * size).scale(size);
        let q = (T::one() - self.psi).scale(size) * (T::one() + self.psi).scale(size);
        let r = q + p * p;
        // (so that nothing is divided by zero)
        let tiny = T::from_base(T::TINY);
        let falling = -r;
        let concave = Concave::either(
            falling,
            || Concave { slope: p, share: eta, floor: p * p + tiny, growth: falling },
            || Concave { slope: T::one(), share: p * p, floor: eta * eta + tiny, growth: r },
        );
        let root = concave.reaches(xi);
        let norm = T::one() / concave.norm(root);
        let near = xi.times(0.5) - root;
        // (of p ξ̄/√… and (ξ − ξ̄)/p the one whose digits are all there)
        let y =
            T::either(falling, || root, || T::either(near, || (xi - root) / p, || p * root * norm));
        let EdgePoint { y, c } = EdgePoint::either(
            near.max(-q),
            // (the root may lie beyond the edge of the contact)
            || EdgePoint::on_edge(y.min(T::one())),
            || {
                let c = (concave.floor + q * root * root).sqrt() * norm;
                // What is left of the error of the root takes the point off the circle.
                let scale = (y * y + c * c).times(-0.5).plus(1.5);
                EdgePoint { y: y * scale, c: c * scale }
            },
        );
        EdgePoint { y: y.scale(sign_xi * sign_slope), c }
    }
}

/// `−1` for negative numbers, else `1`.
#[inline(always)]
fn sign<F: Plain>(x: F) -> F {
    (-x).choose(-F::one(), F::one())
}

/// `h(u) = A u + B u/√(D² + R u²)`, rising and concave for `u ≥ 0`; all four not negative.
#[derive(Clone, Copy)]
struct Concave<T> {
    /// `A`
    slope: T,
    /// `B`
    share: T,
    /// `D²`
    floor: T,
    /// `R`
    growth: T,
}

impl<T: Number> Choice<T> for Concave<T> {
    #[inline(always)]
    fn chosen(by: T, yes: Self, no: Self) -> Self {
        Self {
            slope: by.choose(yes.slope, no.slope),
            share: by.choose(yes.share, no.share),
            floor: by.choose(yes.floor, no.floor),
            growth: by.choose(yes.growth, no.growth),
        }
    }
}

impl<T: Number> Concave<T> {
    /// `√(D² + R u²)`
    #[inline(always)]
    fn norm(&self, u: T) -> T {
        (self.floor + self.growth * u * u).sqrt()
    }

    /// `u` with `h(u) = ξ`. `h` lies below its tangents at zero and at infinity: from the larger of the two
    /// answers that they give, three steps of Halley's method leave less than 1e-13; two leave 1e-5, of which the
    /// place of the largest `C − κ` feels the square: enough in single precision.
    #[inline(always)]
    fn reaches(&self, xi: T) -> T {
        let plain = Concave {
            slope: self.slope.value(),
            share: self.share.value(),
            floor: self.floor.value(),
            growth: self.growth.value(),
        };
        let value = xi.value();
        let d = plain.floor.sqrt();
        let tiny = T::TINY;
        let at_zero = value * d / (plain.slope * d + plain.share + tiny);
        let at_infinity =
            (value - plain.share / (plain.growth + tiny).sqrt()) / (plain.slope + tiny);
        let start = at_zero.max(at_infinity);
        let mut closer = plain.halley(start, value);
        if size_of::<Stored<T>>() >= 8 {
            closer = plain.halley(closer, value);
        }
        self.halley(T::from_base(closer), xi)
    }

    /// One step of Halley's method on `h(u) − ξ`.
    #[inline(always)]
    fn halley(&self, u: T, xi: T) -> T {
        let norm = self.norm(u);
        let inverse = T::one() / norm;
        let cosine = u * inverse;
        // h' = A + B D²/n³,  h'' = −3 B D² R u/n⁵
        let bend = (self.share * inverse) * (self.floor * inverse * inverse);
        let slope = T::one() / (self.slope + bend + T::from_base(T::TINY));
        let step = (self.slope * u + self.share * cosine - xi) * slope;
        let curvature = (bend * slope) * (self.growth * cosine * inverse);
        // (the floor is never met; it keeps what rounding may do bounded)
        u - step / (T::one() + (step * curvature).times(1.5)).max(T::constant(0.125))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;
    use proptest::prelude::*;

    /// From the definition: `C − κ` at a place of the leading edge, `−∞` where no root of (5.41) exists.
    fn excess(family: &StripFamily<f64>, angle: f64) -> f64 {
        let (y, c) = angle.sin_cos();
        let xi_bar = family.xi_bar(y);
        let q = (1.0 - family.psi) * (1.0 + family.psi);
        let square = family.eta * family.eta + q * xi_bar * xi_bar;
        if square < 0.0 {
            return f64::NEG_INFINITY;
        }
        c - (xi_bar * xi_bar + family.eta * family.eta) / (square.sqrt() - family.eta * family.psi)
    }

    fn octaves(low: f64, high: f64) -> impl Strategy<Value = f64> {
        (low..high, any::<bool>()).prop_map(|(x, minus)| if minus { -x.exp2() } else { x.exp2() })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        /// No place is nearer to adhesion than the one that is found.
        #[test]
        fn nothing_is_nearer_than_the_nearest(
            xi in octaves(-7.0, 4.0),
            eta in octaves(-7.0, 4.0),
            psi in octaves(-7.0, -1e-3),
            ratio in -7.0..7.0_f64,
        ) {
            let slope = psi / ratio.exp2() / 0.72;
            let family = StripFamily { xi, slope, eta, psi };
            let point = family.nearest();
            assert_abs_diff_eq!(point.y * point.y + point.c * point.c, 1.0, epsilon = 1e-14);
            let found = excess(&family, point.y.atan2(point.c));
            for i in 1..200 {
                let angle = core::f64::consts::PI * (f64::from(i) / 200.0 - 0.5);
                prop_assert!(excess(&family, angle) <= found + 1e-12 * (1.0 + found.abs()), "{family:?} {point:?}");
            }
        }

        /// At the ends of the interval `κ = C`, short intervals included, and without one there is no adhesion.
        #[test]
        fn interval_ends_where_kappa_meets_the_edge(
            xi in octaves(-7.0, 2.0),
            angle in 0.01..core::f64::consts::TAU,
            psi in octaves(-7.0, -1e-3),
            ratio in -3.0..3.0_f64,
            nearness in -40.0..-1.0_f64,
        ) {
            let slope = psi / ratio.exp2() / 0.72;
            let ray = |t: f64| StripFamily { xi: t * xi * angle.cos(), slope, eta: t * xi * angle.sin(), psi };
            // Just before the last strip loses its adhesion area
            let (mut low, mut high) = (0.0, 1e6);
            for _ in 0..200 {
                let t = 0.5 * (low + high);
                let family = ray(t);
                let point = family.nearest();
                if excess(&family, point.y.atan2(point.c)) > 0.0 { low = t } else { high = t }
            }
            for (t, expected) in [(low * (1.0 - nearness.exp2()), true), (high * (1.0 + nearness.exp2()), false)] {
                let family = ray(t);
                let found = family.adhesion_interval();
                prop_assert_eq!(found.is_ok(), expected, "{:?}", family);
                let Ok(AdhesionInterval { lower, upper }) = found else { continue };
                let nearest = family.nearest();
                prop_assert!(lower.y <= nearest.y && nearest.y <= upper.y);
                // κ rises by up to p/√(1 − ψ²) times Y.
                let noise = 1e-14 * (1.0 + (slope / (1.0 - psi * psi).sqrt()).abs());
                let depth = excess(&family, nearest.y.atan2(nearest.c));
                for end in [lower, upper] {
                    let left = excess(&family, end.y.atan2(end.c));
                    prop_assert!(left.abs() <= 1e-6 * depth + noise, "{left:e} of {depth:e}: {family:?}");
                }
            }
        }
    }
}
