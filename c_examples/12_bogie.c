/*
 * A bogie on flexible rails: two wheelsets, frame, half a car body, and a mass of each rail under each wheel. It hunts in a limit cycle,
 * runs through a curve of 300 m with its flange, brakes to a standstill on a grade, and is lifted by a jack. The numbers are those of an
 * ordinary bogie with weak yaw dampers.
 *   cc -std=c99 -O2 -Iinclude c_examples/12_bogie.c target/lib/libkstrip.a -lm -o bogie && ./bogie tests/data/wheel_rail [hunt|curve|brake|lift]
 * With the word "table" among the runs all wheels take their contacts from a contact table, which is filled first.
 *
 * One rule integrates all of it: the backward differentiation formula of second order, linearly implicit with the derivatives D and K
 * of the forces Q with respect to velocities and places (docs/guide/6-vehicle.md). One evaluation a step:
 *     (3/(2 h) M - D - (2 h/3) K) (change of u) = Q + M u'/2 + K ((change of q before)/3 + (2 h/3) u),   u' = (change of u before)/h
 */
#include "kstrip.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The degrees of freedom: ten of each wheelset with its rails, in the order of the library, then six of the frame and four of the car */
enum { FORWARD, LATERAL, VERTICAL, ROLL, PITCH, YAW, RAILS };
enum { SET = KSTRIP_WHEELSET_FREEDOMS, FRAME = 2 * SET, CAR = FRAME + 6, N = CAR + 4 };

static const double gravity = 9.80665;              /* [m/s^2] */
static const double wheelbase = 2.5, box = 1;       /* distance of the wheelsets, and of a box from the middle [m] */
static const double radius = 0.46;                  /* of a wheel [m] */
static const double mass[N] = {                     /* [kg, kg m^2] */
    1500, 1500, 1500, 800, 110, 800, 80, 120, 80, 120, /* front wheelset; right and left rail, across and down */
    1500, 1500, 1500, 800, 110, 800, 80, 120, 80, 120, /* rear wheelset and its rails */
    2500, 2500, 2500, 1800, 2200, 3000,                /* frame */
    14500, 14500, 14500, 20e3};                        /* half a car body: forward, lateral, vertical, roll */

/* A spring with a damper; its length is a sum of factor times degree of freedom, by_curvature times curvature, and length */
typedef struct {
    int at[6], terms;
    double factor[6], by_curvature, length;
    double stiffness, damping;
    int one_sided; /* it only pushes */
} element;

/* The vehicle and its state */
static struct {
    kstrip_surface rail, wheel;
    kstrip_wheelset set;
    kstrip_track track;
    kstrip_curve curve;
    kstrip_table table;
    kstrip_wheelset_workspace memory;
    kstrip_wheelset_forces forces[2];
    element elements[40];
    int count;
    double place[N], velocity[N];
    double place_change[N], velocity_change[N]; /* in the step before */
    double load[N], brake;                      /* constant forces; torque of the brake on an axle [N m] */
    int held[2];                                /* axles that the brake holds */
    double time;
} b;

/* Forward, lateral, .. of a degree of freedom */
static int direction(int k) { return k < FRAME ? k % SET : (k - FRAME) % 6; }

static void check(kstrip_status status)
{
    if (status >= 0) return;
    fprintf(stderr, "%.4f s: %s\n", b.time, kstrip_status_string(status));
    exit(EXIT_FAILURE);
}

static void read_profile(const char *folder, const char *name, kstrip_surface *surface)
{
    static char text[100000];
    double y[1000], z[1000];
    uint32_t points = 0;
    snprintf(text, sizeof text, "%s/%s", folder, name);
    FILE *file = fopen(text, "rb");
    if (file == NULL) {
        perror(text);
        exit(EXIT_FAILURE);
    }
    const uint32_t length = (uint32_t)fread(text, 1, sizeof text, file);
    fclose(file);
    check(kstrip_read_profile(text, length, KSTRIP_FORMAT_ANY, y, z, 1000, &points, NULL));
    check(kstrip_prepare_profile(y, z, points, 0, 0, surface));
}

/* ---- The vehicle ---- */

