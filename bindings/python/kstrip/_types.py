"""Structures of kstrip.h as numpy records. Written by write_types.py: do not edit."""

from ._record import Integers, Numbers, Part, Record


class Material(Record, name="material"):
    """An isotropic elastic body."""

    shear_modulus = Numbers('Pa', 'Shear modulus G [Pa], > 0. Steel: 82e9.')
    poisson_ratio = Numbers('', "Poisson's ratio [-], 0 to 0.5. Steel: 0.28.")


class CombinedMaterial(Record, name="combined_material"):
    """The combined elastic constants of two bodies."""

    shear_modulus = Numbers('Pa', 'Combined shear modulus G [Pa], 1/G = (1/G_lower + 1/G_upper)/2 (2.6).')
    poisson_ratio = Numbers('', "Combined Poisson's ratio nu [-], nu/G = (nu_lower/G_lower + nu_upper/G_upper)/2 (2.6).")
    mismatch = Numbers('', 'Mismatch kappa [-] (4.3) of the two materials, for kstrip_contact: 0 for like materials; -0.07 for steel (lower) on aluminium, -0.15 on a polymer.')


class Radii(Record, name="radii"):
    """Radii of curvature of two bodies at the contact [m]: convex positive, flat infinite (INFINITY), concave negative. Zero and NaN are errors."""

    lower_x = Numbers('m', 'Lower body in the plane of x and z (a straight rail: INFINITY).')
    lower_y = Numbers('m', 'Lower body in the plane of y and z (a rail: radius of the head).')
    upper_x = Numbers('m', 'Upper body in the plane of x and z (a wheel: rolling radius).')
    upper_y = Numbers('m', 'Upper body in the plane of y and z (a wheel: radius of the profile, INFINITY if conical).')


class Contact(Record, name="contact"):
    """A loaded elliptic contact with combined elastic constants and Coulomb friction."""

    a = Numbers('m', 'Semi-axis a along the rolling direction x [m], > 0.')
    b = Numbers('m', 'Semi-axis b along y [m], > 0.')
    normal_force = Numbers('N', 'Normal force N [N]. If it is <= 0 the contact is lost, and the other members only need to be finite.')
    shear_modulus = Numbers('Pa', 'Combined shear modulus G [Pa] (2.6), > 0.')
    poisson_ratio = Numbers('', "Combined Poisson's ratio nu [-], 0 to 0.5.")
    friction = Numbers('', 'Coefficient of friction mu [-], >= 0.')
    mismatch = Numbers('', 'Mismatch kappa [-] of the two materials (4.3), from kstrip_material_combine(). It is 0 for like materials and positive where the lower body is the softer one; its sign changes where the bodies are exchanged. In unlike bodies pressure makes a longitudinal creepage, so that there is a force without creepage. The theory of 1967 neglects the mismatch.')


class HertzContact(Record, name="hertz_contact"):
    """The contact ellipse of Hertz."""

    a = Numbers('m', 'Semi-axis along the rolling direction x [m].')
    b = Numbers('m', 'Semi-axis along y [m].')
    peak_pressure = Numbers('Pa', 'Pressure at the centre [Pa].')
    approach = Numbers('m', 'Approach of distant points of the two bodies [m].')
    axis_ratio = Numbers('', 'Minor divided by major semi-axis [-], 0 to 1 (2.2).')
    hertz_angle = Numbers('rad', "Hertz's angle tau [rad], 0 to pi/2 (2.5).")
    rho = Numbers('m', 'Four divided by the sum of the four curvatures [m] (2.3).')


class Velocity(Record, name="velocity"):
    """Velocity of one body's material at the centre of the contact, relative to the contact."""

    x = Numbers('m/s', 'Along the rolling direction x [m/s]: about minus the rolling speed for both bodies.')
    y = Numbers('m/s', 'Lateral, along y [m/s].')
    angular_z = Numbers('rad/s', 'Angular velocity about the normal z into the lower body [rad/s].')


class Creepage(Record, name="creepage"):
    """Rigid slip of the upper relative to the lower body, divided by the rolling speed (3.3)."""

    longitudinal = Numbers('', 'Longitudinal creepage [-], positive when the upper body slides in the rolling direction.')
    lateral = Numbers('', 'Lateral creepage [-], positive along y.')
    spin = Numbers('1/m', 'Spin [1/m], positive from x to y, that is about z into the lower body.')


