//! Derivatives of a wheel's forces with respect to its position, from contacts after small steps.
//!
//! The line of contact, the undeformed gap, zones, cells, pressures and strips follow their exact
//! derivatives; what follows from these is computed anew after each step.

use super::groups::{BAND, Group, Groups, Overlaps};
use super::moves::PointMoves;
use super::view::View;
use super::{WheelContact, group_zones};
use crate::normal::cell::{Cell, Cells};
use crate::normal::moving::Directed;
use crate::normal::profile::{DIRECTIONS, TOGETHER};
use crate::normal::smooth::SmoothedProfile;
use crate::normal::{Indentation, Profile};
use crate::number::{Float, Number, add, at, length};
use crate::patch::Patch;
use crate::status::Error;
use crate::wheel_rail::forces::wrench::{Wrench, WrenchByPosition, sum_of_contacts};
use crate::wheel_rail::scene::{Scene, Workspace, is_single};
use crate::wheel_rail::{BodyState, KSTRIP_CONTACTS_CAPACITY};
use core::slice::from_ref;

/// Share by which overlap and shape change over a step, over the root of their rounding.
const SMALL: f64 = 5.0;
/// Change of a creepage over a step, over the root of its product with the rounding of speeds.
const SMALL_SLIP: f64 = 2.8;

/// Largest change of a cell over a step, over its width or length: cells of a zone that has just
/// begun change without a bound, and carry nothing.
const LARGEST_CHANGE: f64 = 0.1;
/// Least share of a step to both sides.
const SHORTEST: f64 = 1.0 / 32.0;
/// Least pressure for steps to both sides, divided by its change over one of them.
const MORE: f64 = 1.0625;
/// Least overlap that decides a step \[m\]: the points of a gap may touch less than its curve.
const SHALLOWEST: f64 = 1e-9;

/// Weight of the change of depths in the step of a share's difference.
const DEEPER: f64 = 0.01;

/// Creepage beyond the linear theory, and speed of a wheel that is nearly at rest \[m/s\].
const CREEPAGE: f64 = 1e-3;
const SLOW: f64 = 0.02;

impl<F: Float> Scene<'_, F> {
    /// Adds the derivatives of a wrench by the position: exact ones of the undeformed gap and of
    /// the strips; those of frames, creepages and creep forces by one-sided differences, in
    /// single precision by central ones. The memory of the last contact that there may be is used.
    #[inline(never)]
    pub(crate) fn add_slopes_by_position(
        &self, state: &BodyState<F>, memory: &mut Workspace<F>, found: &Wrench<F>,
        slopes: &mut WrenchByPosition<F>,
    ) -> Result<(), Error> {
        let Self { rail, pair, .. } = *self;
        let Workspace { gap, strips, contacts, count: used, .. } = memory;
        let spare = (*used as usize).min(KSTRIP_CONTACTS_CAPACITY - 1);
        let contact = contacts.get_mut(spare).ok_or(Error::PatchSize)?;
        let slip = found.dissipation / (found.normal_force + F::TINY);
        let speed = state.velocity.forward.abs().plus(SLOW);
        let creepage = (slip / speed).times(3.0).plus(CREEPAGE);
        let (sides, here) =
            if is_single::<F>() { (2, [F::zero(); 6]) } else { (1, found.members()) };
        let view = View::new(gap, pair, &state.position)?;
        let moves = view.moves(rail);
        let Some(profile) = view.profile()? else { return Ok(()) };
        let mut columns = slopes.columns();
        let mut curve = SmoothedProfile::of_surfaces(&profile, pair.smoothing_length);
        let mut groups = Groups::new();
        group_zones(&curve, &mut groups);
        let deepest = groups.iter().fold(F::zero(), |most, group| most.max(group.whole.depth));
        let length = |direction| view.length_of_step(&moves, direction, deepest, creepage);
        let lengths: [F; DIRECTIONS] = core::array::from_fn(length);
        let mut room = Room { cells: Cells::nothing(), strips, contact };
        for first in (0..DIRECTIONS).step_by(TOGETHER) {
            let (mut moves, mut profile) = (moves, profile);
            moves.first = first;
            profile.motion = Some(&moves);
            curve.follow(&profile, &moves, pair.smoothing_length);
            let lengths = core::array::from_fn(|k| at(&lengths, first + k));
            let columns = columns.get_mut(first..first + TOGETHER).unwrap_or(&mut []);
            let steps = Steps { scene: self, view: &view, state, moves, lengths, sides };
            steps.add_wrenches(&profile, &mut curve, &groups, &mut room, columns)?;
        }
        for (column, length) in columns.into_iter().zip(lengths) {
            let step = length * F::widened(sides as f32);
            for (slope, here) in column.iter_mut().zip(here) {
                *slope = (*slope - here) / step;
            }
        }
        Ok(())
    }
}

/// Memory for one contact: its cells with their derivatives, and its strips after a step.
struct Room<'a, F> {
    cells: Cells<F, TOGETHER>,
    strips: &'a mut Patch<F>,
    contact: &'a mut WheelContact<F>,
}

