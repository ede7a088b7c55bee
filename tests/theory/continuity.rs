//! Totals are continuous functions of the creepages for both rules.
//!
//! A sweep in steps of 1e-6 may show a kink or the beginning of a square root, not a jump. A step
//! more than three times as large as its larger neighbour is checked closely: halved twenty
//! times, always into the half that changes more. Of a square root a thousandth is left, of a jump
//! all.

use kstrip_testing::prelude::*;
use kstrip_testing::theory::{BASE, Law, solve};

const STEP: f64 = 1e-6;

/// Largest change of forces, moment and stick fraction; the moment over the larger semi-axis.
fn distance(law: &Law, p: &[f64; 4], q: &[f64; 4]) -> f64 {
    let arm = law.axis_ratio.sqrt().max(1.0 / law.axis_ratio.sqrt());
    let change = |i: usize| (p[i] - q[i]).abs();
    change(0).max(change(1)).max(change(2) / arm).max(change(3))
}

/// What is left of a change when its interval is halved into the half that changes more, and where.
fn remaining(at: &dyn Fn(f64) -> Law, ends: [f64; 2], width: f64) -> (f64, f64) {
    let law = at(ends[0]);
    let solved = |t: f64| solve(&at(t));
    let distance = |p, q| distance(&law, &p, &q);
    let (low, [below, above]) =
        steepest(ends, ends.map(solved), width, |t| Some(solved(t)), distance);
    (distance(below, above), low)
}

/// A sweep of `steps` to both sides without jump.
fn check_sweep(name: &str, steps: i32, at: impl Fn(f64) -> Law) {
    let place = |i: usize| STEP * (i as f64 - f64::from(steps));
    let values: Vec<[f64; 4]> = (0..=2 * steps as usize).map(|i| solve(&at(place(i)))).collect();
    let law = at(0.0);
    let moves: Vec<f64> =
        values.windows(2).map(|pair| distance(&law, &pair[0], &pair[1])).collect();
    for i in 1..moves.len() - 1 {
        let neighbour = moves[i - 1].max(moves[i + 1]);
        if moves[i] <= 3.0 * neighbour + 1e-9 {
            continue;
        }
        let (jump, found) = remaining(&at, [place(i), place(i + 1)], STEP * 1e-6);
        assert!(
            jump <= 0.03 * moves[i] + 1e-10,
            "{name}: jump of {jump:e} in a step of {:e} beside {neighbour:e} at {:?}",
            moves[i],
            at(found)
        );
    }
}

/// ψ through ±1 with both signs of ηψ, also without η or ξ.
#[test]
fn sweep_of_spin_through_unity() {
    for continuous in [false, true] {
        for sign in [1.0, -1.0] {
            for (xi, eta, axis_ratio) in [
                (0.0, -0.5, 1.0),
                (0.0, 0.5, 1.0),
                (0.3, -0.4, 1.0),
                (0.3, 0.4, 1.0),
                (0.0, 0.0, 1.0),
                (0.3, 0.0, 1.0),
                (0.0, -1e-4, 1.0),
                (0.2, -0.3, 0.1),
                (0.2, -0.3, 10.0),
                (0.9, -0.6, 5.0),
                (0.05, -0.05, 10.0),
            ] {
                let law = Law { xi, eta: eta * sign, axis_ratio, continuous, ..BASE };
                check_sweep("ψ through 1", 150, |t| Law { psi: sign * (1.0 + t), ..law });
            }
        }
    }
}

/// The creepage at which the last strip loses its adhesion, on a ray from a start with adhesion.
fn threshold(at: &dyn Fn(f64) -> Law) -> Option<f64> {
    // Independent of the library: is any strip of 2000 adhering?
    let sticks = |t: f64| {
        let law = at(t);
        (1..4000).any(|i| {
            let (y, c) = (PI * (f64::from(i) / 4000.0 - 0.5)).sin_cos();
            law.adheres(y, c).is_some()
        })
    };
    let ends = [0.0, 2.0];
    (ends.map(sticks) == [true, false]).then(|| bisect(ends, 2e-12, sticks)[0])
}

