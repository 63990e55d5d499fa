//! Streams that do not arrive whole.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use super::stream::{files, messages};
use crate::support::{code, json, run, stderr};

#[test]
fn damage_is_told_and_skipped_and_the_log_stays_good() {
    let files = files("record_damaged", 24);
    json(&["record", &files.stream, "--out", &files.log, "--json"], 0);
    let good: BTreeMap<(String, u64), Vec<u8>> = messages(Path::new(&files.log))
        .into_iter()
        .map(|(topic, stamp, payload)| ((topic, stamp), payload))
        .collect();
    let mut random = 0x9e37_79b9_7f4a_7c15u64;
    let mut below = |n: usize| {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        (random >> 11) as usize % n
    };
    let damaged_log = format!("{}.damaged", files.log);
    let mut lossy = 0;
    for round in 0..40 {
        let mut wire = files.wire.clone();
        let at = below(wire.len());
        let end = (at + 1 + below(3000)).min(wire.len());
        match round % 5 {
            0 => wire[at] ^= 1 << below(8),
            1 => drop(wire.drain(at..end)),
            2 => wire[at..end].reverse(),
            3 => {
                let part = wire[at..end].to_vec();
                drop(wire.splice(at..at, part));
            }
            _ => wire.truncate(at),
        }
        fs::write(&files.stream, &wire).unwrap();
        let output = run(&["record", &files.stream, "--out", &damaged_log, "--json"]);
        match code(&output) {
            2 => {
                assert!(stderr(&output).contains("no whole tick"), "{}", stderr(&output));
                continue;
            }
            1 => lossy += 1,
            // Only the text between frames can be damaged without a loss.
            code => assert_eq!(code, 0),
        }
        for (topic, stamp, payload) in messages(Path::new(&damaged_log)) {
            if topic == "/tf_static" {
                continue; // written with the first tick there is, at its time
            }
            assert_eq!(
                good.get(&(topic.clone(), stamp)),
                Some(&payload),
                "{topic} at {stamp}, round {round}"
            );
        }
    }
    assert!(lossy > 20, "{lossy} lossy");
}

#[test]
fn problems_are_told_in_plain_sentences() {
    let files = files("record_sentences", 12);
    let mut wire = files.wire.clone();
    let middle = wire.len() / 2;
    wire[middle] ^= 1;
    wire.truncate(wire.len() - 40);
    fs::write(&files.stream, &wire).unwrap();
    let output = run(&["record", &files.stream, "--out", &files.log]);
    assert_eq!(code(&output), 1, "{}", stderr(&output));
    let text = String::from_utf8(output.stdout).unwrap();
    for words in [
        "damaged in 1 place (first at byte",
        "ends in the middle of a tick",
        "never came",
        "skipped",
    ] {
        assert!(text.contains(words), "{text}");
    }
}
