//! The beams of a light, and the passes that trace them.

use super::list::{List, pitch};
use super::maps::Maps;
use super::split::Split;
use crate::backend::{Backend, BackendError, Buffer};
use crate::method::cache::Scratch;
use vitrum_kernels::abi::beams::{BeamsUniforms, Lattice, Limits, part};
use vitrum_kernels::abi::record::{beam, bundle, pencil};
use vitrum_kernels::abi::voxels::STEPS;
use vitrum_kernels::beams::tree::{ROW, rows};
use vitrum_kernels::kernel::kernels;

/// Nodes of a tree on a straight piece of a ray, several times as many as usual.
const NODES: u32 = 8 * STEPS as u32;

/// The bodies as rays run through them.
pub(super) struct Bodies {
    pub(super) nodes: Buffer,
    pub(super) corners: Buffer,
    pub(super) materials: Buffer,
    pub(super) looks: Buffer,
}

/// The beams of a lattice of rays, in rounds: the first one has the shadow.
pub(super) struct Lit {
    pub(super) lattice: Lattice,
    pub(super) pencils: Buffer,
    pub(super) beams: Buffer,
    pub(super) bundles: Buffer,
    pub(super) limits: Limits,
    /// The maps that light is traced by, and the nodes of the tree that they are made from; none if light goes through triangles.
    pub(super) maps: Option<(Maps, u32)>,
    /// Whether beams go once all are traced.
    pub(super) loses_beams: bool,
}

impl Lit {
    /// Buffers for the beams of a lattice, number `number` of the frame's.
    pub(super) fn new(
        lattice: Lattice,
        rounds: u32,
        limits: Limits,
        number: usize,
        scratch: &mut Scratch,
        backend: &mut dyn Backend,
    ) -> Result<Self, BackendError> {
        let texels = [lattice.count; 2];
        let [beams, bundles] = [pitch(texels, beam::SIZE), pitch(Self::tree(&lattice), bundle::SIZE)];
        let mut zeros = |label, words: u64| scratch.zeros((label, number), words * 4, backend);
        Ok(Self {
            lattice,
            pencils: zeros("pencils of light", u64::from(lattice.count).pow(2) * pencil::SIZE as u64)?,
            beams: zeros("beams", beams * u64::from(rounds))?,
            bundles: zeros("bundles of beams", bundles * u64::from(rounds))?,
            limits: Limits { pitch: beams as u32, bundle_pitch: bundles as u32, last: rounds - 1, ..limits },
            maps: None,
            loses_beams: false,
        })
    }

    /// Rows of the nodes of a round's tree.
    fn tree(lattice: &Lattice) -> [u32; 2] {
        [ROW, rows(lattice.count)]
    }

    /// Lists the passes in which pencils of light become beams, and beams bundles, unless some of them are to go before.
    pub(super) fn trace(&self, list: &mut List, bodies: &Bodies, pictures: &Buffer) {
        self.describe(list);
        let texels = [self.lattice.count; 2];
        if let Some((maps, nodes)) = &self.maps {
            maps.make(list, bodies, *nodes);
        }
        for round in 0..=self.limits.last {
            self.follow(list, bodies, round);
            let mode = if round == 0 { part::SHADOW } else { part::CAUSTIC };
            let start = u64::from(self.limits.pitch) * u64::from(round);
            let stored = [&self.pencils, pictures, &bodies.materials, &self.beams];
            list.add(&kernels::beams_store_beam, texels, (mode, round), &stored, start);
            if !self.loses_beams {
                self.bound(list, round);
            }
        }
    }

    /// Lists the pass in which the beams of a round become bundles.
    pub(super) fn bound(&self, list: &mut List, round: u32) {
        let start = u64::from(self.limits.bundle_pitch) * u64::from(round);
        let bound = [&self.beams, &self.bundles];
        list.add(&kernels::beams_bound_beams, Self::tree(&self.lattice), (0, round), &bound, start);
    }

    /// Lists the passes that follow pencils to the end of the last piece, so that the fate of its light is known. They leave pencils without work: no
    /// other lattice is traced behind them.
    pub(super) fn finish(&self, list: &mut List, bodies: &Bodies) {
        self.describe(list);
        self.follow(list, bodies, self.limits.last + 1);
    }

    /// Lists the passes that follow pencils to the piece of a round.
    fn follow(&self, list: &mut List, bodies: &Bodies, round: u32) {
        if let Some((maps, _)) = &self.maps {
            maps.trace(list, bodies, &self.pencils, round);
            return;
        }
        let traced = [&bodies.nodes, &bodies.corners, &bodies.materials, &self.pencils];
        for _ in 0..passes_of_round(&list.block) {
            list.add(&kernels::beams_trace_light, [self.lattice.count; 2], (0, round), &traced, 0);
        }
    }

    /// Makes the passes that follow read these beams.
    pub(super) fn describe(&self, list: &mut List) {
        list.block.lattice = self.lattice;
        list.block.limits = self.limits;
    }
}

/// The beams of a frame's light.
pub(super) struct Lights {
    /// Those that are drawn and light surfaces.
    pub(super) first: Lit,
    /// Those that are seen behind surfaces.
    pub(super) second: Option<Lit>,
    /// Those that are drawn in place of some of the first ones.
    pub(super) split: Option<Split>,
}

impl Lights {
    /// The beams that are drawn and light surfaces.
    pub(super) fn drawn(&self) -> impl Iterator<Item = &Lit> {
        std::iter::once(&self.first).chain(self.split.as_ref().map(|split| &split.lit))
    }

    /// All light of the frame in as few beams as there are.
    pub(super) fn fewest(&self) -> Vec<&Lit> {
        self.second.as_ref().map_or_else(|| self.drawn().collect(), |second| vec![second])
    }
}

/// The passes in which pencils get to their next piece in air, at most.
pub(super) fn passes_of_round(block: &BeamsUniforms) -> u32 {
    ((block.limits.bounces + 1) * NODES).div_ceil(4 * STEPS as u32)
}
