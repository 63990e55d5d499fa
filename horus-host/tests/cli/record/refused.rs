//! What cannot be recorded.

use std::fs;
use std::io::Read;
use std::path::Path;

use super::stream::files;
use crate::support::{code, refused, run, scratch};

#[test]
fn what_cannot_be_recorded() {
    let files = files("record_bad", 2);
    let dir = scratch("record_bad_files");
    let path = |name: &str| dir.join(name).to_str().unwrap().to_owned();
    let (log, text) = (path("log.mcap"), path("text.txt"));
    fs::write(&text, "no frames here\n").unwrap();
    refused(
        &["record", &path("missing.bin"), "--out", &log],
        &["cannot open", "missing.bin"],
    );
    refused(
        &["record", &text, "--out", &log],
        &["text.txt", "no whole tick in 15 bytes and 0 frames"],
    );
    assert!(!Path::new(&log).exists(), "nothing is left");
    refused(
        &["record", dir.to_str().unwrap(), "--out", &log],
        &["record_bad_files"],
    );
    assert!(!Path::new(&log).exists(), "nothing is left");
    refused(
        &["record", "/dev/null", "--out", &log],
        &["/dev/null", "no whole tick in 0 bytes"],
    );
    refused(
        &["record", &files.stream, "--out", &files.stream],
        &["stream.bin", "overwritten"],
    );
    refused(
        &["record", &files.stream, "--out", &path("no/such/dir.mcap")],
        &["cannot write the log", "dir.mcap"],
    );
    refused(
        &["record", &files.stream, "--out", dir.to_str().unwrap()],
        &["cannot write the log"],
    );
    // The stream after its first key tick: nothing to start from, and an older log stays.
    fs::write(&log, "an older log").unwrap();
    let late = path("late.bin");
    let mut wire = Vec::new();
    fs::File::open(&files.stream)
        .unwrap()
        .read_to_end(&mut wire)
        .unwrap();
    fs::write(&late, &wire[wire.len() - 500..]).unwrap();
    refused(
        &["record", &late, "--out", &log],
        &["late.bin", "the beginning of the stream is missing"],
    );
    assert_eq!(fs::read_to_string(&log).unwrap(), "an older log");
    for arguments in [
        &["record"][..],
        &["record", "x"],
        &["record", "x", "--out", "y", "--baud", "0"],
    ] {
        assert_eq!(code(&run(arguments)), 2, "{arguments:?}");
    }
}
