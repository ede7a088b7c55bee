"""Values: a class for each structure of kstrip.h. Written by write_types.py: do not edit.

The members of each class are numbers in SI units, numpy arrays and other values. The functions of kstrip make them, and take them
one by one or many in a kstrip.Batch."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from ._value import Array, FrictionPlaces, Value

if TYPE_CHECKING:
    from ._batch import Batch

__all__ = ['Material', 'CombinedMaterial', 'Radii', 'Contact', 'HertzContact', 'Velocity', 'Creepage', 'Parameters', 'Result', 'Friction', 'Derivatives',
 'LawDerivatives', 'Strip', 'Motion', 'MotionDerivatives', 'Point', 'PatchStrip', 'Patch', 'ProfileResult', 'PatchSummary', 'WheelPosition',
 'WheelPair', 'WheelContact', 'WheelVelocity', 'Wrench', 'WrenchDerivatives', 'StripPower', 'WrenchByPosition', 'Curve', 'RailMotion',
 'WheelsetForces', 'WheelsetDerivatives', 'WheelsetByPosition', 'FrictionEstimate', 'FrictionFit']


@dataclass(slots=True, init=False, repr=False, eq=False)
class Material(Value):
    """An isotropic elastic body.

    shear_modulus: Shear modulus G [Pa], > 0, else KSTRIP_ERROR_MODULUS. Steel: 82e9.
    poisson_ratio: Poisson's ratio [-], 0 to 0.5, else KSTRIP_ERROR_POISSON_RATIO. Steel: 0.28.
    """

    _structure: ClassVar[str] = "material"
    _units: ClassVar[dict[str, str]] = {'shear_modulus': 'Pa'}

    shear_modulus: float
    poisson_ratio: float

    def __init__(self, shear_modulus: float, poisson_ratio: float) -> None:
        self.shear_modulus = shear_modulus
        self.poisson_ratio = poisson_ratio


@dataclass(slots=True, init=False, repr=False, eq=False)
class CombinedMaterial(Value):
    """The combined elastic constants of two bodies.

    shear_modulus: Combined shear modulus G [Pa], 1/G = (1/G_lower + 1/G_upper)/2 (2.6).
    poisson_ratio: Combined Poisson's ratio nu [-], nu/G = (nu_lower/G_lower + nu_upper/G_upper)/2 (2.6).
    mismatch: Mismatch kappa [-] (4.3) of the two materials, for kstrip_contact: 0 for like materials; -0.07 for steel (lower) on aluminium, -0.15 on a polymer.
    """

    _structure: ClassVar[str] = "combined_material"
    _units: ClassVar[dict[str, str]] = {'shear_modulus': 'Pa'}

    shear_modulus: float
    poisson_ratio: float
    mismatch: float

    def __init__(self, shear_modulus: float, poisson_ratio: float, mismatch: float) -> None:
        self.shear_modulus = shear_modulus
        self.poisson_ratio = poisson_ratio
        self.mismatch = mismatch


@dataclass(slots=True, init=False, repr=False, eq=False)
class Radii(Value):
    """Radii of curvature of two bodies at the contact [m]: convex positive, flat infinite (INFINITY), concave negative. KSTRIP_ERROR_CURVATURE if one is 0 or NaN, or if the curvatures of both bodies in one plane add up to 0 or less; KSTRIP_WARNING_RADIUS if they are those of radii above 5 m in both planes.

    lower_x: Lower body in the plane of x and z (a straight rail: INFINITY).
    lower_y: Lower body in the plane of y and z (a rail: radius of the head).
    upper_x: Upper body in the plane of x and z (a wheel: rolling radius).
    upper_y: Upper body in the plane of y and z (a wheel: radius of the profile, INFINITY if conical).
    """

    _structure: ClassVar[str] = "radii"
    _units: ClassVar[dict[str, str]] = {'lower_x': 'm', 'lower_y': 'm', 'upper_x': 'm', 'upper_y': 'm'}

    lower_x: float
    lower_y: float
    upper_x: float
    upper_y: float

    def __init__(self, lower_x: float, lower_y: float, upper_x: float, upper_y: float) -> None:
        self.lower_x = lower_x
        self.lower_y = lower_y
        self.upper_x = upper_x
        self.upper_y = upper_y


@dataclass(slots=True, init=False, repr=False, eq=False)
class Contact(Value):
    """A loaded elliptic contact with combined elastic constants and Coulomb friction.

    a: Semi-axis a along the rolling direction x [m], > 0, else KSTRIP_ERROR_SEMI_AXIS.
    b: Semi-axis b along y [m], likewise; KSTRIP_WARNING_SEMI_AXIS if one is above 1 m.
    normal_force: Normal force N [N]. If it is <= 0 the contact is lost, and the other members only need to be finite. KSTRIP_WARNING_PRESSURE if the peak pressure is above a tenth of shear_modulus.
    shear_modulus: Combined shear modulus G [Pa] (2.6), > 0, else KSTRIP_ERROR_MODULUS; above 150 GPa KSTRIP_WARNING_YOUNG, above 10 TPa KSTRIP_WARNING_MODULUS.
    poisson_ratio: Combined Poisson's ratio nu [-], 0 to 0.5, else KSTRIP_ERROR_POISSON_RATIO.
    friction: Friction mu [-], >= 0, else KSTRIP_ERROR_FRICTION; above 5 KSTRIP_WARNING_FRICTION.
    mismatch: Mismatch kappa [-] of the two materials (4.3), from kstrip_material_combine(). It is 0 for similar materials and positive if the lower body is softer. Its sign changes if the bodies are exchanged. In dissimilar bodies pressure makes a longitudinal creepage, so that there is a force without creepage. KSTRIP_WARNING_MISMATCH if its size is above 0.25.
    """

    _structure: ClassVar[str] = "contact"
    _units: ClassVar[dict[str, str]] = {'a': 'm', 'b': 'm', 'normal_force': 'N', 'shear_modulus': 'Pa'}

    a: float
    b: float
    normal_force: float
    shear_modulus: float
    poisson_ratio: float
    friction: float
    mismatch: float

    def __init__(self, a: float, b: float, normal_force: float, shear_modulus: float, poisson_ratio: float, friction: float, mismatch: float) -> None:
        self.a = a
        self.b = b
        self.normal_force = normal_force
        self.shear_modulus = shear_modulus
        self.poisson_ratio = poisson_ratio
        self.friction = friction
        self.mismatch = mismatch


@dataclass(slots=True, init=False, repr=False, eq=False)
class HertzContact(Value):
    """The contact ellipse of Hertz.

    a: Semi-axis along the rolling direction x [m].
    b: Semi-axis along y [m].
    peak_pressure: Pressure at the centre [Pa].
    approach: Approach of distant points of the two bodies [m].
    axis_ratio: Minor divided by major semi-axis [-], 0 to 1 (2.2).
    hertz_angle: Hertz's angle tau [rad], 0 to pi/2 (2.5).
    rho: Four divided by the sum of the four curvatures [m] (2.3).
    """

    _structure: ClassVar[str] = "hertz_contact"
    _units: ClassVar[dict[str, str]] = {'a': 'm', 'b': 'm', 'peak_pressure': 'Pa', 'approach': 'm', 'hertz_angle': 'rad', 'rho': 'm'}

    a: float
    b: float
    peak_pressure: float
    approach: float
    axis_ratio: float
    hertz_angle: float
    rho: float

    def __init__(self, a: float, b: float, peak_pressure: float, approach: float, axis_ratio: float, hertz_angle: float, rho: float) -> None:
        self.a = a
        self.b = b
        self.peak_pressure = peak_pressure
        self.approach = approach
        self.axis_ratio = axis_ratio
        self.hertz_angle = hertz_angle
        self.rho = rho


@dataclass(slots=True, init=False, repr=False, eq=False)
class Velocity(Value):
    """Velocity of one body's material at the centre of the contact, relative to the contact.

    x: Along the rolling direction x [m/s]: about minus the rolling speed for both bodies.
    y: Lateral, along y [m/s].
    angular_z: Angular velocity about the normal z into the lower body [rad/s].
    """

    _structure: ClassVar[str] = "velocity"
    _units: ClassVar[dict[str, str]] = {'x': 'm/s', 'y': 'm/s', 'angular_z': 'rad/s'}

    x: float
    y: float
    angular_z: float

    def __init__(self, x: float, y: float, angular_z: float) -> None:
        self.x = x
        self.y = y
        self.angular_z = angular_z


@dataclass(slots=True, init=False, repr=False, eq=False)
class Creepage(Value):
    """Rigid slip of the upper relative to the lower body, divided by the rolling speed (3.3). KSTRIP_WARNING_CREEPAGE if longitudinal or lateral is above 10 in size; KSTRIP_WARNING_SPIN_UNIT if the spin is larger than bodies that roll on such a contact can have.

    longitudinal: Longitudinal creepage [-], positive when the upper body slides in the rolling direction.
    lateral: Lateral creepage [-], positive along y.
    spin: Spin [1/m], positive from x to y, that is about z into the lower body.
    """

    _structure: ClassVar[str] = "creepage"
    _units: ClassVar[dict[str, str]] = {'spin': '1/m'}

    longitudinal: float
    lateral: float
    spin: float

    def __init__(self, longitudinal: float, lateral: float, spin: float) -> None:
        self.longitudinal = longitudinal
        self.lateral = lateral
        self.spin = spin


@dataclass(slots=True, init=False, repr=False, eq=False)
class Parameters(Value):
    """Kalker's parameters (5.13) of a contact in motion, dimensionless.

    xi: xi = longitudinal G/(2 (1 - nu) mu p0)
    eta: eta = lateral G/(2 mu p0)
    psi: psi = a spin G/(2 mu p0). The theory of 1967 is valid for |psi| < 1.
    """

    _structure: ClassVar[str] = "parameters"
    _units: ClassVar[dict[str, str]] = {}

    xi: float
    eta: float
    psi: float

    def __init__(self, xi: float, eta: float, psi: float) -> None:
        self.xi = xi
        self.eta = eta
        self.psi = psi


@dataclass(slots=True, init=False, repr=False, eq=False)
class Result(Value):
    """Forces on the lower body.

    fx: Longitudinal force [N], positive along the rolling direction.
    fy: Lateral force [N].
    mz: Moment about z at the centre of the contact [N m].
    power: Frictional power divided by rolling speed, fx longitudinal + fy lateral + mz spin [N]: energy dissipated per metre rolled. For dissimilar bodies the creepage that pressure makes is added to the longitudinal one.
    adhesion: Share of the contact area in adhesion [-], 0 to 1. It is -1 with KSTRIP_MODEL_TOTAL, which does not compute it, and 1 with KSTRIP_MODEL_LINEAR, which has adhesion everywhere.
    status_detail: The status of this result: 0 or one of the KSTRIP_WARNING constants.
    """

    _structure: ClassVar[str] = "result"
    _units: ClassVar[dict[str, str]] = {'fx': 'N', 'fy': 'N', 'mz': 'N m', 'power': 'N'}

    fx: float
    fy: float
    mz: float
    power: float
    adhesion: float
    status_detail: int

    def __init__(self, fx: float, fy: float, mz: float, power: float, adhesion: float, status_detail: int) -> None:
        self.fx = fx
        self.fy = fy
        self.mz = mz
        self.power = power
        self.adhesion = adhesion
        self.status_detail = status_detail


@dataclass(slots=True, init=False, repr=False, eq=False)
class Friction(Value):
    """Falling friction: the coefficient is friction ((1 - ratio) exp(-decay w) + ratio), where w is the sliding velocity [m/s]. A layer between the bodies makes the creep curve less steep: slope_factor and slide_factor describe it for a measured or published curve, and layer is an elastic layer that is known. Polach, Wear 258 (2005) 992, gives for locomotives: dry friction 0.55, ratio 0.4, decay 0.6 s/m; wet 0.3, 0.4, 0.2 s/m. KSTRIP_ERROR_MODEL_LEFT_OUT if this build of the library has no laws.

    friction: Coefficient of friction without slip [-], >= 0, else KSTRIP_ERROR_FRICTION.
    ratio: Friction at infinite sliding velocity divided by friction at zero velocity [-], 0 to 1, else KSTRIP_ERROR_FRICTION_RATIO; 1: friction is constant.
    decay: How fast friction falls [s/m], >= 0, else KSTRIP_ERROR_FRICTION_DECAY; 0: it is constant.
    rolling_speed: Rolling speed [m/s], >= 0, else KSTRIP_ERROR_NEGATIVE_SPEED; the sliding velocity is slip times rolling speed. 0: friction is constant.
    slope_factor: Initial slope of the creep curve divided by that of clean bodies [-], 0 to 1, else KSTRIP_ERROR_SLOPE_FACTOR; 0 stands for 1, clean.
    slide_factor: Stretch of the creep curve far in sliding divided by that at its start [-], 0 to 1, else KSTRIP_ERROR_SLIDE_FACTOR; 0 stands for 1: the whole curve is stretched alike.
    layer: Thickness of an elastic layer between the bodies divided by its shear modulus [m/Pa], >= 0, else KSTRIP_ERROR_LAYER; 0: none.
    """

    _structure: ClassVar[str] = "friction"
    _units: ClassVar[dict[str, str]] = {'decay': 's/m', 'rolling_speed': 'm/s', 'layer': 'm/Pa'}

    friction: float
    ratio: float
    decay: float
    rolling_speed: float
    slope_factor: float
    slide_factor: float
    layer: float

    def __init__(self, friction: float, ratio: float, decay: float, rolling_speed: float, slope_factor: float, slide_factor: float, layer: float) -> None:
        self.friction = friction
        self.ratio = ratio
        self.decay = decay
        self.rolling_speed = rolling_speed
        self.slope_factor = slope_factor
        self.slide_factor = slide_factor
        self.layer = layer


@dataclass(slots=True, init=False, repr=False, eq=False)
class Derivatives(Value):
    """Derivatives of fx, fy, mz with respect to creepages, load and friction.

    jacobian: With respect to longitudinal, lateral, spin, row by row [N, N, N m per 1, 1, 1/m]; at kinks of a model a one-sided value.
    normal_force: With respect to the normal force at fixed a and b [-, -, m].
    load_through_hertz: With respect to the normal force while a and b grow with its cube root, as in Hertz's theory [-, -, m].
    friction: With respect to the coefficient of friction (of the law, if given) [N, N, N m].
    """

    _structure: ClassVar[str] = "derivatives"
    _units: ClassVar[dict[str, str]] = {'jacobian': 'N, N, N m per 1, 1, 1/m', 'normal_force': '-, -, m', 'load_through_hertz': '-, -, m', 'friction': 'N, N, N m'}

    jacobian: Array
    normal_force: Array
    load_through_hertz: Array
    friction: Array

    def __init__(self, jacobian: Array, normal_force: Array, load_through_hertz: Array, friction: Array) -> None:
        self.jacobian = jacobian
        self.normal_force = normal_force
        self.load_through_hertz = load_through_hertz
        self.friction = friction


@dataclass(slots=True, init=False, repr=False, eq=False)
class LawDerivatives(Value):
    """Derivatives of fx, fy, mz with respect to the parameters of falling friction.

    ratio: With respect to the ratio [N, N, N m].
    decay: With respect to the decay [N, N, N m per s/m].
    rolling_speed: With respect to the rolling speed of the law at constant creepages [N, N, N m per m/s].
    slope_factor: With respect to the factor of the initial slope, at 1 without a law [N, N, N m].
    slide_factor: With respect to the slide factor [N, N, N m]; 0 where it is 0 in a law without a layer.
    layer: With respect to the layer [N, N, N m per m/Pa]; 0 where there is none.
    """

    _structure: ClassVar[str] = "law_derivatives"
    _units: ClassVar[dict[str, str]] = {'ratio': 'N, N, N m', 'decay': 'N, N, N m per s/m', 'rolling_speed': 'N, N, N m per m/s', 'slope_factor': 'N, N, N m', 'slide_factor': 'N, N, N m', 'layer': 'N, N, N m per m/Pa'}

    ratio: Array
    decay: Array
    rolling_speed: Array
    slope_factor: Array
    slide_factor: Array
    layer: Array

    def __init__(self, ratio: Array, decay: Array, rolling_speed: Array, slope_factor: Array, slide_factor: Array, layer: Array) -> None:
        self.ratio = ratio
        self.decay = decay
        self.rolling_speed = rolling_speed
        self.slope_factor = slope_factor
        self.slide_factor = slide_factor
        self.layer = layer


@dataclass(slots=True, init=False, repr=False, eq=False)
class Strip(Value):
    """One strip y = const of a contact or a patch, and the forces that it carries on the lower body.

    y: Centre line [m].
    width: Width of the strip [m].
    half_length: Half of its length along x [m].
    separatrix: x of the separatrix [m], with slip behind it and adhesion ahead of it; the leading edge if the whole strip slides.
    fx: Its share of the longitudinal force [N].
    fy: Its share of the lateral force [N].
    mz: Its share of the moment about the centre of the contact [N m].
    power: Its share of the frictional power [N].
    state: KSTRIP_STATE_STICK if it has an adhesion area, else KSTRIP_STATE_SLIP.
    """

    _structure: ClassVar[str] = "strip"
    _units: ClassVar[dict[str, str]] = {'y': 'm', 'width': 'm', 'half_length': 'm', 'separatrix': 'm', 'fx': 'N', 'fy': 'N', 'mz': 'N m', 'power': 'N'}

    y: float
    width: float
    half_length: float
    separatrix: float
    fx: float
    fy: float
    mz: float
    power: float
    state: int

    def __init__(self, y: float, width: float, half_length: float, separatrix: float, fx: float, fy: float, mz: float, power: float, state: int) -> None:
        self.y = y
        self.width = width
        self.half_length = half_length
        self.separatrix = separatrix
        self.fx = fx
        self.fy = fy
        self.mz = mz
        self.power = power
        self.state = state


@dataclass(slots=True, init=False, repr=False, eq=False)
class Motion(Value):
    """Motion of the upper body relative to the lower one at the contact, in axes that stay when the motion reverses.

    slip_x: Velocity of the upper relative to the lower body along x [m/s].
    slip_y: Velocity of the upper relative to the lower body along y [m/s].
    spin_rate: Angular velocity of the upper relative to the lower body about z [rad/s].
    rolling_speed: Rolling speed [m/s]: positive along x, negative backward, zero at standstill.
    floor_speed: Floor of the speed [m/s], >= 0, else KSTRIP_ERROR_FLOOR_SPEED; 0 stands for 0.02. Creepages are slip divided by sqrt(rolling_speed^2 + floor_speed^2).
    """

    _structure: ClassVar[str] = "motion"
    _units: ClassVar[dict[str, str]] = {'slip_x': 'm/s', 'slip_y': 'm/s', 'spin_rate': 'rad/s', 'rolling_speed': 'm/s', 'floor_speed': 'm/s'}

    slip_x: float
    slip_y: float
    spin_rate: float
    rolling_speed: float
    floor_speed: float

    def __init__(self, slip_x: float, slip_y: float, spin_rate: float, rolling_speed: float, floor_speed: float) -> None:
        self.slip_x = slip_x
        self.slip_y = slip_y
        self.spin_rate = spin_rate
        self.rolling_speed = rolling_speed
        self.floor_speed = floor_speed


@dataclass(slots=True, init=False, repr=False, eq=False)
class MotionDerivatives(Value):
    """Derivatives of fx, fy, mz with respect to motion, load and friction.

    slip: With respect to slip_x, slip_y, spin_rate, row by row [N, N, N m per m/s, m/s, rad/s].
    rolling_speed: With respect to the rolling speed at constant slip and spin rate [N, N, N m per m/s].
    normal_force: With respect to the normal force at fixed a and b [-, -, m].
    load_through_hertz: With respect to the normal force while a and b grow with its cube root [-, -, m].
    friction: With respect to the coefficient of friction (of the law, if given) [N, N, N m].
    ratio: With respect to the ratio of the law; 0 without one [N, N, N m].
    decay: With respect to the decay of the law; 0 without one [N, N, N m per s/m].
    slope_factor: With respect to the slope factor of the law, at 1 without one [N, N, N m].
    slide_factor: With respect to the slide factor; 0 if it is 0 in a law without a layer [N, N, N m].
    layer: With respect to the layer of the law; 0 where there is none [N, N, N m per m/Pa].
    """

    _structure: ClassVar[str] = "motion_derivatives"
    _units: ClassVar[dict[str, str]] = {'slip': 'N, N, N m per m/s, m/s, rad/s', 'rolling_speed': 'N, N, N m per m/s', 'normal_force': '-, -, m', 'load_through_hertz': '-, -, m', 'friction': 'N, N, N m', 'ratio': 'N, N, N m', 'decay': 'N, N, N m per s/m', 'slope_factor': 'N, N, N m', 'slide_factor': 'N, N, N m', 'layer': 'N, N, N m per m/Pa'}

    slip: Array
    rolling_speed: Array
    normal_force: Array
    load_through_hertz: Array
    friction: Array
    ratio: Array
    decay: Array
    slope_factor: Array
    slide_factor: Array
    layer: Array

    def __init__(self, slip: Array, rolling_speed: Array, normal_force: Array, load_through_hertz: Array, friction: Array, ratio: Array, decay: Array, slope_factor: Array, slide_factor: Array, layer: Array) -> None:
        self.slip = slip
        self.rolling_speed = rolling_speed
        self.normal_force = normal_force
        self.load_through_hertz = load_through_hertz
        self.friction = friction
        self.ratio = ratio
        self.decay = decay
        self.slope_factor = slope_factor
        self.slide_factor = slide_factor
        self.layer = layer


@dataclass(slots=True, init=False, repr=False, eq=False)
class Point(Value):
    """The state of a point of the contact plane. Tractions act on the lower body.

    pressure: Pressure [Pa].
    traction_x: Tangential traction along x [Pa].
    traction_y: Tangential traction along y [Pa].
    slip_x: Slip of the upper relative to the lower body along x, divided by the rolling speed [-].
    slip_y: Slip along y, divided by the rolling speed [-].
    dissipation: Traction times slip [Pa]: energy dissipated per area and metre rolled.
    state: One of the KSTRIP_STATE constants.
    """

    _structure: ClassVar[str] = "point"
    _units: ClassVar[dict[str, str]] = {'pressure': 'Pa', 'traction_x': 'Pa', 'traction_y': 'Pa', 'dissipation': 'Pa'}

    pressure: float
    traction_x: float
    traction_y: float
    slip_x: float
    slip_y: float
    dissipation: float
    state: int

    def __init__(self, pressure: float, traction_x: float, traction_y: float, slip_x: float, slip_y: float, dissipation: float, state: int) -> None:
        self.pressure = pressure
        self.traction_x = traction_x
        self.traction_y = traction_y
        self.slip_x = slip_x
        self.slip_y = slip_y
        self.dissipation = dissipation
        self.state = state


@dataclass(slots=True, init=False, repr=False, eq=False)
class PatchStrip(Value):
    """One strip of a patch, along the rolling direction. Its pressure is a half-ellipse in x, peak_pressure sqrt(1 - (x - centre_x)^2/half_length^2), and does not vary over its width.

    y: Centre line y [m].
    width: Width [m], > 0, else KSTRIP_ERROR_STRIP_SIZE.
    half_length: Half length along x [m], > 0, else KSTRIP_ERROR_STRIP_SIZE.
    centre_x: Centre along x [m]; 0 for most contacts.
    peak_pressure: Pressure at the centre [Pa], >= 0, else KSTRIP_ERROR_PRESSURE.
    friction: Coefficient of friction [-] of this strip, >= 0, else KSTRIP_ERROR_FRICTION.
    """

    _structure: ClassVar[str] = "patch_strip"
    _units: ClassVar[dict[str, str]] = {'y': 'm', 'width': 'm', 'half_length': 'm', 'centre_x': 'm', 'peak_pressure': 'Pa'}

    y: float
    width: float
    half_length: float
    centre_x: float
    peak_pressure: float
    friction: float

    def __init__(self, y: float, width: float, half_length: float, centre_x: float, peak_pressure: float, friction: float) -> None:
        self.y = y
        self.width = width
        self.half_length = half_length
        self.centre_x = centre_x
        self.peak_pressure = peak_pressure
        self.friction = friction


@dataclass(slots=True, init=False, repr=False, eq=False)
class Patch(Value):
    """A contact patch of any shape: its strips, in ascending y. Filled by kstrip_patch_from_contact(), kstrip_patch_from_strips() or kstrip_patch_from_profile(); the members may then be changed. All functions check it again. A patch whose members are all zero, except shear_modulus, carries no load. If the distance of two neighbours is more than one and a half times the distance at which they touch, there is a gap, and the strips on either side are separate contact regions (lobes).

    strips: The strips; the first count are used. KSTRIP_ERROR_STRIP_ORDER if their y do not ascend, or if they overlap by more than half of the distance at which they touch.
    shear_modulus: Combined shear modulus G [Pa], > 0, else KSTRIP_ERROR_MODULUS.
    poisson_ratio: Combined Poisson's ratio [-], 0 to 0.5, else KSTRIP_ERROR_POISSON_RATIO.
    area_scale: Factor [-], > 0, else KSTRIP_ERROR_NOT_FINITE, that makes the sum of the strips' areas the patch's area: 1 unless the strips are the quadrature rule of kstrip_patch_from_contact(); 0 stands for 1. KSTRIP_ERROR_OVERFLOW if it is outside 1e-6 to 1e6.
    lever_scale: The same for the moment of the area about x, the sum of y^2 times area.
    count: Number of strips, 0 to KSTRIP_PATCH_CAPACITY, else KSTRIP_ERROR_PATCH_SIZE. None: no load.
    mismatch: Mismatch kappa [-] of the two materials, as in kstrip_contact: KSTRIP_WARNING_MISMATCH if its size is above 0.25. Only kstrip_patch_from_contact() sets it; the caller may set it.
    """

    _structure: ClassVar[str] = "patch"
    _units: ClassVar[dict[str, str]] = {'shear_modulus': 'Pa'}

    strips: Batch[PatchStrip]
    shear_modulus: float
    poisson_ratio: float
    area_scale: float
    lever_scale: float
    count: int
    mismatch: float

    def __init__(self, strips: Batch[PatchStrip], shear_modulus: float, poisson_ratio: float, area_scale: float, lever_scale: float, count: int, mismatch: float) -> None:
        self.strips = strips
        self.shear_modulus = shear_modulus
        self.poisson_ratio = poisson_ratio
        self.area_scale = area_scale
        self.lever_scale = lever_scale
        self.count = count
        self.mismatch = mismatch


@dataclass(slots=True, init=False, repr=False, eq=False)
class ProfileResult(Value):
    """Approach, load and pressure of two profiles in contact.

    approach: Approach of distant points of the two bodies [m] from where they touch: at the lowest point of the smoothed profile.
    normal_force: Normal force of the strips [N]. If a load is given, it is that load to rounding.
    stiffness: Derivative of the normal force with respect to the approach [N/m].
    peak_pressure: Largest pressure of a strip [Pa].
    peak_y: y of the strip with the largest pressure [m].
    iterations: Sum of the steps of the two searches for the approach, at most 60 for each search. It is 0 if the approach is given.
    status_detail: The status of this result: 0, or KSTRIP_WARNING_PROFILE_END if a contact region ends with the profile.
    lowest: Distance at that lowest point [m], or of the given points without contact: the bodies have moved by approach + lowest.
    """

    _structure: ClassVar[str] = "profile_result"
    _units: ClassVar[dict[str, str]] = {'approach': 'm', 'normal_force': 'N', 'stiffness': 'N/m', 'peak_pressure': 'Pa', 'peak_y': 'm', 'lowest': 'm'}

    approach: float
    normal_force: float
    stiffness: float
    peak_pressure: float
    peak_y: float
    iterations: int
    status_detail: int
    lowest: float

    def __init__(self, approach: float, normal_force: float, stiffness: float, peak_pressure: float, peak_y: float, iterations: int, status_detail: int, lowest: float) -> None:
        self.approach = approach
        self.normal_force = normal_force
        self.stiffness = stiffness
        self.peak_pressure = peak_pressure
        self.peak_y = peak_y
        self.iterations = iterations
        self.status_detail = status_detail
        self.lowest = lowest


@dataclass(slots=True, init=False, repr=False, eq=False)
class PatchSummary(Value):
    """Load, friction bound and area of a patch.

    normal_force: Normal force [N].
    friction_bound: Sum of friction times load over the strips [N]: no tangential force exceeds it.
    area: Contact area [m^2].
    lobes: Number of contact regions.
    """

    _structure: ClassVar[str] = "patch_summary"
    _units: ClassVar[dict[str, str]] = {'normal_force': 'N', 'friction_bound': 'N', 'area': 'm^2'}

    normal_force: float
    friction_bound: float
    area: float
    lobes: int

    def __init__(self, normal_force: float, friction_bound: float, area: float, lobes: int) -> None:
        self.normal_force = normal_force
        self.friction_bound = friction_bound
        self.area = area
        self.lobes = lobes


@dataclass(slots=True, init=False, repr=False, eq=False)
class WheelPosition(Value):
    """Position of the wheel on straight track. The flange of a right wheel touches the gauge side of the rail, which is at small y.

    lateral: y of the wheel's centre from the origin of the rail's profile [m], to the right. The centre is the point of the axle at y = 0 of the wheel's profile.
    vertical: Zero when the centre is one wheel radius above the rail's origin; positive downward [m].
    yaw: Turn about the vertical, which points down [rad]: positive from x to y, between -1 and 1, else KSTRIP_ERROR_ANGLE.
    roll: Turn about x [rad]: positive from y to z, between -1 and 1, else KSTRIP_ERROR_ANGLE. Yaw turns about the axis that roll has turned.
    """

    _structure: ClassVar[str] = "wheel_position"
    _units: ClassVar[dict[str, str]] = {'lateral': 'm', 'vertical': 'm', 'yaw': 'rad', 'roll': 'rad'}

    lateral: float
    vertical: float
    yaw: float
    roll: float

    def __init__(self, lateral: float, vertical: float, yaw: float, roll: float) -> None:
        self.lateral = lateral
        self.vertical = vertical
        self.yaw = yaw
        self.roll = roll


@dataclass(slots=True, init=False, repr=False, eq=False)
class WheelPair(FrictionPlaces):
    """Materials and friction of a wheel and a rail, and options of the computation. Zero is the default of every member but wheel_radius and shear_modulus.

    wheel_radius: Radius of the wheel at z = 0 of its profile [m], > 0, else KSTRIP_ERROR_ROLLING_RADIUS.
    shear_modulus: Combined shear modulus G [Pa], > 0, else KSTRIP_ERROR_MODULUS.
    poisson_ratio: Combined Poisson's ratio [-], 0 to 0.5, else KSTRIP_ERROR_POISSON_RATIO.
    friction: Coefficient of friction [-], >= 0, else KSTRIP_ERROR_FRICTION; if friction_points is 0.
    friction_y: Places on the rail, y of its profile [m], ascending, else KSTRIP_ERROR_PROFILE.
    friction_at: Coefficients there [-], as friction; linear between the places, constant beyond.
    friction_points: How many of these places there are, at most KSTRIP_RAIL_FRICTION_CAPACITY, else KSTRIP_ERROR_CAPACITY; 0: friction is the same everywhere.
    left: 0: a right wheel; any other number: a left wheel. The profiles are always those of a right wheel; position, velocity and wrench are the wheel's own.
    smoothing_length: Length over which the undeformed gap is smoothed [m], >= 0, else KSTRIP_ERROR_SMOOTHING_LENGTH. It is always at least 2.5 steps of the wheel's profile. For rough profiles set it to 2 mm.
    strips: Strips of a contact, about: 4, 8, 16, 32 or 64, else KSTRIP_ERROR_STRIP_COUNT; 0: 16.
    model: KSTRIP_MODEL_STRIP (the default here), KSTRIP_MODEL_TOTAL or one of the models of 1967.
    normal_damping: Damping d [s/m], >= 0, else KSTRIP_ERROR_NORMAL_DAMPING (Hunt and Crossley): the pressure is multiplied by 1 + d times the velocity at which the surfaces approach each other, or by 0 if this factor is negative; the bound of friction changes with it.
    floor_speed: Floor of the speed [m/s], as in kstrip_motion; 0 stands for 0.02, and a negative one is KSTRIP_ERROR_FLOOR_SPEED.
    rail_radius: Radius of the rail at z = 0 of its profile [m], >= 0, else KSTRIP_ERROR_ROLLING_RADIUS: of a roller rig or of the lower of two discs, whose axis is along y; 0: a straight rail.
    rail_ahead: x of the roller's axis from the wheel's centre [m]; not used for a straight rail.
    rail_speed: Speed at which the surface of the rail moves backward under the wheel [m/s], that of a roller at rail_radius: a wheel whose centre is at rest rolls on it like a wheel that moves forward on a rail at rest.
    """

    _structure: ClassVar[str] = "wheel_pair"
    _units: ClassVar[dict[str, str]] = {'wheel_radius': 'm', 'shear_modulus': 'Pa', 'friction_y': 'm', 'smoothing_length': 'm', 'normal_damping': 's/m', 'floor_speed': 'm/s', 'rail_radius': 'm', 'rail_ahead': 'm', 'rail_speed': 'm/s'}

    wheel_radius: float
    shear_modulus: float
    poisson_ratio: float
    friction: float
    friction_y: Array
    friction_at: Array
    friction_points: int
    left: int
    smoothing_length: float
    strips: int
    model: int
    normal_damping: float
    floor_speed: float
    rail_radius: float
    rail_ahead: float
    rail_speed: float

    def __init__(self, wheel_radius: float, shear_modulus: float, poisson_ratio: float, friction: float, friction_y: Array, friction_at: Array, friction_points: int, left: int, smoothing_length: float, strips: int, model: int, normal_damping: float, floor_speed: float, rail_radius: float, rail_ahead: float, rail_speed: float) -> None:
        self.wheel_radius = wheel_radius
        self.shear_modulus = shear_modulus
        self.poisson_ratio = poisson_ratio
        self.friction = friction
        self.friction_y = friction_y
        self.friction_at = friction_at
        self.friction_points = friction_points
        self.left = left
        self.smoothing_length = smoothing_length
        self.strips = strips
        self.model = model
        self.normal_damping = normal_damping
        self.floor_speed = floor_speed
        self.rail_radius = rail_radius
        self.rail_ahead = rail_ahead
        self.rail_speed = rail_speed


@dataclass(slots=True, init=False, repr=False, eq=False)
class WheelContact(Value):
    """One contact of a wheel. Its frame (x, t, n): forward, across the surface, into the rail.

    origin: Point where the pressure acts, on the wheel's undeformed surface, from the wheel's centre [m], axes of the track.
    angle: Angle of the contact plane [rad]: mean of the strips' angles, weighted with load. For a left wheel it is that of the mirrored right wheel.
    angle_range: Range of the angle over the patch [rad]; above 0.52 KSTRIP_WARNING_ANGLE_RANGE.
    radius: Distance of the origin from the axle [m].
    normal_force: Load of the strips [N], >= 0, else KSTRIP_ERROR_NORMAL_FORCE.
    share: Factor of load and forces in the sum over the contacts [-], >= 0, else KSTRIP_ERROR_SHARE: 1, except for contacts 5 to 7 mm apart, whose result blends separate contacts with a merged one.
    approach: Overlap of the undeformed, smoothed surfaces where it is deepest [m].
    stiffness: Derivative of the load with respect to the distance by which the surfaces are moved into each other [N/m].
    along: Length on the rail at y = 0 of the patch [m].
    normal: Derivatives of the wheel's velocity into the rail, mean of the strips weighted with load, with respect to the members of kstrip_wheel_velocity. The wrench of the pressure on the wheel is minus share times normal_force times these six numbers, and times the factor of the damping.
    slip_x: slip_x of kstrip_motion at the patch's origin: derivatives with respect to the members of kstrip_wheel_velocity.
    slip_y: slip_y of kstrip_motion.
    spin_rate: spin_rate of kstrip_motion.
    rolling_speed: rolling_speed of kstrip_motion.
    normal_damping: normal_damping of kstrip_wheel_pair; a negative one is KSTRIP_ERROR_NORMAL_DAMPING.
    at_rest: kstrip_motion of a wheel at rest: that of the rail's surface, mean of the strips weighted with load, with the floor of the speed; a negative floor is KSTRIP_ERROR_FLOOR_SPEED.
    patch: The strips; y along the rail's surface, x forward from the origin.
    rail_axis: x and z of a roller's axis from the wheel's centre [m]; 0 and 0 for a straight rail.
    rail_rate: Rate of a roller about its axis [rad/s]: rail_speed/rail_radius; 0: a straight rail.
    strip_rail_speed: Speed of the rail's surface at each strip, backward [m/s]: rail_speed; on a roller rail_rate times the radius of the roller's undeformed surface there.
    strip_y: y of each strip on the wheel's undeformed surface, from the wheel's centre [m], axes of the track; of a left wheel that of the mirrored right wheel.
    strip_z: z of each strip [m].
    strip_angle: Angle of each strip [rad], as the angle of the contact: the mean of those of both undeformed surfaces.
    strip_lean: Tangent of half the angle between the undeformed surfaces at each strip: the angle of the wheel's is less than strip_angle by the arc tangent of this, that of the rail's is more.
    turned: Roll and yaw of the wheel [rad]; of a left wheel those of the mirrored right wheel.
    left: Whether the wheel is a left one, as in kstrip_wheel_pair.
    """

    _structure: ClassVar[str] = "wheel_contact"
    _units: ClassVar[dict[str, str]] = {'origin': 'm', 'angle': 'rad', 'angle_range': 'rad', 'radius': 'm', 'normal_force': 'N', 'approach': 'm', 'stiffness': 'N/m', 'along': 'm', 'rail_axis': 'm', 'rail_rate': 'rad/s', 'strip_rail_speed': 'm/s', 'strip_y': 'm', 'strip_z': 'm', 'strip_angle': 'rad', 'turned': 'rad'}

    origin: Array
    angle: float
    angle_range: float
    radius: float
    normal_force: float
    share: float
    approach: float
    stiffness: float
    along: float
    normal: Array
    slip_x: Array
    slip_y: Array
    spin_rate: Array
    rolling_speed: Array
    normal_damping: float
    at_rest: Motion
    patch: Patch
    rail_axis: Array
    rail_rate: float
    strip_rail_speed: Array
    strip_y: Array
    strip_z: Array
    strip_angle: Array
    strip_lean: Array
    turned: Array
    left: int

    def __init__(self, origin: Array, angle: float, angle_range: float, radius: float, normal_force: float, share: float, approach: float, stiffness: float, along: float, normal: Array, slip_x: Array, slip_y: Array, spin_rate: Array, rolling_speed: Array, normal_damping: float, at_rest: Motion, patch: Patch, rail_axis: Array, rail_rate: float, strip_rail_speed: Array, strip_y: Array, strip_z: Array, strip_angle: Array, strip_lean: Array, turned: Array, left: int) -> None:
        self.origin = origin
        self.angle = angle
        self.angle_range = angle_range
        self.radius = radius
        self.normal_force = normal_force
        self.share = share
        self.approach = approach
        self.stiffness = stiffness
        self.along = along
        self.normal = normal
        self.slip_x = slip_x
        self.slip_y = slip_y
        self.spin_rate = spin_rate
        self.rolling_speed = rolling_speed
        self.normal_damping = normal_damping
        self.at_rest = at_rest
        self.patch = patch
        self.rail_axis = rail_axis
        self.rail_rate = rail_rate
        self.strip_rail_speed = strip_rail_speed
        self.strip_y = strip_y
        self.strip_z = strip_z
        self.strip_angle = strip_angle
        self.strip_lean = strip_lean
        self.turned = turned
        self.left = left


@dataclass(slots=True, init=False, repr=False, eq=False)
class WheelVelocity(Value):
    """Velocity of the wheel relative to the rail. The axes are at rest; in a curve they are those of the momentary track. Lateral, roll and yaw have the track's signs for a left wheel too.

    forward: Velocity of the wheel's centre along x [m/s].
    lateral: Velocity of the centre along y [m/s].
    vertical: Velocity of the centre along z, down [m/s].
    roll: Rate about the wheelset's own x [rad/s]; these axes do not spin with the axle.
    pitch: Rate about the axle [rad/s]: about minus forward divided by radius.
    yaw: Rate about the wheelset's own z [rad/s].
    """

    _structure: ClassVar[str] = "wheel_velocity"
    _units: ClassVar[dict[str, str]] = {'forward': 'm/s', 'lateral': 'm/s', 'vertical': 'm/s', 'roll': 'rad/s', 'pitch': 'rad/s', 'yaw': 'rad/s'}

    forward: float
    lateral: float
    vertical: float
    roll: float
    pitch: float
    yaw: float

    def __init__(self, forward: float, lateral: float, vertical: float, roll: float, pitch: float, yaw: float) -> None:
        self.forward = forward
        self.lateral = lateral
        self.vertical = vertical
        self.roll = roll
        self.pitch = pitch
        self.yaw = yaw


@dataclass(slots=True, init=False, repr=False, eq=False)
class Wrench(Value):
    """Force and moment on a wheel. They are conjugate to the members of kstrip_wheel_velocity: the products add up to power.

    force: Force on the wheel, axes of the track [N]: forward, lateral, vertical (down; the rail's support is negative).
    moment: Moment on the wheel about its centre [N m] about the wheelset's own axes: roll, pitch (about the axle), yaw.
    dissipation: Frictional power [W], not negative: creep forces on the rail times slip. The power of the creep forces on the wheel is minus this. Only in contacts with a mismatch of the materials it differs, because pressure adds to the slip.
    normal_force: Sum of the loads of all contacts [N], each along its own normal: share times normal_force of kstrip_wheel_contact, times the factor of the damping.
    contacts: Number of contacts, those that kstrip_wheel_workspace lists; of a wheelset those of both wheels. 0: the wheel is lifted, and nothing acts.
    status_detail: The status of this result: 0 or one of the KSTRIP_WARNING constants.
    """

    _structure: ClassVar[str] = "wrench"
    _units: ClassVar[dict[str, str]] = {'force': 'N', 'moment': 'N m', 'dissipation': 'W', 'normal_force': 'N'}

    force: Array
    moment: Array
    dissipation: float
    normal_force: float
    contacts: int
    status_detail: int

    def __init__(self, force: Array, moment: Array, dissipation: float, normal_force: float, contacts: int, status_detail: int) -> None:
        self.force = force
        self.moment = moment
        self.dissipation = dissipation
        self.normal_force = normal_force
        self.contacts = contacts
        self.status_detail = status_detail


@dataclass(slots=True, init=False, repr=False, eq=False)
class WrenchDerivatives(Value):
    """Exact derivatives of the wrench. The rows are the members of force and moment.

    velocity: With respect to the members of kstrip_wheel_velocity [N, N m per m/s, rad/s].
    friction: With respect to a factor on all coefficients of friction, at 1 [N, N m].
    """

    _structure: ClassVar[str] = "wrench_derivatives"
    _units: ClassVar[dict[str, str]] = {'velocity': 'N, N m per m/s, rad/s', 'friction': 'N, N m'}

    velocity: Array
    friction: Array

    def __init__(self, velocity: Array, friction: Array) -> None:
        self.velocity = velocity
        self.friction = friction


@dataclass(slots=True, init=False, repr=False, eq=False)
class StripPower(Value):
    """One strip of a contact of a wheel: its load, and the power that friction dissipates in it.

    wheel_y: y on the wheel's profile [m], in the axes of the profile.
    width: Width along the surface [m].
    normal_force: Load [N], with the share of the contact and the factor of the damping.
    fx: Longitudinal force on the rail [N], with the share of the contact.
    fy: Force on the rail along its surface across the rolling direction [N], with the share of the contact; of a left wheel that of the mirrored right wheel.
    slip: Mean sliding velocity [m/s]: power divided by the coefficient of friction and the load, and below zero together with it.
    power: Frictional power [W], with the share of the contact. That of a strip that hardly slides may be a little below zero: -0.06 % of the power of the wheel if it rolls, -0.4 % if it stands.
    """

    _structure: ClassVar[str] = "strip_power"
    _units: ClassVar[dict[str, str]] = {'wheel_y': 'm', 'width': 'm', 'normal_force': 'N', 'fx': 'N', 'fy': 'N', 'slip': 'm/s', 'power': 'W'}

    wheel_y: float
    width: float
    normal_force: float
    fx: float
    fy: float
    slip: float
    power: float

    def __init__(self, wheel_y: float, width: float, normal_force: float, fx: float, fy: float, slip: float, power: float) -> None:
        self.wheel_y = wheel_y
        self.width = width
        self.normal_force = normal_force
        self.fx = fx
        self.fy = fy
        self.slip = slip
        self.power = power


@dataclass(slots=True, init=False, repr=False, eq=False)
class WrenchByPosition(Value):
    """Derivatives of the wrench with respect to the wheel's position at constant velocity.

    lateral: With respect to the lateral position [N, N m per m].
    vertical: With respect to the vertical position [N, N m per m].
    yaw: With respect to yaw [N, N m per rad].
    roll: With respect to roll [N, N m per rad].
    """

    _structure: ClassVar[str] = "wrench_by_position"
    _units: ClassVar[dict[str, str]] = {'lateral': 'N, N m per m', 'vertical': 'N, N m per m', 'yaw': 'N, N m per rad', 'roll': 'N, N m per rad'}

    lateral: Array
    vertical: Array
    yaw: Array
    roll: Array

    def __init__(self, lateral: Array, vertical: Array, yaw: Array, roll: Array) -> None:
        self.lateral = lateral
        self.vertical = vertical
        self.yaw = yaw
        self.roll = roll


@dataclass(slots=True, init=False, repr=False, eq=False)
class Curve(Value):
    """A curve that a vehicle runs through: the axes of the track move forward and turn with it.

    speed: Speed along the middle of the track, at the height of the wheelset's centre [m/s].
    curvature: One divided by the radius of the curve [1/m]: positive to the right, 0: straight. KSTRIP_WARNING_CURVATURE if its size is above 0.2.
    cant: Angle of cant [rad]: positive where the right rail is lower, between -1 and 1, else KSTRIP_ERROR_ANGLE. In a curve to the right it is positive.
    gravity: Acceleration of gravity [m/s^2]; 0: 9.80665.
    """

    _structure: ClassVar[str] = "curve"
    _units: ClassVar[dict[str, str]] = {'speed': 'm/s', 'curvature': '1/m', 'cant': 'rad', 'gravity': 'm/s^2'}

    speed: float
    curvature: float
    cant: float
    gravity: float

    def __init__(self, speed: float, curvature: float, cant: float, gravity: float) -> None:
        self.speed = speed
        self.curvature = curvature
        self.cant = cant
        self.gravity = gravity


@dataclass(slots=True, init=False, repr=False, eq=False)
class RailMotion(Value):
    """Displacement and velocity of a rail: irregularities of the track, or the motion of a flexible rail. Axes of the track.

    lateral: Displacement to the right [m].
    vertical: Displacement downward [m].
    lateral_velocity: Velocity to the right [m/s].
    vertical_velocity: Velocity downward [m/s].
    """

    _structure: ClassVar[str] = "rail_motion"
    _units: ClassVar[dict[str, str]] = {'lateral': 'm', 'vertical': 'm', 'lateral_velocity': 'm/s', 'vertical_velocity': 'm/s'}

    lateral: float
    vertical: float
    lateral_velocity: float
    vertical_velocity: float

    def __init__(self, lateral: float, vertical: float, lateral_velocity: float, vertical_velocity: float) -> None:
        self.lateral = lateral
        self.vertical = vertical
        self.lateral_velocity = lateral_velocity
        self.vertical_velocity = vertical_velocity


@dataclass(slots=True, init=False, repr=False, eq=False)
class WheelsetForces(Value):
    """Forces on a wheelset, on each wheel, and on each rail.

    wrench: Force on the wheelset [N], axes of the track, and moment about its centre [N m], its own axes; sums of dissipation, loads, contacts.
    wheel: Force and moment on the right and on the left wheel, about the wheel's centre.
    rail: Force on the right and on the left rail [N], axes of the track: forward, lateral (Y, to the right), vertical (Q, down).
    """

    _structure: ClassVar[str] = "wheelset_forces"
    _units: ClassVar[dict[str, str]] = {'rail': 'N'}

    wrench: Wrench
    wheel: Batch[Wrench]
    rail: Array

    def __init__(self, wrench: Wrench, wheel: Batch[Wrench], rail: Array) -> None:
        self.wrench = wrench
        self.wheel = wheel
        self.rail = rail


@dataclass(slots=True, init=False, repr=False, eq=False)
class WheelsetDerivatives(Value):
    """Exact derivatives of the forces on a wheelset and its two rails with respect to the velocities. Rows are the ten forces: force and moment on the wheelset, then lateral and vertical force on the right rail and on the left rail. Columns are the ten degrees of freedom (KSTRIP_WHEELSET_FREEDOMS).

    velocity: With respect to the velocities [N, N m per m/s, rad/s].
    friction: With respect to a factor on all coefficients of friction, at 1 [N, N m].
    """

    _structure: ClassVar[str] = "wheelset_derivatives"
    _units: ClassVar[dict[str, str]] = {'velocity': 'N, N m per m/s, rad/s', 'friction': 'N, N m'}

    velocity: Array
    friction: Array

    def __init__(self, velocity: Array, friction: Array) -> None:
        self.velocity = velocity
        self.friction = friction


@dataclass(slots=True, init=False, repr=False, eq=False)
class WheelsetByPosition(Value):
    """Derivatives of the same ten forces with respect to the positions of the ten degrees of freedom, at constant velocities.

    position: With respect to the positions [N, N m per m, rad]; forward and pitch columns are zero.
    """

    _structure: ClassVar[str] = "wheelset_by_position"
    _units: ClassVar[dict[str, str]] = {'position': 'N, N m per m, rad'}

    position: Array

    def __init__(self, position: Array) -> None:
        self.position = position


@dataclass(slots=True, init=False, repr=False, eq=False)
class FrictionEstimate(Value):
    """A coefficient of friction from a measured force.

    friction: Coefficient of friction [-]; a lower bound with KSTRIP_WARNING_FRICTION_AT_LEAST.
    sensitivity: d(friction)/d(force) [1/N]: change of the coefficient for an error of 1 N in the measured force; 0 for a lower bound.
    residual: Distance between the measured and the computed force [N] in the components that were measured. For one component it is rounding; for both it is the part that friction cannot explain, because the directions of the forces differ.
    status_detail: The status of this result: 0 or one of the KSTRIP_WARNING constants.
    """

    _structure: ClassVar[str] = "friction_estimate"
    _units: ClassVar[dict[str, str]] = {'sensitivity': '1/N', 'residual': 'N'}

    friction: float
    sensitivity: float
    residual: float
    status_detail: int

    def __init__(self, friction: float, sensitivity: float, residual: float, status_detail: int) -> None:
        self.friction = friction
        self.sensitivity = sensitivity
        self.residual = residual
        self.status_detail = status_detail


@dataclass(slots=True, init=False, repr=False, eq=False)
class FrictionFit(Value):
    """A law of friction that was fitted to measured points.

    law: The law.
    standard_errors: Standard errors of its members, from the remaining differences between points and law; 0 for a member that was not fitted or that ended at a bound.
    residual: Root of the weighted mean square difference between measured and computed forces [N].
    steps: Largest number of times that all forces were computed from one start.
    status_detail: The status of this result: 0 or one of the KSTRIP_WARNING constants.
    """

    _structure: ClassVar[str] = "friction_fit"
    _units: ClassVar[dict[str, str]] = {'residual': 'N'}

    law: Friction
    standard_errors: Friction
    residual: float
    steps: int
    status_detail: int

    def __init__(self, law: Friction, standard_errors: Friction, residual: float, steps: int, status_detail: int) -> None:
        self.law = law
        self.standard_errors = standard_errors
        self.residual = residual
        self.steps = steps
        self.status_detail = status_detail


#: The class of each structure by its name
classes: dict[str, type[Value]] = {
    kind._structure: kind for kind in (
        Material,
        CombinedMaterial,
        Radii,
        Contact,
        HertzContact,
        Velocity,
        Creepage,
        Parameters,
        Result,
        Friction,
        Derivatives,
        LawDerivatives,
        Strip,
        Motion,
        MotionDerivatives,
        Point,
        PatchStrip,
        Patch,
        ProfileResult,
        PatchSummary,
        WheelPosition,
        WheelPair,
        WheelContact,
        WheelVelocity,
        Wrench,
        WrenchDerivatives,
        StripPower,
        WrenchByPosition,
        Curve,
        RailMotion,
        WheelsetForces,
        WheelsetDerivatives,
        WheelsetByPosition,
        FrictionEstimate,
        FrictionFit,
    )
}
