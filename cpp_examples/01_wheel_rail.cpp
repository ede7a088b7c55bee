// The wheel on a rail of c_examples/01_wheel_rail.c in C++: units in the types, both ways of failing.
//
//   c++ -std=c++17 -Iinclude cpp_examples/01_wheel_rail.cpp target/lib/libkstrip.a -o wheel_rail
#include "kstrip.hpp"

#include <array>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <vector>

using namespace kstrip::literals;

static_assert(kstrip::version_major == 0 && (80_kN).value == 80e3 && 6.0_mm == 0.006_m);
static_assert((80_kN_f32).value == 80e3f && 6.0_mm_f32 == 0.006_m_f32);

int main()
{
    if (!kstrip::linked_abi_matches())
        return 1;
    const kstrip::metres flat{std::numeric_limits<double>::infinity()};
    const kstrip::radii radii{flat, 0.30_m, 0.46_m, flat};
    const kstrip::material steel{82_GPa, 0.28};
    const auto pair = kstrip::combine(steel, steel);
    const auto [contact, ellipse] = kstrip::contact_from_hertz(radii, pair, 80_kN, 0.3);
    std::printf("a = %.6f mm, b = %.6f mm, peak pressure %.4f MPa\n", contact.a / 1_mm, contact.b / 1_mm,
                ellipse.peak_pressure / 1_MPa);
    const kstrip::creepage motion{1e-3, 0.5e-3, 0.4_per_m};

    // The inverse of Hertz: load and stiffness from the approach
    const auto pressed = kstrip::contact_from_approach(radii, pair, ellipse.approach, 0.3);
    std::printf("approach %.3f %.6e\n", pressed.contact.normal_force.value, pressed.stiffness.value);
    const auto coefficients = kstrip::linear_coefficients(contact.a / contact.b, 0.28);
    std::printf("linear %.6f %.6f %.6f %.6f\n", coefficients[0], coefficients[1], coefficients[2], coefficients[3]);

    // Outputs returned, errors thrown; forces on the rail, and on the wheel.
    const auto forces = kstrip::solve(contact, motion);
    const auto wheel = kstrip::on_upper_body(forces);
    std::printf("rail  %.4f %.4f %.6f\n", forces.fx.value, forces.fy.value, forces.mz.value);
    std::printf("wheel %.4f %.4f %.6f\n", wheel.fx.value, wheel.fy.value, wheel.mz.value);

    // Derivatives
    const auto all = kstrip::evaluate(contact, motion);
    std::printf("derivatives %.4f %.9f %.4f %.9f\n", all.derivatives.jacobian[1][1], all.derivatives.normal_force[0],
                all.derivatives.friction[0], all.derivatives.load_through_hertz[0]);

    // Errors as statuses: nothing is thrown, nothing is written.
    kstrip::result untouched{};
    kstrip::contact bad = contact;
    bad.friction = -1.0;
    const auto status = kstrip::solve(bad, motion, {kstrip::model::total, 16}, untouched);
    std::printf("status %d: %s\n", static_cast<int>(status), kstrip::to_string(status));

    // Errors as exceptions; of a batch with the index of the first bad input
    std::vector<kstrip::contact> contacts(9, contact);
    std::vector<kstrip::creepage> motions;
    for (int i = 0; i < 9; i++)
        motions.push_back({i * 1e-3, 0.0, 0_per_m});
    contacts[5] = bad;
    try {
        static_cast<void>(kstrip::evaluate_batch(contacts, motions));
        std::printf("not thrown\n");
    } catch (const kstrip::error &error) {
        std::printf("thrown %d %d\n", static_cast<int>(error.status()), static_cast<int>(error.index()));
    }

    // A creep curve in one call: one contact for all creepages
    for (const auto &f : kstrip::evaluate_batch(std::array{contact}, motions))
        std::printf("curve %.4f\n", f.fx.value);
    // The same without exceptions; only fx is requested
    std::array<kstrip::newtons, 9> only_fx;
    contacts[5] = contact;
    kstrip::batch_outputs outputs;
    outputs.fx = only_fx.data();
    outputs.fx_stride = sizeof only_fx[0];
    if (kstrip::is_error(kstrip::evaluate_batch(kstrip::batch_of(contacts.data(), motions.data()), 9, {}, outputs)))
        return 1;
    std::printf("batch %.4f\n", only_fx[8].value);

    // A wet rail: friction falls to 40 % of .3 with the sliding velocity, at 20 m/s
    const kstrip::friction wet{0.3, 0.4, 0.6_s_per_m, 20_m_per_s, 0.5};
    const auto slow = kstrip::evaluate(contact, motion, {}, &wet);
    std::printf("wet %.4f %.6f %.6f\n", slow.result.fy.value, slow.friction, slow.law_derivatives.ratio[1]);

    // A contact that does not change: what does not depend on the motion is computed once
    const auto ready = kstrip::prepare(contact);
    if (kstrip::solve(ready, motion).fx != forces.fx)
        return 1;

    // Standstill: velocities instead of creepages
    const auto held = kstrip::solve_motion(contact, {0.00001_m_per_s, 0_m_per_s, 0_rad_per_s, 0_m_per_s});
    std::printf("standstill %.4f %.2f\n", held.result.fx.value, held.derivatives.slip[0][0]);

    // The other way round: friction from the force, creepage from the force
    const auto found = kstrip::estimate_friction(contact, motion, kstrip::measured::both, forces.fx, forces.fy);
    const auto back = kstrip::creepage_for_force(contact, forces.fx, forces.fy, motion.spin);
    std::printf("inverse %.4f %.7f %.7f\n", found.friction, back.longitudinal, back.lateral);

    // A patch of any shape: here the ellipse's strips, the right half without friction
    auto worn = kstrip::patch_from_contact(contact);
    const kstrip::options strip{kstrip::model::strip};
    const auto whole = kstrip::evaluate(worn, motion).result;
    const auto same = kstrip::solve(contact, motion, strip);
    for (std::uint32_t i = 0; i < worn.count; i++)
        if (worn.strips[i].y > 0_m)
            worn.strips[i].friction = 0.0;
    const auto sums = kstrip::summarize(worn);
    std::printf("patch %.4f %.4f %.4f %.6f\n", whole.fx.value - same.fx.value, whole.fy.value - same.fy.value,
                sums.friction_bound.value, sums.area.value * 1e6);

    // Strips and field
    kstrip::newtons sum;
    const auto strips = kstrip::strips(contact, motion);
    for (const auto &s : strips)
        sum += s.fx;
    std::printf("strips %d %.4f\n", static_cast<int>(strips.size()), sum.value);
    const std::array<kstrip::metres, 3> x{-0.5 * contact.a, kstrip::metres{}, 0.5 * contact.a};
    const std::array<kstrip::metres, 2> y{kstrip::metres{}, 2.0 * contact.b};
    for (const auto &p : kstrip::field(contact, motion, {}, x, y))
        std::printf("point %d %.4f\n", static_cast<int>(p.state), p.traction_x / 1_MPa);

    // Single precision
    const kstrip::contact_f32 small{6.0_mm_f32, 4.5_mm_f32, 80_kN_f32, 82_GPa_f32, 0.28f, 0.3f};
    const auto single = kstrip::solve(small, {1e-3f, 0.0f, 0_per_m_f32});
    std::printf("single %.1f\n", static_cast<double>(single.fx.value));
    return 0;
}
