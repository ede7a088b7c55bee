//! Every C function with arbitrary bytes as its arguments, and what must hold whatever they are.
//!
//! Used by the libFuzzer targets of `fuzz/` and by `tests/fuzz_properties.rs`. A function that the header gets
//! is added to the list at the end of [`precision`].
//!
//! * A status below zero leaves every output as it was (they are filled with a pattern first).
//! * Another status means finite outputs.
//! * Models with a friction bound: `|F| ≤ μ N` and tractions `≤ μ Z`, up to rounding.
//! * TOTAL never gains energy.
//! * Reversed creepages give reversed forces, to the bit.
#![allow(dead_code)]

use kstrip::ffi::types::kstrip_options;
use kstrip::ffi::*;
use std::mem::MaybeUninit;

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

    /// A model and a strip count that exist, mostly; any number, sometimes; NULL, rarely.
    fn options(&mut self) -> Option<kstrip_options> {
        let choice = self.byte();
        match choice {
            0..=7 => None,
            8..=31 => Some(kstrip_options {
                model: i32::from_le_bytes(self.take()),
                strips: i32::from_le_bytes(self.take()),
            }),
            _ => Some(kstrip_options {
                model: 1 + i32::from(choice % 5),
                strips: 4 << (choice / 5 % 5),
            }),
        }
    }

    /// Present in all but one of 32 cases.
    fn present(&mut self) -> bool {
        self.byte() % 32 != 1
    }
}

/// The pattern that outputs have before a call.
const POISON: u8 = 0xA5;

/// A value filled with the pattern.
pub fn poisoned<T>() -> MaybeUninit<T> {
    let mut value = MaybeUninit::uninit();
    // SAFETY: any bytes are a MaybeUninit.
    unsafe { std::ptr::write_bytes(&mut value, POISON, 1) };
    value
}

/// Whether a value still has its pattern in every byte.
///
/// The structures of the C interface have no padding.
pub fn untouched<T>(value: &MaybeUninit<T>) -> bool {
    // SAFETY: every byte was set by `poisoned` or by a write of a structure without padding.
    let bytes = unsafe {
        std::slice::from_raw_parts(std::ptr::from_ref(value).cast::<u8>(), size_of::<T>())
    };
    bytes.iter().all(|&byte| byte == POISON)
}

/// A floating-point type that can be any bits.
pub trait Number: Copy + Into<f64> + PartialOrd {
    /// What rounding may add to a bound, relative.
    const ROUNDING: f64;
    /// An argument: any bit pattern, a special value, or an ordinary one around `scale`.
    fn of(bytes: &mut Bytes, scale: f64) -> Self;
    fn bits(self) -> u64;
    fn reversed(self) -> Self;
}

/// Zero, ends of the number range, not numbers.
const SPECIAL: [f64; 16] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    f64::MAX,
    f64::MIN_POSITIVE,
    5e-324,
    f32::MAX as f64,
    f32::MIN_POSITIVE as f64,
    1e-45,
    1e150,
    1e-150,
];

