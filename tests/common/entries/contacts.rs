//! One elliptic contact: forces, derivatives, strips, fields, falling friction, the inverse.

use super::super::*;
use super::*;
use kstrip::strip_1967::strip::State;

pub fn contact(bytes: &mut Bytes) -> kstrip_contact {
    kstrip_contact {
        a: positive(bytes, 5e-3),
        b: positive(bytes, 5e-3),
        normal_force: positive(bytes, 5e5),
        shear_modulus: positive(bytes, 82e10),
        poisson_ratio: positive(bytes, 0.06),
        friction: positive(bytes, 1.0),
        mismatch: if bytes.byte() < 64 { Number::of(bytes, 0.2) } else { 0.0 },
    }
}

pub fn creepage(bytes: &mut Bytes) -> kstrip_creepage {
    kstrip_creepage {
        longitudinal: Number::of(bytes, 1e-2),
        lateral: Number::of(bytes, 1e-2),
        spin: Number::of(bytes, 3.0),
    }
}

pub fn numbers_of(r: &kstrip_result) -> [Float; 5] {
    [r.fx, r.fy, r.mz, r.power, r.adhesion]
}

/// The model that options stand for.
pub fn model_of(options: Option<kstrip_options>) -> i32 {
    match options.map_or(KSTRIP_MODEL_DEFAULT, |options| options.model) {
        KSTRIP_MODEL_DEFAULT => KSTRIP_MODEL_TOTAL,
        model => model,
    }
}

/// What holds for every result.
fn plausible(
    contact: &kstrip_contact, k: &kstrip_creepage, model: i32, status: i32, r: &kstrip_result,
) {
    let context = || format!("{contact:?} {k:?} model {model} {r:?}");
    assert_eq!((r.warning.code(), r.reserved), (status, 0));
    assert!(finite(&numbers_of(r)), "{}", context());
    let rounding = Float::ROUNDING;
    let load = f64::from(contact.normal_force).max(0.0);
    let bound = f64::from(contact.friction) * load;
    let (fx, fy) = (f64::from(r.fx), f64::from(r.fy));
    if model != KSTRIP_MODEL_LINEAR {
        let size = fx.hypot(fy);
        assert!(size <= bound * (1.0 + rounding) + 4.0 * Float::SMALLEST, "{}", context());
    }
    let in_range = (0.0..=1.0).contains(&r.adhesion);
    assert!(in_range || (model == KSTRIP_MODEL_TOTAL && r.adhesion == -1.0), "{}", context());
    if contact.is_lost() {
        assert_eq!((numbers_of(r), status), ([0.0; 5], 0), "{}", context());
        return;
    }
    if model == KSTRIP_MODEL_TOTAL {
        let terms = (f64::from(r.fx) * f64::from(k.longitudinal)).abs()
            + (f64::from(r.fy) * f64::from(k.lateral)).abs()
            + (f64::from(r.mz) * f64::from(k.spin)).abs();
        // A force below the smallest normal number has no relative rounding either.
        let creepages = [k.longitudinal, k.lateral, k.spin].map(|x| f64::from(x).abs());
        let tiny = 4.0 * Float::SMALLEST * (1.0 + creepages.iter().sum::<f64>());
        let power = f64::from(r.power);
        assert!(power >= -rounding * terms - tiny, "gains energy: {}", context());
    }
}

pub fn same_bits(one: &kstrip_result, two: &kstrip_result) {
    assert_eq!(numbers_of(one).map(Number::bits), numbers_of(two).map(Number::bits));
    assert_eq!(one.warning, two.warning);
}

/// `kstrip_solve` once more, for what must be equal.
pub fn solved(
    contact: &kstrip_contact, k: &kstrip_creepage, options: Option<kstrip_options>,
) -> Result<kstrip_result, i32> {
    let mut out = poisoned();
    let status = kstrip_solve(Some(contact), Some(k), options.as_ref(), Some(&mut out));
    if answered(status, untouched(&out)) { Ok(written(&out)) } else { Err(status) }
}

