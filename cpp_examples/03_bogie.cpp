// A bogie on real profiles, S1002 on 60E1: two wheelsets and a frame with six degrees of freedom each. It runs at 20 m/s into a curve of
// 300 m, where its front wheelset climbs to its flange, and then a roll moment of the car body lifts its right wheels for a moment.
//
//   c++ -std=c++17 -O2 -Iinclude cpp_examples/03_vehicle.cpp target/lib/libkstrip.a -o bogie          (uses Eigen if it is installed)
#include "kstrip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#if __has_include(<Eigen/Dense>)
#include <Eigen/Dense>
#define HAS_EIGEN 1
#elif __has_include(<eigen3/Eigen/Dense>)
#include <eigen3/Eigen/Dense>
#define HAS_EIGEN 1
#endif

using namespace kstrip::literals;

// Six numbers of each body, in the order of the library; the bodies are the front wheelset, the rear wheelset and the frame.
enum : std::size_t { forward, lateral, vertical, roll, pitch, yaw, freedoms, frame = 2 * freedoms, all = 3 * freedoms };
using six = std::array<double, freedoms>;
using vector = std::array<double, all>;
using matrix = std::array<vector, all>;

vector solve(matrix a, vector b)
{
#if defined(HAS_EIGEN)
    using dense = Eigen::Matrix<double, all, all, Eigen::RowMajor>;
    Eigen::Map<Eigen::Matrix<double, all, 1>> x(b.data());
    x = Eigen::Map<dense>(a[0].data()).lu().solve(Eigen::Matrix<double, all, 1>(x));
#else
    for (std::size_t k = 0; k < all; k++) { // Gauss and Jordan; the matrix has a large diagonal
        for (std::size_t i = 0; i < all; i++) {
            const double factor = i == k ? 0 : a[i][k] / a[k][k];
            for (std::size_t j = k; j < all; j++)
                a[i][j] -= factor * a[k][j];
            b[i] -= factor * b[k];
        }
    }
    for (std::size_t k = 0; k < all; k++)
        b[k] /= a[k][k];
#endif
    return b;
}

kstrip::surface profile(const std::string &name)
{
    const auto points = kstrip::read_profile("tests/data/wheel_rail/" + name + ".csv");
    return kstrip::prepare_profile(points.y, points.z);
}

// Masses and moments of inertia [kg, kg m^2]; the frame carries half of the car body
const six wheelset_mass{1500, 1500, 1500, 800, 110, 800}, frame_mass{17e3, 17e3, 17e3, 15e3, 20e3, 20e3};
// Springs and dampers between wheelsets and frame along x, y and z [N/m, N s/m], and where they are from the frame's centre [m]
const double stiffness[3] = {10e6, 5e6, 1.2e6}, damping[3] = {10e3, 40e3, 30e3};
const double ahead[2] = {1.25, -1.25}, beside[2] = {1, -1};
const double speed = 20, gravity = 9.81, load = (wheelset_mass[0] + frame_mass[0] / 2) * gravity; // m/s, m/s^2, N

/// The curve begins and ends within a quarter of a second each; later the car body leans to the left.
double curvature(double time) { return std::clamp(std::min(time, 1.25 - time), 0.0, 0.25) / 0.25 / 300; }
double moment(double time) { return -180e3 * std::clamp(1 - std::abs(time - 1.75) / 0.25, 0.0, 1.0); }

/// The state, and the equations of a linearly implicit step h: (M - h dF/dv - h^2 dF/dq) (change of v) = h (F + h dF/dq v).
const double h = 2e-3; // s
struct bogie {
    kstrip::wheelset wheelset;
    kstrip::track track;
    kstrip::wheelset_workspace memory;
    vector position{}, velocity{}, balance{};
    double time = 0, rail_force[2][2][2]{}; // of each wheelset, side: Y, Q [N]
    matrix a{};
    vector b{};

    void add_force(std::size_t row, double force) { b[row] += h * force; }
    void add_derivatives(std::size_t row, std::size_t column, double by_velocity, double by_position)
    {
        a[row][column] -= h * (by_velocity + h * by_position);
        b[row] += h * h * by_position * velocity[column];
    }

