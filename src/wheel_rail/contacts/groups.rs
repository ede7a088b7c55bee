//! Which zones of overlap are one contact.
//!
//! Zones less than 4 mm apart are one contact, as in CONTACT, and zones more than 8 mm apart are
//! not. Between these distances both hold, each by a share. Everything depends on the **free
//! length** between zones: the length along the rail over which the surfaces do not overlap. It
//! does not change when a zone between two others begins with no depth, nor when a zone is divided
//! by a crest that rises out of the overlap.
//!
//! For a length `T` between 4 and 8 mm and a depth `ℓ`, a zone is *strong* where it is deeper than
//! `ℓ`.
//!
//! * Two successive strong zones, with all zones between them, are one group where their free
//!   length is less than `T`.
//! * Otherwise a weak zone between them belongs to the strong zone that is nearer than `T/2`, if
//!   one is. A weak zone beyond the last strong zone belongs to it where it is nearer than `T`. The
//!   others are one group.
//!
//! The share of a group is the probability that it exists, where `ℓ` is spread evenly from 0 to a
//! part of the largest depth, and `T` such that it exceeds a free length `f` with the probability
//! `w(f)`, which falls smoothly from 1 at 4 mm to 0 at 8 mm. Thus no share jumps when a zone
//! appears, vanishes, is divided or merges.

use crate::normal::crossings::Overlap;
use crate::normal::smooth::SmoothedProfile;
use crate::number::{Dual, Float};
use crate::numerics::{ramp, smooth_step};
use crate::status::Error;
use core::mem;
use heapless::Vec;

/// Free length up to which zones are one contact, and from which they are independent \[m\].
pub(super) const ONE_CONTACT: f64 = 4e-3;
const APART: f64 = 8e-3;
/// Largest depth of a weak zone over that of the deepest zone.
const WEAK: f64 = 0.3;
/// Largest number of zones that are told apart.
pub(super) const ZONES: usize = 16;

/// Probability that `T` exceeds a free length: 1 up to 4 mm, 0 from 8 mm on, smooth between.
fn nearness<F: Float>(free: F) -> F {
    F::one() - smooth_step(ramp(free, [ONE_CONTACT, APART]))
}

/// Largest number of groups.
pub(super) const GROUPS: usize = 2 * ZONES;

/// Zones of overlap in ascending order.
pub(super) struct Overlaps<F> {
    list: Vec<Overlap<F>, ZONES>,
}

/// Successive zones that are one contact, by a share.
pub(super) struct Group<F> {
    /// From the first to the last of its zones, with the largest depth.
    pub whole: Overlap<F>,
    /// More than 0, at most 1.
    pub share: F,
    /// Numbers of its first and its last zone.
    pub zones: [usize; 2],
}

/// Groups of zones.
pub(super) type Groups<F> = Vec<Group<F>, GROUPS>;

/// A zone where zones are grouped: its place, counted in free length, and whether it is strong.
#[derive(Clone, Copy)]
struct GroupedZone<F> {
    free: F,
    depth: F,
}

impl<F: Float> Overlaps<F> {
    /// The zones of a curve, made of the numbers that `number` makes.
    #[inline(never)]
    pub fn of_curve<const N: usize>(
        curve: &SmoothedProfile<F, N>, number: impl Fn(Dual<F, N>) -> F,
    ) -> Self {
        let mut zones = Self { list: Vec::new() };
        curve.overlaps(number, |zone| zones.push(zone));
        zones
    }

    /// Adds the next zone; if there is no room, it becomes part of the last.
    pub fn push(&mut self, zone: Overlap<F>) {
        if let Err(zone) = self.list.push(zone)
            && let Some(last) = self.list.last_mut()
        {
            *last = joined(last, &zone);
        }
    }

    /// Adds the groups to none, in ascending order of their first zone; of several from one zone
    /// on, in ascending order of their last.
    ///
    /// # Errors
    /// [`Error::PatchSize`] for more than there is room for.
    #[inline(never)]
    pub fn group(&self, groups: &mut Groups<F>) -> Result<(), Error> {
        let mut places: Vec<GroupedZone<F>, ZONES> = Vec::new();
        let (mut at, mut deepest) = (F::zero(), F::zero());
        let mut last: Option<&Overlap<F>> = None;
        for zone in &self.list {
            at += last.map_or(F::zero(), |last| free(last, zone));
            deepest = deepest.max(zone.depth);
            last = Some(zone);
            let _ = places.push(GroupedZone { free: at, depth: zone.depth });
        }
        // between two successive bounds of ℓ, and of T, the groups are the same
        let weak = deepest.times(WEAK);
        let mut level = F::zero();
        while level < weak {
            let depths = places.iter().map(|place| place.depth).filter(|depth| *depth > level);
            let next = depths.fold(weak, F::min);
            let strong = Strong { places: &places, level: next };
            let mut length = F::of(ONE_CONTACT);
            while length < F::of(APART) {
                let bounds = strong.bounds().filter(|bound| *bound > length);
                let longer = bounds.fold(F::of(APART), F::min);
                let share = (nearness(length) - nearness(longer)) * ((next - level) / weak);
                let mut first = 0;
                for k in 0..places.len() {
                    if k + 1 == places.len() || !strong.are_joined(k, length) {
                        self.add(groups, [first, k], share)?;
                        first = k + 1;
                    }
                }
                length = longer;
            }
            level = next;
        }
        Ok(())
    }

