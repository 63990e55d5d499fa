//! Subscribers that come late or are slow.

use std::time::Instant;

use horus_host::topic::{GridHeader, SliceTopic, Topic, TopicError, kind};

use crate::grids::{Grid, TOPIC, intact, options, send};
use crate::peer::{PATIENCE, TestDomain, domain, until};

/// The numbers in a line like `[1, 2, 3]`.
fn numbers(line: &str) -> Vec<u64> {
    let list = line.trim_matches(['[', ']']);
    list.split(", ").map(|number| number.parse().unwrap()).collect()
}

#[test]
fn who_comes_late_gets_the_last_message() {
    let domain = TestDomain::new("late");
    let topic: Topic<Grid> = Topic::open(&domain.0, TOPIC, options(false)).unwrap();
    for n in 0..5 {
        assert_eq!(send(&topic, n).unwrap(), 0, "nobody listens");
    }
    let mut late = domain.start("grids::subscriber", &[("LAST", "5")]);
    topic.wait_for_subscribers(1, PATIENCE).unwrap();
    assert_eq!(send(&topic, 5).unwrap(), 1);
    assert_eq!(numbers(&late.line("received ")), [4, 5]);
    late.join();
}

#[test]
fn who_is_slow_loses_the_oldest_and_holds_nobody_up() {
    let domain = TestDomain::new("slow");
    let topic: Topic<Grid> = Topic::open(&domain.0, TOPIC, options(false)).unwrap();
    let mut slow = domain.start("grids::subscriber", &[("LAST", "299"), ("PERIOD_US", "20000")]);
    topic.wait_for_subscribers(1, PATIENCE).unwrap();
    let start = Instant::now();
    for n in 0..300 {
        assert_eq!(send(&topic, n).unwrap(), 1);
    }
    let seconds = start.elapsed().as_secs_f64();
    let received = numbers(&slow.line("received "));
    slow.join();
    assert!(seconds < 300.0 * 0.02, "{seconds} s: the publisher was held up");
    assert!(received.is_sorted() && received.len() < 300, "{received:?}");
    assert_eq!(
        received[received.len() - 8..],
        [292, 293, 294, 295, 296, 297, 298, 299]
    );
}

#[test]
fn nothing_is_lost_on_a_reliable_topic() {
    let domain = TestDomain::new("reliable");
    let topic: Topic<Grid> = Topic::open(&domain.0, TOPIC, options(true)).unwrap();
    let role = [("LAST", "99"), ("PERIOD_US", "2000"), ("RELIABLE", "1")];
    let mut slow = [
        domain.start("grids::subscriber", &role),
        domain.start("grids::subscriber", &role),
    ];
    topic.wait_for_subscribers(2, PATIENCE).unwrap();
    for n in 0..100 {
        assert_eq!(send(&topic, n).unwrap(), 2);
    }
    for peer in &mut slow {
        assert_eq!(numbers(&peer.line("received ")), (0..100).collect::<Vec<_>>());
    }
    slow.into_iter().for_each(crate::peer::Peer::join);
}

#[test]
fn subscribers_that_come_at_once_are_all_counted() {
    let domain = TestDomain::new("at_once");
    let open = || -> Topic<Grid> { Topic::open(&domain.0, TOPIC, options(true)).unwrap() };
    let topic = open();
    let nobody = topic.wait_for_subscribers(1, std::time::Duration::from_millis(1));
    assert!(nobody.is_err());
    let subscribers = [open(), open(), open()];
    for subscriber in &subscribers {
        subscriber.recv().unwrap(); // connects
    }
    // All have told before the publisher looks.
    topic
        .wait_for_subscribers(3, std::time::Duration::from_millis(500))
        .unwrap();
}

#[test]
fn waiting_for_subscribers_ends() {
    let domain = TestDomain::new("nobody");
    let topic: Topic<Grid> = Topic::open(&domain.0, TOPIC, options(true)).unwrap();
    let refused = topic.wait_for_subscribers(1, std::time::Duration::from_millis(50));
    assert!(matches!(
        refused,
        Err(TopicError::NoSubscribers {
            ready: 0,
            wanted: 1,
            ..
        })
    ));
    assert_eq!(send(&topic, 0).unwrap(), 0, "and nothing is broken");
}

#[test]
fn messages_that_are_held_stay_as_they_are() {
    let domain = TestDomain::new("held");
    let topic: Topic<Grid> = Topic::open(&domain.0, TOPIC, options(false)).unwrap();
    let listener: Topic<Grid> = Topic::open(&domain.0, TOPIC, options(false)).unwrap();
    assert!(listener.recv().unwrap().is_none());
    let mut held = Vec::new();
    for n in 0..200 {
        send(&topic, n).unwrap();
        if n < 4 {
            held.push(listener.recv().unwrap().unwrap());
        }
    }
    for (n, message) in (0..).zip(&held) {
        assert_eq!(intact(message), n);
    }
    assert!(listener.recv().is_err(), "a fifth cannot be held");
    held.clear();
    assert_eq!(intact(&listener.recv().unwrap().unwrap()), 192);
}

/// A grid of any size.
fn header(width: u32, height: u32, n: u64) -> GridHeader {
    GridHeader {
        timestamp_ns: n,
        resolution: 0.1,
        width,
        height,
        ..GridHeader::default()
    }
}

#[test]
fn slices_have_any_size() {
    let domain = TestDomain::new("slices");
    let topic: SliceTopic<kind::Costs> = SliceTopic::open(&domain.0, "costs", options(true)).unwrap();
    let echo = domain.start("flow::echo", &[]);
    topic.wait_for_subscribers(1, PATIENCE).unwrap();
    let back: SliceTopic<kind::Costs> = SliceTopic::open(&domain.0, "back", options(true)).unwrap();
    for n in 0..60u64 {
        let (width, height) = (1 + 37 * (n as u32 % 20), 1 + 11 * (n as u32 % 7));
        let header = header(width, height, n);
        let mut loan = topic.loan(header, 9).unwrap();
        for (i, cost) in loan.elements_mut().iter_mut().enumerate() {
            assert_eq!(*cost, 9);
            *cost = (i as u64 ^ n) as u8;
        }
        loan.send().unwrap();
        let answer = until(|| back.recv().unwrap());
        assert_eq!(*answer.header(), header);
        assert_eq!(answer.elements().len(), (width * height) as usize);
        let expected = (0u64..).map(|i| !((i ^ n) as u8));
        assert!(
            answer
                .elements()
                .iter()
                .copied()
                .zip(expected)
                .all(|(a, b)| a == b),
            "grid {n}"
        );
    }
    let short = back.send(header(2, 2, 0), &[1, 2, 3]);
    assert!(matches!(short, Err(TopicError::TooLong { len: 3, capacity: 4 })));
    echo.join();
}

/// Sends every slice back with its bytes inverted.
#[test]
#[ignore = "a role, not a test"]
fn echo() {
    let topic: SliceTopic<kind::Costs> = SliceTopic::open(&domain(), "costs", options(true)).unwrap();
    let back: SliceTopic<kind::Costs> = SliceTopic::open(&domain(), "back", options(true)).unwrap();
    for n in 0..60 {
        let message = until(|| topic.recv().unwrap());
        assert_eq!(message.header().timestamp_ns, n);
        if n == 0 {
            back.wait_for_subscribers(1, PATIENCE).unwrap();
        }
        let inverted: Vec<u8> = message.elements().iter().map(|cost| !cost).collect();
        back.send(*message.header(), &inverted).unwrap();
    }
}
