/* Instructions and stack of the single-precision calls, over the inputs of cases.h.
 *
 * Under `qemu-system-arm -icount shift=7` one instruction takes 2^7 ns of simulated time, and SysTick
 * counts 25 MHz: 3.2 ticks for an instruction, the same in every run. These are instructions, not cycles:
 * cycles need the real chip, where the same program with the core's own clock gives them.
 *
 * One line per call: name, fewest, median and most instructions, bytes of stack, most instructions of the
 * cases without a warning (inside the model's range), the case that took most, cases refused.
 */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>

#include "kstrip_f32.h"
#include "cases.h"

#ifndef CASES
#define CASES 10000u
#endif
/* 1: for scripts/cycles.awk, which follows ticks() and measure() in QEMU's trace */
#ifndef TRACED
#define TRACED 0
#endif

#define SYST_CSR (*(volatile uint32_t *)0xE000E010u)
#define SYST_RVR (*(volatile uint32_t *)0xE000E014u)
#define SYST_CVR (*(volatile uint32_t *)0xE000E018u)

/* What is measured: every call with the same arguments. */
typedef kstrip_status (*call)(const kstrip_contact_f32 *, const kstrip_creepage_f32 *);

static kstrip_result_f32 result;
static kstrip_derivatives_f32 derivatives;
static kstrip_prepared_f32 prepared;

static kstrip_status nothing(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    (void)c;
    (void)k;
    return 0;
}

#define SOLVE(name, model, strips)                                                                  \
    static kstrip_status name(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)            \
    {                                                                                               \
        static const kstrip_options options = {model, strips};                                      \
        return kstrip_solve_f32(c, k, &options, &result);                                           \
    }                                                                                               \
    static kstrip_status name##_derivatives(const kstrip_contact_f32 *c,                            \
                                            const kstrip_creepage_f32 *k)                           \
    {                                                                                               \
        static const kstrip_options options = {model, strips};                                      \
        static const kstrip_outputs_f32 outputs = {.result = &result, .derivatives = &derivatives}; \
        return kstrip_evaluate_f32(c, k, NULL, &options, &outputs);                                 \
    }

SOLVE(strip_1967_4, KSTRIP_MODEL_STRIP_1967, 4)
SOLVE(strip_1967_8, KSTRIP_MODEL_STRIP_1967, 8)
SOLVE(strip_1967_16, KSTRIP_MODEL_STRIP_1967, 16)
SOLVE(strip_4, KSTRIP_MODEL_STRIP, 4)
SOLVE(strip_8, KSTRIP_MODEL_STRIP, 8)
SOLVE(strip_16, KSTRIP_MODEL_STRIP, 16)
SOLVE(strip_64, KSTRIP_MODEL_STRIP, 64)
SOLVE(total, KSTRIP_MODEL_TOTAL, 16)
SOLVE(linear, KSTRIP_MODEL_LINEAR, 16)

static kstrip_status only_total(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    return kstrip_solve_total_f32(c, k, &result);
}

static kstrip_status only_linear(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    return kstrip_solve_linear_f32(c, k, &result);
}

static kstrip_status only_strip_1967_8(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    return kstrip_solve_strip_1967_f32(c, k, 8, &result);
}

static kstrip_status on_prepared(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    (void)c;
    return kstrip_solve_prepared_f32(&prepared, k, &result);
}

static kstrip_status falling(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    const kstrip_friction_f32 law = {.friction = c->friction, .ratio = 0.5f, .decay = 0.1f, .rolling_speed = 20.0f};
    static const kstrip_outputs_f32 outputs = {.result = &result, .derivatives = &derivatives};
    return kstrip_evaluate_f32(c, k, &law, NULL, &outputs);
}

static kstrip_status in_motion(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    const kstrip_motion_f32 motion = {.slip_x = k->longitudinal * 10.0f, .slip_y = k->lateral * 10.0f,
                                      .spin_rate = k->spin * 10.0f, .rolling_speed = 10.0f};
    static kstrip_motion_derivatives_f32 slopes;
    static const kstrip_motion_outputs_f32 outputs = {.result = &result, .derivatives = &slopes};
    return kstrip_solve_motion_f32(c, &motion, NULL, NULL, &outputs);
}

