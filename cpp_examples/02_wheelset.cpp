// A wheelset on real profiles, S1002 on 60E1: it is released 3 mm beside the middle of the track and runs back at 30 m/s.
//   c++ -std=c++17 -O2 -Iinclude cpp_examples/02_wheelset.cpp target/lib/libkstrip.a -o wheelset
#include "kstrip.hpp"

#include <cstdio>
#include <string>
using namespace kstrip::literals;

kstrip::surface profile(const std::string &name)
{
    const auto points = kstrip::read_profile("tests/data/wheel_rail/" + name + ".csv");
    return kstrip::prepare_profile(points.y, points.z);
}

int main()
{
    const auto rail = profile("uic60"), wheel = profile("s1002");
    kstrip::track track;
    track.rail[0] = &rail, track.gauge = 1435_mm;
    kstrip::wheelset wheelset;
    wheelset.wheel[0] = &wheel, wheelset.back_to_back = 1360_mm;
    wheelset.pair[0] = {460_mm, 82_GPa, 0.28, 0.3};
    kstrip::wheelset_workspace memory;
    // Springs between wheelset and frame
    const double mass = 1500, inertia = 900, spring = 2e6, yaw_spring = 4e6, h = 2e-3;
    const kstrip::wheelset_loads loads{100_kN};
    kstrip::wheel_position at{3_mm};
    kstrip::wheel_velocity moves{30_m_per_s, 0_m_per_s, 0_m_per_s, 0_rad_per_s, -65.2_rad_per_s, 0_rad_per_s};
    for (int step = 0; step <= 200; step++) {
        // Height and roll at which the rails carry the load; forces there, with derivatives with respect to the velocities
        at = kstrip::wheelset_settle(wheelset, track, at, moves, loads, memory).position;
        const auto on = kstrip::wheelset_on_track_with_derivatives(wheelset, track, at, moves, memory);
        const std::array<double, 6> f = on.forces.wrench;
        const auto &d = on.derivatives.velocity;
        if (step % 25 == 0)
            std::printf("%.2f s: %7.3f mm %7.3f mrad\n", step * h, at.lateral / 1_mm, at.yaw / 1_mrad);
        // Linearly implicit in lateral (1) and yaw (5): (M - h J) dv = h F
        const double force = f[1] - spring * at.lateral.value, moment = f[5] - yaw_spring * at.yaw.value;
        const double a11 = mass - h * d[1][1], a12 = -h * d[1][5], a21 = -h * d[5][1], a22 = inertia - h * d[5][5];
        const double det = a11 * a22 - a12 * a21;
        moves.lateral += kstrip::metres_per_second(h * (a22 * force - a12 * moment) / det);
        moves.yaw += kstrip::radians_per_second(h * (a11 * moment - a21 * force) / det);
        at.lateral += kstrip::metres(h * moves.lateral.value), at.yaw += kstrip::radians(h * moves.yaw.value);
    }
}
