//! Wheel on rail: profiles that are mostly round, positions near contact, contacts with any
//! changes.

use super::super::*;
use super::contacts::friction_of;
use super::*;
use crate::manchester::zeroed;

const POINTS: usize = 24;

/// The status of a batch is that of its first bad element, or one of all of them.
fn is_first_bad(status: i32, statuses: &[i32]) {
    let bad = statuses.iter().find(|status| **status < 0);
    assert!(bad.map_or(statuses.contains(&status), |bad| *bad == status));
}

/// An element of a batch with its status is that of a single call.
fn is_that_of<T: Copy + PartialEq + std::fmt::Debug>(
    (own, out): (i32, &MaybeUninit<T>), (expected, single): (i32, &MaybeUninit<T>),
) {
    assert_eq!(own, expected);
    if own < 0 {
        assert!(untouched(out));
    } else {
        assert_eq!(written(out), written(single));
    }
}

/// Points of an arc of about 20 mm, some of them moved.
fn points(bytes: &mut Bytes, radius: f64) -> ([Float; POINTS], [Float; POINTS]) {
    let (mut y, mut z): ([Float; POINTS], [Float; POINTS]) = Default::default();
    for i in 0..POINTS {
        let s = (i as f64 - 11.5) * 1.8e-3;
        y[i] = s as Float;
        z[i] = (s * s / (2.0 * radius)) as Float;
    }
    if bytes.byte() < 48 {
        y[bytes.below(POINTS)] = Number::of(bytes, 1e-2);
        z[bytes.below(POINTS)] = Number::of(bytes, 1e-4);
    }
    (y, z)
}

fn prepare(bytes: &mut Bytes, radius: f64, surface: Option<&mut kstrip_surface>) -> i32 {
    let (y, z) = points(bytes, radius);
    let count = if bytes.byte() < 16 { bytes.below(POINTS + 1) } else { POINTS };
    let length = |bytes: &mut Bytes| if bytes.byte() < 192 { 0.0 } else { positive(bytes, 2e-3) };
    let (step, smoothing) = (length(bytes), length(bytes));
    let given = bytes.given();
    // SAFETY: NULL or at least as many points as the count says.
    unsafe {
        let (y, z) = (given.array(0, &y), given.array(1, &z));
        kstrip_prepare_profile(y, z, count as u32, step, smoothing, surface)
    }
}

fn prepare_profile(bytes: &mut Bytes) {
    let mut surface = zeroed::<kstrip_surface>();
    let radius = f64::from(positive::<Float>(bytes, 0.3));
    let with = bytes.byte() >= 16;
    let status = prepare(bytes, radius, with.then_some(&mut surface));
    if answered(status, surface.count == 0 && surface.step == 0.0) {
        assert!(with && (4..=512).contains(&surface.count), "{}", surface.count);
        let count = surface.count as usize;
        let lists = [&surface.y, &surface.z, &surface.cosine, &surface.sine];
        assert!(lists.iter().all(|list| finite(&list[..count])) && surface.step > 0.0);
    }
}

/// Files of each format.
const FILES: [&str; 4] = [
    "header.begin\n type=1\nheader.end\nspline.begin\n units.len.f=1000.\n rotate=0.1\n \
     point.begin\n\
     -30 9\n-20 4.5 1\n-10 1\n0 0\n10 1 0.5\n20 4\n30 9\n point.end\nspline.end\n",
    "Filename=a\nXYPoints=7\nColumnDef=X,Y\n\n-30 9\n-20 4\n\"-10 1\n0 0\n10 1\n20 4\n30 9\n",
    "[Profile1Info]\nMPDC=3\nMPD1=L -30 9 -10 1\nMPD2=L -10 1 10 1\nMPD3=L 10 1 30 9\n",
    "nr;y [mm];z [mm]\n1;-30,0;9,0\n2;-20;4\n3;-10;1\n4;0;0\n5;10;1\n6;20;4\n7;30;9\nEND\n",
];

fn read_profile(bytes: &mut Bytes) {
    let mut text = FILES[bytes.below(4)].as_bytes().to_vec();
    for _ in 0..bytes.below(6) {
        let at = bytes.below(256).min(text.len());
        match bytes.below(4) {
            0 if bytes.byte() < 64 => text.truncate(at),
            1 => text.insert(at, bytes.byte()),
            _ if at < text.len() => text[at] = b"0123456789.,;eD-+ \n\"=[]\0"[bytes.below(24)],
            _ => (),
        }
    }
    let capacity = if bytes.byte() < 32 { bytes.below(POINTS + 1) } else { POINTS };
    let format = if bytes.byte() < 32 { u32::from(bytes.byte()) } else { 0 };
    let (mut y, mut z) = (poisoned_array::<Float, POINTS>(), poisoned_array::<Float, POINTS>());
    let (mut count, mut notes) = (poisoned::<u32>(), poisoned::<u32>());
    let given = bytes.given();
    // SAFETY: NULL or as many elements as said.
    let status = unsafe {
        let (text, length) = (given.array(0, &text).cast(), text.len() as u32);
        let (y, z) = (given.places(1, &mut y), given.places(2, &mut z));
        let (count, notes) = (given.output(3, &mut count), given.output(4, &mut notes));
        kstrip_read_profile(text, length, format, y, z, capacity as u32, count, notes)
    };
    let all = all_untouched(&y) && all_untouched(&z) && untouched(&count) && untouched(&notes);
    if answered(status, all) {
        let count = written(&count) as usize;
        assert!((4..=capacity).contains(&count), "{count}");
        let points =
            |list: &[MaybeUninit<Float>]| list[..count].iter().map(written).collect::<Vec<_>>();
        assert!(finite(&points(&y)) && finite(&points(&z)));
        assert!(all_untouched(&y[count..]) && all_untouched(&z[count..]));
    }
}

