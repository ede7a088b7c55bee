//! Where the cells of the normal problem lie.
//!
//! All zones are laid end to end, and the integral of the [density](super::density) of cells over
//! them is divided into equal parts. A cell is cut where a zone ends. The cells do not depend on
//! where the points of the profile lie.
//!
//! The number of lobes `k` is half the variation of the depth `min(1, d/d₀)` along the zones: each
//! deep zone counts as one, whether it has neighbours or has just parted from them, and one that
//! has just begun hardly counts. With more than two lobes there are more cells,
//!
//! ```text
//! n + (n₁ − n) x²/(x² + 6),   x = max(0, k − 2)
//! ```
//!
//! so that with 16 strips (18 to 28 cells) each of eight lobes has at least three. Of a number that
//! is not whole, half of the rest is in the first cell and half in the last.

use crate::normal::cell::{Cell, Cells};
use crate::normal::density::{MOST_ZONES, Zones};
use crate::number::{Arithmetic, Dual, Float, add};
use heapless::Vec;

/// `κ/w` of half a cell, but for the factor of how it is cut.
const PART_COUPLING: f64 = 0.3;
/// Gap over width of a cell, at which its parts are half apart.
const HALF_APART: f64 = 0.5;
/// Least gap, over half of that width.
const CLOSEST: f64 = 1e-6;
/// Lobes that need no more cells than one does.
const OF_FEW: f64 = 2.0;
/// Square of the number of further lobes with which there are half as many more cells as at most.
const HALF_OF_MORE: f64 = 6.0;
/// Cells that a lobe needs to be resolved.
const OF_LOBE: f64 = 3.0;

/// At most `count` cells, or `most` where there are many lobes, and one more for each zone but the
/// first: the density of the zones decides how wide they are. Returns the integral of the density,
/// and whether there are cells enough for the lobes.
#[inline(never)]
pub(super) fn layout<F: Float, const N: usize>(
    zones: &Zones<F, N>, [count, most]: [usize; 2], cells: &mut Cells<F, N>,
) -> (Dual<F, N>, bool) {
    let list = &mut cells.list;
    list.clear();
    let zero = Dual::zero();
    let (mut total, mut far) = (zero, F::zero());
    zones.stretches(&mut |_, stretch| {
        total += stretch.integral();
        far = far.max(stretch.from.value.abs()).max(stretch.to.value.abs());
    });
    let lobes = zones.lobes();
    let count = cells_for(lobes, [count, most]);
    let inverse = count / total.shift(F::TINY);
    // What is narrower than the rounding of places is left out. A share that is a difference rounds
    // by `least`: that of a zone without a cut is the integral itself.
    let rounding = F::EPSILON.times(64.0);
    let (narrow, least) = (far * rounding, (F::one() + far * inverse.value) * rounding);
    let mut own = Cut { place: zero, at: zero, zone: usize::MAX };
    // where the next stretch begins, in cells
    let mut begin = first_place(count);
    let mut cell = 0_i32;
    let mut add = |from: &Cut<F, N>, to: &Cut<F, N>, cell: i32, exact: Dual<F, N>| {
        let share = to.at - from.at;
        let share = if share.value > least { share } else { exact };
        let width = to.place - from.place;
        if share.value > F::zero() && width.value > narrow {
            let y = (from.place + to.place).times(0.5);
            let _ = list.push(Cell::at_place([y, width, share], cell, from.zone as u32));
        }
    };
    // of a zone that has no cut
    let (mut whole, mut last) = (zero, own);
    zones.stretches(&mut |zone, stretch| {
        if zone != own.zone {
            add(&own, &last, cell, whole);
            own = Cut { place: stretch.from, at: begin, zone };
            whole = zero;
            cell = F::whole(begin.value + least).saturating_add(1);
        }
        let own_share = stretch.integral() * inverse;
        let end = begin + own_share;
        whole += own_share;
        loop {
            let next = Dual::from_base(F::widened(cell as f32));
            if !(next.value < end.value - least) || own.at.value >= next.value {
                break;
            }
            let cut = Cut { place: stretch.place_of((next - begin) / inverse), at: next, zone };
            add(&own, &cut, cell, zero);
            own = cut;
            whole = zero;
            cell = cell.saturating_add(1);
        }
        begin = end;
        last = Cut { place: stretch.to, at: end, zone };
    });
    add(&own, &last, cell, whole);
    (total, lobes.value.times(OF_LOBE) <= count.value)
}

