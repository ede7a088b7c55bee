/*
 * What scripts/instructions.sh counts: each row is one entry into counted_calls(), 512 calls of the C
 * interface at creepages from partial slip to sliding. Prints the names of the rows, in their order.
 */
#include "kstrip_f32.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CALLS = 512 };
enum {
    SOLVE, EVALUATE, DERIVATIVES, FALLING, FALLING_DERIVATIVES, LAYER, LAYER_DERIVATIVES, PREPARED,
    BATCH, BATCH_DERIVATIVES, BATCH_FALLING, BATCH_FALLING_DERIVATIVES, KINDS
};
/* of a profile with two bottoms, and of its patch */
enum {
    FROM_PROFILE = KINDS, PATCH, PATCH_DERIVATIVES, WHEEL_FORCES, WHEEL_HEIGHT, WHEEL_ON_RAIL, WHEEL_BY_POSITION, WHEELSET,
    WHEELSET_BY_POSITION, TABLE_FORCES, ON_TABLE, TABLE_BY_POSITION, OF_PATCHES
};
/* bottoms of a wheel's profile: none, two in one contact, three in one contact and in three, each by a share */
enum { FLAT, TWO_BOTTOMS, THREE_BOTTOMS, SHAPES };
/* Wheels are computed for the first of the creepages only. */
enum { CALLS_OF_WHEELS = 32 };
enum { POINTS = 400 };

static const struct {
    const char *name;
    int32_t number;
} models[] = {
    {"STRIP_1967", KSTRIP_MODEL_STRIP_1967},
    {"STRIP_1967_CONTINUOUS", KSTRIP_MODEL_STRIP_1967_CONTINUOUS},
    {"STRIP", KSTRIP_MODEL_STRIP},
    {"TOTAL", KSTRIP_MODEL_TOTAL},
    {"LINEAR", KSTRIP_MODEL_LINEAR},
};

static kstrip_contact contacts[CALLS];
static kstrip_creepage creepages[CALLS];
/* falling friction, at 20 m/s */
static const kstrip_friction law = {0.3, 0.4, 0.6, 20, 1};
static const kstrip_friction_f32 law_f32 = {0.3F, 0.4F, 0.6F, 20, 1};
/* constant friction behind a layer about as flexible as the bodies */
static const kstrip_friction layer = {.friction = 0.3, .ratio = 1, .layer = 4e-14};
static const kstrip_friction_f32 layer_f32 = {.friction = 0.3F, .ratio = 1, .layer = 4e-14F};
static int falls(int kind)
{
    return kind == FALLING || kind == FALLING_DERIVATIVES || kind == BATCH_FALLING || kind == BATCH_FALLING_DERIVATIVES;
}
static int differentiates(int kind)
{
    return kind == DERIVATIVES || kind == FALLING_DERIVATIVES || kind == LAYER_DERIVATIVES || kind == BATCH_DERIVATIVES || kind == BATCH_FALLING_DERIVATIVES;
}
static int has_layer(int kind) { return kind == LAYER || kind == LAYER_DERIVATIVES; }
static kstrip_contact_f32 contacts_f32[CALLS];
static kstrip_creepage_f32 creepages_f32[CALLS];

/* The fraction of i steps, less a half: spread evenly whatever the count. */
static double spread(int i, double step) { return i * step - (int)(i * step) - 0.5; }

static void check(kstrip_status status)
{
    if (status < 0)
        exit(EXIT_FAILURE);
}

static kstrip_patch patch;

/* A patch from 400 points: a parabola, or two bottoms 12 mm apart. */
static void press(int two, kstrip_patch *to)
{
    static double y[POINTS], distance[POINTS];
    const kstrip_profile profile = {y, distance, NULL, NULL, POINTS, 0};
    const kstrip_profile_contact contact = {0.46, 80e3, 0, 0, 82e9, 0.28, 0.3, 16, 0};
    for (int i = 0; i < POINTS; i++) {
        const double s = (y[i] = (i - 199.5) * 125e-6) / 6e-3;
        distance[i] = y[i] * y[i] / 0.6 + two * 90e-6 * (s * s - 1) * (s * s - 1);
    }
    check(kstrip_patch_from_profile(&profile, &contact, to, NULL));
}