class Parameters(Record, name="parameters"):
    """Kalker's parameters (5.13) of a contact in motion, dimensionless."""

    xi = Numbers('', 'xi = longitudinal G/(2 (1 - nu) mu p0)')
    eta = Numbers('', 'eta = lateral G/(2 mu p0)')
    psi = Numbers('', 'psi = a spin G/(2 mu p0). The theory of 1967 is valid for |psi| < 1.')


class Options(Record, name="options"):
    """The model and the number of strips. All zero is the default."""

    model = Integers('', 'One of the KSTRIP_MODEL constants.')
    strips = Integers('', 'Number of strips: 4, 8, 16, 32 or 64; 0 means 16. Models without strips check it and ignore it otherwise.')


class Result(Record, name="result"):
    """Forces on the lower body."""

    fx = Numbers('N', 'Longitudinal force [N], positive along the rolling direction.')
    fy = Numbers('N', 'Lateral force [N].')
    mz = Numbers('N m', 'Moment about z at the centre of the contact [N m].')
    power = Numbers('N', 'Frictional power divided by rolling speed, fx longitudinal + fy lateral + mz spin [N]: energy dissipated per metre rolled. For unlike bodies the creepage that pressure makes is added to the longitudinal one.')
    adhesion = Numbers('', 'Share of the contact area in adhesion [-], 0 to 1. It is -1 with KSTRIP_MODEL_TOTAL, which does not compute it, and 1 with KSTRIP_MODEL_LINEAR, which has adhesion everywhere.')
    status_detail = Integers('', 'The status of this result: 0 or one of the KSTRIP_WARNING constants.')


class Friction(Record, name="friction"):
    """Friction that falls with the slip: the coefficient is friction ((1 - ratio) exp(-decay w) + ratio), where w is the sliding velocity [m/s]. A layer between the bodies makes the creep curve less steep: slope_factor and slide_factor describe it for a measured or published curve, and layer is an elastic layer that is known. Polach, Wear 258 (2005) 992, gives for locomotives: dry friction 0.55, ratio 0.4, decay 0.6 s/m; wet 0.3, 0.4, 0.2 s/m."""

    friction = Numbers('', 'Coefficient of friction without slip [-], >= 0.')
    ratio = Numbers('', 'Friction at infinite sliding velocity divided by friction at zero velocity [-], 0 to 1; 1: friction is constant.')
    decay = Numbers('s/m', 'How fast friction falls [s/m], >= 0; 0: friction is constant.')
    rolling_speed = Numbers('m/s', 'Rolling speed [m/s], >= 0: sliding velocity is slip times rolling speed; 0: friction is constant.')
    slope_factor = Numbers('', 'Initial slope of the creep curve divided by that of clean bodies [-], 0 to 1; 0 stands for 1, clean.')
    slide_factor = Numbers('', 'Stretch of the creep curve far in sliding divided by that at its start [-], 0 to 1; 0 stands for 1: the whole curve is stretched alike.')
    layer = Numbers('m/Pa', 'Thickness of an elastic layer between the bodies divided by its shear modulus [m/Pa], >= 0; 0: none.')


class Derivatives(Record, name="derivatives"):
    """Derivatives of fx, fy, mz with respect to creepages, load and friction."""

    jacobian = Numbers('N, N, N m per 1, 1, 1/m', 'With respect to longitudinal, lateral, spin, row by row [N, N, N m per 1, 1, 1/m]; at kinks of a model a one-sided value.')
    normal_force = Numbers('-, -, m', 'With respect to the normal force at fixed a and b [-, -, m].')
    load_through_hertz = Numbers('-, -, m', 'With respect to the normal force while a and b follow it as Hertz says: both grow like its cube root [-, -, m].')
    friction = Numbers('N, N, N m', 'With respect to the coefficient of friction, that of the law where there is one [N, N, N m].')


class LawDerivatives(Record, name="law_derivatives"):
    """Derivatives of fx, fy, mz with respect to the parameters of falling friction."""

    ratio = Numbers('N, N, N m', 'With respect to the ratio [N, N, N m].')
    decay = Numbers('N, N, N m per s/m', 'With respect to the decay [N, N, N m per s/m].')
    rolling_speed = Numbers('N, N, N m per m/s', 'With respect to the rolling speed of the law at constant creepages [N, N, N m per m/s].')
    slope_factor = Numbers('N, N, N m', 'With respect to the factor of the initial slope, at 1 without a law [N, N, N m].')
    slide_factor = Numbers('N, N, N m', 'With respect to the slide factor [N, N, N m]; 0 where it is 0 in a law without a layer.')
    layer = Numbers('N, N, N m per m/Pa', 'With respect to the layer [N, N, N m per m/Pa]; 0 where there is none.')


