use core::f32::consts::{PI, TAU};

use super::bearing::{self, bearing};
use super::flatscan::LEAST_GAP;
use super::{Flatscan, ScanClass, SensorModel};
use crate::error::{Buffer, Error, require};
use crate::math;

/// How far one beam of a scan frees and occupies cells: squared metres. Storage of a scan's
/// projection, one per beam, 8 bytes; the contents do not matter between calls.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BeamLimits {
    /// Cells nearer than this are free.
    free: f32,
    /// Cells from there on and nearer than this are occupied.
    occupied: f32,
}

impl BeamLimits {
    /// All bits zero: a beam that says nothing.
    pub const EMPTY: Self = Self {
        free: 0.0,
        occupied: 0.0,
    };

    fn new(range: f32, visibility: f32, scan: &Flatscan<'_>, model: &SensorModel) -> Self {
        // A NaN fails the comparison, and -inf is below every threshold.
        let is_valid = range > scan.invalid_range_threshold && visibility > 0.0;
        if !is_valid {
            return Self::EMPTY;
        }
        let (free, occupied) = if range >= scan.out_of_range_threshold || range == f32::INFINITY {
            let reach = model.max_free_range.unwrap_or(scan.out_of_range_threshold);
            (reach * reach, reach * reach)
        } else {
            let back = range + model.wall_thickness;
            (range * range, back * back)
        };
        let seen = visibility * visibility;
        Self {
            free: free.min(seen),
            occupied: occupied.min(seen),
        }
    }

    #[inline]
    fn class(&self, d2: f32) -> ScanClass {
        if d2 < self.free {
            ScanClass::Free
        } else if d2 < self.occupied {
            ScanClass::Occupied
        } else {
            ScanClass::Vacuous
        }
    }
}

/// The beams of a checked scan.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Beams<'a> {
    angles: &'a [f32],
    limits: &'a [BeamLimits],
    /// Angle over which the last and the first beam are neighbours; `None`: they are not.
    closing_gap: Option<f32>,
    half_width: Option<f32>,
    guess: Guess,
    /// Squared metres from which on no beam says anything.
    pub(crate) reach: f32,
}

impl<'a> Beams<'a> {
    /// Checks scan and model, and computes the limits.
    pub(crate) fn new(
        scan: &Flatscan<'a>,
        model: &SensorModel,
        limits: &'a mut [BeamLimits],
    ) -> Result<Self, Error> {
        scan.validate()?;
        model.validate()?;
        let angles = scan.angles;
        require(Buffer::Beams, angles.len(), limits.len())?;
        model.check_beams(angles.len())?;
        let limits = limits.get_mut(..angles.len()).unwrap_or_default();
        let mut reach = 0.0f32;
        let mut visibilities = scan.visibilities.unwrap_or_default().iter();
        for (limits, range) in limits.iter_mut().zip(scan.ranges) {
            let visibility = visibilities.next().copied().unwrap_or(f32::INFINITY);
            *limits = BeamLimits::new(*range, visibility, scan, model);
            reach = reach.max(limits.occupied);
        }
        let closing_gap = closing_gap(angles);
        Ok(Self {
            angles,
            limits,
            closing_gap,
            half_width: model.beam_half_width,
            guess: Guess::new(angles, model.beam_half_width, closing_gap),
            reach,
        })
    }

    /// What the scan says about the point (x, y) in the sensor's frame at squared distance `d2`.
    ///
    /// The nearest beam is guessed from an approximate bearing; where that lies too near to a border
    /// between beams to be sure, it is found by the definition. The result is the definition's.
    #[inline]
    pub(crate) fn class(&self, x: f32, y: f32, d2: f32) -> ScanClass {
        let a = bearing(y, x);
        let (beam, a) = self.guess.beam(a);
        // Not true for NaN.
        if (a - self.angle(beam)).abs() < self.guess.certain && self.is_inner(beam) {
            self.limits.get(beam).copied().unwrap_or_default().class(d2)
        } else {
            // Between the ends of an open fan nothing needs to be found.
            if a > self.guess.open.0 && a < self.guess.open.1 {
                return ScanClass::Vacuous;
            }
            self.class_by_definition(math::atan2(y, x), d2, beam)
        }
    }

    /// True unless it is the first or the last beam.
    #[inline]
    fn is_inner(&self, beam: usize) -> bool {
        beam.wrapping_sub(1) < self.angles.len().wrapping_sub(2)
    }

    /// What the scan says about a cell at squared distance `d2` in direction `a`; `beam` is where the
    /// search for the nearest begins.
    #[inline(never)]
    fn class_by_definition(&self, a: f32, d2: f32, beam: usize) -> ScanClass {
        let beam = &mut beam.min(self.angles.len().saturating_sub(1));
        let difference = self.nearest(a, beam);
        if self.covers(*beam, difference) {
            self.limits.get(*beam).copied().unwrap_or_default().class(d2)
        } else {
            ScanClass::Vacuous
        }
    }

