use std::fmt::Write;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::{MapFileError, MapMode};
use crate::yaml;

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

/// The file as it is written; keys that are not named are ignored.
#[derive(Deserialize)]
struct Keys {
    image: String,
    resolution: f64,
    origin: Vec<f64>,
    free_thresh: f64,
    occupied_thresh: f64,
    negate: Switch,
    mode: Option<String>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Switch {
    Bool(bool),
    Number(i64),
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

    /// Reads the text of the file `path`, which is named in errors.
    ///
    /// # Errors
    /// [`MapFileError::Yaml`] for what is no YAML, for missing keys and wrong types;
    /// [`MapFileError::Value`] for a resolution that is not above zero, numbers that are not finite,
    /// an unknown mode, an origin that is not three numbers, `negate` other than 0, 1, true, false.
    pub fn parse(path: &Path, text: &str) -> Result<Self, MapFileError> {
        let keys: Keys = yaml::from_str(text).map_err(|source| MapFileError::Yaml {
            path: path.to_owned(),
            source,
        })?;
        let refuse = |key, wanted, value: &dyn ToString| MapFileError::Value {
            path: path.to_owned(),
            key,
            wanted,
            value: value.to_string(),
        };
        let finite = |key, value: f64| match value.is_finite() {
            true => Ok(value),
            false => Err(refuse(key, "finite", &value)),
        };
        let resolution = keys.resolution;
        // The maps compute in f32: what is zero or infinite there is no length.
        if !(resolution as f32 > 0.0 && (resolution as f32).is_finite()) {
            return Err(refuse("resolution", "a length above zero", &resolution));
        }
        let origin: [f64; 3] = keys
            .origin
            .try_into()
            .map_err(|values: Vec<f64>| refuse("origin", "three numbers", &format!("{values:?}")))?;
        for value in origin {
            finite("origin", value)?;
        }
        let mode = match keys.mode {
            None => MapMode::default(),
            Some(name) => {
                MapMode::from_name(&name).ok_or_else(|| refuse("mode", "trinary, scale or raw", &name))?
            }
        };
        if keys.image.is_empty() {
            return Err(refuse("image", "a file", &"empty"));
        }
        Ok(Self {
            image: keys.image.into(),
            resolution,
            origin,
            free_thresh: finite("free_thresh", keys.free_thresh)? as f32,
            occupied_thresh: finite("occupied_thresh", keys.occupied_thresh)? as f32,
            negate: match keys.negate {
                Switch::Bool(negate) => negate,
                Switch::Number(0) => false,
                Switch::Number(1) => true,
                Switch::Number(other) => return Err(refuse("negate", "0 or 1", &other)),
            },
            mode,
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
