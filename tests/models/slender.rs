//! Slender contacts, `a/b` .015 to .12 and 8 to 60, against CONTACT: `tests/data/open_slender.csv`;
//! and creepages of any size whose slip spin turns around within the contact, against boundary
//! elements: `tests/data/boundary_elements.csv`. Nothing is fitted on them.

use crate::prelude::*;
use kstrip_testing::reference::*;

/// Axis ratios from and to; allowed of TOTAL and of STRIP: mean and 95th percentile of the force,
/// mean of the moment.
const BINS: [([f64; 2], [f64; 3], [f64; 3]); 7] = [
    ([0.015, 0.03], [0.006, 0.018, 0.010], [0.010, 0.035, 0.05]),
    ([0.03, 0.06], [0.006, 0.018, 0.010], [0.010, 0.035, 0.05]),
    ([0.06, 0.12], [0.006, 0.018, 0.010], [0.010, 0.035, 0.05]),
    ([8.0, 12.0], [0.006, 0.018, 0.010], [0.010, 0.035, 0.05]),
    ([12.0, 20.0], [0.006, 0.018, 0.020], [0.010, 0.035, 0.05]),
    ([20.0, 40.0], [0.006, 0.018, 0.020], [0.010, 0.035, 0.05]),
    ([40.0, 60.1], [0.006, 0.018, 0.040], [0.010, 0.035, 0.05]),
];

#[test]
fn slender_contacts_are_those_of_contact() {
    within(&slender(), &BINS);
}

fn within(cases: &[Case], bins: &[([f64; 2], [f64; 3], [f64; 3])]) {
    for (model, column) in [(Model::Total, 0), (Model::Strip, 1)] {
        let errors = Errors::of_model::<f64>(cases, &sixteen(model));
        for ([low, high], of_total, of_strip) in bins.iter().copied() {
            let part = errors.only(cases, |case| (low..high).contains(&case.axis_ratio));
            let (force, moment) = (figures(&part.force), figures(&part.moment));
            println!("{model:?} {low} to {high}: force {force:?} moment {moment:?}");
            let [mean, p95, moments] = [of_total, of_strip][column];
            let within = force.mean <= mean && force.p95 <= p95 && moment.mean <= moments;
            assert!(within, "{model:?} {low} to {high}: {force:?} {moment:?}");
        }
    }
}

/// Axis ratios from and to; allowed of TOTAL and of STRIP: mean and 95th percentile of the force,
/// mean of the moment.
const TURNING: [([f64; 2], [f64; 3], [f64; 3]); 2] = [
    ([0.01, 7.0], [0.006, 0.020, 0.010], [0.010, 0.035, 0.010]),
    ([7.0, 66.0], [0.010, 0.032, 0.025], [0.010, 0.030, 0.017]),
];

#[test]
fn slip_that_spin_turns_around_is_that_of_boundary_elements() {
    within(&turning(), &TURNING);
}
