"use strict";

const MODELS = ["TOTAL", "STRIP", "STRIP_1967", "STRIP_1967_CONTINUOUS", "LINEAR"];
const MATERIALS = { steel: [82, 0.28], aluminium: [26, 0.34], "cast iron": [44, 0.26], polymer: [0.9, 0.38], rubber: [0.001, 0.49] };
const CREEPAGES = { longitudinal: ["longitudinal creepage", "%", 1e-2], lateral: ["lateral creepage", "%", 1e-2], spin: ["spin", "1/m", 1] };

const axesOf = (v) => v.shape === "axes";
const radiiOf = (v) => v.shape !== "axes";
const hasLaw = (v) => v.law;
const materialFields = (body, key) => [
    { key: `m${key}`, label: `Material of the ${body}`, kind: "choice", options: [...Object.keys(MATERIALS), "other"], value: "steel",
      sets: (name) => MATERIALS[name] && { [`G${key}`]: MATERIALS[name][0], [`nu${key}`]: MATERIALS[name][1] } },
    { key: `G${key}`, label: `Shear modulus G of the ${body}`, unit: "GPa", power: 9, value: 82, low: 1e-4, high: 300, scale: "log", with: `m${key}` },
    { key: `nu${key}`, label: `Poisson’s ratio ν of the ${body}`, unit: "", power: 0, value: 0.28, low: 0, high: 0.5, scale: "linear", with: `m${key}` },
];

