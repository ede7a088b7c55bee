//! Points of a file the right way round: toward larger y, z down, the flange or the gauge side at
//! small y, and y of a wheel from its running circle.

use super::header::Kind;
use super::notes::*;
use super::shape::{Evidence, Shape, width_of};
use super::{Format, ProfileFile};
use crate::number::Float;

/// Strength of evidence, 0 to 1, below which it is weak, and from which it overrules the convention
/// of a format.
const WEAK_EVIDENCE: f64 = 0.2;
const DECISIVE: f64 = 0.6;
const CLEAR: f64 = 1.0 - 1e-6;
/// From the flange back of a wheel to its running circle \[m\].
const FLANGE_BACK: f64 = 0.070;
/// Tips of flanges at smaller y belong to profiles from the running circle, and at these y to those
/// from the flange back \[m\].
const FLANGE_TIP: f64 = -0.020;
const TIP_FROM_BACK: f64 = 0.035;
/// Least width and height of the profile of a wheel with a flange \[m\].
const WHEEL: [f64; 2] = [0.08, 0.015];

impl<F: Float> ProfileFile<'_, F> {
    /// Turns the points, and returns the notes.
    pub(super) fn orient(&self, y: &mut [F], z: &mut [F]) -> u32 {
        let found = Shape::of_points(y, z);
        let mut notes = if found.is_none() { KSTRIP_NOTE_DOUBT_POINTS } else { 0 };
        let shape = found.unwrap_or_default();
        let (kind, mut has_convention) = self.kind(&shape, &mut notes);
        let is_upward = is_upward(kind, has_convention, &shape, &mut notes);
        if is_upward {
            z.iter_mut().for_each(|z| *z = -*z);
            notes |= KSTRIP_NOTE_Z_TURNED;
            // A file against its format in one direction may be so in the other.
            has_convention = false;
        }
        let is_mirrored = is_mirrored(kind, has_convention, is_upward, &shape, &mut notes);
        if is_mirrored {
            y.iter_mut().for_each(|y| *y = -*y);
            notes |= KSTRIP_NOTE_Y_MIRRORED;
        }
        let runs_down = y.first().zip(y.last()).is_some_and(|(first, last)| first > last);
        if runs_down {
            y.reverse();
            z.reverse();
        }
        if runs_down != is_mirrored {
            notes |= KSTRIP_NOTE_REVERSED;
        }
        if kind == Kind::Wheel {
            notes |= KSTRIP_NOTE_WHEEL | self.move_to_running_circle(y, z);
        }
        notes
    }

    /// Wheel or rail, and whether the convention of the format holds for it.
    fn kind(&self, shape: &Shape<F>, notes: &mut u32) -> (Kind, bool) {
        let has_convention = self.format == Format::Simpack;
        match (self.asked, self.header.kind) {
            (Some(asked), Some(said)) if asked != said => {
                *notes |= KSTRIP_NOTE_DOUBT_KIND;
                (asked, false)
            }
            (Some(kind), _) | (None, Some(kind)) => (kind, has_convention),
            (None, None) => {
                if !shape.is_wheel.is_at_least(WEAK_EVIDENCE) {
                    *notes |= KSTRIP_NOTE_DOUBT_KIND;
                }
                let is_wheel = shape.is_wheel.value > F::zero();
                (if is_wheel { Kind::Wheel } else { Kind::Rail }, has_convention)
            }
        }
    }

    /// Moves a wheel from its flange back to its running circle.
    fn move_to_running_circle(&self, y: &mut [F], z: &mut [F]) -> u32 {
        let points = || y.iter().copied().zip(z.iter().copied());
        let Some((tip, depth)) = points().reduce(|a, b| if b.1 > a.1 { b } else { a }) else {
            return 0;
        };
        let [width, height] = [&*y, &*z].map(width_of);
        let [least_width, least_height] = WHEEL.map(F::of);
        if width < least_width || height < least_height || tip <= F::of(FLANGE_TIP) {
            return 0;
        }
        if self.format != Format::MiniProf
            || !self.header.is_from_flange_back
            || tip <= F::zero()
            || tip >= F::of(TIP_FROM_BACK)
        {
            return KSTRIP_NOTE_DOUBT_ORIGIN;
        }
        // The height of the tread at the running circle, or at its end
        let circle = F::of(FLANGE_BACK);
        let tread = || points().skip_while(|point| point.1 < depth);
        let is_there = |(a, b): &((F, F), (F, F))| a.0 <= circle && circle < b.0;
        let chord = tread().zip(tread().skip(1)).find(is_there);
        let end = tread().last().map_or(F::zero(), |point| point.1);
        let zero = chord.map_or(end, |(a, b)| a.1 + (circle - a.0) * (b.1 - a.1) / (b.0 - a.0));
        y.iter_mut().for_each(|y| *y -= circle);
        z.iter_mut().for_each(|z| *z -= zero);
        KSTRIP_NOTE_RUNNING_CIRCLE
    }
}

fn is_clear_wheel<F: Float>(shape: &Shape<F>) -> bool {
    !shape.is_wheel.is_no() && shape.is_wheel.is_at_least(CLEAR)
}

fn is_upward<F: Float>(
    kind: Kind, has_convention: bool, shape: &Shape<F>, notes: &mut u32,
) -> bool {
    let (down, may_overrule) = match kind {
        Kind::Wheel => (shape.wheel_down, is_clear_wheel(shape)),
        // A rail is overruled if it has a head upside down and none as it stands.
        Kind::Rail => (shape.rail_down, shape.heads == [0, 1] && shape.has_deep_head_turned),
    };
    if has_convention {
        let is_against = down.is_no() && down.is_at_least(DECISIVE) && may_overrule;
        *notes |= if is_against { KSTRIP_NOTE_DOUBT_Z } else { 0 };
        return is_against;
    }
    let is_weak = !down.is_at_least(WEAK_EVIDENCE);
    *notes |= if is_weak { KSTRIP_NOTE_DOUBT_Z } else { 0 };
    !is_weak && down.is_no()
}

fn is_mirrored<F: Float>(
    kind: Kind, has_convention: bool, is_upward: bool, shape: &Shape<F>, notes: &mut u32,
) -> bool {
    let ([stands, turned], [heads, heads_turned]) = (shape.gauge_left, shape.heads);
    let (side, heads): (Evidence<F>, usize) = match kind {
        Kind::Wheel => (shape.flange_left, 0),
        Kind::Rail if is_upward => (turned, heads_turned),
        Kind::Rail => (stands, heads),
    };
    if has_convention {
        let is_against = kind == Kind::Wheel
            && side.is_no()
            && side.is_at_least(DECISIVE)
            && is_clear_wheel(shape);
        *notes |= if is_against { KSTRIP_NOTE_DOUBT_SIDE } else { 0 };
        return is_against;
    }
    if heads > 1 {
        *notes |= KSTRIP_NOTE_DOUBT_SIDE;
        return false;
    }
    side.is_no() && side.is_at_least(WEAK_EVIDENCE)
}
