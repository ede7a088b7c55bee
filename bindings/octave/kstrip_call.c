/* kstrip in MATLAB and Octave: what the functions kstrip*.m of this folder call; each has help text (`help kstrip`).
 *
 *   make && mkoctfile --mex -Iinclude bindings/octave/kstrip_call.c target/lib/libkstrip.a -o bindings/octave/kstrip_call.mex
 *   mex -Iinclude bindings/octave/kstrip_call.c target/lib/libkstrip.a -outdir bindings/octave            (MATLAB)
 *   addpath bindings/octave
 *
 * A structure of the C interface is a column of its members, in their order; many are the columns of a matrix, and one column stands
 * for all. Errors name the column; each kind of warning is passed on once, with its first column.
 */
#include "kstrip.h"
#include "mex.h"
#include <string.h>

enum { STATUSES = 64 };

/* The first column of each warning, and how many there are. */
typedef struct {
    size_t first[STATUSES], count[STATUSES];
} report;

static void note(report *seen, kstrip_status status, size_t column)
{
    if (status < 0)
        mexErrMsgIdAndTxt("kstrip:status", "kstrip: column %d: %s", (int)column + 1, kstrip_status_string(status));
    if (status > 0 && status < STATUSES && !seen->count[status]++) seen->first[status] = column;
}

static void warn(const report *seen)
{
    for (int status = 1; status < STATUSES; status++)
        if (seen->count[status])
            mexWarnMsgIdAndTxt("kstrip:warning", "kstrip: column %d%s: %s", (int)seen->first[status] + 1,
                               seen->count[status] > 1 ? " and others" : "", kstrip_status_string(status));
}

/* An argument that was given and is not []. */
static const mxArray *given(int count, const mxArray *arguments[], int i)
{
    return i < count && !mxIsEmpty(arguments[i]) ? arguments[i] : NULL;
}

/* Columns of an argument that has at least `least` rows and no more than the structure has members. */
static size_t columns(const mxArray *array, const char *name, size_t least, size_t size)
{
    const size_t members = size / sizeof(double);
    if (!array || !mxIsDouble(array) || mxIsComplex(array) || mxGetM(array) < least || mxGetM(array) > members)
        mexErrMsgIdAndTxt("kstrip:argument", "kstrip: %s must be a real double matrix with %d to %d rows, see help kstrip", name, (int)least,
                          (int)members);
    return mxGetN(array);
}

static size_t common(size_t one, size_t other)
{
    if (one != other && one != 1 && other != 1)
        mexErrMsgIdAndTxt("kstrip:argument", "kstrip: the arguments have different numbers of columns, %d and %d", (int)one, (int)other);
    return one == 1 ? other : one;
}

/* A structure of numbers from column k, or from the only one; members that are not given are zero. */
static void load(void *to, size_t size, const mxArray *array, size_t k)
{
    const size_t rows = mxGetM(array);
    memset(to, 0, size);
    memcpy(to, mxGetPr(array) + rows * (mxGetN(array) > 1 ? k : 0), rows * sizeof(double));
}

static double scalar(const mxArray *array, double otherwise)
{
    return array ? mxGetScalar(array) : otherwise;
}

static kstrip_options options_of(const mxArray *model, const mxArray *strips)
{
    static const char *const names[] = {"default", "strip_1967", "strip_1967_continuous", "strip", "total", "linear"};
    kstrip_options options = {0, (int32_t)scalar(strips, 0)};
    if (model && mxIsChar(model)) {
        char name[32] = "";
        mxGetString(model, name, sizeof name);
        options.model = -1;
        for (int i = 0; i < 6; i++)
            if (strcmp(name, names[i]) == 0) options.model = i;
    } else {
        options.model = (int32_t)scalar(model, 0);
    }
    return options;
}

static double *field(mxArray *of, const char *name, size_t rows, size_t count)
{
    mxArray *made = mxCreateDoubleMatrix(rows, count, mxREAL);
    mxAddField(of, name);
    mxSetField(of, 0, name, made);
    return mxGetPr(made);
}

static double *cube(mxArray *of, const char *name, size_t count)
{
    const mwSize sizes[3] = {3, 3, count};
    mxArray *made = mxCreateNumericArray(3, sizes, mxDOUBLE_CLASS, mxREAL);
    mxAddField(of, name);
    mxSetField(of, 0, name, made);
    return mxGetPr(made);
}

/* matrix(i, j, k): the derivative of force i with respect to motion j. */
static void put_rows(double *matrix, size_t k, const double rows[3][3])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) matrix[9 * k + 3 * j + i] = rows[i][j];
}

typedef struct {
    double *force, *power, *adhesion, *status, *friction;
} result_fields;

static result_fields results(mxArray *of, size_t n)
{
    const result_fields made = {field(of, "force", 3, n), field(of, "power", 1, n), field(of, "adhesion", 1, n),
                                field(of, "status", 1, n), field(of, "friction", 1, n)};
    return made;
}

static void put_result(const result_fields *to, size_t k, const kstrip_result *from, double friction)
{
    to->force[3 * k] = from->fx, to->force[3 * k + 1] = from->fy, to->force[3 * k + 2] = from->mz;
    to->power[k] = from->power, to->adhesion[k] = from->adhesion;
    to->status[k] = from->status_detail, to->friction[k] = friction;
}

static const char *const strip_rows = "patch.strips";

