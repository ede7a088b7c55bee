"""The bogie of c_examples/12_bogie.c in Exudyn: two wheelsets on flexible rails, a frame, half a car body.

    make && pip install -r hosts/exudyn/requirements.txt && PYTHONPATH=bindings/python python hosts/exudyn/bogie.py

Each wheelset with its rails is a node of ten coordinates, in the order of kstrip. One object has the masses, springs and dampers of the
whole bogie; the object of each wheelset has the forces of the wheels as its user function, and their derivatives as its Jacobian, so that
Exudyn's implicit solver takes steps of 1 ms. The program checks itself: at 80 m/s the bogie hunts in the limit cycle that the one in C
has, and at 20 m/s it comes to rest.
"""

import pathlib
import warnings

import exudyn
import kstrip
import numpy as np
from exudyn.itemInterface import NodeGenericODE2, ObjectGenericODE2, SensorNode

DATA = pathlib.Path(__file__).resolve().parents[2] / "tests" / "data" / "wheel_rail"
FORWARD, LATERAL, VERTICAL, ROLL, PITCH, YAW = range(6)
SET = 10  # freedoms of a wheelset with its rails: six, then lateral and vertical of the right and of the left rail
FRAME, CAR, COUNT = 2 * SET, 2 * SET + 6, 2 * SET + 10
WHEELBASE, BOX = 2.5, 1.0  # m

# kg, kg m^2
MASSES = 2 * [1500, 1500, 1500, 800, 110, 800, 80, 120, 80, 120] + [2500, 2500, 2500, 1800, 2200, 3000, 14500, 14500, 14500, 20e3]
WEIGHT = 9.80665 * (2 * 1500 + 2500 + 14500) / 2

