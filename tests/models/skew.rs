//! Skewed contacts, of wheels that yaw, against Hertz's solution in the principal axes.

use crate::prelude::*;
use crate::profile::pressed;
use nalgebra::Vector2;

const LOAD: f64 = 60e3;

/// The half-width of a contact and its curvatures: `h = A (x − m y)²/2 + B y²/2`.
struct Paraboloid {
    along: f64,
    across: f64,
    slope: f64,
}

impl Paraboloid {
    /// Hertz's contact under a load, `x` along the longer axis.
    fn exact(&self, load: f64) -> HertzContact<f64> {
        let Self { along, across, slope } = *self;
        let sum = along * (1.0 + slope * slope) + across;
        let root = (sum * sum - 4.0 * along * across).max(0.0).sqrt();
        let small = 2.0 * along * across / (sum + root);
        of_curvatures([small, along * across / small], load)
    }

    fn pressed(&self, given: Given<f64>) -> (Patch<f64>, Indentation<f64>) {
        let Self { along, across, slope } = *self;
        let straight = of_curvatures([along, across], 2.0 * LOAD);
        let y: Vec<f64> = (-150..=150).map(|i| f64::from(i) / 100.0 * straight.b).collect();
        let distance: Vec<f64> = y.iter().map(|y| across * y * y / 2.0).collect();
        let centre: Vec<f64> = y.iter().map(|y| slope * y).collect();
        let profile = Profile::new(&y, &distance).unwrap().with_centre_x(&centre).unwrap();
        let contact = ProfileContact { given, smoothing_length: 1e-9, ..pressed(1.0 / along, 1.0) };
        Patch::from_profile(&profile, &contact, StripCount::Sixteen).unwrap()
    }
}

fn of_curvatures([along, across]: [f64; 2], load: f64) -> HertzContact<f64> {
    hertz(&radii([FLAT, FLAT, 1.0 / along, 1.0 / across]), load, 82e9, 0.28).unwrap()
}

/// What skew changes, from pancakes to needles: pressure and approach under a load, the load at an
/// approach, and their slopes.
#[test]
fn skew_changes_a_contact_as_it_changes_that_of_hertz() {
    let mut most = [0.0_f64; 2];
    for quotient in [1e-2_f64, 0.2, 1.0, 3.0, 20.0, 150.0, 1500.0] {
        let along = 1.5 / quotient.min(1.0).sqrt();
        let straight = Paraboloid { along, across: along * quotient, slope: 0.0 };
        let exact = straight.exact(LOAD);
        let [given, approach] = [Given::Load(LOAD), Given::Approach(exact.approach)];
        let [unskewed, deep] = [given, approach].map(|given| straight.pressed(given).1);
        // the middle of the edge is so far ahead, in half lengths of the middle strip
        for share in [0.03, 0.1, 0.3, 0.7, 1.5] {
            let ratio = exact.a / exact.b;
            let slope = share * if quotient < 1.0 { 1.0 / ratio } else { ratio };
            let skewed = Paraboloid { slope, ..straight };
            let (there, (patch, found)) = (skewed.exact(LOAD), skewed.pressed(given));
            assert!((patch.view().unwrap().normal_force() / LOAD - 1.0).abs() < 1e-12);
            let (_, under) = skewed.pressed(approach);
            // what skew changes, and what it should
            let changes = [
                (
                    found.peak_pressure / unskewed.peak_pressure,
                    there.peak_pressure / exact.peak_pressure,
                ),
                (found.approach / unskewed.approach, there.approach / exact.approach),
                // N ~ δ^(3/2)
                (
                    under.normal_force / deep.normal_force,
                    (exact.approach / there.approach).powf(1.5),
                ),
            ];
            let offs = changes.map(|(found, exact)| (found - exact).abs() / (exact - 1.0).abs());
            println!("{quotient} {share}: {changes:.4?}, off by {offs:.4?} of the change");
            let bound = if quotient > 1000.0 { 0.16 } else { 0.04 };
            let far =
                |(off, (_, exact)): (f64, (f64, f64))| off > bound && (exact - 1.0).abs() > 1e-4;
            assert!(!offs.into_iter().zip(changes).any(far), "{quotient} {share} {changes:?}");
            // both slopes are those of what is computed
            let around = |factor: f64| skewed.pressed(Given::Approach(exact.approach * factor)).1;
            let by_approach = around(1.0 + 1e-4).normal_force - around(1.0 - 1e-4).normal_force;
            let around = |factor: f64| skewed.pressed(Given::Load(LOAD * factor)).1;
            let by_load = around(1.0 + 1e-4).approach - around(1.0 - 1e-4).approach;
            let offs = [
                under.stiffness * 2e-4 * exact.approach / by_approach - 1.0,
                found.stiffness * by_load / (2e-4 * LOAD) - 1.0,
            ];
            most.iter_mut().zip(offs).for_each(|(most, off)| *most = most.max(off.abs()));
        }
    }
    println!("stiffness: {:.1e}, {:.1e}", most[0], most[1]);
    assert!(most.iter().all(|most| *most < 1e-6), "{most:?}");
}

