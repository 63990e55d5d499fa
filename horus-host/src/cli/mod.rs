//! Commands, their options and what they print.
//!
//! Exit codes: 0 everything equal or recorded, 1 a mismatch, a difference or a loss, 2 bad input or
//! usage, with one sentence on standard error.

mod bridge;
mod byte_source;
mod compare;
mod cost_options;
mod demo;
mod difference;
mod evidence;
mod grid_picture;
mod info;
mod map;
mod map_geometry;
mod map_kind;
mod map_log;
mod map_options;
mod out_dir;
mod progress;
mod record;
mod recording;
mod render;
mod replay;
mod report;
mod session;
mod skipped;
mod step;
mod summary;
mod survey;
mod value_grid;
mod verdict;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use verdict::{one_sentence, unusable};

/// Runs the command that the arguments of the process name.
pub fn run() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            // Help and version go to standard output and are no failure; nobody may be listening.
            let _ = error.print();
            return if error.use_stderr() {
                unusable()
            } else {
                ExitCode::SUCCESS
            };
        }
    };
    let result = match &arguments.command {
        Command::Demo(options) => demo::run(options),
        Command::Replay(options) => replay::run(options),
        Command::Compare(options) => compare::run(options),
        Command::Record(options) => record::run(options),
        Command::Map(options) => map::run(options),
        Command::Pub(options) => bridge::publish(options),
        Command::Sub(options) => bridge::subscribe(options),
        Command::Info(options) => info::run(options),
        Command::Render(options) => render::run(options),
    };
    match result {
        Ok(verdict) => verdict.into(),
        Err(error) => {
            eprintln!("horus-host: {}", one_sentence(&error));
            unusable()
        }
    }
}

/// Runs the embedded core and its std version side by side and compares every cell.
#[derive(Debug, Parser)]
#[command(name = "horus-host", bin_name = "horus-host", version, after_help = EXAMPLES, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Drive a robot through a made-up building; needs no input
    Demo(demo::DemoOptions),
    /// Replay the laser scans of a recorded ROS 2 log (MCAP)
    Replay(replay::ReplayOptions),
    /// Compare two logs topic by topic, message by message, cell by cell
    Compare(compare::CompareOptions),
    /// Record the frames of a target (serial device, file or standard input) as a log
    Record(record::RecordOptions),
    /// Publish a log over shared memory, topic by topic
    Pub(bridge::PublishOptions),
    /// Record what is published over shared memory as a log
    Sub(bridge::SubscribeOptions),
    /// Tell what is in a log: topics, rates, grids, parameters
    Info(info::InfoOptions),
    /// Paint the grids of a log, with scan and robot, as PNG frames
    Render(render::RenderOptions),
    /// Turn a nav2 map_server file into costs and distances, or save a map as one
    Map(map::MapOptions),
}

const EXAMPLES: &str = "\
Examples:
  horus-host demo                             60 s in a made-up building, results in ./out
  horus-host demo --seconds 5 --out /tmp/o    a short one, elsewhere
  horus-host replay drive.mcap                every scan of a log through both versions
  horus-host replay drive.mcap --out out --width 400 --height 400 --radius 1.0
  horus-host replay drive.mcap --preset nav2 --scan /front/scan --odom-frame map
  horus-host replay drive.mcap --map local --config map.yaml --out out
  horus-host replay drive.mcap --map evidence --fusion pcr6 --out out
  horus-host compare out/core.mcap out/std.mcap
  horus-host record /dev/ttyACM0 --baud 921600 --out target.mcap
  horus-host compare a.mcap b.mcap --tolerance /distance=0.01 --diff diff.mcap --picture first.png
  horus-host info out/core.mcap
  horus-host sub --out live.mcap & horus-host pub drive.mcap --wait 1
  horus-host render out/core.mcap --topic /costmap_raw --every 10 --against out/std.mcap
  horus-host map warehouse.yaml --radius 0.4 --out out
  horus-host map save out/core.mcap room.yaml --topic /local_map

Exit codes: 0 everything equal or recorded, 1 a mismatch or a loss, 2 bad input or usage.";
