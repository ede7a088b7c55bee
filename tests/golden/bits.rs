//! The same inputs give the same bits: in this build, through the C interface (with
//! `KSTRIP_RELEASE_LIBRARY` of the optimised library), in a batch and on two threads; compiled for
//! this very processor: `tests/machines`. `scripts/firmware.sh` runs the first thousand on a
//! simulated Cortex-M4 and Cortex-M7.
//!
//! Every precision has a hash for each of: solves, derivatives and points of the field; patches;
//! falling friction; special motions and strips; the inverse functions of test rigs; layers; laws
//! that are fitted.
//!
//! `KSTRIP_WRITE_GOLDEN=1 cargo test --test golden` writes the hashes anew after a deliberate
//! change. With `KSTRIP_GOLDEN_FEW` only the first thousand are computed, in this build alone.

use kstrip::friction;
pub use kstrip_testing::in_c::InC as Bits;
use kstrip_testing::prelude::*;
use kstrip_testing::single;
use kstrip_testing::toolchain::run_c_with;

const CASES: u32 = 100_000;
const BLOCK: u32 = 1000;
/// What has a hash of its own.
const KINDS: [&str; 7] = ["", " patches", " friction", " special", " rig", " layer", " fit"];

/// FNV-1a, 64 bits at a time.
#[derive(Clone, Copy)]
pub struct Hash(u64);

impl Hash {
    pub const START: Self = Self(0xcbf2_9ce4_8422_2325);

    pub fn value(self) -> u64 {
        self.0
    }

    pub fn mix(&mut self, bits: u64) {
        self.0 = (self.0 ^ bits).wrapping_mul(0x0100_0000_01b3);
    }

    fn code(&mut self, code: i32) {
        self.mix(u64::from(code as u32));
    }

    pub fn add<F: Bits>(&mut self, numbers: &[F]) {
        numbers.iter().for_each(|number| self.mix(number.bits()));
    }

    /// The status; what there is unless it is that of an error.
    pub fn status<T>(&mut self, answer: Result<(T, Warning), Error>) -> Option<T> {
        self.code(answer.as_ref().map_or_else(|error| error.code(), |(_, warning)| warning.code()));
        answer.ok().map(|(found, _)| found)
    }

    fn result<F: Bits>(&mut self, answer: Result<Solution<F>, Error>) {
        if let Some(r) = self.status(answer.map(|r| (r, r.warning))) {
            self.add(&[r.fx, r.fy, r.mz, r.power, r.adhesion]);
        }
    }

    pub fn derivatives<F: Bits>(&mut self, answer: &Result<Differentiated<F>, Error>) {
        let solution = answer.as_ref().map(|found| found.solution).map_err(|error| *error);
        self.result(solution);
        if let Ok(Differentiated { derivatives: d, law, .. }) = answer {
            d.jacobian.iter().for_each(|row| self.add(row));
            [d.normal_force, d.load_through_hertz, d.friction].iter().for_each(|v| self.add(v));
            let law = [law.ratio, law.decay, law.rolling_speed, law.slope_factor];
            law.iter().for_each(|v| self.add(v));
        }
    }

    pub fn members<F: Bits>(&mut self, wrench: &Wrench<F>) {
        self.add(&wrench.members());
        self.add(&[wrench.dissipation, wrench.normal_force]);
        self.mix(u64::from(wrench.contacts));
    }

    /// A wrench with its status; whether there is one.
    pub fn wrench<F: Bits>(&mut self, found: Result<Wrench<F>, Error>) -> bool {
        let found = self.status(found.map(|wrench| (wrench, wrench.warning)));
        found.inspect(|wrench| self.members(wrench)).is_some()
    }

    fn point<F: Bits>(&mut self, answer: Result<(FieldPoint<F>, Warning), Error>) {
        if let Some(p) = self.status(answer) {
            self.add(&[p.pressure, p.traction_x, p.traction_y, p.slip_x, p.slip_y]);
            self.mix(p.state as u64);
        }
    }

