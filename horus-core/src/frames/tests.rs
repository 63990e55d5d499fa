//! The format itself, byte by byte; whole streams are tested against the listener in `tests/host/frames`.

extern crate std;
use std::vec;
use std::vec::Vec;

use super::crc::Crc32;
use super::packer::Packer;
use super::pending::Pending;
use super::row_coder::RowCoder;
use super::*;
use crate::costmap::CostParams;
use crate::error::{Buffer, Error};
use crate::geometry::{CellRect, Pose2D};
use crate::grid::ScanModel;

/// All frames of a rectangle of cells that starts at (0, 0) of a map just as large.
fn coded(cells: &[u8], width: usize, buffer: usize) -> Vec<Vec<u8>> {
    let mut frames = Vec::new();
    let mut buffer = vec![0; buffer];
    let mut packer = Packer::new(&mut buffer);
    let mut sink = |frame: &[u8]| frames.push(frame.to_vec());
    let rect = CellRect {
        x0: 0,
        y0: 0,
        x1: width as u32,
        y1: (cells.len() / width) as u32,
    };
    let mut coder = RowCoder::new(&mut packer, &mut sink, MapLayer::Costs, rect);
    let mut below: Option<&[u8]> = None;
    for row in cells.chunks(width) {
        coder.row(row.iter().copied(), below.map(|below| below.iter().copied()));
        below = Some(row);
    }
    coder.finish();
    frames
}

fn payload(frame: &[u8]) -> &[u8] {
    &frame[FrameHeader::PREFIX..frame.len() - FrameHeader::CRC_LEN]
}

/// The tokens of cells that fit one frame.
fn tokens(cells: &[u8], width: usize) -> Vec<u8> {
    let frames = coded(cells, width, MAX_FRAME);
    assert_eq!(frames.len(), 1);
    match Frame::read(FrameKind::Rows as u8, payload(&frames[0])) {
        Ok(Frame::Rows(part)) => part.tokens.to_vec(),
        other => panic!("{other:?}"),
    }
}

fn decoded(frames: &[Vec<u8>], cells: usize, width: usize) -> Vec<u8> {
    let mut map = vec![0xee; cells];
    let mut known = 0;
    for frame in frames {
        let Ok(Frame::Rows(part)) = Frame::read(FrameKind::Rows as u8, payload(frame)) else {
            panic!("no rows");
        };
        assert_eq!(part.start, known);
        let height = (cells / width) as u32;
        known = part.decode_into(&mut map, width as u32, height).unwrap();
    }
    assert_eq!(known as usize, cells);
    map
}

#[test]
fn the_checksum_is_the_one_of_ieee_802_3() {
    assert_eq!(Crc32::of(*b"123456789"), 0xcbf4_3926);
    assert_eq!(Crc32::of([]), 0);
}

#[test]
fn a_frame_is_laid_out_as_documented() {
    let mut sent = Vec::new();
    let mut buffer = [0; MIN_BUFFER];
    let mut writer = FrameWriter::new_in(&mut buffer, |frame: &[u8]| sent.push(frame.to_vec())).unwrap();
    writer.tick_end(TickEnd { checksum: None });
    writer.tick_end(TickEnd { checksum: None });
    assert_eq!(writer.frames(), 2);
    assert_eq!(sent[0][..11], [0xc1, 0xfa, 1, 5, 0, 0, 0, 0, 1, 0, 0]);
    assert_eq!(
        sent[0][11..],
        Crc32::of(sent[0][2..11].iter().copied()).to_le_bytes()
    );
    assert_eq!(sent[1][4..8], [1, 0, 0, 0]);
    let text = "any text, ü, €, 🤖";
    assert!(!text.bytes().any(|byte| SYNC.contains(&byte)));
}

