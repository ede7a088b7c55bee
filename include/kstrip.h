/**
 * @file kstrip.h
 * kstrip: creep forces of rolling contact by Kalker's strip theory.
 *
 * Generated from the Rust sources by cbindgen; do not edit.
 *
 * ## Example
 *
 *     #include "kstrip.h"
 *     #include <stdio.h>
 *     int main(void)
 *     {
 *         kstrip_contact contact = {.a = 6e-3, .b = 4.5e-3, .normal_force = 80e3,
 *                                   .shear_modulus = 82e9, .poisson_ratio = 0.28, .friction = 0.3};
 *         kstrip_creepage creepage = {.longitudinal = 1e-3, .spin = 0.1};
 *         kstrip_result forces;
 *         kstrip_status status = kstrip_solve(&contact, &creepage, NULL, &forces);
 *         if (status < 0) return puts(kstrip_status_string(status)), 1;
 *         printf("%.0f N along, %.0f N across\n", forces.fx, forces.fy);
 *     }
 *
 * ## Functions
 *
 * Each name begins with kstrip_; the groups are those of this file.
 *
 *     Status: status_string
 *     Bodies: material_combine, contact_from_hertz, contact_from_approach, linear_coefficients
 *     Motion: creepage_from_velocities, parameters_from_creepage, creepage_from_parameters
 *     Solve: solve, evaluate, evaluate_batch, prepare, solve_prepared, solve_motion, solve_total,
 *         solve_strip, solve_strip_1967, solve_linear
 *     Inside the contact: field
 *     Patches of any shape: patch_from_profile, patch_from_strips, patch_from_contact,
 *         patch_summarize, patch_evaluate, patch_evaluate_strips, patch_field
 *     Wheel on rail: read_profile, orient_profiles, prepare_profile, profile_between, touch,
 *         contacts_from_gap, wheel_motion, wrench_from_contacts, contact_power_across,
 *         wheel_on_rail, wheels_on_rails, height_for_load, heights_for_loads, table_size,
 *         table_begin, table_fill, table_finish, table_check, wheel_on_table
 *     The wheelset: gauge_face, curve_motion, wheelset_on_track, wheelset_settle,
 *         wheelsets_on_track, wheelsets_settle, rolling_radius_difference, equivalent_conicity
 *     Test rigs: estimate_friction, creepage_for_force, fit_friction
 *     Options: options_init, result_on_upper_body, version_string, abi_version
 *
 * ## Axes and signs
 *
 *              x  rolling direction, leading edge at x > 0
 *              ^
 *          _.--|--._        The patch seen along z, which points INTO the lower body,
 *        .'    |    '.      away from the viewer.
 *        |     o-----|-> y
 *        '.    z    .'      a: semi-axis along x [m]
 *          '-.___.-'        b: semi-axis along y [m]
 *
 * - Creepage: (velocity of the UPPER body - velocity of the LOWER body) / rolling speed.
 *   Spin: (angular velocity of the upper - lower body about z) / rolling speed [1/m].
 * - Every force and traction acts on the LOWER body and has the sense of the creepage. The upper
 *   body (usually the wheel) gets the opposite: kstrip_result_on_upper_body().
 *   CONTACT and Simpack report the force on the upper body, hence their minus signs.
 * - SI units everywhere: N, m, Pa, 1/m, rad/s.
 *
 * In the comments mu is the coefficient of friction, N the normal force, G the combined shear modulus and nu the combined Poisson's ratio.
 * p0 is the pressure at the centre of the ellipse, and |F| the length of the tangential force. Numbers such as (2.6) are equations of
 * Kalker's paper of 1967 (docs/maintain/theory.md). CONTACT is the reference program against which all errors are measured.
 *
 * ## Conventions
 *
 * - A function returns a kstrip_status, but for kstrip_status_string() and the two versions. Zero is success, a positive
 *   status is a warning with valid outputs, and a negative status is an error with outputs untouched. kstrip_status_string()
 *   returns the cause and the remedy. A workspace, and the contacts of kstrip_contacts_from_gap(), may change before an error.
 *   If a function writes an array of statuses, only the outputs of elements with an error are untouched.
 * - Each function lists its statuses. The usual statuses are KSTRIP_OK, KSTRIP_ERROR_NULL (a pointer that must be given is NULL),
 *   KSTRIP_ERROR_NOT_FINITE (a number is infinite or NaN) and KSTRIP_ERROR_OVERFLOW (a result, such as a derivative, is too large).
 *   The statuses of a structure are those that its comment, those of its members and those of its inner structures name.
 * - An implausible input alone is a warning. If it leads to an error, the error names the likely cause.
 * - If several warnings apply, the most serious is returned: NOT_CONVERGED, then SEVERAL_FRICTIONS, then FRICTION_AT_LEAST and
 *   CREEPAGE_AT_LEAST, then implausible inputs (such as PRESSURE, RADIUS, YOUNG), then BEYOND_FRICTION, ANGLE_RANGE and PROFILE_END, then the others.
 * - Zero is the default. Options that are NULL, options that are all zero, and a single member that is zero mean the recommended choice.
 * - A lost contact is an ordinary input. With normal_force <= 0 every function that solves returns zero forces and
 *   derivatives, adhesion 0 and KSTRIP_OK. a and b may then be 0. NaN is an error.
 * - NULL, NaN, infinities and any other numbers are safe inputs. Pointers must be NULL or valid and
 *   aligned; any other pointer is undefined behaviour, as in C. Arrays must have as many elements as their count. Outputs must not overlap inputs.
 * - An output that may be NULL and is NULL is not computed and costs nothing.
 * - No function allocates, blocks or calls back, and no result depends on earlier calls. Every function may be called from any
 *   thread and from interrupt handlers. Stack use: docs/reference/building.md.
 * - kstrip_f32.h has the same functions and structures in single precision, with the suffix _f32.
 * - The same inputs give the same bits on every machine with IEEE arithmetic, and in every thread.
 */

