//! Streams of frames, from core's writer through the host's reader: every tick arrives as it was, and
//! whatever happens on the way, nothing arrives that was not sent.

mod damage;
#[path = "../differential/op.rs"]
#[allow(dead_code)]
mod op;
#[path = "../differential/pair.rs"]
#[allow(dead_code)]
mod pair;
mod round_trip;
mod sender;
