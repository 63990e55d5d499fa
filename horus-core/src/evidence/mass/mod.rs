//! Mass cells.

mod cell;
mod f32;
mod integer;
mod masses;
mod u16;
mod u8;

pub use self::cell::MassCell;
pub use self::f32::EvidenceF32;
pub use self::masses::Masses;
pub use self::u8::EvidenceU8;
pub use self::u16::EvidenceU16;
