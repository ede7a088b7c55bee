//! Compares patches of profiles, of given strips, of friction in bands and of falling friction with
//! CONTACT: `cargo bench --bench patches` writes `docs/evidence/patches.md` and the pictures in
//! `docs/evidence/patches/`. The same build writes the same files, byte by byte.
//! `cargo bench --bench patches -- cost` prints what patches cost here.

#[path = "common/clock.rs"]
mod clock;
#[path = "common/lines.rs"]
mod lines;
#[allow(dead_code)]
#[path = "accuracy/pictures.rs"]
mod pictures;

use kstrip::contact::Contact;
use kstrip::contact::creepage::Creepage;
use kstrip::contact::totals::StripCount;
use kstrip::forces::{self, Model, Options};
use kstrip::normal::cells::Given;
use kstrip::normal::{Profile, ProfileContact};
use kstrip::patch::solver;
use kstrip_testing::patch_reference::{
    Case, Errors, Full, banded, falling, given, profiles, real, statistics,
};
use lines::Lines;
use pictures::{
    Align, Axis, BLUE, Canvas, Drawn, INK, PALE, Plot, VERMILION, dot, line, picture, write,
};
use std::path::Path;

/// The profile of the picture, and its title.
const SHOWN: (&str, &str) = ("s1002_uic60_1", "S1002 on 60E1, shift 1 mm");
/// The real patch of the picture, and its title.
const SHOWN_REAL: (&str, &str) = ("car7216_p019_1", "profiles in service");
const COUNT: StripCount = StripCount::Sixteen;

/// A profile, its patch, and how far it is from CONTACT.
struct Compared {
    case: Case,
    patch: Full,
    /// Relative errors of area, peak pressure, approach.
    normal: [f64; 3],
    strip: Errors,
    /// On the strips that CONTACT's outline and loads make.
    exact: Errors,
    total: Errors,
}

impl Compared {
    fn new(case: Case) -> Self {
        let (patch, found) = case.patch(COUNT);
        let area = patch.view().unwrap().area();
        let normal = [
            area / case.area - 1.0,
            found.peak_pressure / case.peak_pressure - 1.0,
            found.approach / case.approach - 1.0,
        ];
        let (strip, total) = (case.errors(&patch, Model::Strip), case.errors(&patch, Model::Total));
        let exact = case.errors(&case.reference_patch(), Model::Strip);
        Self { case, patch, normal, strip, exact, total }
    }
}

struct Report(String);

impl Lines for Report {
    fn text(&mut self) -> &mut String {
        &mut self.0
    }
}

fn three(errors: &[f64]) -> String {
    let [mean, most, worst] = statistics(errors);
    format!("{mean:.4} / {most:.4} / {worst:.4}")
}

fn percent(values: impl Iterator<Item = f64>) -> String {
    let values: Vec<f64> = values.map(|x| 100.0 * x.abs()).collect();
    let [mean, _, worst] = statistics(&values);
    format!("{mean:.1} / {worst:.1}")
}

fn all<'a>(list: impl Iterator<Item = &'a Errors>) -> Errors {
    let mut all = Errors::default();
    list.for_each(|errors| all.extend(errors.clone()));
    all
}

fn normal_row(report: &mut Report, name: &str, list: &[&Compared]) {
    let column = |i: usize| percent(list.iter().map(|found| found.normal[i]));
    let strip = all(list.iter().map(|found| &found.strip));
    let exact = all(list.iter().map(|found| &found.exact));
    let total = all(list.iter().map(|found| &found.total));
    report.row([
        name,
        &list.len().to_string(),
        &column(0),
        &column(1),
        &column(2),
        &three(&strip.force),
        &three(&strip.moment),
        &three(&exact.force),
        &three(&total.force),
    ]);
}

