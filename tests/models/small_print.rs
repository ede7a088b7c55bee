//! What a wrong sign or one per cent of a constant would leave unnoticed elsewhere.

use crate::prelude::*;
use kstrip_testing::names::*;
use kstrip_testing::single::single;

const WITH_STRIPS: [Model; 3] = [Model::Strip1967, Model::Strip1967Continuous, Model::Strip];

fn strips(c: &Contact<f64>, m: &Creepage<f64>, model: Model) -> Vec<StripResult<f64>> {
    let mut found = Vec::new();
    forces::strips(c, m, &options(model, StripCount::Eight), &mut |strip| found.push(strip))
        .unwrap();
    found
}

/// Each strip's own forces in every octant of the signs: all three motions reversed reverse the
/// forces of each strip where it stands; `(υx, φ)` reversed reverses `F_x` and keeps `F_y`;
/// `(υy, φ)` reversed keeps `F_x` of the strip on the other side and reverses `F_y`.
#[test]
fn strips_carry_mirrored_forces_in_all_octants() {
    let mut random = Random::new(320);
    for n in 0..120 {
        let c = contact(random.log_between(0.2, 5.0), random.between(0.0, 0.5));
        let unit = c.friction * c.normal_force;
        let [xi, eta, psi] = [0; 3].map(|_| random.sign() * random.log_between(0.05, 1.0));
        let model = WITH_STRIPS[n % 3];
        let own = strips(&c, &creepage(&c, xi, eta, 0.9 * psi), model);
        let same = |turned: Vec<StripResult<f64>>, mirrored: bool, by_x: f64, by_y: f64| {
            assert_eq!(own.len(), turned.len());
            for (i, strip) in own.iter().enumerate() {
                let other = &turned[if mirrored { own.len() - 1 - i } else { i }];
                let off = (strip.fx - by_x * other.fx).abs() + (strip.fy - by_y * other.fy).abs();
                assert!(off < 1e-12 * unit, "{model:?} {i}: {strip:?} {other:?}");
            }
        };
        same(strips(&c, &creepage(&c, -xi, -eta, -0.9 * psi), model), false, -1.0, -1.0);
        same(strips(&c, &creepage(&c, -xi, eta, 0.9 * psi), model), true, -1.0, 1.0);
        same(strips(&c, &creepage(&c, xi, -eta, -0.9 * psi), model), true, 1.0, -1.0);
    }
}

/// Far in sliding every point slips as the bodies move, `(υx − φ y, υy + φ x)`.
#[test]
fn slip_far_in_sliding_is_rigid_slip() {
    let c = contact(1.3, 0.28);
    let m = creepage(&c, 3e3, -2e3, 1.5e3);
    let size = m.longitudinal.hypot(m.lateral);
    for model in WITH_STRIPS {
        // (of the theory of 1967 no more than unit spin is in its slip)
        let m = if model == Model::Strip { m } else { Creepage { spin: 0.0, ..m } };
        let field = Field::new(&c, &m, &sixteen(model)).unwrap();
        for [x, y] in [[0.0, 0.0], [0.5, 0.3], [-0.4, -0.6], [-0.7, 0.2]] {
            let (x, y) = (x * c.a, y * c.b);
            let point = field.at(x, y);
            let [rigid_x, rigid_y] = [m.longitudinal - m.spin * y, m.lateral + m.spin * x];
            let off = (point.slip_x - rigid_x).hypot(point.slip_y - rigid_y);
            assert!(off < 2e-3 * size, "{model:?} {x} {y}: {point:?} {rigid_x} {rigid_y}");
        }
    }
}

/// A patch of two ellipses has, on each, the field of that ellipse alone.
#[test]
fn fields_of_lobes_are_those_of_each_alone() {
    let (first, second) = (contact(0.5, 0.28), contact(3.0, 0.28));
    let second = Contact { friction: 0.2, ..second };
    let pair = [(first, -first.b - 1e-3), (second, second.b + 9e-3)];
    let both = side_by_side(&pair, StripCount::Eight);
    let m = creepage(&first, 0.3, -0.2, 0.0);
    let view = both.view().unwrap();
    let field = PatchField::new(&view, &m, None, Model::Strip).unwrap();
    for (c, centre) in pair {
        let own = Full::from_ellipse(&c, StripCount::Eight).unwrap();
        let own_view = own.view().unwrap();
        let own = PatchField::new(&own_view, &m, None, Model::Strip).unwrap();
        for [x, y] in [[0.0, 0.05], [-0.5, 0.4], [0.3, -0.6]] {
            let (x, y) = (x * c.a, y * c.b);
            let (one, other) = (field.at(x, y + centre), own.at(x, y));
            let unit = c.friction * c.peak_pressure();
            let off = (one.traction_x - other.traction_x).hypot(one.traction_y - other.traction_y);
            assert!(off < 1e-9 * unit && one.pressure > 0.0, "{one:?} {other:?}");
        }
    }
}

