/* The control loop of a twin-disc test rig at 1 kHz, on simulated sensors.
 *
 *      lower disc: driven, crowned       upper disc: braked, cylindrical
 *
 * Every millisecond the loop
 *   1. reads normal load, both speeds and the traction force,
 *   2. turns speeds into creepage and load into the contact ellipse,
 *   3. computes force, adhesion and the force's derivatives for the present estimate of friction,
 *   4. corrects that estimate by the difference to the measured traction,
 *   5. says how much traction may be asked for before the contact slides, and at which creepage that is: the
 *      contact is now constant, prepared once, and solved for eight creepages,
 *   6. keeps every twentieth point of the creep curve.
 * Once a second of the simulated rig it fits the curve to these 50 points: the coefficient of friction and the
 * slope factor, with their standard errors. A fit takes more than a second of a processor of 168 MHz, so that
 * firmware calls it less often, and where the control loop may interrupt it.
 *
 * Friction is estimated with the model's own sensitivity. Force is F = mu N f(creepage/mu), so
 *   dF/dmu = (F - sum_j dF/dcreepage_j creepage_j)/mu:
 * zero while the contact sticks (no friction can be seen in a force that does not depend on it) and N in
 * full sliding. The step is that of normalised least mean squares.
 *
 * The rig is simulated with the same library, a friction that changes (dry, oil, drying) and sensor noise:
 * the program tests the loop and the arithmetic on the chip, not the theory.
 *
 * With TIMED it prints the most instructions of a period and of a fit, by the timer of the board that QEMU
 * simulates (scripts/firmware.sh).
 *
 * It prints a line every 50 ms, and with it the bits of inputs and outputs of the library;
 * twin_disc_check.c computes these again in double precision on a PC. Returns 0 if the estimate has
 * found every friction within 3 %, and so has every fit of a second in which friction did not change.
 */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "kstrip_f32.h"

/* What the sensors deliver. */
struct sensors {
    float load;            /* N */
    float lower_speed;     /* surface speeds, m/s */
    float upper_speed;
    float traction;        /* N, on the lower disc */
};

#define POINTS 50            /* of the creep curve */
#define SECOND 1000          /* ms */

/* What the loop remembers and says. */
struct controller {
    kstrip_contact_f32 contact;    /* with the estimated friction */
    kstrip_creepage_f32 creepage;
    kstrip_result_f32 result;
    float available;               /* N: traction left before the limit */
    float target;                  /* creepage at the limit */
    int32_t limited;               /* 1: reduce the torque */
    kstrip_measured_force_f32 curve[POINTS];    /* traction divided by the load */
    kstrip_friction_fit_f32 fit;
};

static const kstrip_material_f32 steel = {82e9f, 0.28f};
static kstrip_combined_material_f32 pair;
/* Discs of 40 mm radius, the lower one crowned with 120 mm. 1e9 m is flat. */
static const kstrip_radii_f32 radii = {0.040f, 0.120f, 0.040f, 1e9f};

static const kstrip_options model = {KSTRIP_MODEL_STRIP, 8};

#define GAIN 0.05f
#define LIMIT 0.85f          /* share of mu N that the torque control may use */
#define FRICTION_LOWEST 0.02f
#define FRICTION_HIGHEST 0.80f

/* The creepage at which LIMIT of the friction bound is used, by halving: the force grows with the creepage. */
static kstrip_status find_target(struct controller *self)
{
    kstrip_prepared_f32 prepared;
    float low = 0.0f, high = 0.04f;
    int i;
    kstrip_status status = kstrip_prepare_f32(&self->contact, &model, &prepared);
    for (i = 0; i < 8 && status >= 0; ++i) {
        const kstrip_creepage_f32 tried = {0.5f * (low + high), 0.0f, 0.0f};
        kstrip_result_f32 found;
        status = kstrip_solve_prepared_f32(&prepared, &tried, &found);
        if (found.fx < LIMIT * self->contact.friction * self->contact.normal_force) {
            low = tried.longitudinal;
        } else {
            high = tried.longitudinal;
        }
    }
    self->target = 0.5f * (low + high);
    return status;
}