fn orient_profiles(bytes: &mut Bytes) {
    let counts = [0, 0].map(|_: u32| bytes.below(POINTS / 2) as u32);
    let all = counts.iter().sum::<u32>() as usize;
    let scale: Float = Number::of(bytes, 30.0);
    let at = |k: usize| k as Float / 50.0 - 1.0;
    let mut points = [1, 2].map(|power| (0..all).map(|k| scale * at(k).powi(power)).collect());
    if all > 0 && bytes.byte() < 64 {
        points
            .iter_mut()
            .for_each(|list: &mut Vec<_>| list[bytes.below(all)] = Number::of(bytes, 1.0));
    }
    let format = if bytes.byte() < 64 { u32::from(bytes.byte()) } else { 0 };
    let unit: Float = if bytes.byte() < 128 { Number::of(bytes, 1e-3) } else { 0.0 };
    let (mut y, mut z) = (poisoned_array::<Float, POINTS>(), poisoned_array::<Float, POINTS>());
    let (mut taken, mut notes) = (poisoned::<Float>(), poisoned::<u32>());
    let given = bytes.given();
    // SAFETY: NULL or as many elements as said.
    let status = unsafe {
        let [given_y, given_z] = [(0, &points[0]), (1, &points[1])].map(|(k, x)| given.array(k, x));
        let counts = given.array(2, &counts);
        let (y, z) = (given.places(3, &mut y), given.places(4, &mut z));
        let (taken, notes) = (given.output(5, &mut taken), given.output(6, &mut notes));
        kstrip_orient_profiles(given_y, given_z, counts, 2, format, unit, y, z, taken, notes)
    };
    let untouched =
        all_untouched(&y) && all_untouched(&z) && untouched(&taken) && untouched(&notes);
    if answered(status, untouched) {
        let turned =
            |list: &[MaybeUninit<Float>]| list[..all].iter().map(written).collect::<Vec<_>>();
        assert!(finite(&turned(&y)) && finite(&turned(&z)));
        assert!(all_untouched(&y[all..]) && all_untouched(&z[all..]));
    }
}

fn profile_between(bytes: &mut Bytes) {
    let (mut first, mut second) = (zeroed::<kstrip_surface>(), zeroed::<kstrip_surface>());
    prepare(bytes, 0.3, Some(&mut first));
    prepare(bytes, 0.4, Some(&mut second));
    let share: Float = if bytes.byte() < 48 { Number::of(bytes, 0.1) } else { 0.25 };
    let given = bytes.given();
    let mut between = zeroed::<kstrip_surface>();
    // SAFETY: NULL or a profile.
    let status = unsafe {
        let place: *mut kstrip_surface =
            if given.has(2) { &raw mut *between } else { std::ptr::null_mut() };
        let [first, second] = [(0, &*first), (1, &*second)].map(|(k, profile)| {
            if given.has(k) { std::ptr::from_ref(profile) } else { std::ptr::null() }
        });
        kstrip_profile_between(first, second, share, place)
    };
    if answered(status, between.count == 0 && between.step == 0.0) {
        let count = between.count as usize;
        assert!(given.all(3) && (4..=512).contains(&count), "{count}");
        assert!(finite(&between.y[..count]) && finite(&between.z[..count]));
    }
}

/// A wheel over a rail as a program may have it.
pub struct Scene {
    pub rail: Box<kstrip_surface>,
    pub wheel: Box<kstrip_surface>,
    pub pair: kstrip_wheel_pair,
    pub position: kstrip_wheel_position,
    pub velocity: kstrip_wheel_velocity,
}

