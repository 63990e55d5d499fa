use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Context, bail};
use clap::Args;
use serde::Serialize;

use super::domain;
use super::inlet::Inlet;
use super::live_log::LiveLog;
use crate::cli::progress;
use crate::cli::report;
use crate::cli::survey::in_file;
use crate::cli::verdict::Verdict;

/// How often new topics and publishers are looked for, and messages where there were none.
const LOOK: Duration = Duration::from_millis(50);
const POLL: Duration = Duration::from_micros(200);

/// Record topics in shared memory as a log.
#[derive(Debug, Args)]
pub struct SubscribeOptions {
    /// The log to write (MCAP)
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// Only these topics; may be given several times
    #[arg(long, value_name = "TOPIC")]
    topic: Vec<String>,
    /// Stop after N messages
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    limit: Option<u64>,
    /// Stop when no message has come for so long; otherwise when all publishers are gone, or at Ctrl-C
    #[arg(long, value_name = "S", value_parser = clap::value_parser!(u32).range(1..=86_400))]
    timeout: Option<u32>,
    /// Only topics of the same domain are seen [default: $HORUS_DOMAIN, else 0]
    #[arg(long, value_name = "NAME")]
    domain: Option<String>,
    /// Print one JSON object and nothing else
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Serialize)]
struct Subscribed {
    /// Messages written, by topic.
    topics: BTreeMap<String, u64>,
    messages: u64,
    /// Topics that carry nothing a log can hold.
    skipped_topics: Vec<String>,
    files: [PathBuf; 1],
}

pub fn run(options: &SubscribeOptions) -> anyhow::Result<Verdict> {
    let out = &options.out;
    let domain = domain(options.domain.as_deref())?;
    let stop = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&stop);
    ctrlc::set_handler(move || flag.store(true, Ordering::Relaxed)).context("cannot watch for Ctrl-C")?;

    let mut log = LiveLog::new(out)?;
    let mut inlets = BTreeMap::<String, Option<Inlet>>::new();
    let mut subscribed = Subscribed {
        topics: BTreeMap::new(),
        messages: 0,
        skipped_topics: Vec::new(),
        files: [out.clone()],
    };
    let bar = progress::ticks();
    let timeout = options.timeout.map(|seconds| Duration::from_secs(seconds.into()));
    let (mut looked, mut last, mut had_publishers) = (None::<Instant>, Instant::now(), false);
    let is_full = |messages| options.limit.is_some_and(|limit| messages >= limit);
    'receive: while !stop.load(Ordering::Relaxed) {
        let mut came = false;
        for (name, inlet) in &inlets {
            let Some(inlet) = inlet else { continue };
            while inlet.take(name, &mut log).with_context(|| name.clone())? {
                came = true;
                *subscribed.topics.entry(name.clone()).or_default() += 1;
                subscribed.messages += 1;
                if is_full(subscribed.messages) {
                    break 'receive;
                }
            }
        }
        bar.set_position(subscribed.messages);
        if came {
            last = Instant::now();
        }
        if looked.is_none_or(|looked| looked.elapsed() >= LOOK) {
            looked = Some(Instant::now());
            for name in domain.topics()? {
                let is_wanted = options.topic.is_empty() || options.topic.contains(&name);
                if is_wanted && !inlets.contains_key(&name) {
                    let inlet = Inlet::open(&domain, &name)?;
                    if inlet.is_none() {
                        subscribed.skipped_topics.push(name.clone());
                    }
                    inlets.insert(name, inlet);
                    came = true; // its first message may be there
                }
            }
            let has_publishers = inlets.values().flatten().any(Inlet::has_publishers);
            if timeout.is_none() && !came && had_publishers && !has_publishers {
                break; // nothing came since they were last seen
            }
            had_publishers |= has_publishers;
        }
        if timeout.is_some_and(|timeout| last.elapsed() >= timeout) {
            break;
        }
        if !came {
            thread::sleep(POLL);
        }
    }
    bar.finish_and_clear();
    if subscribed.messages == 0 {
        log.discard();
        bail!("no message came on any topic");
    }
    log.finish().map_err(|error| in_file(out, error))?;
    let text = format!(
        "{} messages of {} topics written to {}",
        subscribed.messages,
        subscribed.topics.len(),
        out.display()
    );
    report::print(&subscribed, text, options.json)?;
    Ok(Verdict::Whole)
}
