! kstrip from Fortran 2018: creep forces of rolling contact by Kalker's strip theory.
!
! Written from include/kstrip.h; do not edit:
! KSTRIP_WRITE_FORTRAN=1 cargo test --test builds fortran
!
! Names, units and signs are those of kstrip.h, which has more details. Every function returns a
! status: 0 is success, above 0 a warning, below 0 an error with outputs untouched;
! kstrip_message() returns the text of a status. Members of types are initially zero, and pointers
! null; zero selects the default of an option. Arguments that may be NULL in C are optional. An
! array that C stores by rows is stored by columns in Fortran: the derivative of force i with
! respect to creepage j is jacobian(j, i).
module kstrip
   use, intrinsic :: iso_c_binding
   implicit none

   integer(c_int32_t), parameter :: kstrip_ok = 0
   integer(c_int32_t), parameter :: kstrip_warning_spin = 1
   integer(c_int32_t), parameter :: kstrip_warning_range = 2
   integer(c_int32_t), parameter :: kstrip_warning_beyond_friction = 3
   integer(c_int32_t), parameter :: kstrip_warning_several_frictions = 4
   integer(c_int32_t), parameter :: kstrip_warning_not_converged = 5
   integer(c_int32_t), parameter :: kstrip_warning_friction_at_least = 6
   integer(c_int32_t), parameter :: kstrip_warning_creepage_at_least = 7
   integer(c_int32_t), parameter :: kstrip_warning_pressure = 8
   integer(c_int32_t), parameter :: kstrip_warning_creepage = 9
   integer(c_int32_t), parameter :: kstrip_warning_semi_axis = 10
   integer(c_int32_t), parameter :: kstrip_warning_spin_unit = 11
   integer(c_int32_t), parameter :: kstrip_warning_friction = 12
   integer(c_int32_t), parameter :: kstrip_warning_radius = 13
   integer(c_int32_t), parameter :: kstrip_warning_axis_ratio = 14
   integer(c_int32_t), parameter :: kstrip_warning_mismatch = 15
   integer(c_int32_t), parameter :: kstrip_warning_mismatch_neglected = 16
   integer(c_int32_t), parameter :: kstrip_warning_conformal = 17
   integer(c_int32_t), parameter :: kstrip_warning_angle_range = 19
   integer(c_int32_t), parameter :: kstrip_warning_profile_end = 18
   integer(c_int32_t), parameter :: kstrip_warning_undetermined = 20
   integer(c_int32_t), parameter :: kstrip_warning_orientation = 21
   integer(c_int32_t), parameter :: kstrip_warning_profile_size = 22
   integer(c_int32_t), parameter :: kstrip_warning_modulus = 23
   integer(c_int32_t), parameter :: kstrip_warning_unset = 24
   integer(c_int32_t), parameter :: kstrip_warning_support = 25
   integer(c_int32_t), parameter :: kstrip_warning_profile_coarse = 26
   integer(c_int32_t), parameter :: kstrip_warning_rough = 27
   integer(c_int32_t), parameter :: kstrip_warning_curvature = 28
   integer(c_int32_t), parameter :: kstrip_warning_young = 29
   integer(c_int32_t), parameter :: kstrip_warning_per_cent = 30
   integer(c_int32_t), parameter :: kstrip_warning_damping = 31
   integer(c_int32_t), parameter :: kstrip_warning_second_minimum = 32
   integer(c_int32_t), parameter :: kstrip_warning_fit_bound = 33
   integer(c_int32_t), parameter :: kstrip_warning_profile_guess = 34
   integer(c_int32_t), parameter :: kstrip_error_null = -1
   integer(c_int32_t), parameter :: kstrip_error_not_finite = -2
   integer(c_int32_t), parameter :: kstrip_error_semi_axis = -3
   integer(c_int32_t), parameter :: kstrip_error_normal_force = -4
   integer(c_int32_t), parameter :: kstrip_error_modulus = -5
   integer(c_int32_t), parameter :: kstrip_error_poisson_ratio = -6
   integer(c_int32_t), parameter :: kstrip_error_friction = -7
   integer(c_int32_t), parameter :: kstrip_error_model = -8
   integer(c_int32_t), parameter :: kstrip_error_strip_count = -9
   integer(c_int32_t), parameter :: kstrip_error_curvature = -10
   integer(c_int32_t), parameter :: kstrip_error_rolling_speed = -11
   integer(c_int32_t), parameter :: kstrip_error_capacity = -12
   integer(c_int32_t), parameter :: kstrip_error_not_in_model = -13
   integer(c_int32_t), parameter :: kstrip_error_overflow = -14
   integer(c_int32_t), parameter :: kstrip_error_friction_ratio = -15
   integer(c_int32_t), parameter :: kstrip_error_friction_decay = -16
   integer(c_int32_t), parameter :: kstrip_error_negative_speed = -17
   integer(c_int32_t), parameter :: kstrip_error_slope_factor = -18
   integer(c_int32_t), parameter :: kstrip_error_unexplained = -19
   integer(c_int32_t), parameter :: kstrip_error_force_beyond_friction = -20
   integer(c_int32_t), parameter :: kstrip_error_measured = -21
   integer(c_int32_t), parameter :: kstrip_error_not_prepared = -22
   integer(c_int32_t), parameter :: kstrip_error_floor_speed = -23
   integer(c_int32_t), parameter :: kstrip_error_stride = -24
   integer(c_int32_t), parameter :: kstrip_error_slide_factor = -25
   integer(c_int32_t), parameter :: kstrip_error_layer = -26
   integer(c_int32_t), parameter :: kstrip_error_few_points = -27
   integer(c_int32_t), parameter :: kstrip_error_fit_parameters = -28
   integer(c_int32_t), parameter :: kstrip_error_weight = -29
   integer(c_int32_t), parameter :: kstrip_error_model_left_out = -30
   integer(c_int32_t), parameter :: kstrip_error_modulus_unit = -31
   integer(c_int32_t), parameter :: kstrip_error_strip_size = -40
   integer(c_int32_t), parameter :: kstrip_error_pressure = -41
   integer(c_int32_t), parameter :: kstrip_error_strip_order = -42
   integer(c_int32_t), parameter :: kstrip_error_patch_size = -43
   integer(c_int32_t), parameter :: kstrip_error_profile = -44
   integer(c_int32_t), parameter :: kstrip_error_profile_end = -45
   integer(c_int32_t), parameter :: kstrip_error_rolling_radius = -46
   integer(c_int32_t), parameter :: kstrip_error_smoothing_length = -47
   integer(c_int32_t), parameter :: kstrip_error_scatter = -48
   integer(c_int32_t), parameter :: kstrip_error_normal_damping = -49
   integer(c_int32_t), parameter :: kstrip_error_share = -50
   integer(c_int32_t), parameter :: kstrip_error_support = -51
   integer(c_int32_t), parameter :: kstrip_error_angle = -52
   integer(c_int32_t), parameter :: kstrip_error_length_unit = -53
   integer(c_int32_t), parameter :: kstrip_error_swapped = -54
   integer(c_int32_t), parameter :: kstrip_error_orientation = -55
   integer(c_int32_t), parameter :: kstrip_error_gauge = -60
   integer(c_int32_t), parameter :: kstrip_error_wheel_lifted = -61
   integer(c_int32_t), parameter :: kstrip_error_conicity = -62
   integer(c_int32_t), parameter :: kstrip_error_file_format = -70
   integer(c_int32_t), parameter :: kstrip_error_file_line = -71
   integer(c_int32_t), parameter :: kstrip_error_file_columns = -72
   integer(c_int32_t), parameter :: kstrip_error_file_count = -73
   integer(c_int32_t), parameter :: kstrip_error_file_units = -74
   integer(c_int32_t), parameter :: kstrip_error_file_missing = -75
   integer(c_int32_t), parameter :: kstrip_error_slice_share = -76
   integer(c_int32_t), parameter :: kstrip_error_table = -80
   integer(c_int32_t), parameter :: kstrip_error_table_unfinished = -81
   integer(c_int32_t), parameter :: kstrip_error_table_pair = -82
   integer(c_int32_t), parameter :: kstrip_error_table_spec = -83
   integer(c_int32_t), parameter :: kstrip_error_table_range = -84
   integer(c_int32_t), parameter :: kstrip_model_default = 0
   integer(c_int32_t), parameter :: kstrip_model_strip_1967 = 1
   integer(c_int32_t), parameter :: kstrip_model_strip_1967_continuous = 2
   integer(c_int32_t), parameter :: kstrip_model_strip = 3
   integer(c_int32_t), parameter :: kstrip_model_total = 4
   integer(c_int32_t), parameter :: kstrip_model_linear = 5
   integer(c_int32_t), parameter :: kstrip_strips_capacity = 64
   integer(c_int32_t), parameter :: kstrip_state_outside = 0
   integer(c_int32_t), parameter :: kstrip_state_stick = 1
   integer(c_int32_t), parameter :: kstrip_state_slip = 2
   integer(c_int32_t), parameter :: kstrip_state_slip_negative_dissipation = 3
   integer(c_int32_t), parameter :: kstrip_patch_capacity = 64
   integer(c_int32_t), parameter :: kstrip_surface_capacity = 512
   integer(c_int32_t), parameter :: kstrip_contacts_capacity = 6
   integer(c_int32_t), parameter :: kstrip_rail_friction_capacity = 4
   integer(c_int32_t), parameter :: kstrip_format_any = 0
   integer(c_int32_t), parameter :: kstrip_format_simpack = 1
   integer(c_int32_t), parameter :: kstrip_format_miniprof = 2
   integer(c_int32_t), parameter :: kstrip_format_columns = 3
   integer(c_int32_t), parameter :: kstrip_format_wheel = 16
   integer(c_int32_t), parameter :: kstrip_format_rail = 32
   integer(c_int32_t), parameter :: kstrip_format_z_down = 64
   integer(c_int32_t), parameter :: kstrip_format_side = 128
   integer(c_int32_t), parameter :: kstrip_note_wheel = 1
   integer(c_int32_t), parameter :: kstrip_note_simpack = 2
   integer(c_int32_t), parameter :: kstrip_note_miniprof = 4
   integer(c_int32_t), parameter :: kstrip_note_z_turned = 8
   integer(c_int32_t), parameter :: kstrip_note_y_mirrored = 16
   integer(c_int32_t), parameter :: kstrip_note_reversed = 32
   integer(c_int32_t), parameter :: kstrip_note_running_circle = 64
   integer(c_int32_t), parameter :: kstrip_note_header = 128
   integer(c_int32_t), parameter :: kstrip_note_left_out = 256
   integer(c_int32_t), parameter :: kstrip_note_ignored = 512
   integer(c_int32_t), parameter :: kstrip_note_count = 1024
   integer(c_int32_t), parameter :: kstrip_note_unit_of_width = 2048
   integer(c_int32_t), parameter :: kstrip_note_doubt_kind = 4096
   integer(c_int32_t), parameter :: kstrip_note_doubt_z = 8192
   integer(c_int32_t), parameter :: kstrip_note_doubt_side = 16384
   integer(c_int32_t), parameter :: kstrip_note_doubt_unit = 32768
   integer(c_int32_t), parameter :: kstrip_note_doubt_origin = 65536
   integer(c_int32_t), parameter :: kstrip_note_doubt_points = 131072
   integer(c_int32_t), parameter :: kstrip_note_symmetric = 262144
   integer(c_int32_t), parameter :: kstrip_wheelset_freedoms = 10
   integer(c_int32_t), parameter :: kstrip_measured_fx = 1
   integer(c_int32_t), parameter :: kstrip_measured_fy = 2
   integer(c_int32_t), parameter :: kstrip_fit_friction_expected = 1
   integer(c_int32_t), parameter :: kstrip_fit_ratio = 2
   integer(c_int32_t), parameter :: kstrip_fit_decay = 4
   integer(c_int32_t), parameter :: kstrip_fit_slope_factor = 8
   integer(c_int32_t), parameter :: kstrip_fit_slide_factor = 16
   integer(c_int32_t), parameter :: kstrip_fit_layer = 32
   integer(c_int32_t), parameter :: kstrip_version_major = 0
   integer(c_int32_t), parameter :: kstrip_version_minor = 2
   integer(c_int32_t), parameter :: kstrip_version_patch = 0
   integer(c_int32_t), parameter :: kstrip_abi_version_expected = 1

   !> An isotropic elastic body.
   type, bind(c) :: kstrip_material
      real(c_double) :: shear_modulus = 0
      real(c_double) :: poisson_ratio = 0
   end type

   !> The combined elastic constants of two bodies.
   type, bind(c) :: kstrip_combined_material
      real(c_double) :: shear_modulus = 0
      real(c_double) :: poisson_ratio = 0
      real(c_double) :: mismatch = 0
   end type

   !> Radii of curvature of two bodies at the contact [m]: convex positive, flat infinite (INFINITY), concave negative.
   type, bind(c) :: kstrip_radii
      real(c_double) :: lower_x = 0
      real(c_double) :: lower_y = 0
      real(c_double) :: upper_x = 0
      real(c_double) :: upper_y = 0
   end type

   !> A loaded elliptic contact with combined elastic constants and Coulomb friction.
   type, bind(c) :: kstrip_contact
      real(c_double) :: a = 0
      real(c_double) :: b = 0
      real(c_double) :: normal_force = 0
      real(c_double) :: shear_modulus = 0
      real(c_double) :: poisson_ratio = 0
      real(c_double) :: friction = 0
      real(c_double) :: mismatch = 0
   end type

   !> The contact ellipse of Hertz.
   type, bind(c) :: kstrip_hertz_contact
      real(c_double) :: a = 0
      real(c_double) :: b = 0
      real(c_double) :: peak_pressure = 0
      real(c_double) :: approach = 0
      real(c_double) :: axis_ratio = 0
      real(c_double) :: hertz_angle = 0
      real(c_double) :: rho = 0
   end type

   !> Velocity of one body's material at the centre of the contact, relative to the contact.
   type, bind(c) :: kstrip_velocity
      real(c_double) :: x = 0
      real(c_double) :: y = 0
      real(c_double) :: angular_z = 0
   end type

   !> Rigid slip of the upper relative to the lower body, divided by the rolling speed (3.3).
   type, bind(c) :: kstrip_creepage
      real(c_double) :: longitudinal = 0
      real(c_double) :: lateral = 0
      real(c_double) :: spin = 0
   end type

   !> Kalker's parameters (5.13) of a contact in motion, dimensionless.
   type, bind(c) :: kstrip_parameters
      real(c_double) :: xi = 0
      real(c_double) :: eta = 0
      real(c_double) :: psi = 0
   end type

   !> The model and the number of strips.
   type, bind(c) :: kstrip_options
      integer(c_int32_t) :: model = 0
      integer(c_int32_t) :: strips = 0
   end type

   !> Forces on the lower body.
   type, bind(c) :: kstrip_result
      real(c_double) :: fx = 0
      real(c_double) :: fy = 0
      real(c_double) :: mz = 0
      real(c_double) :: power = 0
      real(c_double) :: adhesion = 0
      integer(c_int32_t) :: status_detail = 0
      integer(c_int32_t) :: reserved = 0
   end type

   !> Falling friction: the coefficient is friction ((1 - ratio) exp(-decay w) + ratio), where w is the sliding velocity
   !> [m/s].
   type, bind(c) :: kstrip_friction
      real(c_double) :: friction = 0
      real(c_double) :: ratio = 0
      real(c_double) :: decay = 0
      real(c_double) :: rolling_speed = 0
      real(c_double) :: slope_factor = 0
      real(c_double) :: slide_factor = 0
      real(c_double) :: layer = 0
   end type

   !> Derivatives of fx, fy, mz with respect to creepages, load and friction.
   type, bind(c) :: kstrip_derivatives
      real(c_double) :: jacobian(3, 3) = 0
      real(c_double) :: normal_force(3) = 0
      real(c_double) :: load_through_hertz(3) = 0
      real(c_double) :: friction(3) = 0
   end type

   !> Derivatives of fx, fy, mz with respect to the parameters of falling friction.
   type, bind(c) :: kstrip_law_derivatives
      real(c_double) :: ratio(3) = 0
      real(c_double) :: decay(3) = 0
      real(c_double) :: rolling_speed(3) = 0
      real(c_double) :: slope_factor(3) = 0
      real(c_double) :: slide_factor(3) = 0
      real(c_double) :: layer(3) = 0
   end type

   !> One strip y = const of a contact or a patch, and the forces that it carries on the lower body.
   type, bind(c) :: kstrip_strip
      real(c_double) :: y = 0
      real(c_double) :: width = 0
      real(c_double) :: half_length = 0
      real(c_double) :: separatrix = 0
      real(c_double) :: fx = 0
      real(c_double) :: fy = 0
      real(c_double) :: mz = 0
      real(c_double) :: power = 0
      integer(c_int32_t) :: state = 0
      integer(c_int32_t) :: reserved = 0
   end type

   !> Where the outputs of kstrip_evaluate() and kstrip_patch_evaluate() go.
   type, bind(c) :: kstrip_outputs
      type(c_ptr) :: result = c_null_ptr
      type(c_ptr) :: derivatives = c_null_ptr
      type(c_ptr) :: law_derivatives = c_null_ptr
      type(c_ptr) :: friction = c_null_ptr
      type(c_ptr) :: strips = c_null_ptr
      type(c_ptr) :: count = c_null_ptr
      integer(c_int32_t) :: capacity = 0
      integer(c_int32_t) :: reserved = 0
   end type

   !> Many contacts with their motion and their friction: for each quantity a pointer to the first one and the distance
   !> to the next in bytes, its stride.
   type, bind(c) :: kstrip_batch_inputs
      type(c_ptr) :: a = c_null_ptr
      integer(c_intptr_t) :: a_stride = 0
      type(c_ptr) :: b = c_null_ptr
      integer(c_intptr_t) :: b_stride = 0
      type(c_ptr) :: normal_force = c_null_ptr
      integer(c_intptr_t) :: normal_force_stride = 0
      type(c_ptr) :: shear_modulus = c_null_ptr
      integer(c_intptr_t) :: shear_modulus_stride = 0
      type(c_ptr) :: poisson_ratio = c_null_ptr
      integer(c_intptr_t) :: poisson_ratio_stride = 0
      type(c_ptr) :: friction = c_null_ptr
      integer(c_intptr_t) :: friction_stride = 0
      type(c_ptr) :: mismatch = c_null_ptr
      integer(c_intptr_t) :: mismatch_stride = 0
      type(c_ptr) :: longitudinal = c_null_ptr
      integer(c_intptr_t) :: longitudinal_stride = 0
      type(c_ptr) :: lateral = c_null_ptr
      integer(c_intptr_t) :: lateral_stride = 0
      type(c_ptr) :: spin = c_null_ptr
      integer(c_intptr_t) :: spin_stride = 0
      type(c_ptr) :: law = c_null_ptr
      integer(c_intptr_t) :: law_stride = 0
   end type

   !> Where the results of many contacts go: for each quantity a pointer to the first one and the distance to the next in
   !> bytes.
   type, bind(c) :: kstrip_batch_outputs
      type(c_ptr) :: fx = c_null_ptr
      integer(c_intptr_t) :: fx_stride = 0
      type(c_ptr) :: fy = c_null_ptr
      integer(c_intptr_t) :: fy_stride = 0
      type(c_ptr) :: mz = c_null_ptr
      integer(c_intptr_t) :: mz_stride = 0
      type(c_ptr) :: power = c_null_ptr
      integer(c_intptr_t) :: power_stride = 0
      type(c_ptr) :: adhesion = c_null_ptr
      integer(c_intptr_t) :: adhesion_stride = 0
      type(c_ptr) :: status_detail = c_null_ptr
      integer(c_intptr_t) :: status_detail_stride = 0
      type(c_ptr) :: friction = c_null_ptr
      integer(c_intptr_t) :: friction_stride = 0
      type(c_ptr) :: derivatives = c_null_ptr
      integer(c_intptr_t) :: derivatives_stride = 0
      type(c_ptr) :: law_derivatives = c_null_ptr
      integer(c_intptr_t) :: law_derivatives_stride = 0
   end type

   !> A contact for which kstrip_prepare() has computed everything that does not depend on the motion.
   type, bind(c) :: kstrip_prepared
      real(c_double) :: numbers(96) = 0
      integer(c_int32_t) :: model = 0
      integer(c_int32_t) :: strips = 0
   end type

   !> Motion of the upper body relative to the lower one at the contact, in axes that stay when the motion reverses.
   type, bind(c) :: kstrip_motion
      real(c_double) :: slip_x = 0
      real(c_double) :: slip_y = 0
      real(c_double) :: spin_rate = 0
      real(c_double) :: rolling_speed = 0
      real(c_double) :: floor_speed = 0
   end type

   !> Derivatives of fx, fy, mz with respect to motion, load and friction.
   type, bind(c) :: kstrip_motion_derivatives
      real(c_double) :: slip(3, 3) = 0
      real(c_double) :: rolling_speed(3) = 0
      real(c_double) :: normal_force(3) = 0
      real(c_double) :: load_through_hertz(3) = 0
      real(c_double) :: friction(3) = 0
      real(c_double) :: ratio(3) = 0
      real(c_double) :: decay(3) = 0
      real(c_double) :: slope_factor(3) = 0
      real(c_double) :: slide_factor(3) = 0
      real(c_double) :: layer(3) = 0
   end type

   !> Where the outputs of kstrip_solve_motion() go.
   type, bind(c) :: kstrip_motion_outputs
      type(c_ptr) :: result = c_null_ptr
      type(c_ptr) :: derivatives = c_null_ptr
      type(c_ptr) :: friction = c_null_ptr
   end type

   !> The state of a point of the contact plane.
   type, bind(c) :: kstrip_point
      real(c_double) :: pressure = 0
      real(c_double) :: traction_x = 0
      real(c_double) :: traction_y = 0
      real(c_double) :: slip_x = 0
      real(c_double) :: slip_y = 0
      real(c_double) :: dissipation = 0
      integer(c_int32_t) :: state = 0
      integer(c_int32_t) :: reserved = 0
   end type

   !> The undeformed distance of two bodies across the rolling direction, at points in ascending y.
   type, bind(c) :: kstrip_profile
      type(c_ptr) :: y = c_null_ptr
      type(c_ptr) :: distance = c_null_ptr
      type(c_ptr) :: centre_x = c_null_ptr
      type(c_ptr) :: rolling_radius = c_null_ptr
      integer(c_int32_t) :: points = 0
      integer(c_int32_t) :: reserved = 0
   end type

   !> Load or approach, material and friction of two profiles that are pressed together.
   type, bind(c) :: kstrip_profile_contact
      real(c_double) :: rolling_radius = 0
      real(c_double) :: normal_force = 0
      real(c_double) :: approach = 0
      real(c_double) :: smoothing_length = 0
      real(c_double) :: shear_modulus = 0
      real(c_double) :: poisson_ratio = 0
      real(c_double) :: friction = 0
      integer(c_int32_t) :: strips = 0
      integer(c_int32_t) :: reserved = 0
   end type

   !> One strip of a patch, along the rolling direction.
   type, bind(c) :: kstrip_patch_strip
      real(c_double) :: y = 0
      real(c_double) :: width = 0
      real(c_double) :: half_length = 0
      real(c_double) :: centre_x = 0
      real(c_double) :: peak_pressure = 0
      real(c_double) :: friction = 0
   end type

   !> A contact patch of any shape: its strips, in ascending y.
   type, bind(c) :: kstrip_patch
      type(kstrip_patch_strip) :: strips(kstrip_patch_capacity)
      real(c_double) :: shear_modulus = 0
      real(c_double) :: poisson_ratio = 0
      real(c_double) :: area_scale = 0
      real(c_double) :: lever_scale = 0
      integer(c_int32_t) :: count = 0
      integer(c_int32_t) :: reserved = 0
      real(c_double) :: mismatch = 0
   end type

   !> Approach, load and pressure of two profiles in contact.
   type, bind(c) :: kstrip_profile_result
      real(c_double) :: approach = 0
      real(c_double) :: normal_force = 0
      real(c_double) :: stiffness = 0
      real(c_double) :: peak_pressure = 0
      real(c_double) :: peak_y = 0
      integer(c_int32_t) :: iterations = 0
      integer(c_int32_t) :: status_detail = 0
      real(c_double) :: lowest = 0
   end type

   !> Load, friction bound and area of a patch.
   type, bind(c) :: kstrip_patch_summary
      real(c_double) :: normal_force = 0
      real(c_double) :: friction_bound = 0
      real(c_double) :: area = 0
      integer(c_int32_t) :: lobes = 0
      integer(c_int32_t) :: reserved = 0
   end type

   !> A profile, prepared by kstrip_prepare_profile(): points at equal steps of its length, toward larger y, and its
   !> direction.
   type, bind(c) :: kstrip_surface
      real(c_double) :: y(kstrip_surface_capacity) = 0
      real(c_double) :: z(kstrip_surface_capacity) = 0
      real(c_double) :: cosine(kstrip_surface_capacity) = 0
      real(c_double) :: sine(kstrip_surface_capacity) = 0
      real(c_double) :: step = 0
      real(c_double) :: spacing = 0
      integer(c_int32_t) :: count = 0
      integer(c_int32_t) :: form = 0
   end type

   !> Position of the wheel on straight track.
   type, bind(c) :: kstrip_wheel_position
      real(c_double) :: lateral = 0
      real(c_double) :: vertical = 0
      real(c_double) :: yaw = 0
      real(c_double) :: roll = 0
   end type

   !> The gap between a wheel and a rail, point by point along the rail.
   type, bind(c) :: kstrip_gap
      real(c_double) :: along(kstrip_surface_capacity) = 0
      real(c_double) :: distance(kstrip_surface_capacity) = 0
      real(c_double) :: x(kstrip_surface_capacity) = 0
      real(c_double) :: y(kstrip_surface_capacity) = 0
      real(c_double) :: z(kstrip_surface_capacity) = 0
      real(c_double) :: angle(kstrip_surface_capacity) = 0
      real(c_double) :: rolling_radius(kstrip_surface_capacity) = 0
      real(c_double) :: step = 0
      integer(c_int32_t) :: count = 0
      integer(c_int32_t) :: reserved = 0
   end type

   !> Materials and friction of a wheel and a rail, and options of the computation.
   type, bind(c) :: kstrip_wheel_pair
      real(c_double) :: wheel_radius = 0
      real(c_double) :: shear_modulus = 0
      real(c_double) :: poisson_ratio = 0
      real(c_double) :: friction = 0
      real(c_double) :: friction_y(kstrip_rail_friction_capacity) = 0
      real(c_double) :: friction_at(kstrip_rail_friction_capacity) = 0
      integer(c_int32_t) :: friction_points = 0
      integer(c_int32_t) :: left = 0
      real(c_double) :: smoothing_length = 0
      integer(c_int32_t) :: strips = 0
      integer(c_int32_t) :: model = 0
      real(c_double) :: normal_damping = 0
      real(c_double) :: floor_speed = 0
      real(c_double) :: rail_radius = 0
      real(c_double) :: rail_ahead = 0
      real(c_double) :: rail_speed = 0
   end type

   !> One contact of a wheel.
   type, bind(c) :: kstrip_wheel_contact
      real(c_double) :: origin(3) = 0
      real(c_double) :: angle = 0
      real(c_double) :: angle_range = 0
      real(c_double) :: radius = 0
      real(c_double) :: normal_force = 0
      real(c_double) :: share = 0
      real(c_double) :: approach = 0
      real(c_double) :: stiffness = 0
      real(c_double) :: along = 0
      real(c_double) :: normal(6) = 0
      real(c_double) :: slip_x(6) = 0
      real(c_double) :: slip_y(6) = 0
      real(c_double) :: spin_rate(6) = 0
      real(c_double) :: rolling_speed(6) = 0
      real(c_double) :: normal_damping = 0
      type(kstrip_motion) :: at_rest
      type(kstrip_patch) :: patch
      real(c_double) :: rail_axis(2) = 0
      real(c_double) :: rail_rate = 0
      real(c_double) :: strip_rail_speed(kstrip_patch_capacity) = 0
      real(c_double) :: strip_y(kstrip_patch_capacity) = 0
      real(c_double) :: strip_z(kstrip_patch_capacity) = 0
      real(c_double) :: strip_angle(kstrip_patch_capacity) = 0
      real(c_double) :: strip_lean(kstrip_patch_capacity) = 0
      real(c_double) :: turned(2) = 0
      integer(c_int32_t) :: left = 0
      integer(c_int32_t) :: reserved = 0
   end type

   !> Velocity of the wheel relative to the rail.
   type, bind(c) :: kstrip_wheel_velocity
      real(c_double) :: forward = 0
      real(c_double) :: lateral = 0
      real(c_double) :: vertical = 0
      real(c_double) :: roll = 0
      real(c_double) :: pitch = 0
      real(c_double) :: yaw = 0
   end type

   !> Force and moment on a wheel.
   type, bind(c) :: kstrip_wrench
      real(c_double) :: force(3) = 0
      real(c_double) :: moment(3) = 0
      real(c_double) :: dissipation = 0
      real(c_double) :: normal_force = 0
      integer(c_int32_t) :: contacts = 0
      integer(c_int32_t) :: status_detail = 0
   end type

   !> Exact derivatives of the wrench.
   type, bind(c) :: kstrip_wrench_derivatives
      real(c_double) :: velocity(6, 6) = 0
      real(c_double) :: friction(6) = 0
   end type

   !> One strip of a contact of a wheel: its load, and the power that friction dissipates in it.
   type, bind(c) :: kstrip_strip_power
      real(c_double) :: wheel_y = 0
      real(c_double) :: width = 0
      real(c_double) :: normal_force = 0
      real(c_double) :: fx = 0
      real(c_double) :: fy = 0
      real(c_double) :: slip = 0
      real(c_double) :: power = 0
   end type

   !> Caller-provided memory for the computation of one wheel.
   type, bind(c) :: kstrip_wheel_workspace
      type(kstrip_gap) :: gap
      type(kstrip_patch) :: strips
      type(kstrip_wheel_contact) :: contacts(kstrip_contacts_capacity)
      integer(c_int32_t) :: count = 0
      integer(c_int32_t) :: reserved = 0
   end type

   !> Derivatives of the wrench with respect to the wheel's position at constant velocity.
   type, bind(c) :: kstrip_wrench_by_position
      real(c_double) :: lateral(6) = 0
      real(c_double) :: vertical(6) = 0
      real(c_double) :: yaw(6) = 0
      real(c_double) :: roll(6) = 0
   end type

   !> A finished contact table, from which a function takes the contacts of wheels (kstrip_table_finish()).
   type, bind(c) :: kstrip_table
      type(c_ptr) :: data = c_null_ptr
      integer(c_int32_t) :: bytes = 0
      integer(c_int32_t) :: only = 0
   end type

   !> Ranges of a contact table, and how many nodes it has.
   type, bind(c) :: kstrip_table_spec
      real(c_double) :: lateral_from = 0
      real(c_double) :: lateral_to = 0
      real(c_double) :: yaw = 0
      real(c_double) :: roll = 0
      real(c_double) :: load = 0
      integer(c_int32_t) :: lateral_nodes = 0
      integer(c_int32_t) :: levels = 0
      integer(c_int32_t) :: yaw_nodes = 0
      integer(c_int32_t) :: roll_nodes = 0
      integer(c_int32_t) :: strips = 0
      integer(c_int32_t) :: reserved = 0
   end type

   !> The size of a finished table, and its measured error.
   type, bind(c) :: kstrip_table_report
      real(c_double) :: force_usual = 0
      real(c_double) :: force_largest = 0
      real(c_double) :: load_usual = 0
      real(c_double) :: load_largest = 0
      integer(c_int32_t) :: bytes = 0
      integer(c_int32_t) :: poses = 0
      integer(c_int32_t) :: missing = 0
      integer(c_int32_t) :: empty = 0
   end type

   !> A curve that a vehicle runs through: the axes of the track move forward and turn with it.
   type, bind(c) :: kstrip_curve
      real(c_double) :: speed = 0
      real(c_double) :: curvature = 0
      real(c_double) :: cant = 0
      real(c_double) :: gravity = 0
   end type

   !> A wheelset: two wheels on an axle.
   type, bind(c) :: kstrip_wheelset
      type(c_ptr) :: wheel(2) = c_null_ptr
      type(c_ptr) :: friction(2) = c_null_ptr
      type(c_ptr) :: table(2) = c_null_ptr
      type(kstrip_wheel_pair) :: pair(2)
      real(c_double) :: back_to_back = 0
      real(c_double) :: running_circles = 0
   end type

   !> Displacement and velocity of a rail: irregularities of the track, or the motion of a flexible rail.
   type, bind(c) :: kstrip_rail_motion
      real(c_double) :: lateral = 0
      real(c_double) :: vertical = 0
      real(c_double) :: lateral_velocity = 0
      real(c_double) :: vertical_velocity = 0
   end type

   !> A track: two rails, and where they are.
   type, bind(c) :: kstrip_track
      type(c_ptr) :: rail(2) = c_null_ptr
      real(c_double) :: gauge = 0
      real(c_double) :: gauge_depth = 0
      real(c_double) :: origin(2) = 0
      type(kstrip_rail_motion) :: motion(2)
   end type

   !> Caller-provided memory for the computation of a wheelset: that of the right wheel and that of the left one.
   type, bind(c) :: kstrip_wheelset_workspace
      type(kstrip_wheel_workspace) :: wheel(2)
   end type

   !> Forces on a wheelset, on each wheel, and on each rail.
   type, bind(c) :: kstrip_wheelset_forces
      type(kstrip_wrench) :: wrench
      type(kstrip_wrench) :: wheel(2)
      real(c_double) :: rail(3, 2) = 0
   end type

   !> Exact derivatives of the forces on a wheelset and its two rails with respect to the velocities.
   type, bind(c) :: kstrip_wheelset_derivatives
      real(c_double) :: velocity(kstrip_wheelset_freedoms, kstrip_wheelset_freedoms) = 0
      real(c_double) :: friction(kstrip_wheelset_freedoms) = 0
   end type

   !> Derivatives of the same ten forces with respect to the positions of the ten degrees of freedom, at constant
   !> velocities.
   type, bind(c) :: kstrip_wheelset_by_position
      real(c_double) :: position(kstrip_wheelset_freedoms, kstrip_wheelset_freedoms) = 0
   end type

   !> Loads of the vehicle and of gravity on a wheelset that does not accelerate.
   type, bind(c) :: kstrip_wheelset_loads
      real(c_double) :: vertical = 0
      real(c_double) :: roll = 0
      real(c_double) :: pitch = 0
   end type

   !> A coefficient of friction from a measured force.
   type, bind(c) :: kstrip_friction_estimate
      real(c_double) :: friction = 0
      real(c_double) :: sensitivity = 0
      real(c_double) :: residual = 0
      integer(c_int32_t) :: status_detail = 0
      integer(c_int32_t) :: reserved = 0
   end type

   !> One measured point of a creep curve.
   type, bind(c) :: kstrip_measured_force
      real(c_double) :: longitudinal = 0
      real(c_double) :: lateral = 0
      real(c_double) :: spin = 0
      real(c_double) :: fx = 0
      real(c_double) :: fy = 0
      real(c_double) :: weight = 0
      integer(c_int32_t) :: measured = 0
      integer(c_int32_t) :: reserved = 0
   end type

   !> A law of friction that was fitted to measured points.
   type, bind(c) :: kstrip_friction_fit
      type(kstrip_friction) :: law
      type(kstrip_friction) :: standard_errors
      real(c_double) :: residual = 0
      integer(c_int32_t) :: steps = 0
      integer(c_int32_t) :: status_detail = 0
   end type

   interface
      !> Text in English with the cause of a status and the remedy.
      type(c_ptr) function kstrip_status_string(status) bind(c)
         import
         integer(c_int32_t), value :: status
      end function

      !> Combine the elastic constants of two bodies.
      integer(c_int32_t) function kstrip_material_combine(lower, upper, combined) bind(c)
         import
         type(kstrip_material), intent(in) :: lower
         type(kstrip_material), intent(in) :: upper
         type(kstrip_combined_material), intent(inout) :: combined
      end function

      !> The contact of two bodies that a load presses together (Hertz).
      integer(c_int32_t) function kstrip_contact_from_hertz(radii, pair, load, friction, contact, ellipse) bind(c)
         import
         type(kstrip_radii), intent(in) :: radii
         type(kstrip_combined_material), intent(in) :: pair
         real(c_double), value :: load
         real(c_double), value :: friction
         type(kstrip_contact), intent(inout) :: contact
         type(kstrip_hertz_contact), intent(inout), optional :: ellipse
      end function

      !> The contact of two bodies that have approached each other: the exact inverse of Hertz, for penalty contact.
      integer(c_int32_t) function kstrip_contact_from_approach(radii, pair, approach, friction, contact, dload_dapproach) bind(c)
         import
         type(kstrip_radii), intent(in) :: radii
         type(kstrip_combined_material), intent(in) :: pair
         real(c_double), value :: approach
         real(c_double), value :: friction
         type(kstrip_contact), intent(inout) :: contact
         real(c_double), intent(inout), optional :: dload_dapproach
      end function

      !> Kalker's coefficients C11, C22, C23, C33 of the linear theory.
      integer(c_int32_t) function kstrip_linear_coefficients(axis_ratio, poisson_ratio, coefficients) bind(c)
         import
         real(c_double), value :: axis_ratio
         real(c_double), value :: poisson_ratio
         real(c_double), intent(inout) :: coefficients(*)
      end function

      !> Creepages from the velocities of both bodies: (upper - lower)/rolling_speed.
      integer(c_int32_t) function kstrip_creepage_from_velocities(lower, upper, rolling_speed, creepage) bind(c)
         import
         type(kstrip_velocity), intent(in) :: lower
         type(kstrip_velocity), intent(in) :: upper
         real(c_double), value :: rolling_speed
         type(kstrip_creepage), intent(inout) :: creepage
      end function

      !> Kalker's dimensionless parameters xi, eta, psi (5.13) of a contact in motion; zero where it is lost.
      integer(c_int32_t) function kstrip_parameters_from_creepage(contact, creepage, parameters) bind(c)
         import
         type(kstrip_contact), intent(in) :: contact
         type(kstrip_creepage), intent(in) :: creepage
         type(kstrip_parameters), intent(inout) :: parameters
      end function

      !> The creepage that has the given parameters xi, eta, psi on a contact: the inverse of
      !> kstrip_parameters_from_creepage(); zero where it is lost.
      integer(c_int32_t) function kstrip_creepage_from_parameters(contact, parameters, creepage) bind(c)
         import
         type(kstrip_contact), intent(in) :: contact
         type(kstrip_parameters), intent(in) :: parameters
         type(kstrip_creepage), intent(inout) :: creepage
      end function

      !> Forces of a contact in motion, on the lower body: the fast path.
      integer(c_int32_t) function kstrip_solve(contact, creepage, options, result) bind(c)
         import
         type(kstrip_contact), intent(in) :: contact
         type(kstrip_creepage), intent(in) :: creepage
         type(kstrip_options), intent(in), optional :: options
         type(kstrip_result), intent(inout) :: result
      end function

      !> Computes, for a contact in motion, every output that is not NULL.
      integer(c_int32_t) function kstrip_evaluate(contact, creepage, friction, options, outputs) bind(c)
         import
         type(kstrip_contact), intent(in) :: contact
         type(kstrip_creepage), intent(in) :: creepage
         type(kstrip_friction), intent(in), optional :: friction
         type(kstrip_options), intent(in), optional :: options
         type(kstrip_outputs), intent(in) :: outputs
      end function

      !> kstrip_evaluate() for many contacts: the same results, bit for bit.
      integer(c_int32_t) function kstrip_evaluate_batch(inputs, count, options, outputs, first_bad) bind(c)
         import
         type(kstrip_batch_inputs), intent(in) :: inputs
         integer(c_int32_t), value :: count
         type(kstrip_options), intent(in), optional :: options
         type(kstrip_batch_outputs), intent(in) :: outputs
         integer(c_int32_t), intent(inout), optional :: first_bad
      end function

      !> Prepares a contact with its options for kstrip_solve_prepared().
      integer(c_int32_t) function kstrip_prepare(contact, options, prepared) bind(c)
         import
         type(kstrip_contact), intent(in) :: contact
         type(kstrip_options), intent(in), optional :: options
         type(kstrip_prepared), intent(inout) :: prepared
      end function

      !> kstrip_solve() for a prepared contact: the same result, bit for bit.
      integer(c_int32_t) function kstrip_solve_prepared(prepared, creepage, result) bind(c)
         import
         type(kstrip_prepared), intent(in) :: prepared
         type(kstrip_creepage), intent(in) :: creepage
         type(kstrip_result), intent(inout) :: result
      end function

      !> Forces of a contact that rolls forward, backward, or not at all, with derivatives with respect to its motion:
      !> for wheels that stop, hold and reverse.
      integer(c_int32_t) function kstrip_solve_motion(contact, motion, friction, options, outputs) bind(c)
         import
         type(kstrip_contact), intent(in) :: contact
         type(kstrip_motion), intent(in) :: motion
         type(kstrip_friction), intent(in), optional :: friction
         type(kstrip_options), intent(in), optional :: options
         type(kstrip_motion_outputs), intent(in) :: outputs
      end function

      !> kstrip_solve() with KSTRIP_MODEL_TOTAL; a program that calls only this links no other model.
      integer(c_int32_t) function kstrip_solve_total(contact, creepage, result) bind(c)
         import
         type(kstrip_contact), intent(in) :: contact
         type(kstrip_creepage), intent(in) :: creepage
         type(kstrip_result), intent(inout) :: result
      end function

      !> kstrip_solve() with KSTRIP_MODEL_STRIP; a program that calls only this links no other model.
      integer(c_int32_t) function kstrip_solve_strip(contact, creepage, strips, result) bind(c)
         import
         type(kstrip_contact), intent(in) :: contact
         type(kstrip_creepage), intent(in) :: creepage
         integer(c_int32_t), value :: strips
         type(kstrip_result), intent(inout) :: result
      end function

      !> kstrip_solve() with KSTRIP_MODEL_STRIP_1967; a program that calls only this links no other model.
      integer(c_int32_t) function kstrip_solve_strip_1967(contact, creepage, strips, result) bind(c)
         import
         type(kstrip_contact), intent(in) :: contact
         type(kstrip_creepage), intent(in) :: creepage
         integer(c_int32_t), value :: strips
         type(kstrip_result), intent(inout) :: result
      end function

      !> kstrip_solve() with KSTRIP_MODEL_LINEAR; a program that calls only this links no other model.
      integer(c_int32_t) function kstrip_solve_linear(contact, creepage, result) bind(c)
         import
         type(kstrip_contact), intent(in) :: contact
         type(kstrip_creepage), intent(in) :: creepage
         type(kstrip_result), intent(inout) :: result
      end function

      !> Pressure, traction, slip and state over a grid; one point is a grid of one.
      integer(c_int32_t) function kstrip_field(contact, creepage, friction, options, x, columns, y, &
         rows, points, capacity) bind(c)
         import
         type(kstrip_contact), intent(in) :: contact
         type(kstrip_creepage), intent(in) :: creepage
         type(kstrip_friction), intent(in) :: friction
         type(kstrip_options), intent(in), optional :: options
         real(c_double), intent(in) :: x(*)
         integer(c_int32_t), value :: columns
         real(c_double), intent(in) :: y(*)
         integer(c_int32_t), value :: rows
         type(kstrip_point), intent(inout) :: points(*)
         integer(c_int32_t), value :: capacity
      end function

      !> The patch of two profiles under a load, or at an approach.
      integer(c_int32_t) function kstrip_patch_from_profile(profile, contact, patch, result) bind(c)
         import
         type(kstrip_profile), intent(in) :: profile
         type(kstrip_profile_contact), intent(in) :: contact
         type(kstrip_patch), intent(inout) :: patch
         type(kstrip_profile_result), intent(inout), optional :: result
      end function

      !> A patch from strips of any origin, in any order of y.
      integer(c_int32_t) function kstrip_patch_from_strips(strips, count, shear_modulus, poisson_ratio, patch) bind(c)
         import
         type(kstrip_patch_strip), intent(in) :: strips(*)
         integer(c_int32_t), value :: count
         real(c_double), value :: shear_modulus
         real(c_double), value :: poisson_ratio
         type(kstrip_patch), intent(inout) :: patch
      end function

      !> The strips of a contact's ellipse, at the places of KSTRIP_MODEL_STRIP.
      integer(c_int32_t) function kstrip_patch_from_contact(contact, options, patch) bind(c)
         import
         type(kstrip_contact), intent(in) :: contact
         type(kstrip_options), intent(in), optional :: options
         type(kstrip_patch), intent(inout) :: patch
      end function

      !> Load, friction bound, area and contact regions of a patch; checks it without solving.
      integer(c_int32_t) function kstrip_patch_summarize(patch, summary) bind(c)
         import
         type(kstrip_patch), intent(in) :: patch
         type(kstrip_patch_summary), intent(inout) :: summary
      end function

      !> Computes, for a patch in motion, every output that is not NULL.
      integer(c_int32_t) function kstrip_patch_evaluate(patch, creepage, friction, options, outputs) bind(c)
         import
         type(kstrip_patch), intent(in) :: patch
         type(kstrip_creepage), intent(in) :: creepage
         type(kstrip_friction), intent(in), optional :: friction
         type(kstrip_options), intent(in), optional :: options
         type(kstrip_outputs), intent(in) :: outputs
      end function

      !> kstrip_patch_evaluate() with creepages of each strip, as on curved surfaces: own is added to the creepages that
      !> the motion has at the strip's centre.
      integer(c_int32_t) function kstrip_patch_evaluate_strips(patch, creepage, own, friction, options, outputs) bind(c)
         import
         type(kstrip_patch), intent(in) :: patch
         type(kstrip_creepage), intent(in) :: creepage
         type(kstrip_creepage), intent(in), optional :: own
         type(kstrip_friction), intent(in) :: friction
         type(kstrip_options), intent(in), optional :: options
         type(kstrip_outputs), intent(in) :: outputs
      end function

      !> Pressure, traction, slip and state of a patch over a grid.
      integer(c_int32_t) function kstrip_patch_field(patch, creepage, friction, options, x, &
         columns, y, rows, points, capacity) bind(c)
         import
         type(kstrip_patch), intent(in) :: patch
         type(kstrip_creepage), intent(in) :: creepage
         type(kstrip_friction), intent(in) :: friction
         type(kstrip_options), intent(in), optional :: options
         real(c_double), intent(in) :: x(*)
         integer(c_int32_t), value :: columns
         real(c_double), intent(in) :: y(*)
         integer(c_int32_t), value :: rows
         type(kstrip_point), intent(inout) :: points(*)
         integer(c_int32_t), value :: capacity
      end function

      !> Reads the profile of a wheel or a rail from the text of a file, in metres and the right way round: points toward
      !> larger y, z down, the flange or the gauge side at small y.
      integer(c_int32_t) function kstrip_read_profile(text, length, format, y, z, capacity, count, notes) bind(c)
         import
         character(kind=c_char), intent(in) :: text(*)
         integer(c_int32_t), value :: length
         integer(c_int32_t), value :: format
         real(c_double), intent(inout) :: y(*)
         real(c_double), intent(inout) :: z(*)
         integer(c_int32_t), value :: capacity
         integer(c_int32_t), intent(inout) :: count
         integer(c_int32_t), intent(inout), optional :: notes
      end function

      !> Turns profiles the right way round by their shape: points toward larger y, z down, the flange or the gauge side
      !> at small y.
      integer(c_int32_t) function kstrip_orient_profiles(y, z, counts, profile_count, format, unit, &
         turned_y, turned_z, taken_unit, notes) bind(c)
         import
         real(c_double), intent(in) :: y(*)
         real(c_double), intent(in) :: z(*)
         integer(c_int32_t), intent(in) :: counts(*)
         integer(c_int32_t), value :: profile_count
         integer(c_int32_t), value :: format
         real(c_double), value :: unit
         real(c_double), intent(inout) :: turned_y(*)
         real(c_double), intent(inout) :: turned_z(*)
         real(c_double), intent(inout), optional :: taken_unit
         integer(c_int32_t), intent(inout), optional :: notes
      end function

      !> Prepares a profile of a rail or a wheel from its points.
      integer(c_int32_t) function kstrip_prepare_profile(y, z, points, step, smoothing_length, surface) bind(c)
         import
         real(c_double), intent(in) :: y(*)
         real(c_double), intent(in) :: z(*)
         integer(c_int32_t), value :: points
         real(c_double), value :: step
         real(c_double), value :: smoothing_length
         type(kstrip_surface), intent(inout) :: surface
      end function

      !> The prepared profile at a place between two slices of a surface.
      integer(c_int32_t) function kstrip_profile_between(first, second, share, between) bind(c)
         import
         type(kstrip_surface), intent(in) :: first
         type(kstrip_surface), intent(in) :: second
         real(c_double), value :: share
         type(kstrip_surface), intent(inout) :: between
      end function

      !> The gap between a wheel and a straight rail: the line on the wheel along which its normal is perpendicular to x,
      !> and its distance from the rail.
      integer(c_int32_t) function kstrip_touch(rail, wheel, wheel_radius, position, reach, gap, least) bind(c)
         import
         type(kstrip_surface), intent(in) :: rail
         type(kstrip_surface), intent(in) :: wheel
         real(c_double), value :: wheel_radius
         type(kstrip_wheel_position), intent(in) :: position
         real(c_double), value :: reach
         type(kstrip_gap), intent(inout) :: gap
         real(c_double), intent(inout), optional :: least
      end function

      !> The contacts of a gap, in ascending y of a right wheel.
      integer(c_int32_t) function kstrip_contacts_from_gap(gap, pair, position, workspace, contacts, count) bind(c)
         import
         type(kstrip_gap), intent(in) :: gap
         type(kstrip_wheel_pair), intent(in) :: pair
         type(kstrip_wheel_position), intent(in) :: position
         type(kstrip_patch), intent(inout) :: workspace
         type(kstrip_wheel_contact), intent(inout) :: contacts(*)
         integer(c_int32_t), intent(inout) :: count
      end function

      !> Motion of the wheel relative to the rail at a contact: slip, spin rate and rolling speed.
      integer(c_int32_t) function kstrip_wheel_motion(contact, velocity, motion) bind(c)
         import
         type(kstrip_wheel_contact), intent(in) :: contact
         type(kstrip_wheel_velocity), intent(in) :: velocity
         type(kstrip_motion), intent(inout) :: motion
      end function

      !> Force and moment on the wheel from its contacts.
      integer(c_int32_t) function kstrip_wrench_from_contacts(contacts, count, velocity, model, &
         friction, wrench, derivatives) bind(c)
         import
         type(kstrip_wheel_contact), intent(in) :: contacts(*)
         integer(c_int32_t), value :: count
         type(kstrip_wheel_velocity), intent(in) :: velocity
         integer(c_int32_t), value :: model
         type(kstrip_friction), intent(in), optional :: friction
         type(kstrip_wrench), intent(inout) :: wrench
         type(kstrip_wrench_derivatives), intent(inout), optional :: derivatives
      end function

      !> Load, sliding velocity and frictional power of each strip of a contact, to compute wear.
      integer(c_int32_t) function kstrip_contact_power_across(contact, velocity, model, friction, strips, capacity, count) bind(c)
         import
         type(kstrip_wheel_contact), intent(in) :: contact
         type(kstrip_wheel_velocity), intent(in) :: velocity
         integer(c_int32_t), value :: model
         type(kstrip_friction), intent(in) :: friction
         type(kstrip_strip_power), intent(inout) :: strips(*)
         integer(c_int32_t), value :: capacity
         integer(c_int32_t), intent(inout) :: count
      end function

      !> Force and moment on a wheel on a rail in one call: kstrip_touch(), kstrip_contacts_from_gap(),
      !> kstrip_wrench_from_contacts().
      integer(c_int32_t) function kstrip_wheel_on_rail(rail, wheel, pair, position, velocity, &
         friction, workspace, wrench, derivatives, by_position) bind(c)
         import
         type(kstrip_surface), intent(in) :: rail
         type(kstrip_surface), intent(in) :: wheel
         type(kstrip_wheel_pair), intent(in) :: pair
         type(kstrip_wheel_position), intent(in) :: position
         type(kstrip_wheel_velocity), intent(in) :: velocity
         type(kstrip_friction), intent(in), optional :: friction
         type(kstrip_wheel_workspace), intent(inout) :: workspace
         type(kstrip_wrench), intent(inout) :: wrench
         type(kstrip_wrench_derivatives), intent(inout), optional :: derivatives
         type(kstrip_wrench_by_position), intent(inout), optional :: by_position
      end function

      !> kstrip_wheel_on_rail() for many wheels with the same profiles: the same results, bit for bit.
      integer(c_int32_t) function kstrip_wheels_on_rails(rail, wheel, count, pairs, pair_stride, &
         positions, position_stride, velocities, velocity_stride, friction, friction_stride, table, &
         workspace, wrenches, derivatives, by_position, contacts, room, statuses) bind(c)
         import
         type(kstrip_surface), intent(in) :: rail
         type(kstrip_surface), intent(in) :: wheel
         integer(c_int32_t), value :: count
         type(kstrip_wheel_pair), intent(in) :: pairs(*)
         integer(c_int32_t), value :: pair_stride
         type(kstrip_wheel_position), intent(in) :: positions(*)
         integer(c_int32_t), value :: position_stride
         type(kstrip_wheel_velocity), intent(in) :: velocities(*)
         integer(c_int32_t), value :: velocity_stride
         type(kstrip_friction), intent(in), optional :: friction(*)
         integer(c_int32_t), value :: friction_stride
         type(kstrip_table), intent(in), optional :: table
         type(kstrip_wheel_workspace), intent(inout) :: workspace
         type(kstrip_wrench), intent(inout) :: wrenches(*)
         type(kstrip_wrench_derivatives), intent(inout), optional :: derivatives(*)
         type(kstrip_wrench_by_position), intent(inout), optional :: by_position(*)
         type(kstrip_wheel_contact), intent(inout), optional :: contacts(*)
         integer(c_int32_t), value :: room
         integer(c_int32_t), intent(inout), optional :: statuses(*)
      end function

      !> The vertical position at which the rail supports a wheel with a given force, to rounding.
      integer(c_int32_t) function kstrip_height_for_load(rail, wheel, pair, position, support, &
         velocity, friction, table, workspace, vertical) bind(c)
         import
         type(kstrip_surface), intent(in) :: rail
         type(kstrip_surface), intent(in) :: wheel
         type(kstrip_wheel_pair), intent(in) :: pair
         type(kstrip_wheel_position), intent(in) :: position
         real(c_double), value :: support
         type(kstrip_wheel_velocity), intent(in), optional :: velocity
         type(kstrip_friction), intent(in), optional :: friction
         type(kstrip_table), intent(in), optional :: table
         type(kstrip_wheel_workspace), intent(inout) :: workspace
         real(c_double), intent(inout) :: vertical
      end function

      !> kstrip_height_for_load() for many wheels with the same profiles: the same results, bit for bit.
      integer(c_int32_t) function kstrip_heights_for_loads(rail, wheel, count, pairs, pair_stride, &
         positions, position_stride, supports, support_stride, velocities, velocity_stride, &
         friction, friction_stride, table, workspace, verticals, statuses) bind(c)
         import
         type(kstrip_surface), intent(in) :: rail
         type(kstrip_surface), intent(in) :: wheel
         integer(c_int32_t), value :: count
         type(kstrip_wheel_pair), intent(in) :: pairs(*)
         integer(c_int32_t), value :: pair_stride
         type(kstrip_wheel_position), intent(in) :: positions(*)
         integer(c_int32_t), value :: position_stride
         real(c_double), intent(in) :: supports(*)
         integer(c_int32_t), value :: support_stride
         type(kstrip_wheel_velocity), intent(in), optional :: velocities(*)
         integer(c_int32_t), value :: velocity_stride
         type(kstrip_friction), intent(in), optional :: friction(*)
         integer(c_int32_t), value :: friction_stride
         type(kstrip_table), intent(in), optional :: table
         type(kstrip_wheel_workspace), intent(inout) :: workspace
         real(c_double), intent(inout) :: verticals(*)
         integer(c_int32_t), intent(inout), optional :: statuses(*)
      end function

      !> Size of a contact table, which holds contacts of kstrip_wheel_on_rail() at nodes; kstrip_wheel_on_table()
      !> interpolates between them.
      integer(c_int32_t) function kstrip_table_size(wheel, spec, bytes, parts) bind(c)
         import
         type(kstrip_surface), intent(in) :: wheel
         type(kstrip_table_spec), intent(in) :: spec
         integer(c_int32_t), intent(inout) :: bytes
         integer(c_int32_t), intent(inout) :: parts
      end function

      !> Begins a table: it chooses lateral nodes for each pair of nodes of yaw and roll, in about the time of one part
      !> for each pair.
      integer(c_int32_t) function kstrip_table_begin(rail, wheel, pair, spec, workspace, table, bytes) bind(c)
         import
         type(kstrip_surface), intent(in) :: rail
         type(kstrip_surface), intent(in) :: wheel
         type(kstrip_wheel_pair), intent(in) :: pair
         type(kstrip_table_spec), intent(in) :: spec
         type(kstrip_wheel_workspace), intent(inout) :: workspace
         integer(c_int8_t), intent(inout) :: table(*)
         integer(c_int32_t), value :: bytes
      end function

      !> Fills parts of a table that is begun, each in about the time of 400 calls of kstrip_wheel_on_rail().
      integer(c_int32_t) function kstrip_table_fill(rail, wheel, pair, first, count, workspace, table, bytes) bind(c)
         import
         type(kstrip_surface), intent(in) :: rail
         type(kstrip_surface), intent(in) :: wheel
         type(kstrip_wheel_pair), intent(in) :: pair
         integer(c_int32_t), value :: first
         integer(c_int32_t), value :: count
         type(kstrip_wheel_workspace), intent(inout) :: workspace
         integer(c_int8_t), intent(inout) :: table(*)
         integer(c_int32_t), value :: bytes
      end function

      !> Finishes a table whose parts are filled: shortens it, measures its error against the direct call with 64 strips,
      !> and adds a checksum.
      integer(c_int32_t) function kstrip_table_finish(rail, wheel, pair, poses, workspace, table, bytes, report) bind(c)
         import
         type(kstrip_surface), intent(in) :: rail
         type(kstrip_surface), intent(in) :: wheel
         type(kstrip_wheel_pair), intent(in) :: pair
         integer(c_int32_t), value :: poses
         type(kstrip_wheel_workspace), intent(inout) :: workspace
         integer(c_int8_t), intent(inout) :: table(*)
         integer(c_int32_t), value :: bytes
         type(kstrip_table_report), intent(inout) :: report
      end function

      !> Checks all of a finished table.
      integer(c_int32_t) function kstrip_table_check(table, bytes, length) bind(c)
         import
         integer(c_int8_t), intent(in) :: table(*)
         integer(c_int32_t), value :: bytes
         integer(c_int32_t), intent(inout), optional :: length
      end function

      !> kstrip_wheel_on_rail() from a table alone: it needs no profiles, and computes no gap.
      integer(c_int32_t) function kstrip_wheel_on_table(table, pair, position, velocity, friction, &
         workspace, wrench, derivatives, by_position) bind(c)
         import
         type(kstrip_table), intent(in) :: table
         type(kstrip_wheel_pair), intent(in) :: pair
         type(kstrip_wheel_position), intent(in) :: position
         type(kstrip_wheel_velocity), intent(in) :: velocity
         type(kstrip_friction), intent(in), optional :: friction
         type(kstrip_wheel_workspace), intent(inout), optional :: workspace
         type(kstrip_wrench), intent(inout) :: wrench
         type(kstrip_wrench_derivatives), intent(inout), optional :: derivatives
         type(kstrip_wrench_by_position), intent(inout), optional :: by_position
      end function

      !> The gauge face of a rail: the least y of its profile down to a depth below its top.
      integer(c_int32_t) function kstrip_gauge_face(rail, depth, face) bind(c)
         import
         type(kstrip_surface), intent(in) :: rail
         real(c_double), value :: depth
         real(c_double), intent(inout) :: face
      end function

      !> Motion and weight in a curve.
      integer(c_int32_t) function kstrip_curve_motion(curve, position, relative, velocity, weight) bind(c)
         import
         type(kstrip_curve), intent(in) :: curve
         type(kstrip_wheel_position), intent(in) :: position
         type(kstrip_wheel_velocity), intent(in) :: relative
         type(kstrip_wheel_velocity), intent(inout) :: velocity
         real(c_double), intent(inout), optional :: weight(*)
      end function

      !> Forces on a wheelset and its rails: two wheels, two rails, one call.
      integer(c_int32_t) function kstrip_wheelset_on_track(set, track, position, velocity, &
         workspace, forces, derivatives, by_position) bind(c)
         import
         type(kstrip_wheelset), intent(in) :: set
         type(kstrip_track), intent(in) :: track
         type(kstrip_wheel_position), intent(in) :: position
         type(kstrip_wheel_velocity), intent(in) :: velocity
         type(kstrip_wheelset_workspace), intent(inout) :: workspace
         type(kstrip_wheelset_forces), intent(inout) :: forces
         type(kstrip_wheelset_derivatives), intent(inout), optional :: derivatives
         type(kstrip_wheelset_by_position), intent(inout), optional :: by_position
      end function

      !> A wheelset in balance: height, roll and pitch rate at which its rails carry given loads, at given lateral
      !> position, yaw and speed.
      integer(c_int32_t) function kstrip_wheelset_settle(set, track, start, velocity, loads, &
         workspace, position, moves, forces) bind(c)
         import
         type(kstrip_wheelset), intent(in) :: set
         type(kstrip_track), intent(in) :: track
         type(kstrip_wheel_position), intent(in) :: start
         type(kstrip_wheel_velocity), intent(in) :: velocity
         type(kstrip_wheelset_loads), intent(in) :: loads
         type(kstrip_wheelset_workspace), intent(inout) :: workspace
         type(kstrip_wheel_position), intent(inout) :: position
         type(kstrip_wheel_velocity), intent(inout) :: moves
         type(kstrip_wheelset_forces), intent(inout), optional :: forces
      end function

      !> kstrip_wheelset_on_track() for many positions and velocities: the same results, bit for bit.
      integer(c_int32_t) function kstrip_wheelsets_on_track(set, track, count, positions, &
         position_stride, velocities, velocity_stride, workspace, forces, derivatives, by_position, statuses) bind(c)
         import
         type(kstrip_wheelset), intent(in) :: set
         type(kstrip_track), intent(in) :: track
         integer(c_int32_t), value :: count
         type(kstrip_wheel_position), intent(in) :: positions(*)
         integer(c_int32_t), value :: position_stride
         type(kstrip_wheel_velocity), intent(in) :: velocities(*)
         integer(c_int32_t), value :: velocity_stride
         type(kstrip_wheelset_workspace), intent(inout) :: workspace
         type(kstrip_wheelset_forces), intent(inout) :: forces(*)
         type(kstrip_wheelset_derivatives), intent(inout), optional :: derivatives(*)
         type(kstrip_wheelset_by_position), intent(inout), optional :: by_position(*)
         integer(c_int32_t), intent(inout), optional :: statuses(*)
      end function

      !> kstrip_wheelset_settle() for many starts, velocities and loads: the same results, bit for bit.
      integer(c_int32_t) function kstrip_wheelsets_settle(set, track, count, starts, start_stride, &
         velocities, velocity_stride, loads, load_stride, workspace, positions, moves, forces, statuses) bind(c)
         import
         type(kstrip_wheelset), intent(in) :: set
         type(kstrip_track), intent(in) :: track
         integer(c_int32_t), value :: count
         type(kstrip_wheel_position), intent(in) :: starts(*)
         integer(c_int32_t), value :: start_stride
         type(kstrip_wheel_velocity), intent(in) :: velocities(*)
         integer(c_int32_t), value :: velocity_stride
         type(kstrip_wheelset_loads), intent(in) :: loads(*)
         integer(c_int32_t), value :: load_stride
         type(kstrip_wheelset_workspace), intent(inout) :: workspace
         type(kstrip_wheel_position), intent(inout) :: positions(*)
         type(kstrip_wheel_velocity), intent(inout) :: moves(*)
         type(kstrip_wheelset_forces), intent(inout), optional :: forces(*)
         integer(c_int32_t), intent(inout), optional :: statuses(*)
      end function

      !> The difference of the rolling radii, right minus left, against the lateral shift of a rigid wheelset that
      !> touches both rails without yaw.
      integer(c_int32_t) function kstrip_rolling_radius_difference(set, track, shifts, count, &
         with_roll, workspace, differences, statuses) bind(c)
         import
         type(kstrip_wheelset), intent(in) :: set
         type(kstrip_track), intent(in) :: track
         real(c_double), intent(in) :: shifts(*)
         integer(c_int32_t), value :: count
         integer(c_int32_t), value :: with_roll
         type(kstrip_wheelset_workspace), intent(inout) :: workspace
         real(c_double), intent(inout) :: differences(*)
         integer(c_int32_t), intent(inout), optional :: statuses(*)
      end function

      !> Equivalent conicity after EN 15302: the conicity of the coned wheelset whose motion has the same wave length.
      integer(c_int32_t) function kstrip_equivalent_conicity(shifts, differences, count, &
         running_circles, wheel_radius, amplitudes, number, conicities, wave_lengths, statuses) bind(c)
         import
         real(c_double), intent(in) :: shifts(*)
         real(c_double), intent(in) :: differences(*)
         integer(c_int32_t), value :: count
         real(c_double), value :: running_circles
         real(c_double), value :: wheel_radius
         real(c_double), intent(in) :: amplitudes(*)
         integer(c_int32_t), value :: number
         real(c_double), intent(inout) :: conicities(*)
         real(c_double), intent(inout), optional :: wave_lengths(*)
         integer(c_int32_t), intent(inout), optional :: statuses(*)
      end function

      !> The coefficient of friction that explains a measured force at a known creepage.
      integer(c_int32_t) function kstrip_estimate_friction(contact, creepage, friction, options, &
         measured, fx, fy, estimate) bind(c)
         import
         type(kstrip_contact), intent(in) :: contact
         type(kstrip_creepage), intent(in) :: creepage
         type(kstrip_friction), intent(in), optional :: friction
         type(kstrip_options), intent(in), optional :: options
         integer(c_int32_t), value :: measured
         real(c_double), value :: fx
         real(c_double), value :: fy
         type(kstrip_friction_estimate), intent(inout) :: estimate
      end function

      !> The creepage at which a contact with a given spin carries a requested force.
      integer(c_int32_t) function kstrip_creepage_for_force(contact, fx, fy, spin, friction, options, creepage) bind(c)
         import
         type(kstrip_contact), intent(in) :: contact
         real(c_double), value :: fx
         real(c_double), value :: fy
         real(c_double), value :: spin
         type(kstrip_friction), intent(in), optional :: friction
         type(kstrip_options), intent(in), optional :: options
         type(kstrip_creepage), intent(inout) :: creepage
      end function

      !> The law of friction that fits a measured creep curve best.
      integer(c_int32_t) function kstrip_fit_friction(contact, points, count, start, parameters, options, fit, first_bad) bind(c)
         import
         type(kstrip_contact), intent(in) :: contact
         type(kstrip_measured_force), intent(in) :: points(*)
         integer(c_int32_t), value :: count
         type(kstrip_friction), intent(in) :: start
         integer(c_int32_t), value :: parameters
         type(kstrip_options), intent(in), optional :: options
         type(kstrip_friction_fit), intent(inout) :: fit
         integer(c_int32_t), intent(inout), optional :: first_bad
      end function

      !> Fill options with zero, the defaults: KSTRIP_MODEL_DEFAULT and 16 strips.
      integer(c_int32_t) function kstrip_options_init(options) bind(c)
         import
         type(kstrip_options), intent(inout) :: options
      end function

      !> The result on the upper body: opposite forces and moment, same power and adhesion.
      integer(c_int32_t) function kstrip_result_on_upper_body(lower, upper) bind(c)
         import
         type(kstrip_result), intent(in) :: lower
         type(kstrip_result), intent(inout) :: upper
      end function

      !> Version of the library that is linked, such as "0.2.0".
      type(c_ptr) function kstrip_version_string() bind(c)
         import
      end function

      !> ABI version of the library that is linked: compare with KSTRIP_ABI_VERSION of the header.
      integer(c_int32_t) function kstrip_abi_version() bind(c)
         import
      end function
   end interface
contains

   !> What a status means and what the caller must change, in English.
   function kstrip_message(status) result(text)
      integer(c_int32_t), intent(in) :: status
      character(len=:), allocatable :: text
      character(kind=c_char), pointer :: letters(:)
      integer :: n
      call c_f_pointer(kstrip_status_string(status), letters, [1000])
      n = 0
      do while (letters(n + 1) /= c_null_char)
         n = n + 1
      end do
      allocate (character(len=n) :: text)
      text = transfer(letters(1:n), text)
   end function
end module
