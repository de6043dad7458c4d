//! Data that methods keep from frame to frame, on the host and on the backend.

use crate::assets::Assets;
use crate::backend::{Backend, BackendError, Buffer, Contents};
use crate::error::Error;
use crate::framing::{self, PointsKey};
use crate::preset::{self, Noise};
use crate::scene::Scene;
use crate::shown::{Changes, Fineness, on_finer};
use crate::subject::Subject;
use glam::DVec3;
use std::any::{Any, TypeId};
use std::collections::HashMap;
use std::convert::Infallible;

/// Data that the methods of a renderer keep from frame to frame: for each method one value of a type of its own.
///
/// All of it belongs to one backend and to one set of assets; a renderer makes a new cache for others.
#[derive(Default)]
pub struct Cache {
    entries: HashMap<TypeId, Box<dyn Any + Send>>,
    noise: Memo<(), Option<Noise>>,
    /// The range of the shown volume without outliers.
    range: Memo<(), [f32; 2]>,
    shown: Memo<Changes, Option<Subject>>,
    points: Memo<(Changes, PointsKey), Vec<DVec3>>,
    finer: Memo<(Changes, Fineness), Subject>,
}

impl Cache {
    /// The value of type `T`. Data of another type, of a method that is no longer used, is dropped.
    pub fn of<T: Any + Default + Send>(&mut self) -> &mut T {
        self.entries.retain(|id, _| *id == TypeId::of::<T>());
        let entry = self.entries.entry(TypeId::of::<T>()).or_insert_with(|| Box::new(T::default()));
        let Some(value) = entry.downcast_mut() else { unreachable!("values are stored by their types") };
        value
    }

    /// The data that a scene's picture is made of, where that is not `assets` as they were read; data of other volumes is dropped.
    ///
    /// # Errors
    /// Where the memory does not suffice.
    pub(crate) fn shown(&mut self, scene: &Scene, assets: &Assets) -> Result<Option<Assets>, Error> {
        let Some(volumes) = assets.subject.volumes() else { return Ok(None) };
        let noise = || *self.noise.of((), || preset::noise(volumes.bending()));
        let range = || *self.range.of((), || volumes.shown.common_range());
        let changes = Changes::of(scene, (volumes, assets.bodies.is_some()), noise, range);
        if !self.shown.is_of(&changes) {
            self.entries.clear();
            self.finer = Memo::default();
        }
        let subject = self.shown.get(changes.clone(), || changes.made(assets))?;
        Ok(subject.clone().map(|subject| Assets { subject, ..assets.clone() }))
    }

    /// The scene and its data on a finer grid, where its interpolation is cubic; `assets` are those that [`Self::shown`] has given. Data of other grids is
    /// dropped.
    ///
    /// # Errors
    /// Where the values are labels, or the memory does not suffice.
    pub(crate) fn finer(&mut self, scene: &Scene, assets: &Assets) -> Result<Option<(Scene, Assets)>, Error> {
        let fineness = assets.subject.volumes().and_then(|volumes| Fineness::of(scene, volumes));
        let (Some(fineness), Some(volume)) = (fineness, assets.subject.volume()) else {
            if self.finer.key().is_some() {
                self.entries.clear();
                self.finer = Memo::default();
            }
            return Ok(None);
        };
        let key = (self.shown.key().unwrap_or_default(), fineness);
        if !self.finer.is_of(&key) {
            self.entries.clear();
        }
        let subject = self.finer.get(key, || fineness.made(&assets.subject))?.clone();
        Ok(Some((on_finer(scene, volume), Assets { subject, ..assets.clone() })))
    }

    /// The scene with the camera that its picture is taken with, where that is another; `assets` are those that [`Self::shown`] has given.
    pub(crate) fn framed(&mut self, scene: &Scene, assets: &Assets) -> Option<Scene> {
        if !framing::is_fitted(scene) {
            return None;
        }
        // A mesh may move.
        if assets.subject.mesh().is_some() {
            return framing::around(scene, assets, &framing::points(scene, &assets.subject));
        }
        let changes = self.shown.key().unwrap_or_default();
        let key = (changes, framing::points_key(scene));
        let points = self.points.of(key, || framing::points(scene, &assets.subject));
        if assets.bodies.is_some() {
            // Bodies may move.
            return framing::around(scene, assets, &[&points[..], &framing::of_bodies(assets)].concat());
        }
        framing::around(scene, assets, points)
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
    /// Whether the stored value belongs to `key`.
    fn is_of(&self, key: &K) -> bool {
        self.0.as_ref().is_some_and(|(known, _)| known == key)
    }

    /// The key of the stored value.
    fn key(&self) -> Option<K>
    where
        K: Clone,
    {
        self.0.as_ref().map(|(key, _)| key.clone())
    }

    /// The value for `key`: the stored one if it belongs to the same key, else a new one that `make` computes and the memo stores.
    ///
    /// # Errors
    /// Those of `make`.
    pub(in crate::method) fn get<E>(&mut self, key: K, make: impl FnOnce() -> Result<V, E>) -> Result<&V, E> {
        if !self.is_of(&key) {
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
