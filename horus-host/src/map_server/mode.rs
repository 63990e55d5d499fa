use std::fmt;

use clap::ValueEnum;

/// How shades of an image become occupancy values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum MapMode {
    /// Free, occupied or unknown.
    #[default]
    Trinary,
    /// Between the thresholds 0 to 100 by the shade; transparent pixels are unknown.
    Scale,
    /// The shade is the value: 0 to 100, others unknown.
    Raw,
}

impl MapMode {
    /// The mode of this name, whatever the case of its letters.
    pub fn from_name(name: &str) -> Option<Self> {
        [Self::Trinary, Self::Scale, Self::Raw]
            .into_iter()
            .find(|mode| name.eq_ignore_ascii_case(&mode.to_string()))
    }
}

impl fmt::Display for MapMode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Trinary => "trinary",
            Self::Scale => "scale",
            Self::Raw => "raw",
        })
    }
}