impl Scene {
    pub fn new(bytes: &mut Bytes) -> Self {
        let (mut rail, mut wheel) = (zeroed::<kstrip_surface>(), zeroed::<kstrip_surface>());
        prepare(bytes, 0.3, Some(&mut rail));
        prepare(bytes, -0.5, Some(&mut wheel));
        if bytes.byte() < 16 {
            wheel.count = bytes.integer() as u32;
            rail.y[bytes.below(100)] = Number::of(bytes, 1e-2);
        }
        let mut any = |scale: f64| -> Float { Number::of(bytes, scale) };
        let pair = kstrip_wheel_pair {
            wheel_radius: 0.46,
            shear_modulus: any(82e9).abs(),
            poisson_ratio: 0.28,
            friction: any(0.3).abs(),
            friction_y: [-5e-3, 0.0, 5e-3, any(1e-2)],
            friction_at: [0.1, any(0.3).abs(), 0.3, 0.4],
            ..*zeroed()
        };
        let [lateral, vertical, yaw, roll] = [1e-3, 1e-4, 1e-2, 1e-2].map(&mut any);
        let position = kstrip_wheel_position { lateral, vertical, yaw, roll };
        let rates = [20.0, 0.1, 0.01, 0.1, 43.0, 0.1].map(any);
        let [forward, lateral, vertical, roll, pitch, yaw] = rates;
        let velocity = kstrip_wheel_velocity { forward, lateral, vertical, roll, pitch, yaw };
        let mut scene = Self { rail, wheel, pair, position, velocity };
        let choice = bytes.byte();
        scene.pair.left = i32::from(choice % 2);
        scene.pair.friction_points = u32::from(choice / 2 % 8);
        scene.pair.strips = bytes.strips();
        if bytes.byte() < 64 {
            scene.pair.normal_damping = Number::of(bytes, 0.5);
            scene.pair.floor_speed = Number::of(bytes, 0.1);
        }
        if bytes.byte() < 64 {
            scene.pair.rail_radius = Number::of(bytes, 1.0);
            scene.pair.rail_ahead = Number::of(bytes, 0.05);
            scene.pair.rail_speed = Number::of(bytes, 20.0);
        }
        scene.pair.model = if choice < 128 { 0 } else { i32::from(choice % 7) };
        scene
    }
}

fn touch(bytes: &mut Bytes) {
    let (scene, given) = (Scene::new(bytes), bytes.given());
    let (mut gap, mut least) = (zeroed::<kstrip_gap>(), poisoned::<Float>());
    let reach = if bytes.byte() < 192 { 0.0 } else { Number::of(bytes, 1e-3) };
    let status = kstrip_touch(
        given.input(0, &scene.rail),
        given.input(1, &scene.wheel),
        scene.pair.wheel_radius,
        given.input(2, &scene.position),
        reach,
        given.has(3).then_some(&mut gap),
        given.output(4, &mut least),
    );
    if answered(status, untouched(&least) && gap.along.iter().all(|&along| along == 0.0)) {
        assert!(given.all(4));
        let along = &gap.along[..gap.count as usize];
        assert!(along.windows(2).all(|pair| pair[0] < pair[1]), "{along:?}");
    }
}

/// The contacts of a gap that may have been changed, and how many there are.
fn contacts(bytes: &mut Bytes, scene: &Scene) -> Option<(Box<[kstrip_wheel_contact; 6]>, u32)> {
    let (mut gap, mut strips) = (zeroed::<kstrip_gap>(), zeroed::<kstrip_patch>());
    let (rail, wheel, radius) = (&scene.rail, &scene.wheel, scene.pair.wheel_radius);
    kstrip_touch(Some(rail), Some(wheel), radius, Some(&scene.position), 0.0, Some(&mut gap), None);
    match bytes.byte() {
        0..=15 => gap.along[bytes.below(200)] = Number::of(bytes, 1e-2),
        16..=31 => gap.angle[bytes.below(200)] = Number::of(bytes, 1.0),
        32..=47 => gap.x[bytes.below(200)] = Number::of(bytes, 1e-2),
        48..=55 => gap.count = bytes.integer() as u32,
        _ => {}
    }
    let given = bytes.given();
    let (mut found, mut count) = (zeroed::<[kstrip_wheel_contact; 6]>(), poisoned::<u32>());
    // SAFETY: NULL or six elements.
    let status = unsafe {
        kstrip_contacts_from_gap(
            given.input(0, &gap),
            given.input(1, &scene.pair),
            given.input(2, &scene.position),
            given.has(3).then_some(&mut strips),
            if given.has(4) { found.as_mut_ptr() } else { std::ptr::null_mut() },
            given.output(5, &mut count),
        )
    };
    if !answered(status, untouched(&count)) {
        return None;
    }
    let count = written(&count);
    for contact in &found[..count as usize] {
        let rows = [contact.slip_x, contact.slip_y, contact.spin_rate, contact.normal];
        let rows = rows.iter().flatten().chain(&contact.rolling_speed);
        assert!(rows.into_iter().all(|x| x.is_finite()), "{contact:?}");
        let (load, share) = (contact.normal_force, contact.share);
        assert!(load >= 0.0 && (0.0..=1.0).contains(&share), "{load} N, share {share}");
    }
    Some((found, count))
}

fn contacts_from_gap(bytes: &mut Bytes) {
    let scene = Scene::new(bytes);
    contacts(bytes, &scene);
}