static element *join(double stiffness, double damping, int terms, const int *at, const double *factor)
{
    element *e = &b.elements[b.count++];
    *e = (element){.terms = terms, .stiffness = stiffness, .damping = damping};
    memcpy(e->at, at, terms * sizeof *at);
    memcpy(e->factor, factor, terms * sizeof *factor);
    return e;
}
#define LIST(...) {__VA_ARGS__}
#define JOIN(stiffness, damping, terms, at, factor) join(stiffness, damping, terms, (const int[6])at, (const double[6])factor)

/* Springs between a wheelset at x and the frame, at the boxes, and under its rails */
static void suspend(int s, double x)
{
    for (double y = -box; y <= box; y += 2 * box) {
        element *along = JOIN(10e6, 10e3, 4, LIST(s + FORWARD, s + YAW, FRAME + FORWARD, FRAME + YAW), LIST(1, -y, -1, y));
        along->by_curvature = -y * x;
        element *across = JOIN(5e6, 10e3, 3, LIST(s + LATERAL, FRAME + LATERAL, FRAME + YAW), LIST(1, -1, -x));
        across->by_curvature = x * x / 2;
        JOIN(1.2e6, 15e3, 5, LIST(s + VERTICAL, s + ROLL, FRAME + VERTICAL, FRAME + ROLL, FRAME + PITCH), LIST(1, y, -1, -y, x));
    }
    for (int k = s + RAILS; k < s + SET; k += 2) {
        JOIN(20e6, 50e3, 1, LIST(k), LIST(1));
        JOIN(75e6, 90e3, 1, LIST(k + 1), LIST(1));
    }
}

static void build(const char *folder)
{
    read_profile(folder, "uic60.csv", &b.rail);
    read_profile(folder, "s1002.csv", &b.wheel);
    b.track = (kstrip_track){.rail = {&b.rail}, .gauge = 1.435};
    b.set = (kstrip_wheelset){.wheel = {&b.wheel}, .back_to_back = 1.360};
    b.set.pair[0] = (kstrip_wheel_pair){.wheel_radius = radius, .shear_modulus = 82e9, .poisson_ratio = 0.28, .friction = 0.3};
    suspend(0, wheelbase / 2);
    suspend(SET, -wheelbase / 2);
    /* Between frame and car: along, a yaw damper, down, across */
    JOIN(20e6, 100e3, 2, LIST(FRAME + FORWARD, CAR + FORWARD), LIST(1, -1));
    JOIN(0, 5e3, 1, LIST(FRAME + YAW), LIST(1.3));
    for (double y = -box; y <= box; y += 2 * box) {
        JOIN(0.5e6, 20e3, 4, LIST(FRAME + VERTICAL, FRAME + ROLL, CAR + VERTICAL, CAR + ROLL), LIST(1, y, -1, -y));
        JOIN(0.17e6, 25e3, 3, LIST(FRAME + LATERAL, CAR + LATERAL, CAR + ROLL), LIST(1, -1, -1.2));
    }
}

/* A contact table of the right wheel, of which the left one is the mirror image. */
static void fill_table(void)
{
    /* The middle of the track is at -10.5 mm: the wheel may shift by 8 mm to both sides. */
    const kstrip_table_spec spec = {.lateral_from = -18.5e-3, .lateral_to = -2.5e-3, .yaw = 12e-3, .roll = 4e-3, .load = 200e3,
                                    .lateral_nodes = 80, .levels = 14, .yaw_nodes = 3, .roll_nodes = 3};
    const kstrip_wheel_pair *pair = &b.set.pair[0];
    kstrip_wheel_workspace *memory = malloc(sizeof *memory);
    uint32_t bytes, parts;
    kstrip_table_report report;
    check(kstrip_table_size(&b.wheel, &spec, &bytes, &parts));
    uint8_t *block = malloc(bytes);
    if (block == NULL || memory == NULL) {
        fprintf(stderr, "no memory\n");
        exit(EXIT_FAILURE);
    }
    check(kstrip_table_begin(&b.rail, &b.wheel, pair, &spec, memory, block, bytes));
    check(kstrip_table_fill(&b.rail, &b.wheel, pair, 0, parts, memory, block, bytes));
    check(kstrip_table_finish(&b.rail, &b.wheel, pair, 100, memory, block, bytes, &report));
    printf("table %u kB, force %.4f, load %.4f %%\n", (unsigned)(report.bytes / 1000), report.force_usual, 100 * report.load_usual);
    b.table = (kstrip_table){.data = block, .bytes = report.bytes};
    b.set.table[0] = b.set.table[1] = &b.table;
    free(memory);
}

