//! Both kernels against a brute-force field, incremental updates against full recomputes, and base costs against nav2.
extern crate std;

use std::boxed::Box;
use std::path::Path;
use std::vec;
use std::vec::Vec;

use super::budget::Budget;
use super::kernel::{Disc, Kernel, Need, bits, column, lanes, low_bits, quads};
use super::layer::Layer;
use super::*;
use crate::error::Error;
use crate::geometry::{CellRect, Pose2D};
use crate::grid::OccupancyGrid;
use crate::storage::{Bitmap, bitmap_words, words_per_row};

/// A small generator; the same numbers on every machine.
struct Rng(u32);

impl Rng {
    fn next(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    fn below(&mut self, n: u32) -> u32 {
        self.next() % n
    }
}

/// Squared distance to the nearest source within reach.
fn brute_force<F: FieldCell>(sources: &[(i32, i32)], reach: u32, x: i32, y: i32) -> F {
    let squared = |s: &(i32, i32)| ((s.0 - x).pow(2) + (s.1 - y).pow(2)) as u32;
    let nearest = sources.iter().map(squared).filter(|s| *s <= reach).min();
    nearest.map_or(F::NONE, F::new)
}

fn check_kernel<F: FieldCell, K: Kernel<F>>(mut kernel: K, disc: Disc, seed: u32) {
    let mut rng = Rng(seed);
    let (w, h) = (1 + rng.below(70), 1 + rng.below(60));
    let mut words = vec![0u32; bitmap_words(w, h)];
    let mut sources = Vec::new();
    for _ in 0..rng.below(w * h / 8 + 2) {
        let (x, y) = (rng.below(w), rng.below(h));
        words[y as usize * words_per_row(w) + x as usize / 32] |= 1 << (x % 32);
        sources.push((x as i32, y as i32));
    }
    let bitmap = Bitmap::new(&words, w, h);
    for _ in 0..3 {
        let x0 = rng.below(w);
        let lanes = (w - x0).min(K::LANES);
        kernel.start(x0 as i32);
        let mut gy = 0;
        while gy < h {
            let mask = if rng.below(3) == 0 { u32::MAX } else { rng.next() } & low_bits(lanes);
            let bit = |lane: u32| mask >> lane & 1 == 1;
            let mut row: Vec<F> = (0..lanes)
                .map(|l| if bit(l) { F::STALE } else { F::new(3) })
                .collect();
            let written = kernel.row(bitmap, gy as i32, (&Need::Stale, 0), &mut row);
            assert_eq!(written & mask, mask);
            for (lane, field) in (0..).zip(&row) {
                let expected = if bit(lane) {
                    brute_force(&sources, disc.reach, (x0 + lane) as i32, gy as i32)
                } else {
                    F::new(3)
                };
                assert_eq!(
                    *field,
                    expected,
                    "seed {seed}: cell ({},{gy}) of {w}x{h}, {disc:?}",
                    x0 + lane
                );
            }
            gy += 1 + rng.below(3) * rng.below(20);
        }
    }
}

#[test]
fn kernels_equal_brute_force() {
    for seed in 1..400 {
        let mut rng = Rng(seed);
        let near = Disc::new(rng.below(256));
        let middle = Disc::new(rng.below(1024));
        let far = Disc::new(rng.below(65534));
        let mut ring = Box::new([7; bits::NEAR_WORDS]);
        check_kernel::<u8, _>(bits::Near::new(&near, &mut ring), near, seed);
        check_kernel::<u16, _>(bits::Near::new(&near, &mut ring), near, seed);
        check_kernel::<u8, _>(quads::Quads::new(&near, &mut ring[..]).unwrap(), near, seed);
        check_kernel::<u16, _>(quads::Quads::new(&near, &mut ring[..]).unwrap(), near, seed);
        check_kernel::<u8, _>(lanes::Lanes::<u8, 32, 32>::new(&near), near, seed);
        let mut ring = Box::new([7; bits::MIDDLE_WORDS]);
        check_kernel::<u16, _>(bits::Middle::new(&middle, &mut ring), middle, seed);
        check_kernel::<u16, _>(lanes::Lanes::<u16, 32, 64>::new(&middle), middle, seed);
        if seed % 20 == 0 {
            check_kernel::<u16, _>(lanes::Lanes::<u16, 32, 512>::new(&far), far, seed);
            let mut ring = Box::new([7; column::FAR_WORDS]);
            check_kernel::<u16, _>(column::Column::new(&far, &mut ring), far, seed);
        }
    }
}

/// Owned buffers of a cost map.
struct Owned<F: FieldCell> {
    cells: Vec<i8>,
    bits: Vec<u32>,
    field: Vec<F>,
    scratch: Vec<u32>,
    costs: Option<Vec<u8>>,
    tables: CostTables<F>,
}

impl<F: FieldCell> Owned<F> {
    fn new(w: u32, h: u32, kept: bool) -> Self {
        let n = (w * h) as usize;
        Self {
            cells: vec![0; n],
            bits: vec![0; bit_words(w, h)],
            field: vec![F::ZERO; n],
            scratch: vec![0; scratch_words(F::MAX_RADIUS.min(31))],
            costs: kept.then(|| vec![0; n]),
            tables: CostTables::EMPTY,
        }
    }

