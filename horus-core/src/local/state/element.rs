use super::SensingState;
use crate::error::Buffer;

/// What a named buffer is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ElementKind {
    /// 32-bit floats.
    F32,
    /// Bytes.
    U8,
}

/// An element of a named buffer: `f32` or `u8`.
pub trait Element: Copy + sealed::Sealed {}

impl Element for f32 {}
impl Element for u8 {}

pub(super) mod sealed {
    use super::{Buffer, ElementKind, SensingState};

    /// The part of the storage that holds elements of a kind.
    pub trait Sealed: Sized {
        const KIND: ElementKind;
        /// Its name in an error.
        const BUFFER: Buffer;
        fn elements<'s>(state: &'s SensingState<'_>) -> &'s [Self];
        fn elements_mut<'s>(state: &'s mut SensingState<'_>) -> &'s mut [Self];
    }

    impl Sealed for f32 {
        const KIND: ElementKind = ElementKind::F32;
        const BUFFER: Buffer = Buffer::Floats;
        fn elements<'s>(state: &'s SensingState<'_>) -> &'s [Self] {
            state.floats
        }
        fn elements_mut<'s>(state: &'s mut SensingState<'_>) -> &'s mut [Self] {
            state.floats
        }
    }

    impl Sealed for u8 {
        const KIND: ElementKind = ElementKind::U8;
        const BUFFER: Buffer = Buffer::Bytes;
        fn elements<'s>(state: &'s SensingState<'_>) -> &'s [Self] {
            state.bytes
        }
        fn elements_mut<'s>(state: &'s mut SensingState<'_>) -> &'s mut [Self] {
            state.bytes
        }
    }
}
