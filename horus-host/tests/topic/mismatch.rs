//! Topics opened as something else than they are.

use horus_host::topic::{
    CostMapMsg, Domain, OccupancyGridMsg, PoseMsg, SliceTopic, Topic, TopicError, TopicOptions, kind,
};

use crate::grids::{Grid, TOPIC, options};
use crate::peer::TestDomain;

#[test]
fn another_type_or_size_is_refused() {
    let domain = TestDomain::new("mismatch");
    let mut publisher = domain.start("grids::publisher", &[("COUNT", "1000000"), ("PERIOD_US", "1000")]);
    publisher.line("ready");
    let domain = &domain.0;
    let refusals = [
        Topic::<PoseMsg>::open(domain, TOPIC, options(false)).err(),
        Topic::<OccupancyGridMsg<9_999>>::open(domain, TOPIC, options(false)).err(),
        Topic::<CostMapMsg<10_000>>::open(domain, TOPIC, options(false)).err(),
        SliceTopic::<kind::Occupancy>::open(domain, TOPIC, options(false)).err(),
    ];
    for refusal in refusals {
        assert!(matches!(refusal, Some(TopicError::Type { .. })), "{refusal:?}");
    }
    let other = Topic::<Grid>::open(domain, TOPIC, options(true)).err();
    assert!(matches!(other, Some(TopicError::Options { .. })), "{other:?}");
    let larger = TopicOptions {
        buffer: 9,
        ..options(false)
    };
    let other = Topic::<Grid>::open(domain, TOPIC, larger).err();
    assert!(matches!(other, Some(TopicError::Options { .. })), "{other:?}");
    assert!(Topic::<Grid>::open(domain, TOPIC, options(false)).is_ok());
    publisher.kill();
}

#[test]
fn names_are_checked() {
    for name in ["", "a b", "a/b", "é", &"x".repeat(33)] {
        assert!(
            matches!(Domain::new(name), Err(TopicError::Name { .. })),
            "{name}"
        );
    }
    let domain = TestDomain::new("names");
    for name in [String::new(), "x".repeat(1000)] {
        let topic = Topic::<PoseMsg>::open(&domain.0, &name, options(false)).err();
        assert!(matches!(topic, Some(TopicError::Name { .. })), "{topic:?}");
    }
}

#[test]
fn domains_do_not_meet() {
    let (a, b) = (TestDomain::new("apart_a"), TestDomain::new("apart_b"));
    let topic = Topic::<PoseMsg>::open(&a.0, "pose2d", options(false)).unwrap();
    let other = Topic::<Grid>::open(&b.0, "pose2d", options(false)).unwrap();
    assert!(other.recv().unwrap().is_none());
    assert_eq!(topic.send(PoseMsg::default()).unwrap(), 0);
}

#[test]
fn a_local_map_is_not_taken_for_costs() {
    let domain = TestDomain::new("local");
    let maps = SliceTopic::<kind::Local>::open(&domain.0, "bytes", options(false)).unwrap();
    let costs = SliceTopic::<kind::Costs>::open(&domain.0, "bytes", options(false)).err();
    assert!(matches!(costs, Some(TopicError::Type { .. })), "{costs:?}");
    drop(maps);
}
