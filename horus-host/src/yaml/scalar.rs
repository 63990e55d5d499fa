use std::borrow::Cow;

use saphyr_parser::{ScalarStyle, Tag};

/// A single value as it is written.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Scalar<'y> {
    text: Cow<'y, str>,
    /// Quoted, or tagged as a text: never a number, a truth value or nothing.
    is_text: bool,
}

impl<'y> Scalar<'y> {
    pub fn new(text: Cow<'y, str>, style: ScalarStyle, tag: Option<&Tag>) -> Self {
        let is_text = style != ScalarStyle::Plain
            || tag.is_some_and(|tag| tag.is_yaml_core_schema() && tag.suffix == "str");
        Self { text, is_text }
    }

    pub fn as_written(&self) -> &str {
        &self.text
    }

    /// `None` for what is a number, a truth value or nothing.
    pub fn text(&self) -> Option<&str> {
        let is_other = self.is_null() || self.boolean().is_some() || self.number().is_some();
        (!is_other).then_some(&self.text)
    }

    pub fn is_null(&self) -> bool {
        !self.is_text && ["", "~", "null", "Null", "NULL"].contains(&&*self.text)
    }

    pub fn boolean(&self) -> Option<bool> {
        match &*self.text {
            _ if self.is_text => None,
            "true" | "True" | "TRUE" => Some(true),
            "false" | "False" | "FALSE" => Some(false),
            _ => None,
        }
    }

    pub fn integer(&self) -> Option<i64> {
        if self.is_text {
            None
        } else if let Some(digits) = self.text.strip_prefix("0x") {
            i64::from_str_radix(digits, 16).ok()
        } else if let Some(digits) = self.text.strip_prefix("0o") {
            i64::from_str_radix(digits, 8).ok()
        } else {
            self.text.parse().ok()
        }
    }

    pub fn number(&self) -> Option<f64> {
        if self.is_text {
            return None;
        }
        self.integer()
            .map(|value| value as f64)
            .or_else(|| float(&self.text))
    }
}

/// A number with a point, an exponent, or none.
fn float(text: &str) -> Option<f64> {
    match text {
        ".inf" | ".Inf" | ".INF" | "+.inf" | "+.Inf" | "+.INF" => Some(f64::INFINITY),
        "-.inf" | "-.Inf" | "-.INF" => Some(f64::NEG_INFINITY),
        ".nan" | ".NaN" | ".NAN" => Some(f64::NAN),
        // Rust reads `inf` and `nan`, too, which are texts in YAML.
        _ if text.contains(|c: char| c.is_ascii_digit()) => text.parse().ok(),
        _ => None,
    }
}
