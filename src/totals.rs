//! Total forces of the strip theory of 1967 by quadrature over strips (Section 7).
//!
//! `(F_x, F_y)/(μ N) = (3/4) ∫ (f_x, f_y) dY`. The strips are placed where the solution needs them:
//! Gauss panels between the edges of the contact and the points where the separatrix meets the
//! leading edge, so that no strip ever changes its regime and the totals are a continuous function
//! of the creepages for every strip count.
//!
//! * Each panel keeps its number of strips, however short it becomes; panels appear and vanish with
//!   zero length.
//! * Adhesion panels run along the leading edge itself: with `t = tan(θ/4)`-type coordinates about
//!   the middle of the panel, `Y` and `C` are rational and the square-root ends of `C` are smooth.
//! * Sliding panels are graded towards the strip where the rigid slip turns (`ξ̄ = 0`), over the
//!   distance in which it turns.
//! * Weights are scaled per panel so that the friction capacity `∫ C² dY` and, with adhesion, the
//!   stretch `∫ C dY` are exact: saturation and linear slopes come out to rounding with any count.

use crate::creepage::Parameters;
use crate::leading_edge::{AdhesionInterval, AdhesionLength, EdgePoint, StripFamily};
use crate::quadrature::{Rule, Tabulated};
use crate::real::{Arithmetic, Pair, Real};
use crate::strip::SlidingRule;

/// Total force and moment of a contact, dimensionless.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Totals<T> {
    /// `F_x/(μ N)`
    pub fx: T,
    /// `F_y/(μ N)`
    pub fy: T,
    /// `M_z/(μ N √(ab))`, about the centre
    pub mz: T,
    /// Share of the contact area in adhesion, 0 to 1.
    pub stick: T,
}

/// How many strips share the patch. Error against the closed form falls geometrically with the
/// count; cost is proportional to it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(i32)]
pub enum StripCount {
    /// 4 strips: shape of the creep curve only.
    Four = 4,
    /// 8 strips.
    Eight = 8,
    /// 16 strips: the recommended count.
    #[default]
    Sixteen = 16,
    /// 32 strips.
    ThirtyTwo = 32,
    /// 64 strips: reference quality.
    SixtyFour = 64,
}

impl StripCount {
    /// The count for a number, if it is one of the fixed counts.
    #[must_use]
    pub const fn from_number(number: i32) -> Option<Self> {
        Some(match number {
            4 => Self::Four,
            8 => Self::Eight,
            16 => Self::Sixteen,
            32 => Self::ThirtyTwo,
            64 => Self::SixtyFour,
            _ => return None,
        })
    }
}

/// One strip as the quadrature placed it, dimensionless.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedStrip<T> {
    /// `Y = y/b` of the centre line.
    pub y: T,
    /// Half length `C = c/a`.
    pub half_length: T,
    /// Width in `Y` that the strip stands for.
    pub width: T,
    /// Length from the trailing edge to the separatrix over two, `κ/a`; `C` when it slides.
    pub kappa: T,
    /// Whether it has an adhesion area.
    pub adheres: bool,
    /// Its share of `F_x/(μ N)`.
    pub fx: T,
    /// Its share of `F_y/(μ N)`.
    pub fy: T,
    /// Its share of `M_z/(μ N a)`, about the centre of the contact.
    pub mz: T,
    /// Its share of the stick area.
    pub stick: T,
}

/// The strip theory of 1967 for one contact and creepage.
#[derive(Clone, Copy, Debug)]
pub struct StripTheory<T: Real> {
    family: StripFamily<T>,
    poisson_ratio: T::Base,
    axis_ratio: T::Base,
    rule: SlidingRule,
}

/// The strips of one or two panels in pairs, component by component: what is not asked for is not
/// computed.
#[derive(Clone, Copy, Debug)]
struct Panel<P, const M: usize> {
    y: [P; M],
    half_length: [P; M],
    width: [P; M],
    kappa: [P; M],
    fx: [P; M],
    fy: [P; M],
    /// About the centre, units of `a`.
    mz: [P; M],
    stick: [P; M],
    adheres: bool,
}