fn motion(bytes: &mut Bytes) {
    let scene = Scene::new(bytes);
    let Some((mut contacts, _)) = contacts(bytes, &scene) else { return };
    if bytes.byte() < 64 {
        contacts[0].slip_x[bytes.below(6)] = Number::of(bytes, 1.0);
    }
    let answer = asked::<kstrip_motion>(bytes, 2, |given, out| {
        kstrip_wheel_motion(given.input(0, &contacts[0]), given.input(1, &scene.velocity), out)
    });
    if let Some((_, m)) = answer {
        assert!(finite(&[m.slip_x, m.slip_y, m.spin_rate, m.rolling_speed]), "{m:?}");
    }
}

/// What holds for a wrench: nothing of a lifted wheel, no energy gained.
pub fn plausible(wrench: &kstrip_wrench, status: i32) {
    assert_eq!(wrench.warning.code(), status);
    assert!(finite(&wrench.members()) && finite(&[wrench.dissipation, wrench.normal_force]));
    if wrench.contacts == 0 {
        assert_eq!((wrench.force, wrench.moment), ([0.0; 3], [0.0; 3]));
    }
}

fn wrench_from_contacts(bytes: &mut Bytes) {
    let scene = Scene::new(bytes);
    let Some((mut contacts, mut count)) = contacts(bytes, &scene) else { return };
    match bytes.byte() {
        0..=15 => contacts[0].share = Number::of(bytes, 1.0),
        16..=31 => contacts[0].patch.strips[0].y = Number::of(bytes, 1e-2),
        32..=39 => count = u32::from(bytes.byte() % 7),
        _ => {}
    }
    let (law, with_law, given) = (friction_of(bytes), bytes.byte() < 128, bytes.given());
    let (mut out, mut slopes) = (poisoned::<kstrip_wrench>(), poisoned());
    // SAFETY: NULL or six elements.
    let status = unsafe {
        kstrip_wrench_from_contacts(
            given.array(0, contacts.as_slice()),
            count,
            given.input(1, &scene.velocity),
            scene.pair.model,
            with_law.then_some(&law),
            given.output(2, &mut out),
            given.output(3, &mut slopes),
        )
    };
    if answered(status, untouched(&out) && untouched::<kstrip_wrench_derivatives>(&slopes)) {
        plausible(&written(&out), status);
    }
}

/// The loads and powers of strips are finite, and loads are not negative.
fn contact_power_across(bytes: &mut Bytes) {
    let scene = Scene::new(bytes);
    let Some((mut contacts, _)) = contacts(bytes, &scene) else { return };
    match bytes.byte() {
        0..=15 => contacts[0].share = Number::of(bytes, 1.0),
        16..=31 => contacts[0].strip_y[0] = Number::of(bytes, 1e-2),
        _ => {}
    }
    let capacity = if bytes.byte() < 16 { 3 } else { kstrip::patch::KSTRIP_PATCH_CAPACITY };
    let (law, with_law, given) = (friction_of(bytes), bytes.byte() < 128, bytes.given());
    let mut strips =
        poisoned_array::<kstrip_strip_power, { kstrip::patch::KSTRIP_PATCH_CAPACITY }>();
    let mut count = poisoned::<u32>();
    // SAFETY: NULL or as many elements as the capacity says.
    let status = unsafe {
        kstrip_contact_power_across(
            given.input(0, &contacts[0]),
            given.input(1, &scene.velocity),
            scene.pair.model,
            with_law.then_some(&law),
            given.places(2, &mut strips),
            capacity as u32,
            given.output(3, &mut count),
        )
    };
    if answered(status, untouched(&count) && all_untouched(&strips)) {
        assert!(given.all(4));
        for strip in &strips[..written(&count) as usize] {
            let kstrip_strip_power { wheel_y, normal_force, fx, fy, slip, power, .. } =
                written(strip);
            assert!(finite(&[wheel_y, normal_force, fx, fy, slip, power]) && normal_force >= 0.0);
        }
    }
}

