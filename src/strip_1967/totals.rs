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

use crate::contact::creepage::Parameters;
use crate::contact::forces::{StripCount, Totals};
use crate::number::{Arithmetic, Choice, Elementary, Number, Pair, Real, Stored};
use crate::strip_1967::leading_edge::{AdhesionInterval, EdgePoint, Released, StripFamily};
use crate::strip_1967::panels::{
    AdhesionPanel, Nodes, Shares, SlidingLaw, SlidingPanels, SlidingStrips,
};
use crate::strip_1967::quadrature::{StripRule, Tabulated};
use crate::strip_1967::strip::SlidingRule;

impl StripCount {
    /// How they are dealt to panels.
    #[inline(always)]
    pub(crate) fn rule<F: Tabulated>(self) -> &'static StripRule<F> {
        let [four, eight, sixteen, thirty_two, sixty_four] = &F::STRIPS;
        match self {
            Self::Four => four,
            Self::Eight => eight,
            Self::Sixteen => sixteen,
            Self::ThirtyTwo => thirty_two,
            Self::SixtyFour => sixty_four,
        }
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
pub struct StripTheory<T: Number> {
    law: SlidingLaw<T>,
    axis_ratio: T::Base,
}

/// The same derivatives with another value.
#[inline(always)]
fn with_value<T: Real>(of: T, value: T::Base) -> T {
    if value == of.value() { of } else { of - T::from_base(of.value()) + T::from_base(value) }
}

/// What is done with the panels of a solution.
trait Sink<T: Number> {
    /// Sliding strips on both sides.
    fn sliding(&mut self, panels: &SlidingPanels<T>, nodes: Nodes<Stored<T>>);
    /// Strips with adhesion.
    fn adhesion(&mut self, panel: &AdhesionPanel<T>, nodes: Nodes<Stored<T>>);
    /// Strips counted among those with adhesion that slide after all.
    fn released(&mut self, panel: &AdhesionPanel<T>, nodes: Nodes<Stored<T>>);
}

/// Adds the strips up. What is not wanted stays zero, and the compiler leaves out what leads to it.
struct Sum<T: Number, const STICK: bool, const MOMENT: bool>(Shares<T::Pair>);

impl<T: Number, const STICK: bool, const MOMENT: bool> Sum<T, STICK, MOMENT> {
    #[inline(always)]
    fn add(&mut self, shares: &Shares<T::Pair>) {
        self.0.fx += shares.fx;
        self.0.fy += shares.fy;
        if MOMENT {
            self.0.mz += shares.mz;
        }
        if STICK {
            self.0.stick += shares.stick;
        }
    }
}

impl<T: Number + Elementary, const STICK: bool, const MOMENT: bool> Sink<T>
    for Sum<T, STICK, MOMENT>
{
    #[inline(always)]
    fn sliding(&mut self, panels: &SlidingPanels<T>, nodes: Nodes<Stored<T>>) {
        let sum = panels.sum(nodes);
        self.add(&panels.shares(&sum, panels.scale(&sum)));
    }

    #[inline(always)]
    fn adhesion(&mut self, panel: &AdhesionPanel<T>, nodes: Nodes<Stored<T>>) {
        self.add(&panel.carried(nodes).0);
    }

    fn released(&mut self, panel: &AdhesionPanel<T>, nodes: Nodes<Stored<T>>) {
        let (stuck, scales) = panel.carried(nodes);
        let mut slid = SlidingStrips::zero();
        for node in nodes {
            slid += panel.slid(&panel.at(node));
        }
        self.add(&-stuck);
        self.add(&panel.slid_shares(&slid, &scales));
    }
}

/// Hands the strips on, one by one.
struct Visitor<'a, T>(&'a mut dyn FnMut(PlacedStrip<T>));

