! A wheel on a rail in Fortran: patch, creep curve, derivatives, and a wheel that stops.
!
!   make && gfortran -J target bindings/fortran/kstrip.f90 bindings/fortran/wheel_rail.f90 target/lib/libkstrip.a -o target/wheel_rail_f && target/wheel_rail_f
program wheel_rail
   use kstrip
   use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_positive_inf
   implicit none
   type(kstrip_radii) :: radii
   type(kstrip_combined_material) :: steel = kstrip_combined_material(shear_modulus=82d9, poisson_ratio=0.28d0)
   type(kstrip_contact) :: contact
   type(kstrip_hertz_contact) :: ellipse
   type(kstrip_creepage) :: creepage
   type(kstrip_motion) :: motion
   type(kstrip_result), target :: force
   type(kstrip_derivatives), target :: by_creepage
   type(kstrip_motion_derivatives), target :: by_slip
   type(kstrip_outputs) :: outputs
   type(kstrip_motion_outputs) :: motion_outputs
   real(c_double) :: flat
   integer :: i

   flat = ieee_value(flat, ieee_positive_inf)
   radii = kstrip_radii(lower_x=flat, lower_y=0.30d0, upper_x=0.46d0, upper_y=flat)
   call check(kstrip_contact_from_hertz(radii, steel, 80d3, 0.3d0, contact, ellipse))
   print '(a, 2f10.6, f12.4)', 'a, b [mm], pressure [MPa]:', contact%a*1d3, contact%b*1d3, ellipse%peak_pressure/1d6

   ! Every output that is not null is computed.
   outputs%result = c_loc(force)
   outputs%derivatives = c_loc(by_creepage)
   do i = 0, 5
      creepage = kstrip_creepage(longitudinal=i*1d-3, lateral=0.5d-3, spin=0.1d0)
      call check(kstrip_evaluate(contact, creepage, outputs=outputs))
      print '(a, f8.4, 3f12.3, es16.6)', 'creepage', creepage%longitudinal, force%fx, force%fy, force%mz, by_creepage%jacobian(3, 2)
   end do

   ! Through standstill: slip velocity and rolling speed instead of creepage
   motion_outputs%result = c_loc(force)
   motion_outputs%derivatives = c_loc(by_slip)
   do i = -2, 2
      motion = kstrip_motion(slip_x=1d-3, rolling_speed=i*0.5d0)
      call check(kstrip_solve_motion(contact, motion, outputs=motion_outputs))
      print '(a, f8.4, f12.3, es16.6)', 'speed', motion%rolling_speed, force%fx, by_slip%slip(1, 1)
   end do

   contact%friction = -1
   print '(a)', kstrip_message(kstrip_solve(contact, creepage, result=force))

contains

   subroutine check(status)
      integer(c_int32_t), intent(in) :: status
      if (status < 0) error stop 'kstrip'
   end subroutine
end program
