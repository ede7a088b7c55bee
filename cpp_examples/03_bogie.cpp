// A bogie on real profiles, S1002 on 60E1: two wheelsets in a frame are released 4 mm beside the middle and run back at 30 m/s.
//   c++ -std=c++17 -O2 -Iinclude cpp_examples/03_bogie.cpp target/lib/libkstrip.a -o bogie
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
    wheelset.wheel[0] = &wheel, wheelset.back_to_back = 1360_mm, wheelset.pair[0] = {460_mm, 82_GPa, 0.28, 0.3};
    kstrip::wheelset_workspace memory;
    kstrip::wheel_position at[2];
    kstrip::wheel_velocity moves[2] = {{30_m_per_s}, {30_m_per_s}};
    // Lateral and yaw of the front wheelset, the rear one and the frame: masses, and springs between frame and wheelsets
    const double mass[6] = {1500, 900, 1500, 900, 3000, 4000}, springs[2] = {5e6, 2e7}, arm[2] = {1.25, -1.25}, h = 2e-3;
    double q[6] = {4e-3, 0, 4e-3, 0, 4e-3, 0}, v[6] = {};
    for (int step = 0; step <= 320; step++) {
        if (step % 40 == 0) std::printf("%.2f s: %7.3f %7.3f %7.3f mm\n", step * h, 1e3 * q[0], 1e3 * q[2], 1e3 * q[4]);
        // Linearly implicit: (M - h dF/dv - h^2 dF/dq) dv = h (F + h dF/dq v); the right-hand side is the last column
        double a[6][7] = {{mass[0]}, {0, mass[1]}, {0, 0, mass[2]}, {0, 0, 0, mass[3]}, {0, 0, 0, 0, mass[4]}, {0, 0, 0, 0, 0, mass[5]}};
        for (int w = 0, y = 0; w < 2; w++, y += 2) {
            at[w].lateral = kstrip::metres(q[y]), at[w].yaw = kstrip::radians(q[y + 1]);
            moves[w].lateral = kstrip::metres_per_second(v[y]), moves[w].yaw = kstrip::radians_per_second(v[y + 1]);
            const auto still = kstrip::wheelset_settle(wheelset, track, at[w], moves[w], {100_kN}, memory);
            at[w] = still.position, moves[w] = still.velocity;
            const auto on = kstrip::wheelset_on_track_with_derivatives(wheelset, track, at[w], moves[w], memory);
            const std::array<double, 6> f = on.forces.wrench;
            a[y][6] += h * f[1], a[y + 1][6] += h * f[5];
            for (int n = 0; n < 4; n++)
                a[y + n / 2][y + n % 2] -= h * on.derivatives.velocity[n / 2 ? 5 : 1][n % 2 ? 5 : 1];
            double stretch[2][6] = {{0, 0, 0, 0, -1, -arm[w]}, {0, 0, 0, 0, 0, -1}};
            stretch[0][y] = stretch[1][y + 1] = 1;
            for (int n = 0; n < 72; n++) {
                const int s = n / 36, i = n / 6 % 6, j = n % 6;
                const double k = h * springs[s] * stretch[s][i] * stretch[s][j];
                a[i][j] += h * k, a[i][6] -= k * (q[j] + h * v[j]);
            }
        }
        for (int n = 0; n < 36; n++) // Gauss and Jordan
            for (int i = n / 6, j = n % 6, k = 6; j != i && k >= i; k--)
                a[j][k] -= a[j][i] / a[i][i] * a[i][k];
        for (int i = 0; i < 6; i++)
            v[i] += a[i][6] / a[i][i], q[i] += h * v[i];
    }
}
