//! Contacts whose normal turns: each strip has its own slip. Derivatives, symmetry and power.

use crate::prelude::*;
use crate::wheel_rail::{assert_derivatives, assert_near, dot, moved, power};
use kstrip::patch::friction;
use kstrip::wheel_rail::forces::across::{StripPower, power_across};
use kstrip_testing::manchester::profile;

/// The contacts of a worn wheel on a worn rail; the normal turns by 25 degrees over one of them.
fn contacts(yaw: f64, left: bool) -> Vec<WheelContact<f64>> {
    let (rail, wheel) = (profile("rail288"), profile("whl288"));
    let pair = kstrip::wheel_rail::WheelPair { left: i32::from(left), ..steel(0.4191) };
    let scene = scene(&rail, &wheel, &pair);
    let mut memory = zeroed::<Workspace<f64>>();
    let side = if left { -1.0 } else { 1.0 };
    let position = Position { lateral: side * -65.44e-3, yaw: side * yaw, ..Position::default() };
    let (vertical, _) = scene.height_for_load(&position, 100e3, None, &mut memory).unwrap();
    scene.place(&Position { vertical, ..position }, &mut memory).unwrap();
    let found = memory.found().to_vec();
    assert!(found.iter().any(|contact| contact.angle_range > 0.3));
    found
}

const FALLING: SlipFriction<f64> =
    SlipFriction { slide_factor: 0.5, layer: 2e-14, ..falling(0.3, 0.4, 0.6, 0.0, 0.7) };

fn rolling(speed: f64) -> Velocity<f64> {
    Velocity {
        forward: speed,
        lateral: 1e-3 * speed + 1e-5,
        vertical: 2e-4 * speed,
        roll: 3e-3 * speed,
        pitch: -speed / 0.4191 + 1e-5,
        yaw: 2e-3 * speed,
    }
}

/// Exact derivatives against differences: forward, backward, through standstill; falling friction
/// behind a layer, unlike materials, damped pressure.
#[test]
fn derivatives_are_those_of_differences() {
    let contacts = contacts(3e-3, false);
    let mut unlike = contacts.clone();
    unlike.iter_mut().for_each(|contact| contact.patch.mismatch = 0.1);
    let mut damped = contacts.clone();
    damped.iter_mut().for_each(|contact| contact.normal_damping = 0.5);
    // on a belt
    let mut moving = contacts.clone();
    moving.iter_mut().for_each(|contact| {
        (contact.at_rest.slip_x, contact.at_rest.rolling_speed) = (3.0, 1.5);
        contact.strip_rail_speed.fill(3.0);
    });
    for (contacts, falling, model) in [
        (&contacts, None, Model::Strip),
        (&contacts, None, Model::Strip1967Continuous),
        (&contacts, Some(&FALLING), Model::Strip),
        (&contacts, Some(&FALLING), Model::Strip1967Continuous),
        (&unlike, None, Model::Strip),
        (&unlike, Some(&FALLING), Model::Strip),
        (&damped, Some(&FALLING), Model::Strip),
        (&moving, Some(&FALLING), Model::Strip),
    ] {
        let law = Law { model, falling };
        for speed in [20.0, 2.0, 0.03, 0.0, -0.02, -4.0] {
            let velocity = rolling(speed);
            let mut slopes: Box<WrenchDerivatives<f64>> = zeroed();
            of_contacts(contacts, &velocity, law, Some(&mut slopes)).unwrap();
            let scale = (speed * speed + 4e-4_f64).sqrt();
            assert_derivatives(&slopes.velocity, 0..6, (3e-7 * scale, 1e-3 / scale), |k, step| {
                of_contacts(contacts, &moved(&velocity, k, step), law, None).unwrap()
            });
            let of_friction = |step: f64| {
                let mut contacts = contacts.clone();
                let strips = contacts.iter_mut().flat_map(|contact| &mut contact.patch.strips);
                strips.for_each(|strip| strip.friction *= 1.0 + step);
                of_contacts(&contacts, &velocity, law, None).unwrap()
            };
            let expected = difference(&of_friction(1e-5), &of_friction(-1e-5), 1e-5);
            assert_near(&slopes.friction, &expected, (1e-6, 1e-9));
        }
    }
}

