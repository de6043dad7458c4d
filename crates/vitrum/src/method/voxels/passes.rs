//! What rays run through, on a backend, and the pass list of a frame.

use super::bodies::{Body, bodies, materials};
use super::{bricks, distances, fields, tree, uniforms};
use crate::backend::{Backend, BackendError, Buffer, Pass, PassList};
use crate::inputs::Inputs;
use crate::method::sweep::View;
use crate::method::sweep::environment::Prepared;
use crate::method::voxelize::{FillRule, Grid, Settings, Voxelization, voxelize_in};
use crate::render::Error;
use crate::scene::{Normals, Scene, Surfaces};
use bytemuck::{bytes_of, cast_slice};
use vitrum_io::Mesh;
use vitrum_kernels::abi::record::{fate, path, view};
use vitrum_kernels::abi::voxels::{STEPS, VoxelsUniforms, surface};
use vitrum_kernels::kernel::{Kernel, kernels};

/// Empty voxels around the mesh: the filter's reach, and what a ray's normal looks at beyond.
const PADDING: u32 = 5;

/// What a mesh is turned into, and how finely.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Kind {
    resolution: u32,
    exact: bool,
    paper: bool,
}

impl Kind {
    fn of(scene: &Scene) -> Self {
        let exact = scene.voxels.surfaces == Surfaces::Exact;
        let paper = scene.voxels.normals == Normals::Paper;
        Self { resolution: scene.voxels.resolution, exact, paper }
    }
}

/// A mesh on a backend: what stays the same while camera and materials change.
pub struct Uploaded {
    kind: Kind,
    /// Where the voxels lie; triangles are in its units, too.
    pub grid: Grid,
    bodies: Vec<Body>,
    /// Rows of voxels that go through holes of the surface, over all bodies; they are left empty.
    pub open_rows: u64,
    kernel: &'static Kernel,
    /// In the order of the kernel's bindings.
    buffers: Vec<Buffer>,
}

impl Uploaded {
    /// Turns a mesh into what the scene's rays run through. `progress` is told how much is done and how much there is, and cancels
    /// by returning `false`.
    ///
    /// # Errors
    /// If there are too many voxels or materials for the rays or for the backend, or the backend fails.
    pub fn new(
        scene: &Scene,
        mesh: &Mesh,
        backend: &mut dyn Backend,
        progress: &mut dyn FnMut(u64, u64) -> bool,
    ) -> Result<Self, Error> {
        let kind = Kind::of(scene);
        let settings = Settings { padding: PADDING, ..Settings::new(kind.resolution) };
        let grid = Grid::around(mesh, &settings)?;
        let mut uploaded = Self {
            kind,
            grid,
            bodies: bodies(mesh)?,
            open_rows: 0,
            kernel: &kernels::voxels_march,
            buffers: Vec::new(),
        };
        let filled = if kind.exact {
            uploaded.triangles(backend)
        } else if kind.paper {
            uploaded.paper(&settings, backend, progress)
        } else {
            uploaded.solids(&settings, backend, progress)
        };
        match filled {
            Ok(()) => Ok(uploaded),
            Err(error) => {
                uploaded.free(backend);
                Err(error)
            }
        }
    }

    /// Whether a scene's rays run through the same.
    #[must_use]
    pub fn fits(&self, scene: &Scene) -> bool {
        self.kind == Kind::of(scene)
    }

    fn upload(&mut self, label: &str, contents: &[u8], backend: &mut dyn Backend) -> Result<(), Error> {
        self.buffers.push(backend.create(label, contents)?);
        Ok(())
    }

    fn triangles(&mut self, backend: &mut dyn Backend) -> Result<(), Error> {
        let tree = tree::build(&self.bodies, self.grid, !self.kind.paper);
        self.kernel = &kernels::voxels_trace_triangles;
        self.upload("nodes of the tree", cast_slice(&tree.nodes), backend)?;
        self.upload("corners of triangles", cast_slice(&tree.corners), backend)
    }

