//! Buffers one behind the other in one block of memory.

use core::ptr::NonNull;
use core::slice;

use crate::grid::BeamSlot;
use crate::local::BufferSlot;

use super::sizes::HORUS_ALIGN;
use super::status::horus_status;
use crate::costmap::{CostTables, FieldCell};
use crate::distance::EnvelopeVertex;
use crate::evidence::{BeamLimits, EvidenceU16};

/// A type of which all bits zero is a value.
///
/// # Safety
/// As it says.
pub(super) unsafe trait Zeroed: 'static {}

// SAFETY: a number.
unsafe impl Zeroed for u8 {}
// SAFETY: a number.
unsafe impl Zeroed for i8 {}
// SAFETY: a number.
unsafe impl Zeroed for u16 {}
// SAFETY: a number.
unsafe impl Zeroed for u32 {}
// SAFETY: a number.
unsafe impl Zeroed for i16 {}
// SAFETY: a number.
unsafe impl Zeroed for i32 {}
// SAFETY: numbers; `EMPTY` is all bits zero.
unsafe impl Zeroed for EnvelopeVertex {}
// SAFETY: numbers; `EMPTY` is all bits zero.
unsafe impl Zeroed for BeamSlot {}
// SAFETY: a number.
unsafe impl Zeroed for f32 {}
// SAFETY: numbers, and an enum whose first value is zero.
unsafe impl Zeroed for BufferSlot {}
// SAFETY: as above.
unsafe impl Zeroed for BeamLimits {}
// SAFETY: numbers; the vacuous cell is all bits zero.
unsafe impl Zeroed for EvidenceU16 {}
// SAFETY: numbers and flags, arrays of them; `EMPTY` is all bits zero.
unsafe impl<F: FieldCell> Zeroed for CostTables<F> {}

/// Hands out buffers from a block, or, without one, measures how much they take: the same code
/// asks for them either way, so the measure cannot differ from the need.
pub(super) struct Arena {
    block: Option<NonNull<u8>>,
    length: usize,
    used: usize,
}

impl Arena {
    /// Measures.
    pub(super) const fn measure() -> Self {
        Self {
            block: None,
            length: isize::MAX as usize,
            used: 0,
        }
    }

    /// Hands out.
    ///
    /// # Safety
    /// `block` is aligned to [`HORUS_ALIGN`] and has `length` writable bytes that nothing else
    /// reaches as long as what is handed out lives.
    pub(super) const unsafe fn over(block: NonNull<u8>, length: usize) -> Self {
        Self {
            block: Some(block),
            length,
            used: 0,
        }
    }

    /// Bytes taken so far, rounded up so that another block may follow.
    pub(super) fn bytes(&self) -> usize {
        self.used.next_multiple_of(HORUS_ALIGN)
    }

    /// Leaves room for a `T` that somebody else writes.
    pub(super) fn skip<T>(&mut self) -> Result<(), horus_status> {
        self.place::<T>(1).map(|_| ())
    }

    /// The next `count` elements, zeroed; none when only measuring.
    pub(super) fn take<T: Zeroed>(&mut self, count: usize) -> Result<&'static mut [T], horus_status> {
        let start = self.place::<T>(count)?;
        let Some(block) = self.block else {
            return Ok(&mut []);
        };
        // SAFETY: `place` found `start` and `count` elements inside the block, behind everything
        // handed out before, aligned as the block is to HORUS_ALIGN >= align_of::<T>(). They are
        // valid once zeroed, and nothing else reaches them.
        Ok(unsafe {
            let first = block.add(start).cast::<T>();
            first.write_bytes(0, count);
            slice::from_raw_parts_mut(first.as_ptr(), count)
        })
    }

    /// Room for one value.
    pub(super) fn room<T: 'static>(&mut self) -> Result<Room<T>, horus_status> {
        let start = self.place::<T>(1)?;
        // SAFETY: as in `take`.
        let place = self.block.map(|block| unsafe { block.add(start).cast() });
        Ok(Room { place })
    }

    /// Where the next `count` elements start.
    fn place<T>(&mut self, count: usize) -> Result<usize, horus_status> {
        const { assert!(align_of::<T>() <= HORUS_ALIGN) };
        let start = self.used.next_multiple_of(align_of::<T>());
        let end = count
            .checked_mul(size_of::<T>())
            .and_then(|b| b.checked_add(start));
        // Room to round up stays below `isize::MAX`, too.
        let end = end.filter(|end| *end <= isize::MAX as usize - HORUS_ALIGN);
        let end = end.ok_or(horus_status::SizeOverflow)?;
        if end > self.length {
            return Err(horus_status::BufferTooSmall);
        }
        self.used = end;
        Ok(start)
    }
}

/// Room for one value in a block; none when only measuring.
pub(super) struct Room<T> {
    place: Option<NonNull<T>>,
}

impl<T: 'static> Room<T> {
    /// Puts the value there.
    pub(super) fn put(self, value: T) -> Result<&'static mut T, horus_status> {
        let mut place = self.place.ok_or(horus_status::BufferTooSmall)?;
        // SAFETY: the arena found room for a `T` here, aligned, which nothing else reaches.
        Ok(unsafe {
            place.write(value);
            place.as_mut()
        })
    }
}
