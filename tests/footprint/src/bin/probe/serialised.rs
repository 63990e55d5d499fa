//! The plain data types through a real format, both ways.

use horus_core::prelude::*;
use horus_footprint::{need, opaque};
use postcard::{from_bytes, to_slice};

pub fn call() {
    let buffer = &mut opaque([0u8; 64])[..];
    need(to_slice(&opaque(Pose2D::default()), buffer).is_ok());
    need(to_slice(&opaque(GridInfo::EMPTY), buffer).is_ok());
    need(to_slice(&opaque(CostParams::default()), buffer).is_ok());
    need(to_slice(&opaque(ScanModel::Set), buffer).is_ok());
    need(from_bytes::<Pose2D>(opaque(buffer)).ok());
    need(from_bytes::<CellRect>(opaque(buffer)).ok());
    need(from_bytes::<CostParams>(opaque(buffer)).ok());
    need(from_bytes::<ScanModel>(opaque(buffer)).ok());
}
