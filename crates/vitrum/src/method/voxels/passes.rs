//! The pass list of a frame.

use super::bodies::materials;
use super::cache::FrameCache;
use super::light::light_source;
use super::shadow::Lookup;
use super::shadow::source::Source;
use super::uniforms::{self, Surroundings};
use super::uploaded::{UploadedMesh, shown};
use crate::assets::Assets;
use crate::backend::{Backend, BackendError, Buffer, Pass, PassList, ReadBack as _, WhileBusy};
use crate::error::Error;
use crate::method::view::environment::EnvironmentUniforms;
use crate::method::view::receivers::Receivers;
use crate::method::view::{Bounds, View};
use crate::scene::{MethodName, Scene};
use bytemuck::bytes_of;
use vitrum_kernels::abi::record::{mirror, path, view};
use vitrum_kernels::abi::voxels::{STEPS, VoxelsUniforms, flag, seen};
use vitrum_kernels::kernel::{Kernel, Window, kernels};

/// A frame of rays through a mesh that is ready to run.
pub struct Rays {
    /// The passes.
    pub passes: PassList,
    /// Rays across and down.
    pub rays: [u32; 2],
    records: Buffer,
    pub(super) film: Buffer,
    /// Voxels of the mesh along x, y and z; `None` if rays run through its triangles.
    pub(super) voxels: Option<[u32; 3]>,
    /// Rows of voxels that go through holes of the surface and were left empty.
    pub(super) open_rows: u64,
}

impl Rays {
    /// Uploads the remaining data of a frame and lists its passes. The data in `uploaded` stays when the frame is freed.
    ///
    /// # Errors
    /// If the backend fails.
    pub fn prepare(
        scene: &Scene,
        assets: &Assets,
        uploaded: &UploadedMesh,
        backend: &mut dyn Backend,
    ) -> Result<Self, Error> {
        list(scene, assets, uploaded, &mut FrameCache::default(), backend)
    }

    /// Runs all passes; `progress` receives the number of finished passes and returns whether to go on.
    ///
    /// # Errors
    /// As [`Backend::run`].
    pub fn run(
        &self,
        backend: &mut dyn Backend,
        progress: &mut (dyn FnMut(usize) -> bool + Send),
    ) -> Result<(), BackendError> {
        backend.run(&self.passes, progress)
    }

    /// The finished pixels: planar records as [`view`] describes.
    ///
    /// # Errors
    /// As [`Backend::read`].
    pub fn film(&self, backend: &mut dyn Backend) -> Result<Vec<f32>, BackendError> {
        backend.read_all(&self.film)
    }

    /// The present state of the rays: planar records as [`path`] describes.
    ///
    /// # Errors
    /// As [`Backend::read`].
    pub fn records(&self, backend: &mut dyn Backend) -> Result<Vec<f32>, BackendError> {
        backend.read_all(&self.records)
    }
}

/// The largest number of rounds of a frame: dispatches, each together with one of [`seek`](vitrum_kernels::voxels::seek) if rays seek.
/// A ray that is under way after them has met more surfaces than allowed.
fn rounds(uploaded: &UploadedMesh, block: &VoxelsUniforms, way: u32) -> u32 {
    // Nodes of a tree, several times those of a ray.
    const NODES: u32 = 16 * STEPS as u32;
    // Where a way turns it may meet one surface more.
    let crossings = block.most_bounces + way + 1;
    let steps = uploaded.voxels().map_or(NODES, |[x, y, z]| {
        // From end to end in half voxels, as if there were a surface all along the way.
        let march = 2 * (x + y + z);
        if uploaded.has_opaque() { march.max(NODES) } else { march }
    });
    (crossings * steps).div_ceil(STEPS as u32)
}

/// The number of dispatches in which a search for the mirrored triangle visits every node of the tree.
fn searches(uploaded: &UploadedMesh) -> u32 {
    uploaded.nodes().div_ceil(4 * STEPS as u32)
}

/// The ways that rays are followed along: more than one only where surfaces reflect.
fn ways(scene: &Scene, uploaded: &UploadedMesh) -> u32 {
    if scene.voxels.reflection && uploaded.clear > 0 { scene.voxels.branches } else { 1 }
}

