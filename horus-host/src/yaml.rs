//! YAML files: the only place that knows which library reads them.

use serde::de::DeserializeOwned;
use serde_saphyr::{RenderOptions, SnippetMode};
use thiserror::Error;

/// Why a YAML text was refused, with line and column where the library knows them.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{0}")]
pub struct YamlError(String);

/// Reads one document. Keys that `T` does not name are ignored where `T` says nothing else.
///
/// # Errors
/// [`YamlError`] in one line. Nesting and aliases are limited, so that no text takes unbounded memory.
pub fn from_str<T: DeserializeOwned>(text: &str) -> Result<T, YamlError> {
    serde_saphyr::from_str(text).map_err(|error| {
        let mut options = RenderOptions::default();
        options.snippets = SnippetMode::Off;
        let message = error.render_with_options(options);
        YamlError(message.split_whitespace().collect::<Vec<_>>().join(" "))
    })
}

/// A text as a YAML scalar that reads back as the same text, whatever is in it.
pub fn quoted(text: &str) -> String {
    // A JSON string is a double-quoted YAML scalar.
    serde_json::Value::from(text).to_string()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    #[test]
    fn errors_name_line_and_column() {
        for text in ["a: 1\nb: [1, 2\n", "a: 1\nb: x\n", "a: 1\na: 2\n"] {
            let error = from_str::<BTreeMap<String, i32>>(text).unwrap_err().to_string();
            assert!(error.contains("line 2") || error.contains("line 3"), "{error}");
            assert!(!error.contains('\n'));
        }
    }

    #[test]
    fn quoted_texts_read_back() {
        for text in [
            "map.pgm",
            "",
            "a: b",
            "\"'\\",
            "# no comment",
            "tab\tnewline\n",
            "é",
        ] {
            let map: BTreeMap<String, String> = from_str(&format!("key: {}", quoted(text))).unwrap();
            assert_eq!(map["key"], text);
        }
    }
}
