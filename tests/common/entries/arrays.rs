//! Many contacts in one call: each answer is that of the call for one contact, to the bit.

use super::super::*;
use super::contacts::{contact, creepage, friction_of};
use super::*;

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
    let rows: [[Float; 10]; MOST] = std::array::from_fn(|i| {
        let (c, k) = (&contacts[i], &creepages[i]);
        let kstrip_contact { a, b, normal_force: n, shear_modulus: g, poisson_ratio: nu, .. } = *c;
        [a, b, n, g, nu, c.friction, k.longitudinal, k.lateral, k.spin, c.mismatch]
    });
    let columns: [[Float; MOST]; 10] = std::array::from_fn(|q| rows.map(|row| row[q]));
    let (of_contact, of_creepage) = (size_of::<kstrip_contact>(), size_of::<kstrip_creepage>());
    let own = batch_from(|q| {
        let (first, stride) = match q {
            _ if null == Some(q as u8) => (std::ptr::null(), 0),
            _ if !structures => (columns[q].as_ptr(), size_of::<Float>()),
            6..9 => (creepages.as_ptr().cast::<Float>().wrapping_add(q - 6), of_creepage),
            9 => (&raw const contacts[0].mismatch, of_contact),
            _ => (contacts.as_ptr().cast::<Float>().wrapping_add(q), of_contact),
        };
        (first, stride as isize)
    });
    let law = laws.as_ref().map_or(std::ptr::null(), |laws| laws.as_ptr());
    let law_stride = size_of::<kstrip_friction>() as isize;
    let inputs = kstrip_batch_inputs { law, law_stride, ..own };
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
            ..no_batch()
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
            friction: found.as_mut_ptr(),
            ..nowhere()
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
    let notices = expected.iter().map(|(r, ..)| r.warning);
    assert_eq!(
        status,
        notices.fold(kstrip::status::Warning::None, kstrip::status::Warning::worse).code()
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
        assert_eq!(written(place), r.warning.code());
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
