//! Profiles from the text of a file, without a copy of it: SIMPACK, MiniProf, columns of numbers.
//!
//! The convention of a format decides which way its points stand. Only where it has none, or where
//! the caller names another kind, their shape decides. In single steps:
//!
//! 1. A first pass over the text finds header, unit and extent; a second one counts the points that
//!    are at different places. Until then nothing is written.
//! 2. A last pass writes the points, and they are turned.

mod columns;
mod flats;
mod header;
mod miniprof;
pub mod notes;
mod orientation;
mod shape;
mod simpack;
mod text;

use self::header::{FEWEST_POINTS, Header, Kind, LARGEST, MILLIMETRE};
use self::notes::*;
use self::orientation::{Series, warning_of_notes};
pub use self::orientation::{Unit, orient_points, unit_of_points};
use self::text::Lines;
use crate::number::Float;
use crate::status::{Error, Warning};
use crate::wheel_rail::sine_cosine;

/// Points nearer to the one before are left out \[m\].
const NEAREST_POINTS: f64 = 1e-9;
/// How much farther from all others a number is that marks a missing one, and its least size.
const FAR_NUMBER: f64 = 20.0;
const MARK: f64 = 99.0;
/// A closed outline: the distance of its ends over its height, and its least height over its width.
const CLOSED: f64 = 0.02;
const TALL: f64 = 0.25;

/// The least and the largest of some numbers, and those that are next to them.
struct Range<F>([F; 4]);

impl<F: Float> Range<F> {
    fn new() -> Self {
        Self([F::LARGEST, F::LARGEST, -F::LARGEST, -F::LARGEST])
    }

    fn add(&mut self, x: F) {
        let [least, second, below, most] = &mut self.0;
        if x < *least {
            (*least, *second) = (x, *least);
        } else if x > *least {
            *second = second.min(x);
        }
        if x > *most {
            (*most, *below) = (x, *most);
        } else if x < *most {
            *below = below.max(x);
        }
    }

    fn width(&self) -> F {
        self.0[3] - self.0[0]
    }

    /// Whether an end is far from all other numbers.
    fn has_mark(&self) -> bool {
        let [least, second, below, most] = self.0;
        let is_mark = |end: F, next: F, other: F| {
            let span = (next - other).abs();
            end.abs() >= F::of(MARK)
                && span > F::zero()
                && (end - next).abs() > span.times(FAR_NUMBER)
        };
        is_mark(most, below, least) || is_mark(least, second, most)
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Format {
    Simpack,
    MiniProf,
    Columns,
}

impl Format {
    fn found_in(text: &[u8]) -> Self {
        let head = || Lines::new(text).filter(|line| !line.is_empty()).take(400);
        if head().any(simpack::begins_simpack) {
            Self::Simpack
        } else if head().take(100).any(miniprof::begins_miniprof) {
            Self::MiniProf
        } else {
            Self::Columns
        }
    }

    /// Reads a header and the points that count, in units of the file.
    fn read<F: Float>(
        self, text: &[u8], header: &mut Header<F>, point: &mut dyn FnMut([F; 2]),
    ) -> Result<(), Error> {
        match self {
            Self::Simpack => simpack::read_simpack(text, header, point),
            Self::MiniProf => miniprof::read_miniprof(text, header, point),
            Self::Columns => columns::read_columns(text, header, point),
        }
    }
}

/// A file whose points can be read.
pub struct ProfileFile<'a, F> {
    text: &'a [u8],
    format: Format,
    /// The format as the caller names it.
    asked: u32,
    header: Header<F>,
    unit: Unit<F>,
    count: u32,
}

impl<'a, F: Float> ProfileFile<'a, F> {
    /// Examines a text. `asked`: a constant KSTRIP_FORMAT_, to which others may be added.
    ///
    /// # Errors
    /// [`Error::FileFormat`], [`Error::FileLine`], [`Error::FileColumns`], [`Error::FileCount`],
    /// [`Error::FileUnits`], [`Error::FileMissing`]; [`Error::NotFinite`]; [`Error::Profile`] for
    /// fewer than four points; [`Error::Capacity`]; [`Error::Scatter`] for a closed outline.
    pub fn open(text: &'a [u8], asked: u32, capacity: usize) -> Result<Self, Error> {
        Error::FileLine.when(text.contains(&0))?;
        Error::FileFormat.unless(is_known_format(asked))?;
        let format = match asked & 15 {
            KSTRIP_FORMAT_SIMPACK => Format::Simpack,
            KSTRIP_FORMAT_MINIPROF => Format::MiniProf,
            KSTRIP_FORMAT_COLUMNS => Format::Columns,
            _ => Format::found_in(text),
        };
        let (header, unit) = (Header::new(), Unit::of_metres(F::one()));
        let mut file = Self { text, format, asked, header, unit, count: 0 };
        let all = file.examine()?;
        let mut count = 0;
        file.places(&mut |_| count += 1);
        Error::Profile.when(count < FEWEST_POINTS)?;
        Error::Capacity.when(count > capacity)?;
        file.count = count as u32;
        file.header.is_left_out |= count < all;
        Ok(file)
    }

    /// Number of the points.
    #[must_use]
    pub const fn point_count(&self) -> usize {
        self.count as usize
    }