/* A wheel on a round rail of 400 points each. Without or with two bottoms there is the same gap between them as above; three are 8 mm apart. */
static kstrip_surface rail, wheel;
static kstrip_wheel_workspace workspace;
static const kstrip_wheel_pair pair = {.wheel_radius = 0.46, .shear_modulus = 82e9, .poisson_ratio = 0.28, .friction = 0.3};
static kstrip_wheel_position position;
static double load;

static void place(int shape)
{
    static double y[POINTS], below[POINTS], bumps[POINTS];
    for (int i = 0; i < POINTS; i++) {
        const double s = (y[i] = (i - 199.5) * 125e-6) / 6e-3, r = y[i] / 8e-3, t = r > 1.3 ? 1.3 : r < -1.3 ? -1.3 : r;
        below[i] = y[i] * y[i] / 0.6;
        bumps[i] = shape == TWO_BOTTOMS ? -90e-6 * (s * s - 1) * (s * s - 1) : 0;
        if (shape == THREE_BOTTOMS)
            bumps[i] = below[i] + 30e-6 * t - 1.3e-3 * t * t * (t * t - 1) * (t * t - 1);
    }
    check(kstrip_prepare_profile(y, below, POINTS, 0, 0, &rail));
    check(kstrip_prepare_profile(y, bumps, POINTS, 0, 0, &wheel));
    load = shape == THREE_BOTTOMS ? 40e3 : 80e3;
    check(kstrip_height_for_load(&rail, &wheel, &pair, &position, load, NULL, NULL, NULL, &workspace, &position.vertical));
}

/* Contact tables of the wheels of each shape. */
static kstrip_table tables[SHAPES];

static void fill(kstrip_table *table)
{
    const kstrip_table_spec spec = {.lateral_from = -1e-3, .lateral_to = 1e-3, .load = 120e3, .lateral_nodes = 9, .levels = 6};
    uint32_t bytes, parts;
    kstrip_table_report report;
    check(kstrip_table_size(&wheel, &spec, &bytes, &parts));
    uint8_t *block = malloc(bytes);
    if (!block)
        exit(EXIT_FAILURE);
    check(kstrip_table_begin(&rail, &wheel, &pair, &spec, &workspace, block, bytes));
    check(kstrip_table_fill(&rail, &wheel, &pair, 0, parts, &workspace, block, bytes));
    check(kstrip_table_finish(&rail, &wheel, &pair, 0, &workspace, block, bytes, &report));
    *table = (kstrip_table){.data = block, .bytes = report.bytes};
}

