//! Many contacts in one call: each answer is that of the call for one contact, to the bit.

use super::super::*;
use super::contacts::{contact, creepage, friction_of};
use super::*;

/// Contacts at most.
const MOST: usize = 3;

struct Scene {
    contacts: [kstrip_contact; MOST],
    creepages: [kstrip_creepage; MOST],
    count: usize,
    options: Option<kstrip_options>,
    given: Given,
}

impl Scene {
    fn new(bytes: &mut Bytes) -> Self {
        let (options, given, count) = (bytes.options(), bytes.given(), bytes.below(MOST + 1));
        let contacts = std::array::from_fn(|_| contact(bytes));
        let creepages = std::array::from_fn(|_| creepage(bytes));
        Self { contacts, creepages, count, options, given }
    }
}

/// One of these, now and then `None`: a quantity that is missing.
fn missing(bytes: &mut Bytes, count: u8) -> Option<u8> {
    let choice = bytes.byte();
    (choice < count).then_some(choice)
}

/// Structures side by side or one array for each quantity: the bits of the calls for one contact.
fn batch(bytes: &mut Bytes) {
    let scene = Scene::new(bytes);
    let Scene { contacts, creepages, count, options, given } = &scene;
    let (null, structures, wanted) = (missing(bytes, 9), bytes.byte() < 128, bytes.byte());
    let laws: Option<[kstrip_friction; MOST]> =
        (bytes.byte() < 96).then(|| std::array::from_fn(|_| friction_of(bytes)));
    let column = |of: &dyn Fn(usize) -> Float| -> [Float; MOST] { std::array::from_fn(of) };
    let c = |of: &dyn Fn(&kstrip_contact) -> Float| column(&|i| of(&contacts[i]));
    let k = |of: &dyn Fn(&kstrip_creepage) -> Float| column(&|i| of(&creepages[i]));
    let columns = [
        c(&|c| c.a),
        c(&|c| c.b),
        c(&|c| c.normal_force),
        c(&|c| c.shear_modulus),
        c(&|c| c.poisson_ratio),
        c(&|c| c.friction),
        k(&|k| k.longitudinal),
        k(&|k| k.lateral),
        k(&|k| k.spin),
        c(&|c| c.mismatch),
    ];
    let of_contact: [fn(&kstrip_contact) -> *const Float; 6] = [
        |c| &raw const c.a,
        |c| &raw const c.b,
        |c| &raw const c.normal_force,
        |c| &raw const c.shear_modulus,
        |c| &raw const c.poisson_ratio,
        |c| &raw const c.friction,
    ];
    let of_creepage: [fn(&kstrip_creepage) -> *const Float; 3] =
        [|k| &raw const k.longitudinal, |k| &raw const k.lateral, |k| &raw const k.spin];
    let input = |i: usize| -> (*const Float, isize) {
        let (first, stride) = match (structures, i) {
            (true, ..6) => (of_contact[i](&contacts[0]), size_of::<kstrip_contact>()),
            (true, 9) => (&raw const contacts[0].mismatch, size_of::<kstrip_contact>()),
            (true, _) => (of_creepage[i - 6](&creepages[0]), size_of::<kstrip_creepage>()),
            (false, _) => (columns[i].as_ptr(), size_of::<Float>()),
        };
        (if null == Some(i as u8) { std::ptr::null() } else { first }, stride as isize)
    };
    let [
        a,
        b,
        normal_force,
        shear_modulus,
        poisson_ratio,
        friction,
        longitudinal,
        lateral,
        spin,
        mismatch,
    ] = std::array::from_fn(input);
    let inputs = kstrip_batch_inputs {
        a: a.0,
        a_stride: a.1,
        b: b.0,
        b_stride: b.1,
        normal_force: normal_force.0,
        normal_force_stride: normal_force.1,
        shear_modulus: shear_modulus.0,
        shear_modulus_stride: shear_modulus.1,
        poisson_ratio: poisson_ratio.0,
        poisson_ratio_stride: poisson_ratio.1,
        friction: friction.0,
        friction_stride: friction.1,
        mismatch: mismatch.0,
        mismatch_stride: mismatch.1,
        longitudinal: longitudinal.0,
        longitudinal_stride: longitudinal.1,
        lateral: lateral.0,
        lateral_stride: lateral.1,
        spin: spin.0,
        spin_stride: spin.1,
        law: laws.as_ref().map_or(std::ptr::null(), |laws| laws.as_ptr()),
        law_stride: size_of::<kstrip_friction>() as isize,
    };
    let mut arrays: [[MaybeUninit<Float>; MOST + 1]; 6] = std::array::from_fn(|_| poisoned_array());
    let mut details = poisoned_array::<i32, { MOST + 1 }>();
    let mut slopes = poisoned_array::<kstrip_derivatives, { MOST + 1 }>();
    let wanted = Given(if wanted < 192 { wanted } else { 0xff });
    let each = size_of::<Float>() as isize;
    let outputs = {
        let [fx, fy, mz, power, adhesion, found] = &mut arrays;
        kstrip_batch_outputs {
            fx: wanted.places(0, fx),
            fx_stride: each,
            fy: wanted.places(1, fy),
            fy_stride: each,
            mz: wanted.places(2, mz),
            mz_stride: each,
            power: wanted.places(3, power),
            power_stride: each,
            adhesion: wanted.places(4, adhesion),
            adhesion_stride: each,
            status_detail: wanted.places(5, &mut details),
            status_detail_stride: size_of::<i32>() as isize,
            friction: wanted.places(6, found),
            friction_stride: each,
            derivatives: wanted.places(7, &mut slopes),
            derivatives_stride: size_of::<kstrip_derivatives>() as isize,
            law_derivatives: std::ptr::null_mut(),
            law_derivatives_stride: 0,
        }
    };
    let mut bad = MaybeUninit::new(u32::MAX);
    // SAFETY: NULL or four elements, and the count is not larger.
    let status = unsafe {
        kstrip_evaluate_batch(
            given.input(0, &inputs),
            *count as u32,
            options.as_ref(),
            given.input(1, &outputs),
            Some(&mut bad),
        )
    };
    // SAFETY: initialised above.
    let bad = unsafe { bad.assume_init() } as usize;
    let clean = arrays.iter().all(|array| all_untouched(array))
        && all_untouched(&details)
        && all_untouched(&slopes);
    // One by one: what each is alone, and the first that is bad
    let alone = |i: usize| {
        let (mut result, mut d, mut found) =
            (poisoned::<kstrip_result>(), poisoned::<kstrip_derivatives>(), poisoned::<Float>());
        let outputs = kstrip_outputs {
            result: result.as_mut_ptr(),
            derivatives: if wanted.has(7) { d.as_mut_ptr() } else { std::ptr::null_mut() },
            law_derivatives: std::ptr::null_mut(),
            friction: found.as_mut_ptr(),
            strips: std::ptr::null_mut(),
            count: std::ptr::null_mut(),
            capacity: 0,
            reserved: 0,
        };
        let law = laws.as_ref().map(|laws| &laws[i]);
        let (contact, creepage) = (Some(&contacts[i]), Some(&creepages[i]));
        // SAFETY: the places are there.
        let status =
            unsafe { kstrip_evaluate(contact, creepage, law, options.as_ref(), Some(&outputs)) };
        if status < 0 { Err(status) } else { Ok((written(&result), written(&found), d)) }
    };
    if !answered(status, clean) {
        if given.all(2) && null.is_none() && bad != u32::MAX as usize {
            assert_eq!(alone(bad).err(), Some(status));
            assert!((0..bad).all(|i| alone(i).is_ok()));
        }
        return;
    }
    assert!(given.all(2) && (null.is_none() || *count == 0) && bad == *count);
    let expected: Vec<_> = (0..*count).map(|i| alone(i).expect("an answer")).collect();
    let notices = expected.iter().map(|(r, ..)| r.notice);
    assert_eq!(
        status,
        notices.fold(kstrip::status::Notice::None, kstrip::status::Notice::worse).code()
    );
    for (argument, array) in (0..).zip(&arrays) {
        let place = if argument == 5 { 6 } else { argument };
        let count = if wanted.has(place) { *count } else { 0 };
        for (place, (r, found, _)) in array[..count].iter().zip(&expected) {
            let r = [r.fx, r.fy, r.mz, r.power, r.adhesion, *found][usize::from(argument)];
            assert_eq!(written(place).bits(), r.bits(), "{argument} {contacts:?} {creepages:?}");
        }
        assert!(all_untouched(&array[count..]), "written past the count");
    }
    let written_details = if wanted.has(5) { *count } else { 0 };
    for (place, (r, ..)) in details[..written_details].iter().zip(&expected) {
        assert_eq!(written(place), r.notice.code());
    }
    let written_slopes = if wanted.has(7) { *count } else { 0 };
    for (place, (_, _, d)) in slopes[..written_slopes].iter().zip(&expected) {
        let bits = |d: kstrip_derivatives| {
            let rows = [d.normal_force, d.load_through_hertz, d.friction];
            d.jacobian.into_iter().chain(rows).flatten().map(Number::bits).collect::<Vec<_>>()
        };
        assert_eq!(bits(written(place)), bits(written(d)));
    }
    assert!(all_untouched(&details[written_details..]));
    assert!(all_untouched(&slopes[written_slopes..]));
}

pub const ENTRIES: &[Entry] = &[("batch", batch)];
