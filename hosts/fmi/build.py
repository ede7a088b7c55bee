"""Builds kstrip_fmi2.fmu and kstrip_fmi3.fmu: python build.py libkstrip.a FOLDER

The headers of FMI come with the package fmpy.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

import fmpy

HERE = pathlib.Path(__file__).resolve().parent
INCLUDE = HERE.parents[1] / "include"
HEADERS = pathlib.Path(fmpy.__file__).parent / "c-code"
TOKEN = "{8d1c2f0e-6b57-4c39-9a0b-6b7374726970}"

# Value references count from 0; the order is that of wheel_rail.c.
INPUTS = [
    ("slip_x", "m/s", 0.0, "Velocity of the wheel over the rail along x, forward"),
    ("slip_y", "m/s", 0.0, "Velocity of the wheel over the rail along y, to the right"),
    ("spin_rate", "rad/s", 0.0, "Angular velocity of the wheel over the rail about z, into the rail"),
    ("rolling_speed", "m/s", 20.0, "Rolling speed; negative: backward"),
    ("normal_force", "N", 80e3, "Normal force; not positive: the contact is lost"),
    ("friction", "1", 0.3, "Coefficient of friction"),
]
OUTPUTS = [
    ("F_x", "N", "Force on the rail along x; the wheel gets the opposite"),
    ("F_y", "N", "Force on the rail along y"),
    ("M_z", "N.m", "Moment on the rail about z"),
    ("power", "W", "What friction dissipates"),
]
PARAMETERS = [
    ("wheel_radius", "m", 0.46, "Rolling radius"),
    ("wheel_curvature", "1/m", 0.0, "Curvature of the wheel's profile, convex positive; 0: conical"),
    ("rail_radius", "m", 0.3, "Radius of the rail's head"),
    ("shear_modulus", "Pa", 82e9, "Combined shear modulus"),
    ("poisson_ratio", "1", 0.28, "Combined Poisson's ratio"),
    ("floor_speed", "m/s", 0.02, "Speed below which creepages grow no further"),
]
UNITS = {
    "m/s": 'm="1" s="-1"', "rad/s": 'rad="1" s="-1"', "N": 'kg="1" m="1" s="-2"', "N.m": 'kg="1" m="2" s="-2"',
    "W": 'kg="1" m="2" s="-3"', "m": 'm="1"', "1/m": 'm="-1"', "Pa": 'kg="1" m="-1" s="-2"', "1": "",
}  # fmt: skip


def description(version):
    """modelDescription.xml"""
    rows = []

    def variable(name, text, attributes, kind, value):
        head = f'name="{name}" valueReference="{len(rows)}" description="{text}" {attributes}'
        if version == 3:
            rows.append(f"<{kind[0]} {head} {value}/>")
        else:
            rows.append(f"<ScalarVariable {head}><{kind[1]} {value}/></ScalarVariable>")

    real, integer = ("Float64", "Real"), ("Int32", "Integer")
    parameter = 'causality="parameter" variability="tunable" initial="exact"'
    for name, unit, start, text in INPUTS:
        variable(name, text, 'causality="input" variability="continuous"', real, f'unit="{unit}" start="{start}"')
    for name, unit, text in OUTPUTS:
        variable(name, text, 'causality="output" variability="continuous" initial="calculated"', real, f'unit="{unit}"')
    for name, unit, start, text in PARAMETERS:
        variable(name, text, parameter, real, f'unit="{unit}" start="{start}"')
    variable("model", "Model of kstrip.h; 0: the default", parameter, integer, 'start="0"')
    first = len(INPUTS)
    if version == 3:
        variable("time", "Time", 'causality="independent" variability="continuous"', real, "")
        needs = " ".join(map(str, range(first)))
        outputs = "".join(f'<Output valueReference="{first + k}" dependencies="{needs}"/>' for k in range(len(OUTPUTS)))
        initial = "".join(f'<InitialUnknown valueReference="{first + k}"/>' for k in range(len(OUTPUTS)))
        head = f'fmiVersion="3.0" instantiationToken="{TOKEN}"'
        can = 'modelIdentifier="kstrip" providesDirectionalDerivatives="true"'
    else:
        needs = " ".join(str(1 + k) for k in range(first))
        unknown = "".join(f'<Unknown index="{1 + first + k}" dependencies="{needs}"/>' for k in range(len(OUTPUTS)))
        outputs = f"<Outputs>{unknown}</Outputs>"
        initial = "".join(f'<Unknown index="{1 + first + k}"/>' for k in range(len(OUTPUTS)))
        initial = f"<InitialUnknowns>{initial}</InitialUnknowns>"
        head = f'fmiVersion="2.0" guid="{TOKEN}" numberOfEventIndicators="0"'
        can = 'modelIdentifier="kstrip" providesDirectionalDerivative="true"'
    units = "".join(f'<Unit name="{name}"><BaseUnit {si}/></Unit>' for name, si in UNITS.items())
    newline = "\n"
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription {head} modelName="kstrip" description="Creep forces of a wheel on a rail" variableNamingConvention="flat">
<ModelExchange {can}{' completedIntegratorStepNotNeeded="true"' if version == 2 else ""}/>
<CoSimulation {can} canHandleVariableCommunicationStepSize="true"/>
<UnitDefinitions>{units}</UnitDefinitions>
<LogCategories><Category name="logStatusError"/></LogCategories>
<DefaultExperiment startTime="0" stopTime="1" stepSize="0.01"/>
<ModelVariables>
{newline.join(rows)}
</ModelVariables>
<ModelStructure>{outputs}{initial}</ModelStructure>
</fmiModelDescription>
"""


