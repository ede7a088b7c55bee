//! From a wanted force to the creepage.
//!
//! Newton's method on what the force would be without saturation: with `t = |F|/(μ N)`
//!
//! ```text
//! L(F) = 3 (1 − ∛(1 − t)) F/|F|
//! ```
//!
//! is proportional to the creepage in the theory of Vermeulen and Johnson (J. Appl. Mech. 31 (1964) 338), and nearly so
//! here. A step that leads no closer is shortened to where the cubic through both ends crosses zero. If the search still makes no progress, as
//! beside a fold of the force, it starts again with larger creepages along the wanted force.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::number::{Float, length};
use crate::solve::derivatives::{self, Derivatives};
use crate::solve::model::{self, Model, Options, Precision};
use crate::status::{Error, Notice};

/// Forces this near to `μ N`, relatively, are taken for full sliding.
const SLIDING: f64 = 1e-3;
/// Solutions up to which each start is followed, and over the creepage that the first one came to, where it begins.
const STARTS: [(usize, f64); 3] = [(14, 0.0), (27, 2.5), (40, 8.0)];
/// Lengths of one step that are tried.
const LENGTHS: usize = 4;
/// Over the sum of the squares of the slopes, where a step without it leads nowhere.
const DAMPING: f64 = 0.03;
/// Distances from the wanted force over `μ N`: what is reached, what is left to rounding, and what is taken.
const REACHED: f64 = 16.0;
const ROUNDING: f64 = 5e3;
const TAKEN: f64 = 1e4;

/// The creepage `(υx, υy)` at which a contact with a given spin carries a wanted force `(F_x, F_y)` on the lower body.
///
/// With [`Notice::CreepageAtLeast`] the force is within 0.1 % of `μ N`: the result is where it comes as near as that,
/// and larger creepages do as well.
///
/// The search mostly needs five solutions with derivatives, and 12 in all but one of a thousand plausible contacts (two of a thousand for the
/// models of 1967). It ends after 40 with [`Notice::NotConverged`] and the nearest creepage that was found. Where spin keeps the force nearly
/// constant over a range of creepages, more than one creepage may give it, and the result is one of them.
///
/// # Errors
/// Those of [`solve`](model::solve), [`Error::ForceBeyondFriction`].
///
/// # Example
/// ```
/// use kstrip::{contact::Contact, solve::model::{solve, Options}, rig::creepage_for_force};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, shear_modulus: 82e9, poisson_ratio: 0.28, friction: 0.3,
///     mismatch: 0.0,
/// };
/// let options = Options::default();
/// let (creepage, _) = creepage_for_force(&contact, [15e3, -2e3], 0.1_f64, &options)?;
/// let forces = solve(&contact, &creepage, &options)?;
/// assert!((forces.fx - 15e3).abs() < 1e-6 && (forces.fy + 2e3).abs() < 1e-6);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn creepage_for_force<F: Precision>(
    contact: &Contact<F>,
    force: [F; 2],
    spin: F,
    options: &Options,
) -> Result<(Creepage<F>, Notice), Error> {
    let none = Creepage { longitudinal: F::zero(), lateral: F::zero(), spin };
    model::check(contact, &none, options)?;
    let [fx, fy] = force;
    if !fx.is_finite_number() || !fy.is_finite_number() {
        return Err(Error::NotFinite);
    }
    let size = length(fx, fy);
    if contact.is_lost() {
        let fits = size <= F::zero();
        return if fits { Ok((none, Notice::None)) } else { Err(Error::ForceBeyondFriction) };
    }
    let saturates = options.model != Model::Linear;
    let bound = contact.friction_bound();
    let (mut target, mut sliding) = (force, false);
    if saturates {
        if size > bound * (F::one() + F::EPSILON.times(4.0)) {
            return Err(Error::ForceBeyondFriction);
        }
        let most = bound.times(1.0 - SLIDING);
        sliding = size >= most;
        if sliding {
            if bound <= F::zero() {
                return Ok((none, Notice::CreepageAtLeast));
            }
            target = force.map(|part| part / size * most);
        }
    }
    let mut aim = Aim::new(contact, target, spin, options);
    let found = aim.find()?;
    let settled = found.distance <= F::EPSILON.times(TAKEN);
    let notice = if !settled {
        Notice::NotConverged
    } else if sliding {
        Notice::CreepageAtLeast
    } else {
        Notice::None
    };
    Ok((aim.creepage(found.at), notice.worse(found.notice)))
}

