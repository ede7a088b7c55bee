/**
 * @file kstrip.h
 * kstrip: creep forces of rolling contact by Kalker's strip theory.
 *
 * Generated from the Rust sources by cbindgen; do not edit.
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
 * ## Conventions
 *
 * - Every function returns a kstrip_status: 0 is success, > 0 a warning with valid outputs, < 0 an
 *   error with outputs untouched. kstrip_status_string() says what to change.
 * - NULL, NaN, infinities and any other numbers are safe inputs. Pointers must be NULL or valid and
 *   aligned; arrays must have as many elements as their count says. Outputs must not overlap inputs.
 * - No function allocates, blocks, keeps state, or calls back: all may be used from any thread and
 *   from interrupt handlers. Stack use: docs/embedded.md.
 * - Functions and types with the suffix _f32 are the same in single precision.
 * - Same inputs, same bits: on every machine with IEEE arithmetic, in every thread.
 */


#ifndef KSTRIP_H
#define KSTRIP_H

#include <stddef.h>
#include <stdint.h>

/**
 * The strip theory of 1967 with the sliding rule that the paper keeps for forces: strips without
 * adhesion slide along the rigid slip of their centre line. For spin |psi| < 1.
 */
#define KSTRIP_MODEL_STRIP_1967 1

/**
 * The strip theory of 1967 with the sliding rule that joins adhesion strips without a jump.
 */
#define KSTRIP_MODEL_STRIP_1967_CONTINUOUS 2

/**
 * Strips that follow the slip, corrected to the slopes of Kalker's linear theory, for any spin:
 * forces, moment, stick area and fields. Mean error against CONTACT 0.7 % of mu N. The default.
 *
 * The moment is the weakest figure. On ellipses longer than wide, a/b > 5, that roll with hardly more than spin, it can have
 * the wrong sign: by up to 0.02 mu N sqrt(ab) to a/b = 10 (with nu > 0.37), more beyond. The power then is as much below
 * zero. KSTRIP_MODEL_TOTAL never gains energy.
 */
#define KSTRIP_MODEL_STRIP 3

/**
 * Total forces and moment only, most accurate and cheapest; mean error against CONTACT 0.5 % of mu N.
 * No strips, no field; adhesion is reported as -1 (unknown).
 */
#define KSTRIP_MODEL_TOTAL 4

/**
 * Kalker's linear theory, without saturation: for stability analysis. Adhesion is 1.
 */
#define KSTRIP_MODEL_LINEAR 5

/**
 * Wanted from kstrip_evaluate(): the forces (always computed).
 */
#define KSTRIP_WANT_FORCES 1

/**
 * Wanted: the moment, and the power, which contains it.
 */
#define KSTRIP_WANT_MOMENT 2

/**
 * Wanted: the share in adhesion.
 */
#define KSTRIP_WANT_ADHESION 4

/**
 * Wanted: the derivatives with respect to the creepages.
 */
#define KSTRIP_WANT_JACOBIAN 8

/**
 * Wanted: the strips.
 */
#define KSTRIP_WANT_STRIPS 16

/**
 * The longitudinal force was measured.
 */
#define KSTRIP_MEASURED_FX 1

/**
 * The lateral force was measured.
 */
#define KSTRIP_MEASURED_FY 2

/**
 * State of a point: outside the contact.
 */
#define KSTRIP_STATE_OUTSIDE 0

/**
 * State of a point: adhesion, no slip.
 */
#define KSTRIP_STATE_STICK 1

/**
 * State of a point: slip.
 */
#define KSTRIP_STATE_SLIP 2

/**
 * State of a point: slip against the traction (negative local dissipation), the strip theory's
 * error next to the leading edge of sliding strips.
 */
#define KSTRIP_STATE_SLIP_NEGATIVE_DISSIPATION 3

/**
 * Upper bound of the number of strips that kstrip_strips() writes for `strips` strips.
 */
#define KSTRIP_STRIPS_CAPACITY 320

/**
 * Strips that a kstrip_patch has room for.
 */
#define KSTRIP_PATCH_CAPACITY 64

/**
 * Version of the library, major.
 */
#define KSTRIP_VERSION_MAJOR 0

/**
 * Version of the library, minor.
 */
#define KSTRIP_VERSION_MINOR 1

/**
 * Version of the library, patch.
 */
#define KSTRIP_VERSION_PATCH 0

/**
 * Changes whenever a structure or function changes incompatibly.
 */
#define KSTRIP_ABI_VERSION 1

/**
 * Strips of the theory of 1967 at most, corrections beyond unit spin included.
 */
#define MOST_STRIPS_1967 320

/**
 * Result of a call: 0 ok; > 0 warning, outputs valid; < 0 error, outputs untouched.
 */
typedef int32_t kstrip_status;

/**
 * Which model, and with how many strips. Fill with kstrip_options_init().
 */
typedef struct kstrip_options {
    /**
     * One of the KSTRIP_MODEL constants.
     */
    int32_t model;
    /**
     * Number of strips: 4, 8, 16, 32 or 64. Ignored by models without strips, but checked.
     */
    int32_t strips;
} kstrip_options;

/**
 * An isotropic elastic body.
 */
typedef struct kstrip_material {
    /**
     * Shear modulus G [Pa], > 0. Steel: 82e9.
     */
    double shear_modulus;
    /**
     * Poisson's ratio [-], 0 to 0.5. Steel: 0.28.
     */
    double poisson_ratio;
} kstrip_material;

/**
 * The combined elastic constants of two bodies: what the contact sees.
 */
typedef struct kstrip_combined_material {
    /**
     * Combined shear modulus G [Pa], 1/G = (1/G_lower + 1/G_upper)/2.
     */
    double shear_modulus;
    /**
     * Combined Poisson's ratio [-], nu/G = (nu_lower/G_lower + nu_upper/G_upper)/2.
     */
    double poisson_ratio;
    /**
     * Mismatch kappa [-] of the two materials, which the theory neglects: 0 for like materials; an
     * error of a few per cent is to be expected at 0.06 (steel on aluminium).
     */
    double mismatch;
} kstrip_combined_material;

/**
 * Radii of curvature of two bodies at the contact [m]: convex positive, flat infinite (INFINITY),
 * concave negative. Zero and NaN are errors.
 */
typedef struct kstrip_radii {
    /**
     * Lower body in the plane of x and z (a straight rail: INFINITY).
     */
    double lower_x;
    /**
     * Lower body in the plane of y and z (a rail: radius of the head).
     */
    double lower_y;
    /**
     * Upper body in the plane of x and z (a wheel: rolling radius).
     */
    double upper_x;
    /**
     * Upper body in the plane of y and z (a wheel: radius of the profile, INFINITY if conical).
     */
    double upper_y;
} kstrip_radii;

/**
 * The contact ellipse of Hertz.
 */
typedef struct kstrip_hertz_contact {
    /**
     * Semi-axis along the rolling direction x [m].
     */
    double a;
    /**
     * Semi-axis along y [m].
     */
    double b;
    /**
     * Pressure at the centre [Pa].
     */
    double peak_pressure;
    /**
     * Approach of distant points of the two bodies [m].
     */
    double approach;
    /**
     * Minor over major semi-axis [-], 0 to 1.
     */
    double axis_ratio;
    /**
     * Hertz's angle tau [rad], 0 to pi/2.
     */
    double hertz_angle;
    /**
     * Four over the sum of the four curvatures [m].
     */
    double rho;
} kstrip_hertz_contact;

/**
 * Velocity of a body's surface at the centre of the contact, seen from the contact.
 */
typedef struct kstrip_velocity {
    /**
     * Along the rolling direction x [m/s]; about minus the rolling speed for both bodies.
     */
    double x;
    /**
     * Along y [m/s].
     */
    double y;
    /**
     * Angular velocity about z [rad/s].
     */
    double angular_z;
} kstrip_velocity;

/**
 * Rigid slip of the upper over the lower body, divided by the rolling speed.
 */
typedef struct kstrip_creepage {
    /**
     * Longitudinal creepage [-], positive when the upper body slides in the rolling direction.
     */
    double longitudinal;
    /**
     * Lateral creepage [-], positive along y.
     */
    double lateral;
    /**
     * Spin [1/m], positive from x to y (about z).
     */
    double spin;
} kstrip_creepage;

/**
 * A loaded elliptic contact with Coulomb friction.
 */
typedef struct kstrip_contact {
    /**
     * Semi-axis along the rolling direction x [m], > 0.
     */
    double a;
    /**
     * Semi-axis along y [m], > 0.
     */
    double b;
    /**
     * Normal force N [N], >= 0.
     */
    double normal_force;
    /**
     * Combined shear modulus G [Pa], > 0.
     */
    double shear_modulus;
    /**
     * Combined Poisson's ratio [-], 0 to 0.5.
     */
    double poisson_ratio;
    /**
     * Coefficient of friction mu [-], >= 0.
     */
    double friction;
} kstrip_contact;

/**
 * Kalker's parameters (5.13) of a contact in motion, dimensionless.
 */
typedef struct kstrip_parameters {
    /**
     * xi = longitudinal G/(2 (1 - nu) mu p0)
     */
    double xi;
    /**
     * eta = lateral G/(2 mu p0)
     */
    double eta;
    /**
     * psi = a spin G/(2 mu p0). The theory of 1967 is valid for |psi| < 1.
     */
    double psi;
} kstrip_parameters;

/**
 * Forces on the lower body.
 */
typedef struct kstrip_result {
    /**
     * Longitudinal force [N].
     */
    double fx;
    /**
     * Lateral force [N].
     */
    double fy;
    /**
     * Moment about z at the centre of the contact [N m].
     */
    double mz;
    /**
     * Frictional power over rolling speed, fx longitudinal + fy lateral + mz spin [N]: energy
     * dissipated per metre rolled.
     */
    double power;
    /**
     * Share of the contact area in adhesion [-], 0 to 1. KSTRIP_MODEL_TOTAL does not know it: -1.
     */
    double adhesion;
    /**
     * The status of this result: 0 or one of the KSTRIP_WARNING constants.
     */
    int32_t status_detail;
    /**
     * Zero.
     */
    int32_t reserved;
} kstrip_result;

/**
 * One strip y = const of the contact: what it carries, on the lower body.
 */
typedef struct kstrip_strip {
    /**
     * Centre line [m].
     */
    double y;
    /**
     * Width that the strip stands for [m].
     */
    double width;
    /**
     * Half of its length along x [m].
     */
    double half_length;
    /**
     * x of the separatrix [m]: slip behind it, adhesion ahead of it. Equal to half_length when the
     * whole strip slides.
     */
    double separatrix;
    /**
     * Its share of the longitudinal force [N].
     */
    double fx;
    /**
     * Its share of the lateral force [N].
     */
    double fy;
    /**
     * Its share of the moment about the centre of the contact [N m].
     */
    double mz;
    /**
     * Its share of the frictional power [N].
     */
    double power;
    /**
     * KSTRIP_STATE_STICK if it has an adhesion area, else KSTRIP_STATE_SLIP.
     */
    int32_t state;
    /**
     * Zero.
     */
    int32_t reserved;
} kstrip_strip;

