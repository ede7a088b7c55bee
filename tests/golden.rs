//! The same inputs give the same bits: in this (debug) build, through the C interface of the optimised
//! library, in a batch, on two threads, and compiled for this very processor. `scripts/firmware.sh` runs the
//! first thousand on a simulated Cortex-M4 and Cortex-M7.
//!
//! `KSTRIP_WRITE_GOLDEN=1 cargo test --test golden` writes the hashes anew after a deliberate change.

#[path = "common/single.rs"]
mod single;
#[path = "c/toolchain.rs"]
mod toolchain;

use kstrip::contact::Contact;
use kstrip::creepage::Creepage;
use kstrip::model::{Field, Model, Options, Precision, solve, solve_jacobian};
use kstrip::status::Error;
use kstrip::totals::StripCount;
use std::process::Command;
use toolchain::{root, run_c_with, say};

const CASES: u32 = 100_000;
const BLOCK: u32 = 1000;
const START: u64 = 0xcbf2_9ce4_8422_2325;

/// FNV-1a, 64 bits at a time.
fn mixed(hash: u64, bits: u64) -> u64 {
    (hash ^ bits).wrapping_mul(0x0100_0000_01b3)
}

/// An integer for case `i`, as in `tests/c/golden.c`.
fn draw(i: u32, salt: u32, below: u32) -> u32 {
    let x = i.wrapping_mul(2_654_435_761).wrapping_add(salt.wrapping_mul(2_246_822_519));
    let x = (x ^ (x >> 15)).wrapping_mul(2_246_822_519);
    let x = (x ^ (x >> 13)).wrapping_mul(3_266_489_917);
    (x ^ (x >> 16)) % below
}

fn creep(i: u32, salt: u32, unit: f64) -> f64 {
    let sizes = [1.0, 10.0, 100.0, 1000.0, 10000.0];
    let whole = f64::from(draw(i, salt, 2001)) - 1000.0;
    if draw(i, salt + 1, 8) == 0 {
        0.0
    } else {
        whole / (unit * sizes[draw(i, salt + 2, 5) as usize])
    }
}

fn inputs(i: u32) -> (Contact<f64>, Creepage<f64>, Options) {
    let contact = Contact {
        a: f64::from(1 + draw(i, 1, 200)) / 20000.0,
        b: f64::from(1 + draw(i, 2, 200)) / 20000.0,
        normal_force: f64::from(1000 + draw(i, 3, 200_000)),
        shear_modulus: f64::from(1 + draw(i, 4, 100)) * 1e9,
        poisson_ratio: f64::from(draw(i, 5, 101)) / 200.0,
        friction: f64::from(1 + draw(i, 6, 100)) / 100.0,
    };
    let creepage = Creepage {
        longitudinal: creep(i, 7, 1000.0),
        lateral: creep(i, 10, 1000.0),
        spin: creep(i, 13, 10.0),
    };
    let options = Options {
        model: Model::ALL[i as usize % 5],
        strips: StripCount::from_number(4 << draw(i, 16, 5)).expect("a count"),
    };
    (contact, creepage, options)
}

fn code(error: Error) -> u64 {
    u64::from(error.code() as u32)
}

/// What `case_double` and `case_single` of the C program do.
fn hash_case<F: Precision>(
    mut hash: u64,
    i: u32,
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
    bits: fn(F) -> u64,
) -> u64 {
    let r = solve(contact, creepage, options).expect("ordinary inputs");
    hash = mixed(hash, u64::from(r.notice.code() as u32));
    for number in [r.fx, r.fy, r.mz, r.power, r.adhesion] {
        hash = mixed(hash, bits(number));
    }
    if i % 100 >= 5 {
        return hash;
    }
    let (r, jacobian) = solve_jacobian(contact, creepage, options).expect("ordinary inputs");
    hash = mixed(hash, u64::from(r.notice.code() as u32));
    for entry in jacobian.transpose().iter() {
        hash = mixed(hash, bits(*entry));
    }
    for n in [-1.0, 0.0, 1.0] {
        let field = match Field::new(contact, creepage, options) {
            Ok(field) => field,
            Err(error) => {
                hash = mixed(hash, code(error));
                continue;
            }
        };
        hash = mixed(hash, u64::from(field.notice.code() as u32));
        let place = |axis: F, parts: f64| axis * F::of(n) / F::of(parts);
        let p = field.at(place(contact.a, 2.0), place(contact.b, 4.0));
        for number in [p.pressure, p.traction_x, p.traction_y, p.slip_x, p.slip_y] {
            hash = mixed(hash, bits(number));
        }
        hash = mixed(hash, p.state as u64);
    }
    hash
}

