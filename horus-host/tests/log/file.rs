//! Writing and reading whole logs.
use std::io::{self, Write};

use crate::samples::*;
use horus_host::log::{
    LogEntry, LogError, LogMessage, LogReader, LogWriter, RECORD_LIMIT, ReadEnd,
    cdr::CdrError,
    msg::{Costmap, Grid, Header, LaserScan, Message, OccupancyGrid, Path, TFMessage},
};

fn messages(entries: Vec<LogEntry>) -> Vec<LogMessage> {
    let message = |entry| match entry {
        LogEntry::Message(message) => Some(message),
        LogEntry::Metadata { .. } => None,
    };
    entries.into_iter().filter_map(message).collect()
}

#[test]
fn every_message_type_survives_the_log() {
    let (entries, end) = read(&sample(3));
    assert_eq!(end.unwrap(), ReadEnd::Complete);
    let expected = LogEntry::Metadata {
        name: "horus".to_owned(),
        values: metadata(),
    };
    assert_eq!(entries[0], expected);
    let messages = messages(entries);
    assert_eq!(messages.len(), 3 * TOPICS);
    for (index, message) in messages.iter().enumerate() {
        let tick = (index / TOPICS) as u64;
        assert_eq!(message.log_time_ns, stamp(tick));
        assert_eq!(message.publish_time_ns, stamp(tick));
        assert_eq!(message.channel.encoding, "cdr");
        match message.topic() {
            "/tf" | "/tf_static" => {
                assert_eq!(message.decode::<TFMessage>().unwrap(), transforms(tick));
            }
            "/scan" => assert_eq!(message.decode::<LaserScan>().unwrap(), scan(tick)),
            "/map" => assert_eq!(message.decode::<OccupancyGrid>().unwrap(), occupancy(tick)),
            "/costmap_raw" => assert_eq!(message.decode::<Costmap>().unwrap(), costmap(tick)),
            "/evidence" => assert_eq!(message.decode::<Grid>().unwrap(), evidence(tick)),
            "/plan" => assert_eq!(message.decode::<Path>().unwrap(), path(tick)),
            other => panic!("unexpected topic {other}"),
        }
    }
}

#[test]
fn the_same_calls_give_the_same_bytes() {
    assert_eq!(sample(20), sample(20));
}

#[test]
fn what_was_flushed_survives_a_crash() {
    /// Keeps what was written to it and flushed, as a file does when its process dies.
    #[derive(Default)]
    struct Crashing {
        pending: Vec<u8>,
        flushed: Vec<u8>,
    }
    impl Write for &mut Crashing {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.pending.extend_from_slice(bytes);
            Ok(bytes.len())
        }
        fn flush(&mut self) -> io::Result<()> {
            self.flushed.append(&mut self.pending);
            Ok(())
        }
    }
    let mut sink = Crashing::default();
    let mut log = LogWriter::new(&mut sink).unwrap();
    log.set_flush_interval(10);
    for tick in 0..4 {
        log.write("/scan", stamp(tick), &scan(tick)).unwrap();
    }
    log.flush().unwrap();
    for tick in 4..25 {
        log.write("/scan", stamp(tick), &scan(tick)).unwrap();
    }
    // A crash runs no destructor.
    std::mem::forget(log);
    let (entries, end) = read(&sink.flushed);
    // 4 by hand, then twice 10 by the interval; the 25th was never flushed.
    assert_eq!(messages(entries).len(), 24);
    let offset = sink.flushed.len() as u64;
    assert_eq!(end.unwrap(), ReadEnd::Truncated { offset });
}

