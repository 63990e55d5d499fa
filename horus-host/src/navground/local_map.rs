use horus_core::local::{Property, PropertyKind, PropertyValue};
use horus_core::prelude::{Footprint, LocalGridMapConfig};
use saphyr::{LoadableYamlNode, MarkedYaml, Scalar, YamlData};

use super::ConfigError;

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
    /// What is wrong, with the key and the line: not YAML, no or another `type`, an unknown key, a value of the
    /// wrong type or out of range.
    pub fn parse(text: &str) -> Result<Self, ConfigError> {
        if text.len() > Self::MOST_BYTES {
            return Err(ConfigError::TooLarge(text.len()));
        }
        let documents = MarkedYaml::load_from_str(text).map_err(|error| ConfigError::Syntax {
            line: error.marker().line(),
            reason: error.info().to_owned(),
        })?;
        let document = match &documents[..] {
            [document] => document,
            [] => return Err(ConfigError::NoMapping(1)),
            [_, second, ..] => return Err(ConfigError::NoMapping(second.span.start.line())),
        };
        let YamlData::Mapping(mapping) = &document.data else {
            return Err(ConfigError::NoMapping(document.span.start.line()));
        };
        // The lists that the configuration borrows must outlive it.
        let entries: Vec<_> = mapping.iter().map(Entry::new).collect();
        let mut config = LocalGridMapConfig::default();
        let mut has_type = false;
        for entry in &entries {
            if entry.key == "type" {
                entry.check_type()?;
                has_type = true;
            } else {
                entry.apply(&mut config)?;
            }
        }
        if !has_type {
            return Err(ConfigError::NoType);
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

/// A key and its value.
struct Entry<'y> {
    key: &'y str,
    /// From 1.
    line: usize,
    value: &'y MarkedYaml<'y>,
    /// The value's elements, if it is a list of texts.
    list: Option<Vec<&'y str>>,
}

impl<'y> Entry<'y> {
    fn new((key, value): (&'y MarkedYaml<'y>, &'y MarkedYaml<'y>)) -> Self {
        let list = match &value.data {
            YamlData::Sequence(elements) => elements.iter().map(text).collect(),
            _ => None,
        };
        Self {
            key: text(key).unwrap_or("?"),
            line: key.span.start.line(),
            value,
            list,
        }
    }

    fn check_type(&self) -> Result<(), ConfigError> {
        match text(self.value) {
            Some("LocalGridMap") => Ok(()),
            other => Err(self.refused(format!(
                "a local map has the type LocalGridMap, not {}",
                other.unwrap_or("this")
            ))),
        }
    }

    /// Sets the property and checks what the configuration is then.
    fn apply<'c>(&'c self, config: &mut LocalGridMapConfig<'c>) -> Result<(), ConfigError> {
        let properties = LocalGridMapConfig::properties();
        let Some(property) = properties.iter().find(|property| property.name == self.key) else {
            let names: Vec<_> = properties.iter().map(|property| property.name).collect();
            return Err(ConfigError::UnknownKey {
                line: self.line,
                key: self.key.to_owned(),
                known: names.join(", "),
            });
        };
        let value = self.value_for(property).ok_or_else(|| ConfigError::Type {
            line: self.line,
            key: self.key.to_owned(),
            expected: property.kind.as_str(),
        })?;
        let set = config.set(self.key, value).and_then(|()| config.validate());
        set.map_err(|error| self.refused(error.to_string()))
    }

    fn value_for(&self, property: &Property) -> Option<PropertyValue<'_>> {
        if property.kind == PropertyKind::StrList {
            return Some(PropertyValue::StrList(self.list.as_deref()?));
        }
        let YamlData::Value(scalar) = &self.value.data else {
            return None;
        };
        Some(match (property.kind, scalar) {
            (PropertyKind::Int, Scalar::Integer(value)) => PropertyValue::Int(*value),
            (PropertyKind::Float, Scalar::Integer(value)) => PropertyValue::Int(*value),
            (PropertyKind::Float, Scalar::FloatingPoint(value)) => PropertyValue::Float(value.0 as f32),
            (PropertyKind::Bool, Scalar::Boolean(value)) => PropertyValue::Bool(*value),
            (PropertyKind::Str, Scalar::String(value)) => PropertyValue::Str(value),
            // A name left empty.
            (PropertyKind::Str, Scalar::Null) => PropertyValue::Str(""),
            _ => return None,
        })
    }

    fn refused(&self, reason: String) -> ConfigError {
        ConfigError::Value {
            line: self.line,
            key: self.key.to_owned(),
            reason,
        }
    }
}

/// A text.
fn text<'y>(node: &'y MarkedYaml<'y>) -> Option<&'y str> {
    match &node.data {
        YamlData::Value(Scalar::String(text)) => Some(text),
        _ => None,
    }
}
