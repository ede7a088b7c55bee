//! From a table and a position to the contacts of a wheel, and to force and moment.
//!
//! 1. The numbers of the position at the places of the wheel are [blended](super::blend).
//! 2. **A strip** is the part of the interval between two places in which the blended `l²` is
//!    positive. Both squares are linear there, and the strip has their means. The intervals do not
//!    move with the wheel's position, and a strip begins and ends with a width of zero.
//! 3. **Contacts** are groups of zones of strips, as in the direct computation.
//! 4. The pressures are multiplied by one factor, so that they support what the heights tell.

use super::blend::{AtPlaces, Blend};
use super::block::ContactTable;
use crate::forces::Model;
use crate::normal::crossings::Overlap;
use crate::number::{Arithmetic, Float, Strips, at};
use crate::patch::{KSTRIP_PATCH_CAPACITY, PatchStrip};
use crate::status::{Error, Warning};
use crate::wheel_rail::contacts::WheelContact;
use crate::wheel_rail::contacts::groups::{Groups, Overlaps};
use crate::wheel_rail::contacts::view::Place;
use crate::wheel_rail::forces::wrench::{self, Law, Wrench, WrenchByPosition, WrenchDerivatives};
use crate::wheel_rail::profile::{CurvePoint, Piece};
use crate::wheel_rail::scene::{TableSource, Workspace};
use crate::wheel_rail::touch::angle_of;
use crate::wheel_rail::touch::line_of_contact::Wheel;
use crate::wheel_rail::touch::roller::Over;
use crate::wheel_rail::{BodyState, Position, Requested, WheelPair};
use heapless::Vec;

/// `l²` over `R` times the distance of the undeformed and the deformed surfaces.
pub(super) const ROUNDNESS: f64 = 2.6;
/// Largest factor of the pressures.
const MOST_SCALED: f64 = 2.0;
/// One strip more than all contacts together may have.
const TOO_MANY: usize = KSTRIP_PATCH_CAPACITY + 1;
/// Step of differences \[m, rad\], in double and in single precision.
const STEPS: [f64; 2] = [1e-8, 5e-6];

/// A wheel over a table.
#[derive(Clone, Copy)]
pub struct TableScene<'a, F> {
    /// The table.
    pub table: ContactTable<'a>,
    /// Friction, side, damping, speeds; radius and materials are those of the table.
    pub pair: &'a WheelPair<F>,
    /// The law of the creep forces.
    pub law: Law<'a, F>,
}

/// The part of an interval between two places in which the bodies touch.
#[derive(Clone, Copy)]
struct Covered<F> {
    /// Quantity of the place before.
    before: usize,
    /// Its middle, as share of the interval, and its ends as lengths on the wheel \[m\].
    share: F,
    ends: [F; 2],
    /// Half the angle between the surfaces \[rad\].
    half_angle: F,
    /// Means of `l²` and `p²`.
    square: F,
    pressure: F,
    /// Quantity of its zone.
    zone: usize,
}

/// What the strips on a wheel have in common.
struct Blended<F> {
    zones: Overlaps<F>,
    /// Number of places from one end of an interval to the other.
    stride: usize,
    /// Depth \[m\], and the derivative of the support \[N/m\].
    indented: [F; 2],
    /// Vertical support \[N\].
    support: F,
    warning: Warning,
}

/// The second difference of numbers at a place; zero at their ends.
fn bend<F: Float>(list: &[F], k: usize, stride: usize) -> F {
    let beside = k.checked_sub(stride).zip(list.get(k + stride));
    beside.map_or(F::zero(), |(before, after)| at(list, before) - at(list, k).times(2.0) + *after)
}

/// Strips on the wheel, as many as there is room for.
type OnWheel<F> = Vec<Covered<F>, TOO_MANY>;

