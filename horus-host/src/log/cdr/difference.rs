/// The first field in which two messages of one type differ.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FieldDifference {
    /// Path of the field, e.g. `info.origin.position.x`, `transforms[2].child_frame_id`, `data`.
    pub path: String,
    /// Index of the element, where the field is a sequence of numbers; `None` where the sequences
    /// differ in length or the field is no sequence.
    pub element: Option<usize>,
    /// The value in the first message.
    pub a: String,
    /// The value in the second message.
    pub b: String,
}

impl FieldDifference {
    /// A difference between two values that have no parts.
    pub(crate) fn leaf(a: impl ToString, b: impl ToString) -> Self {
        Self {
            path: String::new(),
            element: None,
            a: a.to_string(),
            b: b.to_string(),
        }
    }

    /// The same difference seen from the structure that holds it under `part`.
    pub(crate) fn under(mut self, part: &str) -> Self {
        // `part` is a field name or an index such as `[2]`; only names are joined by a dot.
        let dot = if self.path.is_empty() || self.path.starts_with('[') {
            ""
        } else {
            "."
        };
        self.path = format!("{part}{dot}{}", self.path);
        self
    }
}
