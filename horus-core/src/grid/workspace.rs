use nalgebra::Vector2;

use super::LaserScan;
use crate::error::{Buffer, Error, require};
use crate::math;

/// What integrating scans of one lidar needs beside the grid, over caller-provided storage: one
/// [`BeamSlot`] per beam, whose directions are computed once per scan geometry, and one bit per
/// cell for [`ScanModel::Accumulate`](super::ScanModel::Accumulate).
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
    slots: &'a mut [BeamSlot],
    seen: &'a mut [u32],
    /// Angles the directions were computed for, and how many of them are.
    angles: BeamAngles,
    computed: usize,
}

/// The angles of a scan's beams, in radians: beam `i` points to `first + i * span / parts`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BeamAngles {
    pub first: f32,
    pub span: f32,
    /// 1 if `span` is the angle between two beams.
    pub parts: u32,
}

impl BeamAngles {
    /// The angle of a beam, in f64: dividing by 1 changes no bit.
    fn angle(&self, beam: usize) -> f64 {
        let along = beam as f64 * f64::from(self.span);
        f64::from(self.first) + along / f64::from(self.parts)
    }
}

/// What a workspace keeps of one beam: its direction in the sensor frame and, while a scan is
/// integrated, the cell it ends in. 12 bytes.
#[derive(Clone, Copy, Debug)]
pub struct BeamSlot {
    pub(crate) direction: Vector2<f32>,
    /// Linear index of the cell the beam hits; [`NO_CELL`](Self::NO_CELL) if it hits none.
    pub(crate) hit: u32,
}

impl BeamSlot {
    /// All bits zero; the contents do not matter.
    pub const EMPTY: Self = Self {
        direction: Vector2::new(0.0, 0.0),
        hit: 0,
    };

    /// No grid has this many cells.
    pub(crate) const NO_CELL: u32 = u32::MAX;
}

/// Storage for a [`ScanWorkspace`]: `BEAMS` beams and `WORDS` words of cell bits
/// (one per 32 cells of the grid for `Accumulate`, 0 for `Set`).
#[derive(Clone, Debug)]
pub struct ScanBuffers<const BEAMS: usize, const WORDS: usize> {
    slots: [BeamSlot; BEAMS],
    seen: [u32; WORDS],
}

impl<const BEAMS: usize, const WORDS: usize> ScanBuffers<BEAMS, WORDS> {
    /// All bits zero: costs no flash image in a `static`.
    pub const fn empty() -> Self {
        Self {
            slots: [BeamSlot::EMPTY; BEAMS],
            seen: [0; WORDS],
        }
    }

    /// A workspace over these buffers.
    pub fn workspace(&mut self) -> ScanWorkspace<'_> {
        ScanWorkspace::new_in(&mut self.slots, &mut self.seen)
    }
}

impl<'a> ScanWorkspace<'a> {
    /// A workspace over one slot per beam and, for `Accumulate`, one bit per cell (a word per
    /// 32 cells; empty for `Set`).
    pub fn new_in(slots: &'a mut [BeamSlot], seen: &'a mut [u32]) -> Self {
        Self {
            slots,
            seen,
            angles: BeamAngles {
                first: 0.0,
                span: 0.0,
                parts: 1,
            },
            computed: 0,
        }
    }

    /// Most beams a scan may have.
    pub fn beams(&self) -> usize {
        self.slots.len()
    }

    /// The slots of a scan's beams with their directions, and `words` cleared cell bits.
    pub(crate) fn prepare(&mut self, scan: &LaserScan<'_>, words: usize) -> Result<Prepared<'_>, Error> {
        let beams = scan.ranges.len();
        require(Buffer::Beams, beams, self.slots.len())?;
        require(Buffer::Seen, words, self.seen.len())?;
        self.point(
            beams,
            BeamAngles {
                first: scan.angle_min,
                span: scan.angle_increment,
                parts: 1,
            },
        );
        let seen = self.seen.get_mut(..words).unwrap_or_default();
        seen.fill(0);
        Ok(Prepared {
            slots: self.slots.get_mut(..beams).unwrap_or_default(),
            seen,
        })
    }

    /// The slots of `beams` beams with their directions; of fewer if there is no room for all.
    pub(crate) fn directed(&mut self, beams: usize, angles: BeamAngles) -> &mut [BeamSlot] {
        let beams = beams.min(self.slots.len());
        self.point(beams, angles);
        self.slots.get_mut(..beams).unwrap_or_default()
    }

    /// Computes the directions of the first `beams` beams, but for those that are there.
    fn point(&mut self, beams: usize, angles: BeamAngles) {
        if angles != self.angles {
            self.angles = angles;
            self.computed = 0;
        }
        let missing = self.slots.get_mut(self.computed..beams).unwrap_or_default();
        for (i, slot) in (self.computed..).zip(missing) {
            let (cos, sin) = math::beam_cos_sin(angles.angle(i));
            slot.direction = Vector2::new(cos, sin);
        }
        self.computed = self.computed.max(beams);
    }
}

/// A workspace made ready for one scan.
pub(crate) struct Prepared<'a> {
    pub slots: &'a mut [BeamSlot],
    pub seen: &'a mut [u32],
}
