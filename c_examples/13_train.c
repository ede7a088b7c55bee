/*
 * The wheels of a train of fifty cars on an irregular track, from one contact table: four hundred wheels of a right and a left rail, each
 * at its own place of the track, a thousand times a second, with derivatives. A table is filled first, by all threads.
 *   cc -std=c99 -O2 -fopenmp -Iinclude c_examples/13_train.c target/lib/libkstrip.a -lm -o train && ./train tests/data/wheel_rail [milliseconds]
 * Without -fopenmp one thread does it all. With a third word "wheels" it prints every wheel of the last step.
 */
#include "kstrip.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif

enum { CARS = 50, AXLES = 4, WHEELS = 2 * AXLES * CARS, MOST_THREADS = 64, PIECE = 8 };
static const double radius = 0.46, speed = 40, load = 60e3; /* [m], [m/s], [N] */

/* A wheel: how far behind the first axle it is, its lateral position on the rail, the lateral force on it, the friction's power. */
typedef struct moment {
    double behind, lateral, force, power;
} moment;

static kstrip_surface rail, wheel;
static moment now[WHEELS];
static kstrip_wheel_workspace *memory; /* of each thread */
static int threads = 1;

static kstrip_wheel_workspace *own_memory(void)
{
#ifdef _OPENMP
    return &memory[omp_get_thread_num()];
#else
    return memory;
#endif
}

static double seconds(void)
{
#ifdef _OPENMP
    return omp_get_wtime();
#else
    return 0;
#endif
}

static void check(kstrip_status status)
{
    if (status < 0)
        fprintf(stderr, "%s\n", kstrip_status_string(status)), exit(EXIT_FAILURE);
}

/* Reads points [mm], turns them by an angle [rad] and prepares them. */
static void read_profile(const char *folder, const char *name, double angle, kstrip_surface *surface)
{
    static double y[20000], z[20000];
    char path[1000];
    snprintf(path, sizeof path, "%s/%s.csv", folder, name);
    FILE *file = fopen(path, "r");
    if (!file)
        fprintf(stderr, "%s cannot be read\n", path), exit(EXIT_FAILURE);
    char line[200];
    uint32_t count = 0;
    while (count < 20000 && fgets(line, sizeof line, file)) {
        double across, down;
        if (sscanf(line, "%lf,%lf", &across, &down) != 2)
            continue;
        y[count] = 1e-3 * (across * cos(angle) - down * sin(angle));
        z[count++] = 1e-3 * (across * sin(angle) + down * cos(angle));
    }
    fclose(file);
    check(kstrip_prepare_profile(y, z, count, 0, 0, surface));
}

/* Fills a table of the pair, by all threads. Returns its length. */
static uint32_t fill_table(const kstrip_wheel_pair *pair, uint8_t **table)
{
    const kstrip_table_spec spec = {.lateral_from = -15e-3, .lateral_to = -5e-3, .yaw = 5e-3, .load = 2 * load};
    uint32_t bytes, parts;
    check(kstrip_table_size(&wheel, &spec, &bytes, &parts));
    uint8_t *block = malloc(bytes);
    if (!block)
        fprintf(stderr, "no memory\n"), exit(EXIT_FAILURE);
    check(kstrip_table_begin(&rail, &wheel, pair, &spec, memory, block, bytes));
    const double start = seconds();
    kstrip_status worst = KSTRIP_OK;
#ifdef _OPENMP
#pragma omp parallel for num_threads(threads) schedule(dynamic) reduction(min : worst)
#endif
    for (int part = 0; part < (int)parts; part++) {
        const kstrip_status status = kstrip_table_fill(&rail, &wheel, pair, (uint32_t)part, 1, own_memory(), block, bytes);
        worst = status < worst ? status : worst;
    }
    check(worst);
    kstrip_table_report report;
    check(kstrip_table_finish(&rail, &wheel, pair, 200, memory, block, bytes, &report));
    printf("table of %u kB, %u parts", (unsigned)(report.bytes / 1000), (unsigned)parts);
    if (seconds() > 0)
        printf(", filled in %.1f s", seconds() - start);
    printf("\nforces within %.3f of mu N at 95 of 100 positions, loads within %.2f %%\n", report.force_usual, 100 * report.load_usual);
    *table = block;
    return report.bytes;
}

