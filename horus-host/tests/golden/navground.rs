//! navground: how the window moves.

use std::path::Path;

use serde_json::Value;

use crate::subject::Grid;
use crate::vectors::*;

/// The poses (x, y in metres, theta in radians) a trace was driven with: in the JSON, or in the `.f32` beside it.
fn poses(path: &Path, trace: &Value) -> Vec<[f64; 3]> {
    if let Some(poses) = trace["poses"].as_array() {
        let pose = |p: &Value| [0, 1, 2].map(|i| p[i].as_f64().unwrap());
        return poses.iter().map(pose).collect();
    }
    let records = std::fs::read(path.with_extension("f32")).expect("the trace's .f32");
    let step = int(&trace["f32_per_step"]) as usize * 4;
    let at = int(&trace["layout_f32"]["pose"][0]) as usize * 4;
    let number = |record: &[u8], i: usize| {
        let bytes = &record[at + 4 * i..at + 4 * i + 4];
        f64::from(f32::from_le_bytes(bytes.try_into().unwrap()))
    };
    let records = records.chunks_exact(step);
    records.map(|r| [0, 1, 2].map(|i| number(r, i))).collect()
}

#[test]
fn navground_window_shifts() {
    let mut compared = 0;
    for folder in folders("navground") {
        for entry in std::fs::read_dir(folder).expect("a readable folder") {
            let path = entry.expect("a readable folder").path();
            if path.extension().is_none_or(|e| e != "json") {
                continue;
            }
            let trace = read(&path);
            let kind = trace["kind"].as_str().unwrap_or_default();
            if !(kind.starts_with("robust") || kind == "exact") {
                println!("skipped: {} holds no robust or exact shifts", path.display());
                continue;
            }
            let (width, height) = size_of(&trace);
            let resolution = f32_of(&trace["resolution"]);
            let mut grid = Grid::new(width, height, resolution, [0.0; 3]).unwrap();
            let steps = items(&trace["steps"]);
            let poses = poses(&path, &trace);
            assert_eq!(poses.len(), steps.len());
            for (i, (pose, step)) in poses.into_iter().zip(steps).enumerate() {
                let golden = [0, 1].map(|axis| int(&step["shift"][axis]) as i32);
                let shift = grid.recenter(pose).unwrap();
                assert_eq!(shift, golden, "{}, step {i}", path.display());
                compared += 1;
            }
        }
    }
    assert!(compared > 0);
}
