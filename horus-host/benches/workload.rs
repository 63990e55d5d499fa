//! Maps and changes for the benches: an office with walls, doors and furniture, and what a lidar
//! on a circling robot changes in it.
//!
//! With `HORUS_BENCH_DATA` naming a folder that holds `map_office_<W>.bin` (one byte per cell,
//! 1 = obstacle) and `seq_<name>_office_<W>.bin` (see [`Ticks::parse`]) those are used.

use std::path::PathBuf;
use std::{env, fs};

/// One net change: column, row, and whether an obstacle is there now.
pub type Change = (u32, u32, bool);

/// Net changes, tick by tick.
pub struct Ticks(pub Vec<Vec<Change>>);

/// A square map and its change sequences.
pub struct Workload {
    /// Cells per side.
    pub side: u32,
    /// -1..=100 per cell, row-major.
    pub cells: Vec<i8>,
    /// One obstacle in (even ticks), the same out again (odd ticks).
    pub one: Ticks,
    /// What a 360-beam scan changes.
    pub scan: Ticks,
}

impl Workload {
    /// The office of `side` x `side` cells.
    pub fn office(side: u32) -> Self {
        Self::from_files(side).unwrap_or_else(|| Self::generate(side))
    }

    fn from_files(side: u32) -> Option<Self> {
        let folder = PathBuf::from(env::var_os("HORUS_BENCH_DATA")?);
        let read = |name: String| {
            let path = folder.join(name);
            fs::read(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
        };
        let map = read(format!("map_office_{side}.bin"));
        Some(Self {
            side,
            cells: map.iter().map(|&v| if v == 1 { 100 } else { 0 }).collect(),
            one: Ticks::parse(&read(format!("seq_one_office_{side}.bin"))),
            scan: Ticks::parse(&read(format!("seq_scan_office_{side}.bin"))),
        })
    }

    fn generate(side: u32) -> Self {
        let mut random = Random(side);
        let mut map = Map {
            side,
            blocked: vec![false; (side * side) as usize],
        };
        // Rooms of 100 cells with two-cell walls, a door of 20 in each, six pieces of furniture.
        for k in (0..=side).step_by(100) {
            let at = k.saturating_sub(1);
            map.fill(at, 0, at + 2, side, true);
            map.fill(0, at, side, at + 2, true);
        }
        for k in (100..side).step_by(100) {
            for j in (0..side).step_by(100) {
                let door = j + 15 + random.below(50);
                map.fill(k - 1, door, k + 1, door + 20, false);
                let door = j + 15 + random.below(50);
                map.fill(door, k - 1, door + 20, k + 1, false);
            }
        }
        for j in (0..side).step_by(100) {
            for i in (0..side).step_by(100) {
                for _ in 0..6 {
                    let (w, h) = (3 + random.below(14), 3 + random.below(14));
                    let (x, y) = (i + 6 + random.below(80), j + 6 + random.below(80));
                    map.fill(x, y, x + w, y + h, true);
                }
            }
        }
        // The robot's track about the middle of a room stays free.
        let centre = f64::from(side / 200 * 100 + 50);
        for y in 0..side {
            for x in 0..side {
                let d = (f64::from(x) - centre).hypot(f64::from(y) - centre);
                if (18.0..=32.0).contains(&d) {
                    map.blocked[(y * side + x) as usize] = false;
                }
            }
        }
        let (one, scan) = (map.one(&mut random), map.scan(centre, &mut random));
        let cells = map.blocked.iter().map(|b| if *b { 100 } else { 0 }).collect();
        Self {
            side,
            cells,
            one,
            scan,
        }
    }
}

impl Ticks {
    /// u32 ticks; per tick four i32 of no interest here, u32 n, n times (u16 x, u16 y, u8 now, u8 0).
    fn parse(bytes: &[u8]) -> Self {
        let u32_at = |i: usize| u32::from_le_bytes(bytes[i..i + 4].try_into().unwrap());
        let u16_at = |i: usize| u32::from(u16::from_le_bytes([bytes[i], bytes[i + 1]]));
        let mut at = 4;
        let ticks = (0..u32_at(0)).map(|_| {
            at += 20;
            let changes = u32_at(at - 4) as usize;
            let start = at;
            at += 6 * changes;
            (start..at)
                .step_by(6)
                .map(|i| (u16_at(i), u16_at(i + 2), bytes[i + 4] == 1))
                .collect()
        });
        Self(ticks.collect())
    }