#[test]
fn a_log_cut_anywhere_reads_up_to_the_last_whole_record() {
    let bytes = sample(3);
    let whole = messages(read(&bytes).0);
    let mut counts = Vec::new();
    for len in 0..bytes.len() {
        let (entries, end) = read(&bytes[..len]);
        match end {
            Err(LogError::Empty) => assert_eq!(len, 0),
            Err(LogError::NotMcap) => assert!((1..8).contains(&len)),
            Ok(ReadEnd::Truncated { offset }) => assert!((8..=len as u64).contains(&offset)),
            other => panic!("cut at {len}: {other:?}"),
        }
        let found = messages(entries);
        assert_eq!(found, whole[..found.len()], "cut at {len}");
        counts.push(found.len());
    }
    assert!(counts.is_sorted());
    counts.dedup();
    // One chunk per tick.
    assert_eq!(counts, [0, TOPICS, 2 * TOPICS, 3 * TOPICS]);
}

#[test]
fn a_chunk_whose_length_was_never_filled_in_is_a_truncation() {
    // Writers that seek leave this where they crash inside a chunk.
    let mut log = LogWriter::new(Vec::new()).unwrap();
    write_tick(&mut log, 0).unwrap();
    let finished = log.finish().unwrap();
    let chunk = mcap::Summary::read(&finished).unwrap().unwrap().chunk_indexes[0].clone();
    let offset = chunk.chunk_start_offset + chunk.chunk_length;
    let mut bytes = finished[..offset as usize].to_vec();
    bytes.push(6);
    bytes.extend([0xff; 8]);
    bytes.extend([0; 100]);
    let (entries, end) = read(&bytes);
    assert_eq!(messages(entries).len(), TOPICS);
    assert_eq!(end.unwrap(), ReadEnd::Truncated { offset });
}

#[test]
fn damage_names_its_place() {
    let mut bytes = sample(2);
    let summary = mcap::Summary::read(&bytes).unwrap().unwrap();
    let offset = summary.chunk_indexes[1].chunk_start_offset;
    // A byte of the compressed records of the second chunk.
    bytes[offset as usize + 200] ^= 1;
    let (entries, end) = read(&bytes);
    assert_eq!(messages(entries).len(), TOPICS);
    let error = end.unwrap_err();
    assert!(matches!(error, LogError::Damaged { offset: at, .. } if at == offset));
    let text = format!("the log is damaged at byte {offset}: ");
    assert!(error.to_string().starts_with(&text), "{error}");
}

#[test]
fn other_files_are_refused() {
    let error = |bytes: &[u8]| read(bytes).1.unwrap_err();
    assert!(matches!(error(b""), LogError::Empty));
    assert!(matches!(error(b"\x89MCA"), LogError::NotMcap));
    assert!(matches!(
        error(b"#ROSBAG V2.0\n and more of it"),
        LogError::NotMcap
    ));
}

#[test]
fn a_file_that_cannot_be_made_or_opened_is_named() {
    let path = scratch("no_such_folder").join("run.mcap");
    let error = LogWriter::create(&path).map(|_| ()).unwrap_err();
    assert!(matches!(&error, LogError::Create { path: named, .. } if *named == path));
    assert!(error.to_string().contains("no_such_folder"), "{error}");
    let error = LogReader::open(&path).map(|_| ()).unwrap_err();
    assert!(matches!(error, LogError::Open { path: named, .. } if named == path));
}

#[test]
fn a_file_written_in_place_reads_back() {
    let path = scratch("in_place.mcap");
    let mut log = LogWriter::create(&path).unwrap();
    write_tick(&mut log, 0).unwrap();
    log.flush().unwrap();
    // Readable while it is still being written.
    let reader = LogReader::open(&path).unwrap();
    assert_eq!(reader.filter(Result::is_ok).count(), TOPICS);
    log.finish().unwrap();
    let mut reader = LogReader::open(&path).unwrap();
    assert_eq!(reader.by_ref().filter(Result::is_ok).count(), TOPICS);
    assert_eq!(reader.end(), Some(ReadEnd::Complete));
}

