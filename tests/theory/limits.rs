//! What must come out exactly: linear derivatives, saturation, pure creepage.

use kstrip_testing::prelude::*;

/// C11 = π²/(4(1 − ν)), C22 = π²/4, C23 = (π/3)√(a/b) for both rules, from
/// forces at vanishing creepage and from the derivatives at zero. The coefficients are defined by
/// Fx = G ab C11 υx, Fy = G ab (C22 υy + √(ab) C23 φ), Mz = −G (ab)^(3/2) C23 υy.
#[test]
fn linear_slopes_are_exact() {
    for axis_ratio in [0.05, 0.3, 1.0, 2.0, 20.0] {
        for nu in [0.0, 0.28, 0.5] {
            let c = contact(axis_ratio, nu);
            let (ab, g) = (c.a * c.b, c.shear_modulus);
            let c11 = PI * PI / (4.0 * (1.0 - nu));
            let c22 = PI * PI / 4.0;
            let c23 = PI / 3.0 * axis_ratio.sqrt();
            for kind in MODELS {
                let o = sixteen(kind);
                // The next term is −(2/π) τ relative to the first: 1e-11
                let tiny = 1e-11 * theory::slip_unit(&c);
                let solve = |x, y, s| {
                    let motion = creep(x, y, s);
                    solved(&c, &motion, &o)
                };
                let along = solve(tiny, 0.0, 0.0);
                let across = solve(0.0, tiny, 0.0);
                let spin = tiny / c.a;
                let turning = solve(0.0, 0.0, spin);
                let zero = creep(0.0, 0.0, 0.0);
                let (_, j) = forces::solve_jacobian(&c, &zero, &o)
                    .unwrap_or_else(|error| panic!("{error:?} {c:?} {o:?}"));
                let near = |got: f64, expected: f64, what: &str| {
                    assert!(
                        (got / expected - 1.0).abs() < 1e-9,
                        "{what}: {got:e} {expected:e} a/b {axis_ratio} ν {nu} {o:?}"
                    );
                };
                near(along.fx, g * ab * c11 * tiny, "C11");
                near(across.fy, g * ab * c22 * tiny, "C22");
                near(turning.fy, g * ab.powf(1.5) * c23 * spin, "C23");
                near(across.mz, -g * ab.powf(1.5) * c23 * tiny, "C32");
                near(j[(0, 0)], g * ab * c11, "dFx/dυx");
                near(j[(1, 1)], g * ab * c22, "dFy/dυy");
                near(j[(1, 2)], g * ab.powf(1.5) * c23, "dFy/dφ");
                near(j[(2, 1)], -g * ab.powf(1.5) * c23, "dMz/dυy");
                // No coupling of the longitudinal direction with the others
                let scale = 1e-12 * g * ab;
                assert!(j[(0, 1)].abs() < scale && j[(1, 0)].abs() < scale);
                assert!(j[(0, 2)].abs() < scale * c.a && j[(2, 0)].abs() < scale * c.a);
                assert!((along.adhesion - 1.0).abs() < 2e-10, "{}", along.adhesion);
            }
        }
    }
}

/// Spin against spin: Mz = (3π/16) b ψ (b/a)/(1 − ν) μN from the longitudinal tractions, i.e.
/// C33 = π² b/(16 a (1 − ν))·… in the same units: the moment that ξ̄ = −pY leaves.
#[test]
fn spin_moment_has_its_linear_slope() {
    for axis_ratio in [0.2, 1.0, 5.0] {
        let c = contact(axis_ratio, 0.28);
        let psi = 1e-10;
        let s = solved(
            &c,
            &creepage(&c, 0.0, 0.0, psi),
            &options(Model::Strip1967, StripCount::SixtyFour),
        );
        // (3/4) b ∫ Y p Y 2C dY with ∫ Y² C dY = π/8
        let expected = 3.0 * PI / 16.0 * c.friction_bound() * c.b * psi * c.b / (c.a * 0.72);
        assert!((s.mz / expected - 1.0).abs() < 3e-9, "{} {expected}", s.mz);
    }
}

