//! Rolling forward, backward, and standstill between them.
//!
//! **Creepage** is slip divided by rolling speed, which is not defined at standstill. A floor of
//! the speed makes it finite:
//!
//! ```text
//! V_f = √(V² + floor²),   υx, υy = slip/V_f,   φ = spin rate/V_f
//! ```
//!
//! At standstill the contact is then a damper of `C/floor`, where `C` is the slope of the creep
//! curve. With the default floor of 0.02 m/s a railway wheel that is held on a slope of 1:50 creeps
//! at 3 µm/s.
//!
//! **The leading edge** is at `x > 0` forward and at `x < 0` backward. Backward rolling is forward
//! rolling in axes turned by 180 degrees about `z`: the motion is turned and solved, and the
//! sense of the forces is restored. With `R = diag(−1, −1, 1)`
//!
//! ```text
//! F₊(c) = F(c),   F₋(c) = R F(R c),   F = w(V) F₊ + w(−V) F₋
//! w = (2 + 3t − t³)/4,   t = V/(3 floor)
//! ```
//!
//! `w` is 1 from `t = 1` on, so that beyond three floors only one end leads. Between, forces and
//! all derivatives are continuous. The forces of both ends oppose the slip and keep the bound,
//! hence their mean does: power `F · slip + M_z · spin rate ≥ 0`, `|F| ≤ μ N`. Motion turned by 180
//! degrees gives turned forces, to the bit.
//!
//! **Dissimilar materials.** The slip velocity that pressure adds is `V Δυx`: it is proportional to
//! the rolling speed and changes its sign with it. So the mismatch is `±κ V/V_f` at the two ends
//! and zero at standstill, and the forces of both ends oppose the same slip.
//!
//! **Falling friction** uses `V_f` as its rolling speed, so that friction falls with the slip
//! velocity also at standstill. Each end has the friction that agrees with its own slip.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::contact::implausibility;
use crate::forces::{Options, Solution};
use crate::friction::derivatives::{self, Differentiated};
use crate::friction::{FrictionSolution, InMotion, SlipFriction};
use crate::number::{Float, add, are_finite};
use crate::status::{Error, Warning};

/// Floor of the rolling speed where none is given \[m/s\].
const SPEED_FLOOR: f64 = 0.02;
/// Rolling speed, divided by the floor, beyond which only one end of the contact leads.
const BLENDED: f64 = 3.0;
/// Share of the mismatch that is used at standstill to compute the derivative with respect to it:
/// forces are linear in so small a mismatch.
const STANDSTILL: f64 = 1e-9;
/// Least speed at which creepages are checked for plausibility \[m/s\]: below this speed any slip
/// is plausible.
const JUDGED: f64 = 1.0;

/// Motion of the upper body relative to the lower one at the contact, in axes that stay when the
/// motion reverses.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion<F> {
    /// Velocity of the upper relative to the lower body along x \[m/s\].
    pub slip_x: F,
    /// Velocity of the upper relative to the lower body along y \[m/s\].
    pub slip_y: F,
    /// Angular velocity of the upper relative to the lower body about z \[rad/s\].
    pub spin_rate: F,
    /// Rolling speed \[m/s\]: positive along x, negative backward, zero at standstill.
    pub rolling_speed: F,
    /// Floor of the speed \[m/s\], >= 0, else KSTRIP_ERROR_FLOOR_SPEED; 0 stands for 0.02.
    /// Creepages are slip divided by sqrt(rolling_speed^2 + floor_speed^2).
    pub floor_speed: F,
}

/// Derivatives of fx, fy, mz with respect to motion, load and friction.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionDerivatives<F> {
    /// With respect to slip_x, slip_y, spin_rate, row by row \[N, N, N m per m/s, m/s, rad/s\].
    pub slip: [[F; 3]; 3],
    /// With respect to the rolling speed at constant slip and spin rate \[N, N, N m per m/s\].
    pub rolling_speed: [F; 3],
    /// With respect to the normal force at fixed a and b \[-, -, m\].
    pub normal_force: [F; 3],
    /// With respect to the normal force while a and b grow with its cube root \[-, -, m\].
    pub load_through_hertz: [F; 3],
    /// With respect to the coefficient of friction (of the law, if given) \[N, N, N m\].
    pub friction: [F; 3],
    /// With respect to the ratio of the law; 0 without one \[N, N, N m\].
    pub ratio: [F; 3],
    /// With respect to the decay of the law; 0 without one \[N, N, N m per s/m\].
    pub decay: [F; 3],
    /// With respect to the slope factor of the law, at 1 without one \[N, N, N m\].
    pub slope_factor: [F; 3],
    /// With respect to the slide factor; 0 if it is 0 in a law without a layer \[N, N, N m\].
    pub slide_factor: [F; 3],
    /// With respect to the layer of the law; 0 where there is none \[N, N, N m per m/Pa\].
    pub layer: [F; 3],
}

