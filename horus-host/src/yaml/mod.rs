//! YAML files of one flat mapping, with lines in errors: the only place that knows which library reads them.
//!
//! # Examples
//! ```
//! use horus_host::yaml::Document;
//!
//! let document = Document::parse("resolution: 0.05\norigin: [1, 2.5, 0]\nname: room\n")?;
//! assert_eq!(document.required("origin")?.numbers()?, [1.0, 2.5, 0.0]);
//! let error = document.required("name")?.number().unwrap_err();
//! assert_eq!(error.to_string(), "line 3: name: a number is expected, not room");
//! let error = Document::parse("width: 3\nwidth: 4\n").unwrap_err();
//! assert_eq!(error.to_string(), "line 2: width: the key is given twice, first in line 1");
//! # Ok::<(), horus_host::yaml::YamlError>(())
//! ```

mod document;
mod entry;
mod error;
mod scalar;
#[cfg(test)]
mod tests;

pub use document::Document;
pub use entry::Entry;
pub use error::YamlError;

/// A text as a YAML scalar that reads back as the same text, whatever is in it.
pub fn quoted(text: &str) -> String {
    // A JSON string is a double-quoted YAML scalar.
    serde_json::Value::from(text).to_string()
}
