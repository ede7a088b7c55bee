/*
 * A bogie vehicle on eight wheel-rail contacts in SUNDIALS: CVODE runs it, KINSOL finds its place in a curve, both with the exact
 * Jacobian that kstrip_solve_motion() gives. Speed is a state: hunting at 60 m/s, standstill and restart are one model.
 *
 *   make && cc -std=gnu11 -O2 -Iinclude hosts/sundials/vehicle.c target/lib/libkstrip.a -lsundials_cvode -lsundials_kinsol
 *      -lsundials_nvecserial -lsundials_sunmatrixdense -lsundials_sunlinsoldense -llapack -lm -o target/vehicle && target/vehicle
 *
 * Prints its figures and checks them: the exit code is 0 when all hold.
 */
#include <cvode/cvode.h>
#include <kinsol/kinsol.h>
#include <kstrip.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

/* Axes of the track: x forward, y right, z down. Bodies: wheelsets 0 to 3, bogie frames 4 and 5, car 6.
   Velocities: y, yaw of each body, the vehicle's speed, the speed of the rim of each wheelset. State: coordinates of all but the
   rims, then velocities. */
enum { BODIES = 7, AXLES = 4, PLACE = 2 * BODIES, RIM = PLACE + 1, VELOCITIES = RIM + AXLES, COORDINATES = PLACE + 1 };
enum { STATES = COORDINATES + VELOCITIES, STEADY = PLACE + AXLES };

static const double mass[BODIES] = {1500, 1500, 1500, 1500, 3000, 3000, 32000};       /* kg */
static const double inertia[BODIES] = {900, 900, 900, 900, 3500, 3500, 2e6};          /* kg m2 */
static const double vehicle_mass = 44000, rim_mass = 570;                              /* kg; of a rim: inertia/radius^2 */
static const double radius = 0.46, half_gauge = 0.75, conicity = 0.15;                 /* m, m, - */
static const double flange_clearance = 7e-3, flange_stiffness = 1.5e7, gravity = 9.81; /* m, N/m, m/s2 */
static kstrip_contact contact;

/* A joint of body i to body j, at the distance `arm` ahead of the centre of j */
typedef struct { int i, j; double arm, stiffness, damping, yaw_stiffness, yaw_damping; } joint;
static const joint joints[] = {
    {0, 4, 1.25, 2e6, 0, 5e6, 0},           {1, 4, -1.25, 2e6, 0, 5e6, 0},
    {2, 5, 1.25, 2e6, 0, 5e6, 0},           {3, 5, -1.25, 2e6, 0, 5e6, 0},
    {4, 6, 9.5, 320e3, 60e3, 160e3, 420e3}, {5, 6, -9.5, 320e3, 60e3, 160e3, 420e3},
};

typedef struct {
    double curvature, cant, slope; /* to the left [1/m], [-], uphill [-] */
    double drive, brake;           /* on each rim [N] */
    double steady_speed;           /* of KINSOL [m/s] */
    int kstrip_model;
    long contacts;
} world;

static double vehicle_inertia(int velocity)
{
    if (velocity == PLACE) return vehicle_mass;
    if (velocity >= RIM) return rim_mass;
    return velocity % 2 ? inertia[velocity / 2] : mass[velocity / 2];
}

static void add(SUNMatrix J, int force, int state, double derivative)
{
    if (J) SM_ELEMENT_D(J, COORDINATES + force, state) += derivative / vehicle_inertia(force);
}

/* One wheel, side = -1 left, 1 right. Its slip is linear in the velocities, slip = B (v, yaw rate, speed, rim), and its
   generalized force is -B' (force on the rail): what friction takes is what the vehicle loses. */
