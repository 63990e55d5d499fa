//! The local map: 200x200 cells of 5 cm, 360 and 1080 rays, a robot that moves by most of a cell per update.
//!
//! `cargo bench -p horus-host --bench local` prints thread CPU time per update. With `HORUS_PEER_PYTHON` naming a
//! Python that has navground 0.7.0 and numpy, navground updates its map from the same poses and scans in the same
//! run (`benches/peers/navground_local.py`); the last maps must be equal, and ours must be three times as fast.

use std::hint::black_box;
use std::path::PathBuf;
use std::process::{Command, ExitCode};
use std::time::Duration;

use cpu_time::ThreadTime;
use horus_core::local::BufferSlot;
use horus_core::prelude::*;

const SIDE: u32 = 200;
const RESOLUTION: f32 = 0.05;
const MAX_RANGE: f32 = 8.0;
const RADIUS: f32 = 0.2;
const STEPS: usize = 400;
/// The fastest pass counts: what else the machine does only ever adds.
const PASSES: usize = 15;
/// Ours must be faster by this.
const FACTOR: f64 = 3.0;

/// A drive through a corridor with pillars.
struct Drive {
    rays: usize,
    poses: Vec<Pose2D>,
    scans: Vec<Vec<f32>>,
}

impl Drive {
    fn new(rays: usize) -> Self {
        let pose = |step: usize| {
            let t = step as f32;
            Pose2D::new(
                0.013 + 0.041 * t,
                0.9 * (0.05 * t).sin() + 0.007,
                0.3 * (0.03 * t).cos(),
            )
        };
        let poses: Vec<_> = (0..STEPS).map(pose).collect();
        let scans = poses.iter().map(|pose| {
            let range = |ray: usize| {
                let angle = f64::from(pose.theta)
                    + f64::from(START)
                    + ray as f64 * f64::from(FOV) / (rays - 1) as f64;
                range_along(f64::from(pose.x), f64::from(pose.y), angle) as f32
            };
            (0..rays).map(range).collect()
        });
        let scans = scans.collect();
        Self { rays, poses, scans }
    }

    fn lidar(&self) -> Lidar<'static> {
        Lidar {
            name: "lidar",
            mount: Pose2D::default(),
            start_angle: START,
            fov: FOV,
            max_range: MAX_RANGE,
        }
    }

    /// The input of the peer.
    fn write(&self) -> std::io::Result<PathBuf> {
        let mut bytes = Vec::new();
        for number in [SIDE, self.rays as u32, STEPS as u32] {
            bytes.extend(number.to_le_bytes());
        }
        let mut floats = |numbers: &[f32]| bytes.extend(numbers.iter().flat_map(|n| n.to_le_bytes()));
        floats(&[RESOLUTION, START, FOV, MAX_RANGE, RADIUS]);
        for (pose, scan) in self.poses.iter().zip(&self.scans) {
            floats(&[pose.x, pose.y, pose.theta]);
            floats(scan);
        }
        let path = std::env::temp_dir().join(format!("horus-local-{}-{}.bin", std::process::id(), self.rays));
        std::fs::write(&path, bytes)?;
        Ok(path)
    }

    /// Time per update, and the last map.
    fn run(&self) -> (Duration, Vec<u8>) {
        let lidars = [self.lidar()];
        let config = LocalGridMapConfig {
            width: SIDE,
            height: SIDE,
            resolution: RESOLUTION,
            radius: RADIUS,
            external_odometry: "odom",
            lidars: &lidars,
            ..LocalGridMapConfig::default()
        };
        let mut best = Duration::MAX;
        let mut last = Vec::new();
        for _ in 0..PASSES {
            let cells = vec![0; (SIDE * SIDE) as usize];
            let mut map = LocalGridMap::new_in(cells, config).expect("a legal map");
            let mut slots = [BufferSlot::EMPTY; 8];
            let mut floats = vec![0.0; self.rays + 16];
            let mut state = SensingState::new_in(&mut slots, &mut floats, &mut []);
            let mut beams = vec![BeamSlot::EMPTY; self.rays];
            let mut workspaces = [ScanWorkspace::new_in(&mut beams, &mut [])];
            let odometry = Odometry { name: "odom" };
            let mut spent = Duration::ZERO;
            for (pose, scan) in self.poses.iter().zip(&self.scans) {
                odometry.write(&mut state, *pose, [0.0; 3]).expect("room");
                lidars[0].write(&mut state, scan).expect("room");
                let start = ThreadTime::now();
                let update = map.update(&state, Pose2D::default(), &mut workspaces);
                spent += start.elapsed();
                black_box(update).expect("a legal update");
            }
            best = best.min(spent);
            last = map.data().to_vec();
        }
        (best / STEPS as u32, last)
    }
}

const START: f32 = -3.1;
const FOV: f32 = 6.2;

/// How far a ray goes: walls along x, pillars every 2 m, ends beyond sight.
fn range_along(x: f64, y: f64, angle: f64) -> f64 {
    let (sin, cos) = angle.sin_cos();
    let wall = if sin > 0.0 {
        (2.731 - y) / sin
    } else {
        (-3.117 - y) / sin
    };
    let pillar = |i: i32| {
        let (px, py) = (
            1.037 + 2.0 * f64::from(i) - x,
            if i % 2 == 0 { 1.511 } else { -1.713 } - y,
        );
        let (along, across) = (px * cos + py * sin, py * cos - px * sin);
        if along > 0.0 && across.abs() < 0.173 {
            along - (0.03 - across * across).sqrt().max(0.0)
        } else {
            f64::INFINITY
        }
    };
    let nearest = (0..10).map(pillar).fold(wall, f64::min);
    nearest.min(f64::from(MAX_RANGE))
}

fn fnv1a64(bytes: &[u8]) -> u64 {
    let step = |hash: u64, &byte: &u8| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, step)
}

/// The peer's nanoseconds per update and the hash of its last map.
fn peer(python: &str, drive: &Drive) -> Result<(f64, u64), String> {
    let input = drive.write().map_err(|error| error.to_string())?;
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/peers/navground_local.py");
    let output = Command::new(python).arg(script).arg(&input).output();
    let _ = std::fs::remove_file(&input);
    let output = output.map_err(|error| format!("{python}: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout);
    let words: Vec<_> = text.split_whitespace().collect();
    let told = match words[..] {
        [_, ns, hash] => ns.parse().ok().zip(u64::from_str_radix(hash, 16).ok()),
        _ => None,
    };
    told.ok_or_else(|| format!("{python}: {}", String::from_utf8_lossy(&output.stderr)))
}

fn main() -> ExitCode {
    let python = std::env::var("HORUS_PEER_PYTHON").ok();
    let mut reached = true;
    for rays in [360, 1080] {
        let drive = Drive::new(rays);
        let (time, map) = drive.run();
        let own = time.as_nanos() as f64;
        println!(
            "local map, {SIDE}x{SIDE}, {rays} rays: {:.1} us per update",
            own / 1e3
        );
        let Some(python) = &python else { continue };
        match peer(python, &drive) {
            Ok((ns, hash)) => {
                let factor = ns / own;
                let same = if hash == fnv1a64(&map) {
                    "equal"
                } else {
                    "DIFFERENT"
                };
                println!(
                    "  navground 0.7.0: {:.1} us, {factor:.2} times as long; last maps {same}",
                    ns / 1e3
                );
                reached &= factor >= FACTOR && hash == fnv1a64(&map);
            }
            Err(error) => {
                eprintln!("the peer did not run: {error}");
                reached = false;
            }
        }
    }
    if reached {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