    fn split(&mut self) -> (&mut [i8], CostBuffers<'_, F>) {
        let buffers = CostBuffers {
            bits: &mut self.bits,
            field: &mut self.field,
            scratch: &mut self.scratch,
            costs: self.costs.as_deref_mut(),
            tables: &mut self.tables,
        };
        (&mut self.cells, buffers)
    }

    fn map(&mut self, w: u32, h: u32, origin: Pose2D, params: CostParams) -> CostMap<'_, F> {
        let (cells, buffers) = self.split();
        let grid = OccupancyGrid::new_in(cells, w, h, 0.05, origin).unwrap();
        CostMap::new_in(grid, buffers, params).unwrap()
    }
}

fn costs<F: FieldCell>(map: &CostMap<'_, F>) -> Vec<u8> {
    (0..map.info().height())
        .flat_map(|gy| map.row(gy).collect::<Vec<_>>())
        .collect()
}

fn random_params(rng: &mut Rng, max_cells: u32) -> CostParams {
    let decay = if rng.below(2) == 0 {
        Decay::Polynomial
    } else {
        Decay::Exponential
    };
    CostParams {
        inflation_radius: 0.05 * rng.below(max_cells + 1) as f32 + 0.01 * rng.below(4) as f32,
        cost_scaling_factor: [0.0, 0.5, 1.0, 3.0, 10.0][rng.below(5) as usize],
        lethal_cost: 2 + rng.below(253) as u8,
        lethal_threshold: 1 + rng.below(100) as i8,
        unknown_inflates: rng.below(2) == 0,
        decay,
        inscribed_radius: 0.05 * rng.below(4) as f32,
        inflate_unknown: rng.below(2) == 0,
    }
}

/// Random changes, shifts and updates; after each update every cost equals a full recompute.
fn check_incremental<F: FieldCell>(seed: u32, max_cells: u32, kept: bool) {
    let mut rng = Rng(seed);
    let (w, h) = (1 + rng.below(60), 1 + rng.below(50));
    let params = loop {
        let params = random_params(&mut rng, max_cells);
        if CostTables::<F>::reach(&params, 0.05).is_ok() {
            break params;
        }
    };
    let (mut owned, mut fresh) = (Owned::<F>::new(w, h, kept), Owned::<F>::new(w, h, false));
    let mut map = owned.map(w, h, Pose2D::default(), params);
    let mut full = fresh.map(w, h, Pose2D::default(), params);
    let centre = |map: &CostMap<'_, F>| {
        let o = map.info().origin();
        (o.x + w as f32 * 0.025, o.y + h as f32 * 0.025)
    };
    let mut before = costs(&map);
    let mut shifted = false;
    for step in 0..60 {
        for _ in 0..rng.below(8) {
            let value = [-1, 0, 0, 100, 100, 30, 64, 99][rng.below(8) as usize];
            map.set_occupancy(rng.below(w), rng.below(h), value);
        }
        if rng.below(6) == 0 {
            let value = [-1, 0, 100][rng.below(3) as usize];
            let (x, y, n) = (rng.below(w), rng.below(h), 1 + rng.below(20));
            for gy in y..(y + n).min(h) {
                for gx in x..(x + n).min(w) {
                    map.set_occupancy(gx, gy, value);
                }
            }
        }
        if rng.below(4) == 0 {
            let (x, y) = centre(&map);
            let by =
                |rng: &mut Rng| (rng.below(7) as f32 - 3.0) * 0.05 * (1 + rng.below(9) * rng.below(2)) as f32;
            let shift = map
                .recenter(Pose2D::new(x + by(&mut rng), y + by(&mut rng), 0.0))
                .unwrap();
            shifted |= shift != [0, 0];
        }
        let changed = if rng.below(2) == 0 {
            let budget = map.min_budget() + rng.below(3000);
            let calls = map.calls_left();
            let mut used = 0;
            let mut all: Option<CellRect> = None;
            let stop = rng.below(3) == 0;
            let finished = loop {
                let update = map.update_costs_within(budget).unwrap();
                used += 1;
                all = match (all, update.changed) {
                    (Some(a), Some(b)) => Some(a.union(&b)),
                    (a, b) => a.or(b),
                };
                if update.pending == 0 {
                    break true;
                }
                if stop && used == 2 {
                    break false;
                }
            };
            assert!(used <= calls.max(1), "{used} calls, {calls} promised");
            if !finished {
                shifted = true; // the rectangle spans several updates now
                continue;
            }
            all
        } else {
            map.update_costs()
        };
        full.load(map.occupancy_grid().data()).unwrap();
        let (now, expected) = (costs(&map), costs(&full));
        let context = || std::format!("seed {seed} step {step} {w}x{h} {params:?}");
        assert_eq!(now, expected, "{}", context());
        if let Some(kept) = map.costs() {
            assert_eq!(kept, &expected[..], "kept: {}", context());
        }
        if !shifted {
            let mut smallest = crate::geometry::Bounds::EMPTY;
            for (i, (a, b)) in before.iter().zip(&now).enumerate() {
                if a != b {
                    smallest.add(i as u32 % w, i as u32 / w);
                }
            }
            if kept {
                assert_eq!(changed, smallest.rect(), "{}", context());
            } else if let Some(smallest) = smallest.rect() {
                let changed = changed.expect("something changed");
                assert_eq!(changed.union(&smallest), changed, "{}", context());
            }
        }
        shifted = false;
        before = now;
    }
}

