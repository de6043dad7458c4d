//! The passes that split texels of the light's lattice where curvature shows in the picture (`beams.adaptive`).

use super::lattice::finer;
use super::list::List;
use super::lit::{Bodies, Lit};
use crate::backend::{Backend, BackendError, Buffer};
use crate::method::cache::Scratch;
use vitrum_kernels::abi::beams::Limits;
use vitrum_kernels::abi::record::curved;
use vitrum_kernels::kernel::kernels;

/// The beams of the texels that are split: those of a lattice with twice as many texels along each edge, most of which have none.
pub(super) struct Split {
    pub(super) lit: Lit,
    pub(super) curved: Buffer,
}

impl Split {
    /// Buffers for the split texels of a lattice, which is to lose their beams; `number` is that of their own lattice among the frame's.
    pub(super) fn new(
        whole: &mut Lit,
        limits: Limits,
        number: usize,
        scratch: &mut Scratch,
        backend: &mut dyn Backend,
    ) -> Result<Self, BackendError> {
        whole.loses_beams = true;
        let words = u64::from(whole.lattice.count).pow(2) * curved::SIZE as u64;
        Ok(Self {
            lit: Lit::new(finer(whole.lattice), whole.limits.last + 1, limits, number, scratch, backend)?,
            curved: scratch.zeros("curved texels", words * 4, backend)?,
        })
    }

    /// Lists the passes in which curved texels of a lattice are found, split, and lose their own beams. Behind them each texel's light is that of its own
    /// beams, or of the beams of the four texels in its place.
    pub(super) fn trace(&self, list: &mut List, whole: &Lit, bodies: &Bodies, pictures: &Buffer) {
        let texels = [whole.lattice.count; 2];
        whole.describe(list);
        // The first round is the shadow, whose beams go straight on.
        for round in 1..=whole.limits.last {
            list.add(&kernels::beams_find_curved, texels, (0, round), &[&whole.beams, &self.curved], 0);
        }
        for round in 0..=whole.limits.last {
            let start = u64::from(whole.limits.pitch) * u64::from(round);
            list.add(&kernels::beams_drop_beam, texels, (0, round), &[&self.curved, &whole.beams], start);
            whole.bound(list, round);
        }
        self.lit.describe(list);
        let finer = [self.lit.lattice.count; 2];
        list.add(&kernels::beams_split_texels, finer, (0, 0), &[&self.curved, &whole.beams, &self.lit.pencils], 0);
        self.lit.trace(list, bodies, pictures);
    }
}