class Strip(Record, name="strip"):
    """One strip y = const of a contact or a patch, and the forces that it carries on the lower body."""

    y = Numbers('m', 'Centre line [m].')
    width = Numbers('m', 'Width of the strip [m].')
    half_length = Numbers('m', 'Half of its length along x [m].')
    separatrix = Numbers('m', 'x of the separatrix [m], with slip behind it and adhesion ahead of it; the leading edge if the whole strip slides.')
    fx = Numbers('N', 'Its share of the longitudinal force [N].')
    fy = Numbers('N', 'Its share of the lateral force [N].')
    mz = Numbers('N m', 'Its share of the moment about the centre of the contact [N m].')
    power = Numbers('N', 'Its share of the frictional power [N].')
    state = Integers('', 'KSTRIP_STATE_STICK if it has an adhesion area, else KSTRIP_STATE_SLIP.')


class Prepared(Record, name="prepared"):
    """A contact for which kstrip_prepare() has computed everything that does not depend on the motion. The structure holds plain numbers and no pointers, so it may be copied and kept, for this version of the library only. It begins with a mark: a structure that was never prepared, or was prepared in the other precision, gives KSTRIP_ERROR_NOT_PREPARED."""

    numbers = Numbers('', 'For use by the library only.')
    model = Integers('', 'The model; 0: nothing prepared.')
    strips = Integers('', 'The strip count.')


class Motion(Record, name="motion"):
    """Motion of the upper body relative to the lower one at the contact, in axes that stay when the motion reverses."""

    slip_x = Numbers('m/s', 'Velocity of the upper relative to the lower body along x [m/s].')
    slip_y = Numbers('m/s', 'Velocity of the upper relative to the lower body along y [m/s].')
    spin_rate = Numbers('rad/s', 'Angular velocity of the upper relative to the lower body about z [rad/s].')
    rolling_speed = Numbers('m/s', 'Rolling speed [m/s]: positive along x, negative backward, zero at standstill.')
    floor_speed = Numbers('m/s', 'Floor of the speed [m/s], >= 0: creepages are slip divided by sqrt(rolling_speed^2 + floor_speed^2). 0 stands for 0.02.')


class MotionDerivatives(Record, name="motion_derivatives"):
    """Derivatives of fx, fy, mz with respect to motion, load and friction."""

    slip = Numbers('N, N, N m per m/s, m/s, rad/s', 'With respect to slip_x, slip_y, spin_rate, row by row [N, N, N m per m/s, m/s, rad/s].')
    rolling_speed = Numbers('N, N, N m per m/s', 'With respect to the rolling speed at constant slip and spin rate [N, N, N m per m/s].')
    normal_force = Numbers('-, -, m', 'With respect to the normal force at fixed a and b [-, -, m].')
    load_through_hertz = Numbers('-, -, m', 'With respect to the normal force while a and b follow it as Hertz says [-, -, m].')
    friction = Numbers('N, N, N m', 'With respect to the coefficient of friction, that of the law where there is one [N, N, N m].')
    ratio = Numbers('N, N, N m', 'With respect to the ratio of the law; 0 without one [N, N, N m].')
    decay = Numbers('N, N, N m per s/m', 'With respect to the decay of the law; 0 without one [N, N, N m per s/m].')
    slope_factor = Numbers('N, N, N m', 'With respect to the slope factor of the law, at 1 without one [N, N, N m].')
    slide_factor = Numbers('N, N, N m', 'With respect to the slide factor of the law; 0 where it is 0 in a law without a layer [N, N, N m].')
    layer = Numbers('N, N, N m per m/Pa', 'With respect to the layer of the law; 0 where there is none [N, N, N m per m/Pa].')


class Point(Record, name="point"):
    """The state of a point of the contact plane. Tractions act on the lower body."""

    pressure = Numbers('Pa', 'Pressure [Pa].')
    traction_x = Numbers('Pa', 'Tangential traction along x [Pa].')
    traction_y = Numbers('Pa', 'Tangential traction along y [Pa].')
    slip_x = Numbers('', 'Slip of the upper relative to the lower body along x, divided by the rolling speed [-].')
    slip_y = Numbers('', 'Slip along y, divided by the rolling speed [-].')
    dissipation = Numbers('Pa', 'Traction times slip [Pa]: energy dissipated per area and metre rolled.')
    state = Integers('', 'One of the KSTRIP_STATE constants.')


