//! How a profile stands, from its shape: a wheel or a rail, z up or down, the flange or the gauge
//! side at small or at large y.
//!
//! The points are prepared first, as for a calculation: single strays are out, and scatter is
//! smoothed. The prepared profile has flat parts, where it rises by less than 20 degrees. The
//! longest is the tread or the head. On either side of a flat part the profile falls, rises or
//! ends:
//!
//! * A wheel: beside the tread the flange reaches down to its tip and rises again. A roller without
//!   a flange has both edges up.
//! * A rail: beside a head the profile falls on both sides. A groove is a flat part that rises on
//!   both sides, and counts against a head only by its own width.

use super::flats::{Examined, Flank, Flat, Flats};
use crate::number::Float;

/// Least depth of the sides of a rail's head \[m\]. A groove for a ball is less deep.
const LEAST_SIDE: f64 = 8e-3;
/// Depth of a flange below its tread, length of the top of a rail's head \[m\]; width of a rail and
/// least depth of its sides over that length.
const FLANGE_DEPTH: [f64; 2] = [0.018, 0.045];
const HEAD_LENGTH: [f64; 2] = [0.032, 0.080];
const WIDEST_RAIL: f64 = 1.7;
const LEAST_SIDE_SHARE: f64 = 0.2;
/// Strength of evidence that is clear.
const CLEAR: f64 = 1.0 - 1e-6;
/// Evidence: a value of at most a weight, positive for yes.
#[derive(Clone, Copy, Default)]
pub(super) struct Evidence<F> {
    pub(super) value: F,
    pub(super) weight: F,
}

impl<F: Float> Evidence<F> {
    const fn new(value: F, weight: F) -> Self {
        Self { value, weight }
    }

    fn add(&mut self, other: Self) {
        self.value += other.value;
        self.weight += other.weight;
    }

    pub(super) fn is_no(&self) -> bool {
        self.value < F::zero()
    }

    /// Whether its strength is at least so much, 0 to 1.
    pub(super) fn is_at_least(&self, strength: f64) -> bool {
        self.weight > F::zero() && self.value.abs() >= self.weight.times(strength)
    }
}

/// What the shapes of one profile or of several say.
#[derive(Clone, Copy, Default)]
pub(super) struct Shape<F> {
    pub(super) is_wheel: Evidence<F>,
    /// Of a wheel and of a rail: z points down.
    pub(super) wheel_down: Evidence<F>,
    pub(super) rail_down: Evidence<F>,
    /// The flange is at small y, of the wheel as it stands and upside down.
    pub(super) flange_left: [Evidence<F>; 2],
    /// The gauge side is at small y, of the rail as it stands and upside down.
    pub(super) gauge_left: [Evidence<F>; 2],
    /// Number of heads as it stands and upside down.
    pub(super) heads: [usize; 2],
    /// A head upside down has sides as deep as those of a rail.
    pub(super) has_deep_head_turned: bool,
    /// Beside the longest flat part the profile is not the same on both sides, or it has a tip.
    pub(super) has_flange: bool,
    /// Length of the longest flat part, and the depth of its sides.
    pub(super) longest: F,
    depth: F,
    /// No line follows the points.
    pub(super) is_scattered: bool,
}

impl<F: Float> Shape<F> {
    /// Adds what the shape of another profile says.
    pub(super) fn add(&mut self, other: &Self) {
        self.is_wheel.add(other.is_wheel);
        self.wheel_down.add(other.wheel_down);
        self.rail_down.add(other.rail_down);
        let all = self.flange_left.iter_mut().chain(&mut self.gauge_left);
        for (sum, side) in all.zip(other.flange_left.iter().chain(&other.gauge_left)) {
            sum.add(*side);
        }
        for (most, heads) in self.heads.iter_mut().zip(other.heads) {
            *most = heads.max(*most);
        }
        self.has_deep_head_turned |= other.has_deep_head_turned;
        self.has_flange |= other.has_flange;
        self.is_scattered |= other.is_scattered;
        if other.longest > self.longest {
            (self.longest, self.depth) = (other.longest, other.depth);
        }
    }

