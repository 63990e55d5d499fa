use std::cell::{Cell, OnceCell};
use std::fmt::Debug;
use std::thread;
use std::time::{Duration, Instant};

use iceoryx2::config::Config;
use iceoryx2::node::{Node, NodeBuilder};
use iceoryx2::port::listener::Listener;
use iceoryx2::port::publisher::Publisher;
use iceoryx2::port::subscriber::Subscriber;
use iceoryx2::port::update_connections::UpdateConnections;
use iceoryx2::port::{BackpressureAction, BackpressureInfo, SendError};
use iceoryx2::prelude::{
    BackpressureStrategy, CallbackProgression, IceoryxSend, PortFactory as _, ServiceName,
    SignalHandlingMode, ZeroCopySend, ipc,
};
use iceoryx2::service::builder::publish_subscribe::{
    Builder, PublishSubscribeCreateError, PublishSubscribeOpenError, PublishSubscribeOpenOrCreateError,
};
use iceoryx2::service::port_factory::publish_subscribe::PortFactory;
use iceoryx2::service::port_factory::publisher::PortFactoryPublisher;

use super::{Domain, TopicError, TopicOptions};

/// How often and how long opening is tried again where a service is just coming or going.
const PAUSE: Duration = Duration::from_millis(10);
const TRIES: u32 = 100;

/// Most publishers and subscribers of a topic, dead ones not yet cleaned included.
const PORTS: usize = 8;
/// Messages that a subscriber may hold.
const HELD: usize = 4;

/// What both kinds of topics share: the service, and its ports as far as they are used.
pub(super) struct Channel<P: IceoryxSend + Debug + ?Sized + 'static, H: ZeroCopySend + Debug + 'static> {
    name: String,
    options: TopicOptions,
    publisher: OnceCell<Publisher<ipc::Service, P, H>>,
    subscriber: OnceCell<Subscriber<ipc::Service, P, H>>,
    /// Told by every subscriber once it is connected to a publisher.
    ready: OnceCell<Listener<ipc::Service>>,
    /// The publishers that were told.
    told: Cell<u128>,
    service: PortFactory<ipc::Service, P, H>,
    node: Node<ipc::Service>,
}

impl<P: IceoryxSend + Debug + ?Sized + 'static, H: ZeroCopySend + Debug + 'static> Channel<P, H> {
    /// Opens the service `name`, or creates it. `open` makes the builder for the type.
    pub fn open(
        domain: &Domain,
        name: &str,
        options: TopicOptions,
        wanted: &'static str,
        open: impl Fn(
            Builder<P, H, ipc::Service>,
        ) -> Result<PortFactory<ipc::Service, P, H>, PublishSubscribeOpenOrCreateError>,
        builder: impl Fn(&Node<ipc::Service>, &ServiceName) -> Builder<P, H, ipc::Service>,
    ) -> Result<Self, TopicError> {
        let service_name = service_name(name)?;
        let node = node(domain.config(), name)?;
        let mut tries = 0;
        let service = loop {
            let builder = builder(&node, &service_name)
                .enable_safe_overflow(!options.reliable)
                .subscriber_max_buffer_size(options.buffer.max(1))
                .subscriber_max_borrowed_samples(HELD)
                .history_size(1)
                .max_publishers(PORTS)
                .max_subscribers(PORTS)
                .max_nodes(2 * PORTS);
            match open(builder) {
                Ok(service) => break service,
                Err(error) if is_passing(&error) && tries < TRIES => {
                    tries += 1;
                    thread::sleep(PAUSE);
                }
                Err(error) => return Err(open_error(error, name, wanted)),
            }
        };
        Ok(Self {
            name: name.to_owned(),
            options,
            publisher: OnceCell::new(),
            subscriber: OnceCell::new(),
            ready: OnceCell::new(),
            told: Cell::new(0),
            service,
            node,
        })
    }

