//! Solves contacts of the whole input space for a long time and watches.
//!
//!     cargo run --release --example soak -- [solves] [state file]
//!
//! 10⁹ solves by default. The state is written after every block of 2²⁰; started again with the same file
//! it goes on where it was. It stops with an error when a promise is broken: an output that is not finite or
//! beyond the friction bound, an output written on error, other bits for the same inputs as at the
//! start, memory that grows.

use indicatif::{ProgressBar, ProgressStyle};
#[path = "../tests/common/names.rs"]
mod names;

use kstrip::status::Notice;
use names::*;
use std::mem::MaybeUninit;
use std::time::Instant;

#[path = "../tests/common/random.rs"]
mod random;

use random::Random;

const BLOCK: u64 = 1 << 20;
/// The first block is solved again after so many, to see that nothing has drifted.
const CHECK_EVERY: u64 = 64;
/// Solves of the first block that are compared.
const SAMPLE: u64 = 1 << 17;

/// Mostly cheap models: the point is the number of inputs. Model, strips.
const MIX: [(i32, i32); 16] = [
    (KSTRIP_MODEL_TOTAL, 16),
    (KSTRIP_MODEL_LINEAR, 16),
    (KSTRIP_MODEL_STRIP_1967, 4),
    (KSTRIP_MODEL_TOTAL, 16),
    (KSTRIP_MODEL_LINEAR, 16),
    (KSTRIP_MODEL_STRIP_1967_CONTINUOUS, 4),
    (KSTRIP_MODEL_TOTAL, 16),
    (KSTRIP_MODEL_STRIP, 4),
    (KSTRIP_MODEL_TOTAL, 16),
    (KSTRIP_MODEL_LINEAR, 16),
    (KSTRIP_MODEL_STRIP_1967, 8),
    (KSTRIP_MODEL_TOTAL, 16),
    (KSTRIP_MODEL_STRIP, 8),
    (KSTRIP_MODEL_STRIP_1967_CONTINUOUS, 8),
    (KSTRIP_MODEL_STRIP_1967, 16),
    (KSTRIP_MODEL_STRIP, 16),
];

/// What is carried from run to run.
#[derive(Clone, Copy, Default)]
struct State {
    solves: u64,
    refused: u64,
    warned: u64,
    /// Of all results so far.
    hash: u64,
    /// Of the sample of the first block.
    sample: u64,
    seconds: f64,
}

impl State {
    fn load(path: &str) -> Option<Self> {
        let text = std::fs::read_to_string(path).ok()?;
        let words: Vec<&str> = text.split_whitespace().collect();
        let [solves, refused, warned, hash, sample, seconds] = words[..] else { return None };
        Some(Self {
            solves: solves.parse().ok()?,
            refused: refused.parse().ok()?,
            warned: warned.parse().ok()?,
            hash: u64::from_str_radix(hash, 16).ok()?,
            sample: u64::from_str_radix(sample, 16).ok()?,
            seconds: seconds.parse().ok()?,
        })
    }

    fn store(&self, path: &str) -> std::io::Result<()> {
        let Self { solves, refused, warned, hash, sample, seconds } = *self;
        // Never half a state: written beside it, then renamed.
        let beside = format!("{path}.new");
        std::fs::write(
            &beside,
            format!("{solves} {refused} {warned} {hash:x} {sample:x} {seconds}\n"),
        )?;
        std::fs::rename(beside, path)
    }
}

/// `low 2ᵏ (1 + u)`: evenly over so many octaves.
fn octaves(random: &mut Random, low: f64, count: u64) -> f64 {
    let bits = random.bits();
    let power = f64::from_bits((1023 + (bits >> 32) % count) << 52);
    low * power * (1.0 + (bits as u32) as f64 / 4_294_967_296.0)
}

fn signed(random: &mut Random, x: f64) -> f64 {
    random.sign() * x
}

/// Contact and motion: shapes of 1 : 1000 to 1000 : 1, loads and materials of any size, from
/// no creepage at all to far beyond sliding, one in 64 with arbitrary bits in one number.
fn input(random: &mut Random) -> (kstrip_contact, kstrip_creepage) {
    let b = octaves(random, 1e-5, 14);
    let mut contact = kstrip_contact {
        a: b * octaves(random, 1e-3, 20),
        b,
        normal_force: 0.0,
        shear_modulus: octaves(random, 1e6, 20),
        poisson_ratio: 0.5 * random.unit(),
        friction: octaves(random, 1e-3, 11),
    };
    // Peak pressure of 2⁻²⁰ G … G/10
    let pressure = contact.shear_modulus * octaves(random, 1e-6, 17);
    contact.normal_force = pressure * contact.a * contact.b * 2.094_395_102_393_195;
    let unit = 2.0 * contact.friction * pressure / contact.shear_modulus;
    let bits = random.bits();
    // Each of the three is there or not, and of its own size.
    let mut part = |present: bool| {
        if present { octaves(random, unit * 1e-6, 26) } else { 0.0 }
    };
    let (x, y, s) =
        (part(bits & 3 != 0), part(bits >> 2 & 3 != 0), part(bits >> 4 & 3 != 0) / contact.a);
    let mut creepage = kstrip_creepage {
        longitudinal: signed(random, x),
        lateral: signed(random, y),
        spin: signed(random, s),
    };
    if bits >> 8 & 63 == 0 {
        let any = f64::from_bits(random.bits());
        match bits >> 16 & 7 {
            0 => contact.a = any,
            1 => contact.b = any,
            2 => contact.normal_force = any,
            3 => contact.shear_modulus = any,
            4 => contact.friction = any,
            5 => creepage.longitudinal = any,
            6 => creepage.lateral = any,
            _ => creepage.spin = any,
        }
    }
    (contact, creepage)
}

