use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

use anyhow::{Context, bail};
use horus_host::log::{LogEntry, LogMessage, LogReader};

use super::{GridPicture, is_grid};
use crate::cli::survey::in_file;

/// Topics that are painted without being asked for, the most wanted first.
const FAVOURITES: [&str; 3] = ["/costmap", "/local_map", "/map"];

/// Lethal cost where no metadata record tells it.
const LETHAL: u8 = 253;

/// The grids to paint.
pub struct Selection {
    pub topic: String,
    pub messages: u64,
    pub first_ns: u64,
}

impl Selection {
    /// Chooses a topic of the log.
    pub fn of(path: &Path, wanted: Option<&str>) -> anyhow::Result<Self> {
        let mut topics = BTreeMap::<String, u64>::new();
        let mut first_ns = u64::MAX;
        for entry in LogReader::open(path).map_err(|error| in_file(path, error))? {
            let LogEntry::Message(message) = entry.map_err(|error| in_file(path, error))? else {
                continue;
            };
            if is_grid(&message.channel.type_name) {
                *topics.entry(message.topic().to_owned()).or_default() += 1;
                first_ns = first_ns.min(message.log_time_ns);
            }
        }
        let name = path.display();
        let list = topics.keys().cloned().collect::<Vec<_>>().join(", ");
        let favourite = FAVOURITES.into_iter().find(|name| topics.contains_key(*name));
        let chosen = match wanted {
            Some(wanted) => topics.get_key_value(wanted),
            None => favourite
                .and_then(|name| topics.get_key_value(name))
                .or_else(|| topics.first_key_value()),
        };
        match chosen {
            Some((topic, &messages)) => Ok(Self {
                topic: topic.clone(),
                messages,
                first_ns,
            }),
            None if list.is_empty() => bail!("{name}: the log holds no grids"),
            None => bail!(
                "{name}: no grids on {}: they are on {list}",
                wanted.unwrap_or_default()
            ),
        }
    }
}

/// The lethal cost that a log's metadata names.
pub fn lethal_cost(path: &Path) -> anyhow::Result<u8> {
    for entry in LogReader::open(path).map_err(|error| in_file(path, error))? {
        match entry.map_err(|error| in_file(path, error))? {
            LogEntry::Metadata { name, values } if name == "horus" => {
                return Ok(values
                    .get("lethal_cost")
                    .and_then(|text| text.parse().ok())
                    .unwrap_or(LETHAL));
            }
            // Our logs start with it.
            LogEntry::Message(_) => break,
            LogEntry::Metadata { .. } => {}
        }
    }
    Ok(LETHAL)
}

/// The log to paint beside the first one, read as time goes on.
pub struct Partner<'a> {
    path: PathBuf,
    topic: &'a str,
    reader: LogReader<BufReader<File>>,
    next: Option<LogMessage>,
}

impl<'a> Partner<'a> {
    pub fn open(path: &Path, topic: &'a str) -> anyhow::Result<Self> {
        Ok(Self {
            path: path.to_owned(),
            topic,
            reader: LogReader::open(path).map_err(|error| in_file(path, error))?,
            next: None,
        })
    }

    /// The grid logged at `stamp_ns`, if there is one.
    pub fn at(&mut self, stamp_ns: u64, lethal_cost: u8) -> anyhow::Result<Option<GridPicture>> {
        loop {
            let message = match self.next.take() {
                Some(message) => message,
                None => match self.reader.next() {
                    None => return Ok(None),
                    Some(entry) => match entry.map_err(|error| in_file(&self.path, error))? {
                        LogEntry::Message(message) if message.topic() == self.topic => message,
                        _ => continue,
                    },
                },
            };
            if message.log_time_ns > stamp_ns {
                self.next = Some(message); // for a later one
                return Ok(None);
            }
            if message.log_time_ns == stamp_ns && is_grid(&message.channel.type_name) {
                let name = || self.path.display().to_string();
                return GridPicture::of(&message, lethal_cost)
                    .with_context(name)
                    .map(Some);
            }
        }
    }
}
