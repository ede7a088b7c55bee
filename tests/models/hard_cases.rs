//! The hard cases by name, in Rust and through the C functions, in both precisions: each gives a right
//! answer or a named status, and an error leaves the outputs as they were.

use crate::names::*;
use crate::random::Random;
use crate::single;
use crate::theory;

use crate::C0;
use kstrip::contact::Contact;
use kstrip::contact::creepage::Creepage;
use kstrip::contact::forces::StripCount;
use kstrip::solve::model::{self, Field, Model};
use kstrip::status::{Error, Notice};
use kstrip::strip_1967::strip::State;
use single::{single, single_motion};
use std::f64::consts::PI;
use std::mem::MaybeUninit;
use theory::{Law, MODELS, contact, creepage, options};

const WHEEL: Contact<f64> = Contact { b: 4e-3, ..C0 };

const MOTION: Creepage<f64> = Creepage { longitudinal: 1e-3, lateral: -5e-4, spin: 0.2 };

fn motion(longitudinal: f64, lateral: f64, spin: f64) -> Creepage<f64> {
    Creepage { longitudinal, lateral, spin }
}

const POISON: u8 = 0xA5;

const FEW_AND_MANY: [StripCount; 2] = [StripCount::Four, StripCount::SixtyFour];

/// Memory for an output, filled with a pattern that no result has.
fn poisoned<T>() -> MaybeUninit<T> {
    let mut place = MaybeUninit::<T>::uninit();
    // SAFETY: bytes of a place that is ours.
    unsafe { std::ptr::write_bytes(place.as_mut_ptr().cast::<u8>(), POISON, size_of::<T>()) };
    place
}

fn untouched<T>(places: &[MaybeUninit<T>]) -> bool {
    // SAFETY: every byte was written by `poisoned`.
    let bytes = unsafe {
        std::slice::from_raw_parts(places.as_ptr().cast::<u8>(), std::mem::size_of_val(places))
    };
    bytes.iter().all(|&byte| byte == POISON)
}

/// A batch of one contact.
///
/// # Safety
/// None: all places are there.
unsafe fn batch_of_one(
    c: &kstrip_contact,
    m: &kstrip_creepage,
    options: &kstrip_options,
    out: &mut MaybeUninit<kstrip_result>,
) -> i32 {
    let (inputs, outputs) = (batch_inputs(c, m), batch_results(out.as_mut_ptr()));
    // SAFETY: the structures are there.
    unsafe { kstrip_evaluate_batch(Some(&inputs), 1, Some(options), Some(&outputs), None) }
}