static kstrip_patch patch_of(const mxArray *of)
{
    kstrip_patch patch;
    memset(&patch, 0, sizeof patch);
    const mxArray *strips = of && mxIsStruct(of) ? mxGetField(of, 0, "strips") : NULL;
    if (!strips || !mxGetField(of, 0, "shear_modulus") || !mxGetField(of, 0, "poisson_ratio"))
        mexErrMsgIdAndTxt("kstrip:argument", "kstrip: patch must be a struct from kstrip_patch_from_contact or kstrip_patch_from_profile");
    const size_t count = mxIsEmpty(strips) ? 0 : columns(strips, strip_rows, 6, sizeof *patch.strips);
    if (count > KSTRIP_PATCH_CAPACITY) mexErrMsgIdAndTxt("kstrip:status", "kstrip: %s", kstrip_status_string(KSTRIP_ERROR_PATCH_SIZE));
    for (size_t k = 0; k < count; k++) load(&patch.strips[k], sizeof patch.strips[k], strips, k);
    patch.count = (uint32_t)count;
    patch.shear_modulus = mxGetScalar(mxGetField(of, 0, "shear_modulus"));
    patch.poisson_ratio = mxGetScalar(mxGetField(of, 0, "poisson_ratio"));
    patch.area_scale = scalar(mxGetField(of, 0, "area_scale"), 0);
    patch.lever_scale = scalar(mxGetField(of, 0, "lever_scale"), 0);
    patch.mismatch = scalar(mxGetField(of, 0, "mismatch"), 0);
    return patch;
}

static mxArray *of_patch(const kstrip_patch *patch)
{
    mxArray *made = mxCreateStructMatrix(1, 1, 0, NULL);
    double *strips = field(made, "strips", sizeof *patch->strips / sizeof(double), patch->count);
    memcpy(strips, patch->strips, patch->count * sizeof *patch->strips);
    *field(made, "shear_modulus", 1, 1) = patch->shear_modulus;
    *field(made, "poisson_ratio", 1, 1) = patch->poisson_ratio;
    *field(made, "area_scale", 1, 1) = patch->area_scale;
    *field(made, "lever_scale", 1, 1) = patch->lever_scale;
    *field(made, "mismatch", 1, 1) = patch->mismatch;
    return made;
}

/* (contact or patch, creepage, friction, model, strips, creepages of a patch's strips) */
static mxArray *evaluate(int count, const mxArray *in[])
{
    const mxArray *law = given(count, in, 2);
    const kstrip_options options = options_of(given(count, in, 3), given(count, in, 4));
    const int is_patch = count > 0 && mxIsStruct(in[0]);
    kstrip_patch patch = {0};
    size_t n = columns(given(count, in, 1), "creepage", 3, sizeof(kstrip_creepage));
    if (is_patch)
        patch = patch_of(in[0]);
    else
        n = common(n, columns(given(count, in, 0), "contact", 6, sizeof(kstrip_contact)));
    if (law) n = common(n, columns(law, "friction", 5, sizeof(kstrip_friction)));
    const mxArray *besides = given(count, in, 5);
    kstrip_creepage own[KSTRIP_PATCH_CAPACITY];
    if (besides) {
        const size_t strips = columns(besides, "own", 3, sizeof *own);
        if (!is_patch || strips != patch.count) mexErrMsgIdAndTxt("kstrip:argument", "kstrip: own needs a patch, and one column for each of its strips");
        for (size_t k = 0; k < strips; k++) load(&own[k], sizeof own[k], besides, k);
    }
    mxArray *made = mxCreateStructMatrix(1, 1, 0, NULL);
    const result_fields to = results(made, n);
    double *jacobian = cube(made, "jacobian", n), *by_load = field(made, "by_load", 3, n);
    double *by_hertz = field(made, "by_load_through_hertz", 3, n), *by_friction = field(made, "by_friction", 3, n);
    double *by_ratio = field(made, "by_ratio", 3, n), *by_decay = field(made, "by_decay", 3, n);
    double *by_speed = field(made, "by_rolling_speed", 3, n), *by_slope = field(made, "by_slope_factor", 3, n);
    double *by_slide = field(made, "by_slide_factor", 3, n), *by_layer = field(made, "by_layer", 3, n);
    report seen = {{0}, {0}};
    for (size_t k = 0; k < n; k++) {
        kstrip_contact contact;
        kstrip_creepage creepage;
        kstrip_friction friction;
        kstrip_result result;
        kstrip_derivatives by;
        kstrip_law_derivatives by_law;
        double left;
        const kstrip_outputs outputs = {.result = &result, .derivatives = &by, .law_derivatives = &by_law, .friction = &left};
        load(&creepage, sizeof creepage, in[1], k);
        if (law) load(&friction, sizeof friction, law, k);
        if (!is_patch) load(&contact, sizeof contact, in[0], k);
        note(&seen,
             is_patch ? kstrip_patch_evaluate_strips(&patch, &creepage, besides ? own : NULL, law ? &friction : NULL, &options, &outputs)
                      : kstrip_evaluate(&contact, &creepage, law ? &friction : NULL, &options, &outputs),
             k);
        put_result(&to, k, &result, left);
        put_rows(jacobian, k, (const double(*)[3])by.jacobian);
        memcpy(by_load + 3 * k, by.normal_force, sizeof by.normal_force);
        memcpy(by_hertz + 3 * k, by.load_through_hertz, sizeof by.load_through_hertz);
        memcpy(by_friction + 3 * k, by.friction, sizeof by.friction);
        memcpy(by_ratio + 3 * k, by_law.ratio, sizeof by_law.ratio);
        memcpy(by_decay + 3 * k, by_law.decay, sizeof by_law.decay);
        memcpy(by_speed + 3 * k, by_law.rolling_speed, sizeof by_law.rolling_speed);
        memcpy(by_slope + 3 * k, by_law.slope_factor, sizeof by_law.slope_factor);
        memcpy(by_slide + 3 * k, by_law.slide_factor, sizeof by_law.slide_factor);
        memcpy(by_layer + 3 * k, by_law.layer, sizeof by_law.layer);
    }
    warn(&seen);
    return made;
}