/* callgrind sets its counter to zero on entry and writes it on return. */
__attribute__((noinline)) void counted_calls(int kind, const kstrip_options *options);
void counted_calls(int kind, const kstrip_options *options)
{
    static kstrip_result results[CALLS];
    static kstrip_derivatives derivatives[CALLS];
    const ptrdiff_t c = sizeof *contacts, k = sizeof *creepages, r = sizeof *results;
    const kstrip_batch_inputs from = {
        &contacts->a, c, &contacts->b, c, &contacts->normal_force, c, &contacts->shear_modulus, c,
        &contacts->poisson_ratio, c, &contacts->friction, c, NULL, 0, &creepages->longitudinal, k,
        &creepages->lateral, k, &creepages->spin, k, falls(kind) ? &law : NULL, 0};
    kstrip_batch_outputs to = {&results->fx, r, &results->fy, r, &results->mz, r,
                                     &results->power, r, &results->adhesion, r,
                                     &results->status_detail, r, NULL, 0, NULL, 0, NULL, 0};
    kstrip_outputs outputs;
    kstrip_prepared prepared;
    memset(&outputs, 0, sizeof outputs);
    outputs.result = results;
    outputs.derivatives = differentiates(kind) ? derivatives : NULL;
    if (differentiates(kind)) {
        to.derivatives = derivatives;
        to.derivatives_stride = sizeof *derivatives;
    }
    if (kind >= WHEEL_FORCES) {
        static kstrip_wrench wrench;
        static kstrip_wrench_derivatives slopes;
        static kstrip_wrench_by_position by_position;
        static kstrip_wheelset_workspace both;
        static kstrip_wheelset_forces forces;
        static kstrip_wheelset_derivatives by;
        static kstrip_wheelset_by_position moved;
        const kstrip_wheelset set = {.wheel = {&wheel}, .back_to_back = 1.36, .pair = {pair}};
        const kstrip_track track = {.rail = {&rail}, .origin = {0.75, 0.75}};
        for (int i = 0; i < CALLS_OF_WHEELS; i++) {
            const kstrip_wheel_velocity velocity = {.forward = 20, .pitch = -(1 + creepages[i].longitudinal) * 20 / 0.46};
            if (kind == WHEEL_HEIGHT) {
                double height;
                check(kstrip_height_for_load(&rail, &wheel, &pair, &position, load, NULL, NULL, NULL, &workspace, &height));
            } else if (kind >= TABLE_FORCES)
                check(kstrip_wheel_on_table(&tables[options->strips], &pair, &position, &velocity, NULL, &workspace, &wrench,
                                            kind == TABLE_FORCES ? NULL : &slopes,
                                            kind == TABLE_BY_POSITION ? &by_position : NULL));
            else if (kind < WHEELSET)
                check(kstrip_wheel_on_rail(&rail, &wheel, &pair, &position, &velocity, NULL, &workspace, &wrench,
                                           kind == WHEEL_FORCES ? NULL : &slopes,
                                           kind == WHEEL_BY_POSITION ? &by_position : NULL));
            else
                check(kstrip_wheelset_on_track(&set, &track, &position, &velocity, &both, &forces, &by,
                                               kind == WHEELSET_BY_POSITION ? &moved : NULL));
        }
        return;
    }
    if (kind >= FROM_PROFILE) {
        /* (without strip count: two bottoms) */
        const int two = options->strips == 0;
        outputs.derivatives = kind == PATCH_DERIVATIVES ? derivatives : NULL;
        for (int i = 0; i < CALLS; i++) {
            if (kind == FROM_PROFILE)
                press(two, &patch);
            else
                check(kstrip_patch_evaluate(&patch, &creepages[i], NULL, options, &outputs));
        }
        return;
    }
    if (kind >= BATCH) {
        check(kstrip_evaluate_batch(&from, CALLS, options, &to, NULL));
        return;
    }
    if (kind == PREPARED)
        check(kstrip_prepare(contacts, options, &prepared));
    for (int i = 0; i < CALLS; i++) {
        if (kind == SOLVE)
            check(kstrip_solve(contacts, &creepages[i], options, results));
        else if (kind == PREPARED)
            check(kstrip_solve_prepared(&prepared, &creepages[i], results));
        else
            check(kstrip_evaluate(contacts, &creepages[i], has_layer(kind) ? &layer : falls(kind) ? &law : NULL, options, &outputs));
    }
}

/* The same in single precision. */
__attribute__((noinline)) void counted_calls_f32(int kind, const kstrip_options *options);
void counted_calls_f32(int kind, const kstrip_options *options)
{
    static kstrip_result_f32 results[CALLS];
    static kstrip_derivatives_f32 derivatives[CALLS];
    const ptrdiff_t c = sizeof *contacts_f32, k = sizeof *creepages_f32, r = sizeof *results;
    const kstrip_batch_inputs_f32 from = {
        &contacts_f32->a, c, &contacts_f32->b, c, &contacts_f32->normal_force, c,
        &contacts_f32->shear_modulus, c, &contacts_f32->poisson_ratio, c, &contacts_f32->friction, c, NULL, 0,
        &creepages_f32->longitudinal, k, &creepages_f32->lateral, k, &creepages_f32->spin, k,
        falls(kind) ? &law_f32 : NULL, 0};
    kstrip_batch_outputs_f32 to = {&results->fx, r, &results->fy, r, &results->mz, r,
                                         &results->power, r, &results->adhesion, r,
                                         &results->status_detail, r, NULL, 0, NULL, 0, NULL, 0};
    kstrip_outputs_f32 outputs;
    kstrip_prepared_f32 prepared;
    memset(&outputs, 0, sizeof outputs);
    outputs.result = results;
    outputs.derivatives = differentiates(kind) ? derivatives : NULL;
    if (differentiates(kind)) {
        to.derivatives = derivatives;
        to.derivatives_stride = sizeof *derivatives;
    }
    if (kind >= BATCH) {
        check(kstrip_evaluate_batch_f32(&from, CALLS, options, &to, NULL));
        return;
    }
    if (kind == PREPARED)
        check(kstrip_prepare_f32(contacts_f32, options, &prepared));
    for (int i = 0; i < CALLS; i++) {
        if (kind == SOLVE)
            check(kstrip_solve_f32(contacts_f32, &creepages_f32[i], options, results));
        else if (kind == PREPARED)
            check(kstrip_solve_prepared_f32(&prepared, &creepages_f32[i], results));
        else
            check(kstrip_evaluate_f32(contacts_f32, &creepages_f32[i], has_layer(kind) ? &layer_f32 : falls(kind) ? &law_f32 : NULL, options, &outputs));
    }
}

