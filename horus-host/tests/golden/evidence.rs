//! Evidence grids against an independent oracle of exact fractions and 64-bit floats.

use serde_json::Value;

use crate::evidence_subject::{self as subject, Masses};
use crate::vectors::{f32_of, int, items, vectors};

/// A scan, a lattice and a sensor model as the vectors describe them.
pub struct ScanCase {
    pub rows: u32,
    pub cols: u32,
    pub cell_size: f32,
    pub lattice_pose: [f32; 3],
    pub sensor: [f32; 3],
    pub angles: Vec<f32>,
    pub ranges: Vec<f32>,
    pub m_free: Masses,
    pub m_occ: Masses,
    pub wall_thickness: f32,
    pub invalid_range: f32,
    pub out_of_range: f32,
    pub max_free_range: Option<f32>,
}

/// The part of a lattice that resampling looks at.
#[derive(Clone, Copy)]
pub struct GridCase {
    pub rows: u32,
    pub cols: u32,
    pub cell_size: f32,
    pub pose: [f32; 3],
}

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let numbers: Vec<_> = items(value)
        .iter()
        .map(|v| v.as_f64().expect("a number"))
        .collect();
    numbers.try_into().expect("so many numbers")
}

fn grid_case(value: &Value) -> GridCase {
    GridCase {
        rows: int(&value["rows"]) as u32,
        cols: int(&value["cols"]) as u32,
        cell_size: f32_of(&value["cell"]),
        pose: numbers(&value["pose"]).map(|v| v as f32),
    }
}

/// Fuses in every way of the subject and compares with the expected masses.
fn check(rule: &str, one: Masses, two: Masses, expected: Option<Masses>, id: &str) -> usize {
    let mut compared = 0;
    for (way, tolerance, got) in subject::fuse(rule, one, two) {
        compared += 1;
        let Some(expected) = expected else {
            assert!(
                got.is_none_or(|got| got == [0.0, 0.0, 1.0]),
                "{id}, {rule}, {way}: undefined, not {got:?}"
            );
            continue;
        };
        let got = got.unwrap_or_else(|| panic!("{id}, {rule}, {way}: undefined"));
        for (got, expected) in got.into_iter().zip(expected) {
            assert!(
                (got - expected).abs() <= tolerance,
                "{id}, {rule}, {way}: {got} is not {expected}"
            );
        }
    }
    compared
}

#[test]
fn published_examples() {
    let mut compared = 0;
    for cases in vectors("evidence", "rules_literature.json") {
        for case in items(&cases) {
            let rule = case["rule"].as_str().expect("a rule");
            let fraction = |v: &Value| {
                let text = v.as_str().expect("a fraction");
                let (n, d) = text.split_once('/').unwrap_or((text, "1"));
                n.parse::<f64>().unwrap() / d.parse::<f64>().unwrap()
            };
            let sources: Vec<Masses> = items(&case["m"])
                .iter()
                .map(|m| [0, 1, 2].map(|i| fraction(&m[i])))
                .collect();
            let id = case["id"].as_str().unwrap_or_default();
            if rule == "conjunctive" {
                println!("skipped: {id}: the conjunctive rule alone is no operator");
                continue;
            }
            let expected = numbers(&case["f64"]);
            // Three sources are fused from left to right.
            let (last, first) = sources.split_last().expect("two sources or more");
            let state = first[1..].iter().fold(first[0], |state, next| {
                let (_, _, fused) = subject::fuse(rule, state, *next).swap_remove(0);
                fused.expect("a defined fusion")
            });
            compared += check(rule, state, *last, Some(expected), id);
        }
    }
    assert!(compared > 10, "{compared}");
}

#[test]
fn limit_cases_of_the_rules() {
    let mut compared = 0;
    for cases in vectors("evidence", "rules_edge.json") {
        for case in items(&cases) {
            let (one, two) = (numbers(&case["m1"]), numbers(&case["m2"]));
            for rule in ["pcr6", "dempster_shafer", "josang_average", "josang_cumulative"] {
                let expected = &case["rules"][rule];
                let expected = (!expected.is_null()).then(|| numbers(&expected["f64"]));
                let id = case["id"].as_str().unwrap_or_default();
                compared += check(rule, one, two, expected, id);
                compared += check(rule, two, one, expected, id);
            }
        }
    }
    assert!(compared > 100, "{compared}");
}

fn pair(value: &Value) -> [u32; 2] {
    [0, 1].map(|i| int(&value[i]) as u32)
}

