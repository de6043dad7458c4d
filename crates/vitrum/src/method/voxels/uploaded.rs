//! A mesh on a backend, as rays run through it: voxels, or a tree of triangles, and the shadow map.

use super::bodies::{Body, Group, bodies, groups};
use super::received::{self, Received};
use super::shadow::{Cast, ShadowMap};
use super::solids::Solids;
use super::{bricks, cropped, refit, tree, uniforms};
use crate::assets::Assets;
use crate::backend::{Backend, Buffer, Contents, ReadBack as _};
use crate::error::Error;
use crate::method::Tools;
use crate::method::sweep::caustics::Caustics;
use crate::method::twist::twisted;
use crate::method::voxelize::{Grid, Settings, Voxelization, voxelize_in};
use crate::scene::{MethodName, Normals, Scene, Surfaces};
use crate::unrenderable::Unrenderable;
use bytemuck::cast_slice;
use std::borrow::Cow;
use std::sync::Arc;
use vitrum_io::Mesh;
use vitrum_kernels::abi::voxels::surface;
use vitrum_kernels::kernel::{Kernel, kernels};

/// Empty voxels around the mesh: the reach of the filter and of the gradient at a ray.
const PADDING: u32 = 5;

/// A refitted tree is built anew when a ray has so many times as many steps through it as when it was built.
const WORN: f64 = 1.5;

/// The key of an uploaded mesh: the representation, and its resolution.
#[derive(Debug, Clone, PartialEq)]
struct Kind {
    resolution: u32,
    exact: bool,
    paper: bool,
    /// Overlap of the paper's voxels; 0 for other representations.
    overlap: f32,
    /// The materials of each body.
    groups: Vec<Group>,
}

impl Kind {
    fn settings(&self) -> Settings {
        Settings { padding: PADDING, overlap: self.overlap, ..Settings::new(self.resolution) }
    }

    fn of(scene: &Scene, mesh: &Mesh) -> Self {
        let groups = groups(mesh, &scene.material);
        // Opaque bodies are triangles always.
        let exact = scene.voxels.surfaces == Surfaces::Exact || groups.iter().all(|group| group.opaque);
        let paper = scene.voxels.normals == Normals::Paper;
        let overlap = if paper { scene.voxels.overlap } else { 0.0 };
        Self { resolution: scene.voxelization.resolution, exact, paper, overlap, groups }
    }
}

/// The shape of an uploaded mesh.
#[derive(Debug, Clone)]
struct Shape {
    /// The mesh as it was loaded.
    mesh: Arc<Mesh>,
    twist: f32,
}

impl Shape {
    fn of(scene: &Scene, assets: &Assets) -> Result<Self, Error> {
        let twist = scene.mesh.first().map_or(0.0, |mesh| mesh.twist);
        Ok(Self { mesh: Arc::clone(shared(assets, MethodName::Voxels)?), twist })
    }

    /// Whether both are the same, by the identity of the mesh: while one is kept, no other takes its place.
    fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.mesh, &other.mesh) && self.twist == other.twist
    }

    /// The mesh, deformed.
    fn deformed(&self) -> Cow<'_, Mesh> {
        if self.twist == 0.0 { Cow::Borrowed(&self.mesh) } else { Cow::Owned(twisted(&self.mesh, self.twist)) }
    }
}

/// A mesh on a backend, which stays the same while camera and materials change.
pub struct UploadedMesh {
    kind: Kind,
    shape: Shape,
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
    /// [`refit::steps`] of the tree when it was built.
    steps: f64,
    pub(super) shadow: Option<ShadowMap>,
    /// The light on receivers, where bodies refract it.
    pub(super) received: Option<Received>,
}

impl UploadedMesh {
    /// Turns a mesh into the representation that the scene's rays run through, with its shadow map, and uploads it.
    ///
    /// # Errors
    /// If the subject is no mesh, there are too many voxels or materials for the rays or for the backend, or the backend fails.
    pub fn new(scene: &Scene, assets: &Assets, tools: &mut Tools<'_>) -> Result<Self, Error> {
        let mut uploaded = Self::unlit(scene, assets, tools)?;
        uploaded.light(scene, assets, None, tools)?;
        Ok(uploaded)
    }

    /// As [`Self::new`], without a shadow map.
    pub(super) fn unlit(scene: &Scene, assets: &Assets, tools: &mut Tools<'_>) -> Result<Self, Error> {
        let shape = Shape::of(scene, assets)?;
        let kind = Kind::of(scene, &shape.mesh);
        let mesh = shape.deformed();
        let settings = kind.settings();
        let grid = Grid::around(&mesh, &settings)?;
        let bodies = bodies(&mesh, &scene.material)?;
        let mut uploaded = Self {
            clear: bodies.iter().filter(|body| !body.opaque).count(),
            kind,
            grid,
            bounds: mesh.bounds(),
            shape: shape.clone(),
            bodies,
            open_rows: 0,
            kernel: &kernels::voxels_march,
            buffers: Vec::new(),
            tree: Vec::new(),
            nodes: 0,
            steps: 0.0,
            shadow: None,
            received: None,
        };
        uploaded.fill(&settings, tools)?;
        Ok(uploaded)
    }

