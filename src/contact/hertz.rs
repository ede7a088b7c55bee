//! The contact ellipse of Hertz (Section 2), from the load or from the approach of the bodies.

use crate::contact::Contact;
use crate::contact::elliptic::Integrals;
use crate::contact::material::{CombinedMaterial, check_modulus, check_poisson_ratio};
use crate::contact::plausibility::SMALLEST_CURVATURE;
use crate::number::{Float, are_finite};
use crate::status::{Error, Warning};

/// Largest semi-axis, divided by the smaller radius in its direction, for bodies that count as
/// half-spaces.
const LARGEST_OPENING: f64 = 0.3;

/// Radii of curvature of two bodies at the contact \[m\]: convex positive, flat infinite
/// (INFINITY), concave negative. KSTRIP_ERROR_CURVATURE if one is 0 or NaN, or if the curvatures of
/// both bodies in one plane add up to 0 or less; KSTRIP_WARNING_RADIUS if they are those of radii
/// above 5 m in both planes.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Radii<F> {
    /// Lower body in the plane of x and z (a straight rail: INFINITY).
    pub lower_x: F,
    /// Lower body in the plane of y and z (a rail: radius of the head).
    pub lower_y: F,
    /// Upper body in the plane of x and z (a wheel: rolling radius).
    pub upper_x: F,
    /// Upper body in the plane of y and z (a wheel: radius of the profile, INFINITY if conical).
    pub upper_y: F,
}

/// The contact ellipse of Hertz.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HertzContact<F> {
    /// Semi-axis along the rolling direction x \[m\].
    pub a: F,
    /// Semi-axis along y \[m\].
    pub b: F,
    /// Pressure at the centre \[Pa\].
    pub peak_pressure: F,
    /// Approach of distant points of the two bodies \[m\].
    pub approach: F,
    /// Minor divided by major semi-axis \[-\], 0 to 1 (2.2).
    pub axis_ratio: F,
    /// Hertz's angle tau \[rad\], 0 to pi/2 (2.5).
    pub hertz_angle: F,
    /// Four divided by the sum of the four curvatures \[m\] (2.3).
    pub rho: F,
}

/// Contact ellipse, pressure and approach under a normal load `N` \[N\].
///
/// `shear_modulus` \[Pa\] and `poisson_ratio` are the combined constants of
/// [`combine`](crate::contact::material::combine). Without load, `N ≤ 0`, the ellipse is a point:
/// `a = b = 0`.
///
/// # Errors
/// [`Error::Curvature`] for a zero or NaN radius, or when the bodies do not touch in an ellipse
/// (summed curvature not positive in both directions); [`Error::Modulus`], [`Error::PoissonRatio`],
/// [`Error::NotFinite`]; [`Error::Overflow`] when a result does not fit the floating-point type.
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
    radii: &Radii<F>, normal_force: F, shear_modulus: F, poisson_ratio: F,
) -> Result<HertzContact<F>, Error> {
    let modulus = plane_strain_modulus(shear_modulus, poisson_ratio)?;
    Error::NotFinite.unless(normal_force.is_finite_number())?;
    Form::new(radii)?.loaded_by(normal_force.max(F::zero()), modulus)
}

/// The contact of two bodies under a load \[N\], with Hertz's solution and whether the numbers are
/// plausible.
///
/// Without load, `N ≤ 0`, contact is lost: `a`, `b` and the contact's normal force are zero.
///
/// # Errors
/// Those of [`hertz`] and of [`Contact::check`].
pub fn from_hertz<F: Float>(
    radii: &Radii<F>, pair: &CombinedMaterial<F>, load: F, friction: F,
) -> Result<(Contact<F>, HertzContact<F>, Warning), Error> {
    let modulus = plane_strain_modulus(pair.shear_modulus, pair.poisson_ratio)?;
    Error::NotFinite.unless(load.is_finite_number())?;
    let (form, normal_force) = (Form::new(radii)?, load.max(F::zero()));
    let hertz = form.loaded_by(normal_force, modulus)?;
    let (contact, warning) =
        form.loaded([hertz.a, hertz.b], radii, pair, normal_force, friction)?;
    Ok((contact, hertz, warning))
}

