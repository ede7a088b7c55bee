/**
 * @file kstrip_f32.h
 * kstrip in single precision: the functions and structures of kstrip.h with the suffix _f32.
 * Arguments, members, units, ranges and statuses are those of the functions and structures
 * without it.
 *
 * Generated from the Rust sources by cbindgen; do not edit.
 */

#ifndef KSTRIP_F32_H
#define KSTRIP_F32_H

#include "kstrip.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * @defgroup kstrip_bodies_f32 Bodies: materials, Hertz's ellipse and its inverse, linear coefficients
 * @{
 */

/** An isotropic elastic body. */
typedef struct kstrip_material_f32 {
    float shear_modulus;
    float poisson_ratio;
} kstrip_material_f32;

/** The combined elastic constants of two bodies. */
typedef struct kstrip_combined_material_f32 {
    float shear_modulus;
    float poisson_ratio;
    float mismatch;
} kstrip_combined_material_f32;

/** kstrip_material_combine() in single precision. */
kstrip_status kstrip_material_combine_f32(const struct kstrip_material_f32 *lower,
                                          const struct kstrip_material_f32 *upper,
                                          struct kstrip_combined_material_f32 *combined);

/**
 * Radii of curvature of two bodies at the contact [m]: convex positive, flat infinite
 * (INFINITY), concave negative. KSTRIP_ERROR_CURVATURE if one is 0 or NaN, or if the curvatures of
 * both bodies in one plane add up to 0 or less; KSTRIP_WARNING_RADIUS if they are those of radii
 * above 5 m in both planes.
 */
typedef struct kstrip_radii_f32 {
    float lower_x;
    float lower_y;
    float upper_x;
    float upper_y;
} kstrip_radii_f32;

/** A loaded elliptic contact with combined elastic constants and Coulomb friction. */
typedef struct kstrip_contact_f32 {
    float a;
    float b;
    float normal_force;
    float shear_modulus;
    float poisson_ratio;
    float friction;
    float mismatch;
} kstrip_contact_f32;

/** The contact ellipse of Hertz. */
typedef struct kstrip_hertz_contact_f32 {
    float a;
    float b;
    float peak_pressure;
    float approach;
    float axis_ratio;
    float hertz_angle;
    float rho;
} kstrip_hertz_contact_f32;

/** kstrip_contact_from_hertz() in single precision. */
kstrip_status kstrip_contact_from_hertz_f32(const struct kstrip_radii_f32 *radii,
                                            const struct kstrip_combined_material_f32 *pair,
                                            float load,
                                            float friction,
                                            struct kstrip_contact_f32 *contact,
                                            struct kstrip_hertz_contact_f32 *ellipse);

/** kstrip_contact_from_approach() in single precision. */
kstrip_status kstrip_contact_from_approach_f32(const struct kstrip_radii_f32 *radii,
                                               const struct kstrip_combined_material_f32 *pair,
                                               float approach,
                                               float friction,
                                               struct kstrip_contact_f32 *contact,
                                               float *dload_dapproach);

/** kstrip_linear_coefficients() in single precision. */
kstrip_status kstrip_linear_coefficients_f32(float axis_ratio,
                                             float poisson_ratio,
                                             float *coefficients);

/** @} */

/**
 * @defgroup kstrip_motion_f32 Motion: creepages, Kalker's parameters
 * @{
 */

/** Velocity of one body's material at the centre of the contact, relative to the contact. */
typedef struct kstrip_velocity_f32 {
    float x;
    float y;
    float angular_z;
} kstrip_velocity_f32;

/**
 * Rigid slip of the upper relative to the lower body, divided by the rolling speed (3.3).
 * KSTRIP_WARNING_CREEPAGE if longitudinal or lateral is above 10 in size; KSTRIP_WARNING_SPIN_UNIT
 * if the spin is larger than bodies that roll on such a contact can have.
 */
typedef struct kstrip_creepage_f32 {
    float longitudinal;
    float lateral;
    float spin;
} kstrip_creepage_f32;

/** kstrip_creepage_from_velocities() in single precision. */
kstrip_status kstrip_creepage_from_velocities_f32(const struct kstrip_velocity_f32 *lower,
                                                  const struct kstrip_velocity_f32 *upper,
                                                  float rolling_speed,
                                                  struct kstrip_creepage_f32 *creepage);

/** Kalker's parameters (5.13) of a contact in motion, dimensionless. */
typedef struct kstrip_parameters_f32 {
    float xi;
    float eta;
    float psi;
} kstrip_parameters_f32;

/** kstrip_parameters_from_creepage() in single precision. */
kstrip_status kstrip_parameters_from_creepage_f32(const struct kstrip_contact_f32 *contact,
                                                  const struct kstrip_creepage_f32 *creepage,
                                                  struct kstrip_parameters_f32 *parameters);

/** kstrip_creepage_from_parameters() in single precision. */
kstrip_status kstrip_creepage_from_parameters_f32(const struct kstrip_contact_f32 *contact,
                                                  const struct kstrip_parameters_f32 *parameters,
                                                  struct kstrip_creepage_f32 *creepage);

/** @} */

/**
 * @defgroup kstrip_solve_f32 Solve: forces, derivatives, strips
 * @{
 */

/** Forces on the lower body. */
typedef struct kstrip_result_f32 {
    float fx;
    float fy;
    float mz;
    float power;
    float adhesion;
    kstrip_status status_detail;
    int32_t reserved;
} kstrip_result_f32;

/** kstrip_solve() in single precision. */
kstrip_status kstrip_solve_f32(const struct kstrip_contact_f32 *contact,
                               const struct kstrip_creepage_f32 *creepage,
                               const struct kstrip_options *options,
                               struct kstrip_result_f32 *result);

/**
 * Falling friction: the coefficient is friction ((1 - ratio) exp(-decay w) +
 * ratio), where w is the sliding velocity [m/s]. A layer between the bodies makes the creep
 * curve less steep: slope_factor and slide_factor describe it for a measured or published curve,
 * and layer is an elastic layer that is known.
 *
 * Polach, Wear 258 (2005) 992, gives for locomotives: dry friction 0.55, ratio 0.4, decay 0.6 s/m;
 * wet 0.3, 0.4, 0.2 s/m. KSTRIP_ERROR_MODEL_LEFT_OUT if this build of the library has no laws.
 */
typedef struct kstrip_friction_f32 {
    float friction;
    float ratio;
    float decay;
    float rolling_speed;
    float slope_factor;
    float slide_factor;
    float layer;
} kstrip_friction_f32;

/** Derivatives of fx, fy, mz with respect to creepages, load and friction. */
typedef struct kstrip_derivatives_f32 {
    float jacobian[3][3];
    float normal_force[3];
    float load_through_hertz[3];
    float friction[3];
} kstrip_derivatives_f32;

/** Derivatives of fx, fy, mz with respect to the parameters of falling friction. */
typedef struct kstrip_law_derivatives_f32 {
    float ratio[3];
    float decay[3];
    float rolling_speed[3];
    float slope_factor[3];
    float slide_factor[3];
    float layer[3];
} kstrip_law_derivatives_f32;

/** One strip y = const of a contact or a patch, and the forces that it carries on the lower body. */
typedef struct kstrip_strip_f32 {
    float y;
    float width;
    float half_length;
    float separatrix;
    float fx;
    float fy;
    float mz;
    float power;
    int32_t state;
    int32_t reserved;
} kstrip_strip_f32;

/**
 * Where the outputs of kstrip_evaluate() and kstrip_patch_evaluate() go. An output that is NULL is
 * not computed and costs nothing.
 */
typedef struct kstrip_outputs_f32 {
    struct kstrip_result_f32 *result;
    struct kstrip_derivatives_f32 *derivatives;
    struct kstrip_law_derivatives_f32 *law_derivatives;
    float *friction;
    struct kstrip_strip_f32 *strips;
    uint32_t *count;
    uint32_t capacity;
    uint32_t reserved;
} kstrip_outputs_f32;

/** kstrip_evaluate() in single precision. */
kstrip_status kstrip_evaluate_f32(const struct kstrip_contact_f32 *contact,
                                  const struct kstrip_creepage_f32 *creepage,
                                  const struct kstrip_friction_f32 *friction,
                                  const struct kstrip_options *options,
                                  const struct kstrip_outputs_f32 *outputs);

/**
 * Many contacts with their motion and their friction: for each quantity a pointer to the first one
 * and the distance to the next in bytes, its stride. An input with stride 0 is the same for all
 * contacts.
 *
 * Arrays of structures (&contacts[0].a, sizeof(kstrip_contact)) and one array for each quantity
 * (a, sizeof(double)) are both possible. All members but mismatch and law are required, unless
 * there are no contacts.
 */
typedef struct kstrip_batch_inputs_f32 {
    const float *a;
    ptrdiff_t a_stride;
    const float *b;
    ptrdiff_t b_stride;
    const float *normal_force;
    ptrdiff_t normal_force_stride;
    const float *shear_modulus;
    ptrdiff_t shear_modulus_stride;
    const float *poisson_ratio;
    ptrdiff_t poisson_ratio_stride;
    const float *friction;
    ptrdiff_t friction_stride;
    const float *mismatch;
    ptrdiff_t mismatch_stride;
    const float *longitudinal;
    ptrdiff_t longitudinal_stride;
    const float *lateral;
    ptrdiff_t lateral_stride;
    const float *spin;
    ptrdiff_t spin_stride;
    const struct kstrip_friction_f32 *law;
    ptrdiff_t law_stride;
} kstrip_batch_inputs_f32;

/**
 * Where the results of many contacts go: for each quantity a pointer to the first one and the
 * distance to the next in bytes. An output that is NULL is not computed and costs nothing.
 */
typedef struct kstrip_batch_outputs_f32 {
    float *fx;
    ptrdiff_t fx_stride;
    float *fy;
    ptrdiff_t fy_stride;
    float *mz;
    ptrdiff_t mz_stride;
    float *power;
    ptrdiff_t power_stride;
    float *adhesion;
    ptrdiff_t adhesion_stride;
    int32_t *status_detail;
    ptrdiff_t status_detail_stride;
    float *friction;
    ptrdiff_t friction_stride;
    struct kstrip_derivatives_f32 *derivatives;
    ptrdiff_t derivatives_stride;
    struct kstrip_law_derivatives_f32 *law_derivatives;
    ptrdiff_t law_derivatives_stride;
} kstrip_batch_outputs_f32;

/** kstrip_evaluate_batch() in single precision. */
kstrip_status kstrip_evaluate_batch_f32(const struct kstrip_batch_inputs_f32 *inputs,
                                        uint32_t count,
                                        const struct kstrip_options *options,
                                        const struct kstrip_batch_outputs_f32 *outputs,
                                        uint32_t *first_bad);

/**
 * A contact for which kstrip_prepare() has computed everything that does not depend on the motion.
 * The structure holds plain numbers and no pointers, so it may be copied and kept, for this
 * version of the library only. It begins with a mark: a structure that was never prepared, or was
 * prepared in the other precision, gives KSTRIP_ERROR_NOT_PREPARED.
 */
typedef struct kstrip_prepared_f32 {
    float numbers[96];
    int32_t model;
    int32_t strips;
} kstrip_prepared_f32;

/** kstrip_prepare() in single precision. */
kstrip_status kstrip_prepare_f32(const struct kstrip_contact_f32 *contact,
                                 const struct kstrip_options *options,
                                 struct kstrip_prepared_f32 *prepared);

/** kstrip_solve_prepared() in single precision. */
kstrip_status kstrip_solve_prepared_f32(const struct kstrip_prepared_f32 *prepared,
                                        const struct kstrip_creepage_f32 *creepage,
                                        struct kstrip_result_f32 *result);

/**
 * Motion of the upper body relative to the lower one at the contact, in axes that stay when the
 * motion reverses.
 */
typedef struct kstrip_motion_f32 {
    float slip_x;
    float slip_y;
    float spin_rate;
    float rolling_speed;
    float floor_speed;
} kstrip_motion_f32;

/** Derivatives of fx, fy, mz with respect to motion, load and friction. */
typedef struct kstrip_motion_derivatives_f32 {
    float slip[3][3];
    float rolling_speed[3];
    float normal_force[3];
    float load_through_hertz[3];
    float friction[3];
    float ratio[3];
    float decay[3];
    float slope_factor[3];
    float slide_factor[3];
    float layer[3];
} kstrip_motion_derivatives_f32;

/**
 * Where the outputs of kstrip_solve_motion() go. An output that is NULL is not computed and costs
 * nothing.
 */
typedef struct kstrip_motion_outputs_f32 {
    struct kstrip_result_f32 *result;
    struct kstrip_motion_derivatives_f32 *derivatives;
    float *friction;
} kstrip_motion_outputs_f32;

/** kstrip_solve_motion() in single precision. */
kstrip_status kstrip_solve_motion_f32(const struct kstrip_contact_f32 *contact,
                                      const struct kstrip_motion_f32 *motion,
                                      const struct kstrip_friction_f32 *friction,
                                      const struct kstrip_options *options,
                                      const struct kstrip_motion_outputs_f32 *outputs);

/** kstrip_solve_total() in single precision. */
kstrip_status kstrip_solve_total_f32(const struct kstrip_contact_f32 *contact,
                                     const struct kstrip_creepage_f32 *creepage,
                                     struct kstrip_result_f32 *result);

/** kstrip_solve_strip() in single precision. */
kstrip_status kstrip_solve_strip_f32(const struct kstrip_contact_f32 *contact,
                                     const struct kstrip_creepage_f32 *creepage,
                                     int32_t strips,
                                     struct kstrip_result_f32 *result);

/** kstrip_solve_strip_1967() in single precision. */
kstrip_status kstrip_solve_strip_1967_f32(const struct kstrip_contact_f32 *contact,
                                          const struct kstrip_creepage_f32 *creepage,
                                          int32_t strips,
                                          struct kstrip_result_f32 *result);

/** kstrip_solve_linear() in single precision. */
kstrip_status kstrip_solve_linear_f32(const struct kstrip_contact_f32 *contact,
                                      const struct kstrip_creepage_f32 *creepage,
                                      struct kstrip_result_f32 *result);

/** @} */

/**
 * @defgroup kstrip_inside_f32 Inside the contact: pressure, traction, slip
 * @{
 */

/** The state of a point of the contact plane. Tractions act on the lower body. */
typedef struct kstrip_point_f32 {
    float pressure;
    float traction_x;
    float traction_y;
    float slip_x;
    float slip_y;
    float dissipation;
    int32_t state;
    int32_t reserved;
} kstrip_point_f32;

/** kstrip_field() in single precision. */
kstrip_status kstrip_field_f32(const struct kstrip_contact_f32 *contact,
                               const struct kstrip_creepage_f32 *creepage,
                               const struct kstrip_friction_f32 *friction,
                               const struct kstrip_options *options,
                               const float *x,
                               uint32_t columns,
                               const float *y,
                               uint32_t rows,
                               struct kstrip_point_f32 *points,
                               uint32_t capacity);

/** @} */

/**
 * @defgroup kstrip_patch_f32 Patches of any shape
 * @{
 */

/**
 * The undeformed distance of two bodies across the rolling direction, at points in ascending y.
 * The points are smoothed over the length that kstrip_profile_contact gives.
 */
typedef struct kstrip_profile_f32 {
    const float *y;
    const float *distance;
    const float *centre_x;
    const float *rolling_radius;
    uint32_t points;
    uint32_t reserved;
} kstrip_profile_f32;

/**
 * Load or approach, material and friction of two profiles that are pressed together. Zero is the
 * default of every member but rolling_radius, shear_modulus and one of normal_force and approach.
 */
typedef struct kstrip_profile_contact_f32 {
    float rolling_radius;
    float normal_force;
    float approach;
    float smoothing_length;
    float shear_modulus;
    float poisson_ratio;
    float friction;
    int32_t strips;
    int32_t reserved;
} kstrip_profile_contact_f32;

/**
 * One strip of a patch, along the rolling direction. Its pressure is a half-ellipse in x,
 * peak_pressure sqrt(1 - (x - centre_x)^2/half_length^2), and does not vary over its width.
 */
typedef struct kstrip_patch_strip_f32 {
    float y;
    float width;
    float half_length;
    float centre_x;
    float peak_pressure;
    float friction;
} kstrip_patch_strip_f32;

/**
 * A contact patch of any shape: its strips, in ascending y. Filled by kstrip_patch_from_contact(),
 * kstrip_patch_from_strips() or kstrip_patch_from_profile(); the members may then be changed. All
 * functions check it again. A patch whose members are all zero, except shear_modulus, carries no
 * load.
 *
 * If the distance of two neighbours is more than one and a half times the distance at which they
 * touch, there is a gap, and the strips on either side are separate contact regions (lobes).
 */
typedef struct kstrip_patch_f32 {
    struct kstrip_patch_strip_f32 strips[KSTRIP_PATCH_CAPACITY];
    float shear_modulus;
    float poisson_ratio;
    float area_scale;
    float lever_scale;
    uint32_t count;
    uint32_t reserved;
    float mismatch;
} kstrip_patch_f32;

/** Approach, load and pressure of two profiles in contact. */
typedef struct kstrip_profile_result_f32 {
    float approach;
    float normal_force;
    float stiffness;
    float peak_pressure;
    float peak_y;
    uint32_t iterations;
    kstrip_status status_detail;
    float lowest;
} kstrip_profile_result_f32;

/** kstrip_patch_from_profile() in single precision. */
kstrip_status kstrip_patch_from_profile_f32(const struct kstrip_profile_f32 *profile,
                                            const struct kstrip_profile_contact_f32 *contact,
                                            struct kstrip_patch_f32 *patch,
                                            struct kstrip_profile_result_f32 *result);

/** kstrip_patch_from_strips() in single precision. */
kstrip_status kstrip_patch_from_strips_f32(const struct kstrip_patch_strip_f32 *strips,
                                           uint32_t count,
                                           float shear_modulus,
                                           float poisson_ratio,
                                           struct kstrip_patch_f32 *patch);

/** kstrip_patch_from_contact() in single precision. */
kstrip_status kstrip_patch_from_contact_f32(const struct kstrip_contact_f32 *contact,
                                            const struct kstrip_options *options,
                                            struct kstrip_patch_f32 *patch);

/** Load, friction bound and area of a patch. */
typedef struct kstrip_patch_summary_f32 {
    float normal_force;
    float friction_bound;
    float area;
    uint32_t lobes;
    uint32_t reserved;
} kstrip_patch_summary_f32;

/** kstrip_patch_summarize() in single precision. */
kstrip_status kstrip_patch_summarize_f32(const struct kstrip_patch_f32 *patch,
                                         struct kstrip_patch_summary_f32 *summary);

/** kstrip_patch_evaluate() in single precision. */
kstrip_status kstrip_patch_evaluate_f32(const struct kstrip_patch_f32 *patch,
                                        const struct kstrip_creepage_f32 *creepage,
                                        const struct kstrip_friction_f32 *friction,
                                        const struct kstrip_options *options,
                                        const struct kstrip_outputs_f32 *outputs);

/** kstrip_patch_evaluate_strips() in single precision. */
kstrip_status kstrip_patch_evaluate_strips_f32(const struct kstrip_patch_f32 *patch,
                                               const struct kstrip_creepage_f32 *creepage,
                                               const struct kstrip_creepage_f32 *own,
                                               const struct kstrip_friction_f32 *friction,
                                               const struct kstrip_options *options,
                                               const struct kstrip_outputs_f32 *outputs);

/** kstrip_patch_field() in single precision. */
kstrip_status kstrip_patch_field_f32(const struct kstrip_patch_f32 *patch,
                                     const struct kstrip_creepage_f32 *creepage,
                                     const struct kstrip_friction_f32 *friction,
                                     const struct kstrip_options *options,
                                     const float *x,
                                     uint32_t columns,
                                     const float *y,
                                     uint32_t rows,
                                     struct kstrip_point_f32 *points,
                                     uint32_t capacity);

/** @} */

/**
 * @defgroup kstrip_wheel_rail_f32 Wheel on rail: from two profiles to the forces on the wheel
 * @{
 */

/** kstrip_read_profile() in single precision. */
kstrip_status kstrip_read_profile_f32(const char *text,
                                      uint32_t length,
                                      uint32_t format,
                                      float *y,
                                      float *z,
                                      uint32_t capacity,
                                      uint32_t *count,
                                      uint32_t *notes);

/** kstrip_orient_profiles() in single precision. */
kstrip_status kstrip_orient_profiles_f32(const float *y,
                                         const float *z,
                                         const uint32_t *counts,
                                         uint32_t profile_count,
                                         uint32_t format,
                                         float unit,
                                         float *turned_y,
                                         float *turned_z,
                                         float *taken_unit,
                                         uint32_t *notes);

/**
 * A profile, prepared by kstrip_prepare_profile(): points at equal steps of its length, toward
 * larger y, and its direction. It holds plain numbers and may be copied.
 */
typedef struct kstrip_surface_f32 {
    float y[KSTRIP_SURFACE_CAPACITY];
    float z[KSTRIP_SURFACE_CAPACITY];
    float cosine[KSTRIP_SURFACE_CAPACITY];
    float sine[KSTRIP_SURFACE_CAPACITY];
    float step;
    float spacing;
    uint32_t count;
    uint32_t form;
} kstrip_surface_f32;

/** kstrip_prepare_profile() in single precision. */
kstrip_status kstrip_prepare_profile_f32(const float *y,
                                         const float *z,
                                         uint32_t points,
                                         float step,
                                         float smoothing_length,
                                         struct kstrip_surface_f32 *surface);

/** kstrip_profile_between() in single precision. */
kstrip_status kstrip_profile_between_f32(const struct kstrip_surface_f32 *first,
                                         const struct kstrip_surface_f32 *second,
                                         float share,
                                         struct kstrip_surface_f32 *between);

/**
 * Position of the wheel on straight track. The flange of a right wheel touches the gauge side of
 * the rail, which is at small y.
 */
typedef struct kstrip_wheel_position_f32 {
    float lateral;
    float vertical;
    float yaw;
    float roll;
} kstrip_wheel_position_f32;

/**
 * The gap between a wheel and a rail, point by point along the rail. A host with its own search of
 * contact fills it. The first count elements of each member are used.
 */
typedef struct kstrip_gap_f32 {
    float along[KSTRIP_SURFACE_CAPACITY];
    float distance[KSTRIP_SURFACE_CAPACITY];
    float x[KSTRIP_SURFACE_CAPACITY];
    float y[KSTRIP_SURFACE_CAPACITY];
    float z[KSTRIP_SURFACE_CAPACITY];
    float angle[KSTRIP_SURFACE_CAPACITY];
    float rolling_radius[KSTRIP_SURFACE_CAPACITY];
    float step;
    uint32_t count;
    uint32_t reserved;
} kstrip_gap_f32;

/** kstrip_touch() in single precision. */
kstrip_status kstrip_touch_f32(const struct kstrip_surface_f32 *rail,
                               const struct kstrip_surface_f32 *wheel,
                               float wheel_radius,
                               const struct kstrip_wheel_position_f32 *position,
                               float reach,
                               struct kstrip_gap_f32 *gap,
                               float *least);

/**
 * Materials and friction of a wheel and a rail, and options of the computation. Zero is the
 * default of every member but wheel_radius and shear_modulus.
 */
typedef struct kstrip_wheel_pair_f32 {
    float wheel_radius;
    float shear_modulus;
    float poisson_ratio;
    float friction;
    float friction_y[KSTRIP_RAIL_FRICTION_CAPACITY];
    float friction_at[KSTRIP_RAIL_FRICTION_CAPACITY];
    uint32_t friction_points;
    int32_t left;
    float smoothing_length;
    int32_t strips;
    int32_t model;
    float normal_damping;
    float floor_speed;
    float rail_radius;
    float rail_ahead;
    float rail_speed;
} kstrip_wheel_pair_f32;

/** One contact of a wheel. Its frame (x, t, n): forward, across the surface, into the rail. */
typedef struct kstrip_wheel_contact_f32 {
    float origin[3];
    float angle;
    float angle_range;
    float radius;
    float normal_force;
    float share;
    float approach;
    float stiffness;
    float along;
    float normal[6];
    float slip_x[6];
    float slip_y[6];
    float spin_rate[6];
    float rolling_speed[6];
    float normal_damping;
    struct kstrip_motion_f32 at_rest;
    struct kstrip_patch_f32 patch;
    float rail_axis[2];
    float rail_rate;
    float strip_rail_speed[KSTRIP_PATCH_CAPACITY];
    float strip_y[KSTRIP_PATCH_CAPACITY];
    float strip_z[KSTRIP_PATCH_CAPACITY];
    float strip_angle[KSTRIP_PATCH_CAPACITY];
    float strip_lean[KSTRIP_PATCH_CAPACITY];
    float turned[2];
    int32_t left;
    int32_t reserved;
} kstrip_wheel_contact_f32;

/** kstrip_contacts_from_gap() in single precision. */
kstrip_status kstrip_contacts_from_gap_f32(const struct kstrip_gap_f32 *gap,
                                           const struct kstrip_wheel_pair_f32 *pair,
                                           const struct kstrip_wheel_position_f32 *position,
                                           struct kstrip_patch_f32 *workspace,
                                           struct kstrip_wheel_contact_f32 *contacts,
                                           uint32_t *count);

/**
 * Velocity of the wheel relative to the rail. The axes are at rest; in a curve they are those of
 * the momentary track. Lateral, roll and yaw have the track's signs for a left wheel too.
 */
typedef struct kstrip_wheel_velocity_f32 {
    float forward;
    float lateral;
    float vertical;
    float roll;
    float pitch;
    float yaw;
} kstrip_wheel_velocity_f32;

/** kstrip_wheel_motion() in single precision. */
kstrip_status kstrip_wheel_motion_f32(const struct kstrip_wheel_contact_f32 *contact,
                                      const struct kstrip_wheel_velocity_f32 *velocity,
                                      struct kstrip_motion_f32 *motion);

/**
 * Force and moment on a wheel. They are conjugate to the members of kstrip_wheel_velocity: the
 * products add up to power.
 */
typedef struct kstrip_wrench_f32 {
    float force[3];
    float moment[3];
    float dissipation;
    float normal_force;
    uint32_t contacts;
    kstrip_status status_detail;
} kstrip_wrench_f32;

/** Exact derivatives of the wrench. The rows are the members of force and moment. */
typedef struct kstrip_wrench_derivatives_f32 {
    float velocity[6][6];
    float friction[6];
} kstrip_wrench_derivatives_f32;

/** kstrip_wrench_from_contacts() in single precision. */
kstrip_status kstrip_wrench_from_contacts_f32(const struct kstrip_wheel_contact_f32 *contacts,
                                              uint32_t count,
                                              const struct kstrip_wheel_velocity_f32 *velocity,
                                              int32_t model,
                                              const struct kstrip_friction_f32 *friction,
                                              struct kstrip_wrench_f32 *wrench,
                                              struct kstrip_wrench_derivatives_f32 *derivatives);

/** One strip of a contact of a wheel: its load, and the power that friction dissipates in it. */
typedef struct kstrip_strip_power_f32 {
    float wheel_y;
    float width;
    float normal_force;
    float fx;
    float fy;
    float slip;
    float power;
} kstrip_strip_power_f32;

/** kstrip_contact_power_across() in single precision. */
kstrip_status kstrip_contact_power_across_f32(const struct kstrip_wheel_contact_f32 *contact,
                                              const struct kstrip_wheel_velocity_f32 *velocity,
                                              int32_t model,
                                              const struct kstrip_friction_f32 *friction,
                                              struct kstrip_strip_power_f32 *strips,
                                              uint32_t capacity,
                                              uint32_t *count);

/**
 * Caller-provided memory for the computation of one wheel. It may hold anything before a call.
 * After KSTRIP_OK or a warning it holds the gap and the contacts of the position; after an error
 * its contents have no meaning.
 */
typedef struct kstrip_wheel_workspace_f32 {
    struct kstrip_gap_f32 gap;
    struct kstrip_patch_f32 strips;
    struct kstrip_wheel_contact_f32 contacts[KSTRIP_CONTACTS_CAPACITY];
    uint32_t count;
    uint32_t reserved;
} kstrip_wheel_workspace_f32;

/** Derivatives of the wrench with respect to the wheel's position at constant velocity. */
typedef struct kstrip_wrench_by_position_f32 {
    float lateral[6];
    float vertical[6];
    float yaw[6];
    float roll[6];
} kstrip_wrench_by_position_f32;

/** kstrip_wheel_on_rail() in single precision. */
kstrip_status kstrip_wheel_on_rail_f32(const struct kstrip_surface_f32 *rail,
                                       const struct kstrip_surface_f32 *wheel,
                                       const struct kstrip_wheel_pair_f32 *pair,
                                       const struct kstrip_wheel_position_f32 *position,
                                       const struct kstrip_wheel_velocity_f32 *velocity,
                                       const struct kstrip_friction_f32 *friction,
                                       struct kstrip_wheel_workspace_f32 *workspace,
                                       struct kstrip_wrench_f32 *wrench,
                                       struct kstrip_wrench_derivatives_f32 *derivatives,
                                       struct kstrip_wrench_by_position_f32 *by_position);

/** kstrip_wheels_on_rails() in single precision. */
kstrip_status kstrip_wheels_on_rails_f32(const struct kstrip_surface_f32 *rail,
                                         const struct kstrip_surface_f32 *wheel,
                                         uint32_t count,
                                         const struct kstrip_wheel_pair_f32 *pairs,
                                         uint32_t pair_stride,
                                         const struct kstrip_wheel_position_f32 *positions,
                                         uint32_t position_stride,
                                         const struct kstrip_wheel_velocity_f32 *velocities,
                                         uint32_t velocity_stride,
                                         const struct kstrip_friction_f32 *friction,
                                         uint32_t friction_stride,
                                         const struct kstrip_table *table,
                                         struct kstrip_wheel_workspace_f32 *workspace,
                                         struct kstrip_wrench_f32 *wrenches,
                                         struct kstrip_wrench_derivatives_f32 *derivatives,
                                         struct kstrip_wrench_by_position_f32 *by_position,
                                         struct kstrip_wheel_contact_f32 *contacts,
                                         uint32_t room,
                                         kstrip_status *statuses);

/** kstrip_height_for_load() in single precision. */
kstrip_status kstrip_height_for_load_f32(const struct kstrip_surface_f32 *rail,
                                         const struct kstrip_surface_f32 *wheel,
                                         const struct kstrip_wheel_pair_f32 *pair,
                                         const struct kstrip_wheel_position_f32 *position,
                                         float support,
                                         const struct kstrip_wheel_velocity_f32 *velocity,
                                         const struct kstrip_friction_f32 *friction,
                                         const struct kstrip_table *table,
                                         struct kstrip_wheel_workspace_f32 *workspace,
                                         float *vertical);

/** kstrip_heights_for_loads() in single precision. */
kstrip_status kstrip_heights_for_loads_f32(const struct kstrip_surface_f32 *rail,
                                           const struct kstrip_surface_f32 *wheel,
                                           uint32_t count,
                                           const struct kstrip_wheel_pair_f32 *pairs,
                                           uint32_t pair_stride,
                                           const struct kstrip_wheel_position_f32 *positions,
                                           uint32_t position_stride,
                                           const float *supports,
                                           uint32_t support_stride,
                                           const struct kstrip_wheel_velocity_f32 *velocities,
                                           uint32_t velocity_stride,
                                           const struct kstrip_friction_f32 *friction,
                                           uint32_t friction_stride,
                                           const struct kstrip_table *table,
                                           struct kstrip_wheel_workspace_f32 *workspace,
                                           float *verticals,
                                           kstrip_status *statuses);

/** Ranges of a contact table, and how many nodes it has. */
typedef struct kstrip_table_spec_f32 {
    float lateral_from;
    float lateral_to;
    float yaw;
    float roll;
    float load;
    uint32_t lateral_nodes;
    uint32_t levels;
    uint32_t yaw_nodes;
    uint32_t roll_nodes;
    uint32_t strips;
    uint32_t reserved;
} kstrip_table_spec_f32;

/** kstrip_table_size() in single precision. */
kstrip_status kstrip_table_size_f32(const struct kstrip_surface_f32 *wheel,
                                    const struct kstrip_table_spec_f32 *spec,
                                    uint32_t *bytes,
                                    uint32_t *parts);

/** kstrip_table_begin() in single precision. */
kstrip_status kstrip_table_begin_f32(const struct kstrip_surface_f32 *rail,
                                     const struct kstrip_surface_f32 *wheel,
                                     const struct kstrip_wheel_pair_f32 *pair,
                                     const struct kstrip_table_spec_f32 *spec,
                                     struct kstrip_wheel_workspace_f32 *workspace,
                                     uint8_t *table,
                                     uint32_t bytes);

/** kstrip_table_fill() in single precision. */
kstrip_status kstrip_table_fill_f32(const struct kstrip_surface_f32 *rail,
                                    const struct kstrip_surface_f32 *wheel,
                                    const struct kstrip_wheel_pair_f32 *pair,
                                    uint32_t first,
                                    uint32_t count,
                                    struct kstrip_wheel_workspace_f32 *workspace,
                                    uint8_t *table,
                                    uint32_t bytes);

/** The size of a finished table, and its measured error. */
typedef struct kstrip_table_report_f32 {
    float force_usual;
    float force_largest;
    float load_usual;
    float load_largest;
    uint32_t bytes;
    uint32_t poses;
    uint32_t missing;
    uint32_t empty;
} kstrip_table_report_f32;

/** kstrip_table_finish() in single precision. */
kstrip_status kstrip_table_finish_f32(const struct kstrip_surface_f32 *rail,
                                      const struct kstrip_surface_f32 *wheel,
                                      const struct kstrip_wheel_pair_f32 *pair,
                                      uint32_t poses,
                                      struct kstrip_wheel_workspace_f32 *workspace,
                                      uint8_t *table,
                                      uint32_t bytes,
                                      struct kstrip_table_report_f32 *report);

/** kstrip_table_check() in single precision. */
kstrip_status kstrip_table_check_f32(const uint8_t *table, uint32_t bytes, uint32_t *length);

/** kstrip_wheel_on_table() in single precision. */
kstrip_status kstrip_wheel_on_table_f32(const struct kstrip_table *table,
                                        const struct kstrip_wheel_pair_f32 *pair,
                                        const struct kstrip_wheel_position_f32 *position,
                                        const struct kstrip_wheel_velocity_f32 *velocity,
                                        const struct kstrip_friction_f32 *friction,
                                        struct kstrip_wheel_workspace_f32 *workspace,
                                        struct kstrip_wrench_f32 *wrench,
                                        struct kstrip_wrench_derivatives_f32 *derivatives,
                                        struct kstrip_wrench_by_position_f32 *by_position);

/** @} */

/**
 * @defgroup kstrip_wheelset_f32 The wheelset: two wheels on two rails
 * @{
 */

/** kstrip_gauge_face() in single precision. */
kstrip_status kstrip_gauge_face_f32(const struct kstrip_surface_f32 *rail,
                                    float depth,
                                    float *face);

/** A curve that a vehicle runs through: the axes of the track move forward and turn with it. */
typedef struct kstrip_curve_f32 {
    float speed;
    float curvature;
    float cant;
    float gravity;
} kstrip_curve_f32;

/** kstrip_curve_motion() in single precision. */
kstrip_status kstrip_curve_motion_f32(const struct kstrip_curve_f32 *curve,
                                      const struct kstrip_wheel_position_f32 *position,
                                      const struct kstrip_wheel_velocity_f32 *relative,
                                      struct kstrip_wheel_velocity_f32 *velocity,
                                      float *weight);

/**
 * A wheelset: two wheels on an axle. Number 0 is the right wheel, number 1 the left one.
 * KSTRIP_ERROR_GAUGE if back_to_back and running_circles are both 0, or one of them is negative.
 */
typedef struct kstrip_wheelset_f32 {
    const struct kstrip_surface_f32 *wheel[2];
    const struct kstrip_friction_f32 *friction[2];
    const struct kstrip_table *table[2];
    struct kstrip_wheel_pair_f32 pair[2];
    float back_to_back;
    float running_circles;
} kstrip_wheelset_f32;

/**
 * Displacement and velocity of a rail: irregularities of the track, or the motion of a flexible
 * rail. Axes of the track.
 */
typedef struct kstrip_rail_motion_f32 {
    float lateral;
    float vertical;
    float lateral_velocity;
    float vertical_velocity;
} kstrip_rail_motion_f32;

/**
 * A track: two rails, and where they are. Axes: x forward, y to the right, z down; the middle of
 * the track is midway between the gauge faces. Cant and inclination of the track are those of
 * these axes; the inclination of the rails is in their profiles. Number 0 is the right side,
 * number 1 the left side. KSTRIP_ERROR_GAUGE if gauge, gauge_depth or an origin is negative, or if
 * the gauge is 0 and used; KSTRIP_WARNING_PROFILE_END if a rail ends above gauge_depth.
 */
typedef struct kstrip_track_f32 {
    const struct kstrip_surface_f32 *rail[2];
    float gauge;
    float gauge_depth;
    float origin[2];
    struct kstrip_rail_motion_f32 motion[2];
} kstrip_track_f32;

/**
 * Caller-provided memory for the computation of a wheelset: that of the right wheel and that of
 * the left one. It may hold anything before a call. After KSTRIP_OK or a warning it holds gap and
 * contacts of both wheels.
 */
typedef struct kstrip_wheelset_workspace_f32 {
    struct kstrip_wheel_workspace_f32 wheel[2];
} kstrip_wheelset_workspace_f32;

/** Forces on a wheelset, on each wheel, and on each rail. */
typedef struct kstrip_wheelset_forces_f32 {
    struct kstrip_wrench_f32 wrench;
    struct kstrip_wrench_f32 wheel[2];
    float rail[2][3];
} kstrip_wheelset_forces_f32;

/**
 * Exact derivatives of the forces on a wheelset and its two rails with respect to the velocities.
 * Rows are the ten forces: force and moment on the wheelset, then lateral and vertical force on
 * the right rail and on the left rail. Columns are the ten degrees of freedom
 * (KSTRIP_WHEELSET_FREEDOMS).
 */
typedef struct kstrip_wheelset_derivatives_f32 {
    float velocity[KSTRIP_WHEELSET_FREEDOMS][KSTRIP_WHEELSET_FREEDOMS];
    float friction[KSTRIP_WHEELSET_FREEDOMS];
} kstrip_wheelset_derivatives_f32;

/**
 * Derivatives of the same ten forces with respect to the positions of the ten degrees of freedom,
 * at constant velocities.
 */
typedef struct kstrip_wheelset_by_position_f32 {
    float position[KSTRIP_WHEELSET_FREEDOMS][KSTRIP_WHEELSET_FREEDOMS];
} kstrip_wheelset_by_position_f32;

/** kstrip_wheelset_on_track() in single precision. */
kstrip_status kstrip_wheelset_on_track_f32(const struct kstrip_wheelset_f32 *set,
                                           const struct kstrip_track_f32 *track,
                                           const struct kstrip_wheel_position_f32 *position,
                                           const struct kstrip_wheel_velocity_f32 *velocity,
                                           struct kstrip_wheelset_workspace_f32 *workspace,
                                           struct kstrip_wheelset_forces_f32 *forces,
                                           struct kstrip_wheelset_derivatives_f32 *derivatives,
                                           struct kstrip_wheelset_by_position_f32 *by_position);

/** Loads of the vehicle and of gravity on a wheelset that does not accelerate. */
typedef struct kstrip_wheelset_loads_f32 {
    float vertical;
    float roll;
    float pitch;
} kstrip_wheelset_loads_f32;

/** kstrip_wheelset_settle() in single precision. */
kstrip_status kstrip_wheelset_settle_f32(const struct kstrip_wheelset_f32 *set,
                                         const struct kstrip_track_f32 *track,
                                         const struct kstrip_wheel_position_f32 *start,
                                         const struct kstrip_wheel_velocity_f32 *velocity,
                                         const struct kstrip_wheelset_loads_f32 *loads,
                                         struct kstrip_wheelset_workspace_f32 *workspace,
                                         struct kstrip_wheel_position_f32 *position,
                                         struct kstrip_wheel_velocity_f32 *moves,
                                         struct kstrip_wheelset_forces_f32 *forces);

/** kstrip_wheelsets_on_track() in single precision. */
kstrip_status kstrip_wheelsets_on_track_f32(const struct kstrip_wheelset_f32 *set,
                                            const struct kstrip_track_f32 *track,
                                            uint32_t count,
                                            const struct kstrip_wheel_position_f32 *positions,
                                            uint32_t position_stride,
                                            const struct kstrip_wheel_velocity_f32 *velocities,
                                            uint32_t velocity_stride,
                                            struct kstrip_wheelset_workspace_f32 *workspace,
                                            struct kstrip_wheelset_forces_f32 *forces,
                                            struct kstrip_wheelset_derivatives_f32 *derivatives,
                                            struct kstrip_wheelset_by_position_f32 *by_position,
                                            kstrip_status *statuses);

/** kstrip_wheelsets_settle() in single precision. */
kstrip_status kstrip_wheelsets_settle_f32(const struct kstrip_wheelset_f32 *set,
                                          const struct kstrip_track_f32 *track,
                                          uint32_t count,
                                          const struct kstrip_wheel_position_f32 *starts,
                                          uint32_t start_stride,
                                          const struct kstrip_wheel_velocity_f32 *velocities,
                                          uint32_t velocity_stride,
                                          const struct kstrip_wheelset_loads_f32 *loads,
                                          uint32_t load_stride,
                                          struct kstrip_wheelset_workspace_f32 *workspace,
                                          struct kstrip_wheel_position_f32 *positions,
                                          struct kstrip_wheel_velocity_f32 *moves,
                                          struct kstrip_wheelset_forces_f32 *forces,
                                          kstrip_status *statuses);

/** kstrip_rolling_radius_difference() in single precision. */
kstrip_status kstrip_rolling_radius_difference_f32(const struct kstrip_wheelset_f32 *set,
                                                   const struct kstrip_track_f32 *track,
                                                   const float *shifts,
                                                   uint32_t count,
                                                   int32_t with_roll,
                                                   struct kstrip_wheelset_workspace_f32 *workspace,
                                                   float *differences,
                                                   kstrip_status *statuses);

/** kstrip_equivalent_conicity() in single precision. */
kstrip_status kstrip_equivalent_conicity_f32(const float *shifts,
                                             const float *differences,
                                             uint32_t count,
                                             float running_circles,
                                             float wheel_radius,
                                             const float *amplitudes,
                                             uint32_t number,
                                             float *conicities,
                                             float *wave_lengths,
                                             kstrip_status *statuses);

/** @} */

/**
 * @defgroup kstrip_rig_f32 Test rigs: friction from a force, creepage from a force, a law from a curve
 * @{
 */

/** A coefficient of friction from a measured force. */
typedef struct kstrip_friction_estimate_f32 {
    float friction;
    float sensitivity;
    float residual;
    kstrip_status status_detail;
    int32_t reserved;
} kstrip_friction_estimate_f32;

/** kstrip_estimate_friction() in single precision. */
kstrip_status kstrip_estimate_friction_f32(const struct kstrip_contact_f32 *contact,
                                           const struct kstrip_creepage_f32 *creepage,
                                           const struct kstrip_friction_f32 *friction,
                                           const struct kstrip_options *options,
                                           uint32_t measured,
                                           float fx,
                                           float fy,
                                           struct kstrip_friction_estimate_f32 *estimate);

/** kstrip_creepage_for_force() in single precision. */
kstrip_status kstrip_creepage_for_force_f32(const struct kstrip_contact_f32 *contact,
                                            float fx,
                                            float fy,
                                            float spin,
                                            const struct kstrip_friction_f32 *friction,
                                            const struct kstrip_options *options,
                                            struct kstrip_creepage_f32 *creepage);

/** One measured point of a creep curve. */
typedef struct kstrip_measured_force_f32 {
    float longitudinal;
    float lateral;
    float spin;
    float fx;
    float fy;
    float weight;
    uint32_t measured;
    uint32_t reserved;
} kstrip_measured_force_f32;

/** A law of friction that was fitted to measured points. */
typedef struct kstrip_friction_fit_f32 {
    struct kstrip_friction_f32 law;
    struct kstrip_friction_f32 standard_errors;
    float residual;
    uint32_t steps;
    kstrip_status status_detail;
} kstrip_friction_fit_f32;

/** kstrip_fit_friction() in single precision. */
kstrip_status kstrip_fit_friction_f32(const struct kstrip_contact_f32 *contact,
                                      const struct kstrip_measured_force_f32 *points,
                                      uint32_t count,
                                      const struct kstrip_friction_f32 *start,
                                      uint32_t parameters,
                                      const struct kstrip_options *options,
                                      struct kstrip_friction_fit_f32 *fit,
                                      uint32_t *first_bad);

/** @} */

/**
 * @defgroup kstrip_rest_f32 Options, upper body, version
 * @{
 */

/** kstrip_result_on_upper_body() in single precision. */
kstrip_status kstrip_result_on_upper_body_f32(const struct kstrip_result_f32 *lower,
                                              struct kstrip_result_f32 *upper);

/** @} */

#ifdef __cplusplus
} // extern "C"
#endif

#endif /* KSTRIP_F32_H */
