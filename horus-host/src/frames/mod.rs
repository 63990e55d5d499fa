//! The listener's side of [`horus_core::frames`]: a stream of frames, maybe damaged, becomes ticks.
//!
//! A [`StreamReader`] takes bytes from any source and yields every tick that arrived whole, with the
//! map as it was then. What is damaged, cut, out of order or does not fit what came before is
//! counted by kind with the place of the first ([`Problems`]) and skipped; after a loss ticks are
//! dropped until the next key tick, so that no map is ever yielded that the sender did not have.
//! Text between frames is skipped. Memory is bounded by the longest frame and the largest map.
//!
//! # Examples
//! ```
//! use horus_core::costmap::bit_words;
//! use horus_core::frames::{MapStream, StreamOptions, StreamTick};
//! use horus_core::prelude::*;
//! use horus_host::frames::StreamReader;
//!
//! # let mut buffers = CostMapBuffers::<{ 40 * 40 }, { bit_words(40, 40) }>::empty();
//! # let (cells, cost_buffers) = buffers.split();
//! # let grid = OccupancyGrid::new_in(cells, 40, 40, 0.05, Pose2D::new(-1.0, -1.0, 0.0))?;
//! let mut map = CostMap::new_in(grid, cost_buffers, CostParams::default())?;
//! let mut wire = b"booting\n".to_vec();
//! let mut buffer = [0; 256];
//! let mut stream = MapStream::new_in(&mut buffer, |frame: &[u8]| wire.extend(frame), StreamOptions::default())?;
//! map.set_occupancy(20, 20, 100);
//! let costs_changed = map.update_costs();
//! let scan = LaserScan { angle_min: 0.0, angle_increment: 0.0, range_min: 0.0, range_max: 0.0, ranges: &[] };
//! let pose = Pose2D::default();
//! let changed = costs_changed;
//! stream.tick(&map, &StreamTick { stamp_ns: 7, robot: pose, sensor: pose, scan, changed, costs_changed });
//!
//! let mut reader = StreamReader::new(wire.as_slice());
//! let tick = reader.next_tick()?.expect("a key tick");
//! assert_eq!(tick.maps.expect("with maps").costs[20 * 40 + 20], 253);
//! assert!(reader.next_tick()?.is_none() && reader.problems().is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod assembler;
mod order;
mod parser;
mod problem;
mod reader;
mod session;
mod tick;
mod window;

pub use problem::{Problem, ProblemKind, Problems};
pub use reader::StreamReader;
pub use session::StreamSession;
pub use tick::StreamedTick;
