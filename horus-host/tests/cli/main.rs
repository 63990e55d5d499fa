//! The command line, run as its users run it.

mod bad_input;
mod compare;
mod demo;
mod record;
mod replay;
mod support;