    fn strips<F: Bits>(&mut self, status: i32, strips: &[StripResult<F>]) {
        self.code(status);
        for s in strips {
            self.add(&[s.y, s.width, s.half_length, s.separatrix, s.fx, s.fy, s.mz, s.power]);
            self.mix(s.state as u64);
        }
    }
}

/// Whether a contact has more than solves: of a hundred five, one for each model.
fn has_field(i: u32) -> bool {
    i % 100 < 5
}

/// Whether it has the rest: the same of the first thousand, later of two thousand five.
fn has_rest(i: u32) -> bool {
    has_field(i) && (i < 1000 || i % 2000 < 5)
}

/// Whether a law is fitted to its forces, a hundred solutions: of the first thousand of every fifth
/// five that have the rest.
fn has_fit(i: u32) -> bool {
    has_rest(i) && i % 500 < 5
}

/// An integer for case `i`, as in `tests/c/golden.c`.
pub fn draw(i: u32, salt: u32, below: u32) -> u32 {
    let x = i.wrapping_mul(2_654_435_761).wrapping_add(salt.wrapping_mul(2_246_822_519));
    let x = (x ^ (x >> 15)).wrapping_mul(2_246_822_519);
    let x = (x ^ (x >> 13)).wrapping_mul(3_266_489_917);
    (x ^ (x >> 16)) % below
}

fn drawn(i: u32, salt: u32, unit: f64) -> f64 {
    let sizes = [1.0, 10.0, 100.0, 1000.0, 10000.0];
    let whole = f64::from(draw(i, salt, 2001)) - 1000.0;
    if draw(i, salt + 1, 8) == 0 {
        0.0
    } else {
        whole / (unit * sizes[draw(i, salt + 2, 5) as usize])
    }
}

pub fn inputs(i: u32) -> (Contact<f64>, Creepage<f64>, Options) {
    let contact = Contact {
        a: f64::from(1 + draw(i, 1, 200)) / 20000.0,
        b: f64::from(1 + draw(i, 2, 200)) / 20000.0,
        normal_force: f64::from(1000 + draw(i, 3, 200_000)),
        shear_modulus: f64::from(1 + draw(i, 4, 100)) * 1e9,
        poisson_ratio: f64::from(draw(i, 5, 101)) / 200.0,
        friction: f64::from(1 + draw(i, 6, 100)) / 100.0,
        mismatch: 0.0,
    };
    let creepage = creep(drawn(i, 7, 1000.0), drawn(i, 10, 1000.0), drawn(i, 13, 10.0));
    let options = Options {
        model: Model::ALL[i as usize % 5],
        strips: StripCount::from_number(4 << draw(i, 16, 5)).expect("a count"),
    };
    (contact, creepage, options)
}

/// A quotient of integers, rounded to the precision.
pub fn part<F: Bits>(whole: u32, of: f64) -> F {
    F::of(f64::from(whole) / of)
}

/// Friction that falls with the slip, of clean bodies.
pub fn law<F: Bits>(
    [friction, ratio, decay, rolling_speed, slope_factor]: [F; 5],
) -> SlipFriction<F> {
    let (slide_factor, layer) = (F::zero(), F::zero());
    SlipFriction { friction, ratio, decay, rolling_speed, slope_factor, slide_factor, layer }
}

/// A contact of a profile, by radius, modulus, Poisson's ratio, friction and smoothing length.
pub fn pressed<F: Bits>(given: Given<F>, of: [F; 5]) -> ProfileContact<F> {
    let [rolling_radius, shear_modulus, poisson_ratio, friction, smoothing_length] = of;
    #[rustfmt::skip]
    let contact = ProfileContact {
        rolling_radius, given, shear_modulus, poisson_ratio, friction, smoothing_length,
    };
    contact
}

/// What a profile gave.
pub fn hash_indentation<F: Bits>(hash: &mut Hash, found: &Indentation<F>) {
    let Indentation { approach, normal_force, stiffness, peak_pressure, peak_y, lowest, .. } =
        *found;
    hash.add(&[approach, normal_force, stiffness, peak_pressure, peak_y, lowest]);
    hash.mix(u64::from(found.iterations));
}

