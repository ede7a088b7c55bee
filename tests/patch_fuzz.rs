//! The C functions of patches with numbers of any kind, in both precisions: an error leaves every output as
//! it was, and anything else is finite and within its bound.

#[path = "common/entries.rs"]
mod entries;
#[path = "common/random.rs"]
mod random;

use entries::{poisoned, untouched};
use kstrip::ffi::patch::*;
use kstrip::ffi::patch_single::*;
use kstrip::ffi::patch_types::*;
use kstrip::ffi::types::*;
use kstrip::ffi::types_f32::*;
use kstrip::ffi::*;
use random::Random;
use std::mem::MaybeUninit;

/// `KSTRIP_FUZZ_CASES` as in `tests/fuzz_properties.rs`.
fn cases() -> u32 {
    std::env::var("KSTRIP_FUZZ_CASES").ok().and_then(|text| text.parse().ok()).unwrap_or(6_000)
}

/// Mostly near `scale`, sometimes far from it, rarely special or any bits.
fn number(random: &mut Random, scale: f64) -> f64 {
    const SPECIAL: [f64; 10] = [
        0.0,
        -1.0,
        f64::NAN,
        f64::INFINITY,
        f64::MAX,
        f64::MIN_POSITIVE,
        5e-324,
        f32::MAX as f64,
        f32::MIN_POSITIVE as f64,
        1e-45,
    ];
    match random.bits() % 64 {
        0 => SPECIAL[(random.bits() % 10) as usize],
        1 => f64::from_bits(random.bits()),
        2 => f64::from(f32::from_bits(random.bits() as u32)),
        3..=8 => scale * random.log_between(1e-15, 1e15),
        _ => scale * random.log_between(0.1, 10.0),
    }
}

/// Either sign.
fn signed(random: &mut Random, scale: f64) -> f64 {
    number(random, scale) * random.sign()
}

