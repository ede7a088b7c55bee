//! What a call costs: `cargo run --release --example speed`.
//!
//! Median of interleaved rounds over 512 random creepages, FASTSIM 10x10 of `benches/peers` in the same
//! run. With the arguments `count MODEL STRIPS CALLS` it only makes the calls, for `scripts/instructions.sh`.

#[path = "../benches/peers/mod.rs"]
mod peers;
#[path = "common/progress.rs"]
mod progress;

use kstrip::coefficients::LinearCoefficients;
use kstrip::contact::Contact;
use kstrip::creepage::Creepage;
use kstrip::model::{Model, Options, solve, solve_jacobian};
use kstrip::totals::StripCount;
use std::hint::black_box;
use std::time::Instant;

const CONTACT: Contact<f64> = Contact {
    a: 6e-3,
    b: 4e-3,
    normal_force: 80e3,
    shear_modulus: 82e9,
    poisson_ratio: 0.28,
    friction: 0.3,
};

/// Creepages from partial slip to sliding, by the golden ratio and its relatives.
fn creepages() -> Vec<Creepage<f64>> {
    let spread = |i: usize, step: f64| (i as f64 * step).fract() - 0.5;
    (0..512)
        .map(|i| Creepage {
            longitudinal: spread(i, 0.618_034) * 8e-3,
            lateral: spread(i, 0.381_966) * 8e-3,
            spin: spread(i, 0.271_828) * 1.5,
        })
        .collect()
}

fn run(options: &Options, creepages: &[Creepage<f64>]) -> f64 {
    creepages
        .iter()
        .map(|creepage| {
            solve(black_box(&CONTACT), creepage, options)
                .map_or(0.0, |forces| forces.fx + forces.fy)
        })
        .sum()
}

fn run_jacobian(options: &Options, creepages: &[Creepage<f64>]) -> f64 {
    creepages
        .iter()
        .map(|creepage| {
            solve_jacobian(black_box(&CONTACT), creepage, options)
                .map_or(0.0, |(forces, jacobian)| forces.fx + jacobian[(0, 0)])
        })
        .sum()
}

fn fastsim(grid: &peers::fastsim::Grid<10, 10>, creepages: &[Creepage<f64>]) -> f64 {
    use peers::fastsim::{Bound, Flexibility, solve};
    let c = LinearCoefficients::at(CONTACT.a / CONTACT.b, CONTACT.poisson_ratio);
    creepages
        .iter()
        .map(|creepage| {
            let input = peers::Input {
                a: CONTACT.a,
                b: CONTACT.b,
                normal_force: CONTACT.normal_force,
                shear_modulus: CONTACT.shear_modulus,
                poisson_ratio: CONTACT.poisson_ratio,
                friction: CONTACT.friction,
                longitudinal: creepage.longitudinal,
                lateral: creepage.lateral,
                spin: creepage.spin,
                c11: c.c11,
                c22: c.c22,
                c23: c.c23,
            };
            let force =
                solve::<10, 10, 1>(grid, black_box(&input), Flexibility::Three, Bound::Parabolic);
            force.fx + force.fy
        })
        .sum()
}

/// Rounds over all calls, of which the median counts.
const ROUNDS: u64 = 41;

/// Name, what to run, times so far.
type Row = (String, Box<dyn Fn() -> f64>, Vec<f64>);

fn main() {
    let creepages = creepages();
    let arguments: Vec<String> = std::env::args().collect();
    if let [_, mode, model, strips, calls] = &arguments[..]
        && mode == "count"
    {
        let options = Options {
            model: Model::from_number(model.parse().expect("a number")).expect("a model"),
            strips: StripCount::from_number(strips.parse().expect("a number")).expect("a count"),
        };
        let calls: usize = calls.parse().expect("a number");
        let many: Vec<_> = creepages.iter().copied().cycle().take(calls).collect();
        println!("{}", run(&options, &many));
        return;
    }

    let counts = [
        StripCount::Four,
        StripCount::Eight,
        StripCount::Sixteen,
        StripCount::ThirtyTwo,
        StripCount::SixtyFour,
    ];
    let mut rows: Vec<Row> = Vec::new();
    let grid = peers::fastsim::Grid::<10, 10>::new(peers::fastsim::Layout::StripCentres);
    let list = creepages.clone();
    rows.push(("FASTSIM 10x10 (peer)".into(), Box::new(move || fastsim(&grid, &list)), vec![]));
    for model in Model::ALL {
        let with_strips = !matches!(model, Model::Total | Model::Linear);
        for strips in counts {
            if !with_strips && strips != StripCount::Sixteen {
                continue;
            }
            let options = Options { model, strips };
            let name = if with_strips {
                format!("{model:?}, {} strips", strips as i32)
            } else {
                format!("{model:?}")
            };
            let list = creepages.clone();
            rows.push((name.clone(), Box::new(move || run(&options, &list)), vec![]));
            if strips == StripCount::Sixteen {
                let list = creepages.clone();
                let name = format!("{name}, with Jacobian");
                rows.push((name, Box::new(move || run_jacobian(&options, &list)), vec![]));
            }
        }
    }
    for _ in progress::bar(ROUNDS).wrap_iter(0..ROUNDS) {
        for (_, call, times) in &mut rows {
            let start = Instant::now();
            black_box(call());
            times.push(start.elapsed().as_nanos() as f64 / creepages.len() as f64);
        }
    }
    let median = |times: &[f64]| {
        let mut sorted = times.to_vec();
        sorted.sort_by(f64::total_cmp);
        sorted[sorted.len() / 2]
    };
    let reference = median(&rows[0].2);
    println!("| call | ns | of FASTSIM 10x10 |\n|---|---|---|");
    for (name, _, times) in &rows {
        let time = median(times);
        println!("| {name} | {time:.0} | {:.2} |", time / reference);
    }
}
