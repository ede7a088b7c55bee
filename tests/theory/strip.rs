//! One strip of the theory (Sections 4 to 6).

use kstrip::strip_1967::strip::adhesion_length;
use kstrip_testing::prelude::*;

const RULES: [SlidingRule; 2] = [SlidingRule::RigidSlip, SlidingRule::Continuous];

/// A random strip: half of them with |ψ| < 1, the others around and beyond 1.
fn random_strip(random: &mut Random) -> Strip<f64> {
    let psi = random.sign()
        * match random.bits() % 4 {
            0 | 1 => random.unit(),
            2 => 1.0 + random.log_between(1e-12, 0.2) * random.sign(),
            _ => random.between(1.0, 1.3),
        };
    let mut eta = random.sign() * random.log_between(1e-6, 1.5);
    if psi.abs() > 1.0 && random.unit() < 0.8 {
        eta = -eta.abs() * psi.signum();
    }
    let xi_bar =
        if random.unit() < 0.1 { 0.0 } else { random.sign() * random.log_between(1e-6, 1.5) };
    let rule = RULES[(random.bits() % 2) as usize];
    Strip::solve(random.log_between(1e-3, 1.0), xi_bar, eta, psi, random.between(0.0, 0.5), rule)
}

/// κ, α and β + ψ against 60-digit roots of ξ̄² + (η + ψκ)² = κ², also where ηψ → −S and ψ → 1.
#[test]
fn adhesion_length_agrees_with_high_precision() {
    let mut rows = 0;
    for n in numbers("strip.csv") {
        let [xi_bar, eta, psi, kappa, _, _, condition] = n;
        if kappa > 1e100 {
            // Longer than any strip, and its exact length is nobody's concern
            assert!(adhesion_length(xi_bar, eta, psi).unwrap() > 1e100, "{n:?}");
            continue;
        }
        // Rounding of S² where it is a small difference, halved by the root
        let allowed = 2e-15 + 2e-16 * condition;
        // As a strip wide enough to adhere, in which nothing may underflow
        if psi.abs() <= 1.0 {
            let strip = Strip::solve(2.0 * kappa, xi_bar, eta, psi, 0.28, SlidingRule::RigidSlip);
            let Regime::Adhesion { kappa: got, alpha, beta_plus_psi } = strip.regime else {
                panic!("{n:?}: {strip:?}");
            };
            assert!((got / kappa - 1.0).abs() <= allowed, "{n:?}: {got:e}");
            assert!((alpha - n[4]).abs() <= allowed, "{n:?}: alpha {alpha:e}");
            assert!((beta_plus_psi - n[5]).abs() <= 2.0 * allowed, "{n:?}: {beta_plus_psi:e}");
        }
        // The bare formula serves creepages whose squares are numbers.
        if xi_bar.abs().max(eta.abs()) > 1e-150 {
            let got = adhesion_length(xi_bar, eta, psi).unwrap();
            assert!((got / kappa - 1.0).abs() <= allowed, "{n:?}: {got:e}");
        }
        rows += 1;
    }
    assert!(rows > 200);
}

/// No root, no adhesion: beyond unit spin with lateral creepage of the wrong sign, or too little.
#[test]
fn strips_without_root_slide() {
    for (xi_bar, eta, psi) in
        [(0.1, 0.5, 1.0), (0.1, 0.5, 1.5), (0.1, -0.5, -1.0), (0.5, -0.1, 2.0), (0.5, 0.0, 1.0)]
    {
        assert_eq!(adhesion_length(xi_bar, eta, psi), None, "{xi_bar} {eta} {psi}");
        for rule in RULES {
            assert!(!Strip::solve(1.0, xi_bar, eta, psi, 0.28, rule).adheres());
        }
    }
}

/// α² + (β + ψ)² = 1 in every strip, and a unit direction where it slides.
#[test]
fn traction_behind_the_separatrix_is_on_the_bound() {
    let mut random = Random::new(540);
    let mut adhering = 0;
    for _ in 0..100_000 {
        let strip = random_strip(&mut random);
        let (x, y) = match strip.regime {
            Regime::Adhesion { alpha, beta_plus_psi, .. } => {
                adhering += 1;
                (alpha, beta_plus_psi)
            }
            Regime::Sliding { direction_x, direction_y } => (direction_x, direction_y),
        };
        // β + ψ is a difference of numbers up to |ψ|/(1 − |ψ|) ~ 1/κ; in the worst case a digit or
        // two go. For |ψ| > 1 the root S of a small difference takes more.
        let allowed = if strip.psi.abs() > 1.0 { 1e-7 } else { 1e-13 };
        assert!((x.hypot(y) - 1.0).abs() <= allowed, "{strip:?}");
    }
    assert!(adhering > 20_000);
}

