//! A contact patch of any shape as a list of strips. Pressure and friction may differ from strip to strip.
//!
//! A strip runs along the rolling direction. It has a centre line `y`, a width, a half length `l`, a centre
//! `x_c`, a friction coefficient, and a pressure that is a half-ellipse in `x`,
//! `Z = p₀ √(1 − (x − x_c)²/l²)`, so that it carries the load `(π/2) p₀ l · width`. Where the strips come from
//! does not matter: from a Hertz ellipse ([`Patch::from_ellipse`]), from a profile
//! ([`profile`]), or from any other solver ([`Patch::from_strips`]).
//!
//! Strips lie side by side in ascending `y`. Where the distance of two neighbours is more than one and a half
//! times that at which they touch, there is a gap, and what lies on either side of it is a lobe of its own.
//!
//! The model STRIP needs an axis ratio. It takes that of an ellipse which stands for the strips around ([`zones`]).

mod estimate;
pub mod field;
pub mod friction;
mod influence;
mod lattice;
pub mod normal;
mod parabola;
pub mod profile;
mod section;
mod shares;
mod smooth;
pub mod solver;
mod stored;
pub mod zones;

pub use self::stored::{KSTRIP_PATCH_CAPACITY, StoredPatch};

use crate::contact::Contact;
use crate::contact::forces::StripCount;
use crate::contact::material::{check_modulus, check_poisson_ratio};
use crate::number::Float;
use crate::patch::zones::{Sizes, Zone};
use crate::solve::model::Precision;
use crate::status::Error;
use crate::strip::Rule;
use core::f64::consts::{FRAC_PI_2, PI};
use heapless::Vec;

/// One strip of a patch, along the rolling direction. Its pressure is a half-ellipse in x,
/// peak_pressure sqrt(1 - (x - centre_x)^2/half_length^2), and does not vary over its width.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PatchStrip<F> {
    /// Centre line y \[m\].
    pub y: F,
    /// Width \[m\], > 0.
    pub width: F,
    /// Half length along x \[m\], > 0.
    pub half_length: F,
    /// Centre along x \[m\]; 0 for most contacts.
    pub centre_x: F,
    /// Pressure at the centre \[Pa\], >= 0.
    pub peak_pressure: F,
    /// Coefficient of friction \[-\], >= 0; every strip may have its own.
    pub friction: F,
}

impl<F: Float> PatchStrip<F> {
    /// Load `(π/2) p₀ l · width` \[N\].
    #[must_use]
    pub fn load(&self) -> F {
        (self.peak_pressure * self.half_length).times(FRAC_PI_2) * self.width
    }

    /// Coefficient of friction times the load \[N\].
    #[must_use]
    pub fn friction_bound(&self) -> F {
        self.friction * self.load()
    }

    /// `y`, width, half length, `x_c`, pressure and friction.
    pub(crate) fn numbers(&self) -> [F; 6] {
        let Self { y, width, half_length, centre_x, peak_pressure, friction } = *self;
        [y, width, half_length, centre_x, peak_pressure, friction]
    }

    /// The circle with the strip's length, peak pressure and friction: its parameters `ξ, η, ψ` are the
    /// strip's.
    #[must_use]
    pub fn circle(&self, shear_modulus: F, poisson_ratio: F) -> Contact<F> {
        let Self { half_length, peak_pressure, friction, .. } = *self;
        Contact {
            a: half_length,
            b: half_length,
            // p₀ = 3N/(2π a b)
            normal_force: (peak_pressure * half_length).times(2.0 * PI / 3.0) * half_length,
            shear_modulus,
            poisson_ratio,
            friction,
            mismatch: F::zero(),
        }
    }

    /// Checks the members.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::StripSize`], [`Error::Pressure`], [`Error::Friction`].
    pub fn check(&self) -> Result<(), Error> {
        let Self { width, half_length, peak_pressure, friction, .. } = *self;
        if !self.numbers().iter().all(|input| input.is_finite_number()) {
            return Err(Error::NotFinite);
        }
        if width <= F::zero() || half_length <= F::zero() {
            return Err(Error::StripSize);
        }
        if peak_pressure < F::zero() {
            return Err(Error::Pressure);
        }
        if friction < F::zero() {
            return Err(Error::Friction);
        }
        Ok(())
    }

