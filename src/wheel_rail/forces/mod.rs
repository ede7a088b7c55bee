//! Forces of the contacts of a wheel: the wrench of all of them (`wrench`), a patch that rolls
//! forward and backward (`ends`), and strips with a slip of their own (`curved`).

mod curved;
mod ends;
pub mod wrench;
