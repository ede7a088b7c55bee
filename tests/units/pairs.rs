//! Pairs and quads in registers against plain ones, bit by bit.

use super::*;

macro_rules! agree {
    ($registers:ident, $quad:ident, $float:ident) => {{
        let numbers: [$float; 12] =
            [0.0, -0.0, 1.0, -1.0, 0.3, -7.1e-5, 2.9e11, 3e-30, -3e-30, 1e-45, 1e30, -1.0 / 3.0];
        let bits = |(first, second): ($float, $float)| [first.to_bits(), second.to_bits()];
        for x in numbers {
            for y in numbers {
                let (a, b) = ($registers::of(x, y), $registers::of(y, 0.7));
                let (c, d) = (Two::<$float>::of(x, y), Two::<$float>::of(y, 0.7));
                let (e, f) = ($quad::of_halves(a, b), $quad::of_halves(b, a));
                let registers =
                    [a + b, a - b, a * b, -a, a.abs(), a.max(b), a.min(b), a.choose(b, a)];
                let plain = [c + d, c - d, c * d, -c, c.abs(), c.max(d), c.min(d), c.choose(d, c)];
                for (i, (one, two)) in registers.iter().zip(&plain).enumerate() {
                    assert_eq!(bits(one.parts()), bits(two.parts()), "operation {i} of {x} {y}");
                }
                let quads = [e + f, e - f, e * f, -e, e.abs(), e.max(f), e.min(f), e.choose(f, e)];
                let halves = [
                    [a + b, b + a],
                    [a - b, b - a],
                    [a * b, b * a],
                    [-a, -b],
                    [a.abs(), b.abs()],
                    [a.max(b), b.max(a)],
                    [a.min(b), b.min(a)],
                    [a.choose(b, a), b.choose(a, b)],
                ];
                for (i, (four, halves)) in quads.iter().zip(halves).enumerate() {
                    for (half, pair) in four.halves().into_iter().zip(halves) {
                        let (half, pair) = (bits(half.parts()), bits(pair.parts()));
                        assert_eq!(half, pair, "operation {i} of {x} {y} in quads");
                    }
                }
                if x > 1e-30 && y > 1e-30 && x < 1e30 && y < 1e30 {
                    assert_eq!(bits((a / b).parts()), bits((c / d).parts()));
                    assert_eq!(bits(a.sqrt().parts()), bits(c.sqrt().parts()));
                    let one = $registers::inverse_roots([a, b, a]);
                    let two = Two::<$float>::inverse_roots([c, d, c]);
                    for (one, two) in one.iter().zip(&two) {
                        assert_eq!(bits(one.parts()), bits(two.parts()), "roots of {x} {y}");
                    }
                    for (quotient, pair) in (e / f).halves().into_iter().zip([a / b, b / a]) {
                        assert_eq!(bits(quotient.parts()), bits(pair.parts()));
                    }
                    let roots = [e.inverse_root().halves(), e.sqrt().halves()];
                    let pairs = [$registers::inverse_roots([a, b]), [a.sqrt(), b.sqrt()]];
                    for (root, pair) in roots.iter().flatten().zip(pairs.iter().flatten()) {
                        assert_eq!(bits(root.parts()), bits(pair.parts()), "roots of {x} {y}");
                    }
                }
            }
        }
    }};
}

/// Registers and plain pairs give the same bits, signs of zeros included; so do four numbers and two pairs.
#[test]
fn registers_and_plain_pairs_agree() {
    agree!(F64Pair, F64Quad, f64);
    agree!(F32Pair, F32Quad, f32);
}
