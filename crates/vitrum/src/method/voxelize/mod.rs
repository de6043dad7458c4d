//! Voxelization of triangle meshes: the voxels of the surface, the attributes that triangles bring to them, and the coverage of the
//! voxels of the solid (Chang et al. 2010, §2; solids are not in the paper).

pub(in crate::method) mod columns;
mod fixed_point;
mod grid;
pub(in crate::method) mod items;
mod settings;
mod solid;
mod surface;
pub(in crate::method) mod triangles;
mod work;

pub use grid::{Grid, MOST_PADDING, MOST_VOXELS};
pub use settings::{FillRule, Settings};
pub use solid::Solid;
pub use surface::{Attributes, Mask};

use crate::backend::Backend;
use crate::error::Error;
use crate::method::Tools;
use crate::unrenderable::Unrenderable;
use items::Plan;
use serde::Serialize;
use solid::Body;
use surface::Surface;
use vitrum_io::Mesh;
use web_time::Instant;
use work::Work;

/// Statistics of a voxelization.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Statistics {
    /// `cpu` or `gpu`.
    pub backend: String,
    /// The processor or graphics adapter.
    pub adapter: String,
    /// Triangles of the mesh.
    pub triangles: usize,
    /// Voxels along x, y, z.
    pub dimensions: [u32; 3],
    /// A voxel's edge, in the mesh's units.
    pub voxel_size: f64,
    /// Voxels that triangles meet; `None` if they are not marked.
    pub surface_voxels: Option<u64>,
    /// Volume inside, in the mesh's units cubed; `None` if it is not filled.
    pub volume: Option<f64>,
    /// See [`Solid::open_rows`].
    pub open_rows: Option<u64>,
    /// Pieces of work: small triangles, and slices of large ones.
    pub items: u64,
    /// Milliseconds from the mesh to the voxels; more than one if it was done several times.
    pub voxelize_ms: Vec<f64>,
}

/// A mesh as voxels.
#[derive(Debug, Clone)]
pub struct Voxelization {
    /// The grid of the voxels.
    pub grid: Grid,
    /// The mask of the surface: all voxels that triangles meet, their faces included. No such voxel is missing, and no voxel in the
    /// mask is farther from a triangle than 2⁻¹⁶ of the triangle's extent, two voxels and the requested overlap.
    pub surface: Option<Mask>,
    /// The attributes of the surface's voxels.
    pub attributes: Option<Attributes>,
    /// The coverage of the voxels by the solid.
    pub solid: Option<Solid>,
    /// Times and counts.
    pub statistics: Statistics,
}

/// Turns a mesh into voxels. The result does not depend on the backend, nor on the order of the triangles.
///
/// `tools.progress` is told from time to time how much of the work is done, and cancels it by returning `false`.
///
/// # Errors
/// Where the settings are out of their ranges, the mesh is a point, or the backend fails or lacks the memory.
pub fn voxelize(mesh: &Mesh, settings: &Settings, tools: &mut Tools<'_>) -> Result<Voxelization, Error> {
    tools.backend.threads().run(|| {
        let started = Instant::now();
        let grid = Grid::around(mesh, settings)?;
        let mut made = voxelize_in(grid, mesh, settings, tools)?;
        made.statistics.voxelize_ms = vec![started.elapsed().as_secs_f64() * 1e3];
        Ok(made)
    })
}

/// Turns a mesh into voxels of a given grid, as [`voxelize`]; the mesh must lie within the grid.
pub(crate) fn voxelize_in(
    grid: Grid,
    mesh: &Mesh,
    settings: &Settings,
    tools: &mut Tools<'_>,
) -> Result<Voxelization, Error> {
    let started = Instant::now();
    let Tools { backend, progress } = tools;
    let backend = &mut **backend;
    if !(0.0..=1.0).contains(&settings.overlap) {
        return Err(Unrenderable::Overlap { overlap: settings.overlap }.into());
    }
    let mut work = Work { done: 0, total: 0, items: 0, progress };
    let (mut surface, mut attributes, mut solid) = (None, None, None);
    if settings.surface || settings.attributes {
        let prepared = Surface::new(mesh, grid, settings.overlap);
        work.total += mesh.triangles.len() as u64 * (1 + u64::from(settings.attributes));
        let mask = prepared.mark(backend, &mut work)?;
        if settings.attributes {
            attributes = Some(prepared.attributes(&mask, backend, &mut work)?);
        }
        surface = Some(mask);
    }
    if let Some(rule) = settings.solid {
        solid = Some(fill(mesh, grid, rule, backend, &mut work)?);
    }
    let statistics = Statistics {
        backend: backend.name().to_owned(),
        adapter: backend.adapter(),
        triangles: mesh.triangles.len(),
        dimensions: grid.dimensions,
        voxel_size: grid.voxel_size,
        surface_voxels: surface.as_ref().map(Mask::count),
        volume: solid.as_ref().map(|solid| solid.volume() * (grid.voxel_size * grid.voxel_size * grid.voxel_size)),
        open_rows: solid.as_ref().map(|solid| solid.open_rows),
        items: work.items,
        voxelize_ms: vec![started.elapsed().as_secs_f64() * 1e3],
    };
    Ok(Voxelization { grid, surface, attributes, solid, statistics })
}

/// Bytes up to which an allocator keeps a freed piece for the next request; it returns larger pieces to the system.
const KEPT: usize = 1 << 25;

fn fill(
    mesh: &Mesh,
    grid: Grid,
    rule: FillRule,
    backend: &mut dyn Backend,
    work: &mut Work<'_>,
) -> Result<Solid, Error> {
    let body = Body::new(mesh, grid, rule)?;
    let mut coverage = Vec::<u8>::new();
    let voxels = usize::try_from(grid.voxels()).unwrap_or(usize::MAX);
    coverage.try_reserve_exact(voxels).map_err(|_| Unrenderable::NoMemory { dimensions: grid.dimensions })?;
    if voxels <= KEPT {
        coverage.resize(voxels, 0);
    } else {
        // Pages that the system clears when they are written, by all threads.
        drop(coverage);
        coverage = vec![0; voxels];
    }
    let mut solid = Solid { coverage, open_rows: 0 };
    let buffers = body.buffers(backend)?;
    for slab in body.slabs() {
        let slices = body.slices(slab);
        let plan = Plan::new(&slices);
        work.total += plan.total();
        body.fill(slab, &plan, &buffers, backend, work, &mut solid)?;
    }
    Ok(solid)
}
