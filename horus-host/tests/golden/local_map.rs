//! navground: whole maps of `LocalGridMap`, cell by cell.

use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::subject::LocalMap;
use crate::vectors::*;

/// Traces that hold what navground leaves behind in a move of a whole window.
const STALE: [&str; 2] = ["r07_far_moves", "e11_shift_edges"];

/// One lidar's scan in a trace.
pub struct TraceScan {
    pub start_angle: f32,
    pub fov: f32,
    pub max_range: f32,
    pub ranges: Vec<f32>,
}

/// What a trace's map is made from.
pub struct TraceMap {
    pub width: u32,
    pub height: u32,
    pub resolution: f32,
    pub footprint: String,
    pub radius: f32,
    /// Names of the lidars, in their order.
    pub lidars: Vec<String>,
    pub has_odometry: bool,
}

/// The `.f32` of a trace: one record per step.
struct Records<'t> {
    layout: &'t Value,
    numbers: Vec<f32>,
    per_step: usize,
}

impl<'t> Records<'t> {
    fn read(path: &Path, trace: &'t Value) -> Self {
        let bytes = std::fs::read(path.with_extension("f32")).expect("the trace's .f32");
        let number = |b: &[u8]| f32::from_le_bytes(b.try_into().unwrap());
        Self {
            layout: &trace["layout_f32"],
            numbers: bytes.chunks_exact(4).map(number).collect(),
            per_step: int(&trace["f32_per_step"]) as usize,
        }
    }

    /// `count` numbers of a step.
    fn part(&self, step: usize, at: &Value, count: usize) -> &[f32] {
        let start = step * self.per_step + int(at) as usize;
        &self.numbers[start..start + count]
    }

    fn three(&self, step: usize, name: &str) -> [f32; 3] {
        self.part(step, &self.layout[name][0], 3).try_into().unwrap()
    }

    fn scans(&self, step: usize) -> Vec<TraceScan> {
        let scan = |lidar: &Value| TraceScan {
            start_angle: self.part(step, &lidar["start_angle"], 1)[0],
            fov: self.part(step, &lidar["fov"], 1)[0],
            max_range: self.part(step, &lidar["max_range"], 1)[0],
            ranges: self
                .part(step, &lidar["ranges"][0], int(&lidar["ranges"][1]) as usize)
                .to_vec(),
        };
        items(&self.layout["lidars"]).iter().map(scan).collect()
    }
}

fn traces() -> Vec<(PathBuf, Value)> {
    let files = folders("navground").into_iter().flat_map(|folder| {
        let entries = std::fs::read_dir(folder).expect("a readable folder");
        entries.map(|entry| entry.expect("a readable folder").path())
    });
    let mut files: Vec<_> = files
        .filter(|p| p.extension().is_some_and(|e| e == "json"))
        .collect();
    files.sort();
    let traces = files.into_iter().map(|path| (read(&path), path));
    traces
        .filter(|(trace, _)| trace["layout_f32"].is_object())
        .map(|(trace, path)| (path, trace))
        .collect()
}

fn map_of(trace: &Value) -> TraceMap {
    let (width, height) = size_of(trace);
    let name = |lidar: &Value| lidar["name"].as_str().expect("a name").to_owned();
    TraceMap {
        width,
        height,
        resolution: f32_of(&trace["resolution"]),
        footprint: trace["footprint"].as_str().expect("a name").to_owned(),
        radius: f32_of(&trace["radius"]),
        lidars: items(&trace["lidars"]).iter().map(name).collect(),
        has_odometry: trace["external_odometry"] == true,
    }
}

fn fnv1a64(bytes: &[u8]) -> u64 {
    let step = |hash: u64, &byte: &u8| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, step)
}

/// The first cell in which two maps differ.
fn first_difference(a: &[u8], b: &[u8], width: u32) -> String {
    let Some(i) = a.iter().zip(b).position(|(a, b)| a != b) else {
        return "none".to_owned();
    };
    let differing = a.iter().zip(b).filter(|(a, b)| a != b).count();
    let (x, y) = (i % width as usize, i / width as usize);
    format!("({x}, {y}): {} instead of {}, and {differing} in all", a[i], b[i])
}

