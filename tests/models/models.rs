//! What must hold for STRIP, TOTAL and LINEAR whatever their constants are: bound, symmetries, limits,
//! smoothness, hard inputs, and that strips and fields belong to the totals.

use crate::random;
use crate::theory::COUNTS;

use kstrip::contact::Contact;
use kstrip::contact::creepage::Creepage;
use kstrip::contact::forces::StripCount;
use kstrip::linear::LinearCoefficients;
use kstrip::patch::{Patch, solver};
use kstrip::solve::model::{self, Field, Model, Options, Precision, Solution, StripResult, solve};
use kstrip::status::{Error, Notice};
use kstrip::strip_1967::strip::State;
use proptest::prelude::*;
use random::Random;
use rstest::rstest;
use std::f64::consts::PI;

/// `√(ab)` \[m\], `G` \[Pa\], `μ N` \[N\], `μ`.
const SIZE: f64 = 5e-3;
const SHEAR_MODULUS: f64 = 82e9;
const BOUND: f64 = 24e3;
const FRICTION: f64 = 0.3;
/// Creepage for `vx = 1`.
const UNIT: f64 = BOUND / (SHEAR_MODULUS * SIZE * SIZE);

/// Every model with saturation that is tested here, with every count that it has.
fn saturating() -> Vec<Options> {
    let mut all: Vec<Options> =
        COUNTS.into_iter().map(|strips| Options { model: Model::Strip, strips }).collect();
    all.push(total());
    all
}

fn strip() -> Options {
    Options { model: Model::Strip, strips: StripCount::Sixteen }
}

fn total() -> Options {
    Options { model: Model::Total, strips: StripCount::Sixteen }
}

fn linear() -> Options {
    Options { model: Model::Linear, strips: StripCount::Sixteen }
}

fn contact<F: Precision>(axis_ratio: f64, poisson_ratio: f64) -> Contact<F> {
    Contact {
        a: F::of(SIZE * axis_ratio.sqrt()),
        b: F::of(SIZE / axis_ratio.sqrt()),
        normal_force: F::of(BOUND / FRICTION),
        shear_modulus: F::of(SHEAR_MODULUS),
        poisson_ratio: F::of(poisson_ratio),
        friction: F::of(FRICTION),
        mismatch: F::zero(),
    }
}

/// From `vx, vy, φ` as in `tests/data/README.md`.
fn creepage<F: Precision>(v: [f64; 3]) -> Creepage<F> {
    Creepage {
        longitudinal: F::of(v[0] * UNIT),
        lateral: F::of(v[1] * UNIT),
        spin: F::of(v[2] * UNIT / SIZE),
    }
}

/// `φ` that makes `ψ` on this contact.
fn spin_of(psi: f64, axis_ratio: f64) -> f64 {
    3.0 / PI / axis_ratio.sqrt() * psi
}

/// `(Fx, Fy)/(μ N), Mz/(μ N √(ab))`
fn normalised<F: Precision>(solution: &Solution<F>) -> [f64; 3] {
    let [x, y, z] = [solution.fx, solution.fy, solution.mz].map(|f| f.to_f64());
    [x / BOUND, y / BOUND, z / (BOUND * SIZE)]
}

fn forces(axis_ratio: f64, nu: f64, v: [f64; 3], options: &Options) -> [f64; 3] {
    let solution = solve(&contact::<f64>(axis_ratio, nu), &creepage(v), options);
    normalised(&solution.unwrap_or_else(|error| panic!("{error} {axis_ratio} {nu} {v:?}")))
}

/// Derivatives of the same by `vx, vy, φ`.
fn slopes(axis_ratio: f64, nu: f64, v: [f64; 3], options: &Options) -> [[f64; 3]; 3] {
    let (_, j): (_, nalgebra::Matrix3<f64>) =
        model::solve_jacobian(&contact::<f64>(axis_ratio, nu), &creepage(v), options)
            .unwrap_or_else(|error| panic!("{error} {axis_ratio} {nu} {v:?} {options:?}"));
    let (row, column) = ([1.0, 1.0, 1.0 / SIZE], [1.0, 1.0, 1.0 / SIZE]);
    std::array::from_fn(|i| std::array::from_fn(|k| j[(i, k)] * row[i] * column[k] * UNIT / BOUND))
}

