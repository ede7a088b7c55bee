//! Panels of strips: pieces of the contact in which one law holds, and the Gauss nodes on them.
//!
//! What a panel carries is linear in the weights of its strips, so strips are added up first and scaled
//! afterwards, by factors per panel that make the friction capacity `∫ C² dY` and, with adhesion, the
//! stretch `∫ C dY` exact. Nothing is stored per strip.

use crate::number::{Arithmetic, Choice, Elementary, Number, Pair, Plain, Stored};
use crate::strip_1967::leading_edge::{AdhesionLength, EdgePoint, StripFamily};
use crate::strip_1967::quadrature::Node;
use crate::strip_1967::strip::SlidingRule;
use core::f64::consts::PI;
use core::ops::{AddAssign, Neg};

/// A Gauss rule of any length: one piece of code serves every strip count.
pub(crate) type Nodes<F> = &'static [Node<F>];

/// Two plain numbers.
type Bare<T> = <<T as Arithmetic>::Base as Number>::Pair;

/// What strips carry.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shares<P> {
    /// `F_x/(μ N)`
    pub fx: P,
    /// `F_y/(μ N)`
    pub fy: P,
    /// `M_z/(μ N a)`, about the centre of the contact.
    pub mz: P,
    /// Share of the area of the contact that sticks.
    pub stick: P,
}

impl<P: Arithmetic> Shares<P> {
    pub(crate) fn zero() -> Self {
        Self { fx: P::zero(), fy: P::zero(), mz: P::zero(), stick: P::zero() }
    }
}

impl<P: Arithmetic> AddAssign for Shares<P> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        self.fx += other.fx;
        self.fy += other.fy;
        self.mz += other.mz;
        self.stick += other.stick;
    }
}

impl<P: Arithmetic> Neg for Shares<P> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { fx: -self.fx, fy: -self.fy, mz: -self.mz, stick: -self.stick }
    }
}

/// What strips without adhesion need to know of the contact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SlidingLaw<T: Number> {
    /// `ξ̄(Y)`, `η`, `ψ`
    pub family: StripFamily<T>,
    /// `1 − ν`
    pub compliance: T::Base,
    /// Which direction.
    pub rule: SlidingRule,
    /// `b/a`
    pub inverse_ratio: T::Base,
}

impl<T: Number> SlidingLaw<T> {
    /// Directions of sliding of a pair of strips with `ξ̄` and `C²`.
    #[inline(always)]
    fn direction(
        &self,
        family: &StripFamily<T::Pair>,
        xi_bar: T::Pair,
        c_squared: T::Pair,
    ) -> (T::Pair, T::Pair) {
        let eta = family.eta;
        let (x, y) = match self.rule {
            // w ~ ((1 − ν) ξ̄, η)
            SlidingRule::RigidSlip => (xi_bar.scale(self.compliance), eta),
            // w ~ (ξ̄, η + ψ C)
            SlidingRule::Continuous => {
                let c = c_squared.bare().max(Bare::<T>::tiny()).sqrt();
                let c = T::Pair::composed(c, [Bare::<T>::constant(0.5) / c], [c_squared]);
                (xi_bar, eta + family.psi * c)
            }
        };
        let (px, py) = (x.bare(), y.bare());
        let inverse = Bare::<T>::one() / (px * px + py * py + Bare::<T>::tiny()).sqrt();
        let (wx, wy) = (px * inverse, py * inverse);
        // dw = (w_y, −w_x) dα,  dα = (y dx − x dy)/(x² + y²)
        let turn = T::Pair::composed(Bare::<T>::zero(), [wy * inverse, -(wx * inverse)], [x, y]);
        (T::Pair::composed(wx, [wy], [turn]), T::Pair::composed(wy, [-wx], [turn]))
    }
}

/// Strips without adhesion on both sides: between `lower` and `Y = −1` (first of each pair), and
/// between `upper` and `Y = 1` (second). The first panel is mirrored, so that both run from `from` up to
/// the edge of the contact and `ξ̄ = ξ − p Y`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SlidingPanels<'a, T: Number> {
    law: &'a SlidingLaw<T>,
    family: StripFamily<T::Pair>,
    from: T::Pair,
    length: T::Pair,
    slope: T::Pair,
    /// `A` and `B` of the grading `Y = from + L s (A + B s²)`, `A + B = 1`.
    near: T::Pair,
    span: T::Pair,
}

