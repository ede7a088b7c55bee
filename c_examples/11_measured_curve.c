/*
 * From measured points to a law of friction: a locomotive's creep curve on a wet rail. The law is fitted, its parameters are printed with
 * their standard errors, then the curves as columns: measured points; clean bodies, the fitted law, and what CONTACT computes with an
 * elastic layer and falling friction. Forces are divided by the load.
 *   cc -std=c99 -Iinclude c_examples/11_measured_curve.c target/lib/libkstrip.a -lm -o measured_curve && ./measured_curve tests/data
 * The points: Engel, Beck, Alders 1998, as CONTACT's user guide shows them; CONTACT's curve: its example tractcurv (tests/data/README.md).
 */
#include "kstrip.h"
#include <stdio.h>
#include <stdlib.h>

enum { MOST = 200 };
/* Semi-axes [m], load [N], shear modulus [Pa], Poisson's ratio, friction of the clean curve */
static const kstrip_contact contact = {6.304e-3, 12.61e-3, 106.7e3, 82e9, 0.28, 0.33, 0};
static const kstrip_options model = {KSTRIP_MODEL_TOTAL, 0};

static void check(kstrip_status status)
{
    if (status < 0) fprintf(stderr, "%s\n", kstrip_status_string(status)), exit(EXIT_FAILURE);
}

static FILE *open_in(const char *folder, const char *name)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "r");
    if (file == NULL) perror(path), exit(EXIT_FAILURE);
    return file;
}

/* Lines of creepage in per cent and force over load. */
static uint32_t read_points(const char *folder, kstrip_measured_force points[MOST])
{
    char line[256];
    double per_cent, share;
    uint32_t count = 0;
    FILE *file = open_in(folder, "eurosprinter_measured.csv");
    while (count < MOST && fgets(line, sizeof line, file) != NULL)
        if (sscanf(line, "%lf,%lf", &per_cent, &share) == 2)
            points[count++] = (kstrip_measured_force){.longitudinal = per_cent / 100, .fx = share * contact.normal_force,
                                                      .weight = 1, .measured = KSTRIP_MEASURED_FX};
    fclose(file);
    return count;
}

static double force(double creepage, const kstrip_friction *law)
{
    const kstrip_creepage c = {creepage, 0, 0};
    kstrip_result result;
    const kstrip_outputs outputs = {.result = &result};
    check(kstrip_evaluate(&contact, &c, law, &model, &outputs));
    return result.fx / contact.normal_force;
}

int main(int count, char **words)
{
    const char *folder = count > 1 ? words[1] : "tests/data";
    kstrip_measured_force points[MOST];
    kstrip_friction_fit fit;
    const uint32_t measured = read_points(folder, points);

    /* Only the rolling speed stays: zero means a usual start. A layer would be nearly the same as a slope factor. */
    const kstrip_friction start = {.rolling_speed = 10};
    const uint32_t parameters = KSTRIP_FIT_FRICTION | KSTRIP_FIT_RATIO | KSTRIP_FIT_DECAY | KSTRIP_FIT_SLOPE_FACTOR | KSTRIP_FIT_SLIDE_FACTOR;
    uint32_t bad = measured;
    const kstrip_status status = kstrip_fit_friction(&contact, points, measured, &start, parameters, &model, &fit, &bad);
    if (status < 0 && bad < measured) fprintf(stderr, "point %u: ", (unsigned)bad);
    check(status);

    const kstrip_friction *law = &fit.law, *error = &fit.standard_errors;
    printf("%u points, %u steps: %s\n", (unsigned)measured, (unsigned)fit.steps, kstrip_status_string(status));
    printf("friction      %.4f +- %.4f\n", law->friction, error->friction);
    printf("ratio         %.4f +- %.4f\n", law->ratio, error->ratio);
    printf("decay         %.4f +- %.4f s/m\n", law->decay, error->decay);
    printf("slope factor  %.4f +- %.4f\n", law->slope_factor, error->slope_factor);
    printf("slide factor  %.4f +- %.4f\n", law->slide_factor, error->slide_factor);
    printf("rms           %.5f of the load\n", fit.residual / contact.normal_force);

    printf("\nmeasured: creepage_percent, measured, fitted\n");
    for (uint32_t i = 0; i < measured; i++)
        printf("%.4f,%.4f,%.5f\n", 100 * points[i].longitudinal, points[i].fx / contact.normal_force, force(points[i].longitudinal, law));

    printf("\ncurves: creepage_percent, clean, fitted, contact\n");
    char line[256];
    double creepage, newton;
    FILE *file = open_in(folder, "traction_curves.csv");
    while (fgets(line, sizeof line, file) != NULL)
        if (sscanf(line, "contact_layer_falling,%lf,%lf", &creepage, &newton) == 2)
            printf("%.4f,%.5f,%.5f,%.5f\n", 100 * creepage, force(creepage, NULL), force(creepage, law), newton / contact.normal_force);
    fclose(file);
    return 0;
}
