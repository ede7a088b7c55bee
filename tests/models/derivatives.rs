//! The derivatives of `solve_jacobian` against differences of `solve`.

use crate::prelude::*;
use kstrip::forces::derivatives;
use kstrip_testing::single;

/// Forces divided by `μ N` and moment by `μ N √(ab)`, for given parameters.
fn forces(c: &Contact<f64>, p: [f64; 3], o: &Options) -> [f64; 3] {
    normalised(c, &solved(c, &theory::creepage(c, p[0], p[1], p[2]), o))
}

/// d(fx, fy, mz)/d(ξ, η, ψ) from the derivatives with respect to the creepages.
fn slopes(c: &Contact<f64>, p: [f64; 3], o: &Options) -> [[f64; 3]; 3] {
    let (_, j) = forces::solve_jacobian(c, &theory::creepage(c, p[0], p[1], p[2]), o).unwrap();
    let unit = c.friction * c.normal_force;
    let rows = [unit, unit, unit * (c.a * c.b).sqrt()];
    let slip = theory::slip_unit(c);
    let columns = [slip * (1.0 - c.poisson_ratio), slip, slip / c.a];
    std::array::from_fn(|i| std::array::from_fn(|k| j[(i, k)] * columns[k] / rows[i]))
}

/// Thousands of random points, every count: 1e-7 of the size of the row. Points with a breakpoint
/// of the computed function inside the stencil show themselves by differences that do not converge;
/// a smaller stencil usually escapes it.
#[test]
fn derivatives_are_those_of_the_computed_forces() {
    let beyond = |random: &mut Random| random.sign() * random.between(1.001, 3.0);
    let anywhere = |random: &mut Random, low: f64, high: f64| {
        let size = random.log_between(low, high);
        [0; 3].map(|_| size * random.between(-1.0, 1.0))
    };
    // both rules up to |ψ| = 0.98
    check_models(&MODELS, 3_000, 61, |random| {
        [random.between(-1.3, 1.3), random.between(-1.3, 1.3), random.between(-0.98, 0.98)]
    });
    // with lateral creepage along the spin everything slides, about a moving strip
    check_models(&MODELS, 600, 65, |random| {
        let psi = beyond(random);
        [random.between(-0.8, 0.8), psi.signum() * random.between(0.01, 1.3), psi]
    });
    // with lateral creepage against it some strips adhere
    check_models(&MODELS, 1_000, 62, |random| {
        let psi = beyond(random);
        [random.between(-0.8, 0.8), -psi.signum() * random.between(0.0, 1.3), psi]
    });
    // where forces are almost linear and the adhesion interval is almost everything
    check_models(&MODELS, 1_000, 63, |random| anywhere(random, 1e-3, 1e-1));
    // the models after 1967, up to the spin they are fitted for
    let later = [Model::Strip, Model::Total, Model::Linear];
    check_models(&later, 3_000, 66, |random| anywhere(random, 1e-3, 3.0));
}

fn check_models(
    models: &[Model], points: usize, seed: u64, next: impl Fn(&mut Random) -> [f64; 3],
) {
    let mut random = Random::new(seed);
    let mut comparison = Comparison::default();
    for n in 0..points {
        let c = any_contact(&mut random);
        let o = options(models[n % models.len()], StripCount::ALL[n / models.len() % 5]);
        let p = next(&mut random);
        let exact = slopes(&c, p, &o);
        // Size of each row, so that small entries are measured against what they stand beside
        let size: [f64; 3] =
            std::array::from_fn(|i| exact[i].iter().fold(0.1, |m, d| d.abs().max(m)));
        for k in 0..3 {
            let at = |t: f64| {
                let mut q = p;
                q[k] += t;
                forces(&c, q, &o)
            };
            let column = exact.map(|row| row[k]);
            comparison.column(&at, column, size, 1e-7, &(k, p, o, c));
        }
    }
    comparison.assert_few_kinks(50);
}