#[test]
fn total_in_single_precision_is_right_at_any_creepage() {
    let c = contact(1.5, 0.28);
    let o = sixteen(Model::Total);
    for exponent in -2..=28 {
        let size = 10_f64.powi(exponent);
        let m = creepage(&c, 0.6 * size, -0.5 * size, 0.3 * size);
        let double = solved(&c, &m, &o);
        let one = solved(&single(&c), &single_motion(&m), &o);
        let off = (f64::from(one.fx) - double.fx).hypot(f64::from(one.fy) - double.fy);
        assert!(off < 3e-5 * c.friction * c.normal_force, "1e{exponent}: {one:?} {double:?}");
    }
}

/// The warning of a spin in another unit begins at `|φ| √(ab) = 0.05`; that of friction in per cent
/// above 5; that of the theory of 1967 with `|ψ| = 1` itself.
#[test]
fn warnings_begin_where_they_say() {
    let c = contact(1.0, 0.28);
    let radius = (c.a * c.b).sqrt();
    let light = Contact { normal_force: c.normal_force * 1e-3, ..c };
    for (share, warning) in [(0.998, Warning::None), (1.002, Warning::Spin)] {
        let m = creep(0.0, 0.0, 0.05 * share / radius);
        let o = sixteen(Model::Total);
        assert_eq!(solved(&light, &m, &o).warning, warning, "{share}");
    }
    for (friction, warning) in [(4.99, Warning::None), (5.01, Warning::Friction)] {
        let slippery = Contact { friction, ..c };
        let o = sixteen(Model::Total);
        let rest = creep(0.0, 0.0, 0.0);
        assert_eq!(solved(&slippery, &rest, &o).warning, warning, "{friction}");
    }
    // the numbers next to unit spin, one of which is exactly one
    let o = sixteen(Model::Strip1967);
    let mut unit_spins = 0;
    for n in 0..200 {
        let c = kstrip_contact { friction: 0.2 + 1e-3 * f64::from(n), ..c };
        let near = creepage(&c, 0.0, 0.0, 1.0).spin;
        for step in -4..=4 {
            let spin = f64::from_bits(near.to_bits().wrapping_add_signed(step));
            let m = kstrip_creepage { longitudinal: 1e-3, lateral: 0.0, spin };
            let mut told = MaybeUninit::uninit();
            assert_eq!(kstrip_parameters_from_creepage(Some(&c), Some(&m), Some(&mut told)), 0);
            // SAFETY: status 0.
            let psi = unsafe { told.assume_init() }.psi;
            let warning = solved(&c, &m, &o).warning;
            unit_spins += i32::from(psi == 1.0);
            assert_eq!(warning == Warning::SpinBeyondTheory, psi >= 1.0, "{psi:e}");
        }
    }
    assert!(unit_spins > 20, "{unit_spins}");
}

/// What overflows for a contact does for one turned by a right angle.
#[test]
fn linear_theory_overflows_on_needles_either_way() {
    let o = sixteen(Model::Linear);
    let c = contact(1.0, 0.28);
    let mut refused = [0; 2];
    for (size, refused) in [1e3, 1e120].into_iter().zip(&mut refused) {
        for exponent in 1..=70 {
            let (long, short) = (10_f64.powi(exponent), 10_f64.powi(-exponent));
            let at = |a: f64, b: f64| {
                let c = Contact { a, b, ..c };
                let m = creep(size, size, 0.0);
                forces::check(&c, &m, &o)
            };
            assert_eq!(at(long, short), at(short, long), "1e{exponent}");
            *refused += i32::from(at(long, short).is_err());
        }
    }
    assert!(refused[0] < refused[1] && refused[1] < 70, "{refused:?}");
}

/// STRIP's force does not exceed friction by more than two units of the last place, far in sliding
/// and turning.
#[test]
fn strip_keeps_the_friction_bound_to_its_last_digits() {
    let mut random = Random::new(326);
    let mut worst = [0.0_f64; 2];
    for _ in 0..4000 {
        let c = contact(random.log_between(0.05, 20.0), random.between(0.0, 0.5));
        let [xi, eta, psi] = [0; 3].map(|_| random.sign() * random.log_between(1e-3, 1e4));
        let (m, o) = (creepage(&c, xi, eta, psi), sixteen(Model::Strip));
        let of = solved(&c, &m, &o);
        worst[0] = worst[0].max((of.fx.hypot(of.fy) / c.friction_bound() - 1.0) / f64::EPSILON);
        let c = single(&c);
        let of = solved(&c, &single_motion(&m), &o);
        let size = f64::from(of.fx).hypot(f64::from(of.fy)) / f64::from(c.friction_bound());
        worst[1] = worst[1].max((size - 1.0) / f64::from(f32::EPSILON));
    }
    println!("{worst:?} units");
    assert!(worst.iter().all(|worst| *worst <= 2.0), "{worst:?}");
}
