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

int main()
{
    if (!kstrip::linked_abi_matches())
        return 1;
    const kstrip::metres flat{std::numeric_limits<double>::infinity()};
    const kstrip::material steel{82_GPa, 0.28};
    const auto pair = kstrip::combine(steel, steel);
    const auto patch = kstrip::hertz({flat, 0.30_m, 0.46_m, flat}, 80_kN, pair);
    std::printf("a = %.6f mm, b = %.6f mm, peak pressure %.4f MPa\n", patch.a / 1_mm, patch.b / 1_mm,
                patch.peak_pressure / 1_MPa);

    const kstrip::contact contact{patch.a, patch.b, 80_kN, pair.shear_modulus, pair.poisson_ratio, 0.3};
    const kstrip::creepage motion{1e-3, 0.5e-3, 0.4_per_m};

    // Outputs returned, errors thrown; forces on the rail, and on the wheel.
    const auto forces = kstrip::solve(contact, motion);
    const auto wheel = kstrip::on_upper_body(forces);
    std::printf("rail  %.4f %.4f %.6f\n", forces.fx.value, forces.fy.value, forces.mz.value);
    std::printf("wheel %.4f %.4f %.6f\n", wheel.fx.value, wheel.fy.value, wheel.mz.value);

    // How the lateral force answers to the lateral creepage
    const auto linearised = kstrip::solve_jacobian(contact, motion);
    std::printf("dFy/dlateral %.4f\n", linearised.jacobian(1, 1));

    // Errors as statuses: nothing is thrown, nothing is written.
    kstrip::result untouched{};
    kstrip::contact bad = contact;
    bad.friction = -1.0;
    const auto status = kstrip::solve(bad, motion, {kstrip::model::total, 16}, untouched);
    std::printf("status %d: %s\n", static_cast<int>(status), kstrip::to_string(status));

    // Errors as exceptions
    try {
        static_cast<void>(kstrip::solve(bad, motion));
        std::printf("not thrown\n");
    } catch (const kstrip::error &error) {
        std::printf("thrown %d\n", static_cast<int>(error.status()));
    }

    // A creep curve in one call
    std::vector<kstrip::contact> contacts(9, contact);
    std::vector<kstrip::creepage> motions;
    for (int i = 0; i < 9; i++)
        motions.push_back({i * 1e-3, 0.0, 0_per_m});
    std::vector<kstrip::result> curve(9);
    if (kstrip::is_error(kstrip::solve_batch(contacts, motions, {}, curve)))
        return 1;
    for (const auto &f : curve)
        std::printf("curve %.4f\n", f.fx.value);

    // The same with derivatives; and with those with respect to load and friction
    std::vector<kstrip::jacobian> slopes(9);
    if (kstrip::is_error(kstrip::solve_jacobian_batch(contacts, motions, {}, curve, slopes)))
        return 1;
    std::printf("slope %.4f\n", slopes[1](0, 0));
    kstrip::result same{};
    kstrip::derivatives all{};
    if (kstrip::is_error(kstrip::solve_derivatives(contact, motion, {}, same, all)))
        return 1;
    std::printf("derivatives %.4f %.9f %.4f %.9f\n", all.jacobian(1, 1), all.normal_force[0], all.friction[0],
                all.load_through_hertz[0]);

    // A wet rail: friction falls to 40 % of .3 with the sliding velocity, at 20 m/s
    const kstrip::friction wet{0.3, 0.4, 0.6_s_per_m, 20_m_per_s, 0.5};
    double effective = 0;
    if (kstrip::is_error(kstrip::solve_friction_jacobian(contact, motion, wet, {}, same, slopes[0], &effective)))
        return 1;
    std::printf("wet %.4f %.6f\n", same.fy.value, effective);

    // The same from one array for each quantity; only fx is wanted
    const kstrip::batch_inputs from{&contact.a, &contact.b, &contact.normal_force, &contact.shear_modulus,
                                    &contact.poisson_ratio, &contact.friction, &motion.longitudinal,
                                    &motion.lateral, &motion.spin};
    kstrip::newtons only_fx;
    kstrip::batch_outputs wanted{};
    wanted.fx = &only_fx;
    if (kstrip::is_error(kstrip::solve_batch_arrays(1, from, {}, wanted)) || only_fx != forces.fx)
        return 1;

    // The other way round: friction from the force, creepage from the force
    const kstrip::options total{kstrip::model::total, 16};
    const auto measured = kstrip::solve(contact, motion, total);
    kstrip::friction_estimate found{};
    kstrip::creepage back{};
    if (kstrip::is_error(kstrip::estimate_friction(contact, motion, total, kstrip::measured::both, measured.fx,
                                                   measured.fy, found)) ||
        kstrip::is_error(kstrip::creepage_for_force(contact, measured.fx, measured.fy, motion.spin, total, back)))
        return 1;
    std::printf("inverse %.4f %.7f %.7f\n", found.friction, back.longitudinal, back.lateral);

    // Only what is wanted
    kstrip::result some{};
    kstrip::jacobian its{};
    if (kstrip::is_error(kstrip::evaluate(contact, motion, total, kstrip::want::forces | kstrip::want::jacobian, &some,
                                          &its)))
        return 1;
    std::printf("evaluate %.4f %.4f\n", some.fx.value, its(0, 0));

    // A patch of any shape: here the ellipse's strips, the right half without friction
    kstrip::patch worn{};
    if (kstrip::is_error(kstrip::patch_from_ellipse(contact, 16, worn)))
        return 1;
    const auto whole = kstrip::solve(worn, motion);
    kstrip::result slowed{}, too{}, again{};
    kstrip::jacobian slowed_slopes{};
    kstrip::patch slipping{};
    kstrip::contact slipping_ellipse{};
    double share = 0.0;
    if (kstrip::is_error(kstrip::solve_friction(worn, motion, wet, {}, slowed, &share)) ||
        kstrip::is_error(kstrip::solve_friction_jacobian(worn, motion, wet, {}, too, slowed_slopes)) ||
        kstrip::is_error(kstrip::under_friction(worn, motion, wet, {}, slipping)) ||
        kstrip::is_error(kstrip::under_friction(contact, motion, wet, {}, slipping_ellipse)) ||
        kstrip::is_error(kstrip::solve(slipping, motion, {}, again)))
        return 1;
    std::printf("wet patch %.4f %.4f %.4f %.6f %.6f\n", slowed.fy.value, too.fy.value, again.fy.value,
                share * contact.friction, slipping_ellipse.friction);
    for (std::uint32_t i = 0; i < worn.count; i++)
        if (worn.strips[i].y > 0_m)
            worn.strips[i].friction = 0.0;
    kstrip::patch_summary sums{};
    if (kstrip::is_error(kstrip::summarize(worn, sums)))
        return 1;
    std::printf("patch %.4f %.4f %.4f %.6f\n", whole.fx.value, whole.fy.value, sums.friction_bound.value,
                sums.area.value * 1e6);

    // Strips and field
    std::array<kstrip::strip, kstrip::strips_capacity> strips;
    std::uint32_t count = 0;
    if (kstrip::is_error(kstrip::strips(contact, motion, {}, strips, count)))
        return 1;
    kstrip::newtons sum;
    for (std::uint32_t i = 0; i < count; i++)
        sum += strips[i].fx;
    std::printf("strips %u %.4f\n", static_cast<unsigned>(count), sum.value);
    const std::array<kstrip::metres, 3> x{-0.5 * patch.a, kstrip::metres{}, 0.5 * patch.a};
    const std::array<kstrip::metres, 2> y{kstrip::metres{}, 2.0 * patch.b};
    std::array<kstrip::point, 6> points;
    if (kstrip::is_error(kstrip::field(contact, motion, {}, x, y, points)))
        return 1;
    for (const auto &p : points)
        std::printf("point %d %.4f\n", static_cast<int>(p.state), p.traction_x / 1_MPa);

    // Single precision
    const kstrip::contact_f32 small{kstrip::metres_f32{6e-3f}, kstrip::metres_f32{4.5e-3f},
                                    kstrip::newtons_f32{80e3f}, kstrip::pascals_f32{82e9f}, 0.28f, 0.3f};
    const auto single = kstrip::solve(small, kstrip::creepage_f32{1e-3f, 0.0f, kstrip::per_metre_f32{0.0f}});
    std::printf("single %.1f\n", static_cast<double>(single.fx.value));
    return 0;
}
