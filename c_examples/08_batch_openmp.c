/*
 * Many contacts on several threads, which share nothing: prints contacts per second, and checks that every bit is that of kstrip_solve().
 *
 *   cc -std=c99 -O2 -fopenmp -Iinclude c_examples/08_batch_openmp.c target/lib/libkstrip.a \
 *      -o batch && ./batch [contacts]
 */
#include "kstrip.h"
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PIECE = 1000, ROUNDS = 5 }; /* contacts per batch call; rounds, of which the best counts */

static kstrip_contact *contacts;
static kstrip_creepage *creepages;
static kstrip_result *scalar, *results;

static void check(kstrip_status status)
{
    if (status >= 0) /* a warning: the results are valid */
        return;
    fprintf(stderr, "kstrip: %s\n", kstrip_status_string(status));
    exit(EXIT_FAILURE);
}

/* One after the other, on one thread. */
static void solve_scalar(int count)
{
    for (int i = 0; i < count; i++)
        check(kstrip_solve(&contacts[i], &creepages[i], NULL, &scalar[i]));
}

/* In pieces, each solved by whichever thread is free. */
static void solve_batch(int count, int threads)
{
#pragma omp parallel for num_threads(threads) schedule(dynamic)
    for (int i = 0; i < count; i += PIECE) {
        const uint32_t length = (uint32_t)(count - i < PIECE ? count - i : PIECE);
        const kstrip_contact *c = &contacts[i];
        const kstrip_creepage *k = &creepages[i];
        kstrip_result *r = &results[i];
        const ptrdiff_t of_c = sizeof *c, of_k = sizeof *k, of_r = sizeof *r; /* distances from one to the next [bytes] */
        const kstrip_batch_inputs from = {&c->a, of_c, &c->b, of_c, &c->normal_force, of_c,
                                          &c->shear_modulus, of_c, &c->poisson_ratio, of_c,
                                          &c->friction, of_c, NULL, 0, &k->longitudinal, of_k,
                                          &k->lateral, of_k, &k->spin, of_k, NULL, 0};
        const kstrip_batch_outputs to = {&r->fx, of_r, &r->fy, of_r, &r->mz, of_r, &r->power, of_r,
                                         &r->adhesion, of_r, &r->status_detail, of_r,
                                         NULL, 0, NULL, 0, NULL, 0};
        check(kstrip_evaluate_batch(&from, length, NULL, &to, NULL));
    }
}

int main(int argc, char **argv)
{
    const int count = argc > 1 ? atoi(argv[1]) : 200000;
    const size_t n = count > 0 ? (size_t)count : 0;
    contacts = malloc(n * sizeof *contacts);
    creepages = malloc(n * sizeof *creepages);
    scalar = malloc(n * sizeof *scalar);
    results = malloc(n * sizeof *results);
    if (n == 0 || !contacts || !creepages || !scalar || !results)
        return fprintf(stderr, "how many contacts? (and memory for them)\n"), EXIT_FAILURE;
    for (int i = 0; i < count; i++) {
        /* a, b [m], load [N], shear modulus [Pa], Poisson's ratio, friction */
        const kstrip_contact contact = {6e-3, (1 + i % 7) / 700.0, 80e3, 82e9, 0.28, 0.3, 0};
        const kstrip_creepage creepage = {(i % 101 - 50) / 2e4, (i % 103 - 51) / 2e4,
                                          (i % 107 - 53) / 50.0}; /* [-], [-], [1/m] */
        contacts[i] = contact, creepages[i] = creepage;
    }

    int differing = 0;
    for (int threads = 0; threads <= 2; threads++) { /* 0: without batch */
        double best = 1e300;
        memset(results, 0, n * sizeof *results);
        for (int round = 0; round < ROUNDS; round++) {
            const double start = omp_get_wtime();
            threads == 0 ? solve_scalar(count) : solve_batch(count, threads);
            const double seconds = omp_get_wtime() - start;
            best = seconds < best ? seconds : best;
        }
        printf("threads %d: %.3e contacts per second", threads, count / best);
        for (int i = 0; i < count && threads > 0; i++) /* whole structures: they have no gaps */
            differing += memcmp(&results[i], &scalar[i], sizeof *results) != 0;
        printf(threads == 0 ? " (kstrip_solve, no batch)\n" : ", %d differ so far\n", differing);
    }
    free(contacts), free(creepages), free(scalar), free(results);
    return differing ? EXIT_FAILURE : EXIT_SUCCESS;
}