/// The totals of both rules are closed forms over the whole ellipse: the number of strips has no
/// part in them, nor in their derivatives.
#[test]
fn any_number_of_strips_has_the_same_totals() {
    let mut random = Random::new(19);
    for n in 0..600 {
        let c = contact(random.log_between(0.05, 20.0), random.between(0.0, 0.5));
        let [xi, eta] = [0; 2].map(|_| random.between(-1.5, 1.5));
        let m = match n % 6 {
            0 => creepage(&c, 0.0, eta, 0.0),
            1 => creepage(&c, 0.0, 0.0, eta),
            _ => creepage(&c, xi, eta, random.between(-2.0, 2.0)),
        };
        for kind in MODELS {
            let [first, others @ ..] = StripCount::ALL.map(|count| {
                let o = options(kind, count);
                (solved(&c, &m, &o), forces::solve_jacobian(&c, &m, &o).unwrap())
            });
            assert!(others.iter().all(|other| *other == first), "{c:?} {m:?} {kind:?}");
        }
    }
}

/// Section 8.15, the way that loses no digits: (3π/4)τ − … as an integral of its own derivative
/// would be another quadrature, so the formula itself, for τ where it does not cancel.
fn pure_creepage(tau: f64) -> f64 {
    if tau >= 1.0 {
        return 1.0;
    }
    1.0 - ((2.0 + tau * tau) * (1.0 - tau * tau).sqrt() - 3.0 * tau * tau.acos()) / 2.0
}

/// Pure creepage in closed form of Section 8.15: both rules along the axes, the continuous rule in
/// any direction; force, moment and stick area, from far below partial slip to far in sliding.
#[test]
fn pure_creepage_has_its_closed_form() {
    let mut worst = 0.0_f64;
    for axis_ratio in [0.1, 1.0, 10.0] {
        let c = contact(axis_ratio, 0.28);
        let sizes = (0..=60).map(|i| f64::from(i) / 50.0);
        for tau in sizes.chain([1e-9, 1e-5, 1e-3, 7.0, 1e6, 1e80]) {
            for (kind, angle) in [
                (Model::Strip1967, 0.0_f64),
                (Model::Strip1967, PI / 2.0),
                (Model::Strip1967, -PI),
                (Model::Strip1967Continuous, 0.0),
                (Model::Strip1967Continuous, 0.7),
                (Model::Strip1967Continuous, -2.4),
            ] {
                // Exact zeros, so that the other component is exactly none
                let clean = |v: f64| if v.abs() < 1e-15 { 0.0 } else { v };
                let (dx, dy) = (clean(angle.cos()), clean(angle.sin()));
                let motion = creepage(&c, tau * dx, tau * dy, 0.0);
                let s = solved(&c, &motion, &sixteen(kind));
                let along = (s.fx * dx + s.fy * dy) / c.friction_bound();
                let across = (s.fx * dy - s.fy * dx) / c.friction_bound();
                assert!(along.is_finite());
                worst = worst.max((along - pure_creepage(tau)).abs());
                assert!(across.abs() < 4e-15, "{tau} {angle}: {across:e}");
                assert!(tau < 1.0 || s.mz.abs() < 1e-12 * c.friction_bound() * c.a.max(c.b));
                let inside = tau.min(1.0);
                let stick = inside.acos() - inside * (1.0 - inside * inside).sqrt();
                assert!((s.adhesion - 2.0 / PI * stick).abs() < 4e-15, "{tau}: {}", s.adhesion);
            }
        }
    }
    // A little spin on much creepage does not matter
    for kind in MODELS {
        let s = solved(&C0, &creepage(&C0, 1e9, 0.0, 0.5), &sixteen(kind));
        assert!((s.fx / C0.friction_bound() - 1.0).abs() < 4e-15);
    }
    println!("worst error {worst:e}");
    // measured 6e-16
    assert!(worst < 5e-15, "{worst:e}");
}
