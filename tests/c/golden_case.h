/* One case of golden.c in one precision: included twice, with REAL the type of numbers, BITS an integer of its
 * size, and NAME(x) what x is called in that precision.
 */

static void NAME(add)(uint64_t *hash, REAL x)
{
    BITS bits;
    memcpy(&bits, &x, sizeof bits);
    *hash = mixed(*hash, bits);
}

static void NAME(add_all)(uint64_t *hash, const REAL *x, int count)
{
    int n;
    for (n = 0; n < count; n++)
        NAME(add)(hash, x[n]);
}

/* A status, and a result if there is one. */
static void NAME(add_result)(uint64_t *hash, kstrip_status status, const NAME(kstrip_result) *r)
{
    *hash = mixed(*hash, (uint32_t)status);
    if (status >= 0) {
        const REAL numbers[5] = {r->fx, r->fy, r->mz, r->power, r->adhesion};
        NAME(add_all)(hash, numbers, 5);
    }
}

/* With all derivatives. */
static void NAME(add_derivatives)(uint64_t *hash, kstrip_status status, const NAME(kstrip_result) *r,
                                  const NAME(kstrip_derivatives) *d,
                                  const NAME(kstrip_law_derivatives) *law)
{
    NAME(add_result)(hash, status, r);
    if (status >= 0) {
        NAME(add_all)(hash, &d->jacobian[0][0], 9);
        NAME(add_all)(hash, d->normal_force, 3);
        NAME(add_all)(hash, d->load_through_hertz, 3);
        NAME(add_all)(hash, d->friction, 3);
        NAME(add_all)(hash, law->ratio, 3);
        NAME(add_all)(hash, law->decay, 3);
        NAME(add_all)(hash, law->rolling_speed, 3);
        NAME(add_all)(hash, law->slope_factor, 3);
    }
}

static void NAME(add_point)(uint64_t *hash, kstrip_status status, const NAME(kstrip_point) *p)
{
    *hash = mixed(*hash, (uint32_t)status);
    if (status >= 0) {
        const REAL numbers[5] = {p->pressure, p->traction_x, p->traction_y, p->slip_x, p->slip_y};
        NAME(add_all)(hash, numbers, 5);
        *hash = mixed(*hash, (uint32_t)p->state);
    }
}

static void NAME(add_strips)(uint64_t *hash, kstrip_status status, const NAME(kstrip_strip) *strips,
                             uint32_t count)
{
    uint32_t n;
    *hash = mixed(*hash, (uint32_t)status);
    for (n = 0; status >= 0 && n < count; n++) {
        const NAME(kstrip_strip) s = strips[n];
        const REAL numbers[8] = {s.y,  s.width, s.half_length, s.separatrix,
                                 s.fx, s.fy,    s.mz,          s.power};
        NAME(add_all)(hash, numbers, 8);
        *hash = mixed(*hash, (uint32_t)s.state);
    }
}

/* A quotient of integers, rounded to this precision. */
static REAL NAME(part)(uint32_t whole, double of)
{
    return (REAL)((double)whole / of);
}

/* A batch of one contact; with derivatives unless d is NULL. */
static kstrip_status NAME(batch)(const NAME(kstrip_contact) *c, const NAME(kstrip_creepage) *k,
                                 const kstrip_options *o, NAME(kstrip_result) *r,
                                 NAME(kstrip_derivatives) *d, NAME(kstrip_law_derivatives) *law)
{
    NAME(kstrip_batch_inputs) from;
    NAME(kstrip_batch_outputs) to;
    memset(&from, 0, sizeof from);
    memset(&to, 0, sizeof to);
    from.a = &c->a, from.b = &c->b, from.normal_force = &c->normal_force;
    from.shear_modulus = &c->shear_modulus, from.poisson_ratio = &c->poisson_ratio;
    from.friction = &c->friction, from.mismatch = &c->mismatch;
    from.longitudinal = &k->longitudinal, from.lateral = &k->lateral, from.spin = &k->spin;
    to.fx = &r->fx, to.fy = &r->fy, to.mz = &r->mz, to.power = &r->power;
    to.adhesion = &r->adhesion, to.status_detail = &r->status_detail;
    to.derivatives = d, to.law_derivatives = law;
    return NAME(kstrip_evaluate_batch)(&from, 1, o, &to, NULL);
}

