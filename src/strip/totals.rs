//! Sums over the strips of the Hertz ellipse, four at a time, and the power that they must not gain.

use super::constants::NODES;
use super::creepage::{Law, Prepared};
use super::derivative::{SpinSlopes, forces_and_slopes};
use super::kernel::{Carried, Seen, Spin, forces};
use super::tables::{Closed, FourStrips, Kernel, Node, Rule, STRIP_FIELDS};
use crate::contact::forces::{StripCount, Totals};
use crate::linear::LinearCoefficients;
use crate::number::{Arithmetic, Float, Number, Plain, Quad};

/// Power over that of the linear theory divided by `√(1 + n²)`: never below this.
const FLOOR: f64 = 0.2;
/// Nothing happens above the floor and this. References computed with CONTACT are above 0.64.
const STEP: f64 = 0.2;

/// A contact's strips, ready for creepages.
#[derive(Clone, Copy, Debug)]
pub struct PreparedStrips<F: Plain> {
    pub(crate) contact: Prepared<F>,
    rule: Rule<F::Stored>,
}

/// Sums over the strips of a contact: `F_x/(μ N)`, `F_y/(μ N)`, `M_z/(μ N √(ab))` and the share in adhesion, and the
/// derivatives of the first three by [`Law::numbers`].
#[derive(Clone, Copy, Debug)]
pub struct Sums<F> {
    values: [F; 4],
    slopes: [[F; 6]; 3],
}

/// Numbers whose strips are added up in the widest registers that there are.
pub trait StripSums: Plain {
    /// Sums over the strips of a contact, with slopes where they are wanted.
    #[inline(always)]
    fn strip_sums(strips: &PreparedStrips<Self>, law: &Law<Self>, slopes: bool) -> Sums<Self> {
        strips.sums(law, slopes)
    }
}

