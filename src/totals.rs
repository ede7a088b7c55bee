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
use crate::leading_edge::{AdhesionInterval, EdgePoint, StripFamily};
use crate::quadrature::{Rule, Tabulated};
use crate::real::Real;
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

/// The strips of one panel, component by component, so that loops over them vectorise and what is
/// not asked for is not computed.
#[derive(Clone, Copy, Debug)]
struct Panel<T, const M: usize> {
    y: [T; M],
    half_length: [T; M],
    width: [T; M],
    kappa: [T; M],
    fx: [T; M],
    fy: [T; M],
    /// About the centre, units of `a`.
    mz: [T; M],
    stick: [T; M],
    adheres: bool,
}

/// What is done with the panels of a solution.
trait Sink<T> {
    fn take<const M: usize>(&mut self, panel: Panel<T, M>);
}

/// Adds the strips up.
struct Sum<T> {
    fx: T,
    fy: T,
    mz: T,
    stick: T,
}

impl<T: Real> Sink<T> for Sum<T> {
    #[inline(always)]
    fn take<const M: usize>(&mut self, panel: Panel<T, M>) {
        for i in 0..M {
            self.fx += panel.fx[i];
            self.fy += panel.fy[i];
            self.mz += panel.mz[i];
        }
        if panel.adheres {
            for stick in panel.stick {
                self.stick += stick;
            }
        }
    }
}

/// Hands the strips on, one by one.
struct Visitor<'a, T>(&'a mut dyn FnMut(PlacedStrip<T>));

