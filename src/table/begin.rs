//! A table is begun: places on the wheel, loads of the levels, and the lateral nodes of all slabs.
//!
//! * The loads grow with the third power of the level: the heights then have about equal distances.
//! * Lateral nodes are found for the slab without yaw and roll: the interval whose length times the
//!   error of the interpolation in its middle is largest is halved, as long as there are nodes.
//! * In a slab with yaw and roll a node lies where the contact has the angle that it has at this
//!   node without yaw and roll, so that what changes quickly with the lateral position lies at the
//!   same nodes in all slabs. The angle is the mean of all strips weighted with load.

use super::axis::Around;
use super::block::{
    BEGUN, ContactTable, Quantity, check_pair, write_bytes, write_header, write_number,
};
use super::fill::plain;
use super::spec::TableSpec;
use crate::contact::totals::StripCount;
use crate::number::{Float, at, pairs, sort};
use crate::status::Error;
use crate::wheel_rail::Position;
use crate::wheel_rail::scene::{Scene, Workspace};
use heapless::Vec;

/// Load of the first level over the largest.
const FIRST_LOAD: f64 = 1e-7;
/// Loads that find the lateral nodes, over the largest.
const PROBED: [f64; 2] = [0.055, 0.55];
/// Nearest lateral nodes \[m\].
const NEAREST_NODES: f64 = 6e-6;
/// Part of an interval's error that its halves are expected to have.
const LEFT: f64 = 0.25;
/// Load whose angle of contact is the same in all slabs, over the largest.
const ANGLE_LOAD: f64 = 0.09;
/// At so many angles of contact the lateral positions of a slab are found, between which they are
/// linear.
const ANGLE_KNOTS: usize = 16;
/// How far a lateral position is sought from where it would be by the roll alone \[m\], and how
/// often a range is halved.
const SOUGHT: f64 = 4e-3;
const ANGLE_HALVINGS: u32 = 15;
/// Least part of a step of the lateral position in a slab over that without yaw and roll.
const LEAST_STEP: f64 = 0.05;
const PROBE: usize = 8;

/// Numbers of the contacts at a lateral position that must be interpolated well, and by how much
/// they may be wrong to be as bad as another.
type Probe<F> = [F; PROBE];

/// A number between those of knots, at the ends with the shift of the last one.
fn at_knots<F: Float>(knots: &[[F; 2]], x: F) -> Option<F> {
    let ([first, of_first], [last, of_last]) = (*knots.first()?, *knots.last()?);
    if x <= first || x >= last {
        return Some(if x <= first { of_first + (x - first) } else { of_last + (x - last) });
    }
    let ([from, p], [to, q]) = pairs(knots).find(|(_, [to, _])| x <= *to)?;
    Some(*p + (*q - *p) * ((x - *from) / (*to - *from)))
}

impl<F: Float> TableSpec<F> {
    /// Begins a table in a block. The pair's side, friction and damping do not matter.
    ///
    /// # Errors
    /// Those of [`TableSpec::size`]; [`Error::Capacity`] for a block that is too small; those of
    /// the scene; [`Error::TableSpec`] where no lateral position has contacts.
    pub fn begin_table(
        &self, scene: &Scene<F>, memory: &mut Workspace<F>, block: &mut [u8],
    ) -> Result<(), Error> {
        let counts = self.counts(scene.wheel)?;
        check_pair(scene.pair)?;
        Error::TablePair.when(scene.pair.rail_radius > F::zero())?;
        scene.rail.check()?;
        let most = counts.most_bytes()?;
        let block = block.get_mut(..most).ok_or(Error::Capacity)?;
        let pair = plain(scene.pair);
        let scene = Scene { pair: &pair, strips: StripCount::Sixteen, table: None, ..*scene };
        let lateral = self.lateral_nodes(&scene, counts.lateral, memory)?;
        write_header(block, &counts, most);
        let [.., heights, records, _] = counts.sections();
        let heights = block.get_mut(heights..records).unwrap_or(&mut []);
        // no part is filled
        heights.iter_mut().for_each(|byte| *byte = u8::MAX);
        for (number, value) in [
            (Quantity::WheelRadius, pair.wheel_radius),
            (Quantity::ShearModulus, pair.shear_modulus),
            (Quantity::PoissonRatio, pair.poisson_ratio),
            (Quantity::SmoothingLength, pair.smoothing_length),
            (Quantity::Spacing, self.place_spacing()?),
            (Quantity::Yaw, self.yaw),
            (Quantity::Roll, self.roll),
            (Quantity::Load, self.load),
        ] {
            write_number(block, number, value.to_f64());
        }
        let [_, loads, of_places, ..] = counts.sections();
        let mut write = |from: usize, k: usize, value: F| {
            write_bytes(block, from + 8 * k, value.to_f64().to_le_bytes());
        };
        let last = F::widened((counts.levels - 1) as f32);
        for k in 0..counts.levels {
            let share = F::widened(k as f32) / last;
            let load = self.load * (share * share * share).max(F::of(FIRST_LOAD));
            write(loads, k, (load * load).cube_root());
        }
        let (spacing, step) = (self.place_spacing()?, scene.wheel.step);
        for k in 0..counts.places {
            let steps = spacing * F::widened(k as f32) / step;
            let whole =
                (steps.whole().max(0) as usize).min((scene.wheel.count as usize).saturating_sub(2));
            let share = steps - F::widened(whole as f32);
            let Some(own) = scene.wheel.curve_at(whole, share) else { continue };
            for (member, value) in [own.y, own.z, own.cosine, own.sine].into_iter().enumerate() {
                write(of_places, 4 * k + member, value);
            }
        }
        self.write_lateral_nodes(&scene, &lateral, memory, block)
    }

