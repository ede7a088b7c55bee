// Every structure of the header. Written together with it:
// KSTRIP_WRITE_HEADER=1 cargo test --test interface binary_interface
layouts! {
    kstrip_options { model, strips }
    kstrip_material { shear_modulus, poisson_ratio }
    kstrip_combined_material { shear_modulus, poisson_ratio, mismatch }
    kstrip_radii { lower_x, lower_y, upper_x, upper_y }
    kstrip_hertz_contact { a, b, peak_pressure, approach, axis_ratio, hertz_angle, rho }
    kstrip_velocity { x, y, angular_z }
    kstrip_creepage { longitudinal, lateral, spin }
    kstrip_contact { a, b, normal_force, shear_modulus, poisson_ratio, friction }
    kstrip_parameters { xi, eta, psi }
    kstrip_result { fx, fy, mz, power, adhesion, status_detail, reserved }
    kstrip_strip { y, width, half_length, separatrix, fx, fy, mz, power, state, reserved }
    kstrip_point { pressure, traction_x, traction_y, slip_x, slip_y, dissipation, state, reserved }
    kstrip_patch_strip { y, width, half_length, centre_x, peak_pressure, friction }
    kstrip_patch { strips, shear_modulus, poisson_ratio, area_scale, lever_scale, count, reserved }
    kstrip_profile_contact { rolling_radius, normal_force, shear_modulus, poisson_ratio, friction }
    kstrip_profile_result { penetration, peak_pressure, normal_force, deepest_y, iterations, reserved }
    kstrip_patch_summary { normal_force, friction_bound, area, lobes, reserved }
    kstrip_contact_f32 { a, b, normal_force, shear_modulus, poisson_ratio, friction }
    kstrip_patch_strip_f32 { y, width, half_length, centre_x, peak_pressure, friction }
    kstrip_patch_f32 { strips, shear_modulus, poisson_ratio, area_scale, lever_scale, count, reserved }
    kstrip_profile_contact_f32 { rolling_radius, normal_force, shear_modulus, poisson_ratio, friction }
    kstrip_profile_result_f32 { penetration, peak_pressure, normal_force, deepest_y, iterations, reserved }
    kstrip_patch_summary_f32 { normal_force, friction_bound, area, lobes, reserved }
    kstrip_creepage_f32 { longitudinal, lateral, spin }
    kstrip_result_f32 { fx, fy, mz, power, adhesion, status_detail, reserved }
    kstrip_strip_f32 { y, width, half_length, separatrix, fx, fy, mz, power, state, reserved }
    kstrip_point_f32 { pressure, traction_x, traction_y, slip_x, slip_y, dissipation, state, reserved }
    kstrip_material_f32 { shear_modulus, poisson_ratio }
    kstrip_combined_material_f32 { shear_modulus, poisson_ratio, mismatch }
    kstrip_radii_f32 { lower_x, lower_y, upper_x, upper_y }
    kstrip_hertz_contact_f32 { a, b, peak_pressure, approach, axis_ratio, hertz_angle, rho }
    kstrip_velocity_f32 { x, y, angular_z }
    kstrip_parameters_f32 { xi, eta, psi }
    kstrip_batch_inputs { a, b, normal_force, shear_modulus, poisson_ratio, friction, longitudinal, lateral, spin }
    kstrip_batch_outputs { fx, fy, mz, power, adhesion, status_detail }
    kstrip_batch_inputs_f32 { a, b, normal_force, shear_modulus, poisson_ratio, friction, longitudinal, lateral, spin }
    kstrip_batch_outputs_f32 { fx, fy, mz, power, adhesion, status_detail }
    kstrip_derivatives { jacobian, normal_force, friction, load_through_hertz }
    kstrip_derivatives_f32 { jacobian, normal_force, friction, load_through_hertz }
    kstrip_friction { friction, ratio, decay, rolling_speed, slope_factor }
    kstrip_friction_f32 { friction, ratio, decay, rolling_speed, slope_factor }
    kstrip_friction_estimate { friction, sensitivity, residual, status_detail, reserved }
    kstrip_friction_estimate_f32 { friction, sensitivity, residual, status_detail, reserved }
}
