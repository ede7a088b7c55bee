"use strict";

// The second view: a wheel on a rail, from two profiles.
const wheelView = {
    name: "wheel",
    groups: [
        { title: "Position", fields: [
            { key: "shift", label: "Lateral shift to the right", unit: "mm", power: -3, value: 2, low: -12, high: 12, scale: "linear" },
            { key: "yaw", label: "Yaw to the right", unit: "mrad", power: -3, value: 2, low: -30, high: 30, scale: "linear" },
            { key: "Q", label: "Vertical load Q (the rail’s support)", unit: "kN", power: 3, value: 80, low: 1, high: 200, scale: "linear" },
            { key: "side", label: "Wheel", kind: "choice", options: { right: "right wheel", left: "left wheel" }, value: "right" },
        ] },
        { title: "Motion", fields: [
            { key: "v", label: "Speed", unit: "m/s", power: 0, value: 20, low: 0.1, high: 100, scale: "linear" },
            { key: "turn", label: "Axle speed above that of pure rolling", unit: "%", power: -2, value: 0, high: 3, scale: "cube" },
            { key: "drift", label: "Lateral velocity", unit: "mm/s", power: -3, value: 0, high: 300, scale: "cube" },
        ] },
        { title: "Profiles", fields: [
            { key: "rail", label: "Rail", kind: "file", builtin: "60E1", value: "60E1" },
            { key: "wheel", label: "Wheel", kind: "file", builtin: "S1002", value: "S1002" },
            { key: "R", label: "Wheel radius", unit: "mm", power: -3, value: 460, low: 150, high: 650, scale: "linear" },
            { key: "origin", label: "Rail origin, outward from the running circle", unit: "mm", power: -3, value: 10.5325, low: -40, high: 40, scale: "linear" },
            { key: "cant", label: "Roll angle added to the rail", unit: "mrad", power: -3, value: 0, low: -60, high: 60, scale: "linear" },
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
    points: {},

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
            library.release();
            this.memory = {
                rail: library.make("kstrip_surface"), wheel: library.make("kstrip_surface"), workspace: library.make("kstrip_wheel_workspace"), of: {},
            };
            library.keep();
        }
        for (const kind of ["rail", "wheel"]) {
            const key = kind === "rail" ? v.cant : 0, of = this.memory.of[kind];
            if (of && of.points === this.points[kind] && of.key === key && of.smooth === v.smooth) continue;
            delete this.memory.of[kind];
            const { y, z } = this.pointsOf(kind, v);
            about(`profile of the ${kind}`, () => this.prepareProfile(library, y, z, v.smooth, this.memory[kind]));
            this.memory.of[kind] = { points: this.points[kind], key, smooth: v.smooth };
        }
    },

    // y, z: points [m]. smooth: smoothing length [m].
    prepareProfile(library, y, z, smooth, surface) {
        return library.call("prepare_profile", library.doubles(y), library.doubles(z), y.length, 0, smooth, surface);
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
        this.prepare(library, v);
        const inputs = this.inputs(v), { rail, wheel, workspace } = this.memory;
        const model = library.constants[`KSTRIP_MODEL_${v.m}`];
        const pair = library.make("kstrip_wheel_pair", { ...inputs.pair, model });
        const position = library.make("kstrip_wheel_position", inputs.position);
        const velocity = library.make("kstrip_wheel_velocity", inputs.velocity);
        const vertical = library.member(position, "vertical"), wrench = library.make("kstrip_wrench");
        const warnings = [];
        const warn = (name, status) => {
            const text = library.message(status);
            if (status > 0 && !warnings.some((one) => one[1] === text)) warnings.push([name, text]);
        };
        warn("Height", library.call("height_for_load", rail, wheel, pair, position, inputs.load, velocity, null, null, workspace, vertical));
        warn("Wheel on rail", library.call("wheel_on_rail", rail, wheel, pair, position, velocity, null, workspace, wrench, null, null));

        const found = { wrench: library.read(wrench), position: library.read(position), warnings, inputs, contacts: [] };
        const count = library.read(library.member(workspace, "count")), contacts = library.member(workspace, "contacts");
        for (let i = 0; i < count; i++) {
            found.contacts.push(about(`contact ${i + 1}`, () => this.contactAt(library, library.element(contacts, i), velocity, model, warn)));
        }
        return found;
    },

    // One contact: place, creepages, forces, strips and tractions.
    contactAt(library, pointer, velocity, model, warn) {
        const contact = library.read(pointer), patch = library.member(pointer, "patch");
        const motion = library.make("kstrip_motion"), summary = library.make("kstrip_patch_summary");
        library.call("wheel_motion", pointer, velocity, motion);
        contact.motion = library.read(motion);
        const speed = Math.abs(contact.motion.rolling_speed) || 1;
        contact.creepages = [contact.motion.slip_x, contact.motion.slip_y, contact.motion.spin_rate].map((one) => one / speed);
        library.call("patch_summarize", patch, summary);
        contact.summary = library.read(summary);
        contact.strips = contact.patch.strips.slice(0, contact.patch.count);
        contact.peak = Math.max(0, ...contact.strips.map((strip) => strip.peak_pressure));
        this.computeStrips(library, contact, patch, warn);

        // The wrench of this contact alone: its pressure is along the normal, its creep forces are in the plane of the contact
        const wrench = library.make("kstrip_wrench");
        library.write(pointer, { share: 1 });
        warn("Contact", library.call("wrench_from_contacts", pointer, 1, velocity, model, null, wrench, null));
        library.write(pointer, { share: contact.share });
        const [x, y, z] = library.read(wrench).force, right = contact.left ? -y : y;
        contact.result.fx = -x;
        contact.result.fy = -right * Math.cos(contact.angle) - z * Math.sin(contact.angle);
        return contact;
    },

    // Strips and tractions of STRIP at the mean slip of a contact.
    computeStrips(library, contact, patch, warn) {
        const creepage = library.make("kstrip_creepage", Object.fromEntries(Object.keys(CREEPAGES).map((key, i) => [key, contact.creepages[i]])));
        const options = library.make("kstrip_options", { model: library.constants.KSTRIP_MODEL_STRIP });
        const capacity = library.constants.KSTRIP_PATCH_CAPACITY;
        const result = library.make("kstrip_result"), strips = library.allocate("kstrip_strip", capacity), count = library.allocate("uint32_t");
        const outputs = library.make("kstrip_outputs", { result, strips, count, capacity });
        warn("Patch", library.call("patch_evaluate", patch, creepage, null, options, outputs));
        contact.result = library.read(result);
        contact.forces = library.readAll(strips, library.read(count));

        // Thirteen points along x, and in the middle of each strip or of each second, third .. strip
        const low = Math.min(...contact.strips.map((s) => s.centre_x - s.half_length));
        const high = Math.max(...contact.strips.map((s) => s.centre_x + s.half_length));
        const step = (high - low) / 13, every = Math.max(1, Math.round(step / contact.strips[0].width));
        const xs = Array.from({ length: 13 }, (_, i) => low + (i + 0.5) * step);
        const ys = contact.strips.map((strip) => strip.y).filter((_, i) => i % every === every >> 1);
        const size = xs.length * ys.length, points = library.allocate("kstrip_point", size);
        library.call("patch_field", patch, creepage, null, options, library.doubles(xs), xs.length, library.doubles(ys), ys.length, points, size);
        contact.grid = { xs, ys, step };
        contact.field = library.readAll(points, size).map((p, i) => ({ ...p, x: xs[i % xs.length], y: ys[Math.floor(i / xs.length)] }));
    },

    sentence(v, found) {
        const { wrench, contacts } = found;
        if (contacts.length === 0) return "The wheel is lifted. No force acts on it.";
        const places = contacts.length === 1 ? "one contact" : `${contacts.length} contacts`;
        const worst = contacts.reduce((most, one) => (one.normal_force > most.normal_force ? one : most));
        return `${places[0].toUpperCase()}${places.slice(1)}. On the wheel: ${direction(wrench.force[0], wrench.force[1])}, `
            + `${show(Math.abs(wrench.force[2]))} N ${wrench.force[2] < 0 ? "up" : "down"}. `
            + `The most loaded contact has a peak pressure of ${show(worst.peak / 1e6, 3)} MPa and a contact angle of ${show((worst.angle * 180) / Math.PI, 3)}°.`;
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

    // The outline of the stick area of a contact: from the separatrix of each strip to its leading edge, around strips side by side.
    stickArea(contact, atX, atY) {
        let d = "", ahead = [], behind = [], end = NaN;
        const close = () => {
            if (ahead.length > 0) d += `M${[...ahead, ...behind.reverse()].map((point) => point.map((one) => one.toFixed(1)).join(" ")).join("L")}Z`;
            [ahead, behind] = [[], []];
        };
        contact.forces.forEach((force, k) => {
            const strip = contact.strips[k], sides = [strip.y - strip.width / 2, strip.y + strip.width / 2];
            const separatrix = Math.max(force.separatrix, strip.centre_x - strip.half_length), lead = strip.centre_x + strip.half_length;
            // An area that is less than a unit of the picture long would be a mere line
            const sticks = force.state === 1 && Math.abs(atY(lead) - atY(separatrix)) >= 1;
            if (!sticks || Math.abs(sides[0] - end) > 1e-3 * strip.width) close();
            if (!sticks) return;
            for (const side of sides) {
                ahead.push([atX(side), atY(lead)]);
                behind.push([atX(side), atY(separatrix)]);
            }
            end = sides[1];
        });
        close();
        return d;
    },

    // Each contact in its plane: pressure by strength of the colour, the stick area, tractions on the rail.
    drawPatches(v, found) {
        const mm = 1e3, contacts = found.contacts;
        if (contacts.length === 0) return picture(560, 120, "Contact patches", "no contact", `<text class="label" x="280" y="64" text-anchor="middle">no contact</text>`);
        const ends = contacts.map((c) => ({
            left: Math.min(...c.strips.map((s) => s.y - s.width / 2)) * mm, right: Math.max(...c.strips.map((s) => s.y + s.width / 2)) * mm,
            low: Math.min(...c.strips.map((s) => s.centre_x - s.half_length)) * mm, high: Math.max(...c.strips.map((s) => s.centre_x + s.half_length)) * mm,
        }));
        const gap = 4, wide = ends.reduce((sum, e) => sum + e.right - e.left + gap, gap), tall = Math.max(...ends.map((e) => e.high - e.low));
        const scale = Math.min(480 / wide, 215 / tall), height = 300, sign = v.side === "left" ? -1 : 1;
        const peak = Math.max(...contacts.map((c) => c.peak));
        let cursor = (560 - wide * scale) / 2 + gap * scale, svg = "";
        const middle = 138, strength = (n) => (0.1 + 0.11 * n).toFixed(2);
        contacts.forEach((c, i) => {
            const e = ends[i], centre = (e.low + e.high) / 2;
            const atX = (y) => cursor + (sign > 0 ? y - e.left : e.right - y) * scale, atY = (x) => middle - (x - centre) * scale;
            const levels = Array.from({ length: 8 }, () => ""), cells = 12;
            let outline = "";
            c.strips.forEach((s) => {
                const [x0, x1] = [atX((s.y - s.width / 2) * mm), atX((s.y + s.width / 2) * mm)].sort((p, q) => p - q);
                for (let j = 0; j < cells; j++) {
                    const t = (j + 0.5) / cells * 2 - 1, p = (s.peak_pressure * Math.sqrt(1 - t * t)) / peak;
                    const from = atY((s.centre_x + s.half_length * (((j + 1) / cells) * 2 - 1)) * mm), to = atY((s.centre_x + s.half_length * ((j / cells) * 2 - 1)) * mm);
                    levels[Math.min(7, Math.floor(p * 8))] += `M${x0.toFixed(1)} ${from.toFixed(1)}H${x1.toFixed(1)}V${to.toFixed(1)}H${x0.toFixed(1)}Z`;
                }
                outline += `M${x0.toFixed(1)} ${atY((s.centre_x + s.half_length) * mm).toFixed(1)}H${x1.toFixed(1)}V${atY((s.centre_x - s.half_length) * mm).toFixed(1)}H${x0.toFixed(1)}Z`;
            });
            const largest = Math.max(...c.field.map((p) => Math.hypot(p.traction_x, p.traction_y)), 0);
            const arrows = largest > 0 ? c.field.filter((p) => p.state !== 0).map((p) => {
                const length = (Math.max(9, 0.95 * c.grid.step * mm * scale)) / largest;
                return arrow(atX(p.y * mm), atY(p.x * mm), sign * p.traction_y * length, -p.traction_x * length, 4);
            }).join("") : "";
            svg += `<path class="outline" d="${outline}"/>` + levels.map((d, n) => `<path class="pressure" style="fill-opacity:${strength(n)}" d="${d}"/>`).join("")
                + `<path class="stick outlined" d="${this.stickArea(c, (y) => atX(y * mm), (x) => atY(x * mm))}"/><path class="arrows" d="${arrows}"/>`
                + `<text class="number" x="${((atX(e.left * 1) + atX(e.right * 1)) / 2).toFixed(1)}" y="${(middle + (tall * scale) / 2 + 22).toFixed(1)}" text-anchor="middle">${i + 1}</text>`;
            cursor += (e.right - e.left + gap) * scale;
        });
        const bar = niceAbove(wide / 14) || 1;
        const shades = Array.from({ length: 8 }, (_, n) => `<rect class="pressure" style="fill-opacity:${strength(n)}" x="${440 + 10 * n}" y="8" width="10" height="10"/>`);
        svg += `<g class="key"><path class="bar" d="M24 284v5h${(bar * scale).toFixed(1)}v-5"/><text x="${24 + bar * scale + 8}" y="289">${tick(bar)} mm</text>`
            + `<rect class="stick outlined" x="150" y="278" width="14" height="12"/><text x="171" y="289">stick area</text>`
            + `<path class="arrows" d="${arrow(370, 285, 24, 0, 6)}"/><text x="400" y="289">traction on the rail</text>`
            + `<path class="arrows" d="${arrow(16, 50, 0, -26, 6)}"/><text x="24" y="34">x</text>`
            + `${shades.join("")}<text x="434" y="17" text-anchor="end">0</text><text x="520" y="34" text-anchor="end">${show(peak / 1e6, 3)} MPa</text></g>`;
        const said = contacts.map((c, i) => `contact ${i + 1}: ${show(ends[i].high - ends[i].low, 3)} mm long, ${show(ends[i].right - ends[i].left, 3)} mm wide, `
            + `peak pressure ${show(c.peak / 1e6, 3)} MPa, ${show(100 * c.result.adhesion, 3)} % stick area`);
        return picture(560, height, "Contact patches, pressure and tractions", said.join("; "), svg);
    },

    draw(v, found, at) {
        at("section").innerHTML = this.drawSection(v, found);
        at("patches").innerHTML = this.drawPatches(v, found);
        const { wrench, contacts } = found;
        const rows = [
            ["position y", "mm", (c) => (found.position.lateral + c.origin[1]) * 1e3], ["contact angle", "°", (c) => (c.angle * 180) / Math.PI],
            ["rolling radius", "mm", (c) => c.radius * 1e3], ["load", "kN", (c) => c.normal_force / 1e3],
            ["weight in the sum", "", (c) => c.share], ["area", "mm²", (c) => c.summary.area * 1e6], ["peak pressure", "MPa", (c) => c.peak / 1e6],
            ["longitudinal creepage", "%", (c) => c.creepages[0] * 100], ["lateral creepage", "%", (c) => c.creepages[1] * 100],
            ["spin", "1/m", (c) => c.creepages[2]], ["longitudinal creep force on the rail", "N", (c) => c.result.fx],
            ["lateral creep force on the rail", "N", (c) => c.result.fy], ["|F|/μN", "%", (c) => (100 * Math.hypot(c.result.fx, c.result.fy)) / c.summary.friction_bound],
            ["stick area", "%", (c) => 100 * c.result.adhesion],
        ];
        at("contacts").innerHTML = `<thead><tr><th scope="col">contact</th>${contacts.map((_, i) => `<th scope="col">${i + 1}</th>`).join("")}</tr></thead><tbody>`
            + rows.map(([name, unit, value]) => `<tr><th scope="row">${name}${unit ? ` [${unit}]` : ""}</th>${contacts.map((c) => `<td>${data(value(c))}</td>`).join("")}</tr>`).join("") + "</tbody>";
        const six = [["force forward", "N", wrench.force[0]], ["force to the right", "N", wrench.force[1]], ["force down", "N", wrench.force[2]],
            ["roll moment", "N m", wrench.moment[0]], ["pitch moment (about the axle)", "N m", wrench.moment[1]], ["yaw moment", "N m", wrench.moment[2]],
            ["vertical position of the centre, down", "mm", found.position.vertical * 1e3], ["frictional power", "W", wrench.dissipation]];
        at("wrench").innerHTML = six.map(([name, unit, value]) => `<div><dt>${name}</dt><dd>${data(value, unit)}</dd></div>`).join("");
    },
};
