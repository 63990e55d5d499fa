//! What is refused, and that nothing has changed then.

use horus_core::error::{Buffer, Parameter};
use horus_core::local::{PropertyValue, UNKNOWN};
use horus_core::prelude::*;

const BAD: [f32; 3] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
const LONG: &str = "a name of more than thirty-two bytes";

fn config() -> LocalGridMapConfig<'static> {
    LocalGridMapConfig {
        external_lidars: &["a", "b"],
        ..LocalGridMapConfig::default()
    }
}

fn refused(config: LocalGridMapConfig<'_>) -> Error {
    let mut map = LocalGridMap::new_in([9u8; 100], LocalGridMapConfig::default()).unwrap();
    map.recenter(Pose2D::new(3.0, 4.0, 0.0)).unwrap();
    let before = (map.offset(), map.width(), map.height());
    let error = map.reset(config).unwrap_err();
    assert_eq!((map.offset(), map.width(), map.height()), before);
    assert_eq!(map.data(), [UNKNOWN; 100]);
    let at_first = LocalGridMap::new_in([9u8; 100], config).unwrap_err();
    assert_eq!(at_first.to_string(), error.to_string());
    error
}

#[test]
fn properties_out_of_range() {
    for resolution in [0.0, -0.1, f32::NAN, f32::INFINITY] {
        let error = refused(LocalGridMapConfig {
            resolution,
            ..config()
        });
        assert!(matches!(error, Error::InvalidResolution(_)));
    }
    for radius in [-0.1, f32::NAN, f32::INFINITY] {
        let error = refused(LocalGridMapConfig { radius, ..config() });
        assert_eq!(error, Error::InvalidParameter(Parameter::FootprintRadius));
    }
    let error = refused(LocalGridMapConfig {
        width: 11,
        ..config()
    });
    let expected = Error::BufferTooSmall {
        buffer: Buffer::Cells,
        needed: 110,
        given: 100,
    };
    assert_eq!(error, expected);
    let error = refused(LocalGridMapConfig {
        width: u32::MAX,
        ..config()
    });
    assert_eq!(error, Error::SizeOverflow);
}

#[test]
fn names() {
    let given = LONG.len();
    let too_long = Error::NameTooLong { given };
    assert_eq!(
        refused(LocalGridMapConfig {
            name: LONG,
            ..config()
        }),
        too_long
    );
    assert_eq!(
        refused(LocalGridMapConfig {
            external_odometry: LONG,
            ..config()
        }),
        too_long
    );
    assert_eq!(
        refused(LocalGridMapConfig {
            external_lidars: &["a", LONG],
            ..config()
        }),
        too_long
    );
    let odometry = Some(Odometry { name: LONG });
    assert_eq!(refused(LocalGridMapConfig { odometry, ..config() }), too_long);
    let twice = LocalGridMapConfig {
        external_lidars: &["a", "b", "a"],
        ..config()
    };
    assert_eq!(refused(twice), Error::DuplicateName);
    let lidar = Lidar {
        name: "b",
        mount: Pose2D::default(),
        start_angle: 0.0,
        fov: 1.0,
        max_range: 1.0,
    };
    let both = LocalGridMapConfig {
        lidars: &[lidar],
        ..config()
    };
    assert_eq!(refused(both), Error::DuplicateName);
}

#[test]
fn lidars_that_cannot_be() {
    let good = Lidar {
        name: "l",
        mount: Pose2D::default(),
        start_angle: 0.0,
        fov: 1.0,
        max_range: 1.0,
    };
    for bad in BAD {
        let cases = [
            (
                Lidar {
                    start_angle: bad,
                    ..good
                },
                Error::InvalidParameter(Parameter::StartAngle),
            ),
            (
                Lidar { fov: bad, ..good },
                Error::InvalidParameter(Parameter::FieldOfView),
            ),
            (
                Lidar {
                    max_range: bad,
                    ..good
                },
                Error::InvalidParameter(Parameter::MaxRange),
            ),
            (
                Lidar {
                    mount: Pose2D::new(0.0, bad, 0.0),
                    ..good
                },
                Error::NonFinitePose,
            ),
        ];
        for (lidar, error) in cases {
            assert_eq!(
                refused(LocalGridMapConfig {
                    lidars: &[lidar],
                    ..config()
                }),
                error
            );
            let mut buffers = SensingBuffers::<8, 20, 0>::empty();
            let mut state = buffers.state();
            assert_eq!(lidar.write(&mut state, &[1.0]), Err(error));
            assert_eq!(state.buffers().count(), 0);
        }
    }
    let negative = Lidar {
        max_range: -1.0,
        ..good
    };
    assert_eq!(
        negative.validate(),
        Err(Error::InvalidParameter(Parameter::MaxRange))
    );
}

