//! What must hold for every model whatever its constants are: bound, symmetries, limits,
//! smoothness, and that strips and fields belong to the totals.

use crate::prelude::*;
use kstrip_testing::reference::{BOUND, FRICTION, SIZE, UNIT, contact, options};
use proptest::prelude::*;
use rstest::rstest;

/// STRIP with every count, and TOTAL.
fn fitted() -> Vec<Options> {
    StripCount::ALL
        .map(|strips| options(Model::Strip, strips))
        .into_iter()
        .chain([total()])
        .collect()
}

/// Every model with a friction bound.
fn saturating() -> Vec<Options> {
    let of_1967 = [Model::Strip1967, Model::Strip1967Continuous];
    fitted().into_iter().chain(of_1967.map(sixteen)).collect()
}

fn total() -> Options {
    sixteen(Model::Total)
}

fn linear() -> Options {
    sixteen(Model::Linear)
}

/// From `vx, vy, φ` as in `tests/data/README.md`.
fn creepage<F: Float>(v: [f64; 3]) -> Creepage<F> {
    let [longitudinal, lateral, spin] = [v[0] * UNIT, v[1] * UNIT, v[2] * UNIT / SIZE].map(F::of);
    Creepage { longitudinal, lateral, spin }
}

/// `φ` that makes `ψ` on a contact of that shape.
fn spin_of(psi: f64, axis_ratio: f64) -> f64 {
    3.0 / PI / axis_ratio.sqrt() * psi
}

/// `(Fx, Fy)/(μ N), Mz/(μ N √(ab))`
fn normalised<F: Float>(solution: &Solution<F>) -> [f64; 3] {
    let [x, y, z] = [solution.fx, solution.fy, solution.mz].map(|f| f.to_f64());
    [x / BOUND, y / BOUND, z / (BOUND * SIZE)]
}

fn forces(axis_ratio: f64, nu: f64, v: [f64; 3], options: &Options) -> [f64; 3] {
    let solution = forces_of_contact(&contact::<f64>(axis_ratio, nu), &creepage(v), options);
    normalised(&solution.unwrap_or_else(|error| panic!("{error} {axis_ratio} {nu} {v:?}")))
}

/// Derivatives of the same with respect to `vx, vy, φ`.
fn slopes(axis_ratio: f64, nu: f64, v: [f64; 3], options: &Options) -> [[f64; 3]; 3] {
    let (_, j) = forces::solve_jacobian(&contact::<f64>(axis_ratio, nu), &creepage(v), options)
        .unwrap_or_else(|error| panic!("{error} {axis_ratio} {nu} {v:?} {options:?}"));
    let unit = [1.0, 1.0, 1.0 / SIZE];
    std::array::from_fn(|i| std::array::from_fn(|k| j[(i, k)] * unit[i] * unit[k] * UNIT / BOUND))
}

fn far(p: [f64; 3], q: [f64; 3]) -> f64 {
    (0..3).map(|i| (p[i] - q[i]).abs()).fold(0.0, f64::max)
}

/// Either sign, size log-uniform over six decades; sometimes exactly zero.
fn component() -> impl Strategy<Value = f64> {
    let size = (-4.0..2.0_f64, any::<bool>())
        .prop_map(|(e, negative)| if negative { -(10f64.powf(e)) } else { 10f64.powf(e) });
    prop_oneof![1 => Just(0.0), 8 => size]
}

fn creepages() -> impl Strategy<Value = [f64; 3]> {
    [component(), component(), component()]
}

/// Axis ratios and Poisson's ratios over a given number of decades either way.
fn shapes(decades: f64) -> impl Strategy<Value = (f64, f64)> {
    ((-decades..decades).prop_map(|e| 10f64.powf(e)), 0.0..=0.5_f64)
}

