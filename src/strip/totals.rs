//! Sums over the strips of the Hertz ellipse, four at a time, and the power that they must not gain.

use super::any::{Forces, Slopes, both_kinds, of_eight, parts_of_eight};
use super::creepage::{Law, Prepared};
use super::derivative::{SpinSlopes, forces_and_slopes};
use super::kernel::{Carried, Seen, Spin, forces};
use super::single;
use super::tables::{FourStrips, Rule, STRIP_FIELDS, Tables};
use crate::contact::forces::{StripCount, Totals};
use crate::linear::LinearCoefficients;
use crate::number::{Arithmetic, Float, Number, Plain, Quad, once};

/// Power over that of the linear theory divided by `√(1 + n²)`: never below this.
const FLOOR: f64 = 0.2;
/// Nothing happens above the floor and this. References computed with CONTACT are above 0.64.
const STEP: f64 = 0.2;

/// A contact's strips, ready for creepages.
#[derive(Clone, Copy, Debug)]
pub struct PreparedStrips<F: Plain> {
    pub(crate) contact: Prepared<F>,
    pub(super) rule: Rule<F::Stored>,
}

/// Numbers that contacts are solved in, and how their strips are added up.
pub trait StripTotals: Plain {
    /// [`PreparedStrips::totals`], in wide registers if there are any.
    #[inline(always)]
    fn strip_totals<T: Number<Base = Self>>(
        strips: &PreparedStrips<Self>,
        creepage: [T; 3],
    ) -> Totals<T> {
        once!(T, strips.totals(creepage))
    }
    /// What any eight strips carry that see `A_x, A_y, σ`, the spread and the start, each with its share of the inner nodes.
    #[inline(always)]
    fn eight_forces(seen: [[Self; 8]; 5], inner: [Self; 8]) -> Forces<Self, 8> {
        if cfg!(target_os = "none") {
            return single::eight::<_, false>(seen, inner).0;
        }
        both_kinds::<_, _, 8, false>(seen, inner, of_eight, parts_of_eight).0
    }
    /// That, and its derivatives.
    #[inline(always)]
    fn eight_slopes(seen: [[Self; 8]; 5], inner: [Self; 8]) -> (Forces<Self, 8>, Slopes<Self, 8>) {
        if cfg!(target_os = "none") {
            return single::eight::<_, true>(seen, inner);
        }
        both_kinds::<_, _, 8, true>(seen, inner, of_eight, parts_of_eight)
    }
}

impl StripTotals for f32 {}
#[cfg(target_arch = "x86_64")]
impl StripTotals for crate::number::lanes::F64x4 {}
#[cfg(target_arch = "x86_64")]
impl StripTotals for crate::number::lanes::F32x8 {}
#[cfg(not(target_arch = "x86_64"))]
impl StripTotals for f64 {}

/// Sums over the strips of a contact: `F_x/(μ N)`, `F_y/(μ N)`, `M_z/(μ N √(ab))` and the share in adhesion, and the
/// derivatives of the first three by `Law::numbers`.
#[derive(Clone, Copy, Debug)]
pub struct Sums<F> {
    values: [F; 4],
    slopes: [[F; 6]; 3],
}

impl<F: Plain> Sums<F> {
    /// From `f_x, f_y`, the two parts of the moment and the stick area.
    #[inline(always)]
    pub(super) fn of(values: [F; 5], slopes: [[F; 6]; 3], contact: &Prepared<F>) -> Self {
        let [fx, fy, by_x, by_y, stick] = values;
        let mz = by_x * contact.root - by_y * contact.upright;
        Self { values: [fx, fy, mz, stick.clamped(F::zero(), F::one())], slopes }
    }
}

impl<F: Plain> PreparedStrips<F> {
    /// `axis_ratio` is `a/b`, `linear` the coefficients for it.
    #[inline(always)]
    pub fn new(
        axis_ratio: F,
        poisson_ratio: F,
        linear: &LinearCoefficients<F>,
        count: StripCount,
    ) -> Self {
        let rule = Rule::new(count);
        let factors = [F::stored(rule.stretch), F::stored(rule.lever)];
        Self { contact: Prepared::new(axis_ratio, poisson_ratio, linear, factors), rule }
    }

    /// The strips of a contact that has been prepared for their number.
    #[inline(always)]
    pub(crate) fn from_prepared(contact: Prepared<F>, count: StripCount) -> Self {
        Self { contact, rule: Rule::new(count) }
    }

