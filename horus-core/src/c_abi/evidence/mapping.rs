//! How a local mapping is made.

use core::ffi::c_void;

use super::config::{
    HORUS_LOCAL_MAPPING_INPAINTS, HORUS_LOCAL_MAPPING_SENSORS, horus_local_mapping_config, operator,
};
use crate::c_abi::arena::{Arena, Room};
use crate::c_abi::call::Call;
use crate::c_abi::object::{self, Make, Object};
use crate::c_abi::status::horus_status;
use crate::distance::DistanceBuffers;
use crate::evidence::{
    FusionRule, Inpaint, LocalMapping, LocalMappingConfig, MappingBuffers, SensorConfig, class_bytes,
};
use crate::storage::bitmap_words;

/// The whole chain of local mapping: scans become evidence, are fused into a rolling map, which is
/// painted over, cut into free and occupied, and measured for distances. It lies in memory of its
/// user.
pub struct horus_local_mapping {
    _memory: (),
}

pub(in super::super) type Mapping = LocalMapping<'static>;

impl Object for Mapping {
    const TAG: u32 = u32::from_le_bytes(*b"HEm1");
    type Handle = horus_local_mapping;
}

/// What lies behind a local mapping.
pub struct Parts {
    buffers: MappingBuffers<'static>,
    sensors: Room<[SensorConfig; HORUS_LOCAL_MAPPING_SENSORS]>,
    inpaints: Room<[Inpaint; HORUS_LOCAL_MAPPING_INPAINTS]>,
}

impl Make for Mapping {
    type Object = Self;
    type Config = horus_local_mapping_config;
    type Buffers = Parts;

    fn buffers(config: &Self::Config, arena: &mut Arena) -> Result<Self::Buffers, horus_status> {
        use crate::evidence::Lattice;

        let info = Lattice::from(config.lattice).info()?;
        let mut classes = 0;
        for sensor in config.used_sensors()? {
            let lattice = Lattice::from(sensor.lattice);
            lattice.validate()?;
            classes = classes.max(class_bytes(lattice.rows, lattice.cols));
        }
        Ok(Parts {
            sensors: arena.room()?,
            inpaints: arena.room()?,
            buffers: MappingBuffers {
                cells: arena.take(info.cells())?,
                limits: arena.take(config.beams as usize)?,
                binary: arena.take(bitmap_words(info.width(), info.height()))?,
                distance: DistanceBuffers {
                    cells: arena.take(info.cells())?,
                    vertices: arena.take(info.width() as usize)?,
                },
                classes: arena.take(classes)?,
            },
        })
    }

    fn make(config: &Self::Config, parts: Self::Buffers) -> Result<Self, horus_status> {
        let ((sensors, sensor_count), (inpaints, inpaint_count)) = (config.sensors()?, config.inpaints()?);
        let sensors: &'static [SensorConfig] = parts.sensors.put(sensors)?;
        let inpaints: &'static [Inpaint] = parts.inpaints.put(inpaints)?;
        let config = LocalMappingConfig {
            lattice: config.lattice.into(),
            rule: FusionRule {
                operator: operator(config.fusion)?,
                ignorance_floor: config.ignorance_floor,
            },
            sensors: sensors.get(..sensor_count).unwrap_or_default(),
            inpaint: inpaints.get(..inpaint_count).unwrap_or_default(),
            thresholds: config.thresholds(),
            max_distance: config.max_distance,
        };
        Ok(LocalMapping::new_in(parts.buffers, config)?)
    }
}

/// Bytes of memory that such a mapping takes: 6 per cell of the fused map, a quarter per cell of the
/// largest sensor lattice, 8 per beam, and a few.
///
/// Fails with HORUS_STATUS_INVALID_RESOLUTION, HORUS_STATUS_NON_FINITE_POSE,
/// HORUS_STATUS_SIZE_OVERFLOW.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_mapping_bytes(
    config: *const horus_local_mapping_config,
    bytes: *mut usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let config = claims.input(config)?;
        claims.output(bytes)?.write(object::bytes::<Mapping>(&config)?);
        Ok(())
    })
}

/// Makes a mapping that knows nothing in `length` bytes of memory.
///
/// Fails as horus_local_mapping_bytes does, and with HORUS_STATUS_BUFFER_TOO_SMALL,
/// HORUS_STATUS_INVALID_CHOICE, HORUS_STATUS_INVALID_MASSES, HORUS_STATUS_INVALID_MAPPING_PARAMETER.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_mapping_init(
    memory: *mut c_void,
    length: usize,
    config: *const horus_local_mapping_config,
    mapping: *mut *mut horus_local_mapping,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| object::init::<Mapping>(claims, memory, length, config, mapping))
}
