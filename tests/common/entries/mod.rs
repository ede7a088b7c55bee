//! Every C function with arbitrary bytes as its arguments, and what must hold whatever they are.
//!
//! Used by the libFuzzer targets of `fuzz/` and by `tests/interface/fuzz_properties.rs`. The first
//! byte chooses the function and its precision, the others are its arguments. A function that the
//! header gets is added to one of the lists [`ENTRIES`](double::contacts::ENTRIES);
//! `tests/interface/fuzz_properties.rs` finds out if it is not.
//!
//! * A status below zero leaves every output as it was (they are filled with a pattern first), and
//!   any other status leaves what was not asked for.
//! * Another status means finite outputs.
//! * Models with a friction bound: `|F| ≤ μ N` and tractions `≤ μ Z`, up to rounding.
//! * TOTAL never gains energy.
//! * Reversed creepages give reversed forces, to the bit.
//! * Functions that share an answer give the same bits.
// The lists of checks are compiled once for each precision, and one of them has nothing to convert.
#![allow(clippy::duplicate_mod, clippy::useless_conversion, clippy::unnecessary_cast)]

use crate::places::{batch_from, no_batch, nowhere};
pub use crate::poison::poisoned;
use crate::poison::untouched as all_untouched;
use crate::structures;
use kstrip::ffi::types::{kstrip_options, kstrip_table};
use kstrip::ffi::*;
use kstrip::status::Warning;
use std::mem::MaybeUninit;

pub mod double;
pub mod single;

/// Arbitrary bytes as arguments. Past their end everything is zero.
pub struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn take<const N: usize>(&mut self) -> [u8; N] {
        let mut taken = [0; N];
        let count = N.min(self.0.len());
        taken[..count].copy_from_slice(&self.0[..count]);
        self.0 = &self.0[count..];
        taken
    }

    fn byte(&mut self) -> u8 {
        self.take::<1>()[0]
    }

    fn integer(&mut self) -> i32 {
        i32::from_le_bytes(self.take())
    }

    /// A number below `end`, which is at most 256.
    fn below(&mut self, end: usize) -> usize {
        usize::from(self.byte()) % end
    }

    /// A model and a strip count that exist, mostly; any number, sometimes; NULL, rarely.
    fn options(&mut self) -> Option<kstrip_options> {
        let choice = self.byte();
        match choice {
            0..=7 => None,
            8..=15 => Some(kstrip_options { model: self.integer(), strips: self.integer() }),
            _ => Some(kstrip_options {
                model: i32::from(choice % 6),
                strips: [0, 4, 8, 16, 32, 64][usize::from(choice / 6 % 6)],
            }),
        }
    }

    /// A strip count that exists, mostly.
    fn strips(&mut self) -> i32 {
        match self.byte() {
            0..=7 => self.integer(),
            choice => 4 << (choice % 5),
        }
    }

    /// Which of up to eight pointers are given: all of them in fifteen of sixteen cases.
    fn given(&mut self) -> Given {
        let choice = self.byte();
        Given(if choice < 16 { self.byte() } else { 0xff })
    }
}

/// Which pointers of a call are given; the others are NULL.
#[derive(Clone, Copy)]
struct Given(u8);

impl Given {
    fn has(self, argument: u8) -> bool {
        self.0 >> argument & 1 == 1
    }

    /// The first `count` arguments.
    fn all(self, count: u8) -> bool {
        (0..count).all(|argument| self.has(argument))
    }

    fn input<T>(self, argument: u8, value: &T) -> Option<&T> {
        self.has(argument).then_some(value)
    }

    fn output<T>(self, argument: u8, value: &mut MaybeUninit<T>) -> Option<&mut MaybeUninit<T>> {
        self.has(argument).then_some(value)
    }

    fn array<T>(self, argument: u8, values: &[T]) -> *const T {
        if self.has(argument) { values.as_ptr() } else { std::ptr::null() }
    }

    /// A place to be filled, as a pointer.
    fn place<T>(self, argument: u8, value: &mut MaybeUninit<T>) -> *mut T {
        if self.has(argument) { value.as_mut_ptr() } else { std::ptr::null_mut() }
    }

    /// An array to be filled; its elements are numbers or structures of C.
    fn places<T>(self, argument: u8, values: &mut [MaybeUninit<T>]) -> *mut T {
        if self.has(argument) { values.as_mut_ptr().cast() } else { std::ptr::null_mut() }
    }
}

/// As many of them.
fn poisoned_array<T, const N: usize>() -> [MaybeUninit<T>; N] {
    std::array::from_fn(|_| poisoned())
}

/// Whether a value still has its pattern in every byte.
pub fn untouched<T>(value: &MaybeUninit<T>) -> bool {
    all_untouched(std::slice::from_ref(value))
}

/// What a call has written, if its status says so.
fn written<T: Copy>(value: &MaybeUninit<T>) -> T {
    assert!(!untouched(value), "nothing was written");
    // SAFETY: every byte has been set, at the latest by `poisoned`, and any bits are a value of a C
    // structure.
    unsafe { value.assume_init_read() }
}

/// A floating-point type that can be any bits.
pub trait Number: Copy + Into<f64> + PartialOrd {
    /// What rounding may add to a bound, relative.
    const ROUNDING: f64;
    /// The smallest normal number: below it there is no relative rounding.
    const SMALLEST: f64;
    /// An argument: any bit pattern, a special value, or an ordinary one around `scale`.
    fn of(bytes: &mut Bytes, scale: f64) -> Self;
    fn bits(self) -> u64;
    fn reversed(self) -> Self;
}