/// What is done with the panels of a solution.
trait Sink<T: Real> {
    fn take<const M: usize>(&mut self, panel: Panel<T::Pair, M>);
}

/// Adds the strips up.
struct Sum<P> {
    fx: P,
    fy: P,
    mz: P,
    stick: P,
}

impl<T: Real> Sink<T> for Sum<T::Pair> {
    #[inline(always)]
    fn take<const M: usize>(&mut self, panel: Panel<T::Pair, M>) {
        self.fx += total(&panel.fx);
        self.fy += total(&panel.fy);
        self.mz += total(&panel.mz);
        if panel.adheres {
            self.stick += total(&panel.stick);
        }
    }
}

/// Hands the strips on, one by one.
struct Visitor<'a, T>(&'a mut dyn FnMut(PlacedStrip<T>));

impl<T: Real> Sink<T> for Visitor<'_, T> {
    fn take<const M: usize>(&mut self, panel: Panel<T::Pair, M>) {
        let pick = |pair: T::Pair, second: bool| {
            let parts = pair.parts();
            if second { parts.1 } else { parts.0 }
        };
        for second in [false, true] {
            for i in 0..M {
                (self.0)(PlacedStrip {
                    y: pick(panel.y[i], second),
                    half_length: pick(panel.half_length[i], second),
                    width: pick(panel.width[i], second),
                    kappa: pick(panel.kappa[i], second),
                    adheres: panel.adheres,
                    fx: pick(panel.fx[i], second),
                    fy: pick(panel.fy[i], second),
                    mz: pick(panel.mz[i], second),
                    stick: pick(panel.stick[i], second),
                });
            }
        }
    }
}

