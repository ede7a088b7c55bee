//! The numbers of a position at the places of the wheel, and what the heights tell.
//!
//! The nodes around the position give the heights of all levels there. With the vertical position
//! these give the support, and the levels around. `l²`, `p²` and half the angle between the
//! surfaces are blended over all nodes around.

use super::axis::Around;
use super::block::{ContactTable, Counts, MOST_PLACES, Quantity, Record, SQUARE_FLOOR};
use crate::number::avx::with_avx;
use crate::number::{Float, add, ascend, at};
use crate::status::Error;
use crate::wheel_rail::Position;
use heapless::Vec;

/// Largest number of nodes of roll, yaw and lateral position around a position: four on each axis.
const AROUND: usize = 64;

/// Numbers at successive places of the wheel.
pub(super) type AtPlaces<F> = Vec<F, MOST_PLACES>;

/// The numbers of a position. Its lists are memory of the caller's: a structure that owned them
/// would be filled with zeros first.
pub(super) struct Blend<'a, F> {
    /// `l²` \[m²\].
    pub square: &'a mut AtPlaces<F>,
    /// `p²` \[Pa²\].
    pub pressure: &'a mut AtPlaces<F>,
    /// Half the angle between the surfaces \[rad\].
    pub half_angle: &'a mut AtPlaces<F>,
    /// Number of the first place.
    pub first: usize,
    /// Vertical support \[N\], and its derivative with respect to the vertical position.
    pub support: F,
    pub stiffness: F,
    /// How far the wheel is below the height of the first level \[m\].
    pub depth: F,
}

/// `p²` over `l²` where the surfaces do not touch, as outside a contact of a sphere.
pub(super) fn pressure_by_square(modulus: f64, poisson_ratio: f64, radius: f64) -> f64 {
    let slope = 0.65 * modulus / (radius * (1.0 - poisson_ratio));
    slope * slope
}

