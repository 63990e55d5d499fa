//! From a shade to an occupancy value and back.

use super::{MapMode, MapYaml};

const UNKNOWN: i8 = -1;

/// The shade of an unknown cell in a trinary image, and the shades of a free and an occupied one.
const UNKNOWN_SHADE: u8 = 205;
const FREE_SHADE: u8 = 254;

/// The values of the 256 shades, and of a transparent pixel.
pub(super) struct Shades {
    values: [i8; 256],
    keep_transparent: bool,
}

impl Shades {
    pub fn new(yaml: &MapYaml) -> Self {
        let mut values = [UNKNOWN; 256];
        for (shade, value) in (0u8..=255).zip(&mut values) {
            *value = occupancy(shade, yaml);
        }
        Self {
            values,
            keep_transparent: yaml.mode == MapMode::Raw,
        }
    }

    /// The value of a pixel.
    pub fn value(&self, shade: u8, is_opaque: bool) -> i8 {
        match is_opaque || self.keep_transparent {
            true => self.values[usize::from(shade)],
            false => UNKNOWN,
        }
    }
}

/// The value of an opaque pixel, in f32 as nav2 computes it.
fn occupancy(shade: u8, yaml: &MapYaml) -> i8 {
    if yaml.mode == MapMode::Raw {
        return match i8::try_from(shade) {
            Ok(value @ 0..=100) => value,
            _ => UNKNOWN,
        };
    }
    let light = f32::from(shade) / 255.0;
    let occupied = if yaml.negate { light } else { 1.0 - light };
    let (free_thresh, occupied_thresh) = (yaml.free_thresh, yaml.occupied_thresh);
    if occupied <= free_thresh {
        0
    } else if occupied >= occupied_thresh {
        100
    } else if yaml.mode == MapMode::Scale {
        let share = (occupied - free_thresh) / (occupied_thresh - free_thresh);
        (share * 100.0).round() as i8
    } else {
        UNKNOWN
    }
}

/// The pixel that a value is saved as: its shade, and whether it is opaque.
pub(super) fn pixel(value: i8, yaml: &MapYaml) -> (u8, bool) {
    let known = u8::try_from(value).ok().filter(|value| *value <= 100);
    let inverted = |shade: u8| if yaml.negate { 255 - shade } else { shade };
    match (yaml.mode, known) {
        (MapMode::Raw, Some(value)) => (value, true),
        (MapMode::Raw, None) => (255, true),
        (MapMode::Scale, Some(value)) => {
            let dark = (255 * u32::from(value) + 50) / 100;
            (inverted(255 - dark as u8), true)
        }
        (MapMode::Scale, None) => (128, false),
        (MapMode::Trinary, None) => (inverted(UNKNOWN_SHADE), true),
        (MapMode::Trinary, Some(value)) => {
            let share = f32::from(value) / 100.0;
            let shade = if share <= yaml.free_thresh {
                FREE_SHADE
            } else if share >= yaml.occupied_thresh {
                0
            } else {
                UNKNOWN_SHADE
            };
            (inverted(shade), true)
        }
    }
}
