use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};

use horus_host::map_server::MapFile;
use serde::Serialize;

/// What a map is.
#[derive(Debug, Serialize)]
pub struct MapFacts {
    map: PathBuf,
    image: PathBuf,
    mode: String,
    width: u32,
    height: u32,
    /// Metres per cell.
    resolution: f64,
    /// x, y in metres, yaw in radians.
    origin: [f64; 3],
    /// Cells by occupancy.
    counts: BTreeMap<i8, u64>,
    /// What was written.
    pub files: Vec<PathBuf>,
}

impl MapFacts {
    pub fn new(path: &Path, map: &MapFile) -> Self {
        Self {
            map: path.to_owned(),
            image: map.yaml.image.clone(),
            mode: map.yaml.mode.to_string(),
            width: map.width,
            height: map.height,
            resolution: map.yaml.resolution,
            origin: map.yaml.origin,
            counts: map.counts(),
            files: Vec::new(),
        }
    }
}

impl fmt::Display for MapFacts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, yaw] = self.origin;
        writeln!(
            f,
            "map             {}, {}, {}",
            self.map.display(),
            self.image.display(),
            self.mode
        )?;
        writeln!(
            f,
            "size            {} x {} cells of {} m",
            self.width, self.height, self.resolution
        )?;
        writeln!(f, "origin          {x} m, {y} m, {yaw} rad")?;
        for (value, cells) in &self.counts {
            let name = match value {
                -1 => "unknown",
                0 => "free",
                100 => "occupied",
                _ => "",
            };
            writeln!(f, "{name:10} {value:4} {cells:>9} cells")?;
        }
        for file in &self.files {
            writeln!(f, "wrote           {}", file.display())?;
        }
        Ok(())
    }
}
