//! Errors of a wheel on a rail by angle and range of its contacts, against conformal CONTACT; those
//! of steep contacts at equal load, each in its own plane.

use crate::prelude::*;
use crate::wheel_rail::{PAGE, mean_and_p95, rows, stand};
use kstrip_testing::patch_reference::{Row, number};

/// Mean, 95th percentile, and how many there are.
fn with_count(errors: Vec<f64>) -> ([f64; 2], usize) {
    let count = errors.len();
    (mean_and_p95(errors), count)
}

/// Loads of contacts, each with its share.
fn load_of(contacts: &[WheelContact<f64>]) -> f64 {
    contacts.iter().map(|contact| contact.share * contact.normal_force).sum()
}

/// The mean angle of contacts, weighted with their loads.
fn mean_angle(contacts: &[WheelContact<f64>]) -> f64 {
    let sum: f64 = contacts.iter().map(|c| c.share * c.normal_force * c.angle).sum();
    sum / load_of(contacts)
}

/// The steep contacts of a wheel at the height where they have a load, with its velocity.
///
/// At a given vertical load a flange's normal force follows its angle: .5 degrees are 2 % of it at
/// 70 degrees. CONTACT's plane turns by as much with the load.
fn steep_contacts(row: &Row, load: f64) -> (Vec<WheelContact<f64>>, Velocity<f64>) {
    let (mut stand, position, velocity) = stand(row);
    let (middle, angle) = (number(row, "vertical_mm") * 1e-3, number(row, "angle_deg"));
    let mut contacts = |vertical: f64| -> Vec<WheelContact<f64>> {
        stand.solve(&Position { vertical, ..position }, &velocity);
        let is_steep = |c: &&WheelContact<f64>| (c.angle.to_degrees().abs() - angle).abs() < 25.0;
        stand.memory.found().iter().filter(is_steep).copied().collect()
    };
    // the load rises with the height
    let is_low = |vertical| load_of(&contacts(vertical)) <= load;
    let [_, high] = bisect([middle - 1e-4, middle + 1e-4], 2e-16, is_low);
    let contacts = contacts(high);
    assert!((load_of(&contacts) / load - 1.0).abs() < 1e-4, "{row:?}");
    (contacts, velocity)
}

/// Error of the force in the plane of the steep contacts of a wheel, divided by `μ N`, at equal
/// load, and the range of their normals [degrees]. `kind` precedes the reference's columns. None:
/// there is no such reference.
fn steep_contact(row: &Row, kind: &str) -> Option<[f64; 2]> {
    let [load, x, s] = ["normal_force_N", "FX_N", "FS_N"].map(|name| format!("{kind}{name}"));
    let load: f64 = row[&load].parse().ok()?;
    let (contacts, velocity) = steep_contacts(row, load);
    let [fx, fy, fz] = of_contacts(&contacts, &velocity, STRIP, None).unwrap().force;
    let (sine, cosine) = mean_angle(&contacts).sin_cos();
    let off = (fx + number(row, &x)).hypot(fy * cosine + fz * sine + number(row, &s));
    let range = contacts.iter().map(|contact| contact.angle_range).fold(0.0, f64::max);
    Some([off / (0.3 * load), range.to_degrees()])
}

/// The peak pressures of contacts above 50 degrees, at equal load: with yaw they are as good as
/// without.
#[test]
fn steep_contacts_press_as_contact_says() {
    let rows = rows("flange");
    let [straight, yawed] = [false, true].map(|yawed| {
        let rows = rows.iter().filter(|row| !row["peak_pressure_MPa"].is_empty());
        let rows = rows.filter(|row| (number(row, "yaw_rad") != 0.0) == yawed);
        let found = rows.map(|row| {
            let (contacts, _) = steep_contacts(row, number(row, "normal_force_N"));
            let strips = contacts.iter().flat_map(|contact| &contact.patch.strips);
            let peak = strips.map(|strip| strip.peak_pressure).fold(0.0, f64::max);
            peak * 1e-6 / number(row, "peak_pressure_MPa") - 1.0
        });
        with_count(found.collect())
    });
    println!("peak pressures without yaw {straight:.4?}, with yaw {yawed:.4?}");
    assert!(straight.1 == 16 && straight.0[0] < 0.006);
    assert!(yawed.1 == 16 && yawed.0[0] < 0.008 && yawed.0[1] < 0.025);
    assert_told(PAGE, &format!("with yaw {:.1} % on average", 100.0 * yawed.0[0]));
}

/// Contacts above 50 degrees whose normals turn by less than 30: conformal CONTACT, and CONTACT
/// with one plane.
#[test]
fn steep_contacts_are_those_of_contact_at_equal_load() {
    let rows = rows("flange");
    assert_eq!(rows.len(), 48);
    let [conformal, planar] = ["conformal_", ""].map(|kind| {
        let found = rows.iter().filter_map(|row| steep_contact(row, kind));
        with_count(found.filter(|[_, range]| *range < 30.0).map(|[error, _]| error).collect())
    });
    println!("conformal {conformal:.4?}, planar {planar:.4?}");
    assert!(conformal.0[0] < 0.02 && planar.0[0] < 0.012 && planar.0[1] < 0.03);
    let ([mean, _], count) = conformal;
    let of_conformal = format!("| {mean:.3} ({count}) |");
    assert_told(PAGE, &format!("above 50 degrees, at equal load {of_conformal}"));
    let ([mean, p95], count) = planar;
    assert_told(
        PAGE,
        &format!(
            "Against CONTACT with one plane, errors of the forces are {mean:.3} on average and \
             {p95:.3} at the 95th percentile ({count} contacts)"
        ),
    );
}

/// The forces of wheels at the vertical load, in classes of the mean angle of their steepest
/// contacts and of the range of the normals.
#[test]
fn errors_by_angle_and_range_are_those_of_the_page() {
    let mut classes = [const { [const { Vec::new() }; 3] }; 3];
    for row in rows("runs").iter().filter(|row| !row["conformal_FX_N"].is_empty()) {
        let (mut stand, position, velocity) = stand(row);
        let vertical = stand.height(&position, number(row, "support_N"), Some(&velocity));
        let [fx, fy, _] = stand.solve(&Position { vertical, ..position }, &velocity).force;
        let found = stand.memory.found().iter();
        let angle = found.map(|contact| contact.angle.to_degrees().abs()).fold(0.0, f64::max);
        let range = number(row, "angle_range_deg");
        if angle < 50.0 && range < 30.0 {
            let class = |x: f64, ends: [f64; 2]| ends.iter().filter(|&&end| x >= end).count();
            let off =
                (fx + number(row, "conformal_FX_N")).hypot(fy + number(row, "conformal_FY_N"));
            let error = off / (0.3 * number(row, "normal_force_N"));
            classes[class(angle, [10.0, 30.0])][class(range, [10.0, 20.0])].push(error);
        }
    }
    for (name, classes) in ["0 to 10", "10 to 30", "30 to 50"].iter().zip(classes) {
        let cells = classes.map(|errors| match errors.len() {
            0 => "–".to_owned(),
            count => format!("{:.3} ({count})", mean_and_p95(errors)[0]),
        });
        let row = format!("| {name} degrees | {} |", cells.join(" | "));
        println!("{row}");
        assert_told(PAGE, &row);
    }
}