    pub(super) fn is_clear_wheel(&self) -> bool {
        !self.is_wheel.is_no() && self.is_wheel.is_at_least(CLEAR)
    }

    /// Whether a profile has the size of a wheel or of a rail's head if its points, `width` wide,
    /// are inches, so much larger than it stands.
    pub(super) fn is_in_inches(&self, width: F, factor: F) -> bool {
        let is_within = |x: F, [least, most]: [f64; 2]| x > F::of(least) && x < F::of(most);
        if self.is_clear_wheel() {
            return is_within(self.depth * factor, FLANGE_DEPTH);
        }
        let is_head = self.heads != [0, 0] && width < self.longest.times(WIDEST_RAIL);
        is_head
            && is_within(self.longest * factor, HEAD_LENGTH)
            && self.depth > self.longest.times(LEAST_SIDE_SHARE)
    }
}

impl<F: Float> Shape<F> {
    /// The evidence of the points \[m\] of a profile, in their order, either way along y.
    pub(super) fn of_points(y: &[F], z: &[F]) -> Self {
        let examined = Examined::new(y, z).map(|line| line.shape());
        examined.unwrap_or(Self { is_scattered: true, ..Self::default() })
    }
}

impl<F: Float> Examined<F> {
    fn shape(&self) -> Shape<F> {
        let flats = self.flats();
        let main = flats.iter().copied().reduce(|a, b| if b.length > a.length { b } else { a });
        let Some(main) = main else { return Shape::default() };
        let [stands, turned] = [1.0, -1.0].map(|sign| self.gauge_left(&flats, F::of(sign)));
        let mut sides_turned = heads(&flats, -F::one()).flat_map(|head| head.sides);
        Shape {
            is_wheel: self.is_wheel(&main, &flats),
            wheel_down: self.wheel_down(&main),
            rail_down: self.rail_down(&flats),
            flange_left: [1.0, -1.0].map(|sign| flange_left(&main, F::of(sign))),
            gauge_left: [stands.0, turned.0],
            heads: [stands.1, turned.1],
            has_deep_head_turned: sides_turned.any(|side| side.depth >= F::of(LEAST_SIDE)),
            has_flange: !main.is_of_roller(),
            longest: main.length,
            depth: main.sides[0].depth.max(main.sides[1].depth),
            is_scattered: false,
        }
    }

    fn wheel_down(&self, tread: &Flat<F>) -> Evidence<F> {
        let [left, right] = tread.sides;
        if tread.is_of_roller() {
            // No flange: the edges of a roller are up, and between them it is crowned.
            if left.sign.abs() > F::zero() {
                let depth = left.depth.min(right.depth);
                return Evidence::new(-left.sign * depth, depth);
            }
            return self.crown(-F::one());
        }
        let [left, right] = tread.sides.map(|side| side.sign * flange_reach(&side, tread.length));
        Evidence::new(left + right, left.abs() + right.abs())
    }

    /// Whether the middle of a profile is higher than its ends (sign 1) or lower (sign -1); weak
    /// where it is nearly straight.
    fn crown(&self, sign: F) -> Evidence<F> {
        let last = self.number_of_points().saturating_sub(1);
        let sagitta = (self.z(0) + self.z(last)).times(0.5) - self.z(self.number_of_points() / 2);
        Evidence::new(sign * sagitta, sagitta.abs().max(self.width().times(1e-3)))
    }

    fn rail_down(&self, flats: &Flats<F>) -> Evidence<F> {
        let mut found = Evidence::default();
        for flat in flats {
            let [left, right] = flat.sides.map(|side| side.sign);
            found.value += (flat.length * (left + right)).times(0.5);
            found.weight += (flat.length * (left.abs() + right.abs())).times(0.5);
        }
        if found.weight > F::zero() { found } else { self.crown(F::one()) }
    }

    /// Whether the gauge side of a rail is at small y, from its head alone, and the number of
    /// heads; z points down with the sign.
    fn gauge_left(&self, flats: &Flats<F>, sign: F) -> (Evidence<F>, usize) {
        let count = heads(flats, sign).count();
        let head = heads(flats, sign).reduce(|a, b| if b.length > a.length { b } else { a });
        head.map_or((Evidence::default(), 0), |head| (self.lean(head, sign), count))
    }

