//! Rolling forward, backward, and standstill between them.

use crate::prelude::*;
use kstrip::forces::derivatives;
use kstrip::friction;
use kstrip::motion::{MotionDerivatives, differentiate_motion, solve_motion};
use kstrip_testing::single::single;

const FLOOR: f64 = 0.02;
const WET: SlipFriction<f64> = falling(0.3, 0.4, 0.6, 0.0, 0.5);
/// Behind a layer that sliding softens.
const SOFT: SlipFriction<f64> = SlipFriction { decay: 0.0, slide_factor: 0.5, layer: 3e-14, ..WET };
const LAWS: [Option<SlipFriction<f64>>; 3] = [None, Some(WET), Some(SOFT)];

fn any_contact(random: &mut Random) -> Contact<f64> {
    let (ratio, size) = (random.log_between(0.2, 5.0).sqrt(), random.log_between(1e-4, 2e-2));
    let (a, b) = (size * ratio, size / ratio);
    let friction = random.between(0.05, 0.6);
    let normal_force = random.log_between(1e-3, 2e-2) * 82e9 * a * b * 2.0;
    Contact { a, b, normal_force, friction, poisson_ratio: random.between(0.0, 0.5), ..C0 }
}

/// Slip from nearly linear to full sliding at the speed that it has, with spin of either sign.
fn any_motion(random: &mut Random, contact: &Contact<f64>, rolling_speed: f64) -> Motion<f64> {
    let Contact { a, b, normal_force, shear_modulus, friction, .. } = *contact;
    let unit = friction * normal_force / (shear_modulus * a * b) * rolling_speed.hypot(FLOOR);
    let size = unit * random.log_between(0.03, 3.0);
    let [slip_x, slip_y, spin] = [0; 3].map(|_| size * random.between(-1.0, 1.0));
    Motion { slip_x, slip_y, spin_rate: spin / (a * b).sqrt(), rolling_speed, floor_speed: 0.0 }
}

fn any_speed(random: &mut Random) -> f64 {
    match random.bits() % 4 {
        0 => 0.0,
        1 => random.between(-0.06, 0.06),
        2 => random.sign() * random.log_between(1e-9, 1e-2),
        _ => random.sign() * random.log_between(0.05, 50.0),
    }
}

/// Contacts and motions of any speed, with options and a law.
fn states(
    seed: u64, count: usize,
) -> impl Iterator<Item = (Contact<f64>, Motion<f64>, Options, Option<SlipFriction<f64>>)> {
    let mut random = Random::new(seed);
    (0..count).map(move |n| {
        let (c, speed) = (any_contact(&mut random), any_speed(&mut random));
        let m = any_motion(&mut random, &c, speed);
        (c, m, sixteen(Model::ALL[n % 5]), LAWS[n / 5 % 3])
    })
}

/// From three floors on it is one end that leads, exactly: forward the creepage is slip over speed,
/// backward the contact is turned by 180 degrees, solved and turned back.
#[test]
fn far_from_standstill_one_end_leads() {
    let mut random = Random::new(201);
    for n in 0..400 {
        let (c, o) = (any_contact(&mut random), sixteen(Model::ALL[n % 5]));
        let speed = if n % 3 == 0 { 0.06 } else { random.log_between(0.0601, 100.0) };
        for sign in [1.0, -1.0] {
            let m = any_motion(&mut random, &c, sign * speed);
            let ratio = FLOOR / speed;
            let divisor = speed * (ratio * ratio + 1.0).sqrt();
            assert!((divisor / speed.hypot(FLOOR) - 1.0).abs() < 1e-15);
            let creepage = creep(
                sign * (m.slip_x / divisor),
                sign * (m.slip_y / divisor),
                m.spin_rate / divisor,
            );
            let plain = solved(&c, &creepage, &o);
            let expected = [sign * plain.fx, sign * plain.fy, plain.mz];
            let (found, mu) = solve_motion(&c, &m, None, &o).unwrap();
            assert_eq!(
                (force_and_moment(&found), mu, found.adhesion),
                (expected, c.friction, plain.adhesion)
            );
            let law = SlipFriction { rolling_speed: divisor, ..WET };
            let wet = friction::solve_with_law(&c, &creepage, &law, &o).unwrap();
            let (found, mu) = solve_motion(&c, &m, Some(&WET), &o).unwrap();
            let fy = sign * wet.solution.fy;
            assert_eq!((found.fy, found.mz, mu), (fy, wet.solution.mz, wet.friction));
        }
    }
}

