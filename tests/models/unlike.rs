//! Unlike materials: what pressure adds to the creepage, in every model but those of 1967.

use crate::prelude::*;
use kstrip::contact::hertz::from_hertz;
use kstrip::friction::derivatives;
use kstrip::motion;
use kstrip_testing::reference::contact;
use kstrip_testing::reference::*;

const MODELS: [Model; 3] = [Model::Strip, Model::Total, Model::Linear];

/// Steel below, aluminium above.
fn pair() -> f64 {
    let steel = Material { shear_modulus: 82e9, poisson_ratio: 0.28 };
    let aluminium = Material { shear_modulus: 26e9, poisson_ratio: 0.34 };
    combine(&steel, &aluminium).unwrap().mismatch
}

fn state(random: &mut Random) -> (Contact<f64>, Creepage<f64>) {
    let contact = Contact {
        mismatch: random.between(-0.25, 0.25),
        friction: random.between(0.1, 0.5),
        ..contact(random.log_between(0.03, 30.0), random.between(0.1, 0.5))
    };
    let unit = contact.friction * NORMAL_FORCE / (SHEAR_MODULUS * SIZE * SIZE);
    let [x, y, spin] = [0.3, 0.3, 0.5].map(|size| random.between(-size, size) * unit);
    (contact, creep(x, y, spin / SIZE))
}

fn forces(solution: &Solution<f64>) -> [f64; 3] {
    [solution.fx, solution.fy, solution.mz / SIZE]
}

#[test]
fn a_contact_of_hertz_knows_its_pair() {
    let [steel, soft] = [(82e9, 0.28), (26e9, 0.34)]
        .map(|(shear_modulus, poisson_ratio)| Material { shear_modulus, poisson_ratio });
    let radii = radii([FLAT, 0.3, 0.46, FLAT]);
    let mismatch = |lower, upper| {
        let pair = combine(lower, upper).unwrap();
        let (contact, ellipse, _) = from_hertz(&radii, &pair, 80e3, 0.3).unwrap();
        let (same, _, _) = from_approach(&radii, &pair, ellipse.approach, 0.3).unwrap();
        assert_eq!((contact.mismatch, same.mismatch), (pair.mismatch, pair.mismatch));
        contact.mismatch
    };
    assert_eq!((mismatch(&steel, &steel), mismatch(&soft, &soft)), (0.0, 0.0));
    assert!(mismatch(&steel, &soft) < -0.06 && mismatch(&steel, &soft) == -mismatch(&soft, &steel));
}

/// Rolling without creepage there is a force that changes its sign with the bodies, and nothing
/// lateral; at standstill there is none.
#[test]
fn at_rest_there_is_a_force_where_it_rolls() {
    let unlike = Contact { mismatch: pair(), ..contact(1.5, 0.3) };
    let exchanged = Contact { mismatch: -unlike.mismatch, ..unlike };
    let rest = creep(0.0, 0.0, 0.0);
    for model in MODELS {
        let [found, other] = [&unlike, &exchanged].map(|c| solved(c, &rest, &sixteen(model)));
        assert!(found.fx > 0.1 * BOUND && found.fx < 0.5 * BOUND, "{model:?} {}", found.fx);
        assert_eq!((found.fx, found.power), (-other.fx, other.power), "{model:?}");
        assert_eq!((found.fy, found.mz, found.warning), (0.0, 0.0, Warning::None), "{model:?}");
        let stands =
            motion::solve_motion(&unlike, &Motion::default(), None, &sixteen(model)).unwrap().0;
        assert_eq!((stands.fx, stands.power), (0.0, 0.0), "{model:?}");
        // far from standstill it is the same force forward and backward, in axes that stay
        let rolls = |rolling_speed| {
            let motion = Motion { rolling_speed, ..Motion::default() };
            motion::solve_motion(&unlike, &motion, None, &sixteen(model)).unwrap().0.fx
        };
        assert!((rolls(50.0) - found.fx).abs() < 1e-6 * BOUND && rolls(-50.0) == -rolls(50.0));
    }
    for model in [Model::Strip1967, Model::Strip1967Continuous] {
        let found = solved(&unlike, &rest, &sixteen(model));
        assert_eq!((found.fx, found.warning), (0.0, Warning::MismatchNeglected));
    }
}

