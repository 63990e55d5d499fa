//! What can go wrong with transforms.

use thiserror::Error;

/// Why a transform was not stored, or a pose could not be given.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum TfError {
    /// A frame name that no frame can have.
    #[error("frame name of {length} bytes is not valid: it must have 1 to {longest} bytes")]
    InvalidName {
        /// Its length without leading slashes.
        length: usize,
        /// The longest name accepted.
        longest: usize,
    },
    /// A frame given as its own parent.
    #[error("frame `{frame}` cannot be its own parent")]
    OwnParent {
        /// The frame.
        frame: String,
    },
    /// A transform with NaN or infinite numbers, given or computed.
    #[error("the transform from `{child}` to `{parent}` is not finite")]
    NotFinite {
        /// The frame the numbers are given in.
        parent: String,
        /// The frame described.
        child: String,
    },
    /// A rotation whose quaternion is zero.
    #[error("the rotation from `{child}` to `{parent}` is a zero quaternion")]
    ZeroQuaternion {
        /// The frame the numbers are given in.
        parent: String,
        /// The frame described.
        child: String,
    },
    /// A frame published both as static and as moving.
    #[error("frame `{child}` was {} before and cannot become {}", kind(*.was_static), kind(!*.was_static))]
    KindChanged {
        /// The frame.
        child: String,
        /// True if it was static so far.
        was_static: bool,
    },
    /// The buffer holds as many transforms as it may.
    #[error("the transform buffer is full: it holds {capacity} transforms")]
    Full {
        /// The number of transforms it may hold.
        capacity: usize,
    },
    /// A frame that no transform has mentioned.
    #[error("frame `{frame}` is unknown: no transform names it")]
    UnknownFrame {
        /// The frame.
        frame: String,
    },
    /// Two frames in different trees at that time.
    #[error("frames `{target}` and `{source_frame}` are not connected at {stamp_ns} ns")]
    Disconnected {
        /// The frame in which the pose was wanted.
        target: String,
        /// The frame whose pose was wanted.
        source_frame: String,
        /// The time asked for.
        stamp_ns: u64,
    },
    /// A time before the first or after the last transform of a moving frame.
    #[error(
        "the pose of `{child}` in `{parent}` at {stamp_ns} ns would be extrapolated: \
         it is known from {oldest_ns} to {newest_ns} ns"
    )]
    Extrapolation {
        /// The parent frame of the edge that does not reach.
        parent: String,
        /// The child frame of the edge that does not reach.
        child: String,
        /// The time asked for.
        stamp_ns: u64,
        /// The time of the edge's first transform.
        oldest_ns: u64,
        /// The time of the edge's last transform.
        newest_ns: u64,
    },
    /// A time between two transforms that lie too far apart.
    #[error(
        "the pose of `{child}` in `{parent}` at {stamp_ns} ns lies in a gap from {before_ns} to \
         {after_ns} ns, longer than the {max_gap_ns} ns allowed"
    )]
    Gap {
        /// The parent frame of the edge.
        parent: String,
        /// The child frame of the edge.
        child: String,
        /// The time asked for.
        stamp_ns: u64,
        /// The time of the last transform before it.
        before_ns: u64,
        /// The time of the first transform after it.
        after_ns: u64,
        /// The longest gap interpolated across.
        max_gap_ns: u64,
    },
    /// A time between two transforms of one frame that name different parents.
    #[error(
        "frame `{child}` moves from parent `{before}` to `{after}` around {stamp_ns} ns: \
         its pose there is not known"
    )]
    ParentChanged {
        /// The frame.
        child: String,
        /// Its parent in the last transform before that time.
        before: String,
        /// Its parent in the first transform after that time.
        after: String,
        /// The time asked for.
        stamp_ns: u64,
    },
    /// Frames that are each other's ancestors.
    #[error("the parents of frame `{frame}` form a loop at {stamp_ns} ns")]
    Loop {
        /// The frame whose parents were followed.
        frame: String,
        /// The time asked for.
        stamp_ns: u64,
    },
}

fn kind(is_static: bool) -> &'static str {
    if is_static { "static" } else { "moving" }
}