#ifndef KSTRIP_H
#define KSTRIP_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * @defgroup kstrip_status Status
 * @{
 */

/** Result of a call: 0 ok; > 0 warning, outputs valid; < 0 error, outputs untouched. */
typedef int32_t kstrip_status;

/** Success. */
#define KSTRIP_OK 0

/** Warning: the spin parameter |psi| is 1 or more, which is beyond the theory of 1967. */
#define KSTRIP_WARNING_SPIN 1
/** Warning: |psi| is above 3, beyond the comparison of KSTRIP_MODEL_STRIP with CONTACT. */
#define KSTRIP_WARNING_RANGE 2
/** Warning: the force of KSTRIP_MODEL_LINEAR exceeds mu N. */
#define KSTRIP_WARNING_BEYOND_FRICTION 3
/**
 * Warning: more than one coefficient of friction fits: with falling friction the result has the
 * largest, reached from rest; an estimate is the smallest.
 */
#define KSTRIP_WARNING_SEVERAL_FRICTIONS 4
/** Warning: an iteration ended before its result was accurate to rounding. */
#define KSTRIP_WARNING_NOT_CONVERGED 5
/** Warning: the contact sticks, so that the result is only a lower bound of friction. */
#define KSTRIP_WARNING_FRICTION_AT_LEAST 6
/** Warning: the requested force is that of full sliding, and every larger creepage has it as well. */
#define KSTRIP_WARNING_CREEPAGE_AT_LEAST 7
/**
 * Warning: implausible pressure, above a tenth of the shear modulus: the modulus (Pa), the load
 * (N) or the semi-axes (m) are probably in another unit.
 */
#define KSTRIP_WARNING_PRESSURE 8
/**
 * Warning: implausible creepage, above 10: it is probably in per cent, or the contact hardly rolls
 * (at low speed use slip velocities).
 */
#define KSTRIP_WARNING_CREEPAGE 9
/** Warning: implausible semi-axis, above 1 m: it is probably in mm. */
#define KSTRIP_WARNING_SEMI_AXIS 10
/**
 * Warning: implausible spin, larger than rolling bodies of this curvature can have: it is probably
 * in degrees per metre.
 */
#define KSTRIP_WARNING_SPIN_UNIT 11
/** Warning: implausible coefficient of friction, above 5: it is probably in per cent. */
#define KSTRIP_WARNING_FRICTION 12
/** Warning: implausible radii, larger than 5 m in both directions: they are probably in mm. */
#define KSTRIP_WARNING_RADIUS 13
/** Warning: the axis ratio a/b is outside 0.015 to 60, the range for which the model was made. */
#define KSTRIP_WARNING_AXIS_RATIO 14
/**
 * Warning: the mismatch of the materials exceeds 0.25, and the model was not compared with its
 * reference there.
 */
#define KSTRIP_WARNING_MISMATCH 15
/** Warning: the theory of 1967 neglects the mismatch of the materials. */
#define KSTRIP_WARNING_MISMATCH_NEGLECTED 16
/**
 * Warning: a semi-axis exceeds 0.3 of the smaller radius in its direction, so that the bodies are
 * not half-spaces.
 */
#define KSTRIP_WARNING_CONFORMAL 17
/**
 * Warning: the normal turns by more than 30 degrees over a contact of a wheel: forces may be off
 * by some tenths of mu N.
 */
#define KSTRIP_WARNING_ANGLE_RANGE 19
/** Warning: a contact region ends with the profile, as if the bodies ended there. */
#define KSTRIP_WARNING_PROFILE_END 18
/** Warning: the measured points do not determine each parameter of a law. */
#define KSTRIP_WARNING_UNDETERMINED 20
/**
 * Warning: implausible profile, upside down or the wrong way round, or a contact of a wheel above
 * 30 degrees.
 */
#define KSTRIP_WARNING_ORIENTATION 21
/** Warning: implausible profile, longer than 1 m: it is probably in mm. */
#define KSTRIP_WARNING_PROFILE_SIZE 22
/**
 * Warning: implausible shear modulus, below 0.1 MPa or above 10 TPa: it is probably in another
 * unit than Pa.
 */
#define KSTRIP_WARNING_MODULUS 23
/** Warning: friction and Poisson's ratio of a wheel and a rail are both 0. */
#define KSTRIP_WARNING_UNSET 24
/**
 * Warning: no ordinary contact supports the wheel: its support falls with depth, or its peak
 * pressure exceeds a twentieth of the shear modulus.
 */
#define KSTRIP_WARNING_SUPPORT 25
/**
 * Warning: a contact of a wheel is narrower than four point spacings of a profile, so that the
 * pressure depends on the shape between the points.
 */
#define KSTRIP_WARNING_PROFILE_COARSE 26
/**
 * Warning: a contact has more local minima than its strips resolve, or a wheel has more than four
 * contacts: the load may jump.
 */
#define KSTRIP_WARNING_ROUGH 27
/**
 * Warning: implausible curvature of the track, above 0.2 per m: it is probably the radius of the
 * curve.
 */
#define KSTRIP_WARNING_CURVATURE 28
/** Warning: implausible shear modulus, above 150 GPa: it is probably Young's modulus E. */
#define KSTRIP_WARNING_YOUNG 29
/** Warning: implausible slope factor, fitted below 0.05: the creepages are probably in per cent. */
#define KSTRIP_WARNING_PER_CENT 30
/** Warning: implausible damping, which more than doubles the pressure: it is probably in N s/m. */
#define KSTRIP_WARNING_DAMPING 31
/**
 * Warning: another law fits the measured points as well: its residual is at most 1 per cent
 * larger.
 */
#define KSTRIP_WARNING_SECOND_MINIMUM 32
/**
 * Warning: a fitted parameter of a law is at its bound, and beyond it the law would fit the
 * measured points better.
 */
#define KSTRIP_WARNING_FIT_BOUND 33
/**
 * Warning: kind, side, direction of z, origin or unit of a profile file are guessed from weak
 * evidence, or contradict the file.
 */
#define KSTRIP_WARNING_PROFILE_GUESS 34

/** Error: a required pointer is NULL. */
#define KSTRIP_ERROR_NULL -1
/** Error: an input is infinite or NaN. */
#define KSTRIP_ERROR_NOT_FINITE -2
/** Error: a semi-axis is not positive. */
#define KSTRIP_ERROR_SEMI_AXIS -3
/** Error: the normal force of two profiles or of a contact of a wheel is negative. */
#define KSTRIP_ERROR_NORMAL_FORCE -4
/** Error: a modulus of elasticity is not positive. */
#define KSTRIP_ERROR_MODULUS -5
/** Error: Poisson's ratio is outside [0, 0.5]. */
#define KSTRIP_ERROR_POISSON_RATIO -6
/** Error: the coefficient of friction is negative. */
#define KSTRIP_ERROR_FRICTION -7
/** Error: the model is not one of the KSTRIP_MODEL constants. */
#define KSTRIP_ERROR_MODEL -8
/** Error: the strip count is not 4, 8, 16, 32 or 64. */
#define KSTRIP_ERROR_STRIP_COUNT -9
/** Error: a radius is zero or NaN, or the summed curvature in a plane is not positive. */
#define KSTRIP_ERROR_CURVATURE -10
/** Error: the rolling speed is not positive. */
#define KSTRIP_ERROR_ROLLING_SPEED -11
/** Error: the caller's array is too small, or a count exceeds the capacity of a structure. */
#define KSTRIP_ERROR_CAPACITY -12
/**
 * Error: the model cannot compute a requested output, because it has no strips, no field or no
 * patches, or its force does not depend on friction.
 */
#define KSTRIP_ERROR_NOT_IN_MODEL -13
/** Error: a result is beyond the range of the floating-point type. */
#define KSTRIP_ERROR_OVERFLOW -14
/** Error: the ratio of falling friction is outside [0, 1]. */
#define KSTRIP_ERROR_FRICTION_RATIO -15
/** Error: the decay of falling friction is negative. */
#define KSTRIP_ERROR_FRICTION_DECAY -16
/** Error: the rolling speed of falling friction is negative. */
#define KSTRIP_ERROR_NEGATIVE_SPEED -17
/** Error: the factor of the initial slope is outside [0, 1]. */
#define KSTRIP_ERROR_SLOPE_FACTOR -18
/** Error: no friction explains the measured force. */
#define KSTRIP_ERROR_UNEXPLAINED -19
/**
 * Error: the requested force exceeds mu N, or the torque about an axle exceeds the torque that
 * friction carries at any pitch rate.
 */
#define KSTRIP_ERROR_FORCE_BEYOND_FRICTION -20
/** Error: the measurement is not one of KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY, or their sum. */
#define KSTRIP_ERROR_MEASURED -21
/**
 * Error: a structure was not filled by kstrip_prepare() of the same precision, or a profile not by
 * kstrip_prepare_profile().
 */
#define KSTRIP_ERROR_NOT_PREPARED -22
/** Error: the floor of the speed is negative. */
#define KSTRIP_ERROR_FLOOR_SPEED -23
/**
 * Error: the stride of an output of a batch is smaller than the output, or a stride is not a
 * multiple of the alignment.
 */
#define KSTRIP_ERROR_STRIDE -24
/** Error: the slide factor is outside [0, 1]. */
#define KSTRIP_ERROR_SLIDE_FACTOR -25
/** Error: the layer between the bodies is negative. */
#define KSTRIP_ERROR_LAYER -26
/** Error: there are fewer measured forces than parameters to fit. */
#define KSTRIP_ERROR_FEW_POINTS -27
/** Error: no parameter is to be fitted, or the number is not a sum of KSTRIP_FIT constants. */
#define KSTRIP_ERROR_FIT_PARAMETERS -28
/** Error: the weight of a measured point is negative. */
#define KSTRIP_ERROR_WEIGHT -29
/** Error: the model, or its falling friction or layer, was left out of this build of the library. */
#define KSTRIP_ERROR_MODEL_LEFT_OUT -30
/**
 * Error: the wheel finds no support, and the shear modulus is below 0.1 MPa: it is probably in MPa
 * or GPa.
 */
#define KSTRIP_ERROR_MODULUS_UNIT -31
/** Error: a strip of a patch has a width or half length that is not positive. */
#define KSTRIP_ERROR_STRIP_SIZE -40
/** Error: the peak pressure of a strip is negative. */
#define KSTRIP_ERROR_PRESSURE -41
/** Error: strips of a patch overlap, or do not ascend in y. */
#define KSTRIP_ERROR_STRIP_ORDER -42
/** Error: there are more strips than a patch can hold, or more contacts than a wheel may have. */
#define KSTRIP_ERROR_PATCH_SIZE -43
/** Error: a profile has too few points or a negative step, or numbers that must ascend do not. */
#define KSTRIP_ERROR_PROFILE -44
/** Error: a profile ends where the bodies would touch, or the wheel is beside the rail. */
#define KSTRIP_ERROR_PROFILE_END -45
/** Error: a rolling radius or the radius of a wheel is not positive. */
#define KSTRIP_ERROR_ROLLING_RADIUS -46
/** Error: a smoothing length is negative. */
#define KSTRIP_ERROR_SMOOTHING_LENGTH -47
/** Error: no line follows the points of a profile, because they scatter or turn back too far. */
#define KSTRIP_ERROR_SCATTER -48
/** Error: the damping of the pressure is negative. */
#define KSTRIP_ERROR_NORMAL_DAMPING -49
/** Error: the share of a contact of a wheel is negative. */
#define KSTRIP_ERROR_SHARE -50
/** Error: the requested support of a wheel, or the vertical load of a wheelset, is not positive. */
#define KSTRIP_ERROR_SUPPORT -51
/**
 * Error: a yaw, roll or cant is 1 rad or more, or a wheel beside the rail has a yaw or roll above
 * 0.2 rad.
 */
#define KSTRIP_ERROR_ANGLE -52
/**
 * Error: the wheel is over 0.7 m beside or 5 m above or below the rail, its radius exceeds 5 m, or
 * a profile 1 m.
 */
#define KSTRIP_ERROR_LENGTH_UNIT -53
/**
 * Error: the wheel is beside the rail, the rail's profile has a flange, and the wheel's profile
 * has the head of a rail.
 */
#define KSTRIP_ERROR_SWAPPED -54
/**
 * Error: the wheel is beside the rail, and a profile is upside down, the wrong way round, or
 * neither a wheel nor a rail.
 */
#define KSTRIP_ERROR_ORIENTATION -55
/** Error: a gauge, a place of a rail or a distance of wheels is missing or negative. */
#define KSTRIP_ERROR_GAUGE -60
/** Error: no position of the wheelset balances the loads, because a wheel lifts. */
#define KSTRIP_ERROR_WHEEL_LIFTED -61
/**
 * Error: no wave has this amplitude: it is not positive or beyond the shifts, or the radii turn
 * the wheelset away from the middle.
 */
#define KSTRIP_ERROR_CONICITY -62
/** Error: the format of a profile file is not one of the constants. */
#define KSTRIP_ERROR_FILE_FORMAT -70
/** Error: a line of a profile file is not a point, a keyword or a title of its format. */
#define KSTRIP_ERROR_FILE_LINE -71
/** Error: a table has more than two columns, and no line before it names y and z. */
#define KSTRIP_ERROR_FILE_COLUMNS -72
/** Error: a profile file has fewer points than its header promises. */
#define KSTRIP_ERROR_FILE_COUNT -73
/**
 * Error: the unit of a profile file is not positive, or its numbers are too large for a profile in
 * millimetres.
 */
#define KSTRIP_ERROR_FILE_UNITS -74
/** Error: a number of a table is far from all others, and probably marks a missing number. */
#define KSTRIP_ERROR_FILE_MISSING -75
/** Error: the share of a profile between two slices is not in 0 to 1. */
#define KSTRIP_ERROR_SLICE_SHARE -76
/**
 * Error: the memory is not a contact table of this version: it is damaged, cut off, or something
 * else.
 */
#define KSTRIP_ERROR_TABLE -80
/** Error: a contact table is not finished, or a finished table is to be filled. */
#define KSTRIP_ERROR_TABLE_UNFINISHED -81
/**
 * Error: a contact table was made for another radius, material or smoothing length, or the rail is
 * a roller.
 */
#define KSTRIP_ERROR_TABLE_PAIR -82
/**
 * Error: a contact table's range is empty, negative or without contact, nodes are too few, strips
 * are not 12 to 32, or no such part exists.
 */
#define KSTRIP_ERROR_TABLE_SPEC -83
/** Error: a position is outside the ranges of a contact table, or its load is above the largest. */
#define KSTRIP_ERROR_TABLE_RANGE -84

/**
 * Text in English with the cause of a status and the remedy.
 *
 * @param status  a status that a function returned, or any other number.
 * @return a static string, never NULL; "unknown status" for a number that is no status.
 */
const char *kstrip_status_string(kstrip_status status);

/** @} */

/**
 * @defgroup kstrip_bodies Bodies: materials, Hertz's ellipse and its inverse, linear coefficients
 * @{
 */

/** An isotropic elastic body. */
typedef struct kstrip_material {
    /** Shear modulus G [Pa], > 0, else KSTRIP_ERROR_MODULUS. Steel: 82e9. */
    double shear_modulus;
    /** Poisson's ratio [-], 0 to 0.5, else KSTRIP_ERROR_POISSON_RATIO. Steel: 0.28. */
    double poisson_ratio;
} kstrip_material;

/** The combined elastic constants of two bodies. */
typedef struct kstrip_combined_material {
    /** Combined shear modulus G [Pa], 1/G = (1/G_lower + 1/G_upper)/2 (2.6). */
    double shear_modulus;
    /** Combined Poisson's ratio nu [-], nu/G = (nu_lower/G_lower + nu_upper/G_upper)/2 (2.6). */
    double poisson_ratio;
    /**
     * Mismatch kappa [-] (4.3) of the two materials, for kstrip_contact: 0 for like materials;
     * -0.07 for steel (lower) on aluminium, -0.15 on a polymer.
     */
    double mismatch;
} kstrip_combined_material;

/**
 * Combine the elastic constants of two bodies. From Young's modulus: shear_modulus = E/(2 (1 +
 * poisson_ratio)).
 *
 * @param lower, upper    the two bodies.
 * @param[out] combined   receives the constants that kstrip_contact_from_hertz() and
 *                        kstrip_contact take.
 * @return usual statuses; statuses of kstrip_material.
 */
kstrip_status kstrip_material_combine(const struct kstrip_material *lower,
                                      const struct kstrip_material *upper,
                                      struct kstrip_combined_material *combined);

/**
 * Radii of curvature of two bodies at the contact [m]: convex positive, flat infinite
 * (INFINITY), concave negative. KSTRIP_ERROR_CURVATURE if one is 0 or NaN, or if the curvatures of
 * both bodies in one plane add up to 0 or less; KSTRIP_WARNING_RADIUS if they are those of radii
 * above 5 m in both planes.
 */
typedef struct kstrip_radii {
    /** Lower body in the plane of x and z (a straight rail: INFINITY). */
    double lower_x;
    /** Lower body in the plane of y and z (a rail: radius of the head). */
    double lower_y;
    /** Upper body in the plane of x and z (a wheel: rolling radius). */
    double upper_x;
    /** Upper body in the plane of y and z (a wheel: radius of the profile, INFINITY if conical). */
    double upper_y;
} kstrip_radii;

/** A loaded elliptic contact with combined elastic constants and Coulomb friction. */
typedef struct kstrip_contact {
    /** Semi-axis a along the rolling direction x [m], > 0, else KSTRIP_ERROR_SEMI_AXIS. */
    double a;
    /** Semi-axis b along y [m], likewise; KSTRIP_WARNING_SEMI_AXIS if one is above 1 m. */
    double b;
    /**
     * Normal force N [N]. If it is <= 0 the contact is lost, and the other members only need to
     * be finite. KSTRIP_WARNING_PRESSURE if the peak pressure is above a tenth of shear_modulus.
     */
    double normal_force;
    /**
     * Combined shear modulus G [Pa] (2.6), > 0, else KSTRIP_ERROR_MODULUS; above 150 GPa
     * KSTRIP_WARNING_YOUNG, above 10 TPa KSTRIP_WARNING_MODULUS.
     */
    double shear_modulus;
    /** Combined Poisson's ratio nu [-], 0 to 0.5, else KSTRIP_ERROR_POISSON_RATIO. */
    double poisson_ratio;
    /** Friction mu [-], >= 0, else KSTRIP_ERROR_FRICTION; above 5 KSTRIP_WARNING_FRICTION. */
    double friction;
    /**
     * Mismatch kappa [-] of the two materials (4.3), from kstrip_material_combine(). It is 0
     * for similar materials and positive if the lower body is softer. Its sign changes if the
     * bodies are exchanged. In dissimilar bodies pressure makes a longitudinal creepage, so that
     * there is a force without creepage. KSTRIP_WARNING_MISMATCH if its size is above 0.25.
     */
    double mismatch;
} kstrip_contact;

/** The contact ellipse of Hertz. */
typedef struct kstrip_hertz_contact {
    /** Semi-axis along the rolling direction x [m]. */
    double a;
    /** Semi-axis along y [m]. */
    double b;
    /** Pressure at the centre [Pa]. */
    double peak_pressure;
    /** Approach of distant points of the two bodies [m]. */
    double approach;
    /** Minor divided by major semi-axis [-], 0 to 1 (2.2). */
    double axis_ratio;
    /** Hertz's angle tau [rad], 0 to pi/2 (2.5). */
    double hertz_angle;
    /** Four divided by the sum of the four curvatures [m] (2.3). */
    double rho;
} kstrip_hertz_contact;

/**
 * The contact of two bodies that a load presses together (Hertz).
 *
 * @param radii           curvatures of both bodies.
 * @param pair            combined constants.
 * @param load            N [N]; not positive: the contact is lost, a = b = normal_force = 0.
 * @param friction        coefficient of friction [-], >= 0.
 * @param[out] contact    receives the contact.
 * @param[out] ellipse    receives pressure, approach and shape; NULL: not needed.
 * @return usual statuses; statuses of kstrip_radii; KSTRIP_ERROR_MODULUS and
 *         KSTRIP_ERROR_POISSON_RATIO (pair is outside the ranges of kstrip_material);
 *         KSTRIP_ERROR_FRICTION (friction < 0); warnings of kstrip_contact (about the contact that
 *         is found); KSTRIP_WARNING_CONFORMAL (a semi-axis is above 0.3 of the smaller radius in
 *         its direction).
 */
kstrip_status kstrip_contact_from_hertz(const struct kstrip_radii *radii,
                                        const struct kstrip_combined_material *pair,
                                        double load,
                                        double friction,
                                        struct kstrip_contact *contact,
                                        struct kstrip_hertz_contact *ellipse);

/**
 * The contact of two bodies that have approached each other: the exact inverse of Hertz, for
 * penalty contact.
 *
 * @param radii           curvatures of both bodies.
 * @param pair            combined constants.
 * @param approach        of distant points of the bodies [m]; not positive: the contact is lost.
 * @param friction        coefficient of friction [-], >= 0.
 * @param[out] contact    receives the contact, with its load.
 * @param[out] dload_dapproach  receives the contact stiffness dN/d(approach) [N/m]; NULL: not
 *                              needed.
 * @return as kstrip_contact_from_hertz().
 */
kstrip_status kstrip_contact_from_approach(const struct kstrip_radii *radii,
                                           const struct kstrip_combined_material *pair,
                                           double approach,
                                           double friction,
                                           struct kstrip_contact *contact,
                                           double *dload_dapproach);

/**
 * Kalker's coefficients C11, C22, C23, C33 of the linear theory.
 *
 * For vanishing creepage fx = G a b C11 longitudinal, fy = G a b (C22 lateral + sqrt(ab) C23
 * spin), mz = G (ab)^(3/2) (sqrt(ab) C33 spin - C23 lateral). Beyond axis ratios of 0.1 to 10 they
 * follow the asymptotes of slender ellipses.
 *
 * @param axis_ratio      a/b [-], > 0; a along the rolling direction.
 * @param poisson_ratio   combined Poisson's ratio [-], 0 to 0.5.
 * @param[out] coefficients  receives four numbers: C11, C22, C23, C33.
 * @return KSTRIP_OK; KSTRIP_ERROR_NULL (coefficients), KSTRIP_ERROR_NOT_FINITE (an argument is
 *         infinite or NaN), KSTRIP_ERROR_SEMI_AXIS (axis_ratio <= 0), KSTRIP_ERROR_POISSON_RATIO
 *         (outside 0 to 0.5).
 */
kstrip_status kstrip_linear_coefficients(double axis_ratio,
                                         double poisson_ratio,
                                         double *coefficients);

/** @} */

/**
 * @defgroup kstrip_motion Motion: creepages, Kalker's parameters
 * @{
 */

/** Velocity of one body's material at the centre of the contact, relative to the contact. */
typedef struct kstrip_velocity {
    /** Along the rolling direction x [m/s]: about minus the rolling speed for both bodies. */
    double x;
    /** Lateral, along y [m/s]. */
    double y;
    /** Angular velocity about the normal z into the lower body [rad/s]. */
    double angular_z;
} kstrip_velocity;

/**
 * Rigid slip of the upper relative to the lower body, divided by the rolling speed (3.3).
 * KSTRIP_WARNING_CREEPAGE if longitudinal or lateral is above 10 in size; KSTRIP_WARNING_SPIN_UNIT
 * if the spin is larger than bodies that roll on such a contact can have.
 */
typedef struct kstrip_creepage {
    /** Longitudinal creepage [-], positive when the upper body slides in the rolling direction. */
    double longitudinal;
    /** Lateral creepage [-], positive along y. */
    double lateral;
    /** Spin [1/m], positive from x to y, that is about z into the lower body. */
    double spin;
} kstrip_creepage;

/**
 * Creepages from the velocities of both bodies: (upper - lower)/rolling_speed.
 *
 * For forward rolling at some speed; kstrip_solve_motion() takes velocities through standstill and
 * reversal.
 *
 * @param lower, upper    surface velocities at the centre of the contact, in one frame.
 * @param rolling_speed   V [m/s], > 0; x points in the rolling direction.
 * @param[out] creepage   receives the creepages.
 * @return usual statuses; KSTRIP_ERROR_ROLLING_SPEED (rolling_speed <= 0).
 */
kstrip_status kstrip_creepage_from_velocities(const struct kstrip_velocity *lower,
                                              const struct kstrip_velocity *upper,
                                              double rolling_speed,
                                              struct kstrip_creepage *creepage);

/** Kalker's parameters (5.13) of a contact in motion, dimensionless. */
typedef struct kstrip_parameters {
    /** xi = longitudinal G/(2 (1 - nu) mu p0) */
    double xi;
    /** eta = lateral G/(2 mu p0) */
    double eta;
    /** psi = a spin G/(2 mu p0). The theory of 1967 is valid for |psi| < 1. */
    double psi;
} kstrip_parameters;

/**
 * Kalker's dimensionless parameters xi, eta, psi (5.13) of a contact in motion; zero where it is
 * lost.
 *
 * @param contact         ellipse, load, material, friction.
 * @param creepage        its motion.
 * @param[out] parameters  receives xi, eta and psi [-].
 * @return usual statuses; errors of kstrip_contact.
 */
kstrip_status kstrip_parameters_from_creepage(const struct kstrip_contact *contact,
                                              const struct kstrip_creepage *creepage,
                                              struct kstrip_parameters *parameters);

/**
 * The creepage that has the given parameters xi, eta, psi on a contact: the inverse of
 * kstrip_parameters_from_creepage(); zero where it is lost.
 *
 * @param contact         ellipse, load, material, friction.
 * @param parameters      xi, eta and psi [-].
 * @param[out] creepage   receives the creepage.
 * @return usual statuses; errors of kstrip_contact.
 */
kstrip_status kstrip_creepage_from_parameters(const struct kstrip_contact *contact,
                                              const struct kstrip_parameters *parameters,
                                              struct kstrip_creepage *creepage);

/** @} */

/**
 * @defgroup kstrip_solve Solve: forces, derivatives, strips
 * @{
 */

/**
 * The default, 0: forces and derivatives from KSTRIP_MODEL_TOTAL; fields, strips and patches from
 * KSTRIP_MODEL_STRIP.
 */
#define KSTRIP_MODEL_DEFAULT 0
/**
 * The strip theory of Kalker's paper of 1967. It has no fitted constants. It has the sliding rule
 * that the paper keeps for forces: strips without adhesion slide along the rigid slip of their
 * centre line. The paper made it for slender ellipses, a/b up to 0.2, and |psi| < 1.
 */
#define KSTRIP_MODEL_STRIP_1967 1
/** The same theory with the sliding rule that joins adhesion strips without a jump. */
#define KSTRIP_MODEL_STRIP_1967_CONTINUOUS 2
/**
 * A strip theory in Kalker's sense: the half-ellipses of 1967 where a strip adheres, slip along
 * the local rigid slip if it does not. A small network, fitted to CONTACT, corrects the
 * flexibilities. It has forces, moment, stick area and fields. Its derivatives at rest are those
 * of linear theory, and its power is never negative.
 */
#define KSTRIP_MODEL_STRIP 3
/**
 * A closed formula with a small network fitted to CONTACT. It has forces and moment, and is the
 * most accurate model for ellipses. Far in sliding it is rigid slip, and its power is never
 * negative. It has no strips and no field; adhesion is reported as -1 (unknown).
 */
#define KSTRIP_MODEL_TOTAL 4
/**
 * Kalker's linear theory, for stability analysis. Its force grows with the creepage without a
 * limit. Adhesion is 1.
 */
#define KSTRIP_MODEL_LINEAR 5

/** Largest number of strips that kstrip_evaluate() writes. */
#define KSTRIP_STRIPS_CAPACITY 64

/** State of a point: outside the contact. */
#define KSTRIP_STATE_OUTSIDE 0
/** State of a point: adhesion, no slip. */
#define KSTRIP_STATE_STICK 1
/** State of a point: slip. */
#define KSTRIP_STATE_SLIP 2
/**
 * State of a point: slip against the traction (negative local dissipation). This is an error of
 * the strip theory near the leading edge of sliding strips.
 */
#define KSTRIP_STATE_SLIP_NEGATIVE_DISSIPATION 3

/**
 * The model and the number of strips. All zero is the default. Outside the range of the model:
 * KSTRIP_WARNING_SPIN (1967, |psi| of 1 or more), KSTRIP_WARNING_RANGE (STRIP, |psi| above 3),
 * KSTRIP_WARNING_AXIS_RATIO (STRIP, TOTAL: a/b beyond 0.015 to 60), KSTRIP_WARNING_BEYOND_FRICTION
 * (LINEAR, more than mu N), KSTRIP_WARNING_MISMATCH_NEGLECTED (1967, a mismatch that is not 0).
 */
typedef struct kstrip_options {
    /**
     * One of the KSTRIP_MODEL constants, else KSTRIP_ERROR_MODEL; KSTRIP_ERROR_MODEL_LEFT_OUT if
     * this build of the library has no such model.
     */
    int32_t model;
    /**
     * Number of strips: 4, 8, 16, 32 or 64; 0 means 16; else KSTRIP_ERROR_STRIP_COUNT. Models
     * without strips check it and ignore it otherwise.
     */
    int32_t strips;
} kstrip_options;

/** Forces on the lower body. */
typedef struct kstrip_result {
    /** Longitudinal force [N], positive along the rolling direction. */
    double fx;
    /** Lateral force [N]. */
    double fy;
    /** Moment about z at the centre of the contact [N m]. */
    double mz;
    /**
     * Frictional power divided by rolling speed, fx longitudinal + fy lateral + mz spin [N]:
     * energy dissipated per metre rolled. For dissimilar bodies the creepage that pressure makes
     * is added to the longitudinal one.
     */
    double power;
    /**
     * Share of the contact area in adhesion [-], 0 to 1. It is -1 with KSTRIP_MODEL_TOTAL, which
     * does not compute it, and 1 with KSTRIP_MODEL_LINEAR, which has adhesion everywhere.
     */
    double adhesion;
    /** The status of this result: 0 or one of the KSTRIP_WARNING constants. */
    kstrip_status status_detail;
    /** Reserved: zero. */
    int32_t reserved;
} kstrip_result;

/**
 * Forces of a contact in motion, on the lower body: the fast path.
 *
 * The forces are continuous in all inputs, and |F| <= mu N. They are zero where creepage and spin
 * are zero, and where the contact is lost (normal_force <= 0), with adhesion 0. The forces of
 * KSTRIP_MODEL_LINEAR have no such bound, and for given semi-axes do not change with the load
 * until the contact is lost. The time is bounded: every iteration has a largest number of steps.
 *
 * @param contact         ellipse, load, material, friction.
 * @param creepage        motion.
 * @param options         model and strip count; NULL for the defaults.
 * @param[out] result     receives forces, moment, power and adhesion.
 * @return usual statuses; statuses of kstrip_contact, kstrip_creepage and kstrip_options.
 */
kstrip_status kstrip_solve(const struct kstrip_contact *contact,
                           const struct kstrip_creepage *creepage,
                           const struct kstrip_options *options,
                           struct kstrip_result *result);

/**
 * Falling friction: the coefficient is friction ((1 - ratio) exp(-decay w) +
 * ratio), where w is the sliding velocity [m/s]. A layer between the bodies makes the creep
 * curve less steep: slope_factor and slide_factor describe it for a measured or published curve,
 * and layer is an elastic layer that is known.
 *
 * Polach, Wear 258 (2005) 992, gives for locomotives: dry friction 0.55, ratio 0.4, decay 0.6 s/m;
 * wet 0.3, 0.4, 0.2 s/m. KSTRIP_ERROR_MODEL_LEFT_OUT if this build of the library has no laws.
 */
typedef struct kstrip_friction {
    /** Coefficient of friction without slip [-], >= 0, else KSTRIP_ERROR_FRICTION. */
    double friction;
    /**
     * Friction at infinite sliding velocity divided by friction at zero velocity [-], 0 to 1,
     * else KSTRIP_ERROR_FRICTION_RATIO; 1: friction is constant.
     */
    double ratio;
    /** How fast friction falls [s/m], >= 0, else KSTRIP_ERROR_FRICTION_DECAY; 0: it is constant. */
    double decay;
    /**
     * Rolling speed [m/s], >= 0, else KSTRIP_ERROR_NEGATIVE_SPEED; the sliding velocity is slip
     * times rolling speed. 0: friction is constant.
     */
    double rolling_speed;
    /**
     * Initial slope of the creep curve divided by that of clean bodies [-], 0 to 1, else
     * KSTRIP_ERROR_SLOPE_FACTOR; 0 stands for 1, clean.
     */
    double slope_factor;
    /**
     * Stretch of the creep curve far in sliding divided by that at its start [-], 0 to 1, else
     * KSTRIP_ERROR_SLIDE_FACTOR; 0 stands for 1: the whole curve is stretched alike.
     */
    double slide_factor;
    /**
     * Thickness of an elastic layer between the bodies divided by its shear modulus [m/Pa],
     * >= 0, else KSTRIP_ERROR_LAYER; 0: none.
     */
    double layer;
} kstrip_friction;

/** Derivatives of fx, fy, mz with respect to creepages, load and friction. */
typedef struct kstrip_derivatives {
    /**
     * With respect to longitudinal, lateral, spin, row by row [N, N, N m per 1, 1, 1/m]; at
     * kinks of a model a one-sided value.
     */
    double jacobian[3][3];
    /** With respect to the normal force at fixed a and b [-, -, m]. */
    double normal_force[3];
    /**
     * With respect to the normal force while a and b grow with its cube root, as in Hertz's theory
     * [-, -, m].
     */
    double load_through_hertz[3];
    /** With respect to the coefficient of friction (of the law, if given) [N, N, N m]. */
    double friction[3];
} kstrip_derivatives;

/** Derivatives of fx, fy, mz with respect to the parameters of falling friction. */
typedef struct kstrip_law_derivatives {
    /** With respect to the ratio [N, N, N m]. */
    double ratio[3];
    /** With respect to the decay [N, N, N m per s/m]. */
    double decay[3];
    /** With respect to the rolling speed of the law at constant creepages [N, N, N m per m/s]. */
    double rolling_speed[3];
    /** With respect to the factor of the initial slope, at 1 without a law [N, N, N m]. */
    double slope_factor[3];
    /** With respect to the slide factor [N, N, N m]; 0 where it is 0 in a law without a layer. */
    double slide_factor[3];
    /** With respect to the layer [N, N, N m per m/Pa]; 0 where there is none. */
    double layer[3];
} kstrip_law_derivatives;

/** One strip y = const of a contact or a patch, and the forces that it carries on the lower body. */
typedef struct kstrip_strip {
    /** Centre line [m]. */
    double y;
    /** Width of the strip [m]. */
    double width;
    /** Half of its length along x [m]. */
    double half_length;
    /**
     * x of the separatrix [m], with slip behind it and adhesion ahead of it; the leading edge if
     * the whole strip slides.
     */
    double separatrix;
    /** Its share of the longitudinal force [N]. */
    double fx;
    /** Its share of the lateral force [N]. */
    double fy;
    /** Its share of the moment about the centre of the contact [N m]. */
    double mz;
    /** Its share of the frictional power [N]. */
    double power;
    /** KSTRIP_STATE_STICK if it has an adhesion area, else KSTRIP_STATE_SLIP. */
    int32_t state;
    /** Reserved: zero. */
    int32_t reserved;
} kstrip_strip;

/**
 * Where the outputs of kstrip_evaluate() and kstrip_patch_evaluate() go. An output that is NULL is
 * not computed and costs nothing.
 */
typedef struct kstrip_outputs {
    /** Forces, moment, power, adhesion: those of kstrip_solve() if friction is constant. */
    struct kstrip_result *result;
    /**
     * Derivatives with respect to creepages, load and friction. Under falling friction they
     * include the change of friction.
     */
    struct kstrip_derivatives *derivatives;
    /** Derivatives with respect to the parameters of falling friction. */
    struct kstrip_law_derivatives *law_derivatives;
    /**
     * The coefficient of friction that agrees with the slip; the contact's own where friction is
     * constant. For a patch it is the factor that multiplies the friction of all strips, 1 where
     * friction is constant.
     */
    double *friction;
    /** The forces of each strip (capacity elements); they add up to the result of the model. */
    struct kstrip_strip *strips;
    /** Number of strips that were written; required with strips. */
    uint32_t *count;
    /**
     * Size of the array strips: at least the strip count of the options; for a patch, at least its
     * number of strips. KSTRIP_STRIPS_CAPACITY is always enough.
     */
    uint32_t capacity;
    /** Reserved: zero. */
    uint32_t reserved;
} kstrip_outputs;

/**
 * Computes, for a contact in motion, every output that is not NULL.
 *
 * If friction is given, the coefficient of friction falls with the slip and agrees with it; the
 * contact's own coefficient is ignored. All derivatives include that dependence. If more than one
 * coefficient agrees with its slip, the result has the largest. The two models of 1967 may miss
 * it under steeply falling friction, because their forces jump, or nearly jump, when a first
 * strip begins to adhere. With KSTRIP_MODEL_DEFAULT strips are those of KSTRIP_MODEL_STRIP.
 *
 * @param contact, creepage, options  as in kstrip_solve().
 * @param friction        falling friction; NULL: constant.
 * @param outputs         where the outputs go.
 * @return as kstrip_solve(); statuses of kstrip_friction; KSTRIP_WARNING_SEVERAL_FRICTIONS (more
 *         than one coefficient agrees with its slip); KSTRIP_WARNING_NOT_CONVERGED (the search for
 *         the coefficient ended early); KSTRIP_ERROR_CAPACITY (outputs->capacity is below the
 *         strip count); KSTRIP_ERROR_NOT_IN_MODEL (strips of KSTRIP_MODEL_TOTAL or
 *         KSTRIP_MODEL_LINEAR).
 */
kstrip_status kstrip_evaluate(const struct kstrip_contact *contact,
                              const struct kstrip_creepage *creepage,
                              const struct kstrip_friction *friction,
                              const struct kstrip_options *options,
                              const struct kstrip_outputs *outputs);

/**
 * Many contacts with their motion and their friction: for each quantity a pointer to the first one
 * and the distance to the next in bytes, its stride. An input with stride 0 is the same for all
 * contacts.
 *
 * Arrays of structures (&contacts[0].a, sizeof(kstrip_contact)) and one array for each quantity
 * (a, sizeof(double)) are both possible. All members but mismatch and law are required, unless
 * there are no contacts.
 */
typedef struct kstrip_batch_inputs {
    /** Semi-axes along x [m]. */
    const double *a;
    /**
     * Stride [bytes]: distance from one semi-axis to the next. The other strides are those of the
     * inputs before them.
     */
    ptrdiff_t a_stride;
    /** Semi-axes along y [m]. */
    const double *b;
    /** Stride [bytes]. */
    ptrdiff_t b_stride;
    /** Normal forces [N]; a contact whose force is not positive is lost. */
    const double *normal_force;
    /** Stride [bytes]. */
    ptrdiff_t normal_force_stride;
    /** Combined shear moduli G [Pa]. */
    const double *shear_modulus;
    /** Stride [bytes]. */
    ptrdiff_t shear_modulus_stride;
    /** Combined Poisson's ratios [-]. */
    const double *poisson_ratio;
    /** Stride [bytes]. */
    ptrdiff_t poisson_ratio_stride;
    /** Coefficients of friction [-]. */
    const double *friction;
    /** Stride [bytes]. */
    ptrdiff_t friction_stride;
    /** Mismatches of the materials [-]; NULL: like materials. */
    const double *mismatch;
    /** Stride [bytes]. */
    ptrdiff_t mismatch_stride;
    /** Longitudinal creepages [-]. */
    const double *longitudinal;
    /** Stride [bytes]. */
    ptrdiff_t longitudinal_stride;
    /** Lateral creepages [-]. */
    const double *lateral;
    /** Stride [bytes]. */
    ptrdiff_t lateral_stride;
    /** Spins [1/m]. */
    const double *spin;
    /** Stride [bytes]. */
    ptrdiff_t spin_stride;
    /** Falling friction; NULL: constant. */
    const struct kstrip_friction *law;
    /** Stride [bytes]. */
    ptrdiff_t law_stride;
} kstrip_batch_inputs;

/**
 * Where the results of many contacts go: for each quantity a pointer to the first one and the
 * distance to the next in bytes. An output that is NULL is not computed and costs nothing.
 */
typedef struct kstrip_batch_outputs {
    /** Longitudinal forces on the lower bodies [N]. */
    double *fx;
    /**
     * Stride [bytes]: distance from one force to the next, forward or backward. With more than one
     * contact a stride is at least the size of its output.
     */
    ptrdiff_t fx_stride;
    /** Lateral forces [N]. */
    double *fy;
    /** Stride [bytes]. */
    ptrdiff_t fy_stride;
    /** Moments about z at the centres of the contacts [N m]. */
    double *mz;
    /** Stride [bytes]. */
    ptrdiff_t mz_stride;
    /** Frictional powers divided by rolling speed [N]. */
    double *power;
    /** Stride [bytes]. */
    ptrdiff_t power_stride;
    /** Shares of the contact areas in adhesion [-], 0 to 1, or -1 for unknown. */
    double *adhesion;
    /** Stride [bytes]. */
    ptrdiff_t adhesion_stride;
    /** The status of each result: 0 or one of the KSTRIP_WARNING constants. */
    int32_t *status_detail;
    /** Stride [bytes]. */
    ptrdiff_t status_detail_stride;
    /** Coefficients of friction that agree with the slip [-]. */
    double *friction;
    /** Stride [bytes]. */
    ptrdiff_t friction_stride;
    /** Derivatives with respect to creepages, load and friction. */
    struct kstrip_derivatives *derivatives;
    /** Stride [bytes]. */
    ptrdiff_t derivatives_stride;
    /** Derivatives with respect to the parameters of falling friction. */
    struct kstrip_law_derivatives *law_derivatives;
    /** Stride [bytes]. */
    ptrdiff_t law_derivatives_stride;
} kstrip_batch_outputs;

/**
 * kstrip_evaluate() for many contacts: the same results, bit for bit.
 *
 * On processors with AVX several contacts are solved in parallel. All inputs are checked before
 * anything is written: if one is bad its status is returned, no output is touched, and first_bad
 * receives its index. A lost contact is not bad: its results are zero.
 *
 * With more than one contact an output's stride is at least the size of the output, forward or
 * backward. Every stride is a multiple of the alignment of its type.
 *
 * @param inputs          contacts, creepages, falling friction.
 * @param count           how many; 0 is allowed.
 * @param options         for all contacts; NULL for the defaults.
 * @param outputs         where the outputs go; they must not overlap the inputs or each other.
 * @param[out] first_bad  receives the index of the first bad contact, or count where none is bad;
 *                        NULL: not needed.
 * @return as kstrip_evaluate(): the error of the first bad contact, or the most serious warning;
 *         KSTRIP_ERROR_STRIDE (a stride is no multiple of the alignment, or that of an output is
 *         smaller than the output).
 */
kstrip_status kstrip_evaluate_batch(const struct kstrip_batch_inputs *inputs,
                                    uint32_t count,
                                    const struct kstrip_options *options,
                                    const struct kstrip_batch_outputs *outputs,
                                    uint32_t *first_bad);

/**
 * A contact for which kstrip_prepare() has computed everything that does not depend on the motion.
 * The structure holds plain numbers and no pointers, so it may be copied and kept, for this
 * version of the library only. It begins with a mark: a structure that was never prepared, or was
 * prepared in the other precision, gives KSTRIP_ERROR_NOT_PREPARED.
 */
typedef struct kstrip_prepared {
    /** For use by the library only. */
    double numbers[96];
    /** The model; 0: nothing prepared. */
    int32_t model;
    /** The strip count. */
    int32_t strips;
} kstrip_prepared;

/**
 * Prepares a contact with its options for kstrip_solve_prepared().
 *
 * Use this for rigs whose contact is constant, and for iterations on the creepage.
 *
 * @param contact, options  as in kstrip_solve().
 * @param[out] prepared   receives the prepared contact.
 * @return usual statuses; errors of kstrip_contact and kstrip_options.
 */
kstrip_status kstrip_prepare(const struct kstrip_contact *contact,
                             const struct kstrip_options *options,
                             struct kstrip_prepared *prepared);

/**
 * kstrip_solve() for a prepared contact: the same result, bit for bit.
 *
 * @param prepared        by kstrip_prepare().
 * @param creepage        motion.
 * @param[out] result     receives forces, moment, power and adhesion.
 * @return as kstrip_solve(); KSTRIP_ERROR_NOT_PREPARED (prepared is not from kstrip_prepare() of
 *         this precision).
 */
kstrip_status kstrip_solve_prepared(const struct kstrip_prepared *prepared,
                                    const struct kstrip_creepage *creepage,
                                    struct kstrip_result *result);

/**
 * Motion of the upper body relative to the lower one at the contact, in axes that stay when the
 * motion reverses.
 */
typedef struct kstrip_motion {
    /** Velocity of the upper relative to the lower body along x [m/s]. */
    double slip_x;
    /** Velocity of the upper relative to the lower body along y [m/s]. */
    double slip_y;
    /** Angular velocity of the upper relative to the lower body about z [rad/s]. */
    double spin_rate;
    /** Rolling speed [m/s]: positive along x, negative backward, zero at standstill. */
    double rolling_speed;
    /**
     * Floor of the speed [m/s], >= 0, else KSTRIP_ERROR_FLOOR_SPEED; 0 stands for 0.02.
     * Creepages are slip divided by sqrt(rolling_speed^2 + floor_speed^2).
     */
    double floor_speed;
} kstrip_motion;

/** Derivatives of fx, fy, mz with respect to motion, load and friction. */
typedef struct kstrip_motion_derivatives {
    /** With respect to slip_x, slip_y, spin_rate, row by row [N, N, N m per m/s, m/s, rad/s]. */
    double slip[3][3];
    /** With respect to the rolling speed at constant slip and spin rate [N, N, N m per m/s]. */
    double rolling_speed[3];
    /** With respect to the normal force at fixed a and b [-, -, m]. */
    double normal_force[3];
    /** With respect to the normal force while a and b grow with its cube root [-, -, m]. */
    double load_through_hertz[3];
    /** With respect to the coefficient of friction (of the law, if given) [N, N, N m]. */
    double friction[3];
    /** With respect to the ratio of the law; 0 without one [N, N, N m]. */
    double ratio[3];
    /** With respect to the decay of the law; 0 without one [N, N, N m per s/m]. */
    double decay[3];
    /** With respect to the slope factor of the law, at 1 without one [N, N, N m]. */
    double slope_factor[3];
    /** With respect to the slide factor; 0 if it is 0 in a law without a layer [N, N, N m]. */
    double slide_factor[3];
    /** With respect to the layer of the law; 0 where there is none [N, N, N m per m/Pa]. */
    double layer[3];
} kstrip_motion_derivatives;

/**
 * Where the outputs of kstrip_solve_motion() go. An output that is NULL is not computed and costs
 * nothing.
 */
typedef struct kstrip_motion_outputs {
    /**
     * Forces and moment on the lower body, and adhesion. The power is in watts here: fx slip_x +
     * fy slip_y + mz spin_rate.
     */
    struct kstrip_result *result;
    /** Derivatives with respect to motion, load and friction. */
    struct kstrip_motion_derivatives *derivatives;
    /** The coefficient of friction that agrees with the slip. */
    double *friction;
} kstrip_motion_outputs;

/**
 * Forces of a contact that rolls forward, backward, or not at all, with derivatives with respect
 * to its motion: for wheels that stop, hold and reverse.
 *
 * The creepages are slip divided by sqrt(rolling_speed^2 + floor_speed^2). Far from standstill the
 * leading edge of the patch lies ahead, in the direction of the motion. Near standstill the
 * results of both directions are blended, so that forces and derivatives are continuous. Friction
 * opposes the slip at every speed. The axis x keeps its direction when the motion reverses.
 *
 * @param contact, options  as in kstrip_solve().
 * @param motion          slip, spin rate, signed rolling speed.
 * @param friction        falling friction; NULL: constant. Its rolling_speed is ignored.
 * @param outputs         where the outputs go.
 * @return usual statuses; statuses of kstrip_contact, kstrip_motion, kstrip_friction and
 *         kstrip_options; warnings of kstrip_creepage (above 1 m/s);
 *         KSTRIP_WARNING_SEVERAL_FRICTIONS and KSTRIP_WARNING_NOT_CONVERGED, as in
 *         kstrip_evaluate().
 */
kstrip_status kstrip_solve_motion(const struct kstrip_contact *contact,
                                  const struct kstrip_motion *motion,
                                  const struct kstrip_friction *friction,
                                  const struct kstrip_options *options,
                                  const struct kstrip_motion_outputs *outputs);

/**
 * kstrip_solve() with KSTRIP_MODEL_TOTAL; a program that calls only this links no other model.
 *
 * @param contact, creepage  as in kstrip_solve().
 * @param[out] result     receives forces, moment and power on the lower body.
 * @return usual statuses; statuses of kstrip_contact and kstrip_creepage;
 *         KSTRIP_WARNING_AXIS_RATIO (a/b is outside 0.015 to 60).
 */
kstrip_status kstrip_solve_total(const struct kstrip_contact *contact,
                                 const struct kstrip_creepage *creepage,
                                 struct kstrip_result *result);

/**
 * kstrip_solve() with KSTRIP_MODEL_STRIP; a program that calls only this links no other model.
 *
 * @param contact, creepage  as in kstrip_solve().
 * @param strips          4, 8, 16, 32 or 64; 0: 16.
 * @param[out] result     receives forces, moment, power and adhesion.
 * @return as kstrip_solve_total(); KSTRIP_WARNING_RANGE (|psi| is above 3);
 *         KSTRIP_ERROR_STRIP_COUNT (strips is another number).
 */
kstrip_status kstrip_solve_strip(const struct kstrip_contact *contact,
                                 const struct kstrip_creepage *creepage,
                                 int32_t strips,
                                 struct kstrip_result *result);

/**
 * kstrip_solve() with KSTRIP_MODEL_STRIP_1967; a program that calls only this links no other
 * model.
 *
 * @param contact, creepage  as in kstrip_solve().
 * @param strips          4, 8, 16, 32 or 64; 0: 16.
 * @param[out] result     receives forces, moment, power and adhesion.
 * @return usual statuses; statuses of kstrip_contact and kstrip_creepage; KSTRIP_WARNING_SPIN
 *         (|psi| is 1 or more); KSTRIP_WARNING_MISMATCH_NEGLECTED (the mismatch is not 0);
 *         KSTRIP_ERROR_STRIP_COUNT (strips is another number).
 */
kstrip_status kstrip_solve_strip_1967(const struct kstrip_contact *contact,
                                      const struct kstrip_creepage *creepage,
                                      int32_t strips,
                                      struct kstrip_result *result);

/**
 * kstrip_solve() with KSTRIP_MODEL_LINEAR; a program that calls only this links no other model.
 *
 * @param contact, creepage  as in kstrip_solve().
 * @param[out] result     receives forces, moment and power on the lower body.
 * @return usual statuses; statuses of kstrip_contact and kstrip_creepage;
 *         KSTRIP_WARNING_BEYOND_FRICTION (the force exceeds mu N).
 */
kstrip_status kstrip_solve_linear(const struct kstrip_contact *contact,
                                  const struct kstrip_creepage *creepage,
                                  struct kstrip_result *result);

/** @} */

/**
 * @defgroup kstrip_inside Inside the contact: pressure, traction, slip
 * @{
 */

/** The state of a point of the contact plane. Tractions act on the lower body. */
typedef struct kstrip_point {
    /** Pressure [Pa]. */
    double pressure;
    /** Tangential traction along x [Pa]. */
    double traction_x;
    /** Tangential traction along y [Pa]. */
    double traction_y;
    /** Slip of the upper relative to the lower body along x, divided by the rolling speed [-]. */
    double slip_x;
    /** Slip along y, divided by the rolling speed [-]. */
    double slip_y;
    /** Traction times slip [Pa]: energy dissipated per area and metre rolled. */
    double dissipation;
    /** One of the KSTRIP_STATE constants. */
    int32_t state;
    /** Reserved: zero. */
    int32_t reserved;
} kstrip_point;

/**
 * Pressure, traction, slip and state over a grid; one point is a grid of one. Integrals of
 * traction and dissipation are near the forces and the power of kstrip_evaluate().
 *
 * @param contact, creepage, friction  as in kstrip_evaluate().
 * @param options         a model with strips; NULL and KSTRIP_MODEL_DEFAULT: KSTRIP_MODEL_STRIP.
 * @param x, columns      array of x [m] from the centre of the ellipse, and its size; outside is
 *                        allowed.
 * @param y, rows         array of y [m] and its size.
 * @param[out] points     array of rows * columns elements; the point (x[i], y[j]) is
 *                        points[j * columns + i].
 * @param capacity        size of points, at least rows * columns.
 * @return as kstrip_evaluate(); KSTRIP_ERROR_CAPACITY (capacity is below rows * columns);
 *         KSTRIP_ERROR_NOT_IN_MODEL (KSTRIP_MODEL_TOTAL and KSTRIP_MODEL_LINEAR have no field).
 */
kstrip_status kstrip_field(const struct kstrip_contact *contact,
                           const struct kstrip_creepage *creepage,
                           const struct kstrip_friction *friction,
                           const struct kstrip_options *options,
                           const double *x,
                           uint32_t columns,
                           const double *y,
                           uint32_t rows,
                           struct kstrip_point *points,
                           uint32_t capacity);

/** @} */

/**
 * @defgroup kstrip_patch Patches of any shape
 * @{
 */

/** Maximum number of strips in a kstrip_patch. */
#define KSTRIP_PATCH_CAPACITY 64

/**
 * The undeformed distance of two bodies across the rolling direction, at points in ascending y.
 * The points are smoothed over the length that kstrip_profile_contact gives.
 */
typedef struct kstrip_profile {
    /** Places y [m], ascending, else KSTRIP_ERROR_PROFILE. */
    const double *y;
    /**
     * Distance of the bodies there [m], the least along x. A constant added to all distances
     * changes nothing.
     */
    const double *distance;
    /**
     * Place along x [m] where the distance is least; bodies that yaw touch ahead on one side and
     * behind on the other. NULL: at 0.
     */
    const double *centre_x;
    /**
     * Rolling radius [m] of each point, > 0, else KSTRIP_ERROR_ROLLING_RADIUS; it replaces that of
     * the contact. NULL: the contact's own.
     */
    const double *rolling_radius;
    /** Number of points, at least 2, else KSTRIP_ERROR_PROFILE. */
    uint32_t points;
    /** Reserved: zero. */
    uint32_t reserved;
} kstrip_profile;

/**
 * Load or approach, material and friction of two profiles that are pressed together. Zero is the
 * default of every member but rolling_radius, shear_modulus and one of normal_force and approach.
 */
typedef struct kstrip_profile_contact {
    /**
     * Rolling radius [m], > 0, else KSTRIP_ERROR_ROLLING_RADIUS; of two rolling bodies 1/R =
     * 1/R_lower + 1/R_upper. It is ignored where the profile has its own radii.
     */
    double rolling_radius;
    /** Normal force N [N], >= 0, else KSTRIP_ERROR_NORMAL_FORCE; 0: approach decides. */
    double normal_force;
    /** Approach of distant points of the bodies [m], >= 0; only where normal_force is 0. */
    double approach;
    /**
     * Length over which the profile is smoothed [m], >= 0, else KSTRIP_ERROR_SMOOTHING_LENGTH. 0
     * stands for half the width of the contact, at most 2 mm. The length is always at least 2.5
     * steps of the profile. For rough profiles set it to 4 mm.
     */
    double smoothing_length;
    /** Combined shear modulus G [Pa], > 0, else KSTRIP_ERROR_MODULUS. */
    double shear_modulus;
    /** Combined Poisson's ratio [-], 0 to 0.5, else KSTRIP_ERROR_POISSON_RATIO. */
    double poisson_ratio;
    /** Coefficient of friction of every strip [-], >= 0, else KSTRIP_ERROR_FRICTION. */
    double friction;
    /**
     * About how many strips all zones have together: 4, 8, 16, 32 or 64, of which 40 are given,
     * on a microcontroller 16; 0: 16;
     * else KSTRIP_ERROR_STRIP_COUNT.
     */
    int32_t strips;
    /** Reserved: zero. */
    int32_t reserved;
} kstrip_profile_contact;

/**
 * One strip of a patch, along the rolling direction. Its pressure is a half-ellipse in x,
 * peak_pressure sqrt(1 - (x - centre_x)^2/half_length^2), and does not vary over its width.
 */
typedef struct kstrip_patch_strip {
    /** Centre line y [m]. */
    double y;
    /** Width [m], > 0, else KSTRIP_ERROR_STRIP_SIZE. */
    double width;
    /** Half length along x [m], > 0, else KSTRIP_ERROR_STRIP_SIZE. */
    double half_length;
    /** Centre along x [m]; 0 for most contacts. */
    double centre_x;
    /** Pressure at the centre [Pa], >= 0, else KSTRIP_ERROR_PRESSURE. */
    double peak_pressure;
    /** Coefficient of friction [-] of this strip, >= 0, else KSTRIP_ERROR_FRICTION. */
    double friction;
} kstrip_patch_strip;

/**
 * A contact patch of any shape: its strips, in ascending y. Filled by kstrip_patch_from_contact(),
 * kstrip_patch_from_strips() or kstrip_patch_from_profile(); the members may then be changed. All
 * functions check it again. A patch whose members are all zero, except shear_modulus, carries no
 * load.
 *
 * If the distance of two neighbours is more than one and a half times the distance at which they
 * touch, there is a gap, and the strips on either side are separate contact regions (lobes).
 */
typedef struct kstrip_patch {
    /**
     * The strips; the first count are used. KSTRIP_ERROR_STRIP_ORDER if their y do not ascend, or
     * if they overlap by more than half of the distance at which they touch.
     */
    struct kstrip_patch_strip strips[KSTRIP_PATCH_CAPACITY];
    /** Combined shear modulus G [Pa], > 0, else KSTRIP_ERROR_MODULUS. */
    double shear_modulus;
    /** Combined Poisson's ratio [-], 0 to 0.5, else KSTRIP_ERROR_POISSON_RATIO. */
    double poisson_ratio;
    /**
     * Factor [-], > 0, else KSTRIP_ERROR_NOT_FINITE, that makes the sum of the strips' areas the
     * patch's area: 1 unless the strips are the quadrature rule of kstrip_patch_from_contact(); 0
     * stands for 1. KSTRIP_ERROR_OVERFLOW if it is outside 1e-6 to 1e6.
     */
    double area_scale;
    /** The same for the moment of the area about x, the sum of y^2 times area. */
    double lever_scale;
    /** Number of strips, 0 to KSTRIP_PATCH_CAPACITY, else KSTRIP_ERROR_PATCH_SIZE. None: no load. */
    uint32_t count;
    /** Reserved: zero. */
    uint32_t reserved;
    /**
     * Mismatch kappa [-] of the two materials, as in kstrip_contact: KSTRIP_WARNING_MISMATCH if
     * its size is above 0.25. Only kstrip_patch_from_contact() sets it; the caller may set it.
     */
    double mismatch;
} kstrip_patch;

/** Approach, load and pressure of two profiles in contact. */
typedef struct kstrip_profile_result {
    /**
     * Approach of distant points of the two bodies [m] from where they touch: at the lowest
     * point of the smoothed profile.
     */
    double approach;
    /** Normal force of the strips [N]. If a load is given, it is that load to rounding. */
    double normal_force;
    /** Derivative of the normal force with respect to the approach [N/m]. */
    double stiffness;
    /** Largest pressure of a strip [Pa]. */
    double peak_pressure;
    /** y of the strip with the largest pressure [m]. */
    double peak_y;
    /**
     * Sum of the steps of the two searches for the approach, at most 60 for each search. It is 0
     * if the approach is given.
     */
    uint32_t iterations;
    /**
     * The status of this result: 0, or KSTRIP_WARNING_PROFILE_END if a contact region ends
     * with the profile.
     */
    kstrip_status status_detail;
    /**
     * Distance at that lowest point [m], or of the given points without contact: the bodies have
     * moved by approach + lowest.
     */
    double lowest;
} kstrip_profile_result;

/**
 * The patch of two profiles under a load, or at an approach.
 *
 * Contact regions begin with zero width, grow and merge. The results are continuous in distances
 * and approach, and in the load unless it falls with the approach (rough profiles). The stiffness
 * is the derivative of the computed load. The approach is measured from the lowest point of the
 * smoothed profile: it has a kink when another point becomes the lowest.
 *
 * @param profile         undeformed distance of the bodies at points in ascending y.
 * @param contact         rolling radius, load or approach, material, friction, number of strips.
 * @param[out] patch      receives the patch.
 * @param[out] result     receives approach, peak pressure and load; NULL: not needed.
 * @return usual statuses; statuses of kstrip_profile and kstrip_profile_contact;
 *         KSTRIP_WARNING_PROFILE_END (a contact region ends with the profile);
 *         KSTRIP_WARNING_ROUGH (a contact has more local minima than its strips resolve).
 */
kstrip_status kstrip_patch_from_profile(const struct kstrip_profile *profile,
                                        const struct kstrip_profile_contact *contact,
                                        struct kstrip_patch *patch,
                                        struct kstrip_profile_result *result);

/**
 * A patch from strips of any origin, in any order of y.
 *
 * Strips may overlap by up to half of the distance at which they touch (a quadrature rule does),
 * not by more. Strips that do not ascend are sorted in a copy on the stack (3 KiB; 2 KiB in single
 * precision).
 *
 * @param strips, count   the strips, at most KSTRIP_PATCH_CAPACITY; 0 is allowed.
 * @param shear_modulus   combined shear modulus G [Pa], > 0.
 * @param poisson_ratio   combined Poisson's ratio [-], 0 to 0.5.
 * @param[out] patch      receives the patch.
 * @return usual statuses; statuses of kstrip_patch_strip; KSTRIP_ERROR_MODULUS (shear_modulus <=
 *         0); KSTRIP_ERROR_POISSON_RATIO (outside 0 to 0.5); KSTRIP_ERROR_STRIP_ORDER (strips
 *         overlap by more than that); KSTRIP_ERROR_PATCH_SIZE (count is above
 *         KSTRIP_PATCH_CAPACITY).
 */
kstrip_status kstrip_patch_from_strips(const struct kstrip_patch_strip *strips,
                                       uint32_t count,
                                       double shear_modulus,
                                       double poisson_ratio,
                                       struct kstrip_patch *patch);

/**
 * The strips of a contact's ellipse, at the places of KSTRIP_MODEL_STRIP. A lost contact has no
 * strips.
 *
 * With KSTRIP_MODEL_STRIP and eight strips or more kstrip_patch_evaluate() has the result of
 * kstrip_solve() to rounding. For the models of 1967 the difference is less than the force of one
 * strip.
 *
 * @param contact         the loaded contact.
 * @param options         strip count; its model is checked and otherwise ignored. NULL for the
 *                        defaults.
 * @param[out] patch      receives the patch.
 * @return usual statuses; errors of kstrip_contact and kstrip_options.
 */
kstrip_status kstrip_patch_from_contact(const struct kstrip_contact *contact,
                                        const struct kstrip_options *options,
                                        struct kstrip_patch *patch);

/** Load, friction bound and area of a patch. */
typedef struct kstrip_patch_summary {
    /** Normal force [N]. */
    double normal_force;
    /** Sum of friction times load over the strips [N]: no tangential force exceeds it. */
    double friction_bound;
    /** Contact area [m^2]. */
    double area;
    /** Number of contact regions. */
    uint32_t lobes;
    /** Reserved: zero. */
    uint32_t reserved;
} kstrip_patch_summary;

/**
 * Load, friction bound, area and contact regions of a patch; checks it without solving.
 *
 * @param patch           the patch.
 * @param[out] summary    receives the sums.
 * @return usual statuses; statuses of kstrip_patch.
 */
kstrip_status kstrip_patch_summarize(const struct kstrip_patch *patch,
                                     struct kstrip_patch_summary *summary);

/**
 * Computes, for a patch in motion, every output that is not NULL. Forces act on the lower body.
 *
 * The creepage is that at the origin of the patch's coordinates, x = y = 0; the creepages of a
 * strip are (longitudinal - spin y, lateral + spin centre_x), and moments are about the origin.
 * |F| is at most the sum of friction times load over the strips. With KSTRIP_MODEL_STRIP the
 * flexibilities of a strip are those of an equivalent ellipse, fitted to the contact region that
 * contains the strip, or larger if the strip is long for its pressure. KSTRIP_MODEL_TOTAL adds the
 * forces of these ellipses. It is cheap and smooth, and has no strips and no share in adhesion.
 *
 * The forces of KSTRIP_MODEL_STRIP and KSTRIP_MODEL_TOTAL are continuous in the widths and places
 * of strips that have one width or are narrower. That of KSTRIP_MODEL_STRIP_1967 jumps by up to
 * the force of one strip if a strip with spin stops adhering; that of
 * KSTRIP_MODEL_STRIP_1967_CONTINUOUS has a kink there.
 *
 * For the derivatives with respect to load, all pressures grow by one factor; through Hertz, all
 * lengths grow with the load's cube root as well. The derivatives with respect to friction are
 * those with respect to the mean coefficient. If friction is given, the factor (1 - ratio)
 * exp(-decay w) + ratio multiplies the coefficients of all strips, and the law's own coefficient
 * is ignored. outputs->strips receives patch->count strips.
 *
 * @param patch           the patch.
 * @param creepage        motion at the origin.
 * @param friction        falling friction; NULL: constant.
 * @param options         KSTRIP_MODEL_STRIP (the default here), KSTRIP_MODEL_TOTAL or one of the
 *                        models of 1967; NULL for the default. The strip count is checked and
 *                        otherwise ignored.
 * @param outputs         where the outputs go.
 * @return usual statuses; statuses of kstrip_patch, kstrip_friction and kstrip_options;
 *         KSTRIP_WARNING_SEVERAL_FRICTIONS and KSTRIP_WARNING_NOT_CONVERGED, as in
 *         kstrip_evaluate(); KSTRIP_ERROR_CAPACITY (outputs->capacity is below patch->count);
 *         KSTRIP_ERROR_NOT_IN_MODEL for KSTRIP_MODEL_LINEAR (the linear theory of a patch is its
 *         derivatives at zero creepage) and for the strips of KSTRIP_MODEL_TOTAL.
 */
kstrip_status kstrip_patch_evaluate(const struct kstrip_patch *patch,
                                    const struct kstrip_creepage *creepage,
                                    const struct kstrip_friction *friction,
                                    const struct kstrip_options *options,
                                    const struct kstrip_outputs *outputs);

/**
 * kstrip_patch_evaluate() with creepages of each strip, as on curved surfaces: own is added to the
 * creepages that the motion has at the strip's centre. Derivatives are with respect to the motion.
 *
 * @param patch, creepage, friction, options, outputs  as in kstrip_patch_evaluate().
 * @param own             array of patch->count creepages, one for each strip; NULL: all zero.
 * @return as kstrip_patch_evaluate(); KSTRIP_ERROR_NOT_IN_MODEL also for KSTRIP_MODEL_TOTAL.
 */
kstrip_status kstrip_patch_evaluate_strips(const struct kstrip_patch *patch,
                                           const struct kstrip_creepage *creepage,
                                           const struct kstrip_creepage *own,
                                           const struct kstrip_friction *friction,
                                           const struct kstrip_options *options,
                                           const struct kstrip_outputs *outputs);

/**
 * Pressure, traction, slip and state of a patch over a grid. They do not vary over the width of a
 * strip.
 *
 * The tractions add up to the forces of kstrip_patch_evaluate(), and the dissipation to its power,
 * as those of kstrip_field() do.
 *
 * @param patch, creepage, friction  as in kstrip_patch_evaluate().
 * @param options         as in kstrip_patch_evaluate(), but not KSTRIP_MODEL_TOTAL; NULL for the
 *                        default.
 * @param x, columns      array of x [m] and its size; places outside of the patch are allowed.
 * @param y, rows         array of y [m] and its size.
 * @param[out] points     array of rows * columns elements; the point (x[i], y[j]) is
 *                        points[j * columns + i].
 * @param capacity        size of points, at least rows * columns.
 * @return as kstrip_patch_evaluate(); KSTRIP_ERROR_CAPACITY (capacity is below rows * columns);
 *         KSTRIP_ERROR_NOT_IN_MODEL also for KSTRIP_MODEL_TOTAL.
 */
kstrip_status kstrip_patch_field(const struct kstrip_patch *patch,
                                 const struct kstrip_creepage *creepage,
                                 const struct kstrip_friction *friction,
                                 const struct kstrip_options *options,
                                 const double *x,
                                 uint32_t columns,
                                 const double *y,
                                 uint32_t rows,
                                 struct kstrip_point *points,
                                 uint32_t capacity);

/** @} */

/**
 * @defgroup kstrip_wheel_rail Wheel on rail: from two profiles to the forces on the wheel
 * @{
 */

/** Maximum number of points in a prepared profile or a gap. */
#define KSTRIP_SURFACE_CAPACITY 512

/**
 * Largest number of contacts of one wheel: four separate ones, and two that merge neighbours less
 * than 7 mm apart.
 */
#define KSTRIP_CONTACTS_CAPACITY 6

/** Largest number of places along the rail at which friction is given. */
#define KSTRIP_RAIL_FRICTION_CAPACITY 4

/** Format of a profile file: found from its beginning. */
#define KSTRIP_FORMAT_ANY 0
/** Format of a profile file: SIMPACK and CONTACT (.prw, .prr). */
#define KSTRIP_FORMAT_SIMPACK 1
/** Format of a profile file: MiniProf (.whl, .ban, .mpt). */
#define KSTRIP_FORMAT_MINIPROF 2
/** Format of a profile file: columns of numbers, text or CSV. */
#define KSTRIP_FORMAT_COLUMNS 3
/** May be added to a format: the file has the profile of a wheel. */
#define KSTRIP_FORMAT_WHEEL 16
/** May be added to a format: the file has the profile of a rail. */
#define KSTRIP_FORMAT_RAIL 32
/** May be added to a format: z points down, whatever the shape. */
#define KSTRIP_FORMAT_Z_DOWN 64
/** May be added to a format: the flange or the gauge side is at small y, whatever the shape. */
#define KSTRIP_FORMAT_SIDE 128

/** Note on a profile file: it is the profile of a wheel; without this note of a rail. */
#define KSTRIP_NOTE_WHEEL 1
/** Note on a profile file: the file has SIMPACK's format. */
#define KSTRIP_NOTE_SIMPACK 2
/** Note on a profile file: the file has MiniProf's format. */
#define KSTRIP_NOTE_MINIPROF 4
/** Note on a profile file: z pointed up and is turned. */
#define KSTRIP_NOTE_Z_TURNED 8
/** Note on a profile file: the flange or the gauge side was at large y, and y is mirrored. */
#define KSTRIP_NOTE_Y_MIRRORED 16
/** Note on a profile file: the points ran toward smaller y and are reversed. */
#define KSTRIP_NOTE_REVERSED 32
/** Note on a profile file: y and z of a wheel are moved from its flange back to its running circle. */
#define KSTRIP_NOTE_RUNNING_CIRCLE 64
/** Note on a profile file: shift, turn or mirrors of its header are applied. */
#define KSTRIP_NOTE_HEADER 128
/** Note on a profile file: lines or points are left out, such as marked or coincident ones. */
#define KSTRIP_NOTE_LEFT_OUT 256
/** Note on a profile file: a smoothing or weights of its header are not used. */
#define KSTRIP_NOTE_IGNORED 512
/** Note on a profile file: its header has another number of points. */
#define KSTRIP_NOTE_COUNT 1024
/** Note on a profile file: the unit is that of the width of the points. */
#define KSTRIP_NOTE_UNIT_OF_WIDTH 2048
/** Doubt about a profile file: it may be another kind, or header and shape differ. */
#define KSTRIP_NOTE_DOUBT_KIND 4096
/** Doubt about a profile file: z may point up by the shape, or is turned against its format. */
#define KSTRIP_NOTE_DOUBT_Z 8192
/** Doubt about a profile file: the side is against its format, or a rail has several heads. */
#define KSTRIP_NOTE_DOUBT_SIDE 16384
/** Doubt about a profile file: the unit is taken as inches or mm, by the size of the points. */
#define KSTRIP_NOTE_DOUBT_UNIT 32768
/** Doubt about a profile file: y = 0 of a wheel is not its running circle. */
#define KSTRIP_NOTE_DOUBT_ORIGIN 65536
/** Doubt about a profile file: no line follows the points, or the first of several is read. */
#define KSTRIP_NOTE_DOUBT_POINTS 131072
/** Note on a profile file: its shape has no side, without a flange or of a symmetric head. */
#define KSTRIP_NOTE_SYMMETRIC 262144

/**
 * Reads the profile of a wheel or a rail from the text of a file, in metres and the right way
 * round: points toward larger y, z down, the flange or the gauge side at small y.
 *
 * Formats: SIMPACK and CONTACT (.prw, .prr), MiniProf (.whl, .ban, .mpt), and columns of numbers
 * with or without names. The convention of SIMPACK's format decides which way its points stand.
 * For the other formats, or if the requested kind is not that of the header, the shape of the
 * tread or of the head decides. The wheel of a MiniProf file is moved from its flange back to its
 * running circle. docs/reference/profile-files.md has the rules. The text is read several times,
 * without a copy.
 *
 * @param text, length    the text of the file and its number of bytes. It need not end with 0.
 * @param format          KSTRIP_FORMAT_ANY or another one of these constants; the kind may be
 *                        added, KSTRIP_FORMAT_WHEEL or KSTRIP_FORMAT_RAIL, and directions that
 *                        are known, KSTRIP_FORMAT_Z_DOWN and KSTRIP_FORMAT_SIDE.
 * @param[out] y, z       arrays of capacity elements; receive the points [m].
 * @param capacity        number of elements of y and of z.
 * @param[out] count      receives the number of points.
 * @param[out] notes      receives findings and changes, a sum of KSTRIP_NOTE_; NULL: not needed.
 * @return KSTRIP_OK; KSTRIP_WARNING_PROFILE_GUESS (a note is a doubt: check notes);
 *         KSTRIP_ERROR_NULL (text, y, z or count); KSTRIP_ERROR_FILE_FORMAT (format is no sum of
 *         these constants); KSTRIP_ERROR_FILE_LINE (a line is no point, keyword or title of the
 *         format); KSTRIP_ERROR_FILE_COLUMNS (more than two columns, and no names);
 *         KSTRIP_ERROR_FILE_COUNT (fewer points than the header promises); KSTRIP_ERROR_FILE_UNITS
 *         (a unit is not positive, or the numbers are too large for millimetres);
 *         KSTRIP_ERROR_FILE_MISSING (a number is far from all others); KSTRIP_ERROR_NOT_FINITE (a
 *         number is infinite, NaN or immense); KSTRIP_ERROR_PROFILE (fewer than four points);
 *         KSTRIP_ERROR_CAPACITY (more points than capacity); KSTRIP_ERROR_SCATTER (the points are
 *         a closed outline).
 */
kstrip_status kstrip_read_profile(const char *text,
                                  uint32_t length,
                                  uint32_t format,
                                  double *y,
                                  double *z,
                                  uint32_t capacity,
                                  uint32_t *count,
                                  uint32_t *notes);

/**
 * Turns profiles the right way round by their shape: points toward larger y, z down, the flange or
 * the gauge side at small y. kstrip_read_profile() includes this. Kind, unit and directions are
 * decided once for all profiles. docs/reference/profile-files.md has the rules.
 *
 * @param y, z            the points of all profiles, one profile after the other.
 * @param counts, profile_count  number of the points of each profile, at least four; of profiles.
 * @param format          a sum of KSTRIP_FORMAT_ constants: the convention of the points.
 * @param unit            metres per unit of y and z; 0: size and shape decide.
 * @param[out] turned_y, turned_z  receive the points [m]; not y and z themselves.
 * @param[out] taken_unit, notes  receive the unit, and a sum of KSTRIP_NOTE_; NULL: not needed.
 * @return KSTRIP_OK; KSTRIP_WARNING_PROFILE_GUESS (a note is a doubt: check notes);
 *         KSTRIP_ERROR_NULL (a required array); KSTRIP_ERROR_CAPACITY (2^32 points or more);
 *         KSTRIP_ERROR_PROFILE (no profile, or fewer than four points in one);
 *         KSTRIP_ERROR_NOT_FINITE (a number is infinite, NaN or immense); KSTRIP_ERROR_FILE_FORMAT
 *         (format is no sum of the constants); KSTRIP_ERROR_FILE_UNITS (unit < 0, or 0 and the
 *         numbers are too large for millimetres).
 */
kstrip_status kstrip_orient_profiles(const double *y,
                                     const double *z,
                                     const uint32_t *counts,
                                     uint32_t profile_count,
                                     uint32_t format,
                                     double unit,
                                     double *turned_y,
                                     double *turned_z,
                                     double *taken_unit,
                                     uint32_t *notes);

/**
 * A profile, prepared by kstrip_prepare_profile(): points at equal steps of its length, toward
 * larger y, and its direction. It holds plain numbers and may be copied.
 */
typedef struct kstrip_surface {
    /**
     * y [m], to the right: of a rail from its origin, of a wheel from its running circle, with
     * the flange at small y.
     */
    double y[KSTRIP_SURFACE_CAPACITY];
    /** z [m], down; of a wheel its radius minus wheel_radius. */
    double z[KSTRIP_SURFACE_CAPACITY];
    /** Derivative of y with respect to the length: the cosine of the profile's angle. */
    double cosine[KSTRIP_SURFACE_CAPACITY];
    /** Derivative of z with respect to the length: the sine of the profile's angle. */
    double sine[KSTRIP_SURFACE_CAPACITY];
    /** Length between two points [m]. */
    double step;
    /** Mean distance between the points that were given [m]. */
    double spacing;
    /** Number of points, 4 to KSTRIP_SURFACE_CAPACITY. */
    uint32_t count;
    /**
     * The form of the profile: 0, or a sum of 1 (it is not that of a wheel), 2 (it is not that of
     * a rail), 4 (it has few points, and is not smooth between them), 8 (it has the tip of a
     * flange) and 16 (it goes down on both sides as the head of a rail).
     */
    uint32_t form;
} kstrip_surface;

/**
 * Prepares a profile of a rail or a wheel from its points. Do this once for each profile.
 *
 * The points are in their order along the profile. They may run either way along y, turn back (as
 * those of a measured flange do), lie at any distances, coincide, be scanned twice and scatter:
 * parts of the profile that are scanned again, single points in the wrong order, and points nearer
 * to each other than their scatter are averaged. Single strays, one of 128 points, are left out.
 * The flange of a wheel and the gauge side of a rail are at small y (profiles of a right wheel),
 * and z points down. The prepared points are one step apart.
 *
 * @param y, z, points    the points [m], at least 4. Those of a rail are measured from its origin,
 *                        those of a wheel from its running circle; the z of a wheel is its radius
 *                        minus wheel_radius.
 * @param step            length between prepared points [m]; 0: the length of the profile divided
 *                        by the capacity less one.
 * @param smoothing_length  each point is replaced by that of a parabola fitted to the points up to
 *                        this distance [m], >= 0: at least four point spacings, 2 to 4 mm for
 *                        measured profiles; below two spacings it has no effect. 0: a profile of
 *                        many points, or of smooth ones as in drawings, goes through all of them,
 *                        and one of fewer, rough points is smoothed over at most six spacings.
 * @param[out] surface    receives the profile.
 * @return usual statuses, KSTRIP_ERROR_OVERFLOW if the profile is smaller than 1 um or a
 *         coordinate is above 1 km; KSTRIP_WARNING_ORIENTATION (the shape stands upside down or
 *         the wrong way round); KSTRIP_WARNING_PROFILE_SIZE (longer than 1 m);
 *         KSTRIP_ERROR_PROFILE (fewer than four points, or step < 0);
 *         KSTRIP_ERROR_SMOOTHING_LENGTH (smoothing_length < 0); KSTRIP_ERROR_CAPACITY (the step
 *         needs too many points); KSTRIP_ERROR_SCATTER (no line follows the points).
 */
kstrip_status kstrip_prepare_profile(const double *y,
                                     const double *z,
                                     uint32_t points,
                                     double step,
                                     double smoothing_length,
                                     struct kstrip_surface *surface);

/**
 * The prepared profile at a place between two slices of a surface. The surface varies along the
 * track, as at a switch or a crossing, or around a wheel. It is continuous in the share.
 *
 * Points at the same share of the length of both profiles belong together: their coordinates are
 * interpolated, and the result is prepared. Both slices must begin and end at the same features,
 * and be near enough to each other that the features between them move in proportion. The slope of
 * the surface along the track is not a part of the result: wheels touch the profile at the place
 * as if it were that of a straight rail, and a rail that rises by 1 in 100 moves the contact ahead
 * by a hundredth of the radius of the wheel.
 *
 * @param first, second   prepared profiles of the slices before and after the place.
 * @param share           0 at the place of the first to 1 at that of the second.
 * @param[out] between    receives the profile; it may be one of the slices.
 * @return as kstrip_prepare_profile() for the points between the slices; KSTRIP_ERROR_NOT_PREPARED
 *         (first or second); KSTRIP_ERROR_SLICE_SHARE (share is outside 0 to 1).
 */
kstrip_status kstrip_profile_between(const struct kstrip_surface *first,
                                     const struct kstrip_surface *second,
                                     double share,
                                     struct kstrip_surface *between);

/**
 * Position of the wheel on straight track. The flange of a right wheel touches the gauge side of
 * the rail, which is at small y.
 */
typedef struct kstrip_wheel_position {
    /**
     * y of the wheel's centre from the origin of the rail's profile [m], to the right. The
     * centre is the point of the axle at y = 0 of the wheel's profile.
     */
    double lateral;
    /** Zero when the centre is one wheel radius above the rail's origin; positive downward [m]. */
    double vertical;
    /**
     * Turn about the vertical, which points down [rad]: positive from x to y, between -1 and 1,
     * else KSTRIP_ERROR_ANGLE.
     */
    double yaw;
    /**
     * Turn about x [rad]: positive from y to z, between -1 and 1, else KSTRIP_ERROR_ANGLE. Yaw
     * turns about the axis that roll has turned.
     */
    double roll;
} kstrip_wheel_position;

/**
 * The gap between a wheel and a rail, point by point along the rail. A host with its own search of
 * contact fills it. The first count elements of each member are used.
 */
typedef struct kstrip_gap {
    /**
     * Length on the rail's surface from any origin [m], ascending, else KSTRIP_ERROR_PROFILE. A
     * host that works in a plane passes its coordinate in this plane.
     */
    double along[KSTRIP_SURFACE_CAPACITY];
    /** Undeformed gap along the rail's normal [m]; negative where the surfaces overlap. */
    double distance[KSTRIP_SURFACE_CAPACITY];
    /**
     * x of the point on the wheel's undeformed surface from the wheel's centre, axes of the track
     * [m]: 0 without yaw.
     */
    double x[KSTRIP_SURFACE_CAPACITY];
    /** y of this point [m]. */
    double y[KSTRIP_SURFACE_CAPACITY];
    /** z of this point [m], about the wheel's radius. */
    double z[KSTRIP_SURFACE_CAPACITY];
    /**
     * Angle of the tangent across x, mean of both surfaces [rad], positive from y to z; about
     * -1.2 at the flange of a right wheel. Its size is below 2.3, else KSTRIP_ERROR_PROFILE.
     */
    double angle[KSTRIP_SURFACE_CAPACITY];
    /**
     * Radius of curvature of the wheel along x [m], > 0, else KSTRIP_ERROR_ROLLING_RADIUS. It is
     * R0 = r/cos a without yaw: distance from the axle divided by the cosine of the angle between
     * normal and radius. A wheel that yaws has
     * R0/(1 + (sin yaw/cos a)^2 (k R0 - 1)), with the curvature k of its profile; this is R0 (1 -
     * dx/ds tan(yaw)/cos a) where x changes by dx/ds along the line of these points. Over a
     * roller the curvatures of both add up, and angle and distance are those in the plane through
     * the roller's axis and the point.
     */
    double rolling_radius[KSTRIP_SURFACE_CAPACITY];
    /**
     * Point spacing of the wheel [m], >= 0, else KSTRIP_ERROR_SMOOTHING_LENGTH: the gap is
     * smoothed over at least 2.5 of it. 0: the spacing of the gap's points near the contact.
     */
    double step;
    /** Number of points, at most KSTRIP_SURFACE_CAPACITY, else KSTRIP_ERROR_CAPACITY. */
    uint32_t count;
    /** Reserved: zero. */
    uint32_t reserved;
} kstrip_gap;

/**
 * The gap between a wheel and a straight rail: the line on the wheel along which its normal is
 * perpendicular to x, and its distance from the rail.
 *
 * @param rail, wheel     prepared profiles.
 * @param wheel_radius    radius of the wheel at z = 0 of its profile [m], > 0.
 * @param position        where the right wheel is. For a left wheel pass lateral, yaw and roll
 *                        with the opposite signs.
 * @param reach           distance from the rail above which points are left out [m]; 0: 2 mm.
 *                        For kstrip_contacts_from_gap() it must be at least 3 d + min(1 mm,
 *                        sqrt(s^2 + 6.25 d^2)/2), or 2 mm if that is less, with the step d of the
 *                        wheel and smoothing_length s: nearer points enter the smoothing.
 * @param[out] gap        receives the points.
 * @param[out] least      receives their least distance [m]: negative where the surfaces overlap,
 *                        and reach where no point is nearer; NULL: not needed.
 * @return usual statuses; statuses of kstrip_wheel_position; KSTRIP_ERROR_NOT_PREPARED (rail or
 *         wheel); KSTRIP_ERROR_ROLLING_RADIUS (wheel_radius <= 0); KSTRIP_ERROR_PROFILE_END (the
 *         wheel is beside the rail) or its likely cause: KSTRIP_ERROR_ANGLE (yaw or roll is above
 *         0.2 in size), KSTRIP_ERROR_LENGTH_UNIT (the wheel is 0.7 m beside the rail, or 5 m above
 *         or below it; wheel_radius is above 5 m, or a profile is longer than 1 m),
 *         KSTRIP_ERROR_SWAPPED (rail has a flange, and wheel the head of a rail),
 *         KSTRIP_ERROR_ORIENTATION (a profile is not that of a rail or a wheel).
 */
kstrip_status kstrip_touch(const struct kstrip_surface *rail,
                           const struct kstrip_surface *wheel,
                           double wheel_radius,
                           const struct kstrip_wheel_position *position,
                           double reach,
                           struct kstrip_gap *gap,
                           double *least);

/**
 * Materials and friction of a wheel and a rail, and options of the computation. Zero is the
 * default of every member but wheel_radius and shear_modulus.
 */
typedef struct kstrip_wheel_pair {
    /** Radius of the wheel at z = 0 of its profile [m], > 0, else KSTRIP_ERROR_ROLLING_RADIUS. */
    double wheel_radius;
    /** Combined shear modulus G [Pa], > 0, else KSTRIP_ERROR_MODULUS. */
    double shear_modulus;
    /** Combined Poisson's ratio [-], 0 to 0.5, else KSTRIP_ERROR_POISSON_RATIO. */
    double poisson_ratio;
    /** Coefficient of friction [-], >= 0, else KSTRIP_ERROR_FRICTION; if friction_points is 0. */
    double friction;
    /** Places on the rail, y of its profile [m], ascending, else KSTRIP_ERROR_PROFILE. */
    double friction_y[KSTRIP_RAIL_FRICTION_CAPACITY];
    /** Coefficients there [-], as friction; linear between the places, constant beyond. */
    double friction_at[KSTRIP_RAIL_FRICTION_CAPACITY];
    /**
     * How many of these places there are, at most KSTRIP_RAIL_FRICTION_CAPACITY, else
     * KSTRIP_ERROR_CAPACITY; 0: friction is the same everywhere.
     */
    uint32_t friction_points;
    /**
     * 0: a right wheel; any other number: a left wheel. The profiles are always those of a right
     * wheel; position, velocity and wrench are the wheel's own.
     */
    int32_t left;
    /**
     * Length over which the undeformed gap is smoothed [m], >= 0, else
     * KSTRIP_ERROR_SMOOTHING_LENGTH. It is always at least 2.5 steps of the wheel's profile. For
     * rough profiles set it to 2 mm.
     */
    double smoothing_length;
    /** Strips of a contact, about: 4, 8, 16, 32 or 64, else KSTRIP_ERROR_STRIP_COUNT; 0: 16. */
    int32_t strips;
    /** KSTRIP_MODEL_STRIP (the default here), KSTRIP_MODEL_TOTAL or one of the models of 1967. */
    int32_t model;
    /**
     * Damping d [s/m], >= 0, else KSTRIP_ERROR_NORMAL_DAMPING (Hunt and Crossley): the pressure
     * is multiplied by 1 + d times the velocity at which the surfaces approach each other, or by 0
     * if this factor is negative; the bound of friction changes with it.
     */
    double normal_damping;
    /**
     * Floor of the speed [m/s], as in kstrip_motion; 0 stands for 0.02, and a negative one is
     * KSTRIP_ERROR_FLOOR_SPEED.
     */
    double floor_speed;
    /**
     * Radius of the rail at z = 0 of its profile [m], >= 0, else KSTRIP_ERROR_ROLLING_RADIUS: of
     * a roller rig or of the lower of two discs, whose axis is along y; 0: a straight rail.
     */
    double rail_radius;
    /** x of the roller's axis from the wheel's centre [m]; not used for a straight rail. */
    double rail_ahead;
    /**
     * Speed at which the surface of the rail moves backward under the wheel [m/s], that of a
     * roller at rail_radius: a wheel whose centre is at rest rolls on it like a wheel that moves
     * forward on a rail at rest.
     */
    double rail_speed;
} kstrip_wheel_pair;

/** One contact of a wheel. Its frame (x, t, n): forward, across the surface, into the rail. */
typedef struct kstrip_wheel_contact {
    /**
     * Point where the pressure acts, on the wheel's undeformed surface, from the wheel's centre
     * [m], axes of the track.
     */
    double origin[3];
    /**
     * Angle of the contact plane [rad]: mean of the strips' angles, weighted with load. For a
     * left wheel it is that of the mirrored right wheel.
     */
    double angle;
    /** Range of the angle over the patch [rad]; above 0.52 KSTRIP_WARNING_ANGLE_RANGE. */
    double angle_range;
    /** Distance of the origin from the axle [m]. */
    double radius;
    /** Load of the strips [N], >= 0, else KSTRIP_ERROR_NORMAL_FORCE. */
    double normal_force;
    /**
     * Factor of load and forces in the sum over the contacts [-], >= 0, else KSTRIP_ERROR_SHARE:
     * 1, except for contacts 5 to 7 mm apart, whose result blends separate contacts with a merged
     * one.
     */
    double share;
    /** Overlap of the undeformed, smoothed surfaces where it is deepest [m]. */
    double approach;
    /**
     * Derivative of the load with respect to the distance by which the surfaces are moved into
     * each other [N/m].
     */
    double stiffness;
    /** Length on the rail at y = 0 of the patch [m]. */
    double along;
    /**
     * Derivatives of the wheel's velocity into the rail, mean of the strips weighted with load,
     * with respect to the members of kstrip_wheel_velocity. The wrench of the pressure on the
     * wheel is minus share times normal_force times these six numbers, and times the factor of
     * the damping.
     */
    double normal[6];
    /**
     * slip_x of kstrip_motion at the patch's origin: derivatives with respect to the members of
     * kstrip_wheel_velocity.
     */
    double slip_x[6];
    /** slip_y of kstrip_motion. */
    double slip_y[6];
    /** spin_rate of kstrip_motion. */
    double spin_rate[6];
    /** rolling_speed of kstrip_motion. */
    double rolling_speed[6];
    /** normal_damping of kstrip_wheel_pair; a negative one is KSTRIP_ERROR_NORMAL_DAMPING. */
    double normal_damping;
    /**
     * kstrip_motion of a wheel at rest: that of the rail's surface, mean of the strips weighted
     * with load, with the floor of the speed; a negative floor is KSTRIP_ERROR_FLOOR_SPEED.
     */
    struct kstrip_motion at_rest;
    /** The strips; y along the rail's surface, x forward from the origin. */
    struct kstrip_patch patch;
    /** x and z of a roller's axis from the wheel's centre [m]; 0 and 0 for a straight rail. */
    double rail_axis[2];
    /** Rate of a roller about its axis [rad/s]: rail_speed/rail_radius; 0: a straight rail. */
    double rail_rate;
    /**
     * Speed of the rail's surface at each strip, backward [m/s]: rail_speed; on a roller
     * rail_rate times the radius of the roller's undeformed surface there.
     */
    double strip_rail_speed[KSTRIP_PATCH_CAPACITY];
    /**
     * y of each strip on the wheel's undeformed surface, from the wheel's centre [m], axes of
     * the track; of a left wheel that of the mirrored right wheel.
     */
    double strip_y[KSTRIP_PATCH_CAPACITY];
    /** z of each strip [m]. */
    double strip_z[KSTRIP_PATCH_CAPACITY];
    /**
     * Angle of each strip [rad], as the angle of the contact: the mean of those of both
     * undeformed surfaces.
     */
    double strip_angle[KSTRIP_PATCH_CAPACITY];
    /**
     * Tangent of half the angle between the undeformed surfaces at each strip: the angle of the
     * wheel's is less than strip_angle by the arc tangent of this, that of the rail's is more.
     */
    double strip_lean[KSTRIP_PATCH_CAPACITY];
    /** Roll and yaw of the wheel [rad]; of a left wheel those of the mirrored right wheel. */
    double turned[2];
    /** Whether the wheel is a left one, as in kstrip_wheel_pair. */
    int32_t left;
    /** Reserved: zero. */
    int32_t reserved;
} kstrip_wheel_contact;

/**
 * The contacts of a gap, in ascending y of a right wheel.
 *
 * Overlaps less than 5 mm apart are one contact and one normal problem; overlaps more than 7 mm
 * apart are separate contacts. Between these distances the result blends the separate contacts
 * with the merged one; share has the weights. Of more than four contacts the nearest are merged,
 * with KSTRIP_WARNING_ROUGH.
 *
 * @param gap             the gap between the surfaces, from kstrip_touch() or a host's own search.
 * @param pair            materials, friction, side.
 * @param position        where the wheel is.
 * @param workspace       memory for the strips of a contact; it may hold anything.
 * @param[out] contacts   array of KSTRIP_CONTACTS_CAPACITY elements; receives the contacts. It is
 *                        memory of the computation too: after an error it may have changed.
 * @param[out] count      receives their number; 0: the wheel is lifted.
 * @return usual statuses; statuses of kstrip_gap, kstrip_wheel_pair and kstrip_wheel_position;
 *         KSTRIP_WARNING_ANGLE_RANGE (the normal turns by more than 30 degrees over a contact);
 *         KSTRIP_WARNING_ROUGH (also a contact with more local minima than its strips resolve);
 *         KSTRIP_ERROR_PROFILE_END (a contact reaches an end of the gap); KSTRIP_ERROR_PATCH_SIZE
 *         (more contacts than fit).
 */
kstrip_status kstrip_contacts_from_gap(const struct kstrip_gap *gap,
                                       const struct kstrip_wheel_pair *pair,
                                       const struct kstrip_wheel_position *position,
                                       struct kstrip_patch *workspace,
                                       struct kstrip_wheel_contact *contacts,
                                       uint32_t *count);

/**
 * Velocity of the wheel relative to the rail. The axes are at rest; in a curve they are those of
 * the momentary track. Lateral, roll and yaw have the track's signs for a left wheel too.
 */
typedef struct kstrip_wheel_velocity {
    /** Velocity of the wheel's centre along x [m/s]. */
    double forward;
    /** Velocity of the centre along y [m/s]. */
    double lateral;
    /** Velocity of the centre along z, down [m/s]. */
    double vertical;
    /** Rate about the wheelset's own x [rad/s]; these axes do not spin with the axle. */
    double roll;
    /** Rate about the axle [rad/s]: about minus forward divided by radius. */
    double pitch;
    /** Rate about the wheelset's own z [rad/s]. */
    double yaw;
} kstrip_wheel_velocity;

/**
 * Motion of the wheel relative to the rail at a contact: slip, spin rate and rolling speed. They
 * are the input of kstrip_solve_motion(). Slip and spin rate divided by the rolling speed are the
 * creepages of kstrip_patch_evaluate(). The motion is linear in the velocity.
 *
 * @param contact         a contact.
 * @param velocity        how the wheel moves.
 * @param[out] motion     receives the motion, that of a roller included.
 * @return usual statuses.
 */
kstrip_status kstrip_wheel_motion(const struct kstrip_wheel_contact *contact,
                                  const struct kstrip_wheel_velocity *velocity,
                                  struct kstrip_motion *motion);

/**
 * Force and moment on a wheel. They are conjugate to the members of kstrip_wheel_velocity: the
 * products add up to power.
 */
typedef struct kstrip_wrench {
    /**
     * Force on the wheel, axes of the track [N]: forward, lateral, vertical (down; the rail's
     * support is negative).
     */
    double force[3];
    /**
     * Moment on the wheel about its centre [N m] about the wheelset's own axes: roll, pitch
     * (about the axle), yaw.
     */
    double moment[3];
    /**
     * Frictional power [W], not negative: creep forces on the rail times slip. The power of the
     * creep forces on the wheel is minus this. Only in contacts with a mismatch of the materials
     * it differs, because pressure adds to the slip.
     */
    double dissipation;
    /**
     * Sum of the loads of all contacts [N], each along its own normal: share times normal_force
     * of kstrip_wheel_contact, times the factor of the damping.
     */
    double normal_force;
    /**
     * Number of contacts, those that kstrip_wheel_workspace lists; of a wheelset those of both
     * wheels. 0: the wheel is lifted, and nothing acts.
     */
    uint32_t contacts;
    /** The status of this result: 0 or one of the KSTRIP_WARNING constants. */
    kstrip_status status_detail;
} kstrip_wrench;

/** Exact derivatives of the wrench. The rows are the members of force and moment. */
typedef struct kstrip_wrench_derivatives {
    /** With respect to the members of kstrip_wheel_velocity [N, N m per m/s, rad/s]. */
    double velocity[6][6];
    /** With respect to a factor on all coefficients of friction, at 1 [N, N m]. */
    double friction[6];
} kstrip_wrench_derivatives;

/**
 * Force and moment on the wheel from its contacts. The contacts may come from
 * kstrip_contacts_from_gap() or from a table.
 *
 * The wheel may roll forward or backward, or stand still, as in kstrip_solve_motion(): forces are
 * continuous through rest. They are continuous where damping reduces the pressure to zero, and
 * have a kink there.
 *
 * @param contacts, count  the contacts, at most KSTRIP_CONTACTS_CAPACITY; a wheel without contacts
 *                         is lifted, and its forces are zero.
 * @param velocity        how the wheel moves.
 * @param model           KSTRIP_MODEL_STRIP (the default here), KSTRIP_MODEL_TOTAL or one of the
 *                        models of 1967.
 * @param friction        falling friction (not its friction and rolling_speed); NULL: constant.
 * @param[out] wrench     receives force and moment.
 * @param[out] derivatives  receives their derivatives with respect to velocity and friction; NULL:
 *                          not needed.
 * @return usual statuses; statuses of kstrip_wheel_contact and kstrip_friction; warnings of
 *         kstrip_options; KSTRIP_WARNING_DAMPING (it more than doubles the pressure);
 *         KSTRIP_WARNING_SEVERAL_FRICTIONS and KSTRIP_WARNING_NOT_CONVERGED, as in
 *         kstrip_evaluate(); KSTRIP_ERROR_PATCH_SIZE (too many contacts or strips);
 *         KSTRIP_ERROR_MODEL (model is another number); KSTRIP_ERROR_NOT_IN_MODEL
 *         (KSTRIP_MODEL_LINEAR); KSTRIP_ERROR_MODEL_LEFT_OUT (this build has no such model).
 */
kstrip_status kstrip_wrench_from_contacts(const struct kstrip_wheel_contact *contacts,
                                          uint32_t count,
                                          const struct kstrip_wheel_velocity *velocity,
                                          int32_t model,
                                          const struct kstrip_friction *friction,
                                          struct kstrip_wrench *wrench,
                                          struct kstrip_wrench_derivatives *derivatives);

/** One strip of a contact of a wheel: its load, and the power that friction dissipates in it. */
typedef struct kstrip_strip_power {
    /** y on the wheel's profile [m], in the axes of the profile. */
    double wheel_y;
    /** Width along the surface [m]. */
    double width;
    /** Load [N], with the share of the contact and the factor of the damping. */
    double normal_force;
    /** Longitudinal force on the rail [N], with the share of the contact. */
    double fx;
    /**
     * Force on the rail along its surface across the rolling direction [N], with the share of
     * the contact; of a left wheel that of the mirrored right wheel.
     */
    double fy;
    /**
     * Mean sliding velocity [m/s]: power divided by the coefficient of friction and the load,
     * and below zero together with it.
     */
    double slip;
    /**
     * Frictional power [W], with the share of the contact. That of a strip that hardly slides
     * may be a little below zero: -0.06 % of the power of the wheel if it rolls, -0.4 % if it
     * stands.
     */
    double power;
} kstrip_strip_power;

/**
 * Load, sliding velocity and frictional power of each strip of a contact, to compute wear.
 *
 * Add the strips of all contacts at their wheel_y; y on the rail is that of the position plus
 * strip_y of the contact. The powers add up to the dissipation of kstrip_wrench_from_contacts()
 * with the model KSTRIP_MODEL_STRIP, and the loads to its normal_force.
 *
 * @param contact         a contact.
 * @param velocity        how the wheel moves.
 * @param model, friction  as in kstrip_wrench_from_contacts(). KSTRIP_MODEL_TOTAL has no strips:
 *                        KSTRIP_MODEL_STRIP takes its place.
 * @param[out] strips     array of capacity elements, at least contact->patch.count, for which
 *                        KSTRIP_PATCH_CAPACITY is always enough.
 * @param capacity        size of strips.
 * @param[out] count      receives the number of strips.
 * @return as kstrip_wrench_from_contacts(); KSTRIP_ERROR_CAPACITY (capacity is below
 *         contact->patch.count).
 */
kstrip_status kstrip_contact_power_across(const struct kstrip_wheel_contact *contact,
                                          const struct kstrip_wheel_velocity *velocity,
                                          int32_t model,
                                          const struct kstrip_friction *friction,
                                          struct kstrip_strip_power *strips,
                                          uint32_t capacity,
                                          uint32_t *count);

/**
 * Caller-provided memory for the computation of one wheel. It may hold anything before a call.
 * After KSTRIP_OK or a warning it holds the gap and the contacts of the position; after an error
 * its contents have no meaning.
 */
typedef struct kstrip_wheel_workspace {
    /** The gap between the surfaces. */
    struct kstrip_gap gap;
    /** Memory in which the normal problem of a contact is solved. */
    struct kstrip_patch strips;
    /** The contacts, in ascending y of a right wheel; the first count are used. */
    struct kstrip_wheel_contact contacts[KSTRIP_CONTACTS_CAPACITY];
    /** Number of contacts. */
    uint32_t count;
    /** Reserved: zero. */
    uint32_t reserved;
} kstrip_wheel_workspace;

/** Derivatives of the wrench with respect to the wheel's position at constant velocity. */
typedef struct kstrip_wrench_by_position {
    /** With respect to the lateral position [N, N m per m]. */
    double lateral[6];
    /** With respect to the vertical position [N, N m per m]. */
    double vertical[6];
    /** With respect to yaw [N, N m per rad]. */
    double yaw[6];
    /** With respect to roll [N, N m per rad]. */
    double roll[6];
} kstrip_wrench_by_position;

/**
 * Force and moment on a wheel on a rail in one call: kstrip_touch(), kstrip_contacts_from_gap(),
 * kstrip_wrench_from_contacts().
 *
 * In a curve, pass the velocity relative to the momentary track, which is at rest; on a roller
 * that of the wheel's centre in the axes of the rig. Force and moment are continuous in position
 * and velocity, but where normals of a rail cross below the wheel: on a rough rail, and where the
 * bodies overlap by more than 3 mm on a flange. A contact appears and vanishes with zero load, and
 * two become one between 7 and 5 mm. Forces may also jump with KSTRIP_WARNING_ROUGH. The time is
 * bounded.
 *
 * @param rail, wheel     prepared profiles.
 * @param pair            materials, friction, side, number of strips, model.
 * @param position        where the wheel is.
 * @param velocity        how it moves.
 * @param friction        falling friction (not its friction and rolling_speed); NULL: constant.
 * @param workspace       memory that may hold anything; receives gap and contacts.
 * @param[out] wrench     receives force and moment.
 * @param[out] derivatives  receives their exact derivatives with respect to velocity and friction;
 *                          NULL: not needed.
 * @param[out] by_position  receives their derivatives with respect to position: exact but for one
 *                        difference of creep forces, one-sided at kinks; for a roller central
 *                        differences. NULL: not needed.
 * @return as kstrip_touch(), kstrip_contacts_from_gap() and kstrip_wrench_from_contacts().
 *         KSTRIP_ERROR_MODULUS_UNIT is a likely cause too (shear_modulus below 0.1 MPa). Warnings
 *         about implausible inputs: KSTRIP_WARNING_ORIENTATION (a profile is not that of a rail or
 *         a wheel, or a contact is above 30 degrees), KSTRIP_WARNING_PROFILE_SIZE (a profile is
 *         longer than 1 m), KSTRIP_WARNING_RADIUS (wheel_radius is above 5 m),
 *         KSTRIP_WARNING_MODULUS (below 0.1 MPa or above 10 TPa), KSTRIP_WARNING_YOUNG (above 150
 *         GPa), KSTRIP_WARNING_FRICTION (above 5), KSTRIP_WARNING_UNSET (friction and
 *         poisson_ratio are 0), KSTRIP_WARNING_PRESSURE (above a tenth of shear_modulus).
 *         KSTRIP_WARNING_PROFILE_COARSE: a contact is narrower than four point spacings.
 */
kstrip_status kstrip_wheel_on_rail(const struct kstrip_surface *rail,
                                   const struct kstrip_surface *wheel,
                                   const struct kstrip_wheel_pair *pair,
                                   const struct kstrip_wheel_position *position,
                                   const struct kstrip_wheel_velocity *velocity,
                                   const struct kstrip_friction *friction,
                                   struct kstrip_wheel_workspace *workspace,
                                   struct kstrip_wrench *wrench,
                                   struct kstrip_wrench_derivatives *derivatives,
                                   struct kstrip_wrench_by_position *by_position);

/**
 * A finished contact table, from which a function takes the contacts of wheels
 * (kstrip_table_finish()). All zero: no table.
 */
typedef struct kstrip_table {
    /** The bytes of the table, at any address, else KSTRIP_ERROR_TABLE. */
    const uint8_t *data;
    /** Their number, or a larger one; else KSTRIP_ERROR_TABLE. */
    uint32_t bytes;
    /**
     * 0: outside the table the contacts are computed from the profiles, and at its ends force and
     * moment jump by its error. Any other number: KSTRIP_ERROR_TABLE_RANGE outside.
     */
    int32_t only;
} kstrip_table;

/**
 * kstrip_wheel_on_rail() for many wheels with the same profiles: the same results, bit for bit.
 * Several threads may each compute a part, with a workspace of their own.
 *
 * Pairs, positions, velocities and friction are arrays, in which the next element is a stride
 * away; with a stride of 0 all wheels have the same one. A wheel without a result does not stop
 * the others; its status has the reason, and its other outputs are untouched.
 *
 * @param rail, wheel, workspace  as in kstrip_wheel_on_rail(), one for all wheels.
 * @param count           number of wheels; 0 is allowed.
 * @param pairs, pair_stride  kstrip_wheel_pair of each, and the distance from one to the next
 *                            [bytes]: 0 or another multiple of the alignment. The other strides
 *                            have the same rule.
 * @param positions, position_stride  position of each wheel, and its stride [bytes].
 * @param velocities, velocity_stride  velocity of each wheel, and its stride [bytes].
 * @param friction, friction_stride  as in kstrip_wheel_on_rail(), with its stride [bytes]; NULL:
 *                            constant.
 * @param table           a contact table of all pairs, whose results are those of
 *                        kstrip_wheel_on_table(); NULL: contacts are computed.
 * @param[out] wrenches   array of count elements; receives force and moment, and with them the
 *                        number of contacts.
 * @param[out] derivatives, by_position  arrays of count elements, as in kstrip_wheel_on_rail();
 *                        NULL: not needed.
 * @param[out] contacts   array of count times room elements; receives the first room contacts of
 *                        each wheel, their unused strips zero; NULL: not needed. A wheel of fewer
 *                        contacts leaves the rest untouched. Those of wheel i begin at i room.
 * @param room            contacts of each wheel for which there is room, at most
 *                        KSTRIP_CONTACTS_CAPACITY.
 * @param[out] statuses   array of count elements; receives those of kstrip_wheel_on_rail();
 *                        NULL: not needed.
 * @return as kstrip_wheel_on_rail(), with a table as kstrip_wheel_on_table() too: the first error
 *         of a wheel, or the most serious warning; before any wheel KSTRIP_ERROR_NULL (a required
 *         array), KSTRIP_ERROR_STRIDE (no multiple of the alignment), KSTRIP_ERROR_CAPACITY (room
 *         is above KSTRIP_CONTACTS_CAPACITY).
 */
kstrip_status kstrip_wheels_on_rails(const struct kstrip_surface *rail,
                                     const struct kstrip_surface *wheel,
                                     uint32_t count,
                                     const struct kstrip_wheel_pair *pairs,
                                     uint32_t pair_stride,
                                     const struct kstrip_wheel_position *positions,
                                     uint32_t position_stride,
                                     const struct kstrip_wheel_velocity *velocities,
                                     uint32_t velocity_stride,
                                     const struct kstrip_friction *friction,
                                     uint32_t friction_stride,
                                     const struct kstrip_table *table,
                                     struct kstrip_wheel_workspace *workspace,
                                     struct kstrip_wrench *wrenches,
                                     struct kstrip_wrench_derivatives *derivatives,
                                     struct kstrip_wrench_by_position *by_position,
                                     struct kstrip_wheel_contact *contacts,
                                     uint32_t room,
                                     kstrip_status *statuses);

/**
 * The vertical position at which the rail supports a wheel with a given force, to rounding. Use it
 * to begin a run, and for tables. Of several positions it is the highest.
 *
 * @param rail, wheel, pair  as in kstrip_wheel_on_rail().
 * @param position        where the wheel is; its vertical member is where the search begins.
 * @param support         requested upward force of the rail on the wheel [N], > 0.
 * @param velocity        how the wheel moves; its creep forces carry a part of the load. NULL: the
 *                        pressure carries all of it.
 * @param friction        as in kstrip_wheel_on_rail(); NULL: constant.
 * @param table           a contact table of the pair; NULL: contacts are computed.
 * @param workspace       memory that may hold anything; receives gap and contacts.
 * @param[out] vertical   receives the vertical position [m].
 * @return as kstrip_wheel_on_rail(); KSTRIP_WARNING_NOT_CONVERGED (no height carries the load to
 *         rounding); KSTRIP_WARNING_SUPPORT (no ordinary contact supports the wheel at this
 *         height); KSTRIP_ERROR_SUPPORT (support <= 0); with a table those of
 *         kstrip_wheel_on_table().
 */
kstrip_status kstrip_height_for_load(const struct kstrip_surface *rail,
                                     const struct kstrip_surface *wheel,
                                     const struct kstrip_wheel_pair *pair,
                                     const struct kstrip_wheel_position *position,
                                     double support,
                                     const struct kstrip_wheel_velocity *velocity,
                                     const struct kstrip_friction *friction,
                                     const struct kstrip_table *table,
                                     struct kstrip_wheel_workspace *workspace,
                                     double *vertical);

/**
 * kstrip_height_for_load() for many wheels with the same profiles: the same results, bit for bit.
 *
 * @param rail, wheel, count, workspace  as in kstrip_wheels_on_rails().
 * @param pairs, pair_stride  kstrip_wheel_pair of each, and its stride [bytes].
 * @param positions, position_stride  position of each wheel, and its stride [bytes]; each search
 *                        begins at the vertical member of its position.
 * @param supports, support_stride  requested upward force of the rail on each wheel [N], > 0, and
 *                        its stride [bytes].
 * @param velocities, velocity_stride  velocity of each wheel, and its stride [bytes]; NULL: the
 *                        pressure carries the load.
 * @param friction, friction_stride  as in kstrip_wheel_on_rail(), with its stride [bytes]; NULL:
 *                        constant.
 * @param table           a contact table of all pairs; NULL: contacts are computed.
 * @param[out] verticals  array of count elements; receives the vertical positions [m].
 * @param[out] statuses   array of count elements; receives those of kstrip_height_for_load();
 *                        NULL: not needed.
 * @return as kstrip_height_for_load(): the first error of a wheel, or the most serious warning;
 *         before any wheel KSTRIP_ERROR_NULL (a required array), KSTRIP_ERROR_STRIDE (no multiple
 *         of the alignment).
 */
kstrip_status kstrip_heights_for_loads(const struct kstrip_surface *rail,
                                       const struct kstrip_surface *wheel,
                                       uint32_t count,
                                       const struct kstrip_wheel_pair *pairs,
                                       uint32_t pair_stride,
                                       const struct kstrip_wheel_position *positions,
                                       uint32_t position_stride,
                                       const double *supports,
                                       uint32_t support_stride,
                                       const struct kstrip_wheel_velocity *velocities,
                                       uint32_t velocity_stride,
                                       const struct kstrip_friction *friction,
                                       uint32_t friction_stride,
                                       const struct kstrip_table *table,
                                       struct kstrip_wheel_workspace *workspace,
                                       double *verticals,
                                       kstrip_status *statuses);

/** Ranges of a contact table, and how many nodes it has. */
typedef struct kstrip_table_spec {
    /**
     * Range of the lateral position without yaw and roll [m]. With them the range has the same
     * places of contact, and is shifted by about roll times wheel_radius.
     */
    double lateral_from;
    /** End of this range [m]. */
    double lateral_to;
    /** Largest yaw to both sides [rad], >= 0; 0: no yaw. */
    double yaw;
    /** Largest roll to both sides [rad], >= 0; 0: no roll. */
    double roll;
    /** Largest vertical support of the wheel [N], > 0. */
    double load;
    /** Lateral nodes, 9 to 256; 0: 99. */
    uint32_t lateral_nodes;
    /** Levels of the load, 3 to 64; 0: 20. */
    uint32_t levels;
    /** Nodes of yaw; 0: 3, without yaw 1. */
    uint32_t yaw_nodes;
    /** Nodes of roll, an odd number; 0: one every 2.5 mrad or less, without roll 1. */
    uint32_t roll_nodes;
    /**
     * Number of strips in 8 mm of a contact, 12 to 32; 0: 16. It is that of the places on the
     * wheel at which the table has numbers.
     */
    uint32_t strips;
    /** Reserved: zero. */
    uint32_t reserved;
} kstrip_table_spec;

/**
 * Size of a contact table, which holds contacts of kstrip_wheel_on_rail() at nodes;
 * kstrip_wheel_on_table() interpolates between them. docs/evidence/tables.md has its accuracy.
 *
 * A table is caller-provided memory at any address, without pointers and little-endian. It may be
 * written to a file, and read or mapped again on another machine and by either precision. It is
 * begun, its parts are filled in any order and on any threads, and it is finished.
 *
 * @param wheel           prepared profile.
 * @param spec            ranges and numbers of nodes.
 * @param[out] bytes      receives the length that a table needs while it is filled.
 * @param[out] parts      receives the number of its parts.
 * @return KSTRIP_OK; KSTRIP_ERROR_NULL; KSTRIP_ERROR_NOT_PREPARED (wheel); KSTRIP_ERROR_NOT_FINITE
 *         and KSTRIP_ERROR_TABLE_SPEC (spec); KSTRIP_ERROR_CAPACITY (too many nodes, or 4 GB).
 */
kstrip_status kstrip_table_size(const struct kstrip_surface *wheel,
                                const struct kstrip_table_spec *spec,
                                uint32_t *bytes,
                                uint32_t *parts);

/**
 * Begins a table: it chooses lateral nodes for each pair of nodes of yaw and roll, in about the
 * time of one part for each pair.
 *
 * @param rail, wheel, pair  as in kstrip_wheel_on_rail(), with a straight rail; side, friction,
 *                        damping, strips and model do not matter.
 * @param spec            as in kstrip_table_size().
 * @param workspace       memory that may hold anything.
 * @param[out] table      memory of that many bytes.
 * @param bytes           at least the length that kstrip_table_size() returns.
 * @return KSTRIP_OK; a status of kstrip_table_size(); KSTRIP_ERROR_CAPACITY (bytes);
 *         KSTRIP_ERROR_TABLE_PAIR (a roller); KSTRIP_ERROR_TABLE_SPEC (no lateral position of the
 *         range has a contact); an error of kstrip_wheel_on_rail() about its arguments.
 */
kstrip_status kstrip_table_begin(const struct kstrip_surface *rail,
                                 const struct kstrip_surface *wheel,
                                 const struct kstrip_wheel_pair *pair,
                                 const struct kstrip_table_spec *spec,
                                 struct kstrip_wheel_workspace *workspace,
                                 uint8_t *table,
                                 uint32_t bytes);

/**
 * Fills parts of a table that is begun, each in about the time of 400 calls of
 * kstrip_wheel_on_rail(). Several threads may each fill other parts of one table, with separate
 * workspaces. Call it with few parts to show the progress.
 *
 * @param rail, wheel, pair  those with which it was begun.
 * @param first, count    number of the first part, and how many.
 * @param workspace       memory that may hold anything.
 * @param[in,out] table, bytes  the table.
 * @return KSTRIP_OK; KSTRIP_ERROR_NULL; KSTRIP_ERROR_TABLE (no table, or bytes too few);
 *         KSTRIP_ERROR_TABLE_UNFINISHED (it is finished already); KSTRIP_ERROR_TABLE_PAIR (another
 *         pair); KSTRIP_ERROR_TABLE_SPEC (there are no such parts); an error of
 *         kstrip_wheel_on_rail() about its arguments.
 */
kstrip_status kstrip_table_fill(const struct kstrip_surface *rail,
                                const struct kstrip_surface *wheel,
                                const struct kstrip_wheel_pair *pair,
                                uint32_t first,
                                uint32_t count,
                                struct kstrip_wheel_workspace *workspace,
                                uint8_t *table,
                                uint32_t bytes);

/** The size of a finished table, and its measured error. */
typedef struct kstrip_table_report {
    /**
     * Error of the horizontal force over friction times load [-]: not exceeded by 95 of 100
     * poses.
     */
    double force_usual;
    /** The largest one [-]. */
    double force_largest;
    /** Error of the vertical force over that force [-]: not exceeded by 95 of 100 poses. */
    double load_usual;
    /** The largest one [-]. */
    double load_largest;
    /** Length of the table [bytes]. */
    uint32_t bytes;
    /** Number of poses that were compared. */
    uint32_t poses;
    /** Number of poses that the direct computation has, and the table has not. */
    uint32_t missing;
    /** Number of nodes without a contact. */
    uint32_t empty;
} kstrip_table_report;

/**
 * Finishes a table whose parts are filled: shortens it, measures its error against the direct call
 * with 64 strips, and adds a checksum. The positions of the measurement have 2.3 to 91 % of the
 * largest load and are spread over the ranges.
 *
 * @param rail, wheel, pair  those with which it was begun.
 * @param poses           number of these positions: 500 are enough, and take about a second.
 * @param workspace       memory that may hold anything.
 * @param[in,out] table, bytes  the table.
 * @param[out] report     receives the length that the table has now, and its error.
 * @return as kstrip_table_fill(); KSTRIP_ERROR_TABLE_UNFINISHED where a part is not filled, after
 *         which it must be begun again.
 */
kstrip_status kstrip_table_finish(const struct kstrip_surface *rail,
                                  const struct kstrip_surface *wheel,
                                  const struct kstrip_wheel_pair *pair,
                                  uint32_t poses,
                                  struct kstrip_wheel_workspace *workspace,
                                  uint8_t *table,
                                  uint32_t bytes,
                                  struct kstrip_table_report *report);

/**
 * Checks all of a finished table. Call it once if a table comes from a file: the other functions
 * read no more than they need, and compute wrong numbers from a damaged table, but never access
 * memory outside it.
 *
 * @param table, bytes    the table, or more bytes than it has.
 * @param[out] length     receives its length [bytes]; NULL: not needed.
 * @return KSTRIP_OK; KSTRIP_ERROR_NULL; KSTRIP_ERROR_TABLE (damaged, cut off, of another version,
 *         or something else); KSTRIP_ERROR_TABLE_UNFINISHED (it is begun only).
 */
kstrip_status kstrip_table_check(const uint8_t *table, uint32_t bytes, uint32_t *length);

/**
 * kstrip_wheel_on_rail() from a table alone: it needs no profiles, and computes no gap. Force and
 * moment are continuous inside the table.
 *
 * @param table           a finished table; its member only does not matter.
 * @param pair            friction, side, model, damping, floor_speed and rail_speed. The radius,
 *                        the materials and the smoothing length are those of the table, the number
 *                        of strips is that of its spec, and the rail is straight.
 * @param position, velocity  as in kstrip_wheel_on_rail().
 * @param friction        falling friction (not its friction and rolling_speed); NULL: constant.
 * @param workspace       memory that may hold anything; receives the contacts; NULL: not needed.
 *                        With several contacts a call without it takes longer, and the sums have
 *                        another rounding.
 * @param[out] wrench     receives force and moment.
 * @param[out] derivatives  receives their exact derivatives with respect to velocity and friction;
 *                          NULL: not needed.
 * @param[out] by_position  receives the derivatives of the interpolated wrench with respect to
 *                        position: one-sided differences; NULL: not needed.
 * @return KSTRIP_OK; KSTRIP_WARNING_ANGLE_RANGE or KSTRIP_WARNING_ROUGH as there;
 *         KSTRIP_ERROR_NULL; KSTRIP_ERROR_TABLE_RANGE (outside the table, where
 *         kstrip_wheel_on_rail() takes over); KSTRIP_ERROR_TABLE (no table, or bytes too few);
 *         KSTRIP_ERROR_TABLE_UNFINISHED (it is begun only); KSTRIP_ERROR_TABLE_PAIR (another
 *         pair); an error of kstrip_wheel_on_rail() about its arguments.
 */
kstrip_status kstrip_wheel_on_table(const struct kstrip_table *table,
                                    const struct kstrip_wheel_pair *pair,
                                    const struct kstrip_wheel_position *position,
                                    const struct kstrip_wheel_velocity *velocity,
                                    const struct kstrip_friction *friction,
                                    struct kstrip_wheel_workspace *workspace,
                                    struct kstrip_wrench *wrench,
                                    struct kstrip_wrench_derivatives *derivatives,
                                    struct kstrip_wrench_by_position *by_position);

/** @} */

/**
 * @defgroup kstrip_wheelset The wheelset: two wheels on two rails
 * @{
 */

/**
 * Degrees of freedom of a wheelset on two rails: the members of kstrip_wheel_velocity (forward,
 * lateral, vertical, roll, pitch, yaw), then lateral and vertical of the right rail, and lateral
 * and vertical of the left one.
 */
#define KSTRIP_WHEELSET_FREEDOMS 10

/**
 * The gauge face of a rail: the least y of its profile down to a depth below its top. kstrip_track
 * uses it to find the rail's origin, which lies half the gauge minus this y from the middle of the
 * track.
 *
 * @param rail            prepared profile of a rail.
 * @param depth           depth below the top of the rail [m], >= 0; 0: 14 mm.
 * @param[out] face       receives y of the gauge face from the rail's origin [m]; negative.
 * @return KSTRIP_OK; KSTRIP_WARNING_PROFILE_END (the profile ends above the depth);
 *         KSTRIP_ERROR_NULL (rail or face), KSTRIP_ERROR_NOT_FINITE (depth is infinite or NaN),
 *         KSTRIP_ERROR_NOT_PREPARED (rail), KSTRIP_ERROR_GAUGE (depth < 0).
 */
kstrip_status kstrip_gauge_face(const struct kstrip_surface *rail, double depth, double *face);

/** A curve that a vehicle runs through: the axes of the track move forward and turn with it. */
typedef struct kstrip_curve {
    /** Speed along the middle of the track, at the height of the wheelset's centre [m/s]. */
    double speed;
    /**
     * One divided by the radius of the curve [1/m]: positive to the right, 0: straight.
     * KSTRIP_WARNING_CURVATURE if its size is above 0.2.
     */
    double curvature;
    /**
     * Angle of cant [rad]: positive where the right rail is lower, between -1 and 1, else
     * KSTRIP_ERROR_ANGLE. In a curve to the right it is positive.
     */
    double cant;
    /** Acceleration of gravity [m/s^2]; 0: 9.80665. */
    double gravity;
} kstrip_curve;

/**
 * Motion and weight in a curve. The axes of the track run along the curve with its speed, and turn
 * with it; relative to the momentary track, which is at rest, a body therefore has this motion in
 * addition to its own. Use it before kstrip_wheelset_on_track() and for the weight of every body.
 *
 * @param curve           speed, curvature, cant.
 * @param position        where the body is in the axes of the track; vertical is not used.
 * @param relative        how the body moves in these axes; forward is the velocity in
 *                        addition to the speed of the curve.
 * @param[out] velocity   receives the velocity relative to the momentary track.
 * @param[out] weight     receives three numbers: weight per mass, the centrifugal part included,
 *                        forward, lateral, vertical [m/s^2]. At balance speed its lateral part is
 *                        zero. NULL: not needed.
 * @return usual statuses; statuses of kstrip_curve and kstrip_wheel_position.
 */
kstrip_status kstrip_curve_motion(const struct kstrip_curve *curve,
                                  const struct kstrip_wheel_position *position,
                                  const struct kstrip_wheel_velocity *relative,
                                  struct kstrip_wheel_velocity *velocity,
                                  double *weight);

/**
 * A wheelset: two wheels on an axle. Number 0 is the right wheel, number 1 the left one.
 * KSTRIP_ERROR_GAUGE if back_to_back and running_circles are both 0, or one of them is negative.
 */
typedef struct kstrip_wheelset {
    /** Prepared profiles, both of a right wheel: right, left; left NULL: as the right one. */
    const struct kstrip_surface *wheel[2];
    /** Falling friction, as in kstrip_patch_evaluate(): right, left; NULL: constant. */
    const struct kstrip_friction *friction[2];
    /** Contact tables of each wheel on its rail: right, left; NULL: contacts are computed. */
    const struct kstrip_table *table[2];
    /**
     * Radius, materials, friction and options of each wheel; if the left wheel_radius is 0, the
     * left wheel has all values of the right one. The member left is not used.
     */
    struct kstrip_wheel_pair pair[2];
    /**
     * Distance of the backs of the flanges [m], 1.360 for standard gauge; not used where
     * running_circles is given.
     */
    double back_to_back;
    /**
     * Distance of the running circles, which are at y = 0 of the wheels' profiles [m]; 0:
     * back_to_back and twice 70 mm.
     */
    double running_circles;
} kstrip_wheelset;

/**
 * Displacement and velocity of a rail: irregularities of the track, or the motion of a flexible
 * rail. Axes of the track.
 */
typedef struct kstrip_rail_motion {
    /** Displacement to the right [m]. */
    double lateral;
    /** Displacement downward [m]. */
    double vertical;
    /** Velocity to the right [m/s]. */
    double lateral_velocity;
    /** Velocity downward [m/s]. */
    double vertical_velocity;
} kstrip_rail_motion;

/**
 * A track: two rails, and where they are. Axes: x forward, y to the right, z down; the middle of
 * the track is midway between the gauge faces. Cant and inclination of the track are those of
 * these axes; the inclination of the rails is in their profiles. Number 0 is the right side,
 * number 1 the left side. KSTRIP_ERROR_GAUGE if gauge, gauge_depth or an origin is negative, or if
 * the gauge is 0 and used; KSTRIP_WARNING_PROFILE_END if a rail ends above gauge_depth.
 */
typedef struct kstrip_track {
    /** Prepared profiles, both of a right rail: right, left; left NULL: as the right one. */
    const struct kstrip_surface *rail[2];
    /**
     * Gauge [m]: distance of the gauge faces, 1.435 for standard gauge; not used where both
     * origins are given.
     */
    double gauge;
    /** Depth below the top of the rails down to which the gauge is measured [m], >= 0; 0: 14 mm. */
    double gauge_depth;
    /**
     * Distances of the rails' origins from the middle of the track [m], >= 0: right, left; 0: from
     * the gauge.
     */
    double origin[2];
    /** Displacements and velocities of the rails, right and left: irregularities, flexible rails. */
    struct kstrip_rail_motion motion[2];
} kstrip_track;

/**
 * Caller-provided memory for the computation of a wheelset: that of the right wheel and that of
 * the left one. It may hold anything before a call. After KSTRIP_OK or a warning it holds gap and
 * contacts of both wheels.
 */
typedef struct kstrip_wheelset_workspace {
    /** Right, left. */
    struct kstrip_wheel_workspace wheel[2];
} kstrip_wheelset_workspace;

/** Forces on a wheelset, on each wheel, and on each rail. */
typedef struct kstrip_wheelset_forces {
    /**
     * Force on the wheelset [N], axes of the track, and moment about its centre [N m], its own
     * axes; sums of dissipation, loads, contacts.
     */
    struct kstrip_wrench wrench;
    /** Force and moment on the right and on the left wheel, about the wheel's centre. */
    struct kstrip_wrench wheel[2];
    /**
     * Force on the right and on the left rail [N], axes of the track: forward, lateral (Y, to
     * the right), vertical (Q, down).
     */
    double rail[2][3];
} kstrip_wheelset_forces;

/**
 * Exact derivatives of the forces on a wheelset and its two rails with respect to the velocities.
 * Rows are the ten forces: force and moment on the wheelset, then lateral and vertical force on
 * the right rail and on the left rail. Columns are the ten degrees of freedom
 * (KSTRIP_WHEELSET_FREEDOMS).
 */
typedef struct kstrip_wheelset_derivatives {
    /** With respect to the velocities [N, N m per m/s, rad/s]. */
    double velocity[KSTRIP_WHEELSET_FREEDOMS][KSTRIP_WHEELSET_FREEDOMS];
    /** With respect to a factor on all coefficients of friction, at 1 [N, N m]. */
    double friction[KSTRIP_WHEELSET_FREEDOMS];
} kstrip_wheelset_derivatives;

/**
 * Derivatives of the same ten forces with respect to the positions of the ten degrees of freedom,
 * at constant velocities.
 */
typedef struct kstrip_wheelset_by_position {
    /** With respect to the positions [N, N m per m, rad]; forward and pitch columns are zero. */
    double position[KSTRIP_WHEELSET_FREEDOMS][KSTRIP_WHEELSET_FREEDOMS];
} kstrip_wheelset_by_position;

/**
 * Forces on a wheelset and its rails: two wheels, two rails, one call.
 *
 * The position is that of the wheelset's centre, in the axes of the track: lateral from the middle
 * of the track, vertical below the place where the centre is the mean of both wheel radii above
 * the rails' origins. The velocity is that of the centre relative to the momentary track, with
 * rates about the wheelset's own axes; in a curve kstrip_curve_motion() computes it. Forces are
 * continuous as in kstrip_wheel_on_rail(). The forces times the ten velocities are minus the
 * dissipation and minus the power that goes into the pressure.
 *
 * @param set             wheels, materials, friction, distance of the wheels.
 * @param track           rails, gauge, displacements and velocities of the rails.
 * @param position        where the wheelset's centre is, its yaw and its roll.
 * @param velocity        how it moves.
 * @param workspace       memory that may hold anything; receives gap and contacts of both wheels.
 * @param[out] forces     receives the wrench on the wheelset and on each wheel, and the force on
 *                        each rail.
 * @param[out] derivatives  receives exact derivatives with respect to the ten velocities and to
 *                        friction; NULL: not needed.
 * @param[out] by_position  receives derivatives with respect to the ten positions, as exact as
 *                        those of kstrip_wheel_on_rail(); NULL: not needed.
 * @return statuses of kstrip_wheelset and kstrip_track; as kstrip_wheel_on_rail() for each wheel,
 *         of two warnings the more serious; with tables those of kstrip_wheel_on_table().
 */
kstrip_status kstrip_wheelset_on_track(const struct kstrip_wheelset *set,
                                       const struct kstrip_track *track,
                                       const struct kstrip_wheel_position *position,
                                       const struct kstrip_wheel_velocity *velocity,
                                       struct kstrip_wheelset_workspace *workspace,
                                       struct kstrip_wheelset_forces *forces,
                                       struct kstrip_wheelset_derivatives *derivatives,
                                       struct kstrip_wheelset_by_position *by_position);

/** Loads of the vehicle and of gravity on a wheelset that does not accelerate. */
typedef struct kstrip_wheelset_loads {
    /** Downward force at the centre [N], weight included, > 0, else KSTRIP_ERROR_SUPPORT. */
    double vertical;
    /** Moment about the wheelset's x axis [N m]: positive from y to z, onto the right rail. */
    double roll;
    /** Torque about the axle [N m], in the sense of the pitch rate: negative drives forward. */
    double pitch;
} kstrip_wheelset_loads;

/**
 * A wheelset in balance: height, roll and pitch rate at which its rails carry given loads, at
 * given lateral position, yaw and speed. Use it to begin a run, and for tables. Any friction from
 * 0 on, any speed and rollers are possible. Without friction the pitch rate is that of pure
 * rolling on the mean radius. A wheel is lifted in the result only if no balance is found with
 * both wheels on the rails.
 *
 * @param set, track      as in kstrip_wheelset_on_track().
 * @param start           lateral and yaw; vertical and roll are where the search begins.
 * @param velocity        how the wheelset moves; its pitch is not used.
 * @param loads           downward force, roll moment and torque about the axle that act on the
 *                        wheelset.
 * @param workspace       memory that may hold anything; receives gap and contacts of both wheels.
 * @param[out] position   receives the position.
 * @param[out] moves      receives the velocity, with the pitch rate.
 * @param[out] forces     receives the forces there; NULL: not needed.
 * @return as kstrip_wheelset_on_track(); statuses of kstrip_wheelset_loads;
 *         KSTRIP_WARNING_NOT_CONVERGED (the balance is not exact to rounding);
 *         KSTRIP_ERROR_WHEEL_LIFTED (no heights carry the loads);
 *         KSTRIP_ERROR_FORCE_BEYOND_FRICTION (friction does not carry the torque).
 */
kstrip_status kstrip_wheelset_settle(const struct kstrip_wheelset *set,
                                     const struct kstrip_track *track,
                                     const struct kstrip_wheel_position *start,
                                     const struct kstrip_wheel_velocity *velocity,
                                     const struct kstrip_wheelset_loads *loads,
                                     struct kstrip_wheelset_workspace *workspace,
                                     struct kstrip_wheel_position *position,
                                     struct kstrip_wheel_velocity *moves,
                                     struct kstrip_wheelset_forces *forces);

/**
 * kstrip_wheelset_on_track() for many positions and velocities: the same results, bit for bit.
 *
 * @param set, track, workspace  as in kstrip_wheelset_on_track().
 * @param count           number of positions; 0 is allowed.
 * @param positions, position_stride  positions of the wheelset, and the distance from one to the
 *                        next [bytes], as in kstrip_wheels_on_rails().
 * @param velocities, velocity_stride  velocities of the wheelset, and their stride [bytes].
 * @param[out] forces     array of count elements; receives the forces.
 * @param[out] derivatives, by_position  arrays of count elements; NULL: not needed.
 * @param[out] statuses   array of count elements; receives those of kstrip_wheelset_on_track();
 *                        NULL: not needed.
 * @return as kstrip_wheelset_on_track(): the first error of an element, or the most serious
 *         warning; before any element KSTRIP_ERROR_NULL (a required array), KSTRIP_ERROR_STRIDE
 *         (no multiple of the alignment).
 */
kstrip_status kstrip_wheelsets_on_track(const struct kstrip_wheelset *set,
                                        const struct kstrip_track *track,
                                        uint32_t count,
                                        const struct kstrip_wheel_position *positions,
                                        uint32_t position_stride,
                                        const struct kstrip_wheel_velocity *velocities,
                                        uint32_t velocity_stride,
                                        struct kstrip_wheelset_workspace *workspace,
                                        struct kstrip_wheelset_forces *forces,
                                        struct kstrip_wheelset_derivatives *derivatives,
                                        struct kstrip_wheelset_by_position *by_position,
                                        kstrip_status *statuses);

/**
 * kstrip_wheelset_settle() for many starts, velocities and loads: the same results, bit for bit.
 *
 * @param set, track, count, workspace  as in kstrip_wheelsets_on_track().
 * @param starts, start_stride  as in kstrip_wheelset_settle(), and the distance from one to the
 *                        next [bytes], as in kstrip_wheels_on_rails().
 * @param velocities, velocity_stride  as in kstrip_wheelset_settle(), with their stride [bytes].
 * @param loads, load_stride  as in kstrip_wheelset_settle(), with their stride [bytes].
 * @param[out] positions, moves  arrays of count elements.
 * @param[out] forces     array of count elements; NULL: not needed.
 * @param[out] statuses   array of count elements; receives those of kstrip_wheelset_settle();
 *                        NULL: not needed.
 * @return as kstrip_wheelset_settle(), and before any element as kstrip_wheelsets_on_track().
 */
kstrip_status kstrip_wheelsets_settle(const struct kstrip_wheelset *set,
                                      const struct kstrip_track *track,
                                      uint32_t count,
                                      const struct kstrip_wheel_position *starts,
                                      uint32_t start_stride,
                                      const struct kstrip_wheel_velocity *velocities,
                                      uint32_t velocity_stride,
                                      const struct kstrip_wheelset_loads *loads,
                                      uint32_t load_stride,
                                      struct kstrip_wheelset_workspace *workspace,
                                      struct kstrip_wheel_position *positions,
                                      struct kstrip_wheel_velocity *moves,
                                      struct kstrip_wheelset_forces *forces,
                                      kstrip_status *statuses);

/**
 * The difference of the rolling radii, right minus left, against the lateral shift of a rigid
 * wheelset that touches both rails without yaw.
 *
 * @param set, track      as in kstrip_wheelset_on_track(); of the motion of the rails only the
 *                        displacements are used.
 * @param shifts, count   lateral positions of the wheelset [m].
 * @param with_roll       0: without roll, as in EN 15302; any other number: with the roll that
 *                        the wheelset has on both rails.
 * @param workspace       memory that may hold anything.
 * @param[out] differences  array of count elements; receives the differences [m]. An element with
 *                        an error is untouched and does not stop the others.
 * @param[out] statuses   array of count elements; receives the status of each shift; NULL: not
 *                        needed.
 * @return as kstrip_wheelset_on_track() without velocities and contacts: the first error of a
 *         shift; before any shift KSTRIP_ERROR_NULL (a required array or structure).
 */
kstrip_status kstrip_rolling_radius_difference(const struct kstrip_wheelset *set,
                                               const struct kstrip_track *track,
                                               const double *shifts,
                                               uint32_t count,
                                               int32_t with_roll,
                                               struct kstrip_wheelset_workspace *workspace,
                                               double *differences,
                                               kstrip_status *statuses);

/**
 * Equivalent conicity after EN 15302: the conicity of the coned wheelset whose motion has the same
 * wave length. It comes from the motion of a free wheelset over half a wave, with differences of
 * the rolling radii that kstrip_rolling_radius_difference() or a measurement gives.
 *
 * @param shifts, differences, count  lateral shifts [m], ascending, and differences of the rolling
 *                        radii, right minus left [m]; at least 2, straight between them.
 * @param running_circles  distance of the running circles [m], > 0, about 1.5.
 * @param wheel_radius    radius of the wheels [m], > 0.
 * @param amplitudes, number  amplitudes of the motion [m], > 0.
 * @param[out] conicities   array of number elements; receives the conicities [-], >= 0: 0 where
 *                        the radii do not differ over a part of the motion. An element with an
 *                        error is untouched and does not stop the others.
 * @param[out] wave_lengths  array of number elements; receives the wave lengths [m], INFINITY
 *                        where the conicity is 0; NULL: not needed.
 * @param[out] statuses   array of number elements; receives the status of each amplitude; NULL:
 *                        not needed.
 * @return KSTRIP_OK, or the error of the first amplitude without a conicity: KSTRIP_ERROR_CONICITY
 *         (it is not positive or beyond the shifts, or the radii turn the wheelset away from the
 *         middle), KSTRIP_ERROR_NOT_FINITE (it is infinite or NaN), KSTRIP_ERROR_OVERFLOW (a
 *         result is too large); before any amplitude KSTRIP_ERROR_NULL (a required array),
 *         KSTRIP_ERROR_NOT_FINITE (another number), KSTRIP_ERROR_PROFILE (fewer than two shifts,
 *         or they do not ascend), KSTRIP_ERROR_GAUGE (running_circles <= 0),
 *         KSTRIP_ERROR_ROLLING_RADIUS (wheel_radius <= 0).
 */
kstrip_status kstrip_equivalent_conicity(const double *shifts,
                                         const double *differences,
                                         uint32_t count,
                                         double running_circles,
                                         double wheel_radius,
                                         const double *amplitudes,
                                         uint32_t number,
                                         double *conicities,
                                         double *wave_lengths,
                                         kstrip_status *statuses);

/** @} */

/**
 * @defgroup kstrip_rig Test rigs: friction from a force, creepage from a force, a law from a curve
 * @{
 */

/** The longitudinal force was measured. */
#define KSTRIP_MEASURED_FX 1
/** The lateral force was measured. */
#define KSTRIP_MEASURED_FY 2

/** Fit the coefficient of friction without slip. */
#define KSTRIP_FIT_FRICTION 1
/** Fit the ratio of falling friction. */
#define KSTRIP_FIT_RATIO 2
/** Fit the decay of falling friction. */
#define KSTRIP_FIT_DECAY 4
/** Fit the slope factor. */
#define KSTRIP_FIT_SLOPE_FACTOR 8
/** Fit the slide factor. */
#define KSTRIP_FIT_SLIDE_FACTOR 16
/** Fit the layer. */
#define KSTRIP_FIT_LAYER 32

/** A coefficient of friction from a measured force. */
typedef struct kstrip_friction_estimate {
    /** Coefficient of friction [-]; a lower bound with KSTRIP_WARNING_FRICTION_AT_LEAST. */
    double friction;
    /**
     * d(friction)/d(force) [1/N]: change of the coefficient for an error of 1 N in the measured
     * force; 0 for a lower bound.
     */
    double sensitivity;
    /**
     * Distance between the measured and the computed force [N] in the components that were
     * measured. For one component it is rounding; for both it is the part that friction
     * cannot explain, because the directions of the forces differ.
     */
    double residual;
    /** The status of this result: 0 or one of the KSTRIP_WARNING constants. */
    kstrip_status status_detail;
    /** Reserved: zero. */
    int32_t reserved;
} kstrip_friction_estimate;

/**
 * The coefficient of friction that explains a measured force at a known creepage.
 *
 * The contact adheres if less than a twentieth of the friction is used, or if the force is larger
 * than in linear theory. Then the status is KSTRIP_WARNING_FRICTION_AT_LEAST, and the result is
 * the used friction |force|/load, a lower bound. If spin opposes the creepage, more than one
 * friction may explain the force: the status is KSTRIP_WARNING_SEVERAL_FRICTIONS, and the result
 * is the smallest. KSTRIP_MODEL_TOTAL suits best. The force of KSTRIP_MODEL_STRIP_1967 jumps when
 * a first strip begins to adhere. A jump across the measured force is one of several solutions
 * there, and is returned only with KSTRIP_WARNING_NOT_CONVERGED. With the models of 1967 an
 * estimate may miss a friction, most often if the force is nearly zero.
 *
 * Under a law the result is its friction, without slip: a force that was computed with the law
 * has the law's coefficient. If the actual law is another one, each creepage has another
 * friction; kstrip_fit_friction() finds the law.
 *
 * @param contact         ellipse, load, material; its friction is ignored.
 * @param creepage        motion.
 * @param friction        law of friction, whose own coefficient is ignored; NULL: clean bodies,
 *                        constant friction.
 * @param options         model and strip count; NULL for the defaults. Not KSTRIP_MODEL_LINEAR.
 * @param measured        KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY, or both added, for the
 *                        magnitude of the force.
 * @param fx, fy          measured forces on the lower body [N]; others are ignored.
 * @param[out] estimate   receives friction, its sensitivity, and how far the force is off.
 * @return as kstrip_solve(); statuses of kstrip_friction; KSTRIP_WARNING_FRICTION_AT_LEAST,
 *         KSTRIP_WARNING_SEVERAL_FRICTIONS and KSTRIP_WARNING_NOT_CONVERGED (see above);
 *         KSTRIP_ERROR_NOT_IN_MODEL (KSTRIP_MODEL_LINEAR); KSTRIP_ERROR_MEASURED (measured is
 *         another number); KSTRIP_ERROR_UNEXPLAINED (no friction gives the force, or the contact
 *         is lost).
 */
kstrip_status kstrip_estimate_friction(const struct kstrip_contact *contact,
                                       const struct kstrip_creepage *creepage,
                                       const struct kstrip_friction *friction,
                                       const struct kstrip_options *options,
                                       uint32_t measured,
                                       double fx,
                                       double fy,
                                       struct kstrip_friction_estimate *estimate);

/**
 * The creepage at which a contact with a given spin carries a requested force.
 *
 * If no creepage has the force to rounding, such as a force within a jump of STRIP_1967, the
 * result is the nearest, with KSTRIP_WARNING_NOT_CONVERGED. If spin keeps the force from growing
 * with the creepage, more than one creepage may have it; the result is one of them. A force within
 * 0.1 % of friction times load is that of full sliding. The status is then
 * KSTRIP_WARNING_CREEPAGE_AT_LEAST, and every larger creepage has the force as well. A lost
 * contact carries no force.
 *
 * @param contact         ellipse, load, material, friction.
 * @param fx, fy          requested force on the lower body [N].
 * @param spin            given spin [1/m].
 * @param friction        law of friction; NULL: clean bodies, the contact's own friction. A force
 *                        that falling friction does not reach is KSTRIP_WARNING_NOT_CONVERGED.
 * @param options         model and strip count; NULL for the defaults.
 * @param[out] creepage   receives the creepages, and the given spin.
 * @return as kstrip_solve(); statuses of kstrip_friction; KSTRIP_WARNING_CREEPAGE_AT_LEAST and
 *         KSTRIP_WARNING_NOT_CONVERGED (see above); KSTRIP_WARNING_SEVERAL_FRICTIONS, as in
 *         kstrip_evaluate(); KSTRIP_ERROR_FORCE_BEYOND_FRICTION (the force exceeds mu N).
 */
kstrip_status kstrip_creepage_for_force(const struct kstrip_contact *contact,
                                        double fx,
                                        double fy,
                                        double spin,
                                        const struct kstrip_friction *friction,
                                        const struct kstrip_options *options,
                                        struct kstrip_creepage *creepage);

/** One measured point of a creep curve. */
typedef struct kstrip_measured_force {
    /** Longitudinal creepage [-]. */
    double longitudinal;
    /** Lateral creepage [-]. */
    double lateral;
    /** Spin [1/m]. */
    double spin;
    /** Longitudinal force on the lower body [N]; ignored unless it was measured. */
    double fx;
    /** Lateral force on the lower body [N]; ignored unless it was measured. */
    double fy;
    /**
     * Weight of the squared error of a force, >= 0, else KSTRIP_ERROR_WEIGHT. It is 1 for points
     * of equal accuracy, 1/error^2 otherwise; 0: the point does not count.
     */
    double weight;
    /** KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY, or both added; else KSTRIP_ERROR_MEASURED. */
    uint32_t measured;
    /** Reserved: zero. */
    uint32_t reserved;
} kstrip_measured_force;

/** A law of friction that was fitted to measured points. */
typedef struct kstrip_friction_fit {
    /** The law. */
    struct kstrip_friction law;
    /**
     * Standard errors of its members, from the remaining differences between points and law; 0 for
     * a member that was not fitted or that ended at a bound.
     */
    struct kstrip_friction standard_errors;
    /** Root of the weighted mean square difference between measured and computed forces [N]. */
    double residual;
    /** Largest number of times that all forces were computed from one start. */
    uint32_t steps;
    /** The status of this result: 0 or one of the KSTRIP_WARNING constants. */
    kstrip_status status_detail;
} kstrip_friction_fit;

/**
 * The law of friction that fits a measured creep curve best.
 *
 * It minimises the sum of the squared differences between measured and computed forces, each times
 * the weight of its point. The search begins at start and at other places, unless the points are
 * met exactly. Members of the law that are not fitted keep the values of start. A fitted member
 * that is 0 in start begins at a usual value; falling friction needs the rolling speed in start.
 * Bounds are those of the law: a member that ends at its bound has a standard error of 0, and the
 * status is KSTRIP_WARNING_FIT_BOUND. If another law has a residual that is at most 1 per cent
 * larger, the status is KSTRIP_WARNING_SECOND_MINIMUM.
 *
 * Points that lie on one part of the curve do not determine each parameter. The status is then
 * KSTRIP_WARNING_UNDETERMINED: a parameter would be uncertain by more than half of its value with
 * errors of the forces of one per cent, or with their actual errors if these are larger. Layer
 * and slope factor have nearly the same effect; fit one of them.
 *
 * @param contact         ellipse, load, material of all points; its friction is ignored.
 * @param points, count   the measured points.
 * @param start           where to begin, and the members that stay.
 * @param parameters      which members to fit: KSTRIP_FIT constants, added.
 * @param options         model and strip count; NULL for the defaults.
 * @param[out] fit        receives the law and its standard errors.
 * @param[out] first_bad  receives the index of the first bad point, or count where none is bad;
 *                        NULL: not requested.
 * @return usual statuses; errors of kstrip_contact, kstrip_friction (start), kstrip_measured_force
 *         and kstrip_options; KSTRIP_WARNING_FIT_BOUND, KSTRIP_WARNING_SECOND_MINIMUM and
 *         KSTRIP_WARNING_UNDETERMINED (see above); KSTRIP_WARNING_NOT_CONVERGED (the last step
 *         still changed the law); KSTRIP_WARNING_PER_CENT (the slope factor is below 0.05);
 *         KSTRIP_ERROR_FEW_POINTS (fewer forces than parameters); KSTRIP_ERROR_FIT_PARAMETERS
 *         (parameters is 0 or no sum of the constants); KSTRIP_ERROR_UNEXPLAINED (the contact is
 *         lost).
 */
kstrip_status kstrip_fit_friction(const struct kstrip_contact *contact,
                                  const struct kstrip_measured_force *points,
                                  uint32_t count,
                                  const struct kstrip_friction *start,
                                  uint32_t parameters,
                                  const struct kstrip_options *options,
                                  struct kstrip_friction_fit *fit,
                                  uint32_t *first_bad);

/** @} */

/**
 * @defgroup kstrip_rest Options, upper body, version
 * @{
 */

/** Version of the library, major. */
#define KSTRIP_VERSION_MAJOR 0
/** Version of the library, minor. */
#define KSTRIP_VERSION_MINOR 2
/** Version of the library, patch. */
#define KSTRIP_VERSION_PATCH 0

/** Changes whenever a structure or function changes incompatibly. */
#define KSTRIP_ABI_VERSION 1

/**
 * Fill options with zero, the defaults: KSTRIP_MODEL_DEFAULT and 16 strips.
 * kstrip_options o = {0} does the same.
 *
 * @param[out] options  receives the defaults.
 * @return KSTRIP_OK, or KSTRIP_ERROR_NULL if options is NULL.
 */
kstrip_status kstrip_options_init(struct kstrip_options *options);

/**
 * The result on the upper body: opposite forces and moment, same power and adhesion.
 *
 * @param lower           result on the lower body.
 * @param[out] upper      receives the result on the upper body.
 * @return KSTRIP_OK, or KSTRIP_ERROR_NULL if lower or upper is NULL.
 */
kstrip_status kstrip_result_on_upper_body(const struct kstrip_result *lower,
                                          struct kstrip_result *upper);

/** Version of the library that is linked, such as "0.2.0". Never NULL. */
const char *kstrip_version_string(void);

/** ABI version of the library that is linked: compare with KSTRIP_ABI_VERSION of the header. */
int32_t kstrip_abi_version(void);

/** @} */

#ifdef __cplusplus
} // extern "C"
#endif

#endif /* KSTRIP_H */