/// Turned by 180 degrees about z the same motion has the same forces, moment, power and
/// derivatives: to the bit. Seen in a mirror along or across the rolling direction too, as
/// far as the model sums its strips alike from either side: to rounding.
#[test]
fn mirrors_are_exact() {
    for (n, (c, m, o, law)) in states(202, 600).enumerate() {
        let (found, mu, slopes) = differentiate_motion(&c, &m, law.as_ref(), &o).unwrap();
        let (plain, plain_mu) = solve_motion(&c, &m, law.as_ref(), &o).unwrap();
        assert!((plain.fx - found.fx).abs() <= 1e-12 * c.friction_bound());
        assert!((plain_mu - mu).abs() <= 1e-12);
        // x and y to their negatives; x alone; y alone: signs of (x, y, moment or spin)
        for [x, y, z] in [[-1.0, -1.0, 1.0], [-1.0, 1.0, -1.0], [1.0, -1.0, -1.0]] {
            let seen = Motion {
                slip_x: x * m.slip_x,
                slip_y: y * m.slip_y,
                spin_rate: z * m.spin_rate,
                rolling_speed: x * m.rolling_speed,
                ..m
            };
            let (image, image_mu, image_slopes) =
                differentiate_motion(&c, &seen, law.as_ref(), &o).unwrap();
            let signs = [x, y, z];
            let turn = |v: [f64; 3]| std::array::from_fn::<f64, 3, _>(|i| signs[i] * v[i]);
            let expected = MotionDerivatives {
                slip: std::array::from_fn(|i| turn(slopes.slip[i].map(|s| s * signs[i]))),
                rolling_speed: turn(slopes.rolling_speed).map(|s| s * x),
                normal_force: turn(slopes.normal_force),
                load_through_hertz: turn(slopes.load_through_hertz),
                friction: turn(slopes.friction),
                ratio: turn(slopes.ratio),
                decay: turn(slopes.decay),
                slope_factor: turn(slopes.slope_factor),
                slide_factor: turn(slopes.slide_factor),
                layer: turn(slopes.layer),
            };
            if z > 0.0 {
                assert_eq!(
                    force_and_moment(&image),
                    turn(force_and_moment(&found)),
                    "{n} {o:?} {m:?}"
                );
                let seen = (image.power, image.adhesion, image_mu);
                assert_eq!(seen, (found.power, found.adhesion, mu), "{n} {o:?} {m:?}");
                assert_eq!(image_slopes, expected, "{n} {o:?} {m:?}");
                continue;
            }
            let unit = 1e-11 * c.friction_bound().max(found.fx.hypot(found.fy));
            for (image, own) in
                force_and_moment(&image).into_iter().zip(turn(force_and_moment(&found)))
            {
                assert!((image - own).abs() < unit, "{n} {o:?} {m:?}: {image} {own}");
            }
            let (image, own) = (scaled(&c, &m, &image_slopes), scaled(&c, &m, &expected));
            for (image, own) in image.into_iter().zip(own) {
                assert!((image - own).abs() < 1e-8 * (1.0 + own.abs()), "{n} {o:?}: {image} {own}");
            }
        }
    }
}

