//! A model behind a layer ([`layer`](crate::layer)): the half-spaces of the model, and bristles.
//!
//! `F = M f(k c/M, k κ/μ; k₁, λ)` with `λ = h G/(G₃ a)`, so that all that homogeneity says holds as
//! without a layer, but for the load through Hertz, with which `λ` falls like `N^{−1/3}`:
//!
//! ```text
//! N dF/dN = F − ⅓ J_v v − ⅓ λ ∂F/∂λ
//! ```

use crate::contact::Contact;
use crate::contact::creepage::{Creepage, Parameters};
use crate::contact::totals::Totals;
use crate::forces::check::find_fault;
use crate::forces::derivatives::{
    Derivatives, POWERS, Sensitivity, Slopes, by_size, differentiated_by, scaled, transposed,
};
use crate::forces::options::{Model, Options, Solution};
use crate::forces::theory::{Forces, ScaledContact, Theory, by_model, solution_by};
use crate::friction::law::SlipFriction;
use crate::layer::{Interface, Layer, Split};
use crate::number::dual::Dual;
use crate::number::{Float, Number, Real, are_finite};
use crate::status::Error;

/// Creepages, layer and what sliding leaves: what forces are differentiated by.
type Variable<F> = Dual<F, 5>;

/// A model behind a layer.
#[derive(Clone, Copy, Debug)]
struct Layered<F, M> {
    model: M,
    layer: Layer<F>,
    interface: Interface<F>,
}

/// The layer of a contact that carries, and its creepages.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Behind<F> {
    pub layer: Layer<F>,
    pub split: Split<F>,
    /// The creepage of half-spaces and bristles together.
    pub whole: Creepage<F>,
    /// Whether there are bristles, or a slide factor only.
    pub has_bristles: bool,
}

impl<F: Float> Behind<F> {
    pub fn half_spaces(&self) -> Creepage<F> {
        self.split.half_spaces(&self.whole)
    }
}

/// Forces, their derivatives at constant friction, and those by layer and slide factor.
pub(crate) type WithSlopes<F> = (Solution<F>, Slopes<F>, InterfaceSlopes<F>);

/// Derivatives with respect to layer and slide factor at constant friction.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct InterfaceSlopes<F> {
    /// The layer `h/G₃` \[m/Pa\].
    pub layer: F,
    /// With respect to the layer.
    pub by_layer: Sensitivity<F>,
    /// With respect to the slide factor.
    pub by_slide: Sensitivity<F>,
}

impl<F: Real, M: Theory<F>> Layered<F, M> {
    #[inline(always)]
    fn new(frame: &ScaledContact<F>, options: &Options, interface: Interface<F>) -> Self {
        let (ratio, _, linear) = frame.shape();
        let layer = Layer::new(ratio, &linear);
        Self { model: M::of_contact(frame, options), layer, interface }
    }

    /// Totals behind an interface whose numbers may be variables.
    #[inline(always)]
    fn totals_through_layer<T: Number<Base = F>>(
        &self, frame: &ScaledContact<F>, parameters: &Parameters<T>, interface: &Interface<T>,
    ) -> Totals<T> {
        let split = self.layer.split(frame.units.normalised(parameters), interface);
        let [x, y, z] = split.factors;
        let Parameters { xi, eta, psi, .. } = *parameters;
        let half_spaces = self.half_spaces(frame, parameters, [xi * x, eta * y, psi * z]);
        if !interface.layer.value().exceeds(F::zero()) {
            return half_spaces;
        }
        let mean = self.layer.with_bristles(&half_spaces, &split);
        // TOTAL has no area of adhesion.
        let stick = if M::MODEL == Model::Total { half_spaces.stick } else { mean.stick };
        Totals { stick, ..mean }
    }

    /// Totals of the model at other creepages, of which it has three derivatives at most.
    #[inline]
    fn half_spaces<T: Number<Base = F>>(
        &self, frame: &ScaledContact<F>, of: &Parameters<T>, seen: [T; 3],
    ) -> Totals<T> {
        let Parameters { poisson_ratio, axis_ratio, .. } = *of;
        let [xi, eta, psi] = seen.map(T::value);
        if !T::HAS_DERIVATIVES {
            let parameters = Parameters { xi, eta, psi, poisson_ratio, axis_ratio };
            let Totals { fx, fy, mz, stick } = self.model.model_totals::<F>(frame, &parameters);
            let [fx, fy, mz, stick] = [fx, fy, mz, stick].map(T::from_base);
            return Totals { fx, fy, mz, stick };
        }
        let (xi, eta, psi) = (Dual::input(xi, 0), Dual::input(eta, 1), Dual::input(psi, 2));
        let parameters = Parameters { xi, eta, psi, poisson_ratio, axis_ratio };
        let found = self.model.model_totals::<Dual<F, 3>>(frame, &parameters);
        let of = |total: Dual<F, 3>| T::composed(total.value, total.gradient, seen);
        let stick = T::from_base(found.stick.value);
        Totals { fx: of(found.fx), fy: of(found.fy), mz: of(found.mz), stick }
    }

