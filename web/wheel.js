"use strict";

// The second view: a wheel on a rail, from two profiles.
const wheelView = {
    name: "wheel",
    groups: [
        { title: "Position", fields: [
            { key: "shift", label: "Lateral shift to the right", unit: "mm", power: -3, value: 2, low: -12, high: 12, scale: "linear" },
            { key: "yaw", label: "Yaw to the right", unit: "mrad", power: -3, value: 2, low: -30, high: 30, scale: "linear" },
            { key: "Q", label: "Load of the wheel", unit: "kN", power: 3, value: 80, low: 1, high: 200, scale: "linear" },
            { key: "side", label: "Wheel", kind: "choice", options: { right: "right wheel", left: "left wheel" }, value: "right" },
        ] },
        { title: "Motion", fields: [
            { key: "v", label: "Speed", unit: "m/s", power: 0, value: 20, low: 0.1, high: 100, scale: "linear" },
            { key: "turn", label: "Axle turns faster than it rolls by", unit: "%", power: -2, value: 0, high: 3, scale: "cube" },
            { key: "drift", label: "Lateral velocity", unit: "mm/s", power: -3, value: 0, high: 300, scale: "cube" },
        ] },
        { title: "Profiles", fields: [
            { key: "rail", label: "Rail", kind: "file", builtin: "60E1", value: "60E1" },
            { key: "wheel", label: "Wheel", kind: "file", builtin: "S1002", value: "S1002" },
            { key: "R", label: "Wheel radius", unit: "mm", power: -3, value: 460, low: 150, high: 650, scale: "linear" },
            { key: "origin", label: "Rail’s origin, outward from the running circle", unit: "mm", power: -3, value: 10.5325, low: -40, high: 40, scale: "linear" },
            { key: "cant", label: "Rail turned by", unit: "mrad", power: -3, value: 0, low: -60, high: 60, scale: "linear" },
            { key: "smooth", label: "Smoothing of measured profiles", unit: "mm", power: -3, value: 0, low: 0, high: 8, scale: "linear" },
        ] },
        { title: "Friction and material", closed: true, fields: [
            { key: "f", label: "Friction μ", unit: "", power: 0, value: 0.3, low: 0, high: 1, scale: "linear" },
            { key: "G", label: "Shear modulus G (both)", unit: "GPa", power: 9, value: 82, low: 1, high: 300, scale: "log" },
            { key: "nu", label: "Poisson’s ratio ν (both)", unit: "", power: 0, value: 0.28, low: 0, high: 0.5, scale: "linear" },
            { key: "m", label: "Model", kind: "choice", options: ["STRIP", "TOTAL"], value: "STRIP" },
        ] },
    ],
    // Points [mm] of the profiles in use: { y, z }
    points: { rail: PROFILES["60E1"], wheel: PROFILES.S1002 },

    // Points of a profile [m], as the library and the copied programs get them.
    pointsOf(kind, v) {
        const { y, z } = this.points[kind];
        if (kind !== "rail" || v.cant === 0) return { y: y.map((one) => one * 1e-3), z: z.map((one) => one * 1e-3) };
        const cosine = Math.cos(v.cant), sine = Math.sin(v.cant);
        return {
            y: y.map((one, i) => (one * cosine - z[i] * sine) * 1e-3),
            z: z.map((one, i) => (one * sine + z[i] * cosine) * 1e-3),
        };
    },

    // Prepared profiles and the workspace stay in memory; a profile is prepared again when it changes.
    prepare(library, v) {
        if (!this.memory) {
            const size = (name) => library.structures[name].size;
            library.release();
            this.memory = {
                rail: library.allocate(size("kstrip_surface")), wheel: library.allocate(size("kstrip_surface")),
                workspace: library.allocate(size("kstrip_wheel_workspace")), of: {},
            };
            library.keep();
        }
        for (const kind of ["rail", "wheel"]) {
            const key = kind === "rail" ? v.cant : 0, of = this.memory.of[kind];
            if (of && of.points === this.points[kind] && of.key === key && of.smooth === v.smooth) continue;
            const points = this.pointsOf(kind, v);
            const status = library.call("prepare_profile", library.doubles(points.y), library.doubles(points.z), points.y.length, 0, v.smooth,
                this.memory[kind]);
            if (status < 0) return `The profile of the ${kind}: ${library.message(status)}`;
            this.memory.of[kind] = { points: this.points[kind], key, smooth: v.smooth };
        }
        return null;
    },

    // Inputs of the library, as the copied programs have them too.
    inputs(v) {
        const left = v.side === "left";
        return {
            pair: { wheel_radius: v.R, shear_modulus: v.G, poisson_ratio: v.nu, friction: v.f, left: left ? 1 : 0, smoothing_length: v.smooth },
            position: { lateral: left ? v.shift + v.origin : v.shift - v.origin, yaw: v.yaw },
            velocity: { forward: v.v, lateral: v.drift, pitch: (-v.v / v.R) * (1 + v.turn) },
            load: v.Q,
        };
    },

    compute(library, v) {
        const wrong = this.prepare(library, v);
        if (wrong) return { error: wrong };
        const inputs = this.inputs(v), { rail, wheel, workspace } = this.memory;
        const model = library.constants[`KSTRIP_MODEL_${v.m}`];
        const pair = library.make("kstrip_wheel_pair", { ...inputs.pair, model });
        const position = library.make("kstrip_wheel_position", inputs.position);
        const velocity = library.make("kstrip_wheel_velocity", inputs.velocity);
        const vertical = position + library.structures.kstrip_wheel_position.members.vertical.offset;
        const warnings = [];
        const says = (name, status) => {
            if (status > 0 && !warnings.some((one) => one[1] === library.message(status))) warnings.push([name, library.message(status)]);
            return status;
        };
        if (says("Height", library.call("height_for_load", rail, wheel, pair, position, inputs.load, 0, 0, workspace, vertical)) < 0) {
            return { error: "The rail does not carry this load here: " + library.message(library.call("height_for_load", rail, wheel, pair, position, inputs.load, 0, 0, workspace, vertical)) };
        }
        const wrench = library.make("kstrip_wrench");
        const status = says("Wheel on rail", library.call("wheel_on_rail", rail, wheel, pair, position, velocity, 0, workspace, wrench, 0, 0));
        if (status < 0) return { error: library.message(status) };

        const space = library.structures.kstrip_wheel_workspace.members, contactSize = library.structures.kstrip_wheel_contact.size;
        const count = new DataView(library.memory.buffer).getUint32(workspace + space.count.offset, true);
        const found = { wrench: library.read("kstrip_wrench", wrench), position: library.read("kstrip_wheel_position", position), warnings, inputs, contacts: [] };
        for (let i = 0; i < count; i++) {
            found.contacts.push(this.contactAt(library, v, workspace + space.contacts.offset + i * contactSize, velocity, says));
        }
        return found;
    },

    // One contact: place, creepages, forces, strips and tractions.
    contactAt(library, v, pointer, velocity, says) {
        const contact = library.read("kstrip_wheel_contact", pointer);
        const patch = pointer + library.structures.kstrip_wheel_contact.members.patch.offset;
        const motion = library.make("kstrip_motion"), result = library.make("kstrip_result"), summary = library.make("kstrip_patch_summary");
        library.call("wheel_motion", pointer, velocity, motion);
        contact.motion = library.read("kstrip_motion", motion);
        const speed = Math.abs(contact.motion.rolling_speed) || 1;
        contact.creepages = [contact.motion.slip_x, contact.motion.slip_y, contact.motion.spin_rate].map((one) => one / speed);
        const creepage = library.make("kstrip_creepage", Object.fromEntries(Object.keys(CREEPAGES).map((key, i) => [key, contact.creepages[i]])));
        library.call("patch_summarize", patch, summary);
        contact.summary = library.read("kstrip_patch_summary", summary);
        contact.strips = contact.patch.strips.slice(0, contact.patch.count);
        contact.peak = Math.max(0, ...contact.strips.map((strip) => strip.peak_pressure));

        // Strips and tractions are those of STRIP at the mean slip
        const capacity = library.constants.KSTRIP_PATCH_CAPACITY;
        const forces = library.allocate(capacity * library.structures.kstrip_strip.size), number = library.allocate(4);
        const outputs = library.make("kstrip_outputs", { result, strips: forces, count: number, capacity });
        const options = library.make("kstrip_options", { model: library.constants.KSTRIP_MODEL_STRIP });
        says("Patch", library.call("patch_evaluate", patch, creepage, 0, options, outputs));
        contact.result = library.read("kstrip_result", result);
        contact.forces = library.readAll("kstrip_strip", forces, contact.patch.count);
        // The wrench of this contact alone, without its pressure: creep forces in its plane
        library.write("kstrip_wheel_contact", pointer, { share: 1 });
        const wrench = library.make("kstrip_wrench");
        says("Contact", library.call("wrench_from_contacts", pointer, 1, velocity, library.constants[`KSTRIP_MODEL_${v.m}`], 0, wrench, 0));
        library.write("kstrip_wheel_contact", pointer, { share: contact.share });
        const [x, y, z] = library.read("kstrip_wrench", wrench).force, right = v.side === "left" ? -y : y;
        contact.result.fx = -x;
        contact.result.fy = -right * Math.cos(contact.angle) - z * Math.sin(contact.angle);
        const ys = contact.strips.map((strip) => strip.y), low = Math.min(...contact.strips.map((s) => s.centre_x - s.half_length));
        const high = Math.max(...contact.strips.map((s) => s.centre_x + s.half_length));
        const step = (high - low) / 13, xs = Array.from({ length: 13 }, (_, i) => low + (i + 0.5) * step);
        const every = Math.max(1, Math.round(step / (contact.strips[0]?.width ?? step))), rows = ys.filter((_, i) => i % every === every >> 1);
        const points = library.allocate(xs.length * rows.length * library.structures.kstrip_point.size);
        contact.field = rows.length > 0 && library.call("patch_field", patch, creepage, options, library.doubles(xs), xs.length,
            library.doubles(rows), rows.length, points, xs.length * rows.length) >= 0
            ? library.readAll("kstrip_point", points, xs.length * rows.length).map((p, i) => ({ ...p, x: xs[i % xs.length], y: rows[Math.floor(i / xs.length)] }))
            : [];
        contact.step = step;
        return contact;
    },

    sentence(v, found) {
        const { wrench, contacts } = found;
        if (contacts.length === 0) return "The wheel is lifted: nothing acts on it.";
        const places = contacts.length === 1 ? "one contact" : `${contacts.length} contacts`;
        const worst = contacts.reduce((most, one) => (one.normal_force > most.normal_force ? one : most));
        return `${places[0].toUpperCase()}${places.slice(1)}. On the wheel: ${direction(wrench.force[0], wrench.force[1])}, `
            + `${show(Math.abs(wrench.force[2]))} N ${wrench.force[2] < 0 ? "up" : "down"}. `
            + `The contact with most load has ${show(worst.peak / 1e6, 3)} MPa at ${show((worst.angle * 180) / Math.PI, 3)}°.`;
    },

    // Both profiles across the track [mm], with contacts and the forces of the pressure. A left wheel is the mirror image.
    drawSection(v, found) {
        const sign = v.side === "left" ? -1 : 1, width = 560, height = 285;
        const rail = this.pointsOf("rail", v), wheel = this.points.wheel, mm = 1e3;
        const y0 = found.position.lateral * mm, z0 = found.position.vertical * mm;
        const { atX, atY, svg } = axes([58, 12, 490, 219], sign > 0 ? [-82, 70] : [-70, 82], [48, -20], ["y from the origin of the rail [mm]", "z down [mm]"], [8, 5]);
        const line = (y, z) => path(y.map((one, i) => [atX(one), atY(z[i])]));
        const railLine = line(rail.y.map((y) => sign * y * mm), rail.z.map((z) => z * mm));
        const wheelLine = line(wheel.y.map((y) => y0 + sign * y), wheel.z.map((z) => z + z0));
        const most = Math.max(1, ...found.contacts.map((c) => c.normal_force));
        let marks = "", said = [];
        found.contacts.forEach((c, i) => {
            const y = y0 + c.origin[1] * mm, z = z0 + (c.origin[2] - v.R) * mm;
            const [ny, nz] = [-Math.sin(c.angle) * sign, Math.cos(c.angle)], length = 14 + (34 * c.normal_force) / most;
            marks += `<path class="force" d="${arrow(atX(y) + ny * length, atY(z) + nz * length, -ny * length, -nz * length, 8)}"/>`
                + `<circle class="touch" cx="${atX(y).toFixed(1)}" cy="${atY(z).toFixed(1)}" r="4.5"/>`
                + `<text class="number" x="${(atX(y) + ny * (length + 11)).toFixed(1)}" y="${(atY(z) + nz * (length + 11) + 4).toFixed(1)}" text-anchor="middle">${i + 1}</text>`;
            said.push(`contact ${i + 1} at y ${show(y, 3)} mm, ${show((c.angle * 180) / Math.PI, 3)} degrees, ${show(c.normal_force / 1e3, 3)} kN`);
        });
        const content = `<defs><clipPath id="section"><rect x="58" y="12" width="490" height="219"/></clipPath></defs>${svg}`
            + `<g clip-path="url(#section)"><path class="profile rail" d="${railLine}"/><path class="profile wheel" d="${wheelLine}"/>${marks}</g>`
            + `<text class="name" x="${sign > 0 ? 70 : 536}" y="30" text-anchor="${sign > 0 ? "start" : "end"}">wheel</text>`
            + `<text class="name" x="${atX(0)}" y="222" text-anchor="middle">rail</text>`;
        return picture(width, height, "Wheel and rail", said.join("; ") || "no contact", content);
    },

    // Each contact, drawn along its normal: pressure by shade, slip and stick, tractions on the rail.
    drawPatches(v, found) {
        const mm = 1e3, contacts = found.contacts;
        if (contacts.length === 0) return picture(560, 120, "Patches", "no contact", `<text class="label" x="280" y="64" text-anchor="middle">no contact</text>`);
        const ends = contacts.map((c) => ({
            left: Math.min(...c.strips.map((s) => s.y - s.width / 2)) * mm, right: Math.max(...c.strips.map((s) => s.y + s.width / 2)) * mm,
            low: Math.min(...c.strips.map((s) => s.centre_x - s.half_length)) * mm, high: Math.max(...c.strips.map((s) => s.centre_x + s.half_length)) * mm,
        }));
        const gap = 4, wide = ends.reduce((sum, e) => sum + e.right - e.left + gap, gap), tall = Math.max(...ends.map((e) => e.high - e.low));
        const scale = Math.min(480 / wide, 215 / tall), height = 300, sign = v.side === "left" ? -1 : 1;
        const peak = Math.max(...contacts.map((c) => c.peak));
        let cursor = (560 - wide * scale) / 2 + gap * scale, svg = "";
        const middle = 138;
        contacts.forEach((c, i) => {
            const e = ends[i], centre = (e.low + e.high) / 2;
            const atX = (y) => cursor + (sign > 0 ? y - e.left : e.right - y) * scale, atY = (x) => middle - (x - centre) * scale;
            const shades = Array.from({ length: 8 }, () => ""), cells = 12;
            let edges = "", outline = "";
            c.strips.forEach((s, k) => {
                const [x0, x1] = [atX((s.y - s.width / 2) * mm), atX((s.y + s.width / 2) * mm)].sort((p, q) => p - q);
                for (let j = 0; j < cells; j++) {
                    const t = (j + 0.5) / cells * 2 - 1, p = (s.peak_pressure * Math.sqrt(1 - t * t)) / peak;
                    const from = atY((s.centre_x + s.half_length * (((j + 1) / cells) * 2 - 1)) * mm), to = atY((s.centre_x + s.half_length * ((j / cells) * 2 - 1)) * mm);
                    shades[Math.min(7, Math.floor(p * 8))] += `M${x0.toFixed(1)} ${from.toFixed(1)}H${x1.toFixed(1)}V${to.toFixed(1)}H${x0.toFixed(1)}Z`;
                }
                outline += `M${x0.toFixed(1)} ${atY((s.centre_x + s.half_length) * mm).toFixed(1)}H${x1.toFixed(1)}V${atY((s.centre_x - s.half_length) * mm).toFixed(1)}H${x0.toFixed(1)}Z`;
                const f = c.forces[k];
                if (f?.state === 1) edges += `M${x0.toFixed(1)} ${atY(f.separatrix * mm).toFixed(1)}H${x1.toFixed(1)}`;
            });
            const largest = Math.max(...c.field.map((p) => Math.hypot(p.traction_x, p.traction_y)), 0);
            const arrows = largest > 0 ? c.field.filter((p) => p.state !== 0).map((p) => {
                const length = (Math.max(9, 0.95 * c.step * mm * scale)) / largest;
                return arrow(atX(p.y * mm), atY(p.x * mm), sign * p.traction_y * length, -p.traction_x * length, 4);
            }).join("") : "";
            svg += `<path class="outline" d="${outline}"/>` + shades.map((d, n) => `<path class="pressure" style="fill-opacity:${(0.1 + 0.11 * n).toFixed(2)}" d="${d}"/>`).join("")
                + `<path class="separatrix" d="${edges}"/><path class="arrows" d="${arrows}"/>`
                + `<text class="number" x="${((atX(e.left * 1) + atX(e.right * 1)) / 2).toFixed(1)}" y="${(middle + (tall * scale) / 2 + 22).toFixed(1)}" text-anchor="middle">${i + 1}</text>`;
            cursor += (e.right - e.left + gap) * scale;
        });
        const bar = niceAbove(wide / 14) || 1;
        svg += `<path class="bar" d="M24 284v5h${(bar * scale).toFixed(1)}v-5"/><text x="${24 + bar * scale + 8}" y="289">${tick(bar)} mm</text>`
            + `<path class="separatrix" d="M140 285h24"/><text x="170" y="289">stick ahead of it, slip behind</text>`
            + `<path class="arrows" d="${arrow(440, 285, 24, 0, 6)}"/><text x="470" y="289">traction</text>`
            + `<path class="arrows" d="${arrow(16, 50, 0, -26, 6)}"/><text x="24" y="34">x</text>`
            + Array.from({ length: 8 }, (_, n) => `<rect class="pressure" style="fill-opacity:${(0.1 + 0.11 * n).toFixed(2)}" x="${440 + 10 * n}" y="8" width="10" height="10"/>`).join("")
            + `<text x="434" y="17" text-anchor="end">0</text><text x="520" y="34" text-anchor="end">${show(peak / 1e6, 3)} MPa</text>`;
        const said = contacts.map((c, i) => `contact ${i + 1}: ${show(ends[i].high - ends[i].low, 3)} mm long, ${show(ends[i].right - ends[i].left, 3)} mm wide, `
            + `peak pressure ${show(c.peak / 1e6, 3)} MPa, ${show(100 * c.result.adhesion, 3)} % sticks`);
        return picture(560, height, "Patches, pressure and tractions", said.join("; "), svg);
    },

    draw(v, found, at) {
        at("section").innerHTML = this.drawSection(v, found);
        at("patches").innerHTML = this.drawPatches(v, found);
        const { wrench, contacts } = found;
        const rows = [
            ["place y", "mm", (c) => (found.position.lateral + c.origin[1]) * 1e3], ["angle", "°", (c) => (c.angle * 180) / Math.PI],
            ["rolling radius", "mm", (c) => c.radius * 1e3], ["load", "kN", (c) => c.normal_force / 1e3],
            ["share in the sum", "", (c) => c.share], ["area", "mm²", (c) => c.summary.area * 1e6], ["peak pressure", "MPa", (c) => c.peak / 1e6],
            ["longitudinal creepage", "%", (c) => c.creepages[0] * 100], ["lateral creepage", "%", (c) => c.creepages[1] * 100],
            ["spin", "1/m", (c) => c.creepages[2]], ["creep force on the rail, along", "N", (c) => c.result.fx],
            ["creep force on the rail, across", "N", (c) => c.result.fy], ["friction in use", "%", (c) => (100 * Math.hypot(c.result.fx, c.result.fy)) / c.summary.friction_bound],
            ["sticks", "%", (c) => 100 * c.result.adhesion],
        ];
        at("contacts").innerHTML = `<thead><tr><th scope="col">contact</th>${contacts.map((_, i) => `<th scope="col">${i + 1}</th>`).join("")}</tr></thead><tbody>`
            + rows.map(([name, unit, value]) => `<tr><th scope="row">${name}${unit ? ` [${unit}]` : ""}</th>${contacts.map((c) => `<td>${data(value(c))}</td>`).join("")}</tr>`).join("") + "</tbody>";
        const six = [["force forward", "N", wrench.force[0]], ["force to the right", "N", wrench.force[1]], ["force down", "N", wrench.force[2]],
            ["moment, roll", "N m", wrench.moment[0]], ["moment about the axle", "N m", wrench.moment[1]], ["moment, yaw", "N m", wrench.moment[2]],
            ["height of the centre, down", "mm", found.position.vertical * 1e3], ["dissipation", "W", wrench.dissipation]];
        at("wrench").innerHTML = six.map(([name, unit, value]) => `<div><dt>${name}</dt><dd>${data(value, unit)}</dd></div>`).join("");
    },
};
