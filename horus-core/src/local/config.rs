use super::state::check_name;
use super::{Footprint, Lidar, Odometry, Property, PropertyKind, PropertyValue};
use crate::error::{Error, Parameter};
use crate::geometry::{GridInfo, Pose2D};

/// What a [`LocalGridMap`](super::LocalGridMap) is made from: navground's properties with its
/// defaults, and the sensors that belong to the map. Names and lists are borrowed.
///
/// # Examples
/// ```
/// use horus_core::local::PropertyValue;
/// use horus_core::prelude::*;
///
/// let mut config = LocalGridMapConfig {
///     external_lidars: &["front", "rear"],
///     ..LocalGridMapConfig::default()
/// };
/// config.set("width", PropertyValue::Int(200))?;
/// assert_eq!(config.set("width", PropertyValue::Int(-1)), Err(Error::PropertyType));
/// assert_eq!(config.width, 200);
/// for property in LocalGridMapConfig::properties() {
///     assert!(config.get(property.name).is_some());
/// }
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalGridMapConfig<'a> {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Metres per cell.
    pub resolution: f32,
    /// Whether the map's outputs include the transformation from its frame to the world.
    pub include_transformation: bool,
    /// Lidars that others own, by name.
    pub external_lidars: &'a [&'a str],
    /// The odometry sensor that others own, by name; empty: none.
    pub external_odometry: &'a str,
    /// What is freed around the robot.
    pub footprint: Footprint,
    /// Radius of the footprint in metres.
    pub radius: f32,
    /// Prefix of the map's outputs.
    pub name: &'a str,
    /// Lidars that belong to the map; drawn after the external ones.
    pub lidars: &'a [Lidar<'a>],
    /// The odometry sensor that belongs to the map; it goes before the external one.
    pub odometry: Option<Odometry<'a>>,
}

impl Default for LocalGridMapConfig<'_> {
    fn default() -> Self {
        Self::new()
    }
}

impl<'a> LocalGridMapConfig<'a> {
    /// navground's defaults: 10 x 10 cells of 0.1 m, no sensors.
    pub const fn new() -> Self {
        Self {
            width: 10,
            height: 10,
            resolution: 0.1,
            include_transformation: false,
            external_lidars: &[],
            external_odometry: "",
            footprint: Footprint::Rectangular,
            radius: 0.0,
            name: "",
            lidars: &[],
            odometry: None,
        }
    }

