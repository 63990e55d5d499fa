use std::io::{IsTerminal, stderr};

use indicatif::{ProgressBar, ProgressStyle};

/// A progress bar over `scans` on standard error, hidden unless that is a terminal.
pub fn bar(scans: u64) -> ProgressBar {
    if !stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} scans, {elapsed} of {duration}");
    ProgressBar::new(scans).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// A counter of recorded ticks on standard error, hidden unless that is a terminal.
pub fn ticks() -> ProgressBar {
    if !stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{spinner} {pos} ticks in {elapsed}, {msg}; Ctrl-C ends");
    ProgressBar::new_spinner().with_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()))
}

/// A progress bar over the `rows` of a map and what is done with them, on standard error, hidden
/// unless that is a terminal.
pub fn rows(rows: u64) -> ProgressBar {
    if !stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} rows, {msg}, {elapsed}");
    ProgressBar::new(rows).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