impl<T: Real> StripTheory<T>
where
    T::Base: Tabulated,
{
    /// Set up the theory with one of its sliding rules.
    #[must_use]
    pub fn new(parameters: &Parameters<T>, rule: SlidingRule) -> Self {
        Self {
            family: StripFamily {
                xi: parameters.xi,
                slope: parameters.spin_slope(),
                eta: parameters.eta,
                psi: parameters.psi,
            },
            poisson_ratio: parameters.poisson_ratio,
            axis_ratio: parameters.axis_ratio,
            rule,
        }
    }

    /// Whether the spin is inside the theory, `|ψ| < 1`.
    #[must_use]
    pub fn spin_in_range(&self) -> bool {
        self.family.psi.value().abs() < T::Base::one()
    }

    /// Total force, moment and stick area with a fixed number of strips.
    #[must_use]
    pub fn totals(&self, count: StripCount) -> Totals<T> {
        let zero = T::Pair::zero();
        let mut pairs = Sum { fx: zero, fy: zero, mz: zero, stick: zero };
        self.place(count, &mut pairs);
        let sum = Sum {
            fx: pairs.fx.sum(),
            fy: pairs.fy.sum(),
            mz: pairs.mz.sum(),
            stick: pairs.stick.sum(),
        };
        // Friction capacity is exact, stretch is exact, their mixture with few strips is not: keep
        // |F| ≤ μ N.
        let size = sum.fx * sum.fx + sum.fy * sum.fy;
        let bound = if size > T::one() { T::one() / size.sqrt() } else { T::one() };
        Totals {
            fx: sum.fx * bound,
            fy: sum.fy * bound,
            // a = √(ab) √(a/b)
            mz: sum.mz.scale(self.axis_ratio.sqrt()),
            stick: sum.stick.clamped(T::zero(), T::one()),
        }
    }

    /// Hand every strip of a fixed count to `visit`. The sum of the shares is the total. For
    /// `|ψ| > 1` strips beyond the count may follow that correct pieces of the adhesion interval
    /// which slide (their widths are negative where they take adhesion away).
    pub fn strips(&self, count: StripCount, visit: &mut dyn FnMut(PlacedStrip<T>)) {
        self.place(count, &mut Visitor(visit));
    }

    #[inline(always)]
    fn place(&self, count: StripCount, sink: &mut impl Sink<T>) {
        type B<T> = <T as Arithmetic>::Base;
        match count {
            StripCount::Four => {
                self.panels(&B::<T>::GAUSS_1, &B::<T>::MIRRORED_2, false, sink);
            }
            StripCount::Eight => {
                self.panels(&B::<T>::GAUSS_2, &B::<T>::MIRRORED_4, false, sink);
            }
            StripCount::Sixteen => {
                self.panels(&B::<T>::GAUSS_5, &B::<T>::MIRRORED_6, false, sink);
            }
            StripCount::ThirtyTwo => {
                self.panels(&B::<T>::GAUSS_8, &B::<T>::MIRRORED_8, true, sink);
            }
            StripCount::SixtyFour => {
                self.panels(&B::<T>::GAUSS_16, &B::<T>::MIRRORED_16, true, sink);
            }
        }
    }

    /// Sliding – adhesion – sliding; `split` divides the adhesion interval where `ξ̄ = 0`.
    #[inline(always)]
    fn panels<const S: usize, const A: usize>(
        &self,
        slide: &Rule<T::Base, S>,
        stick: &Rule<T::Base, A>,
        split: bool,
        sink: &mut impl Sink<T>,
    ) {
        match self.family.adhesion_interval() {
            Ok(AdhesionInterval { lower, upper }) => {
                sink.take(self.sliding_panels(slide, lower, upper));
                if split {
                    let middle = self.turning_strip(lower, upper);
                    sink.take(self.adhesion_panel(stick, lower, middle));
                    sink.take(self.adhesion_panel(stick, middle, upper));
                } else {
                    sink.take(self.adhesion_panel(stick, lower, upper));
                }
                if !self.spin_in_range() {
                    self.corrections(stick, &AdhesionInterval { lower, upper }, sink);
                }
            }
            Err(nearest) => sink.take(self.sliding_panels(slide, nearest, nearest)),
        }
    }

    /// For `|ψ| > 1`: pieces of the adhesion interval slide after all.
    #[cold]
    #[inline(never)]
    fn corrections<const A: usize>(
        &self,
        stick: &Rule<T::Base, A>,
        interval: &AdhesionInterval<T>,
        sink: &mut impl Sink<T>,
    ) {
        for piece in &self.family.excluded(interval) {
            sink.take(self.adhesion_panel(stick, piece.lower, piece.upper).negated());
            sink.take(self.sliding_piece(stick, piece.lower, piece.upper));
        }
    }

    /// The strip with `ξ̄ = 0`, or the end of the interval nearest to it.
    fn turning_strip(&self, lower: EdgePoint<T>, upper: EdgePoint<T>) -> EdgePoint<T> {
        let StripFamily { xi, slope, .. } = self.family;
        if !(xi.abs() < slope.abs()) {
            return if xi * slope < T::zero() { lower } else { upper };
        }
        let y = xi / slope;
        if y <= lower.y {
            lower
        } else if y >= upper.y {
            upper
        } else {
            EdgePoint { y, c: ((T::one() - y) * (T::one() + y)).sqrt() }
        }
    }

    /// Directions of sliding of a pair of strips with `ξ̄` and `C²`.
    #[inline(always)]
    fn direction(&self, xi_bar: T::Pair, c_squared: T::Pair) -> (T::Pair, T::Pair) {
        let eta = T::Pair::both(self.family.eta);
        let (x, y) = match self.rule {
            // w ~ ((1 − ν) ξ̄, η)
            SlidingRule::RigidSlip => (xi_bar.scale(T::Base::one() - self.poisson_ratio), eta),
            // w ~ (ξ̄, η + ψ C)
            SlidingRule::Continuous => {
                let c = c_squared.max(T::Pair::tiny()).sqrt();
                (xi_bar, eta + T::Pair::both(self.family.psi) * c)
            }
        };
        let inverse = T::Pair::one() / (x * x + y * y + T::Pair::tiny()).sqrt();
        (x * inverse, y * inverse)
    }

    /// Strips without adhesion on both sides: between `lower` and `Y = −1` (first of each pair), and
    /// between `upper` and `Y = 1` (second).
    #[inline(always)]
    fn sliding_panels<const S: usize>(
        &self,
        rule: &Rule<T::Base, S>,
        lower: EdgePoint<T>,
        upper: EdgePoint<T>,
    ) -> Panel<T::Pair, S> {
        let (one, tiny, zero) = (T::Pair::one(), T::Pair::tiny(), T::Pair::zero());
        // The first panel mirrored, so that both run from `from` up to 1 and ξ̄ = ξ − p Y.
        let from = T::Pair::of(-lower.y, upper.y);
        let edge = T::Pair::of(lower.c, upper.c);
        let xi = T::Pair::both(self.family.xi);
        let slope = T::Pair::of(-self.family.slope, self.family.slope);
        let eta = T::Pair::both(self.family.eta);
        // Length of the panel, 1 − Y, without cancellation next to the edge
        let beyond = one + from.abs();
        let length = from.choose(edge * edge / beyond, beyond);
        // ∫ C² dY over the panel
        let capacity = length * length * (one - length.times(1.0 / 3.0));
        // Grading Y = end + L s (A + B s²)/(A + B): A is the distance in slip from the strip where
        // it turns, B the slip that the panel spans.
        let compliance = T::Base::one() - self.poisson_ratio;
        let z = (xi - slope * from).scale(compliance);
        // (a floor, so that the derivative at zero creepage is finite)
        let floor = T::Pair::from_base(T::ROOT_TINY);
        let near = (eta * eta + z * z + floor).sqrt().times(2.0);
        let span = (slope * length).scale(compliance).abs();
        let scale = one / (near + span);
        let (near, span) = (near * scale, span * scale);

        let (mut y, mut c_squared, mut share) = ([zero; S], [zero; S], [zero; S]);
        let (mut wx, mut wy) = ([zero; S], [zero; S]);
        for i in 0..S {
            // [-1, 1] → [0, 1]
            let s = rule.nodes[i].times(0.5).plus(0.5);
            let square = s * s;
            let g = (near + span.scale(square)).scale(s);
            y[i] = from + length * g;
            c_squared[i] = length * (one - g) * (one + y[i]);
            share[i] = c_squared[i] * (near + span.scale(square.times(3.0))).scale(rule.weights[i]);
            (wx[i], wy[i]) = self.direction(xi - slope * y[i], c_squared[i]);
        }
        let normalised = capacity.times(0.75) / (total(&share) + tiny);
        let inverse_ratio =
            T::Pair::of(T::one(), -T::one()).scale(T::Base::one() / self.axis_ratio);
        let mirror = T::Pair::of(-T::one(), T::one());
        let mut panel = Panel::sliding(y, c_squared, share);
        for i in 0..S {
            let share = share[i] * normalised;
            panel.fx[i] = share * wx[i];
            panel.fy[i] = share * wy[i];
            panel.mz[i] = y[i] * panel.fx[i] * inverse_ratio;
            panel.y[i] = y[i] * mirror;
            panel.width[i] = share.times(4.0 / 3.0) / (c_squared[i] + tiny);
        }
        panel
    }

    /// Strips with adhesion along the arc of the leading edge from `lower` to `upper`, in pairs that
    /// lie symmetrically about its middle.
    #[inline(always)]
    fn adhesion_panel<const A: usize>(
        &self,
        rule: &Rule<T::Base, A>,
        lower: EdgePoint<T>,
        upper: EdgePoint<T>,
    ) -> Panel<T::Pair, A> {
        let arc = Arc::between(lower, upper);
        let nodes = arc.nodes(rule);
        let (stretch, capacity) = arc.scales(&nodes);
        let (stretch, capacity) =
            (T::Pair::both(stretch.times(0.75)), T::Pair::both(capacity.times(0.75)));
        let StripFamily { eta, psi, .. } = self.family.paired();
        let inverse_ratio = T::Base::one() / self.axis_ratio;
        let zero = [T::Pair::zero(); A];
        let mut panel = Panel {
            y: nodes.y,
            half_length: nodes.c,
            width: nodes.width,
            kappa: zero,
            fx: zero,
            fy: zero,
            mz: zero,
            stick: zero,
            adheres: true,
        };
        let family = self.family.paired();
        let length = AdhesionLength::of(&family, self.family.cancels());
        for i in 0..A {
            let (y, c) = (nodes.y[i], nodes.c[i]);
            let xi_bar = family.xi_bar(y);
            let kappa = length.at(xi_bar).min(c);
            let (by_stretch, by_capacity) = (nodes.width[i] * stretch, nodes.width[i] * capacity);
            // f_x = ξ̄ (2C − K),  f_y = ψ C² + η (2C − K)
            let stuck = c - kappa;
            let reach = (c + stuck) * by_stretch;
            panel.kappa[i] = kappa;
            panel.fx[i] = xi_bar * reach;
            panel.fy[i] = psi * (c * c * by_capacity) + eta * reach;
            // M_z = a m_x − b Y f_x,  m_x = −η (C − K)²
            panel.mz[i] =
                -(eta * stuck * stuck * by_capacity) - (y * panel.fx[i]).scale(inverse_ratio);
            panel.stick[i] = (stuck * by_stretch).times(8.0 / (3.0 * core::f64::consts::PI));
        }
        panel
    }

    /// Strips that slide although they lie inside the adhesion interval (`|ψ| > 1` only).
    fn sliding_piece<const A: usize>(
        &self,
        rule: &Rule<T::Base, A>,
        lower: EdgePoint<T>,
        upper: EdgePoint<T>,
    ) -> Panel<T::Pair, A> {
        let arc = Arc::between(lower, upper);
        let nodes = arc.nodes(rule);
        let (_, scale) = arc.scales(&nodes);
        let scale = T::Pair::both(scale.times(0.75));
        let family = self.family.paired();
        let inverse_ratio = T::Base::one() / self.axis_ratio;
        let c_squared = nodes.c.map(|c| c * c);
        let mut panel = Panel::sliding(nodes.y, c_squared, nodes.width);
        for (i, &c_squared) in c_squared.iter().enumerate() {
            let share = c_squared * nodes.width[i] * scale;
            let (wx, wy) = self.direction(family.xi_bar(nodes.y[i]), c_squared);
            panel.fx[i] = share * wx;
            panel.fy[i] = share * wy;
            panel.mz[i] = -(nodes.y[i] * panel.fx[i]).scale(inverse_ratio);
        }
        panel
    }
}

