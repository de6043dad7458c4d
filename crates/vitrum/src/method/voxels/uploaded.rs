//! What rays run through, on a backend.

use super::bodies::{Body, Group, bodies, groups};
use super::shadow::{Cast, ShadowMap};
use super::solids::Solids;
use super::{bricks, cropped, tree};
use crate::backend::{Backend, Buffer};
use crate::inputs::Inputs;
use crate::method::twist::twisted;
use crate::method::voxelize::{Grid, Settings, Voxelization, voxelize_in};
use crate::render::Error;
use crate::scene::{Normals, Scene, Surfaces};
use bytemuck::cast_slice;
use vitrum_io::Mesh;
use vitrum_kernels::abi::voxels::surface;
use vitrum_kernels::kernel::{Kernel, kernels};

/// Empty voxels around the mesh: the filter's reach, and what a ray's normal looks at beyond.
const PADDING: u32 = 5;

/// What a mesh is turned into, and how finely.
#[derive(Debug, Clone, PartialEq)]
struct Kind {
    resolution: u32,
    twist: f32,
    exact: bool,
    paper: bool,
    /// Of the paper's voxels; else 0.
    overlap: f32,
    /// What makes a body each.
    groups: Vec<Group>,
}

impl Kind {
    fn of(scene: &Scene, mesh: &Mesh) -> Self {
        let groups = groups(mesh, &scene.material);
        // Opaque bodies are triangles always.
        let exact = scene.voxels.surfaces == Surfaces::Exact || groups.iter().all(|group| group.opaque);
        let paper = scene.voxels.normals == Normals::Paper;
        let twist = scene.mesh.as_ref().map_or(0.0, |mesh| mesh.twist);
        let overlap = if paper { scene.voxels.overlap } else { 0.0 };
        Self { resolution: scene.voxels.resolution, twist, exact, paper, overlap, groups }
    }
}

/// A mesh on a backend: what stays the same while camera and materials change.
pub struct Uploaded {
    kind: Kind,
    /// Where the voxels lie; triangles are in its units, too.
    pub grid: Grid,
    /// Low and high corner of the mesh.
    pub(super) bounds: [[f32; 3]; 2],
    /// Clear ones first.
    pub(super) bodies: Vec<Body>,
    /// How many are clear.
    pub(super) clear: usize,
    /// Rows of voxels that go through holes of the surface, over all clear bodies; they are left empty.
    pub open_rows: u64,
    pub(super) kernel: &'static Kernel,
    /// In the order of the kernel's bindings.
    pub(super) buffers: Vec<Buffer>,
    /// Nodes and corners of the tree of triangles: all, or where rays march through voxels, those of opaque bodies.
    pub(super) tree: Vec<Buffer>,
    nodes: u32,
    pub(super) shadow: Option<ShadowMap>,
}

impl Uploaded {
    /// Turns a mesh into what the scene's rays run through. `progress` is told how much is done and how much there is, and cancels
    /// by returning `false`.
    ///
    /// # Errors
    /// If `inputs` have no mesh, there are too many voxels or materials for the rays or for the backend, or the backend fails.
    pub fn new(
        scene: &Scene,
        inputs: &Inputs,
        backend: &mut dyn Backend,
        progress: &mut dyn FnMut(u64, u64) -> bool,
    ) -> Result<Self, Error> {
        let mesh = shown(inputs)?;
        let kind = Kind::of(scene, mesh);
        let deformed = (kind.twist != 0.0).then(|| twisted(mesh, kind.twist));
        let mesh = deformed.as_ref().unwrap_or(mesh);
        let settings = Settings { padding: PADDING, overlap: kind.overlap, ..Settings::new(kind.resolution) };
        let grid = Grid::around(mesh, &settings)?;
        let bodies = bodies(mesh, &scene.material)?;
        let mut uploaded = Self {
            clear: bodies.iter().filter(|body| !body.opaque).count(),
            kind,
            grid,
            bounds: mesh.bounds(),
            bodies,
            open_rows: 0,
            kernel: &kernels::voxels_march,
            buffers: Vec::new(),
            tree: Vec::new(),
            nodes: 0,
            shadow: None,
        };
        let filled = uploaded.fill(&settings, backend, progress);
        match filled.and_then(|()| uploaded.update(scene, inputs, backend, progress)) {
            Ok(()) => Ok(uploaded),
            Err(error) => {
                uploaded.free(backend);
                Err(error)
            }
        }
    }

    /// Whether a scene's rays run through the same.
    #[must_use]
    pub fn fits(&self, scene: &Scene, mesh: &Mesh) -> bool {
        self.kind == Kind::of(scene, mesh)
    }

    /// Voxels along x, y and z; `None` where rays run through the triangles.
    #[must_use]
    pub fn voxels(&self) -> Option<[u32; 3]> {
        (!self.kind.exact).then_some(self.grid.dimensions)
    }

