use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use horus_host::lockstep::LockstepConfig;
use horus_host::lockstep::evidence::{EvidenceConfig, EvidenceLayers};
use horus_host::log::msg::{Grid, NumericType, PackedElementField, Pose, Time, Vector2};

use crate::cli::map_geometry::MapGeometry;
use crate::cli::map_log::{Frames, MapLog};
use crate::cli::step::ScanStep;
use crate::cli::value_grid::{self, EVIDENCE_BYTES};

/// The log of one side: scans, transforms, and the evidence and distances after them.
pub struct EvidenceLog {
    log: MapLog,
    map: MapGeometry,
    frame: String,
}

impl EvidenceLog {
    /// Starts the log at `path` with a `horus` metadata record.
    pub fn create(
        path: &Path,
        config: &EvidenceConfig,
        frames: &Frames,
        metadata: BTreeMap<String, String>,
    ) -> anyhow::Result<Self> {
        let map = MapGeometry::from(&LockstepConfig {
            width: config.width,
            height: config.height,
            resolution: config.resolution,
            ..LockstepConfig::default()
        });
        Ok(Self {
            log: MapLog::create(path, map, frames, metadata)?,
            map,
            frame: frames.odom.clone(),
        })
    }

    /// Writes a scan and the transforms that connect it, and with `layers` the maps after it.
    pub fn write(&mut self, step: &ScanStep, layers: Option<&EvidenceLayers>) -> anyhow::Result<()> {
        let stamp_ns = step.stamp_ns;
        let grids = layers.map(|layers| [self.evidence(stamp_ns, layers), self.distance(stamp_ns, layers)]);
        self.log.write_with(step, |writer| {
            let Some([evidence, distance]) = grids else {
                return Ok(());
            };
            writer.write("/evidence", stamp_ns, &evidence)?;
            writer.write("/distance", stamp_ns, &distance)
        })
    }

    /// Writes index and footer.
    pub fn finish(self) -> anyhow::Result<PathBuf> {
        self.log.finish()
    }

    fn evidence(&self, stamp_ns: u64, layers: &EvidenceLayers) -> Grid {
        let data = value_grid::evidence_bytes(layers.masses.iter().copied());
        self.grid(
            stamp_ns,
            layers,
            value_grid::evidence_fields(),
            EVIDENCE_BYTES,
            data,
        )
    }

    fn distance(&self, stamp_ns: u64, layers: &EvidenceLayers) -> Grid {
        let field = PackedElementField::new("distance", 0, NumericType::Float32);
        let data = layers.distance.iter().flat_map(|metres| metres.to_le_bytes());
        self.grid(stamp_ns, layers, vec![field], 4, data.collect())
    }

    fn grid(
        &self,
        stamp_ns: u64,
        layers: &EvidenceLayers,
        fields: Vec<PackedElementField>,
        cell_stride: u32,
        data: Vec<u8>,
    ) -> Grid {
        let corner = self.map.corner(layers.offset);
        let side = f64::from(self.map.resolution);
        Grid {
            timestamp: Time::from_ns(stamp_ns),
            frame_id: self.frame.clone(),
            pose: Pose::planar(corner.x, corner.y, corner.yaw),
            column_count: self.map.width,
            cell_size: Vector2 { x: side, y: side },
            row_stride: cell_stride * self.map.width,
            cell_stride,
            fields,
            data,
        }
    }
}