static int wheel(const double *x, double *force, SUNMatrix J, world *w, int axle, int side)
{
    const double *q = x, *v = x + COORDINATES;
    const double arm = side * half_gauge, cone = side * conicity / radius, y = q[2 * axle], yaw = q[2 * axle + 1];
    const int at[4] = {2 * axle, 2 * axle + 1, PLACE, RIM + axle};
    const double B[3][4] = {{0, -arm, 1 + arm * w->curvature, -(1 + cone * y)}, /* ahead: yaw, curve, radius r + conicity y */
                            {1, 0, -yaw, 0},                                     /* aside: a yawed wheel runs off */
                            {0, 1, -w->curvature, -cone}};                       /* spin: the contact plane is tilted */
    double slip[3] = {0};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 4; k++) slip[i] += B[i][k] * v[at[k]];

    const kstrip_motion motion = {slip[0], slip[1], slip[2], v[PLACE], 0};
    const kstrip_options options = {.model = w->kstrip_model};
    kstrip_result r;
    kstrip_motion_derivatives d;
    const kstrip_motion_outputs outputs = {.result = &r, .derivatives = J ? &d : NULL};
    w->contacts++;
    if (kstrip_solve_motion(&contact, &motion, NULL, &options, &outputs) < 0) return -1;

    const double f[3] = {r.fx, r.fy, r.mz};
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++) force[at[k]] -= B[i][k] * f[i];
    if (!J) return 0;
    const double slip_by_y = -cone * v[RIM + axle], slip_by_yaw = -v[PLACE];
    for (int i = 0; i < 3; i++) {
        double by[6] = {0}; /* of f[i] by the four velocities, y and yaw */
        for (int k = 0; k < 4; k++)
            for (int j = 0; j < 3; j++) by[k] += d.slip[i][j] * B[j][k];
        by[2] += d.rolling_speed[i];
        by[4] = d.slip[i][0] * slip_by_y, by[5] = d.slip[i][1] * slip_by_yaw;
        for (int k = 0; k < 4; k++) {
            for (int j = 0; j < 4; j++) add(J, at[k], COORDINATES + at[j], -B[i][k] * by[j]);
            add(J, at[k], at[0], -B[i][k] * by[4]), add(J, at[k], at[1], -B[i][k] * by[5]);
        }
    }
    add(J, RIM + axle, at[0], cone * f[0]), add(J, PLACE, at[1], f[1]); /* B itself depends on y and yaw */
    return 0;
}

/* rates of the state, and their Jacobian if J is not NULL */
static int rates(const double *x, double *rate, SUNMatrix J, world *w)
{
    const double *q = x, *v = x + COORDINATES;
    double force[VELOCITIES] = {0};
    if (J) SUNMatZero(J);
    for (int i = 0; i < COORDINATES; i++) {
        rate[i] = v[i];
        if (J) SM_ELEMENT_D(J, i, COORDINATES + i) = 1;
    }
    for (size_t n = 0; n < sizeof joints / sizeof *joints; n++) {
        const joint *s = &joints[n];
        const int lateral[3] = {2 * s->i, 2 * s->j, 2 * s->j + 1}, yaw[2] = {2 * s->i + 1, 2 * s->j + 1};
        const double by[3] = {1, -1, -s->arm}, turn[2] = {1, -1};
        /* in a curve the track bends away from the middle of body j */
        double d = -s->arm * s->arm * w->curvature / 2, rate_of_d = 0, e = -s->arm * w->curvature, rate_of_e = 0;
        for (int k = 0; k < 3; k++) d += by[k] * q[lateral[k]], rate_of_d += by[k] * v[lateral[k]];
        for (int k = 0; k < 2; k++) e += turn[k] * q[yaw[k]], rate_of_e += turn[k] * v[yaw[k]];
        for (int k = 0; k < 3; k++) {
            force[lateral[k]] -= by[k] * (s->stiffness * d + s->damping * rate_of_d);
            for (int l = 0; l < 3; l++) {
                add(J, lateral[k], lateral[l], -by[k] * by[l] * s->stiffness);
                add(J, lateral[k], COORDINATES + lateral[l], -by[k] * by[l] * s->damping);
            }
        }
        for (int k = 0; k < 2; k++) {
            force[yaw[k]] -= turn[k] * (s->yaw_stiffness * e + s->yaw_damping * rate_of_e);
            for (int l = 0; l < 2; l++) {
                add(J, yaw[k], yaw[l], -turn[k] * turn[l] * s->yaw_stiffness);
                add(J, yaw[k], COORDINATES + yaw[l], -turn[k] * turn[l] * s->yaw_damping);
            }
        }
    }
    for (int axle = 0; axle < AXLES; axle++) {
        for (int side = -1; side <= 1; side += 2)
            if (wheel(x, force, J, w, axle, side) < 0) return -1;
        const double y = q[2 * axle], over = fabs(y) - flange_clearance, u = v[RIM + axle], small = 1e-6; /* m/s */
        if (over > 0) force[2 * axle] -= copysign(flange_stiffness * over, y), add(J, 2 * axle, 2 * axle, -flange_stiffness);
        const double root = sqrt(u * u + small * small); /* the brake's own friction */
        force[RIM + axle] += w->drive - w->brake * u / root;
        add(J, RIM + axle, COORDINATES + RIM + axle, -w->brake * small * small / (root * root * root));
    }
    const double V = v[PLACE];
    for (int b = 0; b < BODIES; b++) {
        force[2 * b] += mass[b] * (V * V * w->curvature - gravity * w->cant);
        add(J, 2 * b, COORDINATES + PLACE, 2 * mass[b] * V * w->curvature);
    }
    force[PLACE] -= vehicle_mass * gravity * w->slope;
    for (int i = 0; i < VELOCITIES; i++) rate[COORDINATES + i] = force[i] / vehicle_inertia(i);
    return 0;
}