/// Runs a case through every entry point in double precision and requires the same status from all;
/// errors must leave outputs untouched. Returns the forces of both rules in units of μN and μN√(ab).
fn everywhere(c: &Contact<f64>, m: &Creepage<f64>) -> Result<Vec<[f64; 4]>, i32> {
    let (cc, cm) = (*c, *m);
    let mut answers = Vec::new();
    let mut statuses = Vec::new();
    for kind in MODELS {
        for count in FEW_AND_MANY {
            let o = options(kind, count);
            let co = kstrip_options { model: kind as i32, strips: count as i32 };
            let expected = match model::solve(c, m, &o) {
                Ok(s) => s.notice.code(),
                Err(error) => error.code(),
            };
            statuses.push(expected);
            let mut result = [poisoned::<kstrip_result>()];
            let mut strips: Vec<_> = (0..192).map(|_| poisoned::<kstrip_strip>()).collect();
            let mut written = [poisoned::<u32>()];
            let mut point = [poisoned::<kstrip_point>()];
            let mut points: Vec<_> = (0..15).map(|_| poisoned::<kstrip_point>()).collect();
            let x =
                [-0.9, -0.3, 0.0, 0.3, 1.2].map(|f| f * if c.a.is_finite() { c.a } else { 1.0 });
            let y = [-0.5, 0.0, 0.7].map(|f| f * if c.b.is_finite() { c.b } else { 1.0 });

            let plain = kstrip_solve(Some(&cc), Some(&cm), Some(&co), Some(&mut result[0]));
            assert_eq!(plain, expected, "kstrip_solve {c:?} {m:?}");
            // SAFETY: all arrays have the sizes that the calls say.
            let (batch, strip_status, field) = unsafe {
                let mut one = [poisoned::<kstrip_result>()];
                let batch = batch_of_one(&cc, &cm, &co, &mut one[0]);
                if batch < 0 {
                    assert!(untouched(&one));
                } else {
                    let (p, q) = (one[0].assume_init(), result[0].assume_init());
                    assert!(p.fx.is_finite() && p.mz.is_finite(), "{c:?} {m:?} {co:?} {p:?}");
                    assert_eq!((p.fx, p.fy, p.mz, p.adhesion), (q.fx, q.fy, q.mz, q.adhesion));
                }
                (
                    batch,
                    kstrip_evaluate(
                        Some(&cc),
                        Some(&cm),
                        None,
                        Some(&co),
                        Some(&kstrip_outputs {
                            strips: strips.as_mut_ptr().cast(),
                            capacity: 192,
                            count: written[0].as_mut_ptr(),
                            ..nowhere()
                        }),
                    ),
                    kstrip_field(
                        Some(&cc),
                        Some(&cm),
                        Some(&co),
                        x.as_ptr(),
                        5,
                        y.as_ptr(),
                        3,
                        points.as_mut_ptr().cast(),
                        15,
                    ),
                )
            };
            // SAFETY: one point.
            let traction = unsafe {
                let (x, y, out) = (&raw const x[1], &raw const y[1], point.as_mut_ptr().cast());
                kstrip_field(Some(&cc), Some(&cm), Some(&co), x, 1, y, 1, out, 1)
            };
            assert_eq!([batch, strip_status, field, traction], [expected; 4], "{c:?} {m:?} {o:?}");
            let mut second = [poisoned::<kstrip_result>()];
            let mut slopes = [poisoned::<kstrip_derivatives>()];
            let mut by_law = [poisoned::<kstrip_law_derivatives>()];
            let outputs = kstrip_outputs {
                result: second[0].as_mut_ptr(),
                derivatives: slopes[0].as_mut_ptr(),
                law_derivatives: by_law[0].as_mut_ptr(),
                ..nowhere()
            };
            // SAFETY: the places are there.
            let jacobian =
                unsafe { kstrip_evaluate(Some(&cc), Some(&cm), None, Some(&co), Some(&outputs)) };
            if jacobian < 0 {
                assert!(untouched(&second) && untouched(&slopes) && untouched(&by_law));
            } else {
                // SAFETY: status >= 0 says written.
                let d = unsafe { slopes[0].assume_init() };
                let numbers = d.normal_force.iter().chain(&d.friction).chain(&d.load_through_hertz);
                assert!(d.jacobian.iter().flatten().chain(numbers).all(|v| v.is_finite()), "{d:?}");
            }
            // A derivative may be too large where the force is not.
            assert!(jacobian == expected || (expected >= 0 && jacobian == -14), "{c:?} {m:?}");
            if expected < 0 {
                assert!(untouched(&result) && untouched(&strips) && untouched(&written));
                assert!(untouched(&point) && untouched(&points));
                continue;
            }
            // SAFETY: status >= 0 says written.
            let (r, n) = unsafe { (result[0].assume_init(), written[0].assume_init() as usize) };
            assert!(
                [r.fx, r.fy, r.mz, r.power, r.adhesion].iter().all(|v| v.is_finite()),
                "{r:?} {c:?} {m:?}"
            );
            assert_eq!((r.notice.code(), r.reserved), (expected, 0));
            assert!((n > 0 || c.is_lost()) && n <= 192 && untouched(&strips[n..]), "{n}");
            let bound = c.friction * c.normal_force;
            for p in points.iter().chain(&point) {
                // SAFETY: written.
                let p = unsafe { p.assume_init() };
                assert!(
                    [p.pressure, p.traction_x, p.traction_y, p.slip_x, p.slip_y, p.dissipation]
                        .iter()
                        .all(|v| v.is_finite()),
                    "{p:?} {c:?} {m:?}"
                );
                let traction = p.traction_x.hypot(p.traction_y);
                assert!(
                    traction <= c.friction * p.pressure * (1.0 + 1e-7),
                    "{p:?} {c:?} {m:?} {o:?}"
                );
                assert!(p.reserved == 0);
            }
            let unit = if bound > 0.0 { bound } else { 1.0 };
            let mean = c.a.sqrt() * c.b.sqrt();
            assert!(r.fx.hypot(r.fy) <= bound * (1.0 + 1e-12), "{r:?}");
            let answer = [r.fx / unit, r.fy / unit, r.mz / unit / mean, r.adhesion];
            if count == StripCount::Four {
                answers.push(answer);
            } else {
                assert_eq!(answers.last(), Some(&answer), "any number of strips");
            }
        }
    }
    assert!(statuses.windows(2).all(|pair| pair[0] == pair[1]), "{statuses:?} {c:?} {m:?}");
    if statuses[0] < 0 { Err(statuses[0]) } else { Ok(answers) }
}

