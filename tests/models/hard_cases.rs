//! The hard cases by name, of every model in both precisions, in Rust and through the C functions:
//! each gives a right answer or a named status, and an error leaves the outputs as they were.

use crate::prelude::*;
use kstrip::ffi::types::Outputs;
use kstrip::friction::derivatives::LawDerivatives;
use kstrip_testing::in_c::InC;
use kstrip_testing::names::*;
use kstrip_testing::poison::{poisoned, untouched};
use kstrip_testing::single::{converted, converted_motion};
use kstrip_testing::theory::{BASE, Law};

const WHEEL: Contact<f64> = Contact { b: 4e-3, ..C0 };
const MOTION: Creepage<f64> = creep(1e-3, -5e-4, 0.2);
const REST: Creepage<f64> = creep(0.0, 0.0, 0.0);

fn finite<F: Float>(numbers: &[F]) -> bool {
    numbers.iter().all(|number| number.is_finite_number())
}

/// What a model answers, at every entry point alike: forces divided by `μ N`, the moment over
/// `μ N √(ab)`, and the stick area; and the same with few strips as with many unless it is STRIP.
fn answer<F: InC>(c: &Contact<f64>, m: &Creepage<f64>, model: Model) -> Result<[f64; 4], Error> {
    let (c, m) = (converted::<_, F>(c), converted_motion::<_, F>(m));
    let [few, many] =
        [StripCount::Four, StripCount::SixtyFour].map(|count| one_answer(&c, &m, model, count));
    assert!(
        few == many || model == Model::Strip && few.is_ok() == many.is_ok(),
        "{few:?} {many:?}"
    );
    many
}