    /// Distance of the centre lines at which the strips touch.
    fn touching(&self, next: &Self) -> F {
        self.width.times(0.5) + next.width.times(0.5)
    }

    /// Whether there is a gap before the next strip.
    pub(crate) fn is_apart(&self, next: &Self) -> bool {
        next.y - self.y > self.touching(next).times(1.5)
    }

    /// Whether the next strip lies beside this one. The widths of a Gauss rule overlap by up to a quarter.
    fn is_beside(&self, next: &Self) -> bool {
        next.y > self.y && next.y - self.y >= self.touching(next).times(0.5)
    }
}

/// The least and the largest of each number of the strips, and their sum.
struct Extremes<F> {
    least: [F; 6],
    most: [F; 6],
    sum: [F; 6],
}

impl<F: Float> Extremes<F> {
    fn of(strips: &[PatchStrip<F>]) -> Self {
        let (least, most) = ([F::LARGEST; 6], [-F::LARGEST; 6]);
        let mut own = Self { least, most, sum: [F::zero(); 6] };
        for strip in strips {
            let numbers = strip.numbers();
            let places = own.least.iter_mut().zip(&mut own.most).zip(&mut own.sum);
            for (((least, most), sum), number) in places.zip(numbers) {
                *least = number.min(*least);
                *most = number.max(*most);
                *sum += number;
            }
        }
        own
    }

    /// Whether the numbers are of the usual sizes, 1 nm to 1 m and up to TPa: then no check can fail, in either precision.
    fn are_usual(&self) -> bool {
        let (nearest, farthest) =
            ([-1.0, 1e-9, 1e-9, -1.0, 0.0, 0.0], [1.0, 1.0, 1.0, 1.0, 1e12, 5.0]);
        let within = |numbers: &[F; 6]| {
            let bounds = nearest.iter().zip(&farthest);
            numbers
                .iter()
                .zip(bounds)
                .all(|(x, (low, high))| x.lies_between(F::of(*low), F::of(*high)))
        };
        // (what is not a number is neither the least nor the largest)
        within(&self.least)
            && within(&self.most)
            && self.sum.iter().all(|sum| sum.is_finite_number())
    }
}

/// Factors that turn a sum over the strips into the integral over the patch.
///
/// They are 1 where the strips are the patch itself. The strips of an ellipse are a rule of Gauss, whose sums miss the integrals by a
/// little; these two factors make the slopes of the linear theory exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuadratureScale<F> {
    /// For the area `∫ 2 l dy`.
    pub area: F,
    /// For its moment `∫ 2 l y² dy`.
    pub lever: F,
}

impl<F: Float> Default for QuadratureScale<F> {
    fn default() -> Self {
        Self { area: F::one(), lever: F::one() }
    }
}

/// Number of lobes whose zones a view keeps; those of further lobes are found again wherever they are needed.
const LOBES: usize = 4;

/// A checked patch, whose strips the caller stores.
#[derive(Clone, Copy, Debug)]
pub struct PatchView<'a, F> {
    strips: &'a [PatchStrip<F>],
    shear_modulus: F,
    poisson_ratio: F,
    scale: QuadratureScale<F>,
    mismatch: F,
    /// Whether there are several lobes.
    has_gaps: bool,
    sizes: Sizes<F>,
    /// The zone of all strips; none where a gap or a neck divides the patch.
    whole: Option<Zone<F>>,
    /// Of a divided patch the zones of the first lobes, where all strips of the lobe have the same.
    of_lobes: [Option<Zone<F>>; LOBES],
}

