use nalgebra::{Point2, Vector2};

use super::sealed::Sealed;

/// A point in metres: `Vector2<f32>`, `Point2<f32>` or `(f32, f32)`.
pub trait Point: Copy + Sealed {
    /// The same point as a vector from the frame's origin.
    fn vector(self) -> Vector2<f32>;
}

impl Sealed for Vector2<f32> {}
impl Sealed for Point2<f32> {}
impl Sealed for (f32, f32) {}

impl Point for Vector2<f32> {
    #[inline]
    fn vector(self) -> Vector2<f32> {
        self
    }
}

impl Point for Point2<f32> {
    #[inline]
    fn vector(self) -> Vector2<f32> {
        self.coords
    }
}

impl Point for (f32, f32) {
    #[inline]
    fn vector(self) -> Vector2<f32> {
        Vector2::new(self.0, self.1)
    }
}
