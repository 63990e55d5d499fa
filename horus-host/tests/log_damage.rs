//! Damaged logs: no panic, no abort, no memory the file does not warrant, no invented messages.
#[path = "log/samples.rs"]
mod samples;

use std::{
    alloc::{GlobalAlloc, Layout, System},
    sync::atomic::{AtomicUsize, Ordering},
};

use horus_host::log::{LogEntry, LogError, LogReader, ReadEnd};
use rand_pcg::{Pcg64Mcg, rand_core::RngCore};
use samples::*;

/// Counts allocated bytes, and the most there ever were.
struct Counting;

static NOW: AtomicUsize = AtomicUsize::new(0);
static PEAK: AtomicUsize = AtomicUsize::new(0);

// SAFETY: forwards to the system allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let now = NOW.fetch_add(layout.size(), Ordering::Relaxed) + layout.size();
        PEAK.fetch_max(now, Ordering::Relaxed);
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        NOW.fetch_sub(layout.size(), Ordering::Relaxed);
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Damaged copies of each log.
const ROUNDS: usize = 3000;

/// The record limit of these tests.
const LIMIT: usize = 1 << 20;

/// A log in `compression` with chunk checksums or without.
fn container(compression: Option<mcap::Compression>, checksums: bool) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut log = mcap::WriteOptions::new()
        .profile("ros2")
        .compression(compression)
        .compression_threads(0)
        .chunk_size(Some(2000))
        .calculate_chunk_crcs(checksums)
        .calculate_data_section_crc(checksums)
        .create(std::io::Cursor::new(&mut bytes))
        .unwrap();
    let (entries, _) = read(&sample(6));
    for entry in entries {
        let LogEntry::Message(message) = entry else {
            let metadata = mcap::records::Metadata {
                name: "horus".to_owned(),
                metadata: metadata(),
            };
            log.write_metadata(&metadata).unwrap();
            continue;
        };
        let channel = &message.channel;
        let schema = log.add_schema(&channel.type_name, "ros2msg", b"").unwrap();
        let id = log
            .add_channel(schema, &channel.topic, "cdr", &Default::default())
            .unwrap();
        let header = mcap::records::MessageHeader {
            channel_id: id,
            sequence: 0,
            log_time: message.log_time_ns,
            publish_time: message.publish_time_ns,
        };
        log.write_to_known_channel(&header, &message.payload).unwrap();
    }
    log.finish().unwrap();
    drop(log);
    bytes
}

fn read_limited(bytes: &[u8]) -> (Vec<LogEntry>, Result<ReadEnd, LogError>) {
    let mut reader = LogReader::with_record_limit(bytes, LIMIT);
    let mut entries = Vec::new();
    for entry in &mut reader {
        match entry {
            Ok(entry) => entries.push(entry),
            Err(error) => return (entries, Err(error)),
        }
    }
    (entries, Ok(reader.end().unwrap()))
}

/// One random damage: a bit flipped, a cut, bytes inserted, removed or overwritten, a length made
/// huge.
fn damage(bytes: &[u8], random: &mut Pcg64Mcg) -> Vec<u8> {
    let mut damaged = bytes.to_vec();
    let at = random.next_u64() as usize % bytes.len();
    let some = 1 + random.next_u32() as usize % 20;
    match random.next_u32() % 6 {
        0 => damaged[at] ^= 1 << (random.next_u32() % 8),
        1 => damaged.truncate(at),
        2 => {
            let extra: Vec<u8> = (0..some).map(|_| random.next_u32() as u8).collect();
            damaged.splice(at..at, extra);
        }
        3 => drop(damaged.drain(at..(at + some).min(bytes.len()))),
        4 => {
            let end = (at + some).min(bytes.len());
            damaged[at..end].fill_with(|| random.next_u32() as u8);
        }
        _ => {
            let lengths = [u64::MAX, 1 << 62, 1 << 40, 0xffff_ffff, LIMIT as u64];
            let length = lengths[random.next_u32() as usize % lengths.len()].to_le_bytes();
            let width = if random.next_u32().is_multiple_of(2) { 8 } else { 4 };
            let end = (at + width).min(bytes.len());
            damaged[at..end].copy_from_slice(&length[..end - at]);
        }
    }
    damaged
}

