/* How much stack calls need on this machine: each runs in a thread whose stack was painted; prints the
 * name of the function and the number of bytes that it changed below what a call of nothing changes. Of
 * the models and options of a function it is the largest number.
 */
#define _POSIX_C_SOURCE 200809L
#include "kstrip.h"
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROOM = 1 << 20, PAINT = 0xA5, POINTS = 201, MEASURED = 12, BATCH = 16 };

static double y[POINTS], rail_z[POINTS], wheel_z[POINTS], distance[POINTS];
static kstrip_surface rail, wheel, again;
static kstrip_wheel_workspace workspace;
static kstrip_wheelset_workspace both;
static kstrip_patch patch;
static kstrip_options options;
static uint8_t block[1 << 20];
static uint32_t bytes_of_table, parts;

static const kstrip_contact contact = {6e-3, 4.5e-3, 80e3, 82e9, 0.28, 0.3, 0};
static const kstrip_creepage creepage = {1e-3, 5e-4, 0.2};
static const kstrip_friction law = {0.3, 0.4, 0.6, 20, 0.5, 0.8, 1e-14};
static const kstrip_wheel_position position = {1e-3, 1e-4, 2e-3, 0};
static const kstrip_wheel_velocity velocity = {20, 0.01, 0, 0, -43.4, 0.01};

static int nothing(void)
{
    return KSTRIP_OK;
}

static int solve(void)
{
    kstrip_result result;
    return kstrip_solve(&contact, &creepage, &options, &result);
}

/* All outputs of a contact or of a patch. */
static kstrip_outputs everything(kstrip_strip *strips, uint32_t *count)
{
    static kstrip_result result;
    static kstrip_derivatives derivatives;
    static kstrip_law_derivatives by_law;
    kstrip_outputs outputs;
    memset(&outputs, 0, sizeof outputs);
    outputs.result = &result, outputs.derivatives = &derivatives, outputs.law_derivatives = &by_law;
    outputs.strips = strips, outputs.capacity = KSTRIP_STRIPS_CAPACITY, outputs.count = count;
    return outputs;
}

static int evaluate(void)
{
    static kstrip_strip strips[KSTRIP_STRIPS_CAPACITY];
    static uint32_t count;
    const int has_strips = options.model != KSTRIP_MODEL_TOTAL;
    const kstrip_outputs outputs = everything(has_strips ? strips : NULL, has_strips ? &count : NULL);
    return kstrip_evaluate(&contact, &creepage, &law, &options, &outputs);
}

static int evaluate_batch(void)
{
    static double fx[BATCH];
    static kstrip_derivatives derivatives[BATCH];
    kstrip_batch_inputs inputs;
    kstrip_batch_outputs outputs;
    memset(&inputs, 0, sizeof inputs);
    memset(&outputs, 0, sizeof outputs);
    /* (strides of 0: all contacts are the same) */
    inputs.a = &contact.a, inputs.b = &contact.b, inputs.normal_force = &contact.normal_force;
    inputs.shear_modulus = &contact.shear_modulus, inputs.poisson_ratio = &contact.poisson_ratio;
    inputs.friction = &contact.friction, inputs.longitudinal = &creepage.longitudinal;
    inputs.lateral = &creepage.lateral, inputs.spin = &creepage.spin, inputs.law = &law;
    outputs.fx = fx, outputs.fx_stride = sizeof fx[0];
    outputs.derivatives = derivatives, outputs.derivatives_stride = sizeof derivatives[0];
    return kstrip_evaluate_batch(&inputs, BATCH, &options, &outputs, NULL);
}

static int creepage_for_force(void)
{
    kstrip_creepage found;
    return kstrip_creepage_for_force(&contact, 5e3, 2e3, 0.1, &law, &options, &found);
}

static int estimate_friction(void)
{
    kstrip_friction_estimate found;
    return kstrip_estimate_friction(&contact, &creepage, &law, &options, KSTRIP_MEASURED_FX, 8e3, 0,
                                    &found);
}

static int fit_friction(void)
{
    static kstrip_measured_force points[MEASURED];
    kstrip_friction_fit found;
    int i;
    for (i = 0; i < MEASURED; i++) {
        const double c = (i + 1) * (i + 1);
        points[i].longitudinal = c * 1e-4;
        points[i].fx = 24e3 * c / (c + 20);
        points[i].weight = 1;
        points[i].measured = KSTRIP_MEASURED_FX;
    }
    return kstrip_fit_friction(&contact, points, MEASURED, &law,
                               KSTRIP_FIT_FRICTION | KSTRIP_FIT_SLOPE_FACTOR, &options, &found, NULL);
}

