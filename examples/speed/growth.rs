//! How cost grows with the number of contacts of a batch and of points of a field.

use crate::calls::{contact_f64, median};
use crate::clock;
use crate::names::*;
use crate::together;
use kstrip::solve::model::Model;
use std::mem::MaybeUninit;

pub const CONTACTS: [usize; 7] = [1, 10, 100, 1000, 10_000, 100_000, 1_000_000];
pub const SIDES: [usize; 4] = [10, 30, 100, 300];

/// Nanoseconds of each, the median of rounds that take turns.
fn in_turn(sizes: &[usize], mut run: impl FnMut(usize)) -> Vec<f64> {
    let mut times = vec![Vec::new(); sizes.len()];
    for round in 0..41 {
        for (size, times) in sizes.iter().zip(&mut times) {
            // the largest take long enough to be measured a few times only
            if round >= 5 && *size >= 100_000 {
                continue;
            }
            // the smallest are too short for the clock
            let repetitions = (1000 / size).max(1);
            let time = clock::took(|| (0..repetitions).for_each(|_| run(*size)));
            times.push(time / repetitions as f64);
        }
    }
    times.iter().map(|times| median(times)).collect()
}

/// Nanoseconds per contact of `kstrip_evaluate_batch`.
pub fn batch(model: Model) -> Vec<f64> {
    let largest = CONTACTS[CONTACTS.len() - 1];
    let mut contacts = together::in_double::Contacts::new(largest);
    let times = in_turn(&CONTACTS, |count| contacts.solve(count, model, together::How::Arrays));
    times.iter().zip(CONTACTS).map(|(time, count)| time / count as f64).collect()
}

/// Nanoseconds per point of `kstrip_field`.
pub fn field(model: Model) -> Vec<f64> {
    let options = kstrip_options { model: model as i32, strips: 16 };
    let contact = contact_f64();
    let creepage = kstrip_creepage { longitudinal: 1e-3, lateral: 5e-4, spin: 0.3 };
    let largest = SIDES[SIDES.len() - 1];
    let mut points: Vec<MaybeUninit<kstrip_point>> = Vec::new();
    points.resize_with(largest * largest, MaybeUninit::zeroed);
    let places = |side: usize, axis: f64| -> Vec<f64> {
        (0..side).map(|i| axis * ((2 * i + 1) as f64 / side as f64 - 1.0)).collect()
    };
    let times = in_turn(&SIDES, |side| {
        let (x, y) = (places(side, contact.a), places(side, contact.b));
        let (count, capacity) = (side as u32, (side * side) as u32);
        // SAFETY: `x` and `y` have `side` numbers, `points` at least `side²` elements.
        let status = unsafe {
            kstrip_field(
                Some(&contact),
                Some(&creepage),
                Some(&options),
                x.as_ptr(),
                count,
                y.as_ptr(),
                count,
                points.as_mut_ptr().cast(),
                capacity,
            )
        };
        assert!(status >= 0, "{status}");
    });
    times.iter().zip(SIDES).map(|(time, side)| time / (side * side) as f64).collect()
}