static int cvode_rates(realtype t, N_Vector x, N_Vector rate, void *w)
{
    (void)t;
    return rates(NV_DATA_S(x), NV_DATA_S(rate), NULL, w);
}
static int cvode_jacobian(realtype t, N_Vector x, N_Vector rate, SUNMatrix J, void *w, N_Vector a, N_Vector b, N_Vector c)
{
    (void)t, (void)rate, (void)b, (void)c;
    return rates(NV_DATA_S(x), NV_DATA_S(a), J, w);
}

static int faults;
static void check(int holds, const char *what)
{
    if (!holds) printf("  MISSED: %s\n", what), faults++;
}
static void must(int flag, const char *what)
{
    if (flag < 0) fprintf(stderr, "%s: %d\n", what, flag), exit(EXIT_FAILURE);
}

/* A run of CVODE that is kept, to go on with other loads */
typedef struct { void *cvode; N_Vector x; SUNMatrix J; SUNLinearSolver solver; } run;
static run begin(SUNContext context, world *w, double speed, double aside, double tolerance, int exact)
{
    run r = {CVodeCreate(CV_BDF, context), N_VNew_Serial(STATES, context), SUNDenseMatrix(STATES, STATES, context), NULL};
    double *x = NV_DATA_S(r.x);
    N_VConst(0, r.x);
    for (int b = 0; b < BODIES; b++) x[2 * b] = aside;
    for (int i = PLACE; i < VELOCITIES; i++) x[COORDINATES + i] = speed;
    r.solver = SUNLinSol_Dense(r.x, r.J, context);
    must(CVodeInit(r.cvode, cvode_rates, 0, r.x), "CVodeInit");
    must(CVodeSStolerances(r.cvode, tolerance, tolerance * 1e-2 * aside), "CVodeSStolerances");
    CVodeSetUserData(r.cvode, w), CVodeSetMaxNumSteps(r.cvode, 1000000);
    must(CVodeSetLinearSolver(r.cvode, r.solver, r.J), "CVodeSetLinearSolver");
    if (exact) must(CVodeSetJacFn(r.cvode, cvode_jacobian), "CVodeSetJacFn");
    w->contacts = 0;
    return r;
}
static void go_to(run *r, double time)
{
    realtype reached;
    must(CVode(r->cvode, time, r->x, &reached, CV_NORMAL), "CVode");
}
static void end(run *r)
{
    CVodeFree(&r->cvode), SUNLinSolFree(r->solver), SUNMatDestroy(r->J), N_VDestroy(r->x);
}

