//! Which zones of overlap are one contact.
//!
//! Zones less than 5 mm apart are one contact, and zones more than 7 mm apart are not. Between
//! these distances both hold, each by a share. Everything depends on the **free length** between
//! zones: the length along the rail over which the surfaces do not overlap. It does not change when
//! a zone between two others begins with no depth, nor when a zone is divided by a local maximum
//! that rises out of the overlap.
//!
//! For a length `T` between 5 and 7 mm and a depth `ℓ`, a zone is *strong* where it is deeper than
//! `ℓ`.
//!
//! * Two successive strong zones, with all zones between them, are one group where their free
//!   length is less than `T`.
//! * Otherwise a weak zone between them belongs to the strong zone that is nearer than `T/2`, if
//!   one is. A weak zone beyond the last strong zone belongs to it where it is nearer than `T`. The
//!   others are one group.
//!
//! So `T` and `ℓ` part the zones into groups. The share of a group is the probability of its
//! partitions, where `ℓ` is spread evenly between two parts of the largest depth, and `T` such that
//! it exceeds a free length `f` with the probability `w(f)`, which falls smoothly from 1 at 5 mm to
//! 0 at 7 mm. Thus no share jumps when a zone appears, vanishes, is divided or merges.
//!
//! **Room.** Where more than four groups would be left, `T` begins at the length at which four are
//! left. Where all partitions together have more groups than there is room for, the least probable
//! ones are left out, and the others lose the probability `p₀` of the most probable one of these:
//! `(p − p₀)/Σ(p − p₀)`. Either is a continuous change, but where a zone begins beside so many
//! others.

use crate::normal::crossings::Overlap;
use crate::normal::smooth::SmoothedProfile;
use crate::number::{Dual, Float};
use crate::numerics::{ramp, smooth_step};
use crate::wheel_rail::KSTRIP_CONTACTS_CAPACITY;
use core::mem;
use heapless::Vec;

/// Least length `T`, free length up to which zones are one contact \[m\].
const ONE_CONTACT: f64 = 5e-3;
/// Range of `T` \[m\].
pub(super) const BAND: f64 = 2e-3;
/// Range of the depth below which a zone is weak, over that of the deepest zone.
const WEAK: [f64; 2] = [0.1, 0.2];
/// Largest number of zones that are told apart.
pub(super) const ZONES: usize = 16;
/// Largest number of groups of a partition.
const APART: usize = 4;
/// Largest number of partitions that are told apart.
const PARTITIONS: usize = 32;

/// Zones of overlap in ascending order.
pub(crate) struct Overlaps<F> {
    list: Vec<Overlap<F>, ZONES>,
}

/// Successive zones that are one contact, by a share.
pub(crate) struct Group<F> {
    /// From the first to the last of its zones, with the largest depth.
    pub whole: Overlap<F>,
    /// More than 0, at most 1.
    pub share: F,
    /// Numbers of its first and its last zone.
    pub zones: [usize; 2],
}

pub(crate) type Groups<F> = Vec<Group<F>, KSTRIP_CONTACTS_CAPACITY>;

/// A zone where zones are grouped: its place, counted in free length, and its depth.
#[derive(Clone, Copy)]
struct GroupedZone<F> {
    free: F,
    depth: F,
}

/// A way of parting the zones into groups.
struct Partition<F> {
    /// Bit `k`: zones `k` and `k + 1` are in one group.
    joined: u32,
    probability: F,
}

impl<F: Float> Partition<F> {
    /// First and last zone of each group.
    fn groups(&self, zones: usize) -> impl Iterator<Item = [usize; 2]> {
        let mut first = 0;
        (0..zones).filter(move |k| k + 1 == zones || self.joined >> k & 1 == 0).map(move |last| {
            let group = [first, last];
            first = last + 1;
            group
        })
    }
}

impl<F: Float> Overlaps<F> {
    pub const fn new() -> Self {
        Self { list: Vec::new() }
    }