fn one_answer<F: InC>(
    c: &Contact<F>, m: &Creepage<F>, model: Model, count: StripCount,
) -> Result<[f64; 4], Error> {
    let what = || format!("{model:?} {count:?} {c:?} {m:?}");
    let o = kstrip_options { model: model as i32, strips: count as i32 };
    let expected = forces::forces_of_contact(c, m, &options(model, count));
    let status = expected.as_ref().map_or_else(|error| error.code(), |s| s.warning.code());
    let mut result = [poisoned::<Solution<F>>()];
    assert_eq!(F::solve((c, m, &o), &mut result[0]), status, "{}", what());
    let mut one = [poisoned::<Solution<F>>()];
    // SAFETY: one contact, and a place for one result.
    let batch =
        unsafe { F::batch(&batch_inputs(c, m), 1, &o, &batch_results(one[0].as_mut_ptr()), None) };
    assert_eq!(batch, status, "{}", what());
    let mut second = [poisoned::<Solution<F>>()];
    let mut slopes = [poisoned::<Derivatives<F>>()];
    let mut by_law = [poisoned::<LawDerivatives<F>>()];
    let outputs = Outputs {
        result: second[0].as_mut_ptr(),
        derivatives: slopes[0].as_mut_ptr(),
        law_derivatives: by_law[0].as_mut_ptr(),
        ..nowhere()
    };
    // SAFETY: the places are there.
    let with_slopes = unsafe { F::evaluate((c, m, &o), None, &outputs) };
    // A derivative may be too large where the force is not.
    let overflows = status >= 0 && with_slopes == Error::Overflow.code();
    assert!(with_slopes == status || overflows, "{with_slopes} {}", what());
    if with_slopes < 0 {
        assert!(untouched(&second) && untouched(&slopes) && untouched(&by_law), "{}", what());
    } else {
        // SAFETY: status >= 0 says written.
        let d = unsafe { slopes[0].assume_init() };
        let vectors = [d.normal_force, d.friction, d.load_through_hertz];
        assert!(d.jacobian.iter().chain(&vectors).all(|row| finite(row)), "{d:?} {}", what());
    }
    let mut strips: [MaybeUninit<StripResult<F>>; 64] = std::array::from_fn(|_| poisoned());
    let mut written = [poisoned::<u32>()];
    let outputs = Outputs {
        strips: strips.as_mut_ptr().cast(),
        capacity: 64,
        count: written[0].as_mut_ptr(),
        ..nowhere()
    };
    let scaled = |axis: F, shares: &[f64]| -> Vec<F> {
        let axis = if axis.is_finite_number() { axis } else { F::one() };
        shares.iter().map(|share| axis * F::of(*share)).collect()
    };
    let (x, y) = (scaled(c.a, &[-0.9, -0.3, 0.0, 0.3, 1.2]), scaled(c.b, &[-0.5, 0.0, 0.7]));
    let mut points: [MaybeUninit<FieldPoint<F>>; 15] = std::array::from_fn(|_| poisoned());
    // SAFETY: the places are there, and as many as the counts say.
    let inside = unsafe {
        [
            F::evaluate((c, m, &o), None, &outputs),
            F::field((c, m, &o), &x, &y, points.as_mut_ptr().cast()),
        ]
    };
    let has_strips = !matches!(model, Model::Total | Model::Linear);
    for inside in inside {
        assert!(inside == status || !has_strips && inside < 0, "{inside} {}", what());
    }
    if !has_strips || status < 0 {
        assert!(untouched(&strips) && untouched(&written) && untouched(&points), "{}", what());
    } else {
        // SAFETY: status >= 0 says written.
        let n = unsafe { written[0].assume_init() } as usize;
        assert!((n > 0 || c.is_lost()) && untouched(&strips[n..]), "{n} {}", what());
        for p in &points {
            // SAFETY: as above.
            let p = unsafe { p.assume_init() };
            let numbers = [p.pressure, p.traction_x, p.traction_y, p.slip_x, p.slip_y];
            assert!(finite(&numbers) && finite(&[p.dissipation]), "{p:?} {}", what());
            // (the bound next to the separatrix is a difference of square roots)
            let loose = 10.0 * F::EPSILON.to_f64().sqrt();
            let bound = c.friction.to_f64() * p.pressure.to_f64() * (1.0 + loose);
            let traction = p.traction_x.to_f64().hypot(p.traction_y.to_f64());
            assert!(traction <= bound.max(1e-37) && p.reserved == 0, "{p:?} {}", what());
        }
    }
    let s = expected.inspect_err(|_| assert!(untouched(&result) && untouched(&one)))?;
    // SAFETY: status >= 0 says written; a batch has no member that is reserved.
    let (found, of_batch) = unsafe { (result[0].assume_init(), one[0].assume_init()) };
    assert_eq!([found, Solution { reserved: 0, ..of_batch }], [s; 2], "{}", what());
    let numbers = [s.fx, s.fy, s.mz, s.power, s.adhesion];
    assert!(finite(&numbers) && s.reserved == 0, "{s:?} {}", what());
    let [fx, fy, mz, _, adhesion] = numbers.map(|number| number.to_f64());
    let bound = c.friction.to_f64() * c.normal_force.to_f64().max(0.0);
    // (a unit in the last place is coarse among subnormal numbers)
    let limit = bound * (1.0 + 8.0 * F::EPSILON.to_f64()) + 3.0 * (F::TINY * F::EPSILON).to_f64();
    assert!(fx.hypot(fy) <= limit || model == Model::Linear, "{s:?} {}", what());
    let unit = if bound > 0.0 { bound } else { 1.0 };
    let mean = (c.a.to_f64()).sqrt() * c.b.to_f64().sqrt();
    Ok([fx / unit, fy / unit, mz / unit / mean, adhesion])
}

/// A model in a precision, and what it answers.
type Answered = (Model, bool, Result<[f64; 4], Error>);

/// Every model in double precision, and then in single.
fn everywhere(c: &Contact<f64>, m: &Creepage<f64>) -> [Answered; 10] {
    std::array::from_fn(|i| {
        let (model, single) = (Model::ALL[i % 5], i >= 5);
        let found = if single { answer::<f32>(c, m, model) } else { answer::<f64>(c, m, model) };
        let lost = matches!(found, Err(Error::Overflow | Error::NotFinite | Error::SemiAxis));
        assert!(found.is_ok() || lost, "{model:?} {single} {found:?} {c:?} {m:?}");
        (model, single, found)
    })
}

