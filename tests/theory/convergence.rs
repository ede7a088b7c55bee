//! Quadrature over strips against the closed form (7.1).

use kstrip::contact::creepage::Parameters;
use kstrip::contact::forces::StripCount;
use kstrip::strip_1967::closed_form;
use kstrip::strip_1967::strip::SlidingRule;
use kstrip::strip_1967::totals::StripTheory;

use crate::random;
use random::Random;

/// a/b .1..10, nu 0..0.5, |xi|, |eta| <= 1 with eta also log-uniform down to 0, |psi| <= .95.
fn sample(random: &mut Random) -> Parameters<f64> {
    let eta = if random.unit() < 0.5 {
        random.between(-1.0, 1.0)
    } else {
        random.sign() * 10f64.powf(random.between(-12.0, 0.0))
    };
    Parameters {
        xi: random.between(-1.0, 1.0),
        eta,
        psi: random.between(-0.95, 0.95),
        poisson_ratio: random.between(0.0, 0.5),
        axis_ratio: 10f64.powf(random.between(-1.0, 1.0)),
    }
}

fn errors(count: StripCount) -> Vec<f64> {
    let mut random = Random::new(1967);
    let mut errors: Vec<f64> = (0..10_000)
        .map(|_| {
            let parameters = sample(&mut random);
            let exact = closed_form::force(&parameters).unwrap();
            let totals = StripTheory::new(&parameters, SlidingRule::RigidSlip).totals(count);
            let error = (totals.fx - exact.0).hypot(totals.fy - exact.1);
            assert!(error.is_finite(), "{parameters:?}");
            error
        })
        .collect();
    errors.sort_by(f64::total_cmp);
    errors
}

#[test]
fn quadrature_converges_to_the_closed_form() {
    for (count, median, p95, worst) in [
        (StripCount::Four, 1.0, 1.0, 1.0),
        (StripCount::Eight, 1.0, 1.0, 1.0),
        (StripCount::Sixteen, 3e-5, 1e-3, 5e-3),
        (StripCount::ThirtyTwo, 1.0, 1.0, 1.0),
        (StripCount::SixtyFour, 1e-10, 2e-6, 1e-4),
    ] {
        let errors = errors(count);
        let (m, p, w) = (errors[5_000], errors[9_500], errors[9_999]);
        println!("{:>2} strips: median {m:.1e}, 95 % {p:.1e}, worst {w:.1e}", count as i32);
        assert!(m <= median && p <= p95 && w <= worst, "{count:?}: {m:.2e} {p:.2e} {w:.2e}");
    }
}
