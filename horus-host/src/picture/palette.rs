//! Colours of cell values.

use std::cmp::Ordering;

use super::Rgb;

/// Unknown cells: the grey-green of RViz.
pub const UNKNOWN: Rgb<u8> = Rgb([0x70, 0x89, 0x86]);
/// Lethal cost: magenta.
pub const LETHAL: Rgb<u8> = Rgb([255, 0, 255]);
/// Inscribed cost: cyan.
pub const INSCRIBED: Rgb<u8> = Rgb([0, 255, 255]);
/// Cells that are equal in both grids.
pub const EQUAL: Rgb<u8> = Rgb([0xc8, 0xc8, 0xc8]);

/// An occupancy value as RViz's `map` scheme shows it: 0 white, 100 black, greys between,
/// -1 [`UNKNOWN`]. Values no grid should hold stand out: green above 100, red to yellow below -1.
pub fn occupancy(value: i8) -> Rgb<u8> {
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
pub fn cost(cost: u8, lethal_cost: u8) -> Rgb<u8> {
    match cost {
        0 => Rgb([255; 3]),
        u8::MAX => UNKNOWN,
        _ if cost == lethal_cost => LETHAL,
        1..=252 => {
            let red = (255 * (u32::from(cost) - 1) / 251) as u8;
            Rgb([red, 0, 255 - red])
        }
        _ => INSCRIBED,
    }
}

/// A difference of two grids: [`EQUAL`] grey, red where the first is greater, blue where it is
/// less.
pub fn difference(first_to_second: Ordering) -> Rgb<u8> {
    match first_to_second {
        Ordering::Equal => EQUAL,
        Ordering::Greater => Rgb([0xd0, 0x10, 0x10]),
        Ordering::Less => Rgb([0x10, 0x30, 0xd0]),
    }
}

/// Masses (free, occupied) as Isaac's viewer shows them: free white, occupied black, uncertain green, mixed by their
/// masses.
pub fn evidence([free, occupied]: [f64; 2]) -> Rgb<u8> {
    let byte = |share: f64| (share.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
    Rgb([byte(free), byte(1.0 - occupied), byte(free)])
}

/// A cell of a binary map: occupied black, free white.
pub fn binary(occupied: bool) -> Rgb<u8> {
    Rgb([if occupied { 0 } else { 255 }; 3])
}

/// A distance in metres from black, at and inside obstacles, to white, at `cap` metres and beyond.
pub fn distance(metres: f32, cap: f32) -> Rgb<u8> {
    Rgb([((metres / cap).clamp(0.0, 1.0) * 255.0) as u8; 3])
}
