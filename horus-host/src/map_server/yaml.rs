use std::fmt::Write;
use std::path::{Path, PathBuf};

use super::{MapFileError, MapMode};
use crate::yaml::{self, Document, Entry, YamlError};

/// The keys of a `map.yaml`.
#[derive(Debug, Clone, PartialEq)]
pub struct MapYaml {
    /// The image, relative to the file.
    pub image: PathBuf,
    /// Metres per cell.
    pub resolution: f64,
    /// x, y in metres and yaw in radians of the corner of the lowest left cell.
    pub origin: [f64; 3],
    /// Occupancies 0 to 1 up to this one are free.
    pub free_thresh: f32,
    /// Occupancies 0 to 1 from this one on are occupied.
    pub occupied_thresh: f32,
    /// Light pixels are occupied, instead of dark ones.
    pub negate: bool,
    /// How shades become values.
    pub mode: MapMode,
}

impl MapYaml {
    /// For a map to be saved: the thresholds that read its cells back (0.196 and 0.65; 0 and 1 in
    /// `Scale` mode); the image is named when it is saved.
    pub fn new(resolution: f64, origin: [f64; 3], mode: MapMode) -> Self {
        let (free_thresh, occupied_thresh) = match mode {
            MapMode::Scale => (0.0, 1.0),
            MapMode::Trinary | MapMode::Raw => (0.196, 0.65),
        };
        Self {
            image: PathBuf::new(),
            resolution,
            origin,
            free_thresh,
            occupied_thresh,
            negate: false,
            mode,
        }
    }

    /// Reads the text of the file `path`, which is named in errors. Keys that are not named above are ignored.
    ///
    /// # Errors
    /// [`MapFileError::Yaml`] for what is no YAML, for missing keys, keys given twice and wrong types; for a
    /// resolution that is not above zero, numbers that are not finite, an unknown mode, an origin that is not
    /// three numbers, `negate` other than 0, 1, true, false.
    pub fn parse(path: &Path, text: &str) -> Result<Self, MapFileError> {
        Document::parse(text)
            .and_then(|document| Self::read(&document))
            .map_err(|source| MapFileError::Yaml {
                path: path.to_owned(),
                source,
            })
    }

    fn read(document: &Document<'_>) -> Result<Self, YamlError> {
        Ok(Self {
            image: image(document.required("image")?)?,
            resolution: resolution(document.required("resolution")?)?,
            origin: origin(document.required("origin")?)?,
            free_thresh: threshold(document.required("free_thresh")?)?,
            occupied_thresh: threshold(document.required("occupied_thresh")?)?,
            negate: negate(document.required("negate")?)?,
            mode: match document.get("mode").filter(|entry| !entry.is_null()) {
                Some(entry) => mode(entry)?,
                None => MapMode::default(),
            },
        })
    }

    /// The text of the file.
    pub fn to_text(&self) -> String {
        let [x, y, yaw] = self.origin;
        let mut text = String::new();
        let mut key = |name: &str, value: &dyn std::fmt::Display| {
            let _ = writeln!(text, "{name}: {value}");
        };
        key("image", &yaml::quoted(&self.image.to_string_lossy()));
        key("mode", &self.mode);
        key("resolution", &self.resolution);
        key("origin", &format!("[{x}, {y}, {yaw}]"));
        key("negate", &u8::from(self.negate));
        key("occupied_thresh", &self.occupied_thresh);
        key("free_thresh", &self.free_thresh);
        text
    }
}

fn image(entry: &Entry<'_>) -> Result<PathBuf, YamlError> {
    match entry.text()? {
        "" => Err(entry.refused("a file is expected")),
        name => Ok(name.into()),
    }
}

fn resolution(entry: &Entry<'_>) -> Result<f64, YamlError> {
    let metres = entry.number()?;
    // The maps compute in f32: what is zero or infinite there is no length.
    if metres as f32 > 0.0 && (metres as f32).is_finite() {
        Ok(metres)
    } else {
        Err(entry.refused(format!("a length above zero is expected, not {metres}")))
    }
}

fn origin(entry: &Entry<'_>) -> Result<[f64; 3], YamlError> {
    let values = entry.numbers()?;
    for &value in &values {
        finite(entry, value)?;
    }
    values.try_into().map_err(|values: Vec<f64>| {
        entry.refused(format!("three numbers are expected, not {}", values.len()))
    })
}

fn threshold(entry: &Entry<'_>) -> Result<f32, YamlError> {
    Ok(finite(entry, entry.number()?)? as f32)
}

fn negate(entry: &Entry<'_>) -> Result<bool, YamlError> {
    match (entry.boolean(), entry.integer()) {
        (Ok(negate), _) => Ok(negate),
        (_, Ok(number @ 0..=1)) => Ok(number == 1),
        _ => Err(entry.refused("0, 1, true or false is expected")),
    }
}

fn mode(entry: &Entry<'_>) -> Result<MapMode, YamlError> {
    let name = entry.text()?;
    MapMode::from_name(name).ok_or_else(|| entry.refused("trinary, scale or raw is expected"))
}

fn finite(entry: &Entry<'_>, value: f64) -> Result<f64, YamlError> {
    match value.is_finite() {
        true => Ok(value),
        false => Err(entry.refused("a finite number is expected")),
    }
}