impl StripSums for f32 {}
#[cfg(not(target_arch = "x86_64"))]
impl StripSums for f64 {}

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
        let factors = [F::of(rule.stretch), F::of(rule.lever)];
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
        self.totals_by(creepage, Self::sums)
    }

    /// [`PreparedStrips::totals`] with strips added up by `sums`.
    #[inline(always)]
    pub(crate) fn totals_by<T: Number<Base = F>>(
        &self,
        creepage: [T; 3],
        sums: impl Fn(&Self, &Law<F>, bool) -> Sums<F>,
    ) -> Totals<T> {
        let law = self.contact.see(creepage);
        let Sums { values: [fx, fy, mz, stick], slopes: [by_x, by_y, by_m] } =
            sums(self, &law.value(), T::HAS_DERIVATIVES);
        let by = law.numbers();
        let totals = Totals {
            fx: T::follow(fx, by_x, by),
            fy: T::follow(fy, by_y, by),
            mz: T::follow(mz, by_m, by),
            stick: T::from_base(stick),
        };
        power_projected(totals, law.creepage, &self.contact.linear)
    }

    /// Sums over the strips, four at a time in [`Number::Quad`].
    #[inline(always)]
    pub(crate) fn sums(&self, law: &Law<F>, slopes: bool) -> Sums<F> {
        self.sums_in::<Quads>(law, slopes)
    }

    /// Sums over the strips, four at a time.
    #[inline(always)]
    pub(crate) fn sums_in<R: Fours<F>>(&self, law: &Law<F>, slopes: bool) -> Sums<F> {
        let zero = R::Four::zero();
        let [mut fx, mut fy, mut by_x, mut by_y, mut stick] = [zero; 5];
        let mut sums = [[zero; 6]; 3];
        let Prepared { root, upright, .. } = self.contact;
        let strips = Together::new::<F, R>(law);
        for four in self.rule.fours {
            let fields = fields::<F, R>(four);
            let [.., load, load_c, load_y, area, _] = fields;
            let carried = if slopes {
                let (carried, [x, y, m]) = strips.forces_and_slopes(&fields);
                // Mz = ∫ (x Y − y X): lever arms √(a/b) C x̂ and √(b/a) Y
                let (arm_m, arm_x) = (load_c * R::all(root), load_y * R::all(upright));
                let mut z = m;
                for (z, x) in z.iter_mut().zip(x) {
                    *z = *z * arm_m - x * arm_x;
                }
                let [sum_x, sum_y, sum_z] = &mut sums;
                strips.add(sum_x, R::Four::each(&x, |slope| *slope * load), &fields);
                strips.add(sum_y, R::Four::each(&y, |slope| *slope * load), &fields);
                strips.add(sum_z, z, &fields);
                carried
            } else {
                strips.forces(&fields)
            };
            fx += carried.fx * load;
            fy += carried.fy * load;
            by_x += carried.mx * load_c;
            by_y += carried.fx * load_y;
            stick += carried.stick * area;
        }
        let mz = R::sum(by_x) * root - R::sum(by_y) * upright;
        let stick = R::sum(stick).clamped(F::zero(), F::one());
        let mut by_law = [[F::zero(); 6]; 3];
        for (by_law, sums) in by_law.iter_mut().zip(&sums) {
            *by_law = F::each(sums, |sum| R::sum(*sum));
        }
        Sums { values: [R::sum(fx), R::sum(fy), mz, stick], slopes: by_law }
    }

    /// What each strip carries of the contact's friction bound, with its share of the area, ascending in `y`; their sum is
    /// what [`PreparedStrips::totals`] answers.
    pub fn each(&self, creepage: [F; 3], mut take: impl FnMut(Totals<F>, F))
    where
        F: Float,
    {
        let law = self.contact.see(creepage);
        let Sums { values: [fx, fy, mz, stick], .. } = self.sums(&law, false);
        let sums = Totals { fx, fy, mz, stick };
        let whole = power_projected(sums, law.creepage, &self.contact.linear);
        let strips = Together::new::<F, Quads>(&law);
        let mut strip = |i: usize, lane: usize| {
            let Some(four) = self.rule.fours.get(i) else { return };
            let fields = fields::<F, Quads>(four);
            let Carried { fx, fy, mx, stick } = strips.forces(&fields);
            let [.., load, load_c, load_y, area, _] = fields;
            let Prepared { root, upright, .. } = self.contact;
            let mz = (mx * load_c).scale(root) - (fx * load_y).scale(upright);
            let of = |quad: F::Quad| quad.parts().get(lane).copied().unwrap_or(F::zero());
            let share = of(load);
            let found = Totals {
                fx: of(fx * load) + share * (whole.fx - sums.fx),
                fy: of(fy * load) + share * (whole.fy - sums.fy),
                mz: of(mz) + share * (whole.mz - sums.mz),
                stick: of(stick),
            };
            take(found, of(area));
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

/// The kernel for strips of an ellipse side by side, which have one spin.
struct Together<P: Arithmetic> {
    /// `a_x, a_y, ρ, ε` and the start.
    law: [P; 5],
    spin: Spin<P>,
    by_spin: SpinSlopes<P>,
    nodes: [Node<P>; NODES],
    closed: Closed<P>,
}

impl<P: Arithmetic<Bare = P>> Together<P> {
    #[inline(always)]
    fn new<F: Plain, R: Fours<F, Four = P>>(law: &Law<F>) -> Self {
        let spin = Spin::new(law.spin);
        // (without derivatives nobody reads them)
        let by_spin = SpinSlopes::new(&spin).map(R::all);
        let (nodes, closed) = Kernel::<F::Stored>::get().read(both_sides::<F, R>);
        let Law { longitudinal, lateral, slope, bend, start, .. } = *law;
        let law = P::each(&[longitudinal, lateral, slope, bend, start], |x| R::all(*x));
        Self { law, spin: spin.map(R::all), by_spin, nodes, closed }
    }

    /// `A_x = (a_x − ρ Y (1 + ε (0.4 − Y²)))/C`, `A_y = a_y/C`
    #[inline(always)]
    fn seen(&self, fields: &[P; STRIP_FIELDS]) -> Seen<P> {
        let [y, inverse, bend_y, .., width] = *fields;
        let [longitudinal, lateral, slope, bend, start] = self.law;
        Seen {
            x: (longitudinal - slope * (bend * bend_y + y)) * inverse,
            y: lateral * inverse,
            spread: slope * width,
            start,
        }
    }

    #[inline(always)]
    fn forces(&self, fields: &[P; STRIP_FIELDS]) -> Carried<P> {
        forces(&self.seen(fields), &self.spin, &self.nodes, &self.closed).0
    }

    #[inline(always)]
    fn forces_and_slopes(&self, fields: &[P; STRIP_FIELDS]) -> (Carried<P>, [[P; 5]; 3]) {
        let Self { spin, nodes, closed, by_spin, .. } = self;
        forces_and_slopes(&self.seen(fields), spin, nodes, closed, by_spin)
    }

    /// Adds derivatives by what the strips see to those by [`Law::numbers`].
    #[inline(always)]
    fn add(&self, sums: &mut [P; 6], by_seen: [P; 5], fields: &[P; STRIP_FIELDS]) {
        let [y, inverse, bend, .., width] = *fields;
        let [by_x, by_y, by_spin, by_spread, by_start] = by_seen;
        let scaled = by_x * inverse;
        let [longitudinal, lateral, slope, bent, spin, start] = sums;
        *longitudinal += scaled;
        *lateral += by_y * inverse;
        *slope += by_spread * width - scaled * y;
        *bent -= scaled * bend;
        *spin += by_spin;
        *start += by_start;
    }
}

/// How four strips stand side by side.
pub(crate) trait Fours<F> {
    type Four: Arithmetic<Bare = Self::Four>;
    fn all(x: F) -> Self::Four;
    fn of(numbers: [F; 4]) -> Self::Four;
    fn sum(four: Self::Four) -> F;
}

/// In [`Number::Quad`].
struct Quads;

impl<F: Plain> Fours<F> for Quads {
    type Four = F::Quad;
    #[inline(always)]
    fn all(x: F) -> F::Quad {
        F::Quad::all(x)
    }
    #[inline(always)]
    fn of(numbers: [F; 4]) -> F::Quad {
        F::Quad::plain(numbers)
    }
    #[inline(always)]
    fn sum(four: F::Quad) -> F {
        four.sum()
    }
}

/// Strips at `Y` and `−Y`: the numbers of two, twice.
#[inline(always)]
fn both_sides<F: Plain, R: Fours<F>>(couple: &[F::Stored; 2]) -> R::Four {
    let [a, b] = F::both_stored(*couple);
    R::of([a, b, a, b])
}

/// The fields of four strips: `y`, `bend` and `load_y` are odd in `y`.
#[inline(always)]
fn fields<F: Plain, R: Fours<F>>(four: &FourStrips<F::Stored>) -> [R::Four; STRIP_FIELDS] {
    let even = both_sides::<F, R>;
    let odd = |couple: &[F::Stored; 2]| {
        let [a, b] = F::both_stored(*couple);
        R::of([a, b, -a, -b])
    };
    let [y, inverse, bend, load, load_c, load_y, area, width] = four;
    [
        odd(y),
        even(inverse),
        odd(bend),
        even(load),
        even(load_c),
        odd(load_y),
        even(area),
        even(width),
    ]
}

/// Any four strips: what each sees, its spin, and whether it is an inner one (of neighbours one is).
#[inline(never)]
pub(crate) fn four_strips<T: Number>(
    seen: &[(Seen<T>, T); 4],
    inner: [bool; 4],
) -> [Carried<T>; 4] {
    type Four<T> = <<T as Arithmetic>::Base as Number>::Quad;
    let four = |of: fn(&(Seen<T>, T)) -> T| -> Four<T> {
        Quad::of(seen.each_ref().map(|own| of(own).value()))
    };
    let spin = Spin::new(four(|(_, spin)| *spin));
    let plain = Seen {
        x: four(|(seen, _)| seen.x),
        y: four(|(seen, _)| seen.y),
        spread: four(|(seen, _)| seen.spread),
        start: four(|(seen, _)| seen.start),
    };
    let (nodes, closed) = Kernel::<<T::Base as Plain>::Stored>::get().read(|[outer, other]| {
        let own = |inner| T::Base::stored(if inner { *other } else { *outer });
        <Four<T> as Quad<T::Base>>::plain(inner.map(own))
    });
    let (Carried { fx, fy, mx, stick }, slopes) = if T::HAS_DERIVATIVES {
        forces_and_slopes(&plain, &spin, &nodes, &closed, &SpinSlopes::new(&spin))
    } else {
        (forces(&plain, &spin, &nodes, &closed).0, [[Four::<T>::zero(); 5]; 3])
    };
    let [fx, fy, mx, stick] = [fx, fy, mx, stick].map(Quad::parts);
    let [by_x, by_y, by_m] = slopes.map(|slopes| slopes.map(Quad::parts));
    let mut lane = 0;
    seen.each_ref().map(|(seen, spin)| {
        let of = |four: &[T::Base; 4]| four.get(lane).copied().unwrap_or(T::Base::zero());
        let by = [seen.x, seen.y, *spin, seen.spread, seen.start];
        let follow = |value: &[T::Base; 4], slopes: &[[T::Base; 4]; 5]| {
            T::follow(of(value), slopes.each_ref().map(of), by)
        };
        let carried = Carried {
            fx: follow(&fx, &by_x),
            fy: follow(&fy, &by_y),
            mx: follow(&mx, &by_m),
            stick: T::from_base(of(&stick)),
        };
        lane += 1;
        carried
    })
}

/// Forces moved so that friction takes power out: `F·v n/(v·K v)`, `K = diag(C11, C22, C33)`,
/// `n² = 1 + |K v|² + (C23 φ)²`, is 1 at rest in every direction, and lifted where it is below [`FLOOR`] + [`STEP`], to no
/// less than [`FLOOR`] and with a continuous slope.
///
/// `F' = F + λ h K v` with `h = (1 − |F|²)/10` on the forces and 1 on the moment; beyond `|F'| = 1` all of it is scaled down.
#[inline(always)]
fn power_projected<T: Number>(
    totals: Totals<T>,
    creepage: [T; 3],
    linear: &LinearCoefficients<T::Base>,
) -> Totals<T> {
    let [vx, vy, phi] = creepage;
    let [kx, ky, ks] = [vx.scale(linear.c11), vy.scale(linear.c22), phi.scale(linear.c33)];
    let square = kx.squared() + ky.squared() + ks.squared() + phi.scale(linear.c23).squared();
    let Totals { fx, fy, mz, stick } = totals;
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
    Totals {
        fx: low.choose(x * size, fx),
        fy: low.choose(y * size, fy),
        mz: low.choose((mz + factor * ks) * size, mz),
        stick,
    }
}