class ProfileContact(Record, name="profile_contact"):
    """Load or approach, material and friction of two profiles that are pressed together. Zero is the default of every member but rolling_radius, shear_modulus and one of normal_force and approach."""

    rolling_radius = Numbers('m', 'Rolling radius [m], > 0; of two rolling bodies 1/R = 1/R_lower + 1/R_upper. It is ignored where the profile has its own radii.')
    normal_force = Numbers('N', 'Normal force N [N], >= 0; 0: approach decides.')
    approach = Numbers('m', 'Approach of distant points of the bodies [m], >= 0; only where normal_force is 0.')
    smoothing_length = Numbers('m', 'Length over which the profile is smoothed [m], >= 0. 0 stands for half the width of the contact, at most 2 mm. The length is always at least 2.5 steps of the profile. For rough profiles set it to 4 mm.')
    shear_modulus = Numbers('Pa', 'Combined shear modulus G [Pa], > 0.')
    poisson_ratio = Numbers('', "Combined Poisson's ratio [-], 0 to 0.5.")
    friction = Numbers('', 'Coefficient of friction of every strip [-], >= 0.')
    strips = Integers('', 'About how many strips all zones have together: 4, 8, 16, 32 or 64 (which gives 40); 0: 16.')


class PatchStrip(Record, name="patch_strip"):
    """One strip of a patch, along the rolling direction. Its pressure is a half-ellipse in x, peak_pressure sqrt(1 - (x - centre_x)^2/half_length^2), and does not vary over its width."""

    y = Numbers('m', 'Centre line y [m].')
    width = Numbers('m', 'Width [m], > 0.')
    half_length = Numbers('m', 'Half length along x [m], > 0.')
    centre_x = Numbers('m', 'Centre along x [m]; 0 for most contacts.')
    peak_pressure = Numbers('Pa', 'Pressure at the centre [Pa], >= 0.')
    friction = Numbers('', 'Coefficient of friction [-], >= 0; every strip may have its own.')


class Patch(Record, name="patch"):
    """A contact patch of any shape: its strips, in ascending y. Filled by kstrip_patch_from_contact(), kstrip_patch_from_strips() or kstrip_patch_from_profile(); the members may then be changed. All functions check it again. A patch whose members are all zero, except shear_modulus, carries no load. Where the distance of two neighbours is more than one and a half times that at which they touch, there is a gap: the strips on either side are a lobe of their own."""

    strips = Part(PatchStrip, '', 'The strips; the first count are used.')
    shear_modulus = Numbers('Pa', 'Combined shear modulus G [Pa], > 0.')
    poisson_ratio = Numbers('', "Combined Poisson's ratio [-], 0 to 0.5.")
    area_scale = Numbers('', "Factor [-], > 0, that makes the sum of the strips' areas the patch's area: 1 unless the strips are a quadrature rule (kstrip_patch_from_contact()); 0 stands for 1.")
    lever_scale = Numbers('', 'The same for the moment of the area about x, the sum of y^2 times area.')
    count = Integers('', 'Number of strips, 0 to KSTRIP_PATCH_CAPACITY. None: no load.')
    mismatch = Numbers('', 'Mismatch kappa [-] of the two materials, as in kstrip_contact. Only kstrip_patch_from_contact() sets it; the other functions leave it 0, and the caller may set it.')


class ProfileResult(Record, name="profile_result"):
    """Approach, load and pressure of two profiles in contact."""

    approach = Numbers('m', 'Approach of distant points of the two bodies [m] from where they touch: at the lowest point of the smoothed profile.')
    normal_force = Numbers('N', 'Normal force of the strips [N]. If a load is given, it is that load to rounding.')
    stiffness = Numbers('N/m', 'Derivative of the normal force with respect to the approach [N/m].')
    peak_pressure = Numbers('Pa', 'Largest pressure of a strip [Pa].')
    peak_y = Numbers('m', 'y of the strip with the largest pressure [m].')
    iterations = Integers('', 'Steps of the two searches for the approach, at most 60 each.')
    status_detail = Integers('', 'The status of this result: 0, or KSTRIP_WARNING_PROFILE_END where a zone of contact ends with the profile.')
    lowest = Numbers('m', 'Distance at that lowest point [m], or of the given points without contact: the bodies have moved by approach + lowest.')