/* Largest |y| of a wheelset in the last quarter; the rate at which it grew since the second [1/s] */
static double growth(SUNContext context, world *w, double speed, double aside, double tolerance, double seconds, double *last)
{
    run r = begin(context, w, speed, aside, tolerance, 1);
    double largest[4] = {0};
    for (int k = 1; k <= 800; k++) {
        go_to(&r, seconds * k / 800);
        for (int a = 0; a < AXLES; a++) largest[(k - 1) / 200] = fmax(largest[(k - 1) / 200], fabs(NV_Ith_S(r.x, 2 * a)));
    }
    end(&r);
    *last = largest[3];
    return log(largest[3] / largest[1]) / (seconds / 2);
}

/* Largest real part of the eigenvalues that oscillate, at rest on straight track */
extern void dgeev_(const char *, const char *, const int *, double *, const int *, double *, double *, double *, const int *,
                   double *, const int *, double *, const int *, int *);
static double eigenvalue(SUNMatrix J, world *w, double speed, double *frequency)
{
    double x[STATES] = {0}, rate[STATES], re[STATES], im[STATES], work[8 * STATES], largest = -INFINITY;
    const int n = STATES, one = 1, room = 8 * STATES;
    int info;
    for (int i = PLACE; i < VELOCITIES; i++) x[COORDINATES + i] = speed;
    must(rates(x, rate, J, w), "rates");
    dgeev_("N", "N", &n, SUNDenseMatrix_Data(J), &n, re, im, NULL, &one, NULL, &one, work, &room, &info);
    must(-abs(info), "dgeev");
    for (int i = 0; i < n; i++)
        if (im[i] > 1 && re[i] > largest) largest = re[i], *frequency = im[i] / 6.283185307179586;
    return largest;
}

static void jacobian_is_exact(SUNMatrix J)
{
    double worst = 0;
    for (int n = 0; n < 4; n++) {
        world w = {.curvature = 1e-3, .brake = 1e4, .drive = 3e3, .slope = .01};
        const double speed = (const double[]){60, -20, .03, .002}[n];
        double x[STATES], above[STATES], below[STATES], rate[STATES];
        for (int i = 0; i < STATES; i++) x[i] = 1e-3 * fmin(1, fabs(speed)) * sin(1 + 3.0 * i);
        for (int i = PLACE; i < VELOCITIES; i++) x[COORDINATES + i] = speed * (1 + 1e-4 * i);
        must(rates(x, rate, J, &w), "rates");
        for (int k = 0; k < STATES; k++) {
            const double kept = x[k], h = 1e-7 * fmin(1, fabs(speed));
            x[k] = kept + h, must(rates(x, above, NULL, &w), "rates");
            x[k] = kept - h, must(rates(x, below, NULL, &w), "rates");
            x[k] = kept;
            for (int i = 0; i < STATES; i++) {
                const double exact = SM_ELEMENT_D(J, i, k);
                worst = fmax(worst, fabs((above[i] - below[i]) / (2 * h) - exact) / (1 + fabs(exact)));
            }
        }
    }
    printf("Jacobian of %d states against differences, 60 m/s to 2 mm/s: %.1e\n", STATES, worst);
    check(worst < 1e-5, "the Jacobian is exact");
}

