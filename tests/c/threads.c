/* Four threads solve the same contacts at the same time; every bit must be the same. */
#define _POSIX_C_SOURCE 200809L
#include "kstrip.h"
#include <pthread.h>
#include <stdio.h>
#include <string.h>

enum { THREADS = 4, CASES = 4096 };

typedef struct work {
    pthread_t thread;
    int error;
    kstrip_result results[CASES];
} work;

static work all[THREADS];

/* Quotients of integers: the same numbers on every machine. */
static void *run(void *argument)
{
    work *const mine = argument;
    for (int i = 0; i < CASES; i++) {
        const kstrip_contact contact = {6e-3, (1 + i % 7) / 700.0, 80e3, 82e9, i % 6 / 10.0, 0.3, 0};
        const kstrip_creepage creepage = {(i % 16 - 7) / 4000.0, (i / 16 % 16 - 7) / 4000.0,
                                          (i / 256 - 7) / 8.0};
        const kstrip_options options = {1 + i % 5, 4 << i / 5 % 5};
        const kstrip_status status = kstrip_solve(&contact, &creepage, &options, &mine->results[i]);
        if (status < 0)
            mine->error = status;
    }
    return NULL;
}

int main(void)
{
    int differing = 0;
    for (int t = 0; t < THREADS; t++)
        if (pthread_create(&all[t].thread, NULL, run, &all[t]))
            return 1;
    for (int t = 0; t < THREADS; t++)
        if (pthread_join(all[t].thread, NULL) || all[t].error)
            return 2;
    for (int t = 1; t < THREADS; t++)
        for (int i = 0; i < CASES; i++)
            differing += memcmp(&all[t].results[i], &all[0].results[i], sizeof(kstrip_result)) != 0;

    /* FNV-1a over the bits of the numbers, 64 at a time */
    uint64_t hash = 0xcbf29ce484222325U;
    for (int i = 0; i < CASES; i++) {
        const double *const numbers = &all[0].results[i].fx; /* fx, fy, mz, power, adhesion */
        for (int k = 0; k < 5; k++) {
            uint64_t bits;
            memcpy(&bits, (const char *)numbers + (size_t)k * sizeof bits, sizeof bits);
            hash = (hash ^ bits) * 0x100000001b3U;
        }
    }
    printf("threads %d cases %d differing %d hash %08lx%08lx\n", THREADS, CASES, differing,
           (unsigned long)(hash >> 32), (unsigned long)(hash & 0xffffffffU));
    return 0;
}
