//! Where the cells of the normal problem lie.
//!
//! All zones are laid end to end, and the integral of the [density](super::density) of cells over
//! them is divided into equal parts. A cell is cut where a zone ends. The cells do not depend on
//! where the points of the profile lie.

use crate::normal::density::{ZONES, Zones};
use crate::normal::profile::WithSlope;
use crate::number::{Arithmetic, Float};
use heapless::Vec;

/// Largest number of cells of the normal problem. On a microcontroller there are fewer, so that
/// patches asked for with 32 and 64 strips have fewer.
pub const CELLS: usize = if cfg!(target_os = "none") { 20 } else { 48 };
/// The place of a cell, or of a part of one, on the line `x = 0`.
#[derive(Clone, Copy, Debug)]
pub(super) struct CellPlace<F> {
    /// Its middle \[m\].
    pub y: WithSlope<F>,
    /// Its width \[m\].
    pub width: WithSlope<F>,
    /// Where the conditions of contact hold \[m\]: at the middle; of two parts of one cell with
    /// hardly a gap between them, at the middle of both.
    pub at: WithSlope<F>,
    /// How strongly the pressure is coupled to that of the place before and to that of the place
    /// after, `κ` \[m\].
    pub coupling: [WithSlope<F>; 2],
    /// Share of a whole cell.
    share: WithSlope<F>,
    /// Number of the cell that it is a part of.
    cell: i32,
    /// Number of its zone.
    zone: usize,
}

/// `κ/w` of half a cell, but for the factor of how it is cut.
const LEANING: f64 = 0.3;
/// Gap over width of a cell, at which its parts are half apart.
const NEAR: f64 = 0.5;

pub(super) type CellPlaces<F> = Vec<CellPlace<F>, CELLS>;

/// At most `count` cells, and one more for each zone but the first: the density of the zones
/// decides how wide they are. (The cells are written where they stay: a copy would take room on the
/// stack.) Returns the integral of the density.
#[inline(never)]
pub(super) fn layout<F: Float>(
    zones: &Zones<F>,
    count: usize,
    places: &mut CellPlaces<F>,
) -> WithSlope<F> {
    places.clear();
    let count = F::widened(count.min(CELLS - ZONES) as f32);
    let (mut total, mut far) = (WithSlope::zero(), F::zero());
    zones.stretches(&mut |_, stretch| {
        total += stretch.total();
        far = far.max(stretch.from.value.abs()).max(stretch.to.value.abs());
    });
    let inverse = WithSlope::from_base(count) / total.shift(F::TINY);
    // what is narrower than rounding, of lengths or of places, is left out
    let least = (F::one() + far * inverse.value) * F::EPSILON.times(64.0);
    let zero = WithSlope::zero();
    let mut own = Cut { place: zero, at: zero, zone: usize::MAX };
    // where the next stretch begins, in cells
    let mut begin = zero;
    let mut cell = 0_i32;
    let mut add = |from: &Cut<F>, to: &Cut<F>, cell: i32| {
        let share = to.at - from.at;
        if share.value > least {
            let y = (from.place + to.place).times(0.5);
            let (width, coupling) = (to.place - from.place, [zero; 2]);
            let _ =
                places.push(CellPlace { y, width, at: y, coupling, share, cell, zone: from.zone });
        }
    };
    let mut last = own;
    zones.stretches(&mut |zone, stretch| {
        if zone != own.zone {
            add(&own, &last, cell);
            own = Cut { place: stretch.from, at: begin, zone };
            cell = F::whole(begin.value + least).saturating_add(1);
        }
        let end = begin + stretch.total() * inverse;
        loop {
            let next = WithSlope::from_base(F::widened(cell as f32));
            if !(next.value < end.value - least) || own.at.value >= next.value {
                break;
            }
            let cut = Cut { place: stretch.place((next - begin) / inverse), at: next, zone };
            add(&own, &cut, cell);
            own = cut;
            cell = cell.saturating_add(1);
        }
        begin = end;
        last = Cut { place: stretch.to, at: end, zone };
    });
    add(&own, &last, cell);
    total
}

/// Where cells are cut.
#[derive(Clone, Copy)]
struct Cut<F> {
    place: WithSlope<F>,
    /// The same in cells.
    at: WithSlope<F>,
    zone: usize,
}

/// Couples the pressures of parts of cells, so that parts vanish and merge without a jump. A part
/// `r` of a cell is coupled to its neighbour in the zone with `κ = 0.3 w (1 − r)²/r`. Two parts of
/// one cell with a gap `g` between them, `φ = g²/(g² + w²/4)`, are coupled to each other with
/// `0.3 w (1 − φ)/φ`, to their zones less by the factor `φ`, and meet the bodies where both
/// together would.
#[inline(never)]
pub(super) fn lean<F: Float>(places: &mut CellPlaces<F>) {
    let (zero, one) = (WithSlope::zero(), WithSlope::one());
    let apart = |place: &CellPlace<F>, next: &CellPlace<F>| {
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
            beside.iter().zip(fades).zip(others).zip(&mut place.coupling)
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
