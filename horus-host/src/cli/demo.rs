use std::path::PathBuf;

use anyhow::bail;
use clap::Args;
use horus_host::log::msg::{Header, LaserScan};
use horus_host::sim::{Lidar, Pose, SimConfig, SimTick, Simulation};
use horus_host::tf::Pose2;

use super::map_log::Frames;
use super::map_options::MapOptions;
use super::out_dir::OutDir;
use super::progress;
use super::session::{Session, conclude};
use super::step::{ScanStep, Step};
use super::verdict::Verdict;

/// Longest simulation in seconds: a day.
const LONGEST: f64 = 86_400.0;

/// Drive a robot through a made-up building.
#[derive(Debug, Args)]
pub struct DemoOptions {
    /// Directory for logs, pictures and summary
    #[arg(long, value_name = "DIR", default_value = "out")]
    out: PathBuf,
    /// How long the robot drives, ten scans a second
    #[arg(long, value_name = "S", default_value_t = 60.0, allow_negative_numbers = true)]
    seconds: f64,
    /// Seed of the building, the people in it and the noise
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Log the maps of every K-th scan only
    #[arg(long, value_name = "K", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..))]
    log_every: u64,
    /// Print one JSON object and nothing else
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    map: MapOptions,
}

pub fn run(options: &DemoOptions) -> anyhow::Result<Verdict> {
    let config = options.map.config();
    config.validate()?;
    let sim = SimConfig {
        seed: options.seed,
        ..SimConfig::default()
    };
    let ticks = options.seconds * 1e9 / sim.tick_ns as f64;
    if !(ticks >= 1.0 && options.seconds <= LONGEST) {
        bail!("a demo takes 0.1 to {LONGEST} seconds, not {}", options.seconds);
    }
    let out = OutDir::create(&options.out)?;
    let simulation = Simulation::new(SimConfig {
        ticks: ticks.round() as u32,
        ..sim
    });
    let lidar = simulation.config().lidar.clone();
    let frames = Frames {
        odom: "odom".to_owned(),
        base: "base_link".to_owned(),
    };
    let session = Session {
        config,
        frames: &frames,
        beams: lidar.beams,
        out: Some(&out),
        log_every: options.log_every,
        limit: u64::MAX,
    };
    let bar = progress::bar(simulation.len() as u64);
    let period_s = sim.tick_ns as f32 * 1e-9;
    let steps = simulation.map(|tick| Ok(Step::Scan(Box::new(step(tick, &lidar, period_s)))));
    let source = format!("simulation of {} s, seed {}", options.seconds, options.seed);
    conclude(session.run(source, steps, &bar)?, Some(&out), options.json)
}

fn step(tick: SimTick, lidar: &Lidar, period_s: f32) -> ScanStep {
    let last_beam = lidar.beams.saturating_sub(1) as f32;
    ScanStep {
        stamp_ns: tick.stamp_ns,
        scan: LaserScan {
            header: Header::new(tick.stamp_ns, "laser"),
            angle_min: lidar.angle_min,
            angle_max: lidar.angle_min + last_beam * lidar.angle_increment,
            angle_increment: lidar.angle_increment,
            time_increment: 0.0,
            scan_time: period_s,
            range_min: lidar.range_min,
            range_max: lidar.range_max,
            ranges: tick.ranges,
            intensities: Vec::new(),
        },
        robot: planar(&tick.robot),
        sensor: planar(&tick.robot.mounted(&lidar.mount)),
        mount: planar(&lidar.mount),
        map_from_odom: None,
    }
}

fn planar(pose: &Pose) -> Pose2 {
    Pose2 {
        x: pose.x,
        y: pose.y,
        yaw: pose.theta,
    }
}