macro_rules! number {
    ($float:ident, $rounding:expr) => {
        impl Number for $float {
            const ROUNDING: f64 = $rounding;
            fn of(bytes: &mut Bytes, scale: f64) -> Self {
                let choice = bytes.byte();
                match choice {
                    0..=15 => $float::from_le_bytes(bytes.take()),
                    16..=31 => SPECIAL[usize::from(choice - 16)] as $float,
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

fn positive<N: Number>(bytes: &mut Bytes, scale: f64) -> N {
    let value = N::of(bytes, scale);
    // Ordinary values of quantities that must not be negative are positive three times in four.
    if value.into() < 0.0 && !bytes.byte().is_multiple_of(4) { value.reversed() } else { value }
}

/// A status that the header knows.
fn known(status: i32) -> bool {
    (KSTRIP_ERROR_LOWEST..=KSTRIP_WARNING_BEYOND_FRICTION).contains(&status)
}

/// The lowest error of the header: found by asking for texts, so that a new one needs no change here.
const KSTRIP_ERROR_LOWEST: i32 = {
    let mut status = -1;
    while kstrip::status::advice(status - 1).is_some() {
        status -= 1;
    }
    status
};

/// Status and outputs of a call agree.
fn consistent(status: i32, outputs_untouched: bool, outputs_finite: impl FnOnce() -> bool) {
    assert!(known(status), "status {status}");
    if status < 0 {
        assert!(outputs_untouched, "status {status} and something written");
    } else {
        assert!(outputs_finite(), "status {status} and an output that is no number");
    }
}

/// All checks of one precision.
macro_rules! precision {
    (
        $name:ident, $float:ident, $functions:ident, $types:ident,
        $material:ident, $combined:ident, $radii:ident, $ellipse:ident, $velocity:ident, $creepage:ident,
        $contact:ident, $parameters:ident, $result:ident, $strip:ident, $point:ident,
        $from_young:ident, $combine:ident, $hertz:ident, $from_velocities:ident, $to_parameters:ident,
        $from_parameters:ident, $solve:ident, $jacobian:ident, $batch:ident, $strips:ident, $at:ident,
        $field:ident, $upper:ident, $total:ident, $linear:ident, $strip_1967:ident, $strip_model:ident
    ) => {
        pub mod $name {
            use super::*;
            use kstrip::ffi::per_model::*;
            use kstrip::ffi::$functions::*;
            use kstrip::ffi::$types::*;

            fn finite(numbers: &[$float]) -> bool {
                numbers.iter().all(|number| number.is_finite())
            }

            fn contact(bytes: &mut Bytes) -> $contact {
                // Both axes from one size, so that the shape is ordinary more often than not.
                let a: $float = positive(bytes, 5e-3);
                $contact {
                    a,
                    b: positive(bytes, 5e-3),
                    normal_force: positive(bytes, 5e5),
                    shear_modulus: positive(bytes, 82e10),
                    poisson_ratio: positive(bytes, 0.3),
                    friction: positive(bytes, 1.0),
                }
            }

            fn creepage(bytes: &mut Bytes) -> $creepage {
                $creepage {
                    longitudinal: Number::of(bytes, 1e-2),
                    lateral: Number::of(bytes, 1e-2),
                    spin: Number::of(bytes, 3.0),
                }
            }

            fn numbers_of(r: &$result) -> [$float; 5] {
                [r.fx, r.fy, r.mz, r.power, r.adhesion]
            }

            fn reversed(k: &$creepage) -> $creepage {
                $creepage { longitudinal: -k.longitudinal, lateral: -k.lateral, spin: -k.spin }
            }

            /// What holds for every result.
            fn plausible(contact: &$contact, k: &$creepage, model: i32, status: i32, r: &$result) {
                assert_eq!((r.status_detail, r.reserved), (status, 0));
                let rounding = <$float as Number>::ROUNDING;
                let bound = f64::from(contact.friction) * f64::from(contact.normal_force);
                let (fx, fy) = (f64::from(r.fx), f64::from(r.fy));
                if model != KSTRIP_MODEL_LINEAR {
                    // the smallest numbers have no relative rounding
                    let tiny = 4.0 * f64::from(<$float>::MIN_POSITIVE);
                    assert!(
                        fx.hypot(fy) <= bound * (1.0 + rounding) + tiny,
                        "{contact:?} {k:?} {r:?}"
                    );
                }
                let in_range = (0.0..=1.0).contains(&r.adhesion);
                assert!(in_range || (model == KSTRIP_MODEL_TOTAL && r.adhesion == -1.0), "{r:?}");
                // Beyond these shapes single precision has no digits left for the small terms.
                let shapes = if <$float>::EPSILON > 1e-10 { 1e2 } else { 1e6 };
                let ratio = f64::from(contact.a) / f64::from(contact.b);
                if model == KSTRIP_MODEL_TOTAL && (1.0 / shapes..=shapes).contains(&ratio) {
                    let terms = (f64::from(r.fx) * f64::from(k.longitudinal)).abs()
                        + (f64::from(r.fy) * f64::from(k.lateral)).abs()
                        + (f64::from(r.mz) * f64::from(k.spin)).abs();
                    // A force below the smallest normal number has no relative rounding either.
                    let creepages = [k.longitudinal, k.lateral, k.spin].map(|x| f64::from(x).abs());
                    let tiny = 4.0
                        * f64::from(<$float>::MIN_POSITIVE)
                        * (1.0 + creepages.iter().sum::<f64>());
                    assert!(
                        f64::from(r.power) >= -rounding * terms - tiny,
                        "TOTAL gains energy: {contact:?} {k:?} {r:?}"
                    );
                }
            }

            /// One solve and everything that is known about it.
            pub fn solve_checked(
                contact: &$contact,
                k: &$creepage,
                options: Option<&kstrip_options>,
            ) {
                let mut out = poisoned::<$result>();
                let status = $solve(Some(contact), Some(k), options, Some(&mut out));
                // SAFETY: only read when the status says that it was written.
                let read = |out: &MaybeUninit<$result>| unsafe { out.assume_init_read() };
                consistent(status, untouched(&out), || {
                    let r = read(&out);
                    let numbers = finite(&numbers_of(&r));
                    assert!(numbers, "{contact:?} {k:?} {options:?} {r:?}");
                    numbers
                });
                if status < 0 {
                    return;
                }
                let r = read(&out);
                let model = options.map_or(KSTRIP_MODEL_STRIP, |options| options.model);
                plausible(contact, k, model, status, &r);
                let mut back = poisoned::<$result>();
                assert_eq!(
                    $solve(Some(contact), Some(&reversed(k)), options, Some(&mut back)),
                    status
                );
                let back = read(&back);
                assert!(
                    (back.fx, back.fy, back.mz) == (-r.fx, -r.fy, -r.mz)
                        && (back.power, back.adhesion) == (r.power, r.adhesion),
                    "reversed creepages: {contact:?} {k:?} {options:?} {r:?} {back:?}"
                );
            }

            fn solve(bytes: &mut Bytes) {
                let (contact, creepage) = (contact(bytes), creepage(bytes));
                let options = bytes.options();
                let given = (bytes.present(), bytes.present(), bytes.present());
                if given != (true, true, true) {
                    let mut out = poisoned::<$result>();
                    let status = $solve(
                        given.0.then_some(&contact),
                        given.1.then_some(&creepage),
                        options.as_ref(),
                        given.2.then_some(&mut out),
                    );
                    assert!(status < 0 && untouched(&out), "NULL gives {status}");
                    return;
                }
                solve_checked(&contact, &creepage, options.as_ref());
            }

            fn per_model(bytes: &mut Bytes) {
                let (contact, creepage) = (contact(bytes), creepage(bytes));
                let which = bytes.byte();
                let strips = match bytes.options() {
                    Some(options) => options.strips,
                    None => 16,
                };
                let (mut one, mut two) = (poisoned::<$result>(), poisoned::<$result>());
                let (c, k) = (Some(&contact), Some(&creepage));
                let (status, model, strips) = match which % 4 {
                    0 => ($total(c, k, Some(&mut one)), KSTRIP_MODEL_TOTAL, 16),
                    1 => ($linear(c, k, Some(&mut one)), KSTRIP_MODEL_LINEAR, 16),
                    2 => {
                        ($strip_1967(c, k, strips, Some(&mut one)), KSTRIP_MODEL_STRIP_1967, strips)
                    }
                    _ => ($strip_model(c, k, strips, Some(&mut one)), KSTRIP_MODEL_STRIP, strips),
                };
                let options = kstrip_options { model, strips };
                let same = $solve(c, k, Some(&options), Some(&mut two));
                // An error of the contact and one of the options may come in another order.
                assert_eq!(status < 0, same < 0);
                consistent(status, untouched(&one), || true);
                if status >= 0 {
                    // SAFETY: both written, as their statuses say.
                    let (one, two) = unsafe { (one.assume_init(), two.assume_init()) };
                    assert_eq!(
                        numbers_of(&one).map(Number::bits),
                        numbers_of(&two).map(Number::bits)
                    );
                }
            }

            fn jacobian(bytes: &mut Bytes) {
                let (contact, creepage) = (contact(bytes), creepage(bytes));
                let options = bytes.options();
                let (with_result, with_entries) = (bytes.present(), bytes.present());
                let mut out = poisoned::<$result>();
                let mut entries = poisoned::<[$float; 9]>();
                let pointer =
                    if with_entries { entries.as_mut_ptr().cast() } else { std::ptr::null_mut() };
                // SAFETY: NULL or nine numbers.
                let status = unsafe {
                    $jacobian(
                        Some(&contact),
                        Some(&creepage),
                        options.as_ref(),
                        with_result.then_some(&mut out),
                        pointer,
                    )
                };
                assert!(status < 0 || (with_result && with_entries));
                consistent(status, untouched(&out) && untouched(&entries), || {
                    // SAFETY: written, as the status says.
                    let (j, r) = unsafe { (entries.assume_init(), out.assume_init_read()) };
                    let numbers = finite(&j) && finite(&numbers_of(&r));
                    assert!(numbers, "{contact:?} {creepage:?} {options:?} {r:?} {j:?}");
                    numbers
                });
                if status >= 0 {
                    let model = options.map_or(KSTRIP_MODEL_STRIP, |options| options.model);
                    // SAFETY: written, as the status says.
                    plausible(&contact, &creepage, model, status, &unsafe { out.assume_init() });
                }
            }

            fn batch(bytes: &mut Bytes) {
                const MOST: usize = 4;
                let options = bytes.options();
                let count = bytes.byte() % 5;
                let contacts: [$contact; MOST] = std::array::from_fn(|_| contact(bytes));
                let creepages: [$creepage; MOST] = std::array::from_fn(|_| creepage(bytes));
                let given = [bytes.present(), bytes.present(), bytes.present()];
                let mut results: [_; MOST] = std::array::from_fn(|_| poisoned::<$result>());
                let one = if given[0] { contacts.as_ptr() } else { std::ptr::null() };
                let two = if given[1] { creepages.as_ptr() } else { std::ptr::null() };
                let out = if given[2] { results.as_mut_ptr().cast() } else { std::ptr::null_mut() };
                // SAFETY: NULL or four elements, and the count is not larger.
                let status = unsafe { $batch(one, two, count.into(), options.as_ref(), out) };
                assert!(status < 0 || count == 0 || given == [true; 3]);
                consistent(status, results.iter().all(untouched), || true);
                let mut worst = 0;
                for (i, result) in results.iter().enumerate() {
                    if status < 0 {
                        break;
                    }
                    if i >= count.into() {
                        assert!(untouched(result), "written past the count");
                        continue;
                    }
                    let mut single = poisoned::<$result>();
                    let of_one = $solve(
                        Some(&contacts[i]),
                        Some(&creepages[i]),
                        options.as_ref(),
                        Some(&mut single),
                    );
                    assert!(of_one >= 0);
                    worst = worst.max(of_one);
                    // SAFETY: both written, as their statuses say.
                    let (a, b) = unsafe { (result.assume_init_read(), single.assume_init()) };
                    assert_eq!(numbers_of(&a).map(Number::bits), numbers_of(&b).map(Number::bits));
                }
                assert!(status < 0 || status == worst);
            }

            fn strips(bytes: &mut Bytes) {
                let (contact, creepage) = (contact(bytes), creepage(bytes));
                let options = bytes.options();
                let capacity = usize::from(bytes.byte());
                let (with_array, with_count) = (bytes.present(), bytes.present());
                let mut array = [const { MaybeUninit::<$strip>::uninit() }; 256];
                array.iter_mut().for_each(|strip| *strip = poisoned());
                let mut count = poisoned::<u32>();
                let pointer =
                    if with_array { array.as_mut_ptr().cast() } else { std::ptr::null_mut() };
                // SAFETY: NULL or 256 elements, and the capacity is not larger.
                let status = unsafe {
                    $strips(
                        Some(&contact),
                        Some(&creepage),
                        options.as_ref(),
                        pointer,
                        capacity as u32,
                        with_count.then_some(&mut count),
                    )
                };
                let clean = untouched(&count) && array.iter().all(untouched);
                consistent(status, clean, || true);
                if status < 0 {
                    assert!(
                        status != KSTRIP_ERROR_CAPACITY
                            || capacity < KSTRIP_STRIPS_CAPACITY as usize
                    );
                    return;
                }
                // SAFETY: written, as the status says.
                let count = unsafe { count.assume_init() } as usize;
                assert!(with_count && count <= capacity && (with_array || count == 0));
                for (i, strip) in array.iter().enumerate() {
                    if i >= count {
                        assert!(untouched(strip), "written past the count");
                        continue;
                    }
                    // SAFETY: the first `count` are written.
                    let s = unsafe { strip.assume_init_read() };
                    let numbers =
                        [s.y, s.width, s.half_length, s.separatrix, s.fx, s.fy, s.mz, s.power];
                    assert!(finite(&numbers), "{contact:?} {creepage:?} {options:?} {s:?}");
                    assert!(s.y.abs() <= contact.b * (1.0 + 1e-5), "outside the contact: {s:?}");
                    assert!([KSTRIP_STATE_STICK, KSTRIP_STATE_SLIP].contains(&s.state));
                }
            }

            fn plausible_point(
                contact: &$contact,
                k: &$creepage,
                options: Option<&kstrip_options>,
                p: &$point,
            ) {
                let numbers =
                    [p.pressure, p.traction_x, p.traction_y, p.slip_x, p.slip_y, p.dissipation];
                assert!(finite(&numbers), "{contact:?} {k:?} {options:?} {p:?}");
                assert!(p.pressure >= 0.0 && p.reserved == 0, "{p:?}");
                let bound = f64::from(contact.friction) * f64::from(p.pressure);
                // The bound of a point next to the separatrix is a difference of square roots; its digits
                // are those of the peak.
                let peak = f64::from(contact.friction) * f64::from(contact.normal_force)
                    / f64::from(contact.a)
                    / f64::from(contact.b);
                let allowed = 1e3 * <$float as Number>::ROUNDING;
                let traction = f64::from(p.traction_x).hypot(p.traction_y.into());
                assert!(
                    traction <= bound + allowed * peak + 1e-30,
                    "{contact:?} {k:?} {options:?} {p:?}"
                );
                match p.state {
                    KSTRIP_STATE_OUTSIDE => assert!(numbers.iter().all(|&n| n == 0.0), "{p:?}"),
                    KSTRIP_STATE_STICK => assert!(p.slip_x == 0.0 && p.slip_y == 0.0, "{p:?}"),
                    KSTRIP_STATE_SLIP | KSTRIP_STATE_SLIP_NEGATIVE_DISSIPATION => {}
                    state => panic!("state {state}"),
                }
            }

            fn at(bytes: &mut Bytes) {
                let (contact, creepage) = (contact(bytes), creepage(bytes));
                let options = bytes.options();
                let (x, y) = (Number::of(bytes, 5e-3), Number::of(bytes, 5e-3));
                let with_point = bytes.present();
                let mut point = poisoned::<$point>();
                let status = $at(
                    Some(&contact),
                    Some(&creepage),
                    options.as_ref(),
                    x,
                    y,
                    with_point.then_some(&mut point),
                );
                consistent(status, untouched(&point), || with_point);
                if status >= 0 {
                    // SAFETY: written, as the status says.
                    let point = unsafe { point.assume_init() };
                    plausible_point(&contact, &creepage, options.as_ref(), &point);
                }
            }

            fn field(bytes: &mut Bytes) {
                const MOST: usize = 36;
                let (contact, creepage) = (contact(bytes), creepage(bytes));
                let options = bytes.options();
                let counts = bytes.byte();
                let (columns, rows) = (counts % 7, counts / 7 % 7);
                let capacity = bytes.byte() as usize % (MOST + 1);
                let places: [$float; 12] = std::array::from_fn(|_| Number::of(bytes, 5e-3));
                let given = [bytes.present(), bytes.present(), bytes.present()];
                let mut points: [_; MOST] = std::array::from_fn(|_| poisoned::<$point>());
                // Inputs may overlap each other.
                let x = if given[0] { places.as_ptr() } else { std::ptr::null() };
                let y = if given[1] {
                    places[usize::from(counts % 6)..].as_ptr()
                } else {
                    std::ptr::null()
                };
                let out = if given[2] { points.as_mut_ptr().cast() } else { std::ptr::null_mut() };
                // SAFETY: NULL or at least as many elements as the counts say.
                let status = unsafe {
                    $field(
                        Some(&contact),
                        Some(&creepage),
                        options.as_ref(),
                        x,
                        columns.into(),
                        y,
                        rows.into(),
                        out,
                        capacity as u32,
                    )
                };
                consistent(status, points.iter().all(untouched), || true);
                let needed = usize::from(columns) * usize::from(rows);
                for (i, point) in points.iter().enumerate() {
                    if status >= 0 && i < needed {
                        // SAFETY: written, as the status says.
                        let point = unsafe { point.assume_init_read() };
                        plausible_point(&contact, &creepage, options.as_ref(), &point);
                    } else {
                        assert!(untouched(point), "written past the grid");
                    }
                }
                assert!(status < 0 || needed <= capacity);
            }

            fn materials(bytes: &mut Bytes) {
                let modulus = positive(bytes, 82e9);
                let ratio = positive(bytes, 0.3);
                let mut out = poisoned::<$material>();
                let status = $from_young(modulus, ratio, bytes.present().then_some(&mut out));
                consistent(status, untouched(&out), || {
                    // SAFETY: written, as the status says.
                    let m = unsafe { out.assume_init_read() };
                    finite(&[m.shear_modulus, m.poisson_ratio])
                });
                let lower = $material { shear_modulus: modulus, poisson_ratio: ratio };
                let upper = $material {
                    shear_modulus: positive(bytes, 82e9),
                    poisson_ratio: positive(bytes, 0.3),
                };
                let mut out = poisoned::<$combined>();
                let status = $combine(
                    bytes.present().then_some(&lower),
                    bytes.present().then_some(&upper),
                    bytes.present().then_some(&mut out),
                );
                consistent(status, untouched(&out), || {
                    // SAFETY: written, as the status says.
                    let m = unsafe { out.assume_init_read() };
                    finite(&[m.shear_modulus, m.poisson_ratio, m.mismatch])
                        && m.shear_modulus > 0.0
                        && (0.0..=0.5).contains(&m.poisson_ratio)
                        && m.mismatch.abs() <= 0.5
                });
            }

            fn hertz(bytes: &mut Bytes) {
                let mut radius = || Number::of(bytes, 10.0);
                let radii = $radii {
                    lower_x: radius(),
                    lower_y: radius(),
                    upper_x: radius(),
                    upper_y: radius(),
                };
                let load = positive(bytes, 1e5);
                let material = $combined {
                    shear_modulus: positive(bytes, 82e9),
                    poisson_ratio: positive(bytes, 0.3),
                    mismatch: Number::of(bytes, 0.1),
                };
                let mut out = poisoned::<$ellipse>();
                let status = $hertz(
                    bytes.present().then_some(&radii),
                    load,
                    bytes.present().then_some(&material),
                    bytes.present().then_some(&mut out),
                );
                consistent(status, untouched(&out), || {
                    // SAFETY: written, as the status says.
                    let h = unsafe { out.assume_init_read() };
                    finite(&[h.a, h.b, h.peak_pressure, h.approach, h.hertz_angle, h.rho])
                        && h.a >= 0.0
                        && h.b >= 0.0
                        && h.axis_ratio > 0.0
                        && h.axis_ratio <= 1.0
                });
            }

            fn velocities(bytes: &mut Bytes) {
                let mut velocity = |scale: f64| $velocity {
                    x: Number::of(bytes, scale),
                    y: Number::of(bytes, 1.0),
                    angular_z: Number::of(bytes, 1.0),
                };
                let (lower, upper) = (velocity(-20.0), velocity(-20.0));
                let speed = positive(bytes, 20.0);
                let mut out = poisoned::<$creepage>();
                let status = $from_velocities(
                    bytes.present().then_some(&lower),
                    bytes.present().then_some(&upper),
                    speed,
                    bytes.present().then_some(&mut out),
                );
                consistent(status, untouched(&out), || {
                    // SAFETY: written, as the status says.
                    let k = unsafe { out.assume_init_read() };
                    finite(&[k.longitudinal, k.lateral, k.spin])
                });
            }

            fn parameters(bytes: &mut Bytes) {
                let (contact, creepage) = (contact(bytes), creepage(bytes));
                let mut out = poisoned::<$parameters>();
                let status = $to_parameters(
                    bytes.present().then_some(&contact),
                    bytes.present().then_some(&creepage),
                    bytes.present().then_some(&mut out),
                );
                consistent(status, untouched(&out), || {
                    // SAFETY: written, as the status says.
                    let p = unsafe { out.assume_init_read() };
                    finite(&[p.xi, p.eta, p.psi])
                });
                let wanted = $parameters {
                    xi: Number::of(bytes, 1.0),
                    eta: Number::of(bytes, 1.0),
                    psi: Number::of(bytes, 1.0),
                };
                let mut out = poisoned::<$creepage>();
                let status = $from_parameters(
                    bytes.present().then_some(&contact),
                    bytes.present().then_some(&wanted),
                    bytes.present().then_some(&mut out),
                );
                consistent(status, untouched(&out), || {
                    // SAFETY: written, as the status says.
                    let k = unsafe { out.assume_init_read() };
                    finite(&[k.longitudinal, k.lateral, k.spin])
                });
            }

            fn upper(bytes: &mut Bytes) {
                let lower = $result {
                    fx: Number::of(bytes, 1e3),
                    fy: Number::of(bytes, 1e3),
                    mz: Number::of(bytes, 1e3),
                    power: Number::of(bytes, 1e3),
                    adhesion: Number::of(bytes, 1.0),
                    status_detail: i32::from_le_bytes(bytes.take()),
                    reserved: i32::from_le_bytes(bytes.take()),
                };
                let (with_lower, with_upper) = (bytes.present(), bytes.present());
                let mut out = poisoned::<$result>();
                let status = $upper(with_lower.then_some(&lower), with_upper.then_some(&mut out));
                assert_eq!(status == 0, with_lower && with_upper);
                consistent(status, untouched(&out), || {
                    // SAFETY: written, as the status says. No number is computed: any bits pass through.
                    let u = unsafe { out.assume_init_read() };
                    u.power.bits() == lower.power.bits() && (-u.fx).bits() == lower.fx.bits()
                });
            }

            /// The functions, most of the time those that compute most.
            pub const ENTRIES: &[(&str, fn(&mut Bytes))] = &[
                ("solve", solve),
                ("per_model", per_model),
                ("jacobian", jacobian),
                ("batch", batch),
                ("strips", strips),
                ("at", at),
                ("field", field),
                ("materials", materials),
                ("hertz", hertz),
                ("velocities", velocities),
                ("parameters", parameters),
                ("upper", upper),
            ];
        }
    };
}

precision!(
    double_precision,
    f64,
    double,
    types,
    kstrip_material,
    kstrip_combined_material,
    kstrip_radii,
    kstrip_hertz_contact,
    kstrip_velocity,
    kstrip_creepage,
    kstrip_contact,
    kstrip_parameters,
    kstrip_result,
    kstrip_strip,
    kstrip_point,
    kstrip_material_from_youngs_modulus,
    kstrip_material_combine,
    kstrip_hertz,
    kstrip_creepage_from_velocities,
    kstrip_parameters_from_creepage,
    kstrip_creepage_from_parameters,
    kstrip_solve,
    kstrip_solve_jacobian,
    kstrip_solve_batch,
    kstrip_strips,
    kstrip_traction_at,
    kstrip_field,
    kstrip_result_on_upper_body,
    kstrip_solve_total,
    kstrip_solve_linear,
    kstrip_solve_strip_1967,
    kstrip_solve_strip
);

precision!(
    single_precision,
    f32,
    single,
    types_f32,
    kstrip_material_f32,
    kstrip_combined_material_f32,
    kstrip_radii_f32,
    kstrip_hertz_contact_f32,
    kstrip_velocity_f32,
    kstrip_creepage_f32,
    kstrip_contact_f32,
    kstrip_parameters_f32,
    kstrip_result_f32,
    kstrip_strip_f32,
    kstrip_point_f32,
    kstrip_material_from_youngs_modulus_f32,
    kstrip_material_combine_f32,
    kstrip_hertz_f32,
    kstrip_creepage_from_velocities_f32,
    kstrip_parameters_from_creepage_f32,
    kstrip_creepage_from_parameters_f32,
    kstrip_solve_f32,
    kstrip_solve_jacobian_f32,
    kstrip_solve_batch_f32,
    kstrip_strips_f32,
    kstrip_traction_at_f32,
    kstrip_field_f32,
    kstrip_result_on_upper_body_f32,
    kstrip_solve_total_f32,
    kstrip_solve_linear_f32,
    kstrip_solve_strip_1967_f32,
    kstrip_solve_strip_f32
);

/// Calls the function that the first byte names, in one precision or the other, with the rest.
pub fn any_entry(data: &[u8]) {
    let mut bytes = Bytes(data);
    let choice = usize::from(bytes.byte());
    let entries = if choice < 128 { double_precision::ENTRIES } else { single_precision::ENTRIES };
    let (_, entry) = entries[choice % 128 % entries.len()];
    entry(&mut bytes);
}

/// Calls `kstrip_solve` or `kstrip_solve_f32`.
pub fn solve_entry(data: &[u8]) {
    let mut bytes = Bytes(data);
    let single = bytes.byte() % 2 == 1;
    let entries = if single { single_precision::ENTRIES } else { double_precision::ENTRIES };
    (entries[0].1)(&mut bytes);
}
