//! The outputs of rays through a mesh.

use super::passes::Rays;
use crate::backend::{Backend, BackendError, Buffer, PassList};
use crate::film::{Output, PixelFilter, Statistics, rgb, rgba, xyz};
use crate::method::PreparedFrame;
use vitrum_kernels::abi::record::{fate, view};

/// The outputs, by the components of [`view`].
pub(super) const OUTPUTS: &[Output] = &[
    Output::color(rgba!(view::COLOR, view::COVERAGE)),
    Output::mean(
        "depth",
        &[("Z", view::DEPTH)],
        "depth of the first surface along the viewing direction, world units; 0 where there is none",
    )
    .filtered(PixelFilter::Present)
    .lengths(),
    Output::directions(
        "direction",
        xyz!(view::DIRECTION),
        "final unit direction of the ray in view space (looking along -z)",
    ),
    Output::directions(
        "normal",
        xyz!(view::NORMAL),
        "unit normal at the first surface in view space, 0 where there is none",
    ),
    Output::central("bounces", &[("Y", view::BOUNCES)], "surfaces at which the ray was refracted or reflected"),
    Output::mean("path_length", &[("Y", view::LENGTH)], "length of the ray's way inside the mesh, world units")
        .lengths(),
    Output::mean(
        "transmittance",
        rgb!(view::TRANSMITTANCE),
        "transmittance along the ray: the share of light that absorption and reflection leave, RGB, 0 to 1",
    ),
    Output::mean(
        "reflectance",
        &[("Y", view::REFLECTANCE)],
        "share of the light that the first surface reflects, 0 to 1",
    ),
    Output::central(
        "status",
        &[("Y", view::STATUS)],
        "1 the ray left, 2 it was still inside, 3 it met an opaque body or a receiver",
    ),
];

impl PreparedFrame for Rays {
    fn passes(&self) -> &PassList {
        &self.passes
    }

    fn rays(&self) -> [u32; 2] {
        self.rays
    }

    fn film(&self) -> &Buffer {
        &self.film
    }

    fn run(
        &self,
        backend: &mut dyn Backend,
        progress: &mut (dyn FnMut(u64, u64) -> bool + Send),
    ) -> Result<(), BackendError> {
        let total = self.passes.passes.len() as u64;
        Self::run(self, backend, &mut |done| progress(done as u64, total))
    }

    fn count(&self, film: &[f32], statistics: &mut Statistics) {
        let rays = film.len() / view::SIZE;
        let fates = &film[view::STATUS * rays..][..rays];
        let trapped = fates.iter().filter(|&&status| status == fate::TRAPPED).count() as u64;
        statistics.rays_trapped = Some(statistics.rays_trapped.unwrap_or(0) + trapped);
    }

    fn statistics(&self, _backend: &mut dyn Backend, statistics: &mut Statistics) -> Result<(), BackendError> {
        statistics.voxels = self.voxels;
        statistics.open_rows = self.voxels.map(|_| self.open_rows);
        Ok(())
    }
}