pub fn solve(bytes: &mut Bytes) {
    let (contact, k) = (contact(bytes), creepage(bytes));
    let options = bytes.options();
    let answer = asked(bytes, 2, |given, out| {
        kstrip_solve(given.input(0, &contact), given.input(1, &k), options.as_ref(), out)
    });
    let Some((status, r)) = answer else { return };
    plausible(&contact, &k, model_of(options), status, &r);
    let reversed =
        kstrip_creepage { longitudinal: -k.longitudinal, lateral: -k.lateral, spin: -k.spin };
    // exchanged bodies too: what pressure adds changes its sign
    let exchanged = kstrip_contact { mismatch: -contact.mismatch, ..contact };
    let back = solved(&exchanged, &reversed, options).expect("the same status");
    assert_eq!(back.warning.code(), status);
    assert!(
        (back.fx, back.fy, back.mz) == (-r.fx, -r.fy, -r.mz)
            && (back.power, back.adhesion) == (r.power, r.adhesion),
        "reversed creepages: {contact:?} {k:?} {options:?} {r:?} {back:?}"
    );
}

/// The functions of one model each, which answer like `kstrip_solve`.
fn of_one_model(
    bytes: &mut Bytes, model: i32,
    call: impl FnOnce(
        Option<&kstrip_contact>,
        Option<&kstrip_creepage>,
        i32,
        Option<&mut MaybeUninit<kstrip_result>>,
    ) -> i32,
) {
    let (contact, k) = (contact(bytes), creepage(bytes));
    let strips = bytes.strips();
    let given = bytes.given();
    let mut out = poisoned();
    let (c, m) = (given.input(0, &contact), given.input(1, &k));
    let status = call(c, m, strips, given.output(2, &mut out));
    let answer = answered(status, untouched(&out));
    assert!(given.all(3) || !answer);
    if given.all(3) {
        // The count of a model without strips does not matter.
        let no_strips = [KSTRIP_MODEL_TOTAL, KSTRIP_MODEL_LINEAR].contains(&model);
        let strips = if no_strips { 16 } else { strips };
        let same = solved(&contact, &k, Some(kstrip_options { model, strips }));
        // An error of the contact and one of the options may come in another order.
        assert_eq!(answer, same.is_ok(), "{status} {same:?}");
        if let Ok(same) = same {
            same_bits(&written(&out), &same);
        }
    }
}

fn solve_total(bytes: &mut Bytes) {
    of_one_model(bytes, KSTRIP_MODEL_TOTAL, |c, k, _, out| kstrip_solve_total(c, k, out));
}

fn solve_linear(bytes: &mut Bytes) {
    of_one_model(bytes, KSTRIP_MODEL_LINEAR, |c, k, _, out| kstrip_solve_linear(c, k, out));
}

fn solve_strip_1967(bytes: &mut Bytes) {
    of_one_model(bytes, KSTRIP_MODEL_STRIP_1967, |c, k, n, out| {
        kstrip_solve_strip_1967(c, k, n, out)
    });
}

fn solve_strip(bytes: &mut Bytes) {
    of_one_model(bytes, KSTRIP_MODEL_STRIP, |c, k, n, out| kstrip_solve_strip(c, k, n, out));
}

/// Where the outputs of an evaluation go, each with its pattern.
pub struct All {
    pub result: MaybeUninit<kstrip_result>,
    pub derivatives: MaybeUninit<kstrip_derivatives>,
    pub law_derivatives: MaybeUninit<kstrip_law_derivatives>,
    pub friction: MaybeUninit<Float>,
    pub strips: [MaybeUninit<kstrip_strip>; MOST_STRIPS],
    pub count: MaybeUninit<u32>,
    pub capacity: usize,
    /// Which are requested: result, derivatives, by the law, friction, strips, count.
    given: Given,
}

