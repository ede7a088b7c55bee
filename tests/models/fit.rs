//! From measured creep curves to the law of friction, and the law's curves against published ones.

use crate::prelude::*;
use kstrip::friction;
use kstrip::rig::fit::FrictionFit;
use kstrip_testing::reference::Table;

/// The locomotive of `eurosprinter_measured.csv`.
const LOCOMOTIVE: Contact<f64> =
    Contact { a: 6.304e-3, b: 12.61e-3, normal_force: 106.7e3, friction: 0.33, ..C0 };

/// Constant but for the members that are named.
const START: SlipFriction<f64> = falling(0.35, 0.5, 0.3, 10.0, 0.3);

const ONE: [bool; 6] = [true, true, true, true, false, false];
const TWO: [bool; 6] = [true, true, true, true, true, false];

fn total() -> Options {
    Options { model: Model::Total, ..Options::default() }
}

fn along(creepage: f64) -> Creepage<f64> {
    creep(creepage, 0.0, 0.0)
}

fn point(creepage: f64, fx: f64) -> MeasuredForce<f64> {
    measured_force(along(creepage), [fx, f64::NAN], 1)
}

fn measured() -> Vec<MeasuredForce<f64>> {
    let points = numbers("eurosprinter_measured.csv").into_iter();
    points.map(|[percent, share]| point(percent / 100.0, share * LOCOMOTIVE.normal_force)).collect()
}

fn curve(series: &str) -> Vec<MeasuredForce<f64>> {
    let table = Table::read(root().join("tests/data/traction_curves.csv"));
    let own = table.rows().filter(|row| table.text(*row, "series") == series);
    own.map(|row| point(table.number(row, "creepage"), table.number(row, "force_N"))).collect()
}

/// Points on the curve of a law, `count` of them, each at its creepage, times a factor.
fn made(
    law: &SlipFriction<f64>, count: i32, at: impl Fn(f64) -> f64,
    mut factor: impl FnMut(i32) -> f64,
) -> Vec<MeasuredForce<f64>> {
    let point = |i: i32| {
        let creepage = at(f64::from(i));
        point(creepage, behind(&along(creepage), law).fx * factor(i))
    };
    (1..=count).map(point).collect()
}

/// The locomotive's forces under a law.
fn behind(motion: &Creepage<f64>, law: &SlipFriction<f64>) -> Solution<f64> {
    friction::solve_with_law(&LOCOMOTIVE, motion, law, &total()).unwrap().solution
}

fn fit(
    points: &[MeasuredForce<f64>], fitted: [bool; 6], start: SlipFriction<f64>,
) -> FrictionFit<f64> {
    fit_friction(&LOCOMOTIVE, points, &start, fitted, &total()).unwrap()
}

