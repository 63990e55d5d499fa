//! The core in one process, the std version in another: every map is compared.

use horus_core::costmap::{CostTables, bit_words, scratch_words};
use horus_core::prelude as core;
use horus_host::reference;
use horus_host::sim::{Lidar, SimConfig, Simulation};
use horus_host::topic::{GridHeader, PoseMsg, ScanHeader, SliceTopic, Topic, TopicOptions, kind};

use crate::peer::{PATIENCE, TestDomain, domain, until};

const SIDE: u32 = 80;
const RESOLUTION: f32 = 0.05;
const TICKS: u32 = 60;
const BEAMS: usize = 90;

/// Where the corner lies before the window first moves.
const CORNER: f32 = -2.0;

#[test]
fn core_and_std_version_agree_across_processes() {
    let domain = TestDomain::new("versions");
    let options = TopicOptions::reliable();
    let poses: Topic<PoseMsg> = Topic::open(&domain.0, "pose2d", options).unwrap();
    let scans: SliceTopic<kind::Scan> = SliceTopic::open(&domain.0, "laser_scan", options).unwrap();
    let grids: SliceTopic<kind::Occupancy> = SliceTopic::open(&domain.0, "occupancy_grid", options).unwrap();
    let costs: SliceTopic<kind::Costs> = SliceTopic::open(&domain.0, "cost_map", options).unwrap();
    let core = domain.start("both_versions::core_process", &[]);

    let corner = reference::Pose2D::new(CORNER.into(), CORNER.into(), 0.0);
    let grid = reference::OccupancyGrid::try_new(SIDE, SIDE, RESOLUTION, corner).unwrap();
    let mut map = reference::CostMap::with_params(grid, reference::CostParams::default()).unwrap();
    let mut occupied = 0;
    for tick in 0..u64::from(TICKS) {
        let (mut pose, mut scan, mut cells, mut cost) = (None, None, None, None);
        until(|| {
            pose = pose.take().or_else(|| poses.recv().unwrap());
            scan = scan.take().or_else(|| scans.recv().unwrap());
            cells = cells.take().or_else(|| grids.recv().unwrap());
            cost = cost.take().or_else(|| costs.recv().unwrap());
            (pose.is_some() && scan.is_some() && cells.is_some() && cost.is_some()).then_some(())
        });
        let (pose, scan, cells, cost) = (pose.unwrap(), scan.unwrap(), cells.unwrap(), cost.unwrap());
        assert_eq!(pose.timestamp_ns, tick);
        let robot = reference::Pose2D::new(pose.x, pose.y, pose.theta);
        let header = scan.header();
        let grid = &mut map.occupancy_grid;
        grid.recenter(robot).unwrap();
        let scan = reference::LaserScan {
            angle_min: header.angle_min,
            angle_increment: header.angle_increment,
            range_min: header.range_min,
            range_max: header.range_max,
            ranges: scan.elements().to_vec(),
        };
        grid.integrate_scan(&scan, robot, reference::ScanModel::Set)
            .unwrap();
        map.compute_costs();
        assert_eq!(cells.header().timestamp_ns, tick);
        assert_eq!(
            cells.elements(),
            map.occupancy_grid.data,
            "occupancy of tick {tick}"
        );
        assert_eq!(cost.elements(), map.costs, "costs of tick {tick}");
        occupied = cells.elements().iter().filter(|&&cell| cell == 100).count();
    }
    assert!(
        occupied > 20,
        "{occupied} occupied cells at the end: nothing was mapped"
    );
    core.join();
}

/// Maps a simulated drive and publishes scans, poses and maps; the costs are written in shared memory.
#[test]
#[ignore = "a role, not a test"]
fn core_process() {
    let (domain, options) = (domain(), TopicOptions::reliable());
    let poses: Topic<PoseMsg> = Topic::open(&domain, "pose2d", options).unwrap();
    let scans: SliceTopic<kind::Scan> = SliceTopic::open(&domain, "laser_scan", options).unwrap();
    let grids: SliceTopic<kind::Occupancy> = SliceTopic::open(&domain, "occupancy_grid", options).unwrap();
    let costs: SliceTopic<kind::Costs> = SliceTopic::open(&domain, "cost_map", options).unwrap();
    poses.wait_for_subscribers(1, PATIENCE).unwrap();
    scans.wait_for_subscribers(1, PATIENCE).unwrap();
    grids.wait_for_subscribers(1, PATIENCE).unwrap();
    costs.wait_for_subscribers(1, PATIENCE).unwrap();

    let lidar = Lidar {
        beams: BEAMS,
        angle_increment: std::f32::consts::TAU / BEAMS as f32,
        ..Lidar::default()
    };
    let config = SimConfig {
        ticks: TICKS,
        lidar: lidar.clone(),
        ..SimConfig::default()
    };
    let len = (SIDE * SIDE) as usize;
    let (mut cells, mut field) = (vec![0; len], vec![0u8; len]);
    let (mut bits, mut scratch) = (vec![0; bit_words(SIDE, SIDE)], vec![0; scratch_words(15)]);
    let mut tables = CostTables::EMPTY;
    let buffers = core::CostBuffers {
        bits: &mut bits,
        field: &mut field,
        scratch: &mut scratch,
        costs: None,
        tables: &mut tables,
    };
    let corner = core::Pose2D::new(CORNER, CORNER, 0.0);
    let grid = core::OccupancyGrid::new_in(&mut cells[..], SIDE, SIDE, RESOLUTION, corner).unwrap();
    let mut map = core::CostMap::new_in(grid, buffers, core::CostParams::default()).unwrap();
    let mut beams = core::ScanBuffers::<BEAMS, 0>::empty();
    for (tick, step) in (0..).zip(Simulation::new(config)) {
        let robot = core::Pose2D::new(step.robot.x as f32, step.robot.y as f32, step.robot.theta as f32);
        let scan = core::LaserScan {
            angle_min: lidar.angle_min,
            angle_increment: lidar.angle_increment,
            range_min: lidar.range_min,
            range_max: lidar.range_max,
            ranges: &step.ranges,
        };
        map.recenter(robot).unwrap();
        map.integrate_scan(&scan, robot, core::ScanModel::Set, &mut beams.workspace())
            .unwrap();
        map.update_costs();

        let pose = PoseMsg {
            timestamp_ns: tick,
            x: robot.x.into(),
            y: robot.y.into(),
            theta: robot.theta.into(),
        };
        assert_eq!(poses.send(pose).unwrap(), 1);
        let header = ScanHeader {
            timestamp_ns: tick,
            angle_min: scan.angle_min,
            angle_increment: scan.angle_increment,
            range_min: scan.range_min,
            range_max: scan.range_max,
            beams: BEAMS as u32,
            ..ScanHeader::default()
        };
        assert_eq!(scans.send(header, scan.ranges).unwrap(), 1);
        let header = GridHeader {
            timestamp_ns: tick,
            ..GridHeader::of_info(map.info())
        };
        assert_eq!(grids.send(header, map.occupancy_grid().data()).unwrap(), 1);
        let mut message = costs.loan(header, 255).unwrap();
        for (gy, row) in (0..).zip(message.elements_mut().chunks_exact_mut(SIDE as usize)) {
            for (cost, value) in row.iter_mut().zip(map.row(gy)) {
                *cost = value;
            }
        }
        assert_eq!(message.send().unwrap(), 1);
    }
}