#[test]
fn navground_maps_bit_for_bit() {
    let mut compared = Vec::new();
    for (path, trace) in traces() {
        let name = trace["name"].as_str().unwrap();
        let kind = trace["kind"].as_str().unwrap();
        if STALE.contains(&name) || !(kind.starts_with("robust") || kind == "exact") {
            println!("skipped: {} does not hold bit for bit", path.display());
            continue;
        }
        let config = map_of(&trace);
        let records = Records::read(&path, &trace);
        let maps = std::fs::read(path.with_extension("u8")).ok();
        let cells = (config.width * config.height) as usize;
        let mut map = LocalMap::new(&config);
        for (i, step) in items(&trace["steps"]).iter().enumerate() {
            let at = format!("{}, step {i}", path.display());
            let pose = records.three(i, "pose");
            let update = map.update(records.three(i, "world_pose"), pose, &records.scans(i));
            let shift = [0, 1].map(|axis| int(&step["shift"][axis]) as i32);
            assert_eq!(update, shift, "{at}");
            if let Some(maps) = &maps {
                let golden = &maps[i * cells..(i + 1) * cells];
                let difference = first_difference(map.data(), golden, config.width);
                assert!(map.data() == golden, "{at}: {difference}");
            }
            let count = |value: u8| map.data().iter().filter(|cell| **cell == value).count() as i64;
            assert_eq!(count(255), int(&step["free"]), "{at}: free cells");
            assert_eq!(count(0), int(&step["occ"]), "{at}: occupied cells");
            assert_eq!(count(128), int(&step["unknown"]), "{at}: unknown cells");
            assert_eq!(fnv1a64(map.data()), bits(&step["fnv1a64"]), "{at}");
            let golden = records.part(i, &trace["layout_f32"]["origin_after"][0], 2);
            for (origin, golden) in map.origin().iter().zip(golden) {
                let error = (origin - golden).abs() / config.resolution;
                assert!(error <= 1e-4, "{at}: origin {origin}, {golden} recorded");
            }
            // navground's own is off by what its window was moved; ours takes the robot to where it is in the world.
            let ([tx, ty, turn], [x, y, theta]) = (map.transformation(), pose);
            let world = if config.has_odometry {
                records.three(i, "world_pose")
            } else {
                pose
            };
            let (sin, cos) = turn.sin_cos();
            let taken = [tx + cos * x - sin * y, ty + sin * x + cos * y, turn + theta];
            for (taken, world) in taken.iter().zip(world) {
                assert!((taken - world).abs() < 1e-5, "{at}: {taken} instead of {world}");
            }
        }
        compared.push(name.to_owned());
    }
    println!("compared: {}", compared.join(", "));
    assert!(compared.len() >= 9, "{compared:?}");
}

/// Recorded in navground's own simulation, whose walls lie on cell boundaries.
#[test]
fn navground_natural_maps_nearly() {
    let mut compared = 0;
    for (path, trace) in traces() {
        if trace["kind"] != "natural" {
            continue;
        }
        let Ok(maps) = std::fs::read(path.with_extension("u8")) else {
            println!("skipped: {} has no maps beside it", path.display());
            continue;
        };
        let config = map_of(&trace);
        let records = Records::read(&path, &trace);
        let cells = (config.width * config.height) as usize;
        let mut map = LocalMap::new(&config);
        let (mut differing, mut total) = (0, 0);
        for (i, golden) in maps.chunks_exact(cells).enumerate() {
            map.update(
                records.three(i, "world_pose"),
                records.three(i, "pose"),
                &records.scans(i),
            );
            differing += map.data().iter().zip(golden).filter(|(a, b)| a != b).count();
            total += cells;
            map.load(golden);
        }
        let share = differing as f64 / total as f64;
        println!("{}: {differing} of {total} cells differ", path.display());
        assert!(share <= 0.002, "{}: {differing} of {total} cells", path.display());
        compared += 1;
    }
    if compared == 0 {
        println!("skipped: no natural trace is there");
    }
}
