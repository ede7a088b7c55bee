/* A library with the model TOTAL alone: what was left out is KSTRIP_ERROR_MODEL_LEFT_OUT, and touches no output. */
#include <stdio.h>

#include "kstrip_f32.h"

static int failures;

static void expect(const char *what, int found, int wanted)
{
    if (found != wanted) {
        printf("%s: %d for %d\n", what, found, wanted);
        ++failures;
    }
}

int main(void)
{
    const kstrip_contact_f32 contact = {.a = 6e-3f, .b = 4e-3f, .normal_force = 80e3f, .shear_modulus = 82e9f,
                                        .poisson_ratio = 0.28f, .friction = 0.3f};
    const kstrip_creepage_f32 creepage = {.longitudinal = 1e-3f};
    const kstrip_friction_f32 law = {.friction = 0.3f, .ratio = 0.4f, .decay = 0.6f, .rolling_speed = 20.0f};
    const int models[] = {KSTRIP_MODEL_STRIP_1967, KSTRIP_MODEL_STRIP_1967_CONTINUOUS, KSTRIP_MODEL_STRIP,
                          KSTRIP_MODEL_LINEAR};
    kstrip_result_f32 result = {.fx = -1.0f};
    kstrip_derivatives_f32 derivatives;
    kstrip_strip_f32 strips[64];
    uint32_t count = 77;
    const kstrip_outputs_f32 outputs = {.result = &result, .derivatives = &derivatives};
    const kstrip_outputs_f32 of_strips = {.strips = strips, .capacity = 64, .count = &count};
    for (unsigned i = 0; i < sizeof models / sizeof *models; ++i) {
        const kstrip_options options = {models[i], 16};
        expect("solve", kstrip_solve_f32(&contact, &creepage, &options, &result), KSTRIP_ERROR_MODEL_LEFT_OUT);
        expect("evaluate", kstrip_evaluate_f32(&contact, &creepage, NULL, &options, &outputs), KSTRIP_ERROR_MODEL_LEFT_OUT);
    }
    expect("law", kstrip_evaluate_f32(&contact, &creepage, &law, NULL, &outputs), KSTRIP_ERROR_MODEL_LEFT_OUT);
    expect("strips", kstrip_evaluate_f32(&contact, &creepage, NULL, NULL, &of_strips) < 0, 1);
    expect("outputs", result.fx == -1.0f && count == 77, 1);
    expect("total", kstrip_evaluate_f32(&contact, &creepage, NULL, NULL, &outputs), KSTRIP_OK);
    expect("force", result.fx > 0.0f && result.fx < 24e3f, 1);
    return failures;
}
