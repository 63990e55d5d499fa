//! The command line, run as its users run it.

mod bad_input;
mod bridge;
mod compare;
mod demo;
mod evidence;
mod local;
mod map;
mod record;
mod replay;
mod support;
mod views;
