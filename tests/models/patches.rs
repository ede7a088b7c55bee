//! Patches of no particular shape.

use crate::prelude::*;

pub type Full = Patch<f64>;

/// An irregular patch: one to three lobes, random lengths, pressures, frictions, centres.
pub fn irregular(random: &mut Random) -> Full {
    let mut strips = Vec::new();
    let mut y = random.between(-8e-3, 0.0);
    for _ in 0..1 + random.bits() % 3 {
        for _ in 0..2 + random.bits() % 12 {
            let width = random.between(0.2e-3, 0.8e-3);
            strips.push(PatchStrip {
                y: y + width / 2.0,
                width,
                half_length: random.between(2e-3, 7e-3),
                centre_x: random.between(-1e-3, 1e-3),
                peak_pressure: random.between(0.2e9, 1.5e9),
                friction: random.between(0.05, 0.5),
            });
            y += width;
        }
        y += random.between(1e-3, 4e-3);
    }
    Full::from_strips(&strips, 82e9, 0.28).unwrap()
}

/// Ellipses side by side, with so many strips each, about their centres.
pub fn side_by_side(ellipses: &[(Contact<f64>, f64)], count: StripCount) -> Full {
    let alone = |c: &Contact<f64>| Full::from_ellipse(c, count).unwrap();
    let mut strips = Vec::new();
    for (c, centre) in ellipses {
        let shifted = |strip: &PatchStrip<f64>| PatchStrip { y: strip.y + centre, ..*strip };
        strips.extend(alone(c).used().iter().map(shifted));
    }
    let Full { area_scale, lever_scale, .. } = alone(&ellipses[0].0);
    Full { area_scale, lever_scale, ..Full::from_strips(&strips, 82e9, 0.28).unwrap() }
}

/// The results of all strips.
pub fn strips_of_patch(
    patch: &PatchView<f64>, motion: &Creepage<f64>, model: Model,
) -> Vec<StripResult<f64>> {
    let mut found = Vec::new();
    solver::patch_strips(patch, motion, model, &mut |strip| found.push(strip)).unwrap();
    found
}

/// From adhesion to sliding.
pub fn motion(random: &mut Random) -> Creepage<f64> {
    let size = random.log_between(1e-5, 1e-1);
    creep(
        size * random.between(-1.0, 1.0),
        size * random.between(-1.0, 1.0),
        size * random.between(-300.0, 300.0),
    )
}
