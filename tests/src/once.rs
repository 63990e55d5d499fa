use core::cell::UnsafeCell;

/// A static that is handed out once, in programs of one thread.
#[derive(Debug)]
pub struct Once<T>(UnsafeCell<T>);

// SAFETY: these programs have one thread.
unsafe impl<T> Sync for Once<T> {}

impl<T> Once<T> {
    /// Wraps a value.
    pub const fn new(value: T) -> Self {
        Self(UnsafeCell::new(value))
    }

    /// The value.
    ///
    /// # Safety
    /// Called once per static.
    #[allow(clippy::mut_from_ref)]
    pub unsafe fn take(&self) -> &mut T {
        // SAFETY: one thread, and the caller takes each static once.
        unsafe { &mut *self.0.get() }
    }
}
