//! Patches of strips: the ways to build one, and what is computed on it.

use super::super::*;
use super::contacts::{
    All, Grid, contact, creepage, friction_of, model_of, numbers_of, plausible_point,
};
use super::*;

/// Strips of a list, points of a profile: at most these.
const MOST: usize = 6;

fn strip(bytes: &mut Bytes, y: f64, width: f64) -> kstrip_patch_strip {
    kstrip_patch_strip {
        y: y as Float,
        width: width as Float,
        half_length: positive(bytes, 5e-3),
        centre_x: if bytes.byte() < 128 { 0.0 } else { Number::of(bytes, 1e-3) },
        peak_pressure: positive(bytes, 1e9),
        friction: positive(bytes, 0.3),
    }
}

/// A list of strips that mostly lie side by side, sometimes apart, rarely in disorder.
fn list(bytes: &mut Bytes) -> ([kstrip_patch_strip; MOST], usize) {
    let count = bytes.below(MOST + 1);
    let mut y: f64 = f64::from(<Float as Number>::of(bytes, 1e-2));
    let width: f64 = f64::from(positive::<Float>(bytes, 1e-3));
    let strips = std::array::from_fn(|_| {
        let (step, share) = (bytes.byte(), bytes.byte());
        let own = width * (0.5 + f64::from(share) / 256.0);
        y += match step {
            0..=15 => -own,
            16..=79 => 3.0 * own,
            _ => 1.3 * own,
        };
        strip(bytes, y, own)
    });
    (strips, count)
}

fn from_list(bytes: &mut Bytes, out: Option<&mut MaybeUninit<kstrip_patch>>) -> i32 {
    let (strips, count) = list(bytes);
    let (modulus, ratio) = (positive(bytes, 82e9), positive(bytes, 0.06));
    let given = bytes.given();
    // SAFETY: NULL or at least as many strips as the count says.
    unsafe { kstrip_patch_from_strips(given.array(0, &strips), count as u32, modulus, ratio, out) }
}

fn from_contact(bytes: &mut Bytes, out: Option<&mut MaybeUninit<kstrip_patch>>) -> i32 {
    let contact = contact(bytes);
    let options = kstrip_options { model: 0, strips: bytes.strips() };
    kstrip_patch_from_contact(bytes.given().input(0, &contact), Some(&options), out)
}

/// A profile that is mostly a hollow with some roughness.
fn from_profile(
    bytes: &mut Bytes, out: Option<&mut MaybeUninit<kstrip_patch>>,
    found: Option<&mut MaybeUninit<kstrip_profile_result>>,
) -> i32 {
    const POINTS: usize = 10;
    let points = bytes.below(POINTS + 1);
    let (step, depth) =
        (f64::from(positive::<Float>(bytes, 2e-3)), f64::from(positive::<Float>(bytes, 1e-4)));
    let mut place = f64::from(<Float as Number>::of(bytes, 1e-2));
    let (mut y, mut distance): ([Float; POINTS], [Float; POINTS]) = Default::default();
    for i in 0..POINTS {
        place += step * f64::from(bytes.byte()) / 128.0;
        y[i] = place as Float;
        let s = i as f64 - points as f64 / 2.0;
        distance[i] = (depth * (s * s / 4.0 + f64::from(bytes.byte()) / 128.0)) as Float;
    }
    if bytes.byte() < 16 {
        y[bytes.below(POINTS)] = Number::of(bytes, 1e-2);
        distance[bytes.below(POINTS)] = Number::of(bytes, 1e-4);
    }
    let mut pressed = |scale: f64| -> (Float, Float) {
        let by_load = bytes.byte() < 192;
        let size = positive(bytes, scale * if by_load { 1.0 } else { 1e-9 });
        if by_load { (size, 0.0) } else { (0.0, size) }
    };
    let (normal_force, approach) = pressed(5e4);
    let contact = kstrip_profile_contact {
        rolling_radius: positive(bytes, 0.5),
        normal_force,
        approach,
        smoothing_length: if bytes.byte() < 192 { 0.0 } else { positive(bytes, 1e-3) },
        shear_modulus: positive(bytes, 82e9),
        poisson_ratio: positive(bytes, 0.06),
        friction: positive(bytes, 0.3),
        strips: bytes.strips(),
        reserved: 0,
    };
    let (mut centre_x, mut rolling_radius): ([Float; POINTS], [Float; POINTS]) = Default::default();
    let [with_centres, with_radii] = [bytes.byte() >= 192, bytes.byte() >= 192];
    for i in 0..POINTS {
        if with_centres {
            centre_x[i] = (y[i] - y[0]) * (f64::from(bytes.byte()) / 512.0) as Float;
        }
        if with_radii {
            rolling_radius[i] = positive(bytes, 0.5);
        }
    }
    let given = bytes.given();
    let list = |wanted, list: &[Float]| if wanted { list.as_ptr() } else { std::ptr::null() };
    let profile = kstrip_profile {
        y: given.array(0, &y),
        distance: given.array(1, &distance),
        centre_x: list(with_centres, &centre_x),
        rolling_radius: list(with_radii, &rolling_radius),
        points: points as u32,
        reserved: 0,
    };
    // SAFETY: NULL or at least as many points as the count says.
    unsafe {
        kstrip_patch_from_profile(given.input(3, &profile), given.input(2, &contact), out, found)
    }
}

