//! A table is begun: places on the wheel, loads of the levels, the lateral nodes, and the shifts of
//! the slabs.
//!
//! * The loads grow with the third power of the level: the heights then have about equal distances.
//! * Lateral nodes are found for the slab without yaw and roll: the interval in whose middle the
//!   interpolation is worst is halved, as long as there are nodes.
//! * A slab is shifted by as much as the lateral position at which the flange carries.

use super::axis::Around;
use super::block::{
    BEGUN, ContactTable, Quantity, check_pair, write_bytes, write_header, write_number,
};
use super::fill::plain;
use super::spec::TableSpec;
use crate::contact::totals::StripCount;
use crate::number::{Float, at, sort};
use crate::status::Error;
use crate::wheel_rail::Position;
use crate::wheel_rail::scene::{Scene, Workspace};
use heapless::Vec;

/// Load of the first level over the largest.
const FIRST_LOAD: f64 = 1e-7;
/// Loads that find the lateral nodes, over the largest.
const PROBED: [f64; 2] = [0.055, 0.55];
/// Nearest lateral nodes \[m\].
const NEAREST_NODES: f64 = 16e-6;
/// Part of an interval's error that its halves are expected to have.
const LEFT: f64 = 0.25;
/// Load that finds the flange, over the largest, and the angle of a contact there \[rad\].
const FLANGE_LOAD: f64 = 0.09;
const FLANGE_ANGLE: f64 = -0.7;
/// How far the flange is sought from where it would be by the roll alone \[m\], and how often this
/// range is halved.
const FLANGE_RANGE: f64 = 4e-3;
const FLANGE_HALVINGS: u32 = 14;
const PROBE: usize = 8;

/// Numbers of the contacts at a lateral position that must be interpolated well, and by how much
/// they may be wrong to be as bad as another.
type Probe<F> = [F; PROBE];

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
        let [shifts, of_lateral, loads, of_places, ..] = counts.sections();
        let mut write = |from: usize, k: usize, value: F| {
            write_bytes(block, from + 8 * k, value.to_f64().to_le_bytes());
        };
        for (k, x) in lateral.iter().enumerate() {
            write(of_lateral, k, *x);
        }
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
        self.write_shifts(&scene, shifts, memory, block)
    }

    /// Writes by how much each slab is shifted.
    fn write_shifts(
        &self, scene: &Scene<F>, from: usize, memory: &mut Workspace<F>, block: &mut [u8],
    ) -> Result<(), Error> {
        let range = F::of(FLANGE_RANGE);
        let base =
            self.flange(scene, &Position::default(), self.lateral_from, self.lateral_to, memory);
        for slab in 0..ContactTable::in_state(block, BEGUN)?.counts.slabs() {
            let table = ContactTable::in_state(block, BEGUN)?;
            let [roll, yaw] = table.roll_and_yaw::<F>(slab);
            let by_roll = roll * scene.pair.wheel_radius;
            let position = Position { yaw, roll, ..Position::default() };
            let shift = base.and_then(|base| {
                let about = base + by_roll;
                let own = self.flange(scene, &position, about - range, about + range, memory)?;
                Some(own - base)
            });
            let shift = shift.unwrap_or(by_roll);
            write_bytes(block, from + 8 * slab, shift.to_f64().to_le_bytes());
        }
        Ok(())
    }

    /// The lateral position between two at which the flange begins to carry; none where it does at
    /// the first, or not at the last.
    fn flange(
        &self, scene: &Scene<F>, position: &Position<F>, mut free: F, mut on: F,
        memory: &mut Workspace<F>,
    ) -> Option<F> {
        let mut carries = |lateral: F| {
            let position = Position { lateral, ..*position };
            let load = self.load.times(FLANGE_LOAD);
            let found = scene.height_for_load(&position, load, None, memory);
            let first = memory.found().first();
            found.is_err() || first.is_none_or(|own| own.angle < F::of(FLANGE_ANGLE))
        };
        if carries(free) || !carries(on) {
            return None;
        }
        for _ in 0..FLANGE_HALVINGS {
            let middle = (free + on).times(0.5);
            if carries(middle) {
                on = middle;
            } else {
                free = middle;
            }
        }
        Some(free)
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
            // the interval with the largest expected error, of equal ones the longest
            let mut worst = (0, -F::one(), F::zero());
            for k in 0..nodes.len() - 1 {
                let (Some(own), Some(next)) = (nodes.get(k), nodes.get(k + 1)) else { continue };
                let size = next.x - own.x;
                let is_near = size < F::of(2.0 * NEAREST_NODES);
                let error = if is_near { F::zero() } else { own.error };
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