fn profile_tables(report: &mut Report, list: &[Compared]) {
    report.line("## How far from CONTACT: profiles\n");
    report.line(
        "CONTACT solved the normal and the tangential problem of 30 profiles on elastic \
         half-spaces (`tests/data/patches`), with nine creepages each. Profiles of the family \
         `hertz` are parabolas, as controls. The patches have 16 strips and the default \
         smoothing.\n",
    );
    report.header(&["quantity", "value"]);
    report.row(["shear modulus, Poisson's ratio", "steel, `ν = 0.28`"]);
    report.row(["load", "31 to 100 kN"]);
    report.row(["friction", "0.3"]);
    report.row(["length of the patches divided by their width", "0.6 to 4.7"]);
    report.line(
        "\nErrors of area, peak pressure and approach are mean / largest in %. Errors of the force \
         are in units of `μ N`. Errors of the moment are in units of `μ N c` with `c = √(area/π)`. \
         Both are mean / 95th percentile / largest. One column has the errors of STRIP on \
         CONTACT's own outline and loads. They are nearly as large, so nearly all error comes from \
         the tangential model.\n",
    );
    report.header(&[
        "family",
        "profiles",
        "area",
        "peak pressure",
        "approach",
        "force, STRIP",
        "moment, STRIP",
        "force, STRIP on CONTACT's outline",
        "force, TOTAL",
    ]);
    let mut families: Vec<&str> = Vec::new();
    for found in list {
        if !families.contains(&found.case.family.as_str()) {
            families.push(&found.case.family);
        }
    }
    for family in families {
        let own: Vec<_> = list.iter().filter(|found| found.case.family == family).collect();
        normal_row(report, family, &own);
    }
    normal_row(report, "**all**", &list.iter().collect::<Vec<_>>());

    report.line("\nThe next table has the five profiles with the largest errors of force.\n");
    report.header(&["profile", "force, mean", "force, largest", "area, %", "peak pressure, %"]);
    let mut worst: Vec<&Compared> = list.iter().collect();
    let largest = |found: &Compared| statistics(&found.strip.force)[2];
    worst.sort_by(|a, b| largest(b).total_cmp(&largest(a)));
    for found in &worst[..5] {
        report.row([
            found.case.name.clone(),
            format!("{:.4}", statistics(&found.strip.force)[0]),
            format!("{:.4}", largest(found)),
            format!("{:.1}", 100.0 * found.normal[0]),
            format!("{:.1}", 100.0 * found.normal[1]),
        ]);
    }
}

fn other_tables(report: &mut Report) {
    report.line("\n## Given strips, friction in bands, falling friction\n");
    report.line(
        "The table has the errors of force and moment with STRIP, mean / 95th percentile / \
         largest. Given strips have half-elliptic pressure. The strips of skewed patches have \
         centres beside `x = 0`. Bands and falling friction are on ellipses of 16 strips with \
         three axis ratios. All bodies are of steel (`ν = 0.28`). In CONTACT friction falls with \
         the slip of each point. In the library it falls with the mean slip of the patch. One row \
         has all families of falling friction.\n",
    );
    report.header(&["patch", "force", "moment"]);
    let mut sums = [Errors::default(), Errors::default()];
    for (list, sum) in [given(), banded(COUNT)].into_iter().zip(&mut sums) {
        for (case, patch) in list {
            let errors = case.errors(&patch, Model::Strip);
            report.row([case.name.clone(), three(&errors.force), three(&errors.moment)]);
            sum.extend(errors);
        }
    }
    let mut under_law = Errors::default();
    for (case, patch, law) in falling() {
        under_law.extend(case.errors_under(&patch, Some(&law), Model::Strip));
    }
    let names = ["**given, all**", "**bands, all**", "**falling, all**"];
    for (name, errors) in names.iter().zip(sums.iter().chain([&under_law])) {
        report.row([*name, &three(&errors.force), &three(&errors.moment)]);
    }
}

/// Uniform numbers −1/2 to 1/2, the same in every build.
struct Uniform(u64);

impl Uniform {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    }
}