/// Three wheels, of which the second may be another: their results are those of single calls.
fn wheels_on_rails(bytes: &mut Bytes) {
    let scene = Scene::new(bytes);
    let (law, with_law, given) = (friction_of(bytes), bytes.byte() < 64, bytes.given());
    let mut places = [scene.position; 3];
    places[1].lateral = Number::of(bytes, 5e-3);
    let mut memory = zeroed::<kstrip_wheel_workspace>();
    let mut outs: [_; 3] = std::array::from_fn(|_| poisoned::<kstrip_wrench>());
    let mut statuses = [77; 3];
    let stride = size_of::<kstrip_wheel_position>() as u32;
    let mut met = zeroed::<[kstrip_wheel_contact; 6]>();
    let room = if bytes.byte() < 16 { 7 } else { 2 };
    // SAFETY: NULL, or one element, or three; and two contacts for each.
    let status = unsafe {
        kstrip_wheels_on_rails(
            given.input(0, &scene.rail),
            given.input(1, &scene.wheel),
            3,
            &raw const scene.pair,
            0,
            given.array(2, &places),
            if bytes.byte() < 16 { stride + 1 } else { stride },
            &raw const scene.velocity,
            0,
            if with_law { &raw const law } else { std::ptr::null() },
            0,
            None,
            given.has(3).then_some(&mut memory),
            outs.as_mut_ptr().cast(),
            std::ptr::null_mut(),
            std::ptr::null_mut(),
            met.as_mut_ptr(),
            room,
            statuses.as_mut_ptr(),
        )
    };
    if statuses == [77; 3] {
        assert!(status < 0 && outs.iter().all(untouched));
        return;
    }
    for (i, ((place, out), own)) in places.iter().zip(&outs).zip(statuses).enumerate() {
        let mut single = poisoned::<kstrip_wrench>();
        let expected = kstrip_wheel_on_rail(
            Some(&scene.rail),
            Some(&scene.wheel),
            Some(&scene.pair),
            Some(place),
            Some(&scene.velocity),
            with_law.then_some(&law),
            Some(&mut memory),
            Some(&mut single),
            None,
            None,
        );
        is_that_of((own, out), (expected, &single));
        if own >= 0 {
            let count = (memory.count as usize).min(2);
            let loads = |contacts: &[kstrip_wheel_contact]| -> Vec<Float> {
                contacts[..count].iter().map(|contact| contact.normal_force).collect()
            };
            assert_eq!(loads(&met[2 * i..]), loads(&memory.contacts));
        }
    }
    is_first_bad(status, &statuses);
}

fn wheel_on_rail(bytes: &mut Bytes) {
    let scene = Scene::new(bytes);
    let (law, with_law, given) = (friction_of(bytes), bytes.byte() < 64, bytes.given());
    let mut memory = zeroed::<kstrip_wheel_workspace>();
    let (mut out, mut slopes, mut moved) = (poisoned::<kstrip_wrench>(), poisoned(), poisoned());
    let wanted = bytes.byte();
    let status = kstrip_wheel_on_rail(
        given.input(0, &scene.rail),
        given.input(1, &scene.wheel),
        given.input(2, &scene.pair),
        given.input(3, &scene.position),
        given.input(4, &scene.velocity),
        with_law.then_some(&law),
        given.has(5).then_some(&mut memory),
        given.output(6, &mut out),
        (wanted < 32).then_some(&mut slopes),
        (wanted < 8).then_some(&mut moved),
    );
    let slopes_untouched = untouched::<kstrip_wrench_derivatives>(&slopes)
        && untouched::<kstrip_wrench_by_position>(&moved);
    if answered(status, untouched(&out) && slopes_untouched) {
        plausible(&written(&out), status);
    }
}

fn height_for_load(bytes: &mut Bytes) {
    let (scene, given) = (Scene::new(bytes), bytes.given());
    let mut memory = zeroed::<kstrip_wheel_workspace>();
    let mut out = poisoned::<Float>();
    // SAFETY: without a table nothing is read but these.
    let status = unsafe {
        kstrip_height_for_load(
            given.input(0, &scene.rail),
            given.input(1, &scene.wheel),
            given.input(2, &scene.pair),
            given.input(3, &scene.position),
            Number::of(bytes, 1e4),
            given.input(4, &scene.velocity),
            None,
            None,
            given.has(5).then_some(&mut memory),
            given.output(6, &mut out),
        )
    };
    if answered(status, untouched(&out)) {
        assert!(written(&out).is_finite());
    }
}

/// Two heights: those of single calls.
fn heights_for_loads(bytes: &mut Bytes) {
    let (scene, given) = (Scene::new(bytes), bytes.given());
    let supports: [Float; 2] = std::array::from_fn(|_| Number::of(bytes, 1e4));
    let mut memory = zeroed::<kstrip_wheel_workspace>();
    let mut outs: [_; 2] = std::array::from_fn(|_| poisoned::<Float>());
    let mut statuses = [77; 2];
    let velocity = (bytes.byte() < 64).then_some(&scene.velocity);
    // SAFETY: NULL, or one element, or two.
    let status = unsafe {
        kstrip_heights_for_loads(
            given.input(0, &scene.rail),
            given.input(1, &scene.wheel),
            2,
            &raw const scene.pair,
            0,
            &raw const scene.position,
            0,
            given.array(2, &supports),
            size_of::<Float>() as u32 + u32::from(bytes.byte() < 16),
            velocity.map_or(std::ptr::null(), std::ptr::from_ref),
            0,
            std::ptr::null(),
            0,
            None,
            given.has(3).then_some(&mut memory),
            outs.as_mut_ptr().cast(),
            statuses.as_mut_ptr(),
        )
    };
    if statuses == [77; 2] {
        assert!(status < 0 && outs.iter().all(untouched));
        return;
    }
    for ((&support, out), own) in supports.iter().zip(&outs).zip(statuses) {
        let mut single = poisoned::<Float>();
        // SAFETY: without a table nothing is read but these.
        let expected = unsafe {
            kstrip_height_for_load(
                Some(&scene.rail),
                Some(&scene.wheel),
                Some(&scene.pair),
                Some(&scene.position),
                support,
                velocity,
                None,
                None,
                Some(&mut memory),
                Some(&mut single),
            )
        };
        is_that_of((own, out), (expected, &single));
    }
    is_first_bad(status, &statuses);
}