/* Both wheelsets in balance on their rails, from which springs and rails are measured. The axes run along the track with the speed. */
static void start(double speed, double lateral)
{
    const kstrip_wheelset_loads weight = {.vertical = (2 * mass[0] + mass[FRAME] + mass[CAR]) * gravity / 2};
    const kstrip_wheel_position at = {.lateral = lateral};
    const kstrip_wheel_velocity rolls = {.forward = speed};
    kstrip_wheel_position where;
    kstrip_wheel_velocity moves;
    memset(b.place, 0, sizeof b.place);
    memset(b.velocity, 0, sizeof b.velocity);
    memset(b.place_change, 0, sizeof b.place_change);
    memset(b.velocity_change, 0, sizeof b.velocity_change);
    memset(b.load, 0, sizeof b.load);
    memset(b.track.motion, 0, sizeof b.track.motion);
    b.time = b.brake = 0;
    b.held[0] = b.held[1] = 0;
    b.curve = (kstrip_curve){.speed = speed};
    check(kstrip_wheelset_settle(&b.set, &b.track, &at, &rolls, &weight, &b.memory, &where, &moves, &b.forces[0]));
    for (int s = 0; s < FRAME; s += SET) {
        b.place[s + LATERAL] = lateral;
        b.place[s + VERTICAL] = where.vertical;
        b.place[s + ROLL] = where.roll;
        b.velocity[s + PITCH] = moves.pitch;
        b.load[s + VERTICAL] = weight.vertical;
        for (int k = 0; k < 4; k++) b.load[s + RAILS + k] = -b.forces[0].rail[k / 2][1 + k % 2];
    }
    for (element *e = b.elements; e < b.elements + b.count; e++) {
        e->length = 0;
        for (int i = 0; i < e->terms; i++) {
            const int moved_aside = e->at[i] < FRAME && direction(e->at[i]) == LATERAL;
            if (!moved_aside) e->length -= e->factor[i] * b.place[e->at[i]];
        }
    }
}

/* ---- The forces Q at places q and velocities u, and their derivatives D and K ---- */

static kstrip_wheel_position position_of(const double *q)
{
    return (kstrip_wheel_position){.lateral = q[LATERAL], .vertical = q[VERTICAL], .yaw = q[YAW], .roll = q[ROLL]};
}

static kstrip_wheel_velocity velocity_of(const double *u)
{
    return (kstrip_wheel_velocity){u[FORWARD], u[LATERAL], u[VERTICAL], u[ROLL], u[PITCH], u[YAW]};
}

/* Those of wheelset i with its rails, and the weight per mass in the curve */
static void add_wheelset(int i, const double *q, const double *u, double *Q, double (*D)[N], double (*K)[N], double weight[3])
{
    static kstrip_wheelset_derivatives by_velocity;
    static kstrip_wheelset_by_position by_position;
    const int s = i * SET;
    const kstrip_wheel_position position = position_of(q + s);
    const kstrip_wheel_velocity relative = velocity_of(u + s);
    kstrip_wheel_velocity moves;
    kstrip_wheelset_forces *forces = &b.forces[i];
    for (int side = 0; side < 2; side++) {
        const int k = s + RAILS + 2 * side;
        b.track.motion[side] = (kstrip_rail_motion){q[k], q[k + 1], u[k], u[k + 1]};
    }
    check(kstrip_curve_motion(&b.curve, &position, &relative, &moves, weight));
    check(kstrip_wheelset_on_track(&b.set, &b.track, &position, &moves, &b.memory, forces, &by_velocity, &by_position));
    for (int k = 0; k < 3; k++) {
        Q[s + k] += forces->wrench.force[k];
        Q[s + ROLL + k] += forces->wrench.moment[k];
    }
    for (int k = 0; k < 4; k++) Q[s + RAILS + k] += forces->rail[k / 2][1 + k % 2];
    for (int row = 0; row < SET; row++) {
        for (int column = 0; column < SET; column++) {
            D[s + row][s + column] = by_velocity.velocity[row][column];
            K[s + row][s + column] = by_position.position[row][column];
        }
    }
    /* The axle is a gyroscope */
    const double spin = mass[PITCH] * moves.pitch;
    Q[s + ROLL] += spin * moves.yaw;
    Q[s + YAW] -= spin * moves.roll;
    D[s + ROLL][s + YAW] += spin;
    D[s + YAW][s + ROLL] -= spin;
}