/// All derivatives as one list of numbers, each over a size that it does not exceed by much.
fn scaled(c: &Contact<f64>, m: &Motion<f64>, slopes: &MotionDerivatives<f64>) -> Vec<f64> {
    let radius = (c.a * c.b).sqrt();
    let speed = m.rolling_speed.hypot(FLOOR);
    let stiffness = 5.0 * c.shear_modulus * c.a * c.b;
    let bound = c.friction_bound();
    let MotionDerivatives { slip, rolling_speed, normal_force, load_through_hertz, .. } = *slopes;
    let mut list = Vec::new();
    let rows = [1.0, 1.0, radius];
    for (i, row) in rows.into_iter().enumerate() {
        let columns = slip[i].into_iter().zip(rows);
        list.extend(columns.map(|(slope, column)| slope / (row * column * stiffness / speed)));
        for (slopes, size) in [
            (rolling_speed, bound / speed),
            (normal_force, c.friction),
            (load_through_hertz, c.friction),
            (slopes.friction, c.normal_force),
            (slopes.ratio, bound),
            (slopes.decay, bound),
            (slopes.slope_factor, bound),
            (slopes.slide_factor, bound),
            (slopes.layer, bound * c.shear_modulus / c.a),
        ] {
            list.push(slopes[i] / (row * size));
        }
    }
    list
}

/// Force, moment and every derivative pass through V = 0 and V = ±3 floors without a jump, in every
/// model, with and without falling friction.
#[test]
fn force_and_derivatives_are_continuous_through_standstill() {
    let mut random = Random::new(203);
    for n in 0..300 {
        let (c, o) = (any_contact(&mut random), sixteen(Model::ALL[n % 5]));
        let law = LAWS[n / 5 % 3];
        for at in [0.0, 3.0 * FLOOR, -3.0 * FLOOR] {
            let m = any_motion(&mut random, &c, at);
            let step = 1e-8 * FLOOR;
            let here = |v: f64| {
                let m = Motion { rolling_speed: v, ..m };
                let (found, _, slopes) = differentiate_motion(&c, &m, law.as_ref(), &o).unwrap();
                let radius = (c.a * c.b).sqrt();
                let forces =
                    [found.fx, found.fy, found.mz / radius].map(|f| f / c.friction_bound());
                (forces, scaled(&c, &m, &slopes))
            };
            let ((f, p), (g, q)) = (here(at - step), here(at + step));
            for (f, g) in f.into_iter().zip(g) {
                assert!((f - g).abs() < 1e-7 * (1.0 + f.abs()), "{n} {at} {o:?} {m:?}: {f} {g}");
            }
            for (k, (p, q)) in p.into_iter().zip(q).enumerate() {
                assert!(
                    (p - q).abs() < 1e-5 * (1.0 + p.abs()),
                    "{n} {at} {o:?} entry {k}: {p} {q}"
                );
            }
        }
    }
}

