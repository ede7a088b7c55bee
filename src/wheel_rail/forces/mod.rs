//! Forces of the contacts of a wheel: the wrench of all of them (`wrench`), load and power across
//! one of them (`across`), a patch that rolls forward and backward (`ends`), and strips with a slip
//! of their own (`curved`).

pub mod across;
mod curved;
mod ends;
pub mod wrench;
