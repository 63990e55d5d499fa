use super::horus_cost_map;
use super::map::{cost_map, cost_map_mut};
use crate::c_abi::call::{Call, Plain};
use crate::c_abi::status::horus_status;
use crate::costmap::{CostParams, Decay};

/// How inflated cost falls with the distance d (metres) to the nearest source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum horus_decay {
    /// HORUS: trunc((lethal_cost - 1) * (1 - d / R)^k) for d <= R.
    Polynomial = 0,
    /// nav2: 254 at d = 0, 253 up to the inscribed radius, then
    /// trunc(252 * exp(-k * (d - inscribed_radius))) within R rounded up to whole cells.
    Exponential = 1,
}

/// Parameters of a cost map. Start from one of the presets.
///
/// The base cost of a cell with occupancy v: unknown 255; v >= lethal_threshold: lethal_cost; else
/// min(2 * v, lethal_cost - 1). Lethal cells are the sources of inflation.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct horus_cost_params {
    /// R, metres, finite and >= 0.
    pub inflation_radius: f32,
    /// k, finite and >= 0: an exponent (polynomial) or 1/m (exponential).
    pub cost_scaling_factor: f32,
    /// Metres, finite and >= 0; exponential only.
    pub inscribed_radius: f32,
    /// A horus_decay.
    pub decay: i32,
    /// Cost of lethal cells, 2 .. 254.
    pub lethal_cost: u8,
    /// Lowest occupancy that is lethal, 1 .. 100.
    pub lethal_threshold: i8,
    /// Not 0: unknown cells are sources, too.
    pub unknown_inflates: u8,
    /// Not 0: unknown cells take any inflated cost above zero, not only 253 and 254; exponential only.
    pub inflate_unknown: u8,
}

// SAFETY: numbers.
unsafe impl Plain for horus_cost_params {}

impl horus_cost_params {
    pub(super) fn params(self) -> Result<CostParams, horus_status> {
        let decay = if self.decay == horus_decay::Polynomial as i32 {
            Decay::Polynomial
        } else if self.decay == horus_decay::Exponential as i32 {
            Decay::Exponential
        } else {
            return Err(horus_status::InvalidChoice);
        };
        Ok(CostParams {
            inflation_radius: self.inflation_radius,
            cost_scaling_factor: self.cost_scaling_factor,
            lethal_cost: self.lethal_cost,
            lethal_threshold: self.lethal_threshold,
            unknown_inflates: self.unknown_inflates != 0,
            decay,
            inscribed_radius: self.inscribed_radius,
            inflate_unknown: self.inflate_unknown != 0,
        })
    }
}

impl From<CostParams> for horus_cost_params {
    fn from(params: CostParams) -> Self {
        let decay = match params.decay {
            Decay::Polynomial => horus_decay::Polynomial,
            Decay::Exponential => horus_decay::Exponential,
        };
        Self {
            inflation_radius: params.inflation_radius,
            cost_scaling_factor: params.cost_scaling_factor,
            inscribed_radius: params.inscribed_radius,
            decay: decay as i32,
            lethal_cost: params.lethal_cost,
            lethal_threshold: params.lethal_threshold,
            unknown_inflates: params.unknown_inflates.into(),
            inflate_unknown: params.inflate_unknown.into(),
        }
    }
}

/// The default parameters: R 0.55 m, k 10, polynomial, lethal from occupancy 50 on.
#[unsafe(no_mangle)]
pub extern "C" fn horus_cost_params_default() -> horus_cost_params {
    CostParams::default().into()
}

/// HORUS 0.4.1: the defaults, but lethal from occupancy 65 on, and unknown cells inflate.
#[unsafe(no_mangle)]
pub extern "C" fn horus_cost_params_horus() -> horus_cost_params {
    CostParams::horus().into()
}

/// nav2's inflation layer: exponential, lethal cost 254 from occupancy 100 on.
#[unsafe(no_mangle)]
pub extern "C" fn horus_cost_params_nav2() -> horus_cost_params {
    CostParams::nav2().into()
}

/// The parameters in force.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_params(
    map: *const horus_cost_map,
    params: *mut horus_cost_params,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map(claims, map)?;
        let in_force = *map.params();
        claims.output(params)?.write(in_force.into());
        Ok(())
    })
}

/// Takes new parameters and recomputes everything before it returns.
///
/// Fails with HORUS_STATUS_INVALID_CHOICE, one of HORUS_STATUS_INVALID_... for a parameter,
/// HORUS_STATUS_RADIUS_TOO_LARGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_set_params(
    map: *mut horus_cost_map,
    params: *const horus_cost_params,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let params = claims.input(params)?.params()?;
        let map = cost_map_mut(claims, map)?;
        map.set_params(params)?;
        Ok(())
    })
}

/// Largest offset, in cells, at which a source still costs something.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_effective_radius(
    map: *const horus_cost_map,
    cells: *mut u32,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map(claims, map)?;
        let radius = map.effective_radius();
        claims.output(cells)?.write(radius);
        Ok(())
    })
}
