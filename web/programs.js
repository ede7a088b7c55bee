"use strict";

// Programs in C and Python that compute the numbers of the demo and print them with all digits.
const programs = {
    c(view, v, found) {
        return view.name === "contact" ? this.contactInC(v, found) : this.wheelInC(v, found);
    },
    python(view, v, found) {
        return view.name === "contact" ? this.contactInPython(v) : this.wheelInPython(v, found);
    },

    // A number that reads back as the same bits
    inC: (x) => (x === Infinity ? "INFINITY" : x === -Infinity ? "-INFINITY" : String(x)),
    inPython: (x) => (x === Infinity ? 'float("inf")' : x === -Infinity ? 'float("-inf")' : String(x)),

    contactInC(v) {
        const n = this.inC;
        const bodies = v.shape === "axes"
            ? `    kstrip_contact contact = {.a = ${n(v.a)}, .b = ${n(v.b)}, .normal_force = ${n(v.N)}, .shear_modulus = pair.shear_modulus,
                              .poisson_ratio = pair.poisson_ratio, .friction = ${n(v.mu)}, .mismatch = pair.mismatch};`
            : `    kstrip_radii radii = {.lower_x = ${n(v.lx)}, .lower_y = ${n(v.ly)}, .upper_x = ${n(v.ux)}, .upper_y = ${n(v.uy)}};  /* [m] */
    kstrip_contact contact;
    check(kstrip_contact_from_hertz(&radii, &pair, ${n(v.N)}, ${n(v.mu)}, &contact, NULL));`;
        const law = v.law ? `
    kstrip_friction law = {.friction = ${n(v.mu)}, .ratio = ${n(v.A)}, .decay = ${n(v.B)}, .rolling_speed = ${n(v.V)}, .slope_factor = ${n(v.k)}};` : "";
        return `/* Written by the browser demo of kstrip. After \`make\`: cc program.c -Iinclude target/lib/libkstrip.a -lm -o program && ./program */
#include "kstrip.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void check(kstrip_status status)
{
    if (status != KSTRIP_OK) fprintf(stderr, "%s\\n", kstrip_status_string(status));
    if (status < 0) exit(EXIT_FAILURE);
}

int main(void)
{
    kstrip_material rail = {${n(v.G1)}, ${n(v.nu1)}}, wheel = {${n(v.G2)}, ${n(v.nu2)}};  /* shear modulus [Pa], Poisson's ratio */
    kstrip_combined_material pair;
    check(kstrip_material_combine(&rail, &wheel, &pair));
${bodies}
    kstrip_creepage creepage = {.longitudinal = ${n(v.vx)}, .lateral = ${n(v.vy)}, .spin = ${n(v.phi)}};${law}

    static const char *names[] = {"TOTAL", "STRIP", "STRIP_1967", "STRIP_1967_CONTINUOUS", "LINEAR"};
    static const int models[] = {KSTRIP_MODEL_TOTAL, KSTRIP_MODEL_STRIP, KSTRIP_MODEL_STRIP_1967, KSTRIP_MODEL_STRIP_1967_CONTINUOUS,
                                 KSTRIP_MODEL_LINEAR};
    for (int i = 0; i < 5; i++) {
        kstrip_options options = {.model = models[i]};
        kstrip_result forces;  /* on the rail, the lower body */
        double friction;
        kstrip_outputs outputs = {.result = &forces, .friction = &friction};
        check(kstrip_evaluate(&contact, &creepage, ${v.law ? "&law" : "NULL"}, &options, &outputs));
        printf("%s fx %.17g N, fy %.17g N, mz %.17g N m, power %.17g N, adhesion %.17g, friction %.17g\\n", names[i], forces.fx, forces.fy,
               forces.mz, forces.power, forces.adhesion, friction);
    }
    return 0;
}
`;
    },

    contactInPython(v) {
        const n = this.inPython;
        const bodies = v.shape === "axes"
            ? `contact = kstrip.contact(a=${n(v.a)}, b=${n(v.b)}, normal_force=${n(v.N)}, shear_modulus=pair.shear_modulus,
                         poisson_ratio=pair.poisson_ratio, friction=${n(v.mu)}, mismatch=pair.mismatch)`
            : `radii = kstrip.radii(lower_x=${n(v.lx)}, lower_y=${n(v.ly)}, upper_x=${n(v.ux)}, upper_y=${n(v.uy)})  # [m]
contact, ellipse = kstrip.contact_from_hertz(radii, pair, load=${n(v.N)}, friction=${n(v.mu)})`;
        const law = v.law
            ? `law = kstrip.friction(${n(v.mu)}, ratio=${n(v.A)}, decay=${n(v.B)}, rolling_speed=${n(v.V)}, slope_factor=${n(v.k)})`
            : "law = None";
        return `# Written by the browser demo of kstrip. After \`make\`: PYTHONPATH=bindings/python python3 program.py   (or: pip install ./bindings/python)
import kstrip

pair = kstrip.combine((${n(v.G1)}, ${n(v.nu1)}), (${n(v.G2)}, ${n(v.nu2)}))  # rail, wheel: shear modulus [Pa], Poisson's ratio
${bodies}
creepage = kstrip.creepage(longitudinal=${n(v.vx)}, lateral=${n(v.vy)}, spin=${n(v.phi)})
${law}
for name in ("TOTAL", "STRIP", "STRIP_1967", "STRIP_1967_CONTINUOUS", "LINEAR"):
    found = kstrip.evaluate(contact, creepage, law, model=name.lower())
    forces = found.result  # on the rail, the lower body
    print(f"{name} fx {forces.fx!r} N, fy {forces.fy!r} N, mz {forces.mz!r} N m, power {forces.power!r} N, adhesion {forces.adhesion!r}, "
          f"friction {found.friction!r}")
`;
    },

    // Numbers in lines
    list(values) {
        const lines = [];
        for (let i = 0; i < values.length; i += 10) lines.push(`    ${values.slice(i, i + 10).join(", ")},`);
        return lines.join("\n");
    },

    wheelInC(v, found) {
        const n = this.inC, { pair, position, velocity, load } = found.inputs;
        const array = (name, values) => `static const double ${name}[] = {\n${this.list(values)}\n};`;
        const rail = wheelView.pointsOf("rail", v), wheel = wheelView.pointsOf("wheel", v);
        return `/* Written by the browser demo of kstrip. After \`make\`: cc program.c -Iinclude target/lib/libkstrip.a -lm -o program && ./program */
#include "kstrip.h"
#include <stdio.h>
#include <stdlib.h>

/* Profiles of a right wheel [m]: ${v.rail}, ${v.wheel} */
${array("rail_y", rail.y)}
${array("rail_z", rail.z)}
${array("wheel_y", wheel.y)}
${array("wheel_z", wheel.z)}

static kstrip_surface rail, wheel;
static kstrip_wheel_workspace workspace;

static void check(kstrip_status status)
{
    if (status != KSTRIP_OK) fprintf(stderr, "%s\\n", kstrip_status_string(status));
    if (status < 0) exit(EXIT_FAILURE);
}

int main(void)
{
    check(kstrip_prepare_profile(rail_y, rail_z, sizeof rail_y / sizeof *rail_y, 0, ${n(v.smooth)}, &rail));
    check(kstrip_prepare_profile(wheel_y, wheel_z, sizeof wheel_y / sizeof *wheel_y, 0, ${n(v.smooth)}, &wheel));
    kstrip_wheel_pair pair = {.wheel_radius = ${n(pair.wheel_radius)}, .shear_modulus = ${n(pair.shear_modulus)}, .poisson_ratio = ${n(pair.poisson_ratio)},
                              .friction = ${n(pair.friction)}, .left = ${pair.left}, .smoothing_length = ${n(pair.smoothing_length)}, .model = KSTRIP_MODEL_${v.m}};
    kstrip_wheel_position position = {.lateral = ${n(position.lateral)}, .yaw = ${n(position.yaw)}};
    kstrip_wheel_velocity velocity = {.forward = ${n(velocity.forward)}, .lateral = ${n(velocity.lateral)}, .pitch = ${n(velocity.pitch)}};
    check(kstrip_height_for_load(&rail, &wheel, &pair, &position, ${n(load)}, &velocity, NULL, NULL, &workspace, &position.vertical));
    kstrip_wrench on_wheel;
    check(kstrip_wheel_on_rail(&rail, &wheel, &pair, &position, &velocity, NULL, &workspace, &on_wheel, NULL, NULL));
    printf("vertical %.17g m\\n", position.vertical);
    printf("force %.17g %.17g %.17g N\\n", on_wheel.force[0], on_wheel.force[1], on_wheel.force[2]);
    printf("moment %.17g %.17g %.17g N m\\n", on_wheel.moment[0], on_wheel.moment[1], on_wheel.moment[2]);
    for (unsigned i = 0; i < workspace.count; i++)
        printf("contact load %.17g N, angle %.17g rad\\n", workspace.contacts[i].normal_force, workspace.contacts[i].angle);
    return 0;
}
`;
    },

    wheelInPython(v, found) {
        const n = this.inPython, { pair, position, velocity, load } = found.inputs;
        const array = (name, values) => `${name} = [\n${this.list(values)}\n]`;
        const rail = wheelView.pointsOf("rail", v), wheel = wheelView.pointsOf("wheel", v);
        return `# Written by the browser demo of kstrip. After \`make\`: PYTHONPATH=bindings/python python3 program.py   (or: pip install ./bindings/python)
import kstrip

# Profiles of a right wheel [m]: ${v.rail}, ${v.wheel}
${array("rail_y", rail.y)}
${array("rail_z", rail.z)}
${array("wheel_y", wheel.y)}
${array("wheel_z", wheel.z)}

rail = kstrip.prepare_profile(rail_y, rail_z, smoothing_length=${n(v.smooth)})
wheel = kstrip.prepare_profile(wheel_y, wheel_z, smoothing_length=${n(v.smooth)})
pair = kstrip.wheel_pair(wheel_radius=${n(pair.wheel_radius)}, shear_modulus=${n(pair.shear_modulus)}, poisson_ratio=${n(pair.poisson_ratio)},
                         friction=${n(pair.friction)}, left=${pair.left ? "True" : "False"}, smoothing_length=${n(pair.smoothing_length)}, model="${v.m.toLowerCase()}")
position = kstrip.wheel_position(lateral=${n(position.lateral)}, yaw=${n(position.yaw)})
velocity = kstrip.wheel_velocity(forward=${n(velocity.forward)}, lateral=${n(velocity.lateral)}, pitch=${n(velocity.pitch)})
position.vertical = kstrip.height_for_load(rail, wheel, pair, position, ${n(load)}, velocity)
found = kstrip.wheel_on_rail(rail, wheel, pair, position, velocity)
print("vertical", repr(position.vertical), "m")
print("force", *map(repr, found.wrench.force.tolist()), "N")
print("moment", *map(repr, found.wrench.moment.tolist()), "N m")
for contact in found.contacts:
    print("contact load", repr(contact.normal_force), "N, angle", repr(contact.angle), "rad")
`;
    },
};