/// The same where double precision must have an answer, but for linear forces beyond it, and single
/// unless it is beyond its range.
fn answers(c: &Contact<f64>, m: &Creepage<f64>) -> impl Iterator<Item = (Model, bool, [f64; 4])> {
    let all = everywhere(c, m);
    assert!(all[..4].iter().all(|(_, _, found)| found.is_ok()), "{all:?} {c:?} {m:?}");
    all.into_iter().filter_map(|(model, single, found)| Some((model, single, found.ok()?)))
}

fn near(got: [f64; 4], expected: [f64; 4], allowed: f64) -> bool {
    (0..4).all(|i| (got[i] - expected[i]).abs() <= allowed)
}

#[test]
fn zero_creepage() {
    for zero in [0.0, -0.0] {
        for (model, single, got) in answers(&WHEEL, &creep(zero, zero, 0.0)) {
            let stick = if model == Model::Total { -1.0 } else { 1.0 };
            let allowed = if single { 1e-6 } else { 1e-12 };
            assert!(got[..3] == [0.0; 3] && (got[3] - stick).abs() < allowed, "{model:?} {got:?}");
        }
    }
    // Nothing slips anywhere
    let field = Field::new(&WHEEL, &REST, &options(Model::Strip1967, StripCount::Four)).unwrap();
    for i in -9..=9 {
        let p = field.at(WHEEL.a * f64::from(i) / 10.0, 0.1 * WHEEL.b);
        let found = (p.state, p.traction_x, p.traction_y, p.dissipation);
        assert_eq!(found, (State::Stick, 0.0, 0.0, 0.0));
    }
}

#[test]
fn vanishing_lateral_creepage_with_spin_joins_none() {
    for psi in [0.3, -0.9, 1.0, 1.7] {
        let at = |eta: f64| {
            MODELS.map(|model| {
                answer::<f64>(&WHEEL, &creepage(&WHEEL, 0.1, eta, psi), model).unwrap()
            })
        };
        let none = at(0.0);
        for eta in [1e-300, -1e-300, 1e-200, -1e-154, 1e-100, 1e-30, -1e-16, 1e-12] {
            for (one, two) in at(eta).into_iter().zip(none) {
                // From ψ = ±1 on strips with ξ̄² < 2 |η| C adhere: forces grow like √|η|
                let allowed = if psi >= 1.0 { 1e-9 + 3.0 * eta.abs().sqrt() } else { 1e-9 };
                assert!(near(one, two, allowed), "{psi} {eta:e}: {one:?} {two:?}");
            }
        }
    }
}

/// Below unit spin by any hair single precision has the force of the theory.
#[test]
fn lateral_creepage_against_almost_unit_spin() {
    let c = contact(1.0, 0.28);
    for k in 1..=16 {
        for sign in [1.0, -1.0] {
            let (eta, psi) = (-0.5 * sign, sign * (1.0 - 10f64.powi(-k)));
            let law = Law { xi: 0.1, eta, psi, continuous: true, ..BASE };
            let (exact, _) = law.totals();
            let got = answer::<f32>(&c, &creepage(&c, law.xi, eta, psi), MODELS[1]).unwrap();
            assert!((got[1] - exact[1]).abs() < 1e-6, "{psi}: {got:?} {exact:?}");
        }
    }
}

#[test]
fn spin_of_exactly_one() {
    // G/(2μp₀) = 1 and a = 1 make ψ = φ exactly: p₀ = 3N/(2πab) with N = 2π/3
    let (normal_force, shear_modulus) = (2.0 * PI / 3.0, 2.0);
    let c = Contact {
        a: 1.0,
        b: 1.0,
        normal_force,
        shear_modulus,
        poisson_ratio: 0.29,
        friction: 1.0,
        ..C0
    };
    for sign in [1.0, -1.0] {
        for (xi, eta) in [(0.0, -0.5), (0.0, 0.5), (0.0, 0.0), (0.3, -0.2), (0.3, 0.0), (0.3, 0.2)]
        {
            let law = Law { xi, eta: eta * sign, psi: sign, poisson_ratio: 0.29, ..BASE };
            let (exact, _) = law.totals();
            // Neighbours on both sides, in case the factor is one unit in the last place off 1
            for psi in [1.0 - f64::EPSILON, 1.0, 1.0 + f64::EPSILON] {
                let m = creep(xi * 0.71, law.eta, psi * sign);
                let got = answer::<f64>(&c, &m, MODELS[0]).unwrap();
                // measured 2.3e-8
                assert!(near(got, exact, 2e-7), "{law:?}: {got:?} {exact:?}");
                answer::<f32>(&c, &m, MODELS[0]).unwrap();
            }
        }
    }
}