// The first view: one elliptic contact.
const contactView = {
    name: "contact",
    groups: [
        { title: "Motion", fields: [
            { key: "vx", label: "Longitudinal creepage", unit: "%", power: -2, value: 0.1, high: 3, scale: "cube", symbol: "longitudinal" },
            { key: "vy", label: "Lateral creepage", unit: "%", power: -2, value: 0, high: 3, scale: "cube", symbol: "lateral" },
            { key: "phi", label: "Spin", unit: "1/m", power: 0, value: 0.4, high: 20, scale: "cube", symbol: "spin" },
        ] },
        { title: "Load and shape", fields: [
            { key: "N", label: "Load N", unit: "kN", power: 3, value: 80, low: 0, high: 250, scale: "linear" },
            { key: "shape", label: "Ellipse from", kind: "choice", options: { radii: "the radii of the bodies", axes: "its semi-axes" }, value: "radii" },
            { key: "ly", label: "Rail head radius", unit: "mm", power: -3, value: 300, high: 10, scale: "radius", when: radiiOf },
            { key: "ux", label: "Wheel rolling radius", unit: "mm", power: -3, value: 460, high: 10, scale: "radius", when: radiiOf },
            { key: "uy", label: "Wheel profile radius", unit: "mm", power: -3, value: Infinity, high: 10, scale: "radius", when: radiiOf },
            { key: "lx", label: "Rail (roller) radius along x", unit: "mm", power: -3, value: Infinity, high: 10, scale: "radius", when: radiiOf },
            { key: "a", label: "Semi-axis a along x", unit: "mm", power: -3, value: 6, low: 0.1, high: 50, scale: "log", when: axesOf },
            { key: "b", label: "Semi-axis b along y", unit: "mm", power: -3, value: 4.5, low: 0.1, high: 50, scale: "log", when: axesOf },
        ] },
        { title: "Friction", fields: [
            { key: "mu", label: "Friction μ", unit: "", power: 0, value: 0.3, low: 0, high: 1, scale: "linear" },
            { key: "law", label: "Velocity-dependent (falling) friction", kind: "check", value: false },
            { key: "A", label: "Ratio A (fast to slow)", unit: "", power: 0, value: 0.4, low: 0, high: 1, scale: "linear", when: hasLaw },
            { key: "B", label: "Decay B", unit: "s/m", power: 0, value: 0.6, low: 0, high: 2, scale: "linear", when: hasLaw },
            { key: "V", label: "Rolling speed", unit: "m/s", power: 0, value: 20, low: 0, high: 100, scale: "linear", when: hasLaw },
            { key: "k", label: "Slope factor (layer)", unit: "", power: 0, value: 1, low: 0.05, high: 1, scale: "linear", when: hasLaw },
        ] },
        { title: "Materials", closed: true, fields: [...materialFields("rail", "1"), ...materialFields("wheel", "2")] },
        { title: "Pictures", fields: [
            { key: "model", label: "Model of the patch", kind: "choice", options: ["STRIP", "STRIP_1967", "STRIP_1967_CONTINUOUS"], value: "STRIP" },
            { key: "sweep", label: "Creep curves against", kind: "choice", value: "longitudinal",
              options: { longitudinal: "longitudinal creepage", lateral: "lateral creepage", spin: "spin" } },
        ] },
    ],

    // The inputs as structures in the library's memory.
    prepare(library, v) {
        const body = (g, nu) => library.make("kstrip_material", { shear_modulus: g, poisson_ratio: nu });
        const pair = library.make("kstrip_combined_material"), made = { contact: library.make("kstrip_contact"), status: 0 };
        library.call("material_combine", body(v.G1, v.nu1), body(v.G2, v.nu2), pair);
        if (v.shape === "axes") {
            library.write(made.contact, { a: v.a, b: v.b, normal_force: v.N, friction: v.mu, ...library.read(pair) });
        } else {
            const radii = library.make("kstrip_radii", { lower_x: v.lx, lower_y: v.ly, upper_x: v.ux, upper_y: v.uy });
            const ellipse = library.make("kstrip_hertz_contact");
            made.status = library.call("contact_from_hertz", radii, pair, v.N, v.mu, made.contact, ellipse);
            made.ellipse = library.read(ellipse);
        }
        made.creepage = library.make("kstrip_creepage", { longitudinal: v.vx, lateral: v.vy, spin: v.phi });
        made.law = v.law
            ? library.make("kstrip_friction", { friction: v.mu, ratio: v.A, decay: v.B, rolling_speed: v.V, slope_factor: v.k })
            : null;
        return made;
    },

    compute(library, v) {
        const made = this.prepare(library, v), warnings = [];
        const found = { contact: library.read(made.contact), ellipse: made.ellipse, models: [], warnings };
        if (made.status > 0) warnings.push(["Hertz", library.message(made.status)]);

        // All models at the creepage of the sliders
        const result = library.make("kstrip_result"), friction = library.allocate("double");
        const outputs = library.make("kstrip_outputs", { result, friction });
        for (const name of MODELS) {
            const status = library.call("evaluate", made.contact, made.creepage, made.law, this.options(library, name), outputs);
            if (status > 0) warnings.push([name, library.message(status)]);
            found.models.push({ name, ...library.read(result), friction: library.read(friction) });
        }
        about("derivatives", () => this.computeDerivatives(library, made, found));
        about("contact patch", () => this.computePatch(library, v, made, found));
        about("creep curves", () => this.computeCurves(library, v, made, found));
        return found;
    },

    options(library, model, strips = 0) {
        return library.make("kstrip_options", { model: library.constants[`KSTRIP_MODEL_${model}`], strips });
    },

    computeDerivatives(library, made, found) {
        const derivatives = library.make("kstrip_derivatives"), outputs = library.make("kstrip_outputs", { derivatives });
        library.call("evaluate", made.contact, made.creepage, made.law, this.options(library, "TOTAL"), outputs);
        found.derivatives = library.read(derivatives);
    },

    // Strips and tractions of the model that draws the patch.
    computePatch(library, v, made, found) {
        const { a, b } = found.contact;
        if (!(found.contact.normal_force > 0)) return;
        const capacity = library.constants.KSTRIP_STRIPS_CAPACITY;
        const strips = library.allocate("kstrip_strip", capacity), count = library.allocate("uint32_t");
        const result = library.make("kstrip_result"), outputs = library.make("kstrip_outputs", { strips, count, capacity, result });
        library.call("evaluate", made.contact, made.creepage, made.law, this.options(library, v.model, capacity), outputs);
        found.strips = library.readAll(strips, library.read(count));
        found.patch = library.read(result);

        // A grid of points with one distance in both directions
        const step = Math.max(a, b) / 7.5;
        const line = (half) => Array.from({ length: 2 * Math.floor(half / step - 0.2) + 1 }, (_, i, n = Math.floor(half / step - 0.2)) => (i - n) * step);
        const xs = line(a), ys = line(b), size = xs.length * ys.length, points = library.allocate("kstrip_point", size);
        library.call("field", made.contact, made.creepage, made.law, this.options(library, v.model),
            library.doubles(xs), xs.length, library.doubles(ys), ys.length, points, size);
        found.grid = { xs, ys, step };
        found.field = library.readAll(points, size).map((point, i) => ({ ...point, x: xs[i % xs.length], y: ys[Math.floor(i / xs.length)] }));
    },

    // Creep curves of all models, and points of FASTSIM.
    computeCurves(library, v, made, found) {
        const { contact } = found, { a, b } = contact, bound = contact.friction * contact.normal_force;
        const current = { longitudinal: v.vx, lateral: v.vy, spin: v.phi }, here = current[v.sweep];
        const scale = CREEPAGES[v.sweep][2];
        let most = v.sweep === "spin" ? 2 : 1e-2, kalker = null;
        if (a > 0 && b > 0) {
            const coefficients = library.allocate("double", 4);
            library.call("linear_coefficients", a / b, contact.poisson_ratio, coefficients);
            kalker = library.readAll(coefficients, 4);
            const slope = v.sweep === "longitudinal" ? kalker[0] : v.sweep === "lateral" ? kalker[1] : kalker[2] * Math.sqrt(a * b);
            if (bound > 0) most = (4 * bound) / (contact.shear_modulus * a * b * slope);
        }
        most = niceAbove(Math.max(most, 1.1 * Math.abs(here)) / scale) * scale;
        const half = v.law ? 24 : 40;
        const places = Array.from({ length: 2 * half + 1 }, (_, i) => Math.sign(i - half) * Math.abs((i - half) / half) ** 1.5 * most);
        const component = v.sweep === "longitudinal" ? "fx" : "fy";
        const result = library.make("kstrip_result"), outputs = library.make("kstrip_outputs", { result });
        const creepage = library.make("kstrip_creepage", current), force = library.member(result, component);
        found.curves = MODELS.map((name) => {
            const options = this.options(library, name);
            const points = places.map((place) => {
                library.write(creepage, { [v.sweep]: place });
                library.call("evaluate", made.contact, creepage, made.law, options, outputs);
                return [place / scale, library.read(force)];
            });
            return { name, points };
        });
        const others = found.models.map((model) => [model.name, model[component]]);
        found.curve = { most: most / scale, here: here / scale, component, others, bound, places };
        if (kalker && !v.law && bound > 0) {
            const motion = (place) => Object.values({ ...current, [v.sweep]: place });
            found.fastsim = Array.from({ length: 21 }, (_, i) => {
                const place = ((i - 10) / 10) * most;
                return [place / scale, fastsim(contact, motion(place), kalker)[component]];
            });
            found.fastsimHere = fastsim(contact, Object.values(current), kalker);
        }
    },

    // The forces of the default model, in words.
    sentence(v, found) {
        const { contact } = found, total = found.models[0], strip = found.models.find((model) => model.name === v.model);
        if (!(contact.normal_force > 0)) return "The contact is lost. It carries no force.";
        const bound = total.friction * contact.normal_force, used = bound > 0 ? Math.hypot(total.fx, total.fy) / bound : 0;
        return `Creep force on the rail (TOTAL): ${direction(total.fx, total.fy)}, ${show(used * 100, 3)} % of the friction bound μN. `
            + `The stick area is ${show(100 * strip.adhesion, 3)} % of the patch (${v.model}).`;
    },

    drawPatch(v, found) {
        const { a, b } = found.contact, title = "Contact patch";
        if (!found.strips) return picture(420, 400, title, "no contact", `<text class="label" x="210" y="200" text-anchor="middle">no contact</text>`);
        const side = 330, range = niceAbove(Math.max(a, b) * 1.12 * 1e3 / 2) * 2 > Math.max(a, b) * 2.4e3
            ? Math.max(a, b) * 1.3e3 : niceAbove(Math.max(a, b) * 1.12 * 1e3 / 2) * 2;
        const { atX, atY, svg } = axes([62, 12, side, side], [-range, range], [-range, range], ["y to the right [mm]", "x rolling direction [mm]"]);
        const mm = 1e3;
        let stick = "", slip = "";
        const rectangle = (y0, y1, x0, x1) => `M${atX(y0 * mm).toFixed(2)} ${atY(x0 * mm).toFixed(2)}H${atX(y1 * mm).toFixed(2)}V${atY(x1 * mm).toFixed(2)}H${atX(y0 * mm).toFixed(2)}Z`;
        for (const s of found.strips) {
            const [y0, y1] = [s.y - s.width / 2, s.y + s.width / 2], limit = a * 1.05;
            const sticks = s.state === 1 && s.separatrix < s.half_length;
            const edge = sticks ? Math.max(s.separatrix, -limit) : limit;
            slip += rectangle(y0, y1, -limit, edge);
            if (sticks) stick += rectangle(y0, y1, edge, limit);
        }
        const ellipse = `cx="${atX(0)}" cy="${atY(0)}" rx="${(atX(b * mm) - atX(0)).toFixed(2)}" ry="${(atY(0) - atY(a * mm)).toFixed(2)}"`;
        const largest = Math.max(...found.field?.map((p) => Math.hypot(p.traction_x, p.traction_y)) ?? [0]);
        let arrows = "", faulty = "";
        for (const p of found.field ?? []) {
            if (p.state === 0 || !(largest > 0)) continue;
            const length = (0.95 * found.grid.step * mm * (atX(1) - atX(0))) / largest;
            const one = arrow(atX(p.y * mm), atY(p.x * mm), p.traction_y * length, -p.traction_x * length, 5);
            if (p.state === 3) faulty += one;
            else arrows += one;
        }
        const key = (x, className, text) => `<rect class="${className}" x="${x}" y="386" width="14" height="14" rx="2"/><text x="${x + 20}" y="397">${text}</text>`;
        const content = `<defs><clipPath id="rim"><ellipse ${ellipse}/></clipPath></defs>${svg}`
            + `<g clip-path="url(#rim)"><path class="slip" d="${slip}"/><path class="stick" d="${stick}"/></g>`
            + `<ellipse class="rim" ${ellipse}/><path class="arrows" d="${arrows}"/><path class="arrows faulty" d="${faulty}"/>`
            + `<g class="key">${key(62, "stick", "stick")}${key(132, "slip", "slip")}<path class="arrows" d="${arrow(196, 393, 22, 0, 6)}"/>`
            + `<text x="224" y="397">traction on the rail</text></g>`;
        const pressure = (1.5 * found.contact.normal_force) / (Math.PI * a * b);
        return picture(420, 408, title,
            `ellipse ${show(2 * a * mm, 3)} mm long and ${show(2 * b * mm, 3)} mm wide, peak pressure ${show(pressure / 1e6, 3)} MPa, ${show(found.patch.adhesion * 100, 3)} % stick area`,
            content);
    },

    drawCurves(v, found) {
        const { most, here, component, others, bound } = found.curve;
        const top = bound > 0 ? (1.15 * bound) / 1e3 : 1;
        const [label, unit] = CREEPAGES[v.sweep];
        const { atX, atY, svg } = axes([62, 12, 470, 330], [-most, most], [-top, top],
            [`${label} [${unit}]`, `${component === "fx" ? "longitudinal" : "lateral"} force on the rail [kN]`], [8, 8]);
        const lines = found.curves.map(({ name, points }) =>
            `<path class="curve ${name}" d="${path(points.map(([x, y]) => [atX(x), atY(Math.max(-2 * top, Math.min(2 * top, y / 1e3)))]))}"/>`).reverse().join("");
        const rings = (found.fastsim ?? []).map(([x, y]) => `<circle class="fastsim" cx="${atX(x).toFixed(1)}" cy="${atY(y / 1e3).toFixed(1)}" r="3.2"/>`).join("");
        const dots = others.map(([name, force]) => Math.abs(force / 1e3) <= top
            ? `<circle class="dot ${name}" cx="${atX(here).toFixed(1)}" cy="${atY(force / 1e3).toFixed(1)}" r="4"/>` : "").reverse().join("");
        const content = `<defs><clipPath id="frame"><rect x="62" y="12" width="470" height="330"/></clipPath></defs>${svg}`
            + `<path class="here" d="M${atX(here).toFixed(1)} 12V342"/><g clip-path="url(#frame)">${lines}${rings}${dots}</g>`;
        return picture(548, 382, "Creep curves", `force against ${label} from ${show(-most)} to ${show(most)} ${unit}; at ${show(here)} ${unit} `
            + others.map(([name, force]) => `${name} ${show(force / 1e3, 3)} kN`).join(", "), content);
    },

    draw(v, found, at) {
        at("patch").innerHTML = this.drawPatch(v, found);
        at("curves").innerHTML = this.drawCurves(v, found);
        const { contact, ellipse } = found, mm = 1e3;
        const bound = contact.friction * contact.normal_force;
        const area = Math.PI * contact.a * contact.b, peak = area > 0 ? (1.5 * contact.normal_force) / area : 0;
        at("facts").innerHTML = [
            ["semi-axis a along x", data(contact.a * mm, "mm")], ["semi-axis b along y", data(contact.b * mm, "mm")],
            ["peak pressure", data((ellipse?.peak_pressure ?? peak) / 1e6, "MPa")],
            ...(ellipse ? [["approach", data(ellipse.approach * 1e6, "µm")]] : []),
            ["friction bound μN", data(bound, "N")], ["material mismatch κ", data(contact.mismatch)],
        ].map(([name, value]) => `<div><dt>${name}</dt><dd>${value}</dd></div>`).join("");
        const rows = found.models.map((m) => {
            const limit = m.friction * contact.normal_force;
            return `<tr data-model="${m.name}"><th scope="row"><span class="swatch ${m.name}"></span>${m.name}</th><td data-of="fx">${data(m.fx)}</td>`
                + `<td data-of="fy">${data(m.fy)}</td><td data-of="mz">${data(m.mz)}</td><td>${limit > 0 ? data((100 * Math.hypot(m.fx, m.fy)) / limit, "", 3) : "–"}</td>`
                + `<td data-of="adhesion">${m.adhesion < 0 ? "–" : data(m.adhesion * 100, "", 3)}</td><td data-of="power">${data(m.power)}</td>`
                + `<td data-of="friction">${data(m.friction, "", 3)}</td></tr>`;
        });
        if (found.fastsimHere) {
            const { fx, fy } = found.fastsimHere;
            rows.push(`<tr><th scope="row"><span class="swatch fastsim"></span>FASTSIM 10 × 10</th><td>${data(fx)}</td><td>${data(fy)}</td><td>–</td>`
                + `<td>${data((100 * Math.hypot(fx, fy)) / bound, "", 3)}</td><td>–</td><td>–</td><td>${data(contact.friction, "", 3)}</td></tr>`);
        }
        at("models").innerHTML = rows.join("");
        const d = found.derivatives, row = (name, i) => `<tr><th scope="row">${name}</th>`
            + [0, 1, 2].map((k) => `<td>${data(d.jacobian[3 * i + k])}</td>`).join("") + `<td>${data(d.load_through_hertz[i])}</td><td>${data(d.friction[i])}</td></tr>`;
        at("derivatives").innerHTML = row("Fx [N]", 0) + row("Fy [N]", 1) + row("Mz [N m]", 2);
    },
};