/// Root of the mean of the squares over the load of points below a creepage.
fn rms(points: &[MeasuredForce<f64>], law: &SlipFriction<f64>, below: f64) -> f64 {
    let of = points.iter().filter(|p| p.longitudinal < below).map(|p| {
        ((behind(&along(p.longitudinal), law).fx - p.fx) / LOCOMOTIVE.normal_force).powi(2)
    });
    let squares: Vec<f64> = of.collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

/// Published curves: modified FASTSIM, CONTACT with a layer and falling friction, measured points.
#[test]
fn curves_that_others_published_are_met() {
    for (name, points, one, two) in [
        ("modified FASTSIM", curve("modified_fastsim"), 0.0135, 0.0025),
        ("CONTACT, layer, falling friction", curve("contact_layer_falling"), 0.0040, 0.0022),
        ("measured", measured(), 0.0262, 0.0243),
    ] {
        for (fitted, slide, limit) in [(ONE, 0.0, one), (TWO, 0.5, two)] {
            let found = fit(&points, fitted, SlipFriction { slide_factor: slide, ..START });
            let all = found.residual / LOCOMOTIVE.normal_force;
            let low = rms(&points, &found.law, 0.01);
            println!(
                "{name}: {:.4} below 1 % {low:.4} steps {} {:?} {:.4?} {:.4?}",
                all, found.steps, found.warning, found.law, found.standard_errors
            );
            assert!((all - rms(&points, &found.law, 1.0)).abs() < 1e-9);
            assert!(all < limit && all > 0.7 * limit, "{name} {all}");
            if name == "measured" && slide > 0.0 {
                assert!(low < 0.031, "{low}");
            }
            // (what ends at a bound has no error)
            if name == "measured" {
                assert_eq!((found.law.ratio, found.standard_errors.ratio), (0.0, 0.0));
            }
        }
    }
}

/// On a curve that the law itself made the fit is exact, from far away.
#[test]
fn a_law_finds_itself() {
    let truth = SlipFriction { slide_factor: 0.4, ..START };
    let points = made(&truth, 30, |i| 0.01 * i * i / 30.0, |_| 1.0);
    let start = SlipFriction { rolling_speed: 10.0, ratio: 0.9, ..SlipFriction::of_constant(0.0) };
    let found = fit(&points, TWO, start);
    println!("{found:?}");
    for (found, truth) in [
        (found.law.friction, truth.friction),
        (found.law.ratio, truth.ratio),
        (found.law.decay, truth.decay),
        (found.law.slope_factor, truth.slope_factor),
        (found.law.slide_factor, truth.slide_factor),
    ] {
        assert!((found / truth - 1.0).abs() < 1e-5, "{found} {truth}");
    }
    // so is a layer, and where lateral forces were measured too
    let truth = SlipFriction { layer: 1.2e-13, ..SlipFriction::of_constant(0.3) };
    let points: Vec<_> = (1..=12)
        .map(|i| {
            let size = 2e-4 * f64::from(i * i);
            let motion = creep(size, 0.5 * size, 0.1);
            let Solution { fx, fy, .. } = behind(&motion, &truth);
            MeasuredForce { weight: 2.0, ..measured_force(motion, [fx, fy], 3) }
        })
        .collect();
    let found =
        fit(&points, [true, false, false, false, false, true], SlipFriction::of_constant(0.0));
    assert!((found.law.layer / truth.layer - 1.0).abs() < 1e-5, "{found:?}");
    assert!((found.law.friction / truth.friction - 1.0).abs() < 1e-6);
    assert_eq!(found.warning, Warning::None);
}

/// With noise of 2 % the parameters come back within their standard errors: of many, 68 % within
/// one.
#[test]
fn standard_errors_are_those_of_the_noise() {
    let truth = SlipFriction { slide_factor: 0.5, slope_factor: 0.4, ..START };
    let mut random = Random::new(311);
    let (mut within, mut all, mut worst) = (0, 0, 0.0_f64);
    for _ in 0..40 {
        // nearly normal
        let mut noise = |_| 1.0 + 0.02 * (0..12).map(|_| random.between(-0.5, 0.5)).sum::<f64>();
        let points = made(&truth, 30, |i| 0.08 * (i / 30.0).powi(2), &mut noise);
        let found = fit(&points, ONE, SlipFriction { slide_factor: 0.5, ..START });
        for (of, error, truth) in [
            (found.law.friction, found.standard_errors.friction, truth.friction),
            (found.law.slope_factor, found.standard_errors.slope_factor, truth.slope_factor),
        ] {
            let off = ((of - truth) / error).abs();
            within += usize::from(off < 1.0);
            worst = worst.max(off);
            all += 1;
        }
    }
    println!("{within} of {all}, worst {worst}");
    assert!((0.5..0.85).contains(&(within as f64 / all as f64)), "{within} of {all}");
    assert!(worst < 4.0, "{worst}");
}

/// Points in adhesion only bound friction from below.
#[test]
fn points_that_do_not_tell_are_named() {
    let truth = SlipFriction { slope_factor: 0.3, ..SlipFriction::of_constant(0.35) };
    let points = |largest: f64| made(&truth, 20, |i| largest * i / 20.0, |_| 1.0);
    let which = [true, false, false, true, false, false];
    let start = SlipFriction::of_constant(0.3);
    assert_eq!(fit(&points(1e-4), which, start).warning, Warning::Undetermined);
    assert_eq!(fit(&points(2e-2), which, start).warning, Warning::None);
    // measured points below 1 % do not tell how friction falls
    let low: Vec<_> = measured().into_iter().filter(|p| p.longitudinal < 0.01).collect();
    let start = SlipFriction { slide_factor: 0.5, ..START };
    assert_eq!(fit(&low, ONE, start).warning, Warning::Undetermined);
    assert_eq!(fit(&low, which, start).warning, Warning::None);
}

#[test]
fn undetermined_begins_at_half_of_a_parameter() {
    let which = [true, false, false, true, false, false];
    let truth = SlipFriction { slope_factor: 0.3, ..SlipFriction::of_constant(0.35) };
    let fitted = |noise: f64| {
        let mut points = made(&truth, 30, |i| 4e-3 * i / 30.0, |_| 1.0);
        for (point, sign) in points.iter_mut().zip([-1.0, -1.0, 1.0, 1.0].iter().cycle()) {
            point.fx += sign * noise * 106.7e3;
        }
        fit(&points, which, SlipFriction::of_constant(0.3))
    };
    let ends = [0.01, 1.0];
    let warnings = ends.map(|noise| fitted(noise).warning);
    assert_eq!(warnings, [Warning::None, Warning::Undetermined]);
    let is_low = |noise| fitted(noise).warning != Warning::Undetermined;
    let found = fitted(bisect(ends, 1e-6, is_low)[0]);
    let share = (found.standard_errors.friction / found.law.friction)
        .max(found.standard_errors.slope_factor / found.law.slope_factor);
    assert!((share - 0.5).abs() < 5e-3, "{share} {found:?}");
}

#[test]
fn bad_points_are_named() {
    let good = [point(1e-3, 10e3), point(1e-2, 30e3)];
    let which = [true, false, false, true, false, false];
    let of = |points: &[MeasuredForce<f64>], which| {
        fit_friction(&LOCOMOTIVE, points, &SlipFriction::of_constant(0.3), which, &total())
            .map(|_| ())
    };
    assert_eq!(of(&good, which), Ok(()));
    assert_eq!(of(&good[..1], which), Err((1, Error::FewPoints)));
    assert_eq!(of(&good, [false; 6]), Err((2, Error::FitParameters)));
    let [first, second] = good;
    let without = MeasuredForce { weight: 0.0, ..second };
    let spins = MeasuredForce { spin: f64::NAN, ..first };
    assert_eq!(of(&[spins, second], which), Err((0, Error::NotFinite)));
    for (bad, error) in [
        (MeasuredForce { fx: f64::NAN, ..second }, Error::NotFinite),
        (MeasuredForce { weight: -1.0, ..second }, Error::Weight),
        (MeasuredForce { measured: 4, ..second }, Error::Measured),
    ] {
        assert_eq!(of(&[first, bad], which), Err((1, error)));
    }
    assert_eq!(of(&[first, without], which), Err((2, Error::FewPoints)));
    let start = SlipFriction::of_constant(0.3);
    for (start, error) in [
        (SlipFriction { layer: -1.0, ..start }, Error::Layer),
        (SlipFriction { slide_factor: 1.5, ..start }, Error::SlideFactor),
    ] {
        let found = fit_friction(&LOCOMOTIVE, &good, &start, which, &total());
        assert_eq!(found.map(|_| ()), Err((2, error)));
    }
}

/// Polach's formula with his published sets: `k = (k_A + k_S)/2`, `k₁ = 0.33 k_S/(k_A + k_S)`. He
/// takes the whole creepage for the slip, which here is smaller: his `B` counts 1.2 times.
#[test]
fn polachs_sets_are_met() {
    let c = Contact { a: 7.5e-3, b: 5e-3, normal_force: 100e3, ..LOCOMOTIVE };
    let LinearCoefficients { c11, .. } = LinearCoefficients::at(c.a / c.b, c.poisson_ratio);
    let mut errors = Vec::new();
    for (ka, ks, friction, ratio, decay) in [
        (1.0, 0.4, 0.55, 0.4, 0.6),
        (0.3, 0.1, 0.3, 0.4, 0.2),
        (0.2, 0.07, 0.06, 0.4, 0.2),
        (0.1, 0.04, 0.03, 0.4, 0.1),
    ] {
        for rolling_speed in [2.0, 10.0, 30.0] {
            let law = falling(friction, ratio, 1.2 * decay, rolling_speed, (ka + ks) / 2.0);
            let law = SlipFriction { slide_factor: 0.33 * ks / (ka + ks), ..law };
            let creepages = (0..60)
                .map(|i| 1e-4 + (0.01 - 1e-4) * f64::from(i) / 59.0)
                .chain((0..60).map(|i| 0.012 + (0.2 - 0.012) * f64::from(i) / 59.0));
            for x in creepages {
                let w = x * rolling_speed;
                let mu = friction * ((1.0 - ratio) * (-decay * w).exp() + ratio);
                let eps = c.shear_modulus * PI * c.a * c.b * c11 / (4.0 * c.normal_force * mu) * x;
                let arc = (ks * eps).atan();
                let polach = 2.0 * mu / PI * (ka * eps / (1.0 + (ka * eps).powi(2)) + arc);
                let found =
                    friction::solve_with_law(&c, &along(x), &law, &total()).unwrap().solution;
                errors.push((found.fx / c.normal_force - polach).abs() / friction);
            }
        }
    }
    let [mean, high, worst] = statistics(&errors);
    println!("Polach {mean:.4} {high:.4} {worst:.4}");
    assert!(mean < 0.018 && high < 0.037 && worst < 0.05, "{mean} {high} {worst}");
    let told = format!("Polach's formula, four published sets | {mean:.3} `μ0 N` | {worst:.3}");
    assert_told("docs/evidence/adhesion.md", &told);
}

/// The law with the members that docs/reference/other-programs.md makes of modified FASTSIM's
/// `k₀, α, β`, against forces whose stiffness changes with the slip as there:
/// `k = k₀ (α + (1 − α)/(1 + β ε))`, `ε = (π/4) k₀ G a b C11 υx/(μ N)`.
#[test]
fn modified_fastsims_stiffness_is_met() {
    let c = LOCOMOTIVE;
    let LinearCoefficients { c11, .. } = LinearCoefficients::at(c.a / c.b, c.poisson_ratio);
    let linear = PI / 4.0 * c.shear_modulus * c.a * c.b * c11 / c.friction_bound();
    let mut errors = Vec::new();
    for slope in [0.2, 0.4, 0.6, 0.8, 1.0] {
        for alpha in [0.02, 0.1, 0.3, 0.5, 0.8, 1.0] {
            for beta in [0.1, 0.2, 0.4, 0.6, 0.8_f64] {
                let cubed = beta.powi(3);
                let lost = (1.0 - alpha) * (1.0 - alpha) * cubed / (2.3 + 1.45 * cubed);
                let left = alpha + (1.0 - alpha) / (1.0 + 3.4 * beta + 11.0 * cubed);
                let law = falling(c.friction, 1.0, 0.0, 0.0, slope * (1.0 - lost));
                let law = SlipFriction { slide_factor: 0.83 * left, ..law };
                for i in 0..30 {
                    let x = 1e-4 * 1000_f64.powf(f64::from(i) / 29.0);
                    let by_slip = alpha + (1.0 - alpha) / (1.0 + beta * slope * linear * x);
                    let softer = Contact { shear_modulus: c.shear_modulus * slope * by_slip, ..c };
                    let wanted = forces_of_contact(&softer, &along(x), &total()).unwrap();
                    let off = behind(&along(x), &law).fx - wanted.fx;
                    errors.push(off.abs() / c.friction_bound());
                }
            }
        }
    }
    let [mean, _, worst] = statistics(&errors);
    println!("modified FASTSIM {mean:.4} {worst:.4}");
    assert!(mean < 0.007 && worst < 0.05, "{mean} {worst}");
    let told = format!("same change of stiffness in TOTAL | {mean:.3} `μ0 N` | {worst:.3}");
    assert_told("docs/evidence/adhesion.md", &told);
}

#[test]
fn friction_is_estimated_under_the_law() {
    let mut random = Random::new(312);
    for n in 0..60 {
        let law = match n % 3 {
            0 => SlipFriction { slope_factor: 0.28, ..SlipFriction::of_constant(0.33) },
            1 => SlipFriction { friction: 0.33, slide_factor: 0.4, ..START },
            _ => SlipFriction { layer: 1.5e-13, ..SlipFriction::of_constant(0.33) },
        };
        let creepage = [5e-4, 2e-3, 5e-3, 1.5e-2][n / 3 % 4];
        let spin = if n < 12 { 0.0 } else { random.between(-0.3, 0.3) };
        let m = Creepage { spin, ..along(creepage) };
        let made = behind(&m, &law);
        let other = SlipFriction { friction: f64::from(n as u32 % 7) * 0.1, ..law };
        let found = estimate_friction(
            &LOCOMOTIVE,
            &m,
            Some(&other),
            &total(),
            Measured::Fx,
            [made.fx, 0.0],
        );
        let found = found.unwrap();
        if found.warning == Warning::FrictionAtLeast {
            assert!(creepage < 1e-3 && found.friction <= 0.33);
            continue;
        }
        assert!((found.friction / 0.33 - 1.0).abs() < 1e-8, "{law:?} {m:?} {found:?}");
        let (back, warning) =
            creepage_for_force(&LOCOMOTIVE, [made.fx, made.fy], spin, Some(&law), &total())
                .unwrap();
        let again = behind(&back, &law);
        if warning == Warning::None {
            assert!(
                (again.fx - made.fx).hypot(again.fy - made.fy) < 1e-6 * made.fx.abs(),
                "{law:?} {m:?} {back:?}"
            );
        } else {
            // beyond the maximum of falling friction, or full sliding
            assert!(creepage > 4e-3, "{law:?} {m:?} {warning:?}");
        }
    }
}

/// The law's friction at every creepage, and what clean bodies would need: far less, without a
/// warning.
#[test]
fn a_slope_factor_is_not_taken_for_low_friction() {
    let law = SlipFriction { slope_factor: 0.28, ..SlipFriction::of_constant(0.33) };
    let other = SlipFriction { friction: 0.7, ..law };
    for (creepage, clean) in [(5e-4, 0.031), (2e-3, 0.113), (5e-3, 0.235), (1.5e-2, 0.330)] {
        let m = along(creepage);
        let made = behind(&m, &law);
        let estimate = |law: Option<&SlipFriction<f64>>| {
            let force = [made.fx, 0.0];
            estimate_friction(&LOCOMOTIVE, &m, law, &total(), Measured::Fx, force).unwrap()
        };
        let [under, without] = [estimate(Some(&other)), estimate(None)];
        assert_eq!((under.warning, without.warning), (Warning::None, Warning::None));
        assert!((under.friction - 0.33).abs() < 1e-9, "{creepage}: {under:?}");
        assert!((without.friction - clean).abs() < 6e-4, "{creepage}: {without:?}");
    }
}

#[test]
fn the_error_of_a_layer_is_a_share_of_it() {
    let truth = SlipFriction { layer: 1.2e-13, ..START };
    let truth = SlipFriction { ratio: 1.0, slope_factor: 0.0, ..truth };
    let off = |i: i32| if i % 2 == 0 { 1.01 } else { 0.99 };
    let points = made(&truth, 20, |i| 2e-5 * i * i, off);
    let found = fit(&points, [true, false, false, false, false, true], truth);
    let share = found.standard_errors.layer / found.law.layer;
    assert!(share > 1e-3 && share < 0.1, "{found:?}");
}

/// Laws of all kinds from starts of all kinds: exact points come back, unless a warning names what
/// is not determined.
#[test]
fn the_start_of_a_fit_does_not_matter() {
    let mut random = Random::new(4446);
    let cases = std::env::var("KSTRIP_FITS").map_or(120, |cases| cases.parse().unwrap());
    let (mut exact, mut warned) = (0, [0; 3]);
    for k in 0..cases {
        let truth = SlipFriction {
            friction: random.log_between(0.05, 0.6),
            ratio: random.between(0.1, 0.9),
            decay: random.log_between(0.05, 3.0),
            rolling_speed: random.log_between(1.0, 60.0),
            slope_factor: random.log_between(0.06, 1.0),
            slide_factor: random.between(0.1, 1.0),
            layer: 0.0,
        };
        let mut fitted = [0; 6].map(|_| random.unit() < 0.5);
        fitted[5] = false;
        fitted[0] |= !fitted.contains(&true);
        let far = random.log_between(1.0, 1e6);
        let mut off = |x: f64, most: f64| (x * random.log_between(1.0 / far, far)).min(most);
        let changed = SlipFriction {
            friction: off(truth.friction, 1e5),
            ratio: off(truth.ratio, 1.0),
            decay: off(truth.decay, 1e5),
            slope_factor: off(truth.slope_factor, 1.0),
            slide_factor: off(truth.slide_factor, 1.0),
            ..truth
        };
        let [a, b, c, d, e, _] = fitted;
        let start = SlipFriction {
            friction: if a { changed.friction } else { truth.friction },
            ratio: if b { changed.ratio } else { truth.ratio },
            decay: if c { changed.decay } else { truth.decay },
            slope_factor: if d { changed.slope_factor } else { truth.slope_factor },
            slide_factor: if e { changed.slide_factor } else { truth.slide_factor },
            ..truth
        };
        let points = made(&truth, 16, |i| 4e-4 * 1.3_f64.powf(i), |_| 1.0);
        let found = fit(&points, fitted, start);
        match found.warning {
            Warning::Undetermined => warned[0] += 1,
            Warning::SecondMinimum => warned[1] += 1,
            Warning::FitBound => warned[2] += 1,
            other => {
                assert_eq!(other, Warning::None, "{k} {truth:?} {start:?} {fitted:?} {found:?}");
                exact += 1;
                let (own, law) = (&truth, &found.law);
                for (one, other) in [
                    (own.friction, law.friction),
                    (own.ratio, law.ratio),
                    (own.decay, law.decay),
                    (own.slope_factor, law.slope_factor),
                    (own.slide_factor, law.slide_factor),
                ] {
                    let is_near = (one - other).abs() <= 1e-6 * one.max(1e-3);
                    assert!(is_near, "{k} {truth:?} {start:?} {fitted:?} {found:?}");
                }
            }
        }
    }
    println!("exact {exact}, undetermined, second minimum, bound {warned:?} of {cases}");
    assert!(exact * 2 > cases);
}

/// Exact points next to whose law there is a local minimum of the residual.
#[test]
fn a_local_minimum_is_left() {
    let of_1967 = Options { model: Model::Strip1967, ..Options::default() };
    let contact = |[a, b, normal_force]: [f64; 3]| Contact { a, b, normal_force, ..LOCOMOTIVE };
    for (options, contact, [from, angle], count, truth, start, fitted) in [
        (
            of_1967,
            contact([7.06174e-3, 7.19966e-3, 77_055.4]),
            [5.130_46e-5, 2.166_952_8],
            21,
            SlipFriction {
                slide_factor: 0.438_883,
                ..falling(0.129_360_3, 0.747_327, 1.179_543, 24.269_94, 0.290_335)
            },
            SlipFriction { slide_factor: 0.1965, ..falling(8.748_57, 1.0, 1e3, 24.269_94, 1.0) },
            TWO,
        ),
        (
            total(),
            contact([2.92771e-3, 2.84759e-3, 73_218.0]),
            [2.0974e-4, 1.987_620_3],
            18,
            falling(0.059_884_9, 0.659_704, 2.429_919, 24.438_31, 0.102_1),
            falling(7.114_88e-3, 0.659_704, 64.9925, 24.438_31, 9.016_45e-4),
            [true, false, true, true, false, false],
        ),
    ] {
        let growth = (0.05_f64 / from).powf(1.0 / f64::from(count - 1));
        let points: Vec<_> = (0..count)
            .map(|i| {
                let size = from * growth.powi(i);
                let motion = creep(size * angle.cos(), size * angle.sin(), 0.0);
                let found = friction::solve_with_law(&contact, &motion, &truth, &options).unwrap();
                let Solution { fx, fy, .. } = found.solution;
                measured_force(motion, [fx, fy], 3)
            })
            .collect();
        let found = fit_friction(&contact, &points, &start, fitted, &options).unwrap();
        assert_eq!(found.warning, Warning::None);
        assert_relative_eq!(found.law.friction, truth.friction, max_relative = 1e-6);
        assert_relative_eq!(found.law.decay, truth.decay, max_relative = 1e-6);
    }
}

/// Points that lie above any law end at its bound, and a warning names that.
#[test]
fn a_bound_is_named() {
    let law = falling(0.3, 0.5, 0.5, 10.0, 1.0);
    // the curve is steeper than that of clean bodies
    let points = made(&law, 10, |i| 2e-4 * i, |_| 1.5);
    let start = SlipFriction { friction: 0.45, ..law };
    let found = fit(&points, [false, false, false, true, false, false], start);
    assert_eq!((found.warning, found.law.slope_factor), (Warning::FitBound, 1.0));
    assert_eq!(found.standard_errors.slope_factor, 0.0);
}

/// Creepages in per cent give the same law with a slope factor that is too small, and its warning
/// goes before that of a ratio at its bound.
#[test]
fn creepages_in_per_cent_are_told() {
    let in_per_cent = |point: MeasuredForce<f64>| MeasuredForce {
        longitudinal: 100.0 * point.longitudinal,
        ..point
    };
    let points: Vec<_> = measured().into_iter().map(in_per_cent).collect();
    let found = fit(&points, ONE, START);
    assert_eq!(found.warning, Warning::PerCent);
    assert!(found.law.slope_factor < 0.05, "{found:?}");
    for (slope_factor, told) in [(0.0495, Warning::PerCent), (0.0505, Warning::None)] {
        let law = falling(0.3, 0.5, 0.3, 10.0, slope_factor);
        let points = made(&law, 10, |i| 4e-3 * i, |_| 1.0);
        let start = SlipFriction { friction: 0.4, slope_factor: 0.2, ..law };
        let found = fit(&points, [true, false, false, true, false, false], start);
        assert_eq!(found.warning, told, "{slope_factor}");
    }
    let right = fit(&measured(), ONE, START);
    assert_ne!(right.warning, Warning::PerCent);
    assert_relative_eq!(right.residual, found.residual, max_relative = 1e-3);
}