#[test]
fn left_is_the_mirror_of_right_and_friction_dissipates() {
    let (right, left) = (contacts(3e-3, false), contacts(3e-3, true));
    let velocity = rolling(20.0);
    let Velocity { forward, lateral, vertical, roll, pitch, yaw } = velocity;
    let mirrored = Velocity { forward, lateral: -lateral, vertical, roll: -roll, pitch, yaw: -yaw };
    let [a, b] = [(&right, &velocity), (&left, &mirrored)]
        .map(|(contacts, velocity)| of_contacts(contacts, velocity, STRIP, None).unwrap());
    let [fx, fy, fz, mx, my, mz] = a.members();
    assert_eq!([fx, -fy, fz, -mx, my, -mz], b.members());
    for speed in [20.0, 0.01, -3.0] {
        let velocity = rolling(speed);
        let wrench = of_contacts(&right, &velocity, STRIP, None).unwrap();
        assert!(wrench.dissipation > 0.0, "{speed}");
        // creep forces and pressure take the power of the wheel
        let pressed = |contact: &WheelContact<f64>| {
            contact.share * contact.normal_force * dot(&contact.normal, &rates(&velocity))
        };
        let of_pressure: f64 = right.iter().map(pressed).sum();
        let rest = power(&wrench, &velocity) + wrench.dissipation + of_pressure;
        assert!(rest.abs() < 1e-9 * wrench.normal_force * speed.abs(), "{speed} {rest}");
    }
}

#[test]
fn backward_rolling_is_that_of_the_mirror_image() {
    let (wheel, image) = (contacts(6e-3, false), contacts(-6e-3, false));
    for (model, falling) in [(Model::Strip, None), (Model::Strip1967Continuous, Some(&FALLING))] {
        let law = Law { model, falling };
        let ahead = rolling(5.0);
        let Velocity { forward, pitch, yaw, .. } = ahead;
        let back = Velocity { forward: -forward, pitch: -pitch, yaw: -yaw, ..ahead };
        let a = of_contacts(&wheel, &ahead, law, None).unwrap();
        let b = of_contacts(&image, &back, law, None).unwrap();
        let [fx, fy, fz, mx, my, mz] = b.members();
        let bound = 0.3 * a.normal_force;
        for (own, image) in a.members().into_iter().zip([-fx, fy, fz, mx, -my, -mz]) {
            assert!((own - image).abs() < 1e-6 * bound, "{model:?}: {own} {image}");
        }
    }
}

/// Creepages of strips that are those of a rigid motion give the forces of that motion, and so do
/// all derivatives.
#[test]
fn own_creepages_of_a_rigid_motion_are_that_motion() {
    let contacts = contacts(3e-3, false);
    let patch = &contacts[0].patch;
    let view = patch.view().unwrap();
    let whole = creep(1.2e-3, -2e-3, 0.4);
    for share in [0.0, 0.3, 1.0] {
        let rest = 1.0 - share;
        let common = creep(rest * whole.longitudinal, rest * whole.lateral, rest * whole.spin);
        let own: Vec<_> = view
            .strips()
            .iter()
            .map(|strip| {
                creep(
                    share * (whole.longitudinal - whole.spin * strip.y),
                    share * (whole.lateral + whole.spin * strip.centre_x),
                    share * whole.spin,
                )
            })
            .collect();
        let curved = view.with_own_creepages(&own).unwrap();
        for model in [Model::Strip, Model::Strip1967Continuous] {
            let [a, b] = [(&view, &whole), (&curved, &common)]
                .map(|(view, creepage)| solver::solve_patch(view, creepage, model).unwrap());
            let pairs = [(a.fx, b.fx), (a.fy, b.fy), (a.mz, b.mz), (a.power, b.power)];
            for (a, b) in pairs {
                assert!((a - b).abs() < 1e-9 * a.abs(), "{model:?} {share}: {a} {b}");
            }
            for falling in [None, Some(&SlipFriction { rolling_speed: 20.0, ..FALLING })] {
                let [a, b] = [(&view, &whole), (&curved, &common)].map(|(view, creepage)| {
                    friction::differentiate_patch(view, creepage, falling, model).unwrap()
                });
                assert!((a.friction - b.friction).abs() < 1e-9);
                let entries = |found: &Differentiated<f64>| {
                    let (of, law) = (&found.derivatives, &found.law);
                    let rows = [of.normal_force, of.load_through_hertz, of.friction];
                    let of_law = [law.ratio, law.decay, law.slope_factor, law.layer];
                    [of.jacobian.as_flattened(), rows.as_flattened(), of_law.as_flattened()]
                        .concat()
                };
                for (a, b) in entries(&a).into_iter().zip(entries(&b)) {
                    assert!((a - b).abs() < 1e-6 * (a.abs() + 1e-3), "{share}: {a} {b}");
                }
            }
        }
        assert!(solver::solve_patch(&curved, &common, Model::Total).is_err());
        assert!(view.with_own_creepages(&own[1..]).is_err());
    }
}

