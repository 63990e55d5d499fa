//! A control loop's whole tick: the window follows the robot, a scan comes in, costs follow.

use horus_core::Error;
use horus_core::costmap::FieldCell;
use horus_core::prelude::*;
use horus_tests::meter::Stat;
use horus_tests::workload::{Lidar, RESOLUTION, robot};

use crate::bench::Bench;
use crate::case::Case;

const TICKS: u32 = 40;

pub fn run<F: FieldCell>(
    case: &Case,
    (cells, buffers): (&mut [i8], CostBuffers<'_, F>),
    bench: &mut Bench<'_>,
) -> Result<(), Error> {
    let Bench {
        meter,
        table,
        office,
        lidar,
        beams,
        ..
    } = bench;
    // The robot starts at the window's centre.
    let (start, half) = (robot(0), case.side as f32 * 0.5);
    let corner = (start.x / RESOLUTION - half, start.y / RESOLUTION - half);
    let mut map = CostMap::new_in(case.grid(cells, corner)?, buffers, case.params)?;
    case.show(office, &mut map);

    let mut workspace = beams.workspace();
    **lidar = Lidar::new();
    let mut stat = Stat::default();
    for tick in 0..TICKS {
        let (scan, pose) = (lidar.measure(office, tick), robot(tick));
        let (done, cost) = meter.measure(|| {
            map.recenter(pose)?;
            map.integrate_scan(&scan, pose, ScanModel::Set, &mut workspace)?;
            Ok(map.update_costs())
        });
        done?;
        // The first scan is the one that adds range noise to a clean map, and computes directions.
        if tick > 0 {
            stat.add(cost);
        }
    }
    table.row(case.setting, "tick: recenter, integrate_scan, update_costs", stat);
    Ok(())
}
