//! Grids with a number and a checksum, made in shared memory.

use std::time::Duration;

use horus_core::prelude::{OccupancyGrid, Pose2D};
use horus_host::topic::{GridHeader, OccupancyGridMsg, Received, Topic, TopicError, TopicOptions};

use crate::peer::{PATIENCE, domain, number};

pub const SIDE: u32 = 100;
pub type Grid = OccupancyGridMsg<{ (SIDE * SIDE) as usize }>;

pub const TOPIC: &str = "occupancy_grid";

/// Options with a short patience, so that tests of full buffers end.
pub fn options(reliable: bool) -> TopicOptions {
    TopicOptions {
        reliable,
        patience: Duration::from_millis(500),
        ..TopicOptions::default()
    }
}

/// Sends grid number `n`: a core grid in the loaned message, its checksum in the metadata.
pub fn send(topic: &Topic<Grid>, n: u64) -> Result<usize, TopicError> {
    let mut message = topic.loan()?;
    let cells = message.elements_mut();
    let mut grid = OccupancyGrid::new_in(cells, SIDE, SIDE, 0.05, Pose2D::new(1.0, 2.0, 0.5)).unwrap();
    for gy in 0..SIDE {
        for gx in 0..SIDE {
            let value = (u64::from(gx * 7 + gy * 13) + n * 31) % 101;
            assert!(grid.set_occupancy(gx, gy, value as i8));
        }
    }
    grid.timestamp_ns = n;
    let checksum = checksum(grid.data(), n);
    grid.metadata[..4].copy_from_slice(&checksum.to_le_bytes());
    let header = GridHeader::of(&grid);
    message.header = header;
    message.send()
}

/// The number of a grid that has arrived whole.
pub fn intact(message: &Received<Grid>) -> u64 {
    let grid = message.header.view(message.elements()).unwrap();
    assert_eq!((grid.info().width(), grid.info().height()), (SIDE, SIDE));
    assert_eq!(grid.info().origin(), Pose2D::new(1.0, 2.0, 0.5));
    let expected = checksum(grid.data(), grid.timestamp_ns);
    assert_eq!(grid.metadata[..4], expected.to_le_bytes(), "torn data");
    grid.timestamp_ns
}

fn checksum(cells: &[i8], n: u64) -> u32 {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&n.to_le_bytes());
    hasher.update(&cells.iter().map(|&cell| cell as u8).collect::<Vec<_>>());
    hasher.finalize()
}

/// Publishes from `FIRST` on, every `PERIOD_US`, until it is killed or has sent `COUNT`.
#[test]
#[ignore = "a role, not a test"]
fn publisher() {
    let topic = Topic::open(&domain(), TOPIC, options(number("RELIABLE") == 1)).unwrap();
    if number("WAIT") > 0 {
        topic
            .wait_for_subscribers(number("WAIT") as usize, PATIENCE)
            .unwrap();
    }
    println!("ready");
    let first = number("FIRST");
    for n in first..first.saturating_add(number("COUNT")) {
        send(&topic, n).unwrap();
        std::thread::sleep(Duration::from_micros(number("PERIOD_US")));
    }
}

/// Receives until grid number `LAST`, `PERIOD_US` after each; says which came.
#[test]
#[ignore = "a role, not a test"]
fn subscriber() {
    let topic: Topic<Grid> = Topic::open(&domain(), TOPIC, options(number("RELIABLE") == 1)).unwrap();
    // Connects; there may be a first message.
    let mut received: Vec<u64> = topic.recv().unwrap().iter().map(intact).collect();
    println!("ready");
    crate::peer::until(|| {
        let message = topic.recv().unwrap()?;
        received.push(intact(&message));
        drop(message);
        std::thread::sleep(Duration::from_micros(number("PERIOD_US")));
        (received.last() == Some(&number("LAST"))).then_some(())
    });
    println!("received {received:?}");
}
