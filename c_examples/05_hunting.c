/*
 * Hunting: a single wheelset, suspended in a frame that runs at speed V, moves sideways and yaws. Implicit
 * integrator (trapezoidal rule) with Newton's method and the library's Jacobian; critical speed by bisection.
 *   cc -std=c99 -Iinclude c_examples/05_hunting.c target/lib/libkstrip.a -lm -o hunting
 */
#include "kstrip.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double mass = 1800, inertia = 1100, lateral = 400e3, yaw = 3e6; /* kg, kg m2, N/m, N m */
static const double radius = 0.46, half_gauge = 0.75, conicity = 0.1, h = 0.5e-3; /* m, m, -; half a step [s] */
static const kstrip_contact contact = {6e-3, 4.5e-3, 80e3, 82e9, 0.28, 0.2};
static unsigned long calls; /* of kstrip_evaluate() */

typedef struct { double y, psi, v, w; } state; /* right [m], clockwise from above [rad], their rates */

/* Accelerations at the end of a step, and derivatives by the rates there: y, psi follow by half a step. */
static void accelerate(const state *x, double speed, const kstrip_options *model, double a[2], double s[2][2])
{
    a[0] = -lateral * x->y / mass, a[1] = -yaw * x->psi / inertia;
    s[0][0] = -lateral * h / mass, s[1][1] = -yaw * h / inertia, s[0][1] = s[1][0] = 0;
    for (int side = -1; side <= 1; side += 2) { /* left, right */
        const double arm = side * half_gauge, cone = side * conicity / radius;
        const kstrip_creepage c = {-arm * x->w / speed - cone * x->y, x->v / speed - x->psi, x->w / speed - cone};
        const double by[2][3] = {{-cone * h, 1 / speed, 0}, {-arm / speed, -h, 1 / speed}};
        kstrip_result f; /* on the rail: the wheel gets the opposite */
        kstrip_derivatives d;
        const kstrip_outputs outputs = {.result = &f, .derivatives = &d};
        if (calls++, kstrip_evaluate(&contact, &c, NULL, model, &outputs) < 0)
            exit(EXIT_FAILURE);
        a[0] -= f.fy / mass, a[1] += (arm * f.fx - f.mz) / inertia;
        for (int k = 0; k < 2; k++)
            for (int i = 0; i < 3; i++)
                s[0][k] -= d.jacobian[1][i] * by[k][i] / mass,
                    s[1][k] += (arm * d.jacobian[0][i] - d.jacobian[2][i]) * by[k][i] / inertia;
    }
}

/* Start aside, run; the largest |y| of the last quarter over that of the second. */
static double growth(double speed, const kstrip_options *model, double aside, double seconds, double *last)
{
    state x = {aside, 0, 0, 0};
    double a[2], b[2], s[2][2], largest[4] = {0};
    accelerate(&x, speed, model, a, s);
    for (int n = 0, steps = (int)(seconds / (2 * h)); n < steps && fabs(x.y) < 1; n++) {
        const state from = x;
        for (int newton = 0; newton < 20; newton++) {
            x.y = from.y + h * (from.v + x.v), x.psi = from.psi + h * (from.w + x.w);
            accelerate(&x, speed, model, b, s);
            const double r = x.v - from.v - h * (a[0] + b[0]), q = x.w - from.w - h * (a[1] + b[1]);
            const double m = 1 - h * s[0][0], k = h * s[0][1], l = h * s[1][0], o = 1 - h * s[1][1];
            x.v -= (o * r + k * q) / (m * o - k * l), x.w -= (m * q + l * r) / (m * o - k * l);
            if (fabs(r) + fabs(q) < 1e-11 * (fabs(x.v) + fabs(x.w)) + 1e-18) break;
        }
        a[0] = b[0], a[1] = b[1];
        largest[4L * n / steps] = fmax(largest[4L * n / steps], fabs(x.y));
    }
    *last = largest[3];
    return largest[3] > 0 ? largest[3] / largest[1] : INFINITY; /* nothing left: it ran away */
}

int main(void)
{
    const kstrip_options models[] = {{KSTRIP_MODEL_LINEAR, 16}, {KSTRIP_MODEL_TOTAL, 16}};
    double critical[2], last;
    for (int i = 0; i < 2; i++) {
        double low = 5, high = 150;
        while (critical[i] = (low + high) / 2, high - low > 0.01)
            *(growth(critical[i], &models[i], 1e-6, 20, &last) > 1 ? &high : &low) = critical[i];
        printf("critical speed, %s: %.3f m/s\n", i ? "total" : "linear", critical[i]);
    }
    for (int i = 0; i < 2; i++) {
        const int aside = i ? 20 : 1; /* mm */
        const double ratio = growth(1.1 * critical[1], &models[1], aside * 1e-3, 60, &last);
        printf("limit cycle from %d mm: amplitude %.4f mm, growth %.5f\n", aside, last * 1e3, ratio);
    }
    printf("calls with Jacobian: %lu, force calls saved against differences: %lu\n", calls, 3 * calls);
    return EXIT_SUCCESS;
}