/// The traction is continuous where slip begins, and so is the slip.
#[test]
fn traction_is_continuous_at_the_separatrix() {
    let mut random = Random::new(1967);
    let mut tested = 0;
    while tested < 5_000 {
        let strip = random_strip(&mut random);
        if !strip.adheres() || strip.half_length - strip.separatrix() < 1e-3 * strip.half_length {
            continue;
        }
        tested += 1;
        let (x, c) = (strip.separatrix(), strip.half_length);
        let step = 1e-12 * c;
        let (behind, ahead) = (strip.at(x - step), strip.at(x + step));
        // The traction leaves the bound like a square root: √(1e-12) times its amplitude, which is
        // at most about 2 |β| there.
        let amplitude = match strip.regime {
            Regime::Adhesion { kappa, .. } => {
                (strip.xi_bar.abs() + strip.eta.abs()) / kappa.max(1e-300) + 1.0
            }
            Regime::Sliding { .. } => unreachable!(),
        };
        let allowed = 1e-5 * c * amplitude;
        assert!((behind.traction_x - ahead.traction_x).abs() <= allowed, "{strip:?}");
        assert!((behind.traction_y - ahead.traction_y).abs() <= allowed, "{strip:?}");
        assert!(behind.slip_x.hypot(behind.slip_y) <= allowed, "{strip:?}");
        assert_eq!((ahead.slip_x, ahead.slip_y), (0.0, 0.0));
        if strip.separatrix() - step > -c {
            assert_ne!(behind.state, State::Stick);
        }
        assert_eq!(ahead.state, State::Stick);
    }
}

/// `PV ∫ f(t)/(x − t) dt` over the strip by quadrature of the traction itself.
fn principal_value(strip: &Strip<f64>, x: f64, f: impl Fn(f64) -> f64) -> f64 {
    let c = strip.half_length;
    let at_x = f(x);
    let mut cuts = [-c, strip.separatrix(), x, c];
    cuts.sort_by(f64::total_cmp);
    let regular: f64 = cuts
        .windows(2)
        .filter(|piece| piece[1] - piece[0] > 1e-12)
        .map(|piece| theory::between(|t| (f(t) - at_x) / (x - t), piece[0], piece[1], 48))
        .sum();
    regular + at_x * ((x + c) / (c - x)).ln()
}

/// The elastic field of the computed traction, from Section 3, gives the slip that the strip
/// reports: none in the adhesion area, the stated one behind it and in sliding strips.
#[test]
fn slip_is_that_of_the_elastic_field_of_the_traction() {
    let cases = [
        // C, ξ̄, η, ψ
        (1.0, 0.3, 0.2, 0.0),
        (0.8, -0.3, 0.2, 0.4),
        (1.0, 0.0, -0.5, 1.0),
        (0.9, 0.2, 0.3, -0.7),
        (1.0, 0.1, 0.0, 0.6),
        (0.5, 0.05, -0.12, 0.95),
        (0.6, 0.02, -0.4, 1.2),
        (1.0, 0.9, 0.8, 0.3),
        (0.4, -0.7, 0.1, -1.5),
    ];
    let (mut stuck, mut slid) = (0, 0);
    for (c, xi_bar, eta, psi) in cases {
        for rule in RULES {
            let nu = 0.28;
            let strip = Strip::solve(c, xi_bar, eta, psi, nu, rule);
            for i in 1..20 {
                let x = -c + 2.0 * c * f64::from(i) / 20.0 + 0.001;
                let point = strip.at(x);
                let along = principal_value(&strip, x, |t| strip.at(t).traction_x);
                let across = principal_value(&strip, x, |t| strip.at(t).traction_y);
                // s_x = υx − φy + du/dx, in units of 2μp₀/G
                let slip_x = (1.0 - nu) * (xi_bar - along / PI);
                let spin = if strip.adheres() { psi.clamp(-1.0, 1.0) } else { psi };
                let slip_y = eta + spin * x - across / PI;
                // Quadrature of an integrand with a removable singularity
                assert!((slip_x - point.slip_x).abs() < 4e-15, "{strip:?} {x}: {slip_x:e}");
                assert!((slip_y - point.slip_y).abs() < 1e-9, "{strip:?} {x}: {slip_y:e}");
                if point.state == State::Stick { stuck += 1 } else { slid += 1 }
            }
        }
    }
    assert!(stuck > 40 && slid > 80, "{stuck} {slid}");
}

/// Behind the separatrix the slip has the sense of the traction on the lower body: along x always,
/// and the angle between both is at most asin|ψ| (Table 4).
#[test]
fn slip_has_the_sense_of_the_traction() {
    let mut random = Random::new(4);
    for _ in 0..20_000 {
        let strip = random_strip(&mut random);
        if !strip.adheres() || strip.psi.abs() > 1.0 {
            continue;
        }
        let x = -strip.half_length
            + 2.0 * random.unit() * (strip.separatrix() + strip.half_length) / 2.0;
        let point = strip.at(x);
        if point.state == State::Stick || point.traction_x.hypot(point.traction_y) == 0.0 {
            continue;
        }
        assert_ne!(point.state, State::SlipNegativeDissipation, "{strip:?}");
        assert!(point.traction_x * point.slip_x >= 0.0, "{strip:?}");
        // s ~ ((1 − ν) α, β): without the factor 1 − ν its angle to (α, β + ψ) is bounded by
        // asin|ψ|
        let (sx, sy) = (point.slip_x / (1.0 - strip.poisson_ratio), point.slip_y);
        let cosine = (sx * point.traction_x + sy * point.traction_y)
            / (sx.hypot(sy) * point.traction_x.hypot(point.traction_y));
        let largest = (1.0 - strip.psi * strip.psi).max(0.0).sqrt();
        if sx.hypot(sy) > 1e-12 {
            assert!(cosine >= largest - 1e-6, "{strip:?}: {cosine} {largest}");
        }
    }
}