/// A pair of sliding strips, or the sum of many; not yet scaled.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SlidingStrips<P> {
    /// Weight times `C²`
    share: P,
    fx: P,
    fy: P,
    /// `Y f_x`
    by_y: P,
}

impl<P: Arithmetic> SlidingStrips<P> {
    pub(crate) fn zero() -> Self {
        Self { share: P::zero(), fx: P::zero(), fy: P::zero(), by_y: P::zero() }
    }
}

impl<P: Arithmetic> AddAssign for SlidingStrips<P> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        self.share += other.share;
        self.fx += other.fx;
        self.fy += other.fy;
        self.by_y += other.by_y;
    }
}

/// Where a strip lies.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place<P> {
    /// `Y`
    pub y: P,
    /// `C²`
    pub c_squared: P,
}

impl<'a, T: Number> SlidingPanels<'a, T> {
    #[inline(always)]
    pub(crate) fn new(law: &'a SlidingLaw<T>, lower: EdgePoint<T>, upper: EdgePoint<T>) -> Self {
        let one = T::Pair::one();
        let from = T::Pair::of(-lower.y, upper.y);
        let edge = T::Pair::of(lower.c, upper.c);
        let slope = T::Pair::of(-law.family.slope, law.family.slope);
        let family = law.family.paired();
        let (xi, eta) = (family.xi, family.eta);
        // Length of the panel, 1 − Y, without cancellation next to the edge
        let beyond = one + from.abs();
        let length = from.choose(edge * edge / beyond, beyond);
        // A is the distance in slip from the strip where it turns, B the slip that the panel spans
        let z = (xi - slope * from).scale(law.compliance);
        // (a floor, so that the derivative at zero creepage is finite)
        let floor = T::Pair::from_base(T::ROOT_TINY);
        let near = (eta * eta + z * z + floor).sqrt().times(2.0);
        let span = (slope * length).scale(law.compliance).abs();
        let scale = (near + span).inverse();
        Self { law, family, from, length, slope, near: near * scale, span: span * scale }
    }

    /// The strips at a node.
    #[inline(always)]
    pub(crate) fn at(&self, node: &Node<Stored<T>>) -> (Place<T::Pair>, SlidingStrips<T::Pair>) {
        let (node, weight) = (T::Base::stored(node.0), T::Base::stored(node.1));
        let one = Bare::<T>::one();
        // [-1, 1] → [0, 1]
        let s = node.times(0.5).plus(0.5);
        let square = s * s;
        let (near, span) = (self.near.bare(), self.span.bare());
        let (from, length) = (self.from.bare(), self.length.bare());
        let g = (near + span.scale(square)).scale(s);
        let place = from + length * g;
        let c_squared = length * (one - g) * (one + place);
        let width = (near + span.scale(square.times(3.0))).scale(weight);
        let share = c_squared * width;
        // L = 1 − from and B = 1 − A:  dY = (1 − g) dfrom + L (s − s³) dA,  d(C²) = −2 Y dY
        let rest = <T::Base as Arithmetic>::one() - square;
        let y = T::Pair::composed(place, [one - g, length.scale(s * rest)], [self.from, self.near]);
        let arm = -(place + place);
        let bend = c_squared.scale((rest - (square + square)) * weight);
        let c_squared = T::Pair::composed(c_squared, [arm], [y]);
        let share = T::Pair::composed(share, [width, bend], [c_squared, self.near]);
        let xi_bar = self.family.xi - self.slope * y;
        let (wx, wy) = self.law.direction(&self.family, xi_bar, c_squared);
        let fx = share * wx;
        (Place { y, c_squared }, SlidingStrips { share, fx, fy: share * wy, by_y: y * fx })
    }

    /// All of them.
    #[inline(always)]
    pub(crate) fn sum(&self, nodes: Nodes<Stored<T>>) -> SlidingStrips<T::Pair> {
        if T::HAS_DERIVATIVES { self.sum_apart(nodes) } else { self.sum_here(nodes) }
    }

    /// (With derivatives the panels' numbers are many: read from memory, not held in registers.)
    #[inline(never)]
    fn sum_apart(&self, nodes: Nodes<Stored<T>>) -> SlidingStrips<T::Pair> {
        self.sum_here(nodes)
    }

    #[inline(always)]
    fn sum_here(&self, nodes: Nodes<Stored<T>>) -> SlidingStrips<T::Pair> {
        let mut sum = SlidingStrips::zero();
        for node in nodes {
            sum += self.at(node).1;
        }
        sum
    }