    /// The zones of a curve, made of the numbers that `number` makes.
    #[inline(never)]
    pub fn of_curve<const N: usize>(
        curve: &SmoothedProfile<F, N>, number: impl Fn(Dual<F, N>) -> F,
    ) -> Self {
        let mut zones = Self::new();
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
    /// on, in ascending order of their last. Returns whether there was room for all of them.
    #[inline(never)]
    pub fn group(&self, groups: &mut Groups<F>) -> bool {
        let (partitions, mut all) = self.partitions();
        let mut fitting = 0;
        for partition in &partitions {
            let is_new = |zones: &[usize; 2]| groups.iter().all(|group| group.zones != *zones);
            let needed = partition.groups(self.list.len()).filter(is_new).count();
            if groups.len() + needed > groups.capacity() {
                all = false;
                break;
            }
            for zones in partition.groups(self.list.len()) {
                self.add(groups, zones);
            }
            fitting += 1;
        }
        let left_out = partitions.get(fitting).map_or(F::zero(), |first| first.probability);
        // of several that are equally probable none is left out alone
        let above = |partition: &Partition<F>| partition.probability - left_out + F::TINY;
        let fitting = partitions.get(..fitting).unwrap_or(&[]);
        let sum = fitting.iter().fold(F::zero(), |sum, partition| sum + above(partition));
        for partition in fitting {
            for zones in partition.groups(self.list.len()) {
                if let Some(group) = groups.iter_mut().find(|group| group.zones == zones) {
                    group.share += above(partition) / sum;
                }
            }
        }
        all
    }

    /// The partitions in descending order of their probability, and whether `T` begins at 5 mm.
    fn partitions(&self) -> (Vec<Partition<F>, PARTITIONS>, bool) {
        let (mut partitions, mut usual) = (Vec::new(), true);
        let mut places: Vec<GroupedZone<F>, ZONES> = Vec::new();
        let (mut at, mut deepest) = (F::zero(), F::zero());
        let mut last: Option<&Overlap<F>> = None;
        for zone in &self.list {
            at += last.map_or(F::zero(), |last| free(last, zone));
            deepest = deepest.max(zone.depth);
            last = Some(zone);
            let _ = places.push(GroupedZone { free: at, depth: zone.depth });
        }
        // between two successive bounds of ℓ, and of T, the partition is the same
        let [mut level, weak] = WEAK.map(|weak| deepest.times(weak));
        let range = weak - level;
        while level < weak {
            let depths = places.iter().map(|place| place.depth).filter(|depth| *depth > level);
            let next = depths.fold(weak, F::min);
            let strong = Strong { places: &places, level: next };
            let shortest = strong.shortest();
            usual &= shortest <= F::of(ONE_CONTACT);
            let longest = shortest.plus(BAND);
            let exceeds = |free: F| F::one() - smooth_step(ramp(free - shortest, [0.0, BAND]));
            let mut length = shortest;
            while length < longest {
                let longer = strong.next_bound(length, longest);
                let joined = strong.joined(length);
                let probability = (exceeds(length) - exceeds(longer)) * ((next - level) / range);
                add_partition(&mut partitions, Partition { joined, probability });
                length = longer;
            }
            level = next;
        }
        (sorted(partitions), usual)
    }

    /// Adds a group without share, if it is not there.
    fn add(&self, groups: &mut Groups<F>, zones: [usize; 2]) {
        if groups.iter().any(|group| group.zones == zones) {
            return;
        }
        let own = self.list.get(zones[0]..=zones[1]).unwrap_or(&[]);
        let Some(whole) = own.iter().copied().reduce(|one, next| joined(&one, &next)) else {
            return;
        };
        // core's sorting can panic; each group goes to its place instead
        let mut last = Group { whole, share: F::zero(), zones };
        for group in groups.iter_mut() {
            if last.zones < group.zones {
                mem::swap(&mut last, group);
            }
        }
        let _ = groups.push(last);
    }
}

/// Adds a partition, or its probability to that of the same one.
fn add_partition<F: Float>(list: &mut Vec<Partition<F>, PARTITIONS>, new: Partition<F>) {
    match list.iter_mut().find(|own| own.joined == new.joined) {
        Some(own) => own.probability += new.probability,
        None => drop(list.push(new)),
    }
}

/// Partitions in descending order of their probability.
fn sorted<F: Float>(list: Vec<Partition<F>, PARTITIONS>) -> Vec<Partition<F>, PARTITIONS> {
    let mut sorted: Vec<Partition<F>, PARTITIONS> = Vec::new();
    for mut last in list {
        for own in &mut sorted {
            if last.probability > own.probability {
                mem::swap(&mut last, own);
            }
        }
        let _ = sorted.push(last);
    }
    sorted
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

    /// The next bound of `T` after a length, at most the last.
    fn next_bound(&self, length: F, last: F) -> F {
        self.bounds().filter(|bound| *bound > length).fold(last, F::min)
    }

    /// The partition for a length `T` or a little more: see [`Partition::joined`].
    fn joined(&self, length: F) -> u32 {
        let next = 0..self.places.len().saturating_sub(1);
        next.filter(|k| self.are_joined(*k, length)).fold(0, |joined, k| joined | 1 << k)
    }

    /// The least length `T`: it leaves no more than four groups.
    fn shortest(&self) -> F {
        let mut length = F::of(ONE_CONTACT);
        while self.places.len().saturating_sub(self.joined(length).count_ones() as usize) > APART {
            let next = self.next_bound(length, F::LARGEST);
            if next == F::LARGEST {
                break;
            }
            length = next;
        }
        length
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
