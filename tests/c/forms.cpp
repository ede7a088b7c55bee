// Every function of kstrip.hpp that throws returns what its other form writes; numbers with and without units are the same; products of
// units, literals and arrays. Prints what is wrong.
#include "kstrip.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <list>

using namespace kstrip::literals;

static int failures = 0;
static void expect(bool holds, const char *what)
{
    if (!holds)
        std::printf("%s\n", what), failures++;
}
template <class X> static bool same(const X &a, const X &b) { return std::memcmp(&a, &b, sizeof(X)) == 0; }
static void fine(kstrip::status s, const char *what) { expect(!kstrip::is_error(s), what); }

static_assert((3_kN * 20_mm) == 60_Nm && (20_mm * 3_kN) == 0.06_kNm);
static_assert(std::is_same_v<decltype(1_N * 1_m), kstrip::newton_metres>);
static_assert(std::is_same_v<decltype(1_m * 1_m), kstrip::square_metres>);
static_assert(2_Pa * (3_m * 1_m) == 6_N && 5_N_per_m * 2_m == 10_N && 2_rad_per_s * 3_m == 6_m_per_s);
static_assert(0.5_per_m * 20_m_per_s == 10_rad_per_s && 36_km_per_h == 10_m_per_s && 1500_mrad == 1.5_rad);
static_assert((180_deg).value > 3.14159265358979 && (180_deg).value < 3.1415926535898 && 90_deg_f32 == kstrip::radians_f32(1.57079637f));
static_assert(std::is_same_v<decltype(kstrip::wheel_pair::model), kstrip::model>);
static_assert(std::is_constructible_v<kstrip::lengths<double>, std::vector<double>>);
static_assert(!std::is_constructible_v<kstrip::lengths<double>, std::vector<float>>);
static_assert(!std::is_constructible_v<kstrip::lengths<double>, std::vector<kstrip::newtons>>);
static_assert(!std::is_constructible_v<kstrip::lengths<double>, std::list<double>>);
// Six numbers are a position or a velocity, and back
constexpr std::array<double, 6> six_numbers{1, 2, 3, 4, 5, 6};
static_assert(kstrip::wheel_position_of(six_numbers).lateral == 2_m && kstrip::wheel_position_of(six_numbers).vertical == 3_m);
static_assert(kstrip::wheel_position_of(six_numbers).roll == 4_rad && kstrip::wheel_position_of(six_numbers).yaw == 6_rad);
static_assert(kstrip::wheel_velocity_of(six_numbers).forward == 1_m_per_s && kstrip::wheel_velocity_of(six_numbers).pitch == 5_rad_per_s);
static_assert(kstrip::wheel_position_of(std::array<float, 6>{0, 2}).lateral == 2_m_f32);

