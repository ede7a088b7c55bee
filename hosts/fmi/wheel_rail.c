/*
 * A wheel on a rail as an FMU: FMI 2.0 or 3.0 (FMI is 2 or 3), model exchange and co-simulation. Hertz's ellipse from load and radii,
 * creep forces by kstrip_solve_motion() through standstill and reversal, exact directional derivatives. Outputs follow inputs: no
 * states, no events. build.py adds the functions of the standard that a model without states has no use for.
 */
#if FMI == 3
#include "fmi3Functions.h"
typedef fmi3Instance instance;
typedef fmi3ValueReference reference;
#else
#include "fmi2Functions.h"
typedef fmi2Component instance;
typedef fmi2ValueReference reference;
#endif
#include <kstrip.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Value references, as in build.py */
enum { SLIP_X, SLIP_Y, SPIN_RATE, ROLLING_SPEED, NORMAL_FORCE, FRICTION, INPUTS };
enum { F_X = INPUTS, F_Y, M_Z, POWER, OUTPUTS_END };
enum { WHEEL_RADIUS = OUTPUTS_END, WHEEL_CURVATURE, RAIL_RADIUS, SHEAR_MODULUS, POISSON_RATIO, FLOOR_SPEED, REALS };
enum { MODEL = REALS, TIME };

static const double start[REALS] = {0, 0, 0, 20, 80e3, .3, 0, 0, 0, 0, .46, 0, .3, 82e9, .28, .02};

typedef struct {
    double value[REALS], time, derivative[OUTPUTS_END - F_X][INPUTS];
    int model, stale; /* stale: outputs and derivatives are not those of the inputs */
    void *environment;
#if FMI == 3
    fmi3LogMessageCallback log;
#else
    fmi2CallbackLogger log;
    char name[64];
#endif
} unit;

static void say(const unit *u, kstrip_status status)
{
    if (!u->log) return;
#if FMI == 3
    u->log(u->environment, fmi3Error, "logStatusError", kstrip_status_string(status));
#else
    u->log(u->environment, u->name, fmi2Error, "logStatusError", "%s", kstrip_status_string(status));
#endif
}

static int update(unit *u)
{
    if (!u->stale) return 1;
    double *r = u->value;
    const kstrip_radii radii = {INFINITY, r[RAIL_RADIUS], r[WHEEL_RADIUS], 1 / r[WHEEL_CURVATURE]};
    const kstrip_combined_material pair = {r[SHEAR_MODULUS], r[POISSON_RATIO], 0};
    const kstrip_motion motion = {r[SLIP_X], r[SLIP_Y], r[SPIN_RATE], r[ROLLING_SPEED], r[FLOOR_SPEED]};
    const kstrip_options options = {.model = u->model};
    kstrip_contact contact;
    kstrip_result f;
    kstrip_motion_derivatives d;
    const kstrip_motion_outputs outputs = {.result = &f, .derivatives = &d};
    kstrip_status status = kstrip_contact_from_hertz(&radii, &pair, r[NORMAL_FORCE], r[FRICTION], &contact, NULL);
    if (status >= 0) status = kstrip_solve_motion(&contact, &motion, NULL, &options, &outputs);
    if (status < 0) return say(u, status), 0;

    const double force[3] = {f.fx, f.fy, f.mz};
    r[F_X] = f.fx, r[F_Y] = f.fy, r[M_Z] = f.mz, r[POWER] = f.power;
    memset(u->derivative, 0, sizeof u->derivative);
    double *power = u->derivative[POWER - F_X];
    for (int i = 0; i < 3; i++) {
        double *by = u->derivative[i];
        memcpy(by, d.slip[i], sizeof d.slip[i]);
        by[ROLLING_SPEED] = d.rolling_speed[i], by[NORMAL_FORCE] = d.load_through_hertz[i], by[FRICTION] = d.friction[i];
        power[i] += force[i];
        for (int k = 0; k < INPUTS; k++) power[k] += by[k] * r[i]; /* power = force . slip */
    }
    u->stale = 0;
    return 1;
}

