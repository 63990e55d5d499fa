//! What one call from C may touch: every pointer is checked, and checked against all others.

use core::ffi::c_void;
use core::marker::PhantomData;
use core::ptr::NonNull;
use core::slice;

use super::object::{Object, Placed};
use super::sizes::HORUS_ALIGN;
use super::status::horus_status;

/// A type of which every bit pattern is a value, so that C can pass anything.
///
/// # Safety
/// As it says: no `bool`, enum or reference inside.
pub(super) unsafe trait Plain: Copy {}

// SAFETY: numbers.
unsafe impl Plain for u8 {}
// SAFETY: numbers.
unsafe impl Plain for i8 {}
// SAFETY: numbers.
unsafe impl Plain for f32 {}

/// Stands for the promise of the C caller; see [`from_c`](Self::from_c).
pub(super) struct Call(());

impl Call {
    /// Opens a call.
    ///
    /// # Safety
    /// Every pointer that the body of [`run`](Self::run) claims is one that the C caller gave to
    /// this call, and that caller keeps the contract in the documentation of `c_abi`.
    pub(super) unsafe fn from_c() -> Self {
        Self(())
    }

    /// Runs the body; its references end with the call.
    pub(super) fn run(
        self,
        body: impl for<'c> FnOnce(&mut Claims<'c>) -> Result<(), horus_status>,
    ) -> horus_status {
        let mut claims = Claims {
            spans: [Span::EMPTY; 8],
            count: 0,
            call: PhantomData,
        };
        match body(&mut claims) {
            Ok(()) => horus_status::Ok,
            Err(status) => status,
        }
    }
}

/// Who else may reach what is claimed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Access {
    Shared,
    Exclusive,
}

/// Claimed bytes, by address.
#[derive(Clone, Copy, Debug)]
struct Span {
    start: usize,
    end: usize,
    access: Access,
}

impl Span {
    const EMPTY: Self = Self {
        start: 0,
        end: 0,
        access: Access::Shared,
    };

    fn conflicts(&self, other: &Self) -> bool {
        let overlap = self.start < other.end && other.start < self.end;
        overlap && (self.access == Access::Exclusive || other.access == Access::Exclusive)
    }
}

/// What a call has claimed so far. Whatever is written is claimed by nothing else, whatever is
/// claimed twice is only read: so the references that are handed out never alias.
pub(super) struct Claims<'c> {
    spans: [Span; 8],
    count: usize,
    call: PhantomData<&'c mut ()>,
}