/// Down to the subnormal numbers the forces are the linear ones.
#[test]
fn tiny_creepage_is_linear() {
    let at = |size: f64| creep(size, -2.0 * size, 3.0 * size / WHEEL.a);
    for (model, unit) in Model::ALL.map(|m| (m, answer::<f64>(&WHEEL, &at(1e-15), m).unwrap())) {
        for size in [1e-300, 1e-250, 1e-160, 1e-154, 1e-100, 1e-30] {
            let got = answer::<f64>(&WHEEL, &at(size), model).unwrap();
            for i in 0..3 {
                let error = (got[i] / unit[i] / (size / 1e-15) - 1.0).abs();
                assert!(error < 3e-12, "{model:?} {size:e} {i}: {error:e}");
            }
        }
    }
    for size in [5e-324, 1e-310, 1e-200, 1e-45, 1e-38, 1e-30] {
        for (model, _, got) in answers(&WHEEL, &creep(size, size, size)) {
            let stick = if model == Model::Total { -1.0 } else { 1.0 };
            assert!(near(got, [0.0, 0.0, 0.0, stick], 1e-6), "{model:?} {size:e}: {got:?}");
        }
    }
}

#[test]
fn huge_creepage_saturates() {
    for size in [1e3, 1e18, 1e30, 1e90, 1e150, 1e200, 1e299] {
        for (model, single, got) in answers(&WHEEL, &creep(3.0 * size, -4.0 * size, 0.0)) {
            // along the rigid slip (3, −4); by the continuous rule along (ξ, η)
            let [x, y] = if model == MODELS[1] { [3.0 / 0.72, -4.0] } else { [3.0, -4.0] };
            let length = f64::hypot(x, y);
            let off = (got[0] - x / length).hypot(got[1] - y / length);
            let allowed = if single { 1e-6 } else { 2e-14 };
            assert!(off < allowed || model == Model::Linear, "{model:?} {size:e}: {got:?}");
        }
        // Spin alone: no force along x, and a moment on the lower body along the spin
        for (model, _, found) in everywhere(&WHEEL, &creep(0.0, 0.0, size)) {
            let alone = found.is_err_and(|error| error != Error::SemiAxis)
                || found.is_ok_and(|got| got[0].abs() < 1e-12 && got[2] >= 0.0);
            assert!(alone, "{model:?} {size:e}: {found:?}");
        }
    }
    for m in [creep(1e300, 0.0, 0.0), creep(0.0, -1e300, 0.0), creep(1e300, 1e300, 1e308)] {
        let _ = everywhere(&WHEEL, &m);
    }
    // Beyond f32 the cast gives infinity, which is refused
    let beyond = answer::<f32>(&WHEEL, &creep(1e300, 0.0, 0.0), Model::Total);
    assert_eq!(beyond, Err(Error::NotFinite));
}

