//! Lines, words and decimal numbers of a text, without a copy of it.

use crate::number::Float;
use heapless::Vec;

/// Words of a line that are kept; more are only counted.
const MOST_WORDS: usize = 16;
/// A number that is as large keeps no more digits.
const ENOUGH: f64 = 1e17;
/// Largest exponent of a number, beyond which it is infinite or zero.
const MOST_EXPONENT: i32 = 400;

/// The lines of a text, trimmed; empty ones too. A mark of the byte order at the beginning and what
/// follows the end mark of DOS are left out.
#[derive(Clone)]
pub(super) struct Lines<'a>(Option<&'a [u8]>);

impl<'a> Lines<'a> {
    pub(super) fn new(text: &'a [u8]) -> Self {
        let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
        Self(text.split(|byte| *byte == 0x1a).next())
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        let mut parts = self.0?.splitn(2, |byte| matches!(byte, b'\n' | b'\r'));
        let line = parts.next();
        self.0 = parts.next();
        line.map(<[u8]>::trim_ascii)
    }
}

/// How the words of a line are separated.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Separator {
    /// By spaces and tabs.
    Blank,
    /// By one character, and spaces around it do not count.
    Character(u8),
}

/// The words of a line: the first [`MOST_WORDS`] of them, and their number.
pub(super) struct Words<'a> {
    pub(super) list: Vec<&'a [u8], MOST_WORDS>,
    pub(super) count: usize,
}

impl<'a> Words<'a> {
    /// Splits a line. Quotation marks protect a separator, and are no part of a word. Empty words
    /// at the end of a line do not count.
    pub(super) fn of_line(line: &'a [u8], separator: Separator) -> Self {
        let mut words = Self { list: Vec::new(), count: 0 };
        let (mut is_quoted, mut filled) = (false, 0);
        let split = line.split(|byte| match separator {
            Separator::Blank => byte.is_ascii_whitespace(),
            Separator::Character(character) => {
                is_quoted ^= *byte == b'"';
                *byte == character && !is_quoted
            }
        });
        for word in split.filter(|word| separator != Separator::Blank || !word.is_empty()) {
            let word = without(word, b"\"");
            words.count += 1;
            // What does not fit is only counted.
            let _ = words.list.push(word);
            filled = if word.is_empty() { filled } else { words.count };
        }
        words.count = filled;
        words.list.truncate(filled);
        words
    }

    pub(super) fn word(&self, k: usize) -> &'a [u8] {
        self.list.get(k).copied().unwrap_or(b"")
    }
}

/// A text without these characters and without blanks at both ends.
pub(super) fn without<'a>(text: &'a [u8], characters: &[u8]) -> &'a [u8] {
    trimmed(text, characters, characters)
}

/// A text without blanks and some characters before it, and without blanks and others after it.
pub(super) fn trimmed<'a>(mut text: &'a [u8], before: &[u8], after: &[u8]) -> &'a [u8] {
    let is_one = |byte: &u8, of: &[u8]| byte.is_ascii_whitespace() || of.contains(byte);
    while let [first, rest @ ..] = text
        && is_one(first, before)
    {
        text = rest;
    }
    while let [rest @ .., last] = text
        && is_one(last, after)
    {
        text = rest;
    }
    text
}

/// Whether a line begins with a number, which may be in quotation marks.
pub(super) fn begins_as_number(line: &[u8]) -> bool {
    match without(line, b"\"+-") {
        [b'.' | b',', digit, ..] | [digit, ..] => digit.is_ascii_digit(),
        [] => false,
    }
}

/// A text up to the first of some characters.
pub(super) fn up_to<'a>(text: &'a [u8], characters: &[u8]) -> &'a [u8] {
    text.split(|byte| characters.contains(byte)).next().unwrap_or(text).trim_ascii()
}

/// The key and the value of `key = value`.
pub(super) fn pair(text: &[u8]) -> Option<(&[u8], &[u8])> {
    let mut parts = text.splitn(2, |byte| *byte == b'=');
    let (key, value) = (parts.next()?.trim_ascii(), parts.next()?);
    let begins = key.first().is_some_and(u8::is_ascii_alphabetic);
    let is_key = |byte: &u8| byte.is_ascii_alphanumeric() || b"_. ".contains(byte);
    (begins && key.iter().all(is_key)).then(|| (key, value.trim_ascii()))
}

/// A decimal number, with an exponent after `e` or Fortran's `d`; correct to rounding for up to 15
/// digits and exponents up to 22 in double precision, for 7 and 10 in single precision.
pub(super) fn number<F: Float>(word: &[u8], point: u8) -> Option<F> {
    let (is_negative, word) = sign(word);
    let mut parts = word.splitn(2, |byte| matches!(byte, b'e' | b'E' | b'd' | b'D'));
    let (mantissa, exponent) = (parts.next()?, parts.next());
    let (mut value, mut power, mut has_digit, mut has_point) = (F::zero(), 0_i32, false, false);
    for byte in mantissa {
        if byte.is_ascii_digit() {
            has_digit = true;
            if value < F::of(ENOUGH) {
                value = value.times(10.0) + F::widened(f32::from(byte & 15));
                power = power.saturating_sub(i32::from(has_point));
            } else {
                power = power.saturating_add(i32::from(!has_point));
            }
        } else if *byte == point && !has_point {
            has_point = true;
        } else {
            return None;
        }
    }
    let power = power.saturating_add(exponent.map_or(Some(0), whole)?);
    let value = times_power_of_ten(value, power.clamp(-MOST_EXPONENT, MOST_EXPONENT));
    has_digit.then_some(if is_negative { -value } else { value })
}

/// A whole number with a sign.
pub(super) fn whole(word: &[u8]) -> Option<i32> {
    let (is_negative, digits) = sign(word);
    let next = |value: i32, byte: &u8| {
        let digit = byte.is_ascii_digit().then_some(i32::from(byte & 15));
        digit.map(|digit| value.saturating_mul(10).saturating_add(digit))
    };
    let size = digits.iter().try_fold(0, next).filter(|_| !digits.is_empty())?;
    Some(if is_negative { -size } else { size })
}

/// Whether a number has a minus, and its rest.
fn sign(word: &[u8]) -> (bool, &[u8]) {
    match word {
        [sign @ (b'-' | b'+'), rest @ ..] => (*sign == b'-', rest),
        _ => (false, word),
    }
}

/// `value · 10^power`, with powers that are exact as far as they go.
fn times_power_of_ten<F: Float>(mut value: F, power: i32) -> F {
    let exact = if size_of::<F>() == 8 { 22 } else { 10 };
    let mut left = if value > F::zero() { power.abs() } else { 0 };
    while left > 0 {
        let now = left.min(exact);
        left -= now;
        let factor = (0..now).fold(F::one(), |factor, _| factor.times(10.0));
        value = if power > 0 { value * factor } else { value / factor };
    }
    value
}