impl All {
    pub fn new(bytes: &mut Bytes) -> Self {
        let choice = bytes.byte();
        let given = Given(if choice < 128 { bytes.byte() } else { 0xff });
        Self {
            result: poisoned(),
            derivatives: poisoned(),
            law_derivatives: poisoned(),
            friction: poisoned(),
            strips: poisoned_array(),
            count: poisoned(),
            capacity: if choice < 224 { MOST_STRIPS - 1 } else { bytes.below(MOST_STRIPS) },
            given,
        }
    }

    pub fn outputs(&mut self) -> kstrip_outputs {
        let given = self.given;
        kstrip_outputs {
            result: given.place(0, &mut self.result),
            derivatives: given.place(1, &mut self.derivatives),
            law_derivatives: given.place(2, &mut self.law_derivatives),
            friction: given.place(3, &mut self.friction),
            strips: given.places(4, &mut self.strips),
            count: given.place(5, &mut self.count),
            capacity: self.capacity as u32,
            reserved: 0,
        }
    }

    /// Whether each of them is as it was.
    fn untouched(&self) -> [bool; 6] {
        [
            untouched(&self.result),
            untouched(&self.derivatives),
            untouched(&self.law_derivatives),
            untouched(&self.friction),
            all_untouched(&self.strips),
            untouched(&self.count),
        ]
    }

    /// Whether there is an answer: then what is requested is written, and nothing else.
    pub fn answered(&self, status: i32, context: impl Fn() -> String) -> bool {
        let untouched = self.untouched();
        if !answered(status, untouched == [true; 6]) {
            return false;
        }
        for (i, untouched) in (0..6).zip(untouched) {
            // (a contact may have no strips, and a count is one of strips)
            let may = i == 4 || (i == 5 && !self.given.has(4));
            assert!(may || untouched != self.given.has(i), "output {i}: {}", context());
        }
        if self.given.has(1) {
            let d = written(&self.derivatives);
            let vectors = [d.normal_force, d.friction, d.load_through_hertz];
            let all = d.jacobian.iter().chain(&vectors).all(|row| finite(row));
            assert!(all, "{} {d:?}", context());
        }
        if self.given.has(2) {
            let d = written(&self.law_derivatives);
            let vectors = [d.ratio, d.decay, d.rolling_speed, d.slope_factor];
            assert!(vectors.iter().all(|row| finite(row)), "{} {d:?}", context());
        }
        true
    }

    pub fn result(&self) -> Option<kstrip_result> {
        self.given.has(0).then(|| written(&self.result))
    }

    pub fn friction(&self) -> Option<Float> {
        self.given.has(3).then(|| written(&self.friction))
    }

    pub fn strips(&self) -> Option<Vec<kstrip_strip>> {
        let count = self.given.has(4).then(|| written(&self.count) as usize)?;
        assert!(count <= self.capacity && all_untouched(&self.strips[count..]));
        Some(self.strips[..count].iter().map(written).collect())
    }
}

fn evaluate(bytes: &mut Bytes) {
    let (contact, k, law) = (contact(bytes), creepage(bytes), friction_of(bytes));
    let options = bytes.options();
    let given = bytes.given();
    let with_law = bytes.byte() < 128;
    let mut all = All::new(bytes);
    let outputs = all.outputs();
    // SAFETY: each pointer is NULL or valid.
    let status = unsafe {
        kstrip_evaluate(
            given.input(0, &contact),
            given.input(1, &k),
            with_law.then_some(&law),
            options.as_ref(),
            given.input(2, &outputs),
        )
    };
    let context = || format!("{contact:?} {k:?} {options:?} {:?}", with_law.then_some(law));
    if !all.answered(status, context) {
        return;
    }
    assert!(given.all(3));
    if let Some(r) = all.result() {
        let model = model_of(options);
        if with_law {
            plausible_friction(&contact, &k, &law, model, &r, all.friction());
        } else {
            plausible(&contact, &k, model, r.warning.code(), &r);
            same_bits(&r, &solved(&contact, &k, options).expect("an answer"));
        }
    }
    if let Some(strips) = all.strips() {
        plausible_strips(&contact, with_law.then_some(&law), &strips, context);
    }
}