impl<T: Real> Visitor<'_, T> {
    fn hand_on(&mut self, adheres: bool, places: [T::Pair; 4], shares: &Shares<T::Pair>) {
        let [y, half_length, width, kappa] = places.map(T::Pair::parts);
        let [fx, fy, mz, stick] =
            [shares.fx, shares.fy, shares.mz, shares.stick].map(T::Pair::parts);
        (self.0)(PlacedStrip {
            y: y.0,
            half_length: half_length.0,
            width: width.0,
            kappa: kappa.0,
            adheres,
            fx: fx.0,
            fy: fy.0,
            mz: mz.0,
            stick: stick.0,
        });
        (self.0)(PlacedStrip {
            y: y.1,
            half_length: half_length.1,
            width: width.1,
            kappa: kappa.1,
            adheres,
            fx: fx.1,
            fy: fy.1,
            mz: mz.1,
            stick: stick.1,
        });
    }
}

impl<T: Real> Sink<T> for Visitor<'_, T> {
    fn sliding(&mut self, panels: &SlidingPanels<T>, nodes: Nodes<T::Base>) {
        let scale = panels.scale(&panels.sum(nodes));
        for node in nodes {
            let (place, strips) = panels.at(node);
            let half_length = place.c_squared.max(T::Pair::zero()).sqrt();
            let width = SlidingPanels::<T>::width(&place, &strips, scale);
            let y = SlidingPanels::<T>::unmirrored(place.y);
            let shares = panels.shares(&strips, scale);
            self.hand_on(false, [y, half_length, width, half_length], &shares);
        }
    }

    fn adhesion(&mut self, panel: &AdhesionPanel<T>, nodes: Nodes<T::Base>) {
        let (_, scales) = panel.carried(nodes);
        for node in nodes {
            let strip = panel.at(node);
            let shares = panel.shares(&strip.terms(), &scales);
            self.hand_on(true, [strip.y, strip.c, strip.width, strip.kappa], &shares);
        }
    }

    fn released(&mut self, panel: &AdhesionPanel<T>, nodes: Nodes<T::Base>) {
        let (_, scales) = panel.carried(nodes);
        for node in nodes {
            let strip = panel.at(node);
            let shares = -panel.shares(&strip.terms(), &scales);
            self.hand_on(true, [strip.y, strip.c, -strip.width, strip.kappa], &shares);
            let shares = panel.slid_shares(&panel.slid(&strip), &scales);
            self.hand_on(false, [strip.y, strip.c, strip.width, strip.c], &shares);
        }
    }
}

impl<T: Number + Elementary> StripTheory<T> {
    /// Set up the theory with one of its sliding rules.
    #[inline(always)]
    #[must_use]
    pub fn new(parameters: &Parameters<T>, rule: SlidingRule) -> Self {
        let one = <T::Base as Arithmetic>::one();
        Self {
            law: SlidingLaw {
                family: StripFamily {
                    xi: parameters.xi,
                    slope: parameters.spin_slope(),
                    eta: parameters.eta,
                    psi: parameters.psi,
                },
                compliance: one - parameters.poisson_ratio,
                rule,
                inverse_ratio: one / parameters.axis_ratio,
            },
            axis_ratio: parameters.axis_ratio,
        }
    }

    /// Totals from the sums over all strips.
    #[inline(always)]
    fn totals_of<const STICK: bool, const MOMENT: bool>(
        &self,
        sum: &Sum<T, STICK, MOMENT>,
    ) -> Totals<T> {
        let Shares { fx, fy, mz, stick } = sum.0;
        let (fx, fy, mz, stick) = (fx.sum(), fy.sum(), mz.sum(), stick.sum());
        let bound = Self::bound(fx, fy);
        let lever = self.lever();
        Totals {
            fx: fx * bound,
            fy: fy * bound,
            // a = √(ab) √(a/b)
            mz: mz.clamped(-lever, lever).scale(self.axis_ratio.sqrt()),
            stick: stick.clamped(T::zero(), T::one()),
        }
    }

    /// Friction capacity is exact, stretch is exact, their mixture with few strips is not: what keeps `|F| ≤ μ N`.
    #[inline(always)]
    fn bound(fx: T, fy: T) -> T {
        let size = fx * fx + fy * fy;
        T::either(size - T::one(), || T::one() / size.sqrt(), T::one)
    }