    fn add(&self, groups: &mut Groups<F>, zones: [usize; 2], share: F) -> Result<(), Error> {
        if let Some(group) = groups.iter_mut().find(|group| group.zones == zones) {
            group.share += share;
            return Ok(());
        }
        let own = self.list.get(zones[0]..=zones[1]).unwrap_or(&[]);
        let Some(whole) = own.iter().copied().reduce(|one, next| joined(&one, &next)) else {
            return Ok(());
        };
        // core's sorting can panic; each group goes to its place instead
        let mut last = Group { whole, share, zones };
        for group in groups.iter_mut() {
            if last.zones < group.zones {
                mem::swap(&mut last, group);
            }
        }
        groups.push(last).map_err(|_| Error::PatchSize)
    }
}

fn free<F: Float>(zone: &Overlap<F>, next: &Overlap<F>) -> F {
    let ([_, end], [begin, _]) = (zone.ends, next.ends);
    (begin - end).max(F::zero())
}

fn joined<F: Float>(zone: &Overlap<F>, next: &Overlap<F>) -> Overlap<F> {
    let ([begin, _], [_, end]) = (zone.ends, next.ends);
    Overlap { ends: [begin, end], depth: zone.depth.max(next.depth) }
}

/// Zones, of which those that are at least as deep as a level are strong.
struct Strong<'a, F> {
    places: &'a [GroupedZone<F>],
    level: F,
}

impl<F: Float> Strong<'_, F> {
    /// The place in free length of the nearest strong zone among some.
    fn nearest<'b>(&self, mut among: impl Iterator<Item = &'b GroupedZone<F>>) -> Option<F>
    where
        F: 'b,
    {
        among.find(|place| place.depth >= self.level).map(|place| place.free)
    }

    /// Free lengths from the strong zones before and after a zone, itself included.
    fn distances(&self, k: usize) -> [Option<F>; 2] {
        let Some(own) = self.places.get(k) else { return [None; 2] };
        let before = self.nearest(self.places.get(..=k).unwrap_or(&[]).iter().rev());
        let after = self.nearest(self.places.get(k..).unwrap_or(&[]).iter());
        [before.map(|free| own.free - free), after.map(|free| free - own.free)]
    }

    /// `T` over the distance up to which a zone belongs to a strong one.
    fn factor(&self, k: usize) -> F {
        let [before, after] = self.distances(k);
        if before.is_some() && after.is_some() { F::constant(2.0) } else { F::one() }
    }

    /// Values of `T` beyond which the groups are others.
    fn bounds(&self) -> impl Iterator<Item = F> {
        (0..self.places.len()).flat_map(|k| {
            let [before, _] = self.distances(k);
            let [_, after] = self.distances(k + 1);
            let [own, next] = [k, k + 1].map(|k| self.places.get(k).map(|place| place.free));
            let between = own.zip(next).map(|(own, next)| next - own);
            let span = before.zip(after).zip(between).map(|((a, b), free)| a + free + b);
            let [near, other] = self.distances(k).map(|d| d.map(|d| d * self.factor(k)));
            [span, near, other].into_iter().flatten()
        })
    }

    /// Whether a zone and the next are in one group, for a length `T` or a little more.
    fn are_joined(&self, k: usize, length: F) -> bool {
        let ([before, _], [_, after]) = (self.distances(k), self.distances(k + 1));
        let (Some(own), Some(next)) = (self.places.get(k), self.places.get(k + 1)) else {
            return false;
        };
        let between = next.free - own.free;
        if let (Some(before), Some(after)) = (before, after)
            && before + between + after <= length
        {
            return true;
        }
        let is_near =
            |k: usize, distance: Option<F>| distance.is_some_and(|d| d * self.factor(k) <= length);
        let weak = [own, next].map(|place| !(place.depth >= self.level));
        // to the strong zone before, to that after, or to none
        let [[before, after], [next_before, next_after]] =
            [k, k + 1].map(|k| self.distances(k).map(|distance| is_near(k, distance)));
        let own = [before, weak[0] && after];
        let next = [weak[1] && next_before, next_after];
        own == next
    }
}
