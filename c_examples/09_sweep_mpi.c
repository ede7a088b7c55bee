/*
 * A map of creepage, spin and shape of the contact, computed on several machines: 10^7 cases, one CSV file.
 *
 *   mpicc -std=c99 -O2 -Iinclude c_examples/09_sweep_mpi.c target/lib/libkstrip.a -lm -o sweep
 *   mpirun -n 2 ./sweep map.csv [directions]
 *
 * 10 000 cells, one row each (1.5 MB): shape a/b, spin psi, size of the creepage |(xi, eta)|.
 * A cell sums up cases that differ in the direction of the creepage, 1000 unless the second argument says otherwise.
 * One process solves a cell and the others add zero, so that the file has the same bits however many processes run.
 */
#include "kstrip.h"
#include <math.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

enum { SHAPES = 20, SPINS = 20, SIZES = 25, CELLS = SHAPES * SPINS * SIZES };

/* One row: what names the cell, then means (least, most) over its directions. Force in units of
   friction times load, moment in those times sqrt(ab), share of the contact in adhesion. */
enum { SHAPE, SPIN, SIZE, FORCE, LEAST, MOST, MOMENT, STICK, NUMBERS };
static const char titles[] = "a_over_b,psi,creepage,force,force_least,force_most,moment,stick";
static const kstrip_options strips = {KSTRIP_MODEL_STRIP, 0}; /* it computes the stick area */
static double mine[CELLS][NUMBERS], rows[CELLS][NUMBERS];

static void check(int good, const char *message)
{
    if (!good && fprintf(stderr, "sweep: %s\n", message))
        MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
}

static void solve_cell(int cell, int directions, double *row)
{
    row[SHAPE] = pow(10, 2.0 * (cell % SHAPES) / (SHAPES - 1) - 1); /* 0.1 to 10 */
    row[SPIN] = 3.0 * (cell / SHAPES % SPINS) / (SPINS - 1);        /* 0 to 3 */
    row[SIZE] = pow(10, 3.0 * (cell / (SHAPES * SPINS)) / (SIZES - 1) - 2); /* 0.01 to 10 */
    const double root = sqrt(row[SHAPE]), radius = 5e-3, bound = 0.3 * 80e3; /* sqrt(ab), mu N */
    const kstrip_contact contact = {radius * root, radius / root, 80e3, 82e9, 0.28, 0.3, 0};
    row[LEAST] = 1;
    for (int i = 0; i < directions; i++) {
        const double angle = 6.283185307179586 * i / directions;
        const kstrip_parameters p = {row[SIZE] * cos(angle), row[SIZE] * sin(angle), row[SPIN]};
        kstrip_creepage creepage;
        kstrip_result f;
        kstrip_status status = kstrip_creepage_from_parameters(&contact, &p, &creepage);
        status = status < 0 ? status : kstrip_solve(&contact, &creepage, &strips, &f);
        check(status >= 0, kstrip_status_string(status));
        const double force = sqrt(f.fx * f.fx + f.fy * f.fy) / bound;
        row[FORCE] += force / directions;
        row[LEAST] = fmin(row[LEAST], force);
        row[MOST] = fmax(row[MOST], force);
        row[MOMENT] += fabs(f.mz) / (bound * radius) / directions;
        row[STICK] += f.adhesion / directions;
    }
}

int main(int argc, char **argv)
{
    int rank, ranks;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    const int directions = argc > 2 ? atoi(argv[2]) : 1000;
    check(argc > 1 && directions > 0, "the file to write, and how many directions");
    const double start = MPI_Wtime();
    for (int cell = rank, done = 1; cell < CELLS; cell += ranks, done++) {
        solve_cell(cell, directions, mine[cell]);
        if (rank == 0 && done % 500 == 0) /* the other processes are about as far */
            fprintf(stderr, "%3d %%, about %.0f s left\n", 100 * done * ranks / CELLS,
                    (MPI_Wtime() - start) * (CELLS - done * ranks) / (done * ranks));
    }
    MPI_Reduce(mine, rows, CELLS * NUMBERS, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
    const double seconds = MPI_Wtime() - start, cases = (double)CELLS * directions;
    FILE *const file = rank == 0 ? fopen(argv[1], "w") : NULL;
    check(rank != 0 || (file && fprintf(file, "%s\n", titles) > 0), "cannot open the file");
    for (int i = 0; file && i < CELLS * NUMBERS; i++)
        fprintf(file, "%.17g%c", rows[i / NUMBERS][i % NUMBERS], (i + 1) % NUMBERS ? ',' : '\n');
    check(!file || !(ferror(file) | fclose(file)), "cannot write the file");
    if (rank == 0)
        printf("%.0f cases, %d processes, %.3e cases per second\n", cases, ranks, cases / seconds);
    return MPI_Finalize();
}