/**
 * The state of a point of the contact plane. Tractions act on the lower body.
 */
typedef struct kstrip_point {
    /**
     * Pressure [Pa].
     */
    double pressure;
    /**
     * Tangential traction along x [Pa].
     */
    double traction_x;
    /**
     * Tangential traction along y [Pa].
     */
    double traction_y;
    /**
     * Slip of the upper over the lower body along x, over the rolling speed [-].
     */
    double slip_x;
    /**
     * Slip along y, over the rolling speed [-].
     */
    double slip_y;
    /**
     * traction . slip [Pa]: energy dissipated per area and metre rolled.
     */
    double dissipation;
    /**
     * One of the KSTRIP_STATE constants.
     */
    int32_t state;
    /**
     * Zero.
     */
    int32_t reserved;
} kstrip_point;

/**
 * One strip of a patch, along the rolling direction. Its pressure is a half-ellipse in x,
 * p = peak_pressure sqrt(1 - (x - centre_x)^2/half_length^2), and does not vary over its width.
 */
typedef struct kstrip_patch_strip {
    /**
     * Centre line y [m].
     */
    double y;
    /**
     * Width [m], > 0.
     */
    double width;
    /**
     * Half length along x [m], > 0.
     */
    double half_length;
    /**
     * Centre along x [m]; 0 for most contacts.
     */
    double centre_x;
    /**
     * Pressure at the centre [Pa], >= 0.
     */
    double peak_pressure;
    /**
     * Coefficient of friction [-], >= 0. May be changed from strip to strip after a patch is built.
     */
    double friction;
} kstrip_patch_strip;

/**
 * A contact patch of any shape: its strips, in ascending y. Filled by kstrip_patch_from_ellipse(),
 * kstrip_patch_from_strips() or kstrip_patch_from_profile(); the members may then be changed.
 * All functions check it again.
 *
 * Where the distance of two neighbours is more than one and a half times that at which they touch,
 * there is a gap: what lies on either side is a lobe of its own.
 */
typedef struct kstrip_patch {
    /**
     * The strips; the first count are used.
     */
    struct kstrip_patch_strip strips[KSTRIP_PATCH_CAPACITY];
    /**
     * Combined shear modulus G [Pa], > 0.
     */
    double shear_modulus;
    /**
     * Combined Poisson's ratio [-], 0 to 0.5.
     */
    double poisson_ratio;
    /**
     * Factor [-], > 0, that makes the sum of the strips' areas the patch's area: 1 unless the strips
     * are a quadrature rule (kstrip_patch_from_ellipse()).
     */
    double area_scale;
    /**
     * The same for the moment of the area about x, the sum of y^2 times area.
     */
    double lever_scale;
    /**
     * Number of strips, 0 to KSTRIP_PATCH_CAPACITY. None: no load.
     */
    uint32_t count;
    /**
     * Zero.
     */
    uint32_t reserved;
} kstrip_patch;

/**
 * What presses two profiles together.
 */
typedef struct kstrip_profile_contact {
    /**
     * Rolling radius [m], > 0; of two rolling bodies 1/R = 1/R_lower + 1/R_upper.
     */
    double rolling_radius;
    /**
     * Normal force [N], >= 0.
     */
    double normal_force;
    /**
     * Combined shear modulus G [Pa], > 0.
     */
    double shear_modulus;
    /**
     * Combined Poisson's ratio [-], 0 to 0.5.
     */
    double poisson_ratio;
    /**
     * Coefficient of friction of every strip [-], >= 0.
     */
    double friction;
} kstrip_profile_contact;

/**
 * How two profiles meet under a load.
 */
typedef struct kstrip_profile_result {
    /**
     * Approach of distant points of the two bodies [m].
     */
    double penetration;
    /**
     * Largest pressure [Pa], at the deepest point.
     */
    double peak_pressure;
    /**
     * Normal force reached [N]: the one asked for, to rounding.
     */
    double normal_force;
    /**
     * y of the deepest point [m].
     */
    double deepest_y;
    /**
     * Evaluations of the load, at most 60.
     */
    uint32_t iterations;
    /**
     * Zero.
     */
    uint32_t reserved;
} kstrip_profile_result;

/**
 * What a patch carries.
 */
typedef struct kstrip_patch_summary {
    /**
     * Normal force [N].
     */
    double normal_force;
    /**
     * Sum of friction times load over the strips [N]: no tangential force exceeds it.
     */
    double friction_bound;
    /**
     * Contact area [m^2].
     */
    double area;
    /**
     * Number of lobes.
     */
    uint32_t lobes;
    /**
     * Zero.
     */
    uint32_t reserved;
} kstrip_patch_summary;

/**
 * A loaded elliptic contact with Coulomb friction.
 */
typedef struct kstrip_contact_f32 {
    /**
     * Semi-axis along the rolling direction x [m], > 0.
     */
    float a;
    /**
     * Semi-axis along y [m], > 0.
     */
    float b;
    /**
     * Normal force N [N], >= 0.
     */
    float normal_force;
    /**
     * Combined shear modulus G [Pa], > 0.
     */
    float shear_modulus;
    /**
     * Combined Poisson's ratio [-], 0 to 0.5.
     */
    float poisson_ratio;
    /**
     * Coefficient of friction mu [-], >= 0.
     */
    float friction;
} kstrip_contact_f32;

/**
 * kstrip_patch_strip in single precision.
 */
typedef struct kstrip_patch_strip_f32 {
    /**
     * Centre line y [m].
     */
    float y;
    /**
     * Width [m], > 0.
     */
    float width;
    /**
     * Half length along x [m], > 0.
     */
    float half_length;
    /**
     * Centre along x [m]; 0 for most contacts.
     */
    float centre_x;
    /**
     * Pressure at the centre [Pa], >= 0.
     */
    float peak_pressure;
    /**
     * Coefficient of friction [-], >= 0. May be changed from strip to strip after a patch is built.
     */
    float friction;
} kstrip_patch_strip_f32;

/**
 * kstrip_patch in single precision.
 */
typedef struct kstrip_patch_f32 {
    /**
     * The strips; the first count are used.
     */
    struct kstrip_patch_strip_f32 strips[KSTRIP_PATCH_CAPACITY];
    /**
     * Combined shear modulus G [Pa], > 0.
     */
    float shear_modulus;
    /**
     * Combined Poisson's ratio [-], 0 to 0.5.
     */
    float poisson_ratio;
    /**
     * Factor [-], > 0, that makes the sum of the strips' areas the patch's area: 1 unless the strips
     * are a quadrature rule (kstrip_patch_from_ellipse()).
     */
    float area_scale;
    /**
     * The same for the moment of the area about x, the sum of y^2 times area.
     */
    float lever_scale;
    /**
     * Number of strips, 0 to KSTRIP_PATCH_CAPACITY. None: no load.
     */
    uint32_t count;
    /**
     * Zero.
     */
    uint32_t reserved;
} kstrip_patch_f32;

/**
 * kstrip_profile_contact in single precision.
 */
typedef struct kstrip_profile_contact_f32 {
    /**
     * Rolling radius [m], > 0; of two rolling bodies 1/R = 1/R_lower + 1/R_upper.
     */
    float rolling_radius;
    /**
     * Normal force [N], >= 0.
     */
    float normal_force;
    /**
     * Combined shear modulus G [Pa], > 0.
     */
    float shear_modulus;
    /**
     * Combined Poisson's ratio [-], 0 to 0.5.
     */
    float poisson_ratio;
    /**
     * Coefficient of friction of every strip [-], >= 0.
     */
    float friction;
} kstrip_profile_contact_f32;

/**
 * kstrip_profile_result in single precision.
 */
typedef struct kstrip_profile_result_f32 {
    /**
     * Approach of distant points of the two bodies [m].
     */
    float penetration;
    /**
     * Largest pressure [Pa], at the deepest point.
     */
    float peak_pressure;
    /**
     * Normal force reached [N]: the one asked for, to rounding.
     */
    float normal_force;
    /**
     * y of the deepest point [m].
     */
    float deepest_y;
    /**
     * Evaluations of the load, at most 60.
     */
    uint32_t iterations;
    /**
     * Zero.
     */
    uint32_t reserved;
} kstrip_profile_result_f32;

/**
 * kstrip_patch_summary in single precision.
 */
typedef struct kstrip_patch_summary_f32 {
    /**
     * Normal force [N].
     */
    float normal_force;
    /**
     * Sum of friction times load over the strips [N]: no tangential force exceeds it.
     */
    float friction_bound;
    /**
     * Contact area [m^2].
     */
    float area;
    /**
     * Number of lobes.
     */
    uint32_t lobes;
    /**
     * Zero.
     */
    uint32_t reserved;
} kstrip_patch_summary_f32;

/**
 * Rigid slip of the upper over the lower body, divided by the rolling speed.
 */
typedef struct kstrip_creepage_f32 {
    /**
     * Longitudinal creepage [-], positive when the upper body slides in the rolling direction.
     */
    float longitudinal;
    /**
     * Lateral creepage [-], positive along y.
     */
    float lateral;
    /**
     * Spin [1/m], positive from x to y (about z).
     */
    float spin;
} kstrip_creepage_f32;

/**
 * Forces on the lower body.
 */
typedef struct kstrip_result_f32 {
    /**
     * Longitudinal force [N].
     */
    float fx;
    /**
     * Lateral force [N].
     */
    float fy;
    /**
     * Moment about z at the centre of the contact [N m].
     */
    float mz;
    /**
     * Frictional power over rolling speed, fx longitudinal + fy lateral + mz spin [N]: energy
     * dissipated per metre rolled.
     */
    float power;
    /**
     * Share of the contact area in adhesion [-], 0 to 1. KSTRIP_MODEL_TOTAL does not know it: -1.
     */
    float adhesion;
    /**
     * The status of this result: 0 or one of the KSTRIP_WARNING constants.
     */
    int32_t status_detail;
    /**
     * Zero.
     */
    int32_t reserved;
} kstrip_result_f32;

/**
 * One strip y = const of the contact: what it carries, on the lower body.
 */