fn prepared(bytes: &mut Bytes) {
    let (contact, k) = (contact(bytes), creepage(bytes));
    let options = bytes.options();
    let given = bytes.given();
    let mut place = poisoned::<kstrip_prepared>();
    let status =
        kstrip_prepare(given.input(0, &contact), options.as_ref(), given.output(1, &mut place));
    if status < 0 {
        assert!(untouched(&place));
        return;
    }
    // SAFETY: status 0.
    let prepared = unsafe { place.assume_init() };
    let mut out = poisoned();
    let status = kstrip_solve_prepared(
        given.input(2, &prepared),
        given.input(3, &k),
        given.output(4, &mut out),
    );
    let answer = answered(status, untouched(&out));
    if given.all(5) {
        match solved(&contact, &k, options) {
            Ok(same) => same_bits(&written(&out), &same),
            Err(error) => assert_eq!((error, answer), (status, false)),
        }
    }
}

/// Forward, backward and standing: bounded, and friction never drives.
fn motion(bytes: &mut Bytes) {
    let (contact, law) = (contact(bytes), friction_of(bytes));
    let motion = kstrip_motion {
        slip_x: Number::of(bytes, 1e-2),
        slip_y: Number::of(bytes, 1e-2),
        spin_rate: Number::of(bytes, 1.0),
        rolling_speed: Number::of(bytes, 10.0),
        floor_speed: positive(bytes, 0.02),
    };
    let options = bytes.options();
    let (given, wanted) = (bytes.given(), bytes.given());
    let with_law = bytes.byte() < 128;
    let (mut result, mut derivatives, mut friction) =
        (poisoned::<kstrip_result>(), poisoned::<kstrip_motion_derivatives>(), poisoned());
    let outputs = kstrip_motion_outputs {
        result: wanted.place(0, &mut result),
        derivatives: wanted.place(1, &mut derivatives),
        friction: wanted.place(2, &mut friction),
    };
    // SAFETY: each pointer is NULL or valid.
    let status = unsafe {
        kstrip_solve_motion(
            given.input(0, &contact),
            given.input(1, &motion),
            with_law.then_some(&law),
            options.as_ref(),
            given.input(2, &outputs),
        )
    };
    let clean = [untouched(&result), untouched(&derivatives), untouched(&friction)];
    if !answered(status, clean == [true; 3]) {
        return;
    }
    assert!(given.all(3));
    assert_eq!(clean, [0, 1, 2].map(|i| !wanted.has(i)));
    let context = || format!("{contact:?} {motion:?} {options:?} {:?}", with_law.then_some(law));
    if wanted.has(0) {
        let r = written(&result);
        assert!(finite(&numbers_of(&r)), "{} {r:?}", context());
        let most = if with_law { law.friction } else { contact.friction };
        let bound = f64::from(most) * f64::from(contact.normal_force).max(0.0);
        let size = f64::from(r.fx).hypot(r.fy.into());
        let limit = bound * (1.0 + 4.0 * Float::ROUNDING) + 8.0 * Float::SMALLEST;
        assert!(model_of(options) == KSTRIP_MODEL_LINEAR || size <= limit, "{} {r:?}", context());
    }
    if wanted.has(1) {
        let d = written(&derivatives);
        let vectors = [d.rolling_speed, d.normal_force, d.load_through_hertz, d.friction];
        let others = [d.ratio, d.decay, d.slope_factor];
        let all = d.slip.iter().chain(&vectors).chain(&others).all(|row| finite(row));
        assert!(all, "{} {d:?}", context());
    }
}

