use core::ffi::c_void;

use crate::c_abi::arena::{Arena, Room};
use crate::c_abi::call::{Call, Plain};
use crate::c_abi::object::{self, Make, Object};
use crate::c_abi::status::horus_status;
use crate::geometry::{GridInfo, Pose2D};
use crate::grid::{BeamSlot, ScanWorkspace};
use crate::local::{BufferSlot, Footprint, LocalGridMap, LocalGridMapConfig, SensingState};

/// Most lidars of a local map.
pub const HORUS_LOCAL_MAP_LIDARS: usize = 4;
/// Bytes of a name in a local map's configuration; a shorter one ends with a zero.
pub const HORUS_LOCAL_MAP_NAME: usize = 32;

/// A rolling map of what lidars see around a robot: one byte per cell, 0 occupied, 128 unknown, 255
/// free, row by row from the lowest y. It lies, with its sensing state, in memory of its user.
pub struct horus_local_map {
    _memory: (),
}

/// What a local map frees around the robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum horus_footprint_kind {
    /// A square of twice the radius, along the map's axes.
    Rectangular = 0,
    /// A disc of the radius.
    Circular = 1,
    /// Nothing.
    None = 2,
}

/// Size, sensors and outputs of a local map.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct horus_local_map_config {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Metres per cell.
    pub resolution: f32,
    /// A horus_footprint_kind.
    pub footprint: i32,
    /// Radius of the footprint in metres.
    pub radius: f32,
    /// Lidars, at most HORUS_LOCAL_MAP_LIDARS.
    pub lidars: u32,
    /// Most beams of a scan.
    pub beams: u32,
    /// Not 0: there is an odometry sensor.
    pub has_odometry: u8,
    /// Not 0: room for horus_local_map_publish(), one more byte per cell.
    pub publishes: u8,
    /// Not 0: what is published includes the transformation from the map's frame to the world.
    pub include_transformation: u8,
    /// Prefix of what is published, UTF-8.
    pub name: [u8; 32],
    /// Name of the odometry sensor, UTF-8.
    pub odometry: [u8; 32],
    /// Names of the lidars, UTF-8, each another one, in the order in which their scans are drawn.
    pub lidar_names: [[u8; 32]; 4],
}

// SAFETY: numbers.
unsafe impl Plain for horus_local_map_config {}

/// A 10 x 10 map of 0.1 m without sensors, navground's defaults.
#[unsafe(no_mangle)]
pub extern "C" fn horus_local_map_config_default() -> horus_local_map_config {
    let LocalGridMapConfig {
        width,
        height,
        resolution,
        radius,
        ..
    } = LocalGridMapConfig::new();
    horus_local_map_config {
        width,
        height,
        resolution,
        footprint: horus_footprint_kind::Rectangular as i32,
        radius,
        lidars: 0,
        beams: 0,
        has_odometry: 0,
        publishes: 0,
        include_transformation: 0,
        name: [0; 32],
        odometry: [0; 32],
        lidar_names: [[0; 32]; 4],
    }
}

type Names<T> = [T; HORUS_LOCAL_MAP_LIDARS];

impl horus_local_map_config {
    fn cells(&self) -> Result<usize, horus_status> {
        Ok(GridInfo::new(self.width, self.height, self.resolution, Pose2D::default())?.cells())
    }

    fn footprint(&self) -> Result<Footprint, horus_status> {
        let known = [
            (horus_footprint_kind::Rectangular, Footprint::Rectangular),
            (horus_footprint_kind::Circular, Footprint::Circular),
            (horus_footprint_kind::None, Footprint::None),
        ];
        let found = known.iter().find(|(number, _)| *number as i32 == self.footprint);
        found
            .map(|(_, footprint)| *footprint)
            .ok_or(horus_status::InvalidChoice)
    }

    /// Named buffers, and numbers in them.
    fn capacity(&self) -> Result<(usize, usize), horus_status> {
        let lidars = self.lidars as usize;
        let numbers = (self.beams as usize)
            .checked_add(6)
            .and_then(|n| n.checked_mul(lidars));
        let numbers = numbers
            .and_then(|n| n.checked_add(12))
            .ok_or(horus_status::SizeOverflow)?;
        Ok((5 * lidars + 6, numbers))
    }
}

/// A map, its sensing state, and a workspace per lidar.
pub(in crate::c_abi) struct LocalMap {
    pub map: LocalGridMap<'static, &'static mut [u8]>,
    pub state: SensingState<'static>,
    pub workspaces: Names<ScanWorkspace<'static>>,
    /// Most beams of a scan.
    pub beams: usize,
}