typedef struct kstrip_strip_f32 {
    /**
     * Centre line [m].
     */
    float y;
    /**
     * Width that the strip stands for [m].
     */
    float width;
    /**
     * Half of its length along x [m].
     */
    float half_length;
    /**
     * x of the separatrix [m]: slip behind it, adhesion ahead of it. Equal to half_length when the
     * whole strip slides.
     */
    float separatrix;
    /**
     * Its share of the longitudinal force [N].
     */
    float fx;
    /**
     * Its share of the lateral force [N].
     */
    float fy;
    /**
     * Its share of the moment about the centre of the contact [N m].
     */
    float mz;
    /**
     * Its share of the frictional power [N].
     */
    float power;
    /**
     * KSTRIP_STATE_STICK if it has an adhesion area, else KSTRIP_STATE_SLIP.
     */
    int32_t state;
    /**
     * Zero.
     */
    int32_t reserved;
} kstrip_strip_f32;

/**
 * The state of a point of the contact plane. Tractions act on the lower body.
 */
typedef struct kstrip_point_f32 {
    /**
     * Pressure [Pa].
     */
    float pressure;
    /**
     * Tangential traction along x [Pa].
     */
    float traction_x;
    /**
     * Tangential traction along y [Pa].
     */
    float traction_y;
    /**
     * Slip of the upper over the lower body along x, over the rolling speed [-].
     */
    float slip_x;
    /**
     * Slip along y, over the rolling speed [-].
     */
    float slip_y;
    /**
     * traction . slip [Pa]: energy dissipated per area and metre rolled.
     */
    float dissipation;
    /**
     * One of the KSTRIP_STATE constants.
     */
    int32_t state;
    /**
     * Zero.
     */
    int32_t reserved;
} kstrip_point_f32;

/**
 * An isotropic elastic body, single precision.
 */
typedef struct kstrip_material_f32 {
    /**
     * Shear modulus G [Pa], > 0. Steel: 82e9.
     */
    float shear_modulus;
    /**
     * Poisson's ratio [-], 0 to 0.5. Steel: 0.28.
     */
    float poisson_ratio;
} kstrip_material_f32;

/**
 * The combined elastic constants of two bodies: what the contact sees.
 */
typedef struct kstrip_combined_material_f32 {
    /**
     * Combined shear modulus G [Pa], 1/G = (1/G_lower + 1/G_upper)/2.
     */
    float shear_modulus;
    /**
     * Combined Poisson's ratio [-], nu/G = (nu_lower/G_lower + nu_upper/G_upper)/2.
     */
    float poisson_ratio;
    /**
     * Mismatch kappa [-] of the two materials, which the theory neglects: 0 for like materials; an
     * error of a few per cent is to be expected at 0.06 (steel on aluminium).
     */
    float mismatch;
} kstrip_combined_material_f32;

/**
 * Radii of curvature of two bodies at the contact [m]: convex positive, flat infinite (INFINITY),
 * concave negative. Zero and NaN are errors.
 */
typedef struct kstrip_radii_f32 {
    /**
     * Lower body in the plane of x and z (a straight rail: INFINITY).
     */
    float lower_x;
    /**
     * Lower body in the plane of y and z (a rail: radius of the head).
     */
    float lower_y;
    /**
     * Upper body in the plane of x and z (a wheel: rolling radius).
     */
    float upper_x;
    /**
     * Upper body in the plane of y and z (a wheel: radius of the profile, INFINITY if conical).
     */
    float upper_y;
} kstrip_radii_f32;

/**
 * The contact ellipse of Hertz.
 */
typedef struct kstrip_hertz_contact_f32 {
    /**
     * Semi-axis along the rolling direction x [m].
     */
    float a;
    /**
     * Semi-axis along y [m].
     */
    float b;
    /**
     * Pressure at the centre [Pa].
     */
    float peak_pressure;
    /**
     * Approach of distant points of the two bodies [m].
     */
    float approach;
    /**
     * Minor over major semi-axis [-], 0 to 1.
     */
    float axis_ratio;
    /**
     * Hertz's angle tau [rad], 0 to pi/2.
     */
    float hertz_angle;
    /**
     * Four over the sum of the four curvatures [m].
     */
    float rho;
} kstrip_hertz_contact_f32;

/**
 * Velocity of a body's surface at the centre of the contact, seen from the contact.
 */
typedef struct kstrip_velocity_f32 {
    /**
     * Along the rolling direction x [m/s]; about minus the rolling speed for both bodies.
     */
    float x;
    /**
     * Along y [m/s].
     */
    float y;
    /**
     * Angular velocity about z [rad/s].
     */
    float angular_z;
} kstrip_velocity_f32;

/**
 * Kalker's parameters (5.13) of a contact in motion, dimensionless.
 */
typedef struct kstrip_parameters_f32 {
    /**
     * xi = longitudinal G/(2 (1 - nu) mu p0)
     */
    float xi;
    /**
     * eta = lateral G/(2 mu p0)
     */
    float eta;
    /**
     * psi = a spin G/(2 mu p0). The theory of 1967 is valid for |psi| < 1.
     */
    float psi;
} kstrip_parameters_f32;

/**
 * Contacts and creepages as one array for each quantity.
 *
 * Arrays of as many elements as there are contacts; none may be NULL unless there are no contacts.
 */
typedef struct kstrip_batch_inputs {
    /**
     * Semi-axes along the rolling direction x [m], > 0.
     */
    const double *a;
    /**
     * Semi-axes along y [m], > 0.
     */
    const double *b;
    /**
     * Normal forces N [N], >= 0.
     */
    const double *normal_force;
    /**
     * Combined shear moduli G [Pa], > 0.
     */
    const double *shear_modulus;
    /**
     * Combined Poisson's ratios [-], 0 to 0.5.
     */
    const double *poisson_ratio;
    /**
     * Coefficients of friction mu [-], >= 0.
     */
    const double *friction;
    /**
     * Longitudinal creepages [-].
     */
    const double *longitudinal;
    /**
     * Lateral creepages [-].
     */
    const double *lateral;
    /**
     * Spins [1/m].
     */
    const double *spin;
} kstrip_batch_inputs;

/**
 * Where the results of many contacts go, one array for each quantity.
 *
 * Arrays of as many elements as there are contacts; NULL for what is not wanted.
 */
typedef struct kstrip_batch_outputs {
    /**
     * Longitudinal forces on the lower bodies [N].
     */
    double *fx;
    /**
     * Lateral forces [N].
     */
    double *fy;
    /**
     * Moments about z at the centres of the contacts [N m].
     */
    double *mz;
    /**
     * Frictional powers over rolling speed [N].
     */
    double *power;
    /**
     * Shares of the contact areas in adhesion [-], 0 to 1, or -1 for unknown.
     */
    double *adhesion;
    /**
     * The status of each result: 0 or one of the KSTRIP_WARNING constants.
     */
    int32_t *status_detail;
} kstrip_batch_outputs;

/**
 * Contacts and creepages as one array for each quantity, single precision.
 *
 * Arrays of as many elements as there are contacts; none may be NULL unless there are no contacts.
 */
typedef struct kstrip_batch_inputs_f32 {
    /**
     * Semi-axes along the rolling direction x [m], > 0.
     */
    const float *a;
    /**
     * Semi-axes along y [m], > 0.
     */
    const float *b;
    /**
     * Normal forces N [N], >= 0.
     */
    const float *normal_force;
    /**
     * Combined shear moduli G [Pa], > 0.
     */
    const float *shear_modulus;
    /**
     * Combined Poisson's ratios [-], 0 to 0.5.
     */
    const float *poisson_ratio;
    /**
     * Coefficients of friction mu [-], >= 0.
     */
    const float *friction;
    /**
     * Longitudinal creepages [-].
     */
    const float *longitudinal;
    /**
     * Lateral creepages [-].
     */
    const float *lateral;
    /**
     * Spins [1/m].
     */
    const float *spin;
} kstrip_batch_inputs_f32;

/**
 * Where the results of many contacts go, one array for each quantity, single precision.
 *
 * Arrays of as many elements as there are contacts; NULL for what is not wanted.
 */
typedef struct kstrip_batch_outputs_f32 {
    /**
     * Longitudinal forces on the lower bodies [N].
     */
    float *fx;
    /**
     * Lateral forces [N].
     */
    float *fy;
    /**
     * Moments about z at the centres of the contacts [N m].
     */
    float *mz;
    /**
     * Frictional powers over rolling speed [N].
     */
    float *power;
    /**
     * Shares of the contact areas in adhesion [-], 0 to 1, or -1 for unknown.
     */
    float *adhesion;
    /**
     * The status of each result: 0 or one of the KSTRIP_WARNING constants.
     */
    int32_t *status_detail;
} kstrip_batch_outputs_f32;

/**
 * Derivatives of fx, fy, mz with respect to creepages, load and friction.
 */
typedef struct kstrip_derivatives {
    /**
     * d(fx, fy, mz)/d(longitudinal, lateral, spin), row by row [N, N, N m over 1, 1, 1/m].
     */
    double jacobian[9];
    /**
     * d(fx, fy, mz)/d(normal_force) at fixed a and b [-, -, m].
     */
    double normal_force[3];
    /**
     * d(fx, fy, mz)/d(friction) [N, N, N m].
     */
    double friction[3];
    /**
     * d(fx, fy, mz)/d(normal_force) while a and b follow the load as Hertz says: both grow like its
     * cube root in a contact of given curvatures [-, -, m].
     */
    double load_through_hertz[3];
} kstrip_derivatives;

/**
 * Derivatives of fx, fy, mz with respect to creepages, load and friction, single precision.
 */
typedef struct kstrip_derivatives_f32 {
    /**
     * d(fx, fy, mz)/d(longitudinal, lateral, spin), row by row [N, N, N m over 1, 1, 1/m].
     */
    float jacobian[9];
    /**
     * d(fx, fy, mz)/d(normal_force) at fixed a and b [-, -, m].
     */
    float normal_force[3];
    /**
     * d(fx, fy, mz)/d(friction) [N, N, N m].
     */
    float friction[3];
    /**
     * d(fx, fy, mz)/d(normal_force) while a and b follow the load as Hertz says: both grow like its
     * cube root in a contact of given curvatures [-, -, m].
     */
    float load_through_hertz[3];
} kstrip_derivatives_f32;

/**
 * Friction that falls with the slip, friction ((1 - ratio) exp(-decay w) + ratio) with the sliding
 * velocity w [m/s], and the stiffness of the layer between the bodies.
 *
 * Polach, Wear 258 (2005) 992, gives for locomotives: dry friction 0.55, ratio 0.4, decay 0.6 s/m; wet 0.3,
 * 0.4, 0.2 s/m.
 */
typedef struct kstrip_friction {
    /**
     * Coefficient of friction without slip [-], >= 0.
     */
    double friction;
    /**
     * Friction at infinite sliding velocity over that at none [-], 0 to 1; 1: friction is constant.
     */
    double ratio;
    /**
     * How fast friction falls [s/m], >= 0; 0: friction is constant.
     */
    double decay;
    /**
     * Rolling speed [m/s], >= 0: sliding velocity is slip times rolling speed.
     */
    double rolling_speed;
    /**
     * Initial slope of the creep curve over that of clean bodies [-], > 0 to 1; 1: clean.
     */
    double slope_factor;
} kstrip_friction;