    /// The linear theory: half-spaces and bristles at rest, `F` in newtons for creepages that were
    /// checked. Sliding does nothing.
    #[inline]
    fn linear<T: Number<Base = F>>(
        &self, [x, y, coupling, z]: [F; 4], creepage: &Creepage<T>, layer: T,
    ) -> [T; 3] {
        let Creepage { longitudinal, lateral, spin } = *creepage;
        let [k1, k2, ks] = self.layer.series(layer);
        let weight = T::one() - k1;
        let (vx, vy, phi) = (longitudinal * k1, lateral * k2, spin * ks);
        let [of_lateral, of_spin] = self.layer.moments();
        let half_spaces = phi.scale(z) - vy.scale(coupling);
        let bristles = phi.scale(z * of_spin) - vy.scale(coupling * of_lateral);
        [
            vx.scale(x),
            vy.scale(y) + phi.scale(coupling),
            half_spaces + (bristles - half_spaces) * weight,
        ]
    }
}

impl<F: Real, M: Theory<F>> Theory<F> for Layered<F, M> {
    const MODEL: Model = M::MODEL;

    #[inline]
    fn of_contact(frame: &ScaledContact<F>, options: &Options) -> Self {
        Self::new(frame, options, Interface { layer: F::zero(), slide: F::one() })
    }
    #[inline(always)]
    fn model_totals<T: Number<Base = F>>(
        &self, frame: &ScaledContact<F>, parameters: &Parameters<T>,
    ) -> Totals<T> {
        let Interface { layer, slide } = self.interface;
        let interface = Interface { layer: T::from_base(layer), slide: T::from_base(slide) };
        self.totals_through_layer(frame, parameters, &interface)
    }
    fn stiffness(&self) -> Option<&[F; 4]> {
        self.model.stiffness()
    }
    #[inline(always)]
    fn forces(&self, frame: &ScaledContact<F>, creepage: &Creepage<F>) -> (Forces<F>, F) {
        if let Some(stiffness) = self.stiffness() {
            let [fx, fy, mz] = self.linear(*stiffness, creepage, self.interface.layer);
            return (Forces { fx, fy, mz, adhesion: F::one() }, F::zero());
        }
        let parameters = frame.units.parameters(creepage);
        (frame.in_newtons(self.model_totals(frame, &parameters)), parameters.psi)
    }
}

impl<F: Float> SlipFriction<F> {
    /// Whether there is a layer, or a slide factor.
    #[inline]
    pub(crate) fn has_interface(&self) -> bool {
        Self::HAS_LAYER && (self.layer > F::zero() || self.slide_factor > F::zero())
    }

    /// In units of a length `a` of a clean contact.
    pub(crate) fn interface(&self, shear_modulus: F, a: F) -> Interface<F> {
        let slide = if self.slide_factor > F::zero() { self.slide_factor } else { F::one() };
        Interface { layer: (self.layer * (shear_modulus / a)).min(F::HUGE), slide }
    }
}

/// What leads a contact, stiff as [`SlipFriction::contact`] says, through a layer.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ThroughLayer<'a, F> {
    pub law: &'a SlipFriction<F>,
    pub creepage: &'a Creepage<F>,
    pub options: &'a Options,
}

impl<F: Float> ThroughLayer<'_, F> {
    pub(super) fn interface(&self, contact: &Contact<F>) -> Interface<F> {
        self.law.interface(contact.shear_modulus / self.law.slope_or_one(), contact.a)
    }

    /// Forces.
    pub fn solve(&self, contact: &Contact<F>) -> Result<Solution<F>, Error> {
        by_model!(self.options.model, F, solve_in(self, contact), Err(Error::ModelLeftOut))
    }

    /// Forces with their derivatives while friction stays; [`Error::Overflow`] also when one of
    /// these does not fit.
    pub fn differentiate(&self, contact: &Contact<F>) -> Result<WithSlopes<F>, Error> {
        let ordinary = contact.is_ordinary(self.creepage);
        if !ordinary {
            find_fault(contact, self.creepage, self.options.model)?;
        }
        if contact.is_lost() {
            return Ok(WithSlopes::default());
        }
        let frame = &ScaledContact::new(contact);
        let none = WithSlopes::default();
        let found = by_model!(self.options.model, F, differentiate_in(self, frame, ordinary), none);
        let (_, slopes, InterfaceSlopes { by_layer, by_slide, .. }) = &found;
        let fit = are_finite(&slopes.derivatives.entries())
            && are_finite(&by_layer.forces)
            && are_finite(&by_slide.forces)
            && are_finite(&[by_layer.power, by_slide.power]);
        Error::Overflow.unless(fit).map(|()| found)
    }
}

#[inline]
fn solve_in<F: Float, M: Theory<F>>(
    through: &ThroughLayer<F>, contact: &Contact<F>,
) -> Result<Solution<F>, Error> {
    solution_by(contact, through.creepage, |frame| {
        Layered::<F, M>::new(frame, through.options, through.interface(contact))
    })
}