fn hashes_of_rust() -> String {
    let mut blocks = [Vec::new(), Vec::new()];
    for block in 0..CASES / BLOCK {
        let [mut two, mut one] = [START; 2];
        for i in block * BLOCK..(block + 1) * BLOCK {
            let (contact, creepage, options) = inputs(i);
            two = hash_case(two, i, &contact, &creepage, &options, f64::to_bits);
            let (contact, creepage) = (single::single(&contact), single::single_motion(&creepage));
            one = hash_case(one, i, &contact, &creepage, &options, |x| u64::from(x.to_bits()));
        }
        blocks[0].push(two);
        blocks[1].push(one);
    }
    let mut text = String::new();
    for count in [(CASES / BLOCK) as usize, 1] {
        for (name, hashes) in ["double", "single"].iter().zip(&blocks) {
            let hash = hashes[..count].iter().fold(START, |hash, block| mixed(hash, *block));
            text += &format!("{name} {} {hash:016x}\n", count * BLOCK as usize);
        }
    }
    text
}

#[test]
fn every_build_gives_the_golden_bits() {
    let path = root().join("tests/data/golden.txt");
    let here = hashes_of_rust();
    if std::env::var_os("KSTRIP_WRITE_GOLDEN").is_some() {
        std::fs::write(&path, &here).expect("tests/data is writable");
    }
    let golden = std::fs::read_to_string(&path).expect("the golden hashes");
    let way = "KSTRIP_WRITE_GOLDEN=1 cargo test --test golden, if results were to change";
    assert_eq!(here, golden, "this build; {way}");
    for mode in [&[][..], &["batch"], &["threads"]] {
        assert_eq!(run_c_with("tests/c/golden.c", mode), golden, "C program, {mode:?}; {way}");
    }
}

/// A library for this very processor, with all of its instructions, rounds the same.
#[test]
fn the_native_processor_gives_the_golden_bits() {
    let golden = std::fs::read_to_string(root().join("tests/data/golden.txt")).expect("hashes");
    let target = concat!(env!("CARGO_TARGET_TMPDIR"), "/native");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(root()).env_remove("CARGO_BUILD_TARGET");
    cargo.env("RUSTFLAGS", "-C target-cpu=native");
    cargo.args(["rustc", "--locked", "--release", "--lib", "--crate-type", "staticlib"]);
    cargo.args(["--features", "panic-handler", "--target-dir", target]);
    let output = cargo.output().expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let program = format!("{target}/golden");
    let built = Command::new("cc")
        .args(["-std=c99", "-O2", "-ffp-contract=off", "-I"])
        .arg(root().join("include"))
        .arg(root().join("tests/c/golden.c"))
        .arg(format!("{target}/release/libkstrip.a"))
        .args(["-lpthread", "-o", &program])
        .output();
    match built {
        Ok(output) if output.status.success() => {}
        Ok(output) => panic!("{}", String::from_utf8_lossy(&output.stderr)),
        Err(error) => {
            say(&format!("SKIPPED: golden bits with target-cpu=native: no cc ({error})"));
            return;
        }
    }
    let output = Command::new(&program).output().expect("the program runs");
    assert_eq!(String::from_utf8_lossy(&output.stdout), golden, "target-cpu=native");
}
