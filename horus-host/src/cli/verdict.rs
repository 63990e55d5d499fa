use std::process::ExitCode;

/// How a command that could do its work ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    Equal,
    Different,
    /// Everything that was to be recorded is.
    Whole,
    /// Something is missing from what was recorded.
    Lossy,
}

impl From<Verdict> for ExitCode {
    fn from(verdict: Verdict) -> Self {
        match verdict {
            Verdict::Equal | Verdict::Whole => ExitCode::SUCCESS,
            Verdict::Different | Verdict::Lossy => ExitCode::from(1),
        }
    }
}

/// The exit code of a command that could not do its work.
pub fn unusable() -> ExitCode {
    ExitCode::from(2)
}

/// An error and its causes in one line. A cause that the text before it already tells is left out.
pub fn one_sentence(error: &anyhow::Error) -> String {
    let mut sentence = String::new();
    for cause in error.chain() {
        let cause = cause.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
        if sentence.contains(&cause) {
            continue;
        }
        if !sentence.is_empty() {
            sentence.push_str(": ");
        }
        sentence.push_str(&cause);
    }
    sentence
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn causes_are_told_once_and_in_one_line() {
        let cause = anyhow::anyhow!("the disk\nis  full");
        let error = cause
            .context("cannot write: the disk is full")
            .context("out/core.mcap");
        assert_eq!(
            one_sentence(&error),
            "out/core.mcap: cannot write: the disk is full"
        );
    }
}