class PatchSummary(Record, name="patch_summary"):
    """Load, friction bound and area of a patch."""

    normal_force = Numbers('N', 'Normal force [N].')
    friction_bound = Numbers('N', 'Sum of friction times load over the strips [N]: no tangential force exceeds it.')
    area = Numbers('m^2', 'Contact area [m^2].')
    lobes = Integers('', 'Number of lobes.')


class Surface(Record, name="surface"):
    """A profile, prepared by kstrip_prepare_profile(): points at equal steps of its length, toward larger y, and its direction. It holds plain numbers and may be copied."""

    y = Numbers('m', 'y [m], to the right: of a rail from its origin, of a wheel from its running circle, with the flange at small y.')
    z = Numbers('m', 'z [m], down; of a wheel its radius minus wheel_radius.')
    cosine = Numbers('', "Derivative of y with respect to the length: the cosine of the profile's angle.")
    sine = Numbers('', "Derivative of z with respect to the length: the sine of the profile's angle.")
    step = Numbers('m', 'Length between two points [m].')
    spacing = Numbers('m', 'Mean distance between the points that were given [m].')
    count = Integers('', 'Number of points, 4 to KSTRIP_SURFACE_CAPACITY.')
    form = Integers('', 'What the shape tells: 0 nothing, or a sum of 1 (it is not the profile of a wheel), 2 (it is not the profile of a rail) and 4 (it has few points, and is not smooth between them).')


class WheelPosition(Record, name="wheel_position"):
    """Position of the wheel on straight track. The flange of a right wheel touches the gauge side of the rail, which is at small y."""

    lateral = Numbers('m', "y of the wheel's centre from the origin of the rail's profile [m], to the right. The centre is the point of the axle at y = 0 of the wheel's profile.")
    vertical = Numbers('m', "Zero when the centre is one wheel radius above the rail's origin; positive downward [m].")
    yaw = Numbers('rad', 'Turn about the vertical, which points down [rad]: positive from x to y, between -1 and 1.')
    roll = Numbers('rad', 'Turn about x [rad]: positive from y to z, between -1 and 1. Yaw turns about the axis that roll has turned.')


class Gap(Record, name="gap"):
    """The gap between a wheel and a rail, point by point along the rail. A host with its own search of contact fills it. The first count elements of each member are used."""

    along = Numbers('m', "Length on the rail's surface from any origin [m], ascending. A host that works in a plane passes its coordinate in this plane.")
    distance = Numbers('m', "Distance of the undeformed surfaces along the rail's normal [m]; negative where they would overlap.")
    x = Numbers('m', "x of the point on the wheel's undeformed surface from the wheel's centre, axes of the track [m]: 0 without yaw.")
    y = Numbers('m', 'y of this point [m].')
    z = Numbers('m', "z of this point [m], about the wheel's radius.")
    angle = Numbers('rad', 'Angle of the tangent across x, mean of both surfaces [rad], positive from y to z; about -1.2 at the flange of a right wheel.')
    rolling_radius = Numbers('m', "Radius of curvature of the wheel along x [m]. Without yaw R0 = r/cos a: distance from the axle divided by the cosine of the angle between normal and radius. A wheel that yaws has R0/(1 + (sin yaw/cos a)^2 (k R0 - 1)), with the curvature k of its profile; this is R0 (1 - dx/ds tan(yaw)/cos a) where x changes by dx/ds along the line of these points. Over a roller the curvatures of both add up, and angle and distance are those in the plane through the roller's axis and the point.")
    step = Numbers('m', "Distance of the wheel's points [m], >= 0, over 2.5 of which surfaces are smoothed at least; 0: that of the gap's points where the surfaces are near.")
    count = Integers('', 'Number of points.')