proptest! {
    /// `|F| ≤ μ N`, also for needles, and the moment within the largest arm.
    #[test]
    fn bounded((g, nu) in shapes(3.0), v in creepages()) {
        for options in saturating() {
            let [x, y, z] = forces(g, nu, v, &options);
            prop_assert!(x.hypot(y) <= 1.0 + 1e-12, "{options:?}: {x} {y}");
            prop_assert!(z.abs() <= g.sqrt() + 1.0 / g.sqrt(), "{options:?}: {z}");
            let single = solved(&contact::<f32>(g, nu), &creepage(v), &options);
            let [x, y, _] = normalised(&single);
            prop_assert!(x.hypot(y) <= 1.0 + 1e-6, "{options:?} f32: {x} {y}");
            let known = (0.0..=1.0).contains(&single.adhesion);
            let unknown = options == total() && single.adhesion == -1.0;
            prop_assert!(known || unknown, "{options:?} {single:?}");
        }
    }

    /// `(−vx, vy, φ)` gives `(−Fx, Fy, Mz)`; all three reversed reverse all three, to the bit.
    #[test]
    fn symmetric((g, nu) in shapes(2.0), v in creepages()) {
        let [x, y, s] = v;
        for options in saturating().into_iter().chain([linear()]) {
            let [fx, fy, mz] = forces(g, nu, v, &options);
            let arm = g.sqrt().max(1.0 / g.sqrt());
            let scale = 1e-12 * (1.0 + fx.abs() + fy.abs() + mz.abs().max(arm));
            let mirrored = forces(g, nu, [-x, y, s], &options);
            prop_assert!(far(mirrored, [-fx, fy, mz]) <= scale, "{options:?} {mirrored:?}");
            prop_assert_eq!(forces(g, nu, [-x, -y, -s], &options), [-fx, -fy, -mz]);
            prop_assert!(x != 0.0 || fx == 0.0, "{options:?} {fx}");
            if y == 0.0 && s == 0.0 {
                prop_assert!(fy.abs() <= 1e-15 && mz.abs() <= 1e-15, "{options:?} {fy} {mz}");
            }
        }
    }

    /// LINEAR is the three products of its definition, for any creepage.
    #[test]
    fn linear_theory((g, nu) in shapes(3.0), v in creepages()) {
        let LinearCoefficients { c11, c22, c23, c33 } = LinearCoefficients::at(g, nu);
        let expected = [c11 * v[0], c22 * v[1] + c23 * v[2], c33 * v[2] - c23 * v[1]];
        let is = forces(g, nu, v, &linear());
        let scale = expected.iter().fold(1.0_f64, |s, f| s.max(f.abs()))
            + c22 * v[1].abs() + (c23 + c33) * v[2].abs() + c23 * v[1].abs();
        prop_assert!(far(is, expected) <= 1e-12 * scale, "{is:?} {expected:?}");
    }

    /// Vanishing creepage: the forces of linear theory, and for TOTAL its moment.
    #[test]
    fn linear_limit((g, nu) in shapes(1.0), v in [-1.0..1.0_f64, -1.0..1.0, -1.0..1.0]) {
        let small = v.map(|x| 1e-6 * x);
        let expected = forces(g, nu, small, &linear());
        // the second term is of the order of the linear force itself
        let size = 1e-6 * LinearCoefficients::at(g, nu).c33.max(30.0);
        for options in fitted() {
            let mut is = forces(g, nu, small, &options);
            if options.model == Model::Strip {
                is[2] = expected[2];
            }
            prop_assert!(far(is, expected) <= 3.0 * size * size, "{options:?} {is:?} {expected:?}");
        }
    }

    /// Nothing is gained from friction: `Fx υx + Fy υy + Mz φ ≥ 0`.
    #[test]
    fn dissipative((g, nu) in shapes(1.15), v in creepages()) {
        for options in saturating() {
            let power =
                solved(&contact::<f64>(g, nu), &creepage(v), &options).power;
            let [x, y, z] = forces(g, nu, v, &options);
            let sum = x * v[0] + y * v[1] + z * v[2];
            prop_assert!((power / (BOUND * UNIT) - sum).abs() <= 1e-12 * (1.0 + sum.abs()));
            prop_assert!(sum >= -1e-12, "{options:?}: {sum}");
        }
    }

    /// Continuous in creepage, spin, axis ratio and Poisson's ratio, at every scale.
    #[test]
    fn continuous(
        (g, nu) in shapes(1.0),
        v in creepages(),
        step in [-1.0..1.0_f64, -1.0..1.0, -1.0..1.0, -1.0..1.0, -1.0..1.0],
    ) {
        const STEP: f64 = 1e-8;
        let moved = std::array::from_fn(|i| v[i] + STEP * step[i]);
        let (moved_g, moved_nu) =
            (g * (1.0 + STEP * step[3]), (nu + STEP * step[4]).clamp(0.0, 0.5));
        for options in fitted() {
            let change =
                far(forces(g, nu, v, &options), forces(moved_g, moved_nu, moved, &options));
            // the linear derivatives reach 16 for the forces and 12 for the moment
            prop_assert!(change <= 300.0 * STEP, "{options:?}: {change:e}");
        }
    }

    /// The derivatives are those of the forces, and have no jump.
    #[test]
    fn differentiable(
        (g, nu) in shapes(1.0),
        v in creepages(),
        way in [-1.0..1.0_f64, -1.0..1.0, -1.0..1.0],
    ) {
        let moved = |step: f64| std::array::from_fn(|i| v[i] + step * way[i]);
        for options in [sixteen(Model::Strip), total()] {
            let here = slopes(g, nu, v, &options);
            let step = 1e-7;
            let (ahead, behind) =
                (forces(g, nu, moved(step), &options), forces(g, nu, moved(-step), &options));
            let there = slopes(g, nu, moved(1e-8), &options);
            for i in 0..3 {
                let expected: f64 = (0..3).map(|k| here[i][k] * way[k]).sum();
                let is = (ahead[i] - behind[i]) / (2.0 * step);
                prop_assert!((is - expected).abs() <= 3e-3, "{options:?} {i}: {is} {expected}");
                prop_assert!(far(here[i], there[i]) <= 1e-3, "{options:?} {here:?} {there:?}");
            }
        }
    }

    /// Large creepage without spin: the whole of `μ N` along the rigid slip.
    #[test]
    fn saturated((g, nu) in shapes(1.0), size in 1e3..1e6_f64, angle in -PI..PI) {
        let (sine, cosine) = angle.sin_cos();
        for options in fitted() {
            let is = forces(g, nu, [size * cosine, size * sine, 0.0], &options);
            prop_assert!(far(is, [cosine, sine, 0.0]) <= 2e-3, "{options:?} {is:?} {angle}");
        }
    }

    #[test]
    fn single_precision((g, nu) in shapes(1.0), v in creepages()) {
        for options in fitted() {
            let single = solved(&contact::<f32>(g, nu), &creepage(v), &options);
            let difference = far(normalised(&single), forces(g, nu, v, &options));
            prop_assert!(difference <= 1e-4, "{options:?}: {difference:e}");
        }
    }

    /// The strips add up to the totals, and share the patch and its width.
    #[test]
    fn strips_add_up((g, nu) in shapes(1.0), v in creepages(), count in 0..5_usize) {
        let (contact, motion) = (contact::<f64>(g, nu), creepage(v));
        for model in [Model::Strip, Model::Strip1967, Model::Strip1967Continuous] {
            let options = options(model, StripCount::ALL[count]);
            let whole = solved(&contact, &motion, &options);
            let mut parts: Vec<StripResult<f64>> = Vec::new();
            let warning =
                forces::strips(&contact, &motion, &options, &mut |s| parts.push(s)).unwrap();
            prop_assert_eq!(warning, whole.warning);
            prop_assert_eq!(parts.len(), StripCount::ALL[count] as usize);
            let power = BOUND * UNIT * (v[0].abs() + v[1].abs() + 10.0 * v[2].abs());
            for (part, expected, scale) in [
                ((|s| s.fx) as fn(&StripResult<f64>) -> f64, whole.fx, BOUND),
                (|s| s.fy, whole.fy, BOUND),
                (|s| s.mz, whole.mz, BOUND * SIZE * 4.0),
                (|s| s.power, whole.power, power),
                (|s| s.width, 2.0 * contact.b, contact.b),
            ] {
                // (beyond unit spin strips of the theory of 1967 take away what others have)
                let scale = scale.max(parts.iter().map(|s| part(s).abs()).sum());
                let is = parts.iter().map(part).sum::<f64>();
                let allowed = if model == Model::Strip { 1e-12 } else { 1e-10 };
                prop_assert!((is - expected).abs() <= allowed * scale, "{model:?} {is} {expected}");
            }
            for part in &parts {
                prop_assert!(part.separatrix.abs() <= part.half_length * (1.0 + 1e-12));
                let c = (1.0 - (part.y / contact.b).powi(2)).sqrt() * contact.a;
                prop_assert!((part.half_length - c).abs() <= 1e-12 * contact.a);
                let agrees = (part.state == State::Stick) == (part.separatrix < part.half_length);
                prop_assert!(agrees || model == Model::Strip, "{model:?} {part:?}");
            }
        }
    }

    /// Pressure is Hertz's, the traction within the friction bound, nothing outside.
    #[test]
    fn field_within_the_bound(
        (g, nu) in shapes(1.15),
        v in creepages(),
        x in -1.1..1.1_f64,
        y in -1.1..1.1_f64,
    ) {
        let contact = contact::<f64>(g, nu);
        for model in [Model::Strip, Model::Strip1967, Model::Strip1967Continuous] {
            let field = Field::new(&contact, &creepage(v), &sixteen(model)).unwrap();
            let point = field.at(x * contact.a, y * contact.b);
            let square = 1.0 - x * x - y * y;
            let p0 = 1.5 * contact.normal_force / (PI * contact.a * contact.b);
            let pressure = p0 * square.max(0.0).sqrt();
            prop_assert!(
                (point.pressure - pressure).abs() <= 1e-9 * p0,
                "{} {}",
                point.pressure,
                pressure,
            );
            let traction = point.traction_x.hypot(point.traction_y);
            // (a small difference of squares beyond unit spin)
            let allowed =
                if model != Model::Strip && spin_of(1.0, g) < v[2].abs() { 1e-7 } else { 1e-12 };
            prop_assert!(
                traction <= FRICTION * point.pressure * (1.0 + allowed),
                "{model:?} {point:?}",
            );
            let power = point.traction_x * point.slip_x + point.traction_y * point.slip_y;
            let slip = point.slip_x.hypot(point.slip_y);
            prop_assert!((power - point.dissipation).abs() <= 1e-12 * traction * slip, "{point:?}");
            prop_assert_eq!(point.state == State::Outside, square < 0.0);
            match point.state {
                State::Stick => prop_assert!(slip == 0.0),
                State::Outside => prop_assert_eq!(traction, 0.0),
                State::Slip => prop_assert!(point.dissipation >= 0.0, "{point:?}"),
                State::SlipNegativeDissipation => prop_assert!(point.dissipation < 0.0),
            }
        }
    }
}

