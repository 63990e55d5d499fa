//! Colours of cell values.

use std::cmp::Ordering;

use super::Rgb;

/// Unknown cells: the grey-green of RViz.
pub const UNKNOWN: Rgb = Rgb([0x70, 0x89, 0x86]);
/// Cost 0: white; RViz shows what lies below.
pub const FREE: Rgb = Rgb([255; 3]);
/// Lethal cost: magenta.
pub const LETHAL: Rgb = Rgb([255, 0, 255]);
/// Inscribed cost: cyan.
pub const INSCRIBED: Rgb = Rgb([0, 255, 255]);
/// Cells that are equal in both grids.
pub const EQUAL: Rgb = Rgb([0xc8, 0xc8, 0xc8]);

/// An occupancy value as RViz's `map` scheme shows it: 0 white, 100 black, greys between,
/// -1 [`UNKNOWN`]. Values no grid should hold stand out: green above 100, red to yellow below -1.
pub fn occupancy(value: i8) -> Rgb {
    match value {
        0..=100 => {
            let grey = 255 - (255 * i32::from(value) / 100) as u8;
            Rgb([grey; 3])
        }
        -1 => UNKNOWN,
        101..=i8::MAX => Rgb([0, 255, 0]),
        i8::MIN..=-2 => Rgb([255, (255 * (i32::from(value) + 128) / 126) as u8, 0]),
    }
}

/// A cost 0..=255 as RViz's `costmap` scheme shows it: 0 white (RViz: transparent), 1 to 252 from
/// blue to red, 255 [`UNKNOWN`]; `lethal_cost` [`LETHAL`], other costs of 253 and 254
/// [`INSCRIBED`].
pub fn cost(cost: u8, lethal_cost: u8) -> Rgb {
    match cost {
        0 => FREE,
        u8::MAX => UNKNOWN,
        _ if cost == lethal_cost => LETHAL,
        1..=252 => {
            let red = (255 * (u32::from(cost) - 1) / 251) as u8;
            Rgb([red, 0, 255 - red])
        }
        _ => INSCRIBED,
    }
}

/// A cost as an occupancy grid carries it, as RViz's `costmap` scheme shows it: 0 white (RViz:
/// transparent), 1 to 98 from blue to red, 99 [`INSCRIBED`], 100 [`LETHAL`], -1 [`UNKNOWN`]. Values no
/// grid should hold as in [`occupancy`].
pub fn viewable_cost(value: i8) -> Rgb {
    match value {
        0 => FREE,
        1..=98 => {
            let red = (255 * i32::from(value) / 100) as u8;
            Rgb([red, 0, 255 - red])
        }
        99 => INSCRIBED,
        100 => LETHAL,
        _ => occupancy(value),
    }
}

/// A distance in metres: 0 black to `farthest` white; NaN [`UNKNOWN`]; below 0, inside obstacles,
/// from black to blue.
pub fn distance(metres: f32, farthest: f32) -> Rgb {
    if metres.is_nan() {
        return UNKNOWN;
    }
    let level = (metres.abs() / farthest.max(f32::MIN_POSITIVE)).min(1.0);
    let level = (255.0 * level) as u8;
    if metres < 0.0 {
        Rgb([0, 0, level])
    } else {
        Rgb([level; 3])
    }
}

/// A difference of two grids: [`EQUAL`] grey, red where the first is greater, blue where it is
/// less.
pub fn difference(first_to_second: Ordering) -> Rgb {
    match first_to_second {
        Ordering::Equal => EQUAL,
        Ordering::Greater => Rgb([0xd0, 0x10, 0x10]),
        Ordering::Less => Rgb([0x10, 0x30, 0xd0]),
    }
}

/// Masses (free, occupied) as Isaac's viewer shows them: free white, occupied black, uncertain green, mixed by their
/// masses.
pub fn evidence([free, occupied]: [f64; 2]) -> Rgb {
    let byte = |share: f64| (share.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
    Rgb([byte(free), byte(1.0 - occupied), byte(free)])
}

/// A cell of a binary map: occupied black, free white.
pub fn binary(occupied: bool) -> Rgb {
    Rgb([if occupied { 0 } else { 255 }; 3])
}