static void critical_speed(SUNContext context, SUNMatrix J)
{
    const int models[] = {KSTRIP_MODEL_LINEAR, KSTRIP_MODEL_TOTAL};
    double critical = 0, frequency, last;
    for (int m = 0; m < 2; m++) {
        world w = {.kstrip_model = models[m]};
        double low = 30, high = 150;
        while (high - low > 1e-6) {
            const double V = (low + high) / 2;
            *(eigenvalue(J, &w, V, &frequency) > 0 ? &high : &low) = V;
        }
        critical = low;
        /* 2 % below and above, a hundredth of a millimetre aside; growth is linear in the speed between */
        const double below = growth(context, &w, .98 * critical, 1e-5, 1e-8, 8, &last);
        const double above = growth(context, &w, 1.02 * critical, 1e-5, 1e-8, 8, &last);
        const double by_runs = critical * (.98 - .04 * below / (above - below));
        printf("critical speed, %s: eigenvalues %.2f m/s at %.2f Hz, CVODE %.2f m/s (growth %.4f and %.4f 1/s at 98 and 102 %%)\n",
               m ? "TOTAL" : "LINEAR", critical, frequency, by_runs, below, above);
        check(below < 0 && above > 0 && fabs(by_runs / critical - 1) < 2e-3, "runs and eigenvalues agree within 0.2 %");
    }
    for (int n = 0; n < 2; n++) {
        world w = {0};
        const double share = n ? 1.1 : .9, rate = growth(context, &w, share * critical, 3e-3, 1e-5, 10, &last);
        printf("at %.0f %% of it, 3 mm aside: %.4f mm after 10 s\n", share * 100, last * 1e3);
        check(n ? fabs(rate) < 1e-2 && last > flange_clearance : last < 3e-5, "dies away below, hunts between the flanges above");
    }
}

/* Steady curving: y and yaw of all bodies and the rims' speeds, so that nothing but the vehicle's speed changes */
static int steady_index(int i, int state) { return i < PLACE ? (state ? i : COORDINATES + i) : COORDINATES + RIM + i - PLACE; }
static void steady_state(N_Vector unknown, const world *w, double *x)
{
    memset(x, 0, STATES * sizeof *x);
    x[COORDINATES + PLACE] = w->steady_speed;
    for (int i = 0; i < STEADY; i++) x[steady_index(i, 1)] = NV_Ith_S(unknown, i);
}
static int steady_residual(N_Vector unknown, N_Vector residual, void *w)
{
    double x[STATES], rate[STATES];
    steady_state(unknown, w, x);
    if (rates(x, rate, NULL, w) < 0) return -1;
    for (int i = 0; i < STEADY; i++) NV_Ith_S(residual, i) = rate[steady_index(i, 0)];
    return 0;
}
static SUNMatrix whole;
static int steady_jacobian(N_Vector unknown, N_Vector residual, SUNMatrix J, void *w, N_Vector a, N_Vector b)
{
    double x[STATES], rate[STATES];
    (void)residual, (void)a, (void)b;
    steady_state(unknown, w, x);
    if (rates(x, rate, whole, w) < 0) return -1;
    for (int i = 0; i < STEADY; i++)
        for (int k = 0; k < STEADY; k++) SM_ELEMENT_D(J, i, k) = SM_ELEMENT_D(whole, steady_index(i, 0), steady_index(k, 1));
    return 0;
}
static void curving(SUNContext context)
{
    double places[2] = {0};
    for (double R = 2000; R >= 250; R /= 2)
        for (int exact = 1; exact >= 0; exact--) {
            world w = {.curvature = 1 / R, .cant = .02, .steady_speed = 20};
            N_Vector x = N_VNew_Serial(STEADY, context), scale = N_VNew_Serial(STEADY, context);
            SUNMatrix J = SUNDenseMatrix(STEADY, STEADY, context);
            SUNLinearSolver solver = SUNLinSol_Dense(x, J, context);
            void *kinsol = KINCreate(context);
            N_VConst(0, x), N_VConst(1, scale);
            for (int a = 0; a < AXLES; a++) NV_Ith_S(x, PLACE + a) = w.steady_speed;
            must(KINInit(kinsol, steady_residual, x), "KINInit"), KINSetUserData(kinsol, &w);
            must(KINSetLinearSolver(kinsol, solver, J), "KINSetLinearSolver");
            if (exact) must(KINSetJacFn(kinsol, steady_jacobian), "KINSetJacFn");
            KINSetMaxSetupCalls(kinsol, 1), KINSetNumMaxIters(kinsol, 200), KINSetMaxNewtonStep(kinsol, 1);
            KINSetFuncNormTol(kinsol, 1e-9), KINSetScaledStepTol(kinsol, 1e-15);
            const int flag = KINSol(kinsol, x, KIN_LINESEARCH, scale, scale);
            long iterations;
            double norm;
            KINGetNumNonlinSolvIters(kinsol, &iterations), KINGetFuncNorm(kinsol, &norm);
            places[exact] = NV_Ith_S(x, 0);
            printf("curve of %4.0f m, %s: %ld iterations, %ld contacts, residual %.1e, leading axle %.4f mm outward, %.4f mrad\n", R,
                   exact ? "kstrip's Jacobian " : "KINSOL's differences", iterations, w.contacts, norm, places[exact] * 1e3, NV_Ith_S(x, 1) * 1e3);
            if (exact) check(flag >= 0 && norm < 1e-8 && iterations <= 30 && places[1] > 0, "KINSOL finds the curve");
            else if (flag >= 0 && norm < 1e-8) check(fabs(places[0] - places[1]) < 1e-8, "both find the same place");
            KINFree(&kinsol), SUNLinSolFree(solver), SUNMatDestroy(J), N_VDestroy(x), N_VDestroy(scale);
        }
}