/* Derivatives and three points of the field. */
static void NAME(field)(uint64_t *hash, const NAME(kstrip_contact) *c, const NAME(kstrip_creepage) *k,
                        const kstrip_options *o, int side_by_side)
{
    NAME(kstrip_result) r;
    NAME(kstrip_derivatives) d;
    NAME(kstrip_law_derivatives) law;
    NAME(kstrip_outputs) all;
    NAME(kstrip_point) p;
    kstrip_status status;
    int n;
    memset(&all, 0, sizeof all);
    all.result = &r, all.derivatives = &d, all.law_derivatives = &law;
    status = side_by_side ? NAME(batch)(c, k, o, &r, &d, &law)
                   : NAME(kstrip_evaluate)(c, k, NULL, o, &all);
    NAME(add_derivatives)(hash, status, &r, &d, &law);
    for (n = -1; n <= 1; n++) {
        const REAL x = c->a * (REAL)n / 2, y = c->b * (REAL)n / 4;
        status = NAME(kstrip_field)(c, k, NULL, o, &x, 1, &y, 1, &p, 1);
        NAME(add_point)(hash, status, &p);
    }
}

/* A patch by one of its three builders: the strips of an ellipse with friction of their own, strips in any order with
 * a gap between them, a rough profile. */
static kstrip_status NAME(build)(uint64_t *hash, uint32_t i, const NAME(kstrip_contact) *c,
                                 const kstrip_options *o, NAME(kstrip_patch) *patch)
{
    kstrip_status status;
    uint32_t n, at = 0;
    if (i / 5 % 3 == 0) {
        status = NAME(kstrip_patch_from_contact)(c, o, patch);
        for (n = 0; status >= 0 && n < patch->count; n++)
            patch->strips[n].friction *= NAME(part)(4 + draw(i, 100 + n, 5), 8);
    } else if (i / 5 % 3 == 1) {
        NAME(kstrip_patch_strip) strips[20];
        const uint32_t count = 2 + draw(i, 20, 19);
        for (n = 0; n < count; n++) {
            /* places in units of 1/20000 m, from the last strip to the first */
            NAME(kstrip_patch_strip) *strip = &strips[count - 1 - n];
            const uint32_t width = 2 * (1 + draw(i, 100 + n, 10));
            at += n == count / 2 ? 40 : 0;
            strip->y = NAME(part)(at + width / 2, 20000);
            strip->width = NAME(part)(width, 20000);
            strip->half_length = NAME(part)(40 + draw(i, 200 + n, 80), 20000);
            strip->centre_x = NAME(part)(draw(i, 300 + n, 20), 20000);
            strip->peak_pressure = NAME(part)(draw(i, 400 + n, 15), 1) * 100000000;
            strip->friction = NAME(part)(1 + draw(i, 500 + n, 50), 100);
            at += width;
        }
        status = NAME(kstrip_patch_from_strips)(strips, count, c->shear_modulus, c->poisson_ratio, patch);
    } else {
        NAME(kstrip_profile) profile;
        NAME(kstrip_profile_contact) load;
        NAME(kstrip_profile_result) found;
        REAL y[33], distance[33];
        const uint32_t bend = 1 + draw(i, 20, 8);
        for (n = 0; n < 33; n++) {
            const uint32_t away = n < 16 ? 16 - n : n - 16;
            y[n] = n < 16 ? -NAME(part)(away, 1000) : NAME(part)(away, 1000);
            distance[n] = NAME(part)(away * away * bend * 8 + draw(i, 100 + n, 20), 10000000);
        }
        memset(&load, 0, sizeof load);
        load.rolling_radius = NAME(part)(200 + draw(i, 21, 800), 1000);
        load.normal_force = c->normal_force;
        load.shear_modulus = c->shear_modulus;
        load.poisson_ratio = c->poisson_ratio;
        load.friction = c->friction;
        /* (more are fewer on a microcontroller) */
        load.strips = o->strips < 16 ? o->strips : 16;
        memset(&profile, 0, sizeof profile);
        profile.y = y;
        profile.distance = distance;
        profile.points = 33;
        status = NAME(kstrip_patch_from_profile)(&profile, &load, patch, &found);
        if (status >= 0) {
            const REAL numbers[4] = {found.approach, found.peak_pressure, found.normal_force,
                                     found.peak_y};
            NAME(add_all)(hash, numbers, 4);
            *hash = mixed(*hash, found.iterations);
        }
    }
    *hash = mixed(*hash, (uint32_t)status);
    return status;
}