impl<F: Float> Blend<'_, F> {
    /// Finds the strips on a wheel of a radius, and the zones that they are. `stride` is the number
    /// of places from one end of an interval to the other, a power of two.
    #[inline(never)]
    fn strips_on_wheel(
        &self, table: &ContactTable, (stride, radius): (usize, F), strips: &mut OnWheel<F>,
    ) -> Overlaps<F> {
        let Self { square, pressure, half_angle, first, .. } = self;
        let mut zones = Overlaps::new();
        strips.clear();
        let mut open: Option<Overlap<F>> = None;
        let mut zone = 0;
        let per_depth = F::one() / radius.times(ROUNDNESS);
        let here = |k: usize| table.along::<F>(first + k);
        let step = here(stride) - here(0);
        // the intervals of a table lie where they lie, whatever the first blended place
        let mut next = first.wrapping_neg() & (stride - 1);
        while next + stride < square.len() {
            let k = next;
            next += stride;
            let ends_of = |list: &[F]| [at(list, k), at(list, k + stride)];
            let [from, to] = ends_of(square);
            let (begins, ends) = (from > F::zero(), to > F::zero());
            if !(begins || ends) {
                continue;
            }
            let (zero, one) = (F::zero(), F::one());
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
            let lengths = shares.map(|share| here(k) + step * share);
            let [begin, end] = lengths;
            let strip = Covered {
                before: first + k,
                share,
                ends: lengths,
                half_angle: middle(half_angle),
                square: mean(square),
                pressure: mean(pressure),
                zone,
            };
            if strip.square.sqrt() > F::TINY && end - begin > F::TINY {
                let _ = strips.push(strip);
            }
            let own = open.get_or_insert(Overlap { ends: [begin, end], depth: zero });
            own.ends[1] = end;
            own.depth = own.depth.max(from.max(to) * per_depth);
            if !ends && let Some(done) = open.take() {
                zones.push(done);
                zone += 1;
            }
        }
        if let Some(last) = open {
            zones.push(last);
        }
        zones
    }
}

/// Appends the places of strips on the wheel's surface, four side by side.
fn add_places<F: Float>(
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

/// A finished table as the source of the contacts of a [`Scene`](crate::wheel_rail::scene::Scene).
/// `only`: whether a position outside the table is [`Error::TableRange`]; else its contacts are
/// computed.
#[must_use]
pub fn source<F: Float>(bytes: &[u8], only: bool) -> TableSource<'_, F> {
    TableSource {
        bytes,
        only,
        find: |bytes, pair, position, memory| {
            let law = Law { model: Model::Strip, falling: None };
            TableScene { table: ContactTable::new(bytes)?, pair, law }.place(position, memory)
        },
        solve: |bytes, (pair, law), state, memory, requested| {
            let Requested { by_velocity, by_position } = requested;
            let requested = Requested {
                by_velocity: by_velocity.as_deref_mut(),
                by_position: by_position.as_deref_mut(),
            };
            let scene = TableScene { table: ContactTable::new(bytes)?, pair, law };
            scene.differentiate(state, memory, requested)
        },
    }
}

