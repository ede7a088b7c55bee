//! Registers against plain numbers, bit by bit.

use kstrip::internals::{has_avx, has_avx512};
use kstrip::number::lanes::Lanes;
use kstrip::number::{Arithmetic, Number, Real, Strips};
use kstrip_testing::prelude::*;

/// Every operation of `N` numbers side by side has the bits of plain numbers, signs of zeros
/// included.
fn agree<F: Float, const N: usize>(bits: fn(F) -> u64) {
    let numbers =
        [0.0, -0.0, 1.0, -1.0, 0.3, -7.1e-5, 2.9e11, 3e-30, -3e-30, 1e-45, 1e30, -1.0 / 3.0];
    let numbers = numbers.map(F::of);
    for shift in 0..numbers.len() {
        for first in 0..numbers.len() {
            let lanes =
                |from: usize| Lanes::<F, N>::gather(|k| numbers[(from + 5 * k) % numbers.len()]);
            let (a, b, c) = (lanes(first), lanes(first + shift), lanes(first + 2 * shift + 1));
            let same = |what: &str, is: Lanes<F, N>, one: &dyn Fn(F, F, F) -> F| {
                for k in 0..N {
                    let expected = one(a.lane(k), b.lane(k), c.lane(k));
                    let nan = !expected.is_finite_number() && !(expected <= F::LARGEST);
                    let agrees = bits(is.lane(k)) == bits(expected);
                    assert!(agrees || nan, "{what} {N}: {:?} {:?}", a.lane(k), b.lane(k));
                }
            };
            same("a + b", a + b, &|a, b, _| a + b);
            same("a - b", a - b, &|a, b, _| a - b);
            same("a * b", a * b, &|a, b, _| a * b);
            same("a / b", a / b, &|a, b, _| a / b);
            same("-a", -a, &|a, _, _| -a);
            same("abs", a.abs(), &|a, _, _| a.abs());
            same("max", a.max(b), &|a, b, _| a.max(b));
            same("min", a.min(b), &|a, b, _| a.min(b));
            same("choose", a.choose(b, c), &|a, b, c| a.choose(b, c));
            same("root", a.abs().sqrt(), &|a, _, _| a.abs().sqrt());
            same("inverse root", a.abs().inverse_root(), &|a, _, _| a.abs().inverse_root());
            let any = (0..N).any(|k| a.lane(k) > b.lane(k));
            assert_eq!(a.exceeds(b), any);
            let all = (0..N).all(|k| a.lane(k) >= b.lane(k) && a.lane(k) <= c.lane(k));
            assert_eq!(a.lies_between(b, c), all);
        }
    }
}

#[test]
fn registers_have_the_bits_of_plain_numbers() {
    let (double, single) = (f64::to_bits, |x: f32| u64::from(x.to_bits()));
    agree::<f64, 2>(double);
    agree::<f64, 3>(double);
    agree::<f32, 2>(single);
    agree::<f32, 4>(single);
    if has_avx() {
        agree::<f64, 4>(double);
        agree::<f32, 8>(single);
    }
    if has_avx512() {
        agree::<f64, 8>(double);
        agree::<f32, 16>(single);
    }
}