/// Solves `count` inputs of a block; the hash of the results, how many were refused, how many warned.
fn solve_block(block: u64, count: u64) -> Result<(u64, u64, u64), String> {
    let mut random = Random::new(block.wrapping_mul(0x9E37_79B9_7F4A_7C15));
    let (mut hash, mut refused, mut warned) = (0xcbf2_9ce4_8422_2325_u64, 0, 0);
    let untouched = kstrip_result {
        fx: -7.0,
        fy: -7.0,
        mz: -7.0,
        power: -7.0,
        adhesion: -7.0,
        notice: Notice::None,
        reserved: -7,
    };
    for i in 0..count {
        let (contact, creepage) = input(&mut random);
        let (model, strips) = MIX[(i % 16) as usize];
        let options = kstrip_options { model, strips };
        let mut out = MaybeUninit::new(untouched);
        let status = kstrip_solve(Some(&contact), Some(&creepage), Some(&options), Some(&mut out));
        // SAFETY: initialised above.
        let r = unsafe { out.assume_init() };
        let numbers = [r.fx, r.fy, r.mz, r.power, r.adhesion];
        let well = if status < 0 {
            refused += 1;
            r == untouched
        } else {
            warned += u64::from(status > 0);
            let bound = contact.friction * contact.normal_force.max(0.0);
            numbers.iter().all(|number| number.is_finite())
                && (model == KSTRIP_MODEL_LINEAR
                    || r.fx.hypot(r.fy) <= bound * (1.0 + 1e-12) + f64::MIN_POSITIVE)
                && (-1.0..=1.0).contains(&r.adhesion)
        };
        if !well {
            return Err(format!(
                "block {block}, solve {i}: {contact:?} {creepage:?} {options:?} gives {status} {r:?}"
            ));
        }
        for number in numbers {
            // FNV-1a, 64 bits at a time
            hash = (hash ^ number.to_bits()).wrapping_mul(0x0100_0000_01b3);
        }
    }
    Ok((hash, refused, warned))
}

/// Resident memory in kB, where the system tells.
fn resident() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmRSS:"))?;
    line.split_whitespace().nth(1)?.parse().ok()
}

fn run() -> Result<(), String> {
    let mut arguments = std::env::args().skip(1);
    let wanted: f64 = match arguments.next() {
        Some(text) => text.parse().map_err(|_| format!("{text} is not a number of solves"))?,
        None => 1e9,
    };
    let path = arguments.next();
    let wanted = wanted as u64;
    let known = path.as_deref().and_then(State::load);
    let resumed = known.is_some_and(|state| state.solves > 0);
    let mut state = known.unwrap_or_default();
    let sample = solve_block(0, SAMPLE)?.0;
    if resumed && sample != state.sample {
        return Err("the first block has other results than when this run began".to_owned());
    }
    state.sample = sample;

    let bar = ProgressBar::new(wanted);
    let style =
        "{elapsed_precise} {wide_bar} {human_pos}/{human_len} {per_sec}, {eta_precise} left";
    bar.set_style(ProgressStyle::with_template(style).map_err(|error| error.to_string())?);
    bar.set_position(state.solves);
    bar.reset_eta();
    let (begin, before) = (Instant::now(), state.seconds);
    // Memory is looked at once everything has been used.
    let mut first_resident = None;
    let mut most_resident = 0;
    while state.solves < wanted {
        let block = state.solves / BLOCK;
        let count = BLOCK.min(wanted - state.solves);
        let (hash, refused, warned) = solve_block(block, count)?;
        state.hash = (state.hash ^ hash).wrapping_mul(0x0100_0000_01b3);
        state.solves += count;
        state.refused += refused;
        state.warned += warned;
        state.seconds = before + begin.elapsed().as_secs_f64();
        if (block + 1).is_multiple_of(CHECK_EVERY) && solve_block(0, SAMPLE)?.0 != state.sample {
            return Err(format!("after block {block} the first block has other results"));
        }
        if let Some(memory) = resident() {
            let first = *first_resident.get_or_insert(memory);
            most_resident = most_resident.max(memory);
            if memory > first + 4096 {
                return Err(format!("memory grew from {first} kB to {memory} kB"));
            }
        }
        if let Some(path) = &path {
            state.store(path).map_err(|error| format!("{path}: {error}"))?;
        }
        bar.set_position(state.solves);
    }
    bar.finish();
    let State { solves, refused, warned, hash, seconds, .. } = state;
    println!("{solves} solves, {refused} refused, {warned} with a warning, hash {hash:016x}");
    let rate = solves as f64 / seconds.max(1e-9) / 1e6;
    println!(
        "{seconds:.0} s, {rate:.2} million solves per second (inputs, checks and hash included)"
    );
    match first_resident {
        Some(first) => println!(
            "resident memory: {first} kB after the first block, at most {most_resident} kB"
        ),
        None => println!("resident memory: SKIPPED, this system does not tell"),
    }
    println!(
        "the first block gives the same bits as at the start: {}",
        solve_block(0, SAMPLE)?.0 == state.sample
    );
    Ok(())
}

fn main() -> std::process::ExitCode {
    match run() {
        Ok(()) => std::process::ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("soak: {message}");
            std::process::ExitCode::FAILURE
        }
    }
}
