//! Processes that are killed.

use std::time::{Duration, Instant};

use horus_host::topic::{OccupancyGridMsg, PoseMsg, Topic};

use crate::grids::{Grid, TOPIC, intact, options, send};
use crate::peer::{PATIENCE, TestDomain, until};

#[test]
fn a_publisher_is_killed_and_started_again() {
    let domain = TestDomain::new("killed");
    let topic: Topic<Grid> = Topic::open(&domain.0, TOPIC, options(false)).unwrap();
    assert!(topic.recv().unwrap().is_none());
    for round in 0..6u64 {
        let first = (round * 1_000_000).to_string();
        let publisher = domain.start(
            "grids::publisher",
            &[("FIRST", &first), ("COUNT", "1000000"), ("PERIOD_US", "50")],
        );
        let next = |newest: u64| {
            until(|| {
                let message = topic.recv().unwrap()?;
                let n = intact(&message);
                (n >= newest).then_some((n, message))
            })
        };
        // Many messages of this round, then one that is held while the process dies in the middle of
        // whatever it is doing.
        let (n, held) = next(round * 1_000_000 + 50);
        std::thread::sleep(Duration::from_millis(round));
        publisher.kill();
        assert_eq!(intact(&held), n, "what was received outlives its publisher");
        drop(held);
        while let Some(message) = topic.recv().unwrap() {
            assert!(intact(&message) < (round + 1) * 1_000_000);
        }
    }
}

#[test]
fn a_killed_subscriber_holds_a_reliable_publisher_up_only_once() {
    let domain = TestDomain::new("gone");
    let topic: Topic<Grid> = Topic::open(&domain.0, TOPIC, options(true)).unwrap();
    let role = [("LAST", "1000000"), ("RELIABLE", "1")];
    let mut doomed = domain.start("grids::subscriber", &role);
    doomed.line("ready");
    topic.wait_for_subscribers(1, PATIENCE).unwrap();
    assert_eq!(send(&topic, 0).unwrap(), 1);
    doomed.kill();
    let start = Instant::now();
    let refused = (1..40).filter(|&n| send(&topic, n).is_err()).count();
    assert!(refused <= 1, "{refused} refused");
    assert!(start.elapsed() < Duration::from_secs(3), "{:?}", start.elapsed());

    // The next one gets everything that is sent from then on.
    let mut next = domain.start("grids::subscriber", &[("LAST", "59"), ("RELIABLE", "1")]);
    next.line("ready");
    until(|| topic.wait_for_subscribers(1, Duration::from_millis(100)).ok());
    for n in 40..60 {
        send(&topic, n).unwrap();
    }
    let received = next.line("received ");
    assert!(received.ends_with("56, 57, 58, 59]"), "{received}");
    next.join();
}

#[test]
fn what_killed_processes_leave_does_not_block_another_type() {
    let domain = TestDomain::new("stale");
    for _ in 0..3 {
        let mut publisher = domain.start("grids::publisher", &[("COUNT", "1000000"), ("PERIOD_US", "100")]);
        publisher.line("ready");
        let mut subscriber = domain.start("grids::subscriber", &[("LAST", "100000000")]);
        subscriber.line("ready");
        std::thread::sleep(Duration::from_millis(30));
        subscriber.kill();
        publisher.kill();
        // Each of them would be refused if the one before were still there.
        let grid: Topic<OccupancyGridMsg<16>> = Topic::open(&domain.0, TOPIC, options(true)).unwrap();
        drop(grid);
        let pose: Topic<PoseMsg> = Topic::open(&domain.0, TOPIC, options(false)).unwrap();
        assert_eq!(pose.send(PoseMsg::default()).unwrap(), 0);
    }
}
