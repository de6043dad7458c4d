//! The pass list of a frame.

use super::bodies::materials;
use super::looks::looks;
use super::shadow::Lookup;
use super::uniforms::{self, Seen};
use super::uploaded::{Uploaded, shown};
use crate::backend::{Backend, BackendError, Buffer, Pass, PassList, WhileBusy};
use crate::inputs::Inputs;
use crate::method::sweep::View;
use crate::method::view::environment::Prepared;
use crate::method::view::light::travels;
use crate::method::view::receivers::Receivers;
use crate::render::Error;
use crate::scene::Scene;
use bytemuck::{bytes_of, cast_slice};
use vitrum_kernels::abi::record::{fate, mirror, path, view};
use vitrum_kernels::abi::voxels::{STEPS, VoxelsUniforms, flag, seen};
use vitrum_kernels::kernel::{Kernel, Window, kernels};

/// A frame that is ready to run.
pub struct Rays {
    /// The passes.
    pub passes: PassList,
    /// Rays across and down.
    pub rays: [u32; 2],
    /// Parts of the passes that may end early.
    stretches: Vec<Stretch>,
    created: Vec<Buffer>,
    records: Buffer,
    film: Buffer,
}

/// Passes up to number `end` that matter while there is work.
struct Stretch {
    end: usize,
    /// The records that tell.
    records: Buffer,
    /// Their component that does.
    component: usize,
    /// Whether a record with this one has work left.
    is_busy: fn(f32) -> bool,
}

impl Rays {
    /// Uploads what else a frame needs and lists its passes. What `uploaded` has stays when the frame is freed.
    ///
    /// # Errors
    /// If the backend fails.
    pub fn prepare(
        scene: &Scene,
        inputs: &Inputs,
        uploaded: &Uploaded,
        backend: &mut dyn Backend,
    ) -> Result<Self, Error> {
        let mut created = Vec::new();
        let listed = list(scene, inputs, uploaded, backend, &mut created);
        if listed.is_err() {
            created.iter().for_each(|buffer| backend.free(*buffer));
        }
        Ok(Self { created, ..listed? })
    }

    /// Runs all passes; `progress` gets how many are done and returns whether to go on.
    ///
    /// # Errors
    /// As [`Backend::run`].
    pub fn run(&self, backend: &mut dyn Backend, progress: &mut dyn FnMut(usize) -> bool) -> Result<(), BackendError> {
        // Most rays have left after a few dispatches. A backend that cannot see that by itself is asked for records from time to time.
        const TOGETHER: usize = 8;
        let total = self.passes.passes.len();
        if total <= 2 * TOGETHER || backend.leaves_out_idle_passes() {
            return backend.run(&self.passes, progress);
        }
        let part = |from: usize, to: usize| {
            let copy = |pass: &Pass| Pass { uniforms: pass.uniforms.clone(), buffers: pass.buffers.clone(), ..*pass };
            PassList { passes: self.passes.passes[from..to].iter().map(copy).collect(), ..PassList::default() }
        };
        let mut done = 0;
        for stretch in &self.stretches {
            let start = done;
            while done < stretch.end && (done == start || self.is_busy(stretch, backend)?) {
                let end = (done + TOGETHER).min(stretch.end);
                backend.run(&part(done, end), &mut |more| progress(done + more))?;
                done = end;
            }
            done = stretch.end;
        }
        backend.run(&part(done, total), &mut |more| progress(done + more))
    }

    /// Whether any invocation has work left.
    fn is_busy(&self, stretch: &Stretch, backend: &mut dyn Backend) -> Result<bool, BackendError> {
        let component = u64::from(self.rays[0]) * u64::from(self.rays[1]) * 4;
        let bytes = backend.read_part(stretch.records, stretch.component as u64 * component, component)?;
        let stages: Vec<f32> = bytemuck::pod_collect_to_vec(&bytes);
        Ok(stages.into_iter().any(stretch.is_busy))
    }

    /// The finished pixels: planar records as [`view`] describes.
    ///
    /// # Errors
    /// As [`Backend::read`].
    pub fn film(&self, backend: &mut dyn Backend) -> Result<Vec<f32>, BackendError> {
        Ok(bytemuck::pod_collect_to_vec(&backend.read(self.film)?))
    }

    /// The rays as they are now: planar records as [`path`] describes.
    ///
    /// # Errors
    /// As [`Backend::read`].
    pub fn records(&self, backend: &mut dyn Backend) -> Result<Vec<f32>, BackendError> {
        Ok(bytemuck::pod_collect_to_vec(&backend.read(self.records)?))
    }

    /// Frees the frame's buffers.
    pub fn free(self, backend: &mut dyn Backend) {
        for buffer in self.created {
            backend.free(buffer);
        }
    }
}

/// Rounds after which a ray that is still under way has met more than it may: dispatches, each with one that looks for what is ahead
/// if rays seek.
fn rounds(uploaded: &Uploaded, block: &VoxelsUniforms) -> u32 {
    // Nodes of a tree, several times those of a ray.
    const NODES: u32 = 16 * STEPS as u32;
    let crossings = block.most_bounces + 1;
    let steps = uploaded.voxels().map_or(NODES, |[x, y, z]| {
        // From end to end in half voxels, as if there were a surface all along the way.
        let march = 2 * (x + y + z);
        if uploaded.has_opaque() { march.max(NODES) } else { march }
    });
    (crossings * steps).div_ceil(STEPS as u32)
}

