use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::PathBuf;

use anyhow::{Context, bail};
use clap::Args;
use horus_host::log::{Comparison, ReadEnd, compare_with};

use super::difference::Differences;
use super::report;
use super::verdict::Verdict;

/// Compare two logs.
#[derive(Debug, Args)]
pub struct CompareOptions {
    /// The first log
    a: PathBuf,
    /// The second log
    b: PathBuf,
    /// Let floats and known cells of a topic differ by this much; may be given once per topic
    #[arg(long, value_name = "TOPIC=NUMBER", value_parser = tolerance)]
    tolerance: Vec<(String, f64)>,
    /// Write a log of what differs: /a and /b with the messages, /difference with the cells
    #[arg(long, value_name = "FILE")]
    diff: Option<PathBuf>,
    /// Paint the first grid that differs: in the first log, in the second, and where
    #[arg(long, value_name = "FILE")]
    picture: Option<PathBuf>,
    /// Print one JSON object and nothing else
    #[arg(long)]
    json: bool,
}

pub fn run(options: &CompareOptions) -> anyhow::Result<Verdict> {
    let mut tolerances = BTreeMap::new();
    for (topic, tolerance) in &options.tolerance {
        if tolerances.insert(topic.clone(), *tolerance).is_some() {
            bail!("the tolerance of {topic} is given twice");
        }
    }
    let mut differences = Differences::new(
        options.diff.as_deref(),
        options.picture.as_deref(),
        [&options.a, &options.b],
    )?;
    let comparison = compare_with(&options.a, &options.b, &tolerances, &mut |pair| {
        differences.add(pair)
    })?;
    differences.finish()?;
    if let Some(unused) = tolerances.keys().find(|topic| {
        let mut topics = comparison.topics.iter();
        !topics.any(|compared| compared.topic == **topic)
    }) {
        bail!("neither log has the topic {unused} of a tolerance");
    }
    report::print(&comparison, table(&comparison), options.json)?;
    Ok(if comparison.equal {
        Verdict::Equal
    } else {
        Verdict::Different
    })
}

/// `TOPIC=NUMBER`.
fn tolerance(text: &str) -> anyhow::Result<(String, f64)> {
    let (topic, number) = text.rsplit_once('=').context("it must be TOPIC=NUMBER")?;
    match number.parse::<f64>() {
        Ok(number) if number >= 0.0 && number.is_finite() && !topic.is_empty() => {
            Ok((topic.to_owned(), number))
        }
        _ => bail!("it must be TOPIC=NUMBER with a number of zero or more"),
    }
}

/// One line per topic, then the first difference of each.
fn table(comparison: &Comparison) -> String {
    let names = comparison.topics.iter().map(|topic| topic.topic.len());
    let width = names.max().unwrap_or(0).max(5);
    let mut text = format!(
        "{:width$}  messages a  messages b  tolerance  differing  cells\n",
        "topic"
    );
    for topic in &comparison.topics {
        let _ = writeln!(
            text,
            "{:width$}  {:>10}  {:>10}  {:>9}  {:>9}  {:>5}",
            topic.topic,
            topic.messages_a,
            topic.messages_b,
            topic.tolerance,
            topic.differing_messages,
            topic.differing_cells
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