#[test]
fn a_short_buffer_is_refused() {
    let mut buffer = [0; MIN_BUFFER - 1];
    let error = Error::BufferTooSmall {
        buffer: Buffer::Frame,
        needed: MIN_BUFFER,
        given: MIN_BUFFER - 1,
    };
    assert_eq!(FrameWriter::new_in(&mut buffer, |_: &[u8]| ()).err(), Some(error));
}

#[test]
fn the_longest_session_fits_the_shortest_buffer_and_long_names_are_cut() {
    let name = "é".repeat(40);
    let session = Session {
        width: u32::MAX,
        height: 7,
        resolution: 0.05,
        origin: Pose2D::new(1.0, -2.0, 0.5),
        params: CostParams::nav2(),
        model: ScanModel::accumulate(),
        mount: Pose2D::new(0.1, 0.0, 3.0),
        names: FrameNames {
            odom: &name,
            base: &name,
            sensor: "laser",
        },
    };
    let mut frame = Vec::new();
    let mut buffer = [0; MIN_BUFFER];
    let mut writer = FrameWriter::new_in(&mut buffer, |bytes: &[u8]| frame = bytes.to_vec()).unwrap();
    writer.session(&session);
    let Ok(Frame::Session(read)) = Frame::read(FrameKind::Session as u8, payload(&frame)) else {
        panic!("no session");
    };
    let cut = "é".repeat(16);
    let names = FrameNames {
        odom: &cut,
        base: &cut,
        ..session.names
    };
    assert_eq!(read, Session { names, ..session });
    // One byte more or less, and it is none.
    for payload in [&payload(&frame)[1..], &[payload(&frame), &[0]].concat()] {
        assert_eq!(Frame::read(1, payload), Err(Unreadable::Malformed));
    }
    assert_eq!(Frame::read(77, &[]), Err(Unreadable::UnknownKind));
}

#[test]
fn cells_become_the_documented_tokens() {
    assert_eq!(tokens(&[5], 1), [0x00, 5]);
    assert_eq!(tokens(&[5, 5], 2), [0x40, 5]);
    assert_eq!(tokens(&[1, 2, 3], 3), [0x02, 1, 2, 3]);
    assert_eq!(
        tokens(&[1, 2, 2, 3], 4),
        [0x03, 1, 2, 2, 3],
        "two stay in a literal"
    );
    assert_eq!(tokens(&[1, 2, 2, 2, 3], 5), [0x00, 1, 0x41, 2, 0x00, 3]);
    assert_eq!(
        tokens(&[1, 2, 1, 2], 2),
        [0x01, 1, 2, 0x81],
        "a row like the one below it"
    );
    assert_eq!(
        tokens(&[1, 2, 1, 9], 2),
        [0x03, 1, 2, 1, 9],
        "one cell is not worth a copy"
    );
    assert_eq!(tokens(&[4; 64], 64), [0x7e, 4]);
    assert_eq!(tokens(&[4; 65], 65), [0x7f, 0, 4]);
    assert_eq!(tokens(&[4; 200], 200), [0x7f, 0x87, 1, 4]);
    let stripes: Vec<u8> = (0..200).chain(0..200).map(|gx| gx as u8).collect();
    assert_eq!(tokens(&stripes, 200)[204..], [0xff, 72], "128 + 72 cells");
}

#[test]
fn no_cells_take_more_than_the_documented_bytes() {
    let mut noise = 1u32;
    for values in [2u32, 3, 5, 256] {
        for n in [1usize, 2, 3, 63, 64, 65, 129, 1000] {
            for width in [1, 7, n] {
                let cells: Vec<u8> = (0..n / width * width)
                    .map(|_| {
                        noise = noise.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                        ((noise >> 16) % values) as u8
                    })
                    .collect();
                if cells.is_empty() {
                    continue;
                }
                let tokens = tokens(&cells, width);
                assert!(tokens.len() <= cells.len() + cells.len().div_ceil(64));
                for buffer in [MIN_BUFFER, 300, MAX_FRAME] {
                    let frames = coded(&cells, width, buffer);
                    assert!(frames.iter().all(|frame| frame.len() <= buffer));
                    assert_eq!(decoded(&frames, cells.len(), width), cells);
                }
            }
        }
    }
}

