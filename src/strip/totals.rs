//! Sums over the strips of the Hertz ellipse.

use super::creepage::{Distribution, Flexibilities};
use super::derivative::{SpinSlopes, alone_with_slopes, forces_and_slopes};
use super::kernel::{Spin, StripCreepage, forces};
use super::power::power_projected;
use super::tables::{FourStrips, Rule, STRIP_FIELDS, Tables};
use crate::contact::totals::{StripCount, StripForces, Totals};
use crate::linear::LinearCoefficients;
use crate::number::avx::with_avx;
use crate::number::lanes::Lanes;
use crate::number::{Arithmetic, Float, Number, Real, Strips, add};

/// A contact's strips, ready for creepages.
#[derive(Clone, Copy, Debug)]
pub struct EllipseStrips<F: Real> {
    pub(crate) contact: Flexibilities<F>,
    pub(super) rule: Rule<F::Stored>,
}

/// Sums over the strips: of `f_x, f_y`, the two parts of the moment, the stick area, and zero; with
/// derivatives also those of `f_x, f_y` and the moment with respect to [`Distribution::numbers`].
type Rows<P, const ROWS: usize> = [[P; 6]; ROWS];

/// Number of rows: without derivatives, and with them.
const VALUES: usize = 1;
const SLOPES: usize = 4;

impl<F: Real> EllipseStrips<F> {
    /// `axis_ratio` is `a/b`, `linear` the coefficients for it.
    #[inline(always)]
    pub fn new(
        axis_ratio: F, poisson_ratio: F, linear: &LinearCoefficients<F>, count: StripCount,
    ) -> Self {
        let rule = Rule::new(count);
        let factors = [F::stored(rule.stretch), F::stored(rule.lever)];
        Self { contact: Flexibilities::new(axis_ratio, poisson_ratio, linear, factors), rule }
    }

    /// The strips of a contact that has been prepared for their number.
    #[inline]
    pub(crate) fn from_prepared(contact: Flexibilities<F>, count: StripCount) -> Self {
        Self { contact, rule: Rule::new(count) }
    }

    /// Forces, moment and share in adhesion for `vx, vy = G a b (υx, υy)/(μ N)`,
    /// `φ = G (a b)^{3/2} ϕ/(μ N)`.
    #[inline(always)]
    pub fn totals_of_strips<T: Number<Base = F>>(&self, creepage: [T; 3]) -> Totals<T> {
        with_avx!(if T::LANES => <F: Real, T: Number<Base = F>>(
            strips: &EllipseStrips<F> = self,
            creepage: [T; 3]
        ) -> Totals<T> {
            if cfg!(target_os = "none") {
                // Machines without wide registers compute one strip after the other, which needs
                // less flash, with the creepages that strips of other shapes have too.
                strips.totals_of::<T, Lanes<F, 1>>(&strips.contact.see(creepage))
            } else {
                let law = strips.contact.seen::<T, F::Four>(creepage);
                if T::HAS_DERIVATIVES && T::LANES > 1 {
                    // One strip of several contacts fills the register.
                    strips.totals_of::<T, F::WideRow>(&law)
                } else {
                    strips.totals_of::<T, F::Four>(&law)
                }
            }
        } {
            let law = strips.contact.seen::<T, F::WideRow>(creepage);
            let count = 4 * strips.rule.fours.len();
            if !T::HAS_DERIVATIVES && count >= F::WideSixteen::COUNT {
                strips.totals_of::<T, F::WideSixteen>(&law)
            } else if (!T::HAS_DERIVATIVES || size_of::<F>() == 4) && count >= F::WideEight::COUNT {
                strips.totals_of::<T, F::WideEight>(&law)
            } else {
                strips.totals_of::<T, F::WideFour>(&law)
            }
        })
    }

    /// The totals, computed one strip after the other.
    #[doc(hidden)]
    pub fn totals_one_by_one<T: Number<Base = F>>(&self, creepage: [T; 3]) -> Totals<T> {
        self.totals_of::<T, Lanes<F, 1>>(&self.contact.seen::<T, Lanes<F, 1>>(creepage))
    }