    /// The publisher port, made when it is first asked for.
    pub fn publisher(
        &self,
        finish: impl FnOnce(
            PortFactoryPublisher<'_, ipc::Service, P, H>,
        ) -> PortFactoryPublisher<'_, ipc::Service, P, H>,
    ) -> Result<&Publisher<ipc::Service, P, H>, TopicError> {
        if let Some(publisher) = self.publisher.get() {
            return Ok(publisher);
        }
        let patience = self.options.patience;
        let mut builder = self.service.publisher_builder().max_loaned_samples(HELD);
        if self.options.reliable {
            builder = builder
                .backpressure_strategy(BackpressureStrategy::RetryUntilDelivered)
                .set_backpressure_handler(move |info: &BackpressureInfo| {
                    if info.elapsed_time > patience {
                        return BackpressureAction::DiscardDataAndFail;
                    }
                    thread::sleep(Duration::from_micros(20));
                    BackpressureAction::Retry
                });
        }
        let publisher = finish(builder)
            .create()
            .map_err(|error| self.error("publish", error))?;
        Ok(self.publisher.get_or_init(|| publisher))
    }

    /// The subscriber port, made when it is first asked for, and connected to every publisher.
    pub fn subscriber(&self) -> Result<&Subscriber<ipc::Service, P, H>, TopicError> {
        let subscriber = match self.subscriber.get() {
            Some(subscriber) => subscriber,
            None => {
                let builder = self.service.subscriber_builder();
                let subscriber = builder.create().map_err(|error| self.error("subscribe", error))?;
                self.subscriber.get_or_init(|| subscriber)
            }
        };
        let publishers = self.publishers();
        if publishers != self.told.get() {
            subscriber
                .update_connections()
                .map_err(|error| self.error("connect", error))?;
            self.tell()?;
            self.told.set(publishers);
        }
        Ok(subscriber)
    }

    /// Number of publishers, those of killed processes that nobody has cleaned up included.
    pub fn number_of_publishers(&self) -> usize {
        self.service.dynamic_config().number_of_publishers()
    }

    /// Waits until `wanted` subscribers are connected, so that none misses what is sent next.
    pub fn wait_for_subscribers(&self, wanted: usize, patience: Duration) -> Result<(), TopicError> {
        let deadline = Instant::now() + patience;
        let listener = self.listener()?;
        let mut told = 0;
        loop {
            let ready = told.min(self.service.dynamic_config().number_of_subscribers());
            if ready >= wanted {
                return Ok(());
            }
            if Instant::now() >= deadline {
                return Err(TopicError::NoSubscribers {
                    topic: self.name.clone(),
                    ready,
                    wanted,
                });
            }
            listener
                // Those who told since the last look come as one event with a count.
                .timed_wait(|event| told += event.count as usize, PAUSE)
                .map_err(|error| self.error("wait for subscribers", error))?;
        }
    }

    /// Listens to subscribers from now on; to be called before the publisher is made.
    pub fn listen(&self) -> Result<(), TopicError> {
        self.listener().map(drop)
    }

    /// What the topic was opened with.
    pub fn options(&self) -> &TopicOptions {
        &self.options
    }

    /// Removes what killed processes left.
    pub fn clean(&self) {
        let _ = self.node.try_cleanup_dead_nodes();
    }

    /// What sending returned; a failure may come from a subscriber that was killed.
    pub fn sent(&self, result: Result<usize, SendError>) -> Result<usize, TopicError> {
        result.map_err(|error| {
            self.clean();
            self.error("send", error)
        })
    }

    pub fn error(&self, what: &'static str, reason: impl Debug) -> TopicError {
        TopicError::Use {
            what,
            topic: self.name.clone(),
            reason: format!("{reason:?}"),
        }
    }

    fn listener(&self) -> Result<&Listener<ipc::Service>, TopicError> {
        if let Some(listener) = self.ready.get() {
            return Ok(listener);
        }
        let event = self.ready_event()?;
        let listener = event
            .listener_builder()
            .create()
            .map_err(|error| self.error("listen", error))?;
        Ok(self.ready.get_or_init(|| listener))
    }

