/* On a PC: reads the trace of twin_disc.c and computes every printed line again in double precision.
 *
 *     ./twin_disc_check < trace.txt
 *
 * Returns 0 if all forces agree within 2e-6 mu N (moment: times sqrt(a b)) and no line is missing.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "kstrip.h"

#define ALLOWED 2e-6
#define LINES 90

static double number(unsigned word)
{
    const uint32_t bits = (uint32_t)word;
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

int main(void)
{
    static const kstrip_options model = {KSTRIP_MODEL_STRIP, 8};
    char line[512];
    double largest = 0.0, largest_stick = 0.0;
    int lines = 0;
    while (fgets(line, sizeof line, stdin) != NULL) {
        unsigned w[13];
        const char *start = strchr(line, '|');
        kstrip_contact c;
        kstrip_creepage k;
        kstrip_result r;
        double unit, force, moment;
        if (line[0] == '#' || start == NULL) {
            continue;
        }
        if (sscanf(start, "| %x %x %x %x %x %x %x %x %x | %x %x %x %x", &w[0], &w[1], &w[2], &w[3], &w[4],
                   &w[5], &w[6], &w[7], &w[8], &w[9], &w[10], &w[11], &w[12]) != 13) {
            printf("cannot read: %s", line);
            return 2;
        }
        c.a = number(w[0]);
        c.b = number(w[1]);
        c.normal_force = number(w[2]);
        c.shear_modulus = number(w[3]);
        c.poisson_ratio = number(w[4]);
        c.friction = number(w[5]);
        c.mismatch = 0;
        k.longitudinal = number(w[6]);
        k.lateral = number(w[7]);
        k.spin = number(w[8]);
        if (kstrip_solve(&c, &k, &model, &r) < 0) {
            printf("refused: %s", line);
            return 2;
        }
        unit = c.friction * c.normal_force;
        force = hypot(number(w[9]) - r.fx, number(w[10]) - r.fy) / unit;
        moment = fabs(number(w[11]) - r.mz) / (unit * sqrt(c.a * c.b));
        largest = fmax(largest, fmax(force, moment));
        largest_stick = fmax(largest_stick, fabs(number(w[12]) - r.adhesion));
        ++lines;
    }
    printf("twin_disc: %d lines, largest difference to double precision %.2g mu N, stick area %.2g\n", lines,
           largest, largest_stick);
    return lines == LINES && largest <= ALLOWED ? 0 : 1;
}