    void add_wheelset(std::size_t set)
    {
        const std::size_t first = set * freedoms;
        six q, v;
        std::copy_n(&position[first], freedoms, q.begin());
        std::copy_n(&velocity[first], freedoms, v.begin());
        const auto place = kstrip::wheel_position_of(q);
        const kstrip::curve curve{kstrip::metres_per_second(speed), kstrip::per_metre(curvature(time)), {}, gravity};
        const auto [moves, weight] = kstrip::curve_motion(curve, place, kstrip::wheel_velocity_of(v));
        const auto on = kstrip::wheelset_on_track_with_derivatives(wheelset, track, place, moves, memory, true);
        const six force = on.forces.wrench;
        for (std::size_t row = 0; row < freedoms; row++) {
            add_force(first + row, force[row]);
            for (std::size_t column = 0; column < freedoms; column++)
                add_derivatives(first + row, first + column, on.derivatives.velocity[row][column], on.by_position.position[row][column]);
        }
        add_force(first + vertical, load);
        // In the axes of the curve, half of the frame with each wheelset
        add_force(first + lateral, wheelset_mass[lateral] * weight[1]);
        add_force(frame + lateral, frame_mass[lateral] / 2 * weight[1]);
        for (std::size_t side = 0; side < 2; side++)
            for (std::size_t k = 0; k < 2; k++)
                rail_force[set][side][k] = on.forces.rail[side][1 + k].value;
    }

    void add_spring(std::size_t set, std::size_t box, std::size_t axis)
    {
        // How each degree of freedom stretches it: the motion of the wheelset's point minus that of the frame's point
        const double x = ahead[set], y = beside[box];
        vector stretch{};
        double *wheels = &stretch[set * freedoms], *body = &stretch[frame];
        wheels[axis] = 1, body[axis] = -1;
        if (axis == forward)
            wheels[yaw] = -y, body[yaw] = y;
        if (axis == lateral)
            body[yaw] = -x;
        if (axis == vertical)
            wheels[roll] = y, body[roll] = -y, body[pitch] = x;
        // In a curve the axes at the wheelset turn against those at the frame by curvature times x
        double length = curvature(time) * (wheels[yaw] * x + wheels[lateral] * x * x / 2), rate = 0;
        for (std::size_t k = 0; k < all; k++) {
            length += stretch[k] * (position[k] - balance[k]);
            rate += stretch[k] * velocity[k];
        }
        for (std::size_t row = 0; row < all; row++) {
            add_force(row, -stretch[row] * (stiffness[axis] * length + damping[axis] * rate));
            for (std::size_t column = 0; column < all; column++)
                add_derivatives(row, column, -damping[axis] * stretch[row] * stretch[column], -stiffness[axis] * stretch[row] * stretch[column]);
        }
    }

    void advance()
    {
        a = {}, b = {};
        for (std::size_t k = 0; k < all; k++)
            a[k][k] = k < frame ? wheelset_mass[k % freedoms] : frame_mass[k % freedoms];
        for (std::size_t set = 0; set < 2; set++) {
            add_wheelset(set);
            for (std::size_t box = 0; box < 2; box++)
                for (std::size_t axis = 0; axis < 3; axis++)
                    add_spring(set, box, axis);
        }
        add_force(frame + roll, moment(time));
        const vector change = solve(a, b);
        for (std::size_t k = 0; k < all; k++) {
            velocity[k] += change[k];
            position[k] += h * velocity[k];
        }
        time += h;
    }
};

int main()
{
    const kstrip::surface rail = profile("uic60"), wheel = profile("s1002");
    bogie vehicle;
    vehicle.track.rail[0] = &rail;
    vehicle.track.gauge = 1435_mm;
    vehicle.wheelset.wheel[0] = &wheel;
    vehicle.wheelset.back_to_back = 1360_mm;
    vehicle.wheelset.pair[0] = {460_mm, 82_GPa, 0.28, 0.3};
    vehicle.wheelset.pair[0].normal_damping = 0.1;

    // Both wheelsets in balance on their rails, from which the springs are measured
    const auto still = kstrip::wheelset_settle(vehicle.wheelset, vehicle.track, kstrip::wheel_position_of(six{}),
                                               kstrip::wheel_velocity_of(six{speed}), {kstrip::newtons(load)}, vehicle.memory);
    for (std::size_t first = 0; first < frame; first += freedoms) {
        vehicle.balance[first + vertical] = still.position.vertical.value;
        vehicle.velocity[first + pitch] = still.velocity.pitch.value;
    }
    vehicle.position = vehicle.balance;

    for (int i = 0; i <= 1125; i++) {
        vehicle.advance();
        if (i % 125 != 0)
            continue;
        const auto &[right, left] = vehicle.rail_force[0];
        std::printf("%.2f s: y %6.2f %6.2f mm  Y %6.1f %6.1f kN  Q %6.1f %6.1f kN\n", vehicle.time - h, 1e3 * vehicle.position[lateral],
                    1e3 * vehicle.position[freedoms + lateral], 1e-3 * right[0], 1e-3 * left[0], 1e-3 * right[1], 1e-3 * left[1]);
    }
}
