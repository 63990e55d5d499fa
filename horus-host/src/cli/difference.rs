use std::fs::{self, File};
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use anyhow::{Context, bail};
use horus_host::log::msg::{Costmap, Grid, LaserScan, Message, OccupancyGrid, Path as PathMsg, TFMessage};
use horus_host::log::{DifferingPair, LogError, LogMessage, LogWriter};
use horus_host::picture::Picture;

use super::grid_picture::{GridPicture, is_grid};
use super::survey::in_file;
use super::value_grid::{self, DISTANCE, EVIDENCE};

/// Pictures are enlarged up to this many pixels on the longer side of each.
const SIZE: u32 = 800;
/// Lethal cost in pictures of exact costs.
const LETHAL: u8 = 253;

/// What two logs differ in, as a log and as a picture of the first grid.
pub struct Differences {
    log: Option<DifferenceLog>,
    picture: Option<PathBuf>,
}

/// A log that gets its name when it is whole.
struct DifferenceLog {
    path: PathBuf,
    temporary: PathBuf,
    /// `None` once it is finished.
    writer: Option<LogWriter<BufWriter<File>>>,
}

impl Drop for DifferenceLog {
    fn drop(&mut self) {
        // Not there any more if it has got its name.
        let _ = fs::remove_file(&self.temporary);
    }
}

impl Differences {
    pub fn new(log: Option<&Path>, picture: Option<&Path>, inputs: [&Path; 2]) -> anyhow::Result<Self> {
        for output in [log, picture].into_iter().flatten() {
            let is_same = |input: &Path| {
                input
                    .canonicalize()
                    .is_ok_and(|input| output.canonicalize().is_ok_and(|output| input == output))
            };
            if inputs.into_iter().any(is_same) {
                bail!("{}: a log to compare would be overwritten", output.display());
            }
        }
        let log = log.map(|path| -> anyhow::Result<_> {
            let temporary = part(path)?;
            Ok(DifferenceLog {
                path: path.to_owned(),
                writer: Some(LogWriter::create(&temporary)?),
                temporary,
            })
        });
        Ok(Self {
            log: log.transpose()?,
            picture: picture.map(Path::to_owned),
        })
    }

    /// Takes the next pair that differs.
    pub fn add(&mut self, pair: DifferingPair) -> anyhow::Result<()> {
        if let Some(log) = &mut self.log
            && let Some(writer) = &mut log.writer
        {
            write_pair(writer, pair).map_err(|error| in_file(&log.path, error))?;
        }
        if let (Some(a), Some(b)) = (pair.a, pair.b)
            && let Some(path) = &self.picture
            && is_grid(&a.channel.type_name)
            && is_grid(&b.channel.type_name)
        {
            let temporary = part(path)?;
            let painted = paint(a, b).and_then(|picture| {
                picture.save(&temporary)?;
                Ok(fs::rename(&temporary, path)?)
            });
            if painted.is_err() {
                let _ = fs::remove_file(&temporary); // the first error is the one to tell
            }
            painted.with_context(|| format!("cannot paint {}", path.display()))?;
            self.picture = None;
        }
        Ok(())
    }

    /// Gives the log its name.
    pub fn finish(self) -> anyhow::Result<()> {
        let Some(mut log) = self.log else { return Ok(()) };
        if let Some(writer) = log.writer.take() {
            writer.finish().map_err(|error| in_file(&log.path, error))?;
        }
        fs::rename(&log.temporary, &log.path).with_context(|| format!("cannot write {}", log.path.display()))
    }
}

/// The name of a file while it is written.
fn part(path: &Path) -> anyhow::Result<PathBuf> {
    let name = path
        .file_name()
        .with_context(|| format!("{} is no file name", path.display()))?;
    let mut part = std::ffi::OsString::from(".");
    part.push(name);
    part.push(".part");
    Ok(path.with_file_name(part))
}

fn paint(a: &LogMessage, b: &LogMessage) -> anyhow::Result<Picture> {
    let (a, b) = (GridPicture::of(a, LETHAL)?, GridPicture::of(b, LETHAL)?);
    let scale = (SIZE / a.width.max(a.height).max(1)).clamp(1, 16);
    let mut pictures = vec![a.paint(scale)?, b.paint(scale)?];
    if (a.width, a.height) == (b.width, b.height) {
        pictures.push(a.paint_difference(&b, scale)?);
    }
    Ok(Picture::beside(&pictures)?.with_scale_bar(a.resolution / f64::from(scale))?)
}

