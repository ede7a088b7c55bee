//! Profiles the right way round: toward larger y, z down, the flange or the gauge side at small y,
//! and y of a wheel from its running circle. Kind, unit and sides of several profiles are decided
//! once.

use super::flats::width_of;
use super::header::{FEWEST_POINTS, LARGEST, MILLIMETRE};
use super::notes::*;
use super::shape::{Evidence, Shape};
use crate::number::Float;
use crate::status::{Error, Warning};

/// Strength of evidence, 0 to 1, below which it is weak, and from which it overrules the convention
/// of a format.
const WEAK_EVIDENCE: f64 = 0.2;
const DECISIVE: f64 = 0.6;
/// A rail is turned by its shape if its flat part is longer \[m\]. A groove for a ball is shorter.
const LEAST_HEAD: f64 = 0.030;
/// From the flange back of a wheel to its running circle \[m\].
const FLANGE_BACK: f64 = 0.070;
/// Tips of flanges at smaller y belong to profiles from the running circle, and at these y to those
/// from the flange back \[m\].
const FLANGE_TIP: f64 = -0.020;
const TIP_FROM_BACK: f64 = 0.035;
/// Least width and height of the profile of a wheel with a flange \[m\].
const WHEEL: [f64; 2] = [0.08, 0.015];
/// Widest profile in metres, and in mm; and up to which width the unit may be another one than mm:
/// inches, or cm for a wheel with a flange.
const WIDEST_PROFILE: [f64; 2] = [0.6, 2000.0];
const WIDEST_IN_INCHES: f64 = 12.0;
const WIDEST_IN_CENTIMETRES: f64 = 25.0;
const INCH: f64 = 0.0254;

/// The unit of points.
pub struct Unit<F> {
    /// Metres per unit.
    pub metres: F,
    /// The shape may change it.
    is_open: bool,
    notes: u32,
}

impl<F: Float> Unit<F> {
    pub(super) const fn of_metres(metres: F) -> Self {
        Self { metres, is_open: false, notes: 0 }
    }

    /// Of points that are `width` wide.
    pub(super) fn of_width(width: F) -> Result<Self, Error> {
        let [metres, millimetres] = WIDEST_PROFILE.map(F::of);
        Error::FileUnits.when(width > millimetres)?;
        Ok(Self {
            metres: if width <= metres { F::one() } else { F::of(MILLIMETRE) },
            is_open: width > metres && width <= F::of(WIDEST_IN_CENTIMETRES),
            notes: KSTRIP_NOTE_UNIT_OF_WIDTH,
        })
    }
}

/// Checks the points of a caller's profiles, and finds their unit from their width if it is 0.
///
/// # Errors
/// [`Error::FileFormat`]; [`Error::Profile`] for fewer than four points in a profile;
/// [`Error::NotFinite`]; [`Error::FileUnits`].
pub fn unit_of_points<F: Float>(
    [y, z]: [&[F]; 2], counts: &[u32], format: u32, unit: F,
) -> Result<Unit<F>, Error> {
    Error::FileFormat.unless(is_known_format(format))?;
    let is_short = |count: &u32| (*count as usize) < FEWEST_POINTS;
    Error::Profile.when(counts.is_empty() || counts.iter().any(is_short))?;
    let mut numbers = y.iter().chain(z).chain([&unit]);
    Error::NotFinite.unless(numbers.all(|x| x.abs() <= F::of(LARGEST)))?;
    Error::FileUnits.when(unit < F::zero())?;
    if unit > F::zero() {
        return Ok(Unit::of_metres(unit));
    }
    let (mut width, mut first) = (F::zero(), 0);
    for count in counts {
        let part = first..first + *count as usize;
        let widths = [y, z].map(|list| list.get(part.clone()).map_or(F::zero(), width_of));
        width = width.max(widths[0]).max(widths[1]);
        first = part.end;
    }
    Unit::of_width(width)
}

/// Writes the points of a caller's profiles the right way round, in metres. `unit` is found by
/// [`unit_of_points`], and receives the unit that is taken. Returns the notes, and a warning if one
/// of them is a doubt.
pub fn orient_points<F: Float>(
    points: [&[F]; 2], [y, z]: [&mut [F]; 2], counts: &[u32], format: u32, unit: &mut Unit<F>,
) -> (u32, Warning) {
    for (list, given) in [&mut *y, &mut *z].into_iter().zip(points) {
        list.iter_mut().zip(given).for_each(|(x, given)| *x = *given * unit.metres);
    }
    let notes = Series { y, z, counts }.turn(format, unit);
    (notes, warning_of_notes(notes))
}

