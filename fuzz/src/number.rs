//! Floats that are mostly sensible and sometimes anything.

use arbitrary::{Arbitrary, Result, Unstructured};

/// A number of units that its user chooses: cells, tenths of a radian, metres.
#[derive(Clone, Copy, Debug)]
pub enum Number {
    /// Sixteenths of a unit.
    Sixteenths(i16),
    /// That many units: zeros, infinities, NaN, limits.
    Units(f32),
    /// This value, whatever the unit.
    Exactly(f32),
}

const SPECIAL: [f32; 24] = [
    0.0,
    -0.0,
    f32::NAN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::MAX,
    f32::MIN,
    f32::MIN_POSITIVE,
    1e-40,
    1e-6,
    1000.0,
    -1000.5,
    65_536.0,
    16_777_216.0,
    16_777_217.0,
    -33_554_432.0,
    33_554_436.0,
    268_435_456.0,
    -1_073_741_824.0,
    1_073_741_824.0,
    1_073_741_760.0,
    2_147_483_648.0,
    1e19,
    -1e19,
];

impl<'a> Arbitrary<'a> for Number {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        Ok(match u.arbitrary::<u8>()? {
            0..=223 => Self::Sixteenths(u.arbitrary::<i16>()? % 1024),
            224..=243 => Self::Units(*u.choose(&SPECIAL)?),
            _ => Self::Exactly(f32::from_bits(u.arbitrary()?)),
        })
    }
}

impl Number {
    /// The value in the unit's own unit.
    pub fn of(self, unit: f32) -> f32 {
        match self {
            Self::Sixteenths(n) => f32::from(n) / 16.0 * unit,
            Self::Units(n) => n * unit,
            Self::Exactly(value) => value,
        }
    }
}