/// The sum of an array.
#[inline(always)]
fn total<P: Arithmetic, const M: usize>(terms: &[P; M]) -> P {
    let mut sum = P::zero();
    for &term in terms {
        sum += term;
    }
    sum
}

impl<P: Arithmetic, const M: usize> Panel<P, M> {
    /// Sliding strips, forces still zero.
    #[inline(always)]
    fn sliding(y: [P; M], c_squared: [P; M], width: [P; M]) -> Self {
        let half_length = c_squared.map(|square| square.max(P::zero()).sqrt());
        let zero = [P::zero(); M];
        Self {
            y,
            half_length,
            width,
            kappa: half_length,
            fx: zero,
            fy: zero,
            mz: zero,
            stick: zero,
            adheres: false,
        }
    }

    /// The same strips taken away.
    fn negated(mut self) -> Self {
        for list in [&mut self.width, &mut self.fx, &mut self.fy, &mut self.mz, &mut self.stick] {
            for value in list {
                *value = -*value;
            }
        }
        self
    }
}

/// A piece of the leading edge, as an arc of the unit circle `Y = sin θ`, `C = cos θ`.
struct Arc<T> {
    lower: EdgePoint<T>,
    upper: EdgePoint<T>,
    /// The point half-way.
    middle: EdgePoint<T>,
    /// `tan(Δθ/4)`, 0 to 1.
    quarter_tangent: T,
}