/* (contact, creepage, model, strips): forces alone */
static mxArray *forces(int count, const mxArray *in[])
{
    const kstrip_options options = options_of(given(count, in, 2), given(count, in, 3));
    const size_t n = common(columns(given(count, in, 1), "creepage", 3, sizeof(kstrip_creepage)),
                            columns(given(count, in, 0), "contact", 6, sizeof(kstrip_contact)));
    mxArray *made = mxCreateDoubleMatrix(3, n, mxREAL);
    double *force = mxGetPr(made);
    report seen = {{0}, {0}};
    for (size_t k = 0; k < n; k++) {
        kstrip_contact contact;
        kstrip_creepage creepage;
        kstrip_result result;
        load(&contact, sizeof contact, in[0], k);
        load(&creepage, sizeof creepage, in[1], k);
        note(&seen, kstrip_solve(&contact, &creepage, &options, &result), k);
        force[3 * k] = result.fx, force[3 * k + 1] = result.fy, force[3 * k + 2] = result.mz;
    }
    warn(&seen);
    return made;
}

/* (contact, motion, friction, model, strips) */
static mxArray *in_motion(int count, const mxArray *in[])
{
    const mxArray *law = given(count, in, 2);
    const kstrip_options options = options_of(given(count, in, 3), given(count, in, 4));
    size_t n = common(columns(given(count, in, 0), "contact", 6, sizeof(kstrip_contact)),
                      columns(given(count, in, 1), "motion", 4, sizeof(kstrip_motion)));
    if (law) n = common(n, columns(law, "friction", 5, sizeof(kstrip_friction)));
    mxArray *made = mxCreateStructMatrix(1, 1, 0, NULL);
    const result_fields to = results(made, n);
    double *by_slip = cube(made, "by_slip", n), *by_speed = field(made, "by_rolling_speed", 3, n);
    double *by_load = field(made, "by_load", 3, n), *by_hertz = field(made, "by_load_through_hertz", 3, n);
    double *by_friction = field(made, "by_friction", 3, n);
    report seen = {{0}, {0}};
    for (size_t k = 0; k < n; k++) {
        kstrip_contact contact;
        kstrip_motion motion;
        kstrip_friction friction;
        kstrip_result result;
        kstrip_motion_derivatives by;
        double left;
        const kstrip_motion_outputs outputs = {.result = &result, .derivatives = &by, .friction = &left};
        load(&contact, sizeof contact, in[0], k);
        load(&motion, sizeof motion, in[1], k);
        if (law) load(&friction, sizeof friction, law, k);
        note(&seen, kstrip_solve_motion(&contact, &motion, law ? &friction : NULL, &options, &outputs), k);
        put_result(&to, k, &result, left);
        put_rows(by_slip, k, (const double(*)[3])by.slip);
        memcpy(by_speed + 3 * k, by.rolling_speed, sizeof by.rolling_speed);
        memcpy(by_load + 3 * k, by.normal_force, sizeof by.normal_force);
        memcpy(by_hertz + 3 * k, by.load_through_hertz, sizeof by.load_through_hertz);
        memcpy(by_friction + 3 * k, by.friction, sizeof by.friction);
    }
    warn(&seen);
    return made;
}

/* (radii, pair, load, friction): contacts and ellipses */
static void hertz(int outputs, mxArray *out[], int count, const mxArray *in[])
{
    const mxArray *loads = given(count, in, 2);
    size_t n = common(columns(given(count, in, 0), "radii", 4, sizeof(kstrip_radii)),
                      columns(given(count, in, 1), "pair", 2, sizeof(kstrip_combined_material)));
    n = common(n, columns(loads, "load", 1, sizeof(double)));
    const double friction = scalar(given(count, in, 3), 0);
    const size_t members = sizeof(kstrip_contact) / sizeof(double), of_ellipse = sizeof(kstrip_hertz_contact) / sizeof(double);
    out[0] = mxCreateDoubleMatrix(members, n, mxREAL);
    mxArray *ellipses = mxCreateDoubleMatrix(of_ellipse, n, mxREAL);
    report seen = {{0}, {0}};
    for (size_t k = 0; k < n; k++) {
        kstrip_radii radii;
        kstrip_combined_material pair;
        kstrip_contact contact;
        kstrip_hertz_contact ellipse;
        load(&radii, sizeof radii, in[0], k);
        load(&pair, sizeof pair, in[1], k);
        note(&seen, kstrip_contact_from_hertz(&radii, &pair, mxGetPr(loads)[mxGetN(loads) > 1 ? k : 0], friction, &contact, &ellipse), k);
        memcpy(mxGetPr(out[0]) + members * k, &contact, sizeof contact);
        memcpy(mxGetPr(ellipses) + of_ellipse * k, &ellipse, sizeof ellipse);
    }
    warn(&seen);
    if (outputs > 1) out[1] = ellipses;
}