/// Without a change of the place along `x` nothing changes, to the bit; with a small one it is of
/// the second order.
#[test]
fn contacts_without_skew_keep_their_bits() {
    let y: Vec<f64> = (-40..=40).map(|i| f64::from(i) * 0.3e-3).collect();
    let distance: Vec<f64> = y.iter().map(|y| 3.0 * y * y + 1e4 * y.powi(4)).collect();
    let contact = ProfileContact { given: Given::Approach(80e-6), ..pressed(0.5, 1.0) };
    let of = |profile: &Profile<f64>| {
        Patch::<f64>::from_profile(profile, &contact, StripCount::Sixteen).unwrap()
    };
    let pressed = |slope: f64| {
        let centre: Vec<f64> = y.iter().map(|y| 1e-3 + slope * y).collect();
        of(&Profile::new(&y, &distance).unwrap().with_centre_x(&centre).unwrap())
    };
    let ((patch, found), (almost, near)) = (pressed(0.0), pressed(1e-9));
    let (plain, unskewed) = of(&Profile::new(&y, &distance).unwrap());
    assert_eq!(found, unskewed);
    let strips = |patch: &Patch<f64>| patch.view().unwrap().strips().to_vec();
    for ((strip, plain), almost) in strips(&patch).iter().zip(strips(&plain)).zip(strips(&almost)) {
        assert_eq!(strip.centre_x, 1e-3);
        assert_eq!(kstrip::patch::PatchStrip { centre_x: 0.0, ..*strip }, plain);
        assert!((almost.peak_pressure / plain.peak_pressure - 1.0).abs() < 1e-14);
    }
    assert!((near.normal_force / found.normal_force - 1.0).abs() < 1e-14);
    // and a larger one has less than a step's share of curvature
    let loads: Vec<f64> = (-60..=60).map(|i| pressed(f64::from(i) * 0.01).1.normal_force).collect();
    let bends = loads.windows(3).map(|w| (w[0] - 2.0 * w[1] + w[2]).abs() / w[1]);
    let most = bends.fold(0.0, f64::max);
    assert!(most < 1e-4, "{most}");
}

/// A wheel with a hollow arc that yaws over a rail's round edge, without profiles: the distance of
/// a point of the wheel from the rail, by the angle of its profile and that around the axle.
struct Arch {
    rail: f64,
    wheel: f64,
    radius: f64,
    position: Position<f64>,
}

impl Arch {
    fn place(&self, at: &Vector2<f64>) -> [f64; 3] {
        let Position { lateral, vertical, yaw, .. } = self.position;
        let (y, z) = (self.wheel * at.x.sin(), self.wheel * (1.0 - at.x.cos()));
        let (ahead, below) = ((self.radius + z) * at.y.sin(), (self.radius + z) * at.y.cos());
        let (sine, cosine) = yaw.sin_cos();
        let across = ahead * sine + y * cosine + lateral;
        [ahead * cosine - y * sine, across, below - self.radius + vertical]
    }

    fn distance(&self, at: &Vector2<f64>) -> f64 {
        let [_, y, z] = self.place(at);
        y.hypot(z - self.rail) - self.rail
    }

    /// Length along `x` and on the rail's surface.
    fn on_rail(&self, at: &Vector2<f64>) -> Vector2<f64> {
        let [x, y, z] = self.place(at);
        Vector2::new(x, self.rail * y.atan2(self.rail - z))
    }