static void add_element(const element *e, const double *q, const double *u, double *Q, double (*D)[N], double (*K)[N])
{
    double longer = e->length + e->by_curvature * b.curve.curvature, rate = 0;
    for (int i = 0; i < e->terms; i++) {
        longer += e->factor[i] * q[e->at[i]];
        rate += e->factor[i] * u[e->at[i]];
    }
    const double force = e->stiffness * longer + e->damping * rate;
    if (e->one_sided && force <= 0) return;
    for (int i = 0; i < e->terms; i++) {
        Q[e->at[i]] -= e->factor[i] * force;
        for (int k = 0; k < e->terms; k++) {
            D[e->at[i]][e->at[k]] -= e->factor[i] * e->factor[k] * e->damping;
            K[e->at[i]][e->at[k]] -= e->factor[i] * e->factor[k] * e->stiffness;
        }
    }
}

static void find_forces(const double *q, const double *u, double *Q, double (*D)[N], double (*K)[N])
{
    double weight[3];
    memset(D, 0, N * sizeof *D);
    memset(K, 0, N * sizeof *K);
    memcpy(Q, b.load, sizeof b.load);
    for (int i = 0; i < 2; i++) add_wheelset(i, q, u, Q, D, K, weight);
    /* The curve changes the weight; the weight on straight track is in the loads and springs */
    for (int k = 0; k < N; k++) {
        if (direction(k) == LATERAL) Q[k] += mass[k] * weight[LATERAL];
        if (direction(k) == VERTICAL) Q[k] += mass[k] * (weight[VERTICAL] - gravity);
    }
    for (const element *e = b.elements; e < b.elements + b.count; e++) add_element(e, q, u, Q, D, K);
}

/* ---- Time steps ---- */

/* a = W^-1 a by Gauss's method with row exchanges; W is destroyed */
static void solve(double (*W)[N], double *a)
{
    for (int c = 0; c < N; c++) {
        int best = c;
        for (int r = c + 1; r < N; r++) best = fabs(W[r][c]) > fabs(W[best][c]) ? r : best;
        for (int k = c; k <= N; k++) {
            double *x = k < N ? &W[c][k] : &a[c], *y = k < N ? &W[best][k] : &a[best];
            const double kept = *x;
            *x = *y;
            *y = kept;
        }
        for (int r = c + 1; r < N; r++) {
            const double share = W[r][c] / W[c][c];
            for (int k = c; k < N; k++) W[r][k] -= share * W[c][k];
            a[r] -= share * a[c];
        }
    }
    for (int r = N - 1; r >= 0; r--) {
        for (int k = r + 1; k < N; k++) a[r] -= W[r][k] * a[k];
        a[r] /= W[r][r];
    }
}

/* The brake is a torque between axle and frame. An axle that would turn back within this step is held from now on: a constraint. */
static void apply_brake(double (*W)[N], double *right)
{
    for (int i = 0; i < 2; i++) {
        const int r = i * SET + PITCH;
        const double torque = b.velocity[r] < 0 ? b.brake : -b.brake;
        b.held[i] |= b.brake > 0 && b.velocity[r] * (b.velocity[r] + b.velocity_change[r]) <= 0;
        if (b.held[i]) {
            memset(W[r], 0, sizeof W[r]);
            W[r][r] = 1;
            right[r] = -b.velocity[r];
        } else {
            right[r] += torque;
            right[FRAME + PITCH] -= torque;
        }
    }
}

