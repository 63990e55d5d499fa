use nalgebra::{Isometry2, Vector2};

use super::{DenseGrid2, HorusValues, LinearGrid2, OccupancyGrid2d, RegularGrid};
use crate::grid::OccupancyGrid;

impl<S: AsRef<[i8]>> RegularGrid for OccupancyGrid<S> {
    fn resolution(&self) -> f32 {
        self.info().resolution()
    }
}

impl<S: AsRef<[i8]>> DenseGrid2 for OccupancyGrid<S> {
    type Data = i8;

    fn width(&self) -> u32 {
        self.info().width()
    }

    fn height(&self) -> u32 {
        self.info().height()
    }

    #[inline]
    fn value(&self, cell: Vector2<i32>) -> Option<i8> {
        self.data().get(self.index_at(cell)?).copied()
    }
}

impl<S: AsRef<[i8]>> LinearGrid2 for OccupancyGrid<S> {
    #[inline]
    fn data(&self) -> &[i8] {
        self.data()
    }
}

impl<S: AsRef<[i8]>> OccupancyGrid2d for OccupancyGrid<S> {
    type Values = HorusValues;

    #[inline]
    fn value_traits(&self) -> HorusValues {
        HorusValues
    }

    fn origin(&self) -> Isometry2<f32> {
        self.info().isometry()
    }
}