    /// Rails lean toward the gauge side, and they wear there: their top lies away from it.
    fn lean(&self, head: &Flat<F>, sign: F) -> Evidence<F> {
        let z = |k: usize| sign * self.z(k);
        // Down each side, until it rises again, and at most 25 mm below the head
        let goes_on = |from: usize, to: usize, end: usize| {
            z(to) > z(from).plus(-1e-4) && z(from) < z(end).plus(0.025)
        };
        let (mut first, mut last) = (head.first, head.last);
        while first > 0 && goes_on(first, first - 1, head.first) {
            first -= 1;
        }
        while last + 1 < self.number_of_points() && goes_on(last, last + 1, head.last) {
            last += 1;
        }
        let top = (first..=last).reduce(|a, b| if z(b) < z(a) { b } else { a }).unwrap_or(first);
        let between = |a: usize, b: usize, level: F| {
            self.y(a) + (level - z(a)) * (self.y(b) - self.y(a)) / (z(b) - z(a))
        };
        let reach = |depth: F| {
            let level = z(top) + depth;
            let left = (first..top).rev().find(|k| z(*k) > level);
            let right = (top + 1..=last).find(|k| z(*k) > level);
            match (left, right) {
                (Some(left), Some(right)) => {
                    [between(left, left + 1, level), between(right - 1, right, level)]
                }
                _ => [self.y(first), self.y(last)],
            }
        };
        let lowest = z(first).min(z(last)) - z(top);
        let [left, right] = reach(lowest.times(0.1).min(F::of(1e-4)));
        let centre = (left + right).times(0.5);
        let [left, right] = reach(lowest.times(0.9).min(F::of(0.014)));
        Evidence::new((centre - left) - (right - centre), (right - left).times(0.2))
    }

    fn is_wheel(&self, main: &Flat<F>, flats: &Flats<F>) -> Evidence<F> {
        let of = |value: f64| Evidence::new(F::of(value), F::one());
        let [left, right] = main.sides;
        let has_flange = main.sides.map(|side| {
            side.has_tip
                && !side.returns
                && side.depth > main.length.times(0.1)
                && side.depth < main.length.times(0.9)
        });
        let is_other =
            |flat: &Flat<F>| flat.first != main.first && flat.length > main.length.times(0.25);
        let has_others = flats.iter().any(is_other);
        let same = (left.sign - right.sign).abs() <= F::zero();
        if has_flange.contains(&true) && !has_others {
            of(if !same || !has_flange.contains(&false) { 1.0 } else { 0.3 })
        } else if has_others || (same && left.sign.abs() > F::zero()) {
            of(-1.0)
        } else {
            // One side, or none: a rail's head is at most 80 mm wide.
            of(if self.width() > F::of(0.09) { 0.1 } else { -0.1 })
        }
    }
}

/// Heads of a rail: flat parts beside which the profile falls; z points down with the sign.
fn heads<F: Float>(flats: &Flats<F>, sign: F) -> impl Iterator<Item = &Flat<F>> {
    let longest = flats.iter().fold(F::zero(), |most, flat| most.max(flat.length));
    flats.iter().filter(move |flat| {
        let falls = flat.sides.iter().any(|side| side.sign * sign > F::zero());
        let rises = flat.sides.iter().any(|side| side.sign * sign < F::zero());
        falls && !rises && flat.length > longest.times(0.1)
    })
}

/// How far a side reaches as the flange of a tread: one with a tip counts in full.
fn flange_reach<F: Float>(side: &Flank<F>, length: F) -> F {
    let depth = side.depth.min(length.times(0.4));
    if side.has_tip && !side.returns { depth } else { depth.times(0.4) }
}

fn flange_left<F: Float>(tread: &Flat<F>, sign: F) -> Evidence<F> {
    let [left, right] = tread.sides.map(|side| {
        if side.sign * sign > F::zero() { flange_reach(&side, tread.length) } else { F::zero() }
    });
    Evidence::new(left - right, left + right)
}