struct ArcNodes<P, const A: usize> {
    y: [P; A],
    c: [P; A],
    width: [P; A],
}

impl<T: Real> Arc<T> {
    #[inline(always)]
    fn between(lower: EdgePoint<T>, upper: EdgePoint<T>) -> Self {
        let (dy, dc) = (upper.y - lower.y, upper.c - lower.c);
        let (sy, sc) = (upper.y + lower.y, upper.c + lower.c);
        // 2 sin(Δθ/2), 2 cos(Δθ/2): the chord and the sum of the two unit vectors
        let lengths = T::Pair::of(dy, sy).squared() + T::Pair::of(dc, sc).squared();
        let (chord, along) = (lengths + T::Pair::tiny()).sqrt().parts();
        // Both the sum and the normal of the chord point to the middle; together they never vanish.
        let scale = T::one() / (chord + along);
        Self {
            lower,
            upper,
            middle: EdgePoint { y: (sy - dc) * scale, c: (sc + dy) * scale },
            quarter_tangent: chord / (along.plus(2.0)),
        }
    }

    /// Nodes in `t = tan(φ/2)` about the middle, where `cos φ` and `sin φ` are rational; `−t` and `t`
    /// side by side.
    #[inline(always)]
    fn nodes<const A: usize>(&self, rule: &Rule<T::Base, A>) -> ArcNodes<T::Pair, A> {
        let zero = [T::Pair::zero(); A];
        let mut nodes = ArcNodes { y: zero, c: zero, width: zero };
        let (middle_y, middle_c) = (T::Pair::both(self.middle.y), T::Pair::both(self.middle.c));
        let sides = T::Pair::of(-T::one(), T::one());
        for i in 0..A {
            let t = self.quarter_tangent.scale(rule.nodes[i]);
            let scale = T::one() / (T::one() + t * t);
            let cosine = T::Pair::both((T::one() - t * t) * scale);
            let sine = T::Pair::both((t * scale).times(2.0)) * sides;
            nodes.c[i] = middle_c * cosine - middle_y * sine;
            nodes.y[i] = middle_y * cosine + middle_c * sine;
            // dY = C dφ,  dφ = 2 dt/(1 + t²)
            let turn = (self.quarter_tangent * scale).scale(rule.weights[i].times(2.0));
            nodes.width[i] = nodes.c[i] * T::Pair::both(turn);
        }
        nodes
    }