/// How much the forces change when points are measured with noise, or one of them is bad.
fn noise_table(report: &mut Report, list: &[Compared]) {
    report.line("\n## Measured points\n");
    report.line(
        "The table has the change of the force, in units of `μ N`, if the points of the 30 \
         profiles are measured. Each profile has nine creepages, and its points are 0.05 mm apart. \
         Each profile was disturbed 20 times with noise of 5 µm rms. Then it was disturbed 20 \
         times at one point, by 20 µm. The largest changes come from noise that tilts a wide patch \
         with spin and moves its middle by 0.1 mm.\n",
    );
    report.header(&["points", "mean / 95th percentile / largest", "below 0.02, %"]);
    let mut uniform = Uniform(20_260_117);
    for bad in [false, true] {
        let mut changes = Vec::new();
        for Compared { case, patch, .. } in list {
            let forces = |patch: &Full| -> Vec<[f64; 2]> {
                let view = patch.view().unwrap();
                let bound = case.friction * case.load;
                let of = |creepage| {
                    let found = solver::solve_patch(&view, &creepage, Model::Strip).unwrap();
                    [found.fx / bound, found.fy / bound]
                };
                case.motions.iter().map(|motion| of(case.creepage(motion))).collect()
            };
            let clean = forces(patch);
            for _ in 0..20 {
                let mut measured = case.clone();
                if bad {
                    let place = 10e-3 * uniform.next();
                    let i = case.y.partition_point(|y| *y < place);
                    measured.distance[i] += 20e-6_f64.copysign(uniform.next());
                } else {
                    for h in &mut measured.distance {
                        // twelve uniform numbers make a normal one
                        *h += 5e-6 * (0..12).map(|_| uniform.next()).sum::<f64>();
                    }
                }
                let found = forces(&measured.patch(COUNT).0);
                let pairs = clean.iter().zip(&found);
                changes.extend(pairs.map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1])));
            }
        }
        let below = changes.iter().filter(|change| **change < 0.02).count();
        let share = 100.0 * below as f64 / changes.len() as f64;
        let name = if bad { "one wrong by 20 µm" } else { "noise of 5 µm rms" };
        report.row([name, &three(&changes), &format!("{share:.1}")]);
    }
}

/// Largest change of force and approach between loads that differ by a tenth of a thousandth, while
/// zones merge.
fn merging_table(report: &mut Report) {
    report.line("\n## Regions that merge\n");
    report.line(
        "A profile with two local minima 9 mm apart, `h = H ((y/4.5 mm)² − 1)²`, is pressed \
         with a growing load. Two zones grow, touch and become one. The table has the largest \
         change of the force, in units of `μ N`, for a load step of 0.01 %. It also has the \
         largest relative change of the approach for this step. Neither jumps.\n",
    );
    report.header(&["H [µm]", "load [kN]", "zones", "force, STRIP", "force, TOTAL", "approach"]);
    let y: Vec<f64> = (-1000..=1000).map(|i| 20e-6 * f64::from(i)).collect();
    let creepage = Creepage { longitudinal: 3e-4, lateral: 5e-4, spin: 0.1 };
    for height in [70e-6, 30e-6] {
        let distance: Vec<f64> =
            y.iter().map(|y| height * ((y / 4.5e-3).powi(2) - 1.0).powi(2)).collect();
        let mut load = 50e3;
        let mut last = None::<([[f64; 2]; 2], f64)>;
        let (mut steps, mut zones) = ([0.0_f64; 3], Vec::new());
        while load < 250e3 {
            let (patch, found) =
                Full::from_profile(&Profile::new(&y, &distance).unwrap(), &pressed(load), COUNT)
                    .unwrap();
            let view = patch.view().unwrap();
            let forces = [Model::Strip, Model::Total].map(|model| {
                let found = solver::solve_patch(&view, &creepage, model).unwrap();
                [found.fx, found.fy].map(|force| force / (0.35 * load))
            });
            if let Some((before, approach)) = last {
                for ((step, a), b) in steps.iter_mut().zip(before).zip(forces) {
                    *step = step.max((a[0] - b[0]).hypot(a[1] - b[1]));
                }
                steps[2] = steps[2].max((found.approach / approach - 1.0).abs());
            }
            let lobes = view.lobes().count();
            if zones.last() != Some(&lobes) {
                zones.push(lobes);
            }
            last = Some((forces, found.approach));
            load *= 1.0001;
        }
        let zones: Vec<String> = zones.iter().map(usize::to_string).collect();
        report.row([
            format!("{:.0}", height * 1e6),
            "50 to 250".into(),
            zones.join(", then "),
            format!("{:.5}", steps[0]),
            format!("{:.5}", steps[1]),
            format!("{:.5}", steps[2]),
        ]);
    }
}