#[test]
fn properties_by_name() {
    let mut config = LocalGridMapConfig::default();
    for property in LocalGridMapConfig::properties() {
        assert_eq!(
            config.get(property.name),
            Some(property.default),
            "{}",
            property.name
        );
        assert_eq!(property.default.kind(), property.kind);
        assert!(!property.description.is_empty());
        config.set(property.name, property.default).unwrap();
    }
    assert_eq!(config, LocalGridMapConfig::default());
    for (name, value, error) in [
        ("width", PropertyValue::Float(3.0), Error::PropertyType),
        ("width", PropertyValue::Int(-1), Error::PropertyType),
        ("height", PropertyValue::Int(1 << 32), Error::PropertyType),
        ("footprint", PropertyValue::Str("round"), Error::UnknownFootprint),
        ("footprint", PropertyValue::Bool(true), Error::PropertyType),
        ("depth", PropertyValue::Int(1), Error::UnknownProperty),
    ] {
        assert_eq!(config.set(name, value), Err(error), "{name}");
        assert_eq!(config, LocalGridMapConfig::default());
    }
    config.set("resolution", PropertyValue::Int(1)).unwrap();
    assert_eq!(config.resolution, 1.0);
}

#[test]
fn updates() {
    let mut map = LocalGridMap::new_in([9u8; 100], config()).unwrap();
    let mut buffers = SensingBuffers::<16, 64, 0>::empty();
    let mut state = buffers.state();
    let lidar = Lidar {
        name: "b",
        mount: Pose2D::default(),
        start_angle: 0.0,
        fov: 1.0,
        max_range: 1.0,
    };
    lidar.write(&mut state, &[0.3; 9]).unwrap();
    let (mut few, mut enough) = (ScanBuffers::<8, 0>::empty(), ScanBuffers::<9, 0>::empty());
    let pose = Pose2D::new(1.0, 1.0, 0.0);
    let refused = |map: &mut LocalGridMap<'_, [u8; 100]>, pose, spaces: &mut [ScanWorkspace<'_>]| {
        let error = map.update(&state, pose, spaces).unwrap_err();
        assert_eq!(
            (map.offset(), map.data()),
            ([0, 0], &[UNKNOWN; 100][..]),
            "{error}"
        );
        assert_eq!(map.transformation(), None);
        error
    };
    let error = refused(&mut map, pose, &mut [enough.workspace()]);
    let expected = Error::BufferTooSmall {
        buffer: Buffer::Workspaces,
        needed: 2,
        given: 1,
    };
    assert_eq!(error, expected);
    let error = refused(&mut map, pose, &mut [enough.workspace(), few.workspace()]);
    let expected = Error::BufferTooSmall {
        buffer: Buffer::Beams,
        needed: 9,
        given: 8,
    };
    assert_eq!(error, expected);
    let mut spaces = [few.workspace(), enough.workspace()];
    for bad in BAD {
        let error = refused(&mut map, Pose2D::new(bad, 0.0, 0.0), &mut spaces);
        assert_eq!(error, Error::NonFinitePose);
    }
    for far in [1e12, 3.4e38] {
        let error = refused(&mut map, Pose2D::new(0.0, -far, 0.0), &mut spaces);
        assert_eq!(error, Error::OffsetOutOfRange);
    }
    let told = map.update(&state, pose, &mut spaces).unwrap();
    assert_eq!((told.lidars, told.missing_lidars), (1, 1));
    assert!(matches!(
        map.load(&[0; 99]),
        Err(Error::LengthMismatch {
            needed: 100,
            given: 99
        })
    ));
}
