// Typical mistakes in C++: the good case, and a call of each function; the rows are written behind this by tests/interface/mistakes.rs.
#include <kstrip.hpp>

#include "mistakes.h"

using namespace kstrip::literals;

template <class Unit, class T> void SET(kstrip::quantity<Unit, T> &member, double value) { member.value = static_cast<T>(value); }
template <class T> void SET(T &member, double value) { member = static_cast<T>(static_cast<int>(value) == value ? static_cast<int>(value) : 0); }
inline void SET(double &member, double value) { member = value; }

static kstrip::contact contact;
static kstrip::creepage creepage;
static kstrip::options options;
static kstrip::radii radii;
static kstrip::combined_material steel;
static kstrip::curve curve;
static kstrip::wheel_pair pair;
static kstrip::wheel_position position;
static kstrip::wheel_velocity velocity;
static kstrip::wheelset_loads loads;
static kstrip::track track;
static kstrip::wheelset set;
static kstrip::surface profiles[3], prepared;
static kstrip::wheel_workspace memory;
static kstrip::wheelset_workspace both;

static int number(kstrip::status status) { return static_cast<int>(status); }
static const kstrip::surface &of_rail() { return profiles[swapped ? 1 : rail_upside_down ? 2 : 0]; }
static const kstrip::surface &of_wheel() { return profiles[swapped ? 0 : 1]; }

static void good_case()
{
    good_numbers();
    contact = {6_mm, 4.5_mm, 80_kN, 82_GPa, 0.28, 0.3};
    creepage = {1e-3, 0, 0.1_per_m};
    options = {};
    radii = {kstrip::metres(1e300), 300_mm, 460_mm, kstrip::metres(1e300)};
    steel = {82_GPa, 0.28, 0};
    curve = {20_m_per_s, kstrip::per_metre(1 / 300.0), 0.1_rad};
    pair = {460_mm, 82_GPa, 0.28, 0.3};
    position = {};
    velocity = {20_m_per_s};
    velocity.pitch = -43.4_rad_per_s;
    loads = {160_kN};
    track = kstrip::track{};
    track.gauge = 1.435_m;
    set = kstrip::wheelset{};
    set.back_to_back = 1.36_m;
}

static int solve()
{
    kstrip::result result{};
    return number(kstrip::solve(contact, creepage, options, result));
}

static int hertz() { return number(kstrip::contact_from_hertz(radii, steel, 80_kN, 0.3, contact)); }

static int through_curve() { return number(kstrip::curve_motion(curve, position, velocity, velocity)); }

static int prepare_shape(const double *y, const double *z, unsigned points, kstrip::surface *to)
{
    return number(kstrip::prepare_profile<double>({y, points}, {z, points}, 0_m, 0_m, *to));
}

static int height()
{
    kstrip::metres found{};
    position.lateral += kstrip::metres(offset);
    return number(kstrip::height_for_load(of_rail(), of_wheel(), pair, position, kstrip::newtons(support), nullptr, nullptr, memory, found));
}

static int wheel()
{
    const kstrip::wheel_pair good{460_mm, 82_GPa, 0.28, 0.3};
    kstrip::metres found{};
    kstrip::wrench wrench{};
    static_cast<void>(kstrip::height_for_load(profiles[0], profiles[1], good, {kstrip::metres(offset)}, 80_kN, nullptr, nullptr, memory, found));
    position.lateral += kstrip::metres(offset);
    if (position.vertical == 0_m)
        position.vertical = found;
    return number(kstrip::wheel_on_rail(of_rail(), of_wheel(), pair, position, velocity, nullptr, memory, wrench));
}

static int settle()
{
    kstrip::wheel_position at{};
    kstrip::wheel_velocity moves{};
    track.rail[0] = &of_rail(), set.wheel[0] = &of_wheel(), set.pair[0] = pair;
    return number(kstrip::wheelset_settle(set, track, position, velocity, loads, both, at, moves));
}

static int fit()
{
    kstrip::friction law{0.35};
    law.slope_factor = 0.4;
    kstrip::measured_force points[FORCES];
    kstrip::friction_fit found{};
    for (int i = 0; i < FORCES; i++) {
        const kstrip::creepage slip{0.5e-3 * (1 << i), 0, 0_per_m};
        const auto evaluated = kstrip::evaluate(contact, slip, {}, &law);
        points[i].longitudinal = slip.longitudinal * creepage_factor;
        points[i].fx = evaluated.result.fx;
    }
    return number(kstrip::fit_friction<double>(contact, points, FORCES, law, kstrip::fitted::coefficient | kstrip::fitted::slope_factor, {}, found));
}

static int conicity()
{
    const double shifts[2] = {-5e-3, 5e-3}, differences[2] = {-5e-4 * sense, 5e-4 * sense}, amplitudes[1] = {amplitude};
    double found[1];
    return number(kstrip::equivalent_conicity<double>(shifts, differences, 1.5_m, 460_mm, amplitudes, found));
}

static int for_force() { return number(kstrip::creepage_for_force(contact, kstrip::newtons(force), 0_N, 0_per_m, nullptr, {}, creepage)); }

static const char *text_of(int status) { return kstrip::to_string(static_cast<kstrip::status>(status)); }
