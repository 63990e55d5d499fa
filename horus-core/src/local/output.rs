//! What the map publishes, and how others read it.

use super::{LocalGridMap, SensingState, Shape, state::check_name};
use crate::error::Error;
use crate::geometry::Pose2D;

const MAP: &str = "local_gridmap";
const ORIGIN: &str = "origin";
const RESOLUTION: &str = "resolution";
const TRANSFORMATION: &str = "transformation";

/// A local map as a [`SensingState`] holds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridMapView<'s> {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Metres per cell.
    pub resolution: f32,
    /// The corner of cell (0, 0), metres in the map's frame.
    pub origin: [f32; 2],
    /// All cells, row-major.
    pub data: &'s [u8],
}

impl<S: AsRef<[u8]>> LocalGridMap<'_, S> {
    /// Reserves the buffers of [`publish`](Self::publish): the map's cells, and three numbers, or six
    /// with the transformation.
    ///
    /// # Errors
    /// [`Error::BufferTooSmall`], [`Error::BufferType`]; the state is as it was then.
    pub fn prepare(&self, state: &mut SensingState<'_>) -> Result<(), Error> {
        let name = self.config().name;
        check_name(name)?;
        state.all_or_nothing(|state| {
            state.reserve::<u8>(name, MAP, self.info().cells())?;
            state.reserve::<f32>(name, ORIGIN, 2)?;
            state.reserve::<f32>(name, RESOLUTION, 1)?;
            if self.config().include_transformation {
                state.reserve::<f32>(name, TRANSFORMATION, 3)?;
            }
            Ok(())
        })
    }

    /// Copies the map into the state, for those who read it there: `local_gridmap` (height x width),
    /// `origin`, `resolution` and, if the configuration includes it and an update has made one,
    /// `transformation`, under the map's name. Nobody needs it who has the map itself.
    ///
    /// # Errors
    /// As [`prepare`](Self::prepare).
    ///
    /// # Complexity
    /// One read and one write per cell.
    pub fn publish(&self, state: &mut SensingState<'_>) -> Result<(), Error> {
        self.prepare(state)?;
        let name = self.config().name;
        state.write(name, MAP, Shape::grid(self.height(), self.width()), self.data())?;
        state.write(name, ORIGIN, Shape::line(2), &self.origin())?;
        state.write(name, RESOLUTION, Shape::line(1), &[self.resolution()])?;
        match self.transformation() {
            Some(Pose2D { x, y, theta }) if self.config().include_transformation => {
                state.write(name, TRANSFORMATION, Shape::line(3), &[x, y, theta])
            }
            _ => Ok(()),
        }
    }

    /// The map that was published under this map's name; `None` if none was.
    pub fn read_gridmap<'s>(&self, state: &'s SensingState<'_>) -> Option<GridMapView<'s>> {
        GridMapView::read_gridmap_with_name(state, self.config().name)
    }

    /// The transformation that was published under this map's name; `None` if none was.
    pub fn read_transformation(&self, state: &SensingState<'_>) -> Option<Pose2D> {
        GridMapView::read_transformation_with_name(state, self.config().name)
    }
}

impl<'s> GridMapView<'s> {
    /// The map that was published under a name; `None` if none was.
    pub fn read_gridmap_with_name(state: &'s SensingState<'_>, name: &str) -> Option<Self> {
        let map = state.read::<u8>(name, MAP)?;
        let &[x, y] = state.read::<f32>(name, ORIGIN)?.data() else {
            return None;
        };
        let &[resolution] = state.read::<f32>(name, RESOLUTION)?.data() else {
            return None;
        };
        Some(Self {
            width: map.shape().columns(),
            height: map.shape().rows(),
            resolution,
            origin: [x, y],
            data: map.data(),
        })
    }

    /// The transformation, from the map's frame to the world in metres and radians, that was published
    /// under a name; `None` if none was.
    pub fn read_transformation_with_name(state: &SensingState<'_>, name: &str) -> Option<Pose2D> {
        state.pose(name, TRANSFORMATION)
    }
}
