"use strict";

// Inputs, state, link, copies. `page` holds the state; the tests read it.
const page = { views: { contact: contactView, wheel: wheelView }, view: "contact", shown: {}, library: null, milliseconds: 0, ready: null };
const $ = (id) => document.getElementById(id);
const fieldsOf = (view) => view.groups.flatMap((group) => group.fields);
const isNumber = (field) => field.kind === undefined;
const isUsed = (field, shown) => !field.when || field.when(shown);

// A displayed number in SI units, rounded once: "0.1" per cent is 0.001.
function inSI(field, value) {
    if (!isNumber(field) || !Number.isFinite(value)) return value;
    const [digits, exponent = "0"] = String(value).split("e");
    return Number(`${digits}e${Number(exponent) + field.power}`);
}

// An input of the user that is not right, in words.
class InputError extends Error {}

// The inputs in SI units.
function valuesOf(view) {
    const shown = page.shown[view.name];
    const bad = fieldsOf(view).find((field) => isUsed(field, shown) && Number.isNaN(shown[field.key]));
    if (bad) throw new InputError(`“${bad.label}” is not a number.`);
    return Object.fromEntries(fieldsOf(view).map((field) => [field.key, inSI(field, shown[field.key])]));
}

// Position of a slider, -500 to 500 or 0 to 1000, from a displayed value, and back.
const sliders = {
    linear: { range: [0, 1000], to: (f, x) => (1000 * (x - f.low)) / (f.high - f.low), from: (f, t) => f.low + ((f.high - f.low) * t) / 1000 },
    log: { range: [0, 1000], to: (f, x) => (1000 * Math.log(x / f.low)) / Math.log(f.high / f.low), from: (f, t) => f.low * (f.high / f.low) ** (t / 1000) },
    // fine near zero
    cube: { range: [-500, 500], to: (f, x) => 500 * Math.cbrt(x / f.high), from: (f, t) => f.high * (t / 500) ** 3 },
    // curvature, fine near flat; `high` is the smallest radius
    radius: { range: [-500, 500], to: (f, x) => 500 * Math.cbrt(f.high / x), from: (f, t) => (t === 0 ? Infinity : f.high / (t / 500) ** 3) },
};

// Values of a slider have three digits, or two places where they are around zero.
function rounded(field, value) {
    if (!Number.isFinite(value)) return value;
    if (field.scale === "linear") return Number(value.toFixed(field.high - field.low > 20 ? 1 : 3)) + 0;
    return Number(value.toPrecision(3)) + 0;
}

const FILE_HINT = "Drop a file here, or choose one: columns y and z, .prr, .prw, .ban, .whl.";

function makeRow(view, field) {
    const row = document.createElement("div"), id = `${view.name}-${field.key}`;
    row.className = `row ${field.kind ?? "number"}`;
    row.dataset.key = field.key;
    if (field.kind === "choice") {
        const options = Array.isArray(field.options) ? field.options.map((name) => [name, name]) : Object.entries(field.options);
        row.innerHTML = `<label for="${id}">${field.label}</label><select id="${id}">${options.map(([key, name]) => `<option value="${key}">${name}</option>`).join("")}</select>`;
        row.querySelector("select").addEventListener("change", (event) => {
            Object.assign(page.shown[view.name], field.sets?.(event.target.value) ?? {});
            change(view, field, event.target.value);
        });
    } else if (field.kind === "check") {
        row.innerHTML = `<input type="checkbox" id="${id}"><label for="${id}">${field.label}</label>`;
        row.querySelector("input").addEventListener("change", (event) => change(view, field, event.target.checked));
    } else if (field.kind === "file") {
        row.innerHTML = `<label for="${id}">${field.label}: <span class="now"></span></label><input type="file" id="${id}" aria-describedby="${id}-notes">`
            + `<p class="notes" id="${id}-notes" role="status">${FILE_HINT}</p>`
            + `<div class="tools" hidden><button type="button" class="mirror">Mirror y</button><button type="button" class="turn">Turn z</button><button type="button" class="builtin">Back to ${field.builtin}</button></div>`;
        row.querySelector("input").addEventListener("change", (event) => event.target.files[0] && readFile(field.key, event.target.files[0]));
        row.querySelector(".builtin").addEventListener("click", () => useProfile(field.key, field.builtin, PROFILES[field.builtin], FILE_HINT));
        const negated = (axis) => () => {
            const points = wheelView.points[field.key], turned = { y: points.y, z: points.z, [axis]: points[axis].map((one) => -one) };
            useProfile(field.key, page.shown.wheel[field.key], turned, axis === "y" ? "y was mirrored." : "z was turned.");
        };
        row.querySelector(".mirror").addEventListener("click", negated("y"));
        row.querySelector(".turn").addEventListener("click", negated("z"));
    } else {
        const [low, high] = sliders[field.scale].range;
        const unit = field.unit ? ` in ${field.unit}` : "";
        row.innerHTML = `<label for="${id}">${field.label}</label><input type="range" id="${id}" min="${low}" max="${high}" step="1">`
            + `<input type="number" id="${id}-number" step="any" aria-label="${escape(field.label)}${unit}"${field.scale === "radius" ? ' placeholder="flat"' : ""}>`
            + `<span class="unit" aria-hidden="true">${field.unit}</span>`;
        const [slider, number] = row.querySelectorAll("input");
        slider.addEventListener("input", () => change(view, field, rounded(field, sliders[field.scale].from(field, Number(slider.value)))));
        // An empty radius is flat; any other text that is no number is NaN, and valuesOf() refuses it
        number.addEventListener("input", () => {
            const isFlat = field.scale === "radius" && number.value === "" && !number.validity.badInput;
            change(view, field, isFlat ? Infinity : number.valueAsNumber, number);
        });
        number.addEventListener("change", () => showInputs(view));
        // An arrow key moves a number by one in its second digit
        number.addEventListener("keydown", (event) => {
            if (event.key !== "ArrowUp" && event.key !== "ArrowDown") return;
            event.preventDefault();
            const value = page.shown[view.name][field.key];
            if (!Number.isFinite(value)) return;
            const step = 10 ** Math.floor(Math.log10(Math.abs(value) || (field.high ?? 1)) - 1);
            change(view, field, Number((value + (event.key === "ArrowUp" ? step : -step)).toPrecision(10)));
        });
    }
    return row;
}

