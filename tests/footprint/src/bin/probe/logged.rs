//! The plain data types and errors through a logger that keeps the last byte.

use core::sync::atomic::{AtomicU8, Ordering};

use horus_core::prelude::*;
use horus_footprint::opaque;

#[defmt::global_logger]
struct LastByte;

static LAST: AtomicU8 = AtomicU8::new(0);

// SAFETY: one thread without interrupts.
unsafe impl defmt::Logger for LastByte {
    fn acquire() {}
    unsafe fn flush() {}
    unsafe fn release() {}
    unsafe fn write(bytes: &[u8]) {
        if let Some(last) = bytes.last() {
            LAST.store(*last, Ordering::Relaxed);
        }
    }
}

pub fn call() {
    defmt::info!("{} {}", opaque(Pose2D::default()), opaque(GridInfo::EMPTY));
    defmt::info!("{} {}", opaque(CostParams::default()), opaque(ScanModel::Set));
    defmt::info!(
        "{} {}",
        opaque(ScanReport::default()),
        opaque(FootprintCost::default())
    );
    defmt::info!("{}", opaque(Error::NonFinitePose));
    defmt::info!(
        "{}",
        opaque(CostUpdate {
            changed: None,
            pending: 0
        })
    );
}
