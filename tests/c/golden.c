/* Hashes over results of the same inputs on every machine. tests/golden/bits.rs has the inputs again in Rust,
 * tests/data/golden.txt the hashes that are right.
 *
 *     golden               one contact after the other
 *     golden batch         kstrip_evaluate_batch for each contact
 *     golden threads       two threads, half of the contacts each
 *
 * golden_case.h says what is hashed of a case. Inputs are quotients of integers, so that no compiler can round
 * them differently. With FIRMWARE defined only the first contacts are solved, without arguments and without
 * threads.
 */
#define _POSIX_C_SOURCE 200809L
#include "kstrip_f32.h"
#include <stdio.h>
#include <string.h>

/* Patches of profiles have fewer cells on a microcontroller: other bits, which are left out there. */
#ifdef FIRMWARE
enum { CONTACTS = 1000, HAS_PATCHES = 0 };
#else
#include <pthread.h>
enum { CONTACTS = 100000, HAS_PATCHES = 1 };
#endif
/* A hash is printed after so many contacts as well. */
enum { FIRST = 1000, BLOCK = 1000, BLOCKS = CONTACTS / BLOCK };

/* Each has its own hash. */
enum { SOLVES, PATCHES, FRICTION, SPECIAL, RIG, LAYER, FIT, KINDS };
static const char *const kinds[KINDS] = {"", " patches", " friction", " special", " rig", " layer", " fit"};

static uint64_t mixed(uint64_t hash, uint64_t bits)
{
    return (hash ^ bits) * 0x100000001b3U; /* FNV-1a, 64 bits at a time */
}

/* Whether a contact has more than solves: of a hundred five, one for each model. */
static int has_field(uint32_t i)
{
    return i % 100 < 5;
}

/* Whether it has the rest: the same of the first thousand, later of two thousand five. */
static int has_rest(uint32_t i)
{
    return has_field(i) && (i < 1000 || i % 2000 < 5);
}

/* Whether a law is fitted to its forces, a hundred solutions: of the first thousand of every fifth five
 * that have the rest. */
static int has_fit(uint32_t i)
{
    return has_rest(i) && i % 500 < 5;
}

/* Integers for case i. */
static uint32_t draw(uint32_t i, uint32_t salt, uint32_t below)
{
    uint32_t x = i * 2654435761u + salt * 2246822519u;
    x = (x ^ x >> 15) * 2246822519u;
    x = (x ^ x >> 13) * 3266489917u;
    return (x ^ x >> 16) % below;
}

static double creep(uint32_t i, uint32_t salt, double unit)
{
    /* zero, or of a size over four decades */
    static const double sizes[5] = {1, 10, 100, 1000, 10000};
    const double whole = (double)draw(i, salt, 2001) - 1000;
    return draw(i, salt + 1, 8) == 0 ? 0 : whole / (unit * sizes[draw(i, salt + 2, 5)]);
}

static void inputs(uint32_t i, kstrip_contact *c, kstrip_creepage *k, kstrip_options *o)
{
    c->a = (1 + draw(i, 1, 200)) / 20000.0;
    c->b = (1 + draw(i, 2, 200)) / 20000.0;
    c->normal_force = (double)(1000 + draw(i, 3, 200000));
    c->shear_modulus = (1 + draw(i, 4, 100)) * 1e9;
    c->poisson_ratio = draw(i, 5, 101) / 200.0;
    c->friction = (1 + draw(i, 6, 100)) / 100.0;
    c->mismatch = 0;
    k->longitudinal = creep(i, 7, 1000);
    k->lateral = creep(i, 10, 1000);
    k->spin = creep(i, 13, 10);
    o->model = 1 + (int32_t)(i % 5);
    o->strips = 4 << draw(i, 16, 5);
}

#define REAL double
#define BITS uint64_t
#define NAME(x) x
#include "golden_case.h"
#undef REAL
#undef BITS
#undef NAME
#define REAL float
#define BITS uint32_t
#define NAME(x) x##_f32
#include "golden_case.h"

/* One hash per block, so that threads may take blocks in any order. */
static uint64_t blocks[2][BLOCKS][KINDS];

static void solve_block(int block, int batch)
{
    uint64_t *const two = blocks[0][block], *const one = blocks[1][block];
    uint32_t i;
    int kind;
    for (kind = 0; kind < KINDS; kind++)
        two[kind] = one[kind] = 0xcbf29ce484222325U;
    for (i = (uint32_t)block * BLOCK; i < (uint32_t)(block + 1) * BLOCK; i++) {
        hash_case(two, i, batch);
        hash_case_f32(one, i, batch);
    }
}

static void print(int count)
{
    static const char *const precisions[2] = {"double", "single"};
    int precision, kind, i;
    for (precision = 0; precision < 2; precision++) {
        for (kind = 0; kind < KINDS; kind++) {
            uint64_t hash = 0xcbf29ce484222325U;
            for (i = 0; i < count; i++)
                hash = mixed(hash, blocks[precision][i][kind]);
            printf("%s%s %d %08lx%08lx\n", precisions[precision], kinds[kind], count * BLOCK,
                   (unsigned long)(hash >> 32), (unsigned long)(hash & 0xffffffffU));
        }
    }
}

#ifdef FIRMWARE
int main(void)
{
    solve_block(0, 0);
#else
static void *half(void *start)
{
    int block;
    for (block = *(const int *)start; block < BLOCKS; block += 2)
        solve_block(block, 0);
    return NULL;
}

int main(int count, char **arguments)
{
    const int batch = count > 1 && strcmp(arguments[1], "batch") == 0;
    if (count > 1 && !batch) {
        static const int starts[2] = {0, 1};
        pthread_t thread;
        if (pthread_create(&thread, NULL, half, (void *)&starts[1]))
            return 1;
        half((void *)&starts[0]);
        if (pthread_join(thread, NULL))
            return 1;
    } else {
        int block;
        for (block = 0; block < BLOCKS; block++)
            solve_block(block, batch);
    }
    print(BLOCKS);
#endif
    print(FIRST / BLOCK);
    return 0;
}