/// A wheel on a rail.
fn pressed(load: f64) -> ProfileContact<f64> {
    ProfileContact {
        rolling_radius: 0.46,
        given: Given::Load(load),
        shear_modulus: 82e9,
        poisson_ratio: 0.28,
        friction: 0.35,
        smoothing_length: 0.0,
    }
}

/// Real wheels on real rails, by pair.
fn real_table(report: &mut Report, list: &[Case]) {
    report.line("\n## Real wheels on real rails\n");
    report.line(
        "The 36 patches are from six pairs of profiles, new and worn, with yaw \
         (`tests/data/real`). Each point has its rolling radius and its place along `x`. The \
         bodies are of steel (`ν = 0.28`), with friction 0.3. The load is 34 to 146 kN. The mean \
         length of the patches is 0.3 to 24 times their width. Creepages and moment are about the \
         origin of the profile. The errors against CONTACT are defined as above.\n",
    );
    report.header(&["pair", "patches", "area", "peak pressure", "force, STRIP", "moment, STRIP"]);
    let mut pairs: Vec<&str> = Vec::new();
    for case in list {
        if !pairs.contains(&case.family.as_str()) {
            pairs.push(&case.family);
        }
    }
    let mut row = |name: &str, own: &[&Case]| {
        let built: Vec<_> = own.iter().map(|case| case.patch(COUNT)).collect();
        let pairs = || own.iter().zip(&built);
        let area = percent(
            pairs().map(|(case, (patch, _))| patch.view().unwrap().area() / case.area - 1.0),
        );
        let peak = percent(
            pairs().map(|(case, (_, found))| found.peak_pressure / case.peak_pressure - 1.0),
        );
        let errors: Vec<Errors> =
            pairs().map(|(case, (patch, _))| case.errors(patch, Model::Strip)).collect();
        let errors = all(errors.iter());
        let count = own.len().to_string();
        report.row([name, &count, &area, &peak, &three(&errors.force), &three(&errors.moment)]);
    };
    for pair in pairs {
        row(pair, &list.iter().filter(|case| case.family == pair).collect::<Vec<_>>());
    }
    row("**all**", &list.iter().collect::<Vec<_>>());
}

/// Mean error of the peak pressure of the real patches under noise, by smoothing length.
fn smoothing_table(report: &mut Report, list: &[Case]) {
    report.line("\n## What smoothing does\n");
    report.line(
        "The table has the mean error of the peak pressure of the real patches, in %, if \
         their points are measured with noise.\n",
    );
    report.header(&["smoothing length", "no noise", "2 µm rms", "5 µm rms"]);
    for (name, smoothing_length) in
        [("0 (default)", 0.0), ("1 mm", 1e-3), ("2 mm", 2e-3), ("4 mm", 4e-3)]
    {
        let mut cells = vec![name.to_owned()];
        for noise in [0.0, 2e-6, 5e-6] {
            let mut uniform = Uniform(20_260_118);
            let errors: Vec<f64> = list
                .iter()
                .map(|case| {
                    let mut measured = case.clone();
                    for h in &mut measured.distance {
                        *h += noise * (0..12).map(|_| uniform.next()).sum::<f64>();
                    }
                    let contact = ProfileContact { smoothing_length, ..case.contact() };
                    let found = Full::from_profile(&measured.profile(), &contact, COUNT).unwrap().1;
                    100.0 * (found.peak_pressure / case.peak_pressure - 1.0).abs()
                })
                .collect();
            cells.push(format!("{:.1}", statistics(&errors)[0]));
        }
        report.row([&cells[0], &cells[1], &cells[2], &cells[3]]);
    }
}