/* Brake to rest uphill on 1:50, hold, drive off */
static void stop_hold_restart(SUNContext context)
{
    for (int exact = 1; exact >= 0; exact--) {
        world w = {.slope = .02, .brake = 10e3};
        run r = begin(context, &w, 3, 2e-3, 1e-6, exact);
        const double *x = NV_DATA_S(r.x), *v = x + COORDINATES;
        go_to(&r, 5);
        const double held = x[PLACE];
        go_to(&r, 8);
        const double drift = x[PLACE] - held, standing = v[PLACE], aside = x[0];
        w.brake = 0, w.drive = 5e3;
        must(CVodeReInit(r.cvode, 8, r.x), "CVodeReInit");
        go_to(&r, 18);
        const double expected = 10 * (4 * w.drive - vehicle_mass * gravity * w.slope) / (vehicle_mass + 4 * rim_mass);
        long steps, jacobians;
        CVodeGetNumSteps(r.cvode, &steps), CVodeGetNumJacEvals(r.cvode, &jacobians); /* since the restart */
        printf("stop, hold, restart, %s: drift %.1f um in 3 s at %.2f um/s, %.3f mm aside; then %.4f m/s (rigid %.4f), "
               "%ld contacts\n",
               exact ? "kstrip's Jacobian" : "CVODE's differences", drift * 1e6, standing * 1e6, aside * 1e3, v[PLACE], expected, w.contacts);
        check(drift < 0 && drift > -20e-6, "holds on the slope");
        check(fabs(v[PLACE] / expected - 1) < .01, "drives off");
        end(&r);
    }
}

int main(void)
{
    SUNContext context;
#if SUNDIALS_VERSION_MAJOR >= 7
    must(SUNContext_Create(SUN_COMM_NULL, &context), "SUNContext_Create");
#else
    must(SUNContext_Create(NULL, &context), "SUNContext_Create");
#endif
    const kstrip_combined_material steel = {82e9, 0.28, 0};
    const kstrip_radii radii = {INFINITY, 0.30, radius, INFINITY};
    must(kstrip_contact_from_hertz(&radii, &steel, vehicle_mass * gravity / 8, 0.35, &contact, NULL), "contact");
    whole = SUNDenseMatrix(STATES, STATES, context);
    jacobian_is_exact(whole);
    critical_speed(context, whole);
    curving(context);
    stop_hold_restart(context);
    SUNMatDestroy(whole);
    SUNContext_Free(&context);
    return faults ? EXIT_FAILURE : EXIT_SUCCESS;
}
