//! Damaged streams: what arrives was sent, what is missing is told.

use std::collections::BTreeMap;

use horus_core::frames::{MIN_BUFFER, StreamOptions};
use horus_core::prelude::*;
use horus_host::frames::{ProblemKind, StreamReader, StreamedTick};

use crate::op::{Op, Scan};
use crate::pair::{Buffers, Pair, Setup};
use crate::round_trip::check;
use crate::sender::{Sent, send};

/// A stream of 45 ticks, each fifth of them a key tick, and where its frames start.
fn stream() -> (Vec<u8>, Vec<Sent>, Vec<usize>) {
    let setup = Setup {
        width: 50,
        height: 40,
        resolution: 0.05,
        origin: Pose2D::new(-1.0, -1.0, 0.0),
        params: CostParams::default(),
    };
    let mut random = Random(7);
    let mut ops = Vec::new();
    for i in 0..45 {
        ops.push(Op::Scan(Scan {
            x: 0.0,
            y: 0.0,
            theta: 0.1 * i as f32,
            angle_min: -3.0,
            angle_increment: 0.1,
            ranges: (0..60).map(|_| 0.4 + random.below(300) as f32 * 0.01).collect(),
            model: ScanModel::Set,
        }));
        ops.push(match i % 3 {
            0 => Op::Update,
            1 => Op::UpdateWithin {
                extra: 3000,
                calls: 1,
            },
            _ => Op::Move { dx: 0.7, dy: -0.4 },
        });
    }
    let mut buffers = Buffers::<u8>::new(setup.width, setup.height, false);
    let mut pair = Pair::new(&mut buffers, &setup).unwrap();
    let options = StreamOptions {
        key_every: 5,
        checksum_every: 0, // sequence numbers and frame checksums must do
        ..StreamOptions::default()
    };
    let (wire, sent) = send(&mut pair, &ops, options, MIN_BUFFER);
    let mut starts = Vec::new();
    let mut at = 0;
    while at < wire.len() {
        if wire[at..].starts_with(&[0xc1, 0xfa]) {
            starts.push(at);
            at += 14 + usize::from(u16::from_le_bytes([wire[at + 8], wire[at + 9]]));
        } else {
            at += 1; // text
        }
    }
    assert!(sent.len() == 45 && starts.len() > 300, "{} frames", starts.len());
    (wire, sent, starts)
}

struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as usize % n.max(1)
    }
}

/// Reads a stream to its end.
fn read(wire: &[u8]) -> (Vec<StreamedTick>, StreamReader<&[u8]>) {
    let mut reader = StreamReader::with_cell_limit(wire, 1 << 16);
    let mut ticks = Vec::new();
    while let Some(tick) = reader.next_tick().unwrap() {
        ticks.push(tick);
    }
    (ticks, reader)
}

/// Every tick that was read was sent; the problems' kinds.
fn check_all(sent: &[Sent], wire: &[u8], what: &str) -> (usize, Vec<ProblemKind>) {
    let (ticks, reader) = read(wire);
    let by_stamp: BTreeMap<u64, &Sent> = sent.iter().map(|sent| (sent.stamp_ns, sent)).collect();
    for tick in &ticks {
        check(by_stamp[&tick.stamp_ns], tick);
    }
    let kinds: Vec<ProblemKind> = reader.problems().iter().map(|(kind, _)| kind).collect();
    for (_, problem) in reader.problems().iter() {
        assert!(problem.count > 0 && problem.first_at_byte <= wire.len() as u64);
    }
    if ticks.len() < sent.len() {
        // Only a stream that was cut between two ticks is missing something without a trace.
        let is_prefix = sent.iter().any(|sent| sent.bytes[0] == wire.len());
        assert!(
            is_prefix || !kinds.is_empty(),
            "{what}: {} ticks and no problem",
            ticks.len()
        );
    }
    (ticks.len(), kinds)
}

#[test]
fn the_undamaged_stream_is_whole() {
    let (wire, sent, _) = stream();
    assert_eq!(check_all(&sent, &wire, "nothing"), (45, vec![]));
}