static int from_profile(void)
{
    const kstrip_profile profile = {y, distance, NULL, NULL, POINTS, 0};
    kstrip_profile_contact pressed;
    kstrip_profile_result result;
    memset(&pressed, 0, sizeof pressed);
    pressed.rolling_radius = 0.46, pressed.normal_force = 80e3, pressed.shear_modulus = 82e9;
    pressed.poisson_ratio = 0.28, pressed.friction = 0.3, pressed.strips = options.strips;
    return kstrip_patch_from_profile(&profile, &pressed, &patch, &result);
}

static int evaluate_patch(void)
{
    const kstrip_outputs outputs = everything(NULL, NULL);
    return kstrip_patch_evaluate(&patch, &creepage, &law, &options, &outputs);
}

static int prepare_profile(void)
{
    return kstrip_prepare_profile(y, wheel_z, POINTS, 0, 0, &again);
}

static kstrip_wheel_pair pair(void)
{
    kstrip_wheel_pair pair;
    memset(&pair, 0, sizeof pair);
    pair.wheel_radius = 0.46, pair.shear_modulus = 82e9, pair.poisson_ratio = 0.28, pair.friction = 0.3;
    pair.model = options.model, pair.strips = options.strips;
    return pair;
}

static int wheel_on_rail(void)
{
    static kstrip_wrench wrench;
    static kstrip_wrench_derivatives derivatives;
    static kstrip_wrench_by_position by_position;
    const kstrip_wheel_pair own = pair();
    return kstrip_wheel_on_rail(&rail, &wheel, &own, &position, &velocity, &law, &workspace, &wrench,
                                &derivatives, &by_position);
}

static int height_for_load(void)
{
    const kstrip_wheel_pair own = pair();
    double vertical;
    return kstrip_height_for_load(&rail, &wheel, &own, &position, 80e3, &velocity, &law, NULL, &workspace,
                                  &vertical);
}

static kstrip_wheelset wheelset(void)
{
    kstrip_wheelset set;
    memset(&set, 0, sizeof set);
    set.wheel[0] = &wheel, set.friction[0] = &law, set.friction[1] = &law;
    set.pair[0] = pair(), set.running_circles = 1.5;
    return set;
}

static const kstrip_track track = {{&rail, NULL}, 0, 0, {0.75, 0.75}, {{0, 0, 0, 0}, {0, 0, 0, 0}}};

static int wheelset_on_track(void)
{
    static kstrip_wheelset_forces forces;
    static kstrip_wheelset_derivatives derivatives;
    static kstrip_wheelset_by_position by_position;
    const kstrip_wheelset set = wheelset();
    return kstrip_wheelset_on_track(&set, &track, &position, &velocity, &both, &forces, &derivatives,
                                    &by_position);
}

static int wheelset_settle(void)
{
    static kstrip_wheelset_forces forces;
    const kstrip_wheelset_loads loads = {160e3, 0, 0};
    const kstrip_wheelset set = wheelset();
    kstrip_wheel_position where;
    kstrip_wheel_velocity moves;
    return kstrip_wheelset_settle(&set, &track, &position, &velocity, &loads, &both, &where, &moves,
                                  &forces);
}

static const kstrip_table_spec spec = {-2e-3, 3e-3, 5e-3, 0, 300e3, 9, 3, 3, 1, 16, 0};

static int table_begin(void)
{
    const kstrip_wheel_pair own = pair();
    return kstrip_table_begin(&rail, &wheel, &own, &spec, &workspace, block, bytes_of_table);
}

static int table_fill(void)
{
    const kstrip_wheel_pair own = pair();
    return kstrip_table_fill(&rail, &wheel, &own, 0, parts, &workspace, block, bytes_of_table);
}

static int table_finish(void)
{
    const kstrip_wheel_pair own = pair();
    kstrip_table_report report;
    return kstrip_table_finish(&rail, &wheel, &own, 10, &workspace, block, bytes_of_table, &report);
}

/* What a table needs before it is finished. */
static int table_filled(void)
{
    const int status = table_begin();
    return status < 0 ? status : table_fill();
}

