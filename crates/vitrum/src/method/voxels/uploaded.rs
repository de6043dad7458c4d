//! A mesh on a backend, as rays run through it: voxels, or a tree of triangles, and the shadow map.

use super::bodies::{Body, Group, bodies, groups};
use super::shadow::{Cast, ShadowMap};
use super::solids::Solids;
use super::{bricks, cropped, tree, uniforms};
use crate::assets::Assets;
use crate::backend::{Backend, Buffer, Contents};
use crate::error::Error;
use crate::method::Tools;
use crate::method::twist::twisted;
use crate::method::voxelize::{Grid, Settings, Voxelization, voxelize_in};
use crate::scene::{MethodName, Normals, Scene, Surfaces};
use crate::unrenderable::Unrenderable;
use bytemuck::cast_slice;
use vitrum_io::Mesh;
use vitrum_kernels::abi::voxels::surface;
use vitrum_kernels::kernel::{Kernel, kernels};

/// Empty voxels around the mesh: the reach of the filter and of the gradient at a ray.
const PADDING: u32 = 5;

/// The key of an uploaded mesh: the representation, and its resolution.
#[derive(Debug, Clone, PartialEq)]
struct Kind {
    resolution: u32,
    twist: f32,
    exact: bool,
    paper: bool,
    /// Overlap of the paper's voxels; 0 for other representations.
    overlap: f32,
    /// The materials of each body.
    groups: Vec<Group>,
}

impl Kind {
    fn of(scene: &Scene, mesh: &Mesh) -> Self {
        let groups = groups(mesh, &scene.material);
        // Opaque bodies are triangles always.
        let exact = scene.voxels.surfaces == Surfaces::Exact || groups.iter().all(|group| group.opaque);
        let paper = scene.voxels.normals == Normals::Paper;
        let twist = scene.mesh.first().map_or(0.0, |mesh| mesh.twist);
        let overlap = if paper { scene.voxels.overlap } else { 0.0 };
        Self { resolution: scene.voxelization.resolution, twist, exact, paper, overlap, groups }
    }
}

/// A mesh on a backend, which stays the same while camera and materials change.
pub struct UploadedMesh {
    kind: Kind,
    /// The grid of the voxels, in whose units the triangles are, too.
    pub grid: Grid,
    /// Low and high corner of the mesh.
    pub(in crate::method) bounds: [[f32; 3]; 2],
    /// The bodies, clear ones first.
    pub(in crate::method) bodies: Vec<Body>,
    /// Number of clear bodies.
    pub(super) clear: usize,
    /// Rows of voxels that go through holes of the surface, over all clear bodies; they are left empty.
    pub open_rows: u64,
    pub(super) kernel: &'static Kernel,
    /// Buffers of voxels, in the order of the kernel's bindings.
    pub(super) buffers: Vec<Buffer>,
    /// Nodes and corners of the tree of triangles: all, or where rays march through voxels, those of opaque bodies.
    pub(in crate::method) tree: Vec<Buffer>,
    nodes: u32,
    pub(super) shadow: Option<ShadowMap>,
}

impl UploadedMesh {
    /// Turns a mesh into the representation that the scene's rays run through, and uploads it.
    ///
    /// # Errors
    /// If the subject is no mesh, there are too many voxels or materials for the rays or for the backend, or the backend fails.
    pub fn new(scene: &Scene, assets: &Assets, tools: &mut Tools<'_>) -> Result<Self, Error> {
        let mesh = shown(assets, MethodName::Voxels)?;
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
        uploaded.fill(&settings, tools)?;
        uploaded.update(scene, assets, tools)?;
        Ok(uploaded)
    }

    /// Whether a scene's rays run through the same representation.
    #[must_use]
    pub fn fits(&self, scene: &Scene, mesh: &Mesh) -> bool {
        self.kind == Kind::of(scene, mesh)
    }

    /// Voxels along x, y and z; `None` where rays run through the triangles.
    #[must_use]
    pub fn voxels(&self) -> Option<[u32; 3]> {
        (!self.kind.exact).then_some(self.grid.dimensions)
    }