/// Friction only dissipates; what the creepage alone brings in may be less than nothing by the
/// force times what pressure adds.
#[test]
fn rolling_takes_no_energy_from_nothing() {
    let mut random = Random::new(26);
    let mut least = 0.0_f64;
    for _ in 0..4000 {
        let (contact, creepage) = state(&mut random);
        let adds =
            contact.mismatch * NORMAL_FORCE / (SHEAR_MODULUS * contact.a * (contact.a + contact.b));
        for model in MODELS {
            let found = solved(&contact, &creepage, &sixteen(model));
            let Creepage { longitudinal, lateral, spin } = creepage;
            let brought = found.fx * longitudinal + found.fy * lateral + found.mz * spin;
            assert!(found.power >= 0.0, "{model:?} {contact:?} {creepage:?}");
            let from_load = (found.power - brought).abs();
            assert!(from_load <= 0.72 * (found.fx * adds).abs() + 1e-9, "{model:?} {contact:?}");
            least = least.min(brought / (BOUND * adds.abs()));
        }
    }
    println!("least power of the creepage alone {least:.3} of mu N times the strain");
    assert!(least < -0.1 && least > -0.72);
}

/// Derivatives are those of what is computed: by creepages, load, load through Hertz and friction,
/// constant and falling, and by speed.
#[test]
fn derivatives_go_through_the_shift() {
    let mut random = Random::new(7);
    for case in 0..150 {
        let (contact, creepage) = state(&mut random);
        let o = sixteen(MODELS[case % 3]);
        let law = (case % 2 == 1).then_some(falling(contact.friction, 0.4, 0.6, 20.0, 0.7));
        let solve = |contact: &Contact<f64>,
                     creepage: &Creepage<f64>,
                     law: Option<SlipFriction<f64>>| {
            let found =
                derivatives::differentiate_with_law(contact, creepage, law.as_ref(), &o).unwrap();
            (forces(&found.solution), found.derivatives)
        };
        let Derivatives { jacobian, normal_force, load_through_hertz, friction } =
            solve(&contact, &creepage, law).1;
        let check = |what: &str, unit: f64, slope: [f64; 3], at: &dyn Fn(f64) -> [f64; 3]| {
            let h = 1e-6;
            let (ahead, behind) = (at(h), at(-h));
            for i in 0..3 {
                let difference = (ahead[i] - behind[i]) / (2.0 * h);
                let slope = slope[i] * unit / if i == 2 { SIZE } else { 1.0 };
                let off = (slope - difference).abs() / (contact.friction * NORMAL_FORCE);
                assert!(off < 1e-6, "{what} {i}: {slope} {difference} {o:?} {contact:?} {law:?}");
            }
        };
        let unit = contact.friction * NORMAL_FORCE / (SHEAR_MODULUS * SIZE * SIZE);
        let Creepage { longitudinal, lateral, spin } = creepage;
        check("longitudinal", unit, jacobian.map(|row| row[0]), &|h| {
            solve(&contact, &Creepage { longitudinal: longitudinal + h * unit, ..creepage }, law).0
        });
        check("lateral", unit, jacobian.map(|row| row[1]), &|h| {
            solve(&contact, &Creepage { lateral: lateral + h * unit, ..creepage }, law).0
        });
        check("spin", unit / SIZE, jacobian.map(|row| row[2]), &|h| {
            solve(&contact, &Creepage { spin: spin + h * unit / SIZE, ..creepage }, law).0
        });
        let loaded = |h: f64| Contact { normal_force: NORMAL_FORCE * (1.0 + h), ..contact };
        check("load", NORMAL_FORCE, normal_force, &|h| solve(&loaded(h), &creepage, law).0);
        check("Hertz", NORMAL_FORCE, load_through_hertz, &|h| {
            let grows = (1.0 + h).cbrt();
            let grown = Contact { a: contact.a * grows, b: contact.b * grows, ..loaded(h) };
            solve(&grown, &creepage, law).0
        });
        check("friction", contact.friction, friction, &|h| {
            let friction = contact.friction * (1.0 + h);
            let law = law.map(|law| SlipFriction { friction, ..law });
            solve(&Contact { friction, ..contact }, &creepage, law).0
        });
        // speeds: standstill, beside it, far from it
        let rolling_speed = [0.0, 0.01, -0.03, 3.0, -5.0][case % 5];
        let speed = f64::hypot(rolling_speed, 0.02);
        let [slip_x, slip_y, spin_rate] = [longitudinal, lateral, spin].map(|c| c * speed);
        let moves = Motion { slip_x, slip_y, spin_rate, rolling_speed, floor_speed: 0.0 };
        let at = |rolling_speed: f64| {
            let moves = Motion { rolling_speed, ..moves };
            motion::differentiate_motion(&contact, &moves, law.as_ref(), &o).unwrap()
        };
        check("speed", speed, at(rolling_speed).2.rolling_speed, &|h| {
            forces(&at(rolling_speed + h * speed).0)
        });
    }
}

