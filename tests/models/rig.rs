//! The inverse for test rigs: friction from a measured force, creepage from a wanted one.

use crate::prelude::*;
use kstrip_testing::single;
use single::{single, single_motion};

const SATURATING: [Model; 4] =
    [Model::Strip, Model::Total, Model::Strip1967, Model::Strip1967Continuous];

fn any_options(n: usize) -> Options {
    options(SATURATING[n % 4], StripCount::Sixteen)
}

fn any_contact(random: &mut Random) -> Contact<f64> {
    let c = contact(random.log_between(0.2, 5.0), random.between(0.0, 0.5));
    Contact { friction: random.between(0.05, 0.6), ..c }
}

fn rough(warning: Warning) -> bool {
    matches!(warning, Warning::SpinBeyondTheory | Warning::OutsideRange | Warning::AxisRatio)
}

/// Solve, forget the friction, find it again: from either component and from both.
#[test]
fn friction_is_found_again() {
    let mut random = Random::new(81);
    let (mut found, mut several) = (0, 0);
    for n in 0..1_500 {
        let c = any_contact(&mut random);
        let size = random.log_between(0.03, 20.0);
        let [xi, eta, psi] = [0; 3].map(|_| random.between(-1.0, 1.0));
        let m = theory::creepage(&c, size * xi, size * eta, 0.1 * psi);
        let o = any_options(n);
        let s = solved(&c, &m, &o);
        let bound = c.friction * c.normal_force;
        let forgotten = Contact { friction: 0.0, ..c };
        for measured in [Measured::Fx, Measured::Fy, Measured::Both] {
            let used = measured_size(measured, &s);
            // What spin leaves of a component may fall again as friction grows, and sticking tells
            // nothing
            let clear = if measured == Measured::Both { 0.06 } else { 0.3 };
            if used < clear * bound || size * xi.hypot(eta) < 0.1 {
                continue;
            }
            let e = estimate_friction(&forgotten, &m, None, &o, measured, [s.fx, s.fy]).unwrap();
            if e.warning == Warning::SeveralFrictions {
                several += 1;
                assert!(e.friction <= c.friction * (1.0 + 1e-9), "{e:?} {c:?} {m:?} {o:?}");
                continue;
            }
            assert!(e.warning == Warning::None || rough(e.warning), "{e:?}");
            let again = solved(&Contact { friction: e.friction, ..c }, &m, &o);
            let again = measured_size(measured, &again);
            assert!((again - used).abs() <= 1e-11 * bound, "{e:?} {measured:?} {c:?} {m:?} {o:?}");
            // Rounding of the force, times what the answer says of its sensitivity
            let allowed = 1e-12 * c.friction + 1e-12 * bound * e.sensitivity.abs();
            assert!(
                (e.friction - c.friction).abs() <= allowed,
                "{e:?} {measured:?} {c:?} {m:?} {o:?}"
            );
            found += 1;
        }
    }
    println!("{found} found, {several} with several");
    assert!(found > 1_000 && several * 10 < found);
}

#[test]
fn sensitivity_is_the_derivative() {
    let c = contact(1.0, 0.28);
    let o = Options::default();
    for size in [0.2, 0.5, 1.0, 2.0] {
        let m = theory::creepage(&c, size, 0.3 * size, 0.05);
        let s = solved(&c, &m, &o);
        for measured in [Measured::Fx, Measured::Both] {
            let at = |factor: f64| {
                estimate_friction(&c, &m, None, &o, measured, [s.fx * factor, s.fy * factor])
                    .unwrap()
            };
            let h = 1e-5;
            let force = if measured == Measured::Fx { s.fx } else { s.fx.hypot(s.fy) };
            let slope = (at(1.0 + h).friction - at(1.0 - h).friction) / (2.0 * h * force);
            let exact = at(1.0).sensitivity;
            // Slopes of the creep curve have kinks, over 1e-5 of it
            assert!((slope / exact - 1.0).abs() < 1e-6, "{size} {measured:?}: {slope} {exact}");
        }
    }
}