#[test]
fn rows_that_cannot_be_are_refused() {
    let part = |rect: [u32; 4], start: u32, tokens: &'static [u8]| RowsPart {
        layer: MapLayer::Occupancy,
        rect: CellRect {
            x0: rect[0],
            y0: rect[1],
            x1: rect[2],
            y1: rect[3],
        },
        start,
        tokens,
    };
    let good = part([1, 1, 3, 3], 0, &[0x41, 7, 0x80]);
    let mut cells = [0; 12];
    assert_eq!(good.decode_into(&mut cells, 4, 3), Some(4));
    assert_eq!(cells, [0, 0, 0, 0, 0, 7, 7, 0, 0, 7, 7, 0]);
    for bad in [
        part([1, 1, 1, 3], 0, &[]),                                      // no cells
        part([1, 2, 3, 2], 0, &[]),                                      // no cells
        part([3, 1, 1, 3], 0, &[0x40, 7]),                               // the wrong way round
        part([1, 1, 5, 3], 0, &[0x40, 7]),                               // right of the map
        part([1, 1, 3, 4], 0, &[0x40, 7]),                               // above it
        part([1, 1, 3, 3], 0, &[0x43, 7]),                               // more cells than there are
        part([1, 1, 3, 3], 3, &[0x40, 7]),                               // the same, later
        part([1, 1, 3, 3], 3, &[0x01, 1, 2]),                            // the same, as a literal
        part([1, 1, 3, 3], 3, &[0x81]),                                  // the same, as a copy
        part([1, 1, 3, 3], 0, &[0x80]),                                  // nothing below
        part([1, 1, 3, 3], 0, &[0x02, 1]),                               // cut off
        part([1, 1, 3, 3], 0, &[0x40]),                                  // cut off
        part([1, 1, 3, 3], 0, &[0x7f, 0xff, 0xff]),                      // cut off
        part([1, 1, 3, 3], 0, &[0x7f, 0xff, 0xff, 0xff, 0xff, 0x0f, 1]), // 2^32 cells and more
    ] {
        assert_eq!(bad.decode_into(&mut [0; 12], 4, 3), None, "{bad:?}");
    }
    assert_eq!(good.decode_into(&mut [0; 11], 4, 3), None, "another map");
}

#[test]
fn numbers_survive_and_overlong_ones_do_not() {
    for value in [0, 1, 127, 128, 16_383, 16_384, u32::MAX >> 4, u32::MAX] {
        let mut buffer = [0; 5];
        let mut out = Put::new(&mut buffer, 0);
        out.varint(value);
        let len = out.len();
        let mut from = Take::new(&buffer[..len]);
        assert_eq!((from.varint(), from.is_empty()), (Some(value), true));
    }
    assert_eq!(Take::new(&[0xff, 0xff, 0xff, 0xff, 0x10]).varint(), None);
    assert_eq!(Take::new(&[0x80]).varint(), None);
    assert_eq!(Take::new(&[2]).flag(), None);
    assert_eq!(Take::new(&[2, b'a', 0xff]).name(), None);
}

#[test]
fn waiting_rectangles_follow_the_window() {
    let rect = |x0, y0, x1, y1| CellRect { x0, y0, x1, y1 };
    let mut pending = Pending::default();
    pending.add(Some(rect(3, 4, 5, 6)));
    pending.add(None);
    pending.add(Some(rect(4, 2, 9, 5)));
    pending.shift([4, -1]);
    assert_eq!(pending.take(), Some(rect(0, 3, 5, 7)));
    assert_eq!(pending.take(), None);
    pending.add(Some(rect(3, 4, 5, 6)));
    pending.shift([5, 0]);
    assert_eq!(pending.take(), None, "it has left");
}
