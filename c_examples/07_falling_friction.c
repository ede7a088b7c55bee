/*
 * Friction that falls with the slip: a traction curve with a maximum, and the stick-slip oscillation of an axle that
 * a shaft drives from a motor at constant speed. Implicit integrator with the library's Jacobian.
 *   cc -std=c99 -Iinclude c_examples/07_falling_friction.c target/lib/libkstrip.a -lm -o falling
 */
#include "kstrip.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const kstrip_contact contact = {6e-3, 4.5e-3, 80e3, 82e9, 0.28, 0, 0}; /* friction: see law */
static const kstrip_options model = {KSTRIP_MODEL_TOTAL, 16};
static const double speed = 10, radius = 0.5;               /* m/s, m */
static const double inertia = 50, stiffness = 500e3, damping = 50; /* kg m2, N m, N m s */

/* Traction of the wheel at a creepage, positive when it slips forward, and its slope. */
static double traction(const kstrip_friction *law, double slip, double *slope, double *friction)
{
    const kstrip_creepage c = {-slip, 0, 0}; /* the wheel's surface moves backwards over the rail */
    kstrip_result f;                         /* on the rail: the wheel gets the opposite */
    kstrip_derivatives d;
    const kstrip_outputs outputs = {.result = &f, .derivatives = &d, .friction = friction};
    if (kstrip_evaluate(&contact, &c, law, &model, &outputs) < 0)
        exit(EXIT_FAILURE);
    *slope = d.jacobian[0][0];
    return -f.fx;
}

/* Let the motor run at a mean slip; amplitude of the slip in the last and the third quarter, and its frequency. */
static void drive(const kstrip_friction *law, double mean, double amplitude[2], double *frequency)
{
    const double step = 1e-4, seconds = 8;
    double slope, mu, slip = mean, past = mean, last = 0;
    double twist = traction(law, mean, &slope, &mu) * radius / stiffness * 0.99; /* a small push */
    double low[2] = {1, 1}, high[2] = {0, 0}, first = 0;
    int turns = 0;
    for (int n = 0; n < seconds / step; n++, past = slip) {
        /* wheel: inertia d(omega)/dt = shaft - traction radius, with omega = speed (1 + slip)/radius */
        const double unit = speed / radius, from = slip, from_twist = twist;
        const double rate = stiffness * from_twist + damping * unit * (mean - from)
            - traction(law, from, &slope, &mu) * radius;
        for (int newton = 0; newton < 30; newton++) { /* trapezoidal rule */
            twist = from_twist + step / 2 * unit * (2 * mean - from - slip);
            const double force = traction(law, slip, &slope, &mu);
            const double after = stiffness * twist + damping * unit * (mean - slip) - force * radius;
            const double error = inertia * unit * (slip - from) - step / 2 * (rate + after);
            const double by_slip = (stiffness * step / 2 + damping) * unit + slope * radius;
            const double d = inertia * unit + step / 2 * by_slip;
            slip -= error / d;
            if (fabs(error / d) < 1e-14) break;
        }
        const int half = (int)(4 * n * step / seconds) - 2; /* third and last quarter */
        if (half < 0) continue;
        low[half] = fmin(low[half], slip), high[half] = fmax(high[half], slip);
        if (half == 1 && past < mean && slip >= mean) /* one turn of the oscillation */
            last = n * step, first = turns++ == 0 ? last : first;
    }
    amplitude[0] = (high[0] - low[0]) / 2, amplitude[1] = (high[1] - low[1]) / 2;
    *frequency = turns > 1 ? (turns - 1) / (last - first) : 0;
}

int main(void)
{
    const kstrip_friction falling = {0.4, 0.4, 0.6, speed, 0.5, 0, 0},
                          constant = {0.4, 1, 0, speed, 0.5, 0, 0};
    double slope, mu, amplitude[2], frequency;
    printf("slip [-], traction [N], slope [N], friction [-]\n");
    for (double slip = 1e-4; slip < 0.5; slip *= 1.2) {
        const double force = traction(&falling, slip, &slope, &mu);
        printf("curve %.6e %.4f %.4f %.8f\n", slip, force, slope, mu);
    }
    for (int i = 0; i < 3; i++) {
        const double mean = i == 0 ? 0.005 : 0.1;
        drive(i == 2 ? &constant : &falling, mean, amplitude, &frequency);
        printf("%s friction, mean slip %.3f: amplitude %.6f then %.6f, %.3f Hz\n",
               i == 2 ? "constant" : "falling", mean, amplitude[0], amplitude[1], frequency);
    }
    return EXIT_SUCCESS;
}
