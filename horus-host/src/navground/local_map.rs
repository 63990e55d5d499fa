use horus_core::local::{PropertyKind, PropertyValue};
use horus_core::prelude::{Footprint, LocalGridMapConfig};

use super::ConfigError;
use crate::yaml::{Document, Entry, YamlError};

/// The properties of a local map, read from YAML: `type: LocalGridMap` and any of navground's properties, and
/// `radius`, the footprint's, which navground takes from the agent. What is not given has navground's default.
#[derive(Debug, Clone, PartialEq)]
pub struct LocalMapFile {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Metres per cell.
    pub resolution: f32,
    /// Whether the outputs include the transformation from the map's frame to the world.
    pub include_transformation: bool,
    /// Names of the lidars.
    pub external_lidars: Vec<String>,
    /// Name of the odometry sensor; empty: none.
    pub external_odometry: String,
    /// What is freed around the robot.
    pub footprint: Footprint,
    /// Radius of the footprint in metres.
    pub radius: f32,
    /// Prefix of the outputs.
    pub name: String,
}

impl LocalMapFile {
    /// The most bytes of a configuration.
    pub const MOST_BYTES: usize = 1 << 16;

    /// Reads a configuration.
    ///
    /// # Errors
    /// What is wrong, with the key and the line: not YAML, no or another `type`, an unknown key, a key given
    /// twice, a value of the wrong type or out of range.
    pub fn parse(text: &str) -> Result<Self, ConfigError> {
        if text.len() > Self::MOST_BYTES {
            return Err(ConfigError::TooLarge(text.len()));
        }
        let document = Document::parse(text)?;
        check_type(document.get("type").ok_or(ConfigError::NoType)?)?;
        let properties = document.entries().iter().filter(|entry| entry.key() != "type");
        // The lists that the configuration borrows must outlive it.
        let properties: Vec<_> = properties.map(Given::new).collect::<Result<_, _>>()?;
        let mut config = LocalGridMapConfig::default();
        for given in &properties {
            given.apply(&mut config)?;
        }
        Ok(Self {
            width: config.width,
            height: config.height,
            resolution: config.resolution,
            include_transformation: config.include_transformation,
            external_lidars: config
                .external_lidars
                .iter()
                .map(|&name| name.to_owned())
                .collect(),
            external_odometry: config.external_odometry.to_owned(),
            footprint: config.footprint,
            radius: config.radius,
            name: config.name.to_owned(),
        })
    }
}

fn check_type(entry: &Entry<'_>) -> Result<(), YamlError> {
    match entry.text()? {
        "LocalGridMap" => Ok(()),
        other => Err(entry.refused(format!("a local map has the type LocalGridMap, not {other}"))),
    }
}

/// A property that is given, and its value.
struct Given<'y> {
    entry: &'y Entry<'y>,
    kind: PropertyKind,
    /// The value, if it is a list.
    list: Vec<&'y str>,
}

impl<'y> Given<'y> {
    fn new(entry: &'y Entry<'y>) -> Result<Self, ConfigError> {
        let properties = LocalGridMapConfig::properties();
        let Some(property) = properties.iter().find(|property| property.name == entry.key()) else {
            let names: Vec<_> = properties.iter().map(|property| property.name).collect();
            return Err(ConfigError::UnknownKey {
                line: entry.line(),
                key: entry.key().to_owned(),
                known: names.join(", "),
            });
        };
        let kind = property.kind;
        let list = match kind {
            PropertyKind::StrList => entry.texts()?,
            _ => Vec::new(),
        };
        Ok(Self { entry, kind, list })
    }

    /// Sets the property and checks what the configuration is then.
    fn apply<'c>(&'c self, config: &mut LocalGridMapConfig<'c>) -> Result<(), YamlError> {
        let value = self.value()?;
        let set = config
            .set(self.entry.key(), value)
            .and_then(|()| config.validate());
        set.map_err(|error| self.entry.refused(error))
    }

    fn value(&self) -> Result<PropertyValue<'_>, YamlError> {
        let entry = self.entry;
        Ok(match self.kind {
            PropertyKind::Int => PropertyValue::Int(entry.integer()?),
            PropertyKind::Float => match entry.integer() {
                Ok(value) => PropertyValue::Int(value),
                Err(_) => PropertyValue::Float(entry.number()? as f32),
            },
            PropertyKind::Bool => PropertyValue::Bool(entry.boolean()?),
            // A name left empty.
            PropertyKind::Str if entry.is_null() => PropertyValue::Str(""),
            PropertyKind::Str => PropertyValue::Str(entry.text()?),
            PropertyKind::StrList => PropertyValue::StrList(&self.list),
        })
    }
}