fn far(p: [f64; 3], q: [f64; 3]) -> f64 {
    (0..3).map(|i| (p[i] - q[i]).abs()).fold(0.0, f64::max)
}

/// Either sign, size log-uniform over six decades; sometimes exactly zero.
fn component() -> impl Strategy<Value = f64> {
    prop_oneof![
        1 => Just(0.0),
        8 => (-4.0..2.0_f64, any::<bool>())
            .prop_map(|(e, negative)| if negative { -(10f64.powf(e)) } else { 10f64.powf(e) }),
    ]
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
            prop_assert!(x.hypot(y) <= 1.0 + 1e-12, "{:?}: {} {}", options, x, y);
            prop_assert!(z.abs() <= g.sqrt() + 1.0 / g.sqrt(), "{:?}: {}", options, z);
            let single = solve(&contact::<f32>(g, nu), &creepage(v), &options).unwrap();
            let [x, y, _] = normalised(&single);
            prop_assert!(x.hypot(y) <= 1.0 + 1e-6, "{:?} f32: {} {}", options, x, y);
            if options.model == Model::Strip {
                prop_assert!((0.0..=1.0).contains(&single.adhesion));
            } else {
                prop_assert!(single.adhesion == -1.0);
            }
        }
    }

    /// `(−vx, vy, φ)` gives `(−Fx, Fy, Mz)`; all three reversed reverse all three.
    #[test]
    fn symmetric((g, nu) in shapes(2.0), v in creepages()) {
        let [x, y, s] = v;
        for options in saturating().into_iter().chain([linear()]) {
            let [fx, fy, mz] = forces(g, nu, v, &options);
            let scale = 1e-12 * (1.0 + fx.abs() + fy.abs() + mz.abs());
            let mirrored = forces(g, nu, [-x, y, s], &options);
            let reversed = forces(g, nu, [-x, -y, -s], &options);
            prop_assert!(far(mirrored, [-fx, fy, mz]) <= scale, "{:?} {:?}", options, mirrored);
            prop_assert!(far(reversed, [-fx, -fy, -mz]) <= scale, "{:?} {:?}", options, reversed);
            if x == 0.0 {
                prop_assert!(fx.abs() <= 1e-15, "{:?} {}", options, fx);
            }
            if y == 0.0 && s == 0.0 {
                prop_assert!(fy.abs() <= 1e-15 && mz.abs() <= 1e-15, "{:?} {} {}", options, fy, mz);
            }
        }
    }

    /// LINEAR is the three products of its definition, for any creepage.
    #[test]
    fn linear_theory((g, nu) in shapes(3.0), v in creepages()) {
        let LinearCoefficients { c11, c22, c23, c33 } = LinearCoefficients::at(g, nu);
        let expected =
            [c11 * v[0], c22 * v[1] + c23 * v[2], c33 * v[2] - c23 * v[1]];
        let is = forces(g, nu, v, &linear());
        let scale = expected.iter().fold(1.0_f64, |s, f| s.max(f.abs()))
            + c22 * v[1].abs() + (c23 + c33) * v[2].abs() + c23 * v[1].abs();
        prop_assert!(far(is, expected) <= 1e-12 * scale, "{:?} {:?}", is, expected);
    }

    /// Vanishing creepage: the forces of linear theory, and for TOTAL its moment.
    #[test]
    fn linear_limit((g, nu) in shapes(1.0), v in [-1.0..1.0_f64, -1.0..1.0, -1.0..1.0]) {
        let small = v.map(|x| 1e-6 * x);
        let expected = forces(g, nu, small, &linear());
        // the second term is of the order of the linear force itself
        let size = 1e-6 * LinearCoefficients::at(g, nu).c33.max(30.0);
        for options in saturating() {
            let is = forces(g, nu, small, &options);
            let mut error = (is[0] - expected[0]).abs().max((is[1] - expected[1]).abs());
            if options.model == Model::Total {
                error = error.max((is[2] - expected[2]).abs());
            }
            prop_assert!(error <= 3.0 * size * size, "{:?} {:?} {:?}", options, is, expected);
        }
    }

    /// Nothing is gained from friction: `Fx υx + Fy υy + Mz φ ≥ 0`.
    #[test]
    fn dissipative((g, nu) in shapes(1.15), v in creepages()) {
        for options in saturating() {
            let (contact, motion) = (contact::<f64>(g, nu), creepage(v));
            let power = solve(&contact, &motion, &options).unwrap().power;
            let [x, y, z] = forces(g, nu, v, &options);
            let sum = x * v[0] + y * v[1] + z * v[2];
            prop_assert!((power / (BOUND * UNIT) - sum).abs() <= 1e-12 * (1.0 + sum.abs()));
            prop_assert!(sum >= -1e-12, "{:?}: {}", options, sum);
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
        let (moved_g, moved_nu) = (g * (1.0 + STEP * step[3]), (nu + STEP * step[4]).clamp(0.0, 0.5));
        for options in saturating() {
            let change = far(forces(g, nu, v, &options), forces(moved_g, moved_nu, moved, &options));
            // the linear slopes reach 16 for the forces and 12 for the moment
            prop_assert!(change <= 300.0 * STEP, "{:?}: {:e}", options, change);
        }
    }

    /// The derivatives are those of the forces, and for TOTAL they have no jump.
    #[test]
    fn differentiable((g, nu) in shapes(1.0), v in creepages(), way in [-1.0..1.0_f64, -1.0..1.0, -1.0..1.0]) {
        for options in [strip(), total()] {
            let j = slopes(g, nu, v, &options);
            let step = 1e-7;
            let ahead = forces(g, nu, std::array::from_fn(|i| v[i] + step * way[i]), &options);
            let behind = forces(g, nu, std::array::from_fn(|i| v[i] - step * way[i]), &options);
            for i in 0..3 {
                let expected: f64 = (0..3).map(|k| j[i][k] * way[k]).sum();
                let is = (ahead[i] - behind[i]) / (2.0 * step);
                prop_assert!((is - expected).abs() <= 3e-3, "{:?} {}: {} {}", options, i, is, expected);
            }
        }
        let step = 1e-8;
        let here = slopes(g, nu, v, &total());
        let there = slopes(g, nu, std::array::from_fn(|i| v[i] + step * way[i]), &total());
        for i in 0..3 {
            prop_assert!(far(here[i], there[i]) <= 1e5 * step, "{:?} {:?}", here, there);
        }
    }

    /// Large creepage without spin: the whole of `μ N` along the rigid slip.
    #[test]
    fn saturated((g, nu) in shapes(1.0), size in 1e3..1e6_f64, angle in -PI..PI) {
        let (sine, cosine) = angle.sin_cos();
        for options in saturating() {
            let is = forces(g, nu, [size * cosine, size * sine, 0.0], &options);
            let expected = [cosine, sine, 0.0];
            prop_assert!(far(is, expected) <= 2e-3, "{:?} {:?} {:?}", options, is, expected);
        }
    }

    /// Single precision is the same model.
    #[test]
    fn single_precision((g, nu) in shapes(1.0), v in creepages()) {
        for options in saturating() {
            let double = forces(g, nu, v, &options);
            let single = solve(&contact::<f32>(g, nu), &creepage(v), &options).unwrap();
            let difference = far(normalised(&single), double);
            prop_assert!(difference <= 1e-4, "{:?}: {:e}", options, difference);
        }
    }

    /// The strips add up to the totals, and share the patch and its width.
    #[test]
    fn strips_add_up((g, nu) in shapes(1.0), v in creepages()) {
        let (contact, motion) = (contact::<f64>(g, nu), creepage(v));
        for strips in COUNTS {
            let options = Options { model: Model::Strip, strips };
            let whole = solve(&contact, &motion, &options).unwrap();
            let mut parts: Vec<StripResult<f64>> = Vec::new();
            let notice = model::strips(&contact, &motion, &options, &mut |s| parts.push(s)).unwrap();
            prop_assert_eq!(notice, whole.notice);
            prop_assert_eq!(parts.len(), strips as usize);
            let sum = |part: fn(&StripResult<f64>) -> f64| parts.iter().map(part).sum::<f64>();
            let power = BOUND * UNIT * (v[0].abs() + v[1].abs() + 10.0 * v[2].abs());
            for (is, expected, scale) in [
                (sum(|s| s.fx), whole.fx, BOUND),
                (sum(|s| s.fy), whole.fy, BOUND),
                (sum(|s| s.mz), whole.mz, BOUND * SIZE * 4.0),
                (sum(|s| s.power), whole.power, power),
                (sum(|s| s.width), 2.0 * contact.b, contact.b),
            ] {
                prop_assert!((is - expected).abs() <= 1e-12 * scale, "{} {}", is, expected);
            }
            for part in &parts {
                prop_assert!(part.separatrix.abs() <= part.half_length * (1.0 + 1e-12));
                let c = (1.0 - (part.y / contact.b).powi(2)).sqrt() * contact.a;
                prop_assert!((part.half_length - c).abs() <= 1e-12 * contact.a);
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
        let field = Field::new(&contact, &creepage(v), &strip()).unwrap();
        let point = field.at(x * contact.a, y * contact.b);
        let square = 1.0 - x * x - y * y;
        let p0 = 1.5 * contact.normal_force / (PI * contact.a * contact.b);
        let pressure = p0 * square.max(0.0).sqrt();
        prop_assert!((point.pressure - pressure).abs() <= 1e-9 * p0, "{} {}", point.pressure, pressure);
        let traction = point.traction_x.hypot(point.traction_y);
        prop_assert!(traction <= FRICTION * point.pressure * (1.0 + 1e-12) , "{:?}", point);
        prop_assert_eq!(point.state == State::Outside, square < 0.0);
        match point.state {
            State::Stick => prop_assert!(point.slip_x == 0.0 && point.slip_y == 0.0),
            State::Outside => prop_assert_eq!(traction, 0.0),
            State::Slip => prop_assert!(point.dissipation >= 0.0, "{:?}", point),
            State::SlipNegativeDissipation => prop_assert!(point.dissipation < 0.0),
        }
    }
}

/// The field integrates to the totals. They are computed apart: the totals from ten steps a
/// strip, the field point by point. Of `μ N`, and of `μ N √(ab)` for the moment, over 200 cases of the range
/// that the model states.
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
    for _ in 0..CASES {
        let g = random.log_between(0.1, 10.0);
        let nu = random.between(0.0, 0.5);
        let v = [
            random.sign() * random.log_between(1e-3, 3.0),
            random.sign() * random.log_between(1e-3, 3.0),
            random.sign() * spin_of(random.log_between(1e-3, 3.0), g),
        ];
        let (contact, motion) = (contact::<f64>(g, nu), creepage(v));
        let field = Field::new(&contact, &motion, &options).unwrap();
        let whole = solve(&contact, &motion, &options).unwrap();
        let mut sum = [0.0; 4];
        model::strips(&contact, &motion, &options, &mut |part| {
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
        assert!((sum[3] / contact.normal_force - 1.0).abs() <= 2e-4);
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

/// No creepage: no force at all, and the derivatives are the linear coefficients.
#[rstest]
fn zero_creepage(
    #[values(0.001, 0.1, 0.5, 1.0, 3.0, 10.0, 1000.0)] g: f64,
    #[values(0.0, 0.28, 0.5)] nu: f64,
) {
    let LinearCoefficients { c11, c22, c23, c33 } = LinearCoefficients::at(g, nu);
    for options in saturating().into_iter().chain([linear()]) {
        assert_eq!(forces(g, nu, [0.0; 3], &options), [0.0; 3], "{options:?}");
        let solution = solve(&contact::<f64>(g, nu), &creepage([0.0; 3]), &options).unwrap();
        assert_eq!(solution.power, 0.0);
        let j = slopes(g, nu, [0.0; 3], &options);
        let mut near = vec![(j[0][0], c11), (j[1][1], c22), (j[1][2], c23)];
        if options.model != Model::Strip {
            near.extend([(j[2][1], -c23), (j[2][2], c33)]);
        }
        for (is, expected) in near {
            // clamped axis ratios: TOTAL and STRIP hold at the ends of 1e-3 … 1e3
            assert!((is / expected - 1.0).abs() < 1e-6, "{options:?}: {is} {expected}");
        }
        for zero in [j[0][1], j[0][2], j[1][0], j[2][0]] {
            assert!(zero.abs() < 1e-9, "{options:?} {j:?}");
        }
    }
}

/// A model in one precision: its options and the digits of its numbers.
#[derive(Debug)]
struct Way {
    options: Options,
    single: bool,
}

/// All of it in both precisions: `check` gets the contact and what the model made of it.
fn everywhere(
    make: impl Fn(&mut Contact<f64>, &mut Creepage<f64>),
    check: impl Fn(&Way, &Contact<f64>, Result<Solution<f64>, Error>),
) {
    let (mut double, mut motion) = (contact::<f64>(1.0, 0.28), creepage::<f64>([0.1, -0.05, 0.2]));
    make(&mut double, &mut motion);
    let narrow = |x: f64| x as f32;
    let single = Contact {
        a: narrow(double.a),
        b: narrow(double.b),
        normal_force: narrow(double.normal_force),
        shear_modulus: narrow(double.shear_modulus),
        poisson_ratio: narrow(double.poisson_ratio),
        friction: narrow(double.friction),
        mismatch: 0.0,
    };
    let slow = Creepage {
        longitudinal: narrow(motion.longitudinal),
        lateral: narrow(motion.lateral),
        spin: narrow(motion.spin),
    };
    for options in saturating().into_iter().chain([linear()]) {
        let result = solve(&double, &motion, &options);
        check(&Way { options, single: false }, &double, result);
        let solution = solve(&single, &slow, &options).map(|s| Solution {
            fx: f64::from(s.fx),
            fy: f64::from(s.fy),
            mz: f64::from(s.mz),
            power: f64::from(s.power),
            adhesion: f64::from(s.adhesion),
            notice: s.notice,
            reserved: 0,
        });
        check(&Way { options, single: true }, &double, solution);
    }
}

/// A finite answer within the bound, or a refusal by name (beyond the floating-point type).
fn sane(way: &Way, contact: &Contact<f64>, result: Result<Solution<f64>, Error>) {
    match result {
        Ok(s) => {
            let all = [s.fx, s.fy, s.mz, s.power, s.adhesion];
            assert!(all.iter().all(|x| x.is_finite()), "{way:?} {s:?}");
            let bound = contact.friction * contact.normal_force;
            if way.options.model != Model::Linear {
                // a subnormal f32 bound has few digits
                let limit = bound * (1.0 + 1e-5) + 3e-45;
                assert!(s.fx.hypot(s.fy) <= limit, "{way:?} {s:?} {bound:e}");
                let arm = (contact.a + contact.b) * (1.0 + 1e-5);
                assert!(s.mz.abs() <= limit * arm + 3e-45, "{way:?} {s:?} {bound:e}");
            }
        }
        Err(error) => assert!(
            matches!(error, Error::Overflow | Error::NotFinite | Error::SemiAxis),
            "{way:?} {error}"
        ),
    }
}

/// In these cases there must be an answer; in single precision unless it is beyond the range.
fn answered(way: &Way, contact: &Contact<f64>, result: Result<Solution<f64>, Error>) {
    assert!(
        result.is_ok() || way.single && result == Err(Error::Overflow),
        "{way:?} {contact:?} {result:?}"
    );
    sane(way, contact, result);
}

#[rstest]
#[case(f64::NAN)]
#[case(f64::INFINITY)]
#[case(f64::NEG_INFINITY)]
fn not_a_number_is_refused(#[case] bad: f64) {
    let refused = |way: &Way, _: &Contact<f64>, result: Result<Solution<f64>, Error>| {
        assert_eq!(result.map(|_| ()), Err(Error::NotFinite), "{way:?}");
    };
    everywhere(|_, v| v.longitudinal = bad, refused);
    everywhere(|_, v| v.lateral = bad, refused);
    everywhere(|_, v| v.spin = bad, refused);
    everywhere(|c, _| c.a = bad, refused);
    everywhere(|c, _| c.b = bad, refused);
    everywhere(|c, _| c.normal_force = bad, refused);
    everywhere(|c, _| c.friction = bad, refused);
    let any = |way: &Way, _: &Contact<f64>, result: Result<Solution<f64>, Error>| {
        assert!(result.is_err(), "{way:?}");
    };
    everywhere(|c, _| c.shear_modulus = bad, any);
    everywhere(|c, _| c.poisson_ratio = bad, any);
}

#[rstest]
fn huge_creepage(#[values(1e18, 1e37, 1e150, 1e300, 1e308)] huge: f64) {
    everywhere(|_, v| v.longitudinal = huge, sane);
    everywhere(|_, v| v.lateral = -huge, sane);
    everywhere(|_, v| v.spin = huge, sane);
    everywhere(|_, v| (v.longitudinal, v.lateral, v.spin) = (huge, huge, -huge), sane);
    // with saturation there is an answer as long as the power is a number
    if huge <= 1e300 {
        for options in saturating() {
            let c = contact::<f64>(1.0, 0.28);
            let v = Creepage { longitudinal: huge, lateral: 0.0, spin: 0.0 };
            let s = solve(&c, &v, &options).unwrap();
            assert!((s.fx / BOUND - 1.0).abs() < 2e-3 && s.fy == 0.0, "{options:?} {s:?}");
        }
    }
}

#[rstest]
fn tiny_creepage(#[values(1e-30, 1e-44, 1e-200, 1e-308, 5e-324)] tiny: f64) {
    everywhere(|_, v| *v = Creepage { longitudinal: tiny, lateral: 0.0, spin: 0.0 }, answered);
    everywhere(|_, v| *v = Creepage { longitudinal: tiny, lateral: -tiny, spin: tiny }, answered);
    everywhere(|_, v| *v = Creepage { longitudinal: 0.0, lateral: 0.0, spin: tiny }, answered);
}

#[test]
fn zero_creepage_is_answered() {
    everywhere(|_, v| *v = Creepage::default(), answered);
}

/// The limit of the theory of 1967 is nothing special.
#[rstest]
fn spin_of_one(
    #[values(0.1, 1.0, 5.0)] g: f64,
    #[values(-0.5, 0.0, 0.5)] vy: f64,
    #[values(-1.0, 1.0)] psi: f64,
) {
    for options in saturating() {
        let at = |psi: f64| forces(g, 0.28, [0.0, vy, spin_of(psi, g)], &options);
        let is = at(psi);
        assert!(is.iter().all(|f| f.is_finite()));
        assert!(far(is, at(psi * (1.0 - 1e-9))) < 1e-6 && far(is, at(psi * (1.0 + 1e-9))) < 1e-6);
    }
}

#[rstest]
fn needles(#[values(1e-30, 1e-6, 1e-3, 1e3, 1e6, 1e30)] g: f64, #[values(0.0, 0.5)] nu: f64) {
    let shape = |c: &mut Contact<f64>| {
        (c.a, c.b, c.poisson_ratio) = (SIZE * g.sqrt(), SIZE / g.sqrt(), nu);
    };
    everywhere(|c, _| shape(c), answered);
    everywhere(
        |c, v| {
            shape(c);
            v.spin = 1e3;
        },
        answered,
    );
}

#[rstest]
fn ends_of_poisson_ratio(#[values(0.0, 0.5)] nu: f64) {
    everywhere(|c, _| c.poisson_ratio = nu, answered);
}

#[test]
fn no_friction_no_force() {
    everywhere(
        |c, _| c.friction = 0.0,
        |way, contact, result| {
            answered(way, contact, result);
            let s = result.unwrap();
            if way.options.model == Model::Linear {
                assert_eq!(s.notice, Notice::BeyondFriction);
            } else {
                assert_eq!([s.fx, s.fy, s.mz, s.power], [0.0; 4], "{way:?}");
            }
        },
    );
}

#[test]
fn no_load_no_force() {
    everywhere(
        |c, _| c.normal_force = 0.0,
        |way, contact, result| {
            answered(way, contact, result);
            if way.options.model != Model::Linear {
                let s = result.unwrap();
                assert_eq!([s.fx, s.fy, s.mz, s.power], [0.0; 4], "{way:?}");
            }
        },
    );
}

#[rstest]
fn subnormal_load(#[values(1e-37, 1e-40, 1e-44, 1e-300, 1e-310, 5e-324)] load: f64) {
    everywhere(|c, _| c.normal_force = load, answered);
    // it slides: the force is μ N along the slip, for this small load as for any other
    for options in saturating() {
        let contact = Contact { normal_force: load, ..contact::<f64>(1.0, 0.28) };
        let v = Creepage { longitudinal: 1e-3, lateral: 0.0, spin: 0.0 };
        let s = solve(&contact, &v, &options).unwrap();
        let bound = FRICTION * load;
        assert!((s.fx - bound).abs() <= 2e-3 * bound + 5e-324, "{options:?} {s:?} {bound:e}");
    }
}

#[test]
fn notices() {
    let notice = |g: f64, psi: f64, options: &Options| {
        let solution =
            solve(&contact::<f64>(g, 0.28), &creepage([0.1, 0.0, spin_of(psi, g)]), options);
        solution.unwrap().notice
    };
    let any_spin = [(0.015, 3.1), (60.0, 0.0), (1.0, 4.0)];
    let strips = [(0.015, 0.0), (60.0, 0.0), (1.0, 2.99), (1.0, -2.99), (5.0, 1.0)];
    let slender =
        [(0.0149, 0.0), (60.1, 0.0), (1e3, 1.0)].map(|(g, psi)| (g, psi, Notice::AxisRatio));
    let spinning = [3.01, -3.01].map(|psi| (1.0, psi, Notice::OutsideRange));
    let beyond_strips = [slender.as_slice(), &spinning].concat();
    for options in saturating() {
        let (within, beyond) = if options.model == Model::Total {
            (any_spin.as_slice(), slender.as_slice())
        } else {
            (strips.as_slice(), beyond_strips.as_slice())
        };
        for (g, psi) in within {
            assert_eq!(notice(*g, *psi, &options), Notice::None, "{options:?} {g} {psi}");
        }
        for (g, psi, expected) in beyond {
            assert_eq!(notice(*g, *psi, &options), *expected, "{options:?} {g} {psi}");
        }
        // and so do the strips of the ellipse
        for (g, psi) in [(1.0, 2.9), (1.0, 3.1), (15.0, 0.0), (0.07, 4.0), (40.0, 0.5), (70.0, 0.5)]
        {
            let contact = contact::<f64>(g, 0.28);
            let patch = Patch::<f64, 64>::from_ellipse(&contact, options.strips).unwrap();
            let v = creepage([0.1, 0.0, spin_of(psi, g)]);
            let found = solver::solve(&patch.view().unwrap(), &v, options.model).unwrap();
            assert_eq!(found.notice, notice(g, psi, &options), "{options:?} {g} {psi}");
        }
    }
    let g = 1.0;
    let c11 = LinearCoefficients::at(g, 0.28).c11;
    for (share, expected) in [(0.999, Notice::None), (1.001, Notice::BeyondFriction)] {
        let v = creepage([share / c11, 0.0, 0.0]);
        assert_eq!(solve(&contact::<f64>(g, 0.28), &v, &linear()).unwrap().notice, expected);
    }
}

#[test]
fn totals_have_no_strips_and_no_field() {
    let (contact, v) = (contact::<f64>(1.0, 0.28), creepage([0.1, 0.0, 0.1]));
    for options in [total(), linear()] {
        let mut called = false;
        let result = model::strips(&contact, &v, &options, &mut |_| called = true);
        assert_eq!((result, called), (Err(Error::NotInModel), false));
        assert_eq!(Field::new(&contact, &v, &options).map(|_| ()), Err(Error::NotInModel));
    }
}

/// TOTAL turns smoothly from stick to slip and through zero: over the whole range of a creepage and for every size
/// of steps the derivatives change no faster than the curvature allows.
#[rstest]
fn total_has_no_kink(
    #[values(1.0, 10.0)] g: f64,
    #[values([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.5, -0.5, 0.5])] way: [f64; 3],
    #[values(0.0, 0.3)] spin: f64,
) {
    let at = |t: f64| {
        let mut v = way.map(|w| w * t);
        v[2] += spin;
        slopes(g, 0.28, v, &total())
    };
    // a kink keeps its jump when the step is halved; a curvature halves it
    let jump = |steps: i32| {
        let values: Vec<_> =
            (-steps..=steps).map(|k| at(2.0 * f64::from(k) / f64::from(steps))).collect();
        let largest = |pair: &[[[f64; 3]; 3]]| {
            (0..3).map(|i| far(pair[0][i], pair[1][i])).fold(0.0, f64::max)
        };
        values.windows(2).map(largest).fold(0.0, f64::max)
    };
    let (coarse, fine) = (jump(100), jump(800));
    assert!(fine <= 0.3 * coarse, "{coarse} {fine}");
}
