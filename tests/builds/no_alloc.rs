//! Nothing in the library allocates: an allocator that counts calls gets none.

use kstrip_testing::prelude::*;
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::hint::black_box;

struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: every call goes on to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let _ = ALLOCATIONS.try_with(|count| count.set(count.get() + 1));
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn allocations(work: impl FnOnce()) -> usize {
    let before = ALLOCATIONS.with(Cell::get);
    work();
    ALLOCATIONS.with(Cell::get) - before
}

#[test]
fn the_counter_sees_an_allocation() {
    assert!(allocations(|| drop(black_box(vec![1_u8; 100]))) > 0);
}

macro_rules! everything {
    ($float:ty) => {{
        let steel = Material::<$float> { shear_modulus: 82e9, poisson_ratio: 0.28 };
        let pair = combine(&steel, &steel).unwrap();
        let radii = radii([<$float>::INFINITY, 0.3, 0.46, <$float>::INFINITY]);
        let h = hertz(&radii, 80e3, pair.shear_modulus, pair.poisson_ratio).unwrap();
        let (a, b, shear_modulus, poisson_ratio) =
            (h.a, h.b, pair.shear_modulus, pair.poisson_ratio);
        let (normal_force, friction, mismatch) = (80e3, 0.3, 0.0);
        let contact =
            Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, mismatch };
        // At rest, small, combined, sliding, |ψ| > 1 with adhesion, NaN
        for (x, y, s) in [
            (0.0, 0.0, 0.0),
            (1e-4, 1e-4, 0.01),
            (2e-3, -3e-3, 0.5),
            (0.1, 0.1, 0.1),
            (0.0, -5e-3, 1.5),
            (1e-3, -8e-3, 3.0),
            (<$float>::NAN, 0.0, 0.0),
        ] {
            let motion = creep(x, y, s);
            for model in Model::ALL {
                for count in [4, 8, 16, 32, 64] {
                    let count = StripCount::from_number(count).unwrap();
                    let options = Options { model, strips: count };
                    let _ = black_box(forces_of_contact(&contact, &motion, &options));
                    let _ = black_box(solve_jacobian(&contact, &motion, &options));
                    let _ = black_box(strips(&contact, &motion, &options, &mut |strip| {
                        black_box(strip);
                    }));
                    if let Ok(field) = Field::new(&contact, &motion, &options) {
                        for i in -12..=12 {
                            for j in -12..=12 {
                                let place = |i: i32, axis| axis * i as $float / 10.0;
                                black_box(field.at(place(i, h.a), place(j, h.b)));
                            }
                        }
                    }
                }
            }
        }
    }};
}

/// From materials to fields, both precisions, every model and count, good and bad inputs.
#[test]
fn nothing_allocates() {
    assert_eq!(allocations(|| everything!(f64)), 0);
    assert_eq!(allocations(|| everything!(f32)), 0);
}

#[test]
fn c_functions_do_not_allocate() {
    use kstrip_testing::names::*;
    use std::mem::MaybeUninit;
    let numbers = [6e-3, 4e-3, 80e3, 82e9, 0.28, 0.3, 1e-3, -1e-3, 0.3, 0.0];
    let (contact, creepage) = problem(numbers);
    let (contacts, creepages) = ([contact; 8], [creepage; 8]);
    let mut results = [const { MaybeUninit::<kstrip_result>::uninit() }; 8];
    let mut result = MaybeUninit::uninit();
    let count = allocations(|| {
        assert_eq!(kstrip_solve(Some(&contact), Some(&creepage), None, Some(&mut result)), 0);
        // SAFETY: eight elements each.
        let status = unsafe {
            let from = batch_inputs(contacts.as_ptr(), creepages.as_ptr());
            let to = batch_results(results.as_mut_ptr().cast());
            kstrip_evaluate_batch(Some(&from), 8, None, Some(&to), None)
        };
        assert_eq!(status, 0);
    });
    assert_eq!(count, 0);
}
