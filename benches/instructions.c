/*
 * What scripts/instructions.sh counts: each row is one entry into counted_calls(), 512 calls of the C
 * interface over creepages from partial slip to sliding. Prints the names of the rows, in their order.
 */
#include "kstrip.h"
#include <stdio.h>
#include <stdlib.h>

enum { CALLS = 512 };
enum { SOLVE, JACOBIAN, BATCH };

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
static kstrip_contact_f32 contacts_f32[CALLS];
static kstrip_creepage_f32 creepages_f32[CALLS];

/* The fraction of i steps, less a half: spread evenly whatever the count. */
static double spread(int i, double step) { return i * step - (int)(i * step) - 0.5; }

static void check(kstrip_status status)
{
    if (status < 0)
        exit(EXIT_FAILURE);
}

/* callgrind sets its counter to zero on entry and writes it on return. */
__attribute__((noinline)) void counted_calls(int kind, int is_f32, const kstrip_options *options);
void counted_calls(int kind, int is_f32, const kstrip_options *options)
{
    static kstrip_result results[CALLS];
    static kstrip_result_f32 results_f32[CALLS];
    double slopes[9];
    float slopes_f32[9];
    if (kind == BATCH) {
        if (is_f32)
            check(kstrip_solve_batch_f32(contacts_f32, creepages_f32, CALLS, options, results_f32));
        else
            check(kstrip_solve_batch(contacts, creepages, CALLS, options, results));
        return;
    }
    for (int i = 0; i < CALLS; i++) {
        const kstrip_creepage *const motion = &creepages[i];
        const kstrip_creepage_f32 *const motion_f32 = &creepages_f32[i];
        if (kind == SOLVE && !is_f32)
            check(kstrip_solve(contacts, motion, options, results));
        else if (kind == SOLVE)
            check(kstrip_solve_f32(contacts_f32, motion_f32, options, results_f32));
        else if (!is_f32)
            check(kstrip_solve_jacobian(contacts, motion, options, results, slopes));
        else
            check(kstrip_solve_jacobian_f32(contacts_f32, motion_f32, options, results_f32,
                                            slopes_f32));
    }
}

int main(void)
{
    for (int i = 0; i < CALLS; i++) {
        const kstrip_contact c = {6e-3, 4e-3, 80e3, 82e9, 0.28, 0.3};
        const kstrip_contact_f32 d = {6e-3F, 4e-3F, 80e3F, 82e9F, 0.28F, 0.3F};
        const kstrip_creepage k = {spread(i, 0.618034) * 8e-3, spread(i, 0.381966) * 8e-3,
                                   spread(i, 0.271828) * 1.5};
        const kstrip_creepage_f32 l = {(float)k.longitudinal, (float)k.lateral, (float)k.spin};
        contacts[i] = c, contacts_f32[i] = d, creepages[i] = k, creepages_f32[i] = l;
    }
    static const char *const kinds[] = {"solve", "jacobian", "batch"};
    for (size_t m = 0; m < sizeof models / sizeof *models; m++)
        for (int is_f32 = 0; is_f32 < 2; is_f32++)
            for (int kind = SOLVE; kind <= BATCH; kind++)
                for (int32_t strips = 4; strips <= 64; strips *= 2) {
                    const int32_t number = models[m].number;
                    const int has_strips =
                        number != KSTRIP_MODEL_TOTAL && number != KSTRIP_MODEL_LINEAR;
                    if (strips != 16 && (kind != SOLVE || !has_strips))
                        continue;
                    const kstrip_options options = {number, strips};
                    printf("%s %s %s %d\n", models[m].name, is_f32 ? "f32" : "f64", kinds[kind],
                           has_strips ? (int)strips : 0);
                    counted_calls(kind, is_f32, &options);
                }
    return EXIT_SUCCESS;
}