/// Forces of a contact that rolls forward, backward or not at all, with the power in watts,
/// `F · slip + M_z · spin rate`; and the coefficient of friction. The rolling speed of the law is
/// not used.
///
/// # Errors
/// Those of [`forces_of_contact`](crate::forces::forces_of_contact) and [`SlipFriction::check`];
/// [`Error::NotFinite`], [`Error::FloorSpeed`].
///
/// # Example
/// A wheel that stands on a slope creeps, and one that rolls back is braked:
/// ```
/// use kstrip::{contact::Contact, forces::Options, motion::{solve_motion, Motion}};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, friction: 0.3,
///     shear_modulus: 82e9, poisson_ratio: 0.28, mismatch: 0.0,
/// };
/// let creeps = Motion { slip_x: 5e-6, ..Motion::default() };
/// let backward = Motion { slip_x: 1e-3, rolling_speed: -2.0, ..Motion::default() };
/// for motion in [creeps, backward] {
///     let (forces, _) = solve_motion(&contact, &motion, None, &Options::default())?;
///     assert!(forces.fx > 0.0 && forces.power > 0.0);
/// }
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn solve_motion<F: Float>(
    contact: &Contact<F>, motion: &Motion<F>, law: Option<&SlipFriction<F>>, options: &Options,
) -> Result<(Solution<F>, F), Error> {
    let rolling = Rolling::new(motion)?;
    let law = law.map(|law| SlipFriction { rolling_speed: rolling.speed, ..*law });
    let ratio = rolling.speed_by_rolling;
    let [forward, backward] = rolling.each_end_of(contact, ratio, |contact, creepage| {
        let motion = InMotion { creepage, law: law.as_ref(), options };
        motion.check(contact)?;
        let FrictionSolution { solution, friction } = motion.solve(contact)?;
        Ok((solution, friction))
    })?;
    rolling.blended(&with_friction_of_law(contact, law.as_ref()), forward, backward)
}

/// [`solve_motion`] with derivatives with respect to all inputs.
///
/// # Errors
/// Those of [`solve_motion`]; [`Error::Overflow`] also when a derivative does not fit the
/// floating-point type.
pub fn differentiate_motion<F: Float>(
    contact: &Contact<F>, motion: &Motion<F>, law: Option<&SlipFriction<F>>, options: &Options,
) -> Result<(Solution<F>, F, MotionDerivatives<F>), Error> {
    let rolling = Rolling::new(motion)?;
    let law = law.map(|law| SlipFriction { rolling_speed: rolling.speed, ..*law });
    let differentiate = |contact: &Contact<F>, creepage: &Creepage<F>| {
        derivatives::differentiate_with_law(contact, creepage, law.as_ref(), options)
    };
    let ends = |ratio: F| rolling.each_end_of(contact, ratio, differentiate);
    let [forward, backward] = ends(rolling.speed_by_rolling)?;
    let by_mismatch = rolling.through_mismatch(contact.mismatch, ends)?;
    let found = |of: &Differentiated<F>| (of.solution, of.friction);
    let contact = with_friction_of_law(contact, law.as_ref());
    let (solution, friction) = rolling.blended(&contact, found(&forward), found(&backward))?;
    let slopes = rolling.slopes(&forward, &backward, by_mismatch);
    Error::Overflow.unless(slopes.entries().all(F::is_finite_number))?;
    Ok((solution, friction, slopes))
}

/// The contact with the friction of the law, if there is one.
fn with_friction_of_law<F: Float>(
    contact: &Contact<F>, law: Option<&SlipFriction<F>>,
) -> Contact<F> {
    Contact { friction: law.map_or(contact.friction, |law| law.friction), ..*contact }
}

/// The creepages of a motion, and the shares of both ends.
pub(crate) struct Rolling<F> {
    motion: Motion<F>,
    /// `V_f` \[m/s\]
    pub(crate) speed: F,
    /// `∂V_f/∂V = V/V_f`
    pub(crate) speed_by_rolling: F,
    /// `w(V)`, `w(−V)`
    shares: [F; 2],
    /// `dw/dV` \[s/m\], the same for `w(V)` and, negative, for `w(−V)`
    pub(crate) share_slope: F,
    creepage: Creepage<F>,
}