    /// `(3/4) ∫ C² dY` over its sum: the factor that the strips are scaled with.
    #[inline(always)]
    pub(crate) fn scale(&self, sum: &SlidingStrips<T::Pair>) -> T::Pair {
        let length = self.length;
        let capacity = length * length * (T::Pair::one() - length.times(1.0 / 3.0));
        capacity.times(0.75) / (sum.share + T::Pair::tiny())
    }

    /// What strips, or all of them, carry.
    #[inline(always)]
    pub(crate) fn shares(
        &self,
        strips: &SlidingStrips<T::Pair>,
        scale: T::Pair,
    ) -> Shares<T::Pair> {
        let arm = T::Pair::of(T::one(), -T::one()).scale(self.law.inverse_ratio);
        Shares {
            fx: strips.fx * scale,
            fy: strips.fy * scale,
            mz: strips.by_y * scale * arm,
            stick: T::Pair::zero(),
        }
    }

    /// `Y` of a place, the first panel no longer mirrored.
    #[inline(always)]
    pub(crate) fn unmirrored(y: T::Pair) -> T::Pair {
        y * T::Pair::of(-T::one(), T::one())
    }

    /// Width that strips stand for.
    #[inline(always)]
    pub(crate) fn width(
        place: &Place<T::Pair>,
        strips: &SlidingStrips<T::Pair>,
        scale: T::Pair,
    ) -> T::Pair {
        (strips.share * scale).times(4.0 / 3.0) / (place.c_squared + T::Pair::tiny())
    }
}

/// Strips with adhesion along an arc of the leading edge, in pairs that lie symmetrically about its
/// middle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AdhesionPanel<'a, T: Number> {
    law: &'a SlidingLaw<T>,
    family: StripFamily<T::Pair>,
    length: AdhesionLength<T::Pair>,
    arc: Arc<T>,
}

/// A pair of strips with adhesion.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AdhesionStrip<P> {
    pub y: P,
    pub c: P,
    pub width: P,
    pub kappa: P,
    xi_bar: P,
}

/// Sums over strips with adhesion, not yet scaled.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AdhesionSum<P> {
    /// `Σ C w`
    stretch: P,
    /// `Σ C² w`
    capacity: P,
    /// `Σ (2C − K) w`
    reach: P,
    /// `Σ ξ̄ (2C − K) w`
    fx: P,
    /// `Σ Y ξ̄ (2C − K) w`
    by_y: P,
    /// `Σ (C − K)² w`
    lever: P,
    /// `Σ (C − K) w`
    stuck: P,
}

impl<P: Arithmetic> AdhesionStrip<P> {
    #[inline(always)]
    pub(crate) fn terms(&self) -> AdhesionSum<P> {
        let stretch = self.c * self.width;
        let stuck = self.c - self.kappa;
        let reach = (self.c + stuck) * self.width;
        let fx = self.xi_bar * reach;
        AdhesionSum {
            stretch,
            capacity: self.c * stretch,
            reach,
            fx,
            by_y: self.y * fx,
            lever: stuck * stuck * self.width,
            stuck: stuck * self.width,
        }
    }
}

impl<P: Arithmetic> AdhesionSum<P> {
    pub(crate) fn zero() -> Self {
        let zero = P::zero();
        Self {
            stretch: zero,
            capacity: zero,
            reach: zero,
            fx: zero,
            by_y: zero,
            lever: zero,
            stuck: zero,
        }
    }
}

impl<P: Arithmetic> AddAssign for AdhesionSum<P> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        self.stretch += other.stretch;
        self.capacity += other.capacity;
        self.reach += other.reach;
        self.fx += other.fx;
        self.by_y += other.by_y;
        self.lever += other.lever;
        self.stuck += other.stuck;
    }
}

/// `3/4` of the factors that make the stretch and the capacity of an adhesion panel exact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scales<P> {
    stretch: P,
    capacity: P,
}

impl<'a, T: Number + Elementary> AdhesionPanel<'a, T> {
    #[inline(always)]
    pub(crate) fn new(law: &'a SlidingLaw<T>, lower: EdgePoint<T>, upper: EdgePoint<T>) -> Self {
        let length = AdhesionLength::of(&law.family, law.family.cancels());
        Self {
            law,
            family: law.family.paired(),
            length: length.paired(),
            arc: Arc::between(lower, upper),
        }
    }

