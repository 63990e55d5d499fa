use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use anyhow::{Context, bail};
use horus_host::log::msg::{Message, OccupancyGrid};
use horus_host::log::{LogEntry, LogReader};
use horus_host::map_server::MapFile;

use crate::cli::survey::in_file;

/// First bytes of an MCAP file.
const MCAP: [u8; 5] = *b"\x89MCAP";

/// A map to save, from a map file or from a log.
pub struct SourceMap {
    pub size: (u32, u32),
    pub resolution: f64,
    pub origin: [f64; 3],
    pub cells: Vec<i8>,
    /// What it was read from.
    pub files: Vec<PathBuf>,
}

impl SourceMap {
    /// Reads a map file, or the last occupancy grid on a topic of a log.
    pub fn read(path: &Path, topic: &str) -> anyhow::Result<Self> {
        let mut start = [0; MCAP.len()];
        let mut file = File::open(path).with_context(|| format!("cannot open {}", path.display()))?;
        if file.read_exact(&mut start).is_ok() && start == MCAP {
            return Self::from_log(path, topic);
        }
        let map = MapFile::load(path, &mut |_, _| {})?;
        let image = path.parent().unwrap_or(Path::new("")).join(&map.yaml.image);
        Ok(Self {
            files: vec![path.to_owned(), image],
            size: (map.width, map.height),
            resolution: map.yaml.resolution,
            origin: map.yaml.origin,
            cells: map.cells,
        })
    }

    fn from_log(path: &Path, topic: &str) -> anyhow::Result<Self> {
        let name = path.display();
        let mut reader = LogReader::open(path).map_err(|error| in_file(path, error))?;
        let mut last = None;
        let mut others = std::collections::BTreeSet::new();
        for entry in &mut reader {
            let LogEntry::Message(message) = entry.map_err(|error| in_file(path, error))? else {
                continue;
            };
            if message.topic() == topic {
                last = Some(message);
            } else if message.channel.type_name == OccupancyGrid::TYPE {
                others.insert(message.topic().to_owned());
            }
        }
        let Some(message) = last else {
            let others = others.into_iter().collect::<Vec<_>>().join(", ");
            match others.is_empty() {
                true => bail!("{name}: the log holds no occupancy grid"),
                false => bail!("{name}: no message on {topic}: occupancy grids are on {others}"),
            }
        };
        let grid: OccupancyGrid = message.decode().map_err(|error| in_file(path, error))?;
        let (info, pose) = (&grid.info, &grid.info.origin);
        Ok(Self {
            files: vec![path.to_owned()],
            size: (info.width, info.height),
            // Decimal, as it was most likely meant: 0.05, not 0.05000000074505806.
            resolution: info
                .resolution
                .to_string()
                .parse()
                .unwrap_or(info.resolution.into()),
            origin: [pose.position.x, pose.position.y, pose.orientation.yaw()],
            cells: grid.data,
        })
    }
}
