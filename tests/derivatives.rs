//! The derivatives of `solve_jacobian` against differences of `solve`.

#[path = "common/random.rs"]
mod random;
#[path = "common/theory.rs"]
mod theory;

use kstrip::contact::Contact;
use kstrip::creepage::Creepage;
use kstrip::model::{self, Options};
use kstrip::totals::StripCount;
use random::Random;
use theory::{COUNTS, MODELS, contact, options};

/// Forces over μN and moment over μN√(ab) for given parameters.
fn forces(c: &Contact<f64>, p: [f64; 3], o: &Options) -> [f64; 3] {
    let s = model::solve(c, &theory::creepage(c, p[0], p[1], p[2]), o).unwrap();
    let unit = c.friction * c.normal_force;
    [s.fx / unit, s.fy / unit, s.mz / (unit * (c.a * c.b).sqrt())]
}

/// d(fx, fy, mz)/d(ξ, η, ψ) from the derivatives with respect to the creepages.
fn slopes(c: &Contact<f64>, p: [f64; 3], o: &Options) -> [[f64; 3]; 3] {
    let (_, j) = model::solve_jacobian(c, &theory::creepage(c, p[0], p[1], p[2]), o).unwrap();
    let unit = c.friction * c.normal_force;
    let rows = [unit, unit, unit * (c.a * c.b).sqrt()];
    let slip = theory::slip_unit(c);
    let columns = [slip * (1.0 - c.poisson_ratio), slip, slip / c.a];
    std::array::from_fn(|i| std::array::from_fn(|k| j[(i, k)] * columns[k] / rows[i]))
}

/// Central differences with h, h/2, h/4, extrapolated; and how far the last two extrapolations differ:
/// an error of the order h or h² betrays a kink within the stencil.
fn differences(f: &dyn Fn(f64) -> [f64; 3], h: f64) -> ([f64; 3], [f64; 3]) {
    let central = |h: f64| {
        let (ahead, behind) = (f(h), f(-h));
        std::array::from_fn::<f64, 3, _>(|i| (ahead[i] - behind[i]) / (2.0 * h))
    };
    let (d1, d2, d4) = (central(h), central(h / 2.0), central(h / 4.0));
    let (mut result, mut doubt) = ([0.0; 3], [0.0; 3]);
    for i in 0..3 {
        let (r1, r2) = ((4.0 * d2[i] - d1[i]) / 3.0, (4.0 * d4[i] - d2[i]) / 3.0);
        result[i] = (16.0 * r2 - r1) / 15.0;
        doubt[i] = (r2 - r1).abs();
    }
    (result, doubt)
}

/// Thousands of random points, both rules, every count, |ψ| ≤ 0.98: 1e-7 of the size of the row. Points
/// with a breakpoint of the computed function inside the stencil show themselves by differences that
/// do not converge; a smaller stencil usually escapes it.
#[test]
fn derivatives_are_those_of_the_computed_forces() {
    check(3_000, 61, |random| {
        [random.between(-1.3, 1.3), random.between(-1.3, 1.3), random.between(-0.98, 0.98)]
    });
}

/// Beyond unit spin with lateral creepage along the spin: everything slides, about a moving strip.
#[test]
fn derivatives_of_full_sliding_beyond_unit_spin() {
    check(600, 65, |random| {
        let psi = random.sign() * random.between(1.001, 3.0);
        [random.between(-0.8, 0.8), psi.signum() * random.between(0.01, 1.3), psi]
    });
}

/// Beyond unit spin with lateral creepage against it, where some strips adhere.
#[test]
fn derivatives_beyond_unit_spin() {
    check(1_000, 62, |random| {
        let psi = random.sign() * random.between(1.001, 3.0);
        [random.between(-0.8, 0.8), -psi.signum() * random.between(0.0, 1.3), psi]
    });
}

/// Small parameters, where forces are almost linear and the adhesion interval is almost everything.
#[test]
fn derivatives_at_small_creepage() {
    check(1_000, 63, |random| {
        let size = random.log_between(1e-3, 1e-1);
        [0; 3].map(|_| size * random.between(-1.0, 1.0))
    });
}

fn check(points: usize, seed: u64, next: impl Fn(&mut Random) -> [f64; 3]) {
    let mut random = Random::new(seed);
    let mut skipped = 0;
    let mut worst = 0.0_f64;
    let mut wrong = Vec::new();
    for n in 0..points {
        let c = contact(random.log_between(0.1, 10.0), random.between(0.0, 0.5));
        let o = options(MODELS[n % 2], COUNTS[n / 2 % 5]);
        let p = next(&mut random);
        let exact = slopes(&c, p, &o);
        // Size of each row, so that small entries are measured against what they stand beside
        let size: [f64; 3] =
            std::array::from_fn(|i| exact[i].iter().fold(0.1, |m, d| d.abs().max(m)));
        for k in 0..3 {
            let f = |t: f64| {
                let mut q = p;
                q[k] += t;
                forces(&c, q, &o)
            };
            let Some(got) = [1e-3, 1e-4, 1e-5].into_iter().find_map(|h| {
                let (got, doubt) = differences(&f, h);
                // Rounding of the differences is 1e-16/h/4 ~ 1e-11 at the smallest
                (0..3).all(|i| doubt[i] < 3e-8 * size[i]).then_some(got)
            }) else {
                skipped += 1;
                continue;
            };
            for i in 0..3 {
                let error = (got[i] - exact[i][k]).abs() / size[i];
                worst = worst.max(error);
                if error >= 1e-7 || error.is_nan() {
                    wrong.push(format!(
                        "row {i}, column {k}: {:e} against {:e} at {p:?} {o:?} a/b {} ν {}",
                        exact[i][k],
                        got[i],
                        c.a / c.b,
                        c.poisson_ratio
                    ));
                }
            }
        }
    }
    println!("{skipped} of {} stencils skipped, worst {worst:e}", 3 * points);
    let some = wrong.iter().take(6).cloned().collect::<Vec<_>>().join("\n");
    assert!(
        wrong.is_empty(),
        "{} of {} entries, worst {worst:e}:\n{some}",
        wrong.len(),
        9 * points
    );
    assert!(skipped * 50 < 3 * points, "{skipped} of {} stencils met a breakpoint", 3 * points);
}

