//! What the inverse promises, with the solutions counted. `KSTRIP_CASES=100000 cargo test --release
//! --test units rig:: -- --nocapture` prints the figures of docs/maintain/runs.md.

use kstrip_testing::prelude::*;

const SATURATING: [Model; 4] =
    [Model::Total, Model::Strip, Model::Strip1967Continuous, Model::Strip1967];

fn cases(few: usize) -> usize {
    std::env::var("KSTRIP_CASES").map_or(few, |n| n.parse().unwrap())
}

/// Friction .05 to .8, a/b .1 to 10; the second number is the unit of slip, `2 μ p₀/G`.
fn any_contact(random: &mut Random) -> (Contact<f64>, f64) {
    let (b, pressure) = (random.log_between(4e-4, 8e-3), random.log_between(2e8, 2e9));
    let a = b * random.log_between(0.1, 10.0);
    let (normal_force, friction) = (2.0 / 3.0 * PI * a * b * pressure, random.between(0.05, 0.8));
    let poisson_ratio = random.between(0.0, 0.5);
    let contact = Contact { a, b, normal_force, poisson_ratio, friction, ..C0 };
    (contact, 2.0 * friction * pressure / contact.shear_modulus)
}

/// A motion whose spin opposes its creepage.
fn opposed(random: &mut Random, n: usize, contact: &Contact<f64>, unit: f64) -> Creepage<f64> {
    let size = random.log_between(0.03, 10.0);
    let [xi, eta] = [0; 2].map(|_| size * random.between(-1.0, 1.0));
    let xi = xi * [0.0, 0.1, 1.0][n % 3];
    let spin = -size * eta.signum() * random.log_between(0.3, 3.0);
    creep(xi * unit, eta * unit, spin * unit / contact.a)
}

/// The result is never larger than the friction that made the force, and where it is smaller, the
/// status says so.
#[test]
fn no_friction_is_missed() {
    for model in SATURATING {
        let mut random = Random::new(301);
        let (mut tried, mut larger, mut silent, mut several, mut bounds) = (0, 0, 0, 0, 0);
        let (mut solutions, mut most, tries) = (0, 0, cases(120));
        for n in 0..tries {
            let (contact, unit) = any_contact(&mut random);
            let motion = opposed(&mut random, n, &contact, unit);
            let measured = [Measured::Fx, Measured::Fy, Measured::Both][n / 2 % 3];
            let o = sixteen(model);
            let made = solved(&contact, &motion, &o);
            let measured =
                if n % 3 == 0 && measured == Measured::Fx { Measured::Fy } else { measured };
            let force = [made.fx, made.fy];
            if measured_size(measured, &made) < 1e-9 * contact.friction * contact.normal_force {
                continue;
            }
            tried += 1;
            let Ok((_, found, solved)) = estimate_counted(&contact, &motion, &o, measured, force)
            else {
                // no friction is said to explain the force
                silent += 1;
                continue;
            };
            solutions += solved;
            most = most.max(solved);
            match found.warning {
                Warning::FrictionAtLeast => {
                    bounds += 1;
                    larger += usize::from(found.friction > contact.friction * (1.0 + 1e-9));
                    continue;
                }
                Warning::SeveralFrictions => several += 1,
                _ => silent += usize::from(found.friction < contact.friction * (1.0 - 1e-6)),
            }
            larger += usize::from(found.friction > contact.friction * (1.0 + 1e-6));
        }
        println!(
            "estimates, {model:?}: {tried}; larger {larger}, smaller without a word {silent}, \
             several {several}, lower bounds {bounds}; solutions: mean {}, at most {most}",
            solutions / tried
        );
        // (its force jumps where adhesion is born)
        let allowed = tried / if model == Model::Strip1967 { 1_000 } else { 20_000 };
        assert!(larger + silent <= allowed && most <= 90, "{model:?}");
    }
}