/// Room for the strips of a contact, and one more.
pub const MOST_STRIPS: usize = KSTRIP_STRIPS_CAPACITY as usize + 1;

/// What holds for the strips of a contact: within the contact, and bounded.
fn plausible_strips(
    contact: &kstrip_contact, law: Option<&kstrip_friction>, strips: &[kstrip_strip],
    context: impl Fn() -> String,
) {
    if contact.is_lost() {
        assert!(strips.is_empty());
        return;
    }
    let friction = law.map_or(contact.friction, |law| law.friction);
    let bound = f64::from(friction) * f64::from(contact.normal_force);
    let lever = f64::from(contact.a).max(contact.b.into());
    // Shares of fx, fy, mz, and what there is of each to round: beyond the theory's spin some
    // strips take away what others have.
    let (mut sums, mut sizes) = ([0.0; 3], [0.0; 3]);
    for s in strips {
        let numbers = [s.y, s.width, s.half_length, s.separatrix, s.fx, s.fy, s.mz, s.power];
        assert!(finite(&numbers), "{} {s:?}", context());
        assert!(s.y.abs() <= contact.b * (1.0 + 1e-5), "outside the contact: {} {s:?}", context());
        assert!(matches!(s.state, State::Stick | State::Slip));
        for (i, share) in [s.fx, s.fy, s.mz].into_iter().enumerate() {
            sums[i] += f64::from(share);
            sizes[i] += f64::from(share).abs();
        }
    }
    for (i, lever) in [1.0, 1.0, lever].into_iter().enumerate() {
        let limit = 1.001 * bound * lever + 320.0 * Float::SMALLEST * (1.0 + lever);
        let allowed = limit + 100.0 * Float::ROUNDING * sizes[i];
        assert!(sums[i].abs() <= allowed, "{i}: {} of {limit}: {}", sums[i], context());
    }
}

/// What holds for every point of a field; `peak` is the largest friction bound of the contact.
pub fn plausible_point(p: &kstrip_point, friction: Float, peak: f64, context: impl Fn() -> String) {
    let numbers = [p.pressure, p.traction_x, p.traction_y, p.slip_x, p.slip_y, p.dissipation];
    assert!(finite(&numbers), "{} {p:?}", context());
    assert!(p.pressure >= 0.0 && p.reserved == 0, "{p:?}");
    // (of a lost contact friction is any number)
    let friction = f64::from(friction).max(0.0);
    let bound = friction * f64::from(p.pressure);
    // The bound of a point next to the separatrix is a difference of square roots; its digits are
    // those of the peak. A pressure below the smallest normal number has none.
    let lost = 4.0 * friction * Float::SMALLEST;
    let allowed = 1e3 * Float::ROUNDING * peak + lost + 1e-30;
    let traction = f64::from(p.traction_x).hypot(p.traction_y.into());
    assert!(traction <= bound + allowed, "{} {p:?}", context());
    match p.state {
        State::Outside => assert!(numbers.iter().all(|&n| n == 0.0), "{p:?}"),
        State::Stick => assert!(p.slip_x == 0.0 && p.slip_y == 0.0, "{p:?}"),
        State::Slip | State::SlipNegativeDissipation => {}
    }
}

fn peak(contact: &kstrip_contact) -> f64 {
    if contact.is_lost() {
        return 0.0;
    }
    let bound = f64::from(contact.friction) * f64::from(contact.normal_force);
    bound / f64::from(contact.a) / f64::from(contact.b)
}

/// Columns and rows of a grid, what its places may be, and room for its points.
pub struct Grid {
    pub x: Vec<Float>,
    pub y: Vec<Float>,
    pub capacity: usize,
    pub points: [MaybeUninit<kstrip_point>; Grid::MOST + 1],
}

impl Grid {
    const MOST: usize = 16;