    /// Least distance and the curvatures there, in the plane of the contact.
    fn least(&self, start: f64) -> (f64, Matrix2<f64>) {
        let step = 1e-4;
        let ways = [Vector2::new(step, 0.0), Vector2::new(0.0, step)];
        let mut at = Vector2::new(start, 0.0);
        let second = |at: &Vector2<f64>| {
            Matrix2::from_fn(|i, k| {
                let corner = |a: f64, b: f64| self.distance(&(at + ways[i] * a + ways[k] * b));
                let sum = corner(1.0, 1.0) - corner(1.0, -1.0) - corner(-1.0, 1.0);
                (sum + corner(-1.0, -1.0)) / (4.0 * step * step)
            })
        };
        for _ in 0..40 {
            let slope = Vector2::from_fn(|i, _| {
                (self.distance(&(at + ways[i])) - self.distance(&(at - ways[i]))) / (2.0 * step)
            });
            let moved = second(&at).try_inverse().unwrap() * slope;
            at -= moved.map(|x| x.clamp(-0.05, 0.05));
        }
        let columns =
            ways.map(|way| (self.on_rail(&(at + way)) - self.on_rail(&(at - way))) / (2.0 * step));
        let inverse = Matrix2::from_columns(&columns).try_inverse().unwrap();
        (self.distance(&at), inverse.transpose() * second(&at) * inverse)
    }
}

/// A round rail edge under a hollow wheel that yaws: at the overlap that the surfaces have the load
/// does not depend on the yaw any more than that of Hertz, and pressures under the load are his.
#[test]
fn yawed_wheels_press_as_the_principal_curvatures_say() {
    let arc = |radius: f64| {
        let angles: Vec<f64> = (-800..=600).map(|i| f64::from(i) * 1e-3 * 1.75).collect();
        let y: Vec<f64> = angles.iter().map(|angle| radius * angle.sin()).collect();
        let z: Vec<f64> = angles.iter().map(|angle| radius * (1.0 - angle.cos())).collect();
        prepared(&y, &z)
    };
    let (mut loads, mut pressures) = (vec![], vec![]);
    for (rail, wheel, angle) in [(0.0133, 0.02, 0.87), (0.013, 0.03, 1.13), (0.08, 0.3, 1.13)] {
        let mut stand = Stand::new(arc(rail), arc(wheel), 0.46);
        let mut of_unyawed = [1.0; 2];
        for yaw in [0.0, 0.006, -0.012, 0.018] {
            let lateral = (wheel - rail) * f64::sin(angle);
            let vertical = -(wheel - rail) * (1.0 - angle.cos());
            let position = Position { lateral, vertical, yaw, ..Position::default() };
            let mut arch = Arch { rail, wheel, radius: 0.46, position };
            for _ in 0..60 {
                let (least, _) = arch.least(-angle);
                arch.position.vertical += (least + 50e-6) / angle.cos() * 0.5;
            }
            let (least, curvatures) = arch.least(-angle);
            stand.solve(&arch.position, &ROLLING);
            let [contact] = stand.memory.found() else { panic!("{rail} {yaw}: one contact") };
            let turned = curvatures.symmetric_eigenvalues();
            let exact = |load| of_curvatures([turned.min(), turned.max()], load);
            // N ~ δ^(3/2)
            let load = LOAD * (-least / exact(LOAD).approach).powf(1.5);
            let strips = contact.patch.used().iter().map(|strip| strip.peak_pressure);
            let peak = strips.fold(0.0, f64::max);
            let found =
                [contact.normal_force / load, peak / exact(contact.normal_force).peak_pressure];
            if yaw == 0.0 {
                of_unyawed = found;
            }
            println!("{rail} {yaw}: load {:.4}, pressure {:.4}", found[0], found[1]);
            loads.push((found[0] / of_unyawed[0] - 1.0).abs());
            pressures.push((found[1] - 1.0).abs());
        }
    }
    let most = |list: &[f64]| list.iter().copied().fold(0.0, f64::max);
    assert!(most(&loads) < 5e-3, "{loads:?}");
    assert!(most(&pressures) < 0.01, "{pressures:?}");
}
