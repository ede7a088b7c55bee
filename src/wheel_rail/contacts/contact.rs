//! One contact of a wheel: where its strips are on the wheel, the direction of its pressure, and
//! its motion as the wheel moves.
//!
//! **Each strip has a direction of its own**: at angle `a` the tangent `t = (0, cos a, sin a)` and
//! the normal into the rail `n = (0, −sin a, cos a)`; its point `p` is on the wheel's undeformed
//! surface. With the wheel's velocity `v` and rates `ω`
//!
//! ```text
//! slip_x = (v + ω×p)·e_x,   slip_y = (v + ω×p)·t,   spin rate = ω·n;   V = (v_x − (ω×p)_x)/2
//! ```
//!
//! On a roller `e_x`, `t` and `n` are turned by the angle `φ` at which `p` is over its axis
//! (`roller`).
//!
//! The spin has the normal of each body's own undeformed surface, as the slip has its radius: thus
//! the slip changes across the strips as its spin says. The surface of the rail moves backward with
//! its speed, on a roller with `V r/R`, where `r` is the radius of the roller's surface under the
//! strip. Creep forces are computed strip by strip with these (`curved`). The patch has their mean,
//! weighted with the strips' loads `N` and referred to its origin: for TOTAL, which has no strips.
//! The force of the pressure is `Σ N n`.

use super::view::Place;
use crate::motion::Motion;
use crate::number::{Float, add, are_finite, at, length, set_at};
use crate::patch::{KSTRIP_PATCH_CAPACITY, Patch};
use crate::status::Error;
use crate::wheel_rail::touch::line_of_contact::{Axes, Turn, with_moment};
use crate::wheel_rail::touch::roller::{Over, Roller};
use crate::wheel_rail::{Position, Velocity, WheelPair, dot, sine_cosine};

/// Turn of the normal over a contact \[rad\] from which one plane is not enough.
const FLAT: f64 = 30.0 * core::f64::consts::PI / 180.0;

/// One contact of a wheel. Its frame (x, t, n): forward, across the surface, into the rail.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelContact<F> {
    /// Point where the pressure acts, on the wheel's undeformed surface, from the wheel's centre
    /// \[m\], axes of the track.
    pub origin: [F; 3],
    /// Angle of the contact plane \[rad\]: mean of the strips' angles, weighted with load. For a
    /// left wheel it is that of the mirrored right wheel.
    pub angle: F,
    /// Range of the angle over the patch \[rad\]; above 0.52 KSTRIP_WARNING_ANGLE_RANGE.
    pub angle_range: F,
    /// Distance of the origin from the axle \[m\].
    pub radius: F,
    /// Load of the strips \[N\], >= 0, else KSTRIP_ERROR_NORMAL_FORCE.
    pub normal_force: F,
    /// Factor of load and forces in the sum over the contacts \[-\], >= 0, else KSTRIP_ERROR_SHARE:
    /// 1, except for contacts 5 to 7 mm apart, whose result blends separate contacts with a merged
    /// one.
    pub share: F,
    /// Overlap of the undeformed, smoothed surfaces where it is deepest \[m\].
    pub approach: F,
    /// Derivative of the load with respect to the distance by which the surfaces are moved into
    /// each other \[N/m\].
    pub stiffness: F,
    /// Length on the rail at y = 0 of the patch \[m\].
    pub along: F,
    /// Derivatives of the wheel's velocity into the rail, mean of the strips weighted with load,
    /// with respect to the members of kstrip_wheel_velocity. The wrench of the pressure on the
    /// wheel is minus share times normal_force times these six numbers, and times the factor of
    /// the damping.
    pub normal: [F; 6],
    /// slip_x of kstrip_motion at the patch's origin: derivatives with respect to the members of
    /// kstrip_wheel_velocity.
    pub slip_x: [F; 6],
    /// slip_y of kstrip_motion.
    pub slip_y: [F; 6],
    /// spin_rate of kstrip_motion.
    pub spin_rate: [F; 6],
    /// rolling_speed of kstrip_motion.
    pub rolling_speed: [F; 6],
    /// normal_damping of kstrip_wheel_pair; a negative one is KSTRIP_ERROR_NORMAL_DAMPING.
    pub normal_damping: F,
    /// kstrip_motion of a wheel at rest: that of the rail's surface, mean of the strips weighted
    /// with load, with the floor of the speed; a negative floor is KSTRIP_ERROR_FLOOR_SPEED.
    pub at_rest: Motion<F>,
    /// The strips; y along the rail's surface, x forward from the origin.
    pub patch: Patch<F>,
    /// x and z of a roller's axis from the wheel's centre \[m\]; 0 and 0 for a straight rail.
    pub rail_axis: [F; 2],
    /// Rate of a roller about its axis \[rad/s\]: rail_speed/rail_radius; 0: a straight rail.
    pub rail_rate: F,
    /// Speed of the rail's surface at each strip, backward \[m/s\]: rail_speed; on a roller
    /// rail_rate times the radius of the roller's undeformed surface there.
    pub strip_rail_speed: [F; KSTRIP_PATCH_CAPACITY],
    /// y of each strip on the wheel's undeformed surface, from the wheel's centre \[m\], axes of
    /// the track; of a left wheel that of the mirrored right wheel.
    pub strip_y: [F; KSTRIP_PATCH_CAPACITY],
    /// z of each strip \[m\].
    pub strip_z: [F; KSTRIP_PATCH_CAPACITY],
    /// Angle of each strip \[rad\], as the angle of the contact: the mean of those of both
    /// undeformed surfaces.
    pub strip_angle: [F; KSTRIP_PATCH_CAPACITY],
    /// Tangent of half the angle between the undeformed surfaces at each strip: the angle of the
    /// wheel's is less than strip_angle by the arc tangent of this, that of the rail's is more.
    pub strip_lean: [F; KSTRIP_PATCH_CAPACITY],
    /// Roll and yaw of the wheel \[rad\]; of a left wheel those of the mirrored right wheel.
    pub turned: [F; 2],
    /// Whether the wheel is a left one, as in kstrip_wheel_pair.
    pub left: i32,
    /// Reserved: zero.
    pub reserved: i32,
}

