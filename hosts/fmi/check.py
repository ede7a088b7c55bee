"""Checks the FMUs of build.py: python check.py FOLDER libkstrip.so

fmpy's validation; a sweep through standstill by both kinds of FMU; 2000 random directional derivatives against differences; the digits of
a direct call, in fmpy and in libcosimpy; refusal of bad input.
"""

import ctypes
import pathlib
import shutil
import sys

import fmpy
import numpy as np
from build import INPUTS, OUTPUTS
from fmpy.fmi2 import FMU2Model
from fmpy.fmi3 import FMU3Model
from fmpy.validation import validate_fmu

folder, library = pathlib.Path(sys.argv[1]), ctypes.CDLL(sys.argv[2])
IN, OUT = range(len(INPUTS)), range(len(INPUTS), len(INPUTS) + len(OUTPUTS))
INPUT_NAMES, OUTPUT_NAMES = [row[0] for row in INPUTS], [row[0] for row in OUTPUTS]


def direct(x):
    """F_x, F_y, M_z, power by a call of the library."""
    numbers = lambda *values: (ctypes.c_double * len(values))(*values)
    contact, result = numbers(*[0] * 7), numbers(*[0] * 6)
    radii, steel, motion = numbers(np.inf, 0.3, 0.46, np.inf), numbers(82e9, 0.28, 0), numbers(*x[:4], 0.02)
    outputs = (ctypes.c_void_p * 3)(ctypes.addressof(result), None, None)
    assert library.kstrip_contact_from_hertz(radii, steel, ctypes.c_double(x[4]), ctypes.c_double(x[5]), contact, None) >= 0
    assert library.kstrip_solve_motion(contact, motion, None, None, outputs) >= 0
    return list(result[:4])


class Model:
    """An instance for model exchange."""

    def __init__(self, fmu):
        self.description, self.folder = fmpy.read_model_description(fmu), fmpy.extract(fmu)
        self.two = self.description.fmiVersion == "2.0"
        kind = FMU2Model if self.two else FMU3Model
        self.unit = kind(guid=self.description.guid, unzipDirectory=self.folder, modelIdentifier="kstrip", instanceName="wheel")
        self.unit.instantiate()
        if self.two:
            self.unit.setupExperiment()
        self.unit.enterInitializationMode()
        self.unit.exitInitializationMode()
        self.set = self.unit.setReal if self.two else self.unit.setFloat64
        self.get = self.unit.getReal if self.two else self.unit.getFloat64

    def __call__(self, x):
        self.set(list(IN), [float(v) for v in x])
        return np.array(self.get(list(OUT)))

    def along(self, direction):
        return np.array(self.unit.getDirectionalDerivative(list(OUT), list(IN), [float(v) for v in direction]))

    def close(self):
        self.unit.terminate()
        self.unit.freeInstance()
        shutil.rmtree(self.folder)


def motions(random, count):
    """Random inputs, forward and backward, 0.1 mm/s to 100 m/s, and the sizes of their changes."""
    for _ in range(count):
        speed = random.choice([-1, 1]) * 10 ** random.uniform(-4, 2)
        v = np.hypot(speed, 0.02)
        size = np.array([2e-3 * v, 2e-3 * v, 0.3 * v, v, 10 ** random.uniform(3.5, 5.2), random.uniform(0.1, 0.6)])
        yield np.array([*(random.normal(size=3) * size[:3]), speed, *size[4:]]), size


def sweep(fmu):
    """Both kinds of FMU, from 20 m/s through standstill to -20 m/s."""
    t = np.linspace(0, 1, 401)
    rows = np.zeros(len(t), dtype=[("time", float)] + [(name, float) for name in INPUT_NAMES])
    rows["time"], rows["rolling_speed"], rows["normal_force"], rows["friction"] = t, 20 - 40 * t, 80e3, 0.3
    rows["slip_x"], rows["slip_y"], rows["spin_rate"] = 0.3 * np.sin(7 * t), 0.1 * np.cos(5 * t), 4 * np.sin(3 * t)
    for kind in ("ModelExchange", "CoSimulation"):
        r = fmpy.simulate_fmu(fmu, fmi_type=kind, input=rows, output=OUTPUT_NAMES, stop_time=1, output_interval=1 / 400)
        force = np.hypot(r["F_x"], r["F_y"]) / (0.3 * 80e3)
        assert all(np.isfinite(r[name]).all() for name in OUTPUT_NAMES) and len(r) >= 401
        assert force.max() <= 1 and force.max() > 0.99 and r["power"].min() >= 0, (force.max(), r["power"].min())
        print(f"  {kind}: {len(r)} points through standstill, largest force {force.max():.6f} mu N, smallest power {r['power'].min():.3e} W")


def derivatives(model, random):
    """Along random directions, against differences of fourth order. With three steps, because the longer ones may lie across a place where
    the second derivative jumps (full sliding, the end of the blend near standstill)."""
    worst = 0
    for x, size in motions(random, 2000):
        direction = size * random.normal(size=len(size))
        model(x)
        exact = model.along(direction)
        scale = x[5] * x[4] * np.array([1, 1, 5e-3, np.abs(size[:2]).max()])

        def error(h):
            f = [model(x + k * h * direction) for k in (-2, -1, 1, 2)]
            return np.max(np.abs(exact - (f[0] - 8 * f[1] + 8 * f[2] - f[3]) / (12 * h)) / scale)

        worst = max(worst, min(error(3e-5), error(3e-6), error(1e-7)))
    print(f"  2000 random directional derivatives against differences: {worst:.1e} mu N")
    assert worst < 1e-8


def cosim(fmu, x):
    """The outputs in libcosim, the second importer."""
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
    from libcosimpy.CosimManipulator import CosimManipulator
    from libcosimpy.CosimObserver import CosimObserver
    from libcosimpy.CosimSlave import CosimLocalSlave

    log_output_level(CosimLogLevel.WARNING)
    execution = CosimExecution.from_step_size(step_size=10_000_000)
    slave = execution.add_local_slave(CosimLocalSlave(fmu_path=str(fmu), instance_name="wheel"))
    inputs, observer = CosimManipulator.create_override(), CosimObserver.create_last_value()
    execution.add_manipulator(inputs)
    execution.add_observer(observer)
    inputs.slave_real_values(slave, list(IN), [float(v) for v in x])
    execution.simulate_until(100_000_000)
    return list(observer.last_real_values(slave, list(OUT)))


def main():
    for version in (2, 3):
        fmu = folder / f"kstrip_fmi{version}.fmu"
        random = np.random.default_rng(version)
        problems = validate_fmu(str(fmu))
        assert not problems, problems
        print(f"FMI {version}.0: fmpy {fmpy.__version__} validates without a finding")
        sweep(str(fmu))
        model = Model(str(fmu))
        derivatives(model, random)
        for x, _ in motions(random, 200):
            assert list(model(x)) == direct(x), (x, model(x), direct(x))
        assert not model([0.01, 0.01, 0, 20, 0, 0.3]).any(), "a lost contact carries nothing"
        try:
            model([0.01, 0.01, 0, 20, 80e3, -1])
            raise SystemExit("negative friction is not refused")
        except Exception as error:
            print(f"  200 motions: the digits of the direct call; negative friction: {type(error).__name__}")
        model.close()
        if version == 2:
            x = [0.02, 0.01, 2.0, -15.0, 75e3, 0.35]
            assert cosim(fmu, x) == direct(x), (cosim(fmu, x), direct(x))
            print("  libcosimpy: the digits of the direct call")


main()