class WheelPair(Record, name="wheel_pair"):
    """Materials and friction of a wheel and a rail, and options of the computation. Zero is the default of every member but wheel_radius and shear_modulus."""

    wheel_radius = Numbers('m', 'Radius of the wheel at z = 0 of its profile [m], > 0.')
    shear_modulus = Numbers('Pa', 'Combined shear modulus G [Pa], > 0.')
    poisson_ratio = Numbers('', "Combined Poisson's ratio [-], 0 to 0.5.")
    friction = Numbers('', 'Coefficient of friction [-], >= 0; where friction_points is 0.')
    friction_y = Numbers('m', 'Places on the rail, y of its profile [m], ascending.')
    friction_at = Numbers('', 'Coefficient of friction at these places [-], >= 0; linear between them, constant beyond.')
    friction_points = Integers('', 'How many of these places there are, at most KSTRIP_RAIL_FRICTION_CAPACITY; 0: friction is the same everywhere.')
    left = Integers('', "0: a right wheel; any other number: a left wheel. The profiles are always those of a right wheel; position, velocity and wrench are the wheel's own.")
    smoothing_length = Numbers('m', "Length over which the distance of the surfaces is smoothed [m], >= 0. It is always at least 2.5 steps of the wheel's profile. For rough profiles set it to 2 mm.")
    strips = Integers('', 'About how many strips a contact has: 4, 8, 16, 32 or 64; 0: 16.')
    model = Integers('', 'KSTRIP_MODEL_STRIP (the default here), KSTRIP_MODEL_TOTAL or one of the models of 1967.')
    normal_damping = Numbers('s/m', 'Damping of the pressure d [s/m], >= 0 (Hunt and Crossley): the pressure is multiplied by 1 + d times the velocity at which the surfaces approach each other, or by 0 where this factor is negative; the bound of friction changes with it.')
    floor_speed = Numbers('m/s', 'Floor of the speed [m/s], >= 0, as in kstrip_motion; 0 stands for 0.02.')
    rail_radius = Numbers('m', 'Radius of the rail at z = 0 of its profile [m], >= 0: that of a roller rig or of the lower of two discs, whose axis is along y; 0: a straight rail.')
    rail_ahead = Numbers('m', "x of the roller's axis from the wheel's centre [m]; not used for a straight rail.")
    rail_speed = Numbers('m/s', 'Speed at which the surface of the rail moves backward under the wheel [m/s], that of a roller at rail_radius: a wheel whose centre is at rest rolls on it like a wheel that moves forward on a rail at rest.')


class WheelContact(Record, name="wheel_contact"):
    """One contact of a wheel. Its frame is (x, t, n): forward, across along the surface, into the rail."""

    origin = Numbers('m', "Point where the pressure acts, on the wheel's undeformed surface, from the wheel's centre [m], axes of the track.")
    angle = Numbers('rad', "Angle of the contact plane [rad]: mean of the strips' angles, weighted with load. For a left wheel it is that of the mirrored right wheel.")
    angle_range = Numbers('rad', 'Range of the angle over the patch [rad]; above 0.52 the status is KSTRIP_WARNING_ANGLE_RANGE.')
    radius = Numbers('m', 'Distance of the origin from the axle [m].')
    normal_force = Numbers('N', 'Load of the strips [N].')
    share = Numbers('', 'Factor of load and forces in the sum over the contacts [-]: 1, except for contacts 4 to 8 mm apart, which count partly by themselves and partly as one contact.')
    approach = Numbers('m', 'Overlap of the undeformed, smoothed surfaces where it is deepest [m].')
    stiffness = Numbers('N/m', 'Derivative of the load with respect to the distance by which the surfaces are moved into each other [N/m].')
    along = Numbers('m', 'Length on the rail at y = 0 of the patch [m].')
    normal = Numbers('', "Derivatives of the wheel's velocity into the rail, mean of the strips weighted with load, with respect to the members of kstrip_wheel_velocity. The force and the moment of the pressure on the wheel are minus share times normal_force times these six numbers, and times the factor of the damping.")
    slip_x = Numbers('', "slip_x of kstrip_motion at the patch's origin: derivatives with respect to the members of kstrip_wheel_velocity.")
    slip_y = Numbers('', 'slip_y of kstrip_motion.')
    spin_rate = Numbers('', 'spin_rate of kstrip_motion.')
    rolling_speed = Numbers('', 'rolling_speed of kstrip_motion.')
    normal_damping = Numbers('', 'normal_damping of kstrip_wheel_pair.')
    at_rest = Part(Motion, '', "kstrip_motion of a wheel at rest: that of the rail's surface, with the floor of the speed.")
    patch = Part(Patch, '', "The strips; y along the rail's surface, x forward from the origin.")
    own = Numbers('', "Share of each strip's own slip, 0 to 1; the rest is that of a plane contact. 0 where the normal turns by less than about 5 degrees, 0.8 from about 10 degrees on, and 0 on rollers.")
    strip_y = Numbers('m', "y of each strip on the wheel's undeformed surface, from the wheel's centre [m], axes of the track; of a left wheel that of the mirrored right wheel.")
    strip_z = Numbers('m', 'z of each strip [m].')
    strip_angle = Numbers('rad', 'Angle of each strip [rad], as the angle of the contact.')
    turned = Numbers('rad', 'Roll and yaw of the wheel [rad]; of a left wheel those of the mirrored right wheel.')
    left = Integers('', 'Whether the wheel is a left one, as in kstrip_wheel_pair.')


