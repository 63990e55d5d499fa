use crate::log::cdr::{CdrError, CdrReader, CdrValue, CdrWriter, Definition};

/// A message type that can be a topic of a log.
pub trait Message: CdrValue {
    /// Full type name, e.g. `nav_msgs/msg/OccupancyGrid`.
    const TYPE: &'static str;

    /// The concatenated `ros2msg` definition: this type's fields, then every type they use.
    fn definition() -> String {
        let mut definition = Definition::default();
        Self::define(&mut definition);
        definition.into_text()
    }

    /// The message as a payload, encapsulation header included.
    ///
    /// # Errors
    /// [`CdrError::NulInString`] or [`CdrError::TooLong`].
    fn to_payload(&self) -> Result<Vec<u8>, CdrError> {
        let mut writer = CdrWriter::new();
        self.encode(&mut writer);
        writer.finish().map(<[u8]>::to_vec)
    }

    /// Decodes a payload.
    ///
    /// # Errors
    /// Whatever is wrong with the payload, see [`CdrError`].
    fn from_payload(payload: &[u8]) -> Result<Self, CdrError> {
        let mut reader = CdrReader::new(payload)?;
        let message = Self::decode(&mut reader)?;
        reader.finish()?;
        Ok(message)
    }
}
