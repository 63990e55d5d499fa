use std::fmt::Display;
use std::io::{ErrorKind, Write, stdout};

use anyhow::Context;
use serde::Serialize;

/// Prints a command's result: one JSON object, or the text made for people.
pub fn print(result: &impl Serialize, text: impl Display, json: bool) -> anyhow::Result<()> {
    let text = if json { to_json(result)? } else { text.to_string() };
    match writeln!(stdout().lock(), "{}", text.trim_end()) {
        // A reader that has seen enough is no failure.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        result => result.context("cannot write to standard output"),
    }
}

/// Pretty JSON.
pub fn to_json(result: &impl Serialize) -> anyhow::Result<String> {
    serde_json::to_string_pretty(result).context("cannot write the result as JSON")
}
