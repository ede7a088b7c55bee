"use strict";

// Reads a profile from the text of a file: columns y and z, as text, CSV, Simpack (.prr, .prw) or MiniProf (.ban, .whl).
// Returns { y, z, notes }, in mm, z down, a wheel's flange at small y. An error names the line that is wrong.
function readProfile(text, isWheel) {
    const y = [], z = [], notes = [];
    const isSimpack = /^\s*point\.begin/m.test(text), hasHeader = isSimpack || /^\s*"?\w+"?\s*=/m.test(text);
    let inside = !isSimpack, off = 0, missing = 0, columns = null;
    text.split(/\r\n|\r|\n/).forEach((line, i) => {
        if (/^\s*point\.(begin|end)/.test(line)) inside = isSimpack && line.includes("begin");
        let words = line.replace(/(#|!|%|\/\/).*$/, "").trim();
        if (!inside || words === "" || /^point\./.test(words)) return;
        // A quotation mark before a point of MiniProf switches it off; those around the words of a table are left out
        if (hasHeader && words.startsWith('"')) {
            off += 1;
            return;
        }
        words = words.replaceAll('"', "");
        // A comma is a decimal point if another character separates the columns
        if (/[;\t ]/.test(words) && /\d,\d/.test(words) && !words.includes(".")) words = words.replace(/,(?=\d)/g, ".");
        const parts = words.split(/[\s,;]+/).filter((word) => word !== ""), numbers = parts.map((word) => Number(word.replace(/^([-+.\d]+)d/i, "$1e")));
        const place = `Line ${i + 1}: “${line.trim().slice(0, 40)}”`;
        const names = parts.map((word) => word.toLowerCase());
        if (y.length === 0 && names.includes("y") && names.includes("z")) columns = [names.indexOf("y"), names.indexOf("z")];
        else if (numbers.length >= 2 && numbers.every(Number.isFinite)) {
            if (numbers.length > 2 && !hasHeader && !columns) throw new Error(`${place} has ${numbers.length} numbers. Name the columns y and z in the first line.`);
            const pair = (columns ?? [0, 1]).map((column) => numbers[column]);
            if (pair.some((one) => Math.abs(one) === 9999)) missing += 1;
            else [y, z].forEach((all, k) => all.push(pair[k]));
        } else if (y.length > 0 && !/^[\w.]+\s*=/.test(words)) {
            throw new Error(`${place} is not a pair of numbers.`);
        }
    });
    if (y.length === 0) throw new Error("There are no pairs of numbers in this file. It needs two columns: y and z of the profile.");
    if (y.length < 4) throw new Error(`A profile needs at least 4 points; this file has ${y.length}.`);

    const least = (all) => all.reduce((one, other) => Math.min(one, other)), most = (all) => all.reduce((one, other) => Math.max(one, other));
    // The width of a profile is some centimetres
    const inMetres = most(y) - least(y) < 1;
    if (inMetres) for (let i = 0; i < y.length; i++) {
        y[i] *= 1e3;
        z[i] *= 1e3;
    }
    notes.push(`${y.length} points in ${inMetres ? "m" : "mm"}`);
    if (off > 0) notes.push(`switched-off points left out: ${off}`);
    if (missing > 0) notes.push(`missing points (9999) left out: ${missing}`);
    // Flange and sides of the head are far from the median and below
    const median = [...z].sort((p, q) => p - q)[z.length >> 1];
    if (median - least(z) > most(z) - median) {
        for (let i = 0; i < z.length; i++) z[i] = -z[i];
        notes.push("z pointed up and was turned");
    }
    if (isWheel) {
        const tip = y[z.indexOf(most(z))];
        if (tip > (most(y) + least(y)) / 2) {
            for (let i = 0; i < y.length; i++) y[i] = -y[i];
            notes.push("the flange was at large y: mirrored");
        }
    }
    return { y, z, notes };
}

// The kind of profile that the name of a file states; undefined for other names.
function kindOfFile(name) {
    if (/\.(prw|whl|wheel)$|wheel/i.test(name)) return "wheel";
    if (/\.(prr|ban|rail)$|rail/i.test(name)) return "rail";
    return undefined;
}