/// Strips also add up to the totals where power is corrected, in long contacts with spin: each
/// strip has its share of what the correction adds to the moment.
#[test]
fn strips_add_up_where_power_is_corrected() {
    let options = options(Model::Strip, StripCount::Eight);
    for (g, nu, v) in [
        (8.65, 0.40, [-0.0020, -0.0048, 0.064]),
        (18.4, 0.26, [0.0051, -0.0049, 0.026]),
        (24.3, 0.49, [0.0032, 0.0007, 0.0147]),
    ] {
        let (contact, motion) = (contact::<f64>(g, nu), creepage(v));
        let whole = normalised(&solved(&contact, &motion, &options));
        // the correction keeps a fifth of the power of linear theory, divided by √(1 + n²)
        let LinearCoefficients { c11, c22, c23, c33 } = LinearCoefficients::at(g, nu);
        let linear = [c11 * v[0], c22 * v[1], c33 * v[2]];
        let square = linear.iter().map(|k| k * k).sum::<f64>() + (c23 * v[2]).powi(2);
        let power = |forces: [f64; 3]| forces.iter().zip(v).map(|(f, v)| f * v).sum::<f64>();
        assert_relative_eq!(
            power(whole) * (1.0 + square).sqrt(),
            0.2 * power(linear),
            max_relative = 1e-12
        );
        let mut sum = [0.0; 3];
        forces::strips(&contact, &motion, &options, &mut |strip| {
            let StripResult { fx, fy, mz, .. } = strip;
            sum = std::array::from_fn(|i| sum[i] + [fx, fy, mz][i]);
        })
        .unwrap();
        let sum = [sum[0] / BOUND, sum[1] / BOUND, sum[2] / (BOUND * SIZE)];
        for (sum, whole) in sum.iter().zip(whole) {
            assert!((sum - whole).abs() < 1e-13, "{g}: {sum} {whole}");
        }
    }
}