/// `solve_jacobian` returns the forces of `solve`, to the last bits.
#[test]
fn solution_beside_the_derivatives_is_the_solution() {
    let mut random = Random::new(64);
    for n in 0..3_000 {
        let c = contact(random.log_between(0.1, 10.0), random.between(0.0, 0.5));
        let o = options(MODELS[n % 2], COUNTS[n / 2 % 5]);
        let m = theory::creepage(
            &c,
            random.between(-1.3, 1.3),
            random.between(-1.3, 1.3),
            random.between(-2.0, 2.0),
        );
        let one = model::solve(&c, &m, &o).unwrap();
        let (two, _) = model::solve_jacobian(&c, &m, &o).unwrap();
        let unit = c.friction * c.normal_force;
        // The order of operations may differ, nothing else
        assert!((one.fx - two.fx).abs() < 1e-13 * unit && (one.fy - two.fy).abs() < 1e-13 * unit);
        assert!((one.mz - two.mz).abs() < 1e-13 * unit * (c.a + c.b));
        assert!((one.adhesion - two.adhesion).abs() < 1e-13);
        assert_eq!(one.notice, two.notice);
    }
}

/// In full sliding the force only turns: no derivative along the slip direction, μN/slip across it.
#[test]
fn saturated_force_has_no_derivative_along_the_slip() {
    for axis_ratio in [0.2, 1.0, 5.0] {
        let c = contact(axis_ratio, 0.28);
        for o in COUNTS.into_iter().flat_map(|n| MODELS.map(|m| options(m, n))) {
            for angle in 0..12 {
                let (sine, cosine) = (0.3 + f64::from(angle) * 0.52_f64).sin_cos();
                let p = [3.0 * cosine, 3.0 * sine, 0.0];
                let j = slopes(&c, p, &o);
                for row in &j {
                    let along = row[0] * cosine + row[1] * sine;
                    assert!(along.abs() < 1e-13, "{o:?}: {along:e}");
                }
                // Continuous rule: F = (ξ, η)/τ, so ∂Fx/∂ξ = sin²/τ
                if o.model == MODELS[1] {
                    assert!((j[0][0] - sine * sine / 3.0).abs() < 1e-13);
                    assert!((j[0][1] + sine * cosine / 3.0).abs() < 1e-13);
                }
            }
        }
    }
}

/// At rest the derivatives are the linear slopes and all finite, also in single precision.
#[test]
fn derivatives_at_rest_are_the_linear_slopes() {
    use std::f64::consts::PI;
    for axis_ratio in [0.1, 1.0, 10.0] {
        let c = contact(axis_ratio, 0.28);
        for o in COUNTS.into_iter().flat_map(|n| MODELS.map(|m| options(m, n))) {
            for size in [0.0, 1e-300, 1e-200, 1e-160, 1e-150, 1e-100, 1e-30, 1e-12] {
                for direction in
                    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.3, -0.5, 0.7]]
                {
                    let p = direction.map(|d| d * size);
                    let j = slopes(&c, p, &o);
                    // 32 strips cut the adhesion interval where ξ̄ = 0; the cut moves with ξ/ψ, and with it
                    // the quadrature of the odd part p ∫ Y C dY
                    let split = o.strips == StripCount::ThirtyTwo && p[2] != 0.0;
                    let allowed = if split { 1e-5 } else { 1e-9 };
                    assert!((j[0][0] - 0.75 * PI).abs() < allowed, "{o:?} {p:?} {j:?}");
                    assert!((j[1][1] - 0.75 * PI).abs() < 1e-9, "{o:?} {p:?} {j:?}");
                    assert!((j[1][2] - 1.0).abs() < 1e-9, "{o:?} {p:?} {j:?}");
                    assert!(j[0][1].abs() < 1e-9 && j[1][0].abs() < 1e-9, "{o:?} {p:?} {j:?}");
                }
            }
        }
        let single = Contact::<f32> {
            a: c.a as f32,
            b: c.b as f32,
            normal_force: c.normal_force as f32,
            shear_modulus: c.shear_modulus as f32,
            poisson_ratio: c.poisson_ratio as f32,
            friction: c.friction as f32,
        };
        let rest = Creepage { longitudinal: 0.0_f32, lateral: 0.0, spin: 0.0 };
        for count in COUNTS {
            let (_, j) = model::solve_jacobian(&single, &rest, &options(MODELS[0], count)).unwrap();
            let expected = c.shear_modulus * c.a * c.b * PI * PI / 4.0;
            assert!((f64::from(j[(1, 1)]) / expected - 1.0).abs() < 1e-5);
        }
    }
}
