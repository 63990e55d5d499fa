use super::{FrameKind, FrameNames, Payload, Put, Take};
use crate::costmap::{CostMap, CostParams, Decay, FieldCell};
use crate::geometry::Pose2D;
use crate::grid::ScanModel;

/// What a log has to know of the map and the robot; sent before every key tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Session<'a> {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Metres per cell.
    pub resolution: f32,
    /// Pose of the corner of cell (0, 0) in the map's frame before the window first moved.
    pub origin: Pose2D,
    /// Parameters of the cost map.
    pub params: CostParams,
    /// How scans change cells.
    pub model: ScanModel,
    /// The lidar on the robot, metres and radians.
    pub mount: Pose2D,
    /// Names of the coordinate frames.
    pub names: FrameNames<'a>,
}

impl<'a> Session<'a> {
    /// The session of a map.
    pub fn of<F: FieldCell>(
        map: &CostMap<'_, F>,
        model: ScanModel,
        mount: Pose2D,
        names: FrameNames<'a>,
    ) -> Self {
        let info = map.info();
        Self {
            width: info.width(),
            height: info.height(),
            resolution: info.resolution(),
            origin: info.first_origin(),
            params: *map.params(),
            model,
            mount,
            names,
        }
    }
}

impl<'a> Payload<'a> for Session<'a> {
    const KIND: FrameKind = FrameKind::Session;

    fn put(&self, out: &mut Put<'_>) {
        out.u32(self.width);
        out.u32(self.height);
        out.f32(self.resolution);
        out.pose(self.origin);
        put_params(&self.params, out);
        put_model(self.model, out);
        out.pose(self.mount);
        out.name(self.names.odom);
        out.name(self.names.base);
        out.name(self.names.sensor);
    }

    fn take(from: &mut Take<'a>) -> Option<Self> {
        Some(Self {
            width: from.u32()?,
            height: from.u32()?,
            resolution: from.f32()?,
            origin: from.pose()?,
            params: take_params(from)?,
            model: take_model(from)?,
            mount: from.pose()?,
            names: FrameNames {
                odom: from.name()?,
                base: from.name()?,
                sensor: from.name()?,
            },
        })
    }
}

fn put_params(params: &CostParams, out: &mut Put<'_>) {
    out.f32(params.inflation_radius);
    out.f32(params.cost_scaling_factor);
    out.u8(params.lethal_cost);
    out.u8(params.lethal_threshold as u8);
    out.u8(params.unknown_inflates.into());
    out.u8(match params.decay {
        Decay::Polynomial => 0,
        Decay::Exponential => 1,
    });
    out.f32(params.inscribed_radius);
    out.u8(params.inflate_unknown.into());
}

fn take_params(from: &mut Take<'_>) -> Option<CostParams> {
    Some(CostParams {
        inflation_radius: from.f32()?,
        cost_scaling_factor: from.f32()?,
        lethal_cost: from.u8()?,
        lethal_threshold: from.u8()? as i8,
        unknown_inflates: from.flag()?,
        decay: match from.u8()? {
            0 => Decay::Polynomial,
            1 => Decay::Exponential,
            _ => return None,
        },
        inscribed_radius: from.f32()?,
        inflate_unknown: from.flag()?,
    })
}

fn put_model(model: ScanModel, out: &mut Put<'_>) {
    match model {
        ScanModel::Set => out.u8(0),
        ScanModel::Accumulate { hit, miss, min, max } => {
            out.u8(1);
            [hit, miss, min, max].into_iter().for_each(|v| out.u8(v as u8));
        }
    }
}

fn take_model(from: &mut Take<'_>) -> Option<ScanModel> {
    let mut value = || from.u8().map(|byte| byte as i8);
    match value()? {
        0 => Some(ScanModel::Set),
        1 => Some(ScanModel::Accumulate {
            hit: value()?,
            miss: value()?,
            min: value()?,
            max: value()?,
        }),
        _ => None,
    }
}