/// One of three panels beside each other, with its title and the name of its horizontal axis.
fn panel(
    canvas: &Canvas, column: usize, [title, across]: [&str; 2], [x, y]: [Axis; 2],
    points: &[(f64, f64)],
) -> Drawn {
    let left = 48.0 + 290.0 * column as f64;
    let plot = Plot { left, top: 40.0, width: 230.0, height: 170.0, x, y };
    plot.frame(canvas)?;
    plot.title(canvas, title)?;
    plot.curve(canvas, points, BLUE, 2.0)?;
    write(canvas, across, (left + 115.0, 242.0), 12, Align::Centre, INK)
}

/// Light contact, a zone that appears, a profile that moves sideways.
fn draw_sweeps(canvas: &Canvas) -> Drawn {
    let parabola: Vec<f64> = (0..201).map(|i| 0.4e-3 * (f64::from(i) - 100.3)).collect();
    let heights: Vec<f64> = parabola.iter().map(|y| y * y / 0.6).collect();
    let at = |y: &[f64], distance: &[f64], given| {
        let contact = ProfileContact { given, ..pressed(0.0) };
        Full::from_profile(&Profile::new(y, distance).unwrap(), &contact, COUNT).unwrap()
    };
    let light: Vec<(f64, f64)> = (0..=80)
        .map(|i| {
            let approach = 10_f64.powf(-12.0 + 0.1 * f64::from(i));
            let found = at(&parabola, &heights, Given::Approach(approach)).1;
            (approach, found.normal_force / approach.powf(1.5) * 1e-9)
        })
        .collect();
    let axes = [
        Axis::logarithmic(1e-12, 1e-4, &[1e-12, 1e-10, 1e-8, 1e-6, 1e-4]),
        Axis::linear(0.0, 120.0, &[0.0, 40.0, 80.0, 120.0]),
    ];
    panel(canvas, 0, ["load/approach^1.5 [GN/m^1.5]", "approach [m], a parabola"], axes, &light)?;
    let y: Vec<f64> = (-400..=400).map(|i| 1e-4 * f64::from(i)).collect();
    let minima = |y: &f64| ((y - 6e-3).powi(2) / 0.3).min((y + 5e-3).powi(2) / 0.2 + 12e-6);
    let distance: Vec<f64> = y.iter().map(minima).collect();
    let birth: Vec<(f64, f64)> = (0..=200)
        .map(|i| {
            let approach = 8e-6 + 0.06e-6 * f64::from(i);
            let found = at(&y, &distance, Given::Approach(approach)).1;
            (approach * 1e6, found.normal_force * 1e-3)
        })
        .collect();
    let axes = [
        Axis::linear(8.0, 20.0, &[8.0, 12.0, 16.0, 20.0]),
        Axis::linear(0.0, 9.0, &[0.0, 3.0, 6.0, 9.0]),
    ];
    panel(canvas, 1, ["load [kN]", "approach [µm], a second zone from 13 µm on"], axes, &birth)?;
    let creepage = Creepage { longitudinal: 1e-3, lateral: 5e-4, spin: 0.3 };
    let y: Vec<f64> = (0..304).map(|i| 50e-3 * (f64::from(i) / 303.0 - 0.5)).collect();
    let moved: Vec<(f64, f64)> = (-100..=100)
        .map(|i| {
            let shift = 20e-6 * f64::from(i);
            let shape =
                |y: &f64| 90e-6 * (((y - shift) / 6e-3).powi(2) - 1.0).powi(2) + y * y / 0.6;
            let distance: Vec<f64> = y.iter().map(shape).collect();
            let (patch, _) = at(&y, &distance, Given::Load(80e3));
            let found =
                solver::solve_patch(&patch.view().unwrap(), &creepage, Model::Strip).unwrap();
            (shift * 1e3, found.fx / (0.35 * 80e3))
        })
        .collect();
    let axes = [
        Axis::linear(-2.0, 2.0, &[-2.0, -1.0, 0.0, 1.0, 2.0]),
        Axis::linear(0.0, 0.5, &[0.0, 0.1, 0.2, 0.3, 0.4, 0.5]),
    ];
    panel(canvas, 2, ["Fx/(µ N)", "shift of two minima [mm]"], axes, &moved)
}

