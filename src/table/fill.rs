//! What a node holds: the height at which the rail supports the wheel with the load of its level,
//! and, at the places of the wheel, `l²` and `p²` of the contact there and half the angle between
//! the surfaces.
//!
//! Between the strips both squares are linear. Outside they are negative, so that zones appear and
//! vanish without a kink in between: with the distance `d` of the undeformed surfaces and their
//! deflection `u` by all strips
//!
//! ```text
//! l² = −2.6 R (d + 0.73 u − e),   u = (1 − ν)/(π G) Σ N/√((y − y_j)² + 0.36 l_j²)
//! ```
//!
//! where `e` makes it zero at the nearest end of a zone, and fades with the distance from there.

use super::blend::pressure_by_square;
use super::block::{
    BEGUN, ContactTable, FIELD, MOST_PLACES, RECORD, Record, SQUARE_FLOOR, write_bytes,
};
use super::strips::ROUNDNESS;
use crate::contact::totals::StripCount;
use crate::number::{Arithmetic, Float, Strips, length, pairs};
use crate::patch::{KSTRIP_PATCH_CAPACITY, PatchStrip};
use crate::status::Error;
use crate::wheel_rail::contacts::WheelContact;
use crate::wheel_rail::profile::PreparedProfile;
use crate::wheel_rail::scene::{Scene, Workspace};
use crate::wheel_rail::touch::angle_of;
use crate::wheel_rail::touch::line_of_contact::{Turn, Wheel};
use crate::wheel_rail::{KSTRIP_CONTACTS_CAPACITY, Position, WheelPair};
use core::f64::consts::PI;
use heapless::Vec;

/// Share of the deflection that counts, and square of the half length that it has beside it.
const COUNTED: f64 = 0.73;
const BESIDE: f64 = 0.36;
/// Distance over which the correction at the ends of zones fades \[m\], and beyond which no
/// deflection counts.
const END_FADES: f64 = 1.5e-3;
const BEYOND: f64 = 1e-4;
/// Largest number of places of a contact, and of ends of zones of all contacts.
const OUTLINE: usize = 3 * KSTRIP_PATCH_CAPACITY;
const ENDS: usize = 32;

/// A point of the gap on the wheel.
#[derive(Clone, Copy)]
struct WheelPoint {
    /// Length on the wheel and on the rail \[m\].
    own: f64,
    along: f64,
    distance: f64,
    half_angle: f64,
    radius: f64,
}

/// A place of a contact on the rail: length, `l²`, `p²`, and whether the contact reaches it from
/// the place before.
type OnRail = ([f64; 3], bool);

/// The memory of a part of a table that is filled, and where the fields of its nodes begin.
pub(super) struct Part<'a> {
    pub heights: &'a mut [u8],
    pub records: &'a mut [u8],
    pub fields: &'a mut [u8],
    pub offset: usize,
}

/// A pair whose contacts tables have: those of a right wheel without friction.
pub(super) fn plain<F: Float>(pair: &WheelPair<F>) -> WheelPair<F> {
    let (zero, left) = (F::zero(), 0);
    WheelPair { left, friction: zero, friction_points: 0, normal_damping: zero, ..*pair }
}

/// The position of a part without its height.
pub(super) fn position_of<F: Float>(table: &ContactTable, part: usize) -> Position<F> {
    let nodes = table.counts.lateral.max(1);
    let slab = part / nodes;
    let [roll, yaw] = table.roll_and_yaw(slab);
    Position { lateral: table.lateral(part), vertical: F::zero(), yaw, roll }
}