#[test]
fn derivatives_at_rest_are_the_linear_slopes() {
    for axis_ratio in [0.1, 1.0, 10.0] {
        let c = contact(axis_ratio, 0.28);
        for o in MODELS.map(sixteen) {
            for size in [0.0, 1e-300, 1e-200, 1e-160, 1e-150, 1e-100, 1e-30, 1e-12] {
                for direction in
                    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.3, -0.5, 0.7]]
                {
                    let p = direction.map(|d| d * size);
                    let j = slopes(&c, p, &o);
                    assert!((j[0][0] - 0.75 * PI).abs() < 2e-10, "{o:?} {p:?} {j:?}");
                    assert!((j[1][1] - 0.75 * PI).abs() < 6e-11, "{o:?} {p:?} {j:?}");
                    assert!((j[1][2] - 1.0).abs() < 3e-11, "{o:?} {p:?} {j:?}");
                    assert!(j[0][1].abs() < 1e-9 && j[1][0].abs() < 1e-9, "{o:?} {p:?} {j:?}");
                }
            }
        }
        let single = single::single(&c);
        let rest = creep(0.0_f32, 0.0, 0.0);
        let (_, j) = forces::solve_jacobian(&single, &rest, &sixteen(MODELS[0])).unwrap();
        let expected = c.shear_modulus * c.a * c.b * PI * PI / 4.0;
        assert!((f64::from(j[(1, 1)]) / expected - 1.0).abs() < 3e-7);
    }
}

/// What is differentiated by, as a relative change `t`.
#[derive(Clone, Copy, Debug)]
enum Change {
    Load,
    Friction,
    Hertz,
}

impl Change {
    fn of(self, c: &Contact<f64>, t: f64) -> Contact<f64> {
        match self {
            Self::Load => Contact { normal_force: c.normal_force * (1.0 + t), ..*c },
            Self::Friction => Contact { friction: c.friction * (1.0 + t), ..*c },
            Self::Hertz => {
                // Hertz: a, b ~ N^{1/3}
                let growth = (1.0 + t).cbrt();
                let normal_force = c.normal_force * (1.0 + t);
                Contact { a: c.a * growth, b: c.b * growth, normal_force, ..*c }
            }
        }
    }

    /// The derivative with respect to `t`, in the units of `unit`.
    fn slope(self, c: &Contact<f64>, d: &Derivatives<f64>) -> [f64; 3] {
        let (vector, factor) = match self {
            Self::Load => (d.normal_force, c.normal_force),
            Self::Friction => (d.friction, c.friction),
            Self::Hertz => (d.load_through_hertz, c.normal_force),
        };
        let size = c.friction * c.normal_force;
        let units = [size, size, size * (c.a * c.b).sqrt()];
        std::array::from_fn(|i| vector[i] * factor / units[i])
    }
}

/// Load, friction and load through Hertz, every model, from nearly linear to full sliding.
#[test]
fn derivatives_by_load_and_friction_are_those_of_the_computed_forces() {
    let mut random = Random::new(67);
    let mut comparison = Comparison::default();
    for n in 0..3_000 {
        let c = any_contact(&mut random);
        let o = options(Model::ALL[n % 5], StripCount::ALL[n / 5 % 5]);
        let size = random.log_between(1e-3, 3.0);
        let p = [0; 3].map(|_| size * random.between(-1.0, 1.0));
        let m = theory::creepage(&c, p[0], p[1], p[2]);
        let (solution, d) = derivatives::forces_and_derivatives(&c, &m, &o).unwrap();
        let (same, j) = forces::solve_jacobian(&c, &m, &o).unwrap();
        let rows = std::array::from_fn(|i| std::array::from_fn(|k| j[(i, k)]));
        assert_eq!((solution, d.jacobian), (same, rows), "{o:?}");
        assert_eq!(solution, solved(&c, &m, &o), "{o:?}");
        for change in [Change::Load, Change::Friction, Change::Hertz] {
            let exact = change.slope(&c, &d);
            let at = |t: f64| normalised(&c, &solved(&change.of(&c, t), &m, &o));
            let size = exact.map(|slope| slope.abs().max(0.1));
            comparison.column(&at, exact, size, 1e-7, &(change, p, o, c));
        }
    }
    comparison.assert_few_kinks(50);
}