/**
 * Friction that falls with the slip, and the stiffness of the layer, single precision.
 */
typedef struct kstrip_friction_f32 {
    /**
     * Coefficient of friction without slip [-], >= 0.
     */
    float friction;
    /**
     * Friction at infinite sliding velocity over that at none [-], 0 to 1; 1: friction is constant.
     */
    float ratio;
    /**
     * How fast friction falls [s/m], >= 0; 0: friction is constant.
     */
    float decay;
    /**
     * Rolling speed [m/s], >= 0: sliding velocity is slip times rolling speed.
     */
    float rolling_speed;
    /**
     * Initial slope of the creep curve over that of clean bodies [-], > 0 to 1; 1: clean.
     */
    float slope_factor;
} kstrip_friction_f32;

/**
 * A coefficient of friction from a measured force.
 */
typedef struct kstrip_friction_estimate {
    /**
     * Coefficient of friction [-]; a lower bound with KSTRIP_WARNING_FRICTION_AT_LEAST.
     */
    double friction;
    /**
     * d(friction)/d(force) [1/N]: what an error of the measured force does to it; 0 for a lower bound.
     */
    double sensitivity;
    /**
     * Distance between the measured and the computed force [N], of the components that were measured.
     */
    double residual;
    /**
     * The status of this result: 0 or one of the KSTRIP_WARNING constants.
     */
    int32_t status_detail;
    /**
     * Zero.
     */
    int32_t reserved;
} kstrip_friction_estimate;

/**
 * A coefficient of friction from a measured force, single precision.
 */
typedef struct kstrip_friction_estimate_f32 {
    /**
     * Coefficient of friction [-]; a lower bound with KSTRIP_WARNING_FRICTION_AT_LEAST.
     */
    float friction;
    /**
     * d(friction)/d(force) [1/N]: what an error of the measured force does to it; 0 for a lower bound.
     */
    float sensitivity;
    /**
     * Distance between the measured and the computed force [N], of the components that were measured.
     */
    float residual;
    /**
     * The status of this result: 0 or one of the KSTRIP_WARNING constants.
     */
    int32_t status_detail;
    /**
     * Zero.
     */
    int32_t reserved;
} kstrip_friction_estimate_f32;

/**
 * Success.
 */
#define KSTRIP_OK 0

/**
 * Warning: spin parameter |psi| >= 1, beyond the theory of 1967. The result is its continuation:
 * finite, continuous, bounded by mu N.
 */
#define KSTRIP_WARNING_SPIN 1

/**
 * Warning: an input is outside the range in which the model was checked against its reference.
 */
#define KSTRIP_WARNING_RANGE 2

/**
 * Warning: the linear force exceeds mu N.
 */
#define KSTRIP_WARNING_BEYOND_FRICTION 3

/**
 * Warning: more than one coefficient of friction fits. Under falling friction the result has the largest,
 * which is reached from adhesion; an estimate from a measured force is the smallest.
 */
#define KSTRIP_WARNING_SEVERAL_FRICTIONS 4

/**
 * Warning: a bounded iteration ended before its result was accurate to rounding.
 */
#define KSTRIP_WARNING_NOT_CONVERGED 5

/**
 * Warning: the contact sticks, and the measured force tells only a lower bound of friction.
 */
#define KSTRIP_WARNING_FRICTION_AT_LEAST 6

/**
 * Warning: the wanted force is that of full sliding, which every larger creepage gives as well.
 */
#define KSTRIP_WARNING_CREEPAGE_AT_LEAST 7

/**
 * Error: a required pointer is NULL.
 */
#define KSTRIP_ERROR_NULL -1

/**
 * Error: an input is infinite or NaN.
 */
#define KSTRIP_ERROR_NOT_FINITE -2

/**
 * Error: a semi-axis is not positive.
 */
#define KSTRIP_ERROR_SEMI_AXIS -3

/**
 * Error: the normal force is negative.
 */
#define KSTRIP_ERROR_NORMAL_FORCE -4

/**
 * Error: a modulus of elasticity is not positive.
 */
#define KSTRIP_ERROR_MODULUS -5

/**
 * Error: Poisson's ratio is outside [0, 0.5].
 */
#define KSTRIP_ERROR_POISSON_RATIO -6

/**
 * Error: the coefficient of friction is negative.
 */
#define KSTRIP_ERROR_FRICTION -7

/**
 * Error: unknown model.
 */
#define KSTRIP_ERROR_MODEL -8

/**
 * Error: the strip count is not 4, 8, 16, 32 or 64.
 */
#define KSTRIP_ERROR_STRIP_COUNT -9

/**
 * Error: the bodies do not touch in an ellipse.
 */
#define KSTRIP_ERROR_CURVATURE -10

/**
 * Error: the rolling speed is not positive.
 */
#define KSTRIP_ERROR_ROLLING_SPEED -11

/**
 * Error: the caller's array is too small.
 */
#define KSTRIP_ERROR_CAPACITY -12

/**
 * Error: the model has totals only, no strips and no field.
 */
#define KSTRIP_ERROR_NOT_IN_MODEL -13

/**
 * Error: a result is beyond the range of the floating-point type.
 */
#define KSTRIP_ERROR_OVERFLOW -14

/**
 * Error: the ratio of falling friction is outside [0, 1].
 */
#define KSTRIP_ERROR_FRICTION_RATIO -15

/**
 * Error: the decay of falling friction is negative.
 */
#define KSTRIP_ERROR_FRICTION_DECAY -16

/**
 * Error: the rolling speed of falling friction is negative.
 */
#define KSTRIP_ERROR_NEGATIVE_SPEED -17

/**
 * Error: the factor of the initial slope is outside (0, 1].
 */
#define KSTRIP_ERROR_SLOPE_FACTOR -18

/**
 * Error: no friction explains the measured force.
 */
#define KSTRIP_ERROR_UNEXPLAINED -19

/**
 * Error: the wanted force exceeds mu N.
 */
#define KSTRIP_ERROR_FORCE_BEYOND_FRICTION -20

/**
 * Error: what was measured is not one of KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY, or their sum.
 */
#define KSTRIP_ERROR_MEASURED -21

/**
 * Error: what is wanted has a flag that is none of the KSTRIP_WANT constants.
 */
#define KSTRIP_ERROR_WANTED -22

/**
 * Error: a strip of a patch has a width or half length that is not positive.
 */
#define KSTRIP_ERROR_STRIP_SIZE -40

/**
 * Error: the peak pressure of a strip is negative.
 */
#define KSTRIP_ERROR_PRESSURE -41

/**
 * Error: strips of a patch overlap, or do not ascend in y.
 */
#define KSTRIP_ERROR_STRIP_ORDER -42

/**
 * Error: more strips, or more separate zones of contact, than the patch has room for.
 */
#define KSTRIP_ERROR_PATCH_SIZE -43

/**
 * Error: a profile has fewer than three points, or its y does not ascend.
 */
#define KSTRIP_ERROR_PROFILE -44

/**
 * Error: the contact reaches the end of the profile.
 */
#define KSTRIP_ERROR_PROFILE_END -45

/**
 * Error: a rolling radius is not positive.
 */
#define KSTRIP_ERROR_ROLLING_RADIUS -46



#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/**
 * What a status means and what the caller must change, in English.
 *
 * Returns a static string; for a number that is no status, "unknown status". Never NULL.
 */
const char *kstrip_status_string(kstrip_status status);

/**
 * Version of the library that is linked, such as "0.1.0". Never NULL.
 */
const char *kstrip_version_string(void);

/**
 * ABI version of the library that is linked: compare with KSTRIP_ABI_VERSION of the header.
 */
int32_t kstrip_abi_version(void);

/**
 * Fill in the recommended model and strip count.
 *
 * @param[out] options  receives the defaults.
 * @return KSTRIP_OK or KSTRIP_ERROR_NULL.
 */
kstrip_status kstrip_options_init(struct kstrip_options *options);

/**
 * Material from Young's modulus: G = E/(2 (1 + nu)).
 *
 * @param youngs_modulus  E [Pa], > 0.
 * @param poisson_ratio   nu [-], 0 to 0.5.
 * @param[out] material   receives the material.
 * @return KSTRIP_OK, KSTRIP_ERROR_NULL, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_MODULUS,
 *         KSTRIP_ERROR_POISSON_RATIO.
 */
kstrip_status kstrip_material_from_youngs_modulus(double youngs_modulus,
                                                  double poisson_ratio,
                                                  struct kstrip_material *material);

/**
 * Combine the elastic constants of two bodies.
 *
 * @param lower, upper    the two bodies.
 * @param[out] combined   receives the constants that kstrip_hertz() and kstrip_contact take.
 * @return KSTRIP_OK, KSTRIP_ERROR_NULL, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_MODULUS,
 *         KSTRIP_ERROR_POISSON_RATIO, KSTRIP_ERROR_OVERFLOW.
 */
kstrip_status kstrip_material_combine(const struct kstrip_material *lower,
                                      const struct kstrip_material *upper,
                                      struct kstrip_combined_material *combined);

/**
 * Contact ellipse, peak pressure and approach of two bodies pressed together (Hertz).
 *
 * Relative error below 1e-12 (5e-6 in single precision) for axis ratios down to 1e-4; a handful of
 * iterations, at most 12. Without load the ellipse is a point, a = b = 0.
 *
 * @param radii           curvatures of both bodies.
 * @param normal_force    N [N], >= 0.
 * @param material        combined constants.
 * @param[out] ellipse    receives the solution.
 * @return KSTRIP_OK, KSTRIP_ERROR_NULL, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_NORMAL_FORCE,
 *         KSTRIP_ERROR_MODULUS, KSTRIP_ERROR_POISSON_RATIO, KSTRIP_ERROR_CURVATURE,
 *         KSTRIP_ERROR_OVERFLOW.
 */
kstrip_status kstrip_hertz(const struct kstrip_radii *radii,
                           double normal_force,
                           const struct kstrip_combined_material *material,
                           struct kstrip_hertz_contact *ellipse);

/**
 * Creepages from the velocities of both bodies: (upper - lower)/rolling_speed.
 *
 * @param lower, upper    surface velocities at the centre of the contact, in one frame.
 * @param rolling_speed   V [m/s], > 0; x points in the rolling direction.
 * @param[out] creepage   receives the creepages.
 * @return KSTRIP_OK, KSTRIP_ERROR_NULL, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_ROLLING_SPEED,
 *         KSTRIP_ERROR_OVERFLOW.
 */
kstrip_status kstrip_creepage_from_velocities(const struct kstrip_velocity *lower,
                                              const struct kstrip_velocity *upper,
                                              double rolling_speed,
                                              struct kstrip_creepage *creepage);

