//! Every load that a wheel can carry has a height: in a groove that is as round as the wheel, from
//! the smallest loads on, in both precisions.

use crate::prelude::*;
use kstrip::wheel_rail::scene::TableSource;
use std::cell::Cell;
use std::sync::OnceLock;

/// A surface with given points.
fn surface<F: Float>(points: impl Iterator<Item = [f64; 2]>) -> Box<PreparedProfile<F>> {
    let (y, z): (Vec<F>, Vec<F>) = points.map(|[y, z]| (F::of(y), F::of(z))).unzip();
    let mut surface = zeroed::<PreparedProfile<F>>();
    surface.prepare(&y, &z, F::zero(), F::zero()).unwrap();
    surface
}

/// An arc of a circle around the z axis whose lowest point is at z = 0, at points that are 0.1 mm
/// apart; level beyond the circle.
fn groove(radius: f64, half: i32) -> impl Iterator<Item = [f64; 2]> {
    (-half..=half).map(move |k| {
        let y = f64::from(k) * 1e-4;
        [y, (radius * radius - y * y).max(0.0).sqrt() - radius]
    })
}

/// The height of a load, what the rail carries there, and the stiffness of the contacts.
fn carried<F: Float>(
    [rail, wheel]: [&PreparedProfile<F>; 2], pair: &WheelPair<F>, place: [f64; 2], load: f64,
    memory: &mut Workspace<F>,
) -> (F, F, F) {
    let law = Law { model: Model::Strip, falling: None };
    let scene = Scene { rail, wheel, pair, strips: StripCount::Sixteen, law, table: None };
    let [lateral, vertical] = place.map(F::of);
    let position = Position { lateral, vertical, ..Position::default() };
    let (height, warning) = scene.height_for_load(&position, F::of(load), None, memory).unwrap();
    assert_ne!(warning, Warning::NotConverged, "{place:?} {load}");
    let (mut sum, mut stiffness) = (F::zero(), F::zero());
    for contact in memory.found() {
        sum += contact.share * contact.normal_force * contact.normal[2];
        stiffness += contact.share * contact.stiffness;
    }
    (height, sum, stiffness)
}

/// A ball of 10 mm in grooves that are 0.2 to 3 per cent larger. The lips of some grooves are
/// so steep that the ball, lowered from above, would meet them first.
#[test]
fn a_ball_in_a_groove_has_a_height_for_each_load() {
    let wheel = surface::<f64>(groove(10e-3, 99));
    let pair = steel(0.42);
    let mut memory = zeroed();
    for hundredths in 2..30 {
        let radius = 10e-3 + 1e-5 * f64::from(hundredths);
        let rail = surface(groove(radius, (2e4 * radius).round() as i32));
        let mut before = -1e-6;
        for load in [10.0, 100.0, 1e3, 10e3] {
            let (height, sum, _) = carried([&rail, &wheel], &pair, [0.0; 2], load, &mut memory);
            assert_relative_eq!(sum, load, max_relative = 1e-9);
            assert!(height > before && height < 40e-6, "{radius} {load} {height}");
            before = height;
        }
    }
}

fn loads_are_carried<F: Float>(rounding: f64) {
    let [rail, wheel] = ["uic60", "s1002"].map(|name| {
        let [y, z] = points(name);
        surface::<F>(y.into_iter().zip(z).map(|(y, z)| [y, z]))
    });
    let pair = WheelPair {
        wheel_radius: F::of(0.46),
        shear_modulus: F::of(82e9),
        poisson_ratio: F::of(0.28),
        friction: F::of(0.3),
        ..*zeroed()
    };
    let mut memory = zeroed();
    for load in [1.0, 10.0, 1e2, 1e3, 1e4, 1e5] {
        for k in 0..24 {
            let place = [-8e-3 + 2.5e-4 * f64::from(k), 1e-3 * f64::from(k - 12)];
            let found = carried([&rail, &wheel], &pair, place, load, &mut memory);
            let [sum, stiffness] = [found.1, found.2].map(Float::to_f64);
            // a rounding of the height, or of the sum
            let accurate = stiffness * rounding + load * F::EPSILON.to_f64().powf(2.0 / 3.0) * 2.0;
            assert!((sum - load).abs() <= accurate, "{load} {place:?} {sum}");
        }
    }
}

/// The force is that of a height that is rounded like the points of the profiles.
#[test]
fn loads_from_one_newton_on_have_heights() {
    loads_are_carried::<f64>(1e-15);
    loads_are_carried::<f32>(20e-9);
}

thread_local! {
    static EVALUATIONS: Cell<usize> = const { Cell::new(0) };
}

/// A wheel S1002 over a rail UIC60.
fn counted_scene(pair: &WheelPair<f64>) -> Scene<'_, f64> {
    static PROFILES: OnceLock<[Box<PreparedProfile<f64>>; 2]> = OnceLock::new();
    let [rail, wheel] = PROFILES.get_or_init(|| {
        ["uic60", "s1002"].map(|name| {
            let [y, z] = points(name);
            surface(y.into_iter().zip(z).map(|(y, z)| [y, z]))
        })
    });
    let law = Law { model: Model::Strip, falling: None };
    Scene { rail, wheel, pair, strips: StripCount::Sixteen, law, table: None }
}

/// The contacts of a position, as a table would give them, and a count of these calls.
fn counted_contacts(
    _: &[u8], pair: &WheelPair<f64>, position: &Position<f64>, memory: &mut Workspace<f64>,
) -> Result<Warning, Error> {
    EVALUATIONS.with(|count| count.set(count.get() + 1));
    counted_scene(pair).place(position, memory)
}

/// From the tread to the flange, with yaw and without, from 1 to 100 kN: evaluations of contacts
/// for a height.
#[test]
fn a_height_takes_few_evaluations() {
    let pair = steel(0.46);
    let table = TableSource {
        bytes: &[],
        only: true,
        find: counted_contacts,
        solve: |_, _, _, _, _| Err(Error::Table),
    };
    let scene = Scene { table: Some(table), ..counted_scene(&pair) };
    let (mut memory, mut counts) = (zeroed(), vec![]);
    for k in 0..150 {
        for load in [1e3, 1e4, 1e5] {
            let lateral = -18e-3 + 1e-4 * f64::from(k);
            let yaw = 4e-3 * f64::from(k % 3);
            let position = Position { lateral, yaw, ..Position::default() };
            EVALUATIONS.with(|count| count.set(0));
            scene.height_for_load(&position, load, None, &mut memory).unwrap();
            counts.push(EVALUATIONS.with(Cell::get));
        }
    }
    counts.sort_unstable();
    let [median, most] = [counts[counts.len() / 2], counts[counts.len() - 1]];
    println!("evaluations: {median} in the median, {most} at most");
    assert!(counts[0] > 0 && median <= 4 && most <= 6, "{counts:?}");
}