/// The adhesion interval appears and vanishes: sweeps of ξ, of η and of both through the threshold,
/// |ψ| up to 3.
#[test]
fn sweep_where_the_adhesion_interval_vanishes() {
    let mut found = 0;
    for psi in [0.0_f64, 0.1, 0.4, -0.4, 0.9, -0.99, 1.5, -3.0] {
        for (dx, dy) in [(1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (0.6, -0.8)] {
            for axis_ratio in [0.3, 1.0, 4.0] {
                let ray = |t: f64| Law {
                    xi: t * dx,
                    // Beyond unit spin adhesion needs lateral creepage against the spin
                    eta: t * dy - if psi.abs() > 1.0 { 0.3 * psi } else { 0.0 },
                    psi,
                    axis_ratio,
                    ..BASE
                };
                let Some(critical) = threshold(&ray) else { continue };
                found += 1;
                for continuous in [false, true] {
                    let at = |t| Law { continuous, ..ray(critical + t) };
                    check_sweep("adhesion vanishes", 60, at);
                }
            }
        }
    }
    assert!(found > 30, "{found}");
}

/// The kink at η = 0 with spin, for small and large spin, and the same for ξ.
#[test]
fn sweep_of_lateral_creepage_through_zero_with_spin() {
    for continuous in [false, true] {
        for psi in [1e-3_f64, 0.2, -0.7, 0.999, -1.0, 1.4, 3.0] {
            for xi in [0.0, 0.2, -1.1] {
                for axis_ratio in [0.2, 5.0] {
                    let law = Law { xi, psi, axis_ratio, continuous, ..BASE };
                    check_sweep("η through 0", 25, |t| Law { eta: t, ..law });
                    let half = |t| Law { eta: t + 0.5 * STEP, ..law };
                    check_sweep("η through 0, half a step off", 25, half);
                    let law = Law { xi: 0.0, eta: -0.3 * psi.signum(), ..law };
                    check_sweep("ξ through 0", 25, |t| Law { xi: xi + t, ..law });
                }
            }
        }
    }
}

/// Through zero creepage and through zero spin.
#[test]
fn sweep_through_rest() {
    for continuous in [false, true] {
        for axis_ratio in [0.1, 1.0, 10.0] {
            let law = Law { axis_ratio, continuous, ..BASE };
            check_sweep("ξ through rest", 60, |t| Law { xi: t, ..law });
            check_sweep("η through rest", 60, |t| Law { eta: t, ..law });
            check_sweep("ψ through rest", 60, |t| Law { psi: t, ..law });
            check_sweep("all through rest", 60, |t| Law { xi: t, eta: -t, psi: t, ..law });
            for (xi, eta) in
                [(0.3, 0.0), (0.0, 0.4), (0.5, -0.5), (1.0, 0.0), (0.6, 0.8), (2.0, 1.0)]
            {
                let law = Law { xi, eta, axis_ratio, continuous, ..BASE };
                check_sweep("ψ through 0", 60, |t| Law { psi: t, ..law });
            }
        }
    }
}

/// A hunt for jumps anywhere: along random paths the interval with the largest unexplained change
/// is halved until it is 1e-13 wide. A continuous function has nothing left there (a square root
/// 3e-7).
#[test]
fn no_jump_is_found_by_bisection_along_random_paths() {
    let mut random = Random::new(55);
    let point = |random: &mut Random| {
        let wide = random.unit() < 0.5;
        [
            random.between(-1.2, 1.2),
            random.between(-1.2, 1.2),
            if wide { random.between(-3.0, 3.0) } else { random.between(-1.2, 1.2) },
        ]
    };
    let (mut jumps, mut worst) = (Vec::new(), 0.0_f64);
    for path in 0..250 {
        let (start, end) = (point(&mut random), point(&mut random));
        let base = Law {
            poisson_ratio: random.between(0.0, 0.5),
            axis_ratio: random.log_between(0.1, 10.0),
            continuous: path % 2 == 0,
            ..BASE
        };
        let at = |t: f64| {
            let mix = |i: usize| start[i] + (end[i] - start[i]) * t;
            Law { xi: mix(0), eta: mix(1), psi: mix(2), ..base }
        };
        const CELLS: usize = 200;
        let grid: Vec<f64> = (0..=CELLS).map(|i| i as f64 / CELLS as f64).collect();
        let values: Vec<[f64; 4]> = grid.iter().map(|&t| solve(&at(t))).collect();
        // Cells that change more than their neighbours first
        let changes: Vec<f64> = values.windows(2).map(|v| distance(&base, &v[0], &v[1])).collect();
        let mut order: Vec<usize> = (1..CELLS - 1).collect();
        let excess = |i: usize| changes[i] - 0.5 * (changes[i - 1] + changes[i + 1]);
        order.sort_by(|&i, &j| excess(j).total_cmp(&excess(i)));
        for &cell in order.iter().take(6) {
            let (jump, low) = remaining(&at, [grid[cell], grid[cell + 1]], 1e-13);
            worst = worst.max(jump);
            if jump > 5e-9 {
                jumps.push(format!("{jump:.1e} at {:?}", at(low)));
            }
        }
    }
    println!("largest change in 1e-13: {worst:e}");
    assert!(jumps.is_empty(), "{} jumps:\n{}", jumps.len(), jumps.join("\n"));
}