#[test]
fn incremental_equals_full_one_byte() {
    for seed in 1..300 {
        check_incremental::<u8>(seed, 15, seed % 2 == 0);
    }
}

#[test]
fn incremental_equals_full_two_bytes() {
    for seed in 1..100 {
        check_incremental::<u16>(seed, if seed % 10 == 0 { 70 } else { 31 }, seed % 2 == 0);
    }
}

/// A map of nav2 from base costs, which is more than an occupancy can say.
struct BaseCostCase<'j> {
    json: &'j str,
}

impl BaseCostCase<'_> {
    /// The text of a field of the case, a flat JSON object.
    fn text(&self, key: &str) -> &str {
        let quoted = std::format!("\"{key}\":");
        let (_, rest) = self.json.split_once(&quoted).expect("the field");
        let rest = rest.trim_start().trim_start_matches('"');
        rest.split(['"', ',', '}']).next().unwrap_or(rest)
    }

    fn number<T: core::str::FromStr>(&self, key: &str) -> T {
        self.text(key).parse().ok().expect("a number")
    }

    fn bytes(&self, key: &str) -> Vec<u8> {
        let digits = self.text(key);
        let byte = |at| u8::from_str_radix(&digits[at..at + 2], 16).expect("hex digits");
        (0..digits.len()).step_by(2).map(byte).collect()
    }

    /// Compares a full computation and an update from an empty map with nav2; returns the effective radius.
    fn check<F: FieldCell>(&self) -> Result<u32, Error> {
        let (w, h) = (self.number("width"), self.number("height"));
        let params = CostParams {
            inflation_radius: self.number("inflation_radius"),
            inscribed_radius: self.number("inscribed_radius"),
            cost_scaling_factor: self.number("cost_scaling_factor"),
            inflate_unknown: self.number("inflate_unknown"),
            unknown_inflates: self.number("inflate_around_unknown"),
            ..CostParams::nav2()
        };
        let (input, formula) = (self.bytes("input"), self.bytes("formula"));
        let mut owned = Owned::<F>::new(w, h, true);
        let (_, buffers) = owned.split();
        let mut layer = Layer::new(w, h, self.number("resolution"), buffers, params)?;
        layer.tables.read_base_costs(params.unknown_inflates);
        layer.compute(&input);
        assert_eq!(layer.costs.as_deref(), Some(&formula[..]), "{}", self.text("id"));
        layer.compute(&vec![0u8; input.len()]);
        for (i, _) in (0..).zip(&input).filter(|(_, byte)| **byte != 0) {
            layer.mark(i % w, i / w);
        }
        layer.update(&input, &mut Budget::unlimited());
        assert_eq!(layer.costs.as_deref(), Some(&formula[..]), "{}", self.text("id"));
        Ok(layer.tables.disc.radius)
    }
}

#[test]
fn base_costs_equal_nav2() {
    for folder in ["../tests/golden", "../../shared/golden"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
        let Ok(text) = std::fs::read_to_string(path.join("nav2/inflation.json")) else {
            std::println!("skipped: {} is not there", path.display());
            continue;
        };
        let objects = text.split('{').filter(|json| json.contains("_mixed_"));
        let cases: Vec<_> = objects.map(|json| BaseCostCase { json }).collect();
        assert!(!cases.is_empty());
        for case in cases {
            let radius = case.check::<u16>().unwrap();
            match case.check::<u8>() {
                Err(Error::RadiusTooLarge { .. }) => assert!(radius > 15),
                one_byte => assert_eq!(one_byte, Ok(radius)),
            }
        }
    }
}
