//! Coordinate frames of a recorded log: which pose did one frame have in another at a given time?
//!
//! A [`TfBuffer`] takes the transforms of a log (`/tf` and `/tf_static`) and answers
//! [`TfBuffer::lookup`] between any two connected frames. It is stricter than a live transform
//! listener, because a replay must give the same answer on every run: it never extrapolates, never
//! waits, never answers "the latest", and never guesses between two parents.

mod buffer;
mod edge;
mod error;
mod pose2;
#[cfg(test)]
mod tests;
mod transform;

pub use buffer::TfBuffer;
pub use error::TfError;
pub use pose2::Pose2;
pub use transform::Transform;
