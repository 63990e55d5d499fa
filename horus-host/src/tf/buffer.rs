//! The transforms of a log.

use std::collections::BTreeMap;

use nalgebra::Isometry3;

use super::edge::{Edge, NoPose, Sample};
use super::{Pose2, TfError, Transform};

/// The longest frame name accepted, in bytes.
const LONGEST_NAME: usize = 255;

/// The transforms of a log, and the pose of any frame in any other at any recorded time.
///
/// Frame names are the same with and without leading `/`. A frame has one parent at a time; a log
/// may change it.
///
/// # Memory
/// Every transform is kept (about 100 bytes each) so that a log may be read in any order. The
/// buffer refuses more than its capacity, [`TfBuffer::DEFAULT_CAPACITY`] unless
/// [`TfBuffer::with_capacity`] says otherwise; nothing is ever dropped silently.
///
/// # Examples
/// ```
/// use horus_host::tf::{TfBuffer, Transform};
///
/// let mut buffer = TfBuffer::new();
/// buffer.insert("odom", "base_link", 1_000, Transform::planar(0.0, 0.0, 0.0), false)?;
/// buffer.insert("odom", "base_link", 3_000, Transform::planar(2.0, 0.0, 0.0), false)?;
/// buffer.insert("base_link", "laser", 0, Transform::planar(0.25, 0.0, 0.0), true)?;
///
/// let pose = buffer.lookup("odom", "laser", 2_000)?;
/// assert_eq!((pose.x, pose.y, pose.yaw), (1.25, 0.0, 0.0));
/// assert!(buffer.lookup("odom", "laser", 4_000).is_err());
/// # Ok::<(), horus_host::tf::TfError>(())
/// ```
#[derive(Debug, Clone)]
pub struct TfBuffer {
    ids: BTreeMap<String, usize>,
    frames: Vec<Frame>,
    stored: usize,
    capacity: usize,
    max_gap_ns: Option<u64>,
}

#[derive(Debug, Clone)]
struct Frame {
    name: String,
    edge: Option<Edge>,
}

impl Default for TfBuffer {
    fn default() -> Self {
        Self::new()
    }
}

impl TfBuffer {
    /// The number of transforms a buffer may hold by default: 4 million, about 400 MB when full.
    /// A robot that publishes ten frames at 100 Hz fills it in 67 minutes.
    pub const DEFAULT_CAPACITY: usize = 4_000_000;

    /// An empty buffer of the default capacity, which interpolates across gaps of any length.
    pub fn new() -> Self {
        Self::with_capacity(Self::DEFAULT_CAPACITY)
    }

    /// An empty buffer that holds at most `capacity` transforms. Nothing is allocated yet.
    pub fn with_capacity(capacity: usize) -> Self {
        Self {
            ids: BTreeMap::new(),
            frames: Vec::new(),
            stored: 0,
            capacity,
            max_gap_ns: None,
        }
    }

    /// Refuses to interpolate between two transforms that lie more than this apart (`None`: any
    /// gap is fine). A time that has a transform of its own is never in a gap.
    pub fn set_max_gap_ns(&mut self, max_gap_ns: Option<u64>) {
        self.max_gap_ns = max_gap_ns;
    }

    /// The number of transforms held.
    pub fn len(&self) -> usize {
        self.stored
    }

    /// True if no transform is held.
    pub fn is_empty(&self) -> bool {
        self.stored == 0
    }

    /// Stores the pose of `child` in `parent` at a time (metres, nanoseconds).
    ///
    /// Transforms may come in any order. A second one for the same child and time replaces the
    /// first. A static one holds at all times, whatever its stamp, and replaces the static one
    /// before it. Quaternions are brought to unit length.
    ///
    /// # Errors
    /// [`TfError::InvalidName`], [`TfError::OwnParent`], [`TfError::NotFinite`],
    /// [`TfError::ZeroQuaternion`], [`TfError::KindChanged`] or [`TfError::Full`]; the buffer is
    /// then unchanged. A loop is found by [`TfBuffer::lookup`], since parents may change with time.
    ///
    /// # Complexity
    /// Logarithmic in the number of frames and of the child's transforms.
    pub fn insert(
        &mut self,
        parent: &str,
        child: &str,
        stamp_ns: u64,
        transform: Transform,
        is_static: bool,
    ) -> Result<(), TfError> {
        let parent = checked_name(parent)?;
        let child = checked_name(child)?;
        if parent == child {
            return Err(TfError::OwnParent {
                frame: child.to_string(),
            });
        }
        let names = || (parent.to_string(), child.to_string());
        if !transform.is_finite() {
            let (parent, child) = names();
            return Err(TfError::NotFinite { parent, child });
        }
        let Some(isometry) = transform.to_isometry() else {
            let (parent, child) = names();
            return Err(TfError::ZeroQuaternion { parent, child });
        };
        let is_new = match self.edge_of(child) {
            None => true,
            Some(Edge::Static(_)) if is_static => false,
            Some(Edge::Moving(samples)) if !is_static => !samples.contains_key(&stamp_ns),
            Some(edge) => {
                return Err(TfError::KindChanged {
                    child: child.to_string(),
                    was_static: matches!(edge, Edge::Static(_)),
                });
            }
        };
        if is_new && self.stored >= self.capacity {
            return Err(TfError::Full {
                capacity: self.capacity,
            });
        }

        let parent = self.id_or_insert(parent);
        let child = self.id_or_insert(child);
        let sample = Sample { parent, isometry };
        let edge = &mut self.frames[child].edge;
        match edge {
            Some(Edge::Moving(samples)) => {
                samples.insert(stamp_ns, sample);
            }
            _ if is_static => *edge = Some(Edge::Static(sample)),
            _ => *edge = Some(Edge::Moving(BTreeMap::from([(stamp_ns, sample)]))),
        }
        self.stored += usize::from(is_new);
        Ok(())
    }