/// Between `count` cells, and `most` for many lobes.
fn cells_for<F: Float, const N: usize>(lobes: Dual<F, N>, cells: [usize; 2]) -> Dual<F, N> {
    let further = lobes.plus(-OF_FEW).max(Dual::zero());
    let [count, most] = cells.map(|count| F::widened(count as f32));
    let more = further.squared() / further.squared().plus(HALF_OF_MORE);
    more.scale(most - count).shift(count)
}

/// Where the first cell begins, in cells: two of them meet in the middle.
fn first_place<F: Float, const N: usize>(count: Dual<F, N>) -> Dual<F, N> {
    let half = count.times(0.5);
    let whole = F::widened(F::whole(half.value) as f32);
    let middle = if whole < half.value { whole + F::one() } else { whole };
    Dual::from_base(middle) - half
}

#[derive(Clone, Copy)]
struct Cut<F, const N: usize> {
    place: Dual<F, N>,
    /// The same in cells.
    at: Dual<F, N>,
    zone: usize,
}

/// Couples the pressures of parts of cells, so that parts vanish and merge without a jump.
///
/// Two parts of one cell, of which all parts have the width `W`, with the free length `g` between
/// them have the nearness `n = (W/2)²/(g² + (W/2)²)`, which a part between them that vanishes does
/// not change. A part counts as much of the others as they are near: they add to its width `w`,
/// to its share `r` of a whole cell, and to the place where it meets the bodies, which is their
/// centre. It is coupled to its neighbours in the zone with `κ = 0.3 w (1 − r)²/r`, and the parts
/// on both sides of a gap `g` are coupled to each other with `0.3 W w₁ w₂/(w₁ + w₂) W/(2 g)`,
/// divided by the part's own width: like springs in series two gaps are as stiff as one of their
/// length.
///
/// A zone that is less than a cell carries little: with its share `r`, its parts are coupled to a
/// pressure of zero with `κ = 0.3 W (1 − r)²/r`. Zones that are near count as one with it: this is
/// the mean over all numbers from 0 to 1 of `κ` with the shares of zones whose nearness, over the
/// free length between, is more than the number.
#[inline(never)]
pub(super) fn couple_parts<F: Float, const N: usize>(cells: &mut Cells<F, N>) {
    let list = &mut cells.list;
    let [total, all] = list
        .iter()
        .fold([Dual::zero(); 2], |[width, share], part| [width + part.width, share + part.share]);
    let half_cell = (total / all.shift(F::TINY)).times(HALF_APART).squared();
    for i in 0..list.len() {
        if let (Some(coupled), Some(own)) = (coupled(list, i, half_cell), list.get_mut(i)) {
            *own = coupled;
        }
    }
}

/// A part of a cell that leans on others; none for a whole cell.
fn coupled<F: Float, const N: usize>(
    known: &[Cell<F, N>], i: usize, half_cell: Dual<F, N>,
) -> Option<Cell<F, N>> {
    let place = known.get(i)?;
    if place.share.value >= F::one() - F::EPSILON.times(256.0) {
        return None;
    }
    let parts = known.iter().filter(|part| part.number == place.number);
    let width = parts.fold(Dual::zero(), |sum, part| sum + part.width);
    let reach = width.times(HALF_APART).squared();
    let [below, above] = [-1, 1].map(|step| Beside::new(known, i, step, reach));
    let mut sums = [place.width, place.share, place.width * place.y];
    add(&mut sums, below.near);
    add(&mut sums, above.near);
    let [near, share, moment] = sums;
    // κ over the part's own width
    let (cell, per_width) = ((near / share).times(PART_COUPLING), place.width.inverse());
    let rest = (Dual::one() - share).max(Dual::zero());
    let mut coupled = Cell { at: moment / near, over: near, ..*place };
    coupled.alone = cell * softness_of_zone(known, i, half_cell);
    let by_zone = cell * rest.squared() / share * near * per_width;
    let sides = [(&below, &above, i.checked_sub(1)), (&above, &below, Some(i + 1))];
    for ((side, other, next), coupling) in sides.into_iter().zip(&mut coupled.coupling) {
        let Some(next) = next.and_then(|next| known.get(next)) else { continue };
        if next.zone == place.zone {
            *coupling = by_zone;
        } else if next.number == place.number {
            let inner = place.width + other.outer;
            let both = inner * side.outer / (inner + side.outer);
            let half = width.times(0.5);
            let closeness = half / (side.gap + half.times(CLOSEST));
            *coupling = width.times(PART_COUPLING) * both * closeness * per_width;
        }
    }
    Some(coupled)
}

