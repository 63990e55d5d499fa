//! The std version's grid under the traits of the embedded core, so that algorithms written for those run on it.

use horus_core::grid::{DenseGrid2, HorusValues, LinearGrid2, OccupancyGrid2d, RegularGrid};
use horus_core::nalgebra::{Isometry2, Translation2, UnitComplex, Vector2};

use crate::reference::OccupancyGrid;

impl RegularGrid for OccupancyGrid {
    fn resolution(&self) -> f32 {
        self.resolution
    }
}

impl DenseGrid2 for OccupancyGrid {
    type Data = i8;

    fn width(&self) -> u32 {
        self.width
    }

    fn height(&self) -> u32 {
        self.height
    }

    fn value(&self, cell: Vector2<i32>) -> Option<i8> {
        self.data.get(self.index_at(cell)?).copied()
    }
}

impl LinearGrid2 for OccupancyGrid {
    fn data(&self) -> &[i8] {
        &self.data
    }
}

impl OccupancyGrid2d for OccupancyGrid {
    type Values = HorusValues;

    fn value_traits(&self) -> HorusValues {
        HorusValues
    }

    fn origin(&self) -> Isometry2<f32> {
        let pose = self.origin;
        let (sin, cos) = libm::sincosf(pose.theta as f32);
        Isometry2::from_parts(
            Translation2::new(pose.x as f32, pose.y as f32),
            UnitComplex::from_cos_sin_unchecked(cos, sin),
        )
    }
}
