//! Objects in the caller's memory: how they are placed and known again.

use core::ffi::c_void;

use super::arena::Arena;
use super::call::{Claims, Plain};
use super::status::horus_status;

/// A kind of object that C holds by a handle.
pub(super) trait Object: Sized + 'static {
    /// Marks objects of this kind, and no other, in memory.
    const TAG: u32;
    /// The incomplete type that C knows it as.
    type Handle;
}

/// A way to make an object.
pub(super) trait Make {
    /// What comes of it.
    type Object: Object;
    /// What C says about it.
    type Config: Plain;
    /// The buffers it takes.
    type Buffers;

    /// Checks the sizes and takes the buffers, which have no elements when only measured.
    fn buffers(config: &Self::Config, arena: &mut Arena) -> Result<Self::Buffers, horus_status>;

    /// Checks the rest and makes the object.
    fn make(config: &Self::Config, buffers: Self::Buffers) -> Result<Self::Object, horus_status>;
}

/// The start of every object's memory.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(super) struct Header {
    pub tag: u32,
    /// Where it was made: an object refers to its own buffers, so a copy is none.
    pub address: usize,
    /// Bytes of the whole block, buffers included.
    pub length: usize,
}

/// An object as it lies at the start of its block; its buffers follow.
#[repr(C)]
pub(super) struct Placed<T> {
    pub header: Header,
    pub object: T,
}

/// Bytes that an object and its buffers take: a multiple of `HORUS_ALIGN`.
pub(super) fn bytes<M: Make>(config: &M::Config) -> Result<usize, horus_status> {
    let mut arena = Arena::measure();
    arena.skip::<Placed<M::Object>>()?;
    M::buffers(config, &mut arena)?;
    Ok(arena.bytes())
}

/// Makes an object in the caller's memory. An error after the claims leaves no object there.
pub(super) fn init<M: Make>(
    claims: &mut Claims<'_>,
    memory: *mut c_void,
    length: usize,
    config: *const M::Config,
    handle: *mut *mut <M::Object as Object>::Handle,
) -> Result<(), horus_status> {
    let config = claims.input(config)?;
    let handle = claims.output(handle)?;
    let needed = bytes::<M>(&config)?;
    let block = claims.block(memory, needed.min(length))?;
    if length < needed {
        return Err(horus_status::BufferTooSmall);
    }
    let placed = block.cast::<Placed<M::Object>>();
    // SAFETY: the block is aligned, its `needed` bytes, which hold a `Placed`, are writable (the
    // contract), and nothing else that this call has claimed reaches it. Whatever object it held
    // ends here.
    let mut arena = unsafe {
        (&raw mut (*placed.as_ptr()).header.tag).write(0);
        Arena::over(block, needed)
    };
    arena.skip::<Placed<M::Object>>()?;
    let buffers = M::buffers(&config, &mut arena)?;
    let object = M::make(&config, buffers)?;
    let header = Header {
        tag: M::Object::TAG,
        address: block.addr().get(),
        length: needed,
    };
    // SAFETY: as above; the buffers lie behind it.
    unsafe { placed.write(Placed { header, object }) };
    handle.write(placed.as_ptr().cast());
    Ok(())
}
