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

#include "kstrip.h"
#include "cases.h"

#ifndef CASES
#define CASES 10000u
#endif

#define SYST_CSR (*(volatile uint32_t *)0xE000E010u)
#define SYST_RVR (*(volatile uint32_t *)0xE000E014u)
#define SYST_CVR (*(volatile uint32_t *)0xE000E018u)

/* What is measured: every call with the same arguments. */
typedef kstrip_status (*call)(const kstrip_contact_f32 *, const kstrip_creepage_f32 *);

static kstrip_result_f32 result;
static float jacobian[9];

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
    static kstrip_status name##_jacobian(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k) \
    {                                                                                               \
        static const kstrip_options options = {model, strips};                                      \
        return kstrip_solve_jacobian_f32(c, k, &options, &result, jacobian);                        \
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

static kstrip_status hertz(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    /* A twin-disc pair whose radii follow the case: 20 mm to 640 mm. */
    const kstrip_radii_f32 radii = {c->a * 40.0f, 1e30f, 0.04f, c->b * 40.0f};
    const kstrip_combined_material_f32 pair = {c->shear_modulus, c->poisson_ratio, 0.0f};
    static kstrip_hertz_contact_f32 ellipse;
    (void)k;
    return kstrip_hertz_f32(&radii, c->normal_force, &pair, &ellipse);
}

static kstrip_status traction_strip(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    static const kstrip_options options = {KSTRIP_MODEL_STRIP, 16};
    static kstrip_point_f32 point;
    return kstrip_traction_at_f32(c, k, &options, 0.3f * c->a, 0.4f * c->b, &point);
}

static kstrip_status traction_strip_1967(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    static const kstrip_options options = {KSTRIP_MODEL_STRIP_1967, 16};
    static kstrip_point_f32 point;
    return kstrip_traction_at_f32(c, k, &options, 0.3f * c->a, 0.4f * c->b, &point);
}

static kstrip_strip_f32 written[KSTRIP_STRIPS_CAPACITY];

static kstrip_status strips_1967_16(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    static const kstrip_options options = {KSTRIP_MODEL_STRIP_1967, 16};
    uint32_t count;
    return kstrip_strips_f32(c, k, &options, written, KSTRIP_STRIPS_CAPACITY, &count);
}

static kstrip_status strips_16(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    static const kstrip_options options = {KSTRIP_MODEL_STRIP, 16};
    uint32_t count;
    return kstrip_strips_f32(c, k, &options, written, KSTRIP_STRIPS_CAPACITY, &count);
}

/* SysTick's ticks during one call, those of an empty call included. */
static uint32_t ticks(call what, const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k,
                      kstrip_status *status)
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
#define BINS 500000u
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

static void measure(const char *name, call what)
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
        cases_next(i, &contact, &creepage);
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
           fewest, median, most, stack_of(what) - empty_stack, most_in_range, most_case, refused);
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
    measure("jacobian.STRIP_1967.4", strip_1967_4_jacobian);
    measure("jacobian.STRIP_1967.8", strip_1967_8_jacobian);
    measure("jacobian.STRIP_1967.16", strip_1967_16_jacobian);
    measure("jacobian.STRIP.4", strip_4_jacobian);
    measure("jacobian.STRIP.8", strip_8_jacobian);
    measure("jacobian.STRIP.16", strip_16_jacobian);
    measure("jacobian.STRIP.64", strip_64_jacobian);
    measure("jacobian.TOTAL", total_jacobian);
    measure("jacobian.LINEAR", linear_jacobian);
    measure("hertz", hertz);
    measure("traction_at.STRIP_1967", traction_strip_1967);
    measure("traction_at.STRIP", traction_strip);
    measure("strips.STRIP_1967.16", strips_1967_16);
    measure("strips.STRIP.16", strips_16);
    return 0;
}