/// The single-precision twins: same status or, where f32 has no room, Overflow; finite and bounded.
fn everywhere_single(c: &Contact<f64>, m: &Creepage<f64>) -> Result<[f32; 3], i32> {
    let (c, m) = (single(c), single_motion(m));
    let (cc, cm) = (c, m);
    let mut last = Err(0);
    for kind in MODELS {
        for count in FEW_AND_MANY {
            let o = options(kind, count);
            let co = kstrip_options { model: kind as i32, strips: count as i32 };
            let core = model::solve(&c, &m, &o);
            let mut result = [poisoned::<kstrip_result_f32>()];
            let status = kstrip_solve_f32(Some(&cc), Some(&cm), Some(&co), Some(&mut result[0]));
            let mut point = [poisoned::<kstrip_point_f32>()];
            // SAFETY: one point.
            let at = unsafe {
                let (x, y, out) = (0.1 * c.a, 0.2 * c.b, point.as_mut_ptr().cast());
                kstrip_field_f32(Some(&cc), Some(&cm), Some(&co), &x, 1, &y, 1, out, 1)
            };
            let mut slopes = [poisoned::<kstrip_derivatives_f32>()];
            let mut second = [poisoned::<kstrip_result_f32>()];
            let outputs = kstrip_outputs_f32 {
                result: second[0].as_mut_ptr(),
                derivatives: slopes[0].as_mut_ptr(),
                ..nowhere()
            };
            // SAFETY: the places are there.
            let jacobian = unsafe {
                kstrip_evaluate_f32(Some(&cc), Some(&cm), None, Some(&co), Some(&outputs))
            };
            if jacobian < 0 {
                assert!(untouched(&second) && untouched(&slopes));
            }
            match core {
                Ok(s) => {
                    assert_eq!((status, at), (s.notice.code(), s.notice.code()));
                    // SAFETY: written.
                    let (r, p) = unsafe { (result[0].assume_init(), point[0].assume_init()) };
                    let numbers = [
                        r.fx,
                        r.fy,
                        r.mz,
                        r.power,
                        r.adhesion,
                        p.pressure,
                        p.traction_x,
                        p.traction_y,
                        p.slip_x,
                        p.slip_y,
                        p.dissipation,
                    ];
                    assert!(numbers.iter().all(|v| v.is_finite()), "{numbers:?} {c:?} {m:?} {o:?}");
                    let bound = c.friction * c.normal_force;
                    // A unit in the last place is coarse among subnormal numbers
                    assert!(r.fx.hypot(r.fy) <= bound * (1.0 + 1e-6) + 6e-45, "{r:?} {c:?}");
                    last = Ok([r.fx / bound, r.fy / bound, r.adhesion]);
                }
                Err(error) => {
                    assert_eq!((status, at, jacobian), (error.code(), error.code(), error.code()));
                    assert!(untouched(&result) && untouched(&point));
                    last = Err(error.code());
                }
            }
        }
    }
    last
}

fn assert_all(answers: &[[f64; 4]], expected: [f64; 4], allowed: f64) {
    for answer in answers {
        for (got, expected) in answer.iter().zip(expected) {
            assert!((got - expected).abs() <= allowed, "{answer:?} {expected:?}");
        }
    }
}

#[test]
fn zero_creepage() {
    let answers = everywhere(&WHEEL, &motion(0.0, 0.0, 0.0)).unwrap();
    assert_all(&answers, [0.0, 0.0, 0.0, 1.0], 1e-15);
    assert!(answers.iter().all(|answer| answer[..3] == [0.0; 3]));
    let [fx, fy, stick] = everywhere_single(&WHEEL, &motion(0.0, -0.0, 0.0)).unwrap();
    assert!(fx == 0.0 && fy == 0.0 && (stick - 1.0).abs() < 1e-6);
    let rest = motion(0.0, 0.0, 0.0);
    // Nothing slips anywhere
    let field = Field::new(&WHEEL, &rest, &options(Model::Strip1967, StripCount::Four)).unwrap();
    for i in -9..=9 {
        let p = field.at(WHEEL.a * f64::from(i) / 10.0, 0.1 * WHEEL.b);
        assert_eq!(
            (p.state, p.traction_x, p.traction_y, p.dissipation),
            (State::Stick, 0.0, 0.0, 0.0)
        );
    }
    // The derivatives at rest are the linear slopes
    let sixteen = options(Model::Strip1967, StripCount::Sixteen);
    let (_, j) = model::solve_jacobian(&WHEEL, &rest, &sixteen).unwrap();
    let expected = WHEEL.shear_modulus * WHEEL.a * WHEEL.b * PI * PI / 4.0;
    assert!((j[(1, 1)] / expected - 1.0).abs() < 1e-9);
}

#[test]
fn zero_spin_is_pure_creepage() {
    let unit = theory::slip_unit(&WHEEL);
    let tau = 0.5;
    let force = 1.0 - (2.25 * 0.75_f64.sqrt() - 1.5 * 0.5_f64.acos()) / 2.0;
    let answers = everywhere(&WHEEL, &motion(0.0, tau * unit, 0.0)).unwrap();
    for answer in &answers {
        assert!((answer[1] - force).abs() < 1e-14 && answer[0].abs() < 1e-15, "{answer:?}");
    }
    let single = everywhere_single(&WHEEL, &motion(0.0, tau * unit, 0.0)).unwrap();
    assert!((f64::from(single[1]) - force).abs() < 1e-5, "{single:?}");
}