/* (y, distance, struct): a patch, and what presses it */
static void from_profile(int outputs, mxArray *out[], int count, const mxArray *in[])
{
    static const char *const names[] = {"rolling_radius", "normal_force", "approach", "smoothing_length", "shear_modulus", "poisson_ratio",
                                        "friction", "strips", "centre_x", "rolling_radii"};
    const mxArray *y = given(count, in, 0), *distance = given(count, in, 1), *of = given(count, in, 2);
    if (!y || !distance || !mxIsDouble(y) || !mxIsDouble(distance) || mxGetNumberOfElements(y) != mxGetNumberOfElements(distance) || !of ||
        !mxIsStruct(of))
        mexErrMsgIdAndTxt("kstrip:argument", "kstrip: y and distance must be vectors of one length, options a struct: help kstrip_patch_from_profile");
    for (int i = 0; i < mxGetNumberOfFields(of); i++) {
        int known = 0;
        for (size_t j = 0; j < sizeof names / sizeof *names; j++) known |= strcmp(mxGetFieldNameByNumber(of, i), names[j]) == 0;
        if (!known) mexErrMsgIdAndTxt("kstrip:argument", "kstrip: unknown field %s: help kstrip_patch_from_profile", mxGetFieldNameByNumber(of, i));
    }
    const double *along[2] = {NULL, NULL};
    for (int i = 0; i < 2; i++) {
        const mxArray *values = mxGetField(of, 0, names[8 + i]);
        if (values && (!mxIsDouble(values) || mxGetNumberOfElements(values) != mxGetNumberOfElements(y)))
            mexErrMsgIdAndTxt("kstrip:argument", "kstrip: %s must have one number for each point", names[8 + i]);
        if (values) along[i] = mxGetPr(values);
    }
    double numbers[8];
    for (int i = 0; i < 8; i++) numbers[i] = scalar(mxGetField(of, 0, names[i]), 0);
    const kstrip_profile profile = {mxGetPr(y), mxGetPr(distance), along[0], along[1], (uint32_t)mxGetNumberOfElements(y), 0};
    const kstrip_profile_contact contact = {numbers[0], numbers[1], numbers[2], numbers[3], numbers[4],
                                            numbers[5], numbers[6], (int32_t)numbers[7], 0};
    kstrip_patch patch;
    kstrip_profile_result result;
    report seen = {{0}, {0}};
    note(&seen, kstrip_patch_from_profile(&profile, &contact, &patch, &result), 0);
    warn(&seen);
    out[0] = of_patch(&patch);
    if (outputs > 1) {
        out[1] = mxCreateStructMatrix(1, 1, 0, NULL);
        *field(out[1], "approach", 1, 1) = result.approach;
        *field(out[1], "normal_force", 1, 1) = result.normal_force;
        *field(out[1], "stiffness", 1, 1) = result.stiffness;
        *field(out[1], "peak_pressure", 1, 1) = result.peak_pressure;
        *field(out[1], "peak_y", 1, 1) = result.peak_y;
        *field(out[1], "lowest", 1, 1) = result.lowest;
    }
}

/* (contact, strips) */
static mxArray *from_contact(int count, const mxArray *in[])
{
    const kstrip_options options = options_of(NULL, given(count, in, 1));
    kstrip_contact contact;
    kstrip_patch patch;
    report seen = {{0}, {0}};
    columns(given(count, in, 0), "contact", 6, sizeof contact);
    load(&contact, sizeof contact, in[0], 0);
    note(&seen, kstrip_patch_from_contact(&contact, &options, &patch), 0);
    warn(&seen);
    return of_patch(&patch);
}

/* (y, z, step, smoothing length): a prepared profile, as bytes */
static mxArray *prepare_profile(int count, const mxArray *in[])
{
    const mxArray *y = given(count, in, 0), *z = given(count, in, 1);
    if (!y || !z || !mxIsDouble(y) || !mxIsDouble(z) || mxGetNumberOfElements(y) != mxGetNumberOfElements(z))
        mexErrMsgIdAndTxt("kstrip:argument", "kstrip: y and z must be vectors of one length");
    mxArray *made = mxCreateNumericMatrix(sizeof(kstrip_surface), 1, mxUINT8_CLASS, mxREAL);
    report seen = {{0}, {0}};
    note(&seen,
         kstrip_prepare_profile(mxGetPr(y), mxGetPr(z), (uint32_t)mxGetNumberOfElements(y), scalar(given(count, in, 2), 0),
                                scalar(given(count, in, 3), 0), mxGetData(made)),
         0);
    warn(&seen);
    return made;
}

