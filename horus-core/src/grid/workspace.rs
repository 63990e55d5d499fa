use nalgebra::Vector2;

use super::LaserScan;
use crate::error::{Buffer, Error, require};
use crate::math;

/// What integrating scans of one lidar needs beside the grid, over caller-provided storage: the
/// beams' directions (8 bytes per beam), computed once per scan geometry, and one bit per cell for
/// [`ScanModel::Accumulate`](super::ScanModel::Accumulate).
///
/// Keep one per lidar: the directions are recomputed only when the scan's angles change.
///
/// ```
/// use horus_core::prelude::*;
///
/// let mut buffers = ScanBuffers::<360, 0>::empty(); // a `static` in firmware
/// let workspace = buffers.workspace();
/// assert_eq!(workspace.beams(), 360);
/// ```
#[derive(Debug)]
pub struct ScanWorkspace<'a> {
    directions: &'a mut [Vector2<f32>],
    seen: &'a mut [u32],
    /// Angles the directions were computed for, and how many of them are.
    geometry: (f32, f32),
    computed: usize,
}

/// Storage for a [`ScanWorkspace`]: `BEAMS` beams and `WORDS` words of cell bits
/// (one per 32 cells of the grid for `Accumulate`, 0 for `Set`).
#[derive(Clone, Debug)]
pub struct ScanBuffers<const BEAMS: usize, const WORDS: usize> {
    directions: [Vector2<f32>; BEAMS],
    seen: [u32; WORDS],
}

impl<const BEAMS: usize, const WORDS: usize> ScanBuffers<BEAMS, WORDS> {
    /// All bits zero: costs no flash image in a `static`.
    pub const fn empty() -> Self {
        Self {
            directions: [Vector2::new(0.0, 0.0); BEAMS],
            seen: [0; WORDS],
        }
    }

    /// A workspace over these buffers.
    pub fn workspace(&mut self) -> ScanWorkspace<'_> {
        ScanWorkspace::new_in(&mut self.directions, &mut self.seen)
    }
}

impl<'a> ScanWorkspace<'a> {
    /// A workspace over one direction per beam and, for `Accumulate`, one bit per cell (a word per
    /// 32 cells; empty for `Set`).
    pub fn new_in(directions: &'a mut [Vector2<f32>], seen: &'a mut [u32]) -> Self {
        Self {
            directions,
            seen,
            geometry: (0.0, 0.0),
            computed: 0,
        }
    }

    /// Most beams a scan may have.
    pub fn beams(&self) -> usize {
        self.directions.len()
    }

    /// The directions of a scan's beams in the sensor frame, and `words` cleared cell bits.
    pub(crate) fn prepare(&mut self, scan: &LaserScan<'_>, words: usize) -> Result<Prepared<'_>, Error> {
        let beams = scan.ranges.len();
        require(Buffer::Directions, beams, self.directions.len())?;
        require(Buffer::Seen, words, self.seen.len())?;
        let geometry = (scan.angle_min, scan.angle_increment);
        if geometry != self.geometry {
            self.geometry = geometry;
            self.computed = 0;
        }
        for (i, direction) in self
            .directions
            .iter_mut()
            .enumerate()
            .take(beams)
            .skip(self.computed)
        {
            let angle = f64::from(geometry.0) + i as f64 * f64::from(geometry.1);
            let (cos, sin) = math::beam_cos_sin(angle);
            *direction = Vector2::new(cos, sin);
        }
        self.computed = self.computed.max(beams);
        let seen = self.seen.get_mut(..words).unwrap_or_default();
        seen.fill(0);
        Ok(Prepared {
            directions: self.directions.get(..beams).unwrap_or_default(),
            seen,
        })
    }
}

/// A workspace made ready for one scan.
pub(crate) struct Prepared<'a> {
    pub directions: &'a [Vector2<f32>],
    pub seen: &'a mut [u32],
}
