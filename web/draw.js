"use strict";

// Text and pictures. Pictures are SVG, coloured by classes of style.css, so that they follow light and dark.

// A number for people: four digits, thousands apart, a real minus.
function show(value, digits = 4) {
    if (!Number.isFinite(value)) return Number.isNaN(value) ? "–" : value > 0 ? "∞" : "−∞";
    if (value === 0) return "0";
    const size = Math.abs(value);
    if (size < 1e-3 || size >= 1e7) return value.toExponential(digits - 2).replace(/-/g, "−").replace("e+", "e");
    const places = Math.max(0, Math.min(6, digits - 1 - Math.floor(Math.log10(size))));
    const [whole, part] = size.toFixed(places).split(".");
    const grouped = whole.replace(/\B(?=(\d{3})+$)/g, "\u202f");
    return (value < 0 ? "−" : "") + grouped + (part ? `.${part}` : "");
}

// A number with its unit; all digits are in the attribute `value`.
function data(value, unit = "", digits = 4) {
    return `<data value="${value}">${show(value, digits)}${unit ? `\u00a0${unit}` : ""}</data>`;
}

function escape(text) {
    return String(text).replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]);
}

// A text as a sentence, with a capital letter and a full stop.
function sentenceOf(text) {
    return `${text[0].toUpperCase()}${text.slice(1)}${text.endsWith(".") ? "" : "."}`;
}

// The least of 1, 2, 5 times a power of ten that is at least `value`.
function niceAbove(value) {
    const power = 10 ** Math.floor(Math.log10(value));
    return [1, 2, 5, 10].map((n) => n * power).find((n) => n >= value * (1 - 1e-9));
}

function ticks(low, high, most = 6) {
    const step = niceAbove((high - low) / most);
    const found = [];
    for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) found.push(Number((i * step).toPrecision(12)));
    return found;
}

function tick(value) {
    return String(value).replace("-", "−");
}

// A frame with axes. `box` is [left, top, width, height] in the picture's own units; x and y are [least, largest], drawn at the left and
// bottom. Returns the functions of the coordinates and the markup of the axes.
function axes(box, x, y, labels, most = [6, 6]) {
    const [left, top, width, height] = box;
    const atX = (v) => left + ((v - x[0]) / (x[1] - x[0])) * width;
    const atY = (v) => top + height - ((v - y[0]) / (y[1] - y[0])) * height;
    let lines = "", text = "";
    for (const v of ticks(Math.min(...x), Math.max(...x), most[0])) {
        lines += `M${atX(v).toFixed(1)} ${top}V${top + height}`;
        text += `<text x="${atX(v).toFixed(1)}" y="${top + height + 15}" text-anchor="middle">${tick(v)}</text>`;
    }
    for (const v of ticks(Math.min(...y), Math.max(...y), most[1])) {
        lines += `M${left} ${atY(v).toFixed(1)}H${left + width}`;
        text += `<text x="${left - 6}" y="${(atY(v) + 4).toFixed(1)}" text-anchor="end">${tick(v)}</text>`;
    }
    const zero = (x[0] <= 0 && x[1] >= 0 ? `M${atX(0).toFixed(1)} ${top}V${top + height}` : "")
        + (Math.min(...y) <= 0 && Math.max(...y) >= 0 ? `M${left} ${atY(0).toFixed(1)}H${left + width}` : "");
    const svg = `<path class="grid" d="${lines}"/><path class="zero" d="${zero}"/><g class="ticks">${text}</g>`
        + `<text class="label" x="${left + width / 2}" y="${top + height + 33}" text-anchor="middle">${labels[0]}</text>`
        + `<text class="label" transform="translate(${left - 44} ${top + height / 2}) rotate(-90)" text-anchor="middle">${labels[1]}</text>`;
    return { atX, atY, svg };
}

// A path through points, broken where a number is missing.
function path(points) {
    let d = "", pen = "M";
    for (const [x, y] of points) {
        if (!Number.isFinite(x) || !Number.isFinite(y)) {
            pen = "M";
            continue;
        }
        d += `${pen}${x.toFixed(1)} ${y.toFixed(1)}`;
        pen = "L";
    }
    return d;
}

// An arrow as a part of a path; short ones are dots.
function arrow(x, y, dx, dy, head = 4) {
    const size = Math.hypot(dx, dy);
    if (size < 0.4) return "";
    const [ux, uy] = [dx / size, dy / size], h = Math.min(head, size * 0.6);
    const [ex, ey] = [x + dx, y + dy];
    const side = (s) => `${(ex - h * (ux - s * uy * 0.6)).toFixed(1)} ${(ey - h * (uy + s * ux * 0.6)).toFixed(1)}`;
    return `M${x.toFixed(1)} ${y.toFixed(1)}L${ex.toFixed(1)} ${ey.toFixed(1)}M${side(1)}L${ex.toFixed(1)} ${ey.toFixed(1)}L${side(-1)}`;
}

// The markup of a picture; its title and description are read by screen readers.
function picture(width, height, title, description, content) {
    return `<svg viewBox="0 0 ${width} ${height}" role="img" aria-label="${escape(title)}: ${escape(description)}"><title>${escape(title)}</title>`
        + `${content}</svg>`;
}

// Where a vector of x (forward) and y (right) points, in words.
function direction(fx, fy) {
    const along = `${show(Math.abs(fx))} N ${fx < 0 ? "backward" : "forward"}`;
    const across = `${show(Math.abs(fy))} N to the ${fy < 0 ? "left" : "right"}`;
    return `${along} and ${across}`;
}
