//! Comparing two logs.
use std::path::PathBuf;

use crate::samples::*;
use horus_host::log::{Comparison, Difference, LogError, LogWriter, ReadEnd, TopicComparison, compare};

type Log = LogWriter<Vec<u8>>;

/// Writes a log of a test to a file.
fn file(name: &str, write: impl FnOnce(&mut Log) -> Result<(), LogError>) -> PathBuf {
    let mut log = LogWriter::new(Vec::new()).unwrap();
    write(&mut log).unwrap();
    let path = scratch(name);
    std::fs::write(&path, log.finish().unwrap()).unwrap();
    path
}

fn three_ticks(log: &mut Log) -> Result<(), LogError> {
    (0..3).try_for_each(|tick| write_tick(log, tick))
}

fn topic<'a>(comparison: &'a Comparison, name: &str) -> &'a TopicComparison {
    let topics = &comparison.topics;
    topics.iter().find(|topic| topic.topic == name).unwrap()
}

fn first<'a>(comparison: &'a Comparison, name: &str) -> &'a Difference {
    topic(comparison, name).first.as_ref().unwrap()
}

#[test]
fn equal_logs_are_equal_whatever_the_order_of_topics_and_chunks() {
    let a = file("equal_a.mcap", three_ticks);
    let b = file("equal_b.mcap", |log| {
        log.metadata("only here", metadata())?;
        for tick in 0..3 {
            log.write("/plan", stamp(tick), &path(tick))?;
            log.flush()?;
        }
        for tick in 0..3 {
            log.write("/tf_static", stamp(tick), &transforms(tick))?;
            log.write("/evidence", stamp(tick), &evidence(tick))?;
            log.write("/map", stamp(tick), &occupancy(tick))?;
            log.write("/costmap_raw", stamp(tick), &costmap(tick))?;
            log.write("/scan", stamp(tick), &scan(tick))?;
            log.write("/tf", stamp(tick), &transforms(tick))?;
        }
        Ok(())
    });
    let result = compare(&a, &b).unwrap();
    assert!(result.equal);
    assert_eq!(result.topics.len(), TOPICS);
    for topic in &result.topics {
        assert_eq!((topic.messages_a, topic.messages_b), (3, 3));
        assert!(topic.is_equal() && topic.first.is_none());
    }
}

#[test]
fn every_kind_of_difference_is_found_where_it_is() {
    let a = file("kinds_a.mcap", three_ticks);
    let b = file("kinds_b.mcap", |log| {
        for tick in 0..3 {
            let mut map = occupancy(tick);
            let mut costs = costmap(tick);
            let mut masses = evidence(tick);
            let mut beams = scan(tick);
            let mut edges = transforms(tick);
            if tick == 1 {
                // Cell (3, 2) and, for the count only, cell (6, 4).
                map.data[17] = 77;
                map.data[34] = 78;
                costs.metadata.origin.position.x += 1.0;
                // The mass `occupied` of cell (2, 1): two of its bytes, one cell.
                let at = 16 * 9 + 4;
                masses.data[at..at + 4].copy_from_slice(&0.75f32.to_le_bytes());
                beams.ranges[2] = f32::NAN;
                edges.transforms[1].child_frame_id = "robot".to_owned();
            }
            log.write("/map", stamp(tick), &map)?;
            log.write("/costmap_raw", stamp(tick), &costs)?;
            log.write("/evidence", stamp(tick), &masses)?;
            log.write("/scan", stamp(tick), &beams)?;
            log.write("/tf", stamp(tick), &edges)?;
            log.write("/tf_static", stamp(tick) + tick / 2, &transforms(tick))?;
        }
        log.write("/tf", stamp(3), &transforms(3))?;
        log.write("/plan", stamp(0), &scan(0))
    });
    let result = compare(&a, &b).unwrap();
    assert!(!result.equal);
    let text = |name| first(&result, name).to_string();
    let old = occupancy(1).data[17];
    let at = stamp(1);
    assert_eq!(
        text("/map"),
        format!("message 1 at {at} ns: data of cell (3, 2) is {old} against 77")
    );
    assert_eq!(topic(&result, "/map").differing_messages, 1);
    assert_eq!(topic(&result, "/map").differing_cells, 2);
    assert_eq!(
        text("/costmap_raw"),
        format!("message 1 at {at} ns: metadata.origin.position.x is -1 against 0")
    );
    let difference = first(&result, "/evidence");
    assert_eq!(
        (difference.field.as_str(), difference.b.as_str()),
        ("data.occupied", "0.75")
    );
    assert_eq!(difference.cell, Some([2, 1]));
    assert_eq!(topic(&result, "/evidence").differing_cells, 1);
    assert_eq!(
        text("/scan"),
        format!("message 1 at {at} ns: ranges[2] is 3.5 against NaN")
    );
    let tf = topic(&result, "/tf");
    assert_eq!((tf.messages_a, tf.messages_b, tf.differing_messages), (3, 4, 2));
    assert_eq!(
        text("/tf"),
        format!("message 1 at {at} ns: transforms[1].child_frame_id is \"base_link\" against \"robot\"")
    );
    assert_eq!(first(&result, "/tf_static").field, "log time");
    assert_eq!(first(&result, "/tf_static").message, 2);
    let plan = topic(&result, "/plan");
    assert_eq!(
        (plan.messages_a, plan.messages_b, plan.differing_messages),
        (3, 1, 3)
    );
    assert_eq!(first(&result, "/plan").field, "type");
    let json = serde_json::to_value(&result).unwrap();
    assert_eq!(json["topics"][2]["first"]["cell"], serde_json::json!([3, 2]));
    assert_eq!(json["end_a"], "complete");
}

