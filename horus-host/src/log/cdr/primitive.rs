//! The primitive types of message definitions.
use super::{CdrError, CdrReader, CdrValue, CdrWriter, FieldDifference};

/// What all numbers share; the rest of the implementation is given in braces.
macro_rules! number {
    ($type:ty, $name:literal, $same:expr, { $($bulk:item)* }) => {
        impl CdrValue for $type {
            const MIN_LEN: usize = size_of::<$type>();

            fn type_name() -> String {
                $name.to_owned()
            }

            fn encode(&self, writer: &mut CdrWriter) {
                writer.number(self.to_le_bytes());
            }

            fn decode(reader: &mut CdrReader) -> Result<Self, CdrError> {
                reader.number().map(<$type>::from_le_bytes)
            }

            fn difference(&self, other: &Self) -> Option<FieldDifference> {
                let same: fn(&$type, &$type) -> bool = $same;
                (!same(self, other)).then(|| FieldDifference::leaf(self, other))
            }

            fn elements_difference(a: &[Self], b: &[Self]) -> Option<FieldDifference> {
                a.iter().zip(b).enumerate().find_map(|(index, (a, b))| {
                    let mut found = a.difference(b)?;
                    found.element = Some(index);
                    Some(found)
                })
            }

            $($bulk)*
        }
    };
}

number!(i32, "int32", |a, b| a == b, {});
number!(u32, "uint32", |a, b| a == b, {});
number!(f64, "float64", |a, b| a.to_bits() == b.to_bits(), {
    fn settle(&mut self, other: &Self, tolerance: f64) {
        if (*self - other).abs() <= tolerance {
            *self = *other;
        }
    }
});

number!(u8, "uint8", |a, b| a == b, {
    fn encode_elements(values: &[Self], writer: &mut CdrWriter) {
        writer.raw(1, values.iter().copied());
    }

    fn decode_elements(count: usize, reader: &mut CdrReader) -> Result<Vec<Self>, CdrError> {
        Ok(reader.raw(1, count)?.to_vec())
    }
});

number!(i8, "int8", |a, b| a == b, {
    fn encode_elements(values: &[Self], writer: &mut CdrWriter) {
        writer.raw(1, values.iter().map(|value| value.cast_unsigned()));
    }

    fn decode_elements(count: usize, reader: &mut CdrReader) -> Result<Vec<Self>, CdrError> {
        let bytes = reader.raw(1, count)?;
        Ok(bytes.iter().map(|byte| byte.cast_signed()).collect())
    }
});

number!(f32, "float32", |a, b| a.to_bits() == b.to_bits(), {
    fn settle(&mut self, other: &Self, tolerance: f64) {
        if (f64::from(*self) - f64::from(*other)).abs() <= tolerance {
            *self = *other;
        }
    }

    fn encode_elements(values: &[Self], writer: &mut CdrWriter) {
        writer.floats(values);
    }

    fn decode_elements(count: usize, reader: &mut CdrReader) -> Result<Vec<Self>, CdrError> {
        reader.floats(count)
    }
});

impl CdrValue for String {
    const MIN_LEN: usize = 4;

    fn type_name() -> String {
        "string".to_owned()
    }

    fn encode(&self, writer: &mut CdrWriter) {
        writer.string(self);
    }

    fn decode(reader: &mut CdrReader) -> Result<Self, CdrError> {
        reader.string()
    }

    fn difference(&self, other: &Self) -> Option<FieldDifference> {
        (self != other).then(|| FieldDifference::leaf(format_args!("{self:?}"), format_args!("{other:?}")))
    }
}