impl<'a, F: Float> PatchView<'a, F> {
    /// Checks strips in ascending `y`, the combined shear modulus `G` \[Pa\] and Poisson's ratio `ν`. A patch without strips carries
    /// no load.
    ///
    /// # Errors
    /// Those of [`PatchStrip::check`]; [`Error::Modulus`], [`Error::PoissonRatio`];
    /// [`Error::StripOrder`] when strips overlap or do not ascend; [`Error::Overflow`] when a sum or the
    /// axis ratio of a lobe does not fit the floating-point type.
    pub fn new(
        strips: &'a [PatchStrip<F>],
        shear_modulus: F,
        poisson_ratio: F,
        scale: QuadratureScale<F>,
    ) -> Result<Self, Error> {
        check_modulus(shear_modulus)?;
        check_poisson_ratio(poisson_ratio)?;
        for factor in [scale.area, scale.lever] {
            if !factor.is_finite_number() || factor <= F::zero() {
                return Err(Error::NotFinite);
            }
            if factor < F::constant(1e-6) || factor > F::constant(1e6) {
                return Err(Error::Overflow);
            }
        }
        let extremes = Extremes::of(strips);
        let are_usual = extremes.are_usual();
        if !are_usual {
            for strip in strips {
                strip.check()?;
            }
        }
        let (mut are_beside, mut has_gaps) = (true, false);
        for (strip, next) in strips.iter().zip(strips.iter().skip(1)) {
            are_beside &= strip.is_beside(next);
            has_gaps |= strip.is_apart(next);
        }
        if !are_beside {
            return Err(Error::StripOrder);
        }
        let mismatch = F::zero();
        let (sizes, whole, of_lobes) = (Sizes::new(strips, &extremes), None, [None; LOBES]);
        let mut view = Self {
            strips,
            shear_modulus,
            poisson_ratio,
            scale,
            mismatch,
            has_gaps,
            sizes,
            whole,
            of_lobes,
        };
        view.whole = view.only_zone();
        if view.whole.is_none() {
            let mut zones = [None; LOBES];
            let mut first = 0;
            for (zone, lobe) in zones.iter_mut().zip(view.lobes()) {
                *zone = view.zone_of_lobe(first, lobe);
                first += lobe.len();
            }
            view.of_lobes = zones;
        }
        if view.find_zone(|zone| zone.contact.check().err()).is_some() {
            return Err(Error::Overflow);
        }
        if are_usual {
            return Ok(view);
        }
        for strip in strips {
            strip.circle(shear_modulus, poisson_ratio).check().map_err(|_| Error::Overflow)?;
            // (the circle's pressure is zero where its load underflows)
            if !(strip.friction * strip.peak_pressure).is_finite_number() {
                return Err(Error::Overflow);
            }
        }
        let sums = [view.friction_bound(), view.normal_force(), view.area() * scale.area];
        if sums.iter().all(|sum| sum.is_finite_number()) { Ok(view) } else { Err(Error::Overflow) }
    }