impl<'a, F: Float> Blend<'a, F> {
    /// With empty lists.
    pub fn in_lists([square, pressure, half_angle]: [&'a mut AtPlaces<F>; 3]) -> Self {
        let zero = F::zero();
        let (support, stiffness, depth) = (zero, zero, zero);
        Self { square, pressure, half_angle, first: 0, support, stiffness, depth }
    }

    /// Finds the numbers of a position of a right wheel. Returns whether anything touches there. A
    /// position beyond the ranges is an error unless `is_beyond` allows it.
    ///
    /// # Errors
    /// [`Error::TableRange`]
    #[inline(never)]
    pub fn find(
        &mut self, table: &ContactTable, position: &Position<F>, is_beyond: bool,
    ) -> Result<bool, Error> {
        let Counts { lateral, levels, yaw, .. } = table.counts;
        let Position { lateral: y, vertical, yaw: angle, roll } = *position;
        let slabs = table.slabs_around(roll, angle);
        let in_slab = |number: Quantity, angle: F| angle.abs() <= F::of(table.quantity(number));
        let node = |k: usize| table.lateral_between(&slabs, k);
        let is_inside = in_slab(Quantity::Yaw, angle) && in_slab(Quantity::Roll, roll);
        Error::TableRange
            .unless(is_beyond || (is_inside && y >= node(0) && y <= node(lateral - 1)))?;
        let of_lateral = Around::new(node, lateral, y);
        let [of_roll, of_yaw] = &slabs;
        let mut parts = Vec::<(usize, F), AROUND>::new();
        for (r, by_roll) in of_roll.nodes() {
            for (a, by_yaw) in of_yaw.nodes() {
                for (i, by) in of_lateral.nodes() {
                    let _ = parts.push(((r * yaw + a) * lateral + i, by_roll * by_yaw * by));
                }
            }
        }
        let mut heights = [F::zero(); 64];
        for (part, weight) in &parts {
            add(&mut heights, table.heights::<F>(*part).map(|height| *weight * height));
        }
        let heights = heights.get(..levels).unwrap_or(&[]);
        Error::TableRange.unless(ascend(heights))?;
        let (first, last) = (at(heights, 0), at(heights, levels - 1));
        Error::TableRange.unless(is_beyond || vertical <= last)?;
        let of_level = Around::new(|k| at(heights, k), levels, vertical);
        // N^(2/3), and its derivative
        let power = of_level.blend(|k| table.load(k));
        if !(power > F::zero()) {
            return Ok(false);
        }
        let near = (0..levels - 2).take_while(|k| at(heights, k + 1) <= vertical).count();
        let [low, high] = [near, near + 1].map(|k| at(heights, k));
        let slope = (table.load::<F>(near + 1) - table.load(near)) / (high - low);
        self.support = power * power.sqrt();
        self.stiffness = power.sqrt() * slope.times(1.5);
        self.depth = (vertical - first).max(F::zero());
        // the fields are linear in the height
        let share = (vertical - low) / (high - low);
        let of_levels = [(near, F::one() - share), (near + 1, share)];
        self.add(table, &parts, |(part, weight)| {
            of_levels.map(|(level, by)| (table.record(part * levels + level), *weight * by))
        });
        Ok(true)
    }

    /// Adds the fields of nodes, each with its weight, to none: two levels of each of some parts.
    fn add<P>(
        &mut self, table: &ContactTable, parts: &[P], nodes: impl Fn(&P) -> [(Record, F); 2],
    ) {
        let (mut from, mut to) = (table.counts.places, 0);
        for part in parts {
            for (record, _) in nodes(part) {
                let first = record.first as usize;
                from = from.min(first);
                to = to.max((first + record.count as usize).min(table.counts.places));
            }
        }
        // two places more on both sides, for the bends there
        (from, to) = (from.saturating_sub(2), (to + 2).min(table.counts.places));
        let [radius, modulus, ratio] =
            [Quantity::WheelRadius, Quantity::ShearModulus, Quantity::PoissonRatio]
                .map(|number| table.quantity(number));
        let floor = F::of(SQUARE_FLOOR);
        let least_pressure = floor * F::of(pressure_by_square(modulus, ratio, radius));
        let Self { square, pressure, half_angle, first: begin, .. } = self;
        *begin = from;
        for _ in from..to {
            let _ = square.push(-floor);
            let _ = pressure.push(-least_pressure);
            let _ = half_angle.push(F::zero());
        }
        for part in parts {
            for (record, weight) in nodes(part) {
                let ([squares, pressures], angles) = table.fields(&record);
                let first = (record.first as usize).saturating_sub(from);
                let [length, peak, angle] = record.scales.map(|scale| F::widened(scale) * weight);
                add_numbers(square, first, squares, [length, floor * weight]);
                add_numbers(pressure, first, pressures, [peak, least_pressure * weight]);
                add_angles(half_angle, first, angles, angle);
            }
        }
    }
}

/// Adds numbers of 16 bits times their scale, and one number more, to a list from a place on.
fn add_numbers<F: Float>(list: &mut [F], first: usize, numbers: &[[u8; 2]], factors: [F; 2]) {
    with_avx!(if F::LANES => <F: Float>(
        list: &mut [F], first: usize, numbers: &[[u8; 2]], factors: [F; 2]
    ) -> () {
        let [scale, more] = factors;
        for (own, bytes) in list.iter_mut().skip(first).zip(numbers) {
            *own += F::widened(f32::from(i16::from_le_bytes(*bytes))) * scale + more;
        }
    });
}

/// Adds angles of 8 bits times their scale to a list from a place on; before them the first, and
/// after them the last.
fn add_angles<F: Float>(list: &mut [F], first: usize, angles: &[u8], scale: F) {
    with_avx!(if F::LANES => <F: Float>(
        list: &mut [F], first: usize, angles: &[u8], scale: F
    ) -> () {
        let number = |byte: u8| F::widened(f32::from(i8::from_le_bytes([byte]))) * scale;
        let (Some(begin), Some(end)) = (angles.first(), angles.last()) else { return };
        let (before, rest) = parted(list, first);
        let (inside, after) = parted(rest, angles.len());
        for (own, byte) in inside.iter_mut().zip(angles) {
            *own += number(*byte);
        }
        for (places, outer) in [(before, begin), (after, end)] {
            let term = number(*outer);
            places.iter_mut().for_each(|own| *own += term);
        }
    });
}

/// The first numbers of a list, at most so many, and the others.
fn parted<F>(list: &mut [F], first: usize) -> (&mut [F], &mut [F]) {
    let first = first.min(list.len());
    list.split_at_mut_checked(first).unwrap_or_default()
}