#[test]
fn thousands_of_damages_never_make_a_wrong_map() {
    let (wire, sent, starts) = stream();
    let mut random = Random(0x1234_5678_9abc);
    let mut seen: BTreeMap<ProblemKind, u32> = BTreeMap::new();
    let mut arrived = 0;
    let end_of = |frame: usize| starts.get(frame + 1).copied().unwrap_or(wire.len());
    for round in 0..4000 {
        let mut damaged = wire.clone();
        let mut what = String::new();
        for _ in 0..=random.below(3) {
            let at = random.below(damaged.len());
            let most = if random.below(4) == 0 { 2000 } else { 12 };
            let n = 1 + random.below(most);
            let end = (at + n).min(damaged.len());
            let frame = random.below(starts.len() - 2);
            let kind = if round % 2 == 0 {
                random.below(6)
            } else {
                6 + random.below(4)
            };
            what += &format!("{kind} at {at}+{n} frame {frame}; ");
            match kind {
                0 => damaged[at] ^= 1 << random.below(8),
                1 => damaged[at..end]
                    .iter_mut()
                    .for_each(|byte| *byte = random.below(256) as u8),
                2 => drop(damaged.drain(at..end)),
                3 => damaged.truncate(at.max(1)),
                4 => {
                    let noise: Vec<u8> = (0..n).map(|_| random.below(256) as u8).collect();
                    damaged.splice(at..at, noise);
                }
                5 => {
                    let part = damaged[at..end].to_vec();
                    damaged.splice(at..at, part);
                }
                // Whole frames, where the stream is still as long as it was.
                _ if damaged.len() != wire.len() => {}
                6 => drop(damaged.drain(starts[frame]..starts[frame + 1])),
                7 => {
                    let part = damaged[starts[frame]..starts[frame + 1]].to_vec();
                    damaged.splice(starts[frame]..starts[frame], part);
                }
                8 => damaged[starts[frame]..end_of(frame + 1)].rotate_left(starts[frame + 1] - starts[frame]),
                _ => {
                    let other = random.below(starts.len() - 1);
                    let part = wire[starts[other]..end_of(other)].to_vec();
                    damaged.splice(starts[frame]..starts[frame], part);
                }
            }
        }
        let (ticks, kinds) = check_all(&sent, &damaged, &what);
        arrived += ticks;
        kinds
            .into_iter()
            .for_each(|kind| *seen.entry(kind).or_default() += 1);
    }
    assert!(arrived > 4000 * 30, "{arrived} ticks arrived");
    for kind in [
        ProblemKind::JoinedLate,
        ProblemKind::Corrupt,
        ProblemKind::Truncated,
        ProblemKind::Missing,
        ProblemKind::OutOfOrder,
        ProblemKind::Restarted,
    ] {
        assert!(seen.contains_key(&kind), "{kind:?} in {seen:?}");
    }
}

#[test]
fn each_kind_of_damage_is_told_with_its_place() {
    let (wire, sent, starts) = stream();
    let problem = |wire: &[u8], kind| {
        let (ticks, reader) = read(wire);
        assert_eq!(check_all(&sent, wire, "one damage").0, ticks.len());
        let problem = reader
            .problems()
            .get(kind)
            .unwrap_or_else(|| panic!("{}", reader.problems()));
        (ticks.len(), problem.count, problem.first_at_byte)
    };
    let with = |change: &dyn Fn(&mut Vec<u8>)| {
        let mut damaged = wire.clone();
        change(&mut damaged);
        damaged
    };
    // The frames of tick 12: those up to the key tick 15 are dropped.
    let first = starts
        .iter()
        .position(|start| *start >= sent[12].bytes[0])
        .unwrap();
    let at = starts[first + 1];
    let here = at as u64;

    let flipped = with(&|wire| wire[at + 20] ^= 4);
    assert_eq!(problem(&flipped, ProblemKind::Corrupt), (42, 1, here));
    assert_eq!(
        problem(&flipped, ProblemKind::Missing),
        (42, 1, starts[first + 2] as u64)
    );
    let long = with(&|wire| wire[at + 9] ^= 0x80);
    assert_eq!(problem(&long, ProblemKind::Corrupt), (42, 1, here));
    let unsynced = with(&|wire| wire[at] = b'?');
    assert_eq!(
        problem(&unsynced, ProblemKind::Missing),
        (42, 1, starts[first + 2] as u64)
    );
    let twice = with(&|bytes| {
        let frame = wire[at..starts[first + 2]].to_vec();
        drop(bytes.splice(at..at, frame));
    });
    let (all, second) = (45, starts[first + 2] as u64);
    assert_eq!(
        problem(&twice, ProblemKind::OutOfOrder),
        (all, 1, second),
        "nothing is lost"
    );
    let cut = &wire[..at + 5];
    assert_eq!(
        problem(cut, ProblemKind::Truncated),
        (12, 2, here),
        "frame and tick"
    );
    assert_eq!(
        problem(&wire[..at], ProblemKind::Truncated),
        (12, 1, here),
        "the tick"
    );
    assert_eq!(problem(&wire[at..], ProblemKind::JoinedLate), (30, 1, 0));
    let restarted = [&wire[..at], &wire[..]].concat();
    assert_eq!(problem(&restarted, ProblemKind::Restarted), (12 + 45, 1, here));
}

