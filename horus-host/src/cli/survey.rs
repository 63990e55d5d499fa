use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, anyhow, bail};
use horus_host::log::msg::{LaserScan, Message, TFMessage, TransformStamped};
use horus_host::log::{LogEntry, LogError, LogReader, ReadEnd};
use horus_host::tf::{TfBuffer, TfError, Transform};

/// What has to be known of a log before its scans can be replayed: all transforms (a scan may
/// stand before those it needs) and the topics.
#[derive(Debug)]
pub struct Survey {
    pub tf: TfBuffer,
    /// Transforms that no buffer can hold, and what is wrong with the first.
    pub rejected_transforms: u64,
    pub first_rejection: Option<String>,
    /// How the log ends.
    pub end: ReadEnd,
    topics: BTreeMap<String, Topic>,
}

#[derive(Debug, Default)]
struct Topic {
    type_name: String,
    scans: u64,
    beams: usize,
}

/// The scans to replay.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ScanTopic {
    pub name: String,
    pub scans: u64,
    /// Most beams a scan has.
    pub beams: usize,
}

impl Survey {
    /// Reads the whole log.
    pub fn of(path: &Path, longest_gap_ns: Option<u64>) -> anyhow::Result<Self> {
        let mut tf = TfBuffer::new();
        tf.set_max_gap_ns(longest_gap_ns);
        let mut survey = Self {
            tf,
            rejected_transforms: 0,
            first_rejection: None,
            end: ReadEnd::Complete,
            topics: BTreeMap::new(),
        };
        let mut reader = LogReader::open(path).map_err(|error| in_file(path, error))?;
        for entry in &mut reader {
            let LogEntry::Message(message) = entry.map_err(|error| in_file(path, error))? else {
                continue;
            };
            let type_name = &message.channel.type_name;
            let topic = survey.topics.entry(message.topic().to_owned()).or_default();
            topic.type_name.clone_from(type_name);
            if type_name == LaserScan::TYPE {
                topic.scans += 1;
                // One that cannot be decoded is an error only if its topic is replayed.
                let beams = message.decode::<LaserScan>().map_or(0, |scan| scan.ranges.len());
                topic.beams = topic.beams.max(beams);
            } else if type_name == TFMessage::TYPE {
                let is_static = match message.topic().rsplit('/').next() {
                    Some("tf") => false,
                    Some("tf_static") => true,
                    _ => continue,
                };
                let transforms: TFMessage = message.decode().map_err(|error| in_file(path, error))?;
                for transform in &transforms.transforms {
                    survey
                        .add(transform, is_static)
                        .with_context(|| path.display().to_string())?;
                }
            }
        }
        survey.end = reader.end().unwrap_or(ReadEnd::Complete);
        Ok(survey)
    }

    /// The scans to replay: those on `wanted`, else on the only topic with scans, else on `/scan`.
    pub fn scan_topic(&self, wanted: Option<&str>) -> anyhow::Result<ScanTopic> {
        let with_scans = || self.topics.iter().filter(|(_, topic)| topic.scans > 0);
        let chosen = match wanted {
            Some(name) => self
                .topics
                .get_key_value(name)
                .filter(|(_, topic)| topic.scans > 0),
            None if with_scans().count() == 1 => with_scans().next(),
            None => with_scans().find(|(name, _)| *name == "/scan"),
        };
        if let Some((name, topic)) = chosen {
            return Ok(ScanTopic {
                name: name.clone(),
                scans: topic.scans,
                beams: topic.beams,
            });
        }
        let list: Vec<&str> = with_scans().map(|(name, _)| name.as_str()).collect();
        let list = list.join(", ");
        match wanted.map(|name| (name, self.topics.get(name))) {
            _ if list.is_empty() => match self.end {
                ReadEnd::Complete => bail!("the log holds no {} messages", LaserScan::TYPE),
                ReadEnd::Truncated { offset } => bail!(
                    "the log is truncated at byte {offset} and holds no {} messages up to there",
                    LaserScan::TYPE
                ),
            },
            Some((name, Some(topic))) => {
                bail!("topic {name} holds {}, scans are on {list}", topic.type_name)
            }
            Some((name, None)) => bail!("the log has no topic {name}, scans are on {list}"),
            None => bail!("scans are on {list}, so choose one with --scan"),
        }
    }

    fn add(&mut self, stamped: &TransformStamped, is_static: bool) -> anyhow::Result<()> {
        let (t, q) = (&stamped.transform.translation, &stamped.transform.rotation);
        let transform = Transform {
            translation: [t.x, t.y, t.z],
            rotation: [q.x, q.y, q.z, q.w],
        };
        let (parent, child) = (&stamped.header.frame_id, &stamped.child_frame_id);
        let rejection = match stamped.header.stamp.to_ns() {
            Some(stamp_ns) => match self.tf.insert(parent, child, stamp_ns, transform, is_static) {
                Ok(()) => return Ok(()),
                Err(error @ TfError::Full { .. }) => return Err(error.into()),
                Err(error) => error.to_string(),
            },
            None => format!("the time of the transform from `{child}` lies before the epoch"),
        };
        self.rejected_transforms += 1;
        self.first_rejection.get_or_insert(rejection);
        Ok(())
    }
}

/// An error of the log module with the file it is about.
pub fn in_file(path: &Path, error: LogError) -> anyhow::Error {
    match error {
        LogError::Open { .. } | LogError::Create { .. } => error.into(), // these name it themselves
        error => anyhow!(error).context(path.display().to_string()),
    }
}
