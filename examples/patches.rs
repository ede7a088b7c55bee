#[path = "../tests/common/patch_reference.rs"]
mod patch_reference;
use kstrip::contact::forces::StripCount;
use kstrip::solve::model::Model;
use patch_reference::*;
use std::time::Instant;
fn main() {
    let cases = profiles();
    for count in [StripCount::Sixteen, StripCount::ThirtyTwo] {
        let mut all = Errors::default();
        let mut families: Vec<(String, Errors)> = vec![];
        let (mut area, mut peak, mut approach) = (vec![], vec![], vec![]);
        for case in &cases {
            let (patch, found) = case.patch(count);
            let view = patch.view().unwrap();
            let e = case.errors(&patch, Model::Strip);
            let da = view.area() / case.area - 1.0;
            let dp = found.peak_pressure / case.peak_pressure - 1.0;
            let dd = found.approach / case.approach - 1.0;
            area.push(da.abs());
            peak.push(dp.abs());
            approach.push(dd.abs());
            if std::env::args().count() > 1 {
                println!(
                    "{:16} {:2} lobes {} area {:6.1} p {:6.1} d {:6.1} K {:.3} F {:.4} {:.4} M {:.4} it {}",
                    case.name,
                    patch.strips.len(),
                    view.lobes().count(),
                    da * 100.,
                    dp * 100.,
                    dd * 100.,
                    found.stiffness * found.approach / case.load,
                    statistics(&e.force)[0],
                    statistics(&e.force)[2],
                    statistics(&e.moment)[2],
                    found.iterations
                );
            }
            match families.iter_mut().find(|f| f.0 == case.family) {
                Some(f) => f.1.extend(e.clone()),
                None => families.push((case.family.clone(), e.clone())),
            }
            all.extend(e);
        }
        println!(
            "{count:?}: F {:.4?} M {:.4?} area {:.3?} peak {:.3?} approach {:.3?}",
            statistics(&all.force),
            statistics(&all.moment),
            statistics(&area),
            statistics(&peak),
            statistics(&approach)
        );
        for (f, e) in &families {
            println!("   {f:12} {:.4?}", statistics(&e.force));
        }
        let mut t = Errors::default();
        for case in &cases {
            t.extend(case.errors(&case.reference_patch(), Model::Strip));
        }
        println!("exact strips F {:.4?} M {:.4?}", statistics(&t.force), statistics(&t.moment));
        let mut t = Errors::default();
        for (case, patch) in given() {
            let e = case.errors(&patch, Model::Strip);
            if std::env::args().count() > 1 {
                println!(
                    "  {:20} {:.4?} M {:.4?}",
                    case.name,
                    statistics(&e.force),
                    statistics(&e.moment)
                );
            }
            t.extend(e);
        }
        println!("given F {:.4?} M {:.4?}", statistics(&t.force), statistics(&t.moment));
        let mut t = Errors::default();
        for (case, patch) in banded(count) {
            let e = case.errors(&patch, Model::Strip);
            if std::env::args().count() > 1 {
                println!("  {:20} {:.4?}", case.name, e.force);
            }
            t.extend(e);
        }
        println!("banded F {:.4?} M {:.4?}", statistics(&t.force), statistics(&t.moment));
        let start = Instant::now();
        let mut n = 0;
        let mut s = 0.0;
        for _ in 0..20 {
            for case in &cases {
                s += case.patch(count).1.approach;
                n += 1;
            }
        }
        println!("{:.1} us a patch ({s:.3})", start.elapsed().as_secs_f64() * 1e6 / n as f64);
    }
}
