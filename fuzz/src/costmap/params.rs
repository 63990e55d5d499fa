use arbitrary::{Arbitrary, Result, Unstructured};
use horus_core::costmap::scratch_words;
use horus_core::prelude::{CostParams, Decay};
use horus_host::reference;

use super::Width;
use crate::number::Number;

/// The std version's parameters.
pub type StdParams = reference::CostParams;

/// Parameters of a cost map, mostly legal; lengths in cells.
#[derive(Clone, Copy, Debug)]
pub struct Params {
    /// A part of the largest radius of interest, or any number of cells.
    radius: std::result::Result<u8, Number>,
    factor: f32,
    lethal_cost: u8,
    lethal_threshold: i8,
    unknown_inflates: bool,
    is_exponential: bool,
    inscribed: Number,
    inflate_unknown: bool,
}

impl<'a> Arbitrary<'a> for Params {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let rare = |u: &mut Unstructured<'a>| u.arbitrary::<u8>().map(|b| b >= 240);
        Ok(Self {
            radius: if rare(u)? {
                Err(u.arbitrary()?)
            } else {
                Ok(u.arbitrary()?)
            },
            factor: if rare(u)? {
                u.arbitrary::<Number>()?.of(1.0)
            } else {
                *u.choose(&[10.0, 0.0, 1.0, 3.0, 0.5, 2.0, 0.1, 30.0])?
            },
            lethal_cost: if rare(u)? {
                u.arbitrary()?
            } else {
                *u.choose(&[253, 254, 2, 3, 100])?
            },
            lethal_threshold: if rare(u)? {
                u.arbitrary()?
            } else {
                *u.choose(&[50, 65, 100, 1, 30])?
            },
            unknown_inflates: u.arbitrary()?,
            is_exponential: u.arbitrary()?,
            inscribed: if rare(u)? {
                u.arbitrary()?
            } else {
                Number::Sixteenths(u.arbitrary::<u8>()?.into())
            },
            inflate_unknown: u.arbitrary()?,
        })
    }
}

impl Params {
    /// The parameters for both sides.
    pub fn both<F: Width>(&self, resolution: f32) -> (CostParams, StdParams) {
        let inflation_radius = match self.radius {
            // Around the most that the field holds.
            Ok(part @ 248..) => (F::MAX_RADIUS as f32 + f32::from(part - 248) / 6.0) * resolution,
            Ok(part) => f32::from(part) / 247.0 * F::RADIUS_SCALE * resolution,
            Err(cells) => cells.of(resolution),
        };
        let inscribed_radius = self.inscribed.of(resolution);
        let Self {
            factor: cost_scaling_factor,
            lethal_cost,
            lethal_threshold,
            ..
        } = *self;
        let Self {
            unknown_inflates,
            inflate_unknown,
            ..
        } = *self;
        let (decay, std_decay) = if self.is_exponential {
            (Decay::Exponential, reference::Decay::Exponential)
        } else {
            (Decay::Polynomial, reference::Decay::Polynomial)
        };
        (
            CostParams {
                inflation_radius,
                cost_scaling_factor,
                lethal_cost,
                lethal_threshold,
                unknown_inflates,
                decay,
                inscribed_radius,
                inflate_unknown,
            },
            StdParams {
                inflation_radius,
                cost_scaling_factor,
                lethal_cost,
                lethal_threshold,
                unknown_inflates,
                decay: std_decay,
                inscribed_radius,
                inflate_unknown,
            },
        )
    }
}

/// The effective radius by brute force, capped at one more than `F` holds; `None` where the std
/// version refuses the parameters.
pub(super) fn effective_radius<F: Width>(params: &StdParams, resolution: f32) -> Option<u32> {
    params.validate().ok()?;
    let mut row = vec![0u8; F::MAX_RADIUS as usize + 2];
    row[0] = params.lethal_cost;
    let costs = reference::inflate(&row, row.len(), resolution, params);
    Some(
        costs
            .iter()
            .skip(1)
            .rposition(|cost| *cost > 0)
            .map_or(0, |i| i as u32 + 1),
    )
}

/// Whether core must take these parameters.
pub(super) fn is_acceptable<F: Width>(params: &StdParams, resolution: f32, scratch: usize) -> bool {
    effective_radius::<F>(params, resolution)
        .is_some_and(|radius| radius <= F::MAX_RADIUS && scratch_words(radius) <= scratch)
}