/// Where bodies adhere the traction vanishes at the leading edge, however near the point is.
#[test]
fn traction_vanishes_at_the_leading_edge() {
    let (contact, motion) = (contact::<f64>(1.0, 0.28), creepage([0.05, 0.02, 0.0]));
    let field = Field::new(&contact, &motion, &sixteen(Model::Strip)).unwrap();
    let [near, far] = [1e-5, 2e-3].map(|depth| {
        let point = field.at((1.0 - depth) * contact.a, 0.0);
        assert_eq!(point.state, State::Stick);
        point.traction_x.hypot(point.traction_y)
    });
    assert!(near > 0.0 && near < 0.2 * far, "{near} {far}");
}

/// The field integrates to the totals. They are computed apart: the totals from a few nodes of each
/// strip, the field point by point. Of `μ N`, and of `μ N √(ab)` for the moment, over 200 cases of
/// the range that the model states, a quarter of them of unlike bodies.
#[test]
fn field_integrates_to_the_force() {
    const CASES: usize = 200;
    const POINTS: i32 = 120;
    const FORCE_MEAN: f64 = 0.003;
    const FORCE_MAX: f64 = 0.035;
    const MOMENT_MEAN: f64 = 0.002;
    const MOMENT_MAX: f64 = 0.03;
    let options = Options { model: Model::Strip, strips: StripCount::SixtyFour };
    let mut random = Random::new(3);
    let (mut sums, mut largest) = ([0.0; 2], [0.0_f64; 2]);
    for case in 0..CASES {
        let g = random.log_between(0.1, 10.0);
        let nu = random.between(0.0, 0.5);
        let v = [
            random.sign() * random.log_between(1e-3, 3.0),
            random.sign() * random.log_between(1e-3, 3.0),
            random.sign() * spin_of(random.log_between(1e-3, 3.0), g),
        ];
        let (contact, motion) = (contact::<f64>(g, nu), creepage(v));
        let contact = Contact { mismatch: if case % 4 == 0 { 0.1 } else { 0.0 }, ..contact };
        let field = Field::new(&contact, &motion, &options).unwrap();
        let whole = solved(&contact, &motion, &options);
        let mut sum = [0.0; 4];
        forces::strips(&contact, &motion, &options, &mut |part| {
            let strip = field.strip_at(part.y);
            for i in 0..POINTS {
                // x = c cos θ, midpoints in θ
                let angle = PI * (f64::from(i) + 0.5) / f64::from(POINTS);
                let x = part.half_length * angle.cos();
                let area = part.width * part.half_length * angle.sin() * PI / f64::from(POINTS);
                let point = field.along(strip.as_ref(), x);
                sum[0] += point.traction_x * area;
                sum[1] += point.traction_y * area;
                sum[2] += (x * point.traction_y - part.y * point.traction_x) * area;
                sum[3] += point.pressure * area;
            }
        })
        .unwrap();
        assert!((sum[3] / contact.normal_force - 1.0).abs() <= 5e-15);
        let off = [
            (sum[0] - whole.fx).hypot(sum[1] - whole.fy) / BOUND,
            (sum[2] - whole.mz).abs() / (BOUND * SIZE),
        ];
        for k in 0..2 {
            sums[k] += off[k] / CASES as f64;
            largest[k] = largest[k].max(off[k]);
        }
    }
    println!("mean {sums:.4?}, largest {largest:.4?}");
    assert!(sums[0] <= FORCE_MEAN && largest[0] <= FORCE_MAX, "force: {sums:?} {largest:?}");
    assert!(sums[1] <= MOMENT_MEAN && largest[1] <= MOMENT_MAX, "moment: {sums:?} {largest:?}");
}

