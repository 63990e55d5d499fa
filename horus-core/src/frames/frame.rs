use super::{FrameKind, Put, RowsPart, ScanPart, Session, Take, TickEnd, TickStart};

/// What a frame carries.
pub trait Payload<'a>: Sized {
    /// The kind of frame that carries it.
    const KIND: FrameKind;

    /// Appends the fields.
    fn put(&self, out: &mut Put<'_>);

    /// Reads the fields; `None` if they are not those of such a payload.
    fn take(from: &mut Take<'a>) -> Option<Self>;
}

/// The payload of a frame, read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Frame<'a> {
    /// See [`Session`].
    Session(Session<'a>),
    /// See [`TickStart`].
    TickStart(TickStart),
    /// See [`ScanPart`].
    Scan(ScanPart<'a>),
    /// See [`RowsPart`].
    Rows(RowsPart<'a>),
    /// See [`TickEnd`].
    TickEnd(TickEnd),
}

/// Why a payload cannot be read although its checksum is right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unreadable {
    /// This version knows no frame of this kind.
    UnknownKind,
    /// The fields are not those of the kind.
    Malformed,
}

impl<'a> Frame<'a> {
    /// Reads the payload of a frame of kind `kind`; all of it must be used.
    ///
    /// # Errors
    /// [`Unreadable`].
    pub fn read(kind: u8, payload: &'a [u8]) -> Result<Self, Unreadable> {
        const SESSION: u8 = FrameKind::Session as u8;
        const TICK_START: u8 = FrameKind::TickStart as u8;
        const SCAN: u8 = FrameKind::Scan as u8;
        const ROWS: u8 = FrameKind::Rows as u8;
        const TICK_END: u8 = FrameKind::TickEnd as u8;
        let mut from = Take::new(payload);
        let frame = match kind {
            SESSION => Session::take(&mut from).map(Self::Session),
            TICK_START => TickStart::take(&mut from).map(Self::TickStart),
            SCAN => ScanPart::take(&mut from).map(Self::Scan),
            ROWS => RowsPart::take(&mut from).map(Self::Rows),
            TICK_END => TickEnd::take(&mut from).map(Self::TickEnd),
            _ => return Err(Unreadable::UnknownKind),
        };
        frame.filter(|_| from.is_empty()).ok_or(Unreadable::Malformed)
    }
}