    pub fn new(bytes: &mut Bytes, scale: f64) -> Self {
        let shape = bytes.byte();
        let (columns, rows) = (usize::from(shape % 5), usize::from(shape / 5 % 5));
        let capacity = if shape < 250 { Self::MOST } else { bytes.below(Self::MOST + 1) };
        let mut places = |count| (0..count).map(|_| Number::of(bytes, scale)).collect();
        Self { x: places(columns), y: places(rows), capacity, points: poisoned_array() }
    }

    /// All points that a call with this status should have written, after a look at the others.
    pub fn written(&self, status: i32) -> impl Iterator<Item = kstrip_point> {
        let needed = self.x.len() * self.y.len();
        let answer = answered(status, all_untouched(&self.points));
        assert!(!answer || needed <= self.capacity);
        let count = if answer { needed } else { 0 };
        assert!(all_untouched(&self.points[count..]), "written past the grid");
        self.points[..count].iter().map(written)
    }
}

fn field(bytes: &mut Bytes) {
    let (contact, k) = (contact(bytes), creepage(bytes));
    let options = bytes.options();
    let given = bytes.given();
    let law = (bytes.byte() < 100).then(|| friction_of(bytes));
    let mut grid = Grid::new(bytes, 5e-3);
    // Inputs may overlap each other.
    let y = if grid.x.len() == grid.y.len() { grid.x.clone() } else { grid.y.clone() };
    let y = if bytes.byte() < 64 && y.len() == grid.x.len() { &grid.x } else { &y };
    // SAFETY: NULL or as many elements as the counts say.
    let status = unsafe {
        kstrip_field(
            given.input(0, &contact),
            given.input(1, &k),
            law.as_ref(),
            options.as_ref(),
            given.array(2, &grid.x),
            grid.x.len() as u32,
            given.array(3, y),
            y.len() as u32,
            given.places(4, &mut grid.points),
            grid.capacity as u32,
        )
    };
    for point in grid.written(status) {
        let friction = law.map_or(contact.friction, |law| law.friction);
        plausible_point(&point, friction, peak(&kstrip_contact { friction, ..contact }), || {
            format!("{contact:?} {k:?} {law:?} {options:?}")
        });
    }
}

pub fn friction_of(bytes: &mut Bytes) -> kstrip_friction {
    kstrip_friction {
        friction: positive(bytes, 1.0),
        ratio: positive(bytes, 0.12),
        decay: positive(bytes, 1.0),
        rolling_speed: positive(bytes, 30.0),
        slope_factor: positive(bytes, 0.12),
        slide_factor: positive(bytes, 0.12),
        layer: positive(bytes, 1e-13),
    }
}

/// With the friction that was found, the result is one of a contact of that friction.
fn plausible_friction(
    contact: &kstrip_contact, k: &kstrip_creepage, friction: &kstrip_friction, model: i32,
    r: &kstrip_result, effective: Option<Float>,
) {
    let found = effective.unwrap_or(friction.friction);
    assert!(found >= 0.0 && found <= friction.friction, "{contact:?} {k:?} {friction:?} {found}");
    let contact = kstrip_contact { friction: found, ..*contact };
    plausible(&contact, k, model, r.warning.code(), r);
}

fn estimate_friction(bytes: &mut Bytes) {
    let (contact, k) = (contact(bytes), creepage(bytes));
    let options = bytes.options();
    let measured =
        if bytes.byte() < 8 { bytes.integer() as u32 } else { 1 + bytes.below(3) as u32 };
    let (fx, fy) = (Number::of(bytes, 1e5), Number::of(bytes, 1e5));
    let law = (bytes.byte() < 100).then(|| friction_of(bytes));
    let answer = asked::<kstrip_friction_estimate>(bytes, 2, |given, out| {
        let (contact, k) = (given.input(0, &contact), given.input(1, &k));
        let (law, options) = (law.as_ref(), options.as_ref());
        kstrip_estimate_friction(contact, k, law, options, measured, fx, fy, out)
    });
    if let Some((status, found)) = answer {
        let numbers = [found.friction, found.sensitivity, found.residual];
        let context = || format!("{contact:?} {k:?} {options:?} {measured} {fx} {fy} {found:?}");
        assert!(finite(&numbers), "{}", context());
        assert!(found.friction >= 0.0 && found.residual >= 0.0, "{}", context());
        assert_eq!((found.warning.code(), found.reserved), (status, 0));
    }
}