/// One of 1, 2, 5 times a power of ten: ticks at this distance are two to five.
fn step(range: f64) -> f64 {
    let power = 10_f64.powf((range / 5.0).log10().floor());
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|k| k * power).find(|k| range / k <= 5.0).unwrap_or(range)
}

/// Axes with ticks and labels: across in mm, upward from `low` to `high`.
struct Axes {
    left: f64,
    /// y \[m\]
    ends: [f64; 2],
    low: f64,
    high: f64,
}

impl Axes {
    fn across(&self, y: f64) -> f64 {
        self.left + 290.0 * (y - self.ends[0]) / (self.ends[1] - self.ends[0])
    }

    fn up(&self, value: f64) -> f64 {
        215.0 - 165.0 * (value - self.low) / (self.high - self.low)
    }

    fn draw(&self, canvas: &Canvas, label: &str) -> Drawn {
        let number = |x: f64| format!("{x:.0}").replace('-', "−").replace("−0", "0");
        let [low, high] = self.ends.map(|y| 1e3 * y);
        let across = step(high - low);
        for i in (low / across).ceil() as i32..=(high / across).floor() as i32 {
            let y = f64::from(i) * across;
            let h = self.across(1e-3 * y);
            line(canvas, &[(h, 50.0), (h, 218.0)], PALE, 1.0)?;
            write(canvas, &number(y), (h, 228.0), 11, Align::Centre, INK)?;
        }
        let upward = step(self.high - self.low);
        for i in (self.low / upward).ceil() as i32..=(self.high / upward).floor() as i32 {
            let v = self.up(f64::from(i) * upward);
            line(canvas, &[(self.left - 3.0, v), (self.left + 290.0, v)], PALE, 1.0)?;
            let text = number(f64::from(i) * upward);
            write(canvas, &text, (self.left - 6.0, v), 11, Align::Right, INK)?;
        }
        let corner = [(self.left, 50.0), (self.left, 215.0), (self.left + 290.0, 215.0)];
        line(canvas, &corner, INK, 1.0)?;
        write(canvas, label, (self.left - 30.0, 38.0), 11, Align::Left, INK)?;
        write(canvas, "y [mm]", (self.left + 145.0, 245.0), 11, Align::Centre, INK)
    }
}

/// The title, and what lines and dots (or dashes) stand for.
fn title(canvas: &Canvas, name: &str, contact: &str, dashes: bool) -> Drawn {
    write(canvas, name, (20.0, 14.0), 12, Align::Left, INK)?;
    line(canvas, &[(330.0, 14.0), (350.0, 14.0)], BLUE, 2.0)?;
    line(canvas, &[(355.0, 14.0), (375.0, 14.0)], VERMILION, 2.0)?;
    write(canvas, "kstrip, 16 strips", (382.0, 14.0), 11, Align::Left, INK)?;
    if dashes {
        for left in [515.0, 525.0] {
            line(canvas, &[(left, 14.0), (left + 6.0, 14.0)], INK, 1.0)?;
        }
    } else {
        for left in [515.0, 522.0, 529.0] {
            dot(canvas, (left, 14.0), 1.3, INK, true)?;
        }
    }
    write(canvas, contact, (538.0, 14.0), 11, Align::Left, INK)
}

