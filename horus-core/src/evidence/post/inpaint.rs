use super::super::Masses;
use super::super::viewpoint::Viewpoint;
use crate::error::{Error, Parameter};
use crate::geometry::GridInfo;

/// The frame that a painted rectangle lies in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InpaintFrame {
    /// It moves with the robot: a blind spot, the robot's own body.
    #[default]
    Robot,
    /// It stays where it is in the world.
    World,
}

/// A rectangle whose cells are given masses, whatever the sensors say.
///
/// It holds the cells whose centre lies in the closed rectangle. Of several, the last that holds a
/// cell counts. Painting does not change the fused map: it is laid over what is read from it.
///
/// Source: Isaac `EvidenceMapInpaint`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Inpaint {
    /// Frame of the rectangle.
    pub frame: InpaintFrame,
    /// First and last x, metres, finite and in order.
    pub x: [f32; 2],
    /// First and last y, metres, finite and in order.
    pub y: [f32; 2],
    /// What its cells hold.
    pub masses: Masses,
}

impl Inpaint {
    /// Checks the rectangle.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`].
    pub fn validate(&self) -> Result<(), Error> {
        let is_span = |[from, to]: [f32; 2]| from.is_finite() && to.is_finite() && from <= to;
        if is_span(self.x) && is_span(self.y) {
            Ok(())
        } else {
            Err(Error::InvalidParameter(Parameter::InpaintRectangle))
        }
    }

    /// The rectangle over a map while the robot stands somewhere.
    pub(in super::super) fn placed<'m>(&self, info: &'m GridInfo, robot: &Viewpoint) -> PlacedInpaint<'m> {
        PlacedInpaint {
            rect: *self,
            viewpoint: match self.frame {
                InpaintFrame::Robot => Some(*robot),
                InpaintFrame::World => None,
            },
            info,
        }
    }
}

/// A painted rectangle over the cells of a map.
pub(in super::super) struct PlacedInpaint<'m> {
    rect: Inpaint,
    /// Where the rectangle's frame lies in the world, unless it is the world.
    viewpoint: Option<Viewpoint>,
    info: &'m GridInfo,
}

impl PlacedInpaint<'_> {
    pub(crate) fn holds(&self, gx: u32, gy: u32) -> bool {
        let Some(center) = self.info.grid_to_world(gx, gy) else {
            return false;
        };
        let (x, y) = self.viewpoint.map_or(center, |viewpoint| viewpoint.see(center));
        let within = |[from, to]: [f32; 2], v: f32| from <= v && v <= to;
        within(self.rect.x, x) && within(self.rect.y, y)
    }

    /// Shows the cells it holds.
    ///
    /// Complexity: the cells of its bounding box.
    pub(crate) fn for_each(&self, mut show: impl FnMut(u32, u32)) {
        let Inpaint { x, y, .. } = self.rect;
        let (mut low, mut high) = ([f32::INFINITY; 2], [f32::NEG_INFINITY; 2]);
        let mut far = 0.0f32;
        for corner in [(x[0], y[0]), (x[0], y[1]), (x[1], y[0]), (x[1], y[1])] {
            let (wx, wy) = self.viewpoint.map_or(corner, |viewpoint| viewpoint.point(corner));
            far = far.max(wx.abs() + wy.abs());
            let (cx, cy) = self.info.world_to_continuous(wx, wy);
            low = [low[0].min(cx), low[1].min(cy)];
            high = [high[0].max(cx), high[1].max(cy)];
        }
        // Two cells more for what rounding may hide near the origin, and some steps of f32 far from it,
        // where they are longer than a cell; casts saturate.
        let margin = 2.0 + 8.0 * f32::EPSILON * far / self.info.resolution();
        let span =
            |low: f32, high: f32, size: u32| (low - margin) as u32..((high + 1.0 + margin) as u32).min(size);
        let columns = span(low[0], high[0], self.info.width());
        for gy in span(low[1], high[1], self.info.height()) {
            for gx in columns.clone() {
                if self.holds(gx, gy) {
                    show(gx, gy);
                }
            }
        }
    }
}
