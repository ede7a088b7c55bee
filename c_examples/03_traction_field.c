/*
 * Inside the patch: what each strip carries, and the traction at every point. Both must add up to
 * the forces of kstrip_solve().
 *
 *   cc -std=c99 -Iinclude c_examples/03_traction_field.c target/lib/libkstrip.a -o field
 */
#include "kstrip.h"
#include <stdio.h>
#include <stdlib.h>

enum { N = 240, PRINTED = 24 }; /* grid lines each way; every how many is printed */

static kstrip_point field[N * N];

static void check(kstrip_status status)
{
    if (status != KSTRIP_OK)
        fprintf(stderr, "kstrip: %s\n", kstrip_status_string(status));
    if (status < 0)
        exit(EXIT_FAILURE);
}

int main(void)
{
    /* Semi-axes along and across the rolling direction [m], load [N], shear modulus [Pa],
       Poisson's ratio, friction. */
    const kstrip_contact contact = {6e-3, 4.5e-3, 80e3, 82e9, 0.28, 0.3, 0};
    const kstrip_creepage motion = {0.0005, 0.001, 0.3}; /* -, -, 1/m */
    const kstrip_options options = {KSTRIP_MODEL_STRIP_1967, 32};
    static const char *const states[] = {"outside", "stick", "slip", "slip-"};

    kstrip_strip strips[KSTRIP_STRIPS_CAPACITY];
    uint32_t count;
    double fx = 0, fy = 0, mz = 0, power = 0;
    kstrip_result f;
    const kstrip_outputs outputs = {
        .result = &f, .strips = strips, .capacity = KSTRIP_STRIPS_CAPACITY, .count = &count};
    check(kstrip_evaluate(&contact, &motion, NULL, &options, &outputs));
    printf("strip    y [mm]  width [mm]  half length [mm]  separatrix [mm]     Fx [N]     Fy [N]"
           "\n");
    for (uint32_t i = 0; i < count; i++) {
        const kstrip_strip s = strips[i];
        printf("%5u%10.5f%12.5f%18.5f%17.5f%11.4f%11.4f\n", (unsigned)i, s.y * 1e3, s.width * 1e3,
               s.half_length * 1e3, s.separatrix * 1e3, s.fx, s.fy);
        fx += s.fx, fy += s.fy, mz += s.mz, power += s.power;
    }

    /* The field at the centres of N x N equal cells over the rectangle around the ellipse */
    double x[N], y[N], gx = 0, gy = 0, gz = 0, gn = 0, gp = 0;
    for (int i = 0; i < N; i++) {
        x[i] = contact.a * (2 * i + 1 - N) / N;
        y[i] = contact.b * (2 * i + 1 - N) / N;
    }
    check(kstrip_field(&contact, &motion, NULL, &options, x, N, y, N, field, N * N));
    const double cell = 4 * contact.a * contact.b / N / N; /* m^2 */
    printf("\nfield  x [mm]    y [mm]  pressure [MPa]   X [MPa]   Y [MPa]     slip_x     slip_y\n");
    for (int j = 0; j < N; j++) {
        for (int i = 0; i < N; i++) {
            const kstrip_point p = field[j * N + i];
            gn += cell * p.pressure;
            gx += cell * p.traction_x;
            gy += cell * p.traction_y;
            gz += cell * (x[i] * p.traction_y - y[j] * p.traction_x);
            gp += cell * p.dissipation;
            if (i % PRINTED == PRINTED / 2 && j % PRINTED == PRINTED / 2 && p.state)
                printf("point%8.4f%10.5f%16.4f%10.4f%10.4f%11.7f%11.7f %s\n", x[i] * 1e3,
                       y[j] * 1e3, p.pressure / 1e6, p.traction_x / 1e6, p.traction_y / 1e6,
                       p.slip_x, p.slip_y, states[p.state]);
        }
    }

    printf("\n                        N [N]      Fx [N]      Fy [N]   Mz [N m]   power [N]\n");
    printf("solve          %14.4f%12.4f%12.4f%11.6f%12.6f\n", contact.normal_force, f.fx, f.fy,
           f.mz, f.power);
    printf("sum of strips  %14s%12.4f%12.4f%11.6f%12.6f\n", "", fx, fy, mz, power);
    printf("integral       %14.4f%12.4f%12.4f%11.6f%12.6f\n", gn, gx, gy, gz, gp);
    return EXIT_SUCCESS;
}