    /// Forces, moment and share in adhesion for `vx, vy = G a b (υx, υy)/(μ N)`, `φ = G (a b)^{3/2} ϕ/(μ N)`.
    #[inline(always)]
    pub fn totals<T: Number<Base = F>>(&self, creepage: [T; 3]) -> Totals<T> {
        let law = self.contact.see(creepage);
        let sums = if T::HAS_DERIVATIVES {
            self.plain_sums::<true>(&law.value())
        } else {
            self.plain_sums::<false>(&law.value())
        };
        self.totals_of(&law, sums)
    }

    /// Without wide registers.
    #[inline(always)]
    fn plain_sums<const SLOPES: bool>(&self, law: &Law<F>) -> Sums<F> {
        if cfg!(target_os = "none") {
            single::sums::<F, SLOPES>(&self.contact, self.rule.fours, law)
        } else {
            self.sums::<Quads, SLOPES>(law)
        }
    }

    /// From the sums over the strips, with the derivatives of what they see.
    #[inline(always)]
    pub(super) fn totals_of<T: Number<Base = F>>(&self, law: &Law<T>, sums: Sums<F>) -> Totals<T> {
        let Sums { values: [fx, fy, mz, stick], slopes: [by_x, by_y, by_m] } = sums;
        let by = law.numbers();
        let totals = Totals {
            fx: T::follow(fx, by_x, by),
            fy: T::follow(fy, by_y, by),
            mz: T::follow(mz, by_m, by),
            stick: T::from_base(stick),
        };
        power_projected(totals, law.creepage, &self.contact.linear)
    }

    /// Sums over the strips, group by group. Every fourth four is added up apart, whatever a group is.
    #[inline(always)]
    pub(super) fn sums<R: Group<F>, const SLOPES: bool>(&self, law: &Law<F>) -> Sums<F> {
        let zero = R::Strips::zero();
        let mut sums = [[zero; 4]; 5];
        let mut slopes = [[[zero; 4]; 6]; 3];
        let arms = [self.contact.root, self.contact.upright].map(R::all);
        let strips = Together::new(law, R::all);
        let constants = Tables::<F::Stored, _>::new(R::couple);
        for (i, group) in R::groups(self.rule.fours).iter().enumerate() {
            let fields = fields(|of, odd| R::field(group, of, odd));
            let (seen, chain) = (strips.seen(&fields), i % (4 / R::FOURS));
            let carried = if SLOPES {
                let (carried, own) =
                    forces_and_slopes(&seen, &strips.spin, &constants, &strips.by_spin);
                for (slopes, own) in slopes.iter_mut().zip(by_law(own, &fields, arms)) {
                    add(slopes, chain, own);
                }
                carried
            } else {
                forces(&seen, &strips.spin, &constants, |_, _| ()).0
            };
            add(&mut sums, chain, shares(carried, &fields));
        }
        let mut values = [F::zero(); 5];
        for (value, sum) in values.iter_mut().zip(&sums) {
            *value = R::sum(sum);
        }
        let mut by_law = [[F::zero(); 6]; 3];
        if SLOPES {
            for (by_law, slopes) in by_law.iter_mut().zip(&slopes) {
                for (value, slope) in by_law.iter_mut().zip(slopes) {
                    *value = R::sum(slope);
                }
            }
        }
        Sums::of(values, by_law, &self.contact)
    }

    /// Fours of strips.
    #[cfg(target_arch = "x86_64")]
    pub(super) fn fours(&self) -> usize {
        self.rule.fours.len()
    }