/* The points of the text of a file as a struct. */
static mxArray *read_profile(int count, const mxArray *in[])
{
    static const char *const names[] = {"y", "z", "notes"};
    const mxArray *text = given(count, in, 0);
    if (!text || !mxIsChar(text)) mexErrMsgIdAndTxt("kstrip:argument", "kstrip: text must be the text of a profile file");
    const uint32_t length = (uint32_t)mxGetNumberOfElements(text), room = length / 4 + 8;
    char *bytes = mxArrayToString(text);
    double *y = mxMalloc(room * sizeof *y), *z = mxMalloc(room * sizeof *z);
    uint32_t points = 0, notes = 0;
    report seen = {{0}, {0}};
    note(&seen, kstrip_read_profile(bytes, length, (uint32_t)scalar(given(count, in, 1), 0), y, z, room, &points, &notes), 0);
    warn(&seen);
    mxArray *to = mxCreateStructMatrix(1, 1, 3, (const char **)names);
    mxArray *across = mxCreateDoubleMatrix(points, 1, mxREAL), *down = mxCreateDoubleMatrix(points, 1, mxREAL);
    memcpy(mxGetPr(across), y, points * sizeof *y), memcpy(mxGetPr(down), z, points * sizeof *z);
    mxSetField(to, 0, "y", across), mxSetField(to, 0, "z", down), mxSetField(to, 0, "notes", mxCreateDoubleScalar(notes));
    mxFree(bytes), mxFree(y), mxFree(z);
    return to;
}

static mxArray *orient_profiles(int count, const mxArray *in[])
{
    static const char *const names[] = {"y", "z", "unit", "notes"};
    const mxArray *y = given(count, in, 0), *z = given(count, in, 1), *counts = given(count, in, 2);
    if (!y || !z || !counts || !mxIsDouble(y) || !mxIsDouble(z) || !mxIsDouble(counts) || mxGetNumberOfElements(y) != mxGetNumberOfElements(z))
        mexErrMsgIdAndTxt("kstrip:argument", "kstrip: y and z must be arrays of one length");
    const size_t points = mxGetNumberOfElements(y);
    const uint32_t profiles = (uint32_t)mxGetNumberOfElements(counts);
    uint32_t *of_each = mxMalloc((profiles + 1) * sizeof *of_each), notes = 0;
    for (uint32_t i = 0; i < profiles; i++) of_each[i] = (uint32_t)mxGetPr(counts)[i];
    mxArray *to = mxCreateStructMatrix(1, 1, 4, (const char **)names);
    mxArray *across = mxCreateDoubleMatrix(points, 1, mxREAL), *down = mxCreateDoubleMatrix(points, 1, mxREAL);
    double unit = 0;
    report seen = {{0}, {0}};
    note(&seen, kstrip_orient_profiles(mxGetPr(y), mxGetPr(z), of_each, profiles, (uint32_t)scalar(given(count, in, 3), 0),
                                       scalar(given(count, in, 4), 0), mxGetPr(across), mxGetPr(down), &unit, &notes), 0);
    warn(&seen);
    mxSetField(to, 0, "y", across), mxSetField(to, 0, "z", down);
    mxSetField(to, 0, "unit", mxCreateDoubleScalar(unit)), mxSetField(to, 0, "notes", mxCreateDoubleScalar(notes));
    mxFree(of_each);
    return to;
}

static const kstrip_surface *surface_of(const mxArray *of, const char *name)
{
    if (!of || !mxIsUint8(of) || mxGetNumberOfElements(of) != sizeof(kstrip_surface))
        mexErrMsgIdAndTxt("kstrip:argument", "kstrip: %s must be made by kstrip_prepare_profile", name);
    return mxGetData(of);
}

static mxArray *profile_between(int count, const mxArray *in[])
{
    const kstrip_surface *first = surface_of(given(count, in, 0), "first"), *second = surface_of(given(count, in, 1), "second");
    mxArray *made = mxCreateNumericMatrix(sizeof(kstrip_surface), 1, mxUINT8_CLASS, mxREAL);
    report seen = {{0}, {0}};
    note(&seen, kstrip_profile_between(first, second, scalar(given(count, in, 2), 0), mxGetData(made)), 0);
    warn(&seen);
    return made;
}

