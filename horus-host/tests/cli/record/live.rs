//! Streams that come while they are recorded.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Child, Command, Stdio};

use horus_host::log::{LogEntry, LogReader, ReadEnd};

use super::stream::{files, messages};
use crate::support::{code, json, stderr};

#[test]
fn standard_input_and_a_limit() {
    let files = files("record_stdin", 12);
    let mut child = start(&["record", "-", "--out", &files.log, "--limit", "5", "--json"]);
    let mut input = child.stdin.take().unwrap();
    input.write_all(&files.wire).unwrap(); // less than the pipe and the reader hold
    // Standard input stays open: the limit ends it.
    assert_eq!(finished(child)["ticks"], 5);
    drop(input);
    assert_eq!(
        messages(Path::new(&files.log))
            .iter()
            .filter(|message| message.0 == "/scan")
            .count(),
        5
    );
}

fn start(arguments: &[&str]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_horus-host"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// The JSON of a child that ends well.
fn finished(child: Child) -> serde_json::Value {
    let output = child.wait_with_output().unwrap();
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// Waits until a file is there and has grown longer than so many bytes.
#[cfg(unix)]
fn wait_for(path: &Path, bytes: u64) {
    for _ in 0..600 {
        if fs::metadata(path).is_ok_and(|file| file.len() >= bytes) {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
    panic!("{} does not grow", path.display());
}

#[cfg(unix)]
#[test]
fn a_serial_device_until_ctrl_c() {
    use serialport::{SerialPort, TTYPort};
    let files = files("record_device", 12);
    let (mut target, host) = TTYPort::pair().unwrap();
    let device = host.name().unwrap();
    let child = start(&[
        "record", &device, "--baud", "921600", "--out", &files.log, "--json",
    ]);
    wait_for(Path::new(&files.log), 0); // made once the device is open
    // Zeros, flow control characters and line ends must pass a raw line unchanged.
    let booting = b"\0\x11\x13\r\nbooting\n\x04\x03";
    target.write_all(booting).unwrap();
    for part in files.wire.chunks(512) {
        target.write_all(part).unwrap();
        std::thread::sleep(std::time::Duration::from_millis(1)); // a line has a speed
    }
    wait_for(Path::new(&files.log), 100);
    std::thread::sleep(std::time::Duration::from_millis(500));
    let id = child.id().to_string();
    assert!(
        Command::new("kill")
            .args(["-INT", &id])
            .status()
            .unwrap()
            .success()
    );
    let summary = finished(child);
    assert_eq!(
        (&summary["ticks"], &summary["problems"]),
        (&12.into(), &serde_json::json!({})),
        "{summary}"
    );
    assert_eq!(summary["bytes"], files.wire.len() + booting.len());
    drop((target, host));

    let from_device = messages(Path::new(&files.log));
    json(&["record", &files.stream, "--out", &files.log, "--json"], 0);
    assert!(
        from_device == messages(Path::new(&files.log)),
        "the same log as from a file"
    );
}

#[cfg(unix)]
#[test]
fn a_killed_recording_leaves_what_was_flushed() {
    let files = files("record_killed", 80);
    let mut child = start(&["record", "-", "--out", &files.log]);
    let mut input = child.stdin.take().unwrap();
    input.write_all(&files.wire).unwrap();
    wait_for(Path::new(&files.log), 100);
    std::thread::sleep(std::time::Duration::from_millis(1500));
    child.kill().unwrap();
    child.wait().unwrap();
    let mut reader = LogReader::open(Path::new(&files.log)).unwrap();
    let scans = (&mut reader)
        .filter(|entry| matches!(entry, Ok(LogEntry::Message(message)) if message.topic() == "/scan"))
        .count();
    assert!(scans >= 64, "{scans} scans");
    assert!(matches!(reader.end(), Some(ReadEnd::Truncated { .. })));
}
