//! Target `frames`: a map that is streamed arrives as it was, and whatever happens to the bytes, nothing
//! arrives that was not sent, in bounded memory.

mod map;
mod sound;

pub use map::{MapOp, StreamSetup};
pub use sound::SoundFrame;

use arbitrary::Arbitrary;
use horus_host::frames::{StreamReader, StreamedTick};

use crate::damage::Damage;
use crate::memory::peak_of;
use crate::sequence::{Rest, Short};

/// Most cells of a map.
const CELLS: usize = 4096;
/// What reading may allocate beside the map and a tick: the longest frame, a block, a scan.
const OVERHEAD: usize = 64 << 10;

/// A stream.
#[derive(Clone, Debug, Arbitrary)]
pub enum FramesCase {
    /// Any bytes.
    Bytes(Vec<u8>),
    /// Frames with any contents and the right checksum.
    Sound(Vec<SoundFrame>),
    /// A map's stream, maybe damaged.
    Streamed {
        /// How it is streamed.
        setup: StreamSetup,
        /// What happens to the stream.
        damages: Short<Damage, 4>,
        /// What happens to the map.
        ops: Rest<MapOp>,
    },
}

/// Runs a case; panics where writer or reader break their promises.
pub fn run(case: &FramesCase) {
    match case {
        FramesCase::Bytes(bytes) => {
            read(bytes);
        }
        FramesCase::Sound(frames) => {
            let mut sequence = 0u32;
            let mut bytes = Vec::new();
            for frame in frames {
                bytes.extend(frame.bytes(sequence));
                sequence = frame.next(sequence);
            }
            read(&bytes);
        }
        FramesCase::Streamed { setup, damages, ops } => streamed(setup, &damages.0, &ops.0),
    }
}

/// Every tick of a stream, read in bounded memory.
fn read(bytes: &[u8]) -> (Vec<StreamedTick>, bool) {
    let mut reader = StreamReader::with_cell_limit(bytes, CELLS);
    let mut ticks = Vec::new();
    loop {
        let mut next = None;
        let peak = peak_of(|| next = reader.next_tick().expect("memory can be read"));
        let bound = 16 * CELLS + 8 * bytes.len() + OVERHEAD;
        assert!(peak <= bound, "reading {} bytes took {peak}", bytes.len());
        match next {
            Some(tick) => ticks.push(tick),
            None => break,
        }
    }
    assert_eq!(reader.bytes(), bytes.len() as u64);
    assert!(reader.bytes_outside() <= bytes.len() as u64);
    (ticks, reader.problems().is_empty())
}

fn streamed(setup: &StreamSetup, damages: &[Damage], ops: &[MapOp]) {
    let (mut wire, shown) = map::write(setup, ops);
    let whole = wire.clone();
    damages.iter().for_each(|damage| damage.apply(&mut wire));
    let (ticks, is_sound) = read(&wire);
    for tick in &ticks {
        let expected = shown.get(&tick.stamp_ns).expect("a tick that was sent");
        if let Some(maps) = &tick.maps {
            assert_eq!(
                (maps.offset, &maps.occupancy, &maps.costs),
                (expected.offset, &expected.cells, &expected.costs)
            );
        }
    }
    if wire == whole {
        assert!(is_sound && ticks.len() == shown.len());
    }
}
