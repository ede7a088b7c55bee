/*
 * A railway wheel on a rail: contact patch, forces, and a map of where the wheel sticks and slips.
 *
 *   cc -std=c99 -Iinclude c_examples/01_wheel_rail.c target/lib/libkstrip.a -o wheel_rail
 */
#include "kstrip.h"
#include <math.h> /* INFINITY */
#include <stdio.h>
#include <stdlib.h>

enum { ROWS = 25, COLUMNS = 51 };

static void check(kstrip_status status)
{
    if (status != KSTRIP_OK)
        fprintf(stderr, "kstrip: %s\n", kstrip_status_string(status));
    if (status < 0) /* < 0: error, nothing was written; > 0: warning, the result is valid */
        exit(EXIT_FAILURE);
}

/* Prints rounding errors as plain zeros. */
static double tidy(double v) { return v < 5e-5 && v > -5e-5 ? 0 : v; }

int main(void)
{
    const double load = 80e3, friction = 0.3; /* N, - */
    const kstrip_material steel = {82e9, 0.28}; /* shear modulus [Pa], Poisson's ratio */
    /* Rail (lower body): straight, head of 0.30 m. Wheel (upper body): 0.46 m, conical tread. */
    const kstrip_radii radii = {INFINITY, 0.30, 0.46, INFINITY}; /* m */
    const kstrip_creepage motions[] = {/* longitudinal [-], lateral [-], spin [1/m] */
        {0.0001, 0, 0}, {0.001, 0, 0},   {0.002, 0, 0},     {0.01, 0, 0},     {1, 0, 0},
        {0, 0.001, 0},  {0, -0.001, 0},  {0.001, 0.001, 0}, {0, 0, 0.1},      {0, 0, 0.5},
        {0, 0, 1.0},    {0.001, 0, 0.5}, {0, 0.001, 0.5},   {0, -0.001, 0.5}, {0.001, 0.001, 0.5}};
    kstrip_combined_material pair;
    kstrip_hertz_contact patch;
    check(kstrip_material_combine(&steel, &steel, &pair));
    kstrip_contact contact;
    check(kstrip_contact_from_hertz(&radii, &pair, load, friction, &contact, &patch));
    printf("Contact patch\n  a = %.6f mm along the rail, b = %.6f mm across\n", patch.a * 1e3,
           patch.b * 1e3);
    printf("  peak pressure %.4f MPa, approach %.6f um\n\n", patch.peak_pressure / 1e6,
           patch.approach * 1e6);

    /* Forces on the rail; the wheel gets the opposite. STRIP computes the stick area, which the last column has. */
    const kstrip_options strips = {.model = KSTRIP_MODEL_STRIP};
    printf("Forces on the rail\n  long. [%%]  lat. [%%] spin [1/m]     Fx [N]     Fy [N]   Mz [N m]"
           "  stick [%%]\n");
    for (size_t i = 0; i < sizeof motions / sizeof *motions; i++) {
        const kstrip_creepage m = motions[i];
        kstrip_result f;
        check(kstrip_solve(&contact, &m, &strips, &f));
        printf("%11.2f%10.2f%11.2f%11.2f%11.2f%11.4f%11.3f\n", m.longitudinal * 100,
               m.lateral * 100, m.spin, tidy(f.fx), tidy(f.fy), tidy(f.mz), f.adhesion * 100);
    }

    /* The map: a line of text is about twice as high as a character is wide. */
    const kstrip_creepage motion = {0.001, 0, 0.4};
    static kstrip_point map[ROWS * COLUMNS];
    const double step = 2 * contact.a / ROWS; /* m per line */
    double x[ROWS], y[COLUMNS];
    for (int i = 0; i < ROWS; i++)
        x[i] = (i - ROWS / 2) * step;
    for (int j = 0; j < COLUMNS; j++)
        y[j] = (j - COLUMNS / 2) * step / 2;
    check(kstrip_field(&contact, &motion, NULL, NULL, x, ROWS, y, COLUMNS, map, ROWS * COLUMNS));
    printf("\nStick and slip at %.2f %% longitudinal creepage, spin %.2f 1/m\n"
           "  # stick   . slip   - slip against the traction\n\n"
           "%*s\n", motion.longitudinal * 100, motion.spin, COLUMNS / 2 + 24,
           "^ x, rolling direction (leading edge)");
    for (int i = ROWS - 1; i >= 0; i--) {
        printf("  |");
        for (int j = 0; j < COLUMNS; j++)
            putchar(" #.-"[map[j * ROWS + i].state]); /* KSTRIP_STATE_OUTSIDE is 0, and so on */
        printf("|%s\n", i == ROWS / 2 ? " -> y" : "");
    }
    return EXIT_SUCCESS;
}
