// A wheelset on real profiles, S1002 on 60E1: it is released 3 mm beside the middle of the track and runs back at 30 m/s.
//
//   c++ -std=c++17 -O2 -Iinclude cpp_examples/02_wheelset.cpp target/lib/libkstrip.a -o wheelset
#include "kstrip.hpp"

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>

using namespace kstrip::literals;

// Positions, velocities and forces are six numbers each, in this order [m, rad].
enum : std::size_t { forward, lateral, vertical, roll, pitch, yaw };
using six = std::array<double, 6>;

kstrip::surface profile(const std::string &name)
{
    const auto points = kstrip::read_profile("tests/data/wheel_rail/" + name + ".csv");
    return kstrip::prepare_profile(points.y, points.z);
}

int main()
{
    const kstrip::surface rail = profile("uic60"), wheel = profile("s1002");
    kstrip::track track;
    track.rail[0] = &rail;
    track.gauge = 1435_mm;
    kstrip::wheelset wheelset;
    wheelset.wheel[0] = &wheel;
    wheelset.back_to_back = 1360_mm;
    wheelset.pair[0] = {460_mm, 82_GPa, 0.28, 0.3};
    kstrip::wheelset_workspace memory;

    // The wheelset, springs between it and a frame that runs straight ahead, and the load on its bearings
    const double mass = 1500, inertia = 900;              // kg, kg m^2
    const double lateral_spring = 2e6, yaw_spring = 4e6;  // N/m, N m/rad
    const kstrip::wheelset_loads load{100_kN};
    const double step = 2e-3; // s

    six position{}, velocity{};
    position[lateral] = 3e-3;
    velocity[forward] = 30;
    for (int i = 0; i <= 200; i++) {
        if (i % 25 == 0)
            std::printf("%.2f s: %7.3f mm %7.3f mrad\n", i * step, 1e3 * position[lateral], 1e3 * position[yaw]);
        // Height, roll and pitch rate at which the rails carry the load
        const auto still = kstrip::wheelset_settle(wheelset, track, kstrip::wheel_position_of(position),
                                                   kstrip::wheel_velocity_of(velocity), load, memory);
        // Forces there, and their derivatives with respect to the velocities
        const auto on = kstrip::wheelset_on_track_with_derivatives(wheelset, track, still.position, still.velocity, memory);
        const six force = on.forces.wrench;
        const auto &slope = on.derivatives.velocity;

        // Creep forces are stiff dampers, so that the step is implicit: (M - h dF/dv) (change of v) = h F
        const double f = step * (force[lateral] - lateral_spring * position[lateral]);
        const double m = step * (force[yaw] - yaw_spring * position[yaw]);
        const double a = mass - step * slope[lateral][lateral], b = -step * slope[lateral][yaw];
        const double c = -step * slope[yaw][lateral], d = inertia - step * slope[yaw][yaw];
        velocity[lateral] += (d * f - b * m) / (a * d - b * c);
        velocity[yaw] += (a * m - c * f) / (a * d - b * c);
        position[lateral] += step * velocity[lateral];
        position[yaw] += step * velocity[yaw];
    }
}