/// Fills a part. A node that has no contact gets a height that is no number.
///
/// # Errors
/// Those of a table that is not begun, of another pair, or of profiles that are not prepared.
pub(super) fn fill<F: Float>(
    scene: &Scene<F>, head: &[u8], number: usize, part: &mut Part, memory: &mut Workspace<F>,
) -> Result<(), Error> {
    let table = ContactTable::in_state(head, BEGUN)?;
    table.check_pair(scene.pair)?;
    scene.rail.check()?;
    scene.wheel.check()?;
    let pair = plain(scene.pair);
    let fine = Scene { pair: &pair, strips: StripCount::SixtyFour, table: None, ..*scene };
    let mut position = position_of(&table, number);
    for level in 0..table.counts.levels {
        let load = table.load::<F>(level);
        let found = fine.height_for_load(&position, load * load.sqrt(), None, memory);
        let placed = found.and_then(|(height, _)| {
            position.vertical = height;
            fine.place(&position, memory)
        });
        let height = if placed.is_ok() && memory.count > 0 {
            let at = part.offset + level * FIELD * table.counts.places;
            let out = part.fields.get_mut(level * FIELD * table.counts.places..);
            let record = write_node(&fine, &table, &position, memory, (at, out.unwrap_or(&mut [])));
            write_bytes(part.records, RECORD * level, record.bytes());
            position.vertical.to_f64()
        } else {
            write_bytes(part.records, RECORD * level, Record::default().bytes());
            f64::NAN
        };
        write_bytes(part.heights, 8 * level, height.to_le_bytes());
    }
    Ok(())
}

/// Points of a gap on the wheel, in ascending length.
fn points_on_wheel<F: Float>(
    wheel: &PreparedProfile<F>, radius: F, position: &Position<F>, memory: &Workspace<F>,
) -> Vec<WheelPoint, MOST_PLACES> {
    let (turn, turned) = (Turn::new(position), Wheel::new(radius, position));
    let gap = &memory.gap;
    let mut points = Vec::new();
    let mut k = 0;
    let members = gap.along.iter().zip(&gap.distance).zip(&gap.angle).zip(&gap.rolling_radius);
    let places = gap.x.iter().zip(&gap.y).zip(&gap.z);
    for ((((along, distance), angle), rolling), ((x, y), z)) in
        members.zip(places).take(gap.count as usize)
    {
        let [x, y, z] = turn.to_wheelset([*x, *y, *z]);
        let z = length(x, z) - radius;
        let far = |k: usize| {
            let own = wheel.point(k).filter(|_| k < wheel.count as usize);
            own.map_or(F::LARGEST, |own| (own.y - y).squared() + (own.z - z).squared())
        };
        while far(k + 1) <= far(k) {
            k += 1;
        }
        if far(k) > wheel.step.squared() {
            // the next point is on another part of the profile
            k = (0..wheel.count as usize)
                .fold(0, |best, k| if far(k) < far(best) { k } else { best });
        }
        let Some(own) = wheel.point(k) else { continue };
        let beside = (y - own.y) * own.cosine + (z - own.z) * own.sine;
        let point = wheel.points::<F::Four>(|_| k);
        let [normal_y, normal_z] = turned.line_of_contact(&point).normal;
        let of_wheel = angle_of(-normal_y.lane(0), normal_z.lane(0));
        let _ = points.push(WheelPoint {
            own: (wheel.step * F::widened(k as f32) + beside).to_f64(),
            along: along.to_f64(),
            distance: distance.to_f64(),
            half_angle: (*angle - of_wheel).to_f64(),
            radius: rolling.to_f64(),
        });
    }
    points
}

/// The places of a contact: the middles of its strips, and the ends of its zones.
fn outline<F: Float>(contact: &WheelContact<F>) -> Vec<OnRail, OUTLINE> {
    let mut places = Vec::new();
    let mut last: Option<(&PatchStrip<F>, f64)> = None;
    for strip in contact.patch.used() {
        let half = strip.width.times(0.5);
        let [begin, middle, end] =
            [-half, F::zero(), half].map(|from| (contact.along + strip.y + from).to_f64());
        if last.is_none_or(|(before, _)| before.is_apart(strip)) {
            if let Some((_, end)) = last {
                let _ = places.push(([end, 0.0, 0.0], true));
            }
            let _ = places.push(([begin, 0.0, 0.0], false));
        }
        let [l, p] = [strip.half_length, strip.peak_pressure].map(F::to_f64);
        let _ = places.push(([middle, l * l, p * p], true));
        last = Some((strip, end));
    }
    if let Some((_, end)) = last {
        let _ = places.push(([end, 0.0, 0.0], true));
    }
    places
}