function makeControls(view) {
    const form = $(`controls-${view.name}`);
    form.addEventListener("submit", (event) => event.preventDefault());
    for (const group of view.groups) {
        const set = document.createElement("fieldset");
        const inner = group.closed ? document.createElement("details") : set;
        if (group.closed) set.setAttribute("aria-label", group.title);
        else set.innerHTML = `<legend class="title">${group.title}</legend>`;
        if (group.closed) {
            inner.innerHTML = `<summary class="title">${group.title}</summary>`;
            set.append(inner);
        }
        inner.append(...group.fields.map((field) => makeRow(view, field)));
        form.append(set);
    }
    const reset = document.createElement("button");
    reset.type = "button";
    reset.className = "reset";
    reset.textContent = "Reset all inputs";
    reset.addEventListener("click", () => {
        setDefaults(view);
        showInputs(view);
        schedule();
    });
    form.append(reset);
}

function setDefaults(view) {
    page.shown[view.name] = Object.fromEntries(fieldsOf(view).map((field) => [field.key, field.value]));
    for (const { key, builtin } of fieldsOf(view).filter((field) => field.kind === "file")) {
        view.points[key] = PROFILES[builtin];
        showNotes($(`${view.name}-${key}-notes`), FILE_HINT);
    }
}

function change(view, field, value, typed) {
    page.shown[view.name][field.key] = value;
    if (field.with) page.shown[view.name][field.with] = "other";
    showInputs(view, typed);
    schedule();
}

// Puts the state into the inputs; a field in which somebody types is left alone.
function showInputs(view, typed) {
    const shown = page.shown[view.name];
    for (const field of fieldsOf(view)) {
        const input = $(`${view.name}-${field.key}`), row = input.closest(".row"), value = shown[field.key];
        row.hidden = !isUsed(field, shown);
        if (field.kind === "choice") input.value = value;
        else if (field.kind === "check") input.checked = value;
        else if (field.kind === "file") {
            row.querySelector(".now").textContent = value;
            row.querySelector(".tools").hidden = value === field.builtin;
        } else {
            const [low, high] = sliders[field.scale].range;
            const number = $(`${input.id}-number`);
            number.setAttribute("aria-invalid", String(Number.isNaN(value)));
            if (number !== typed) number.value = Number.isFinite(value) ? value : "";
            if (Number.isNaN(value)) continue;
            input.value = Math.max(low, Math.min(high, Math.round(sliders[field.scale].to(field, value))));
            input.setAttribute("aria-valuetext", Number.isFinite(value) ? `${show(value)} ${field.unit}` : "flat");
        }
    }
}

// ---------------------------------------------------------------- profiles