/* The members of kstrip_wheel_pair as fields; those that are not given are zero. With `more` those of a wheelset and its track too. */
static kstrip_wheel_pair pair_of(const mxArray *of, int more)
{
    static const char *const names[] = {"wheel_radius", "shear_modulus", "poisson_ratio", "friction", "left",
                                        "smoothing_length", "strips", "model", "friction_y", "friction_at", "normal_damping", "floor_speed",
                                        "rail_radius", "rail_ahead", "rail_speed",
                                        "back_to_back", "running_circles", "gauge", "gauge_depth"};
    const size_t count = more ? sizeof names / sizeof *names : 15;
    kstrip_wheel_pair pair;
    memset(&pair, 0, sizeof pair);
    if (!of || !mxIsStruct(of)) mexErrMsgIdAndTxt("kstrip:argument", "kstrip: pair must be a struct: help kstrip_wheel_on_rail");
    for (int i = 0; i < mxGetNumberOfFields(of); i++) {
        int known = 0;
        for (size_t j = 0; j < count; j++) known |= strcmp(mxGetFieldNameByNumber(of, i), names[j]) == 0;
        if (!known) mexErrMsgIdAndTxt("kstrip:argument", "kstrip: unknown field %s: help kstrip_wheel_on_rail", mxGetFieldNameByNumber(of, i));
    }
    pair.wheel_radius = scalar(mxGetField(of, 0, "wheel_radius"), 0);
    pair.shear_modulus = scalar(mxGetField(of, 0, "shear_modulus"), 0);
    pair.poisson_ratio = scalar(mxGetField(of, 0, "poisson_ratio"), 0);
    pair.friction = scalar(mxGetField(of, 0, "friction"), 0);
    pair.left = scalar(mxGetField(of, 0, "left"), 0) != 0;
    pair.smoothing_length = scalar(mxGetField(of, 0, "smoothing_length"), 0);
    pair.normal_damping = scalar(mxGetField(of, 0, "normal_damping"), 0);
    pair.floor_speed = scalar(mxGetField(of, 0, "floor_speed"), 0);
    pair.rail_radius = scalar(mxGetField(of, 0, "rail_radius"), 0);
    pair.rail_ahead = scalar(mxGetField(of, 0, "rail_ahead"), 0);
    pair.rail_speed = scalar(mxGetField(of, 0, "rail_speed"), 0);
    const kstrip_options options = options_of(mxGetField(of, 0, "model"), mxGetField(of, 0, "strips"));
    pair.strips = options.strips, pair.model = options.model;
    const mxArray *places = mxGetField(of, 0, "friction_y"), *at = mxGetField(of, 0, "friction_at");
    const size_t points = places ? mxGetNumberOfElements(places) : 0;
    if (points > KSTRIP_RAIL_FRICTION_CAPACITY || points != (at ? mxGetNumberOfElements(at) : 0))
        mexErrMsgIdAndTxt("kstrip:argument", "kstrip: friction_y and friction_at must have one length, at most %d", KSTRIP_RAIL_FRICTION_CAPACITY);
    for (size_t i = 0; i < points; i++) pair.friction_y[i] = mxGetPr(places)[i], pair.friction_at[i] = mxGetPr(at)[i];
    pair.friction_points = (uint32_t)points;
    return pair;
}

/* (rail, wheel, pair, position, velocity, friction, by position) */
static mxArray *wheel_on_rail(int count, const mxArray *in[])
{
    static kstrip_wheel_workspace memory;
    const kstrip_surface *rail = surface_of(given(count, in, 0), "rail"), *wheel = surface_of(given(count, in, 1), "wheel");
    const kstrip_wheel_pair pair = pair_of(given(count, in, 2), 0);
    const mxArray *law = given(count, in, 5);
    const int moved = scalar(given(count, in, 6), 0) != 0;
    size_t n = common(columns(given(count, in, 3), "position", 1, sizeof(kstrip_wheel_position)),
                      columns(given(count, in, 4), "velocity", 6, sizeof(kstrip_wheel_velocity)));
    if (law) n = common(n, columns(law, "friction", 5, sizeof(kstrip_friction)));
    mxArray *made = mxCreateStructMatrix(1, 1, 0, NULL);
    double *wrench = field(made, "wrench", 6, n), *dissipation = field(made, "dissipation", 1, n);
    double *normal_force = field(made, "normal_force", 1, n), *contacts = field(made, "contacts", 1, n);
    double *status = field(made, "status", 1, n), *by_velocity = field(made, "by_velocity", 36, n);
    double *by_friction = field(made, "by_friction", 6, n), *by_position = moved ? field(made, "by_position", 24, n) : NULL;
    enum { MOST = KSTRIP_CONTACTS_CAPACITY };
    double *angle = field(made, "contact_angle", MOST, n), *y = field(made, "contact_y", MOST, n);
    double *radius = field(made, "contact_radius", MOST, n), *load_of = field(made, "contact_load", MOST, n);
    report seen = {{0}, {0}};
    for (size_t k = 0; k < n; k++) {
        kstrip_wheel_position position;
        kstrip_wheel_velocity velocity;
        kstrip_friction friction;
        kstrip_wrench on;
        kstrip_wrench_derivatives by;
        kstrip_wrench_by_position by_place;
        load(&position, sizeof position, in[3], k);
        load(&velocity, sizeof velocity, in[4], k);
        if (law) load(&friction, sizeof friction, law, k);
        note(&seen,
             kstrip_wheel_on_rail(rail, wheel, &pair, &position, &velocity, law ? &friction : NULL, &memory, &on, &by,
                                  moved ? &by_place : NULL),
             k);
        memcpy(wrench + 6 * k, on.force, sizeof on.force);
        memcpy(wrench + 6 * k + 3, on.moment, sizeof on.moment);
        dissipation[k] = on.dissipation, normal_force[k] = on.normal_force, contacts[k] = on.contacts, status[k] = on.status_detail;
        memcpy(by_friction + 6 * k, by.friction, sizeof by.friction);
        for (int i = 0; i < 6; i++)
            for (int j = 0; j < 6; j++) by_velocity[36 * k + 6 * j + i] = by.velocity[i][j];
        if (moved) {
            memcpy(by_position + 24 * k, by_place.lateral, sizeof by_place.lateral);
            memcpy(by_position + 24 * k + 6, by_place.vertical, sizeof by_place.vertical);
            memcpy(by_position + 24 * k + 12, by_place.yaw, sizeof by_place.yaw);
            memcpy(by_position + 24 * k + 18, by_place.roll, sizeof by_place.roll);
        }
        for (size_t i = 0; i < MOST && i < memory.count; i++) {
            const kstrip_wheel_contact *contact = &memory.contacts[i];
            angle[MOST * k + i] = contact->angle, radius[MOST * k + i] = contact->radius;
            y[MOST * k + i] = contact->origin[1] + position.lateral, load_of[MOST * k + i] = contact->share * contact->normal_force;
        }
    }
    warn(&seen);
    return made;
}