static void NAME(patch)(uint64_t *hash, const NAME(kstrip_patch) *patch, const NAME(kstrip_creepage) *k,
                        const kstrip_options *o)
{
    NAME(kstrip_patch_summary) sum;
    NAME(kstrip_result) r;
    NAME(kstrip_point) p;
    NAME(kstrip_strip) strips[KSTRIP_PATCH_CAPACITY];
    NAME(kstrip_derivatives) d;
    NAME(kstrip_law_derivatives) law;
    NAME(kstrip_outputs) all;
    uint32_t count = 0, n;
    kstrip_status status = NAME(kstrip_patch_summarize)(patch, &sum);
    *hash = mixed(*hash, (uint32_t)status);
    if (status < 0)
        return;
    NAME(add)(hash, sum.normal_force);
    NAME(add)(hash, sum.friction_bound);
    NAME(add)(hash, sum.area);
    *hash = mixed(*hash, sum.lobes);
    for (n = 0; n < patch->count; n++) {
        const NAME(kstrip_patch_strip) s = patch->strips[n];
        const REAL numbers[6] = {s.y, s.width, s.half_length, s.centre_x, s.peak_pressure, s.friction};
        NAME(add_all)(hash, numbers, 6);
    }
    memset(&all, 0, sizeof all);
    all.result = &r, all.derivatives = &d, all.law_derivatives = &law;
    status = NAME(kstrip_patch_evaluate)(patch, k, NULL, o, &all);
    NAME(add_derivatives)(hash, status, &r, &d, &law);
    memset(&all, 0, sizeof all);
    all.strips = strips, all.capacity = KSTRIP_PATCH_CAPACITY, all.count = &count;
    status = NAME(kstrip_patch_evaluate)(patch, k, NULL, o, &all);
    NAME(add_strips)(hash, status, strips, count);
    for (n = 0; n < patch->count; n += 3) {
        const NAME(kstrip_patch_strip) s = patch->strips[n];
        const REAL x = s.centre_x - s.half_length / 4;
        status = NAME(kstrip_patch_field)(patch, k, NULL, o, &x, 1, &s.y, 1, &p, 1);
        NAME(add_point)(hash, status, &p);
    }
}