/// Without friction the derivatives are one-sided: full sliding starts at once. A lost contact has
/// none.
#[test]
fn derivatives_without_load_or_friction_are_those_of_sliding() {
    let full = contact(1.5, 0.28);
    let m = creep(1e-3, -4e-4, 0.1);
    for model in Model::ALL {
        let o = sixteen(model);
        for (load, friction) in [(0.0, 0.3), (full.normal_force, 0.0), (0.0, 0.0)] {
            let c = Contact { normal_force: load, friction, ..full };
            let (s, d) = derivatives::forces_and_derivatives(&c, &m, &o).unwrap();
            if model == Model::Linear {
                assert_eq!((d.normal_force, d.friction), ([0.0; 3], [0.0; 3]));
                continue;
            }
            assert_eq!((force_and_moment(&s), d.jacobian), ([0.0; 3], [[0.0; 3]; 3]), "{model:?}");
            if load == 0.0 {
                assert_eq!(d, Derivatives::default(), "{model:?}");
                continue;
            }
            // The same motion with next to no load or friction
            let little = 1e-9;
            let near = Contact {
                normal_force: load + little * full.normal_force,
                friction: friction + little,
                ..full
            };
            let s = solved(&near, &m, &o);
            let size = near.friction * near.normal_force;
            for (i, force) in force_and_moment(&s).into_iter().enumerate() {
                let unit = if i == 2 { full.a } else { 1.0 };
                let expected = force / size;
                let (by_load, by_friction) = (d.normal_force[i], d.friction[i]);
                // STRIP keeps a slip of order 1/creepage in the limit, TOTAL likewise
                assert!((by_load - friction * expected).abs() < 1e-3 * unit, "{model:?} {i}");
                assert!((by_friction - load * expected).abs() < 1e-3 * unit * full.normal_force);
            }
        }
    }
    // No motion, no force, whatever the load
    let rest = creep(0.0, 0.0, 0.0);
    for model in Model::ALL {
        for c in [full, Contact { friction: 0.0, ..full }, Contact { normal_force: 0.0, ..full }] {
            let (_, d) = derivatives::forces_and_derivatives(&c, &rest, &sixteen(model)).unwrap();
            let all = [d.normal_force, d.friction, d.load_through_hertz];
            assert_eq!(all, [[0.0; 3]; 3], "{model:?}");
        }
    }
}

/// In full sliding without spin the force is `μ N` along the slip, whatever else changes.
#[test]
fn derivatives_in_full_sliding() {
    let c = contact(0.7, 0.3);
    for model in [Model::Strip1967, Model::Strip1967Continuous, Model::Strip, Model::Total] {
        // (STRIP's elasticity, by which lateral creepage has a share of spin, fades with the fourth
        // power)
        let size = if model == Model::Strip { 30.0 } else { 0.3 };
        for (vx, vy) in [(size, 0.0), (0.0, -size)] {
            let m = creep(vx, vy, 0.0);
            let (_, d) = derivatives::forces_and_derivatives(&c, &m, &sixteen(model)).unwrap();
            let direction =
                [vx.signum() * f64::from(vx != 0.0), vy.signum() * f64::from(vy != 0.0)];
            for (i, direction) in direction.into_iter().enumerate() {
                let off = (d.normal_force[i] - c.friction * direction).abs();
                assert!(off < 1e-12, "{model:?} {off:e}");
                assert!((d.friction[i] / c.normal_force - direction).abs() < 4e-14);
                assert!((d.load_through_hertz[i] - c.friction * direction).abs() < 4e-15);
            }
        }
    }
}