    fn solids(
        &mut self,
        settings: &Settings,
        backend: &mut dyn Backend,
        progress: &mut dyn FnMut(u64, u64) -> bool,
    ) -> Result<(), Error> {
        let [x, y, z] = self.grid.dimensions;
        let bytes = self.grid.voxels() * 2 * self.bodies.len() as u64;
        // Kernels count bytes by a signed number.
        if bytes > i32::MAX as u64 - 8 {
            let count = self.bodies.len();
            return Err(Error::Scene(format!(
                "{x} x {y} x {z} voxels of {count} materials take {bytes} bytes, rays can address 2^31; lower `voxels.resolution`"
            )));
        }
        let settings = Settings { surface: false, solid: Some(FillRule::Nonzero), ..*settings };
        let mut all: Vec<u16> = Vec::new();
        for body in &self.bodies {
            let solid = voxelize_in(self.grid, &body.mesh, &settings, backend, progress)?.solid;
            let solid = solid.expect("a solid was asked for");
            self.open_rows += solid.open_rows;
            let field = distances::distances(body, self.grid, &solid.coverage);
            all.extend(fields::smooth(&field, self.grid.dimensions.map(|voxels| voxels as usize)));
        }
        let distances = bricks::distances(&all, self.grid.dimensions);
        // Whole words, and one more for the pair of the last voxel.
        all.resize(all.len().next_multiple_of(2) + 2, 0);
        self.upload("distances of bricks", cast_slice(&distances), backend)?;
        self.upload("fields of materials", cast_slice(&all), backend)
    }

    fn paper(
        &mut self,
        settings: &Settings,
        backend: &mut dyn Backend,
        progress: &mut dyn FnMut(u64, u64) -> bool,
    ) -> Result<(), Error> {
        let mut whole = self.bodies[0].mesh.clone();
        whole.triangles.clear();
        for (number, body) in self.bodies.iter().enumerate() {
            whole.triangles.extend(&body.mesh.triangles);
            whole.triangle_materials.resize(whole.triangles.len(), number as u32);
        }
        let settings = Settings { attributes: true, ..*settings };
        let Voxelization { surface, attributes, .. } = voxelize_in(self.grid, &whole, &settings, backend, progress)?;
        let (mask, attributes) = surface.zip(attributes).expect("both were asked for");
        let surfaces: Vec<[f32; surface::SIZE]> = attributes
            .normals
            .iter()
            .zip(&attributes.materials)
            .map(|(normal, material)| {
                let [x, y, z] = glam::Vec3::from_array(*normal).normalize_or_zero().to_array();
                [x, y, z, material.unwrap_or(0) as f32]
            })
            .collect();
        self.kernel = &kernels::voxels_march_paper;
        self.upload("mask of the surface", cast_slice(mask.words()), backend)?;
        self.upload("ranks of the mask", cast_slice(&mask.ranks().0), backend)?;
        self.upload("surfaces of voxels", cast_slice(&surfaces), backend)
    }

    /// Dispatches after which a ray that is still under way has met more than it may.
    fn dispatches(&self, block: &VoxelsUniforms) -> u32 {
        let [x, y, z] = self.grid.dimensions;
        let crossings = block.bricks.w + 1;
        // From end to end in half voxels, as if there were a surface all along the way; a tree's nodes, several times those of a ray.
        let steps = if self.kind.exact { 16 * STEPS as u32 } else { 2 * (x + y + z) };
        (crossings * steps).div_ceil(STEPS as u32)
    }

    /// Frees the buffers.
    pub fn free(self, backend: &mut dyn Backend) {
        for buffer in self.buffers {
            backend.free(buffer);
        }
    }
}

