//! A contact patch from profiles: the construction of Kik and Piotrowski.
//!
//! W. Kik, J. Piotrowski, *A fast, approximate method to calculate normal load at contact between wheel
//! and rail and creep forces during rolling*, 2nd mini-conference on contact mechanics and wear of rail/wheel
//! systems, Budapest 1996; J. Piotrowski, W. Kik, *A simplified model of wheel/rail contact mechanics for
//! non-Hertzian problems*, Vehicle System Dynamics 46 (2008) 27–48.
//!
//! Two bodies whose undeformed surfaces are `f(y) ≥ 0` apart on the line `x = 0`, with `f = 0` at the deepest
//! point, approach each other by `δ`. Contact is assumed where the surfaces would pass through each other
//! when shifted by `0.55 δ` only:
//!
//! ```text
//! g(y) = 0.55 δ − f(y) where that is positive;   l(y)² = 2 R g(y)
//! Z(x, y) = s √(l(y)² − x²)
//! ```
//!
//! with `R` the rolling radius and the slope `s = p₀/l₀` such that the deflection under this pressure is `δ` at the
//! deepest point `y₀`: `δ = (1/(π E*)) ∫∫ Z/r dA`, `E* = G/(1 − ν)`. The integral over `x` is
//!
//! ```text
//! ∫ √(l² − x²)/√(x² + d²) dx = 2 l²/√(l² + d²) D(g),   d = |y − y₀|,   g = d/√(l² + d²)
//! ```
//!
//! with the elliptic integral `D = ∫ sin²θ/√(cos²θ + g² sin²θ) dθ`. So `N = π² E* δ R ∫ g dy/J`, `J` the integral of that
//! over `y`, and `δ` for a given `N` is found between zero and where the contact would reach the end of the
//! profile, by secants through `N^{2/3}`, which is nearly proportional to `δ`.
//!
//! Against Hertz's paraboloids the pressure distribution is an ellipsoid too, but its axes are those of the section
//! of the undeformed surfaces: for a circle 3 % too long, the peak pressure 6 % too low; for slender ellipses
//! more (`tests/models/patch.rs`). No shape correction is applied. Of two points equally deep the first counts.

use crate::contact::elliptic::Integrals;
use crate::contact::forces::StripCount;
use crate::contact::material::{check_modulus, check_poisson_ratio};
use crate::number::Float;
use crate::patch::{Patch, PatchStrip};
use crate::solve::model::Precision;
use crate::status::Error;
use core::f64::consts::PI;

/// Share of the approach by which the surfaces are shifted into each other.
const VIRTUAL_SHARE: f64 = 0.55;
/// A node of Gauss on `[-1, 1]` and its weight.
type Node = (f64, f64);
/// Two of them.
const GAUSS_2: [Node; 2] = [(-0.577_350_269_189_625_8, 1.0), (0.577_350_269_189_625_8, 1.0)];
/// Eight.
const GAUSS_8: [Node; 8] = [
    (-0.9602898564975363, 0.10122853629037626),
    (-0.7966664774136267, 0.22238103445337448),
    (-0.525532409916329, 0.31370664587788727),
    (-0.1834346424956498, 0.362683783378362),
    (0.1834346424956498, 0.362683783378362),
    (0.525532409916329, 0.31370664587788727),
    (0.7966664774136267, 0.22238103445337448),
    (0.9602898564975363, 0.10122853629037626),
];
/// Evaluations of the load at most; six to nine are usual.
const ITERATIONS: u32 = 60;

/// What presses the two profiles together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfileContact<F> {
    /// Rolling radius `R` \[m\], positive; of two rolling bodies `1/R = 1/R₁ + 1/R₂`.
    pub rolling_radius: F,
    /// Normal force `N` \[N\], not negative.
    pub normal_force: F,
    /// Combined shear modulus `G` \[Pa\], positive.
    pub shear_modulus: F,
    /// Combined Poisson's ratio `ν`, 0 to 1/2.
    pub poisson_ratio: F,
    /// Coefficient of friction `μ` of every strip, not negative.
    pub friction: F,
}

