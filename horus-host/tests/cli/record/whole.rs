//! Streams that arrive whole.

use std::collections::BTreeSet;
use std::path::Path;

use horus_host::log::{LogEntry, LogReader};

use super::stream::{SIZE, files, messages};
use crate::support::json;

#[test]
fn the_log_of_the_target_is_the_log_of_the_host() {
    let files = files("record_whole", 20);
    let summary = json(&["record", &files.stream, "--out", &files.log, "--json"], 0);
    assert_eq!(
        (&summary["ticks"], &summary["skipped_ticks"]),
        (&20.into(), &0.into())
    );
    assert_eq!(summary["bytes"], files.wire.len());
    assert_eq!(summary["bytes_outside_frames"], 20 * 16, "the text");
    assert_eq!(summary["problems"], serde_json::json!({}));

    let topics: BTreeSet<String> = messages(Path::new(&files.log))
        .into_iter()
        .map(|message| message.0)
        .collect();
    let expected = [
        "/costmap",
        "/costmap_raw",
        "/local_map",
        "/scan",
        "/tf",
        "/tf_static",
    ];
    assert_eq!(topics.iter().map(String::as_str).collect::<Vec<_>>(), expected);
    let mut reader = LogReader::open(Path::new(&files.log)).unwrap();
    let Some(Ok(LogEntry::Metadata { name, values })) = reader.next() else {
        panic!("metadata comes first");
    };
    let value = |key: &str| values[key].as_str();
    assert_eq!(
        (name.as_str(), value("side"), value("width")),
        ("horus", "target", "100")
    );
    assert_eq!((value("decay"), value("lethal_cost")), ("polynomial", "253"));

    // The host's own run over the target's scans and poses.
    json(
        &[&["replay", &files.log, "--out", &files.out, "--json"], &SIZE[..]].concat(),
        0,
    );
    for side in ["core", "std"] {
        let host = format!("{}/{side}.mcap", files.out);
        let comparison = json(&["compare", &files.log, &host, "--json"], 0);
        assert_eq!(comparison["equal"], true, "{comparison}");
        assert_eq!(comparison["topics"].as_array().unwrap().len(), 6);
    }
    // Other parameters on the host are noticed.
    json(
        &[
            &[
                "replay",
                &files.log,
                "--out",
                &files.out,
                "--scaling",
                "5",
                "--json",
            ],
            &SIZE[..],
        ]
        .concat(),
        0,
    );
    json(
        &[
            "compare",
            &files.log,
            &format!("{}/core.mcap", files.out),
            "--json",
        ],
        1,
    );
}

#[test]
fn a_replay_of_a_replay_writes_the_same_log() {
    let files = files("record_again", 6);
    json(&["record", &files.stream, "--out", &files.log, "--json"], 0);
    json(
        &[&["replay", &files.log, "--out", &files.out, "--json"], &SIZE[..]].concat(),
        0,
    );
    let (once, twice) = (format!("{}/core.mcap", files.out), format!("{}2", files.out));
    json(
        &[&["replay", &once, "--out", &twice, "--json"], &SIZE[..]].concat(),
        0,
    );
    json(&["compare", &once, &format!("{twice}/core.mcap"), "--json"], 0);
}