/// A contact and a force that it shall carry.
pub(crate) struct Aim<'a, F> {
    contact: &'a Contact<F>,
    options: &'a Options,
    spin: F,
    /// Over the unit.
    target: [F; 2],
    /// `μ N`; of the linear theory the size of the forces.
    unit: F,
    /// The unit over `G a b`.
    slip: F,
    saturates: bool,
    /// Solutions so far.
    pub(crate) solved: usize,
}

/// A creepage and what it leads to.
#[derive(Clone, Copy)]
pub(crate) struct Place<F> {
    /// `(υx, υy)` over the unit of slip
    pub(crate) at: [F; 2],
    /// `L(F) − L(target)`
    error: [F; 2],
    /// Its derivatives, row by row.
    slopes: [[F; 2]; 2],
    /// How large the error is.
    off: F,
    /// `|F − target|` over the unit
    pub(crate) distance: F,
    notice: Notice,
}

/// `L(F)` of a force over `μ N`, and its derivatives.
fn unsaturated<F: Float>([x, y]: [F; 2]) -> ([F; 2], [[F; 2]; 2]) {
    let t = length(x, y);
    // c³ = 1 − t, L = k F with k = 3 (1 − c)/t = 3/(1 + c + c²), d|L|/dt = 1/c²
    let c = (F::one() - t).max(F::EPSILON).cube_root();
    let k = F::constant(3.0) / (F::one() + c + c * c);
    let stretch = F::one() / (c * c) - k;
    let over = t + F::TINY;
    let (x, y) = (x / over, y / over);
    let mixed = stretch * x * y;
    let slopes = [[k + stretch * x * x, mixed], [mixed, k + stretch * y * y]];
    ([x * t * k, y * t * k], slopes)
}

fn times<F: Float>(rows: &[[F; 2]; 2], [x, y]: [F; 2]) -> [F; 2] {
    rows.map(|[by_x, by_y]| by_x * x + by_y * y)
}

impl<'a, F: Precision> Aim<'a, F> {
    /// Of a contact with load and, unless the theory is linear, friction.
    pub(crate) fn new(
        contact: &'a Contact<F>,
        target: [F; 2],
        spin: F,
        options: &'a Options,
    ) -> Self {
        let saturates = options.model != Model::Linear;
        let Contact { a, b, shear_modulus, .. } = *contact;
        let stiffness = shear_modulus * a * b;
        let unit = if saturates {
            contact.friction_bound()
        } else {
            length(target[0], target[1]) + stiffness * (a * b).sqrt() * spin.abs() + F::TINY
        };
        let slip = unit / stiffness;
        let slip = if slip.is_finite_number() && slip > F::zero() { slip } else { F::one() };
        let target = target.map(|part| part / unit);
        Self { contact, options, spin, target, unit, slip, saturates, solved: 0 }
    }

    pub(crate) fn creepage(&self, [x, y]: [F; 2]) -> Creepage<F> {
        Creepage { longitudinal: x * self.slip, lateral: y * self.slip, spin: self.spin }
    }

    fn place(&mut self, at: [F; 2]) -> Result<Place<F>, Error> {
        self.solved += 1;
        let (solution, slopes) =
            derivatives::solve(self.contact, &self.creepage(at), self.options)?;
        let Derivatives { jacobian: [[xx, xy, _], [yx, yy, _], _], .. } = slopes;
        let force = [solution.fx / self.unit, solution.fy / self.unit];
        let rows = [[xx, xy], [yx, yy]].map(|row| row.map(|slope| slope / self.unit * self.slip));
        let [to_x, to_y] = self.target;
        let distance = length(force[0] - to_x, force[1] - to_y);
        let (error, slopes) = if self.saturates {
            let ([x, y], [of_x, of_y]) = unsaturated(force);
            let ([wanted_x, wanted_y], _) = unsaturated(self.target);
            let [[xx, xy], [yx, yy]] = rows;
            let columns = [[xx, yx], [xy, yy]];
            ([x - wanted_x, y - wanted_y], [times(&columns, of_x), times(&columns, of_y)])
        } else {
            ([force[0] - to_x, force[1] - to_y], rows)
        };
        let off = length(error[0], error[1]);
        Ok(Place { at, error, slopes, off, distance, notice: solution.notice })
    }