impl<F: Float> WheelContact<F> {
    /// A contact without strips.
    pub(crate) const fn nothing() -> Self {
        let (zero, none, places) = (F::ZERO, [F::ZERO; 6], [F::ZERO; KSTRIP_PATCH_CAPACITY]);
        Self {
            origin: [zero; 3],
            angle: zero,
            angle_range: zero,
            radius: zero,
            normal_force: zero,
            share: zero,
            approach: zero,
            stiffness: zero,
            along: zero,
            normal: none,
            slip_x: none,
            slip_y: none,
            spin_rate: none,
            rolling_speed: none,
            normal_damping: zero,
            at_rest: Motion {
                slip_x: zero,
                slip_y: zero,
                spin_rate: zero,
                rolling_speed: zero,
                floor_speed: zero,
            },
            patch: Patch::nothing(),
            rail_axis: [zero; 2],
            rail_rate: zero,
            strip_rail_speed: places,
            strip_y: places,
            strip_z: places,
            strip_angle: places,
            strip_lean: places,
            turned: [zero; 2],
            left: 0,
            reserved: 0,
        }
    }

    /// `B`: slip and spin rate by the wheel's velocity.
    pub(crate) fn rows(&self) -> [[F; 6]; 3] {
        [self.slip_x, self.slip_y, self.spin_rate]
    }

    /// Where a point of the wheel is over the rail.
    pub(crate) fn over(&self, x: F, z: F) -> Over<F> {
        match self.rail_axis {
            [_, down] if down == F::zero() => Over::straight(),
            axis => Over::of_axis(axis, x, z),
        }
    }

    /// The axes of the wheel.
    pub(crate) fn axes(&self) -> Axes<F> {
        let [roll, yaw] = self.turned;
        let turn = Turn::new(&Position { roll, yaw, ..Position::default() });
        Axes { turn, left: self.left != 0 }
    }

    /// The columns of `B`.
    pub(crate) fn columns(&self) -> [[F; 3]; 6] {
        core::array::from_fn(|k| self.rows().map(|row| at(&row, k)))
    }