RAIL, WHEEL = (kstrip.read_profile(DATA / f"{name}.csv").prepare() for name in ("uic60", "s1002"))
PAIR = kstrip.wheel_pair(wheel_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
WHEELSET = kstrip.Wheelset(WHEEL, PAIR, back_to_back=1.36)


def suspension():
    """Stiffness and damping of the springs and dampers: of each, the lengthening is a sum of factors times coordinates."""
    stiffness, damping = np.zeros((COUNT, COUNT)), np.zeros((COUNT, COUNT))

    def join(k, d, **factors):
        along = np.zeros(COUNT)
        for name, factor in factors.items():
            along[int(name[1:])] = factor
        stiffness[...] += k * np.outer(along, along)
        damping[...] += d * np.outer(along, along)

    def of(*pairs):
        return {f"_{place}": factor for place, factor in pairs}

    for s, x in ((0, WHEELBASE / 2), (SET, -WHEELBASE / 2)):
        for y in (-BOX, BOX):  # primary: along, across, down
            join(10e6, 10e3, **of((s + FORWARD, 1), (s + YAW, -y), (FRAME + FORWARD, -1), (FRAME + YAW, y)))
            join(5e6, 10e3, **of((s + LATERAL, 1), (FRAME + LATERAL, -1), (FRAME + YAW, -x)))
            join(1.2e6, 15e3, **of((s + VERTICAL, 1), (s + ROLL, y), (FRAME + VERTICAL, -1), (FRAME + ROLL, -y), (FRAME + PITCH, x)))
        for k in (s + 6, s + 8):  # rails: across, down
            join(20e6, 50e3, **of((k, 1)))
            join(75e6, 90e3, **of((k + 1, 1)))
    join(20e6, 100e3, **of((FRAME + FORWARD, 1), (CAR + FORWARD, -1)))  # secondary: along, yaw damper, down, across
    join(0, 5e3, **of((FRAME + YAW, 1.3)))
    for y in (-BOX, BOX):
        join(0.5e6, 20e3, **of((FRAME + VERTICAL, 1), (FRAME + ROLL, y), (CAR + VERTICAL, -1), (CAR + ROLL, -y)))
        join(0.17e6, 25e3, **of((FRAME + LATERAL, 1), (CAR + LATERAL, -1), (CAR + ROLL, -1.2)))
    return stiffness, damping


class Wheels:
    """Forces of the wheels on a wheelset and its rails, less those of the balance from which springs and coordinates count."""

    def __init__(self, speed, lateral):
        start = kstrip.wheel_position(lateral=lateral)
        self.settled = kstrip.wheelset_settle(WHEELSET, kstrip.Track(RAIL, gauge=1.435), start,
                                              kstrip.wheel_velocity(forward=speed, pitch=-speed / 0.46), WEIGHT)
        self.speed, self.seat = speed, self.settled.position
        forces = self.settled.forces
        self.balance = np.concatenate(([0, 0, -WEIGHT, 0, 0, 0], forces.rail[0, 1:], forces.rail[1, 1:]))

    def solve(self, q, rates, by_position):
        seat = self.seat
        motion = kstrip.rail_motion(q[[6, 8]], q[[7, 9]], rates[[6, 8]], rates[[7, 9]])
        position = kstrip.wheel_position(lateral=q[LATERAL], vertical=seat.vertical + q[VERTICAL], yaw=q[YAW], roll=seat.roll + q[ROLL])
        moves = kstrip.wheel_velocity(forward=self.speed + rates[FORWARD], lateral=rates[LATERAL], vertical=rates[VERTICAL],
                                      roll=rates[ROLL], pitch=self.settled.velocity.pitch + rates[PITCH], yaw=rates[YAW])
        return kstrip.wheelset_on_track(WHEELSET, kstrip.Track(RAIL, gauge=1.435, motion=motion), position, moves, by_position)

    def spin(self, rates):
        """The axle is a gyroscope: moment of yaw by roll rate, and the opposite [N m s]."""
        return MASSES[PITCH] * (self.settled.velocity.pitch + rates[PITCH])

    def force(self, mbs, t, item, q, rates):
        forces = self.solve(np.array(q), np.array(rates), False).forces
        wrench = forces.wrench
        sums = np.concatenate((wrench.force, wrench.moment, forces.rail[0, 1:], forces.rail[1, 1:])) - self.balance
        sums[ROLL] += self.spin(rates) * rates[YAW]
        sums[YAW] -= self.spin(rates) * rates[ROLL]
        return sums

    def jacobian(self, mbs, t, item, q, rates, by_place, by_rate):
        found = self.solve(np.array(q), np.array(rates), True)
        damps = np.array(found.derivatives.velocity)
        damps[ROLL, YAW] += self.spin(rates)
        damps[YAW, ROLL] -= self.spin(rates)
        # (of the left side of the equations)
        return -(by_place * np.array(found.by_position.position) + by_rate * damps)


def run(speed, until, step=1e-3):
    """Lateral place of the front wheelset [mm] over time [s], from 3 mm."""
    wheels = Wheels(speed, 3e-3)
    system = exudyn.SystemContainer()
    mbs = system.AddSystem()
    start = np.zeros(SET)
    start[LATERAL] = 3e-3
    nodes = [mbs.AddNode(NodeGenericODE2(referenceCoordinates=np.zeros(count), initialCoordinates=begin, initialCoordinates_t=np.zeros(count),
                                         numberOfODE2Coordinates=count))
             for count, begin in ((SET, start), (SET, start), (COUNT - FRAME, np.zeros(COUNT - FRAME)))]
    stiffness, damping = suspension()
    mbs.AddObject(ObjectGenericODE2(nodeNumbers=nodes, massMatrix=np.diag(MASSES), stiffnessMatrix=stiffness, dampingMatrix=damping))
    for node in nodes[:2]:
        mbs.AddObject(ObjectGenericODE2(nodeNumbers=[node], massMatrix=np.zeros((SET, SET)), forceUserFunction=wheels.force,
                                        jacobianUserFunction=wheels.jacobian))
    place = mbs.AddSensor(SensorNode(nodeNumber=nodes[0], storeInternal=True, outputVariableType=exudyn.OutputVariableType.Coordinates))
    mbs.Assemble()
    settings = exudyn.SimulationSettings()
    integration = settings.timeIntegration
    integration.numberOfSteps, integration.endTime = round(until / step), until
    integration.generalizedAlpha.spectralRadius = 0.7
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = step
    integration.verboseMode = 0
    mbs.SolveDynamic(settings)
    stored = mbs.GetSensorStoredData(place)
    return stored[:, 0], 1e3 * stored[:, 1 + LATERAL]


if __name__ == "__main__":
    # In its limit cycle the flange of S1002 touches with a patch whose normal turns by more than 30 degrees.
    warnings.simplefilter("ignore", kstrip.KstripWarning)
    time, place = run(80.0, 4.0)
    before, after = (np.abs(place[(time >= a) & (time < a + 1)]).max() for a in (2.0, 3.0))
    print(f"80 m/s: limit cycle of {after:.2f} mm")
    assert 7.0 < after < 10.0 and abs(after / before - 1) < 0.15, (before, after)
    time, place = run(20.0, 3.0)
    last = np.abs(place[time > 2.5]).max()
    print(f"20 m/s: {last:.3f} mm after 2.5 s")
    assert last < 1.0