/**
 * Kalker's dimensionless parameters xi, eta, psi (5.13) of a contact in motion.
 *
 * @return KSTRIP_OK or the errors of kstrip_solve() for the same contact and creepage.
 */
kstrip_status kstrip_parameters_from_creepage(const struct kstrip_contact *contact,
                                              const struct kstrip_creepage *creepage,
                                              struct kstrip_parameters *parameters);

/**
 * The creepage that has the given parameters xi, eta, psi on a contact: the inverse of
 * kstrip_parameters_from_creepage().
 *
 * @return KSTRIP_OK, KSTRIP_ERROR_NULL, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_OVERFLOW or the errors
 *         of kstrip_solve() for the same contact.
 */
kstrip_status kstrip_creepage_from_parameters(const struct kstrip_contact *contact,
                                              const struct kstrip_parameters *parameters,
                                              struct kstrip_creepage *creepage);

/**
 * Forces of a contact in motion, on the lower body.
 *
 * Continuous in all inputs; |F| <= mu N. Zero creepage and spin give zero; no load or no friction
 * give zero. Bounded time, no iteration that depends on convergence alone.
 *
 * @param contact         ellipse, load, material, friction.
 * @param creepage        motion.
 * @param options         model and strip count; NULL for the defaults.
 * @param[out] result     receives forces, moment, power and stick area.
 * @return KSTRIP_OK; KSTRIP_WARNING_SPIN, KSTRIP_WARNING_RANGE, KSTRIP_WARNING_BEYOND_FRICTION;
 *         KSTRIP_ERROR_NULL, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_SEMI_AXIS,
 *         KSTRIP_ERROR_NORMAL_FORCE, KSTRIP_ERROR_MODULUS, KSTRIP_ERROR_POISSON_RATIO,
 *         KSTRIP_ERROR_FRICTION, KSTRIP_ERROR_MODEL, KSTRIP_ERROR_STRIP_COUNT,
 *         KSTRIP_ERROR_OVERFLOW.
 */
kstrip_status kstrip_solve(const struct kstrip_contact *contact,
                           const struct kstrip_creepage *creepage,
                           const struct kstrip_options *options,
                           struct kstrip_result *result);

/**
 * Forces and their exact derivatives with respect to the creepages.
 *
 * @param[out] jacobian   receives d(fx, fy, mz)/d(longitudinal, lateral, spin), row by row: nine
 *                        numbers [N, N, N m over 1, 1, 1/m]. At kinks of a model, a one-sided value.
 * @return as kstrip_solve(); KSTRIP_ERROR_OVERFLOW also when a derivative is too large.
 */
kstrip_status kstrip_solve_jacobian(const struct kstrip_contact *contact,
                                    const struct kstrip_creepage *creepage,
                                    const struct kstrip_options *options,
                                    struct kstrip_result *result,
                                    double *jacobian);

/**
 * Forces of many contacts: the same as calling kstrip_solve() for each, bit for bit.
 *
 * All inputs are checked before anything is written: if one is bad its status is returned and no
 * result is touched.
 *
 * @param contacts, creepages  arrays of count elements.
 * @param count           number of contacts; 0 is allowed.
 * @param options         for all contacts; NULL for the defaults.
 * @param[out] results    array of count elements; status_detail tells each one's warning.
 * @return KSTRIP_OK, the largest warning, or the first error, as kstrip_solve().
 */
kstrip_status kstrip_solve_batch(const struct kstrip_contact *contacts,
                                 const struct kstrip_creepage *creepages,
                                 uint32_t count,
                                 const struct kstrip_options *options,
                                 struct kstrip_result *results);

/**
 * What each strip carries. The shares add up to the totals of kstrip_solve().
 *
 * @param[out] strips     array that receives the strips.
 * @param capacity        its size; KSTRIP_STRIPS_CAPACITY is always enough, options->strips is when
 *                        |psi| <= 1.
 * @param[out] count      receives how many were written. A patch that slides as a whole has fewer
 *                        strips than asked for.
 * @return as kstrip_solve(); KSTRIP_ERROR_CAPACITY, KSTRIP_ERROR_NOT_IN_MODEL.
 */
kstrip_status kstrip_strips(const struct kstrip_contact *contact,
                            const struct kstrip_creepage *creepage,
                            const struct kstrip_options *options,
                            struct kstrip_strip *strips,
                            uint32_t capacity,
                            uint32_t *count);

/**
 * Pressure, traction, slip and state at a point of the contact plane.
 *
 * @param x, y            the point [m], from the centre of the ellipse; outside is allowed.
 * @param[out] point      receives the state.
 * @return as kstrip_solve(); KSTRIP_ERROR_NOT_IN_MODEL.
 */
kstrip_status kstrip_traction_at(const struct kstrip_contact *contact,
                                 const struct kstrip_creepage *creepage,
                                 const struct kstrip_options *options,
                                 double x,
                                 double y,
                                 struct kstrip_point *point);

/**
 * Pressure, traction, slip and state over a grid.
 *
 * @param x, columns      array of x [m] and its size.
 * @param y, rows         array of y [m] and its size.
 * @param[out] points     array of rows * columns elements; the point (x[i], y[j]) is
 *                        points[j * columns + i].
 * @param capacity        its size.
 * @return as kstrip_solve(); KSTRIP_ERROR_CAPACITY, KSTRIP_ERROR_NOT_IN_MODEL.
 */
kstrip_status kstrip_field(const struct kstrip_contact *contact,
                           const struct kstrip_creepage *creepage,
                           const struct kstrip_options *options,
                           const double *x,
                           uint32_t columns,
                           const double *y,
                           uint32_t rows,
                           struct kstrip_point *points,
                           uint32_t capacity);

/**
 * The same result seen from the upper body: opposite forces and moment, same power and adhesion.
 *
 * @param lower           result on the lower body.
 * @param[out] upper      receives the result on the upper body.
 * @return KSTRIP_OK or KSTRIP_ERROR_NULL.
 */
kstrip_status kstrip_result_on_upper_body(const struct kstrip_result *lower,
                                          struct kstrip_result *upper);

/**
 * The strips of a Hertz ellipse, where KSTRIP_MODEL_STRIP places them.
 *
 * kstrip_patch_solve() with KSTRIP_MODEL_STRIP gives the answer of kstrip_solve() with the same strip count,
 * to rounding. The strips of the models of 1967 move with the solution in kstrip_solve(), here they do not: the
 * forces differ by a part of what one strip carries.
 *
 * @param contact         the loaded contact.
 * @param strips          number of strips: 4, 8, 16, 32 or 64.
 * @param[out] patch      receives the patch.
 * @return KSTRIP_OK; KSTRIP_ERROR_STRIP_COUNT, or one of the errors of kstrip_solve() for the contact.
 */
kstrip_status kstrip_patch_from_ellipse(const struct kstrip_contact *contact,
                                        int32_t strips,
                                        struct kstrip_patch *patch);

/**
 * A patch from strips of any origin, in any order of y.
 *
 * Strips may overlap by up to half of the distance at which they touch (a quadrature rule does), not by
 * more. Strips that do not ascend are sorted in a copy on the stack (7 KiB).
 *
 * @param strips, count   the strips, at most KSTRIP_PATCH_CAPACITY; 0 is allowed.
 * @param shear_modulus   combined shear modulus G [Pa], > 0.
 * @param poisson_ratio   combined Poisson's ratio [-], 0 to 0.5.
 * @param[out] patch      receives the patch.
 * @return KSTRIP_OK; KSTRIP_ERROR_NULL, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_MODULUS,
 *         KSTRIP_ERROR_POISSON_RATIO, KSTRIP_ERROR_FRICTION, KSTRIP_ERROR_OVERFLOW,
 *         KSTRIP_ERROR_STRIP_SIZE, KSTRIP_ERROR_PRESSURE, KSTRIP_ERROR_STRIP_ORDER (overlap),
 *         KSTRIP_ERROR_PATCH_SIZE.
 */
kstrip_status kstrip_patch_from_strips(const struct kstrip_patch_strip *strips,
                                       uint32_t count,
                                       double shear_modulus,
                                       double poisson_ratio,
                                       struct kstrip_patch *patch);

/**
 * The patch of two profiles under a load, by the construction of Kik and Piotrowski (1996): virtual
 * penetration 0.55 delta, half lengths sqrt(2 R g), pressure a half-ellipse along x, delta from the
 * deflection at the deepest point.
 *
 * No elastic problem is solved: for the circle of Hertz the patch is 3 % too large and the peak pressure 6 %
 * too low; for an ellipse whose curvatures are as 1 to 9, one axis is 27 % too long. Zones of contact that
 * are apart become lobes. Bounded time: at most 60 evaluations of the load, usually below ten, each
 * proportional to the number of points in contact. Uses 7 KiB of stack.
 *
 * @param y, distance, points  undeformed distance of the bodies [m] on the line x = 0 at y [m], which ascends;
 *                        at least 3 points, straight between them. What is added to all distances
 *                        does not matter.
 * @param contact         rolling radius, load, material, friction.
 * @param strips          number of strips, 4, 8, 16, 32 or 64; with several zones of contact the patch may
 *                        have a few less.
 * @param[out] patch      receives the patch.
 * @param[out] result     receives approach, peak pressure, and the load reached.
 * @return KSTRIP_OK; KSTRIP_ERROR_NULL, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_PROFILE,
 *         KSTRIP_ERROR_PROFILE_END, KSTRIP_ERROR_ROLLING_RADIUS, KSTRIP_ERROR_NORMAL_FORCE,
 *         KSTRIP_ERROR_MODULUS, KSTRIP_ERROR_POISSON_RATIO, KSTRIP_ERROR_FRICTION,
 *         KSTRIP_ERROR_STRIP_COUNT, KSTRIP_ERROR_PATCH_SIZE, KSTRIP_ERROR_OVERFLOW.
 */
kstrip_status kstrip_patch_from_profile(const double *y,
                                        const double *distance,
                                        uint32_t points,
                                        const struct kstrip_profile_contact *contact,
                                        int32_t strips,
                                        struct kstrip_patch *patch,
                                        struct kstrip_profile_result *result);

/**
 * Load, friction bound, area and lobes of a patch; checks it without solving.
 *
 * @param patch           the patch.
 * @param[out] summary    receives the sums.
 * @return KSTRIP_OK; KSTRIP_ERROR_NULL or one of the errors of kstrip_patch_from_strips(), here
 *         KSTRIP_ERROR_STRIP_ORDER also when the strips do not ascend.
 */
kstrip_status kstrip_patch_summarize(const struct kstrip_patch *patch,
                                     struct kstrip_patch_summary *summary);