/* One period of the loop; what the firmware of a real rig would contain. */
static kstrip_status control(struct controller *self, const struct sensors *in)
{
    const kstrip_velocity_f32 lower = {-in->lower_speed, 0.0f, 0.0f};
    const kstrip_velocity_f32 upper = {-in->upper_speed, 0.0f, 0.0f};
    const float rolling_speed = 0.5f * (in->lower_speed + in->upper_speed);
    kstrip_derivatives_f32 slopes;
    const kstrip_outputs_f32 outputs = {.result = &self->result, .derivatives = &slopes};
    float sensitivity, bound;
    kstrip_status status;

    status = kstrip_contact_from_hertz_f32(&radii, &pair, in->load, self->contact.friction, &self->contact, NULL);
    if (status < 0) {
        return status;
    }
    status = kstrip_creepage_from_velocities_f32(&lower, &upper, rolling_speed, &self->creepage);
    if (status < 0) {
        return status;
    }
    status = kstrip_evaluate_f32(&self->contact, &self->creepage, NULL, &model, &outputs);
    if (status < 0) {
        return status;
    }

    bound = self->contact.friction * in->load;
    sensitivity = (self->result.fx - slopes.jacobian[0][0] * self->creepage.longitudinal) / self->contact.friction;
    /* Below a fifth of its greatest value the sensitivity says more about the model than about friction. */
    if (sensitivity > 0.2f * in->load || sensitivity < -0.2f * in->load) {
        float mu = self->contact.friction
                   + GAIN * sensitivity * (in->traction - self->result.fx) / (sensitivity * sensitivity);
        mu = mu < FRICTION_LOWEST ? FRICTION_LOWEST : mu;
        self->contact.friction = mu > FRICTION_HIGHEST ? FRICTION_HIGHEST : mu;
    }
    self->available = LIMIT * bound - (self->result.fx < 0.0f ? -self->result.fx : self->result.fx);
    self->limited = self->available < 0.0f;
    return find_target(self);
}

/* A point of the creep curve; load and traction vary together, so that their quotient is kept. */
static void keep(struct controller *self, const struct sensors *in, int32_t ms)
{
    if (ms % (SECOND / POINTS) == 0) {
        kstrip_measured_force_f32 *point = &self->curve[ms % SECOND / (SECOND / POINTS)];
        memset(point, 0, sizeof *point);
        point->longitudinal = self->creepage.longitudinal;
        point->fx = in->traction / in->load;
        point->weight = 1.0f;
        point->measured = KSTRIP_MEASURED_FX;
    }
}

/* The curve of the last second, for the present load. */
static kstrip_status fit_curve(struct controller *self)
{
    static const kstrip_friction_f32 start = {.friction = 0.2f, .ratio = 1.0f, .slope_factor = 1.0f};
    static kstrip_measured_force_f32 points[POINTS];
    int i;
    for (i = 0; i < POINTS; ++i) {
        points[i] = self->curve[i];
        points[i].fx *= self->contact.normal_force;
    }
    return kstrip_fit_friction_f32(&self->contact, points, POINTS, &start,
                                   KSTRIP_FIT_FRICTION | KSTRIP_FIT_SLOPE_FACTOR, NULL, &self->fit, NULL);
}

#ifdef TIMED
/* The first timer of the board: 32 bits, downward, 3.2 ticks for an instruction under -icount shift=7. */
#define TIMER_CTRL (*(volatile uint32_t *)0x40000000u)
#define TIMER_VALUE (*(volatile uint32_t *)0x40000004u)
#define TIMER_RELOAD (*(volatile uint32_t *)0x40000008u)
static void start_timer(void)
{
    TIMER_CTRL = 0;
    TIMER_RELOAD = TIMER_VALUE = 0xFFFFFFFFu;
    TIMER_CTRL = 1u;
}
static uint32_t timer(void)
{
    return TIMER_VALUE;
}
#else
static void start_timer(void)
{
}
static uint32_t timer(void)
{
    return 0;
}
#endif

/* The most instructions since the timer's value `before`. */
static void note(uint32_t *most, uint32_t before)
{
    const uint32_t n = (uint32_t)((uint64_t)(before - timer()) * 5u / 16u);
    *most = n > *most ? n : *most;
}

/* The simulated rig. */

static uint32_t noise_state = 7;

/* Between -1 and 1, the sum of four: nearly a bell. */
static float noise(void)
{
    float sum = 0.0f;
    int i;
    for (i = 0; i < 4; ++i) {
        noise_state = noise_state * 1664525u + 1013904223u;
        sum += (float)(noise_state >> 16) * (1.0f / 65536.0f) - 0.5f;
    }
    return 0.5f * sum;
}

/* 0 to 1 to 0, with the given period in milliseconds. */
static float triangle(int32_t ms, int32_t period)
{
    const int32_t phase = ms % period;
    return (float)(2 * phase < period ? 2 * phase : 2 * (period - phase)) / (float)period;
}

#define PHASE 1500 /* ms */
static const float frictions[] = {0.32f, 0.09f, 0.21f};
#define PHASES ((int32_t)(sizeof frictions / sizeof frictions[0]))

static kstrip_status rig(int32_t ms, struct sensors *out)
{
    const float creep = 0.012f * triangle(ms, 300);
    const float load = 800.0f + 200.0f * triangle(ms, 700);
    kstrip_contact_f32 contact;
    kstrip_result_f32 truth;
    kstrip_status status =
        kstrip_contact_from_hertz_f32(&radii, &pair, load, frictions[ms / PHASE], &contact, NULL);
    if (status >= 0) {
        const kstrip_creepage_f32 creepage = {creep, 0.0f, 0.0f};
        const kstrip_options fine = {KSTRIP_MODEL_STRIP, 16};
        status = kstrip_solve_f32(&contact, &creepage, &fine, &truth);
    }
    if (status < 0) {
        return status;
    }
    out->load = load * (1.0f + 0.005f * noise());
    out->lower_speed = 5.0f * (1.0f + 0.5f * creep) + 1e-4f * noise();
    out->upper_speed = 5.0f * (1.0f - 0.5f * creep) + 1e-4f * noise();
    out->traction = truth.fx * (1.0f + 0.01f * noise()) + 0.5f * noise();
    return status;
}

