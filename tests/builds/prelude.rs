//! What most files of this program use.

#[path = "../common/prelude.rs"]
mod shared;

pub(crate) use crate::header;
pub(crate) use crate::toolchain::{
    cpp_compilers, output_of, root, run_cpp, run_source, say, scratch,
};
pub(crate) use shared::*;