    /// The motion of the wheel over the rail at the contact.
    pub fn motion(&self, velocity: &[F; 6]) -> Motion<F> {
        let [slip_x, slip_y, spin_rate] = self.rows().map(|row| dot(&row, velocity));
        let rolling_speed = dot(&self.rolling_speed, velocity);
        let rest = self.at_rest;
        Motion {
            slip_x: slip_x + rest.slip_x,
            slip_y: slip_y + rest.slip_y,
            spin_rate: spin_rate + rest.spin_rate,
            rolling_speed: rolling_speed + rest.rolling_speed,
            floor_speed: rest.floor_speed,
        }
    }

    /// The same, checked.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::Overflow`].
    pub fn checked_motion(&self, velocity: &Velocity<F>) -> Result<Motion<F>, Error> {
        let velocity = velocity.members();
        let motion = self.motion(&velocity);
        let members = |motion: &Motion<F>| {
            let Motion { slip_x, slip_y, spin_rate, rolling_speed, floor_speed } = *motion;
            [slip_x, slip_y, spin_rate, rolling_speed, floor_speed]
        };
        let given = [&velocity[..], &members(&self.at_rest), &self.rolling_speed];
        let [x, y, spin] = self.rows();
        let is_given = given.into_iter().chain([&x[..], &y, &spin]).all(are_finite);
        Error::NotFinite.unless(is_given)?;
        Error::Overflow.unless(are_finite(&members(&motion))).map(|()| motion)
    }