/// Force, moment and dissipation of a strip are the integrals of its traction and local
/// dissipation: Section 5 and the power balance, to 1e-10.
#[test]
fn strip_totals_are_the_integrals_of_its_field() {
    let mut random = Random::new(71);
    for _ in 0..2_000 {
        let strip = random_strip(&mut random);
        let c = strip.half_length;
        let integral = |f: &dyn Fn(f64) -> f64| {
            let cut = strip.separatrix().clamp(-c, c);
            let mut sum = theory::between(f, -c, cut, 40);
            // Ahead of a separatrix close to the trailing edge both square roots are near: pieces
            // that grow with the distance.
            let (mut low, mut step) = (cut, 0.5 * (cut + c).max(1e-9 * c));
            while low < c {
                let high = if low + 3.0 * step < c { low + step } else { c };
                sum += theory::between(f, low, high, 40);
                (low, step) = (high, 3.0 * step);
            }
            sum
        };
        // F/(μN) = (3/4) ∫ f dY and F = ∫∫ X dx dy give f = (2/π) ∫ X dx
        let unit = 2.0 / PI;
        let fx = unit * integral(&|x| strip.at(x).traction_x);
        let fy = unit * integral(&|x| strip.at(x).traction_y);
        let mx = unit * integral(&|x| x * strip.at(x).traction_y);
        let power = unit * integral(&|x| strip.at(x).dissipation());
        let (force, moment) = (strip.force(), strip.moment());
        // Relative to the friction capacity C² of the strip, the size of its rounding
        let capacity = c * c;
        assert!((fx - force.0).abs() < 2e-14 * capacity, "{strip:?}: {fx} {force:?}");
        assert!((fy - force.1).abs() < 3e-14 * capacity, "{strip:?}: {fy} {force:?}");
        assert!((mx - moment).abs() < 4e-15 * capacity, "{strip:?}: {mx} {moment}");
        let size = capacity * (strip.xi_bar.abs() + strip.eta.abs() + (strip.psi * c).abs());
        // S loses digits just above unit spin, and with it the dissipation
        let allowed = if strip.psi.abs() > 1.0 { 1e-7 } else { 1e-10 };
        assert!(
            (power - strip.dissipation()).abs() < allowed * size,
            "{strip:?}: {power:e} {:e}",
            strip.dissipation()
        );
    }
}

/// Where a strip loses its adhesion area (κ = C) the continuous rule joins without a jump; the
/// direction of the rigid slip jumps unless there is no spin and ν = 0.
#[test]
fn sliding_rules_join_or_jump_as_stated() {
    let mut random = Random::new(6);
    let mut jumps = 0;
    for _ in 0..5_000 {
        let (xi_bar, eta) = (random.between(-0.7, 0.7), random.between(-0.7, 0.7));
        let (psi, nu) = (random.between(-0.9, 0.9), random.between(0.0, 0.5));
        let kappa = adhesion_length(xi_bar, eta, psi).unwrap();
        let solve = |c: f64, rule| Strip::solve(c, xi_bar, eta, psi, nu, rule);
        let sides = |rule| {
            let (sticks, slides) =
                (solve(kappa * (1.0 + 1e-9), rule), solve(kappa * (1.0 - 1e-9), rule));
            assert!(sticks.adheres() && !slides.adheres());
            let x = -0.3 * kappa;
            let (one, two) = (sticks.at(x), slides.at(x));
            let traction = (one.traction_x - two.traction_x).hypot(one.traction_y - two.traction_y);
            traction / kappa
        };
        // √(1e-9) from the square root at the separatrix would be 3e-5; at this x it is far ahead.
        assert!(sides(SlidingRule::Continuous) < 1e-7);
        // (8.) the rigid-slip rule: ((1 − ν) ξ̄, η) against (ξ̄, η + ψκ)
        let (x1, y1) = ((1.0 - nu) * xi_bar, eta);
        let (x2, y2) = (xi_bar, eta + psi * kappa);
        let (l1, l2) = (x1.hypot(y1), x2.hypot(y2));
        let expected = (x1 / l1 - x2 / l2).hypot(y1 / l1 - y2 / l2) * 0.91f64.sqrt();
        let jump = sides(SlidingRule::RigidSlip);
        assert!((jump - expected).abs() < 2e-13, "{jump} {expected}");
        jumps += usize::from(jump > 0.1);
    }
    assert!(jumps > 1_000);
}