impl<F: Float> Rolling<F> {
    pub(crate) fn new(motion: &Motion<F>) -> Result<Self, Error> {
        let Motion { slip_x, slip_y, spin_rate, rolling_speed, floor_speed } = *motion;
        let inputs = [slip_x, slip_y, spin_rate, rolling_speed, floor_speed];
        Error::NotFinite.unless(are_finite(&inputs))?;
        Error::FloorSpeed.unless(floor_speed >= F::zero())?;
        let floor = if floor_speed > F::zero() { floor_speed } else { F::constant(SPEED_FLOOR) };
        // V_f = √(V² + floor²), whose squares may overflow or vanish
        let (larger, smaller) = (floor.max(rolling_speed.abs()), floor.min(rolling_speed.abs()));
        let speed = larger * (smaller / larger).squared().plus(1.0).sqrt();
        // w(V) = (2 + 3t − t³)/4,  t = V/(3 floor)
        let t = (rolling_speed / floor.times(BLENDED)).clamped(-F::one(), F::one());
        let odd = t * (F::constant(3.0) - t * t);
        let shares = [odd, -odd].map(|odd| odd.plus(2.0).times(0.25));
        let share_slope = (F::one() - t * t) / floor.times(4.0 * BLENDED / 3.0);
        let creepage = Creepage {
            longitudinal: slip_x / speed,
            lateral: slip_y / speed,
            spin: spin_rate / speed,
        };
        creepage.check().map_err(|_| Error::Overflow)?;
        let speed_by_rolling = rolling_speed / speed;
        Ok(Self { motion: *motion, speed, speed_by_rolling, shares, share_slope, creepage })
    }

    /// The results for forward rolling, and for backward rolling in axes turned by 180 degrees; the
    /// argument of the function tells whether the axes are turned. Where only one end leads, both
    /// results are those of this end, and one of them has a share of zero.
    pub(crate) fn each_end<S: Copy>(
        &self, mut solve: impl FnMut(&Creepage<F>, bool) -> Result<S, Error>,
    ) -> Result<[S; 2], Error> {
        let Creepage { longitudinal, lateral, spin } = self.creepage;
        let turned = Creepage { longitudinal: -longitudinal, lateral: -lateral, spin };
        let [ahead, behind] = self.shares;
        if behind <= F::zero() {
            return solve(&self.creepage, false).map(|found| [found; 2]);
        }
        if ahead <= F::zero() {
            return solve(&turned, true).map(|found| [found; 2]);
        }
        Ok([solve(&self.creepage, false)?, solve(&turned, true)?])
    }

    /// [`Self::each_end`] of a contact whose ends have the mismatch `±κ V/V_f`; the argument is
    /// that ratio.
    fn each_end_of<S: Copy>(
        &self, contact: &Contact<F>, ratio: F,
        solve: impl Fn(&Contact<F>, &Creepage<F>) -> Result<S, Error>,
    ) -> Result<[S; 2], Error> {
        self.each_end(|creepage, turned| {
            let mismatch = contact.mismatch * if turned { -ratio } else { ratio };
            solve(&Contact { mismatch, ..*contact }, creepage)
        })
    }

    /// `∂F/∂κ_V ∂κ_V/∂V` of the mismatch `κ_V = κ V/V_f`, `∂κ_V/∂V = κ floor²/V_f³`.
    /// The function gives the derivatives at both ends for a ratio `V/V_f`.
    pub(crate) fn through_mismatch(
        &self, mismatch: F, ends: impl FnOnce(F) -> Result<[Differentiated<F>; 2], Error>,
    ) -> Result<[F; 3], Error> {
        if mismatch == F::zero() {
            return Ok([F::zero(); 3]);
        }
        let (near, rate) = self.through_ratio();
        let [forward, backward] = ends(near)?;
        let both = self.both_ends(forward.by_mismatch, backward.by_mismatch);
        Ok(both.map(|entry| entry * rate))
    }

    /// A ratio `V/V_f` that is not zero, and the factor of `κ_V ∂F/∂κ_V` there in the derivative
    /// with respect to `V`. (It is divided by `κ_V`, which at standstill is replaced by a small
    /// share of `κ`.)
    pub(crate) fn through_ratio(&self) -> (F, F) {
        let ratio = self.speed_by_rolling;
        let least = F::constant(STANDSTILL);
        let near = if ratio.abs() < least { least } else { ratio };
        (near, (F::one() - ratio * ratio) / (self.speed * near))
    }

    /// `w(V) p + w(−V) q`, exactly `p` where both are the same.
    pub(crate) fn mean(&self, p: F, q: F) -> F {
        let [ahead, behind] = self.shares;
        if p == q { p } else { ahead * p + behind * q }
    }