class WheelVelocity(Record, name="wheel_velocity"):
    """Velocity of the wheel relative to the rail. The axes are at rest; in a curve they are those of the momentary track. Lateral, roll and yaw have the track's signs for a left wheel too."""

    forward = Numbers('m/s', "Velocity of the wheel's centre along x [m/s].")
    lateral = Numbers('m/s', 'Velocity of the centre along y [m/s].')
    vertical = Numbers('m/s', 'Velocity of the centre along z, down [m/s].')
    roll = Numbers('rad/s', "Rate about the wheelset's own x [rad/s]. These axes yaw and roll with the wheelset but do not spin.")
    pitch = Numbers('rad/s', 'Rate about the axle [rad/s]: about minus forward divided by radius.')
    yaw = Numbers('rad/s', "Rate about the wheelset's own z [rad/s].")


class Wrench(Record, name="wrench"):
    """Force and moment on a wheel. They are conjugate to the members of kstrip_wheel_velocity: the products add up to power."""

    force = Numbers('N', "Force on the wheel, axes of the track [N]: forward, lateral, vertical (down; the rail's support is negative).")
    moment = Numbers('N m', "Moment on the wheel about its centre [N m] about the wheelset's own axes: roll, pitch (about the axle), yaw.")
    dissipation = Numbers('W', 'Frictional power [W], not negative: creep forces on the rail times slip. The power of the creep forces on the wheel is minus this, but for contacts with a mismatch of the materials, where pressure adds to the slip.')
    normal_force = Numbers('N', 'Sum of the loads of all contacts [N], each along its own normal: share times normal_force of kstrip_wheel_contact, times the factor of the damping.')
    contacts = Integers('', 'Number of contacts, those that kstrip_wheel_workspace lists; of a wheelset those of both wheels. 0: the wheel is lifted, and nothing acts.')
    status_detail = Integers('', 'The status of this result: 0 or one of the KSTRIP_WARNING constants.')


class WrenchDerivatives(Record, name="wrench_derivatives"):
    """Exact derivatives of the wrench. The rows are the members of force and moment."""

    velocity = Numbers('N, N m per m/s, rad/s', 'With respect to the members of kstrip_wheel_velocity [N, N m per m/s, rad/s].')
    friction = Numbers('N, N m', 'With respect to a factor on all coefficients of friction, at 1 [N, N m].')


class WheelWorkspace(Record, name="wheel_workspace"):
    """Memory of the caller for the computation of one wheel. It may hold anything before a call. After KSTRIP_OK or a warning it holds the gap and the contacts of the position; after an error its contents have no meaning."""

    gap = Part(Gap, '', 'The gap between the surfaces.')
    strips = Part(Patch, '', 'Memory in which the normal problem of a contact is solved.')
    contacts = Part(WheelContact, '', 'The contacts, in ascending y of a right wheel; the first count are used.')
    count = Integers('', 'Number of contacts.')


class WrenchByPosition(Record, name="wrench_by_position"):
    """Derivatives of the wrench with respect to the wheel's position at constant velocity."""

    lateral = Numbers('N, N m per m', 'With respect to the lateral position [N, N m per m].')
    vertical = Numbers('N, N m per m', 'With respect to the vertical position [N, N m per m].')
    yaw = Numbers('N, N m per rad', 'With respect to yaw [N, N m per rad].')
    roll = Numbers('N, N m per rad', 'With respect to roll [N, N m per rad].')


class Curve(Record, name="curve"):
    """A curve that a vehicle runs through: the axes of the track move forward and turn with it."""

    speed = Numbers('m/s', "Speed along the middle of the track, at the height of the wheelset's centre [m/s].")
    curvature = Numbers('1/m', 'One divided by the radius of the curve [1/m]: positive to the right, 0: straight.')
    cant = Numbers('rad', 'Angle of cant [rad]: positive where the right rail is lower, between -1 and 1. In a curve to the right it is positive.')
    gravity = Numbers('m/s^2', 'Acceleration of gravity [m/s^2]; 0: 9.80665.')


class RailMotion(Record, name="rail_motion"):
    """Displacement and velocity of a rail: irregularities of the track, or the motion of a flexible rail. Axes of the track."""

    lateral = Numbers('m', 'Displacement to the right [m].')
    vertical = Numbers('m', 'Displacement downward [m].')
    lateral_velocity = Numbers('m/s', 'Velocity to the right [m/s].')
    vertical_velocity = Numbers('m/s', 'Velocity downward [m/s].')