impl<F: Float> TableScene<'_, F> {
    /// Finds the contacts of a position.
    ///
    /// # Errors
    /// [`Error::TableRange`] outside the table; [`Error::TablePair`]; those of the pair and the
    /// position.
    pub fn place(
        &self, position: &Position<F>, memory: &mut Workspace<F>,
    ) -> Result<Warning, Error> {
        position.check()?;
        self.table.check_pair(self.pair)?;
        self.place_checked(position, false, memory)
    }

    /// Finds the strips at a position of a right wheel; none where nothing touches. The lists of
    /// the blend leave the stack with it.
    #[inline(never)]
    fn strips_at(
        &self, right: &Position<F>, is_beyond: bool, strips: &mut OnWheel<F>,
    ) -> Result<Option<Blended<F>>, Error> {
        let Self { table, pair, .. } = self;
        let (mut square, mut pressure, mut half_angle) =
            (AtPlaces::new(), AtPlaces::new(), AtPlaces::new());
        let mut blend = Blend::in_lists([&mut square, &mut pressure, &mut half_angle]);
        if !blend.find(table, right, is_beyond)? {
            return Ok(None);
        }
        let (mut stride, mut warning) = (1, Warning::None);
        let mut zones = blend.strips_on_wheel(table, (stride, pair.wheel_radius), strips);
        while strips.len() > KSTRIP_PATCH_CAPACITY {
            (stride, warning) = (2 * stride, Warning::Rough);
            zones = blend.strips_on_wheel(table, (stride, pair.wheel_radius), strips);
        }
        let Blend { depth, stiffness, support, .. } = blend;
        Ok(Some(Blended { zones, stride, indented: [depth, stiffness], support, warning }))
    }

    fn place_checked(
        &self, position: &Position<F>, is_beyond: bool, memory: &mut Workspace<F>,
    ) -> Result<Warning, Error> {
        let Self { table, pair, .. } = self;
        (memory.count, memory.gap.count) = (0, 0);
        let right = position.mirrored(pair.left != 0);
        let mut own = OnWheel::new();
        let Some(blended) = self.strips_at(&right, is_beyond, &mut own)? else {
            return Ok(Warning::None);
        };
        let Blended { zones, stride, indented, support: wanted, mut warning } = blended;
        let wheel = Wheel::new(pair.wheel_radius, &right);
        let mut places = Vec::new();
        add_places(table, &wheel, &own, (stride, pair.rail_speed), &mut places);
        let mut groups = Groups::new();
        if !zones.group(&mut groups) {
            warning = Warning::Rough;
        }
        let (mut support, mut written) = (F::zero(), 0);
        let Workspace { strips, contacts, .. } = memory;
        for (group, contact) in groups.iter().zip(contacts.iter_mut()) {
            let [first, last] = group.zones;
            let begin = own.partition_point(|strip| strip.zone < first);
            let end = own.partition_point(|strip| strip.zone <= last);
            let of_group = (own.get(begin..end)).zip(places.get(begin..end));
            let Some((inside, of_strips)) = of_group else { continue };
            let Some(first) = of_strips.first() else { continue };
            strips.clear(pair.shear_modulus, pair.poisson_ratio);
            for (strip, place) in inside.iter().zip(of_strips) {
                strips.push(strip.of_patch(place));
            }
            contact.fill(pair, &right, strips, indented, |k, _| *of_strips.get(k).unwrap_or(first));
            contact.share = group.share.clamped(F::zero(), F::one());
            let [_, _, vertical, ..] = contact.normal;
            support += contact.share * contact.normal_force * vertical;
            written += 1;
        }
        if !(support > F::zero()) {
            return Ok(Warning::None);
        }
        memory.count = written as u32;
        let scale = (wanted / support).min(F::of(MOST_SCALED));
        for contact in memory.contacts.iter_mut().take(written) {
            contact.scale_pressure(scale, support);
            if contact.is_conformal() {
                warning = warning.worse(Warning::AngleRange);
            }
        }
        Ok(warning)
    }

    fn wrench_at(
        &self, state: &BodyState<F>, is_beyond: bool, memory: &mut Workspace<F>,
        by_velocity: Option<&mut WrenchDerivatives<F>>,
    ) -> Result<Wrench<F>, Error> {
        let placed = self.place_checked(&state.position, is_beyond, memory)?;
        let Workspace { strips, contacts, count, .. } = memory;
        let found = contacts.get(..*count as usize).unwrap_or(&[]);
        let wrench = wrench::of_contacts_in(strips, found, &state.velocity, self.law, by_velocity)?;
        Ok(Wrench { warning: wrench.warning.worse(placed), ..wrench })
    }

    /// The wrench of a position and a velocity, with the derivatives that are requested. Those with
    /// respect to the position are differences of the interpolated wrench.
    ///
    /// # Errors
    /// Those of [`TableScene::place`] and of
    /// [`of_contacts`](crate::wheel_rail::forces::wrench::of_contacts).
    pub fn differentiate(
        &self, state: &BodyState<F>, memory: &mut Workspace<F>,
        requested: Requested<WrenchDerivatives<F>, WrenchByPosition<F>>,
    ) -> Result<Wrench<F>, Error> {
        state.position.check()?;
        self.table.check_pair(self.pair)?;
        let Requested { by_velocity, by_position } = requested;
        let found = self.wrench_at(state, false, memory, by_velocity)?;
        let Some(slopes) = by_position else { return Ok(found) };
        let [double, single] = STEPS.map(F::of);
        let step = if F::EPSILON > F::of(1e-10) { single } else { double };
        for (k, column) in slopes.columns().into_iter().enumerate() {
            let mut moved = *state;
            let members = moved.position.members_mut();
            members.into_iter().skip(k).take(1).for_each(|own| *own += step);
            *column = self.wrench_at(&moved, true, memory, None)?.members();
            for (slope, own) in column.iter_mut().zip(found.members()) {
                *slope = (*slope - own) / step;
            }
        }
        self.place_checked(&state.position, false, memory)?;
        Ok(found)
    }
}

impl<F: Float> Covered<F> {
    /// The strip of a patch at a place.
    fn of_patch(&self, place: &Place<F>) -> PatchStrip<F> {
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

impl<F: Float> WheelContact<F> {
    /// Multiplies the pressures by a factor. The stiffness is that of all contacts before, and each
    /// has a part of it by its share of their support.
    fn scale_pressure(&mut self, factor: F, support: F) {
        for strip in self.patch.used_mut() {
            strip.peak_pressure = strip.peak_pressure * factor;
        }
        let [_, _, vertical, ..] = self.normal;
        let part = self.normal_force / support;
        // upward by downward: N n_z by δ/n_z
        self.stiffness = self.stiffness * part / (vertical + F::TINY);
        self.approach = self.approach * vertical;
        self.normal_force = self.normal_force * factor;
    }
}
