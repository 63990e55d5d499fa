/// Declares a ROS message structure of a package from its field list, with everything that follows
/// from it: encoding, decoding, definition and comparison.
macro_rules! ros_struct {
    (
        $package:literal;
        $(#[$attribute:meta])*
        pub struct $name:ident {
            $($(#[$field_attribute:meta])* pub $field:ident: $type:ty,)+
        }
    ) => {
        $(#[$attribute])*
        #[derive(Debug, Clone, PartialEq)]
        pub struct $name {
            $($(#[$field_attribute])* pub $field: $type,)+
        }

        impl $crate::log::cdr::CdrValue for $name {
            const MIN_LEN: usize =
                0 $(+ <$type as $crate::log::cdr::CdrValue>::MIN_LEN)+;

            fn type_name() -> String {
                concat!($package, "/", stringify!($name)).to_owned()
            }

            fn define(definition: &mut $crate::log::cdr::Definition) {
                let name = concat!($package, "/", stringify!($name));
                let added = definition.add(name, || {
                    let mut fields = String::new();
                    $(
                        fields.push_str(&<$type as $crate::log::cdr::CdrValue>::type_name());
                        fields.push(' ');
                        fields.push_str(stringify!($field).trim_start_matches("r#"));
                        fields.push('\n');
                    )+
                    fields
                });
                if added {
                    $(<$type as $crate::log::cdr::CdrValue>::define(definition);)+
                }
            }

            fn encode(&self, writer: &mut $crate::log::cdr::CdrWriter) {
                $($crate::log::cdr::CdrValue::encode(&self.$field, writer);)+
            }

            fn decode(
                reader: &mut $crate::log::cdr::CdrReader,
            ) -> Result<Self, $crate::log::cdr::CdrError> {
                // Fields of a structure expression are evaluated in the order written.
                Ok(Self {
                    $($field: $crate::log::cdr::CdrValue::decode(reader)?,)+
                })
            }

            fn difference(&self, other: &Self) -> Option<$crate::log::cdr::FieldDifference> {
                $(
                    if let Some(found) =
                        $crate::log::cdr::CdrValue::difference(&self.$field, &other.$field)
                    {
                        return Some(found.under(stringify!($field).trim_start_matches("r#")));
                    }
                )+
                None
            }

            fn settle(&mut self, other: &Self, tolerance: f64) {
                $($crate::log::cdr::CdrValue::settle(&mut self.$field, &other.$field, tolerance);)+
            }
        }

        impl $crate::log::msg::Message for $name {
            const TYPE: &'static str = concat!($package, "/msg/", stringify!($name));
        }
    };
}
