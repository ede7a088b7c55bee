/* Instructions and stack of the single-precision calls, over the inputs of cases.h.
 *
 * Under `qemu-system-arm -icount shift=7` one instruction takes 2^7 ns of simulated time, and the board's
 * timer counts 25 MHz: 3.2 ticks for an instruction, the same in every run. These are instructions, not
 * cycles: cycles need the real chip, where the same program with the core's own clock gives them.
 *
 * One line per call: name, fewest, median and most instructions, bytes of stack, most instructions of the
 * cases without a warning (inside the model's range), the case that took most, cases refused.
 */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "kstrip_f32.h"
#include "cases.h"

#ifndef CASES
#define CASES 10000u
#endif
/* 1: for scripts/cycles.awk, which follows ticks() and measure() in QEMU's trace */
#ifndef TRACED
#define TRACED 0
#endif

/* Cases of a call that takes millions of instructions. */
#define FEW (TRACED ? 3u : CASES / 50u)

#ifdef __riscv
/* QEMU counts 2^7 for an instruction under -icount shift=7. */
static uint32_t count(void)
{
    uint32_t high, low, again;
    do {
        __asm volatile("rdinstreth %0\n\trdinstret %1\n\trdinstreth %2" : "=&r"(high), "=&r"(low), "=&r"(again));
    } while (high != again);
    return 0u - (high << 25 | low >> 7);
}
#define INSTRUCTIONS(ticks) (ticks)
#define STACK_POINTER "mv %0, sp"
#else
/* The first timer of the board: 32 bits, downward. */
#define TIMER_CTRL (*(volatile uint32_t *)0x40000000u)
#define TIMER_VALUE (*(volatile uint32_t *)0x40000004u)
#define TIMER_RELOAD (*(volatile uint32_t *)0x40000008u)
#define count() TIMER_VALUE
#define INSTRUCTIONS(ticks) ((uint32_t)(((uint64_t)(ticks) * 5u + 8u) / 16u))
#define STACK_POINTER "mov %0, sp"
#endif

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

static kstrip_status estimate(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    static kstrip_friction_estimate_f32 found;
    return kstrip_estimate_friction_f32(c, k, NULL, NULL, KSTRIP_MEASURED_FX | KSTRIP_MEASURED_FY, result.fx, result.fy,
                                        &found);
}

/* The force that estimate() explains. */
static void next_force(uint32_t i, kstrip_contact_f32 *contact, kstrip_creepage_f32 *creepage)
{
    cases_next(i, contact, creepage);
    (void)kstrip_solve_f32(contact, creepage, NULL, &result);
}

/* A measured creep curve of falling friction, with errors of one per cent. */
#define FIT_POINTS 50
static kstrip_measured_force_f32 curve[FIT_POINTS];

static void next_curve(uint32_t i, kstrip_contact_f32 *contact, kstrip_creepage_f32 *creepage)
{
    kstrip_friction_f32 law = {.ratio = 0.4f, .decay = 0.5f, .rolling_speed = 20.0f};
    static const kstrip_outputs_f32 outputs = {.result = &result};
    uint32_t k;
    do {
        cases_next(i & ~3u, contact, creepage);
    } while (contact->normal_force == 0.0f);
    law.friction = contact->friction;
    for (k = 0; k < FIT_POINTS; ++k) {
        creepage->longitudinal = 1e-3f * (float)(k + 1);
        creepage->lateral = creepage->spin = 0.0f;
        (void)kstrip_evaluate_f32(contact, creepage, &law, NULL, &outputs);
        curve[k] = (kstrip_measured_force_f32){.longitudinal = creepage->longitudinal, .weight = 1.0f,
                                               .fx = result.fx * (0.99f + 0.02f * cases_unit()),
                                               .measured = KSTRIP_MEASURED_FX};
    }
}

static kstrip_status fit_friction(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    static const kstrip_friction_f32 start = {.rolling_speed = 20.0f};
    static kstrip_friction_fit_f32 fit;
    (void)k;
    return kstrip_fit_friction_f32(c, curve, FIT_POINTS, &start, KSTRIP_FIT_FRICTION | KSTRIP_FIT_RATIO | KSTRIP_FIT_DECAY,
                                   NULL, &fit, NULL);
}