/// Sticking contacts show a lower bound, forces against the slip nothing.
#[test]
fn what_the_force_does_not_tell_is_said() {
    let c = contact(1.0, 0.28);
    for o in (0..4).map(any_options) {
        let at = |m: &Creepage<f64>, fx: f64| {
            estimate_friction(&c, m, None, &o, Measured::Fx, [fx, 0.0])
        };
        let small = theory::creepage(&c, 1e-3, 0.0, 0.0);
        let s = solved(&c, &small, &o);
        let e = at(&small, s.fx).unwrap();
        if o.model == Model::Strip {
            // Its creep curve leaves the linear one both ways
            assert!(
                matches!(e.warning, Warning::FrictionAtLeast | Warning::SeveralFrictions),
                "{e:?}"
            );
        } else {
            assert_eq!((e.warning, e.friction), (Warning::FrictionAtLeast, s.fx / c.normal_force));
        }
        // More than linear theory gives
        let large = theory::creepage(&c, 0.5, 0.0, 0.0);
        let e = at(&large, 10.0 * solved(&c, &large, &o).fx).unwrap();
        assert_eq!(e.warning, Warning::FrictionAtLeast);
        // At rest nothing is known
        let rest = creep(0.0, 0.0, 0.0);
        assert_eq!(at(&rest, 0.0).unwrap().warning, Warning::FrictionAtLeast);
        // No force in spite of slip: no friction
        let e = at(&large, 0.0).unwrap();
        assert_eq!((e.warning, e.friction), (Warning::None, 0.0));
        // Against the slip
        assert_eq!(at(&large, -1000.0), Err(Error::Unexplained));
        let unloaded = Contact { normal_force: 0.0, ..c };
        let e = estimate_friction(&unloaded, &large, None, &o, Measured::Both, [1.0, 0.0]);
        assert_eq!(e, Err(Error::Unexplained));
    }
    let m = theory::creepage(&c, 0.5, 0.0, 0.0);
    let linear = sixteen(Model::Linear);
    assert_eq!(
        estimate_friction(&c, &m, None, &linear, Measured::Fx, [1.0, 0.0]),
        Err(Error::NotInModel)
    );
}

/// Solve, forget the creepage, find it again.
#[test]
fn creepage_is_found_again() {
    let mut random = Random::new(82);
    let (mut found, mut slid, mut lost) = (0, 0, 0);
    for n in 0..2_000 {
        let c = any_contact(&mut random);
        let size = random.log_between(1e-3, 5.0);
        let [xi, eta, psi] = [0; 3].map(|_| random.between(-1.0, 1.0));
        let m = theory::creepage(&c, size * xi, size * eta, 0.6 * psi);
        let o = any_options(n);
        let s = solved(&c, &m, &o);
        let bound = c.friction * c.normal_force;
        let (got, warning) = creepage_for_force(&c, [s.fx, s.fy], m.spin, None, &o).unwrap();
        let again = solved(&c, &got, &o);
        let off = (again.fx - s.fx).hypot(again.fy - s.fy) / bound;
        match warning {
            Warning::CreepageAtLeast => {
                slid += 1;
                assert!(off < 1.1e-3 && s.fx.hypot(s.fy) > (1.0 - 1.1e-3) * bound, "{off}");
                // within a thousandth of full sliding the force hardly tells one creepage from
                // another half as large again
                assert!(
                    got.longitudinal.hypot(got.lateral) <= m.longitudinal.hypot(m.lateral) * 1.5,
                    "{got:?} {m:?} {c:?} {o:?}"
                );
            }
            Warning::NotConverged => {
                lost += 1;
                println!("{off:e} {} {o:?}", s.fx.hypot(s.fy) / bound);
            }
            _ => {
                found += 1;
                assert!(off < 1e-11, "{off:e} {c:?} {m:?} {o:?}");
            }
        }
    }
    println!("{found} found, {slid} sliding, {lost} not converged");
    assert!(found > 1_000 && slid > 50 && lost * 100 < 2_000);
}

/// Linear theory is inverted exactly, and told when it exceeds friction.
#[test]
fn linear_theory_is_inverted() {
    let c = contact(2.0, 0.28);
    let o = sixteen(Model::Linear);
    let bound = c.friction * c.normal_force;
    for (fx, fy, warning) in
        [(0.3, -0.2, Warning::None), (0.0, 0.0, Warning::None), (3.0, 1.0, Warning::BeyondFriction)]
    {
        let (got, told) = creepage_for_force(&c, [fx * bound, fy * bound], 0.2, None, &o).unwrap();
        let s = solved(&c, &got, &o);
        assert!((s.fx / bound - fx).abs() < 1e-12 && (s.fy / bound - fy).abs() < 1e-12);
        assert_eq!(told, warning);
    }
}

/// Beyond `μ N` there is no creepage; without load or friction any will do.
#[test]
fn forces_out_of_reach_are_refused() {
    let c = contact(1.0, 0.28);
    let bound = c.friction * c.normal_force;
    for o in (0..4).map(any_options) {
        let at = |c: &Contact<f64>, fx: f64| creepage_for_force(c, [fx, 0.0], 0.1, None, &o);
        assert_eq!(at(&c, 1.001 * bound), Err(Error::ForceBeyondFriction));
        assert_eq!(at(&c, f64::NAN), Err(Error::NotFinite));
        assert_eq!(at(&c, bound).unwrap().1, Warning::CreepageAtLeast);
        let slippery = Contact { friction: 0.0, ..c };
        assert_eq!(at(&slippery, 1.0), Err(Error::ForceBeyondFriction));
        assert_eq!(at(&slippery, 0.0).unwrap().1, Warning::CreepageAtLeast);
    }
}