/// The contact of two bodies whose distant points have come closer by `approach` \[m\]: the inverse
/// of [`from_hertz`], for the contact search of a multibody program. Also returns the stiffness
/// `dN/dδ = 3N/(2δ)` \[N/m\], and whether the numbers are plausible.
///
/// Without approach, `δ ≤ 0`, contact is lost: `a`, `b`, normal force and stiffness are zero.
///
/// # Errors
/// Those of [`from_hertz`].
///
/// # Example
/// ```
/// use kstrip::contact::{hertz::{from_approach, from_hertz, Radii}, material::{combine, Material}};
/// let steel = Material { shear_modulus: 82e9, poisson_ratio: 0.28 };
/// let flat = f64::INFINITY;
/// let radii = Radii { lower_x: flat, lower_y: 0.30, upper_x: 0.46, upper_y: flat };
/// let pair = combine(&steel, &steel)?;
/// let (_, hertz, _) = from_hertz(&radii, &pair, 80e3, 0.3)?;
/// let (contact, stiffness, _) = from_approach(&radii, &pair, hertz.approach, 0.3)?;
/// assert!((contact.normal_force - 80e3).abs() < 1e-9);
/// assert!((stiffness * hertz.approach - 1.5 * 80e3).abs() < 1e-9);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn from_approach<F: Float>(
    radii: &Radii<F>, pair: &CombinedMaterial<F>, approach: F, friction: F,
) -> Result<(Contact<F>, F, Warning), Error> {
    let modulus = plane_strain_modulus(pair.shear_modulus, pair.poisson_ratio)?;
    Error::NotFinite.unless(approach.is_finite_number())?;
    let approach = approach.max(F::zero());
    let form = Form::new(radii)?;
    let Form { axis_ratio, integrals, scale, .. } = form;
    // δ = (p₀/E*) s K with p₀ = E* l √(AB)/√(BD):  l² = δ √(BD/(AB))/(g K)
    let major = approach.sqrt() * (scale / (axis_ratio * integrals.k())).sqrt();
    // dN/dδ = 3N/(2δ) = π E* l/K
    let stiffness = modulus.times(core::f64::consts::PI) * (major / integrals.k());
    let normal_force = (stiffness * approach).times(2.0 / 3.0);
    let [a, b] = form.axes(major);
    Error::Overflow.unless(are_finite(&[a, b, stiffness, normal_force]))?;
    let (contact, warning) = form.loaded([a, b], radii, pair, normal_force, friction)?;
    Ok((contact, stiffness, warning))
}

impl<F: Float> Contact<F> {
    /// Whether a semi-axis is so long compared with the radii in its direction that the bodies are
    /// not half-spaces.
    fn is_conformal(&self, radii: &Radii<F>) -> bool {
        let Radii { lower_x, lower_y, upper_x, upper_y } = *radii;
        let opens = |axis: F, lower: F, upper: F| {
            axis > lower.abs().min(upper.abs()).times(LARGEST_OPENING)
        };
        opens(self.a, lower_x, upper_x) || opens(self.b, lower_y, upper_y)
    }
}

/// `E* = G/(1 − ν)`
fn plane_strain_modulus<F: Float>(shear_modulus: F, poisson_ratio: F) -> Result<F, Error> {
    check_modulus(shear_modulus)?;
    check_poisson_ratio(poisson_ratio)?;
    Ok(shear_modulus / (F::one() - poisson_ratio))
}

/// The shape of the ellipse, which depends on the radii alone.
#[derive(Clone, Copy)]
struct Form<F> {
    /// The smaller of `A = (1/Rx⁺ + 1/Rx⁻)/2` and `B = (1/Ry⁺ + 1/Ry⁻)/2` \[1/m\].
    small: F,
    /// The larger \[1/m\].
    large: F,
    /// Whether the ellipse is longer along `x`.
    along: bool,
    /// `g = s/l`
    axis_ratio: F,
    integrals: Integrals<F>,
    /// `√(BD/(AB))` \[m\], of the integrals `B`, `D` over the curvatures: what
    /// `√(AB) = (p₀/E*)(s/(l² e²)) √{[(l/s)² E − K][K − E]}` is in them, `l E*/p₀`.
    scale: F,
}

