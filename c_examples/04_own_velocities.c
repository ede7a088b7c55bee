/*
 * From the velocities of two rigid bodies to the forces on both, as in a multibody program.
 *
 *   cc -std=c99 -Iinclude c_examples/04_own_velocities.c target/lib/libkstrip.a -o velocities
 */
#include "kstrip.h"
#include <stdio.h>
#include <stdlib.h>

typedef struct vector {
    double x, y, z;
} vector;

typedef struct body {
    vector velocity; /* of its centre, seen from the contact, which moves along the rail [m/s] */
    vector angular;  /* angular velocity [rad/s] */
    vector arm;      /* from its centre to the contact [m] */
} body;

static double dot(vector a, vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/* Motion of the body's surface at the contact, along the axes of the contact. */
static kstrip_velocity at_contact(const body *m, const vector axes[3])
{
    const vector w = m->angular, r = m->arm; /* velocity + angular x arm */
    const vector v = {m->velocity.x + w.y * r.z - w.z * r.y, m->velocity.y + w.z * r.x - w.x * r.z,
                      m->velocity.z + w.x * r.y - w.y * r.x};
    const kstrip_velocity seen = {dot(v, axes[0]), dot(v, axes[1]), dot(w, axes[2])};
    return seen;
}

static void check(kstrip_status status)
{
    if (status != KSTRIP_OK)
        fprintf(stderr, "kstrip: %s\n", kstrip_status_string(status));
    if (status < 0)
        exit(EXIT_FAILURE);
}

/* Power of the contact forces on a body [W]; prints the force along the world's axes. */
static double report(const char *name, const kstrip_result *f, kstrip_velocity v,
                     const vector axes[3])
{
    printf("force on the %-5s  x %.4f  y %.4f  z %.4f N, moment %.6f N m\n", name,
           f->fx * axes[0].x + f->fy * axes[1].x, f->fx * axes[0].y + f->fy * axes[1].y,
           f->fx * axes[0].z + f->fy * axes[1].z, f->mz);
    return f->fx * v.x + f->fy * v.y + f->mz * v.angular_z;
}

int main(void)
{
    /* World: x forward, y to the right, z down. A train at 20 m/s; the wheel turns 0.1 % too fast
       (it pulls) and points 1 mrad to the right of the rail. The contact plane is tilted by 50 mrad
       about x, hence spin. Axes of the contact: rolling direction, lateral, into the rail. */
    const double speed = 20, radius = 0.46, spin_rate = 1.001 * speed / radius; /* m/s, m, rad/s */
    const double cos_yaw = 0.9999995000000417, sin_yaw = 0.0009999998333333417;
    const double cos_tilt = 0.9987502603949663, sin_tilt = 0.04997916927067833;
    const vector axes[3] = {{1, 0, 0}, {0, cos_tilt, sin_tilt}, {0, -sin_tilt, cos_tilt}};
    const body rail = {{-speed, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    const body wheel = {{0, 0, 0}, {spin_rate * sin_yaw, -spin_rate * cos_yaw, 0}, {0, 0, radius}};
    /* a, b [m], load [N], shear modulus [Pa], Poisson's ratio, friction: see 01_wheel_rail.c */
    const kstrip_contact contact = {6e-3, 4.5e-3, 80e3, 82e9, 0.28, 0.3, 0};

    const kstrip_velocity lower = at_contact(&rail, axes), upper = at_contact(&wheel, axes);
    kstrip_creepage creepage;
    kstrip_result on_rail, on_wheel;
    check(kstrip_creepage_from_velocities(&lower, &upper, speed, &creepage));
    check(kstrip_solve(&contact, &creepage, NULL, &on_rail)); /* forces on the lower body */
    check(kstrip_result_on_upper_body(&on_rail, &on_wheel));
    printf("creepage: longitudinal %.9f, lateral %.9f, spin %.9f 1/m\n", creepage.longitudinal,
           creepage.lateral, creepage.spin);
    double power = report("rail", &on_rail, lower, axes);
    power += report("wheel", &on_wheel, upper, axes);
    printf("power of the forces on both bodies %.6f W\n", power);
    printf("frictional heat                    %.6f W\n", on_rail.power * speed);
    return EXIT_SUCCESS;
}