/// `l²` and `p²` of a contact at a length on the rail; none outside its zones.
fn inside(places: &[OnRail], along: f64) -> Option<[f64; 2]> {
    pairs(places).find_map(|(([from, a, b], _), ([to, c, d], joined))| {
        let share = (along - from) / (to - from);
        let is_here = *joined && (0.0..1.0).contains(&share);
        is_here.then_some([a + (c - a) * share, b + (d - b) * share])
    })
}

/// The surfaces of a node at lengths on the rail.
struct Surfaces<'a, F> {
    contacts: &'a [WheelContact<F>],
    /// The places of the contacts.
    outlines: Vec<Vec<OnRail, OUTLINE>, KSTRIP_CONTACTS_CAPACITY>,
    points: &'a [WheelPoint],
    /// `0.73 (1 − ν)/(π G)`
    compliance: f64,
    /// Ends of zones on the rail, with `d + 0.73 u` there.
    ends: Vec<[f64; 2], ENDS>,
}

impl<F: Float> Surfaces<'_, F> {
    /// The point of the gap at a length, by any of its lengths; none beyond its points.
    fn point(&self, of: impl Fn(&WheelPoint) -> f64, at: f64, step: f64) -> Option<WheelPoint> {
        let next = self.points.partition_point(|point| of(point) <= at);
        let (before, after) = (self.points.get(next.checked_sub(1)?)?, self.points.get(next)?);
        let length = of(after) - of(before);
        let share = (at - of(before)) / length;
        let mix = |of: fn(&WheelPoint) -> f64| of(before) + (of(after) - of(before)) * share;
        (length < 3.0 * step).then(|| WheelPoint {
            own: mix(|point| point.own),
            along: mix(|point| point.along),
            distance: mix(|point| point.distance),
            half_angle: mix(|point| point.half_angle),
            radius: mix(|point| point.radius),
        })
    }

    /// `d + 0.73 u`
    fn apart(&self, point: &WheelPoint) -> f64 {
        let mut deflection = 0.0;
        for contact in self.contacts {
            let share = contact.share.to_f64();
            for strip in contact.patch.used() {
                let beside = point.along - (contact.along + strip.y).to_f64();
                let length = strip.half_length.to_f64();
                let square = beside * beside + BESIDE * length * length;
                deflection += share * strip.load().to_f64() / Arithmetic::sqrt(square);
            }
        }
        point.distance + self.compliance * deflection
    }

    /// Notes the ends of the zones of all contacts.
    fn note_ends(&mut self, step: f64) {
        for ([end, square, _], _) in self.outlines.iter().flatten() {
            let point = self.point(|point| point.along, *end, step);
            if let Some(point) = point.filter(|_| *square == 0.0) {
                let _ = self.ends.push([*end, self.apart(&point)]);
            }
        }
    }

    /// `l²` and `p²` outside the zones, at most zero.
    fn beyond_zones(&self, point: &WheelPoint, [modulus, ratio]: [f64; 2]) -> [f64; 2] {
        let mut nearest = [f64::MAX, 0.0];
        for [end, apart] in &self.ends {
            let distance = (point.along - end).abs();
            let [least, _] = nearest;
            if distance < least {
                nearest = [distance, *apart];
            }
        }
        let [distance, apart] = nearest;
        let fades = Float::exp(-Arithmetic::min(distance / END_FADES, 40.0));
        let rest = Arithmetic::max(self.apart(point) - apart * fades, 0.0);
        let square = Arithmetic::max(-ROUNDNESS * point.radius * rest, -SQUARE_FLOOR);
        [square, square * pressure_by_square(modulus, ratio, point.radius)]
    }

    /// `l²` and `p²` at a point.
    fn squares(&self, point: &WheelPoint, [modulus, ratio]: [f64; 2]) -> [f64; 2] {
        let (mut sums, mut rest) = ([0.0; 2], 1.0);
        for (contact, outline) in self.contacts.iter().zip(&self.outlines) {
            if let Some([square, pressure]) = inside(outline, point.along) {
                let share = contact.share.to_f64();
                let [own, other] = sums;
                sums = [own + share * square, other + share * pressure];
                rest -= share;
            }
        }
        let [own, other] = sums;
        if rest > 1e-9 {
            let [square, pressure] = self.beyond_zones(point, [modulus, ratio]);
            sums = [own + rest * square, other + rest * pressure];
        }
        sums
    }
}

