//! How the points of a gap move with the wheel.
//!
//! A point of the wheel's profile keeps its place on the profile. With the motion `dy`, `dz`, `dψ`
//! (yaw), `dρ` (roll) of the wheel, `w` its place and `m` its normal in the wheel's axes, and `R`
//! the turn,
//!
//! ```text
//! dp = dρ e_x × p + dψ R (e_z × w + θ' (r cos θ, 0, −r sin θ)),   θ' = −tan α/(cos θ cos² ψ)
//! dn = dρ e_x × n + dψ R (e_z × m + θ' (cos α cos θ, 0, −cos α sin θ))
//! dR = −2 R (1 − R/R₀) cot ψ dψ,   R₀ = r/cos α
//! ```
//!
//! and the point of the rail under it moves by `du = dp·r'/(r'·r' − e·r'')`. Where the gap ends
//! between two points of the wheel, because the rail ends or leans back or the distance is that at
//! which points are left out, this length or this distance stays, and the place on the profile
//! moves.

use crate::normal::profile::{Moves, TOGETHER};
use crate::number::{Float, at, length};
use crate::wheel_rail::profile::PreparedProfile;
use crate::wheel_rail::touch::foot::UNDERCUT;
use crate::wheel_rail::touch::line_of_contact::{RADIUS_FACTORS, Turn};
use crate::wheel_rail::{Position, sine_cosine};

/// Roundings by which the last point of a gap may be off.
const ROUNDINGS: f64 = 1e3;

pub(super) type Lists<'a, F> = [&'a [F]; 7];

/// The points of a gap, which move with the members of a position.
#[derive(Clone, Copy, Debug)]
pub(super) struct PointMoves<'a, F> {
    lists: Lists<'a, F>,
    rail: &'a PreparedProfile<F>,
    turn: Turn<F>,
    /// -1 for a left wheel, whose mirror image moves the other way, else 1.
    side: F,
    /// Distance at which the gap ends \[m\].
    reach: F,
    /// The first of the directions of derivatives.
    pub first: usize,
}

/// The rail under a point.
struct Under<F> {
    cosine: F,
    sine: F,
    /// Mean of its angle and the wheel's.
    angle: F,
    /// Change of its length for a motion along it.
    along: F,
    /// Change of its angle for a change of its length.
    curvature: F,
}

impl<'a, F: Float> PointMoves<'a, F> {
    /// `position` is that of a right wheel, or of the mirror image of a left one.
    pub fn new(
        lists: Lists<'a, F>, rail: &'a PreparedProfile<F>, position: &Position<F>, left: bool,
        reach: F,
    ) -> Self {
        let side = if left { -F::one() } else { F::one() };
        Self { lists, rail, turn: Turn::new(position), side, reach, first: 0 }
    }

    /// How the wheel, or the mirror image of a left one, moves in a direction.
    pub fn direction(&self, number: usize) -> [F; 4] {
        let of = |k: usize, size: F| if k == number { size } else { F::zero() };
        [of(0, self.side), of(1, F::one()), of(2, self.side), of(3, self.side)]
    }

    fn members(&self, k: usize) -> [F; 7] {
        self.lists.map(|list| at(list, k))
    }

    fn under(&self, [along, distance, _, _, _, angle, _]: [F; 7]) -> Under<F> {
        let [y, z] = self.rail.along(along);
        let square = y.slope.squared() + z.slope.squared();
        let size = square.sqrt();
        let per_size = F::one() / size;
        let (cosine, sine) = (y.slope * per_size, z.slope * per_size);
        // e = −g n
        let bend = z.bend * cosine - y.bend * sine;
        let along = self.rail.step * size / (square + distance * bend);
        let curvature = bend * per_size / self.rail.step;
        Under { cosine, sine, angle, along, curvature }
    }

