/* A wheel on a contact table that a microcontroller has in its flash.
 *
 * On a PC: fills a table of a wheel on a rail in double precision, writes it and some positions with velocities to two
 * files, and prints the forces on the wheel in single precision.
 *
 *     ./table_lookup tests/data/wheel_rail table.bin poses.bin > forces.txt
 *
 * On the board: the two files are linked as they are (arm-none-eabi-objcopy -I binary), and the table is read in place.
 * The same forces are printed, bit for bit, and lines with a # that have the instructions of a lookup, counted as in
 * budget.c, and its memory.
 */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "kstrip_f32.h"

#define POSES 100u

/* Lateral position, height, yaw; pitch rate and lateral velocity. */
typedef struct pose {
    float lateral, vertical, yaw, pitch, across;
} pose;

static const float radius = 0.46f, speed = 20.0f;

/* The forces on the wheel, on request with their derivatives. */
static kstrip_status look_up(const kstrip_table *table, const pose *at, kstrip_wrench_f32 *wrench,
                             kstrip_wrench_derivatives_f32 *derivatives)
{
    const kstrip_wheel_pair_f32 pair = {
        .wheel_radius = radius, .shear_modulus = 82e9f, .poisson_ratio = 0.28f, .friction = 0.3f};
    const kstrip_wheel_position_f32 position = {.lateral = at->lateral, .vertical = at->vertical, .yaw = at->yaw};
    const kstrip_wheel_velocity_f32 velocity = {.forward = speed, .pitch = at->pitch, .lateral = at->across};
    return kstrip_wheel_on_table_f32(table, &pair, &position, &velocity, NULL, NULL, wrench, derivatives, NULL);
}

static uint32_t bits(float number)
{
    uint32_t word;
    memcpy(&word, &number, sizeof word);
    return word;
}

static void print_force(kstrip_status status, const kstrip_wrench_f32 *wrench)
{
    printf("%d %08" PRIx32 " %08" PRIx32 " %08" PRIx32 "\n", (int)status, bits(wrench->force[0]), bits(wrench->force[1]),
           bits(wrench->force[2]));
}

#ifdef __arm__

extern const uint8_t _binary_table_bin_start[], _binary_table_bin_end[];
extern const uint8_t _binary_poses_bin_start[];

/* The first timer of the board, and the bytes below the stack that are painted. */
#define TIMER_CTRL (*(volatile uint32_t *)0x40000000u)
#define TIMER_VALUE (*(volatile uint32_t *)0x40000004u)
#define TIMER_RELOAD (*(volatile uint32_t *)0x40000008u)
#define PAINT 0x5au
#define PAINTED 65536u
#define SPARED 512u

static int ascending(const void *a, const void *b)
{
    const uint32_t *left = a, *right = b;
    return (*left > *right) - (*left < *right);
}

/* Bytes of stack that a lookup uses: those on which it leaves no paint. */
static uint32_t stack_of(const kstrip_table *table, const pose *at, kstrip_wrench_derivatives_f32 *derivatives)
{
    kstrip_wrench_f32 wrench;
    uint8_t *end;
    uint32_t left = 0;
    __asm volatile("mov %0, sp" : "=r"(end));
    memset(end - PAINTED, PAINT, PAINTED - SPARED);
    (void)look_up(table, at, &wrench, derivatives);
    while (left < PAINTED && ((volatile uint8_t *)end)[(int32_t)left - (int32_t)PAINTED] == PAINT) {
        ++left;
    }
    return PAINTED - left;
}

int main(void)
{
    const kstrip_table table = {.data = _binary_table_bin_start,
                                .bytes = (uint32_t)(_binary_table_bin_end - _binary_table_bin_start),
                                .only = 1};
    static uint32_t counts[2][POSES];
    static kstrip_wrench_derivatives_f32 derivatives;
    uint32_t k, with, stack[2] = {0, 0};
    TIMER_RELOAD = 0xffffffffu;
    TIMER_VALUE = 0xffffffffu;
    TIMER_CTRL = 1u;
    for (k = 0; k < POSES; ++k) {
        pose at;
        memcpy(&at, _binary_poses_bin_start + k * sizeof at, sizeof at);
        for (with = 0; with < 2; ++with) {
            kstrip_wrench_f32 wrench = {.contacts = 0};
            kstrip_wrench_derivatives_f32 *wanted = with ? &derivatives : NULL;
            const uint32_t begin = TIMER_VALUE;
            const kstrip_status status = look_up(&table, &at, &wrench, wanted);
            /* 3.2 ticks for an instruction */
            counts[with][k] = (uint32_t)(((uint64_t)(begin - TIMER_VALUE) * 5u + 8u) / 16u);
            const uint32_t used = stack_of(&table, &at, wanted);
            stack[with] = used > stack[with] ? used : stack[with];
            if (!with) {
                print_force(status, &wrench);
            }
        }
    }
    printf("# table %" PRIu32 " bytes\n", table.bytes);
    for (with = 0; with < 2; ++with) {
        qsort(counts[with], POSES, sizeof counts[with][0], ascending);
        printf("# %s: %" PRIu32 " %" PRIu32 " %" PRIu32 " instructions, %" PRIu32 " bytes of stack\n",
               with ? "with derivatives" : "forces", counts[with][0], counts[with][POSES / 2], counts[with][POSES - 1],
               stack[with]);
    }
    return 0;
}

