//! Light that stays on the device from frame to frame, while the camera alone moves.

use super::tables::TablesKey;
use super::wavefront::{LightKey, Wavefront, WavefrontBuffers};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The most bytes of light that is kept, unless one light alone has more.
const MOST_BYTES: u64 = 512 << 20;

/// A wavefront and its buffers.
pub(super) struct Carried {
    pub(super) wavefront: Wavefront,
    pub(super) buffers: WavefrontBuffers,
    /// Whether its passes have run to the end: a frame may be cancelled on the way.
    pub(super) is_done: AtomicBool,
}

/// All that a light depends on, besides the volumes.
pub(super) type Key = (TablesKey, LightKey);

/// The light of several sources, in the order in which it was carried.
#[derive(Default)]
pub(super) struct KeptLight {
    lights: Vec<(Key, Arc<Carried>)>,
}

impl KeptLight {
    /// The light of that key; where its nodes are needed, too, only if no other light has been carried since.
    pub(super) fn find(&mut self, key: Option<&Key>, nodes: bool) -> Option<Arc<Carried>> {
        // Light of a frame that was cancelled has not arrived.
        self.lights.retain(|(_, carried)| carried.is_done.load(Ordering::Relaxed));
        let at = self.lights.iter().position(|(known, _)| Some(known) == key)?;
        let is_last = at + 1 == self.lights.len();
        (is_last || !nodes).then(|| Arc::clone(&self.lights[at].1))
    }

    /// Makes room for light of so many bytes: lights that were carried first go first.
    pub(super) fn make_room(&mut self, bytes: u64) {
        let mut total = bytes + self.lights.iter().map(|(_, carried)| carried.wavefront.bytes()).sum::<u64>();
        self.lights.retain(|(_, carried)| {
            let stays = total <= MOST_BYTES;
            total -= if stays { 0 } else { carried.wavefront.bytes() };
            stays
        });
    }

    /// Keeps the light of that key, in place of what it was.
    pub(super) fn keep(&mut self, key: Key, carried: Arc<Carried>) {
        self.lights.retain(|(known, _)| *known != key);
        self.lights.push((key, carried));
    }
}