/// Profiles one after another in the same arrays, with the numbers of their points.
pub(super) struct Series<'a, F> {
    pub(super) y: &'a mut [F],
    pub(super) z: &'a mut [F],
    pub(super) counts: &'a [u32],
}

impl<F: Float> Series<'_, F> {
    fn each_profile(&mut self, apply: &mut dyn FnMut(&mut [F], &mut [F])) {
        let mut first = 0;
        for count in self.counts {
            let part = first..first + *count as usize;
            first = part.end;
            if let (Some(y), Some(z)) = (self.y.get_mut(part.clone()), self.z.get_mut(part)) {
                apply(y, z);
            }
        }
    }

    fn rescale(&mut self, factor: F) {
        self.y.iter_mut().chain(self.z.iter_mut()).for_each(|x| *x = *x * factor);
    }

    fn shape(&mut self) -> Shape<F> {
        let mut shape = Shape::default();
        self.each_profile(&mut |y, z| shape.add(&Shape::of_points(y, z)));
        shape
    }

    /// Turns profiles in metres, and changes their unit if it is open. Returns the notes.
    pub(super) fn turn(&mut self, known: u32, unit: &mut Unit<F>) -> u32 {
        let (mut notes, mut shape) = (unit.notes, self.shape());
        if unit.is_open {
            let (mut width, factor) = (F::zero(), F::of(INCH / MILLIMETRE));
            self.each_profile(&mut |y, z| width = width.max(width_of(y)).max(width_of(z)));
            let is_narrow = width <= F::of(WIDEST_IN_INCHES * MILLIMETRE);
            notes |= if is_narrow || shape.is_clear_wheel() { KSTRIP_NOTE_DOUBT_UNIT } else { 0 };
            if is_narrow && shape.is_in_inches(width, factor) {
                unit.metres = unit.metres * factor;
                self.rescale(factor);
                shape = self.shape();
            }
        }
        notes |= if shape.is_scattered { KSTRIP_NOTE_DOUBT_POINTS } else { 0 };
        let is_wheel = match known & (KSTRIP_FORMAT_WHEEL | KSTRIP_FORMAT_RAIL) {
            KSTRIP_FORMAT_WHEEL => true,
            KSTRIP_FORMAT_RAIL => false,
            _ => {
                let is_weak = !shape.is_wheel.is_at_least(WEAK_EVIDENCE);
                notes |= if is_weak { KSTRIP_NOTE_DOUBT_KIND } else { 0 };
                shape.is_wheel.value > F::zero()
            }
        };
        let (is_upward, doubt) = is_upward(is_wheel, known, &shape);
        // A file against its format in one direction may be so in the other.
        let mirrored_known = if is_upward { without_convention(known) } else { known };
        let (is_mirrored, side) = is_mirrored(is_wheel, mirrored_known, is_upward, &shape);
        notes |= doubt | side;
        for (holds, bit) in [
            (is_wheel, KSTRIP_NOTE_WHEEL),
            (is_upward, KSTRIP_NOTE_Z_TURNED),
            (is_mirrored, KSTRIP_NOTE_Y_MIRRORED),
        ] {
            notes |= if holds { bit } else { 0 };
        }
        let is_from_back = known & 15 == KSTRIP_FORMAT_MINIPROF;
        self.each_profile(&mut |y, z| {
            z.iter_mut().filter(|_| is_upward).for_each(|z| *z = -*z);
            y.iter_mut().filter(|_| is_mirrored).for_each(|y| *y = -*y);
            let runs_down = y.first() > y.last();
            if runs_down {
                y.reverse();
                z.reverse();
            }
            notes |= if runs_down == is_mirrored { 0 } else { KSTRIP_NOTE_REVERSED };
            notes |= if is_wheel { move_to_running_circle(y, z, is_from_back) } else { 0 };
        });
        notes
    }
}

/// A warning if one of the notes is a doubt.
pub(super) const fn warning_of_notes(notes: u32) -> Warning {
    if notes & DOUBTS == 0 { Warning::None } else { Warning::ProfileGuess }
}

