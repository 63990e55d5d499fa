use std::collections::BTreeMap;
use std::fmt;
use std::fs;
use std::path::PathBuf;

use clap::Args;
use horus_host::log::msg::{Costmap, Grid, LaserScan, Message, OccupancyGrid, Pose};
use horus_host::log::{LogEntry, LogMessage, LogReader, ReadEnd};
use serde::Serialize;

use super::report;
use super::survey::in_file;
use super::verdict::Verdict;

/// Tell what is in a log.
#[derive(Debug, Args)]
pub struct InfoOptions {
    /// The log (MCAP)
    log: PathBuf,
    /// Print one JSON object and nothing else
    #[arg(long)]
    json: bool,
}

/// What is in a log.
#[derive(Debug, Serialize)]
struct Info {
    log: PathBuf,
    bytes: u64,
    messages: u64,
    start_ns: Option<u64>,
    end_ns: Option<u64>,
    duration_s: f64,
    /// Where a log that ends in the middle was left.
    truncated_at_byte: Option<u64>,
    topics: Vec<Topic>,
    /// Metadata records in file order.
    metadata: Vec<Record>,
}

#[derive(Debug, Serialize)]
struct Topic {
    topic: String,
    r#type: String,
    encoding: String,
    messages: u64,
    bytes: u64,
    start_ns: u64,
    end_ns: u64,
    /// Messages per second between the first and the last; `None` with less than two of them.
    rate_hz: Option<f64>,
    /// Of the last message, if it is a grid.
    grid: Option<Geometry>,
    /// Of the last message, if it is a scan.
    beams: Option<usize>,
    #[serde(skip)]
    last: Option<LogMessage>,
}

/// Size and place of a grid.
#[derive(Debug, Serialize)]
struct Geometry {
    frame: String,
    width: u32,
    height: u32,
    resolution: f64,
    origin: [f64; 3],
}

#[derive(Debug, Serialize)]
struct Record {
    name: String,
    values: BTreeMap<String, String>,
}

pub fn run(options: &InfoOptions) -> anyhow::Result<Verdict> {
    let info = survey(&options.log)?;
    report::print(&info, &info, options.json)?;
    Ok(Verdict::Whole)
}

fn survey(path: &std::path::Path) -> anyhow::Result<Info> {
    let mut topics = BTreeMap::<String, Topic>::new();
    let mut metadata = Vec::new();
    let mut reader = LogReader::open(path).map_err(|error| in_file(path, error))?;
    for entry in &mut reader {
        match entry.map_err(|error| in_file(path, error))? {
            LogEntry::Message(message) => {
                let topic = topics
                    .entry(message.topic().to_owned())
                    .or_insert_with(|| Topic::new(&message));
                topic.messages += 1;
                topic.bytes += message.payload.len() as u64;
                topic.start_ns = topic.start_ns.min(message.log_time_ns);
                topic.end_ns = topic.end_ns.max(message.log_time_ns);
                topic.last = Some(message);
            }
            LogEntry::Metadata { name, values } => metadata.push(Record { name, values }),
        }
    }
    let mut topics: Vec<Topic> = topics.into_values().collect();
    for topic in &mut topics {
        topic.conclude();
    }
    let start_ns = topics.iter().map(|topic| topic.start_ns).min();
    let end_ns = topics.iter().map(|topic| topic.end_ns).max();
    Ok(Info {
        log: path.to_owned(),
        bytes: fs::metadata(path).map_or(0, |file| file.len()),
        messages: topics.iter().map(|topic| topic.messages).sum(),
        duration_s: seconds(start_ns.unwrap_or(0), end_ns.unwrap_or(0)),
        start_ns,
        end_ns,
        truncated_at_byte: match reader.end() {
            Some(ReadEnd::Truncated { offset }) => Some(offset),
            _ => None,
        },
        topics,
        metadata,
    })
}

fn seconds(start_ns: u64, end_ns: u64) -> f64 {
    end_ns.saturating_sub(start_ns) as f64 * 1e-9
}