#[test]
fn refused_messages_leave_the_log_as_it_was() {
    let mut log = LogWriter::new(Vec::new()).unwrap();
    log.write("/map", 1, &occupancy(1)).unwrap();
    let error = log.write("/map", 2, &scan(2)).unwrap_err();
    assert_eq!(
        error.to_string(),
        "topic /map holds nav_msgs/msg/OccupancyGrid, so it cannot take sensor_msgs/msg/LaserScan"
    );
    let mut zero = scan(2);
    zero.header = Header::new(2, "a\0b");
    let error = log.write("/scan", 2, &zero).unwrap_err();
    assert!(matches!(
        error,
        LogError::Encode {
            source: CdrError::NulInString { .. },
            ..
        }
    ));
    let huge = Costmap {
        data: vec![0; RECORD_LIMIT],
        ..costmap(2)
    };
    let error = log.write("/costmap_raw", 2, &huge).unwrap_err();
    assert!(matches!(error, LogError::MessageTooLong { .. }));
    let mut expected = LogWriter::new(Vec::new()).unwrap();
    expected.write("/map", 1, &occupancy(1)).unwrap();
    assert_eq!(log.finish().unwrap(), expected.finish().unwrap());
}

#[test]
fn the_longest_message_written_can_be_read() {
    let mut log = LogWriter::new(Vec::new()).unwrap();
    log.write("/scan", 1, &scan(1)).unwrap();
    let large = Costmap {
        data: (0..RECORD_LIMIT - (2 << 20) - 1000)
            .map(|i| ((i * i) >> 7) as u8)
            .collect(),
        ..costmap(2)
    };
    log.write("/costmap_raw", 2, &large).unwrap();
    let bytes = log.finish().unwrap();
    let (entries, end) = read(&bytes);
    assert_eq!(end.unwrap(), ReadEnd::Complete);
    assert!(messages(entries)[1].decode::<Costmap>().unwrap() == large);
}

#[test]
fn messages_decode_only_as_what_they_are() {
    let (entries, _) = read(&sample(1));
    let mut message = messages(entries).swap_remove(0);
    let error = message.decode::<LaserScan>().unwrap_err();
    assert_eq!(
        error.to_string(),
        "topic /tf holds tf2_msgs/msg/TFMessage, not sensor_msgs/msg/LaserScan"
    );
    message.payload = vec![0, 7, 0, 0];
    let error = message.decode::<TFMessage>().unwrap_err();
    assert!(matches!(
        error,
        LogError::Decode {
            source: CdrError::Xcdr2 { id: 7 },
            ..
        }
    ));
    let mut channel = (*message.channel).clone();
    channel.encoding = "json".to_owned();
    message.channel = channel.into();
    let error = message.decode::<TFMessage>().unwrap_err();
    assert_eq!(
        error.to_string(),
        "topic /tf is encoded as \"json\", and only cdr is decoded"
    );
}

#[test]
fn the_container_says_what_ros_tools_expect() {
    let bytes = sample(2);
    let summary = mcap::Summary::read(&bytes).unwrap().unwrap();
    assert_eq!(summary.channels.len(), TOPICS);
    for channel in summary.channels.values() {
        let schema = channel.schema.as_ref().unwrap();
        assert_eq!(channel.message_encoding, "cdr");
        assert_eq!(schema.encoding, "ros2msg");
        let durability = match channel.topic.as_str() {
            "/map" | "/tf_static" => "\n  durability: 1\n",
            _ => "\n  durability: 2\n",
        };
        let qos = &channel.metadata["offered_qos_profiles"];
        assert!(
            qos.contains("\n  reliability: 1\n") && qos.contains(durability),
            "{qos}"
        );
        if channel.topic == "/scan" {
            assert_eq!(schema.name, LaserScan::TYPE);
            assert_eq!(schema.data, LaserScan::definition().as_bytes());
        }
    }
    assert!(
        summary
            .chunk_indexes
            .iter()
            .all(|chunk| chunk.compression == "zstd")
    );
    // Header record: opcode, length, then the profile as the first text.
    assert_eq!(&bytes[8 + 9..][..8], b"\x04\0\0\0ros2");
}