/**
 * Forces of a patch in motion, on the lower body.
 *
 * The creepage is that at the origin of the patch's coordinates, x = y = 0; a strip sees
 * (longitudinal - spin y, lateral + spin centre_x), and the moment is about the origin. |F| is at
 * most the sum of friction times load over the strips. KSTRIP_MODEL_STRIP solves each lobe
 * with an equivalent ellipse: as wide as the lobe's strips together, with their mean squared half length
 * (two thirds of a squared), their load and their mean friction.
 *
 * @param patch           the patch.
 * @param creepage        motion at the origin.
 * @param options         KSTRIP_MODEL_STRIP or one of the models of 1967; NULL for the default. The
 *                        strip count is checked and otherwise ignored.
 * @param[out] result     receives forces, moment, power and stick area.
 * @return KSTRIP_OK, KSTRIP_WARNING_SPIN, KSTRIP_WARNING_RANGE (of a lobe's ellipse);
 *         KSTRIP_ERROR_NOT_IN_MODEL for KSTRIP_MODEL_TOTAL and KSTRIP_MODEL_LINEAR (the linear theory
 *         of a patch is kstrip_patch_jacobian() at zero creepage); KSTRIP_ERROR_MODEL,
 *         KSTRIP_ERROR_STRIP_COUNT, or one of the errors of kstrip_patch_summarize().
 */
kstrip_status kstrip_patch_solve(const struct kstrip_patch *patch,
                                 const struct kstrip_creepage *creepage,
                                 const struct kstrip_options *options,
                                 struct kstrip_result *result);

/**
 * Forces of a patch and their exact derivatives with respect to the creepages.
 *
 * @param[out] jacobian   receives d(fx, fy, mz)/d(longitudinal, lateral, spin), row by row: nine
 *                        numbers [N, N, N m over 1, 1, 1/m]. At kinks of a model, a one-sided value.
 * @return as kstrip_patch_solve(); KSTRIP_ERROR_OVERFLOW also when a derivative is too large.
 */
kstrip_status kstrip_patch_jacobian(const struct kstrip_patch *patch,
                                    const struct kstrip_creepage *creepage,
                                    const struct kstrip_options *options,
                                    struct kstrip_result *result,
                                    double *jacobian);

/**
 * What each strip of a patch carries, ascending in y. The shares add up to the totals of
 * kstrip_patch_solve(); each moment is about the origin.
 *
 * @param[out] strips     array that receives the strips.
 * @param capacity        its size, at least patch->count.
 * @param[out] count      receives how many were written: patch->count.
 * @return as kstrip_patch_solve(); KSTRIP_ERROR_CAPACITY.
 */
kstrip_status kstrip_patch_strips(const struct kstrip_patch *patch,
                                  const struct kstrip_creepage *creepage,
                                  const struct kstrip_options *options,
                                  struct kstrip_strip *strips,
                                  uint32_t capacity,
                                  uint32_t *count);

/**
 * Pressure, traction, slip and state at a point of a patch. They do not vary over the width of a strip.
 *
 * @param x, y            the point [m]; outside is allowed.
 * @param[out] point      receives the state.
 * @return as kstrip_patch_solve().
 */
kstrip_status kstrip_patch_traction_at(const struct kstrip_patch *patch,
                                       const struct kstrip_creepage *creepage,
                                       const struct kstrip_options *options,
                                       double x,
                                       double y,
                                       struct kstrip_point *point);

/**
 * Pressure, traction, slip and state of a patch over a grid.
 *
 * @param x, columns      array of x [m] and its size.
 * @param y, rows         array of y [m] and its size.
 * @param[out] points     array of rows * columns elements; the point (x[i], y[j]) is
 *                        points[j * columns + i].
 * @param capacity        its size.
 * @return as kstrip_patch_solve(); KSTRIP_ERROR_CAPACITY.
 */
kstrip_status kstrip_patch_field(const struct kstrip_patch *patch,
                                 const struct kstrip_creepage *creepage,
                                 const struct kstrip_options *options,
                                 const double *x,
                                 uint32_t columns,
                                 const double *y,
                                 uint32_t rows,
                                 struct kstrip_point *points,
                                 uint32_t capacity);

/**
 * kstrip_patch_from_ellipse() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_patch_from_ellipse_f32(const struct kstrip_contact_f32 *contact,
                                            int32_t strips,
                                            struct kstrip_patch_f32 *patch);

/**
 * kstrip_patch_from_strips() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_patch_from_strips_f32(const struct kstrip_patch_strip_f32 *strips,
                                           uint32_t count,
                                           float shear_modulus,
                                           float poisson_ratio,
                                           struct kstrip_patch_f32 *patch);

/**
 * kstrip_patch_from_profile() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_patch_from_profile_f32(const float *y,
                                            const float *distance,
                                            uint32_t points,
                                            const struct kstrip_profile_contact_f32 *contact,
                                            int32_t strips,
                                            struct kstrip_patch_f32 *patch,
                                            struct kstrip_profile_result_f32 *result);

/**
 * kstrip_patch_summarize() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_patch_summarize_f32(const struct kstrip_patch_f32 *patch,
                                         struct kstrip_patch_summary_f32 *summary);

/**
 * kstrip_patch_solve() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_patch_solve_f32(const struct kstrip_patch_f32 *patch,
                                     const struct kstrip_creepage_f32 *creepage,
                                     const struct kstrip_options *options,
                                     struct kstrip_result_f32 *result);

/**
 * kstrip_patch_jacobian() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_patch_jacobian_f32(const struct kstrip_patch_f32 *patch,
                                        const struct kstrip_creepage_f32 *creepage,
                                        const struct kstrip_options *options,
                                        struct kstrip_result_f32 *result,
                                        float *jacobian);

/**
 * kstrip_patch_strips() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_patch_strips_f32(const struct kstrip_patch_f32 *patch,
                                      const struct kstrip_creepage_f32 *creepage,
                                      const struct kstrip_options *options,
                                      struct kstrip_strip_f32 *strips,
                                      uint32_t capacity,
                                      uint32_t *count);

/**
 * kstrip_patch_traction_at() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_patch_traction_at_f32(const struct kstrip_patch_f32 *patch,
                                           const struct kstrip_creepage_f32 *creepage,
                                           const struct kstrip_options *options,
                                           float x,
                                           float y,
                                           struct kstrip_point_f32 *point);

/**
 * kstrip_patch_field() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_patch_field_f32(const struct kstrip_patch_f32 *patch,
                                     const struct kstrip_creepage_f32 *creepage,
                                     const struct kstrip_options *options,
                                     const float *x,
                                     uint32_t columns,
                                     const float *y,
                                     uint32_t rows,
                                     struct kstrip_point_f32 *points,
                                     uint32_t capacity);

/**
 * kstrip_solve() with KSTRIP_MODEL_TOTAL without linking any other model.
 *
 * The same result, to the bit, as kstrip_solve() with that model in its options. kstrip_solve() learns
 * its model when it runs and therefore brings every model into the program; a program that calls
 * only the functions of this group contains only the models that they name.
 *
 * @param[in]  contact   the loaded contact.
 * @param[in]  creepage  creepage and spin.
 * @param[out] result    receives the forces on the lower body; adhesion is -1 (unknown).
 * @return KSTRIP_OK, KSTRIP_WARNING_RANGE, or one of the errors of kstrip_solve().
 */
kstrip_status kstrip_solve_total(const struct kstrip_contact *contact,
                                 const struct kstrip_creepage *creepage,
                                 struct kstrip_result *result);

/**
 * kstrip_solve() with KSTRIP_MODEL_LINEAR without linking any other model.
 *
 * @param[in]  contact   the loaded contact.
 * @param[in]  creepage  creepage and spin.
 * @param[out] result    receives the forces on the lower body; adhesion is 1.
 * @return KSTRIP_OK, KSTRIP_WARNING_BEYOND_FRICTION, or one of the errors of kstrip_solve().
 */
kstrip_status kstrip_solve_linear(const struct kstrip_contact *contact,
                                  const struct kstrip_creepage *creepage,
                                  struct kstrip_result *result);

/**
 * kstrip_solve() with KSTRIP_MODEL_STRIP_1967 without linking any other model.
 *
 * @param[in]  contact   the loaded contact.
 * @param[in]  creepage  creepage and spin.
 * @param[in]  strips    number of strips: 4, 8, 16, 32 or 64.
 * @param[out] result    receives the forces on the lower body.
 * @return KSTRIP_OK, KSTRIP_WARNING_SPIN, or one of the errors of kstrip_solve().
 */
kstrip_status kstrip_solve_strip_1967(const struct kstrip_contact *contact,
                                      const struct kstrip_creepage *creepage,
                                      int32_t strips,
                                      struct kstrip_result *result);

/**
 * kstrip_solve() with KSTRIP_MODEL_STRIP without linking any other model.
 *
 * @param[in]  contact   the loaded contact.
 * @param[in]  creepage  creepage and spin.
 * @param[in]  strips    number of strips: 4, 8, 16, 32 or 64.
 * @param[out] result    receives the forces on the lower body.
 * @return KSTRIP_OK, KSTRIP_WARNING_RANGE, or one of the errors of kstrip_solve().
 */
kstrip_status kstrip_solve_strip(const struct kstrip_contact *contact,
                                 const struct kstrip_creepage *creepage,
                                 int32_t strips,
                                 struct kstrip_result *result);

