//! Files of SIMPACK and CONTACT: sections of `keyword = value` lines, and the points in the section
//! `point`. Lengths are in `units.len.f` units per metre, z points down, and the flange or the
//! gauge side is at small y.

use super::header::{Header, Kind};
use super::text::{Lines, Separator, Words, number, pair, up_to, whole};
use crate::number::Float;
use crate::status::Error;

const DEEPEST_NESTING: usize = 8;

/// Whether a line begins a section of such a file.
pub(super) fn begins_simpack(line: &[u8]) -> bool {
    section(line, ".begin")
        .is_some_and(|name| [&b"header"[..], b"spline", b"point"].contains(&name))
}

/// The name of the section that a line begins or ends.
fn section<'a>(line: &'a [u8], mark: &str) -> Option<&'a [u8]> {
    let name = line.strip_suffix(mark.as_bytes())?;
    let is_name = |byte: &u8| byte.is_ascii_alphanumeric() || *byte == b'_';
    (!name.is_empty() && name.iter().all(is_name)).then_some(name)
}

/// Reads the keywords into a header, and passes each point within the bounds that has a weight, in
/// the units of the file.
///
/// # Errors
/// [`Error::FileLine`] for a line that is neither.
pub(super) fn read_simpack<F: Float>(
    text: &[u8], header: &mut Header<F>, point: &mut dyn FnMut([F; 2]),
) -> Result<(), Error> {
    let mut sections = heapless::Vec::<&[u8], DEEPEST_NESTING>::new();
    for line in Lines::new(text).map(|line| up_to(line, b"!%")).filter(|line| !line.is_empty()) {
        let within = sections.last().copied().unwrap_or(b"");
        if let Some(name) = section(line, ".begin") {
            sections.push(name).map_err(|_| Error::FileLine)?;
        } else if let Some(name) = section(line, ".end") {
            Error::FileLine.unless(sections.pop() == Some(name))?;
        } else if within == b"point" {
            let words = Words::of_line(line, Separator::Blank);
            let [y, z] = [0, 1].map(|k| number::<F>(words.word(k), b'.').ok_or(Error::FileLine));
            let of = [y?, z?];
            let weight = number(words.word(2), b'.').unwrap_or(F::one()).abs();
            if weight > F::zero() && header.is_within(of) {
                header.has_ignored |= (weight - F::one()).abs() > F::zero();
                point(of);
            } else {
                header.is_left_out = true;
            }
        } else {
            let (key, value) = pair(line).ok_or(Error::FileLine)?;
            header.keyword(within, key, value)?;
        }
    }
    Error::FileLine.unless(sections.is_empty())
}

impl<F: Float> Header<F> {
    /// Whether a point is within the bounds; equal ones are none.
    fn is_within(&self, of: [F; 2]) -> bool {
        let mut pairs = of.iter().zip(&self.bounds);
        pairs.all(|(x, [least, most])| least >= most || (x >= least && x <= most))
    }

    fn keyword(&mut self, within: &[u8], key: &[u8], value: &[u8]) -> Result<(), Error> {
        let of = || number::<F>(value, b'.').ok_or(Error::FileLine);
        let [[y_least, y_most], [z_least, z_most]] = &mut self.bounds;
        match key {
            b"type" if within == b"header" => {
                let kinds = [Kind::Rail, Kind::Wheel];
                let number = whole(value).and_then(|number| usize::try_from(number).ok());
                self.kind = number.and_then(|number| kinds.get(number).copied());
            }
            b"units.len.f" => self.units_per_metre = of()?,
            b"units.ang.f" => self.units_per_radian = of()?,
            b"shift.y" => self.shift[0] = of()?,
            b"shift.z" => self.shift[1] = of()?,
            b"rotate" => self.turn = of()?,
            b"mirror.y" => self.mirror[0] = of()?.abs() > F::zero(),
            b"mirror.z" => self.mirror[1] = of()?.abs() > F::zero(),
            b"bound.y.min" => *y_least = of()?,
            b"bound.y.max" => *y_most = of()?,
            b"bound.z.min" => *z_least = of()?,
            b"bound.z.max" => *z_most = of()?,
            b"approx.smooth" => self.has_ignored |= of()?.abs() > F::zero(),
            _ => (),
        }
        Ok(())
    }
}
