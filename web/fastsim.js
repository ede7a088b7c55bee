"use strict";

// FASTSIM, Kalker's simplified theory, for comparison: J. J. Kalker, Vehicle System Dynamics 11 (1982) 1-13. Ten strips of ten cells,
// a flexibility for each creepage, parabolic bound, bound and slip at the centres of the cells. tests/peers.rs computes
// tests/web/fastsim.csv with the method that the project's reports use, and the demo is tested against this table.
//
// contact: members of kstrip_contact [SI]. creepage: [longitudinal, lateral, spin]. coefficients: Kalker's C11, C22, C23.
// Returns fx, fy [N] on the lower body.
function fastsim(contact, creepage, [c11, c22, c23], cells = 10) {
    const { a, b, normal_force, shear_modulus: g } = contact;
    const bound = contact.friction * normal_force;
    if (!(bound > 0)) return { fx: 0, fy: 0 };
    // 1/L1 = 3 G C11/(8a), 1/L2 = 3 G C22/(8a), 1/L3 = 4 G C23/(pi a sqrt(a/b))
    const k = (3 * g) / (8 * a);
    const k1 = k * c11, k2 = k * c22, k3 = (4 * g * c23 * Math.sqrt(b / a)) / (Math.PI * a);
    const centre = (2 * bound) / (Math.PI * a * b); // 2 mu N/(pi a b): the bound at the centre of the ellipse
    let fx = 0, fy = 0;
    for (let j = 0; j < cells; j++) {
        const y = (-1 + (2 * j + 1) / cells) * b;
        const half = a * Math.sqrt(1 - (y / b) ** 2), step = (2 * half) / cells;
        let px = 0, py = 0;
        for (let i = 0; i < cells; i++) {
            const x = half * (1 - (2 * i + 1) / cells);
            px += step * (creepage[0] * k1 - creepage[2] * y * k3);
            py += step * (creepage[1] * k2 + creepage[2] * x * k3);
            const limit = centre * (1 - (x / a) ** 2 - (y / b) ** 2), size = Math.hypot(px, py);
            if (size > limit) {
                px *= limit / size;
                py *= limit / size;
            }
            const area = step * ((2 * b) / cells);
            fx += px * area;
            fy += py * area;
        }
    }
    return { fx, fy };
}
