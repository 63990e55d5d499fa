//! Undamaged streams.

use horus_core::frames::{MAX_FRAME, MIN_BUFFER, StreamOptions};
use horus_core::prelude::*;
use horus_host::frames::{StreamReader, StreamedTick};
use proptest::prelude::*;

use crate::op::{Op, op};
use crate::pair::{Buffers, Pair, Setup};
use crate::sender::{Sent, bits, send};

/// Panics unless a tick that was read is the one that was sent.
pub fn check(sent: &Sent, read: &StreamedTick) {
    assert_eq!(read.stamp_ns, sent.stamp_ns);
    assert_eq!((bits(read.robot), bits(read.sensor)), (sent.pose, sent.pose));
    let ranges: Vec<u32> = read.ranges.iter().map(|range| range.to_bits()).collect();
    assert_eq!(ranges, sent.ranges);
    if let Some(maps) = &read.maps {
        assert_eq!(maps.offset, sent.offset);
        assert_eq!(maps.occupancy, sent.cells);
        assert_eq!(maps.costs, sent.costs);
    } else {
        assert!(!sent.is_key, "a key tick has maps");
    }
}

fn options() -> impl Strategy<Value = StreamOptions<'static>> {
    (0..6u32, 0..4u32, 0..3u32).prop_map(|(key_every, maps_every, checksum_every)| StreamOptions {
        key_every,
        maps_every,
        checksum_every,
        ..StreamOptions::default()
    })
}

fn params() -> impl Strategy<Value = CostParams> {
    prop_oneof![
        Just(CostParams::default()),
        Just(CostParams::horus()),
        Just(CostParams::nav2()),
        Just(CostParams {
            inflate_unknown: true,
            ..CostParams::nav2()
        }),
    ]
}

fn setup() -> impl Strategy<Value = Setup> {
    let size = prop_oneof![(1..40u32, 1..40u32), (1..4u32, 1..300u32), (1..300u32, 1..4u32)];
    (size, params()).prop_map(|((width, height), params)| Setup {
        width,
        height,
        resolution: 0.05,
        origin: Pose2D::new(-0.5, 0.25, 0.3),
        params,
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..ProptestConfig::default() })]

    #[test]
    fn every_tick_arrives_as_it_was_sent(
        (setup, ops) in setup().prop_flat_map(|setup| {
            let ops = prop::collection::vec(op(setup.width, setup.height), 1..60);
            (Just(setup), ops)
        }),
        kept: bool,
        options in options(),
        buffer in prop_oneof![Just(MIN_BUFFER), MIN_BUFFER..2 * MAX_FRAME],
        block in 1..5000usize,
    ) {
        let mut buffers = Buffers::<u8>::new(setup.width, setup.height, kept);
        let mut pair = Pair::new(&mut buffers, &setup).unwrap();
        let (wire, sent) = send(&mut pair, &ops, options, buffer);
        let mut reader = StreamReader::new(Blocks { bytes: &wire, block });
        for sent in &sent {
            let read = reader.next_tick().unwrap().expect("a tick");
            check(sent, &read);
            assert_eq!(read.session.config.params, setup.params);
            assert_eq!(read.session.origin, setup.origin);
        }
        assert_eq!(reader.next_tick().unwrap(), None);
        assert!(reader.problems().is_empty(), "{}", reader.problems());
        assert_eq!(reader.skipped_ticks(), 0);
        assert_eq!(reader.bytes(), wire.len() as u64);
    }
}

/// Hands bytes out in blocks.
struct Blocks<'a> {
    bytes: &'a [u8],
    block: usize,
}

impl std::io::Read for Blocks<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let n = self.block.min(buffer.len());
        self.bytes.read(&mut buffer[..n])
    }
}

#[test]
fn changed_parameters_bring_a_key_tick() {
    use horus_core::frames::{MapStream, StreamTick};
    let setup = Setup {
        width: 30,
        height: 20,
        resolution: 0.05,
        origin: Pose2D::default(),
        params: CostParams::default(),
    };
    let mut buffers = Buffers::<u8>::new(setup.width, setup.height, false);
    let mut pair = Pair::new(&mut buffers, &setup).unwrap();
    let mut wire = Vec::new();
    let mut buffer = [0; MIN_BUFFER];
    let options = StreamOptions {
        key_every: 0,
        ..StreamOptions::default()
    };
    let mut stream =
        MapStream::new_in(&mut buffer, |frame: &[u8]| wire.extend_from_slice(frame), options).unwrap();
    let map = &mut pair.core;
    map.set_occupancy(7, 7, 100);
    let tick = |stamp_ns, costs_changed| StreamTick {
        stamp_ns,
        robot: Pose2D::default(),
        sensor: Pose2D::default(),
        scan: LaserScan {
            angle_min: 0.0,
            angle_increment: 0.0,
            range_min: 0.0,
            range_max: 0.0,
            ranges: &[],
        },
        changed: costs_changed,
        costs_changed,
    };
    let changed = map.update_costs();
    assert!(stream.tick(map, &tick(0, changed)));
    assert!(!stream.tick(map, &tick(1, None)));
    map.set_params(CostParams::nav2()).unwrap();
    assert!(stream.tick(map, &tick(2, None)));
    assert!(!stream.tick(map, &tick(3, None)));
    stream.request_key();
    assert!(stream.tick(map, &tick(4, None)));
    let mut reader = StreamReader::new(&wire[..]);
    let mut lethal = Vec::new();
    while let Some(tick) = reader.next_tick().unwrap() {
        lethal.push(tick.maps.unwrap().costs[7 * 30 + 7]);
    }
    assert_eq!(lethal, [253, 253, 254, 254, 254]);
    assert!(reader.problems().is_empty(), "{}", reader.problems());

    // A key tick without its session, whose parameters are new, is of no use.
    let is_session = |at: &usize| wire[*at..].starts_with(&[0xc1, 0xfa, 1, 1]);
    let second = (0..wire.len()).filter(is_session).nth(1).unwrap();
    let len = 14 + usize::from(wire[second + 8]);
    let without = [&wire[..second], &wire[second + len..]].concat();
    let mut reader = StreamReader::new(&without[..]);
    let mut told = Vec::new();
    while let Some(tick) = reader.next_tick().unwrap() {
        told.push((tick.stamp_ns, tick.session.config.params.lethal_cost));
    }
    assert_eq!(told, [(0, 253), (1, 253), (4, 254)]);
    assert_eq!(reader.skipped_ticks(), 2);
}

#[test]
fn operations_make_ticks() {
    // What the property above rests on: a run of operations is a run of ticks with maps in them.
    let setup = Setup {
        width: 60,
        height: 50,
        resolution: 0.05,
        origin: Pose2D::default(),
        params: CostParams::default(),
    };
    let mut buffers = Buffers::<u8>::new(setup.width, setup.height, false);
    let mut pair = Pair::new(&mut buffers, &setup).unwrap();
    let ops = [
        Op::Block {
            gx: 3,
            gy: 4,
            size: 5,
            value: 100,
        },
        Op::Update,
        Op::Move { dx: 3.0, dy: -2.0 },
        Op::Update,
    ];
    let (_, sent) = send(&mut pair, &ops, StreamOptions::default(), MIN_BUFFER);
    let keys: Vec<bool> = sent.iter().map(|sent| sent.is_key).collect();
    assert_eq!(keys, [true, false, false]);
    assert_ne!(sent[1].offset, sent[2].offset);
    assert!(sent[2].costs.contains(&253) && sent[2].costs.contains(&255));
}