#[test]
fn vanishing_lateral_creepage_with_spin_joins_none() {
    for psi in [0.3, -0.9, 1.0, 1.7] {
        let at = |eta: f64| everywhere(&WHEEL, &creepage(&WHEEL, 0.1, eta, psi)).unwrap();
        let none = at(0.0);
        for eta in [1e-300, -1e-300, 1e-200, -1e-154, 1e-100, 1e-30, -1e-16, 1e-12] {
            for (one, two) in at(eta).iter().zip(&none) {
                // From ψ = ±1 on strips with ξ̄² < 2 |η| C adhere: forces grow like √|η|
                let allowed = if psi >= 1.0 { 1e-9 + 3.0 * eta.abs().sqrt() } else { 1e-9 };
                for i in 0..4 {
                    assert!((one[i] - two[i]).abs() < allowed, "{psi} {eta:e}: {one:?} {two:?}");
                }
            }
        }
    }
}

#[test]
fn lateral_creepage_against_almost_unit_spin() {
    for k in 1..=16 {
        for sign in [1.0, -1.0] {
            let psi = sign * (1.0 - 10f64.powi(-k));
            for (kind, continuous) in MODELS.into_iter().zip([false, true]) {
                let law = Law {
                    xi: 0.1,
                    eta: -0.5 * sign,
                    psi,
                    poisson_ratio: 0.28,
                    axis_ratio: 1.0,
                    continuous,
                };
                let (exact, _) = law.totals();
                let c = contact(1.0, 0.28);
                let m = creepage(&c, law.xi, law.eta, law.psi);
                let s = model::solve(&c, &m, &options(kind, StripCount::SixtyFour)).unwrap();
                let unit = c.friction * c.normal_force;
                assert!((s.fx / unit - exact[0]).abs() < 1e-5, "{psi}: {s:?} {exact:?}");
                assert!((s.fy / unit - exact[1]).abs() < 1e-5, "{psi}: {s:?} {exact:?}");
                assert!((s.adhesion - exact[3]).abs() < 1e-5, "{psi}: {s:?} {exact:?}");
                everywhere(&c, &m).unwrap();
                let small = everywhere_single(&c, &m).unwrap();
                if continuous {
                    assert!((f64::from(small[1]) - exact[1]).abs() < 1e-3, "{psi}: {small:?}");
                }
            }
        }
    }
}

#[test]
fn spin_of_exactly_one() {
    // G/(2μp₀) = 1 and a = 1 make ψ = φ exactly: p₀ = 3N/(2πab) with N = 2π/3
    for sign in [1.0, -1.0] {
        let c = Contact {
            a: 1.0,
            b: 1.0,
            normal_force: 2.0 * PI / 3.0,
            shear_modulus: 2.0,
            poisson_ratio: 0.29,
            friction: 1.0,
            mismatch: 0.0,
        };
        for (xi, eta) in [(0.0, -0.5), (0.0, 0.5), (0.0, 0.0), (0.3, -0.2), (0.3, 0.0), (0.3, 0.2)]
        {
            // Neighbours on both sides, in case the factor is one unit in the last place off 1
            for psi in [1.0 - f64::EPSILON, 1.0, 1.0 + f64::EPSILON] {
                let m = motion(xi * 0.71, eta * sign, psi * sign);
                let answers = everywhere(&c, &m).unwrap();
                let law = Law {
                    xi,
                    eta: eta * sign,
                    psi: sign,
                    poisson_ratio: 0.29,
                    axis_ratio: 1.0,
                    continuous: false,
                };
                let (exact, _) = law.totals();
                for (got, exact) in answers[0].iter().zip(exact) {
                    // measured 2.3e-8
                    assert!((got - exact).abs() < 2e-7, "{law:?}: {answers:?} {exact:?}");
                }
                everywhere_single(&c, &m).unwrap();
            }
        }
    }
}

#[test]
fn tiny_creepage_is_linear() {
    for size in [1e-300, 1e-250, 1e-160, 1e-154, 1e-100, 1e-30] {
        let m = motion(size, -2.0 * size, 3.0 * size / WHEEL.a);
        let unit = theory::slip_unit(&WHEEL);
        for answer in everywhere(&WHEEL, &m).unwrap() {
            let fx = 0.75 * PI * size / (unit * 0.72);
            let fy = (0.75 * PI * -2.0 + 3.0) * size / unit;
            assert!((answer[0] / fx - 1.0).abs() < 1e-9, "{size:e}: {answer:?} {fx:e}");
            assert!((answer[1] / fy - 1.0).abs() < 1e-9, "{size:e}: {answer:?} {fy:e}");
            assert!((answer[3] - 1.0).abs() < 1e-12);
        }
    }
    // Below the normal numbers of each precision: nothing but a zero to rounding
    for size in [5e-324, 1e-310] {
        let answers = everywhere(&WHEEL, &motion(size, size, size)).unwrap();
        assert_all(&answers, [0.0, 0.0, 0.0, 1.0], 1e-12);
    }
    for size in [1e-45, 1e-38, 1e-30, 1e-20] {
        let [fx, _, stick] = everywhere_single(&WHEEL, &motion(size, 0.0, 0.0)).unwrap();
        assert!((0.0..1e-15).contains(&fx) && (stick - 1.0).abs() < 1e-6, "{size:e}: {fx} {stick}");
    }
}