#[test]
fn fixed_point_to_the_last_step() {
    if !subject::HAS_INTEGERS {
        return;
    }
    for file in vectors("evidence", "fixed_point.json") {
        for case in items(&file["cases"]) {
            let q = int(&case["Q"]) as u32;
            let (a, b) = (pair(&case["a"]), pair(&case["b"]));
            for (rule, column) in [("pcr6", "pcr6_nearest"), ("dempster_shafer", "ds_nearest")] {
                // A total conflict, which Dempster's rule does not define, has no column.
                let expected = (!case[column].is_null()).then(|| pair(&case[column]));
                if let Some(got) = subject::fuse_steps(q, rule, a, b) {
                    assert_eq!(got, expected.unwrap_or([0, 0]), "{rule}, {case}");
                }
            }
        }
        for trap in items(&file["negative_u_traps"]) {
            if trap["a"].is_array() {
                let q = int(&trap["Q"]) as u32;
                let got = subject::fuse_steps(q, "dempster_shafer", pair(&trap["a"]), pair(&trap["b"]));
                assert!(
                    got.is_none_or(|got| got == pair(&trap["right"])),
                    "{trap}: {got:?}"
                );
            } else {
                let right = pair(&trap["right"]);
                assert_eq!(
                    subject::steps(int(&trap["Q"]) as u32, numbers(&trap["m"])),
                    right,
                    "{trap}"
                );
            }
        }
        for q in [255, 65_535] {
            let name = format!("pcr6_nearest_Q{q}_states189_pairs35721");
            let expected = file["crc32"][&name].as_u64().expect("a checksum");
            assert_eq!(u64::from(checksum(q)), expected, "{name}");
        }
    }
}

/// CRC-32 over the results of all pairs of the states that the vectors name.
fn checksum(q: u32) -> u32 {
    let mut values: Vec<u32> = (0..=16)
        .map(|i| {
            let (whole, rest) = (i * q / 16, i * q % 16);
            // Halves to even.
            whole + u32::from(rest > 8 || (rest == 8 && whole % 2 == 1))
        })
        .chain([1, q - 1])
        .collect();
    values.sort_unstable();
    values.dedup();
    let pairs = values.iter().flat_map(|&f| values.iter().map(move |&o| [f, o]));
    let states: Vec<_> = pairs.filter(|[f, o]| f + o <= q).collect();
    assert_eq!(states.len(), 189);
    let mut crc = crc32fast::Hasher::new();
    for a in &states {
        for b in &states {
            let fused = subject::fuse_steps(q, "pcr6", *a, *b).expect("PCR6 takes all");
            fused.iter().for_each(|v| crc.update(&(*v as u16).to_le_bytes()));
        }
    }
    crc.finalize()
}

#[test]
fn scans_become_classes() {
    for cases in vectors("evidence", "ism.json") {
        for case in items(&cases) {
            let params = &case["params"];
            let angle = |i: usize| {
                let step = i as f64 * case["angle_step"].as_f64().unwrap();
                (case["angle0"].as_f64().unwrap() + step) as f32
            };
            let ranges = items(&case["ranges"])
                .iter()
                .enumerate()
                .map(|(i, range)| match range {
                    Value::Null if i % 13 == 5 => f32::NAN,
                    Value::Null => f32::INFINITY,
                    range => f32_of(range),
                });
            let GridCase {
                rows,
                cols,
                cell_size,
                pose,
            } = grid_case(&case["lattice"]);
            let ranges: Vec<_> = ranges.collect();
            let scan = ScanCase {
                rows,
                cols,
                cell_size,
                lattice_pose: pose,
                sensor: numbers(&case["sensor"]).map(|v| v as f32),
                angles: (0..ranges.len()).map(angle).collect(),
                ranges,
                m_free: numbers(&params["m_free"]),
                m_occ: numbers(&params["m_occ"]),
                wall_thickness: f32_of(&params["wall_thickness"]),
                invalid_range: f32_of(&params["invalid_range"]),
                out_of_range: f32_of(&params["out_of_range"]),
                max_free_range: params["max_free_range"].as_f64().map(|v| v as f32),
            };
            // The vectors run through the columns of a row first.
            let text = |key: &str| case[key].as_str().expect("a string").as_bytes();
            let at = |row: u32, col: u32| (row * cols + col) as usize;
            for (way, classes) in subject::classify(&scan) {
                for row in 0..rows {
                    for col in 0..cols {
                        let got = classes[(col * rows + row) as usize];
                        let golden = text("class")[at(row, col)] as char;
                        let tie = text("tie")[at(row, col)] == b'1';
                        assert!(
                            tie || got == golden,
                            "{}, {way}: ({row}, {col}) is {got}, not {golden}",
                            case["id"]
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn grids_are_resampled() {
    for file in vectors("evidence", "resample.json") {
        let src = grid_case(&file["src"]);
        let masses = |grid: GridCase, value: &Value| -> Vec<Masses> {
            let cells = items(value);
            let cell = |row: u32, col: u32| {
                let first = 3 * (row * grid.cols + col) as usize;
                [0, 1, 2].map(|i| cells[first + i].as_f64().expect("a mass"))
            };
            (0..grid.cols)
                .flat_map(|col| (0..grid.rows).map(move |row| cell(row, col)))
                .collect()
        };
        let cells = masses(src, &file["grid"]);
        for case in items(&file["cases"]) {
            let dst = grid_case(&case["dst"]);
            let expected = masses(dst, &case["bilinear"]);
            let pose = numbers(&case["dst_to_src"]);
            for (way, tolerance, got) in subject::resample(&cells, src, dst, pose) {
                for (i, (got, expected)) in got.iter().zip(&expected).enumerate() {
                    for (got, expected) in got.iter().zip(expected) {
                        assert!(
                            (got - expected).abs() <= tolerance,
                            "{}, {way}: cell {i} is {got}, not {expected}",
                            case["id"]
                        );
                    }
                }
            }
        }
    }
}