/// A patch that was just built is one that other functions accept.
fn accepted(patch: &kstrip_patch) -> kstrip_patch_summary {
    let mut sums = poisoned::<kstrip_patch_summary>();
    let status = kstrip_patch_summarize(Some(patch), Some(&mut sums));
    assert_eq!(status, 0, "{patch:?}");
    written(&sums)
}

/// A patch that one of the two makes is accepted.
fn made_by(bytes: &mut Bytes, make: fn(&mut Bytes, Option<&mut MaybeUninit<kstrip_patch>>) -> i32) {
    let with_patch = bytes.given();
    let mut out = poisoned::<kstrip_patch>();
    let status = make(bytes, with_patch.output(0, &mut out));
    if answered(status, untouched(&out)) {
        accepted(&written(&out));
    }
}

fn patch_from_strips(bytes: &mut Bytes) {
    made_by(bytes, from_list);
}

fn patch_from_contact(bytes: &mut Bytes) {
    made_by(bytes, from_contact);
}

fn patch_from_profile(bytes: &mut Bytes) {
    let given = bytes.given();
    let (mut out, mut found) = (poisoned::<kstrip_patch>(), poisoned::<kstrip_profile_result>());
    let status = from_profile(bytes, given.output(0, &mut out), given.output(1, &mut found));
    if answered(status, untouched(&out) && untouched(&found)) {
        assert!(given.has(0));
        let patch = written(&out);
        if !given.has(1) {
            accepted(&patch);
            return;
        }
        let found = written(&found);
        let numbers = [found.approach, found.peak_pressure, found.normal_force];
        assert!(finite(&numbers) && numbers.iter().all(|&x| x >= 0.0), "{found:?}");
        // two searches of at most 60 steps
        assert!(found.peak_y.is_finite() && found.iterations <= 120, "{found:?}");
        let load = f64::from(accepted(&patch).normal_force);
        let reached = f64::from(found.normal_force);
        // (far fewer digits are lost unless the numbers are at the ends of their range;
        // tests/models/patch.rs asks for them. A load among the subnormal numbers is a sum of such
        // numbers, each rounded to the smallest of them.)
        let smallest = f64::from(Float::from_bits(1));
        let allowed = 1.001e-3 * reached + smallest * f64::from(patch.count);
        assert!((load - reached).abs() <= allowed, "{load} {found:?} {patch:?}");
    }
}