function showNotes(element, notes, isBad = false) {
    element.textContent = notes;
    element.classList.toggle("problem", isBad);
}

function useProfile(kind, name, points, notes, isBad = false) {
    showNotes($(`wheel-${kind}-notes`), notes, isBad);
    if (isBad) return;
    wheelView.points[kind] = points;
    page.shown.wheel[kind] = name;
    showInputs(wheelView);
    schedule();
}

async function readFile(kind, file) {
    try {
        const points = readProfile(await file.text(), kind === "wheel"), smooth = page.shown.wheel.smooth * 1e-3 || 0;
        page.library.release();
        const [y, z] = [points.y, points.z].map((all) => all.map((one) => one * 1e-3));
        wheelView.prepareProfile(page.library, y, z, smooth, page.library.make("kstrip_surface"));
        useProfile(kind, file.name, points, `${points.notes.join("; ")}.`);
    } catch (error) {
        useProfile(kind, file.name, null, `${file.name} was not read. ${sentenceOf(error.message)}`, true);
    }
    $(`wheel-${kind}`).value = "";
}

function acceptDrops() {
    const rowOf = (event) => event.target.closest?.(".row.file");
    const unmark = () => document.querySelectorAll(".row.file.over").forEach((row) => row.classList.remove("over"));
    addEventListener("dragover", (event) => {
        event.preventDefault();
        unmark();
        rowOf(event)?.classList.add("over");
    });
    addEventListener("drop", (event) => {
        event.preventDefault();
        unmark();
        const file = event.dataTransfer.files[0];
        if (!file) return;
        const kind = rowOf(event)?.dataset.key ?? kindOfFile(file.name);
        choose("wheel");
        if (kind) readFile(kind, file);
        else useProfile("wheel", file.name, null, `Is ${file.name} a rail or a wheel? Drop it on one of these two fields.`, true);
    });
}

// ---------------------------------------------------------------- the link

function linkOf(view) {
    const shown = page.shown[view.name];
    const parts = fieldsOf(view).filter((field) => !Object.is(shown[field.key], field.value) && !Number.isNaN(shown[field.key]))
        .map((field) => `${field.key}=${encodeURIComponent(shown[field.key] === Infinity ? "flat" : shown[field.key])}`);
    return `#${[view.name, ...parts].join("&")}`;
}

function readLink() {
    const [name, ...parts] = location.hash.slice(1).split("&");
    const view = page.views[name];
    if (!view) return;
    const given = new URLSearchParams(parts.join("&"));
    setDefaults(view);
    for (const field of fieldsOf(view)) {
        const text = given.get(field.key);
        if (text === null) continue;
        if (isNumber(field)) {
            const value = text === "flat" ? Infinity : Number(text);
            if (!Number.isNaN(value) && text !== "") page.shown[name][field.key] = value;
        } else if (field.kind === "check") page.shown[name][field.key] = text === "true";
        else if (field.kind === "choice") {
            if ((Array.isArray(field.options) ? field.options : Object.keys(field.options)).includes(text)) page.shown[name][field.key] = text;
        } else if (text !== field.builtin) {
            useProfile(field.key, text, null, `The link was made with the file ${text}. Drop this file here; ${field.builtin} is shown.`, true);
        }
    }
    showInputs(view);
    choose(name);
}

// ---------------------------------------------------------------- views, update

function choose(name) {
    page.view = name;
    for (const key of Object.keys(page.views)) {
        $(`view-${key}`).hidden = key !== name;
        $(`tab-${key}`).setAttribute("aria-selected", String(key === name));
        $(`tab-${key}`).tabIndex = key === name ? 0 : -1;
    }
    $("skip").href = `#results-${name}`;
    schedule();
}

let waiting = false;
function schedule() {
    if (waiting || !page.library) return;
    waiting = true;
    requestAnimationFrame(() => {
        waiting = false;
        update();
    });
}

function later(milliseconds, action) {
    let timer;
    return () => {
        clearTimeout(timer);
        timer = setTimeout(action, milliseconds);
    };
}
const saveLink = later(250, () => history.replaceState(null, "", linkOf(page.views[page.view])));
const speak = later(700, () => {
    const view = $(`view-${page.view}`);
    $("spoken").textContent = ["problem", "sentence", "warnings"].map((name) => view.querySelector(`[data-at=${name}]`))
        .filter((one) => !one.hidden).map((one) => one.textContent).join(" ");
});