/* A twin-disc pair whose radii follow the case: 20 mm to 640 mm. */
static kstrip_radii_f32 radii_of(const kstrip_contact_f32 *c)
{
    const kstrip_radii_f32 radii = {c->a * 40.0f, 1e30f, 0.04f, c->b * 40.0f};
    return radii;
}

static kstrip_status hertz(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    const kstrip_radii_f32 radii = radii_of(c);
    const kstrip_combined_material_f32 pair = {c->shear_modulus, c->poisson_ratio, 0.0f};
    kstrip_contact_f32 contact;
    (void)k;
    return kstrip_contact_from_hertz_f32(&radii, &pair, c->normal_force, c->friction, &contact, NULL);
}

static kstrip_status point(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k, int32_t model)
{
    const kstrip_options options = {model, 16};
    const float x = 0.3f * c->a, y = 0.4f * c->b;
    static kstrip_point_f32 at;
    return kstrip_field_f32(c, k, &options, &x, 1, &y, 1, &at, 1);
}

static kstrip_status point_strip(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    return point(c, k, KSTRIP_MODEL_STRIP);
}

static kstrip_status point_strip_1967(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    return point(c, k, KSTRIP_MODEL_STRIP_1967);
}

static kstrip_status strips_of(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k, int32_t model)
{
    const kstrip_options options = {model, 16};
    static kstrip_strip_f32 written[16];
    static uint32_t count;
    static const kstrip_outputs_f32 outputs = {.strips = written, .count = &count, .capacity = 16};
    return kstrip_evaluate_f32(c, k, NULL, &options, &outputs);
}

static kstrip_status strips_1967_16(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    return strips_of(c, k, KSTRIP_MODEL_STRIP_1967);
}

static kstrip_status strips_16(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    return strips_of(c, k, KSTRIP_MODEL_STRIP);
}

/* SysTick's ticks during one call, those of an empty call included. */
static __attribute__((noinline)) uint32_t ticks(call what, const kstrip_contact_f32 *c,
                                                const kstrip_creepage_f32 *k, kstrip_status *status)
{
    uint32_t before, after;
    SYST_CVR = 0;
    __asm volatile("" ::: "memory");
    before = SYST_CVR;
    *status = what(c, k);
    after = SYST_CVR;
    __asm volatile("" ::: "memory");
    return (before - after) & 0xFFFFFFu;
}

/* Counts of calls per number of instructions; more than the last are counted there. */
#define BINS (TRACED ? 2u : 500000u)
static uint16_t histogram[BINS];

#define PAINTED 65536u
#define PAINT 0x5AA5C33Cu

/* Paint the stack below this function's frame. */
static __attribute__((noinline)) volatile uint32_t *paint(void)
{
    volatile uint32_t *top, *p;
    uint32_t i;
    __asm volatile("mov %0, sp" : "=r"(top));
    p = top;
    for (i = 0; i < PAINTED / 4u; ++i) {
        *--p = PAINT;
    }
    return top;
}

/* Bytes between `top` and the deepest word that has changed. */
static uint32_t used(volatile uint32_t *top)
{
    volatile uint32_t *p = top - PAINTED / 4u;
    while (p < top && *p == PAINT) {
        ++p;
    }
    return (uint32_t)(top - p) * 4u;
}

/* Model that on_prepared() is measured with. */
static kstrip_options prepared_for = {KSTRIP_MODEL_TOTAL, 16};

/* The next case; its contact is prepared, which is not measured. */
static void next(uint32_t i, kstrip_contact_f32 *contact, kstrip_creepage_f32 *creepage)
{
    cases_next(i, contact, creepage);
    (void)kstrip_prepare_f32(contact, &prepared_for, &prepared);
}

/* The same frames for every call: what nothing() uses is subtracted. */
static __attribute__((noinline)) uint32_t stack_of(call what)
{
    volatile uint32_t *top = paint();
    uint32_t i;
    cases_restart();
    for (i = 0; i < CASES; ++i) {
        kstrip_contact_f32 contact;
        kstrip_creepage_f32 creepage;
        cases_next(i, &contact, &creepage);
        what(&contact, &creepage);
    }
    return used(top);
}

