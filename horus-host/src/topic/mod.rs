//! Live data between processes over shared memory: `Topic`, as HORUS has it, on iceoryx2.
//!
//! | | size | for |
//! |---|---|---|
//! | [`Topic`]`<T>` | fixed at compile time | [`Fixed`]`<kind, N>`: grids, cost bytes, scans of up to N elements; [`PoseMsg`] |
//! | [`SliceTopic`]`<kind>` | any, per message | the same kinds |
//!
//! A kind ([`kind`]) says what a message is: its header, its elements and its topic's default name.
//! Messages are made **in** shared memory: [`Topic::loan`] gives one whose elements are a slice that a
//! core grid takes as its storage; sending it copies nothing, and every subscriber reads the same bytes.
//!
//! Who comes late gets the last message at the publisher's next `send`. Who is slow loses the oldest
//! messages and never slows the publisher, unless the topic is [reliable](TopicOptions::reliable()).
//! What a killed process leaves behind is cleaned when the next one opens a topic. Opening a topic as
//! another type or size is an error.
//!
//! Processes meet in a [`Domain`], one per user unless `HORUS_DOMAIN` names another.
//!
//! # Examples
//! ```
//! use horus_core::prelude::*;
//! use horus_host::topic::{Domain, GridHeader, OccupancyGridMsg, Topic, TopicOptions};
//!
//! type Map = OccupancyGridMsg<{ 60 * 40 }>;
//! let domain = Domain::new("doc_topic")?; // `Topic::new("occupancy_grid")` for that of the user
//! let topic: Topic<Map> = Topic::open(&domain, "occupancy_grid", TopicOptions::default())?;
//! let listener: Topic<Map> = Topic::open(&domain, "occupancy_grid", TopicOptions::default())?;
//! assert!(listener.recv()?.is_none());
//!
//! let mut message = topic.loan()?;
//! let mut grid = OccupancyGrid::new_in(message.elements_mut(), 60, 40, 0.05, Pose2D::default())?;
//! grid.set_occupancy(3, 2, 100);
//! let header = GridHeader::of(&grid);
//! message.header = header;
//! message.send()?;
//!
//! let received = listener.recv()?.expect("a message");
//! let map = received.header.view(received.elements())?;
//! assert_eq!((map.info().width(), map.occupancy(3, 2)), (60, Some(100)));
//! # drop((received, topic, listener));
//! # domain.remove();
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod channel;
mod domain;
mod error;
mod fixed;
mod header;
pub mod kind;
mod options;
mod sized;
mod slice;

pub use domain::Domain;
pub use error::TopicError;
pub use fixed::{Fixed, Payload, PoseMsg};
pub use header::{
    GridHeader, LocalGridHeader, ScanHeader, TransformEntry, TransformHeader, frame_bytes, frame_name,
};
pub use options::TopicOptions;
pub use sized::{Loan, Received, Topic};
pub use slice::{SliceLoan, SliceReceived, SliceTopic};

/// A HORUS `OccupancyGrid` of up to `N` cells.
pub type OccupancyGridMsg<const N: usize> = Fixed<kind::Occupancy, N>;
/// The cost bytes of a HORUS `CostMap` of up to `N` cells.
pub type CostMapMsg<const N: usize> = Fixed<kind::Costs, N>;
/// A laser scan of up to `N` beams.
pub type LaserScanMsg<const N: usize> = Fixed<kind::Scan, N>;
/// A navground `LocalGridMap` of up to `N` cells.
pub type LocalGridMapMsg<const N: usize> = Fixed<kind::Local, N>;
/// An evidence grid of up to `N` cells.
pub type EvidenceGridMsg<const N: usize> = Fixed<kind::Evidence, N>;
/// A distance map of up to `N` cells.
pub type DistanceMapMsg<const N: usize> = Fixed<kind::Distance, N>;
