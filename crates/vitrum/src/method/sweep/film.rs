//! The outputs of a sweep, and its light as a picture.

use super::Sweep;
use super::uniforms::SMALLEST_COSINE;
use crate::backend::{Backend, BackendError, Buffer, Pass, PassList};
use crate::film::{Output, PixelFilter, Statistics, rgb, rgba, xyz};
use crate::method::PreparedFrame;
use std::sync::atomic::Ordering;
use vitrum_io::Picture;
use vitrum_kernels::abi::record::{film, status};
use vitrum_kernels::abi::sweep::SweepUniforms;

/// The outputs, by the components of [`film`].
pub(super) const OUTPUTS: &[Output] = &[
    Output::color(rgba!(film::COLOR, film::COVERAGE)),
    Output::mean("opacity", &[("Y", film::OPACITY)], "opacity A of particles and receivers, 0 to 1"),
    Output::mean(
        "transmittance",
        rgb!(film::TRANSMITTANCE),
        "share of light that the filter leaves on the way, RGB, 0 to 1",
    ),
    Output::mean(
        "depth",
        &[("Z", film::DEPTH)],
        "opacity-weighted mean depth from the eye along the viewing direction, world units; 0 where nothing is opaque",
    )
    .filtered(PixelFilter::WeightedBy(film::OPACITY))
    .lengths(),
    Output::directions(
        "direction",
        xyz!(film::DIRECTION),
        "final unit direction of the ray in view space (looking along -z)",
    ),
    Output::central("position", xyz!(film::POSITION), "final position of the ray in view space, world units").vectors(),
    Output::central(
        "status",
        &[("Y", film::STATUS)],
        "0 the ray went through, 1 it became opaque or met a receiver, 2 it turned back, 3 it turned back and was followed",
    ),
    Output::mean(
        "light",
        &[],
        "light of the first light source on the last plane, in the light grid's own texels, RGB",
    ),
];

impl PreparedFrame for Sweep {
    fn passes(&self) -> &PassList {
        &self.passes
    }

    fn rays(&self) -> [u32; 2] {
        self.rays
    }

    fn film(&self) -> &Buffer {
        &self.buffers.film
    }

    fn arrive(&self) {
        if let Some(carried) = &self.carried {
            carried.is_done.store(true, Ordering::Relaxed);
        }
    }

    /// The grid's rows go up, a picture's down.
    fn light(&self, backend: &mut dyn Backend) -> Result<Option<Picture>, BackendError> {
        if !self.request.light {
            return Ok(None);
        }
        let irradiance = self.irradiance(backend)?;
        let [width, height] = self.light_grid.size;
        let texels = width as usize * height as usize;
        let pixels = (0..height as usize)
            .rev()
            .flat_map(|row| (0..width as usize).map(move |column| row * width as usize + column))
            .map(|at| [irradiance[at], irradiance[texels + at], irradiance[2 * texels + at]])
            .collect();
        Ok(Some(Picture::rgb(width, height, pixels)))
    }

    fn plane(&self, pass: &Pass) -> Option<u32> {
        let uniforms: SweepUniforms = bytemuck::pod_read_unaligned(&pass.uniforms);
        let distance = |plane: &u32| (self.planes.depth(*plane) - f64::from(uniforms.step.ahead)).abs();
        (0..self.planes.count).min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }

    fn count(&self, records: &[f32], statistics: &mut Statistics) {
        let rays = records.len() / film::SIZE;
        let fates = &records[film::STATUS * rays..][..rays];
        let terminated = fates.iter().filter(|&&fate| fate == status::TURNED).count() as u64;
        statistics.rays_terminated = Some(statistics.rays_terminated.unwrap_or(0) + terminated);
    }

    fn statistics(&self, _backend: &mut dyn Backend, statistics: &mut Statistics) -> Result<(), BackendError> {
        statistics.planes = Some(self.planes.count);
        statistics.light_texels = Some(self.light_grid.size);
        if let Some(Voxelized { dimensions, open_rows }) = self.voxelized {
            (statistics.voxels, statistics.open_rows) = (Some(dimensions), Some(open_rows));
        }
        Ok(())
    }
}

/// Whether a ray was followed beyond the sweep, as far as its finished record tells: it was followed to no end or until it left the volume, or it goes
/// where no plane takes a ray. One that ended on something without having gone back does not tell.
pub(super) fn is_followed(records: &[f32], ray: usize) -> bool {
    let rays = records.len() / film::SIZE;
    let component = |component: usize| records[component * rays + ray];
    let fate = component(film::STATUS);
    // View space looks along -z.
    let forward = -component(film::DIRECTION + 2);
    fate == status::TURNED || fate == status::LEFT || forward < SMALLEST_COSINE
}

/// The volumes that were made of a mesh.
#[derive(Debug, Clone, Copy)]
pub(super) struct Voxelized {
    /// Voxels along x, y and z.
    pub(super) dimensions: [u32; 3],
    /// Rows of voxels that go through holes of the surface.
    pub(super) open_rows: u64,
}