impl<'c> Claims<'c> {
    /// An object, to be read.
    pub(super) fn object<T: Object>(&mut self, handle: *const T::Handle) -> Result<&'c T, horus_status> {
        let placed = self.find::<T>(handle, Access::Shared)?;
        // SAFETY: `find` saw the header that `init` wrote behind everything else, at this very
        // address, so a `T` lies here (the contract: left alone since); nothing else that this
        // call claims may be written where it or its buffers lie, and no other call is running.
        Ok(unsafe { &(*placed).object })
    }

    /// An object, to be changed.
    pub(super) fn object_mut<T: Object>(
        &mut self,
        handle: *mut T::Handle,
    ) -> Result<&'c mut T, horus_status> {
        let placed = self.find::<T>(handle, Access::Exclusive)?.cast_mut();
        // SAFETY: as in `object`; the claim is exclusive, so nothing else reaches the block.
        Ok(unsafe { &mut (*placed).object })
    }

    fn find<T: Object>(
        &mut self,
        handle: *const T::Handle,
        access: Access,
    ) -> Result<*const Placed<T>, horus_status> {
        let placed = handle.cast::<Placed<T>>();
        aligned(placed, HORUS_ALIGN)?;
        // SAFETY: not NULL, aligned, and at least four readable bytes (the contract). The tag is
        // read alone first: only an object has the whole header.
        let tag = unsafe { (&raw const (*placed).header.tag).read() };
        if tag != T::TAG {
            return Err(horus_status::InvalidHandle);
        }
        // SAFETY: the tag says that `init` wrote a header here.
        let header = unsafe { (&raw const (*placed).header).read() };
        if header.address != placed.addr() {
            return Err(horus_status::InvalidHandle); // copied from elsewhere
        }
        self.claim(header.address, header.length, access)?;
        Ok(placed)
    }

    /// A value that C points to, copied.
    pub(super) fn input<T: Plain>(&mut self, value: *const T) -> Result<T, horus_status> {
        self.pointer(value, 1, Access::Shared)?;
        // SAFETY: not NULL, aligned, readable (the contract), not reached by any exclusive claim,
        // and every bit pattern is a `T`.
        Ok(unsafe { value.read() })
    }

    /// Values that C points to. NULL is legal for none.
    pub(super) fn slice<T: Plain>(
        &mut self,
        values: *const T,
        count: usize,
    ) -> Result<&'c [T], horus_status> {
        if count == 0 {
            return Ok(&[]);
        }
        self.pointer(values, count, Access::Shared)?;
        // SAFETY: not NULL, aligned, `count` readable elements (the contract) of at most
        // `isize::MAX` bytes, not reached by any exclusive claim, and every bit pattern is a `T`.
        Ok(unsafe { slice::from_raw_parts(values, count) })
    }

    /// Values that the call fills. NULL is legal for none.
    pub(super) fn slice_mut<T: Plain>(
        &mut self,
        values: *mut T,
        count: usize,
    ) -> Result<&'c mut [T], horus_status> {
        if count == 0 {
            return Ok(&mut []);
        }
        self.pointer(values, count, Access::Exclusive)?;
        // SAFETY: as in `slice`, writable, and no other claim reaches it.
        Ok(unsafe { slice::from_raw_parts_mut(values, count) })
    }

    /// A place for one result.
    pub(super) fn output<T>(&mut self, value: *mut T) -> Result<Output<'c, T>, horus_status> {
        self.pointer(value, 1, Access::Exclusive)?;
        Ok(Output {
            value: NonNull::new(value),
            call: PhantomData,
        })
    }

    /// A place for one result, or NULL: not wanted.
    pub(super) fn output_or_null<T>(&mut self, value: *mut T) -> Result<Output<'c, T>, horus_status> {
        if value.is_null() {
            return Ok(Output {
                value: None,
                call: PhantomData,
            });
        }
        self.output(value)
    }

    /// Memory for an object: aligned, and nothing else reaches its first `bytes` bytes.
    pub(super) fn block(&mut self, memory: *mut c_void, bytes: usize) -> Result<NonNull<u8>, horus_status> {
        let memory = memory.cast::<u8>();
        aligned(memory, HORUS_ALIGN)?;
        self.claim(memory.addr(), bytes, Access::Exclusive)?;
        NonNull::new(memory).ok_or(horus_status::NullPointer)
    }

    fn pointer<T>(&mut self, values: *const T, count: usize, access: Access) -> Result<(), horus_status> {
        aligned(values, align_of::<T>())?;
        let bytes = count
            .checked_mul(size_of::<T>())
            .ok_or(horus_status::SizeOverflow)?;
        self.claim(values.addr(), bytes, access)
    }

    fn claim(&mut self, start: usize, bytes: usize, access: Access) -> Result<(), horus_status> {
        let end = start.checked_add(bytes);
        let end = end.filter(|_| isize::try_from(bytes).is_ok());
        let end = end.ok_or(horus_status::SizeOverflow)?;
        let span = Span { start, end, access };
        let mut claimed = self.spans.iter().take(self.count);
        if claimed.any(|other| span.conflicts(other)) {
            return Err(horus_status::Overlap);
        }
        // No function claims more than there is room for; one that did would always be refused.
        let free = self.spans.get_mut(self.count).ok_or(horus_status::Overlap)?;
        *free = span;
        self.count += 1;
        Ok(())
    }
}

fn aligned<T>(pointer: *const T, align: usize) -> Result<(), horus_status> {
    if pointer.is_null() {
        Err(horus_status::NullPointer)
    } else if !pointer.addr().is_multiple_of(align) {
        Err(horus_status::Misaligned)
    } else {
        Ok(())
    }
}

/// A place for one result of a call.
pub(super) struct Output<'c, T> {
    /// `None`: not wanted.
    value: Option<NonNull<T>>,
    call: PhantomData<&'c mut T>,
}

impl<T> Output<'_, T> {
    pub(super) fn write(self, value: T) {
        if let Some(to) = self.value {
            // SAFETY: aligned, writable (the contract), and no other claim reaches it.
            unsafe { to.write(value) };
        }
    }
}