/// Whether z points up, and the doubt about it.
fn is_upward<F: Float>(is_wheel: bool, known: u32, shape: &Shape<F>) -> (bool, u32) {
    if known & KSTRIP_FORMAT_Z_DOWN != 0 {
        return (false, 0);
    }
    let down = if is_wheel { shape.wheel_down } else { shape.rail_down };
    if has_convention(known) {
        // A rail is overruled if it has a head upside down and none as it stands.
        let may_overrule = if is_wheel {
            shape.is_clear_wheel()
        } else {
            shape.heads == [0, 1] && shape.has_deep_head_turned
        };
        let is_against = down.is_no() && down.is_at_least(DECISIVE) && may_overrule;
        return (is_against, if is_against { KSTRIP_NOTE_DOUBT_Z } else { 0 });
    }
    if !down.is_at_least(WEAK_EVIDENCE) {
        return (false, KSTRIP_NOTE_DOUBT_Z);
    }
    // Grooves are concave as rails upside down are, and rollers have no flange
    let is_sure = if is_wheel { shape.has_flange } else { shape.has_deep_head_turned };
    let may_turn = is_wheel || is_sure || shape.longest > F::of(LEAST_HEAD);
    let doubt = if down.is_no() && !is_sure { KSTRIP_NOTE_DOUBT_Z } else { 0 };
    (down.is_no() && may_turn, doubt)
}

/// Whether the flange or the gauge side is at large y, and a note or a doubt about it.
fn is_mirrored<F: Float>(
    is_wheel: bool, known: u32, is_upward: bool, shape: &Shape<F>,
) -> (bool, u32) {
    if known & KSTRIP_FORMAT_SIDE != 0 {
        return (false, 0);
    }
    let chosen = usize::from(is_upward);
    let sides: &[Evidence<F>; 2] = if is_wheel { &shape.flange_left } else { &shape.gauge_left };
    let side = sides.get(chosen).copied().unwrap_or_default();
    let heads = shape.heads.get(chosen).copied().unwrap_or(0);
    if has_convention(known) {
        let is_decisive = side.is_no() && side.is_at_least(DECISIVE);
        let is_against = is_wheel && is_decisive && shape.is_clear_wheel();
        return (is_against, if is_against { KSTRIP_NOTE_DOUBT_SIDE } else { 0 });
    }
    let is_clear = side.is_at_least(WEAK_EVIDENCE);
    let has_several = !is_wheel && heads > 1;
    let note = if is_clear { 0 } else { KSTRIP_NOTE_SYMMETRIC };
    let doubt = if has_several { KSTRIP_NOTE_DOUBT_SIDE } else { 0 };
    (is_clear && !has_several && side.is_no(), note | doubt)
}

/// Moves a wheel from its flange back to its running circle.
fn move_to_running_circle<F: Float>(y: &mut [F], z: &mut [F], is_from_back: bool) -> u32 {
    let points = || y.iter().copied().zip(z.iter().copied());
    let Some((tip, depth)) = points().reduce(|a, b| if b.1 > a.1 { b } else { a }) else {
        return 0;
    };
    let [width, height] = [&*y, &*z].map(width_of);
    let [least_width, least_height] = WHEEL.map(F::of);
    if width < least_width || height < least_height || tip <= F::of(FLANGE_TIP) {
        return 0;
    }
    if !is_from_back || tip <= F::zero() || tip >= F::of(TIP_FROM_BACK) {
        return KSTRIP_NOTE_DOUBT_ORIGIN;
    }
    // The height of the tread at the running circle, or at its end
    let circle = F::of(FLANGE_BACK);
    let tread = || points().skip_while(|point| point.1 < depth);
    let is_there = |(a, b): &((F, F), (F, F))| a.0 <= circle && circle < b.0;
    let chord = tread().zip(tread().skip(1)).find(is_there);
    let end = tread().last().map_or(F::zero(), |point| point.1);
    let zero = chord.map_or(end, |(a, b)| a.1 + (circle - a.0) / (b.0 - a.0) * (b.1 - a.1));
    y.iter_mut().for_each(|y| *y -= circle);
    z.iter_mut().for_each(|z| *z -= zero);
    KSTRIP_NOTE_RUNNING_CIRCLE
}
