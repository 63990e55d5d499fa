//! Running the built command line, and writing small logs for it.
#![allow(dead_code)] // every test file uses its own part of this

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use horus_host::log::LogWriter;
use horus_host::log::msg::{Header, LaserScan, TFMessage, Time, Transform, TransformStamped};
use serde_json::Value;

/// One second in nanoseconds.
pub const S: u64 = 1_000_000_000;

/// An empty directory of a test's own.
pub fn scratch(test: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).unwrap();
    path
}

/// Runs `horus-host`.
pub fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_horus-host"))
        .args(arguments)
        .output()
        .unwrap()
}

pub fn code(output: &Output) -> i32 {
    output.status.code().expect("ended by itself")
}

pub fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// The one JSON object a run printed, which ended with `expected`.
pub fn json(arguments: &[&str], expected: i32) -> Value {
    let output = run(arguments);
    assert_eq!(code(&output), expected, "{arguments:?}: {}", stderr(&output));
    assert_eq!(stderr(&output), "", "nothing to say and no terminal");
    let value: Value = serde_json::from_slice(&output.stdout).expect("standard output is JSON");
    assert!(value.is_object());
    value
}

/// Runs something that cannot work: exit code 2, nothing on standard output, and on standard
/// error one sentence with `words` in it.
pub fn refused(arguments: &[&str], words: &[&str]) {
    let output = run(arguments);
    let text = stderr(&output);
    assert_eq!(code(&output), 2, "{arguments:?}: {text}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    assert_eq!(text.trim_end().lines().count(), 1, "{text}");
    assert!(text.starts_with("horus-host: "), "{text}");
    for word in words {
        assert!(text.contains(word), "{text:?} does not say {word:?}");
    }
}

/// Writes a log with whatever a test needs.
pub struct TestLog {
    writer: LogWriter<std::io::BufWriter<fs::File>>,
}

impl TestLog {
    pub fn create(path: &Path) -> Self {
        Self {
            writer: LogWriter::create(path).unwrap(),
        }
    }

    /// A log with a laser 0.1 m ahead of the robot.
    pub fn with_mount(path: &Path) -> Self {
        let mut log = Self::create(path);
        log.tf(
            "/tf_static",
            0,
            "base_link",
            "laser",
            Transform::planar(0.1, 0.0, 0.0),
        );
        log
    }

    pub fn tf(&mut self, topic: &str, stamp_ns: u64, parent: &str, child: &str, transform: Transform) {
        let message = TFMessage {
            transforms: vec![TransformStamped {
                header: Header::new(stamp_ns, parent),
                child_frame_id: child.to_owned(),
                transform,
            }],
        };
        self.writer.write(topic, stamp_ns, &message).unwrap();
    }

    /// The robot at x = 0.5 m per second.
    pub fn robot(&mut self, stamp_ns: u64) {
        let x = 0.5 * stamp_ns as f64 / S as f64;
        self.tf(
            "/tf",
            stamp_ns,
            "odom",
            "base_link",
            Transform::planar(x, 0.2, 0.1 * x),
        );
    }

    pub fn scan(&mut self, scan: &LaserScan) {
        self.scan_on("/scan", scan);
    }

    pub fn scan_on(&mut self, topic: &str, scan: &LaserScan) {
        let log_time = scan.header.stamp.to_ns().unwrap_or(0);
        self.writer.write(topic, log_time, scan).unwrap();
    }

    pub fn finish(self) {
        self.writer.finish().unwrap();
    }
}

/// A scan of 60 beams: walls, no returns, and all kinds of invalid ranges.
pub fn scan_at(stamp_ns: u64) -> LaserScan {
    let range = |i: u64| match (i + stamp_ns / 100_000_000) % 13 {
        0 => f32::INFINITY,
        1 => f32::NAN,
        2 => f32::NEG_INFINITY,
        3 => 0.01,
        n => 0.2 * n as f32,
    };
    LaserScan {
        header: Header {
            stamp: Time::from_ns(stamp_ns),
            frame_id: "laser".to_owned(),
        },
        angle_min: -1.5,
        angle_max: 1.45,
        angle_increment: 0.05,
        range_min: 0.05,
        range_max: 2.3,
        ranges: (0..60).map(range).collect(),
        ..LaserScan::default()
    }
}

/// A PNG file that was read back.
pub struct Painted {
    pub width: u32,
    pub height: u32,
    /// Red, green, blue and alpha of every pixel, the top row first.
    pub pixels: Vec<[u8; 4]>,
}

impl Painted {
    pub fn read(path: impl AsRef<Path>) -> Self {
        let file = std::io::BufReader::new(fs::File::open(path).unwrap());
        let mut decoder = png::Decoder::new(file);
        decoder.set_transformations(png::Transformations::EXPAND);
        let mut reader = decoder.read_info().unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut bytes).unwrap();
        let pixels = match info.color_type {
            png::ColorType::Rgb => bytes
                .as_chunks()
                .0
                .iter()
                .map(|&[r, g, b]| [r, g, b, 255])
                .collect(),
            png::ColorType::Rgba => bytes.as_chunks().0.to_vec(),
            other => panic!("{other:?}"),
        };
        Self {
            width: info.width,
            height: info.height,
            pixels,
        }
    }

    pub fn size(&self) -> (u32, u32) {
        (self.width, self.height)
    }

    /// Red, green and blue at a place, row 0 at the top.
    pub fn at(&self, x: u32, y: u32) -> [u8; 3] {
        let [r, g, b, _] = self.pixels[(y * self.width + x) as usize];
        [r, g, b]
    }
}
