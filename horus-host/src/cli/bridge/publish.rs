use std::collections::BTreeMap;
use std::path::PathBuf;
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Context, bail};
use clap::Args;
use horus_host::log::{LogEntry, LogReader};
use serde::Serialize;

use super::domain;
use super::outlet::Outlet;
use crate::cli::report;
use crate::cli::survey::in_file;
use crate::cli::verdict::Verdict;

/// How long topics stay after the last message, so that those who read slowly can open what grew.
const LINGER: Duration = Duration::from_millis(300);

/// Publish a log over shared memory.
#[derive(Debug, Args)]
pub struct PublishOptions {
    /// The log (MCAP)
    log: PathBuf,
    /// Only these topics; may be given several times
    #[arg(long, value_name = "TOPIC")]
    topic: Vec<String>,
    /// How much faster than it was recorded; 0 is as fast as subscribers read
    #[arg(
        long,
        value_name = "FACTOR",
        default_value_t = 1.0,
        allow_negative_numbers = true
    )]
    rate: f64,
    /// Wait for so many subscribers on each topic before the first message
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u8).range(..=16))]
    wait: u8,
    /// How long to wait for them
    #[arg(long, value_name = "S", default_value_t = 30, value_parser = clap::value_parser!(u32).range(1..=86_400))]
    patience: u32,
    /// Only processes of the same domain see the topics [default: $HORUS_DOMAIN, else 0]
    #[arg(long, value_name = "NAME")]
    domain: Option<String>,
    /// Print one JSON object and nothing else
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Serialize)]
struct Published {
    log: PathBuf,
    /// Messages sent, by topic.
    topics: BTreeMap<String, u64>,
    messages: u64,
    /// Messages that no topic carries.
    skipped: u64,
}

pub fn run(options: &PublishOptions) -> anyhow::Result<Verdict> {
    let rate = options.rate;
    if !(rate >= 0.0 && rate.is_finite()) {
        bail!("a rate is zero or more, not {rate}");
    }
    let log = &options.log;
    let domain = domain(options.domain.as_deref())?;
    let is_wanted = |topic: &str| options.topic.is_empty() || options.topic.iter().any(|name| name == topic);

    // All topics exist before the first message, so that subscribers can be waited for.
    let mut outlets = BTreeMap::<String, Option<Outlet>>::new();
    for entry in LogReader::open(log).map_err(|error| in_file(log, error))? {
        if let LogEntry::Message(message) = entry.map_err(|error| in_file(log, error))?
            && is_wanted(message.topic())
            && !outlets.contains_key(message.topic())
        {
            let outlet = Outlet::open(&domain, &message).with_context(|| log.display().to_string())?;
            outlets.insert(message.topic().to_owned(), outlet);
        }
    }
    if let Some(missing) = options.topic.iter().find(|topic| !outlets.contains_key(*topic)) {
        bail!("{}: the log has no topic {missing}", log.display());
    }
    if outlets.values().all(Option::is_none) {
        bail!("{}: the log holds nothing that a topic carries", log.display());
    }
    let deadline = Instant::now() + Duration::from_secs(options.patience.into());
    for outlet in outlets.values().flatten() {
        let left = deadline.saturating_duration_since(Instant::now());
        outlet.wait_for_subscribers(options.wait.into(), left)?;
    }

    let mut published = Published {
        log: log.clone(),
        topics: BTreeMap::new(),
        messages: 0,
        skipped: 0,
    };
    let start = Instant::now();
    let mut first_ns = None;
    for entry in LogReader::open(log).map_err(|error| in_file(log, error))? {
        let LogEntry::Message(message) = entry.map_err(|error| in_file(log, error))? else {
            continue;
        };
        let Some(outlet) = outlets.get(message.topic()) else {
            continue; // not wanted
        };
        let Some(outlet) = outlet else {
            published.skipped += 1;
            continue;
        };
        if rate > 0.0 {
            let since = message
                .log_time_ns
                .saturating_sub(*first_ns.get_or_insert(message.log_time_ns));
            let due = Duration::from_nanos((since as f64 / rate) as u64); // saturates
            thread::sleep(due.saturating_sub(start.elapsed()));
        }
        outlet.send(&message).with_context(|| log.display().to_string())?;
        *published.topics.entry(message.topic().to_owned()).or_default() += 1;
        published.messages += 1;
    }
    if published.messages > 0 {
        thread::sleep(LINGER);
    }
    let text = format!(
        "{}: {} messages sent, {} of other types skipped",
        log.display(),
        published.messages,
        published.skipped
    );
    report::print(&published, text, options.json)?;
    Ok(Verdict::Whole)
}
