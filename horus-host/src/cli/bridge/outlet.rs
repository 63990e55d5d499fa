use std::time::Duration;

use horus_host::log::LogMessage;
use horus_host::log::msg::{Costmap, Grid, LaserScan, Message, OccupancyGrid, TFMessage};
use horus_host::topic::kind::Kind;
use horus_host::topic::{Domain, SliceTopic, TopicError, TopicOptions, kind};

use super::{convert, options};
use crate::cli::value_grid::{self, DISTANCE, EVIDENCE};

/// A topic that messages of a log are sent on.
pub enum Outlet {
    Map(SliceTopic<kind::Occupancy>),
    Costs(SliceTopic<kind::Costs>),
    Scan(SliceTopic<kind::Scan>),
    Transforms(SliceTopic<kind::Transforms>),
    Distance(SliceTopic<kind::Distance>),
    Evidence(SliceTopic<kind::Evidence>),
}

impl Outlet {
    /// The topic for messages like this one; `None` if no topic carries them.
    pub fn open(domain: &Domain, message: &LogMessage) -> anyhow::Result<Option<Self>> {
        fn open<K: Kind>(domain: &Domain, message: &LogMessage) -> Result<SliceTopic<K>, TopicError> {
            let options = TopicOptions {
                // A little more than it has: the payload has a header.
                expected_len: message.payload.len() / size_of::<K::Element>() + 1,
                ..options()
            };
            SliceTopic::open(domain, message.topic(), options)
        }
        Ok(Some(match message.channel.type_name.as_str() {
            OccupancyGrid::TYPE => Self::Map(open(domain, message)?),
            Costmap::TYPE => Self::Costs(open(domain, message)?),
            LaserScan::TYPE => Self::Scan(open(domain, message)?),
            TFMessage::TYPE => Self::Transforms(open(domain, message)?),
            Grid::TYPE => {
                let grid: Grid = message.decode()?;
                if value_grid::values(&grid, DISTANCE).is_some() {
                    Self::Distance(open(domain, message)?)
                } else if value_grid::values(&grid, EVIDENCE).is_some() {
                    Self::Evidence(open(domain, message)?)
                } else {
                    return Ok(None);
                }
            }
            _ => return Ok(None),
        }))
    }

    pub fn wait_for_subscribers(&self, wanted: usize, patience: Duration) -> Result<(), TopicError> {
        match self {
            Self::Map(topic) => topic.wait_for_subscribers(wanted, patience),
            Self::Costs(topic) => topic.wait_for_subscribers(wanted, patience),
            Self::Scan(topic) => topic.wait_for_subscribers(wanted, patience),
            Self::Transforms(topic) => topic.wait_for_subscribers(wanted, patience),
            Self::Distance(topic) => topic.wait_for_subscribers(wanted, patience),
            Self::Evidence(topic) => topic.wait_for_subscribers(wanted, patience),
        }
    }

    /// Sends a message; returns how many subscribers got it.
    pub fn send(&self, message: &LogMessage) -> anyhow::Result<usize> {
        Ok(match self {
            Self::Map(topic) => {
                let map: OccupancyGrid = message.decode()?;
                topic.send(convert::map_header(&map), &map.data)?
            }
            Self::Costs(topic) => {
                let map: Costmap = message.decode()?;
                topic.send(convert::costs_header(&map), &map.data)?
            }
            Self::Scan(topic) => {
                let scan: LaserScan = message.decode()?;
                topic.send(convert::scan_header(&scan), &scan.ranges)?
            }
            Self::Transforms(topic) => {
                let is_static = message.topic().ends_with("tf_static");
                let (header, entries) =
                    convert::transforms(&message.decode()?, message.log_time_ns, is_static);
                topic.send(header, &entries)?
            }
            Self::Distance(topic) => match value_grid::values(&message.decode()?, DISTANCE) {
                Some((header, cells)) => topic.send(header, cells.as_flattened())?,
                None => 0,
            },
            Self::Evidence(topic) => match value_grid::values(&message.decode()?, EVIDENCE) {
                Some((header, cells)) => topic.send(header, &cells)?,
                None => 0,
            },
        })
    }
}