/// Every derivative against differences: slip, spin rate, speed, load at a fixed ellipse and
/// through Hertz, friction and the law.
#[test]
fn derivatives_are_those_of_the_forces() {
    let mut comparison = Comparison::default();
    for (n, (c, m, o, law)) in states(204, 240).enumerate() {
        let law = law.map(|law| SlipFriction { friction: c.friction, ..law });
        let (_, _, s) = differentiate_motion(&c, &m, law.as_ref(), &o).unwrap();
        let (radius, v_f) = ((c.a * c.b).sqrt(), m.rolling_speed.hypot(FLOOR));
        let slip = m.slip_x.abs() + m.slip_y.abs() + radius * m.spin_rate.abs();
        let shaken = |which: usize, by: f64| {
            let (mut c, mut m, mut law) = (c, m, law);
            let factor = 1.0 + by;
            match which {
                0 => m.slip_x += by * slip,
                1 => m.slip_y += by * slip,
                2 => m.spin_rate += by * slip / radius,
                3 => m.rolling_speed += by * v_f,
                4 => c.normal_force *= factor,
                5 => {
                    c.normal_force *= factor;
                    c.a *= factor.cbrt();
                    c.b *= factor.cbrt();
                }
                6 => match &mut law {
                    Some(law) => law.friction *= factor,
                    None => c.friction *= factor,
                },
                7 => law.iter_mut().for_each(|law| law.ratio += by),
                8 => law.iter_mut().for_each(|law| law.decay *= factor),
                9 => law.iter_mut().for_each(|law| law.slope_factor *= factor),
                10 => law.iter_mut().for_each(|law| law.slide_factor *= factor),
                _ => law.iter_mut().for_each(|law| law.layer *= factor),
            }
            force_and_moment(&solve_motion(&c, &m, law.as_ref(), &o).unwrap().0)
        };
        let size = force_and_moment(&solve_motion(&c, &m, law.as_ref(), &o).unwrap().0);
        let size = size[0].abs() + size[1].abs() + size[2].abs() / radius;
        let units = [size, size, size * radius];
        for which in 0..law.map_or(7, |law| if law.layer > 0.0 { 12 } else { 10 }) {
            let by = |h: f64| {
                let forces = shaken(which, h);
                std::array::from_fn(|i| forces[i] / units[i])
            };
            let exact = std::array::from_fn(|i| {
                let slope = match which {
                    0..=2 => s.slip[i][which] * if which == 2 { slip / radius } else { slip },
                    3 => s.rolling_speed[i] * v_f,
                    4 => s.normal_force[i] * c.normal_force,
                    5 => s.load_through_hertz[i] * c.normal_force,
                    6 => s.friction[i] * c.friction,
                    7 => s.ratio[i],
                    8 => s.decay[i] * law.unwrap_or(WET).decay,
                    9 => s.slope_factor[i] * WET.slope_factor,
                    10 => s.slide_factor[i] * SOFT.slide_factor,
                    _ => s.layer[i] * SOFT.layer,
                };
                slope / units[i]
            });
            comparison.column(&by, exact, [1.0; 3], 5e-9, &(n, o, law, which));
        }
    }
    comparison.assert_few_kinks(53);
    assert!(comparison.compared > 1600);
}

/// Friction takes energy out, and no more than it can hold, at every speed through standstill; with
/// falling friction the bound is that of the friction that is reported.
#[test]
fn friction_opposes_slip_and_keeps_its_bound() {
    let mut random = Random::new(205);
    for n in 0..4000 {
        let c = any_contact(&mut random);
        let model = [Model::Total, Model::Strip][n % 2];
        let law = LAWS[n / 2 % 3];
        let speed = any_speed(&mut random);
        let mut m = any_motion(&mut random, &c, speed);
        let huge = 10f64.powf(random.between(0.0, 3.0));
        (m.slip_x, m.slip_y) = (m.slip_x * huge, m.slip_y * huge);
        let (found, mu) = solve_motion(&c, &m, law.as_ref(), &sixteen(model)).unwrap();
        let rigid = m.slip_x.hypot(m.slip_y) + (c.a + c.b) * m.spin_rate.abs();
        let bound = mu * c.normal_force;
        assert!(found.power >= -1e-9 * bound * rigid, "{n} {c:?} {m:?} {found:?}");
        assert!(found.fx.hypot(found.fy) <= bound * (1.0 + 1e-12), "{n} {m:?} {found:?}");
        assert!(mu <= law.map_or(c.friction, |law| law.friction));
    }
}

/// The slip velocity decides about falling friction at standstill: a wheel that spins at 2 m/s on
/// the spot.
#[test]
fn friction_falls_with_the_slip_velocity_at_standstill() {
    for slip in [0.5, 2.0, 10.0] {
        let m = Motion { slip_x: slip, ..Motion::default() };
        let (found, mu) = solve_motion(&C0, &m, Some(&WET), &sixteen(Model::Total)).unwrap();
        let expected = 0.3 * (0.6 * (-0.6 * slip).exp() + 0.4);
        assert!((mu - expected).abs() < 4e-15, "{slip}: {mu} {expected}");
        assert!((found.fx / (mu * 80e3) - 1.0).abs() < 1e-2);
    }
}