    /// Factors that make `Σ C w` equal `∫ C dY` and `Σ C² w` equal `∫ C² dY`.
    #[inline(always)]
    fn scales<const A: usize>(&self, nodes: &ArcNodes<T::Pair, A>) -> (T, T) {
        let (mut stretch, mut capacity) = (T::Pair::zero(), T::Pair::zero());
        for i in 0..A {
            let first = nodes.c[i] * nodes.width[i];
            stretch += first;
            capacity += nodes.c[i] * first;
        }
        let (stretch, capacity) = (stretch.sum(), capacity.sum());
        let (lower, upper) = (self.lower, self.upper);
        // ∫ C dY = ∫ C² dθ = (Δθ + Y₂C₂ − Y₁C₁)/2
        let angle = self.quarter_tangent.atan().times(4.0);
        let exact_stretch = (angle + (upper.y * upper.c - lower.y * lower.c)).times(0.5);
        // ∫ C² dY = ΔY (1 − (Y₁² + Y₁Y₂ + Y₂²)/3)
        let squares = lower.y * lower.y + lower.y * upper.y + upper.y * upper.y;
        let exact_capacity = (upper.y - lower.y) * (T::one() - squares.times(1.0 / 3.0));
        let ratio = |exact: T, sum: T| {
            if sum.value() > T::EPSILON { exact / sum } else { T::one() }
        };
        (ratio(exact_stretch, stretch), ratio(exact_capacity, capacity))
    }
}
