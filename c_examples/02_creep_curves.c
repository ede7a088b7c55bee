/*
 * Creep curves of every model as CSV on standard output: force against creepage, for a plot.
 *
 *   cc -std=c99 -Iinclude c_examples/02_creep_curves.c target/lib/libkstrip.a -o creep_curves
 *   ./creep_curves > creep_curves.csv
 */
#include "kstrip.h"
#include <stdio.h>
#include <stdlib.h>

/* One line per model. */
static const struct {
    const char *name;
    int32_t number;
} models[] = {
    {"strip_1967", KSTRIP_MODEL_STRIP_1967},
    {"strip_1967_continuous", KSTRIP_MODEL_STRIP_1967_CONTINUOUS},
    {"strip", KSTRIP_MODEL_STRIP},
    {"total", KSTRIP_MODEL_TOTAL},
    {"linear", KSTRIP_MODEL_LINEAR},
};

/* One line per curve: the motion of size 1, and a constant motion that is added to it. */
static const struct {
    const char *name;
    kstrip_creepage direction, constant; /* longitudinal [-], lateral [-], spin [1/m] */
} curves[] = {
    {"longitudinal", {1, 0, 0}, {0, 0, 0}},
    {"lateral", {0, 1, 0}, {0, 0, 0}},
    {"spin", {0, 0, 100}, {0, 0, 0}},
    {"longitudinal_with_spin", {1, 0, 0}, {0, 0, 0.5}},
    {"lateral_with_spin", {0, 1, 0}, {0, 0, 0.5}},
};

/* Creepages [-], from the linear range to full sliding; times 100 the spins [1/m]. */
static const double sizes[] = {0,      1e-6,   1e-5,   0.0001, 0.0002, 0.0005, 0.001,  0.0015,
                               0.002,  0.0025, 0.003,  0.004,  0.005,  0.006,  0.007,  0.008,
                               0.009,  0.01,   0.0125, 0.015,  0.02,   0.03,   0.05,   0.1};

static void check(kstrip_status status)
{
    if (status >= 0) /* a warning: the result is valid, and the last column tells */
        return;
    fprintf(stderr, "kstrip: %s\n", kstrip_status_string(status));
    exit(EXIT_FAILURE);
}

#define COUNT(array) (sizeof(array) / sizeof *(array))

int main(void)
{
    /* Semi-axes along and across the rolling direction [m], load [N], shear modulus [Pa],
       Poisson's ratio, friction. */
    const kstrip_contact contact = {6e-3, 4.5e-3, 80e3, 82e9, 0.28, 0.3, 0};
    kstrip_options options;
    check(kstrip_options_init(&options));

    printf("model,number,curve,longitudinal,lateral,spin_1_per_m,fx_N,fy_N,mz_N_m,power_N,stick,"
           "status\n");
    for (size_t m = 0; m < COUNT(models); m++) {
        options.model = models[m].number;
        for (size_t c = 0; c < COUNT(curves); c++) {
            const kstrip_creepage d = curves[c].direction, k = curves[c].constant;
            for (size_t i = 0; i < COUNT(sizes); i++) {
                const kstrip_creepage motion = {d.longitudinal * sizes[i] + k.longitudinal,
                                                d.lateral * sizes[i] + k.lateral,
                                                d.spin * sizes[i] + k.spin};
                kstrip_result f; /* forces on the lower body */
                check(kstrip_solve(&contact, &motion, &options, &f));
                printf("%s,%d,%s,%.10g,%.10g,%.10g,%.10g,%.10g,%.10g,%.10g,%.10g,%d\n",
                       models[m].name, (int)models[m].number, curves[c].name, motion.longitudinal,
                       motion.lateral, motion.spin, f.fx, f.fy, f.mz, f.power, f.adhesion,
                       (int)f.status_detail);
            }
        }
    }
    return EXIT_SUCCESS;
}