    /// Sums for the creepages of the strips, `P` of them side by side.
    #[inline(always)]
    fn totals_of<T: Number<Base = F>, P: Strips<F>>(&self, law: &Distribution<T>) -> Totals<T> {
        let [values, by_x, by_y, by_z] = if T::HAS_DERIVATIVES {
            self.sums::<P, SLOPES>(&law.without_derivatives())
        } else {
            let [values] = self.sums::<P, VALUES>(&law.without_derivatives());
            [values; SLOPES]
        };
        let (by, Totals { fx, fy, mz, stick }) = (law.numbers(), self.values(values));
        let totals = Totals {
            fx: T::composed(fx, by_x, by),
            fy: T::composed(fy, by_y, by),
            mz: T::composed(mz, by_z, by),
            stick: T::from_base(stick),
        };
        power_projected(totals, law.creepage, &self.contact.linear)
    }

    #[inline]
    fn values(&self, [fx, fy, by_x, by_y, stick, _]: [F; 6]) -> Totals<F> {
        let mz = by_x * self.contact.root - by_y * self.contact.upright;
        Totals { fx, fy, mz, stick: stick.clamped(F::zero(), F::one()) }
    }

    /// Sums over the strips, `P` of them at a time. Four partial sums per lane are added as
    /// `(c₀ + c₂) + (c₁ + c₃)`, then the lanes likewise, so that the result does not depend on the
    /// width of the register. It stays out of line where code must be small and the stack short: it
    /// needs no room while the creepages of the strips are computed.
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline(never))]
    pub(super) fn sums<P: Strips<F>, const ROWS: usize>(
        &self, law: &Distribution<F>,
    ) -> Rows<F, ROWS> {
        let strips = CommonCreepage::<P>::new(law, P::all);
        let sum = if P::COUNT >= 4 {
            self.chains::<P, ROWS>(&strips)
        } else {
            self.one_by_one::<P, ROWS>(&strips)
        };
        let mut totals = [[F::zero(); 6]; ROWS];
        for (total, sum) in totals.as_flattened_mut().iter_mut().zip(sum.as_flattened()) {
            *total = sum.total();
        }
        totals
    }

    /// The sums over every four.
    #[inline(always)]
    fn chains<P: Strips<F>, const ROWS: usize>(&self, strips: &CommonCreepage<P>) -> Rows<P, ROWS> {
        let fours = const { P::COUNT / 4 };
        // Each of the four partial sums is added separately, in the order 0, 2, 1, 3, and then to
        // its half.
        let (chains, nothing) = (4 / fours, [[P::zero(); 6]; ROWS]);
        let mut halves = [nothing; 2];
        for k in 0..chains {
            let chain = if chains == 4 { (k & 1) << 1 | k >> 1 } else { k };
            let mut sums = nothing;
            for group in self.rule.fours.chunks_exact(fours).skip(chain).step_by(chains) {
                self.add_strips(strips, group, 0, &mut sums);
            }
            if let Some(half) = halves.get_mut(2 * k / chains) {
                add(half.as_flattened_mut(), sums.as_flattened().iter().copied());
            }
        }
        let [mut first, second] = halves;
        if chains > 1 {
            add(first.as_flattened_mut(), second.as_flattened().iter().copied());
        }
        first
    }

    /// The sums over all strips, one after the other. A partial sum of one strip is added where it
    /// belongs without a place of its own.
    #[inline(always)]
    fn one_by_one<P: Strips<F>, const ROWS: usize>(
        &self, strips: &CommonCreepage<P>,
    ) -> Rows<P, ROWS> {
        // The compiler would write zeros that it foresees by a call.
        let [x, ..] = strips.law;
        #[allow(clippy::eq_op)]
        let nothing = [[x - x; 6]; ROWS];
        let last = if self.rule.fours.len() <= 4 { 1 } else { 3 };
        let mut lanes = [nothing; 2];
        let mut chains = [nothing; 4];
        for lane in [0, 2, 1, 3] {
            for sums in chains.iter_mut().take(last + 1) {
                *sums = nothing;
            }
            for (i, four) in self.rule.fours.iter().enumerate() {
                if let Some(sums) = chains.get_mut(i & last) {
                    self.add_strips(strips, core::slice::from_ref(four), lane, sums);
                }
            }
            let [first, second, third, fourth] = &mut chains;
            if last == 3 {
                add(first.as_flattened_mut(), third.as_flattened().iter().copied());
                add(second.as_flattened_mut(), fourth.as_flattened().iter().copied());
            }
            add(first.as_flattened_mut(), second.as_flattened().iter().copied());
            if let Some(lanes) = lanes.get_mut(lane & 1) {
                add(lanes.as_flattened_mut(), first.as_flattened().iter().copied());
            }
        }
        let [mut first, second] = lanes;
        add(first.as_flattened_mut(), second.as_flattened().iter().copied());
        first
    }

    /// Adds the strips of some fours, from this lane on, to the sums.
    #[inline(always)]
    fn add_strips<P: Strips<F>, const ROWS: usize>(
        &self, strips: &CommonCreepage<P>, group: &[FourStrips<F::Stored>], lane: usize,
        sums: &mut Rows<P, ROWS>,
    ) {
        let constants = Tables::<F::Stored, _>::new(|couple: &[F::Stored; 2]| {
            P::gather(|k| of_lane(couple, lane + k))
        });
        let fields = fields(|of, odd| {
            P::gather(|k| {
                let four = group.get(k / 4).or(group.first());
                four.map_or(F::zero(), |four| of_side(of(four), lane + k % 4, odd))
            })
        });
        let seen = strips.seen(&fields);
        let StripForces { fx, fy, mx, stick } = if ROWS == SLOPES {
            let arms = [self.contact.root, self.contact.upright].map(P::all);
            let (spin, by_spin) = (&strips.spin, &strips.by_spin);
            let (carried, own) = if P::COUNT == 1 && F::LANES == 1 {
                alone_with_slopes(&seen, spin, lane & 1 == 1, by_spin)
            } else {
                forces_and_slopes(&seen, spin, &constants, by_spin)
            };
            let own = by_law(own, &fields, arms);
            add(
                sums.as_flattened_mut().get_mut(6..).unwrap_or_default(),
                own.as_flattened().iter().copied(),
            );
            carried
        } else {
            forces(&seen, &strips.spin, &constants, |_, _| ()).0
        };
        // The sums of f_x, f_y, the two parts of the moment, and the stick area.
        let [.., load, load_c, load_y, area, _] = fields;
        let shares = [fx * load, fy * load, mx * load_c, fx * load_y, stick * area];
        add(sums.as_flattened_mut(), shares);
    }

    /// The forces of each strip, divided by the contact's friction bound, ascending in `y`. Their
    /// sum is the result of [`EllipseStrips::totals_of_strips`].
    pub fn each_strip(&self, creepage: [F; 3], mut take: impl FnMut(Totals<F>))
    where
        F: Float,
    {
        let law = self.contact.see(creepage);
        let [values] = self.sums::<Lanes<F, 1>, VALUES>(&law);
        let sums = self.values(values);
        let whole = power_projected(sums, law.creepage, &self.contact.linear);
        let strips = CommonCreepage::new(&law, |x| x);
        let mut strip = |i: usize, lane: usize| {
            let Some(four) = self.rule.fours.get(i) else { return };
            let fields = fields(|of, odd| of_side::<F>(of(four), lane, odd));
            let seen = strips.seen(&fields);
            let StripForces { fx, fy, mx, stick } = alone(&seen, &strips.spin, lane & 1 == 1);
            let [.., load, load_c, load_y, _, _] = fields;
            let Flexibilities { root, upright, .. } = self.contact;
            let mz = mx * load_c * root - fx * load_y * upright;
            take(Totals {
                fx: fx * load + load * (whole.fx - sums.fx),
                fy: fy * load + load * (whole.fy - sums.fy),
                mz: mz + load * (whole.mz - sums.mz),
                stick,
            });
        };
        let count = self.rule.fours.len();
        // [Y₀, Y₁, −Y₀, −Y₁] with Y₀ > Y₁; the fours begin in the middle.
        for i in (0..count).rev() {
            strip(i, 2);
            strip(i, 3);
        }
        for i in 0..count {
            strip(i, 1);
            strip(i, 0);
        }
    }

    /// `√(a/b)` within the limits of the model.
    pub fn root(&self) -> F {
        self.contact.root
    }
}