#[test]
fn single_precision_round_trips() {
    let mut random = Random::new(83);
    let (mut frictions, mut creepages, mut lost) = (0, 0, 0);
    for n in 0..1_000 {
        let c = single(&any_contact(&mut random));
        let wide = contact(f64::from(c.a / c.b), 0.3);
        let size = random.log_between(0.1, 3.0);
        let [xi, eta, psi] = [0; 3].map(|_| random.between(-1.0, 1.0));
        let m = theory::creepage(&wide, size * xi, size * eta, 0.1 * psi);
        let m = single_motion(&m);
        let o = any_options(n);
        let s = solved(&c, &m, &o);
        let bound = c.friction * c.normal_force;
        if s.fx.hypot(s.fy) > 0.1 * bound && size * xi.hypot(eta) > 0.2 {
            let e = estimate_friction(&c, &m, None, &o, Measured::Both, [s.fx, s.fy]).unwrap();
            if e.warning == Warning::SeveralFrictions {
                continue;
            }
            // a force of single precision is known to about twenty roundings
            let allowed = 2e-6 * c.friction + 2.4e-6 * bound * e.sensitivity.abs();
            assert!((e.friction - c.friction).abs() < allowed, "{e:?} {c:?} {m:?} {o:?}");
            frictions += 1;
        }
        let (got, warning) = creepage_for_force(&c, [s.fx, s.fy], m.spin, None, &o).unwrap();
        if warning == Warning::NotConverged {
            lost += 1;
            continue;
        }
        let again = solved(&c, &got, &o);
        let off = (again.fx - s.fx).hypot(again.fy - s.fy) / bound;
        assert!(off < 2e-3, "{off} {warning:?} {c:?} {m:?} {o:?}");
        creepages += 1;
    }
    println!("{frictions} frictions, {creepages} creepages, {lost} not converged");
    assert!(frictions > 400 && lost * 50 < 1_000);
}

/// What the contact says of its own friction plays no part, be it what it may.
#[test]
fn own_friction_is_ignored() {
    let c = contact(1.5, 0.28);
    let m = theory::creepage(&c, 0.6, 0.2, 0.1);
    for o in (0..4).map(any_options) {
        let s = solved(&c, &m, &o);
        let at = |friction: f64| {
            let contact = Contact { friction, ..c };
            estimate_friction(&contact, &m, None, &o, Measured::Both, [s.fx, s.fy]).unwrap()
        };
        let expected = at(0.0);
        assert!((expected.friction / c.friction - 1.0).abs() < 1e-10);
        for friction in [1e-9, 0.9, -1.0, 1e300, f64::INFINITY, f64::NAN] {
            assert_eq!(at(friction), expected, "{friction} {o:?}");
        }
    }
}

/// Where spin opposes the creepage a force may have several frictions: none is smaller than the one
/// that is found. Every friction from full sliding to the answer is tried, in steps of a
/// thousandth.
#[test]
fn the_smallest_friction_is_found() {
    let mut random = Random::new(87);
    let (mut several, mut found) = (0, 0);
    for n in 0..60 {
        let c = any_contact(&mut random);
        let size = random.log_between(0.1, 3.0);
        let eta = size * random.between(0.3, 1.0);
        let psi = -eta * random.between(0.6, 1.8);
        let m = theory::creepage(&c, 0.1 * size, eta, psi);
        let o = options([Model::Total, Model::Strip][n % 2], StripCount::Eight);
        let s = solved(&c, &m, &o);
        let force = |friction: f64| solved(&Contact { friction, ..c }, &m, &o).fy;
        let e = estimate_friction(&c, &m, None, &o, Measured::Fy, [0.0, s.fy]).unwrap();
        if e.warning == Warning::FrictionAtLeast {
            continue;
        }
        several += usize::from(e.warning == Warning::SeveralFrictions);
        found += 1;
        assert!(e.friction <= c.friction * (1.0 + 1e-9), "{e:?} {c:?} {m:?} {o:?}");
        let sign = s.fy.signum();
        let mut at = s.fy.abs() / c.normal_force * (1.0 + 1e-9);
        while at < e.friction * (1.0 - 1e-9) {
            let excess = sign * (force(at) - s.fy);
            assert!(excess < 1e-9 * s.fy.abs(), "{at} fits, {e:?} {c:?} {m:?} {o:?}");
            at *= 1.001;
        }
    }
    println!("{found} found, {several} of them with several");
    assert!(found > 40);
}

/// A force that is larger than that of any friction has to have the direction of the creepage.
#[test]
fn a_huge_force_of_the_wrong_sign_is_unexplained() {
    let c = contact(1.0, 0.28);
    let m = theory::creepage(&c, 1e-8, 0.0, 0.0);
    let force = 0.3 * c.normal_force;
    for model in SATURATING {
        let o = options(model, StripCount::Sixteen);
        let sign = solved(&c, &m, &o).fx.signum();
        let estimate = |fx: f64| estimate_friction(&c, &m, None, &o, Measured::Fx, [fx, 0.0]);
        assert_eq!(estimate(sign * force).unwrap().warning, Warning::FrictionAtLeast);
        assert_eq!(estimate(-sign * force).err(), Some(Error::Unexplained), "{model:?}");
    }
}
