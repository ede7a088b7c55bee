#[path = "../tests/common/patch_reference.rs"]
mod patch_reference;
use kstrip::contact::forces::StripCount;
use kstrip::solve::model::Model;
use patch_reference::*;
fn cpu() -> f64 {
    std::fs::read_to_string("/proc/self/schedstat")
        .unwrap()
        .split(' ')
        .next()
        .unwrap()
        .parse::<f64>()
        .unwrap()
        / 1e3
}
fn main() {
    let cases = profiles();
    for count in [StripCount::Sixteen, StripCount::ThirtyTwo] {
        for _ in 0..3 {
            let t = cpu();
            let mut n = 0;
            let mut s = 0.0;
            for _ in 0..30 {
                for case in &cases {
                    s += case.patch(count).1.approach;
                    n += 1;
                }
            }
            let built = (cpu() - t) / n as f64;
            let patches: Vec<_> = cases.iter().map(|c| c.patch(count).0).collect();
            let t = cpu();
            let mut n = 0;
            for _ in 0..20 {
                for (case, patch) in cases.iter().zip(&patches) {
                    for m in &case.motions {
                        s += kstrip::patch::solver::solve(
                            &patch.view().unwrap(),
                            &case.creepage(m),
                            Model::Strip,
                        )
                        .unwrap()
                        .fx;
                        n += 1;
                    }
                }
            }
            let solved = (cpu() - t) / n as f64;
            let c = kstrip::contact::Contact {
                a: 6e-3,
                b: 5e-3,
                normal_force: 80e3,
                shear_modulus: 82e9,
                poisson_ratio: 0.28,
                friction: 0.3,
            };
            let o = kstrip::solve::model::Options { model: Model::Strip, strips: count };
            let t = cpu();
            let mut n = 0;
            for _ in 0..20 {
                for case in &cases {
                    for m in &case.motions {
                        s += kstrip::solve::model::solve(&c, &case.creepage(m), &o).unwrap().fx;
                        n += 1;
                    }
                }
            }
            println!(
                "{count:?}: {built:.1} us built, {solved:.2} solved, contact {:.2} ({s:.1})",
                (cpu() - t) / n as f64
            );
        }
    }
}