    /// All properties, in alphabetical order.
    pub const fn properties() -> &'static [Property] {
        &PROPERTIES
    }

    /// The value of a property; `None` if there is none of this name.
    pub fn get(&self, name: &str) -> Option<PropertyValue<'a>> {
        Some(match name {
            "external_lidars" => PropertyValue::StrList(self.external_lidars),
            "external_odometry" => PropertyValue::Str(self.external_odometry),
            "footprint" => PropertyValue::Str(self.footprint.as_str()),
            "height" => PropertyValue::Int(self.height.into()),
            "include_transformation" => PropertyValue::Bool(self.include_transformation),
            "name" => PropertyValue::Str(self.name),
            "radius" => PropertyValue::Float(self.radius),
            "resolution" => PropertyValue::Float(self.resolution),
            "width" => PropertyValue::Int(self.width.into()),
            _ => return None,
        })
    }

    /// Sets a property; a whole number serves as a number too. The whole is checked by
    /// [`validate`](Self::validate) only.
    ///
    /// # Errors
    /// [`Error::UnknownProperty`], [`Error::PropertyType`], [`Error::UnknownFootprint`]; nothing
    /// changes then.
    pub fn set(&mut self, name: &str, value: PropertyValue<'a>) -> Result<(), Error> {
        use PropertyValue::{Bool, Float, Int, Str, StrList};
        match (name, value) {
            ("external_lidars", StrList(names)) => self.external_lidars = names,
            ("external_odometry", Str(name)) => self.external_odometry = name,
            ("footprint", Str(name)) => self.footprint = name.parse()?,
            ("height", Int(cells)) => self.height = count(cells)?,
            ("include_transformation", Bool(include)) => self.include_transformation = include,
            ("name", Str(name)) => self.name = name,
            ("radius", Float(metres)) => self.radius = metres,
            ("radius", Int(metres)) => self.radius = metres as f32,
            ("resolution", Float(metres)) => self.resolution = metres,
            ("resolution", Int(metres)) => self.resolution = metres as f32,
            ("width", Int(cells)) => self.width = count(cells)?,
            _ if self.get(name).is_some() => return Err(Error::PropertyType),
            _ => return Err(Error::UnknownProperty),
        }
        Ok(())
    }

    /// Checks everything: numbers, names, sensors.
    ///
    /// # Errors
    /// [`Error::InvalidResolution`], [`Error::SizeOverflow`], [`Error::NameTooLong`],
    /// [`Error::DuplicateName`] if two lidars, whoever owns them, have the same name;
    /// [`Error::InvalidParameter`] and [`Error::NonFinitePose`] for the footprint's radius and a
    /// lidar's numbers.
    pub fn validate(&self) -> Result<(), Error> {
        self.info()?;
        if !(self.radius.is_finite() && self.radius >= 0.0) {
            return Err(Error::InvalidParameter(Parameter::FootprintRadius));
        }
        let odometry = self.odometry.map_or("", |odometry| odometry.name);
        for name in [self.name, self.external_odometry, odometry] {
            check_name(name)?;
        }
        for lidar in self.lidars {
            lidar.validate()?;
        }
        for (i, name) in self.lidar_names().enumerate() {
            check_name(name)?;
            if self.lidar_names().take(i).any(|earlier| earlier == name) {
                return Err(Error::DuplicateName);
            }
        }
        Ok(())
    }

    /// The names of all lidars in the order in which they are drawn.
    pub fn lidar_names(&self) -> impl Iterator<Item = &'a str> + use<'a> {
        let own = self.lidars.iter().map(|lidar| lidar.name);
        self.external_lidars.iter().copied().chain(own)
    }

    /// The map before it first moves: its corner lies at the frame's origin.
    pub(super) fn info(&self) -> Result<GridInfo, Error> {
        GridInfo::new(self.width, self.height, self.resolution, Pose2D::default())
    }
}

/// Cells, from a property's value.
fn count(cells: i64) -> Result<u32, Error> {
    u32::try_from(cells).or(Err(Error::PropertyType))
}

const DEFAULT: LocalGridMapConfig<'static> = LocalGridMapConfig::new();

static PROPERTIES: [Property; 9] = [
    Property {
        name: "external_lidars",
        kind: PropertyKind::StrList,
        default: PropertyValue::StrList(DEFAULT.external_lidars),
        unit: "",
        description: "Names of external lidar sensors",
    },
    Property {
        name: "external_odometry",
        kind: PropertyKind::Str,
        default: PropertyValue::Str(DEFAULT.external_odometry),
        unit: "",
        description: "Name of the external odometry sensor; empty: none",
    },
    Property {
        name: "footprint",
        kind: PropertyKind::Str,
        default: PropertyValue::Str(DEFAULT.footprint.as_str()),
        unit: "",
        description: "Footprint type: rectangular, circular or none",
    },
    Property {
        name: "height",
        kind: PropertyKind::Int,
        default: PropertyValue::Int(DEFAULT.height as i64),
        unit: "cells",
        description: "Height of the map",
    },
    Property {
        name: "include_transformation",
        kind: PropertyKind::Bool,
        default: PropertyValue::Bool(DEFAULT.include_transformation),
        unit: "",
        description: "Whether to include the transformation between map and world frame",
    },
    Property {
        name: "name",
        kind: PropertyKind::Str,
        default: PropertyValue::Str(DEFAULT.name),
        unit: "",
        description: "Prefix of the map's outputs",
    },
    Property {
        name: "radius",
        kind: PropertyKind::Float,
        default: PropertyValue::Float(DEFAULT.radius),
        unit: "m",
        description: "Radius of the footprint",
    },
    Property {
        name: "resolution",
        kind: PropertyKind::Float,
        default: PropertyValue::Float(DEFAULT.resolution),
        unit: "m/cell",
        description: "Size of a cell",
    },
    Property {
        name: "width",
        kind: PropertyKind::Int,
        default: PropertyValue::Int(DEFAULT.width as i64),
        unit: "cells",
        description: "Width of the map",
    },
];
