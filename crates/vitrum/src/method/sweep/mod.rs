//! The plane sweep (Magnus & Bruckner 2017): refraction, coloured transmission, soft shadows and caustics in scalar volumes.
//!
//! [`Sweep::prepare`] turns a scene into tables, buffers and a pass list; [`Sweep::run`] hands the list to the backend;
//! [`Sweep::film`] and [`Sweep::irradiance`] read what came out.

mod bodies;
mod cache;
mod carrier;
pub(in crate::method) mod caustics;
mod crop;
mod film;
mod hull;
mod irradiance_ring;
mod kept;
mod light;
mod mesh_volumes;
mod occupancy;
mod paging;
mod passes;
mod planes;
mod projection;
mod tables;
mod texels;
mod transfer;
mod uniforms;
mod unoccluded;
mod uploaded;
mod voxels;
mod wavefront;
mod window;

pub use light::LightGrid;
pub use planes::Planes;
pub use tables::Tables;

use crate::assets::Assets;
use crate::backend::{Backend, BackendError, Buffer, PassList, ReadBack as _};
use crate::error::Error;
use crate::film::Output;
use crate::method::{Bounds, Cache, ChosenRays, Exposure, Job, Method, PreparedFrame, Tools, View, lights, spectrum};
use crate::request::OutputRequest;
use crate::scene::{MethodName, Scene, Transport};
use crate::subject::{Subject, Volumes};
use crate::unrenderable::Unrenderable;
use cache::{FrameCache, SweepCache};
use film::Voxelized;
use irradiance_ring::IrradianceRing;
use kept::Carried;
use projection::as_shown;
use std::collections::BTreeMap;
use std::sync::Arc;
use uniforms::FramePlan;
use uploaded::UploadedVolumes;

/// The plane sweep.
#[derive(Debug, Clone, Copy)]
pub struct PlaneSweep;

impl Method for PlaneSweep {
    fn name(&self) -> MethodName {
        MethodName::Sweep
    }

    fn outputs(&self) -> &'static [Output] {
        film::OUTPUTS
    }

    fn check(&self, scene: &Scene, assets: &Assets) -> Result<(), Error> {
        match &assets.subject {
            Subject::Mesh(mesh) => {
                scene.check_for_mesh()?;
                crate::method::surface::check_mesh(mesh)?;
                light::check(scene, Bounds::from(&**mesh), assets.environment.as_deref())
            }
            Subject::Volume(_) | Subject::Volumes { .. } => {
                let Some(volumes) = assets.subject.volumes() else { return Ok(()) };
                bodies::check(scene, volumes, assets)?;
                uniforms::check(&as_shown(scene), volumes, assets.environment.as_deref())
            }
        }
    }

    /// One exposure for each light, and of each for each wavelength where indices of refraction depend on it.
    fn exposures(&self, scene: &Scene, assets: &Assets) -> Vec<Exposure> {
        let scene = &*as_shown(scene);
        let disperses = assets
            .subject
            .mesh()
            .map_or(scene.transfer.disperses(), |mesh| crate::method::voxels::bodies::disperse(mesh, &scene.material));
        let wavelengths = (scene.sweep.refraction && disperses).then_some(scene.sweep.wavelengths);
        let bounds = Bounds::from(&assets.subject);
        spectrum::split(lights::sweep_exposures(scene, assets.environment.as_deref(), bounds), wavelengths)
    }

    fn refines(&self) -> bool {
        true
    }

    /// Light on texels moves with the camera's planes, and would be carried for each part.
    fn divides(&self, scene: &Scene) -> bool {
        as_shown(scene).sweep.light == Transport::Forward
    }

    fn is_costly(&self, records: &[f32], ray: usize) -> bool {
        film::is_followed(records, ray)
    }

    fn prepare(
        &self,
        job: &Job<'_>,
        cache: &mut Cache,
        tools: &mut Tools<'_>,
    ) -> Result<Box<dyn PreparedFrame>, Error> {
        let Job { scene, assets, request, chosen } = *job;
        let cache: &mut SweepCache = cache.of();
        let map = assets.environment.as_deref();
        if let Some(volumes) = assets.subject.volumes() {
            cache.bodies(scene, volumes.shown, assets, tools)?;
            let SweepCache { bodies, frame, .. } = cache;
            let Some(bodies) = bodies else {
                return Ok(Box::new(Sweep::of(scene, volumes, map, (request, chosen), frame, tools.backend)?));
            };
            let voxelized = Some(Voxelized { dimensions: bodies.dimensions(), open_rows: bodies.open_rows });
            let (scene, volumes) = (bodies.scene(scene), bodies.volumes(volumes));
            let sweep = Sweep::of(&scene, volumes, map, (request, chosen), frame, tools.backend)?;
            return Ok(Box::new(Sweep { voxelized, ..sweep }));
        }
        cache.mesh(scene, assets, tools)?;
        let SweepCache { mesh: Some(mesh), frame, .. } = cache else { unreachable!("it was made above") };
        let (scene, volumes) = (mesh.scene(scene, assets)?, mesh.volumes());
        let voxelized = Some(Voxelized { dimensions: volumes.shown.dimensions, open_rows: mesh.open_rows });
        let sweep = Sweep::of(&scene, volumes, map, (request, chosen), frame, tools.backend)?;
        Ok(Box::new(Sweep { voxelized, ..sweep }))
    }
}

/// A sweep that is ready to run. Its buffers are freed when it is dropped.
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
    /// The wavefront that carries the light forward, if one does.
    carried: Option<Arc<Carried>>,
    ring: IrradianceRing,
    /// The irradiance of unoccluded light.
    unoccluded: [f32; 3],
    request: OutputRequest,
    /// The volumes that were made of a mesh, if the subject is one, or has bodies within it.
    voxelized: Option<Voxelized>,
}