/// Writes the fields of a node to a slot that begins so many bytes after that of all fields.
fn write_node<F: Float>(
    scene: &Scene<F>, table: &ContactTable, position: &Position<F>, memory: &Workspace<F>,
    (offset, out): (usize, &mut [u8]),
) -> Record {
    let WheelPair { wheel_radius, shear_modulus, poisson_ratio, .. } = *scene.pair;
    let [modulus, ratio] = [shear_modulus, poisson_ratio].map(F::to_f64);
    let points = points_on_wheel(scene.wheel, wheel_radius, position, memory);
    let compliance = COUNTED * (1.0 - ratio) / (PI * modulus);
    let (contacts, ends) = (memory.found(), Vec::new());
    let mut outlines = Vec::new();
    for contact in contacts {
        let _ = outlines.push(outline(contact));
    }
    let mut around = Surfaces { contacts, outlines, points: &points, compliance, ends };
    let step = scene.wheel.step.to_f64();
    around.note_ends(step);
    let floor_pressure = -SQUARE_FLOOR * pressure_by_square(modulus, ratio, wheel_radius.to_f64());
    let mut nodes: Vec<[f64; 3], MOST_PLACES> = Vec::new();
    let (mut first, mut end) = (usize::MAX, 0);
    let mut largest = [SQUARE_FLOOR, -floor_pressure];
    let mut half_angle = points.first().map_or(0.0, |point| point.half_angle);
    for k in 0..table.counts.places {
        let point = around.point(|point| point.own, table.along(k), step);
        let mut own = [-SQUARE_FLOOR, floor_pressure];
        if let Some(point) = point {
            half_angle = point.half_angle;
            if point.distance < BEYOND {
                own = around.squares(&point, [modulus, ratio]);
            }
        }
        let [square, pressure] = own;
        if square > -SQUARE_FLOOR {
            (first, end) = (first.min(k), k + 1);
            let [length, peak] = largest;
            largest = [Arithmetic::max(length, square), Arithmetic::max(peak, pressure.abs())];
        }
        let _ = nodes.push([square, pressure, half_angle]);
    }
    let first = first.min(end).saturating_sub(1);
    let nodes = nodes.get(first..(end + 1).min(table.counts.places)).unwrap_or(&[]);
    let widest = nodes.iter().fold(1e-9, |widest, [.., own]| Arithmetic::max(widest, own.abs()));
    let [length, peak] = largest;
    let scales = [length / 32767.0, peak / 32767.0, widest / 127.0].map(|scale| scale as f32);
    let per_step = scales.map(|scale| 1.0 / f64::from(scale));
    let nearest = |number: f64| number + if number < 0.0 { -0.5 } else { 0.5 };
    let count = nodes.len();
    for (k, [square, pressure, half_angle]) in nodes.iter().enumerate() {
        let [length, peak, angle] = per_step;
        write_bytes(out, 2 * k, (nearest(square * length) as i16).to_le_bytes());
        write_bytes(out, 2 * (count + k), (nearest(pressure * peak) as i16).to_le_bytes());
        write_bytes(out, 4 * count + k, (nearest(half_angle * angle) as i8).to_le_bytes());
    }
    let (offset, count) = (offset as u32, count as u16);
    Record { offset, first: first as u16, count, scales }
}
