//! Rays through a mesh (Chang et al. 2010): through the voxels of clear materials (§4), or for comparison through their triangles, to
//! opaque triangles and receivers in the light that the mesh lets through (§3).
//!
//! [`UploadedMesh::new`] turns a mesh into what rays run through and the shadow that it casts; [`Rays::prepare`] lists the passes of a
//! frame; [`Rays::run`] hands them to the backend; [`Rays::film`] reads what came out.

pub(in crate::method) mod bodies;
mod bricks;
pub(in crate::method) mod cache;
mod cropped;
mod distances;
mod fields;
mod film;
pub(in crate::method) mod light;
pub(in crate::method) mod looks;
mod normals;
mod passes;
mod received;
mod refit;
pub(in crate::method) mod shadow;
pub(in crate::method) mod solids;
mod tree;
pub(in crate::method) mod uniforms;
pub(in crate::method) mod uploaded;

pub use bodies::{Body, bodies};
pub(crate) use looks::GREY;
pub use passes::Rays;
pub use uploaded::UploadedMesh;

use crate::assets::Assets;
use crate::error::Error;
use crate::film::Output;
use crate::method::{Bounds, Cache, Exposure, Job, Method, PreparedFrame, Tools, lights, spectrum};
use crate::scene::{MethodName, Scene};
use cache::MeshCache;

/// Rays through a mesh.
#[derive(Debug, Clone, Copy)]
pub struct MeshRays;

/// Checks that `method` can show a scene's mesh in its lights.
///
/// # Errors
/// Where the subject is a volume, the mesh has no surface, or [`light::check`] or the scene's checks for meshes fail.
pub(in crate::method) fn check(scene: &Scene, assets: &Assets, method: MethodName) -> Result<(), Error> {
    let mesh = uploaded::shown(assets, method)?;
    scene.check_for_mesh()?;
    crate::method::surface::check_mesh(mesh)?;
    light::check(scene, assets, mesh)
}

/// The exposures of a scene of meshes: one for each light, or for each of the crisp ones that a soft light is made of, and of each for
/// each of `wavelengths` wavelengths where the mesh's bodies disperse.
pub(in crate::method) fn exposures(scene: &Scene, assets: &Assets, wavelengths: u32) -> Vec<Exposure> {
    let lights = lights::crisp_exposures(scene, assets.environment.as_deref(), Bounds::from(&assets.subject));
    let disperse = assets.subject.mesh().is_some_and(|mesh| bodies::disperse(mesh, &scene.material));
    spectrum::split(lights, disperse.then_some(wavelengths))
}

impl Method for MeshRays {
    fn name(&self) -> MethodName {
        MethodName::Voxels
    }

    fn outputs(&self) -> &'static [Output] {
        film::OUTPUTS
    }

    fn check(&self, scene: &Scene, assets: &Assets) -> Result<(), Error> {
        check(scene, assets, self.name())
    }

    fn exposures(&self, scene: &Scene, assets: &Assets) -> Vec<Exposure> {
        exposures(scene, assets, scene.voxels.wavelengths)
    }

    fn prepare(
        &self,
        job: &Job<'_>,
        cache: &mut Cache,
        tools: &mut Tools<'_>,
    ) -> Result<Box<dyn PreparedFrame>, Error> {
        let Job { scene, assets, .. } = *job;
        let cache: &mut MeshCache = cache.of();
        if let Some(last) = cache.uploaded.take() {
            cache.uploaded = last.followed(scene, assets, tools)?;
        }
        if cache.uploaded.is_none() {
            // Light through the bodies' volumes knows by itself what they are made of.
            *cache = MeshCache { caustics: std::mem::take(&mut cache.caustics), ..MeshCache::default() };
        }
        let MeshCache { uploaded, caustics, frame } = cache;
        let uploaded = match uploaded {
            Some(uploaded) => uploaded,
            None => uploaded.insert(UploadedMesh::unlit(scene, assets, tools)?),
        };
        let refracted = if received::has_caustics(scene, uploaded::shown(assets, self.name())?, &uploaded.bodies) {
            caustics.of(scene, assets, tools)?
        } else {
            None
        };
        uploaded.light(scene, assets, refracted, tools)?;
        Ok(Box::new(passes::list(scene, assets, uploaded, frame, tools.backend)?))
    }
}
