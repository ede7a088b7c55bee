/*
 * Hunting: a wheelset, held by springs in a frame that runs at constant speed, moves sideways and yaws. Above the critical speed it
 * swings up to a limit cycle. Trapezoidal rule, Newton's method with the derivatives of kstrip_evaluate(). docs/reference/hosts.md derives its
 * creepages in "A wheelset worked out by hand".
 *   cc -std=c99 -Iinclude c_examples/05_hunting.c target/lib/libkstrip.a -lm -o hunting
 */
#include "kstrip.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double mass = 1800, inertia = 1100, lateral_spring = 400e3, yaw_spring = 3e6; /* kg, kg m2, N/m, N m */
static const double radius = 0.46, half_gauge = 0.75, conicity = 0.1, step = 1e-3;         /* m, m, -, s */
static const kstrip_contact contact = {6e-3, 4.5e-3, 80e3, 82e9, 0.28, 0.2, 0};
static unsigned long calls; /* of kstrip_evaluate() */

/* The state, x forward, y to the right, z down: place [m] and yaw [rad] to the right, and their rates */
enum { Y, YAW, Y_RATE, YAW_RATE, STATES };

/* Adds the forces of one wheel (side = -1: left, 1: right) to the rates of the state, and their derivatives with respect to the state. */
static void add_wheel(int side, double speed, const kstrip_options *model, const double x[STATES], double rate[STATES],
                      double by[STATES][STATES])
{
    /* creepage = of the straight run + K x: the radius grows by conicity y, yaw steers, the tilted tread gives spin */
    const double arm = side * half_gauge, cone = side * conicity / radius;
    const double straight[3] = {0, 0, -cone};
    const double K[3][STATES] = {{-cone, 0, 0, -arm / speed}, {0, -1, 1 / speed, 0}, {0, 0, 0, 1 / speed}};
    double c[3];
    for (int i = 0; i < 3; i++) {
        c[i] = straight[i];
        for (int k = 0; k < STATES; k++) c[i] += K[i][k] * x[k];
    }
    const kstrip_creepage creepage = {c[0], c[1], c[2]};
    kstrip_result result;
    kstrip_derivatives d;
    const kstrip_outputs outputs = {.result = &result, .derivatives = &d};
    const kstrip_status status = kstrip_evaluate(&contact, &creepage, NULL, model, &outputs);
    if (status < 0) {
        fprintf(stderr, "%s\n", kstrip_status_string(status));
        exit(EXIT_FAILURE);
    }
    calls++;
    /* Equal and opposite forces act on the wheel: fx at the lever arm, fy, mz. */
    const double f[3] = {result.fx, result.fy, result.mz};
    const double on_y[3] = {0, -1 / mass, 0}, on_yaw[3] = {arm / inertia, 0, -1 / inertia};
    for (int i = 0; i < 3; i++) {
        rate[Y_RATE] += on_y[i] * f[i], rate[YAW_RATE] += on_yaw[i] * f[i];
        for (int k = 0; k < STATES; k++) {
            double slope = 0; /* of f[i] by x[k] */
            for (int j = 0; j < 3; j++) slope += d.jacobian[i][j] * K[j][k];
            by[Y_RATE][k] += on_y[i] * slope, by[YAW_RATE][k] += on_yaw[i] * slope;
        }
    }
}

static void rates(double speed, const kstrip_options *model, const double x[STATES], double rate[STATES], double by[STATES][STATES])
{
    const double springs[STATES][STATES] = {
        [Y][Y_RATE] = 1, [YAW][YAW_RATE] = 1, [Y_RATE][Y] = -lateral_spring / mass, [YAW_RATE][YAW] = -yaw_spring / inertia};
    for (int i = 0; i < STATES; i++) {
        rate[i] = 0;
        for (int k = 0; k < STATES; k++) rate[i] += springs[i][k] * x[k], by[i][k] = springs[i][k];
    }
    add_wheel(-1, speed, model, x, rate, by);
    add_wheel(1, speed, model, x, rate, by);
}

/* A z = r by Gauss; the solution replaces r. The matrix is 1 - (small) J: no pivots. */
static void solve(double A[STATES][STATES], double r[STATES])
{
    for (int p = 0; p < STATES; p++)
        for (int i = p + 1; i < STATES; i++) {
            const double factor = A[i][p] / A[p][p];
            for (int k = p; k < STATES; k++) A[i][k] -= factor * A[p][k];
            r[i] -= factor * r[p];
        }
    for (int i = STATES - 1; i >= 0; i--) {
        for (int k = i + 1; k < STATES; k++) r[i] -= A[i][k] * r[k];
        r[i] /= A[i][i];
    }
}

/* One step of the trapezoidal rule: x' = x + step/2 (rate(x) + rate(x')). rate: at x, then at x'. */
static void advance(double speed, const kstrip_options *model, double x[STATES], double rate[STATES])
{
    double from[STATES];
    for (int i = 0; i < STATES; i++) from[i] = x[i] + step / 2 * rate[i];
    for (int newton = 0; newton < 20; newton++) {
        double A[STATES][STATES], change[STATES], size = 0, changed = 0;
        rates(speed, model, x, rate, A);
        for (int i = 0; i < STATES; i++) {
            change[i] = from[i] + step / 2 * rate[i] - x[i];
            for (int k = 0; k < STATES; k++) A[i][k] = (i == k) - step / 2 * A[i][k];
        }
        solve(A, change);
        for (int i = 0; i < STATES; i++) x[i] += change[i], size += fabs(x[i]), changed += fabs(change[i]);
        if (changed < 1e-9 * size + 1e-18) break;
    }
}

/* Starts at a displacement. Gives the largest |y| of the last quarter of the run, and returns its ratio to that of the second quarter. */
static double growth(double speed, const kstrip_options *model, double aside, double seconds, double *last)
{
    double x[STATES] = {aside, 0, 0, 0}, rate[STATES], by[STATES][STATES], largest[4] = {0};
    const int steps = (int)(seconds / step);
    rates(speed, model, x, rate, by);
    for (int n = 0; n < steps && fabs(x[Y]) < 1; n++) {
        advance(speed, model, x, rate);
        largest[4L * n / steps] = fmax(largest[4L * n / steps], fabs(x[Y]));
    }
    *last = largest[3];
    return largest[3] > 0 ? largest[3] / largest[1] : INFINITY; /* the last quarter was not reached: it ran away */
}

int main(void)
{
    const kstrip_options linear = {.model = KSTRIP_MODEL_LINEAR}, total = {.model = KSTRIP_MODEL_TOTAL};
    double critical = 0, last;
    for (int i = 0; i < 2; i++) {
        double low = 5, high = 150;
        while (high - low > 0.01) {
            critical = (low + high) / 2;
            *(growth(critical, i ? &total : &linear, 1e-6, 20, &last) > 1 ? &high : &low) = critical;
        }
        printf("critical speed, %s: %.3f m/s\n", i ? "total" : "linear", critical);
    }
    for (int i = 0; i < 2; i++) {
        const int aside = i ? 20 : 1; /* mm */
        const double ratio = growth(1.1 * critical, &total, aside * 1e-3, 60, &last);
        printf("limit cycle from %d mm: amplitude %.4f mm, growth %.5f\n", aside, last * 1e3, ratio);
    }
    printf("calls with Jacobian: %lu, force calls saved against differences: %lu\n", calls, 3 * calls);
    return EXIT_SUCCESS;
}
