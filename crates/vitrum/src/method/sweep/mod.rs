//! The plane sweep (Magnus & Bruckner 2017): refraction, coloured transmission, soft shadows and caustics in scalar volumes.
//!
//! [`Sweep::prepare`] turns a scene into tables, buffers and a pass list; [`Sweep::run`] hands the list to the backend;
//! [`Sweep::film`] and [`Sweep::irradiance`] read what came out.

pub(crate) mod blend;
mod carrier;
pub(crate) mod film;
mod hull;
mod kept;
mod light;
mod occupancy;
mod paging;
mod passes;
mod planes;
mod sheets;
mod sources;
pub mod spectrum;
mod tables;
mod texels;
mod uniforms;
mod unoccluded;
mod uploaded;
mod voxels;
mod window;

pub use crate::method::view::View;
pub use light::LightGrid;
pub use planes::Planes;
pub use tables::Tables;
pub use uniforms::check;
pub use uploaded::Uploaded;

use crate::backend::{Backend, BackendError, Buffer, PassList};
use crate::error::Error;
use crate::inputs::Inputs;
use crate::request::Wanted;
use crate::scene::Scene;
use kept::Kept;
use uniforms::Fixed;

/// A frame that is ready to run.
pub struct Sweep {
    /// The passes.
    pub passes: PassList,
    /// The planes.
    pub planes: Planes,
    /// The light grid.
    pub light_grid: LightGrid,
    /// Rays across and down.
    pub rays: [u32; 2],
    buffers: Buffers,
    kept: Kept,
    /// The irradiance of unoccluded light.
    unoccluded: [f32; 3],
}

/// The buffers of a frame.
struct Buffers {
    irradiance: Buffer,
    film: Buffer,
}

impl Sweep {
    /// Uploads the volumes, builds tables and lists the passes.
    ///
    /// # Errors
    /// [`Error::Scene`] where what is seen and lit makes no frame, [`Error::Backend`] where the backend lacks the memory or fails.
    pub fn prepare(scene: &Scene, inputs: &Inputs, wanted: Wanted, backend: &mut dyn Backend) -> Result<Self, Error> {
        let uploaded = Uploaded::new(inputs, backend)?;
        Self::prepare_uploaded(scene, inputs, &uploaded, wanted, backend)
    }

    /// As [`Self::prepare`], with the volumes streamed in as little memory as that takes, however small they are: what large volumes come
    /// to by themselves.
    ///
    /// # Errors
    /// As [`Self::prepare`].
    pub fn prepare_streamed(
        scene: &Scene,
        inputs: &Inputs,
        wanted: Wanted,
        backend: &mut dyn Backend,
    ) -> Result<Self, Error> {
        Self::prepare_uploaded(scene, inputs, &Uploaded::streamed(inputs), wanted, backend)
    }

    /// Builds tables and lists the passes for volumes that are on the backend already. They stay there when the frame is freed. Where
    /// the light is not wanted, it is only carried as far as a viewing ray can see it, and [`Self::irradiance`] gives what is left of it.
    ///
    /// # Errors
    /// As [`Self::prepare`].
    pub fn prepare_uploaded(
        scene: &Scene,
        inputs: &Inputs,
        uploaded: &Uploaded,
        wanted: Wanted,
        backend: &mut dyn Backend,
    ) -> Result<Self, Error> {
        let fixed = Fixed::new(scene, inputs, uploaded.format, backend.largest_buffer())?;
        let (passes, buffers) = passes::build(inputs, &fixed, uploaded, wanted, backend)?;
        Ok(Self {
            passes,
            planes: fixed.planes,
            light_grid: fixed.light_grid,
            rays: fixed.rays,
            buffers,
            kept: fixed.kept(),
            unoccluded: fixed.unoccluded_irradiance(),
        })
    }

    /// Runs all passes; `progress` gets the planes that are done and returns whether to go on.
    ///
    /// # Errors
    /// As [`Backend::run`].
    pub fn run(&self, backend: &mut dyn Backend, progress: &mut dyn FnMut(u32) -> bool) -> Result<(), BackendError> {
        let total = self.passes.passes.len().max(1);
        let planes = self.planes.count;
        backend.run(&self.passes, &mut |done| progress((done as u64 * u64::from(planes) / total as u64) as u32))
    }

    /// The finished pixels: planar records as [`film`](vitrum_kernels::abi::record::film) describes, for `rays` pixels.
    ///
    /// # Errors
    /// As [`Backend::read`].
    pub fn film(&self, backend: &mut dyn Backend) -> Result<Vec<f32>, BackendError> {
        backend.read_all(&self.buffers.film)
    }

    /// The light on the last plane: red, then green, then blue plane irradiance for the light grid's texels (radiance if
    /// `sweep.intensity` is not `jacobian`).
    ///
    /// # Errors
    /// As [`Backend::read`].
    pub fn irradiance(&self, backend: &mut dyn Backend) -> Result<Vec<f32>, BackendError> {
        self.irradiance_on(self.planes.count - 1, backend)
    }

    /// As [`Self::irradiance`], on plane `plane`, until light is carried a few planes further.
    ///
    /// # Errors
    /// As [`Backend::read`].
    pub fn irradiance_on(&self, plane: u32, backend: &mut dyn Backend) -> Result<Vec<f32>, BackendError> {
        let texels = self.light_grid.size[0] as usize * self.light_grid.size[1] as usize;
        let bytes = (self.unoccluded.len() * texels * 4) as u64;
        let start = self.kept.start(plane) * 4;
        let mut shares: Vec<f32> = backend.read_part(&self.buffers.irradiance, start..start + bytes)?;
        for (channel, unoccluded) in shares.chunks_exact_mut(texels).zip(self.unoccluded) {
            channel.iter_mut().for_each(|share| *share *= unoccluded);
        }
        Ok(shares)
    }
}