    /// Writes the lateral nodes of all slabs.
    fn write_lateral_nodes(
        &self, scene: &Scene<F>, lateral: &[F], memory: &mut Workspace<F>, block: &mut [u8],
    ) -> Result<(), Error> {
        let knots = self.knots(scene, lateral, memory);
        let counts = ContactTable::in_state(block, BEGUN)?.counts;
        let [from, ..] = counts.sections();
        for slab in 0..counts.slabs() {
            let [roll, yaw] = ContactTable::in_state(block, BEGUN)?.roll_and_yaw::<F>(slab);
            let position = Position { yaw, roll, ..Position::default() };
            let by_roll = roll * scene.pair.wheel_radius;
            // the lateral positions of the knots
            let mut found = Vec::<[F; 2], ANGLE_KNOTS>::new();
            for [x, angle] in &knots {
                let about = *x + by_roll;
                let range = [-SOUGHT, SOUGHT].map(|distance| about + F::of(distance));
                let own = self.lateral_of(scene, &position, *angle, range, memory);
                // where the contact has not this angle, the shift is that of the knot before
                let own = match found.last() {
                    None => own.unwrap_or(about),
                    Some([before, last]) => {
                        let step = *x - *before;
                        own.unwrap_or(*last + step).max(*last + step.times(LEAST_STEP))
                    }
                };
                let _ = found.push([*x, own]);
            }
            for (k, x) in lateral.iter().enumerate() {
                let own = at_knots(&found, *x).unwrap_or(*x + by_roll);
                let part = slab * counts.lateral + k;
                write_bytes(block, from + 8 * part, own.to_f64().to_le_bytes());
            }
        }
        Ok(())
    }

    /// Lateral positions without yaw and roll with their angles of contact, which are at equal
    /// distances.
    fn knots(
        &self, scene: &Scene<F>, lateral: &[F], memory: &mut Workspace<F>,
    ) -> Vec<[F; 2], ANGLE_KNOTS> {
        let mut angles = Vec::<[F; 2], 256>::new();
        for x in lateral {
            let position = Position { lateral: *x, ..Position::default() };
            if let Some(angle) = self.angle_of_contact(scene, &position, memory) {
                let _ = angles.push([*x, angle]);
            }
        }
        let mut knots = Vec::new();
        let (Some([_, first]), Some([_, last])) = (angles.first(), angles.last()) else {
            return knots;
        };
        for k in 0..ANGLE_KNOTS {
            // not the steepest: a slab may not have them
            let share = F::widened((k as f32 + 0.5) / (ANGLE_KNOTS + 1) as f32);
            let angle = *first + (*last - *first) * share;
            let around = pairs(&angles).find(|([_, p], [_, q])| *p <= angle && angle < *q);
            let Some(([from, _], [to, _])) = around else { continue };
            let found = self.lateral_of(scene, &Position::default(), angle, [*from, *to], memory);
            if let Some(x) = found {
                let _ = knots.push([x, angle]);
            }
        }
        knots
    }

    /// The lateral position in a range at which the contact has an angle; none if it does not.
    fn lateral_of(
        &self, scene: &Scene<F>, position: &Position<F>, angle: F, [mut from, mut to]: [F; 2],
        memory: &mut Workspace<F>,
    ) -> Option<F> {
        let mut is_before = |lateral: F| {
            let position = Position { lateral, ..*position };
            Some(self.angle_of_contact(scene, &position, memory)? <= angle)
        };
        if is_before(from) == Some(false) || is_before(to) == Some(true) {
            return None;
        }
        for _ in 0..ANGLE_HALVINGS {
            let middle = (from + to).times(0.5);
            if is_before(middle)? {
                from = middle;
            } else {
                to = middle;
            }
        }
        Some((from + to).times(0.5))
    }