static int wheel_on_table(void)
{
    static kstrip_wrench wrench;
    static kstrip_wrench_derivatives derivatives;
    static kstrip_wrench_by_position by_position;
    const kstrip_wheel_pair own = pair();
    kstrip_table table;
    memset(&table, 0, sizeof table);
    table.data = block, table.bytes = bytes_of_table;
    return kstrip_wheel_on_table(&table, &own, &position, &velocity, &law, &workspace, &wrench,
                                 &derivatives, &by_position);
}

/* A call, and what comes before it, on the stack of main. */
typedef struct call {
    const char *name;
    int (*of)(void);
    int (*before)(void);
    int status;
} call;

static void *run(void *argument)
{
    call *const mine = argument;
    mine->status = mine->of();
    return NULL;
}

/* Bytes that a call changed below the start of its thread's stack. */
static long used(call *one)
{
    void *room;
    long unchanged = 0;
    pthread_attr_t attributes;
    pthread_t thread;
    if (one->before && one->before() < 0)
        exit(4);
    if (posix_memalign(&room, 4096, ROOM))
        exit(2);
    memset(room, PAINT, ROOM);
    if (pthread_attr_init(&attributes) || pthread_attr_setstack(&attributes, room, ROOM) ||
        pthread_create(&thread, &attributes, run, one) || pthread_join(thread, NULL))
        exit(3);
    while (unchanged < ROOM && ((const unsigned char *)room)[unchanged] == PAINT)
        unchanged++;
    pthread_attr_destroy(&attributes);
    free(room);
    return ROOM - unchanged;
}

int main(void)
{
    call calls[] = {{"nothing", nothing, NULL, 0},
                    {"kstrip_solve", solve, NULL, 0},
                    {"kstrip_evaluate", evaluate, NULL, 0},
                    {"kstrip_evaluate_batch", evaluate_batch, NULL, 0},
                    {"kstrip_creepage_for_force", creepage_for_force, NULL, 0},
                    {"kstrip_estimate_friction", estimate_friction, NULL, 0},
                    {"kstrip_fit_friction", fit_friction, NULL, 0},
                    {"kstrip_patch_from_profile", from_profile, NULL, 0},
                    {"kstrip_patch_evaluate", evaluate_patch, NULL, 0},
                    {"kstrip_prepare_profile", prepare_profile, NULL, 0},
                    {"kstrip_wheel_on_rail", wheel_on_rail, NULL, 0},
                    {"kstrip_height_for_load", height_for_load, NULL, 0},
                    {"kstrip_wheelset_on_track", wheelset_on_track, NULL, 0},
                    {"kstrip_wheelset_settle", wheelset_settle, NULL, 0},
                    {"kstrip_table_begin", table_begin, NULL, 0},
                    {"kstrip_table_fill", table_fill, table_begin, 0},
                    {"kstrip_table_finish", table_finish, table_filled, 0},
                    {"kstrip_wheel_on_table", wheel_on_table, NULL, 0}};
    const int models[] = {KSTRIP_MODEL_TOTAL, KSTRIP_MODEL_STRIP, KSTRIP_MODEL_STRIP_1967_CONTINUOUS};
    long least = 0;
    size_t k;
    int i, m;
    for (i = 0; i < POINTS; i++) {
        y[i] = (i - POINTS / 2) * 0.3e-3;
        rail_z[i] = distance[i] = y[i] * y[i] / 0.6;
        wheel_z[i] = y[i] / -40 - y[i] * y[i];
    }
    if (kstrip_prepare_profile(y, rail_z, POINTS, 0, 0, &rail) < 0 ||
        kstrip_prepare_profile(y, wheel_z, POINTS, 0, 0, &wheel) < 0 ||
        kstrip_table_size(&wheel, &spec, &bytes_of_table, &parts) < 0 || bytes_of_table > sizeof block)
        return 1;
    for (k = 0; k < sizeof calls / sizeof *calls; k++) {
        long most = 0;
        for (m = 0; m < 9; m++) {
            long bytes;
            options.model = models[m / 3], options.strips = (const int[]){8, 32, 64}[m % 3];
            bytes = used(&calls[k]);
            most = bytes > most ? bytes : most;
            if (calls[k].status < 0) {
                fprintf(stderr, "%s: %s\n", calls[k].name, kstrip_status_string(calls[k].status));
                return 1;
            }
        }
        if (k == 0)
            least = most;
        else
            printf("%s %ld\n", calls[k].name, most - least);
    }
    return 0;
}
