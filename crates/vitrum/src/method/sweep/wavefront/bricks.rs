//! The bricks of a wavefront's light: the samples around places where something looks at the light, and where they are stored.

use super::frame::Frame;
use glam::DVec3;
use vitrum_kernels::abi::wavefront::{BRICK, BRICKS_TOGETHER, ENTRY, plane_words};

/// The word of a list for a brick that only fills it up: a brick that no grid has.
const NONE: u32 = u32::MAX;

/// The bricks of one of their layers, which has the samples of [`BRICK`] planes.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Layer {
    /// The first word of the list of its bricks.
    pub(super) list: u32,
    /// Number of its bricks, with those that only fill the list up.
    pub(super) bricks: u32,
    /// The first word of its first plane in the buffer of light.
    pub(super) start: u32,
}

/// The bricks of a wavefront's light.
#[derive(Debug, Clone)]
pub(super) struct Bricks {
    /// Bricks across, up and along the light.
    pub(super) counts: [u32; 3],
    /// The buffer of bricks: entries, x fastest, then the lists.
    pub(super) words: Vec<u32>,
    pub(super) layers: Vec<Layer>,
    /// Words of the entries.
    pub(super) entries: usize,
}

/// Which bricks something looks at.
pub(super) struct Looked {
    counts: [usize; 3],
    looked: Vec<bool>,
}

impl Looked {
    /// The bricks of `frame` that have samples around one of the `boxes`, each given by its corners in the world. Sample 0 has the coordinate
    /// `first_sample`.
    pub(super) fn new(frame: &Frame, first_sample: f64, boxes: &[[DVec3; 8]]) -> Self {
        let brick = BRICK as usize;
        let planes = frame.kept() as usize;
        let counts = [frame.cells[0] as usize / brick + 1, frame.cells[1] as usize / brick + 1, planes / brick + 1];
        let mut looked = vec![false; counts.iter().product()];
        for corners in boxes {
            let at = corners.map(|corner| frame.coordinates(corner) - DVec3::new(first_sample, first_sample, 0.0));
            let low = at.iter().copied().fold(DVec3::INFINITY, DVec3::min).to_array();
            let high = at.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max).to_array();
            // A look-up is between a sample and the next one, which may be in the next brick; casts cut off below 0.
            let nearer = low[2] - frame.nearer();
            let first = [low[0], low[1], nearer].map(|x| x.floor() as usize / brick);
            let last: [usize; 3] =
                std::array::from_fn(|axis| ((high[axis].floor() + 1.0) as usize / brick).min(counts[axis] - 1));
            for z in first[2]..=last[2] {
                for y in first[1]..=last[1] {
                    let row = (z * counts[1] + y) * counts[0];
                    if first[0] <= last[0] {
                        looked[row + first[0]..=row + last[0]].fill(true);
                    }
                }
            }
        }
        Self { counts, looked }
    }

    /// Words that the entries take.
    pub(super) fn entries(&self) -> u64 {
        self.looked.len() as u64 * u64::from(ENTRY)
    }

    /// Words that the samples take, with `components` words each.
    pub(super) fn words(&self, components: u32) -> u64 {
        let [across, up, _] = self.counts;
        let layers = self.looked.chunks(across * up);
        layers.map(|layer| u64::from(layer_words(together(layer), components))).sum()
    }

    /// The bricks, stored from word `first` of the buffer of light on.
    pub(super) fn bricks(&self, components: u32, first: u32) -> Bricks {
        let [across, up, _] = self.counts;
        let mut words = vec![0; self.looked.len() * ENTRY as usize];
        let entries = words.len();
        let mut layers = Vec::new();
        let mut start = first;
        for (number, looked) in self.looked.chunks(across * up).enumerate() {
            let bricks = together(looked);
            let list = words.len() as u32;
            for (index, _) in looked.iter().enumerate().filter(|(_, looked)| **looked) {
                let place = words.len() as u32 - list;
                let entry = (number * across * up + index) * ENTRY as usize;
                let of_brick = [start + place * vitrum_kernels::abi::wavefront::LAYER, bricks, place + 1];
                words[entry..][..of_brick.len()].copy_from_slice(&of_brick);
                words.push((index % across) as u32 | ((index / across) as u32) << 16);
            }
            words.resize((list + bricks) as usize, NONE);
            layers.push(Layer { list, bricks, start });
            start += layer_words(bricks, components);
        }
        let counts = self.counts.map(|count| count as u32);
        Bricks { counts, words, layers, entries }
    }
}

/// The number of bricks of a layer, as many as are stored together.
fn together(looked: &[bool]) -> u32 {
    (looked.iter().filter(|looked| **looked).count() as u32).next_multiple_of(BRICKS_TOGETHER)
}

/// Words of a layer: one plane more than a brick has, which it shares with the next layer.
fn layer_words(bricks: u32, components: u32) -> u32 {
    plane_words(bricks, components) * (BRICK + 1)
}