/// One case in one precision: what `tests/c/golden_case.h` does.
struct Case<'a, F: Bits> {
    i: u32,
    contact: &'a Contact<F>,
    creepage: &'a Creepage<F>,
    options: &'a Options,
}

type Full<F> = Patch<F>;

impl<F: Bits> Case<'_, F> {
    fn draw(&self, salt: u32, below: u32) -> u32 {
        draw(self.i, salt, below)
    }

    fn hash(&self, hashes: &mut [Hash; KINDS.len()]) {
        let Self { i, contact, creepage, options } = *self;
        let [solves, patches, friction, special, rig, layer, fit] = hashes;
        let r = forces::forces_of_contact(contact, creepage, options);
        solves.result(r);
        if has_field(i) {
            self.field(solves);
        }
        if has_rest(i) {
            let patch = self.build(patches);
            if let Some(patch) = &patch {
                self.patch(patches, patch);
            }
            self.falling([friction, &mut *patches], patch.as_ref());
            self.special(special);
            self.rig(rig, &r.expect("ordinary inputs"));
            self.layer([layer, patches, fit], patch.as_ref());
        }
    }

    /// Derivatives and three points of the field.
    fn field(&self, hash: &mut Hash) {
        let Self { contact, creepage, options, .. } = *self;
        hash.derivatives(&differentiate_with_law(contact, creepage, None, options));
        for n in [-1.0, 0.0, 1.0] {
            let place = |axis: F, parts: f64| axis * F::of(n) / F::of(parts);
            let field = Field::new(contact, creepage, options);
            hash.point(
                field.map(|f| (f.at(place(contact.a, 2.0), place(contact.b, 4.0)), f.warning)),
            );
        }
    }

    /// A patch by one of its three builders.
    fn build(&self, hash: &mut Hash) -> Option<Full<F>> {
        let Self { i, contact, options, .. } = *self;
        let mut warning = Warning::None;
        let patch = match i / 5 % 3 {
            0 => Full::from_ellipse(contact, options.strips).map(|mut patch| {
                for (strip, n) in patch.used_mut().iter_mut().zip(0..) {
                    strip.friction = strip.friction * part(4 + self.draw(100 + n, 5), 8.0);
                }
                patch
            }),
            1 => {
                let count = 2 + self.draw(20, 19);
                let mut at = 0;
                let mut strips: Vec<_> = (0..count)
                    .map(|n| {
                        let width = 2 * (1 + self.draw(100 + n, 10));
                        at += if n == count / 2 { 40 } else { 0 };
                        let y = at + width / 2;
                        at += width;
                        PatchStrip {
                            y: part(y, 20000.0),
                            width: part(width, 20000.0),
                            half_length: part(40 + self.draw(200 + n, 80), 20000.0),
                            centre_x: part(self.draw(300 + n, 20), 20000.0),
                            peak_pressure: part::<F>(self.draw(400 + n, 15), 1.0) * F::of(1e8),
                            friction: part(1 + self.draw(500 + n, 50), 100.0),
                        }
                    })
                    .collect();
                strips.reverse();
                Full::from_strips(&strips, contact.shear_modulus, contact.poisson_ratio)
            }
            _ => {
                let bend = 1 + self.draw(20, 8);
                let away = |n: u32| n.abs_diff(16);
                let y: Vec<F> = (0..33)
                    .map(|n| part::<F>(away(n), 1000.0))
                    .zip(0..33)
                    .map(|(y, n)| if n < 16 { -y } else { y })
                    .collect();
                let rough = |n| away(n) * away(n) * bend * 8 + self.draw(100 + n, 20);
                let distance: Vec<F> = (0..33).map(|n| part(rough(n), 1e7)).collect();
                let Contact { normal_force, shear_modulus, poisson_ratio, friction, .. } = *contact;
                let radius = part(200 + self.draw(21, 800), 1000.0);
                let numbers = [radius, shear_modulus, poisson_ratio, friction, F::zero()];
                let load = pressed(Given::Load(normal_force), numbers);
                // (more are fewer on a microcontroller)
                let strips = options.strips.min(StripCount::Sixteen);
                let built =
                    Full::from_profile(&Profile::new(&y, &distance).unwrap(), &load, strips);
                built.map(|(patch, found)| {
                    let loads = [found.approach, found.peak_pressure, found.normal_force];
                    hash.add(&loads);
                    hash.add(&[found.peak_y]);
                    hash.mix(u64::from(found.iterations));
                    warning = found.warning;
                    patch
                })
            }
        };
        hash.status(patch.map(|patch| (patch, warning)))
    }

    fn patch(&self, hash: &mut Hash, patch: &Full<F>) {
        let Self { creepage, options: Options { model, .. }, .. } = *self;
        let Some(view) = hash.status(patch.view().map(|view| (view, Warning::None))) else {
            return;
        };
        let area = view.area() * view.quadrature().area;
        hash.add(&[view.normal_force(), view.friction_bound(), area]);
        hash.mix(view.lobes().count() as u64);
        for s in view.strips() {
            let PatchStrip { y, width, half_length, centre_x, peak_pressure, friction } = *s;
            hash.add(&[y, width, half_length, centre_x, peak_pressure, friction]);
        }
        let found = patch_friction::differentiate_patch(&view, creepage, None, *model);
        hash.derivatives(&found);
        let mut strips = Vec::new();
        let status = solver::patch_strips(&view, creepage, *model, &mut |s| strips.push(s));
        hash.strips(status.map_or_else(Error::code, Warning::code), &strips);
        for s in view.strips().iter().step_by(3) {
            let x = s.centre_x - s.half_length / F::of(4.0);
            let field = PatchField::new(&view, creepage, None, *model);
            hash.point(field.map(|f| (f.at(x, s.y), f.warning)));
        }
    }

    /// Friction that falls with the slip: of the contact, and of the patch in its hash.
    fn falling(&self, [hash, of_patch]: [&mut Hash; 2], patch: Option<&Full<F>>) {
        let Self { contact, creepage, options, .. } = *self;
        let law = law([
            part(5 + self.draw(30, 60), 100.0),
            part(self.draw(31, 11), 10.0),
            part(self.draw(32, 20), 10.0),
            part(self.draw(33, 60), 1.0),
            part(1 + self.draw(34, 10), 10.0),
        ]);
        let found = differentiate_with_law(contact, creepage, Some(&law), options);
        hash.derivatives(&found);
        if let Ok(found) = found {
            hash.add(&[found.friction]);
            let shear_modulus = contact.shear_modulus * law.slope_factor;
            let slipping = Contact { friction: found.friction, shear_modulus, ..*contact };
            let (x, y) = (-contact.a / F::of(4.0), contact.b / F::of(8.0));
            let field = Field::new(&slipping, creepage, options);
            hash.point(field.map(|f| (f.at(x, y), f.warning)));
        }
        let Some(patch) = patch else { return };
        let view = patch.view().expect("as it was built");
        let found = patch_friction::differentiate_patch(&view, creepage, Some(&law), options.model);
        of_patch.derivatives(&found);
        if let Ok(found) = found {
            of_patch.add(&[found.friction]);
        }
    }

    /// Forces at rest and without spin, lateral or longitudinal creepage; strips.
    fn special(&self, hash: &mut Hash) {
        let Self { contact, creepage, options, .. } = *self;
        let Creepage { longitudinal, lateral, spin } = *creepage;
        for zeros in 0..5 {
            let kept = |nth, x| if zeros == nth || zeros == 4 { F::zero() } else { x };
            let motion = creep(kept(1, longitudinal), kept(2, lateral), kept(3, spin));
            hash.result(forces::forces_of_contact(contact, &motion, options));
        }
        let mut strips = Vec::new();
        let status = forces::strips(contact, creepage, options, &mut |s| strips.push(s));
        hash.strips(status.map_or_else(Error::code, Warning::code), &strips);
    }

    /// Friction from a share of the force, and the creepage for it.
    fn rig(&self, hash: &mut Hash, r: &Solution<F>) {
        let Self { i, contact, creepage, options } = *self;
        let share = part(4 + self.draw(40, 5), 8.0);
        let (fx, fy, zero) = (r.fx * share, r.fy * share, F::zero());
        let (measured, force) = match i / 5 % 3 {
            0 => (Measured::Fx, [fx, zero]),
            1 => (Measured::Fy, [zero, fy]),
            _ => (Measured::Both, [fx, fy]),
        };
        let found = estimate_friction(contact, creepage, None, options, measured, force);
        if let Some(found) = hash.status(found.map(|found| (found, found.warning))) {
            hash.add(&[found.friction, found.sensitivity, found.residual]);
        }
        let found = creepage_for_force(contact, [fx, fy], creepage.spin, None, options);
        if let Some(motion) = hash.status(found) {
            hash.add(&[motion.longitudinal, motion.lateral, motion.spin]);
        }
    }

    /// A layer, what sliding leaves of it, or both; of a third of the contacts the friction falls.
    /// The patch counts in its hash, and a fit of the law to its own forces in that of fits.
    fn layer(&self, [hash, of_patch, of_fit]: [&mut Hash; 3], patch: Option<&Full<F>>) {
        let Self { i, contact, creepage, options } = *self;
        let (kind, zero) = (i / 5 % 3, F::zero());
        let mut law = SlipFriction {
            rolling_speed: if kind == 0 { part(1 + self.draw(53, 40), 1.0) } else { zero },
            slope_factor: part(1 + self.draw(54, 10), 10.0),
            slide_factor: if kind == 1 { zero } else { part(1 + self.draw(55, 10), 10.0) },
            layer: if kind == 2 { zero } else { part(1 + self.draw(56, 40), 4e14) },
            ..SlipFriction::of_constant(part(5 + self.draw(50, 60), 100.0))
        };
        (law.ratio, law.decay) = (part(1 + self.draw(51, 9), 10.0), part(self.draw(52, 10), 10.0));
        self.behind(hash, differentiate_with_law(contact, creepage, Some(&law), options));
        let mut strips = Vec::new();
        let found = friction::contact_with_law(contact, creepage, &law, options).and_then(
            |(contact, _)| {
                friction::strips_with_law(&contact, creepage, Some(&law), options, &mut |s| {
                    strips.push(s)
                })
            },
        );
        let count = strips.len();
        hash.code(found.map_or_else(Error::code, |_| count as i32));
        for s in &strips {
            hash.add(&[s.y, s.width, s.half_length, s.separatrix, s.fx, s.fy, s.mz, s.power]);
        }
        let (x, y) = (-contact.a / F::of(4.0), contact.b / F::of(8.0));
        let field = LawField::new(contact, creepage, Some(&law), options);
        hash.point(field.map(|f| (f.along(&f.strip_at(y), x), f.warning)));
        if let Some(view) = patch.and_then(|patch| patch.view().ok()) {
            let found =
                patch_friction::differentiate_patch(&view, creepage, Some(&law), options.model);
            self.behind(of_patch, found);
            for s in view.strips().iter().step_by(5) {
                let field = PatchField::new(&view, creepage, Some(&law), options.model);
                let x = s.centre_x - s.half_length / F::of(4.0);
                of_patch.point(field.map(|f| (f.at(x, s.y), f.warning)));
            }
        }
        if has_fit(i) {
            self.fit(of_fit, &law);
        }
    }

    /// Friction and slope factor of a law from the forces that it gives.
    fn fit(&self, hash: &mut Hash, law: &SlipFriction<F>) {
        let Self { contact, creepage, options, .. } = *self;
        let points: Vec<_> = (1..=6)
            .filter_map(|n| {
                let share = part::<F>(n * n, 16.0);
                let Creepage { longitudinal, lateral, spin } = *creepage;
                let motion = creep(longitudinal * share, lateral * share, spin);
                let found = friction::solve_with_law(contact, &motion, law, options).ok()?.solution;
                Some(measured_force(motion, [found.fx, found.fy], 3))
            })
            .collect();
        let start = SlipFriction { friction: F::zero(), slope_factor: F::zero(), ..*law };
        let fitted = [true, false, false, true, false, false];
        let found = fit_friction(contact, &points, &start, fitted, options);
        let found = found.map(|found| (found, found.warning)).map_err(|(_, error)| error);
        if let Some(found) = hash.status(found) {
            let (law, errors) = (found.law, found.standard_errors);
            hash.add(&[law.friction, law.slope_factor, errors.friction, errors.slope_factor]);
            hash.add(&[found.residual]);
            hash.mix(u64::from(found.steps));
        }
    }

    /// Forces and all derivatives, those by the layer and the slide factor too.
    fn behind(&self, hash: &mut Hash, found: Result<Differentiated<F>, Error>) {
        hash.derivatives(&found);
        if let Ok(found) = found {
            hash.add(&found.law.slide_factor);
            hash.add(&found.law.layer);
            hash.add(&[found.friction]);
        }
    }
}

