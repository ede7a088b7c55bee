/* Prints the text of every status, and how every function answers bad input. */
#include "kstrip.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { POISON = 0xA5 };

static int poisoned(const void *memory, size_t size)
{
    const unsigned char *byte = memory;
    while (size--)
        if (*byte++ != POISON)
            return 0;
    return 1;
}

/* Poison an output, make a call, print its status, and whether the output is as it was. */
#define CASE(name, output, call)                                                                   \
    do {                                                                                           \
        memset(&(output), POISON, sizeof(output));                                                 \
        const kstrip_status status = (call);                                                       \
        printf("case %s %ld %s\n", name, (long)status,                                             \
               poisoned(&(output), sizeof(output)) ? "untouched" : "written");                     \
    } while (0)

/* One member of an input replaced by a bad value. */
#define WITH(type, variable, member, value)                                                        \
    type variable##_bad = variable;                                                                \
    variable##_bad.member = (value)

#define SOLVE_WITH(name, variable, type, member, value)                                            \
    do {                                                                                           \
        WITH(type, variable, member, value);                                                       \
        const type *const variable##_pointer = &variable##_bad;                                    \
        CASE(name, result, SOLVE_##variable(variable##_pointer));                                  \
    } while (0)
#define SOLVE_contact(pointer) kstrip_solve(pointer, &creepage, &options, &result)
#define SOLVE_creepage(pointer) kstrip_solve(&contact, pointer, &options, &result)
#define SOLVE_options(pointer) kstrip_solve(&contact, &creepage, pointer, &result)

static void texts(void)
{
    for (int status = -60; status <= 20; status++)
        printf("text %d %s\n", status, kstrip_status_string(status));
    printf("version %s abi %ld\n", kstrip_version_string(), (long)kstrip_abi_version());
}

static void preparation(void)
{
    const kstrip_material steel = {82e9, 0.28};
    const kstrip_combined_material pair = {82e9, 0.28, 0};
    const kstrip_radii radii = {INFINITY, 0.3, 0.46, INFINITY};
    const kstrip_velocity lower = {-10, 0, 0}, upper = {-9.99, 0.01, 0.5};
    const kstrip_contact contact = {6e-3, 4e-3, 80e3, 82e9, 0.28, 0.3};
    const kstrip_creepage creepage = {1e-3, 0, 0.1};
    const kstrip_parameters parameters = {0.1, 0.2, 0.3};
    kstrip_options options;
    kstrip_material material;
    kstrip_combined_material combined;
    kstrip_hertz_contact ellipse;
    kstrip_creepage motion;
    kstrip_parameters numbers;

    CASE("options.null", options, kstrip_options_init(NULL));
    CASE("options.ok", options, kstrip_options_init(&options));

    CASE("young.null", material, kstrip_material_from_youngs_modulus(210e9, 0.28, NULL));
    CASE("young.nan", material, kstrip_material_from_youngs_modulus(NAN, 0.28, &material));
    CASE("young.zero", material, kstrip_material_from_youngs_modulus(0, 0.28, &material));
    CASE("young.poisson", material, kstrip_material_from_youngs_modulus(210e9, 0.6, &material));
    CASE("young.ok", material, kstrip_material_from_youngs_modulus(210e9, 0.28, &material));

    CASE("combine.null_lower", combined, kstrip_material_combine(NULL, &steel, &combined));
    CASE("combine.null_upper", combined, kstrip_material_combine(&steel, NULL, &combined));
    CASE("combine.null_out", combined, kstrip_material_combine(&steel, &steel, NULL));
    {
        WITH(kstrip_material, steel, shear_modulus, -82e9);
        CASE("combine.modulus", combined, kstrip_material_combine(&steel, &steel_bad, &combined));
        steel_bad.shear_modulus = INFINITY;
        CASE("combine.infinite", combined, kstrip_material_combine(&steel_bad, &steel, &combined));
        steel_bad.shear_modulus = 82e9, steel_bad.poisson_ratio = -0.1;
        CASE("combine.poisson", combined, kstrip_material_combine(&steel_bad, &steel, &combined));
    }
    CASE("combine.ok", combined, kstrip_material_combine(&steel, &steel, &combined));

    CASE("hertz.null_radii", ellipse, kstrip_hertz(NULL, 80e3, &pair, &ellipse));
    CASE("hertz.null_material", ellipse, kstrip_hertz(&radii, 80e3, NULL, &ellipse));
    CASE("hertz.null_out", ellipse, kstrip_hertz(&radii, 80e3, &pair, NULL));
    CASE("hertz.negative_load", ellipse, kstrip_hertz(&radii, -1, &pair, &ellipse));
    CASE("hertz.nan_load", ellipse, kstrip_hertz(&radii, NAN, &pair, &ellipse));
    {
        WITH(kstrip_radii, radii, lower_y, 0);
        CASE("hertz.zero_radius", ellipse, kstrip_hertz(&radii_bad, 80e3, &pair, &ellipse));
        radii_bad.lower_y = INFINITY;
        CASE("hertz.flat", ellipse, kstrip_hertz(&radii_bad, 80e3, &pair, &ellipse));
        radii_bad.lower_y = -0.3;
        CASE("hertz.concave", ellipse, kstrip_hertz(&radii_bad, 80e3, &pair, &ellipse));
        WITH(kstrip_combined_material, pair, shear_modulus, 0);
        CASE("hertz.modulus", ellipse, kstrip_hertz(&radii, 80e3, &pair_bad, &ellipse));
    }
    CASE("hertz.ok", ellipse, kstrip_hertz(&radii, 80e3, &pair, &ellipse));

    CASE("velocities.null_lower", motion,
         kstrip_creepage_from_velocities(NULL, &upper, 10, &motion));
    CASE("velocities.null_upper", motion,
         kstrip_creepage_from_velocities(&lower, NULL, 10, &motion));
    CASE("velocities.null_out", motion, kstrip_creepage_from_velocities(&lower, &upper, 10, NULL));
    CASE("velocities.stand", motion, kstrip_creepage_from_velocities(&lower, &upper, 0, &motion));
    CASE("velocities.back", motion, kstrip_creepage_from_velocities(&lower, &upper, -10, &motion));
    CASE("velocities.nan", motion, kstrip_creepage_from_velocities(&lower, &upper, NAN, &motion));
    CASE("velocities.overflow", motion,
         kstrip_creepage_from_velocities(&lower, &upper, 1e-310, &motion));
    CASE("velocities.ok", motion, kstrip_creepage_from_velocities(&lower, &upper, 10, &motion));

    CASE("parameters.null", numbers, kstrip_parameters_from_creepage(NULL, &creepage, &numbers));
    CASE("parameters.null_out", numbers,
         kstrip_parameters_from_creepage(&contact, &creepage, NULL));
    CASE("parameters.ok", numbers, kstrip_parameters_from_creepage(&contact, &creepage, &numbers));
    CASE("creepage.null", motion, kstrip_creepage_from_parameters(&contact, NULL, &motion));
    CASE("creepage.null_out", motion, kstrip_creepage_from_parameters(&contact, &parameters, NULL));
    {
        WITH(kstrip_parameters, parameters, eta, NAN);
        CASE("creepage.nan", motion,
             kstrip_creepage_from_parameters(&contact, &parameters_bad, &motion));
    }
    CASE("creepage.ok", motion, kstrip_creepage_from_parameters(&contact, &parameters, &motion));
}

static void solution(void)
{
    const kstrip_contact contact = {6e-3, 4e-3, 80e3, 82e9, 0.28, 0.3};
    const kstrip_creepage creepage = {1e-3, 0, 0.1};
    const kstrip_options options = {KSTRIP_MODEL_STRIP_1967, 16};
    const kstrip_options total = {KSTRIP_MODEL_TOTAL, 16}, linear = {KSTRIP_MODEL_LINEAR, 16};
    const kstrip_creepage large = {1, 0, 0};
    const double x[2] = {0, 1e-3}, y[2] = {0, 1e-3}, bad[2] = {0, NAN};
    const kstrip_contact contacts[2] = {contact, {6e-3, 4e-3, -1, 82e9, 0.28, 0.3}};
    const kstrip_creepage motions[2] = {creepage, creepage};
    kstrip_result result, results[2];
    kstrip_strip strips[KSTRIP_STRIPS_CAPACITY];
    kstrip_point point, points[4];
    double jacobian[9];
    uint32_t count;

    CASE("solve.null_contact", result, kstrip_solve(NULL, &creepage, &options, &result));
    CASE("solve.null_creepage", result, kstrip_solve(&contact, NULL, &options, &result));
    CASE("solve.null_out", result, kstrip_solve(&contact, &creepage, &options, NULL));
    SOLVE_WITH("solve.a_zero", contact, kstrip_contact, a, 0);
    SOLVE_WITH("solve.a_nan", contact, kstrip_contact, a, NAN);
    SOLVE_WITH("solve.b_negative", contact, kstrip_contact, b, -4e-3);
    SOLVE_WITH("solve.b_infinite", contact, kstrip_contact, b, INFINITY);
    SOLVE_WITH("solve.load_negative", contact, kstrip_contact, normal_force, -1);
    SOLVE_WITH("solve.load_nan", contact, kstrip_contact, normal_force, NAN);
    SOLVE_WITH("solve.load_zero", contact, kstrip_contact, normal_force, 0);
    SOLVE_WITH("solve.load_huge", contact, kstrip_contact, normal_force, 1.7e308);
    SOLVE_WITH("solve.modulus_zero", contact, kstrip_contact, shear_modulus, 0);
    SOLVE_WITH("solve.modulus_nan", contact, kstrip_contact, shear_modulus, NAN);
    SOLVE_WITH("solve.poisson_negative", contact, kstrip_contact, poisson_ratio, -0.01);
    SOLVE_WITH("solve.poisson_large", contact, kstrip_contact, poisson_ratio, 0.51);
    SOLVE_WITH("solve.poisson_nan", contact, kstrip_contact, poisson_ratio, NAN);
    SOLVE_WITH("solve.friction_negative", contact, kstrip_contact, friction, -0.3);
    SOLVE_WITH("solve.friction_nan", contact, kstrip_contact, friction, NAN);
    SOLVE_WITH("solve.friction_zero", contact, kstrip_contact, friction, 0);
    SOLVE_WITH("solve.friction_huge", contact, kstrip_contact, friction, 1e307);
    SOLVE_WITH("solve.longitudinal_nan", creepage, kstrip_creepage, longitudinal, NAN);
    SOLVE_WITH("solve.lateral_infinite", creepage, kstrip_creepage, lateral, -INFINITY);
    SOLVE_WITH("solve.spin_nan", creepage, kstrip_creepage, spin, NAN);
    SOLVE_WITH("solve.spin_large", creepage, kstrip_creepage, spin, 10);
    SOLVE_WITH("solve.model_zero", options, kstrip_options, model, 0);
    SOLVE_WITH("solve.model_unknown", options, kstrip_options, model, 999);
    SOLVE_WITH("solve.strips_zero", options, kstrip_options, strips, 0);
    SOLVE_WITH("solve.strips_odd", options, kstrip_options, strips, 15);
    CASE("solve.linear_large", result, kstrip_solve(&contact, &large, &linear, &result));
    CASE("solve.default", result, kstrip_solve(&contact, &creepage, NULL, &result));
    CASE("solve.ok", result, kstrip_solve(&contact, &creepage, &options, &result));

    CASE("jacobian.null_entries", result,
         kstrip_solve_jacobian(&contact, &creepage, &options, &result, NULL));
    CASE("jacobian.null_result", jacobian,
         kstrip_solve_jacobian(&contact, &creepage, &options, NULL, jacobian));
    CASE("jacobian.bad", jacobian,
         kstrip_solve_jacobian(&contacts[1], &creepage, &options, &result, jacobian));
    CASE("jacobian.ok", jacobian,
         kstrip_solve_jacobian(&contact, &creepage, &options, &result, jacobian));

    CASE("batch.second_bad", results, kstrip_solve_batch(contacts, motions, 2, NULL, results));
    CASE("batch.null", results, kstrip_solve_batch(NULL, motions, 2, NULL, results));
    CASE("batch.null_out", results, kstrip_solve_batch(contacts, motions, 1, NULL, NULL));
    CASE("batch.empty", results, kstrip_solve_batch(NULL, NULL, 0, NULL, NULL));
    CASE("batch.ok", results[0], kstrip_solve_batch(contacts, motions, 1, NULL, results));

    CASE("strips.capacity", strips,
         kstrip_strips(&contact, &creepage, &options, strips, 3, &count));
    CASE("strips.capacity_count", count,
         kstrip_strips(&contact, &creepage, &options, strips, 3, &count));
    CASE("strips.null", count,
         kstrip_strips(&contact, &creepage, &options, NULL, KSTRIP_STRIPS_CAPACITY, &count));
    CASE("strips.null_count", strips,
         kstrip_strips(&contact, &creepage, &options, strips, KSTRIP_STRIPS_CAPACITY, NULL));
    CASE("strips.total", strips,
         kstrip_strips(&contact, &creepage, &total, strips, KSTRIP_STRIPS_CAPACITY, &count));
    CASE("strips.ok", count,
         kstrip_strips(&contact, &creepage, &options, strips, KSTRIP_STRIPS_CAPACITY, &count));

    CASE("point.null", point, kstrip_traction_at(&contact, &creepage, &options, 0, 0, NULL));
    CASE("point.nan", point, kstrip_traction_at(&contact, &creepage, &options, NAN, 0, &point));
    CASE("point.outside", point, kstrip_traction_at(&contact, &creepage, &options, 1, 1, &point));
    CASE("point.total", point, kstrip_traction_at(&contact, &creepage, &total, 0, 0, &point));
    CASE("point.ok", point, kstrip_traction_at(&contact, &creepage, &options, 0, 0, &point));

    CASE("field.capacity", points,
         kstrip_field(&contact, &creepage, &options, x, 2, y, 2, points, 3));
    CASE("field.null_x", points,
         kstrip_field(&contact, &creepage, &options, NULL, 2, y, 2, points, 4));
    CASE("field.null_out", points,
         kstrip_field(&contact, &creepage, &options, x, 2, y, 2, NULL, 4));
    CASE("field.nan", points, kstrip_field(&contact, &creepage, &options, x, 2, bad, 2, points, 4));
    CASE("field.total", points, kstrip_field(&contact, &creepage, &total, x, 2, y, 2, points, 4));
    CASE("field.linear", points, kstrip_field(&contact, &creepage, &linear, x, 2, y, 2, points, 4));
    CASE("field.ok", points, kstrip_field(&contact, &creepage, &options, x, 2, y, 2, points, 4));

    CASE("upper.null", result, kstrip_result_on_upper_body(NULL, &result));
    CASE("upper.null_out", result, kstrip_result_on_upper_body(&results[0], NULL));
}

static void more_derivatives(void)
{
    const kstrip_contact contact = {6e-3, 4e-3, 80e3, 82e9, 0.28, 0.3};
    const kstrip_creepage creepage = {1e-3, 0, 0.1};
    const kstrip_contact contacts[2] = {contact, {6e-3, 4e-3, -1, 82e9, 0.28, 0.3}};
    const kstrip_creepage motions[2] = {creepage, creepage};
    kstrip_derivatives slopes;
    kstrip_result result, results[2];
    double jacobians[18];

    CASE("derivatives.null", result,
         kstrip_solve_derivatives(&contact, &creepage, NULL, &result, NULL));
    CASE("derivatives.null_result", slopes,
         kstrip_solve_derivatives(&contact, &creepage, NULL, NULL, &slopes));
    CASE("derivatives.bad", slopes,
         kstrip_solve_derivatives(&contacts[1], &creepage, NULL, &result, &slopes));
    CASE("derivatives.ok", slopes,
         kstrip_solve_derivatives(&contact, &creepage, NULL, &result, &slopes));
    CASE("jacobians.second_bad", jacobians,
         kstrip_solve_jacobian_batch(contacts, motions, 2, NULL, results, jacobians));
    CASE("jacobians.second_bad_results", results,
         kstrip_solve_jacobian_batch(contacts, motions, 2, NULL, results, jacobians));
    CASE("jacobians.null", results,
         kstrip_solve_jacobian_batch(contacts, motions, 1, NULL, results, NULL));
    CASE("jacobians.null_results", jacobians,
         kstrip_solve_jacobian_batch(contacts, motions, 1, NULL, NULL, jacobians));
    CASE("jacobians.ok", jacobians,
         kstrip_solve_jacobian_batch(contacts, motions, 1, NULL, results, jacobians));
}

static void friction_laws(void)
{
    const kstrip_contact contact = {6e-3, 4e-3, 80e3, 82e9, 0.28, NAN}; /* friction is ignored */
    const kstrip_creepage creepage = {1e-3, 0, 0.1};
    const kstrip_friction friction = {0.55, 0.4, 0.6, 20, 1}, constant = {0.3, 1, 0, 0, 1};
    kstrip_result result;
    double jacobian[9], mu;

    CASE("friction.null", result,
         kstrip_solve_friction(&contact, &creepage, NULL, NULL, &result, NULL));
    CASE("friction.null_out", mu,
         kstrip_solve_friction(&contact, &creepage, &friction, NULL, NULL, &mu));
    CASE("friction.null_entries", result,
         kstrip_solve_friction_jacobian(&contact, &creepage, &friction, NULL, &result, NULL, &mu));
    {
        WITH(kstrip_friction, friction, ratio, 2);
        CASE("friction.ratio", result,
             kstrip_solve_friction(&contact, &creepage, &friction_bad, NULL, &result, &mu));
        friction_bad.ratio = 0.4, friction_bad.decay = -1;
        CASE("friction.decay", mu,
             kstrip_solve_friction(&contact, &creepage, &friction_bad, NULL, &result, &mu));
        friction_bad.decay = 1, friction_bad.rolling_speed = -1;
        CASE("friction.speed", jacobian,
             kstrip_solve_friction_jacobian(&contact, &creepage, &friction_bad, NULL, &result,
                                            jacobian, &mu));
        friction_bad.rolling_speed = 1, friction_bad.slope_factor = 0;
        CASE("friction.slope", result,
             kstrip_solve_friction(&contact, &creepage, &friction_bad, NULL, &result, &mu));
    }
    CASE("friction.constant", result,
         kstrip_solve_friction(&contact, &creepage, &constant, NULL, &result, NULL));
    CASE("friction.ok", mu,
         kstrip_solve_friction(&contact, &creepage, &friction, NULL, &result, &mu));
    CASE("friction.jacobian", jacobian,
         kstrip_solve_friction_jacobian(&contact, &creepage, &friction, NULL, &result, jacobian,
                                        NULL));
}

static void rig(void)
{
    const kstrip_contact contact = {6e-3, 4e-3, 80e3, 82e9, 0.28, 0.3};
    const kstrip_creepage creepage = {2e-3, 0, 0.1};
    const kstrip_options linear = {KSTRIP_MODEL_LINEAR, 16};
    kstrip_friction_estimate estimate;
    kstrip_creepage motion;

    CASE("estimate.null", estimate,
         kstrip_estimate_friction(NULL, &creepage, NULL, 1, 1e4, 0, &estimate));
    CASE("estimate.measured", estimate,
         kstrip_estimate_friction(&contact, &creepage, NULL, 4, 1e4, 0, &estimate));
    CASE("estimate.linear", estimate,
         kstrip_estimate_friction(&contact, &creepage, &linear, KSTRIP_MEASURED_FX, 1e4, 0, &estimate));
    CASE("estimate.against", estimate,
         kstrip_estimate_friction(&contact, &creepage, NULL, KSTRIP_MEASURED_FX, -1e4, 0, &estimate));
    CASE("estimate.sticks", estimate,
         kstrip_estimate_friction(&contact, &creepage, NULL, KSTRIP_MEASURED_FX, 1e8, 0, &estimate));
    CASE("estimate.ok", estimate,
         kstrip_estimate_friction(&contact, &creepage, NULL, KSTRIP_MEASURED_FX, 1e4, 0, &estimate));
    CASE("inverse.null", motion, kstrip_creepage_for_force(NULL, 1e4, 0, 0, NULL, &motion));
    CASE("inverse.nan", motion, kstrip_creepage_for_force(&contact, NAN, 0, 0, NULL, &motion));
    CASE("inverse.beyond", motion, kstrip_creepage_for_force(&contact, 1e5, 0, 0, NULL, &motion));
    CASE("inverse.sliding", motion, kstrip_creepage_for_force(&contact, 24e3, 0, 0, NULL, &motion));
    CASE("inverse.ok", motion, kstrip_creepage_for_force(&contact, 1e4, 0, 0, NULL, &motion));
}

static void patches(void)
{
    enum { N = 5 };
    const kstrip_contact contact = {6e-3, 4e-3, 80e3, 82e9, 0.28, 0.3};
    const kstrip_creepage creepage = {1e-3, 0, 0.1}, nan = {NAN, 0, 0};
    const kstrip_options total = {KSTRIP_MODEL_TOTAL, 16}, unknown = {77, 16};
    const kstrip_patch_strip strip = {0, 1e-3, 5e-3, 0, 1e9, 0.3}, next = {1e-3, 1e-3, 5e-3, 0, 1e9, 0.3};
    const kstrip_patch_strip pair[2] = {strip, next}, back[2] = {next, strip}, same[2] = {strip, strip};
    const double y[N] = {-0.02, -0.01, 0, 0.01, 0.02}, z[N] = {4e-4, 1e-4, 0, 1e-4, 4e-4};
    const double rise[N] = {0, 1e-4, 2e-4, 3e-4, 4e-4}, hole[N] = {4e-4, NAN, 0, 1e-4, 4e-4};
    const kstrip_profile_contact wheel = {0.46, 80e3, 82e9, 0.28, 0.3};
    const double x[2] = {0, 1e-3};
    static kstrip_patch_strip many[KSTRIP_PATCH_CAPACITY + 1];
    static kstrip_patch patch, good, bad;
    kstrip_profile_result found;
    kstrip_patch_summary sums;
    kstrip_result result;
    kstrip_strip strips[KSTRIP_PATCH_CAPACITY];
    kstrip_point point, points[4];
    double jacobian[9];
    uint32_t count;

    CASE("ellipse.null", patch, kstrip_patch_from_ellipse(NULL, 16, &patch));
    CASE("ellipse.null_out", patch, kstrip_patch_from_ellipse(&contact, 16, NULL));
    CASE("ellipse.strips", patch, kstrip_patch_from_ellipse(&contact, 17, &patch));
    {
        WITH(kstrip_contact, contact, a, -1);
        CASE("ellipse.bad", patch, kstrip_patch_from_ellipse(&contact_bad, 16, &patch));
    }
    CASE("ellipse.ok", good, kstrip_patch_from_ellipse(&contact, 64, &good));

    CASE("given.null", patch, kstrip_patch_from_strips(NULL, 2, 82e9, 0.28, &patch));
    CASE("given.null_out", patch, kstrip_patch_from_strips(pair, 2, 82e9, 0.28, NULL));
    CASE("given.many", patch,
         kstrip_patch_from_strips(many, KSTRIP_PATCH_CAPACITY + 1, 82e9, 0.28, &patch));
    CASE("given.zero_width", patch, kstrip_patch_from_strips(many, 1, 82e9, 0.28, &patch));
    CASE("given.overlap", patch, kstrip_patch_from_strips(same, 2, 82e9, 0.28, &patch));
    CASE("given.modulus", patch, kstrip_patch_from_strips(pair, 2, 0, 0.28, &patch));
    CASE("given.poisson", patch, kstrip_patch_from_strips(pair, 2, 82e9, 0.7, &patch));
    {
        WITH(kstrip_patch_strip, strip, peak_pressure, -1);
        CASE("given.pressure", patch, kstrip_patch_from_strips(&strip_bad, 1, 82e9, 0.28, &patch));
        strip_bad.peak_pressure = 1e9, strip_bad.friction = -0.1;
        CASE("given.friction", patch, kstrip_patch_from_strips(&strip_bad, 1, 82e9, 0.28, &patch));
        strip_bad.friction = NAN;
        CASE("given.nan", patch, kstrip_patch_from_strips(&strip_bad, 1, 82e9, 0.28, &patch));
    }
    CASE("given.empty", patch, kstrip_patch_from_strips(NULL, 0, 82e9, 0.28, &patch));
    CASE("given.ok", patch, kstrip_patch_from_strips(pair, 2, 82e9, 0.28, &patch));
    CASE("given.unsorted", patch, kstrip_patch_from_strips(back, 2, 82e9, 0.28, &patch));

    CASE("profile.null", patch, kstrip_patch_from_profile(NULL, z, N, &wheel, 16, &patch, &found));
    CASE("profile.null_contact", patch,
         kstrip_patch_from_profile(y, z, N, NULL, 16, &patch, &found));
    CASE("profile.null_out", found, kstrip_patch_from_profile(y, z, N, &wheel, 16, NULL, &found));
    CASE("profile.null_result", patch,
         kstrip_patch_from_profile(y, z, N, &wheel, 16, &patch, NULL));
    CASE("profile.strips", patch, kstrip_patch_from_profile(y, z, N, &wheel, 5, &patch, &found));
    CASE("profile.few", patch, kstrip_patch_from_profile(y, z, 2, &wheel, 16, &patch, &found));
    CASE("profile.order", patch, kstrip_patch_from_profile(z, z, N, &wheel, 16, &patch, &found));
    CASE("profile.nan", patch, kstrip_patch_from_profile(y, hole, N, &wheel, 16, &patch, &found));
    CASE("profile.end", found, kstrip_patch_from_profile(y, rise, N, &wheel, 16, &patch, &found));
    {
        WITH(kstrip_profile_contact, wheel, rolling_radius, 0);
        CASE("profile.radius", found,
             kstrip_patch_from_profile(y, z, N, &wheel_bad, 16, &patch, &found));
        wheel_bad.rolling_radius = 0.46, wheel_bad.normal_force = -1;
        CASE("profile.load", found,
             kstrip_patch_from_profile(y, z, N, &wheel_bad, 16, &patch, &found));
        wheel_bad.normal_force = 1e9;
        CASE("profile.heavy", found,
             kstrip_patch_from_profile(y, z, N, &wheel_bad, 16, &patch, &found));
    }
    CASE("profile.ok", patch, kstrip_patch_from_profile(y, z, N, &wheel, 16, &patch, &found));
    CASE("profile.ok_result", found, kstrip_patch_from_profile(y, z, N, &wheel, 16, &patch, &found));

    kstrip_patch_from_ellipse(&contact, 64, &good);
    CASE("summary.null", sums, kstrip_patch_summarize(NULL, &sums));
    CASE("summary.null_out", sums, kstrip_patch_summarize(&good, NULL));
    CASE("summary.ok", sums, kstrip_patch_summarize(&good, &sums));
    bad = good, bad.count = KSTRIP_PATCH_CAPACITY + 1;
    CASE("summary.count", sums, kstrip_patch_summarize(&bad, &sums));
    bad = good, bad.strips[3] = bad.strips[2];
    CASE("summary.order", sums, kstrip_patch_summarize(&bad, &sums));
    bad = good, bad.area_scale = 0;
    CASE("summary.scale", sums, kstrip_patch_summarize(&bad, &sums));

    bad = good, bad.strips[5].half_length = 0;
    CASE("patch.null", result, kstrip_patch_solve(NULL, &creepage, NULL, &result));
    CASE("patch.null_creepage", result, kstrip_patch_solve(&good, NULL, NULL, &result));
    CASE("patch.null_out", result, kstrip_patch_solve(&good, &creepage, NULL, NULL));
    CASE("patch.bad", result, kstrip_patch_solve(&bad, &creepage, NULL, &result));
    CASE("patch.nan", result, kstrip_patch_solve(&good, &nan, NULL, &result));
    CASE("patch.total", result, kstrip_patch_solve(&good, &creepage, &total, &result));
    CASE("patch.unknown", result, kstrip_patch_solve(&good, &creepage, &unknown, &result));
    CASE("patch.ok", result, kstrip_patch_solve(&good, &creepage, NULL, &result));
    CASE("patch_jacobian.null", result,
         kstrip_patch_jacobian(&good, &creepage, NULL, &result, NULL));
    CASE("patch_jacobian.bad", jacobian,
         kstrip_patch_jacobian(&bad, &creepage, NULL, &result, jacobian));
    CASE("patch_jacobian.ok", jacobian,
         kstrip_patch_jacobian(&good, &creepage, NULL, &result, jacobian));
    CASE("patch_strips.capacity", strips,
         kstrip_patch_strips(&good, &creepage, NULL, strips, 63, &count));
    CASE("patch_strips.null_count", strips,
         kstrip_patch_strips(&good, &creepage, NULL, strips, 64, NULL));
    CASE("patch_strips.total", count,
         kstrip_patch_strips(&good, &creepage, &total, strips, 64, &count));
    CASE("patch_strips.ok", count,
         kstrip_patch_strips(&good, &creepage, NULL, strips, 64, &count));
    CASE("patch_point.nan", point,
         kstrip_patch_traction_at(&good, &creepage, NULL, 0, NAN, &point));
    CASE("patch_point.null", point, kstrip_patch_traction_at(&good, &creepage, NULL, 0, 0, NULL));
    CASE("patch_point.ok", point, kstrip_patch_traction_at(&good, &creepage, NULL, 0, 0, &point));
    CASE("patch_field.capacity", points,
         kstrip_patch_field(&good, &creepage, NULL, x, 2, x, 2, points, 3));
    CASE("patch_field.null", points,
         kstrip_patch_field(&good, &creepage, NULL, NULL, 2, x, 2, points, 4));
    CASE("patch_field.ok", points,
         kstrip_patch_field(&good, &creepage, NULL, x, 2, x, 2, points, 4));
}

static void evaluation(void)
{
    const kstrip_contact contact = {6e-3, 4e-3, 80e3, 82e9, 0.28, 0.3};
    const kstrip_creepage creepage = {2e-3, 0, 0.1};
    const kstrip_options total = {KSTRIP_MODEL_TOTAL, 16};
    const uint32_t all = KSTRIP_WANT_FORCES | KSTRIP_WANT_MOMENT | KSTRIP_WANT_ADHESION |
                         KSTRIP_WANT_JACOBIAN | KSTRIP_WANT_STRIPS;
    kstrip_result result;
    kstrip_strip strips[16];
    double jacobian[9];
    uint32_t count;

    CASE("evaluate.null", jacobian,
         kstrip_evaluate(&contact, &creepage, NULL, all, NULL, jacobian, strips, 16, &count));
    CASE("evaluate.flag", result,
         kstrip_evaluate(&contact, &creepage, NULL, 32, &result, NULL, NULL, 0, NULL));
    CASE("evaluate.null_jacobian", result,
         kstrip_evaluate(&contact, &creepage, NULL, all, &result, NULL, strips, 16, &count));
    CASE("evaluate.null_count", jacobian,
         kstrip_evaluate(&contact, &creepage, NULL, all, &result, jacobian, strips, 16, NULL));
    CASE("evaluate.capacity", jacobian,
         kstrip_evaluate(&contact, &creepage, NULL, all, &result, jacobian, strips, 15, &count));
    CASE("evaluate.total", result,
         kstrip_evaluate(&contact, &creepage, &total, all, &result, jacobian, strips, 16, &count));
    CASE("evaluate.forces", result,
         kstrip_evaluate(&contact, &creepage, NULL, KSTRIP_WANT_FORCES, &result, NULL, NULL, 0, NULL));
    CASE("evaluate.all", strips,
         kstrip_evaluate(&contact, &creepage, NULL, all, &result, jacobian, strips, 16, &count));
}

/* Single precision shares the checks; a sample of each kind. */
static void single_precision(void)
{
    const kstrip_contact_f32 contact = {6e-3F, 4e-3F, 80e3F, 82e9F, 0.28F, 0.3F};
    const kstrip_contact_f32 bad = {6e-3F, 4e-3F, 80e3F, 82e9F, 0.28F, -0.3F};
    const kstrip_creepage_f32 creepage = {1e-3F, 0, 0.1F}, nan = {NAN, 0, 0};
    const float x[2] = {0, 1e-3F};
    const kstrip_creepage_f32 large = {1, 0, 0};
    const kstrip_options total = {KSTRIP_MODEL_TOTAL, 16}, linear = {KSTRIP_MODEL_LINEAR, 16};
    kstrip_result_f32 result;
    kstrip_point_f32 points[2];
    float jacobian[9];

    CASE("f32.solve.null", result, kstrip_solve_f32(NULL, &creepage, NULL, &result));
    CASE("f32.solve.nan", result, kstrip_solve_f32(&contact, &nan, NULL, &result));
    CASE("f32.solve.friction", result, kstrip_solve_f32(&bad, &creepage, NULL, &result));
    CASE("f32.solve.linear_large", result, kstrip_solve_f32(&contact, &large, &linear, &result));
    CASE("f32.solve.ok", result, kstrip_solve_f32(&contact, &creepage, NULL, &result));
    CASE("f32.jacobian.bad", jacobian,
         kstrip_solve_jacobian_f32(&bad, &creepage, NULL, &result, jacobian));
    static kstrip_patch_f32 patch;
    CASE("f32.ellipse.bad", patch, kstrip_patch_from_ellipse_f32(&bad, 16, &patch));
    CASE("f32.ellipse.ok", patch, kstrip_patch_from_ellipse_f32(&contact, 16, &patch));
    CASE("f32.patch.nan", result, kstrip_patch_solve_f32(&patch, &nan, NULL, &result));
    CASE("f32.patch.total", result, kstrip_patch_solve_f32(&patch, &creepage, &total, &result));
    CASE("f32.field.capacity", points,
         kstrip_field_f32(&contact, &creepage, NULL, x, 2, x, 2, points, 2));
    CASE("f32.field.total", points,
         kstrip_field_f32(&contact, &creepage, &total, x, 2, x, 1, points, 2));
}

int main(void)
{
    texts();
    preparation();
    solution();
    more_derivatives();
    friction_laws();
    rig();
    evaluation();
    patches();
    single_precision();
    return 0;
}