/// Mixed sizes: huge in one direction, ordinary in another.
#[test]
fn wildly_different_creepages() {
    let mut refused = 0;
    let sizes = [0.0, 1e-300, 1e-40, 1e-20, 1e-3, 1.0, 1e20, 1e75, 1e200, 1e280];
    for (i, x) in sizes.into_iter().enumerate() {
        for (k, y) in sizes.into_iter().enumerate() {
            for s in sizes {
                let (sx, sy) = [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0)][(i + k) % 3];
                let m = creep(sx * x, sy * y, s);
                for model in Model::ALL {
                    let [double, single] =
                        [answer::<f64>(&WHEEL, &m, model), answer::<f32>(&WHEEL, &m, model)];
                    let beyond = single.is_err_and(|error| error == Error::NotFinite);
                    assert!(beyond || single.is_ok() || single == Err(Error::Overflow), "{m:?}");
                    assert!(double.is_ok() || double == Err(Error::Overflow), "{m:?} {double:?}");
                    refused += usize::from(double.is_err());
                }
            }
        }
    }
    assert!(refused < 1500, "{refused} of 5000");
}

#[test]
fn needle_ellipses() {
    for axis_ratio in [1e-30, 1e-6, 1e-3, 1e3, 1e6, 1e30] {
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
                for (model, single, got) in answers(&c, &m) {
                    // (needles beyond 1e6 are too thin for the quadrature of the comparison)
                    let of_1967 = model.is_of_1967() && (1e-7..1e7).contains(&axis_ratio);
                    if !of_1967 || single && model == MODELS[0] {
                        continue;
                    }
                    let continuous = model == MODELS[1];
                    let law = Law { xi, eta, psi, poisson_ratio: nu, axis_ratio, continuous };
                    let (exact, _) = law.totals();
                    let arm = axis_ratio.sqrt().max(1.0 / axis_ratio.sqrt());
                    // (of the comparison: a needle's strips turn within a thousandth of its length)
                    let allowed =
                        if single { [5e-4, 2e-5, 2e-3, 2e-4] } else { [1e-8, 2e-5, 2e-3, 1e-14] };
                    for (i, unit) in [1.0, 1.0, arm, 1.0].into_iter().enumerate() {
                        let off = (got[i] - exact[i]).abs() / unit;
                        assert!(off < allowed[i], "{law:?} {i}: {got:?} {exact:?}");
                    }
                }
            }
            let _ = everywhere(&c, &creep(MOTION.longitudinal, MOTION.lateral, 1e3));
        }
    }
}

#[test]
fn nothing_is_carried_without_load_or_friction() {
    for c in [
        Contact { normal_force: 0.0, ..WHEEL },
        Contact { normal_force: -1.0, ..WHEEL },
        Contact { friction: 0.0, ..WHEEL },
    ] {
        for m in [MOTION, REST, creep(0.1, 0.1, 10.0)] {
            for (model, _, [fx, fy, mz, stick]) in answers(&c, &m) {
                if model != Model::Linear || c.is_lost() {
                    assert_eq!([fx.abs(), fy.abs(), mz.abs()], [0.0; 3], "{model:?} {c:?} {m:?}");
                    let sticks = m == REST && !c.is_lost();
                    assert!(sticks || stick < 1e-12, "{model:?} {c:?} {m:?} {stick}");
                } else if m != REST {
                    let o = sixteen(model);
                    let warning = solved(&c, &m, &o).warning;
                    assert_eq!(warning, Warning::BeyondFriction);
                }
            }
        }
    }
    // Without friction the slip is the rigid slip
    let c = Contact { friction: 0.0, ..WHEEL };
    let field = Field::new(&c, &MOTION, &options(Model::Strip1967, StripCount::Four)).unwrap();
    let (x, y) = (0.3 * c.a, -0.4 * c.b);
    let p = field.at(x, y);
    let rigid = [MOTION.longitudinal - MOTION.spin * y, MOTION.lateral + MOTION.spin * x];
    assert!((p.slip_x - rigid[0]).abs() < 1e-12 && (p.slip_y - rigid[1]).abs() < 1e-12, "{p:?}");
    assert_eq!((p.traction_x, p.traction_y), (0.0, 0.0));
}

