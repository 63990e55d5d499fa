use horus_host::log::LogMessage;
use horus_host::log::msg::{Costmap, Grid, LaserScan, Message, OccupancyGrid, TFMessage};
use horus_host::topic::{Domain, SliceTopic, TopicError, kind};
use std::time::Duration;

use super::{convert, options};

/// A topic that messages of a log are sent on.
pub enum Outlet {
    Map(SliceTopic<kind::Occupancy>),
    Costs(SliceTopic<kind::Costs>),
    Scan(SliceTopic<kind::Scan>),
    Transforms(SliceTopic<kind::Transforms>),
    Distance(SliceTopic<kind::Distance>),
    Evidence(SliceTopic<kind::Evidence>),
}

/// Names of the values in grids of the log.
pub const DISTANCE: [&str; 1] = ["distance"];
pub const EVIDENCE: [&str; 2] = ["free", "occupied"];

impl Outlet {
    /// The topic for messages like this one; `None` if no topic carries them.
    pub fn open(domain: &Domain, message: &LogMessage) -> anyhow::Result<Option<Self>> {
        let name = message.topic();
        Ok(Some(match message.channel.type_name.as_str() {
            OccupancyGrid::TYPE => Self::Map(SliceTopic::open(domain, name, options())?),
            Costmap::TYPE => Self::Costs(SliceTopic::open(domain, name, options())?),
            LaserScan::TYPE => Self::Scan(SliceTopic::open(domain, name, options())?),
            TFMessage::TYPE => Self::Transforms(SliceTopic::open(domain, name, options())?),
            Grid::TYPE => {
                let grid: Grid = message.decode()?;
                if convert::values(&grid, DISTANCE).is_some() {
                    Self::Distance(SliceTopic::open(domain, name, options())?)
                } else if convert::values(&grid, EVIDENCE).is_some() {
                    Self::Evidence(SliceTopic::open(domain, name, options())?)
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
            Self::Distance(topic) => match convert::values(&message.decode()?, DISTANCE) {
                Some((header, cells)) => topic.send(header, cells.as_flattened())?,
                None => 0,
            },
            Self::Evidence(topic) => match convert::values(&message.decode()?, EVIDENCE) {
                Some((header, cells)) => topic.send(header, &cells)?,
                None => 0,
            },
        })
    }
}