impl<F: Float> Form<F> {
    fn new(radii: &Radii<F>) -> Result<Self, Error> {
        // A = (1/Rx⁺ + 1/Rx⁻)/2,  B = (1/Ry⁺ + 1/Ry⁻)/2
        let half_curvature = |lower: F, upper: F| (F::one() / lower + F::one() / upper).times(0.5);
        let curvature_x = half_curvature(radii.lower_x, radii.upper_x);
        let curvature_y = half_curvature(radii.lower_y, radii.upper_y);
        let usable = |curvature: F| curvature.is_finite_number() && curvature > F::zero();
        Error::Curvature.unless(usable(curvature_x) && usable(curvature_y))?;
        let (small, large) = (curvature_x.min(curvature_y), curvature_x.max(curvature_y));
        // B/A = [(l/s)² E − K]/[K − E], which in the integrals of `elliptic` is A/B = g² D/B.
        let axis_ratio = axis_ratio(small / large);
        Error::Overflow.unless(axis_ratio > F::zero())?;
        let integrals = Integrals::at(axis_ratio);
        let scale = (integrals.b * integrals.d).sqrt() / (small.sqrt() * large.sqrt());
        // The larger curvature belongs to the shorter semi-axis (2.4).
        let along = curvature_x < curvature_y;
        Ok(Self { small, large, along, axis_ratio, integrals, scale })
    }

    /// Hertz's solution for a load that is not negative and `E*`.
    fn loaded_by(&self, normal_force: F, modulus: F) -> Result<HertzContact<F>, Error> {
        let Self { small, large, axis_ratio, integrals, scale, .. } = *self;
        // l³ = (3N/(2π g E*)) √(BD/(AB))
        let major = normal_force.cube_root()
            * (F::constant(1.5 / core::f64::consts::PI) / axis_ratio).cube_root()
            * (scale / modulus).cube_root();
        let minor = axis_ratio * major;
        // p₀ = 3N/(2π a b), written as the curvature that it flattens so that N = 0 is no 0/0:
        // p₀ = E* l √(AB)/√(BD)
        let peak_pressure = modulus * (major / scale);
        // δ = (p₀/E*) s K
        let approach = (major / scale) * minor * integrals.k();
        let [a, b] = self.axes(major);
        // 1/ρ = (1/Rx⁺ + 1/Rx⁻ + 1/Ry⁺ + 1/Ry⁻)/4   (2.3)
        let rho = F::constant(2.0) / (small + large);
        // cos τ = (ρ/4) |(1/Rx⁺ + 1/Rx⁻) − (1/Ry⁺ + 1/Ry⁻)|   (2.5), as tan(τ/2) = √(A/B)
        let hertz_angle = (small / large).sqrt().atan().times(2.0);
        Error::Overflow.unless(are_finite(&[major, minor, peak_pressure, approach, rho]))?;
        Ok(HertzContact { a, b, peak_pressure, approach, axis_ratio, hertz_angle, rho })
    }

    /// A checked contact, and whether it and the radii are plausible. In a lost contact friction
    /// and mismatch are checked as well.
    fn loaded(
        &self, [a, b]: [F; 2], radii: &Radii<F>, pair: &CombinedMaterial<F>, normal_force: F,
        friction: F,
    ) -> Result<(Contact<F>, Warning), Error> {
        let CombinedMaterial { shear_modulus, poisson_ratio, mismatch } = *pair;
        let contact =
            Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, mismatch };
        Error::NotFinite.unless(are_finite(&[friction, mismatch]))?;
        Error::Friction.unless(friction >= F::zero())?;
        contact.check()?;
        let warning = match contact.plausibility() {
            _ if self.large < F::constant(SMALLEST_CURVATURE) => Warning::Radius,
            Warning::None if contact.is_conformal(radii) => Warning::Conformal,
            warning => warning,
        };
        Ok((contact, warning))
    }

    /// `a`, `b` for the major semi-axis.
    fn axes(&self, major: F) -> [F; 2] {
        let minor = self.axis_ratio * major;
        if self.along { [major, minor] } else { [minor, major] }
    }
}

/// Largest number of Newton steps. Five reach rounding from the starting value for any axis ratio.
const NEWTON_STEPS: usize = 12;

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
