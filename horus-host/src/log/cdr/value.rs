use super::{CdrError, CdrReader, CdrWriter, FieldDifference};

/// A type with an XCDR1 encoding and a name in ROS message definitions.
pub trait CdrValue: Sized {
    /// Fewest bytes one value takes, padding not counted; at least 1. Bounds sequence lengths.
    const MIN_LEN: usize;

    /// Name in a definition: `float32`, `std_msgs/Header`, `uint8[]`.
    fn type_name() -> String;

    /// Adds the definitions of this type and of every type in it; nothing for primitives.
    fn define(_definition: &mut Definition) {}

    /// Appends the value.
    fn encode(&self, writer: &mut CdrWriter);

    /// Reads a value.
    ///
    /// # Errors
    /// Whatever is wrong with the payload, see [`CdrError`].
    fn decode(reader: &mut CdrReader) -> Result<Self, CdrError>;

    /// First field that differs, `None` if all are equal. Floats are compared by their bits.
    fn difference(&self, other: &Self) -> Option<FieldDifference>;

    /// Takes the value of `other` in every float that is at most `tolerance` away from it.
    fn settle(&mut self, _other: &Self, _tolerance: f64) {}

    /// Appends the elements of a sequence, without their count.
    fn encode_elements(values: &[Self], writer: &mut CdrWriter) {
        for value in values {
            value.encode(writer);
        }
    }

    /// Reads `count` elements; the caller has bounded `count` by [`MIN_LEN`](Self::MIN_LEN).
    ///
    /// # Errors
    /// As [`decode`](Self::decode).
    fn decode_elements(count: usize, reader: &mut CdrReader) -> Result<Vec<Self>, CdrError> {
        (0..count).map(|_| Self::decode(reader)).collect()
    }

    /// First difference between two sequences of equal length.
    fn elements_difference(a: &[Self], b: &[Self]) -> Option<FieldDifference> {
        a.iter()
            .zip(b)
            .enumerate()
            .find_map(|(index, (a, b))| a.difference(b).map(|found| found.under(&format!("[{index}]"))))
    }
}

/// Collects the structures a message is made of, in order of first use, each once.
#[derive(Debug, Default)]
pub struct Definition {
    structures: Vec<(&'static str, String)>,
}

impl Definition {
    /// Adds a structure: its name (`geometry_msgs/Pose`) and its fields, one `type name` per line.
    /// `false` if it is known already, and then so are the types in it.
    pub fn add(&mut self, name: &'static str, fields: impl FnOnce() -> String) -> bool {
        if self.structures.iter().any(|(known, _)| *known == name) {
            return false;
        }
        self.structures.push((name, fields()));
        true
    }

    /// The concatenated `ros2msg` text: the first structure, then the others behind separators.
    pub fn into_text(self) -> String {
        let separator = "=".repeat(80);
        let mut text = String::new();
        for (index, (name, fields)) in self.structures.iter().enumerate() {
            if index > 0 {
                text.push_str(&format!("{separator}\nMSG: {name}\n"));
            }
            text.push_str(fields);
        }
        text
    }
}