#else

#include <math.h>

#include "kstrip.h"

static kstrip_surface rail, wheel;
static kstrip_wheel_workspace workspace;

static void check(kstrip_status status)
{
    if (status < 0) {
        fprintf(stderr, "%s\n", kstrip_status_string(status));
        exit(EXIT_FAILURE);
    }
}

static FILE *opened(const char *path, const char *mode)
{
    FILE *file = fopen(path, mode);
    if (file == NULL) {
        fprintf(stderr, "%s cannot be opened\n", path);
        exit(EXIT_FAILURE);
    }
    return file;
}

static void read_profile(const char *folder, const char *name, kstrip_surface *surface)
{
    static double y[20000], z[20000];
    char path[1000], line[200];
    uint32_t count = 0;
    snprintf(path, sizeof path, "%s/%s.csv", folder, name);
    FILE *file = opened(path, "r");
    while (count < 20000 && fgets(line, sizeof line, file) != NULL) {
        if (sscanf(line, "%lf,%lf", &y[count], &z[count]) == 2) {
            y[count] *= 1e-3;
            z[count] *= 1e-3;
            ++count;
        }
    }
    fclose(file);
    check(kstrip_prepare_profile(y, z, count, 0, 0, surface));
}

int main(int argc, char **argv)
{
    const kstrip_wheel_pair pair = {
        .wheel_radius = radius, .shear_modulus = 82e9f, .poisson_ratio = 0.28f, .friction = 0.3f};
    const kstrip_table_spec spec = {
        .lateral_from = -18.7e-3, .lateral_to = -2.4e-3, .yaw = 20e-3, .load = 220e3, .yaw_nodes = 5};
    kstrip_table_report report;
    uint32_t bytes, parts, k;
    uint32_t state = 1;
    if (argc < 4) {
        fprintf(stderr, "usage: %s FOLDER TABLE POSES\n", argv[0]);
        return EXIT_FAILURE;
    }
    read_profile(argv[1], "uic60", &rail);
    read_profile(argv[1], "s1002", &wheel);
    check(kstrip_table_size(&wheel, &spec, &bytes, &parts));
    uint8_t *block = malloc(bytes);
    if (block == NULL) {
        fprintf(stderr, "no memory\n");
        return EXIT_FAILURE;
    }
    check(kstrip_table_begin(&rail, &wheel, &pair, &spec, &workspace, block, bytes));
    check(kstrip_table_fill(&rail, &wheel, &pair, 0, parts, &workspace, block, bytes));
    check(kstrip_table_finish(&rail, &wheel, &pair, 100, &workspace, block, bytes, &report));
    FILE *file = opened(argv[2], "wb");
    fwrite(block, 1, report.bytes, file);
    fclose(file);
    const kstrip_table table = {.data = block, .bytes = report.bytes, .only = 1};
    file = opened(argv[3], "wb");
    for (k = 0; k < POSES;) {
        float random[5];
        for (int i = 0; i < 5; ++i) {
            state = state * 1664525u + 1013904223u;
            random[i] = (float)(state >> 8) / 16777216.0f;
        }
        /* 5 to 200 kN, as many light as heavy ones */
        const double load = 5e3 * pow(40.0, random[0]);
        kstrip_wheel_position position = {.lateral = -18.5e-3 + 16e-3 * random[1], .yaw = 36e-3 * (random[2] - 0.5)};
        if (kstrip_height_for_load(&rail, &wheel, &pair, &position, load, NULL, NULL, &table, &workspace,
                                   &position.vertical) < 0) {
            continue;
        }
        const pose at = {.lateral = (float)position.lateral,
                         .vertical = (float)position.vertical,
                         .yaw = (float)position.yaw,
                         .pitch = -speed / radius * (0.996f + 8e-3f * random[3]),
                         .across = 0.16f * (random[4] - 0.5f)};
        kstrip_wrench_f32 wrench;
        const kstrip_status status = look_up(&table, &at, &wrench, NULL);
        if (status < 0) {
            continue;
        }
        fwrite(&at, sizeof at, 1, file);
        print_force(status, &wrench);
        ++k;
    }
    fclose(file);
    free(block);
    return EXIT_SUCCESS;
}

#endif
