/*
 * A worn wheel on a worn rail touch in two zones: the patch from the distance of the profiles (Kik and
 * Piotrowski), its forces on clean and on half-greasy rails, and maps of traction and of stick and slip.
 *
 *   cc -std=c99 -Iinclude c_examples/06_worn_profile.c target/lib/libkstrip.a -lm -o worn
 */
#include "kstrip.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { POINTS = 241, COLUMNS = 45 };

static kstrip_patch clean, greasy;

static void check(kstrip_status status)
{
    if (status != KSTRIP_OK)
        fprintf(stderr, "kstrip: %s\n", kstrip_status_string(status));
    if (status < 0)
        exit(EXIT_FAILURE);
}

int main(void)
{
    /* Distance of the undeformed profiles [m]: two bottoms 9 mm apart, the right one 6 um higher */
    double y[POINTS], distance[POINTS], across[COLUMNS];
    for (int i = 0; i < POINTS; i++) {
        y[i] = 0.1e-3 * (i - POINTS / 2);
        const double s = y[i] / 4.5e-3, w = s * s - 1;
        distance[i] = 70e-6 * w * w + 3e-6 * s;
    }
    const kstrip_profile_contact wheel = {.rolling_radius = 0.46, .normal_force = 80e3, .shear_modulus = 82e9,
                                          .poisson_ratio = 0.28, .friction = 0.35, .strips = 32};
    kstrip_profile_result found;
    kstrip_patch_summary sums;
    check(kstrip_patch_from_profile(y, distance, POINTS, &wheel, &clean, &found));
    check(kstrip_patch_summarize(&clean, &sums));
    printf("approach %.4f um, peak pressure %.3f MPa at y = %.4f mm, load %.4f N\n",
           found.approach * 1e6, found.peak_pressure / 1e6, found.deepest_y * 1e3,
           found.normal_force);
    printf("%u strips in %u zones, area %.4f mm2\n\n", (unsigned)clean.count, (unsigned)sums.lobes,
           sums.area * 1e6);

    /* Grease on the right-hand zone: friction is a number of each strip */
    greasy = clean;
    for (uint32_t i = 0; i < greasy.count; i++)
        greasy.strips[i].friction = greasy.strips[i].y > 0 ? 0.05 : 0.35;

    printf("long. [%%]  lat. [%%]  spin [1/m]      Fx [N]      Fy [N]   Mz [N m]  stick [%%]\n");
    static const kstrip_creepage motions[] = {
        {5e-4, 0, 0}, {2e-3, 0, 0}, {0, 2e-3, 0}, {1e-3, 5e-4, 0.3}, {0, 0, 0.5}, {1, 0, 0}};
    for (unsigned i = 0; i < sizeof motions / sizeof motions[0]; i++) {
        const kstrip_creepage m = motions[i];
        for (int k = 0; k < 2; k++) {
            kstrip_result f;
            const kstrip_outputs outputs = {.result = &f};
            check(kstrip_patch_evaluate(k ? &greasy : &clean, &m, NULL, NULL, &outputs));
            printf("%9.3f %9.3f %11.3f %11.3f %11.3f %10.4f %10.4f  %s\n", m.longitudinal * 100,
                   m.lateral * 100, m.spin, f.fx, f.fy, f.mz, f.adhesion * 100,
                   k ? "greasy" : "clean");
        }
    }

    /* Leading edge on top. Left digits: traction in tenths of the largest bound; right: # stick, . slip */
    for (int j = 0; j < COLUMNS; j++)
        across[j] = 0.4e-3 * (j - COLUMNS / 2);
    for (int i = 10; i >= -10; i--) {
        const double x = 0.9e-3 * i;
        kstrip_point row[COLUMNS];
        char digits[COLUMNS + 1] = "", states[COLUMNS + 1] = "";
        check(kstrip_patch_field(&greasy, &motions[3], NULL, &x, 1, across, COLUMNS, row, COLUMNS));
        for (int j = 0; j < COLUMNS; j++) {
            const double t = hypot(row[j].traction_x, row[j].traction_y);
            digits[j] = row[j].state ? '0' + (int)(9.999 * t / (0.35 * found.peak_pressure)) : ' ';
            states[j] = " #.."[row[j].state];
        }
        printf("  |%s|%s|\n", digits, states);
    }
    return EXIT_SUCCESS;
}