/// A law of zeros but for what is set: friction alone is constant friction, friction that falls
/// needs no slope factor.
#[test]
fn a_law_of_zeros_behaves_as_written() {
    let zero = falling(0.0, 0.0, 0.0, 0.0, 0.0);
    for (c, m, o, _) in states(208, 100) {
        let constant = SlipFriction { friction: c.friction, ..zero };
        let (plain, with_law) =
            (solve_motion(&c, &m, None, &o), solve_motion(&c, &m, Some(&constant), &o));
        assert_eq!(plain, with_law);
        let falls = SlipFriction { ratio: 0.4, decay: 0.6, ..constant };
        let one = SlipFriction { slope_factor: 1.0, ..falls };
        assert_eq!(solve_motion(&c, &m, Some(&falls), &o), solve_motion(&c, &m, Some(&one), &o));
    }
}

#[test]
fn a_lost_contact_carries_nothing_at_any_speed() {
    let mut random = Random::new(206);
    for n in 0..100 {
        let o = sixteen(Model::ALL[n % 5]);
        let lost = [
            Contact { normal_force: 0.0, ..C0 },
            Contact { normal_force: -3.0, ..C0 },
            Contact { a: 0.0, b: 0.0, normal_force: 0.0, ..C0 },
            Contact { a: 0.0, b: 0.0, normal_force: -1e-12, ..C0 },
        ][n % 4];
        let speed = any_speed(&mut random);
        let m = any_motion(&mut random, &C0, speed);
        let law = LAWS[n / 4 % 3];
        let (found, _, slopes) = differentiate_motion(&lost, &m, law.as_ref(), &o).unwrap();
        let Solution { power, adhesion, warning, .. } = found;
        assert_eq!(
            (force_and_moment(&found), power, adhesion, warning),
            ([0.0; 3], 0.0, 0.0, Warning::None)
        );
        assert!(scaled(&C0, &m, &slopes).iter().all(|slope| *slope == 0.0), "{slopes:?}");
        assert_eq!(
            force_and_moment(&solve_motion(&lost, &m, law.as_ref(), &o).unwrap().0),
            [0.0; 3]
        );
    }
}

/// Squares that overflow or vanish on the way.
#[test]
fn extreme_motions_are_answered_or_named() {
    let o = sixteen(Model::Total);
    for (rolling_speed, floor_speed) in
        [(1e200, 1e-3), (-1e200, 0.0), (0.0, 1e-200), (1e-250, 1e-200)]
    {
        let m = Motion { slip_x: 1e-205, rolling_speed, floor_speed, ..Motion::default() };
        let (found, _) = solve_motion(&C0, &m, None, &o).unwrap();
        assert!(found.fx >= 0.0 && found.fx < 24e3, "{m:?} {found:?}");
    }
    let beyond = Motion { slip_x: 1e200, floor_speed: 1e-200, ..Motion::default() };
    assert_eq!(solve_motion(&C0, &beyond, None, &o).err(), Some(Error::Overflow));
    assert_eq!(differentiate_motion(&C0, &beyond, None, &o).err(), Some(Error::Overflow));
}

/// Below walking pace any slip is plausible; at speed, a spin rate in degrees per second is not.
#[test]
fn wheel_spin_at_standstill_is_not_implausible() {
    let spun = Motion { slip_x: 5.0, spin_rate: 0.5, ..Motion::default() };
    let said =
        |m: Motion<f64>| solve_motion(&C0, &m, None, &sixteen(Model::Total)).unwrap().0.warning;
    assert!(!said(spun).is_implausible());
    assert_eq!(said(Motion { spin_rate: 0.01, ..spun }), Warning::None);
    let rolling = Motion { slip_x: 0.01, spin_rate: 10.0 * 0.5, rolling_speed: 10.0, ..spun };
    assert_eq!(said(rolling), Warning::None);
    assert_eq!(
        said(Motion { spin_rate: rolling.spin_rate.to_degrees(), ..rolling }),
        Warning::Spin
    );
    assert_eq!(said(Motion { slip_x: 200.0, ..rolling }), Warning::Creepage);
    let soft = Contact { shear_modulus: 82.0, ..C0 };
    let found = solve_motion(&soft, &spun, None, &sixteen(Model::Total)).unwrap().0;
    assert_eq!(found.warning, Warning::Pressure);
}

