use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use anyhow::{Context, bail};
use horus_core::distance::{DistanceMap, MAX_SIDE};
use horus_core::prelude::Pose2D;
use horus_host::lockstep::{CoreStorage, FixedMap, LockstepConfig};
use horus_host::log::msg::Header;
use horus_host::log::{LogError, LogWriter};
use horus_host::map_server::MapFile;
use horus_host::picture::{indexed_png, palette};
use horus_host::topic::{GridHeader, frame_bytes};
use indicatif::ProgressBar;

use super::distances::Distances;
use crate::cli::map_geometry::MapGeometry;
use crate::cli::map_log::MAP_FRAME;
use crate::cli::out_dir::OutDir;
use crate::cli::summary::metadata;
use crate::cli::survey::in_file;
use crate::cli::value_grid::{self, DISTANCE};

/// What `map` writes.
pub const FILES: [&str; 4] = ["occupancy.png", "costmap.png", "distance.png", "map.mcap"];

/// A map stands still: its log has one point in time.
const STAMP_NS: u64 = 0;

/// Computes the costs of a map and writes pictures and log.
pub fn write(
    out: &OutDir,
    config: &LockstepConfig,
    origin: Pose2D,
    map: MapFile,
    distances: Distances,
    bar: &ProgressBar,
) -> anyhow::Result<Vec<PathBuf>> {
    let (width, height) = (config.width, config.height);
    if width.max(height) > MAX_SIDE {
        bail!("{width} x {height} cells: distances are computed of at most {MAX_SIDE} on a side");
    }
    bar.set_message("computing costs");
    let mut storage = CoreStorage::new(config, 0)?;
    let fixed = FixedMap::new(config, origin, &map.cells, &mut storage)?;
    drop(map); // one byte per cell: the cost map has its own
    let layers = Layers {
        map: &fixed,
        geometry: MapGeometry::with_origin(config, origin),
        size: (config.width, config.height),
        bar,
    };
    let [occupancy, costs, picture, log] = FILES;
    let lethal = config.params.lethal_cost;
    let mut files = vec![
        out.replace(occupancy, |path| layers.paint_occupancy(path))?,
        out.replace(costs, |path| layers.paint_costs(path, lethal))?,
    ];
    layers.start("computing distances");
    let written = distances.compute(config, origin, &fixed, bar, |distances| {
        files.push(out.replace(picture, |path| layers.paint_distances(path, distances))?);
        files.push(out.replace(log, |path| {
            bar.set_message("writing the log");
            let mut metadata = metadata(config, MAP_FRAME, "core");
            metadata.remove("model"); // no scans
            layers
                .log(path, metadata, distances)
                .map_err(|error| in_file(path, error))
        })?);
        anyhow::Ok(())
    });
    written??;
    Ok(files)
}

struct Layers<'a> {
    map: &'a FixedMap<'a>,
    geometry: MapGeometry,
    size: (u32, u32),
    bar: &'a ProgressBar,
}

impl Layers<'_> {
    fn paint_occupancy(&self, path: &Path) -> anyhow::Result<()> {
        self.start("painting occupancy");
        let width = self.size.0 as usize;
        let cells = self.map.occupancy();
        let colour = |value: u8| palette::occupancy(value as i8);
        indexed_png(path, self.size, colour, |gy, row| {
            let start = gy as usize * width;
            for (value, cell) in row.iter_mut().zip(cells.iter().skip(start)) {
                *value = *cell as u8;
            }
            self.bar.inc(1);
        })
        .context("the picture of the occupancy")
    }

    fn paint_costs(&self, path: &Path, lethal: u8) -> anyhow::Result<()> {
        self.start("painting costs");
        let colour = |cost| palette::cost(cost, lethal);
        indexed_png(path, self.size, colour, |gy, row| {
            self.map.read_row(gy, row);
            self.bar.inc(1);
        })
        .context("the picture of the costs")
    }

    fn paint_distances(&self, path: &Path, distances: &DistanceMap<'_, u32>) -> anyhow::Result<()> {
        self.start("painting distances");
        let farthest = distances.metres().fold(0.0f32, f32::max);
        let per_level = farthest.max(f32::MIN_POSITIVE) / 255.0;
        let colour = |level: u8| palette::distance(f32::from(level) * per_level, farthest);
        let width = self.size.0;
        indexed_png(path, self.size, colour, |gy, row| {
            for (gx, level) in (0..width).zip(row) {
                let metres = distances.metres_at(gx, gy).unwrap_or(0.0);
                *level = (metres / per_level).round() as u8;
            }
            self.bar.inc(1);
        })
        .context("the picture of the distances")
    }

    fn log(
        &self,
        path: &Path,
        metadata: BTreeMap<String, String>,
        distances: &DistanceMap<'_, u32>,
    ) -> Result<(), LogError> {
        let mut log = LogWriter::create(path)?;
        // One message at a time in memory.
        log.set_flush_interval(1);
        log.metadata("horus", metadata)?;
        let placed = self.geometry.at([0, 0]);
        let header = Header::new(STAMP_NS, MAP_FRAME);
        let map = placed.occupancy_grid(header.clone(), self.map.occupancy().to_vec());
        log.write("/map", STAMP_NS, &map)?;
        drop(map);
        let mut costs = vec![0; self.map.occupancy().len()];
        for (gy, row) in (0..).zip(costs.chunks_exact_mut(self.size.0 as usize)) {
            self.map.read_row(gy, row);
        }
        let viewable = placed.viewable(header.clone(), &costs);
        log.write("/costmap", STAMP_NS, &viewable)?;
        drop(viewable);
        log.write("/costmap_raw", STAMP_NS, &placed.costmap(header, costs))?;
        let header = GridHeader {
            timestamp_ns: STAMP_NS,
            origin: [
                self.geometry.origin.x,
                self.geometry.origin.y,
                self.geometry.origin.theta,
            ]
            .map(f64::from),
            resolution: self.geometry.resolution,
            width: self.size.0,
            height: self.size.1,
            frame_id: frame_bytes(MAP_FRAME),
            ..GridHeader::default()
        };
        let cells = distances.metres().map(|metres| [metres]);
        log.write("/distance", STAMP_NS, &value_grid::grid(&header, DISTANCE, cells))?;
        log.finish().map(drop)
    }

    fn start(&self, what: &'static str) {
        self.bar.set_position(0);
        self.bar.set_message(what);
    }
}
