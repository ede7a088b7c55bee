! A wheelset on its track, a law of friction with a layer, and the fit of a law to measured forces, in Fortran.
!
!   make && gfortran -J target bindings/fortran/kstrip.f90 bindings/fortran/wheelset.f90 target/lib/libkstrip.a -o target/wheelset_f && target/wheelset_f
program wheelset
   use kstrip
   implicit none
   integer, parameter :: points = 121, measured = 30, cells = 161
   type(kstrip_surface), target :: rail, wheel
   type(kstrip_wheelset) :: set
   type(kstrip_track) :: track
   type(kstrip_wheelset_workspace) :: memory
   type(kstrip_wheel_position) :: starts(3), positions(3)
   type(kstrip_wheel_velocity) :: velocity(1), moves(3)
   type(kstrip_wheelset_loads) :: loads(1) = kstrip_wheelset_loads(vertical=160d3)
   type(kstrip_wheelset_forces) :: forces(3), again
   type(kstrip_contact) :: contact
   type(kstrip_friction) :: law, start
   type(kstrip_result), target :: force
   type(kstrip_outputs) :: outputs
   type(kstrip_measured_force) :: curve(measured)
   type(kstrip_friction_fit) :: fit
   type(kstrip_patch) :: patch
   type(kstrip_point) :: tractions(cells*cells)
   type(kstrip_options) :: strip = kstrip_options(model=kstrip_model_strip)
   type(kstrip_creepage) :: motion = kstrip_creepage(longitudinal=2d-3, lateral=1d-3, spin=0.2d0)
   real(c_double) :: y(points), clean, ahead(cells), across(cells), cell
   integer(c_int32_t) :: statuses(3)
   integer :: i

   ! A cone of 1:20 on a round head
   y = [(0.5d-3*(i - 61), i=1, points)]
   call check(kstrip_prepare_profile(y, 0.3d0 - sqrt(0.09d0 - y**2), points, 0d0, 0d0, rail))
   call check(kstrip_prepare_profile(y, -0.05d0*y, points, 0d0, 0d0, wheel))
   track%rail(1) = c_loc(rail)
   track%gauge = 1.446d0
   track%gauge_depth = 1d-3
   set%wheel(1) = c_loc(wheel)
   set%pair(1) = kstrip_wheel_pair(wheel_radius=0.46d0, shear_modulus=82d9, poisson_ratio=0.28d0, friction=0.3d0)
   set%back_to_back = 1.36d0

   ! Three balances in one call: start and position are arrays, velocity and load are one for all
   do i = 1, 3
      starts(i)%lateral = (i - 2)*1d-3
   end do
   velocity(1) = kstrip_wheel_velocity(forward=20d0, pitch=-20d0/0.46d0)
   call check(kstrip_wheelsets_settle(set, track, 3, starts, int(c_sizeof(starts(1)), c_int32_t), velocity, 0, loads, 0, memory, &
      positions, moves, forces, statuses))
   do i = 1, 3
      call check(kstrip_wheelset_on_track(set, track, positions(i), moves(i), memory, again))
      print '(a, f8.3, 3f14.3)', 'wheelset', positions(i)%lateral*1d3, forces(i)%rail(3, 1) + forces(i)%rail(3, 2), &
         forces(i)%wrench%force(2), again%wrench%force(2)
   end do

   ! Falling friction, behind a layer of a wet rail
   contact = kstrip_contact(a=6d-3, b=4.5d-3, normal_force=80d3, shear_modulus=82d9, poisson_ratio=0.28d0, friction=0.3d0)
   law = kstrip_friction(friction=0.35d0, ratio=0.5d0, decay=0.3d0, rolling_speed=10d0, layer=1d-13)
   outputs%result = c_loc(force)
   do i = 1, measured
      curve(i)%longitudinal = 2d-3*i - 1.8d-3
      call check(kstrip_evaluate(contact, kstrip_creepage(longitudinal=curve(i)%longitudinal), law, outputs=outputs))
      curve(i)%fx = force%fx
      curve(i)%weight = 1
      curve(i)%measured = kstrip_measured_fx
   end do
   call check(kstrip_solve(contact, kstrip_creepage(longitudinal=curve(1)%longitudinal), result=force))
   clean = force%fx
   print '(a, 2f14.3)', 'layer', curve(1)%fx, clean

   ! The law from its forces
   start = law
   start%friction = 0
   start%layer = 0
   call check(kstrip_fit_friction(contact, curve, measured, start, ior(kstrip_fit_friction_expected, kstrip_fit_layer), fit=fit))
   print '(a, f10.6, es16.6, f12.6)', 'fit', fit%law%friction, fit%law%layer, fit%residual

   ! Its tractions, of the contact and of its patch, add up to the force
   ahead = [(0.075d-3*(i - 81), i=1, cells)]
   across = [(0.057d-3*(i - 81), i=1, cells)]
   cell = 0.075d-3*0.057d-3
   call check(kstrip_evaluate(contact, motion, law, strip, outputs))
   call check(kstrip_patch_from_contact(contact, strip, patch))
   call check(kstrip_field(contact, motion, law, strip, ahead, cells, across, cells, tractions, cells*cells))
   clean = sum(tractions%traction_x)*cell
   call check(kstrip_patch_field(patch, motion, law, strip, ahead, cells, across, cells, tractions, cells*cells))
   print '(a, 3f14.3)', 'tractions', force%fx, clean, sum(tractions%traction_x)*cell

contains

   subroutine check(status)
      integer(c_int32_t), intent(in) :: status
      if (status < 0) error stop 'kstrip'
   end subroutine
end program
