//! A frame of beams, and what can be read back of it.

use super::lit::{Lights, Lit};
use crate::backend::{Backend, BackendError, Buffer, PassList, ReadBack as _};

/// A frame of beams that is ready to run.
pub struct Frame {
    /// The passes.
    pub passes: PassList,
    /// Viewing rays across and down.
    pub rays: [u32; 2],
    pub(super) film: Buffer,
    pub(super) lights: Option<Lights>,
}

impl Frame {
    /// The pencils of light after the passes have run: planar records as [`pencil`](vitrum_kernels::abi::record::pencil) describes, one for each texel of the lattice. None if no light
    /// casts shadows.
    ///
    /// # Errors
    /// As [`Backend::read`].
    pub fn pencils(&self, backend: &mut dyn Backend) -> Result<Vec<f32>, BackendError> {
        self.lights.as_ref().map_or(Ok(Vec::new()), |lights| backend.read_all(&lights.first.pencils))
    }

    /// The maps of the bodies as the light sees them, after the passes have run: planar records as [`faces`](vitrum_kernels::abi::record::faces) describes,
    /// one for each texel of the lattice. None if no light casts shadows, or goes through triangles.
    ///
    /// # Errors
    /// As [`Backend::read`].
    pub fn maps(&self, backend: &mut dyn Backend) -> Result<Vec<f32>, BackendError> {
        let maps = self.lights.as_ref().and_then(|lights| lights.first.maps.as_ref());
        maps.map_or(Ok(Vec::new()), |(maps, _)| backend.read_all(&maps.faces))
    }

    /// The beams that are drawn after the passes have run, of the light's lattice and of the one whose texels are parts of its split ones.
    /// None if no light casts shadows.
    ///
    /// # Errors
    /// As [`Backend::read`].
    pub fn beams(&self, backend: &mut dyn Backend) -> Result<Vec<Drawn>, BackendError> {
        let of = |lit: &Lit| {
            let records = backend.read_all(&lit.beams)?;
            Ok(Drawn { count: lit.lattice.count, pitch: lit.limits.pitch as usize, records })
        };
        self.lights.iter().flat_map(Lights::drawn).map(of).collect()
    }

    /// Records of [`curved`](vitrum_kernels::abi::record::curved) after the passes have run, one for each texel of the lattice. None if texels are not
    /// split.
    ///
    /// # Errors
    /// As [`Backend::read`].
    pub fn curved(&self, backend: &mut dyn Backend) -> Result<Vec<f32>, BackendError> {
        let split = self.lights.as_ref().and_then(|lights| lights.split.as_ref());
        split.map_or(Ok(Vec::new()), |split| backend.read_all(&split.curved))
    }
}

/// Beams of a lattice.
pub struct Drawn {
    /// Texels along each edge.
    pub count: u32,
    /// Floats from the records of one round to those of the next.
    pub pitch: usize,
    /// Planar records of [`beam`](vitrum_kernels::abi::record::beam), one for each texel, round by round: the first one has the shadow.
    pub records: Vec<f32>,
}
