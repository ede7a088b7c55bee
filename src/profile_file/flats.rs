//! The flat parts of a profile, and how it goes on beside them.

use crate::number::Float;
use crate::wheel_rail::profile::PreparedProfile;

/// Sine of the angle below which a part is flat.
const FLAT_PART: f64 = 0.342;
/// Most points that are used, and most flat parts.
const MOST_USED: usize = 500;
const MOST_FLATS: usize = 64;
/// The size of a profile over the length with which it is smoothed.
const SMOOTHING: f64 = 1.0 / 40.0;

/// How a profile goes on beside a flat part.
#[derive(Clone, Copy, Default)]
pub(super) struct Flank<F> {
    /// 1: z grows, -1: z becomes smaller, 0: the profile ends.
    pub(super) sign: F,
    /// Height between the end of the flat part and the farthest point before the profile returns.
    pub(super) depth: F,
    pub(super) has_tip: bool,
    /// Another flat part follows near the height of this one.
    pub(super) returns: bool,
}

/// A flat part: its first and last point, its length, and how the profile goes on beside it.
#[derive(Clone, Copy, Default)]
pub(super) struct Flat<F> {
    pub(super) first: usize,
    pub(super) last: usize,
    pub(super) length: F,
    pub(super) sides: [Flank<F>; 2],
}

impl<F: Float> Flat<F> {
    /// Both sides are the same, without a flange.
    pub(super) fn is_of_roller(&self) -> bool {
        let [left, right] = self.sides;
        (left.sign - right.sign).abs() <= F::zero() && !left.has_tip && !right.has_tip
    }
}

pub(super) type Flats<F> = heapless::Vec<Flat<F>, MOST_FLATS>;

/// The middle one of five.
fn middle<F: Float>([a, b, c, d, e]: [F; 5]) -> F {
    let sorted = |a: F, b: F| (a.min(b), a.max(b));
    let ((a, b), (c, d)) = (sorted(a, b), sorted(c, d));
    // Neither the least nor the largest of four is the middle of five
    let (low, high) = (a.max(c), b.min(d));
    let (low, high) = sorted(low, high);
    e.max(low).min(high)
}

/// The largest number minus the least.
pub(super) fn width_of<F: Float>(list: &[F]) -> F {
    let least = list.iter().fold(F::LARGEST, |least, x| least.min(*x));
    list.iter().fold(-F::LARGEST, |most, x| most.max(*x)) - least
}

/// A prepared profile, z down or up.
pub(super) struct Examined<F>(PreparedProfile<F>);

impl<F: Float> Examined<F> {
    /// The points \[m\] of a profile, in their order; none if no line follows them.
    pub(super) fn new(y: &[F], z: &[F]) -> Option<Self> {
        let every = 1 + y.len() / MOST_USED;
        let mut thinned = [[F::zero(); MOST_USED]; 2];
        let count = y.len().div_ceil(every).min(MOST_USED);
        for (list, thin) in [y, z].into_iter().zip(&mut thinned) {
            let at = |k: usize| list.get(k * every).copied().unwrap_or(F::zero());
            for (k, place) in thin.iter_mut().enumerate().take(count) {
                let is_inner = k >= 2 && k + 2 < count && count >= 20;
                let five = || [at(k - 2), at(k - 1), at(k), at(k + 1), at(k + 2)];
                *place = if is_inner { middle(five()) } else { at(k) };
            }
        }
        let [y, z] = [thinned[0].get(..count)?, thinned[1].get(..count)?];
        let size = (width_of(y).squared() + width_of(z).squared()).sqrt();
        let mut line = Self(PreparedProfile::new());
        line.0.prepare(y, z, F::zero(), size.times(SMOOTHING)).ok()?;
        Some(line)
    }

    pub(super) fn number_of_points(&self) -> usize {
        self.0.count as usize
    }

    pub(super) fn y(&self, k: usize) -> F {
        self.0.y.get(k).copied().unwrap_or(F::zero())
    }

    pub(super) fn z(&self, k: usize) -> F {
        self.0.z.get(k).copied().unwrap_or(F::zero())
    }

    pub(super) fn width(&self) -> F {
        self.0.y.get(..self.number_of_points()).map_or(F::zero(), width_of)
    }

    /// Parts that are flat; narrow dents divide none.
    pub(super) fn flats(&self) -> Flats<F> {
        let length = |first: usize, last: usize| self.0.step * F::widened((last - first) as f32);
        let longest_of = |flats: &Flats<F>| {
            flats.iter().fold(F::zero(), |most, flat| most.max(length(flat.first, flat.last)))
        };
        // More of them are a rough line, of which the first tell enough.
        let (mut runs, mut flats) = (Flats::<F>::new(), Flats::<F>::new());
        for k in (0..self.number_of_points()).filter(|k| self.is_flat(*k)) {
            match runs.last_mut().filter(|run| run.last + 1 == k) {
                Some(run) => run.last = k,
                None => drop(runs.push(Flat { first: k, last: k, ..Flat::default() })),
            }
        }
        let longest = longest_of(&runs);
        for run in runs.iter().copied() {
            let joins = |before: &&mut Flat<F>| {
                length(before.last, run.first) < longest.times(0.06)
                    && (self.z(run.first) - self.z(before.last)).abs() < longest.times(0.03)
            };
            match flats.last_mut().filter(joins) {
                Some(before) => before.last = run.last,
                None => drop(flats.push(run)),
            }
        }
        let longest = longest_of(&flats);
        flats.iter_mut().for_each(|flat| flat.length = length(flat.first, flat.last));
        flats.retain(|flat| flat.length >= longest.times(0.03));
        self.add_sides(&mut flats, longest);
        flats
    }

    fn is_flat(&self, k: usize) -> bool {
        let point = self.0.point(k);
        point.is_some_and(|at| at.sine.abs() < F::of(FLAT_PART) && at.cosine > F::zero())
    }

    fn add_sides(&self, flats: &mut Flats<F>, longest: F) {
        let least = longest.times(0.05);
        let all = flats.clone();
        let height = |flat: &Flat<F>| self.z((flat.first + flat.last) / 2);
        for (number, flat) in flats.iter_mut().enumerate() {
            let left = self.side((0..=flat.first).rev(), least);
            let right = self.side(flat.last..self.number_of_points(), least);
            let is_near = |other: &Flat<F>| {
                (height(other) - height(flat)).abs() < longest.times(0.3)
                    && other.length >= longest.times(0.1)
            };
            let has_left = all.iter().take(number).any(is_near);
            let has_right = all.iter().skip(number + 1).any(is_near);
            flat.sides = [(left, has_left), (right, has_right)]
                .map(|(side, has_other)| Flank { returns: side.has_tip && has_other, ..side });
        }
    }

    /// The way from the end of a flat part, over heights of at least `least`.
    fn side(&self, points: impl Iterator<Item = usize>, least: F) -> Flank<F> {
        let (mut begin, mut side) = (None, Flank::<F>::default());
        for k in points {
            let rise = self.z(k) - *begin.get_or_insert(self.z(k));
            if side.sign.abs() <= F::zero() && rise.abs() > least {
                side.sign = if rise > F::zero() { F::one() } else { -F::one() };
            }
            let depth = side.sign * rise;
            side.depth = side.depth.max(depth);
            if side.depth - depth > least {
                side.has_tip = true;
                break;
            }
        }
        side
    }
}