    /// Nor does a moment exceed `μ N` times the longer semi-axis, however slender the ellipse; over `a`.
    #[inline(always)]
    fn lever(&self) -> T {
        let one = <T::Base as Arithmetic>::one();
        T::from_base(one.max(one / self.axis_ratio))
    }

    /// Without spin and with `τ = √(ξ² + η²) ≥ 1` no strip adheres and all slide the same way: what the
    /// quadrature, exact for the friction capacity, gives to rounding.
    #[inline(always)]
    fn all_slide(&self) -> Totals<T> {
        let StripFamily { xi, eta, .. } = self.law.family;
        let x = match self.law.rule {
            SlidingRule::RigidSlip => xi.scale(self.law.compliance),
            SlidingRule::Continuous => xi,
        };
        let inverse = T::one() / (x * x + eta * eta).sqrt();
        Totals { fx: x * inverse, fy: eta * inverse, mz: T::zero(), stick: T::zero() }
    }

    /// Sliding – adhesion – sliding; `split` divides the adhesion interval where `ξ̄ = 0`.
    ///
    /// (On a microcontroller its stack is free while the interval and its pieces are searched for.)
    #[cfg_attr(target_os = "none", inline(never))]
    #[cfg_attr(not(target_os = "none"), inline(always))]
    fn panels(
        &self,
        rule: &StripRule<Stored<T>>,
        (lower, upper): (&EdgePoint<T>, &EdgePoint<T>),
        adheres: bool,
        sink: &mut impl Sink<T>,
    ) {
        let StripRule { slide, stick, split } = *rule;
        let law = &self.law;
        let (lower, upper) = (*lower, *upper);
        sink.sliding(&SlidingPanels::new(law, lower, upper), slide);
        if !adheres {
            return;
        }
        let middle = if split { self.turning_strip(lower, upper) } else { lower };
        // (a loop, so that the code of a panel is there once)
        for (from, to) in [(lower, middle), (middle, upper)].into_iter().skip(usize::from(!split)) {
            sink.adhesion(&AdhesionPanel::new(law, from, to), stick);
        }
    }

    /// The strip with `ξ̄ = 0`, or the end of the interval nearest to it.
    #[inline(always)]
    fn turning_strip(&self, lower: EdgePoint<T>, upper: EdgePoint<T>) -> EdgePoint<T> {
        let StripFamily { xi, slope, .. } = self.law.family;
        let mut y = xi / slope;
        if T::HAS_DERIVATIVES {
            // A strip between two panels of the same rule: where exactly it lies does not matter, and with a vanishing
            // spin its derivatives have no numbers.
            let vanishing = T::from_base(T::ROOT_TINY) - slope.abs();
            y = vanishing.choose(T::from_base(xi.value() / slope.value()), y);
        }
        let outside = EdgePoint::chosen(-(xi * slope), lower, upper);
        let below = EdgePoint::chosen(upper.y - y, EdgePoint::on_edge(y), upper);
        let inside = EdgePoint::chosen(y - lower.y, below, lower);
        EdgePoint::chosen(slope.abs() - xi.abs(), inside, outside)
    }
}

