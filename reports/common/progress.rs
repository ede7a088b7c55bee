//! A progress bar with an estimate of the time left, on standard error; nothing is shown where that
//! is no terminal.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar over so many steps; its message says what is being done.
pub fn bar(steps: u64) -> ProgressBar {
    let bar = ProgressBar::new(steps);
    // A template that does not parse would leave the plain bar.
    if let Ok(style) = ProgressStyle::with_template(
        "{elapsed_precise} {wide_bar} {pos}/{len}, {eta_precise} left  {msg}",
    ) {
        bar.set_style(style);
    }
    bar.enable_steady_tick(std::time::Duration::from_millis(200));
    bar
}