    /// Makes the shadow that a scene's light casts, if it is another one than before. `progress` is as for [`Self::new`].
    ///
    /// # Errors
    /// If the shadow map is too large for the backend, or the backend fails.
    pub fn update(
        &mut self,
        scene: &Scene,
        inputs: &Inputs,
        backend: &mut dyn Backend,
        progress: &mut dyn FnMut(u64, u64) -> bool,
    ) -> Result<(), Error> {
        let cast = Cast::of(scene, inputs, &self.bodies)?;
        let is_of = |map: &ShadowMap| cast.as_ref().is_some_and(|cast| map.is_of(cast));
        if self.shadow.as_ref().is_some_and(is_of) {
            return Ok(());
        }
        if let Some(other) = self.shadow.take() {
            backend.free(other.buffer);
        }
        self.shadow = cast.map(|cast| ShadowMap::new(cast, &self.bodies, backend, progress)).transpose()?;
        Ok(())
    }

    /// Number of the first body whose triangles are in the tree.
    pub(super) fn first_in_tree(&self) -> usize {
        if self.kind.exact { 0 } else { self.clear }
    }

    /// Whether there is anything opaque to be met.
    pub(super) fn has_opaque(&self) -> bool {
        self.clear < self.bodies.len()
    }

    /// How many nodes the tree has.
    pub(super) fn nodes(&self) -> u32 {
        self.nodes
    }

    fn fill(
        &mut self,
        settings: &Settings,
        backend: &mut dyn Backend,
        progress: &mut dyn FnMut(u64, u64) -> bool,
    ) -> Result<(), Error> {
        let tree = tree::build(&self.bodies, self.first_in_tree(), self.grid, !self.kind.paper)?;
        self.nodes = tree.count();
        for (label, floats) in [("nodes of the tree", &tree.nodes), ("corners of triangles", &tree.corners)] {
            self.tree.push(backend.create(label, cast_slice(floats))?);
        }
        if self.kind.exact {
            self.kernel = &kernels::voxels_trace_triangles;
            Ok(())
        } else if self.kind.paper {
            self.paper(settings, backend, progress)
        } else {
            self.solids(backend, progress)
        }
    }

    fn upload(&mut self, label: &str, contents: &[u8], backend: &mut dyn Backend) -> Result<(), Error> {
        self.buffers.push(backend.create(label, contents)?);
        Ok(())
    }

    fn solids(&mut self, backend: &mut dyn Backend, progress: &mut dyn FnMut(u64, u64) -> bool) -> Result<(), Error> {
        let [x, y, z] = self.grid.dimensions;
        let bytes = self.grid.voxels() * 2 * self.clear as u64;
        // Kernels count bytes by a signed number.
        if bytes > i32::MAX as u64 - 8 {
            let count = self.clear;
            return Err(Error::Scene(format!(
                "{x} x {y} x {z} voxels of {count} clear materials take {bytes} bytes, rays can address 2^31; lower `voxels.resolution`"
            )));
        }
        let clear = &self.bodies[..self.clear];
        let Solids { fields: all, open_rows } = Solids::new(clear, self.grid, backend, progress)?;
        self.open_rows = open_rows;
        let distances = bricks::distances(&all, self.grid.dimensions);
        let cropped = cropped::cropped(&all, self.grid.dimensions);
        drop(all);
        self.upload("distances of bricks", cast_slice(&distances), backend)?;
        self.upload("fields of materials", cast_slice(&cropped), backend)
    }

    fn paper(
        &mut self,
        settings: &Settings,
        backend: &mut dyn Backend,
        progress: &mut dyn FnMut(u64, u64) -> bool,
    ) -> Result<(), Error> {
        let whole = together(&self.bodies[..self.clear]);
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

    /// Frees the buffers.
    pub fn free(self, backend: &mut dyn Backend) {
        let shadow = self.shadow.map(|map| map.buffer);
        for buffer in self.buffers.into_iter().chain(self.tree).chain(shadow) {
            backend.free(buffer);
        }
    }
}

/// The mesh that inputs have.
pub(super) fn shown(inputs: &Inputs) -> Result<&Mesh, Error> {
    inputs.mesh.as_ref().ok_or_else(|| Error::Scene("`voxels` shows a mesh, and none is given".to_owned()))
}

/// Several bodies in one mesh, each with its number as its material.
fn together(bodies: &[Body]) -> Mesh {
    let mut whole = bodies[0].mesh.clone();
    for (number, body) in bodies.iter().enumerate() {
        let part = &body.mesh;
        if number > 0 {
            let base = whole.positions.len() as u32;
            whole.positions.extend(&part.positions);
            whole.triangles.extend(part.triangles.iter().map(|triangle| triangle.map(|vertex| vertex + base)));
            if let (Some(all), Some(normals)) = (&mut whole.normals, &part.normals) {
                all.extend(normals);
            }
            if let (Some(all), Some(colors)) = (&mut whole.colors, &part.colors) {
                all.extend(colors);
            }
        }
        whole.triangle_materials.resize(whole.triangles.len(), number as u32);
    }
    whole
}