static void reset(unit *u)
{
    memcpy(u->value, start, sizeof start);
    u->model = KSTRIP_MODEL_DEFAULT, u->time = 0, u->stale = 1;
}
static int set(unit *u, const reference *at, size_t count, const double *values)
{
    for (size_t k = 0; k < count; k++) {
        if (at[k] >= REALS || (at[k] >= F_X && at[k] < OUTPUTS_END)) return 0;
        u->value[at[k]] = values[k];
    }
    return u->stale = 1;
}
static int get(unit *u, const reference *at, size_t count, double *values)
{
    for (size_t k = 0; k < count; k++) {
        if (at[k] == TIME && FMI == 3) values[k] = u->time;
        else if (at[k] >= REALS || (at[k] >= F_X && at[k] < OUTPUTS_END && !update(u))) return 0;
        else values[k] = u->value[at[k]];
    }
    return 1;
}
static int set_model(unit *u, const reference *at, size_t count, const int *values)
{
    for (size_t k = 0; k < count; k++) {
        if (at[k] != MODEL) return 0;
        u->model = values[k], u->stale = 1;
    }
    return 1;
}
static int get_model(const unit *u, const reference *at, size_t count, int *values)
{
    for (size_t k = 0; k < count; k++) {
        if (at[k] != MODEL) return 0;
        values[k] = u->model;
    }
    return 1;
}
static int directional(unit *u, const reference *out, size_t outs, const reference *in, size_t ins, const double *seed, double *answer)
{
    if (!update(u)) return 0;
    for (size_t o = 0; o < outs; o++) {
        answer[o] = 0;
        for (size_t k = 0; k < ins; k++) {
            if (out[o] < F_X || out[o] >= OUTPUTS_END || in[k] >= INPUTS) return 0;
            answer[o] += u->derivative[out[o] - F_X][in[k]] * seed[k];
        }
    }
    return 1;
}

#if FMI == 3

#define STATUS(fine) ((fine) ? fmi3OK : fmi3Error)
const char *fmi3GetVersion(void) { return fmi3Version; }
static instance make(fmi3String token, void *environment, fmi3LogMessageCallback log)
{
    unit *u = token && !strcmp(token, TOKEN) ? calloc(1, sizeof *u) : NULL;
    if (u) u->environment = environment, u->log = log, reset(u);
    return u;
}
instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean logging,
                                      fmi3InstanceEnvironment environment, fmi3LogMessageCallback log)
{
    (void)name, (void)resources, (void)visible, (void)logging;
    return make(token, environment, log);
}
instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean logging,
                                     fmi3Boolean events, fmi3Boolean early, const reference *required, size_t count,
                                     fmi3InstanceEnvironment environment, fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback between)
{
    (void)name, (void)resources, (void)visible, (void)logging, (void)events, (void)early, (void)required, (void)count, (void)between;
    return make(token, environment, log);
}
void fmi3FreeInstance(instance u) { free(u); }
fmi3Status fmi3Reset(instance u) { return reset(u), fmi3OK; }
fmi3Status fmi3EnterInitializationMode(instance u, fmi3Boolean defined, double tolerance, double from, fmi3Boolean stops, double to)
{
    (void)defined, (void)tolerance, (void)stops, (void)to;
    return ((unit *)u)->time = from, fmi3OK;
}
fmi3Status fmi3SetTime(instance u, double time) { return ((unit *)u)->time = time, fmi3OK; }
fmi3Status fmi3SetFloat64(instance u, const reference at[], size_t n, const double x[], size_t m) { return STATUS(n == m && set(u, at, n, x)); }
fmi3Status fmi3GetFloat64(instance u, const reference at[], size_t n, double x[], size_t m) { return STATUS(n == m && get(u, at, n, x)); }
fmi3Status fmi3SetInt32(instance u, const reference at[], size_t n, const int x[], size_t m) { return STATUS(n == m && set_model(u, at, n, x)); }
fmi3Status fmi3GetInt32(instance u, const reference at[], size_t n, int x[], size_t m) { return STATUS(n == m && get_model(u, at, n, x)); }
fmi3Status fmi3GetDirectionalDerivative(instance u, const reference out[], size_t outs, const reference in[], size_t ins, const double seed[],
                                        size_t seeds, double answer[], size_t answers)
{
    return STATUS(seeds == ins && answers == outs && directional(u, out, outs, in, ins, seed, answer));
}
fmi3Status fmi3UpdateDiscreteStates(instance u, fmi3Boolean *again, fmi3Boolean *stop, fmi3Boolean *nominals, fmi3Boolean *values,
                                    fmi3Boolean *next, double *when)
{
    (void)u, (void)when;
    *again = *stop = *nominals = *values = *next = fmi3False;
    return fmi3OK;
}
fmi3Status fmi3CompletedIntegratorStep(instance u, fmi3Boolean final, fmi3Boolean *event, fmi3Boolean *stop)
{
    (void)u, (void)final;
    *event = *stop = fmi3False;
    return fmi3OK;
}
fmi3Status fmi3GetNumberOfEventIndicators(instance u, size_t *n) { return (void)u, *n = 0, fmi3OK; }
fmi3Status fmi3GetNumberOfContinuousStates(instance u, size_t *n) { return (void)u, *n = 0, fmi3OK; }
fmi3Status fmi3DoStep(instance c, double time, double step, fmi3Boolean final, fmi3Boolean *event, fmi3Boolean *stop, fmi3Boolean *early,
                      double *reached)
{
    unit *u = c;
    (void)final;
    *event = *stop = *early = fmi3False, *reached = u->time = time + step;
    return STATUS(update(u));
}

