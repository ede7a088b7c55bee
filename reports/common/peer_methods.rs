//! The methods of `benches/peers` as one kind of function, for the reports. The file that includes
//! this one includes the module `peers` too.

use crate::peers::fastsim::{Bound, Flexibility, Grid, Layout};
use crate::peers::{Input, Output, fastrip, fastsim};
use kstrip::contact::Contact;
use kstrip::contact::creepage::Creepage;
use kstrip::linear::LinearCoefficients;
use kstrip_testing::reference::{Answer, Case, CoefficientCase, Errors};

/// A contact in motion as the other methods want it, with the library's linear coefficients.
pub fn input_of(contact: &Contact<f64>, motion: &Creepage<f64>) -> Input {
    let Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, .. } = *contact;
    let Creepage { longitudinal, lateral, spin } = *motion;
    let LinearCoefficients { c11, c22, c23, .. } = LinearCoefficients::at(a / b, poisson_ratio);
    Input {
        a,
        b,
        normal_force,
        shear_modulus,
        poisson_ratio,
        friction,
        longitudinal,
        lateral,
        spin,
        c11,
        c22,
        c23,
    }
}

/// The contact of a case as the other methods want it. For the cases of `open.csv` they get the
/// linear coefficients that CONTACT itself computed, else those of the library.
pub fn input(case: &Case, table: &[CoefficientCase]) -> Input {
    let known = table
        .iter()
        .find(|c| c.axis_ratio == case.axis_ratio && c.poisson_ratio == case.poisson_ratio);
    let c = LinearCoefficients::at(case.axis_ratio, case.poisson_ratio);
    let [c11, c22, c23, _] = known.map_or([c.c11, c.c22, c.c23, c.c33], |known| known.reference);
    Input { c11, c22, c23, ..input_of(&case.contact(), &case.motion()) }
}

/// A method: forces in units of `μ N` from a contact in motion.
pub type Solver = Box<dyn Fn(&Input) -> Output>;

/// FASTSIM on a square grid, `LANES` strips side by side (1: the classical loop).
pub fn fastsim_on<const M: usize, const LANES: usize>(
    layout: Layout, flexibility: Flexibility, bound: Bound,
) -> (String, Solver) {
    let grid = Grid::<M, M>::new(layout);
    let flexibilities = match flexibility {
        Flexibility::Three => "3 flexibilities",
        Flexibility::Kalker => "1 flexibility (1982)",
        Flexibility::Energy => "1 flexibility (energy)",
        Flexibility::Blended => "blended as in CONTACT",
    };
    let name = match bound {
        Bound::Parabolic => "parabolic",
        Bound::Elliptic => "elliptic",
    };
    (
        format!("FASTSIM {M}x{M}, {flexibilities}, {name}"),
        Box::new(move |input| fastsim::solve::<M, M, LANES>(&grid, input, flexibility, bound)),
    )
}

/// FaStrip on strips, ten side by side.
pub fn fastrip_on<const X: usize, const Y: usize>(flexibility: Flexibility) -> (String, Solver) {
    let grid = Grid::<X, Y>::new(Layout::StripCentres);
    let name = if flexibility == Flexibility::Energy { "energy" } else { "1982" };
    (
        format!("FaStrip {X}x{Y}, flexibility ({name})"),
        Box::new(move |input| fastrip::solve::<X, Y, 10>(&grid, input, flexibility)),
    )
}

/// FaStrip as CONTACT describes its own, ten rows side by side.
pub fn fastrip_contact_on<const M: usize>() -> (String, Solver) {
    let grid = Grid::<M, M>::new(Layout::Rectangle);
    (
        format!("FaStrip {M}x{M} as in CONTACT"),
        Box::new(move |input| fastrip::solve_contact::<M, M, 10>(&grid, input)),
    )
}

/// The errors of a method on some cases.
pub fn peer_errors(cases: &[Case], table: &[CoefficientCase], solve: &Solver) -> Errors {
    Errors::of(cases, |case| {
        let output = solve(&input(case, table));
        Answer { force: [output.fx, output.fy], moment: output.mz, stick: f64::NAN }
    })
}