/// A host with places and tangents of the strips gives them their creepages, and finds the wheel's
/// wrench from their forces.
#[test]
fn a_host_that_passes_the_slip_of_each_strip_finds_the_wrench() {
    use kstrip_testing::names::*;
    let contacts = contacts(0.0, false);
    let velocity = rolling(20.0);
    let at_speed = |row: &[f64; 6]| dot(row, &rates(&velocity));
    let expected = of_contacts(&contacts, &velocity, STRIP, None).unwrap();
    let mut wrench = [0.0; 6];
    for contact in &contacts {
        let strips = &contact.patch.strips[..contact.patch.count as usize];
        let speed = at_speed(&contact.rolling_speed);
        // forward, across along the strip's tangent, about the wheel's normal
        let rows: Vec<_> = (0..strips.len())
            .map(|k| {
                let x = contact.origin[0] + strips[k].centre_x;
                let (y, z) = (contact.strip_y[k], contact.strip_z[k]);
                let (s, c) = contact.strip_angle[k].sin_cos();
                let (sin, cos) = (contact.strip_angle[k] - contact.strip_lean[k].atan()).sin_cos();
                [
                    [1.0, 0.0, 0.0, 0.0, z, -y],
                    [0.0, c, s, y * s - z * c, -x * s, x * c],
                    [0.0, 0.0, 0.0, 0.0, -sin, cos],
                ]
            })
            .collect();
        let own: Vec<_> = rows
            .iter()
            .map(|rows: &[[f64; 6]; 3]| {
                let [longitudinal, lateral, spin] = rows.map(|row| at_speed(&row) / speed);
                kstrip_creepage { longitudinal, lateral, spin }
            })
            .collect();
        let mut found: Vec<kstrip_strip> = Vec::with_capacity(64);
        let mut count = 0;
        let (strips_at, count_at) = (found.as_mut_ptr(), &raw mut count);
        let outputs =
            kstrip_outputs { strips: strips_at, count: count_at, capacity: 64, ..nowhere() };
        let rest = creep(0.0, 0.0, 0.0);
        let (patch, own) = (Some(&contact.patch), own.as_ptr());
        // SAFETY: each pointer is NULL or valid; as many creepages as strips, room for all strips.
        let found = unsafe {
            let outputs = Some(&outputs);
            let status = kstrip_patch_evaluate_strips(patch, Some(&rest), own, None, None, outputs);
            assert_eq!(status, 0);
            found.set_len(count as usize);
            found
        };
        for ((rows, strip), found) in rows.iter().zip(strips).zip(&found) {
            // the moment about the strip's own centre
            let mz = found.mz - (strip.centre_x * found.fy - strip.y * found.fx);
            let forces = [found.fx, found.fy, mz];
            for (j, sum) in wrench.iter_mut().enumerate() {
                let creep: f64 = (0..3).map(|i| rows[i][j] * forces[i]).sum();
                *sum -= contact.share * creep;
            }
        }
        for (sum, normal) in wrench.iter_mut().zip(contact.normal) {
            *sum -= contact.share * contact.normal_force * normal;
        }
    }
    for (sum, expected) in wrench.into_iter().zip(expected.members()) {
        assert!((sum - expected).abs() < 1e-5 * 0.3 * 100e3, "{sum} {expected}");
    }
}