/// A real patch: outline, pressure, and CONTACT's largest pressure.
fn draw_real(case: &Case, what: &str, canvas: &Canvas) -> Drawn {
    let patch = case.patch(COUNT).0;
    let strips = patch.used();
    let ends = strips.iter().fold([f64::INFINITY, -f64::INFINITY], |[least, most], strip| {
        [least.min(strip.y - strip.width), most.max(strip.y + strip.width)]
    });
    let longest =
        1.15e3 * strips.iter().map(|s| s.half_length + s.centre_x.abs()).fold(0.0, f64::max);
    let peak = 1e-6 * case.peak_pressure;
    title(canvas, &format!("{}: {what}", case.name), "CONTACT, largest", true)?;
    let outline = Axes { left: 50.0, ends, low: -longest, high: longest };
    let pressure = Axes { left: 410.0, ends, low: 0.0, high: 1.2 * peak };
    outline.draw(canvas, "outline, x [mm]")?;
    pressure.draw(canvas, "peak pressure of a strip [MPa]")?;
    for strip in strips {
        let (from, to) = (strip.y - strip.width / 2.0, strip.y + strip.width / 2.0);
        for x in [strip.centre_x - strip.half_length, strip.centre_x + strip.half_length] {
            let v = outline.up(1e3 * x);
            line(canvas, &[(outline.across(from), v), (outline.across(to), v)], BLUE, 2.0)?;
        }
        let v = pressure.up(1e-6 * strip.peak_pressure);
        line(canvas, &[(pressure.across(from), v), (pressure.across(to), v)], VERMILION, 2.0)?;
    }
    for i in 0..29 {
        let left = pressure.left + 10.0 * f64::from(i);
        let v = pressure.up(peak);
        line(canvas, &[(left, v), (left + 5.0, v)], INK, 1.0)?;
    }
    Ok(())
}

/// Quickest of many rounds, in µs for each call.
fn quickest(calls: usize, mut round: impl FnMut()) -> f64 {
    let rounds = (0..30).map(|_| clock::took(&mut round));
    rounds.fold(f64::INFINITY, f64::min) / calls as f64 / 1e3
}

fn print_costs() {
    let cases = profiles();
    println!("Processor time on this machine, µs, of the quickest of 30 rounds over all profiles:");
    for (count, name) in [(StripCount::Sixteen, 16), (StripCount::ThirtyTwo, 32)] {
        let mut sum = 0.0;
        let built = quickest(cases.len(), || {
            cases.iter().for_each(|case| sum += case.patch(count).1.approach);
        });
        println!("{name} strips: profile to patch {built:.1}");
        let patches: Vec<Full> = cases.iter().map(|case| case.patch(count).0).collect();
        let views: Vec<_> = patches.iter().map(|patch| patch.view().unwrap()).collect();
        for several in [false, true] {
            let some: Vec<usize> = (0..cases.len())
                .filter(|i| {
                    let zone = |number| views[*i].zone(number).map(|zone| zone.contact.a);
                    let own = zone(0);
                    (1..views[*i].strips().len()).any(|number| zone(number) != own) == several
                })
                .collect();
            for (model, what) in [(Model::Strip, "STRIP"), (Model::Total, "TOTAL")] {
                let cost = quickest(9 * some.len(), || {
                    for i in &some {
                        for motion in &cases[*i].motions {
                            let creepage = cases[*i].creepage(motion);
                            sum += solver::solve_patch(&views[*i], &creepage, model).unwrap().fx;
                        }
                    }
                });
                let zones = if several { "several regions or a narrowing" } else { "one zone" };
                println!("  {what}, {} patches of {zones}: {cost:.2}", some.len());
            }
        }
        let contact = Contact {
            a: 6e-3,
            b: 5e-3,
            normal_force: 80e3,
            shear_modulus: 82e9,
            poisson_ratio: 0.28,
            friction: 0.3,
            mismatch: 0.0,
        };
        let options = Options { model: Model::Strip, strips: count };
        let cost = quickest(9 * cases.len(), || {
            for case in &cases {
                for motion in &case.motions {
                    let creepage = case.creepage(motion);
                    sum += forces::forces_of_contact(&contact, &creepage, &options).unwrap().fx;
                }
            }
        });
        println!("  STRIP on an ellipse: {cost:.2} ({sum:.3e})");
    }
}