    /// The strips at a node.
    #[inline(always)]
    pub(crate) fn at(&self, node: &Node<Stored<T>>) -> AdhesionStrip<T::Pair> {
        let (y, c, width) = self.arc.at(node);
        let xi_bar = self.family.xi_bar(y);
        AdhesionStrip { y, c, width, kappa: self.length.at(xi_bar).min(c), xi_bar }
    }

    /// All of them.
    #[inline(always)]
    fn sum(&self, nodes: Nodes<Stored<T>>) -> AdhesionSum<T::Pair> {
        if T::HAS_DERIVATIVES { self.sum_apart(nodes) } else { self.sum_here(nodes) }
    }

    #[inline(never)]
    fn sum_apart(&self, nodes: Nodes<Stored<T>>) -> AdhesionSum<T::Pair> {
        self.sum_here(nodes)
    }

    #[inline(always)]
    fn sum_here(&self, nodes: Nodes<Stored<T>>) -> AdhesionSum<T::Pair> {
        let mut sum = AdhesionSum::zero();
        for node in nodes {
            sum += self.at(node).terms();
        }
        sum
    }

    /// What all of them carry, and their factors.
    #[cfg_attr(target_os = "none", inline(never))]
    #[cfg_attr(not(target_os = "none"), inline(always))]
    pub(crate) fn carried(&self, nodes: Nodes<Stored<T>>) -> (Shares<T::Pair>, Scales<T::Pair>) {
        let sum = self.sum(nodes);
        let scales = self.scales(&sum);
        (self.shares(&sum, &scales), scales)
    }

    /// Factors for strips whose sum is `sum`.
    #[inline(always)]
    fn scales(&self, sum: &AdhesionSum<T::Pair>) -> Scales<T::Pair> {
        let (stretch, capacity) = (sum.stretch.sum(), sum.capacity.sum());
        let (exact_stretch, exact_capacity) = self.arc.integrals();
        let epsilon = T::from_base(T::EPSILON);
        let ratio = |exact: T, sum: T| {
            let ratio = T::either(sum - epsilon, || exact / sum, T::one);
            T::Pair::both(ratio.times(0.75))
        };
        Scales { stretch: ratio(exact_stretch, stretch), capacity: ratio(exact_capacity, capacity) }
    }

    /// What strips, or all of them, carry.
    #[inline(always)]
    pub(crate) fn shares(
        &self,
        sum: &AdhesionSum<T::Pair>,
        scales: &Scales<T::Pair>,
    ) -> Shares<T::Pair> {
        let StripFamily { eta, psi, .. } = self.family;
        Shares {
            // f_x = ξ̄ (2C − K),  f_y = ψ C² + η (2C − K)
            fx: sum.fx * scales.stretch,
            fy: psi * (sum.capacity * scales.capacity) + eta * (sum.reach * scales.stretch),
            // M_z = a m_x − b Y f_x,  m_x = −η (C − K)²
            mz: -(eta * (sum.lever * scales.capacity))
                - (sum.by_y * scales.stretch).scale(self.law.inverse_ratio),
            stick: (sum.stuck * scales.stretch).times(8.0 / (3.0 * PI)),
        }
    }

    /// What the strips would carry if they slid, not yet scaled.
    #[inline(always)]
    pub(crate) fn slid(&self, strip: &AdhesionStrip<T::Pair>) -> SlidingStrips<T::Pair> {
        let c_squared = strip.c * strip.c;
        let share = c_squared * strip.width;
        let (wx, wy) = self.law.direction(&self.family, strip.xi_bar, c_squared);
        let fx = share * wx;
        SlidingStrips { share, fx, fy: share * wy, by_y: strip.y * fx }
    }

    /// The same, scaled: strips that slide carry the friction capacity.
    #[inline(always)]
    pub(crate) fn slid_shares(
        &self,
        strips: &SlidingStrips<T::Pair>,
        scales: &Scales<T::Pair>,
    ) -> Shares<T::Pair> {
        Shares {
            fx: strips.fx * scales.capacity,
            fy: strips.fy * scales.capacity,
            mz: -(strips.by_y * scales.capacity).scale(self.law.inverse_ratio),
            stick: T::Pair::zero(),
        }
    }
}