/**
 * kstrip_solve_total() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_solve_total_f32(const struct kstrip_contact_f32 *contact,
                                     const struct kstrip_creepage_f32 *creepage,
                                     struct kstrip_result_f32 *result);

/**
 * kstrip_solve_linear() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_solve_linear_f32(const struct kstrip_contact_f32 *contact,
                                      const struct kstrip_creepage_f32 *creepage,
                                      struct kstrip_result_f32 *result);

/**
 * kstrip_solve_strip_1967() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_solve_strip_1967_f32(const struct kstrip_contact_f32 *contact,
                                          const struct kstrip_creepage_f32 *creepage,
                                          int32_t strips,
                                          struct kstrip_result_f32 *result);

/**
 * kstrip_solve_strip() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_solve_strip_f32(const struct kstrip_contact_f32 *contact,
                                     const struct kstrip_creepage_f32 *creepage,
                                     int32_t strips,
                                     struct kstrip_result_f32 *result);

/**
 * kstrip_material_from_youngs_modulus() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_material_from_youngs_modulus_f32(float youngs_modulus,
                                                      float poisson_ratio,
                                                      struct kstrip_material_f32 *material);

/**
 * kstrip_material_combine() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_material_combine_f32(const struct kstrip_material_f32 *lower,
                                          const struct kstrip_material_f32 *upper,
                                          struct kstrip_combined_material_f32 *combined);

/**
 * kstrip_hertz() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_hertz_f32(const struct kstrip_radii_f32 *radii,
                               float normal_force,
                               const struct kstrip_combined_material_f32 *material,
                               struct kstrip_hertz_contact_f32 *ellipse);

/**
 * kstrip_creepage_from_velocities() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_creepage_from_velocities_f32(const struct kstrip_velocity_f32 *lower,
                                                  const struct kstrip_velocity_f32 *upper,
                                                  float rolling_speed,
                                                  struct kstrip_creepage_f32 *creepage);

/**
 * kstrip_parameters_from_creepage() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_parameters_from_creepage_f32(const struct kstrip_contact_f32 *contact,
                                                  const struct kstrip_creepage_f32 *creepage,
                                                  struct kstrip_parameters_f32 *parameters);

/**
 * kstrip_creepage_from_parameters() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_creepage_from_parameters_f32(const struct kstrip_contact_f32 *contact,
                                                  const struct kstrip_parameters_f32 *parameters,
                                                  struct kstrip_creepage_f32 *creepage);

/**
 * kstrip_solve() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_solve_f32(const struct kstrip_contact_f32 *contact,
                               const struct kstrip_creepage_f32 *creepage,
                               const struct kstrip_options *options,
                               struct kstrip_result_f32 *result);

/**
 * kstrip_solve_jacobian() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_solve_jacobian_f32(const struct kstrip_contact_f32 *contact,
                                        const struct kstrip_creepage_f32 *creepage,
                                        const struct kstrip_options *options,
                                        struct kstrip_result_f32 *result,
                                        float *jacobian);

/**
 * kstrip_solve_batch() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_solve_batch_f32(const struct kstrip_contact_f32 *contacts,
                                     const struct kstrip_creepage_f32 *creepages,
                                     uint32_t count,
                                     const struct kstrip_options *options,
                                     struct kstrip_result_f32 *results);

/**
 * kstrip_strips() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_strips_f32(const struct kstrip_contact_f32 *contact,
                                const struct kstrip_creepage_f32 *creepage,
                                const struct kstrip_options *options,
                                struct kstrip_strip_f32 *strips,
                                uint32_t capacity,
                                uint32_t *count);

/**
 * kstrip_traction_at() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_traction_at_f32(const struct kstrip_contact_f32 *contact,
                                     const struct kstrip_creepage_f32 *creepage,
                                     const struct kstrip_options *options,
                                     float x,
                                     float y,
                                     struct kstrip_point_f32 *point);

/**
 * kstrip_field() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_field_f32(const struct kstrip_contact_f32 *contact,
                               const struct kstrip_creepage_f32 *creepage,
                               const struct kstrip_options *options,
                               const float *x,
                               uint32_t columns,
                               const float *y,
                               uint32_t rows,
                               struct kstrip_point_f32 *points,
                               uint32_t capacity);

/**
 * kstrip_result_on_upper_body() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_result_on_upper_body_f32(const struct kstrip_result_f32 *lower,
                                              struct kstrip_result_f32 *upper);

/**
 * kstrip_solve_batch() for one array for each quantity, as vector codes and data frames have them.
 *
 * The same results as kstrip_solve() for each contact, bit for bit. All inputs are checked before
 * anything is written: if one is bad its status is returned and no output is touched.
 *
 * @param count           number of contacts; 0 is allowed.
 * @param inputs          arrays of count elements.
 * @param options         for all contacts; NULL for the defaults.
 * @param outputs         arrays of count elements; NULL where a quantity is not wanted: moment (with the power) and
 *                        adhesion are then left out where that saves time. They must not
 *                        overlap the inputs or each other.
 * @return KSTRIP_OK, the largest warning, or the first error, as kstrip_solve().
 */
kstrip_status kstrip_solve_batch_arrays(uint32_t count,
                                        const struct kstrip_batch_inputs *inputs,
                                        const struct kstrip_options *options,
                                        const struct kstrip_batch_outputs *outputs);

/**
 * kstrip_solve_batch_arrays() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_solve_batch_arrays_f32(uint32_t count,
                                            const struct kstrip_batch_inputs_f32 *inputs,
                                            const struct kstrip_options *options,
                                            const struct kstrip_batch_outputs_f32 *outputs);

/**
 * Forces and their exact derivatives with respect to creepages, normal force and friction.
 *
 * The first nine derivatives are those of kstrip_solve_jacobian(). Without load or friction those with
 * respect to them are one-sided, those of full sliding. KSTRIP_MODEL_LINEAR has no friction in it: its
 * derivatives with respect to friction and to the load at fixed a, b are zero, and
 * load_through_hertz is zero without load, where it has no bound.
 *
 * @param contact              ellipse, load, material, friction.
 * @param creepage             motion.
 * @param options              model and strip count; NULL for the defaults.
 * @param[out] result          receives what kstrip_solve() gives.
 * @param[out] derivatives     receives the derivatives; at kinks of a model, one-sided values.
 * @return as kstrip_solve(); KSTRIP_ERROR_OVERFLOW also when a derivative is too large.
 */
kstrip_status kstrip_solve_derivatives(const struct kstrip_contact *contact,
                                       const struct kstrip_creepage *creepage,
                                       const struct kstrip_options *options,
                                       struct kstrip_result *result,
                                       struct kstrip_derivatives *derivatives);

/**
 * Forces and derivatives of many contacts: the same as calling kstrip_solve_jacobian() for each, bit
 * for bit.
 *
 * All inputs are checked before anything is written: if one is bad its status is returned and no
 * output is touched.
 *
 * @param contacts, creepages  arrays of count elements.
 * @param count           number of contacts; 0 is allowed.
 * @param options         for all contacts; NULL for the defaults.
 * @param[out] results    array of count elements; status_detail tells each one's warning.
 * @param[out] jacobians  array of 9 count numbers: nine per contact, as kstrip_solve_jacobian().
 * @return KSTRIP_OK, the largest warning, or the first error, as kstrip_solve_jacobian().
 */
kstrip_status kstrip_solve_jacobian_batch(const struct kstrip_contact *contacts,
                                          const struct kstrip_creepage *creepages,
                                          uint32_t count,
                                          const struct kstrip_options *options,
                                          struct kstrip_result *results,
                                          double *jacobians);

/**
 * kstrip_solve_derivatives() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_solve_derivatives_f32(const struct kstrip_contact_f32 *contact,
                                           const struct kstrip_creepage_f32 *creepage,
                                           const struct kstrip_options *options,
                                           struct kstrip_result_f32 *result,
                                           struct kstrip_derivatives_f32 *derivatives);

/**
 * kstrip_solve_jacobian_batch() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_solve_jacobian_batch_f32(const struct kstrip_contact_f32 *contacts,
                                              const struct kstrip_creepage_f32 *creepages,
                                              uint32_t count,
                                              const struct kstrip_options *options,
                                              struct kstrip_result_f32 *results,
                                              float *jacobians);

/**
 * Only what is wanted of a contact in motion: what is not wanted is not computed.
 *
 * What is wanted is that of kstrip_solve(), kstrip_solve_jacobian() and kstrip_strips(), bit for bit. What is not
 * wanted is reported as mz = power = 0 and adhesion = -1. KSTRIP_MODEL_STRIP saves most without adhesion; all derivatives
 * come together. The README has the instructions of each combination. Under falling friction:
 * kstrip_contact_under_friction() first, except for derivatives, which are kstrip_solve_friction_jacobian()'s.
 *
 * @param contact         ellipse, load, material, friction.
 * @param creepage        motion.
 * @param options         model and strip count; NULL for the defaults.
 * @param wanted          KSTRIP_WANT constants, added up; the forces are always computed.
 * @param[out] result     receives the forces.
 * @param[out] jacobian   nine numbers as kstrip_solve_jacobian(); with KSTRIP_WANT_JACOBIAN only, else may be NULL.
 * @param[out] strips     array as kstrip_strips(); with KSTRIP_WANT_STRIPS only, else may be NULL.
 * @param capacity        its size.
 * @param[out] count      receives how many were written; with KSTRIP_WANT_STRIPS only, else may be NULL.
 * @return as kstrip_solve(), kstrip_solve_jacobian() and kstrip_strips(); KSTRIP_ERROR_WANTED.
 */
kstrip_status kstrip_evaluate(const struct kstrip_contact *contact,
                              const struct kstrip_creepage *creepage,
                              const struct kstrip_options *options,
                              uint32_t wanted,
                              struct kstrip_result *result,
                              double *jacobian,
                              struct kstrip_strip *strips,
                              uint32_t capacity,
                              uint32_t *count);

/**
 * kstrip_evaluate() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_evaluate_f32(const struct kstrip_contact_f32 *contact,
                                  const struct kstrip_creepage_f32 *creepage,
                                  const struct kstrip_options *options,
                                  uint32_t wanted,
                                  struct kstrip_result_f32 *result,
                                  float *jacobian,
                                  struct kstrip_strip_f32 *strips,
                                  uint32_t capacity,
                                  uint32_t *count);

/**
 * Forces under friction that falls with the slip, solved consistently with the slip.
 *
 * The slip is the mean over the contact, weighted with friction: power/(friction N), which is 0 where
 * everything sticks and the creepage in full sliding without spin. The coefficient of friction of the
 * contact is ignored. The slope factor stands for a layer that makes the contact softer: it multiplies the shear
 * modulus and stretches the creep curve without changing its shape. With constant friction
 * (ratio 1, decay 0 or rolling_speed 0) and slope_factor 1 the result is that of kstrip_solve(), bit for bit and
 * at its cost; otherwise some six solutions, 260 at most. For KSTRIP_MODEL_LINEAR only the slope factor
 * counts.
 *
 * @param contact         ellipse, load, material; its friction is ignored.
 * @param creepage        motion.
 * @param friction        how friction falls.
 * @param options         model and strip count; NULL for the defaults.
 * @param[out] result     receives what kstrip_solve() gives.
 * @param[out] effective  receives the coefficient of friction [-] that agrees with the slip; may be NULL.
 * @return as kstrip_solve(); KSTRIP_WARNING_SEVERAL_FRICTIONS, KSTRIP_WARNING_NOT_CONVERGED for
 *         friction that falls steeply; KSTRIP_ERROR_FRICTION_RATIO, KSTRIP_ERROR_FRICTION_DECAY,
 *         KSTRIP_ERROR_NEGATIVE_SPEED, KSTRIP_ERROR_SLOPE_FACTOR.
 */
kstrip_status kstrip_solve_friction(const struct kstrip_contact *contact,
                                    const struct kstrip_creepage *creepage,
                                    const struct kstrip_friction *friction,
                                    const struct kstrip_options *options,
                                    struct kstrip_result *result,
                                    double *effective);

/**
 * kstrip_solve_friction() with the exact derivatives with respect to the creepages.
 *
 * @param[out] jacobian   receives d(fx, fy, mz)/d(longitudinal, lateral, spin), row by row, friction
 *                        following the slip: nine numbers [N, N, N m over 1, 1, 1/m]. On the falling branch
 *                        of a traction curve the entry on the diagonal is negative.
 * @return as kstrip_solve_friction(); KSTRIP_ERROR_OVERFLOW also when a derivative is too large.
 */
