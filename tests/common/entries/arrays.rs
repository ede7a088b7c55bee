//! Many contacts in one call: each answer is that of the call for one contact, to the bit.

use super::super::*;
use super::contacts::{contact, creepage, same_bits, solved};
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

    /// Contacts one by one by `kstrip_solve`, which must all be there, and the worst of their statuses.
    fn one_by_one(&self) -> (Vec<kstrip_result>, i32) {
        let solved: Vec<kstrip_result> = (0..self.count)
            .map(|i| {
                solved(&self.contacts[i], &self.creepages[i], self.options).expect("an answer")
            })
            .collect();
        let worst = solved.iter().map(|r| r.status_detail).max().unwrap_or(0);
        (solved, worst)
    }
}

fn batch(bytes: &mut Bytes) {
    let scene = Scene::new(bytes);
    let given = scene.given;
    let mut results = poisoned_array::<kstrip_result, { MOST + 1 }>();
    // SAFETY: NULL or four elements, and the count is not larger.
    let status = unsafe {
        kstrip_solve_batch(
            given.array(0, &scene.contacts),
            given.array(1, &scene.creepages),
            scene.count as u32,
            scene.options.as_ref(),
            given.places(2, &mut results),
        )
    };
    if answered(status, all_untouched(&results)) {
        assert!(given.all(3) || scene.count == 0);
        let (wanted, worst) = scene.one_by_one();
        assert_eq!(status, worst);
        results.iter().zip(&wanted).for_each(|(r, wanted)| same_bits(&written(r), wanted));
        assert!(all_untouched(&results[scene.count..]), "written past the count");
    }
}

fn batch_arrays(bytes: &mut Bytes) {
    let scene = Scene::new(bytes);
    let given = scene.given;
    let (null_inputs, null_outputs) = (bytes.byte(), bytes.byte());
    let column = |of: &dyn Fn(usize) -> Float| -> [Float; MOST] { std::array::from_fn(of) };
    let c = |of: &dyn Fn(&kstrip_contact) -> Float| column(&|i| of(&scene.contacts[i]));
    let k = |of: &dyn Fn(&kstrip_creepage) -> Float| column(&|i| of(&scene.creepages[i]));
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
    ];
    // One of nine, now and then.
    let input = |i: u8| {
        let null = null_inputs < 9 && null_inputs == i;
        if null { std::ptr::null() } else { columns[usize::from(i)].as_ptr() }
    };
    let inputs = kstrip_batch_inputs {
        a: input(0),
        b: input(1),
        normal_force: input(2),
        shear_modulus: input(3),
        poisson_ratio: input(4),
        friction: input(5),
        longitudinal: input(6),
        lateral: input(7),
        spin: input(8),
    };
    let mut arrays = [const { [const { MaybeUninit::<Float>::uninit() }; MOST + 1] }; 5];
    arrays.iter_mut().for_each(|array| array.fill_with(poisoned));
    let mut details = poisoned_array::<i32, { MOST + 1 }>();
    // Outputs that are not wanted are NULL: any of six.
    let wanted = Given(if null_outputs < 64 { null_outputs } else { 0xff });
    let outputs = {
        let [fx, fy, mz, power, adhesion] = &mut arrays;
        kstrip_batch_outputs {
            fx: wanted.places(0, fx),
            fy: wanted.places(1, fy),
            mz: wanted.places(2, mz),
            power: wanted.places(3, power),
            adhesion: wanted.places(4, adhesion),
            status_detail: wanted.places(5, &mut details),
        }
    };
    // SAFETY: NULL or four elements, and the count is not larger.
    let status = unsafe {
        kstrip_solve_batch_arrays(
            scene.count as u32,
            given.input(0, &inputs),
            scene.options.as_ref(),
            given.input(1, &outputs),
        )
    };
    let clean = arrays.iter().all(|array| all_untouched(array)) && all_untouched(&details);
    if !answered(status, clean) {
        return;
    }
    assert!(given.all(2) && (null_inputs >= 9 || scene.count == 0));
    let (expected, worst) = scene.one_by_one();
    assert_eq!(status, worst);
    for (argument, array) in (0..).zip(&arrays) {
        let count = if wanted.has(argument) { scene.count } else { 0 };
        for (place, r) in array[..count].iter().zip(&expected) {
            let r = [r.fx, r.fy, r.mz, r.power, r.adhesion][usize::from(argument)];
            assert_eq!(written(place).bits(), r.bits());
        }
        assert!(all_untouched(&array[count..]), "written past the count");
    }
    let count = if wanted.has(5) { scene.count } else { 0 };
    for (place, r) in details[..count].iter().zip(&expected) {
        assert_eq!(written(place), r.status_detail);
    }
    assert!(all_untouched(&details[count..]), "written past the count");
}

fn jacobian_batch(bytes: &mut Bytes) {
    let scene = Scene::new(bytes);
    let given = scene.given;
    let mut results = poisoned_array::<kstrip_result, { MOST + 1 }>();
    let mut jacobians = poisoned_array::<[Float; 9], { MOST + 1 }>();
    // SAFETY: NULL or four elements (nine numbers each), and the count is not larger.
    let status = unsafe {
        kstrip_solve_jacobian_batch(
            given.array(0, &scene.contacts),
            given.array(1, &scene.creepages),
            scene.count as u32,
            scene.options.as_ref(),
            given.places(2, &mut results),
            given.places(3, &mut jacobians).cast(),
        )
    };
    if !answered(status, all_untouched(&results) && all_untouched(&jacobians)) {
        return;
    }
    assert!(given.all(4) || scene.count == 0);
    let mut worst = 0;
    for i in 0..scene.count {
        let (mut result, mut entries) = (poisoned::<kstrip_result>(), poisoned::<[Float; 9]>());
        // SAFETY: nine numbers.
        let of_one = unsafe {
            kstrip_solve_jacobian(
                Some(&scene.contacts[i]),
                Some(&scene.creepages[i]),
                scene.options.as_ref(),
                Some(&mut result),
                entries.as_mut_ptr().cast(),
            )
        };
        assert!(of_one >= 0);
        worst = worst.max(of_one);
        same_bits(&written(&results[i]), &written(&result));
        let (one, other) = (written(&jacobians[i]), written(&entries));
        assert!(finite(&one), "{one:?}");
        assert_eq!(one.map(Number::bits), other.map(Number::bits));
    }
    assert_eq!(status, worst);
    assert!(all_untouched(&results[scene.count..]) && all_untouched(&jacobians[scene.count..]));
}

pub const ENTRIES: &[Entry] =
    &[("batch", batch), ("batch_arrays", batch_arrays), ("jacobian_batch", jacobian_batch)];