    /// Whether its numbers are possible.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let (share, normal_force) = (self.share, self.normal_force);
        let is_finite = are_finite(&self.normal) && are_finite(&[share, normal_force]);
        Error::NotFinite.unless(is_finite)?;
        Error::Share.when(share < F::zero())?;
        Error::NormalForce.when(normal_force < F::zero())
    }

    /// The factor by which damping changes the pressure: `max(0, 1 + d v_n)`, with the velocity
    /// `v_n` of the wheel into the rail.
    pub(crate) fn damping_factor(&self, velocity: &[F; 6]) -> Result<F, Error> {
        let damping = self.normal_damping;
        Error::NotFinite.unless(damping.is_finite_number())?;
        Error::NormalDamping.unless(damping >= F::zero())?;
        let factor = (damping * dot(&self.normal, velocity)).plus(1.0).max(F::zero());
        if factor.is_finite_number() { Ok(factor) } else { Err(Error::Overflow) }
    }

    pub(crate) fn is_finite(&self) -> bool {
        let numbers = [self.radius, self.normal_force, self.approach, self.stiffness, self.along];
        let rows = [self.normal, self.rolling_speed].into_iter().chain(self.rows());
        let Motion { slip_x, spin_rate, .. } = self.at_rest;
        let of_rail = [slip_x, spin_rate, self.rail_rate];
        let are_finite = are_finite(&numbers) && are_finite(&of_rail);
        are_finite && rows.flatten().all(F::is_finite_number)
    }

    /// The largest peak pressure of the strips \[Pa\].
    pub(crate) fn peak_pressure(&self) -> F {
        self.patch.used().iter().fold(F::zero(), |most, strip| most.max(strip.peak_pressure))
    }

    /// Length along the rail from the first strip to the last \[m\].
    pub(crate) fn width(&self) -> F {
        match (self.patch.used().first(), self.patch.used().last()) {
            (Some(first), Some(last)) => last.y - first.y + (first.width + last.width).times(0.5),
            _ => F::LARGEST,
        }
    }

    /// Whether the normal turns by too much for one plane of contact.
    pub(crate) fn is_conformal(&self) -> bool {
        self.angle_range > F::of(FLAT)
    }

    /// Fills the contact from strips along the rail, of a pair at the position of a right wheel, or
    /// of the mirror image of a left one. `place` gives the place of a strip by its number and its
    /// length along the rail.
    pub(crate) fn fill(
        &mut self, pair: &WheelPair<F>, position: &Position<F>, strips: &Patch<F>,
        [approach, stiffness]: [F; 2], place: impl Fn(usize, F) -> Place<F>,
    ) {
        self.patch = *strips;
        let roller = Roller::new(pair, position);
        (self.rail_axis, self.rail_rate) = match roller {
            Some(own) => (own.axis(), pair.rail_speed / pair.rail_radius),
            None => ([F::zero(); 2], F::zero()),
        };
        let (sums, faster) = self.sums_of_strips(pair, position.lateral, place);
        let [[.., load], _, _] = sums;
        let share = F::one() / (load + F::TINY);
        let [[x, y, z, along, angle, _], tangent, normal] =
            sums.map(|sums| sums.map(|sum| sum * share));
        for strip in self.patch.strips.iter_mut().take(self.patch.count as usize) {
            (strip.y, strip.centre_x) = (strip.y - along, strip.centre_x - x);
        }
        (self.turned, self.left, self.reserved) = ([position.roll, position.yaw], pair.left, 0);
        self.origin = [x, if pair.left != 0 { -y } else { y }, z];
        let [in_x, _, in_z] = self.axes().turn.to_wheelset([x, y, z]);
        self.radius = length(in_x, in_z);
        (self.normal_force, self.along, self.angle) = (load, along, angle);
        (self.approach, self.stiffness) = (approach, stiffness);
        self.normal_damping = pair.normal_damping;
        let rail_speed = pair.rail_speed + faster * share;
        self.set_motion([x, y, z], [tangent, normal], rail_speed, pair.floor_speed);
    }

    /// Places of the strips on the wheel, the speed of the rail under them, and their friction.
    /// Returns sums weighted with load: of place, length along the rail, angle and 1; of the
    /// tangent and of the normal with their moments; and of the speed of the rail over that of its
    /// pair.
    fn sums_of_strips(
        &mut self, pair: &WheelPair<F>, lateral: F, place: impl Fn(usize, F) -> Place<F>,
    ) -> ([[F; 6]; 3], F) {
        let (mut sums, mut faster) = ([[F::zero(); 6]; 3], F::zero());
        let (mut lowest, mut highest) = (F::LARGEST, -F::LARGEST);
        for k in 0..self.patch.count as usize {
            let Some(strip) = self.patch.strips.get_mut(k) else { break };
            let Place { point: [x, y, z], angle, lean, over, rail_speed } = place(k, strip.y);
            set_at(&mut self.strip_y, k, y);
            set_at(&mut self.strip_z, k, z);
            set_at(&mut self.strip_angle, k, angle);
            set_at(&mut self.strip_lean, k, lean);
            set_at(&mut self.strip_rail_speed, k, rail_speed);
            (lowest, highest) = (lowest.min(angle), highest.max(angle));
            let (sine, cosine) = sine_cosine(angle);
            let terms = [
                [x, y, z, strip.y, angle, F::one()],
                with_moment([x, y, z], over.turned(cosine, sine)),
                with_moment([x, y, z], over.turned(-sine, cosine)),
            ];
            let load = strip.load();
            for (sums, terms) in sums.iter_mut().zip(terms) {
                add(sums, terms.map(|term| load * term));
            }
            faster += load * (rail_speed - pair.rail_speed);
            strip.friction = pair.friction_at_rail(lateral + y);
        }
        self.angle_range = highest - lowest;
        (sums, faster)
    }

    /// Derivatives of slip, spin and rolling speed at a place with respect to the wheel's velocity,
    /// and the motion of a rail with this speed.
    fn set_motion(
        &mut self, place: [F; 3], [tangent, normal]: [[F; 6]; 2], rail_speed: F, floor_speed: F,
    ) {
        let (zero, [x, _, z], [a, b, c, ..]) = (F::zero(), place, normal);
        let over = self.over(x, z);
        let forward = with_moment(place, [over.cosine, zero, over.sine]);
        // V = (v_x − (ω×p)_x)/2
        let mut rolling = forward.map(|entry| entry.times(-0.5));
        let [speed, ..] = &mut rolling;
        *speed = speed.plus(1.0);
        let axes = self.axes();
        let own = |row| axes.members(row);
        self.normal = own(normal);
        (self.slip_x, self.slip_y) = (own(forward), own(tangent));
        (self.spin_rate, self.rolling_speed) = (own([zero, zero, zero, a, b, c]), own(rolling));
        self.at_rest = Motion {
            slip_x: rail_speed,
            slip_y: zero,
            spin_rate: -b * self.rail_rate,
            rolling_speed: rail_speed.times(0.5),
            floor_speed,
        };
    }
}