/// Free length between two parts \[m\].
fn gap<F: Float, const N: usize>(one: &Cell<F, N>, other: &Cell<F, N>) -> Dual<F, N> {
    ((one.y - other.y).abs() - (one.width + other.width).times(0.5)).max(Dual::zero())
}

/// `(1 − r)²/r` of a zone's share `r` of a whole cell; 0 for a whole cell or more.
fn softness<F: Float, const N: usize>(share: Dual<F, N>) -> Dual<F, N> {
    let rest = (Dual::one() - share).max(Dual::zero());
    rest.squared() / share
}

/// The mean of `(1 − r)²/r` over all numbers from 0 to 1, with the share `r` of a place's zone and
/// of those that are nearer than the number.
fn softness_of_zone<F: Float, const N: usize>(
    known: &[Cell<F, N>], from: usize, half_cell: Dual<F, N>,
) -> Dual<F, N> {
    let Some((before, [place, after @ ..])) = known.split_at_checked(from) else {
        return Dual::zero();
    };
    let mut share = place.share;
    // nearness and share of other zones on a side, the nearest first
    let mut others = |parts: &mut dyn Iterator<Item = &Cell<F, N>>| {
        let mut others = Vec::<[Dual<F, N>; 2], MOST_ZONES>::new();
        let (mut free, mut last) = (Dual::zero(), place);
        for part in parts {
            if part.zone != last.zone {
                free += gap(part, last);
                let near = half_cell / (half_cell + free.squared());
                let _ = others.push([near, part.share]);
            } else if let Some([_, other]) = others.last_mut() {
                *other += part.share;
            } else {
                share += part.share;
            }
            last = part;
        }
        others
    };
    let above = others(&mut after.iter());
    let below = others(&mut before.iter().rev());
    let [mut above, mut below] = [above.iter().peekable(), below.iter().peekable()];
    let (mut sum, mut reached) = (Dual::zero(), Dual::one());
    loop {
        let next = match (above.peek(), below.peek()) {
            (Some([one, _]), Some([two, _])) if one.value < two.value => below.next(),
            (None, _) => below.next(),
            _ => above.next(),
        };
        let Some([near, other]) = next else { break };
        sum += (reached - *near) * softness(share);
        share += *other;
        reached = *near;
    }
    sum + reached * softness(share)
}

/// The other parts of a cell on one side of a part.
struct Beside<F, const N: usize> {
    /// Width, share, and width times place, each times the nearness.
    near: [Dual<F, N>; 3],
    /// Gap before the next part \[m\].
    gap: Dual<F, N>,
    /// Width of these parts.
    outer: Dual<F, N>,
}

impl<F: Float, const N: usize> Beside<F, N> {
    fn new(known: &[Cell<F, N>], from: usize, step: isize, reach: Dual<F, N>) -> Self {
        let zero = Dual::zero();
        let mut beside = Self { near: [zero; 3], gap: zero, outer: zero };
        let (mut free, mut k) = (zero, from);
        while let (Some(own), Some(next)) =
            (known.get(k), k.checked_add_signed(step).and_then(|next| known.get(next)))
        {
            if next.number != own.number || next.zone == own.zone {
                break;
            }
            let gap = gap(own, next);
            if k == from {
                beside.gap = gap;
            }
            free += gap;
            let nearness = reach / (free.squared() + reach);
            beside.outer += next.width;
            let other = [next.width, next.share, next.width * next.y];
            add(&mut beside.near, other.map(|term| term * nearness));
            k = k.saturating_add_signed(step);
        }
        beside
    }
}
