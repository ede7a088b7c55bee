//! Sums over the strips of the Hertz ellipse, four at a time, and the power that they must not gain.

use super::constants::NODES;
use super::creepage::{Law, Prepared};
use super::derivative::{Four, SpinSlopes, differentiated};
use super::kernel::{Carried, Seen, Spin};
use super::tables::{Closed, FourStrips, Kernel, Node, Rule, STRIP_FIELDS};
use crate::contact::forces::{StripCount, Totals};
use crate::linear::LinearCoefficients;
use crate::number::{Arithmetic, Float, Number, Plain, Quad, Stored};

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

/// Nodes and closed part for four strips.
type FourNodes<F> = ([Node<<F as Number>::Quad>; NODES], Closed<<F as Number>::Quad>);

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

    /// Forces, moment and share in adhesion for `vx, vy = G a b (υx, υy)/(μ N)`, `φ = G (a b)^{3/2} ϕ/(μ N)`.
    #[inline(always)]
    pub fn totals<T: Number<Base = F>>(&self, creepage: [T; 3]) -> Totals<T> {
        let law = self.contact.see(creepage);
        let sums = self.sum(&law);
        power_projected(sums, law.creepage, &self.contact.linear)
    }

    /// Sums over the strips.
    #[inline(always)]
    pub(super) fn sum<T: Number<Base = F>>(&self, law: &Law<T>) -> Totals<T> {
        let zero = T::Quad::zero();
        let [mut fx, mut fy, mut by_x, mut by_y, mut stick] = [zero; 5];
        let kernel = FourKernel::new(law);
        for four in self.rule.fours {
            let carried = kernel.forces(law, four);
            let [_, _, _, load, load_c, load_y, area, _] = fields::<F>(four);
            fx += carried.fx.weigh(load);
            fy += carried.fy.weigh(load);
            by_x += carried.mx.weigh(load_c);
            by_y += carried.fx.weigh(load_y);
            stick += carried.stick.weigh(area);
        }
        // Mz = ∫ (x Y − y X): lever arms √(a/b) C x̂ and √(b/a) Y
        let contact = &self.contact;
        let mz = by_x.sum().scale(contact.root) - by_y.sum().scale(contact.upright);
        let stick = stick.sum().max(T::zero()).min(T::one());
        Totals { fx: fx.sum(), fy: fy.sum(), mz, stick }
    }

    /// What each strip carries of the contact's friction bound, with its share of the area, ascending in `y`; their sum is
    /// what [`PreparedStrips::totals`] answers.
    pub fn each(&self, creepage: [F; 3], mut take: impl FnMut(Totals<F>, F))
    where
        F: Float,
    {
        let law = self.contact.see(creepage);
        let sums = self.sum(&law);
        let whole = power_projected(sums, law.creepage, &self.contact.linear);
        let kernel = FourKernel::new(&law);
        let mut strip = |i: usize, lane: usize| {
            let Some(four) = self.rule.fours.get(i) else { return };
            let Carried { fx, fy, mx, stick } = kernel.forces(&law, four);
            let [_, _, _, load, load_c, load_y, area, _] = fields::<F>(four);
            let mz =
                (mx * load_c).scale(self.contact.root) - (fx * load_y).scale(self.contact.upright);
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

/// Any four strips: what each sees, its spin, and whether it is an inner one (of neighbours one is).
#[inline(never)]
pub(crate) fn four_strips<T: Number>(
    seen: &[(Seen<T>, T); 4],
    inner: [bool; 4],
) -> [Carried<T>; 4] {
    let four = |of: fn(&(Seen<T>, T)) -> T| T::Quad::of(T::each(seen, of));
    let sigma = four(|(_, spin)| *spin);
    let spin = Spin::new(sigma.bare());
    let seen = Seen {
        x: four(|(seen, _)| seen.x),
        y: four(|(seen, _)| seen.y),
        spread: four(|(seen, _)| seen.spread),
        start: four(|(seen, _)| seen.start),
    };
    let (nodes, closed) = Kernel::<Stored<T>>::get().read(|[outer, other]| {
        Quad::plain(inner.map(|inner| T::Base::stored(if inner { *other } else { *outer })))
    });
    let by_spin = SpinSlopes::new(&spin);
    let Carried { fx, fy, mx, stick } =
        differentiated::<T>(&seen, sigma, &spin, &nodes, &closed, &by_spin);
    let [fy, mx, stick] = [fy, mx, stick].map(T::Quad::parts);
    let mut carried = fx.parts().map(|fx| Carried { fx, fy: fx, mx: fx, stick: fx });
    for (own, (fy, (mx, stick))) in
        carried.iter_mut().zip(fy.into_iter().zip(mx.into_iter().zip(stick)))
    {
        *own = Carried { fx: own.fx, fy, mx, stick };
    }
    carried
}

/// The kernel for four strips of an ellipse, which have one spin.
struct FourKernel<T: Number> {
    sigma: T::Quad,
    spin: Spin<Four<T>>,
    by_spin: SpinSlopes<Four<T>>,
    nodes: FourNodes<T::Base>,
}

impl<T: Number> FourKernel<T> {
    #[inline(always)]
    fn new(law: &Law<T>) -> Self {
        let spin = Spin::new(law.spin.value());
        // (without derivatives nobody reads them)
        let by_spin = SpinSlopes::new(&spin);
        Self {
            sigma: T::Quad::all(law.spin),
            spin: spin.map(Quad::all),
            by_spin: by_spin.map(Quad::all),
            nodes: Kernel::<Stored<T>>::get().read(|couple| both_sides::<T::Base>(couple)),
        }
    }

    #[inline(always)]
    fn forces(&self, law: &Law<T>, four: &FourStrips<Stored<T>>) -> Carried<T::Quad> {
        let [y, inverse, bend, _, _, _, _, width] = fields::<T::Base>(four);
        // A_x = (a_x − ρ Y (1 + ε (0.4 − Y²)))/C
        let profile = T::Quad::all(law.bend).weigh(bend) + T::Quad::fixed(y);
        let slope = T::Quad::all(law.slope);
        let seen = Seen {
            x: (T::Quad::all(law.longitudinal) - slope * profile).weigh(inverse),
            y: T::Quad::all(law.lateral).weigh(inverse),
            spread: slope.weigh(width),
            start: T::Quad::all(law.start),
        };
        let (nodes, closed) = &self.nodes;
        differentiated::<T>(&seen, self.sigma, &self.spin, nodes, closed, &self.by_spin)
    }
}

/// Strips at `Y` and `−Y`: the numbers of two, twice.
#[inline(always)]
fn both_sides<F: Plain>(couple: &[F::Stored; 2]) -> F::Quad {
    let [a, b] = F::both_stored(*couple);
    F::Quad::plain([a, b, a, b])
}

/// The fields of four strips: `y`, `bend` and `load_y` are odd in `y`.
#[inline(always)]
fn fields<F: Plain>(four: &FourStrips<F::Stored>) -> [F::Quad; STRIP_FIELDS] {
    let odd = |couple: &[F::Stored; 2]| {
        let [a, b] = F::both_stored(*couple);
        F::Quad::plain([a, b, -a, -b])
    };
    let [y, inverse, bend, load, load_c, load_y, area, width] = four;
    let even = both_sides::<F>;
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
