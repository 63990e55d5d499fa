//! Named buffers between sensors and the map.

mod buffers;
mod element;
mod shape;
mod slot;
mod view;

pub use buffers::SensingBuffers;
pub use element::{Element, ElementKind};
pub use shape::Shape;
pub use slot::BufferSlot;
pub use view::BufferView;

use crate::error::{Buffer, Error, MAX_NAME, require};
use crate::geometry::Pose2D;
use slot::MAX_KEY;

/// A fixed-capacity store of named buffers of `f32` and `u8`, shaped in one or two dimensions, over
/// caller-provided storage: what sensors measured, and what a map made of it.
///
/// A buffer is called `name/field`, or `field` for the empty name. It is reserved once, with a
/// capacity, and then holds what was last written until [`clear`](Self::clear).
///
/// Source: navground's `SensingState`.
///
/// # Examples
/// ```
/// use horus_core::local::Shape;
/// use horus_core::prelude::*;
///
/// let mut buffers = SensingBuffers::<2, 8, 0>::empty(); // a `static` in firmware
/// let mut state = buffers.state();
/// state.reserve::<f32>("imu", "gyro", 3)?;
/// assert!(state.read::<f32>("imu", "gyro").is_none(), "nothing was written");
/// state.write("imu", "gyro", Shape::line(3), &[0.0, 0.0, 0.1])?;
/// assert_eq!(state.read::<f32>("imu", "gyro").unwrap().data()[2], 0.1);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug)]
pub struct SensingState<'a> {
    slots: &'a mut [BufferSlot],
    floats: &'a mut [f32],
    bytes: &'a mut [u8],
    used: usize,
    used_floats: usize,
    used_bytes: usize,
}

impl<'a> SensingState<'a> {
    /// A state without buffers: room for one name per slot, and for all `floats` and `bytes`.
    pub fn new_in(slots: &'a mut [BufferSlot], floats: &'a mut [f32], bytes: &'a mut [u8]) -> Self {
        Self {
            slots,
            floats,
            bytes,
            used: 0,
            used_floats: 0,
            used_bytes: 0,
        }
    }

    /// Reserves a buffer of up to `capacity` elements. One that is there already stays as it is.
    ///
    /// # Errors
    /// [`Error::NameTooLong`]; [`Error::BufferType`] if the buffer is there with another type;
    /// [`Error::BufferTooSmall`] if it is there with less capacity, or if slots or elements run out.
    /// Nothing changes then.
    ///
    /// # Complexity
    /// One comparison of names per buffer.
    pub fn reserve<T: Element>(&mut self, name: &str, field: &str, capacity: usize) -> Result<(), Error> {
        check_name(name)?;
        let key = name.len() + field.len() + usize::from(!name.is_empty());
        if key > MAX_KEY {
            return Err(Error::NameTooLong { given: key });
        }
        if let Some(slot) = self.slot(name, field) {
            if slot.kind != T::KIND {
                return Err(Error::BufferType);
            }
            return require(Buffer::Named, capacity, slot.capacity());
        }
        let used = match T::KIND {
            ElementKind::F32 => self.used_floats,
            ElementKind::U8 => self.used_bytes,
        };
        let free = T::elements(self).len().saturating_sub(used);
        require(T::BUFFER, capacity, free)?;
        require(Buffer::Slots, self.used + 1, self.slots.len())?;
        if let Some(slot) = self.slots.get_mut(self.used) {
            *slot = BufferSlot::new((name, field), T::KIND, (used, capacity));
        }
        self.used += 1;
        match T::KIND {
            ElementKind::F32 => self.used_floats += capacity,
            ElementKind::U8 => self.used_bytes += capacity,
        }
        Ok(())
    }

    /// Writes all elements of a buffer, row-major; one that is not there yet is reserved.
    ///
    /// # Errors
    /// As [`reserve`](Self::reserve); [`Error::LengthMismatch`] unless there is one value per element
    /// of the shape. Nothing changes then.
    ///
    /// # Complexity
    /// One comparison of names per buffer, one write per element.
    pub fn write<T: Element>(
        &mut self,
        name: &str,
        field: &str,
        shape: Shape,
        values: &[T],
    ) -> Result<(), Error> {
        if shape.elements() != Some(values.len()) {
            return Err(Error::LengthMismatch {
                needed: shape.elements().unwrap_or(usize::MAX),
                given: values.len(),
            });
        }
        self.reserve::<T>(name, field, values.len())?;
        let used = self.used;
        let slots = self.slots.iter_mut().take(used);
        let mut range = 0..0;
        if let Some(slot) = slots.into_iter().find(|slot| slot.is(name, field)) {
            slot.shape = shape;
            range = slot.range();
        }
        if let Some(elements) = T::elements_mut(self).get_mut(range)
            && elements.len() == values.len()
        {
            elements.copy_from_slice(values);
        }
        Ok(())
    }

    /// What was last written to a buffer; `None` if nothing was, or if it holds another type.
    ///
    /// # Complexity
    /// One comparison of names per buffer.
    pub fn read<T: Element>(&self, name: &str, field: &str) -> Option<BufferView<'_, T>> {
        let slot = self.slot(name, field)?;
        if slot.kind != T::KIND || slot.shape.dimensions() == 0 {
            return None;
        }
        Some(BufferView {
            shape: slot.shape,
            data: T::elements(self).get(slot.range())?,
        })
    }

    /// Forgets the contents of all buffers; they stay reserved.
    pub fn clear(&mut self) {
        for slot in self.slots.iter_mut().take(self.used) {
            slot.shape = Shape::EMPTY;
        }
    }

    /// Every buffer's name, type and the shape of its contents (`None`: nothing was written), in the
    /// order in which they were reserved.
    pub fn buffers(&self) -> impl Iterator<Item = (&str, ElementKind, Option<Shape>)> + '_ {
        self.slots.iter().take(self.used).map(|slot| {
            let shape = (slot.shape.dimensions() > 0).then_some(slot.shape);
            (slot.key_str(), slot.kind, shape)
        })
    }

    /// A buffer of three numbers as a pose.
    pub(super) fn pose(&self, name: &str, field: &str) -> Option<Pose2D> {
        match self.read::<f32>(name, field)?.data() {
            &[x, y, theta] => Some(Pose2D::new(x, y, theta)),
            _ => None,
        }
    }

    /// Several reservations: if one fails, none was made.
    pub(super) fn all_or_nothing(
        &mut self,
        reserve: impl FnOnce(&mut Self) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let before = (self.used, self.used_floats, self.used_bytes);
        reserve(self).inspect_err(|_| (self.used, self.used_floats, self.used_bytes) = before)
    }

    fn slot(&self, name: &str, field: &str) -> Option<&BufferSlot> {
        self.slots
            .iter()
            .take(self.used)
            .find(|slot| slot.is(name, field))
    }
}

/// An error if a sensor's or a map's name is too long.
pub(super) fn check_name(name: &str) -> Result<(), Error> {
    if name.len() > MAX_NAME {
        Err(Error::NameTooLong { given: name.len() })
    } else {
        Ok(())
    }
}
