use super::{CdrError, CdrReader, CdrValue, CdrWriter, Definition, FieldDifference};

/// A sequence: a 32-bit count and the elements.
impl<T: CdrValue> CdrValue for Vec<T> {
    const MIN_LEN: usize = 4;

    fn type_name() -> String {
        format!("{}[]", T::type_name())
    }

    fn define(definition: &mut Definition) {
        T::define(definition);
    }

    fn encode(&self, writer: &mut CdrWriter) {
        writer.length(self.len());
        T::encode_elements(self, writer);
    }

    fn decode(reader: &mut CdrReader) -> Result<Self, CdrError> {
        let count = reader.length(T::MIN_LEN)?;
        T::decode_elements(count, reader)
    }

    fn difference(&self, other: &Self) -> Option<FieldDifference> {
        if self.len() == other.len() {
            return T::elements_difference(self, other);
        }
        let elements = |sequence: &Self| format!("{} elements", sequence.len());
        Some(FieldDifference::leaf(elements(self), elements(other)))
    }
    fn settle(&mut self, other: &Self, tolerance: f64) {
        if self.len() == other.len() {
            for (element, other) in self.iter_mut().zip(other) {
                element.settle(other, tolerance);
            }
        }
    }
}