/// Half lengths and pressure, ours as lines, CONTACT's as dots.
fn draw(found: &Compared, what: &str, canvas: &Canvas) -> Drawn {
    let (case, strips) = (&found.case, found.patch.used());
    let outline = || case.outline.iter();
    let least = outline().map(|row| row.y).fold(f64::INFINITY, f64::min) - 1e-3;
    let most = outline().map(|row| row.y).fold(-f64::INFINITY, f64::max) + 1e-3;
    let longest = 1.15e3 * outline().map(|row| row.half_length).fold(0.0, f64::max);
    let ends = [least, most];
    title(canvas, &format!("{}: {what}", case.name), "CONTACT", false)?;
    let length = Axes { left: 50.0, ends, low: 0.0, high: longest };
    let pressure = Axes { left: 410.0, ends, low: 0.0, high: 1.2e-6 * case.peak_pressure };
    length.draw(canvas, "half length of a strip [mm]")?;
    pressure.draw(canvas, "peak pressure of a strip [MPa]")?;
    for strip in strips {
        let (from, to) = (strip.y - strip.width / 2.0, strip.y + strip.width / 2.0);
        let (high, tall) =
            (length.up(1e3 * strip.half_length), pressure.up(1e-6 * strip.peak_pressure));
        line(canvas, &[(length.across(from), high), (length.across(to), high)], BLUE, 2.0)?;
        line(
            canvas,
            &[(pressure.across(from), tall), (pressure.across(to), tall)],
            VERMILION,
            2.0,
        )?;
    }
    for row in outline() {
        let at = (length.across(row.y), length.up(1e3 * row.half_length));
        dot(canvas, at, 1.3, INK, true)?;
        let at = (pressure.across(row.y), pressure.up(1e-6 * row.peak_pressure));
        dot(canvas, at, 1.3, INK, true)?;
    }
    Ok(())
}

fn main() {
    if std::env::args().nth(1).as_deref() == Some("cost") {
        print_costs();
        return;
    }
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/evidence");
    let list: Vec<Compared> = profiles().into_iter().map(Compared::new).collect();
    let mut report = Report(String::new());
    report.line(include_str!("patches/introduction.txt").trim_end());
    report.line("");
    profile_tables(&mut report, &list);
    other_tables(&mut report);
    let rails = real();
    real_table(&mut report, &rails);
    smoothing_table(&mut report, &rails);
    noise_table(&mut report, &list);
    merging_table(&mut report);
    std::fs::create_dir_all(docs.join("patches")).unwrap();
    let (name, what) = SHOWN;
    let found = list.iter().find(|found| found.case.name == name).unwrap();
    picture(&docs.join(format!("patches/{name}.svg")), (720, 255), |canvas| {
        draw(found, what, canvas)
    })
    .unwrap();
    report.line("\n## A real patch\n");
    report.line(
        "The left plot has both ends of each strip. The data have only the largest pressure \
         of CONTACT, which is the dashed line.\n",
    );
    let (name, what) = SHOWN_REAL;
    let case = rails.iter().find(|case| case.name == name).unwrap();
    picture(&docs.join(format!("patches/{name}.svg")), (720, 255), |canvas| {
        draw_real(case, what, canvas)
    })
    .unwrap();
    report.line(format!("![Outline and pressure of {name}](patches/{name}.svg)\n"));
    report.line("## Light contact, zones that appear, profiles that move\n");
    report.line(
        "The left plot has the load of a light contact of a parabola, divided by the power \
         3/2 of its approach. The quotient is constant from 1e-12 m. In the middle plot a second \
         zone appears while two bodies approach, and the load has no step. In the right plot \
         a profile with two local minima moves sideways at 80 kN, and the force has no step.\n",
    );
    picture(&docs.join("patches/sweeps.svg"), (880, 260), draw_sweeps).unwrap();
    report.line("![Light contact, a zone that appears, a shift](patches/sweeps.svg)\n");
    report.line(include_str!("patches/limits.txt").trim_end());
    std::fs::write(docs.join("patches.md"), report.0).unwrap();
}
