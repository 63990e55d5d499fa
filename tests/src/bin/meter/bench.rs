use horus_core::prelude::*;
use horus_tests::Once;
use horus_tests::meter::{Meter, Table};
use horus_tests::workload::{BEAMS, Lidar, Office};

use crate::occupied::{Occupied, WORDS};

/// Beam slots, and the bits of accumulating scans.
pub type LidarBuffers = ScanBuffers<BEAMS, WORDS>;

/// What every section works with.
pub struct Bench<'t> {
    pub meter: Meter,
    pub table: &'t mut Table,
    pub office: &'static Office,
    pub lidar: &'static mut Lidar,
    pub beams: &'static mut LidarBuffers,
    pub occupied: &'static mut Occupied,
}

impl<'t> Bench<'t> {
    /// Builds the office; called once.
    pub fn new(meter: Meter, table: &'t mut Table) -> Self {
        static OFFICE: Once<Office> = Once::new(Office::empty());
        static LIDAR: Once<Lidar> = Once::new(Lidar::new());
        static BUFFERS: Once<LidarBuffers> = Once::new(LidarBuffers::empty());
        static OCCUPIED: Once<Occupied> = Once::new(Occupied::empty());
        // SAFETY: this function runs once.
        let (office, lidar, beams, occupied) =
            unsafe { (OFFICE.take(), LIDAR.take(), BUFFERS.take(), OCCUPIED.take()) };
        office.build();
        Self {
            meter,
            table,
            office,
            lidar,
            beams,
            occupied,
        }
    }
}
