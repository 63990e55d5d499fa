//! Text that crosses the interface.

use core::ffi::c_char;

use super::call::Claims;
use super::status::horus_status;

/// UTF-8 text of `length` bytes; NULL is legal for none.
pub(super) fn input<'c>(
    claims: &mut Claims<'c>,
    text: *const c_char,
    length: usize,
) -> Result<&'c str, horus_status> {
    let bytes = claims.slice(text.cast::<u8>(), length)?;
    str::from_utf8(bytes).map_err(|_| horus_status::InvalidText)
}

/// Copies a text with its terminating zero into `to`, which has room for `length` bytes.
pub(super) fn output(
    claims: &mut Claims<'_>,
    to: *mut c_char,
    length: usize,
    text: &str,
) -> Result<(), horus_status> {
    if text.len() >= length {
        return Err(horus_status::BufferTooSmall);
    }
    let to = claims.slice_mut(to.cast::<u8>(), text.len() + 1)?;
    for (to, from) in to.iter_mut().zip(text.bytes().chain([0])) {
        *to = from;
    }
    Ok(())
}