    /// What rays of a scene run through: this where it is of the same shape, and where rays run through triangles of which nothing but the corners
    /// has changed, this with its tree refitted; else `None`, and it has to be made anew.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn followed(mut self, scene: &Scene, assets: &Assets, tools: &mut Tools<'_>) -> Result<Option<Self>, Error> {
        let shape = Shape::of(scene, assets)?;
        if self.kind != Kind::of(scene, &shape.mesh) {
            return Ok(None);
        }
        if self.shape.is(&shape) {
            return Ok(Some(self));
        }
        // Looks and materials are kept for the scene alone.
        if !self.kind.exact || self.shape.mesh.materials != shape.mesh.materials {
            return Ok(None);
        }
        let mesh = shape.deformed();
        let bodies = bodies(&mesh, &scene.material)?;
        if !same_triangles(&self.bodies, &bodies) {
            return Ok(None);
        }
        self.bounds = mesh.bounds();
        self.grid = Grid::around(&mesh, &self.kind.settings())?;
        drop(mesh);
        (self.shape, self.bodies, self.shadow, self.received) = (shape, bodies, None, None);
        self.refit(tools)?;
        Ok(Some(self))
    }

    /// Voxels along x, y and z; `None` where rays run through the triangles.
    #[must_use]
    pub fn voxels(&self) -> Option<[u32; 3]> {
        (!self.kind.exact).then_some(self.grid.dimensions)
    }

    /// Makes the shadow map of a scene's light, if the light or the materials have changed, and has the light on receivers that bodies refract, if they do.
    ///
    /// # Errors
    /// If the shadow map is too large for the backend, or the backend fails.
    pub(super) fn light(
        &mut self,
        scene: &Scene,
        assets: &Assets,
        refracted: Option<Arc<Caustics>>,
        tools: &mut Tools<'_>,
    ) -> Result<(), Error> {
        let cast = Cast::of(scene, assets, &self.bodies, refracted.as_deref().map_or(0, received::words))?;
        if self.shadow.as_ref().map(ShadowMap::cast) != cast.as_ref() {
            // The old map goes first: both together could be too much for a device.
            (self.received, self.shadow) = (None, None);
            self.shadow = cast.map(|cast| ShadowMap::new(cast, &self.bodies, tools)).transpose()?;
        }
        let kept =
            self.received.take().filter(|kept| refracted.as_ref().is_some_and(|new| Arc::ptr_eq(new, &kept.caustics)));
        self.received = match (kept, refracted) {
            (None, Some(new)) => Some(Received::new(new, self.shadow.as_ref(), tools.backend)?),
            (kept, _) => kept,
        };
        Ok(())
    }

    /// The buffer in which kernels look light up, if there is one.
    pub(super) fn light_buffer(&self) -> Option<&Buffer> {
        self.received.as_ref().map(Received::buffer).or(self.shadow.as_ref().map(|map| &map.buffer))
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

    /// The distance beside boxes at which rays look for triangles, in voxels.
    fn reach(&self) -> f32 {
        if self.kind.exact { uniforms::contact(self.bounds, self.grid) as f32 } else { 0.0 }
    }

    /// Refits the tree to the bodies, or builds it anew where that has worn it out.
    fn refit(&mut self, tools: &mut Tools<'_>) -> Result<(), Error> {
        let corners = tree::corners(&self.bodies, self.first_in_tree(), self.grid, !self.kind.paper);
        if corners.is_empty() {
            return Ok(());
        }
        // The host keeps no copy.
        let mut nodes: Vec<f32> = tools.backend.read_all(&self.tree[0])?;
        refit::refit(&mut nodes, &corners, tree::margin(self.reach()));
        if refit::steps(&nodes) > WORN * self.steps {
            self.tree.clear();
            return self.fill(&self.kind.settings(), tools);
        }
        for (buffer, floats) in self.tree.iter().zip([&nodes, &corners]) {
            let words = cast_slice(floats);
            tools.backend.write(buffer, words.len(), &mut |all: &mut [u32]| all.copy_from_slice(words))?;
        }
        Ok(())
    }

    fn fill(&mut self, settings: &Settings, tools: &mut Tools<'_>) -> Result<(), Error> {
        let tree = tree::build(&self.bodies, self.first_in_tree(), self.grid, !self.kind.paper, self.reach())?;
        self.nodes = tree.count();
        self.steps = refit::steps(&tree.nodes);
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
    shared(assets, method).map(|mesh| &**mesh)
}

/// As [`shown`], shared.
fn shared(assets: &Assets, method: MethodName) -> Result<&Arc<Mesh>, Error> {
    assets.subject.shared_mesh().ok_or_else(|| Unrenderable::NeedsMesh { method: method.as_str() }.into())
}

/// Whether bodies differ in nothing but the places and normals of their vertices.
fn same_triangles(before: &[Body], after: &[Body]) -> bool {
    let same = |(one, other): (&Body, &Body)| {
        (one.material, one.opaque, one.mirror) == (other.material, other.opaque, other.mirror)
            && one.mesh.triangles == other.mesh.triangles
            && one.mesh.colors == other.mesh.colors
    };
    before.len() == after.len() && before.iter().zip(after).all(same)
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