/// A patch as a program may have it: built by one of the three functions, perhaps changed since, or
/// any bits.
fn patch(bytes: &mut Bytes) -> Option<kstrip_patch> {
    let mut out = poisoned::<kstrip_patch>();
    let way = bytes.byte();
    let status = match way {
        0..=15 => {
            let mut found = poisoned();
            from_profile(bytes, Some(&mut out), Some(&mut found))
        }
        16..=79 => from_contact(bytes, Some(&mut out)),
        80..=87 => return Some(any_bits(bytes)),
        _ => from_list(bytes, Some(&mut out)),
    };
    if !answered(status, untouched(&out)) {
        return None;
    }
    let mut patch = written(&out);
    let changed = bytes.below(MOST);
    match bytes.byte() {
        0..=7 => patch.strips[changed].friction = Number::of(bytes, 0.3),
        8..=15 => patch.strips[changed].half_length = Number::of(bytes, 5e-3),
        16..=23 => patch.strips[changed].y = Number::of(bytes, 1e-2),
        24..=31 => patch.count = bytes.integer() as u32,
        32..=39 => patch.lever_scale = Number::of(bytes, 1.0),
        40..=47 => patch.area_scale = Number::of(bytes, 1.0),
        _ => {}
    }
    Some(patch)
}

fn any_bits(bytes: &mut Bytes) -> kstrip_patch {
    let mut any = || -> Float { Number::of(bytes, 1.0) };
    let strips = std::array::from_fn(|i| {
        let mut number = || if i < 3 { any() } else { 0.0 };
        let [y, width, half_length] = [0; 3].map(|_| number());
        let [centre_x, peak_pressure, friction] = [0; 3].map(|_| number());
        kstrip_patch_strip { y, width, half_length, centre_x, peak_pressure, friction }
    });
    kstrip_patch {
        strips,
        shear_modulus: any(),
        poisson_ratio: any(),
        area_scale: any(),
        lever_scale: any(),
        count: bytes.below(256) as u32,
        reserved: bytes.integer() as u32,
        mismatch: if bytes.byte() < 64 { Number::of(bytes, 0.2) } else { 0.0 },
    }
}

fn patch_options(bytes: &mut Bytes) -> Option<kstrip_options> {
    match bytes.byte() {
        choice @ 0..=239 => Some(kstrip_options { model: 1 + i32::from(choice % 3), strips: 16 }),
        _ => bytes.options(),
    }
}

fn summarize(bytes: &mut Bytes) {
    let Some(patch) = patch(bytes) else { return };
    let answer = asked::<kstrip_patch_summary>(bytes, 1, |given, out| {
        kstrip_patch_summarize(given.input(0, &patch), out)
    });
    if let Some((_, s)) = answer {
        assert!(finite(&[s.normal_force, s.friction_bound, s.area]), "{patch:?} {s:?}");
        let in_range = s.normal_force >= 0.0 && s.friction_bound >= 0.0 && s.area >= 0.0;
        assert!(in_range && s.lobes <= patch.count && s.reserved == 0, "{patch:?} {s:?}");
    }
}

/// What holds for the result of a patch that was solved.
fn plausible(
    patch: &kstrip_patch, k: &kstrip_creepage, model: i32, status: i32, r: &kstrip_result,
) {
    let context = || format!("{patch:?} {k:?} model {model} {r:?}");
    assert_eq!((r.warning.code(), r.reserved), (status, 0));
    assert!(finite(&numbers_of(r)), "{}", context());
    let bound = f64::from(accepted(patch).friction_bound);
    let size = f64::from(r.fx).hypot(r.fy.into());
    // A sum over strips: each rounds by itself.
    let allowed = bound * (1.0 + 1.5 * Float::ROUNDING) + 64.0 * Float::SMALLEST;
    assert!(size <= allowed, "{size} of {bound}: {}", context());
    let unknown = model == KSTRIP_MODEL_TOTAL && r.adhesion == -1.0;
    assert!((0.0..=1.0).contains(&r.adhesion) || unknown, "{}", context());
}

