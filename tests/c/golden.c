/* Hashes over results of the same inputs on every machine. tests/golden.rs has the inputs again in Rust,
 * tests/data/golden.txt the hashes that are right.
 *
 *     golden               one contact after the other
 *     golden batch         kstrip_solve_batch where it answers the same question
 *     golden threads       two threads, half of the contacts each
 *
 * Inputs are quotients of integers, so that no compiler can round them differently. With FIRMWARE defined only
 * the first contacts are solved, without arguments and without threads.
 */
#define _POSIX_C_SOURCE 200809L
#include "kstrip.h"
#include <stdio.h>
#include <string.h>

#ifdef FIRMWARE
enum { CONTACTS = 1000 };
#else
#include <pthread.h>
enum { CONTACTS = 100000 };
#endif
/* A hash is printed after so many contacts as well. */
enum { FIRST = 1000, BLOCK = 1000, BLOCKS = CONTACTS / BLOCK };

static uint64_t mixed(uint64_t hash, uint64_t bits)
{
    return (hash ^ bits) * 0x100000001b3U; /* FNV-1a, 64 bits at a time */
}

static uint64_t mixed_double(uint64_t hash, double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return mixed(hash, bits);
}

static uint64_t mixed_float(uint64_t hash, float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return mixed(hash, bits);
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
    k->longitudinal = creep(i, 7, 1000);
    k->lateral = creep(i, 10, 1000);
    k->spin = creep(i, 13, 10);
    o->model = 1 + (int32_t)(i % 5);
    o->strips = 4 << draw(i, 16, 5);
}

#define HASH_RESULT(number)                                                                        \
    do {                                                                                           \
        hash = mixed(hash, (uint32_t)status);                                                      \
        hash = number(hash, r.fx);                                                                 \
        hash = number(hash, r.fy);                                                                 \
        hash = number(hash, r.mz);                                                                 \
        hash = number(hash, r.power);                                                              \
        hash = number(hash, r.adhesion);                                                           \
    } while (0)

/* Five of a hundred cases, one of each model, also give derivatives and three points of the field. */
#define HASH_MORE(suffix, real, number)                                                            \
    do {                                                                                           \
        real jacobian[9];                                                                          \
        int n;                                                                                     \
        hash = mixed(hash, (uint32_t)kstrip_solve_jacobian##suffix(&c, &k, &o, &r, jacobian));     \
        for (n = 0; n < 9; n++)                                                                    \
            hash = number(hash, jacobian[n]);                                                      \
        for (n = 0; n < 3; n++) {                                                                  \
            kstrip_point##suffix p;                                                                \
            const kstrip_status s = kstrip_traction_at##suffix(                                    \
                &c, &k, &o, c.a * (real)(n - 1) / 2, c.b * (real)(n - 1) / 4, &p);                 \
            hash = mixed(hash, (uint32_t)s);                                                       \
            if (s >= 0) {                                                                          \
                hash = number(hash, p.pressure);                                                   \
                hash = number(hash, p.traction_x);                                                 \
                hash = number(hash, p.traction_y);                                                 \
                hash = number(hash, p.slip_x);                                                     \
                hash = number(hash, p.slip_y);                                                     \
                hash = mixed(hash, (uint32_t)p.state);                                             \
            }                                                                                      \
        }                                                                                          \
    } while (0)

static uint64_t case_double(uint64_t hash, uint32_t i, int batch)
{
    kstrip_contact c;
    kstrip_creepage k;
    kstrip_options o;
    kstrip_result r;
    kstrip_status status;
    inputs(i, &c, &k, &o);
    status = batch ? kstrip_solve_batch(&c, &k, 1, &o, &r) : kstrip_solve(&c, &k, &o, &r);
    HASH_RESULT(mixed_double);
    if (i % 100 < 5)
        HASH_MORE(, double, mixed_double);
    return hash;
}

static uint64_t case_single(uint64_t hash, uint32_t i, int batch)
{
    kstrip_contact d;
    kstrip_creepage e;
    kstrip_options o;
    kstrip_result_f32 r;
    kstrip_status status;
    inputs(i, &d, &e, &o);
    {
        const kstrip_contact_f32 c = {(float)d.a, (float)d.b, (float)d.normal_force,
                                      (float)d.shear_modulus, (float)d.poisson_ratio, (float)d.friction};
        const kstrip_creepage_f32 k = {(float)e.longitudinal, (float)e.lateral, (float)e.spin};
        status = batch ? kstrip_solve_batch_f32(&c, &k, 1, &o, &r) : kstrip_solve_f32(&c, &k, &o, &r);
        HASH_RESULT(mixed_float);
        if (i % 100 < 5)
            HASH_MORE(_f32, float, mixed_float);
    }
    return hash;
}

/* One hash per block, so that threads may take blocks in any order. */
static uint64_t blocks[2][BLOCKS];

static void solve_block(int block, int batch)
{
    uint32_t i;
    uint64_t two = 0xcbf29ce484222325U, one = two;
    for (i = (uint32_t)block * BLOCK; i < (uint32_t)(block + 1) * BLOCK; i++) {
        two = case_double(two, i, batch);
        one = case_single(one, i, batch);
    }
    blocks[0][block] = two;
    blocks[1][block] = one;
}

static void print(const char *name, const uint64_t *hashes, int count)
{
    uint64_t hash = 0xcbf29ce484222325U;
    int i;
    for (i = 0; i < count; i++)
        hash = mixed(hash, hashes[i]);
    printf("%s %d %08lx%08lx\n", name, count * BLOCK, (unsigned long)(hash >> 32),
           (unsigned long)(hash & 0xffffffffU));
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
    print("double", blocks[0], BLOCKS);
    print("single", blocks[1], BLOCKS);
#endif
    print("double", blocks[0], FIRST / BLOCK);
    print("single", blocks[1], FIRST / BLOCK);
    return 0;
}
