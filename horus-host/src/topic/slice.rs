use std::any::type_name;
use std::mem::MaybeUninit;
use std::time::Duration;

use iceoryx2::port::publisher::Publisher;
use iceoryx2::prelude::{AllocationStrategy, ipc};
use iceoryx2::sample::Sample;
use iceoryx2::sample_mut::SampleMut;
use iceoryx2::sample_mut_uninit::SampleMutUninit;
use iceoryx2::service::builder::publish_subscribe::Builder;

use super::channel::Channel;
use super::kind::{Counted, Kind};
use super::{Domain, TopicError, TopicOptions};

type Port<K> = Publisher<ipc::Service, [<K as Kind>::Element], <K as Kind>::Header>;
type Unwritten<K> = SampleMutUninit<ipc::Service, [MaybeUninit<<K as Kind>::Element>], <K as Kind>::Header>;

/// A topic of messages of any size; publisher and subscriber at once, each made when it is used.
pub struct SliceTopic<K: Kind> {
    channel: Channel<[K::Element], K::Header>,
}

impl<K: Kind> SliceTopic<K> {
    /// Opens the topic `name` in the user's domain.
    ///
    /// # Errors
    /// As [`open`](Self::open).
    pub fn new(name: &str) -> Result<Self, TopicError> {
        Self::open(&Domain::of_user()?, name, TopicOptions::default())
    }

    /// Opens a topic, or creates it.
    ///
    /// # Errors
    /// As [`Topic::open`](super::Topic::open). Kinds with equal headers and elements are not told apart.
    pub fn open(domain: &Domain, name: &str, options: TopicOptions) -> Result<Self, TopicError> {
        let channel = Channel::open(
            domain,
            name,
            options,
            type_name::<[K::Element]>(),
            |builder: Builder<[K::Element], K::Header, ipc::Service>| builder.open_or_create(),
            |node, name| {
                let service = node.service_builder(name);
                service
                    .publish_subscribe::<[K::Element]>()
                    .user_header::<K::Header>()
            },
        )?;
        Ok(Self { channel })
    }

    /// A message of `header.count()` elements in shared memory, each of them `element`.
    ///
    /// # Errors
    /// [`TopicError::Use`], also if too many loans are held or memory is short.
    ///
    /// # Complexity
    /// One write per element.
    pub fn loan(&self, header: K::Header, element: K::Element) -> Result<SliceLoan<'_, K>, TopicError> {
        Ok(SliceLoan {
            sample: self.uninit(header)?.write_from_fn(|_| element),
            channel: &self.channel,
        })
    }

    /// Sends a copy of `elements`; returns how many subscribers got it.
    ///
    /// # Errors
    /// [`TopicError::TooLong`] if there are more or fewer than the header says; [`TopicError::Use`].
    pub fn send(&self, header: K::Header, elements: &[K::Element]) -> Result<usize, TopicError> {
        if elements.len() != header.count() {
            return Err(TopicError::TooLong {
                len: elements.len(),
                capacity: header.count(),
            });
        }
        let sample = self.uninit(header)?.write_from_slice(elements);
        self.channel.sent(sample.send())
    }

    /// The oldest message that has not been received; `None` if there is none.
    ///
    /// # Errors
    /// [`TopicError::Use`].
    pub fn recv(&self) -> Result<Option<SliceReceived<K>>, TopicError> {
        let sample = self.channel.subscriber()?.receive();
        let sample = sample.map_err(|error| self.channel.error("receive", error))?;
        Ok(sample.map(|sample| SliceReceived { sample }))
    }

    /// Waits until `wanted` subscribers are connected, so that none misses what is sent next.
    ///
    /// # Errors
    /// [`TopicError::NoSubscribers`] once `patience` is over.
    pub fn wait_for_subscribers(&self, wanted: usize, patience: Duration) -> Result<(), TopicError> {
        self.channel.listen()?;
        self.publisher()?;
        self.channel.wait_for_subscribers(wanted, patience)
    }

    /// Number of publishers, those of killed processes that nobody has cleaned up included.
    pub fn number_of_publishers(&self) -> usize {
        self.channel.number_of_publishers()
    }

    /// Removes what killed processes left, their publishers among it.
    pub fn clean(&self) {
        self.channel.clean();
    }

    fn publisher(&self) -> Result<&Port<K>, TopicError> {
        let expected_len = self.channel.options().expected_len.max(1);
        self.channel.publisher(|builder| {
            builder
                .initial_max_slice_len(expected_len)
                .allocation_strategy(AllocationStrategy::PowerOfTwo)
        })
    }

    fn uninit(&self, header: K::Header) -> Result<Unwritten<K>, TopicError> {
        let sample = self.publisher()?.loan_slice_uninit(header.count());
        let mut sample = sample.map_err(|error| self.channel.error("loan a message", error))?;
        *sample.user_header_mut() = header;
        Ok(sample)
    }
}

/// A message that is being made in shared memory.
pub struct SliceLoan<'a, K: Kind> {
    sample: SampleMut<ipc::Service, [K::Element], K::Header>,
    channel: &'a Channel<[K::Element], K::Header>,
}

impl<K: Kind> SliceLoan<'_, K> {
    /// Size and place, or the geometry of a scan.
    pub fn header_mut(&mut self) -> &mut K::Header {
        self.sample.user_header_mut()
    }

    /// The elements: storage for a core grid.
    pub fn elements_mut(&mut self) -> &mut [K::Element] {
        self.sample.payload_mut()
    }

    /// Sends it; returns how many subscribers got it.
    ///
    /// # Errors
    /// [`TopicError::Use`]: on a reliable topic, if a subscriber's buffer stayed full.
    pub fn send(self) -> Result<usize, TopicError> {
        let Self { sample, channel } = self;
        channel.sent(sample.send())
    }
}

/// A message in shared memory, to be read. Its memory is free again when it is dropped.
pub struct SliceReceived<K: Kind> {
    sample: Sample<ipc::Service, [K::Element], K::Header>,
}

impl<K: Kind> SliceReceived<K> {
    /// Size and place, or the geometry of a scan.
    pub fn header(&self) -> &K::Header {
        self.sample.user_header()
    }

    /// The elements; as many as the header says, unless another program sent it.
    pub fn elements(&self) -> &[K::Element] {
        self.sample.payload()
    }
}