/// Hashes of a block of cases, in both precisions.
fn hash_block(block: u32) -> [[Hash; KINDS.len()]; 2] {
    let [mut two, mut one] = [[Hash::START; KINDS.len()]; 2];
    for i in block * BLOCK..(block + 1) * BLOCK {
        let (contact, creepage, options) = &inputs(i);
        Case { i, contact, creepage, options }.hash(&mut two);
        let (contact, creepage) = (&single::single(contact), &single::single_motion(creepage));
        Case { i, contact, creepage, options }.hash(&mut one);
    }
    [two, one]
}

/// The lines of the golden hashes for these numbers of blocks, the largest first.
fn hashes_of_rust(counts: &[u32]) -> String {
    let workers = std::thread::available_parallelism().map_or(1, |n| n.get() as u32);
    let blocks: Vec<_> = std::thread::scope(|scope| {
        let part = |worker: u32| worker * counts[0] / workers;
        let parts: Vec<_> = (0..workers)
            .map(|worker| part(worker)..part(worker + 1))
            .map(|blocks| scope.spawn(|| blocks.map(hash_block).collect::<Vec<_>>()))
            .collect();
        parts.into_iter().flat_map(|part| part.join().expect("hashes")).collect()
    });
    let mut text = String::new();
    for count in counts {
        for (p, precision) in ["double", "single"].iter().enumerate() {
            for (kind, name) in KINDS.iter().enumerate() {
                let mut hash = Hash::START;
                blocks[..*count as usize].iter().for_each(|block| hash.mix(block[p][kind].0));
                text += &format!("{precision}{name} {} {:016x}\n", count * BLOCK, hash.0);
            }
        }
    }
    text
}

