use horus_core::costmap::FieldCell;
use horus_core::frames::{
    Frame, FrameHeader, FrameNames, FrameWriter, MapChecksum, MapLayer, MapStream, Payload, Put, RowsPart,
    ScanPart, Session, StreamOptions, StreamTick, Take, TickEnd, TickStart,
};
use horus_core::prelude::*;
use horus_footprint::{need, opaque, robot};

pub fn write<F: FieldCell>(map: &CostMap<'_, F>, buffer: &mut [u8], ranges: &[f32]) {
    let options = opaque(StreamOptions::default());
    let sink = |frame: &[u8]| need(frame);
    if let Ok(mut stream) = MapStream::new_in(opaque(&mut *buffer), sink, options) {
        loop {
            let pose = opaque(Pose2D::default());
            let tick = StreamTick {
                stamp_ns: opaque(1),
                robot: pose,
                sensor: pose,
                scan: robot::scan(opaque(ranges)),
                changed: opaque(None),
                costs_changed: opaque(None),
            };
            need(stream.tick(map, &opaque(tick)));
            if opaque(false) {
                break;
            }
            stream.request_key();
        }
        need((stream.frames(), stream.sink_mut()));
    }
    if let Ok(mut writer) = FrameWriter::new_in(opaque(buffer), sink) {
        let names = opaque(FrameNames::default());
        let session = Session::of(map, opaque(ScanModel::Set), opaque(Pose2D::default()), names);
        writer.session(&opaque(session));
        writer.tick_start(&opaque(START));
        writer.ranges(opaque(ranges));
        let rect = opaque(RECT);
        writer.occupancy(map.occupancy_grid(), rect);
        writer.costs(map, rect);
        writer.tick_end(opaque(TickEnd { checksum: None }));
        need((writer.frames(), writer.sink_mut()));
    }
}

const RECT: CellRect = CellRect {
    x0: 1,
    y0: 2,
    x1: 3,
    y1: 4,
};
const START: TickStart = TickStart {
    is_key: true,
    has_maps: true,
    stamp_ns: 0,
    robot: Pose2D::new(0.0, 0.0, 0.0),
    sensor: Pose2D::new(0.0, 0.0, 0.0),
    offset: [0; 2],
    beams: 0,
    angle_min: 0.0,
    angle_increment: 0.0,
    range_min: 0.0,
    range_max: 0.0,
};

pub fn read(bytes: &[u8], cells: &mut [u8]) {
    if let Ok(frame) = Frame::read(opaque(1), opaque(bytes)) {
        match opaque(frame) {
            Frame::Scan(part) => part.ranges().for_each(need),
            Frame::Rows(part) => need(part.decode_into(opaque(cells), opaque(3), opaque(4))),
            other => need(other),
        }
    }
    let header = FrameHeader::take(&mut Take::new(opaque(bytes)));
    need(header.map(|header| opaque(header).frame_len()));
    let layer = opaque(MapLayer::from_number(opaque(1)));
    need(layer.map(MapLayer::unseen));
    need(MapLayer::unseen(opaque(MapLayer::Costs)));
    take(&mut opaque(Take::new(bytes)));
    // Only the library makes a `Put`.
    need(put as fn(&mut Put<'_>, &Everything<'_>));
}

fn take(from: &mut Take<'_>) {
    need((from.u8(), from.u16(), from.u32(), from.u64(), from.f32()));
    need((from.varint(), from.pose(), from.name(), from.flag()));
    need((from.bytes(opaque(5)), from.is_empty(), from.rest()));
}

/// All that can be put.
struct Everything<'a> {
    header: FrameHeader,
    session: Session<'a>,
    start: TickStart,
    scan: ScanPart<'a>,
    rows: RowsPart<'a>,
    checksum: MapChecksum,
}

fn put(out: &mut Put<'_>, of: &Everything<'_>) {
    of.header.put(out);
    of.session.put(out);
    of.start.put(out);
    of.scan.put(out);
    of.rows.put(out);
    let checksum = Some(of.checksum);
    TickEnd { checksum }.put(out);
    out.u8(opaque(1));
    out.u16(opaque(2));
    out.u32(opaque(3));
    out.u64(opaque(4));
    out.f32(opaque(5.0));
    out.varint(opaque(6));
    out.pose(opaque(Pose2D::default()));
    out.name(opaque("name"));
    out.bytes(opaque(&[7, 8][..]));
}