impl<T: Real> StripTheory<T>
where
    T::Base: Tabulated,
{
    /// Whether the spin is inside the theory, `|ψ| < 1`.
    #[must_use]
    pub fn spin_in_range(&self) -> bool {
        self.law.family.psi.value().abs() < <T::Base as Arithmetic>::one()
    }

    /// Total force, moment and stick area with a fixed number of strips.
    #[must_use]
    pub fn totals(&self, count: StripCount) -> Totals<T> {
        self.wanted_totals::<true, true>(count)
    }

    /// [`StripTheory::totals`] without the stick area or the moment, which are zero then.
    #[inline(always)]
    pub(crate) fn wanted_totals<const STICK: bool, const MOMENT: bool>(
        &self,
        count: StripCount,
    ) -> Totals<T> {
        if let Some(totals) = self.pure_sliding() {
            return totals;
        }
        if T::HAS_DERIVATIVES && self.vanishes() {
            return self.totals_of_vanishing::<STICK, MOMENT>(count);
        }
        self.summed::<STICK, MOMENT>(count)
    }

    /// The largest of the parameters of all strips.
    #[inline(always)]
    fn size(&self) -> T::Base {
        let StripFamily { xi, slope, eta, psi } = self.law.family;
        let size = |v: T| v.value().abs();
        size(xi).max(size(slope)).max(size(eta)).max(size(psi))
    }

    /// Below this the derivatives of squares of the parameters leave the number range.
    #[inline(always)]
    fn least_size() -> T::Base {
        T::ROOT_TINY.times(1e6)
    }

    /// Whether creepages are so small that derivatives of their squares leave the number range.
    #[inline(always)]
    fn vanishes(&self) -> bool {
        let size = self.size();
        size < Self::least_size() && size > <T::Base as Arithmetic>::zero()
    }

    /// [`StripTheory::totals`] of larger creepages of the same direction, and the forces made smaller again: both are as
    /// linear as rounding allows.
    #[cold]
    #[inline(never)]
    fn totals_of_vanishing<const STICK: bool, const MOMENT: bool>(
        &self,
        count: StripCount,
    ) -> Totals<T> {
        let StripFamily { xi, slope, eta, psi } = self.law.family;
        let (size, least) = (self.size(), Self::least_size());
        let (factor, shrink) = (least / size, size / least);
        let larger = |v: T| with_value(v, v.value() * factor);
        let family = StripFamily {
            xi: larger(xi),
            slope: larger(slope),
            eta: larger(eta),
            psi: larger(psi),
        };
        let theory = Self { law: SlidingLaw { family, ..self.law }, ..*self };
        let Totals { fx, fy, mz, stick } = theory.summed::<STICK, MOMENT>(count);
        let shrunk = |f: T| with_value(f, f.value() * shrink);
        Totals { fx: shrunk(fx), fy: shrunk(fy), mz: shrunk(mz), stick }
    }

    #[inline(always)]
    fn summed<const STICK: bool, const MOMENT: bool>(&self, count: StripCount) -> Totals<T> {
        let mut sum = Sum::<T, STICK, MOMENT>(Shares::zero());
        self.place(count, &mut sum);
        self.totals_of(&sum)
    }

    /// [`StripTheory::all_slide`] where it holds.
    #[inline(always)]
    fn pure_sliding(&self) -> Option<Totals<T>> {
        let StripFamily { xi, eta, psi, .. } = self.law.family;
        let zero = <T::Base as Arithmetic>::zero();
        if T::HAS_DERIVATIVES || psi.value() != zero || !(xi * xi + eta * eta >= T::one()) {
            return None;
        }
        Some(self.all_slide())
    }

    /// Hand every strip of a fixed count to `visit`. The sum of the shares is the total. For
    /// `|ψ| > 1` strips beyond the count may follow that correct pieces of the adhesion interval
    /// which slide (their widths are negative where they take adhesion away).
    pub fn strips(&self, count: StripCount, visit: &mut dyn FnMut(PlacedStrip<T>)) {
        let [mut fx, mut fy, mut mz] = [T::zero(); 3];
        self.each(count, &mut |strip| {
            fx += strip.fx;
            fy += strip.fy;
            mz += strip.mz;
        });
        let bound = Self::bound(fx, fy);
        let (size, lever) = (mz.abs(), self.lever());
        let lever = if size > lever { lever / size } else { T::one() };
        self.each(count, &mut |strip| {
            visit(PlacedStrip {
                fx: strip.fx * bound,
                fy: strip.fy * bound,
                mz: strip.mz * lever,
                ..strip
            });
        });
    }

    #[inline(never)]
    fn each(&self, count: StripCount, visit: &mut dyn FnMut(PlacedStrip<T>)) {
        self.place(count, &mut Visitor(visit));
    }

    #[inline(always)]
    fn place(&self, count: StripCount, sink: &mut impl Sink<T>) {
        let rule = count.rule();
        let interval = self.law.family.adhesion_interval();
        let ends = match &interval {
            Ok(AdhesionInterval { lower, upper }) => (lower, upper),
            Err(nearest) => (nearest, nearest),
        };
        self.panels(rule, ends, interval.is_ok(), sink);
        if let Ok(interval) = interval
            && !self.spin_in_range()
        {
            self.releases(&interval, sink);
        }
    }

    /// For `|ψ| > 1`: pieces of the adhesion interval slide after all, each short enough for 4 nodes.
    #[cold]
    #[inline(never)]
    fn releases(&self, interval: &AdhesionInterval<T>, sink: &mut impl Sink<T>) {
        let [_, rule, ..] = &T::Base::STRIPS;
        let mut released = Released::of(&self.law.family, interval);
        while released.next_cell() {
            for (lower, upper) in released.pieces.iter().flatten() {
                self.release(lower, upper, rule.stick, sink);
            }
        }
    }

    #[inline(never)]
    fn release(
        &self,
        lower: &EdgePoint<T>,
        upper: &EdgePoint<T>,
        nodes: Nodes<T::Base>,
        sink: &mut impl Sink<T>,
    ) {
        sink.released(&AdhesionPanel::new(&self.law, *lower, *upper), nodes);
    }
}

