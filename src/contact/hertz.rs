//! The contact ellipse of Hertz (Section 2).

use crate::contact::elliptic::Integrals;
use crate::contact::material::{check_modulus, check_poisson_ratio};
use crate::number::Float;
use crate::status::Error;

/// Radii of curvature of the two surfaces \[m\]: convex positive, flat infinite, concave negative.
///
/// `x` is the rolling direction, so a wheel has its rolling radius in `x` and its profile radius in
/// `y`; a straight rail is infinite in `x`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Radii<F> {
    /// Lower body, in the plane through the rolling direction: `Rx⁺`.
    pub lower_x: F,
    /// Lower body, across the rolling direction: `Ry⁺`.
    pub lower_y: F,
    /// Upper body, in the plane through the rolling direction: `Rx⁻`.
    pub upper_x: F,
    /// Upper body, across the rolling direction: `Ry⁻`.
    pub upper_y: F,
}

/// The solution of Hertz's problem.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HertzContact<F> {
    /// Semi-axis along the rolling direction `x` \[m\].
    pub a: F,
    /// Semi-axis across it, along `y` \[m\].
    pub b: F,
    /// Pressure at the centre `p₀` \[Pa\].
    pub peak_pressure: F,
    /// Approach of distant points of the two bodies `δ` \[m\].
    pub approach: F,
    /// Axis ratio `g = s/l`, the minor over the major semi-axis, in `(0, 1]` (2.2).
    pub axis_ratio: F,
    /// Hertz's angle `τ` \[rad\], `0 … π/2` (2.5).
    pub hertz_angle: F,
    /// `ρ` \[m\], four over the sum of the curvatures (2.3): the diameter for a sphere on a plane.
    pub rho: F,
}

/// Newton steps at most; five reach rounding from the starting value for any axis ratio.
const NEWTON_STEPS: usize = 12;

/// Contact ellipse, pressure and approach under a normal load `N ≥ 0` \[N\].
///
/// `shear_modulus` \[Pa\] and `poisson_ratio` are the combined constants of
/// [`combine`](crate::contact::material::combine). Without load the ellipse is a point: `a = b = 0`.
///
/// # Errors
/// [`Error::Curvature`] for a zero or NaN radius, or when the bodies do not touch in an ellipse
/// (summed curvature not positive in both directions); [`Error::NormalForce`], [`Error::Modulus`],
/// [`Error::PoissonRatio`], [`Error::NotFinite`]; [`Error::Overflow`] when a result does not fit the
/// floating-point type.
///
/// # Example
/// Steel ball of 1 m radius on a plane, `a³ = 3 N R/(4 E*)`:
/// ```
/// use kstrip::contact::hertz::{hertz, Radii};
/// let flat = f64::INFINITY;
/// let radii = Radii { lower_x: flat, lower_y: flat, upper_x: 1.0, upper_y: 1.0 };
/// let ball = hertz(&radii, 80e3, 82e9, 0.28)?;
/// let expected = (3.0 * 80e3 * (1.0 - 0.28) / (4.0 * 82e9_f64)).cbrt();
/// assert!((ball.a - expected).abs() < 1e-12 * expected && ball.a == ball.b);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn hertz<F: Float>(
    radii: &Radii<F>,
    normal_force: F,
    shear_modulus: F,
    poisson_ratio: F,
) -> Result<HertzContact<F>, Error> {
    check_modulus(shear_modulus)?;
    check_poisson_ratio(poisson_ratio)?;
    if !normal_force.is_finite_number() {
        return Err(Error::NotFinite);
    }
    if normal_force < F::zero() {
        return Err(Error::NormalForce);
    }
    // A = (1/Rx⁺ + 1/Rx⁻)/2,  B = (1/Ry⁺ + 1/Ry⁻)/2
    let half_curvature = |lower: F, upper: F| (F::one() / lower + F::one() / upper).times(0.5);
    let curvature_x = half_curvature(radii.lower_x, radii.upper_x);
    let curvature_y = half_curvature(radii.lower_y, radii.upper_y);
    let usable = |curvature: F| curvature.is_finite_number() && curvature > F::zero();
    if !usable(curvature_x) || !usable(curvature_y) {
        return Err(Error::Curvature);
    }
    let (small, large) = (curvature_x.min(curvature_y), curvature_x.max(curvature_y));

    // B/A = [(l/s)² E − K]/[K − E], which in the integrals of `elliptic` is A/B = g² D/B.
    let axis_ratio = axis_ratio(small / large);
    let integrals = Integrals::at(axis_ratio);

    // E* = G/(1 − ν)
    let modulus = shear_modulus / (F::one() - poisson_ratio);
    // √(AB) = (p₀/E*)(s/(l² e²)) √{[(l/s)² E − K][K − E]} with p₀ = 3N/(2π l s) gives
    // l³ = (3N/(2π g E*)) √(BD/(AB)).
    let shape = (integrals.b * integrals.d).sqrt() / (small.sqrt() * large.sqrt());
    let major = normal_force.cube_root()
        * (F::constant(1.5 / core::f64::consts::PI) / axis_ratio).cube_root()
        * (shape / modulus).cube_root();
    let minor = axis_ratio * major;
    // p₀ = 3N/(2π a b), written as the curvature that it flattens so that N = 0 is no 0/0:
    // p₀ = E* l √(AB)/√(BD)
    let peak_pressure = modulus * (major / shape);
    // δ = (p₀/E*) s K
    let approach = (major / shape) * minor * integrals.k();
    // The larger curvature belongs to the shorter semi-axis (2.4).
    let (a, b) = if curvature_x < curvature_y { (major, minor) } else { (minor, major) };
    // 1/ρ = (1/Rx⁺ + 1/Rx⁻ + 1/Ry⁺ + 1/Ry⁻)/4   (2.3)
    let rho = F::constant(2.0) / (small + large);
    // cos τ = (ρ/4) |(1/Rx⁺ + 1/Rx⁻) − (1/Ry⁺ + 1/Ry⁻)|   (2.5), as tan(τ/2) = √(A/B)
    let hertz_angle = (small / large).sqrt().atan().times(2.0);
    let results = [major, minor, peak_pressure, approach, rho];
    if !results.iter().all(|result| result.is_finite_number()) || axis_ratio <= F::zero() {
        return Err(Error::Overflow);
    }
    Ok(HertzContact { a, b, peak_pressure, approach, axis_ratio, hertz_angle, rho })
}

/// The axis ratio `g` for a ratio of curvatures `A/B = g² D(g)/B(g)`, both in `(0, 1]`.
fn axis_ratio<F: Float>(ratio: F) -> F {
    if ratio >= F::one() {
        return F::one();
    }
    // Start: g ≈ (A/B)^(5/8), within a quarter for all but needles.
    let root = ratio.sqrt();
    let mut g = root * root.sqrt().sqrt();
    for _ in 0..NEWTON_STEPS {
        let i = Integrals::at(g);
        let (squared, c) = (g * g, i.c(g));
        let error = ratio / (squared * (i.d / i.b)) - F::one();
        // d ln(A/B)/d ln g = 2 − (B − g² C)/D + g² C/B
        let slope = F::constant(2.0) - (i.b - squared * c) / i.d + squared * c / i.b;
        let step = (error / slope).clamped(F::constant(-0.5), F::constant(1.0));
        g = (g + g * step).min(F::one());
        if step.abs() <= F::EPSILON.times(4.0) {
            break;
        }
    }
    g
}