    /// By yaw: derivatives of x, y, z, of the wheel's angle, and of the rolling radius.
    fn by_yaw(&self, [_, _, x, y, z, _, rolling_radius]: [F; 7], under: &Under<F>) -> [F; 5] {
        let [normal_y, normal_z] = under.normal_of_wheel();
        let [n_x, n_y, n_z] = self.turn.to_wheelset([F::zero(), normal_y, normal_z]);
        let [ahead, across, below] = self.turn.to_wheelset([x, y, z]);
        let (radius, cosine) = (length(ahead, below), length(n_x, n_z));
        let (sin_yaw, cos_yaw) = self.turn.yaw;
        // θ'
        let rate = (n_y * radius) / (cosine * below * cos_yaw * cos_yaw);
        let of = |[a, b, c]: [F; 3]| {
            self.turn.vector_to_track([rate * c - b, a, -(rate * a)]).map(|own| own * self.side)
        };
        let [dx, dy, dz] = of([ahead, across, below]);
        // n = (0, −sin γ, cos γ)
        let [_, by_y, by_z] = of([n_x, n_y, n_z]);
        let turned = by_z * normal_y - by_y * normal_z;
        let share = rolling_radius * cosine / radius;
        let [least, largest] = RADIUS_FACTORS.map(F::of);
        let is_free = sin_yaw != F::zero() && share > least && share < largest;
        let curved = if is_free {
            -(rolling_radius * (F::one() - share)).times(2.0) * cos_yaw / sin_yaw * self.side
        } else {
            F::zero()
        };
        [dx, dy, dz, turned, curved]
    }

    /// In a direction: derivatives of x, y, z, of the wheel's angle, and of the rolling radius;
    /// and those of length and distance.
    #[inline]
    fn in_one(&self, members: [F; 7], under: &Under<F>, direction: usize) -> ([F; 5], [F; 2]) {
        let [_, _, _, y, z, ..] = members;
        let (zero, side) = (F::zero(), self.side);
        let of_wheel = match direction {
            0 | 1 => [zero; 5],
            2 => self.by_yaw(members, under),
            _ => [zero, -(z * side), y * side, side, zero],
        };
        let ([_, dy, dz, ..], [lateral, vertical, ..]) = (of_wheel, self.direction(direction));
        (of_wheel, under.moves([dy + lateral, dz + vertical]))
    }

    /// Derivatives of the members of a point in a direction.
    #[inline]
    pub fn in_direction(&self, k: usize, direction: usize) -> [F; 7] {
        let members = self.members(k);
        let under = self.under(members);
        let ([dx, dy, dz, turned, curved], [moved, lifted]) =
            self.in_one(members, &under, direction);
        let turned = (turned + under.curvature * moved).times(0.5);
        [moved, lifted, dx, dy, dz, turned, curved]
    }
}

impl<F: Float> Under<F> {
    /// The normals of both surfaces have the angle of the point in their middle.
    fn normal_of_wheel(&self) -> [F; 2] {
        let Self { cosine, sine, angle, .. } = *self;
        let (mean_sine, mean_cosine) = sine_cosine(angle);
        let twice = (mean_cosine * cosine + mean_sine * sine).times(2.0);
        [sine - twice * mean_sine, twice * mean_cosine - cosine]
    }

    /// Derivatives of length and distance by the motion of the point above.
    fn moves(&self, [dy, dz]: [F; 2]) -> [F; 2] {
        let Self { cosine, sine, along, .. } = *self;
        [(dy * cosine + dz * sine) * along, dy * sine - dz * cosine]
    }

    /// The same where another point of the wheel comes to this length, or else to this distance.
    fn held(&self, [moved, lifted]: [F; 2], length: bool) -> [F; 2] {
        let [normal_y, normal_z] = self.normal_of_wheel();
        let [along, rises] = self.moves([normal_z, -normal_y]);
        if length {
            [F::zero(), lifted - rises * moved / along]
        } else {
            [moved - along * lifted / rises, F::zero()]
        }
    }
}

impl<F: Float> Moves<F> for PointMoves<'_, F> {
    fn moves_of_point(&self, k: usize) -> [[F; TOGETHER]; 4] {
        let members = self.members(k);
        let [along, distance, ..] = members;
        let under = self.under(members);
        let close = F::EPSILON.times(ROUNDINGS);
        let leans_back = (under.cosine - F::of(UNDERCUT)).abs() <= close;
        let ends = leans_back || self.rail.ends_at(along, close);
        let leaves = distance >= self.reach * (F::one() - close);
        let by: [_; TOGETHER] = core::array::from_fn(|k| {
            let ([x, .., radius], moved) = self.in_one(members, &under, self.first + k);
            let [along, distance] = if ends || leaves { under.held(moved, ends) } else { moved };
            [along, distance, x, radius]
        });
        core::array::from_fn(|member| by.map(|own| at(&own, member)))
    }
}