impl<F: Float> ProfileContact<F> {
    /// # Errors
    /// [`Error::NotFinite`], [`Error::RollingRadius`], [`Error::NormalForce`], [`Error::Modulus`],
    /// [`Error::PoissonRatio`], [`Error::Friction`].
    pub fn check(&self) -> Result<(), Error> {
        let inputs = [self.rolling_radius, self.normal_force, self.friction];
        if !inputs.iter().all(|input| input.is_finite_number()) {
            return Err(Error::NotFinite);
        }
        if self.rolling_radius <= F::zero() {
            return Err(Error::RollingRadius);
        }
        if self.normal_force < F::zero() {
            return Err(Error::NormalForce);
        }
        check_modulus(self.shear_modulus)?;
        check_poisson_ratio(self.poisson_ratio)?;
        if self.friction < F::zero() {
            return Err(Error::Friction);
        }
        Ok(())
    }
}

/// The undeformed distance of two bodies along `y`, straight between its points.
#[derive(Clone, Copy, Debug)]
pub struct Profile<'a, F> {
    y: &'a [F],
    distance: &'a [F],
    /// Smallest distance, and where it is.
    lowest: F,
    deepest: F,
}

/// A straight piece of the interpenetration `g`, where it is not negative.
#[derive(Clone, Copy, Debug)]
struct Piece<F> {
    from: F,
    to: F,
    g_from: F,
    g_to: F,
}

impl<'a, F: Float> Profile<'a, F> {
    /// Points `y` \[m\], strictly ascending, and the distance of the bodies there \[m\]; what is added to all
    /// distances does not matter.
    ///
    /// # Errors
    /// [`Error::Profile`] for fewer than three points, arrays of different length or `y` that does not ascend;
    /// [`Error::NotFinite`].
    pub fn new(y: &'a [F], distance: &'a [F]) -> Result<Self, Error> {
        let (Some(first), true) = (distance.first(), y.len() >= 3 && y.len() == distance.len())
        else {
            return Err(Error::Profile);
        };
        if !y.iter().chain(distance).all(|x| x.is_finite_number()) {
            return Err(Error::NotFinite);
        }
        if !y.iter().zip(y.iter().skip(1)).all(|(y, next)| y < next) {
            return Err(Error::Profile);
        }
        let lowest = distance.iter().fold(*first, |lowest, distance| lowest.min(*distance));
        // The middle of the first flat bottom
        let mut bottom = y
            .iter()
            .zip(distance)
            .skip_while(|(_, distance)| **distance > lowest)
            .take_while(|(_, distance)| **distance <= lowest)
            .map(|(y, _)| *y);
        let start = bottom.next().ok_or(Error::Profile)?;
        let end = bottom.last().unwrap_or(start);
        Ok(Self { y, distance, lowest, deepest: start.times(0.5) + end.times(0.5) })
    }

    /// Interpenetration at which the contact reaches an end of the profile.
    fn depth(&self) -> F {
        let ends = [self.distance.first(), self.distance.last()];
        ends.into_iter()
            .flatten()
            .map(|end| *end - self.lowest)
            .reduce(|a, b| a.min(b))
            .unwrap_or(F::zero())
    }

