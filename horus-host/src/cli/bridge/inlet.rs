use horus_host::log::LogError;
use horus_host::topic::kind::Kind;
use horus_host::topic::{Domain, SliceTopic, TopicError, TopicOptions, kind};

use super::live_log::LiveLog;
use super::{convert, options};
use crate::cli::value_grid::{self, DISTANCE};

/// A topic whose messages are written to a log.
pub enum Inlet {
    Map(SliceTopic<kind::Occupancy>),
    Costs(SliceTopic<kind::Costs>),
    Local(SliceTopic<kind::Local>),
    Scan(SliceTopic<kind::Scan>),
    Transforms(SliceTopic<kind::Transforms>),
    Distance(SliceTopic<kind::Distance>),
    Evidence(SliceTopic<kind::Evidence>),
}

/// Why a topic's messages could not be taken over.
#[derive(Debug, thiserror::Error)]
pub enum InletError {
    #[error(transparent)]
    Topic(#[from] TopicError),
    #[error(transparent)]
    Log(#[from] LogError),
}

impl Inlet {
    /// Opens a topic as whatever it is; `None` if it carries nothing that a log can hold.
    pub fn open(domain: &Domain, name: &str) -> Result<Option<Self>, TopicError> {
        // `pub` sends with the first, programs with the second where they ask for nothing else.
        for options in [options(), TopicOptions::default(), TopicOptions::reliable()] {
            let found = open_as(domain, name, options, Self::Map)
                .or_else(|error| other(error, || open_as(domain, name, options, Self::Costs)))
                .or_else(|error| other(error, || open_as(domain, name, options, Self::Local)))
                .or_else(|error| other(error, || open_as(domain, name, options, Self::Scan)))
                .or_else(|error| other(error, || open_as(domain, name, options, Self::Transforms)))
                .or_else(|error| other(error, || open_as(domain, name, options, Self::Distance)))
                .or_else(|error| other(error, || open_as(domain, name, options, Self::Evidence)));
            match found {
                Ok(inlet) => return Ok(Some(inlet)),
                Err(TopicError::Type { .. } | TopicError::Options { .. }) => {}
                Err(error) => return Err(error),
            }
        }
        Ok(None)
    }

    /// Writes the next message to the log; `false` if there is none.
    pub fn take(&self, topic: &str, log: &mut LiveLog) -> Result<bool, InletError> {
        match self {
            Self::Map(inlet) => take(inlet, |header, cells| {
                log.write(topic, header.timestamp_ns, &convert::map(header, cells))
            }),
            Self::Costs(inlet) => take(inlet, |header, cells| {
                log.write(topic, header.timestamp_ns, &convert::costs(header, cells))
            }),
            Self::Local(inlet) => take(inlet, |header, cells| {
                let map = convert::local_map(&header.grid, cells);
                log.write(topic, header.grid.timestamp_ns, &map)
            }),
            Self::Scan(inlet) => take(inlet, |header, ranges| {
                log.write(topic, header.timestamp_ns, &convert::scan(header, ranges))
            }),
            Self::Transforms(inlet) => take(inlet, |header, entries| {
                log.write(topic, header.timestamp_ns, &convert::tf(entries))
            }),
            Self::Distance(inlet) => take(inlet, |header, cells| {
                let cells = cells.iter().map(|&value| [value]);
                log.write(
                    topic,
                    header.timestamp_ns,
                    &value_grid::grid(header, DISTANCE, cells),
                )
            }),
            Self::Evidence(inlet) => take(inlet, |header, cells| {
                let masses = cells.iter().map(|masses| masses.map(f64::from));
                log.write(topic, header.timestamp_ns, &value_grid::evidence(header, masses))
            }),
        }
    }

    /// Whether anybody publishes; killed processes are cleaned up before counting.
    pub fn has_publishers(&self) -> bool {
        match self {
            Self::Map(inlet) => has_publishers(inlet),
            Self::Costs(inlet) => has_publishers(inlet),
            Self::Local(inlet) => has_publishers(inlet),
            Self::Scan(inlet) => has_publishers(inlet),
            Self::Transforms(inlet) => has_publishers(inlet),
            Self::Distance(inlet) => has_publishers(inlet),
            Self::Evidence(inlet) => has_publishers(inlet),
        }
    }
}

fn open_as<K: Kind>(
    domain: &Domain,
    name: &str,
    options: TopicOptions,
    inlet: impl Fn(SliceTopic<K>) -> Inlet,
) -> Result<Inlet, TopicError> {
    SliceTopic::open(domain, name, options).map(inlet)
}

/// Tries something else if the topic is of another type.
fn other(error: TopicError, open: impl FnOnce() -> Result<Inlet, TopicError>) -> Result<Inlet, TopicError> {
    match error {
        TopicError::Type { .. } => open(),
        error => Err(error),
    }
}

fn take<K: Kind>(
    inlet: &SliceTopic<K>,
    write: impl FnOnce(&K::Header, &[K::Element]) -> Result<(), LogError>,
) -> Result<bool, InletError> {
    let Some(message) = inlet.recv()? else {
        return Ok(false);
    };
    write(message.header(), message.elements())?;
    Ok(true)
}

fn has_publishers<K: Kind>(inlet: &SliceTopic<K>) -> bool {
    inlet.clean();
    inlet.number_of_publishers() > 0
}