#[inline(never)]
pub(crate) fn alone<T: Arithmetic<Value: Real>>(
    seen: &StripCreepage<T>, spin: &Spin<T>, inner: bool,
) -> StripForces<T> {
    let constants = Tables::<<T::Value as Real>::Stored, _>::new(|couple: &[_; 2]| {
        of_lane::<T::Value>(couple, usize::from(inner))
    });
    forces(seen, spin, &constants, |_, _| ()).0
}

/// The number for a strip of a four, `[Y₀, Y₁, −Y₀, −Y₁]`: outer and inner take turns.
#[inline]
fn of_lane<F: Real>([outer, inner]: &[F::Stored; 2], lane: usize) -> F {
    F::stored(if lane & 1 == 1 { *inner } else { *outer })
}

/// The number for a strip of a four, with the opposite sign at `−Y` if the field is odd.
#[inline]
fn of_side<F: Real>(couple: &[F::Stored; 2], lane: usize, odd: bool) -> F {
    let field = of_lane::<F>(couple, lane);
    if odd && lane & 2 == 2 { -field } else { field }
}

/// The creepages that the strips of an ellipse have in common.
pub(super) struct CommonCreepage<P> {
    /// `a_x, a_y, ρ, ε` and the start.
    law: [P; 5],
    pub(super) spin: Spin<P>,
    /// Used only with derivatives.
    pub(super) by_spin: SpinSlopes<P>,
}