static uint32_t empty_ticks, empty_stack;

static __attribute__((noinline)) void measure(const char *name, call what)
{
    uint32_t i, fewest = 0xFFFFFFFFu, most = 0, sum = 0, median = 0, refused = 0;
    uint32_t most_case = 0, most_in_range = 0;
    for (i = 0; i < BINS; ++i) {
        histogram[i] = 0;
    }
    cases_restart();
    for (i = 0; i < CASES; ++i) {
        kstrip_contact_f32 contact;
        kstrip_creepage_f32 creepage;
        kstrip_status status;
        uint32_t n;
        next(i, &contact, &creepage);
        n = ((ticks(what, &contact, &creepage, &status) - empty_ticks) * 5u + 8u) / 16u;
        if (status < 0) {
            ++refused;
            continue;
        }
        if (n < fewest) {
            fewest = n;
        }
        if (n > most) {
            most = n;
            most_case = i;
        }
        if (status == KSTRIP_OK && n > most_in_range) {
            most_in_range = n;
        }
        histogram[n < BINS ? n : BINS - 1u] += 1;
    }
    while (median < BINS - 1u && (sum += histogram[median]) * 2u < CASES - refused) {
        ++median;
    }
    printf("%s %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 "\n", name,
           fewest, median, most, TRACED ? 0u : stack_of(what) - empty_stack, most_in_range, most_case, refused);
}

int main(void)
{
    kstrip_contact_f32 contact;
    kstrip_creepage_f32 creepage;
    kstrip_status status;
    SYST_RVR = 0xFFFFFFu;
    SYST_CVR = 0;
    SYST_CSR = 5u; /* core clock, no interrupt */
    cases_restart();
    cases_next(0, &contact, &creepage);
    empty_ticks = ticks(nothing, &contact, &creepage, &status);
    empty_stack = stack_of(nothing);
    printf("# call fewest median most stack most_in_range case_of_most refused\n");
    measure("solve.STRIP_1967.4", strip_1967_4);
    measure("solve.STRIP_1967.8", strip_1967_8);
    measure("solve.STRIP_1967.16", strip_1967_16);
    measure("solve.STRIP.4", strip_4);
    measure("solve.STRIP.8", strip_8);
    measure("solve.STRIP.16", strip_16);
    measure("solve.STRIP.64", strip_64);
    measure("solve.TOTAL", total);
    measure("solve.LINEAR", linear);
    measure("solve_total", only_total);
    measure("solve_linear", only_linear);
    measure("solve_strip_1967.8", only_strip_1967_8);
    measure("derivatives.STRIP_1967.4", strip_1967_4_derivatives);
    measure("derivatives.STRIP_1967.8", strip_1967_8_derivatives);
    measure("derivatives.STRIP_1967.16", strip_1967_16_derivatives);
    measure("derivatives.STRIP.4", strip_4_derivatives);
    measure("derivatives.STRIP.8", strip_8_derivatives);
    measure("derivatives.STRIP.16", strip_16_derivatives);
    measure("derivatives.STRIP.64", strip_64_derivatives);
    measure("derivatives.TOTAL", total_derivatives);
    measure("derivatives.LINEAR", linear_derivatives);
    prepared_for.model = KSTRIP_MODEL_TOTAL;
    measure("prepared.TOTAL", on_prepared);
    prepared_for.model = KSTRIP_MODEL_LINEAR;
    measure("prepared.LINEAR", on_prepared);
    prepared_for.model = KSTRIP_MODEL_STRIP_1967;
    measure("prepared.STRIP_1967.16", on_prepared);
    prepared_for.model = KSTRIP_MODEL_STRIP;
    measure("prepared.STRIP.16", on_prepared);
    measure("falling_friction.derivatives.TOTAL", falling);
    measure("motion.derivatives.TOTAL", in_motion);
    measure("contact_from_hertz", hertz);
    measure("field.point.STRIP_1967", point_strip_1967);
    measure("field.point.STRIP", point_strip);
    measure("strips.STRIP_1967.16", strips_1967_16);
    measure("strips.STRIP.16", strips_16);
    return 0;
}
