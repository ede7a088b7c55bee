//! Files of MiniProf instruments, in mm: `Key=value` lines, `[sections]` or the title lines of old
//! instruments, and then the points. A point that is marked by a leading quotation mark is left
//! out. Drawings have segments `MPDn=L y z y z`. y = 0 of a wheel is at its flange back.

use super::header::{Header, Kind};
use super::text::{Lines, Separator, Words, begins_as_number, number, pair, whole, without};
use crate::number::Float;
use crate::status::Error;

/// Points after which lines of text are no titles any more, but a footer.
const ROWS: usize = 3;
const KEYS: &str = "filename programname xypoints columndef mptypeno mpserno refpoint1 sectionno \
    transform";
/// Titles of old instruments, and the kind that they name.
const TITLES: [(&str, Option<Kind>); 3] =
    [("MINIWHEELPROF", Some(Kind::Wheel)), ("MINIRAILPROF", Some(Kind::Rail)), ("MINIPROF", None)];

/// Whether a line is of such a file: a title or a keyword.
pub(super) fn begins_miniprof(line: &[u8]) -> bool {
    let is_key =
        |key: &[u8]| KEYS.split(' ').any(|known| key.eq_ignore_ascii_case(known.as_bytes()));
    title(line).is_some() || pair(without(line, b"\"")).is_some_and(|(key, _)| is_key(key))
}

/// The kind that the title of an old instrument names, if it is one.
fn title(line: &[u8]) -> Option<Option<Kind>> {
    let mut words = without(line, b"#").split(|byte| !byte.is_ascii_alphanumeric());
    let first = words.next().unwrap_or(b"");
    let found = TITLES.iter().find(|(name, _)| first.eq_ignore_ascii_case(name.as_bytes()));
    found.map(|(_, kind)| *kind)
}

/// What a file has, from its first section with points.
struct Layout {
    columns: [usize; 2],
    /// Number of the first line with a point.
    first: usize,
    points: usize,
    marked: usize,
    promised: Option<i32>,
}

/// Reads a file: passes each point in mm, or the ends of each segment.
///
/// # Errors
/// [`Error::FileLine`] for a line that is no point; [`Error::FileCount`] if points are missing.
pub(super) fn read_miniprof<F: Float>(
    text: &[u8], header: &mut Header<F>, point: &mut dyn FnMut([F; 2]),
) -> Result<(), Error> {
    let layout = find_layout(text, header)?;
    let mut previous = None;
    for line in Lines::new(text).skip(layout.first).take_while(|line| !is_section(line)) {
        if let Some([from, to]) = segment(line)? {
            if previous != Some(from) {
                point(from);
            }
            point(to);
            previous = Some(to);
        } else if let Some(of) = point_of_line(line, layout.columns) {
            point(of);
        }
    }
    Ok(())
}

fn find_layout<F: Float>(text: &[u8], header: &mut Header<F>) -> Result<Layout, Error> {
    let mut found = Layout { columns: [0, 1], first: 0, points: 0, marked: 0, promised: None };
    let (mut is_over, mut has_footer) = (false, false);
    for (number_of_line, line) in Lines::new(text).enumerate().filter(|(_, line)| !line.is_empty())
    {
        let is_row = point_of_line::<F>(line, found.columns).is_some();
        if is_over {
            header.has_several |= is_row || segment::<F>(line).is_ok_and(|found| found.is_some());
        } else if is_section(line) {
            is_over = found.points > 0;
        } else if is_row || segment::<F>(line)?.is_some() {
            Error::FileLine.when(has_footer)?;
            if found.points == 0 {
                found.first = number_of_line;
            }
            found.points += 1;
        } else if let Some(kind) = title(line) {
            header.kind = header.kind.or(kind);
        } else if let Some((key, value)) = pair(without(line, b"\"")) {
            found.keyword(key, without(value, b"\""), header)?;
        } else if line.first() == Some(&b'"') {
            found.marked += 1;
        } else if line.first().is_some_and(|byte| !b"#!%*/".contains(byte)) {
            has_footer = found.points >= ROWS;
            Error::FileLine.when(has_footer && begins_as_number(line))?;
            if !has_footer {
                (found.points, found.marked) = (0, 0);
            }
        }
    }
    header.is_left_out |= found.marked > 0 || has_footer;
    // A file with more than one point less than it promises was cut.
    let promised = found.promised.map_or(found.points, |count| count.unsigned_abs() as usize);
    let all = found.points + found.marked;
    header.has_other_count |= !(found.points..=all).contains(&promised);
    Error::FileCount.when(found.points > 0 && all + 1 < promised)?;
    Ok(found)
}

impl Layout {
    fn keyword<F: Float>(
        &mut self, key: &[u8], value: &[u8], header: &mut Header<F>,
    ) -> Result<(), Error> {
        if key.eq_ignore_ascii_case(b"xypoints") {
            self.promised = whole(value);
        } else if key.eq_ignore_ascii_case(b"origin") {
            header.is_from_flange_back = !value.eq_ignore_ascii_case(b"running circle");
        } else if key.eq_ignore_ascii_case(b"columndef") && self.points == 0 {
            let words = Words::of_line(value, Separator::Character(b','));
            let place =
                |name: &[u8]| words.list.iter().position(|word| word.eq_ignore_ascii_case(name));
            let [y, z] = [place(b"X"), place(b"Y")].map(|place| place.ok_or(Error::FileLine));
            self.columns = [y?, z?];
        }
        Ok(())
    }
}

fn is_section(line: &[u8]) -> bool {
    line.first() == Some(&b'[') && line.last() == Some(&b']')
}

/// The point of a line of numbers, between blanks, commas or semicolons.
fn point_of_line<F: Float>(line: &[u8], columns: [usize; 2]) -> Option<[F; 2]> {
    if line.first() == Some(&b'"') {
        return None;
    }
    let (comma, semicolon) = (Separator::Character(b','), Separator::Character(b';'));
    let forms =
        [(Separator::Blank, b'.'), (Separator::Blank, b','), (comma, b'.'), (semicolon, b'.')];
    forms.iter().find_map(|(separator, decimal)| {
        let words = Words::of_line(line, *separator);
        let of = |word: &[u8]| number::<F>(word, *decimal).or_else(|| number(word, b'.'));
        let is_row = words.count >= 2 && words.list.iter().all(|word| of(word).is_some());
        let [y, z] = columns.map(|column| of(words.word(column)));
        if is_row { Some([y?, z?]) } else { None }
    })
}

/// The ends of the segment of a drawing, if a line has one.
fn segment<F: Float>(line: &[u8]) -> Result<Option<[[F; 2]; 2]>, Error> {
    let Some((key, value)) = pair(line) else { return Ok(None) };
    let is_key = match key {
        [b'M' | b'm', b'P' | b'p', b'D' | b'd', first, rest @ ..] => {
            first.is_ascii_digit() && rest.iter().all(u8::is_ascii_digit)
        }
        _ => false,
    };
    if !is_key {
        return Ok(None);
    }
    let words = Words::of_line(value, Separator::Blank);
    Error::FileLine.unless(words.count == 5 && words.word(0).eq_ignore_ascii_case(b"L"))?;
    let of = |k: usize| number::<F>(words.word(k), b'.').ok_or(Error::FileLine);
    Ok(Some([[of(1)?, of(2)?], [of(3)?, of(4)?]]))
}