/// No creepage: no force at all, adhesion everywhere, and the derivatives are the linear
/// coefficients.
#[rstest]
fn zero_creepage(
    #[values(0.001, 0.1, 0.5, 1.0, 3.0, 10.0, 1000.0)] g: f64, #[values(0.0, 0.28, 0.5)] nu: f64,
) {
    let LinearCoefficients { c11, c22, c23, c33 } = LinearCoefficients::at(g, nu);
    for options in fitted().into_iter().chain([linear()]) {
        let s = solved(&contact::<f64>(g, nu), &creepage([0.0; 3]), &options);
        assert_eq!([s.fx, s.fy, s.mz, s.power], [0.0; 4], "{options:?}");
        assert!(options == total() || (s.adhesion - 1.0).abs() < 1e-12, "{options:?} {s:?}");
        let j = slopes(g, nu, [0.0; 3], &options);
        let expected = [[c11, 0.0, 0.0], [0.0, c22, c23], [0.0, -c23, c33]];
        let rows = if options.model == Model::Strip { 2 } else { 3 };
        for (is, expected) in j[..rows].iter().flatten().zip(expected.iter().flatten()) {
            let allowed = 1e-11 * (1.0 + expected.abs());
            assert!((is - expected).abs() < allowed, "{options:?}: {is} {expected}");
        }
        assert!(j[2][0].abs() < 1e-12, "{options:?} {j:?}");
    }
}

