/* The same inputs, the same program, on a microcontroller and on a PC: the two outputs must be the same
 * text. Bits of results are printed, or hashed, so that no rounding of printf can hide a difference.
 *
 * Compiled with -DCOMPARE_WITH_DOUBLE (on a PC) it also solves every case in double precision and prints
 * the largest differences, in units of mu N, to standard error, and how many exceed 2e-6. Some must: next to
 * the birth of an adhesion area forces go with the square root of the distance to it, and the
 * double-precision answer itself moves by more when an input moves by one rounding of single precision.
 * The exit status is 1 if a difference exceeds 4e-6 and is more than eight such movements (there are about
 * eight roundings between the inputs and xi, eta, psi).
 */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "kstrip_f32.h"
#include "cases.h"

#ifndef CASES
#define CASES 10000u
#endif
#define BLOCK 250u

/* FNV-1a, one byte at a time, independent of byte order. */
static uint32_t hash_word(uint32_t hash, uint32_t word)
{
    int i;
    for (i = 0; i < 4; ++i) {
        hash = (hash ^ ((word >> (8 * i)) & 0xFFu)) * 16777619u;
    }
    return hash;
}

static uint32_t bits(float x)
{
    uint32_t word;
    memcpy(&word, &x, sizeof word);
    return word;
}

static uint32_t hash_result(uint32_t hash, kstrip_status status, const kstrip_result_f32 *r)
{
    hash = hash_word(hash, (uint32_t)status);
    hash = hash_word(hash, bits(r->fx));
    hash = hash_word(hash, bits(r->fy));
    hash = hash_word(hash, bits(r->mz));
    hash = hash_word(hash, bits(r->power));
    hash = hash_word(hash, bits(r->adhesion));
    return hash_word(hash, (uint32_t)r->status_detail);
}

#ifdef COMPARE_WITH_DOUBLE
#include <math.h>
#define ALLOWED 2e-6
#define FAILED 4e-6
#define ROUNDINGS 8.0

static int too_far = 0;
/* Force differences in mu N (moments: mu N sqrt(a b)) per model. */
static double largest_force[6], largest_moment[6], sum_force[6];
static unsigned counted[6], beyond[6], unexplained[6], worst_case[6];

/* How far the force in double precision moves when creepage, friction or Poisson's ratio change by half
 * a unit of single precision's last place. */
static double conditioning(const kstrip_contact *contact, const kstrip_creepage *creepage,
                           const kstrip_options *options, const kstrip_result *at)
{
    const double step = 1.0 / 16777216.0;
    double largest = 0.0;
    int i;
    for (i = 0; i < 10; ++i) {
        kstrip_contact c = *contact;
        kstrip_creepage k = *creepage;
        kstrip_result r;
        double *const inputs[5] = {&k.longitudinal, &k.lateral, &k.spin, &c.friction, &c.poisson_ratio};
        *inputs[i / 2] *= i % 2 == 0 ? 1.0 - step : 1.0 + step;
        if (kstrip_solve(&c, &k, options, &r) >= 0) {
            largest = fmax(largest, hypot(r.fx - at->fx, r.fy - at->fy));
        }
    }
    return largest;
}

static void compare(uint32_t index, const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k,
                    const kstrip_options *options, const kstrip_result_f32 *single)
{
    const kstrip_contact contact = {c->a, c->b, c->normal_force, c->shear_modulus, c->poisson_ratio,
                                    c->friction, c->mismatch};
    const kstrip_creepage creepage = {k->longitudinal, k->lateral, k->spin};
    kstrip_result r;
    double bound = (double)c->friction * (double)c->normal_force;
    double force, moment, moved;
    int m = options->model;
    if (kstrip_solve(&contact, &creepage, options, &r) < 0 || bound <= 0.0) {
        return;
    }
    /* Linear theory has no bound: there the size of the force is the unit. */
    bound = fmax(bound, hypot(r.fx, r.fy));
    force = hypot(single->fx - r.fx, single->fy - r.fy) / bound;
    moment = fabs(single->mz - r.mz) / fmax(bound * sqrt(contact.a * contact.b), fabs(r.mz));
    counted[m] += 1;
    sum_force[m] += force;
    if (force > largest_force[m]) {
        largest_force[m] = force;
        worst_case[m] = index;
    }
    largest_moment[m] = fmax(largest_moment[m], moment);
    if (force <= ALLOWED) {
        return;
    }
    beyond[m] += 1;
    moved = ROUNDINGS * conditioning(&contact, &creepage, options, &r) / bound;
    if (!(force <= fmax(ALLOWED, moved))) {
        fprintf(stderr, "case %" PRIu32 " model %d: force differs by %.2g mu N, rounding of the inputs explains %.2g\n",
                index, m, force, moved);
        unexplained[m] += 1;
        if (!(force <= FAILED)) {
            too_far = 1;
        }
    }
}