static kstrip_status point(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k, int32_t model)
{
    const kstrip_options options = {model, 16};
    const float x = 0.3f * c->a, y = 0.4f * c->b;
    static kstrip_point_f32 at;
    return kstrip_field_f32(c, k, NULL, &options, &x, 1, &y, 1, &at, 1);
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

/* A wheel on a rail: a head of 300 mm radius with a gauge corner, a cone of 1:20 with a flange. */
#define POINTS 300
static float rail_y[POINTS], rail_z[POINTS], wheel_y[POINTS], wheel_z[POINTS];
static kstrip_surface_f32 rail, wheel;
static kstrip_wheel_workspace_f32 workspace;
static kstrip_wheel_position_f32 position;
static kstrip_wheel_velocity_f32 velocity;
static kstrip_wrench_f32 wrench;
static kstrip_wrench_derivatives_f32 wrench_slopes;
static kstrip_wrench_by_position_f32 wrench_by_position;
static const kstrip_wheel_pair_f32 wheel_pair = {.wheel_radius = 0.46f, .shear_modulus = 82e9f, .poisson_ratio = 0.28f,
                                                 .friction = 0.3f};

static void profiles(void)
{
    uint32_t i;
    for (i = 0; i < POINTS; ++i) {
        const float y = -38e-3f + 76e-3f * ((float)i / (POINTS - 1)), corner = y + 27e-3f;
        const float w = -55e-3f + 100e-3f * ((float)i / (POINTS - 1)), root = w + 32e-3f;
        rail_y[i] = y;
        rail_z[i] = y * y / 0.6f + (corner < 0.0f ? corner * corner / 8e-3f : 0.0f);
        wheel_y[i] = w;
        wheel_z[i] = -0.05f * w + (root < 0.0f ? root * root / 30e-3f : 0.0f);
    }
}

/* The wheel touches with its tread, with its flange, or with both; yaw and creepage of every size; the surfaces overlap by
 * 20 to 160 um. */
static void next_wheel(uint32_t i, kstrip_contact_f32 *contact, kstrip_creepage_f32 *creepage)
{
    float least;
    cases_next(i, contact, creepage);
    position.lateral = 4e-3f + 5e-3f * cases_unit();
    position.yaw = cases_signed(6e-3f * cases_unit());
    position.vertical = 0.0f;
    position.roll = 0.0f;
    (void)kstrip_touch_f32(&rail, &wheel, wheel_pair.wheel_radius, &position, 5e-3f, &workspace.gap, &least);
    position.vertical = least + cases_spread(20e-6f, 3);
    velocity.forward = 20.0f;
    velocity.lateral = creepage->lateral * 20.0f;
    velocity.pitch = -20.0f / wheel_pair.wheel_radius * (1.0f + creepage->longitudinal);
    (void)kstrip_wheel_on_rail_f32(&rail, &wheel, &wheel_pair, &position, &velocity, NULL, &workspace, &wrench, NULL, NULL);
}

static kstrip_status prepare_profile(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    static kstrip_surface_f32 surface;
    (void)c;
    (void)k;
    return kstrip_prepare_profile_f32(wheel_y, wheel_z, POINTS, 0.0f, 2e-3f, &surface);
}

static kstrip_status touch(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    float least;
    (void)c;
    (void)k;
    return kstrip_touch_f32(&rail, &wheel, wheel_pair.wheel_radius, &position, 0.0f, &workspace.gap, &least);
}

static kstrip_status contacts_from_gap(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    (void)c;
    (void)k;
    return kstrip_contacts_from_gap_f32(&workspace.gap, &wheel_pair, &position, &workspace.strips, workspace.contacts,
                                        &workspace.count);
}

static kstrip_status wrench_from_contacts(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    (void)c;
    (void)k;
    return kstrip_wrench_from_contacts_f32(workspace.contacts, workspace.count, &velocity, 0, NULL, &wrench, NULL);
}

static kstrip_status wheel_on_rail(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    (void)c;
    (void)k;
    return kstrip_wheel_on_rail_f32(&rail, &wheel, &wheel_pair, &position, &velocity, NULL, &workspace, &wrench, NULL, NULL);
}

static kstrip_status wheel_on_rail_derivatives(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    (void)c;
    (void)k;
    return kstrip_wheel_on_rail_f32(&rail, &wheel, &wheel_pair, &position, &velocity, NULL, &workspace, &wrench,
                                    &wrench_slopes, NULL);
}

static kstrip_status wheel_on_rail_by_position(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    (void)c;
    (void)k;
    return kstrip_wheel_on_rail_f32(&rail, &wheel, &wheel_pair, &position, &velocity, NULL, &workspace, &wrench,
                                    &wrench_slopes, &wrench_by_position);
}

static kstrip_status height_for_load(const kstrip_contact_f32 *c, const kstrip_creepage_f32 *k)
{
    float vertical;
    (void)c;
    (void)k;
    return kstrip_height_for_load_f32(&rail, &wheel, &wheel_pair, &position, 80e3f, NULL, NULL, NULL, &workspace, &vertical);
}

/* The timer's ticks during one call, those of an empty call included. */
static __attribute__((noinline)) uint32_t ticks(call what, const kstrip_contact_f32 *c,
                                                const kstrip_creepage_f32 *k, kstrip_status *status)
{
    uint32_t before, after;
    __asm volatile("" ::: "memory");
    before = count();
    *status = what(c, k);
    after = count();
    __asm volatile("" ::: "memory");
    return before - after;
}

/* Instructions of each call. */
static uint32_t counts[CASES];

static int ascending(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

#define PAINTED 65536u
#define PAINT 0x5AA5C33Cu

/* Paint the stack below this function's frame. */
static __attribute__((noinline)) volatile uint32_t *paint(void)
{
    volatile uint32_t *top, *p;
    uint32_t i;
    __asm volatile(STACK_POINTER : "=r"(top));
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

/* What makes a case; it is not measured. */
typedef void (*maker)(uint32_t, kstrip_contact_f32 *, kstrip_creepage_f32 *);

/* The same frames for every call: what nothing() uses is subtracted. Case by case, so that the stack of `make` does not count. */
static __attribute__((noinline)) uint32_t stack_of_each(call what, maker make, uint32_t cases)
{
    uint32_t i, deepest = 0;
    cases_restart();
    for (i = 0; i < cases; ++i) {
        kstrip_contact_f32 contact;
        kstrip_creepage_f32 creepage;
        volatile uint32_t *top;
        uint32_t n;
        make(i, &contact, &creepage);
        top = paint();
        what(&contact, &creepage);
        n = used(top);
        if (n > deepest) {
            deepest = n;
        }
    }
    return deepest;
}

/* The same for cheap calls, whose cases need no stack: painted once. */
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

static uint32_t empty_ticks, empty_stack, empty_stack_of_each;

static __attribute__((noinline)) void measure(const char *name, call what, maker make, uint32_t cases)
{
    uint32_t i, accepted = 0, most = 0, most_case = 0, most_in_range = 0, stack = 0;
    cases_restart();
    for (i = 0; i < cases; ++i) {
        kstrip_contact_f32 contact;
        kstrip_creepage_f32 creepage;
        kstrip_status status;
        uint32_t n;
        make(i, &contact, &creepage);
        n = INSTRUCTIONS(ticks(what, &contact, &creepage, &status) - empty_ticks);
        if (status < 0) {
            continue;
        }
        if (n > most) {
            most = n;
            most_case = i;
        }
        if (status == KSTRIP_OK && n > most_in_range) {
            most_in_range = n;
        }
        counts[accepted++] = n;
    }
    if (accepted == 0) {
        printf("%s: every case is refused\n", name);
        exit(1);
    }
    qsort(counts, accepted, sizeof *counts, ascending);
    if (!TRACED) {
        stack = make == next ? stack_of(what) - empty_stack : stack_of_each(what, make, cases) - empty_stack_of_each;
    }
    printf("%s %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 "\n", name,
           counts[0], counts[(accepted - 1u) / 2u], most, stack, most_in_range, most_case, cases - accepted);
}

static void of_contact(const char *name, call what)
{
    measure(name, what, next, CASES);
}

/* Not on a core that computes floating point by software. */
static void of_wheel(const char *name, call what)
{
#ifdef __riscv
    (void)name;
    (void)what;
    (void)next_wheel;
#else
    measure(name, what, next_wheel, FEW);
#endif
}

int main(void)
{
    kstrip_contact_f32 contact;
    kstrip_creepage_f32 creepage;
    kstrip_status status;
#ifndef __riscv
    TIMER_CTRL = 0;
    TIMER_RELOAD = TIMER_VALUE = 0xFFFFFFFFu;
    TIMER_CTRL = 1u;
#endif
    profiles();
    if (kstrip_prepare_profile_f32(rail_y, rail_z, POINTS, 0.0f, 0.0f, &rail) < 0
        || kstrip_prepare_profile_f32(wheel_y, wheel_z, POINTS, 0.0f, 0.0f, &wheel) < 0) {
        return 1;
    }
    cases_restart();
    cases_next(0, &contact, &creepage);
    empty_ticks = ticks(nothing, &contact, &creepage, &status);
    empty_stack = stack_of(nothing);
    empty_stack_of_each = stack_of_each(nothing, next, 10);
    printf("# call fewest median most stack most_in_range case_of_most refused\n");
    of_contact("solve.STRIP_1967.16", strip_1967_16);
    of_contact("solve.STRIP.4", strip_4);
    of_contact("solve.STRIP.8", strip_8);
    of_contact("solve.STRIP.16", strip_16);
    of_contact("solve.STRIP.64", strip_64);
    of_contact("solve.TOTAL", total);
    of_contact("solve.LINEAR", linear);
    of_contact("solve_total", only_total);
    of_contact("solve_linear", only_linear);
    of_contact("solve_strip_1967.8", only_strip_1967_8);
    of_contact("derivatives.STRIP_1967.16", strip_1967_16_derivatives);
    of_contact("derivatives.STRIP.4", strip_4_derivatives);
    of_contact("derivatives.STRIP.8", strip_8_derivatives);
    of_contact("derivatives.STRIP.16", strip_16_derivatives);
    of_contact("derivatives.STRIP.64", strip_64_derivatives);
    of_contact("derivatives.TOTAL", total_derivatives);
    of_contact("derivatives.LINEAR", linear_derivatives);
    prepared_for.model = KSTRIP_MODEL_TOTAL;
    of_contact("prepared.TOTAL", on_prepared);
    prepared_for.model = KSTRIP_MODEL_LINEAR;
    of_contact("prepared.LINEAR", on_prepared);
    prepared_for.model = KSTRIP_MODEL_STRIP_1967;
    of_contact("prepared.STRIP_1967.16", on_prepared);
    prepared_for.model = KSTRIP_MODEL_STRIP;
    of_contact("prepared.STRIP.16", on_prepared);
    of_contact("falling_friction.derivatives.TOTAL", falling);
    of_contact("motion.derivatives.TOTAL", in_motion);
    measure("estimate_friction", estimate, next_force, TRACED ? CASES : CASES / 10u + 1u);
    measure("fit_friction.50", fit_friction, next_curve, TRACED ? 2u : CASES / 1000u + 1u);
    of_contact("contact_from_hertz", hertz);
    of_contact("field.point.STRIP_1967", point_strip_1967);
    of_contact("field.point.STRIP", point_strip);
    of_contact("strips.STRIP_1967.16", strips_1967_16);
    of_contact("strips.STRIP.16", strips_16);
    of_wheel("prepare_profile", prepare_profile);
    of_wheel("touch", touch);
    of_wheel("contacts_from_gap", contacts_from_gap);
    of_wheel("wrench_from_contacts", wrench_from_contacts);
    of_wheel("wheel_on_rail", wheel_on_rail);
    of_wheel("wheel_on_rail.derivatives", wheel_on_rail_derivatives);
    of_wheel("wheel_on_rail.by_position", wheel_on_rail_by_position);
    of_wheel("height_for_load", height_for_load);
    return 0;
}