impl<P: Arithmetic<Value = P>> CommonCreepage<P> {
    /// These creepages in numbers `P`, converted by `all`.
    #[inline(always)]
    pub(super) fn new<F: Real>(law: &Distribution<F>, all: impl Fn(F) -> P + Copy) -> Self {
        let spin = Spin::new(law.spin);
        let by_spin = SpinSlopes::new(&spin).map(all);
        let Distribution { longitudinal, lateral, slope, bend, start, .. } = *law;
        let law = P::each(&[longitudinal, lateral, slope, bend, start], |x| all(*x));
        Self { law, spin: spin.map(all), by_spin }
    }

    /// `A_x = (a_x − ρ Y (1 + ε (0.4 − Y²)))/C`, `A_y = a_y/C`
    #[inline(always)]
    pub(super) fn seen(&self, fields: &[P; STRIP_FIELDS]) -> StripCreepage<P> {
        let [y, inverse, bend_y, .., width] = *fields;
        let [longitudinal, lateral, slope, bend, start] = self.law;
        StripCreepage {
            x: (longitudinal - slope * (bend * bend_y + y)) * inverse,
            y: lateral * inverse,
            spread: slope * width,
            start,
        }
    }
}

/// Derivatives of forces and moment with respect to `Distribution::numbers`, from those of `f_x,
/// f_y, m_x` with respect to the creepages of the strips.
#[inline(always)]
pub(super) fn by_law<P: Arithmetic>(
    [x, y, mut z]: [[P; 5]; 3], fields: &[P; STRIP_FIELDS], [root, upright]: [P; 2],
) -> [[P; 6]; 3] {
    let [at, inverse, bend, load, load_c, load_y, _, width] = *fields;
    // Mz = ∫ (x Y − y X): lever arms √(a/b) C x̂ and √(b/a) Y
    let (arm_m, arm_x) = (load_c * root, load_y * upright);
    for (z, x) in z.iter_mut().zip(x) {
        *z = *z * arm_m - x * arm_x;
    }
    let loaded = |slopes: [P; 5]| P::each(&slopes, |slope| *slope * load);
    [loaded(x), loaded(y), z].map(|[by_x, by_y, by_spin, by_spread, by_start]| {
        let scaled = by_x * inverse;
        let slope = by_spread * width - scaled * at;
        [scaled, by_y * inverse, slope, -(scaled * bend), by_spin, by_start]
    })
}

/// The fields of strips, each read from its pair; `y`, `bend` and `load_y` are odd in `y`.
#[inline(always)]
pub(super) fn fields<F: 'static, P>(
    read: impl Fn(fn(&FourStrips<F>) -> &[F; 2], bool) -> P,
) -> [P; STRIP_FIELDS] {
    [
        read(|[y, ..]| y, true),
        read(|[_, inverse, ..]| inverse, false),
        read(|[_, _, bend, ..]| bend, true),
        read(|[_, _, _, load, ..]| load, false),
        read(|[_, _, _, _, load_c, ..]| load_c, false),
        read(|[_, _, _, _, _, load_y, ..]| load_y, true),
        read(|[.., area, _]| area, false),
        read(|[.., width]| width, false),
    ]
}
