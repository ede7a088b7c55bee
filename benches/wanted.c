/*
 * What scripts/instructions.sh counts for kstrip_evaluate(): each row is one entry into counted_calls(), 512 calls
 * with 16 strips for one kind of motion and one choice of what is wanted. Prints the names of the rows, in their order.
 */
#include "kstrip.h"
#include <stdio.h>
#include <stdlib.h>

enum { CALLS = 512, MOTIONS = 5, CHOICES = 6 };

static kstrip_creepage creepages[CALLS];

/* The fraction of i steps, less a half: spread evenly whatever the count. */
static double spread(int i, double step) { return i * step - (int)(i * step) - 0.5; }

/* callgrind sets its counter to zero on entry and writes it on return. */
__attribute__((noinline)) void counted_calls(const kstrip_options *options, uint32_t wanted);
void counted_calls(const kstrip_options *options, uint32_t wanted)
{
    static const kstrip_contact contact = {6e-3, 4e-3, 80e3, 82e9, 0.28, 0.3};
    static kstrip_strip strips[KSTRIP_STRIPS_CAPACITY];
    kstrip_result result;
    double jacobian[9];
    uint32_t count;
    for (int i = 0; i < CALLS; i++)
        if (kstrip_evaluate(&contact, &creepages[i], options, wanted, &result, jacobian, strips,
                            KSTRIP_STRIPS_CAPACITY, &count) < 0)
            exit(EXIT_FAILURE);
}

int main(void)
{
    static const struct {
        const char *name;
        int32_t number;
    } models[] = {{"STRIP", KSTRIP_MODEL_STRIP},
                  {"STRIP_1967", KSTRIP_MODEL_STRIP_1967},
                  {"TOTAL", KSTRIP_MODEL_TOTAL},
                  {"LINEAR", KSTRIP_MODEL_LINEAR}};
    static const char *const motions[MOTIONS] = {"any", "no_spin", "no_longitudinal", "full_sliding", "rest"};
    static const uint32_t both = KSTRIP_WANT_MOMENT | KSTRIP_WANT_ADHESION;
    const uint32_t choices[CHOICES] = {KSTRIP_WANT_FORCES, KSTRIP_WANT_MOMENT, KSTRIP_WANT_ADHESION,
                                       both, both | KSTRIP_WANT_JACOBIAN, both | KSTRIP_WANT_STRIPS};
    for (size_t m = 0; m < sizeof models / sizeof *models; m++)
        for (int motion = 0; motion < MOTIONS; motion++) {
            for (int i = 0; i < CALLS; i++) {
                const double size = motion == 3 ? 0.2 : motion == 4 ? 0 : 8e-3;
                const kstrip_creepage k = {
                    motion == 2 ? 0 : (spread(i, 0.618034) + (motion == 3)) * size,
                    spread(i, 0.381966) * size,
                    motion == 0 || motion == 2 ? spread(i, 0.271828) * 1.5 : 0};
                creepages[i] = k;
            }
            for (int choice = 0; choice < CHOICES; choice++) {
                const kstrip_options options = {models[m].number, 16};
                if (choice == 5 && m > 1)
                    continue; /* no strips */
                printf("%s %s %d\n", models[m].name, motions[motion], choice);
                counted_calls(&options, choices[choice]);
            }
        }
    return EXIT_SUCCESS;
}