fn differentiate_in<F: Float, M: Theory<F>>(
    through: &ThroughLayer<F>, frame: &ScaledContact<F>, ordinary: bool,
) -> WithSlopes<F> {
    let contact = &frame.contact;
    let layered = Layered::<F, M>::new(frame, through.options, through.interface(contact));
    let mut by_interface = [[F::zero(); 3]; 2];
    let (solution, slopes) =
        differentiated_by(&layered, frame, through.creepage, ordinary, |seen| {
            let (forces, psi, derivatives, found) = layered.with_slopes(frame, seen);
            by_interface = found;
            (forces, psi, derivatives)
        });
    // by λ = h G/(G₃ a) to that by h/G₃
    let unit = contact.shear_modulus / through.law.slope_or_one() / contact.a;
    let [of_layer, of_slide] = by_interface;
    let [by_layer, by_slide] = [scaled(of_layer, unit), of_slide]
        .map(|forces| Sensitivity { forces, power: slopes.seen.power(forces) });
    (solution, slopes, InterfaceSlopes { layer: through.law.layer, by_layer, by_slide })
}

impl<F: Float, M: Theory<F>> Layered<F, M> {
    /// Forces, `ψ`, their derivatives with respect to creepages, load and friction, and to `λ` and
    /// the slide factor.
    fn with_slopes(
        &self, frame: &ScaledContact<F>, creepage: &Creepage<F>,
    ) -> (Forces<F>, F, Derivatives<F>, [[F; 3]; 2]) {
        let inputs = creepage.inputs();
        let interface = Interface {
            layer: Variable::input(self.interface.layer, 3),
            slide: Variable::input(self.interface.slide, 4),
        };
        let stiffness = self.model.stiffness();
        // forces over what they are proportional to
        let (rows, psi, adhesion) = match stiffness {
            Some(stiffness) => {
                (self.linear(*stiffness, &inputs, interface.layer), F::zero(), F::one())
            }
            None => {
                let parameters = frame.units.parameters(&inputs);
                let Totals { fx, fy, mz, stick } =
                    self.totals_through_layer(frame, &parameters, &interface);
                ([fx, fy, mz], parameters.psi.value, stick.value)
            }
        };
        let layer = self.interface.layer;
        let ([fx, fy, mz], derivatives, by_interface) =
            unscaled(&rows, frame, creepage, layer, stiffness.is_some());
        (Forces { fx, fy, mz, adhesion }, psi, derivatives, by_interface)
    }
}

/// Forces, their derivatives, and those by `λ` and the slide factor, from the same divided by
/// `μ N`; those of the linear theory are not divided by anything.
fn unscaled<F: Float>(
    forces: &[Variable<F>; 3], frame: &ScaledContact<F>, creepage: &Creepage<F>, layer: F,
    is_linear: bool,
) -> ([F; 3], Derivatives<F>, [[F; 3]; 2]) {
    let ScaledContact { contact, radius, .. } = frame;
    let Creepage { longitudinal, lateral, spin } = *creepage;
    let one = F::one();
    let (lever, bound) = if is_linear { (one, one) } else { (*radius, contact.friction_bound()) };
    let [of_x, of_y, of_z] = *forces;
    let rows = [(of_x, one), (of_y, one), (of_z, lever)];
    let [fx, fy, mz] = rows.map(|(f, unit)| f.value * (bound * unit));
    let column = |i: usize| rows.map(|(f, unit)| f.derivative(i) * (bound * unit));
    let [by_x, by_y, by_spin, by_layer, by_slide] = [0, 1, 2, 3, 4].map(column);
    let jacobian = transposed([by_x, by_y, by_spin]);
    let translation = |f: &Variable<F>| f.derivative(0) * longitudinal + f.derivative(1) * lateral;
    let [mut euler, mut hertz] = [[F::zero(); 3]; 2];
    for (((f, unit), power), (euler, hertz)) in
        rows.iter().zip(POWERS).zip(euler.iter_mut().zip(&mut hertz))
    {
        let along = translation(f) + f.derivative(2) * spin;
        // λ falls with the load as the translation in f does
        let with_layer = translation(f) + f.derivative(3) * layer;
        [*euler, *hertz] = by_size(f.value, power, along, with_layer).map(|slope| *unit * slope);
    }
    let derivatives = if is_linear {
        let none = [F::zero(); 3];
        let load_through_hertz = hertz.map(|entry| entry / contact.normal_force);
        Derivatives { jacobian, normal_force: none, load_through_hertz, friction: none }
    } else {
        Derivatives {
            jacobian,
            normal_force: scaled(euler, contact.friction),
            load_through_hertz: scaled(hertz, contact.friction),
            friction: scaled(euler, contact.normal_force),
        }
    };
    ([fx, fy, mz], derivatives, [by_layer, by_slide])
}
