//! Columns of numbers, as spreadsheets, instruments and programs write them: two columns, or those
//! with the names of y and z. Titles, names, a count and a footer may stand around them, and cells
//! may be in quotation marks.

use super::header::Header;
use super::text::{Lines, Separator, Words, begins_as_number, number, trimmed, without};
use crate::number::Float;
use crate::status::Error;

const COMMENT: &[u8] = b"#!%*/";
/// Lines from which separators are found.
const SAMPLE: usize = 2000;
/// Names of the columns of y and z.
const NAMES: [[&str; 2]; 5] =
    [["y", "z"], ["x", "z"], ["x", "y"], ["lateral", "vertical"], ["across", "down"]];
/// Cells that stand for no number.
const NO_NUMBERS: [&str; 8] = ["", "nan", "na", "n/a", "#n/a", "null", "none", "-"];
/// Units by name, in metres.
const UNITS: [(&str, f64); 4] = [("mm", 1e-3), ("cm", 1e-2), ("in", 0.0254), ("m", 1.0)];

/// How a table is written, and where its numbers are.
struct Table {
    separator: Separator,
    /// The decimal point.
    point: u8,
    columns: [usize; 2],
    /// Words of a row, and whether columns have names.
    count: usize,
    is_named: bool,
    /// Number of the first row.
    first: usize,
}

/// Reads a table: passes each point in its units.
///
/// # Errors
/// [`Error::FileLine`] for a line that is no row; [`Error::FileColumns`] for more than two columns
/// without names.
pub(super) fn read_columns<F: Float>(
    text: &[u8], header: &mut Header<F>, point: &mut dyn FnMut([F; 2]),
) -> Result<(), Error> {
    let Some(table) = table(text, header)? else { return Ok(()) };
    let mut has_footer = false;
    for line in Lines::new(text).skip(table.first).filter(|line| !is_comment(line)) {
        let bare = bare(line);
        if without(bare, b",;\t\"").is_empty() {
            header.is_left_out |= !bare.is_empty();
            continue;
        }
        let words = Words::of_line(bare, table.separator);
        let number_of = |word: &[u8]| number::<F>(word, table.point);
        if !words.list.iter().any(|word| number_of(word).is_some()) {
            has_footer = true;
            continue;
        }
        Error::FileLine.when(has_footer || (words.count > table.count && !table.is_named))?;
        let [y, z] = table.columns.map(|column| number_of(words.word(column)));
        point([y.ok_or(Error::FileLine)?, z.ok_or(Error::FileLine)?]);
    }
    header.is_left_out |= has_footer;
    Ok(())
}

fn is_comment(line: &[u8]) -> bool {
    line.first().is_some_and(|byte| COMMENT.contains(byte))
}

/// A line without a comment at its end, the brackets of a matrix and what ends its rows.
fn bare(line: &[u8]) -> &[u8] {
    let mut before = b'a';
    let mut parts = line.split(|byte| {
        let begins = before.is_ascii_whitespace() && b"#!%".contains(byte);
        before = *byte;
        begins
    });
    let line = parts.next().unwrap_or(line).trim_ascii();
    // Of `name = [` the bracket is left
    let bracket = line.iter().position(|byte| b"[({".contains(byte));
    let value = bracket.filter(|at| line.iter().take(*at).any(|byte| *byte == b'='));
    let line = value.and_then(|at| line.get(at..)).unwrap_or(line);
    let line = match line {
        [rest @ .., b']' | b')' | b'}', b','] => rest,
        _ => line,
    };
    trimmed(line, b"[({", b"])};")
}

/// Finds the separator and the decimal point from the rows of a sample.
fn separator<F: Float>(text: &[u8]) -> (Separator, u8) {
    let rows = Lines::new(text).take(SAMPLE).map(bare);
    let rows = rows.filter(|row| !is_comment(row) && begins_as_number(row));
    let count = |is: fn(&[u8]) -> bool| rows.clone().filter(|row| is(row)).count();
    let all = count(|_| true);
    let has_points = count(|row| row.contains(&b'.')) > 0;
    let comma = Separator::Character(b',');
    if count(|row| row.contains(&b';')) > all / 2 {
        return (Separator::Character(b';'), if has_points { b'.' } else { b',' });
    }
    let is_within = |three: &[u8]| matches!(three, [b'0'..=b'9', b',', b'0'..=b'9']);
    let within = rows.clone().filter(|row| row.windows(3).any(is_within)).count();
    if count(|row| row.contains(&b',')) <= all / 2 && within == 0 {
        return (Separator::Blank, b'.');
    }
    if count(|row| row.iter().filter(|byte| **byte == b'"').count() >= 4) == all {
        let has_comma = |row: &[u8]| {
            Words::of_line(row, Separator::Character(b','))
                .list
                .iter()
                .any(|cell| cell.contains(&b','))
        };
        return (comma, if count(has_comma) > 0 && !has_points { b',' } else { b'.' });
    }
    // Two or more words trimmed blanks, each a number with a decimal comma or a whole one
    let has_decimal_commas = |row: &[u8]| {
        let words = Words::of_line(row, Separator::Blank);
        words.count >= 2 && words.list.iter().all(|word| number::<F>(word, b',').is_some())
    };
    if count(has_decimal_commas) == all { (Separator::Blank, b',') } else { (comma, b'.') }
}