impl<T: Real> Sink<T> for Visitor<'_, T> {
    fn take<const M: usize>(&mut self, panel: Panel<T, M>) {
        for i in 0..M {
            (self.0)(PlacedStrip {
                y: panel.y[i],
                half_length: panel.half_length[i],
                width: panel.width[i],
                kappa: panel.kappa[i],
                adheres: panel.adheres,
                fx: panel.fx[i],
                fy: panel.fy[i],
                mz: panel.mz[i],
                stick: panel.stick[i],
            });
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
        let mut sum = Sum { fx: T::zero(), fy: T::zero(), mz: T::zero(), stick: T::zero() };
        self.place(count, &mut sum);
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

    /// Hand every strip of a fixed count to `visit`, in ascending `y` within each panel. The sum of
    /// the shares is the total. For `|ψ| > 1` strips beyond the count may follow that correct
    /// pieces of the adhesion interval which slide (their widths are negative where they take
    /// adhesion away).
    pub fn strips(&self, count: StripCount, visit: &mut dyn FnMut(PlacedStrip<T>)) {
        self.place(count, &mut Visitor(visit));
    }

    #[inline(always)]
    fn place(&self, count: StripCount, sink: &mut impl Sink<T>) {
        type B<T> = <T as Real>::Base;
        match count {
            StripCount::Four => self.panels(&B::<T>::GAUSS_1, &B::<T>::GAUSS_2, false, sink),
            StripCount::Eight => self.panels(&B::<T>::GAUSS_2, &B::<T>::GAUSS_4, false, sink),
            StripCount::Sixteen => self.panels(&B::<T>::GAUSS_5, &B::<T>::GAUSS_6, false, sink),
            StripCount::ThirtyTwo => self.panels(&B::<T>::GAUSS_8, &B::<T>::GAUSS_8, true, sink),
            StripCount::SixtyFour => self.panels(&B::<T>::GAUSS_16, &B::<T>::GAUSS_16, true, sink),
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
                sink.take(self.sliding_panel(slide, lower, -1.0));
                if split {
                    let middle = self.turning_strip(lower, upper);
                    sink.take(self.adhesion_panel(stick, lower, middle));
                    sink.take(self.adhesion_panel(stick, middle, upper));
                } else {
                    sink.take(self.adhesion_panel(stick, lower, upper));
                }
                sink.take(self.sliding_panel(slide, upper, 1.0));
                if !self.spin_in_range() {
                    for piece in &self.family.excluded(&AdhesionInterval { lower, upper }) {
                        let wrong = self.adhesion_panel(stick, piece.lower, piece.upper);
                        sink.take(wrong.negated());
                        sink.take(self.sliding_piece(stick, piece.lower, piece.upper));
                    }
                }
            }
            Err(nearest) => {
                sink.take(self.sliding_panel(slide, nearest, -1.0));
                sink.take(self.sliding_panel(slide, nearest, 1.0));
            }
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

    /// Direction of sliding at `Y`, `C²`.
    #[inline(always)]
    fn direction(&self, y: T, c_squared: T) -> (T, T) {
        let xi_bar = self.family.xi_bar(y);
        let (x, y) = match self.rule {
            // w ~ ((1 − ν) ξ̄, η)
            SlidingRule::RigidSlip => {
                (xi_bar.scale(T::Base::one() - self.poisson_ratio), self.family.eta)
            }
            // w ~ (ξ̄, η + ψ C)
            SlidingRule::Continuous => {
                let c = c_squared.max(T::from_base(T::TINY)).sqrt();
                (xi_bar, self.family.eta + self.family.psi * c)
            }
        };
        let inverse = T::one() / (x * x + y * y + T::from_base(T::TINY)).sqrt();
        (x * inverse, y * inverse)
    }

    /// Strips without adhesion between `end` and the edge `Y = side`.
    #[inline(always)]
    fn sliding_panel<const S: usize>(
        &self,
        rule: &Rule<T::Base, S>,
        end: EdgePoint<T>,
        side: f64,
    ) -> Panel<T, S> {
        let tiny = T::from_base(T::TINY);
        // Mirrored so that the panel runs from `from` up to 1.
        let from = end.y.times(side);
        // Length of the panel, 1 − Y, without cancellation next to the edge
        let beyond = T::one() + from.abs();
        let past_middle = end.c * end.c / beyond;
        let length = if from > T::zero() { past_middle } else { beyond };
        // ∫ C² dY over the panel
        let capacity = length * length * (T::one() - length.times(1.0 / 3.0));
        // Grading Y = end + L s (A + B s²)/(A + B): A is the distance in slip from the strip where
        // it turns, B the slip that the panel spans.
        let compliance = T::Base::one() - self.poisson_ratio;
        let z = self.family.xi_bar(end.y).scale(compliance);
        let eta = self.family.eta;
        let near = (eta * eta + z * z + tiny).sqrt().times(2.0);
        let span = (self.family.slope * length).scale(compliance).abs();
        let scale = T::one() / (near + span);
        let (near, span) = (near * scale, span * scale);

        let (mut y, mut c_squared, mut weight) = ([T::zero(); S], [T::zero(); S], [T::zero(); S]);
        for i in 0..S {
            // [-1, 1] → [0, 1]
            let s = rule.nodes[i].times(0.5).plus(0.5);
            let square = s * s;
            let g = (near + span.scale(square)).scale(s);
            y[i] = from + length * g;
            c_squared[i] = length * (T::one() - g) * (T::one() + y[i]);
            weight[i] =
                c_squared[i] * (near + span.scale(square.times(3.0))).scale(rule.weights[i]);
        }
        let normalised = capacity.times(0.75) / (total(&weight) + tiny);
        for i in 0..S {
            y[i] = y[i].times(side);
            weight[i] = weight[i] * normalised;
        }
        self.sliding(y, c_squared, weight)
    }

    /// Sliding strips that carry the shares `capacity` of the friction bound.
    #[inline(always)]
    fn sliding<const M: usize>(
        &self,
        y: [T; M],
        c_squared: [T; M],
        capacity: [T; M],
    ) -> Panel<T, M> {
        let zero = [T::zero(); M];
        let (mut wx, mut wy) = (zero, zero);
        for i in 0..M {
            (wx[i], wy[i]) = self.direction(y[i], c_squared[i]);
        }
        let inverse_ratio = T::Base::one() / self.axis_ratio;
        let mut panel = Panel {
            y,
            half_length: zero,
            width: zero,
            kappa: zero,
            fx: zero,
            fy: zero,
            mz: zero,
            stick: zero,
            adheres: false,
        };
        for i in 0..M {
            let fx = capacity[i] * wx[i];
            panel.fx[i] = fx;
            panel.fy[i] = capacity[i] * wy[i];
            panel.mz[i] = -(y[i] * fx).scale(inverse_ratio);
        }
        for i in 0..M {
            panel.half_length[i] = c_squared[i].max(T::zero()).sqrt();
            panel.kappa[i] = panel.half_length[i];
            panel.width[i] = capacity[i].times(4.0 / 3.0) / (c_squared[i] + T::from_base(T::TINY));
        }
        panel
    }

    /// Strips with adhesion along the arc of the leading edge from `lower` to `upper`.
    #[inline(always)]
    fn adhesion_panel<const A: usize>(
        &self,
        rule: &Rule<T::Base, A>,
        lower: EdgePoint<T>,
        upper: EdgePoint<T>,
    ) -> Panel<T, A> {
        let arc = Arc::between(lower, upper);
        let nodes = arc.nodes(rule);
        let (stretch, capacity) = arc.scales(&nodes);
        let (stretch, capacity) = (stretch.times(0.75), capacity.times(0.75));
        let kappa = self.adhesion_lengths(&nodes.y);
        let StripFamily { eta, psi, .. } = self.family;
        let inverse_ratio = T::Base::one() / self.axis_ratio;
        let zero = [T::zero(); A];
        let mut panel = Panel {
            y: nodes.y,
            half_length: nodes.c,
            width: nodes.width,
            kappa,
            fx: zero,
            fy: zero,
            mz: zero,
            stick: zero,
            adheres: true,
        };
        for i in 0..A {
            let (y, c) = (nodes.y[i], nodes.c[i]);
            let kappa = kappa[i].min(c);
            let (by_stretch, by_capacity) = (nodes.width[i] * stretch, nodes.width[i] * capacity);
            // f_x = ξ̄ (2C − K),  f_y = ψ C² + η (2C − K)
            let reach = (c + c - kappa) * by_stretch;
            let stuck = c - kappa;
            let fx = self.family.xi_bar(y) * reach;
            panel.kappa[i] = kappa;
            panel.fx[i] = fx;
            panel.fy[i] = psi * (c * c * by_capacity) + eta * reach;
            // M_z = a m_x − b Y f_x,  m_x = −η (C − K)²
            panel.mz[i] = -(eta * stuck * stuck * by_capacity) - (y * fx).scale(inverse_ratio);
            panel.stick[i] = (stuck * by_stretch).times(8.0 / (3.0 * core::f64::consts::PI));
        }
        panel
    }

    /// `κ/a` of strips that are known to adhere, by the form of (5.41) that does not cancel.
    #[inline(always)]
    fn adhesion_lengths<const A: usize>(&self, y: &[T; A]) -> [T; A] {
        let StripFamily { eta, psi, .. } = self.family;
        let q = (T::one() - psi) * (T::one() + psi);
        let (eta_psi, eta_squared) = (eta * psi, eta * eta);
        let (mut square, mut s) = ([T::zero(); A], [T::zero(); A]);
        for i in 0..A {
            let xi_bar = self.family.xi_bar(y[i]);
            square[i] = xi_bar * xi_bar;
            // S = √(η² + (1 − ψ²) ξ̄²)
            s[i] = (eta_squared + q * square[i]).max(T::from_base(T::TINY)).sqrt();
        }
        let mut kappa = [T::zero(); A];
        let cancels = eta_psi < T::zero();
        for i in 0..A {
            let numerator = if cancels { square[i] + eta_squared } else { s[i] + eta_psi };
            let denominator = if cancels { s[i] - eta_psi } else { q };
            kappa[i] = numerator / denominator;
        }
        kappa
    }

    /// Strips that slide although they lie inside the adhesion interval (`|ψ| > 1` only).
    fn sliding_piece<const A: usize>(
        &self,
        rule: &Rule<T::Base, A>,
        lower: EdgePoint<T>,
        upper: EdgePoint<T>,
    ) -> Panel<T, A> {
        let arc = Arc::between(lower, upper);
        let nodes = arc.nodes(rule);
        let (_, scale) = arc.scales(&nodes);
        let (mut c_squared, mut capacity) = ([T::zero(); A], [T::zero(); A]);
        for i in 0..A {
            c_squared[i] = nodes.c[i] * nodes.c[i];
            capacity[i] = (c_squared[i] * nodes.width[i] * scale).times(0.75);
        }
        self.sliding(nodes.y, c_squared, capacity)
    }
}

/// The sum of an array.
#[inline(always)]
fn total<T: Real, const M: usize>(terms: &[T; M]) -> T {
    let mut sum = T::zero();
    for &term in terms {
        sum += term;
    }
    sum
}

impl<T: Real, const M: usize> Panel<T, M> {
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

struct ArcNodes<T, const A: usize> {
    y: [T; A],
    c: [T; A],
    width: [T; A],
}

impl<T: Real> Arc<T> {
    #[inline(always)]
    fn between(lower: EdgePoint<T>, upper: EdgePoint<T>) -> Self {
        let (dy, dc) = (upper.y - lower.y, upper.c - lower.c);
        let (sy, sc) = (upper.y + lower.y, upper.c + lower.c);
        let tiny = T::from_base(T::TINY);
        // 2 sin(Δθ/2), 2 cos(Δθ/2): the chord and the sum of the two unit vectors
        let chord = (dy * dy + dc * dc + tiny).sqrt();
        let along = (sy * sy + sc * sc + tiny).sqrt();
        // Both the sum and the normal of the chord point to the middle; together they never vanish.
        let scale = T::one() / (chord + along);
        Self {
            lower,
            upper,
            middle: EdgePoint { y: (sy - dc) * scale, c: (sc + dy) * scale },
            quarter_tangent: chord / (along.plus(2.0)),
        }
    }

    /// Nodes in `t = tan(φ/2)` about the middle, where `cos φ` and `sin φ` are rational.
    #[inline(always)]
    fn nodes<const A: usize>(&self, rule: &Rule<T::Base, A>) -> ArcNodes<T, A> {
        let mut nodes = ArcNodes { y: [T::zero(); A], c: [T::zero(); A], width: [T::zero(); A] };
        for i in 0..A {
            let t = self.quarter_tangent.scale(rule.nodes[i]);
            let scale = T::one() / (T::one() + t * t);
            let (cosine, sine) = ((T::one() - t * t) * scale, (t * scale).times(2.0));
            nodes.c[i] = self.middle.c * cosine - self.middle.y * sine;
            nodes.y[i] = self.middle.y * cosine + self.middle.c * sine;
            // dY = C dφ,  dφ = 2 dt/(1 + t²)
            nodes.width[i] =
                nodes.c[i] * (self.quarter_tangent * scale).scale(rule.weights[i].times(2.0));
        }
        nodes
    }

    /// Factors that make `Σ C w` equal `∫ C dY` and `Σ C² w` equal `∫ C² dY`.
    #[inline(always)]
    fn scales<const A: usize>(&self, nodes: &ArcNodes<T, A>) -> (T, T) {
        let (mut first, mut second) = ([T::zero(); A], [T::zero(); A]);
        for i in 0..A {
            first[i] = nodes.c[i] * nodes.width[i];
            second[i] = nodes.c[i] * first[i];
        }
        let (stretch, capacity) = (total(&first), total(&second));
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