/* (rail, wheel, pair, position, support, velocity, friction): vertical positions */
static mxArray *height_for_load(int count, const mxArray *in[])
{
    static kstrip_wheel_workspace memory;
    const kstrip_surface *rail = surface_of(given(count, in, 0), "rail"), *wheel = surface_of(given(count, in, 1), "wheel");
    const kstrip_wheel_pair pair = pair_of(given(count, in, 2), 0);
    const mxArray *supports = given(count, in, 4), *moves = given(count, in, 5), *law = given(count, in, 6);
    size_t n = common(columns(given(count, in, 3), "position", 1, sizeof(kstrip_wheel_position)), columns(supports, "support", 1, sizeof(double)));
    if (moves) n = common(n, columns(moves, "velocity", 6, sizeof(kstrip_wheel_velocity)));
    if (law) n = common(n, columns(law, "friction", 5, sizeof(kstrip_friction)));
    mxArray *made = mxCreateDoubleMatrix(1, n, mxREAL);
    report seen = {{0}, {0}};
    for (size_t k = 0; k < n; k++) {
        kstrip_wheel_position position;
        kstrip_wheel_velocity velocity;
        kstrip_friction friction;
        double support;
        load(&position, sizeof position, in[3], k);
        load(&support, sizeof support, supports, k);
        if (moves) load(&velocity, sizeof velocity, moves, k);
        if (law) load(&friction, sizeof friction, law, k);
        note(&seen,
             kstrip_height_for_load(rail, wheel, &pair, &position, support, moves ? &velocity : NULL, law ? &friction : NULL, NULL, &memory,
                                    mxGetPr(made) + k),
             k);
    }
    warn(&seen);
    return made;
}

static void set_and_track(int count, const mxArray *in[], kstrip_wheelset *set, kstrip_track *track)
{
    const mxArray *of = given(count, in, 2);
    memset(set, 0, sizeof *set);
    memset(track, 0, sizeof *track);
    set->pair[0] = pair_of(of, 1);
    track->rail[0] = surface_of(given(count, in, 0), "rail");
    set->wheel[0] = surface_of(given(count, in, 1), "wheel");
    set->back_to_back = scalar(mxGetField(of, 0, "back_to_back"), 0);
    set->running_circles = scalar(mxGetField(of, 0, "running_circles"), 0);
    track->gauge = scalar(mxGetField(of, 0, "gauge"), 0);
    track->gauge_depth = scalar(mxGetField(of, 0, "gauge_depth"), 0);
}

static void put_forces(double *wrench, double *rail, size_t k, const kstrip_wheelset_forces *from)
{
    memcpy(wrench + 6 * k, from->wrench.force, sizeof from->wrench.force);
    memcpy(wrench + 6 * k + 3, from->wrench.moment, sizeof from->wrench.moment);
    memcpy(rail + 6 * k, from->rail, sizeof from->rail);
}

/* (rail, wheel, set, position, velocity) */
static mxArray *wheelset_on_track(int count, const mxArray *in[])
{
    static kstrip_wheelset_workspace memory;
    enum { N = KSTRIP_WHEELSET_FREEDOMS };
    kstrip_wheelset set;
    kstrip_track track;
    set_and_track(count, in, &set, &track);
    const size_t n = common(columns(given(count, in, 3), "position", 1, sizeof(kstrip_wheel_position)),
                            columns(given(count, in, 4), "velocity", 6, sizeof(kstrip_wheel_velocity)));
    mxArray *made = mxCreateStructMatrix(1, 1, 0, NULL);
    double *wrench = field(made, "wrench", 6, n), *rail = field(made, "rail", 6, n);
    double *by_velocity = field(made, "by_velocity", N * N, n), *by_friction = field(made, "by_friction", N, n);
    report seen = {{0}, {0}};
    for (size_t k = 0; k < n; k++) {
        kstrip_wheel_position position;
        kstrip_wheel_velocity velocity;
        kstrip_wheelset_forces forces;
        kstrip_wheelset_derivatives by;
        load(&position, sizeof position, in[3], k);
        load(&velocity, sizeof velocity, in[4], k);
        note(&seen, kstrip_wheelset_on_track(&set, &track, &position, &velocity, &memory, &forces, &by, NULL), k);
        put_forces(wrench, rail, k, &forces);
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) by_velocity[N * N * k + N * j + i] = by.velocity[i][j];
        memcpy(by_friction + N * k, by.friction, sizeof by.friction);
    }
    warn(&seen);
    return made;
}