/// A piece of the leading edge, as an arc of the unit circle `Y = sin θ`, `C = cos θ`.
#[derive(Clone, Copy, Debug)]
struct Arc<T: Number> {
    lower: EdgePoint<T>,
    upper: EdgePoint<T>,
    /// The point half-way.
    middle: EdgePoint<T>,
    /// `tan(Δθ/4)`, 0 to 1.
    quarter_tangent: T,
    /// The same twice.
    quarters: T::Pair,
    /// The derivatives of the angle of the middle.
    middle_angle: T::Pair,
}

impl<T: Number + Elementary> Arc<T> {
    #[inline(always)]
    fn between(lower: EdgePoint<T>, upper: EdgePoint<T>) -> Self {
        let (dy, dc) = (upper.y - lower.y, upper.c - lower.c);
        let (sy, sc) = (upper.y + lower.y, upper.c + lower.c);
        // 2 sin(Δθ/2), 2 cos(Δθ/2): the chord and the sum of the two unit vectors
        let lengths = T::Pair::of(dy, sy).squared() + T::Pair::of(dc, sc).squared();
        let (chord, along) = (lengths + T::Pair::tiny()).sqrt().parts();
        // Both the sum and the normal of the chord point to the middle; together they never vanish.
        let scale = (chord + along).inverse();
        let middle = EdgePoint { y: (sy - dc) * scale, c: (sc + dy) * scale };
        let (y, c) = (T::Pair::both(middle.y), T::Pair::both(middle.c));
        let quarter_tangent = chord / along.plus(2.0);
        Self {
            lower,
            upper,
            middle,
            quarter_tangent,
            quarters: T::Pair::both(quarter_tangent),
            middle_angle: T::Pair::composed(Bare::<T>::zero(), [c.bare(), -y.bare()], [y, c]),
        }
    }

    /// `Y`, `C` and width at a node in `t = tan(φ/2)` about the middle, where `cos φ` and `sin φ` are
    /// rational; `−t` and `t` side by side.
    #[inline(always)]
    fn at(&self, node: &Node<Stored<T>>) -> (T::Pair, T::Pair, T::Pair) {
        let (node, weight) = (T::Base::stored(node.0), T::Base::stored(node.1));
        let one = <T::Base as Arithmetic>::one();
        let [middle_y, middle_c] =
            [self.middle.y, self.middle.c].map(|x| Bare::<T>::both(x.value()));
        let quarter = self.quarter_tangent.value();
        let t = quarter * node;
        let scale = one / (one + t * t);
        let cosine = (one - t * t) * scale;
        let sine = (t * scale).times(2.0);
        let (cosine_both, sine) = (Bare::<T>::both(cosine), Bare::<T>::of(-sine, sine));
        let c = middle_c * cosine_both - middle_y * sine;
        let y = middle_y * cosine_both + middle_c * sine;
        // dY = C dφ,  dφ = 2 dt/(1 + t²)
        let turn = (quarter * scale) * weight.times(2.0);
        let width = c * Bare::<T>::both(turn);
        // Derivatives: dY = C dθ and dC = −Y dθ,  dθ = dθ_middle ± dφ,  d(q scale) = cos φ scale dq
        let growth = (scale * node).times(2.0);
        let quarters = self.quarters;
        let angle = T::Pair::composed(
            Bare::<T>::zero(),
            [Bare::<T>::one(), Bare::<T>::of(-growth, growth)],
            [self.middle_angle, quarters],
        );
        let widening = c.scale((scale * cosine) * weight.times(2.0));
        let place = T::Pair::composed(y, [c], [angle]);
        let c_dual = T::Pair::composed(c, [-y], [angle]);
        let width = T::Pair::composed(width, [Bare::<T>::both(turn), widening], [c_dual, quarters]);
        (place, c_dual, width)
    }

    /// `∫ C dY` and `∫ C² dY`
    #[inline(always)]
    fn integrals(&self) -> (T, T) {
        let (lower, upper) = (self.lower, self.upper);
        // ∫ C dY = ∫ C² dθ = (Δθ + Y₂C₂ − Y₁C₁)/2
        let angle = self.quarter_tangent.atan().times(4.0);
        let stretch = (angle + (upper.y * upper.c - lower.y * lower.c)).times(0.5);
        // ∫ C² dY = ΔY (1 − (Y₁² + Y₁Y₂ + Y₂²)/3)
        let squares = lower.y * lower.y + lower.y * upper.y + upper.y * upper.y;
        let capacity = (upper.y - lower.y) * (T::one() - squares.times(1.0 / 3.0));
        (stretch, capacity)
    }
}
