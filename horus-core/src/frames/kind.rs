/// What a frame holds; the number is the one on the wire.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(u8)]
pub enum FrameKind {
    /// [`Session`](super::Session).
    Session = 1,
    /// [`TickStart`](super::TickStart).
    TickStart = 2,
    /// [`ScanPart`](super::ScanPart).
    Scan = 3,
    /// [`RowsPart`](super::RowsPart).
    Rows = 4,
    /// [`TickEnd`](super::TickEnd).
    TickEnd = 5,
}