/// The buffers of a frame that are read.
struct Buffers {
    irradiance: Buffer,
    film: Buffer,
}

impl Sweep {
    /// Uploads the volumes of `assets`, builds tables and lists the passes.
    ///
    /// # Errors
    /// [`Error::Unrenderable`] where the subject is a mesh or the scene's values together make no frame, [`Error::Backend`] where the backend
    /// lacks the memory or fails.
    pub fn prepare(
        scene: &Scene,
        assets: &Assets,
        request: OutputRequest,
        backend: &mut dyn Backend,
    ) -> Result<Self, Error> {
        let map = assets.environment.as_deref();
        Self::of(scene, volumes(assets)?, map, (request, None), &mut FrameCache::default(), backend)
    }

    /// As [`Self::prepare`], with the volumes streamed in as little memory as that takes, however small they are: large volumes are
    /// streamed by themselves.
    ///
    /// # Errors
    /// As [`Self::prepare`].
    pub fn prepare_streamed(
        scene: &Scene,
        assets: &Assets,
        request: OutputRequest,
        backend: &mut dyn Backend,
    ) -> Result<Self, Error> {
        let volumes = volumes(assets)?;
        let mut cache = FrameCache::holding(Arc::new(UploadedVolumes::streamed(volumes)?));
        Self::of(scene, volumes, assets.environment.as_deref(), (request, None), &mut cache, backend)
    }

    /// Builds tables and lists the passes. Where the light is not requested, it is carried only as far as a viewing ray can read it,
    /// and [`Self::irradiance`] gives the irradiance of that region.
    fn of(
        scene: &Scene,
        volumes: Volumes<'_>,
        picture: Option<&vitrum_io::Picture>,
        (request, chosen): (OutputRequest, Option<ChosenRays<'_>>),
        cache: &mut FrameCache,
        backend: &mut dyn Backend,
    ) -> Result<Self, Error> {
        let scene = &*as_shown(scene);
        let uploaded = cache.uploaded(volumes, backend)?;
        let tables = cache.tables(scene, volumes);
        let pictures = cache.pictures.get(scene, picture, &BTreeMap::new(), backend)?;
        let limits = (uploaded.format, backend.largest_buffer());
        let mut plan = FramePlan::new(scene, volumes, tables, &pictures.environment, limits)?;
        if let Some(chosen) = chosen {
            plan.choose(chosen);
        }
        let (passes, buffers, carried) =
            passes::build(scene, volumes, &mut plan, (&uploaded, &pictures.buffer), (request, chosen), cache, backend)?;
        Ok(Self {
            passes,
            planes: plan.planes,
            // Cells may have grown until their light fitted the memory.
            light_grid: carried.as_ref().map_or(plan.light_grid, |carried| {
                LightGrid::of_frame(&carried.wavefront.frame, plan.light_grid.direction)
            }),
            rays: plan.rays,
            buffers,
            carried,
            ring: plan.ring(),
            unoccluded: plan.unoccluded_irradiance(),
            request,
            voxelized: None,
        })
    }

    /// Runs all passes; `progress` gets the planes that are done and returns whether to go on.
    ///
    /// # Errors
    /// As [`Backend::run`].
    pub fn run(
        &self,
        backend: &mut dyn Backend,
        progress: &mut (dyn FnMut(u32) -> bool + Send),
    ) -> Result<(), BackendError> {
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
    /// `sweep.intensity` is not `jacobian`), or for the cells of the wavefront that carries it forward.
    ///
    /// # Errors
    /// As [`Backend::read`].
    pub fn irradiance(&self, backend: &mut dyn Backend) -> Result<Vec<f32>, BackendError> {
        self.irradiance_on(self.light_planes().count - 1, backend)
    }

    /// As [`Self::irradiance`], on plane `plane` of [`Self::light_planes`], until light is carried a few planes further; of a wavefront, once it is there.
    ///
    /// # Errors
    /// As [`Backend::read`] and [`Backend::run`].
    pub fn irradiance_on(&self, plane: u32, backend: &mut dyn Backend) -> Result<Vec<f32>, BackendError> {
        let texels = self.light_grid.size[0] as usize * self.light_grid.size[1] as usize;
        let mut shares: Vec<f32> = if let Some(Carried { wavefront, buffers, .. }) = self.carried.as_deref() {
            let (passes, map) = wavefront.observe(plane, buffers);
            backend.run(&PassList { passes, ..PassList::default() }, &mut |_| true)?;
            wavefront.of_cells(&backend.read_part::<f32>(&buffers.light, map)?, plane)
        } else {
            let bytes = (self.unoccluded.len() * texels * 4) as u64;
            let start = self.ring.start(plane) * 4;
            backend.read_part(&self.buffers.irradiance, start..start + bytes)?
        };
        for (channel, unoccluded) in shares.chunks_exact_mut(texels).zip(self.unoccluded) {
            channel.iter_mut().for_each(|share| *share *= unoccluded);
        }
        Ok(shares)
    }

    /// The planes from which to which light is carried: those of the viewing rays, or those of the wavefront, across the light.
    #[must_use]
    pub fn light_planes(&self) -> Planes {
        self.carried.as_ref().map_or(self.planes, |carried| carried.wavefront.frame.planes)
    }

    /// The frame in which the light grid and its planes are stated: the view, or the wavefront's own.
    #[must_use]
    pub fn light_view(&self) -> Option<View> {
        self.carried.as_ref().map(|carried| carried.wavefront.frame.view)
    }
}

fn volumes(assets: &Assets) -> Result<Volumes<'_>, Error> {
    assets.subject.volumes().ok_or_else(|| Unrenderable::NeedsVolume.into())
}
