/* Typical mistakes in C: the good case, and a call of each function; the rows are written behind this by tests/interface/mistakes.rs. */
#include "kstrip.h"
#include "mistakes.h"

#define SET(member, value) ((member) = (value))

static kstrip_contact contact;
static kstrip_creepage creepage;
static kstrip_options options;
static kstrip_radii radii;
static kstrip_combined_material steel;
static kstrip_curve curve;
static kstrip_wheel_pair pair;
static kstrip_wheel_position position;
static kstrip_wheel_velocity velocity;
static kstrip_wheelset_loads loads;
static kstrip_track track;
static kstrip_wheelset set;
static kstrip_surface profiles[3], prepared;
static kstrip_wheel_workspace memory;
static kstrip_wheelset_workspace both;

static const kstrip_surface *of_rail(void) { return &profiles[swapped ? 1 : rail_upside_down ? 2 : 0]; }
static const kstrip_surface *of_wheel(void) { return &profiles[swapped ? 0 : 1]; }

static void good_case(void)
{
    good_numbers();
    contact = (kstrip_contact){6e-3, 4.5e-3, 80e3, 82e9, 0.28, 0.3, 0};
    creepage = (kstrip_creepage){1e-3, 0, 0.1};
    options = (kstrip_options){0, 0};
    radii = (kstrip_radii){1e300, 0.3, 0.46, 1e300};
    steel = (kstrip_combined_material){82e9, 0.28, 0};
    curve = (kstrip_curve){20, 1 / 300.0, 0.1, 0};
    pair = (kstrip_wheel_pair){.wheel_radius = 0.46, .shear_modulus = 82e9, .poisson_ratio = 0.28, .friction = 0.3};
    position = (kstrip_wheel_position){0, 0, 0, 0};
    velocity = (kstrip_wheel_velocity){20, 0, 0, 0, -43.4, 0};
    loads = (kstrip_wheelset_loads){160e3, 0, 0};
    track = (kstrip_track){.gauge = 1.435};
    set = (kstrip_wheelset){.back_to_back = 1.36};
}

static int solve(void)
{
    kstrip_result result;
    return kstrip_solve(&contact, &creepage, &options, &result);
}

static int hertz(void)
{
    return kstrip_contact_from_hertz(&radii, &steel, 80e3, 0.3, &contact, NULL);
}

static int through_curve(void)
{
    return kstrip_curve_motion(&curve, &position, &velocity, &velocity, NULL);
}

static int prepare_shape(const double *y, const double *z, unsigned points, kstrip_surface *to)
{
    return kstrip_prepare_profile(y, z, points, 0, 0, to);
}

static int height(void)
{
    double found;
    position.lateral += offset;
    return kstrip_height_for_load(of_rail(), of_wheel(), &pair, &position, support, NULL, NULL, NULL, &memory, &found);
}

static int wheel(void)
{
    const kstrip_wheel_pair good = {.wheel_radius = 0.46, .shear_modulus = 82e9, .poisson_ratio = 0.28, .friction = 0.3};
    const kstrip_wheel_position middle = {offset, 0, 0, 0};
    double found;
    kstrip_wrench wrench;
    kstrip_height_for_load(&profiles[0], &profiles[1], &good, &middle, 80e3, NULL, NULL, NULL, &memory, &found);
    position.lateral += offset;
    if (position.vertical == 0)
        position.vertical = found;
    return kstrip_wheel_on_rail(of_rail(), of_wheel(), &pair, &position, &velocity, NULL, &memory, &wrench, NULL, NULL);
}

static int settle(void)
{
    kstrip_wheel_position at;
    kstrip_wheel_velocity moves;
    track.rail[0] = of_rail(), set.wheel[0] = of_wheel(), set.pair[0] = pair;
    return kstrip_wheelset_settle(&set, &track, &position, &velocity, &loads, &both, &at, &moves, NULL);
}

static int fit(void)
{
    const kstrip_friction law = {0.35, 1, 0, 0, 0.4, 1, 0};
    kstrip_measured_force points[FORCES];
    kstrip_friction_fit found;
    for (int i = 0; i < FORCES; i++) {
        const kstrip_creepage slip = {0.5e-3 * (1 << i), 0, 0};
        kstrip_result result;
        const kstrip_outputs outputs = {.result = &result};
        kstrip_evaluate(&contact, &slip, &law, NULL, &outputs);
        points[i] = (kstrip_measured_force){slip.longitudinal * creepage_factor, 0, 0, result.fx, 0, 1, KSTRIP_MEASURED_FX, 0};
    }
    return kstrip_fit_friction(&contact, points, FORCES, &law, KSTRIP_FIT_FRICTION | KSTRIP_FIT_SLOPE_FACTOR, NULL, &found, NULL);
}

static int conicity(void)
{
    const double shifts[2] = {-5e-3, 5e-3}, differences[2] = {-5e-4 * sense, 5e-4 * sense};
    double found;
    return kstrip_equivalent_conicity(shifts, differences, 2, 1.5, 0.46, &amplitude, 1, &found, NULL, NULL);
}

static int for_force(void)
{
    return kstrip_creepage_for_force(&contact, force, 0, 0, NULL, NULL, &creepage);
}

static const char *text_of(int status) { return kstrip_status_string(status); }