/// Dispatches after which a search for what the first surface mirrors has looked at every node there is.
fn searches(uploaded: &Uploaded) -> u32 {
    uploaded.nodes().div_ceil(4 * STEPS as u32)
}

/// A frame, but for what is to be freed with it: buffers are added to `created` as they are made.
fn list(
    scene: &Scene,
    inputs: &Inputs,
    uploaded: &Uploaded,
    backend: &mut dyn Backend,
    created: &mut Vec<Buffer>,
) -> Result<Rays, Error> {
    let mesh = shown(inputs)?;
    let eye = View::new(scene, &inputs.volume);
    let looks = looks(&uploaded.bodies, uploaded.first_in_tree(), mesh, scene);
    let receivers = Receivers::new(scene, &eye, &inputs.volume);
    let surfaces = uploaded.has_opaque() || scene.ground.is_some() || scene.wall.is_some();
    let exact = uploaded.voxels().is_none();
    let seeks = surfaces && !exact;
    let mut flags = if seeks { flag::SEEKS } else { 0 };
    flags |= if looks.of_triangles { flag::LOOK_OF_TRIANGLE } else { 0 };
    let seen = Seen {
        environment: Prepared::new(&scene.environment, inputs.environment.as_ref(), &eye),
        light: eye.axes * travels(&scene.light, &eye)?,
        shadow: uploaded.shadow.as_ref().map_or(Ok(Lookup::default()), |map| map.lookup(scene, uploaded.grid))?,
        receivers,
    };
    let block = uniforms::block(scene, uploaded, &eye, &seen, flags);
    let size = [block.dispatch.width, block.dispatch.height];
    let materials = materials(&uploaded.bodies, mesh, scene, uploaded.grid.voxel_size);
    let mut keep = |buffer: Buffer| {
        created.push(buffer);
        buffer
    };
    let materials = keep(backend.create("materials", cast_slice(&materials))?);
    let map = keep(backend.create("environment", cast_slice(&seen.environment.map))?);
    let looks = keep(backend.create("looks", cast_slice(&looks.floats))?);
    let shadow = match &uploaded.shadow {
        Some(map) => map.buffer,
        None => keep(backend.create_zeroed("no shadow map", 4)?),
    };
    let planes = |components: usize| u64::from(size[0]) * u64::from(size[1]) * components as u64 * 4;
    let rays = keep(backend.create_zeroed("rays", planes(path::SIZE))?);
    let film = keep(backend.create_zeroed("film", planes(view::SIZE))?);
    let pass = |kernel: &'static Kernel, mode: u32, buffers: Vec<Buffer>| {
        let mut block = block;
        block.dispatch.mode = mode;
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
    let tree = [uploaded.tree[0], uploaded.tree[1], materials, rays];
    let marched = || uploaded.buffers.iter().copied().chain([materials, rays]).collect();
    let through: Vec<Buffer> = if exact { tree.to_vec() } else { marched() };
    let mode = block.dispatch.mode;
    let mut passes = vec![pass(&kernels::voxels_initialize_rays, 0, vec![rays])];
    for _ in 0..rounds(uploaded, &block) {
        if seeks {
            passes.push(pass(&kernels::voxels_seek, mode, tree.to_vec()));
        }
        passes.push(pass(uploaded.kernel, mode, through.clone()));
    }
    let is_busy = |status: f32| status == fate::ACTIVE || status == fate::SEEKS;
    let mut stretches = vec![Stretch { end: passes.len(), records: rays, component: path::STATUS, is_busy }];
    let (sees, mirrors) = if surfaces {
        let mirrors = keep(backend.create_zeroed("mirrors", planes(mirror::SIZE))?);
        let reflected = vec![rays, uploaded.tree[0], uploaded.tree[1], materials, mirrors];
        passes.extend((0..searches(uploaded)).map(|_| pass(&kernels::voxels_reflect, 0, reflected.clone())));
        let is_busy = |stage: f32| stage != mirror::stage::FOUND;
        stretches.push(Stretch { end: passes.len(), records: mirrors, component: mirror::STAGE, is_busy });
        (seen::SURFACES, mirrors)
    } else {
        // What nothing is read of.
        (seen::ENVIRONMENT, rays)
    };
    let resolved = vec![rays, map, uploaded.tree[1], looks, shadow, mirrors, film];
    passes.push(pass(&kernels::voxels_resolve, sees, resolved));
    let name = uploaded.kernel.declaration.name;
    let searches = kernels::voxels_reflect.declaration.name;
    let while_busy = vec![
        WhileBusy { kernel: name, passes: vec![name, kernels::voxels_seek.declaration.name] },
        WhileBusy { kernel: searches, passes: vec![searches] },
    ];
    let passes = PassList { passes, while_busy, ..PassList::default() };
    Ok(Rays { passes, rays: size, stretches, created: Vec::new(), records: rays, film })
}
