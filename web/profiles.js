"use strict";

// Reads a profile from the text of a file: columns y and z, as text, CSV, Simpack (.prr, .prw) or MiniProf (.ban, .whl).
// Returns { y, z, notes }, in mm, z down, a wheel's flange at small y. An error says which line is wrong.
function readProfile(text, isWheel) {
    const y = [], z = [], notes = [];
    const isSimpack = /^\s*point\.begin/m.test(text);
    let inside = !isSimpack, left = 0;
    text.split(/\r\n|\r|\n/).forEach((line, i) => {
        if (/^\s*point\.(begin|end)/.test(line)) inside = isSimpack && line.includes("begin");
        let words = line.replace(/(#|!|%|\/\/).*$/, "").trim();
        if (!inside || words === "" || /^point\./.test(words)) return;
        // MiniProf: points that its user has switched off
        if (words.startsWith('"')) {
            left += 1;
            return;
        }
        // A comma is a decimal point where columns are divided by something else
        if (/[;\t ]/.test(words) && /\d,\d/.test(words) && !words.includes(".")) words = words.replace(/,(?=\d)/g, ".");
        const numbers = words.split(/[\s,;]+/).filter((word) => word !== "").slice(0, 2).map(Number);
        if (numbers.length === 2 && numbers.every(Number.isFinite)) {
            y.push(numbers[0]);
            z.push(numbers[1]);
        } else if (y.length > 0 && !/^[\w.]+\s*=/.test(words)) {
            throw new Error(`Line ${i + 1} is not a pair of numbers: “${line.trim().slice(0, 40)}”.`);
        }
    });
    if (y.length === 0) throw new Error("There are no pairs of numbers in this file. It needs two columns: y and z of the profile.");
    if (y.length < 4) throw new Error(`A profile needs at least 4 points; this file has ${y.length}.`);

    // The width of a profile is some centimetres
    const width = Math.max(...y) - Math.min(...y);
    const inMetres = width < 1;
    if (inMetres) for (let i = 0; i < y.length; i++) {
        y[i] *= 1e3;
        z[i] *= 1e3;
    }
    notes.push(`${y.length} points in ${inMetres ? "m" : "mm"}`);
    if (left > 0) notes.push(`${left} points with a quotation mark were left out`);
    // Flange and sides of the head are far from the median and below
    const median = [...z].sort((p, q) => p - q)[z.length >> 1];
    if (median - Math.min(...z) > Math.max(...z) - median) {
        for (let i = 0; i < z.length; i++) z[i] = -z[i];
        notes.push("z pointed up and was turned");
    }
    if (isWheel) {
        const tip = y[z.indexOf(Math.max(...z))];
        if (tip > (Math.max(...y) + Math.min(...y)) / 2) {
            for (let i = 0; i < y.length; i++) y[i] = -y[i];
            notes.push("the flange was at large y: mirrored");
        }
    }
    return { y, z, notes };
}

// What a file is, from its name; undefined where the name does not say it.
function kindOfFile(name) {
    if (/\.(prw|whl|wheel)$|wheel/i.test(name)) return "wheel";
    if (/\.(prr|ban|rail)$|rail/i.test(name)) return "rail";
    return undefined;
}