/// Strips of every contact.
fn across(
    contacts: &[WheelContact<f64>], velocity: &Velocity<f64>, law: Law<f64>,
) -> Vec<StripPower<f64>> {
    let mut strips = vec![];
    for contact in contacts {
        power_across(contact, velocity, law, &mut |strip| strips.push(strip)).unwrap();
    }
    strips
}

/// Power and load of the strips are those of the wrench, and each strip loses power.
#[test]
fn powers_across_contacts_add_up() {
    let mut unlike = contacts(3e-3, false);
    for contact in &mut unlike {
        (contact.patch.mismatch, contact.normal_damping, contact.share) = (0.1, 0.5, 0.7);
    }
    for contacts in [contacts(3e-3, false), contacts(3e-3, true), unlike] {
        for (speed, falling) in
            [(20.0, None), (0.03, Some(&FALLING)), (0.0, None), (-4.0, Some(&FALLING))]
        {
            let (velocity, law) = (rolling(speed), Law { model: Model::Strip, falling });
            let wrench = of_contacts(&contacts, &velocity, law, None).unwrap();
            let strips = across(&contacts, &velocity, law);
            let [power, load] = strips.iter().fold([0.0; 2], |[power, load], strip| {
                assert!(strip.power >= 0.0 && strip.slip >= 0.0);
                [power + strip.power, load + strip.normal_force]
            });
            assert_relative_eq!(power, wrench.dissipation, max_relative = 1e-12);
            assert_relative_eq!(load, wrench.normal_force, max_relative = 1e-12);
            // the model without strips takes the same
            let total = Law { model: Model::Total, falling };
            assert_eq!(across(&contacts, &velocity, total), strips);
        }
    }
}

/// Where all strips slide far, the slip of each is that of the wheel's surface on the rail, and its
/// force is the coefficient of friction times the load.
#[test]
fn strips_that_slide_have_the_slip_of_the_surfaces() {
    let contacts = contacts(3e-3, false);
    let velocity = Velocity { forward: 5.0, pitch: -15.0 / 0.4191, ..Velocity::default() };
    for (contact, strip) in contacts.iter().flat_map(|contact| {
        across(std::slice::from_ref(contact), &velocity, STRIP)
            .into_iter()
            .map(move |strip| (contact, strip))
    }) {
        // the mean of slip along each strip; the radius at the strip is about that of its contact
        let expected = 15.0 * contact.radius / 0.4191 - 5.0;
        assert_relative_eq!(strip.slip, expected, max_relative = 0.05);
        let bound = 0.3 * strip.normal_force;
        assert_relative_eq!(strip.fx.hypot(strip.fy), bound, max_relative = 1e-3);
    }
}

/// The place of a strip on the wheel's profile does not change with roll, yaw and side: at y of the
/// profile the wheel has the radius of the strip.
#[test]
fn strips_lie_on_the_profile_of_the_wheel() {
    let wheel = profile("whl288");
    for contacts in [contacts(3e-3, false), contacts(3e-3, true), contacts(20e-3, false)] {
        for contact in &contacts {
            let strips = across(std::slice::from_ref(contact), &rolling(20.0), STRIP);
            for (k, strip) in strips.iter().enumerate() {
                let [x, y, z] = [
                    contact.origin[0] + contact.patch.strips[k].centre_x,
                    contact.strip_y[k],
                    contact.strip_z[k],
                ];
                // distance from the axle
                let radius = (x * x + y * y + z * z - strip.wheel_y.powi(2)).sqrt();
                let at = wheel
                    .y
                    .windows(2)
                    .position(|pair| (pair[0] - strip.wheel_y) * (pair[1] - strip.wheel_y) <= 0.0);
                let at = at.expect("the profile has the place");
                let share = (strip.wheel_y - wheel.y[at]) / (wheel.y[at + 1] - wheel.y[at]);
                let depth = wheel.z[at] + share * (wheel.z[at + 1] - wheel.z[at]);
                assert!((radius - 0.4191 - depth).abs() < 2e-5, "{radius} {depth}");
            }
        }
    }
}