#else

#define STATUS(fine) ((fine) ? fmi2OK : fmi2Error)
const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
const char *fmi2GetVersion(void) { return fmi2Version; }
instance fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String token, fmi2String resources, const fmi2CallbackFunctions *call,
                         fmi2Boolean visible, fmi2Boolean logging)
{
    (void)type, (void)resources, (void)visible, (void)logging;
    unit *u = token && !strcmp(token, TOKEN) ? calloc(1, sizeof *u) : NULL;
    if (!u) return NULL;
    if (call) u->log = call->logger, u->environment = call->componentEnvironment;
    if (name) strncpy(u->name, name, sizeof u->name - 1);
    reset(u);
    return u;
}
void fmi2FreeInstance(instance u) { free(u); }
fmi2Status fmi2Reset(instance u) { return reset(u), fmi2OK; }
fmi2Status fmi2SetReal(instance u, const reference at[], size_t n, const double x[]) { return STATUS(set(u, at, n, x)); }
fmi2Status fmi2GetReal(instance u, const reference at[], size_t n, double x[]) { return STATUS(get(u, at, n, x)); }
fmi2Status fmi2SetInteger(instance u, const reference at[], size_t n, const int x[]) { return STATUS(set_model(u, at, n, x)); }
fmi2Status fmi2GetInteger(instance u, const reference at[], size_t n, int x[]) { return STATUS(get_model(u, at, n, x)); }
fmi2Status fmi2GetDirectionalDerivative(instance u, const reference out[], size_t outs, const reference in[], size_t ins, const double seed[],
                                        double answer[])
{
    return STATUS(directional(u, out, outs, in, ins, seed, answer));
}
fmi2Status fmi2NewDiscreteStates(instance u, fmi2EventInfo *event) { return (void)u, memset(event, 0, sizeof *event), fmi2OK; }
fmi2Status fmi2CompletedIntegratorStep(instance u, fmi2Boolean final, fmi2Boolean *event, fmi2Boolean *stop)
{
    (void)u, (void)final;
    *event = *stop = fmi2False;
    return fmi2OK;
}
fmi2Status fmi2DoStep(instance u, double time, double step, fmi2Boolean final)
{
    (void)time, (void)step, (void)final;
    return STATUS(update(u));
}

#endif
