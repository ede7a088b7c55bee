//! One elliptic contact: forces, derivatives, strips, fields, falling friction, the inverse.

use super::super::*;
use super::*;

pub fn contact(bytes: &mut Bytes) -> kstrip_contact {
    kstrip_contact {
        a: positive(bytes, 5e-3),
        b: positive(bytes, 5e-3),
        normal_force: positive(bytes, 5e5),
        shear_modulus: positive(bytes, 82e10),
        poisson_ratio: positive(bytes, 0.06),
        friction: positive(bytes, 1.0),
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
    options.map_or(KSTRIP_MODEL_STRIP, |options| options.model)
}

/// What holds for every result.
fn plausible(
    contact: &kstrip_contact,
    k: &kstrip_creepage,
    model: i32,
    status: i32,
    r: &kstrip_result,
) {
    let context = || format!("{contact:?} {k:?} model {model} {r:?}");
    assert_eq!((r.status_detail, r.reserved), (status, 0));
    assert!(finite(&numbers_of(r)), "{}", context());
    let rounding = Float::ROUNDING;
    let bound = f64::from(contact.friction) * f64::from(contact.normal_force);
    let (fx, fy) = (f64::from(r.fx), f64::from(r.fy));
    if model != KSTRIP_MODEL_LINEAR {
        let size = fx.hypot(fy);
        assert!(size <= bound * (1.0 + rounding) + 4.0 * Float::SMALLEST, "{}", context());
    }
    let in_range = (0.0..=1.0).contains(&r.adhesion);
    assert!(in_range || (model == KSTRIP_MODEL_TOTAL && r.adhesion == -1.0), "{}", context());
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
    assert_eq!(one.status_detail, two.status_detail);
}

/// `kstrip_solve` once more, for what must be equal.
pub fn solved(
    contact: &kstrip_contact,
    k: &kstrip_creepage,
    options: Option<kstrip_options>,
) -> Result<kstrip_result, i32> {
    let mut out = poisoned();
    let status = kstrip_solve(Some(contact), Some(k), options.as_ref(), Some(&mut out));
    if answered(status, untouched(&out)) { Ok(written(&out)) } else { Err(status) }
}

pub fn solve(bytes: &mut Bytes) {
    let (contact, k) = (contact(bytes), creepage(bytes));
    let options = bytes.options();
    let given = bytes.given();
    let mut out = poisoned();
    let status = kstrip_solve(
        given.input(0, &contact),
        given.input(1, &k),
        options.as_ref(),
        given.output(2, &mut out),
    );
    if !answered(status, untouched(&out)) {
        return;
    }
    assert!(given.all(3));
    let r = written(&out);
    plausible(&contact, &k, model_of(options), status, &r);
    let reversed =
        kstrip_creepage { longitudinal: -k.longitudinal, lateral: -k.lateral, spin: -k.spin };
    let back = solved(&contact, &reversed, options).expect("the same status");
    assert_eq!(back.status_detail, status);
    assert!(
        (back.fx, back.fy, back.mz) == (-r.fx, -r.fy, -r.mz)
            && (back.power, back.adhesion) == (r.power, r.adhesion),
        "reversed creepages: {contact:?} {k:?} {options:?} {r:?} {back:?}"
    );
}

/// The functions of one model each, which answer like `kstrip_solve`.
fn of_one_model(
    bytes: &mut Bytes,
    model: i32,
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

fn jacobian(bytes: &mut Bytes) {
    let (contact, k) = (contact(bytes), creepage(bytes));
    let options = bytes.options();
    let given = bytes.given();
    let mut out = poisoned();
    let mut entries = poisoned_array::<Float, 9>();
    // SAFETY: NULL or nine numbers.
    let status = unsafe {
        kstrip_solve_jacobian(
            given.input(0, &contact),
            given.input(1, &k),
            options.as_ref(),
            given.output(2, &mut out),
            given.places(3, &mut entries),
        )
    };
    if answered(status, untouched(&out) && all_untouched(&entries)) {
        assert!(given.all(4));
        plausible(&contact, &k, model_of(options), status, &written(&out));
        let entries = entries.map(|entry| written(&entry));
        assert!(finite(&entries), "{contact:?} {k:?} {options:?} {entries:?}");
    }
}

fn derivatives(bytes: &mut Bytes) {
    let (contact, k) = (contact(bytes), creepage(bytes));
    let options = bytes.options();
    let given = bytes.given();
    let (mut out, mut slopes) = (poisoned(), poisoned::<kstrip_derivatives>());
    let status = kstrip_solve_derivatives(
        given.input(0, &contact),
        given.input(1, &k),
        options.as_ref(),
        given.output(2, &mut out),
        given.output(3, &mut slopes),
    );
    if answered(status, untouched(&out) && untouched(&slopes)) {
        assert!(given.all(4));
        plausible(&contact, &k, model_of(options), status, &written(&out));
        let d = written(&slopes);
        let all = finite(&d.jacobian)
            && finite(&d.normal_force)
            && finite(&d.friction)
            && finite(&d.load_through_hertz);
        assert!(all, "{contact:?} {k:?} {options:?} {d:?}");
    }
}

fn evaluate(bytes: &mut Bytes) {
    let (contact, k) = (contact(bytes), creepage(bytes));
    let options = bytes.options();
    let wanted = match bytes.byte() {
        choice @ 0..=247 => u32::from(choice % 32),
        _ => bytes.integer() as u32,
    };
    let wants = |flag| wanted & flag != 0;
    let given = bytes.given();
    let capacity = bytes.below(MOST_STRIPS);
    let mut out = poisoned();
    let mut entries = poisoned_array::<Float, 9>();
    let mut strips = [const { MaybeUninit::<kstrip_strip>::uninit() }; MOST_STRIPS];
    strips[..=capacity].fill_with(poisoned);
    let mut count = poisoned::<u32>();
    // SAFETY: NULL or nine numbers; NULL or at least as many strips as the capacity.
    let status = unsafe {
        kstrip_evaluate(
            given.input(0, &contact),
            given.input(1, &k),
            options.as_ref(),
            wanted,
            given.output(2, &mut out),
            given.places(3, &mut entries),
            given.places(4, &mut strips),
            capacity as u32,
            given.output(5, &mut count),
        )
    };
    let strips = &strips[..=capacity];
    let clean = [
        untouched(&out),
        all_untouched(&entries),
        all_untouched(&strips[..capacity]) && untouched(&count),
    ];
    assert!(untouched(&strips[capacity]), "written past the capacity");
    let context = || format!("{contact:?} {k:?} {options:?} {wanted}");
    let answer = answered(status, clean == [true; 3]);
    if !wants(KSTRIP_WANT_JACOBIAN) && !wants(KSTRIP_WANT_STRIPS) && wanted < 32 && given.all(3) {
        let same = solved(&contact, &k, options);
        assert_eq!(answer, same.is_ok(), "{} {status} {same:?}", context());
        if let Ok(same) = same {
            let r = written(&out);
            let of_same = [same.fx, same.fy].map(Number::bits);
            assert_eq!([r.fx, r.fy].map(Number::bits), of_same, "{}", context());
            let moment = !wants(KSTRIP_WANT_MOMENT) || r.mz.bits() == same.mz.bits();
            let stick = !wants(KSTRIP_WANT_ADHESION) || r.adhesion.bits() == same.adhesion.bits();
            assert!(moment && stick, "{} {r:?} {same:?}", context());
        }
    }
    if !answer {
        return;
    }
    assert!(wanted < 32 && given.all(3));
    let mut r = written(&out);
    if !wants(KSTRIP_WANT_ADHESION) {
        assert_eq!(r.adhesion, -1.0);
        r.adhesion = 0.0;
    }
    if !wants(KSTRIP_WANT_MOMENT) {
        assert_eq!((r.mz, r.power), (0.0, 0.0));
    }
    plausible(&contact, &k, model_of(options), status, &r);
    assert_eq!(clean[1], !wants(KSTRIP_WANT_JACOBIAN));
    assert_eq!(clean[2], !wants(KSTRIP_WANT_STRIPS));
    if wants(KSTRIP_WANT_JACOBIAN) {
        let entries = entries.map(|entry| written(&entry));
        assert!(finite(&entries), "{} {entries:?}", context());
    }
    if wants(KSTRIP_WANT_STRIPS) {
        plausible_strips(&contact, &strips[..capacity], written(&count), context);
    }
}

/// Room for the strips of a contact, and one more.
const MOST_STRIPS: usize = 256;

/// What holds for the strips of a contact: the first `count` are written, within the contact and bounded.
fn plausible_strips(
    contact: &kstrip_contact,
    strips: &[MaybeUninit<kstrip_strip>],
    count: u32,
    context: impl Fn() -> String,
) {
    let count = count as usize;
    assert!(count <= strips.len());
    assert!(all_untouched(&strips[count..]), "written past the count");
    let bound = f64::from(contact.friction) * f64::from(contact.normal_force);
    let lever = f64::from(contact.a).max(contact.b.into());
    // Shares of fx, fy, mz, and what there is of each to round: beyond the theory's spin some strips take away what
    // others have.
    let (mut sums, mut sizes) = ([0.0; 3], [0.0; 3]);
    for strip in &strips[..count] {
        let s = written(strip);
        let numbers = [s.y, s.width, s.half_length, s.separatrix, s.fx, s.fy, s.mz, s.power];
        assert!(finite(&numbers), "{} {s:?}", context());
        assert!(s.y.abs() <= contact.b * (1.0 + 1e-5), "outside the contact: {} {s:?}", context());
        assert!([KSTRIP_STATE_STICK, KSTRIP_STATE_SLIP].contains(&s.state));
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

fn strips(bytes: &mut Bytes) {
    let (contact, k) = (contact(bytes), creepage(bytes));
    let options = bytes.options();
    let given = bytes.given();
    let capacity = bytes.below(MOST_STRIPS);
    let mut strips = [const { MaybeUninit::<kstrip_strip>::uninit() }; MOST_STRIPS];
    strips[..=capacity].fill_with(poisoned);
    let mut count = poisoned::<u32>();
    // SAFETY: NULL or at least as many strips as the capacity.
    let status = unsafe {
        kstrip_strips(
            given.input(0, &contact),
            given.input(1, &k),
            options.as_ref(),
            given.places(2, &mut strips),
            capacity as u32,
            given.output(3, &mut count),
        )
    };
    let strips = &strips[..=capacity];
    assert!(untouched(&strips[capacity]), "written past the capacity");
    if answered(status, all_untouched(strips) && untouched(&count)) {
        assert!(given.has(0) && given.has(1) && given.has(3));
        plausible_strips(&contact, &strips[..capacity], written(&count), || {
            format!("{contact:?} {k:?} {options:?}")
        });
    }
}

/// What holds for every point of a field; `peak` is the largest friction bound of the contact.
pub fn plausible_point(p: &kstrip_point, friction: Float, peak: f64, context: impl Fn() -> String) {
    let numbers = [p.pressure, p.traction_x, p.traction_y, p.slip_x, p.slip_y, p.dissipation];
    assert!(finite(&numbers), "{} {p:?}", context());
    assert!(p.pressure >= 0.0 && p.reserved == 0, "{p:?}");
    let bound = f64::from(friction) * f64::from(p.pressure);
    // The bound of a point next to the separatrix is a difference of square roots; its digits are those of
    // the peak. A pressure below the smallest normal number has none.
    let lost = 4.0 * f64::from(friction) * Float::SMALLEST;
    let allowed = 1e3 * Float::ROUNDING * peak + lost + 1e-30;
    let traction = f64::from(p.traction_x).hypot(p.traction_y.into());
    assert!(traction <= bound + allowed, "{} {p:?}", context());
    match p.state {
        KSTRIP_STATE_OUTSIDE => assert!(numbers.iter().all(|&n| n == 0.0), "{p:?}"),
        KSTRIP_STATE_STICK => assert!(p.slip_x == 0.0 && p.slip_y == 0.0, "{p:?}"),
        KSTRIP_STATE_SLIP | KSTRIP_STATE_SLIP_NEGATIVE_DISSIPATION => {}
        state => panic!("state {state}"),
    }
}

fn peak(contact: &kstrip_contact) -> f64 {
    let bound = f64::from(contact.friction) * f64::from(contact.normal_force);
    bound / f64::from(contact.a) / f64::from(contact.b)
}

fn traction_at(bytes: &mut Bytes) {
    let (contact, k) = (contact(bytes), creepage(bytes));
    let options = bytes.options();
    let (x, y) = (Number::of(bytes, 5e-3), Number::of(bytes, 5e-3));
    let given = bytes.given();
    let mut point = poisoned();
    let status = kstrip_traction_at(
        given.input(0, &contact),
        given.input(1, &k),
        options.as_ref(),
        x,
        y,
        given.output(2, &mut point),
    );
    if answered(status, untouched(&point)) {
        assert!(given.all(3));
        plausible_point(&written(&point), contact.friction, peak(&contact), || {
            format!("{contact:?} {k:?} {options:?} {x} {y}")
        });
    }
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
    let mut grid = Grid::new(bytes, 5e-3);
    // Inputs may overlap each other.
    let y = if grid.x.len() == grid.y.len() { grid.x.clone() } else { grid.y.clone() };
    let y = if bytes.byte() < 64 && y.len() == grid.x.len() { &grid.x } else { &y };
    // SAFETY: NULL or as many elements as the counts say.
    let status = unsafe {
        kstrip_field(
            given.input(0, &contact),
            given.input(1, &k),
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
        plausible_point(&point, contact.friction, peak(&contact), || {
            format!("{contact:?} {k:?} {options:?}")
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
    }
}

/// With the friction that was found, the result is one of a contact of that friction.
fn plausible_friction(
    contact: &kstrip_contact,
    k: &kstrip_creepage,
    friction: &kstrip_friction,
    model: i32,
    r: &kstrip_result,
    effective: Option<Float>,
) {
    let found = effective.unwrap_or(friction.friction);
    assert!(found >= 0.0 && found <= friction.friction, "{contact:?} {k:?} {friction:?} {found}");
    let contact = kstrip_contact { friction: found, ..*contact };
    plausible(&contact, k, model, r.status_detail, r);
}

fn solve_friction(bytes: &mut Bytes) {
    let (contact, k, friction) = (contact(bytes), creepage(bytes), friction_of(bytes));
    let options = bytes.options();
    let given = bytes.given();
    let (mut out, mut effective) = (poisoned::<kstrip_result>(), poisoned::<Float>());
    let status = kstrip_solve_friction(
        given.input(0, &contact),
        given.input(1, &k),
        given.input(2, &friction),
        options.as_ref(),
        given.output(3, &mut out),
        given.output(4, &mut effective),
    );
    if answered(status, untouched(&out) && untouched(&effective)) {
        assert!(given.all(4));
        let r = written(&out);
        assert_eq!(r.status_detail, status);
        let effective = given.has(4).then(|| written(&effective));
        plausible_friction(&contact, &k, &friction, model_of(options), &r, effective);
    }
}

/// The contact as it is while it slips gives what `kstrip_solve_friction` gives.
fn contact_under_friction(bytes: &mut Bytes) {
    let (contact, k, friction) = (contact(bytes), creepage(bytes), friction_of(bytes));
    let options = bytes.options();
    let given = bytes.given();
    let mut out = poisoned::<kstrip_contact>();
    let status = kstrip_contact_under_friction(
        given.input(0, &contact),
        given.input(1, &k),
        given.input(2, &friction),
        options.as_ref(),
        given.output(3, &mut out),
    );
    if answered(status, untouched(&out)) {
        assert!(given.all(4));
        let slipping = written(&out);
        let found = slipping.friction;
        assert!(
            found >= 0.0 && found <= friction.friction,
            "{contact:?} {k:?} {friction:?} {found}"
        );
        let r = solved(&slipping, &k, options).expect("an answer");
        plausible(&slipping, &k, model_of(options), r.status_detail, &r);
    }
}

fn solve_friction_jacobian(bytes: &mut Bytes) {
    let (contact, k, friction) = (contact(bytes), creepage(bytes), friction_of(bytes));
    let options = bytes.options();
    let given = bytes.given();
    let (mut out, mut effective) = (poisoned::<kstrip_result>(), poisoned::<Float>());
    let mut entries = poisoned_array::<Float, 9>();
    // SAFETY: NULL or nine numbers.
    let status = unsafe {
        kstrip_solve_friction_jacobian(
            given.input(0, &contact),
            given.input(1, &k),
            given.input(2, &friction),
            options.as_ref(),
            given.output(3, &mut out),
            given.places(4, &mut entries),
            given.output(5, &mut effective),
        )
    };
    let clean = untouched(&out) && all_untouched(&entries) && untouched(&effective);
    if answered(status, clean) {
        assert!(given.all(5));
        let r = written(&out);
        assert_eq!(r.status_detail, status);
        let effective = given.has(5).then(|| written(&effective));
        plausible_friction(&contact, &k, &friction, model_of(options), &r, effective);
        let entries = entries.map(|entry| written(&entry));
        assert!(finite(&entries), "{contact:?} {k:?} {friction:?} {options:?} {entries:?}");
    }
}

fn estimate_friction(bytes: &mut Bytes) {
    let (contact, k) = (contact(bytes), creepage(bytes));
    let options = bytes.options();
    let measured =
        if bytes.byte() < 8 { bytes.integer() as u32 } else { 1 + bytes.below(3) as u32 };
    let (fx, fy) = (Number::of(bytes, 1e5), Number::of(bytes, 1e5));
    let given = bytes.given();
    let mut out = poisoned::<kstrip_friction_estimate>();
    let status = kstrip_estimate_friction(
        given.input(0, &contact),
        given.input(1, &k),
        options.as_ref(),
        measured,
        fx,
        fy,
        given.output(2, &mut out),
    );
    if answered(status, untouched(&out)) {
        assert!(given.all(3));
        let found = written(&out);
        let numbers = [found.friction, found.sensitivity, found.residual];
        let context = || format!("{contact:?} {k:?} {options:?} {measured} {fx} {fy} {found:?}");
        assert!(finite(&numbers), "{}", context());
        assert!(found.friction >= 0.0 && found.residual >= 0.0, "{}", context());
        assert_eq!((found.status_detail, found.reserved), (status, 0));
    }
}

fn creepage_for_force(bytes: &mut Bytes) {
    let contact = contact(bytes);
    let (fx, fy, spin) = (Number::of(bytes, 1e5), Number::of(bytes, 1e5), Number::of(bytes, 3.0));
    let options = bytes.options();
    let given = bytes.given();
    let mut out = poisoned::<kstrip_creepage>();
    let status = kstrip_creepage_for_force(
        given.input(0, &contact),
        fx,
        fy,
        spin,
        options.as_ref(),
        given.output(1, &mut out),
    );
    if answered(status, untouched(&out)) {
        assert!(given.all(2));
        let k = written(&out);
        let context = || format!("{contact:?} {fx} {fy} {options:?} {k:?}");
        assert!(finite(&[k.longitudinal, k.lateral]), "{}", context());
        assert_eq!(k.spin.bits(), Number::bits(spin), "{}", context());
    }
}

pub const ENTRIES: &[Entry] = &[
    ("solve", solve),
    ("solve_total", solve_total),
    ("solve_linear", solve_linear),
    ("solve_strip_1967", solve_strip_1967),
    ("solve_strip", solve_strip),
    ("jacobian", jacobian),
    ("derivatives", derivatives),
    ("evaluate", evaluate),
    ("strips", strips),
    ("traction_at", traction_at),
    ("field", field),
    ("solve_friction", solve_friction),
    ("contact_under_friction", contact_under_friction),
    ("solve_friction_jacobian", solve_friction_jacobian),
    ("estimate_friction", estimate_friction),
    ("creepage_for_force", creepage_for_force),
];
