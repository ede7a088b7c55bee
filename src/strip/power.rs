//! The correction that keeps the power of friction from being negative.

use crate::contact::totals::Totals;
use crate::linear::LinearCoefficients;
use crate::number::{Arithmetic, Number};

/// Least power, divided by that of the linear theory times `1/√(1 + n²)`.
const FLOOR: f64 = 0.2;
/// The correction begins where the power is less than the floor and this. References computed with
/// CONTACT are above 0.64.
const STEP: f64 = 0.2;

/// Scales a force back to the friction bound, which rounding may exceed.
#[inline(always)]
fn within_bound<T: Number>([x, y]: [T; 2]) -> [T; 2] {
    let over = (x.value().squared() + y.value().squared()).plus(-1.0).max(T::Base::zero());
    let size = T::Base::one() - over.times(0.5);
    [x.scale(size), y.scale(size)]
}

/// Forces moved so that friction takes power out: `F·v n/(v·K v)`, `K = diag(C11, C22, C33)`, `n² =
/// 1 + |K v|² + (C23 φ)²`, is 1 at rest in every direction. Where it is below `FLOOR` + `STEP`
/// it is raised to at least `FLOOR`, with a continuous derivative.
///
/// `F' = F + λ h K v` with `h = (1 − |F|²)/10` for the forces and 1 for the moment; where `|F'| >
/// 1`, all of it is scaled down.
#[inline(always)]
pub fn power_projected<T: Number>(
    totals: Totals<T>, creepage: [T; 3], linear: &LinearCoefficients<T::Base>,
) -> Totals<T> {
    let [vx, vy, phi] = creepage;
    let [kx, ky, ks] = [vx.scale(linear.c11), vy.scale(linear.c22), phi.scale(linear.c33)];
    let square = kx.squared() + ky.squared() + ks.squared() + phi.scale(linear.c23).squared();
    let Totals { fx, fy, mz, stick } = totals;
    let [fx, fy] = within_bound([fx, fy]);
    let totals = Totals { fx, fy, mz, stick };
    let power = fx * vx + fy * vy + mz * phi;
    let whole = kx * vx + ky * vy + ks * phi;
    // No correction at rest, where squares may vanish, nor for x > FLOOR + STEP.
    let n = square.plus(1.0).sqrt();
    let loaded = square.plus(-1e-12);
    let missing = whole.times(FLOOR + STEP) - power * n;
    let low = loaded.choose(missing, -T::one());
    if !low.exceeds(T::zero()) {
        return totals;
    }
    // x = P n/(v·K v) − FLOOR; the correction is max(x, 0) − x, smoothed over ± STEP.
    let whole = loaded.choose(whole, T::one());
    let x = (power * n / whole).plus(-FLOOR);
    let short = (T::constant(STEP) - x).max(T::zero());
    let lift = (-x).plus(-STEP).choose(-x, short.squared().times(0.25 / STEP));
    let h = (T::one() - (fx.squared() + fy.squared())).max(T::zero()).times(0.1);
    let along = h * (kx * vx + ky * vy) + ks * phi;
    let along = loaded.choose(along, T::one());
    let factor = lift / n * (whole / along.max(T::tiny()));
    let (x, y) = (fx + factor * h * kx, fy + factor * h * ky);
    let size = (x.squared() + y.squared()).max(T::one()).inverse_root();
    let [x, y] = within_bound([x * size, y * size]);
    Totals {
        fx: low.choose(x, fx),
        fy: low.choose(y, fy),
        mz: low.choose((mz + factor * ks) * size, mz),
        stick,
    }
}
