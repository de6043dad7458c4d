//! Data that methods keep from frame to frame, on the host and on the backend.

use crate::backend::{Backend, BackendError, Buffer, Contents};
use std::any::{Any, TypeId};
use std::collections::HashMap;
use std::convert::Infallible;

/// Data that the methods of a renderer keep from frame to frame: for each method one value of a type of its own.
///
/// All of it belongs to one backend and to one set of assets; a renderer makes a new cache for others.
#[derive(Default)]
pub struct Cache {
    entries: HashMap<TypeId, Box<dyn Any + Send>>,
}

impl Cache {
    /// The value of type `T`. Data of another type, of a method that is no longer used, is dropped.
    pub fn of<T: Any + Default + Send>(&mut self) -> &mut T {
        self.entries.retain(|id, _| *id == TypeId::of::<T>());
        let entry = self.entries.entry(TypeId::of::<T>()).or_insert_with(|| Box::new(T::default()));
        let Some(value) = entry.downcast_mut() else { unreachable!("values are stored by their types") };
        value
    }
}

/// The result of the last computation, with the key that it was computed for.
#[derive(Debug)]
pub(in crate::method) struct Memo<K, V>(Option<(K, V)>);

impl<K, V> Default for Memo<K, V> {
    fn default() -> Self {
        Self(None)
    }
}

impl<K: PartialEq, V> Memo<K, V> {
    /// The value for `key`: the stored one if it belongs to the same key, else a new one that `make` computes and the memo stores.
    ///
    /// # Errors
    /// Those of `make`.
    pub(in crate::method) fn get<E>(&mut self, key: K, make: impl FnOnce() -> Result<V, E>) -> Result<&V, E> {
        if self.0.as_ref().is_none_or(|(known, _)| *known != key) {
            // The old result goes first: both together could be too much for a device.
            self.0 = None;
            self.0 = Some((key, make()?));
        }
        Ok(&self.0.as_ref().expect("it was made above").1)
    }

    /// As [`Self::get`], for a computation that cannot fail.
    pub(in crate::method) fn of(&mut self, key: K, make: impl FnOnce() -> V) -> &V {
        let Ok(value) = self.get::<Infallible>(key, || Ok(make()));
        value
    }
}

/// A buffer's name in a frame: a label, and a number where several buffers have the same one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(in crate::method) struct Label(&'static str, usize);

impl From<&'static str> for Label {
    fn from(label: &'static str) -> Self {
        Self(label, 0)
    }
}

impl From<(&'static str, usize)> for Label {
    fn from((label, number): (&'static str, usize)) -> Self {
        Self(label, number)
    }
}

/// Buffers that each frame writes anew, used again by the next frame of the same size.
#[derive(Default)]
pub(in crate::method) struct Scratch {
    buffers: HashMap<Label, Buffer>,
}

impl Scratch {
    /// A buffer of `bytes` bytes that are 0. Two buffers of a frame must not have the same label.
    ///
    /// # Errors
    /// As [`Backend::create`].
    pub(in crate::method) fn zeros(
        &mut self,
        label: impl Into<Label>,
        bytes: u64,
        backend: &mut dyn Backend,
    ) -> Result<Buffer, BackendError> {
        let label = label.into();
        if let Some(buffer) = self.buffers.get(&label) {
            if backend.bytes(buffer)? == bytes {
                backend.clear(buffer)?;
                return Ok(buffer.clone());
            }
            self.buffers.remove(&label);
        }
        let buffer = backend.create(label.0, Contents::Zeros(bytes))?;
        self.buffers.insert(label, buffer.clone());
        Ok(buffer)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_memo_computes_once_for_a_key() {
        let mut memo = Memo::default();
        let mut made = 0;
        let mut get = |key: u32| {
            *memo.of(key, || {
                made += 1;
                10 * key
            })
        };
        assert_eq!([get(1), get(1), get(2), get(1)], [10, 10, 20, 10]);
        assert_eq!(made, 3);
    }

    #[test]
    fn a_cache_holds_the_data_of_one_method() {
        let mut cache = Cache::default();
        *cache.of::<u32>() += 3;
        assert_eq!(*cache.of::<u32>(), 3);
        assert_eq!(*cache.of::<String>(), "");
        assert_eq!(*cache.of::<u32>(), 0, "another method was in use");
    }
}
