//! Maps of the bodies as a light sees them, in place of their triangles (`beams.tracer = "depth-map"`; Hu et al. 2010, §5.1).

use super::list::List;
use super::lit::Bodies;
use crate::backend::{Backend, BackendError, Buffer};
use crate::method::cache::Scratch;
use vitrum_kernels::abi::beams::Lattice;
use vitrum_kernels::abi::record::{faces, way};
use vitrum_kernels::abi::voxels::STEPS;
use vitrum_kernels::kernel::kernels;

/// Rounds of beams that maps have: the shadow, and the light that a body refracts or reflects once.
pub(super) const ROUNDS: u32 = 3;

/// The maps of a lattice of rays.
pub(super) struct Maps {
    texels: [u32; 2],
    pub(super) faces: Buffer,
    ways: Buffer,
}

impl Maps {
    /// Buffers for the maps of a lattice, number `number` of the frame's.
    pub(super) fn new(
        lattice: &Lattice,
        number: usize,
        scratch: &mut Scratch,
        backend: &mut dyn Backend,
    ) -> Result<Self, BackendError> {
        let texels = u64::from(lattice.count).pow(2);
        let mut zeros = |label, size: usize| scratch.zeros((label, number), texels * size as u64 * 4, backend);
        Ok(Self {
            texels: [lattice.count; 2],
            faces: zeros("maps of faces", faces::SIZE)?,
            ways: zeros("ways through bodies", way::SIZE)?,
        })
    }

    /// Lists the passes that make the maps, of bodies whose tree has `nodes` nodes.
    pub(super) fn make(&self, list: &mut List, bodies: &Bodies, nodes: u32) {
        let sought = [&bodies.nodes, &bodies.corners, &bodies.materials, &self.faces];
        // The front is looked for, and then the back; ending both are steps, too.
        for _ in 0..(2 * nodes + 2).div_ceil(4 * STEPS as u32) {
            list.add(&kernels::beams_map_faces, self.texels, (0, 0), &sought, 0);
        }
        let refracted = [&self.faces, &bodies.materials, &self.ways];
        list.add(&kernels::beams_refract_maps, self.texels, (0, 0), &refracted, 0);
    }

    /// Lists the pass that takes pencils to the piece of a round.
    pub(super) fn trace(&self, list: &mut List, bodies: &Bodies, pencils: &Buffer, round: u32) {
        let traced = [&self.faces, &self.ways, &bodies.materials, pencils];
        list.add(&kernels::beams_trace_maps, self.texels, (0, round), &traced, 0);
    }
}