const WAY: &str = "KSTRIP_WRITE_GOLDEN=1 cargo test --test golden, if results were to change";

/// Hashes of this build are those of a file of `tests/data`; with `KSTRIP_WRITE_GOLDEN` it is
/// written first.
fn assert_golden(file: &str, here: &str) {
    let path = root().join("tests/data").join(file);
    if std::env::var_os("KSTRIP_WRITE_GOLDEN").is_some() {
        std::fs::write(&path, here).expect("tests/data is writable");
    }
    assert_eq!(here, read(path), "this build; {WAY}");
}

/// The hashes of both precisions, which are made side by side, are those of a file.
pub fn compare(file: &str, double: fn(&str) -> String, single: fn(&str) -> String) {
    let here = std::thread::scope(|scope| {
        let double = scope.spawn(|| double("double"));
        let single = single("single");
        double.join().expect("hashes") + &single
    });
    assert_golden(file, &here);
}

#[test]
fn every_build_gives_the_golden_bits() {
    if std::env::var_os("KSTRIP_GOLDEN_FEW").is_some() {
        let golden = read("tests/data/golden.txt");
        let few = |line: &&str| line.split(' ').nth_back(1) == Some("1000");
        let golden: Vec<_> = golden.lines().filter(few).collect();
        assert_eq!(hashes_of_rust(&[1]).lines().collect::<Vec<_>>(), golden, "{WAY}");
        return;
    }
    let golden = hashes_of_rust(&[CASES / BLOCK, 1]);
    assert_golden("golden.txt", &golden);
    for mode in ["batch", "threads"] {
        assert_eq!(run_c_with("tests/c/golden.c", &[mode]), golden, "C program, {mode}; {WAY}");
    }
}
