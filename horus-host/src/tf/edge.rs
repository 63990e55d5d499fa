//! One frame's connection to its parent over time.

use std::collections::BTreeMap;

use nalgebra::{Isometry3, Translation3};

/// One transform of a frame: where it was in which parent.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    /// Index of the parent frame.
    pub parent: usize,
    /// parent_from_child.
    pub isometry: Isometry3<f64>,
}

/// All that is known of one frame's pose in its parents.
#[derive(Debug, Clone)]
pub(super) enum Edge {
    /// The same at any time.
    Static(Sample),
    /// Samples by time in nanoseconds; never empty.
    Moving(BTreeMap<u64, Sample>),
}

/// Why an edge has no pose at a time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum NoPose {
    Outside { oldest_ns: u64, newest_ns: u64 },
    Gap { before_ns: u64, after_ns: u64 },
    ParentChanged { before: usize, after: usize },
}

impl Edge {
    /// The parent at a time: that of the last sample until then, else of the first sample.
    ///
    /// It is defined beyond the samples too, so that an edge that does not reach can be named.
    pub fn parent_at(&self, stamp_ns: u64) -> Option<usize> {
        match self {
            Self::Static(sample) => Some(sample.parent),
            Self::Moving(samples) => samples
                .range(..=stamp_ns)
                .next_back()
                .or_else(|| samples.first_key_value())
                .map(|(_, sample)| sample.parent),
        }
    }

    /// parent_from_child at a time, with the parent of [`Self::parent_at`].
    ///
    /// # Complexity
    /// Logarithmic in the number of samples.
    pub fn pose_at(&self, stamp_ns: u64, max_gap_ns: Option<u64>) -> Result<Isometry3<f64>, NoPose> {
        let samples = match self {
            Self::Static(sample) => return Ok(sample.isometry),
            Self::Moving(samples) => samples,
        };
        let before = samples.range(..=stamp_ns).next_back();
        let after = samples.range(stamp_ns..).next();
        let (Some((&before_ns, before)), Some((&after_ns, after))) = (before, after) else {
            return Err(NoPose::Outside {
                oldest_ns: samples.first_key_value().map_or(0, |(&ns, _)| ns),
                newest_ns: samples.last_key_value().map_or(0, |(&ns, _)| ns),
            });
        };
        if before_ns == after_ns {
            return Ok(before.isometry);
        }
        if before.parent != after.parent {
            return Err(NoPose::ParentChanged {
                before: before.parent,
                after: after.parent,
            });
        }
        let gap_ns = after_ns - before_ns;
        if max_gap_ns.is_some_and(|longest| gap_ns > longest) {
            return Err(NoPose::Gap { before_ns, after_ns });
        }
        let part = (stamp_ns - before_ns) as f64 / gap_ns as f64;
        Ok(interpolate(&before.isometry, &after.isometry, part))
    }
}

/// Translation along a straight line, rotation along the shorter arc.
fn interpolate(a: &Isometry3<f64>, b: &Isometry3<f64>, part: f64) -> Isometry3<f64> {
    let translation = a.translation.vector * (1.0 - part) + b.translation.vector * part;
    // Slerp divides by the sine of the angle between the two, which is 0 only where they are
    // equal: then either is the answer.
    let rotation = a
        .rotation
        .try_slerp(&b.rotation, part, 1e-12)
        .unwrap_or(a.rotation);
    Isometry3::from_parts(Translation3::from(translation), rotation)
}