    /// The pieces of `g` for an interpenetration `level`, ascending.
    fn pieces(&self, level: F) -> impl Iterator<Item = Piece<F>> + use<'a, F> {
        let lowest = self.lowest;
        let nodes = self.y.iter().zip(self.distance);
        nodes.clone().zip(nodes.skip(1)).filter_map(move |((from, f_from), (to, f_to))| {
            let (g_from, g_to) = (level - (*f_from - lowest), level - (*f_to - lowest));
            let mut piece = Piece { from: *from, to: *to, g_from, g_to };
            if g_from <= F::zero() && g_to <= F::zero() {
                return None;
            }
            let edge = || *from + (*to - *from) * (g_from / (g_from - g_to));
            if g_from < F::zero() {
                piece.from = edge().clamped(*from, *to);
                piece.g_from = F::zero();
            } else if g_to < F::zero() {
                piece.to = edge().clamped(*from, *to);
                piece.g_to = F::zero();
            }
            (piece.to > piece.from).then_some(piece)
        })
    }

    /// Every zone of contact, from one edge to the other.
    fn zones(
        &self,
        level: F,
        mut take: impl FnMut(F, F) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let mut open: Option<(F, F)> = None;
        for piece in self.pieces(level) {
            let (lower, _) = open.unwrap_or((piece.from, piece.to));
            if piece.g_to > F::zero() {
                open = Some((lower, piece.to));
            } else {
                open = None;
                take(lower, piece.to)?;
            }
        }
        // Contact up to the end of the profile, by rounding
        match open {
            Some((lower, upper)) => take(lower, upper),
            None => Ok(()),
        }
    }

    /// `∫ g dy` from one `y` to another.
    fn volume(&self, level: F, lower: F, upper: F) -> F {
        self.pieces(level).fold(F::zero(), |sum, piece| sum + piece.volume(lower, upper))
    }
}

impl<F: Float> Piece<F> {
    fn at(&self, y: F) -> F {
        let share = (y - self.from) / (self.to - self.from);
        self.g_from + (self.g_to - self.g_from) * share
    }

    /// `∫ g dy` over its part between two `y`.
    fn volume(&self, lower: F, upper: F) -> F {
        let (lower, upper) = (self.from.max(lower), self.to.min(upper));
        if upper > lower {
            (upper - lower) * (self.at(lower).times(0.5) + self.at(upper).times(0.5))
        } else {
            F::zero()
        }
    }
}

/// The two bodies in contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Indentation<F> {
    /// Approach of distant points `δ` \[m\].
    pub penetration: F,
    /// Peak pressure, at the deepest point \[Pa\].
    pub peak_pressure: F,
    /// Normal force of the strips \[N\]; that asked for to a few units of the last place.
    pub normal_force: F,
    /// `y` of the deepest point \[m\].
    pub deepest_y: F,
    /// Evaluations of the load that it took.
    pub iterations: u32,
    /// `s = p₀/l₀` \[Pa/m\]
    slope: F,
}

impl<F: Precision> Indentation<F> {
    /// How far two bodies approach under a load.
    ///
    /// # Errors
    /// Those of [`ProfileContact::check`]; [`Error::ProfileEnd`] when the zone of contact reaches an end of
    /// the profile; [`Error::Overflow`].
    pub fn new(profile: &Profile<F>, contact: &ProfileContact<F>) -> Result<Self, Error> {
        contact.check()?;
        let wanted = contact.normal_force;
        let depth = profile.depth();
        if !depth.is_finite_number() {
            return Err(Error::Overflow);
        }
        if depth <= F::zero() {
            return Err(Error::ProfileEnd);
        }
        let mut iterations = 1;
        let largest = Self::at(profile, contact, depth.times(1.0 / VIRTUAL_SHARE));
        let results = [largest.normal_force, largest.peak_pressure];
        if !results.iter().all(|result| result.is_finite_number()) {
            return Err(Error::Overflow);
        }
        if largest.normal_force < wanted {
            return Err(Error::ProfileEnd);
        }
        if wanted <= F::zero() {
            let zero = F::zero();
            return Ok(Self {
                penetration: zero,
                peak_pressure: zero,
                normal_force: zero,
                iterations,
                slope: zero,
                ..largest
            });
        }
        // Secants through h = N^{2/3} between two brackets; the value at an end that stays twice is halved
        // (the Illinois rule).
        let power = |load: F| load.cube_root() * load.cube_root();
        let target = power(wanted);
        let (mut low, mut high) = (F::zero(), largest.penetration);
        let (mut below, mut above) = (target, power(largest.normal_force) - target);
        let mut best = largest;
        let mut moved = 0_i32;
        while iterations < ITERATIONS {
            let error = (best.normal_force - wanted).abs();
            if error <= wanted * F::EPSILON.times(8.0)
                || !(high - low > high * F::EPSILON.times(2.0))
            {
                break;
            }
            let secant = low + (high - low) * (below / (below + above));
            let middle = low.times(0.5) + high.times(0.5);
            let inside = secant > low && secant < high;
            let tried = Self::at(profile, contact, if inside { secant } else { middle });
            iterations += 1;
            let excess = power(tried.normal_force) - target;
            if excess < F::zero() {
                (low, below) = (tried.penetration, -excess);
                if moved < 0 {
                    above = above.times(0.5);
                }
                moved = -1;
            } else {
                (high, above) = (tried.penetration, excess);
                if moved > 0 {
                    below = below.times(0.5);
                }
                moved = 1;
            }
            if (tried.normal_force - wanted).abs() <= error {
                best = tried;
            }
        }
        Ok(Self { iterations, ..best })
    }