fn creepage_for_force(bytes: &mut Bytes) {
    let contact = contact(bytes);
    let (fx, fy, spin) = (Number::of(bytes, 1e5), Number::of(bytes, 1e5), Number::of(bytes, 3.0));
    let options = bytes.options();
    let law = (bytes.byte() < 100).then(|| friction_of(bytes));
    let answer = asked::<kstrip_creepage>(bytes, 1, |given, out| {
        let (contact, law) = (given.input(0, &contact), law.as_ref());
        kstrip_creepage_for_force(contact, fx, fy, spin, law, options.as_ref(), out)
    });
    if let Some((_, k)) = answer {
        let context = || format!("{contact:?} {fx} {fy} {options:?} {k:?}");
        assert!(finite(&[k.longitudinal, k.lateral]), "{}", context());
        assert_eq!(k.spin.bits(), Number::bits(spin), "{}", context());
    }
}

fn fit_friction(bytes: &mut Bytes) {
    let (contact, start) = (contact(bytes), friction_of(bytes));
    let options = bytes.options();
    let parameters = if bytes.byte() < 8 { bytes.integer() as u32 } else { bytes.below(64) as u32 };
    let points: Vec<_> = (0..bytes.below(7))
        .map(|_| {
            let k = creepage(bytes);
            kstrip_measured_force {
                longitudinal: k.longitudinal,
                lateral: k.lateral,
                spin: k.spin,
                fx: Number::of(bytes, 1e5),
                fy: Number::of(bytes, 1e5),
                weight: positive(bytes, 1.0),
                measured: 1 + bytes.below(3) as u32,
                reserved: 0,
            }
        })
        .collect();
    let count = points.len() as u32;
    let answer = asked::<kstrip_friction_fit>(bytes, 2, |given, out| {
        let (contact, start) = (given.input(0, &contact), given.input(1, &start));
        let options = options.as_ref();
        let points = points.as_ptr();
        // SAFETY: as many points as the count says.
        unsafe {
            kstrip_fit_friction(contact, points, count, start, parameters, options, out, None)
        }
    });
    if let Some((status, found)) = answer {
        let context = || format!("{contact:?} {start:?} {options:?} {points:?} {found:?}");
        let kstrip_friction { friction, ratio, decay, slope_factor, slide_factor, layer, .. } =
            found.law;
        assert!(
            finite(&[friction, ratio, decay, slope_factor, slide_factor, layer]),
            "{}",
            context()
        );
        let e = found.standard_errors;
        let errors = [e.friction, e.ratio, e.decay, e.slope_factor, e.slide_factor, e.layer];
        assert!(finite(&errors) && errors.iter().all(|error| *error >= 0.0), "{}", context());
        assert!(finite(&[found.residual]) && found.residual >= 0.0, "{}", context());
        assert!(found.steps <= 80 && found.warning.code() == status, "{}", context());
    }
}

pub const ENTRIES: &[Entry] = &[
    ("solve", solve),
    ("solve_total", solve_total),
    ("solve_linear", solve_linear),
    ("solve_strip_1967", solve_strip_1967),
    ("solve_strip", solve_strip),
    ("evaluate", evaluate),
    ("prepared", prepared),
    ("motion", motion),
    ("field", field),
    ("estimate_friction", estimate_friction),
    ("creepage_for_force", creepage_for_force),
    ("fit_friction", fit_friction),
];
