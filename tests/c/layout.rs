// Every structure of include/kstrip.h. Written together with it:
// KSTRIP_WRITE_HEADER=1 cargo test --test interface binary_interface
layouts! {
    kstrip_material { shear_modulus, poisson_ratio }
    kstrip_combined_material { shear_modulus, poisson_ratio, mismatch }
    kstrip_radii { lower_x, lower_y, upper_x, upper_y }
    kstrip_contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, mismatch }
    kstrip_hertz_contact { a, b, peak_pressure, approach, axis_ratio, hertz_angle, rho }
    kstrip_velocity { x, y, angular_z }
    kstrip_creepage { longitudinal, lateral, spin }
    kstrip_parameters { xi, eta, psi }
    kstrip_options { model, strips }
    kstrip_result { fx, fy, mz, power, adhesion, warning, reserved }
    kstrip_friction { friction, ratio, decay, rolling_speed, slope_factor, slide_factor, layer }
    kstrip_derivatives { jacobian, normal_force, load_through_hertz, friction }
    kstrip_law_derivatives { ratio, decay, rolling_speed, slope_factor, slide_factor, layer }
    kstrip_strip { y, width, half_length, separatrix, fx, fy, mz, power, state, reserved }
    kstrip_outputs { result, derivatives, law_derivatives, friction, strips, count, capacity,
        reserved }
    kstrip_batch_inputs { a, a_stride, b, b_stride, normal_force, normal_force_stride,
        shear_modulus, shear_modulus_stride, poisson_ratio, poisson_ratio_stride, friction,
        friction_stride, mismatch, mismatch_stride, longitudinal, longitudinal_stride, lateral,
        lateral_stride, spin, spin_stride, law, law_stride }
    kstrip_batch_outputs { fx, fx_stride, fy, fy_stride, mz, mz_stride, power, power_stride,
        adhesion, adhesion_stride, status_detail, status_detail_stride, friction, friction_stride,
        derivatives, derivatives_stride, law_derivatives, law_derivatives_stride }
    kstrip_prepared { numbers, model, strips }
    kstrip_motion { slip_x, slip_y, spin_rate, rolling_speed, floor_speed }
    kstrip_motion_derivatives { slip, rolling_speed, normal_force, load_through_hertz, friction,
        ratio, decay, slope_factor, slide_factor, layer }
    kstrip_motion_outputs { result, derivatives, friction }
    kstrip_point { pressure, traction_x, traction_y, slip_x, slip_y, dissipation, state, reserved }
    kstrip_profile { y, distance, centre_x, rolling_radius, points, reserved }
    kstrip_profile_contact { rolling_radius, normal_force, approach, smoothing_length,
        shear_modulus, poisson_ratio, friction, strips, reserved }
    kstrip_patch_strip { y, width, half_length, centre_x, peak_pressure, friction }
    kstrip_patch { strips, shear_modulus, poisson_ratio, area_scale, lever_scale, count, reserved,
        mismatch }
    kstrip_profile_result { approach, normal_force, stiffness, peak_pressure, peak_y, iterations,
        warning, lowest }
    kstrip_patch_summary { normal_force, friction_bound, area, lobes, reserved }
    kstrip_surface { y, z, cosine, sine, step, spacing, count, form }
    kstrip_wheel_position { lateral, vertical, yaw, roll }
    kstrip_gap { along, distance, x, y, z, angle, rolling_radius, step, count, reserved }
    kstrip_wheel_pair { wheel_radius, shear_modulus, poisson_ratio, friction, friction_y,
        friction_at, friction_points, left, smoothing_length, strips, model, normal_damping,
        floor_speed, rail_radius, rail_ahead, rail_speed }
    kstrip_wheel_contact { origin, angle, angle_range, radius, normal_force, share, approach,
        stiffness, along, normal, slip_x, slip_y, spin_rate, rolling_speed, normal_damping,
        at_rest, patch, rail_axis, rail_rate, strip_rail_speed, strip_y, strip_z, strip_angle,
        strip_lean, turned, left, reserved }
    kstrip_wheel_velocity { forward, lateral, vertical, roll, pitch, yaw }
    kstrip_wrench { force, moment, dissipation, normal_force, contacts, warning }
    kstrip_wrench_derivatives { velocity, friction }
    kstrip_strip_power { wheel_y, width, normal_force, fx, fy, slip, power }
    kstrip_wheel_workspace { gap, strips, contacts, count, reserved }
    kstrip_wrench_by_position { lateral, vertical, yaw, roll }
    kstrip_table { data, bytes, only }
    kstrip_table_spec { lateral_from, lateral_to, yaw, roll, load, lateral_nodes, levels,
        yaw_nodes, roll_nodes, strips, reserved }
    kstrip_table_report { force_usual, force_largest, load_usual, load_largest, bytes, poses,
        missing, empty }
    kstrip_curve { speed, curvature, cant, gravity }
    kstrip_wheelset { wheel, friction, table, pair, back_to_back, running_circles }
    kstrip_rail_motion { lateral, vertical, lateral_velocity, vertical_velocity }
    kstrip_track { rail, gauge, gauge_depth, origin, motion }
    kstrip_wheelset_workspace { wheel }
    kstrip_wheelset_forces { wrench, wheel, rail }
    kstrip_wheelset_derivatives { velocity, friction }
    kstrip_wheelset_by_position { position }
    kstrip_wheelset_loads { vertical, roll, pitch }
    kstrip_friction_estimate { friction, sensitivity, residual, warning, reserved }
    kstrip_measured_force { longitudinal, lateral, spin, fx, fy, weight, measured, reserved }
    kstrip_friction_fit { law, standard_errors, residual, steps, warning }
}