/// Single precision agrees with double to its own rounding.
#[test]
fn derivatives_in_single_precision() {
    let mut random = Random::new(68);
    for n in 0..500 {
        let double = contact(random.log_between(0.2, 5.0), random.between(0.0, 0.5));
        let o = options(Model::ALL[n % 5], StripCount::Sixteen);
        let p = [0; 3].map(|_| random.between(-0.6, 0.6));
        let m = theory::creepage(&double, p[0], p[1], p[2]);
        let (single, motion) = (single::single(&double), single::single_motion(&m));
        let (_, of_double) = derivatives::forces_and_derivatives(&double, &m, &o).unwrap();
        let (_, of_single) = derivatives::forces_and_derivatives(&single, &motion, &o).unwrap();
        for change in [Change::Load, Change::Friction, Change::Hertz] {
            let of_single = Derivatives {
                jacobian: of_single.jacobian.map(|row| row.map(f64::from)),
                normal_force: of_single.normal_force.map(f64::from),
                friction: of_single.friction.map(f64::from),
                load_through_hertz: of_single.load_through_hertz.map(f64::from),
            };
            let (wide, narrow) =
                (change.slope(&double, &of_double), change.slope(&double, &of_single));
            for i in 0..3 {
                // Slopes have kinks, and rounding decides on which side a number lies
                let allowed = 2e-3 * wide[i].abs().max(1.0);
                assert!(
                    (wide[i] - narrow[i]).abs() < allowed,
                    "{change:?} {o:?} {wide:?} {narrow:?}"
                );
            }
        }
    }
}

/// The same beyond unit spin, where an adhesion interval may end with `S = 0`: single precision
/// must see that it does.
#[test]
fn derivatives_beyond_unit_spin_in_single_precision() {
    let mut random = Random::new(69);
    let mut far = 0;
    for n in 0..1_000 {
        let c = contact(random.log_between(0.2, 5.0), random.between(0.0, 0.5));
        let psi = random.sign() * random.between(1.001, 3.0);
        let (xi, eta) = (random.between(-0.8, 0.8), -psi.signum() * random.between(0.0, 1.3));
        let c = single::single(&c);
        let motion = single::single_motion(&theory::creepage(&single::double(&c), xi, eta, psi));
        let o = options([Model::Strip1967, Model::Strip1967Continuous][n % 2], StripCount::Sixteen);
        let (_, narrow) = forces::solve_jacobian(&c, &motion, &o).unwrap();
        let (c, motion) = (single::double(&c), single::double_motion(&motion));
        let (_, wide) = forces::solve_jacobian(&c, &motion, &o).unwrap();
        let arm = (c.a * c.b).sqrt();
        let unit = [1.0, 1.0, arm];
        // of force by translation
        let error = |(i, k): (usize, usize)| {
            (f64::from(narrow[(i, k)]) - wide[(i, k)]).abs() / (unit[i] * unit[k])
        };
        let entries = (0..9).map(|n| (n / 3, n % 3));
        let largest = entries.map(error).fold(0.0, f64::max);
        far += usize::from(largest > 1e-3 * wide[(0, 0)].hypot(wide[(1, 1)]));
    }
    // Births of adhesion areas, where rounding decides. (Without `S = 0` it was every third.)
    assert!(far <= 4, "{far} of 1000");
}

/// Where the strip whose longitudinal creepage vanishes lies on the rim, `ξ = p` to the bit, the
/// slopes are those next to it.
#[test]
fn derivatives_where_creepage_vanishes_at_the_rim() {
    let round = Contact { a: 0.00390625, b: 0.00390625, poisson_ratio: 0.5, ..C0 };
    for lateral in [-3e-3, -1e-4, 0.0, 1e-5, 2e-4, 2e-3] {
        for turned in [-1.0, 1.0] {
            // υx = a φ
            let at = |hair| creep(turned * 0.0009765625 + hair, lateral, 0.25);
            for model in [Model::Strip1967, Model::Strip1967Continuous] {
                let options = sixteen(model);
                let slope = |hair| forces::solve_jacobian(&round, &at(hair), &options).unwrap().1;
                let (own, beside) = (slope(0.0), [slope(-1e-9), slope(1e-9)]);
                for beside in beside {
                    let off = (own - beside).abs().max() / beside.abs().max();
                    assert!(off < 1e-4, "{model:?} {lateral} {turned}: {own} {beside}");
                }
            }
        }
    }
}