    /// The planar pose of `source_frame` in `target_frame` at a time: the x and y of its origin
    /// and the direction of its x axis, seen from above ([`Transform::to_planar`]).
    ///
    /// # Errors
    /// As [`TfBuffer::lookup_transform`].
    pub fn lookup(&self, target_frame: &str, source_frame: &str, stamp_ns: u64) -> Result<Pose2, TfError> {
        Ok(self
            .lookup_transform(target_frame, source_frame, stamp_ns)?
            .to_planar())
    }

    /// The pose of `source_frame` in `target_frame` at a time, in space. It takes points given in
    /// the source frame to the target frame.
    ///
    /// Each moving edge between the two is interpolated at that time: translation along a line,
    /// rotation along the shorter arc. Edges beyond their common ancestor play no part.
    ///
    /// # Errors
    /// [`TfError::UnknownFrame`], [`TfError::Disconnected`], [`TfError::Extrapolation`],
    /// [`TfError::Gap`], [`TfError::ParentChanged`], [`TfError::Loop`], or [`TfError::NotFinite`]
    /// if the result overflows.
    ///
    /// # Complexity
    /// Linear in the depth of the tree, times the logarithm of an edge's transforms.
    pub fn lookup_transform(
        &self,
        target_frame: &str,
        source_frame: &str,
        stamp_ns: u64,
    ) -> Result<Transform, TfError> {
        let target = self.id(target_frame)?;
        let source = self.id(source_frame)?;
        let mut target_line = self.line_to_root(target, stamp_ns)?;
        let mut source_line = self.line_to_root(source, stamp_ns)?;
        if target_line.last() != source_line.last() {
            return Err(TfError::Disconnected {
                target: self.frames[target].name.clone(),
                source_frame: self.frames[source].name.clone(),
                stamp_ns,
            });
        }
        while target_line.last().is_some() && target_line.last() == source_line.last() {
            target_line.pop();
            source_line.pop();
        }
        let ancestor_from_target = self.climb(&target_line, stamp_ns)?;
        let ancestor_from_source = self.climb(&source_line, stamp_ns)?;
        let result = Transform::from_isometry(&ancestor_from_target.inv_mul(&ancestor_from_source));
        if !result.is_finite() {
            return Err(TfError::NotFinite {
                parent: self.frames[target].name.clone(),
                child: self.frames[source].name.clone(),
            });
        }
        Ok(result)
    }

    /// The frame and all its ancestors at a time, the root last.
    fn line_to_root(&self, frame: usize, stamp_ns: u64) -> Result<Vec<usize>, TfError> {
        let mut line = vec![frame];
        let mut at = frame;
        while let Some(edge) = &self.frames[at].edge {
            let Some(parent) = edge.parent_at(stamp_ns) else {
                break;
            };
            // A line without repetition cannot be longer than the number of frames.
            if line.len() >= self.frames.len() {
                return Err(TfError::Loop {
                    frame: self.frames[frame].name.clone(),
                    stamp_ns,
                });
            }
            line.push(parent);
            at = parent;
        }
        Ok(line)
    }

    /// The pose of the first frame of a line of descent in the parent of its last.
    fn climb(&self, line: &[usize], stamp_ns: u64) -> Result<Isometry3<f64>, TfError> {
        let mut pose = Isometry3::identity();
        for &child in line {
            if let Some(edge) = &self.frames[child].edge {
                let step = edge
                    .pose_at(stamp_ns, self.max_gap_ns)
                    .map_err(|reason| self.explain(child, edge, stamp_ns, reason))?;
                pose = step * pose;
            }
        }
        Ok(pose)
    }

    fn explain(&self, child: usize, edge: &Edge, stamp_ns: u64, reason: NoPose) -> TfError {
        let name = |frame: usize| self.frames[frame].name.clone();
        let parent = edge.parent_at(stamp_ns).map_or_else(String::new, name);
        let child = name(child);
        match reason {
            NoPose::Outside { oldest_ns, newest_ns } => TfError::Extrapolation {
                parent,
                child,
                stamp_ns,
                oldest_ns,
                newest_ns,
            },
            NoPose::Gap { before_ns, after_ns } => TfError::Gap {
                parent,
                child,
                stamp_ns,
                before_ns,
                after_ns,
                max_gap_ns: self.max_gap_ns.unwrap_or(u64::MAX),
            },
            NoPose::ParentChanged { before, after } => TfError::ParentChanged {
                child,
                before: name(before),
                after: name(after),
                stamp_ns,
            },
        }
    }

    fn id(&self, name: &str) -> Result<usize, TfError> {
        let name = checked_name(name)?;
        let unknown = || TfError::UnknownFrame {
            frame: name.to_string(),
        };
        self.ids.get(name).copied().ok_or_else(unknown)
    }

    fn edge_of(&self, name: &str) -> Option<&Edge> {
        let id = *self.ids.get(name)?;
        self.frames[id].edge.as_ref()
    }

    fn id_or_insert(&mut self, name: &str) -> usize {
        if let Some(&id) = self.ids.get(name) {
            return id;
        }
        let id = self.frames.len();
        self.ids.insert(name.to_string(), id);
        self.frames.push(Frame {
            name: name.to_string(),
            edge: None,
        });
        id
    }
}

/// A frame name without its leading slashes.
fn checked_name(name: &str) -> Result<&str, TfError> {
    let name = name.trim_start_matches('/');
    if name.is_empty() || name.len() > LONGEST_NAME {
        return Err(TfError::InvalidName {
            length: name.len(),
            longest: LONGEST_NAME,
        });
    }
    Ok(name)
}
