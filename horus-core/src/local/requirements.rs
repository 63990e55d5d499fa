use nalgebra::{Isometry2, Vector2};

use super::LocalGridMap;
use crate::grid::{DenseGrid2, LinearGrid2, LocalMapValues, OccupancyGrid2d, RegularGrid};

impl<S: AsRef<[u8]>> RegularGrid for LocalGridMap<'_, S> {
    fn resolution(&self) -> f32 {
        self.info().resolution()
    }
}

impl<S: AsRef<[u8]>> DenseGrid2 for LocalGridMap<'_, S> {
    type Data = u8;

    fn width(&self) -> u32 {
        self.info().width()
    }

    fn height(&self) -> u32 {
        self.info().height()
    }

    #[inline]
    fn value(&self, cell: Vector2<i32>) -> Option<u8> {
        self.data().get(self.index_at(cell)?).copied()
    }
}

impl<S: AsRef<[u8]>> LinearGrid2 for LocalGridMap<'_, S> {
    #[inline]
    fn data(&self) -> &[u8] {
        self.data()
    }
}

impl<S: AsRef<[u8]>> OccupancyGrid2d for LocalGridMap<'_, S> {
    type Values = LocalMapValues;

    #[inline]
    fn value_traits(&self) -> LocalMapValues {
        LocalMapValues
    }

    fn origin(&self) -> Isometry2<f32> {
        self.info().isometry()
    }
}
