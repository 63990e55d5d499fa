//! Cost maps: full recompute, one cell, one scan; 200x200 and 1000x1000 cells of 5 cm, costs
//! reaching 11 cells (Exponential, k 10, inscribed radius 0.1 m).
//!
//! `cargo bench -p horus-host`; with `--features peers` the crate `costmap` runs on the same input
//! in the same run.

mod workload;

use std::hint::black_box;
use std::time::{Duration, Instant};

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use horus_core::costmap::{CostTables, bit_words, scratch_words};
use horus_core::prelude::*;
use workload::{Change, Ticks, Workload};

fn params() -> CostParams {
    CostParams {
        decay: Decay::Exponential,
        ..CostParams::default()
    }
}

fn with_map(load: &Workload, kept: bool, test: impl FnOnce(&mut CostMap<'_>)) {
    let side = load.side;
    let n = load.cells.len();
    let (mut cells, mut field) = (vec![0; n], vec![0; n]);
    let (mut bits, mut scratch) = (vec![0; bit_words(side, side)], vec![0; scratch_words(15)]);
    let mut costs = kept.then(|| vec![0; n]);
    let mut tables = Box::new(CostTables::EMPTY);
    let grid = OccupancyGrid::new_in(&mut cells[..], side, side, 0.05, Pose2D::default());
    let buffers = CostBuffers {
        bits: &mut bits,
        field: &mut field,
        scratch: &mut scratch,
        costs: costs.as_deref_mut(),
        tables: &mut tables,
    };
    let mut map = CostMap::new_in(grid.unwrap(), buffers, params()).unwrap();
    map.load(&load.cells).unwrap();
    test(&mut map);
}

fn apply(map: &mut CostMap<'_>, changes: &[Change]) {
    for &(gx, gy, blocked) in changes {
        map.set_occupancy(gx, gy, if blocked { 100 } else { 0 });
    }
    black_box(map.update_costs());
}

/// Time of whole passes over the ticks, per tick; the map starts afresh in every pass.
fn ticks(map: &mut CostMap<'_>, load: &Workload, ticks: &Ticks, iterations: u64) -> Duration {
    let mut spent = Duration::ZERO;
    for done in 0..iterations {
        let tick = done as usize % ticks.0.len();
        if tick == 0 {
            map.load(&load.cells).unwrap();
        }
        let start = Instant::now();
        apply(map, &ticks.0[tick]);
        spent += start.elapsed();
    }
    spent
}

fn cost_map(c: &mut Criterion) {
    for side in [200, 1000] {
        let load = Workload::office(side);
        println!("{side}x{side}: {:.1} net changes per scan", load.scan.mean());
        let mut group = c.benchmark_group(format!("costmap/{side}"));
        for (name, kept) in [("", false), ("+bytes", true)] {
            with_map(&load, kept, |map| {
                group.bench_function(format!("full{name}"), |b| b.iter(|| map.compute_costs()));
                for (what, sequence) in [("one", &load.one), ("scan", &load.scan)] {
                    group.bench_function(BenchmarkId::from_parameter(format!("{what}{name}")), |b| {
                        b.iter_custom(|n| ticks(map, &load, sequence, n));
                    });
                }
            });
        }
        #[cfg(feature = "peers")]
        peer::bench(&mut group, &load);
        group.finish();
    }
}

#[cfg(feature = "peers")]
mod peer {
    //! The crate `costmap`: it recomputes the region that a change can reach.

    use super::*;
    use costmap::types::{CellRegion, Pose2};
    use costmap::{Costmap, InflationConfig, Layer, MapInfo, WavefrontInflationLayer};
    use criterion::BenchmarkGroup;
    use criterion::measurement::WallTime;
    use glam::{UVec2, Vec2};

    /// Cells that costs reach.
    const RADIUS: u32 = 11;

    struct Peer {
        base: Vec<u8>,
        map: Costmap,
        layer: WavefrontInflationLayer,
        side: u32,
    }

    impl Peer {
        fn new(load: &Workload) -> Self {
            let side = load.side;
            let base: Vec<u8> = load
                .cells
                .iter()
                .map(|v| if *v == 100 { 254 } else { 0 })
                .collect();
            let info = MapInfo {
                width: side,
                height: side,
                resolution: 0.05,
                origin: Vec2::ZERO,
            };
            let map = Costmap::init(info, base.clone()).unwrap();
            let layer = WavefrontInflationLayer::new(InflationConfig {
                inscribed_radius_m: 0.1,
                ..InflationConfig::default()
            });
            let mut peer = Self {
                base,
                map,
                layer,
                side,
            };
            peer.recompute((0, 0), (side, side));
            peer
        }

        /// Clears the region to its base costs and inflates it from sources around it.
        fn recompute(&mut self, from: (u32, u32), to: (u32, u32)) {
            for y in from.1..to.1 {
                for x in from.0..to.0 {
                    let base = self.base[(y * self.side + x) as usize];
                    self.map.set(UVec2::new(x, y), base).unwrap();
                }
            }
            let region = CellRegion::new(UVec2::new(from.0, from.1), UVec2::new(to.0, to.1));
            self.layer.update_costs(&mut self.map, region);
            let _ = Pose2::default();
        }

        fn apply(&mut self, changes: &[Change]) {
            let (mut from, mut to) = ((u32::MAX, u32::MAX), (0, 0));
            for &(x, y, blocked) in changes {
                self.base[(y * self.side + x) as usize] = if blocked { 254 } else { 0 };
                from = (from.0.min(x), from.1.min(y));
                to = (to.0.max(x + 1), to.1.max(y + 1));
            }
            if from.0 < to.0 {
                let low = |v: u32| v.saturating_sub(RADIUS);
                let high = |v: u32| (v + RADIUS).min(self.side);
                self.recompute((low(from.0), low(from.1)), (high(to.0), high(to.1)));
            }
        }
    }

    pub fn bench(group: &mut BenchmarkGroup<'_, WallTime>, load: &Workload) {
        let mut peer = Peer::new(load);
        let side = load.side;
        group.bench_function("full, crate costmap", |b| {
            b.iter(|| peer.recompute((0, 0), (side, side)))
        });
        for (what, sequence) in [("one", &load.one), ("scan", &load.scan)] {
            group.bench_function(format!("{what}, crate costmap"), |b| {
                b.iter_custom(|n| {
                    let mut spent = Duration::ZERO;
                    for done in 0..n {
                        let tick = done as usize % sequence.0.len();
                        if tick == 0 {
                            peer = Peer::new(load);
                        }
                        let start = Instant::now();
                        peer.apply(&sequence.0[tick]);
                        spent += start.elapsed();
                    }
                    spent
                });
            });
        }
    }
}

criterion_group!(benches, cost_map);
criterion_main!(benches);