    /// The place of the wanted force, or the nearest that was found.
    pub(crate) fn find(&mut self) -> Result<Place<F>, Error> {
        let size = length(self.target[0], self.target[1]) + F::TINY;
        let direction = self.target.map(|part| part / size);
        let mut best: Option<Place<F>> = None;
        let mut reach = F::one();
        for (limit, larger) in STARTS.map(|(limit, larger)| (limit, F::constant(larger))) {
            let start = direction.map(|part| part * (reach * larger));
            let Ok(start) = self.place(start) else { break };
            let found = self.follow(start, limit);
            if best.is_none() {
                reach = length(found.at[0], found.at[1]).max(F::one());
            }
            if best.is_none_or(|best| found.distance < best.distance) {
                best = Some(found);
            }
            if found.distance <= F::EPSILON.times(TAKEN) {
                break;
            }
        }
        best.ok_or(Error::Overflow)
    }

    /// Newton's method from a place, as long as it leads closer.
    fn follow(&mut self, start: Place<F>, limit: usize) -> Place<F> {
        let mut place = start;
        let mut damping = F::zero();
        while self.solved < limit && place.distance > F::EPSILON.times(REACHED) {
            match self.step(&place, damping, limit) {
                Some(closer) => (place, damping) = (closer, F::zero()),
                None if place.distance <= F::EPSILON.times(ROUNDING) || damping > F::zero() => {
                    break;
                }
                None => damping = F::constant(DAMPING),
            }
        }
        place
    }

    /// One step of Newton's method, `(Jᵀ J + λ) Δ = −Jᵀ error`, as long as it may be; none if it leads no closer.
    fn step(&mut self, place: &Place<F>, damping: F, limit: usize) -> Option<Place<F>> {
        let Place { at, error, slopes: [[xx, xy], [yx, yy]], off, .. } = *place;
        let right = [-(xx * error[0] + yx * error[1]), -(xy * error[0] + yy * error[1])];
        let (p, q, r) = (xx * xx + yx * yx, xx * xy + yx * yy, xy * xy + yy * yy);
        let added = damping * (p + r);
        let plain = xx * yy - xy * yx;
        // det(Jᵀ J + λ) without cancellation
        let determinant = plain * plain + added * (p + r + added) + F::TINY;
        let mut step = [
            ((r + added) * right[0] - q * right[1]) / determinant,
            ((p + added) * right[1] - q * right[0]) / determinant,
        ];
        let size = length(step[0], step[1]);
        if self.saturates {
            // A step longer than what it starts from leaves what the slopes know.
            let longest = length(at[0], at[1]).plus(1.0).times(2.0);
            if !(size <= longest) {
                step = step.map(|part| part / size * longest);
            }
        }
        // along the error, which the step shall take to zero
        let along = |[x, y]: [F; 2]| (x * error[0] + y * error[1]) / off;
        let slope = along(times(&place.slopes, step));
        let mut share = F::one();
        for _ in 0..LENGTHS {
            if self.solved >= limit {
                return None;
            }
            let next = self.place([at[0] + step[0] * share, at[1] + step[1] * share]).ok()?;
            if next.off < off || next.distance <= F::EPSILON.times(REACHED) {
                return Some(next);
            }
            if place.distance <= F::EPSILON.times(ROUNDING) {
                return None;
            }
            let beyond = along(next.error);
            let shorter = if beyond < F::zero() {
                crossing([off, beyond], [slope * share, along(times(&next.slopes, step)) * share])
            } else {
                F::constant(0.2)
            };
            share = share * shorter.clamped(F::constant(0.05), F::constant(0.95));
        }
        None
    }
}

/// Where the cubic with these values and slopes at 0 and 1 crosses zero, downward, to a thousandth.
fn crossing<F: Float>([a, b]: [F; 2], [p, q]: [F; 2]) -> F {
    let (c2, c3) = ((b - a).times(3.0) - p.times(2.0) - q, (a - b).times(2.0) + p + q);
    let (mut low, mut high) = (F::zero(), F::one());
    for _ in 0..10 {
        let t = (low + high).times(0.5);
        if a + t * (p + t * (c2 + t * c3)) > F::zero() { low = t } else { high = t }
    }
    (low + high).times(0.5)
}