    /// The angle of contact of a position, positive toward the flange \[rad\].
    fn angle_of_contact(
        &self, scene: &Scene<F>, position: &Position<F>, memory: &mut Workspace<F>,
    ) -> Option<F> {
        scene.height_for_load(position, self.load.times(ANGLE_LOAD), None, memory).ok()?;
        let (mut sum, mut all) = (F::zero(), F::zero());
        for contact in memory.found() {
            for (k, strip) in contact.patch.used().iter().enumerate() {
                let own = strip.load() * contact.share;
                sum += own * -at(&contact.strip_angle, k);
                all += own;
            }
        }
        (all > F::zero()).then(|| sum / all)
    }

    /// Numbers that must be interpolated well at a lateral position, in units of their errors.
    fn probe(&self, scene: &Scene<F>, lateral: F, memory: &mut Workspace<F>) -> Option<Probe<F>> {
        let mut position = Position { lateral, ..Position::default() };
        let mut probe = [F::zero(); PROBE];
        let touch = self.load.times(FIRST_LOAD);
        let (touches, _) = scene.height_for_load(&position, touch, None, memory).ok()?;
        for (numbers, share) in probe.as_chunks_mut::<4>().0.iter_mut().zip(PROBED) {
            let load = self.load.times(share);
            let (height, _) = scene.height_for_load(&position, load, None, memory).ok()?;
            position.vertical = height;
            let mut sums = [F::zero(); 5];
            for contact in memory.found() {
                for (k, strip) in contact.patch.used().iter().enumerate() {
                    let (own, y) = (strip.load() * contact.share, at(&contact.strip_y, k));
                    let area = strip.half_length * strip.width;
                    let terms = [F::one(), y, y * y, at(&contact.strip_angle, k), area];
                    for (sum, term) in sums.iter_mut().zip(terms) {
                        *sum += own * term;
                    }
                }
            }
            let [all, y, square, angle, _] = sums;
            let mean = y / all;
            let spread = (square / all - mean * mean).max(F::zero()).sqrt();
            let depth = height - touches + F::TINY;
            // errors of 1 % of the depth, 0.1 mm of place and spread, and 5 mrad are alike
            let units = [depth.times(0.01), F::of(1e-4), F::of(1e-4), F::of(5e-3)];
            let own = [height, mean, spread, angle / all];
            for ((number, own), unit) in numbers.iter_mut().zip(own).zip(units) {
                *number = own / unit;
            }
        }
        Some(probe)
    }

    /// The lateral nodes.
    fn lateral_nodes(
        &self, scene: &Scene<F>, count: usize, memory: &mut Workspace<F>,
    ) -> Result<Vec<F, 256>, Error> {
        /// A node, the numbers there, and the expected error of the interval after it.
        struct Node<F> {
            x: F,
            found: Option<Probe<F>>,
            error: F,
        }
        let mut nodes: Vec<Node<F>, 256> = Vec::new();
        let first = count.min(9);
        for k in 0..first {
            let share = F::widened(k as f32 / (first - 1) as f32);
            let x = self.lateral_from + (self.lateral_to - self.lateral_from) * share;
            let found = self.probe(scene, x, memory);
            let _ = nodes.push(Node { x, found, error: F::LARGEST });
        }
        Error::TableSpec.unless(nodes.iter().any(|node| node.found.is_some()))?;
        while nodes.len() < count {
            // the interval with the largest expected error times length, of equal ones the longest
            let mut worst = (0, -F::one(), F::zero());
            for k in 0..nodes.len() - 1 {
                let (Some(own), Some(next)) = (nodes.get(k), nodes.get(k + 1)) else { continue };
                let size = next.x - own.x;
                let is_near = size < F::of(2.0 * NEAREST_NODES);
                let error = if is_near { F::zero() } else { own.error * size };
                if error > worst.1 || (error == worst.1 && size > worst.2) {
                    worst = (k, error, size);
                }
            }
            let (k, _, size) = worst;
            let x = nodes.get(k).map_or(F::zero(), |node| node.x) + size.times(0.5);
            let found = self.probe(scene, x, memory);
            let around =
                Around::new(|k| nodes.get(k).map_or(F::zero(), |own| own.x), nodes.len(), x);
            let mut error = F::zero();
            for (number, own) in found.iter().flatten().enumerate() {
                let blended = around.blend(|k| {
                    let node = nodes.get(k).and_then(|node| node.found);
                    node.map_or(*own, |found| at(&found, number))
                });
                error = error.max((blended - *own).abs());
            }
            let error = error.times(LEFT);
            if let Some(before) = nodes.get_mut(k) {
                before.error = error;
            }
            let _ = nodes.push(Node { x, found, error });
            sort(&mut nodes, |one, other| one.x < other.x);
        }
        let mut places = Vec::new();
        for node in &nodes {
            let _ = places.push(node.x);
        }
        Ok(places)
    }
}