/// At rest the slopes are those of linear theory over the floor, without the coupling of spin and
/// lateral slip: neither end leads.
#[test]
fn at_rest_the_contact_is_a_damper_of_linear_theory() {
    let still = creep(0.0, 0.0, 0.0);
    for model in Model::ALL {
        let (_, slopes) =
            derivatives::forces_and_derivatives(&C0, &still, &sixteen(model)).unwrap();
        let (_, _, s) =
            differentiate_motion(&C0, &Motion::default(), None, &sixteen(model)).unwrap();
        let rows = s.slip.into_iter().zip(slopes.jacobian);
        for (i, (row, linear)) in rows.enumerate() {
            for (k, (slope, linear)) in row.into_iter().zip(linear).enumerate() {
                let coupling = (i == 2) != (k == 2);
                let expected = if coupling { 0.0 } else { linear / FLOOR };
                assert_eq!(slope, expected, "{model:?} {i} {k}");
            }
        }
        assert_eq!(s.rolling_speed, [0.0; 3]);
    }
}

#[test]
fn single_precision_follows() {
    for (n, (c, m, o, _)) in states(207, 200).enumerate() {
        let single = single(&c);
        let motion = Motion::<f32> {
            slip_x: m.slip_x as f32,
            slip_y: m.slip_y as f32,
            spin_rate: m.spin_rate as f32,
            rolling_speed: m.rolling_speed as f32,
            floor_speed: 0.0,
        };
        let (expected, _) = solve_motion(&c, &m, None, &o).unwrap();
        let (found, _, _) = differentiate_motion(&single, &motion, None, &o).unwrap();
        let size = c.friction_bound().max(expected.fx.hypot(expected.fy));
        assert!((f64::from(found.fx) - expected.fx).abs() < 1e-4 * size, "{n} {o:?}");
        assert!((f64::from(found.fy) - expected.fy).abs() < 1e-4 * size, "{n} {o:?}");
    }
}

/// A mass on a locked wheel: its speed after steps of 1 ms of the linearly implicit rule, which may
/// take a step again from the forces at standstill if it would turn the slip round.
fn stopped(is_taken_again: bool, push: f64) -> f64 {
    const STEP: f64 = 1e-3;
    let contact = Contact { a: 6e-3, b: 5e-3, normal_force: 80e3, friction: 0.235, ..C0 };
    let mass = contact.normal_force / 9.81;
    // force on the mass, and its derivative with respect to the speed
    let at = |speed: f64| {
        let rolling_speed = speed / 2.0;
        let motion =
            Motion { slip_x: speed, slip_y: 0.0, spin_rate: 0.0, rolling_speed, floor_speed: 0.0 };
        let (found, _, by) =
            differentiate_motion(&contact, &motion, None, &sixteen(Model::Strip)).unwrap();
        (push - found.fx, -by.slip[0][0] - by.rolling_speed[0] / 2.0)
    };
    let (mut speed, mut fastest) = (0.05_f64, 0.0_f64);
    for k in 0..400 {
        let (force, slope) = at(speed);
        let mut next = speed + STEP * force / (mass - STEP * slope);
        if is_taken_again && next * speed < 0.0 {
            let (force, slope) = at(0.0);
            let again = (mass * speed + STEP * force) / (mass - STEP * slope);
            // friction holds the mass
            if (slope * again).abs() < contact.friction * contact.normal_force {
                next = again;
            }
        }
        speed = next;
        if k >= 300 {
            fastest = fastest.max(speed.abs());
        }
    }
    fastest
}

/// Sliding friction has no slope, so that a step of this rule leads beyond standstill by up to
/// `μ g h`, and the next step leads back. With the forces of standstill the mass stops.
#[test]
fn a_locked_wheel_stops_with_the_forces_of_standstill() {
    let most = 0.235 * 9.81 * 1e-3;
    let cycle = stopped(false, 0.0);
    assert!((0.3 * most..1.01 * most).contains(&cycle), "{cycle}");
    assert!(stopped(true, 0.0) < 1e-9);
    // a push below the friction holds the mass at the creep of standstill
    assert!(stopped(true, 10e3) < 1e-4);
}