/// Steps of a wheel in [`TOGETHER`] directions, of which the first is that of `moves`.
struct Steps<'a, F> {
    scene: &'a Scene<'a, F>,
    view: &'a View<'a, F>,
    state: &'a BodyState<F>,
    moves: PointMoves<'a, F>,
    /// \[m, rad\]
    lengths: [F; TOGETHER],
    /// 1: forward; 2: also backward.
    sides: usize,
}

struct ContactStep<F> {
    /// Number of the direction, from that of `moves` on.
    k: usize,
    /// \[m, rad\]
    length: F,
    /// Share of the contact after the step.
    share: F,
}

impl<F: Float> Steps<'_, F> {
    /// Adds the wrenches of all contacts after the steps, of which those backward count negative.
    fn add_wrenches(
        &self, profile: &Profile<F>, curve: &mut SmoothedProfile<F, TOGETHER>, groups: &[Group<F>],
        room: &mut Room<F>, columns: &mut [&mut [F; 6]],
    ) -> Result<(), Error> {
        let mut rates = [[F::zero(); KSTRIP_CONTACTS_CAPACITY]; TOGETHER];
        for (k, rates) in rates.iter_mut().enumerate() {
            rates_of_shares(curve, groups, k, rates);
        }
        for (number, group) in groups.iter().enumerate() {
            curve.restrict(&group.whole);
            let (depth, count) = (curve.depth(&group.whole), self.scene.strips);
            let pressed = &mut self.view.press(profile, curve, depth, count, &mut room.cells)?;
            let mut shares = [F::one(); TOGETHER];
            if self.sides == 2 {
                shorten(&room.cells, &self.lengths, &mut shares);
            }
            bound_changes(&mut room.cells, &self.lengths, &shares);
            keep_pressures(&mut room.cells, &self.lengths, &shares, self.sides);
            for (k, (column, rates)) in columns.iter_mut().zip(&rates).enumerate() {
                let (length, part) = (at(&self.lengths, k), at(&shares, k));
                for side in [F::one(), -F::one()].into_iter().take(self.sides) {
                    let length = side * length * part;
                    let share = (group.share + length * at(rates, number)).max(F::zero());
                    let moved =
                        self.wrench_after(&ContactStep { k, length, share }, pressed, room)?;
                    // The weight is ± h/h', where the column's own step h' is shorter than h.
                    let weight = F::one() / (side * part);
                    add(&mut column[..], moved.map(|own| own * weight));
                }
            }
        }
        Ok(())
    }

    /// The wrench of a contact after one of these steps.
    fn wrench_after(
        &self, step: &ContactStep<F>, pressed: &mut Indentation<F>, room: &mut Room<F>,
    ) -> Result<[F; 6], Error> {
        let Self { scene, view, state, moves, .. } = *self;
        let Room { cells, strips, contact } = room;
        let ContactStep { k, length, share } = *step;
        let of = |own: Directed<F>| own.value + length * own.derivative(k);
        view.strips(cells, of, pressed, strips)?;
        if strips.count == 0 {
            return Ok([F::zero(); 6]);
        }
        let moved = view.moved(moves, moves.first + k, length);
        let indented = [pressed.approach, pressed.stiffness];
        contact.fill(moved.pair, &moved.position, strips, indented, |_, along| moved.place(along));
        contact.share = share;
        let contacts = from_ref(&**contact);
        sum_of_contacts::<_, false>(strips, contacts, &state.velocity, scene.law, None)
            .map(|found| found.members())
    }
}

/// Change of a cell over a step in direction `k`: `h ρ` with `ρ = max(|y'|/w, |w'|/w, |a'|/a)`.
fn change<F: Float>(cell: &Cell<F, TOGETHER>, k: usize, step: F) -> F {
    let Cell { y, width, half_length, .. } = cell;
    let rate = |own: &Directed<F>| own.derivative(k).abs();
    let of_width = rate(y).max(rate(width)) / width.value;
    step * of_width.max(rate(half_length) / half_length.value)
}

/// Shares of steps over which all cells change by little, at least [`SHORTEST`].
fn shorten<F: Float>(
    cells: &Cells<F, TOGETHER>, steps: &[F; TOGETHER], shares: &mut [F; TOGETHER],
) {
    for cell in cells.list.iter() {
        for (k, (step, share)) in steps.iter().zip(shares.iter_mut()).enumerate() {
            let most = F::of(LARGEST_CHANGE) / (change(cell, k, *step) + F::TINY);
            *share = share.min(most).max(F::of(SHORTEST));
        }
    }
}

