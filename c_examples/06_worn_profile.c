/*
 * A wheel on a rail as the standards draw them: the patch from their distance, its approach and pressure under a load,
 * how both move with the lateral shift of the wheel, and forces on a clean and on a half-greasy rail.
 *
 * Wheel: S1002, the polynomials of EN 13715. Rail: 60E1 (UIC60), the arcs of EN 13674-1 (radii 300, 80 and 13 mm), leaning
 * inwards by 1:40. Running circle 750 mm from the middle of the track, gauge 1435 mm, 14 mm below the top of the rail.
 *
 *   cc -std=c99 -Iinclude c_examples/06_worn_profile.c target/lib/libkstrip.a -lm -o worn
 */
#include "kstrip.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { POINTS = 1001 };

static kstrip_patch clean, greasy;

static void check(kstrip_status status)
{
    if (status != KSTRIP_OK)
        fprintf(stderr, "kstrip: %s\n", kstrip_status_string(status));
    if (status < 0)
        exit(EXIT_FAILURE);
}

/* How much larger the wheel's radius is at s [mm] from the running circle, positive away from the flange */
static double wheel(double s)
{
    static const double tread[] = {0,
                                   -3.358537058e-2,
                                   1.565681624e-3,
                                   -2.810427944e-5,
                                   5.844240864e-8,
                                   -1.562379023e-8,
                                   5.309217349e-15,
                                   -5.957839843e-12,
                                   2.646656573e-13};
    static const double root[] = {-4.320221063e3, -1.038384026e3, -1.065501873e2, -6.051367875,
                                  -2.054332446e-1, -4.169739389e-3, -4.687195829e-5, -2.252755540e-7};
    const double *c = s < -26 ? root : tread;
    double z = 0;
    if (s > 32.15796)
        return 1.364323640 - 0.066666667 * s;
    for (int i = s < -26 ? 7 : 8; i >= 0; i--)
        z = z * s + c[i];
    return z;
}

/* How far the rail head is below its top at s [mm] from its middle, upright: three arcs that are tangent to each other */
static double rail(double s)
{
    const double first = 10.297, second = 26.05; /* ends of the arcs of 300 and of 80 mm */
    const double sine = first / 300, cosine = sqrt(1 - sine * sine);
    const double sine2 = (second - 220 * sine) / 80, cosine2 = sqrt(1 - sine2 * sine2);
    const double d = fabs(s);
    if (d < first)
        return 300 - sqrt(300 * 300 - d * d);
    if (d < second)
        return 300 - 220 * cosine - sqrt(80 * 80 - (d - 220 * sine) * (d - 220 * sine));
    const double middle = 220 * sine + 67 * sine2;
    return 300 - 220 * cosine - 67 * cosine2 - sqrt(13 * 13 - (d - middle) * (d - middle));
}

/* Their distance [m] at y [m] from the running circle of the unshifted wheel; the flange is at negative y */
static double distance_at(double y, double shift)
{
    /* middle of the rail head from the running circle: 1435/2 + 36 - 14/40 - 750 */
    const double s = y * 1e3 - 3.15;
    return (rail(s) - s / 40 - wheel(y * 1e3 - shift * 1e3)) * 1e-3;
}

static kstrip_profile_result press(double shift, kstrip_patch *patch)
{
    double y[POINTS], distance[POINTS];
    for (int i = 0; i < POINTS; i++) {
        y[i] = -27e-3 + 0.06e-3 * i;
        distance[i] = distance_at(y[i], shift);
    }
    const kstrip_profile_contact contact = {.rolling_radius = 0.46,
                                            .normal_force = 80e3,
                                            .shear_modulus = 82e9,
                                            .poisson_ratio = 0.28,
                                            .friction = 0.35};
    const kstrip_profile profile = {.y = y, .distance = distance, .points = POINTS};
    kstrip_profile_result found;
    check(kstrip_patch_from_profile(&profile, &contact, patch, &found));
    return found;
}

int main(void)
{
    printf("shift [mm]  approach [um]  stiffness [kN/mm]  peak [MPa]  at y [mm]  area [mm2]  strips  zones\n");
    for (int shift = -3; shift <= 3; shift++) {
        kstrip_patch_summary sums;
        const kstrip_profile_result found = press(shift * 1e-3, &clean);
        check(kstrip_patch_summarize(&clean, &sums));
        printf("%10d %14.3f %18.2f %11.2f %10.3f %11.3f %7u %6u\n", shift, found.approach * 1e6,
               found.stiffness * 1e-6, found.peak_pressure * 1e-6, found.peak_y * 1e3, sums.area * 1e6,
               (unsigned)clean.count, (unsigned)sums.lobes);
    }

    /* Grease on the gauge side: friction is a number of each strip */
    const double middle = press(0, &clean).peak_y;
    greasy = clean;
    for (uint32_t i = 0; i < greasy.count; i++)
        greasy.strips[i].friction = greasy.strips[i].y < middle ? 0.05 : 0.35;

    printf("\nlong. [%%]  lat. [%%]  spin [1/m]      Fx [N]      Fy [N]   Mz [N m]  stick [%%]\n");
    static const kstrip_creepage motions[] = {
        {5e-4, 0, 0}, {2e-3, 0, 0}, {0, 2e-3, 0}, {1e-3, 5e-4, 0.3}, {0, 0, 0.5}, {1, 0, 0}};
    for (unsigned i = 0; i < sizeof motions / sizeof motions[0]; i++) {
        const kstrip_creepage m = motions[i];
        for (int k = 0; k < 2; k++) {
            kstrip_result f;
            const kstrip_outputs wanted = {.result = &f};
            const kstrip_options options = {.model = KSTRIP_MODEL_STRIP};
            check(kstrip_patch_evaluate(k ? &greasy : &clean, &m, NULL, &options, &wanted));
            printf("%9.3f %9.3f %11.3f %11.3f %11.3f %10.4f %10.4f  %s\n", m.longitudinal * 100,
                   m.lateral * 100, m.spin, f.fx, f.fy, f.mz, f.adhesion * 100,
                   k ? "greasy" : "clean");
        }
    }
    return EXIT_SUCCESS;
}