    /// The same patch of unlike materials, with the mismatch `κ` as in [`Contact`].
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::Overflow`] when the creepage that pressure makes does not fit the floating-point type.
    pub fn with_mismatch(mut self, mismatch: F) -> Result<Self, Error> {
        if !mismatch.is_finite_number() {
            return Err(Error::NotFinite);
        }
        self.mismatch = mismatch;
        if mismatch == F::zero() {
            return Ok(self);
        }
        for zone in self.whole.iter_mut().chain(self.of_lobes.iter_mut().flatten()) {
            zone.contact.mismatch = mismatch;
        }
        let beyond = |zone: &Zone<F>| (!zone.contact.strain().is_finite_number()).then_some(());
        if self.find_zone(beyond).is_none() { Ok(self) } else { Err(Error::Overflow) }
    }

    /// Mismatch `κ` of the materials.
    #[must_use]
    pub fn mismatch(&self) -> F {
        self.mismatch
    }

    /// The strips, ascending in `y`.
    #[must_use]
    pub fn strips(&self) -> &'a [PatchStrip<F>] {
        self.strips
    }

    /// Combined shear modulus `G` \[Pa\].
    #[must_use]
    pub fn shear_modulus(&self) -> F {
        self.shear_modulus
    }

    /// Combined Poisson's ratio `ν`.
    #[must_use]
    pub fn poisson_ratio(&self) -> F {
        self.poisson_ratio
    }

    /// Factors of the quadrature.
    #[must_use]
    pub fn scale(&self) -> QuadratureScale<F> {
        self.scale
    }

    pub(crate) fn whole(&self) -> Option<&Zone<F>> {
        self.whole.as_ref()
    }

    fn sizes(&self) -> &Sizes<F> {
        &self.sizes
    }

    /// The lobes in ascending `y`, each with the number of its first strip and with its zone, if all its strips have the same.
    pub(crate) fn lobes_and_zones(
        &self,
    ) -> impl Iterator<Item = (usize, &'a [PatchStrip<F>], Option<Zone<F>>)> {
        let mut first = 0;
        self.lobes().enumerate().map(move |(number, lobe)| {
            let begin = first;
            first += lobe.len();
            let zone = match (self.whole, self.of_lobes.get(number)) {
                (Some(whole), _) => Some(whole),
                (None, Some(known)) => *known,
                (None, None) => self.zone_of_lobe(begin, lobe),
            };
            (begin, lobe, zone)
        })
    }

    /// Normal force `N` \[N\].
    #[must_use]
    pub fn normal_force(&self) -> F {
        sum(self.strips, PatchStrip::load)
    }

    /// `Σ μ N` \[N\]: no tangential force exceeds it.
    #[must_use]
    pub fn friction_bound(&self) -> F {
        sum(self.strips, PatchStrip::friction_bound)
    }

    /// Contact area `Σ 2 l w` \[m²\].
    #[must_use]
    pub fn area(&self) -> F {
        sum(self.strips, |strip| strip.half_length.times(2.0) * strip.width)
    }

    /// The parts of the patch that gaps separate, in ascending `y`.
    pub fn lobes(&self) -> impl Iterator<Item = &'a [PatchStrip<F>]> + use<'a, F> {
        let (mut rest, has_gaps) = (self.strips, self.has_gaps);
        core::iter::from_fn(move || {
            let mut pairs = rest.iter().zip(rest.iter().skip(1));
            let end = has_gaps.then(|| pairs.position(|(strip, next)| strip.is_apart(next)));
            let end = end.flatten();
            let (strips, others) = match end.and_then(|last| rest.split_at_checked(last + 1)) {
                Some(parts) => parts,
                None => (rest, [].as_slice()),
            };
            rest = others;
            (!strips.is_empty()).then_some(strips)
        })
    }
}

fn sum<F: Float>(strips: &[PatchStrip<F>], term: impl Fn(&PatchStrip<F>) -> F) -> F {
    strips.iter().fold(F::zero(), |sum, strip| sum + term(strip))
}

/// A patch of at most `CAPACITY` strips.
#[derive(Clone, Debug, PartialEq)]
pub struct Patch<F, const CAPACITY: usize> {
    /// The strips, ascending in `y`.
    pub strips: Vec<PatchStrip<F>, CAPACITY>,
    /// Combined shear modulus `G` \[Pa\].
    pub shear_modulus: F,
    /// Combined Poisson's ratio `ν`.
    pub poisson_ratio: F,
    /// Factors of the quadrature.
    pub scale: QuadratureScale<F>,
    /// Mismatch `κ` of the materials.
    pub mismatch: F,
}

impl<F: Precision, const CAPACITY: usize> Patch<F, CAPACITY> {
    /// The patch of a Hertz ellipse, with strips at the places of [`Model::Strip`](crate::solve::model::Model::Strip).
    ///
    /// # Errors
    /// Those of [`Contact::check`]; [`Error::PatchSize`] when the capacity is below the count;
    /// [`Error::Overflow`] when its strips do not fit the floating-point type.
    pub fn from_ellipse(contact: &Contact<F>, count: StripCount) -> Result<Self, Error> {
        check_ellipse(contact, count)?;
        let mut patch = Self::empty(contact.shear_modulus, contact.poisson_ratio);
        patch.mismatch = contact.mismatch;
        patch.scale = ellipse(contact, count, |strip| patch.strips.push(strip).is_ok())?;
        Ok(patch)
    }

    /// A patch of strips in any order.
    ///
    /// # Errors
    /// [`Error::PatchSize`] when there are more than the capacity, else those of [`PatchView::new`].
    pub fn from_strips(
        strips: &[PatchStrip<F>],
        shear_modulus: F,
        poisson_ratio: F,
    ) -> Result<Self, Error> {
        let mut patch = Self::empty(shear_modulus, poisson_ratio);
        patch.strips.extend_from_slice(strips).map_err(|_| Error::PatchSize)?;
        sort(&mut patch.strips);
        patch.view()?;
        Ok(patch)
    }

    /// An error where the strips do not carry this load, because at the ends of the number range no digits are left.
    pub(crate) fn check(&self, load: F) -> Result<(), Error> {
        let lost = (self.view()?.normal_force() - load).abs();
        if lost <= load * F::constant(1e-3) { Ok(()) } else { Err(Error::Overflow) }
    }

    pub(crate) fn empty(shear_modulus: F, poisson_ratio: F) -> Self {
        let (strips, scale) = (Vec::new(), QuadratureScale::default());
        Self { strips, shear_modulus, poisson_ratio, scale, mismatch: F::zero() }
    }
}

impl<F: Float, const CAPACITY: usize> Patch<F, CAPACITY> {
    /// The patch, checked, for the functions of [`solver`].
    ///
    /// # Errors
    /// Those of [`PatchView::new`] and [`PatchView::with_mismatch`].
    pub fn view(&self) -> Result<PatchView<'_, F>, Error> {
        PatchView::new(&self.strips, self.shear_modulus, self.poisson_ratio, self.scale)?
            .with_mismatch(self.mismatch)
    }
}

/// Sorts strips by `y`, in place. A list that ascends already takes one pass.
pub(crate) fn sort<F: Float>(strips: &mut [PatchStrip<F>]) {
    for end in 1..strips.len() {
        for i in (0..end).rev() {
            match strips.get_mut(i..i + 2) {
                Some([strip, next]) if next.y < strip.y => core::mem::swap(strip, next),
                _ => break,
            }
        }
    }
}

/// Checks that the strips of an ellipse make a patch that [`PatchView::new`] accepts.
///
/// # Errors
/// Those of [`Contact::check`]; [`Error::Overflow`] when its strips do not fit the floating-point type.
pub(crate) fn check_ellipse<F: Precision>(
    contact: &Contact<F>,
    count: StripCount,
) -> Result<(), Error> {
    contact.check()?;
    let Contact { shear_modulus, poisson_ratio, .. } = *contact;
    let [mut width, mut load, mut bound, mut area] = [F::zero(); 4];
    let mut last: Option<PatchStrip<F>> = None;
    let scale = ellipse(contact, count, |strip| {
        width += strip.width;
        load += strip.load();
        bound += strip.friction_bound();
        area += strip.half_length.times(2.0) * strip.width;
        let fits = strip.check().is_ok()
            && strip.circle(shear_modulus, poisson_ratio).check().is_ok()
            && last.is_none_or(|last| last.is_beside(&strip) && !last.is_apart(&strip));
        last = Some(strip);
        fits
    });
    // A strip that is none, or sums beyond the number range: only in contacts at the ends of it.
    let scale = scale.map_err(|_| Error::Overflow)?;
    let friction = if load > F::zero() { bound / load } else { contact.friction };
    // (the ellipse of the strips is not quite their contact's: neither of them at the end of the range)
    for b in [width.times(0.45), width.times(0.55)] {
        let lobe = Contact { b, normal_force: load, friction, ..*contact };
        lobe.check().map_err(|_| Error::Overflow)?;
    }
    if !(area * scale.area).is_finite_number() {
        return Err(Error::Overflow);
    }
    Ok(())
}

/// Hands the strips of a checked ellipse to `take`, which returns whether there was room.
pub(crate) fn ellipse<F: Precision>(
    contact: &Contact<F>,
    count: StripCount,
    mut take: impl FnMut(PatchStrip<F>) -> bool,
) -> Result<QuadratureScale<F>, Error> {
    let rule = Rule::<F>::new(count);
    for [y, half_length, width] in rule.places() {
        let strip = PatchStrip {
            y: contact.b * y,
            width: contact.b * width,
            half_length: contact.a * half_length,
            centre_x: F::zero(),
            peak_pressure: contact.peak_pressure() * half_length,
            friction: contact.friction,
        };
        if !take(strip) {
            return Err(Error::PatchSize);
        }
    }
    Ok(QuadratureScale { area: rule.stretch, lever: rule.lever })
}
