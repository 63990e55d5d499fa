use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;
use horus_host::log::{Comparison, ReadEnd, compare};

use super::report;
use super::verdict::Verdict;

/// Compare two logs.
#[derive(Debug, Args)]
pub struct CompareOptions {
    /// The first log
    a: PathBuf,
    /// The second log
    b: PathBuf,
    /// Print one JSON object and nothing else
    #[arg(long)]
    json: bool,
}

pub fn run(options: &CompareOptions) -> anyhow::Result<Verdict> {
    let comparison = compare(&options.a, &options.b)?;
    report::print(&comparison, table(&comparison), options.json)?;
    Ok(if comparison.equal {
        Verdict::Equal
    } else {
        Verdict::Different
    })
}

/// One line per topic, then the first difference of each.
fn table(comparison: &Comparison) -> String {
    let names = comparison.topics.iter().map(|topic| topic.topic.len());
    let width = names.max().unwrap_or(0).max(5);
    let mut text = format!("{:width$}  messages a  messages b  differing  cells\n", "topic");
    for topic in &comparison.topics {
        let _ = writeln!(
            text,
            "{:width$}  {:>10}  {:>10}  {:>9}  {:>5}",
            topic.topic, topic.messages_a, topic.messages_b, topic.differing_messages, topic.differing_cells
        );
    }
    for topic in &comparison.topics {
        if let Some(first) = &topic.first {
            let _ = writeln!(text, "first difference on {}: {first}", topic.topic);
        }
    }
    for (name, end) in [("first", comparison.end_a), ("second", comparison.end_b)] {
        if let ReadEnd::Truncated { offset } = end {
            let _ = writeln!(
                text,
                "the {name} log is truncated: it was read up to byte {offset}"
            );
        }
    }
    text.push_str(if comparison.equal { "equal" } else { "different" });
    text
}
