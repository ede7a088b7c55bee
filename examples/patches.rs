//! Compares patches of profiles, of given strips and of banded friction with CONTACT:
//! `cargo run --release --example patches` writes `docs/patches.md` and the pictures in `docs/patches/`. The same build
//! writes the same files, byte by byte.

#[path = "common/lines.rs"]
mod lines;
#[path = "../tests/common/patch_reference.rs"]
mod patch_reference;
#[allow(dead_code)]
#[path = "accuracy/pictures.rs"]
mod pictures;

use kstrip::contact::forces::StripCount;
use kstrip::patch::PatchStrip;
use kstrip::solve::model::Model;
use lines::Lines;
use patch_reference::{Case, Errors, Full, banded, given, profiles, statistics};
use pictures::{Align, BLUE, Canvas, Drawn, GREY, INK, ORANGE, dot, line, picture, write};
use std::path::Path;

/// Profiles in pictures.
const SHOWN: [&str; 6] =
    ["two_100_500", "sextic", "bump_4.5_0.07", "worn_step", "s1002_uic60_1", "random_11"];
const COUNT: StripCount = StripCount::Sixteen;

/// A profile, its patch, and how far it is from CONTACT.
struct Compared {
    case: Case,
    patch: Full,
    /// Relative errors of area, peak pressure, approach.
    normal: [f64; 3],
    strip: Errors,
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
        Self { case, patch, normal, strip, total }
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
    let total = all(list.iter().map(|found| &found.total));
    report.row([
        name,
        &list.len().to_string(),
        &column(0),
        &column(1),
        &column(2),
        &three(&strip.force),
        &three(&strip.moment),
        &three(&total.force),
    ]);
}