/// Zero, ends of the number range, not numbers.
const SPECIAL: [f64; 16] = [
    0.0, -0.0, 1.0, -1.0, 0.5, INFINITE, -INFINITE, NAN, MOST, LEAST, 5e-324, LARGE, LEAST_F32,
    1e-45, 1e150, 1e-150,
];
const INFINITE: f64 = f64::INFINITY;
const NAN: f64 = f64::NAN;
const MOST: f64 = f64::MAX;
const LEAST: f64 = f64::MIN_POSITIVE;
const LEAST_F32: f64 = f32::MIN_POSITIVE as f64;
const LARGE: f64 = f32::MAX as f64;

macro_rules! number {
    ($float:ident, $rounding:expr) => {
        impl Number for $float {
            const ROUNDING: f64 = $rounding;
            const SMALLEST: f64 = $float::MIN_POSITIVE as f64;
            fn of(bytes: &mut Bytes, scale: f64) -> Self {
                let choice = bytes.byte();
                match choice {
                    0..=7 => $float::from_le_bytes(bytes.take()),
                    8..=15 => SPECIAL[bytes.below(16)] as $float,
                    // 16 bits of mantissa over an octave, and a few octaves either way
                    _ => {
                        let fraction = f64::from(u16::from_le_bytes(bytes.take())) / 65536.0;
                        let octave = f64::from(i32::from(choice / 2 % 16) - 12);
                        let size = scale * (1.0 + fraction) * octave.exp2();
                        (if choice.is_multiple_of(2) { size } else { -size }) as $float
                    }
                }
            }
            fn bits(self) -> u64 {
                self.to_bits().into()
            }
            fn reversed(self) -> Self {
                -self
            }
        }
    };
}

// Products and sums of a bound and its share of the forces round a handful of times.
number!(f64, 1e-12);
number!(f32, 2e-6);

/// An argument that must not be negative, and is so only now and then.
fn positive<N: Number>(bytes: &mut Bytes, scale: f64) -> N {
    let value = N::of(bytes, scale);
    if value.into() < 0.0 && !bytes.byte().is_multiple_of(16) { value.reversed() } else { value }
}

fn finite<N: Number>(numbers: &[N]) -> bool {
    numbers.iter().all(|&number| number.into().is_finite())
}

/// A status that the header defines.
fn known(status: i32) -> bool {
    status == 0 || kstrip::status::advice(status).is_some()
}

/// Status and outputs of a call agree. Returns whether there is an answer.
#[track_caller]
fn answered(status: i32, outputs_untouched: bool) -> bool {
    assert!(known(status), "status {status}");
    assert!(status >= 0 || outputs_untouched, "status {status} and something written");
    status >= 0
}

/// A call with some inputs, any of which may be missing, and one output after them: the status and
/// what was written, if it is an answer.
#[track_caller]
fn asked<T: Copy>(
    bytes: &mut Bytes, inputs: u8, call: impl FnOnce(Given, Option<&mut MaybeUninit<T>>) -> i32,
) -> Option<(i32, T)> {
    let given = bytes.given();
    let mut out = poisoned();
    let status = call(given, given.output(inputs, &mut out));
    answered(status, untouched(&out)).then(|| {
        assert!(given.all(inputs + 1));
        (status, written(&out))
    })
}

/// A function with its checks.
pub type Entry = (&'static str, fn(&mut Bytes));

/// The functions of a precision.
fn entry(lists: [&'static [Entry]; 6], mut choice: usize) -> Entry {
    choice %= lists.iter().map(|list| list.len()).sum::<usize>();
    for list in lists {
        match list.get(choice) {
            Some(entry) => return *entry,
            None => choice -= list.len(),
        }
    }
    unreachable!()
}

/// The checks that a first byte names.
pub fn chosen(choice: u8) -> Entry {
    let lists = if choice < 128 {
        [
            double::contacts::ENTRIES,
            double::arrays::ENTRIES,
            double::patches::ENTRIES,
            double::arguments::ENTRIES,
            double::wheels::ENTRIES,
            double::tables::ENTRIES,
        ]
    } else {
        [
            single::contacts::ENTRIES,
            single::arrays::ENTRIES,
            single::patches::ENTRIES,
            single::arguments::ENTRIES,
            single::wheels::ENTRIES,
            single::tables::ENTRIES,
        ]
    };
    entry(lists, usize::from(choice % 128))
}

/// Calls the function that the first byte names, in one precision or the other, with the rest.
pub fn any_entry(data: &[u8]) {
    let mut bytes = Bytes(data);
    let (name, check) = chosen(bytes.byte());
    let _name = Named(name);
    check(&mut bytes);
}

/// Tells which function it was that failed.
struct Named(&'static str);

impl Drop for Named {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("checks of {}", self.0);
        }
    }
}

/// Calls `kstrip_solve` or `kstrip_solve_f32`.
pub fn solve_entry(data: &[u8]) {
    let mut bytes = Bytes(data);
    let single = bytes.byte() % 2 == 1;
    let check = if single { single::contacts::solve } else { double::contacts::solve };
    check(&mut bytes);
}
