use super::*;
use crate::log::cdr::{CdrError, CdrReader, CdrValue};

/// Bytes from their hexadecimal digits.
fn hex(digits: &str) -> Vec<u8> {
    let (pairs, _) = digits.as_bytes().as_chunks::<2>();
    let byte = |pair| u8::from_str_radix(str::from_utf8(pair).unwrap(), 16).unwrap();
    pairs.iter().map(|pair| byte(pair)).collect()
}

/// Checks a message against a payload taken from ROS 2.
fn assert_golden<M: Message + PartialEq + std::fmt::Debug>(message: &M, digits: &str) {
    let golden = hex(digits);
    assert_eq!(message.to_payload().unwrap(), golden);
    assert_eq!(&M::from_payload(&golden).unwrap(), message);
    for len in 0..golden.len() {
        assert!(M::from_payload(&golden[..len]).is_err(), "cut to {len} bytes");
    }
}

fn header(frame_id: &str) -> Header {
    Header::new(1_000_000_002, frame_id)
}

#[test]
fn occupancy_grid_has_the_bytes_of_ros() {
    let grid = OccupancyGrid {
        header: header("map"),
        info: MapMetaData {
            map_load_time: Time::default(),
            resolution: 0.05,
            width: 3,
            height: 2,
            origin: Pose::planar(-1.0, -2.0, 0.0),
        },
        data: vec![-1, 0, 100, 49, 50, 99],
    };
    assert_golden(
        &grid,
        "000100000100000002000000040000006d6170000000000000000000cdcc4c3d0300000002000000\
         00000000000000000000f0bf00000000000000c00000000000000000000000000000000000000000\
         000000000000000000000000000000000000f03f06000000ff0064313263",
    );
}

fn scan() -> LaserScan {
    LaserScan {
        header: header("laser"),
        angle_min: -1.0,
        angle_max: 1.0,
        angle_increment: 1.0,
        time_increment: 0.0,
        scan_time: 0.1,
        range_min: 0.05,
        range_max: 30.0,
        ranges: vec![1.0, f32::INFINITY, 2.5],
        intensities: vec![],
    }
}

#[test]
fn laser_scan_has_the_bytes_of_ros() {
    assert_golden(
        &scan(),
        "000100000100000002000000060000006c61736572000000000080bf0000803f0000803f00000000\
         cdcccc3dcdcc4c3d0000f041030000000000803f0000807f0000204000000000",
    );
}

#[test]
fn transforms_have_the_bytes_of_ros() {
    let transform = TransformStamped {
        header: header("odom"),
        child_frame_id: "base_link".to_owned(),
        transform: Transform::planar(1.0, 2.0, 0.0),
    };
    assert_golden(
        &TFMessage {
            transforms: vec![transform],
        },
        "00010000010000000100000002000000050000006f646f6d000000000a000000626173655f6c696e\
         6b000000000000000000f03f00000000000000400000000000000000000000000000000000000000\
         000000000000000000000000000000000000f03f",
    );
}

#[test]
fn foxglove_grid_has_the_bytes_of_ros() {
    let field = |name, offset| PackedElementField::new(name, offset, NumericType::Float32);
    let masses = [0.25f32, 0.5, 0.25];
    let grid = Grid {
        timestamp: Time::from_ns(1_000_000_002),
        frame_id: "odom".to_owned(),
        pose: Pose::planar(-1.0, -2.0, 0.0),
        column_count: 1,
        cell_size: Vector2 { x: 0.05, y: 0.05 },
        row_stride: 12,
        cell_stride: 12,
        fields: vec![field("free", 0), field("occupied", 4), field("unknown", 8)],
        data: masses.iter().flat_map(|mass| mass.to_le_bytes()).collect(),
    };
    assert_golden(
        &grid,
        "000100000100000002000000050000006f646f6d0000000000000000000000000000f0bf00000000\
         000000c0000000000000000000000000000000000000000000000000000000000000000000000000\
         0000f03f01000000000000009a9999999999a93f9a9999999999a93f0c0000000c00000003000000\
         0500000066726565000000000000000007000000090000006f636375706965640000000004000000\
         0700000008000000756e6b6e6f776e0008000000070000000c0000000000803e0000003f0000803e",
    );
}

#[test]
fn big_endian_payloads_decode() {
    let payload = hex("000000000000000100000002000000046d617000");
    let mut reader = CdrReader::new(&payload).unwrap();
    assert_eq!(Header::decode(&mut reader).unwrap(), header("map"));
    reader.finish().unwrap();
    // Sequences of floats are decoded in bulk, so they get a look of their own.
    let payload = hex("00000000000000023f800000c0200000");
    let mut reader = CdrReader::new(&payload).unwrap();
    assert_eq!(Vec::<f32>::decode(&mut reader).unwrap(), [1.0, -2.5]);
}