/// A wheelset and its track from a scene, with some members changed.
fn wheelset(bytes: &mut Bytes, scene: &Scene) -> (kstrip_wheelset, kstrip_track) {
    let any = |bytes: &mut Bytes, value: f64| -> Float {
        if bytes.byte() < 240 { value as Float } else { Number::of(bytes, value) }
    };
    let (rail, wheel) = (&raw const *scene.rail, &raw const *scene.wheel);
    let none = std::ptr::null();
    let motion = kstrip_rail_motion {
        lateral: any(bytes, 1e-4),
        vertical: any(bytes, 1e-5),
        lateral_velocity: any(bytes, 0.01),
        vertical_velocity: any(bytes, 1e-3),
    };
    let still = kstrip_rail_motion::default();
    let left = bytes.byte();
    let second = |first, of: u8| if left & of == 0 { none } else { first };
    let track = kstrip_track {
        rail: [if left == 7 { none } else { rail }, second(rail, 1)],
        gauge: any(bytes, 1.435),
        gauge_depth: any(bytes, 1e-4),
        origin: [if left & 2 == 0 { 0.0 } else { any(bytes, 0.75) }, 0.0],
        motion: [motion, still],
    };
    let pair = kstrip_wheel_pair { wheel_radius: 0.0, ..scene.pair };
    let set = kstrip_wheelset {
        wheel: [wheel, second(wheel, 4)],
        friction: [std::ptr::null(); 2],
        table: [std::ptr::null(); 2],
        pair: [scene.pair, if left & 8 == 0 { pair } else { scene.pair }],
        back_to_back: any(bytes, 1.32),
        running_circles: if left & 16 == 0 { 0.0 } else { any(bytes, 1.46) },
    };
    (set, track)
}

fn gauge_face(bytes: &mut Bytes) {
    let scene = Scene::new(bytes);
    let depth = positive(bytes, 1e-3);
    let found = asked::<Float>(bytes, 1, |given, out| {
        kstrip_gauge_face(given.input(0, &scene.rail), depth, out)
    });
    if let Some((_, face)) = found {
        assert!(face.is_finite());
    }
}

fn curve_motion(bytes: &mut Bytes) {
    let scene = Scene::new(bytes);
    let mut any = |scale: f64| -> Float { Number::of(bytes, scale) };
    let curve =
        kstrip_curve { speed: any(20.0), curvature: any(1e-3), cant: any(0.1), gravity: any(9.8) };
    let (given, mut weight) = (bytes.given(), poisoned::<[Float; 3]>());
    let mut out = poisoned::<kstrip_wheel_velocity>();
    // SAFETY: NULL or three numbers.
    let status = unsafe {
        kstrip_curve_motion(
            given.input(0, &curve),
            given.input(1, &scene.position),
            given.input(2, &scene.velocity),
            given.output(3, &mut out),
            given.place(4, &mut weight).cast(),
        )
    };
    if answered(status, untouched(&out) && untouched(&weight)) {
        let moves = written(&out);
        let kstrip_wheel_velocity { forward, lateral, vertical, roll, pitch, yaw } = moves;
        assert!(finite(&[forward, lateral, vertical, roll, pitch, yaw]), "{curve:?} {moves:?}");
        assert!(!given.has(4) || finite(&written(&weight)), "{curve:?}");
    }
}

fn wheelset_on_track(bytes: &mut Bytes) {
    let scene = Scene::new(bytes);
    let (set, track) = wheelset(bytes, &scene);
    let (given, wanted) = (bytes.given(), bytes.byte());
    let mut memory = zeroed::<kstrip_wheelset_workspace>();
    let mut out = poisoned::<kstrip_wheelset_forces>();
    let (mut slopes, mut moved) = (poisoned(), poisoned());
    // SAFETY: the pointers in the structures are NULL or valid.
    let status = unsafe {
        kstrip_wheelset_on_track(
            given.input(0, &set),
            given.input(1, &track),
            given.input(2, &scene.position),
            given.input(3, &scene.velocity),
            given.has(4).then_some(&mut memory),
            given.output(5, &mut out),
            (wanted < 32).then_some(&mut slopes),
            (wanted < 8).then_some(&mut moved),
        )
    };
    let slopes_untouched = untouched::<kstrip_wheelset_derivatives>(&slopes)
        && untouched::<kstrip_wheelset_by_position>(&moved);
    if answered(status, untouched(&out) && slopes_untouched) {
        let forces = written(&out);
        for wheel in forces.wheel {
            plausible(&wheel, wheel.warning.code());
        }
        assert!(finite(&forces.wrench.members()));
    }
}