/// A frame with these contents and the right checksum.
fn frame(version: u8, kind: u8, sequence: u32, payload: &[u8]) -> Vec<u8> {
    let mut frame = vec![0xc1, 0xfa, version, kind];
    frame.extend(sequence.to_le_bytes());
    frame.extend((payload.len() as u16).to_le_bytes());
    frame.extend(payload);
    let mut crc = u32::MAX;
    for byte in &frame[2..] {
        crc ^= u32::from(*byte);
        for _ in 0..8 {
            crc = (crc >> 1) ^ (0xedb8_8320 * (crc & 1));
        }
    }
    frame.extend((!crc).to_le_bytes());
    frame
}

#[test]
fn frames_that_are_sound_but_impossible_are_told_apart() {
    let (wire, sent, starts) = stream();
    let first = starts
        .iter()
        .position(|start| *start >= sent[12].bytes[0])
        .unwrap();
    let at = starts[first];
    let sequence = first as u32;
    // The frame takes the place of the first of tick 12.
    let replaced = |frame: Vec<u8>| [&wire[..at], &frame, &wire[starts[first + 1]..]].concat();
    let kinds = |wire: &[u8]| check_all(&sent, wire, "an impossible frame");
    let payload = |frame: usize| wire[starts[frame] + 10..starts[frame + 1] - 4].to_vec();
    let start = payload(first);

    let unknown = kinds(&replaced(frame(1, 99, sequence, &[1, 2, 3])));
    assert_eq!(
        unknown,
        (42, vec![ProblemKind::UnknownKind, ProblemKind::Inconsistent])
    );
    let newer = kinds(&replaced(frame(2, 2, sequence, &start)));
    assert_eq!(newer, (42, vec![ProblemKind::UnknownVersion]));
    let short = kinds(&replaced(frame(1, 2, sequence, &start[1..])));
    assert_eq!(short, (42, vec![ProblemKind::Malformed]));
    let mut nan = start.clone();
    nan[9..13].copy_from_slice(&f32::NAN.to_le_bytes());
    assert_eq!(
        kinds(&replaced(frame(1, 2, sequence, &nan))),
        (42, vec![ProblemKind::Malformed])
    );
    let mut far = start.clone();
    far[33..37].copy_from_slice(&i32::MAX.to_le_bytes());
    assert_eq!(
        kinds(&replaced(frame(1, 2, sequence, &far))),
        (42, vec![ProblemKind::Malformed])
    );
    let end = kinds(&replaced(frame(1, 5, sequence, &[0])));
    assert_eq!(
        end,
        (42, vec![ProblemKind::Inconsistent]),
        "an end without a start"
    );
    let session = kinds(&replaced(frame(1, 1, sequence, &payload(0))));
    assert_eq!(
        session,
        (42, vec![ProblemKind::Inconsistent]),
        "a tick without a start"
    );
    let mut huge = payload(0);
    huge[..8].fill(0xff);
    assert_eq!(
        kinds(&replaced(frame(1, 1, sequence, &huge))),
        (42, vec![ProblemKind::Malformed])
    );

    // A checksum that is not the map's, in the place of the tick's end.
    let last = starts
        .iter()
        .position(|start| *start >= sent[12].bytes[1])
        .unwrap()
        - 1;
    let wrong = frame(1, 5, last as u32, &[1, 0, 0, 0, 0, 0, 0, 0, 0]);
    let wrong = [&wire[..starts[last]], &wrong, &wire[starts[last + 1]..]].concat();
    assert_eq!(kinds(&wrong), (42, vec![ProblemKind::MapDiffers]));
}