static void report(void)
{
    static const char *const names[6] = {"", "STRIP_1967", "STRIP_1967_CONTINUOUS", "STRIP", "TOTAL",
                                         "LINEAR"};
    int m;
    for (m = 1; m <= 5; ++m) {
        fprintf(stderr,
                "f32-f64 %s: force mean %.1e, largest %.1e (case %u), moment largest %.1e; %u of %u beyond %.0e, %u without such a reason\n",
                names[m], sum_force[m] / counted[m], largest_force[m], worst_case[m], largest_moment[m],
                beyond[m], counted[m], ALLOWED, unexplained[m]);
    }
}
#endif

int main(void)
{
    static const kstrip_options all[] = {
        {KSTRIP_MODEL_STRIP_1967, 8},
        {KSTRIP_MODEL_STRIP_1967_CONTINUOUS, 16},
        {KSTRIP_MODEL_STRIP, 16},
        {KSTRIP_MODEL_TOTAL, 16},
        {KSTRIP_MODEL_LINEAR, 16},
    };
    enum { MODELS = sizeof all / sizeof all[0] };
    uint32_t hash[MODELS];
    uint32_t i;
    int m, status = 0;

    if (kstrip_abi_version() != KSTRIP_ABI_VERSION) {
        printf("header and library differ\n");
        return 2;
    }
    printf("kstrip %s, %" PRIu32 " cases\n", kstrip_version_string(), (uint32_t)CASES);
    cases_restart();
    for (i = 0; i < CASES; ++i) {
        kstrip_contact_f32 contact;
        kstrip_creepage_f32 creepage;
        cases_next(i, &contact, &creepage);
        for (m = 0; m < MODELS; ++m) {
            kstrip_result_f32 r;
            kstrip_status s;
            memset(&r, 0, sizeof r);
            s = kstrip_solve_f32(&contact, &creepage, &all[m], &r);
            if (s < 0) {
                status = 1;
            }
            if (i % BLOCK == 0) {
                hash[m] = 2166136261u;
            }
            hash[m] = hash_result(hash[m], s, &r);
            if (i % BLOCK == 3) {
                printf("case %" PRIu32 " model %" PRId32 " status %" PRId32 " %08" PRIx32 " %08" PRIx32
                       " %08" PRIx32 " %08" PRIx32 "\n", i, all[m].model, s, bits(r.fx), bits(r.fy),
                       bits(r.mz), bits(r.adhesion));
            }
            if (i % BLOCK == BLOCK - 1) {
                printf("to %" PRIu32 " model %" PRId32 " hash %08" PRIx32 "\n", i, all[m].model, hash[m]);
            }
            /* The derivatives, on fewer cases: they are the most expensive call. */
            if (i % 16 == 3) {
                kstrip_derivatives_f32 slopes;
                const kstrip_outputs_f32 outputs = {.result = &r, .derivatives = &slopes};
                int e;
                uint32_t h = 2166136261u;
                s = kstrip_evaluate_f32(&contact, &creepage, NULL, &all[m], &outputs);
                for (e = 0; e < 9 && s >= 0; ++e) {
                    h = hash_word(h, bits(slopes.jacobian[e / 3][e % 3]));
                }
                hash[m] = hash_result(h ^ hash[m], s, &r);
            }
#ifdef COMPARE_WITH_DOUBLE
            if (s >= 0) {
                compare(i, &contact, &creepage, &all[m], &r);
            }
#endif
        }
    }
#ifdef COMPARE_WITH_DOUBLE
    report();
    if (too_far) {
        return 1;
    }
#endif
    printf(status == 0 ? "all cases solved\n" : "a case was refused\n");
    return status;
}