fn wheelset_settle(bytes: &mut Bytes) {
    let scene = Scene::new(bytes);
    let (set, track) = wheelset(bytes, &scene);
    let mut any = |scale: f64| -> Float { Number::of(bytes, scale) };
    let loads = kstrip_wheelset_loads { vertical: any(1e4).abs(), roll: any(1e3), pitch: any(1e3) };
    let given = bytes.given();
    let mut memory = zeroed::<kstrip_wheelset_workspace>();
    let (mut position, mut moves) = (poisoned(), poisoned());
    let mut out = poisoned::<kstrip_wheelset_forces>();
    // SAFETY: the pointers in the structures are NULL or valid.
    let status = unsafe {
        kstrip_wheelset_settle(
            given.input(0, &set),
            given.input(1, &track),
            given.input(2, &scene.position),
            given.input(3, &scene.velocity),
            given.input(4, &loads),
            given.has(5).then_some(&mut memory),
            given.output(6, &mut position),
            given.output(7, &mut moves),
            Some(&mut out),
        )
    };
    let places_untouched =
        untouched::<kstrip_wheel_position>(&position) && untouched::<kstrip_wheel_velocity>(&moves);
    if answered(status, untouched(&out) && places_untouched) {
        assert!(finite(&written(&out).wrench.members()));
    }
}

/// Two positions of a wheelset: the forces of single calls.
fn wheelsets_on_track(bytes: &mut Bytes) {
    let scene = Scene::new(bytes);
    let ((set, track), given) = (wheelset(bytes, &scene), bytes.given());
    let places = [scene.position, kstrip_wheel_position { lateral: 0.0, ..scene.position }];
    let mut memory = zeroed::<kstrip_wheelset_workspace>();
    let mut outs: [_; 2] = std::array::from_fn(|_| poisoned::<kstrip_wheelset_forces>());
    let mut statuses = [77; 2];
    // SAFETY: the pointers in the structures are NULL or valid, arrays NULL or of two elements.
    let status = unsafe {
        kstrip_wheelsets_on_track(
            given.input(0, &set),
            given.input(1, &track),
            2,
            given.array(2, &places),
            size_of::<kstrip_wheel_position>() as u32 + u32::from(bytes.byte() < 16),
            &raw const scene.velocity,
            0,
            given.has(3).then_some(&mut memory),
            outs.as_mut_ptr().cast(),
            std::ptr::null_mut(),
            std::ptr::null_mut(),
            statuses.as_mut_ptr(),
        )
    };
    if statuses == [77; 2] {
        assert!(status < 0 && outs.iter().all(untouched));
        return;
    }
    for ((place, out), own) in places.iter().zip(&outs).zip(statuses) {
        let mut single = poisoned::<kstrip_wheelset_forces>();
        // SAFETY: the pointers in the structures are NULL or valid.
        let expected = unsafe {
            kstrip_wheelset_on_track(
                Some(&set),
                Some(&track),
                Some(place),
                Some(&scene.velocity),
                Some(&mut memory),
                Some(&mut single),
                None,
                None,
            )
        };
        is_that_of((own, out), (expected, &single));
    }
    is_first_bad(status, &statuses);
}

/// Two balances of a wheelset: those of single calls.
fn wheelsets_settle(bytes: &mut Bytes) {
    let scene = Scene::new(bytes);
    let ((set, track), given) = (wheelset(bytes, &scene), bytes.given());
    let loads: [kstrip_wheelset_loads; 2] = std::array::from_fn(|_| {
        let vertical: Float = Number::of(bytes, 1e4);
        kstrip_wheelset_loads { vertical: vertical.abs(), roll: 0.0, pitch: 0.0 }
    });
    let mut memory = zeroed::<kstrip_wheelset_workspace>();
    let mut outs: [_; 2] = std::array::from_fn(|_| poisoned::<kstrip_wheel_position>());
    let mut moves: [_; 2] = std::array::from_fn(|_| poisoned::<kstrip_wheel_velocity>());
    let mut statuses = [77; 2];
    // SAFETY: the pointers in the structures are NULL or valid, arrays NULL or of two elements.
    let status = unsafe {
        kstrip_wheelsets_settle(
            given.input(0, &set),
            given.input(1, &track),
            2,
            &raw const scene.position,
            0,
            &raw const scene.velocity,
            0,
            given.array(2, &loads),
            size_of::<kstrip_wheelset_loads>() as u32 + u32::from(bytes.byte() < 16),
            given.has(3).then_some(&mut memory),
            outs.as_mut_ptr().cast(),
            moves.as_mut_ptr().cast(),
            std::ptr::null_mut(),
            statuses.as_mut_ptr(),
        )
    };
    if statuses == [77; 2] {
        assert!(status < 0 && outs.iter().all(untouched) && moves.iter().all(untouched));
        return;
    }
    for (((load, out), own), moved) in loads.iter().zip(&outs).zip(statuses).zip(&moves) {
        let (mut single, mut turning) = (poisoned(), poisoned());
        // SAFETY: the pointers in the structures are NULL or valid.
        let expected = unsafe {
            kstrip_wheelset_settle(
                Some(&set),
                Some(&track),
                Some(&scene.position),
                Some(&scene.velocity),
                Some(load),
                Some(&mut memory),
                Some(&mut single),
                Some(&mut turning),
                None,
            )
        };
        is_that_of((own, out), (expected, &single));
        is_that_of((own, moved), (expected, &turning));
    }
    is_first_bad(status, &statuses);
}