#[cfg(target_arch = "x86_64")]
mod side_by_side {
    use super::*;
    use crate::number::lanes::Lanes;

    /// The sums of several contacts, of which some adhere: where this is positive.
    struct SumOfSome<L: Number>(Sum<L, true, true>, L);

    impl<L: Number + Elementary> Sink<L> for SumOfSome<L> {
        #[inline(always)]
        fn sliding(&mut self, panels: &SlidingPanels<L>, nodes: Nodes<Stored<L>>) {
            self.0.sliding(panels, nodes);
        }
        #[inline(always)]
        fn adhesion(&mut self, panel: &AdhesionPanel<L>, nodes: Nodes<Stored<L>>) {
            let adheres = L::Pair::both(self.1);
            let Shares { fx, fy, mz, stick } = panel.carried(nodes).0;
            let of_these = |share: L::Pair| adheres.choose(share, L::Pair::zero());
            self.0.add(&Shares {
                fx: of_these(fx),
                fy: of_these(fy),
                mz: of_these(mz),
                stick: of_these(stick),
            });
        }
        fn released(&mut self, _: &AdhesionPanel<L>, _: Nodes<Stored<L>>) {}
    }

    impl<L: Number + Elementary> StripTheory<L> {
        /// [`StripTheory::totals`] of several contacts, each in its lane, with the bits of one by one; and a number
        /// that is not positive where a contact has to be solved by itself, because it reaches unit spin. `None` when
        /// that is all but one of them.
        #[inline(always)]
        pub(crate) fn totals_side_by_side<const N: usize>(
            &self,
            rule: &StripRule<Stored<L>>,
        ) -> Option<(Totals<L>, L)>
        where
            L: Lanes<N>,
        {
            let (family, within) = self.law.family.within_unit_spin();
            if within.array().into_iter().filter(|x| *x > Stored::<L>::zero()).count() < 2 {
                return None;
            }
            let theory = Self { law: SlidingLaw { family, ..self.law }, ..*self };
            let StripFamily { xi, eta, psi, .. } = family;
            let intervals = family.adhesion_intervals();
            let mut sum = SumOfSome(Sum(Shares::zero()), intervals.adheres);
            let some = intervals.adheres.exceeds(L::zero());
            let AdhesionInterval { lower, upper } = &intervals.ends;
            theory.panels(rule, (lower, upper), some, &mut sum);
            let Totals { mut fx, mut fy, mut mz, mut stick } = theory.totals_of(&sum.0);
            let spin = psi.abs();
            if !spin.is_positive_number() {
                let slide = theory.all_slide();
                let inside = L::one() - (xi * xi + eta * eta);
                let summed = |sum: L, slide| spin.choose(sum, inside.choose(sum, slide));
                (fx, fy) = (summed(fx, slide.fx), summed(fy, slide.fy));
                (mz, stick) = (summed(mz, slide.mz), summed(stick, slide.stick));
            }
            Some((Totals { fx, fy, mz, stick }, within))
        }
    }
}
