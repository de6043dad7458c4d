//! Beams: volume caustics of clear and mirroring bodies in a participating medium (Hu et al. 2010).
//!
//! `density.rs` reads the medium's density, `medium.rs` describes the medium to the kernels (`phase.rs`: its phase function), `lattice.rs`
//! places the rays of a light, `uniforms.rs` describes the rest of a frame. `passes.rs` lists the passes: pencils of light become beams (`lit.rs`, by maps
//! `maps.rs`, split `split.rs`), beams are drawn (`drawing.rs`), cells of the medium exchange light (`exchange.rs`), viewing rays see the rest. `frame.rs` is
//! the frame, `film.rs` its outputs.

mod density;
mod drawing;
mod exchange;
mod film;
mod frame;
mod lattice;
mod list;
mod lit;
mod maps;
mod medium;
mod passes;
mod phase;
mod split;
mod uniforms;

pub use frame::{Drawn, Frame};

use crate::assets::Assets;
use crate::backend::Backend;
use crate::error::Error;
use crate::film::Output;
use crate::method::voxels::cache::FrameCache;
use crate::method::voxels::{self, UploadedMesh};
use crate::method::{Cache, Exposure, Job, Method, PreparedFrame, Tools};
use crate::scene::{MethodName, Scene, Surfaces};
use crate::unrenderable::Unrenderable;
use medium::MediumCache;
use vitrum_kernels::abi::record::{beam, bundle};
use vitrum_kernels::beams::tree::{ROW, rows};

/// Beams of light in a medium.
#[derive(Debug, Clone, Copy)]
pub struct Beams;

/// Data that the next frame of the same assets uses again.
#[derive(Default)]
struct BeamsCache {
    uploaded: Option<UploadedMesh>,
    frame: FrameCache,
    medium: MediumCache,
}

/// The scene of the bodies, as rays run through their triangles: without shadow maps.
fn of_triangles(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    scene.voxels.surfaces = Surfaces::Exact;
    scene.light.iter_mut().for_each(|light| light.shadows = false);
    scene
}

/// A frame of beams of a scene's first light, which is ready to run.
///
/// # Errors
/// Those of [`Method::prepare`].
pub fn prepare(scene: &Scene, assets: &Assets, backend: &mut dyn Backend) -> Result<Frame, Error> {
    let mut tools = Tools { backend, progress: &mut |_| true };
    let uploaded = UploadedMesh::new(&of_triangles(scene), assets, &mut tools)?;
    let mut cache = BeamsCache::default();
    passes::list(scene, assets, &uploaded, &mut cache.frame, &mut cache.medium, tools.backend)
}

/// Checks that kernels can address the beams of a light, the trees over them, and the optical depths along them: they count words by a signed number.
///
/// # Errors
/// [`Unrenderable::TooManyBeams`].
fn check_size(scene: &Scene) -> Result<(), Error> {
    let (rays, segments, adaptive) = (scene.beams.rays, scene.beams.segments, scene.beams.adaptive);
    // Split texels have a lattice of their own, with four texels for each.
    let finest = if adaptive { 2 * rays } else { rays };
    let texels = u64::from(finest) * u64::from(finest);
    let beams = texels * beam::SIZE as u64;
    let tree = u64::from(rows(finest) * ROW) * bundle::SIZE as u64;
    let varying = scene.medium.as_ref().is_some_and(|medium| medium.density.is_some());
    // The optical depths of both lattices are in one buffer.
    let all = if adaptive { texels + texels / 4 } else { texels };
    let depths = if varying { all * u64::from(scene.beams.nodes) } else { 0 };
    // The shadow is a round of its own.
    let words = beams.max(tree).max(depths) * u64::from(segments + 1);
    if words <= i32::MAX as u64 {
        return Ok(());
    }
    Err(Unrenderable::TooManyBeams { rays, segments, adaptive, bytes: words * 4 }.into())
}

impl Method for Beams {
    fn name(&self) -> MethodName {
        MethodName::Beams
    }

    fn outputs(&self) -> &'static [Output] {
        film::OUTPUTS
    }

    fn check(&self, scene: &Scene, assets: &Assets) -> Result<(), Error> {
        check_size(scene)?;
        voxels::check(scene, assets, self.name())?;
        density::check(scene, assets)
    }

    fn exposures(&self, scene: &Scene, assets: &Assets) -> Vec<Exposure> {
        voxels::exposures(scene, assets, scene.beams.wavelengths)
    }

    fn prepare(
        &self,
        job: &Job<'_>,
        cache: &mut Cache,
        tools: &mut Tools<'_>,
    ) -> Result<Box<dyn PreparedFrame>, Error> {
        let Job { scene, assets, .. } = *job;
        let exact = of_triangles(scene);
        let cache: &mut BeamsCache = cache.of();
        if let Some(last) = cache.uploaded.take() {
            cache.uploaded = last.followed(&exact, assets, tools)?;
        }
        if cache.uploaded.is_none() {
            *cache = BeamsCache::default();
        }
        let BeamsCache { uploaded, frame, medium } = cache;
        let uploaded = match uploaded {
            Some(uploaded) => uploaded,
            None => uploaded.insert(UploadedMesh::new(&exact, assets, tools)?),
        };
        Ok(Box::new(passes::list(scene, assets, uploaded, frame, medium, tools.backend)?))
    }
}
