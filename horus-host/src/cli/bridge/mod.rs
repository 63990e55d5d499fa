//! `pub` and `sub`: logs and topics in shared memory.

mod convert;
mod inlet;
mod live_log;
mod outlet;
mod publish;
mod subscribe;

use horus_host::topic::{Domain, TopicError, TopicOptions};

pub use publish::{PublishOptions, run as publish};
pub use subscribe::{SubscribeOptions, run as subscribe};

/// Messages that wait for a subscriber.
const BUFFER: usize = 16;

/// How `pub` sends: nothing is lost while subscribers live.
fn options() -> TopicOptions {
    TopicOptions {
        buffer: BUFFER,
        ..TopicOptions::reliable()
    }
}

fn domain(name: Option<&str>) -> Result<Domain, TopicError> {
    match name {
        Some(name) => Domain::new(name),
        None => Domain::of_user(),
    }
}
