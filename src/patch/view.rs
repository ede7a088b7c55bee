//! A checked patch for the solvers: its strips, their lobes and the equivalent ellipses.

use crate::contact::creepage::Creepage;
use crate::contact::material::{check_modulus, check_poisson_ratio};
use crate::number::{Float, pairs};
use crate::patch::sizes::{Extremes, Sizes};
use crate::patch::zones::Zone;
use crate::patch::{PatchStrip, QuadratureScale};
use crate::status::Error;

/// Number of lobes whose zones a view keeps; those of others are found whenever needed.
const LOBES: usize = 4;

/// A checked patch, whose strips the caller stores.
#[derive(Clone, Copy, Debug)]
pub struct PatchView<'a, F> {
    strips: &'a [PatchStrip<F>],
    shear_modulus: F,
    poisson_ratio: F,
    scale: QuadratureScale<F>,
    mismatch: F,
    pub(super) own: &'a [Creepage<F>],
    own_factor: F,
    /// Whether there are several lobes.
    has_gaps: bool,
    pub(super) sizes: Sizes<F>,
    /// The zone of all strips; none where a gap or a neck divides the patch.
    pub(super) whole: Option<Zone<F>>,
    /// In a divided patch, the zones of the first lobes whose strips all have the same zone.
    of_lobes: [Option<Zone<F>>; LOBES],
}

impl<'a, F: Float> PatchView<'a, F> {
    /// Checks strips in ascending `y`, the combined shear modulus `G` \[Pa\] and Poisson's ratio
    /// `ν`. A patch without strips carries no load.
    ///
    /// # Errors
    /// Those of [`PatchStrip::check`]; [`Error::Modulus`], [`Error::PoissonRatio`];
    /// [`Error::StripOrder`] when strips overlap or do not ascend; [`Error::Overflow`] when a sum
    /// or the axis ratio of a lobe does not fit the floating-point type.
    pub fn new(
        strips: &'a [PatchStrip<F>], shear_modulus: F, poisson_ratio: F, scale: QuadratureScale<F>,
    ) -> Result<Self, Error> {
        check_modulus(shear_modulus)?;
        check_poisson_ratio(poisson_ratio)?;
        for factor in [scale.area, scale.lever] {
            Error::NotFinite.when(!factor.is_finite_number() || factor <= F::zero())?;
            Error::Overflow.when(factor < F::constant(1e-6) || factor > F::constant(1e6))?;
        }
        let extremes = Extremes::new(strips);
        let are_usual = extremes.are_usual();
        if !are_usual {
            strips.iter().try_for_each(PatchStrip::check)?;
        }
        let (mut are_beside, mut has_gaps) = (true, false);
        for (strip, next) in pairs(strips) {
            are_beside &= strip.is_beside(next);
            has_gaps |= strip.is_apart(next);
        }
        Error::StripOrder.unless(are_beside)?;
        let mismatch = F::zero();
        let is_rule = scale != QuadratureScale::default();
        let sizes = Sizes::new(strips, &extremes, is_rule);
        let (whole, of_lobes) = (None, [None; LOBES]);
        let mut view = Self {
            strips,
            shear_modulus,
            poisson_ratio,
            scale,
            mismatch,
            own: &[],
            own_factor: F::one(),
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
        if are_usual {
            return Ok(view);
        }
        Error::Overflow.when(view.find_zone(|zone| zone.contact.check().err()).is_some())?;
        for strip in strips {
            strip.circle(shear_modulus, poisson_ratio).check().map_err(|_| Error::Overflow)?;
            // The pressure of the circle is zero where its load underflows.
            Error::Overflow.unless((strip.friction * strip.peak_pressure).is_finite_number())?;
        }
        let sums = [view.friction_bound(), view.normal_force(), view.area() * scale.area];
        if sums.iter().all(|sum| sum.is_finite_number()) { Ok(view) } else { Err(Error::Overflow) }
    }

    /// The same patch of dissimilar materials, with the mismatch `κ` as in
    /// [`Contact`](crate::contact::Contact).
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::Overflow`] when the creepage that pressure adds does not fit
    /// the floating-point type.
    pub fn with_mismatch(mut self, mismatch: F) -> Result<Self, Error> {
        Error::NotFinite.unless(mismatch.is_finite_number())?;
        if mismatch == self.mismatch {
            return Ok(self);
        }
        self.mismatch = mismatch;
        for zone in self.whole.iter_mut().chain(self.of_lobes.iter_mut().flatten()) {
            zone.contact.mismatch = mismatch;
        }
        let beyond = |zone: &Zone<F>| (!zone.contact.strain().is_finite_number()).then_some(());
        if self.find_zone(beyond).is_none() { Ok(self) } else { Err(Error::Overflow) }
    }

    /// The same patch whose strips have creepages besides that of the patch, each at its own
    /// centre, ascending in `y`: a curved surface. The model TOTAL has no
    /// strips, and refuses them.
    ///
    /// # Errors
    /// [`Error::Capacity`] unless there are as many as strips; [`Error::NotFinite`].
    pub fn with_own_creepages(mut self, own: &'a [Creepage<F>]) -> Result<Self, Error> {
        Error::Capacity.unless(own.len() == self.strips.len())?;
        own.iter().try_for_each(Creepage::check)?;
        (self.own, self.own_factor) = (own, F::one());
        Ok(self)
    }

    /// The same patch with its strips' own creepages multiplied.
    pub(super) fn scaled_own(mut self, factor: F) -> Self {
        self.own_factor = self.own_factor * factor;
        self
    }

    /// The creepage that a strip has at its centre besides that of the patch.
    pub(super) fn own(&self, number: usize) -> Option<Creepage<F>> {
        Some(self.own.get(number)?.scaled(self.own_factor))
    }

    /// Upper bounds of the rigid slip of these creepages within reach, and of their spin.
    pub(super) fn most_own(&self) -> [F; 2] {
        (0..self.own.len()).filter_map(|i| self.own(i)).fold([F::zero(); 2], |[slip, spin], own| {
            [slip.max(own.fastest_within(self.sizes.reach)), spin.max(own.spin.abs())]
        })
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
    pub fn quadrature(&self) -> QuadratureScale<F> {
        self.scale
    }

    /// The lobes, each with the index of its first strip, and the zone if all its strips share one.
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
        sum_of(self.strips, PatchStrip::load)
    }

    /// `Σ μ N` \[N\]: no tangential force exceeds it.
    #[must_use]
    pub fn friction_bound(&self) -> F {
        sum_of(self.strips, PatchStrip::friction_bound)
    }

    /// Contact area `Σ 2 l w` \[m²\].
    #[must_use]
    pub fn area(&self) -> F {
        sum_of(self.strips, |strip| strip.half_length.times(2.0) * strip.width)
    }

    /// The parts of the patch that gaps separate, in ascending `y`.
    pub fn lobes(&self) -> impl Iterator<Item = &'a [PatchStrip<F>]> + use<'a, F> {
        let (mut rest, has_gaps) = (self.strips, self.has_gaps);
        core::iter::from_fn(move || {
            let mut pairs = pairs(rest);
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

fn sum_of<F: Float>(strips: &[PatchStrip<F>], term: impl Fn(&PatchStrip<F>) -> F) -> F {
    strips.iter().fold(F::zero(), |sum, strip| sum + term(strip))
}
