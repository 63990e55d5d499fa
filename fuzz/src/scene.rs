//! Sizes, poses, scans and scan models, derived from bytes.

use arbitrary::{Arbitrary, Result, Unstructured};
use horus_core::prelude::{LaserScan, Pose2D, ScanModel};
use horus_host::reference;

use crate::number::Number;
use crate::sequence::Short;

/// Metres per cell: mostly one of the usual ones.
#[derive(Clone, Copy, Debug)]
pub struct Resolution(pub f32);

impl<'a> Arbitrary<'a> for Resolution {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        const USUAL: [f32; 8] = [0.05, 0.1, 0.025, 0.01, 0.5, 1.0, 0.07, 0.25];
        Ok(Self(match u.arbitrary::<u8>()? {
            n @ 0..=239 => USUAL[usize::from(n) % USUAL.len()],
            _ => u.arbitrary::<Number>()?.of(1.0),
        }))
    }
}

/// Columns and rows: at most 48 x 40, or a single row or column; at most `limit` cells.
pub fn cells(width: u8, height: u8, limit: u32) -> (u32, u32) {
    let long = limit.min(320) * u32::from(width) / 255;
    match height % 43 {
        41 => (long, 1),
        42 => (1, long),
        height => {
            let width = u32::from(width % 49);
            (width, u32::from(height).min(limit / width.max(1)))
        }
    }
}

/// A pose whose position is counted in cells and whose heading in tenths of a radian.
#[derive(Clone, Copy, Debug, Arbitrary)]
pub struct Place {
    x: Number,
    y: Number,
    theta: Option<Number>,
}

impl Place {
    /// The pose in metres and radians, for cells of `resolution` metres.
    pub fn pose(&self, resolution: f32) -> Pose2D {
        let theta = self.theta.map_or(0.0, |theta| theta.of(0.1));
        Pose2D::new(self.x.of(resolution), self.y.of(resolution), theta)
    }
}

/// A pose as the std version takes it.
pub fn std_pose(pose: Pose2D) -> reference::Pose2D {
    reference::Pose2D::new(pose.x.into(), pose.y.into(), pose.theta.into())
}

/// Most beams that core is given room for.
pub const BEAMS: usize = 48;

/// A scan with ranges counted in cells.
#[derive(Clone, Debug, Arbitrary)]
pub struct Scan {
    angle_min: Number,
    angle_increment: Number,
    limits: Option<[Number; 2]>,
    ranges: Short<Number, { BEAMS as u8 + 1 }>,
    sensor: Place,
}

impl Scan {
    /// The scan as the std version takes it, and the sensor's pose: relative to `around`, so that
    /// most sensors stand near the map.
    pub fn std(&self, resolution: f32, around: (f32, f32)) -> (reference::LaserScan, Pose2D) {
        let [range_min, range_max] = match self.limits {
            Some(limits) => limits.map(|limit| limit.of(resolution)),
            None => [0.0, 30.0 * resolution],
        };
        let scan = reference::LaserScan {
            angle_min: self.angle_min.of(0.1),
            angle_increment: self.angle_increment.of(0.05),
            range_min,
            range_max,
            ranges: self.ranges.0.iter().map(|range| range.of(resolution)).collect(),
        };
        let mut sensor = self.sensor.pose(resolution);
        sensor.x += around.0;
        sensor.y += around.1;
        (scan, sensor)
    }
}

/// The same scan as core takes it.
pub fn core_scan(scan: &reference::LaserScan) -> LaserScan<'_> {
    LaserScan {
        angle_min: scan.angle_min,
        angle_increment: scan.angle_increment,
        range_min: scan.range_min,
        range_max: scan.range_max,
        ranges: &scan.ranges,
    }
}

/// A scan model, legal or not.
#[derive(Clone, Copy, Debug, Arbitrary)]
pub enum Model {
    /// Free and hit.
    Set,
    /// With the default steps.
    Usual,
    /// With legal steps.
    Legal {
        /// Its lower seven bits count.
        hit: u8,
        /// Its lower seven bits count.
        miss: u8,
        /// Limits in any order, modulo 101.
        limits: [u8; 2],
    },
    /// With any steps.
    Any {
        /// Step of a hit.
        hit: i8,
        /// Step of a miss.
        miss: i8,
        /// Lower limit.
        min: i8,
        /// Upper limit.
        max: i8,
    },
}

impl Model {
    /// The model for both sides.
    pub fn both(self) -> (ScanModel, reference::ScanModel) {
        let (hit, miss, min, max) = match self {
            Self::Set => return (ScanModel::Set, reference::ScanModel::Set),
            Self::Usual => return (ScanModel::accumulate(), reference::ScanModel::accumulate()),
            Self::Legal { hit, miss, limits } => {
                let [a, b] = limits.map(|limit| (limit % 101) as i8);
                ((hit % 128) as i8, -((miss % 128) as i8), a.min(b), a.max(b))
            }
            Self::Any { hit, miss, min, max } => (hit, miss, min, max),
        };
        (
            ScanModel::Accumulate { hit, miss, min, max },
            reference::ScanModel::Accumulate { hit, miss, min, max },
        )
    }
}

/// Where to move a window.
#[derive(Clone, Copy, Debug, Arbitrary)]
pub enum Move {
    /// By about this many cells along the grid's axes.
    Cells(i8, i8),
    /// By few cells along the grid's axes.
    Few(i8, i8),
    /// So far along both axes that f32 no longer resolves single cells, or nearly so.
    Far {
        /// Powers of two, modulo 31, of cells along x and y.
        powers: [u8; 2],
        /// Cells more or less.
        rest: [i8; 2],
    },
    /// To any pose.
    To(Place),
}

impl Move {
    /// The pose to have in the middle of a window of `size` cells whose corner is at `origin`.
    pub fn pose(self, origin: Pose2D, size: [u32; 2], resolution: f32) -> Pose2D {
        let [dx, dy] = match self {
            Self::Cells(dx, dy) => [dx, dy].map(f32::from),
            Self::Few(dx, dy) => [dx % 4, dy % 4].map(f32::from),
            Self::Far { powers, rest } => {
                let cells = |axis: usize| (1u32 << (powers[axis] % 31)) as f32;
                [cells(0) + f32::from(rest[0]), cells(1) + f32::from(rest[1])]
            }
            Self::To(place) => return place.pose(resolution),
        };
        let x = (size[0] as f32 * 0.5 + dx) * resolution;
        let y = (size[1] as f32 * 0.5 + dy) * resolution;
        let (s, c) = origin.theta.sin_cos();
        Pose2D::new(origin.x + (c * x - s * y), origin.y + (s * x + c * y), 0.0)
    }
}

/// Cell values made from a seed: `density` in 256 are obstacles, the rest free, known or unknown.
#[derive(Clone, Copy, Debug, Arbitrary)]
pub struct Fill {
    seed: u16,
    density: u8,
    kind: FillKind,
}

#[derive(Clone, Copy, Debug, Arbitrary)]
enum FillKind {
    Free,
    Unknown,
    AnyKnown,
    Anything,
}

impl Fill {
    /// The values of `cells` cells.
    pub fn values(&self, cells: usize) -> Vec<i8> {
        let mut state = u32::from(self.seed) | 1 << 16;
        let mut next = || {
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            (state >> 8) as u8
        };
        let mut value = || {
            if next() < self.density {
                return 100;
            }
            match self.kind {
                FillKind::Free => 0,
                FillKind::Unknown => -1,
                FillKind::AnyKnown => (next() % 101) as i8,
                FillKind::Anything => next() as i8,
            }
        };
        (0..cells).map(|_| value()).collect()
    }
}