kstrip_status kstrip_solve_friction_jacobian(const struct kstrip_contact *contact,
                                             const struct kstrip_creepage *creepage,
                                             const struct kstrip_friction *friction,
                                             const struct kstrip_options *options,
                                             struct kstrip_result *result,
                                             double *jacobian,
                                             double *effective);

/**
 * The contact as it is while it slips: friction that falls with the slip has become a constant coefficient of
 * friction, and the slope factor part of the shear modulus.
 *
 * kstrip_evaluate(), kstrip_strips(), kstrip_traction_at(), kstrip_field() and kstrip_solve() of that contact at the same
 * creepage and with the same options are those under falling friction. (Derivatives are not: use
 * kstrip_solve_friction_jacobian(), where friction follows the slip.)
 *
 * @param contact, creepage, friction, options  as kstrip_solve_friction().
 * @param[out] slipping   receives the contact; not the contact itself.
 * @return as kstrip_solve_friction().
 */
kstrip_status kstrip_contact_under_friction(const struct kstrip_contact *contact,
                                            const struct kstrip_creepage *creepage,
                                            const struct kstrip_friction *friction,
                                            const struct kstrip_options *options,
                                            struct kstrip_contact *slipping);

/**
 * kstrip_contact_under_friction() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_contact_under_friction_f32(const struct kstrip_contact_f32 *contact,
                                                const struct kstrip_creepage_f32 *creepage,
                                                const struct kstrip_friction_f32 *friction,
                                                const struct kstrip_options *options,
                                                struct kstrip_contact_f32 *slipping);

/**
 * kstrip_solve_friction() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_solve_friction_f32(const struct kstrip_contact_f32 *contact,
                                        const struct kstrip_creepage_f32 *creepage,
                                        const struct kstrip_friction_f32 *friction,
                                        const struct kstrip_options *options,
                                        struct kstrip_result_f32 *result,
                                        float *effective);

/**
 * kstrip_solve_friction_jacobian() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_solve_friction_jacobian_f32(const struct kstrip_contact_f32 *contact,
                                                 const struct kstrip_creepage_f32 *creepage,
                                                 const struct kstrip_friction_f32 *friction,
                                                 const struct kstrip_options *options,
                                                 struct kstrip_result_f32 *result,
                                                 float *jacobian,
                                                 float *effective);

/**
 * Forces of a patch whose friction falls with the slip, solved consistently with the slip.
 *
 * The friction of every strip is that without slip; the law multiplies all of them with one share,
 * (1 - ratio) exp(-decay w) + ratio, w the rolling speed times the mean slip of the patch, weighted with friction:
 * power over the sum of friction times load. The law's own friction is ignored, its slope_factor multiplies the shear
 * modulus. The strips of an ellipse give the answer of kstrip_solve_friction(). With constant friction and slope_factor
 * 1 the result is that of kstrip_patch_solve(), bit for bit and at its cost; otherwise some six solutions,
 * 260 at most.
 *
 * @param patch           the patch.
 * @param creepage        motion at the origin.
 * @param friction        how friction falls; its member friction is not used.
 * @param options         as kstrip_patch_solve(); NULL for the default.
 * @param[out] result     receives what kstrip_patch_solve() gives.
 * @param[out] share      receives friction that agrees with the slip over friction without slip [-], the same for all
 *                        strips; may be NULL.
 * @return as kstrip_patch_solve(); KSTRIP_WARNING_SEVERAL_FRICTIONS for friction that falls steeply,
 *         KSTRIP_WARNING_NOT_CONVERGED for that and where forces jump over the slip (KSTRIP_MODEL_STRIP_1967 with
 *         spin, see kstrip_patch_from_ellipse()); KSTRIP_ERROR_FRICTION_RATIO, KSTRIP_ERROR_FRICTION_DECAY,
 *         KSTRIP_ERROR_NEGATIVE_SPEED, KSTRIP_ERROR_SLOPE_FACTOR.
 */
kstrip_status kstrip_patch_solve_friction(const struct kstrip_patch *patch,
                                          const struct kstrip_creepage *creepage,
                                          const struct kstrip_friction *friction,
                                          const struct kstrip_options *options,
                                          struct kstrip_result *result,
                                          double *share);

/**
 * kstrip_patch_solve_friction() with the exact derivatives with respect to the creepages.
 *
 * @param[out] jacobian   receives d(fx, fy, mz)/d(longitudinal, lateral, spin), row by row, friction
 *                        following the slip: nine numbers [N, N, N m over 1, 1, 1/m].
 * @return as kstrip_patch_solve_friction(); KSTRIP_ERROR_OVERFLOW also when a derivative is too large.
 */
kstrip_status kstrip_patch_solve_friction_jacobian(const struct kstrip_patch *patch,
                                                   const struct kstrip_creepage *creepage,
                                                   const struct kstrip_friction *friction,
                                                   const struct kstrip_options *options,
                                                   struct kstrip_result *result,
                                                   double *jacobian,
                                                   double *share);

/**
 * The patch as it is while it slips: friction that falls with the slip has become constant friction of its strips,
 * and the slope factor part of its shear modulus.
 *
 * kstrip_patch_strips(), kstrip_patch_traction_at(), kstrip_patch_field() and kstrip_patch_solve() of that patch at the
 * same creepage are those under falling friction. (kstrip_patch_jacobian() is not: its friction stands still.)
 *
 * @param patch, creepage, friction, options  as kstrip_patch_solve_friction().
 * @param[out] slipping   receives the patch; not the patch itself.
 * @param[out] share      receives friction that agrees with the slip over friction without slip [-]; may be NULL.
 * @return as kstrip_patch_solve_friction().
 */
kstrip_status kstrip_patch_under_friction(const struct kstrip_patch *patch,
                                          const struct kstrip_creepage *creepage,
                                          const struct kstrip_friction *friction,
                                          const struct kstrip_options *options,
                                          struct kstrip_patch *slipping,
                                          double *share);

/**
 * kstrip_patch_solve_friction() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_patch_solve_friction_f32(const struct kstrip_patch_f32 *patch,
                                              const struct kstrip_creepage_f32 *creepage,
                                              const struct kstrip_friction_f32 *friction,
                                              const struct kstrip_options *options,
                                              struct kstrip_result_f32 *result,
                                              float *share);

/**
 * kstrip_patch_solve_friction_jacobian() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_patch_solve_friction_jacobian_f32(const struct kstrip_patch_f32 *patch,
                                                       const struct kstrip_creepage_f32 *creepage,
                                                       const struct kstrip_friction_f32 *friction,
                                                       const struct kstrip_options *options,
                                                       struct kstrip_result_f32 *result,
                                                       float *jacobian,
                                                       float *share);

/**
 * kstrip_patch_under_friction() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_patch_under_friction_f32(const struct kstrip_patch_f32 *patch,
                                              const struct kstrip_creepage_f32 *creepage,
                                              const struct kstrip_friction_f32 *friction,
                                              const struct kstrip_options *options,
                                              struct kstrip_patch_f32 *slipping,
                                              float *share);

/**
 * The coefficient of friction that explains a measured force at a known creepage.
 *
 * Bounded iterations, about seventy solutions. The force grows with friction from full sliding, where it is
 * friction times load, to adhesion, where it does not depend on it: there (less than a twentieth of the
 * friction used, or more force than linear theory gives) the status is KSTRIP_WARNING_FRICTION_AT_LEAST and
 * the result is the used friction |force|/load, a lower bound. Where spin opposes the creepage more than one
 * friction may fit: KSTRIP_WARNING_SEVERAL_FRICTIONS, the result is the smallest. KSTRIP_MODEL_TOTAL suits best:
 * the force of KSTRIP_MODEL_STRIP has ripples over friction, up to 11 % of it where less than a third of friction is used,
 * 1 % up to one half, none above 0.7, within which several frictions fit: mostly said by that warning.
 *
 * @param contact         ellipse, load, material; its friction is ignored.
 * @param creepage        motion.
 * @param options         model and strip count; NULL for the defaults. Not KSTRIP_MODEL_LINEAR.
 * @param measured        KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY, or both added: then the resultant counts.
 * @param fx, fy          measured forces on the lower body [N]; what was not measured is ignored.
 * @param[out] estimate   receives friction, its sensitivity, and how far the force is off.
 * @return as kstrip_solve(); KSTRIP_WARNING_FRICTION_AT_LEAST, KSTRIP_WARNING_SEVERAL_FRICTIONS,
 *         KSTRIP_WARNING_NOT_CONVERGED;
 *         KSTRIP_ERROR_NOT_IN_MODEL, KSTRIP_ERROR_MEASURED, KSTRIP_ERROR_UNEXPLAINED.
 */
kstrip_status kstrip_estimate_friction(const struct kstrip_contact *contact,
                                       const struct kstrip_creepage *creepage,
                                       const struct kstrip_options *options,
                                       uint32_t measured,
                                       double fx,
                                       double fy,
                                       struct kstrip_friction_estimate *estimate);

/**
 * The creepage at which a contact with a given spin carries a wanted force.
 *
 * Bounded iterations, about six solutions with derivatives. A force within 0.1 % of friction times load is that of
 * full sliding: the status is KSTRIP_WARNING_CREEPAGE_AT_LEAST, the result is the creepage that comes as near
 * as that, and larger ones do as well.
 *
 * @param contact         ellipse, load, material, friction.
 * @param fx, fy          wanted force on the lower body [N].
 * @param spin            given spin [1/m].
 * @param options         model and strip count; NULL for the defaults.
 * @param[out] creepage   receives the creepages, and the given spin.
 * @return as kstrip_solve(); KSTRIP_WARNING_CREEPAGE_AT_LEAST, KSTRIP_WARNING_NOT_CONVERGED;
 *         KSTRIP_ERROR_FORCE_BEYOND_FRICTION.
 */
kstrip_status kstrip_creepage_for_force(const struct kstrip_contact *contact,
                                        double fx,
                                        double fy,
                                        double spin,
                                        const struct kstrip_options *options,
                                        struct kstrip_creepage *creepage);

/**
 * kstrip_estimate_friction() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_estimate_friction_f32(const struct kstrip_contact_f32 *contact,
                                           const struct kstrip_creepage_f32 *creepage,
                                           const struct kstrip_options *options,
                                           uint32_t measured,
                                           float fx,
                                           float fy,
                                           struct kstrip_friction_estimate_f32 *estimate);

/**
 * kstrip_creepage_for_force() in single precision: same arguments, units, ranges and statuses.
 */
kstrip_status kstrip_creepage_for_force_f32(const struct kstrip_contact_f32 *contact,
                                            float fx,
                                            float fy,
                                            float spin,
                                            const struct kstrip_options *options,
                                            struct kstrip_creepage_f32 *creepage);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* KSTRIP_H */