/// Finds the first row, and names and units in the lines before it; nothing for a text without
/// rows.
fn table<F: Float>(text: &[u8], header: &mut Header<F>) -> Result<Option<Table>, Error> {
    let (separator, point) = separator::<F>(text);
    let row = |line| {
        let words = Words::of_line(bare(line), separator);
        let is_number = |word: &[u8]| number::<F>(word, point).is_some();
        let is_cell = |word: &&[u8]| {
            let stands_for_none = |name: &&str| word.eq_ignore_ascii_case(name.as_bytes());
            is_number(word) || NO_NUMBERS.iter().any(stands_for_none)
        };
        let is_row =
            words.list.iter().any(|word| is_number(word)) && words.list.iter().all(is_cell);
        is_row.then_some(words.count)
    };
    let lines = Lines::new(text).enumerate();
    let mut lines = lines.filter(|(_, line)| !line.is_empty() && !is_comment(line));
    let mut has_text = false;
    while let Some((first, line)) = lines.next() {
        let Some(count) = row(line) else {
            has_text = true;
            continue;
        };
        let after = lines.clone().next().and_then(|(_, line)| row(line));
        if count == 1 && after.is_some_and(|count| count > 1) {
            // The number of the points
            header.is_left_out = true;
            continue;
        }
        let mut table = Table { separator, point, columns: [0, 1], count, is_named: false, first };
        table.name(text, header);
        Error::FileLine.when(count < 2)?;
        Error::FileColumns.when(count > 2 && !table.is_named)?;
        return Ok(Some(table));
    }
    Error::FileLine.when(has_text)?;
    Ok(None)
}

impl Table {
    /// Takes columns and the unit from the lines before the first row.
    fn name<F: Float>(&mut self, text: &[u8], header: &mut Header<F>) {
        for line in Lines::new(text).take(self.first).filter(|line| !line.is_empty()) {
            // Names are trimmed commas, semicolons or tabs, else trimmed blanks
            let bare = without(line, COMMENT);
            let separator = bare.iter().find(|byte| b";,\t".contains(byte));
            let separator = separator.map_or(Separator::Blank, |byte| Separator::Character(*byte));
            let words = Words::of_line(bare, separator);
            let place = |name: &str| {
                let is_name = |word: &[u8]| letters(word).eq_ignore_ascii_case(name.as_bytes());
                let mut places = (0..words.list.len()).filter(|k| is_name(words.word(*k)));
                places.next().filter(|_| places.next().is_none())
            };
            let names = NAMES.iter().find_map(|[y, z]| Some([place(y)?, place(z)?]));
            if let Some(columns) = names.filter(|_| words.count == self.count) {
                (self.columns, self.is_named) = (columns, true);
                header.unit = unit_of(line, true).or(header.unit);
            } else {
                header.unit = header.unit.or_else(|| unit_of(line, false));
            }
        }
    }
}

/// The letters that a name begins with.
fn letters(name: &[u8]) -> &[u8] {
    name.split(|byte| !byte.is_ascii_alphabetic()).next().unwrap_or(name)
}

/// The first unit of a line, in metres. In a comment only in brackets, and inches only there or
/// among names.
fn unit_of(line: &[u8], is_names: bool) -> Option<f64> {
    let mut next = 0;
    line.split(|byte| !byte.is_ascii_alphabetic()).find_map(|word| {
        let (first, end) = (next, next + word.len());
        next = end + 1;
        let around = (first.checked_sub(1).and_then(|k| line.get(k)), line.get(end));
        let is_in_brackets = matches!(around, (Some(b'[' | b'('), Some(b']' | b')')));
        let (name, unit) = UNITS.iter().find(|(name, _)| word == name.as_bytes())?;
        let is_alone = *name != "in" && !is_comment(line);
        (is_names || is_alone || is_in_brackets).then_some(*unit)
    })
}