#[test]
fn huge_creepage_saturates() {
    for size in [1e3, 1e30, 1e90, 1e100, 1e150, 1e200, 1e299] {
        let m = motion(3.0 * size, -4.0 * size, 0.0);
        let answers = everywhere(&WHEEL, &m).unwrap();
        // Rigid slip: along (3, −4) exactly; continuous rule: along (ξ, η)
        assert_all(&answers[..1], [0.6, -0.8, 0.0, 0.0], 1e-12);
        let (x, y) = (3.0 / 0.72, -4.0);
        assert_all(&answers[1..], [x / f64::hypot(x, y), y / f64::hypot(x, y), 0.0, 0.0], 1e-12);
        // Spin alone: no lateral force, a moment against the spin... of the lower body along it
        match everywhere(&WHEEL, &motion(0.0, 0.0, size)) {
            Ok(answers) => {
                for answer in answers {
                    assert!(answer[0].abs() < 1e-12 && answer[3] == 0.0, "{size:e}: {answer:?}");
                    assert!(answer[2] > 0.0, "{size:e}: {answer:?}");
                }
            }
            Err(status) => assert_eq!(status, -14, "{size:e}"),
        }
    }
    for m in [motion(1e300, 0.0, 0.0), motion(0.0, -1e300, 0.0), motion(1e300, 1e300, 1e300)] {
        if let Err(status) = everywhere(&WHEEL, &m) {
            assert_eq!(status, -14, "{m:?}");
        }
    }
    for size in [1e3, 1e10, 1e20, 1e30] {
        let [fx, fy, stick] =
            everywhere_single(&WHEEL, &motion(3.0 * size, -4.0 * size, 0.0)).unwrap();
        let (x, y) = (3.0 / 0.72, -4.0);
        let length = f64::hypot(x, y);
        assert!(
            (f64::from(fx) - x / length).abs() < 1e-5 && (f64::from(fy) - y / length).abs() < 1e-5
        );
        assert_eq!(stick, 0.0);
        if let Err(status) = everywhere_single(&WHEEL, &motion(size, size, size)) {
            assert_eq!(status, -14);
        }
    }
    // Beyond f32 the cast gives infinity, which is refused
    assert_eq!(everywhere_single(&WHEEL, &motion(1e300, 0.0, 0.0)), Err(-2));
}

