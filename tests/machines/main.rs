//! What builds the library again, for another machine or inside somebody else's program: installed
//! clients, a Python wheel, Windows, simulated boards, simulators, this very processor.
//! `cargo test` leaves it out, `.ci/run` calls `cargo test --test machines`.

mod firmware;
mod hosts;
mod install;
mod processor;