static uint32_t bits(float x)
{
    uint32_t word;
    memcpy(&word, &x, sizeof word);
    return word;
}

/* Rounded to an integer, in units of 1/scale. */
static int32_t scaled(float x, float scale)
{
    x *= scale;
    return (int32_t)(x < 0.0f ? x - 0.5f : x + 0.5f);
}

int main(void)
{
    static struct controller loop;
    int32_t ms, missed = 0, limited = 0;
    uint32_t most_of_loop = 0, most_of_fit = 0, before;

    start_timer();
    if (kstrip_material_combine_f32(&steel, &steel, &pair) != KSTRIP_OK) {
        return 2;
    }
    loop.contact.friction = 0.15f;

    printf("# ms load[N] creepage[1e-6] measured[mN] predicted[mN] stick[1e-3] friction[1e-3] available[mN] limited target[1e-6]"
           " | a b N G nu mu longitudinal lateral spin | fx fy mz adhesion\n");
    for (ms = 0; ms < PHASE * PHASES; ++ms) {
        struct sensors now;
        float friction_before = loop.contact.friction;
        kstrip_status status = rig(ms, &now);
        if (status >= 0) {
            before = timer();
            status = control(&loop, &now);
            keep(&loop, &now, ms);
            note(&most_of_loop, before);
        }
        if (status >= 0 && ms % SECOND == SECOND - 1) {
            before = timer();
            status = fit_curve(&loop);
            note(&most_of_fit, before);
            printf("# second %" PRId32 ": friction %" PRId32 "e-3 +- %" PRId32 "e-3, slope factor %" PRId32 "e-2, %" PRIu32
                   " steps\n", ms / SECOND, scaled(loop.fit.law.friction, 1e3f),
                   scaled(loop.fit.standard_errors.friction, 1e3f), scaled(loop.fit.law.slope_factor, 1e2f), loop.fit.steps);
            if ((ms - SECOND + 1) / PHASE == ms / PHASE) {
                const float error = loop.fit.law.friction / frictions[ms / PHASE] - 1.0f;
                missed += !(error > -0.03f && error < 0.03f);
            }
        }
        if (status < 0) {
            printf("error at %" PRId32 " ms: %s\n", ms, kstrip_status_string(status));
            return 2;
        }
        limited += loop.limited;
        if (ms % 50 == 49) {
            const kstrip_contact_f32 *c = &loop.contact;
            const kstrip_creepage_f32 *k = &loop.creepage;
            const kstrip_result_f32 *r = &loop.result;
            printf("%" PRId32 " %" PRId32 " %" PRId32 " %" PRId32 " %" PRId32 " %" PRId32 " %" PRId32
                   " %" PRId32 " %" PRId32 " %" PRId32, ms, scaled(now.load, 1.0f), scaled(k->longitudinal, 1e6f),
                   scaled(now.traction, 1e3f), scaled(r->fx, 1e3f), scaled(r->adhesion, 1e3f),
                   scaled(c->friction, 1e3f), scaled(loop.available, 1e3f), loop.limited,
                   scaled(loop.target, 1e6f));
            printf(" | %08" PRIx32 " %08" PRIx32 " %08" PRIx32 " %08" PRIx32 " %08" PRIx32 " %08" PRIx32
                   " %08" PRIx32 " %08" PRIx32 " %08" PRIx32, bits(c->a), bits(c->b), bits(c->normal_force),
                   bits(c->shear_modulus), bits(c->poisson_ratio), bits(friction_before), bits(k->longitudinal),
                   bits(k->lateral), bits(k->spin));
            printf(" | %08" PRIx32 " %08" PRIx32 " %08" PRIx32 " %08" PRIx32 "\n", bits(r->fx), bits(r->fy),
                   bits(r->mz), bits(r->adhesion));
        }
        if (ms % PHASE == PHASE - 1) {
            const float truth = frictions[ms / PHASE];
            const float error = loop.contact.friction / truth - 1.0f;
            printf("# friction %" PRId32 "e-3, estimated %" PRId32 "e-3\n", scaled(truth, 1e3f),
                   scaled(loop.contact.friction, 1e3f));
            if (!(error > -0.03f && error < 0.03f)) {
                ++missed;
            }
        }
    }
    if (most_of_loop > 0) {
        printf("# most instructions: %" PRIu32 " of a period, %" PRIu32 " of a fit\n", most_of_loop, most_of_fit);
    }
    printf("# limited in %" PRId32 " of %" PRId32 " ms\n", limited, PHASE * PHASES);
    return missed == 0 ? 0 : 1;
}