    /// The load and the pressure for an approach.
    fn at(profile: &Profile<F>, contact: &ProfileContact<F>, penetration: F) -> Self {
        let level = penetration.times(VIRTUAL_SHARE);
        let diameter = contact.rolling_radius.times(2.0);
        let (mut volume, mut potential) = (F::zero(), F::zero());
        for piece in profile.pieces(level) {
            volume += piece.volume(piece.from, piece.to);
            potential += piece.potential(profile.deepest, diameter);
        }
        let modulus = contact.shear_modulus / (F::one() - contact.poisson_ratio);
        // δ = (s/(π E*)) J
        let slope = (modulus * penetration).times(PI) / potential;
        Self {
            penetration,
            peak_pressure: slope * (diameter * level).sqrt(),
            // N = s (π/2) ∫ l² dy,  l² = 2 R g
            normal_force: (slope * diameter).times(0.5 * PI) * volume,
            deepest_y: profile.deepest,
            iterations: 0,
            slope,
        }
    }

    /// Hands the strips to `take`, which tells whether it had room: in every zone of contact strips of equal
    /// width, more in a wide zone than in a narrow one, whose loads are those of the profile exactly.
    pub(crate) fn strips(
        &self,
        profile: &Profile<F>,
        contact: &ProfileContact<F>,
        count: StripCount,
        mut take: impl FnMut(PatchStrip<F>) -> bool,
    ) -> Result<(), Error> {
        let level = self.penetration.times(VIRTUAL_SHARE);
        let (mut zones, mut width) = (0_i32, F::zero());
        profile.zones(level, |lower, upper| {
            zones = zones.saturating_add(1);
            width += upper - lower;
            Ok(())
        })?;
        let spare = count as i32 - zones;
        if spare < 0 {
            return Err(Error::PatchSize);
        }
        profile.zones(level, |lower, upper| {
            // one strip for each zone, the others by width
            let share = (upper - lower) / width;
            let mut strips = 1;
            while strips <= spare && F::of(f64::from(strips)) <= F::of(f64::from(spare)) * share {
                strips += 1;
            }
            let step = (upper - lower) / F::of(f64::from(strips));
            let mut to = lower;
            for i in 1..=strips {
                // Widths as differences of edges, so that far from y = 0 nothing is lost between strips
                let from = to;
                to = if i < strips { lower + step * F::of(f64::from(i)) } else { upper };
                let width = to - from;
                // l² = 2 R g, the mean over the strip
                let mean = profile.volume(level, from, to) / width;
                let half_length = (contact.rolling_radius.times(2.0) * mean).sqrt();
                let strip = PatchStrip {
                    y: from + width.times(0.5),
                    width,
                    half_length,
                    centre_x: F::zero(),
                    peak_pressure: self.slope * half_length,
                    friction: contact.friction,
                };
                if half_length > F::zero() && !take(strip) {
                    return Err(Error::PatchSize);
                }
            }
            Ok(())
        })
    }
}