/// The strips of an ellipse answer as the ellipse does, with its derivatives, under falling
/// friction too.
#[test]
fn a_patch_carries_the_mismatch_of_its_contact() {
    let mut random = Random::new(11);
    for case in 0..40 {
        let (contact, creepage) = state(&mut random);
        let model = [Model::Strip, Model::Total][case % 2];
        let patch = Patch::<f64>::from_ellipse(&contact, StripCount::Sixteen).unwrap();
        let law = (case % 4 > 1).then_some(falling(contact.friction, 0.4, 0.6, 20.0, 0.7));
        let found = patch_friction::differentiate_patch(
            &patch.view().unwrap(),
            &creepage,
            law.as_ref(),
            model,
        )
        .unwrap();
        let of_ellipse =
            derivatives::differentiate_with_law(&contact, &creepage, law.as_ref(), &sixteen(model))
                .unwrap();
        let bound = contact.friction * NORMAL_FORCE;
        let near = |what: &str, p: [f64; 3], q: [f64; 3], unit: f64| {
            for (p, q) in p.into_iter().zip(q) {
                assert!(
                    (p - q).abs() * unit < 0.02 * bound,
                    "{what} {p} {q} {model:?} {contact:?}"
                );
            }
        };
        near("force", forces(&found.solution), forces(&of_ellipse.solution), 1.0);
        near("power", [found.solution.power; 3], [of_ellipse.solution.power; 3], 30.0);
        let (p, q) = (found.derivatives, of_ellipse.derivatives);
        let metres = |[x, y, z]: [f64; 3]| [x, y, z / SIZE];
        near("friction", metres(p.friction), metres(q.friction), contact.friction);
        near("load", metres(p.normal_force), metres(q.normal_force), NORMAL_FORCE);
        near("Hertz", metres(p.load_through_hertz), metres(q.load_through_hertz), NORMAL_FORCE);
        let unit = bound / (SHEAR_MODULUS * SIZE * SIZE);
        for (p, q) in p.jacobian.into_iter().zip(q.jacobian) {
            near("creepage", [p[0], p[1], p[2] / SIZE], [q[0], q[1], q[2] / SIZE], 0.1 * unit);
        }
        // the strips share the power
        if model == Model::Strip && law.is_none() {
            let strips = strips_of_patch(&patch.view().unwrap(), &creepage, model);
            let shared: f64 = strips.iter().map(|strip| strip.power).sum();
            assert!((shared - found.solution.power).abs() <= 4e-15 * bound);
        }
    }
}

/// Unlike minus like against CONTACT, `tests/data/kappa.csv`.
#[test]
fn agrees_with_contact() {
    let pairs = unlike();
    for model in [Model::Total, Model::Strip] {
        let (mut all, mut ordinary) = (Vec::new(), Vec::new());
        for pair in &pairs {
            let ([x, y], [x0, y0]) = (pair.difference(model), pair.difference);
            let off = (x - x0).hypot(y - y0);
            all.push(off);
            if pair.is_ordinary() {
                ordinary.push(off);
            }
        }
        let (all, ordinary) = (figures(&all), figures(&ordinary));
        println!("{model:?}: {all:?}; ordinary pairs {ordinary:?}");
        assert!(all.mean < 0.043 && all.p95 < 0.13 && all.max < 0.22, "{model:?}");
        assert!(ordinary.mean < 0.014 && ordinary.p95 < 0.035, "{model:?}");
    }
}

/// The warning of a mismatch beyond .25 begins there, of contacts and of patches, with falling
/// friction and without.
#[test]
fn the_warning_of_a_mismatch_begins_at_a_quarter() {
    let motion = creep(1e-4, 0.0, 0.0);
    let law = falling(0.3, 0.4, 0.6, 20.0, 1.0);
    for (mismatch, expected) in [(0.2475, Warning::None), (-0.2525, Warning::Mismatch)] {
        let contact = Contact { mismatch, ..contact(1.5, 0.3) };
        let patch = Patch::<f64>::from_ellipse(&contact, StripCount::Sixteen).unwrap();
        for law in [None, Some(&law)] {
            let o = sixteen(Model::Strip);
            let found = derivatives::differentiate_with_law(&contact, &motion, law, &o).unwrap();
            assert_eq!(found.solution.warning, expected, "{mismatch} {law:?}");
            let view = patch.view().unwrap();
            let found = patch_friction::differentiate_patch(&view, &motion, law, Model::Strip);
            assert_eq!(found.unwrap().solution.warning, expected, "{mismatch} {law:?}");
        }
    }
}
