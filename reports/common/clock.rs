//! Processor time of this thread: what other programs do meanwhile does not count.

use rustix::time::{ClockId, clock_gettime};

/// Nanoseconds since the thread began.
pub fn now() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.tv_sec as f64 * 1e9 + time.tv_nsec as f64
}

/// Nanoseconds that it takes, of processor time.
pub fn took(run: impl FnOnce()) -> f64 {
    let start = now();
    run();
    now() - start
}