int main(void)
{
    for (int i = 0; i < CALLS; i++) {
        const kstrip_contact c = {6e-3, 4e-3, 80e3, 82e9, 0.28, 0.3, 0};
        const kstrip_contact_f32 d = {6e-3F, 4e-3F, 80e3F, 82e9F, 0.28F, 0.3F, 0};
        const kstrip_creepage k = {spread(i, 0.618034) * 8e-3, spread(i, 0.381966) * 8e-3,
                                   spread(i, 0.271828) * 1.5};
        const kstrip_creepage_f32 l = {(float)k.longitudinal, (float)k.lateral, (float)k.spin};
        contacts[i] = c, contacts_f32[i] = d, creepages[i] = k, creepages_f32[i] = l;
    }
    static const char *const kinds[] = {"solve", "evaluate", "derivatives", "falling", "falling_derivatives",
                                        "layer", "layer_derivatives", "prepared", "batch",
                                        "batch_derivatives", "batch_falling", "batch_falling_derivatives"};
    for (size_t m = 0; m < sizeof models / sizeof *models; m++)
        for (int is_f32 = 0; is_f32 < 2; is_f32++)
            for (int kind = SOLVE; kind < KINDS; kind++)
                for (int32_t strips = 4; strips <= 64; strips *= 2) {
                    const int32_t number = models[m].number;
                    const int has_strips =
                        number != KSTRIP_MODEL_TOTAL && number != KSTRIP_MODEL_LINEAR;
                    if (strips != 16 && (kind != SOLVE || !has_strips))
                        continue;
                    const kstrip_options options = {number, strips};
                    printf("%s %s %s %d\n", models[m].name, is_f32 ? "f32" : "f64", kinds[kind],
                           has_strips ? (int)strips : 0);
                    (is_f32 ? counted_calls_f32 : counted_calls)(kind, &options);
                }
    static const char *const of_patches[] = {"from_profile", "patch", "patch_derivatives", "wheel_forces", "wheel_height", "wheel_on_rail",
                                             "wheel_by_position", "wheelset", "wheelset_by_position", "wheel_table_forces",
                                             "wheel_table", "wheel_table_by_position"};
    static const char *const shapes[] = {"one_zone", "two_zones", "three_contacts"};
    for (int kind = FROM_PROFILE; kind < OF_PATCHES; kind++)
        for (int shape = FLAT; shape < SHAPES; shape++) {
            /* (a wheel takes none; that of a table has its number here) */
            const kstrip_options options = {KSTRIP_MODEL_STRIP, kind >= TABLE_FORCES ? shape : shape == FLAT ? 16 : 0};
            if (shape == THREE_BOTTOMS && (kind < WHEEL_FORCES || kind == WHEELSET || kind == WHEELSET_BY_POSITION))
                continue;
            printf("STRIP f64 %s_%s 16\n", of_patches[kind - FROM_PROFILE], shapes[shape]);
            if (kind >= WHEEL_FORCES)
                place(shape);
            if (kind == TABLE_FORCES)
                fill(&tables[shape]);
            if (kind < WHEEL_FORCES)
                press(shape == TWO_BOTTOMS, &patch);
            counted_calls(kind, &options);
        }
    return EXIT_SUCCESS;
}