/* Irregular places of the rails: right and left, by the distance along the track [m]. */
static double irregular(double along, int side)
{
    return 0.8e-3 * sin(along / 3.1 + side) + 0.5e-3 * sin(along / 1.27 + 2 * side) + 0.3e-3 * sin(along / 0.61);
}

int main(int argc, char **argv)
{
    const char *folder = argc > 1 ? argv[1] : "tests/data/wheel_rail";
    const int steps = argc > 2 ? atoi(argv[2]) : 100;
#ifdef _OPENMP
    threads = omp_get_max_threads();
    threads = threads < MOST_THREADS ? threads : MOST_THREADS;
#endif
    memory = malloc(MOST_THREADS * sizeof *memory);
    if (!memory)
        return fprintf(stderr, "no memory\n"), EXIT_FAILURE;
    read_profile(folder, "uic60", 0.025, &rail);
    read_profile(folder, "s1002", 0, &wheel);
    const kstrip_wheel_pair pair = {.wheel_radius = radius, .shear_modulus = 82e9, .poisson_ratio = 0.28, .friction = 0.3, .strips = 16};
    uint8_t *block;
    const uint32_t bytes = fill_table(&pair, &block);
    const kstrip_table table = {.data = block, .bytes = bytes};

    /* where a right wheel carries the load, by its lateral position: every 0.1 mm */
    enum { PLACES = 101 };
    double heights[PLACES];
    for (int k = 0; k < PLACES; k++) {
        const kstrip_wheel_position position = {.lateral = -15e-3 + 1e-4 * k};
        check(kstrip_height_for_load(&rail, &wheel, &pair, &position, load, NULL, NULL, &table, memory, &heights[k]));
    }
    const double start = seconds();
    double power = 0, largest = 0;
    int outside = 0;
    for (int step = 0; step < steps; step++) {
        double sum = 0, most = 0;
        int left_out = 0;
#ifdef _OPENMP
#pragma omp parallel for num_threads(threads) schedule(dynamic, PIECE) reduction(+ : sum, left_out) reduction(max : most)
#endif
        for (int i = 0; i < WHEELS; i++) {
            const int side = i % 2, axle = i / 2;
            const double along = speed * 1e-3 * step - 5.0 * axle, sign = side ? -1 : 1;
            const double lateral = -10.5e-3 + sign * irregular(along, side), place = 1e4 * (lateral + 15e-3);
            const int k = (int)place;
            const double height = heights[k] + (heights[k + 1] - heights[k]) * (place - k);
            kstrip_wheel_pair own = pair;
            own.left = side;
            const kstrip_wheel_position position = {.lateral = sign * lateral, .vertical = height, .yaw = 2e-3 * sin(along / 7)};
            const kstrip_wheel_velocity velocity = {.forward = speed, .pitch = -speed / radius, .lateral = speed * position.yaw};
            kstrip_wrench wrench;
            kstrip_wrench_derivatives by_velocity;
            const kstrip_status status =
                kstrip_wheel_on_table(&table, &own, &position, &velocity, NULL, own_memory(), &wrench, &by_velocity, NULL);
            if (status == KSTRIP_ERROR_TABLE_RANGE) { /* the direct call takes over */
                left_out++;
                continue;
            }
            check(status);
            now[i] = (moment){5.0 * axle, sign * lateral, wrench.force[1], wrench.dissipation};
            sum += wrench.dissipation;
            most = fmax(most, fabs(wrench.force[1]));
        }
        power += sum / steps, largest = fmax(largest, most), outside += left_out;
    }
    printf("%d wheels, %d steps of a millisecond: %d outside the table\n", WHEELS, steps, outside);
    printf("friction takes %.1f kW, largest lateral force %.1f kN\n", 1e-3 * power, 1e-3 * largest);
    if (seconds() > 0)
        printf("%.2f times as fast as the train, by %d threads\n", 1e-3 * steps / (seconds() - start), threads);
    if (argc > 3 && strcmp(argv[3], "wheels") == 0)
        for (int i = 0; i < WHEELS; i++)
            printf("wheel %d: %.1f m behind, at %.3f mm, %.3f kN, %.1f W\n", i, now[i].behind, 1e3 * now[i].lateral,
                   1e-3 * now[i].force, now[i].power);
    free(block), free(memory);
    return EXIT_SUCCESS;
}