/// Two frictions, far apart and close together, that earlier versions did not tell.
#[test]
fn close_frictions_are_told() {
    let total = Contact {
        a: 0.003_332_947_995_765_312,
        b: 0.004_572_332_013_238_725,
        normal_force: 13_446.922_882_196_719,
        friction: 0.193_388_064_017_582_54,
        ..C0
    };
    let motion = creep(0.0, 9.379_477_888_511_603e-4, -0.517_434_099_177_47);
    let o = sixteen(Model::Total);
    let force = solved(&total, &motion, &o);
    let found =
        estimate_friction(&total, &motion, None, &o, Measured::Fy, [0.0, force.fy]).unwrap();
    assert_eq!(found.warning, Warning::SeveralFrictions);
    assert!(found.friction < 0.5 * total.friction, "{found:?}");
    let less = Contact { friction: found.friction, ..total };
    let again = solved(&less, &motion, &o);
    assert_relative_eq!(again.fy, force.fy, max_relative = 1e-9);
    // The same in a thousand times the lengths, which hints at a wrong unit: the graver warning
    // stays.
    let large = Contact {
        a: total.a * 1e3,
        b: total.b * 1e3,
        normal_force: total.normal_force * 1e6,
        ..total
    };
    let slow = Creepage { spin: motion.spin / 1e3, ..motion };
    let found =
        estimate_friction(&large, &slow, None, &o, Measured::Fy, [0.0, force.fy * 1e6]).unwrap();
    assert_eq!(found.warning, Warning::SeveralFrictions);

    let strip = Contact {
        a: 0.002_858_666_393_324_693_7,
        b: 0.000_376_578_449_471_886_9,
        normal_force: 1_878.811_251_898_882_6,
        friction: 0.354_441_445_506_393_17,
        ..C0
    };
    let motion =
        creep(5.412_615_851_504_647e-5, -1.878_502_823_146_83e-10, -0.623_965_100_721_438_2);
    let o = sixteen(Model::Strip);
    let force = solved(&strip, &motion, &o);
    let found =
        estimate_friction(&strip, &motion, None, &o, Measured::Fx, [force.fx, 0.0]).unwrap();
    assert_eq!(found.warning, Warning::SeveralFrictions);
    assert!(found.friction < strip.friction * (1.0 + 1e-9), "{found:?}");
}

/// Solutions that a creepage costs: plausible contacts, spin-dominated ones, and any.
#[test]
fn creepages_cost_few_solutions() {
    for model in SATURATING {
        for (kind, [low, high]) in
            [("plausible", [0.0, 0.6]), ("spin-dominated", [0.6, 3.0]), ("wild", [3.0, 1e3])]
        {
            let mut random = Random::new(302);
            let (mut counts, mut lost) = (Vec::new(), 0);
            for _ in 0..cases(250) {
                let (contact, unit) = any_contact(&mut random);
                let size = random.log_between(1e-3, 5.0);
                let [xi, eta] = [0; 2].map(|_| size * random.between(-1.0, 1.0));
                let psi = random.sign() * random.between(low, high);
                let (longitudinal, lateral) = (xi * unit, eta * unit);
                let motion = creep(longitudinal, lateral, psi * unit / contact.a);
                let o = sixteen(model);
                let made = solved(&contact, &motion, &o);
                let bound = contact.friction * contact.normal_force;
                if made.fx.hypot(made.fy) > 0.999 * bound {
                    continue;
                }
                let (found, distance, solutions) =
                    creepage_counted(&contact, [made.fx, made.fy], motion.spin, &o).unwrap();
                counts.push(solutions);
                let again = solved(&contact, &found, &o);
                let off = (again.fx - made.fx).hypot(again.fy - made.fy) / bound;
                assert!((off < 1e-10) == (distance < 1e-10), "{off} {distance}");
                lost += usize::from(off > 1e-10);
            }
            counts.sort_unstable();
            let (n, within) = (counts.len(), counts.iter().filter(|count| **count <= 12).count());
            println!(
                "creepages, {model:?}, {kind}: {n}; median {}, within 12: {:.3} %, at most {}; not \
                 reached: {lost}",
                counts[n / 2],
                100.0 * within as f64 / n as f64,
                counts[n - 1]
            );
            assert!(counts[n - 1] <= 40);
            // (the force of STRIP_1967 jumps where adhesion is born; beyond .99 of the bound that
            // of TOTAL may turn back by a hair)
            let [more, not_reached] = match model {
                Model::Total => [1 + n / 2_000, n / 50_000],
                Model::Strip1967 => [1 + n / 400, 1 + n / 3_000],
                _ => [n / 2_500, n / 50_000],
            };
            let few = n - within <= more && lost <= not_reached;
            assert!(kind != "plausible" || few, "{model:?}: {} {lost}", n - within);
        }
    }
}