/// Axis ratios and spin beyond what was fitted are told, by the model, and by the strips of the
/// ellipse.
#[test]
fn notices() {
    let patches = [(1.0, 2.9), (1.0, 3.1), (15.0, 0.0), (0.07, 4.0), (40.0, 0.5), (70.0, 0.5)];
    for options in fitted() {
        let warning = |g: f64, psi: f64| {
            let v = creepage([0.1, 0.0, spin_of(psi, g)]);
            solved(&contact::<f64>(g, 0.28), &v, &options).warning
        };
        let beyond = if options == total() { Warning::None } else { Warning::OutsideRange };
        for (g, psi, expected) in [
            (0.015, 0.0, Warning::None),
            (60.0, 0.0, Warning::None),
            (1.0, 2.99, Warning::None),
            (1.0, -2.99, Warning::None),
            (5.0, 1.0, Warning::None),
            (1.0, 3.01, beyond),
            (1.0, -3.01, beyond),
            (0.0149, 0.0, Warning::AxisRatio),
            (60.1, 0.0, Warning::AxisRatio),
            (1e3, 1.0, Warning::AxisRatio),
        ] {
            assert_eq!(warning(g, psi), expected, "{options:?} {g} {psi}");
        }
        for (g, psi) in patches {
            let patch = Patch::<f64>::from_ellipse(&contact(g, 0.28), options.strips).unwrap();
            let v = creepage([0.1, 0.0, spin_of(psi, g)]);
            let found = solver::solve_patch(&patch.view().unwrap(), &v, options.model).unwrap();
            assert_eq!(found.warning, warning(g, psi), "{options:?} {g} {psi}");
        }
    }
    let c11 = LinearCoefficients::at(1.0, 0.28).c11;
    for (share, expected) in [(0.999, Warning::None), (1.001, Warning::BeyondFriction)] {
        let v = creepage([share / c11, 0.0, 0.0]);
        assert_eq!(solved(&contact::<f64>(1.0, 0.28), &v, &linear()).warning, expected);
    }
}

#[test]
fn totals_have_no_strips_and_no_field() {
    let (contact, v) = (contact::<f64>(1.0, 0.28), creepage([0.1, 0.0, 0.1]));
    for options in [total(), linear()] {
        let mut called = false;
        let result = forces::strips(&contact, &v, &options, &mut |_| called = true);
        assert_eq!((result, called), (Err(Error::NotInModel), false));
        assert_eq!(Field::new(&contact, &v, &options).map(|_| ()), Err(Error::NotInModel));
    }
}