/// Almost no load: everything slides, and the force is `μ N` along the slip, for a small load as
/// for any other.
#[test]
fn subnormal_loads_slide() {
    for load in [5e-324, 1e-310, 1e-300, 1e-200, 1e-45, 1e-40, 1e-37, 1e-30] {
        let c = Contact { normal_force: load, ..WHEEL };
        for (model, single, got) in answers(&c, &creep(1e-3, 0.0, 0.0)) {
            // (few digits are left of the bound)
            let smallest = if single { 1e-45 } else { 5e-324 };
            let allowed = 2e-3 + smallest / (WHEEL.friction * load);
            let slides = (got[0] - 1.0).abs() <= allowed && got[1] == 0.0 && got[3] < 1e-12;
            assert!(
                slides || model == Model::Linear || single && load < 1e-45,
                "{load:e} {model:?} {got:?}"
            );
        }
    }
}

/// The ends of what is allowed give an answer or a named error, never nonsense.
#[test]
fn extremes_of_inputs_are_answered_or_named() {
    for field in 0..6 {
        for value in [5e-324, 1e-308, 1e-200, 1e-45, 1e-38, 1e-30, 1e30, 3e38, 1e200, 1.7e308] {
            let mut c = WHEEL;
            let Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, .. } = &mut c;
            *[a, b, normal_force, shear_modulus, poisson_ratio, friction][field] = value;
            if field == 4 && value > 0.5 {
                assert_eq!(answer::<f64>(&c, &MOTION, Model::Total), Err(Error::PoissonRatio));
            } else if field != 3 || value > 1e-45 {
                let _ = everywhere(&c, &MOTION);
            }
        }
    }
}

/// `|ψ| ≥ 1` is answered and flagged by every function, `|ψ| < 1` is not.
#[test]
fn spin_beyond_the_theory_is_flagged() {
    let c = contact(1.0, 0.28);
    for (psi, warning) in [
        (0.99, Warning::None),
        (-0.99, Warning::None),
        (1.01, Warning::SpinBeyondTheory),
        (-1.01, Warning::SpinBeyondTheory),
        (30.0, Warning::Spin),
    ] {
        let m = creepage(&c, 0.2, -0.3, psi);
        let o = sixteen(Model::Strip1967);
        assert_eq!(forces::solve_jacobian(&c, &m, &o).unwrap().0.warning, warning);
        assert_eq!(forces::strips(&c, &m, &o, &mut |_| ()).unwrap(), warning);
        assert_eq!(Field::new(&c, &m, &o).unwrap().warning, warning);
        answer::<f64>(&c, &m, Model::Strip1967).unwrap();
    }
}

/// Far beyond unit spin, where the strips that adhere are narrower than rounding, friction still
/// takes power out; no force passes its bound by more than four roundings; and without longitudinal
/// creepage, which is its own mirror image, there is no longitudinal force.
#[test]
fn power_bound_and_mirror_hold_to_rounding() {
    let mut random = Random::new(310);
    let (mut most, mut least, mut mirrored) = (0.0_f64, f64::INFINITY, 0);
    for n in 0..6_000 {
        let c = any_contact(&mut random);
        let size = random.log_between(1e-3, 1e3);
        let [xi, eta] = [0; 2].map(|_| size * random.between(-1.0, 1.0));
        let xi = if n % 3 == 0 { 0.0 } else { xi };
        let psi = random.sign() * random.log_between(1e-3, if n % 2 == 0 { 10.0 } else { 1e18 });
        let m = theory::creepage(&c, xi, eta, psi);
        for model in [Model::Strip1967, Model::Strip1967Continuous, Model::Strip, Model::Total] {
            let s = solved(&c, &m, &sixteen(model));
            assert!(s.power >= 0.0, "{model:?} {c:?} {m:?} {s:?}");
            (least, mirrored) = (least.min(s.power), mirrored + usize::from(xi == 0.0));
            let over = s.fx.hypot(s.fy) / (c.friction * c.normal_force) - 1.0;
            assert!(over <= 4.0 * f64::EPSILON, "{model:?} {over:e} {c:?} {m:?}");
            most = most.max(over / f64::EPSILON);
            assert!(xi != 0.0 || s.fx == 0.0, "{model:?} {c:?} {m:?} {s:?}");
        }
    }
    println!(
        "least power {least:e} W, |F| at most mu N (1 + {most} eps), fx 0 in {mirrored} \
         mirror-symmetric cases"
    );
}