/// Damages `bytes` often; `verified` logs may lose messages but must never show a wrong one.
fn damage_often(bytes: &[u8], verified: bool, seed: u128) {
    let (whole, end) = read_limited(bytes);
    assert_eq!(end.unwrap(), ReadEnd::Complete);
    let mut random = Pcg64Mcg::new(seed);
    let (mut errors, mut invented) = (0, 0);
    for round in 0..ROUNDS {
        let damaged = damage(bytes, &mut random);
        let (entries, end) = read_limited(&damaged);
        if let Err(error) = &end {
            errors += 1;
            let text = error.to_string();
            let is_start = matches!(error, LogError::Empty | LogError::NotMcap);
            assert!(is_start || text.contains("at byte "), "round {round}: {text}");
        }
        if verified && matches!(end, Ok(ReadEnd::Complete)) {
            assert!(entries == whole, "round {round}: a wrong log passed as complete");
        }
        for entry in &entries {
            if let LogEntry::Message(message) = entry {
                // The bytes of a message may be anything where nothing verifies them.
                let _ = message.decode::<horus_host::log::msg::Grid>();
                let _ = message.decode::<horus_host::log::msg::TFMessage>();
                let is_known = whole.iter().any(|known| match known {
                    LogEntry::Message(known) => known.payload == message.payload,
                    LogEntry::Metadata { .. } => false,
                });
                // A chunk whose opcode became that of a message is noticed at the end of the data only.
                invented += usize::from(verified && !is_known);
                assert!(
                    !verified || is_known || end.is_err(),
                    "round {round}: an invented message"
                );
            }
        }
    }
    assert!(invented <= ROUNDS / 500, "{invented} invented messages");
    assert!(
        errors > ROUNDS / 4,
        "only {errors} of {ROUNDS} damaged logs were noticed"
    );
}

/// Most bytes allocated at once while `work` ran, beyond what there was before.
fn peak_of(work: impl FnOnce()) -> usize {
    let before = NOW.load(Ordering::Relaxed);
    PEAK.store(before, Ordering::Relaxed);
    work();
    PEAK.load(Ordering::Relaxed) - before
}

/// `bytes` with the eight bytes at `at` replaced by `length`.
fn with_length(bytes: &[u8], at: u64, length: u64) -> Vec<u8> {
    let mut damaged = bytes.to_vec();
    damaged[at as usize..][..8].copy_from_slice(&length.to_le_bytes());
    damaged
}

fn first_chunk(bytes: &[u8]) -> mcap::records::ChunkIndex {
    let summary = mcap::Summary::read(bytes).unwrap().unwrap();
    summary.chunk_indexes[0].clone()
}

/// A record that claims more than its uncompressed, unverified chunk holds.
fn a_record_cannot_reach_out_of_its_chunk() {
    let bytes = container(None, false);
    let chunk = first_chunk(&bytes);
    // Opcode, length, times, size, checksum, empty compression name, compressed size, opcode.
    let length_at = chunk.chunk_start_offset + 9 + 16 + 8 + 4 + 4 + 8 + 1;
    let damaged = with_length(&bytes, length_at, chunk.compressed_size - 8);
    let (entries, end) = read_limited(&damaged);
    assert_eq!(entries.len(), 1, "the metadata before the chunk");
    let offset = chunk.chunk_start_offset;
    let error = end.unwrap_err();
    assert!(
        matches!(error, LogError::Malformed { offset: at, .. } if at == offset),
        "{error}"
    );
}

/// A chunk that claims to decompress to more than the limit, with no checksum to catch it.
fn an_oversized_chunk_is_not_decompressed() {
    let bytes = container(Some(mcap::Compression::Zstd), false);
    let size_at = first_chunk(&bytes).chunk_start_offset + 9 + 16;
    let claimed = LIMIT as u64 + 1;
    let error = read_limited(&with_length(&bytes, size_at, claimed))
        .1
        .unwrap_err();
    let LogError::Damaged { source, .. } = error else {
        panic!("{error}");
    };
    assert!(
        matches!(source, mcap::McapError::ChunkTooLarge(size) if size == claimed),
        "{source}"
    );
}

/// Lengths up to the limit are believed only as far as there are bytes; longer ones not at all.
fn lengths_cost_nothing() {
    let bytes = sample(6);
    let chunk = first_chunk(&bytes);
    let length_at = chunk.chunk_start_offset + 1;
    let offset = chunk.chunk_start_offset;
    let within = with_length(&bytes, length_at, 60 << 20);
    let beyond = with_length(&bytes, length_at, 73 << 20);
    let peak = peak_of(|| {
        let end = read(&within).1.unwrap();
        assert_eq!(end, ReadEnd::Truncated { offset });
        let error = read(&beyond).1.unwrap_err();
        assert!(
            matches!(error, LogError::Damaged { offset: at, .. } if at == offset),
            "{error}"
        );
    });
    assert!(peak < 1 << 20, "reading took {peak} bytes");
}

// One test, so that nothing else allocates meanwhile.
#[test]
fn damaged_logs_end_in_an_error_or_early() {
    a_record_cannot_reach_out_of_its_chunk();
    an_oversized_chunk_is_not_decompressed();
    lengths_cost_nothing();
    let lz4 = Some(mcap::Compression::Lz4);
    let zstd = Some(mcap::Compression::Zstd);
    let logs = [
        (sample(6), true),
        (container(zstd, true), true),
        (container(lz4, true), true),
        (container(None, true), true),
        (container(zstd, false), false),
        (container(lz4, false), false),
        (container(None, false), false),
    ];
    let peak = peak_of(|| {
        for (seed, (bytes, verified)) in (1..).zip(&logs) {
            damage_often(bytes, *verified, seed);
        }
    });
    assert!(peak < 8 * LIMIT, "reading took {peak} bytes");
}