// Computes and draws. An error is shown in place of all results: no part of an earlier result stays on display.
function update() {
    const start = performance.now(), view = page.views[page.view];
    const panel = $(`view-${view.name}`), at = (name) => panel.querySelector(`[data-at=${name}]`);
    page.library.release();
    try {
        const values = valuesOf(view);
        page.found = view.compute(page.library, values);
        view.draw(values, page.found, at);
        at("sentence").textContent = view.sentence(values, page.found);
        at("warnings").innerHTML = page.found.warnings.length === 0 ? '<li class="none">No warnings.</li>'
            : page.found.warnings.map(([name, text]) => `<li><b>${name}</b>: ${escape(text)}.</li>`).join("");
    } catch (error) {
        const isExpected = error instanceof InputError || error instanceof StatusError;
        if (!isExpected) reportError(error);
        page.found = { error: sentenceOf(isExpected ? error.message : `the demo has a fault here: ${error.message}`) };
    }
    const isBad = Boolean(page.found.error);
    at("problem").hidden = !isBad;
    at("problem").textContent = page.found.error ?? "";
    at("sentence").hidden = at("warnings").hidden = isBad;
    for (const part of panel.querySelectorAll(".computed, .pictures figure")) part.classList.toggle("empty", isBad);
    for (const id of ["copy-c", "copy-python"]) $(id).disabled = isBad;
    $("copied").textContent = "";
    if ($("show").open) showProgram();
    page.milliseconds = performance.now() - start;
    saveLink();
    speak();
}

// ---------------------------------------------------------------- copies

function programIn(language) {
    const view = page.views[page.view];
    return programs[language](view, valuesOf(view), page.found);
}

function showProgram() {
    $("program").textContent = page.found.error ? "" : programIn("c");
}

async function copy(text, what) {
    try {
        await navigator.clipboard.writeText(text);
    } catch {
        // Without permission for the clipboard, a selection is copied
        const area = document.createElement("textarea");
        area.value = text;
        document.body.append(area);
        area.select();
        const done = document.execCommand("copy");
        area.remove();
        if (!done) {
            $("copied").textContent = `The browser does not allow copying. Select the ${what} below.`;
            $("show").open = true;
            return;
        }
    }
    $("copied").textContent = `The ${what} is in the clipboard.`;
}

// ---------------------------------------------------------------- begin

function makeLegend() {
    for (const [name, label] of [...MODELS.map((model) => [model, model]), ["fastsim", "FASTSIM 10 × 10"]]) {
        const button = document.createElement("button");
        button.type = "button";
        button.setAttribute("aria-pressed", "true");
        button.innerHTML = `<span class="swatch ${name}"></span>${label}`;
        button.title = "Show or hide this curve";
        button.addEventListener("click", () => {
            const on = button.getAttribute("aria-pressed") !== "true";
            button.setAttribute("aria-pressed", String(on));
            document.querySelector("[data-at=curves]").classList.toggle(`without-${name}`, !on);
        });
        $("legend").append(button);
        const sheet = document.styleSheets[0];
        sheet.insertRule(`.without-${name} :is(.curve, .dot, circle).${name} { display: none; }`, sheet.cssRules.length);
    }
}

async function begin() {
    try {
        const packed = Uint8Array.from(atob(WASM), (c) => c.charCodeAt(0));
        const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
        const { instance } = await WebAssembly.instantiate(await new Response(stream).arrayBuffer(), {});
        page.library = new Library(instance, HEADER);
    } catch (error) {
        $("broken").hidden = false;
        $("broken").textContent = `This browser cannot run the library (${error.message}). A browser from 2023 or later with WebAssembly is needed.`;
        return;
    }
    $("version").textContent = page.library.call("version_string");
    for (const view of Object.values(page.views)) {
        makeControls(view);
        setDefaults(view);
        showInputs(view);
    }
    makeLegend();
    acceptDrops();
    const tabs = Object.keys(page.views);
    tabs.forEach((name, i) => {
        $(`tab-${name}`).addEventListener("click", () => choose(name));
        $(`tab-${name}`).addEventListener("keydown", (event) => {
            const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
            if (!step) return;
            const next = tabs[(i + step + tabs.length) % tabs.length];
            choose(next);
            $(`tab-${next}`).focus();
        });
    });
    $("copy-c").addEventListener("click", () => copy(programIn("c"), "C program"));
    $("copy-python").addEventListener("click", () => copy(programIn("python"), "Python program"));
    $("copy-link").addEventListener("click", () => copy(location.href.split("#")[0] + linkOf(page.views[page.view]), "link"));
    $("show").addEventListener("toggle", () => $("show").open && showProgram());
    addEventListener("hashchange", readLink);
    readLink();
    update();
}
page.ready = begin();
