/// A property of a configuration, for tools that list and set them by name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Property {
    /// Its name, navground's.
    pub name: &'static str,
    /// What its value is.
    pub kind: PropertyKind,
    /// Its value where none is given.
    pub default: PropertyValue<'static>,
    /// Unit of its value; empty if it has none.
    pub unit: &'static str,
    /// What it is for, in words.
    pub description: &'static str,
}

/// The type of a property.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PropertyKind {
    /// A whole number.
    Int,
    /// A number.
    Float,
    /// True or false.
    Bool,
    /// A text.
    Str,
    /// A list of texts.
    StrList,
}

impl PropertyKind {
    /// navground's name of the type.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Int => "int",
            Self::Float => "float",
            Self::Bool => "bool",
            Self::Str => "str",
            Self::StrList => "[str]",
        }
    }
}

/// The value of a property.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PropertyValue<'a> {
    /// A whole number.
    Int(i64),
    /// A number.
    Float(f32),
    /// True or false.
    Bool(bool),
    /// A text.
    Str(&'a str),
    /// A list of texts.
    StrList(&'a [&'a str]),
}

impl PropertyValue<'_> {
    /// Its type.
    pub const fn kind(&self) -> PropertyKind {
        match self {
            Self::Int(_) => PropertyKind::Int,
            Self::Float(_) => PropertyKind::Float,
            Self::Bool(_) => PropertyKind::Bool,
            Self::Str(_) => PropertyKind::Str,
            Self::StrList(_) => PropertyKind::StrList,
        }
    }
}