/* Friction that falls with the slip, of a contact and, unless it is NULL, of a patch, in the hash of patches. */
static void NAME(falling)(uint64_t *hash, uint64_t *of_patch, uint32_t i, const NAME(kstrip_contact) *c,
                          const NAME(kstrip_patch) *patch, const NAME(kstrip_creepage) *k,
                          const kstrip_options *o)
{
    NAME(kstrip_friction) law;
    NAME(kstrip_result) r;
    NAME(kstrip_point) p;
    NAME(kstrip_contact) slipping = *c;
    NAME(kstrip_derivatives) d;
    NAME(kstrip_law_derivatives) by_law;
    NAME(kstrip_outputs) all;
    REAL found, x, y;
    kstrip_status status;
    law.friction = NAME(part)(5 + draw(i, 30, 60), 100);
    law.ratio = NAME(part)(draw(i, 31, 11), 10);
    law.decay = NAME(part)(draw(i, 32, 20), 10);
    law.rolling_speed = NAME(part)(draw(i, 33, 60), 1);
    law.slope_factor = NAME(part)(1 + draw(i, 34, 10), 10);
    law.slide_factor = 0, law.layer = 0;
    memset(&all, 0, sizeof all);
    all.result = &r, all.friction = &found, all.derivatives = &d, all.law_derivatives = &by_law;
    status = NAME(kstrip_evaluate)(c, k, &law, o, &all);
    NAME(add_derivatives)(hash, status, &r, &d, &by_law);
    if (status >= 0) {
        NAME(add)(hash, found);
        slipping.friction = found;
        slipping.shear_modulus *= law.slope_factor;
        x = -c->a / 4, y = c->b / 8;
        status = NAME(kstrip_field)(c, k, &law, o, &x, 1, &y, 1, &p, 1);
        NAME(add_point)(hash, status, &p);
    }
    if (!patch)
        return;
    status = NAME(kstrip_patch_evaluate)(patch, k, &law, o, &all);
    NAME(add_derivatives)(of_patch, status, &r, &d, &by_law);
    if (status >= 0)
        NAME(add)(of_patch, found);
}

/* Forces at rest and without spin, lateral or longitudinal creepage; strips. */
static void NAME(special)(uint64_t *hash, const NAME(kstrip_contact) *c, const NAME(kstrip_creepage) *k,
                          const kstrip_options *o)
{
    NAME(kstrip_strip) strips[KSTRIP_STRIPS_CAPACITY];
    NAME(kstrip_outputs) all;
    NAME(kstrip_result) r;
    NAME(kstrip_creepage) motion = *k;
    uint32_t count = 0;
    kstrip_status status;
    int zeros;
    for (zeros = 0; zeros < 5; zeros++) {
        motion.longitudinal = zeros == 1 || zeros == 4 ? 0 : k->longitudinal;
        motion.lateral = zeros == 2 || zeros == 4 ? 0 : k->lateral;
        motion.spin = zeros == 3 || zeros == 4 ? 0 : k->spin;
        memset(&all, 0, sizeof all);
        all.result = &r;
        status = NAME(kstrip_evaluate)(c, &motion, NULL, o, &all);
        NAME(add_result)(hash, status, &r);
    }
    memset(&all, 0, sizeof all);
    all.strips = strips, all.capacity = KSTRIP_STRIPS_CAPACITY, all.count = &count;
    status = NAME(kstrip_evaluate)(c, k, NULL, o, &all);
    NAME(add_strips)(hash, status, strips, count);
}

/* Friction from a share of the force, and the creepage for it. */
static void NAME(rig)(uint64_t *hash, uint32_t i, const NAME(kstrip_contact) *c,
                      const NAME(kstrip_creepage) *k, const kstrip_options *o,
                      const NAME(kstrip_result) *r)
{
    const REAL share = NAME(part)(4 + draw(i, 40, 5), 8);
    const REAL fx = r->fx * share, fy = r->fy * share;
    NAME(kstrip_friction_estimate) estimate;
    NAME(kstrip_creepage) motion;
    kstrip_status status = NAME(kstrip_estimate_friction)(c, k, NULL, o, 1 + i / 5 % 3, fx, fy,
                                                             &estimate);
    *hash = mixed(*hash, (uint32_t)status);
    if (status >= 0) {
        NAME(add)(hash, estimate.friction);
        NAME(add)(hash, estimate.sensitivity);
        NAME(add)(hash, estimate.residual);
    }
    status = NAME(kstrip_creepage_for_force)(c, fx, fy, k->spin, NULL, o, &motion);
    *hash = mixed(*hash, (uint32_t)status);
    if (status >= 0) {
        NAME(add)(hash, motion.longitudinal);
        NAME(add)(hash, motion.lateral);
        NAME(add)(hash, motion.spin);
    }
}