/* (rail, wheel, set, position, velocity, loads) */
static mxArray *wheelset_settle(int count, const mxArray *in[])
{
    static kstrip_wheelset_workspace memory;
    kstrip_wheelset set;
    kstrip_track track;
    set_and_track(count, in, &set, &track);
    size_t n = common(columns(given(count, in, 3), "position", 1, sizeof(kstrip_wheel_position)),
                      columns(given(count, in, 4), "velocity", 1, sizeof(kstrip_wheel_velocity)));
    n = common(n, columns(given(count, in, 5), "loads", 1, sizeof(kstrip_wheelset_loads)));
    mxArray *made = mxCreateStructMatrix(1, 1, 0, NULL);
    double *place = field(made, "position", 4, n), *moves = field(made, "velocity", 6, n);
    double *wrench = field(made, "wrench", 6, n), *rail = field(made, "rail", 6, n);
    report seen = {{0}, {0}};
    for (size_t k = 0; k < n; k++) {
        kstrip_wheel_position start, position;
        kstrip_wheel_velocity velocity, rates;
        kstrip_wheelset_loads loads;
        kstrip_wheelset_forces forces;
        load(&start, sizeof start, in[3], k);
        load(&velocity, sizeof velocity, in[4], k);
        load(&loads, sizeof loads, in[5], k);
        note(&seen, kstrip_wheelset_settle(&set, &track, &start, &velocity, &loads, &memory, &position, &rates, &forces), k);
        memcpy(place + 4 * k, &position, sizeof position);
        memcpy(moves + 6 * k, &rates, sizeof rates);
        put_forces(wrench, rail, k, &forces);
    }
    warn(&seen);
    return made;
}

/* (contact, points, start, parameters, model, strips): points with rows longitudinal, lateral, spin, fx, fy, weight; NaN: not measured */
static mxArray *fit_friction(int count, const mxArray *in[])
{
    const mxArray *points = given(count, in, 1);
    const kstrip_options options = options_of(given(count, in, 4), given(count, in, 5));
    const size_t n = columns(points, "points", 6, 6 * sizeof(double));
    kstrip_contact contact;
    kstrip_friction start;
    kstrip_friction_fit fit;
    uint32_t bad = (uint32_t)n;
    columns(given(count, in, 0), "contact", 6, sizeof contact);
    columns(given(count, in, 2), "start", 5, sizeof start);
    load(&contact, sizeof contact, in[0], 0);
    load(&start, sizeof start, in[2], 0);
    kstrip_measured_force *measured = mxCalloc(n ? n : 1, sizeof *measured);
    for (size_t k = 0; k < n; k++) {
        const double *row = mxGetPr(points) + 6 * k;
        const int has_x = row[3] == row[3], has_y = row[4] == row[4];
        measured[k] = (kstrip_measured_force){.longitudinal = row[0], .lateral = row[1], .spin = row[2], .fx = has_x ? row[3] : 0,
                                              .fy = has_y ? row[4] : 0, .weight = row[5],
                                              .measured = (has_x ? KSTRIP_MEASURED_FX : 0) | (has_y ? KSTRIP_MEASURED_FY : 0)};
    }
    report seen = {{0}, {0}};
    const kstrip_status status =
        kstrip_fit_friction(&contact, measured, (uint32_t)n, &start, (uint32_t)scalar(given(count, in, 3), 0), &options, &fit, &bad);
    mxFree(measured);
    if (status < 0 && bad >= n) mexErrMsgIdAndTxt("kstrip:status", "kstrip: %s", kstrip_status_string(status));
    note(&seen, status, bad < n ? bad : 0);
    warn(&seen);
    mxArray *made = mxCreateStructMatrix(1, 1, 0, NULL);
    const size_t members = sizeof fit.law / sizeof(double);
    memcpy(field(made, "law", members, 1), &fit.law, sizeof fit.law);
    memcpy(field(made, "standard_errors", members, 1), &fit.standard_errors, sizeof fit.standard_errors);
    *field(made, "residual", 1, 1) = fit.residual;
    *field(made, "steps", 1, 1) = fit.steps;
    *field(made, "status", 1, 1) = status;
    return made;
}

void mexFunction(int outputs, mxArray *output[], int inputs, const mxArray *input[])
{
    char name[32] = "";
    if (inputs > 0 && mxIsChar(input[0])) mxGetString(input[0], name, sizeof name);
    const int count = inputs - 1;
    const mxArray **in = input + 1;
    if (strcmp(name, "solve") == 0)
        output[0] = forces(count, in);
    else if (strcmp(name, "evaluate") == 0)
        output[0] = evaluate(count, in);
    else if (strcmp(name, "solve_motion") == 0)
        output[0] = in_motion(count, in);
    else if (strcmp(name, "contact_from_hertz") == 0)
        hertz(outputs, output, count, in);
    else if (strcmp(name, "patch_from_profile") == 0)
        from_profile(outputs, output, count, in);
    else if (strcmp(name, "patch_from_contact") == 0)
        output[0] = from_contact(count, in);
    else if (strcmp(name, "read_profile") == 0)
        output[0] = read_profile(count, in);
    else if (strcmp(name, "orient_profiles") == 0)
        output[0] = orient_profiles(count, in);
    else if (strcmp(name, "profile_between") == 0)
        output[0] = profile_between(count, in);
    else if (strcmp(name, "prepare_profile") == 0)
        output[0] = prepare_profile(count, in);
    else if (strcmp(name, "wheel_on_rail") == 0)
        output[0] = wheel_on_rail(count, in);
    else if (strcmp(name, "wheelset_on_track") == 0)
        output[0] = wheelset_on_track(count, in);
    else if (strcmp(name, "wheelset_settle") == 0)
        output[0] = wheelset_settle(count, in);
    else if (strcmp(name, "fit_friction") == 0)
        output[0] = fit_friction(count, in);
    else if (strcmp(name, "height_for_load") == 0)
        output[0] = height_for_load(count, in);
    else
        mexErrMsgIdAndTxt("kstrip:argument", "kstrip_call: call the functions kstrip*.m instead, see help kstrip");
}
