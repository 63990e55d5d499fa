//! `horus-host record`: a stream of frames becomes the log that a run on the host writes.

mod damage;
mod live;
mod refused;
mod stream;
mod whole;