    /// What each strip carries of the contact's friction bound, with its share of the area, ascending in `y`; their sum is
    /// what [`PreparedStrips::totals`] answers.
    pub fn each(&self, creepage: [F; 3], mut take: impl FnMut(Totals<F>, F))
    where
        F: Float,
    {
        let law = self.contact.see(creepage);
        let Sums { values: [fx, fy, mz, stick], .. } = self.plain_sums::<false>(&law);
        let sums = Totals { fx, fy, mz, stick };
        let whole = power_projected(sums, law.creepage, &self.contact.linear);
        let strips = Together::new(&law, |x| x);
        let mut strip = |i: usize, lane: usize| {
            let Some(four) = self.rule.fours.get(i) else { return };
            let fields = single::fields_of(four, lane);
            let Carried { fx, fy, mx, stick } = single::strip(&strips, &fields, lane);
            let [.., load, load_c, load_y, area, _] = fields;
            let Prepared { root, upright, .. } = self.contact;
            let mz = mx * load_c * root - fx * load_y * upright;
            let found = Totals {
                fx: fx * load + load * (whole.fx - sums.fx),
                fy: fy * load + load * (whole.fy - sums.fy),
                mz: mz + load * (whole.mz - sums.mz),
                stick,
            };
            take(found, area);
        };
        let count = self.rule.fours.len();
        // [Y₀, Y₁, −Y₀, −Y₁] with Y₀ > Y₁, fours from the middle on
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

/// What strips of an ellipse have in common: one spin.
pub(super) struct Together<P> {
    /// `a_x, a_y, ρ, ε` and the start.
    law: [P; 5],
    pub(super) spin: Spin<P>,
    /// (Without derivatives nobody reads them.)
    pub(super) by_spin: SpinSlopes<P>,
}

impl<P: Arithmetic<Bare = P>> Together<P> {
    /// In numbers `P` that are `all` the same.
    #[inline(always)]
    pub(super) fn new<F: Plain>(law: &Law<F>, all: impl Fn(F) -> P + Copy) -> Self {
        let spin = Spin::new(law.spin);
        let by_spin = SpinSlopes::new(&spin).map(all);
        let Law { longitudinal, lateral, slope, bend, start, .. } = *law;
        let law = P::each(&[longitudinal, lateral, slope, bend, start], |x| all(*x));
        Self { law, spin: spin.map(all), by_spin }
    }

    /// `A_x = (a_x − ρ Y (1 + ε (0.4 − Y²)))/C`, `A_y = a_y/C`
    #[inline(always)]
    pub(super) fn seen(&self, fields: &[P; STRIP_FIELDS]) -> Seen<P> {
        let [y, inverse, bend_y, .., width] = *fields;
        let [longitudinal, lateral, slope, bend, start] = self.law;
        Seen {
            x: (longitudinal - slope * (bend * bend_y + y)) * inverse,
            y: lateral * inverse,
            spread: slope * width,
            start,
        }
    }
}

/// Shares of `f_x, f_y`, the two parts of the moment, and the stick area.
#[inline(always)]
pub(super) fn shares<P: Arithmetic>(carried: Carried<P>, fields: &[P; STRIP_FIELDS]) -> [P; 5] {
    let [.., load, load_c, load_y, area, _] = *fields;
    let Carried { fx, fy, mx, stick } = carried;
    [fx * load, fy * load, mx * load_c, fx * load_y, stick * area]
}

/// Derivatives of forces and moment by `Law::numbers` from those of `f_x, f_y, m_x` by what the strips see.
#[inline(always)]
pub(super) fn by_law<P: Arithmetic>(
    [x, y, mut z]: [[P; 5]; 3],
    fields: &[P; STRIP_FIELDS],
    [root, upright]: [P; 2],
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

/// Adds numbers to a chain of their sums.
#[inline(always)]
fn add<P: Arithmetic, const N: usize>(sums: &mut [[P; 4]; N], chain: usize, own: [P; N]) {
    for (sums, own) in sums.iter_mut().zip(own) {
        if let Some(sum) = sums.get_mut(chain) {
            *sum += own;
        }
    }
}

/// Strips that are computed side by side.
pub(crate) trait Group<F: Plain> {
    /// Numbers of all of them.
    type Strips: Arithmetic<Bare = Self::Strips>;
    /// Their places.
    type Places: 'static;
    /// How many fours: 1, 2 or 4.
    const FOURS: usize;
    fn groups(fours: &'static [FourStrips<F::Stored>]) -> &'static [Self::Places];
    /// One number for all.
    fn all(x: F) -> Self::Strips;
    /// One for the outer strips and one for the inner ones.
    fn couple(couple: &[F::Stored; 2]) -> Self::Strips;
    /// A field of the strips; of odd ones the sign changes with that of `y`.
    fn field(
        places: &Self::Places,
        of: fn(&FourStrips<F::Stored>) -> &[F::Stored; 2],
        odd: bool,
    ) -> Self::Strips;
    /// Of the chains of additions over each fourth four: `(c₀ + c₂) + (c₁ + c₃)`, and of its strips the same.
    fn sum(chains: &[Self::Strips; 4]) -> F;
}

/// Four in [`Number::Quad`].
pub(super) struct Quads;

impl<F: Plain> Group<F> for Quads {
    type Strips = F::Quad;
    type Places = FourStrips<F::Stored>;
    const FOURS: usize = 1;
    #[inline(always)]
    fn groups(fours: &'static [FourStrips<F::Stored>]) -> &'static [Self::Places] {
        fours
    }
    #[inline(always)]
    fn all(x: F) -> F::Quad {
        F::Quad::all(x)
    }
    #[inline(always)]
    fn couple(couple: &[F::Stored; 2]) -> F::Quad {
        F::Quad::plain(both_sides::<F>(couple, false))
    }
    #[inline(always)]
    fn field(
        places: &Self::Places,
        of: fn(&FourStrips<F::Stored>) -> &[F::Stored; 2],
        odd: bool,
    ) -> F::Quad {
        F::Quad::plain(both_sides::<F>(of(places), odd))
    }
    #[inline(always)]
    fn sum([a, b, c, d]: &[F::Quad; 4]) -> F {
        ((*a + *c) + (*b + *d)).sum()
    }
}

/// Strips at `Y` and `−Y`: the numbers of two, twice, the second time with the other sign if they are odd.
#[inline(always)]
pub(super) fn both_sides<F: Plain>(couple: &[F::Stored; 2], odd: bool) -> [F; 4] {
    let [a, b] = F::both_stored(*couple);
    if odd { [a, b, -a, -b] } else { [a, b, a, b] }
}

/// The fields of strips, each read from its couple; `y`, `bend` and `load_y` are odd in `y`.
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

/// A force of size one and some roundings within the bound, which it may pass by them.
#[inline(always)]
fn within_bound<T: Number>([x, y]: [T; 2]) -> [T; 2] {
    let over = (x.value().squared() + y.value().squared()).plus(-1.0).max(T::Base::zero());
    let size = T::Base::one() - over.times(0.5);
    [x.scale(size), y.scale(size)]
}

/// Forces moved so that friction takes power out: `F·v n/(v·K v)`, `K = diag(C11, C22, C33)`,
/// `n² = 1 + |K v|² + (C23 φ)²`, is 1 at rest in every direction, and lifted where it is below [`FLOOR`] + [`STEP`], to no
/// less than [`FLOOR`] and with a continuous slope.
///
/// `F' = F + λ h K v` with `h = (1 − |F|²)/10` on the forces and 1 on the moment; beyond `|F'| = 1` all of it is scaled down.
#[inline(always)]
pub(super) fn power_projected<T: Number>(
    totals: Totals<T>,
    creepage: [T; 3],
    linear: &LinearCoefficients<T::Base>,
) -> Totals<T> {
    let [vx, vy, phi] = creepage;
    let [kx, ky, ks] = [vx.scale(linear.c11), vy.scale(linear.c22), phi.scale(linear.c33)];
    let square = kx.squared() + ky.squared() + ks.squared() + phi.scale(linear.c23).squared();
    let Totals { fx, fy, mz, stick } = totals;
    let [fx, fy] = within_bound([fx, fy]);
    let totals = Totals { fx, fy, mz, stick };
    let power = fx * vx + fy * vy + mz * phi;
    let whole = kx * vx + ky * vy + ks * phi;
    // nothing to do at rest, where squares may vanish, and for x > FLOOR + STEP
    let n = square.plus(1.0).sqrt();
    let loaded = square.plus(-1e-12);
    let missing = whole.times(FLOOR + STEP) - power * n;
    let low = loaded.choose(missing, -T::one());
    if !low.exceeds(T::zero()) {
        return totals;
    }
    // x = P n/(v·K v) − FLOOR; what is missing to max(x, 0), rounded over ± STEP
    let whole = loaded.choose(whole, T::one());
    let x = (power * n / whole).plus(-FLOOR);
    let short = (T::constant(STEP) - x).max(T::zero());
    let lift = (-x).plus(-STEP).choose(-x, short.squared().times(0.25 / STEP));
    let h = (T::one() - (fx.squared() + fy.squared())).max(T::zero()).times(0.1);
    let along = h * (kx * vx + ky * vy) + ks * phi;
    let along = loaded.choose(along, T::one());
    let factor = lift / n * (whole / along.max(T::tiny()));
    let (x, y) = (fx + factor * h * kx, fy + factor * h * ky);
    let size = (x.squared() + y.squared()).max(T::one()).inverse_root();
    let [x, y] = within_bound([x * size, y * size]);
    Totals {
        fx: low.choose(x, fx),
        fy: low.choose(y, fy),
        mz: low.choose((mz + factor * ks) * size, mz),
        stick,
    }
}