/// Uploads a frame's buffers and lists its passes.
pub(super) fn list(
    scene: &Scene,
    assets: &Assets,
    uploaded: &UploadedMesh,
    cache: &mut FrameCache,
    backend: &mut dyn Backend,
) -> Result<Rays, Error> {
    let mesh = shown(assets, MethodName::Voxels)?;
    let bounds = Bounds::from(mesh);
    let eye = View::new(scene, bounds);
    let looks = cache.looks(scene, mesh, uploaded);
    let receivers = Receivers::new(scene, &eye, bounds);
    let surfaces = uploaded.has_opaque() || scene.ground.is_some() || scene.wall.is_some();
    let exact = uploaded.voxels().is_none();
    let seeks = surfaces && !exact;
    let mut flags = if seeks { flag::SEEKS } else { 0 };
    flags |= if looks.of_triangles { flag::LOOK_OF_TRIANGLE } else { 0 };
    let pictures = cache.pictures.get(scene, assets.environment.as_deref(), &assets.textures, backend)?;
    let light = scene.first_light();
    let source = Source::of(light, &eye, bounds)?;
    let texture = light.texture.as_deref().and_then(|path| pictures.texture(path));
    let seen = Surroundings {
        environment: EnvironmentUniforms::new(scene, &pictures.environment, &eye),
        light: light_source(light, &source, &eye, uploaded.grid, texture),
        shadow: uploaded.shadow.as_ref().map_or(Ok(Lookup::NONE), |map| map.lookup(scene, uploaded.grid))?,
        receivers,
        caustics: uploaded.received.as_ref().map(|received| received.caustics.seen_from(uploaded.grid)),
    };
    let block = uniforms::block(scene, uploaded, &eye, &seen, flags);
    let size = [block.dispatch.width, block.dispatch.height];
    let materials = materials(&uploaded.bodies, mesh, scene, uploaded.grid.voxel_size);
    let materials = cache.materials(materials, backend)?;
    let looks = cache.looks_buffer(scene, &looks, backend)?;
    let shadow = match uploaded.light_buffer() {
        Some(buffer) => buffer.clone(),
        None => cache.scratch.zeros("no shadow map", 4, backend)?,
    };
    let planes = |components: usize| u64::from(size[0]) * u64::from(size[1]) * components as u64 * 4;
    let rays = cache.scratch.zeros("rays", planes(path::SIZE), backend)?;
    let film = cache.scratch.zeros("film", planes(view::SIZE), backend)?;
    let (mode, ways) = (block.dispatch.mode, ways(scene, uploaded));
    // Until the last way, rays keep a reflection for the next one.
    let keeps = |way: u32| if way + 1 < ways { flag::KEEPS } else { 0 };
    let pass = |way: u32, kernel: &'static Kernel, mode: u32, buffers: Vec<Buffer>| {
        let mut block = block;
        block.dispatch.mode = mode;
        block.flags |= keeps(way);
        Pass {
            kernel,
            uniforms: bytes_of(&block).to_vec(),
            buffers,
            width: size[0],
            height: size[1],
            start: 0,
            window: Window::whole(size[0], size[1]),
        }
    };
    let [nodes, corners] = [0, 1].map(|half| uploaded.tree[half].clone());
    let tree = [nodes.clone(), corners.clone(), materials.clone(), rays.clone()];
    let marched = || uploaded.buffers.iter().cloned().chain([materials.clone(), rays.clone()]).collect();
    let through: Vec<Buffer> = if exact { tree.to_vec() } else { marched() };
    let mut passes = vec![pass(0, &kernels::voxels_initialize_rays, 0, vec![rays.clone()])];
    let sees = if surfaces { seen::SURFACES } else { seen::ENVIRONMENT };
    let mirrors = if surfaces {
        cache.scratch.zeros("mirrors", planes(mirror::SIZE), backend)?
    } else {
        // Nothing of it is read.
        rays.clone()
    };
    for way in 0..ways {
        if way > 0 {
            passes.push(pass(way, &kernels::voxels_follow, 0, vec![rays.clone()]));
        }
        for _ in 0..rounds(uploaded, &block, way) {
            if seeks {
                passes.push(pass(way, &kernels::voxels_seek, mode, tree.to_vec()));
            }
            passes.push(pass(way, uploaded.kernel, mode, through.clone()));
        }
        let [pictures, shadow] = [&pictures.buffer, &shadow].map(Buffer::clone);
        let mut ended = vec![rays.clone(), pictures, corners.clone(), looks.clone(), shadow];
        if way > 0 {
            ended.push(film.clone());
            passes.push(pass(way, &kernels::voxels_add_way, sees, ended));
            continue;
        }
        if surfaces {
            let reflected = vec![rays.clone(), nodes.clone(), corners.clone(), materials.clone(), mirrors.clone()];
            passes.extend((0..searches(uploaded)).map(|_| pass(way, &kernels::voxels_reflect, 0, reflected.clone())));
        }
        ended.extend([mirrors.clone(), film.clone()]);
        passes.push(pass(way, &kernels::voxels_resolve, sees, ended));
    }
    let name = uploaded.kernel.declaration.name;
    let searches = kernels::voxels_reflect.declaration.name;
    let while_busy = vec![
        WhileBusy {
            kernel: name,
            passes: vec![name, kernels::voxels_seek.declaration.name],
            until: Some(kernels::voxels_follow.declaration.name),
        },
        WhileBusy { kernel: searches, passes: vec![searches], until: None },
    ];
    let passes = PassList { passes, while_busy, ..PassList::default() };
    Ok(Rays { passes, rays: size, records: rays, film, voxels: uploaded.voxels(), open_rows: uploaded.open_rows })
}
