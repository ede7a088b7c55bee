//! Rolling in either direction, standstill between them.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::friction::SlipFriction;
use crate::solve::derivatives::{Derivatives, Differentiated, differentiate as at_creepage};
use crate::solve::model::{Options, Precision, Solution};
use crate::status::Error;

/// How the upper body moves over the lower one at the contact.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion<F> {
    /// Velocity of the upper over the lower body along x \[m/s\].
    pub slip_x: F,
    /// Along y \[m/s\].
    pub slip_y: F,
    /// Angular velocity of the upper over the lower body about z \[rad/s\].
    pub spin_rate: F,
    /// Rolling speed \[m/s\]: positive along x, negative backward.
    pub rolling_speed: F,
    /// Speed below which creepages grow no further \[m/s\], >= 0; 0: 0.02.
    pub floor_speed: F,
}

/// Derivatives of fx, fy, mz by the motion, by load and by friction.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionDerivatives<F> {
    /// By slip_x, slip_y, spin_rate, row by row \[N, N, N m over m/s, m/s, rad/s\].
    pub slip: [[F; 3]; 3],
    /// By the rolling speed \[N, N, N m over m/s\].
    pub rolling_speed: [F; 3],
    /// By the normal force at fixed a and b \[-, -, m\].
    pub normal_force: [F; 3],
    /// By the normal force while a and b follow it as Hertz says \[-, -, m\].
    pub load_through_hertz: [F; 3],
    /// By the coefficient of friction, that of the law where there is one \[N, N, N m\].
    pub friction: [F; 3],
}

/// Forces of a contact that rolls forward, backward or not at all; power in watts; and the coefficient of friction.
///
/// # Errors
/// Those of [`differentiate`](at_creepage), [`Error::FloorSpeed`].
pub fn solve<F: Precision>(
    contact: &Contact<F>,
    motion: &Motion<F>,
    law: Option<&SlipFriction<F>>,
    options: &Options,
) -> Result<(Solution<F>, F), Error> {
    differentiate(contact, motion, law, options).map(|(solution, friction, _)| (solution, friction))
}

/// [`solve`] with derivatives.
///
/// # Errors
/// Those of [`solve`].
pub fn differentiate<F: Precision>(
    contact: &Contact<F>,
    motion: &Motion<F>,
    law: Option<&SlipFriction<F>>,
    options: &Options,
) -> Result<(Solution<F>, F, MotionDerivatives<F>), Error> {
    let Motion { slip_x, slip_y, spin_rate, rolling_speed, floor_speed } = *motion;
    let inputs = [slip_x, slip_y, spin_rate, rolling_speed, floor_speed];
    if !inputs.iter().all(|input| input.is_finite_number()) {
        return Err(Error::NotFinite);
    }
    if floor_speed < F::zero() {
        return Err(Error::FloorSpeed);
    }
    let floor = if floor_speed > F::zero() { floor_speed } else { F::constant(0.02) };
    // V_f = √(V² + floor²)
    let speed = (rolling_speed * rolling_speed + floor * floor).sqrt();
    let law = law.map(|law| SlipFriction { rolling_speed: speed, ..*law });
    // forward, and backward with the patch turned by 180 degrees
    let solve = |sign: F| {
        let creepage = Creepage {
            longitudinal: sign * slip_x / speed,
            lateral: sign * slip_y / speed,
            spin: spin_rate / speed,
        };
        at_creepage(contact, &creepage, law.as_ref(), options)
    };
    // the share of forward rolling (1 + V/V_f (3 − V²/V_f²)/2)/2, and its slope by V
    let u = rolling_speed / speed;
    let share = (F::one() + (u * (F::constant(3.0) - u * u)).times(0.5)).times(0.5);
    let by_u = (F::one() - u * u).times(0.75);
    let by_speed = by_u * (F::one() - u * u) / speed;
    let ahead = solve(F::one())?;
    let behind = solve(-F::one())?;
    let other = F::one() - share;
    let turned = [-F::one(), -F::one(), F::one()];
    let both = |ahead: [F; 3], behind: [F; 3]| -> [F; 3] {
        let [a, b, c] = ahead;
        let [d, e, f] = behind;
        [share * a - other * d, share * b - other * e, share * c + other * f]
    };
    let of = |found: &Differentiated<F>| {
        let Solution { fx, fy, mz, .. } = found.solution;
        [fx, fy, mz]
    };
    let [fx, fy, mz] = both(of(&ahead), of(&behind));
    let (d, e): (Derivatives<F>, Derivatives<F>) = (ahead.derivatives, behind.derivatives);
    // rows of both directions, by slip_x, slip_y (turned twice), spin_rate
    let rows = d.jacobian.iter().zip(&e.jacobian).zip(turned);
    let mut slip = [[F::zero(); 3]; 3];
    for (place, ((forward, backward), turn)) in slip.iter_mut().zip(rows) {
        let columns = forward.iter().zip(backward).zip(turned);
        for (entry, ((forward, backward), across)) in place.iter_mut().zip(columns) {
            *entry = (share * *forward + other * *backward * turn * across) / speed;
        }
    }
    let motion = [slip_x, slip_y, spin_rate];
    let mut by_rolling = [F::zero(); 3];
    let ends = of(&ahead).into_iter().zip(of(&behind)).zip(turned);
    let laws = ahead.law.rolling_speed.into_iter().zip(behind.law.rolling_speed);
    for ((entry, ((forward, backward), turn)), (row, laws)) in
        by_rolling.iter_mut().zip(ends).zip(slip.iter().zip(laws))
    {
        let [x, y, z] = [row[0] * motion[0], row[1] * motion[1], row[2] * motion[2]];
        let through_law = share * laws.0 + other * laws.1 * turn;
        // creepages fall like 1/V_f, ∂V_f/∂V = V/V_f
        *entry = by_speed * (forward - backward * turn) + (through_law - (x + y + z) / speed) * u;
    }
    let mean = |p: F, q: F| share * p + other * q;
    let solution = Solution {
        fx,
        fy,
        mz,
        power: fx * slip_x + fy * slip_y + mz * spin_rate,
        adhesion: mean(ahead.solution.adhesion, behind.solution.adhesion),
        notice: ahead.solution.notice.worse(behind.solution.notice),
        reserved: 0,
    };
    let derivatives = MotionDerivatives {
        slip,
        rolling_speed: by_rolling,
        normal_force: both(d.normal_force, e.normal_force),
        load_through_hertz: both(d.load_through_hertz, e.load_through_hertz),
        friction: both(d.friction, e.friction),
    };
    Ok((solution, mean(ahead.friction, behind.friction), derivatives))
}
