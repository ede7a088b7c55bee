//! Error against memory of contact tables: `cargo bench --bench tables` writes the table of
//! `docs/evidence/tables.md`.
//!
//! Errors are those that a finished table tells: against the direct call with 64 strips, over
//! positions that are spread over its ranges.

#[allow(dead_code)]
#[path = "common/lines.rs"]
mod lines;

use kstrip::ffi::double;
use kstrip::table::{TableReport, TableSpec, finish};
use kstrip_testing::prelude::*;
use lines::Lines;
use std::sync::atomic::{AtomicU32, Ordering};

const POSES: u32 = 2000;
const LOAD: f64 = 200e3;
const YAW: f64 = 20e-3;

/// A pair of profiles of `tests/data/wheel_rail`: rail and its turn [rad], wheel and its radius
/// [m], lateral positions from the tread to the flange [m].
struct Profiles {
    rail: &'static str,
    turn: f64,
    wheel: &'static str,
    radius: f64,
    lateral: [f64; 2],
}

const PAIRS: [Profiles; 5] = [
    Profiles {
        rail: "uic60",
        turn: 0.0,
        wheel: "s1002",
        radius: 0.46,
        lateral: [-18.5e-3, -2.5e-3],
    },
    Profiles { rail: "siteb", turn: 0.0, wheel: "s1002", radius: 0.46, lateral: [-8e-3, 8e-3] },
    Profiles {
        rail: "uic60",
        turn: -0.025,
        wheel: "wornhm",
        radius: 0.444,
        lateral: [-88e-3, -72e-3],
    },
    Profiles {
        rail: "rail288",
        turn: 0.0,
        wheel: "whl288",
        radius: 0.4572,
        lateral: [-80e-3, -64e-3],
    },
    Profiles {
        rail: "avglow",
        turn: 0.0,
        wheel: "avgwhl",
        radius: 0.4191,
        lateral: [-78e-3, -62e-3],
    },
];

/// Nodes of the axes: lateral, load, yaw. Strips of a contact of 8 mm.
struct Nodes {
    axes: &'static str,
    counts: [u32; 3],
    strips: u32,
}

const AXES: [Nodes; 3] = [
    Nodes { axes: "lateral, load", counts: [99, 20, 1], strips: 16 },
    Nodes { axes: "lateral, load", counts: [99, 20, 1], strips: 24 },
    Nodes { axes: "and yaw to 20 mrad", counts: [99, 20, 5], strips: 24 },
];

/// Fills a table on two threads, and gives what it tells of its error.
fn report(profiles: &Profiles, nodes: &Nodes) -> TableReport<f64> {
    let rail = manchester::turned(profiles.rail, profiles.turn);
    let wheel = manchester::profile(profiles.wheel);
    let pair = manchester::steel(profiles.radius);
    let [lateral_nodes, levels, yaw_nodes] = nodes.counts;
    let [lateral_from, lateral_to] = profiles.lateral;
    let yaw = if yaw_nodes > 1 { YAW } else { 0.0 };
    let spec = TableSpec {
        lateral_from,
        lateral_to,
        yaw,
        load: LOAD,
        lateral_nodes,
        levels,
        yaw_nodes,
        strips: nodes.strips,
        ..*zeroed()
    };
    let scene = Scene {
        rail: &*rail,
        wheel: &*wheel,
        pair: &pair,
        strips: StripCount::Sixteen,
        law: Law { model: Model::Strip, falling: None },
        table: None,
    };
    let mut memory = zeroed();
    let [bytes, parts] = spec.size(&wheel).expect("a size");
    let mut block = vec![0; bytes as usize];
    spec.begin_table(&scene, &mut memory, &mut block).expect("a table");
    let (next, start) = (AtomicU32::new(0), block.as_mut_ptr() as usize);
    let fill = |memory: &mut Workspace<f64>| {
        loop {
            let part = next.fetch_add(1, Ordering::Relaxed);
            if part >= parts {
                break;
            }
            let (rail, wheel) = (Some(&*rail), Some(&*wheel));
            // SAFETY: other threads fill other parts.
            let status = unsafe {
                double::kstrip_table_fill(
                    rail,
                    wheel,
                    Some(&pair),
                    part,
                    1,
                    Some(&mut *memory),
                    start as *mut u8,
                    bytes,
                )
            };
            assert!(status >= 0, "{status}");
        }
    };
    std::thread::scope(|scope| {
        scope.spawn(|| fill(&mut zeroed()));
        fill(&mut memory);
    });
    finish(&scene, POSES, &mut memory, &mut block).expect("a table")
}

struct Page(String);

impl Lines for Page {
    fn text(&mut self) -> &mut String {
        &mut self.0
    }
}

fn main() {
    let mut page = Page(String::new());
    page.header(&[
        "pair",
        "axes",
        "nodes",
        "strips",
        "memory",
        "force, 95 %",
        "largest",
        "load, 95 %",
    ]);
    for profiles in &PAIRS {
        for nodes in &AXES {
            let found = report(profiles, nodes);
            let counts: Vec<String> =
                nodes.counts.iter().filter(|count| **count > 1).map(u32::to_string).collect();
            let row = [
                format!("{} on {}", profiles.wheel, profiles.rail),
                nodes.axes.to_owned(),
                counts.join(" x "),
                nodes.strips.to_string(),
                format!("{:.2} MB", 1e-6 * f64::from(found.bytes)),
                format!("{:.4}", found.force_usual),
                format!("{:.2}", found.force_largest),
                format!("{:.2} %", 100.0 * found.load_usual),
            ];
            println!("{}; load {:.1} % at most", row.join(", "), 100.0 * found.load_largest);
            page.row(row);
        }
    }
    let path = root().join("docs/evidence/tables.md");
    let [begin, end] = ["begin", "end"].map(|which| format!("<!-- tables: {which} -->\n"));
    let whole = read(&path);
    let (head, rest) = whole.split_once(&begin).expect("the place of the table");
    let (_, tail) = rest.split_once(&end).expect("the end of the table");
    std::fs::write(&path, format!("{head}{begin}{}{end}{tail}", page.0)).expect("a page");
}