impl<F: Precision> Piece<F> {
    /// `∫∫ √(l² − x²)/r dx dy` over the piece, `r` the distance from the deepest point.
    fn potential(&self, deepest: F, diameter: F) -> F {
        if self.from < deepest && deepest < self.to {
            let middle = self.at(deepest);
            let left = Self { to: deepest, g_to: middle, ..*self };
            let right = Self { from: deepest, g_from: middle, ..*self };
            return left.beside(deepest, diameter) + right.beside(deepest, diameter);
        }
        self.beside(deepest, diameter)
    }

    /// The same for a piece with the deepest point at its end or outside.
    fn beside(&self, deepest: F, diameter: F) -> F {
        let length = self.to - self.from;
        let (near, sign) =
            if self.from >= deepest { (self.from, F::one()) } else { (self.to, -F::one()) };
        let distance = (near - deepest).abs();
        let along = |offset: F| {
            // ∫ dx = 2 l²/√(l² + d²) D
            let d = distance + offset;
            let square = diameter * self.at(near + offset * sign).max(F::zero());
            let reach = (square + d * d).sqrt() + F::TINY;
            (square / reach).times(2.0) * Integrals::at((d / reach).max(F::EPSILON)).d
        };
        if length <= distance.times(0.5) {
            quadrature(&GAUSS_2, length, along)
        } else {
            // Next to the deepest point it grows like a logarithm: y = L t², dy = 2 L t dt
            let graded = |t: F| (length * t).times(2.0) * along(length * t * t);
            quadrature(&GAUSS_8, F::one(), graded)
        }
    }
}

/// `∫ f` from zero to `length`.
fn quadrature<F: Float>(rule: &[Node], length: F, f: impl Fn(F) -> F) -> F {
    let sum = rule.iter().fold(F::zero(), |sum, (node, weight)| {
        sum + f(length * F::of(*node).times(0.5).plus(0.5)).times(*weight)
    });
    sum * length.times(0.5)
}

impl<F: Precision, const CAPACITY: usize> Patch<F, CAPACITY> {
    /// The patch of two profiles under a load, with at most `count` strips.
    ///
    /// # Errors
    /// Those of [`Profile::new`] and [`Indentation::new`]; [`Error::PatchSize`] when there are more separate
    /// zones of contact than strips, or the capacity is below the count.
    ///
    /// # Example
    /// A wheel of 0.46 m radius on a rail head of 0.30 m:
    /// ```
    /// use kstrip::{patch::kik_piotrowski::ProfileContact, patch::Patch, contact::forces::StripCount};
    /// let y: [f64; 41] = core::array::from_fn(|i| (i as f64 - 20.0) * 0.5e-3);
    /// let distance = y.map(|y| y * y / (2.0 * 0.30));
    /// let contact = ProfileContact {
    ///     rolling_radius: 0.46, normal_force: 80e3,
    ///     shear_modulus: 82e9, poisson_ratio: 0.28, friction: 0.3,
    /// };
    /// let (patch, found) =
    ///     Patch::<f64, 16>::from_profile(&y, &distance, &contact, StripCount::Sixteen)?;
    /// assert!((patch.view()?.normal_force() - 80e3).abs() < 1e-6);
    /// assert!(found.penetration > 0.0 && found.deepest_y == 0.0);
    /// # Ok::<(), kstrip::status::Error>(())
    /// ```
    pub fn from_profile(
        y: &[F],
        distance: &[F],
        contact: &ProfileContact<F>,
        count: StripCount,
    ) -> Result<(Self, Indentation<F>), Error> {
        let profile = Profile::new(y, distance)?;
        let found = Indentation::new(&profile, contact)?;
        let mut patch = Self::empty(contact.shear_modulus, contact.poisson_ratio);
        found.strips(&profile, contact, count, |strip| patch.strips.push(strip).is_ok())?;
        // Lengths and gaps at the ends of the number range have no digits left.
        let lost = (patch.view()?.normal_force() - found.normal_force).abs();
        if !(lost <= found.normal_force * F::constant(1e-3)) {
            return Err(Error::Overflow);
        }
        Ok((patch, found))
    }
}
