//! Buffers on a backend: handles that own them, and the table in which a backend keeps them.

use super::BackendError;
use std::sync::{Arc, Mutex, PoisonError};
use vitrum_io::Words;

/// A buffer on a backend. Clones of the handle name the same buffer, which is freed when the last of them is dropped.
#[derive(Debug, Clone)]
pub struct Buffer(Arc<Handle>);

/// The numbers of buffers whose handles were all dropped and whose memory the backend still has.
type Dropped = Arc<Mutex<Vec<usize>>>;

#[derive(Debug)]
struct Handle {
    number: usize,
    dropped: Dropped,
}

impl Drop for Handle {
    fn drop(&mut self) {
        self.dropped.lock().unwrap_or_else(PoisonError::into_inner).push(self.number);
    }
}

impl Buffer {
    /// The buffer's place in its backend's table: no other living buffer of that backend has the same.
    pub(super) fn number(&self) -> usize {
        self.0.number
    }

    /// Whether no other handle names the buffer.
    pub(super) fn is_last(&self) -> bool {
        Arc::strong_count(&self.0) == 1
    }
}

impl PartialEq for Buffer {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Eq for Buffer {}

/// The first contents of a buffer, in whole words; no buffer is empty.
pub enum Contents<'a> {
    /// A copy of these bytes.
    Bytes(&'a [u8]),
    /// Words that nothing may write while the buffer lives: where a backend can, the same memory.
    Shared(&'a Words),
    /// Zeros, in this number of bytes.
    Zeros(u64),
    /// Words that a function writes into zeros, in this number of bytes: where a backend can, without a copy.
    Written(u64, &'a mut (dyn FnMut(&mut [u32]) + Send)),
}

impl Contents<'_> {
    /// The buffer's size, in bytes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        match self {
            Self::Bytes(bytes) => bytes.len() as u64,
            Self::Shared(words) => size_of_val(&***words) as u64,
            Self::Zeros(bytes) | Self::Written(bytes, _) => *bytes,
        }
    }
}

/// A backend's buffers. The memory of dropped ones is given back as soon as the backend is used again.
#[derive(Debug)]
pub(super) struct Buffers<T> {
    slots: Vec<Option<T>>,
    dropped: Dropped,
}

impl<T> Default for Buffers<T> {
    fn default() -> Self {
        Self { slots: Vec::new(), dropped: Dropped::default() }
    }
}

impl<T> Buffers<T> {
    /// Gives back the memory of buffers whose handles were all dropped.
    pub(super) fn collect(&mut self) {
        for number in self.dropped.lock().unwrap_or_else(PoisonError::into_inner).drain(..) {
            self.slots[number] = None;
        }
    }

    /// Keeps a buffer; its handle.
    pub(super) fn add(&mut self, contents: T) -> Buffer {
        self.collect();
        let number = self.slots.iter().position(Option::is_none).unwrap_or(self.slots.len());
        if number == self.slots.len() {
            self.slots.push(None);
        }
        self.slots[number] = Some(contents);
        Buffer(Arc::new(Handle { number, dropped: Arc::clone(&self.dropped) }))
    }

    /// The contents of a buffer.
    ///
    /// # Errors
    /// [`BackendError::Misuse`] for a buffer of another backend.
    pub(super) fn get(&self, buffer: &Buffer) -> Result<&T, BackendError> {
        self.find(buffer).ok_or_else(stranger)
    }

    /// The contents of a buffer; `None` if it belongs to another backend.
    pub(super) fn find(&self, buffer: &Buffer) -> Option<&T> {
        self.slots.get(self.number(buffer)?)?.as_ref()
    }

    /// As [`Self::get`], to be changed or taken out for a while.
    ///
    /// # Errors
    /// [`BackendError::Misuse`] for a buffer of another backend.
    pub(super) fn slot(&mut self, buffer: &Buffer) -> Result<&mut Option<T>, BackendError> {
        let number = self.number(buffer).ok_or_else(stranger)?;
        Ok(&mut self.slots[number])
    }

    /// The contents of the buffers that still have a handle.
    pub(super) fn living(&self) -> impl Iterator<Item = &T> {
        let dropped = self.dropped.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let slots = self.slots.iter().enumerate().filter(move |(number, _)| !dropped.contains(number));
        slots.filter_map(|(_, slot)| slot.as_ref())
    }

    fn number(&self, buffer: &Buffer) -> Option<usize> {
        Arc::ptr_eq(&buffer.0.dropped, &self.dropped).then_some(buffer.0.number)
    }
}

fn stranger() -> BackendError {
    BackendError::Misuse { kernel: "-", what: "a buffer belongs to another backend".to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_buffer_lives_as_long_as_its_last_handle() {
        let mut buffers = Buffers::default();
        let first = buffers.add("first");
        let second = buffers.add("second");
        let clone = first.clone();
        drop(first);
        assert_eq!(buffers.get(&clone).unwrap(), &"first");
        assert!(clone.is_last());
        assert_eq!(buffers.living().count(), 2);
        let number = clone.number();
        drop(clone);
        assert_eq!(buffers.living().collect::<Vec<_>>(), [&"second"]);
        let third = buffers.add("third");
        assert_eq!(third.number(), number, "the place is used again");
        assert_eq!((buffers.get(&second).unwrap(), buffers.get(&third).unwrap()), (&"second", &"third"));
    }

    #[test]
    fn buffers_of_another_backend_are_refused() {
        let (mut one, mut other) = (Buffers::default(), Buffers::default());
        let (mine, _theirs) = (one.add(1), other.add(2));
        assert!(matches!(other.get(&mine), Err(BackendError::Misuse { .. })));
        assert!(other.slot(&mine).is_err() && other.find(&mine).is_none());
    }
}