fn profile_tables(report: &mut Report, list: &[Compared]) {
    report.line("## Profiles\n");
    report.line("Errors of area, peak pressure and approach in %, mean / largest; of the force in units of `μ N` and of the");
    report.line("moment in units of `μ N c`, `c = √(area/π)`, mean / 95th percentile / largest over nine creepages each.\n");
    report.header(&[
        "family",
        "profiles",
        "area",
        "peak pressure",
        "approach",
        "force, STRIP",
        "moment, STRIP",
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

    report.line("\nThe five profiles with the largest errors of force:\n");
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
    report.line("\n## Given strips and friction in bands\n");
    report.line("Force with STRIP, mean / 95th percentile / largest. Given strips have half-elliptic pressure; skewed patches have");
    report.line("their centres off `x = 0`. Bands are on ellipses of 16 strips.\n");
    report.header(&["patch", "force", "moment"]);
    let mut sums = [Errors::default(), Errors::default()];
    for (list, sum) in [given(), banded(COUNT)].into_iter().zip(&mut sums) {
        for (case, patch) in list {
            let errors = case.errors(&patch, Model::Strip);
            report.row([case.name.clone(), three(&errors.force), three(&errors.moment)]);
            sum.extend(errors);
        }
    }
    for (name, errors) in ["**given, all**", "**bands, all**"].iter().zip(&sums) {
        report.row([*name, &three(&errors.force), &three(&errors.moment)]);
    }
}

/// Outline and pressure, ours as lines, CONTACT's as dots.
fn draw(found: &Compared, canvas: &Canvas) -> Drawn {
    let (case, strips) = (&found.case, &found.patch.strips);
    let outline = || case.outline.iter();
    let least = outline().map(|row| row.y).fold(f64::INFINITY, f64::min) - 1e-3;
    let most = outline().map(|row| row.y).fold(-f64::INFINITY, f64::max) + 1e-3;
    let longest = 1.15 * outline().map(|row| row.half_length).fold(0.0, f64::max);
    let peak = 1.2 * case.peak_pressure;
    let title = format!(
        "{}: outline [mm] and peak pressure [MPa] over y [mm]; lines kstrip, dots CONTACT",
        case.name
    );
    write(canvas, &title, (20.0, 14.0), 11, Align::Left, INK)?;
    let across = |left: f64, y: f64| left + 300.0 * (y - least) / (most - least);
    let tall = |value: f64, top: f64| 210.0 - 170.0 * value / top;
    for (left, top, unit) in [(45.0, longest, 1e3), (400.0, peak, 1e-6)] {
        line(canvas, &[(left, 40.0), (left, 210.0), (left + 300.0, 210.0)], GREY, 1.0)?;
        let text = format!("{:.0}", top * unit * 0.8);
        write(canvas, &text, (left - 5.0, tall(0.8 * top, top)), 10, Align::Right, INK)?;
        for y in [least + 1e-3, most - 1e-3] {
            let text = format!("{:.1}", y * 1e3).replace('-', "−");
            write(canvas, &text, (across(left, y), 222.0), 10, Align::Centre, INK)?;
        }
    }
    let length = |strip: &PatchStrip<f64>| (45.0, strip.half_length, longest, BLUE);
    let pressure = |strip: &PatchStrip<f64>| (400.0, strip.peak_pressure, peak, ORANGE);
    for strip in strips {
        for (left, value, top, ink) in [length(strip), pressure(strip)] {
            let (from, to) = (strip.y - strip.width / 2.0, strip.y + strip.width / 2.0);
            let height = tall(value, top);
            line(canvas, &[(across(left, from), height), (across(left, to), height)], ink, 2.0)?;
        }
    }
    for row in outline() {
        dot(canvas, (across(45.0, row.y), tall(row.half_length, longest)), 1.3, INK, true)?;
        dot(canvas, (across(400.0, row.y), tall(row.peak_pressure, peak)), 1.3, INK, true)?;
    }
    Ok(())
}

fn main() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs");
    let list: Vec<Compared> = profiles().into_iter().map(Compared::new).collect();
    let mut report = Report(String::new());
    report.line("# Patches that are no ellipse, against CONTACT\n");
    report.line("Written by `cargo run --release --example patches`. The reference is `tests/data/patches`: 30 profiles whose normal and");
    report.line("tangential problem CONTACT solved on elastic half-spaces. Ours: `Patch::from_profile` (`kstrip_patch_from_profile`),");
    report.line(
        "16 strips, default smoothing, then STRIP or TOTAL. How it works: `src/patch/normal.rs`.\n",
    );
    profile_tables(&mut report, &list);
    other_tables(&mut report);
    report.line("\n## Outlines and pressures\n");
    std::fs::create_dir_all(docs.join("patches")).unwrap();
    for name in SHOWN {
        let found = list.iter().find(|found| found.case.name == name).unwrap();
        picture(&docs.join(format!("patches/{name}.svg")), (720, 235), |canvas| {
            draw(found, canvas)
        })
        .unwrap();
        report.line(format!("![Outline and pressure of {name}](patches/{name}.svg)\n"));
    }
    report.line("## Limits\n");
    for limit in [
        "The bodies are half-spaces: no conformity, one contact plane. Zones far apart in height or angle are contacts of their own.",
        "The undeformed distance is `h(y) + x²/(2 R)`: no yaw, one rolling radius; a strip's pressure is a half-ellipse in `x`.",
        "What is narrower than the smoothing length (0.6 of the patch's half length by default) is rounded off: the pressure of a \
         sharp crest comes out too low (`worn_peak` 13 % and more). A smaller length sees it, and the noise.",
        "Noise of 5 µm rms at points 0.05 mm apart moves the force by .005 to .02 of `μ N`; points farther apart need a larger length.",
        "A narrow tail that is nearly flat (`s1002_uic60_2`) has the largest errors of force: one ellipse stands for a zone.",
        "TOTAL takes one ellipse for each zone: for stability and real time.",
    ] {
        report.line(format!("* {limit}"));
    }
    std::fs::write(docs.join("patches.md"), report.0).unwrap();
}