/// Strips with creepages of their own; the bytes of a patch, a motion and one more creepage.
fn patch_evaluate_strips(bytes: &mut Bytes) {
    let Some(patch) = patch(bytes) else { return };
    let (k, own) = (creepage(bytes), [creepage(bytes); kstrip::patch::KSTRIP_PATCH_CAPACITY]);
    let (options, given, has_own) = (patch_options(bytes), bytes.given(), bytes.byte() < 192);
    let mut all = All::new(bytes);
    let outputs = all.outputs();
    let list = if has_own { own.as_ptr() } else { std::ptr::null() };
    // SAFETY: each pointer is NULL or valid.
    let status = unsafe {
        kstrip_patch_evaluate_strips(
            given.input(0, &patch),
            given.input(1, &k),
            list,
            None,
            options.as_ref(),
            given.input(2, &outputs),
        )
    };
    let context = || format!("{patch:?} {k:?} {options:?} {has_own}");
    if all.answered(status, context) {
        assert!(given.all(3));
    }
}

fn patch_evaluate(bytes: &mut Bytes) {
    let Some(patch) = patch(bytes) else { return };
    let (k, law) = (creepage(bytes), friction_of(bytes));
    let (options, given) = (patch_options(bytes), bytes.given());
    let with_law = bytes.byte() < 128;
    let mut all = All::new(bytes);
    let outputs = all.outputs();
    // SAFETY: each pointer is NULL or valid.
    let status = unsafe {
        kstrip_patch_evaluate(
            given.input(0, &patch),
            given.input(1, &k),
            with_law.then_some(&law),
            options.as_ref(),
            given.input(2, &outputs),
        )
    };
    let context = || format!("{patch:?} {k:?} {options:?} {:?}", with_law.then_some(law));
    if !all.answered(status, context) {
        return;
    }
    assert!(given.all(3));
    if let Some(r) = all.result() {
        plausible(&patch, &k, model_of(options), r.warning.code(), &r);
    }
    if let Some(share) = all.friction() {
        assert!((0.0..=1.0).contains(&share) && (with_law || share == 1.0), "{}", context());
    }
    if let Some(strips) = all.strips() {
        assert_eq!(strips.len(), patch.count as usize);
        for (s, of_patch) in strips.iter().zip(patch.used()) {
            let numbers = [s.separatrix, s.fx, s.fy, s.mz, s.power];
            assert!(finite(&numbers) && s.y == of_patch.y, "{} {s:?}", context());
        }
    }
}

/// What holds for a point of a patch: the friction is that of a strip, so the largest bounds it.
fn plausible_place(
    patch: &kstrip_patch, k: &kstrip_creepage, options: Option<kstrip_options>, p: &kstrip_point,
) {
    let strips = &patch.strips[..patch.count as usize];
    let friction = strips.iter().fold(0.0, |most: Float, strip| most.max(strip.friction));
    let peak = strips.iter().map(|s| f64::from(s.friction) * f64::from(s.peak_pressure));
    let peak = peak.fold(0.0, f64::max);
    plausible_point(p, friction, peak, || format!("{patch:?} {k:?} {options:?}"));
}

fn patch_field(bytes: &mut Bytes) {
    let Some(patch) = patch(bytes) else { return };
    let (k, options, given) = (creepage(bytes), patch_options(bytes), bytes.given());
    let law = (bytes.byte() < 100).then(|| friction_of(bytes));
    let mut grid = Grid::new(bytes, 5e-3);
    if bytes.byte() < 192 {
        grid.y.iter_mut().zip(patch.used()).for_each(|(y, strip)| *y = strip.y);
    }
    // SAFETY: NULL or as many elements as the counts say.
    let status = unsafe {
        kstrip_patch_field(
            given.input(0, &patch),
            given.input(1, &k),
            law.as_ref(),
            options.as_ref(),
            given.array(2, &grid.x),
            grid.x.len() as u32,
            given.array(3, &grid.y),
            grid.y.len() as u32,
            given.places(4, &mut grid.points),
            grid.capacity as u32,
        )
    };
    for point in grid.written(status) {
        plausible_place(&patch, &k, options, &point);
    }
}

pub const ENTRIES: &[Entry] = &[
    ("patch_from_contact", patch_from_contact),
    ("patch_from_strips", patch_from_strips),
    ("patch_from_profile", patch_from_profile),
    ("summarize", summarize),
    ("patch_evaluate", patch_evaluate),
    ("patch_evaluate_strips", patch_evaluate_strips),
    ("patch_field", patch_field),
];
