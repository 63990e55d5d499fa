//! The std side of horus: everything that runs on a workstation beside the embedded core.
//!
//! | module | what it is |
//! |---|---|
//! | [`mod@reference`] | the std version of grid and cost map, brute force: the oracle for `horus-core` |
//! | [`frames`] | the frames that firmware streams, read back tick by tick |
//! | [`lockstep`] | core and std version side by side on the same scans, every cell compared |
//! | [`log`] | MCAP logs that ROS 2 tools read: writing, bounded reading, comparing |
//! | [`tf`] | the transforms of a log, interpolated at any recorded time |
//! | [`sim`] | a made-up building with a robot and a lidar: input that needs no files |
//! | [`picture`] | PNG pictures and small character windows of grids |
//! | [`prelude`] | the names a program needs to use the std version |
//!
//! [`mod@reference`], [`log`], [`tf`], [`sim`] and [`picture`] know nothing of each other and nothing
//! of the core; [`lockstep`] uses [`mod@reference`], [`picture`] and `horus-core`; [`frames`] uses
//! [`lockstep`] and `horus-core`; the command line `horus-host` uses all of them.
//!
//! Frames and units everywhere: SI, REP 103 axes, REP 105 frames, REP 117 ranges, radians
//! counter-clockwise; times are nanoseconds and end in `_ns`.

pub mod frames;
mod grid_traits;
pub mod lockstep;
pub mod log;
pub mod picture;
pub mod prelude;
pub mod reference;
pub mod sim;
pub mod tf;