# Of what wheel_rail.c leaves out, a model without states and events does these by doing nothing.
NOTHING_TO_DO = """SetDebugLogging SetupExperiment EnterInitializationMode ExitInitializationMode EnterEventMode Terminate
    EnterContinuousTimeMode SetTime SetContinuousStates GetDerivatives GetContinuousStateDerivatives GetEventIndicators GetContinuousStates
    GetNominalsOfContinuousStates EvaluateDiscreteStates EnterStepMode EnterConfigurationMode ExitConfigurationMode""".split()


def source(version):
    """wheel_rail.c, and the functions of the standard that it leaves out: nothing to do, or not supported."""
    ours = (HERE / "wheel_rail.c").read_text()
    types = (HEADERS / f"fmi{version}FunctionTypes.h").read_text()
    rest = []
    for result, name, arguments in re.findall(r"typedef\s+([\w ]+?)\s+(fmi\d\w+)TYPE\s*\((.*?)\);", types, re.S):
        if not re.search(rf"\b{name}\(", ours):
            if result.startswith(f"fmi{version}Status"):
                answer = f"fmi{version}OK" if name[4:] in NOTHING_TO_DO else f"fmi{version}Error"
            else:
                answer = "NULL"
            rest.append(f"{result} {name}({arguments}) {{ return {answer}; }}")
    return ours + "\n".join(rest) + "\n"


def build(version, library, folder):
    fmu = folder / f"kstrip_fmi{version}.fmu"
    with tempfile.TemporaryDirectory() as work:
        code, binary = pathlib.Path(work, "fmu.c"), pathlib.Path(work, "kstrip" + fmpy.sharedLibraryExtension)
        code.write_text(source(version))
        subprocess.run(
            [os.environ.get("CC", "cc"), "-std=gnu2x", "-O2", "-Wall", "-Werror", "-fPIC", "-shared", "-fvisibility=hidden",
             f"-DFMI={version}", f'-DTOKEN="{TOKEN}"', f"-I{INCLUDE}", f"-I{HEADERS}", str(code), str(library), "-lm", "-o", str(binary)],
            check=True,
        )  # fmt: skip
        platform = fmpy.platform_tuple if version == 3 else fmpy.platform
        with zipfile.ZipFile(fmu, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("modelDescription.xml", description(version))
            archive.write(binary, f"binaries/{platform}/{binary.name}")
    return fmu


if __name__ == "__main__":
    into = pathlib.Path(sys.argv[2])
    into.mkdir(parents=True, exist_ok=True)
    for number in (2, 3):
        print(build(number, pathlib.Path(sys.argv[1]), into))
