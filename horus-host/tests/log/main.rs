//! Logs: writing, reading and comparing whole files.

mod compare;
mod file;
mod samples;
