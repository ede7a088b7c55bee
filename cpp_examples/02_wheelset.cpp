// A wheelset on real profiles, S1002 on 60E1: it is released 3 mm beside the middle of the track and runs back at 30 m/s.
//   c++ -std=c++17 -O2 -Iinclude cpp_examples/02_wheelset.cpp target/lib/libkstrip.a -o wheelset
#include "kstrip.hpp"

#include <cstdio>
#include <fstream>
#include <string>
using namespace kstrip::literals;

kstrip::surface profile(const std::string &name)
{
    std::ifstream file("tests/data/wheel_rail/" + name + ".csv");
    file.ignore(80, '\n');
    std::vector<double> y, z;
    char comma;
    for (double a, b; file >> a >> comma >> b;)
        y.push_back(1e-3 * a), z.push_back(1e-3 * b);
    return kstrip::prepare_profile(y, z);
}

int main()
{
    const auto rail = profile("uic60"), wheel = profile("s1002");
    // Half the distance of the running circles, and of the rails' origins
    const auto b = 750_mm, origin = 760.5325_mm, radius = 460_mm;
    const auto speed = 30_m_per_s;
    const auto pitch = -1.0 / radius.value * kstrip::radians_per_second(speed.value);
    const double mass = 1500, inertia = 900, spring = 2e6, yaw_spring = 4e6, h = 1e-3;
    kstrip::wheel_pair pair{radius, 82_GPa, 0.28, 0.3};
    pair.model = kstrip::model::strip;
    kstrip::wheel_workspace memory;
    kstrip::metres y = 3_mm, heights[2]{};
    kstrip::radians yaw{};
    kstrip::metres_per_second vy{};
    kstrip::radians_per_second turn{};
    for (int step = 0; step <= 400; step++) {
        // Force and moment (about z, down) on the wheelset, and their derivatives with respect to vy and turn
        double force = -spring * y.value, moment = -yaw_spring * yaw.value, fv = 0, fw = 0, mv = 0, mw = 0;
        for (const int side : {-1, 1}) {
            const double s = side * b.value;
            pair.left = side < 0;
            auto &height = heights[side > 0];
            height = kstrip::height_for_load(rail, wheel, pair, {y + side * (b - origin), height, yaw}, 50_kN, memory);
            kstrip::wheel_velocity moves{speed - turn * (side * b), vy, 0_m_per_s, 0_rad_per_s, pitch, turn};
            const auto on = kstrip::wheel_on_rail_with_derivatives(rail, wheel, pair, {y + side * (b - origin), height, yaw}, moves, memory);
            const auto &d = on.derivatives.velocity;
            const std::array<double, 6> f = on.wrench;
            force += f[1], moment += f[5] - s * f[0];
            fv += d[1][1], fw += d[1][5] - s * d[1][0];
            mv += d[5][1] - s * d[0][1], mw += d[5][5] - s * (d[5][0] + d[0][5]) + s * s * d[0][0];
        }
        if (step % 50 == 0)
            std::printf("%.2f s: %7.3f mm %7.3f mrad\n", step * h, y / 1_mm, yaw / 1_mrad);
        // Linearly implicit: (M - h J) dv = h F
        const double a11 = mass - h * fv, a12 = -h * fw, a21 = -h * mv, a22 = inertia - h * mw, det = a11 * a22 - a12 * a21;
        vy += kstrip::metres_per_second(h * (a22 * force - a12 * moment) / det);
        turn += kstrip::radians_per_second(h * (a11 * moment - a21 * force) / det);
        y += kstrip::metres(h * vy.value), yaw += kstrip::radians(h * turn.value);
    }
}