    /// Changes per tick.
    pub fn mean(&self) -> f64 {
        self.0.iter().map(Vec::len).sum::<usize>() as f64 / self.0.len() as f64
    }
}

struct Map {
    side: u32,
    blocked: Vec<bool>,
}

impl Map {
    fn fill(&mut self, x0: u32, y0: u32, x1: u32, y1: u32, blocked: bool) {
        for y in y0..y1.min(self.side) {
            for x in x0..x1.min(self.side) {
                self.blocked[(y * self.side + x) as usize] = blocked;
            }
        }
    }

    fn at(&self, x: u32, y: u32) -> bool {
        x >= self.side || y >= self.side || self.blocked[(y * self.side + x) as usize]
    }

    fn one(&self, random: &mut Random) -> Ticks {
        let mut ticks = Vec::new();
        while ticks.len() < 400 {
            let mut inner = || 30 + random.below(self.side - 60);
            let (x, y) = (inner(), inner());
            if !self.at(x, y) {
                ticks.extend([vec![(x, y, true)], vec![(x, y, false)]]);
            }
        }
        Ticks(ticks)
    }

    /// 360 beams of 3.6 m at 5 cm, 1 cell per tick on a circle, range noise, one person walking.
    fn scan(&self, centre: f64, random: &mut Random) -> Ticks {
        let mut seen = self.blocked.clone();
        let ticks = (0..200).map(|tick| {
            let a = f64::from(tick) / 25.0;
            let (rx, ry) = (centre + 25.0 * a.cos(), centre + 25.0 * a.sin());
            let b = 1.0 - f64::from(tick) / 30.0;
            let (px, py) = (centre + 14.0 * b.cos(), centre + 14.0 * b.sin());
            let mut now = std::collections::BTreeMap::new();
            let mut marks = Vec::new();
            for beam in 0..360 {
                let (sin, cos) = f64::from(beam).to_radians().sin_cos();
                let cell = |d: f64| ((rx + d * cos) as u32, (ry + d * sin) as u32);
                let hits = |&d: &f64| {
                    let (x, y) = cell(d);
                    self.at(x, y) || (f64::from(x) - px).hypot(f64::from(y) - py) <= 4.0
                };
                let hit = (0..144).map(|i| f64::from(i) * 0.5).find(hits);
                let end = hit.map_or(72.0, |d| (d + 0.8 * random.spread()).max(0.0));
                let steps = (end * 2.0) as u32;
                now.extend((0..steps).map(|i| (cell(f64::from(i) * 0.5), false)));
                if hit.is_some() {
                    marks.push(cell(end));
                }
            }
            now.extend(marks.into_iter().map(|cell| (cell, true)));
            let mut changes: Vec<Change> = Vec::new();
            for ((x, y), blocked) in now {
                if x < self.side && y < self.side {
                    let known = &mut seen[(y * self.side + x) as usize];
                    if std::mem::replace(known, blocked) != blocked {
                        changes.push((x, y, blocked));
                    }
                }
            }
            changes
        });
        Ticks(ticks.collect())
    }
}

/// The same numbers in every run.
struct Random(u32);

impl Random {
    fn below(&mut self, n: u32) -> u32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.0 >> 8) % n
    }

    /// Roughly normal, deviation 0.5.
    fn spread(&mut self) -> f64 {
        (0..3).map(|_| f64::from(self.below(1000)) / 1000.0 - 0.5).sum()
    }
}