    /// Tells publishers that this subscriber is connected.
    fn tell(&self) -> Result<(), TopicError> {
        let event = self.ready_event()?;
        let notifier = event
            .notifier_builder()
            .create()
            .map_err(|error| self.error("connect", error))?;
        notifier.notify().map_err(|error| self.error("connect", error))?;
        Ok(())
    }

    fn ready_event(
        &self,
    ) -> Result<iceoryx2::service::port_factory::event::PortFactory<ipc::Service>, TopicError> {
        let name = service_name(&format!("{}/ready", self.name))?;
        let mut tries = 0;
        loop {
            let event = self.node.service_builder(&name).event();
            let event = event
                .max_listeners(PORTS)
                .max_notifiers(PORTS)
                .max_nodes(2 * PORTS)
                .open_or_create();
            match event {
                Ok(event) => return Ok(event),
                Err(_) if tries < TRIES => {
                    tries += 1;
                    thread::sleep(PAUSE);
                }
                Err(error) => return Err(self.error("connect", error)),
            }
        }
    }

    /// A number that differs where the publishers do.
    fn publishers(&self) -> u128 {
        let mut sum = 0u128;
        self.service.dynamic_config().list_publishers(|publisher| {
            sum = sum.wrapping_add(publisher.publisher_id.value());
            CallbackProgression::Continue
        });
        sum
    }
}

/// A node that leaves signals alone: the command line has its own handlers.
pub(super) fn node(config: &Config, topic: &str) -> Result<Node<ipc::Service>, TopicError> {
    NodeBuilder::new()
        .config(config)
        .signal_handling_mode(SignalHandlingMode::Disabled)
        .create::<ipc::Service>()
        .map_err(|error| TopicError::Open {
            topic: topic.to_owned(),
            reason: format!("{error:?}"),
        })
}

fn service_name(name: &str) -> Result<ServiceName, TopicError> {
    let refuse = || TopicError::Name {
        what: "topic",
        name: name.to_owned(),
    };
    if name.is_empty() {
        return Err(refuse());
    }
    ServiceName::new(name).map_err(|_| refuse())
}

/// Whether the service is just being created or removed by another process.
fn is_passing(error: &PublishSubscribeOpenOrCreateError) -> bool {
    use PublishSubscribeCreateError as Create;
    use PublishSubscribeOpenError as Open;
    match error {
        PublishSubscribeOpenOrCreateError::PublishSubscribeOpenError(error) => matches!(
            error,
            Open::IsMarkedForDestruction
                | Open::HangsInCreation
                | Open::DoesNotExist
                | Open::ServiceInCorruptedState
                | Open::UnableToCreateServiceTag
        ),
        PublishSubscribeOpenOrCreateError::PublishSubscribeCreateError(error) => matches!(
            error,
            Create::AlreadyExists | Create::IsBeingCreatedByAnotherInstance | Create::HangsInCreation
        ),
        _ => true,
    }
}

fn open_error(error: PublishSubscribeOpenOrCreateError, topic: &str, wanted: &'static str) -> TopicError {
    use PublishSubscribeOpenError as Open;
    let (topic, reason) = (topic.to_owned(), format!("{error:?}"));
    let PublishSubscribeOpenOrCreateError::PublishSubscribeOpenError(error) = error else {
        return TopicError::Open { topic, reason };
    };
    match error {
        Open::IncompatibleTypes | Open::IncompatibleMessagingPattern => TopicError::Type { topic, wanted },
        Open::DoesNotSupportRequestedMinBufferSize
        | Open::DoesNotSupportRequestedMinHistorySize
        | Open::DoesNotSupportRequestedMinSubscriberBorrowedSamples
        | Open::IncompatibleOverflowBehavior => TopicError::Options { topic, reason },
        _ => TopicError::Open { topic, reason },
    }
}
