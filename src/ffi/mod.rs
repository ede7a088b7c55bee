//! The C interface: C types in, C types out; no physics.
//!
//! Structures of the core have the layout of C (`#[repr(C)]`), so that nothing is converted: they
//! come in as `Option<&T>` and go out through `Option<&mut MaybeUninit<T>>`. These have the layout
//! of C pointers and need no unsafe code. Only arrays and structures of pointers need it.
//!
//! The functions stand once, in `exports`, in the order of the header; `double.rs` and `single.rs`
//! compile them for both precisions. `tests/interface/binary_interface.rs` writes the headers.

#![allow(non_camel_case_types)]
// The exported functions are compiled for two precisions from one text.
#![allow(clippy::duplicate_mod)]
// Exported names and C arrays. SECURITY.md lists every file with unsafe code.
#![allow(unsafe_code)]
// What C callers promise about pointers stands once, at the head of the header.
#![allow(clippy::missing_safety_doc)]
// The comments are written for the C header: [N] is a unit and [out] a direction there.
#![allow(rustdoc::broken_intra_doc_links)]

mod constants;
mod support;

pub mod double;
pub mod single;
pub mod types;

pub use self::constants::*;
pub use crate::status::*;

use crate::status::c_string;
use core::ffi::c_char;
use core::mem::MaybeUninit;
use support::write_result;
use types::kstrip_options;

/// Text in English with the cause of a status and the remedy.
///
/// @param status  a status that a function returned, or any other number.
/// @return a static string, never NULL; "unknown status" for a number that is no status.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_status_string(status: kstrip_status) -> *const c_char {
    advice(status).unwrap_or(c"unknown status").as_ptr()
}

/// Version of the library that is linked, such as "0.2.0". Never NULL.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_version_string() -> *const c_char {
    const { c_string(concat!(env!("CARGO_PKG_VERSION"), "\0")) }.as_ptr()
}

/// ABI version of the library that is linked: compare with KSTRIP_ABI_VERSION of the header.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_abi_version() -> i32 {
    KSTRIP_ABI_VERSION
}

/// Fill options with zero, the defaults: KSTRIP_MODEL_DEFAULT and 16 strips.
/// `kstrip_options o = {0}` does the same.
///
/// @param[out] options  receives the defaults.
/// @return KSTRIP_OK, or KSTRIP_ERROR_NULL if options is NULL.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_options_init(
    options: Option<&mut MaybeUninit<kstrip_options>>,
) -> kstrip_status {
    write_result(options, || Ok(kstrip_options { model: KSTRIP_MODEL_DEFAULT, strips: 0 }))
}
