//! Where the cells of the normal problem lie.
//!
//! All zones are laid end to end and divided into cells of one width. A cell is cut where a zone ends. A zone that appears has few cells
//! at first and moves those of the other zones slowly. The cells do not depend on where the points of the profile lie.

use crate::number::{Arithmetic, Float};
use crate::patch::normal::CELLS;
use crate::patch::section::Moving;
use crate::patch::smooth::{ZONES, Zones};
use heapless::Vec;

/// The place of a cell, or of a part of one, on the line `x = 0`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<F> {
    /// Its middle \[m\].
    pub y: Moving<F>,
    /// Its width \[m\].
    pub width: Moving<F>,
    /// Where the conditions of contact hold \[m\]: at the middle; of two parts of one cell with hardly a gap between them, at the middle
    /// of both.
    pub at: Moving<F>,
    /// How strongly the pressure is coupled to that of the place before and to that of the place after, `κ` \[m\].
    pub leans: [Moving<F>; 2],
    /// Share of a whole cell.
    share: Moving<F>,
    /// Number of the cell that it is a part of.
    cell: i32,
    /// Number of its zone.
    zone: usize,
}

/// `κ/w` of half a cell, but for the factor of how it is cut.
const LEANING: f64 = 0.3;
/// Gap over width of a cell, at which its parts are half apart.
const NEAR: f64 = 0.5;

pub(super) type Places<F> = Vec<Place<F>, CELLS>;

/// Widths of all zones together; a zone that has just appeared counts little.
pub(super) fn width<F: Float>(zones: &Zones<F>) -> Moving<F> {
    zones.iter().fold(Moving::zero(), |sum, zone| sum + zone.width() * zone.density)
}

/// At most `count` cells, and one more for each zone but the first. A zone that has just appeared has wider cells, so that its number of
/// cells grows slowly from zero. (The cells are written where they stay: a copy would take room on the stack.)
pub(super) fn lattice<F: Float>(zones: &Zones<F>, count: usize, places: &mut Places<F>) {
    places.clear();
    let count = F::widened(count.min(CELLS - ZONES) as f32);
    let inverse = Moving::from_base(count) / width(zones);
    // what is narrower than rounding, of lengths or of places, is left out
    let far = zones
        .iter()
        .fold(F::zero(), |far, zone| far.max(zone.from.value.abs()).max(zone.to.value.abs()));
    let least = (F::one() + far * inverse.value) * F::EPSILON.times(64.0);
    let zero = Moving::zero();
    // the place of a zone's beginning, in cells
    let mut begin = zero;
    for (zone, own) in zones.iter().enumerate() {
        let density = own.density * inverse;
        let end = begin + own.width() * density;
        let each = density.shift(F::TINY).inverse();
        let (mut at, mut cell) = (begin, (begin.value + least).whole());
        while at.value < end.value - least {
            cell = cell.saturating_add(1);
            let next = Moving::from_base(F::widened(cell as f32));
            let next = if next.value < end.value - least { next } else { end };
            let share = next - at;
            if share.value > least {
                let y = own.from + ((at + next).times(0.5) - begin) * each;
                let leans = [zero; 2];
                let place = Place { y, width: share * each, at: y, leans, share, cell, zone };
                if places.push(place).is_err() {
                    return;
                }
            }
            at = next;
        }
        begin = end;
    }
}

/// Couples the pressures of parts of cells, so that parts vanish and merge without a jump. A part `r` of a cell is coupled to its
/// neighbour in the zone with `κ = 0.3 w (1 − r)²/r`. Two parts of one cell with a gap `g` between them, `φ = g²/(g² + w²/4)`, are
/// coupled to each other with `0.3 w (1 − φ)/φ`, to their zones less by the factor `φ`, and meet the bodies where both together would.
#[inline(never)]
pub(super) fn lean<F: Float>(places: &mut Places<F>) {
    let (zero, one) = (Moving::zero(), Moving::one());
    let apart = |place: &Place<F>, next: &Place<F>| {
        if place.zone == next.zone || place.cell != next.cell {
            return one;
        }
        let gap = next.y - place.y - (place.width + next.width).times(0.5);
        let square = gap.squared();
        let each = place.width + next.width;
        square / (square + each.squared().times(NEAR * NEAR))
    };
    let known = places.clone();
    for (i, place) in places.iter_mut().enumerate() {
        let own = *place;
        let beside = [i.checked_sub(1).and_then(|k| known.get(k)), known.get(i + 1)];
        let [before, after] = beside;
        let fades = [before.map_or(one, |p| apart(p, &own)), after.map_or(one, |p| apart(&own, p))];
        let rest = one - own.share;
        let unit = (own.width / own.share).times(LEANING);
        let by_zone = unit * (rest.squared() / own.share);
        let others = fades.iter().rev();
        for (((other, fade), across), lean) in
            beside.iter().zip(fades).zip(others).zip(&mut place.leans)
        {
            let Some(other) = other else { continue };
            if other.zone == own.zone {
                // (a part at the other end of its zone, or a whole cell, which is not coupled)
                *lean = by_zone * *across;
            } else if other.cell == own.cell {
                *lean = unit * (one - fade) / fade.shift(F::EPSILON.sqrt().times(100.0));
                let (half, outer) = (own.width.times(0.5), other.width.times(0.5));
                let middle = if other.y.value > own.y.value {
                    (own.y - half + other.y + outer).times(0.5)
                } else {
                    (own.y + half + other.y - outer).times(0.5)
                };
                place.at += (one - fade) * (middle - own.y);
            } else {
                *lean = zero;
            }
        }
    }
}
