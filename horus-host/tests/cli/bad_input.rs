//! What cannot work ends with exit code 2 and one sentence.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::support::{S, TestLog, code, refused, run, scan_at, scratch, stderr};
use horus_host::log::msg::{LaserScan, Message};

fn good_log(dir: &Path) -> PathBuf {
    let path = dir.join("good.mcap");
    let mut log = TestLog::with_mount(&path);
    log.robot(S);
    log.robot(2 * S);
    log.scan(&scan_at(S));
    log.scan(&scan_at(2 * S));
    log.finish();
    path
}

#[test]
fn files_that_are_no_logs() {
    let dir = scratch("bad_files");
    let file = |name: &str, bytes: &[u8]| {
        let path = dir.join(name);
        fs::write(&path, bytes).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let missing = dir.join("missing.mcap");
    refused(
        &["replay", missing.to_str().unwrap()],
        &["missing.mcap", "cannot open"],
    );
    refused(
        &["replay", &file("empty.mcap", b""), "--json"],
        &["empty.mcap", "the file is empty"],
    );
    refused(
        &["replay", &file("text.mcap", b"hello, this is no log")],
        &["text.mcap", "not an MCAP file"],
    );
    refused(
        &["replay", dir.to_str().unwrap()],
        &["bad_files", "cannot read the log"],
    );

    let bytes = fs::read(good_log(&dir)).unwrap();
    // The first 800 bytes are header and chunk; what follows the data is an index nobody needs here.
    for at in (60..800).step_by(37) {
        let mut flipped = bytes.clone();
        flipped[at] ^= 0x10;
        refused(
            &["replay", &file("flipped.mcap", &flipped)],
            &["flipped.mcap", "damaged at byte"],
        );
    }
    refused(
        &["replay", &file("cut.mcap", &bytes[..60])],
        &["cut.mcap", "truncated at byte"],
    );
}

#[test]
fn messages_in_a_newer_encoding() {
    let path = scratch("bad_xcdr2").join("xcdr2.mcap");
    let mut writer = mcap::Writer::new(fs::File::create(&path).unwrap()).unwrap();
    let schema = writer
        .add_schema(LaserScan::TYPE, "ros2msg", LaserScan::definition().as_bytes())
        .unwrap();
    let channel = writer
        .add_channel(schema, "/scan", "cdr", &BTreeMap::new())
        .unwrap();
    let mut payload = scan_at(S).to_payload().unwrap();
    payload[1] = 7;
    let header = mcap::records::MessageHeader {
        channel_id: channel,
        sequence: 0,
        log_time: S,
        publish_time: S,
    };
    writer.write_to_known_channel(&header, &payload).unwrap();
    writer.finish().unwrap();
    refused(
        &["replay", path.to_str().unwrap()],
        &["xcdr2.mcap", "/scan", "XCDR2"],
    );
}

#[test]
fn output_directories_that_take_no_files() {
    let dir = scratch("bad_out");
    let log = good_log(&dir);
    let log = log.to_str().unwrap();
    for out in [log.to_owned(), format!("{log}/below")] {
        refused(
            &["replay", log, "--out", &out],
            &["output directory", "good.mcap"],
        );
        refused(&["demo", "--out", &out], &["output directory", "good.mcap"]);
    }
}

#[test]
fn maps_that_cannot_be() {
    let dir = scratch("bad_maps");
    let log = good_log(&dir);
    let log = log.to_str().unwrap();
    let out = dir.join("out");
    let out = out.to_str().unwrap();
    for (options, words) in [
        (&["--width", "0"][..], "a map of 0 x 200 cells"),
        (
            &["--width", "1000000", "--height", "1000000"],
            "a map of 1000000 x 1000000 cells",
        ),
        (&["--resolution", "NaN"], "resolution NaN m"),
        (&["--resolution", "0"], "resolution 0 m"),
        (&["--resolution", "-0.05"], "resolution -0.05 m"),
        (&["--radius", "-1"], "inflation_radius"),
        (&["--radius", "inf"], "inflation_radius"),
        (&["--scaling", "NaN"], "cost_scaling_factor"),
        (
            &["--inscribed", "-1", "--decay", "exponential"],
            "inscribed_radius",
        ),
        (&["--lethal-cost", "255"], "lethal_cost"),
        (&["--lethal-threshold", "-3"], "lethal_threshold"),
        (
            &["--radius", "20", "--decay", "exponential", "--scaling", "0.1"],
            "beyond 255 cells",
        ),
    ] {
        refused(&[&["replay", log], options].concat(), &[words]);
        refused(&[&["demo", "--out", out], options].concat(), &[words]);
    }
    for seconds in ["0", "-1", "NaN", "1e9"] {
        refused(
            &["demo", "--out", out, "--seconds", seconds],
            &["0.1 to 86400 seconds"],
        );
    }
    refused(&["replay", log, "--max-gap", "-1"], &["longest gap"]);
}

#[test]
fn usage_errors_end_with_code_2_and_help_with_0() {
    for arguments in [
        &[][..],
        &["fly"],
        &["replay"],
        &["replay", "x.mcap", "--width", "wide"],
        &["replay", "x.mcap", "--width", "5000000000"],
        &["replay", "x.mcap", "--width", "-5"],
        &["replay", "x.mcap", "--every", "0"],
        &["replay", "x.mcap", "--decay", "linear"],
        &["demo", "--unheard-of"],
    ] {
        let output = run(arguments);
        assert_eq!(code(&output), 2, "{arguments:?}");
        assert!(
            output.stdout.is_empty() && !output.stderr.is_empty(),
            "{arguments:?}"
        );
    }
    for arguments in [&["--help"][..], &["-h"], &["demo", "--help"], &["--version"]] {
        let output = run(arguments);
        assert_eq!(
            (code(&output), stderr(&output).as_str()),
            (0, ""),
            "{arguments:?}"
        );
    }
    let help = String::from_utf8(run(&["--help"]).stdout).unwrap();
    assert!(help.contains("Examples:\n  horus-host demo"), "{help}");
}
