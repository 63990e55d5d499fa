//! What is made of the fused map, on copies: painted rectangles, the binary map, occupancy values.

mod binary;
mod distance;
mod inpaint;
mod occupancy;
mod thresholds;

pub use self::binary::BinaryMap;
pub(super) use self::binary::Decision;
pub use self::distance::binary_to_distance;
pub use self::inpaint::{Inpaint, InpaintFrame};
pub use self::occupancy::evidence_to_occupancy;
pub use self::thresholds::BinaryThresholds;