    /// Walks from `beam` around the circle to the beam nearest to direction `a`; of two as near, the
    /// lower index. Returns the direction as seen from that beam.
    #[inline]
    fn nearest(&self, a: f32, beam: &mut usize) -> f32 {
        let mut best = self.difference(a, *beam);
        if self.guess.overlaps {
            for candidate in 0..self.angles.len() {
                self.improve(a, beam, &mut best, candidate);
            }
            return best;
        }
        let last = self.angles.len().saturating_sub(1);
        loop {
            // Distances around a circle fall up to the nearest beam and rise behind it, so the first
            // beam that is no nearer ends the walk.
            if best >= 0.0 {
                while self.improve(a, beam, &mut best, self.after(*beam)) {}
                // The lower index of a tie, and a start just beyond the beam behind.
                while self.improve(a, beam, &mut best, self.before(*beam)) {}
            } else {
                while self.improve(a, beam, &mut best, self.before(*beam)) {}
                while self.improve(a, beam, &mut best, self.after(*beam)) {}
            }
            // But for the seam of a full circle: there the last beam may be the first, up to rounding.
            if self.is_inner(*beam) && *beam != 1 && beam.wrapping_add(1) != last {
                return best;
            }
            let mut seam = [0, last.min(1), last.saturating_sub(1), last].into_iter();
            if !seam.any(|candidate| self.improve(a, beam, &mut best, candidate)) {
                return best;
            }
        }
    }

    /// Takes `candidate` if it is nearer, or as near and lower.
    #[inline]
    fn improve(&self, a: f32, beam: &mut usize, best: &mut f32, candidate: usize) -> bool {
        let difference = self.difference(a, candidate);
        let (old, new) = (best.abs(), difference.abs());
        let better = new < old || (new == old && candidate < *beam);
        if better {
            *beam = candidate;
            *best = difference;
        }
        better
    }

    #[inline]
    fn after(&self, beam: usize) -> usize {
        let next = beam.wrapping_add(1);
        if next < self.angles.len() { next } else { 0 }
    }

    #[inline]
    fn before(&self, beam: usize) -> usize {
        beam.checked_sub(1).unwrap_or(self.angles.len().saturating_sub(1))
    }

    /// Direction `a` seen from a beam, within a half turn to both sides.
    #[inline]
    fn difference(&self, a: f32, beam: usize) -> f32 {
        let difference = a - self.angle(beam);
        if difference > PI {
            difference - TAU
        } else if difference < -PI {
            difference + TAU
        } else {
            difference
        }
    }

    #[inline]
    fn angle(&self, beam: usize) -> f32 {
        self.angles.get(beam).copied().unwrap_or(0.0)
    }

    #[inline]
    fn covers(&self, beam: usize, difference: f32) -> bool {
        if let Some(half) = self.half_width {
            return difference.abs() <= half;
        }
        let last = self.angles.len().wrapping_sub(1);
        let gap = if difference >= 0.0 {
            if beam < last {
                self.angle(beam.wrapping_add(1)) - self.angle(beam)
            } else {
                self.closing_gap
                    .unwrap_or(self.angle(last) - self.angle(last.wrapping_sub(1)))
            }
        } else if beam > 0 {
            self.angle(beam) - self.angle(beam.wrapping_sub(1))
        } else {
            self.closing_gap.unwrap_or(self.angle(1) - self.angle(0))
        };
        difference.abs() <= 0.5 * gap
    }
}

/// Where the beam nearest to a bearing is likely to be.
#[derive(Clone, Copy, Debug)]
struct Guess {
    first: f32,
    /// Beams per radian, if they were evenly spread.
    density: f32,
    /// A bearing nearer than this to an inner beam lies nearest to it, and is covered by it: half the
    /// smallest gap (or the beams' half width), but for what bearings and differences may be off.
    certain: f32,
    /// Whether the fan runs over its own beginning by more than rounding, so that beams there are not in order.
    overlaps: bool,
    /// Between these bearings no beam covers anything; empty for a full circle.
    open: (f32, f32),
}

impl Guess {
    fn new(angles: &[f32], half_width: Option<f32>, closing_gap: Option<f32>) -> Self {
        let (first, last) = (angles.first().copied(), angles.last().copied());
        let (first, last) = (first.unwrap_or(0.0), last.unwrap_or(0.0));
        let gaps = angles.iter().zip(angles.iter().skip(1)).map(|(a, b)| b - a);
        let (smallest, largest) = gaps.fold((TAU, 0.0), |(s, l): (f32, f32), gap| (s.min(gap), l.max(gap)));
        let half = 0.5 * smallest;
        let reach = half_width.unwrap_or(0.5 * largest) + 2.0 * bearing::ERROR;
        let open = if half_width.is_some() || closing_gap.is_none() {
            (last + reach, (first + TAU) - reach)
        } else {
            (f32::INFINITY, f32::NEG_INFINITY)
        };
        let half = half_width.map_or(half, |width| half.min(width));
        let inner = angles.len().saturating_sub(1) as f32;
        let overlaps = last - first > TAU + LEAST_GAP;
        Self {
            overlaps,
            first,
            density: if last > first { inner / (last - first) } else { 0.0 },
            certain: if overlaps {
                -1.0
            } else {
                half - 2.0 * bearing::ERROR
            },
            open,
        }
    }

    /// A beam, which may be one that there is not, and the bearing on the turn that the beams are on.
    #[inline]
    fn beam(&self, a: f32) -> (usize, f32) {
        let a = if a < self.first {
            a + TAU
        } else if a > self.first + TAU {
            a - TAU
        } else {
            a
        };
        // The cast saturates.
        (((a - self.first) * self.density + 0.5) as usize, a)
    }
}

/// The gap between the last and the first beam of a full circle: at most 1.5 times the largest other.
fn closing_gap(angles: &[f32]) -> Option<f32> {
    let (first, last) = (angles.first()?, angles.last()?);
    let closing = (first + TAU) - last;
    let gaps = angles.iter().zip(angles.iter().skip(1)).map(|(a, b)| b - a);
    let largest = gaps.fold(0.0, f32::max);
    (closing <= 1.5 * largest).then_some(closing)
}
