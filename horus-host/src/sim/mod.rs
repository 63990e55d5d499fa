//! A robot that drives through a made-up building: test input that needs no files.
//!
//! A [`Simulation`] yields one [`SimTick`] per lidar scan: the true pose and 360 noisy ranges. The
//! building ([`World`]) has rooms of 4 to 6 m, doors about 1 m wide, windows that a lidar does not
//! see, furniture, and [`Person`]s walking to and fro. The robot ([`Drive`]) follows a closed
//! circuit through all rooms, past the people and never into anything.
//!
//! The same [`SimConfig`] gives the same bits on every machine: random numbers come from one
//! seeded generator and all functions beyond + - * / from `libm`.
//!
//! World frame: x and y in metres from the building's lower left corner, angles in radians,
//! counter-clockwise. Odometry is perfect: the odometry frame is the world frame.

mod circuit;
mod config;
mod crowd;
mod disc;
mod drive;
mod floor_plan;
mod furniture;
mod lidar;
mod oriented_box;
mod person;
mod pose;
mod random;
mod segment;
mod simulation;
#[cfg(test)]
mod tests;
mod tick;
mod walls;
mod world;

pub use config::SimConfig;
pub use disc::Disc;
pub use drive::Drive;
pub use lidar::Lidar;
pub use oriented_box::OrientedBox;
pub use person::Person;
pub use pose::Pose;
pub use segment::Segment;
pub use simulation::Simulation;
pub use tick::SimTick;
pub use world::World;