/// Mixed sizes: huge in one direction, ordinary in another.
#[test]
fn wildly_different_creepages() {
    let sizes = [0.0, 1e-300, 1e-20, 1e-3, 1.0, 1e20, 1e75, 1e100, 1e200, 1e280];
    for x in sizes {
        for y in sizes {
            for s in sizes {
                for (sx, sy) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0)] {
                    let m = motion(sx * x, sy * y, s);
                    if let Err(status) = everywhere(&WHEEL, &m) {
                        assert_eq!(status, -14, "{m:?}");
                    }
                }
            }
        }
    }
    let sizes = [0.0, 1e-40, 1e-20, 1e-3, 1.0, 1e20, 1e35];
    for x in sizes {
        for y in sizes {
            for s in sizes {
                for (sx, sy) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0)] {
                    let m = motion(sx * x, sy * y, s);
                    if let Err(status) = everywhere_single(&WHEEL, &m) {
                        assert_eq!(status, -14, "{m:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn needle_ellipses() {
    for axis_ratio in [1e-3, 1e3, 1e-6, 1e6] {
        for nu in [0.0, 0.28, 0.5] {
            let c = contact(axis_ratio, nu);
            for (xi, eta, psi) in [
                (0.3, 0.2, 0.0),
                (0.3, -0.2, 0.5),
                (0.0, 0.0, 0.7),
                (0.3, -0.4, 1.0),
                (0.1, -0.5, 1.3),
                (1e-4, 1e-4, 1e-5),
            ] {
                let m = creepage(&c, xi, eta, psi);
                let answers = everywhere(&c, &m).unwrap();
                let single = everywhere_single(&c, &m).unwrap();
                for (k, continuous) in [false, true].into_iter().enumerate() {
                    let law = Law { xi, eta, psi, poisson_ratio: nu, axis_ratio, continuous };
                    let (exact, _) = law.totals();
                    let got = answers[k];
                    for i in [0, 1, 3] {
                        assert!((got[i] - exact[i]).abs() < 1e-3, "{law:?}: {got:?} {exact:?}");
                    }
                    let arm = axis_ratio.sqrt().max(1.0 / axis_ratio.sqrt());
                    assert!((got[2] - exact[2]).abs() < 1e-3 * arm, "{law:?}: {got:?} {exact:?}");
                    // The last of the single answers is the continuous rule
                    if continuous {
                        assert!(
                            (f64::from(single[0]) - exact[0]).abs() < 2e-3,
                            "{law:?} {single:?}"
                        );
                        assert!(
                            (f64::from(single[1]) - exact[1]).abs() < 2e-3,
                            "{law:?} {single:?}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn poisson_ratio_at_its_limits() {
    for nu in [0.0, 0.5] {
        let c = Contact { poisson_ratio: nu, ..WHEEL };
        let answers = everywhere(&c, &MOTION).unwrap();
        let unit = theory::slip_unit(&c);
        let law = Law {
            xi: MOTION.longitudinal / (unit * (1.0 - nu)),
            eta: MOTION.lateral / unit,
            psi: MOTION.spin * c.a / unit,
            poisson_ratio: nu,
            axis_ratio: c.a / c.b,
            continuous: false,
        };
        let (exact, _) = law.totals();
        for i in 0..4 {
            // measured 3.8e-6, the moment
            assert!((answers[0][i] - exact[i]).abs() < 1e-5, "{answers:?} {exact:?}");
        }
    }
}

#[test]
fn subnormal_and_zero_load() {
    // No load, no force, no error: a wheel that lifts off
    let c = Contact { normal_force: 0.0, ..WHEEL };
    for m in [MOTION, motion(0.0, 0.0, 0.0), motion(0.1, 0.1, 10.0)] {
        for kind in MODELS {
            let s = model::solve(&c, &m, &options(kind, StripCount::Sixteen)).unwrap();
            assert_eq!((s.fx.abs(), s.fy.abs(), s.mz.abs(), s.power.abs()), (0.0, 0.0, 0.0, 0.0));
        }
        everywhere(&c, &m).unwrap();
        everywhere_single(&c, &m).ok();
    }
    for load in [5e-324, 1e-320, 1e-310, 1e-300, 1e-200, 1e-30] {
        let c = Contact { normal_force: load, ..WHEEL };
        let answers = everywhere(&c, &MOTION).unwrap();
        // Almost no load: everything slides along the rigid slip, and the bound holds
        for kind in MODELS {
            let s = model::solve(&c, &MOTION, &options(kind, StripCount::Sixteen)).unwrap();
            assert!(s.fx >= 0.0 && s.adhesion == 0.0, "{load:e} {s:?}");
            assert!(s.fx <= load && s.fy.abs() <= load);
        }
        if load > 1e-305 {
            for answer in answers {
                let size = answer[0].hypot(answer[1]);
                assert!(size > 0.5 && size <= 1.0 + 1e-12, "{load:e} {answer:?}");
            }
        }
    }
    for load in [1e-45, 1e-40, 1e-30] {
        everywhere_single(&Contact { normal_force: load, ..WHEEL }, &MOTION).unwrap();
    }
}

#[test]
fn zero_friction() {
    let c = Contact { friction: 0.0, ..WHEEL };
    for answer in everywhere(&c, &MOTION).unwrap() {
        assert_eq!((answer[0].abs(), answer[1].abs(), answer[2].abs()), (0.0, 0.0, 0.0));
        // Nothing holds: no adhesion
        assert_eq!(answer[3], 0.0);
    }
    // The slip is the rigid slip
    let field = Field::new(&c, &MOTION, &options(Model::Strip1967, StripCount::Four)).unwrap();
    let (x, y) = (0.3 * c.a, -0.4 * c.b);
    let p = field.at(x, y);
    let rigid = [MOTION.longitudinal - MOTION.spin * y, MOTION.lateral + MOTION.spin * x];
    assert!((p.slip_x - rigid[0]).abs() < 1e-12 && (p.slip_y - rigid[1]).abs() < 1e-12, "{p:?}");
    assert_eq!((p.traction_x, p.traction_y), (0.0, 0.0));
    let single = single(&c);
    let s = model::solve(
        &single,
        &single_motion(&MOTION),
        &options(Model::Strip1967, StripCount::Four),
    );
    assert_eq!(s.unwrap().fx, 0.0);
}

/// Every field of every input, with every number that is none: refused by its name.
#[test]
fn bad_inputs_are_named() {
    let set = |field: usize, value: f64| {
        let mut c = WHEEL;
        let mut m = MOTION;
        match field {
            0 => c.a = value,
            1 => c.b = value,
            2 => c.normal_force = value,
            3 => c.shear_modulus = value,
            4 => c.poisson_ratio = value,
            5 => c.friction = value,
            6 => m.longitudinal = value,
            7 => m.lateral = value,
            _ => m.spin = value,
        }
        (c, m)
    };
    for field in 0..9 {
        for value in [f64::NAN, -f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let (c, m) = set(field, value);
            assert_eq!(everywhere(&c, &m), Err(KSTRIP_ERROR_NOT_FINITE), "{c:?} {m:?}");
            assert_eq!(everywhere_single(&c, &m), Err(KSTRIP_ERROR_NOT_FINITE));
        }
    }
    for (field, value, status) in [
        (0, 0.0, KSTRIP_ERROR_SEMI_AXIS),
        (0, -6e-3, KSTRIP_ERROR_SEMI_AXIS),
        (1, 0.0, KSTRIP_ERROR_SEMI_AXIS),
        (1, -4e-3, KSTRIP_ERROR_SEMI_AXIS),
        (3, 0.0, KSTRIP_ERROR_MODULUS),
        (3, -1.0, KSTRIP_ERROR_MODULUS),
        (4, -0.01, KSTRIP_ERROR_POISSON_RATIO),
        (4, 0.51, KSTRIP_ERROR_POISSON_RATIO),
        (5, -0.1, KSTRIP_ERROR_FRICTION),
    ] {
        let (c, m) = set(field, value);
        assert_eq!(everywhere(&c, &m), Err(status), "{c:?} {m:?}");
        assert_eq!(everywhere_single(&c, &m), Err(status), "{c:?} {m:?}");
    }
    // Extremes of what is allowed: an answer or Overflow, never nonsense
    for field in 0..6 {
        for value in [5e-324, 1e-308, 1e-200, 1e200, 1.7e308] {
            let (c, m) = set(field, value);
            if let Err(status) = everywhere(&c, &m) {
                assert!(status == -14 || (field == 4 && status == -6), "{status} {c:?}");
            }
        }
        for value in [1e-45, 1e-38, 1e-30, 1e30, 3e38] {
            let (c, m) = set(field, value);
            if let Err(status) = everywhere_single(&c, &m) {
                assert!(status == -14 || (field == 4 && status == -6), "{status} {c:?}");
            }
        }
    }
}

/// |ψ| ≥ 1 is answered and flagged, |ψ| < 1 is not.
#[test]
fn spin_beyond_the_theory_is_flagged() {
    let c = contact(1.0, 0.28);
    for (psi, notice) in [
        (0.99, Notice::None),
        (-0.99, Notice::None),
        (1.01, Notice::SpinBeyondTheory),
        (-1.01, Notice::SpinBeyondTheory),
        (5.0, Notice::SpinBeyondTheory),
        (30.0, Notice::Spin),
    ] {
        let m = creepage(&c, 0.2, -0.3, psi);
        let o = options(Model::Strip1967, StripCount::Sixteen);
        assert_eq!(model::solve(&c, &m, &o).unwrap().notice, notice);
        assert_eq!(model::solve_jacobian(&c, &m, &o).unwrap().0.notice, notice);
        assert_eq!(model::strips(&c, &m, &o, &mut |_| ()).unwrap(), notice);
        assert_eq!(Field::new(&c, &m, &o).unwrap().notice, notice);
        assert!(everywhere(&c, &m).is_ok());
    }
}

/// The C functions before the solver: materials, Hertz, velocities, parameters.
#[test]
fn c_functions_of_the_road_to_the_contact() {
    let steel = kstrip_material { shear_modulus: 82e9, poisson_ratio: 0.28 };
    let mut pair = poisoned::<kstrip_combined_material>();
    assert_eq!(kstrip_material_combine(Some(&steel), Some(&steel), Some(&mut pair)), 0);
    // SAFETY: status 0.
    let pair = unsafe { pair.assume_init() };
    assert_eq!((pair.shear_modulus, pair.poisson_ratio, pair.mismatch), (82e9, 0.28, 0.0));
    let mut out = [poisoned::<kstrip_combined_material>()];
    let bad = kstrip_material { shear_modulus: -1.0, ..steel };
    assert_eq!(kstrip_material_combine(Some(&bad), Some(&steel), Some(&mut out[0])), -5);
    assert_eq!(kstrip_material_combine(None, Some(&steel), Some(&mut out[0])), -1);
    assert!(untouched(&out));

    let radii = kstrip_radii {
        lower_x: f64::INFINITY,
        lower_y: 0.3,
        upper_x: 0.46,
        upper_y: f64::INFINITY,
    };
    let mut contact = [poisoned::<kstrip_contact>()];
    let mut ellipse = [poisoned::<kstrip_hertz_contact>()];
    for (radii, load, status) in [
        (kstrip_radii { lower_y: 0.0, ..radii }, 1.0, -10),
        (kstrip_radii { lower_y: -0.3, ..radii }, 1.0, -10),
        (kstrip_radii { lower_y: f64::NAN, ..radii }, 1.0, -10),
        (radii, f64::NAN, -2),
    ] {
        let (contact, ellipse) = (Some(&mut contact[0]), Some(&mut ellipse[0]));
        let found =
            kstrip_contact_from_hertz(Some(&radii), Some(&pair), load, 0.3, contact, ellipse);
        assert_eq!(found, status);
    }
    assert!(untouched(&ellipse) && untouched(&contact));
    let (r, p) = (Some(&radii), Some(&pair));
    let places = (Some(&mut contact[0]), Some(&mut ellipse[0]));
    assert_eq!(kstrip_contact_from_hertz(r, p, 80e3, 0.3, places.0, places.1), 0);
    // SAFETY: status 0.
    let ellipse = unsafe { ellipse[0].assume_init() };
    assert!(ellipse.a > ellipse.b && ellipse.axis_ratio == ellipse.b / ellipse.a);

    let still = kstrip_velocity { x: 0.0, y: 0.0, angular_z: 0.0 };
    let mut creep = [poisoned::<kstrip_creepage>()];
    assert_eq!(
        kstrip_creepage_from_velocities(Some(&still), Some(&still), 0.0, Some(&mut creep[0])),
        -11
    );
    assert_eq!(kstrip_creepage_from_velocities(Some(&still), None, 1.0, Some(&mut creep[0])), -1);
    assert!(untouched(&creep));
    // Parameters and back
    let (cc, cm) = (WHEEL, MOTION);
    let mut parameters = [poisoned::<kstrip_parameters>()];
    assert_eq!(kstrip_parameters_from_creepage(Some(&cc), None, Some(&mut parameters[0])), -1);
    assert!(untouched(&parameters));
    assert_eq!(kstrip_parameters_from_creepage(Some(&cc), Some(&cm), Some(&mut parameters[0])), 0);
    // SAFETY: status 0.
    let p = unsafe { parameters[0].assume_init() };
    assert!((p.eta - MOTION.lateral / theory::slip_unit(&WHEEL)).abs() < 1e-14);
    let nan = kstrip_parameters { psi: f64::NAN, ..p };
    assert_eq!(kstrip_creepage_from_parameters(Some(&cc), Some(&nan), Some(&mut creep[0])), -2);
    assert!(untouched(&creep));
    assert_eq!(kstrip_creepage_from_parameters(Some(&cc), Some(&p), Some(&mut creep[0])), 0);
    // SAFETY: status 0.
    let back = unsafe { creep[0].assume_init() };
    assert!((back.longitudinal / MOTION.longitudinal - 1.0).abs() < 1e-14);
    assert!((back.spin / MOTION.spin - 1.0).abs() < 1e-14);
}

/// Bodies exchanged: forces reversed, power the same.
#[test]
fn upper_body_sees_the_opposite() {
    let (cc, cm) = (WHEEL, MOTION);
    let (mut lower, mut upper) = (poisoned::<kstrip_result>(), poisoned::<kstrip_result>());
    assert_eq!(kstrip_solve(Some(&cc), Some(&cm), None, Some(&mut lower)), 0);
    assert_eq!(kstrip_result_on_upper_body(Some(&lower), Some(&mut upper)), 0);
    // SAFETY: status 0.
    let (lower, upper) = unsafe { (lower.assume_init(), upper.assume_init()) };
    assert_eq!((upper.fx, upper.fy, upper.mz), (-lower.fx, -lower.fy, -lower.mz));
    assert_eq!((upper.power, upper.adhesion), (lower.power, lower.adhesion));
    assert_eq!(kstrip_result_on_upper_body(None, None), -1);
}

/// Every status has a text that says something, and unknown numbers one that says so.
#[test]
fn every_status_has_a_text() {
    let text = |status| {
        // SAFETY: never NULL, static, says the documentation.
        unsafe { std::ffi::CStr::from_ptr(kstrip_status_string(status)) }.to_str().unwrap()
    };
    let mut seen = std::collections::HashSet::new();
    for status in -24..=13 {
        assert!(text(status).len() >= 2 && text(status) != "unknown status", "{status}");
        assert!(seen.insert(text(status)), "{status}");
    }
    for status in [-1000, -39, 39, 1000, i32::MIN, i32::MAX] {
        assert_eq!(text(status), "unknown status");
    }
    assert_eq!(Error::Friction.code(), KSTRIP_ERROR_FRICTION);
}

/// Far beyond unit spin, where the strips that adhere are narrower than rounding, friction still takes power out; no force passes its
/// bound by more than four roundings; and without longitudinal creepage, which is its own mirror image, there is no longitudinal force.
#[test]
fn power_bound_and_mirror_hold_to_rounding() {
    let mut random = Random::new(310);
    let (mut most, mut least, mut mirrored) = (0.0_f64, f64::INFINITY, 0);
    for n in 0..6_000 {
        let c = contact(random.log_between(0.1, 10.0), random.between(0.0, 0.5));
        let size = random.log_between(1e-3, 1e3);
        let [xi, eta] = [0; 2].map(|_| size * random.between(-1.0, 1.0));
        let xi = if n % 3 == 0 { 0.0 } else { xi };
        let psi = random.sign() * random.log_between(1e-3, if n % 2 == 0 { 10.0 } else { 1e18 });
        let m = theory::creepage(&c, xi, eta, psi);
        for model in [Model::Strip1967, Model::Strip1967Continuous, Model::Strip, Model::Total] {
            let s = model::solve(&c, &m, &options(model, StripCount::Sixteen)).unwrap();
            assert!(s.power >= 0.0, "{model:?} {c:?} {m:?} {s:?}");
            (least, mirrored) = (least.min(s.power), mirrored + usize::from(xi == 0.0));
            let over = s.fx.hypot(s.fy) / (c.friction * c.normal_force) - 1.0;
            assert!(over <= 4.0 * f64::EPSILON, "{model:?} {over:e} {c:?} {m:?}");
            most = most.max(over / f64::EPSILON);
            assert!(xi != 0.0 || s.fx == 0.0, "{model:?} {c:?} {m:?} {s:?}");
        }
    }
    println!(
        "least power {least:e} W, |F| at most mu N (1 + {most} eps), fx 0 in {mirrored} mirror-symmetric cases"
    );
}