static void advance(double h)
{
    static double D[N][N], K[N][N], W[N][N];
    double Q[N], change[N];
    find_forces(b.place, b.velocity, Q, D, K);
    for (int r = 0; r < N; r++) {
        change[r] = Q[r] + mass[r] * b.velocity_change[r] / (2 * h);
        for (int c = 0; c < N; c++) {
            W[r][c] = (r == c ? 1.5 / h * mass[r] : 0) - D[r][c] - 2 * h / 3 * K[r][c];
            change[r] += K[r][c] * (b.place_change[c] / 3 + 2 * h / 3 * b.velocity[c]);
        }
    }
    apply_brake(W, change);
    solve(W, change);
    for (int k = 0; k < N; k++) {
        b.velocity[k] += change[k];
        b.velocity_change[k] = change[k];
        b.place_change[k] = b.place_change[k] / 3 + 2 * h / 3 * b.velocity[k];
        b.place[k] += b.place_change[k];
    }
    b.time += h;
}

/* ---- The runs ---- */

static void print(const char *name)
{
    double(*front)[3] = b.forces[0].rail, (*rear)[3] = b.forces[1].rail;
    printf("%s %6.3f s  y %8.4f %8.4f mm", name, b.time, b.place[LATERAL] * 1e3, b.place[SET + LATERAL] * 1e3);
    printf("  speed %9.6f m/s", b.curve.speed + b.velocity[CAR]);
    printf("  Y %9.1f %9.1f  Q %9.1f %9.1f N", front[0][1], front[1][1], front[0][2], front[1][2]);
    printf("  sum of Y %9.2f N\n", front[0][1] + front[1][1] + rear[0][1] + rear[1][1]);
}

/* Runs until a time in steps h; `before` changes the run with time */
static void run(const char *name, double until, double h, void (*before)(double height))
{
    const double height = b.place[VERTICAL] + box * b.place[ROLL];
    for (int i = 0; b.time < until; i++) {
        before(height);
        advance(h);
        if (i % 20 == 0) print(name);
    }
}

static void nothing(double height) { (void)height; }

/* The curve begins within four seconds */
static void enter_curve(double height)
{
    (void)height;
    const double t = fmin(b.time / 4, 1), share = t * t * (3 - 2 * t);
    b.curve.curvature = share / 300;
    b.curve.cant = 0.1 * share;
}

static void apply(double height)
{
    (void)height;
    b.brake = 2e3 * fmin(b.time, 1);
}

/* The jack lifts the box by up to 20 mm from its height at the start */
static void lift(double height) { b.elements[b.count - 1].length = 0.01 * (1 - cos(2 * b.time)) - height; }

int main(int count, char **words)
{
    const char *wanted = count > 2 ? words[2] : "hunt curve brake lift";
    build(count > 1 ? words[1] : "tests/data/wheel_rail");
    if (strstr(wanted, "table"))
        fill_table();
    if (strstr(wanted, "hunt")) {
        start(80, 3e-3);
        run("hunt", 4, 1e-3, nothing);
    }
    if (strstr(wanted, "curve")) {
        start(sqrt(gravity * 300 * tan(0.1)), 0);
        run("curve at balance speed", 8, 2e-3, enter_curve);
        start(22, 0);
        run("curve at 22 m/s", 8, 2e-3, enter_curve);
    }
    if (strstr(wanted, "brake")) {
        start(2, 3e-3);
        for (int k = 0; k < N; k++) /* a grade of 1:50 */
            if (direction(k) == FORWARD) b.load[k] -= mass[k] * gravity / 50;
        run("brake", 12, 2e-3, apply);
    }
    /* A jack under the right box in front */
    JOIN(10e6, 100e3, 2, LIST(VERTICAL, ROLL), LIST(1, box))->one_sided = 1;
    if (strstr(wanted, "lift")) {
        start(5, 0);
        run("lift", 3.15, 2e-3, lift);
    }
    return EXIT_SUCCESS;
}
