// A driven and braked wheelset in ODE, the Open Dynamics Engine: ODE finds the contacts and solves the motion, kstrip gives the
// friction.
//
//   make && c++ -O2 -Iinclude hosts/ode/wheelset.cpp target/lib/libkstrip.a $(pkg-config --cflags --libs ode) -o target/ode && target/ode
//
// Engines take explicit friction forces only at thousands of steps a second: a creep force grows by some 10^7 N per m/s of slip.
// ODE has what it needs to take it implicitly. In a contact with `slip` c and `motion` m along a direction it solves
//     v + c F = m
// for its velocity v and the force F on the wheel, together with all joints. A creep law, linearised at the slip v0 of the last
// step, is of this form: with the force -f on the wheel and the slope k = df/dv of kstrip_solve_motion(),
//     F = -f - k (v - v0)   <=>   c = 1/k,  m = v0 - f/k.
// Speed, standstill and reversal need no case of their own.
//
// 4 s of driving torque, 4 s of rolling, then a brake that locks the axle on a slope of 1 in 50, to standstill, and hold. Printed
// for several step rates: speed and slip at the end of driving, speed and drift in 3 s while standing.
#include <kstrip.h>
#include <ode/ode.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>

namespace {

constexpr double radius = 0.46, friction = 0.3, wheel_load = 80e3, gravity = 9.81, slope = 0.02;
constexpr double axle_mass = 1800, car_mass = 14500;
constexpr double torque = 0.5 * friction * 2 * wheel_load * radius, brake = 0.48 * friction * 2 * wheel_load * radius;

struct Wheelset {
    dWorldID world;
    dSpaceID space;
    dJointGroupID contacts;
    dBodyID axle, car;
    dGeomID wheel[2];
    dJointID bearing;
    dJointFeedback feedback[2]; // of the last step
    double load[2], slip[2], step;
    long calls;
};

void check(kstrip_status status)
{
    if (status >= 0) return;
    std::fprintf(stderr, "%s\n", kstrip_status_string(status));
    std::exit(1);
}

// ODE's collision callback: one contact of wheel and rail.
void touch(void *data, dGeomID first, dGeomID second)
{
    Wheelset &set = *static_cast<Wheelset *>(data);
    dContact contact = {};
    if (dCollide(first, second, 1, &contact.geom, sizeof contact) == 0) return;
    const int side = first == set.wheel[0] || second == set.wheel[0] ? 0 : 1;
    const dReal *place = contact.geom.pos, *speed = dBodyGetLinearVel(set.axle), *turn = dBodyGetAngularVel(set.axle);
    dVector3 at;
    dBodyGetPointVel(set.axle, place[0], place[1], place[2], at);

    // ODE: x ahead, y to the left, z up. kstrip: x ahead, y to the right, z down.
    const kstrip_radii radii = {INFINITY, 0.3, radius, INFINITY};
    const kstrip_combined_material steel = {82e9, 0.28, 0};
    kstrip_contact patch;
    check(kstrip_contact_from_hertz(&radii, &steel, set.load[side], friction, &patch, nullptr));
    const kstrip_motion motion = {at[0], -at[1], -turn[2], speed[0], 0};
    kstrip_result force;
    kstrip_motion_derivatives by;
    kstrip_motion_outputs outputs = {};
    outputs.result = &force;
    outputs.derivatives = &by;
    check(kstrip_solve_motion(&patch, &motion, nullptr, nullptr, &outputs));
    set.slip[side] = at[0];
    set.calls++;

    dSurfaceParameters &surface = contact.surface;
    surface.mode = dContactFDir1 | dContactSlip1 | dContactSlip2 | dContactMotion1 | dContactMotion2 | dContactSoftERP | dContactSoftCFM;
    surface.mu = dInfinity; // the creep law has its own bound
    contact.fdir1[0] = 1;   // ODE's second direction is normal x first = to the left
    // A saturated force has no slope: what is left keeps the step bounded.
    const double least = 1e-4 * 1.5e7 / std::hypot(speed[0], 0.02);
    const double kx = std::fmax(by.slip[0][0], least), ky = std::fmax(by.slip[1][1], least);
    surface.slip1 = 1 / kx;
    surface.motion1 = at[0] - force.fx / kx;
    surface.slip2 = 1 / ky;
    surface.motion2 = at[1] + force.fy / ky;
    dBodyAddTorque(set.axle, 0, 0, force.mz);
    // Support: a spring softer than Hertz's, half damped
    const double spring = 1.5e7, damper = 2 * 0.5 * std::sqrt(spring * 8e3);
    surface.soft_erp = set.step * spring / (set.step * spring + damper);
    surface.soft_cfm = 1 / (set.step * spring + damper);

    const dJointID joint = dJointCreateContact(set.world, set.contacts, &contact);
    dJointAttach(joint, dGeomGetBody(contact.geom.g1), dGeomGetBody(contact.geom.g2));
    dJointSetFeedback(joint, &set.feedback[side]);
}

void build(Wheelset &set)
{
    set.world = dWorldCreate();
    dWorldSetGravity(set.world, 0, 0, -gravity);
    dWorldSetERP(set.world, 0.8);
    dWorldSetCFM(set.world, 1e-12);
    set.space = dSimpleSpaceCreate(nullptr);
    set.contacts = dJointGroupCreate(0);
    dCreatePlane(set.space, 0, 0, 1, 0);
    dMass mass;
    set.axle = dBodyCreate(set.world);
    dMassSetParameters(&mass, axle_mass, 0, 0, 0, 1100, 120, 1100, 0, 0, 0);
    dBodySetMass(set.axle, &mass);
    dBodySetPosition(set.axle, 0, 0, radius - wheel_load / 1.5e7);
    dBodySetGyroscopicMode(set.axle, 0);
    for (int side = 0; side < 2; side++) {
        set.wheel[side] = dCreateSphere(set.space, radius);
        dGeomSetBody(set.wheel[side], set.axle);
        dGeomSetOffsetPosition(set.wheel[side], 0, side == 0 ? 0.75 : -0.75, 0);
        set.load[side] = wheel_load;
        set.feedback[side] = {};
    }
    // The car goes straight ahead; the axle turns in it.
    set.car = dBodyCreate(set.world);
    dMassSetParameters(&mass, car_mass, 0, 0, 0, 9e3, 2e4, 2e4, 0, 0, 0);
    dBodySetMass(set.car, &mass);
    dBodySetPosition(set.car, 0, 0, radius - wheel_load / 1.5e7);
    set.bearing = dJointCreateHinge(set.world, nullptr);
    dJointAttach(set.bearing, set.axle, set.car);
    dJointSetHingeAnchor(set.bearing, 0, 0, radius - wheel_load / 1.5e7);
    dJointSetHingeAxis(set.bearing, 0, 1, 0);
    const dJointID keep = dJointCreateAMotor(set.world, nullptr);
    dJointAttach(keep, set.car, nullptr);
    dJointSetAMotorNumAxes(keep, 3);
    const int strength[3] = {dParamFMax, dParamFMax2, dParamFMax3};
    for (int axis = 0; axis < 3; axis++) {
        dJointSetAMotorAxis(keep, axis, 0, axis == 0, axis == 1, axis == 2);
        dJointSetAMotorParam(keep, strength[axis], dInfinity);
    }
}

void run(double rate)
{
    Wheelset set = {};
    set.step = 1 / rate;
    build(set);
    const dReal *place = dBodyGetPosition(set.axle), *speed = dBodyGetLinearVel(set.axle);
    double driven = 0, slip = 0, stood = 0;
    for (long i = 0; i < std::lround(16 * rate); i++) {
        const double time = i * set.step;
        if (time < 4) {
            dBodyAddTorque(set.axle, 0, torque, 0);
            dBodyAddTorque(set.car, 0, -torque, 0);
        }
        if (time >= 8) {
            dJointSetHingeParam(set.bearing, dParamVel, 0);
            dJointSetHingeParam(set.bearing, dParamFMax, brake);
            dBodyAddForce(set.car, -gravity * (axle_mass + car_mass) * slope, 0, 0);
        }
        dSpaceCollide(set.space, &set, touch);
        dWorldStep(set.world, set.step);
        dJointGroupEmpty(set.contacts);
        for (int side = 0; side < 2; side++) set.load[side] = std::fabs(set.feedback[side].f1[2]);
        if (i == std::lround(3.9 * rate)) driven = speed[0], slip = set.slip[0];
        if (i == std::lround(13 * rate)) stood = place[0];
    }
    std::printf("%6.0f Hz: driven %.5f m/s, slip %.6f m/s; standing %.2e m/s, drift in 3 s %.5f mm; load %.0f N; calls %ld\n", rate, driven, slip, speed[0],
                (place[0] - stood) * 1e3, set.load[0], set.calls);
    dJointGroupDestroy(set.contacts);
    dSpaceDestroy(set.space);
    dWorldDestroy(set.world);
}

} // namespace

int main()
{
    dInitODE2(0);
    for (const double rate : {60.0, 240.0, 1000.0, 4000.0}) run(rate);
    dCloseODE();
}