/// Lessens the derivatives of cells that would change by much over shares of steps, so that strips
/// keep their order: `c d/dq` with `c = min(1, 0.1/(h ρ))`.
fn bound_changes<F: Float>(
    cells: &mut Cells<F, TOGETHER>, steps: &[F; TOGETHER], shares: &[F; TOGETHER],
) {
    for cell in cells.list.iter_mut() {
        for (k, (step, share)) in steps.iter().zip(shares).enumerate() {
            let change = change(cell, k, *step * *share);
            if change > F::of(LARGEST_CHANGE) {
                let part = F::of(LARGEST_CHANGE) / change;
                let Cell { y, width, half_length, centre_x, pressure, .. } = cell;
                for own in [y, width, half_length, centre_x, pressure] {
                    own.set_derivative(k, own.derivative(k) * part);
                }
            }
        }
    }
}

/// Keeps pressures above zero over shares of steps `h`, so that no strip vanishes. For a step to
/// one side a pressure that would vanish does not change. For steps to both sides it is raised to
/// at least 1.06 times its largest change, so that the difference of both sides keeps the whole
/// derivative: `p₊ − p₋ = 2 h p'`.
fn keep_pressures<F: Float>(
    cells: &mut Cells<F, TOGETHER>, steps: &[F; TOGETHER], shares: &[F; TOGETHER], sides: usize,
) {
    for Cell { pressure, .. } in
        cells.list.iter_mut().filter(|cell| cell.pressure.value > F::zero())
    {
        for (k, (step, share)) in steps.iter().zip(shares).enumerate() {
            let change = *step * *share * pressure.derivative(k);
            if sides == 2 {
                pressure.value = pressure.value.max(change.abs().times(MORE));
            } else if pressure.value + change <= F::zero() {
                pressure.set_derivative(k, F::zero());
            }
        }
    }
}

/// Derivatives of the shares of groups in a direction, by one-sided differences of second order:
/// their step changes free lengths and depths by little. (Out of line: the groups of a difference
/// need not be kept.)
#[inline(never)]
fn rates_of_shares<F: Float>(
    curve: &SmoothedProfile<F, TOGETHER>, groups: &[Group<F>], direction: usize,
    rates: &mut [F; KSTRIP_CONTACTS_CAPACITY],
) {
    if groups.iter().all(|group| group.share == F::one()) {
        return;
    }
    let deepest = groups.iter().fold(F::TINY, |most, group| most.max(group.whole.depth));
    let mut fastest = F::TINY;
    let rate = |own: Directed<F>| own.derivative(direction);
    curve.overlaps(rate, |zone| {
        let [begin, end] = zone.ends.map(|end| end.abs().times(1.0 / BAND));
        fastest = fastest.max(begin).max(end).max(zone.depth.times(DEEPER) / deepest);
    });
    let step = F::EPSILON.cube_root() / fastest;
    // f' = (4 f(h) − f(2 h) − 3 f(0))/(2 h)
    for (distance, weight) in [(step, F::of(2.0)), (step.times(2.0), F::of(-0.5))] {
        let mut moved = Groups::new();
        Overlaps::of_curve(curve, |own| own.value + distance * rate(own)).group(&mut moved);
        for (rate, group) in rates.iter_mut().zip(groups) {
            let moved = moved.iter().find(|moved| moved.zones == group.zones);
            let share = moved.map_or(F::zero(), |moved| moved.share);
            *rate += (share - group.share) * weight / step;
        }
    }
}

impl<'a, F: Float> View<'a, F> {
    /// The same after a step in a direction.
    fn moved(&self, moves: PointMoves<'a, F>, direction: usize, step: F) -> Self {
        let mut position = self.position;
        for (own, by) in position.members_mut().into_iter().zip(moves.direction(direction)) {
            *own += step * by;
        }
        Self { position, moved: Some((moves, direction, step)), ..*self }
    }

    /// The length of a step in a direction, over which the overlap `δ`, the shape and the creepage
    /// `υ` change by a small share. With the rates `d'` of the distance, `u'` and `x'` of the place
    /// of the lowest point, and `α'` of the wheel's turn,
    ///
    /// ```text
    /// h = √ε/(D/5 + C/2.8),   D = |d'|/δ + √(u'² + x'²)/√(δ r),   C = α'/√υ
    /// ```
    fn length_of_step(
        &self, moves: &PointMoves<F>, direction: usize, deepest: F, creepage: F,
    ) -> F {
        let [_, distance, ..] = self.lists;
        let lower = |(lowest, least), (k, own): (usize, &F)| {
            if *own < least { (k, *own) } else { (lowest, least) }
        };
        let (lowest, least) = distance.iter().enumerate().fold((0, F::LARGEST), lower);
        let [along, lifted, x, _, z, ..] = moves.in_direction(lowest, direction);
        let depth = (-least).max(deepest).max(F::of(SHALLOWEST));
        let radius = self.pair.wheel_radius;
        let [_, vertical, yaw, roll] = moves.direction(direction);
        let turns = yaw.abs() + roll.abs() + (z.abs() + vertical.abs()) / radius;
        let creeps = turns / creepage.sqrt();
        let deforms = lifted.abs() / depth + length(along, x) / (depth * radius).sqrt();
        F::EPSILON.sqrt() / (deforms.times(1.0 / SMALL) + creeps.times(1.0 / SMALL_SLIP))
    }
}
