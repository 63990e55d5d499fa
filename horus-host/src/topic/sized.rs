use std::any::type_name;
use std::ops::{Deref, DerefMut};
use std::time::Duration;

use iceoryx2::prelude::ipc;
use iceoryx2::sample::Sample;
use iceoryx2::sample_mut::SampleMut;
use iceoryx2::service::builder::publish_subscribe::Builder;

use super::channel::Channel;
use super::{Domain, Payload, TopicError, TopicOptions};

/// A topic of messages of a fixed size; publisher and subscriber at once, each made when it is used.
pub struct Topic<T: Payload> {
    channel: Channel<T, ()>,
}

impl<T: Payload> Topic<T> {
    /// Opens the topic `name` in the user's domain.
    ///
    /// # Errors
    /// As [`open`](Self::open).
    pub fn new(name: &str) -> Result<Self, TopicError> {
        Self::open(&Domain::of_user()?, name, TopicOptions::default())
    }

    /// Opens the topic that has the type's own name, e.g. `occupancy_grid`.
    ///
    /// # Errors
    /// As [`open`](Self::open).
    pub fn with_default_name() -> Result<Self, TopicError> {
        Self::new(T::TOPIC)
    }

    /// Opens a topic, or creates it.
    ///
    /// # Errors
    /// [`TopicError::Name`]; [`TopicError::Type`] if it holds messages of another type or size;
    /// [`TopicError::Options`]; [`TopicError::Open`].
    pub fn open(domain: &Domain, name: &str, options: TopicOptions) -> Result<Self, TopicError> {
        let channel = Channel::open(
            domain,
            name,
            options,
            type_name::<T>(),
            |builder: Builder<T, (), ipc::Service>| builder.open_or_create(),
            |node, name| node.service_builder(name).publish_subscribe::<T>(),
        )?;
        Ok(Self { channel })
    }

    /// A message in shared memory, all bits zero, to be filled and sent.
    ///
    /// # Errors
    /// [`TopicError::Use`], also if too many loans are held.
    ///
    /// # Complexity
    /// One write per byte.
    pub fn loan(&self) -> Result<Loan<'_, T>, TopicError> {
        let publisher = self.channel.publisher(|builder| builder)?;
        let mut sample = publisher
            .loan_uninit()
            .map_err(|error| self.channel.error("loan a message", error))?;
        // SAFETY: the sample is memory for one T, and all bits zero are one (`Payload`).
        let sample = unsafe {
            sample.payload_mut().as_mut_ptr().write_bytes(0, 1);
            sample.assume_init()
        };
        Ok(Loan {
            sample,
            channel: &self.channel,
        })
    }

    /// Sends a copy of `message`; [`loan`](Self::loan) sends without one. Returns how many
    /// subscribers got it.
    ///
    /// # Errors
    /// [`TopicError::Use`].
    pub fn send(&self, message: T) -> Result<usize, TopicError> {
        let mut loan = self.loan()?;
        *loan = message;
        loan.send()
    }

    /// The oldest message that has not been received; `None` if there is none. It may be held while up
    /// to three others are.
    ///
    /// # Errors
    /// [`TopicError::Use`].
    pub fn recv(&self) -> Result<Option<Received<T>>, TopicError> {
        let sample = self.channel.subscriber()?.receive();
        let sample = sample.map_err(|error| self.channel.error("receive", error))?;
        Ok(sample.map(|sample| Received { sample }))
    }

    /// Waits until `wanted` subscribers are connected, so that none misses what is sent next.
    ///
    /// # Errors
    /// [`TopicError::NoSubscribers`] once `patience` is over.
    pub fn wait_for_subscribers(&self, wanted: usize, patience: Duration) -> Result<(), TopicError> {
        self.channel.listen()?;
        self.channel.publisher(|builder| builder)?;
        self.channel.wait_for_subscribers(wanted, patience)
    }
}

/// A message that is being made in shared memory.
pub struct Loan<'a, T: Payload> {
    sample: SampleMut<ipc::Service, T, ()>,
    channel: &'a Channel<T, ()>,
}

impl<T: Payload> Loan<'_, T> {
    /// Sends it; returns how many subscribers got it.
    ///
    /// # Errors
    /// [`TopicError::Use`]: on a reliable topic, if a subscriber's buffer stayed full.
    pub fn send(self) -> Result<usize, TopicError> {
        let Self { sample, channel } = self;
        channel.sent(sample.send())
    }
}

impl<T: Payload> Deref for Loan<'_, T> {
    type Target = T;
    fn deref(&self) -> &T {
        self.sample.payload()
    }
}

impl<T: Payload> DerefMut for Loan<'_, T> {
    fn deref_mut(&mut self) -> &mut T {
        self.sample.payload_mut()
    }
}

/// A message in shared memory, to be read. Its memory is free again when it is dropped.
pub struct Received<T: Payload> {
    sample: Sample<ipc::Service, T, ()>,
}

impl<T: Payload> Deref for Received<T> {
    type Target = T;
    fn deref(&self) -> &T {
        self.sample.payload()
    }
}