fn write_pair(writer: &mut LogWriter<BufWriter<File>>, pair: DifferingPair) -> Result<(), LogError> {
    for (side, message) in [("/a", pair.a), ("/b", pair.b)] {
        if let Some(message) = message {
            copy(writer, &format!("{side}{}", message.topic()), message)?;
        }
    }
    let (Some(a), Some(b)) = (pair.a, pair.b) else {
        return Ok(());
    };
    let topic = format!("/difference{}", a.topic());
    if let (Ok(a_map), Ok(b_map)) = (a.decode::<OccupancyGrid>(), b.decode::<OccupancyGrid>()) {
        let data = differing(&a_map.data, &b_map.data);
        return write_cells(writer, &topic, a.log_time_ns, OccupancyGrid { data, ..a_map });
    }
    if let (Ok(a_map), Ok(b_map)) = (a.decode::<Costmap>(), b.decode::<Costmap>()) {
        let mut map = OccupancyGrid {
            header: a_map.header,
            data: differing(&a_map.data, &b_map.data),
            ..OccupancyGrid::default()
        };
        map.info.resolution = a_map.metadata.resolution;
        (map.info.width, map.info.height) = (a_map.metadata.size_x, a_map.metadata.size_y);
        map.info.origin = a_map.metadata.origin;
        return write_cells(writer, &topic, a.log_time_ns, map);
    }
    if let (Ok(a_grid), Ok(b_grid)) = (a.decode::<Grid>(), b.decode::<Grid>()) {
        let difference =
            subtracted(&a_grid, &b_grid, DISTANCE).or_else(|| subtracted(&a_grid, &b_grid, EVIDENCE));
        if let Some(difference) = difference {
            return writer.write(&topic, a.log_time_ns, &difference);
        }
    }
    Ok(())
}

/// The named values of a grid less those of another, 0 where they are equal, infinite ones too; `None`
/// unless both have them, for as many cells.
fn subtracted<const N: usize>(a: &Grid, b: &Grid, names: [&str; N]) -> Option<Grid> {
    let ((header, a), (other, b)) = (value_grid::values(a, names)?, value_grid::values(b, names)?);
    if (header.width, header.height) != (other.width, other.height) {
        return None;
    }
    let less = |a: f32, b: f32| if a == b { 0.0 } else { a - b };
    let cells = a
        .iter()
        .zip(&b)
        .map(|(a, b)| std::array::from_fn(|i| less(a[i], b[i])));
    Some(value_grid::grid(&header, names, cells))
}

/// 0 where two cells are equal, 100 where they differ; none where the sizes differ.
fn differing<T: PartialEq>(a: &[T], b: &[T]) -> Vec<i8> {
    if a.len() != b.len() {
        return Vec::new();
    }
    a.iter()
        .zip(b)
        .map(|(a, b)| if a == b { 0 } else { 100 })
        .collect()
}

fn write_cells(
    writer: &mut LogWriter<BufWriter<File>>,
    topic: &str,
    stamp_ns: u64,
    map: OccupancyGrid,
) -> Result<(), LogError> {
    if map.data.is_empty() {
        return Ok(());
    }
    writer.write(topic, stamp_ns, &map)
}

/// Writes a message of a type that we know; others cannot be read by `decode` and are left out.
fn copy(writer: &mut LogWriter<BufWriter<File>>, topic: &str, message: &LogMessage) -> Result<(), LogError> {
    fn as_type<M: Message>(
        writer: &mut LogWriter<BufWriter<File>>,
        topic: &str,
        message: &LogMessage,
    ) -> Result<(), LogError> {
        match message.decode::<M>() {
            Ok(decoded) => writer.write(topic, message.log_time_ns, &decoded),
            Err(_) => Ok(()),
        }
    }
    match message.channel.type_name.as_str() {
        OccupancyGrid::TYPE => as_type::<OccupancyGrid>(writer, topic, message),
        Costmap::TYPE => as_type::<Costmap>(writer, topic, message),
        Grid::TYPE => as_type::<Grid>(writer, topic, message),
        LaserScan::TYPE => as_type::<LaserScan>(writer, topic, message),
        TFMessage::TYPE => as_type::<TFMessage>(writer, topic, message),
        PathMsg::TYPE => as_type::<PathMsg>(writer, topic, message),
        _ => Ok(()),
    }
}