/* Forces and all derivatives, those by the layer and the slide factor too. */
static void NAME(behind)(uint64_t *hash, kstrip_status status, const NAME(kstrip_result) *r,
                         const NAME(kstrip_derivatives) *d, const NAME(kstrip_law_derivatives) *law, REAL friction)
{
    NAME(add_derivatives)(hash, status, r, d, law);
    if (status >= 0) {
        NAME(add_all)(hash, law->slide_factor, 3);
        NAME(add_all)(hash, law->layer, 3);
        NAME(add)(hash, friction);
    }
}

/* Friction and slope factor of a law from the forces that it gives. */
static void NAME(fit)(uint64_t *hash, const NAME(kstrip_contact) *c, const NAME(kstrip_creepage) *k,
                      NAME(kstrip_friction) law, const kstrip_options *o)
{
    NAME(kstrip_measured_force) points[6];
    NAME(kstrip_friction_fit) fit;
    NAME(kstrip_result) r;
    NAME(kstrip_outputs) all;
    kstrip_status status;
    uint32_t count = 0, n;
    memset(&all, 0, sizeof all);
    all.result = &r;
    for (n = 0; n < 6; n++) {
        const REAL share = NAME(part)((n + 1) * (n + 1), 16);
        const NAME(kstrip_creepage) motion = {k->longitudinal * share, k->lateral * share, k->spin};
        NAME(kstrip_measured_force) *point = &points[count];
        if (NAME(kstrip_evaluate)(c, &motion, &law, o, &all) < 0)
            continue;
        memset(point, 0, sizeof *point);
        point->longitudinal = motion.longitudinal, point->lateral = motion.lateral, point->spin = motion.spin;
        point->fx = r.fx, point->fy = r.fy, point->weight = 1;
        point->measured = KSTRIP_MEASURED_FX | KSTRIP_MEASURED_FY;
        count++;
    }
    law.friction = 0, law.slope_factor = 0;
    status = NAME(kstrip_fit_friction)(c, points, count, &law, KSTRIP_FIT_FRICTION | KSTRIP_FIT_SLOPE_FACTOR, o, &fit, NULL);
    *hash = mixed(*hash, (uint32_t)status);
    if (status >= 0) {
        const REAL numbers[5] = {fit.law.friction, fit.law.slope_factor, fit.standard_errors.friction,
                                 fit.standard_errors.slope_factor, fit.residual};
        NAME(add_all)(hash, numbers, 5);
        *hash = mixed(*hash, fit.steps);
    }
}

/* A layer, what sliding leaves of it, or both; of a third of the contacts the friction falls.
 * The patch counts in its hash, and a fit of the law to its own forces in that of fits. */