fn rolling_radius_difference(bytes: &mut Bytes) {
    let scene = Scene::new(bytes);
    let (set, track) = wheelset(bytes, &scene);
    let shifts: [Float; 3] = [Number::of(bytes, 1e-3), 0.0, Number::of(bytes, 1e-3)];
    let (given, mut out) = (bytes.given(), poisoned_array::<Float, 3>());
    let mut memory = zeroed::<kstrip_wheelset_workspace>();
    let mut statuses = [77; 3];
    // SAFETY: the pointers in the structures are NULL or valid, the arrays have three elements.
    let status = unsafe {
        kstrip_rolling_radius_difference(
            given.input(0, &set),
            given.input(1, &track),
            given.array(2, &shifts),
            3,
            i32::from(bytes.byte() % 2),
            given.has(3).then_some(&mut memory),
            given.places(4, &mut out),
            statuses.as_mut_ptr(),
        )
    };
    if statuses == [77; 3] {
        assert!(status < 0 && all_untouched(&out));
        return;
    }
    for (own, out) in statuses.iter().zip(&out) {
        assert!(!answered(*own, untouched(out)) || finite(&[written(out)]));
    }
    is_first_bad(status, &statuses);
}

fn equivalent_conicity(bytes: &mut Bytes) {
    let mut shifts: [Float; 5] = std::array::from_fn(|i| (i as f64 * 2e-3 - 4e-3) as Float);
    let mut differences: [Float; 5] = std::array::from_fn(|_| Number::of(bytes, 1e-3));
    if bytes.byte() < 16 {
        shifts[bytes.below(5)] = Number::of(bytes, 1e-3);
    }
    if bytes.byte() < 192 {
        differences.sort_by(Float::total_cmp);
        differences[2] = 0.0;
    }
    let amplitudes: [Float; 2] = [positive(bytes, 1e-3), positive(bytes, 3e-3)];
    let (circles, radius) = (positive(bytes, 1.5), positive(bytes, 0.46));
    let (given, mut out) = (bytes.given(), poisoned_array::<Float, 2>());
    let (mut lengths, mut statuses) = (poisoned_array::<Float, 2>(), [77; 2]);
    // SAFETY: NULL or as many elements as the counts say.
    let status = unsafe {
        kstrip_equivalent_conicity(
            given.array(0, &shifts),
            given.array(1, &differences),
            5,
            circles,
            radius,
            given.array(2, &amplitudes),
            2,
            given.places(3, &mut out),
            given.places(4, &mut lengths),
            statuses.as_mut_ptr(),
        )
    };
    if statuses == [77; 2] {
        assert!(status < 0 && all_untouched(&out) && all_untouched(&lengths));
        return;
    }
    for ((own, out), length) in statuses.iter().zip(&out).zip(&lengths) {
        if answered(*own, untouched(out) && untouched(length)) {
            let conicity = written(out);
            assert!(finite(&[conicity]) && conicity >= 0.0, "{conicity}");
            if given.has(4) {
                assert_eq!(written(length) == Float::INFINITY, conicity == 0.0);
                assert!(written(length) > 0.0);
            }
        }
    }
    is_first_bad(status, &statuses);
}

pub const ENTRIES: &[Entry] = &[
    ("read_profile", read_profile),
    ("prepare_profile", prepare_profile),
    ("orient_profiles", orient_profiles),
    ("profile_between", profile_between),
    ("touch", touch),
    ("contacts_from_gap", contacts_from_gap),
    ("motion", motion),
    ("wrench_from_contacts", wrench_from_contacts),
    ("contact_power_across", contact_power_across),
    ("wheel_on_rail", wheel_on_rail),
    ("wheels_on_rails", wheels_on_rails),
    ("height_for_load", height_for_load),
    ("heights_for_loads", heights_for_loads),
    ("gauge_face", gauge_face),
    ("curve_motion", curve_motion),
    ("wheelset_on_track", wheelset_on_track),
    ("wheelset_settle", wheelset_settle),
    ("wheelsets_on_track", wheelsets_on_track),
    ("wheelsets_settle", wheelsets_settle),
    ("rolling_radius_difference", rolling_radius_difference),
    ("equivalent_conicity", equivalent_conicity),
];
