//! `horus-host replay --map evidence`: both sides, the logs they write, and refusals.

use std::path::Path;

use crate::support::{self, S, TestLog, json, refused, scan_at, scratch};
use horus_host::log::msg::Grid;
use horus_host::log::{LogEntry, LogReader};

/// Every grid on a topic of a log.
fn grids(path: &Path, topic: &str) -> Vec<Grid> {
    let entries = LogReader::open(path).unwrap().map(Result::unwrap);
    let on_topic = entries.filter_map(|entry| match entry {
        LogEntry::Message(message) if message.topic() == topic => Some(message.decode().unwrap()),
        _ => None,
    });
    on_topic.collect()
}

fn float(bytes: &[u8]) -> f32 {
    f32::from_le_bytes(bytes[..4].try_into().unwrap())
}

#[test]
fn evidence_is_replayed_compared_and_logged() {
    let dir = scratch("evidence_replay");
    let (log, out) = (dir.join("in.mcap"), dir.join("out"));
    let mut writer = TestLog::with_mount(&log);
    for i in 0..6 {
        writer.robot(S + i * S / 10);
        writer.scan(&scan_at(S + i * S / 10));
    }
    writer.finish();
    let (log, out) = (log.to_str().unwrap(), out.to_str().unwrap());
    for fusion in ["pcr6", "dempster_shafer", "josang_average", "josang_cumulative"] {
        let size = ["--width", "60", "--height", "50", "--json", "--out", out];
        let arguments = [
            &["replay", log, "--map", "evidence", "--fusion", fusion],
            &size[..],
        ]
        .concat();
        let summary = json(&arguments, 0);
        assert_eq!(summary["fusion"], fusion);
        assert_eq!(
            (&summary["scans"], &summary["mismatches"]),
            (&6.into(), &0.into()),
            "{summary}"
        );
        assert!(
            summary["largest_difference"].as_f64().unwrap() < 1e-3,
            "{summary}"
        );
        for side in ["core.mcap", "std.mcap"] {
            let path = Path::new(out).join(side);
            let (evidence, distance) = (grids(&path, "/evidence"), grids(&path, "/distance"));
            assert_eq!((evidence.len(), distance.len()), (6, 6));
            let names: Vec<_> = evidence[5].fields.iter().map(|field| &field.name[..]).collect();
            assert_eq!(
                names,
                ["free", "occupied", "unknown", "red", "green", "blue", "alpha"]
            );
            assert_eq!(
                (evidence[5].column_count, evidence[5].data.len()),
                (60, 16 * 60 * 50)
            );
            for cell in evidence[5].data.chunks(16) {
                let sum = float(cell) + float(&cell[4..]) + float(&cell[8..]);
                assert!((sum - 1.0).abs() < 1e-5 && cell[15] == 255, "{cell:?}");
            }
            assert!(evidence[5].data.chunks(16).any(|cell| float(cell) > 0.2));
            assert!(
                distance[5]
                    .data
                    .chunks(4)
                    .all(|cell| (0.0..=2.0 + 1e-3).contains(&float(cell)))
            );
        }
        let [core, std, diff] = ["core.mcap", "std.mcap", "diff.mcap"].map(|name| format!("{out}/{name}"));
        let compared = support::run(&["compare", &core, &std, "--diff", &diff]);
        assert_eq!(
            support::code(&compared),
            1,
            "masses of f64 are not those of 16 bits"
        );
        let tolerant = ["--tolerance", "/evidence=0.001", "--tolerance", "/distance=0.001"];
        let compared = support::run(&[&["compare", &core, &std], &tolerant[..]].concat());
        assert_eq!(support::code(&compared), 0, "colours follow the masses");
        let differences = grids(Path::new(&diff), "/difference/evidence");
        assert!(!differences.is_empty());
        for cell in differences.iter().flat_map(|grid| grid.data.chunks(8)) {
            let [free, occupied] = [float(cell), float(&cell[4..])];
            assert!(free.abs() < 1e-3 && occupied.abs() < 1e-3, "{free} {occupied}");
        }
        for picture in ["evidence.png", "binary.png", "distance.png"] {
            assert!(Path::new(out).join(picture).is_file(), "{picture}");
        }
    }
    refused(&["replay", log, "--fusion", "pcr6"], &["--map evidence"]);
    refused(
        &[
            "replay", log, "--map", "evidence", "--width", "70000", "--height", "2",
        ],
        &["70000", "32767"],
    );
    let unknown = ["replay", log, "--map", "evidence", "--fusion", "yager"];
    let output = support::run(&unknown);
    assert_eq!(support::code(&output), 2);
    assert!(support::stderr(&output).contains("josang_average"));
    refused(
        &["replay", log, "--map", "evidence", "--width", "0"],
        &["0 x 200"],
    );
}
