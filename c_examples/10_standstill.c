/*
 * Through standstill in one run: a vehicle on a slope of 1:50 brakes to rest, is held, rolls back, is held again and drives off.
 * Each linearly implicit step of 1/60 s makes one call of kstrip_solve_motion(). The program checks itself: its exit code is 0 when the
 * vehicle was held, rolled and gained no energy, as it must.
 *   cc -std=c99 -Iinclude c_examples/10_standstill.c target/lib/libkstrip.a -lm -o standstill
 */
#include "kstrip.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* x points uphill. One wheel and its share of the vehicle: masses [kg] (rim: inertia/radius^2), weight along the slope [N] */
static const double mass = 8150, rim = 400, weight = 8150 * 9.81 / 50, step = 1.0 / 60;
static const double brake = 6e3, drive = 6e3; /* at the rim [N] */

typedef struct { double place, vehicle, wheel; } state; /* m, m/s, m/s: speeds of the vehicle and of the wheel's rim */
typedef struct { double force, by_vehicle, by_wheel; } creep; /* on the rail [N], [N s/m] */

/* The wheel's surface moves with vehicle - wheel over the rail; the rail gets the force, the wheel its opposite. */
static creep creep_force(const kstrip_contact *contact, const state *s)
{
    const kstrip_motion motion = {.slip_x = s->vehicle - s->wheel, .rolling_speed = s->vehicle};
    kstrip_result result;
    kstrip_motion_derivatives d;
    const kstrip_motion_outputs outputs = {.result = &result, .derivatives = &d};
    const kstrip_status status = kstrip_solve_motion(contact, &motion, NULL, NULL, &outputs);
    if (status < 0) {
        fprintf(stderr, "%s\n", kstrip_status_string(status));
        exit(EXIT_FAILURE);
    }
    if (result.power < 0) {
        fprintf(stderr, "friction drives: %g W at %g m/s\n", result.power, s->vehicle);
        exit(EXIT_FAILURE);
    }
    const double by_slip = d.slip[0][0]; /* close to C/V, at standstill C/floor */
    return (creep){result.fx, by_slip + d.rolling_speed[0], -by_slip};
}

/* (1 - h J) (change of state) = h (rates), J the Jacobian of the rates:
       mass d(vehicle)/dt = -force - weight,   rim d(wheel)/dt = force + torque */
static void advance(const kstrip_contact *contact, state *s, double torque, int braked)
{
    const creep c = creep_force(contact, s);
    const double p = 1 + step * c.by_vehicle / mass, q = step * c.by_wheel / mass;
    const double r = -step * c.by_vehicle / rim, u = 1 - step * c.by_wheel / rim;
    const double f = -step * (c.force + weight) / mass;
    const double g = step * (c.force + torque - (braked ? copysign(brake, s->wheel) : 0)) / rim;
    double vehicle = (f * u - g * q) / (p * u - q * r), wheel = (p * g - r * f) / (p * u - q * r);
    if (braked && (s->wheel == 0 || s->wheel * (s->wheel + wheel) < 0)) { /* the brake holds the wheel */
        wheel = -s->wheel;
        vehicle = (f - q * wheel) / p;
    }
    s->place += step * (s->vehicle + vehicle / 2);
    s->vehicle += vehicle, s->wheel += wheel;
}

static double energy(const state *s)
{
    return (mass * s->vehicle * s->vehicle + rim * s->wheel * s->wheel) / 2 + weight * s->place;
}

static void check(int holds, const char *what)
{
    if (holds) return;
    fprintf(stderr, "wrong: %s\n", what);
    exit(EXIT_FAILURE);
}

int main(void)
{
    const kstrip_material steel = {82e9, 0.28};
    const kstrip_radii radii = {INFINITY, 0.30, 0.46, INFINITY};
    kstrip_combined_material pair;
    kstrip_contact contact;
    if (kstrip_material_combine(&steel, &steel, &pair) != KSTRIP_OK ||
        kstrip_contact_from_hertz(&radii, &pair, mass * 9.81, 0.3, &contact, NULL) != KSTRIP_OK)
        return EXIT_FAILURE;

    state s = {0, 2, 2}, held = s;
    for (int n = 0; n < 20 * 60; n++) {
        const double t = n * step, before = energy(&s), wheel = s.wheel;
        const int braked = t < 8 || (t >= 11 && t < 16), driven = t >= 16;
        if (n == 5 * 60 || n == 14 * 60) held = s;
        advance(&contact, &s, driven ? drive : 0, braked);
        /* no energy from nowhere: a step is right to first order, a millionth of the first energy */
        check(energy(&s) - before <= driven * drive * step * (wheel + s.wheel) / 2 + 0.016, "energy is gained");
        if ((n + 1) % 60 == 0)
            printf("%2.0f s: %9.6f m, vehicle %10.7f m/s, wheel %10.7f m/s\n", t + step, s.place, s.vehicle, s.wheel);
        if (n + 1 == 8 * 60 || n + 1 == 16 * 60) {
            const double drift = held.place - s.place;
            printf("held: drifts by %.1f um downhill, at %.2f um/s\n", drift * 1e6, -s.vehicle * 1e6);
            check(s.wheel == 0, "the brake does not hold the wheel");
            check(drift > 0 && drift < 30e-6 && s.vehicle < 0 && s.vehicle > -1e-5, "drifts on the slope");
        }
        if (n + 1 == 11 * 60) /* three seconds downhill as a body of mass and rim */
            check(fabs(s.vehicle / (-3 * weight / (mass + rim)) - 1) < 1e-3, "does not roll back freely");
    }
    check(fabs(s.vehicle / (4 * (drive - weight) / (mass + rim)) - 1) < 2e-3, "does not drive off");
    return EXIT_SUCCESS;
}