macro_rules! precision {
    (
        $test:ident, $float:ident, $rounding:expr, $strip:ident, $patch:ident, $summary:ident, $creepage:ident,
        $result:ident, $share:ident, $point:ident, $contact:ident, $found:ident, $from_strips:ident,
        $from_profile:ident, $summarize:ident, $solve:ident, $jacobian:ident, $strips:ident, $field:ident
    ) => {
        #[test]
        fn $test() {
            let mut random = Random::new(471);
            let random = &mut random;
            let (mut patches, mut answers) = (0, 0);
            for _ in 0..cases() {
                let mut out = poisoned::<$patch>();
                let modulus = number(random, 82e9) as $float;
                let ratio = (0.3 * random.unit()) as $float;
                let status = if random.bits() % 4 == 0 {
                    profile(random, modulus, ratio, &mut out)
                } else {
                    list(random, modulus, ratio, &mut out)
                };
                if status < 0 {
                    assert!(untouched(&out), "{status}");
                    continue;
                }
                patches += 1;
                // SAFETY: written, as the status says.
                let mut patch = unsafe { out.assume_init() };
                // What a caller may do to a patch
                match random.bits() % 40 {
                    0 => patch.strips[0].friction = number(random, 0.3) as $float,
                    1 => patch.strips[1].half_length = number(random, 5e-3) as $float,
                    2 => patch.count = random.bits() as u32,
                    3 => patch.lever_scale = number(random, 1.0) as $float,
                    _ => {}
                }
                answers += u32::from(solved(random, &patch));
            }
            println!("{patches} patches, {answers} answers");
            assert!(patches > 1000 && answers > 1000);

            fn list(
                random: &mut Random,
                modulus: $float,
                ratio: $float,
                out: &mut MaybeUninit<$patch>,
            ) -> i32 {
                let count = random.bits() % 7;
                let mut y = signed(random, 1e-2);
                let width = number(random, 1e-3);
                let strips: Vec<$strip> = (0..count)
                    .map(|_| {
                        let own = width * random.between(0.5, 1.5);
                        y += own * if random.bits() % 4 == 0 { 3.0 } else { 1.0 };
                        $strip {
                            y: y as $float,
                            width: own as $float,
                            half_length: number(random, 5e-3) as $float,
                            centre_x: if random.bits() % 2 == 0 {
                                0.0
                            } else {
                                signed(random, 1e-3) as $float
                            },
                            peak_pressure: number(random, 1e9) as $float,
                            friction: number(random, 0.3) as $float,
                        }
                    })
                    .collect();
                // SAFETY: as many strips as the count says.
                unsafe { $from_strips(strips.as_ptr(), count as u32, modulus, ratio, Some(out)) }
            }

            fn profile(
                random: &mut Random,
                modulus: $float,
                ratio: $float,
                out: &mut MaybeUninit<$patch>,
            ) -> i32 {
                let points = random.bits() % 12;
                let step = number(random, 2e-3);
                let depth = number(random, 1e-4);
                let mut y = signed(random, 1e-2);
                let (y, distance): (Vec<$float>, Vec<$float>) = (0..points)
                    .map(|i| {
                        y += step * random.between(0.1, 2.0);
                        let s = i as f64 - points as f64 / 2.0;
                        let distance = depth * (s * s / 4.0 + random.between(0.0, 2.0));
                        let odd = random.bits() % 200 == 0;
                        (y as $float, if odd { signed(random, depth) } else { distance } as $float)
                    })
                    .unzip();
                let contact = $contact {
                    rolling_radius: number(random, 0.5) as $float,
                    normal_force: number(random, 5e4) as $float,
                    shear_modulus: modulus,
                    poisson_ratio: ratio,
                    friction: number(random, 0.3) as $float,
                };
                let mut found = poisoned::<$found>();
                // SAFETY: as many points as the count says.
                let status = unsafe {
                    $from_profile(
                        y.as_ptr(),
                        distance.as_ptr(),
                        points as u32,
                        Some(&contact),
                        4 << (random.bits() % 5),
                        Some(out),
                        Some(&mut found),
                    )
                };
                if status < 0 {
                    assert!(untouched(&found), "{status}");
                    return status;
                }
                // SAFETY: written, as the status says.
                let (patch, found) = unsafe { (out.assume_init_ref(), found.assume_init()) };
                let numbers = [found.penetration, found.peak_pressure, found.normal_force];
                assert!(
                    numbers.iter().all(|x| x.is_finite() && *x >= 0.0),
                    "{contact:?} {found:?}"
                );
                assert!(found.iterations <= 60, "{found:?}");
                let mut sums = poisoned::<$summary>();
                assert_eq!($summarize(Some(patch), Some(&mut sums)), 0, "{contact:?}");
                // SAFETY: written, as the status says.
                let sums = unsafe { sums.assume_init() };
                let (load, reached) = (f64::from(sums.normal_force), f64::from(found.normal_force));
                assert!(
                    (load - reached).abs() <= 1e2 * $rounding * reached + 1e-30,
                    "{sums:?} {found:?}"
                );
                status
            }

            fn solved(random: &mut Random, patch: &$patch) -> bool {
                let motion = $creepage {
                    longitudinal: signed(random, 1e-3) as $float,
                    lateral: signed(random, 1e-3) as $float,
                    spin: signed(random, 0.5) as $float,
                };
                let options = kstrip_options { model: 1 + (random.bits() % 3) as i32, strips: 16 };
                let (patch, k, o) = (Some(patch), Some(&motion), Some(&options));
                let mut sums = poisoned::<$summary>();
                let mut result = poisoned::<$result>();
                let mut linear = poisoned::<$result>();
                let mut entries = poisoned::<[$float; 9]>();
                let mut shares = poisoned::<[$share; 64]>();
                let mut count = poisoned::<u32>();
                let mut points = poisoned::<[$point; 9]>();
                let checked = $summarize(patch, Some(&mut sums));
                let status = $solve(patch, k, o, Some(&mut result));
                // SAFETY: arrays of the sizes given.
                let (of_jacobian, of_strips) = unsafe {
                    (
                        $jacobian(patch, k, o, Some(&mut linear), entries.as_mut_ptr().cast()),
                        $strips(patch, k, o, shares.as_mut_ptr().cast(), 64, Some(&mut count)),
                    )
                };
                let strip = patch.map(|patch| patch.strips[(random.bits() % 6) as usize]);
                let (x, y, half) =
                    strip.map_or((0.0, 0.0, 0.0), |s| (s.centre_x, s.y, s.half_length));
                let (x, y) = ([x - half / 2.0, x, x + half], [y, y * 1.0001, y + half]);
                // SAFETY: three numbers each, nine points.
                let of_field = unsafe {
                    $field(patch, k, o, x.as_ptr(), 3, y.as_ptr(), 3, points.as_mut_ptr().cast(), 9)
                };
                assert_eq!(status, of_strips, "{patch:?} {motion:?} {options:?}");
                assert!(of_jacobian == status || of_jacobian == KSTRIP_ERROR_OVERFLOW);
                assert!(checked >= 0 || status == checked, "{checked} {status}");
                let clean = untouched(&result) && untouched(&shares) && untouched(&count);
                assert_eq!(status < 0, clean, "{status}");
                assert_eq!(of_jacobian < 0, untouched(&linear) && untouched(&entries));
                assert_eq!(of_field < 0, untouched(&points));
                if status < 0 {
                    return false;
                }
                // SAFETY: written, as the statuses say.
                let (r, sums) = unsafe { (result.assume_init(), sums.assume_init()) };
                let numbers = [r.fx, r.fy, r.mz, r.power, r.adhesion];
                assert!(numbers.iter().all(|x| x.is_finite()), "{patch:?} {motion:?} {r:?}");
                let bound = f64::from(sums.friction_bound) * (1.0 + $rounding);
                let size = f64::from(r.fx).hypot(f64::from(r.fy));
                let tiny = 64.0 * f64::from($float::MIN_POSITIVE);
                assert!(size <= bound + tiny, "{patch:?} {motion:?} {options:?} {r:?} {sums:?}");
                assert!((0.0..=1.0).contains(&r.adhesion), "{r:?}");
                if of_jacobian >= 0 {
                    // SAFETY: written, as the status says.
                    let entries = unsafe { entries.assume_init() };
                    assert!(entries.iter().all(|x| x.is_finite()), "{entries:?}");
                }
                // SAFETY: the first `count` are written.
                let count = unsafe { count.assume_init() } as usize;
                assert_eq!(Some(count), patch.map(|patch| patch.count as usize));
                let written = shares.as_ptr().cast::<$share>();
                for i in 0..count {
                    // SAFETY: within the first `count`.
                    let s = unsafe { written.add(i).read() };
                    let numbers = [s.separatrix, s.fx, s.fy, s.mz, s.power];
                    assert!(numbers.iter().all(|x| x.is_finite()), "{patch:?} {motion:?} {s:?}");
                }
                if of_field >= 0 {
                    // SAFETY: written, as the status says.
                    for p in unsafe { points.assume_init() } {
                        let numbers = [p.pressure, p.traction_x, p.traction_y, p.slip_x, p.slip_y];
                        assert!(
                            numbers.iter().all(|x| x.is_finite()),
                            "{patch:?} {motion:?} {options:?} {p:?}"
                        );
                    }
                }
                true
            }
        }
    };
}

precision!(
    any_numbers_in_double_precision,
    f64,
    1e-12,
    kstrip_patch_strip,
    kstrip_patch,
    kstrip_patch_summary,
    kstrip_creepage,
    kstrip_result,
    kstrip_strip,
    kstrip_point,
    kstrip_profile_contact,
    kstrip_profile_result,
    kstrip_patch_from_strips,
    kstrip_patch_from_profile,
    kstrip_patch_summarize,
    kstrip_patch_solve,
    kstrip_patch_jacobian,
    kstrip_patch_strips,
    kstrip_patch_field
);

precision!(
    any_numbers_in_single_precision,
    f32,
    3e-6,
    kstrip_patch_strip_f32,
    kstrip_patch_f32,
    kstrip_patch_summary_f32,
    kstrip_creepage_f32,
    kstrip_result_f32,
    kstrip_strip_f32,
    kstrip_point_f32,
    kstrip_profile_contact_f32,
    kstrip_profile_result_f32,
    kstrip_patch_from_strips_f32,
    kstrip_patch_from_profile_f32,
    kstrip_patch_summarize_f32,
    kstrip_patch_solve_f32,
    kstrip_patch_jacobian_f32,
    kstrip_patch_strips_f32,
    kstrip_patch_field_f32
);