/// A frame that is ready to run.
pub struct Rays {
    /// The passes.
    pub passes: PassList,
    /// Rays across and down.
    pub rays: [u32; 2],
    created: Vec<Buffer>,
    records: Buffer,
    film: Buffer,
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
        let (passes, rays, [records, film]) = listed?;
        Ok(Self { passes, rays, created, records, film })
    }

    /// Runs all passes; `progress` gets how many are done and returns whether to go on.
    pub fn run(&self, backend: &mut dyn Backend, progress: &mut dyn FnMut(usize) -> bool) -> Result<(), BackendError> {
        // Most rays have left after a few dispatches. A backend that cannot see that by itself is asked for the rays from time to time.
        const TOGETHER: usize = 8;
        let total = self.passes.passes.len();
        if total <= 2 * TOGETHER || backend.name() == "cpu" {
            return backend.run(&self.passes, progress);
        }
        let part = |from: usize, to: usize| {
            let copy = |pass: &Pass| Pass { uniforms: pass.uniforms.clone(), buffers: pass.buffers.clone(), ..*pass };
            PassList { passes: self.passes.passes[from..to].iter().map(copy).collect(), ..PassList::default() }
        };
        let mut done = 0;
        while done < total - 1 && (done == 0 || self.under_way(backend)?) {
            let end = (done + TOGETHER).min(total - 1);
            backend.run(&part(done, end), &mut |more| progress(done + more))?;
            done = end;
        }
        backend.run(&part(total - 1, total), &mut |more| progress(total - 1 + more))
    }

    /// Whether any ray has not ended.
    fn under_way(&self, backend: &mut dyn Backend) -> Result<bool, BackendError> {
        let bytes = backend.read(self.records)?;
        let count = self.rays[0] as usize * self.rays[1] as usize;
        let fates = bytes.chunks_exact(4).skip(path::STATUS * count).take(count);
        Ok(fates.map(|word| f32::from_le_bytes([word[0], word[1], word[2], word[3]])).any(|fate| fate == fate::ACTIVE))
    }

    /// The finished pixels: planar records as [`view`] describes.
    pub fn film(&self, backend: &mut dyn Backend) -> Result<Vec<f32>, BackendError> {
        Ok(bytemuck::pod_collect_to_vec(&backend.read(self.film)?))
    }

    /// The rays as they are now: planar records as [`path`] describes.
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

fn list(
    scene: &Scene,
    inputs: &Inputs,
    uploaded: &Uploaded,
    backend: &mut dyn Backend,
    created: &mut Vec<Buffer>,
) -> Result<(PassList, [u32; 2], [Buffer; 2]), Error> {
    let mesh =
        inputs.mesh.as_ref().ok_or_else(|| Error::Scene("`voxels` shows a mesh, and none is given".to_owned()))?;
    let eye = View::new(scene, &inputs.volume);
    let environment = Prepared::new(&scene.environment, inputs.environment.as_ref(), &eye);
    let block = uniforms::block(scene, mesh, uploaded.grid, uploaded.bodies.len(), &eye, &environment);
    let size = [block.dispatch.x, block.dispatch.y];
    let materials = materials(&uploaded.bodies, mesh, scene, uploaded.grid.voxel_size);
    let mut keep = |buffer: Buffer| {
        created.push(buffer);
        buffer
    };
    let materials = keep(backend.create("materials", cast_slice(&materials))?);
    let map = keep(backend.create("environment", cast_slice(&environment.map))?);
    let planes = |components: usize| u64::from(size[0]) * u64::from(size[1]) * components as u64 * 4;
    let rays = keep(backend.create_zeroed("rays", planes(path::SIZE))?);
    let film = keep(backend.create_zeroed("film", planes(view::SIZE))?);
    let pass = |kernel: &'static Kernel, mode: u32, buffers: Vec<Buffer>| {
        let mut block = block;
        block.dispatch.z = mode;
        Pass { kernel, uniforms: bytes_of(&block).to_vec(), buffers, width: size[0], height: size[1] }
    };
    let mut through = uploaded.buffers.clone();
    through.extend([materials, rays]);
    let mut passes = vec![pass(&kernels::voxels_initialize_rays, 0, vec![rays])];
    for _ in 0..uploaded.dispatches(&block) {
        passes.push(pass(uploaded.kernel, block.dispatch.z, through.clone()));
    }
    passes.push(pass(&kernels::voxels_resolve, 0, vec![rays, map, film]));
    let name = uploaded.kernel.declaration.name;
    let list = PassList { passes, while_busy: vec![name], ends_with: Some(name), ..PassList::default() };
    Ok((list, size, [rays, film]))
}