int main()
{
    expect(std::array<double, 6>(kstrip::wheel_velocity_of(six_numbers)) == six_numbers, "a velocity of six numbers");
    const kstrip::contact contact{6_mm, 4.5_mm, 80_kN, 82_GPa, 0.28, 0.3};
    const kstrip::creepage motion{1e-3, 0.5e-3, 0.4_per_m};
    const kstrip::friction wet{0.3, 0.4, 0.6_s_per_m, 20_m_per_s};
    const kstrip::options strip{kstrip::model::strip, 8};

    // Batches: results, derivatives and law
    const std::vector<kstrip::creepage> motions{motion, {2e-3, 0.0, 0_per_m}, {0.05, 0.0, 0_per_m}};
    const auto results = kstrip::evaluate_batch(std::array{contact}, motions, {}, &wet);
    const auto all = kstrip::evaluate_batch_with_derivatives(std::array{contact}, motions, {}, &wet);
    for (std::size_t i = 0; i < motions.size(); i++) {
        const auto one = kstrip::evaluate(contact, motions[i], {}, &wet);
        expect(same(results[i], one.result) && same(all[i].result, one.result), "batch: results");
        expect(same(all[i].derivatives, one.derivatives) && same(all[i].law_derivatives, one.law_derivatives), "batch: derivatives");
        expect(all[i].friction == one.friction && one.friction < 0.3, "batch: friction");
    }
    expect(kstrip::evaluate_batch_with_derivatives(std::array{contact}, std::vector<kstrip::creepage>{}).empty(), "batch: none");

    // Strips and fields of contacts and patches; lengths with and without units
    const auto patch = kstrip::patch_from_contact(contact, strip);
    expect(kstrip::strips(contact, motion, strip).size() == 8 && kstrip::strips(patch, motion).size() == patch.count, "strips");
    std::vector<kstrip::creepage> own(patch.count);
    const auto uniform = kstrip::evaluate(patch, motion);
    expect(same(kstrip::evaluate_strips(patch, motion, own), uniform), "creepages of strips: none of their own");
    own.front().longitudinal = 1e-3;
    const auto curved = kstrip::evaluate_strips(patch, motion, own, {}, &wet);
    kstrip::result by_status;
    kstrip::outputs wanted;
    wanted.result = &by_status;
    fine(kstrip::evaluate_strips(patch, motion, own, &wet, {}, wanted), "creepages of strips");
    expect(same(curved.result, by_status) && curved.friction < 1, "creepages of strips: both forms");
    own.pop_back();
    expect(kstrip::evaluate_strips(patch, motion, own, nullptr, {}, wanted) == kstrip::status::error_capacity, "creepages of strips: one too few");
    const std::vector<double> x{-2e-3, 0.0, 2e-3};
    const kstrip::metres units[3] = {-2_mm, 0_m, 2_mm};
    const double plain[1] = {1e-3};
    const auto by_number = kstrip::field(contact, motion, {}, x, plain), by_unit = kstrip::field(contact, motion, {}, units, std::array{1_mm});
    expect(by_number.size() == 3 && std::memcmp(by_number.data(), by_unit.data(), 3 * sizeof by_number[0]) == 0, "field: units");
    expect(kstrip::field(patch, motion, {}, x, x).size() == 9, "field: of a patch");
    kstrip::friction layered = wet;
    layered.layer = decltype(layered.layer)(5e-14);
    std::vector<double> across, along;
    for (int i = -80; i <= 80; i++)
        along.push_back(i * 0.076e-3), across.push_back(i * 0.057e-3);
    double sums[2] = {0, 0};
    for (const auto &point : kstrip::field(contact, motion, strip, along, across, &layered))
        sums[0] += point.traction_x.value * 0.076e-3 * 0.057e-3;
    for (const auto &point : kstrip::field(patch, motion, {}, along, across, &layered))
        sums[1] += point.traction_x.value * 0.076e-3 * 0.057e-3;
    const double behind = kstrip::evaluate(contact, motion, strip, &layered).result.fx.value;
    expect(behind < 0.9 * kstrip::evaluate(contact, motion, strip, &wet).result.fx.value, "field: a layer is softer");
    expect(std::fabs(sums[0] - behind) < 0.02 * 24e3 && std::fabs(sums[1] - behind) < 0.02 * 24e3, "field: behind a layer");

    // Arrays of six
    const auto force = kstrip::solve(contact, motion);
    const std::array<double, 6> six = force;
    expect(six[0] == force.fx.value && six[1] == force.fy.value && six[2] == 0 && six[5] == force.mz.value, "array of a result");

    // A wheel of 1:20 on a round head
    std::vector<double> ry, rz, wy, wz;
    std::vector<kstrip::metres> ry_units, rz_units;
    for (int i = -60; i <= 60; i++) {
        const double at = 0.5e-3 * i;
        ry.push_back(at), rz.push_back(0.3 - std::sqrt(0.09 - at * at));
        wy.push_back(at), wz.push_back(-0.05 * at);
        ry_units.emplace_back(ry.back()), rz_units.emplace_back(rz.back());
    }
    const auto rail = kstrip::prepare_profile(ry, rz), wheel = kstrip::prepare_profile(wy, wz);
    kstrip::surface written;
    std::memset(static_cast<void *>(&written), 0, sizeof written);
    fine(kstrip::prepare_profile(ry_units, rz_units, 0_m, 0_m, written), "prepare_profile");
    expect(same(written.y, rail.y) && same(written.sine, rail.sine) && written.count == rail.count, "prepare_profile: both forms, units");

    fine(kstrip::profile_between(rail, wheel, 0.5, written), "profile_between");
    const auto between = kstrip::profile_between(rail, wheel, 0.5);
    expect(same(written.y, between.y) && same(written.z, between.z) && written.count == between.count, "profile_between: both forms");
    std::vector<double> up(rz), turned_y(ry.size()), turned_z(ry.size());
    for (double &height : up)
        height *= -20;
    const auto oriented = kstrip::orient_profiles(ry, up, KSTRIP_FORMAT_RAIL);
    const std::uint32_t point_count = static_cast<std::uint32_t>(ry.size());
    double metres_per_unit = 0;
    std::uint32_t changed = 0;
    fine(kstrip::orient_profiles(ry.data(), up.data(), &point_count, 1, KSTRIP_FORMAT_RAIL, 1, turned_y.data(), turned_z.data(), metres_per_unit, changed),
         "orient_profiles");
    expect(metres_per_unit == 1 && turned_z.front() == -up.front() && oriented.z.front().value == turned_z.front() && oriented.y.back().value == ry.back() &&
               changed == oriented.notes && (changed & KSTRIP_NOTE_Z_TURNED) != 0,
           "orient_profiles: both forms");
    const std::string text = "0 0\n10 1\n20 4\n30 9\n40 16\n50 25\n";
    double point_y[8], point_z[8];
    std::uint32_t points_read = 0, notes = 0;
    fine(kstrip::read_profile(text, KSTRIP_FORMAT_COLUMNS | KSTRIP_FORMAT_RAIL, point_y, point_z, 8, points_read, notes), "read_profile");
    const std::string path = "kstrip_forms_profile.txt";
    std::FILE *file = std::fopen(path.c_str(), "wb");
    expect(file && std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fclose(file) == 0, "a file is written");
    const auto points = kstrip::read_profile(path, KSTRIP_FORMAT_COLUMNS | KSTRIP_FORMAT_RAIL);
    std::remove(path.c_str());
    expect(points_read == 6 && points.y.size() == 6 && points.notes == notes && points.y[5].value == point_y[5] && points.z[5].value == point_z[5] &&
               std::fabs(point_y[5] - 50e-3) < 1e-15, "read_profile: both forms");
    try {
        static_cast<void>(kstrip::read_profile("there is no such file"));
        expect(false, "a file that is not there was read");
    } catch (const std::system_error &) {
    }

    kstrip::wheel_pair pair{460_mm, 82_GPa, 0.28, 0.3};
    pair.model = kstrip::model::strip;
    kstrip::wheel_position where{0_mm, 0_mm, 2_mrad};
    const kstrip::wheel_velocity moves{20_m_per_s, 0.01_m_per_s, 0_m_per_s, 0_rad_per_s, -43.6_rad_per_s, 0_rad_per_s};
    auto memory = std::vector<kstrip::wheel_workspace>(1);
    kstrip::wheel_workspace &room = memory.front();
    kstrip::metres height{};
    for (const auto *velocity : {static_cast<const kstrip::wheel_velocity *>(nullptr), &moves}) {
        fine(kstrip::height_for_load(rail, wheel, pair, where, 80_kN, velocity, &wet, room, height), "height_for_load");
        expect(kstrip::height_for_load(rail, wheel, pair, where, 80_kN, room, velocity, &wet) == height, "height_for_load: both forms");
    }
    where.vertical = height;
    kstrip::wrench wrench{};
    kstrip::wrench_derivatives slopes{};
    kstrip::wrench_by_position moved{};
    fine(kstrip::wheel_on_rail(rail, wheel, pair, where, moves, &wet, room, wrench, &slopes, &moved), "wheel_on_rail");
    const auto evaluated = kstrip::wheel_on_rail_with_derivatives(rail, wheel, pair, where, moves, room, &wet, true);
    expect(same(evaluated.wrench, wrench) && same(evaluated.derivatives, slopes) && same(evaluated.by_position, moved), "wheel_on_rail: both forms");
    expect(kstrip::wheel_on_rail_with_derivatives(rail, wheel, pair, where, moves, room, &wet).by_position.vertical[2] == 0, "by_position: not asked for");
    expect(same(kstrip::wheel_on_rail(rail, wheel, pair, where, moves, room, &wet), wrench), "wheel_on_rail: the wrench alone");
    std::array<kstrip::wheel_position, 3> places{where, where, where};
    places[1].vertical = height - 0.01_mm, places[2].lateral = 1_m;
    std::array<kstrip::wrench, 3> wrenches{};
    std::array<std::int32_t, 3> statuses{};
    const kstrip::span<const kstrip::wheel_pair> pairs(&pair, 1);
    const kstrip::span<const kstrip::wheel_velocity> all_move(&moves, 1);
    const auto many = [&](std::size_t wheels) {
        return kstrip::wheels_on_rails<double>(rail, wheel, pairs, {places.data(), wheels}, all_move, &wet, room, {wrenches.data(), wheels},
                                               {statuses.data(), wheels});
    };
    expect(many(3) == kstrip::status::error_length_unit && statuses[0] == 0 && statuses[1] == 0 && statuses[2] == KSTRIP_ERROR_LENGTH_UNIT,
           "wheels_on_rails: the status of each");
    fine(many(2), "wheels_on_rails");
    expect(same(wrenches[0], wrench) && wrenches[1].normal_force < wrench.normal_force, "wheels_on_rails");
    const auto of_two = kstrip::wheels_on_rails<double>(rail, wheel, pairs, {places.data(), 2}, all_move, room, &wet);
    expect(of_two.size() == 2 && same(of_two[0], wrenches[0]) && same(of_two[1], wrenches[1]), "wheels_on_rails: both forms");
    auto met = std::vector<kstrip::wheel_contact>(4);
    fine(kstrip::wheels_on_rails<double>(rail, wheel, pairs, {places.data(), 2}, all_move, &wet, room, {wrenches.data(), 2},
                                         {statuses.data(), 2}, nullptr, nullptr, met), "wheels_on_rails: contacts");
    expect(wrenches[0].contacts == 1 && same(met[2], room.contacts[0]) && met[0].normal_force == wrenches[0].normal_force && met[1].radius == 0_m,
           "wheels_on_rails: contacts of each");
    const std::array<kstrip::newtons, 2> supports{80_kN, 60_kN};
    const auto heights = kstrip::heights_for_loads<double>(rail, wheel, pairs, {&where, 1}, supports, room, all_move, &wet);
    expect(heights.size() == 2 && kstrip::height_for_load(rail, wheel, pair, where, 60_kN, room, &moves, &wet) == heights[1], "heights_for_loads");
    std::array<kstrip::metres, 2> carried{};
    fine(kstrip::heights_for_loads<double>(rail, wheel, pairs, {&where, 1}, supports, {}, nullptr, room, carried, {statuses.data(), 2}),
         "heights_for_loads: by pressure");
    expect(kstrip::height_for_load(rail, wheel, pair, where, 80_kN, room) == carried[0], "heights_for_loads: both forms");
    expect(kstrip::heights_for_loads<double>(rail, wheel, pairs, {places.data(), 3}, supports, {}, nullptr, room, carried, {statuses.data(), 2}) ==
               kstrip::status::error_capacity, "heights_for_loads: other sizes");
    const std::array<double, 6> on_wheel = wrench, velocity = moves;
    expect(std::abs(on_wheel[2] + 80e3) < 1 && on_wheel[4] == wrench.moment[1].value && velocity[4] == -43.6, "arrays of a wheel");

    // The same by its steps
    const auto touched = kstrip::touch(rail, wheel, pair.wheel_radius, where);
    kstrip::metres least{};
    fine(kstrip::touch(rail, wheel, pair.wheel_radius, where, 0_m, room.gap, &least), "touch");
    expect(touched.least == least && touched.gap.count == room.gap.count && least < 0_m, "touch: both forms");
    const auto contacts = kstrip::contacts_from_gap(touched.gap, pair, where);
    std::uint32_t count = 0;
    fine(kstrip::contacts_from_gap(room.gap, pair, where, room.strips, room.contacts, count), "contacts_from_gap");
    expect(count == 1 && contacts.size() == 1 && contacts[0].normal_force == room.contacts[0].normal_force, "contacts_from_gap: both forms");
    kstrip::motion slip{};
    fine(kstrip::wheel_motion(contacts[0], moves, slip), "wheel_motion");
    expect(same(kstrip::wheel_motion(contacts[0], moves), slip), "wheel_motion: both forms");
    const auto summed = kstrip::wrench_from_contacts<double>(contacts, moves, pair.model, &wet);
    expect(same(summed.wrench, wrench) && same(summed.derivatives, slopes), "wrench_from_contacts: both forms");

    const auto worn = kstrip::contact_power_across(contacts[0], moves, pair.model, &wet);
    std::array<kstrip::strip_power, kstrip::patch_capacity> powers{};
    fine(kstrip::contact_power_across<double>(contacts[0], moves, pair.model, &wet, powers, count), "contact_power_across");
    expect(count == worn.size() && count > 8 && same(worn[3], powers[3]), "contact_power_across: both forms");
    double dissipated = 0;
    for (const auto &each : worn)
        dissipated += each.power;
    expect(std::abs(dissipated - wrench.dissipation) < 1e-9 * dissipated, "contact_power_across: dissipation");

    // A contact table of it
    kstrip::table_spec spec;
    spec.lateral_from = -1_mm, spec.lateral_to = 1_mm, spec.load = 200_kN, spec.lateral_nodes = 9, spec.levels = 6;
    const kstrip::contact_table table(rail, wheel, pair, spec, room, 10);
    expect(table.report().bytes == table.bytes().size() && table.report().poses == 10, "contact_table: report");
    kstrip::wheel_position placed;
    placed.lateral = 0.3_mm;
    placed.vertical = kstrip::height_for_load(rail, wheel, pair, placed, 80_kN, room);
    const auto direct = kstrip::wheel_on_rail(rail, wheel, pair, placed, moves, room, &wet);
    const kstrip::contact_table again(table.bytes());
    const auto interpolated = again.wheel(pair, placed, moves, room, &wet);
    expect(same(interpolated, table.wheel_with_derivatives(pair, placed, moves, room, &wet).wrench), "contact_table: both forms");
    expect(std::abs(interpolated.force[2] / direct.force[2] - 1) < 0.02, "contact_table: load");
    const kstrip::table from = again.view(true);
    const kstrip::metres on_table = kstrip::height_for_load(rail, wheel, pair, placed, 80_kN, room, nullptr, nullptr, &from);
    fine(kstrip::height_for_load(rail, wheel, pair, placed, 80_kN, nullptr, nullptr, room, height, &from), "height on a table");
    expect(height == on_table && std::abs((on_table - placed.vertical) / 1_mm) < 2e-3, "height on a table: both forms");
    const auto of_table = kstrip::wheels_on_rails<double>(rail, wheel, pairs, {&placed, 1}, {&moves, 1}, room, &wet, &from);
    expect(of_table.size() == 1 && same(of_table[0], interpolated), "wheels_on_rails: from a table");

    // The wheelset of two such wheels
    kstrip::track track;
    track.rail[0] = &rail, track.gauge = 1.435_m;
    kstrip::wheelset set;
    set.wheel[0] = &wheel, set.pair[0] = pair, set.back_to_back = 1.36_m;
    auto rooms = std::vector<kstrip::wheelset_workspace>(1);
    kstrip::wheelset_workspace &both = rooms.front();
    kstrip::metres face{};
    fine(kstrip::gauge_face(rail, 0_m, face), "gauge_face");
    expect(kstrip::gauge_face(rail) == face && face < 0_m, "gauge_face: both forms");
    const auto settled = kstrip::wheelset_settle(set, track, {1_mm, 0_mm, 1_mrad}, moves, {160_kN}, both);
    kstrip::wheel_position at{};
    kstrip::wheel_velocity turning{};
    fine(kstrip::wheelset_settle(set, track, {1_mm, 0_mm, 1_mrad}, moves, {160_kN}, both, at, turning), "wheelset_settle");
    expect(same(at, settled.position) && same(turning, settled.velocity), "wheelset_settle: both forms");
    kstrip::wheelset_forces forces{};
    kstrip::wheelset_derivatives by_velocity{};
    kstrip::wheelset_by_position by_place{};
    fine(kstrip::wheelset_on_track(set, track, at, turning, both, forces, &by_velocity, &by_place), "wheelset_on_track");
    const auto whole = kstrip::wheelset_on_track_with_derivatives(set, track, at, turning, both, true);
    expect(same(whole.forces, forces) && same(whole.derivatives, by_velocity) && same(whole.by_position, by_place), "wheelset_on_track: both forms");
    expect(same(kstrip::wheelset_on_track(set, track, at, turning, both), forces), "wheelset_on_track: the forces alone");
    const std::array<kstrip::wheelset_loads, 2> loads{{{160_kN}, {120_kN, 10_kNm}}};
    const kstrip::wheel_position begin{1_mm, 0_mm, 1_mrad};
    const auto balances = kstrip::wheelsets_settle<double>(set, track, {&begin, 1}, all_move, loads, both);
    expect(same(balances.position[0], at) && same(balances.velocity[0], turning), "wheelsets_settle");
    const auto second = kstrip::wheelset_settle(set, track, begin, moves, loads[1], both);
    expect(same(balances.forces[1], second.forces) && same(balances.position[1], second.position), "wheelsets_settle: the second");
    const auto on_both = kstrip::wheelsets_on_track<double>(set, track, balances.position, balances.velocity, both);
    expect(same(on_both[0], forces) && same(on_both[1], kstrip::wheelset_on_track(set, track, second.position, second.velocity, both)), "wheelsets_on_track");
    auto each_slope = std::vector<kstrip::wheelset_derivatives>(2);
    std::vector<kstrip::wheelset_forces> each_force(2);
    fine(kstrip::wheelsets_on_track<double>(set, track, balances.position, balances.velocity, both, each_force, {statuses.data(), 2},
                                            each_slope.data()), "wheelsets_on_track: derivatives");
    expect(same(each_force[1], on_both[1]) && same(each_slope[0], by_velocity), "wheelsets_on_track: both forms");
    const std::array<double, 6> on_set = forces.wrench;
    expect(std::abs(on_set[2] + 160e3) < 160, "wheelset: the load");
    const auto through = kstrip::curve_motion<double>({20_m_per_s, 0.002_per_m, 0.05_rad}, at, kstrip::wheel_velocity{});
    kstrip::wheel_velocity in_curve{};
    double weight[3];
    fine(kstrip::curve_motion<double>({20_m_per_s, 0.002_per_m, 0.05_rad}, at, {}, in_curve, weight), "curve_motion");
    expect(same(through.velocity, in_curve) && std::memcmp(weight, through.weight.data(), sizeof weight) == 0, "curve_motion: both forms");
    const std::vector<double> shifts{-4e-3, -2e-3, 0.0, 2e-3, 4e-3};
    const auto differences = kstrip::rolling_radius_difference(set, track, shifts, false, both);
    std::array<kstrip::metres, 5> others;
    fine(kstrip::rolling_radius_difference(set, track, shifts, false, both, others), "rolling_radius_difference");
    expect(std::memcmp(differences.data(), others.data(), sizeof others) == 0, "rolling_radius_difference: both forms");
    const auto cone = kstrip::equivalent_conicity(shifts, differences, 1.5_m, 460_mm, std::array{2_mm});
    double conicity[1];
    fine(kstrip::equivalent_conicity(shifts, differences, 1.5_m, 460_mm, std::array{2_mm}, conicity), "equivalent_conicity");
    expect(cone.conicities[0] == conicity[0] && std::abs(conicity[0] - 0.05) < 0.002, "equivalent_conicity: both forms");
    const std::array amplitudes{2_mm, 9_mm, 1_mm};
    std::array<double, 3> each_conicity{-7, -7, -7};
    expect(kstrip::equivalent_conicity(shifts, differences, 1.5_m, 460_mm, amplitudes, each_conicity, nullptr, statuses) ==
               kstrip::status::error_conicity, "equivalent_conicity: an amplitude beyond the shifts");
    expect(statuses[0] == 0 && statuses[1] == KSTRIP_ERROR_CONICITY && statuses[2] == 0 && each_conicity[0] == conicity[0] &&
               each_conicity[1] == -7 && each_conicity[2] > 0, "equivalent_conicity: the others have their results");

    // The index of an error is that of the element
    const auto index_of = [](auto call) {
        try {
            call();
        } catch (const kstrip::error &error) {
            return error.index();
        }
        return std::size_t{99};
    };
    const std::vector<kstrip::wheel_position> aside{at, {1_m}, at};
    const std::vector<kstrip::newtons> pulled{80_kN, 80_kN, -80_kN};
    const std::vector<kstrip::wheelset_loads> lifting{{160_kN}, {160_kN}, {160_kN}, {160_kN, 900_kNm}};
    const std::vector<kstrip::contact> patches{{6_mm, 4_mm, 80_kN, 82_GPa, 0.28, 0.3}, {0_mm, 4_mm, 80_kN, 82_GPa, 0.28, 0.3}};
    expect(index_of([&] { kstrip::wheels_on_rails<double>(rail, wheel, pairs, places, all_move, room); }) == 2, "wheels_on_rails: index");
    expect(index_of([&] { kstrip::heights_for_loads<double>(rail, wheel, pairs, {&where, 1}, pulled, room); }) == 2, "heights_for_loads: index");
    expect(index_of([&] { kstrip::wheelsets_on_track<double>(set, track, aside, all_move, both); }) == 1, "wheelsets_on_track: index");
    expect(index_of([&] { kstrip::wheelsets_settle<double>(set, track, {&begin, 1}, all_move, lifting, both); }) == 3, "wheelsets_settle: index");
    expect(index_of([&] { kstrip::rolling_radius_difference(set, track, std::vector<double>{0, 1e-3, 0.2}, false, both); }) == 2,
           "rolling_radius_difference: index");
    expect(index_of([&] { kstrip::equivalent_conicity(shifts, differences, 1.5_m, 460_mm, amplitudes); }) == 1, "equivalent_conicity: index");
    expect(index_of([&] { kstrip::evaluate_batch(patches, std::vector<kstrip::creepage>(2)); }) == 1, "evaluate_batch: index");
    expect(of_two.statuses == std::vector{kstrip::status::ok, kstrip::status::ok} && heights.statuses.size() == 2 &&
               balances.statuses.size() == 2 && on_both.statuses.size() == 2 && differences.statuses.size() == 5 &&
               cone.statuses.size() == 1, "the status of each result");

    // Errors are thrown
    try {
        static_cast<void>(kstrip::prepare_profile(ry, std::vector<double>(3)));
        expect(false, "two sizes were taken");
    } catch (const kstrip::error &error) {
        expect(error.status() == kstrip::status::error_capacity, "two sizes: another status");
    }
    const auto single = kstrip::prepare_profile(std::vector<float>(ry.begin(), ry.end()), std::vector<float>(rz.begin(), rz.end()));
    expect(std::is_same_v<decltype(single), const kstrip::surface_f32>, "single precision");
    std::printf("%d failures\n", failures);
    return failures;
}