#[test]
fn a_grid_of_another_size_differs_by_its_size() {
    let a = file("size_a.mcap", |log| log.write("/map", 1, &occupancy(1)));
    let b = file("size_b.mcap", |log| {
        let mut map = occupancy(1);
        map.info.height -= 1;
        map.data.truncate((WIDTH * map.info.height) as usize);
        log.write("/map", 1, &map)
    });
    let result = compare(&a, &b).unwrap();
    let first = first(&result, "/map");
    assert_eq!((first.field.as_str(), first.cell), ("info.height", None));
    assert_eq!((first.a.as_str(), first.b.as_str()), ("5", "4"));
    assert_eq!(topic(&result, "/map").differing_cells, 0);
}

#[test]
fn a_topic_in_one_log_only_is_a_difference() {
    let a = file("topic_a.mcap", |log| log.write("/scan", 1, &scan(1)));
    let b = file("topic_b.mcap", |log| {
        log.write("/scan", 1, &scan(1))?;
        log.write("/plan", 9, &path(9))
    });
    let result = compare(&a, &b).unwrap();
    assert!(!result.equal && topic(&result, "/scan").is_equal());
    let text = first(&result, "/plan").to_string();
    assert_eq!(text, "message 0 at 9 ns: message is missing against present");
}

#[test]
fn truncated_logs_say_so() {
    let whole = file("whole.mcap", three_ticks);
    let bytes = std::fs::read(&whole).unwrap();
    // Without the end magic: every message is there, but the log was not finished.
    let cut = scratch("cut.mcap");
    std::fs::write(&cut, &bytes[..bytes.len() - 8]).unwrap();
    let result = compare(&whole, &cut).unwrap();
    assert_eq!(result.end_a, ReadEnd::Complete);
    assert!(matches!(result.end_b, ReadEnd::Truncated { .. }));
    assert!(!result.equal && result.topics.iter().all(TopicComparison::is_equal));
    assert!(compare(&cut, &cut).unwrap().equal);
}

#[test]
fn an_unreadable_log_is_named() {
    let a = file("readable.mcap", three_ticks);
    let b = scratch("unreadable.mcap");
    std::fs::write(&b, b"no log at all").unwrap();
    for (first, second) in [(&a, &b), (&b, &a)] {
        let error = compare(first, second).unwrap_err();
        assert!(
            matches!(&error, LogError::InFile { path, .. } if *path == b),
            "{error}"
        );
        assert!(
            error
                .to_string()
                .ends_with("unreadable.mcap: the file is not an MCAP file")
        );
    }
    let missing = scratch("missing.mcap");
    let error = compare(&a, &missing).unwrap_err();
    assert!(matches!(&error, LogError::Open { path, .. } if *path == missing));
}