pub(in crate::c_abi) struct Buffers {
    names: &'static mut [u8],
    lidars: Room<Names<&'static str>>,
    slots: &'static mut [BufferSlot],
    floats: &'static mut [f32],
    beams: Names<&'static mut [BeamSlot]>,
    cells: &'static mut [u8],
    published: &'static mut [u8],
}

impl Object for LocalMap {
    const TAG: u32 = u32::from_le_bytes(*b"HLm1");
    type Handle = horus_local_map;
}

impl Make for LocalMap {
    type Object = Self;
    type Config = horus_local_map_config;
    type Buffers = Buffers;

    /// The most aligned first.
    fn buffers(config: &Self::Config, arena: &mut Arena) -> Result<Self::Buffers, horus_status> {
        if config.lidars as usize > HORUS_LOCAL_MAP_LIDARS {
            return Err(horus_status::InvalidChoice);
        }
        config.footprint()?;
        let cells = config.cells()?;
        let (slots, floats) = config.capacity()?;
        let mut beams: Names<&'static mut [BeamSlot]> = Names::default();
        Ok(Buffers {
            lidars: arena.room()?,
            slots: arena.take(slots)?,
            floats: arena.take(floats)?,
            beams: {
                for slots in beams.iter_mut().take(config.lidars as usize) {
                    *slots = arena.take(config.beams as usize)?;
                }
                beams
            },
            names: arena.take((2 + HORUS_LOCAL_MAP_LIDARS) * HORUS_LOCAL_MAP_NAME)?,
            cells: arena.take(cells)?,
            published: match config.publishes {
                0 => &mut [],
                _ => arena.take(cells)?,
            },
        })
    }

    fn make(config: &Self::Config, buffers: Self::Buffers) -> Result<Self, horus_status> {
        let mut names = buffers.names;
        let mut keep = |name: &[u8; HORUS_LOCAL_MAP_NAME]| {
            let (to, rest) = core::mem::take(&mut names)
                .split_first_chunk_mut::<HORUS_LOCAL_MAP_NAME>()
                .ok_or(horus_status::BufferTooSmall)?;
            names = rest;
            *to = *name;
            let to: &'static [u8] = to;
            let text = to.split(|byte| *byte == 0).next().unwrap_or_default();
            str::from_utf8(text).map_err(|_| horus_status::InvalidText)
        };
        let (name, odometry) = (keep(&config.name)?, keep(&config.odometry)?);
        let mut lidars = [""; HORUS_LOCAL_MAP_LIDARS];
        for (to, name) in lidars
            .iter_mut()
            .zip(&config.lidar_names)
            .take(config.lidars as usize)
        {
            *to = keep(name)?;
        }
        let lidars: &'static Names<&'static str> = buffers.lidars.put(lidars)?;
        let own = LocalGridMapConfig {
            width: config.width,
            height: config.height,
            resolution: config.resolution,
            include_transformation: config.include_transformation != 0,
            external_lidars: lidars.get(..config.lidars as usize).unwrap_or_default(),
            odometry: (config.has_odometry != 0).then_some(crate::local::Odometry { name: odometry }),
            footprint: config.footprint()?,
            radius: config.radius,
            name,
            ..LocalGridMapConfig::new()
        };
        let map = LocalGridMap::new_in(buffers.cells, own)?;
        let mut state = SensingState::new_in(buffers.slots, buffers.floats, buffers.published);
        for name in own.lidar_names() {
            state.reserve::<f32>(name, "range", config.beams as usize)?;
        }
        Ok(Self {
            map,
            state,
            workspaces: buffers.beams.map(|slots| ScanWorkspace::new_in(slots, &mut [])),
            beams: config.beams as usize,
        })
    }
}

/// Bytes of memory that such a local map takes: one per cell, one more if it publishes, and per lidar
/// 16 per beam and a few hundred.
///
/// Fails with HORUS_STATUS_INVALID_RESOLUTION, HORUS_STATUS_SIZE_OVERFLOW; with
/// HORUS_STATUS_INVALID_CHOICE for the footprint and the number of lidars.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_map_bytes(
    config: *const horus_local_map_config,
    bytes: *mut usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let config = claims.input(config)?;
        claims.output(bytes)?.write(object::bytes::<LocalMap>(&config)?);
        Ok(())
    })
}

/// Makes a local map of unknown cells, its corner at the frame's origin, in `length` bytes of memory.
///
/// Fails as horus_local_map_bytes() does, and with HORUS_STATUS_BUFFER_TOO_SMALL; with
/// HORUS_STATUS_INVALID_FOOTPRINT_RADIUS, HORUS_STATUS_INVALID_TEXT, HORUS_STATUS_DUPLICATE_NAME the
/// memory holds no object.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_map_init(
    memory: *mut c_void,
    length: usize,
    config: *const horus_local_map_config,
    map: *mut *mut horus_local_map,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| object::init::<LocalMap>(claims, memory, length, config, map))
}