#[test]
fn other_encapsulations_are_refused_by_name() {
    for id in 0..=0x0f_u8 {
        let error = CdrReader::new(&[0, id, 0, 0]).err();
        let expected = match id {
            0 | 1 => None,
            6..=11 => Some(CdrError::Xcdr2 { id: id.into() }),
            _ => Some(CdrError::UnknownEncapsulation { id: id.into() }),
        };
        assert_eq!(error, expected);
    }
    let error = CdrReader::new(&[0, 1, 0]).err();
    assert_eq!(error, Some(CdrError::NoHeader { len: 3 }));
    let text = CdrError::Xcdr2 { id: 7 }.to_string();
    assert_eq!(
        text,
        "the payload is XCDR2 (encapsulation id 0x0007), and only XCDR1 is read"
    );
}

#[test]
fn lengths_beyond_the_payload_are_refused() {
    let huge = hex("00010000ffffffff00000000");
    let decoded = |payload: &[u8]| Vec::<f32>::decode(&mut CdrReader::new(payload).unwrap());
    let too_long = |count| CdrError::SequenceTooLong {
        at: 8,
        count,
        left: 4,
    };
    assert_eq!(decoded(&huge), Err(too_long(0xffff_ffff)));
    assert_eq!(decoded(&hex("000100000200000000000000")), Err(too_long(2)));
    let text = String::decode(&mut CdrReader::new(&huge).unwrap());
    assert_eq!(text, Err(too_long(0xffff_ffff)));
    let edges = Vec::<TransformStamped>::decode(&mut CdrReader::new(&huge).unwrap());
    assert_eq!(edges, Err(too_long(0xffff_ffff)));
}

#[test]
fn strings_are_checked() {
    let decoded = |digits| String::decode(&mut CdrReader::new(&hex(digits)).unwrap());
    assert_eq!(decoded("0001000003000000686900"), Ok("hi".into()));
    assert_eq!(decoded("0001000000000000"), Ok(String::new()));
    let unterminated = Err(CdrError::StringTermination { at: 8 });
    assert_eq!(decoded("00010000020000006869"), unterminated);
    assert_eq!(decoded("0001000003000000680000"), unterminated);
    let not_utf8 = Err(CdrError::StringNotUtf8 { at: 8 });
    assert_eq!(decoded("0001000002000000ff00"), not_utf8);
    let with_zero = Header::new(0, "a\0b").to_payload();
    let text = "a\0b".to_owned();
    assert_eq!(with_zero, Err(CdrError::NulInString { text }));
}

#[test]
fn a_payload_of_another_type_does_not_pass() {
    let mut payload = scan().to_payload().unwrap();
    payload.extend([0; 3]);
    assert!(LaserScan::from_payload(&payload).is_ok());
    payload.push(0);
    let error = LaserScan::from_payload(&payload).unwrap_err();
    assert_eq!(error, CdrError::Trailing { at: 72, left: 4 });
}

#[test]
fn definition_lists_every_structure_once_in_order_of_use() {
    let separator = "=".repeat(80);
    let expected = format!(
        "std_msgs/Header header\nnav_msgs/MapMetaData info\nint8[] data\n\
         {separator}\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n\
         {separator}\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n\
         {separator}\nMSG: nav_msgs/MapMetaData\nbuiltin_interfaces/Time map_load_time\n\
         float32 resolution\nuint32 width\nuint32 height\ngeometry_msgs/Pose origin\n\
         {separator}\nMSG: geometry_msgs/Pose\ngeometry_msgs/Point position\n\
         geometry_msgs/Quaternion orientation\n\
         {separator}\nMSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z\n\
         {separator}\nMSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"
    );
    assert_eq!(OccupancyGrid::definition(), expected);
    assert_eq!(OccupancyGrid::TYPE, "nav_msgs/msg/OccupancyGrid");
    // A field named by a keyword loses Rust's mark.
    assert!(Grid::definition().contains("uint32 offset\nuint8 type\n"));
}

#[test]
fn differences_name_the_field() {
    let edge = TransformStamped::default();
    let one = TFMessage {
        transforms: vec![edge.clone(), edge],
    };
    let mut other = one.clone();
    assert_eq!(one.difference(&other), None);
    other.transforms[1].transform.rotation.w = -0.0;
    let found = one.difference(&other).unwrap();
    assert_eq!(found.path, "transforms[1].transform.rotation.w");
    assert_eq!((found.a.as_str(), found.b.as_str()), ("1", "-0"));
    other.transforms.pop();
    let found = one.difference(&other).unwrap();
    assert_eq!(
        (found.path.as_str(), found.a.as_str()),
        ("transforms", "2 elements")
    );
    // Floats are compared by their bits: an equal NaN is no difference.
    let mut scan = scan();
    scan.ranges[1] = f32::NAN;
    assert_eq!(scan.difference(&scan.clone()), None);
}

#[test]
fn times_split_and_join() {
    let time = Time::from_ns(1_700_000_000_999_999_999);
    assert_eq!((time.sec, time.nanosec), (1_700_000_000, 999_999_999));
    assert_eq!(time.to_ns(), Some(1_700_000_000_999_999_999));
    assert_eq!(Time::from_ns(u64::MAX).sec, i32::MAX);
    assert_eq!(Time { sec: -1, nanosec: 0 }.to_ns(), None);
}

#[test]
fn yaw_survives_the_quaternion() {
    for step in -10..=10 {
        let yaw = 0.3 * f64::from(step);
        assert!((Quaternion::from_yaw(yaw).yaw() - yaw).abs() < 1e-12);
    }
}
