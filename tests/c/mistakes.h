/*
 * What the programs of tests/interface/mistakes.rs have in common in C and C++: points of a rail and a wheel, and numbers that a row of
 * tests/data/mistakes.csv may change. The rows change members of the good case by SET(member, value).
 */
#include <stdio.h>
#include <string.h>

enum { MOST = 1200, FORCES = 6 };
static double drawn_y[2][MOST], drawn_z[2][MOST];
static uint32_t drawn[2];
static double support, force, unit, down, across, creepage_factor, amplitude, sense;
static int swapped, rail_upside_down;
/* From the rail's origin to the wheel in the middle of the track [m]. */
static const double offset = 0.75 - 0.7605325;

static int read_profile(unsigned number, const char *path)
{
    static char text[100000];
    FILE *file = fopen(path, "rb");
    const uint32_t length = file ? (uint32_t)fread(text, 1, sizeof text, file) : 0;
    if (file)
        fclose(file);
    return kstrip_read_profile(text, length, KSTRIP_FORMAT_ANY, drawn_y[number], drawn_z[number], MOST, &drawn[number], NULL) == KSTRIP_OK;
}

static void good_numbers(void)
{
    support = 80e3, force = 10e3, unit = down = across = creepage_factor = sense = 1, amplitude = 3e-3;
    swapped = rail_upside_down = 0;
}
