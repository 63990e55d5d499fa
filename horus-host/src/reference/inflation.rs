//! Cost from occupancy, straight from the formulas: every cell within reach of every source, one at a time.

use std::ops::Range;

use super::frame::BOUNDARY;
use super::{CostParams, Decay};

/// Cost of a cell nothing is known about.
pub(super) const NO_INFORMATION: u8 = 255;

/// A cell's cost before inflation.
pub(super) fn base_cost(occupancy: i8, params: &CostParams) -> u8 {
    if occupancy < 0 {
        NO_INFORMATION
    } else if occupancy >= params.lethal_threshold {
        params.lethal_cost
    } else {
        (occupancy as u8 * 2).min(params.lethal_cost.saturating_sub(1))
    }
}

/// Final costs of a row-major map of base costs with `width` columns: `lethal_cost` is an obstacle, 255 unknown.
///
/// Public so that maps no occupancy grid can express are testable; not part of the documented interface.
pub fn inflate(base: &[u8], width: usize, resolution: f32, params: &CostParams) -> Vec<u8> {
    let height = base.len().checked_div(width).unwrap_or(0);
    let reach = reach(resolution, params);
    let mut inflated = vec![0; base.len()];
    for sy in 0..height {
        for sx in 0..width {
            let source = base[sy * width + sx];
            let is_lethal = source == params.lethal_cost;
            if !(is_lethal || source == NO_INFORMATION && params.unknown_inflates) {
                continue;
            }
            for y in window(sy, reach, height) {
                for x in window(sx, reach, width) {
                    let i = y * width + x;
                    if takes_inflation(base[i], params) {
                        let (dx, dy) = (x.abs_diff(sx) as u64, y.abs_diff(sy) as u64);
                        let cost = inflated_cost(dx * dx + dy * dy, resolution, params);
                        inflated[i] = cost.max(inflated[i]);
                    }
                }
            }
        }
    }
    let cells = base.iter().zip(&inflated);
    cells.map(|(&b, &c)| merge(b, c, params)).collect()
}

/// The cells of one axis within `reach` of `at`.
fn window(at: usize, reach: usize, size: usize) -> Range<usize> {
    at.saturating_sub(reach)..at.saturating_add(reach).saturating_add(1).min(size)
}

/// Cells, per axis, beyond which no source contributes anything.
///
/// `inflated_cost` decides on every cell; no rounding of the quotient can lose one, because a cell within the radius
/// has it well above the next smaller whole number.
fn reach(resolution: f32, params: &CostParams) -> usize {
    // Saturates, and NaN becomes 0.
    libm::ceilf(params.inflation_radius / resolution) as u32 as usize
}

/// What one source adds to a cell at a squared distance of `d2` cells.
pub(super) fn inflated_cost(d2: u64, resolution: f32, params: &CostParams) -> u8 {
    let d = resolution * libm::sqrtf(d2 as f32);
    let (radius, k) = (params.inflation_radius, params.cost_scaling_factor);
    match params.decay {
        Decay::Polynomial if d <= radius && radius > 0.0 => {
            let highest = f32::from(params.lethal_cost.saturating_sub(1));
            (highest * libm::powf(1.0 - d / radius, k)) as u8
        }
        Decay::Polynomial => 0,
        Decay::Exponential => {
            let cells = u64::from(libm::ceilf(radius / resolution - BOUNDARY) as u32);
            if d2 > cells * cells {
                0
            } else if d2 == 0 {
                254
            } else if d <= params.inscribed_radius {
                253
            } else {
                (252.0 * libm::expf(-k * (d - params.inscribed_radius))) as u8
            }
        }
    }
}

/// Whether inflation can change a cell: the polynomial decay leaves lethal and unknown cells alone.
fn takes_inflation(base: u8, params: &CostParams) -> bool {
    params.decay == Decay::Exponential || (base != params.lethal_cost && base != NO_INFORMATION)
}

/// A cell's final cost from its base cost and the largest contribution of any source.
fn merge(base: u8, inflated: u8, params: &CostParams) -> u8 {
    if base != NO_INFORMATION {
        return base.max(inflated);
    }
    let least = if params.inflate_unknown { 1 } else { 253 };
    if inflated >= least {
        inflated
    } else {
        NO_INFORMATION
    }
}
