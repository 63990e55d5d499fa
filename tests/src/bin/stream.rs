//! Streams the first scripted drive on a 200 x 200 map as frames, the way firmware logs: over USART1 on
//! the target, to standard output on the host. The bytes are the same.
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::cell::Cell;

use horus_core::costmap::{CostMapBuffers, bit_words};
use horus_core::frames::MapStream;
use horus_core::prelude::*;
use horus_tests::Once;
use horus_tests::drive::{self, BEAMS};
use horus_tests::rt::{self, note};
use horus_tests::streaming;

horus_tests::start!(run);

/// Cells per side.
const SIDE: u32 = 200;
/// Bytes of the frame buffer.
const BUFFER: usize = 512;
type Buffers = CostMapBuffers<{ (SIDE * SIDE) as usize }, { bit_words(SIDE, SIDE) }>;

fn run() -> bool {
    match stream() {
        Ok(()) => true,
        Err(error) => {
            note!("stream: {}", error);
            false
        }
    }
}

fn stream() -> Result<(), Error> {
    static MAP: Once<Buffers> = Once::new(Buffers::empty());
    static LIDAR: Once<ScanBuffers<BEAMS, 0>> = Once::new(ScanBuffers::empty());
    // SAFETY: here only.
    let (map, lidar) = unsafe { (MAP.take(), LIDAR.take()) };
    let [scenario, ..] = drive::near_scenarios();

    let sent = Cell::new(0);
    let sink = |frame: &[u8]| {
        rt::send(frame);
        sent.set(sent.get() + frame.len());
    };
    let mut buffer = [0; BUFFER];
    let mut stream = MapStream::new_in(&mut buffer, sink, streaming::options(&scenario))?;
    let (mut keys, mut others) = (Sizes::default(), Sizes::default());
    drive::run(
        &scenario,
        SIDE,
        map.split(),
        &mut lidar.workspace(),
        |map, tick| {
            let before = sent.get();
            let is_key = stream.tick(map, &streaming::tick(map, tick));
            let sizes = if is_key { &mut keys } else { &mut others };
            sizes.add(sent.get() - before);
        },
    )?;
    note!(
        "bytes of {} key ticks: mean {}, most {}",
        keys.count,
        keys.mean(),
        keys.most
    );
    note!(
        "bytes of {} other ticks: mean {}, most {}",
        others.count,
        others.mean(),
        others.most
    );
    Ok(())
}

/// Bytes of ticks.
#[derive(Default)]
struct Sizes {
    count: usize,
    sum: usize,
    most: usize,
}

impl Sizes {
    fn add(&mut self, bytes: usize) {
        self.count += 1;
        self.sum += bytes;
        self.most = self.most.max(bytes);
    }

    fn mean(&self) -> usize {
        self.sum / self.count.max(1)
    }
}
