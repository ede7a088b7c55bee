//! From the blended numbers of a position to strips on the wheel, and to their places in space.
//!
//! **A strip** is the part of an interval between two places in which the blended `l²` is positive.
//! Both squares are linear there, and the strip has their means. The intervals do not move with the
//! wheel's position, and a strip begins and ends with a width of zero.

use super::blend::Blend;
use super::block::ContactTable;
use crate::normal::crossings::Overlap;
use crate::number::{Arithmetic, Float, Strips, at};
use crate::patch::{KSTRIP_PATCH_CAPACITY, PatchStrip};
use crate::wheel_rail::contacts::groups::Overlaps;
use crate::wheel_rail::contacts::view::Place;
use crate::wheel_rail::profile::{CurvePoint, Piece};
use crate::wheel_rail::touch::angle_of;
use crate::wheel_rail::touch::line_of_contact::Wheel;
use crate::wheel_rail::touch::roller::Over;
use heapless::Vec;

/// `l²` over `R` times the distance of the undeformed and the deformed surfaces.
pub(super) const ROUNDNESS: f64 = 2.6;
/// One strip more than all contacts together may have.
const TOO_MANY: usize = KSTRIP_PATCH_CAPACITY + 1;

/// The part of an interval between two places in which the bodies touch.
#[derive(Clone, Copy)]
pub(super) struct Covered<F> {
    /// Number of the place before it.
    before: usize,
    /// Its middle, as share of the interval, and its ends as lengths on the wheel \[m\].
    share: F,
    ends: [F; 2],
    /// Half the angle between the surfaces \[rad\].
    half_angle: F,
    /// Means of `l²` and `p²`.
    square: F,
    pressure: F,
    /// Number of its zone.
    pub zone: usize,
}

/// The second difference of numbers at a place; zero at their ends.
fn bend<F: Float>(list: &[F], k: usize, stride: usize) -> F {
    let beside = k.checked_sub(stride).zip(list.get(k + stride));
    beside.map_or(F::zero(), |(before, after)| at(list, before) - at(list, k).times(2.0) + *after)
}

/// Strips on the wheel, as many as there is room for.
pub(super) type OnWheel<F> = Vec<Covered<F>, TOO_MANY>;

impl<F: Float> Blend<'_, F> {
    /// Finds the strips on a wheel of a radius, and the zones that they are. `stride` is the number
    /// of places from one end of an interval to the other, a power of two.
    #[inline(never)]
    pub(super) fn strips_on_wheel(
        &self, table: &ContactTable, (stride, radius): (usize, F), strips: &mut OnWheel<F>,
    ) -> Overlaps<F> {
        let Self { square, first, .. } = self;
        let mut zones = Overlaps::new();
        strips.clear();
        let mut open: Option<Overlap<F>> = None;
        let mut zone = 0;
        let per_depth = F::one() / radius.times(ROUNDNESS);
        // the intervals of a table lie where they lie, whatever the first blended place
        let mut next = first.wrapping_neg() & (stride - 1);
        while next + stride < square.len() {
            let k = next;
            next += stride;
            let [from, to] = [at(square, k), at(square, k + stride)];
            let Some(strip) = self.covered(table, [k, stride], zone) else { continue };
            let [begin, end] = strip.ends;
            if strip.square.sqrt() > F::TINY && end - begin > F::TINY {
                let _ = strips.push(strip);
            }
            let own = open.get_or_insert(Overlap { ends: [begin, end], depth: F::zero() });
            own.ends[1] = end;
            own.depth = own.depth.max(from.max(to) * per_depth);
            if to <= F::zero()
                && let Some(done) = open.take()
            {
                zones.push(done);
                zone += 1;
            }
        }
        if let Some(last) = open {
            zones.push(last);
        }
        zones
    }

    /// The part of the interval from a place to the one a stride further in which the bodies touch,
    /// if they do.
    #[inline(always)]
    fn covered(
        &self, table: &ContactTable, [k, stride]: [usize; 2], zone: usize,
    ) -> Option<Covered<F>> {
        let Self { square, pressure, half_angle, first, .. } = self;
        let ends_of = |list: &[F]| [at(list, k), at(list, k + stride)];
        let [from, to] = ends_of(square);
        let (zero, one) = (F::zero(), F::one());
        let (begins, ends) = (from > zero, to > zero);
        if !(begins || ends) {
            return None;
        }
        let crossing = from / (from - to);
        let shares = [if begins { zero } else { crossing }, if ends { one } else { crossing }];
        let [share, width] =
            [(shares[0] + shares[1]).times(0.5), (shares[1] - shares[0]).squared()];
        let middle = |list| {
            let [from, to] = ends_of(list);
            from + (to - from) * share
        };
        // of a parabola the mean is beside the middle of the chord
        let mean = |list| {
            let bends = bend(list, k, stride) + bend(list, k + stride, stride);
            (middle(list) - bends * width.times(1.0 / 24.0)).max(zero)
        };
        let here = |k: usize| table.along::<F>(first + k);
        let step = here(stride) - here(0);
        Some(Covered {
            before: first + k,
            share,
            ends: shares.map(|share| here(k) + step * share),
            half_angle: middle(half_angle),
            square: mean(square),
            pressure: mean(pressure),
            zone,
        })
    }
}

/// Appends the places of strips on the wheel's surface, four side by side.
pub(super) fn add_places<F: Float>(
    table: &ContactTable, wheel: &Wheel<F>, strips: &[Covered<F>],
    (stride, rail_speed): (usize, F), places: &mut Vec<Place<F>, TOO_MANY>,
) {
    for four in strips.chunks(F::Four::COUNT) {
        let of = |k: usize| four.get(k).or(four.last());
        let point = |further: usize, member: fn(CurvePoint<F>) -> F| {
            F::Four::gather(|k| {
                of(k).map_or(F::zero(), |own| member(table.point(own.before + further)))
            })
        };
        let points = [0, stride].map(|further| CurvePoint {
            y: point(further, |point| point.y),
            z: point(further, |point| point.z),
            cosine: point(further, |point| point.cosine),
            sine: point(further, |point| point.sine),
        });
        let length = F::Four::all(table.along(stride));
        let share = F::Four::gather(|k| of(k).map_or(F::zero(), |own| own.share));
        let [before, after] = points;
        let [y, z] = Piece::new(before, after, length).at(share);
        let per_length = length.inverse();
        let point = CurvePoint {
            y: y.value,
            z: z.value,
            cosine: y.slope * per_length,
            sine: z.slope * per_length,
        };
        let line = wheel.line_of_contact::<F::Four>(&point);
        for (k, own) in four.iter().enumerate() {
            let [normal_y, normal_z] = &line.normal;
            let of_wheel = angle_of(-normal_y.lane(k), normal_z.lane(k));
            let _ = places.push(Place {
                point: core::array::from_fn(|axis| {
                    line.place.get(axis).map_or(F::zero(), |of| of.lane(k))
                }),
                angle: of_wheel + own.half_angle,
                lean: own.half_angle,
                over: Over::straight(),
                rail_speed,
            });
        }
    }
}

impl<F: Float> Covered<F> {
    /// The strip of a patch at a place.
    pub(super) fn of_patch(&self, place: &Place<F>) -> PatchStrip<F> {
        let ([begin, end], [centre_x, ..]) = (self.ends, place.point);
        PatchStrip {
            y: (begin + end).times(0.5),
            width: end - begin,
            half_length: self.square.sqrt(),
            centre_x,
            peak_pressure: self.pressure.sqrt(),
            friction: F::zero(),
        }
    }
}