impl Topic {
    fn new(message: &LogMessage) -> Self {
        Self {
            topic: message.topic().to_owned(),
            r#type: message.channel.type_name.clone(),
            encoding: message.channel.encoding.clone(),
            messages: 0,
            bytes: 0,
            start_ns: message.log_time_ns,
            end_ns: message.log_time_ns,
            rate_hz: None,
            grid: None,
            beams: None,
            last: None,
        }
    }

    /// What follows from all messages, and what the last one tells. One that cannot be decoded tells
    /// nothing: that is for those who need it to complain about.
    fn conclude(&mut self) {
        let duration = seconds(self.start_ns, self.end_ns);
        if self.messages > 1 && duration > 0.0 {
            self.rate_hz = Some((self.messages - 1) as f64 / duration);
        }
        let Some(last) = self.last.take() else { return };
        match self.r#type.as_str() {
            OccupancyGrid::TYPE => self.grid = last.decode().ok().map(|map| Geometry::of_map(&map)),
            Costmap::TYPE => self.grid = last.decode().ok().map(|map| Geometry::of_costs(&map)),
            Grid::TYPE => self.grid = last.decode().ok().map(|grid| Geometry::of_values(&grid)),
            LaserScan::TYPE => self.beams = last.decode().ok().map(|scan: LaserScan| scan.ranges.len()),
            _ => {}
        }
    }
}

impl Geometry {
    fn of_map(map: &OccupancyGrid) -> Self {
        let info = &map.info;
        Self::new(
            &map.header.frame_id,
            [info.width, info.height],
            info.resolution.into(),
            &info.origin,
        )
    }

    fn of_costs(map: &Costmap) -> Self {
        let info = &map.metadata;
        Self::new(
            &map.header.frame_id,
            [info.size_x, info.size_y],
            info.resolution.into(),
            &info.origin,
        )
    }

    fn of_values(grid: &Grid) -> Self {
        let rows = (grid.data.len() as u64)
            .checked_div(grid.row_stride.into())
            .unwrap_or(0);
        let rows = u32::try_from(rows).unwrap_or(u32::MAX);
        Self::new(
            &grid.frame_id,
            [grid.column_count, rows],
            grid.cell_size.x,
            &grid.pose,
        )
    }

    fn new(frame: &str, [width, height]: [u32; 2], resolution: f64, pose: &Pose) -> Self {
        Self {
            frame: frame.to_owned(),
            width,
            height,
            resolution,
            origin: [pose.position.x, pose.position.y, pose.orientation.yaw()],
        }
    }
}

impl fmt::Display for Info {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "log             {}, {} bytes, {} messages, {:.3} s",
            self.log.display(),
            self.bytes,
            self.messages,
            self.duration_s
        )?;
        if let Some(offset) = self.truncated_at_byte {
            writeln!(f, "truncated       it was read up to byte {offset}")?;
        }
        let width = |text: fn(&Topic) -> &str| {
            self.topics
                .iter()
                .map(|topic| text(topic).len())
                .max()
                .unwrap_or(0)
        };
        let (names, types) = (
            width(|topic| &topic.topic).max(5),
            width(|topic| &topic.r#type).max(4),
        );
        writeln!(
            f,
            "{:names$}  {:types$}  messages   rate Hz       bytes",
            "topic", "type"
        )?;
        for topic in &self.topics {
            let rate = topic
                .rate_hz
                .map_or_else(|| "-".to_owned(), |rate| format!("{rate:.2}"));
            write!(
                f,
                "{:names$}  {:types$}  {:>8}  {rate:>8}  {:>10}",
                topic.topic, topic.r#type, topic.messages, topic.bytes
            )?;
            if let Some(grid) = &topic.grid {
                let [x, y, yaw] = grid.origin;
                write!(
                    f,
                    "  {} x {} cells of {} m at ({x:.3}, {y:.3}, {yaw:.3}) in {}",
                    grid.width, grid.height, grid.resolution as f32, grid.frame
                )?;
            }
            if let Some(beams) = topic.beams {
                write!(f, "  {beams} beams")?;
            }
            writeln!(f)?;
        }
        for record in &self.metadata {
            writeln!(f, "metadata {}", record.name)?;
            for (key, value) in &record.values {
                writeln!(f, "  {key:22} {value}")?;
            }
        }
        Ok(())
    }
}