class WheelsetWorkspace(Record, name="wheelset_workspace"):
    """Memory of the caller for the computation of a wheelset: that of the right wheel and that of the left one. It may hold anything before a call. After KSTRIP_OK or a warning it holds gap and contacts of both wheels."""

    wheel = Part(WheelWorkspace, '', 'Right, left.')


class WheelsetForces(Record, name="wheelset_forces"):
    """Forces on a wheelset, on each wheel, and on each rail."""

    wrench = Part(Wrench, '', 'Force on the wheelset [N], axes of the track, and moment about its centre [N m], its own axes; sums of dissipation, loads, contacts.')
    wheel = Part(Wrench, '', "Force and moment on the right and on the left wheel, about the wheel's centre.")
    rail = Numbers('N', 'Force on the right and on the left rail [N], axes of the track: forward, lateral (Y, to the right), vertical (Q, down).')


class WheelsetDerivatives(Record, name="wheelset_derivatives"):
    """Exact derivatives of the forces on a wheelset and its two rails with respect to the velocities. Rows are the ten forces: force and moment on the wheelset, then lateral and vertical force on the right rail and on the left rail. Columns are the ten freedoms (KSTRIP_WHEELSET_FREEDOMS)."""

    velocity = Numbers('N, N m per m/s, rad/s', 'With respect to the velocities [N, N m per m/s, rad/s].')
    friction = Numbers('N, N m', 'With respect to a factor on all coefficients of friction, at 1 [N, N m].')


class WheelsetByPosition(Record, name="wheelset_by_position"):
    """Derivatives of the same ten forces with respect to the positions of the ten freedoms, at constant velocities."""

    position = Numbers('N, N m per m, rad', 'With respect to the positions [N, N m per m, rad]; the columns of forward and pitch are zero.')


class WheelsetLoads(Record, name="wheelset_loads"):
    """Loads of the vehicle and of gravity on a wheelset that does not accelerate."""

    vertical = Numbers('N', "Downward force at the wheelset's centre [N], its weight included, > 0.")
    roll = Numbers('N m', "Moment about the wheelset's x axis [N m]: positive from y to z, onto the right rail.")
    pitch = Numbers('N m', 'Torque about the axle [N m], in the sense of the pitch rate: negative where it drives forward.')


class FrictionEstimate(Record, name="friction_estimate"):
    """A coefficient of friction from a measured force."""

    friction = Numbers('', 'Coefficient of friction [-]; a lower bound with KSTRIP_WARNING_FRICTION_AT_LEAST.')
    sensitivity = Numbers('1/N', 'd(friction)/d(force) [1/N]: change of the coefficient for an error of 1 N in the measured force; 0 for a lower bound.')
    residual = Numbers('N', 'Distance between the measured and the computed force [N] in the components that were measured. For one component it is rounding; for both it is the part that friction cannot explain, because the directions of the forces differ.')
    status_detail = Integers('', 'The status of this result: 0 or one of the KSTRIP_WARNING constants.')


class MeasuredForce(Record, name="measured_force"):
    """One measured point of a creep curve."""

    longitudinal = Numbers('', 'Longitudinal creepage [-].')
    lateral = Numbers('', 'Lateral creepage [-].')
    spin = Numbers('1/m', 'Spin [1/m].')
    fx = Numbers('N', 'Longitudinal force on the lower body [N]; ignored unless it was measured.')
    fy = Numbers('N', 'Lateral force on the lower body [N]; ignored unless it was measured.')
    weight = Numbers('', 'Weight of the squared error of a force, >= 0: 1 for points of equal accuracy, 1/error^2 otherwise; 0: the point does not count.')
    measured = Integers('', 'KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY, or both added.')


class FrictionFit(Record, name="friction_fit"):
    """A law of friction that was fitted to measured points."""

    law = Part(Friction, '', 'The law.')
    standard_errors = Part(Friction, '', 'Standard errors of its members, from the remaining differences between points and law; 0 for a member that was not fitted or that ended at a bound.')
    residual = Numbers('N', 'Root of the weighted mean of the squared differences between measured and computed forces [N].')
    steps = Integers('', 'Number of times that all forces were computed.')
    status_detail = Integers('', 'The status of this result: 0 or one of the KSTRIP_WARNING constants.')