    /// Finds header and unit, and refuses points that are no profile. Returns their number.
    fn examine(&mut self) -> Result<usize, Error> {
        let (mut ranges, mut count) = ([Range::new(), Range::new()], 0);
        let (mut ends, mut is_finite) = (None, true);
        self.format.read(self.text, &mut self.header, &mut |point: [F; 2]| {
            count += 1;
            ends = Some((ends.map_or(point, |(first, _)| first), point));
            for (range, x) in ranges.iter_mut().zip(point) {
                is_finite &= x.abs() <= F::of(LARGEST);
                range.add(x);
            }
        })?;
        Error::Profile.when(count < FEWEST_POINTS)?;
        Error::NotFinite.unless(is_finite)?;
        let has_mark = ranges.iter().any(Range::has_mark);
        Error::FileMissing.when(self.format == Format::Columns && has_mark)?;
        let [width, height] = [ranges[0].width(), ranges[1].width()];
        self.find_unit(width.max(height))?;
        let is_closed = ends.is_some_and(|(first, last)| {
            distance_of_points(first, last) < height.times(CLOSED) && height > width.times(TALL)
        });
        Error::Scatter.when(is_closed)?;
        Ok(count)
    }

    /// Metres per unit, by the header or by the width of the points.
    fn find_unit(&mut self, width: F) -> Result<(), Error> {
        let Header { units_per_metre, units_per_radian, unit, .. } = self.header;
        self.unit = match (self.format, unit) {
            (Format::Simpack, _) => {
                let is_positive = units_per_metre > F::zero() && units_per_radian > F::zero();
                Error::FileUnits.unless(is_positive)?;
                Unit::of_metres(F::one() / units_per_metre)
            }
            (Format::MiniProf, _) => Unit::of_metres(F::of(MILLIMETRE)),
            (Format::Columns, Some(unit)) => Unit::of_metres(F::of(unit)),
            (Format::Columns, None) => Unit::of_width(width)?,
        };
        Ok(())
    }

    /// Passes the points at different places in metres, as the header requests them.
    fn places(&self, place: &mut dyn FnMut([F; 2])) {
        let Header { shift, turn, mirror, units_per_radian, .. } = &self.header;
        let (sine, cosine) = sine_cosine_of_any(*turn / *units_per_radian);
        let [y_sign, z_sign] = mirror.map(|is| if is { -F::one() } else { F::one() });
        let mut last = None;
        // The same text had no error before.
        let _ = self.format.read(self.text, &mut Header::new(), &mut |[y, z]: [F; 2]| {
            let [y, z] = [(y + shift[0]) * self.unit.metres, (z + shift[1]) * self.unit.metres];
            let point = [y_sign * (cosine * y - sine * z), z_sign * (sine * y + cosine * z)];
            if last.is_none_or(|last| distance_of_points(last, point) > F::of(NEAREST_POINTS)) {
                place(point);
            }
            last = Some(point);
        });
    }

    /// Writes [`ProfileFile::point_count`] points, the right way round. Returns the notes, and a
    /// warning if there is a doubt.
    pub fn read(mut self, y: &mut [F], z: &mut [F]) -> (u32, Warning) {
        let mut written = y.iter_mut().zip(z.iter_mut());
        self.places(&mut |point| {
            if let Some((y, z)) = written.next() {
                [*y, *z] = point;
            }
        });
        let mut notes = self.notes();
        let known = self.known(&mut notes);
        notes |= Series { y, z, counts: &[self.count] }.turn(known, &mut self.unit);
        (notes, warning_of_notes(notes))
    }

    /// What is known of the points without their shape, as a format; and a doubt about the kind.
    fn known(&self, notes: &mut u32) -> u32 {
        let asked = self.asked & !15;
        let format = match self.format {
            Format::Simpack => KSTRIP_FORMAT_SIMPACK,
            Format::MiniProf if self.header.is_from_flange_back => KSTRIP_FORMAT_MINIPROF,
            Format::MiniProf | Format::Columns => KSTRIP_FORMAT_COLUMNS,
        };
        let kind = match self.header.kind {
            None => return asked | format,
            Some(Kind::Wheel) => KSTRIP_FORMAT_WHEEL,
            Some(Kind::Rail) => KSTRIP_FORMAT_RAIL,
        };
        let asked_kind = asked & (KSTRIP_FORMAT_WHEEL | KSTRIP_FORMAT_RAIL);
        if asked_kind == 0 || asked_kind == kind {
            return asked | kind | format;
        }
        *notes |= KSTRIP_NOTE_DOUBT_KIND;
        without_convention(asked | format)
    }

    fn notes(&self) -> u32 {
        let header = &self.header;
        let is_changed = header.mirror.contains(&true)
            || [header.turn, header.shift[0], header.shift[1]].iter().any(|x| x.abs() > F::zero());
        let bits = [
            (self.format == Format::Simpack, KSTRIP_NOTE_SIMPACK),
            (self.format == Format::MiniProf, KSTRIP_NOTE_MINIPROF),
            (is_changed, KSTRIP_NOTE_HEADER),
            (header.is_left_out, KSTRIP_NOTE_LEFT_OUT),
            (header.has_ignored, KSTRIP_NOTE_IGNORED),
            (header.has_other_count, KSTRIP_NOTE_COUNT),
            (header.has_several, KSTRIP_NOTE_DOUBT_POINTS),
        ];
        bits.iter().filter(|(holds, _)| *holds).fold(0, |notes, (_, bit)| notes | bit)
    }
}

fn distance_of_points<F: Float>([a, b]: [F; 2], [c, d]: [F; 2]) -> F {
    ((a - c).squared() + (b - d).squared()).sqrt()
}

/// Sine and cosine of any angle, by whole turns and the half of the rest.
fn sine_cosine_of_any<F: Float>(angle: F) -> (F, F) {
    let turn = 2.0 * core::f64::consts::PI;
    let rest = angle - F::of(turn) * F::widened(angle.times(1.0 / turn).whole() as f32);
    let (sine, cosine) = sine_cosine(rest.times(0.5));
    ((sine * cosine).times(2.0), F::one() - sine.squared().times(2.0))
}