static void NAME(layer)(uint64_t *hash, uint64_t *of_patch, uint64_t *of_fit, uint32_t i,
                        const NAME(kstrip_contact) *c, const NAME(kstrip_patch) *patch, const NAME(kstrip_creepage) *k,
                        const kstrip_options *o)
{
    const uint32_t kind = i / 5 % 3;
    NAME(kstrip_strip) strips[KSTRIP_STRIPS_CAPACITY];
    NAME(kstrip_friction) law;
    NAME(kstrip_result) r;
    NAME(kstrip_derivatives) d;
    NAME(kstrip_law_derivatives) by_law;
    NAME(kstrip_outputs) all;
    NAME(kstrip_point) p;
    REAL found = 0, x = -c->a / 4;
    const REAL y = c->b / 8;
    kstrip_status status;
    uint32_t count = 0, n;
    law.friction = NAME(part)(5 + draw(i, 50, 60), 100);
    law.ratio = NAME(part)(1 + draw(i, 51, 9), 10);
    law.decay = NAME(part)(draw(i, 52, 10), 10);
    law.rolling_speed = kind == 0 ? NAME(part)(1 + draw(i, 53, 40), 1) : 0;
    law.slope_factor = NAME(part)(1 + draw(i, 54, 10), 10);
    law.slide_factor = kind == 1 ? 0 : NAME(part)(1 + draw(i, 55, 10), 10);
    law.layer = kind == 2 ? 0 : NAME(part)(1 + draw(i, 56, 40), 4e14);
    memset(&all, 0, sizeof all);
    all.result = &r, all.friction = &found, all.derivatives = &d, all.law_derivatives = &by_law;
    status = NAME(kstrip_evaluate)(c, k, &law, o, &all);
    NAME(behind)(hash, status, &r, &d, &by_law, found);
    memset(&all, 0, sizeof all);
    all.strips = strips, all.capacity = KSTRIP_STRIPS_CAPACITY, all.count = &count;
    status = NAME(kstrip_evaluate)(c, k, &law, o, &all);
    *hash = mixed(*hash, status < 0 ? (uint32_t)status : count);
    for (n = 0; status >= 0 && n < count; n++) {
        const NAME(kstrip_strip) s = strips[n];
        const REAL numbers[8] = {s.y, s.width, s.half_length, s.separatrix, s.fx, s.fy, s.mz, s.power};
        NAME(add_all)(hash, numbers, 8);
    }
    status = NAME(kstrip_field)(c, k, &law, o, &x, 1, &y, 1, &p, 1);
    NAME(add_point)(hash, status, &p);
    if (patch) {
        memset(&all, 0, sizeof all);
        all.result = &r, all.friction = &found, all.derivatives = &d, all.law_derivatives = &by_law;
        status = NAME(kstrip_patch_evaluate)(patch, k, &law, o, &all);
        NAME(behind)(of_patch, status, &r, &d, &by_law, found);
        for (n = 0; n < patch->count; n += 5) {
            const NAME(kstrip_patch_strip) s = patch->strips[n];
            x = s.centre_x - s.half_length / 4;
            status = NAME(kstrip_patch_field)(patch, k, &law, o, &x, 1, &s.y, 1, &p, 1);
            NAME(add_point)(of_patch, status, &p);
        }
    }
    if (has_fit(i))
        NAME(fit)(of_fit, c, k, law, o);
}

static void NAME(hash_case)(uint64_t hashes[KINDS], uint32_t i, int side_by_side)
{
    kstrip_contact d;
    kstrip_creepage e;
    kstrip_options o;
    NAME(kstrip_result) r;
    inputs(i, &d, &e, &o);
    {
        const NAME(kstrip_contact) c = {(REAL)d.a,
                                        (REAL)d.b,
                                        (REAL)d.normal_force,
                                        (REAL)d.shear_modulus,
                                        (REAL)d.poisson_ratio,
                                        (REAL)d.friction,
                                        (REAL)d.mismatch};
        const NAME(kstrip_creepage) k = {(REAL)e.longitudinal, (REAL)e.lateral, (REAL)e.spin};
        const kstrip_status status = side_by_side ? NAME(batch)(&c, &k, &o, &r, NULL, NULL)
                                           : NAME(kstrip_solve)(&c, &k, &o, &r);
        NAME(add_result)(&hashes[SOLVES], status, &r);
        if (has_field(i))
            NAME(field)(&hashes[SOLVES], &c, &k, &o, side_by_side);
        if (has_rest(i)) {
            NAME(kstrip_patch) p;
            const int built = HAS_PATCHES && NAME(build)(&hashes[PATCHES], i, &c, &o, &p) >= 0;
            if (built)
                NAME(patch)(&hashes[PATCHES], &p, &k, &o);
            NAME(falling)(&hashes[FRICTION], &hashes[PATCHES], i, &c, built ? &p : NULL, &k, &o);
            NAME(special)(&hashes[SPECIAL], &c, &k, &o);
            NAME(rig)(&hashes[RIG], i, &c, &k, &o, &r);
            NAME(layer)(&hashes[LAYER], &hashes[PATCHES], &hashes[FIT], i, &c, built ? &p : NULL, &k, &o);
        }
    }
}