    /// Makes the shadow map of a scene's light, if the light or the materials have changed.
    ///
    /// # Errors
    /// If the shadow map is too large for the backend, or the backend fails.
    pub fn update(&mut self, scene: &Scene, assets: &Assets, tools: &mut Tools<'_>) -> Result<(), Error> {
        let cast = Cast::of(scene, assets, &self.bodies)?;
        let is_of = |map: &ShadowMap| cast.as_ref().is_some_and(|cast| map.is_of(cast));
        if self.shadow.as_ref().is_some_and(is_of) {
            return Ok(());
        }
        self.shadow = None;
        self.shadow = cast.map(|cast| ShadowMap::new(cast, &self.bodies, tools)).transpose()?;
        Ok(())
    }

    /// Number of the first body whose triangles are in the tree.
    pub(super) fn first_in_tree(&self) -> usize {
        if self.kind.exact { 0 } else { self.clear }
    }

    /// Whether the mesh has opaque bodies.
    pub(super) fn has_opaque(&self) -> bool {
        self.clear < self.bodies.len()
    }

    /// Whether the mesh has bodies with a diffuse surface.
    pub(in crate::method) fn has_diffuse(&self) -> bool {
        self.bodies.iter().any(|body| body.opaque && !body.mirror)
    }

    /// The number of nodes of the tree.
    pub(in crate::method) fn nodes(&self) -> u32 {
        self.nodes
    }

    fn fill(&mut self, settings: &Settings, tools: &mut Tools<'_>) -> Result<(), Error> {
        let reach = if self.kind.exact { uniforms::contact(self.bounds, self.grid) as f32 } else { 0.0 };
        let tree = tree::build(&self.bodies, self.first_in_tree(), self.grid, !self.kind.paper, reach)?;
        self.nodes = tree.count();
        for (label, floats) in [("nodes of the tree", &tree.nodes), ("corners of triangles", &tree.corners)] {
            self.tree.push(tools.backend.create(label, Contents::Bytes(cast_slice(floats)))?);
        }
        if self.kind.exact {
            self.kernel = &kernels::voxels_trace_triangles;
            Ok(())
        } else if self.kind.paper {
            self.paper(settings, tools)
        } else {
            self.solids(tools)
        }
    }

    fn upload(&mut self, label: &str, contents: &[u8], backend: &mut dyn Backend) -> Result<(), Error> {
        self.buffers.push(backend.create(label, Contents::Bytes(contents))?);
        Ok(())
    }

    fn solids(&mut self, tools: &mut Tools<'_>) -> Result<(), Error> {
        let bytes = self.grid.voxels() * 2 * self.clear as u64;
        // Kernels count bytes by a signed number.
        if bytes > i32::MAX as u64 - 8 {
            let (dimensions, materials) = (self.grid.dimensions, self.clear);
            return Err(Unrenderable::TooManyVoxels { dimensions, materials, bytes }.into());
        }
        let clear = &self.bodies[..self.clear];
        let Solids { fields: all, open_rows } = Solids::new(clear, self.grid, tools)?;
        self.open_rows = open_rows;
        let distances = bricks::distances(&all, self.grid.dimensions);
        let cropped = cropped::cropped(&all, self.grid.dimensions);
        drop(all);
        self.upload("distances of bricks", cast_slice(&distances), tools.backend)?;
        self.upload("fields of materials", cast_slice(&cropped), tools.backend)
    }

    fn paper(&mut self, settings: &Settings, tools: &mut Tools<'_>) -> Result<(), Error> {
        let whole = together(&self.bodies[..self.clear]);
        let settings = Settings { attributes: true, ..*settings };
        let Voxelization { surface, attributes, .. } = voxelize_in(self.grid, &whole, &settings, tools)?;
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
        self.upload("mask of the surface", cast_slice(mask.words()), tools.backend)?;
        self.upload("ranks of the mask", cast_slice(&mask.ranks().0), tools.backend)?;
        self.upload("surfaces of voxels", cast_slice(&surfaces), tools.backend)
    }
}

/// The mesh that is the subject, which `method` shows.
///
/// # Errors
/// [`Unrenderable::NeedsMesh`] where the subject is a volume.
pub(in crate::method) fn shown(assets: &Assets, method: MethodName) -> Result<&Mesh, Error> {
    assets.subject.mesh().ok_or_else(|| Unrenderable::NeedsMesh { method: method.as_str() }.into())
}

/// One mesh of several bodies, each with its number as its material.
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