    /// `w(V) F₊ + w(−V) R F₋` of forces, or of their derivatives with respect to quantities that do
    /// not turn.
    pub(crate) fn both_ends(
        &self, [x, y, z]: [F; 3], [turned_x, turned_y, z_turned]: [F; 3],
    ) -> [F; 3] {
        [self.mean(x, -turned_x), self.mean(y, -turned_y), self.mean(z, z_turned)]
    }

    fn blended(
        &self, contact: &Contact<F>, (forward, friction): (Solution<F>, F),
        (backward, friction_backward): (Solution<F>, F),
    ) -> Result<(Solution<F>, F), Error> {
        let [fx, fy, mz] = self.both_ends(forward.components(), backward.components());
        // F · slip; both ends have the same slip.
        let power = self.mean(forward.power, backward.power) * self.speed;
        Error::Overflow.unless(power.is_finite_number())?;
        // Below JUDGED any slip is plausible.
        let judged = (self.speed / F::constant(JUDGED)).min(F::one());
        let seen = self.creepage.scaled(judged);
        let both = forward.warning.worse(backward.warning);
        let of_model = if both.is_implausible() { Warning::None } else { both };
        let warning = of_model.worse(implausibility(contact, &seen));
        let adhesion = self.mean(forward.adhesion, backward.adhesion);
        let solution = Solution { fx, fy, mz, power, adhesion, warning, ..forward };
        Ok((solution, self.mean(friction, friction_backward)))
    }

    pub(crate) fn slopes(
        &self, forward: &Differentiated<F>, backward: &Differentiated<F>, by_mismatch: [F; 3],
    ) -> MotionDerivatives<F> {
        let (ahead, behind) = (&forward.derivatives, &backward.derivatives);
        let ([ax, ay, az], [bx, by, bz]) = (ahead.jacobian, behind.jacobian);
        // J₋ = R J R
        let turned = |[x, y, z]: [F; 3], sign: F| [x * sign, y * sign, -(z * sign)];
        let per_speed = |ahead: [F; 3], behind: [F; 3]| {
            let [[x, y, z], [u, v, w]] = [ahead, behind];
            [self.mean(x, u), self.mean(y, v), self.mean(z, w)].map(|slope| slope / self.speed)
        };
        let one = F::one();
        let slip = [
            per_speed(ax, turned(bx, one)),
            per_speed(ay, turned(by, one)),
            per_speed(az, turned(bz, -one)),
        ];
        let by_law = self.both_ends(forward.law.rolling_speed, backward.law.rolling_speed);
        // dF/dV = w' (F₊ − F₋) + (∂F/∂V_f − (∂F/∂slip) slip/V_f) ∂V_f/∂V
        let Motion { slip_x, slip_y, spin_rate, .. } = self.motion;
        let ([fx, fy, mz], [gx, gy, gz]) =
            (forward.solution.components(), backward.solution.components());
        let apart = [fx + gx, fy + gy, mz - gz];
        let mut rolling_speed = apart.map(|apart| apart * self.share_slope);
        for ((entry, [x, y, z]), by_law) in rolling_speed.iter_mut().zip(slip).zip(by_law) {
            let falls = (x * slip_x + y * slip_y + z * spin_rate) / self.speed;
            *entry += (by_law - falls) * self.speed_by_rolling;
        }
        add(&mut rolling_speed, by_mismatch);
        MotionDerivatives {
            slip,
            rolling_speed,
            normal_force: self.both_ends(ahead.normal_force, behind.normal_force),
            load_through_hertz: self.both_ends(ahead.load_through_hertz, behind.load_through_hertz),
            friction: self.both_ends(ahead.friction, behind.friction),
            ratio: self.both_ends(forward.law.ratio, backward.law.ratio),
            decay: self.both_ends(forward.law.decay, backward.law.decay),
            slope_factor: self.both_ends(forward.law.slope_factor, backward.law.slope_factor),
            slide_factor: self.both_ends(forward.law.slide_factor, backward.law.slide_factor),
            layer: self.both_ends(forward.law.layer, backward.law.layer),
        }
    }
}

impl<F: Float> MotionDerivatives<F> {
    pub(crate) fn entries(&self) -> impl Iterator<Item = F> {
        let Self { slip, rolling_speed, normal_force, load_through_hertz, friction, .. } = *self;
        let Self { ratio, decay, slope_factor, slide_factor, layer, .. } = *self;
        let others = [rolling_speed, normal_force, load_through_hertz, friction];
        let of_law = [ratio, decay, slope_factor, slide_factor, layer];
        slip.into_iter().chain(others).chain(of_law).flatten()
    }
}
