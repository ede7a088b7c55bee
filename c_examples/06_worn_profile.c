/*
 * A wheel on a rail as the standards draw them, in one call: where they touch as the wheel shifts, its rolling radius, the angle, area
 * and pressure of contact, and the forces on the wheel, on a dry rail and on one that is greased on the gauge side; equivalent conicity.
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

enum { POINTS = 261 };

static kstrip_surface rail, wheel;
static kstrip_wheel_workspace workspace;
static kstrip_wheelset_workspace both;

static void check(kstrip_status status)
{
    if (status != KSTRIP_OK)
        fprintf(stderr, "kstrip: %s\n", kstrip_status_string(status));
    if (status < 0)
        exit(EXIT_FAILURE);
}

/* How much larger the wheel's radius is at s [mm] from the running circle, positive away from the flange */
static double wheel_at(double s)
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
static double rail_at(double s)
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

/* Middle of the rail head from the running circle: 1435/2 + 36 - 14/40 - 750 mm */
static const double offset = 3.15e-3;

static void draw(void)
{
    double y[POINTS], z[POINTS];
    for (int i = 0; i < POINTS; i++) {
        const double s = -32 + i * 60.0 / (POINTS - 1);
        y[i] = s * 1e-3;
        z[i] = wheel_at(s) * 1e-3;
    }
    check(kstrip_prepare_profile(y, z, POINTS, 0, 0, &wheel));
    for (int i = 0; i < POINTS; i++) {
        const double s = -33 + i * 66.0 / (POINTS - 1);
        y[i] = s * 1e-3;
        z[i] = (rail_at(s) - s / 40) * 1e-3;
    }
    check(kstrip_prepare_profile(y, z, POINTS, 0, 0, &rail));
}

static kstrip_wheel_pair steel(double friction)
{
    const kstrip_wheel_pair pair = {
        .wheel_radius = 0.46, .shear_modulus = 82e9, .poisson_ratio = 0.28, .friction = friction};
    return pair;
}

/* Where a wheel that is shifted carries 80 kN */
static kstrip_wheel_position loaded(double shift)
{
    const kstrip_wheel_pair pair = steel(0.35);
    kstrip_wheel_position position = {.lateral = shift - offset};
    check(kstrip_height_for_load(&rail, &wheel, &pair, &position, 80e3, NULL, NULL, NULL, &workspace,
                                 &position.vertical));
    return position;
}

/* Rolling radius there, of the contact that carries most */
static double radius_at(double shift)
{
    loaded(shift);
    const kstrip_wheel_contact *most = workspace.contacts;
    for (uint32_t i = 1; i < workspace.count; i++)
        if (workspace.contacts[i].normal_force > most->normal_force)
            most = workspace.contacts + i;
    return most->radius;
}

int main(void)
{
    draw();
    printf("shift [mm]  at y [mm]  radius [mm]  angle [rad]  its range  load [kN]  area [mm2]  peak [MPa]\n");
    for (int shift = -3; shift <= 5; shift++) {
        const kstrip_wheel_position position = loaded(shift * 1e-3);
        for (uint32_t i = 0; i < workspace.count; i++) {
            const kstrip_wheel_contact *c = &workspace.contacts[i];
            kstrip_patch_summary sums;
            double peak = 0;
            check(kstrip_patch_summarize(&c->patch, &sums));
            for (uint32_t k = 0; k < c->patch.count; k++)
                peak = fmax(peak, c->patch.strips[k].peak_pressure);
            printf("%10d %10.3f %12.4f %12.5f %10.4f %10.4f %11.3f %11.2f\n", shift,
                   (c->origin[1] + position.lateral) * 1e3, c->radius * 1e3, c->angle,
                   c->angle_range, c->normal_force * 1e-3, sums.area * 1e6, peak * 1e-6);
        }
    }

    /* EN 15302: the cones with the wave length of this wheelset, from the motion over half a wave; and the elastic radii at one shift */
    enum { SHIFTS = 81 };
    const kstrip_track track = {.rail = {&rail}, .origin = {0.75 + offset, 0.75 + offset}};
    const kstrip_wheelset set = {.wheel = {&wheel}, .pair = {steel(0.35)}, .running_circles = 1.5};
    const double amplitude = 3e-3;
    double shifts[SHIFTS], differences[SHIFTS], conicity, wave_length;
    for (int i = 0; i < SHIFTS; i++)
        shifts[i] = (i - SHIFTS / 2) * 0.1e-3;
    check(kstrip_rolling_radius_difference(&set, &track, shifts, SHIFTS, 0, &both, differences, NULL));
    check(kstrip_equivalent_conicity(shifts, differences, SHIFTS, 1.5, 0.46, &amplitude, 1, &conicity, &wave_length, NULL));
    printf("\nequivalent conicity at 3 mm %.4f\nwave length at 3 mm %.3f m\nradius difference under load over twice the shift of 3 mm %.4f\n",
           conicity, wave_length, (radius_at(amplitude) - radius_at(-amplitude)) / (2 * amplitude));

    /* Grease on the gauge side: friction along the rail */
    kstrip_wheel_pair dry = steel(0.35), greasy = steel(0.35);
    greasy.friction_points = 2;
    greasy.friction_y[0] = -15e-3;
    greasy.friction_y[1] = 0;
    greasy.friction_at[0] = 0.05;
    greasy.friction_at[1] = 0.35;
    const kstrip_wheel_position position = loaded(2e-3);
    printf("\ncreepage [%%]       forward [N]   lateral [N]  down [N]  about the axle [N m]\n");
    static const double creepages[] = {-1e-2, -1e-3, 0, 1e-3, 1e-2};
    for (unsigned i = 0; i < sizeof creepages / sizeof creepages[0]; i++)
        for (int k = 0; k < 2; k++) {
            const kstrip_wheel_velocity velocity = {
                .forward = 20, .pitch = -20 / 0.4604 * (1 + creepages[i])};
            kstrip_wrench w;
            check(kstrip_wheel_on_rail(&rail, &wheel, k ? &greasy : &dry, &position, &velocity, NULL,
                                       &workspace, &w, NULL, NULL));
            printf("%9.3f %18.3f %13.3f %12.3f %14.4f  %s\n", creepages[i] * 100, w.force[0],
                   w.force[1], w.force[2], w.moment[1], k ? "greasy" : "dry");
        }
    return EXIT_SUCCESS;
}
